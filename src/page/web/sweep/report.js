/** The data of a sweep's report, see docs/sweeps.md. A place is a setting of the keys along x and y. */
class SweepReport {
  constructor(data) {
    this.data = data;
    this.fields = data.fields;
    this.x = data.x;
    this.y = data.y;
    this.places = data.places;
    this.columns = data.x.values.length;
    this.rows = data.y ? data.y.values.length : 1;
    this.byCell = new Map(data.places.map((place) => [place.x + place.y * this.columns, place]));
  }

  /** The place of a column and a row; undefined: no run of it is done. */
  at(column, row) { return column < 0 || column >= this.columns ? undefined : this.byCell.get(column + row * this.columns); }

  /** The best place, or the first one. */
  get first() { return this.data.best ? this.at(this.data.best.x, this.data.best.y) : this.places[0]; }

  isBest(place) { return this.data.best !== null && place.x === this.data.best.x && place.y === this.data.best.y; }

  /** Whether a field is Q, since the start or of the filled machine. */
  isQuality(field) { return ['quality', 'steady.quality.value'].includes(this.fields[field].name); }

  /** Whether a field of a place is Q of too few disks. */
  isDoubtful(place, field) { return this.isQuality(field) && place.means[field] !== null && !place.comparable; }

  /** All defined means of a field, with their errors. */
  meansOf(field) { return this.places.map((place) => place.means[field]).filter((mean) => mean !== null); }

  labelOf(part) { return part.unit ? `${part.label} [${part.unit}]` : part.label; }

  valueText(axis, k, unit = '', digits = 6) {
    const value = axis.values[k];
    return typeof value === 'number' ? quantity(value, unit, digits) : value;
  }

  settingText(place) {
    return [[this.x, place.x], [this.y, place.y]].filter(([axis]) => axis)
      .map(([axis, k]) => `${axis.label} = ${this.valueText(axis, k, axis.unit)}`).join(', ');
  }

  meanText(place, field) {
    const mean = place.means[field];
    return mean ? withError(mean.value, mean.error, this.fields[field].unit) : UNDEFINED;
  }

  /** What is to be known of a field of a place besides its mean. */
  remarks(place, field) {
    const mean = place.means[field];
    const runs = countText(place.runs, 'run');
    const remarks = [mean && mean.count < place.runs ? `defined in ${mean.count} of ${runs}` : runs];
    if (this.isDoubtful(place, field)) remarks.push('Q not comparable');
    return remarks.join(', ');
  }

  /** @return {Array<{seed: string, command: string, page: ?string}>} */
  casesOf(place) {
    return place.cases.flatMap(({arguments: own, seeds, pages}) => seeds.map((seed, k) => ({
      seed: seed === null ? 'the scene\u2019s' : seed,
      command: [this.data.command, own, seed === null ? '' : '--seed ' + seed].filter((part) => part).join(' '),
      page: pages[k],
    })));
  }
}
