// A picture of the upper part of a page. Usage: screenshot.js [OPTION...] PAGE OUT.png
//   --dark          as for a user who prefers it
//   --time SECONDS  the time that the machine shows; without it, the middle of the run
//   --follow ID     the disk that is followed, zoomed onto
//   --width PX, --height PX  of the picture (default: 1200, 900)
import path from 'node:path';
import {parseArgs} from 'node:util';
import {chromium} from './support/browser.js';
import {WIDE, drawn, openFile} from './support/pages.js';

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

const {values: options, positionals: [file, out]} = parseArgs({
  options: {
    dark: {type: 'boolean', default: false},
    time: {type: 'string'},
    follow: {type: 'string'},
    width: {type: 'string', default: String(WIDE.width)},
    height: {type: 'string', default: String(WIDE.height)},
  },
  allowPositionals: true,
});
const browser = await chromium({dark: options.dark});
try {
  const viewport = {width: Number(options.width), height: Number(options.height)};
  const {page, seen} = await openFile(browser, path.resolve(file), viewport);
  await show(page, options);
  await page.screenshot({path: out});
  if (seen.said.length > 0)
    throw new Error(seen.said.join('\n'));
} finally {
  await browser.close();
}
