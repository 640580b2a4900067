// SPDX-License-Identifier: BSD-3-Clause
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {largestSteady, measuredOverlays, partsByStability, readingAt, steadyOverlays} from '../src/chart/overlays.ts';

const point = (angular_frequency: number, largest: number, stable = true) => ({angular_frequency, stable, results: [{largest, smallest: -largest}]});

test('parts of a branch meet where its stability changes', () => {
  const parts = partsByStability([point(1, 1), point(2, 2), point(1.5, 3, false), point(1.6, 4)], p => p.angular_frequency);
  assert.deepEqual(parts, [{stable: true, points: [1, 2]}, {stable: false, points: [2, 1.5]}, {stable: true, points: [1.5, 1.6]}]);
});
test('steady motions have half their peak-to-peak value, and folds jump to where they land', () => {
  const steady = {over: 'frequency', results: [{name: 'm.z', unit: 'm'}, {name: 'm.x', unit: 'm'}], points: [point(1, 2), point(3, 4)].map(p => ({...p, results: [p.results[0]!, p.results[0]!]})),
                  folds: [{point: {...point(3, 4), results: [{largest: 5, smallest: 1}, {largest: 0, smallest: 0}]}, lands: {...point(3, 9), results: [{largest: 9, smallest: -9}, {largest: 0, smallest: 0}]}}]};
  const overlays = steadyOverlays(steady, 'm', ['m.z'], 2, v => 10 * v);
  assert.deepEqual(overlays.map(o => [o.kind, o.points]), [['stable', [[2, 20], [6, 40]]], ['jump', [[6, 20], [6, 90]]]]);
  assert.deepEqual(steadyOverlays(steady, 'm/s', ['m.z'], 1, v => v), []);
  assert.deepEqual(steadyOverlays({...steady, over: 'load'}, 'm', ['m.z'], 1, v => v), []);
});
test('measured amplitudes belong to the drawn result of their unit', () => {
  const measured = [{name: 'impact', excitation: 'hammer', channels: [{result: 'm.z', unit: 'm/s²', angular_frequency: [1, 2], measured: [[3, 4], [0, 2]] as [number, number][]}]}];
  assert.deepEqual(measuredOverlays(measured, 'measured', 'm/s²', ['m.x', 'm.z'], 10, v => 2 * v).map(o => [o.stroke, o.points]), [[1, [[10, 10], [20, 4]]]]);
  assert.deepEqual(measuredOverlays(measured, 'measured', 'm', ['m.z'], 1, v => v), []);
});
test('the largest steady motion of a result is that of its stable parts', () => {
  const of = (kind: 'stable' | 'unstable', points: [number, number | null][]) => ({name: 'm.z', stroke: 1, kind, points});
  assert.deepEqual(largestSteady([of('stable', [[1, 2], [2, null], [3, 5]]), of('unstable', [[4, 9]]), of('stable', [[5, 4]])]), [{x: 3, y: 5, stroke: 1}]);
});
test('a compared curve is read between its points, and a measured one at the nearest of them', () => {
  const of = (kind: 'compared' | 'measured') => ({name: 'm.z', stroke: 0, kind, points: [[1, 10], [2, 20], [4, null], [5, 7]] as [number, number | null][]});
  assert.deepEqual([1, 1.25, 2, 3, 5].map(x => readingAt(of('compared'), x)?.y ?? null), [10, 12.5, 20, null, 7]);
  assert.deepEqual([0.9, 5.1].map(x => readingAt(of('compared'), x)), [null, null]);
  assert.deepEqual([1.2, 1.8].map(x => readingAt(of('measured'), x)), [{x: 1, y: 10}, {x: 2, y: 20}]);
});
