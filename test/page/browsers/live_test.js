// The live page: keys, setpoints, pouring, links, and what the picture shows.
import assert from 'node:assert/strict';
import {describe, it} from 'node:test';
import {pathToFileURL} from 'node:url';
import {LIVE, drawn, goesOn, openPage, openStill, pathOf} from './support/pages.js';
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
const fragmentOf = settings => '#' + encodeURIComponent(JSON.stringify(settings));

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

  it('pours disks by P', async () => {
    const page = await openAt(browser(), 'demo', 0.1);
    const {length} = await disksOf(page);
    await page.keyboard.press('p');
    await until(page, count => window.ratchetSieve.disks().length === count, length + 10);
    assert.deepEqual(await sieve(page, 'schedule'), [[0.1, 'pour', 0, 10]]);
  });

  it('opens another scene', async () => {
    const {page} = await openStill(browser(), LIVE);
    assert.ok(await page.$eval('#feed', field => !field.hidden));
    await page.select('#scene-name', 'paper_fig8');
    await until(page, () => document.querySelector('#bins').hidden && window.ratchetSieve.disks().length > 100);
    assert.ok(await page.$eval('#feed', field => field.hidden));
  });

  it('zooms, and follows a disk that is clicked or named', async () => {
    const page = await openAt(browser(), 'demo', 0.2);
    const scale = () => page.evaluate(() => window.ratchetSieve.toPixel(1, 0).x - window.ratchetSieve.toPixel(0, 0).x);
    const whole = await scale();
    await page.keyboard.press('+');
    assert.ok(await scale() > whole * 1.05);
    await page.click('#whole');
    assert.equal(await scale(), whole);
    const [disk, other] = (await disksOf(page)).filter(({species}) => species === 1);
    const box = await (await page.$('#machine')).boundingBox();
    const at = await page.evaluate(({x, y}) => window.ratchetSieve.toPixel(x, y), disk);
    await page.mouse.click(box.x + at.x, box.y + at.y);
    assert.equal(await sieve(page, 'followed'), disk.id);
    await page.keyboard.press('Escape');
    assert.equal(await sieve(page, 'followed'), null);
    await page.type('#follow', String(other.id));
    await page.keyboard.press('Enter');
    assert.equal(await sieve(page, 'followed'), other.id);
  });
});

describe('a link', () => {
  const browser = useBrowser();
  const SCHEDULE = [[0.05, 'slew', 1, 10, 0.002], [0.1, 'command', 0, 0.1], [0.15, 'pour', 1, 5]];
  const LINKED = {scene: 'demo', seed: 3, feedRate: 0, schedule: SCHEDULE};

  it('opens the run with its commands', async () => {
    const given = await openAt(browser(), 'demo', 0);
    const run = time => given.evaluate(async (to, settings) => {
      await window.ratchetSieve.stateAt('demo', to, settings);
    }, time, LINKED);
    await run(0.2);
    const link = await given.evaluate(() => window.ratchetSieve.link());
    const opened = await openLink(browser(), new URL(link).hash);
    await until(opened, () => window.ratchetSieve.time > 0.15);
    await opened.evaluate(() => window.ratchetSieve.pause());
    await drawn(opened);
    assert.deepEqual(await sieve(opened, 'schedule'), SCHEDULE);
    const shown = await opened.$$eval('#setpoints input', fields => fields.slice(0, 2).map(field => field.value));
    assert.deepEqual(shown, ['0.1', '1']);
    await run(await sieve(opened, 'time'));
    assert.deepEqual(await disksOf(given), await disksOf(opened));
  });

  for (const [what, fragment] of [['that is none', '#nonsense'], ['to no scene of the page', fragmentOf({scene: 'x'})],
    ['with program text for a number', fragmentOf({...LINKED, schedule: [[0, 'pour', 'print(1)', 5]]})],
    ['with a command that the engine refuses', fragmentOf({...LINKED, schedule: [[0, 'pour', 9, 5]]})]])
    it(`${what} is called so, and the page goes on`, async () => {
      const page = await openLink(browser(), fragment);
      assert.match(await said(page), /^This link cannot be opened: ./);
      await page.evaluate(() => window.ratchetSieve.play());
      await goesOn(page, await sieve(page, 'time'));
      await page.evaluate(hash => (location.hash = hash), fragmentOf(LINKED));
      await until(page, () => window.ratchetSieve.schedule.length === 3);
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
