const CHART_HEIGHT = 170;  // if a chart does not say

/** A range of the axis around these numbers, also where they are all the same. */
function padded(low, high) {
  if (low === null || high === null) return [0, 1];
  const span = high > low ? high - low : Math.max(0.2 * Math.abs(high), 0.02);
  return [low - 0.06 * span, high + 0.06 * span];
}

/**
 * A chart over a common axis.
 * @param {HTMLElement} parent
 * @param {{title: string, x: Object, y: Object, series: Array<Object>, bands: Array<Object>, data: Array}} chart
 *   options of uPlot; series without the one of x. It may have a height, a padding, and draw(), which draws over it
 * @param {{sync: string, onClick: function(number, number), mark: function(): ?number}} common
 *   the key of the charts whose cursors are one, what a click at x and y does, and where a line marks the present x
 * @return {{redraw: function(), rebuild: function(), update: function(Array), resize: function(), remove: function()}}
 */
function addChart(parent, chart, common) {
  const box = element('div', {class: 'chart'}, element('h3', {}, chart.title));
  parent.append(box);
  const place = element('div', {role: 'img', 'aria-label': chart.title + '. ' + (chart.summary || '')});
  box.append(place);
  const height = chart.height || CHART_HEIGHT;
  let plot = null;

  function build() {
    if (plot) plot.destroy();
    const axis = {stroke: themeColour('--quiet'), grid: {stroke: themeColour('--line'), width: 1},
      ticks: {stroke: themeColour('--line'), width: 1}};
    plot = new uPlot({
      width: Math.max(200, parent.clientWidth),
      height,
      padding: chart.padding,
      scales: {x: {time: false, ...chart.x.scale}, y: chart.y.scale || {range: (u, low, high) => padded(low, high)}},
      axes: [{...axis, label: chart.x.label, labelSize: 18, size: 34, ...chart.x.axis},
        {...axis, label: chart.y.label, labelSize: 18, size: 58}],
      series: [{label: chart.x.name, value: (u, v) => v === null ? '' : quantity(v, chart.x.unit, 6), ...chart.x.series},
        ...chart.series.map((each) => ({width: 1.6, points: {show: false},
          value: (u, v) => v === null ? UNDEFINED : quantity(v, chart.y.unit), ...each}))],
      bands: chart.bands || [],
      legend: {live: true, markers: {dash: (u, k) => u.series[k].dash ? 'dashed' : 'solid'}},
      cursor: {sync: {key: common.sync}, drag: {x: false, y: false}},
      hooks: {
        drawAxes: [(u) => drawMark(u, common.mark())],
        draw: chart.draw ? [chart.draw] : [],
        ready: [showValues, (u) => {
          u.over.addEventListener('click', () => {
            if (u.cursor.left >= 0) common.onClick(u.posToVal(u.cursor.left, 'x'), u.posToVal(u.cursor.top, 'y'));
          });
          u.over.addEventListener('mouseleave', () => showValues(u));
        }],
      },
    }, chart.data, place);
  }

  function drawMark(u, x) {
    if (x === null) return;
    const left = u.valToPos(x, 'x', true);
    u.ctx.save();
    u.ctx.setLineDash([]);
    u.ctx.strokeStyle = themeColour('--accent');
    u.ctx.lineWidth = 2 * devicePixelRatio;
    u.ctx.beginPath();
    u.ctx.moveTo(left, u.bbox.top);
    u.ctx.lineTo(left, u.bbox.top + u.bbox.height);
    u.ctx.stroke();
    u.ctx.restore();
  }

  /** The legend shows the values at the cursor or, without one, at the mark. */
  function showValues(u) {
    const mark = common.mark();
    if (mark !== null && !(u.cursor.left >= 0)) u.setLegend({idx: Math.max(0, lastNotAbove(chart.data[0], mark))}, false);
  }

  function redraw() {
    showValues(plot);
    plot.redraw(false, false);
  }

  build();
  return {
    redraw,
    rebuild: build,
    update: (data) => {
      chart.data = data;
      plot.setData(data);
      showValues(plot);
    },
    resize: () => plot.setSize({width: Math.max(200, parent.clientWidth), height}),
    remove: () => {
      plot.destroy();
      box.remove();
    },
  };
}
