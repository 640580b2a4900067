// SPDX-License-Identifier: BSD-3-Clause
// Values of the steady motions of a nonlinear machine: at one frequency there may be several.
import type {Steady} from '../results.ts';

/// A computed steady motion, in the units of the chart.
export interface SteadyValue {
  x: number;
  y: number;
  stable: boolean | null;  // null: uncertain
}
/// The computed motions of a result, branch after branch in their order.
export interface SteadyCurve {
  name: string;
  branches: SteadyValue[][];
}

/// Of the drawn results: half the peak-to-peak value.
/// @param frequency, value  into the units of the chart
export function steadyCurves(steady: Steady | null, unit: string, drawn: readonly string[], frequency: number, value: (amplitude: number) => number | null): SteadyCurve[] {
  if (steady?.over !== 'frequency') return [];
  return steady.results.flatMap((result, r) => {
    if (result.unit !== unit || !drawn.includes(result.name)) return [];
    const placed = (p: Steady['points'][number]): SteadyValue => ({x: p.angular_frequency * frequency, y: value((p.results[r]!.largest - p.results[r]!.smallest) / 2) ?? NaN, stable: p.stable});
    return [{name: result.name, branches: [steady, ...steady.further ?? []].map(b => b.points.map(placed))}];
  });
}
/// The motions at a place of the axis of frequencies, the largest first: each time a branch passes it, the nearer one of the two computed
/// motions there. Nothing is computed between them.
export function steadyReadings({branches}: SteadyCurve, x: number): SteadyValue[] {
  const found = new Set<SteadyValue>();
  for (const points of branches)
    for (let i = 1; i < points.length; i++) {
      const [a, b] = [points[i - 1]!, points[i]!];
      if (Math.min(a.x, b.x) <= x && x <= Math.max(a.x, b.x)) found.add(Math.abs(a.x - x) <= Math.abs(b.x - x) ? a : b);
    }
  return [...found].filter(p => !Number.isNaN(p.y)).sort((a, b) => b.y - a.y);
}
export const stabilityWords = ({stable}: Pick<SteadyValue, 'stable'>) => (stable === null ? 'of uncertain stability' : stable ? 'stable' : 'unstable');
