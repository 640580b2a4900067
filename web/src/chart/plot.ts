// SPDX-License-Identifier: BSD-3-Clause
import uPlot from 'uplot';
import type {Display} from '../display.ts';
import {number, type Scale} from '../quantities.ts';
import type {Box} from './label_places.ts';
import {LimitHandles, type LimitMoves, type ShownLimit} from './limit_handles.ts';
import {logarithmicRange, logarithmicTicks} from './logarithmic_axis.ts';
import type {Overlay} from './overlays.ts';
import {partsAbove} from './parts_above.ts';
import {drawPeaks, MARK_OF_INFINITY, placedPeaks, type PlacedPeaks} from './peak_labels.ts';
import type {SteadyCurve} from './steady_readings.ts';
import {chartColours, strokeOf} from './strokes.ts';
import {ThinnedLine} from './thinned_line.ts';

/// One curve on the page: values in the shown unit.
export interface Shown {
  name: string;
  stroke: number;
  amplitude: (number | null)[];
  phase: (number | null)[];
  peaks: {x: number; y: number}[];
  unbounded: number[];  // frequencies of peaks without end
}
export interface Picture {
  x: number[];  // in the shown unit of frequency
  curves: Shown[];
  natural: number[];
  scale: Scale;
  cursor: number | null;
  overlays: Overlay[];
  limits: ShownLimit[];
  steady: SteadyCurve[];
}

const CURVE = 1.6;  // width of its line [px]
const BAND = 0.3;  // opacity

/// uPlot of the amplitudes or of the phases of a picture.
export class Plot {
  private plot: uPlot | null = null;
  private picture: Picture | null = null;
  private made = '';
  private readonly handles: LimitHandles | null;
  peaks: PlacedPeaks | null = null;  // as they are drawn
  private held: [number, number] | null = null;  // the range while a limit is dragged

  /// @param moves  what is done with limits; null: they are not drawn here
  constructor(private readonly parent: HTMLElement, private readonly what: 'amplitude' | 'phase', private readonly display: Display,
              private readonly clicked: (x: number) => void, moves: LimitMoves | null = null) {
    this.handles = moves && new LimitHandles(parent, {
      ...moves,
      began: () => {
        const {min, max} = this.plot!.scales['y']!;
        this.held = [min!, max!];
        moves.began();
      },
      dropped: id => {
        this.held = null;
        moves.dropped(id);
        this.rescale();
      }});
  }

  show(picture: Picture) {
    this.picture = picture;
    const {display, what} = this, {theme, frequencyUnit, logarithmicFrequency, logarithmicAmplitude, decibel} = display;
    const names = picture.curves.map(c => `${c.name} ${c.stroke}`);
    const form = JSON.stringify([theme, frequencyUnit, logarithmicFrequency, logarithmicAmplitude, decibel, names, picture.scale.unit]);
    const data = [picture.x, ...picture.curves.map(c => (what === 'phase' ? c.phase : c.amplitude))] as uPlot.AlignedData;
    if (form === this.made && this.plot) this.plot.setData(data);
    else {
      this.plot?.destroy();
      this.plot = new uPlot(this.options(), data, this.parent);
      this.made = form;
    }
  }
  resize() {
    const {clientWidth: width, clientHeight: height} = this.parent;
    if (width > 0 && height > 0) this.plot?.setSize({width, height});
  }
  /// Draws again what is not a curve, with room for it.
  rescale() { this.plot?.setData(this.plot.data); }
  /// Redraws what follows the cursor.
  redraw() { this.plot?.redraw(false); }
  destroy() { this.plot?.destroy(); }

  private options(): uPlot.Options {
    const {display, what, picture} = this, colours = chartColours(display.theme), isPhase = what === 'phase';
    const logarithmic = !isPhase && display.logarithmicAmplitude && !display.decibel;
    const axis = {stroke: colours.axis, grid: {stroke: colours.grid, width: 1}, ticks: {stroke: colours.grid, width: 1}, font: '11px system-ui, sans-serif',
                  labelFont: '12px system-ui, sans-serif', labelSize: 16};
    const values = (_: uPlot, all: number[]) => all.map(v => (v === null ? '' : number(v, 6)));
    const ticks = {splits: (_: uPlot, _axis: number, from: number, to: number) => logarithmicTicks(from, to).lines, filter: (_: uPlot, all: number[]) => all,
                   values: (plot: uPlot, all: number[], index: number) => {
                     const {min, max} = plot.scales[plot.axes[index]!.scale!]!, {labelled} = logarithmicTicks(min!, max!);
                     return all.map(v => (labelled.includes(v) ? number(v, 6) : ''));
                   }};
    const along = display.logarithmicFrequency ? {distr: 3 as const, range: (_: uPlot, from: number, to: number): [number, number] => [from, to]} : {distr: 1 as const};
    return {
      width: Math.max(this.parent.clientWidth, 50), height: Math.max(this.parent.clientHeight, 50), padding: [isPhase ? 4 : 14, 10, 0, 0],
      legend: {show: false},
      cursor: {y: false, drag: {x: true, y: false}, points: {show: false}, lock: false},
      scales: {x: {time: false, ...along},
               y: isPhase ? {range: [-190, 190]} : {distr: logarithmic ? 3 : 1, range: (_, low, high) => this.range(low, high, logarithmic)}},
      axes: [{...axis, size: isPhase ? 34 : 20, values, ...(display.logarithmicFrequency ? ticks : {}), ...(isPhase ? {label: `frequency [${display.frequencyUnit}]`} : {values: (_, all) => all.map(() => '')})},
             {...axis, size: 46, label: isPhase ? 'phase [°]' : display.decibel ? `dB re 1 ${picture!.scale.unit}` : picture!.scale.unit,
              ...(logarithmic ? ticks : {values}),
              ...(isPhase ? {splits: () => [-180, -90, 0, 90, 180]} : {})}],
      series: [{}, ...picture!.curves.map(curve => {
        const {colour, dash} = strokeOf(curve.stroke, display.theme);
        return {label: curve.name, stroke: colour, dash, width: CURVE, points: {show: false}, spanGaps: false,
                paths: isPhase ? lines(180) : lines(Infinity)} as uPlot.Series;
      })],
      hooks: {drawAxes: [plot => this.bands(plot)],  // behind the curves
              draw: [plot => this.marks(plot)],
              ready: [plot => plot.over.addEventListener('click', event => this.clickedAt(plot, event))]},
    };
  }
  private range(low: number | null, high: number | null, logarithmic: boolean): [number, number] {
    if (this.held) return this.held;
    const {limits, overlays} = this.picture!, heights = overlays.flatMap(o => [...o.points, ...o.upper ?? []].map(p => p[1])).filter(v => v !== null);
    const others = [...limits.map(l => l.y), ...limits.flatMap(l => (l.at ? [l.at.y] : [])), ...heights];
    if (logarithmic) return logarithmicRange([low, high], others);
    const top = others.reduce((a, b) => Math.max(a, b), high ?? 1), bottom = others.reduce((a, b) => Math.min(a, b), low ?? 0);
    return this.display.decibel ? [Math.max(bottom, top - 120) - 3, top + 6] : [0, top * 1.12 || 1];
  }
  private clickedAt(plot: uPlot, event: MouseEvent) {
    const moved = plot.select.width > 2;
    if (!moved) this.clicked(plot.posToVal(event.offsetX, 'x'));
  }
  private bands({ctx, bbox, valToPos}: uPlot) {
    if (this.what !== 'amplitude') return;
    ctx.save();
    ctx.beginPath();
    ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
    ctx.clip();
    ctx.globalAlpha = BAND;
    for (const {kind, stroke: index, points, upper = []} of this.picture!.overlays) {
      if (kind !== 'band') continue;
      ctx.fillStyle = strokeOf(index, this.display.theme).colour;
      ctx.beginPath();
      const bottom = bbox.top + bbox.height;
      points.forEach(([x, y], i) => { ctx[i ? 'lineTo' : 'moveTo'](valToPos(x, 'x', true), y === null ? bottom : valToPos(y, 'y', true)); });
      for (const [x, y] of [...upper].reverse()) ctx.lineTo(valToPos(x, 'x', true), y === null ? bbox.top : valToPos(y, 'y', true));
      ctx.fill();
    }
    ctx.restore();
  }
  /// Natural frequencies, limits, parts above limits, peaks with their values, and the cursor.
  private marks(plot: uPlot) {
    const {ctx, bbox} = plot, picture = this.picture!, colours = chartColours(this.display.theme), ratio = devicePixelRatio;
    const x = (value: number) => plot.valToPos(value, 'x', true), y = (value: number) => plot.valToPos(value, 'y', true);
    const vertical = (value: number, colour: string, width: number, dash: number[]) => {
      if (value < plot.scales['x']!.min! || value > plot.scales['x']!.max!) return;
      stroke(ctx, colour, width * ratio, dash.map(d => d * ratio), [[x(value), bbox.top], [x(value), bbox.top + bbox.height]]);
    };
    ctx.save();
    ctx.beginPath();
    ctx.rect(bbox.left, bbox.top - 14 * ratio, bbox.width, bbox.height + 14 * ratio);
    ctx.clip();
    for (const value of picture.natural) vertical(value, colours.mode, 1, [1, 3]);
    if (this.what === 'amplitude') {
      const placed = (points: Overlay['points']) => points.map(([a, b]) => [x(a), b === null ? null : y(b)] as const);
      for (const overlay of picture.overlays) if (overlay.kind !== 'band') this.overlay(ctx, overlay, placed);
      for (const limit of picture.limits) if (!limit.isLine) this.limit(plot, limit);
      this.upwards(plot, picture);
      const peaks = this.peaks = placedPeaks(plot, picture.curves, picture.overlays);  // before the labels of limits, which find room elsewhere
      this.handles?.place(plot, picture.limits, this.curveFinder(plot), peaks.taken.map(([left, top, right, bottom]): Box =>
        [(left - bbox.left) / ratio, (top - bbox.top) / ratio, (right - bbox.left) / ratio, (bottom - bbox.top) / ratio]));
      drawPeaks(ctx, peaks, index => strokeOf(index, this.display.theme).colour, colours);
    }
    if (picture.cursor !== null) vertical(picture.cursor, colours.text, 1, []);
    ctx.restore();
  }
  /// Is a curve in a part of the plot [px]?
  private curveFinder(plot: uPlot): (box: Box) => boolean {
    const {x, curves, limits} = this.picture!, ratio = devicePixelRatio, {left, top} = plot.bbox;
    if (!limits.length) return () => false;
    const across = x.map(value => plot.valToPos(value, 'x', true) / ratio - left / ratio);
    const up = curves.map(c => c.amplitude.map(value => (value === null ? NaN : (plot.valToPos(value, 'y', true) - top) / ratio)));
    return ([from, above, to, below]) => across.some((at, i) => at >= from && at <= to && up.some(heights => heights[i]! >= above && heights[i]! <= below));
  }
  /// A limit as a dashed line, red where its curve is above it, or of a weaker colour if it is not binding.
  private limit(plot: uPlot, {result, from, to, y: height, isOfCurve, at, violated, binding}: ShownLimit) {
    const {ctx, bbox} = plot, ratio = devicePixelRatio, colours = chartColours(this.display.theme), {x: xs, curves} = this.picture!, above = binding ? colours.violated : colours.unbinding;
    const x = (value: number) => plot.valToPos(value, 'x', true), y = plot.valToPos(height, 'y', true), least = 10 * ratio;
    const ends = [Math.max(x(from), bbox.left), Number.isFinite(to) ? Math.min(x(to), bbox.left + bbox.width) : bbox.left + bbox.width] as const;
    stroke(ctx, violated ? above : colours.limit, 1.6 * ratio, ends[1] - ends[0] > 3 * least ? [8 * ratio, 4 * ratio] : [], [[ends[0], y], [Math.max(ends[1], ends[0] + least), y]]);
    if (at) {
      const [left, top] = [x(at.x), plot.valToPos(at.y, 'y', true)];
      ctx.fillStyle = violated ? above : colours.text;
      ctx.fillRect(left - 3 * ratio, top - 3 * ratio, 6 * ratio, 6 * ratio);
    }
    if (!isOfCurve) return;
    const curve = curves.find(c => c.name === result), inside = xs.map(value => value >= from && value <= to);
    for (const part of curve ? partsAbove(xs, curve.amplitude.map((a, i) => (inside[i] ? a : null)), height) : [])
      this.exceeding(ctx, above, curve!.stroke, part.map(([a, b]) => [x(a), plot.valToPos(b, 'y', true)] as const));
  }
  /// A part of a curve that exceeds a limit: a band of that colour behind it, so that one still sees which curve it is.
  private exceeding(pen: CanvasRenderingContext2D, band: string, index: number, points: readonly (readonly [number, number])[]) {
    const {colour, dash} = strokeOf(index, this.display.theme), ratio = devicePixelRatio;
    stroke(pen, band, 4.6 * ratio, [], points);
    stroke(pen, colour, CURVE * ratio, dash.map(d => d * ratio), points);
  }
  private overlay(pen: CanvasRenderingContext2D, {stroke: index, kind, points, dash}: Overlay, placed: (points: Overlay['points']) => readonly (readonly [number, number | null])[]) {
    const ratio = devicePixelRatio, {colour} = strokeOf(index, this.display.theme), at = placed(points);
    const known = at.filter((p): p is readonly [number, number] => p[1] !== null);
    if (kind === 'violated' || kind === 'unbinding') return this.exceeding(pen, chartColours(this.display.theme)[kind], index, known);
    if (kind === 'measured') return dots(pen, colour, known, 2 * ratio);
    pen.globalAlpha = kind === 'compared' ? 0.7 : 1;
    stroke(pen, colour, (kind === 'stable' ? 2.6 : 1.3) * ratio, (dash ?? {compared: [4, 3], limit: [8, 4], stable: [], unstable: [3, 3], jump: [1, 4], band: []}[kind]).map(d => d * ratio), known);
    if (kind === 'jump' && known.length === 2) arrowHead(pen, colour, known[0]!, known[1]!, 7 * ratio);
    pen.globalAlpha = 1;
  }
  /// A peak without end goes up to the edge.
  private upwards(plot: uPlot, {x: xs, curves}: Picture) {
    const {ctx, bbox} = plot, ratio = devicePixelRatio, edge = bbox.top + MARK_OF_INFINITY * ratio;
    for (const {unbounded, amplitude, stroke: index} of curves)
      for (const at of unbounded) {
        const near = xs.findIndex(x => x >= at), known = [near - 1, near, near + 1].map(i => amplitude[i] ?? null).filter(v => v !== null), left = plot.valToPos(at, 'x', true);
        if (known.length) stroke(ctx, strokeOf(index, this.display.theme).colour, CURVE * ratio, [2 * ratio, 3 * ratio], [[left, plot.valToPos(Math.max(...known), 'y', true)], [left, edge]]);
      }
  }
}

function arrowHead(pen: CanvasRenderingContext2D, colour: string, [x0, y0]: readonly [number, number], [x1, y1]: readonly [number, number], size: number) {
  const angle = Math.atan2(y1 - y0, x1 - x0);
  pen.fillStyle = colour;
  pen.beginPath();
  pen.moveTo(x1, y1);
  for (const side of [-0.4, 0.4]) pen.lineTo(x1 - size * Math.cos(angle + side), y1 - size * Math.sin(angle + side));
  pen.fill();
}
function dots(pen: CanvasRenderingContext2D, colour: string, points: readonly (readonly [number, number])[], size: number) {
  pen.fillStyle = colour;
  for (const [x, y] of points) {
    pen.beginPath();
    pen.arc(x, y, size, 0, 7);
    pen.fill();
  }
}
function stroke(pen: CanvasRenderingContext2D, colour: string, width: number, dash: number[], points: readonly (readonly [number, number])[]) {
  pen.strokeStyle = colour;
  pen.lineWidth = width;
  pen.setLineDash(dash);
  pen.beginPath();
  points.forEach(([x, y], i) => (i ? pen.lineTo(x, y) : pen.moveTo(x, y)));
  pen.stroke();
  pen.setLineDash([]);
}
/// Straight lines between the points, at parts of pixels, so that steep parts are not stairs. A value that changes by more
/// than `jump` begins a new line: a phase that passes ±180° continues at the other edge.
const lines = (jump: number): uPlot.Series.PathBuilder => (plot, series, first, last) => {
  const path = new Path2D(), line = new ThinnedLine(path), x = plot.data[0], y = plot.data[series]!;
  let before: number | null = null;
  for (let i = Math.max(first - 1, 0); i <= Math.min(last + 1, x.length - 1); i++) {
    const value = y[i] ?? null;
    if (before === null || value === null || Math.abs(value - before) > jump) line.end();
    if (value !== null) line.add(plot.valToPos(x[i]!, 'x', true), plot.valToPos(value, 'y', true));
    before = value;
  }
  line.end();
  return {stroke: path, fill: null, clip: null, band: null, gaps: null, flags: 0} as unknown as uPlot.Series.Paths;
};
