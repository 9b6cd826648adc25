const BIN_WIDTH = 0.07;         // of the base's width
const LEAST_HEIGHT = 260;       // of the picture [pixels]
const LABEL_ROOM = 44;          // below the machine, for the labels of the bins [pixels]
const MOST_HEADROOM = 0.15;     // above the base, at most; what flies higher is out of the picture [widths of the base]
const MOST_TEETH = 60;          // that are shown at first
const LEAST_SHOWN = 1.5;        // diameter of the smallest disks at first [pixels]
const SMALLEST_ROUND = 1.3;     // radius of disks that are drawn round [pixels]
const SMALLEST_OUTLINED = 4;    // radius of disks with an outline and a mark that turns [pixels]
const PATH_TIME = 1.5;          // of a followed disk's path, before and after the present [s]
const PATH_STEP = 1 / 480;      // [s]
const STRONGEST_ZOOM = 400;

/**
 * Where the disks of each bin lie: in rows, in the order in which they came. In true size, or smaller where they would
 * not fit. @param {number} width of a bin, which is as high [m]
 */
function heapsOf(bins, species, width) {
  const orders = {left: bins.arrivals('left'), right: bins.arrivals('right')};
  for (let shrink = 1; ; shrink *= 0.9) {
    const heaps = {};
    for (const bin of ['left', 'right']) heaps[bin] = heapOf(orders[bin].map((k) => [k, shrink * species[k].radius]), width);
    if (Object.values(heaps).every((heap) => heap.height <= width) || shrink < 1e-3) return heaps;
  }
}

function heapOf(disks, width) {
  const heap = [];
  let x = 0, low = 0, high = 0;
  for (const [species, radius] of disks) {
    if (x + 2 * radius > width) [x, low] = [0, high];
    heap.push({species, radius, x: x + radius, y: low + radius});
    x += 2 * radius;
    high = Math.max(high, low + 2 * radius);
  }
  heap.height = high;
  return heap;
}

/** Of a length on the page, in those of the screen. */
function inPixels(length) { return Math.round(length * devicePixelRatio); }

/** The part of the world that the picture shows: pixels of the canvas, y downwards, and metres. */
class View {
  /** @param {{left: number, right: number, low: number, high: number}} whole the whole machine [m] */
  constructor(whole) {
    this.whole = whole;
    this.width = this.height = 1;
    this.insets = {left: 0, top: 0, right: 0, bottom: 0};  // covered by other things [pixels]
    this.showWhole();
    this.isFirst = true;  // not chosen by the user
  }

  /** The middle of what is not covered, and its size [pixels]. */
  get free() {
    const {left, top, right, bottom} = this.insets;
    const [width, height] = [Math.max(1, this.width - left - right), Math.max(1, this.height - top - bottom)];
    return {x: left + 0.5 * width, y: top + 0.5 * height, width, height};
  }

  /** Pixels per metre. */
  get scale() {
    const {width, height} = this.free;
    return this.zoom * Math.min(width / (this.whole.right - this.whole.left), height / (this.whole.high - this.whole.low));
  }

  toPixel(x, y) {
    const {free, scale} = this;
    return {x: free.x + (x - this.centre[0]) * scale, y: free.y - (y - this.centre[1]) * scale};
  }

  toWorld(x, y) {
    const {free, scale} = this;
    return [this.centre[0] + (x - free.x) / scale, this.centre[1] - (y - free.y) / scale];
  }

  /** Zooms about a pixel, which stays where it is. */
  zoomBy(factor, x = this.free.x, y = this.free.y) {
    this.isFirst = false;
    const before = this.toWorld(x, y);
    this.zoom = Math.min(STRONGEST_ZOOM, Math.max(0.5, this.zoom * factor));
    const after = this.toWorld(x, y);
    this.centre = [this.centre[0] + before[0] - after[0], this.centre[1] + before[1] - after[1]];
  }

  moveBy(x, y) {
    this.isFirst = false;
    this.centre = [this.centre[0] - x / this.scale, this.centre[1] + y / this.scale];
  }

  showWhole() {
    this.isFirst = false;
    this.zoom = 1;
    this.centre = [0.5 * (this.whole.left + this.whole.right), 0.5 * (this.whole.low + this.whole.high)];
  }
}

/** Draws the machine at a time. */
class Picture {
  constructor(canvas, base, motion, bins) {
    this.canvas = canvas;
    this.base = base;
    this.motion = motion;
    this.bins = bins;
    this.fillBins();
    this.view = new View(this.wholeMachine());
    this.followed = null;
    this.depth = base.lowest - 0.6 * Math.max(base.highest - base.lowest, 0.02 * base.toothWidth);
    this.body = new Path2D();
    for (const corner of [[0, this.depth], ...base.outline(), [base.width, this.depth]]) this.body.lineTo(...corner);
  }

  get binWidth() { return this.bins.areUsed ? BIN_WIDTH * this.base.width : 0; }

  /** Fits canvas and view to the room and the machine as they are now. @param {Object} insets what covers the canvas at its edges [pixels] */
  layout(insets) {
    const {canvas, view} = this;
    this.insets = insets;
    view.insets = {...insets, bottom: insets.bottom + (this.bins.areUsed ? LABEL_ROOM : 0)};
    view.whole = this.wholeMachine();
    const {left, right, low, high} = view.whole;
    const height = canvas.clientWidth * (high - low) / (right - left) + LABEL_ROOM;
    if (!canvas.matches('.filling'))
      canvas.style.height = `${Math.round(Math.min(0.6 * innerHeight, Math.max(LEAST_HEIGHT, height)))}px`;
    [view.width, view.height] = [canvas.clientWidth, canvas.clientHeight];
    [canvas.width, canvas.height] = [view.width, view.height].map(inPixels);
    if (view.isFirst) this.showFirst();
    else if (view.zoom === 1) view.showWhole();
  }

  fillBins() { this.heaps = this.bins.areUsed ? heapsOf(this.bins, this.base.machine.species, this.binWidth) : null; }

  /** All that the base sweeps over and the disks above it, in the world. */
  wholeMachine() {
    const base = this.base;
    const reach = Math.max(...base.states.amplitude, 0);
    const whole = {right: 0, low: -reach + base.lowest, high: reach + base.highest};
    for (const inclination of base.states.inclination) {
      const rise = base.width * Math.sin(inclination);
      whole.right = Math.max(whole.right, base.width * Math.cos(inclination));
      whole.low = Math.min(whole.low, rise - reach);
      whole.high = Math.max(whole.high, rise + reach + base.highest);
    }
    whole.high = Math.max(whole.high, Math.min(this.motion.top(), whole.high + MOST_HEADROOM * base.width));
    const margin = 0.01 * base.width;
    const beside = this.binWidth + margin;
    return {left: -beside, right: whole.right + beside, low: whole.low - beside, high: whole.high + 2 * margin};
  }

  /** The whole machine; of a longer one, or where disks would be points, its middle. */
  showFirst() {
    const {machine, width, highest, states} = this.base;
    this.view.showWhole();
    const smallest = Math.min(...machine.species.map(({radius}) => radius));
    const zoom = Math.max(machine.teeth / MOST_TEETH, LEAST_SHOWN / (2 * smallest * this.view.scale));
    if (zoom > 1) {
      this.view.zoomBy(zoom);
      const inclination = 0.5 * (Math.min(...states.inclination) + Math.max(...states.inclination));
      this.view.centre = [0.5 * width * Math.cos(inclination), 0.5 * width * Math.sin(inclination) + highest];
    }
    this.view.isFirst = true;
  }

  draw(time) {
    const {width, height, clientWidth, clientHeight} = this.canvas;
    if (width !== inPixels(clientWidth) || height !== inPixels(clientHeight)) this.layout(this.insets);
    const context = this.canvas.getContext('2d');
    const ratio = this.canvas.width / Math.max(1, clientWidth);
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.fillStyle = themeColour('--ground');
    context.fillRect(0, 0, this.view.width, this.view.height);
    if (this.followed !== null) this.centreOnFollowed(time);
    // From here on in metres from the middle of the view, y upwards: a canvas computes in single precision.
    const {scale, free, centre} = this.view;
    context.transform(scale, 0, 0, -scale, free.x, free.y);
    context.save();
    context.translate(-centre[0], -centre[1]);
    const pose = this.base.poseAt(time);
    if (this.bins.areUsed) this.drawBins(context, pose, time);
    this.drawBase(context, pose);
    if (this.followed !== null) this.drawPath(context, time);
    context.restore();
    this.drawDisks(context, time);
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    if (this.bins.areUsed) this.drawLabels(context, pose, time);
  }

  drawBase(context, {x, y, cosine, sine}) {
    context.save();
    context.transform(cosine, sine, -sine, cosine, x, y);
    context.fillStyle = context.strokeStyle = themeColour('--base');
    context.fill(this.body);
    if (this.base.machine.boundary === 'walled') {
      context.beginPath();
      for (const s of [0, this.base.width]) {
        context.moveTo(s, this.depth);
        context.lineTo(s, Math.min(this.base.machine.wall_height, this.base.width));
      }
      context.lineWidth = 3 / this.view.scale;
      context.stroke();
    }
    context.restore();
  }

  /** The lower left corner of a bin, at its end of the base [m]. */
  cornerOf(bin, pose) {
    const s = bin === 'left' ? 0 : this.base.width;
    return [pose.x + s * pose.cosine - (bin === 'left' ? this.binWidth : 0),
      pose.y + s * pose.sine + this.base.lowest - this.binWidth];
  }

  /** Both bins, with the disks that they hold in the order in which they came. */
  drawBins(context, pose, time) {
    const width = this.binWidth;
    for (const bin of ['left', 'right']) {
      const [left, low] = this.cornerOf(bin, pose);
      context.fillStyle = themeColour('--bin');
      context.fillRect(left, low, width, width);
      const paths = this.base.machine.species.map(() => new Path2D());
      for (const disk of this.heaps[bin].slice(0, this.bins.total(bin, time)))
        this.addDisk(paths[disk.species], left + disk.x, low + disk.y, disk.radius);
      this.fillDisks(context, paths);
    }
  }

  /** What each bin holds: below it; above it where it stands too low; in the corner where it is out of the picture. */
  drawLabels(context, pose, time) {
    context.font = '600 13px system-ui, sans-serif';
    context.textAlign = 'center';
    context.lineWidth = 4;
    context.strokeStyle = themeColour('--ground');
    for (const bin of ['left', 'right']) {
      const [left, low] = this.cornerOf(bin, pose);
      const lines = this.bins.labelOf(bin, time, this.base.machine.species);
      const half = 0.5 * Math.max(...lines.map(({text}) => context.measureText(text).width)) + 4;
      const {x, y} = this.view.toPixel(left + 0.5 * this.binWidth, low);
      const {free, scale} = this.view;
      const isOut = x < 0 || x > this.view.width;
      const above = y > free.y + 0.5 * free.height ? scale * this.binWidth + LABEL_ROOM : 0;
      const [middle, top] = [[x, free.x, 0.5 * free.width - half], [isOut ? Infinity : y - above, free.y, 0.5 * free.height]]
        .map(([at, centre, reach]) => Math.min(centre + reach, Math.max(centre - reach, at)));
      lines.forEach(({text, species}, k) => {
        context.fillStyle = species === null ? themeColour('--text') : colourOf(species);
        context.strokeText(text, middle, top + 17 * (k + 1));
        context.fillText(text, middle, top + 17 * (k + 1));
      });
    }
  }

  drawDisks(context, time) {
    const bodies = this.base.machine.species.map(() => new Path2D());
    const marks = new Path2D();
    const {scale, centre} = this.view;
    const [fromX, toY] = this.view.toWorld(0, 0);
    const [toX, fromY] = this.view.toWorld(this.view.width, this.view.height);
    this.motion.forEachAt(time, (track, worldX, worldY, angle) => {
      const radius = this.motion.radii[track];
      if (worldX < fromX - radius || worldX > toX + radius || worldY < fromY - radius || worldY > toY + radius) return;
      const x = worldX - centre[0];
      const y = worldY - centre[1];
      this.addDisk(bodies[this.motion.species[track]], x, y, radius);
      if (radius * scale < SMALLEST_OUTLINED) return;
      marks.moveTo(x + 0.35 * radius * Math.cos(angle), y + 0.35 * radius * Math.sin(angle));
      marks.lineTo(x + 0.85 * radius * Math.cos(angle), y + 0.85 * radius * Math.sin(angle));
    });
    this.fillDisks(context, bodies);
    context.strokeStyle = '#ffffff';
    context.lineWidth = 1.5 / scale;
    context.stroke(marks);
  }

  addDisk(path, x, y, radius) {
    if (radius * this.view.scale < SMALLEST_ROUND) return path.rect(x - radius, y - radius, 2 * radius, 2 * radius);
    path.moveTo(x + radius, y);
    return path.arc(x, y, radius, 0, 2 * Math.PI);
  }

  /** @param {Array<Path2D>} paths of each species */
  fillDisks(context, paths) {
    context.lineWidth = 2 / this.view.scale;
    paths.forEach((path, species) => {
      context.fillStyle = isRepeated(species) ? themeColour('--ground') : colourOf(species);
      context.fill(path);
      context.strokeStyle = colourOf(species);
      if (isRepeated(species)) context.stroke(path);
    });
  }

  centreOnFollowed(time) {
    const disk = this.diskAt(time, this.followed);
    if (disk && this.view.zoom > 1.5) this.view.centre = [disk.x, disk.y];
  }

  /** The path of the followed disk, up to now and from now on, and a ring about it. */
  drawPath(context, time) {
    const track = this.motion.trackOf(this.followed, time);
    if (track < 0) return;
    context.strokeStyle = themeColour('--accent');
    for (const [from, to, width, opacity] of [[time - PATH_TIME, time, 1.6, 0.9], [time, time + PATH_TIME, 1, 0.5]]) {
      context.beginPath();
      let before = null;
      for (const [x, y] of this.motion.pathOf(track, from, to, PATH_STEP)) {
        // A periodic base carries the disk from one end to the other.
        if (before !== null && Math.abs(x - before) < 0.5 * this.base.width) context.lineTo(x, y);
        else context.moveTo(x, y);
        before = x;
      }
      context.globalAlpha = opacity;
      context.lineWidth = width / this.view.scale;
      context.stroke();
      context.globalAlpha = 1;
    }
    const disk = this.diskAt(time, this.followed);
    if (!disk) return;
    context.beginPath();
    context.arc(disk.x, disk.y, disk.radius + 4 / this.view.scale, 0, 2 * Math.PI);
    context.lineWidth = 2 / this.view.scale;
    context.stroke();
  }

  /** The disks at a time, as drawn. */
  disksAt(time) {
    const disks = [];
    this.motion.forEachAt(time, (track, x, y, angle) => disks.push({id: this.motion.ids[track],
      species: this.motion.species[track], x, y, radius: this.motion.radii[track], angle}));
    return disks;
  }

  diskAt(time, id) { return this.disksAt(time).find((disk) => disk.id === id) || null; }

  /** The disk at a pixel, or near it; null: there is none. */
  diskNear(time, x, y) {
    let nearest = null;
    let least = Infinity;
    for (const disk of this.disksAt(time)) {
      const pixel = this.view.toPixel(disk.x, disk.y);
      const beyond = Math.hypot(pixel.x - x, pixel.y - y) - disk.radius * this.view.scale;
      if (beyond < least) [nearest, least] = [disk, beyond];
    }
    return least < 8 ? nearest : null;
  }
}
