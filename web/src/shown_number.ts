// SPDX-License-Identifier: BSD-3-Clause
// How page and report write a number, and which multiple of its unit they choose.

/// A finite number with significant digits, without zeros at its end, or with them. "-" is its sign.
export function digitsOf(value: number, digits: number, keepZeros = false): string {
  if (value === 0) return '0';
  const size = Math.abs(value);
  const text = size >= 1e6 || size < 1e-4 ? value.toExponential(digits - 1) : value.toPrecision(digits);
  if (keepZeros || !/[.e]/.test(text)) return text;
  return text.includes('e') ? text.replace(/\.?0*e\+?/, 'e') : text.replace(/\.?0+$/, '');
}

/// Size in the unit, and name: [1e-3, "mm"].
export type Multiple = readonly [number, string];
/// The largest multiple that is not larger than the value, or else the smallest one, as the program chooses it (unit_prefix).
/// @param multiples  from the smallest to the largest
export const suitedMultiple = (value: number, multiples: readonly Multiple[]): Multiple =>
  multiples.findLast(([size]) => value >= size * (1 - 1e-9)) ?? multiples[0]!;
