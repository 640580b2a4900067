// SPDX-License-Identifier: BSD-3-Clause
/// Parts of a curve above its limit, with ends on it.
export function partsAbove(x: readonly number[], y: readonly (number | null)[], limit: number): [number, number][][] {
  const parts: [number, number][][] = [];
  let part: [number, number][] = [];
  const end = () => {
    if (part.length > 1) parts.push(part);
    part = [];
  };
  for (let i = 0; i < x.length; i++) {
    const value = y[i] ?? null, before = i > 0 ? y[i - 1] ?? null : null;
    const crossing = () => x[i - 1]! + (x[i]! - x[i - 1]!) * (limit - before!) / (value! - before!);
    if (value !== null && value > limit) {
      if (!part.length && before !== null) part.push([crossing(), limit]);
      part.push([x[i]!, value]);
    } else {
      if (part.length && value !== null) part.push([crossing(), limit]);
      end();
    }
  }
  end();
  return parts;
}
