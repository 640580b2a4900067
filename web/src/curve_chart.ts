// SPDX-License-Identifier: BSD-3-Clause
import {html, nothing, svg} from 'lit';
import {limitsOf, unitOfFirstLimit, type NotDrawn} from './chart/limits.ts';
import {shownLines} from './chart/limit_lines.ts';
import {amplitudeAt, pictureOf, shownAmplitude, shownLimits, unitsOf, type Choice} from './chart/picture.ts';
import {bandAt, readingAt, type Compared} from './chart/overlays.ts';
import {Plot, type Picture, type Shown} from './chart/plot.ts';
import {stabilityWords, steadyReadings} from './chart/steady_readings.ts';
import {strokeOf} from './chart/strokes.ts';
import {comparable, comparisons, isCompared, wordsOf} from './comparisons.ts';
import {DrawnCurves} from './drawn_curves.ts';
import {hasSomethingToJudge} from './judgement.ts';
import {LimitMover} from './limit_mover.ts';
import {missingCurves} from './missing_curves.ts';
import {outdatedNote} from './outdated_note.ts';
import {Part} from './part.ts';
import {FREQUENCY_UNITS, number, quantityName, type FrequencyUnit} from './quantities.ts';
import type {Curves, SampledBand, Steady, Verdict} from './results.ts';
import {sampledBands, sampledDesigns} from './sampled_designs.ts';

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
  private bandsDrawn = NONE;
  private limitsDrawn = '';
  private notDrawn: NotDrawn[] = [];
  private mover!: LimitMover;
  private compared: Compared[] = [];
  private wanted = '';  // unit that the user chose
  private hasBegun = false;  // with the quantity of the first limit
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
    const unit = [this.wanted, this.choice.unit].find(u => units.includes(u)) ?? units[0] ?? '';
    if (curves && unit !== this.choice.unit) this.chooseUnit(curves, unit);
    const waits = this.isFirstQuantityAwaited(units);
    const check = (label: string, on: boolean, set: (on: boolean) => void) => html`<label title=${HINTS[label] ?? ''}><input type="checkbox" .checked=${on}
      @change=${(e: Event) => set((e.target as HTMLInputElement).checked)}> ${label}</label>`;
    return html`
      <div class="bar">
        <h2 class="hidden">Characteristics</h2>${asker.isOld('curves') || waits ? html`<span class="old">…</span>` : nothing}
        ${units.length ? html`<select aria-label="Quantity" @change=${(e: Event) => this.chooseQuantity(curves!, (e.target as HTMLSelectElement).value)}>
          ${(this.app.engine.isLive ? offeredUnits(units) : units).map(u => html`<option value=${u} ?selected=${u === unit}>${quantityName(u)}</option>`)}</select>` : nothing}
        ${curves && curves.models.length > 1 ? html`<select aria-label="Excitation" @change=${(e: Event) => { this.choice = {...this.choice, model: Number((e.target as HTMLSelectElement).value)}; }}>
          ${curves.models.map((m, i) => html`<option value=${i} ?selected=${i === this.choice.model}>${m.excitations?.join(', ') || 'all excitations'}</option>`)}</select>` : nothing}
        <select aria-label="Unit of frequency" @change=${(e: Event) => display.set({frequencyUnit: (e.target as HTMLSelectElement).value as FrequencyUnit})}>
          ${Object.keys(FREQUENCY_UNITS).map(u => html`<option ?selected=${u === display.frequencyUnit}>${u}</option>`)}</select>
        ${check('log f', display.logarithmicFrequency, logarithmicFrequency => display.set({logarithmicFrequency}))}
        ${check('log', display.logarithmicAmplitude, logarithmicAmplitude => display.set({logarithmicAmplitude}))}
        ${check('dB', display.decibel, decibel => display.set({decibel}))}
        <details class="menu" @keydown=${closeAtEscape}><summary title="draw others beside these curves">compare</summary><div>${check('keep these curves', this.kept !== null, on => { this.kept = on ? curves : null; })}${comparable(this.app).map(key => check(wordsOf(key), isCompared(this.app, key), on => this.compare(key, on)))}</div></details>
        ${check('table', this.asTable, on => { this.asTable = on; })}
      </div>
      <div class="plots ${asker.isOutdated('curves') ? 'outdated' : ''}" tabindex="0" role="application" aria-label="Characteristics. Left and right arrow move the cursor, page up and page down go from peak to peak, Enter makes the machine swing at the cursor." @keydown=${this.key}>
        <div class="amplitude"></div><div class="phase"></div>
        ${asker.isOutdated('curves') ? outdatedNote : nothing}
        ${curves ? nothing : html`<p class="missing">${missingCurves(this.app)}</p>`}
      </div>
      <div class="readings" role="group" aria-label="Curves">${this.legend(curves)}</div>
      <p class="hidden" role="status" aria-live="polite">${this.spoken}</p>
      ${this.asTable && this.picture ? this.table(this.picture) : nothing}`;
  }
  override connectedCallback() {
    super.connectedCallback();
    const {beside, sampler} = this.app;
    this.unsubscribe.push(beside.subscribe(() => this.requestUpdate()));
    if (sampler) this.unsubscribe.push(sampler.subscribe(() => { if (this.bands.length || this.bandsDrawn.length) this.requestUpdate(); }));
  }
  override firstUpdated() {
    const click = (x: number) => this.swing(x / FREQUENCY_UNITS[this.app.display.frequencyUnit]);
    const [top, bottom] = [this.querySelector<HTMLElement>('.amplitude')!, this.querySelector<HTMLElement>('.phase')!];
    this.mover = new LimitMover(this.app, y => amplitudeAt(y, this.picture!.scale, this.app.display), () => this.requestUpdate());
    this.amplitude = new Plot(top, 'amplitude', this.app.display, click, this.mover);
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
    this.beginWithFirstLimit(curves);
    const steady = asker.result<Steady>('steady'), compared = comparisons(this.app, this.kept), binding = this.mover.areBinding;
    const bands = this.bandsDrawn = this.bands;
    const seen = [curves, steady, binding, bands, ...compared.flatMap(c => [c.curves, c.measured?.[0], c.key]), this.choice, display.theme, display.frequencyUnit, display.logarithmicFrequency, display.decibel, display.logarithmicAmplitude];
    if (JSON.stringify(compared.map(c => [c.label, c.old, c.failure])) !== JSON.stringify(this.compared.map(c => [c.label, c.old, c.failure]))) this.requestUpdate();
    this.compared = compared;
    if (seen.length !== this.drawn.length || seen.some((value, i) => value !== this.drawn[i])) {
      this.drawn = seen;
      this.picture = pictureOf(curves, this.choice, display, steady, compared, binding, bands);
      this.limitsDrawn = this.setLimits(curves);
      display.drawn = this.picture.curves.map(c => c.name);
      this.amplitude.show(this.picture);
      this.phase!.show(this.picture);
      this.requestUpdate();
    } else if (this.picture) {
      const limits = this.setLimits(curves);
      if (limits !== this.limitsDrawn) {
        this.limitsDrawn = limits;
        this.amplitude.rescale();
        this.requestUpdate();
      }
      const {cursor} = this;
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

  /// Of the machines within the tolerances; the same list until it changes.
  private get bands() {
    const sampled = sampledDesigns(this.app);
    return sampled ? sampledBands(sampled, this.app.state.case) : NONE;
  }
  /// Puts the present limits into the picture. @returns their text, which changes with them
  private setLimits(curves: Curves): string {
    const {display} = this.app, {drawn, not} = limitsOf(curves, this.choice.model, this.mover.requirements), names = this.drawable(curves).map(r => r.name);
    this.notDrawn = not;
    const picture = this.picture!, {scale} = picture, {hidden, unit} = this.choice;
    const lines = shownLines(this.mover.presentLines(curves), names, hidden, unit, scale, display, v => shownAmplitude(v, scale, display), [picture.x[0] ?? 0, picture.x.at(-1) ?? 0]);
    this.mover.placed(lines.handles);
    picture.limits = [...shownLimits(this.mover.present(drawn), names, hidden, scale, display), ...lines.handles];
    picture.overlays = [...lines.overlays, ...picture.overlays.filter(o => o.kind !== 'limit')];
    return JSON.stringify([this.picture!.limits, not.map(n => n.why)]);
  }
  private drawable = (curves: Curves) => curves.results.filter(r => r.unit === this.choice.unit && !curves.vanishing?.includes(r.name));

  /// Names of the curves with their values at the cursor; a click hides one.
  private legend(curves: Curves | null) {
    if (!curves || !this.picture) return nothing;
    const steady = this.picture.overlays.some(o => o.kind === 'stable'), elsewhere = steady ? '' : this.steadyElsewhere(this.drawable(curves));
    const {display} = this.app, all = this.drawable(curves), at = this.indexAtCursor(), level = all[0]?.level;
    return html`${at === null ? nothing : html`<span class="cursor">${number(this.picture.x[at], 4)} ${display.frequencyUnit} [${this.unit}]</span>`}${this.notDrawn.length ? html`<details class="note"><summary>${this.notDrawn.length === 1 ? '1 limit is' : `${this.notDrawn.length} limits are`} not drawn</summary>
      <ul>${this.notDrawn.map(({words, why}) => html`<li>${words}: ${why}</li>`)}</ul></details>` : nothing}${all.map((r, i) => {
      const curve = this.picture!.curves.find(c => c.name === r.name), {colour} = strokeOf(i, display.theme);
      const value = at !== null && curve ? this.reading(curve, at) : '';
      return html`<button class="curve" aria-pressed=${curve !== undefined} @click=${() => this.toggle(r.name)}>
        <svg viewBox="0 0 18 6" aria-hidden="true"><line x1="0" y1="3" x2="18" y2="3" stroke=${colour} stroke-width="3" stroke-dasharray=${strokeOf(i, display.theme).dash.join(' ')}></line></svg>
        ${r.name}${value ? html` <b>${value}</b>` : nothing}</button>`;
    })}${this.steadyAtCursor().map(({name, motions}) => html`<span class="curve steady">steady ${name}: ${motions.map((m, i) => html`${i ? ', ' : ''}<b>${m.value}</b> ${m.words}`)}</span>`)}${this.bandLegend()}${this.compared.map(c => html`<span class="curve" title=${c.failure}><svg viewBox="0 0 26 6" aria-hidden="true">${c.measured ? svg`<circle cx="7" cy="3" r="2.4" fill="currentColor"></circle><circle cx="18" cy="3" r="2.4" fill="currentColor"></circle>`
        : svg`<line x1="0" y1="3" x2="26" y2="3" stroke="currentColor" stroke-width="2" stroke-dasharray=${c.dash.join(' ')}></line>`}</svg> ${c.label}${c.failure ? ': not computed' : ''}${this.readings(c).map((r, i, all) => html`${i ? ', ' : ': '}${r.name}${r.at} <b>${r.value}</b>${i < all.length - 1 ? nothing : ` ${this.unit}`}`)}${c.old ? html` <span class="old">…</span>` : nothing}</span>`)}${steady ? html`<span class="note">thick: steady motion of the nonlinear machine, half peak-to-peak${level && level !== '0-p' ? ` at the level ${level} of a sine` : ''}; dashed: unstable; arrow: jump</span>` : nothing}${elsewhere ? html`<span class="note">${elsewhere}</span>` : nothing}${this.notes()}`;
  }
  /// How many designs the bands are of, and the bands at the cursor.
  private bandLegend() {
    const bands = this.picture!.overlays.filter(o => o.kind === 'band'), sampled = bands.length ? sampledDesigns(this.app) : null, index = this.indexAtCursor();
    if (!sampled) return nothing;
    const values = index === null ? [] : bands.flatMap(band => {
      const found = bandAt(band, this.picture!.x[index]!);
      return found ? [html`${band.name} <b>${number(found[0], 3)} … ${number(found[1], 3)}</b>`] : [];
    });
    return html`<span class="curve" title="from 5 to 95 % of the machines within the tolerances, at each frequency"><svg viewBox="0 0 18 8" aria-hidden="true"><rect width="18" height="8" fill=${strokeOf(bands[0]!.stroke, this.app.display.theme).colour} fill-opacity="0.3"></rect></svg> 5 … 95 % of ${sampled.found.designs.toLocaleString('en-US')} designs${values.map((v, i) => html`${i ? ', ' : ': '}${v}`)}${values.length ? ` ${this.unit}` : ''}${sampled.old ? html` <span class="old">…</span>` : nothing}</span>`;
  }
  /// What the program notes: the first sentence, and the others on demand.
  private notes() {
    const [first, ...more] = this.app.asker.notes('curves');
    return html`${first ? html`<span class="note">${first}</span>` : nothing}${more.length ? html`<details class="note"><summary>${more.length === 1 ? '1 more note' : `${more.length} more notes`}</summary>
      <ul>${more.map(note => html`<li>${note}</li>`)}</ul></details>` : nothing}`;
  }
  /// Why the steady motions of these results are not in the chart; empty: there are none of them.
  private steadyElsewhere(all: Curves['results']): string {
    const steady = this.app.asker.result<Steady>('steady'), other = steady?.over === 'frequency' ? steady.results.find(s => all.some(r => r.name === s.name && r.unit !== s.unit)) : undefined;
    return other ? `the steady motion is not drawn: it is computed as ${quantityName(other.unit)}` : '';
  }
  /// Shows the first curves of a unit, those with limits before others; more would cover each other until one chooses.
  private chooseUnit(curves: Curves, unit: string) {
    const names = curves.results.filter(r => r.unit === unit && !curves.vanishing?.includes(r.name)).map(r => r.name);
    const limited = new Set([...this.app.index.byPath.values()].filter(e => !e.children.length).flatMap(e => e.path)), first = (name: string) => (limited.has(name) ? 0 : 1);
    const order = [...names].sort((a, b) => first(a) - first(b));
    this.choice = {...this.choice, unit, hidden: new Set(order.slice(MOST_AT_FIRST))};
  }
  /// The page begins with the quantity of the first limit that decides, once.
  private beginWithFirstLimit(curves: Curves) {
    const {asker} = this.app, verdict = asker.result<Verdict>('verdict');
    if (this.wanted || this.hasBegun || !verdict) return;
    this.hasBegun = true;
    this.requestUpdate();  // the mark "…" goes, if nothing else changes
    const unit = unitOfFirstLimit(verdict, curves);
    if (unit !== null && unit !== this.choice.unit && offeredUnits(unitsOf(curves)).includes(unit)) this.chooseQuantity(curves, unit);
  }
  /// Is the quantity with which the page begins not known, or not there yet?
  private isFirstQuantityAwaited(units: readonly string[]): boolean {
    const {app} = this;
    if (!app.engine.isLive || app.asker.failure('verdict') || app.asker.failure('curves')) return false;
    return this.wanted ? units.some(u => isSameMotion(u, this.wanted)) && !units.includes(this.wanted) : !this.hasBegun && hasSomethingToJudge(app) && !app.asker.hasErrors;
  }
  /// Motions are drawn in the quantity of the chosen unit, which the program computes.
  private chooseQuantity(curves: Curves, unit: string) {
    const {display, asker, beside} = this.app, quantity = MOTIONS.findIndex(([a, b]) => a === unit || b === unit);
    this.wanted = unit;
    if (unitsOf(curves).includes(unit)) return this.chooseUnit(curves, unit);
    display.set({quantity: QUANTITIES[quantity]!});
    asker.again();
    beside.rest();
  }
  private compare(key: string, on: boolean) {
    const {display, beside} = this.app;
    display.set({compared: new Map([...display.compared, [key, on]])});
    beside.rest();
  }
  private toggle(name: string) {
    const hidden = new Set(this.choice.hidden);
    if (!hidden.delete(name)) hidden.add(name);
    this.choice = {...this.choice, hidden};
  }
  /// On the axis; the picture follows it.
  private get cursor(): number | null {
    const {cursor, frequencyUnit} = this.app.display;
    return cursor === null ? null : cursor * FREQUENCY_UNITS[frequencyUnit];
  }
  private indexAtCursor(): number | null {
    const {picture, cursor} = this;
    if (!picture || cursor === null || !picture.x.length) return null;
    let best = 0;
    picture.x.forEach((x, i) => { if (Math.abs(x - cursor) < Math.abs(picture.x[best]! - cursor)) best = i; });
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
    if (!this.app.engine.isLive) return this.app.display.set({cursor: omega});
    this.app.display.set({shown: {kind: 'frequency', omega}, cursor: omega});
    this.app.asker.again();
  }
  private key(event: KeyboardEvent) {
    const {display} = this.app, x = this.picture?.x, factor = FREQUENCY_UNITS[display.frequencyUnit];
    if (!x?.length || event.ctrlKey || event.metaKey || event.altKey) return;
    const at = this.indexAtCursor() ?? 0, peaks = [...new Set(this.picture!.curves.flatMap(c => [...c.peaks.map(p => p.x), ...c.unbounded]))].sort((a, b) => a - b);
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
  private reading = ({amplitude, unbounded}: Shown, at: number) => (unbounded.includes(this.picture!.x[at]!) ? '∞' : number(amplitude[at], 3));
  private speak() {
    const at = this.indexAtCursor(), {picture} = this;
    if (at === null || !picture) return;
    const steady = this.steadyAtCursor().map(({name, motions}) => [`steady ${name} ${motions.map(m => `${m.value} ${this.unit} ${m.words}`).join(', ')}`]);
    const all = [picture.curves.map(c => `${c.name} ${this.reading(c, at)} ${this.unit}`), ...this.compared.map(c => this.readings(c).map((r, i) => `${i ? '' : `${c.label}: `}${r.name}${r.at} ${r.value} ${this.unit}`)), ...steady];
    this.spoken = `${number(picture.x[at], 4)} ${this.app.display.frequencyUnit}: ${all.filter(one => one.length).map(one => one.join(', ')).join('; ')}`;
  }
  private get unit() {
    return this.app.display.decibel ? 'dB' : this.picture!.scale.unit;
  }
  /// Values of what is compared at the cursor. `at`: the frequency of a measured point, if it is another one.
  private readings({key}: Compared): {name: string; at: string; value: string}[] {
    const {picture} = this, index = this.indexAtCursor();
    if (index === null || !picture) return [];
    const shown = (x: number) => `${number(x, 4)} ${this.app.display.frequencyUnit}`, here = shown(picture.x[index]!);
    return picture.overlays.filter(o => o.of === key).flatMap(overlay => {
      const found = readingAt(overlay, picture.x[index]!);
      return found ? [{name: overlay.name, at: shown(found.x) === here ? '' : ` at ${shown(found.x)}`, value: number(found.y, 3)}] : [];
    });
  }
  /// The steady motions at the cursor, with the frequency of those that are computed only near it.
  private steadyAtCursor(): {name: string; motions: {value: string; words: string}[]}[] {
    const {picture} = this, index = this.indexAtCursor();
    if (index === null || !picture) return [];
    const at = picture.x[index]!, shown = (x: number) => `${number(x, 4)} ${this.app.display.frequencyUnit}`;
    return picture.steady.map(curve => ({name: curve.name, motions: steadyReadings(curve, at).map(m => ({
      value: number(m.y, 3), words: `${stabilityWords(m)}${shown(m.x) === shown(at) ? '' : ` at ${shown(m.x)}`}`}))})).filter(c => c.motions.length);
  }
  /// All computed steady motions, branch after branch.
  private steadyTable({steady}: Picture) {
    const branches = steady[0]?.branches ?? [];
    if (!branches.length) return nothing;
    return html`<table><caption>Steady motions, half peak-to-peak [${this.unit}]</caption><thead><tr><th scope="col">${this.app.display.frequencyUnit}</th>${steady.map(c => html`<th scope="col">${c.name}</th>`)}<th scope="col">stability</th></tr></thead>
      <tbody>${branches.flatMap((points, b) => points.map((p, i) => html`<tr><th scope="row">${number(p.x, 4)}</th>${steady.map(c => html`<td>${number(c.branches[b]![i]!.y, 3)}</td>`)}<td>${stabilityWords(p)}</td></tr>`))}</tbody></table>`;
  }
  private table(picture: Picture) {
    const {x, curves} = picture;
    const rows = x.map((_, i) => i).filter(i => i % Math.ceil(x.length / 60) === 0), unit = this.unit;
    return html`<div class="scroll table" tabindex="0"><table><caption>Amplitudes [${unit}]</caption><thead><tr><th scope="col">${this.app.display.frequencyUnit}</th>${curves.map(c => html`<th scope="col">${c.name}</th>`)}</tr></thead>
      <tbody>${rows.map(i => html`<tr><th scope="row">${number(x[i], 4)}</th>${curves.map(c => html`<td>${this.reading(c, i)}</td>`)}</tr>`)}</tbody></table>${this.steadyTable(picture)}</div>`;
  }
}
/// Escape closes a menu.
function closeAtEscape(event: KeyboardEvent) {
  const menu = event.currentTarget as HTMLDetailsElement;
  if (event.key !== 'Escape' || !menu.open) return;
  menu.open = false;
  menu.querySelector('summary')!.focus();
  event.stopPropagation();
}
const MOST_AT_FIRST = 6;
const NONE: readonly SampledBand[] = [];
/// Units of the motions in each quantity: of a translation and of a rotation.
const MOTIONS = [['m', 'rad'], ['m/s', 'rad/s'], ['m/s²', 'rad/s²']] as const, QUANTITIES = ['displacement', 'velocity', 'acceleration'];
/// Are both units of a translation, or both of a rotation?
const isSameMotion = (a: string, b: string) => [0, 1].some(kind => [a, b].every(u => MOTIONS.some(m => m[kind] === u)));
/// Units that can be drawn: those of the curves, and their motions in the other quantities.
const offeredUnits = (units: readonly string[]) => [
  ...[0, 1].flatMap(kind => (units.some(u => MOTIONS.some(m => m[kind] === u)) ? MOTIONS.map(m => m[kind]!) : [])), ...units.filter(u => !MOTIONS.some(m => (m as readonly string[]).includes(u)))];
const HINTS: Record<string, string> = {'log f': 'logarithmic frequency', log: 'logarithmic amplitude', dB: 'decibels of the SI unit',
                                       'keep these curves': 'dashed, to compare with changed ones', table: 'the values as a table'};
customElements.define('curve-chart', CurveChart);
