// SPDX-License-Identifier: BSD-3-Clause
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {NEAR, ThinnedLine} from '../src/chart/thinned_line.ts';

type Point = [number, number];
const ROUND_OFF = 1e-9;

/// The corners of each drawn line.
function drawn(...lines: Point[][]): Point[][] {
  const found: Point[][] = [], line = new ThinnedLine({moveTo: (x, y) => found.push([[x, y]]), lineTo: (x, y) => found.at(-1)!.push([x, y])});
  for (const points of lines) {
    for (const [x, y] of points) line.add(x, y);
    line.end();
  }
  return found;
}
/// How far, along y, a point is from straight lines between corners.
function distance([x, y]: Point, corners: Point[]): number {
  const at = Math.max(corners.findIndex(c => c[0] >= x), 1), [[x0, y0], [x1, y1]] = [corners[at - 1]!, corners[at]!];
  return Math.abs(y0 + (y1 - y0) * (x - x0) / (x1 - x0) - y);
}
const resonance = Array.from({length: 500}, (_, i): Point => [i, 300 - 15 / Math.hypot(1 - (i / 120) ** 2, 0.1 * i / 120)]);

test('a line misses no point by more than is seen and has far fewer corners', () => {
  const [corners] = drawn(resonance);
  for (const point of resonance) assert.ok(distance(point, corners!) <= NEAR + ROUND_OFF, `${point}`);
  assert.ok(corners!.length < 0.35 * resonance.length, `${corners!.length}`);
  assert.deepEqual([corners![0], corners!.at(-1)], [resonance[0], resonance.at(-1)]);
});
test('its corners are points of the curve, and a single peak is one of them', () => {
  const peak: Point[] = [[0, 0], [1, 0], [2, 0], [2.001, 90], [2.002, 0], [3, 0], [4, 0]];
  assert.deepEqual(drawn(peak), [[[0, 0], [2, 0], [2.001, 90], [2.002, 0], [4, 0]]]);
});
test('what ends begins again at the next point, also if it is one point alone', () => {
  assert.deepEqual(drawn([[0, 0], [1, 1], [2, 2]], [[3, 5]], [[4, -1], [5, -1]]), [[[0, 0], [2, 2]], [[3, 5]], [[4, -1], [5, -1]]]);
});
