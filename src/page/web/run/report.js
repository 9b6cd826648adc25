/** The results of a run, its commands, and where it comes from. */
class Report {
  constructor(run, times, hasBins) {
    this.run = run;
    this.times = times;
    this.hasBins = hasBins;
    this.results = run.results;
  }

  show() {
    document.title = `${this.run.title} \u2013 ratchet_sieve`;
    byId('title').textContent = this.run.title;
    const results = this.results;
    byId('origin').textContent = `Ratchet sieve, ${quantity(results.start_time, '', 6)} s to ` +
      `${quantity(results.simulated_time, 's', 6)}, seed ${this.run.scene.seed}, ratchet_sieve ${this.run.scene.version}`;
    this.showResults();
    this.showCommands();
    this.showProvenance();
  }

  showResults() {
    const results = this.results;
    const by = results.species.some((species) => species.engine_mean_vx !== null) ? 'engine_' : '';
    const columns = [['species', (species, k) => marked(species.name, k)],
      ['disks', (species) => quantity(species.count, '', 15)],
      ['\u27e8V_x\u27e9', (species) => withError(species[by + 'mean_vx'], species[by + 'mean_vx_stderr'], 'mm/s', MM)],
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
      ...this.steadyRows(), ['short to long slope', ratio(results.short_to_long)], ['largest overlap', quantity(results.max_overlap, 'm')]];
    if (results.collisions)
      whole.push(['contacts', Object.entries(results.collisions)
        .map(([kind, count]) => `${kind.replace('_', ' ')} ${count}`).join(', ')]);
    byId('more-results').append(element('dl', {}, ...whole.flatMap(([name, text]) =>
      [element('dt', {}, name), element('dd', {}, text)])));
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
      'not_recorded', 'species', 'quality', 'processed', 'purity', 'recovery', 'collisions', 'max_overlap', 'short_to_long',
      'steady_reason']);
    for (const [name, value] of Object.entries(this.results)) {
      if (shown.has(name)) continue;
      const title = name.replaceAll('_', ' ');
      byId('more-results').append(element('details', {}, element('summary', {}, title),
        element('div', {class: 'table', tabindex: '0', role: 'group', 'aria-label': title}, Report.tree(value))));
    }
  }

  /** Any value as nested lists and tables. */
  static tree(value) {
    if (value === null || typeof value === 'number') return element('span', {}, quantity(value));
    if (typeof value !== 'object') return element('span', {}, String(value));
    if (Array.isArray(value)) {
      if (value.every((each) => each === null || typeof each === 'number'))
        return element('span', {}, value.map((each) => quantity(each)).join(', '));
      return element('div', {}, ...value.map((each) => Report.tree(each)));
    }
    const columns = Object.values(value);
    if (columns.length && columns.every((column) => Array.isArray(column) && column.length === columns[0].length &&
        column.every((each) => each === null || typeof each === 'number'))) {
      const table = element('table');
      fillTable(table, Object.keys(value), columns[0].map((_, k) => columns.map((column) => quantity(column[k]))));
      return table;
    }
    return element('dl', {}, ...Object.entries(value).flatMap(([name, each]) =>
      [element('dt', {}, name.replaceAll('_', ' ')), element('dd', {}, Report.tree(each))]));
  }

  showCommands() {
    const commands = this.run.commands;
    if (!commands.length) {
      byId('commands-section').hidden = true;
      return;
    }
    fillTable(byId('commands'), ['time', 'command'], commands.map((command) =>
      [seconds(command.time), element('span', {}, command.text)]));
    if (this.run.commands_taken > commands.length)
      byId('commands-section').append(element('p', {class: 'note'},
        `The first ${commands.length} of ${this.run.commands_taken} commands.`));
  }

  showProvenance() {
    const {scene, warnings, motion} = this.run;
    if (warnings.length)
      byId('warnings').append(...warnings.map((warning) => element('p', {class: 'warning'}, 'Warning: ' + warning)));
    const entries = [['Scene hash', scene.hash], ['Seed', String(scene.seed)], ['Version', scene.version],
      ['Plan', this.run.plan], ['Shown', Report.thinningText(motion, this.times)]];
    if (this.results.not_recorded.length) entries.push(['Not recorded', this.results.not_recorded.join(', ')]);
    byId('provenance').append(...entries.flatMap(([name, text]) => [element('dt', {}, name), element('dd', {}, text)]));
    byId('scene').textContent = scene.yaml;
    copyOnClick(byId('copy-scene'), () => this.run.scene.yaml, byId('scene'));
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
