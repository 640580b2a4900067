// SPDX-License-Identifier: BSD-3-Clause
import {html, nothing} from 'lit';
import {Part} from './part.ts';
import {idOf, lineOf, settingOf, worded} from './problem_words.ts';
import type {TextView} from './text_view.ts';

/// The program's messages on the file. A click goes to the line.
export class ProblemList extends Part {
  override render() {
    const {asker, file, state} = this.app, errors = asker.problems.filter(p => p.severity === 'error'), warnings = asker.problems.length - errors.length;
    if (file?.trouble?.kind === 'away') return nothing;
    if (asker.trouble) return html`<div class="problems error" role="alert"><p>${asker.trouble}</p><button @click=${() => asker.again()}>Try again</button></div>`;
    if (!asker.problems.length) return nothing;
    return html`<details class="problems ${errors.length ? 'error' : 'warning'}" ?open=${errors.length > 0}>
      <summary>${errors.length ? `${errors.length} ${errors.length === 1 ? 'error' : 'errors'}` : ''}${errors.length && warnings ? ', ' : ''}${warnings ? `${warnings} ${warnings === 1 ? 'warning' : 'warnings'}` : ''}</summary>
      <ul>${asker.problems.map((p, i) => {
        const line = lineOf(p, state.design.text, this.app.index);
        return html`<li class=${p.severity}><button class="link" id=${idOf(i)} ?disabled=${!(line || settingOf(p)) || !this.closest('page-shell')} @click=${() => this.go(line, i)}>${worded(p, line)}</button></li>`;
      })}</ul></details>`;
  }
  /// Opens the list and goes to its first message.
  show() {
    const list = this.querySelector('details');
    if (list) list.open = true;
    this.querySelector<HTMLElement>('.error .link, summary')?.focus();
  }
  /// To the place in the text, or to the field of a number that is not in the text.
  private async go(line: number, place: number) {
    this.app.display.set({leftTab: line ? 'text' : 'sliders'});
    await new Promise(requestAnimationFrame);
    if (!line) document.querySelector<HTMLElement>(`.left [aria-describedby="${idOf(place)}"]`)?.focus();
    else document.querySelector<TextView>('text-view')?.show(line);
  }
}
customElements.define('problem-list', ProblemList);
