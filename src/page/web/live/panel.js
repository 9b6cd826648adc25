/** What the user sets and reads beside the picture. */
class Panel {
  constructor(page) {
    this.page = page;
    listValues([['separation', 's', 'separation'], ['disks', '', 'disks'], ['events', '', 'events']]);
    byId('scene-name').append(...page.scenes.map(({name, title}) => element('option', {value: name}, title)));
    byId('about').textContent = `The engine of ratchet_sieve ${page.version} runs in this page, as in the programs: ` +
      'the same scene, seed and commands give the same bits.';
    const on = (id, event, action) => byId(id).addEventListener(event, action);
    on('scene-name', 'change', () => page.openScene(byId('scene-name').value));
    on('restart', 'click', () => page.restart(this.asked()));
    on('another', 'click', () => page.restart({...this.asked(), seed: page.settings.seed + 1}));
    on('own', 'click', () => page.restart({...this.asked(), schedule: []}));
    for (const id of ['seed', 'feed-rate']) on(id, 'change', () => page.restart(this.asked()));
    on('step', 'click', () => page.step());
    on('pour', 'click', () => this.pour());
    on('panel', 'toggle', () => page.fit());
    copyOnClick(byId('copy-link'), async () => {
      byId('link').textContent = await page.link();
      return byId('link').textContent;
    }, byId('link'));
    copyOnClick(byId('copy-python'), () => {
      page.showProgram();
      byId('program').open = true;
      return byId('python').textContent;
    }, byId('python'));
    on('program', 'toggle', () => page.showProgram());
    byId('copy-link').hidden = location.protocol === 'about:';  // in a notebook
    byId('panel').open = innerWidth > 800 || innerHeight > innerWidth;
  }

  /** Seed and feed as they stand in their fields, where they are legal. */
  asked() {
    const [seed, feedRate] = ['seed', 'feed-rate'].map((id) => [byId(id).reportValidity(), Number(byId(id).value)]);
    return {...seed[0] ? {seed: seed[1]} : {}, ...this.page.settings.feedRate > 0 && feedRate[0] ? {feedRate: feedRate[1]} : {}};
  }

  /** @param {...number} between ends of a stretch of the base [m]; without them, the scene's */
  pour(...between) {
    if (byId('pour-count').reportValidity())
      this.page.order(['pour', byId('pour-species').selectedIndex, Number(byId('pour-count').value), ...between]);
  }

  showSettings({offered, seed, feedRate}) {
    byId('scene-name').value = offered.name;
    byId('seed').value = String(seed);
    byId('feed').hidden = !(offered.feed_rate > 0);
    byId('feed-rate').value = String(feedRate || 1);
    byId('advice').hidden = offered.machine.boundary !== 'open' || offered.machine.species.length !== 2;
    if (this.offered === offered) return;
    this.offered = offered;
    byId('title').textContent = offered.title;
    byId('origin').textContent = [offered.sentence, ...offered.warnings].join(' ');
    byId('pour-species').replaceChildren(...offered.machine.species.map((species) => element('option', {}, species.name)));
    this.sliders = offered.quantities.map((each, k) =>
      new Slider('set-', each, (value) => this.page.order(['command', k, value])));
    byId('setpoints').replaceChildren(...this.sliders.map(({part}) => part));
    this.rates = offered.quantities.map(({name, slowest, fastest}) =>
      element('input', {type: 'number', min: slowest, max: fastest, step: 'any', 'aria-label': `slew rate of the ${name}`}));
    byId('slews').replaceChildren(...this.rates.map((rate, k) => {
      rate.addEventListener('change', () => {
        if (rate.reportValidity()) this.page.order(['slew', ...this.slews.map((each, i) => i === k ? Number(rate.value) : each)]);
      });
      return element('label', {}, `slew rate ${COMMANDED[offered.quantities[k].name][0]} `, rate, ` ${offered.quantities[k].unit}/s`);
    }));
  }

  /** The setpoints and slew rates as they are, as commands at the start of another run. */
  commands() {
    const {quantities} = this.offered;
    const {base} = this.page.run.readings;
    const slews = quantities.some(({slew_rate: own}, k) => own !== this.slews[k]) ? [[0, 'slew', ...this.slews]] : [];
    return [...slews, ...quantities.map(({name, value}, k) => [value, [0, 'command', k, base['commanded_' + name]]])
      .filter(([own, [, , , now]]) => own !== now).map(([, command]) => command)];
  }

  show({events, separation, base}, schedule, disks, factor) {
    const [, , ...slews] = schedule.filter(([, name]) => name === 'slew').pop() || [];
    this.slews = slews.length ? slews : this.offered.quantities.map((each) => each.slew_rate);
    this.sliders.forEach((slider, k) => slider.show(base['commanded_' + this.offered.quantities[k].name]));
    this.rates.forEach((rate, k) => {
      if (document.activeElement !== rate) rate.value = String(this.slews[k]);
    });
    byId('separation').value = ratio(separation);
    byId('disks').value = String(disks);
    byId('events').value = quantity(events, '', 6);
    byId('factor').value = factor === null ? '' : quantity(factor, '\u00d7 real time', 2);
  }

  /** An error, which is read out, and what is wrong with the run. */
  say(error, readings) {
    let trouble = '';
    if (readings && readings.choke) {
      const {fed, left, layers} = readings.choke;
      trouble = `The base is choked: of ${fed} disks fed ${left} have left, and the layer has risen by ${quantity(layers, '', 3)} of the largest diameters.`;
    } else if (readings && readings.collapses > 0)
      trouble = `${quantity(readings.collapses)} inelastic collapses so far: the contacts of those disks were made elastic for a while.`;
    for (const [id, text] of [['said', error || ''], ['trouble', trouble]])
      if (byId(id).textContent !== text) byId(id).textContent = text;
  }
}
