const SETPOINT_PERIOD = 200;  // between two commands while a slider moves [ms]

/**
 * A slider of a commanded quantity. While it moves it gives a command now and then, and the last value for certain. Else
 * it follows the setpoint, which the commands of a link change too.
 */
class Slider {
  /** @param {Object} quantity as the page has it @param {function(number): Promise} give commands a value */
  constructor(prefix, {name, unit, min, max}, give) {
    [this.unit, this.give] = [unit, give];
    const id = prefix + name;
    const step = 10 ** (Math.floor(Math.log10(max - min)) - 3);  // of a range 1000 or more
    this.input = element('input', {type: 'range', id, min, max, step});
    this.output = element('output', {for: id});
    this.given = null;
    this.givenAt = this.unanswered = 0;
    this.input.addEventListener('input', () => {
      this.showValue(Number(this.input.value));
      if (performance.now() - this.givenAt > SETPOINT_PERIOD) this.giveValue();
    });
    this.input.addEventListener('change', () => {
      if (Number(this.input.value) !== this.given) this.giveValue();
    });
    this.part = element('div', {class: 'setpoint'}, element('label', {for: id}, name + ' ', symbol(COMMANDED[name][0])), this.output, this.input);
  }

  showValue(value) {
    this.output.textContent = shownText(value, this.unit);
    this.input.setAttribute('aria-valuetext', this.output.textContent);
  }

  async giveValue() {
    [this.given, this.givenAt] = [Number(this.input.value), performance.now()];
    ++this.unanswered;
    await this.give(this.given);
    --this.unanswered;
  }

  show(setpoint) {
    if (this.unanswered || setpoint === this.given) return;
    this.given = setpoint;
    this.input.value = String(setpoint);
    this.showValue(setpoint);
  }
}
