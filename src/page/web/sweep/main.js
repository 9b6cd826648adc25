/** The page of a sweep's report: its parts show one field, and one chosen setting. */
class SweepPage {
  constructor(data) {
    this.report = new SweepReport(data);
    this.field = 0;
    this.chosen = this.report.first;
    showHead(data.title, data.origin);
    byId('findings').append(...data.findings.map((line) =>
      element('p', line.startsWith('warning ') ? {class: 'warning'} : {}, line)));
    byId('content').hidden = false;
    this.connectField();
    const choose = (place) => this.choose(place);
    const hasMap = this.report.columns > 1 && this.report.rows > 1;
    this.map = hasMap ? new SweepMap(byId('map'), byId('tip'), this.report, choose) : null;
    byId('map-section').hidden = !hasMap;
    this.curves = new SweepCurves(byId('curves'), this.report, choose);
    this.details = new Chosen(this.report);
    this.means = new MeansTable(this.report, choose);
    for (const id of ['map', 'curves']) byId(id).addEventListener('keydown', (event) => this.onKey(event));
    onThemeChange(() => {
      this.curves.build();
      this.show();
    });
    this.show();
    new ResizeObserver(() => {
      this.curves.chart.resize();
      if (this.map) this.map.resize();
    }).observe(byId('content'));
  }

  connectField() {
    const select = byId('field');
    select.append(...this.report.fields.map((field, k) => element('option', {value: String(k)}, this.report.labelOf(field))));
    select.addEventListener('change', () => this.showField(Number(select.value)));
  }

  show() {
    if (this.map) this.map.show(this.field, this.chosen);
    this.curves.show(this.field, this.chosen);
    this.means.show(this.chosen);
    if (this.shown === this.chosen && this.shownField === this.field) return;
    [this.shown, this.shownField] = [this.chosen, this.field];
    this.details.show(this.chosen, this.field);
  }

  showField(field) {
    this.field = field;
    byId('field').value = String(field);
    this.show();
  }

  choose(place) {
    this.chosen = place;
    this.show();
  }

  /** The next setting that was run, from the chosen one on. */
  move(columns, rows) {
    let {x, y} = this.chosen;
    do {
      x += columns;
      y += rows;
      const place = this.report.at(x, y);
      if (place) return this.choose(place);
    } while (x >= 0 && x < this.report.columns && y >= 0 && y < this.report.rows);
    return undefined;
  }

  /** To the first or the last setting of the chosen row. */
  moveToEnd(isLast) {
    const row = this.report.places.filter((place) => place.y === this.chosen.y);
    this.choose(row[isLast ? row.length - 1 : 0]);
  }

  onKey(event) {
    answerKey(event, {
      ArrowLeft: () => this.move(-1, 0),
      ArrowRight: () => this.move(1, 0),
      ArrowUp: () => this.move(0, 1),
      ArrowDown: () => this.move(0, -1),
      Home: () => this.moveToEnd(false),
      End: () => this.moveToEnd(true),
    });
  }
}

openPage(async () => {
  const page = new SweepPage(JSON.parse(byId('data').textContent));
  const {report} = page;
  return [{
    report: report.data,
    get field() { return report.fields[page.field].name; },
    get chosen() { return page.chosen; },
    get cases() { return report.casesOf(page.chosen); },
    showField: (name) => page.showField(report.fields.findIndex((field) => field.name === name)),
    choose: (column, row = 0) => page.choose(report.at(column, row)),
  }];
});
