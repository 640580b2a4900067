// SPDX-License-Identifier: BSD-3-Clause
import assert from 'node:assert/strict';
import {test} from 'node:test';
import type {Steady, SteadyMotion} from '../src/results.ts';
import {isInBand, largestAt, motionsAt, steadyChoices} from '../src/steady_motions.ts';

const point = (angular_frequency: number, largest: number, stable = true) => ({angular_frequency, stable, results: [{largest, smallest: -largest}]});
const motion = (stable: boolean | null, periods = 1): SteadyMotion => ({curve: 0, periods, stable, places: []});
const steady: Steady = {over: 'frequency', results: [{name: 'm.z', unit: 'm'}], folds: [], points: [point(10, 1), point(20, 3), point(18, 5, false), point(30, 1)],
                        at: [{angular_frequency: 18.000000000001, motions: [motion(true), motion(false), motion(null, 2)]}]};

test('one begins at the largest stable motion', () => {
  assert.equal(largestAt(steady), 20);
  assert.deepEqual(steadyChoices(steady, {shown: {kind: 'rest'}, frequencyUnit: 'rad/s'}), [{omega: 20, motion: 0, words: 'steady motion at 20 rad/s'}]);
});
test('at the shown frequency all motions are offered, with their stability', () => {
  assert.deepEqual(steadyChoices(steady, {shown: {kind: 'frequency', omega: 18}, frequencyUnit: 'rad/s'}).map(c => c.words),
                   ['steady motion 1 at 18 rad/s, stable', 'steady motion 2 at 18 rad/s, unstable', 'steady motion 3 at 18 rad/s, of uncertain stability, 2 periods']);
  assert.equal(motionsAt(steady, 19), null);  // not computed yet
});
test('outside the band, or over the load, the program reports no harmonics', () => {
  assert.deepEqual([isInBand(steady, 10), isInBand(steady, 30), isInBand(steady, 9.9), isInBand({...steady, over: 'load_factor'}, 20)], [true, true, false, false]);
  assert.equal(steadyChoices(steady, {shown: {kind: 'frequency', omega: 50}, frequencyUnit: 'rad/s'})[0]!.omega, 20);
  assert.deepEqual(steadyChoices({...steady, over: 'load_factor'}, {shown: {kind: 'rest'}, frequencyUnit: 'Hz'}), []);
  assert.deepEqual(steadyChoices(null, {shown: {kind: 'rest'}, frequencyUnit: 'Hz'}), []);
});
