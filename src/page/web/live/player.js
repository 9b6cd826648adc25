const MOST = 'most';        // the speed that is as fast as the engine goes
const BUDGET = 30;          // of a request, so that the picture goes on where the engine is slower than real time [ms]
const FACTOR_TIME = 0.5;    // over which the speed that is reached is measured [s]

/** Runs the engine in a worker, and asks it for a picture at each frame of the browser. */
class LivePlayer extends Player {
  /** @param {function(Object)} onAnswer called with each answer of the worker */
  constructor(onAnswer) {
    super([...SPEEDS, MOST], 'as fast as it goes');
    this.onAnswer = onAnswer;
    this.worker = new Worker(URL.createObjectURL(new Blob([byId('worker').textContent], {type: 'text/javascript'})));
    this.worker.onmessage = ({data}) => this.answered(data);
    this.waiting = [];
    this.factor = null;
  }

  /** Asks the worker. @return {Promise<Object>} its answer */
  ask(request, more = {}) {
    this.worker.postMessage({request, ...more});
    return new Promise((resolve) => this.waiting.push(resolve));
  }

  answered(answer) {
    const resolve = this.waiting.shift();
    if (answer.time !== undefined) this.time = answer.time;
    this.onAnswer(answer);
    resolve(answer);
  }

  play() {
    if (this.playing) return;
    this.playing = true;
    this.factor = null;
    this.onChange();
    const measured = {wall: performance.now(), time: this.time};
    this.before = null;
    const step = this.step = (now) => {
      if (!this.playing || this.step !== step) return;
      requestAnimationFrame(step);
      const isNew = this.time < measured.time;  // another run
      if (isNew || now - measured.wall > 1000 * FACTOR_TIME) {
        this.factor = isNew ? null : (this.time - measured.time) / (now - measured.wall) * 1000;
        [measured.wall, measured.time] = [now, this.time];
      }
      if (this.waiting.length) return;
      const elapsed = this.elapsedTo(now);
      this.ask('advance', {to: this.speed === MOST ? Infinity : this.time + this.speed * elapsed, budget: BUDGET});
    };
    requestAnimationFrame(step);
  }

  pause() {
    this.factor = null;
    super.pause();
  }
}
