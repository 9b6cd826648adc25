const ZOOM_STEP = 1.4;
const DRAG = 4;             // pixels that make a press a drag
const CURVES_PERIOD = 100;  // of the mark in the curves while the run plays [ms]

/** The bytes of an element's base64. */
function bytesOf(id) {
  const text = atob(byId(id).textContent.trim());
  const bytes = new Uint8Array(text.length);
  for (let k = 0; k < text.length; ++k) bytes[k] = text.charCodeAt(k);
  return bytes;
}

async function inflated(bytes) {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** The page's data. @return {Promise<{run: Object, series: Object, motion: Uint8Array}>} */
async function readData() {
  const run = JSON.parse(byId('data').textContent);
  const series = JSON.parse(new TextDecoder().decode(await inflated(bytesOf('series'))));
  return {run, series, motion: await inflated(bytesOf('motion'))};
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
    this.connectControls();
    this.connectCanvas();
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
      speed < 1 ? `1/${Math.round(1 / speed)}` : `${speed}\u00d7`)));
    byId('speed').addEventListener('change', () => this.player.setSpeed(Number(byId('speed').value)));
    byId('play').addEventListener('click', () => this.player.toggle());
    byId('back').addEventListener('click', () => this.player.stepFrames(-1));
    byId('forth').addEventListener('click', () => this.player.stepFrames(1));
    byId('zoom-in').addEventListener('click', () => this.zoomBy(ZOOM_STEP));
    byId('zoom-out').addEventListener('click', () => this.zoomBy(1 / ZOOM_STEP));
    byId('whole').addEventListener('click', () => this.showWhole());
    byId('follow').addEventListener('change', () => {
      const text = byId('follow').value;
      this.follow(text === '' ? null : Number(text));
    });
  }

  zoomBy(factor, ...pixel) {
    this.picture.view.zoomBy(factor, ...(pixel.length ? pixel : this.picture.middle(this.player.time)));
    this.show(this.player.time);
  }

  showWhole() {
    this.picture.view.showWhole();
    this.show(this.player.time);
  }

  follow(id) {
    this.picture.followed = id;
    byId('follow').value = id === null ? '' : String(id);
    const disk = id === null ? null : this.picture.diskAt(this.player.time, (each) => each.id === id);
    byId('followed').value = id === null ? '' : !disk ? 'not in the machine at this time'
      : `${this.base.machine.species[disk.species].name}, radius ${quantity(disk.radius * 1e3, 'mm')}`;
    this.show(this.player.time);
  }

  /** Drags move the picture, two fingers zoom, clicks follow a disk. */
  connectCanvas() {
    const canvas = byId('machine');
    const fingers = new Map();
    let dragged = 0;
    canvas.addEventListener('pointerdown', (event) => {
      canvas.setPointerCapture(event.pointerId);
      fingers.set(event.pointerId, [event.offsetX, event.offsetY]);
      if (fingers.size === 1) dragged = 0;
    });
    canvas.addEventListener('pointermove', (event) => {
      if (!fingers.has(event.pointerId)) return;
      const before = [...fingers.values()];
      const moved = [event.offsetX - fingers.get(event.pointerId)[0], event.offsetY - fingers.get(event.pointerId)[1]];
      fingers.set(event.pointerId, [event.offsetX, event.offsetY]);
      dragged += Math.hypot(...moved);
      if (fingers.size === 2) {
        const distance = ([a, b]) => Math.hypot(a[0] - b[0], a[1] - b[1]);
        this.zoomBy(distance([...fingers.values()]) / Math.max(1, distance(before)), event.offsetX, event.offsetY);
      } else if (dragged > DRAG) {
        canvas.classList.add('moving');
        this.picture.view.moveBy(...moved);
        this.show(this.player.time);
      }
    });
    const release = (event) => {
      canvas.classList.remove('moving');
      if (!fingers.delete(event.pointerId) || event.type !== 'pointerup' || dragged > DRAG) return;
      const disk = this.picture.diskNear(this.player.time, event.offsetX, event.offsetY);
      this.follow(disk ? disk.id : null);
    };
    canvas.addEventListener('pointerup', release);
    canvas.addEventListener('pointercancel', release);
    canvas.addEventListener('wheel', (event) => {
      if (!event.ctrlKey && !event.metaKey) return;
      event.preventDefault();
      this.zoomBy(Math.exp(-0.002 * event.deltaY), event.offsetX, event.offsetY);
    }, {passive: false});
  }

  onKey(event) {
    const at = event.target;
    const writes = at.matches('select, textarea, input:not([type=range])');
    if (writes || (event.key === ' ' && at.matches('button, summary'))) return;
    const {player} = this;
    answerKey(event, {
      ' ': () => player.toggle(),
      ArrowLeft: () => player.stepFrames(-1),
      ArrowRight: () => player.stepFrames(1),
      Home: () => player.seek(player.start),
      End: () => player.seek(player.end),
      ',': () => player.changeSpeed(-1),
      '.': () => player.changeSpeed(1),
      '+': () => this.zoomBy(ZOOM_STEP),
      '=': () => this.zoomBy(ZOOM_STEP),
      '-': () => this.zoomBy(1 / ZOOM_STEP),
      '0': () => this.showWhole(),
      Escape: () => this.follow(null),
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
    follow: (id) => page.follow(id),
    disks: () => picture.disksAt(player.time),
    toPixel: (x, y) => picture.view.toPixel(x, y),
    view: () => ({zoom: picture.view.zoom, centre: picture.view.centre, scale: picture.view.scale}),
  };
}

openPage(async () => scriptingOf(new RunPage(await readData())));
