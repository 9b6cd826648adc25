const CURVES_PERIOD = 100;  // of the mark in the curves while the run plays [ms]

/** The page's data. @return {Promise<{run: Object, series: Object, motion: Uint8Array}>} */
async function readData() {
  const run = JSON.parse(byId('data').textContent);
  const series = JSON.parse(new TextDecoder().decode(await inflated(bytesOf(byId('series').textContent))));
  return {run, series, motion: await inflated(bytesOf(byId('motion').textContent))};
}

/** A run's page: its parts, and how they answer to the user. */
class RunPage {
  constructor({run, series, motion}) {
    this.base = new Base(run.machine, series.drive);
    this.motion = new Motion(run.motion, motion, this.base,
      [run.results.start_time, run.results.simulated_time]);
    this.bins = new BinSeries(series.bins, run.machine.boundary);
    new Report(run, this.motion.times, this.bins.areUsed).show();
    byId('content').hidden = false;
    if (run.motion.frames) byId('motion-note').textContent = `Between the ${this.motion.times.length} frames shown, disks fly on parabolas that fit ` +
      'the recorded positions and velocities. Where a disk met others in between, its path is one of several possible ones.';
    this.picture = new Picture(byId('machine'), this.base, this.motion, this.bins);
    this.picture.resize();
    this.picture.showFirst();
    this.readings = new Readings(run.machine, this.base, this.bins);
    this.player = new Player(this.motion.times, (time) => this.show(time));
    this.player.onChange = () => this.showPlayer();
    this.curves = new Curves(byId('curves'), run, series, this.motion.times,
      this.bins.areUsed, (time) => this.player.seek(time), () => this.player.time);
    this.curvesDrawn = 0;
    this.controls = new PictureControls(this.picture, () => this.player.time, () => this.show(this.player.time));
    this.connectControls();
    document.addEventListener('keydown', (event) => this.onKey(event));
    onThemeChange(() => {
      this.curves.all('rebuild');
      this.show(this.player.time);
    });
    addEventListener('beforeprint', () => { byId('scene-details').open = true; });
    new ResizeObserver(() => {
      this.picture.resize();
      this.curves.all('resize');
      this.show(this.player.time);
    }).observe(byId('content'));
    this.showPlayer();
    this.player.seek(this.motion.opening);
  }

  show(time) {
    this.picture.draw(time);
    this.readings.show(time);
    byId('time').value = String(time);
    byId('time').setAttribute('aria-valuetext', time.toFixed(3) + ' seconds');
    const now = performance.now();
    if (!this.player.playing || now - this.curvesDrawn > CURVES_PERIOD) {
      this.curves.all('redraw');
      this.curvesDrawn = now;
    }
    if (!this.player.playing) byId('machine').setAttribute('aria-label', this.readings.sentence(time));
  }

  showPlayer() {
    const {playing, speed} = this.player;
    byId('play').textContent = playing ? 'Pause' : 'Play';
    byId('play').setAttribute('aria-pressed', String(playing));
    byId('speed').value = String(speed);
    if (!playing) this.show(this.player.time);
  }

  connectControls() {
    const slider = byId('time');
    slider.min = String(this.player.start);
    slider.max = String(this.player.end);
    slider.addEventListener('input', () => this.player.seek(Number(slider.value)));
    byId('speed').append(...SPEEDS.map((speed) => element('option', {value: String(speed)},
      speedText(speed))));
    byId('speed').addEventListener('change', () => this.player.setSpeed(Number(byId('speed').value)));
    byId('play').addEventListener('click', () => this.player.toggle());
    byId('back').addEventListener('click', () => this.player.stepFrames(-1));
    byId('forth').addEventListener('click', () => this.player.stepFrames(1));
  }

  onKey(event) {
    if (isForControl(event)) return;
    const {player} = this;
    answerKey(event, {
      ' ': () => player.toggle(),
      ArrowLeft: () => player.stepFrames(-1),
      ArrowRight: () => player.stepFrames(1),
      Home: () => player.seek(player.start),
      End: () => player.seek(player.end),
      ',': () => player.changeSpeed(-1),
      '.': () => player.changeSpeed(1),
      ...this.controls.keys,
    });
  }
}

/** What scripts in the page's console, and tests, can do with it. */
function scriptingOf(page) {
  const {player, picture, motion} = page;
  return {
    start: player.start,
    end: player.end,
    frames: Array.from(motion.times),
    resolution: motion.resolution,
    get time() { return player.time; },
    get playing() { return player.playing; },
    get followed() { return picture.followed; },
    get drawMilliseconds() { return picture.milliseconds; },
    seek: (time) => player.seek(time),
    play: () => player.play(),
    pause: () => player.pause(),
    follow: (id) => page.controls.follow(id),
    disks: () => picture.disksAt(player.time),
    toPixel: (x, y) => picture.view.toPixel(x, y),
    view: () => ({zoom: picture.view.zoom, centre: picture.view.centre, scale: picture.view.scale}),
  };
}

openPage(async () => scriptingOf(new RunPage(await readData())));
