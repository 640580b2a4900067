// SPDX-License-Identifier: BSD-3-Clause
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {newMachine, QUESTIONS, wrongNumber, type Numbers} from '../src/new_machine.ts';
import {indexOf} from '../src/numbers_of_text.ts';
import type {SceneBody} from '../src/results.ts';
import {sliders} from '../src/slider_list.ts';

const numbers = Object.fromEntries(Object.entries(QUESTIONS).map(([name, q]) => [name, q.value])) as Numbers;

test('the mass of the form is a number of the file, and so a slider', () => {
  const text = newMachine('A "fan"', numbers), index = indexOf(text);
  assert.equal(index.numbers.get('bodies.machine.mass')!.raw, '"400 kg"');
  const body = {name: 'machine', node: false, mass: 400} as SceneBody;
  assert.deepEqual(sliders({text, settings: new Map()}, index, [], '', {elements: [], bodies: [body]}).map(s => [s.name, s.value, s.unit]),
                   [['stiffness of mount', 1, ''], ['mass of machine', 400, 'kg']]);
});
test('mounts stand in pairs, symmetric about the middle', () => {
  const {numbers: found} = indexOf(newMachine('', {...numbers, pairs: 3}));
  const x = ['1 left', '2 left', '3 left', '3 right'].map(name => found.get(`elements."${name}".at.x`)!.raw);
  assert.deepEqual(x, ['"480 mm"', '"0 mm"', '"-480 mm"', '"-480 mm"']);
  assert.equal(found.get('elements."2 right".at.y')!.raw, '"-240 mm"');
});
test('a wrong number is named', () => {
  assert.equal(wrongNumber(numbers), '');
  assert.match(wrongNumber({...numbers, mass: NaN}), /^Mass/);
  assert.match(wrongNumber({...numbers, pairs: 1.5}), /^Pairs/);
});
test('a mount of the catalogue takes the place of a stiffness', () => {
  const {byPath} = indexOf(newMachine('', {...numbers, vertical: NaN}, 'disc 75x25 40 ShA'));
  assert.equal(byPath.get('element_types\0mount\0type')!.raw, '"catalogue:disc 75x25 40 ShA"');
  assert.ok(!byPath.has('element_types\0mount\0translation') && byPath.has('requirements\0mount_load'));
  assert.equal(wrongNumber({...numbers, vertical: NaN}, 'disc 75x25 40 ShA'), '');
  assert.match(wrongNumber({...numbers, vertical: NaN}), /^Vertical/);
});
