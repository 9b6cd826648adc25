// Every page opens without a complaint, asks for nothing and has a policy that holds. The watch itself is tested first.
import assert from 'node:assert/strict';
import {once} from 'node:events';
import {mkdtempSync, rmSync, writeFileSync} from 'node:fs';
import {createServer} from 'node:http';
import {tmpdir} from 'node:os';
import path from 'node:path';
import {after, describe, it} from 'node:test';
import {ALL, drawn, openFile, openPage} from './support/pages.js';
import {useBrowser} from './support/browser.js';

// A server that a page must not ask.
const server = createServer((_, response) => response.end()).listen(0, '127.0.0.1');
await once(server, 'listening');
const OUTSIDE = `http://127.0.0.1:${server.address().port}/picture.png`;
after(() => server.close());

describe('the watch', () => {
  const browser = useBrowser();
  const scratch = mkdtempSync(path.join(tmpdir(), 'page_test-'));
  after(() => rmSync(scratch, {recursive: true}));

  it('sees warnings, errors, exceptions, rejections and dialogs', async () => {
    const file = path.join(scratch, 'loud.html');
    writeFileSync(file, `<!doctype html><title>x</title><script>console.warn("careful"); console.error("wrong");
      setTimeout(() => { throw new Error("thrown"); }); Promise.reject(new Error("rejected")); alert("boo")</script>`);
    const {page, seen} = await openFile(browser(), file);
    await drawn(page);
    for (const found of [/^warn.*: careful/m, /^error: wrong/m, /^exception: .*thrown/m, /^exception: .*rejected/m,
      /^dialog: boo/m])
      assert.match(seen.said.join('\n'), found);
  });

  it('sees a request', async () => {
    const file = path.join(scratch, 'request.html');
    writeFileSync(file, `<!doctype html><title>x</title><img src="${OUTSIDE}" alt="">`);
    const {page, seen} = await openFile(browser(), file);
    assert.deepEqual(seen.requested, [OUTSIDE]);
  });
});

describe('every page', () => {
  const browser = useBrowser();

  for (const name of ALL)
    it(`is quiet: ${name}`, async () => {
      const {page, seen} = await openPage(browser(), name);
      await page.evaluate(() => window.ratchetSieve?.play?.());
      await new Promise(done => setTimeout(done, 300));
      await page.evaluate(() => window.scrollTo(0, document.body.scrollHeight));
      await drawn(page);
      assert.deepEqual(seen.said, []);
      assert.deepEqual(seen.requested, []);
      assert.deepEqual(await seen.stopped(), []);
      // Its policy stops every request.
      assert.match(await page.$eval('meta[http-equiv="Content-Security-Policy"]', meta => meta.content),
        /^default-src 'none'/);
      await page.evaluate(url => new Promise(done => {
        const image = new Image();
        image.onload = image.onerror = done;
        image.src = url;
        document.body.append(image);
      }), OUTSIDE);
      await drawn(page);
      assert.deepEqual(await seen.stopped(), [OUTSIDE]);
    });
});
