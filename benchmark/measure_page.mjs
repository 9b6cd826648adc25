// Plays a page for some seconds and prints what it took, as JSON. Usage: measure_page.mjs BROWSER PAGE SECONDS
import path from 'node:path';
import {launch} from '../test/page/browsers/support/browser.js';
import {openFile} from '../test/page/browsers/support/pages.js';

const SOUGHT = 40;  // times at which a single picture is drawn

/// In the page: pictures per second as it plays, and milliseconds of the pictures, in order of size.
async function measure(seconds, sought)
{
  const sieve = window.ratchetSieve;
  await sieve.ready;
  document.getElementById("whole").click();  // all disks are drawn
  sieve.pause();
  const alone = [];
  for (let k = 0; k < sought; ++k) {
    sieve.seek(sieve.start + (k + 0.5) / sought * (sieve.end - sieve.start));
    alone.push(sieve.drawMilliseconds);
  }
  sieve.seek(sieve.start);
  sieve.play();
  const begin = performance.now();
  let pictures = 0;
  let before = sieve.time;
  const disks = sieve.disks().length;
  while (performance.now() - begin < 1000 * seconds && sieve.playing) {
    await new Promise(requestAnimationFrame);
    if (sieve.time !== before)
      ++pictures;
    before = sieve.time;
  }
  const took = (performance.now() - begin) / 1000;
  return {disks, rate: pictures / took, milliseconds: alone.sort((a, b) => a - b)[sought / 2]};
}

const [name, file, seconds] = process.argv.slice(2);
const browser = await launch(name);
try {
  const {page, seen} = await openFile(browser, path.resolve(file));
  const measured = await page.evaluate(measure, Number(seconds), SOUGHT);
  if (seen.said.length > 0)
    throw new Error(seen.said.join('\n'));
  console.log(JSON.stringify(measured));
} finally {
  await browser.close();
}
