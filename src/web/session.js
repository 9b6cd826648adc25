const LOOK = 4;  // about so often the clock is looked at while the engine works [ms]

/** A run with its schedule: the commands and when they were given. The states do not depend on how the time is divided. */
class Session {
  /**
   * @param {WebAssembly.Module} module @param {Uint8Array} definition
   * @param {{seed: number, feedRate: number, schedule: Array}} settings the schedule: commands that are still to be
   *   given, each its time [s] and what Engine.order() takes, in the order of time
   */
  constructor(module, definition, settings) {
    this.engine = new Engine(module, definition, settings);
    this.time = 0;
    this.schedule = [];
    this.pending = settings.schedule.slice();
    this.stride = 1e-3;  // which takes about LOOK [s]
    this.givePending();
  }

  /** Gives a command at the next whole millisecond, for which a link has few digits. */
  orderSoon(order) {
    this.advance(Math.ceil(this.time * 1e3) / 1e3);
    this.order(order);
  }

  /** Gives a command now. */
  order(order) {
    this.engine.order(order);
    this.schedule.push([this.time, ...order]);
  }

  givePending() { while (this.pending.length && this.pending[0][0] <= this.time) this.order(this.pending.shift().slice(1)); }

  /** Advances to a time, or until the wall time `budget` is used up [ms]. */
  advance(to, budget = Infinity) {
    const begin = performance.now();
    for (let before = begin; this.time < to && before - begin < budget;) {
      const full = this.time + this.stride;
      const next = Math.min(to, full, this.pending.length ? this.pending[0][0] : Infinity);
      this.engine.advance(next);
      this.time = next;
      this.givePending();
      const now = performance.now();
      if (now - before >= LOOK) this.stride *= 0.5;
      else if (next === full) this.stride *= 1.5;
      before = now;
    }
  }
}
