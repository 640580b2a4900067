// SPDX-License-Identifier: BSD-3-Clause
import {html, nothing} from 'lit';
import {EngineError, type Doing} from './engine.ts';
import {Part} from './part.ts';

const LOOK = 500;  // ms

/// What the program computes, if that takes longer than a moment.
export class ProgressLine extends Part {
  static override properties = {...Part.properties, doing: {state: true}};
  declare doing: Doing | null;
  private timer = 0;

  constructor() {
    super();
    this.doing = null;
  }
  override connectedCallback() {
    super.connectedCallback();
    this.timer = window.setInterval(() => void this.look(), LOOK);
  }
  override disconnectedCallback() {
    super.disconnectedCallback();
    clearInterval(this.timer);
  }
  override render() {
    if (!this.doing) return nothing;
    const {task, fraction} = this.doing, words = fraction > 0 ? `${task} ${Math.round(100 * fraction)} %` : task;
    return html`<span class="doing" title=${words}>Computing${task ? `: ${words}` : ' …'}</span>`;
  }
  private async look() {
    try {
      this.doing = await this.app.engine.doing?.() ?? null;
    } catch (error) {
      if (!(error instanceof EngineError)) throw error;
      this.doing = null;  // the file notice says that the program is away
    }
  }
}
customElements.define('progress-line', ProgressLine);
