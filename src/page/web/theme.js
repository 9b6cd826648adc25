/** Okabe and Ito's colours, which colour-blind readers can tell apart; as in the other pictures and in RViz. */
const PALETTE = ['#0072B2', '#D55E00', '#009E73', '#CC79A7', '#E69F00', '#56B4E9'];

function colourOf(k) {
  return PALETTE[k % PALETTE.length];
}

/** A colour of the style sheet, such as --line. */
function themeColour(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}

/** Calls back when the colours change: light, dark, print. */
function onThemeChange(callback) {
  for (const query of ['(prefers-color-scheme: dark)', 'print']) matchMedia(query).addEventListener('change', callback);
}
