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
const ON_LINE = 2;  // from a line to its label below it

export const overlap = (a: Box, b: Box) => a[0] < b[2] && a[2] > b[0] && a[1] < b[3] && a[3] > b[1];

/// Places of all labels, in their order; null: there is no room.
/// @param isOnCurve  would a label there cover a curve? The other lines are avoided, too
/// @param rows  in which a label may be above or below its line; 1: next to it
export function labelPlaces(all: readonly Labelled[], area: {width: number; height: number}, isOnCurve: (box: Box) => boolean, rows: number): (LabelPlace | null)[] {
  const taken: Box[] = [];
  return all.map(line => {
    const near = 2 * columns(line, area.width).length;  // candidates in the first row
    const free = candidates(line, area.width, rows).map((box, number) => ({number, box}))
      .filter(({box}) => box[1] >= -LABEL_HEIGHT / 2 && box[3] <= area.height && !taken.some(other => overlap(box, other)));
    const isOnLine = (box: Box) => all.some(other => other !== line && overlap(box, [other.left, other.top, other.right, other.top + 1]));
    const place = free.find(p => p.number === line.before) ?? free.find(p => p.number < near && !isOnLine(p.box) && !isOnCurve(p.box)) ?? free[0] ?? null;
    if (place) taken.push(place.box);
    return place;
  });
}
/// Above and below the line, from its right end to the left; then in the next rows.
function candidates(line: Labelled, width: number, rows: number): Box[] {
  const ends = columns(line, width), boxes: Box[] = [];
  for (let row = 0; row < rows; row++)
    for (const end of ends)
      for (const top of [line.top - (row + 1) * LABEL_HEIGHT, line.top + row * LABEL_HEIGHT + ON_LINE]) boxes.push([end - line.size, top, end, top + LABEL_HEIGHT]);
  return boxes;
}
/// Right ends of labels along the line, or on both sides of a short one; at least one.
function columns({left, right, size}: Labelled, width: number): number[] {
  if (right - left >= size) return Array.from({length: Math.floor((right - left + GAP) / (size + GAP))}, (_, k) => right - k * (size + GAP));
  const sides = [right + GAP + size, left - GAP].filter(end => end <= width && end >= size);
  return sides.length ? sides : [Math.max(right, Math.min(size, width))];
}
