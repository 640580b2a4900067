// SPDX-License-Identifier: BSD-3-Clause
import type {Display} from '../display.ts';
import {FREQUENCY_UNITS, scaleOf} from '../quantities.ts';
import type {Curves} from '../results.ts';
import {drawnFrequencies, sampledCurves} from '../sampled_curves.ts';
import type {Picture, Shown} from './plot.ts';

/// What the user chose to see of the curves.
export interface Choice {
  model: number;
  unit: string;
  hidden: ReadonlySet<string>;
}
const POINTS = 420;

export const unitsOf = (curves: Curves) => [...new Set(curves.results.map(r => r.unit))];

/// Curves of one unit in the units of the page.
export function pictureOf(curves: Curves, choice: Choice, display: Display): Picture {
  const omega = drawnFrequencies(curves, POINTS, display.logarithmicFrequency), sampled = sampledCurves(curves, choice.model, omega);
  const frequency = FREQUENCY_UNITS[display.frequencyUnit];
  const indices = curves.results.map((_, i) => i).filter(i => curves.results[i]!.unit === choice.unit);
  const seen = indices.filter(i => !choice.hidden.has(curves.results[i]!.name));
  const limitOf = (name: string) => curves.limits.find(l => l.result === name)?.limit ?? null;
  const largest = seen.reduce((top, i) => sampled.amplitude[i]!.reduce<number>((t, a) => Math.max(t, a ?? 0), top), 0);
  const scale = display.decibel ? {factor: 1, unit: choice.unit} : scaleOf(largest, choice.unit);
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
  return {x: omega.map(w => w * frequency), curves: shown, natural: curves.natural.map(w => w * frequency), scale,
          cursor: display.cursor === null ? null : display.cursor * frequency};
}
