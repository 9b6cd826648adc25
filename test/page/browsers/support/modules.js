// The modules of package.json. They are installed into the build directory, where `import` does not look.
import {createRequire} from 'node:module';
import {readFileSync} from 'node:fs';
import path from 'node:path';

const installed = createRequire(path.resolve(process.env.PAGE_TEST_MODULES, 'package.json'));

export const puppeteer = installed('puppeteer-core');
export const AXE_SOURCE = readFileSync(installed.resolve('axe-core/axe.min.js'), 'utf8');
