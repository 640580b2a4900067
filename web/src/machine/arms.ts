// SPDX-License-Identifier: BSD-3-Clause
import {Box3, Matrix4, Vector3} from 'three';
import type {Scene, SceneBody, Vector} from '../results.ts';

/// Straight lines from a body to its places outside its box: mounts, points and excitations that it holds at a distance.
/// @returns pairs of ends, in the frame of the project
export function armsOf(body: SceneBody, {elements, points, forces, size}: Pick<Scene, 'elements' | 'points' | 'forces' | 'size'>): [Vector3, Vector3][] {
  if (body.node) return [];
  const places: Vector[] = [...elements.flatMap(e => [e.from, e.to].filter(end => end.body === body.name).map(end => end.at)),
                            ...points.filter(p => p.body === body.name).map(p => p.at), ...forces.filter(f => f.body === body.name).map(f => f.at)];
  const found = new Map<string, [Vector3, Vector3]>();
  for (const at of places) {
    const place = new Vector3(...at), near = nearestOf(body, place);
    if (near.distanceTo(place) > 1e-6 * size) found.set(at.join(), [near, place]);
  }
  return [...found.values()];
}
/// The place of the body's box, or of the box around its solids, that is nearest; of a body without size its centre of mass.
function nearestOf({box, solids, centre_of_mass: centre}: SceneBody, place: Vector3): Vector3 {
  if (solids.length) {
    const around = new Box3();
    for (const {vertices} of solids) for (let i = 0; i < vertices.length; i += 3) around.expandByPoint(new Vector3(...vertices.slice(i, i + 3) as [number, number, number]));
    return around.clampPoint(place, new Vector3());
  }
  if (!box) return new Vector3(...centre);
  const [x, y, z] = box.axes.map(axis => new Vector3(...axis)) as [Vector3, Vector3, Vector3];
  const frame = new Matrix4().makeBasis(x, y, z).setPosition(...box.centre as [number, number, number]), half = new Vector3(...box.size).multiplyScalar(0.5);
  const inBox = place.clone().applyMatrix4(frame.clone().invert()).clamp(half.clone().negate(), half);
  return inBox.applyMatrix4(frame);
}
