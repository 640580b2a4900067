// SPDX-License-Identifier: BSD-3-Clause
// The same facts as tests/unit/report/amplitude_range_test.cpp.
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {amplitudeRange, isWide, type Point} from '../src/report/amplitude_range.ts';

const rule = {range: 100, dips: 0.1, negligible: 1e-3, round_off: 1e-8, below: 10};
const curve = (height: (x: number) => number): Point[] => Array.from({length: 1001}, (_, i) => [i / 1000, height(i / 1000)]);
const wide = (...heights: ((x: number) => number)[]) => isWide(amplitudeRange(heights.map(curve), rule), rule);

test('amplitudes that fall by two decades over nine tenths of the band need a logarithmic axis', () => {
  assert.equal(wide(x => 10 ** (-2.1 / 0.9 * x)), true);
  assert.equal(wide(x => 10 ** (-1.9 / 0.9 * x)), false);
  const {largest, least, bottom} = amplitudeRange([curve(x => 10 ** (-4 * x))], rule);
  assert.ok(largest === 1 && Math.abs(least / 10 ** -3.6 - 1) < 0.02 && Math.abs(bottom / 1e-4 - 1) < 1e-9);
});
test('neither a dip nor a curve that nowhere matters decides, but a small one does', () => {
  assert.equal(wide(x => (Math.abs(x - 0.5) < 0.04 ? 1e-6 : 1)), false);
  assert.equal(wide(() => 1, () => 5e-4), false);
  assert.equal(wide(() => 1, () => 5e-3), true);
  assert.equal(amplitudeRange([curve(x => (x === 0 ? 0 : 1))], rule).bottom, 1);
});
test('an axis ends at most a decade below the least amplitude that matters', () => {
  const {bottom} = amplitudeRange([curve(x => (Math.abs(x - 0.5) < 0.04 ? 1e-6 : 1))], rule);
  assert.equal(bottom, 0.1);
});
test('nothing, or only zeros, has no range', () => {
  assert.equal(wide(), false);
  assert.equal(wide(() => 0), false);
});
