// SPDX-License-Identifier: BSD-3-Clause
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {logarithmicRange, logarithmicTicks} from '../src/chart/logarithmic_axis.ts';

test('the range of any values is finite, positive and of few decades', () => {
  const odd = [[], [null], [0, 0], [1e-300, 5], [Infinity, 3], [NaN, 2], [-1, 4], [7], [1e-12], [0, 1e-9, 1]];
  for (const curves of odd)
    for (const others of [...odd, [1e12], [1e-12]]) {
      const [from, to] = logarithmicRange(curves, others), words = `${curves} | ${others}: ${from} … ${to}`;
      assert.ok(Number.isFinite(from) && Number.isFinite(to) && from > 0 && to > from, words);
      assert.ok(Math.log10(to / from) <= 10 + Math.log10(2.6) + 1e-9, words);
    }
});
test('the range has room for the curves and for limits near them', () => {
  assert.deepEqual(logarithmicRange([1.3, 50], [200]), [1, 400]);
  const [from, to] = logarithmicRange([1e-9, 1], [1e9]);
  assert.ok(Math.abs(from / (1e-5 / 1.3) - 1) < 1e-12);
  assert.equal(to, 2);  // a limit a milliard times as large is not drawn
});
test('ticks of every range are in it, ascending and few, and at least two have a number', () => {
  for (let exponent = -12; exponent <= 6; exponent++)
    for (const digit of [1, 1.7, 4.99, 5, 9.4, 9.5, 9.7, 9.96, 9.9999])
      for (const ratio of [1.001, 1.3, 2.2, 7, 90, 301, 5e3, 3e6, 2.6e10]) {
        const from = digit * 10 ** exponent, to = from * ratio, {lines, labelled} = logarithmicTicks(from, to), words = `${from} … ${to}: ${labelled}`;
        assert.ok(labelled.length >= 2 && labelled.length <= 14 && lines.length <= 90, words);
        assert.ok(labelled.every(v => lines.includes(v)), words);
        for (const all of [lines, labelled])
          assert.ok(all.every((v, i) => v >= from * (1 - 1e-6) && v <= to * (1 + 1e-6) && (i === 0 || v > all[i - 1]!)), words);
      }
  assert.deepEqual(logarithmicTicks(0.0097, 3).labelled, [0.01, 0.1, 1]);
  assert.deepEqual(logarithmicTicks(1, 10).labelled, [1, 2, 5, 10]);
});
test('an axis without an extent has no ticks', () => {
  for (const [from, to] of [[0, 1], [-1, 1], [1, 1], [1, Infinity], [NaN, 1]] as const) assert.deepEqual(logarithmicTicks(from, to).lines, []);
});
