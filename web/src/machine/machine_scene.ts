// SPDX-License-Identifier: BSD-3-Clause
import {Box3, Group, Vector3, type Object3D} from 'three';
import {corners, displacement, largestDisplacement, type Motion} from '../motion.ts';
import type {Scene, SceneBody, Vector} from '../results.ts';
import type {MountValues} from '../mount_colouring.ts';
import type {PlacedScrew} from '../screws.ts';
import type {Selection} from '../state.ts';
import type {Picked} from './picking.ts';
import {armsOf} from './arms.ts';
import {BodyObject, disposeAll} from './body_object.ts';
import {colourOf} from './colour_scale.ts';
import type {Colours} from './colours.ts';
import {ElementObject} from './element_object.ts';
import {forceMark} from './force_marks.ts';
import {Ghosts, type Ghost} from './ghosts.ts';
import {centreOfMassMark, clearanceMark, ground, markedPoles, pointMark, poleMark, stopMark, trace} from './marks.ts';
import {replace, screwMark} from './screw_mark.ts';
import {sharePrograms} from './shader_programs.ts';

interface Follower {
  object: Object3D;
  body: SceneBody;
  at: Vector;
  rest: Vector3;
}

/// All objects of a machine, and how they move.
export class MachineScene {
  readonly root = new Group();
  readonly bounds = new Box3();
  private readonly bodies: BodyObject[];
  private readonly elements: ElementObject[];
  private readonly byName: ReadonlyMap<string, SceneBody>;
  private readonly followers: Follower[] = [];  // marks that move with their body
  private readonly rest = new Group();
  private readonly traces = new Group();
  private readonly ghosts: Ghosts;
  private readonly screw = new Group();

  constructor(readonly scene: Scene, private readonly colours: Colours) {
    const up = scene.gravity && Math.hypot(...scene.gravity) > 0 ? new Vector3(...scene.gravity).negate().normalize() : new Vector3(0, 0, 1);
    this.byName = new Map(scene.bodies.map(b => [b.name, b]));
    this.bodies = scene.bodies.map(b => new BodyObject(b, scene.size, colours, armsOf(b, scene)));
    this.elements = scene.elements.map(e => new ElementObject(e, this.byName, scene.size, up, colours));
    this.ghosts = new Ghosts(this.bodies, this.elements, colours);
    for (const {object, atRest} of this.bodies) {
      this.root.add(object);
      this.rest.add(atRest);
    }
    for (const {object, foot} of this.elements) this.root.add(object, ...(foot ? [foot] : []));
    this.root.add(this.rest, this.traces, this.ghosts.root, this.screw);
    for (const body of scene.bodies.filter(b => !b.node)) this.follow(centreOfMassMark(colours), body, body.centre_of_mass, {kind: 'body', name: body.name});
    for (const body of markedPoles(scene)) this.follow(poleMark(), body, body.pole, {kind: 'body', name: body.name, words: `pole of ${body.name}`});
    for (const point of scene.points) {
      const body = this.byName.get(point.body);
      if (body) this.follow(pointMark(colours), body, point.at, {kind: 'point', name: point.name});
    }
    for (const force of scene.forces) {
      const body = this.byName.get(force.body ?? ''), mark = forceMark(force, scene.size, colours);
      mark.position.set(...force.at);
      if (body) this.follow(mark, body, force.at, {kind: 'force', name: force.name});
      else this.root.add(mark);
    }
    for (const stop of scene.stops) {
      const mark = stopMark(stop, scene.size, colours);
      mark.position.set(...stop.at);
      mark.traverse(part => (part.userData = {kind: 'element', name: stop.name}));
      this.root.add(mark);
    }
    for (const clearance of scene.clearances) this.root.add(clearanceMark(clearance, colours));
    this.root.updateMatrixWorld(true);
    this.measure();
    const centre = this.bounds.getCenter(new Vector3()), lowest = lowestAlong(this.bounds, up);
    this.root.add(ground(lowest, centre, scene.size, up, colours));
    sharePrograms(this.root);
  }
  /// Factor from the true motion to the drawn one: the largest displacement is `share` of the size of the machine.
  scaleFor(motion: Motion, share: number): number {
    const largest = largestDisplacement(motion, this.scene.bodies);
    return largest > 0 ? share * this.scene.size / largest : 0;
  }
  move(motion: Motion | null, phase: number, scale: number) {
    for (const body of this.bodies) body.move(motion?.bodies.get(body.body.name) ?? null, phase, scale);
    for (const element of this.elements) element.move(motion, this.byName, phase, scale);
    for (const {object, body, at, rest} of this.followers) {
      const rigid = motion?.bodies.get(body.name), arm = at.map((v, k) => v - body.pole[k]!) as unknown as Vector;
      object.position.copy(rest);
      if (rigid) object.position.addScaledVector(new Vector3(...displacement(rigid, arm, phase)), scale);
    }
    this.rest.visible = motion !== null && scale > 0;
  }
  showTraces(motion: Motion | null, scale: number) {
    disposeAll(this.traces);
    this.traces.clear();
    if (!motion) return;
    for (const body of this.scene.bodies) {
      const points = this.scene.points.filter(p => p.body === body.name).map(p => p.at);
      for (const at of [...points, body.centre_of_mass, ...corners(body).slice(-4)])
        this.traces.add(trace(at, body, motion, scale, this.colours));
    }
    sharePrograms(this.traces);
  }
  showGhosts(ghost: Ghost, motion: Motion | null, scale: number) {
    this.ghosts.show(ghost, motion, scale);
    sharePrograms(this.ghosts.root);
  }
  /// The axis of a body that moves as a screw; null: none.
  showScrew(screw: PlacedScrew | null, body: SceneBody | null) {
    replace(this.screw, screw && body && screwMark(screw, new Vector3(...body.centre_of_mass), this.scene.size, this.colours));
    sharePrograms(this.screw);
  }
  highlight(selection: Selection | null) {
    for (const b of this.bodies) b.highlight(selection?.kind === 'body' && selection.name === b.body.name, this.colours);
    for (const e of this.elements) e.highlight(selection?.kind === 'element' && selection.name === e.element.name, this.colours);
  }
  /// Colours elements by their values; those without one look as they are.
  colour(values: MountValues | null) {
    for (const e of this.elements) {
      const value = values?.values.get(e.element.name);
      e.paint(value === undefined ? null : colourOf(value, values!));
    }
  }
  dispose() {
    disposeAll(this.root);
    this.ghosts.dispose();
  }

  private follow(object: Object3D, body: SceneBody, at: Vector, selection: Picked) {
    const rest = new Vector3(...at);
    object.position.copy(rest);
    object.traverse(part => (part.userData = selection));
    this.followers.push({object, body, at, rest});
    this.root.add(object);
  }
  private measure() {
    for (const {object} of [...this.bodies, ...this.elements]) this.bounds.expandByObject(object);
    for (const {rest} of this.followers) this.bounds.expandByPoint(rest);
    if (this.bounds.isEmpty()) this.bounds.expandByPoint(new Vector3());
  }
}
const lowestAlong = ({min, max}: Box3, up: Vector3) => [0, 1, 2].reduce((sum, k) => {
  const u = up.getComponent(k);
  return sum + u * (u > 0 ? min : max).getComponent(k);
}, 0);
