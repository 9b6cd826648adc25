// Colours at equal distances on matplotlib's scales, which have even steps and which the colour-blind can read.
const VIRIDIS = ['#440154', '#481f70', '#443983', '#3b528b', '#31688e', '#287c8e', '#21918c', '#20a486', '#35b779', '#5ec962',
  '#90d743', '#c8e020', '#fde725'];
const RED_BLUE = ['#053061', '#1c5c9f', '#3783bb', '#6bacd1', '#a7d0e4', '#d7e8f1', '#f7f6f6', '#fcdfcf', '#f7b799', '#e48066',
  '#c94741', '#a51429', '#67001f'];

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
    this.low = values.reduce((least, value) => Math.min(least, value), Infinity);
    this.high = values.reduce((most, value) => Math.max(most, value), -Infinity);
    this.isSigned = this.low < 0 && this.high > 0;
    if (this.isSigned) {
      this.high = Math.max(-this.low, this.high);
      this.low = -this.high;
    }
    this.colours = this.isSigned ? RED_BLUE : VIRIDIS;
  }

  share(value) {
    return this.high > this.low ? (value - this.low) / (this.high - this.low) : 0.5;
  }

  colourOf(value) {
    return scaleColour(this.colours, this.share(value));
  }
}

/** Colours of so many curves: in the order of numbers, side by side for texts. */
function curveColours(values) {
  if (values.length === 1 || values.some((value) => typeof value !== 'number')) return values.map((_, k) => colourOf(k));
  // The ends of the scale that can be seen on the ground.
  const [from, to] = matchMedia('screen and (prefers-color-scheme: dark)').matches ? [0.3, 1] : [0, 0.8];
  return values.map((_, k) => scaleColour(VIRIDIS, from + (to - from) * k / (values.length - 1)));
}

const MAP_FONT = '13px system-ui, sans-serif';
const BAR_HEIGHT = 12;   // of the colour scale [px]
const DIGITS = 3;        // of the values beside the cells
const LINE_HEIGHT = 18;  // of text [px]
const MAP_HEIGHTS = [150, 440];  // of the cells, at least and at most [px]

/** The outline of a star. */
function starPath(ctx, x, y, radius) {
  for (let k = 0; k < 10; ++k) {
    const [angle, length] = [Math.PI * (k / 5 - 0.5), k % 2 ? 0.45 * radius : radius];
    ctx.lineTo(x + length * Math.cos(angle), y + length * Math.sin(angle));
  }
  ctx.closePath();
}

/** The means of a field over x and y, on a canvas. */
class SweepMap {
  /** @param {function(Object)} onChoose takes a place */
  constructor(canvas, tip, report, onChoose) {
    this.canvas = canvas;
    this.tip = tip;
    this.report = report;
    this.field = 0;
    this.chosen = report.first;
    canvas.addEventListener('pointermove', (event) => this.showTip(event));
    canvas.addEventListener('pointerleave', () => { this.tip.hidden = true; });
    canvas.addEventListener('click', (event) => {
      const place = this.placeAt(event.offsetX, event.offsetY);
      if (place) onChoose(place);
    });
  }

  show(field, chosen) {
    this.field = field;
    this.chosen = chosen;
    this.draw();
  }

  /** The size of the canvas and of its parts. */
  layOut() {
    const {report, canvas} = this;
    const ctx = canvas.getContext('2d');
    ctx.font = MAP_FONT;
    const widest = (axis) => axis.values.reduce((width, _, k) =>
      Math.max(width, ctx.measureText(report.valueText(axis, k, '', DIGITS)).width), 0);
    this.labelWidths = [Math.min(160, widest(report.x)), Math.min(110, widest(report.y))];
    this.left = Math.ceil(this.labelWidths[1]) + 10;
    this.top = LINE_HEIGHT + 4;
    const width = Math.max(200, canvas.clientWidth);
    this.cellWidth = (width - this.left - 8) / report.columns;
    this.cellHeight = Math.min(MAP_HEIGHTS[1], Math.max(MAP_HEIGHTS[0], this.cellWidth * report.rows)) / report.rows;
    this.bottom = this.top + this.cellHeight * report.rows;
    const height = this.bottom + 4.8 * LINE_HEIGHT + BAR_HEIGHT + 8;
    canvas.style.height = height + 'px';
    canvas.width = Math.round(width * devicePixelRatio);
    canvas.height = Math.round(height * devicePixelRatio);
    ctx.setTransform(devicePixelRatio, 0, 0, devicePixelRatio, 0, 0);
    ctx.font = MAP_FONT;
    return ctx;
  }

  draw() {
    const ctx = this.layOut();
    this.colours = Object.fromEntries(['ground', 'quiet', 'line', 'accent'].map((name) => [name, themeColour('--' + name)]));
    this.drawCells(ctx);
    this.drawFrame(ctx, this.chosen, this.colours.ground, 5);
    this.drawFrame(ctx, this.chosen, this.colours.accent, 3);
    const {best} = this.report.data;
    if (best && this.report.fields[this.field].name === 'quality') this.drawStar(ctx, best);
    this.drawLabels(ctx);
    if (this.scale) this.drawScale(ctx);
    const field = this.report.fields[this.field];
    this.canvas.setAttribute('aria-label', `Map of ${field.label} over ${this.report.x.label} and ${this.report.y.label}`);
  }

  /** The cells are kept as a picture until it would change. */
  drawCells(ctx) {
    const {canvas} = this;
    const state = [this.field, canvas.width, canvas.height, devicePixelRatio, this.colours.ground].join(' ');
    if (state !== this.cellsState) {
      const means = this.report.meansOf(this.field);
      this.scale = means.length ? new ColourScale(means.map((mean) => mean.value)) : null;
      this.cells = element('canvas', {width: canvas.width, height: canvas.height});
      const layer = this.cells.getContext('2d');
      layer.scale(devicePixelRatio, devicePixelRatio);
      layer.font = MAP_FONT;
      for (const place of this.report.places) this.drawCell(layer, place);
      this.cellsState = state;
    }
    ctx.drawImage(this.cells, 0, 0, canvas.width / devicePixelRatio, canvas.height / devicePixelRatio);
  }

  /** Left, top, width and height. */
  boxOf(place) {
    return [this.left + place.x * this.cellWidth, this.bottom - (place.y + 1) * this.cellHeight, this.cellWidth, this.cellHeight];
  }

  /** The middle of a cell [px of the canvas]. */
  toPixel(column, row) {
    const [left, top, width, height] = this.boxOf({x: column, y: row});
    return {x: left + 0.5 * width, y: top + 0.5 * height};
  }

  placeAt(x, y) {
    return this.report.at(Math.floor((x - this.left) / this.cellWidth), Math.floor((this.bottom - y) / this.cellHeight));
  }

  drawCell(ctx, place) {
    const mean = place.means[this.field];
    const box = this.boxOf(place);
    if (!mean) {
      ctx.strokeStyle = this.colours.line;
      ctx.lineWidth = 1;
      ctx.strokeRect(...box);
      ctx.fillStyle = this.colours.quiet;
      ctx.textAlign = 'center';
      ctx.textBaseline = 'middle';
      ctx.fillText('\u00d7', box[0] + 0.5 * box[2], box[1] + 0.5 * box[3]);
      return;
    }
    ctx.fillStyle = this.scale.colourOf(mean.value);
    // To whole pixels of the screen, so that no gap is seen between cells.
    const [left, right, top, bottom] = [box[0], box[0] + box[2], box[1], box[1] + box[3]]
      .map((each) => Math.round(each * devicePixelRatio) / devicePixelRatio);
    ctx.fillRect(left, top, right - left, bottom - top);
    if (this.report.isDoubtful(place, this.field)) this.hatch(ctx, left, top, right - left, bottom - top);
  }

  hatch(ctx, left, top, width, height) {
    ctx.save();
    ctx.beginPath();
    ctx.rect(left, top, width, height);
    ctx.clip();
    ctx.globalAlpha = 0.6;
    ctx.fillStyle = this.colours.ground;
    ctx.fillRect(left, top, width, height);
    ctx.globalAlpha = 1;
    ctx.strokeStyle = this.colours.quiet;
    ctx.lineWidth = 1;
    ctx.beginPath();
    // On one grid for all cells: x + y is a multiple of the distance.
    for (let sum = 7 * Math.ceil((left + top) / 7); sum < left + top + width + height; sum += 7) {
      ctx.moveTo(sum - top, top);
      ctx.lineTo(sum - top - height, top + height);
    }
    ctx.stroke();
    ctx.restore();
  }

  drawFrame(ctx, place, colour, width) {
    const [left, top, w, h] = this.boxOf(place);
    ctx.strokeStyle = colour;
    ctx.lineWidth = width;
    ctx.strokeRect(left - 1, top - 1, w + 2, h + 2);
  }

  drawStar(ctx, best) {
    const {x, y} = this.toPixel(best.x, best.y);
    ctx.beginPath();
    starPath(ctx, x, y, 9);
    ctx.fillStyle = '#ffffff';
    ctx.strokeStyle = '#000000';
    ctx.lineWidth = 1.2;
    ctx.fill();
    ctx.stroke();
  }

  /** Values beside the cells, as many as there is room for. */
  drawLabels(ctx) {
    const {report} = this;
    ctx.fillStyle = this.colours.quiet;
    ctx.textAlign = 'center';
    ctx.textBaseline = 'top';
    const everyColumn = Math.ceil((this.labelWidths[0] + 12) / this.cellWidth);
    for (let k = 0; k < report.columns; k += everyColumn)
      ctx.fillText(report.valueText(report.x, k, '', DIGITS), this.left + (k + 0.5) * this.cellWidth, this.bottom + 4, 160);
    ctx.fillText(report.labelOf(report.x), this.left + 0.5 * this.cellWidth * report.columns, this.bottom + 4 + LINE_HEIGHT);
    ctx.textAlign = 'right';
    ctx.textBaseline = 'middle';
    const everyRow = Math.ceil(LINE_HEIGHT / this.cellHeight);
    for (let k = 0; k < report.rows; k += everyRow)
      ctx.fillText(report.valueText(report.y, k, '', DIGITS), this.left - 6, this.bottom - (k + 0.5) * this.cellHeight, 110);
    ctx.textAlign = 'left';
    ctx.textBaseline = 'top';
    ctx.fillText(report.labelOf(report.y), 0, 0);
  }

  drawScale(ctx) {
    const {scale, report} = this;
    const top = this.bottom + 3.3 * LINE_HEIGHT;
    const width = Math.min(360, this.cellWidth * report.columns);
    const gradient = ctx.createLinearGradient(this.left, 0, this.left + width, 0);
    scale.colours.forEach((colour, k) => gradient.addColorStop(k / (scale.colours.length - 1), colour));
    ctx.fillStyle = gradient;
    ctx.fillRect(this.left, top, width, BAR_HEIGHT);
    ctx.fillStyle = this.colours.quiet;
    ctx.textBaseline = 'bottom';
    ctx.textAlign = 'left';
    ctx.fillText(report.labelOf(report.fields[this.field]), this.left, top - 8);
    ctx.textBaseline = 'top';
    ctx.fillText(quantity(scale.low, '', 3), this.left, top + BAR_HEIGHT + 3);
    ctx.textAlign = 'right';
    ctx.fillText(quantity(scale.high, '', 3), this.left + width, top + BAR_HEIGHT + 3);
    ctx.textAlign = 'center';
    ctx.fillText(quantity(0.5 * (scale.low + scale.high), '', 3), this.left + 0.5 * width, top + BAR_HEIGHT + 3);
    const mean = this.chosen.means[this.field];
    if (mean) this.drawPointer(ctx, this.left + width * scale.share(mean.value), top);
  }

  /** A triangle above the chosen value. */
  drawPointer(ctx, x, top) {
    ctx.fillStyle = this.colours.accent;
    ctx.beginPath();
    ctx.moveTo(x, top + 2);
    ctx.lineTo(x - 5, top - 6);
    ctx.lineTo(x + 5, top - 6);
    ctx.fill();
  }

  showTip(event) {
    const place = this.placeAt(event.offsetX, event.offsetY);
    this.tip.hidden = !place;
    if (!place) return;
    const {report, field} = this;
    this.tip.textContent = `${report.settingText(place)}\n${report.fields[field].label}: ${report.meanText(place, field)}\n` +
      report.remarks(place, field) + (report.isBest(place) ? '\nbest setting' : '');
    const left = Math.min(event.offsetX + 14, this.canvas.clientWidth - this.tip.offsetWidth);
    this.tip.style.left = Math.max(0, left) + 'px';
    this.tip.style.top = event.offsetY + 16 + 'px';
  }
}
