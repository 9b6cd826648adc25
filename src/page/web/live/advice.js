const ADVICE_TIME = 20;    // of a run [s]
const ADVICE_SEEDS = 4;    // per setting
const ADVICE_STEPS = {inclination: 0.02, frequency: 1.5, amplitude: 0.0002};  // from the present setting [rad, Hz, m]
const MOST_WORKERS = 4;
const T_OF_SIX = 3.863;    // Student's distribution, 6 degrees of freedom: both tails of 0.05 over six settings

function meanAndVariance(values) {
  const mean = values.reduce((sum, value) => sum + value, 0) / values.length;
  return [mean, values.reduce((sum, value) => sum + (value - mean) ** 2, 0) / (values.length - 1)];
}

/** Runs settings around the present one with fresh seeds, and says which sorts better. */
class Advice {
  constructor(page) {
    this.page = page;
    this.workers = [];
    byId('advise').addEventListener('click', () => this.workers.length ? this.say('') : this.begin());
  }

  /** Ends all runs. */
  say(text) {
    for (const {worker} of this.workers) worker.terminate();
    this.workers = [];
    byId('advise').textContent = 'Which way is better?';
    byId('advised').textContent = text;
  }

  /** The present setting and its neighbours: their setpoints and what differs. */
  settings() {
    const {quantities} = this.page.settings.offered;
    const now = quantities.map(({name}) => this.page.run.readings.base['commanded_' + name]);
    const near = quantities.flatMap(({name, unit, min, max}, k) => [1, -1].map((way) => way * ADVICE_STEPS[name])
      .filter((step) => min <= now[k] + step && now[k] + step <= max).map((step) => ({
        setpoints: now.with(k, now[k] + step),
        text: `${shownText(Math.abs(step), unit)} ${step > 0 ? 'more' : 'less'} ${name}`,
      })));
    return [{setpoints: now}, ...near].map((each) => ({...each, separations: []}));
  }

  async begin() {
    const {settings: run} = this.page;
    const fastest = run.offered.quantities.map((quantity) => quantity.fastest);
    const tried = this.settings();
    const jobs = tried.flatMap((setting) => Array.from({length: ADVICE_SEEDS}, (_, k) => ({setting, seed: run.seed + 1000 + k})));
    const whole = jobs.length;
    const count = Math.min(MOST_WORKERS, Math.max(1, (navigator.hardwareConcurrency || 2) - 1));
    byId('advise').textContent = 'Stop';
    const workers = await Promise.all(Array.from({length: count}, () => EngineWorker.compiled()));
    if (this.page.settings !== run || this.workers.length) return workers.forEach(({worker}) => worker.terminate());
    this.workers = workers;
    await Promise.all(workers.map(async (worker) => {
      for (let job = jobs.pop(); job && this.workers === workers; job = jobs.pop()) {
        byId('advised').textContent = `${whole - jobs.length} of ${whole} runs of ${ADVICE_TIME} s`;
        const schedule = [[0, 'slew', ...fastest], ...job.setting.setpoints.map((value, k) => [0, 'command', k, value])];
        await worker.open({...run, seed: job.seed, schedule}, 0);
        const {readings} = await worker.ask('advance', {to: ADVICE_TIME});
        job.setting.separations.push(readings ? readings.separation : null);
      }
    }));
    if (this.workers === workers) this.say(Advice.text(tried));
  }

  /** @param {Array<{text: string, separations: Array<?number>}>} tried the present setting first */
  static text(tried) {
    if (tried.some(({separations}) => separations.includes(null)))
      return `Within ${ADVICE_TIME} s a kind has not begun to leave in some runs: nothing can be said.`;
    const [now, variance] = meanAndVariance(tried[0].separations);
    const way = now < 0 ? -1 : 1;  // the better way is on with the present sides
    const gains = tried.slice(1).map(({text, separations}) => {
      const [mean, own] = meanAndVariance(separations);
      return {text, mean, gain: way * (mean - now), error: T_OF_SIX * Math.sqrt((variance + own) / ADVICE_SEEDS)};
    });
    const best = gains.reduce((one, other) => other.gain - other.error > one.gain - one.error ? other : one);
    const [from, to, gain, error] = [Math.abs(now), way * best.mean, best.gain, best.error].map((value) => value.toFixed(2).replace('-', '\u2212'));
    return `${best.gain > best.error ? '' : 'None is surely better. '}${best.text}: ${from} \u2192 ${to}, ${best.gain < 0 ? '' : '+'}${gain} \u00b1 ${error} ` +
      `in |s| (95 % for all ${gains.length} neighbours; ${ADVICE_SEEDS} fresh seeds of ${ADVICE_TIME} s each)`;
  }
}
