// SPDX-License-Identifier: BSD-3-Clause
// Motions against the program's own: data/turned.*.json are `trivet scene` and `trivet shapes` of data/turned.toml, two
// turned bodies. The program states the motion of points and ends of elements; the page computes them from the bodies.
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {displacement, ofShape} from '../src/motion.ts';
import type {Scene, Shapes, Vector} from '../src/results.ts';
import sceneData from './data/turned.scene.json';
import shapesData from './data/turned.shapes.json';

const scene = sceneData as unknown as Scene, shapes = shapesData as unknown as Shapes, motion = ofShape(shapes, scene.bodies)!;
const TOLERANCE = 1e-9;  // of 4 mm

function compare(body: string, at: Vector, place: string) {
  const {pole} = scene.bodies.find(b => b.name === body)!, arm = at.map((v, k) => v - pole[k]!) as unknown as Vector;
  const stated = shapes.shapes[0]!.places.find(p => p.name === place)!.motion;
  for (const phase of [0, 0.7, Math.PI / 2, 3]) {
    const computed = displacement(motion.bodies.get(body)!, arm, phase);
    computed.forEach((v, k) => {
      const expected = stated[k]![0] * Math.cos(phase) - stated[k]![1] * Math.sin(phase);
      assert.ok(Math.abs(v - expected) < TOLERANCE, `${place} ${k}: ${v} and ${expected}`);
    });
  }
}
test('points move as the program states', () => {
  for (const {name, body, at} of scene.points) compare(body, at, `${body}.${name}`);
});
test('ends of elements move with their bodies', () => {
  for (const {name, from, to} of scene.elements) {
    if (from.body) compare(from.body, from.at, `${name}.foot`);
    compare(to.body!, to.at, `${name}.head`);
  }
});
