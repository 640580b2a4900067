// SPDX-License-Identifier: BSD-3-Clause
import {html, nothing} from 'lit';
import {Part} from './part.ts';
import {worded} from './problem_words.ts';
import type {TextView} from './text_view.ts';

/// The program's messages on the file. A click goes to the line.
export class ProblemList extends Part {
  override render() {
    const {asker, file} = this.app, errors = asker.problems.filter(p => p.severity === 'error'), warnings = asker.problems.length - errors.length;
    if (file?.trouble?.kind === 'away') return nothing;
    if (asker.trouble) return html`<div class="problems error" role="alert"><p>${asker.trouble}</p><button @click=${() => asker.again()}>Try again</button></div>`;
    if (!asker.problems.length) return nothing;
    return html`<details class="problems ${errors.length ? 'error' : 'warning'}" ?open=${errors.length > 0}>
      <summary>${errors.length ? `${errors.length} ${errors.length === 1 ? 'error' : 'errors'}` : ''}${errors.length && warnings ? ', ' : ''}${warnings ? `${warnings} ${warnings === 1 ? 'warning' : 'warnings'}` : ''}</summary>
      <ul>${asker.problems.map(p => html`<li class=${p.severity}><button class="link" ?disabled=${!p.line || !this.closest('page-shell')} @click=${() => this.go(p.line ?? 0)}>${worded(p)}</button></li>`)}</ul></details>`;
  }
  private async go(line: number) {
    this.app.display.set({leftTab: 'text'});
    await new Promise(requestAnimationFrame);
    document.querySelector<TextView>('text-view')?.show(line);
  }
}
customElements.define('problem-list', ProblemList);
