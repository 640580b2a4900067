// SPDX-License-Identifier: BSD-3-Clause
// Lines over the characteristics: curves kept for comparison, limit lines, periodic motions of a nonlinear machine.
import type {Steady} from '../results.ts';

export interface Overlay {
  name: string;
  stroke: number;
  kind: 'kept' | 'limit' | 'stable' | 'unstable' | 'jump';
  points: (readonly [number, number | null])[];  // in the units of the chart
}
type Value = (amplitude: number) => number | null;

/// Half the peak-to-peak values of the periodic motions over frequency, in parts that are stable or unstable, and the
/// jumps from folds to where they land.
export function steadyOverlays(steady: Steady, results: readonly string[], frequency: number, value: Value): Overlay[] {
  if (steady.over !== 'frequency') return [];
  const overlays: Overlay[] = [];
  steady.results.forEach(({name}, r) => {
    const stroke = results.indexOf(name);
    if (stroke < 0) return;
    const place = (p: Steady['points'][number]) => [p.angular_frequency * frequency, value((p.results[r]!.largest - p.results[r]!.smallest) / 2)] as const;
    for (const branch of [steady, ...steady.further ?? []]) {
      overlays.push(...partsByStability(branch.points, place).map(({stable, points}): Overlay => ({name, stroke, kind: stable ? 'stable' : 'unstable', points})));
      for (const {point, lands} of branch.folds) if (lands) overlays.push({name, stroke, kind: 'jump', points: [place(point), place(lands)]});
    }
  });
  return overlays;
}
/// Parts of a branch between changes of its stability; neighbours share their end.
export function partsByStability<P extends {stable: boolean}, T>(points: readonly P[], place: (point: P) => T): {stable: boolean; points: T[]}[] {
  const parts: {stable: boolean; points: T[]}[] = [];
  points.forEach((point, i) => {
    const last = parts.at(-1);
    if (last?.stable === point.stable) last.points.push(place(point));
    else parts.push({stable: point.stable, points: i > 0 ? [place(points[i - 1]!), place(point)] : [place(point)]});
  });
  return parts;
}
