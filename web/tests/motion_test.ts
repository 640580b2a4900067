// SPDX-License-Identifier: BSD-3-Clause
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {corners, displacement, inProjectFrame, largestDisplacement, ofMode, ofRoot, ofShape, ofSteady, harmonic, sizeWords, type Amplitudes, type Motion, type RigidMotion} from '../src/motion.ts';
import type {Complex, SceneBody, Vector} from '../src/results.ts';

const close = (a: readonly number[], b: readonly number[]) =>
  b.forEach((v, i) => assert.ok(Math.abs(a[i]! - v) < 1e-12, `${a} is not ${b}`));
const amplitudes = (...values: number[]): Amplitudes => values.map((v): Complex => [v, 0]);
const real = (...values: number[]): RigidMotion => harmonic(amplitudes(...values));
const box = (pole: Vector): SceneBody => ({name: 'body', node: false, drawn_as: 'box of equal inertia', dofs: [0, 1, 2, 3, 4, 5], solids: [], pole, centre_of_mass: pole, axes: [[1, 0, 0], [0, 1, 0], [0, 0, 1]], mass: 1,
                                           box: {centre: pole, axes: [[1, 0, 0], [0, 1, 0], [0, 0, 1]], size: [2, 4, 6]}});

test('a rotation about z moves a point on x along y', () => close(displacement(real(0, 0, 0, 0, 0, 0.1), [2, 0, 0], 0), [0, 0.2, 0]));
test('a rotation about x moves a point on z against y', () => close(displacement(real(0, 0, 0, 0.1, 0, 0), [0, 0, 3], 0), [0, -0.3, 0]));
test('a rotation about an axis moves no point of the axis', () => close(displacement(real(0, 0, 0, 1, 2, 3), [2, 4, 6], 0.7), [0, 0, 0]));
test('an imaginary part lags: it is −sin of the phase', () => {
  const motion = harmonic([[0, 1], ...amplitudes(0, 0, 0, 0, 0)]);
  close(displacement(motion, [0, 0, 0], Math.PI / 2), [-1, 0, 0]);
  close(displacement(motion, [0, 0, 0], 0), [0, 0, 0]);
});
test('two directions with a quarter of a period between them make a circle', () => {
  const motion = harmonic([[1, 0], [0, -1], ...amplitudes(0, 0, 0, 0)]);
  for (let i = 0; i < 8; i++) assert.ok(Math.abs(Math.hypot(...displacement(motion, [0, 0, 0], i)) - 1) < 1e-12);
});
test('coordinates along the axes of a turned body become those of the project', () => {
  const turned: SceneBody['axes'] = [[0, 1, 0], [-1, 0, 0], [0, 0, 1]];  // its x is the project's y
  close(inProjectFrame(amplitudes(1, 0, 0, 0, 2, 0), turned).map(v => v[0]), [0, 1, 0, -2, 0, 0]);
});
const of = (motion: RigidMotion): Motion => ({label: '', words: '', angular_frequency: 1, ends: new Map(), bodies: new Map([['body', motion]])});
test('the largest displacement of a translation is its size, of a rotation that of the farthest corner', () => {
  assert.ok(Math.abs(largestDisplacement(of(real(0, 3, 0, 0, 0, 0)), [box([1, 1, 1])]) - 3) < 1e-12);
  assert.ok(Math.abs(largestDisplacement(of(real(0, 0, 0, 1, 0, 0)), [box([0, 0, 0])]) - Math.hypot(2, 3)) < 1e-12);
});
test('a body takes its coordinates from their places in a shape', () => {
  const shape = [...Array(6).fill(0), 0, 0, 5, 0, 0, 0] as number[];
  const mode = {number: 4, angular_frequency: 9, shape, kinetic_energy_share: [], body_kinetic_energy_share: [], strain_energy_share: [], name: 'z'};
  const motion = ofMode({bodies: ['first', 'body'], elements: [], modes: [mode]}, 0, [{...box([0, 0, 0]), dofs: [6, 7, 8, 9, 10, 11]}])!;
  close(motion.bodies.get('body')![0]!.amplitudes.map(v => v[0]), [0, 0, 5, 0, 0, 0]);
  assert.equal(motion.angular_frequency, 9);
});
test('a damped mode is the root with positive frequency that is nearest to it', () => {
  const root = (im: number, mode: number) => ({eigenvalue: [-1, im] as const, kind: 'oscillating', angular_frequency: Math.abs(im), damping_ratio: 0.1,
                                               nearest_mode: mode, shape: [[im, 2], ...amplitudes(0, 0, 0, 0, 0)] as Complex[]});
  const motion = ofRoot({bodies: ['body'], roots: [root(-7, 2), root(5, 1), root(7, 2)]}, 2, [box([0, 0, 0])])!;
  assert.deepEqual(motion.bodies.get('body')![0]!.amplitudes[0], [7, 2]);
});
test('operating shapes move bodies about their poles, and ends on a foundation', () => {
  const shapes = {shapes: [{angular_frequency: 3, places: [{name: 'body', motion: [...amplitudes(1, 0, 0, 0, 0, 0)]}, {name: 'mount.foot', motion: [...amplitudes(0, 0, 2, 0, 0, 0)]}]}]};
  const motion = ofShape(shapes, [box([0, 0, 0])])!;
  assert.equal(motion.bodies.size, 1);
  assert.equal(motion.ends.get('mount.foot')![0]!.amplitudes[2]![0], 2);
});
test('ends on foundations move as modes and roots state', () => {
  const mode = {number: 1, angular_frequency: 9, shape: [0, 0, 0, 0, 0, 0], kinetic_energy_share: [], body_kinetic_energy_share: [], strain_energy_share: [], name: 'z', feet: [[0, 0, 3, 0, 0, 0]]};
  const motion = ofMode({bodies: ['body'], elements: [], feet: ['mount.foot'], modes: [mode]}, 0, [box([0, 0, 0])])!;
  close(displacement(motion.ends.get('mount.foot')!, [0, 0, 0], 0), [0, 0, 3]);
  assert.ok(Math.abs(largestDisplacement(motion, [box([0, 0, 0])]) - 3) < 1e-12);  // no body moves, and the foot is not drawn without end
});
test('ends on foundations lag in a damped mode as the program states', () => {
  const root = {eigenvalue: [-1, 7] as const, kind: 'oscillating', angular_frequency: 7, damping_ratio: 0.1, nearest_mode: 1, shape: [...amplitudes(0, 0, 1, 0, 0, 0)],
                feet: [[...amplitudes(0, 0), [0, -2] as const, ...amplitudes(0, 0, 0)]]};
  const motion = ofRoot({bodies: ['body'], feet: ['mount.foot'], roots: [root]}, 1, [box([0, 0, 0])])!;
  close(displacement(motion.ends.get('mount.foot')!, [0, 0, 0], Math.PI / 2), [0, 0, 2]);
});
test('ends that rest are no moving ground', () => {
  const shapes = {shapes: [{angular_frequency: 3, places: [{name: 'mount.foot', motion: [...amplitudes(0, 0, 0, 0, 0, 0)]}]}]};
  assert.equal(ofShape(shapes, [box([0, 0, 0])])!.ends.size, 0);
});
test('a steady motion is the sum of its mean and its harmonics', () => {
  const along = (z: Complex): Complex[] => [...amplitudes(0, 0), z, ...amplitudes(0, 0, 0)];
  const places = [{name: 'body', harmonics: [along([0.5, 0]), along([1, 0]), along([0, 0]), along([0, 0.25])]}, {name: 'mount.foot', harmonics: [along([0, 0]), along([2, 0])]}];
  const motion = ofSteady({curve: 0, periods: 1, stable: true, places}, 40, '', [box([0, 0, 0])]);
  for (const phase of [0, 0.4, 2, 5]) close(displacement(motion.bodies.get('body')!, [0, 0, 0], phase), [0, 0, 0.5 + Math.cos(phase) - 0.25 * Math.sin(3 * phase)]);
  close(displacement(motion.ends.get('mount.foot')!, [0, 0, 0], Math.PI), [0, 0, -2]);
});
test('the largest displacement of a motion with harmonics is not half a period away', () => {
  const motion: Motion = {label: '', words: '', angular_frequency: 1, ends: new Map(), bodies: new Map([['body', [{order: 0, amplitudes: amplitudes(-1, 0, 0, 0, 0, 0)}, {order: 1, amplitudes: amplitudes(3, 0, 0, 0, 0, 0)}]]])};
  assert.ok(Math.abs(largestDisplacement(motion, [box([0, 0, 0])]) - 4) < 1e-12);  // at the phase π
});
test('the largest displacement of one harmonic is that of its ellipse, to the last digits', () => {
  const motion = of(harmonic([[0.3, 0.2], [-0.4, 1], [0.7, -0.5], [0.02, 0.03], [-0.01, 0.05], [0.04, 0]])), bodies = [box([0.1, -0.2, 0.3])];
  const rigid = motion.bodies.get(bodies[0]!.name)!, arms = corners(bodies[0]!).map(c => c.map((v, k) => v - bodies[0]!.pole[k]!) as unknown as Vector);
  let scanned = 0;
  for (let i = 0; i < 20000; i++)
    for (const arm of arms) scanned = Math.max(scanned, Math.hypot(...displacement(rigid, arm, Math.PI * i / 20000)));
  const exact = largestDisplacement(motion, bodies);
  assert.ok(exact >= scanned && exact - scanned < 1e-8 * exact, `${exact} ${scanned}`);  // (π / 20000)² / 8
});
test('a forced motion states its size, a mode has none', () => {
  const forced = {...of(real(0, 3e-4, 0, 0, 0, 0)), hasSize: true}, bodies = [box([1, 1, 1])];
  assert.equal(sizeWords(forced, bodies, 250), 'largest displacement 300 µm 0-p, drawn 250 ×');
  assert.equal(sizeWords({...forced, hasSize: false}, bodies, 250), '');
  assert.equal(sizeWords({...of(real(0, 0, 0, 0, 0, 0)), hasSize: true}, bodies, 0), '');
});
