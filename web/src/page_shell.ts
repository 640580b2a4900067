// SPDX-License-Identifier: BSD-3-Clause
import {html, nothing} from 'lit';
import './curve_chart.ts';
import './empty_state.ts';
import './machine_view.ts';
import './model_tree.ts';
import './problem_list.ts';
import './result_tables.ts';
import './slider_panel.ts';
import './text_view.ts';
import type {Display} from './display.ts';
import {EngineError, type Example} from './engine.ts';
import {judgement} from './judgement.ts';
import {Part} from './part.ts';
import type {Scene} from './results.ts';

const TABS = {sliders: 'Sliders', model: 'Model', text: 'Text'} as const;

/// The whole page: verdict, picture and sliders first, text last.
export class PageShell extends Part {
  static override properties = {...Part.properties, conflict: {state: true}, opened: {state: true}};
  declare conflict: {version: string; text: string} | null;
  declare opened: boolean;
  private version = '';

  constructor() {
    super();
    [this.conflict, this.opened] = [null, false];
  }
  override connectedCallback() {
    super.connectedCallback();
    const {project} = this.app;
    this.opened = project.name !== null;
    this.version = project.version ?? '';
    addEventListener('keydown', event => this.key(event));
    addEventListener('beforeunload', event => { if (this.opened && !this.app.state.isSaved) event.preventDefault(); });
  }
  /// A notice goes away when it was read.
  override updated() {
    const {display} = this.app, {notice} = display;
    if (!notice || notice === this.timed) return;
    this.timed = notice;
    setTimeout(() => {
      this.timed = '';
      if (display.notice === notice) display.set({notice: ''});
    }, 2000 + 60 * notice.length);
  }
  private timed = '';

  override render() {
    const {app} = this, {display, project} = app;
    document.documentElement.dataset['theme'] = display.theme;
    if (!this.opened) return html`<header>${this.brand()}<span class="space"></span>${this.themeButton()}</header>
      <main class="empty"><empty-state .app=${app} .examples=${project.examples ?? []} .open=${(e: Example) => this.openExample(e)}></empty-state></main>`;
    return html`<header>${this.brand()}${this.heading()}</header>
      <problem-list .app=${app}></problem-list>
      ${this.conflict ? this.conflictBox(this.conflict) : nothing}
      <main class="tab-${display.leftTab}">
        <section class="left" aria-label="Model and parameters">
          <div class="tabs" role="tablist" aria-label="Model">${(Object.keys(TABS) as Display['leftTab'][]).map(t => html`<button role="tab" id="left-${t}" aria-controls="left-panel" aria-selected=${t === display.leftTab} @click=${() => display.set({leftTab: t})}>${TABS[t]}</button>`)}</div>
          <div class="scroll panel" role="tabpanel" id="left-panel" aria-labelledby="left-${display.leftTab}">${this.leftPanel()}</div>
        </section>
        <section class="middle" aria-label="Machine"><machine-view .app=${app}></machine-view></section>
        <section class="right" aria-label="Results"><curve-chart .app=${app}></curve-chart><result-tables .app=${app}></result-tables></section>
      </main>
      <p class="toast" role="status" ?hidden=${!display.notice}>${display.notice}</p>`;
  }
  private leftPanel() {
    const {app} = this;
    switch (app.display.leftTab) {
      case 'sliders': return html`<slider-panel .app=${app}></slider-panel>`;
      case 'model': return html`<model-tree .app=${app}></model-tree>`;
      case 'text': return html`<text-view .app=${app}></text-view>`;
    }
  }
  private brand() { return html`<h1>Trivet</h1>`; }
  private heading() {
    const {state, asker, project} = this.app, said = judgement(this.app), {cases} = this.app;
    const title = asker.result<Scene>('scene')?.title || project.title || '';
    return html`<span class="title" title=${title}>${title}</span>
      ${cases.length > 1 ? html`<select aria-label="Case" @change=${(e: Event) => state.chooseCase((e.target as HTMLSelectElement).value)}>
        ${cases.map(c => html`<option value=${c} ?selected=${c === state.case}>${c || 'base model'}</option>`)}</select>` : nothing}
      <span class="pill ${said.state}" role="status">${SIGNS[said.state]} ${said.words}${said.old ? ' …' : ''}</span>
      <span class="space"></span>
      <button title="Undo (Ctrl Z)" aria-label="Undo" ?disabled=${!state.canUndo} @click=${() => state.undo()}>↶</button>
      <button title="Redo (Ctrl Y)" aria-label="Redo" ?disabled=${!state.canRedo} @click=${() => state.redo()}>↷</button>
      <button title="Save (Ctrl S)" class=${state.isSaved ? '' : 'unsaved'} ?disabled=${state.isSaved || project.read_only === true} @click=${() => this.save()}>${project.read_only ? 'Read only' : 'Save'}</button>
      ${this.themeButton()}`;
  }
  private themeButton() {
    const {display} = this.app, other = display.theme === 'dark' ? 'light' : 'dark';
    return html`<button title="${other} colours" aria-label="Use ${other} colours" @click=${() => display.set({theme: other})}>${other === 'dark' ? '☾' : '☀'}</button>`;
  }
  private conflictBox({version, text}: {version: string; text: string}) {
    return html`<div class="problems error" role="alertdialog" aria-label="The file was changed"><p>Another program changed the file on the disk since you opened it. Nothing was written.</p>
      <details><summary>Text on the disk</summary><pre tabindex="0">${text}</pre></details>
      <button @click=${() => { this.version = version; this.conflict = null; this.app.state.open(text, true); }}>Open the text on the disk</button>
      <button @click=${() => { this.version = version; this.conflict = null; void this.save(); }}>Overwrite it with mine</button>
      <button @click=${() => { this.conflict = null; }}>Cancel</button></div>`;
  }
  private openExample(example: Example) {
    this.opened = true;
    this.app.state.open(example.text, false);
  }
  /// Writes the file; a machine without a file becomes a download.
  private async save() {
    const {state, engine, project} = this.app, {change} = state;
    try {
      const text = state.design.settings.size ? await engine.text(change) : state.design.text;
      if (project.name === null) return this.download(text);
      const saved = await engine.save(this.version, change);
      if (saved.conflict) this.conflict = saved;
      else {
        this.version = saved.version;
        state.wasSaved(text);
        this.app.display.set({notice: `${project.name} is saved.`});
      }
    } catch (error) {
      this.app.display.set({notice: error instanceof EngineError ? error.message : String(error)});
    }
  }
  private download(text: string) {
    const link = document.createElement('a');
    link.href = URL.createObjectURL(new Blob([text], {type: 'application/toml'}));
    link.download = 'machine.toml';
    link.click();
    URL.revokeObjectURL(link.href);
  }
  private key(event: KeyboardEvent) {
    if (!(event.ctrlKey || event.metaKey) || !this.opened) return;
    const inText = (event.target as HTMLElement).tagName === 'TEXT-VIEW', {state} = this.app;
    if (event.key === 's') void (state.isSaved || this.app.project.read_only ? undefined : this.save());
    else if (event.key === 'z' && !event.shiftKey && !inText) state.undo();
    else if ((event.key === 'y' || event.key === 'Z' && event.shiftKey) && !inText) state.redo();
    else return;
    event.preventDefault();
  }
}
const SIGNS = {met: '✓', violated: '✗', none: '○', error: '!', unknown: '…'};
customElements.define('page-shell', PageShell);
