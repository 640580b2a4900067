// SPDX-License-Identifier: BSD-3-Clause
// Peaks with their values: where they are, and where the values have room.
import type uPlot from 'uplot';
import {number} from '../quantities.ts';
import {overlap, type Box} from './label_places.ts';
import {largestSteady, type Overlay} from './overlays.ts';
import type {Shown} from './plot.ts';

/// In pixels of the canvas. `y` null: the peak is unbounded, and at the upper edge.
interface PlacedPeak {
  left: number;
  top: number;
  stroke: number;
  text: string;
  middle: number | null;  // of the text; null: it has no room
}
export interface PlacedPeaks {
  peaks: PlacedPeak[];
  taken: Box[];  // by marks and texts
}
interface Peak {
  x: number;
  y: number | null;
  stroke: number;
}
const MOST = 16;
const AROUND = 4, RADIUS = 2.6, ABOVE = 7, HEIGHT = 18;  // px: of a mark, its text, and both
export const MARK_OF_INFINITY = 16;  // px of the mark of a peak without end below the upper edge of the plot

/// The unbounded peaks, the largest steady motions and the highest peaks, in this order.
function chosen(curves: readonly Shown[], overlays: readonly Overlay[]): Peak[] {
  const unbounded = curves.flatMap(({unbounded, stroke}) => unbounded.map((x): Peak => ({x, y: null, stroke})));
  const ofCurves = curves.flatMap(({peaks, stroke}) => peaks.map(p => ({...p, stroke}))).sort((a, b) => b.y - a.y);
  return [...unbounded, ...[...largestSteady(overlays), ...ofCurves].slice(0, MOST)];
}
/// Each value is above its peak or beside that place, and covers neither another one nor a mark.
export function placedPeaks({ctx: pen, bbox, valToPos}: uPlot, curves: readonly Shown[], overlays: readonly Overlay[]): PlacedPeaks {
  const ratio = devicePixelRatio, around = AROUND * ratio, taken: Box[] = [], end = bbox.left + bbox.width;
  const peaks = chosen(curves, overlays).map(({x, y, stroke}): PlacedPeak => (
    {left: valToPos(x, 'x', true), top: y === null ? bbox.top + MARK_OF_INFINITY * ratio : valToPos(y, 'y', true), stroke, text: y === null ? '∞' : number(y, 3), middle: null}))
    .filter(({left, top}) => left >= bbox.left && left <= end && top >= bbox.top && top <= bbox.top + bbox.height);
  for (const {left, top} of peaks) taken.push([left - around, top - around, left + around, top + around]);
  pen.font = fontOf(ratio);
  for (const peak of peaks) {
    const {left, top} = peak, half = pen.measureText(peak.text).width / 2;
    for (const wished of [left, left + half + around, left - half - around]) {
      const middle = Math.min(Math.max(wished, bbox.left + half), end - half), box: Box = [middle - half - 3, top - HEIGHT * ratio, middle + half + 3, top - around];
      if (taken.some(other => overlap(other, box))) continue;
      taken.push(box);
      peak.middle = middle;
      break;
    }
  }
  return {peaks, taken};
}
export function drawPeaks(pen: CanvasRenderingContext2D, {peaks}: PlacedPeaks, colourOf: (stroke: number) => string, {text, back}: {text: string; back: string}) {
  const ratio = devicePixelRatio;
  for (const {left, top, stroke} of peaks) {
    pen.fillStyle = colourOf(stroke);
    pen.beginPath();
    pen.arc(left, top, RADIUS * ratio, 0, 7);
    pen.fill();
  }
  [pen.textAlign, pen.fillStyle, pen.strokeStyle, pen.lineWidth, pen.lineJoin] = ['center', text, back, 3 * ratio, 'round'];
  for (const {middle, top, text: words} of peaks) {
    if (middle === null) continue;
    pen.font = fontOf(ratio, words === '∞' ? 16 : 11);
    pen.strokeText(words, middle, top - ABOVE * ratio);  // a curve or a line behind it ends beside it
    pen.fillText(words, middle, top - ABOVE * ratio);
  }
}
const fontOf = (ratio: number, size = 11) => `${size * ratio}px system-ui, sans-serif`;
