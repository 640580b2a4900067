// SPDX-License-Identifier: BSD-3-Clause
import {html, nothing} from 'lit';
import {pictureOf, unitsOf, type Choice} from './chart/picture.ts';
import {Plot, type Picture} from './chart/plot.ts';
import {strokeOf} from './chart/strokes.ts';
import {DrawnCurves} from './drawn_curves.ts';
import {Part} from './part.ts';
import {FREQUENCY_UNITS, number, type FrequencyUnit} from './quantities.ts';
import type {Curves, Steady} from './results.ts';

/// Amplitude and phase of the characteristics. A click, or Enter at the cursor, makes the machine swing at that frequency.
export class CurveChart extends Part {
  static override properties = {...Part.properties, asTable: {state: true}, choice: {state: true}, kept: {state: true}, spoken: {state: true}};
  declare asTable: boolean;
  declare choice: Choice;
  declare spoken: string;
  declare kept: Curves | null;
  private amplitude: Plot | null = null;
  private phase: Plot | null = null;
  private picture: Picture | null = null;
  private readonly drawnCurves = new DrawnCurves();
  private drawn: unknown[] = [];
  private watcher: ResizeObserver | null = null;

  constructor() {
    super();
    this.asTable = false;
    this.spoken = '';
    this.kept = null;
    this.choice = {model: 0, unit: '', hidden: new Set()};
  }
  override render() {
    const {display, asker} = this.app, curves = this.drawnCurves.of(asker), units = curves ? unitsOf(curves) : [];
    const unit = units.includes(this.choice.unit) ? this.choice.unit : units[0] ?? '';
    if (curves && unit !== this.choice.unit) this.chooseUnit(curves, unit);
    const check = (label: string, on: boolean, set: (on: boolean) => void) => html`<label title=${HINTS[label] ?? ''}><input type="checkbox" .checked=${on}
      @change=${(e: Event) => set((e.target as HTMLInputElement).checked)}> ${label}</label>`;
    return html`
      <div class="bar">
        <h2 class="hidden">Characteristics</h2>${asker.isOld('curves') ? html`<span class="old">…</span>` : nothing}
        ${units.length > 1 ? html`<select aria-label="Quantity" @change=${(e: Event) => this.chooseUnit(curves!, (e.target as HTMLSelectElement).value)}>
          ${units.map(u => html`<option value=${u} ?selected=${u === unit}>${QUANTITIES[u] ?? u}</option>`)}</select>` : nothing}
        ${curves && curves.models.length > 1 ? html`<select aria-label="Excitation" @change=${(e: Event) => { this.choice = {...this.choice, model: Number((e.target as HTMLSelectElement).value)}; }}>
          ${curves.models.map((m, i) => html`<option value=${i} ?selected=${i === this.choice.model}>${m.excitations?.join(', ') || 'all excitations'}</option>`)}</select>` : nothing}
        <select aria-label="Unit of frequency" @change=${(e: Event) => display.set({frequencyUnit: (e.target as HTMLSelectElement).value as FrequencyUnit})}>
          ${Object.keys(FREQUENCY_UNITS).map(u => html`<option ?selected=${u === display.frequencyUnit}>${u}</option>`)}</select>
        ${check('log f', display.logarithmicFrequency, logarithmicFrequency => display.set({logarithmicFrequency}))}
        ${check('log', display.logarithmicAmplitude, logarithmicAmplitude => display.set({logarithmicAmplitude}))}
        ${check('dB', display.decibel, decibel => display.set({decibel}))}
        ${check('keep', this.kept !== null, on => { this.kept = on ? curves : null; })}
        ${check('table', this.asTable, on => { this.asTable = on; })}
      </div>
      <div class="plots" tabindex="0" role="application" aria-label="Characteristics. Left and right arrow move the cursor, page up and page down go from peak to peak, Enter makes the machine swing at the cursor." @keydown=${this.key}>
        <div class="amplitude"></div><div class="phase"></div>
        ${curves ? nothing : html`<p class="missing">${asker.missing('curves')}</p>`}
      </div>
      <div class="readings" role="group" aria-label="Curves">${this.legend(curves)}</div>
      <p class="hidden" role="status" aria-live="polite">${this.spoken}</p>
      ${this.asTable && this.picture ? this.table(this.picture) : nothing}`;
  }
  override firstUpdated() {
    const click = (x: number) => this.swing(x / FREQUENCY_UNITS[this.app.display.frequencyUnit]);
    const [top, bottom] = [this.querySelector<HTMLElement>('.amplitude')!, this.querySelector<HTMLElement>('.phase')!];
    this.amplitude = new Plot(top, 'amplitude', this.app.display, click);
    this.phase = new Plot(bottom, 'phase', this.app.display, click);
    for (const place of [top, bottom]) place.addEventListener('mousemove', event => this.follow(event, place));
    this.watcher = new ResizeObserver(() => {
      this.amplitude!.resize();
      this.phase!.resize();
    });
    this.watcher.observe(top);
    this.updated();
  }
  override updated() {
    const {asker, display} = this.app, curves = this.drawnCurves.of(asker);
    if (!curves || !this.amplitude) return;
    const steady = asker.result<Steady>('steady'), seen = [curves, steady, this.kept, this.choice, display.theme, display.frequencyUnit, display.logarithmicFrequency, display.decibel, display.logarithmicAmplitude];
    if (seen.some((value, i) => value !== this.drawn[i])) {
      this.drawn = seen;
      this.picture = pictureOf(curves, this.choice, display, steady, this.kept);
      display.drawn = this.picture.curves.map(c => c.name);
      this.amplitude.show(this.picture);
      this.phase!.show(this.picture);
      this.requestUpdate();
    } else if (this.picture) {
      const cursor = display.cursor === null ? null : display.cursor * FREQUENCY_UNITS[display.frequencyUnit];
      if (cursor === this.picture.cursor) return;
      this.picture.cursor = cursor;
      this.amplitude.redraw();
      this.phase!.redraw();
    }
  }
  override disconnectedCallback() {
    super.disconnectedCallback();
    this.watcher?.disconnect();
    this.amplitude?.destroy();
    this.phase?.destroy();
  }

  /// Names of the curves with their values at the cursor; a click hides one.
  private legend(curves: Curves | null) {
    if (!curves || !this.picture) return nothing;
    const steady = this.picture.overlays.some(o => o.kind === 'stable');
    const {display} = this.app, all = curves.results.filter(r => r.unit === this.choice.unit && !curves.vanishing?.includes(r.name)), at = this.indexAtCursor();
    return html`${at === null ? nothing : html`<span class="cursor">${number(this.picture.x[at], 4)} ${display.frequencyUnit}</span>`}${all.map((r, i) => {
      const curve = this.picture!.curves.find(c => c.name === r.name), {colour} = strokeOf(i, display.theme);
      const value = at !== null && curve ? number(curve.amplitude[at], 3) : '';
      return html`<button class="curve" aria-pressed=${curve !== undefined} @click=${() => this.toggle(r.name)}>
        <svg viewBox="0 0 18 6" aria-hidden="true"><line x1="0" y1="3" x2="18" y2="3" stroke=${colour} stroke-width="3" stroke-dasharray=${strokeOf(i, display.theme).dash.join(' ')}></line></svg>
        ${r.name}${value ? html` <b>${value}</b>` : nothing}</button>`;
    })}${steady ? html`<span class="note">thick: steady motion of the nonlinear machine, half peak-to-peak; dashed: unstable; arrow: jump</span>` : nothing}`;
  }
  /// Shows the first curves of a unit; more would cover each other until one chooses.
  private chooseUnit(curves: Curves, unit: string) {
    const names = curves.results.filter(r => r.unit === unit && !curves.vanishing?.includes(r.name)).map(r => r.name);
    this.choice = {...this.choice, unit, hidden: new Set(names.slice(MOST_AT_FIRST))};
  }
  private toggle(name: string) {
    const hidden = new Set(this.choice.hidden);
    if (!hidden.delete(name)) hidden.add(name);
    this.choice = {...this.choice, hidden};
  }
  private indexAtCursor(): number | null {
    const {picture} = this;
    if (!picture || picture.cursor === null || !picture.x.length) return null;
    let best = 0;
    picture.x.forEach((x, i) => { if (Math.abs(x - picture.cursor!) < Math.abs(picture.x[best]! - picture.cursor!)) best = i; });
    return best;
  }
  private follow(event: MouseEvent, place: HTMLElement) {
    const over = place.querySelector<HTMLElement>('.u-over'), x = this.picture?.x;
    if (!over || !x?.length) return;
    const {left, width} = over.getBoundingClientRect(), part = (event.clientX - left) / width, [from, to] = [x[0]!, x.at(-1)!];
    if (part < 0 || part > 1) return;
    const value = this.app.display.logarithmicFrequency ? from * (to / from) ** part : from + part * (to - from);
    this.app.display.set({cursor: value / FREQUENCY_UNITS[this.app.display.frequencyUnit]});
  }
  private swing(omega: number) {
    this.app.display.set({shown: {kind: 'frequency', omega}, cursor: omega});
    this.app.asker.again();
  }
  private key(event: KeyboardEvent) {
    const {display} = this.app, x = this.picture?.x, factor = FREQUENCY_UNITS[display.frequencyUnit];
    if (!x?.length || event.ctrlKey || event.metaKey || event.altKey) return;
    const at = this.indexAtCursor() ?? 0, peaks = [...new Set(this.picture!.curves.flatMap(c => c.peaks.map(p => p.x)))].sort((a, b) => a - b);
    const part = event.shiftKey ? 0.05 : 0.004, here = this.picture!.cursor ?? x[0]!, [from, to] = [x[0]!, x.at(-1)!];
    const step = (sign: number) => {
      const next = display.logarithmicFrequency ? here * (to / from) ** (sign * part) : here + sign * part * (to - from);
      return Math.min(Math.max(next, from), to);
    };
    const next: Record<string, number | undefined> = {
      ArrowRight: step(1), ArrowLeft: step(-1), Home: from, End: to,
      PageDown: peaks.find(p => p > here * (1 + 1e-9)), PageUp: peaks.findLast(p => p < here * (1 - 1e-9))};
    if (event.key === 'Enter') this.swing(x[at]! / factor);
    else if (event.key in next) {
      const to = next[event.key];
      if (to !== undefined) display.set({cursor: to / factor});
      this.updateComplete.then(() => this.speak());
    } else return;
    event.preventDefault();
  }
  private speak() {
    const at = this.indexAtCursor(), {picture} = this;
    if (at === null || !picture) return;
    const unit = this.app.display.decibel ? 'dB' : picture.scale.unit;
    this.spoken = `${number(picture.x[at], 4)} ${this.app.display.frequencyUnit}: ${picture.curves.map(c => `${c.name} ${number(c.amplitude[at], 3)} ${unit}`).join(', ')}`;
  }
  private table({x, curves, scale}: Picture) {
    const rows = x.map((_, i) => i).filter(i => i % Math.ceil(x.length / 60) === 0), unit = this.app.display.decibel ? 'dB' : scale.unit;
    return html`<div class="scroll table" tabindex="0"><table><caption>Amplitudes [${unit}]</caption><thead><tr><th scope="col">${this.app.display.frequencyUnit}</th>${curves.map(c => html`<th scope="col">${c.name}</th>`)}</tr></thead>
      <tbody>${rows.map(i => html`<tr><th scope="row">${number(x[i], 4)}</th>${curves.map(c => html`<td>${number(c.amplitude[i], 3)}</td>`)}</tr>`)}</tbody></table></div>`;
  }
}
const MOST_AT_FIRST = 6;
const HINTS: Record<string, string> = {'log f': 'logarithmic frequency', log: 'logarithmic amplitude', dB: 'decibels of the SI unit',
                                       keep: 'keep these curves, dashed, to compare with changed ones', table: 'the values as a table'};
const QUANTITIES: Record<string, string> = {m: 'displacement', rad: 'rotation', 'm/s': 'velocity', 'm/s^2': 'acceleration', 'm/s2': 'acceleration', N: 'force',
                                            'N m': 'moment'};
customElements.define('curve-chart', CurveChart);
