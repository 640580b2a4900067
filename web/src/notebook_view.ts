// SPDX-License-Identifier: BSD-3-Clause
import {html, nothing} from 'lit';
import {keyed} from 'lit/directives/keyed.js';
import './curve_chart.ts';
import './machine_view.ts';
import './problem_list.ts';
import './result_tables.ts';
import './slider_panel.ts';
import {caseMenu} from './case_menu.ts';
import {Part} from './part.ts';
import type {Scene} from './results.ts';
import {verdictPill} from './verdict_pill.ts';

/// The machine and its results in a notebook, with sliders as long as a kernel computes.
export class NotebookView extends Part {
  static override properties = {...Part.properties, times: {state: true}};
  declare times: number;

  constructor() {
    super();
    this.times = 0;
  }
  /// A notebook takes cells out of the document and puts them back. Parts that drew are then made again.
  override connectedCallback() {
    super.connectedCallback();
    this.times++;
  }
  override render() {
    const {app} = this, {state, asker, project, display, engine} = app;
    const title = asker.result<Scene>('scene')?.title || project.title || '', root = this.getRootNode();
    if (root instanceof ShadowRoot) (root.host as HTMLElement).dataset['theme'] = display.theme;
    return html`<header>
        <span class="title" title=${title}>${title}</span>
        ${engine.isLive ? caseMenu(app) : state.case ? html`<span>${state.case}</span>` : nothing}
        ${verdictPill(app)}<span class="space"></span>
        ${engine.isLive ? html`<button title="Undo" aria-label="Undo" ?disabled=${!state.canUndo} @click=${() => state.undo()}>↶</button>
          <button title="Redo" aria-label="Redo" ?disabled=${!state.canRedo} @click=${() => state.redo()}>↷</button>` : html`<span class="note">as it was last computed</span>`}
      </header>
      <problem-list .app=${app}></problem-list>
      ${engine.isLive ? html`<section aria-label="Sliders"><slider-panel .app=${app}></slider-panel></section>` : nothing}
      ${keyed(this.times, html`<main>
        <section class="middle" aria-label="Machine"><machine-view .app=${app}></machine-view></section>
        <section class="right" aria-label="Results"><curve-chart .app=${app}></curve-chart><result-tables .app=${app}></result-tables></section>
      </main>`)}`;
  }
}
customElements.define('notebook-view', NotebookView);
