// The pages that make_pages.py has made, and what their bags hold.
import {existsSync, readFileSync} from 'node:fs';
import path from 'node:path';
import {pathToFileURL} from 'node:url';

const DIRECTORY = path.resolve(process.env.PAGE_TEST_PAGES ?? '.');

/// Pages of runs with their facts; texts that are programs; a sweep; the live page, where it was made.
export const RUNS = ['demo', 'sizes'];
export const HOSTILE = 'hostile';
export const SWEEP = 'sweep/report';
export const LIVE = 'live';
export const ALL = [...RUNS, HOSTILE, SWEEP, ...existsSync(pathOf(LIVE)) ? [LIVE] : []];

const PATIENCE = 10000;  // ms

export const WIDE = {width: 1200, height: 900};
export const NARROW = {width: 360, height: 740};

export function pathOf(name)
{
  return path.join(DIRECTORY, `${name}.html`);
}

export function factsOf(name)
{
  return JSON.parse(readFileSync(path.join(DIRECTORY, `${name}.json`), 'utf8'));
}

// What a page must not do: complain, fail, or ask for anything.
const LOUD = new Set(['error', 'warn', 'warning', 'assert']);

function isWithin(url)
{
  return /^(data|blob|about):/.test(url);
}

/// Watches a page from before it is opened. `said`: errors, warnings, exceptions, dialogs and what its policy stopped;
/// `requested`: all addresses besides its own.
async function watch(page, own_url)
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

/// Opens a file in a page of its own, watched.
export async function openFile(browser, file, viewport = WIDE)
{
  const page = await browser.newPage();
  const url = pathToFileURL(file).href;
  const seen = await watch(page, url);
  await page.setViewport(viewport);
  await page.goto(url);
  return {page, seen};
}

export async function openPage(browser, name, viewport = WIDE)
{
  const opened = await openFile(browser, pathOf(name), viewport);
  await opened.page.evaluate(() => window.ratchetSieve?.ready);
  return opened;
}

/// Opens it with the machine standing still.
export async function openStill(browser, name, viewport = WIDE)
{
  const opened = await openPage(browser, name, viewport);
  await opened.page.evaluate(() => window.ratchetSieve.pause());
  return opened;
}

/// Lets the browser draw what has changed.
export function drawn(page)
{
  return page.evaluate(() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(() => done()))));
}

export async function seek(page, time)
{
  await page.evaluate(to => window.ratchetSieve.seek(to), time);
  await drawn(page);
}

/// Waits until the machine has gone on from a time. (waitForFunction evaluates text, which the page's policy forbids.)
export async function goesOn(page, time)
{
  const went = await page.evaluate(async (before, patience) => {
    const begin = performance.now();
    while (window.ratchetSieve.time === before && performance.now() - begin < patience)
      await new Promise(requestAnimationFrame);
    return window.ratchetSieve.time > before;
  }, time, PATIENCE);
  if (!went)
    throw new Error(`the machine stands still at ${time} s`);
}
