const STRONGEST_ZOOM = 400;

/** The part of the world that the picture shows: pixels of the canvas, y downwards, and metres. */
class View {
  /** @param {{left: number, right: number, low: number, high: number}} whole the whole machine [m] */
  constructor(whole) {
    this.whole = whole;
    this.zoom = 1;
    this.centre = [0.5 * (whole.left + whole.right), 0.5 * (whole.low + whole.high)];
    this.width = 1;
    this.height = 1;
  }

  resize(width, height) {
    this.width = width;
    this.height = height;
  }

  /** Pixels per metre. */
  get scale() {
    return this.zoom * Math.min(this.width / (this.whole.right - this.whole.left),
      this.height / (this.whole.high - this.whole.low));
  }

  toPixel(x, y) {
    return {x: 0.5 * this.width + (x - this.centre[0]) * this.scale,
      y: 0.5 * this.height - (y - this.centre[1]) * this.scale};
  }

  toWorld(x, y) {
    return [this.centre[0] + (x - 0.5 * this.width) / this.scale, this.centre[1] - (y - 0.5 * this.height) / this.scale];
  }

  /** Zooms about a pixel, which stays where it is. */
  zoomBy(factor, x = 0.5 * this.width, y = 0.5 * this.height) {
    const before = this.toWorld(x, y);
    this.zoom = Math.min(STRONGEST_ZOOM, Math.max(0.5, this.zoom * factor));
    const after = this.toWorld(x, y);
    this.centre = [this.centre[0] + before[0] - after[0], this.centre[1] + before[1] - after[1]];
  }

  moveBy(x, y) {
    this.centre = [this.centre[0] - x / this.scale, this.centre[1] + y / this.scale];
  }

  showWhole() {
    this.zoom = 1;
    this.centre = [0.5 * (this.whole.left + this.whole.right), 0.5 * (this.whole.low + this.whole.high)];
  }
}
