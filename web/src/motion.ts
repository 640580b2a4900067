// SPDX-License-Identifier: BSD-3-Clause
// Harmonic rigid motions of bodies: what an animated shape is made of.
import type {Complex, Modes, Roots, SceneBody, Shapes, Vector} from './results.ts';

/// Complex translation of the pole and rotation about it, in the frame of the project: x, y, z, θx, θy, θz.
export type RigidMotion = readonly Complex[];

/// A motion of the machine at one frequency. Bodies and ends of elements that are not named are at rest.
export interface Motion {
  label: string;
  words: string;
  angular_frequency: number;
  bodies: ReadonlyMap<string, RigidMotion>;
  ends: ReadonlyMap<string, RigidMotion>;  // "front left.foot": end of an element on a moving foundation
}

/// Coordinates along the axes of a body → along those of the project. Rows of `axes` are the axes of the body.
export function inProjectFrame(motion: RigidMotion, axes: SceneBody['axes']): RigidMotion {
  return [0, 3].flatMap(first => [0, 1, 2].map((row): Complex => [0, 1].map(part =>
    axes.reduce((sum, axis, k) => sum + axis[row]! * motion[first + k]![part]!, 0)) as unknown as Complex));
}

/// Displacement of a point at `arm` from the pole at a phase [rad] of the motion: Re((t + θ × arm) e^{i phase}).
export function displacement(motion: RigidMotion, arm: Vector, phase: number): [number, number, number] {
  const [x, y, z, a, b, c] = valuesAt(motion, phase) as [number, number, number, number, number, number];
  return [x + b * arm[2] - c * arm[1], y + c * arm[0] - a * arm[2], z + a * arm[1] - b * arm[0]];
}
/// The six coordinates at a phase [rad].
export function valuesAt(motion: RigidMotion, phase: number): number[] {
  const cos = Math.cos(phase), sin = Math.sin(phase);
  return motion.map(([re, im]) => re * cos - im * sin);
}

function ofBodies(bodies: readonly SceneBody[], shape: readonly Complex[]) {
  const found = new Map<string, RigidMotion>();
  for (const {name, axes, dofs} of bodies) {
    const six = dofs.map(place => shape[place]);
    if (six.every(value => value !== undefined)) found.set(name, inProjectFrame(six, axes));
  }
  return found;
}

export function ofMode(modes: Modes, index: number, bodies: readonly SceneBody[]): Motion | null {
  const mode = modes.modes[index];
  if (!mode) return null;
  return {label: `Mode ${mode.number}`, words: mode.name, angular_frequency: mode.angular_frequency, ends: new Map(),
          bodies: ofBodies(bodies, mode.shape.map(v => [v, 0]))};
}
/// The damped motion of the root nearest to a mode, without its decay: places move with different phases.
export function ofRoot(roots: Roots, mode: number, bodies: readonly SceneBody[]): Motion | null {
  const root = roots.roots.find(r => r.nearest_mode === mode && r.eigenvalue[1] > 0);
  if (!root) return null;
  return {label: `Damped mode ${mode}`, words: '', angular_frequency: root.eigenvalue[1], ends: new Map(),
          bodies: ofBodies(bodies, root.shape)};
}
/// The forced motion at a frequency.
export function ofShape(shapes: Shapes, bodies: readonly SceneBody[]): Motion | null {
  const shape = shapes.shapes[0];
  if (!shape) return null;
  const moving = new Map<string, RigidMotion>(), ends = new Map<string, RigidMotion>();
  for (const {name, motion} of shape.places) {
    (bodies.some(b => b.name === name) ? moving : ends).set(name, motion);  // along the axes of the project
  }
  return {label: 'Operating shape', words: '', angular_frequency: shape.angular_frequency, bodies: moving, ends};
}

/// Largest displacement of the corners of all bodies over a period [m]: the scale of a drawing.
export function largestDisplacement(motion: Motion, bodies: readonly SceneBody[], steps = 24): number {
  let largest = 0;
  for (const body of bodies) {
    const rigid = motion.bodies.get(body.name);
    if (!rigid) continue;
    for (const corner of corners(body)) {
      const arm = corner.map((v, k) => v - body.pole[k]!) as unknown as Vector;
      for (let s = 0; s < steps; s++) largest = Math.max(largest, Math.hypot(...displacement(rigid, arm, Math.PI * s / steps)));
    }
  }
  return largest;
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
