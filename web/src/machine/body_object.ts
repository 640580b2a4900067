// SPDX-License-Identifier: BSD-3-Clause
import {BoxGeometry, BufferAttribute, BufferGeometry, EdgesGeometry, Group, LineBasicMaterial, LineSegments, Matrix4, Mesh,
        MeshLambertMaterial, SphereGeometry, type Material, type Object3D, type Vector3} from 'three';
import {valuesAt, type RigidMotion} from '../motion.ts';
import type {SceneBody, Vector} from '../results.ts';
import type {Colours} from './colours.ts';

/// A body: the meshes of its solids, or the box of equal inertia. It moves by small displacements, as the theory says:
/// a point at r from the pole moves by t + θ × r, so that mounts stay at their places however large it is drawn.
export class BodyObject {
  readonly object = new Group();
  readonly atRest = new Group();  // its edges, where it is at rest
  readonly rest: Matrix4;
  private readonly materials: MeshLambertMaterial[] = [];

  /// @param arms  lines to its places outside it, in the frame of the project
  constructor(readonly body: SceneBody, size: number, colours: Colours, arms: readonly (readonly [Vector3, Vector3])[] = []) {
    this.object.matrixAutoUpdate = this.atRest.matrixAutoUpdate = false;
    if (body.solids.length) for (const solid of body.solids) this.add(meshOf(solid.vertices, solid.triangles, body.pole), colours, 0.75);
    else if (body.box) this.add(boxOf(body), colours, 0.55);
    else if (body.node) this.add(new SphereGeometry(0.006 * size, 12, 8), colours);
    if (arms.length) {
      const ends = new BufferGeometry().setFromPoints(arms.flat()).translate(...body.pole.map(v => -v) as [number, number, number]);
      this.object.add(new LineSegments(ends, new LineBasicMaterial({color: colours.rest})));
    }
    this.rest = rigidMatrix(body.pole, null, 0, 0);
    this.atRest.matrix.copy(this.rest);
    this.move(null, 0, 0);
    this.object.traverse(part => (part.userData = {kind: 'body', name: body.name}));
  }
  move(motion: RigidMotion | null, phase: number, scale: number) {
    this.object.matrix.copy(rigidMatrix(this.body.pole, motion, phase, scale));
    this.object.matrixWorldNeedsUpdate = true;
  }
  highlight(on: boolean, colours: Colours) {
    for (const material of this.materials) material.emissive.setHex(on ? colours.selected : 0).multiplyScalar(on ? 0.55 : 1);
  }
  dispose() {
    disposeAll(this.object);
    disposeAll(this.atRest);
  }

  private add(geometry: BufferGeometry, colours: Colours, opacity = 1) {
    const material = new MeshLambertMaterial({color: colours.body, transparent: opacity < 1, opacity, depthWrite: opacity === 1,
                                              polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1});
    const edges = new EdgesGeometry(geometry, 25);
    this.materials.push(material);
    this.object.add(new Mesh(geometry, material), new LineSegments(edges, new LineBasicMaterial({color: colours.edge})));
    this.atRest.add(new LineSegments(edges, new LineBasicMaterial({color: colours.rest, transparent: true, opacity: 0.45})));
  }
}

/// Position of a body in a phase [rad] of a motion that is drawn `scale` times as large.
export function rigidMatrix(pole: Vector, motion: RigidMotion | null, phase: number, scale: number): Matrix4 {
  const [x, y, z, a, b, c] = (motion ? valuesAt(motion, phase).map(v => v * scale) : [0, 0, 0, 0, 0, 0]) as
      [number, number, number, number, number, number];
  return new Matrix4().set(1, -c, b, pole[0] + x, c, 1, -a, pole[1] + y, -b, a, 1, pole[2] + z, 0, 0, 0, 1);
}
export function disposeAll(object: Object3D) {
  object.traverse(part => {
    const {geometry, material} = part as Partial<Mesh>;
    geometry?.dispose();
    for (const one of [material].flat()) {
      (one as MeshLambertMaterial | undefined)?.map?.dispose();
      (one as Material | undefined)?.dispose();
    }
  });
}

function boxOf({box, pole}: SceneBody): BufferGeometry {
  const geometry = new BoxGeometry(...box!.size), [x, y, z] = box!.axes, at = box!.centre.map((v, k) => v - pole[k]!);
  geometry.applyMatrix4(new Matrix4().set(x[0], y[0], z[0], at[0]!, x[1], y[1], z[1], at[1]!, x[2], y[2], z[2], at[2]!, 0, 0, 0, 1));
  return geometry;
}
function meshOf(vertices: readonly number[], triangles: readonly number[], pole: Vector): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(Float32Array.from(vertices, (v, i) => v - pole[i % 3]!), 3));
  geometry.setIndex([...triangles]);
  const flat = geometry.toNonIndexed();  // facets of a solid are flat
  geometry.dispose();
  flat.computeVertexNormals();
  return flat;
}
