/** Both ends of a class, with as many decimals as tell them from what they are by less than a hundredth of its width. */
function rangeText(from, to) {
  const isNear = (decimals) => [from, to].every((end) => Math.abs(Number(end.toFixed(decimals)) - end) < 0.01 * (to - from));
  const decimals = [0, 1, 2, 3, 4, 5, 6].find(isNear) ?? 6;
  return `${from.toFixed(decimals)} to ${to.toFixed(decimals)}`;
}

/** A key as words. */
function wordsOf(key) {
  return key.replace(/quantile_(\d+)/, '$1 % quantile').replace('mean_vx', '\u27e8V_x\u27e9').replace('stderr', 'standard error')
    .replace(/_(?!x)/g, ' ');
}

/** The results of a run, its commands, and where it comes from. */
class Report {
  constructor(run, times, hasBins) {
    this.run = run;
    this.times = times;
    this.hasBins = hasBins;
    this.results = run.results;
  }

  show() {
    const {run, results} = this;
    showHead(run.title, `${quantity(results.start_time, '', 6)} to ${quantity(results.simulated_time, 's', 6)}, ` +
      `seed ${run.scene.seed}, ratchet_sieve ${run.scene.version}`);
    this.showResults();
    this.showCommands();
    this.showProvenance();
  }

  showResults() {
    const results = this.results;
    const by = results.species.some((species) => species.engine_mean_vx !== null) ? 'engine_' : '';
    const columns = [['species', (species, k) => marked(species.name, k)],
      ['disks', (species) => quantity(species.count, '', 15)],
      ['\u27e8V_x\u27e9', (species) => withError(species[by + 'mean_vx'], species[by + 'mean_vx_stderr'], 'mm/s', 1e3)],
      ['granular temperature', (species) => quantity(species.granular_temperature, 'J')]];
    if (this.hasBins) {
      for (const place of ['left', 'on_base', 'right'])
        columns.push([place.replace('_', ' '), (species) => quantity(species[place], '', 15)]);
      for (const share of ['purity', 'recovery'])
        for (const bin of ['left', 'right'])
          columns.push([`${share} ${bin}`, (species, k) => ratio(results[share][bin][k].number)]);
    }
    fillTable(byId('results'), columns.map(([name]) => name),
      results.species.map((species, k) => columns.map(([, cell]) => cell(species, k))));
    const whole = [['Q', ratio(results.quality)], ['P', ratio(results.processed)],
      ...this.steadyRows(), ['short to long slope', ratio(results.short_to_long)], ['largest overlap', shownText(results.max_overlap, 'm')]];
    if (results.collisions)
      whole.push(['contacts', Object.entries(results.collisions)
        .map(([kind, count]) => `${kind.replace('_', ' ')} ${count}`).join(', ')]);
    if (this.hasBins) whole.unshift(['separation s', ratio(results.separation)]);
    byId('more-results').append(element('dl', {}, ...listOf(whole)));
    this.showObserved();
  }

  /** What a machine with a feed does once it has filled. */
  steadyRows() {
    const {steady, steady_reason: reason} = this.results;
    if (!steady) return reason && !reason.startsWith('no ') ? [['once filled', reason]] : [];
    const {from, separation, throughput, inside} = steady;
    const text = (estimate, unit) => withError(estimate && estimate.value, estimate && estimate.half_width, unit);
    return [['once filled', `from ${seconds(from)}`], ['s once filled', text(separation, '')],
      ['throughput once filled', text(throughput.number, '1/s')], ['disks inside', text(inside, '')]];
  }

  /** What the scene observes: whatever is not shown above. */
  showObserved() {
    const shown = new Set(['scene_hash', 'seed', 'version', 'plan', 'start_time', 'first_frame_time', 'simulated_time', 'particle_frames',
      'not_recorded', 'species', 'separation', 'separation_by_mass', 'quality', 'processed', 'purity', 'recovery', 'collisions', 'max_overlap',
      'short_to_long', 'steady_reason']);
    for (const [name, value] of Object.entries(this.results)) {
      if (shown.has(name)) continue;
      const title = wordsOf(name);
      byId('more-results').append(element('details', {}, element('summary', {}, title),
        scrolling(title, Report.tree(value, this.run.units[name] || {}))));
    }
  }

  /** Any value as nested lists and tables. @param {Object<string, string>} units by the names of numbers and columns */
  static tree(value, units, unit = '') {
    if (value === null || typeof value === 'number') return element('span', {}, shownText(value, unit));
    if (typeof value !== 'object') return element('span', {}, String(value));
    if (Array.isArray(value)) return element('div', {}, ...value.map((each) => Report.tree(each, units, unit)));
    const columns = Object.values(value);
    if (columns.length && columns.every((column) => Array.isArray(column) && column.every((each) => typeof each !== 'object' || each === null)))
      return Report.columns(value, units);
    return element('dl', {}, ...listOf(Object.entries(value).map(([name, each]) => [wordsOf(name), Report.tree(each, units, units[name])])));
  }

  /** A table of columns; both ends of a class are one column, and so are a mean and its error. */
  static columns(all, units) {
    const cells = Object.entries(all).filter(([name]) => !(/(^|_)to$/.test(name) || name.endsWith('_stderr'))).map(([name, column]) => {
      const [unit, scale] = shownUnit(units[name] || '');
      const [ends, errors] = [all[name.replace(/from$/, 'to')], all[name + '_stderr']];
      const isClass = name.endsWith('from') && ends;
      return [wordsOf(isClass ? name.replace(/_?from$/, '') || 'class' : name) + (unit ? ` [${unit}]` : ''), column.map((value, k) =>
        isClass ? rangeText(scale * value, scale * ends[k])
          : errors ? withError(value, errors[k], '', scale) : quantity(value === null ? null : scale * value))];
    });
    const table = element('table');
    fillTable(table, cells.map(([head]) => head), cells[0][1].map((_, k) => cells.map(([, column]) => column[k])));
    return table;
  }

  showCommands() {
    const {commands, commands_taken: taken} = this.run;
    byId('commands-section').hidden = !commands.length;
    fillTable(byId('commands'), ['time', 'command'], commands.map(({time, text}) => [seconds(time), text]));
    if (taken > commands.length)
      byId('commands-section').append(element('p', {class: 'note'}, `The first ${commands.length} of ${taken} commands.`));
  }

  showProvenance() {
    const {scene, warnings, motion} = this.run;
    byId('warnings').append(...warnings.map((warning) => element('p', {class: 'warning'}, 'Warning: ' + warning)));
    const entries = [['Scene hash', scene.hash], ['Seed', String(scene.seed)], ['Version', scene.version],
      ['Plan', this.run.plan], ['Shown', Report.thinningText(motion, this.times)]];
    if (this.results.not_recorded.length) entries.push(['Not recorded', this.results.not_recorded.join(', ')]);
    byId('provenance').append(...listOf(entries));
    addScene(byId('provenance-section'), scene.yaml);
  }

  /** What is shown of the motion, and how. @param {number} end of the run */
  static motionText(motion, times, end) {
    const cut = motion.cut ? `Of ${seconds(end)} the first ${seconds(times[motion.frames - 1])} are shown: a larger file ` +
      '(--html-size) has more. ' : '';
    return `${cut}Between the ${motion.frames} frames shown, disks fly on parabolas that fit the recorded positions and ` +
      'velocities; between frames far apart they go straight on. Where a disk met others in between, its path is one of ' +
      'several possible ones.';
  }

  static thinningText(motion, times) {
    const {frames} = motion;
    if (!frames) return 'no disks: their positions were not recorded';
    const span = times[frames - 1] - times[0];
    const rate = span > 0 ? `, ${quantity((frames - 1) / span, '', 3)} a second` : '';
    const until = motion.cut ? `, until ${seconds(times[frames - 1])}` : '';
    const which = motion.every > 1 || motion.cut ? `one frame of ${motion.every}${motion.cut ? '' : ', and the last'}: ${frames} of ${motion.taken} recorded frames`
      : `all ${frames} recorded frames`;
    const disks = motion.disk_every > 1 ? ` One disk of ${motion.disk_every} is shown: the disks do not see each other.` : '';
    return `${which}${rate}${until}; positions to ${quantity(motion.position_unit * 1e6, '\u00b5m', 2)}.${disks}`;
  }
}
