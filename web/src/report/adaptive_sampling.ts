// SPDX-License-Identifier: BSD-3-Clause
// Frequencies between which straight lines approximate curves at any zoom: the report has time for them, a moving slider has not
// (sampled_curves.ts).

/// What is known of the curves: their band and results, and frequencies near which they change fast.
export interface SampledModel {
  band: readonly [number, number];
  undefined_at: readonly number[];
  pieces: readonly {band: readonly [number, number]; nodes: readonly number[]}[];
  results: readonly {unit: string; extrema: readonly (readonly [number, number])[]}[];
}
export interface Sample {
  w: number;
  v: Float64Array;  // re, im of each result
}
const size = ({v}: Sample, c: number) => Math.hypot(v[2 * c]!, v[2 * c + 1]!);

/// Does any curve deviate from the straight line between two frequencies, or does its phase change too fast?
function bends(a: Sample, m: Sample & {part: number}, b: Sample, tops: readonly number[]): boolean {
  const turn = ({v: u}: Sample, {v}: Sample, re: number, im: number) =>
    Math.abs(Math.atan2(u[re]! * v[im]! - u[im]! * v[re]!, u[re]! * v[re]! + u[im]! * v[im]!));
  for (let c = 0; c < tops.length; c++) {
    const [from, middle, to] = [size(a, c), size(m, c), size(b, c)], most = Math.max(from, middle, to);
    if (Number.isNaN(most) && tops[c]! < Infinity) return true;  // up to a frequency without a result
    if (!(most > 1e-6 * tops[c]!)) continue;  // its shape there is invisible
    if (Math.abs(middle - (1 - m.part) * from - m.part * to) > 7e-4 * Math.max(middle, 1e-3 * most)) return true;
    const re = 2 * c, im = re + 1;
    if (turn(a, m, re, im) > Math.PI / 9 || turn(m, b, re, im) > Math.PI / 9) return true;
  }
  return false;
}

/// The frequencies of a drawing, ascending, with the values there.
/// @param at  values at ω; each call returns an array of its own
/// @param vanishing, unbounded  of each result
export function adaptiveSamples(model: SampledModel, at: (w: number) => Float64Array, vanishing: readonly boolean[],
                                unbounded: readonly boolean[]): Sample[] {
  const [from, to] = model.band, first = new Set(model.undefined_at);
  for (let i = 0; i <= 64; i++) first.add(from + (to - from) * i / 64);
  for (const p of model.pieces) for (const w of [...p.band, ...p.nodes]) first.add(w);
  for (const r of model.results) for (const [w] of r.extrema) first.add(w);
  const inBand = [...first].filter(w => w >= from && w <= to).sort((a, b) => a - b);
  const points = inBand.map((w): Sample => ({w, v: at(w)}));
  const largest = (values: readonly number[]) => values.reduce((most, v) => (Number.isFinite(v) && v > most ? v : most), 0);
  const heights = model.results.map((_, c) => largest(points.map(p => size(p, c))));
  const ofUnit = (unit: string) => largest(heights.filter((_, c) => model.results[c]!.unit === unit));
  const noise = (c: number) => vanishing[c] || heights[c]! < 1e-10 * ofUnit(model.results[c]!.unit);  // only round-off
  const tops = heights.map((height, c) => (noise(c) ? Infinity : unbounded[c] ? 0 : height));
  const result: Sample[] = [], open = points.reverse();  // a stack: its last two are the current interval
  while (open.length > 1) {
    const a = open.pop()!, b = open.at(-1)!;
    const inner = [0.25, 0.5, 0.75].map(part => {
      const w = a.w + part * (b.w - a.w);
      return {part, w, v: at(w)};
    });
    const wide = b.w - a.w > 1e-9 * b.w && result.length + open.length < 20000;
    if (wide && inner.some(m => bends(a, m, b, tops))) open.push({w: inner[1]!.w, v: inner[1]!.v}, a);
    else result.push(a);
  }
  return [...result, ...open];
}
