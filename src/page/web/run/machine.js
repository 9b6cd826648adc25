/** A page with a machine in motion: its parts, and how they answer to the user. A derived class has drawCurves() and keysOf(). */
class MachinePage {
  /** @param {Player} player @param {number} curvesPeriod between two drawings of the curves while it plays [ms] */
  constructor(player, curvesPeriod) {
    this.player = player;
    this.curvesPeriod = curvesPeriod;
    this.curvesDrawn = 0;
    player.onChange = () => this.showPlayer();
    byId('play').addEventListener('click', () => player.toggle());
    byId('speed').addEventListener('change', () =>
      player.setSpeed(player.speeds.find((speed) => String(speed) === byId('speed').value)));
    document.addEventListener('keydown', (event) => this.onKey(event));
    onThemeChange(() => {
      if (this.curves) this.curves.build();
      this.show();
    });
    new ResizeObserver(() => this.fit()).observe(byId('content'));
  }

  /** The window, the panel or the base has changed: the picture is to hold the machine. */
  fit() {
    if (!this.picture) return;
    this.picture.layout(this.insets());
    this.curves.all('resize');
    this.show();
  }

  /** What covers the picture at its edges [pixels]. */
  insets() { return {left: 0, top: 0, right: 0, bottom: 0}; }

  resultText() { return sortedText(this.player.time, this.bins, this.curves.series.velocities, this.picture.base.machine); }

  /** @param {Curves} curves of the same run */
  showMachine(base, motion, bins, curves) {
    this.bins = bins;
    this.picture = new Picture(byId('machine'), base, motion, bins);
    this.picture.layout(this.insets());
    if (this.controls) this.controls.picture = this.picture;
    else this.controls = new PictureControls(this.picture, () => this.player.time, () => this.show());
    this.values = new Readings(base, bins);
    this.curves = curves;
  }

  show() {
    if (!this.picture) return;
    const {time, playing} = this.player;
    this.picture.draw(time);
    this.values.show(time, this.resultText());
    const now = performance.now();
    if (!playing || now - this.curvesDrawn > this.curvesPeriod) {
      this.drawCurves();
      this.curvesDrawn = now;
    }
    if (!playing) byId('machine').setAttribute('aria-label', this.values.sentence(time, this.resultText()));
  }

  showPlayer() {
    const {playing, speed} = this.player;
    byId('play').textContent = playing ? 'Pause' : 'Play';
    byId('play').setAttribute('aria-pressed', String(playing));
    byId('speed').value = String(speed);
    this.show();
  }

  onKey(event) {
    if (isForControl(event) || !this.controls) return;
    answerKey(event, {
      ' ': () => this.player.toggle(),
      ',': () => this.player.changeSpeed(-1),
      '.': () => this.player.changeSpeed(1),
      ...this.controls.keys,
      ...this.keysOf(event),
    });
  }

  /** What scripts in the page's console, and tests, can do with it. */
  scripting() {
    const page = this;
    const {player} = this;
    return {
      get time() { return player.time; },
      get playing() { return player.playing; },
      get followed() { return page.picture.followed; },
      /** What the picture says: the line above it, and the labels of the bins. */
      get said() {
        const {bins, picture} = page;
        const label = (bin) => bins.labelOf(bin, player.time, picture.base.machine.species).map(({text}) => text).join(' ');
        return {result: byId('result').textContent, ...bins.areUsed && {left: label('left'), right: label('right')}};
      },
      play: () => player.play(),
      pause: () => player.pause(),
      disks: () => page.picture.disksAt(player.time),
      toPixel: (x, y) => page.picture.view.toPixel(x, y),
    };
  }
}
