// Each key, the buttons and clicks.
import assert from 'node:assert/strict';
import {describe, it} from 'node:test';
import {drawn, factsOf, goesOn, openStill, seek} from './support/pages.js';
import {useBrowser} from './support/browser.js';

function state(page)
{
  return page.evaluate(() => {
    const {time, playing, followed} = window.ratchetSieve;
    return {
      time, playing, followed,
      pressed: document.querySelector('#play').getAttribute('aria-pressed'),
      slider: Number(document.querySelector('#time').value),
      speed: document.querySelector('#speed').selectedIndex,
    };
  });
}

async function press(page, key)
{
  await page.keyboard.press(key);
  await drawn(page);
  return state(page);
}

/// Pixels to a metre.
function scale(page)
{
  return page.evaluate(() => window.ratchetSieve.toPixel(1, 0).x - window.ratchetSieve.toPixel(0, 0).x);
}

describe('keys', () => {
  const browser = useBrowser();

  it('Space plays and pauses', async () => {
    const {page} = await openStill(browser(), 'demo');
    await seek(page, 1.0);
    const playing = await press(page, ' ');
    assert.deepEqual([playing.playing, playing.pressed], [true, 'true']);
    await goesOn(page, playing.time);
    const paused = await press(page, ' ');
    assert.deepEqual([paused.playing, paused.pressed], [false, 'false']);
    await drawn(page);
    assert.equal((await state(page)).time, paused.time);
  });

  it('the arrows go from one recorded time to the next, Home and End to the start and the end', async () => {
    const {page} = await openStill(browser(), 'demo');
    const frames = await page.evaluate(() => [...window.ratchetSieve.frames]);
    const {times} = factsOf('demo');
    await seek(page, frames[10]);
    for (const [key, time] of [['ArrowRight', frames[11]], ['ArrowRight', frames[12]], ['ArrowLeft', frames[11]],
      ['ArrowLeft', frames[10]], ['ArrowLeft', frames[9]], ['End', times.at(-1)], ['ArrowRight', times.at(-1)],
      ['Home', times[0]], ['ArrowLeft', times[0]]])
      assert.equal((await press(page, key)).time, time, key);
  });

  it('+ and - zoom, 0 shows the whole machine', async () => {
    const {page} = await openStill(browser(), 'demo');
    const whole = await scale(page);
    await press(page, '+');
    const nearer = await scale(page);
    assert.ok(nearer > whole * 1.05);
    await press(page, '+');
    assert.ok(await scale(page) > nearer * 1.05);
    await press(page, '-');
    assert.ok(Math.abs(await scale(page) / nearer - 1) < 1e-6);
    await press(page, '0');
    assert.ok(Math.abs(await scale(page) / whole - 1) < 1e-6);
  });

  it('comma and full stop change the speed', async () => {
    const {page} = await openStill(browser(), 'demo');
    const {speed} = await state(page);
    assert.equal((await press(page, ',')).speed, speed - 1);
    assert.equal((await press(page, '.')).speed, speed);
    assert.equal((await press(page, '.')).speed, speed + 1);
    for (let k = 0; k < 20; ++k)
      await page.keyboard.press(',');
    assert.equal((await state(page)).speed, 0);
  });
});

describe('the pointer', () => {
  const browser = useBrowser();

  it('the slider shows and sets the time', async () => {
    const {page} = await openStill(browser(), 'demo');
    await seek(page, 12.5);
    const step = await page.$eval('#time', slider => Number(slider.step) || 0);
    assert.ok(Math.abs((await state(page)).slider - 12.5) <= step / 2 + 1e-9);
    const set = await page.$eval('#time', slider => {
      slider.value = 3;
      slider.dispatchEvent(new Event('input', {bubbles: true}));
      return Number(slider.value);
    });
    await drawn(page);
    assert.ok(Math.abs((await state(page)).time - set) < 1e-9);
  });

  it('follows a disk that is clicked', async () => {
    const {page} = await openStill(browser(), 'demo');
    const frame = factsOf('demo').frames[1];
    await seek(page, frame.time);
    const box = await (await page.$('#machine')).boundingBox();
    const disk = frame.disks.reduce((largest, each) => each.radius > largest.radius ? each : largest);
    const at = await page.evaluate(({x, y}) => window.ratchetSieve.toPixel(x, y), disk);
    await page.mouse.click(box.x + at.x, box.y + at.y);
    await drawn(page);
    assert.equal((await state(page)).followed, disk.id);
    assert.equal((await press(page, 'Escape')).followed, null);
  });

  it('keeps a followed disk in sight', async () => {
    const {page} = await openStill(browser(), 'demo');
    const [first, , later] = factsOf('demo').frames;
    const disk = first.disks.find(one => later.disks.some(other => other.id === one.id));
    await seek(page, first.time);
    await page.evaluate(id => window.ratchetSieve.follow(id), disk.id);
    for (let k = 0; k < 8; ++k)
      await press(page, '+');
    await seek(page, later.time);
    const there = later.disks.find(other => other.id === disk.id);
    const [at, size] = await page.evaluate(({x, y}) => [window.ratchetSieve.toPixel(x, y),
      {width: document.querySelector('#machine').clientWidth, height: document.querySelector('#machine').clientHeight}],
    there);
    assert.ok(at.x > 0 && at.x < size.width && at.y > 0 && at.y < size.height, JSON.stringify({at, size}));
  });
});
