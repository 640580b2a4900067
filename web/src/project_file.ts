// SPDX-License-Identifier: BSD-3-Clause
// The file on the disk and the edits of this page: saving, another hand that writes the file, a program that went away.
import type {Asker} from './asker.ts';
import {EngineError, type Engine, type OnDisk, type Project} from './engine.ts';
import {historyOf, keptHistory, type KeptHistory} from './kept_history.ts';
import {findingOf} from './problem_words.ts';
import type {Design, State} from './state.ts';

/// Why the page and the file differ, and what the user decides about.
export type Trouble =
  | {kind: 'away'; reason: string; isSilent: boolean}  // the program does not answer
  | {kind: 'changed'; version: string; text: string}  // another program wrote the file, and the page has edits
  | {kind: 'unshown'; version: string; reason: string}  // what is on the disk is no text that the page can show
  | {kind: 'deleted'};

/// Edits that are not on the disk, as the tab keeps them over a reload, a sleep and a new start of the program.
export interface KeptEdits {
  project: string | null;
  version: string | null;  // of the file with which they began
  text: string;
  settings: [string, string][];
  case: string;
  history?: KeptHistory;
}
const KEPT = 'edits', LEFT = 'left', MOST_LEFT = 5;  // keys of the storage; machines without a file that can be opened again
const LOOK = 2000, LOOK_AGAIN = 1000;  // ms between looks at the file; while the program does not answer

export class ProjectFile {
  trouble: Trouble | null = null;
  /// Machines without a file that were left with edits, the last one first.
  readonly left: KeptEdits[];
  private version: string;  // on the disk, when the page last took or wrote it
  private ignored = '';  // version on the disk that the user has decided not to take
  private isSaving = false;
  private isLooking = false;
  private keepsNothing = false;
  private lookTimer = 0;
  private keepTimer = 0;
  private readonly listeners = new Set<() => void>();

  constructor(private readonly engine: Engine, private readonly project: Project, private readonly state: State,
              private readonly asker: Asker, private readonly say: (notice: string, isListed?: boolean) => void) {
    this.version = project.version ?? '';
    this.left = project.name === null ? JSON.parse(sessionStorage.getItem(LEFT) ?? '[]') as KeptEdits[] : [];
  }
  /// Shows the file, with the edits that this tab has kept, and looks at it from time to time.
  begin() {
    const {project, state} = this, kept = this.kept();
    if (typeof project.text === 'string') state.open(project.text, project.version || null);
    if (kept) this.restore(kept);
    else if (project.text === null) this.meet(onDiskOf(project));
    state.subscribe(() => {
      clearTimeout(this.keepTimer);
      this.keepTimer = window.setTimeout(() => this.keep(), 200);
    });
    this.asker.subscribe(() => { if (this.asker.trouble && !this.trouble) void this.look(); });
    addEventListener('pagehide', () => this.keep());
    document.addEventListener('visibilitychange', () => (document.hidden ? this.keep() : void this.look()));
    if (this.engine.version) this.lookLater();
  }
  subscribe(listener: () => void) {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }

  /// Writes the file. @returns the text to download if there is no file
  async save(): Promise<string | null> {
    const {state, engine, project} = this, {change, design} = state;
    this.isSaving = true;
    try {
      const text = design.settings.size ? await engine.text(change) : design.text;
      if (project.name === null) return text;
      const saved = await engine.save(this.version, change);
      if (saved.conflict) this.meet(saved);
      else {
        [this.version, this.ignored] = [saved.version, ''];
        state.wasSaved(text, saved.version, design);
        this.set(null);
        this.say(`${project.name} is saved.`);
      }
    } catch (error) {
      if (error instanceof EngineError) this.say(`Not saved: ${error.message}.`, error.isListed);
      else this.say(String(error));
    } finally {
      this.isSaving = false;
    }
    return null;
  }
  take({version, text}: {version: string; text: string}) {
    this.version = version;
    this.set(null);
    if (this.state.design.text) this.state.replaced(text, version);
    else this.state.open(text, version);  // there is nothing to bring back
  }
  overwrite({version}: {version: string}) {
    this.version = version;
    this.set(null);
    return this.save();
  }
  /// The edits stay, and the file stays as it is.
  ignore({version}: {version: string}) {
    this.ignored = version;
    this.set(null);
  }
  /// The text of the page for a download while the program is away: only it can write settings into a text.
  get textAway(): string {
    const {text} = this.state.design, {settings} = this.state.change;
    return settings.length ? `${text.trimEnd()}\n\n# Changed on the page and not yet written above, as options of trivet:\n${settings.map(s => `#   --set '${s}'\n`).join('')}` : text;
  }

  /// Is the file still what the page shows, and does the program answer?
  async look() {
    const {engine, version} = this;
    if (!engine.version || this.isSaving || this.isLooking) return;
    this.isLooking = true;
    try {
      const onDisk = await engine.version();
      if (this.trouble?.kind === 'away') {
        this.set(null);
        this.asker.afresh();
      }
      if (!this.isSaving && version === this.version) await this.compare(onDisk);
    } catch (error) {
      if (!(error instanceof EngineError)) throw error;
      this.set({kind: 'away', reason: error.message, isSilent: error.isSilent});
      this.keep();
    } finally {
      this.isLooking = false;
    }
  }
  private async compare(onDisk: string) {
    const {state, engine, project, trouble} = this;
    if (project.name === null) return;
    if (onDisk === '') return trouble?.kind === 'deleted' ? undefined : this.meet({version: '', text: null, problems: []});
    if (trouble && 'version' in trouble && onDisk === trouble.version) return;
    if (onDisk === this.version) return trouble ? this.set(null) : undefined;  // the other hand took its change back
    if (onDisk === this.ignored) return;
    const found = onDiskOf(await engine.project()), {text, version} = found;
    if (text === null || text === state.design.text || state.hasEdits) return this.meet(found);
    const isFirst = !state.design.text;
    this.take({version, text});
    if (!isFirst) this.say(`Another program changed ${project.name}; the page shows its new text. Undo brings the earlier one back.`);
  }
  /// Another version is on the disk.
  private meet({version, text, problems}: OnDisk) {
    const {state} = this;
    if (version === '') {
      this.version = '';
      if (state.design.text) state.wasDeleted();
      return this.set({kind: 'deleted'});
    }
    if (text === null) return this.set({kind: 'unshown', version, reason: problems.map(findingOf).join('; ')});
    if (!state.foundOnDisk(text, version)) return this.set({kind: 'changed', version, text});
    this.version = version;
    this.set(null);
  }
  private set(trouble: Trouble | null) {
    this.trouble = trouble;
    for (const listener of this.listeners) listener();
  }
  private lookLater() {
    clearTimeout(this.lookTimer);
    this.lookTimer = window.setTimeout(async () => {
      if (!document.hidden) await this.look();
      this.lookLater();
    }, this.trouble?.kind === 'away' ? LOOK_AGAIN : LOOK);
  }

  private kept(): KeptEdits | null {
    const text = sessionStorage.getItem(KEPT), kept = text ? JSON.parse(text) as KeptEdits : null;
    return kept && kept.project === this.project.name ? kept : null;
  }
  private restore(kept: KeptEdits) {
    const {state, project} = this, design: Design = {text: kept.text, settings: new Map(kept.settings)};
    if (project.name === null) state.open(kept.text, null);
    state.resume(design, kept.case, kept.history ? historyOf(kept.history) : {past: [], future: []});
    if (project.name === null) return;
    const onDisk = this.version;
    this.version = kept.version ?? '';  // with which the edits began
    if (onDisk === '' || onDisk !== this.version) this.meet(onDiskOf(project));
    else this.say('Your edits are back; they are not saved yet.');
  }
  /// The machine without a file is closed; what a hand made of it is kept, to be opened again.
  leave() {
    const {state, project} = this;
    clearTimeout(this.keepTimer);
    if (state.design.settings.size || !project.examples?.some(({text}) => text === state.design.text)) {
      this.left.unshift(this.edits());
      this.left.length = Math.min(this.left.length, MOST_LEFT);
      this.write(LEFT, this.left);
    }
    state.open('', null);
    sessionStorage.removeItem(KEPT);
  }
  /// Opens a machine again that was left.
  reopen(one: KeptEdits) {
    this.left.splice(this.left.indexOf(one), 1);
    this.write(LEFT, this.left);
    this.state.open(one.text, null);
    this.state.resume({text: one.text, settings: new Map(one.settings)}, one.case, historyOf(one.history ?? {texts: [], past: [], future: []}));
  }
  private write(key: string, value: unknown) {
    try {
      sessionStorage.setItem(key, JSON.stringify(value));
    } catch {
      this.say('The tab has no room to keep this over a reload.');
    }
  }
  private edits(): KeptEdits {
    const {state, project} = this, {text, settings} = state.design;
    return {project: project.name, version: this.version || null, text, settings: [...settings], case: state.case, history: keptHistory(state.history)};
  }
  private keep() {
    const {state} = this;
    clearTimeout(this.keepTimer);
    try {
      if (state.isSaved || !state.design.text) return sessionStorage.removeItem(KEPT);
      const {history, ...kept} = this.edits();
      try {
        sessionStorage.setItem(KEPT, JSON.stringify({...kept, history}));
      } catch {  // no room for both: the edits matter more
        sessionStorage.setItem(KEPT, JSON.stringify(kept));
      }
    } catch {
      if (!this.keepsNothing) this.say('The file is too large for the storage of this tab: save before you reload or close it.');
      this.keepsNothing = true;
    }
  }
}
const onDiskOf = ({text = null, version = '', problems = []}: Project): OnDisk => ({version, text, problems});
