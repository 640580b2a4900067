// SPDX-License-Identifier: BSD-3-Clause
import {html, nothing, type TemplateResult} from 'lit';
import {settingPath} from './numbers_of_text.ts';
import {Part} from './part.ts';
import {errorAbout, idOf, worded} from './problem_words.ts';
import {refuse} from './refused_number.ts';
import {quantity, written} from './quantities.ts';
import type {Selection} from './state.ts';
import {pathParts, pathText, type Entry} from './toml_outline.ts';

const KINDS: Record<string, Selection['kind']> = {bodies: 'body', nodes: 'body', elements: 'element', excitations: 'force'};

interface Branch {
  name: string;
  path: readonly string[];
  entry: Entry | null;
  children: Map<string, Branch>;
}

/// The model as a tree. Every number of the file can be edited where it stands.
export class ModelTree extends Part {
  override render() {
    const root: Branch = {name: '', path: [], entry: null, children: new Map()};
    for (const entry of this.app.index.entries) grow(root, entry);
    return html`<ul class="tree" aria-label="Model">${[...root.children.values()].map(b => this.branch(b))}</ul>`;
  }
  override updated() {
    const {selection} = this.app.state;
    if (selection?.name !== this.seen && selection) {
      const chosen = this.querySelector('.chosen');
      for (let at = chosen?.parentElement; at && at !== this; at = at.parentElement) if (at instanceof HTMLDetailsElement) at.open = true;
      chosen?.scrollIntoView({block: 'nearest'});
    }
    this.seen = selection?.name;
  }
  private seen: string | undefined;

  private branch(branch: Branch): TemplateResult {
    const {entry, name, path} = branch, {schema, state} = this.app;
    const description = schema?.description(path) ?? '';
    if (!branch.children.size) return entry?.kind === 'number' ? this.numberRow(name, entry, description)
      : html`<li title=${description}><span class="key">${name}</span><span class="value">${short(entry?.raw ?? '')}</span></li>`;
    const three = [...branch.children.values()];
    if (entry?.kind === 'array' && three.length <= 3 && three.every(c => c.entry?.kind === 'number' && !c.children.size))
      return html`<li title=${description}><span class="key">${name}</span><span class="vector">${three.map(c => this.input(c.entry!, false))}</span></li>`;
    const kind = KINDS[path[0] ?? ''] ?? (path[0] === 'tables' && path[1] === 'elements' ? 'element' : undefined);
    const own = kind && (path.length === 2 || path[0] === 'tables' && path.length === 4) ? {kind, name} : null;
    const chosen = own !== null && state.selection?.kind === own.kind && state.selection.name === own.name;
    return html`<li><details ?open=${path.length === 1 && path[0] !== 'cases' || chosen}><summary class=${chosen ? 'chosen' : ''} title=${description} @click=${() => own && state.select(own)}>${name}</summary>
      <ul>${three.map(c => this.branch(c))}</ul></details></li>`;
  }
  private numberRow(name: string, entry: Entry, description: string) {
    return html`<li title=${description}><span class="key">${name}</span>${this.input(entry, true)}</li>`;
  }
  private input(entry: Entry, pinnable: boolean) {
    const {state, index, display, schema} = this.app, path = settingPath(entry, index.byPath);
    const raw = (path && state.design.settings.get(path)) ?? entry.raw, changed = path !== null && state.design.settings.has(path);
    const wrong = errorAbout(path ? [path, pathText(entry.path)] : [pathText(entry.path)], this.app.asker.problems), isWrong = wrong >= 0;
    const name = (path ? pathParts(path) : entry.path).join(' '), description = schema?.description(entry.path) ?? '';  // "elements front left at x", also of a row
    const label = description ? `${name}: ${description}` : name, text = raw.replace(/^["']|["']$/g, '');
    return html`<input class="number ${changed ? 'changed' : ''}" aria-label=${pinnable ? label : name} title=${isWrong ? worded(this.app.asker.problems[wrong]!) : label} aria-invalid=${isWrong ? 'true' : nothing} aria-describedby=${isWrong ? idOf(wrong) : nothing} size=${Math.min(Math.max(text.length, LEAST), MOST)} .value=${text}
        @change=${(e: Event) => this.edited(entry, path, e.target as HTMLInputElement)}>${pinnable && path && !display.pins.includes(path)
      ? html`<button class="pin" title="Make a slider of ${path}" aria-label="Make a slider of ${path}" @click=${() => display.set({pins: [...display.pins, path], leftTab: 'sliders'})}>⊕</button>` : nothing}`;
  }
  /// A number is set by its path; one that has no path is replaced in the text.
  private edited(entry: Entry, path: string | null, input: HTMLInputElement) {
    const typed = quantity(input.value.replaceAll('−', '-')), {state} = this.app;
    if (!typed) return refuse(input, this.app, ((path && state.design.settings.get(path)) ?? entry.raw).replace(/^["']|["']$/g, ''));
    const before = quantity(entry.raw), value = written(typed.value, typed.unit || before?.unit || '');
    if (path) return state.set({[path]: value});
    const {text} = state.design;
    state.edit(text.slice(0, entry.from) + value + text.slice(entry.to));
  }
}

const LEAST = 3, MOST = 24;  // characters of a field: its text is read without scrolling

function grow(root: Branch, entry: Entry) {
  let at = root;
  entry.path.forEach((part, i) => {
    const path = entry.path.slice(0, i + 1);
    if (!at.children.has(part)) at.children.set(part, {name: part, path, entry: null, children: new Map()});
    at = at.children.get(part)!;
  });
  at.entry = entry;
  const row = entry.children.find(c => c.path.at(-1) === 'name');
  if (row && /^\d+$/.test(at.name)) at.name = row.raw.slice(1, -1);
  for (const child of entry.children) grow(root, child);
}
const short = (raw: string) => (raw.length > 40 ? `${raw.slice(0, 38)}…` : raw.replace(/^"|"$/g, ''));
customElements.define('model-tree', ModelTree);
