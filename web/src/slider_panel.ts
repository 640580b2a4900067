// SPDX-License-Identifier: BSD-3-Clause
import {html, nothing} from 'lit';
import {Part} from './part.ts';
import {errorAbout, idOf, ruleOf} from './problem_words.ts';
import {refuse} from './refused_number.ts';
import {number, quantity} from './quantities.ts';
import type {Scene} from './results.ts';
import {settingsOf, sliders, type Slider} from './slider_list.ts';

const STEPS = 1000;

/// Sliders of the parameters. Everything else on the page follows while one moves.
export class SliderPanel extends Part {
  override render() {
    const {state, display, asker} = this.app;
    this.machine = asker.result<Scene>('scene') ?? this.machine;
    const all = sliders(state.design, this.app.index, display.pins, state.case, this.machine);
    return html`<ul class="sliders">${all.map(s => this.row(s))}</ul>
      ${all.length || !this.machine ? nothing : html`<p class="hint">The file has no number that a slider could move. Add [parameters], or pin a number in the model.</p>`}
      <p class="hint">${display.pins.length ? nothing : 'More sliders: ⊕ beside a number of the model, or [parameters] in the file.'}</p>`;
  }
  private machine: Scene | null = null;  // also while the next one is computed, and while the file has errors

  private row(s: Slider) {
    const position = positionOf(s, s.value), isSet = s.paths.some(p => this.app.state.design.settings.has(p.path));
    const wrong = errorAbout(s.paths.map(p => p.path), this.app.asker.problems), isWrong = wrong >= 0;
    const pinned = this.app.display.pins.includes(s.name);
    return html`<li class=${isSet ? 'changed' : ''}>
      <label title=${s.paths.map(p => p.path).join('\n')}><span>${s.name}</span>
        <input type="range" min="0" max=${STEPS} .value=${String(position)} aria-valuetext=${s.written ?? `${number(s.value)} ${s.unit}`}
          @input=${(e: Event) => this.move(s, (e.target as HTMLInputElement).value, true)} @change=${() => this.app.state.dropped()}></label>
      <input class="number" aria-label="${s.name}, value" aria-invalid=${isWrong ? 'true' : nothing} aria-describedby=${isWrong ? idOf(wrong) : nothing} .value=${shown(s)}
        @change=${(e: Event) => this.type(s, e.target as HTMLInputElement)}>
      ${isWrong ? html`<small class="wrong">${ruleOf(this.app.asker.problems[wrong]!)}</small>` : nothing}
      ${s.paths.some(p => p.path.startsWith('cases.')) && !s.name.startsWith('cases.') ? html`<small class="hint">of case ${this.app.state.case}</small>` : nothing}
      ${pinned ? html`<button title="Remove the slider" @click=${() => this.app.display.set({pins: this.app.display.pins.filter(p => p !== s.name)})}>×</button>` : nothing}
    </li>`;
  }
  private move(s: Slider, position: string, drag: boolean) {
    const part = Number(position) / STEPS, value = s.logarithmic ? s.from * (s.to / s.from) ** part : s.from + part * (s.to - s.from);
    this.app.state.set(settingsOf(s, value), drag);
  }
  /// A typed number has the unit of the slider, or its own.
  private type(s: Slider, input: HTMLInputElement) {
    const typed = quantity(input.value.replaceAll('−', '-').replace(',', '.'));
    if (!typed) return refuse(input, this.app, shown(s));
    this.app.state.set(settingsOf({...s, unit: typed.unit || s.unit}, typed.value));
  }
}
const shown = ({value, unit, written}: Slider) => written ?? `${number(value, 5)}${unit ? ` ${unit}` : ''}`;

function positionOf({from, to, logarithmic}: Slider, value: number): number {
  const part = logarithmic ? Math.log(value / from) / Math.log(to / from) : (value - from) / (to - from);
  return Math.round(STEPS * Math.min(Math.max(part || 0, 0), 1));
}
customElements.define('slider-panel', SliderPanel);
