/** Longest free flight that is shown before a frame and after it, where disks met something in between [s]. */
const LONGEST_ARC = 1 / 240;

/** Between frames that are farther apart disks go straight on in the frame of the base: more would be made up [s]. */
const LONGEST_FLIGHT = 1 / 29;

/** Of so many heights the picture's top is taken. */
const MOST_HEIGHTS = 1e5;

/** Differences of this many units of positions are rounding. */
const ROUNDING = 4;

/** Reads columns of integers, one after the other: src/page/motion.h. */
class ColumnReader {
  constructor(bytes) { this.bytes = bytes; }

  /** @return {Int32Array} the next column, of so many rows */
  next(rows) {
    const column = new Int32Array(rows);
    const [a, b, c, d] = [0, 1, 2, 3].map((k) => this.bytes.subarray(k * rows, (k + 1) * rows));
    for (let k = 0; k < rows; ++k) {
      const number = a[k] | b[k] << 8 | c[k] << 16 | d[k] << 24;
      column[k] = (number >>> 1) ^ -(number & 1);
    }
    this.bytes = this.bytes.subarray(4 * rows);
    return column;
  }
}

/**
 * The disks over time. Positions in the world frame [m].
 *
 * Between two frames a disk flies on parabolas: one on from the earlier frame, one back from the later one. They meet
 * where it had one contact. Where it had more, a third parabola joins them, so that the path fits both frames. Frames
 * far apart are joined by straight lines.
 */
class Motion {
  /**
   * @param {Object} description @param {Uint8Array} bytes see MotionRecord @param {Base} base
   * @param {Array<number>} span the first and the last time of the run, for one without recorded disks
   */
  constructor(description, bytes, base, span) {
    this.base = base;
    this.gravity = base.machine.gravity;
    this.resolution = 2 * description.position_unit;
    this.meets = ROUNDING * description.position_unit;
    this.times = new Float64Array(bytes.buffer, 0, description.frames);
    this.readTracks(new ColumnReader(bytes.subarray(this.times.byteLength)), description);
    if (!this.times.length) this.times = Float64Array.from(span);
    this.listTracksOfFrames();
  }

  readTracks(columns, description) {
    const {tracks, states} = description;
    const next = (count, rows) => Array.from({length: count}, () => columns.next(rows));
    [this.ids, this.species, this.radii, this.firstFrames, this.lengths] = next(5, tracks);
    this.starts = new Int32Array(tracks);  // of a track's states
    for (let k = 1; k < tracks; ++k) this.starts[k] = this.starts[k - 1] + this.lengths[k - 1];
    const [vx, vy, x, y, spin, angle] = next(6, states);
    this.forEachState((track, k, frame) => {
      if (k === this.starts[track]) return;
      const factor = (this.times[frame] - this.times[frame - 1]) * description.positions_per_velocity;
      x[k] += x[k - 1] + Math.floor(0.5 * (vx[k] + vx[k - 1]) * factor + 0.5);
      y[k] += y[k - 1] + Math.floor(0.5 * (vy[k] + vy[k - 1]) * factor + 0.5);
      angle[k] += angle[k - 1];
    });
    const scaled = (column, unit) => {
      const values = new Float32Array(column.length);  // from() would take ten times as long
      for (let k = 0; k < values.length; ++k) values[k] = column[k] * unit;
      return values;
    };
    this.radii = Float64Array.from(this.radii, (radius) => radius * description.radius_unit);
    this.x = scaled(x, description.position_unit);
    this.y = scaled(y, description.position_unit);
    this.vx = scaled(vx, description.velocity_unit);
    this.vy = scaled(vy, description.velocity_unit);
    this.spin = scaled(spin, description.spin_unit);
    this.angle = scaled(angle, 2 * Math.PI / description.angle_steps);
  }

  /** Calls back with each state, track by track: its track, its number and its frame. */
  forEachState(action) {
    for (let track = 0; track < this.ids.length; ++track)
      for (let i = 0; i < this.lengths[track]; ++i) action(track, this.starts[track] + i, this.firstFrames[track] + i);
  }

  /** Tracks by frame: those of frame k are listed from frameStarts[k] on. */
  listTracksOfFrames() {
    this.frameStarts = new Int32Array(this.times.length + 1);
    this.forEachState((track, k, frame) => { ++this.frameStarts[frame + 1]; });
    for (let k = 0; k < this.times.length; ++k) this.frameStarts[k + 1] += this.frameStarts[k];
    const next = this.frameStarts.slice();
    this.tracksOfFrames = new Int32Array(this.x.length);
    this.forEachState((track, k, frame) => { this.tracksOfFrames[next[frame]++] = track; });
  }

  /** When to open the page: at the start or, in a machine that is only fed, once it is half full. */
  get opening() {
    const counts = Array.from(this.times, (time, k) => this.frameStarts[k + 1] - this.frameStarts[k]);
    const most = counts.reduce((a, b) => Math.max(a, b), 0);
    return this.times[counts[0] ? 0 : counts.findIndex((count) => 2 * count >= most)];
  }

  /** The place of the last frame that is not after a time. */
  frameAt(time) { return Math.max(0, lastNotAbove(this.times, time)); }

  /**
   * Calls back with each disk at a time: its track, x, y and angle.
   * @param {function(number, number, number, number)} action
   */
  forEachAt(time, action) {
    const frame = this.frameAt(time);
    const pose = this.base.poseAt(time);
    const place = {x: 0, y: 0, angle: 0};
    for (let k = this.frameStarts[frame]; k < this.frameStarts[frame + 1]; ++k)
      if (this.placeAt(this.tracksOfFrames[k], frame, time, pose, place))
        action(this.tracksOfFrames[k], place.x, place.y, place.angle);
  }

  /** Where the disk of a track is at a time from this frame on. @return {boolean} whether it is in the machine */
  placeAt(track, frame, time, pose, place) {
    const i = this.starts[track] + frame - this.firstFrames[track];
    const elapsed = time - this.times[frame];
    const goesOn = frame + 1 < this.firstFrames[track] + this.lengths[track];
    const span = goesOn ? this.times[frame + 1] - this.times[frame] : 0;
    if (elapsed > 0 && span > LONGEST_FLIGHT) this.slide(i, frame, elapsed, span, pose, place);
    else if (elapsed > 0 && goesOn) this.fly(i, elapsed, span, pose, place);
    else this.flyOn(i, elapsed, place);
    return this.keepInMachine(this.radii[track], pose, place, goesOn || elapsed === 0);
  }

  /** The free flight from a state on. */
  flyOn(i, elapsed, place) {
    place.x = this.x[i] + this.vx[i] * elapsed;
    place.y = this.y[i] + (this.vy[i] - 0.5 * this.gravity * elapsed) * elapsed;
    place.angle = this.angle[i] + this.spin[i] * elapsed;
  }

  /** Between a state and the next one. In a frame that falls, free flights are straight lines. */
  fly(i, elapsed, span, pose, place) {
    const g = this.gravity;
    const x0 = this.x[i], y0 = this.y[i], u0 = this.vx[i], v0 = this.vy[i];
    const u1 = this.vx[i + 1], v1 = this.vy[i + 1] + g * span;
    let x1 = this.x[i + 1], y1 = this.y[i + 1] + 0.5 * g * span * span;
    if (this.base.isPeriodic) {
      // The image of the later position that is nearest to where the disk goes.
      const dx = x0 + 0.5 * (u0 + u1) * span - x1, dy = y0 + 0.5 * (v0 + v1) * span - y1;
      const way = this.base.width * Math.round((dx * pose.cosine + dy * pose.sine) / this.base.width);
      x1 += way * pose.cosine;
      y1 += way * pose.sine;
    }
    // The gap between both lines is gapX + closeX t at the time t.
    const gapX = x0 - (x1 - u1 * span), closeX = u0 - u1;
    const gapY = y0 - (y1 - v1 * span), closeY = v0 - v1;
    const close2 = closeX * closeX + closeY * closeY;
    const contact = close2 > 0 ? Math.min(span, Math.max(0, -(gapX * closeX + gapY * closeY) / close2)) : 0.5 * span;
    const missX = gapX + closeX * contact, missY = gapY + closeY * contact;
    const meet = missX * missX + missY * missY <= this.meets * this.meets;
    const arc = Math.min(LONGEST_ARC, span / 3);
    const leaves = meet ? contact : arc, arrives = meet ? contact : span - arc;
    // From the first line over to the second one; where they meet, at a point half-way between them.
    const half = meet ? 0.5 : 0;
    const startX = x0 + u0 * leaves - half * missX, startY = y0 + v0 * leaves - half * missY;
    const endX = meet ? startX : x1 - u1 * arc, endY = meet ? startY : y1 - v1 * arc;
    const [since, until, fromX, fromY, toX, toY] = elapsed <= leaves ? [0, leaves, x0, y0, startX, startY]
      : elapsed < arrives ? [leaves, arrives, startX, startY, endX, endY] : [arrives, span, endX, endY, x1, y1];
    const part = until > since ? (elapsed - since) / (until - since) : 1;
    place.x = fromX + (toX - fromX) * part;
    place.y = fromY + (toY - fromY) * part - 0.5 * g * elapsed * elapsed;
    this.turn(i, elapsed, span, 0.5 * (leaves + arrives), place);
  }

  /** Straight on from a state to the next one, as seen from the base. */
  slide(i, frame, elapsed, span, pose, place) {
    const [s0, n0] = Base.seenFrom(this.base.poseAt(this.times[frame]), this.x[i], this.y[i]);
    const [s1, n1] = Base.seenFrom(this.base.poseAt(this.times[frame + 1]), this.x[i + 1], this.y[i + 1]);
    const part = elapsed / span;
    const {width} = this.base;
    const way = this.base.isPeriodic ? s1 - s0 - width * Math.round((s1 - s0) / width) : s1 - s0;
    [place.x, place.y] = Base.inWorld(pose, s0 + way * part, n0 + (n1 - n0) * part);
    this.turn(i, elapsed, span, 0.5 * span, place);
  }

  /** The spin changes at the contact; what is left over to the next angle is spread over the time. */
  turn(i, elapsed, span, contact, place) {
    const after = (t) => this.spin[i] * Math.min(t, contact) + this.spin[i + 1] * Math.max(0, t - contact);
    const turn = 2 * Math.PI;
    let rest = (this.angle[i + 1] - this.angle[i] - after(span)) % turn;
    rest -= turn * Math.round(rest / turn);
    place.angle = this.angle[i] + after(elapsed) + rest * elapsed / span;
  }

  /** Moves a disk out of the base and, on a periodic one, into it. @return {boolean} whether it is in the machine */
  keepInMachine(radius, pose, place, stays) {
    let [s, n] = Base.seenFrom(pose, place.x, place.y);
    const base = this.base;
    if (base.isPeriodic) s -= base.width * Math.floor(s / base.width);
    else if (base.machine.boundary === 'walled' && n < base.machine.wall_height)
      s = Math.min(base.width - radius, Math.max(radius, s));
    else if (!stays && (s < 0 || s > base.width)) return false;
    [s, n] = base.cleared(s, n, radius);
    [place.x, place.y] = Base.inWorld(pose, s, n);
    return true;
  }

  /** A height above all disks of the first frame, and above nearly all later states. */
  top() {
    const share = 0.999;
    const every = Math.ceil(this.y.length / MOST_HEIGHTS);
    const heights = Float32Array.from({length: Math.floor(this.y.length / (every || 1))}, (_, k) => this.y[k * every]).sort();
    let top = heights.length ? heights[Math.floor(share * (heights.length - 1))] : -Infinity;
    for (let track = 0; track < this.ids.length; ++track)
      if (this.firstFrames[track] === 0) top = Math.max(top, this.y[this.starts[track]] + this.radii[track]);
    return top;
  }

  /** The track of a disk at a time; -1: it is not in the machine. */
  trackOf(id, time) {
    const frame = this.frameAt(time);
    for (let k = this.frameStarts[frame]; k < this.frameStarts[frame + 1]; ++k)
      if (this.ids[this.tracksOfFrames[k]] === id) return this.tracksOfFrames[k];
    return -1;
  }

  /** The path of a track: points in steps of time, between two times. @return {Array<Array<number>>} [x, y, time] */
  pathOf(track, from, to, step) {
    const points = [];
    const place = {x: 0, y: 0, angle: 0};
    const first = this.firstFrames[track];
    const begin = Math.max(from, this.times[first]);
    const end = Math.min(to, this.times[first + this.lengths[track] - 1]);
    for (let k = Math.ceil(begin / step); k * step <= end; ++k) {
      const time = k * step;
      this.placeAt(track, this.frameAt(time), time, this.base.poseAt(time), place);
      points.push([place.x, place.y, time]);
    }
    return points;
  }
}
