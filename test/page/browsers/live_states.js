// What the engine of a live page gives of each scene, with commands on the way: in Node, or in a browser.
// Usage: live_states.js PAGE OUT.json, with PAGE_TEST_BROWSER=node, chromium or firefox
import {readFileSync, writeFileSync} from 'node:fs';
import path from 'node:path';
import {engineOf} from './support/engine.js';

const TIME = 1.5;
const [file, out] = process.argv.slice(2);

// Tilted, faster, more disks, a larger stroke, at times that no multiple of a picture is.
function scheduleOf({quantities, machine})
{
  return [[0, 'command', 0, quantities[0].value + 0.1], [0.123, 'slew', 0.2, 30, 0.01],
    [0.123, 'command', 1, 1.2 * quantities[1].value], [0.4, 'pour', machine.species.length - 1, 7],
    [0.4, 'pour', 0, 3, 0.01, 0.012],
    [0.777, 'command', 2, 1.1 * quantities[2].value], [1.1, 'command', 0, quantities[0].value - 0.05]];
}

function* statesInNode(html)
{
  const {run, scenes, newSession} = engineOf(html);
  run(html.match(/\/\*\* The run as others can repeat it[^]*?(?=\nconst MOST = )/)[0] + ';globalThis.programOf = programOf');
  for (const offered of scenes) {
    const settings = {offered, seed: 7, feedRate: offered.feed_rate, schedule: scheduleOf(offered)};
    const session = newSession(offered, settings);
    session.advance(TIME);
    yield {name: offered.name, ...session.engine.read(),
      program: run('programOf')(settings, session.schedule, session.time)};
  }
}

async function* statesInBrowser(html)
{
  const {chromium, firefox} = await import('./support/browser.js');
  const browser = await (process.env.PAGE_TEST_BROWSER === 'firefox' ? firefox() : chromium());
  const page = await browser.newPage();
  await page.goto('file://' + path.resolve(file));
  await page.evaluate(() => window.ratchetSieve.ready);
  for (const offered of JSON.parse(html.match(/id="data">([^<]*)<\/script>/)[1]).scenes)
    yield page.evaluate(async (name, time, settings) => {
      const {readings, disks} = await window.ratchetSieve.stateAt(name, time, settings);
      return {name, readings, disks: Array.from(disks), program: window.ratchetSieve.program()};
    }, offered.name, TIME, {seed: 7, schedule: scheduleOf(offered)});
  await browser.close();
}

const html = readFileSync(file, 'utf8');
const states = [];
for await (const {name, readings, disks, program} of (process.env.PAGE_TEST_BROWSER === 'node' ? statesInNode : statesInBrowser)(html))
  states.push({name, readings, program, disks: Buffer.from(Float64Array.from(disks).buffer).toString('base64')});
writeFileSync(out, JSON.stringify(states));
