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
    this.columns = [{label: report.labelOf(report.x), value: (place) => report.x.values[place.x]},
      ...report.y ? [{label: report.labelOf(report.y), value: (place) => report.y.values[place.y]}] : [],
      {label: 'runs', value: (place) => place.runs},
      ...report.fields.map((field, k) => ({label: report.labelOf(field),
        value: (place) => place.means[k] ? place.means[k].value : null}))];
    byId('means-note').textContent = 'Means over the seeds and their standard errors; means.csv beside this page has all digits. ' +
      'Q in brackets is not comparable.' +
      (report.places.length > MOST_ROWS ? ` The first ${MOST_ROWS} of ${report.places.length} rows.` : '');
    this.fill();
  }

  /** Undefined values come last. */
  sorted() {
    if (!this.sorting) return this.report.places;
    const {value} = this.columns[this.sorting.column];
    return [...this.report.places].sort((a, b) => {
      const [one, other] = [value(a), value(b)];
      if (one === null || other === null) return (one === null) - (other === null);
      return this.sorting.sign * (typeof one === 'number' && typeof other === 'number' ? one - other
        : String(one).localeCompare(String(other)));
    });
  }

  fill() {
    this.rows = new Map();
    const places = this.sorted().slice(0, MOST_ROWS);
    fillTable(byId('means'), this.columns.map((column, k) => this.head(column, k)), places.map((place) => this.cells(place)));
    const {rows} = byId('means').tBodies[0];
    places.forEach((place, k) => this.rows.set(place, rows[k]));
    [...byId('means').tHead.rows[0].cells].forEach((cell, k) => cell.setAttribute('aria-sort',
      !this.sorting || this.sorting.column !== k ? 'none' : this.sorting.sign > 0 ? 'ascending' : 'descending'));
    if (this.chosen) this.show(this.chosen);
  }

  head(column, k) {
    const isSorted = this.sorting && this.sorting.column === k;
    const sign = isSorted ? this.sorting.sign > 0 ? ' \u25b4' : ' \u25be' : '';
    const button = element('button', {type: 'button', title: 'Sort'}, column.label + sign);
    button.addEventListener('click', () => {
      this.sorting = {column: k, sign: isSorted ? -this.sorting.sign : 1};
      this.fill();
      byId('means').tHead.rows[0].cells[k].firstChild.focus();
    });
    return button;
  }

  cells(place) {
    const {report} = this;
    const choose = element('button', {type: 'button', title: 'Choose this setting'}, report.valueText(report.x, place.x));
    choose.addEventListener('click', () => this.onChoose(place));
    return [choose, ...report.y ? [report.valueText(report.y, place.y)] : [], String(place.runs),
      ...report.fields.map((_, k) => {
        const star = report.fields[k].name === 'quality' && report.isBest(place) ? '\u2605\u00a0' : '';
        const mean = place.means[k];
        const text = star + (mean ? withError(mean.value, mean.error, '') : UNDEFINED);
        return report.isDoubtful(place, k) ? element('span', {class: 'not-comparable', title: 'Q not comparable'}, `(${text})`) : text;
      })];
  }

  show(chosen) {
    if (this.rows.has(this.chosen)) this.rows.get(this.chosen).removeAttribute('aria-current');
    this.chosen = chosen;
    if (this.rows.has(chosen)) this.rows.get(chosen).setAttribute('aria-current', 'true');
  }
}
