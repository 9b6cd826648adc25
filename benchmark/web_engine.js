// Runs a scene of a live page twice by the page's own engine in Node. Usage: web_engine.js PAGE SCENE TIME
// Prints, as JSON, the events and the processor time of the second simulation [s].
'use strict';
const {readFileSync} = require('node:fs');
const vm = require('node:vm');
const {inflateSync} = require('node:zlib');

const [page, name, time] = process.argv.slice(2);
const html = readFileSync(page, 'utf8');
const textOf = id => html.match(new RegExp(`<script type="[^"]*" id="${id}">([^]*?)</script>`))[1];
const context = vm.createContext({WebAssembly, TextDecoder, performance, postMessage() {}});
vm.runInContext(textOf('worker').replace(/^onmessage/m, 'globalThis.onmessage') + ';globalThis.Session = Session', context);
const engine = new WebAssembly.Module(inflateSync(Buffer.from(textOf('engine'), 'base64')));
const {definition, seed, feed_rate: feedRate} = JSON.parse(textOf('data')).scenes.find(scene => scene.name === name);
const newSession = () => new context.Session(engine, Buffer.from(definition, 'base64'), {seed, feedRate, schedule: []});
newSession().advance(Number(time));  // until the engine is compiled as well as Node can
const session = newSession();
const before = process.cpuUsage();
session.advance(Number(time));
const used = process.cpuUsage(before);
console.log(JSON.stringify({events: session.engine.read().readings.events, seconds: 1e-6 * (used.user + used.system)}));
