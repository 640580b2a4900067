// SPDX-License-Identifier: BSD-3-Clause
// Where the labels of limits go: next to their lines, never over each other, and beside the curves if there is room.

export type Box = [left: number, top: number, right: number, bottom: number];
/// A horizontal line and the width of its label [px].
export interface Labelled {
  left: number;
  right: number;
  top: number;
  size: number;
  before?: number | undefined;  // the place that it had: it stays there while that is free, so that labels do not jump
}
export interface LabelPlace {
  number: number;  // of the candidate
  box: Box;
}
export const LABEL_HEIGHT = 15;
const GAP = 4;      // between labels side by side, and from the end of a short line
const PARTS = 6;    // of a label, by which further places differ
const ON_LINE = 2;  // from a line to its label below it

const isNear = ({row}: {row: number}) => row <= 1;  // to its line: rather there on a curve than far from it

export const overlap = (a: Box, b: Box) => a[0] < b[2] && a[2] > b[0] && a[1] < b[3] && a[3] > b[1];

/// Places of all labels, in their order; null: there is no room.
/// @param isOnCurve  would a label there cover a curve? The other lines are avoided, too
/// @param kept  what no label covers: peaks and their values
/// @param rows  in which a label may be above or below its line; 1: next to it
export function labelPlaces(all: readonly Labelled[], area: {width: number; height: number}, isOnCurve: (box: Box) => boolean, rows: number, kept: readonly Box[] = []): (LabelPlace | null)[] {
  const taken: Box[] = [...kept];
  return all.map(line => {
    const free = candidates(line, area.width, rows).map((one, number) => ({...one, number}))
      .filter(({box}) => box[1] >= -LABEL_HEIGHT / 2 && box[3] <= area.height && !taken.some(other => overlap(box, other)));
    const isOnLine = (box: Box) => all.some(other => other !== line && overlap(box, [other.left, other.top, other.right, other.top + 1]));
    const clear = free.filter(({box}) => !isOnLine(box) && !isOnCurve(box));
    const place = free.find(p => p.number === line.before) ?? clear.find(p => p.row === 0) ?? clear.find(isNear) ?? free.find(isNear) ?? clear[0] ?? free[0] ?? null;
    if (place) taken.push(place.box);
    return place && {number: place.number, box: place.box};
  });
}
/// Above and below the line, from its right end to the left; then in the next rows. Those that leave most room for others are first.
function candidates(line: Labelled, width: number, rows: number): {box: Box; row: number}[] {
  return [columns(line, width), between(line, width)].flatMap(ends => Array.from({length: rows}, (_, row) => row).flatMap(row => ends.flatMap(end =>
    [line.top - (row + 1) * LABEL_HEIGHT, line.top + row * LABEL_HEIGHT + ON_LINE].map((top): {box: Box; row: number} => ({row, box: [end - line.size, top, end, top + LABEL_HEIGHT]})))));
}
/// Right ends of labels along the line, or on both sides of a short one and over its middle; at least one.
function columns({left, right, size}: Labelled, width: number): number[] {
  if (right - left >= size) return Array.from({length: Math.floor((right - left + GAP) / (size + GAP))}, (_, k) => right - k * (size + GAP));
  const sides = [right + GAP + size, left - GAP].filter(end => end <= width && end >= size);
  return [...sides, Math.max(Math.min((left + right + size) / 2, width), Math.min(size, width))];
}
/// Further ones between peaks: along a long line and half beyond its end, or from the right of a short one to its left.
function between({left, right, size}: Labelled, width: number): number[] {
  const [from, to] = right - left < size ? [right + size, left] : [right + size / 2, left + size];
  const first = Math.min(from, width), last = Math.max(to, size), step = size / PARTS;
  if (first < last) return [];
  return Array.from({length: Math.max(Math.floor((first - last) / step), 0) + 1}, (_, k) => first - k * step);
}
