// SPDX-License-Identifier: BSD-3-Clause
import {LineBasicMaterial, MeshBasicMaterial, MultiplyOperation, NoBlending, NormalBlending, type Material, type Mesh, type Object3D} from 'three';

/// Lets surfaces have one shader program, and lines and flat marks another, whether they are opaque or not: without a graphics
/// processor a program takes longer to compile than a picture to draw. three.js makes further ones for opaque materials, which it
/// draws without blending anyway, and for normals and
/// reflections, which flat ones do not have.
export function sharePrograms(drawn: Object3D) {
  drawn.traverse(part => {
    const {geometry, material} = part as Partial<Mesh>;
    for (const one of [material ?? []].flat() as Material[]) {
      if (!one.transparent && one.blending === NormalBlending) one.blending = NoBlending;
      if (one instanceof MeshBasicMaterial || one instanceof LineBasicMaterial) {
        geometry?.deleteAttribute('normal');
        Object.assign(one, {combine: MultiplyOperation});  // with reflections
      }
    }
  });
}
