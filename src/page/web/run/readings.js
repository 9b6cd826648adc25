/** The values at the present time, beside the picture. */
class Readings {
  constructor(machine, base, bins) {
    this.machine = machine;
    this.base = base;
    this.bins = bins;
    this.names = machine.species.map((species, k) => marked(species.name, colourOf(k)));
    this.cells = machine.species.map(() => ['left', 'on_base', 'right'].map(() => element('span')));
    this.hasBins = bins.areUsed(machine.boundary);
    if (!this.hasBins) byId('bins').hidden = true;
    else fillTable(byId('bins'), ['species', 'left bin', 'on the base', 'right bin'],
      this.names.map((name, k) => [name, ...this.cells[k]]));
  }

  show(time) {
    byId('clock').value = seconds(time);
    byId('time').setAttribute('aria-valuetext', time.toFixed(3) + ' seconds');
    byId('quality').value = ratio(this.bins.quality(time));
    byId('processed').value = ratio(this.bins.processed(time));
    const state = this.base.stateAt(time);
    byId('inclination').value = quantity(state.inclination, 'rad');
    byId('frequency').value = quantity(state.frequency, 'Hz');
    byId('amplitude').value = quantity(state.amplitude * 1e3, 'mm');
    if (!this.hasBins) return;
    this.cells.forEach((cells, species) => ['left', 'on_base', 'right'].forEach((place, k) => {
      cells[k].textContent = quantity(this.bins.count(species, place, time), '', 15);
    }));
  }

  /** The same in a sentence, for readers of the screen. */
  sentence(time) {
    const counts = this.machine.species.map((species, k) => !this.hasBins ? '' :
      `; ${species.name}: ${this.bins.count(k, 'left', time)} in the left bin, ` +
      `${this.bins.count(k, 'on_base', time)} on the base, ${this.bins.count(k, 'right', time)} in the right bin`);
    return `The machine at ${time.toFixed(3)} seconds: Q ${ratio(this.bins.quality(time))}, ` +
      `P ${ratio(this.bins.processed(time))}${counts.join('')}`;
  }
}
