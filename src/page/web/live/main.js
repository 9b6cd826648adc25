const CURVES_PERIOD = 300;    // between two drawings of the curves [ms]
const SETPOINT_PERIOD = 100;  // between two commands while a slider moves [ms]
const STEP = 1 / 32;          // of the drive's period
const STEP_AT_REST = 1e-3;    // [s]

/** A machine that runs in the page. */
class LivePage {
  constructor({version, scenes}) {
    this.version = version;
    this.scenes = scenes;
    this.player = new LivePlayer((answer) => this.take(answer), () => this.showPlayer());
    this.panel = new Panel(this);
    this.run = 0;      // the number of the run that was asked for last
    this.begun = 0;    // and of the one that is shown
    this.curvesDrawn = 0;
    document.addEventListener('keydown', (event) => this.onKey(event));
    addEventListener('hashchange', () => {
      if (location.hash && location.hash !== this.linked) this.openLink(location.hash);
    });
    onThemeChange(() => {
      this.curves.all('rebuild');
      this.show();
    });
    new ResizeObserver(() => {
      if (!this.picture) return;
      this.picture.resize();
      this.curves.all('resize');
      this.show();
    }).observe(byId('content'));
  }

  /**
   * Pours a scene.
   * @param {{offered: Object, seed: number, feedRate: number, schedule: Array}} settings see Session
   * @return {Promise<Object>} the first state
   */
  open(settings) {
    this.settings = settings;
    this.error = null;
    ++this.run;
    this.panel.showSettings(settings);
    const {seed, feedRate, schedule} = settings;
    return this.player.ask('open', {run: this.run, definition: bytesOf(settings.offered.definition),
      settings: {seed, feedRate, schedule}});
  }

  openScene(name) {
    const offered = this.scenes.find((scene) => scene.name === name);
    return this.open({offered, seed: offered.seed, feedRate: offered.feed_rate, schedule: []});
  }

  /** Opens the run of a link's fragment; of an empty one, the first scene. Of one that cannot be opened it says why. */
  async openLink(fragment) {
    let error;
    try {
      const settings = settingsOfLink(fragment, this.scenes);
      await (settings ? this.open(settings) : this.openScene(this.scenes[0].name));
      error = this.error;
    } catch (thrown) {
      error = thrown.message;
    }
    if (!error) return;
    await this.openScene(this.scenes[0].name);
    this.player.pause();
    this.error = this.error || 'This link cannot be opened: ' + error;
    this.show();
  }

  restart(change = {}) {
    return this.open({...this.settings, schedule: [], ...change});
  }

  step() {
    this.player.pause();
    const frequency = this.readings?.base.frequency;
    return this.player.ask('advance', {to: this.player.time + (frequency > 0 ? STEP / frequency : STEP_AT_REST)});
  }

  /** What the worker answers. */
  take({run, error, readings, disks, schedule}) {
    if (error && (run === undefined || run === this.run)) {
      this.error = error;
      this.player.pause();
    }
    if (run !== this.run) return this.panel.say(this.error, null);
    this.readings = readings;
    this.schedule = schedule;
    if (this.begun !== run) this.begin(readings, disks);
    else {
      this.base.set(readings.base);
      this.motion.set(readings.time, disks, this.picture.followed);
      this.records.add(readings);
    }
    this.show();
  }

  /** The first state of a run. */
  begin(readings, disks) {
    const {machine} = this.settings.offered;
    this.begun = this.run;
    this.base = new LiveBase(machine, readings.base);
    this.motion = new LiveMotion(this.base);
    this.motion.set(readings.time, disks, null);
    this.records = new Records(machine.species);
    this.records.add(readings);
    this.bins = new BinSeries(this.records.bins, machine.boundary);
    this.picture = new Picture(byId('machine'), this.base, this.motion, this.bins);
    this.picture.resize();
    this.picture.showFirst();
    if (this.controls) this.controls.picture = this.picture;
    else this.controls = new PictureControls(this.picture, () => this.player.time, () => this.show());
    this.values = new Readings(machine, this.base, this.bins);
    byId('follow').value = byId('followed').value = '';
    if (this.curves) this.curves.all('remove');
    this.curves = new Curves(byId('curves'), {machine}, this.records, [0, 1], machine.boundary !== 'periodic', () => {},
      () => this.player.time);
  }

  /** The base tilts: the picture is to hold it. */
  fit() {
    this.picture.fit();
    this.show();
  }

  show() {
    if (!this.readings) return;
    const {time} = this.readings;
    this.picture.draw(time);
    this.values.show(time);
    this.panel.show(this.readings, this.schedule, this.motion.ids.length, this.player.factor);
    this.panel.say(this.error, this.readings);
    const now = performance.now();
    if (!this.player.playing || now - this.curvesDrawn > CURVES_PERIOD) {
      this.picture.fillBins();
      this.curves.update(Math.max(time, 0.1));
      this.curvesDrawn = now;
    }
    if (!this.player.playing) {
      byId('machine').setAttribute('aria-label', this.values.sentence(time));
      this.showProgram();
    }
  }

  showProgram() {
    if (this.readings) byId('python').textContent = this.program();
  }

  showPlayer() {
    this.panel.showPlayer(this.player);
    this.show();
  }

  program() {
    return programOf(this.settings, this.schedule, this.readings.time);
  }

  link() {
    location.hash = fragmentOf(this.settings, this.schedule);
    this.linked = location.hash;
    return location.href;
  }

  onKey(event) {
    if (isForControl(event) || !this.controls) return;
    const isSlider = event.target.matches('input[type=range]');
    answerKey(event, {
      ' ': () => this.player.toggle(),
      ...isSlider ? {} : {ArrowRight: () => this.step()},
      ',': () => this.player.changeSpeed(-1),
      '.': () => this.player.changeSpeed(1),
      r: () => this.restart(),
      n: () => this.restart({seed: this.settings.seed + 1}),
      p: () => this.panel.pour(),
      ...this.controls.keys,
    });
  }
}

/** What scripts in the page's console, and tests, can do with it. */
function scriptingOf(page) {
  const {player} = page;
  return {
    get scenes() { return page.scenes.map((scene) => scene.name); },
    get time() { return player.time; },
    get playing() { return player.playing; },
    get factor() { return player.factor; },
    get readings() { return page.readings; },
    get schedule() { return page.schedule; },
    get followed() { return page.picture.followed; },
    get drawMilliseconds() { return page.picture.milliseconds; },
    toPixel: (x, y) => page.picture.view.toPixel(x, y),
    play: () => player.play(),
    pause: () => player.pause(),
    /** A whole run. @return {Promise<{readings: Object, disks: Float64Array}>} the state at a time */
    async stateAt(name, time, settings) {
      player.pause();
      const offered = page.scenes.find((scene) => scene.name === name);
      await page.open({offered, seed: offered.seed, feedRate: offered.feed_rate, schedule: [], ...settings});
      return player.ask('advance', {to: time});
    },
    disks: () => page.picture.disksAt(player.time),
    program: () => page.program(),
    link: () => page.link(),
  };
}

openPage(async () => {
  const page = new LivePage(JSON.parse(byId('data').textContent));
  await page.player.ask('compile', {engine: await inflated(bytesOf(byId('engine').textContent))});
  byId('content').hidden = false;
  await page.openLink(location.hash);
  if (!page.error && !matchMedia('(prefers-reduced-motion: reduce)').matches) page.player.play();
  return scriptingOf(page);
});
