// The page of a sweep's report: its values, its map under pointer and keys, command lines, and the way to a run.
import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import path from 'node:path';
import {describe, it} from 'node:test';
import {SWEEP, openPage, pathOf} from './support/pages.js';
import {useBrowser} from './support/browser.js';

const LOWEST = [68, 1, 84];      // of viridis
const HIGHEST = [253, 231, 37];

/// Rows of a table without quotes, as maps from column to text.
function rowsOf(file)
{
  const [head, ...rows] = readFileSync(file, 'utf8').trim().split('\r\n').map(line => line.split(','));
  return rows.map(row => Object.fromEntries(head.map((name, k) => [name.split(' [')[0], row[k]])));
}

function chosen(page)
{
  return page.evaluate(() => [window.ratchetSieve.chosen.x, window.ratchetSieve.chosen.y]);
}

/// The cell of a setting.
async function cell(page, x, y)
{
  const k = await page.evaluate((i, j) => window.ratchetSieve.report.places.findIndex(place => place.x === i && place.y === j), x, y);
  return (await page.$$('#map .cell'))[k];
}

describe('the page of a sweep', () => {
  const browser = useBrowser();

  it('shows the means of means.csv', async () => {
    const {page} = await openPage(browser(), SWEEP);
    assert.equal(await page.$eval('#title', part => part.textContent), '<img src=x onerror=alert(1)>');
    const fields = await page.evaluate(() => window.ratchetSieve.report.fields.map(({name}) => name));
    const places = await page.evaluate(() => window.ratchetSieve.report.places.map(({x, y}) => [x, y]));
    const rows = rowsOf(path.join(path.dirname(pathOf(SWEEP)), 'means.csv'));
    assert.equal(places.length, rows.length);
    let numbers = 0;
    for (const [k, [x, y]] of places.entries()) {
      const texts = await page.evaluate((i, j) => {
        window.ratchetSieve.choose(i, j);
        return [...document.querySelectorAll('#chosen-means tbody tr')].map(row => row.cells[1].textContent);
      }, x, y);
      fields.forEach((name, field) => {
        const found = texts[field].replaceAll('\u2212', '-').match(/^(-?[\d.]+) \u00b1 ([\d.]+)/);
        assert.equal(found === null, rows[k][name] === '', `${name}: ${texts[field]}, ${rows[k][name]}`);
        if (!found)
          return;
        for (const [shown, exact] of [[found[1], rows[k][name]], [found[2], rows[k][`${name}_stderr`]]]) {
          const decimals = (shown.split('.')[1] ?? '').length;
          assert.ok(Math.abs(shown - exact) <= 0.5001 * 10 ** -decimals, `${name}: ${shown}, ${exact}`);
          ++numbers;
        }
      });
    }
    assert.ok(numbers > 20, `${numbers} numbers`);
  });

  it('answers the pointer and the keys', async () => {
    const {page, seen} = await openPage(browser(), SWEEP);
    await (await cell(page, 1, 1)).hover();
    const tip = await page.evaluate(() => [document.querySelector('#tip').hidden, document.querySelector('#tip').textContent]);
    const {x, y} = await page.evaluate(() => window.ratchetSieve.report);
    assert.equal(tip[0], false);
    assert.ok(tip[1].startsWith(`${x.label} = ${x.values[1]}`) && tip[1].includes(`${y.label} = ${y.values[1]}`), tip[1]);
    await (await cell(page, 1, 1)).click();
    assert.deepEqual(await chosen(page), [1, 1]);
    await page.focus('#map');
    for (const [key, place] of [['ArrowLeft', [0, 1]], ['ArrowLeft', [0, 1]], ['ArrowDown', [0, 0]], ['End', [2, 0]],
      ['ArrowUp', [2, 1]], ['Home', [0, 1]]]) {
      await page.keyboard.press(key);
      assert.deepEqual(await chosen(page), place, key);
    }
    assert.match(await page.$eval('#chosen', part => part.textContent), new RegExp(`${x.label} = ${x.values[0]}\\s`));
    await page.select('#field', '1');
    assert.equal(await page.evaluate(() => window.ratchetSieve.field), 'separation');
    assert.deepEqual(seen.said, []);
  });

  it('has the colours of its scale', async () => {
    const {page} = await openPage(browser(), SWEEP);
    const ends = await page.evaluate(() => {
      const {report} = window.ratchetSieve;
      window.ratchetSieve.showField('processed');
      const k = report.fields.findIndex(({name}) => name === 'processed');
      return [...report.places].sort((a, b) => a.means[k].value - b.means[k].value).map(({x, y}) => [x, y]);
    });
    for (const [place, colour] of [[ends[0], LOWEST], [ends.at(-1), HIGHEST]]) {
      const found = await (await cell(page, ...place)).evaluate(part => getComputedStyle(part).backgroundColor);
      assert.equal(found, `rgb(${colour.join(', ')})`);
    }
  });

  it('leads from a setting to the command line and the page of each run', async () => {
    const {page} = await openPage(browser(), SWEEP);
    await page.evaluate(() => window.ratchetSieve.choose(2, 0));
    const lines = await page.$$eval('#cases code', parts => parts.map(part => part.textContent));
    assert.equal(lines.length, 2);
    lines.forEach((line, k) => assert.match(line, new RegExp(`^sieve_run .*observed\\.yaml --set duration=1 .* --seed ${k + 1}$`)));
    const [link] = await page.$$('#cases a');
    await Promise.all([page.waitForNavigation(), link.click()]);
    await page.evaluate(() => window.ratchetSieve.ready);
    assert.match(await page.title(), /seed=1/);
    assert.ok(await page.evaluate(() => window.ratchetSieve.frames.length > 100));
  });

  it('sorts its table', async () => {
    const {page} = await openPage(browser(), SWEEP);
    const column = () => page.$$eval('#means tbody tr', rows => rows.map(row => Number(row.cells[2].textContent)));
    const first = () => page.$$eval('#means tbody tr', rows => rows.map(row => Number(row.cells[0].textContent.replace('\u2212', '-'))));
    assert.deepEqual(await column(), Array(6).fill(2));
    await (await page.$('#means thead button')).click();
    const ascending = await first();
    assert.deepEqual(ascending, [...ascending].sort((a, b) => a - b));
    await (await page.$('#means thead button')).click();
    assert.deepEqual(await first(), [...ascending].sort((a, b) => b - a));
    assert.equal(await page.$eval('#means thead th', head => head.getAttribute('aria-sort')), 'descending');
  });
});
