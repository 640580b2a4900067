// SPDX-License-Identifier: BSD-3-Clause
// Curves of one design of a map from its poles and residues, which the program stored: see study/map/curve_fractions.h.

/// Of all stored designs, in arrays.
export interface Fractions {
  pairs: number;   // of poles, of each design
  powers: readonly number[];
  delays: readonly number[];
  real: boolean;   // else each number has a real and an imaginary part
  results: readonly unknown[];
  denominators: ArrayLike<number>;  // p, q of each pair
  numerators: ArrayLike<number>;    // a, b of each pair, then one for each power; for each delay and result
}

type Numbers = typeof Uint8Array | typeof Float32Array | typeof Float64Array;
/// Numbers from base64.
export function unpacked<T extends Numbers>(text: string, Kind: T): InstanceType<T> {
  return new Kind(Uint8Array.from(atob(text), sign => sign.charCodeAt(0)).buffer) as InstanceType<T>;
}

/// Values [re, im, re, im, …] of all curves of a design at ω: Σ (a + b s)/(p + q s + s²) over the pairs of poles, plus
/// powers of s, times e^{−s d} for each delay d; s = iω.
export function designAt({pairs, powers, delays, real, results, denominators, numerators}: Fractions, design: number, w: number): Float64Array {
  const terms = 2 * pairs + powers.length, parts = real ? 1 : 2, basis = new Float64Array(2 * terms);
  const part = (list: ArrayLike<number>, k: number, imaginary: 0 | 1) => (imaginary && real ? 0 : list[k * parts + imaginary]!);
  for (let k = 0, at = design * 2 * pairs; k < pairs; k++, at += 2) {
    const re = part(denominators, at, 0) - w * w - w * part(denominators, at + 1, 1);
    const im = part(denominators, at, 1) + w * part(denominators, at + 1, 0), size = re * re + im * im;
    const [x, y] = [re / size, -im / size];
    basis.set([x, y, -w * y, w * x], 4 * k);
  }
  powers.forEach((m, j) => {
    const turn = ((m % 4) + 4) % 4, size = w ** m;  // s^m = i^m ω^m
    basis.set([[size, 0], [0, size], [-size, 0], [0, -size]][turn]!, 2 * (2 * pairs + j));
  });
  const result = new Float64Array(2 * results.length);
  let at = design * delays.length * results.length * terms;
  for (const delay of delays) {
    const cos = Math.cos(w * delay), sin = -Math.sin(w * delay);
    for (let c = 0; c < results.length; c++) {
      let x = 0, y = 0;
      for (let t = 0; t < terms; t++, at++) {
        const a = part(numerators, at, 0), b = part(numerators, at, 1);
        if (a === 0 && b === 0) continue;
        x += a * basis[2 * t]! - b * basis[2 * t + 1]!;
        y += a * basis[2 * t + 1]! + b * basis[2 * t]!;
      }
      result[2 * c]! += cos * x - sin * y;
      result[2 * c + 1]! += cos * y + sin * x;
    }
  }
  return result;
}

/// Frequencies of the resonances of a design: √|p| of each pair of poles, and where p + q s + s² is least.
export function resonancesOf({pairs, real, denominators}: Fractions, design: number, [from, to]: readonly [number, number]): number[] {
  const parts = real ? 1 : 2, found: number[] = [];
  for (let k = 0, at = design * 2 * pairs * parts; k < pairs; k++, at += 2 * parts) {
    const p = denominators[at]!, q = denominators[at + parts]!;
    found.push(Math.sqrt(Math.abs(p)), Math.sqrt(Math.max(0, p - q * q / 2)));
  }
  return found.filter(w => w > from && w < to);
}

/// The maximum of a curve between two frequencies around its highest drawn point, by golden sections.
export function maximumBetween(size: (w: number) => number, from: number, to: number): number {
  const share = (Math.sqrt(5) - 1) / 2;
  let [a, b] = [from, to], c = b - share * (b - a), d = a + share * (b - a), [fc, fd] = [size(c), size(d)];
  while (b - a > 1e-9 * b) {
    if (fc > fd) [b, d, fd] = [d, c, fc], c = b - share * (b - a), fc = size(c);
    else [a, c, fc] = [c, d, fd], d = a + share * (b - a), fd = size(d);
  }
  return (a + b) / 2;
}

/// How far a drawn maximum rises above the higher of the minima beside it, over its height.
export function riseOf(sizes: readonly number[], at: number): number {
  const lowest = (step: number) => {
    let least = sizes[at]!;
    for (let i = at + step; i >= 0 && i < sizes.length && sizes[i]! <= sizes[at]!; i += step) if (sizes[i]! < least) least = sizes[i]!;
    return least;
  };
  return 1 - Math.max(lowest(-1), lowest(1)) / sizes[at]!;
}
