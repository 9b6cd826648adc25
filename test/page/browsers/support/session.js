// The browser of a group of tests: PAGE_TEST_BROWSER, or Chromium.
import {after, before} from 'node:test';
import {BROWSERS, launch} from './browser.js';

export const BROWSER = process.env.PAGE_TEST_BROWSER ?? BROWSERS[0];

/// A browser for the tests of a `describe`; call what this returns within them.
export function useBrowser(preferences)
{
  let browser;
  before(async () => {
    browser = await launch(BROWSER, preferences);
  });
  after(() => browser?.close());
  return () => browser;
}
