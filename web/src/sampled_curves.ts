// SPDX-License-Identifier: BSD-3-Clause
import {angleOf, ModelValues} from './rational_model.ts';
import type {Curves} from './results.ts';

/// Amplitude in SI and phase in degrees, −180 to 180, of each result over ω [rad/s]; null where it is not defined.
export interface SampledCurves {
  omega: number[];
  amplitude: (number | null)[][];
  phase: (number | null)[][];
}

/// Distances from a peak, relative to its frequency, at which its flanks are drawn.
const FLANKS = Array.from({length: 9}, (_, k) => 10 ** (-4 + 0.375 * k));
const SAME_PEAK = 1e-3;  // peaks of several results at nearly one frequency share their flanks
const FINEST = 5;  // points of a draft to one of the evenly spaced: less than a pixel apart

/// Frequencies of a drawing of the `wanted` results: evenly spaced on the axis, with their extrema, all natural frequencies, and the flanks
/// of peaks and modes. Of a draft, which a moving slider replaces at once, none are closer than the pixels.
export function drawnFrequencies(curves: Curves, count: number, logarithmic: boolean, wanted = curves.results.map((_, i) => i)): number[] {
  const [begin, to] = curves.band, start = begin > 0 ? begin : to * 1e-3, from = logarithmic ? start : begin, all: number[] = [from, to];
  for (let i = 0; i <= count; i++) {
    const part = i / count;
    all.push(logarithmic ? start * (to / start) ** part : from + (to - from) * part);
  }
  const names = new Set(wanted.map(i => curves.results[i]!.name)), peaks = curves.peaks.filter(p => names.has(p.result)).map(p => p.angular_frequency);
  for (const i of wanted) for (const [w] of curves.results[i]!.extrema ?? []) all.push(w);
  const centres = [...curves.natural, ...peaks];
  all.push(...centres);
  let last = 0;
  for (const w of centres.sort((a, b) => a - b)) {
    if (w - last < SAME_PEAK * w) continue;
    last = w;
    for (const d of FLANKS) all.push(w * (1 - d), w * (1 + d));
  }
  const sorted = [...new Set(all)].filter(w => w >= from && w <= to).sort((a, b) => a - b);
  if (!curves.draft) return sorted;
  const kept = new Set(centres), nearest = 1 / (FINEST * count);
  const apart = (a: number, b: number) => (logarithmic ? Math.log(b / a) / Math.log(to / start) : (b - a) / (to - from)) > nearest;
  let before = -Infinity;
  return sorted.filter(w => {
    const stays = kept.has(w) || w === to || before < start || apart(before, w);
    if (stays) before = w;
    return stays;
  });
}

/// Curves of one excitation; those that are not `wanted` are empty. Peaks have the exact amplitude that the program found.
export function sampledCurves(curves: Curves, model: number, omega: number[], wanted = curves.results.map((_, i) => i)): SampledCurves {
  const {results} = curves, chosen = curves.models[model];
  const amplitude: (number | null)[][] = results.map(() => []), phase: (number | null)[][] = results.map(() => []);
  if (!chosen) return {omega: [], amplitude, phase};
  const exact = wanted.map(i => new Map<number, number | null>([
    ...results[i]!.extrema ?? [], ...curves.peaks.filter(p => p.result === results[i]!.name).map(p => [p.angular_frequency, p.amplitude] as const)]));
  const evaluated = new ModelValues(chosen, results.length, wanted);
  for (const w of omega) {
    const values = evaluated.at(w);
    for (let k = 0; k < wanted.length; k++) {
      const c = wanted[k]!, re = values[2 * k]!, im = values[2 * k + 1]!, size = Math.sqrt(re * re + im * im);
      const defined = Number.isFinite(size);
      amplitude[c]!.push(defined ? exact[k]!.get(w) ?? size : null);
      phase[c]!.push(defined && size > 0 ? angleOf(re, im) * 180 / Math.PI : null);
    }
  }
  return {omega, amplitude, phase};
}

/// Does any curve of a result exceed its limit, and where? Frequencies of the drawing above it.
export const exceeds = (amplitude: readonly (number | null)[], limit: number) => amplitude.some(a => a !== null && a > limit);
