// SPDX-License-Identifier: BSD-3-Clause
// Periodic rigid motions of bodies: what an animated shape is made of.
import {number, withUnit} from './quantities.ts';
import type {Complex, Mode, Modes, Root, Roots, SceneBody, Shapes, SteadyMotion, Vector} from './results.ts';

/// Complex translation of the pole and rotation about it, in the frame of the project: x, y, z, θx, θy, θz.
export type Amplitudes = readonly Complex[];
/// The amplitudes of each harmonic of a period: Σ Re(amplitude e^{i order phase}). Order 0 is the mean.
export type RigidMotion = readonly {order: number; amplitudes: Amplitudes}[];

/// A periodic motion of the machine. Bodies and ends of elements that are not named are at rest.
export interface Motion {
  label: string;
  words: string;
  angular_frequency: number;  // that it is named by: of the mode, or of the excitation
  bodies: ReadonlyMap<string, RigidMotion>;
  ends: ReadonlyMap<string, RigidMotion>;  // "front left.foot": end of an element on a moving foundation
  hasSize?: boolean;  // it is forced; a mode has no size of its own
}

/// Coordinates along the axes of a body → along those of the project. Rows of `axes` are the axes of the body.
export function inProjectFrame(motion: Amplitudes, axes: SceneBody['axes']): Amplitudes {
  return [0, 3].flatMap(first => [0, 1, 2].map((row): Complex => [0, 1].map(part =>
    axes.reduce((sum, axis, k) => sum + axis[row]! * motion[first + k]![part]!, 0)) as unknown as Complex));
}

export const harmonic = (amplitudes: Amplitudes): RigidMotion => [{order: 1, amplitudes}];

/// Displacement of a point at `arm` from the pole at a phase [rad] of the motion: t + θ × arm.
export function displacement(motion: RigidMotion, arm: Vector, phase: number): [number, number, number] {
  const [x, y, z, a, b, c] = valuesAt(motion, phase) as [number, number, number, number, number, number];
  return [x + b * arm[2] - c * arm[1], y + c * arm[0] - a * arm[2], z + a * arm[1] - b * arm[0]];
}
/// The six coordinates at a phase [rad].
export function valuesAt(motion: RigidMotion, phase: number): number[] {
  const values = [0, 0, 0, 0, 0, 0];
  for (const {order, amplitudes} of motion) {
    const cos = Math.cos(order * phase), sin = Math.sin(order * phase);
    amplitudes.forEach(([re, im], k) => { values[k]! += re * cos - im * sin; });
  }
  return values;
}

function ofBodies(bodies: readonly SceneBody[], shape: readonly Complex[]) {
  const found = new Map<string, RigidMotion>();
  for (const {name, axes, dofs} of bodies) {
    const six = dofs.map(place => shape[place]);
    if (six.every(value => value !== undefined)) found.set(name, harmonic(inProjectFrame(six, axes)));
  }
  return found;
}
/// Ends on foundations, along the axes of the project.
const ofFeet = (feet: readonly string[] | undefined, motions: readonly Amplitudes[] | undefined) =>
  new Map(feet?.map((name, i) => [name, harmonic(motions![i]!)]));
const real = (values: readonly number[]) => values.map((v): Complex => [v, 0]);

/// What the motion of a mode needs of a document of modes.
export interface MovingModes {
  feet?: string[];
  modes: readonly Pick<Mode, 'number' | 'angular_frequency' | 'name' | 'shape' | 'feet'>[];
}
export function ofMode(modes: Modes | MovingModes, index: number, bodies: readonly SceneBody[]): Motion | null {
  const mode = modes.modes[index];
  if (!mode?.shape) return null;
  return {label: `Mode ${mode.number}`, words: mode.name, angular_frequency: mode.angular_frequency,
          ends: ofFeet(modes.feet, mode.feet?.map(real)), bodies: ofBodies(bodies, real(mode.shape))};
}
export interface MovingRoots {
  feet?: string[];
  roots: readonly Pick<Root, 'eigenvalue' | 'shape' | 'nearest_mode' | 'feet'>[];
}
/// The damped motion of the root nearest to a mode, without its decay: places move with different phases.
export function ofRoot(roots: Roots | MovingRoots, mode: number, bodies: readonly SceneBody[]): Motion | null {
  const root = roots.roots.find(r => r.nearest_mode === mode && r.eigenvalue[1] > 0);
  if (!root) return null;
  return {label: `Damped mode ${mode}`, words: '', angular_frequency: root.eigenvalue[1], ends: ofFeet(roots.feet, root.feet),
          bodies: ofBodies(bodies, root.shape)};
}
/// The forced motion at a frequency.
export function ofShape(shapes: Shapes, bodies: readonly SceneBody[]): Motion | null {
  const shape = shapes.shapes[0];
  if (!shape) return null;
  return {label: 'Operating shape', words: '', angular_frequency: shape.angular_frequency, hasSize: true,
          ...ofPlaces(shape.places.map(({name, motion}) => [name, harmonic(motion)]), bodies)};
}
/// A steady motion with all its harmonics, at the parameter of its curve.
export function ofSteady(motion: SteadyMotion, angular_frequency: number, words: string, bodies: readonly SceneBody[]): Motion {
  const places = motion.places.map(({name, harmonics}): [string, RigidMotion] => [name, harmonics.map((amplitudes, order) => ({order, amplitudes}))]);
  return {label: 'Steady motion', words, angular_frequency, hasSize: true, ...ofPlaces(places, bodies)};
}
/// Bodies, and other places that move, which are ends of elements; along the axes of the project.
function ofPlaces(places: readonly (readonly [string, RigidMotion])[], bodies: readonly SceneBody[]) {
  const isBody = ([name]: readonly [string, RigidMotion]) => bodies.some(b => b.name === name);
  return {bodies: new Map(places.filter(isBody)), ends: new Map(places.filter(p => !isBody(p) && moves(p[1])))};
}

const moves = (rigid: RigidMotion) => rigid.some(({amplitudes}) => amplitudes.some(([re, im]) => re !== 0 || im !== 0));
export const highestOrder = (motion: Motion) => Math.max(1, ...[...motion.bodies.values()].flatMap(rigid => rigid.map(h => h.order)));

/// Largest displacement of the corners of all bodies, and of moving ends, over a period [m]: the scale of a drawing. Exact of one harmonic;
/// of several the largest of 64 places in each period of the highest.
export function largestDisplacement(motion: Motion, bodies: readonly SceneBody[]): number {
  const count = 64 * highestOrder(motion), middle: Vector = [0, 0, 0];
  let largest = 0;
  const reach = (rigid: RigidMotion, arm: Vector) => {
    if (rigid.length === 1 && rigid[0]!.order > 0) largest = Math.max(largest, longestRadius(rigid, arm));
    else for (let s = 0; s < count; s++) largest = Math.max(largest, Math.hypot(...displacement(rigid, arm, 2 * Math.PI * s / count)));
  };
  for (const end of motion.ends.values()) reach(end, middle);
  for (const body of bodies) {
    const rigid = motion.bodies.get(body.name);
    if (!rigid) continue;
    for (const corner of corners(body)) reach(rigid, corner.map((v, k) => v - body.pole[k]!) as unknown as Vector);
  }
  return largest;
}
/// Of the ellipse on which a place moves in one harmonic, a cos φ + b sin φ: |u|² = p + q cos 2φ + a·b sin 2φ with p, q = (a² ± b²)/2.
function longestRadius(motion: RigidMotion, arm: Vector): number {
  const [{order}] = motion as [RigidMotion[number]], a = displacement(motion, arm, 0), b = displacement(motion, arm, Math.PI / 2 / order);
  const dot = (u: readonly number[], v: readonly number[]) => u.reduce((sum, value, k) => sum + value * v[k]!, 0), aa = dot(a, a), bb = dot(b, b);
  return Math.sqrt((aa + bb) / 2 + Math.hypot((aa - bb) / 2, dot(a, b)));
}
/// How large a forced motion is, and how much larger it is drawn; empty of a mode.
export function sizeWords(motion: Motion, bodies: readonly SceneBody[], scale: number): string {
  const largest = motion.hasSize ? largestDisplacement(motion, bodies) : 0;
  return largest > 0 && scale > 0 ? `largest displacement ${withUnit(largest, 'm', 3)} 0-p, drawn ${number(Number(scale.toPrecision(2)), 7)} ×` : '';
}
/// Corners of the box of a body, in the frame of the project.
export function corners({box, pole, solids}: SceneBody): Vector[] {
  if (solids.length) return solids.flatMap(({vertices}) => extremes(vertices));
  if (!box) return [pole];
  const signs = [-0.5, 0.5];
  return signs.flatMap(i => signs.flatMap(j => signs.map(k => [0, 1, 2].map(row =>
    box.centre[row]! + i * box.size[0] * box.axes[0][row]! + j * box.size[1] * box.axes[1][row]! +
    k * box.size[2] * box.axes[2][row]!) as unknown as Vector)));
}
/// The vertices of a solid that are farthest along and against each axis.
function extremes(vertices: readonly number[]): Vector[] {
  const found: Vector[] = [];
  for (let k = 0; k < 3; k++) {
    let [low, high] = [0, 0];
    for (let i = 0; i < vertices.length; i += 3) {
      if (vertices[i + k]! < vertices[low + k]!) low = i;
      if (vertices[i + k]! > vertices[high + k]!) high = i;
    }
    for (const i of [low, high]) found.push([vertices[i]!, vertices[i + 1]!, vertices[i + 2]!]);
  }
  return found;
}
