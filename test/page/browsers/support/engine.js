// The engine of a live page in Node, by the page's own parts.
import vm from 'node:vm';
import {inflateSync} from 'node:zlib';

/// @return {{scenes, newSession, run}} the offered scenes; a Session of one; what runs further scripts beside the worker's
export function engineOf(html)
{
  const textOf = id => html.match(new RegExp(`<script type="[^"]*" id="${id}">([^]*?)</script>`))[1];
  const context = vm.createContext({WebAssembly, TextDecoder, performance, postMessage() {}});
  const run = script => vm.runInContext(script, context);
  run(textOf('worker').replace(/^onmessage/m, 'globalThis.onmessage') + ';globalThis.Session = Session');
  const engine = new WebAssembly.Module(inflateSync(Buffer.from(textOf('engine'), 'base64')));
  return {
    run,
    scenes: JSON.parse(textOf('data')).scenes,
    newSession: (offered, settings) => new context.Session(engine, Buffer.from(offered.definition, 'base64'), settings),
  };
}
