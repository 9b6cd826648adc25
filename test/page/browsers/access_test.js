// Pages for everybody: rules of accessibility in light and dark, reduced motion, a phone's width, paper.
import assert from 'node:assert/strict';
import {describe, it} from 'node:test';
import {AXE_SOURCE, useBrowser} from './support/browser.js';
import {ALL, HOSTILE, LIVE, NARROW, SWEEP, WIDE, drawn, goesOn, openPage, openStill} from './support/pages.js';
import {picture} from './support/picture.js';

// What is observed makes the longest tables.
const SHOWN = [['demo', WIDE], ['demo', NARROW], [HOSTILE, WIDE], [SWEEP, WIDE], [SWEEP, NARROW],
  [LIVE, WIDE], [LIVE, NARROW]].filter(([name]) => ALL.includes(name));
const LEAST_PDF = 20000;  // bytes; an empty page has some thousand
const A_WHILE = 500;      // ms

async function violations(page)
{
  await page.evaluate(AXE_SOURCE);
  const results = await page.evaluate(() => window.axe.run(document, {resultTypes: ['violations']}));
  assert.ok(results.passes.length > 10, 'the rules were applied');
  return results.violations.filter(({impact}) => ['serious', 'critical'].includes(impact))
    .map(({id, nodes}) => `${id}: ${nodes.map(node => node.html).join(' | ')}`);
}

for (const dark of [false, true])
  describe(`the rules of accessibility in ${dark ? 'dark' : 'light'}`, () => {
    const browser = useBrowser({dark});
    for (const [name, viewport] of SHOWN)
      it(`hold: ${name}, ${viewport.width} px wide`, async () => {
        const {page} = await openPage(browser(), name, viewport);
        await page.evaluate(() => {
          window.ratchetSieve?.pause?.();
          document.querySelectorAll('details').forEach(part => (part.open = true));
        });
        await drawn(page);
        assert.deepEqual(await violations(page), []);
      });

    it('the page is as the user prefers', async () => {
      const {page} = await openStill(browser(), 'demo');
      const ground = await page.evaluate(() => getComputedStyle(document.documentElement).backgroundColor);
      assert.equal(Number(/\d+/.exec(ground)[0]) < 128, dark, ground);
    });
  });

describe('the rules', () => {
  const browser = useBrowser();
  it('find a button without a name', async () => {
    const {page} = await openStill(browser(), 'demo');
    await page.evaluate(() => document.body.append(document.createElement('button')));
    assert.match((await violations(page)).join('\n'), /button-name/);
  });
});

describe('with reduced motion', () => {
  const browser = useBrowser({calm: true});
  it('a page does not play by itself', async () => {
    const {page} = await openPage(browser(), 'demo');
    const time = await page.evaluate(() => window.ratchetSieve.time);
    await new Promise(done => setTimeout(done, A_WHILE));
    const later = await page.evaluate(() => [window.ratchetSieve.playing, window.ratchetSieve.time]);
    assert.deepEqual(later, [false, time]);
    await page.evaluate(() => window.ratchetSieve.play());
    await goesOn(page, time);
  });
});

describe('on a phone', () => {
  const browser = useBrowser();
  for (const name of ALL)
    it(`a page is no wider than the screen: ${name}`, async () => {
      const {page} = await openPage(browser(), name, NARROW);
      await page.evaluate(() => document.querySelectorAll('details').forEach(part => (part.open = true)));
      await drawn(page);
      const [content, window_width, canvas] = await page.evaluate(() => [document.documentElement.scrollWidth,
        window.innerWidth, document.querySelector('#machine')?.getBoundingClientRect().width]);
      assert.equal(window_width, NARROW.width);
      assert.ok(content <= NARROW.width, `the page is ${content} px wide`);
      assert.ok(name === SWEEP || canvas > NARROW.width / 2, `the machine is ${canvas} px wide`);
    });
});

describe('on paper', () => {
  const browser = useBrowser();
  for (const name of ['demo', SWEEP])
    it(`a page is not empty: ${name}`, async () => {
      const {page} = await openPage(browser(), name);
      await page.evaluate(() => window.ratchetSieve?.pause?.());
      const pdf = Buffer.from(await page.pdf({printBackground: false}));
      assert.equal(pdf.toString('latin1', 0, 5), '%PDF-');
      assert.ok(pdf.length > LEAST_PDF, `${pdf.length} bytes`);
    });

  it('the machine is in it', async () => {
    const {page} = await openStill(browser(), 'demo');
    await page.emulateMediaType('print');
    await drawn(page);
    const image = await picture(page, '#machine');
    const row = Array.from({length: image.width}, (_, x) => image.at(x, image.height >> 1).join());
    assert.ok(new Set(row).size > 3, 'the machine is blank');
  });
});
