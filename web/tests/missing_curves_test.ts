// SPDX-License-Identifier: BSD-3-Clause
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {missingCurves} from '../src/missing_curves.ts';
import {indexOf} from '../src/numbers_of_text.ts';
import type {App} from '../src/part.ts';

const NO_DRIVE = 'error: response: no harmonic excitation in the model; this analysis needs one; add [excitations.NAME]';
const missing = (text: string, words = NO_DRIVE) => missingCurves({index: indexOf(text), asker: {missing: () => words}} as unknown as App);
const excited = (...types: string[]) => types.map((type, i) => `[excitations.e${i}]\ntype = "${type}"\n`).join('');

test('a machine with orders gets no advice to add a harmonic excitation, and hears where it is judged', () => {
  assert.equal(missing(excited('orders')), 'Curves over frequency belong to a harmonic excitation; this machine has orders.');
  const limits = '[operation]\nlimits = {"m.z" = "4.5 mm/s rms"}\n';
  assert.equal(missing(limits + excited('random', 'time', 'orders')),
    'Curves over frequency belong to a harmonic excitation; this machine has orders, random excitations and forces over time. What is required of it is judged in the table Requirements.');
});
test('without any excitation, or with another reason, the words of the program stay', () => {
  assert.equal(missing(''), NO_DRIVE);
  assert.equal(missing(excited('orders'), 'Computing …'), 'Computing …');
});
