// SPDX-License-Identifier: BSD-3-Clause
// Units of numbers in the project file. They only place the thumb of a slider whose range has another unit than its number:
// the program converts every number that is computed with.

const BASE: Record<string, number> = {m: 1, s: 1, N: 1, Hz: 2 * Math.PI, rpm: 2 * Math.PI / 60, rad: 1, deg: Math.PI / 180, Pa: 1, W: 1, J: 1,
                                      g: 1e-3, t: 1e3, '%': 0.01, kg: 1, min: 60, Nm: 1, bar: 1e5};
const PREFIX: Record<string, number> = {k: 1e3, M: 1e6, G: 1e9, c: 1e-2, m: 1e-3, µ: 1e-6, u: 1e-6, n: 1e-9};

/// Factor to SI of a unit as "kN/mm" or "N s/m"; null: not known here.
function unitFactor(unit: string): number | null {
  let factor = 1, sign = 1;
  for (const token of unit.replaceAll('·', ' ').split(/(\/)|\s+/).filter(Boolean)) {
    if (token === '/') {
      sign = -1;
      continue;
    }
    const match = token.match(/^([^\d^]+)\^?(\d)?$/), name = match?.[1] ?? '', power = Number(match?.[2] ?? 1);
    const one = BASE[name] ?? (PREFIX[name[0] ?? ''] ?? NaN) * (BASE[name.slice(1)] ?? NaN);
    if (!Number.isFinite(one)) return null;
    factor *= one ** (sign * power);
  }
  return factor;
}
/// A number in another unit; null if either is not known here, or one has a unit and the other none that fits.
export function inUnit(value: number, from: string, to: string): number | null {
  const a = unitFactor(from), b = unitFactor(to);
  return from === to ? value : a === null || b === null ? null : value * a / b;
}
