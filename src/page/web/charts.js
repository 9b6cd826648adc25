const CHART_HEIGHT = 170;  // if a chart does not say

/** The least and the greatest of numbers; null, null: there are none. */
function rangeOf(numbers) { return [Math.min, Math.max].map((better) => numbers.length ? numbers.reduce((a, b) => better(a, b)) : null); }

/** A range of the axis around these numbers, also where they are all the same. */
function padded(low, high) {
  if (low === null || high === null) return [0, 1];
  const span = high > low ? high - low : Math.max(0.2 * Math.abs(high), 0.02);
  return [low - 0.06 * span, high + 0.06 * span];
}

/** Numbers at an axis, with the decimals that their distance has. */
function tickTexts(u, splits, axis, space, distance) {
  const decimals = distance.toFixed(12).replace(/0+$/, '').split('.')[1].length;
  return splits.map((value) => value === null ? '' : value.toFixed(decimals).replace(/^-(?=.*[1-9])/, '\u2212').replace(/^-/, ''));
}

/**
 * A chart over a common axis.
 * @param {HTMLElement} parent
 * @param {{title: string, x: Object, y: Object, series: Array<Object>, bands: Array<Object>, data: Array}} chart
 *   options of uPlot; series without the one of x. It may have a height, a padding, and draw(), which draws over it
 * @param {{sync: string, onClick: function(number, number), mark: function(): number}} common
 *   the key of the charts whose cursors are one, what a click at x and y does, and where a line marks the present x
 * @return {{redraw: function(), update: function(Array), resize: function(), remove: function()}}
 */
function addChart(parent, chart, common) {
  const box = element('div', {class: 'chart'}, element('h3', {}, chart.title));
  parent.append(box);
  const place = element('div', {role: 'img', 'aria-label': chart.title});
  box.append(place);
  const line = () => themeColour('--line');
  const axis = {values: tickTexts, stroke: () => themeColour('--quiet'), grid: {stroke: line, width: 1}, ticks: {stroke: line, width: 1}};
  const size = () => ({width: Math.max(200, parent.clientWidth), height: chart.height || CHART_HEIGHT});
  const mark = element('div', {class: 'present'});

  /** Without a cursor the legend shows the values at the mark. */
  function showMark(u) {
    const x = common.mark();
    mark.style.left = u.valToPos(x, 'x') + 'px';
    if (!(u.cursor.left >= 0)) u.setLegend({idx: Math.max(0, lastNotAbove(u.data[0], x))}, false);
  }

  const plot = new uPlot({
    ...size(),
    padding: chart.padding,
    scales: {x: {time: false, ...chart.x.scale}, y: chart.y.scale || {range: (u, low, high) => padded(low, high)}},
    axes: [{...axis, label: chart.x.label, labelSize: 18, size: 34, ...chart.x.axis},
      {...axis, label: chart.y.label, labelSize: 18, size: 58}],
    series: [{label: chart.x.name, value: (u, v) => v === null ? '' : quantity(v, chart.x.unit, 6), ...chart.x.series},
      ...chart.series.map((each) => ({width: 1.6, points: {show: false},
        value: (u, v) => v === null ? UNDEFINED : quantity(v, chart.y.unit), ...each}))],
    bands: chart.bands || [],
    legend: {live: true, markers: {dash: (u, k) => !u.series[k].dash ? 'solid' : u.series[k].dash[0] < 2 ? 'dotted' : 'dashed'}},
    cursor: {sync: {key: common.sync}, drag: {x: false, y: false}},
    hooks: {draw: [...chart.draw ? [chart.draw] : [], showMark]},
  }, chart.data, place);
  plot.under.append(mark);
  plot.over.addEventListener('click', () => {
    if (plot.cursor.left >= 0) common.onClick(plot.posToVal(plot.cursor.left, 'x'), plot.posToVal(plot.cursor.top, 'y'));
  });
  plot.over.addEventListener('mouseleave', () => showMark(plot));

  return {
    redraw: () => plot.redraw(false, false),
    update: (data) => plot.setData(data),
    resize: () => plot.setSize(size()),
    remove: () => {
      plot.destroy();
      box.remove();
    },
  };
}
