// SPDX-License-Identifier: BSD-3-Clause
import type uPlot from 'uplot';
import {LABEL_HEIGHT, labelPlaces, type Box, type Labelled, type LabelPlace} from './label_places.ts';

/// A limit in the units of the chart.
export interface ShownLimit {
  id: string;
  result: string;
  from: number;  // on the axis of frequencies
  to: number;
  y: number;
  label: string;  // "≤ 4.5 mm/s rms · margin 0.87"
  short: string;  // the same without what the axis says: "≤ 4.5 · margin 0.87"
  words: string;  // the same as a sentence
  colour: string;
  dash: readonly number[];  // of the curve
  violated: boolean;
  binding: boolean;  // in the case on the page
  movable: boolean;
  isOfCurve: boolean;
  isLine?: boolean;  // over frequency: here is only the place where it is seized
  at: {x: number; y: number} | null;  // the judged value, where no curve shows it
}
/// What the user does with limits.
export interface LimitMoves {
  began(): void;
  moved(id: string, y: number): void;
  dropped(id: string): void;
  stepped(id: string, factor: number): void;
}
const HALF = 5;  // px around the line that can be seized
const CHIP = 7;  // px of the dashes beside a label: two of them are seen
const FEW = 3;  // limits, whose labels may be long
const ROWS = 4;  // of short labels above and below a line, if many limits are close together
const STEPS: Record<string, number> = {ArrowUp: 1.01, ArrowDown: 1 / 1.01, PageUp: 1.1, PageDown: 1 / 1.1};

/// The limits of a chart as sliders: lines that the mouse and the keyboard move, with their margins.
export class LimitHandles {
  private readonly layer = document.createElement('div');
  private readonly handles = new Map<string, HTMLElement>();
  private readonly sizes = new Map<string, number>();  // of labels, by their form
  private before = new Map<string, number>();  // places of the labels at the last drawing
  private plot: uPlot | null = null;

  constructor(parent: HTMLElement, private readonly moves: LimitMoves) {
    this.layer.className = 'limits';
    parent.append(this.layer);
  }
  /// Puts the handles onto their lines. Each label is near its line; if they have no room there, all are short and may be farther away;
  /// one without any room is seen when its line is pointed at or has the focus.
  /// @param isOnCurve  is a curve in this part of the plot [px]?  @param peaks  boxes of peaks and their values [px of the plot], which stay free
  place(plot: uPlot, limits: readonly ShownLimit[], isOnCurve: (box: Box) => boolean, peaks: readonly Box[]) {
    this.plot = plot;
    const known = new Set(limits.map(l => l.id)), {left, top, width, height} = boxOf(plot);
    for (const [id, handle] of this.handles) if (!known.has(id)) {
      handle.remove();
      this.handles.delete(id);
    }
    Object.assign(this.layer.style, {left: `${left}px`, top: `${top}px`, width: `${width}px`, height: `${height}px`});
    const lines = [...limits].sort((a, b) => a.y - b.y).flatMap(limit => {
      const handle = this.handles.get(limit.id) ?? this.made(limit.id), line = this.put(handle, limit);
      return line ? [{limit, handle, ...line}] : [];
    });
    const labelled = (words: 'label' | 'short') => lines.map(({limit, handle, ...line}): Labelled =>
      ({...line, size: this.sizeOf(handle, limit[words], limit.violated), before: this.before.get(`${limit.id} ${words}`)}));
    let words: 'label' | 'short' = 'label', labels = labelled(words), places = labelPlaces(labels, {width, height}, isOnCurve, lines.length > FEW ? 1 : 2, peaks);
    if (places.includes(null)) {
      labels = labelled(words = 'short');
      places = labelPlaces(labels, {width, height}, isOnCurve, ROWS, peaks);
    }
    this.before = new Map(lines.flatMap(({limit}, i) => (places[i] ? [[`${limit.id} ${words}`, places[i].number]] : [])));
    lines.forEach(({limit, handle}, i) => this.label(handle, limit[words], labels[i]!, places[i]!));
  }
  /// @returns the line in pixels of the plot; null: it is outside
  private put(handle: HTMLElement, limit: ShownLimit) {
    const plot = this.plot!, {width, height} = boxOf(plot), x = (value: number) => Math.min(Math.max(plot.valToPos(value, 'x'), 0), width);
    const left = x(limit.from), right = Number.isFinite(limit.to) ? x(limit.to) : width, top = plot.valToPos(limit.y, 'y');
    const seen = plot.valToPos(limit.from, 'x') <= width && !(plot.valToPos(limit.to, 'x') < 0), outside = !(seen && top >= 0 && top <= height);
    handle.hidden = outside;
    if (outside) return null;
    handle.classList.toggle('violated', limit.violated && limit.binding);
    handle.classList.toggle('unbinding', limit.violated && !limit.binding);
    handle.classList.toggle('fixed', !limit.movable);
    const attributes = {'aria-label': `Limit of ${limit.result}`, 'aria-valuenow': String(limit.y), 'aria-valuetext': limit.words, 'aria-orientation': 'vertical', 'aria-disabled': String(!limit.movable), title: limit.words};
    for (const [name, value] of Object.entries(attributes)) handle.setAttribute(name, value);
    Object.assign(handle.style, {left: `${left}px`, width: `${Math.max(right - left, 2 * HALF)}px`, top: `${top - HALF}px`, height: `${2 * HALF}px`});
    const {dash: [on = 1, off = 0]} = limit, share = Math.min(CHIP / (on + off), 1);
    for (const [name, value] of Object.entries({'--stroke': limit.colour, '--on': `${share * on}px`, '--period': `${share * (on + off)}px`})) handle.style.setProperty(name, value);
    return {left, right, top};
  }
  private label(handle: HTMLElement, words: string, {left, right, top, size}: Labelled, place: LabelPlace | null) {
    const label = handle.firstElementChild as HTMLElement;
    if (label.textContent !== words) label.textContent = words;
    label.classList.toggle('unseen', !place);
    const [x, y] = place?.box ?? [Math.max(left, right - size), Math.max(top - LABEL_HEIGHT, 0)];
    Object.assign(label.style, {left: `${x - left}px`, top: `${y - top + HALF}px`});
  }
  /// Width of a label [px]. Its digits are equally wide, so it is measured only when its form changes: to measure it at each step of a slider
  /// would lay out the whole page each time.
  private sizeOf(handle: HTMLElement, words: string, violated: boolean): number {
    const form = `${violated} ${words.replace(/\d/g, '0')}`, known = this.sizes.get(form);
    if (known !== undefined) return known;
    const label = handle.firstElementChild as HTMLElement;
    label.textContent = words;
    label.classList.remove('unseen');
    const size = label.offsetWidth;
    if (size > 0) this.sizes.set(form, size);
    return size;
  }
  private made(id: string): HTMLElement {
    const handle = document.createElement('div'), label = document.createElement('span');
    handle.className = 'limit';
    handle.tabIndex = 0;
    handle.setAttribute('role', 'slider');
    handle.append(label);
    const isFixed = () => handle.classList.contains('fixed');
    handle.addEventListener('pointerdown', event => {
      if (isFixed() || event.button !== 0) return;
      const from = event.clientY, start = this.plot!.valToPos(Number(handle.getAttribute('aria-valuenow')), 'y');
      const move = (moved: PointerEvent) => this.moves.moved(id, this.plot!.posToVal(Math.min(Math.max(start + moved.clientY - from, 0), this.plot!.over.clientHeight), 'y'));
      handle.setPointerCapture(event.pointerId);
      handle.addEventListener('pointermove', move);
      handle.addEventListener('lostpointercapture', () => {
        handle.removeEventListener('pointermove', move);
        this.moves.dropped(id);
      }, {once: true});
      this.moves.began();
      handle.focus();
      event.preventDefault();
    });
    handle.addEventListener('click', event => event.stopPropagation());
    handle.addEventListener('keydown', event => {
      const factor = STEPS[event.key];
      if (!factor || isFixed() || event.ctrlKey || event.metaKey) return;
      this.moves.stepped(id, factor);
      event.preventDefault();
      event.stopPropagation();
    });
    this.layer.append(handle);
    this.handles.set(id, handle);
    return handle;
  }
}
/// The plot in pixels of its parent, without asking the browser for its layout.
function boxOf({bbox}: uPlot) {
  const ratio = devicePixelRatio;
  return {left: bbox.left / ratio, top: bbox.top / ratio, width: bbox.width / ratio, height: bbox.height / ratio};
}
