// SPDX-License-Identifier: BSD-3-Clause
// Designs as lines over parallel axes, and which of them are inside selected ranges. Places on an axis are shares of its
// length: 0 at its left end, 1 at its right one.
import {digitsOf} from '../shown_number.ts';

/// An axis of src/trivet/report/figures/design_lines_figure.cpp.
export interface Scale {
  name: string;
  unit: string;
  from: number;
  to: number;
  end: number;  // the share at which the scale ends; infinite values are at 1
  logarithmic: boolean;
}
export interface DrawnDesign {
  shares: readonly number[];  // on the axes in their order; fewer if it has no value on the last ones
  met: boolean;
  further: boolean;           // beside the first designs, which are a sample
}
export type Range = readonly [from: number, to: number];

export const ROUNDING = 1e-4;  // of the places, which have hundredths of a pixel
const DIGITS = 4;

export function valueAt(scale: Scale, share: number): number {
  const {from, to, end, logarithmic} = scale, part = share / end;
  if (part > 1 + ROUNDING) return Infinity;
  const within = Math.min(Math.max(part, 0), 1);
  return logarithmic ? from * (to / from) ** within : from + (to - from) * within;
}
export function valueWords(scale: Scale, share: number): string {
  const value = valueAt(scale, share);
  return value === Infinity ? '∞' : digitsOf(value, DIGITS) + (scale.unit ? ` ${scale.unit}` : '');
}
/// "mass: 100 kg … 104 kg"
export const rangeWords = (scale: Scale, [from, to]: Range) =>
  `${scale.name}: ${valueWords(scale, from)} … ${valueWords(scale, to)}`;

/// Is the design inside all ranges? One without a value on an axis with a range is not.
export const isInside = ({shares}: DrawnDesign, ranges: ReadonlyMap<number, Range>) =>
  [...ranges].every(([axis, [from, to]]) => {
    const share = shares[axis];
    return share !== undefined && share >= from - ROUNDING && share <= to + ROUNDING;
  });

const designsOf = (count: number, kind = '') => `${count} ${kind}design${count === 1 ? '' : 's'}`;
/// "37 of 400 designs selected, 31 meet all requirements; 4 of 100 later designs, 0 meet them"
export function countWords(designs: readonly DrawnDesign[], ranges: ReadonlyMap<number, Range>): string {
  const first = designs.filter(({further}) => !further), later = designs.filter(({further}) => further);
  const met = (list: readonly DrawnDesign[]) => list.filter(one => one.met).length;
  const meet = (count: number) => `${count} meet${count === 1 ? 's' : ''}`;
  if (ranges.size === 0)
    return `${designsOf(first.length)}, ${meet(met(first))} all requirements` +
      (later.length ? `; ${designsOf(later.length, 'later ')}, ${meet(met(later))} them` : '');
  const inside = first.filter(one => isInside(one, ranges)), further = later.filter(one => isInside(one, ranges));
  return `${inside.length} of ${designsOf(first.length)} selected, ${meet(met(inside))} all requirements` +
    (later.length ? `; ${further.length} of ${designsOf(later.length, 'later ')}, ${meet(met(further))} them` : '');
}

/// A range after one of its ends is moved: the ends do not pass each other.
export function movedEnd([from, to]: Range, end: 0 | 1, share: number): Range {
  const within = Math.min(Math.max(share, 0), 1);
  return end === 0 ? [Math.min(within, to), to] : [from, Math.max(within, from)];
}
export const isWhole = ([from, to]: Range) => from <= 0 && to >= 1;
