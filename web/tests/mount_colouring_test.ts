// SPDX-License-Identifier: BSD-3-Clause
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {BEYOND, colourOf, STEPS} from '../src/machine/colour_scale.ts';
import {missingValues, mountValues, type MountResults} from '../src/mount_colouring.ts';
import type {Check, Modes, Verdict} from '../src/results.ts';

const mount = (ofCase: string, element: string, deflection: number, utilisation: number | null = null) =>
  ({case: ofCase, element, compression: 1000, across: 0, deflection, utilisation});
const check: Check = {mounts: [mount('', 'left', -2e-3, 0.4), mount('', 'right', -1e-3), mount('cold', 'left', -1e-3)]};
const verdict = {met: false, least_margin: null, cases: [{case: '', met: false, decides: true, governing: 0, requirements: [],
                                      elements: [{element: 'left', governing: 0, share: 1.2}, {element: 'right', governing: 1, share: null}]}]} as Verdict;
const modes = {bodies: [], elements: ['left', 'right'], modes: [{number: 2, strain_energy_share: [0.9, 0.1]}]} as unknown as Modes;
const all: MountResults = {verdict, check, modes};
const lightness = (hex: number) => 0.2126 * (hex >> 16) + 0.7152 * (hex >> 8 & 255) + 0.0722 * (hex & 255);

test('shares of a limit are those of the program; nothing left of it is infinite', () => {
  const found = mountValues('limit', all, '', null)!;
  assert.deepEqual([...found.values], [['left', 1.2], ['right', Infinity]]);
  assert.deepEqual([found.words(1.2), found.words(Infinity), found.top, found.limited], ['120 %', '∞', 1, true]);
});
test('mounts at rest are those of the case, or of the base model if the case does not change them', () => {
  assert.deepEqual([...mountValues('deflection', all, 'cold', null)!.values], [['left', -1e-3]]);
  assert.deepEqual([...mountValues('deflection', all, 'other', null)!.values.keys()], ['left', 'right']);
  assert.equal(mountValues('deflection', all, '', null)!.words(-2e-3), '−2 mm');
  assert.deepEqual([...mountValues('utilisation', all, '', null)!.values], [['left', 0.4]]);  // the other has no range
});
test('energy is that of the shown mode, and without one there is a sentence', () => {
  assert.deepEqual([...mountValues('energy', all, '', 2)!.values], [['left', 0.9], ['right', 0.1]]);
  assert.equal(mountValues('energy', all, '', null), null);
  for (const kind of ['limit', 'utilisation', 'deflection', 'compression', 'energy'] as const) {
    assert.equal(mountValues(kind, {verdict: null, check: null, modes: null}, '', 1), null);
    assert.ok(missingValues(kind).endsWith('.'));
  }
});
test('mounts that do not deflect at rest are not coloured', () => assert.equal(mountValues('deflection', {...all, check: {mounts: [mount('', 'left', 0)]}}, '', null), null));
test('a share of a limit that is not binding is said to be so', () => {
  const there = {...verdict, cases: [{...verdict.cases[0]!, decides: false}]};
  assert.equal(mountValues('limit', {...all, verdict: there}, '', null)!.title, 'share of its limit, not binding in this case');
});
test('lightness rises along the scale, and beyond the limit is a colour of its own', () => {
  for (let i = 1; i < STEPS.length; i++) assert.ok(lightness(STEPS[i]!) > lightness(STEPS[i - 1]!) + 20);
  const values = mountValues('limit', all, '', null)!;
  assert.equal(colourOf(0, values).getHex(), STEPS[0]);
  assert.equal(colourOf(1, values).getHex(), STEPS.at(-1));
  assert.equal(colourOf(1.001, values).getHex(), BEYOND);
  assert.equal(colourOf(Infinity, values).getHex(), BEYOND);
  assert.equal(colourOf(-2e-3, mountValues('deflection', all, '', null)!).getHex(), STEPS.at(-1));  // not limited: its top
});
