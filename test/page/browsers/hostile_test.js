// Texts out of a scene or a bag are data, whatever they look like.
import assert from 'node:assert/strict';
import {describe, it} from 'node:test';
import {HOSTILE, SWEEP, factsOf, openPage} from './support/pages.js';
import {useBrowser} from './support/session.js';

const A_WHILE = 300;  // ms

/// All text that a reader sees, with what can be opened open.
function textOf(page)
{
  return page.evaluate(() => {
    document.querySelectorAll('details').forEach(part => (part.open = true));
    return document.body.innerText;
  });
}

describe('a text that is a program elsewhere', () => {
  const browser = useBrowser();

  for (const name of [HOSTILE, SWEEP])
    it(`does nothing: ${name}`, async () => {
      const {page, seen} = await openPage(browser(), name);
      await new Promise(done => setTimeout(done, A_WHILE));
      assert.deepEqual(seen.said, []);
      assert.deepEqual(await seen.stopped(), []);
      assert.equal(await page.evaluate(() => document.querySelectorAll('img[src=x], svg[onload]').length), 0);
      await page.close();
    });

  it('is shown as it is', async () => {
    const {page} = await openPage(browser(), HOSTILE);
    const {version, scene_hash: hash} = factsOf(HOSTILE);
    const text = await textOf(page);
    for (const [part, hostile] of [[version, /<script>/], [hash, /onerror/]]) {
      assert.match(part, hostile);
      assert.ok(text.includes(part), part);
    }
    await page.close();
  });
});
