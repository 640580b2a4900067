// SPDX-License-Identifier: BSD-3-Clause
import {html} from 'lit';
import {caseMenu} from './case_menu.ts';
import {EngineError} from './engine.ts';
import {Part} from './part.ts';

/// The case on the page, and a new one like it.
export class CaseBar extends Part {
  static override properties = {...Part.properties, naming: {state: true}};
  declare naming: boolean;

  constructor() {
    super();
    this.naming = false;
  }
  override render() {
    return html`${caseMenu(this.app)}
      ${this.naming ? html`<form @submit=${this.create} @keydown=${(e: KeyboardEvent) => { if (e.key === 'Escape') this.naming = false; }}>
        <input name="name" required maxlength="60" aria-label="Name of the new case" placeholder="name"><button>Create</button></form>`
      : html`<button title="New case: the changes of this one and of the moved sliders" aria-label="New case like this one" @click=${this.begin}>+ case</button>`}`;
  }
  private async begin() {
    this.naming = true;
    await this.updateComplete;
    this.querySelector('input')?.focus();
  }
  /// The program writes it into the text: the sliders that were moved belong to the new case then.
  private async create(event: SubmitEvent) {
    event.preventDefault();
    const {state, engine, display} = this.app, name = String(new FormData(event.target as HTMLFormElement).get('name')).trim();
    const {design} = state;
    try {
      const text = await engine.newCase(state.change, name);
      if (state.design !== design) return display.set({notice: 'The model was changed meanwhile: create the case again.'});
      this.naming = false;
      state.put({text, settings: new Map()}, name);
    } catch (error) {
      display.set({notice: error instanceof EngineError ? error.message : String(error)});
    }
  }
}
customElements.define('case-bar', CaseBar);
