// SPDX-License-Identifier: BSD-3-Clause
import {BoxGeometry, BufferGeometry, CylinderGeometry, LatheGeometry, Mesh, MeshLambertMaterial, TorusGeometry, TubeGeometry, Vector2,
        type Object3D} from 'three';
import type {SceneElement} from '../results.ts';
import type {Colours} from './colours.ts';
import {Helix} from './helix.ts';

interface Look {
  length: number;
  radius: number;  // of an element whose law has no dimensions: by the size of the machine
  rubber: MeshLambertMaterial;
  metal: MeshLambertMaterial;
}
type Shape = (element: SceneElement, look: Look) => Object3D[];

/// Parts of an element that stands on z = 0 and ends at z = length, in its axes e1, e2, e3.
export function elementShape(element: SceneElement, length: number, size: number, colours: Colours): Object3D[] {
  const rubber = new MeshLambertMaterial({color: colours.mount}), metal = new MeshLambertMaterial({color: colours.metal});
  const known = element.size[1], radius = known ? known / 2 : Math.min(Math.max(0.45 * length, 0.015 * size), 0.025 * size);
  return (SHAPES[element.kind] ?? mount)(element, {length, radius, rubber, metal});
}

const mount: Shape = (_, look) => [new Mesh(turned([[1, 0], [0.86, 0.25], [0.78, 0.5], [0.86, 0.75], [1, 1]], look), look.rubber), ...plates(look)];
const SHAPES: Record<string, Shape> = {
  coil: ({coil}, look) => {
    const helix = new Helix(coil ?? {mean_diameter: 1.7 * look.radius, turns: 6, dead_turns: [0, 0], left_handed: false, start_angle: 0}, look.length);
    const wire = coil ? Math.min(coil.wire[0], coil.wire[1]) / 2 : 0.12 * look.radius;
    return [new Mesh(new TubeGeometry(helix, Math.ceil(24 * helix.turns), wire, 8), look.metal)];
  },
  rubber: ({rubber}, look) => {
    const layers = rubber?.layers ?? [{thickness: 1, metal: false}], total = layers.reduce((sum, l) => sum + l.thickness, 0);
    let bottom = 0;
    return layers.map(({thickness, metal}) => {
      const height = look.length * thickness / total, middle = bottom + height / 2;
      bottom += height;
      const [x, y] = rubber?.widths ?? [], shape = x && y ? new BoxGeometry(x, y, height).translate(0, 0, middle)
                                                         : cylinder((rubber?.diameter ?? 2 * look.radius) / 2, height, middle);
      return new Mesh(shape, metal ? look.metal : look.rubber);
    });
  },
  bush: ({rubber}, {length, radius, rubber: soft, metal}) => {
    const outer = (rubber?.outer_diameter ?? 2 * radius) / 2, inner = (rubber?.inner_diameter ?? radius) / 2;
    return [new Mesh(cylinder(outer, 0.9 * length, length / 2), soft), new Mesh(cylinder(inner, 1.15 * length, length / 2), metal)];
  },
  beam: ({section}, {length, radius, metal}) => {
    const [x, y] = section?.widths ?? [];
    return [new Mesh(x && y ? new BoxGeometry(x, y, length).translate(0, 0, length / 2) : cylinder((section?.outer_diameter ?? radius) / 2, length, length / 2), metal)];
  },
  rod: (_, {length, radius, metal}) => [new Mesh(cylinder(0.3 * radius, length, length / 2), metal)],
  damper: (_, {length, radius, rubber, metal}) => [new Mesh(cylinder(0.62 * radius, 0.55 * length, 0.3 * length), metal), new Mesh(cylinder(0.24 * radius, length, 0.5 * length), rubber)],
  strut: (element, look) => [...SHAPES['coil']!(element, look), ...SHAPES['damper']!(element, look)],
  stop: (_, look) => [new Mesh(turned([[0.95, 0], [0.8, 0.3], [0.25, 0.62]], look), look.rubber), new Mesh(cylinder(look.radius, 0.1 * look.length, 0.95 * look.length), look.metal)],
  air_spring: (_, look) => [new Mesh(turned([[0.8, 0], [1.15, 0.25], [0.85, 0.5], [1.15, 0.75], [0.8, 1]], look), look.rubber), ...plates(look)],
  wire_rope: (_, look) => [...[-0.5, 0, 0.5].map(place => {
    const loop = new TorusGeometry(0.45 * look.length, 0.07 * look.length, 8, 24).rotateY(Math.PI / 2);
    return new Mesh(loop.translate(place * look.radius, 0, look.length / 2), look.metal);
  }), ...plates(look)],
};

/// Cylinders of three.js are along y; elements are along z.
const cylinder = (radius: number, height: number, middle: number): BufferGeometry =>
  new CylinderGeometry(radius, radius, height, 32).rotateX(Math.PI / 2).translate(0, 0, middle);
const plates = ({radius, length, metal}: Look) => [0.03, 0.97].map(part => new Mesh(cylinder(1.12 * radius, 0.06 * length, part * length), metal));
/// A solid of revolution through points (share of the radius, share of the length), smoothed.
function turned(profile: [number, number][], {radius, length}: Look): BufferGeometry {
  const points = Array.from({length: 17}, (_, i) => {
    const [from, to] = [profile[0]![1], profile.at(-1)![1]], z = from + (to - from) * i / 16;
    const next = Math.max(1, profile.findIndex(p => p[1] >= z - 1e-9)), [r0, z0] = profile[next - 1]!, [r1, z1] = profile[next]!;
    const part = (1 - Math.cos(Math.PI * (z - z0) / (z1 - z0))) / 2;
    return new Vector2(radius * (r0 + (r1 - r0) * part), length * z);
  });
  return new LatheGeometry(points, 32).rotateX(Math.PI / 2);
}
