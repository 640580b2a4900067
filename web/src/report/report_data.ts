// SPDX-License-Identifier: BSD-3-Clause
// The data of the report, and numbers with units. All values in the data are SI and rad/s; amplitudes are converted to the
// units that the report shows.
import type {Complex, CurveModel} from '../results.ts';
import {digitsOf, suitedMultiple, type Multiple} from '../shown_number.ts';
import type {AmplitudeRule} from './amplitude_range.ts';
import type {Sample} from './adaptive_sampling.ts';

export interface Named {
  name: string;
  unit: string;
}
export interface Peak extends Named {
  angular_frequency: number;
  amplitude: number | null;
  unbounded: boolean;
  ratio_to_static: number | null;
  nearest_mode?: number | null;
}
export interface Limit extends Named {
  limit: number;
}
export interface Table {
  angular_frequency: number[];
  results: (Named & {complex: (Complex | null)[]; phase: (number | null)[]})[];
}
/// Rational functions with the exact extrema of their amplitudes, or what a design of a map has in their place.
export interface Model extends CurveModel {
  band: readonly [number, number];
  results: (Named & {extrema: (readonly [number, number])[]; first_phase: number | null})[];
  continuous_phase: boolean;
}
export interface DesignResponse extends Omit<Model, 'pieces' | 'delays'> {
  pieces: {band: readonly [number, number]; nodes: number[]}[];
  at(w: number): Float64Array;
  completed(points: Sample[]): Sample[];
}
export interface Case {
  name: string;
  peaks: Peak[];
  limits: Limit[];
  modes: {angular_frequency: number; number: number; name: string}[];
  vanishing?: Named[];
  response: Table | Model | DesignResponse | null;
}
interface Drawing {
  strokes: {colour: string; dash: number[]}[];
  units: Record<string, {quantity: string; multiples: Multiple[]; factor?: number; round_off?: number}>;
  groups: Group[][];
  design_groups?: Group[][];
  amplitude_rule: AmplitudeRule;
  frequency?: {unit: string; factor: number; label: string};
}
interface Group {
  name: string;
  rows: {label: string; curve: number}[][];
  logarithmic?: boolean[];  // is the axis of amplitudes of each row? Of designs of a map it is not known before they are drawn
}

/// What the program has written into the page. Its parts are those of results.json and of drawing_json.h.
export const read = (id: string): unknown => JSON.parse(document.getElementById(id)!.textContent!);
export const {cases} = read('results') as {cases: Case[]};
export const {strokes, units, groups, frequency, design_groups: designGroups, amplitude_rule: amplitudeRule} = read('drawing') as Drawing;
export const TURN = 2 * Math.PI;

/// Factor from an SI amplitude to the unit that the report shows.
export const factorOf = (unit: string) => units[unit]?.factor ?? 1;
for (const c of cases) {
  for (const p of c.peaks) if (p.amplitude !== null) p.amplitude *= factorOf(p.unit);
  for (const l of c.limits) l.limit *= factorOf(l.unit);
}

export const caseName = (index: number) => cases[index]!.name || 'Base model';

export const smallestOf = (values: readonly number[]) => values.reduce((least, v) => (v < least ? v : least), Infinity);
export const largestOf = (values: readonly (number | null)[]) =>
  values.reduce<number>((most, v) => (Number.isFinite(v) && v! > most ? v! : most), 0);

/// A number with significant digits, without zeros at the end, or with them in readings.
export const number = (value: number, digits: number) => (Number.isFinite(value) ? digitsOf(value, digits) : '–');
export const reading = (value: number, digits: number) => (Number.isFinite(value) ? digitsOf(value, digits, true) : '–');

/// The multiple of a unit that suits the largest value: {factor, unit}, as 1000 and "mm".
export function multiple(largest: number, unit: string) {
  const {multiples, round_off: roundOff = 0} = units[unit]!;
  if (!(largest > 0) || largest < roundOff)  // round-off has no prefix
    return {factor: 1, unit: multiples.find(([size]) => size === 1)?.[1] ?? unit};
  const [size, name] = suitedMultiple(largest, multiples);
  return {factor: 1 / size, unit: name};
}
export function withUnit(value: number, unit: string, digits: number) {
  if (!Number.isFinite(value)) return '∞';
  if (Math.abs(value) < (units[unit]!.round_off ?? 0)) return '0';
  const suited = multiple(Math.abs(value), unit);
  return `${reading(value * suited.factor, digits)} ${suited.unit}`;
}
export const frequencyWords = (omega: number) =>
  (frequency ? `${reading(omega * frequency.factor, 6)} ${frequency.unit}` : `ω = ${reading(omega, 6)} rad/s, f = ${reading(omega / TURN, 6)} Hz`);
