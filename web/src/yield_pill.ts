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
    const {found, old, wanted} = sampled, {shown_share: share, shown_interval: interval} = found.yield, designs = count(found.designs);
    const style = found.held === undefined ? '' : found.held === null ? 'unjudged' : found.held ? 'met' : 'violated';
    return html`<span class="pill yield ${style}" title=${this.explained(found, wanted)}>yield <b>${share}</b> <span class="interval">${interval ? `${interval}, ` : ''}${designs} designs</span>${old ? html` <span class="old">…</span>` : nothing}</span>`;
  }
  private explained({designs, confidence, failed, wanted: yieldWanted, held}: Sample, wanted: number): string {
    const of = designs < wanted ? `the first ${count(designs)} of the ${count(wanted)} machines` : `${count(designs)} machines`;
    const more = designs === FEW && wanted > FEW ? ` More, at most ${count(MOST)}, are judged when nothing moves, if kernels judge them.` : designs < wanted ? ' trivet sample judges all of them.' : '';
    const verdict = held === undefined ? '' : ` ${held ? 'At least' : held === null ? 'Not certainly' : 'Less than'} the wanted ${+(100 * yieldWanted!).toPrecision(6)} %.`;
    return `Share of ${of} within [tolerances] that meet every requirement, and its interval with ${Math.round(100 * confidence)} % confidence.${verdict}${failed ? ` ${count(failed)} could not be judged and count as failed.` : ''}${more}`;
  }
}
const count = (n: number) => n.toLocaleString('en-US');
customElements.define('yield-pill', YieldPill);
