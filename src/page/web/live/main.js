const CURVES_PERIOD = 300;    // between two drawings of the curves [ms]
const STEP = 1 / 32;          // of the drive's period
const STEP_AT_REST = 1e-3;    // [s]
const HANDFUL = 4;            // width of a stretch that is poured onto [largest diameters]
const PER_METRE = 1e4;        // ends of such a stretch: a link has few digits for them

/** A machine that runs in the page. */
class LivePage extends MachinePage {
  constructor({version, scenes}) {
    super(new LivePlayer(() => this.engine.waiting.length > 0 || this.beside.isBusy), CURVES_PERIOD);
    this.version = version;
    this.scenes = scenes;
    this.panel = new Panel(this);
    this.beside = new Beside(this);
    this.advice = new Advice(this);
    this.asked = 0;    // the number of the run that was asked for last
    this.begun = 0;    // and of the one that is shown
    this.showPlayer();
    addEventListener('hashchange', () => {
      if (location.hash.startsWith(MARK) && location.hash !== this.linked) this.openLink(location.hash);
    });
  }

  async start() { this.engine = this.player.engine = await EngineWorker.compiled((answer) => this.take(answer)); }

  /**
   * Pours a scene.
   * @param {{offered: Object, seed: number, feedRate: number, schedule: Array}} settings see Session
   * @return {Promise<Object>} the first state
   */
  open(settings) {
    this.settings = settings;
    this.error = null;
    ++this.asked;
    this.advice.say('');
    this.panel.showSettings(settings);
    this.beside.offer(settings);
    this.beside.open(settings, this.asked);
    return this.engine.open(settings, this.asked);
  }

  openScene(name, settings = {}) {
    const offered = this.scenes.find((scene) => scene.name === name);
    return this.open({offered, seed: offered.seed, feedRate: offered.feed_rate, schedule: [], ...settings});
  }

  /** Opens the run of a link's fragment; of another one, the first scene. Of one that cannot be opened it says why. */
  async openLink(fragment) {
    let error;
    try {
      const settings = await settingsOfLink(fragment, this.scenes);
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

  /** Pours anew, with the setpoints that the run has now. */
  restart(change = {}) { return this.open({...this.settings, schedule: this.panel.commands(), ...change}); }

  step() {
    this.player.pause();
    const frequency = this.run?.readings.base.frequency;
    return this.engine.ask('advance', {to: this.player.time + (frequency > 0 ? STEP / frequency : STEP_AT_REST)});
  }

  async order(order) {
    await this.engine.ask('order', {order});
    this.picture.layout(this.insets());
    this.show();
  }

  /** A handful of disks onto the place of the base that is below a point. */
  drop(x, y) {
    const {base} = this.run;
    const half = HANDFUL * Math.max(...base.machine.species.map(({radius}) => radius));
    const [s] = Base.seenFrom(base.poseAt(), x, y);
    if (s < 0 || s > base.width) return;
    this.panel.pour(...[s - half, s + half].map((end) => Math.round(Math.min(base.width, Math.max(0, end)) * PER_METRE) / PER_METRE));
  }

  /** What the worker answers. */
  take(answer) {
    const {run, error, readings, disks, schedule} = answer;
    if (error && (run === undefined || run === this.asked)) {
      this.error = error;
      this.player.pause();
    }
    if (run !== this.asked) return this.panel.say(this.error, null);
    this.player.time = answer.time;
    this.schedule = schedule;
    if (this.begun !== run) this.begin(readings, disks);
    else this.run.take(readings, disks, this.picture.followed);
    this.beside.follow(answer);
    return this.show();
  }

  /** The first state of a run. */
  begin(readings, disks) {
    const {machine} = this.settings.offered;
    this.begun = this.asked;
    const run = this.run = new LiveRun(machine, readings, disks);
    if (this.controls) byId('follow').value = byId('followed').value = '';
    if (this.curves) this.curves.all('remove');
    this.showMachine(run.base, run.motion, run.bins, new Curves(byId('curves'), {machine}, run.records, [0, 1],
      machine.boundary !== 'periodic', () => {}, () => this.player.time));
    this.controls.onClick = (x, y) => this.drop(x, y);
  }

  insets() {
    const [stage, panel, header] = [byId('stage'), byId('panel'), byId('title').parentElement].map((part) => part.getBoundingClientRect());
    const isBeside = getComputedStyle(byId('panel')).position === 'absolute' && byId('panel').open;
    return {left: 0, top: header.bottom - stage.top, right: isBeside ? stage.right - panel.left : 0, bottom: 0};
  }

  resultText() { return this.player.time > 0 || this.player.playing ? super.resultText() : 'press Play'; }

  show() {
    super.show();
    if (!this.run) return;
    this.panel.show(this.run.readings, this.schedule, this.run.motion.ids.length, this.player.playing ? this.player.factor : null);
    this.panel.say(this.error, this.run.readings);
    this.beside.draw();
    if (!this.player.playing) this.showProgram();
  }

  drawCurves() {
    this.picture.fillBins();
    this.curves.update(Math.max(this.player.time, 0.1));
  }

  showProgram() { if (this.run) byId('python').textContent = this.program(); }

  program() { return programOf(this.settings, this.schedule, this.run.readings.time); }

  async link() {
    location.hash = await fragmentOf(this.settings, this.schedule);
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
  await page.start();
  byId('content').hidden = false;
  await page.openLink(location.hash);
  if (!page.error && !matchMedia('(prefers-reduced-motion: reduce)').matches) player.play();
  return [page.scripting(), {
    get readings() { return page.run.readings; },
    get schedule() { return page.schedule; },
    /** A whole run. @return {Promise<{readings: Object, disks: Float64Array}>} the state at a time */
    async stateAt(name, time, settings) {
      player.pause();
      await page.openScene(name, settings);
      return page.engine.ask('advance', {to: time});
    },
    program: () => page.program(),
    link: () => page.link(),
    /** The run beside, or null. */
    get beside() { return page.beside.picture && page.beside.shown.readings; },
  }];
});
