// SPDX-License-Identifier: BSD-3-Clause
import {Box3, Matrix4, Raycaster, Vector2, Vector3, type Intersection, type Mesh, type Object3D, type PerspectiveCamera} from 'three';
import type {Selection} from '../state.ts';

/// @param words  what is under the pointer, if that is not the selected part as a whole
export type Picked = Selection & {words?: string};

const RINGS = [3, 6, 9];  // px around the pointer within which a small part is meant
const DIRECTIONS = 12;

/// The part that is drawn nearest to the pointer. A mark or a small part comes before a large one: bodies are translucent, so what is
/// seen through one can be selected. The inside of an element counts, too: one sees a coil, not its gaps.
/// @param at    on the canvas, from −1 to 1
/// @param size  of the canvas [px]
export function partAt(root: Object3D, camera: PerspectiveCamera, at: Vector2, size: Vector2): Picked | null {
  root.updateMatrixWorld();
  const ray = new Raycaster(), selectable: Object3D[] = [];
  const sightTo = camera.position.distanceTo(new Vector3().setFromMatrixPosition(root.matrixWorld)), pixel = 2 * sightTo * Math.tan(camera.fov * Math.PI / 360) / size.y;
  ray.params.Line.threshold = RINGS[0]! * pixel;
  root.traverseVisible(part => { if (part.userData['kind'] && !(part as {isLineSegments?: boolean}).isLineSegments) selectable.push(part); });
  const isMark = (part: Object3D) => (part as {isSprite?: boolean}).isSprite === true, isLarge = (part: Object3D) => part.userData['kind'] === 'body' && radiusOf(part) > RINGS[2]! * pixel;
  const aimed = (right: number, up: number) => ray.setFromCamera(new Vector2(at.x + 2 * right / size.x, at.y + 2 * up / size.y), camera);
  const first = (parts: Object3D[]): Intersection | undefined => ray.intersectObjects(parts, false)[0];
  const selection = (part: Object3D | undefined) => (part ? part.userData as Picked : null);

  aimed(0, 0);
  const marks = selectable.filter(isMark), small = selectable.filter(part => !isMark(part) && !isLarge(part)), large = selectable.filter(isLarge);
  const isLine = (part: Object3D) => (part as {isLine?: boolean}).isLine === true, shapes = small.filter(part => !isLine(part));
  const direct = first(marks) ?? first(shapes) ?? first(small.filter(isLine));  // a line hides nothing
  if (direct) return selection(direct.object);
  for (const radius of RINGS) {
    const hits: Intersection[] = [];
    for (let i = 0; i < DIRECTIONS; i++) {
      const angle = 2 * Math.PI * i / DIRECTIONS;
      aimed(radius * Math.cos(angle), radius * Math.sin(angle));
      const hit = first(shapes) ?? first(marks.filter(mark => mark.userData['kind'] !== 'body'));
      if (hit) hits.push(hit);
    }
    const nearest = hits.sort((a, b) => a.distance - b.distance)[0];
    if (nearest) return selection(nearest.object);
  }
  aimed(0, 0);
  const around = root.children.filter(part => part.visible && part.userData['kind'] === 'element').map(part => ({part, distance: distanceToBox(part, ray)}));
  const within = around.filter(({distance}) => distance < Infinity).sort((a, b) => a.distance - b.distance)[0];
  if (within) return selection(within.part);
  const bodies = ray.intersectObjects(large, false).sort((a, b) => radiusOf(a.object) - radiusOf(b.object) || a.distance - b.distance);
  return selection(bodies[0]?.object);
}

function radiusOf(part: Object3D): number {
  const {geometry} = part as Mesh;
  if (!geometry) return 0;
  if (!geometry.boundingSphere) geometry.computeBoundingSphere();
  return geometry.boundingSphere!.radius;
}
/// Along the ray to the box around all that is drawn of an element, along its axes; infinite if the ray passes it.
function distanceToBox(part: Object3D, {ray}: Raycaster): number {
  const box = new Box3(), toPart = new Matrix4().copy(part.matrixWorld).invert();
  part.traverseVisible(one => {
    const {geometry} = one as Mesh;
    if (!geometry) return;
    if (!geometry.boundingBox) geometry.computeBoundingBox();
    box.union(geometry.boundingBox!.clone().applyMatrix4(new Matrix4().multiplyMatrices(toPart, one.matrixWorld)));
  });
  const hit = ray.clone().applyMatrix4(toPart).intersectBox(box, new Vector3());
  return hit ? hit.applyMatrix4(part.matrixWorld).distanceTo(ray.origin) : Infinity;
}
