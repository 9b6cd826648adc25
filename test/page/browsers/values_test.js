// Q and P of a page at a time are those of the bag; so are its scene and where it comes from.
import assert from 'node:assert/strict';
import {describe, it} from 'node:test';
import {HOSTILE, RUNS, factsOf, openStill, seek} from './support/pages.js';
import {useBrowser} from './support/browser.js';

const UNDEFINED = '\u2014';

function textOf(page, id)
{
  return page.$eval(`#${id}`, element => element.textContent.trim());
}

/// A number is shown rounded: it may differ by half of its last digit.
function assertShown(text, value, what)
{
  if (value === null)
    return assert.equal(text, UNDEFINED, what);
  const number = /-?\d+(?:\.(\d+))?/.exec(text);
  assert.ok(number, `${what}: ${text}`);
  const digits = number[1]?.length ?? 0;
  assert.ok(digits >= 2, `${what} has too few digits: ${text}`);
  assert.ok(Math.abs(Number(number[0]) - value) <= 0.5000001 * 10 ** -digits, `${what}: ${text} for ${value}`);
}

function spread(bins)
{
  const defined = bins.findIndex(frame => frame.quality !== null);
  const picked = [0, ...[0.1, 0.25, 0.5, 0.75, 1].map(share => Math.floor(share * (bins.length - 1)))];
  return [...picked, ...defined < 0 ? [] : [defined]].map(k => bins[k]);
}

describe('Q and P', () => {
  const browser = useBrowser();
  for (const name of RUNS)
    it(`are the bag's at scrubbed times: ${name}`, async () => {
      const facts = factsOf(name);
      const {page} = await openStill(browser(), name);
      const frames = new Set(await page.evaluate(() => window.ratchetSieve.frames.map(time => time.toFixed(9))));
      const bins = facts.bins.filter(frame => frames.has(frame.time.toFixed(9)));
      assert.ok(bins.length >= 3);
      for (const frame of spread(bins)) {
        await seek(page, frame.time);
        assertShown(await textOf(page, 'quality'), frame.quality, `Q at ${frame.time} s`);
        assertShown(await textOf(page, 'processed'), frame.processed, `P at ${frame.time} s`);
      }
    });
});

describe('where a page comes from', () => {
  const browser = useBrowser();
  for (const name of [...RUNS, HOSTILE])
    it(`is in it: ${name}`, async () => {
      const facts = factsOf(name);
      const {page} = await openStill(browser(), name);
      assert.equal(await textOf(page, 'scene'), facts.yaml.trim());
      const provenance = await textOf(page, 'provenance');
      for (const part of [facts.scene_hash, String(facts.seed), facts.version])
        assert.ok(provenance.includes(part), `${part} is not in: ${provenance}`);
      for (const species of facts.scene.species)
        assert.ok((await textOf(page, 'results')).includes(species.name), species.name);
    });

  it('can be copied', {timeout: 20000}, async () => {
    const {page} = await openStill(browser(), 'demo');
    const copied = await page.evaluate(() => new Promise(done => {
      Object.defineProperty(navigator, 'clipboard', {value: {writeText: async text => done(text)}});
      document.querySelector('#scene').closest('details').open = true;
      document.querySelector('#copy-scene').click();
    }));
    assert.equal(copied, factsOf('demo').yaml);
  });
});
