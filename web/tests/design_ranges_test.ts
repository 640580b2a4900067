// SPDX-License-Identifier: BSD-3-Clause
import assert from 'node:assert/strict';
import test from 'node:test';
import {countWords, isInside, isWhole, movedEnd, rangeWords, valueAt, valueWords, type DrawnDesign, type Range} from '../src/report/design_ranges.ts';

const mass = {name: 'casting', unit: 'kg', from: 90, to: 110, end: 1, logarithmic: false};
const margin = {name: 'm.x', unit: '', from: 0.5, to: 50, end: 0.94, logarithmic: true};

test('places on an axis are values of its scale', () => {
  assert.equal(valueAt(mass, 0.25), 95);
  assert.equal(valueWords(mass, 0.25), '95 kg');
  assert.ok(Math.abs(valueAt(margin, 0.47) - 5) < 1e-12);  // the middle of two decades
  assert.equal(valueAt(margin, 0.94), 50);
  assert.equal(valueWords(margin, 1), '∞');
  assert.equal(rangeWords(mass, [0, 0.5]), 'casting: 90 kg … 100 kg');
});

const designs: DrawnDesign[] = [
  {shares: [0.1, 0.5], met: true, further: false}, {shares: [0.2, 0.1], met: false, further: false},
  {shares: [0.9, 0.6], met: true, further: false}, {shares: [0.15], met: false, further: false},
  {shares: [0.2, 0.2], met: false, further: true}];

test('ranges of several axes combine, and a design without a value is outside', () => {
  const inside = (...ranges: [number, Range][]) => designs.map(one => isInside(one, new Map(ranges)));
  assert.deepEqual(inside(), [true, true, true, true, true]);
  assert.deepEqual(inside([0, [0, 0.5]]), [true, true, false, true, true]);
  assert.deepEqual(inside([0, [0, 0.5]], [1, [0.2, 1]]), [true, false, false, false, true]);
});

test('the count separates the first designs, a sample, from later ones', () => {
  assert.equal(countWords(designs, new Map()), '4 designs, 2 meet all requirements; 1 later design, 0 meet them');
  assert.equal(countWords(designs, new Map([[0, [0, 0.5]]])), '3 of 4 designs selected, 1 meets all requirements; 1 of 1 later design, 0 meet them');
  assert.equal(countWords(designs.slice(0, 4), new Map([[1, [0.55, 1]]])), '1 of 4 designs selected, 1 meets all requirements');
});

test('an end of a range does not pass the other one, nor the axis', () => {
  assert.deepEqual(movedEnd([0.2, 0.6], 0, 0.8), [0.6, 0.6]);
  assert.deepEqual(movedEnd([0.2, 0.6], 0, -0.1), [0, 0.6]);
  assert.deepEqual(movedEnd([0.2, 0.6], 1, 1.3), [0.2, 1]);
  assert.ok(isWhole(movedEnd([0, 0.6], 1, 2)));
});
