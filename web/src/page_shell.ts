// SPDX-License-Identifier: BSD-3-Clause
import {html, nothing} from 'lit';
import './case_bar.ts';
import './curve_chart.ts';
import './empty_state.ts';
import './file_notice.ts';
import './machine_view.ts';
import './model_tree.ts';
import './problem_list.ts';
import './progress_line.ts';
import './result_tables.ts';
import './slider_panel.ts';
import './text_view.ts';
import type {Display} from './display.ts';
import {downloadProject} from './download.ts';
import type {Example} from './engine.ts';
import {Part} from './part.ts';
import type {ProblemList} from './problem_list.ts';
import type {KeptEdits} from './project_file.ts';
import type {Scene} from './results.ts';
import {verdictPill} from './verdict_pill.ts';
import './yield_pill.ts';

const TABS = {sliders: 'Sliders', model: 'Model', text: 'Text'} as const;

/// The whole page: verdict, picture and sliders first, text last.
export class PageShell extends Part {
  static override properties = {...Part.properties, opened: {state: true}};
  declare opened: boolean;

  constructor() {
    super();
    this.opened = false;
  }
  override connectedCallback() {
    super.connectedCallback();
    this.opened = this.app.state.design.text !== '' || this.app.project.name !== null;
    addEventListener('keydown', event => this.key(event));
    addEventListener('beforeunload', event => { if (this.opened && !this.app.state.isSaved || this.app.file!.left.length) event.preventDefault(); });
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
      <main class="empty"><empty-state .app=${app} .examples=${project.examples ?? []} .open=${(e: Example) => this.openExample(e)} .reopen=${(one: KeptEdits) => this.reopen(one)}></empty-state></main>`;
    return html`<header>${this.brand()}${this.heading()}</header>
      <problem-list .app=${app}></problem-list>
      <file-notice .app=${app}></file-notice>
      ${app.state.design.text ? this.parts() : html`<main class="empty"></main>`}
      <p class="toast" role="status" ?hidden=${!display.notice}>${display.notice}${display.listed && display.listed === display.notice ? html` <button class="link" @click=${() => this.querySelector<ProblemList>('problem-list')?.show()}>Show them</button>` : nothing}</p>`;
  }
  private parts() {
    const {app} = this, {display} = app;
    return html`<main class="tab-${display.leftTab}">
        <section class="left" aria-label="Model and parameters">
          <div class="tabs" role="tablist" aria-label="Model">${(Object.keys(TABS) as Display['leftTab'][]).map(t => html`<button role="tab" id="left-${t}" aria-controls="left-panel" aria-selected=${t === display.leftTab} @click=${() => display.set({leftTab: t})}>${TABS[t]}</button>`)}</div>
          <div class="scroll panel" role="tabpanel" id="left-panel" aria-labelledby="left-${display.leftTab}">${this.leftPanel()}</div>
        </section>
        <section class="middle" aria-label="Machine"><machine-view .app=${app}></machine-view></section>
        <section class="right" aria-label="Results"><curve-chart .app=${app}></curve-chart><result-tables .app=${app}></result-tables></section>
      </main>`;
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
    const {state, asker, project} = this.app;
    const title = asker.result<Scene>('scene')?.title || project.title || '';
    return html`<span class="title" title=${title}>${title}</span>
      <case-bar .app=${this.app}></case-bar>
      ${verdictPill(this.app)}<yield-pill .app=${this.app}></yield-pill>
      <progress-line .app=${this.app}></progress-line>
      <span class="space"></span>
      <button title="Undo (Ctrl Z)" aria-label="Undo" ?disabled=${!state.canUndo} @click=${() => state.undo()}>↶</button>
      <button title="Redo (Ctrl Y)" aria-label="Redo" ?disabled=${!state.canRedo} @click=${() => state.redo()}>↷</button>
      <button title="Save (Ctrl S)" class=${state.isSaved ? '' : 'unsaved'} ?disabled=${state.isSaved || project.read_only === true} @click=${() => this.save()}>${project.read_only ? 'Read only' : 'Save'}</button>
      ${project.name === null ? html`<button title="Back to the examples" @click=${() => this.leave()}>Examples</button>` : nothing}
      ${this.themeButton()}`;
  }
  private leave() {
    this.opened = false;
    this.app.file!.leave();
  }
  private themeButton() {
    const {display} = this.app, other = display.theme === 'dark' ? 'light' : 'dark';
    return html`<button title="${other} colours" aria-label="Use ${other} colours" @click=${() => display.set({theme: other})}>${other === 'dark' ? '☾' : '☀'}</button>`;
  }
  private openExample(example: Example) {
    this.opened = true;
    this.app.state.open(example.text, null);
  }
  private reopen(one: KeptEdits) {
    this.opened = true;
    this.app.file!.reopen(one);
  }
  /// Writes the file; a machine without a file becomes a download.
  private async save() {
    const text = await this.app.file!.save();
    if (text !== null) downloadProject('machine.toml', text);
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
customElements.define('page-shell', PageShell);
