const RECORD_EVERY = 0.1;  // at first, of the curves' rows [s]
const MOST_RECORDS = 2000;  // of rows: then every other one is dropped

/** The base as the engine has it. */
class LiveBase extends Base {
  constructor(machine, state) {
    super(machine, null);
    this.set(state);
  }

  set(state) {
    this.state = state;
    this.states = {amplitude: [state.amplitude, state.commanded_amplitude],
      inclination: [state.inclination, state.commanded_inclination]};
  }

  stateAt() { return this.state; }

  poseAt() {
    const {horizontal_displacement: x, displacement: y, inclination} = this.state;
    return {x, y, cosine: Math.cos(inclination), sine: Math.sin(inclination)};
  }
}

/** The disks as the engine has them, and where the followed one was. A track is a disk's place in the list. */
class LiveMotion {
  /** @param {LiveBase} base */
  constructor(base) {
    this.base = base;
    this.times = [0];
    this.trail = [];
  }

  /** @param {Float64Array} disks DISK_FIELDS of each @param {?number} followed the id of a disk */
  set(time, disks, followed) {
    const stride = DISK_FIELDS.length;
    const column = (name) => {
      const at = DISK_FIELDS.indexOf(name);
      return Float64Array.from({length: disks.length / stride}, (_, k) => disks[k * stride + at]);
    };
    [this.ids, this.species, this.radii, this.x, this.y, this.angle] =
      ['id', 'species', 'radius', 'x', 'y', 'angle'].map(column);
    const track = followed === null ? -1 : this.ids.indexOf(followed);
    const last = this.trail.length && this.trail[this.trail.length - 1];
    if (track < 0 || last && (last.id !== followed || last[2] > time)) this.trail = [];
    if (track >= 0) this.trail.push(Object.assign([this.x[track], this.y[track], time], {id: followed}));
    while (this.trail.length && this.trail[0][2] < time - PATH_TIME) this.trail.shift();
  }

  forEachAt(time, action) {
    for (let track = 0; track < this.ids.length; ++track) action(track, this.x[track], this.y[track], this.angle[track]);
  }

  trackOf(id) { return this.ids.indexOf(id); }

  pathOf(track, from, to) { return this.trail.filter(([, , time]) => from <= time && time <= to); }

  /** As high as the picture goes. */
  top() { return Infinity; }
}

/** What the curves show: columns over time that grow. The last row is the present one. */
class Records {
  constructor(species) {
    this.every = RECORD_EVERY;
    this.columns = [];
    const table = (source, ...names) => Object.fromEntries(names.map((name) => {
      this.columns.push({cells: [], valueOf: (readings) => name === 'time' ? readings.time : source(readings)[name]});
      return [name, this.columns.at(-1).cells];
    }));
    const ofSpecies = (...names) => species.map((_, k) => table((readings) => readings.species[k], ...names));
    this.drive = table(({base}) => base, 'time', ...Object.keys(COMMANDED).flatMap((name) => [name, 'commanded_' + name]));
    this.bins = {...table((readings) => readings, 'time', 'separation', 'quality', 'processed'), species: ofSpecies('left', 'right', 'on_base')};
    this.velocities = {time: this.bins.time, species: ofSpecies('mean_vx', 'mean_vx_stderr')};
  }

  add(readings) {
    const {time} = this.bins;
    const rows = time.length;
    const replaces = rows > 1 && time[rows - 1] - time[rows - 2] < this.every;
    for (const {cells, valueOf} of this.columns) cells.splice(replaces ? rows - 1 : rows, 1, valueOf(readings));
    if (rows > MOST_RECORDS) this.thin();
  }

  thin() {
    this.every *= 2;
    for (const {cells} of this.columns) cells.splice(0, Infinity, ...cells.filter((_, k) => k % 2 === 0 || k === cells.length - 1));
  }
}

/** What is known of a run that goes on. */
class LiveRun {
  /** @param {Object} machine @param {Object} readings and @param {Float64Array} disks of its first state */
  constructor(machine, readings, disks) {
    this.base = new LiveBase(machine, readings.base);
    this.motion = new LiveMotion(this.base);
    this.records = new Records(machine.species);
    this.take(readings, disks, null);
    this.bins = new BinSeries(this.records.bins, machine.boundary);
  }

  take(readings, disks, followed) {
    this.readings = readings;
    this.base.set(readings.base);
    this.motion.set(readings.time, disks, followed);
    this.records.add(readings);
  }
}
