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
