// SPDX-License-Identifier: BSD-3-Clause
import {html, nothing} from 'lit';
import type {CatalogueMount, Example} from './engine.ts';
import {newMachine, OF_A_MOUNT, QUESTIONS, wrongNumber, type Numbers, type Question} from './new_machine.ts';
import {indexOf} from './numbers_of_text.ts';
import {Part} from './part.ts';
import type {KeptEdits} from './project_file.ts';
import {number} from './quantities.ts';

/// What is there without a file: three machines to play with, a form for a new one, and how to begin.
export class EmptyState extends Part {
  static override properties = {...Part.properties, examples: {attribute: false}, open: {attribute: false}, reopen: {attribute: false}, wrong: {state: true}, mount: {state: true}};
  declare examples: readonly Example[];
  declare open: (example: Example) => void;
  declare reopen: (one: KeptEdits) => void;
  declare wrong: string;
  declare mount: string;  // of the generic catalogue; empty: by its stiffness

  constructor() {
    super();
    [this.wrong, this.mount] = ['', ''];
  }
  override render() {
    const left = this.app.file?.left ?? [];
    return html`${left.length ? html`<h2>Go on with yours</h2>
      <p>They are kept in this tab alone until you save them.</p>
      <ul class="examples left">${left.map(one => html`<li><button @click=${() => this.reopen(one)}><b>${titleOf(one.text)}</b><span>not saved</span></button></li>`)}</ul>` : nothing}
      <h2>Begin with a machine</h2>
      <p>Open one, drag a slider, and see how it moves. Nothing is written to your disk until you save it.</p>
      <ul class="examples">${this.examples.map(example => html`<li><button @click=${() => this.open(example)}><b>${example.title}</b><span>${example.name}</span></button></li>`)}</ul>
      <h2>Or describe yours</h2>
      <form @submit=${this.create}>
        <label>Name<input name="title" value="New machine"></label>
        <label>Mounts<select name="mount" aria-label="Mounts" @change=${(e: Event) => { this.mount = (e.target as HTMLSelectElement).value; }}>
          <option value="">by their stiffness</option>
          ${(this.app.project.mounts ?? []).map(mount => html`<option value=${mount.name}>${described(mount)}</option>`)}</select></label>
        ${(Object.entries(QUESTIONS) as [Question, (typeof QUESTIONS)[Question]][]).filter(([name]) => !this.mount || !OF_A_MOUNT.includes(name)).map(([name, q]) => html`<label>${q.label}${q.unit ? ` [${q.unit}]` : ''}<input name=${name} inputmode="decimal" value=${q.value}></label>`)}
        <button class="unsaved">Make it</button>
        ${this.wrong ? html`<p role="alert" class="wrong">${this.wrong}</p>` : nothing}
      </form>
      <p>With your own file: <code>trivet serve machine.toml</code>. A commented file to start from: <code>trivet new machine.toml</code>.</p>`;
  }
  private create(event: SubmitEvent) {
    event.preventDefault();
    const data = new FormData(event.target as HTMLFormElement);
    const numbers = Object.fromEntries(Object.keys(QUESTIONS).map(name => [name, Number(String(data.get(name) ?? '').replace(',', '.'))])) as Numbers;
    this.wrong = wrongNumber(numbers, this.mount);
    if (!this.wrong) this.open({name: 'machine.toml', title: '', text: newMachine(String(data.get('title')), numbers, this.mount)});
  }
}
const titleOf = (text: string) => (indexOf(text).byPath.get('title')?.raw ?? 'machine without a title').replace(/^["']|["']$/g, '').replace(/\\(["\\])/g, '$1');
const described = ({name, stiffness, static_load: load}: CatalogueMount) =>
  `${name}: ${number(stiffness[2] / 1e3)} N/mm${load ? `, up to ${number(load[1])} N` : ''}`;
customElements.define('empty-state', EmptyState);
