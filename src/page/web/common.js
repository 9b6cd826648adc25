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

/** A row of a table: the first cell is its heading. */
function rowOf(cells, columnsHead = false) {
  return element('tr', {}, ...cells.map((cell, k) =>
    columnsHead ? element('th', {scope: 'col'}, cell)
      : k === 0 ? element('th', {scope: 'row'}, cell) : element('td', {}, cell)));
}

/** Fills a table. @param {Array<string|Node>} head @param {Array<Array<string|Node>>} rows */
function fillTable(table, head, rows) {
  for (const part of [...table.tHead ? [table.tHead] : [], ...table.tBodies]) part.remove();
  table.append(element('thead', {}, rowOf(head, true)), element('tbody', {}, ...rows.map((row) => rowOf(row))));
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
  const of = PALETTE[k % PALETTE.length];
  const colour = of.startsWith('--') ? `var(${of})` : of;
  mark.style.border = `.17em solid ${colour}`;
  if (!isRepeated(k)) mark.style.background = colour;
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

/** s, Q, P and shares, to three decimals. */
function ratio(value) { return value === null || value === undefined ? UNDEFINED : value.toFixed(3).replace('-', '\u2212'); }

/** A share. */
function percent(share) { return `${(100 * share).toFixed(0)}\u00a0%`; }

/** A number of things. */
function countText(count, thing) { return `${count} ${thing}${count === 1 ? '' : 's'}`; }

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
  if (error === null || error === undefined) return `${quantity(value * scale)} \u00b1 ${UNDEFINED}${unit ? '\u00a0' + unit : ''}`;
  if (error === 0) return `${quantity(value * scale)} \u00b1 0${unit ? '\u00a0' + unit : ''}`;
  const decimals = Math.max(0, Math.min(12, 1 - Math.floor(Math.log10(Math.max(error * scale, 1e-12)))));
  return `${(value * scale).toFixed(decimals)} \u00b1 ${(error * scale).toFixed(decimals)}${unit ? '\u00a0' + unit : ''}`.replace('-', '\u2212');
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

/**
 * Okabe and Ito's colours, which colour-blind readers can tell apart; as in the other pictures and in RViz. The first is
 * lighter in the dark.
 */
const PALETTE = ['--first-kind', '#D55E00', '#009E73', '#CC79A7', '#E69F00', '#56B4E9'];

function colourOf(k) {
  const colour = PALETTE[k % PALETTE.length];
  return colour.startsWith('--') ? themeColour(colour) : colour;
}

/** Whether k has the colour of an earlier one: its disks are hollow, and its lines dotted. */
function isRepeated(k) { return k >= PALETTE.length; }

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
