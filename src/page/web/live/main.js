const CURVES_PERIOD = 300;    // between two drawings of the curves [ms]
const SETPOINT_PERIOD = 100;  // between two commands while a slider moves [ms]
const STEP = 1 / 32;          // of the drive's period
const STEP_AT_REST = 1e-3;    // [s]

/** A machine that runs in the page. */
class LivePage extends MachinePage {
  constructor({version, scenes}) {
    super(new LivePlayer((answer) => this.take(answer)), CURVES_PERIOD);
    this.version = version;
    this.scenes = scenes;
    this.panel = new Panel(this);
    this.run = 0;      // the number of the run that was asked for last
    this.begun = 0;    // and of the one that is shown
    byId('title').textContent = document.title;
    this.showPlayer();
    addEventListener('hashchange', () => {
      if (location.hash && location.hash !== this.linked) this.openLink(location.hash);
    });
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
    byId('follow').value = byId('followed').value = '';
    if (this.curves) this.curves.all('remove');
    this.showMachine(this.base, this.motion, this.bins, new Curves(byId('curves'), {machine}, this.records, [0, 1],
      machine.boundary !== 'periodic', () => {}, () => this.player.time));
  }

  /** The base tilts: the picture is to hold it. */
  fit() {
    this.picture.fit();
    this.show();
  }

  show() {
    super.show();
    if (!this.readings) return;
    this.panel.show(this.readings, this.schedule, this.motion.ids.length, this.player.factor);
    this.panel.say(this.error, this.readings);
    if (!this.player.playing) this.showProgram();
  }

  drawCurves() {
    this.picture.fillBins();
    this.curves.update(Math.max(this.player.time, 0.1));
  }

  showProgram() {
    if (this.readings) byId('python').textContent = this.program();
  }

  program() {
    return programOf(this.settings, this.schedule, this.readings.time);
  }

  link() {
    location.hash = fragmentOf(this.settings, this.schedule);
    this.linked = location.hash;
    return location.href;
  }

  keysOf(event) {
    return {
      ...event.target.matches('input[type=range]') ? {} : {ArrowRight: () => this.step()},
      r: () => this.restart(),
      n: () => this.restart({seed: this.settings.seed + 1}),
      p: () => this.panel.pour(),
    };
  }
}

openPage(async () => {
  const page = new LivePage(JSON.parse(byId('data').textContent));
  const {player} = page;
  await player.ask('compile', {engine: await inflated(bytesOf(byId('engine').textContent))});
  byId('content').hidden = false;
  await page.openLink(location.hash);
  if (!page.error && !matchMedia('(prefers-reduced-motion: reduce)').matches) player.play();
  return [page.scripting(), {
    get readings() { return page.readings; },
    get schedule() { return page.schedule; },
    /** A whole run. @return {Promise<{readings: Object, disks: Float64Array}>} the state at a time */
    async stateAt(name, time, settings) {
      player.pause();
      const offered = page.scenes.find((scene) => scene.name === name);
      await page.open({offered, seed: offered.seed, feedRate: offered.feed_rate, schedule: [], ...settings});
      return player.ask('advance', {to: time});
    },
    program: () => page.program(),
    link: () => page.link(),
  }];
});
