// SPDX-License-Identifier: BSD-3-Clause
// Types of the results that the page draws: JSON of the commands scene, curves, modes, roots, shapes, check and verdict.
// All numbers are in SI.

export type Vector = readonly [number, number, number];
export type Complex = readonly [number, number];

export interface Problem {
  severity: 'error' | 'warning';
  line?: number;
  column?: number;
  subject?: string;
  where?: string;
  finding?: string;
  message: string;
  rule?: string;
  remedy?: string;
}

export interface End {
  body: string;  // "ground": not on a body
  at: Vector;
}
export interface SceneBody {
  name: string;
  pole: Vector;
  centre_of_mass: Vector;
  axes: readonly [Vector, Vector, Vector];  // x, y and z axis of the body in the frame of the project
  mass: number;
  box?: {centre: Vector; axes: readonly [Vector, Vector, Vector]; size: Vector} | null;
  solids?: readonly Solid[];
}
export interface Solid {
  shape?: string;
  vertices?: readonly number[];
  triangles?: readonly number[];
}
export interface SceneElement {
  name: string;
  type: string;
  from: End;
  to: End;
  axis?: Vector;
  kind: string;
  size?: readonly (number | null)[];  // length, diameter
  coil?: {wire: number; mean_diameter: number; turns: number};
}
export interface Scene {
  title: string;
  size: number;
  gravity: Vector | null;
  bodies: SceneBody[];
  elements: SceneElement[];
  stops: {name: string; at: Vector; direction: Vector; gap: number}[];
  foundations: {name: string; points?: Vector[]}[];
  points: {name: string; body: string; at: Vector}[];
  forces: {name: string; body: string; at: Vector; direction: Vector; kind: string}[];
}

export interface Mode {
  number: number;
  angular_frequency: number;
  shape: number[];
  kinetic_energy_share: number[];
  strain_energy_share: number[];
  name: string;
}
export interface Modes {
  bodies: string[];
  elements: string[];
  modes: Mode[];
}
export interface Root {
  eigenvalue: Complex;
  kind: string;
  angular_frequency: number;
  damping_ratio: number;
  shape: Complex[];
  nearest_mode: number | null;
}
export interface Roots {
  bodies: string[];
  roots: Root[];
}
export interface Shapes {
  shapes: {angular_frequency: number; places: {name: string; motion: Complex[]}[]}[];
}

/// One barycentric rational function for all results, in bands.
export interface Piece {
  band: readonly [number, number];
  nodes: readonly number[];
  weights: readonly number[];  // re, im, re, im …
  values: readonly (readonly number[])[];  // of each delay and result
}
export interface CurveModel {
  excitation?: string;
  pieces: readonly Piece[];
  delays: readonly number[];
  undefined_at: readonly number[];
}
export interface Peak {
  result: string;
  angular_frequency: number;
  amplitude: number | null;
  phase?: number | null;
}
export interface Curves {
  band: readonly [number, number];
  results: {name: string; unit: string; kind?: string}[];
  models: CurveModel[];
  peaks: Peak[];
  natural: number[];
  limits: {result: string; limit: number}[];
}

export interface Requirement {
  kind: string;
  subject: string;
  requirement: string;
  unit: string;
  allowed: number | null;
  value: number | null;
  margin: number | null;
  judged: boolean;
  met: boolean;
  reason: string;
  detail: string;
}
export interface Verdict {
  met: boolean;
  cases: {case: string; met: boolean; decides: boolean; governing: number | null; requirements: Requirement[]}[];
}
export interface Check {
  mounts?: {case: string; element: string; compression: number; across: number; deflection: number}[];
}
