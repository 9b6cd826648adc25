/** The element with an id. */
function byId(id) { return document.getElementById(id); }

/**
 * A new element. Strings among the children are text, never markup.
 * @param {string} tag
 * @param {Object<string, string>} attributes
 * @param {...(Node|string)} children
 */
function element(tag, attributes = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  made.append(...children);
  return made;
}

/** Fills a table. The first cell of a row is its heading. @param {Array<string|Node>} head @param {Array<Array<string|Node>>} rows */
function fillTable(table, head, rows) {
  table.querySelectorAll('thead, tbody').forEach((part) => part.remove());
  table.append(element('thead', {}, element('tr', {}, ...head.map((cell) => element('th', {scope: 'col'}, cell)))),
    element('tbody', {}, ...rows.map(([first, ...cells]) =>
      element('tr', {}, element('th', {scope: 'row'}, first), ...cells.map((cell) => element('td', {}, cell))))));
}

/** A table in a box that scrolls. */
function tableOf(title, head, rows) {
  const table = element('table');
  fillTable(table, head, rows);
  return scrolling(title, table);
}

function scrolling(title, content) { return element('div', {class: 'table', tabindex: '0', role: 'group', 'aria-label': title}, content); }

/** Names and values. @param {Array<Array<string|Node>>} rows */
function listOf(rows) { return rows.flatMap(([name, value]) => [element('dt', {}, name), element('dd', {}, value)]); }

/** The head of a page. */
function showHead(title, origin, result = '') {
  document.title = `${title} \u2013 ratchet_sieve`;
  for (const [id, text] of Object.entries({title, origin, result})) byId(id).textContent = text;
}

/** Adds a scene, to be copied. */
function addScene(parent, yaml) {
  const copy = element('button', {id: 'copy-scene', type: 'button'}, 'Copy the scene');
  const text = element('pre', {id: 'scene', tabindex: '0', 'aria-label': 'Scene'}, yaml);
  copyOnClick(copy, () => yaml, text);
  parent.append(element('details', {}, element('summary', {}, 'Scene'), copy, text));
}

/** Whether a key is for the control that has the focus, and for nothing else. */
function isForControl(event) {
  const at = event.target;
  return at.matches('select, textarea, input:not([type=range])') || (event.key === ' ' && at.matches('button, summary'));
}

/** Does what a key stands for in a map of actions, unless it is held with another one. */
function answerKey(event, actions) {
  if (event.ctrlKey || event.metaKey || event.altKey || !Object.hasOwn(actions, event.key)) return;
  event.preventDefault();
  actions[event.key]();
}

/** The bytes of a text in base64. */
function bytesOf(base64) {
  const text = atob(base64.trim());
  const bytes = new Uint8Array(text.length);
  for (let k = 0; k < text.length; ++k) bytes[k] = text.charCodeAt(k);
  return bytes;
}

async function through(bytes, change) {
  return new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(change)).arrayBuffer());
}

const inflated = (bytes) => through(bytes, new DecompressionStream('deflate'));
const deflated = (bytes) => through(bytes, new CompressionStream('deflate'));

/**
 * Opens the page: window.ratchetSieve is what scripts in the page's console, and tests, can do with it once it is ready.
 * @param {function(): Promise<Array<Object>>} make
 */
function openPage(make) {
  window.ratchetSieve = {};
  window.ratchetSieve.ready = make().then((scripting) => {
    for (const part of scripting) Object.defineProperties(window.ratchetSieve, Object.getOwnPropertyDescriptors(part));
  }).catch((error) => {
    byId('failure').hidden = false;
    byId('failure').textContent = 'This page cannot be shown: ' + error.message;
    throw error;
  });
}

/** A name with a dot in its colour, or a ring as its disks are drawn. */
function marked(name, k) {
  const mark = element('span', {class: 'mark'});
  mark.style.border = `.17em solid var(${kindColour(k)})`;
  if (!isRepeated(k)) mark.style.background = `var(${kindColour(k)})`;
  return element('span', {}, mark, name);
}

/**
 * Makes a button copy a text.
 * @param {function(): string} textOf
 * @param {Node} shown where the text stands: without the right to the clipboard it is selected, to be copied by hand
 */
function copyOnClick(button, textOf, shown) {
  const label = button.textContent;
  button.addEventListener('click', async () => {
    try {
      await navigator.clipboard.writeText(textOf());
      button.textContent = 'Copied';
    } catch (error) {
      getSelection().selectAllChildren(shown);
      button.textContent = 'Selected';
    }
    setTimeout(() => { button.textContent = label; }, 2000);
  });
}

/** What is shown in place of a value that is not defined. */
const UNDEFINED = '\u2014';

/** A value, or null, to so many significant digits, with its unit. */
function quantity(value, unit = '', digits = 4) {
  if (value === null || value === undefined) return UNDEFINED;
  const text = Math.abs(value) >= 1e6 || (value !== 0 && Math.abs(value) < 1e-4)
    ? value.toExponential(digits - 1) : String(Number(value.toPrecision(digits)));
  return text.replace('-', '\u2212') + (unit ? '\u00a0' + unit : '');
}

/** In which unit a number of an SI unit is shown, and how many of it that is. */
function shownUnit(unit) { return {m: ['mm', 1e3], 'm/s': ['mm/s', 1e3], kg: ['g', 1e3], 'kg/s': ['g/s', 1e3]}[unit] || [unit, 1]; }

/** A value of an SI unit as it is shown. */
function shownText(value, unit, digits) {
  const [shown, scale] = shownUnit(unit);
  return quantity(value === null ? null : scale * value, shown, digits);
}

/** s, Q, P and shares, to three decimals. */
function ratio(value) { return value === null || value === undefined ? UNDEFINED : value.toFixed(3).replace('-', '\u2212'); }

/** A share. */
function percent(share) { return `${(100 * share).toFixed(0)}\u00a0%`; }

/** A number of things. */
function countText(count, thing) { return `${count} ${thing}${count === 1 ? '' : 's'}`; }

/** What can be commanded: symbol and unit. */
const COMMANDED = {inclination: ['\u03b8', 'rad'], frequency: ['f', 'Hz'], amplitude: ['A', 'm']};

/** What symbols mean. */
const MEANINGS = {
  s: 'separation: the share of the first kind that left on the left, less that of the second',
  Q: 'how well the kinds are sorted: 1 where each has a side of its own, 0 where both sides hold the same mixture',
  P: 'the share of all disks that has left the machine',
  '\u03b8': 'inclination of the base: its right end is raised where it is above 0',
  f: 'frequency with which the base is shaken',
  A: 'amplitude: how far the base moves up and down from its middle',
  '\u27e8V_x\u27e9': 'mean velocity along the base, to the right',
};

/** A symbol that says what it means when one points at it. */
function symbol(name) { return element('abbr', {title: MEANINGS[name]}, name); }

/** A value and its standard error. */
function withError(value, error, unit, scale = 1) {
  if (value === null || value === undefined) return UNDEFINED;
  const decimals = Math.max(0, Math.min(12, 1 - Math.floor(Math.log10(Math.max(error * scale, 1e-12)))));
  const texts = error ? [value, error].map((number) => (number * scale).toFixed(decimals).replace('-', '\u2212'))
    : [quantity(value * scale), error === 0 ? '0' : UNDEFINED];
  return texts.join(' \u00b1 ') + (unit ? '\u00a0' + unit : '');
}

/** A time to the millisecond. */
function seconds(time) { return time.toFixed(3) + '\u00a0s'; }

/** The place of the last number that is not above `value` in ascending numbers; -1: there is none. */
function lastNotAbove(numbers, value) {
  let from = 0;
  let to = numbers.length;
  while (from < to) {
    const middle = (from + to) >> 1;
    if (numbers[middle] <= value) from = middle + 1; else to = middle;
  }
  return from - 1;
}

const KINDS = 6;  // that have a colour of their own in the style sheet

function kindColour(k) { return `--kind-${k % KINDS}`; }

function colourOf(k) { return themeColour(kindColour(k)); }

/** Whether k has the colour of an earlier one: its disks are hollow, and its lines dotted. */
function isRepeated(k) { return k >= KINDS; }

/** The dashes of a line of k as an option of uPlot. @param {boolean} isOther of two lines of k */
function dashesOf(k, isOther = false) {
  const dashes = isRepeated(k) ? (isOther ? [6, 3, 1.5, 3] : [1.5, 3]) : isOther ? [6, 4] : null;
  return dashes ? {dash: dashes} : {};
}

/** A colour of the style sheet, such as --line. */
function themeColour(name) { return getComputedStyle(document.documentElement).getPropertyValue(name).trim(); }

/** Calls back when the colours change: light, dark, print. */
function onThemeChange(callback) {
  for (const query of ['(prefers-color-scheme: dark)', 'print']) matchMedia(query).addEventListener('change', callback);
}
