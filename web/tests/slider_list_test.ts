// SPDX-License-Identifier: BSD-3-Clause
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {indexOf} from '../src/numbers_of_text.ts';
import type {SceneBody, SceneElement} from '../src/results.ts';
import {sliders} from '../src/slider_list.ts';

const element = (name: string, key: string | null) => ({name, stiffness_key: key}) as SceneElement;
const body = (name: string, node = false) => ({name, node, mass: node ? 0 : 1}) as SceneBody;
const found = (text: string, elements: SceneElement[], bodies: SceneBody[]) =>
  sliders({text, settings: new Map()}, indexOf(text), [], '', {elements, bodies}).map(s => `${s.name}: ${s.paths[0]!.path} = ${s.value} ${s.unit}`.trim());

test('without parameters the types of mounts and the masses are sliders', () => {
  const text = `[bodies."my set"]
mass = "4.2 t"
inertia = {about = "center_of_mass", xx = 1, yy = 1, zz = 1}
[element_types.mount]
scale = 2
[element_types.dashpot]
type = "damper"
[tables.elements]
rows = [
  {name = "left", type = "mount"},
  {name = "oil", type = "dashpot"},
]
`;
  assert.deepEqual(found(text, [element('left', 'scale'), element('oil', null)], [body('my set'), body('knee', true)]),
                   ['stiffness of mount: element_types.mount.scale = 2', 'mass of my set: bodies."my set".mass = 4.2 t']);
});
test('a preloaded spring is scaled with its preload kept, and an element without stiffness is no slider', () => {
  const elements = [element('damper', null), ...['a', 'b', 'c', 'd', 'e'].map(name => element(name, 'stiffness_factor.all'))];
  assert.deepEqual(found('', elements, []), ['a', 'b', 'c', 'd'].map(n => `stiffness of ${n}: elements.${n}.stiffness_factor.all = 1`));
});
test('a type whose elements are preloaded is scaled with their preload kept', () => {
  const text = '[element_types.coil]\ntype = "coil_spring"\n[elements."front left"]\ntype = "coil"\n';
  assert.deepEqual(found(text, [element('front left', 'stiffness_factor.all')], []), ['stiffness of coil: element_types.coil.stiffness_factor.all = 1']);
});
test('the mass of a body with an inertia about its pole, or of solids with a density, is a factor', () => {
  const text = '[bodies.a]\nmass = 5\ninertia = {about = "pole", xx = 1, yy = 1, zz = 1}\n[bodies.b]\nsolids = []\n';
  assert.deepEqual(found(text, [], [body('a'), body('b')]), ['mass of a, factor: bodies.a.mass_about_center = 1', 'mass of b, factor: bodies.b.mass_about_center = 1']);
});
test('before the machine is known no number is offered that might have no room', () => {
  const text = '[bodies.a]\nmass = 5\n';
  assert.deepEqual(sliders({text, settings: new Map()}, indexOf(text), []), []);
});
test('a number in a unit that the slider does not have stays as it is written', () => {
  const text = '[bodies.a]\nmass = 640\n[bodies.b]\nsolids = []\n[parameters.load]\npath = "bodies.a.mass"\nfrom = "500 kg"\nto = "1 t"\n';
  const set = (path: string, value: string, pins: string[], own = text) => sliders({text: own, settings: new Map([[path, value]])}, indexOf(own), pins, '', {elements: [], bodies: [body('b')]}).at(-1)!;
  assert.equal(set('bodies.a.mass', '"700 lb"', []).written, '700 lb');
  assert.equal(set('bodies.a.mass', '"700 lb"', ['bodies.a.mass']).written, '700 lb');
  assert.equal(set('bodies.a.mass', '"700 kg"', []).written, undefined);
  assert.equal(set('bodies.b.mass_about_center', '"640 lb"', [], '[bodies.b]\nsolids = []\n').written, '640 lb');
  assert.equal(set('bodies.b.mass_about_center', '"640 kg"', [], '[bodies.b]\nsolids = []\n').written, '640 kg');
});
