// How large pages are.
import assert from 'node:assert/strict';
import {statSync} from 'node:fs';
import {it} from 'node:test';
import {DIRECT, pathOf} from './support/pages.js';

const MOST = 3e6;  // bytes

for (const name of ['demo', DIRECT])
  it(`half a minute of the demo can be mailed: ${name}`, () => {
    const {size} = statSync(pathOf(name));
    assert.ok(size <= MOST, `${size} bytes`);
  });
