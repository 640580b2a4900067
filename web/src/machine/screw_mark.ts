// SPDX-License-Identifier: BSD-3-Clause
import {ArrowHelper, BufferGeometry, Group, Line, LineBasicMaterial, Vector3, type Mesh, type MeshBasicMaterial} from 'three';
import type {PlacedScrew} from '../screws.ts';
import {disposeAll} from './body_object.ts';
import type {Colours} from './colours.ts';
import {around} from './force_marks.ts';

/// The axis about which a body turns in a mode, with the sense of its rotation; an arrow for its motion along the axis,
/// or for a translation.
export function screwMark({direction, point, pitch}: PlacedScrew, from: Vector3, size: number, colours: Colours): Group {
  const group = new Group(), along = new Vector3(...direction), middle = point ? new Vector3(...point) : from;
  if (point) {
    const ends = [-0.6, 0.6].map(part => middle.clone().addScaledVector(along, part * size)), arc = around(along, 0.09 * size, colours.selected);
    arc.position.copy(middle);
    group.add(new Line(new BufferGeometry().setFromPoints(ends), new LineBasicMaterial({color: colours.selected})), arc);
  }
  const forward = along.clone().multiplyScalar(pitch !== null && pitch < 0 ? -1 : 1), length = point ? 0.14 * size : 0.3 * size;
  if (!point || Math.abs(pitch ?? 0) > 1e-3 * size) group.add(new ArrowHelper(forward, middle, length, colours.selected, 0.05 * size, 0.026 * size));
  group.traverse(part => {
    part.renderOrder = 9;
    const material = (part as Mesh).material as MeshBasicMaterial | undefined;
    if (material) material.depthTest = false;  // most axes are inside a body
  });
  return group;
}
/// Shows one in place of another.
export function replace(group: Group, mark: Group | null) {
  disposeAll(group);
  group.clear();
  if (mark) group.add(mark);
}
