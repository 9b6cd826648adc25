const MOST_ROWS = 2000;  // of the table of all means

/** The chosen setting: its means, and its runs with their command lines. */
class Chosen {
  constructor(report) {
    this.report = report;
    copyOnClick(byId('copy-all'), () => this.cases.map(({command}) => command + '\n').join(''), byId('cases'));
  }

  show(place, field) {
    const {report} = this;
    this.cases = report.casesOf(place);
    byId('chosen').textContent = `${report.isBest(place) ? 'The best setting, ' : ''}${report.settingText(place)}: ${report.fields[field].label} ${report.meanText(place, field)} ` +
      `(${report.remarks(place, field)})`;
    fillTable(byId('chosen-means'), ['field', 'mean and standard error', 'from'], report.fields.map((each, k) =>
      [each.label, report.meanText(place, k), report.remarks(place, k)]));
    byId('copy-all').textContent = 'Copy all command lines';
    byId('copy-all').hidden = this.cases.length === 1;
    fillTable(byId('cases'), ['seed', 'page', 'copy', 'command line'], this.cases.map((each) => this.row(each)));
  }

  row({seed, command, page}) {
    const code = element('code', {}, command);
    const copy = element('button', {type: 'button', 'aria-label': `Copy the command line of seed ${seed}`}, 'Copy');
    copyOnClick(copy, () => command, code);
    const link = page === null ? 'not kept' : element('a', {href: page, 'aria-label': `Play the run of seed ${seed}`}, 'Play');
    return [seed, link, copy, code];
  }
}

/** The table of all means, which a click on a head sorts. */
class MeansTable {
  /** @param {function(Object)} onChoose takes a place */
  constructor(report, onChoose) {
    this.report = report;
    this.onChoose = onChoose;
    this.sorting = null;
    const ofAxis = (axis, k, cell) => ({label: report.labelOf(axis), value: (place) => axis.values[place[k]], cell});
    this.columns = [ofAxis(report.x, 'x', (place) => this.choice(place)),
      ...report.y ? [ofAxis(report.y, 'y', (place) => report.valueText(report.y, place.y))] : [],
      {label: 'runs', value: (place) => place.runs, cell: (place) => String(place.runs)},
      ...report.fields.map((field, k) => ({label: report.labelOf(field),
        value: (place) => place.means[k] ? place.means[k].value : null, cell: (place) => this.mean(place, k)}))];
    byId('means-note').textContent = 'Means over the seeds and their standard errors; means.csv beside this page has all digits. ' +
      'Q in brackets is not comparable.' +
      (report.places.length > MOST_ROWS ? ` The first ${MOST_ROWS} of ${report.places.length} rows.` : '');
    this.fill();
  }

  /** Undefined values come last. */
  sorted() {
    if (!this.sorting) return this.report.places;
    const {sign, column} = this.sorting;
    return [...this.report.places].sort((a, b) => {
      const [one, other] = [column.value(a), column.value(b)];
      if (one === null || other === null) return (one === null) - (other === null);
      return sign * ((one > other) - (one < other));
    });
  }

  fill() {
    const table = byId('means');
    const places = this.sorted().slice(0, MOST_ROWS);
    fillTable(table, this.columns.map((column) => this.head(column)),
      places.map((place) => this.columns.map(({cell}) => cell(place))));
    this.rows = new Map(places.map((place, k) => [place, table.tBodies[0].rows[k]]));
    this.columns.forEach((column, k) => table.tHead.rows[0].cells[k].setAttribute('aria-sort',
      !this.sorting || this.sorting.column !== column ? 'none' : this.sorting.sign > 0 ? 'ascending' : 'descending'));
    if (this.chosen) this.show(this.chosen);
  }

  head(column) {
    const button = element('button', {type: 'button', title: 'Sort'}, column.label);
    button.addEventListener('click', () => {
      this.sorting = {column, sign: this.sorting && this.sorting.column === column ? -this.sorting.sign : 1};
      this.fill();
      byId('means').tHead.rows[0].cells[this.columns.indexOf(column)].firstChild.focus();
    });
    return button;
  }

  choice(place) {
    const choose = element('button', {type: 'button', title: 'Choose this setting'}, this.report.valueText(this.report.x, place.x));
    choose.addEventListener('click', () => this.onChoose(place));
    return choose;
  }

  mean(place, k) {
    const {report} = this;
    const star = report.isQuality(k) && report.isBest(place) ? '\u2605\u00a0' : '';
    const mean = place.means[k];
    const text = star + (mean ? withError(mean.value, mean.error, '') : UNDEFINED);
    return report.isDoubtful(place, k) ? element('span', {class: 'not-comparable', title: 'Q not comparable'}, `(${text})`) : text;
  }

  show(chosen) {
    if (this.rows.has(this.chosen)) this.rows.get(this.chosen).removeAttribute('aria-current');
    this.chosen = chosen;
    if (this.rows.has(chosen)) this.rows.get(chosen).setAttribute('aria-current', 'true');
  }
}
