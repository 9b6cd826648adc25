/** The charts of a run, with one cursor and one mark of the present time. */
class Curves {
  /** @param {function(number)} onClick @param {function(): number} timeNow */
  constructor(parent, run, series, times, hasBins, onClick, timeNow) {
    this.names = run.machine.species.map((species) => species.name);
    this.series = series;
    this.hasBins = hasBins;
    this.end = times[times.length - 1];
    this.x = {name: 'time', label: 'time [s]', scale: {range: () => [times[0], this.end]},
      series: {value: (u, v) => seconds(u.cursor.left >= 0 && v !== null ? v : timeNow())}};
    this.parent = parent;
    this.charts = [];
    this.common = {sync: 'time', onClick, mark: timeNow};
    this.build();
  }

  build() {
    this.all('remove');
    const shown = this.shown();
    this.titles = shown.map(({title}) => title).join();
    this.charts = shown.map((chart) => addChart(this.parent, {x: this.x, ...chart}, this.common));
  }

  /** Shows what the series have become. @param {number} end the last time */
  update(end) {
    this.end = end;
    const shown = this.shown();
    if (shown.map(({title}) => title).join() !== this.titles) this.build();
    else shown.forEach((chart, k) => this.charts[k].update(chart.data));
  }

  /** A chart for all that changes. */
  shown() {
    const charts = this.setpoints();
    if (this.series.velocities.time.length) charts.unshift(this.velocities());
    if (this.hasBins) charts.unshift(...this.names.length === 2 ? [this.separation()] : [], this.qualities(), this.counts(),
      this.shares('purity'), this.shares('recovery'));
    return charts.filter(({data: [, ...columns]}) => columns.some((column) => column.some((value) => value !== column[0])));
  }

  /** Columns of the bins, held until the end of the run. */
  held(...columns) {
    const time = this.series.bins.time;
    return [[...time, this.end], ...columns.map((column) => [...column, column[column.length - 1]])];
  }

  static stepped(label, colour, more = {}) { return {label, stroke: colour, paths: uPlot.paths.stepped({align: 1}), ...more}; }

  qualities() {
    const bins = this.series.bins;
    return {
      title: 'How well they are sorted, Q, and the share that has left, P',
      y: {label: 'Q, P', scale: {range: [0, 1.02]}},
      series: [Curves.stepped('Q', colourOf(0)), Curves.stepped('P', colourOf(1), {dash: [6, 4]})],
      data: this.held(bins.quality, bins.processed),
    };
  }

  separation() {
    return {
      title: `Separation: share of ${this.names[0]} that left on the left, less that of ${this.names[1]}`,
      y: {label: 'separation', scale: {range: [-1.02, 1.02]}},
      series: [Curves.stepped('separation', colourOf(0))],
      data: this.held(this.series.bins.separation),
    };
  }

  /** Of each species a dashed line for the left bin, and one for the right bin. */
  ofBins(columnOf) {
    const series = [];
    const columns = [];
    this.names.forEach((name, k) => ['left', 'right'].forEach((bin) => {
      series.push(Curves.stepped(`${name} ${bin}`, colourOf(k), dashesOf(k, bin === 'left')));
      columns.push(columnOf(this.series.bins.species[k], bin));
    }));
    return {series, data: this.held(...columns)};
  }

  counts() {
    return {title: 'Disks in the bins', y: {label: 'disks', scale: {range: (u, low, high) => [0, 1.05 * high || 1]}},
      ...this.ofBins((species, bin) => species[bin])};
  }

  shares(share) {
    return {
      title: share === 'purity' ? 'Purity: share of a species in a bin, by number'
        : 'Recovery: share of what left of a species that is in a bin, by number',
      y: {label: share, scale: {range: [0, 1.02]}},
      ...this.ofBins((species, bin) => species[bin].map((count, row) => {
        const all = share === 'purity' ? this.series.bins.species.reduce((sum, each) => sum + each[bin][row], 0)
          : species.left[row] + species.right[row];
        return all > 0 ? count / all : null;
      })),
    };
  }

  velocities() {
    const {time, species} = this.series.velocities;
    const [unit, scale] = shownUnit('m/s');
    const series = [];
    const bands = [];
    const data = [time];
    species.forEach((each, k) => {
      const shifted = (sign) => each.mean_vx.map((mean, i) =>
        mean === null || each.mean_vx_stderr[i] === null ? null : scale * (mean + sign * each.mean_vx_stderr[i]));
      const colour = colourOf(k);
      const edge = {stroke: colour + '60', width: 0.5, class: 'edge'};
      series.push({label: this.names[k], stroke: colour, ...dashesOf(k)}, {...edge, label: this.names[k] + ' + error'},
        {...edge, label: this.names[k] + ' \u2212 error'});
      data.push(each.mean_vx.map((mean) => mean === null ? null : scale * mean), shifted(1), shifted(-1));
      bands.push({series: [3 * k + 2, 3 * k + 3], fill: colour + '30'});
    });
    return {
      title: 'Mean velocity \u27e8V_x\u27e9 since the end of settle, and its standard error',
      y: {label: unit, unit}, series, bands, data,
    };
  }

  /** Inclination, frequency and amplitude, each with its setpoint. */
  setpoints() {
    const drive = this.series.drive;
    return Object.entries(COMMANDED).map(([name, [letter, of]]) => {
      const [unit, scale] = shownUnit(of);
      return {
        title: `${name[0].toUpperCase()}${name.slice(1)} ${letter} and its setpoint`,
        y: {label: `${letter} [${unit}]`, unit},
        series: [{label: letter, stroke: colourOf(0)}, Curves.stepped('setpoint', colourOf(1), {dash: [6, 4]})],
        data: [drive.time, ...[drive[name], drive['commanded_' + name]].map((column) => column.map((value) => scale * value))],
      };
    });
  }

  /** @param {string} what redraw, resize or remove */
  all(what) { for (const chart of this.charts) chart[what](); }
}
