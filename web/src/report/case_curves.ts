// SPDX-License-Identifier: BSD-3-Clause
// Curves of the cases, from the models or the tables of the report's data.
import {angleOf, ModelValues} from '../rational_model.ts';
import type {Complex} from '../results.ts';
import {adaptiveSamples} from './adaptive_sampling.ts';
import {factorOf, strokes, TURN, type Case, type DesignResponse, type Limit, type Model, type Named, type Peak,
        type Table} from './report_data.ts';

/// A curve as it is drawn: amplitude in the shown unit, phase in degrees; null where the result is not defined.
export interface Curve extends Named {
  key: string;
  omega: number[];
  amplitude: (number | null)[];
  phase: (number | null)[];
  peaks: Peak[];
  limits: Limit[];
  vanishes: boolean;
}

export const same = (a: Named, b: Named) => a.name === b.name && a.unit === b.unit;

/// Curves of a model in the form of a table, with exact heights at the maxima.
function tabled(c: Case, model: Model | DesignResponse): Table {
  if (!model.pieces.length)
    return {angular_frequency: [], results: model.results.map(r => ({...r, complex: [], phase: []}))};
  const vanishing = model.results.map(r => (c.vanishing ?? []).some(v => same(v, r)));
  const unbounded = model.results.map(r => c.peaks.some(p => p.unbounded && same(p, r)));
  const of_design = 'at' in model, drawn = adaptiveSamples(model, of_design ? model.at : valuesOf(model), vanishing, unbounded);
  const points = of_design ? model.completed(drawn) : drawn;
  const results = model.results.map((r, curve) => {
    const exact = new Map(r.extrema);
    let last = r.first_phase;
    const complex = points.map(({w, v}): Complex | null => {
      const re = v[2 * curve]!, im = v[2 * curve + 1]!, size = Math.hypot(re, im);
      const factor = size > 0 ? (exact.get(w) ?? size) / size : 1;
      return Number.isFinite(size) ? [re * factor, im * factor] : null;
    });
    const phase = complex.map(z => {
      if (!z) return null;
      const angle = angleOf(...z);
      const turns = model.continuous_phase && last !== null ? Math.round((last - angle) / TURN) : 0;
      return last = angle + TURN * turns;
    });
    return {...r, complex, phase};
  });
  return {angular_frequency: points.map(p => p.w), results};
}
/// Evaluates a rational model.
function valuesOf(model: Model) {
  const values = new ModelValues(model, model.results.length);
  return (w: number) => values.at(w).slice();
}

/// Curves of a case in ascending ω.
function readCurves(c: Case, given: NonNullable<Case['response']>): Curve[] {
  const response = 'pieces' in given ? tabled(c, given) : given, all = response.angular_frequency;
  const order = all.map((_, i) => i).sort((a, b) => all[a]! - all[b]!), omega = order.map(i => all[i]!);
  return response.results.map(r => {
    const factor = factorOf(r.unit);
    const amplitude = order.map(i => (r.complex[i] ? factor * Math.hypot(...r.complex[i]) : null));
    const phase = order.map((i, k) => (amplitude[k]! > 0 && r.phase[i] !== null ? r.phase[i]! * 360 / TURN : null));
    return {key: r.name, name: r.name, unit: r.unit, omega, amplitude, phase,
            peaks: c.peaks.filter(p => same(p, r)), limits: c.limits.filter(l => same(l, r)),
            vanishes: (c.vanishing ?? []).some(v => same(v, r))};
  });
}
const known = new WeakMap<Case, Curve[]>();
export function curvesOf(c: Case): Curve[] {
  if (!known.has(c)) known.set(c, c.response ? readCurves(c, c.response) : []);
  return known.get(c)!;
}
export const frequencies = (c: Case) => curvesOf(c)[0]?.omega ?? [];
export const bandOf = (c: Case) => [frequencies(c)[0], frequencies(c).at(-1)];
export const inside = (item: {angular_frequency: number}, [from, to]: readonly [number, number]) =>
  item.angular_frequency >= from && item.angular_frequency <= to;
export const landmarksOf = (c: Case) => [...c.modes, ...c.peaks].map(item => item.angular_frequency);
export const styled = <T extends Named>(curve: T, i: number) => ({...curve, ...strokes[i % strokes.length]!});
