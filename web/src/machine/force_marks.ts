// SPDX-License-Identifier: BSD-3-Clause
import {ArrowHelper, BufferGeometry, ConeGeometry, Group, Line, LineBasicMaterial, Mesh, MeshBasicMaterial, Quaternion, Vector3, type Object3D} from 'three';
import type {SceneForce} from '../results.ts';
import type {Colours} from './colours.ts';

/// An excitation, drawn about its point: a force as an arrow that ends there, a moment and a rotating force as an arrow
/// around its axis.
export function forceMark(force: SceneForce, size: number, colours: Colours): Object3D {
  const axis = new Vector3(...force.direction);
  if (axis.lengthSq() === 0) axis.set(0, 0, 1);
  axis.normalize();
  const mark = force.kind === 'force' || force.kind === 'ground_translation' ? straight(axis, size, colours.force)
                                                                            : around(axis, (force.kind === 'rotating_force' ? 0.05 : 0.09) * size, colours.force);
  mark.traverse(part => {
    part.userData = {kind: 'force', name: force.name};
    part.renderOrder = 8;
    const material = (part as Mesh).material as MeshBasicMaterial | undefined;
    if (material) material.depthTest = false;  // most act inside a body
  });
  return mark;
}
function straight(axis: Vector3, size: number, colour: number): Object3D {
  const group = new Group(), length = 0.18 * size;
  group.add(new ArrowHelper(axis, axis.clone().multiplyScalar(-length), length, colour, 0.04 * size, 0.022 * size));
  return group;
}
export function around(axis: Vector3, radius: number, colour: number): Object3D {
  const group = new Group(), last = 1.55 * Math.PI;
  const points = Array.from({length: 41}, (_, i) => new Vector3(radius * Math.cos(last * i / 40), radius * Math.sin(last * i / 40), 0));
  const tip = new Mesh(new ConeGeometry(0.2 * radius, 0.5 * radius, 14), new MeshBasicMaterial({color: colour}));
  tip.position.copy(points.at(-1)!);
  tip.rotation.z = last;  // a cone points along y, the tangent at angle 0
  group.add(new Line(new BufferGeometry().setFromPoints(points), new LineBasicMaterial({color: colour})), tip);
  group.quaternion.copy(new Quaternion().setFromUnitVectors(new Vector3(0, 0, 1), axis));
  return group;
}
