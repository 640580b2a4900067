// SPDX-License-Identifier: BSD-3-Clause
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {scenesOf, type StoredScenes} from '../src/report/stored_scenes.ts';

test('bodies of stored scenes get their surfaces, which scenes share, in their order', () => {
  const surfaces = [0, 1, 2].map(n => ({vertices: [n, n, n], triangles: []}));
  const scene = (mass: number, ...places: number[][]) => ({title: 'machine', bodies: places.map(solids => ({name: 'body', mass, solids}))});
  const stored = {surfaces, scenes: [scene(1, [2, 0], []), scene(3, [2, 1], [0])]} as unknown as StoredScenes;
  const found = scenesOf(stored).map(({title, bodies}) => ({title, bodies: bodies.map(({mass, solids}) => ({mass, solids}))}));
  const [a, b, c] = surfaces;
  assert.deepEqual(found, [
    {title: 'machine', bodies: [{mass: 1, solids: [c, a]}, {mass: 1, solids: []}]},
    {title: 'machine', bodies: [{mass: 3, solids: [c, b]}, {mass: 3, solids: [a]}]}]);
});
