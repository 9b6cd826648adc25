// Where the bag says that disks are, the canvas has their species' colours, which are told apart in light and dark.
import assert from 'node:assert/strict';
import {describe, it} from 'node:test';
import {useBrowser} from './support/browser.js';
import {drawn, factsOf, openStill, seek} from './support/pages.js';
import {colourOfDisk, difference, picture} from './support/picture.js';

const VISIBLE = 6;         // radius of a disk whose colour is looked at [px]
const MOST_ZOOM = 80;      // presses of +
const SAME_COLOUR = 12;    // difference of the colours of disks of a species
const OTHER_COLOUR = 40;   // least difference of species, and of a species and the background

/// Disks of the bag in pixels of the canvas.
function shownDisks(page, disks)
{
  return page.evaluate(given => given.map(disk => {
    const centre = window.ratchetSieve.toPixel(disk.x, disk.y);
    const edge = window.ratchetSieve.toPixel(disk.x + disk.radius, disk.y);
    return {species: disk.species, x: centre.x, y: centre.y, radius: edge.x - centre.x};
  }), disks);
}

/// The colours of the disks about one, zoomed until it is well visible, by their species.
async function coloursAbout(page, disk, disks)
{
  await page.evaluate(id => window.ratchetSieve.follow(id), disk.id);
  for (let k = 0; k < MOST_ZOOM && (await shownDisks(page, [disk]))[0].radius < VISIBLE; ++k) {
    await page.keyboard.press('+');
    await drawn(page);
  }
  await page.keyboard.press('Escape');
  await drawn(page);
  const image = await picture(page, '#machine');
  const found = (await shownDisks(page, disks))
    .filter(({x, y, radius}) => radius >= VISIBLE && x > radius && x < image.width - radius &&
      y > radius && y < image.height - radius)
    .map(({species, x, y, radius}) => ({species, colour: colourOfDisk(image, x, y, radius)}));
  await page.keyboard.press('0');
  return {background: image.at(3, 3), found};
}

for (const dark of [false, true])
  describe(`in ${dark ? 'dark' : 'light'}, disks have their species' colour`, () => {
    const browser = useBrowser({dark});
    const name = dark ? 'sizes' : 'demo';
    it(name, async () => {
      const facts = factsOf(name);
      const {page} = await openStill(browser(), name);
      const frame = facts.frames[1];
      await seek(page, frame.time);
      const colours = [];
      for (const species of facts.scene.species.keys()) {
        const present = frame.disks.filter(disk => disk.species === species);
        const {background, found} = await coloursAbout(page, present[Math.floor(present.length / 2)], frame.disks);
        colours.push(...found, {species: -1, colour: background});
      }
      assert.equal(new Set(colours.map(({species}) => species)).size, facts.scene.species.length + 1);
      for (const one of colours)
        for (const other of colours) {
          const apart = difference(one.colour, other.colour);
          assert.ok(one.species === other.species ? apart <= SAME_COLOUR : apart >= OTHER_COLOUR,
            `species ${one.species} and ${other.species}: ${one.colour} and ${other.colour}`);
        }
    });
  });
