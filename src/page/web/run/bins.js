/** What a run's bins hold over time. */
class BinSeries {
  /** @param {Object} bins columns over time @param {string} boundary of the machine */
  constructor(bins, boundary) {
    this.bins = bins;
    // Whether disks can leave the machine, or have left it over walls.
    this.areUsed = bins.time.length > 0 &&
      (boundary === 'open' || ['left', 'right'].some((bin) => this.total(bin, Infinity) > 0));
  }

  /** The value of a column, of a species or of the whole machine, that holds at a time; null before the first. */
  at(time, name, columns = this.bins) {
    const row = lastNotAbove(this.bins.time, time);
    return row < 0 ? null : columns[name][row];
  }

  /** Disks of a species in one of left, right, on_base. */
  count(species, place, time) {
    return this.at(time, place, this.bins.species[species]);
  }

  /** All disks in a bin. */
  total(bin, time) {
    return this.bins.species.reduce((sum, species) => sum + this.at(time, bin, species), 0);
  }

  /** The species of the disks in a bin at the end, in the order in which they came. @param {string} bin left or right */
  arrivals(bin) {
    const order = [];
    const counted = this.bins.species.map(() => 0);
    this.bins.time.forEach((_, row) => this.bins.species.forEach((species, k) => {
      for (; counted[k] < species[bin][row]; ++counted[k]) order.push(k);
    }));
    return order;
  }
}

/** The values at the present time, beside the picture. */
class Readings {
  constructor(base, bins) {
    this.species = base.machine.species;
    this.base = base;
    this.bins = bins;
    this.cells = this.species.map(() => ['left', 'on_base', 'right'].map(() => element('span')));
    byId('bins').hidden = !bins.areUsed;
    if (bins.areUsed) fillTable(byId('bins'), ['species', 'left bin', 'on the base', 'right bin'],
      this.species.map(({name}, k) => [marked(name, k), ...this.cells[k]]));
  }

  show(time) {
    byId('clock').value = seconds(time);
    for (const name of ['quality', 'processed']) byId(name).value = ratio(this.bins.at(time, name));
    const state = this.base.stateAt(time);
    byId('inclination').value = quantity(state.inclination, 'rad');
    byId('frequency').value = quantity(state.frequency, 'Hz');
    byId('amplitude').value = quantity(state.amplitude * 1e3, 'mm');
    if (!this.bins.areUsed) return;
    this.cells.forEach((cells, species) => ['left', 'on_base', 'right'].forEach((place, k) => {
      cells[k].textContent = quantity(this.bins.count(species, place, time), '', 15);
    }));
  }

  /** Q, P and the bins in a sentence, for readers of the screen. */
  sentence(time) {
    const counts = this.species.map((species, k) => !this.bins.areUsed ? '' :
      `; ${species.name}: ${this.bins.count(k, 'left', time)} in the left bin, ` +
      `${this.bins.count(k, 'on_base', time)} on the base, ${this.bins.count(k, 'right', time)} in the right bin`);
    return `The machine at ${time.toFixed(3)} seconds: Q ${ratio(this.bins.at(time, 'quality'))}, ` +
      `P ${ratio(this.bins.at(time, 'processed'))}${counts.join('')}`;
  }
}
