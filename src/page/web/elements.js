/** The element with an id. */
function byId(id) {
  return document.getElementById(id);
}

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

/** A name with a dot in its colour. */
function marked(name, colour) {
  const mark = element('span', {class: 'mark'});
  mark.style.background = colour;
  return element('span', {}, mark, name);
}
