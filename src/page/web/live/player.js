const MOST = 'most';        // the speed that is as fast as the engine goes
const BUDGET = 30;          // of a request, so that the picture goes on where the engine is slower than real time [ms]
const FACTOR_TIME = 0.5;    // over which the speed that is reached is measured [s]

/** The engine in a worker: src/web/worker.js. */
class EngineWorker {
  /** @param {function(Object)} onAnswer called with each answer */
  constructor(onAnswer = () => {}) {
    const address = URL.createObjectURL(new Blob([byId('worker').textContent], {type: 'text/javascript'}));
    this.worker = new Worker(address);
    URL.revokeObjectURL(address);
    this.waiting = [];
    this.worker.onmessage = ({data}) => {
      const resolve = this.waiting.shift();
      onAnswer(data);
      resolve(data);
    };
  }

  /** A worker that has compiled the engine of this page. */
  static async compiled(onAnswer) {
    const worker = new EngineWorker(onAnswer);
    await worker.ask('compile', {engine: await inflated(bytesOf(byId('engine').textContent))});
    return worker;
  }

  /** @return {Promise<Object>} its answer */
  ask(request, more = {}) {
    this.worker.postMessage({request, ...more});
    return new Promise((resolve) => this.waiting.push(resolve));
  }

  /** Pours a scene. @param {{offered: Object, seed: number, feedRate: number, schedule: Array}} settings see Session */
  open({offered, seed, feedRate, schedule}, run) {
    return this.ask('open', {run, definition: bytesOf(offered.definition), settings: {seed, feedRate, schedule}});
  }
}

/** Asks the engine for a picture at each frame of the browser. */
class LivePlayer extends Player {
  /** @param {function(): boolean} isBusy whether the engine, or one beside it, still works */
  constructor(isBusy) {
    super([...SPEEDS, MOST], 'fastest');
    this.isBusy = isBusy;
    this.factor = null;
  }

  goOn(now) {
    const isNew = this.before === null || this.time < this.measured.time;  // another run
    if (isNew || now - this.measured.wall > 1000 * FACTOR_TIME) {
      this.factor = isNew ? null : (this.time - this.measured.time) / (now - this.measured.wall) * 1000;
      this.measured = {wall: now, time: this.time};
    }
    if (this.isBusy()) return;
    const elapsed = this.elapsedTo(now);
    this.engine.ask('advance', {to: this.speed === MOST ? Infinity : this.time + this.speed * elapsed, budget: BUDGET});
  }
}
