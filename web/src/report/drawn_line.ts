// SPDX-License-Identifier: BSD-3-Clause
// A curve as a line through its points, and the parts of it that a reader sees.
import type {Point} from './amplitude_range.ts';

interface Line {
  omega: readonly number[];  // ascending
  amplitude: readonly (number | null)[];  // null: a gap
}

/// Index of the drawn frequency nearest to ω.
export function nearestIndex(omega: ArrayLike<number>, w: number): number {
  let low = 0, high = omega.length - 1;
  while (high - low > 1) omega[(low + high) >> 1]! < w ? low = (low + high) >> 1 : high = (low + high) >> 1;
  return high >= 0 && omega[high]! - w < w - omega[low]! ? high : low;
}
/// Amplitude at ω on the drawn line; NaN outside it.
export function amplitudeAt({omega, amplitude}: Line, w: number): number {
  const i = nearestIndex(omega, w), j = w < omega[i]! ? i - 1 : i + 1, [here, there] = [amplitude[i] ?? null, amplitude[j] ?? null];
  if (Math.abs(omega[i]! - w) <= 1e-9 * w) return here ?? NaN;
  if (here === null || there === null) return NaN;
  return here + (there - here) * (w - omega[i]!) / (omega[j]! - omega[i]!);
}
/// Points [ω, amplitude] of the line inside a range, with interpolated ends; NaN in gaps.
export function inRange(line: Line, from: number, to: number): Point[] {
  const points: Point[] = [[from, amplitudeAt(line, from)]];
  for (let i = nearestIndex(line.omega, from); line.omega[i]! < to; i++)
    if (line.omega[i]! > from) points.push([line.omega[i]!, line.amplitude[i] ?? NaN]);
  return [...points, [to, amplitudeAt(line, to)]];
}
