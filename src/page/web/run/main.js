const CURVES_PERIOD = 100;  // of the mark in the curves while the run plays [ms]

/** The page's data. @return {Promise<{run: Object, series: Object, motion: Uint8Array}>} */
async function readData() {
  const run = JSON.parse(byId('data').textContent);
  const series = JSON.parse(new TextDecoder().decode(await inflated(bytesOf(byId('series').textContent))));
  return {run, series, motion: await inflated(bytesOf(byId('motion').textContent))};
}

/** A run's page. */
class RunPage extends MachinePage {
  constructor({run, series, motion: states}) {
    const base = new Base(run.machine, series.drive);
    const span = [run.results.start_time, run.results.simulated_time];
    const motion = new Motion(run.motion, states, base, span);
    const bins = new BinSeries(series.bins, run.machine.boundary);
    super(new RunPlayer(motion.times, () => this.show()), CURVES_PERIOD);
    this.motion = motion;
    new Report(run, motion.times, bins.areUsed).show();
    byId('content').hidden = false;
    if (run.motion.frames) byId('motion-note').textContent = Report.motionText(run.motion, motion.times, span[1]);
    this.showMachine(base, motion, bins, new Curves(byId('curves'), run, series, span, bins.areUsed,
      (time) => this.player.seek(time), () => this.player.time));
    this.connectControls();
    addEventListener('beforeprint', () => { byId('scene').parentElement.open = true; });
    this.showPlayer();
    this.player.seek(motion.opening);
  }

  connectControls() {
    const {player} = this;
    const slider = byId('time');
    slider.min = String(player.start);
    slider.max = String(player.end);
    slider.addEventListener('input', () => player.seek(Number(slider.value)));
    byId('back').addEventListener('click', () => player.stepFrames(-1));
    byId('forth').addEventListener('click', () => player.stepFrames(1));
  }

  show() {
    super.show();
    const {time} = this.player;
    byId('time').value = String(time);
    byId('time').setAttribute('aria-valuetext', time.toFixed(3) + ' seconds');
  }

  /** Of the end of the run. */
  resultText() { return sortedText(Infinity, this.bins, this.curves.series.velocities, this.picture.base.machine); }

  drawCurves() { this.curves.all('redraw'); }

  keysOf() {
    const {player} = this;
    return {
      ArrowLeft: () => player.stepFrames(-1),
      ArrowRight: () => player.stepFrames(1),
      Home: () => player.seek(player.start),
      End: () => player.seek(player.end),
    };
  }
}

openPage(async () => {
  const page = new RunPage(await readData());
  const {player, motion} = page;
  return [page.scripting(), {
    start: player.start,
    end: player.end,
    frames: Array.from(motion.times),
    resolution: motion.resolution,
    seek: (time) => player.seek(time),
    follow: (id) => page.controls.follow(id),
  }];
});
