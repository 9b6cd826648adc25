// The browsers of Debian's packages, without a window. Preferences of the user: {dark, calm}, calm for reduced motion.
import {puppeteer} from './modules.js';

export const BROWSERS = ['chromium', 'firefox'];

// The tests run as root in containers, where Chromium's sandbox cannot: the pages are the package's own.
function chromium()
{
  return puppeteer.launch({
    executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
    args: ['--no-sandbox', '--disable-gpu', '--force-color-profile=srgb', '--hide-scrollbars'],
  });
}

// Firefox takes what a user prefers when it starts alone.
function firefox({dark = false, calm = false})
{
  return puppeteer.launch({
    browser: 'firefox',
    executablePath: process.env.FIREFOX ?? '/usr/bin/firefox-esr',
    extraPrefsFirefox: {
      'layout.css.prefers-color-scheme.content-override': dark ? 0 : 1,
      'ui.prefersReducedMotion': calm ? 1 : 0,
    },
  });
}

async function prefer(page, {dark = false, calm = false})
{
  await page.emulateMediaFeatures([
    {name: 'prefers-color-scheme', value: dark ? 'dark' : 'light'},
    {name: 'prefers-reduced-motion', value: calm ? 'reduce' : 'no-preference'},
  ]);
}

/// A browser with newPage() and close().
export async function launch(name, preferences = {})
{
  const browser = name === 'chromium' ? await chromium() : await firefox(preferences);
  return {
    name,
    async newPage()
    {
      const page = await browser.newPage();
      if (name === 'chromium')
        await prefer(page, preferences);
      return page;
    },
    close: () => browser.close(),
  };
}
