/** A buffer of the module, as it is until the next call. */
const BUFFERS = {text: Uint8Array, names: Uint8Array, values: Float64Array, disks: Float64Array};

/** What stands for a disk in the buffer of disks, SI units: docs/python.md, Simulation.disks. */
const DISK_FIELDS = ['id', 'species', 'x', 'y', 'angle', 'vx', 'vy', 'spin', 'displacement', 'radius'];

const NO_SUCH_CALL = 52;  // ENOSYS of WASI

/** What the module wants of its host: the standard library asks for a clock and the environment. */
function hostOf(memory) {
  return {
    env: {emscripten_notify_memory_growth() {}},
    wasi_snapshot_preview1: {
      clock_time_get: () => NO_SUCH_CALL,
      environ_get: () => 0,
      environ_sizes_get(count, size) {
        const view = new DataView(memory().buffer);
        view.setUint32(count, 0, true);
        view.setUint32(size, 0, true);
        return 0;
      },
      proc_exit(status) { throw new Error(`the engine ended with status ${status}`); },
    },
  };
}

/** One simulation by the engine's own code: src/web/exports.cpp. */
class Engine {
  /**
   * @param {WebAssembly.Module} module @param {Uint8Array} definition of the scene
   * @param {{seed: number, feedRate: number}} settings in place of the scene's
   */
  constructor(module, definition, {seed, feedRate}) {
    this.calls = new WebAssembly.Instance(module, hostOf(() => this.calls.memory)).exports;
    this.calls._initialize();
    const address = this.calls.input(definition.length);
    new Uint8Array(this.calls.memory.buffer, address, definition.length).set(definition);
    this.call('open', seed, feedRate);
  }

  /** @throws {Error} what the engine says; it cannot be advanced any more */
  call(name, ...values) {
    try {
      return this.calls[name](...values);
    } catch (error) {
      throw new Error(new TextDecoder().decode(this.buffer('text')) || error.message);
    }
  }

  /** A copy of a buffer. */
  buffer(name) { return new BUFFERS[name](this.calls.memory.buffer, this.calls[name](), this.calls[name + '_size']()).slice(); }

  advance(time) { this.call('advance', time); }

  /** @param {Array<string|number>} command a name and its values, such as ['command', 0, 0.1], ['pour', 1, 20] */
  order([name, ...values]) { this.call(name, ...values); }

  /** @return {{readings: Object, disks: Float64Array}} the readings as a tree, undefined numbers null */
  read() {
    this.call('read');
    const values = this.buffer('values');
    const readings = {};
    new TextDecoder().decode(this.buffer('names')).split(' ').forEach((name, k) => {
      const path = name.split('.');
      const last = path.pop();
      const part = path.reduce((tree, key) => tree[key] ??= {}, readings);
      part[last] = Number.isNaN(values[k]) ? null : values[k];
    });
    readings.species = Object.values(readings.species);
    return {readings, disks: this.buffer('disks')};
  }
}
