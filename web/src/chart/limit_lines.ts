// SPDX-License-Identifier: BSD-3-Clause
// Limits over frequency in the chart: the line, and a handle on it that the mouse and the keyboard move.
import type {Display} from '../display.ts';
import {FREQUENCY_UNITS, number, shareAtLevel, type Scale} from '../quantities.ts';
import type {LimitLine} from '../results.ts';
import type {ShownLimit} from './limit_handles.ts';
import type {Overlay} from './overlays.ts';
import {strokeOf} from './strokes.ts';

/// A limit over frequency as it is on the page.
export interface PresentLine {
  id: string;
  line: LimitLine;
  factor: number;  // of its present levels over those of `line`
  movable: boolean;
  old: boolean;  // its margin is not that of the present numbers yet
  binding: boolean;
}
type Point = readonly [number, number | null];

/// Lines of the curves that are seen. @param shownValue  of an amplitude  @param band  of the axis of frequencies, in its unit
export function shownLines(all: readonly PresentLine[], names: readonly string[], hidden: ReadonlySet<string>, unit: string, scale: Scale, display: Display,
                           shownValue: (amplitude: number) => number | null, band: readonly [number, number]): {overlays: Overlay[]; handles: ShownLimit[]} {
  const overlays: Overlay[] = [], handles: ShownLimit[] = [], frequency = FREQUENCY_UNITS[display.frequencyUnit];
  for (const {id, line, factor, movable, old, binding} of all) {
    const stroke = names.indexOf(line.result), share = shareAtLevel(line.rms ? 'rms' : '0-p');
    if (stroke < 0 || line.unit !== unit || hidden.has(line.result)) continue;
    const points = line.angular_frequency.map((w, k): Point => [w * frequency, shownValue(factor * line.limit[k]! / share)]), place = placeOf(points, band, display);
    overlays.push({name: line.result, stroke, kind: 'limit', points});
    if (!place) continue;
    const violated = (line.exceeded ?? []).length > 0, margin = `margin ${number(line.least_margin ?? Infinity, 3)}${violated && !binding ? ', not binding' : ''}${old ? ' …' : ''}`;
    const why = movable ? 'moving it moves all its levels by one factor' : 'its levels are not in this file: it cannot be moved here';
    handles.push({id, result: line.result, ...place, label: `${line.name} ≤ ${number(place.y)} ${scale.unit} · ${margin}`, short: `≤ ${number(place.y)} · ${margin}`,
                  words: `${line.result} within "${line.name}": ${margin}${violated ? ', violated' : ''}; ${why}`, violated, binding, movable, isOfCurve: false, isLine: true, at: null,
                  ...strokeOf(stroke, display.theme)});
  }
  return {overlays, handles};
}

/// Where a line is seized: its longest horizontal part, or the middle of its longest part, on the screen. Null: it is outside.
function placeOf(points: readonly Point[], [low, high]: readonly [number, number], {logarithmicFrequency, logarithmicAmplitude, decibel}: Display): {from: number; to: number; y: number} | null {
  const [along, back] = axis(logarithmicFrequency), [up, down] = axis(logarithmicAmplitude && !decibel);
  const parts = points.slice(1).flatMap(([x2, y2], i) => {
    const [x1, y1] = points[i]!, a = Math.max(along(x1), along(low)), b = Math.min(along(x2), along(high));
    if (y1 === null || y2 === null || !(b > a)) return [];
    if (y1 === y2) return [{length: b - a, from: x1, to: x2, y: y1}];
    const middle = (a + b) / 2, part = (middle - along(x1)) / (along(x2) - along(x1)), at = back(middle);
    return [{length: b - a, from: at, to: at, y: down(up(y1) + part * (up(y2) - up(y1)))}];
  });
  const [longest] = parts.sort((a, b) => b.length - a.length);
  return longest ? {from: longest.from, to: longest.to, y: longest.y} : null;
}
const axis = (logarithmic: boolean): readonly [(v: number) => number, (v: number) => number] => (logarithmic ? [Math.log, Math.exp] : [v => v, v => v]);
