// SPDX-License-Identifier: BSD-3-Clause
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {completionsAt} from '../src/completions.ts';
import {indexOf, valueOf} from '../src/numbers_of_text.ts';
import {quantity, written} from '../src/quantities.ts';
import {Schema} from '../src/schema.ts';
import {settingsOf, sliders} from '../src/slider_list.ts';

const TEXT = `# a machine
trivet = 1
title = "set = 5 # not a comment"
[bodies."my set"]   # heavy
mass = "4.2 t"
center_of_mass = ["-60 mm", 10e-3, 0]
points.top = [1, 2, 3]
[element_types.mount]
damping = {loss_factor = 0.12}
matrix = [[1, 2, 3], [4, 5, 6], [7, 8, 9]]
[tables.elements]
rows = [
  {name = "front left", type = "mount", at = [1.4, 0.55, 0]},  # a row
]
[parameters.height]
path = 'elements."front left".at.y'
from = "100 mm"
to = "900 mm"
`;
const index = indexOf(TEXT), design = {text: TEXT, settings: new Map<string, string>()};

test('numbers have the paths that --set accepts', () => {
  assert.deepEqual([...index.numbers.keys()], ['bodies."my set".mass', 'bodies."my set".center_of_mass.x', 'bodies."my set".center_of_mass.y',
    'bodies."my set".center_of_mass.z', 'bodies."my set".points.top.x', 'bodies."my set".points.top.y', 'bodies."my set".points.top.z',
    'element_types.mount.damping.loss_factor', 'elements."front left".at.x', 'elements."front left".at.y', 'elements."front left".at.z']);
});
test('the place of a number in the text is exact', () => {
  for (const entry of index.numbers.values()) assert.equal(TEXT.slice(entry.from, entry.to), entry.raw);
  assert.equal(index.numbers.get('bodies."my set".mass')!.raw, '"4.2 t"');
});
test('a setting replaces the number of the text', () => {
  assert.equal(valueOf('bodies."my set".mass', {text: TEXT, settings: new Map([['bodies."my set".mass', '"5 t"']])}, index), '"5 t"');
});
test('a text that is not complete is read as far as it goes', () => {
  for (let end = 0; end < TEXT.length; end++) indexOf(TEXT.slice(0, end));
  assert.equal(indexOf('a = [1, 2\nb = "x').entries[0]!.path[0], 'a');
});
test('numbers with units', () => {
  assert.deepEqual(quantity('"1.6 kN/mm"'), {value: 1.6, unit: 'kN/mm'});
  assert.deepEqual(quantity('-1_000.5e-3'), {value: -1.0005, unit: ''});
  assert.equal(quantity('"front left"'), null);
  assert.equal(written(0.1 + 0.2, 'mm'), '"0.3 mm"');
});
test('a parameter is a slider in the unit of its range', () => {
  const [slider] = sliders(design, index, []);
  assert.equal(slider!.name, 'height');
  assert.equal(slider!.value, 550);
  assert.deepEqual(settingsOf(slider!, 600), {'elements."front left".at.y': '"600 mm"'});
});

const schema = new Schema({properties: {bodies: {additionalProperties: {$ref: '#/$defs/body'}}},
                           $defs: {body: {anyOf: [{properties: {mass: {description: 'kg'}, kind: {enum: ['solid', 'plate']}, inertia: {properties: {xx: {}}}}}]}}});
test('completion knows the table, a dotted key and an inline table', () => {
  const names = (text: string) => completionsAt(text, text.length, schema)?.options.map(o => o.name) ?? [];
  assert.deepEqual(names('[bodies.a]\nma'), ['inertia', 'kind', 'mass']);
  assert.deepEqual(names('[bodies.a]\ninertia.'), ['xx']);
  assert.deepEqual(names('[bodies.a]\ninertia = {'), ['xx']);
  assert.deepEqual(names('[bodies.a]\nkind = "'), ['solid', 'plate']);
  assert.deepEqual(names('# ma'), []);
  assert.equal(schema.description(['bodies', 'a', 'mass']), 'kg');
});
test('in a case a slider moves the number of the case, if the case changes it', () => {
  const text = `[element_types.mount]
scale = 1
[bodies.b]
mass = "4 t"
[cases."in the cold"]
element_types.mount.scale = 1.4
[cases."in the cold".bodies.b]
center_of_mass = [0, 0, "3 mm"]
`;
  const of = (name: string) => sliders({text, settings: new Map()}, indexOf(text), ['element_types.mount.scale', 'bodies.b.mass'], name).map(s => [s.paths[0]!.path, s.value]);
  assert.deepEqual(of(''), [['element_types.mount.scale', 1], ['bodies.b.mass', 4]]);
  assert.deepEqual(of('in the cold'), [['cases."in the cold".element_types.mount.scale', 1.4], ['bodies.b.mass', 4]]);
  assert.deepEqual(of('in the heat'), of(''));
  assert.equal(indexOf(text).numbers.get('cases."in the cold".bodies.b.center_of_mass.z')!.raw, '"3 mm"');
});
