// SPDX-License-Identifier: BSD-3-Clause
// What the user decided: text, settings of sliders, case and selection, with undo and redo. Nothing here is computed.
import type {Change} from './engine.ts';
import {casesOf, indexOf, numbersOfCases, type TextIndex} from './numbers_of_text.ts';

/// The part of the state that undo brings back.
export interface Design {
  readonly text: string;
  readonly settings: ReadonlyMap<string, string>;  // path → value as in the project file
}
/// What undo brings back. `case`: the case to show then; null: the one on the page.
export interface Step {
  design: Design;
  case: string | null;
  isNumber?: boolean;  // only a number of the text differs
}
/// The next step is the last one of each.
export interface History {
  past: readonly Step[];
  future: readonly Step[];
}
export interface Selection {
  kind: 'body' | 'element' | 'point' | 'force';
  name: string;
}

/// Of a text that is not on the disk: no text equals it.
const NOWHERE: Design = {text: '\0', settings: new Map()};

export class State {
  design: Design = {text: '', settings: new Map()};
  case = '';
  selection: Selection | null = null;
  /// Counts every change that results depend on.
  revision = 0;
  /// Counts changes after which older results belong to another machine: another text or case, not a moved slider.
  generation = 0;
  /// Counts files that were opened.
  file = 0;
  private past: Step[] = [];
  private future: Step[] = [];
  private saved: Design = this.design;
  private opened: {text: string; version: string | null} = {text: '', version: null};  // of the file on the disk
  private indexed: {text: string; index: TextIndex} | null = null;
  private dragged: Design | null = null;  // the design before the drag of a slider
  private readonly listeners = new Set<() => void>();

  /// Opens a file, perhaps with changed numbers; it has no history. @param version  on the disk; null: it is not there
  open(text: string, version: string | null, settings: Iterable<readonly [string, string]> = [], name = '') {
    this.design = {text, settings: new Map(settings)};
    this.opened = {text, version};
    this.saved = version === null ? NOWHERE : this.design;
    [this.past, this.future, this.selection, this.case] = [[], [], null, name];
    this.file++;
    this.changed(true);
  }
  /// A number of the base model leaves a case alone that has its own, as it does once it is written into the file.
  get change(): Change {
    const {text, settings} = this.design, own = settings.size ? numbersOfCases(settings, this.index) : [];
    return {text, version: text === this.opened.text ? this.opened.version : null,
            settings: [...settings, ...own].map(([path, value]) => `${path} = ${value}`), case: this.case};
  }
  /// Keys and numbers of the present text.
  get index(): TextIndex {
    const {text} = this.design;
    if (this.indexed?.text !== text) this.indexed = {text, index: indexOf(text)};
    return this.indexed.index;
  }
  /// Differs the page from the text that was opened or saved last?
  get hasEdits(): boolean {
    return this.design.text !== this.opened.text || this.design.settings.size > 0;
  }
  get isSaved(): boolean {
    return this.design.text === this.saved.text && this.design.settings.size === 0;
  }
  get history(): History { return {past: this.past, future: this.future}; }
  get canUndo() { return this.past.length > 0; }
  get canRedo() { return this.future.length > 0; }

  /// Sets a number. During a drag all values are one step of undo, which `dropped` ends.
  set(values: Readonly<Record<string, string>>, drag = false) {
    const before = this.design, settings = new Map(before.settings);
    for (const [path, value] of Object.entries(values)) settings.set(path, value);
    if (drag) this.dragged ??= before;
    else this.remember(this.dragged ?? before);
    if (!drag) this.dragged = null;
    this.design = {text: before.text, settings};
    this.changed(false);
  }
  dropped() {
    if (this.dragged) this.remember(this.dragged);
    this.dragged = null;
    this.notify();
  }
  edit(text: string) { this.write(text, false); }
  /// Replaces one number in the text: as a moved slider it leaves the machine the same, and so do its undo and redo.
  replaceNumber(place: {from: number; to: number}, value: string) { this.replaceNumbers([[place, value]]); }
  /// Several in one step.
  replaceNumbers(numbers: readonly (readonly [{from: number; to: number}, string])[]) {
    const fromTheEnd = [...numbers].sort((a, b) => b[0].from - a[0].from);
    this.write(fromTheEnd.reduce((text, [{from, to}, value]) => text.slice(0, from) + value + text.slice(to), this.design.text), true);
  }
  /// The settings are now written into the text: the same design in another form, no step of undo.
  folded(text: string) {
    this.design = {text, settings: new Map()};
    this.changed(false);
  }
  undo() { this.travel(this.past, this.future); }
  redo() { this.travel(this.future, this.past); }

  /// @param of  what was saved: later edits stay
  wasSaved(text: string, version: string, of: Design = this.design) {
    this.saved = {text, settings: new Map()};
    if (this.design === of) this.design = this.saved;
    this.opened = {text, version};
    this.changed(false);
  }
  /// Another program wrote the file: its text replaces that of the page. Undo brings the earlier one back.
  replaced(text: string, version: string) {
    this.remember(this.design);
    this.design = this.saved = {text, settings: new Map()};
    this.opened = {text, version};
    if (!casesOf(this.index).includes(this.case)) this.case = '';
    this.changed(true);
  }
  /// Is this text of the file that of the page, or the one with which its edits began before it was deleted? Then there is
  /// nothing to decide.
  foundOnDisk(text: string, version: string): boolean {
    if (text === this.design.text && !this.design.settings.size) this.wasSaved(text, version);
    else if (this.opened.version === null && text === this.opened.text) [this.saved, this.opened] = [{text, settings: new Map()}, {text, version}];
    else return false;
    this.changed(false);
    return true;
  }
  /// The file is no longer on the disk: its text can be saved again.
  wasDeleted() {
    this.opened = {text: this.opened.text, version: null};
    this.saved = NOWHERE;
    this.changed(false);
  }
  /// Another text, with a case of it, as one step of undo.
  put(design: Design, name: string) {
    this.remember(this.design, this.case);
    this.design = design;
    this.case = name;
    this.changed(true);
  }
  /// A design of this page before it was loaded again, with its history; without one it is one step of undo.
  resume(design: Design, name: string, {past, future}: History) {
    if (!past.length) return this.put(design, name);
    [this.past, this.future, this.design, this.case] = [[...past], [...future], design, name];
    this.changed(true);
  }
  chooseCase(name: string) {
    this.case = name;
    this.changed(true);
  }
  select(selection: Selection | null) {
    this.selection = selection;
    this.notify();
  }
  subscribe(listener: () => void) {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }

  private write(text: string, isNumber: boolean) {
    if (text === this.design.text) return;
    this.remember(this.design, null, isNumber);
    this.design = {text, settings: this.design.settings};
    this.changed(!isNumber);
  }
  private remember(design: Design, name: string | null = null, isNumber = false) {
    this.past.push({design, case: name, ...isNumber ? {isNumber} : {}});
    this.future = [];
  }
  private travel(from: Step[], to: Step[]) {
    const next = from.pop();
    if (!next) return;
    const {isNumber = false} = next;
    to.push({design: this.design, case: next.case === null ? null : this.case, ...isNumber ? {isNumber} : {}});
    const sameMachine = (isNumber || next.design.text === this.design.text) && (next.case ?? this.case) === this.case;
    this.design = next.design;
    this.case = next.case ?? this.case;
    this.changed(!sameMachine);
  }
  private changed(anotherMachine: boolean) {
    this.revision++;
    if (anotherMachine) this.generation++;
    this.notify();
  }
  private notify() {
    for (const listener of this.listeners) listener();
  }
}
