// SPDX-License-Identifier: BSD-3-Clause
// Curves of the cases from the data of the page, and numbers with units. All values in the data are SI and rad/s;
// amplitudes are converted to the units that the page shows.

const read = id => JSON.parse(document.getElementById(id).textContent);
const {cases} = read('results');
const {strokes, units, groups, frequency} = read('drawing');  // as in the figures for print, see drawing_json.h
const TURN = 2 * Math.PI;

/// Factor from an SI amplitude to the unit that the page shows.
const factorOf = unit => units[unit]?.factor ?? 1;
for (const c of cases) {
  for (const p of c.peaks) if (p.amplitude !== null) p.amplitude *= factorOf(p.unit);
  for (const l of c.limits) l.limit *= factorOf(l.unit);
}

const caseName = index => cases[index].name || 'Base model';

const smallestOf = values => values.reduce((least, v) => (v < least ? v : least), Infinity);
const largestOf = values => values.reduce((most, v) => (Number.isFinite(v) && v > most ? v : most), 0);
const hertz = omega => omega / TURN;

/// A number with significant digits, without zeros at the end, or with them in readings.
function number(value, digits, keepZeros = false) {
  if (!Number.isFinite(value)) return '–';
  if (value === 0) return '0';
  const size = Math.abs(value);
  const text = size >= 1e6 || size < 1e-4 ? value.toExponential(digits - 1) : value.toPrecision(digits);
  if (keepZeros || !/[.e]/.test(text)) return text;
  return text.includes('e') ? text.replace(/\.?0*e\+?/, 'e') : text.replace(/\.?0+$/, '');
}
const reading = (value, digits) => number(value, digits, true);

/// The multiple of a unit that suits the largest value: {factor, unit}, as 1000 and "mm".
function multiple(largest, unit) {
  const {multiples, round_off: roundOff = 0} = units[unit];
  if (largest < roundOff) largest = 0;  // round-off has no prefix
  const [size, name] = multiples.findLast(([least]) => largest >= least * (1 - 1e-9)) ?? multiples[0];
  const plain = multiples.find(([least]) => least === 1)?.[1] ?? unit;
  return largest > 0 ? {factor: 1 / size, unit: name} : {factor: 1, unit: plain};
}
function withUnit(value, unit, digits) {
  if (!Number.isFinite(value)) return '∞';
  if (Math.abs(value) < (units[unit].round_off ?? 0)) return '0';
  const suited = multiple(Math.abs(value), unit);
  return `${reading(value * suited.factor, digits)} ${suited.unit}`;
}
const frequencyWords = omega => (frequency ? `${reading(omega * frequency.factor, 6)} ${frequency.unit}`
                                           : `ω = ${reading(omega, 6)} rad/s, f = ${reading(hertz(omega), 6)} Hz`);

/// Values [re, im, re, im, …] of all curves of a model at ω: Σ w v/(ω − x) / Σ w/(ω − x) over the nodes x, times
/// e^{−iωd} for each delay d.
function modelAt(model, w) {
  if (model.at) return model.at(w);  // a design of a map, from its poles
  const {nodes, weights, values} = model.pieces.find(p => w <= p.band[1]) ?? model.pieces.at(-1);
  const n = nodes.length, hit = nodes.indexOf(w), curves = model.results.length;
  const result = new Float64Array(2 * curves), shares = new Float64Array(2 * n);
  if (model.undefined_at.includes(w)) return result.fill(NaN);
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
    const size = v => Math.hypot(v[2 * c], v[2 * c + 1]), [from, middle, to] = [size(a), size(m), size(b)];
    const most = Math.max(from, middle, to);
    if (Number.isNaN(most) && tops[c] < Infinity) return true;  // up to a frequency without a result
    if (!(most > 1e-6 * tops[c])) continue;  // its shape there is invisible
    if (Math.abs(middle - (1 - part) * from - part * to) > 7e-4 * Math.max(middle, 1e-3 * most)) return true;
    const turn = (u, v) => Math.abs(Math.atan2(u[2 * c] * v[2 * c + 1] - u[2 * c + 1] * v[2 * c],
                                               u[2 * c] * v[2 * c] + u[2 * c + 1] * v[2 * c + 1]));
    if (turn(a, m) > Math.PI / 9 || turn(m, b) > Math.PI / 9) return true;
  }
  return false;
}

/// Frequencies between which straight lines approximate all curves of a model, and its values there.
function sampled(model, vanishing, unbounded) {
  const [from, to] = model.band, first = new Set(model.undefined_at);
  for (let i = 0; i <= 64; i++) first.add(from + (to - from) * i / 64);
  for (const p of model.pieces) for (const w of [...p.band, ...p.nodes]) first.add(w);
  for (const r of model.results) for (const [w] of r.extrema) first.add(w);
  const inBand = [...first].filter(w => w >= from && w <= to).sort((a, b) => a - b);
  const points = inBand.map(w => ({w, v: modelAt(model, w)}));
  const heights = model.results.map((_, c) => largestOf(points.map(p => Math.hypot(p.v[2 * c], p.v[2 * c + 1]))));
  const ofUnit = unit => largestOf(heights.filter((_, c) => model.results[c].unit === unit));
  const noise = (r, c) => vanishing[c] || heights[c] < 1e-10 * ofUnit(r.unit);  // there the model is only round-off
  const tops = model.results.map((r, c) => (noise(r, c) ? Infinity : unbounded[c] ? 0 : heights[c]));
  const result = [], open = points.reverse();  // a stack: its last two are the current interval
  while (open.length > 1) {
    const a = open.pop(), b = open.at(-1);
    const inner = [0.25, 0.5, 0.75].map(part => ({part, w: a.w + part * (b.w - a.w)}));
    for (const m of inner) m.v = modelAt(model, m.w);
    const wide = b.w - a.w > 1e-9 * b.w && result.length + open.length < 20000;
    if (wide && inner.some(m => bends(a.v, m.v, b.v, m.part, tops))) open.push({w: inner[1].w, v: inner[1].v}, a);
    else result.push(a);
  }
  return [...result, ...open];
}

const same = (a, b) => a.name === b.name && a.unit === b.unit;

/// Curves of a model in the form of a table, with exact heights at the maxima.
function tabled(c) {
  const packed = p => ({...p, weights: Float64Array.from(p.weights), values: p.values.map(v => Float64Array.from(v))});
  const model = c.response.at ? c.response : {...c.response, pieces: c.response.pieces.map(packed)};
  if (!model.pieces.length)
    return {angular_frequency: [], results: model.results.map(r => ({...r, complex: [], phase: []}))};
  const vanishing = model.results.map(r => (c.vanishing ?? []).some(v => same(v, r)));
  const unbounded = model.results.map(r => c.peaks.some(p => p.unbounded && same(p, r)));
  const drawn = sampled(model, vanishing, unbounded), points = model.completed ? model.completed(drawn) : drawn;
  const results = model.results.map((r, curve) => {
    const exact = new Map(r.extrema);
    let last = r.first_phase;
    const complex = points.map(({w, v}) => {
      const [re, im] = [v[2 * curve], v[2 * curve + 1]], size = Math.hypot(re, im);
      const factor = size > 0 ? (exact.get(w) ?? size) / size : 1;
      return Number.isFinite(size) ? [re * factor, im * factor] : null;
    });
    const phase = complex.map(z => {
      if (!z) return null;
      const isReal = Math.abs(z[1]) <= 1e-9 * Math.abs(z[0]);  // the sign of round-off would change at random
      const angle = isReal ? (z[0] < 0 ? Math.PI : 0) : Math.atan2(z[1], z[0]);
      const turns = model.continuous_phase && last !== null ? Math.round((last - angle) / TURN) : 0;
      return last = angle + TURN * turns;
    });
    return {...r, complex, phase};
  });
  return {angular_frequency: points.map(p => p.w), results};
}

/// Curves of a case in ascending ω: amplitude in the shown unit, phase in degrees; null if the result is not defined.
function readCurves(c) {
  const response = c.response.pieces ? tabled(c) : c.response, all = response.angular_frequency;
  const order = all.map((_, i) => i).sort((a, b) => all[a] - all[b]), omega = order.map(i => all[i]);
  return response.results.map(r => {
    const factor = factorOf(r.unit);
    const amplitude = order.map(i => (r.complex[i] ? factor * Math.hypot(...r.complex[i]) : null));
    const phase = order.map((i, k) => (amplitude[k] > 0 && r.phase[i] !== null ? r.phase[i] * 360 / TURN : null));
    return {key: r.name, name: r.name, unit: r.unit, omega, amplitude, phase,
            peaks: c.peaks.filter(p => same(p, r)), limits: c.limits.filter(l => same(l, r)),
            vanishes: (c.vanishing ?? []).some(v => same(v, r))};
  });
}
const known = new WeakMap();
function curvesOf(c) {
  if (!known.has(c)) known.set(c, c.response ? readCurves(c) : []);
  return known.get(c);
}
const frequencies = c => curvesOf(c)[0]?.omega ?? [];
const bandOf = c => [frequencies(c)[0], frequencies(c).at(-1)];
const inside = (item, [from, to]) => item.angular_frequency >= from && item.angular_frequency <= to;
const landmarksOf = c => [...c.modes, ...c.peaks].map(item => item.angular_frequency);
const styled = (curve, i) => ({...curve, ...strokes[i % strokes.length]});

/// Index of the drawn frequency nearest to ω.
function nearestIndex(omega, w) {
  let low = 0, high = omega.length - 1;
  while (high - low > 1) omega[(low + high) >> 1] < w ? low = (low + high) >> 1 : high = (low + high) >> 1;
  return high >= 0 && omega[high] - w < w - omega[low] ? high : low;
}
/// Amplitude at ω on the drawn line; NaN outside it.
function amplitudeAt({omega, amplitude}, w) {
  const i = nearestIndex(omega, w), j = w < omega[i] ? i - 1 : i + 1;
  if (Math.abs(omega[i] - w) <= 1e-9 * w) return amplitude[i] ?? NaN;
  if (amplitude[i] === null || (amplitude[j] ?? null) === null) return NaN;
  return amplitude[i] + (amplitude[j] - amplitude[i]) * (w - omega[i]) / (omega[j] - omega[i]);
}
/// Points [ω, amplitude] of the line inside a range, with interpolated ends.
function inRange(curve, from, to) {
  const points = [[from, amplitudeAt(curve, from)]];
  for (let i = nearestIndex(curve.omega, from); curve.omega[i] <= to; i++)
    if (curve.omega[i] >= from) points.push([curve.omega[i], curve.amplitude[i]]);
  return [...points, [to, amplitudeAt(curve, to)]].filter(p => p[1] > 0);
}
