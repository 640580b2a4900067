// SPDX-License-Identifier: BSD-3-Clause
import {BoxGeometry, BufferGeometry, Curve, CylinderGeometry, LatheGeometry, Mesh, MeshStandardMaterial, SphereGeometry, TubeGeometry,
        Vector2, Vector3, type Object3D} from 'three';
import type {SceneElement} from '../results.ts';
import type {Colours} from './colours.ts';

/// Parts of an element that stands on z = 0 and ends at z = length, as its kind looks.
export function elementShape(element: SceneElement, length: number, size: number, colours: Colours): Object3D[] {
  const rubber = new MeshStandardMaterial({color: colours.mount, roughness: 0.9}), metal = new MeshStandardMaterial({color: colours.metal});
  const thickest = Math.max(0.5 * length, 0.02 * size);
  const radius = Math.min(Math.max((element.size?.[1] ?? 0) / 2, 0.011 * size), Math.max(thickest, 0.022 * size));
  const plate = Math.min(0.08 * length, 0.006 * size);
  const plates = () => [upright(new CylinderGeometry(1.12 * radius, 1.12 * radius, plate, 24), metal, plate / 2),
                        upright(new CylinderGeometry(1.12 * radius, 1.12 * radius, plate, 24), metal, length - plate / 2)];
  switch (element.kind) {
    case 'coil': return [new Mesh(coilOf(element, length, radius), metal), ...plates()];
    case 'bush': return [upright(new CylinderGeometry(radius, radius, length, 24), rubber, length / 2),
                         upright(new CylinderGeometry(0.4 * radius, 0.4 * radius, 1.15 * length, 16), metal, length / 2)];
    case 'beam': return [upright(new BoxGeometry(0.9 * radius, length, 0.9 * radius), metal, length / 2)];
    case 'strut': return [upright(new CylinderGeometry(0.6 * radius, 0.6 * radius, 0.6 * length, 20), metal, 0.3 * length),
                          upright(new CylinderGeometry(0.3 * radius, 0.3 * radius, length, 16), rubber, 0.5 * length)];
    case 'stop': return [upright(new CylinderGeometry(0.15 * radius, 0.9 * radius, 0.45 * length, 20), rubber, 0.225 * length),
                         upright(new CylinderGeometry(0.9 * radius, 0.9 * radius, 0.1 * length, 20), metal, 0.95 * length)];
    case 'matrix': return [upright(new SphereGeometry(radius, 8, 6), rubber, length / 2),
                           upright(new CylinderGeometry(0.2 * radius, 0.2 * radius, length, 12), metal, length / 2)];
    default: return [new Mesh(waisted(radius, length), rubber), ...plates()];
  }
}

/// Cylinders of three.js are along y; elements are along z.
function upright(geometry: BufferGeometry, material: MeshStandardMaterial, middle: number): Mesh {
  geometry.rotateX(Math.PI / 2).translate(0, 0, middle);
  return new Mesh(geometry, material);
}
function waisted(radius: number, length: number): BufferGeometry {
  const profile = Array.from({length: 13}, (_, i) => {
    const part = i / 12;
    return new Vector2(radius * (1 - 0.22 * Math.sin(Math.PI * part)), length * part);
  });
  return new LatheGeometry(profile, 28).rotateX(Math.PI / 2);
}
class Helix extends Curve<Vector3> {
  constructor(private readonly radius: number, private readonly length: number, private readonly turns: number) { super(); }
  override getPoint(part: number, target = new Vector3()) {
    const angle = 2 * Math.PI * this.turns * part;
    return target.set(this.radius * Math.cos(angle), this.radius * Math.sin(angle), this.length * part);
  }
}
function coilOf({coil}: SceneElement, length: number, radius: number): BufferGeometry {
  const turns = Math.min(coil?.turns ?? 6, 16), mean = coil ? coil.mean_diameter / 2 : 0.85 * radius;
  const wire = coil ? Math.min(coil.wire / 2, 0.4 * length / turns) : Math.min(0.14 * mean, 0.35 * length / turns);
  return new TubeGeometry(new Helix(mean, length, turns), Math.ceil(22 * turns), wire, 7);
}
