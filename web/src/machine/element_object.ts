// SPDX-License-Identifier: BSD-3-Clause
import {Group, Matrix4, Vector3, type Color, type Mesh, type MeshLambertMaterial} from 'three';
import {displacement, type Motion, type RigidMotion} from '../motion.ts';
import type {End, SceneBody, SceneElement, Vector} from '../results.ts';
import {disposeAll, rigidMatrix} from './body_object.ts';
import type {Colours} from './colours.ts';
import {elementShape} from './element_shapes.ts';
import {footPlate} from './marks.ts';

type Bodies = ReadonlyMap<string, SceneBody>;

/// An element between its two ends, as a coil, a rubber mount, … It is stretched and sheared as its ends move. One whose
/// ends coincide has no length in the model; it is drawn with one, away from its body.
export class ElementObject {
  readonly object = new Group();
  readonly rest: Matrix4;
  readonly foot: Group | null;  // a piece of the ground or the foundation below end N, which may move
  private readonly ends: {from: Vector3; to: Vector3};
  private readonly across: readonly [Vector3, Vector3];
  private readonly length: number;

  constructor(readonly element: SceneElement, bodies: Bodies, size: number, up: Vector3, colours: Colours) {
    this.object.matrixAutoUpdate = false;
    const [e1, e2, e3] = element.axes.map(e => new Vector3(...e)) as [Vector3, Vector3, Vector3];
    const from = new Vector3(...element.from.at), to = new Vector3(...element.to.at), bush = element.rubber?.length;
    if (bush) spread(from, to, e3, bush / 2, bush / 2);
    else if (from.distanceTo(to) < 0.01 * size) {
      const length = Math.min(Math.max(element.size[0], 0.07 * size), 0.12 * size), side = e3.clone().multiplyScalar(outwards(element, bodies, e3));
      if (element.from.body && element.to.body) spread(from, to, e3, length / 2, length / 2);
      else if (element.from.body) to.addScaledVector(side, length);
      else from.addScaledVector(side, length);
    }
    this.ends = {from, to};
    this.length = Math.max(from.distanceTo(to), 1e-9);
    const along = to.clone().sub(from).normalize(), straight = Math.abs(along.dot(e3)) > 0.99;
    const first = straight ? e1 : new Vector3().crossVectors(Math.abs(along.x) < 0.9 ? new Vector3(1, 0, 0) : new Vector3(0, 1, 0), along).normalize();
    this.across = [first, straight && along.dot(e3) > 0 ? e2 : along.clone().cross(first)];
    this.object.add(...elementShape(element, this.length, size, colours));
    this.object.traverse(part => (part.userData = {kind: 'element', name: element.name}));
    this.place(from, to);
    this.rest = this.object.matrix.clone();
    this.foot = element.from.body ? null : footPlate(size, up, colours);
    if (this.foot) this.foot.traverse(part => (part.userData = {kind: 'element', name: element.name}));
    this.move(null, bodies, 0, 0);
  }
  move(motion: Motion | null, bodies: Bodies, phase: number, scale: number) {
    const {element: {from, to, name}, ends, foot} = this;
    this.place(moved(ends.from, from, motion, bodies, phase, scale, `${name}.foot`),
               moved(ends.to, to, motion, bodies, phase, scale, `${name}.head`));
    if (!foot) return;
    const rigid = motion?.ends.get(`${name}.foot`) ?? null, {x, y, z} = ends.from;
    for (const part of foot.children) part.visible = from.foundation !== undefined || rigid !== null;  // rigid ground is the grid
    foot.matrix.copy(rigidMatrix([x, y, z], rigid, phase, scale));
    foot.matrixWorldNeedsUpdate = true;
  }
  highlight(on: boolean, colours: Colours) {
    this.object.traverse(part => {
      const material = (part as Mesh).material as MeshLambertMaterial | undefined;
      material?.emissive?.setHex(on ? colours.selected : 0).multiplyScalar(on ? 0.7 : 1);
    });
  }
  /// Another colour for all its parts; null: its own.
  paint(colour: Color | null) {
    this.object.traverse(part => {
      const material = (part as Mesh).material as MeshLambertMaterial | undefined;
      if (!material?.color) return;
      const own: Color = material.userData['own'] ??= material.color.clone();
      material.color.copy(colour ?? own);
    });
  }
  dispose() {
    disposeAll(this.object);
    if (this.foot) disposeAll(this.foot);
  }

  private place(from: Vector3, to: Vector3) {
    const along = to.clone().sub(from).divideScalar(this.length), [x, y] = this.across;
    this.object.matrix.copy(new Matrix4().makeBasis(x, y, along).setPosition(from));
    this.object.matrixWorldNeedsUpdate = true;
  }
}

const spread = (from: Vector3, to: Vector3, axis: Vector3, back: number, ahead: number) => {
  from.addScaledVector(axis, -back);
  to.addScaledVector(axis, ahead);
};
/// Where an end is in a phase of the motion: on its body, or on a foundation that moves.
function moved(rest: Vector3, end: End, motion: Motion | null, bodies: Bodies, phase: number, scale: number, name: string): Vector3 {
  if (!motion) return rest;
  const body = bodies.get(end.body ?? ''), rigid: RigidMotion | undefined = body ? motion.bodies.get(body.name) : motion.ends.get(name);
  if (!rigid) return rest;
  const arm = (body ? end.at.map((v, k) => v - body.pole[k]!) : [0, 0, 0]) as unknown as Vector;
  return rest.clone().addScaledVector(new Vector3(...displacement(rigid, arm, phase)), scale);
}
/// 1 or −1: the side of the axis that points away from the centre of mass of the body; down if there is no difference.
function outwards({from, to}: SceneElement, bodies: Bodies, axis: Vector3): number {
  const body = bodies.get(to.body ?? '') ?? bodies.get(from.body ?? '');
  const along = body ? axis.dot(new Vector3(...to.at).sub(new Vector3(...body.centre_of_mass))) : 0;
  return along > 1e-9 ? 1 : along < -1e-9 ? -1 : axis.z > 0 ? -1 : 1;
}
