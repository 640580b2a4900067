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
test('a label covers no peak and no value of a peak, also if it was there before', () => {
  const kept: Box[] = [[250, 80, 300, 101]], near = labelPlaces([line(100)], area, nowhere, 1)[0]!;
  const above = labelPlaces([{...line(100), size: 390}], area, nowhere, 1, kept)[0]!;
  assert.ok(above.box[1] >= 100 && !overlap(above.box, kept[0]!));
  assert.ok(overlap(near.box, kept[0]!) && !overlap(labelPlaces([{...line(100), before: near.number}], area, nowhere, 1, kept)[0]!.box, kept[0]!));
  assert.deepEqual(labelPlaces([line(100)], area, nowhere, 1, [[0, 0, 390, 220]]), [null]);
});
test('a label of a short line is over its middle if a peak is beside it', () => {
  assert.deepEqual(labelPlaces([{left: 300, right: 310, top: 50, size: 170}], area, nowhere, 1, [[150, 30, 200, 70]])[0]!.box, [220, 35, 390, 50]);
});
test('a label of a short line is anywhere over it before it has no room', () => {
  const kept: Box[] = [[100, 0, 195, 220], [300, 0, 390, 220]];
  const [place] = labelPlaces([{left: 260, right: 270, top: 50, size: 90}], area, nowhere, 1, kept);
  assert.ok(place && place.box[0] >= 195 && place.box[2] <= 300 && place.box[3] === 50);
});
test('a label goes to a farther row before it covers a curve', () => {
  const [place] = labelPlaces([line(100)], area, ([, top, , bottom]: Box) => bottom > 85 && top < 119, 2);
  assert.ok(place!.box[3] <= 85);
});
test('a label of a short line is beside it, and inside the plot', () => {
  assert.deepEqual(boxes([{left: 100, right: 110, top: 50, size: 80}], 1), [[114, 35, 194, 50]]);
  assert.deepEqual(boxes([{left: 370, right: 380, top: 50, size: 80}], 1), [[286, 35, 366, 50]]);
});
