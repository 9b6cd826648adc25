// The browsers of Debian's packages, without a window.
import {readFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import path from 'node:path';
import {after, afterEach, before} from 'node:test';

// The modules of package.json. They are installed into the build directory, where `import` does not look.
const installed = createRequire(path.resolve(process.env.PAGE_TEST_MODULES, 'package.json'));
const puppeteer = installed('puppeteer-core');
export const AXE_SOURCE = readFileSync(installed.resolve('axe-core/axe.min.js'), 'utf8');

export function firefox()
{
  return puppeteer.launch({browser: 'firefox', executablePath: process.env.FIREFOX ?? '/usr/bin/firefox-esr'});
}

/// Chromium, with newPage() and close(). Of the user's preferences: {dark, calm}, calm for reduced motion.
export async function chromium({dark = false, calm = false} = {})
{
  // The tests run as root in containers, where Chromium's sandbox cannot: the pages are the package's own.
  const browser = await puppeteer.launch({
    executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
    args: ['--no-sandbox', '--disable-gpu', '--force-color-profile=srgb', '--hide-scrollbars'],
  });
  return {
    async newPage()
    {
      const page = await browser.newPage();
      await page.emulateMediaFeatures([
        {name: 'prefers-color-scheme', value: dark ? 'dark' : 'light'},
        {name: 'prefers-reduced-motion', value: calm ? 'reduce' : 'no-preference'},
      ]);
      return page;
    },
    close: () => browser.close(),
  };
}

/// A browser for the tests of a `describe`: PAGE_TEST_BROWSER, or Chromium. Its pages close with the test that has
/// opened them. Call what this returns within the tests.
export function useBrowser(preferences)
{
  const pages = [];
  let browser;
  before(async () => {
    browser = await (process.env.PAGE_TEST_BROWSER === 'firefox' ? firefox() : chromium(preferences));
  });
  afterEach(() => Promise.all(pages.splice(0).map(page => page.close())));
  after(() => browser?.close());
  return () => ({
    async newPage()
    {
      pages.push(await browser.newPage());
      return pages.at(-1);
    },
  });
}
