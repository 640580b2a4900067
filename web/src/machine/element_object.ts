// SPDX-License-Identifier: BSD-3-Clause
import {Group, Matrix4, Vector3, type MeshStandardMaterial, type Mesh} from 'three';
import {displacement, type Motion, type RigidMotion} from '../motion.ts';
import type {End, SceneBody, SceneElement, Vector} from '../results.ts';
import {disposeAll} from './body_object.ts';
import type {Colours} from './colours.ts';
import {elementShape} from './element_shapes.ts';

/// An element between its two ends, as a coil, a rubber mount, a bush, … It is stretched and sheared as its ends move.
/// An element whose ends coincide has no length in the model; it is drawn with one, away from its body.
export class ElementObject {
  readonly object = new Group();
  private readonly rest: {from: Vector3; to: Vector3};
  private readonly across: [Vector3, Vector3];
  private readonly length: number;

  constructor(readonly element: SceneElement, bodies: ReadonlyMap<string, SceneBody>, size: number, up: Vector3, colours: Colours) {
    this.object.matrixAutoUpdate = false;
    const from = new Vector3(...element.from.at), to = new Vector3(...element.to.at);
    if (from.distanceTo(to) < 0.01 * size) {
      const length = Math.min(Math.max(element.size?.[0] ?? 0, 0.05 * size), 0.12 * size);
      const isGround = !bodies.has(element.to.body), away = awayFrom(element, bodies, up).multiplyScalar(length);
      (isGround ? to : from).add(away);
    }
    this.rest = {from, to};
    this.length = Math.max(from.distanceTo(to), 1e-9);
    const along = to.clone().sub(from).normalize();
    const first = new Vector3(Math.abs(along.x) < 0.9 ? 1 : 0, Math.abs(along.x) < 0.9 ? 0 : 1, 0).cross(along).normalize();
    this.across = [first, along.clone().cross(first)];
    this.object.add(...elementShape(element, this.length, size, colours));
    this.object.traverse(part => (part.userData = {kind: 'element', name: element.name}));
    this.place(from, to);
  }
  move(motion: Motion | null, bodies: ReadonlyMap<string, SceneBody>, phase: number, scale: number) {
    const {element: {from, to, name}, rest} = this;
    this.place(moved(rest.from, from, motion, bodies, phase, scale, `${name}.foot`),
               moved(rest.to, to, motion, bodies, phase, scale, `${name}.head`));
  }
  highlight(on: boolean, colours: Colours) {
    this.object.traverse(part => {
      const material = (part as Mesh).material as MeshStandardMaterial | undefined;
      material?.emissive?.setHex(on ? colours.selected : 0).multiplyScalar(on ? 0.7 : 1);
    });
  }
  dispose() { disposeAll(this.object); }

  private place(from: Vector3, to: Vector3) {
    const along = to.clone().sub(from).divideScalar(this.length), [x, y] = this.across;
    this.object.matrix.copy(new Matrix4().makeBasis(x, y, along).setPosition(from));
    this.object.matrixWorldNeedsUpdate = true;
  }
}

/// Where an end is in a phase of the motion: on its body, or on a foundation that moves.
function moved(rest: Vector3, end: End, motion: Motion | null, bodies: ReadonlyMap<string, SceneBody>, phase: number, scale: number,
               name: string): Vector3 {
  if (!motion) return rest;
  const body = bodies.get(end.body), rigid: RigidMotion | undefined = body ? motion.bodies.get(body.name) : motion.ends.get(name);
  if (!rigid) return rest;
  const arm = (body ? end.at.map((v, k) => v - body.pole[k]!) : [0, 0, 0]) as unknown as Vector;
  const [x, y, z] = displacement(rigid, arm, phase);
  return rest.clone().add(new Vector3(x, y, z).multiplyScalar(scale));
}

/// Direction in which an element without length is drawn: along its axis, away from the centre of mass of its body.
function awayFrom({axis, from, to}: SceneElement, bodies: ReadonlyMap<string, SceneBody>, up: Vector3): Vector3 {
  if (!axis) return up.clone().negate();
  const body = bodies.get(to.body) ?? bodies.get(from.body), direction = new Vector3(...axis).normalize();
  if (!body) return direction;
  const outwards = new Vector3(...to.at).sub(new Vector3(...body.centre_of_mass));
  return direction.dot(outwards) < 0 ? direction.negate() : direction;
}
