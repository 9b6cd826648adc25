// The live page: keys, setpoints, pouring, links, and what the picture shows.
import assert from 'node:assert/strict';
import {describe, it} from 'node:test';
import {pathToFileURL} from 'node:url';
import {deflateSync} from 'node:zlib';
import {LIVE, NARROW, drawn, goesOn, openPage, openStill, pathOf} from './support/pages.js';
import {useBrowser} from './support/browser.js';

const URL_OF_PAGE = pathToFileURL(pathOf(LIVE)).href;
const TRIES = 200;
const PAUSE = 50;  // between two tries [ms]

/// Waits until a function that runs in the page gives what is truthy.
async function until(page, holds, ...values)
{
  for (let k = 0; k < TRIES; ++k) {
    if (await page.evaluate(holds, ...values))
      return;
    await new Promise(done => setTimeout(done, PAUSE));
  }
  throw new Error(`it did not come to ${holds} with ${values}`);
}

/// The page with a scene that stands still at a time.
async function openAt(browser, scene, time)
{
  const {page} = await openStill(browser, LIVE);
  await page.evaluate((name, to) => window.ratchetSieve.stateAt(name, to).then(() => {}), scene, time);
  return page;
}

async function openLink(browser, fragment)
{
  const page = await browser.newPage();
  await page.goto(URL_OF_PAGE + fragment);
  await page.evaluate(() => window.ratchetSieve.ready);
  return page;
}

const sieve = (page, name) => page.evaluate(key => window.ratchetSieve[key], name);
const disksOf = page => page.evaluate(() => window.ratchetSieve.disks());
const said = page => page.$eval('#said', part => part.textContent);
const fragmentOf = settings => '#run=' + deflateSync(JSON.stringify(settings)).toString('base64url');

/// Sets a slider as a hand does.
const slide = (page, id, value) => page.$eval(id, (slider, to) => {
  slider.value = to;
  slider.dispatchEvent(new Event('input', {bubbles: true}));
  slider.dispatchEvent(new Event('change', {bubbles: true}));
}, value);

describe('the live page', () => {
  const browser = useBrowser();

  it('plays and pauses by Space, and goes one step by the right arrow', async () => {
    const {page} = await openStill(browser(), LIVE);
    await page.keyboard.press(' ');
    assert.ok(await sieve(page, 'playing'));
    await goesOn(page, await sieve(page, 'time'));
    await page.keyboard.press('ArrowRight');
    assert.ok(!await sieve(page, 'playing'));
    await drawn(page);
    const time = await sieve(page, 'time');
    await page.keyboard.press('ArrowRight');
    await goesOn(page, time);
  });

  it('plays as fast as it goes', async () => {
    const {page} = await openPage(browser(), LIVE);
    await until(page, () => window.ratchetSieve.time > 0.5);
    await page.select('#speed', 'most');
    await goesOn(page, await sieve(page, 'time'));
  });

  it('gives a command when a slider moves by a key', async () => {
    const page = await openAt(browser(), 'demo', 0.1);
    await page.focus('#set-inclination');
    for (let k = 0; k < 3; ++k)
      await page.keyboard.press('ArrowRight');
    await until(page, () => window.ratchetSieve.schedule.length === 3);
    const value = await page.$eval('#set-inclination', slider => Number(slider.value));
    assert.ok(value > 0);
    assert.deepEqual((await sieve(page, 'schedule')).at(-1), [0.1, 'command', 0, value]);
    assert.equal((await sieve(page, 'readings')).base.commanded_inclination, value);
    await page.keyboard.press(' ');
    await until(page, to => window.ratchetSieve.readings.base.inclination === to, value);
  });

  it('pours anew by R, and by N with the next seed', async () => {
    const page = await openAt(browser(), 'demo', 0);
    const first = await disksOf(page);
    await page.evaluate(() => window.ratchetSieve.stateAt('demo', 0.1).then(() => {}));
    await page.keyboard.press('r');
    await until(page, () => window.ratchetSieve.time === 0);
    assert.deepEqual(await disksOf(page), first);
    await page.keyboard.press('n');
    await until(page, x => window.ratchetSieve.disks()[0].x !== x, first[0].x);
    assert.equal(await page.$eval('#seed', field => field.value), '2');
  });

  it('keeps the setpoints with the next seed, until the scene\u2019s are asked for', async () => {
    const page = await openAt(browser(), 'demo', 0.1);
    await slide(page, '#set-inclination', 0.2);
    await until(page, () => window.ratchetSieve.schedule.length === 1);
    await page.keyboard.press('n');
    await until(page, () => window.ratchetSieve.time === 0);
    assert.deepEqual(await sieve(page, 'schedule'), [[0, 'command', 0, 0.2]]);
    assert.equal((await sieve(page, 'readings')).base.commanded_inclination, 0.2);
    await page.click('#own');
    await until(page, () => window.ratchetSieve.schedule.length === 0);
    assert.equal((await sieve(page, 'readings')).base.commanded_inclination, 0);
  });

  it('pours disks by P, and drops a handful where one clicks', async () => {
    const page = await openAt(browser(), 'demo', 0.1);
    const {length} = await disksOf(page);
    await page.keyboard.press('p');
    await until(page, count => window.ratchetSieve.disks().length === count, length + 10);
    const before = new Set((await disksOf(page)).map(({id}) => id));
    const box = await (await page.$('#machine')).boundingBox();
    const at = await page.evaluate(() => window.ratchetSieve.toPixel(0.3, 0.2));
    await page.mouse.click(box.x + at.x, box.y + at.y);
    await until(page, count => window.ratchetSieve.disks().length === count, before.size + 10);
    const [first, [, name, species, count, from, to]] = await sieve(page, 'schedule');
    assert.deepEqual([first, name, species, count], [[0.1, 'pour', 0, 10], 'pour', 0, 10]);
    assert.ok(from < 0.3 && 0.3 < to && to - from < 0.06, `${from} to ${to}`);
    for (const {id, x} of await disksOf(page))
      assert.ok(before.has(id) || from <= x && x <= to, `${x}`);
  });

  it('runs two side by side, in step, with one setting different', async () => {
    const page = await openAt(browser(), 'demo', 0);
    await page.select('#beside', 'inclination');
    await until(page, () => window.ratchetSieve.beside);
    await slide(page, '#set-frequency', 30);
    await page.keyboard.press(' ');
    await until(page, () => window.ratchetSieve.time > 0.3);
    await page.keyboard.press(' ');
    await until(page, () => window.ratchetSieve.beside.time === window.ratchetSieve.time);
    const [one, other] = [await sieve(page, 'readings'), await sieve(page, 'beside')].map(({base}) => base);
    assert.equal(one.commanded_inclination, 0);
    assert.ok(other.commanded_inclination > 0.05);
    assert.deepEqual([one.commanded_frequency, one.frequency], [other.commanded_frequency, other.frequency]);
  });

  it('says of the bins and of the separation what the engine does', async () => {
    const page = await openAt(browser(), 'machine_fig9', 12);
    const {species: [a, b], separation} = await sieve(page, 'readings');
    const {result, left, right} = await sieve(page, 'said');
    const sides = separation > 0 ? 'A left, B right' : 'A right, B left';
    assert.ok(result.includes(`${(100 * Math.abs(separation)).toFixed(0)}\u00a0% sorted: ${sides}`), result);
    for (const [bin, text] of [['left', left], ['right', right]]) {
      const [most, name] = a[bin] >= b[bin] ? [a[bin], 'A'] : [b[bin], 'B'];
      assert.equal(text, `${a[bin] + b[bin]} disks ${(100 * most / (a[bin] + b[bin])).toFixed(0)}\u00a0% ${name}`);
    }
  });

  it('says which way is better, and with which error', async () => {
    const page = await openAt(browser(), 'demo', 0);
    const adviceOn = (...better) => page.evaluate(separations => Advice.text([[-0.7, -0.72, -0.68, -0.7], separations,
      [-0.7, -0.69, -0.71, -0.7]].map((each, k) => ({text: `setting ${k}`, separations: each}))), better);
    assert.match(await adviceOn(-0.8, -0.82, -0.78, -0.8), /^setting 1: 0\.70 \u2192 0\.80, \+0\.10 \u00b1 0\.04 /);
    assert.match(await adviceOn(-0.9, -0.72, -0.5, -0.8), /^None is surely better/);
    assert.match(await adviceOn(-0.9, null, -0.5, -0.8), /nothing can be said/);
  });

  it('opens another scene', async () => {
    const {page} = await openStill(browser(), LIVE);
    assert.ok(await page.$eval('#feed', field => !field.hidden));
    await page.select('#scene-name', 'paper_fig8');
    await until(page, () => document.querySelector('#bins').hidden && window.ratchetSieve.disks().length > 100);
    assert.ok(await page.$eval('#feed', field => field.hidden));
  });

  it('follows a disk that is named', async () => {
    const page = await openAt(browser(), 'demo', 0.2);
    const {id} = (await disksOf(page)).at(-1);
    await page.$$eval('#panel details', parts => parts.forEach(part => (part.open = true)));
    await page.type('#follow', String(id));
    await page.keyboard.press('Enter');
    assert.equal(await sieve(page, 'followed'), id);
  });

  it('shows the middle of the machine where its disks would be points, and the whole when asked', async () => {
    const {page} = await openStill(browser(), LIVE, NARROW);
    const width = () => page.evaluate(() => window.ratchetSieve.toPixel(0.76, 0).x - window.ratchetSieve.toPixel(0, 0).x);
    assert.ok(await width() > NARROW.width);
    await page.click('#whole');
    assert.ok(await width() < NARROW.width);
  });
});

describe('a link', () => {
  const browser = useBrowser();
  const SCHEDULE = [[0.05, 'slew', 1, 10, 0.002], [0.1, 'command', 0, 0.1], [0.15, 'pour', 1, 5], [0.15, 'pour', 0, 2, 0.01, 0.02]];
  const ROWS = [[50, 's', 1, 10, 0.002], [50, 'c', 0, 0.1], [50, 'p', 1, 5], [0, 'p', 0, 2, 0.01, 0.02]];
  const LINKED = ['demo', 3, 0, ROWS];

  it('opens the run with its commands', async () => {
    const given = await openAt(browser(), 'demo', 0);
    const run = time => given.evaluate(async (to, settings) => {
      await window.ratchetSieve.stateAt('demo', to, settings);
    }, time, {seed: 3, schedule: SCHEDULE});
    await run(0.2);
    const link = await given.evaluate(() => window.ratchetSieve.link());
    const opened = await openLink(browser(), new URL(link).hash);
    await until(opened, () => window.ratchetSieve.time > 0.15);
    await opened.evaluate(() => window.ratchetSieve.pause());
    await drawn(opened);
    assert.deepEqual(await sieve(opened, 'schedule'), SCHEDULE);
    const shown = await opened.$$eval('#set-inclination, #slews input', fields => fields.slice(0, 2).map(field => field.value));
    assert.deepEqual(shown, ['0.1', '1']);
    await run(await sieve(opened, 'time'));
    assert.deepEqual(await disksOf(given), await disksOf(opened));
  });

  it('of a minute of dragging has less than 2000 characters', async () => {
    const page = await openAt(browser(), 'demo', 0);
    const drag = Array.from({length: 300}, (_, k) => [Math.round(200.3 * k + 3 * Math.sin(k * k)) / 1000 || 0, 'command', 0,
      Number((0.3 * Math.sin(k / 9 + Math.sin(k * k) / 5)).toFixed(4))]);
    await page.evaluate(schedule => window.ratchetSieve.stateAt('demo', 60, {schedule}).then(() => {}), drag);
    assert.equal((await sieve(page, 'schedule')).length, 300);
    const link = await page.evaluate(() => window.ratchetSieve.link());
    assert.ok(link.length < 2000, `${link.length} characters`);
  });

  it('that is not of this page is ignored', async () => {
    const page = await openLink(browser(), '#nonsense');
    assert.equal(await said(page), '');
    await goesOn(page, 0);
  });

  for (const [what, fragment] of [['that is cut off', fragmentOf(LINKED).slice(0, 30)], ['to no scene of the page', fragmentOf(['x', 1, 0, []])],
    ['with program text for a number', fragmentOf(['demo', 3, 0, [[0, 'p', 'print(1)', 5]]])],
    ['with a command that the engine refuses', fragmentOf(['demo', 3, 0, [[0, 'p', 9, 5]]])]])
    it(`${what} is called so, and the page goes on`, async () => {
      const page = await openLink(browser(), fragment);
      assert.match(await said(page), /^This link cannot be opened: ./);
      await page.evaluate(() => window.ratchetSieve.play());
      await goesOn(page, await sieve(page, 'time'));
      await page.evaluate(hash => (location.hash = hash), fragmentOf(LINKED));
      await until(page, () => window.ratchetSieve.schedule.length === 4);
      assert.equal(await page.$eval('#seed', field => field.value), '3');
      assert.equal(await said(page), '');
    });
});

describe('with reduced motion', {skip: process.env.PAGE_TEST_BROWSER === 'firefox'}, () => {
  const browser = useBrowser({calm: true});
  it('the machine stands still until it is played', async () => {
    const {page} = await openPage(browser(), LIVE);
    await drawn(page);
    assert.deepEqual([await sieve(page, 'playing'), await sieve(page, 'time')], [false, 0]);
    await page.click('#play');
    await goesOn(page, 0);
  });
});
