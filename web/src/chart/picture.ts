// SPDX-License-Identifier: BSD-3-Clause
import type {Display} from '../display.ts';
import {FREQUENCY_UNITS, number, quantity, scaleAtLevel, type Scale} from '../quantities.ts';
import type {Curves, SampledBand, Steady} from '../results.ts';
import type {ShownLimit} from './limit_handles.ts';
import type {Limit} from './limits.ts';
import {drawnFrequencies, sampledCurves} from '../sampled_curves.ts';
import {bandOverlays, measuredOverlays, steadyOverlays, type Compared, type Overlay} from './overlays.ts';
import type {Picture, Shown} from './plot.ts';
import {steadyCurves} from './steady_readings.ts';
import {strokeOf} from './strokes.ts';

/// What the user chose to see of the curves.
export interface Choice {
  model: number;
  unit: string;
  hidden: ReadonlySet<string>;
}
const POINTS = 420;

export const unitsOf = ({results, vanishing = []}: Curves) =>
  [...new Set(results.filter(r => !vanishing.includes(r.name)).map(r => r.unit))];

/// Curves of one unit in the units of the page.
/// @param binding  limits are, in the case on the page
export function pictureOf(curves: Curves, choice: Choice, display: Display, steady: Steady | null = null, compared: readonly Compared[] = [], binding = true, bands: readonly SampledBand[] = []): Picture {
  const frequency = FREQUENCY_UNITS[display.frequencyUnit];
  const indices = curves.results.map((_, i) => i).filter(i => curves.results[i]!.unit === choice.unit && !curves.vanishing?.includes(curves.results[i]!.name));
  const seen = indices.filter(i => !choice.hidden.has(curves.results[i]!.name));
  const omega = drawnFrequencies(curves, POINTS, display.logarithmicFrequency, seen), sampled = sampledCurves(curves, choice.model, omega, seen);
  const largest = seen.reduce((top, i) => sampled.amplitude[i]!.reduce<number>((t, a) => Math.max(t, a ?? 0), top), 0);
  const of = curves.results[indices[0] ?? -1], scale = display.decibel ? {factor: of?.level_factor ?? 1, unit: `${choice.unit} ${of?.level ?? ''}`.trim()} : scaleAtLevel(largest, choice.unit, of);
  const names = indices.map(i => curves.results[i]!.name);
  const shownValue = (v: number | null) => shownAmplitude(v, scale, display);
  const shown = seen.map((i): Shown => {
    const {name} = curves.results[i]!;
    const peaks = curves.peaks.filter(p => p.result === name);
    return {name, stroke: indices.indexOf(i), amplitude: sampled.amplitude[i]!.map(shownValue), phase: sampled.phase[i]!,
            unbounded: peaks.filter(p => p.unbounded).map(p => p.angular_frequency * frequency),
            peaks: peaks.filter(p => p.amplitude !== null && p.amplitude > 1e-4 * largest).map(p => ({x: p.angular_frequency * frequency, y: shownValue(p.amplitude)!}))};
  });
  const shownBands = bandOverlays(bands, choice.unit, names, frequency, shownValue).filter(o => !choice.hidden.has(o.name));
  const overlays: Overlay[] = steady ? steadyOverlays(steady, choice.unit, names, frequency, shownValue).filter(o => !choice.hidden.has(o.name)) : [];
  const steadyOfCurves = steadyCurves(steady, choice.unit, names.filter(name => !choice.hidden.has(name)), frequency, shownValue);
  for (const line of curves.lines ?? []) {
    const stroke = names.indexOf(line.result);
    if (stroke < 0 || line.unit !== choice.unit || choice.hidden.has(line.result)) continue;
    const amplitude = sampled.amplitude[curves.results.findIndex(r => r.name === line.result)] ?? [];
    for (const [from, to] of line.exceeded ?? [])
      overlays.push({name: line.result, stroke, kind: binding ? 'violated' : 'unbinding', points: omega.flatMap((w, k) => (w >= from && w <= to ? [[w * frequency, shownValue(amplitude[k] ?? null)] as const] : []))});
  }
  for (const one of compared) {
    if (one.curves) overlays.push(...comparedOverlays(one.curves, one, choice, display, names, shownValue));
    if (one.measured) overlays.push(...measuredOverlays(one.measured, one.key, choice.unit, names, frequency, shownValue).filter(o => !choice.hidden.has(o.name)));
  }
  return {overlays: [...shownBands, ...overlays], limits: [], steady: steadyOfCurves, x: omega.map(w => w * frequency), curves: shown, natural: curves.natural.map(w => w * frequency), scale,
          cursor: display.cursor === null ? null : display.cursor * frequency};
}

/// An amplitude on the axis; null where the axis cannot show it.
export function shownAmplitude(value: number | null, {factor}: Scale, {decibel, logarithmicAmplitude}: Display): number | null {
  if (value === null || !(value > 0 || !decibel && !logarithmicAmplitude)) return null;
  return decibel ? 20 * Math.log10(value * factor) : value * factor;
}
/// The SI value of a place on the axis.
export const amplitudeAt = (shown: number, {factor}: Scale, {decibel}: Display) => (decibel ? 10 ** (shown / 20) : shown) / factor;

/// A limit of the file as it is on the page.
export interface PresentLimit {
  limit: Limit;
  allowed: number;  // SI, of the present number
  written: string;  // "4.5 mm/s rms", as in the file
  movable: boolean;
  old: boolean;  // its margin is not that of the present numbers yet
  binding: boolean;  // the case on the page decides
}
/// Limits of the curves that are seen.
export function shownLimits(all: readonly PresentLimit[], names: readonly string[], hidden: ReadonlySet<string>, scale: Scale, display: Display): ShownLimit[] {
  const frequency = FREQUENCY_UNITS[display.frequencyUnit];
  return all.flatMap(({limit: {requirement: r, result, from, to, isOfCurve}, allowed, written, movable, old, binding}, i): ShownLimit[] => {
    const stroke = names.indexOf(result), y = shownAmplitude(allowed, scale, display);
    if (stroke < 0 || hidden.has(result) || y === null) return [];
    const value = !isOfCurve && r.value !== null ? shownAmplitude(r.value, scale, display) : null, violated = r.judged && !r.met, steady = r.kind === 'steady';
    const margin = !r.judged ? 'not judged' : r.margin === null ? 'nothing limits it' : `margin ${number(r.margin, 3)}${violated && !binding ? ', not binding' : ''}`;
    const label = (amplitude: string) => `${steady ? 'steady ' : ''}≤ ${amplitude} · ${margin}${old ? ' …' : ''}`;
    return [{id: `${i} ${r.place.join('.')}`, result, from: from * frequency, to: to * frequency, y, label: label(atLevelOf(written, y, scale, display)), short: label(shortOf(written, r.level ?? '', y, scale, display)), violated, binding, movable, ...strokeOf(stroke, display.theme),
             words: `${r.shown_requirement ?? r.requirement}: ${margin}${violated ? ', violated' : ''}${steady ? '; square: the largest deviation of the steady motions from rest' : ''}`, isOfCurve,
             at: value !== null ? {x: (steady ? r.angular_frequency ?? from : (from + to) / 2) * frequency, y: value} : null}];
  });
}

/// "110 µm p-p = 55 µm 0-p": the number of the file, and that on the axis if it has another level or unit.
function atLevelOf(written: string, y: number, {unit}: Scale, {decibel}: Display): string {
  const onAxis = `${number(y)} ${unit}`;
  return decibel || written === onAxis ? written : onAxis.startsWith(`${written} `) ? onAxis : `${written} = ${onAxis}`;
}

/// The number of the file, without what the axis says.
function shortOf(written: string, level: string, y: number, {unit}: Scale, {decibel}: Display): string {
  const file = quantity(written);
  if (decibel) return written;
  if (!file?.unit) return number(y);  // a bare number is in SI
  const whole = /(0-p|rms|p-p)$/.test(file.unit) || !level ? file.unit : `${file.unit} ${level}`;
  return number(file.value) + (whole === unit ? '' : ` ${whole}`);
}

/// Curves of another machine, or as they were when the user kept them.
function comparedOverlays(other: Curves, {key: of, dash}: Compared, choice: Choice, display: Display, names: readonly string[], shownValue: (v: number | null) => number | null): Overlay[] {
  const omega = drawnFrequencies(other, POINTS, display.logarithmicFrequency);
  const wanted = other.results.map((_, i) => i).filter(i => other.results[i]!.unit === choice.unit && names.includes(other.results[i]!.name) && !choice.hidden.has(other.results[i]!.name));
  const sampled = sampledCurves(other, choice.model, omega, wanted);
  return wanted.map((i): Overlay => {
    const {name} = other.results[i]!;
    return {name, stroke: names.indexOf(name), kind: 'compared', of, dash, points: omega.map((w, k) => [w * FREQUENCY_UNITS[display.frequencyUnit], shownValue(sampled.amplitude[i]![k]!)])};
  });
}
