/** Speeds over that of the machine. */
const SPEEDS = [0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10];

const LONGEST_FRAME = 0.1;  // a pause of the browser, as of a hidden tab, is not caught up with [s]

/** The present time of a page, whether it goes on by play(), and how fast. */
class Player {
  /** @param {Array} speeds to choose from: numbers, or a text @param {string} textOfOther what the text stands for */
  constructor(speeds, textOfOther = '') {
    this.speeds = speeds;
    this.time = 0;
    this.playing = false;
    this.speed = 1;
    this.onChange = () => {};
    byId('speed').append(...speeds.map((speed) => element('option', {value: String(speed)},
      typeof speed !== 'number' ? textOfOther : speed < 1 ? `1/${Math.round(1 / speed)}` : `${speed}\u00d7`)));
  }

  /** Plays: a derived class has goOn(), which is called at each picture. */
  play() {
    if (this.playing) return;
    this.playing = true;
    this.before = null;
    this.onChange();
    const step = this.step = (now) => {
      if (!this.playing || this.step !== step) return;
      requestAnimationFrame(step);
      this.goOn(now);
    };
    requestAnimationFrame(step);
  }

  pause() {
    this.playing = false;
    this.onChange();
  }

  toggle() { if (this.playing) this.pause(); else this.play(); }

  /** The time that play() goes on by, since the picture before [s]. */
  elapsedTo(now) {
    const elapsed = this.before === null ? 0 : Math.min(LONGEST_FRAME, (now - this.before) / 1000);
    this.before = now;
    return elapsed;
  }

  setSpeed(speed) {
    this.speed = speed;
    this.onChange();
  }

  changeSpeed(steps) {
    this.setSpeed(this.speeds[Math.min(this.speeds.length - 1, Math.max(0, this.speeds.indexOf(this.speed) + steps))]);
  }
}

/** Plays a run that was recorded. */
class RunPlayer extends Player {
  /** @param {function()} show called with each new time */
  constructor(times, show) {
    super(SPEEDS);
    this.times = times;
    this.time = this.start = times[0];
    this.end = times[times.length - 1];
    this.show = show;
  }

  seek(time) {
    this.time = Math.min(this.end, Math.max(this.start, time));
    this.show();
  }

  play() {
    if (this.time >= this.end) this.seek(this.start);
    super.play();
  }

  goOn(now) {
    this.seek(this.time + this.speed * this.elapsedTo(now));
    if (this.time >= this.end) this.pause();
  }

  /** To the next recorded frame, or to the last one before. */
  stepFrames(frames) {
    this.pause();
    const k = lastNotAbove(this.times, this.time);
    const isOn = this.times[Math.max(k, 0)] === this.time;
    const next = k + frames + (frames < 0 && !isOn ? 1 : 0);
    this.seek(this.times[Math.min(this.times.length - 1, Math.max(0, next))]);
  }
}
