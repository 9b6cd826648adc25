// Where the bag says that disks are, the canvas has their species' colours; elsewhere it has not.
import assert from 'node:assert/strict';
import {describe, it} from 'node:test';
import {baseAt, heightAbove} from './support/base.js';
import {drawn, factsOf, openStill, seek} from './support/pages.js';
import {colourOfDisk, difference, picture} from './support/picture.js';
import {useBrowser} from './support/session.js';

const VISIBLE = 6;         // radius of a disk whose colour is looked at [px]
const MOST_ZOOM = 80;      // presses of +
const SAME_COLOUR = 12;    // difference of the colours of disks of a species
const OTHER_COLOUR = 40;   // least difference of species, and of a species and the background
const CLEAR = 4;           // of a point beside disks, from their edges [px]

/// Zooms onto a disk until it is well visible; then follows none.
async function zoomOnto(page, disk)
{
  await page.evaluate(id => window.ratchetSieve.follow(id), disk.id);
  for (let k = 0; k < MOST_ZOOM && (await shownDisks(page, [disk]))[0].radius < VISIBLE; ++k) {
    await page.keyboard.press('+');
    await drawn(page);
  }
  await page.evaluate(() => window.ratchetSieve.follow(null));
  await drawn(page);
}

/// Disks of the bag in pixels of the canvas.
function shownDisks(page, disks)
{
  return page.evaluate(given => given.map(disk => {
    const centre = window.ratchetSieve.toPixel(disk.x, disk.y);
    const edge = window.ratchetSieve.toPixel(disk.x + disk.radius, disk.y);
    return {species: disk.species, x: centre.x, y: centre.y, radius: edge.x - centre.x};
  }), disks);
}

async function machinePicture(page)
{
  const canvas = await page.$('#machine');
  return picture(await canvas.screenshot());
}

function isInside(image, disk)
{
  return disk.x - disk.radius > CLEAR && disk.x + disk.radius < image.width - CLEAR &&
    disk.y - disk.radius > CLEAR && disk.y + disk.radius < image.height - CLEAR;
}

/// The colours of the points of a grid that are clear of all disks and above the base.
async function clearColours(page, image, shown, facts, time)
{
  const points = [];
  for (let y = 10; y < image.height - 10; y += 7)
    for (let x = 10; x < image.width - 10; x += 7)
      if (shown.every(disk => Math.hypot(disk.x - x, disk.y - y) > disk.radius + CLEAR))
        points.push([x, y]);
  const [origin, unit] = await page.evaluate(() =>
    [window.ratchetSieve.toPixel(0, 0), window.ratchetSieve.toPixel(1, 1)]);
  const scale = [unit.x - origin.x, unit.y - origin.y];
  const base = baseAt(facts.base, time);
  return points.filter(([x, y]) => {
    const height = heightAbove(facts.scene, base, (x - origin.x) / scale[0], (y - origin.y) / scale[1]);
    return height !== undefined && height * scale[0] > CLEAR;
  }).map(([x, y]) => image.at(x, y));
}

function mostFrequent(colours)
{
  const counts = new Map();
  for (const colour of colours)
    counts.set(colour.join(), (counts.get(colour.join()) ?? 0) + 1);
  return [...counts].sort((a, b) => b[1] - a[1])[0][0].split(',').map(Number);
}

for (const dark of [false, true])
  describe(`in ${dark ? 'dark' : 'light'}, disks have their species' colour`, () => {
    const browser = useBrowser({dark});
    for (const name of [dark ? 'sizes' : 'demo'])
      it(name, async () => {
        const facts = factsOf(name);
        const {page} = await openStill(browser(), name);
        const frame = facts.frames[1];
        await seek(page, frame.time);
        const colours = new Map();
        let clear = [];
        for (const species of facts.scene.species.keys()) {
          const present = frame.disks.filter(disk => disk.species === species);
          await page.keyboard.press('0');
          await zoomOnto(page, present[Math.floor(present.length / 2)]);
          const image = await machinePicture(page);
          const shown = await shownDisks(page, frame.disks);
          const visible = shown.filter(disk => disk.radius >= VISIBLE && isInside(image, disk));
          for (const disk of visible)
            colours.set(disk.species, [...colours.get(disk.species) ?? [],
              colourOfDisk(image, disk.x, disk.y, disk.radius)]);
          clear = clear.concat(await clearColours(page, image, shown, facts, frame.time));
        }
        assert.ok(clear.length > 100, `only ${clear.length} points beside disks`);
        const background = mostFrequent(clear);
        const seen = [...colours].map(([species, found]) => ({species, found, usual: mostFrequent(found)}));
        assert.equal(seen.length, facts.scene.species.length, 'each species was seen');
        for (const {species, found, usual} of seen) {
          for (const colour of found)
            assert.ok(difference(colour, usual) <= SAME_COLOUR, `species ${species}: ${colour} for ${usual}`);
          assert.ok(difference(usual, background) >= OTHER_COLOUR, `species ${species} as the background: ${usual}`);
          assert.equal(clear.filter(colour => difference(colour, usual) <= SAME_COLOUR).length, 0,
            `the colour of species ${species}, ${usual}, is where no disk is`);
        }
        for (const one of seen)
          for (const other of seen)
            assert.ok(one === other || difference(one.usual, other.usual) >= OTHER_COLOUR,
              `species ${one.species} and ${other.species} look alike: ${one.usual}, ${other.usual}`);
        await page.close();
      });
  });
