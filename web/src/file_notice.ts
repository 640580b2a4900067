// SPDX-License-Identifier: BSD-3-Clause
import {html, nothing} from 'lit';
import {downloadProject} from './download.ts';
import {differentLines} from './line_difference.ts';
import {Part} from './part.ts';
import type {Trouble} from './project_file.ts';
import type {Design} from './state.ts';

const MOST_LINES = 200;

/// What happened to the file or to the program, and what the user can do about it.
export class FileNotice extends Part {
  override render() {
    const {trouble} = this.app.file!;
    switch (trouble?.kind) {
      case 'away': return this.away(trouble);
      case 'deleted': return this.deleted();
      case 'unshown': return this.unshown(trouble);
      case 'changed': return this.changed(trouble);
      default: return nothing;
    }
  }
  private away({reason, isSilent}: Trouble & {kind: 'away'}) {
    const {project} = this.app, file = this.app.file!;
    return html`<div class="problems error" role="alert"><p>${reason} Your edits are kept in this tab.</p>
      ${isSilent ? html`<pre>${['trivet serve', quoted(project.name ?? ''), '--port', location.port].filter(word => word).join(' ')}</pre>` : nothing}
      <button @click=${() => void file.look()}>Try again</button>
      ${this.downloadButton()}</div>`;
  }
  private unshown({reason}: Trouble & {kind: 'unshown'}) {
    const {project, state} = this.app;
    return html`<div class="problems error" role="alert"><p>${project.name} on the disk is no text that this page can show, and nothing is written over it. ${reason}.</p>
      <p>The page goes on by itself when the file can be read.</p>
      ${state.design.text ? this.downloadButton() : nothing}</div>`;
  }
  private downloadButton() {
    const {project} = this.app;
    return html`<button @click=${() => downloadProject(project.name ?? 'machine.toml', this.app.file!.textAway)}>Download the text</button>`;
  }
  private deleted() {
    const {project, state} = this.app, file = this.app.file!;
    if (!state.design.text) return html`<div class="problems error" role="alert"><p>${project.name} is no longer on the disk, or it is empty.</p></div>`;
    return html`<div class="problems error" role="alert"><p>${project.name} is no longer on the disk, or it is empty there. Its text is still on this page.</p>
      ${project.read_only ? nothing : html`<button @click=${() => void file.save()}>Write it again</button>`}
      ${this.downloadButton()}</div>`;
  }
  /// What saving would write: the program writes the settings into the text. `unwritten`: until it has, or if it cannot.
  private mine(): {text: string; unwritten: readonly string[]} {
    const {state, engine} = this.app, {design, change} = state;
    if (!design.settings.size) return {text: design.text, unwritten: []};
    if (this.written?.of === design) return this.written.text === null ? {text: design.text, unwritten: change.settings} : {text: this.written.text, unwritten: []};
    const written = this.written = {of: design, text: null as string | null};
    void engine.text(change).then(text => { written.text = text; this.requestUpdate(); }, () => undefined);
    return {text: design.text, unwritten: change.settings};
  }
  private written: {of: Design; text: string | null} | null = null;
  private changed(trouble: Trouble & {kind: 'changed'}) {
    const {project} = this.app, file = this.app.file!, mine = this.mine(), lines = differentLines(plain(trouble.text), plain(mine.text));
    const count = lines.length ? (lines.length === 1 ? '1 line differs' : `${lines.length} lines differ`) : mine.unwritten.length ? 'No line differs yet' : 'Only the ends of lines differ';
    return html`<div class="problems error" role="alertdialog" aria-label="The file was changed"><p>Another program changed ${project.name} on the disk, and this page has edits. Nothing was written.</p>
      <details open><summary>${count}: − on the disk, + on this page</summary>
      <pre class="difference" tabindex="0">${lines.slice(0, MOST_LINES).map(l => html`<span class=${l.side}>${l.side === 'first' ? '−' : '+'} ${String(l.number).padStart(4)}  ${l.text}\n</span>`)}${mine.unwritten.map(s => html`<span class="second">+ ${s}\n</span>`)}</pre></details>
      <button @click=${() => file.take(trouble)}>Open the text on the disk</button>
      ${project.read_only ? nothing : html`<button @click=${() => void file.overwrite(trouble)}>Overwrite it with mine</button>`}
      <button @click=${() => file.ignore(trouble)}>Go on with mine</button></div>`;
  }
}
const plain = (text: string) => text.replaceAll('\r\n', '\n');
const quoted = (name: string) => (/^[\w./-]*$/.test(name) ? name : `'${name.replaceAll("'", "'\\''")}'`);
customElements.define('file-notice', FileNotice);
