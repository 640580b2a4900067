// SPDX-License-Identifier: BSD-3-Clause
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {LABEL_HEIGHT, labelPlaces, overlap, type Box, type Labelled} from '../src/chart/label_places.ts';

const area = {width: 390, height: 220}, nowhere = () => false;
const line = (top: number, size = 120): Labelled => ({left: 0, right: 390, top, size});
const boxes = (all: readonly Labelled[], rows: number, isOnCurve = nowhere as (box: Box) => boolean) => labelPlaces(all, area, isOnCurve, rows).map(p => p && p.box);

test('six labels of lines at one height are next to it and none covers another', () => {
  const found = boxes([100, 100, 100, 101, 101.5, 100].map(top => line(top)), 2);
  found.forEach((a, i) => found.forEach((b, j) => assert.ok(a && b && (i === j || !overlap(a, b)))));
  for (const box of found) assert.ok(box![0] >= 0 && box![2] <= area.width && box![1] >= 100 - 2.2 * LABEL_HEIGHT && box![3] <= 101.5 + 2.2 * LABEL_HEIGHT);
});
test('a label without room next to its line has none, or is in a further row', () => {
  const many = Array.from({length: 7}, () => line(100));
  assert.equal(boxes(many, 1).filter(box => box === null).length, 1);
  assert.ok(!boxes(many, 2).includes(null));
});
test('a label is beside the curves if there is room next to its line, and stays at its place while that is free', () => {
  const rightAbove = ([, top, right]: Box) => right > 300 && top < 100;
  const [place] = labelPlaces([line(100)], area, rightAbove, 1);
  assert.ok(place!.box[1] > 100);
  assert.deepEqual(labelPlaces([{...line(100), before: place!.number}], area, nowhere, 1), [place]);
});
test('a label of a short line is beside it, and inside the plot', () => {
  assert.deepEqual(boxes([{left: 100, right: 110, top: 50, size: 80}], 1), [[114, 35, 194, 50]]);
  assert.deepEqual(boxes([{left: 370, right: 380, top: 50, size: 80}], 1), [[286, 35, 366, 50]]);
});
