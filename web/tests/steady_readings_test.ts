// SPDX-License-Identifier: BSD-3-Clause
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {stabilityWords, steadyCurves, steadyReadings} from '../src/chart/steady_readings.ts';
import type {Steady} from '../src/results.ts';

const point = (angular_frequency: number, largest: number, stable: boolean | null = true) => ({angular_frequency, stable, results: [{largest, smallest: -largest / 2}, {largest: 7, smallest: 0}]});
// up on the stable part to 4, back on the unstable one to 2, and up again
const bent: Steady = {over: 'frequency', results: [{name: 'm.z', unit: 'm'}, {name: 'm.f', unit: 'N'}], folds: [],
                      points: [point(1, 4), point(3, 8), point(4, 12), point(3.2, 16, false), point(2, 20, false), point(2.9, 24), point(5, 28)],
                      further: [{points: [point(2, 40, null), point(4, 44, null)], folds: []}]};
const [curve, ...others] = steadyCurves(bent, 'm', ['m.z', 'm.f'], 10, v => 2 * v);

test('the steady motions at a frequency are the nearest computed ones of every branch, with their stability', () => {
  assert.deepEqual([curve!.name, others.length], ['m.z', 0]);
  const read = (x: number) => steadyReadings(curve!, x).map(p => [p.x, p.y, stabilityWords(p)]);
  assert.deepEqual(read(30), [[20, 60, 'of uncertain stability'], [29, 36, 'stable'], [32, 24, 'unstable'], [30, 12, 'stable']]);
  assert.deepEqual(read(45), [[50, 42, 'stable']]);
  assert.deepEqual(read(51), []);
});
test('curves over load, of another quantity or not drawn have no readings', () => {
  assert.deepEqual(steadyCurves({...bent, over: 'load'}, 'm', ['m.z'], 1, v => v), []);
  assert.deepEqual(steadyCurves(bent, 'm/s', ['m.z'], 1, v => v), []);
  assert.deepEqual(steadyCurves(bent, 'm', [], 1, v => v), []);
});
