// SPDX-License-Identifier: BSD-3-Clause
import {html, nothing} from 'lit';
import {drawMap, plottedIn, titleOf, type Plotted} from './chart/map_picture.ts';
import {AxisNumber, partOn} from './map_axis.ts';
import {Part} from './part.ts';
import {number} from './quantities.ts';
import type {DesignMap, DesignMaps} from './results.ts';

/// The map of the file. Its point is the design on the page; dragging it sets both numbers.
export class MapPanel extends Part {
  static override properties = {...Part.properties, pair: {state: true}, spoken: {state: true}};
  declare pair: number;
  declare spoken: string;
  private drawn: unknown[] = [];
  private watcher: ResizeObserver | null = null;

  constructor() {
    super();
    [this.pair, this.spoken] = [0, ''];
  }
  override connectedCallback() {
    super.connectedCallback();
    this.unsubscribe.push(this.app.beside.subscribe(() => this.requestUpdate()));
  }
  override render() {
    const {beside} = this.app, all = this.maps, map = this.map, running = beside.isRunning('map');
    if (!map) return html`<p class="hint">${beside.failure('map') || (!beside.takesLong('map') ? 'Computing …' : this.app.engine.oneAtATime ? 'The kernel answers nothing else while it computes the map.' : 'The map takes longer than a second.')}</p>${this.computeButton()}`;
    const point = this.point(map), axes = this.axes(map), label = `Map of ${titleOf(map.x)} and ${titleOf(map.y)}`;
    return html`<div class="bar">${all.length > 1 ? html`<select aria-label="Pair of numbers" @change=${(e: Event) => { this.pair = Number((e.target as HTMLSelectElement).value); }}>
          ${all.map((m, i) => html`<option value=${i} ?selected=${i === this.pair}>${m.y.name} over ${m.x.name}</option>`)}</select>` : nothing}
        <span>${map.kept} of ${map.designs} designs meet all rules</span>${beside.isOld('map') ? html`<span class="old" title="computed for other numbers">…</span>` : nothing}
        ${map.best ? html`<button title="Move the design to the largest margin of the map" @click=${() => this.set(map, map.best!.x, map.best!.y)}>★ best</button>` : nothing}${running ? nothing : this.computeButton()}</div>
      <div class="map" tabindex="0" role="application" aria-label="${label}. Arrow keys move the design, with Shift far." @keydown=${(e: KeyboardEvent) => this.key(e, map)}
           @pointerdown=${(e: PointerEvent) => this.pressed(e, map)} @pointermove=${(e: PointerEvent) => this.moved(e, map)} @pointerup=${() => this.app.state.dropped()}>
        <canvas></canvas><span class="design" ?hidden=${!point} title="the design on the page"></span></div>
      <p class="hint">${point ? this.words(map, point) : `${axes.map(a => a.value === null ? a.paths.join(', ') : '').filter(Boolean).join(' and ')} is not in the file: click in the map to set it.`}</p>
      <ul class="rules">${map.colours.map(({colour, words}) => html`<li><svg viewBox="0 0 12 12" aria-hidden="true"><rect width="12" height="12" fill=${colour}></rect></svg>${words}</li>`)}
        <li class="note">colour: the rule with the least margin; light: all are met; ★ largest margin${map.marks.some(m => m.kept === false) ? `; ●: cases, red if they violate a rule${map.marks.some(m => !m.decides && m.kept === false) ? ', ochre where that is not binding' : ''}` : ''}</li></ul>
      <p class="hidden" role="status" aria-live="polite">${this.spoken}</p>`;
  }
  override updated() {
    const {map} = this, box = this.querySelector<HTMLElement>('.map'), {theme} = this.app.display;
    if (!map || !box) return;
    if (!this.watcher) {
      this.watcher = new ResizeObserver(() => { this.drawn = []; this.requestUpdate(); });
      this.watcher.observe(box);
    }
    const {clientWidth: width, clientHeight: height} = box, canvas = box.querySelector('canvas')!, seen = [map, width, height, theme, devicePixelRatio];
    if (width < 120 || height < 80) return;
    if (seen.some((value, i) => value !== this.drawn[i])) {
      this.drawn = seen;
      [canvas.width, canvas.height] = [width * devicePixelRatio, height * devicePixelRatio];
      const pen = canvas.getContext('2d')!;
      pen.scale(devicePixelRatio, devicePixelRatio);
      drawMap(pen, map, width, height, theme);
    }
    const point = this.point(map), design = box.querySelector<HTMLElement>('.design')!, area = plottedIn(width, height);
    if (point) Object.assign(design.style, {left: `${area.left + point[0] * area.width}px`, top: `${area.top + (1 - point[1]) * area.height}px`});
  }
  override disconnectedCallback() {
    super.disconnectedCallback();
    this.watcher?.disconnect();
    this.watcher = null;
  }

  private get maps(): DesignMap[] {
    const found = this.app.beside.result<DesignMaps>('map');
    return !found ? [] : 'pairs' in found ? found.pairs : [found];
  }
  private get map(): DesignMap | null {
    return this.maps[this.pair] ?? this.maps[0] ?? null;
  }
  private computeButton() {
    const {beside} = this.app;
    return beside.takesLong('map') ? html`<button @click=${() => beside.waitFor('map')}>Compute the map</button>` : nothing;
  }
  private axes = (map: DesignMap) => [new AxisNumber(this.app, map.x, map, 'x'), new AxisNumber(this.app, map.y, map, 'y')] as const;
  /// Where the design on the page is, as parts of the axes; null outside.
  private point(map: DesignMap): [number, number] | null {
    const [x, y] = this.axes(map).map(a => a.value), parts: [number, number] = [x == null ? NaN : partOn(map.x, x), y == null ? NaN : partOn(map.y, y)];
    return parts.every(p => p >= -1e-9 && p <= 1 + 1e-9) ? parts : null;
  }
  /// The numbers of the design, and what the map says of the nearest one that it computed.
  private words(map: DesignMap, [a, b]: readonly [number, number]): string {
    const axes = this.axes(map), [i, j] = [Math.round(a * (map.x.points - 1)), Math.round(b * (map.y.points - 1))], k = j * map.x.points + i;
    const numbers = (x: number | null, y: number | null) => `${map.x.name} ${`${number(x, 4)} ${map.x.unit}`.trim()}, ${map.y.name} ${`${number(y, 4)} ${map.y.unit}`.trim()}`;
    const margin = map.grid.margin[k], governing = map.grid.governing[k];
    const said = typeof governing === 'number' ? `margin ${number(margin, 4)}, by ${map.colours.find(c => c.governing === governing)!.words}` : governing === 'none' ? 'nothing limits it' : 'no result';
    return `${numbers(axes[0].value, axes[1].value)}. Nearest design of the map, ${numbers(axes[0].at(i / (map.x.points - 1)), axes[1].at(j / (map.y.points - 1)))}: ${said}`;
  }
  private set(map: DesignMap, x: number, y: number, drag = false) {
    const [ofX, ofY] = this.axes(map);
    this.app.state.set({...ofX.settings(x), ...ofY.settings(y)}, drag);
  }
  private to(map: DesignMap, a: number, b: number, drag: boolean) {
    const [ofX, ofY] = this.axes(map), inside = (part: number) => Math.min(Math.max(part, 0), 1);
    this.set(map, ofX.at(inside(a)), ofY.at(inside(b)), drag);
  }
  private pressed(event: PointerEvent, map: DesignMap) {
    if (event.button !== 0) return;
    const box = event.currentTarget as HTMLElement, [a, b] = partsAt(event, box);
    if (a < -0.02 || a > 1.02 || b < -0.02 || b > 1.02) return;
    box.setPointerCapture(event.pointerId);
    box.focus();
    this.to(map, a, b, true);
    event.preventDefault();
  }
  private moved(event: PointerEvent, map: DesignMap) {
    const box = event.currentTarget as HTMLElement;
    if (!box.hasPointerCapture(event.pointerId)) return;
    this.to(map, ...partsAt(event, box), true);
  }
  private key(event: KeyboardEvent, map: DesignMap) {
    const step = event.shiftKey ? 0.1 : 0.01, [a, b] = this.point(map) ?? [0.5, 0.5];
    const moves: Record<string, [number, number]> = {ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, step], ArrowDown: [0, -step]}, move = moves[event.key];
    if (!move || event.ctrlKey || event.metaKey || event.altKey) return;
    this.to(map, a + move[0], b + move[1], false);
    const point = this.point(map);
    if (point) this.spoken = this.words(map, point);
    event.preventDefault();
  }
}
function partsAt(event: PointerEvent, box: HTMLElement): [number, number] {
  const {left, top} = box.getBoundingClientRect(), area: Plotted = plottedIn(box.clientWidth, box.clientHeight);
  return [(event.clientX - left - area.left) / area.width, 1 - (event.clientY - top - area.top) / area.height];
}
customElements.define('map-panel', MapPanel);
