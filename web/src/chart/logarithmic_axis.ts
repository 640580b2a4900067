// SPDX-License-Identifier: BSD-3-Clause
// Range and ticks of logarithmic axes. uPlot's own ticks never end if the axis begins just below a power of ten that is less
// than 0.1: it rounds 0.0107 to 0.011, goes on in steps of 0.011, and rounds these to 0.

/// Values of curves below this share of their largest are not drawn: they are zeros and round-off. Nothing else, such as a limit, draws the
/// axis out further than that above them.
export const LOWEST = 1e-5;

/// Ends of an axis with room at both: finite, positive, at most ten decades and the room, whatever the values are.
/// @param curves  they decide the decades  @param others  are seen too, if they are near enough
export function logarithmicRange(curves: Iterable<number | null>, others: Iterable<number | null> = []): [number, number] {
  const [least, largest] = positiveEnds(curves);
  const near = largest > 0 ? [...others].filter(v => v !== null && v >= LOWEST * largest && v <= largest / LOWEST) : others;
  const [lowest, highest] = positiveEnds(near), top = Math.max(largest, highest);
  if (!(top > 0)) return [LOWEST, 1];
  return [Math.max(Math.min(least, lowest), LOWEST * (largest || highest)) / 1.3, top * 2];
}
/// The least and the largest of the positive finite values; ∞ and 0 without any.
function positiveEnds(values: Iterable<number | null>): [number, number] {
  let [least, largest] = [Infinity, 0];
  for (const v of values) if (v !== null && v > 0 && Number.isFinite(v)) [least, largest] = [Math.min(least, v), Math.max(largest, v)];
  return [least, largest];
}

/// Places of lines and of those with a number, from small to large: powers of ten, with 2 and 5 on a short axis; at equal steps if it is
/// shorter still. Empty if the ends are not finite, positive and in this order.
export function logarithmicTicks(from: number, to: number): {lines: number[]; labelled: number[]} {
  if (!(from > 0 && to > from && Number.isFinite(to))) return {lines: [], labelled: []};
  const decades = ofDigits(from, to, [1]), short = to / from < 300 || decades.length < 2 ? ofDigits(from, to, [1, 2, 5]) : decades;
  const labelled = short.length < 3 ? equalSteps(from, to) : short;
  const lines = to / from > 1e8 || short.length < 3 ? labelled : ofDigits(from, to, [1, 2, 3, 4, 5, 6, 7, 8, 9]);
  return {lines, labelled};
}
function ofDigits(from: number, to: number, digits: readonly number[]): number[] {
  const [first, last] = [Math.floor(Math.log10(from)), Math.ceil(Math.log10(to))], step = 1 + Math.floor((last - first) / 12), found: number[] = [];
  for (let decade = first; decade <= last; decade += step)
    for (const digit of digits) found.push(Number(`${digit}e${decade}`));
  return found.filter(v => v >= from * (1 - 1e-9) && v <= to * (1 + 1e-9));
}
function equalSteps(from: number, to: number): number[] {
  const rough = (to - from) / 5, decade = 10 ** Math.floor(Math.log10(rough)), step = decade * ([1, 2, 5].find(s => s * decade >= rough) ?? 10);
  const first = Math.ceil(from / step - 1e-9), count = Math.floor((to - first * step) / step + 1e-9);
  return Array.from({length: count + 1}, (_, k) => Number(((first + k) * step).toPrecision(12)));
}
