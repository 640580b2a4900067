// SPDX-License-Identifier: BSD-3-Clause
// The rule for logarithmic amplitudes of report/drawing/amplitude_range.h, with the constants of the program, for what the reader chose to see: a
// part of the band, some of the curves. The program decides for whole charts.

export interface AmplitudeRule {
  range: number;
  dips: number;
  negligible: number;
  round_off: number;
  below: number;
}
export type Point = readonly [at: number, amplitude: number];
export interface AmplitudeRange {
  largest: number;
  least: number;  // that matters
  bottom: number;  // of a logarithmic axis
}

/// What curves span. Their abscissas are ascending; an amplitude that is not finite is a gap.
export function amplitudeRange(curves: readonly (readonly Point[])[], rule: AmplitudeRule): AmplitudeRange {
  const highest = curves.map(curve => curve.reduce((most, p) => Number.isFinite(p[1]) ? Math.max(most, p[1]) : most, 0));
  const largest = highest.reduce((most, one) => Math.max(most, one), 0), roundOff = rule.round_off * largest;
  let [least, smallest] = [largest, largest];
  for (const [i, curve] of curves.entries()) {
    if (!(highest[i]! > rule.negligible * largest)) continue;
    least = Math.min(least, exceptDips(curve, rule.dips, roundOff));
    for (const [, amplitude] of curve) if (Number.isFinite(amplitude) && amplitude > roundOff) smallest = Math.min(smallest, amplitude);
  }
  return {largest, least, bottom: Math.max(smallest, least / rule.below)};
}
export const isWide = ({largest, least}: AmplitudeRange, rule: AmplitudeRule) => largest > 0 && largest > rule.range * least;

/// The amplitude that a curve exceeds except in its dips, which have a share of its band.
function exceptDips(curve: readonly Point[], dips: number, from: number): number {
  const pieces = curve.slice(1).flatMap(([at, amplitude], i): [number, number][] => {
    const [before, other] = curve[i]!, height = Math.max(amplitude, other);
    return Number.isFinite(amplitude) && Number.isFinite(other) && height >= from ? [[height, at - before]] : [];
  });
  let left = dips * pieces.reduce((sum, piece) => sum + piece[1], 0);
  for (const [height, width] of pieces.sort((a, b) => a[0] - b[0])) if ((left -= width) <= 0) return height;
  return Infinity;
}
