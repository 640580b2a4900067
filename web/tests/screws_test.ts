// SPDX-License-Identifier: BSD-3-Clause
// Screw axes against the motion of the body: data/turned.modes.json is `trivet modes` of data/turned.toml.
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {displacement, ofMode, valuesAt} from '../src/motion.ts';
import type {Modes, Scene, Vector} from '../src/results.ts';
import {screwOf, screwWords} from '../src/screws.ts';
import modesData from './data/turned.modes.json';
import sceneData from './data/turned.scene.json';

const scene = sceneData as unknown as Scene, modes = modesData as unknown as Modes;

test('every point of a screw axis moves along it, by the pitch times the rotation', () => {
  let tried = 0;
  modes.modes.forEach((mode, index) => {
    const motion = ofMode(modes, index, scene.bodies)!;
    scene.bodies.forEach((body, b) => {
      const screw = screwOf(modes, mode.number, body), rigid = motion.bodies.get(body.name)!;
      if (!screw?.point) return;
      const {direction, point, pitch} = screw, size = Math.max(...valuesAt(rigid, 0).map(Math.abs), 1e-12);
      for (const along of [-0.7, 0, 0.4]) {
        const arm = point.map((v, k) => v + along * direction[k]! - body.pole[k]!) as unknown as Vector;
        displacement(rigid, arm, 0).forEach((v, k) =>
          assert.ok(Math.abs(v - pitch! * mode.screws![b]!.rotation * direction[k]!) < 1e-8 * size * (1 + Math.hypot(...point)), `mode ${mode.number}, ${body.name}`));
      }
      tried++;
    });
  });
  assert.ok(tried > 6);
});
test('words of an axis have its distance and its pitch', () => {
  const body = {...scene.bodies[0]!, centre_of_mass: [0, 0, 1] as Vector};
  assert.equal(screwWords({direction: [1, 0, 0], point: [0, 0, 0.75], pitch: -0.012}, body), 'screw axis 250 mm from the centre of mass, pitch −12 mm/rad');
  assert.equal(screwWords({direction: [1, 0, 0], point: [0, 0, 1], pitch: 1e-18}, body), 'screw axis 0 m from the centre of mass, pitch 0 m/rad');
  assert.equal(screwWords({direction: [1, 0, 0], point: null, pitch: null}, body), 'translation without rotation');
});
