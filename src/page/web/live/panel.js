const SYMBOLS = {inclination: '\u03b8', frequency: 'f', amplitude: 'A'};
const SCALES = {m: [1e3, 'mm']};  // in which a setpoint is shown

/** A setpoint as it is shown. */
function setpointText(value, unit) {
  const [scale, shown] = SCALES[unit] || [1, unit];
  return quantity(value * scale, shown);
}

/** A power of ten that divides a range into 1000 steps or more. */
function stepOf(range) {
  return 10 ** (Math.floor(Math.log10(range)) - 3);
}

/** What the user sets and reads beside the picture. */
class Panel {
  constructor(page) {
    this.page = page;
    byId('scene-name').append(...page.scenes.map((scene) => element('option', {}, scene.name)));
    const on = (id, event, action) => byId(id).addEventListener(event, action);
    on('scene-name', 'change', () => page.openScene(byId('scene-name').value));
    on('restart', 'click', () => page.restart(this.asked()));
    on('another', 'click', () => page.restart({...this.asked(), seed: page.settings.seed + 1}));
    for (const id of ['seed', 'feed-rate']) on(id, 'change', () => page.restart(this.asked()));
    on('step', 'click', () => page.step());
    on('pour', 'click', () => this.pour());
    copyOnClick(byId('copy-link'), () => {
      byId('link').textContent = page.link();
      return byId('link').textContent;
    }, byId('link'));
    copyOnClick(byId('copy-python'), () => {
      page.showProgram();
      byId('program').open = true;
      return byId('python').textContent;
    }, byId('python'));
    on('program', 'toggle', () => page.showProgram());
    byId('copy-link').hidden = location.protocol === 'about:';  // in a notebook
  }

  /** Seed and feed as they stand in their fields, where they are legal. */
  asked() {
    const [seed, feedRate] = ['seed', 'feed-rate'].map((id) => [byId(id).reportValidity(), Number(byId(id).value)]);
    return {...seed[0] ? {seed: seed[1]} : {}, ...this.page.settings.feedRate > 0 && feedRate[0] ? {feedRate: feedRate[1]} : {}};
  }

  pour() {
    if (byId('pour-count').reportValidity())
      this.page.player.ask('order', {order: ['pour', byId('pour-species').selectedIndex, Number(byId('pour-count').value)]});
  }

  showSettings({offered, seed, feedRate}) {
    byId('scene-name').value = offered.name;
    byId('seed').value = String(seed);
    byId('feed').hidden = !(offered.feed_rate > 0);
    byId('feed-rate').value = String(feedRate || 1);
    byId('pour-species').replaceChildren(...offered.machine.species.map((species) => element('option', {}, species.name)));
    byId('origin').textContent = `The engine of ratchet_sieve ${this.page.version} runs in this page. ${offered.warnings.join(' ')}`;
    this.firstSlews = offered.quantities.map((each) => each.slew_rate);
    this.sliders = offered.quantities.map((each, k) => this.sliderOf(each, k));
    byId('setpoints').replaceChildren(...this.sliders.map((slider) => slider.label));
  }

  /**
   * A slider and its slew rate. While it moves it gives a command now and then, and the last value for certain. Else it
   * follows the setpoint, which the commands of a link change too.
   */
  sliderOf({name, unit, min, max, slew_rate: slew, slowest, fastest}, k) {
    const input = element('input', {type: 'range', id: 'set-' + name, min, max, step: stepOf(max - min)});
    const output = element('output', {for: 'set-' + name});
    const rate = element('input', {type: 'number', min: slowest, max: fastest, step: 'any', value: slew});
    let given = null;
    let givenAt = 0;
    let unanswered = 0;
    const showValue = (value) => {
      output.textContent = setpointText(value, unit);
      input.setAttribute('aria-valuetext', output.textContent);
    };
    const give = async () => {
      [given, givenAt] = [Number(input.value), performance.now()];
      ++unanswered;
      await this.page.player.ask('order', {order: ['command', k, given]});
      --unanswered;
      this.page.fit();
    };
    input.addEventListener('input', () => {
      showValue(Number(input.value));
      if (performance.now() - givenAt > SETPOINT_PERIOD) give();
    });
    input.addEventListener('change', () => {
      if (Number(input.value) !== given) give();
    });
    rate.addEventListener('change', () => {
      if (!rate.reportValidity()) return;
      const slews = this.slews.map((each, i) => i === k ? Number(rate.value) : each);
      this.page.player.ask('order', {order: ['slew', ...slews]});
    });
    const show = (setpoint, slewRate) => {
      if (document.activeElement !== rate) rate.value = String(slewRate);
      if (unanswered || setpoint === given) return;
      given = setpoint;
      input.value = String(setpoint);
      showValue(setpoint);
    };
    const label = element('div', {class: 'setpoint'}, element('label', {for: 'set-' + name}, `${name} ${SYMBOLS[name]}`), input, output,
      element('label', {class: 'slew'}, 'slew rate ', rate, ` ${unit}/s`));
    return {label, name, show};
  }

  show({events, separation, base}, schedule, disks, factor) {
    const [, , ...slews] = schedule.filter(([, name]) => name === 'slew').pop() || [];
    this.slews = slews.length ? slews : this.firstSlews;
    this.sliders.forEach(({name, show}, k) => show(base['commanded_' + name], this.slews[k]));
    byId('separation').value = ratio(separation).replace('-', '\u2212');
    byId('disks').value = String(disks);
    byId('events').value = quantity(events, '', 6);
    byId('factor').value = factor === null ? '' : quantity(factor, '\u00d7 real time', 3);
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
