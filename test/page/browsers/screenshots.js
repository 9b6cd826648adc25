// Pictures of a page to look at. Usage: screenshots.js [OPTION...] PAGE OUT
//   --browser NAME  chromium (the default) or firefox
//   --time SECONDS  the time that the machine shows; without it, the middle of the run
//   --follow ID     the disk that is followed, zoomed onto
//   --height PX     of the picture, if OUT ends in .png (default: 900)
// Writes into the directory OUT wide_light.png, wide_dark.png, narrow_light.png and narrow_dark.png. If OUT ends in .png:
// the upper part of the page, wide and light, into this file.
import {mkdirSync} from 'node:fs';
import path from 'node:path';
import {parseArgs} from 'node:util';
import {launch} from './support/browser.js';
import {NARROW, WIDE, drawn, openFile} from './support/pages.js';

const ZOOM = 8;  // presses of + onto a followed disk

async function show(page, {time, follow})
{
  await page.evaluate(async at => {
    const sieve = window.ratchetSieve;
    await sieve?.ready;
    if (!sieve?.seek)  // the page of a sweep
      return;
    sieve.pause();
    sieve.seek(at ?? (sieve.start + sieve.end) / 2);
  }, time === undefined ? null : Number(time));
  if (follow !== undefined) {
    await page.evaluate(id => window.ratchetSieve.follow(id), Number(follow));
    for (let k = 0; k < ZOOM; ++k)
      await page.keyboard.press('+');
  }
  await drawn(page);
}

async function take(file, out, options, {dark, viewport, whole})
{
  const browser = await launch(options.browser, {dark});
  try {
    const {page, seen} = await openFile(browser, path.resolve(file), viewport);
    await show(page, options);
    await page.screenshot({path: out, fullPage: whole});
    if (seen.said.length > 0)
      throw new Error(seen.said.join('\n'));
  } finally {
    await browser.close();
  }
}

const {values: options, positionals: [file, out]} = parseArgs({
  options: {
    browser: {type: 'string', default: 'chromium'},
    time: {type: 'string'},
    follow: {type: 'string'},
    height: {type: 'string', default: String(WIDE.height)},
  },
  allowPositionals: true,
});

if (out.endsWith('.png')) {
  await take(file, out, options, {dark: false, viewport: {...WIDE, height: Number(options.height)}, whole: false});
} else {
  mkdirSync(out, {recursive: true});
  for (const [width, viewport] of [['wide', WIDE], ['narrow', NARROW]])
    for (const dark of [false, true])
      await take(file, path.join(out, `${width}_${dark ? 'dark' : 'light'}.png`), options, {dark, viewport, whole: true});
}
