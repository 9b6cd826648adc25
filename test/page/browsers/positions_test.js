// The disks of a page are those of its bag, and never below the base.
import assert from 'node:assert/strict';
import {describe, it} from 'node:test';
import {baseAt, heightAbove} from './support/base.js';
import {RUNS, factsOf, openStill} from './support/pages.js';
import {useBrowser} from './support/browser.js';

const SAME_TIME = 1e-9;     // s
const FINE_ENOUGH = 0.05;   // the page's resolution over the smallest radius
const ROUNDING = 1 + 1e-6;  // of positions on the edge of the resolution
const TURN = 2 * Math.PI;
const SAME_ANGLE = 0.51 * TURN / 256;
const FRAME = 1 / 240;            // of the run that is whole [s]
const SAG = 9.81 / 8 / 30 ** 2;  // of a flight of 1/30 s below its tangents' crossing [m]

/// As one text: of 10^4 objects Firefox's protocol takes seconds.
async function disksAt(page, time)
{
  return JSON.parse(await page.evaluate(to => {
    window.ratchetSieve.seek(to);
    return JSON.stringify(window.ratchetSieve.disks());
  }, time));
}

/// The recorded times of the page that the facts have, too.
async function sharedFrames(page, facts)
{
  const times = await page.evaluate(() => [...window.ratchetSieve.frames]);
  return facts.frames.filter(frame => times.some(time => Math.abs(time - frame.time) < SAME_TIME));
}

function smallestRadius(facts)
{
  return Math.min(...facts.frames.flatMap(frame => frame.disks.map(disk => disk.radius)));
}

function assertSameDisks(drawn, recorded, resolution, species)
{
  const byId = new Map(drawn.map(disk => [disk.id, disk]));
  assert.equal(drawn.length, recorded.length);
  for (const expected of recorded) {
    const disk = byId.get(expected.id);
    assert.ok(disk, `disk ${expected.id} is missing`);
    for (const field of ['x', 'y', 'radius'])
      assert.ok(Math.abs(disk[field] - expected[field]) <= resolution * ROUNDING,
        `${field} of disk ${disk.id}: ${disk[field]} for ${expected[field]}, resolution ${resolution}`);
    const turned = Math.abs(disk.angle - expected.angle) / TURN;
    assert.ok(Math.abs(turned - Math.round(turned)) * TURN <= SAME_ANGLE, `angle of disk ${disk.id}`);
    assert.ok([expected.species, species[expected.species]].includes(disk.species), `species of disk ${disk.id}`);
  }
}

/// Between a recorded time and the next, where base and drive are known.
function timesBetween(facts)
{
  const stride = Math.max(1, Math.floor(facts.base.length / 12));
  return facts.base.slice(0, -1).flatMap((frame, k) => (k % stride === 0 ? [0.2, 0.5, 0.8] : []).map(share =>
    frame.time + share * (facts.base[k + 1].time - frame.time)));
}

describe('at recorded times', () => {
  const browser = useBrowser();
  for (const name of RUNS)
    it(`the disks are the bag's: ${name}`, async () => {
      const facts = factsOf(name);
      const {page} = await openStill(browser(), name);
      const resolution = await page.evaluate(() => window.ratchetSieve.resolution);
      assert.ok(resolution > 0 && resolution <= FINE_ENOUGH * smallestRadius(facts), `resolution ${resolution}`);
      const frames = await sharedFrames(page, facts);
      assert.ok(frames.length >= 3, `only ${frames.length} of the bag's times are in the page`);
      const species = facts.scene.species.map(one => one.name);
      for (const frame of frames)
        assertSameDisks(await disksAt(page, frame.time), frame.disks, resolution, species);
    });
});

describe('between recorded times', () => {
  const browser = useBrowser();
  for (const name of RUNS)
    it(`no disk is below the base: ${name}`, async () => {
      const facts = factsOf(name);
      const {page} = await openStill(browser(), name);
      const resolution = await page.evaluate(() => window.ratchetSieve.resolution);
      let looked = 0;
      for (const time of timesBetween(facts)) {
        const base = baseAt(facts.base, time);
        for (const disk of await disksAt(page, time)) {
          const height = heightAbove(facts.scene, base, disk.x, disk.y);
          if (height === undefined)
            continue;
          ++looked;
          assert.ok(height >= disk.radius - 2 * resolution,
            `t = ${time}: disk ${disk.id} of radius ${disk.radius} is ${height} above the base`);
        }
      }
      assert.ok(looked > 100, `only ${looked} disks were looked at`);
    });
});

// A run by its bag, and pages of it with fewer frames: a path between two of them goes no higher than the disks did.
describe('in pages that are thinned', () => {
  const browser = useBrowser();
  for (const name of ['cut', 'few'])
    it(`no disk rises above those of the run: ${name}`, async () => {
      const tops = factsOf('tops');
      const {page} = await openStill(browser(), name);
      const frames = await page.evaluate(() => window.ratchetSieve.frames);
      let looked = 0;
      for (let k = 0; k + 1 < frames.length; ++k) {
        const [from, to] = [frames[k], frames[k + 1]];
        const highest = Math.max(...tops.filter(([time]) => time > from - FRAME && time < to + FRAME).map(([, y]) => y));
        for (const share of to - from > 1.5 * FRAME && k % 4 === 0 ? [0.25, 0.5, 0.75] : []) {
          const drawn = await disksAt(page, from + share * (to - from));
          const top = Math.max(...drawn.map(disk => disk.y));
          assert.ok(top < highest + SAG, `t = ${from + share * (to - from)}: a disk at ${top}, in the run at ${highest}`);
          ++looked;
        }
      }
      assert.ok(looked > 20, `only ${looked} times were looked at`);
      const rate = (frames.length - 1) / (frames[frames.length - 1] - frames[0]);
      assert.ok(name === 'few' || rate > 29.9, `${rate} frames a second`);
    });
});
