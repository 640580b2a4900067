// SPDX-License-Identifier: BSD-3-Clause
import {html, nothing} from 'lit';
import {hasSomethingToJudge} from './judgement.ts';
import type {Table} from './display.ts';
import './map_panel.ts';
import {briefMode} from './mode_words.ts';
import {Part, type App} from './part.ts';
import {limitNumber, setLimit} from './limit_number.ts';
import {missingCurves} from './missing_curves.ts';
import {outdatedNote} from './outdated_note.ts';
import {refuse} from './refused_number.ts';
import {frequency, number, quantity, scaleAtLevel, withUnit} from './quantities.ts';
import type {Check, Curves, Mode, Modes, Peak, Requirement, Roots, Verdict} from './results.ts';

const TABS: Record<Table, string> = {modes: 'Modes', requirements: 'Requirements', mounts: 'Mounts', peaks: 'Peaks', map: 'Map'};
const COMMANDS: Record<Table, string> = {modes: 'modes', requirements: 'verdict', mounts: 'check', peaks: 'curves', map: 'map'};
const COORDINATES = ['x', 'y', 'z', 'θx', 'θy', 'θz'];

/// A map can be asked for.
const hasMap = (app: App) => app.engine.isLive && app.index.byPath.has('analyses\0map');
/// The table that the user chose, or the one that suits the file.
export function tableOnPage(app: App): Table {
  const {table} = app.display, usual = hasSomethingToJudge(app) ? 'requirements' : hasMap(app) ? 'map' : 'modes';
  return table && (table !== 'map' || hasMap(app)) ? table : usual;
}

/// Tables of the results: modes with their energies, margins of requirements, loads of mounts, peaks.
export class ResultTables extends Part {
  override render() {
    const {app} = this, tab = tableOnPage(app);
    const bodies: Record<Table, () => unknown> = {modes: () => this.modes(), requirements: () => this.requirements(), mounts: () => this.mounts(), peaks: () => this.peaks(),
                                                  map: () => html`<map-panel .app=${app}></map-panel>`};
    const shown = (Object.keys(TABS) as Table[]).filter(t => t !== 'map' || hasMap(app));
    const isOutdated = tab === 'map' ? app.beside.isOld('map') && app.asker.hasErrors : app.asker.isOutdated(COMMANDS[tab]);
    return html`<div class="tabs" role="tablist" aria-label="Tables">${shown.map(t => html`<button role="tab" id="tab-${t}" aria-controls="table-panel" aria-selected=${t === tab} @click=${() => this.choose(t)}>${TABS[t]}</button>`)}</div>
      <div class="scroll table ${isOutdated ? 'outdated' : ''}" role="tabpanel" id="table-panel" aria-labelledby="tab-${tab}" tabindex="0" @scroll=${this.scrolled}>${isOutdated ? outdatedNote : nothing}${bodies[tab]()}</div>`;
  }
  private choose(table: Table) {
    this.app.display.set({table});
    this.app.beside.rest();
  }
  private modes() {
    const {asker, display} = this.app, modes = asker.result<Modes>('modes'), roots = asker.result<Roots>('roots');
    if (!modes) return this.missing('modes');
    const one = modes.bodies.length === 1, words = modes.kinetic_energy_share_words ?? 'shares of the kinetic energy';
    return html`<table><thead><tr><th scope="col">Mode</th><th scope="col">${display.frequencyUnit}</th><th scope="col" title="damping ratio of the nearest root">ζ</th><th scope="col" class="words">motion</th>
      ${one ? COORDINATES.map(c => html`<th scope="col" title=${words}>${c}</th>`) : html`<th scope="col">kinetic energy</th>`}</tr></thead><tbody>
      ${this.modesInView(modes).map(m => {
        const chosen = display.shown.kind === 'mode' && display.shown.number === m.number, root = roots?.roots.find(r => r.nearest_mode === m.number && r.eigenvalue[1] > 0);
        return html`<tr aria-selected=${chosen} class=${chosen ? 'chosen' : ''} @click=${() => display.set({shown: {kind: 'mode', number: m.number}})}>
          <th scope="row"><button class="link" aria-label="Show mode ${m.number}">${m.number}</button></th><td>${frequency(m.angular_frequency, display.frequencyUnit).split(' ')[0]}</td>
          <td>${root ? `${number(100 * root.damping_ratio, 3)} %` : roots ? '–' : html`<span class="old">…</span>`}</td><td class="words" title=${m.name}>${briefMode(m.name)}</td>
          ${one ? m.kinetic_energy_share!.map(share => html`<td class=${isCoupled(share) ? 'share coupled' : 'share'} title=${isCoupled(share) ? words : ''}>${Math.abs(share) >= 0.005 ? Math.round(100 * share) : ''}</td>`) : html`<td class="words">${largestShares(modes, m)}</td>`}</tr>`;
      })}</tbody></table>${one ? html`<p class="hint">x … θz in %: ${modes.modes.some(m => m.kinetic_energy_share!.some(isCoupled)) ? words : 'shares of the kinetic energy'}.</p>` : nothing}${this.energies(modes)}`;
  }
  private inView: ReadonlySet<number> | null = null;  // rows that are seen; null: not known yet
  private rows: readonly Mode[] = [];  // as they are on the page

  /// While numbers move, only rows that are seen follow at once: the table of sixty modes would be laid out again at each step.
  private modesInView({modes}: Modes): readonly Mode[] {
    const keeps = this.numbersMove && this.inView && this.rows.length === modes.length;
    this.rows = keeps ? modes.map((mode, i) => (this.inView!.has(i) ? mode : this.rows[i]!)) : modes;
    return this.rows;
  }
  private get numbersMove() { return this.app.asker.isOld('curves') && !this.app.asker.hasErrors; }
  override updated() {
    if (!this.numbersMove && this.rows.length > MOST_LIVE) this.look();
  }
  private look() {
    const panel = this.querySelector('#table-panel')!, {top, bottom} = panel.getBoundingClientRect();
    this.inView = new Set([...panel.querySelectorAll('tbody tr')].flatMap((row, i) => {
      const box = row.getBoundingClientRect();
      return box.bottom >= top && box.top <= bottom ? [i] : [];
    }));
  }
  private scrolled() {
    if (this.rows.length <= MOST_LIVE) return;
    this.look();
    this.requestUpdate();
  }
  /// In which elements the chosen mode stores its energy.
  private energies(modes: Modes) {
    const {shown} = this.app.display, mode = shown.kind === 'mode' ? modes.modes.find(m => m.number === shown.number) : undefined;
    if (!mode) return nothing;
    const shares = modes.elements.map((name, i) => ({name, share: mode.strain_energy_share?.[i] ?? 0})).filter(e => Math.abs(e.share) >= 0.005).sort((a, b) => b.share - a.share);
    return html`<p class="hint">Mode ${mode.number}: ${mode.name}. Strain energy: ${shares.map(e => `${e.name} ${number(100 * e.share, 3)} %`).join(', ') || '–'}.</p>`;
  }
  private requirements() {
    const {asker, state} = this.app, verdict = asker.result<Verdict>('verdict');
    if (!hasSomethingToJudge(this.app)) return html`<p class="hint">The file has no [requirements], [limits] or limit lines. With them every design is judged here, with its margins.</p>`;
    if (!verdict) return this.missing('verdict');
    const found = verdict.cases.find(c => c.case === state.case) ?? verdict.cases[0];
    const sorted = [...found?.requirements ?? []].sort((a, b) => (a.margin ?? Infinity) - (b.margin ?? Infinity));
    const old = asker.isOld('verdict') ? html` <span class="old">…</span>` : nothing, binding = found?.decides !== false;
    const several = verdict.cases.length > 1, numbers = sorted.some(r => r.place.length);
    return html`<table class="requirements">${binding ? nothing : html`<caption>The requirements are not binding in this case.</caption>`}<thead><tr><th scope="col">Requirement</th><th scope="col" class="value">value${numbers ? ', limit' : ''}</th><th scope="col" class="margin" title="1: just met; more: met with room">margin</th>${several ? html`<th scope="col" class="elsewhere" title="least margin of all other cases">elsewhere</th>` : nothing}<th scope="col" class="met">met</th></tr></thead><tbody>
      ${sorted.map(r => html`<tr class=${!r.judged ? 'unjudged' : r.met ? '' : binding ? 'violated' : 'unbinding'}><th scope="row" class="words">${r.shown_requirement ?? r.requirement}</th><td>${r.judged ? this.judged(r) : r.reason || '–'}${this.limit(r)}</td>
        <td>${r.margin === null ? '–' : number(r.margin, 3)}${old}</td>${several ? html`<td>${this.elsewhere(verdict, r)}</td>` : nothing}<td>${!r.judged ? '–' : r.met ? '✓' : binding ? '✗' : '(✗)'}<span class="hidden">${r.met ? 'yes' : binding ? 'no' : 'no, not binding'}</span></td></tr>`)}</tbody></table>`;
  }
  /// The number of a limit, to be changed here too.
  private limit(r: Requirement) {
    const {state, index} = this.app, found = r.place.length ? limitNumber(r.place, state.case, state.design, index) : null;
    if (!found) return '';
    const valid = `${number(found.value, 6)} ${found.unit}`.trim();
    return html`<input class="number" aria-label="Limit: ${r.shown_requirement ?? r.requirement}" .value=${valid} @change=${(e: Event) => {
      const input = e.target as HTMLInputElement, typed = quantity(input.value.replaceAll('−', '-').replace(',', '.'));
      if (typed && typed.value > 0) setLimit(state, {...found, unit: typed.unit || found.unit}, typed.value);
      else refuse(input, this.app, valid, 'a number above 0');
    }}>`;
  }
  /// The least margin of the same requirement in the other cases, with the case; first of those that violate it and are binding.
  private elsewhere({cases}: Verdict, {kind, subject, requirement}: Requirement) {
    const others = cases.filter(c => c.case !== this.app.state.case).flatMap(c => c.requirements.filter(r => r.kind === kind && r.subject === subject && r.requirement === requirement && r.judged && r.margin !== null).map(r => ({in: c.case, binding: c.decides, r})));
    const decide = others.filter(o => o.binding && !o.r.met), told = [...decide.length ? decide : others].sort((a, b) => a.r.margin! - b.r.margin! || Number(b.binding) - Number(a.binding));
    const least = told[0];
    if (!least) return '–';
    return html`<span class=${violatedClass(least.r, least.binding)}>${number(least.r.margin, 3)} ${least.in || 'base model'}${least.r.met || least.binding ? '' : ', not binding'}</span>`;
  }
  private mounts() {
    const {asker, state} = this.app, check = asker.result<Check>('check'), all = check?.mounts ?? [], own = all.filter(m => m.case === state.case);
    const rows = own.length ? own : all.filter(m => m.case === '');  // a case is listed only if it differs from the base model
    const verdict = asker.result<Verdict>('verdict')?.cases.find(c => c.case === state.case), judged = (verdict?.requirements ?? []).filter(r => r.kind === 'mount_load' && r.judged);
    if (!check) return this.missing('check');
    if (!rows.length) return html`<p class="hint">No load at rest: the file has no gravity, or no mount that carries a load.</p>`;
    return html`<table><caption>At rest under gravity</caption><thead><tr><th scope="col">Mount</th><th scope="col">compression</th><th scope="col">across</th><th scope="col">deflection</th>${judged.length ? html`<th scope="col" title="of its load range in the catalogue; 1: just met">margin of load${verdict!.decides ? '' : ', not binding'}</th>` : nothing}</tr></thead><tbody>
      ${rows.map(m => {
        const chosen = state.selection?.kind === 'element' && state.selection.name === m.element;
        return html`<tr class=${chosen ? 'chosen' : ''} @click=${() => state.select({kind: 'element', name: m.element})}><th scope="row"><button class="link">${m.element}</button></th>
          <td>${withUnit(m.compression, 'N')}</td><td>${withUnit(m.across, 'N')}</td><td>${withUnit(m.deflection, 'm')}</td>
          ${judged.length ? html`<td>${judged.filter(r => r.subject === m.element).map(r => html`<span class=${violatedClass(r, verdict!.decides)}>${r.margin === null ? '–' : number(r.margin, 3)}</span>`)}</td>` : nothing}</tr>`;
      })}</tbody></table>`;
  }
  private peaks() {
    const {asker, display, engine} = this.app, curves = asker.result<Curves>('curves');
    if (!curves) return html`<p class="hint">${missingCurves(this.app)}</p>`;
    const of = new Map(curves.results.map(r => [r.name, r]));
    const rows = curves.peaks.filter(p => p.angular_frequency >= curves.band[0] && p.angular_frequency <= curves.band[1]);
    const show = ({angular_frequency: omega}: Peak) => {
      display.set({cursor: omega, ...(engine.isLive ? {shown: {kind: 'frequency', omega}} : {})});
      asker.again();
    };
    return html`<table><thead><tr><th scope="col">Result</th><th scope="col">${display.frequencyUnit}</th><th scope="col">amplitude</th><th scope="col">phase</th></tr></thead><tbody>
      ${rows.map(p => html`<tr @click=${() => show(p)}>
        <th scope="row">${engine.isLive ? html`<button class="link" aria-label="Show the motion at this peak of ${p.result}">${p.result}</button>` : p.result}</th><td>${frequency(p.angular_frequency, display.frequencyUnit).split(' ')[0]}</td>
        <td>${p.amplitude === null ? '∞' : amplitude(p.amplitude, of.get(p.result))}</td><td>${p.phase == null ? '–' : `${number(Math.round(p.phase * 18e6 / Math.PI) / 1e5, 3)}°`}</td></tr>`)}</tbody></table>${asker.notes('curves').map(note => html`<p class="hint">${note}</p>`)}`;
  }
  private judged = (r: Requirement) => (r.unit !== 'rad/s' && r.shown_value ? r.shown_value : this.value(r.value, r.unit));
  private value(value: number | null, unit: string) {
    if (unit === 'rad/s') return frequency(value, this.app.display.frequencyUnit, 3);
    return unit === '1' ? number(value, 3) : withUnit(value, unit, 3);
  }
  private missing(command: string) {
    return html`<p class="hint">${this.app.asker.missing(command)}</p>`;
  }
}
const MOST_LIVE = 12;  // rows that all follow at once
/// Is a share of a single coordinate below 0 or above 100 %, as it is shown?
const isCoupled = (share: number) => share <= -0.005 || share >= 1.005;
/// A violation is red only where the requirements are binding.
const violatedClass = ({met}: Requirement, binding: boolean) => (met ? '' : binding ? 'bad' : 'minor');
/// "1.07 mm/s rms"
function amplitude(value: number, result: Curves['results'][number] | undefined): string {
  const scale = scaleAtLevel(value, result?.unit ?? '', result);
  return `${number(value * scale.factor)} ${scale.unit}`.trim();
}
/// "frame 81 %, axle 12 %": shares of the bodies.
function largestShares(modes: Modes, mode: Mode): string {
  const ofBodies = modes.bodies.map((name, i) => ({name, share: mode.body_kinetic_energy_share[i]!}));
  return ofBodies.filter(b => b.share >= 0.05).sort((a, b) => b.share - a.share).slice(0, 3).map(b => `${b.name} ${Math.round(100 * b.share)} %`).join(', ');
}
customElements.define('result-tables', ResultTables);
