// What a page must not do: complain, fail, or ask for anything.

const LOUD = new Set(['error', 'warn', 'warning', 'assert']);

function isWithin(url)
{
  return /^(data|blob|about):/.test(url);
}

/// Watches a page from before it is opened. `said`: errors, warnings, exceptions, dialogs and what its policy stopped;
/// `requested`: all addresses besides its own.
export async function watch(page, own_url)
{
  const seen = {said: [], requested: []};
  page.on('console', message => LOUD.has(message.type()) && seen.said.push(`${message.type()}: ${message.text()}`));
  page.on('pageerror', error => seen.said.push(`exception: ${error.message}`));
  page.on('dialog', async dialog => {
    seen.said.push(`dialog: ${dialog.message()}`);
    await dialog.dismiss();
  });
  page.on('request', request => {
    const url = request.url().split('#')[0];
    if (url !== own_url && !isWithin(url))
      seen.requested.push(url);
  });
  await page.evaluateOnNewDocument(() => {
    window.policyStopped = [];
    document.addEventListener('securitypolicyviolation', event => window.policyStopped.push(event.blockedURI));
  });
  seen.stopped = () => page.evaluate(() => window.policyStopped);
  return seen;
}
