// SPDX-License-Identifier: BSD-3-Clause
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {ModelValues} from '../src/rational_model.ts';
import {drawnFrequencies, sampledCurves} from '../src/sampled_curves.ts';
import type {Curves, CurveModel} from '../src/results.ts';

type Value = readonly [number, number];
const ROUND_OFF = 1e-11;  // of interpolation with five nodes

const modelAt = (of: CurveModel, omega: number, results: number) => new ModelValues(of, results).at(omega);

/// Receptance of a mass on a spring with a damper, 1/(k − ω²m + iωc): a rational function of degree 2.
function receptance(w: number, [m, c, k] = [2, 3, 800]): Value {
  const re = k - w * w * m, im = w * c, size = re * re + im * im;
  return [re / size, -im / size];
}
/// Barycentric weights w_j that make Σ w v/(ω−x) / Σ w/(ω−x) equal to p/q for q of degree below the number of nodes:
/// w_j = q(x_j) / Π (x_j − x_i).
function model(nodes: number[], delays: number[] = [0]): CurveModel {
  const weights = nodes.flatMap((x, j) => {
    const product = nodes.reduce((p, y, i) => (i === j ? p : p * (x - y)), 1);
    return [(800 - 2 * x * x) / product, 3 * x / product];
  });
  return {pieces: [{band: [0, 60], nodes, weights, values: delays.map(() => nodes.flatMap(x => [...receptance(x)]))}], delays, undefined_at: [7]};
}
const near = (got: ArrayLike<number>, want: Value, tolerance: number) =>
  want.forEach((v, i) => assert.ok(Math.abs(got[i]! - v) <= tolerance * Math.hypot(...want), `${got[i]} is not ${v}`));

test('a model equals the receptance that it interpolates, between and on its nodes', () => {
  const nodes = [1, 12, 23, 34, 50];
  for (const w of [0.5, 1, 5, 19.99, 20, 23, 47, 50, 60]) near(modelAt(model(nodes), w, 1), receptance(w), ROUND_OFF);
});
test('a delay turns the phase by −ω d', () => {
  const w = 21, d = 0.013, [re, im] = receptance(w), cos = Math.cos(w * d), sin = -Math.sin(w * d);
  near(modelAt(model([1, 12, 23, 34, 50], [d]), w, 1), [re * cos - im * sin, re * sin + im * cos], ROUND_OFF);
});
test('nothing is drawn at a frequency without a result', () => assert.ok(Number.isNaN(modelAt(model([1, 12, 23]), 7, 1)[0])));

function curves(): Curves {
  return {band: [0, 60], results: [{name: 'mass.z', unit: 'm'}], models: [{...model([1, 12, 23, 34, 50]), undefined_at: []}], natural: [20], limits: [],
          peaks: [{result: 'mass.z', angular_frequency: 19.94, amplitude: 0.0166, phase: -1.5}]};
}
test('a peak is drawn at its exact place and height', () => {
  const all = curves(), omega = drawnFrequencies(all, 50, false), sampled = sampledCurves(all, 0, omega);
  assert.equal(sampled.amplitude[0]![omega.indexOf(19.94)], 0.0166);
  assert.ok(omega.every((w, i) => i === 0 || w > omega[i - 1]!));
});
test('straight lines between the drawn frequencies follow a sharp peak', () => {
  const all = curves(), omega = drawnFrequencies(all, 420, false), sampled = sampledCurves(all, 0, omega).amplitude[0]!;
  for (let i = 1; i < omega.length; i++) {
    const middle = (omega[i]! + omega[i - 1]!) / 2, line = (sampled[i]! + sampled[i - 1]!) / 2, curve = Math.hypot(...receptance(middle));
    if (omega[i] !== 19.94 && omega[i - 1] !== 19.94) assert.ok(Math.abs(line - curve) < 0.01 * 0.0166, `${middle}: ${line} and ${curve}`);
  }
});
test('only wanted results are evaluated, and one that a draft does not have is nowhere defined', () => {
  const one = model([1, 12, 23, 34, 50]), {values} = one.pieces[0]!;
  const three: CurveModel = {...one, pieces: [{...one.pieces[0]!, values: [[], values[0]!.map(v => 2 * v), values[0]!]}]};
  for (const w of [12, 19]) {
    const [a, b, c, d] = new ModelValues(three, 3, [2, 0]).at(w);
    near([a!, b!], receptance(w), ROUND_OFF);
    assert.ok(Number.isNaN(c) && Number.isNaN(d));
  }
});
test('a draft has no points closer than a pixel, but all natural frequencies', () => {
  for (const logarithmic of [false, true]) {
    const draft = {...curves(), peaks: [], draft: true, natural: [20, 20.001]}, omega = drawnFrequencies(draft, 400, logarithmic);
    assert.ok(omega.includes(20) && omega.includes(20.001));
    const place = (w: number) => (logarithmic ? Math.log(w / 0.06) / Math.log(1000) : w / 60), close = omega.filter((w, i) => i > 1 && place(w) - place(omega[i - 1]!) < 1 / 2000);
    assert.ok(close.every(w => Math.abs(w - 20) < 0.05 || w === 60), String(close));
    assert.ok(omega.length < 450 && omega.at(-1) === 60 && omega[0] === (logarithmic ? 0.06 : 0));
  }
});
