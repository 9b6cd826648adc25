// Colours at equal distances on matplotlib's scales, which have even steps and which the colour-blind can read.
const VIRIDIS = ['#440154', '#481f70', '#443983', '#3b528b', '#31688e', '#287c8e', '#21918c', '#20a486', '#35b779', '#5ec962',
  '#90d743', '#c8e020', '#fde725'];
const RED_BLUE = ['#1c5c9f', '#3783bb', '#6bacd1', '#a7d0e4', '#d7e8f1', '#f7f6f6', '#fcdfcf', '#f7b799', '#e48066',
  '#c94741', '#a51429'];

/** A colour of a scale. @param {number} share from 0 to 1 */
function scaleColour(scale, share) {
  const place = Math.min(1, Math.max(0, share)) * (scale.length - 1);
  const k = Math.min(scale.length - 2, Math.floor(place));
  const channels = [1, 3, 5].map((at) => {
    const [from, to] = [scale[k], scale[k + 1]].map((colour) => parseInt(colour.slice(at, at + 2), 16));
    return Math.round(from + (place - k) * (to - from));
  });
  return `rgb(${channels.join(', ')})`;
}

/** Colours of numbers; around zero where they have both signs. */
class ColourScale {
  /** @param {Array<number>} values at least one */
  constructor(values) {
    [this.low, this.high] = rangeOf(values);
    const isSigned = this.low < 0 && this.high > 0;
    if (isSigned) {
      this.high = Math.max(-this.low, this.high);
      this.low = -this.high;
    }
    this.colours = isSigned ? RED_BLUE : this.high > 0 ? VIRIDIS : VIRIDIS.toReversed();
  }

  share(value) { return this.high > this.low ? (value - this.low) / (this.high - this.low) : 0.5; }

  colourOf(value) { return scaleColour(this.colours, this.share(value)); }
}

/** Colours of so many curves: in the order of numbers, side by side for texts. */
function curveColours(values) {
  if (values.length === 1 || values.some((value) => typeof value !== 'number')) return values.map((_, k) => colourOf(k));
  // The ends of the scale that can be seen on the ground.
  const [from, to] = matchMedia('screen and (prefers-color-scheme: dark)').matches ? [0.4, 1] : [0, 0.65];
  return values.map((_, k) => scaleColour(VIRIDIS, from + (to - from) * k / (values.length - 1)));
}

const DIGITS = 3;        // of the values beside the cells
const LETTER = [8, 18];  // of such a value, wide and high [px]
const MAP_HEIGHTS = [150, 440];  // of the cells, at least and at most [px]

/** The means of a field over x and y: a grid of cells, which the style sheet draws. */
class SweepMap {
  /** @param {function(Object)} onChoose takes a place */
  constructor(map, tip, report, onChoose) {
    [this.map, this.tip, this.report] = [map, tip, report];
    const placeAt = ({target}) => this.places.get(target);
    map.addEventListener('pointermove', (event) => this.showTip(placeAt(event), event));
    map.addEventListener('pointerleave', () => { tip.hidden = true; });
    map.addEventListener('click', (event) => {
      if (placeAt(event)) onChoose(placeAt(event));
    });
    this.places = new Map(report.places.map((place) => [this.add('cell', place.x, place.y), place]));
    const texts = (axis) => axis.values.map((_, k) => report.valueText(axis, k, '', DIGITS));
    this.columnLabels = texts(report.x).map((text, k) => this.add('label', k, -1, text));
    this.rowLabels = texts(report.y).map((text, k) => this.add('label', -1, k, text));
    byId('map-x').textContent = report.labelOf(report.x);
    byId('map-y').textContent = report.labelOf(report.y);
    this.resize();
  }

  /** A part in a column and a row of the map; -1: beside the cells. */
  add(kind, column, row, text = '') {
    const part = element('div', {class: kind}, text);
    part.style.gridArea = `${this.report.rows - row} / ${column + 2}`;
    this.map.append(part);
    return part;
  }

  /** As many values beside the cells as there is room for. */
  resize() {
    const {map, report} = this;
    const width = map.clientWidth / report.columns;
    const height = Math.min(MAP_HEIGHTS[1], Math.max(MAP_HEIGHTS[0], width * report.rows)) / report.rows;
    map.style.gridTemplate = `repeat(${report.rows}, ${height}px) auto / auto repeat(${report.columns}, minmax(0, 1fr))`;
    const longest = Math.max(...this.columnLabels.map((label) => label.textContent.length));
    const showEvery = (step, labels) => labels.forEach((label, k) => { label.hidden = k % step !== 0; });
    showEvery(Math.ceil(LETTER[0] * (longest + 2) / width), this.columnLabels);
    showEvery(Math.ceil(LETTER[1] / height), this.rowLabels);
  }

  show(field, chosen) {
    if (field !== this.field) this.showField(field);
    for (const [cell, place] of this.places) cell.classList.toggle('chosen', place === chosen);
    const mean = chosen.means[field];
    byId('pointer').hidden = !mean;
    if (mean) byId('pointer').style.left = 100 * this.scale.share(mean.value) + '%';
  }

  showField(field) {
    const {report} = this;
    this.field = field;
    const means = report.meansOf(field);
    this.scale = means.length ? new ColourScale(means.map((mean) => mean.value)) : null;
    const isQuality = report.isQuality(field);
    for (const [cell, place] of this.places) {
      const mean = place.means[field];
      cell.style.backgroundColor = mean ? this.scale.colourOf(mean.value) : '';
      cell.classList.toggle('crossed', !mean);
      cell.classList.toggle('hatched', report.isDoubtful(place, field));
      cell.classList.toggle('best', isQuality && report.isBest(place));
    }
    this.map.setAttribute('aria-label', `Map of ${report.fields[field].label} over ${report.x.label} and ${report.y.label}`);
    byId('scale').hidden = !this.scale;
    if (this.scale) this.showScale(report.labelOf(report.fields[field]));
  }

  showScale(label) {
    const {low, high, colours} = this.scale;
    byId('scale-label').textContent = label;
    byId('bar').style.background = `linear-gradient(to right, ${colours.join(', ')})`;
    byId('scale-values').replaceChildren(...[low, 0.5 * (low + high), high].map((value) => element('span', {}, quantity(value, '', 3))));
  }

  showTip(place, {clientX, clientY}) {
    this.tip.hidden = !place;
    if (!place) return;
    const {report, field} = this;
    this.tip.textContent = `${report.settingText(place)}\n${report.fields[field].label}: ${report.meanText(place, field)}\n` +
      report.remarks(place, field) + (report.isBest(place) ? '\nbest setting' : '');
    const {left, top, width} = this.map.getBoundingClientRect();
    this.tip.style.left = Math.max(0, Math.min(clientX - left + 14, width - this.tip.offsetWidth)) + 'px';
    this.tip.style.top = clientY - top + 16 + 'px';
  }
}
