/** The run as others can repeat it: settings in a link, and a program. */

/** Of a command, whose first letter stands in a link: how many numbers may follow, and how many of them are whole. See Engine.order(). */
const COMMANDS = {command: {counts: [2], whole: 1}, slew: {counts: [3], whole: 0}, pour: {counts: [2, 4], whole: 2}};
const MARK = '#run=';   // before the settings of a link
const PER_SECOND = 1e3;  // commands are given at whole milliseconds: src/web/session.js

function isCommand([name, ...values]) {
  if (!Object.hasOwn(COMMANDS, name)) return false;
  const {counts, whole} = COMMANDS[name];
  return counts.includes(values.length) &&
    values.every((value, k) => k < whole ? Number.isSafeInteger(value) : Number.isFinite(value));
}

/**
 * The settings that a link's fragment holds; null: it is none of this page's. A program is made of them: they are to be
 * numbers. @throws {Error} of what is no such link
 */
async function settingsOfLink(fragment, scenes) {
  if (!fragment.startsWith(MARK)) return null;
  const bytes = bytesOf(fragment.slice(MARK.length).replaceAll('-', '+').replaceAll('_', '/'));
  const [name, seed, feedRate, rows] = JSON.parse(new TextDecoder().decode(await inflated(bytes)));
  const offered = scenes.find((scene) => scene.name === name);
  if (!offered) throw new Error(`there is no scene ${name} in this page`);
  let at = 0;
  const schedule = rows.map(([wait, letter, ...values]) => [(at += wait) / PER_SECOND,
    Object.keys(COMMANDS).find((name) => name[0] === letter), ...values]);
  if (!Number.isSafeInteger(seed) || seed < 0 || !Number.isFinite(feedRate) ||
      !rows.every(([wait]) => Number.isSafeInteger(wait) && wait >= 0) || !schedule.every(([, ...order]) => isCommand(order)))
    throw new Error('seed, feed or commands are not as this page writes them');
  return {offered, seed, feedRate, schedule};
}

async function fragmentOf({offered, seed, feedRate}, schedule) {
  const at = schedule.map(([time]) => Math.round(time * PER_SECOND));
  const rows = schedule.map(([, [letter], ...values], k) => [at[k] - (at[k - 1] || 0), letter, ...values]);
  const bytes = await deflated(new TextEncoder().encode(JSON.stringify([offered.name, seed, feedRate, rows])));
  return MARK + btoa(String.fromCharCode(...bytes)).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
}

/** A command as a line of Python. @param {Array} order see Engine.order() */
function pythonOf([name, ...values], offered) {
  if (name === 'command') return `simulation.command(${offered.quantities[values[0]].name}=${values[1]})`;
  if (name === 'slew') return `simulation.set_slew_rates(${offered.quantities.map((each, k) => `${each.name}=${values[k]}`).join(', ')})`;
  const [species, count, ...between] = values;
  return `simulation.pour(${species}, ${count}${between.length ? `, between=(${between.join(', ')})` : ''})`;
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
