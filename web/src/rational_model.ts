// SPDX-License-Identifier: BSD-3-Clause
import type {CurveModel, Piece} from './results.ts';

/// Values [re, im, re, im, …] of the wanted ones of the results of a model at ω [rad/s]: Σ w v/(ω − x) / Σ w/(ω − x) over the nodes x, times
/// e^{−iωd} for each delay d. NaN where the results are not defined.
export function modelAt(model: CurveModel, omega: number, results: number, wanted: readonly number[] = [...Array(results).keys()]): Float64Array {
  const out = new Float64Array(2 * wanted.length), piece = pieceAt(model.pieces, omega);
  if (!piece || model.undefined_at.includes(omega)) return out.fill(NaN);
  const {nodes, weights, values} = piece, n = nodes.length, hit = nodes.indexOf(omega);
  const shares = new Float64Array(2 * n);
  let re = 0, im = 0;
  for (let j = 0; j < n; j++) {
    const distance = omega - nodes[j]!;
    re += shares[2 * j] = hit < 0 ? weights[2 * j]! / distance : hit === j ? 1 : 0;
    im += shares[2 * j + 1] = hit < 0 ? weights[2 * j + 1]! / distance : 0;
  }
  const size = re * re + im * im;
  model.delays.forEach((delay, d) => {
    const cos = Math.cos(omega * delay), sin = -Math.sin(omega * delay);
    const a = (cos * re + sin * im) / size, b = (sin * re - cos * im) / size;  // e^{−iωd} over the denominator
    for (let c = 0; c < wanted.length; c++) {
      const v = values[d * results + wanted[c]!]!;
      let x = 0, y = 0;
      for (let j = 0; j < n; j++) {
        const p = shares[2 * j]!, q = shares[2 * j + 1]!, r = v[2 * j]!, s = v[2 * j + 1]!;
        x += p * r - q * s;
        y += p * s + q * r;
      }
      out[2 * c]! += a * x - b * y;
      out[2 * c + 1]! += a * y + b * x;
    }
  });
  return out;
}

const pieceAt = (pieces: readonly Piece[], omega: number) => pieces.find(p => omega <= p.band[1]) ?? pieces.at(-1);
