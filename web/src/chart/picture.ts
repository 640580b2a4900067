// SPDX-License-Identifier: BSD-3-Clause
import type {Display} from '../display.ts';
import {FREQUENCY_UNITS, scaleOf} from '../quantities.ts';
import type {Curves, Steady} from '../results.ts';
import {drawnFrequencies, sampledCurves} from '../sampled_curves.ts';
import {steadyOverlays, type Overlay} from './overlays.ts';
import type {Picture, Shown} from './plot.ts';

/// What the user chose to see of the curves.
export interface Choice {
  model: number;
  unit: string;
  hidden: ReadonlySet<string>;
}
const POINTS = 420;

export const unitsOf = ({results, vanishing = []}: Curves) =>
  [...new Set(results.filter(r => !vanishing.includes(r.name)).map(r => r.unit))];

/// Curves of one unit in the units of the page.
export function pictureOf(curves: Curves, choice: Choice, display: Display, steady: Steady | null = null, kept: Curves | null = null): Picture {
  const frequency = FREQUENCY_UNITS[display.frequencyUnit];
  const indices = curves.results.map((_, i) => i).filter(i => curves.results[i]!.unit === choice.unit && !curves.vanishing?.includes(curves.results[i]!.name));
  const seen = indices.filter(i => !choice.hidden.has(curves.results[i]!.name));
  const omega = drawnFrequencies(curves, POINTS, display.logarithmicFrequency, seen), sampled = sampledCurves(curves, choice.model, omega, seen);
  const limitOf = (name: string) => curves.limits.find(l => l.result === name)?.limit ?? null;
  const largest = seen.reduce((top, i) => sampled.amplitude[i]!.reduce<number>((t, a) => Math.max(t, a ?? 0), top), 0);
  const scale = display.decibel ? {factor: 1, unit: choice.unit} : scaleOf(largest, choice.unit);
  const names = indices.map(i => curves.results[i]!.name);
  const shownValue = (v: number | null) => {
    if (v === null || !(v > 0 || !display.decibel && !display.logarithmicAmplitude)) return null;
    return display.decibel ? 20 * Math.log10(v) : v * scale.factor;
  };
  const shown = seen.map((i): Shown => {
    const {name} = curves.results[i]!;
    return {name, stroke: indices.indexOf(i), amplitude: sampled.amplitude[i]!.map(shownValue), phase: sampled.phase[i]!,
            limit: shownValue(limitOf(name)), peaks: curves.peaks.filter(p => p.result === name && p.amplitude !== null && p.amplitude > 1e-4 * largest)
              .map(p => ({x: p.angular_frequency * frequency, y: shownValue(p.amplitude)!}))};
  });
  const overlays: Overlay[] = steady ? steadyOverlays(steady, names, frequency, shownValue).filter(o => !choice.hidden.has(o.name)) : [];
  for (const line of curves.lines ?? []) {
    const stroke = names.indexOf(line.result), level = line.rms ? Math.SQRT2 : 1;
    if (stroke < 0 || line.unit !== choice.unit || choice.hidden.has(line.result)) continue;
    overlays.push({name: line.result, stroke, kind: 'limit', points: line.angular_frequency.map((w, k) => [w * frequency, shownValue(level * line.limit[k]!)])});
  }
  if (kept) overlays.push(...keptOverlays(kept, choice, display, names, shownValue));
  return {overlays, x: omega.map(w => w * frequency), curves: shown, natural: curves.natural.map(w => w * frequency), scale,
          cursor: display.cursor === null ? null : display.cursor * frequency};
}

/// Curves as they were when the user kept them, dashed.
function keptOverlays(kept: Curves, choice: Choice, display: Display, names: readonly string[], shownValue: (v: number | null) => number | null): Overlay[] {
  const omega = drawnFrequencies(kept, POINTS, display.logarithmicFrequency), sampled = sampledCurves(kept, choice.model, omega);
  return kept.results.flatMap(({name}, i): Overlay[] => {
    const stroke = names.indexOf(name);
    if (stroke < 0 || choice.hidden.has(name)) return [];
    return [{name, stroke, kind: 'kept', points: omega.map((w, k) => [w * FREQUENCY_UNITS[display.frequencyUnit], shownValue(sampled.amplitude[i]![k]!)])}];
  });
}
