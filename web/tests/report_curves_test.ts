// SPDX-License-Identifier: BSD-3-Clause
// The curves of reports: designs of a map from poles and residues, and the frequencies at which curves are drawn.
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {angleOf} from '../src/rational_model.ts';
import {adaptiveSamples, type SampledModel} from '../src/report/adaptive_sampling.ts';
import {designAt, maximumBetween, resonancesOf, riseOf, unpacked, type Fractions} from '../src/report/pole_fractions.ts';
import {digitsOf, suitedMultiple} from '../src/shown_number.ts';

type Value = [number, number];
const times = ([a, b]: Value, [c, d]: Value): Value => [a * c - b * d, a * d + b * c];
const plus = (a: Value, b: Value): Value => [a[0] + b[0], a[1] + b[1]];
const over = (a: Value, [c, d]: Value): Value => times(a, [c / (c * c + d * d), -d / (c * c + d * d)]);
const exp = (angle: number): Value => [Math.cos(angle), Math.sin(angle)];
const near = (got: ArrayLike<number>, [re, im]: Value, at = 0) =>
  assert.ok(Math.hypot(got[at]! - re, got[at + 1]! - im) <= 1e-13 * Math.hypot(re, im), `${got[at]}, ${got[at + 1]} are not ${re}, ${im}`);

/// Two designs of two pairs of poles, s⁻² and s¹, two results, a delay; complex numbers one after the other.
const parts = (count: number, first: number) => Array.from({length: 2 * count}, (_, k) => Math.sin(first + 1.7 * k) * 10 ** (k % 3));
const complex: Fractions = {pairs: 2, powers: [-2, 1], delays: [0, 0.02], real: false, results: ['a', 'b'],
                            denominators: parts(8, 1), numerators: parts(2 * 2 * 2 * 6, 2)};
const at = (list: ArrayLike<number>, k: number): Value => [list[2 * k]!, list[2 * k + 1]!];

/// Σ e^{−s d} ((a + b s)/(p + q s + s²) + … + c s^m), written out in complex numbers.
function expected(f: Fractions, design: number, w: number, result: number): Value {
  const s: Value = [0, w], terms = 2 * f.pairs + f.powers.length;
  return f.delays.reduce<Value>((sum, delay, d) => {
    const first = ((design * f.delays.length + d) * f.results.length + result) * terms;
    let value: Value = [0, 0];
    for (let k = 0; k < f.pairs; k++) {
      const p = at(f.denominators, 2 * (design * f.pairs + k)), q = at(f.denominators, 2 * (design * f.pairs + k) + 1);
      const a = at(f.numerators, first + 2 * k), b = at(f.numerators, first + 2 * k + 1);
      value = plus(value, over(plus(a, times(b, s)), plus(p, plus(times(q, s), times(s, s)))));
    }
    f.powers.forEach((m, j) => {
      const power = m < 0 ? over([1, 0], times(s, s)) : s;  // −2 and 1
      value = plus(value, times(at(f.numerators, first + 2 * f.pairs + j), power));
    });
    return plus(sum, times(value, exp(-w * delay)));
  }, [0, 0]);
}
test('a design is the sum of its fractions and powers, with delays', () => {
  for (const design of [0, 1])
    for (const w of [0.3, 4, 77]) {
      const found = designAt(complex, design, w);
      for (const result of [0, 1]) near(found, expected(complex, design, w, result), 2 * result);
    }
});
test('real numbers are complex ones without imaginary parts', () => {
  const real = (list: ArrayLike<number>) => Array.from(list, (v, k) => (k % 2 ? 0 : v)), half = (list: ArrayLike<number>) => Array.from(list).filter((_, k) => k % 2 === 0);
  const whole = {...complex, denominators: real(complex.denominators), numerators: real(complex.numerators)};
  const short = {...complex, real: true, denominators: half(complex.denominators), numerators: half(complex.numerators)};
  assert.deepEqual(designAt(short, 1, 5), designAt(whole, 1, 5));
});
test('numbers come from base64, and the resonance of a pair is where its fraction is largest', () => {
  const [w0, damping] = [30, 0.1], numbers = Float64Array.of(w0 * w0, 2 * damping * w0);
  const text = btoa(String.fromCharCode(...new Uint8Array(numbers.buffer)));
  const one: Fractions = {pairs: 1, powers: [], delays: [0], real: true, results: ['a'], denominators: unpacked(text, Float64Array), numerators: [1, 0]};
  const found = maximumBetween(w => Math.hypot(...designAt(one, 0, w) as unknown as Value), 20, 40), exact = w0 * Math.sqrt(1 - 2 * damping * damping);
  assert.ok(Math.abs(found - exact) < 1e-6 * exact && resonancesOf(one, 0, [0, 100]).some(w => Math.abs(w - exact) < 1e-9));
});
test('a maximum rises above the higher of the minima beside it', () => {
  assert.equal(riseOf([5, 1, 4, 2, 8], 2), 0.5);
  assert.equal(riseOf([1, 2, 2, 2], 1), 0);
});

test('straight lines between the samples follow a sharp peak, and its phase', () => {
  const [k, m, c] = [900, 1, 0.02], value = (w: number) => Float64Array.from(over([1, 0], [k - m * w * w, c * w]));
  const model: SampledModel = {band: [0, 60], undefined_at: [], pieces: [{band: [0, 60], nodes: [30]}], results: [{unit: 'm', extrema: []}]};
  const samples = adaptiveSamples(model, value, [false], [false]), height = Math.hypot(...value(30) as unknown as Value);
  assert.ok(samples[0]!.w === 0 && samples.at(-1)!.w === 60 && samples.length < 3000);
  let worst = 0;
  samples.slice(1).forEach((b, i) => {
    const a = samples[i]!, size = ({v}: {v: Float64Array}) => Math.hypot(v[0]!, v[1]!);
    for (const part of [0.1, 0.4, 0.8]) {
      const exact = Math.hypot(...value(a.w + part * (b.w - a.w)) as unknown as Value);
      worst = Math.max(worst, Math.abs((1 - part) * size(a) + part * size(b) - exact) / Math.max(exact, 1e-3 * height));
    }
  });
  assert.ok(worst < 2e-3, `${worst}`);
  assert.ok(adaptiveSamples(model, value, [true], [false]).length < 80);  // of one that vanishes nothing is drawn exactly
});
test('the angle of a real value does not depend on its round-off', () => {
  for (const im of [1e-12, -1e-12, 0]) assert.deepEqual([angleOf(-1, im), angleOf(1, im)], [Math.PI, 0]);
  assert.equal(angleOf(0, -2), -Math.PI / 2);
});

test('numbers have significant digits, with zeros at the end only in readings', () => {
  assert.deepEqual([1.5, 0.00012, 2e-7, 3e7, -20, 0].map(v => digitsOf(v, 4)), ['1.5', '0.00012', '2e-7', '3e7', '-20', '0']);
  assert.deepEqual([1.5, 2e-7].map(v => digitsOf(v, 4, true)), ['1.500', '2.000e-7']);
});
test('a value has the largest multiple that is not larger', () => {
  const multiples = [[1e-6, 'µm'], [1e-3, 'mm'], [1, 'm']] as const;
  assert.deepEqual([2e-9, 9.99e-4, 1e-3 * (1 - 1e-12), 5000].map(v => suitedMultiple(v, multiples)[1]), ['µm', 'µm', 'mm', 'm']);
});
