const BESIDE = 0.1;  // by which the setting beside differs at first [range of its slider]

/** A second machine in the window, in step with the first: it has another seed, or one setting of its own. */
class Beside {
  constructor(page) {
    this.page = page;
    this.engine = null;
    this.quantity = null;  // the setting that differs; null: the seed
    byId('beside').addEventListener('change', () => this.choose(byId('beside').value));
  }

  /** Lists what can differ. */
  offer({offered}) {
    if (offered === this.offered) return;
    this.offered = offered;
    byId('beside').replaceChildren(...[['', 'no'], ['seed', 'next seed'], ...offered.quantities.map(({name}) => [name, name])]
      .map(([value, text]) => element('option', {value}, text)));
    this.show(false);
  }

  show(isShown) {
    byId('beside-view').hidden = !isShown;
    byId('origin').hidden = isShown;
    byId('beside-setpoint').replaceChildren();
    if (isShown) return;
    if (this.engine) this.engine.worker.terminate();
    this.engine = this.picture = null;
    this.page.fit();
  }

  async choose(what) {
    this.show(what !== '');
    if (!what) return;
    this.index = this.offered.quantities.findIndex(({name}) => name === what);
    this.quantity = this.offered.quantities[this.index] || null;
    if (this.quantity) this.addSlider(this.quantity);
    this.engine ??= await EngineWorker.compiled();
    this.page.restart();
  }

  addSlider({min, max, name}) {
    const now = this.page.run.readings.base['commanded_' + name];
    const more = BESIDE * (max - min);
    this.value = Number((now + more <= max ? now + more : now - more).toPrecision(4));
    const slider = new Slider('beside-', this.quantity, (value) => {
      this.value = value;
      return this.engine.ask('order', {order: ['command', this.index, value]});
    });
    slider.show(this.value);
    byId('beside-setpoint').append(slider.part);
  }

  get isBusy() { return this.engine !== null && this.engine.waiting.length > 0; }

  /** Pours it anew beside a run. */
  open(settings, run) {
    if (!this.engine) return;
    this.picture = null;
    this.run = run;
    this.given = 0;  // commands of the run that it has got
    const own = this.quantity ? {schedule: [[0, 'command', this.index, this.value]]} : {schedule: [], seed: settings.seed + 1};
    this.engine.open({...settings, ...own}, run);
  }

  /** Brings it to where the run is. */
  async follow({run, time, schedule}) {
    if (!this.engine || run !== this.run) return;
    for (; this.given < schedule.length; ++this.given) {
      const [at, ...order] = schedule[this.given];
      if (this.quantity && order[0] === 'command' && order[1] === this.index) continue;
      this.engine.ask('advance', {to: at});
      this.engine.ask('order', {order});
    }
    const answer = await this.engine.ask('advance', {to: time});
    if (!this.engine || answer.run !== this.run || !answer.disks) return;
    const {readings, disks} = answer;
    if (this.picture) this.shown.take(readings, disks, null);
    else {
      this.shown = new LiveRun(this.offered.machine, readings, disks);
      this.picture = new Picture(byId('beside-machine'), this.shown.base, this.shown.motion, this.shown.bins);
    }
    this.draw();
  }

  draw() {
    if (!this.picture) return;
    const {bins, records, readings: {time}} = this.shown;
    Object.assign(this.picture, {view: this.page.picture.view, insets: this.page.picture.insets});
    this.picture.fillBins();
    this.picture.draw(time);
    const what = this.quantity ? `${this.quantity.name} ${shownText(this.value, this.quantity.unit)}` : `seed ${this.page.settings.seed + 1}`;
    byId('beside-result').textContent = `${what}: ${sortedText(time, bins, records.velocities, this.offered.machine)}`;
  }
}
