// SPDX-License-Identifier: BSD-3-Clause
import type {CurveModel, Piece} from './results.ts';

/// Evaluates the wanted results of a model: Σ w v/(ω − x) / Σ w/(ω − x) over the nodes x, times e^{−iωd} for each delay d, summed.
export class ModelValues {
  private readonly parts: readonly Part[];

  constructor(private readonly model: CurveModel, results: number, private readonly wanted: readonly number[] = [...Array(results).keys()]) {
    this.parts = model.pieces.map(piece => part(piece, model.delays.length, results, wanted));
  }
  /// Values [re, im, re, im, …] at ω [rad/s]. NaN where the results are not defined. The next call overwrites them.
  at(omega: number): Float64Array {
    const {out} = this, found = this.parts.find(p => omega <= p.to) ?? this.parts.at(-1);
    out.fill(0);
    if (!found || this.model.undefined_at.includes(omega)) return out.fill(NaN);
    const {nodes, weights, products, inverse, values} = found, n = nodes.length, hit = nodes.indexOf(omega);
    let re = 0, im = 0;
    if (hit < 0)
      for (let j = 0; j < n; j++) {
        const d = inverse[j] = 1 / (omega - nodes[j]!);
        re += weights[2 * j]! * d;
        im += weights[2 * j + 1]! * d;
      }
    else [re, im] = [1, 0];
    const size = re * re + im * im, count = this.wanted.length;
    this.model.delays.forEach((delay, d) => {
      const cos = Math.cos(omega * delay), sin = -Math.sin(omega * delay);
      const a = (cos * re + sin * im) / size, b = (sin * re - cos * im) / size;  // e^{−iωd} over the denominator
      for (let c = 0; c < count; c++) {
        const first = 2 * n * (d * count + c);
        let x = 0, y = 0;
        if (hit < 0)
          for (let j = 0, k = first; j < n; j++, k += 2) {
            x += products[k]! * inverse[j]!;
            y += products[k + 1]! * inverse[j]!;
          }
        else [x, y] = [values[first + 2 * hit]!, values[first + 2 * hit + 1]!];
        out[2 * c]! += a * x - b * y;
        out[2 * c + 1]! += a * y + b * x;
      }
    });
    return out;
  }
  private readonly out = new Float64Array(2 * this.wanted.length);
}

/// Angle of a value [rad], −π to π. That of a real value does not change with the sign of its round-off.
export function angleOf(re: number, im: number): number {
  return Math.abs(im) <= 1e-9 * Math.abs(re) ? (re < 0 ? Math.PI : 0) : Math.atan2(im, re);
}

/// A piece as arrays of numbers: v and w v of each delay and wanted result over the nodes.
interface Part {
  to: number;
  nodes: Float64Array;
  weights: Float64Array;
  values: Float64Array;
  products: Float64Array;
  inverse: Float64Array;  // 1/(ω − x)
}
function part({band, nodes, weights, values}: Piece, delays: number, results: number, wanted: readonly number[]): Part {
  const n = nodes.length, flat = new Float64Array(2 * n * delays * wanted.length).fill(NaN), products = new Float64Array(flat.length);
  for (let d = 0; d < delays; d++) wanted.forEach((result, c) => flat.set(values[d * results + result]!, 2 * n * (d * wanted.length + c)));
  for (let k = 0; k < flat.length; k += 2) {
    const j = k % (2 * n), [p, q, r, s] = [weights[j]!, weights[j + 1]!, flat[k]!, flat[k + 1]!];
    products[k] = p * r - q * s;
    products[k + 1] = p * s + q * r;
  }
  return {to: band[1], nodes: Float64Array.from(nodes), weights: Float64Array.from(weights), values: flat, products, inverse: new Float64Array(n)};
}
