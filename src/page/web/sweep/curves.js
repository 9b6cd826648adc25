const MOST_CURVES = 10;    // in one picture
const CURVES_HEIGHT = 320;
const LABEL_HEIGHT = 14;   // of the curves' ends [px]
const POINT = 3;           // radius [px]

/** The means of a field over x, with a curve for each value of y. */
class SweepCurves {
  /** @param {function(Object)} onChoose takes a place */
  constructor(parent, report, onChoose) {
    this.parent = parent;
    this.report = report;
    this.onChoose = onChoose;
    this.chart = null;
    const {values} = report.x;
    this.isNumeric = values.every((value) => typeof value === 'number');
    this.positions = this.isNumeric ? values : values.map((_, k) => k);
    byId('curves-note').textContent = 'Means over the seeds and their standard errors. A click or the arrow keys choose a setting.' +
      (this.showsAll ? '' : ` The curve is that of the chosen setting, one of ${report.rows}.`);
  }

  get showsAll() { return this.report.rows <= MOST_CURVES; }

  show(field, chosen) {
    const sameCurves = this.chart && field === this.field && (this.showsAll || chosen.y === this.chosen.y);
    this.field = field;
    this.chosen = chosen;
    if (sameCurves) this.chart.redraw();
    else this.build();
  }

  build() {
    if (this.chart) this.chart.remove();
    const {report, field} = this;
    this.shownRows = this.showsAll ? Array.from({length: report.rows}, (_, k) => k) : [this.chosen.y];
    this.colours = curveColours(this.shownRows.map((row) => report.y ? report.y.values[row] : field));
    this.names = this.shownRows.map((row) => report.y ? report.valueText(report.y, row) : report.fields[field].label);
    this.chart = addChart(this.parent, {
      title: report.labelOf(report.fields[field]) + (report.y ? `, for ${report.labelOf(report.y)}` : ''),
      height: CURVES_HEIGHT,
      padding: [null, report.y ? 58 : null, null, null],
      x: this.xOptions(),
      y: {label: report.labelOf(report.fields[field]), scale: {range: this.yRange()}},
      series: this.shownRows.map((row, k) => ({label: this.names[k], stroke: this.colours[k],
        ...this.colours.indexOf(this.colours[k]) < k ? dashesOf(k) : {},
        value: (u, v, s, i) => i === null || i === undefined ? '' : this.textAt(i, row)})),
      data: [this.positions, ...this.shownRows.map((row) => this.positions.map((_, i) => {
        const mean = this.meanAt(i, row);
        return mean ? mean.value : null;
      }))],
      draw: (u) => this.drawPoints(u),
    }, {onClick: (x, y) => this.choose(x, y), mark: () => this.positions[this.chosen.x]});
  }

  xOptions() {
    const {report, positions} = this;
    const first = positions[0];
    const last = positions[positions.length - 1];
    const margin = last > first ? 0.03 * (last - first) : 0.5;
    return {
      label: report.labelOf(report.x),
      scale: {range: () => [first - margin, last + margin]},
      axis: this.isNumeric ? {} : {splits: () => positions, values: (u, splits) => splits.map((k) => report.valueText(report.x, k))},
      series: {label: report.x.label, value: (u, v, s, i) => i === null || i === undefined ? '' : report.valueText(report.x, i, report.x.unit)},
    };
  }

  /** So that the error bars are within. */
  yRange() {
    const means = this.report.meansOf(this.field);
    return padded(...rangeOf(means.flatMap(({value, error}) => [value - error, value + error])));
  }

  meanAt(column, row) {
    const place = this.report.at(column, row);
    return place ? place.means[this.field] : null;
  }

  textAt(column, row) {
    const place = this.report.at(column, row);
    return !place ? 'not run' : this.report.meanText(place, this.field) +
      (this.report.isDoubtful(place, this.field) ? ' (not comparable)' : '');
  }

  /** The place nearest to a point of the chart: of those below and above it. */
  choose(x, y) {
    const nearest = (all, distance) => all.reduce((one, other) => distance(other) < distance(one) ? other : one);
    const column = nearest([...this.positions.keys()], (k) => Math.abs(this.positions[k] - x));
    const places = this.shownRows.map((row) => this.report.at(column, row)).filter((place) => place && place.means[this.field]);
    if (places.length) this.onChoose(nearest(places, (place) => Math.abs(place.means[this.field].value - y)));
  }

  drawPoints(u) {
    const {ctx} = u;
    const pixels = devicePixelRatio;
    ctx.save();
    ctx.lineWidth = 1.2 * pixels;
    const ends = [];
    this.shownRows.forEach((row, k) => {
      ctx.strokeStyle = this.colours[k];
      let end = null;
      this.positions.forEach((x, i) => {
        const mean = this.meanAt(i, row);
        if (!mean) return;
        const left = u.valToPos(x, 'x', true);
        const top = u.valToPos(mean.value, 'y', true);
        if (mean.error) {
          ctx.beginPath();
          ctx.moveTo(left, u.valToPos(mean.value - mean.error, 'y', true));
          ctx.lineTo(left, u.valToPos(mean.value + mean.error, 'y', true));
          ctx.stroke();
        }
        this.drawPoint(ctx, left, top, this.report.at(i, row), this.colours[k], pixels);
        end = top;
      });
      if (end !== null) ends.push({top: end, text: this.names[k], colour: this.colours[k]});
    });
    if (this.report.y) this.drawEnds(ctx, u.bbox.left + u.bbox.width + 6 * pixels, ends, pixels);
    ctx.restore();
  }

  /** Hollow where Q is not comparable, a star where it is best. */
  drawPoint(ctx, left, top, place, colour, pixels) {
    const isBest = this.report.isQuality(this.field) && this.report.isBest(place);
    ctx.fillStyle = this.report.isDoubtful(place, this.field) ? themeColour('--ground') : colour;
    if (isBest) return this.drawText(ctx, '\u2605\ufe0e', left, top, 22 * pixels, 'center');
    ctx.beginPath();
    ctx.arc(left, top, (place === this.chosen ? 2 : 1) * POINT * pixels, 0, 2 * Math.PI);
    ctx.fill();
    return ctx.stroke();
  }

  drawText(ctx, text, left, top, size, align) {
    ctx.font = `${size}px system-ui, sans-serif`;
    ctx.textAlign = align;
    ctx.textBaseline = 'middle';
    ctx.fillText(text, left, top);
  }

  /** The names of the curves at their ends, moved apart where two would touch. */
  drawEnds(ctx, left, ends, pixels) {
    ends.sort((a, b) => a.top - b.top);
    for (let round = 0; round < 100; ++round)
      for (let k = 0; k + 1 < ends.length; ++k) {
        const overlap = LABEL_HEIGHT * pixels - (ends[k + 1].top - ends[k].top);
        if (overlap <= 0) continue;
        ends[k].top -= 0.5 * overlap;
        ends[k + 1].top += 0.5 * overlap;
      }
    for (const {top, text, colour} of ends) {
      ctx.fillStyle = colour;
      ctx.fillRect(left, top - 4 * pixels, 8 * pixels, 8 * pixels);
      ctx.fillStyle = themeColour('--text');
      this.drawText(ctx, text, left + 12 * pixels, top, 12 * pixels, 'left');
    }
  }
}
