// SPDX-License-Identifier: BSD-3-Clause
// What is drawn beside bodies and elements: centres of mass, points, axes, stops, clearances, the ground, traces.
import {ArrowHelper, BufferGeometry, CanvasTexture, CircleGeometry, CylinderGeometry, DoubleSide, EdgesGeometry, Float32BufferAttribute, GridHelper, Group, Line,
        LineBasicMaterial, LineSegments, Mesh, MeshBasicMaterial, MeshLambertMaterial, Quaternion, RingGeometry, Sprite, SpriteMaterial, Vector3} from 'three';
import {displacement, highestOrder, type Motion} from '../motion.ts';
import type {Scene, SceneBody, Vector} from '../results.ts';
import type {Colours} from './colours.ts';

export type Up = Vector3;

/// The quartered circle of a centre of mass, a dot for a point, a letter of an axis: always of the same size on screen.
function sprite(draw: (pen: CanvasRenderingContext2D, size: number) => void, height: number): Sprite {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = 64;
  draw(canvas.getContext('2d')!, 64);
  const result = new Sprite(new SpriteMaterial({map: new CanvasTexture(canvas), depthTest: false, sizeAttenuation: false, transparent: true, toneMapped: false}));
  result.scale.setScalar(height);
  result.renderOrder = 10;
  return result;
}
export function centreOfMassMark(colours: Colours): Sprite {
  return sprite((pen, size) => {
    const middle = size / 2, radius = 0.4 * size;
    for (let quarter = 0; quarter < 4; quarter++) {
      pen.beginPath();
      pen.moveTo(middle, middle);
      pen.arc(middle, middle, radius, quarter * Math.PI / 2, (quarter + 1) * Math.PI / 2);
      pen.fillStyle = quarter % 2 ? '#fff' : '#111';
      pen.fill();
    }
    pen.strokeStyle = colours.text;
    pen.lineWidth = 3;
    pen.beginPath();
    pen.arc(middle, middle, radius, 0, 2 * Math.PI);
    pen.stroke();
  }, 0.022);
}
/// A ring with the letter P: the pole of a body, to which its coordinates and screws refer.
export function poleMark(): Sprite {
  return sprite((pen, size) => {
    pen.beginPath();
    pen.arc(size / 2, size / 2, 0.42 * size, 0, 2 * Math.PI);
    pen.fillStyle = '#fff';
    pen.fill();
    pen.strokeStyle = '#111';
    pen.lineWidth = 6;
    pen.stroke();
    pen.font = `700 ${0.6 * size}px system-ui, sans-serif`;
    pen.textAlign = 'center';
    pen.textBaseline = 'middle';
    pen.fillStyle = '#111';
    pen.fillText('P', size / 2, 0.53 * size);
  }, 0.024);
}
/// Poles that no other mark shows: they are neither the centre of mass of their body nor the origin of the project.
export function markedPoles({bodies, size}: Scene): SceneBody[] {
  const apart = (a: Vector, b: Vector) => Math.hypot(...a.map((v, k) => v - b[k]!)) > 1e-6 * size;
  return bodies.filter(b => !b.node && apart(b.pole, b.centre_of_mass) && apart(b.pole, [0, 0, 0]));
}
export function pointMark(colours: Colours): Sprite {
  return sprite((pen, size) => {
    pen.beginPath();
    pen.arc(size / 2, size / 2, 0.3 * size, 0, 2 * Math.PI);
    pen.fillStyle = `#${colours.trace.toString(16).padStart(6, '0')}`;
    pen.fill();
    pen.strokeStyle = '#fff';
    pen.lineWidth = 6;
    pen.stroke();
  }, 0.016);
}
function letter(text: string, colours: Colours): Sprite {
  return sprite((pen, size) => {
    pen.font = `600 ${0.7 * size}px system-ui, sans-serif`;
    pen.textAlign = 'center';
    pen.textBaseline = 'middle';
    pen.fillStyle = colours.text;
    pen.fillText(text, size / 2, size / 2);
  }, 0.03);
}

/// Axes of the project with their letters.
export function axesMark(length: number, colours: Colours): Group {
  const group = new Group();
  ['x', 'y', 'z'].forEach((name, k) => {
    const direction = new Vector3().setComponent(k, 1), tip = letter(name, colours);
    tip.scale.setScalar(0.45 * length);
    group.add(new ArrowHelper(direction, new Vector3(), length, colours.edge, 0.22 * length, 0.1 * length), tip);
    tip.position.copy(direction).multiplyScalar(1.25 * length);
  });
  return group;
}
/// The plate that a stop touches after its gap, or the circle of a ring.
export function stopMark({direction, gap, kind}: Scene['stops'][number], size: number, colours: Colours): Group {
  const group = new Group(), axis = new Vector3(...direction), closed = gap <= 0;
  const material = new MeshBasicMaterial({color: closed ? colours.force : colours.selected, side: DoubleSide, transparent: true, opacity: 0.75});
  const radius = 0.028 * size, shape = kind === 'ring' ? new RingGeometry(radius, 1.15 * radius, 36) : new CircleGeometry(radius, 28);
  const plate = new Mesh(shape, material);
  plate.quaternion.copy(new Quaternion().setFromUnitVectors(new Vector3(0, 0, 1), axis));
  if (kind !== 'ring') plate.position.copy(axis).multiplyScalar(Math.max(gap, 0));
  group.add(plate);
  return group;
}
/// The line across which two places may touch.
export function clearanceMark({from, to}: Scene['clearances'][number], colours: Colours): Line {
  const ends = [new Vector3(...from.at), new Vector3(...to.at)];
  const line = new Line(new BufferGeometry().setFromPoints(ends), new LineBasicMaterial({color: colours.selected, depthTest: false}));
  line.renderOrder = 7;
  return line;
}
/// A piece of a foundation under a mount, normal to `up`, whose top is at the origin.
export function footPlate(size: number, up: Up, colours: Colours): Group {
  const group = new Group(), thickness = 0.012 * size, plate = new CylinderGeometry(0.045 * size, 0.045 * size, thickness, 28).translate(0, -thickness / 2, 0);
  plate.applyQuaternion(new Quaternion().setFromUnitVectors(new Vector3(0, 1, 0), up));
  group.matrixAutoUpdate = false;
  group.add(new Mesh(plate, new MeshLambertMaterial({color: colours.rest})), new LineSegments(new EdgesGeometry(plate, 25), new LineBasicMaterial({color: colours.edge})));
  return group;
}
/// The ground below the machine, normal to `up`.
export function ground(lowest: number, centre: Vector3, size: number, up: Up, colours: Colours): GridHelper {
  const step = 10 ** Math.round(Math.log10(size / 6)), cells = Math.ceil(2.6 * size / step);
  const grid = new GridHelper(cells * step, cells);
  grid.material.dispose();
  grid.material = new LineBasicMaterial({color: colours.grid});
  grid.quaternion.copy(new Quaternion().setFromUnitVectors(new Vector3(0, 1, 0), up));
  grid.position.copy(centre).addScaledVector(up, lowest - centre.dot(up));
  return grid;
}

/// The closed curve of a point over one period of a motion: an ellipse, if it is harmonic.
export function trace(at: Vector, body: SceneBody, motion: Motion, scale: number, colours: Colours): Line {
  const arm = at.map((v, k) => v - body.pole[k]!) as unknown as Vector, rigid = motion.bodies.get(body.name), places: number[] = [];
  const steps = Math.max(72, 16 * highestOrder(motion));
  for (let i = 0; rigid && i <= steps; i++) {
    const u = displacement(rigid, arm, 2 * Math.PI * i / steps);
    places.push(...u.map((v, k) => at[k]! + scale * v));
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new Float32BufferAttribute(places, 3));
  const line = new Line(geometry, new LineBasicMaterial({color: colours.trace, depthTest: false}));
  line.renderOrder = 9;
  return line;
}
