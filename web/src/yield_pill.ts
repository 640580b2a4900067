// SPDX-License-Identifier: BSD-3-Clause
import {html, nothing} from 'lit';
import {Part} from './part.ts';
import type {Sample} from './results.ts';
import {FEW, MOST, sampledDesigns, sampleFailure, sampleWishes} from './sampled_designs.ts';

/// The share of the machines within the tolerances that meet every requirement, beside the verdict on the design.
export class YieldPill extends Part {
  override connectedCallback() {
    super.connectedCallback();
    const {sampler} = this.app;
    if (sampler) this.unsubscribe.push(sampler.subscribe(() => this.requestUpdate()));
  }
  override render() {
    const {app} = this, sampled = sampledDesigns(app), failure = sampleFailure(app);
    if (failure) return html`<span class="pill unjudged" title=${failure}>no yield</span>`;
    if (!sampled) return app.sampler && !app.sampler.hasErrors && sampleWishes(app).length ? html`<span class="pill unknown">yield <span class="old">…</span></span>` : nothing;
    const {found, old, wanted} = sampled, {share, range} = yieldWords(found), designs = count(found.designs);
    const style = found.held === undefined ? '' : found.held === null ? 'unjudged' : found.held ? 'met' : 'violated';
    return html`<span class="pill yield ${style}" title=${this.explained(found, wanted)}>yield <b>${share} %</b> <span class="interval">${range ? `${range}, ` : ''}${designs} designs</span>${old ? html` <span class="old">…</span>` : nothing}</span>`;
  }
  private explained({designs, confidence, failed, wanted: yieldWanted, held}: Sample, wanted: number): string {
    const of = designs < wanted ? `the first ${count(designs)} of the ${count(wanted)} machines` : `${count(designs)} machines`;
    const more = designs === FEW && wanted > FEW ? ` More, at most ${count(MOST)}, are judged when nothing moves, if kernels judge them.` : designs < wanted ? ' trivet sample judges all of them.' : '';
    const verdict = held === undefined ? '' : ` ${held ? 'At least' : held === null ? 'Not certainly' : 'Less than'} the wanted ${+(100 * yieldWanted!).toPrecision(6)} %.`;
    return `Share of ${of} within [tolerances] that meet every requirement, and its interval with ${Math.round(100 * confidence)} % confidence.${verdict}${failed ? ` ${count(failed)} could not be judged and count as failed.` : ''}${more}`;
  }
}
const count = (n: number) => n.toLocaleString('en-US');

/// In %, with two digits of what is not known, as `trivet sample` has it: without violations the bound of one side.
export function yieldWords({designs, confidence, yield: {share, from, to, met}}: Pick<Sample, 'yield' | 'designs' | 'confidence'>): {share: string; range: string} {
  const bound = (1 - confidence) ** (1 / designs), digits = decimals(met === designs || met === 0 ? 1 - bound : Math.max(to - share, share - from)), unit = 10 ** digits;
  const shown = (part: number, round: (n: number) => number) => (round(100 * part * unit) / unit).toFixed(digits);
  if (met === designs) return {share: `≥ ${shown(bound, Math.floor)}`, range: ''};
  if (met === 0) return {share: `≤ ${shown(1 - bound, Math.ceil)}`, range: ''};
  return {share: shown(share, Math.round), range: `${shown(from, Math.round)} … ${shown(to, Math.round)} %`};
}
const decimals = (unsure: number) => (unsure > 0 ? Math.min(Math.max(1 - Math.floor(Math.log10(100 * unsure)), 0), 9) : 1);
customElements.define('yield-pill', YieldPill);
