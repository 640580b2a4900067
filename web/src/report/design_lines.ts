// SPDX-License-Identifier: BSD-3-Clause
// Ranges on the axes of the picture of kept designs, selected by mouse, touch and keys: lines outside them fade. The designs
// are the lines of the picture itself, which is complete without this script.
import {countWords, isInside, isWhole, movedEnd, rangeWords, valueAt, valueWords, type DrawnDesign, type Range, type Scale} from './design_ranges.ts';

const STEP = 0.01, STEP_WITH_SHIFT = 0.1;  // of an axis, by an arrow key
const NEAR_END = 10, LEAST_DRAG = 4;       // [px]
const AROUND = 15;                         // an axis is caught so far above and below [pixels of the picture]
const WHOLE: Range = [0, 1];
const HINT = 'Drag along an axis to select a range of it; ranges of several axes combine. Drag an end or the range to move ' +
  'it, double-click an axis to clear it. Keys: Tab to an end, ← → to move it (with Shift by tens), Escape to clear the axis.';

function html<Tag extends keyof HTMLElementTagNameMap>(tag: Tag, attributes: Record<string, string>, ...children: (Node | string)[]) {
  const node = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
  node.append(...children);
  return node;
}

interface DrawnAxis extends Scale {
  left: number;
  right: number;
  y: number;
}
function axesOf(svg: SVGSVGElement): DrawnAxis[] {
  return [...svg.querySelectorAll<SVGLineElement>('.design-axis')].map(line => {
    const {name, unit, from, to, end, logarithmic} = line.dataset;
    return {name: name!, unit: unit!, from: Number(from), to: Number(to), end: Number(end), logarithmic: logarithmic !== undefined,
            left: line.x1.baseVal.value, right: line.x2.baseVal.value, y: line.y1.baseVal.value};
  });
}
interface Line extends DrawnDesign {
  node: SVGElement;
}
function linesOf(svg: SVGSVGElement, axes: readonly DrawnAxis[]): Line[] {
  return [...svg.querySelectorAll<SVGPolylineElement>('[data-verdict] > polyline')].map(node => {
    const {verdict, further} = node.parentElement!.dataset;
    const shares = [...node.points].filter(({y}, k) => Math.abs(y - axes[k]!.y) < 1).map(({x}, k) => (x - axes[k]!.left) / (axes[k]!.right - axes[k]!.left));
    return {node, shares, met: verdict === 'met', further: further !== undefined};
  });
}

/// One picture with its ranges.
class DesignLines {
  private readonly ranges = new Map<number, Range>();
  private readonly count = html('p', {class: 'design-count', role: 'status'});
  private readonly words = html('p', {class: 'on-screen hint'});
  private readonly clearing = html('button', {type: 'button'}, 'Clear all ranges');
  private readonly places: AxisPlace[];
  private waiting = 0;

  constructor(private readonly svg: SVGSVGElement, private readonly axes: readonly DrawnAxis[], private readonly lines: readonly Line[]) {
    const holder = html('div', {class: 'design-lines'});
    svg.replaceWith(holder);
    this.places = axes.map((axis, k) => new AxisPlace(axis, svg.viewBox.baseVal, range => this.select(k, range)));
    holder.append(svg, ...this.places.map(({node}) => node));
    this.clearing.addEventListener('click', () => {
      this.ranges.clear();
      this.show();
    });
    // Below the picture, which does not move when the words change; the count stays in the window.
    holder.closest('figure')!.append(html('div', {class: 'on-screen design-status'}, this.count, this.clearing), this.words);
    this.show();
  }

  private select(axis: number, range: Range) {
    if (isWhole(range)) this.ranges.delete(axis);
    else this.ranges.set(axis, range);
    this.waiting ||= requestAnimationFrame(() => {
      this.waiting = 0;
      this.show();
    });
  }

  private show() {
    const {ranges} = this;
    this.places.forEach((place, k) => place.show(ranges.get(k) ?? WHOLE));
    for (const line of this.lines) line.node.classList.toggle('outside', !isInside(line, ranges));
    this.svg.classList.toggle('ranged', ranges.size > 0);
    this.count.textContent = countWords(this.lines, ranges);
    const selected = [...ranges].sort(([a], [b]) => a - b).map(([k, range]) => rangeWords(this.axes[k]!, range));
    this.words.textContent = selected.length ? `Selected: ${selected.join('; ')}.` : HINT;
    this.clearing.disabled = ranges.size === 0;
  }
}

/// The range of one axis, over the picture.
class AxisPlace {
  readonly node: HTMLDivElement;
  private readonly band = html('div', {class: 'design-band'});
  private readonly ends: [HTMLDivElement, HTMLDivElement];
  private range = WHOLE;

  constructor(private readonly axis: DrawnAxis, box: DOMRect | SVGRect, private readonly select: (range: Range) => void) {
    const {left, right, y} = axis, percent = (part: number, whole: number) => `${(100 * part) / whole}%`;
    this.ends = [this.end(0, 'from'), this.end(1, 'to')];
    this.node = html('div', {class: 'on-screen design-range', role: 'group', 'aria-label': axis.name}, this.band, ...this.ends);
    Object.assign(this.node.style, {left: percent(left, box.width), width: percent(right - left, box.width),
                                    top: percent(y - AROUND, box.height), height: percent(2 * AROUND, box.height)});
    this.node.addEventListener('pointerdown', event => this.drag(event));
    this.node.addEventListener('dblclick', () => this.set(WHOLE));
  }

  private end(which: 0 | 1, words: string) {
    const node = html('div', {class: 'design-end', role: 'slider', tabindex: '0', 'aria-label': `${this.axis.name}, ${words}`});
    node.addEventListener('keydown', event => {
      const by = event.shiftKey ? STEP_WITH_SHIFT : STEP, at = this.range[which];
      const to = {ArrowLeft: at - by, ArrowDown: at - by, ArrowRight: at + by, ArrowUp: at + by, PageDown: at - STEP_WITH_SHIFT,
                  PageUp: at + STEP_WITH_SHIFT, Home: 0, End: 1}[event.key];
      if (event.key === 'Escape' || event.key === 'Delete') this.set(WHOLE);
      else if (to === undefined) return;
      else this.set(movedEnd(this.range, which, Math.round(to / STEP) * STEP));
      event.preventDefault();
    });
    return node;
  }

  private set(range: Range) {
    this.show(range);
    this.select(range);
  }

  /// A drag moves an end, the range, or begins another range.
  private drag(event: PointerEvent) {
    if (event.button !== 0) return;
    const {left, width} = this.node.getBoundingClientRect(), start = event.clientX, {pointerId} = event;
    const shareOf = (x: number) => Math.min(Math.max((x - left) / width, 0), 1);
    const from = this.range, at = shareOf(start), isNear = (end: number) => Math.abs(end - at) * width <= NEAR_END;
    const caught = !isWhole(from) ? ([0, 1] as const).find(which => isNear(from[which])) : undefined;
    const inside = !isWhole(from) && at > from[0] && at < from[1];
    const ended = new AbortController(), options = {signal: ended.signal};
    let begun = false;
    this.node.setPointerCapture(pointerId);
    this.node.addEventListener('pointermove', moved => {
      if (moved.pointerId !== pointerId) return;
      begun ||= Math.abs(moved.clientX - start) >= LEAST_DRAG;
      if (!begun) return;
      const to = shareOf(moved.clientX);
      if (caught !== undefined) return this.set(movedEnd(from, caught, to));
      if (!inside) return this.set([Math.min(at, to), Math.max(at, to)]);
      const by = Math.min(Math.max(to - at, -from[0]), 1 - from[1]);
      this.set([from[0] + by, from[1] + by]);
    }, options);
    for (const over of ['pointerup', 'pointercancel', 'lostpointercapture'] as const)
      this.node.addEventListener(over, () => {
        ended.abort();
        this.ends[caught ?? 1].focus({preventScroll: true});
      }, options);
  }

  show(range: Range) {
    this.range = range;
    const percent = (share: number) => `${100 * share}%`;
    this.band.hidden = isWhole(range);
    Object.assign(this.band.style, {left: percent(range[0]), width: percent(range[1] - range[0])});
    this.ends.forEach((end, which) => {
      end.style.left = percent(range[which]!);
      const limits = {min: this.axis.from, max: this.axis.to, now: Math.min(valueAt(this.axis, range[which]!), this.axis.to)};
      for (const [name, value] of Object.entries(limits)) end.setAttribute(`aria-value${name}`, String(value));
      end.setAttribute('aria-valuetext', valueWords(this.axis, range[which]!));
      end.classList.toggle('moved', !isWhole(range));
    });
  }
}

for (const figure of document.querySelectorAll('figure:has(.design-axis)')) {
  const svg = figure.querySelector('svg')!, axes = axesOf(svg);
  new DesignLines(svg, axes, linesOf(svg, axes));
}
