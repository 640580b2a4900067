// SPDX-License-Identifier: BSD-3-Clause
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {armsOf} from '../src/machine/arms.ts';
import type {SceneBody, SceneElement, Vector} from '../src/results.ts';

const turned = [[0, 1, 0], [-1, 0, 0], [0, 0, 1]] as const;
const body = (more: Partial<SceneBody>): SceneBody => ({name: 'body', node: false, mass: 1, drawn_as: '', pole: [9, 9, 9], centre_of_mass: [1, 0, 0], axes: turned, dofs: [],
                                                         box: {centre: [1, 0, 0], axes: turned, size: [4, 2, 2]}, solids: [], ...more});
const mount = (at: Vector, of = 'body'): SceneElement => ({name: '', type: '', kind: '', from: {ground: true, at}, to: {body: of, at}, axes: turned, size: [1, 1]});
const arms = (one: SceneBody, places: Vector[]) => armsOf(one, {elements: [...places.map(at => mount(at)), mount([50, 0, 0], 'other')], points: [], forces: [], size: 1})
  .map(ends => ends.map(end => end.toArray().map(v => Math.round(v * 1e9) / 1e9 + 0)));

test('a place outside the turned box of a body is joined with the nearest place of the box', () => {
  assert.deepEqual(arms(body({}), [[2, 2, 1], [1.5, -1.9, 0]]), []);  // on a corner, and inside
  assert.deepEqual(arms(body({}), [[1, 5, 0], [4, 0, 0.5], [1, 5, 0]]), [[[1, 2, 0], [1, 5, 0]], [[2, 0, 0.5], [4, 0, 0.5]]]);
});
test('a body of solids is joined from the box around them, one without size from its centre of mass, a node never', () => {
  const solids = [{vertices: [0, 0, 0, 1, 1, 1], triangles: []}];
  assert.deepEqual(arms(body({solids}), [[0.5, 0.5, 3]]), [[[0.5, 0.5, 1], [0.5, 0.5, 3]]]);
  assert.deepEqual(arms(body({box: null}), [[1, 1, 0]]), [[[1, 0, 0], [1, 1, 0]]]);
  assert.deepEqual(arms(body({node: true}), [[4, 4, 4]]), []);
});
