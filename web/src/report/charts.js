// SPDX-License-Identifier: BSD-3-Clause
// Charts of curves, drawn by uPlot: ranges, ticks, marks, pointer, keys and legends.
import uPlot from 'uplot';
import {logarithmicTicks} from '../chart/logarithmic_axis.ts';
import {amplitudeRange, isWide} from './amplitude_range.ts';
import {amplitudeRule, frequency, frequencyWords, largestOf, multiple, number, reading, smallestOf, units, withUnit} from './report_data.ts';
import {inside} from './case_curves.ts';
import {amplitudeAt, inRange, nearestIndex} from './drawn_line.ts';
import {axisFactor, change, frequencyUnit, moveBy, view, zoomTo} from './view.js';

const isOnPaper = chart => Boolean(chart.width);  // low: the caption names the amplitude, the last number the unit
const FEW_POINTS = 24;  // so few points of a response are drawn as dots, because the line between them shows little

export const byId = id => document.getElementById(id);

export function html(tag, attributes, ...children) {
  const node = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes ?? {})) {
    if (name.startsWith('on')) node.addEventListener(name.slice(2), value);
    else if (value !== null && value !== undefined && value !== false) node.setAttribute(name, value);
  }
  node.append(...children.flat(Infinity).filter(child => child !== null && child !== undefined));
  return node;
}

// ---------------------------------------------------------------- ranges and ticks

/// The shown range of ω. A logarithmic axis cannot start at 0; it starts a decade below the lowest mode or peak.
export function frequencyRange(chart) {
  let [from, to] = view.zoom ?? chart.band;
  if (!(to > from)) [from, to] = [from * 0.9, from * 1.1 + 1e-9];
  if (view.xlog && from <= 0) {
    const lowest = smallestOf(chart.landmarks.filter(w => w > 1e-6 * to));
    from = Math.max(Math.min(lowest / 10, to / 100), to / 1e5);
  }
  return [from, to];
}

/// The amplitude that is exceeded over a twentieth of the range: the scale of a chart with infinite peaks.
function commonTop(points) {
  const pieces = points.slice(1).map((p, i) => [Math.max(p[1], points[i][1]), p[0] - points[i][0]]).filter(([height]) => height >= 0);
  let left = 0.05 * pieces.reduce((sum, p) => sum + p[1], 0);
  for (const [value, width] of pieces.sort((a, b) => b[0] - a[0])) if ((left -= width) <= 0) return value;
  return 0;
}

/// Highest drawn amplitude: curves with infinite peaks are cut off far above what they exceed commonly.
function ceilingOf(chart) {
  if (!chart.curves.some(c => c.peaks.some(p => p.unbounded))) return Infinity;
  return 1000 * largestOf(chart.curves.map(c => commonTop(inRange(c, ...chart.band)))) || Infinity;
}

/// Is the amplitude axis logarithmic?
const isLogarithmic = chart => view.ylog ?? chart.wide;
const shownCurves = chart => chart.curves.filter(c => !view.hidden.has(c.key));
const limitsOf = chart => chart.limits ?? shownCurves(chart).flatMap(c => c.limits.map(l => ({...l, label: c.label})));

/// Is the amplitude axis logarithmic unless the reader chooses? The program decides for a whole chart, its rule for a part of one.
export function suitsLogarithm(chart) {
  if (chart.phase) return false;
  const curves = shownCurves(chart), range = frequencyRange(chart);
  if (chart.logarithmic !== undefined && !view.zoom && curves.length === chart.curves.length) return chart.logarithmic;
  const isUnbounded = curves.some(c => c.peaks.some(p => p.unbounded && inside(p, range)));
  return isUnbounded || isWide(amplitudeRange(curves.map(c => inRange(c, ...range)), amplitudeRule), amplitudeRule);
}

/// Share of the height of a chart that the marks of modes on its upper edge and a circle below them need.
function roomOfMarks(chart) {
  const marks = 20, above = 10, axis = 24, label = isOnPaper(chart) ? 0 : 18;  // [px]
  return chart.modes.length ? marks / (chart.height - above - axis - label) : 0.057;
}

/// Range of the amplitude axis: all shown curves and peaks, and limits near them.
function amplitudeAxis(chart) {
  const range = frequencyRange(chart), curves = shownCurves(chart), lines = curves.map(c => inRange(c, ...range));
  const log = isLogarithmic(chart);
  const peaks = curves.flatMap(c => c.peaks).filter(p => inside(p, range));
  let largest = largestOf([...lines.map(line => largestOf(line.map(p => p[1]))), ...peaks.map(p => p.amplitude)]);
  if (peaks.some(p => p.unbounded))
    largest = Math.min(largest, chart.ceiling, log ? Infinity : 2 * largestOf(lines.map(commonTop)) || Infinity);
  const limits = limitsOf(chart).map(l => l.limit).filter(l => l <= largest * (log ? 100 : 3));
  const top = Math.max(largest, ...limits);
  if (!(top > 0)) return log ? [0.1, 1] : [0, 1];
  const room = roomOfMarks(chart);
  if (!log) return [0, top / (1 - room)];
  const {bottom} = amplitudeRange(lines, amplitudeRule), from = Math.min(bottom > 0 ? bottom / 1.6 : Infinity, top / 10);
  return [from, top * (top / from) ** (room / (1 - room))];
}

/// Phases of the curves: ±180°, or more in multiples of 90° for continuous phases.
export function phaseRange(curves) {
  const angles = curves.flatMap(c => c.phase).filter(v => v !== null);
  const low = Math.min(-180, Math.floor(smallestOf(angles) / 90 + 1e-9) * 90);
  return [low, Math.max(180, Math.ceil(largestOf(angles) / 90 - 1e-9) * 90)];
}
/// Range of the phase axis, with some space and that of the marks.
function phaseAxis(chart) {
  const [low, high] = chart.phase, room = roomOfMarks(chart), air = 0.02 * (high - low);
  return [low - air, high + Math.max(air, chart.modes.length ? (high - low) * room / (1 - room) : 0)];
}

/// Ticks of a logarithmic axis: those with numbers within a decade, only powers of ten on a crowded one.
/// @param length  of the axis [px]; lines closer than 2 px within a decade would be a grey area
function ticksOf(from, to, length) {
  const {lines, labelled} = logarithmicTicks(from, to), decades = Math.log10(to / from);
  if (decades < 1) return labelled;
  return length / decades < 44 ? lines.filter(tick => tick.toExponential().startsWith('1e')) : lines;
}
/// Labels of powers of ten, as many as there is room for, and of 2 and 5 times them on a short axis.
function logarithmicLabels(ticks, room) {
  const decades = Math.log10(ticks.at(-1) / ticks[0]), every = Math.ceil(decades / room);
  if (decades < 1) return ticks.map(tick => number(tick, 8));
  return ticks.map(tick => {
    const [digit, power] = tick.toExponential(0).split('e').map(Number);
    if (digit !== 1) return decades < room / 3 && [2, 5].includes(digit) ? number(tick, 8) : '';
    if (power % every) return '';
    if (power >= -3 && power <= 4) return number(tick, 8);
    return '10' + [...String(power)].map(sign => (sign === '-' ? '⁻' : '⁰¹²³⁴⁵⁶⁷⁸⁹'[sign])).join('');
  });
}

// ---------------------------------------------------------------- charts

/// Path of a phase within ±180°: it continues at the other edge, reached the short way.
function wrappedPath(u, curve, first, last) {
  const stroke = new Path2D(), [omega, angles] = [u.data[0], u.data[curve]];
  const across = i => u.valToPos(omega[i], 'x', true), up = angle => u.valToPos(angle, 'y', true);
  let before = null;  // index of the last point
  for (let i = first; i <= last; i++) {
    const angle = angles[i];
    if (angle !== null && before !== null && Math.abs(angle - angles[before]) > 180) {
      const edge = Math.sign(angles[before]) * 180, way = 360 - Math.abs(angle - angles[before]);
      const part = way > 0 ? Math.abs(edge - angles[before]) / way : 0.5;
      const middle = across(before) + part * (across(i) - across(before));
      stroke.lineTo(middle, up(edge));
      stroke.moveTo(middle, up(-edge));
    }
    if (angle !== null) before === null ? stroke.moveTo(across(i), up(angle)) : stroke.lineTo(across(i), up(angle));
    before = angle === null ? null : i;
  }
  return {stroke, fill: null, flags: 0};
}

function peakWords(peak, label) {
  const height = peak.unbounded ? 'unbounded (undamped)' : withUnit(peak.amplitude, peak.unit, 5);
  const lines = [`peak of ${label}: ${height}`, frequencyWords(peak.angular_frequency)];
  if (peak.ratio_to_static !== null) lines.push(`${reading(peak.ratio_to_static, 5)} × static`);
  if (peak.nearest_mode) lines.push(`nearest mode: ${peak.nearest_mode}`);
  return lines.join('\n');
}
/// Marks over a chart: modes as ticks on the upper edge, limits as lines, peaks as circles, infinite ones as lines.
function drawMarks(chart, u) {
  const range = frequencyRange(chart), {min, max} = u.scales.y, marks = [];
  const across = w => u.valToPos(w * axisFactor(), 'x'), up = value => u.valToPos(value, 'y');
  const add = (style, place, title, content) => marks.push(html('span', {class: style, style: place, title}, content));
  for (const m of chart.modes.filter(mode => inside(mode, range)))
    add('mode', `left:${across(m.angular_frequency)}px`,
        `mode ${m.number}, ${frequencyWords(m.angular_frequency)}\n${m.name}`);
  if (!chart.phase) {
    let outside = 0;
    for (const l of limitsOf(chart)) {
      const suited = multiple(l.limit, l.unit), shown = l.limit >= min && l.limit <= max;
      const words = ['limit', l.label, number(l.limit * suited.factor, 6), suited.unit].filter(Boolean).join(' ');
      if (shown) add(`limit${up(l.limit) < 20 ? ' below' : ''}`, `top:${up(l.limit)}px`, null, html('b', {}, words));
      else add('limit outside', `top:${26 + 15 * outside++}px`, null,
               html('b', {}, `${words} (${l.limit > max ? 'above' : 'below'} this picture)`));
    }
    for (const c of shownCurves(chart))
      for (const p of c.peaks.filter(peak => inside(peak, range))) {
        const place = `left:${across(p.angular_frequency)}px;color:${c.colour};`;
        if (p.unbounded) add('endless', place, peakWords(p, c.label), '∞');
        else if (p.amplitude >= min && p.amplitude <= max)
          add('peak', `${place}top:${up(p.amplitude)}px`, peakWords(p, c.label));
      }
  }
  chart.marks.replaceChildren(...marks);
  u.over.append(chart.marks);
}

/// Data for uPlot: frequencies in the unit of the axis, then one list for each curve.
function dataOf(chart) {
  const factor = axisFactor(), missing = v => v === null || (isLogarithmic(chart) && !(v > 0));
  const usable = v => (missing(v) ? null : Math.min(v, chart.ceiling));
  const values = c => (chart.phase ? c.phase : c.amplitude.map(usable));
  const lists = chart.curves.map(c => [c.omega.map(w => w * factor), values(c)]);
  return chart.joined ? uPlot.join(lists) : [lists[0][0], ...lists.map(list => list[1])];
}

/// Index of the point of a curve nearest to the cursor; a comparison has points that belong to other curves.
function nearestPoint(u, curve, index) {
  const values = u.data[curve];
  for (let step = 0; step < 200; step++)
    for (const i of [index - step, index + step]) if (values[i] !== undefined) return i;
  return index;
}

// Steps between ticks, from 1e-24 to 5e15.
const STEPS = [...Array(40).keys()].flatMap(k => [1, 2, 5].map(digit => Number(`${digit}e${k - 24}`)));
const FONT = '12px system-ui, "Segoe UI", "Liberation Sans", Arial, sans-serif';
const AXIS = {stroke: '#333', font: FONT, labelFont: FONT, gap: 4, labelSize: 18, labelGap: 0, incrs: STEPS,
              ticks: {show: false}, grid: {stroke: '#e2e2e2', width: 1}};

/// "displacement amplitude [mm]" in the unit that suits the shown range.
export function amplitudeWords(chart, u) {
  const {quantity} = units[chart.unit], name = quantity.includes(' ') ? quantity : `${quantity} amplitude`;
  const top = u.scales.y.max ?? amplitudeAxis(chart)[1];  // before the first drawing
  return `${name} [${multiple(top, chart.unit).unit}]`;
}
const frequencyLabel = () => (view.hz ? 'f [Hz]' : frequency?.label ?? 'ω [rad/s]');
/// Numbers of an axis, the last one with a unit: "5", "", "20 Hz".
function withUnitAtEnd(texts, unit) {
  const last = texts.findLastIndex(Boolean);
  return texts.map((text, i) => (i === last ? `${text} ${unit}` : text));
}
/// Frequency axis and amplitude or phase axis.
function axesOf(chart) {
  const logarithmic = {filter: (u, ticks) => ticks,
                       splits: (u, axis, from, to) =>
                         ticksOf(from, to, (axis ? u.bbox.height : u.bbox.width) / uPlot.pxRatio)};
  const labels = (ticks, log, room) => (log ? logarithmicLabels(ticks, room) : ticks.map(tick => number(tick, 8)));
  const ylog = isLogarithmic(chart), suited = u => multiple(u.scales.y.max, chart.unit);
  const frequencies = (u, ticks) => labels(ticks, view.xlog, u.width / 50);
  const x = {...AXIS, label: isOnPaper(chart) ? null : frequencyLabel(), size: 24, space: 50,
             values: (u, ticks) => (isOnPaper(chart) ? withUnitAtEnd(frequencies(u, ticks), frequencyUnit())
                                                     : frequencies(u, ticks)),
             ...(view.xlog ? logarithmic : {})};
  const angles = {...AXIS, label: 'phase [°]', size: 50, space: 22, incrs: [45, 90, 180, 360, 720, 1440, 3600, 14400]};
  const amplitudes = {...AXIS, label: chart.caption ? null : u => amplitudeWords(chart, u), size: 50,
                      space: ylog ? 20 : 30,
                      values: (u, ticks) => labels(ticks.map(v => v * suited(u).factor), ylog, chart.height / 25),
                      ...(ylog ? logarithmic : {})};
  return [x, chart.phase ? angles : amplitudes];
}
function seriesOf(chart, curve) {
  const few = curve.omega.length <= FEW_POINTS;
  return {label: curve.label, pxAlign: 0, stroke: few ? `${curve.colour}59` : curve.colour, width: 1.7,
          dash: curve.dash.map(length => length * uPlot.pxRatio),
          show: !view.hidden.has(curve.key) && !(chart.phase && curve.vanishes),
          paths: chart.phase && chart.phase[1] === 180 ? wrappedPath : undefined,
          points: {show: few, size: 6, width: 0, fill: curve.colour}};
}
function optionsOf(chart) {
  const [from, to] = frequencyRange(chart).map(w => w * axisFactor()), ylog = isLogarithmic(chart) && !chart.phase;
  return {
    width: chart.width ?? Math.max(280, chart.holder.clientWidth), height: chart.height,
    padding: [10, isOnPaper(chart) ? 28 : 12, 0, 0],
    legend: {show: false}, axes: axesOf(chart), series: [{}, ...chart.curves.map(curve => seriesOf(chart, curve))],
    scales: {x: {time: false, distr: view.xlog ? 3 : 1, min: from, max: to, range: (u, low, high) => [low, high]},
             y: {distr: ylog ? 3 : 1, range: () => (chart.phase ? phaseAxis(chart) : amplitudeAxis(chart))}},
    cursor: {y: false, move: (u, x, y) => snapped(chart, u, x, y), dataIdx: nearestPoint, points: {size: 7},
             drag: {x: true, y: false, setScale: false, dist: 6}, bind: bindings,
             sync: {key: 'ω', scales: ['x', null], filters: {pub: type => type === 'mousemove'}}},
    hooks: {draw: [u => drawMarks(chart, u)], setCursor: [u => readOut(chart, u)], setSelect: [selectRange]},
  };
}

/// Is a chart in the window, or nearly?
function isNear({holder}) {
  const {top, bottom} = holder.getBoundingClientRect(), margin = 300;
  return bottom > -margin && top < window.innerHeight + margin;
}
/// Draws a chart again, or only moves it to the shown frequencies. One outside the window waits, except on paper, where
/// charts have a fixed width.
export function draw(chart) {
  if (!chart.stale || !(chart.width || isNear(chart))) return;
  const wide = suitsLogarithm(chart);
  if (wide !== chart.wide) [chart.wide, chart.stale] = [wide, 'all'];
  if (chart.stale === 'range') {
    const [min, max] = frequencyRange(chart).map(w => w * axisFactor());
    chart.plot.setScale('x', {min, max});
  } else {
    chart.plot?.destroy();
    chart.plot = new uPlot(optionsOf(chart), dataOf(chart), chart.holder);
    listenToMore(chart);
  }
  chart.stale = '';
}
export function makeChart(options) {
  const chart = {height: 250, phase: null, modes: [], stale: 'all', ...options};
  chart.ceiling = ceilingOf(chart);
  chart.marks = html('div', {class: 'marks'});
  const holder = chart.holder = html('div', {class: 'picture', tabindex: 0, role: 'img', 'aria-label': chart.title,
                                             style: `min-height:${chart.height}px`});
  holder.addEventListener('keydown', event => moveByKey(chart, event));
  return chart;
}

// ---------------------------------------------------------------- pointer, keys, legend

/// Mouse events of a chart, also of the marks on it.
const bindings = {
  mousedown: (u, target, handle) => event => { if (event.button === 0) handle(event); },
  mouseup: (u, target, handle) => event => { if (event.button === 0) handle(event); },
  mousemove: (u, target, handle) => event => handle(event),
  dblclick: () => () => change({zoom: null}),
};
/// Position of the cursor: in the charts of one case at the nearest drawn frequency, except while a range is selected.
function snapped(chart, u, x, y) {
  if (x < 0 || x > u.over.clientWidth) return [-10, -10];
  if (chart.joined || u.cursor.event?.buttons) return [x, y];
  const nearest = u.valToPos(u.data[0][nearestIndex(u.data[0], u.posToVal(x, 'x'))], 'x');
  return [nearest >= 0 && nearest <= u.over.clientWidth ? nearest : x, y];
}
function selectRange(u) {
  const {left, width} = u.select;
  if (!(width > 0)) return;
  u.setSelect({left: 0, width: 0, top: 0, height: 0}, false);
  change({zoom: [left, left + width].map(x => u.posToVal(x, 'x') / axisFactor())});
}
/// Wheel and touch: uPlot listens to the mouse only.
function listenToMore(chart) {
  const {over} = chart.plot;
  over.addEventListener('wheel', event => {
    if (!event.ctrlKey && !event.shiftKey) return;  // scrolls the page
    event.preventDefault();
    const step = Math.sign(event.deltaY || event.deltaX), same = v => v;
    const [to, back] = view.xlog ? [Math.log, Math.exp] : [same, same], [from, end] = frequencyRange(chart).map(to);
    const across = event.clientX - over.getBoundingClientRect().left;
    const middle = to(chart.plot.posToVal(across, 'x') / axisFactor());
    if (event.ctrlKey) zoomTo(...[from, end].map(v => back(middle + (v - middle) * 1.25 ** step)));
    else moveBy(0.1 * step * (end - from), to, back);
  }, {passive: false});
  const mouse = {pointerdown: 'mousedown', pointermove: 'mousemove', pointerup: 'mouseup', pointercancel: 'mouseup'};
  for (const [type, name] of Object.entries(mouse))
    over.addEventListener(type, event => {
      const {clientX, clientY, movementX, movementY} = event, buttons = type === 'pointermove' ? event.buttons : 0;
      if (event.pointerType === 'touch')
        over.dispatchEvent(new MouseEvent(name, {clientX, clientY, movementX, movementY, buttons, bubbles: true}));
    });
}
function moveByKey(chart, event) {
  const step = {ArrowLeft: -1, ArrowRight: 1}[event.key], {plot} = chart;
  if (event.key === 'Escape') plot.setCursor({left: -10, top: -10}, true, true);
  if (!step) return;
  event.preventDefault();
  const {cursor, data: [omega], over, scales: {x}} = plot;
  const at = cursor.left >= 0 ? plot.posToVal(cursor.left, 'x') : plot.posToVal(over.clientWidth / 2, 'x');
  const index = nearestIndex(omega, at) + step * (event.shiftKey ? 10 : 1);
  const next = Math.max(x.min, Math.min(x.max, omega[Math.max(0, Math.min(omega.length - 1, index))]));
  plot.setCursor({left: plot.valToPos(next, 'x'), top: 10}, true, true);
}

/// Buttons that show or hide curves, each with the value under the cursor.
export function makeLegend(curves, withPhase) {
  const legend = {withPhase, frequency: html('span', {class: 'frequency'}), entries: []};
  const entries = curves.map(curve => {
    const value = html('span', {class: 'reading'}, highestWords(curve)), sample = html('span', {class: 'sample'});
    sample.innerHTML = `<svg width="28" height="10"><path d="M0,5H28" stroke="${curve.colour}" stroke-width="2" ` +
                       `stroke-dasharray="${curve.dash.join()}"/></svg>`;
    legend.entries.push({curve, value});
    const button = html('button', {type: 'button', 'aria-pressed': !view.hidden.has(curve.key), 'data-key': curve.key,
                                   title: 'show or hide this curve', onclick: () => toggle(curve.key)},
                        sample, curve.vanishes ? `${curve.label} (≈ 0)` : curve.label);
    return html('span', {class: 'entry'}, button, value);
  });
  legend.node = html('div', {class: withPhase ? 'legend' : 'legend many'}, entries, legend.frequency);
  return legend;
}
function toggle(key) {
  view.hidden.has(key) ? view.hidden.delete(key) : view.hidden.add(key);
  for (const button of document.querySelectorAll('.legend button'))
    button.setAttribute('aria-pressed', !view.hidden.has(button.dataset.key));
  change({hidden: view.hidden});
}
function highestWords(c) {
  if (c.vanishes) return 'below round-off';
  const unbounded = c.peaks.some(p => p.unbounded && inside(p, [c.omega[0], c.omega.at(-1)]));
  return `max ${unbounded ? '∞' : withUnit(largestOf(c.amplitude), c.unit, 4)}`;
}
/// Writes the values under the cursor into the legend.
function readOut(chart, u) {
  const none = !(u.cursor.left >= 0), w = none ? 0 : u.posToVal(u.cursor.left, 'x') / axisFactor();
  if (chart.phase) return;  // the chart of the amplitude next to it has the same legend
  chart.legend.frequency.textContent = none ? '' : frequencyWords(w);
  for (const {curve, value} of chart.legend.entries) {
    const amplitude = amplitudeAt(curve, w), phase = curve.phase[nearestIndex(curve.omega, w)];
    const angle = chart.legend.withPhase && phase !== null ? `, ${phase.toFixed(1)}°` : '';
    const words = () => (Number.isFinite(amplitude) ? withUnit(amplitude, curve.unit, 4) + angle : '–');
    value.textContent = none ? highestWords(curve) : words();
  }
}
