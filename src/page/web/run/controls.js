const ZOOM_STEP = 1.4;
const DRAG = 4;  // pixels that make a press a drag

/** The part of the machine that the picture shows, and the disk that it follows: buttons, keys, pointers. */
class PictureControls {
  /** @param {function(): number} timeNow @param {function()} show draws the picture anew */
  constructor(picture, timeNow, show) {
    this.picture = picture;
    this.timeNow = timeNow;
    this.onClick = null;  // what a click beside the disks does, at x and y in the world, if no disk is followed
    this.show = show;
    this.keys = {
      '+': () => this.zoomBy(ZOOM_STEP),
      '=': () => this.zoomBy(ZOOM_STEP),
      '-': () => this.zoomBy(1 / ZOOM_STEP),
      '0': () => this.showWhole(),
      Escape: () => this.follow(null),
    };
    for (const [id, text, name, key] of [['zoom-out', '\u2212', 'Zoom out', '-'], ['zoom-in', '+', 'Zoom in', '+'], ['whole', 'Whole machine', 'Whole machine', '0']]) {
      const button = element('button', {id, type: 'button', 'aria-label': name, title: `${name} (${key})`}, text);
      button.addEventListener('click', this.keys[key]);
      byId('view').append(button, ' ');
    }
    byId('following').append(element('label', {}, 'Follow disk ', element('input', {id: 'follow', type: 'number', min: 0, step: 1, placeholder: 'id'})),
      ' ', element('output', {id: 'followed'}));
    byId('follow').addEventListener('change', () => {
      const text = byId('follow').value;
      this.follow(text === '' ? null : Number(text));
    });
    this.connectCanvas();
  }

  zoomBy(factor, ...pixel) {
    this.picture.view.zoomBy(factor, ...pixel);
    this.show();
  }

  showWhole() {
    this.picture.view.showWhole();
    this.show();
  }

  follow(id) {
    this.picture.followed = id;
    byId('follow').value = id === null ? '' : String(id);
    const disk = id === null ? null : this.picture.diskAt(this.timeNow(), id);
    byId('followed').value = id === null ? '' : !disk ? 'not in the machine at this time'
      : `${this.picture.base.machine.species[disk.species].name}, radius ${shownText(disk.radius, 'm')}`;
    this.show();
  }

  /** Drags move the picture, two fingers move it and zoom, clicks follow a disk. */
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
        const [a, b] = fingers.values();
        this.picture.view.moveBy(0.5 * moved[0], 0.5 * moved[1]);
        this.zoomBy(distance([a, b]) / Math.max(1, distance(before)), 0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]));
      } else if (dragged > DRAG) {
        canvas.classList.add('moving');
        this.picture.view.moveBy(...moved);
        this.show();
      }
    });
    const release = (event) => {
      canvas.classList.remove('moving');
      if (!fingers.delete(event.pointerId) || event.type !== 'pointerup' || dragged > DRAG) return;
      const disk = this.picture.diskNear(this.timeNow(), event.offsetX, event.offsetY);
      if (disk || this.picture.followed !== null || !this.onClick) this.follow(disk ? disk.id : null);
      else this.onClick(...this.picture.view.toWorld(event.offsetX, event.offsetY));
    };
    canvas.addEventListener('pointerup', release);
    canvas.addEventListener('pointercancel', release);
    canvas.addEventListener('wheel', (event) => {
      if (!event.ctrlKey && !event.metaKey) return;
      event.preventDefault();
      this.zoomBy(Math.exp(-0.002 * event.deltaY), event.offsetX, event.offsetY);
    }, {passive: false});
  }
}
