// SPDX-License-Identifier: BSD-3-Clause
import {html, nothing} from 'lit';
import {downloadProject} from './download.ts';
import {differentLines} from './line_difference.ts';
import {Part} from './part.ts';
import type {Trouble} from './project_file.ts';

const MOST_LINES = 200;

/// What happened to the file or to the program, and what the user can do about it.
export class FileNotice extends Part {
  override render() {
    const {trouble} = this.app.file!;
    switch (trouble?.kind) {
      case 'away': return this.away(trouble);
      case 'deleted': return this.deleted();
      case 'changed': return this.changed(trouble);
      default: return nothing;
    }
  }
  private away({reason, isSilent}: Trouble & {kind: 'away'}) {
    const {project} = this.app, file = this.app.file!;
    return html`<div class="problems error" role="alert"><p>${reason} Your edits are kept in this tab.</p>
      ${isSilent ? html`<pre>${['trivet serve', quoted(project.name ?? ''), '--port', location.port].filter(word => word).join(' ')}</pre>` : nothing}
      <button @click=${() => void file.look()}>Try again</button>
      <button @click=${() => downloadProject(project.name ?? 'machine.toml', file.textAway)}>Download the text</button></div>`;
  }
  private deleted() {
    const {project} = this.app, file = this.app.file!;
    return html`<div class="problems error" role="alert"><p>${project.name} is no longer on the disk. Its text is still on this page.</p>
      ${project.read_only ? nothing : html`<button @click=${() => void file.save()}>Write it again</button>`}
      <button @click=${() => downloadProject(project.name ?? 'machine.toml', file.textAway)}>Download the text</button></div>`;
  }
  private changed(trouble: Trouble & {kind: 'changed'}) {
    const {project, state} = this.app, file = this.app.file!, lines = differentLines(trouble.text, state.design.text), {settings} = state.change;
    return html`<div class="problems error" role="alertdialog" aria-label="The file was changed"><p>Another program changed ${project.name} on the disk, and this page has edits. Nothing was written.</p>
      <details open><summary>${lines.length === 1 ? '1 line differs' : `${lines.length} lines differ`}: − on the disk, + on this page</summary>
      <pre class="difference" tabindex="0">${lines.slice(0, MOST_LINES).map(l => html`<span class=${l.side}>${l.side === 'first' ? '−' : '+'} ${String(l.number).padStart(4)}  ${l.text}\n</span>`)}${settings.map(s => html`<span class="second">+ ${s}\n</span>`)}</pre></details>
      <button @click=${() => file.take(trouble)}>Open the text on the disk</button>
      ${project.read_only ? nothing : html`<button @click=${() => void file.overwrite(trouble)}>Overwrite it with mine</button>`}
      <button @click=${() => file.ignore(trouble)}>Go on with mine</button></div>`;
  }
}
const quoted = (name: string) => (/^[\w./-]*$/.test(name) ? name : `'${name.replaceAll("'", "'\\''")}'`);
customElements.define('file-notice', FileNotice);
