// Runs a scene of a live page twice by the page's own engine in Node. Usage: web_engine.mjs PAGE SCENE TIME
// Prints, as JSON, the events and the processor time of the second simulation [s].
import {readFileSync} from 'node:fs';
import {engineOf} from '../test/page/browsers/support/engine.js';

const [page, name, time] = process.argv.slice(2);
const {scenes, newSession} = engineOf(readFileSync(page, 'utf8'));
const offered = scenes.find(scene => scene.name === name);
const begun = () => newSession(offered, {seed: offered.seed, feedRate: offered.feed_rate, schedule: []});
begun().advance(Number(time));  // until the engine is compiled as well as Node can
const session = begun();
const before = process.cpuUsage();
session.advance(Number(time));
const used = process.cpuUsage(before);
console.log(JSON.stringify({events: session.engine.read().readings.events, seconds: 1e-6 * (used.user + used.system)}));
