// SPDX-License-Identifier: BSD-3-Clause
import type uPlot from 'uplot';

/// A limit in the units of the chart.
export interface ShownLimit {
  id: string;
  result: string;
  from: number;  // on the axis of frequencies
  to: number;
  y: number;
  label: string;  // "≤ 4.5 mm/s · margin 0.87"
  words: string;  // the same as a sentence
  colour: string;
  violated: boolean;
  binding: boolean;  // in the case on the page
  movable: boolean;
  isOfCurve: boolean;
  at: {x: number; y: number} | null;  // the judged value, where no curve shows it
}
/// What the user does with limits.
export interface LimitMoves {
  began(): void;
  moved(id: string, y: number): void;
  dropped(id: string): void;
  stepped(id: string, factor: number): void;
}
export type Box = [number, number, number, number];

const HALF = 5;  // px around the line that can be seized
const HEIGHT = 15;  // px of a label
const STEPS: Record<string, number> = {ArrowUp: 1.01, ArrowDown: 1 / 1.01, PageUp: 1.1, PageDown: 1 / 1.1};

/// The limits of a chart as sliders: lines that the mouse and the keyboard move, with their margins.
export class LimitHandles {
  private readonly layer = document.createElement('div');
  private readonly handles = new Map<string, HTMLElement>();
  private readonly sizes = new WeakMap<HTMLElement, {form: string; size: number}>();
  private plot: uPlot | null = null;

  constructor(parent: HTMLElement, private readonly moves: LimitMoves) {
    this.layer.className = 'limits';
    parent.append(this.layer);
  }
  /// Puts the handles onto their lines. @returns places of the labels in pixels of the plot
  place(plot: uPlot, limits: readonly ShownLimit[]): Box[] {
    this.plot = plot;
    const known = new Set(limits.map(l => l.id)), {left, top, width, height} = boxOf(plot);
    for (const [id, handle] of this.handles) if (!known.has(id)) {
      handle.remove();
      this.handles.delete(id);
    }
    Object.assign(this.layer.style, {left: `${left}px`, top: `${top}px`, width: `${width}px`, height: `${height}px`});
    const boxes: Box[] = [];
    for (const limit of [...limits].sort((a, b) => a.y - b.y)) {
      const handle = this.handles.get(limit.id) ?? this.made(limit.id), box = this.put(handle, limit, boxes);
      if (box) boxes.push(box);
    }
    return boxes;
  }
  private put(handle: HTMLElement, limit: ShownLimit, taken: readonly Box[]): Box | null {
    const plot = this.plot!, {width, height} = boxOf(plot), x = (value: number) => Math.min(Math.max(plot.valToPos(value, 'x'), 0), width);
    const left = x(limit.from), right = Number.isFinite(limit.to) ? x(limit.to) : width, top = plot.valToPos(limit.y, 'y'), label = handle.firstElementChild as HTMLElement;
    const seen = plot.valToPos(limit.from, 'x') <= width && !(plot.valToPos(limit.to, 'x') < 0), outside = !(seen && top >= 0 && top <= height);
    handle.hidden = outside;
    if (outside) return null;
    if (label.textContent !== limit.label) label.textContent = limit.label;
    handle.classList.toggle('violated', limit.violated && limit.binding);
    handle.classList.toggle('unbinding', limit.violated && !limit.binding);
    handle.classList.toggle('fixed', !limit.movable);
    const attributes = {'aria-label': `Limit of ${limit.result}`, 'aria-valuenow': String(limit.y), 'aria-valuetext': limit.words, 'aria-orientation': 'vertical', 'aria-disabled': String(!limit.movable), title: limit.words};
    for (const [name, value] of Object.entries(attributes)) handle.setAttribute(name, value);
    Object.assign(handle.style, {left: `${left}px`, width: `${Math.max(right - left, 2 * HALF)}px`, top: `${top - HALF}px`, height: `${2 * HALF}px`});
    handle.style.setProperty('--stroke', limit.colour);
    const size = this.sizeOf(label, limit), end = labelEnd(left, right, size, width);
    const places = [0, 1, 2, 3].flatMap(k => [top - (k + 1) * HEIGHT, top + k * HEIGHT + 2]).filter(y => y >= -HEIGHT / 2 && y + HEIGHT <= height);
    const free = places.find(y => !taken.some(b => b[0] < end && b[2] > end - size && b[1] < y + HEIGHT && b[3] > y)) ?? places[0] ?? top;
    Object.assign(label.style, {left: `${end - size - left}px`, top: `${free - top + HALF}px`});
    return [end - size, free, end, free + HEIGHT];
  }
  /// Width of a label [px]. Its digits are equally wide, so it is measured only when its form changes: to measure it at each step of a slider
  /// would lay out the whole page each time.
  private sizeOf(label: HTMLElement, {label: text, violated}: ShownLimit): number {
    const form = `${violated} ${text.replace(/\d/g, '0')}`, known = this.sizes.get(label);
    if (known?.form === form) return known.size;
    const size = label.offsetWidth;
    if (size > 0) this.sizes.set(label, {form, size});
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
/// Right end of a label: within its line, or beside a short one.
function labelEnd(left: number, right: number, size: number, width: number): number {
  if (right - left >= size) return right;
  if (right + 4 + size <= width) return right + 4 + size;
  return left - 4 >= size ? left - 4 : Math.max(right, Math.min(size, width));
}
