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
