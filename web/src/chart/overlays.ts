// SPDX-License-Identifier: BSD-3-Clause
// Lines over the characteristics: curves kept for comparison, limit lines, periodic motions of a nonlinear machine.
import type {Curves, Measurement, SampledBand, Steady} from '../results.ts';

export interface Overlay {
  name: string;
  stroke: number;
  kind: 'compared' | 'measured' | 'limit' | 'violated' | 'unbinding' | 'stable' | 'unstable' | 'jump' | 'band';
  dash?: readonly number[];  // of compared curves
  of?: string;  // what is compared: its key
  points: (readonly [number, number | null])[];  // in the units of the chart; of a band its lower edge
  upper?: Overlay['points'];  // of a band, at the same frequencies
}
type Value = (amplitude: number) => number | null;

/// Curves of the same results of another machine, beside those on the page.
export interface Compared {
  key: string;
  label: string;
  curves: Curves | null;  // null: not there yet
  measured?: readonly Measurement[];
  old: boolean;
  failure: string;
  dash: readonly number[];
}
/// Amplitudes that were measured, of the drawn results in their unit.
export function measuredOverlays(measured: readonly Measurement[], of: string, unit: string, results: readonly string[], frequency: number, value: Value): Overlay[] {
  return measured.flatMap(({channels}) => channels.flatMap((channel): Overlay[] => {
    const stroke = results.indexOf(channel.result);
    if (stroke < 0 || channel.unit !== unit) return [];
    return [{name: channel.result, stroke, kind: 'measured', of, points: channel.angular_frequency.map((w, i) => [w * frequency, value(Math.hypot(...channel.measured[i]!))])}];
  }));
}

/// From 5 to 95 % of the designs within the tolerances, behind the curves of the same quantity.
export function bandOverlays(bands: readonly SampledBand[], unit: string, results: readonly string[], frequency: number, value: Value): Overlay[] {
  return bands.flatMap((band): Overlay[] => {
    const stroke = results.indexOf(band.result), edge = (amplitudes: SampledBand['low']) => band.angular_frequency.map((w, i) => [w * frequency, amplitudes[i] == null ? null : value(amplitudes[i])] as const);
    return stroke < 0 || band.unit !== unit ? [] : [{name: band.result, stroke, kind: 'band', points: edge(band.low), upper: edge(band.high)}];
  });
}
/// A band at a place of the axis of frequencies. Null outside.
export function bandAt(overlay: Overlay, x: number): [number, number] | null {
  const low = readingAt(overlay, x), high = readingAt({...overlay, points: overlay.upper ?? []}, x);
  return low && high && [low.y, high.y];
}

/// What is compared with a curve, at a place of the axis of frequencies: between the two nearest points of a curve, or the nearest measured
/// point, which may be at another place. Null outside.
export function readingAt({kind, points}: Overlay, x: number): {x: number; y: number} | null {
  const after = points.findIndex(p => p[0] >= x), b = points[after], a = points[after - 1] ?? b;
  if (!a || !b || (after === 0 && b[0] > x)) return null;
  const part = b[0] > a[0] ? (x - a[0]) / (b[0] - a[0]) : 0;
  if (kind === 'measured') {
    const [at, y] = part < 0.5 ? a : b;
    return y === null ? null : {x: at, y};
  }
  const y = part === 0 ? a[1] : part === 1 ? b[1] : a[1] === null || b[1] === null ? null : a[1] + part * (b[1] - a[1]);
  return y === null ? null : {x, y};
}

/// Half the peak-to-peak values of the periodic motions over frequency, in parts that are stable or unstable, and the
/// jumps from folds to where they land.
export function steadyOverlays(steady: Steady, shownUnit: string, results: readonly string[], frequency: number, value: Value): Overlay[] {
  if (steady.over !== 'frequency') return [];
  const overlays: Overlay[] = [];
  steady.results.forEach(({name, unit}, r) => {
    const stroke = results.indexOf(name);
    if (stroke < 0 || unit !== shownUnit) return;
    const place = (p: Steady['points'][number]) => [p.angular_frequency * frequency, value((p.results[r]!.largest - p.results[r]!.smallest) / 2)] as const;
    for (const branch of [steady, ...steady.further ?? []]) {
      overlays.push(...partsByStability(branch.points, place).map(({stable, points}): Overlay => ({name, stroke, kind: stable ? 'stable' : 'unstable', points})));
      for (const {point, lands} of branch.folds) if (lands) overlays.push({name, stroke, kind: 'jump', points: [place(point), place(lands)]});
    }
  });
  return overlays;
}
/// The largest stable steady motion of each result.
export function largestSteady(overlays: readonly Overlay[]): {x: number; y: number; stroke: number}[] {
  const largest = new Map<string, {x: number; y: number; stroke: number}>();
  for (const {kind, name, stroke, points} of overlays)
    if (kind === 'stable') for (const [x, y] of points) if (y !== null && y > (largest.get(name)?.y ?? -Infinity)) largest.set(name, {x, y, stroke});
  return [...largest.values()];
}
/// Parts of a branch between changes of its stability; neighbours share their end.
export function partsByStability<P extends {stable: boolean | null}, T>(points: readonly P[], place: (point: P) => T): {stable: boolean; points: T[]}[] {
  const parts: {stable: boolean; points: T[]}[] = [];
  points.forEach((point, i) => {
    const last = parts.at(-1), stable = point.stable === true;
    if (last?.stable === stable) last.points.push(place(point));
    else parts.push({stable, points: i > 0 ? [place(points[i - 1]!), place(point)] : [place(point)]});
  });
  return parts;
}
