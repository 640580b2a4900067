// SPDX-License-Identifier: BSD-3-Clause
import {Group, LineBasicMaterial, LineSegments, Mesh, MeshLambertMaterial, type Object3D} from 'three';
import type {Motion} from '../motion.ts';
import {rigidMatrix, type BodyObject} from './body_object.ts';
import type {Colours} from './colours.ts';
import type {ElementObject} from './element_object.ts';

/// What a moving machine is compared with: its edges at rest, the whole machine at rest, or also its flashes.
export const GHOSTS = {edges: 'edges at rest', rest: 'machine at rest', strobe: 'stroboscope'} as const;
export type Ghost = keyof typeof GHOSTS;

const FLASHES = 8;  // in a period

/// Transparent copies of bodies and elements. They share the geometry of what they are copies of.
export class Ghosts {
  readonly root = new Group();
  private readonly fill: MeshLambertMaterial;
  private readonly line: LineBasicMaterial;
  private atRest: Group | null = null;  // made when it is first wanted
  private readonly flashes = new Group();

  constructor(private readonly bodies: readonly BodyObject[], private readonly elements: readonly ElementObject[], colours: Colours) {
    this.fill = new MeshLambertMaterial({color: colours.rest, transparent: true, opacity: 0.28, depthWrite: false});
    this.line = new LineBasicMaterial({color: colours.trace, transparent: true, opacity: 0.55, depthWrite: false});
    this.root.add(this.flashes);
  }
  show(ghost: Ghost, motion: Motion | null, scale: number) {
    const moves = motion !== null && scale > 0;
    if (ghost !== 'edges' && moves) this.root.add(this.atRest ??= this.machineAtRest());
    if (this.atRest) this.atRest.visible = ghost !== 'edges' && moves;
    this.flashes.clear();
    if (ghost !== 'strobe' || !moves) return;
    for (const {body, atRest} of this.bodies) {
      const rigid = motion.bodies.get(body.name);
      for (let i = 0; rigid && i < FLASHES; i++) this.flashes.add(this.flash(atRest, rigidMatrix(body.pole, rigid, 2 * Math.PI * i / FLASHES, scale)));
    }
  }
  dispose() {
    this.fill.dispose();
    this.line.dispose();
  }

  private flash(edges: Group, matrix: Group['matrix']): Group {
    const copy = new Group();
    copy.matrixAutoUpdate = false;
    copy.matrix.copy(matrix);
    copy.matrixWorldNeedsUpdate = true;
    for (const part of edges.children) copy.add(new LineSegments((part as LineSegments).geometry, this.line));
    return copy;
  }
  private machineAtRest(): Group {
    const group = new Group();
    for (const {object, rest} of [...this.bodies, ...this.elements]) {
      const copy = object.clone(true);
      copy.matrix.copy(rest);
      copy.matrixWorldNeedsUpdate = true;
      for (const part of collected(copy)) {
        part.userData = {};  // one does not select a ghost
        if (part instanceof Mesh) part.material = this.fill;
        else if (part instanceof LineSegments) part.visible = false;
      }
      group.add(copy);
    }
    return group;
  }
}
function collected(object: Object3D): Object3D[] {
  const all: Object3D[] = [];
  object.traverse(part => all.push(part));
  return all;
}
