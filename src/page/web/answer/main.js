const MOST_SHOWN = 10;  // rows of a table; the rest is folded

/** A table with its title and note, whose later rows are folded. @param {{title: string, note: string, head: Array, rows: Array}} about */
function foldedTable({title, note, head, rows}) {
  const more = rows.slice(MOST_SHOWN);
  return element('div', {}, element('h3', {}, title), ...note ? [element('p', {class: 'note'}, note)] : [],
    tableOf(title, head, rows.slice(0, MOST_SHOWN)),
    ...more.length ? [element('details', {}, element('summary', {}, countText(more.length, 'more row')), tableOf(title, head, more))] : []);
}

/** The page of an answer: python/ratchet_sieve/answers/page.py. */
openPage(async () => {
  const answer = JSON.parse(byId('data').textContent);
  showHead(answer.title, answer.origin, answer.result);
  byId('lines').append(...answer.lines.map((line) =>
    element('p', line.startsWith('warning: ') ? {class: 'warning'} : {}, line)));
  byId('tables').append(...answer.tables.map(foldedTable));
  byId('map-section').hidden = !answer.picture;
  if (answer.picture) Object.assign(byId('picture'), {src: 'data:image/png;base64,' + answer.picture.bytes, alt: answer.picture.says});
  byId('best-section').hidden = !answer.scene;
  if (answer.scene) addScene(byId('best-section'), answer.scene);
  byId('content').hidden = false;
  return [{answer}];
});
