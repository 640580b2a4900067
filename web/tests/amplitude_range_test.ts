// SPDX-License-Identifier: BSD-3-Clause
// The same facts as tests/unit/report/amplitude_range_test.cpp.
import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import {test} from 'node:test';
import {amplitudeRange, isWide, type AmplitudeRule, type Point} from '../src/report/amplitude_range.ts';
import {inRange} from '../src/report/drawn_line.ts';

/// The constants of the program, which reports have in their data.
const header = readFileSync('../src/trivet/report/drawing/amplitude_range.h', 'utf8');
const constantsOf = (text: string) => Object.fromEntries([...text.matchAll(/ double (\w+) = ([\d.e-]+);/g)].map(m => [m[1]!, Number(m[2])]));
const rule = constantsOf(header.match(/struct AmplitudeRule {(.*?)};/s)![1]!) as unknown as AmplitudeRule;
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
test('a gap is no part of the band', () => {
  const interrupted = (x: number) => (x < 0.1 ? 1 : x <= 0.95 ? NaN : 1e-3);
  assert.equal(wide(interrupted), true);
  const points = curve(interrupted), line = {omega: points.map(p => p[0]), amplitude: points.map(p => (p[1] >= 0 ? p[1] : null))};
  const isWideFrom = (from: number) => isWide(amplitudeRange([inRange(line, from, 1)], rule), rule);
  assert.ok(isWideFrom(0) && isWideFrom(0.05) && !isWideFrom(0.5));
});
test('a zero is an amplitude, which ends no axis', () => {
  const points = inRange({omega: [0, 1, 2, 3], amplitude: [0, 4, null, 2]}, 0, 2.5);
  assert.deepEqual(points, [[0, 0], [1, 4], [2, NaN], [2.5, NaN]]);
  assert.deepEqual(amplitudeRange([points], rule), {largest: 4, least: 4, bottom: 4});
});
