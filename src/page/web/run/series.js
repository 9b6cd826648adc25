/** What a run's bins hold over time. */
class BinSeries {
  constructor(bins) {
    this.bins = bins;
  }

  get isEmpty() {
    return this.bins.time.length === 0;
  }

  /** Whether disks can leave the machine, or have left it over walls. */
  areUsed(boundary) {
    return !this.isEmpty && (boundary === 'open' || this.most > 0);
  }

  /** The row that holds at a time; -1: before the first. */
  rowAt(time) {
    return lastNotAbove(this.bins.time, time);
  }

  quality(time) {
    const row = this.rowAt(time);
    return row < 0 ? null : this.bins.quality[row];
  }

  processed(time) {
    const row = this.rowAt(time);
    return row < 0 ? null : this.bins.processed[row];
  }

  /** Disks of a species in one of left, right, on_base. */
  count(species, place, time) {
    const row = this.rowAt(time);
    return row < 0 ? null : this.bins.species[species][place][row];
  }

  /** All disks in a bin. */
  total(bin, time) {
    const row = this.rowAt(time);
    return row < 0 ? 0 : this.bins.species.reduce((sum, species) => sum + species[bin][row], 0);
  }

  /** The species of the disks in a bin, in the order in which they came. @param {string} bin left or right */
  arrivals(bin, time) {
    const last = this.rowAt(time);
    const order = [];
    const counted = this.bins.species.map(() => 0);
    for (let row = 0; row <= last; ++row)
      this.bins.species.forEach((species, k) => {
        for (; counted[k] < species[bin][row]; ++counted[k]) order.push(k);
      });
    return order;
  }

  /** The most disks that a bin ever holds. */
  get most() {
    return Math.max(...['left', 'right'].map((bin) => this.total(bin, Infinity)));
  }
}
