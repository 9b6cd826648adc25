/** The run as others can repeat it: settings in a link, and a program. */

/** Of a command: how many numbers follow its name, and how many of them are whole. See Engine.order(). */
const NUMBERS_OF = {command: [2, 1], slew: [3, 0], pour: [2, 2]};

function isCommand([name, ...values]) {
  if (!Object.hasOwn(NUMBERS_OF, name)) return false;
  const [count, whole] = NUMBERS_OF[name];
  return values.length === count &&
    values.every((value, k) => k < whole ? Number.isSafeInteger(value) : Number.isFinite(value));
}

/**
 * The settings that a link's fragment holds; null: none. A program is made of them: they are to be numbers.
 * @throws {Error} of what is no such link
 */
function settingsOfLink(fragment, scenes) {
  if (fragment.length < 2) return null;
  const settings = JSON.parse(decodeURIComponent(fragment.slice(1)));
  const offered = scenes.find((scene) => scene.name === settings.scene);
  if (!offered) throw new Error(`there is no scene ${settings.scene} in this page`);
  const isTime = (time, k, times) => Number.isFinite(time) && time >= (k ? times[k - 1] : 0);
  const {seed, feedRate, schedule} = settings;
  if (!Number.isSafeInteger(seed) || seed < 0 || !Number.isFinite(feedRate) || !Array.isArray(schedule) ||
      !schedule.map(([time]) => time).every(isTime) || !schedule.every(([, ...order]) => isCommand(order)))
    throw new Error('seed, feed or commands are not as this page writes them');
  return {offered, seed, feedRate, schedule};
}

function fragmentOf({offered, seed, feedRate}, schedule) {
  return '#' + encodeURIComponent(JSON.stringify({scene: offered.name, seed, feedRate, schedule}));
}

/** A command as a line of Python. @param {Array} order see Engine.order() */
function pythonOf([name, ...values], offered) {
  switch (name) {
    case 'command': return `simulation.command(${offered.quantities[values[0]].name}=${values[1]})`;
    case 'slew':
      return `simulation.set_slew_rates(${offered.quantities.map((each, k) => `${each.name}=${values[k]}`).join(', ')})`;
    default: return `simulation.pour(${values.join(', ')})`;
  }
}

/** A program that repeats the run up to a time, to the same bits. */
function programOf({offered, seed, feedRate}, schedule, time) {
  const overrides = [`"seed": ${seed}`, ...feedRate > 0 ? [`"feed.rate": ${feedRate}`] : []];
  const lines = ['import ratchet_sieve as rs', '', `scene = rs.Scene(r"""\n${offered.yaml.trim()}\n""", {${overrides.join(', ')}})`,
    'simulation = rs.Simulation(scene)'];
  let last = 0;
  for (const [at, ...order] of schedule) {
    if (at > last) lines.push(`simulation.advance_to(${at})`);
    lines.push(pythonOf(order, offered));
    last = at;
  }
  return [...lines, `simulation.advance_to(${time})`, 'print(simulation.summary)', ''].join('\n');
}
