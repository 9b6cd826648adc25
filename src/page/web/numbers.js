/** What is shown in place of a value that is not defined. */
const UNDEFINED = 'undefined';

/** A value, or null, to so many significant digits, with its unit. */
function quantity(value, unit = '', digits = 4) {
  if (value === null || value === undefined) return UNDEFINED;
  const text = Math.abs(value) >= 1e6 || (value !== 0 && Math.abs(value) < 1e-4)
    ? value.toExponential(digits - 1) : String(Number(value.toPrecision(digits)));
  return text.replace('-', '\u2212') + (unit ? '\u00a0' + unit : '');
}

/** Q, P and shares, to three decimals. */
function ratio(value) {
  return value === null || value === undefined ? UNDEFINED : value.toFixed(3);
}

/** A value and its standard error. */
function withError(value, error, unit, scale = 1) {
  if (value === null || value === undefined) return UNDEFINED;
  if (error === null || error === undefined) return quantity(value * scale, unit) + ', error ' + UNDEFINED;
  if (error === 0) return `${quantity(value * scale)} \u00b1 0${unit ? '\u00a0' + unit : ''}`;
  const decimals = Math.max(0, Math.min(12, 1 - Math.floor(Math.log10(Math.max(error * scale, 1e-12)))));
  return `${(value * scale).toFixed(decimals)} \u00b1 ${(error * scale).toFixed(decimals)}${unit ? '\u00a0' + unit : ''}`.replace('-', '\u2212');
}

/** A time to the millisecond. */
function seconds(time) {
  return time.toFixed(3) + '\u00a0s';
}

/** The place of the last number that is not above `value` in ascending numbers; -1: there is none. */
function lastNotAbove(numbers, value) {
  let from = 0;
  let to = numbers.length;
  while (from < to) {
    const middle = (from + to) >> 1;
    if (numbers[middle] <= value) from = middle + 1; else to = middle;
  }
  return from - 1;
}
