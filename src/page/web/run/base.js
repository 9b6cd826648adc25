const MOST_PASSES = 20;  // in which a disk is moved out of a groove
const CLEAR = 1e-4;      // an overlap that is none [radii]

/** The base: its motion, and what keeps disks above it. World frame: x to the right, y upwards [m]. */
class Base {
  /** @param {Object} machine @param {Object} drive series of its states */
  constructor(machine, drive) {
    this.machine = machine;
    this.states = drive;
    this.toothWidth = machine.tooth[machine.tooth.length - 1][0];
    this.width = machine.teeth * this.toothWidth;
    this.highest = Math.max(...machine.tooth.map((corner) => corner[1]));
    this.lowest = Math.min(...machine.tooth.map((corner) => corner[1]));
  }

  /** Setpoints and applied values at a time, by their names, and the phase [rad]. */
  stateAt(time) {
    const states = this.states;
    const last = states.time.length - 1;
    const k = Math.min(Math.max(lastNotAbove(states.time, time), 0), Math.max(last - 1, 0));
    const next = Math.min(k + 1, last);
    const span = states.time[next] - states.time[k];
    const elapsed = time - states.time[k];
    const part = span > 0 ? elapsed / span : 0;
    const state = {};
    for (const name of Object.keys(COMMANDED)) {
      state[name] = states[name][k] + (states[name][next] - states[name][k]) * part;
      const commanded = states['commanded_' + name];
      state['commanded_' + name] = commanded[part >= 1 ? next : k];
    }
    state.phase = this.phaseAt(k, next, span, elapsed);
    return state;
  }

  /** The frequency is linear between two states. The remainder to the later state's phase is spread evenly. */
  phaseAt(k, next, span, elapsed) {
    const states = this.states;
    if (!(span > 0)) return states.phase[k];
    const turn = 2 * Math.PI;
    const ramp = (states.frequency[next] - states.frequency[k]) / span;
    const after = (t) => turn * (states.frequency[k] * t + 0.5 * ramp * t * t);
    let rest = (states.phase[next] - states.phase[k] - after(span)) % turn;
    rest -= turn * Math.round(rest / turn);
    return states.phase[k] + after(elapsed) + rest * elapsed / span;
  }

  /** The displacement of the base by its drive, in the world: docs/model.md, "The drive". */
  displacement(state) {
    const drive = this.machine.drive;
    const scale = drive.amplitude !== 0 ? state.amplitude / drive.amplitude : 1;
    let x = scale * drive.horizontal_amplitude * Math.sin(state.phase + drive.horizontal_phase);
    let y = state.amplitude * Math.sin(state.phase);
    for (const harmonic of drive.harmonics) {
      const phase = harmonic.multiple * state.phase;
      x += scale * harmonic.horizontal_amplitude * Math.sin(phase + harmonic.horizontal_phase);
      y += scale * harmonic.amplitude * Math.sin(phase + harmonic.phase);
    }
    if (!drive.turns_with_base) return [x, y];
    const cosine = Math.cos(state.inclination);
    const sine = Math.sin(state.inclination);
    return [cosine * x - sine * y, sine * x + cosine * y];
  }

  /** Where the base is: its foot and its direction. */
  poseAt(time) {
    const state = this.stateAt(time);
    const [x, y] = this.displacement(state);
    return {x, y, cosine: Math.cos(state.inclination), sine: Math.sin(state.inclination)};
  }

  /** A place of the world, along the base and normal to it. */
  static seenFrom(pose, x, y) {
    const dx = x - pose.x, dy = y - pose.y;
    return [dx * pose.cosine + dy * pose.sine, dy * pose.cosine - dx * pose.sine];
  }

  /** The inverse of seenFrom. */
  static inWorld(pose, s, n) { return [pose.x + s * pose.cosine - n * pose.sine, pose.y + s * pose.sine + n * pose.cosine]; }

  /** Corners in the frame of the base: along it, and normal to it. */
  outline() {
    const corners = [];
    for (let k = 0; k < this.machine.teeth; ++k)
      for (const [s, n] of this.machine.tooth) corners.push([k * this.toothWidth + s, n]);
    return corners;
  }

  get isPeriodic() { return this.machine.boundary === 'periodic'; }

  /** Calls back with both ends of each face that a disk over s can reach. */
  forEachFace(s, radius, action) {
    const tooth = this.machine.tooth;
    let first = Math.floor((s - radius) / this.toothWidth);
    let last = Math.floor((s + radius) / this.toothWidth);
    if (!this.isPeriodic) {
      first = Math.max(first, 0);
      last = Math.min(last, this.machine.teeth - 1);
    }
    for (let k = first; k <= last; ++k) {
      const start = k * this.toothWidth;
      for (let i = 0; i + 1 < tooth.length; ++i)
        action([start + tooth[i][0], tooth[i][1]], [start + tooth[i + 1][0], tooth[i + 1][1]]);
    }
  }

  /** The height of the outline over s; -Infinity beyond its ends. */
  surface(s) {
    let height = -Infinity;
    this.forEachFace(s, 0, (a, b) => {
      if (a[0] < b[0] && a[0] <= s && s <= b[0])
        height = Math.max(height, a[1] + (b[1] - a[1]) * (s - a[0]) / (b[0] - a[0]));
    });
    return height;
  }

  /**
   * The place nearest to (s, n) at which a disk does not overlap the base: lifted onto it where its centre lies below the
   * surface, and moved away from the faces and corners that it overlaps, from the deepest first.
   */
  cleared(s, n, radius) {
    if (n - radius > this.highest) return [s, n];
    const surface = this.surface(s);
    if (n <= surface) n = surface + radius;
    for (let pass = 0; pass < MOST_PASSES; ++pass) {
      let deepest = radius;
      let away = null;
      this.forEachFace(s, radius, (a, b) => {
        const ds = b[0] - a[0];
        const dn = b[1] - a[1];
        const part = Math.min(1, Math.max(0, ((s - a[0]) * ds + (n - a[1]) * dn) / (ds * ds + dn * dn)));
        const fromS = s - a[0] - part * ds;
        const fromN = n - a[1] - part * dn;
        const distance = Math.hypot(fromS, fromN);
        if (distance < deepest && distance > 0) {
          deepest = distance;
          away = [fromS / distance, fromN / distance];
        }
      });
      if (!away || deepest > radius * (1 - CLEAR)) break;
      s += (radius - deepest) * away[0];
      n += (radius - deepest) * away[1];
    }
    return [s, n];
  }
}
