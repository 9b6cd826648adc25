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
    return row < 0 ? null : columns[name]?.[row] ?? null;
  }

  /** Disks of a species in one of left, right, on_base. */
  count(species, place, time) { return this.at(time, place, this.bins.species[species]); }

  /** All disks in a bin. */
  total(bin, time) { return this.bins.species.reduce((sum, species) => sum + this.at(time, bin, species), 0); }

  /** What a bin holds, in two lines: how many disks, and the share of the kind that most are of. */
  labelOf(bin, time, species) {
    const total = this.total(bin, time);
    if (!total) return [{text: '0', species: null}];
    const most = species.map((_, k) => this.count(k, bin, time)).reduce((best, count, k, all) => count > all[best] ? k : best, 0);
    return [{text: countText(total, 'disk'), species: null},
      {text: `${percent(this.count(most, bin, time) / total)} ${species[most].name}`, species: most}];
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

/** A kind with its size and mass. */
function kindOf({name, radius, mass, varies}, k) {
  return element('span', {}, marked(name, k), ` ${varies ? 'about ' : ''}${shownText(radius, 'm', 3)}, ${shownText(mass, 'kg', 3)} `);
}

/** How well a machine sorts at a time, by the engine's own numbers. @param {BinSeries} bins @param {Object} velocities series */
function sortedText(time, bins, velocities, {species, fed}) {
  const [separation, quality, processed] = ['separation', 'quality', 'processed'].map((name) => bins.at(time, name));
  const left = `${percent(processed || 0)} have left`;
  if (quality !== null) {
    const [first, second] = species.map(({name}) => name);
    const sides = species.length !== 2 ? 'the best pair' : !separation ? 'both alike'
      : separation > 0 ? `${first} left, ${second} right` : `${first} right, ${second} left`;
    return `${percent(quality)} sorted: ${sides}${fed ? '' : '; ' + left}`;
  }
  const row = lastNotAbove(velocities.time, time);
  const drifts = bins.areUsed || row < 0 ? [] : species.map(({name}, k) => [name, velocities.species[k].mean_vx[row]])
    .filter(([, mean]) => mean !== null).map(([name, mean]) =>
      `${name} drifts ${shownText(Math.abs(mean), 'm/s', 2)} to the ${mean < 0 ? 'left' : 'right'}`);
  return bins.areUsed ? left : drifts.join(', ') || 'no mean velocity yet';
}

/** The values at the present time: names, symbols and ids of their outputs. */
const VALUES = [['sorted', 'Q', 'quality'], ['have left', 'P', 'processed'],
  ...Object.entries(COMMANDED).map(([name, [letter]]) => [name, letter, name])];

const PLACE_TEXTS = {left: 'left bin', on_base: 'on the base', right: 'right bin'};
const PLACES = Object.keys(PLACE_TEXTS);

/** Adds values to the page's list. @param {Array<Array<string>>} values as VALUES */
function listValues(values) {
  byId('now').append(...values.map(([name, letter, id]) => element('div', {}, element('dt', {}, name, ...letter ? [' ', symbol(letter)] : []),
    element('dd', {}, element('output', {id, 'aria-live': 'off'})))));
}

/** The values at the present time, beside the picture. */
class Readings {
  constructor(base, bins) {
    this.species = base.machine.species;
    if (!byId('quality')) listValues(VALUES);
    this.result = document.createTextNode('');
    byId('result').replaceChildren(...this.species.map(kindOf), '\u2014 ', this.result);
    this.base = base;
    this.bins = bins;
    this.cells = this.species.map(() => PLACES.map(() => element('span')));
    byId('bins').hidden = !bins.areUsed;
    if (bins.areUsed) fillTable(byId('bins'), ['species', ...Object.values(PLACE_TEXTS)],
      this.species.map(({name}, k) => [marked(name, k), ...this.cells[k]]));
  }

  show(time, text) {
    byId('clock').value = seconds(time);
    this.result.data = text;
    for (const name of ['quality', 'processed']) byId(name).value = ratio(this.bins.at(time, name));
    const state = this.base.stateAt(time);
    for (const [name, [, unit]] of Object.entries(COMMANDED)) byId(name).value = shownText(state[name], unit);
    if (!this.bins.areUsed) return;
    this.cells.forEach((cells, species) => PLACES.forEach((place, k) => {
      cells[k].textContent = quantity(this.bins.count(species, place, time), '', 15);
    }));
  }

  /** In a sentence, for readers of the screen. */
  sentence(time, text) {
    const counts = this.species.map(({name}, k) => !this.bins.areUsed ? '' : `; ${name}: ` + PLACES.map((place) =>
      `${this.bins.count(k, place, time)} ${PLACE_TEXTS[place]}`).join(', '));
    return `The machine at ${time.toFixed(3)} seconds: ${text}${counts.join('')}`;
  }
}
