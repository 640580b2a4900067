// SPDX-License-Identifier: BSD-3-Clause
// Types of the results that the page draws: JSON of the commands scene, curves, modes, roots, shapes, check and verdict.
// All numbers are in SI.

export type Vector = readonly [number, number, number];
export type Complex = readonly [number, number];

export interface Problem {
  severity: 'error' | 'warning';
  file?: string;  // of a setting: "--set PATH = VALUE"
  line?: number;
  column?: number;
  subject?: string;
  where?: string;
  finding?: string;
  message: string;
  rule?: string;
  remedy?: string;
}

/// Exactly one of body, foundation and ground is given.
export interface End {
  body?: string;
  foundation?: string;
  ground?: boolean;
  at: Vector;
}
export type Frame = readonly [Vector, Vector, Vector];  // its three unit vectors
export interface Box {
  centre: Vector;
  axes: Frame;
  size: Vector;
}
export interface SceneBody {
  name: string;
  node: boolean;
  mass: number;
  drawn_as: string;
  pole: Vector;
  centre_of_mass: Vector;
  axes: Frame;
  dofs: readonly number[];  // places of its coordinates in shapes over all bodies
  box: Box | null;
  solids: readonly {vertices: readonly number[]; triangles: readonly number[]}[];
}
export interface Coil {
  wire: readonly [number, number];  // radial, axial
  mean_diameter: number;
  turns: number;
  dead_turns: readonly [number, number];
  left_handed: boolean;
  start_angle: number;  // [rad] from e1
}
export interface Rubber {
  diameter?: number;
  hole_diameter?: number;
  widths?: readonly [number, number];
  layers?: readonly {thickness: number; metal: boolean}[];  // from N to K
  inner_diameter?: number;  // of a bush
  outer_diameter?: number;
  length?: number;
}
export interface SceneElement {
  name: string;
  type: string;
  kind: string;
  stiffness_key?: string | null;  // of the number that scales its stiffness
  from: End;
  to: End;
  axes: Frame;
  size: readonly [number, number | null];  // length, largest diameter or width
  coil?: Coil;
  rubber?: Rubber;
  section?: {outer_diameter?: number; inner_diameter?: number; widths?: readonly [number, number]};
}
export interface SceneForce {
  name: string;
  type: string;
  kind: string;
  body: string | null;
  at: Vector;
  direction: Vector;
}
export interface Scene {
  title: string;
  size: number;
  gravity: Vector | null;
  bodies: SceneBody[];
  elements: SceneElement[];
  stops: {name: string; kind: string; at: Vector; direction: Vector; gap: number; unit: string}[];
  foundations: {name: string; at: Vector}[];
  points: {name: string; body: string; at: Vector}[];
  clearances: {name: string; from: End; to: End; direction: Vector; gap: number}[];
  forces: SceneForce[];
}

export interface Mode {
  number: number;
  angular_frequency: number;
  shape: number[] | null;  // null here and below: not asked for
  kinetic_energy_share: number[] | null;
  body_kinetic_energy_share: number[];
  strain_energy_share: number[] | null;
  screws?: {direction: Vector; point: Vector | null; pitch: number | null; rotation: number}[] | null;  // of each body, along its axes, from its pole
  name: string;
  feet?: number[][] | null;  // motion of these ends, along the axes of the project
}
export interface Modes {
  bodies: string[];
  feet?: string[];  // ends on flexible foundations
  elements: string[];
  modes: Mode[];
  kinetic_energy_share_words?: string;  // what the shares of single coordinates are, and why they may be above 1 or below 0
}
export interface Root {
  eigenvalue: Complex;
  kind: string;
  angular_frequency: number;
  damping_ratio: number;
  shape: Complex[];
  nearest_mode: number | null;
  feet?: Complex[][];  // as in Mode
}
export interface Roots {
  bodies: string[];
  feet?: string[];
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
  excitations?: readonly string[];
  pieces: readonly Piece[];
  delays: readonly number[];
  undefined_at: readonly number[];
}
export interface Peak {
  result: string;
  angular_frequency: number;
  amplitude: number | null;
  phase?: number | null;
  unbounded?: boolean;  // an undamped natural frequency
}
export interface Curves {
  band: readonly [number, number];
  results: {name: string; unit: string; kind?: string; level?: string | null; level_factor?: number; extrema?: readonly (readonly [number, number])[]}[];
  vanishing?: string[];  // results that are round-off
  models: CurveModel[];
  peaks: Peak[];
  natural: number[];
  limits: {result: string; limit: number}[];
  lines?: LimitLine[];
  draft?: boolean;  // the models alone, without exact peaks
}
/// A limit over frequency; `rms`: of rms values, not amplitudes.
export interface LimitLine {
  name: string;
  result: string;
  unit: string;
  rms: boolean;
  angular_frequency: number[];
  limit: number[];
  least_margin?: number | null;
  exceeded?: readonly (readonly [number, number])[];  // bands of ω
}

interface SteadyPoint {
  angular_frequency: number;
  stable: boolean | null;  // null: uncertain
  results: {largest: number; smallest: number}[];
}
interface Branch {
  points: SteadyPoint[];
  folds: {point: SteadyPoint; lands: SteadyPoint | null}[];
}
/// One of the motions at a frequency: all its harmonics from the mean on, of bodies and of ends that move.
export interface SteadyMotion {
  curve: number;
  periods: number;
  stable: boolean | null;
  places: {name: string; harmonics: Complex[][]}[];
}
export interface Steady extends Branch {
  over: string;
  at?: {angular_frequency: number; motions: SteadyMotion[]}[];
  results: {name: string; unit: string}[];
  further?: Branch[];
}
export interface Requirement {
  kind: string;
  subject: string;
  requirement: string;
  shown_requirement?: string;  // as the table of the program has it, at its levels
  shown_value?: string;
  unit: string;
  level?: string | null;  // of `allowed` and `value`: "0-p", "rms", "p-p"
  allowed: number | null;
  value: number | null;
  margin: number | null;
  judged: boolean;
  met: boolean;
  reason: string;
  detail: string;
  angular_frequency: number | null;  // at which the value occurs
  band: readonly [number, number | null] | null;  // ω in which the curve is judged
  speed: readonly [number, number] | null;  // of the machine at which it is judged
  excitations: readonly string[];  // empty: all
  order: number | null;  // of a shaft that alone drives it
  place: readonly string[];  // keys that lead to its number in the file; empty: it has none
}
export interface Verdict {
  met: boolean;
  least_margin: {case: string; requirement: number; margin: number} | null;  // in the cases that decide; null: nothing limits the design
  cases: {case: string; met: boolean; decides: boolean; governing: number | null; requirements: Requirement[];
          elements: {element: string; governing: number; share: number | null}[]}[];  // share of a limit; null: infinite
}
/// Amplitudes of the designs within the tolerances, at each frequency for itself. Null: infinite.
export interface SampledBand {
  result: string;
  unit: string;
  angular_frequency: number[];
  low: (number | null)[];  // 5 % of the designs are below it
  median: (number | null)[];
  high: (number | null)[];  // 95 %
}
/// Designs within the tolerances, judged in all cases in which the design has to hold.
export interface Sample {
  designs: number;
  confidence: number;
  yield: {shown_share: string; shown_interval: string};
  wanted?: number;  // with a wanted yield
  held?: boolean | null;  // null: these designs do not decide
  failed: number;
  cases: {case: string; no_kernels: string}[];
  bands?: {case: string; results: SampledBand[]}[];
}
export interface Check {
  mounts?: {case: string; element: string; compression: number; across: number; deflection: number; utilisation: number | null}[];
}

export interface MapAxis {
  parameter: string;  // a path, or a name of [parameters]
  name: string;
  from: number;
  to: number;
  unit: string;
  spacing: 'linear' | 'logarithmic';
  points: number;
}
/// Many designs over two numbers, judged by the program.
export interface DesignMap {
  x: MapAxis;
  y: MapAxis;
  rules: {words: string}[];
  colours: {governing: number | 'none' | 'not computed'; colour: string; words: string}[];  // the key, in its order, with rules at their levels
  designs: number;
  kept: number;
  feasible: {share: number; boundary: (readonly [number, number])[][]};
  best: {x: number; y: number; margin: number | null; governing: number | 'none'; kept: boolean} | null;
  marks: {case: string; x: number | null; y: number | null; of_this_model: boolean; decides: boolean; kept?: boolean; margin?: number | null}[];
  grid: {margin: (number | null)[]; governing: (number | string)[]};  // row after row of y, x fastest
}
export type DesignMaps = DesignMap | {pairs: DesignMap[]};

export interface Measurement {
  name: string;
  excitation: string | null;  // that alone acts; null: those of the response
  channels: {result: string; unit: string; angular_frequency: number[]; measured: Complex[]}[];
}
