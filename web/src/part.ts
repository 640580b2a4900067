// SPDX-License-Identifier: BSD-3-Clause
import {LitElement} from 'lit';
import type {Asker} from './asker.ts';
import type {BesideResults} from './beside.ts';
import type {Display} from './display.ts';
import type {Engine, Project} from './engine.ts';
import {casesOf, type TextIndex} from './numbers_of_text.ts';
import type {ProjectFile} from './project_file.ts';
import type {Schema} from './schema.ts';
import type {State} from './state.ts';

/// What all parts of the page share.
export class App {
  schema: Schema | null = null;
  file: ProjectFile | null = null;  // a notebook has none

  /// @param sampler  keeps the sample of machines within the tolerances; a notebook has none
  constructor(readonly engine: Engine, readonly project: Project, readonly state: State, readonly display: Display, readonly asker: Asker,
              readonly beside: BesideResults, readonly sampler: Asker | null = null) {}

  /// Names of the cases of the present text; "" is the base model.
  get cases(): string[] {
    return casesOf(this.index);
  }
  /// Keys and numbers of the present text.
  get index(): TextIndex {
    return this.state.index;
  }
}

/// A part of the page. It is rendered into the document, not into a shadow root, so that page.css and labels reach it.
export class Part extends LitElement {
  static override properties = {app: {attribute: false}};
  declare app: App;
  protected unsubscribe: (() => void)[] = [];

  override createRenderRoot(): HTMLElement | ShadowRoot { return this; }
  override connectedCallback() {
    super.connectedCallback();
    const update = () => this.requestUpdate();
    const {state, display, asker, file} = this.app;
    this.unsubscribe = [state, display, asker, ...file ? [file] : []].map(part => part.subscribe(update));
  }
  override disconnectedCallback() {
    super.disconnectedCallback();
    for (const end of this.unsubscribe) end();
  }
}
