// SPDX-License-Identifier: BSD-3-Clause
// Screw axes of modes as the program states them, placed in the machine.
import {withUnit} from './quantities.ts';
import type {Modes, SceneBody, Vector} from './results.ts';

export interface PlacedScrew {
  direction: Vector;
  point: Vector | null;  // null: a pure translation
  pitch: number | null;  // [m/rad]
}

/// The screw of a body in a mode, in the frame of the project.
export function screwOf(modes: Modes, number: number, body: SceneBody): PlacedScrew | null {
  const screw = modes.modes.find(m => m.number === number)?.screws?.[modes.bodies.indexOf(body.name)];
  if (!screw || Math.hypot(...screw.direction) === 0) return null;  // it does not move
  const turned = (v: Vector) => [0, 1, 2].map(row => body.axes.reduce((sum, axis, k) => sum + axis[row]! * v[k]!, 0)) as unknown as Vector;
  const point = screw.point && turned(screw.point).map((v, k) => v + body.pole[k]!) as unknown as Vector;
  return {direction: turned(screw.direction), point, pitch: screw.pitch};
}
/// Where the axis is, and how far the body moves along it.
export function screwWords({point, pitch}: PlacedScrew, {centre_of_mass}: SceneBody): string {
  if (!point) return 'translation without rotation';
  const distance = Math.hypot(...point.map((v, k) => v - centre_of_mass[k]!));
  return `screw axis ${withUnit(distance, 'm', 3)} from the centre of mass, pitch ${withUnit(Math.abs(pitch!) < 1e-9 ? 0 : pitch, 'm', 3)}/rad`;
}
