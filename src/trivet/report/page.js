// SPDX-License-Identifier: BSD-3-Clause
// Reads the results embedded in the page, fills its tables and draws its pictures. All values inside are SI and rad/s.
'use strict';
(() => {

const results = JSON.parse(document.getElementById('results').textContent);
const cases = results.cases;
const TURN = 2 * Math.PI;
// The colours (Okabe-Ito) and dashes of the static figures.
const COLOURS = ['#0072B2', '#D55E00', '#009E73', '#CC79A7', '#000000', '#E69F00'];
const DASHES = ['', '7,3', '2,2', '9,3,2,3', '5,2', '1,3'];
const MOTIONS = ['x', 'y', 'z', 'θx', 'θy', 'θz'];
const FORCES = ['Fx', 'Fy', 'Fz', 'Mx', 'My', 'Mz'];
const SWITCHES = ['ylog', 'xlog', 'hz'];
const FEW_POINTS = 24;  // a response at this few frequencies is also shown as a table

/// State chosen by the user. `zoom` is null or [from, to] in rad/s; `hidden` contains the names of hidden curves.
const view = {case: 0, ylog: false, xlog: false, hz: false, zoom: null, compare: '', hidden: new Set()};
let pictures = [];       // of the selected case
let comparison = null;   // the picture of all cases
let cursor = null;       // ω under the pointer

// ---------------------------------------------------------------- elements, numbers, tables

const byId = id => document.getElementById(id);

function fill(node, attributes, children) {
  for (const [name, value] of Object.entries(attributes ?? {})) {
    if (name.startsWith('on')) node.addEventListener(name.slice(2), value);
    else if (value !== null && value !== undefined && value !== false) node.setAttribute(name, value);
  }
  node.append(...children.flat(Infinity).filter(child => child !== null && child !== undefined));
  return node;
}
const html = (tag, attributes, ...children) => fill(document.createElement(tag), attributes, children);
const svg = (tag, attributes, ...children) => fill(document.createElementNS('http://www.w3.org/2000/svg', tag), attributes, children);

/// Replaces the children of an element of the page.
function put(id, ...children) {
  byId(id).replaceChildren();
  fill(byId(id), {}, children);
}

const isNumber = value => typeof value === 'number' && Number.isFinite(value);
const smallestOf = values => values.reduce((least, v) => (v < least ? v : least), Infinity);
const largestOf = values => values.reduce((most, v) => (Number.isFinite(v) && v > most ? v : most), 0);

/// A number with significant digits, without trailing zeros, or with them in columns of results.
function number(value, digits = 6, keepZeros = false) {
  if (!isNumber(value)) return '–';
  if (value === 0) return '0';
  const size = Math.abs(value);
  const text = size >= 1e6 || size < 1e-4 ? value.toExponential(digits - 1) : value.toPrecision(digits);
  if (text.includes('e')) return keepZeros ? text.replace('e+', 'e') : text.replace(/\.?0*e\+?/, 'e');
  return keepZeros || !text.includes('.') ? text : text.replace(/\.?0+$/, '');
}
const result = (value, digits = 5) => number(value, digits, true);
const percent = share => (isNumber(share) ? `${(100 * share).toFixed(1).replace(/^-0\.0$/, '0.0')}\u00a0%` : '–');
const vector = v => `(${v.map(x => number(x, 7)).join(', ')})`;
const sameAxes = rotation => rotation.every((row, i) => row.every((x, j) => Math.abs(x - (i === j ? 1 : 0)) < 1e-12));

/// A suitable SI prefix for the largest value: {factor, unit}.
function prefix(largest, unit) {
  if (!(largest > 0) || !Number.isFinite(largest)) return {factor: 1, unit};
  const step = Math.max(-3, Math.min(2, Math.floor(Math.log10(largest) / 3 + 1e-9)));
  return {factor: 10 ** (-3 * step), unit: ['n', 'µ', 'm', '', 'k', 'M'][step + 3] + unit};
}
function withUnit(value, unit, digits = 5) {
  if (!isNumber(value)) return '∞';
  const p = prefix(Math.abs(value), unit);
  return `${result(value * p.factor, digits)} ${p.unit}`;
}

const count = (n, one, many = one + 's') => `${n} ${n === 1 ? one : many}`;

/// A right-aligned cell or heading.
const num = content => ({content, number: true});
const hertz = omega => omega / TURN;
const OMEGA_AND_HERTZ = [num('ω [rad/s]'), num('f [Hz]')];
const omegaAndHertz = w => [num(result(w, 6)), num(isNumber(w) ? result(hertz(w), 6) : '–')];
const quietIf = (quiet, text) => (quiet ? html('span', {class: 'quiet'}, text) : text);

/// Keeps a unit on one line with the word before it.
const unbroken = text => text.replace(/ ?\[[^\]]*\]/g, unit => unit.replaceAll(' ', '\u00a0'));

/// `rows` are arrays of cells, or {cells, mark}; a cell is a text, a node, num(…) or {content, span}. Long `tall` tables scroll.
function table(headings, rows, {tall = false, style = null} = {}) {
  const heading = item => html('th', {scope: 'col', class: item.number ? 'number' : null}, unbroken(item.content ?? item));
  const cell = item => html('td', {class: item?.number ? 'number' : null, colspan: item?.span}, item?.content ?? item);
  const line = row => html('tr', {class: row.mark}, (row.cells ?? row).map(cell));
  return html('div', {class: tall && rows.length > 18 ? 'scroll tall' : 'scroll', tabindex: 0, role: 'region', 'aria-label': 'table'},
    html('table', {class: style}, html('thead', {}, html('tr', {}, headings.map(heading))), html('tbody', {}, rows.map(line))));
}
const bad = text => html('span', {class: 'bad'}, text);
const hint = (...texts) => html('p', {class: 'hint'}, texts);
function verdict(passed, yes = 'ok', no = 'FAILED') {
  return html('span', {class: passed ? 'good' : 'bad'}, passed ? `✓ ${yes}` : `✗ ${no}`);
}
const section = (id, title, ...children) => html('section', {id}, html('h2', {}, title), children);
const folded = (title, ...children) => html('details', {}, html('summary', {}, title), children);
const caseName = index => cases[index].name || 'Base model';

// ---------------------------------------------------------------- curves

/// Owner and kind of an answer, from its name: "compressor.discharge flange.rx" is θx among the rotations of the flange.
function place(name, unit) {
  const dot = name.lastIndexOf('.');
  const owner = name.slice(0, dot), component = name.slice(dot + 1);
  if (unit.startsWith('N')) {
    const moment = unit === 'N m';
    return {owner: owner.replace(/\.(force|moment)$/, ''), kind: 'forces', lower: moment, label: (moment ? 'M' : 'F') + component};
  }
  const turns = component.startsWith('r');
  return {owner, kind: 'motions', lower: turns, label: turns ? 'θ' + component.slice(1) : component};
}

const frequencies = c => (curvesOf(c).length ? curvesOf(c)[0].omega : []);

const known = new Map();
function curvesOf(c) {
  if (!known.has(c)) known.set(c, c.response ? readCurves(c) : []);
  return known.get(c);
}

/// Values [re, im, re, im, …] of all curves of a model at ω: Σ w v/(ω − x) / Σ w/(ω − x) over the nodes x, times e^{−iωd} for each delay d.
function modelAt(model, w) {
  const piece = model.pieces.find(p => w <= p.band[1]) ?? model.pieces.at(-1), {nodes, weights, values} = piece, n = nodes.length;
  const curves = model.results.length, result = new Float64Array(2 * curves), shares = new Float64Array(2 * n), hit = nodes.indexOf(w);
  if (model.checks.undefined_at.includes(w)) return result.fill(NaN);
  let re = 0, im = 0;
  for (let j = 0; j < n; j++) {
    re += shares[2 * j] = hit < 0 ? weights[2 * j] / (w - nodes[j]) : hit === j ? 1 : 0;
    im += shares[2 * j + 1] = hit < 0 ? weights[2 * j + 1] / (w - nodes[j]) : 0;
  }
  model.delays.forEach((delay, d) => {
    const size = re * re + im * im, cos = Math.cos(w * delay), sin = -Math.sin(w * delay);
    const a = (cos * re + sin * im) / size, b = (sin * re - cos * im) / size;  // e^{−iωd} over the denominator
    for (let c = 0; c < curves; c++) {
      const v = values[d * curves + c];
      let x = 0, y = 0;
      for (let j = 0; j < n; j++) {
        x += shares[2 * j] * v[2 * j] - shares[2 * j + 1] * v[2 * j + 1];
        y += shares[2 * j] * v[2 * j + 1] + shares[2 * j + 1] * v[2 * j];
      }
      result[2 * c] += a * x - b * y;
      result[2 * c + 1] += a * y + b * x;
    }
  });
  return result;
}

/// Does any curve deviate from the straight line between two frequencies, or does its phase change too fast?
function bends(a, m, b, part, tops) {
  for (let c = 0; c < tops.length; c++) {
    const size = v => Math.hypot(v[2 * c], v[2 * c + 1]), [from, middle, to] = [size(a), size(m), size(b)], most = Math.max(from, middle, to);
    if (!(most > 1e-6 * tops[c])) continue;  // its shape there is invisible
    if (Math.abs(middle - (1 - part) * from - part * to) > 7e-4 * Math.max(middle, 1e-3 * most)) return true;
    const turn = (u, v) => Math.abs(Math.atan2(u[2 * c] * v[2 * c + 1] - u[2 * c + 1] * v[2 * c], u[2 * c] * v[2 * c] + u[2 * c + 1] * v[2 * c + 1]));
    if (turn(a, m) > Math.PI / 9 || turn(m, b) > Math.PI / 9) return true;
  }
  return false;
}

/// Frequencies between which straight lines approximate all curves of a model, and its values there.
function drawn(model, vanishing, unbounded) {
  const [from, to] = model.band, first = new Set([...Array(65).keys()].map(i => from + (to - from) * i / 64));
  for (const p of model.pieces) for (const w of [...p.band, ...p.nodes]) first.add(w);
  for (const r of model.results) for (const [w] of r.extrema) first.add(w);
  const points = [...first, ...model.checks.undefined_at].filter(w => w >= from && w <= to).sort((a, b) => a - b).map(w => ({w, v: modelAt(model, w)}));
  const heights = model.results.map((_, c) => largestOf(points.map(p => Math.hypot(p.v[2 * c], p.v[2 * c + 1]))));
  const ofUnit = unit => largestOf(heights.filter((_, c) => model.results[c].unit === unit));
  const noise = (r, c) => vanishing[c] || heights[c] < 1e-10 * ofUnit(r.unit);  // there the model is only round-off
  const tops = model.results.map((r, c) => (noise(r, c) ? Infinity : unbounded[c] ? 0 : heights[c]));
  const result = [], open = points.reverse();  // a stack: its last two are the current interval
  while (open.length > 1) {
    const a = open.pop(), b = open.at(-1);
    const inner = [0.25, 0.5, 0.75].map(part => ({part, w: a.w + part * (b.w - a.w)})).map(m => ({...m, v: modelAt(model, m.w)}));
    const wide = b.w - a.w > 1e-9 * b.w && result.length + open.length < 20000;
    if (wide && inner.some(m => bends(a.v, m.v, b.v, m.part, tops))) open.push({w: inner[1].w, v: inner[1].v}, a);
    else result.push(a);
  }
  return [...result, ...open];
}

/// Curves of a model in the form of a table, with exact heights at the maxima.
function tabled(c) {
  const packed = p => ({...p, weights: Float64Array.from(p.weights), values: p.values.map(row => Float64Array.from(row))});
  const model = {...c.response, pieces: c.response.pieces.map(packed)}, has = (list, mark) => model.results.map(r => (list ?? []).some(s => s.name === r.name && s.unit === r.unit && s[mark]));
  if (!model.pieces.length) return {angular_frequency: [], results: model.results.map(r => ({...r, complex: [], phase: []}))};
  const points = drawn(model, has(c.peaks?.curves, 'vanishes'), has(c.peaks?.peaks, 'unbounded'));
  const results = model.results.map((r, curve) => {
    const exact = new Map(r.extrema);
    let last = r.first_phase;
    const complex = points.map(({w, v}) => {
      const [re, im] = [v[2 * curve], v[2 * curve + 1]], size = Math.hypot(re, im), factor = size > 0 ? (exact.get(w) ?? size) / size : 1;
      return Number.isFinite(size) ? [re * factor, im * factor] : null;
    });
    const phase = complex.map(z => {
      if (!z) return null;
      const angle = z[1] === 0 ? (z[0] < 0 ? Math.PI : 0) : Math.atan2(z[1], z[0]);
      return last = model.continuous_phase && last !== null ? angle + TURN * Math.round((last - angle) / TURN) : angle;
    });
    return {...r, complex, phase};
  });
  return {angular_frequency: points.map(p => p.w), results};
}

/// Curves of a case in ascending ω: amplitude in SI, phase in degrees; NaN if the answer is not defined.
function readCurves(c) {
  const response = c.response.pieces ? tabled(c) : c.response, all = response.angular_frequency;
  const order = all.map((_, i) => i).sort((a, b) => all[a] - all[b]);
  const omega = order.map(i => all[i]);
  return response.results.map(r => {
    const amplitude = order.map(i => (r.complex[i] ? Math.hypot(...r.complex[i]) : NaN));
    const mine = item => item.name === r.name && item.unit === r.unit;
    return {
      ...place(r.name, r.unit), key: r.name, name: r.name, unit: r.unit, omega, amplitude,
      phase: order.map((i, k) => (amplitude[k] > 0 && isNumber(r.phase[i]) ? r.phase[i] * 360 / TURN : NaN)),
      peaks: (c.peaks?.peaks ?? []).filter(mine), limits: c.limits.filter(mine),
      vanishes: (c.peaks?.curves ?? []).some(s => mine(s) && s.vanishes),
    };
  });
}

/// Items with a place, grouped by owner: [{name, kind, rows: [[upper…], [lower…]]}].
function grouped(items) {
  const groups = [];
  for (const item of items) {
    let group = groups.find(g => g.name === item.owner && g.kind === item.kind);
    if (!group) groups.push(group = {name: item.owner, kind: item.kind, rows: [[], []]});
    group.rows[item.lower ? 1 : 0].push(item);
  }
  return groups;
}

function quantity(unit) {
  const names = {m: 'displacement', 'm/s': 'velocity', 'm/s²': 'acceleration', rad: 'rotation', 'rad/s': 'angular velocity',
                 'rad/s²': 'angular acceleration', N: 'force', 'N m': 'moment'};
  return names[unit] ?? unit;
}

// ---------------------------------------------------------------- scales and ticks

function linearTicks(from, to, wanted) {
  const raw = (to - from) / wanted, decade = 10 ** Math.floor(Math.log10(raw)), ratio = raw / decade;
  const step = decade * (ratio < 1.5 ? 1 : ratio < 3.5 ? 2 : ratio < 7.5 ? 5 : 10);
  const ticks = [];
  for (let k = Math.ceil(from / step - 1e-9); k * step <= to + 1e-9 * (to - from); k++) ticks.push({value: k * step, label: number(k * step, 8)});
  return ticks;
}

function decadeLabel(k) {
  if (k >= -3 && k <= 4) return String(Number(`1e${k}`));
  return '10' + [...String(k)].map(sign => (sign === '-' ? '⁻' : '⁰¹²³⁴⁵⁶⁷⁸⁹'[sign])).join('');
}
function logTicks(from, to, wanted) {
  const decades = Math.log10(to / from);
  if (decades < 1) return linearTicks(from, to, wanted);
  const ticks = [], every = Math.ceil(decades / wanted), labelled = decades < wanted / 3 ? [2, 5] : [];
  for (let k = Math.floor(Math.log10(from)); k <= Math.log10(to); k++)
    for (let digit = 1; digit < 10; digit++) {
      const value = digit * 10 ** k;
      if (value < from * (1 - 1e-9) || value > to * (1 + 1e-9)) continue;
      if (digit === 1) ticks.push({value, label: k % every === 0 ? decadeLabel(k) : ''});
      else if (decades <= wanted) ticks.push({value, label: labelled.includes(digit) ? number(value) : '', minor: true});
    }
  return ticks;
}

function scale(from, to, start, end, logarithmic, ticks) {
  const f = logarithmic ? Math.log : v => v, back = logarithmic ? Math.exp : v => v;
  const a = f(from), b = f(to);
  return {from, to, ticks, at: v => start + (f(v) - a) / (b - a) * (end - start), value: p => back(a + (p - start) / (end - start) * (b - a))};
}

/// The shown range of ω. A logarithmic axis cannot start at 0; it starts a decade below the lowest mode or peak.
function frequencyRange(picture) {
  let [from, to] = view.zoom ?? picture.band;
  if (!(to > from)) [from, to] = [from * 0.9, from * 1.1 + 1e-9];
  if (view.xlog && from <= 0) {
    const lowest = smallestOf(picture.landmarks.filter(w => w > 1e-6 * to));
    from = Math.max(Math.min(lowest / 10, to / 100), to / 1e5);
  }
  return [from, to];
}

function frequencyScale(picture, box) {
  const [from, to] = frequencyRange(picture), factor = view.hz ? 1 / TURN : 1;
  const ticks = (view.xlog ? logTicks : linearTicks)(from * factor, to * factor, Math.max(3, Math.floor((box.right - box.left) / (view.xlog ? 50 : 70))));
  return scale(from, to, box.left, box.right, view.xlog, ticks.map(tick => ({...tick, value: tick.value / factor})));
}

const inside = (w, x) => w >= x.from && w <= x.to;

/// Points [ω, value] of a curve inside the scale, with points interpolated at both ends; NaN values remain as gaps.
/// A wrapped phase is interpolated the short way round.
function within(curve, values, x, wrapped = false) {
  const points = [], round = step => (wrapped && Math.abs(step) > 180 ? step - Math.sign(step) * 360 : step);
  const cut = (i, at) => {
    const part = (at - curve.omega[i]) / (curve.omega[i + 1] - curve.omega[i]);
    return [at, round(values[i] + part * round(values[i + 1] - values[i]))];
  };
  curve.omega.forEach((w, i) => {
    const next = curve.omega[i + 1];
    if (inside(w, x)) points.push([w, values[i]]);
    if (w < x.from && next > x.from) points.push(cut(i, x.from));
    if (w < x.to && next > x.to) points.push(cut(i, x.to));
  });
  return points;
}

/// The amplitude that is exceeded over a twentieth of the range: the scale of a picture with infinite peaks.
function commonTop(points) {
  const pieces = points.slice(1).map((p, i) => [Math.max(p[1], points[i][1]), p[0] - points[i][0]]).filter(p => p[1] > 0).sort((a, b) => b[0] - a[0]);
  let left = 0.05 * pieces.reduce((sum, p) => sum + p[1], 0);
  for (const [value, width] of pieces) if ((left -= width) <= 0) return value;
  return 0;
}

const shownSeries = picture => picture.series.filter(s => !view.hidden.has(s.key));
const limitsOf = picture => picture.limits ?? shownSeries(picture).flatMap(s => s.limits.map(l => ({...l, label: s.label})));

function amplitudeScale(picture, x, box) {
  const shown = shownSeries(picture), peaks = shown.flatMap(s => s.peaks).filter(p => inside(p.angular_frequency, x));
  const lines = shown.map(s => within(s, s.amplitude, x));
  let largest = largestOf([...lines.flat().map(p => p[1]), ...peaks.map(p => p.amplitude)]);
  if (peaks.some(p => p.unbounded) && !view.ylog) largest = Math.min(largest, 2 * largestOf(lines.map(commonTop)) || largest);
  const limits = limitsOf(picture).map(l => l.limit).filter(l => l <= largest * (view.ylog ? 100 : 3));
  const top = Math.max(largest, ...limits);
  const unit = prefix(top, picture.unit);
  let from = 0, to = top > 0 ? 1.06 * top : 1;
  if (view.ylog && top > 0) {
    const alive = lines.filter(line => largestOf(line.map(p => p[1])) > 1e-9 * largest).flat().map(p => p[1]).filter(v => v > 0);
    from = Math.min(Math.max(smallestOf(alive), 1e-8 * largest) / 1.6, to / 10);
    to *= (to / from) ** 0.06;
  }
  const logarithmic = from > 0, factor = unit.factor;
  const ticks = (logarithmic ? logTicks : linearTicks)(from * factor, to * factor, Math.floor((box.bottom - box.top) / (logarithmic ? 20 : 40)));
  return {...scale(from, to, box.bottom, box.top, logarithmic, ticks.map(t => ({...t, value: t.value / factor}))),
          label: `${quantity(picture.unit)}${quantity(picture.unit).includes(' ') ? '' : ' amplitude'} [${unit.unit}]`};
}

function phaseScale(picture, box) {
  const values = shownSeries(picture).flatMap(s => s.phase).filter(Number.isFinite);
  const low = values.reduce((m, v) => Math.min(m, Math.floor(v / 90 + 1e-9) * 90), -180);
  const high = values.reduce((m, v) => Math.max(m, Math.ceil(v / 90 - 1e-9) * 90), 180);
  const step = [45, 90, 180, 360, 720, 1440].find(s => (high - low) / s <= 8) ?? 3600;
  const ticks = [];
  for (let v = Math.ceil(low / step) * step; v <= high; v += step) ticks.push({value: v, label: String(v)});
  const air = 0.02 * (high - low);
  return {...scale(low - air, high + air, box.bottom, box.top, false, ticks), label: 'phase [°]', wrapped: low >= -180 && high <= 180};
}

// ---------------------------------------------------------------- drawing a picture

/// The path of a curve; a wrapped phase continues from ±180° at the other side.
function path(points, x, y, wrapped) {
  let d = '', previous = null;
  const go = (command, px, py) => { d += `${command}${px.toFixed(2)},${Math.max(-1e4, Math.min(1e4, py)).toFixed(2)}`; };
  for (const [w, value] of points) {
    if (!Number.isFinite(value) || (y.from > 0 && !(value > 0))) { previous = null; continue; }
    const px = x.at(w), py = y.at(value);
    if (previous && wrapped && Math.abs(value - previous.value) > 180) {
      const edge = Math.sign(previous.value) * 180, way = 360 - Math.abs(value - previous.value);
      const part = way > 0 ? Math.abs(edge - previous.value) / way : 0.5, middle = previous.px + part * (px - previous.px);
      go('L', middle, y.at(edge));
      go('M', middle, y.at(-edge));
    }
    go(previous ? 'L' : 'M', px, py);
    previous = {value, px};
  }
  return d;
}

function drawFrame(picture, x, y, box, width) {
  const middle = (box.top + box.bottom) / 2;
  const label = (tick, place) => (tick.label ? svg('text', {...place, fill: '#333'}, tick.label) : null);
  const colour = tick => (tick.minor ? '#f1f1f1' : '#dfdfdf');
  return svg('g', {},
    x.ticks.map(t => [svg('path', {d: `M${x.at(t.value)},${box.top}V${box.bottom}`, stroke: colour(t)}),
      label(t, {x: x.at(t.value), y: box.bottom + 16, 'text-anchor': 'middle'})]),
    y.ticks.map(t => [svg('path', {d: `M${box.left},${y.at(t.value)}H${box.right}`, stroke: colour(t)}),
      label(t, {x: box.left - 6, y: y.at(t.value) + 4, 'text-anchor': 'end'})]),
    svg('rect', {x: box.left, y: box.top, width: box.right - box.left, height: box.bottom - box.top, fill: 'none', stroke: '#333'}),
    svg('text', {x: (box.left + box.right) / 2, y: box.bottom + 34, 'text-anchor': 'middle'}, view.hz ? 'f [Hz]' : 'ω [rad/s]'),
    svg('text', {x: 13, y: middle, 'text-anchor': 'middle', transform: `rotate(-90 13 ${middle})`}, y.label));
}

/// Undamped natural frequencies as short ticks on the upper edge.
function drawModes(picture, x, box) {
  return picture.modes.filter(m => m.angular_frequency > 0 && inside(m.angular_frequency, x)).map(m =>
    svg('path', {d: `M${x.at(m.angular_frequency)},${box.top}v9`, stroke: '#666', 'stroke-width': 2},
      svg('title', {}, `mode ${m.number}, ω = ${result(m.angular_frequency, 6)} rad/s = ${result(m.frequency_hz, 6)} Hz\n${m.name}`)));
}

function peakWords(peak, label) {
  const lines = [`peak of ${label}: ${peak.unbounded ? 'unbounded (undamped)' : withUnit(peak.amplitude, peak.unit)}`,
                 `ω = ${result(peak.angular_frequency, 6)} rad/s = ${result(hertz(peak.angular_frequency), 6)} Hz`];
  if (isNumber(peak.ratio_to_static)) lines.push(`${result(peak.ratio_to_static)} × static`);
  if (peak.nearest_mode) lines.push(`nearest mode: ${peak.nearest_mode}`);
  return lines.join('\n');
}
function drawPeaks(series, x, y, box) {
  return series.peaks.filter(p => inside(p.angular_frequency, x)).map(p => {
    const title = svg('title', {}, peakWords(p, series.label)), px = x.at(p.angular_frequency);
    if (p.unbounded) {
      return svg('g', {}, title, svg('path', {d: `M${px},${box.top}V${box.bottom}`, stroke: series.colour, 'stroke-width': 1.6, 'stroke-dasharray': '1.5,4'}),
        svg('text', {x: px + 4, y: box.top + 22, fill: series.colour, 'font-size': 15}, '∞'));
    }
    if (p.amplitude < y.from || p.amplitude > y.to) return null;
    const place = {cx: px, cy: y.at(p.amplitude)};
    return svg('g', {}, title, svg('circle', {...place, r: 9, fill: 'transparent'}),
      svg('circle', {...place, r: 3.2, fill: '#fff', stroke: series.colour, 'stroke-width': 1.5}));
  });
}

function drawLimits(picture, y, box) {
  let above = 0;
  return limitsOf(picture).map(l => {
    const unit = prefix(l.limit, l.unit), style = {fill: '#b00020', x: box.left + 6, stroke: '#fff', 'stroke-width': 3, 'paint-order': 'stroke'};
    const words = ['limit', l.label, number(l.limit * unit.factor), unit.unit].filter(Boolean).join(' ');
    if (l.limit > y.to || l.limit < y.from)
      return svg('text', {...style, y: box.top + 24 + 15 * above++}, `${words} (${l.limit > y.to ? 'above' : 'below'} this picture)`);
    const py = y.at(l.limit);
    return svg('g', {}, svg('path', {d: `M${box.left},${py}H${box.right}`, stroke: '#b00020', 'stroke-width': 1.4, 'stroke-dasharray': '10,4'}),
      svg('text', {...style, y: py - 5 < box.top + 12 ? py + 14 : py - 5}, words));
  });
}

/// A curve; if it has few points these are drawn too, because the line between them shows little.
function drawCurve(series, values, x, y) {
  const points = within(series, values, x, y.wrapped), few = series.omega.length <= FEW_POINTS;
  const dots = few ? points.filter(p => series.omega.includes(p[0]) && Number.isFinite(p[1])) : [];
  return [svg('path', {d: path(points, x, y, y.wrapped), fill: 'none', stroke: series.colour, 'stroke-width': 1.7, opacity: few ? 0.35 : null,
                       'stroke-linejoin': 'round', 'stroke-dasharray': series.dash || null}),
          dots.filter(p => p[1] >= y.from).map(p => svg('circle', {cx: x.at(p[0]), cy: y.at(p[1]), r: 3, fill: series.colour}))];
}

let clips = 0;
function drawPicture(picture) {
  const width = Math.max(280, picture.holder.clientWidth || 560), height = picture.height;
  const box = {left: 68, right: width - 12, top: 10, bottom: height - 44};
  const x = frequencyScale(picture, box), y = picture.phase ? phaseScale(picture, box) : amplitudeScale(picture, x, box);
  const clip = `clip${++clips}`, shown = shownSeries(picture);
  const drawn = shown.filter(s => !(picture.phase && s.vanishes)).map(s => drawCurve(s, picture.phase ? s.phase : s.amplitude, x, y));
  const overlay = svg('g', {});
  picture.frame = {x, y, box, width, overlay};
  picture.holder.replaceChildren(svg('svg', {viewBox: `0 0 ${width} ${height}`, role: 'img', 'aria-label': picture.title},
    svg('defs', {}, svg('clipPath', {id: clip}, svg('rect', {x: box.left, y: box.top - 3, width: box.right - box.left, height: box.bottom - box.top + 6}))),
    svg('rect', {x: 0, y: 0, width, height, fill: '#fff'}),
    drawFrame(picture, x, y, box, width),
    svg('g', {'clip-path': `url(#${clip})`}, drawn),
    overlay, drawModes(picture, x, box),
    picture.phase ? null : [drawLimits(picture, y, box), shown.map(s => drawPeaks(s, x, y, box))]));
}

// ---------------------------------------------------------------- pointer, keys, legend

const allPictures = () => (comparison ? [...pictures, comparison] : pictures);

/// Index of the drawn frequency nearest to ω.
function nearestIndex(omega, w) {
  let low = 0, high = omega.length - 1;
  while (high - low > 1) omega[(low + high) >> 1] < w ? low = (low + high) >> 1 : high = (low + high) >> 1;
  return high >= 0 && omega[high] - w < w - omega[low] ? high : low;
}
function amplitudeAt(series, w) {
  const i = nearestIndex(series.omega, w), j = w < series.omega[i] ? i - 1 : i + 1;
  if (series.omega[i] === w || j < 0 || j >= series.omega.length) return Math.abs(series.omega[i] - w) < 1e-9 * w ? series.amplitude[i] : NaN;
  return series.amplitude[i] + (series.amplitude[j] - series.amplitude[i]) * (w - series.omega[i]) / (series.omega[j] - series.omega[i]);
}

function drawCursor(picture) {
  const {x, y, box, overlay} = picture.frame;
  overlay.replaceChildren();
  if (cursor === null || !inside(cursor, x)) return;
  overlay.append(svg('path', {d: `M${x.at(cursor)},${box.top}V${box.bottom}`, stroke: '#333', 'stroke-dasharray': '3,2'}));
  for (const s of shownSeries(picture)) {
    const value = picture.phase ? s.phase[nearestIndex(s.omega, cursor)] : amplitudeAt(s, cursor);
    if (Number.isFinite(value) && value >= y.from && value <= y.to && !(picture.phase && s.vanishes))
      overlay.append(svg('circle', {cx: x.at(cursor), cy: y.at(value), r: 3.2, fill: s.colour, stroke: '#fff'}));
  }
}
function highestWords(s) {
  if (s.vanishes) return 'below round-off';
  const unbounded = s.peaks.some(p => p.unbounded && inside(p.angular_frequency, {from: s.omega[0], to: s.omega.at(-1)}));
  return `max ${unbounded ? '∞' : withUnit(largestOf(s.amplitude), s.unit, 4)}`;
}
function readOut(legend) {
  const none = cursor === null;
  legend.frequency.textContent = none ? '' : `ω = ${result(cursor, 6)} rad/s, f = ${result(hertz(cursor), 6)} Hz`;
  for (const {series, reading} of legend.entries) {
    const phase = series.phase?.[nearestIndex(series.omega, cursor ?? 0)], amplitude = none ? NaN : amplitudeAt(series, cursor);
    const angle = legend.withPhase && Number.isFinite(phase) ? `, ${phase.toFixed(1)}°` : '';
    reading.textContent = none ? highestWords(series) : Number.isFinite(amplitude) ? withUnit(amplitude, series.unit, 4) + angle : '–';
  }
}
function setCursor(w) {
  cursor = w;
  for (const picture of allPictures()) drawCursor(picture);
  for (const legend of new Set(allPictures().map(p => p.legend))) readOut(legend);
}

/// ω at a pointer event, clamped to the axis; in the pictures of one case the nearest drawn frequency.
function frequencyAt(picture, event, snap) {
  const {x, box, width} = picture.frame, rectangle = picture.holder.getBoundingClientRect();
  const pixel = Math.max(box.left, Math.min(box.right, (event.clientX - rectangle.left) * width / rectangle.width));
  const w = x.value(pixel), omega = picture.series[0]?.omega ?? [];
  if (!snap || picture === comparison || !omega.length) return {w, pixel};
  const near = omega[nearestIndex(omega, w)];
  return {w: inside(near, x) ? near : w, pixel};
}

function listen(picture) {
  const holder = picture.holder;
  let start = null;
  const mark = event => {
    const {box, overlay} = picture.frame, end = frequencyAt(picture, event).pixel;
    overlay.replaceChildren(svg('rect', {x: Math.min(start.pixel, end), y: box.top, width: Math.abs(end - start.pixel), height: box.bottom - box.top,
                                         fill: '#0072b2', 'fill-opacity': 0.15, stroke: '#0072b2'}));
  };
  const finish = event => {
    if (!start) return;
    const end = frequencyAt(picture, event), from = start;
    start = null;
    if (Math.abs(end.pixel - from.pixel) > 6) change({zoom: [from.w, end.w].sort((a, b) => a - b)});
  };
  holder.addEventListener('pointerdown', event => {
    if (event.button !== 0) return;
    start = frequencyAt(picture, event);
    holder.setPointerCapture(event.pointerId);
  });
  holder.addEventListener('pointermove', event => {
    setCursor(frequencyAt(picture, event, true).w);
    if (start) mark(event);
  });
  holder.addEventListener('pointerup', finish);
  holder.addEventListener('pointercancel', () => { start = null; setCursor(null); });
  holder.addEventListener('pointerleave', () => { if (!start) setCursor(null); });
  holder.addEventListener('dblclick', () => change({zoom: null}));
  holder.addEventListener('keydown', event => moveByKey(picture, event));
}
function moveByKey(picture, event) {
  const step = {ArrowLeft: -1, ArrowRight: 1}[event.key];
  if (event.key === 'Escape') setCursor(null);
  if (!step || !picture.series.length) return;
  event.preventDefault();
  const {x} = picture.frame, omega = picture.series[0].omega;
  const from = cursor === null ? (x.from + x.to) / 2 : cursor;
  const index = nearestIndex(omega, from) + step * (event.shiftKey ? 10 : 1);
  setCursor(Math.max(x.from, Math.min(x.to, omega[Math.max(0, Math.min(omega.length - 1, index))])));
}

function makePicture(options) {
  const picture = {height: 250, phase: false, modes: [], ...options, holder: html('div', {class: 'picture', tabindex: 0})};
  listen(picture);
  return picture;
}

/// Buttons that show or hide curves, each with the value under the cursor.
function makeLegend(series, withPhase) {
  const legend = {withPhase, frequency: html('span', {class: 'frequency'}), entries: []};
  const entries = series.map(s => {
    const reading = html('span', {class: 'reading'});
    legend.entries.push({series: s, reading});
    const sample = svg('svg', {width: 28, height: 10, 'aria-hidden': 'true'},
      svg('path', {d: 'M0,5H28', stroke: s.colour, 'stroke-width': 2, 'stroke-dasharray': s.dash || null}));
    const button = html('button', {type: 'button', 'aria-pressed': !view.hidden.has(s.key), 'data-key': s.key, title: 'show or hide this curve',
                                   onclick: () => toggle(s.key)}, sample, s.vanishes ? `${s.label} (≈ 0)` : s.label);
    return html('span', {class: 'entry'}, button, reading);
  });
  legend.node = html('div', {class: withPhase ? 'legend' : 'legend many'}, entries, legend.frequency);
  return legend;
}
function toggle(key) {
  view.hidden.has(key) ? view.hidden.delete(key) : view.hidden.add(key);
  for (const button of document.querySelectorAll('.legend button')) button.setAttribute('aria-pressed', !view.hidden.has(button.dataset.key));
  refresh();
}

// ---------------------------------------------------------------- characteristics and comparison

const bandOf = c => [smallestOf(frequencies(c)), largestOf(frequencies(c))];
const naturalOf = c => (c.modes?.modes ?? []).map(m => m.angular_frequency).filter(w => w > 0);
const landmarksOf = c => [...naturalOf(c), ...(c.peaks?.peaks ?? []).map(p => p.angular_frequency)];
const styled = (series, i) => ({...series, colour: COLOURS[i % 6], dash: DASHES[(i + Math.floor(i / 6)) % 6]});

function characteristicsRow(c, series) {
  const legend = makeLegend(series, true);
  const common = {series, legend, unit: series[0].unit, band: bandOf(c), landmarks: landmarksOf(c), modes: c.modes?.modes ?? []};
  const title = `${series[0].owner}, ${series.map(s => s.label).join(', ')}`;
  const pair = [makePicture({...common, title: `Amplitude of ${title}`}), makePicture({...common, phase: true, title: `Phase of ${title}`})];
  pictures.push(...pair);
  return html('div', {class: 'row'}, legend.node, html('div', {class: 'pair'}, pair.map(p => p.holder)));
}

function responseTable(curves) {
  const cells = (s, i) => [s.name, ...omegaAndHertz(s.omega[i]), num(Number.isFinite(s.amplitude[i]) ? withUnit(s.amplitude[i], s.unit) : 'not defined'),
                           num(Number.isFinite(s.phase[i]) ? s.phase[i].toFixed(2) : '–')];
  return table(['curve', ...OMEGA_AND_HERTZ, num('amplitude'), num('phase [°]')], curves.flatMap(s => s.omega.map((_, i) => cells(s, i))), {tall: true});
}

function characteristics(c) {
  const curves = curvesOf(c), points = frequencies(c).length;
  pictures = [];
  if (!curves.length) return null;
  if (points < 2) return section('characteristics', 'Response', responseTable(curves));
  const pair = group => html('div', {}, html('h3', {}, group.name), group.rows.filter(row => row.length).map(row => characteristicsRow(c, row.map(styled))));
  return section('characteristics', 'Amplitude and phase characteristics',
    hint('Move over a picture to read values at the drawn frequencies (or focus it and use ← →, with Shift by tens). ',
      'Drag to zoom all pictures in frequency, double-click for the whole band. Click a legend entry to show or hide its curve. ',
      'Circles: resonance peaks. Grey ticks on the upper edge: undamped natural frequencies.'),
    grouped(curves).map(pair), points <= FEW_POINTS ? folded('The same as a table', responseTable(curves)) : null);
}

const drawable = () => cases.filter(c => frequencies(c).length > 1);
const comparedNames = () => [...new Set(drawable().flatMap(c => c.response.results.map(r => r.name)))];

function buildComparison() {
  const names = comparedNames();
  comparison = null;
  if (cases.length < 2 || !names.length) return;
  if (!names.includes(view.compare)) view.compare = names[0];
  const series = cases.flatMap((c, i) => {
    const curve = frequencies(c).length > 1 && curvesOf(c).find(s => s.name === view.compare);
    return curve ? [styled({...curve, key: `case ${i}`, label: caseName(i)}, i)] : [];
  });
  const bands = drawable().map(bandOf), legend = makeLegend(series, false);
  comparison = makePicture({series, legend, height: 360, unit: series[0].unit, band: [smallestOf(bands.map(b => b[0])), largestOf(bands.map(b => b[1]))],
                            limits: cases[view.case].limits.filter(l => l.name === view.compare).map(l => ({...l, label: ''})),
                            landmarks: drawable().flatMap(landmarksOf), title: `Amplitude of ${view.compare} in all cases`});
  const choose = event => {
    view.compare = event.target.value;
    buildComparison();
    refresh();
    byId('compare').focus();
  };
  const options = names.map(name => html('option', {value: name, selected: name === view.compare ? '' : null}, name));
  put('comparison', html('h2', {}, 'Comparison of cases'), html('p', {}, html('label', {}, 'Curve ', html('select', {id: 'compare', onchange: choose}, options))),
    legend.node, comparison.holder,
    hint('Zoom and axes are those of the pictures above. Values under the cursor are interpolated between the frequencies drawn in each case.'));
  byId('comparison').hidden = false;
}

// ---------------------------------------------------------------- results of a case

function limitsSection(c) {
  if (!c.limits.length) return null;
  const row = l => ({mark: l.kept ? null : 'failed', cells: [
    l.name, num(withUnit(l.limit, l.unit)), num(withUnit(l.in_band, l.unit)), num(isNumber(l.in_band) ? percent(l.in_band / l.limit) : '∞'),
    ...omegaAndHertz(l.in_band_at), num(withUnit(l.anywhere, l.unit)), verdict(l.kept, 'met', 'EXCEEDED')]});
  return section('limits', 'Limits', table(['curve', num('limit'), num('largest in the band'), num('share of the limit'), ...OMEGA_AND_HERTZ,
    num('largest at any frequency'), 'verdict'], c.limits.map(row)));
}

function peakRow(p, c) {
  const [from, to] = c.band ?? [0, Infinity], tolerance = c.peaks.peak_tolerance, endless = p.relative_prominence === null;
  const counted = p.unbounded || endless || p.relative_prominence >= tolerance;
  const remarks = [p.unbounded ? 'unbounded: no damping' : '', counted ? '' : `prominence under ${number(100 * tolerance)} %`,
                   from < to && !inside(p.angular_frequency, {from, to}) ? 'outside the band' : '', p.method === 'series' ? 'very flat, less exact' : ''];
  return {mark: counted ? null : 'minor', cells: [
    p.name, ...omegaAndHertz(p.angular_frequency), num(p.unbounded ? '∞' : withUnit(p.amplitude, p.unit)), num(result(p.ratio_to_static)),
    num(endless ? '∞' : result(100 * p.relative_prominence, 4)), num(p.nearest_mode ?? '–'), remarks.filter(Boolean).join('; ')]};
}
function peakless(s) {
  if (s.vanishes) return `${s.name}: no resonance peak; below round-off at all frequencies.`;
  const at = isNumber(s.highest_at) ? `at ω = ${number(s.highest_at, 5)} rad/s` : 'as ω → ∞';
  return `${s.name}: no resonance peak; highest amplitude ${withUnit(s.highest, s.unit)} ${at}.`;
}
function peaksSection(c) {
  if (!c.peaks) return null;
  const {peaks, curves, min_prominence, peak_tolerance} = c.peaks, none = curves.filter(s => s.peaks === 0);
  const headings = ['curve', ...OMEGA_AND_HERTZ, num('amplitude'), num('ratio to static'), num('relative prominence [%]'), num('nearest mode'), 'remark'];
  return section('peaks', 'Resonance peaks', peaks.length ? table(headings, peaks.map(p => peakRow(p, c)), {tall: true}) : null,
    none.length ? html('ul', {class: 'sentences'}, none.map(s => html('li', {}, peakless(s)))) : null,
    hint(`All peaks at 0 < ω < ∞, except those lower than ${number(min_prominence)} of the curve's largest amplitude; `,
      `grey ones rise less than ${number(100 * peak_tolerance)} % above the adjacent minimum. `,
      'Prominence “∞”: the amplitude next to the peak falls to 0. Ratio “–”: the static amplitude is 0 or not defined.'));
}

function modeFrequency(m) {
  if (m.angular_frequency === null) return [{span: 2, content: bad(`▲ unstable, ω² = ${result(m.eigenvalue_squared)} rad²/s²`)}];
  return m.angular_frequency === 0 ? [{span: 2, content: 'rigid body (ω = 0)'}] : omegaAndHertz(m.angular_frequency);
}
function mostStrained(m, names) {
  const shares = m.strain_energy_share;
  if (!shares?.length) return '–';
  const most = shares.indexOf(Math.max(...shares)), alike = shares.filter(share => Math.abs(share - shares[most]) < 5e-4).length - 1;
  return `${names[most]} (${percent(shares[most])})${alike ? `, ${alike} more with the same share` : ''}`;
}
function kineticWords(m, body) {
  const sum = from => percent(m.principal_kinetic_energy_share.slice(6 * body + from, 6 * body + from + 3).reduce((a, b) => a + b, 0));
  return `${sum(0)} / ${sum(3)}`;
}
function modesSection(c) {
  if (!c.modes) return null;
  const {bodies, elements, modes} = c.modes, several = bodies.length > 1;
  const coordinates = bodies.flatMap(b => MOTIONS.map(x => num(several ? `${b} ${x}` : x)));
  const value = v => num(quietIf(v !== 0 && Math.abs(v) < 1e-12, result(v, 4)));
  const byCoordinate = key => table([num('mode'), ...coordinates], modes.map(m => [num(m.number), ...m[key].map(value)]));
  const row = m => ({mark: m.angular_frequency === null ? 'failed' : null, cells: [
    num(m.number), ...modeFrequency(m), m.name + (m.repeated ? ' (repeated root)' : ''), mostStrained(m, elements), ...bodies.map((_, b) => num(kineticWords(m, b)))]});
  return section('modes', 'Undamped modes',
    table([num('mode'), ...OMEGA_AND_HERTZ, 'motion', 'most strained element (share)',
      ...bodies.map(b => num(`kinetic energy${several ? ' of ' + b : ''}: translation / rotation`))], modes.map(row)),
    folded('Mode shapes at the poles: x, y, z [m], θx, θy, θz [rad], unit modal mass', byCoordinate('shape')),
    folded('Shares of kinetic energy by coordinate at the poles (they sum to 1; single ones may be outside 0 … 1)', byCoordinate('kinetic_energy_share')));
}

function rootsSection(c) {
  if (!c.roots) return null;
  const all = c.roots.roots.map(r => ({...r, re: r.eigenvalue[0], im: r.eigenvalue[1]}));
  const paired = r => r.im !== 0 && all.some(o => Math.hypot(o.re - r.re, o.im + r.im) < 1e-9 * Math.hypot(r.re, r.im));
  const row = r => ({mark: r.kind === 'growing' ? 'failed' : null, cells: [
    num(result(r.re, 6)), num((paired(r) ? '± ' : '') + result(r.im, 6)), r.kind === 'growing' ? bad('▲ GROWING') : r.kind,
    num(result(r.angular_frequency, 6)), num(result(r.damped_angular_frequency, 6)), num(result(r.damping_ratio)), num(r.nearest_mode ?? '–')]});
  return section('roots', 'Damped roots',
    table([num('Re λ [1/s]'), num('Im λ [rad/s]'), 'kind', num('|λ| [rad/s]'), num('damped ω [rad/s]'), num('damping ratio'), num('nearest mode')],
      all.filter(r => r.im >= 0 || !paired(r)).map(row), {tall: true}));
}

function staticTable(c, kind) {
  const items = c.static.results.map(r => ({...r, ...place(r.name, r.unit)})).filter(r => r.kind === kind);
  if (!items.length) return null;
  const motions = kind === 'motions', labels = motions ? MOTIONS : FORCES;
  const sizes = [false, true].map(lower => largestOf(items.filter(r => r.lower === lower).map(r => Math.abs(r.value))));
  const units = sizes.map((size, i) => prefix(size, (motions ? ['m', 'rad'] : ['N', 'N m'])[i]));
  const cell = (group, label, i) => {
    const item = group.rows[i].find(r => r.label === label);
    return num(item ? quietIf(item.value !== 0 && Math.abs(item.value) < 1e-11 * sizes[i], result(item.value * units[i].factor)) : '–');
  };
  return table([motions ? 'body or point' : 'forces of', ...labels.map((label, k) => num(`${label} [${units[k < 3 ? 0 : 1].unit}]`))],
    grouped(items).map(group => [group.name, ...labels.map((label, k) => cell(group, label, k < 3 ? 0 : 1))]));
}
function staticSection(c) {
  if (!c.static) return null;
  return section('static', 'Static results', staticTable(c, 'motions'), html('p', {}), staticTable(c, 'forces'),
    hint(`Under gravity and the constant forces. Grey values are round-off. Backward error of the solution: ${number(c.static.backward_error, 3)}.`));
}

function solutionRows({worst_backward_error, at_angular_frequency, pivoted_fallbacks, undefined_at, second_solver: second}) {
  const at = w => `at ω = ${number(w, 5)} rad/s`;
  return [
    ['response', 'worst backward error of the solution', `${number(worst_backward_error, 3)} ${at(at_angular_frequency)}`, ''],
    {mark: second.passed ? null : 'failed', cells: ['response', `second solver agrees at ${count(second.frequencies, 'frequency', 'frequencies')}`,
      `worst difference ${number(second.worst_difference, 3)} ${at(second.at_angular_frequency)}, allowed ${number(second.allowed, 3)}`, verdict(second.passed)]},
    ['response', 'frequencies that needed the pivoted solver', String(pivoted_fallbacks), ''],
    ['response', 'frequencies at which the response is not defined', undefined_at.length ? undefined_at.map(w => number(w)).join(', ') + ' rad/s' : 'none', '']];
}
function checksSection(c) {
  const rows = c.checks.map(k => ({mark: k.passed ? null : 'failed', cells: [k.subject, k.what, k.value, verdict(k.passed)]}));
  if (c.response) rows.push(...solutionRows(c.response.checks));
  if (c.response?.pieces)
    rows.push(['response', 'curves of this page compared with independent solves and extrema', `drawn from ${count(c.response.solves, 'solve')}; ` +
      `largest difference ${number(100 * c.response.worst_error, 2)} % at ω = ${number(c.response.worst_error_at, 5)} rad/s, ${c.response.tests} compared`, verdict(c.response.worst_error <= 1e-3)]);
  const failed = failures(c).length;
  return section('checks', 'Checks', html('p', {class: failed ? 'bad' : 'good'}, failed ? `✗ ${failed} failed.` : '✓ All passed.'),
    table(['subject', 'check', 'value', 'verdict'], rows, {tall: true}));
}

// ---------------------------------------------------------------- inputs of a case

const matrix = (labels, rows, style) => table(['', ...labels.map(num)], rows.map((row, i) => [labels[i], ...row.map(v => num(number(v)))]), {style});
const axesWords = rotation => (sameAxes(rotation) ? 'are parallel to the ground axes' : `are the columns of the matrix with the rows ${rotation.map(vector).join(' ')} in the ground`);

function bodiesTables(bodies) {
  const points = b => Object.entries(b.points).map(([name, at]) => html('div', {}, `${name} ${vector(at)}`));
  const moments = b => html('span', {class: b.principal_moments.some(j => j <= 0) ? 'bad' : null}, b.principal_moments.map(j => number(j)).join(', '));
  const row = b => [b.name, num(number(b.mass)), vector(b.center_of_mass), moments(b), b.free.map(f => f.replace('r', 'θ')).join(' ') || 'none',
                    vector(b.position), html('span', {}, points(b))];
  return [table(['body', num('mass [kg]'), 'centre of mass [m]', 'principal central moments [kg m²]', 'free coordinates', 'pole in ground [m]', 'points [m]'], bodies.map(row)),
    folded('Inertia about the pole [kg m²] and axes of the bodies',
      bodies.map(b => [html('p', {}, `${b.name}: the body axes ${axesWords(b.rotation)}`), matrix(['x', 'y', 'z'], b.inertia_about_pole)]))];
}
function elementsTables(elements) {
  const row = e => [e.name, e.type, e.n.on, vector(e.n.in_ground), e.k.on, vector(e.k.in_ground), num(number(e.scale)), e.damping];
  const stiffness = e => folded(`Stiffness 12×12 of ${e.name}`,
    hint(`Scale included; [N/m], [N/rad], [N m/m], [N m/rad]. The local axes of N ${axesWords(e.n.axes_in_ground)}; those of K ${axesWords(e.k.axes_in_ground)}.`),
    matrix(['N', 'K'].flatMap(end => MOTIONS.map(x => `${end} ${x}`)), e.stiffness, 'matrix'));
  const viscous = e => folded(`Viscous damping 12×12 of ${e.name}`, hint('[N s/m], [N s/rad], [N m s/m], [N m s/rad], in the same axes.'),
    matrix(['N', 'K'].flatMap(end => MOTIONS.map(x => `${end} ${x}`)), e.viscous_damping, 'matrix'));
  const found = e => folded(`How ${e.name} was determined`, '', table(['what', 'value'], e.facts.map(f => [f.what, f.value])));
  return [table(['element', 'type', 'end N on', 'N in ground [m]', 'end K on', 'K in ground [m]', num('scale'), 'damping'], elements.map(row)), elements.filter(e => e.facts.length).map(found), elements.map(stiffness), elements.filter(e => e.damping === 'viscous matrix').map(viscous)];
}
/// An excitation: its course is shown by its type; of a force or motion only non-zero components are listed.
function excitationsTable(excitations) {
  const parts = (values, names, unit) => (values ?? []).map((v, i) => (v ? `${names[i]} ${number(v)}` : '')).filter(Boolean).map(text => `${text} ${unit}`);
  const amplitudes = e => [...parts(e.force, FORCES, e.units?.[0] ?? 'N'), ...parts(e.moment, FORCES.slice(3), e.units?.[1] ?? 'N m'), ...parts(e.translation, MOTIONS, e.units?.[0] ?? 'm'),
                           ...parts(e.rotation, MOTIONS.slice(3), e.units?.[1] ?? 'rad')].join(', ') || '–';
  const phases = e => (e.phase?.some(p => p !== 0) ? vector(e.phase.map(p => p * 360 / TURN)) : '–');
  const row = e => [e.name, e.type, e.on ?? 'ground', e.at ? vector(e.at) : '–', amplitudes(e), phases(e)];
  return table(['excitation', 'type', 'on', 'at, body or ground axes [m]', 'components', 'phases of the six [°]'], excitations.map(row));
}
function inputsSection(c) {
  const {bodies, elements, excitations, foundations = [], gravity, damping} = c.model, part = (title, list, make) => [html('h3', {}, title), list.length ? make(list) : html('p', {}, 'None.')];
  return section('inputs', 'Inputs', part('Bodies', bodies, bodiesTables), part('Elements', elements, elementsTables), part('Excitations', excitations, excitationsTable),
    foundations.length ? [html('h3', {}, 'Flexible foundations'), table(['foundation', 'coordinate', num('mass [kg, kg m²]'), num('stiffness [N/m, N m/rad]'), num('damping')],
      foundations.flatMap(f => f.mass.map((row, i) => [f.name, i + 1, number(row[i]), number(f.stiffness[i][i]), number(f.damping[i][i])])))] : null,
    html('p', {}, gravity ? `Gravity ${vector(gravity)} m/s², ground axes; it affects static results, and the geometric stiffness if elements are preloaded.` : 'No gravity.'), html('p', {}, `Damping of the system: ${damping}.`));
}

// ---------------------------------------------------------------- all cases together

function failures(c) {
  const failed = c.checks.filter(k => !k.passed).map(k => `${k.subject}, “${k.what}”: ${k.value}`);
  if (c.response && !c.response.checks.second_solver.passed) failed.push('response: the second solver does not agree');
  return failed;
}
const allLimits = c => [...c.limits, ...(c.limit_lines ?? [])];
const brokenLimits = c => allLimits(c).filter(l => !l.kept).length;
const grows = c => (c.modes?.modes ?? []).some(m => m.angular_frequency === null) || (c.roots?.roots ?? []).some(r => r.kind === 'growing');

/// Equal texts of several cases listed once, with their cases: [{text, origin, of: [index]}].
function gathered(textsOf) {
  const found = new Map();
  cases.forEach((c, index) => textsOf(c).forEach(full => {
    const [, origin, rest] = /^(.*?:\d+: )?(?:warning: )?([^]*)$/.exec(full);
    const text = rest.replace(`case "${c.name}": `, '');
    if (!found.has(text)) found.set(text, {text, origin: origin?.replace(/: $/, ''), of: new Set()});
    found.get(text).of.add(index);
  }));
  return [...found.values()];
}
function notice(style, title, items) {
  if (!items.length) return null;
  const owners = item => (cases.length === 1 ? '' : item.of.size === cases.length ? 'all cases' : [...item.of].map(caseName).join(', '));
  const where = item => [item.origin, owners(item)].filter(Boolean).join('; ');
  const line = item => html('li', {}, item.text, where(item) ? html('span', {class: 'where'}, ` (${where(item)})`) : null);
  return html('div', {class: style, role: 'note'}, html('h2', {}, title), html('ul', {}, items.map(line)));
}
function buildNotices() {
  const warnings = gathered(c => c.warnings), failed = gathered(failures);
  const clean = cases.length && !warnings.length && !failed.length;
  const exceeded = cases.flatMap((c, i) => brokenLimits(c) ? [`${caseName(i)} (${brokenLimits(c)} of ${allLimits(c).length})`] : []);
  put('notices', notice('alert', `⚠ ${count(warnings.length, 'warning')}`, warnings), notice('alert', `✗ ${count(failed.length, 'failed check')}`, failed),
    notice('note', 'Rigid-body modes', gathered(c => c.free_motions)),
    exceeded.length ? html('p', {class: 'alert', role: 'note'}, bad('✗ Limits are exceeded: '), `${exceeded.join(', ')}; see below.`) : null,
    clean ? html('p', {class: exceeded.length ? 'note' : 'calm'}, `${exceeded.length ? '' : '✓ '}No warnings; all checks of the data passed${cases.length > 1 ? ' in all cases' : ''}.`) : null);
}

/// Verdict on a case from its own map, or else from the first map of the report.
const mapMark = c => (c.map ?? cases.find(other => other.map)?.map)?.marks.find(mark => (mark.case ?? '') === (c.name ?? ''));
function mapCell(c) {
  const mark = mapMark(c), whose = c.map && c.name ? ' (own map)' : '';
  return !mark ? '–' : 'kept' in mark ? verdict(mark.kept, 'met' + whose, 'VIOLATED' + whose) : bad('not computed');
}

function glanceRow(c, i) {
  const natural = naturalOf(c), limits = allLimits(c).length, broken = brokenLimits(c), failed = failures(c).length;
  const open = () => {
    change({case: i});
    byId('case-pictures').scrollIntoView();
  };
  return [html('button', {type: 'button', class: 'link', onclick: open}, caseName(i)), num(c.changes.length || '–'),
    c.warnings.length ? bad(`⚠ ${c.warnings.length}`) : 'none', verdict(!failed, 'ok', `${failed} FAILED`),
    limits ? verdict(!broken, 'met', `${broken} of ${limits} EXCEEDED`) : '–', ...(cases.some(mapMark) ? [mapCell(c)] : []),
    grows(c) ? bad('▲ unstable') : c.free_motions.length ? 'rigid-body mode' : 'stable',
    ...omegaAndHertz(natural.length ? smallestOf(natural) : null), ...omegaAndHertz(natural.length ? largestOf(natural) : null)];
}
function buildGlance() {
  if (!cases.length) return;
  byId('cases').append(table(['case', num('changes'), 'warnings', 'checks', 'limits', ...(cases.some(mapMark) ? ['rules of the map'] : []), 'motion', num('lowest mode [rad/s]'), num('[Hz]'), num('highest mode [rad/s]'), num('[Hz]')],
    cases.map(glanceRow)));
  byId('cases').hidden = false;
}

// ---------------------------------------------------------------- the page

function caseHead(c) {
  const faults = [c.warnings.length ? count(c.warnings.length, 'warning') : '', failures(c).length ? count(failures(c).length, 'failed check') : '', grows(c) ? 'unstable motion' : ''];
  const words = faults.filter(Boolean).join(', ');
  return section('case-head', cases.length > 1 ? `Case: ${caseName(view.case)}` : caseName(view.case),
    words ? html('p', {class: 'bad'}, `⚠ Check the results: ${words}; see the top of the page.`) : null,
    c.changes.length ? [html('p', {}, 'Changes from the base model:'), html('ul', {class: 'changes'}, c.changes.map(text => html('li', {}, html('code', {}, text))))] : null);
}

function buildCase() {
  const c = cases[view.case];
  cursor = null;
  for (const block of byId('case-answers').children) block.hidden = Number(block.dataset.case) !== view.case;
  put('case-pictures', caseHead(c), limitsSection(c), characteristics(c), peaksSection(c));
  put('case-tables', modesSection(c), rootsSection(c), staticSection(c), inputsSection(c), checksSection(c));
  buildComparison();
  const shown = [...document.querySelectorAll('main section')].filter(s => !s.closest('[hidden]') && s.id !== 'case-head');
  const link = s => html('button', {type: 'button', class: 'link', onclick: () => s.scrollIntoView()}, s.querySelector('h2').textContent);
  put('contents', shown.map(link));
  byId('switches').hidden = !allPictures().length;
}

/// Updates controls and address to the view and redraws the pictures.
function refresh() {
  for (const key of SWITCHES) byId(key).checked = view[key];
  byId('case').value = view.case;
  const range = pictures.length ? frequencyRange(pictures[0]) : [0, 0];
  [byId('from').value, byId('to').value] = range.map(w => Number((view.hz ? hertz(w) : w).toPrecision(5)));
  byId('zoom-unit').textContent = view.hz ? 'Hz' : 'rad/s';
  byId('unzoom').disabled = !view.zoom;
  document.querySelectorAll('#cases tbody tr').forEach((row, i) => row.classList.toggle('selected', i === view.case && cases.length > 1));
  for (const picture of allPictures()) drawPicture(picture);
  setCursor(cursor);
  writeAddress();
}
function change(patch) {
  Object.assign(view, patch);
  if ('case' in patch) buildCase();
  refresh();
}

/// The view in the address, as in #case=1&ylog&xlog&hz&zoom=2,40&compare=pump.z&hide=pump.x
function writeAddress() {
  const parts = SWITCHES.filter(key => view[key]);
  if (view.case) parts.unshift(`case=${view.case}`);
  if (view.zoom) parts.push(`zoom=${view.zoom.map(w => Number(w.toPrecision(6))).join(',')}`);
  if (view.compare && view.compare !== comparedNames()[0]) parts.push(`compare=${encodeURIComponent(view.compare)}`);
  if (view.hidden.size) parts.push(`hide=${[...view.hidden].map(encodeURIComponent).join(',')}`);
  try {
    history.replaceState(null, '', `#${parts.join('&')}`);
  } catch { /* some browsers do not allow this for files */ }
}
function decoded(text) {
  try { return decodeURIComponent(text); } catch { return ''; }
}
function readAddress() {
  const given = new Map(location.hash.slice(1).split('&').map(part => [part.split('=')[0], part.split('=').slice(1).join('=')]));
  const index = Number(given.get('case') ?? 0), zoom = (given.get('zoom') ?? '').split(',').map(Number);
  view.case = cases[index] ? index : 0;
  for (const key of SWITCHES) view[key] = given.has(key);
  view.zoom = zoom.length === 2 && zoom[0] >= 0 && zoom[1] > zoom[0] ? zoom : null;
  view.compare = decoded(given.get('compare') ?? '');
  view.hidden = new Set((given.get('hide') ?? '').split(',').filter(Boolean).map(decoded));
}

function zoomByNumbers() {
  const factor = view.hz ? TURN : 1, from = byId('from').valueAsNumber * factor;
  const to = Math.min(byId('to').valueAsNumber * factor, largestOf(allPictures().map(p => p.band[1])));
  if (from >= 0 && to > from) change({zoom: [from, to]});
}
function listenToControls() {
  byId('case').addEventListener('change', event => change({case: Number(event.target.value)}));
  for (const key of SWITCHES) byId(key).addEventListener('change', event => change({[key]: event.target.checked}));
  for (const id of ['from', 'to']) byId(id).addEventListener('change', zoomByNumbers);
  byId('unzoom').addEventListener('click', () => change({zoom: null}));
  byId('controls').addEventListener('submit', event => event.preventDefault());
  let timer = 0;
  window.addEventListener('resize', () => {
    clearTimeout(timer);
    timer = setTimeout(refresh, 150);
  });
}
function start() {
  put('input', `input ${results.input.file} · sha256 `, html('span', {class: 'hash'}, results.input.sha256));
  buildNotices();
  buildGlance();
  byId('overview').hidden = !drawable().length;
  byId('controls').hidden = !cases.length;
  if (!cases.length) return;
  put('case', cases.map((_, i) => html('option', {value: i}, caseName(i))));
  listenToControls();
  const follow = () => {
    readAddress();
    buildCase();
    refresh();
  };
  window.addEventListener('hashchange', follow);
  follow();
}
start();

})();
