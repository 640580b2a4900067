// SPDX-License-Identifier: BSD-3-Clause
// Numbers in the units that the page shows. Everything else on the page is in SI.
import {digitsOf, suitedMultiple, type Multiple} from './shown_number.ts';

const TURN = 2 * Math.PI;

/// Units of the frequency axis: factor from rad/s.
export const FREQUENCY_UNITS = {Hz: 1 / TURN, rpm: 60 / TURN, 'rad/s': 1} as const;
export type FrequencyUnit = keyof typeof FREQUENCY_UNITS;

/// A number with significant digits, without zeros at its end.
export function number(value: number | null | undefined, digits = 4): string {
  if (value === null || value === undefined || Number.isNaN(value)) return '–';
  if (!Number.isFinite(value)) return value > 0 ? '∞' : '−∞';
  return digitsOf(value, digits).replace('-', '−');
}

/// Prefixes of a unit of which engineers use multiples; others are shown as they are.
const PREFIXES: readonly Multiple[] = [[1e-9, 'n'], [1e-6, 'µ'], [1e-3, 'm'], [1, ''], [1e3, 'k'], [1e6, 'M']];
const WITHOUT_LARGE = new Set(['m', 'm/s', 'm/s^2', 'm/s2', 'm/s²', 'rad', 'rad/s', 'rad/s^2', 's']);
/// [m/s] Standards of machines state velocities in mm/s; the program has the same rule (foundation/unit_prefix).
const LEAST_IN_MILLIMETRES_PER_SECOND = 1e-4;
const PREFIXED = /^(m|N|rad|W|J|Pa|s)\b/;

const QUANTITIES: Record<string, string> = {m: 'displacement', rad: 'rotation', 'm/s': 'velocity', 'rad/s': 'angular velocity', 'm/s^2': 'acceleration', 'm/s2': 'acceleration', 'm/s²': 'acceleration',
                                            'rad/s^2': 'angular acceleration', 'rad/s2': 'angular acceleration', 'rad/s²': 'angular acceleration', N: 'force', 'N m': 'moment'};
/// What is measured in a unit, in a word; the unit itself if it has none.
export const quantityName = (unit: string) => QUANTITIES[unit] ?? unit;

export interface Scale {
  factor: number;
  unit: string;
}
/// The multiple of an SI unit that suits the largest value: {1000, "mm"}.
export function scaleOf(largest: number, unit: string): Scale {
  const shown = unit.replace('^2', '²').replace('s2', 's²');
  if (!PREFIXED.test(unit) || !(largest > 0)) return {factor: 1, unit: shown};
  const [suited, itsPrefix] = suitedMultiple(largest, WITHOUT_LARGE.has(unit) ? PREFIXES.filter(([one]) => one <= 1) : PREFIXES);
  const isInMillimetres = unit === 'm/s' && suited === 1e-6 && largest >= LEAST_IN_MILLIMETRES_PER_SECOND * (1 - 1e-9);
  const [size, prefix] = isInMillimetres ? [1e-3, 'm'] as const : [suited, itsPrefix] as const;
  return {factor: 1 / size, unit: prefix + shown};
}
/// The same for amplitudes: times the share of the level at which the program shows them, "mm/s rms".
export function scaleAtLevel(largest: number, unit: string, {level, level_factor: share = 1}: {level?: string | null; level_factor?: number} = {}): Scale {
  const scale = scaleOf(largest * share, unit);
  return {factor: scale.factor * share, unit: level ? `${scale.unit} ${level}` : scale.unit};
}
/// What a harmonic quantity has at a level over its amplitude: for numbers of the program that have a level without its `level_factor`.
/// Without a level they are amplitudes.
export const shareAtLevel = (level: string | null | undefined) => (level ? SHARES[level]! : 1);
const SHARES: Record<string, number> = {'0-p': 1, 'p-p': 2, rms: Math.SQRT1_2};

export function withUnit(value: number | null | undefined, unit: string, digits = 4): string {
  if (value === null || value === undefined || !Number.isFinite(value)) return number(value);
  const scale = scaleOf(Math.abs(value), unit);
  return `${number(value * scale.factor, digits)} ${scale.unit}`.trim();
}
export const frequency = (omega: number | null, unit: FrequencyUnit, digits = 4) =>
  omega === null ? '–' : `${number(omega * FREQUENCY_UNITS[unit], digits)} ${unit}`;

/// A number of the project file: "1.6 kN/mm" has a value and a unit, 4200 only a value. Null: it is not one.
export function quantity(text: string): {value: number; unit: string} | null {
  const match = text.trim().match(/^"?\s*([-+−]?(?:\d[\d_]*\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*([^"]*?)\s*"?$/);
  if (!match) return null;
  const value = Number(match[1]!.replaceAll('_', '').replace('−', '-'));
  return Number.isFinite(value) ? {value, unit: match[2]!} : null;
}
/// In the form of the project file, with as many digits as a hand would write.
export const written = (value: number, unit: string) => {
  const text = String(Number(value.toPrecision(6)));
  return unit ? `"${text} ${unit}"` : text;
};
