// SPDX-License-Identifier: BSD-3-Clause
import {html} from 'lit';
import type {Example} from './engine.ts';
import {Part} from './part.ts';

/// What is there without a file: three machines to play with, and how to begin.
export class EmptyState extends Part {
  static override properties = {...Part.properties, examples: {attribute: false}, open: {attribute: false}};
  declare examples: readonly Example[];
  declare open: (example: Example) => void;

  override render() {
    return html`<h2>Begin with a machine</h2>
      <p>Open one, drag a slider, and see how it moves. Nothing is written to your disk until you save it.</p>
      <ul class="examples">${this.examples.map(example => html`<li><button @click=${() => this.open(example)}><b>${example.title}</b><span>${example.name}</span></button></li>`)}</ul>
      <p>With your own file: <code>trivet serve machine.toml</code>. A commented file to start from: <code>trivet new machine.toml</code>.</p>`;
  }
}
customElements.define('empty-state', EmptyState);
