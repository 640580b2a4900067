// SPDX-License-Identifier: BSD-3-Clause
// Keeps the results on the page up to date: at most one question is under way, and the newest state wins.
import {EngineError, type Answer, type Engine, type Outcome, type Want} from './engine.ts';
import type {Problem} from './results.ts';
import type {State} from './state.ts';

/// A result and the state that it belongs to.
export interface Kept {
  revision: number;
  generation: number;
  asked: string;  // of which wish
  outcome: Outcome;
}
/// A command that the page wants. `exact`: asked at a short rest of the state; `after`: then, when the exact ones are there; `slow`: at a long rest. `as`: the name under which its
/// result is kept, by default the command. `settings`: of the question, not of the design.
export interface Wish {
  want: Want;
  exact?: boolean;
  after?: boolean;
  slow?: boolean;
  as?: string;
  settings?: readonly string[];
}

/// Results that follow every move of a slider, and those that wait for it to rest. In this order they are asked for.
const PACES = ['quick', 'exact', 'after', 'slow'] as const;
type Pace = typeof PACES[number];
/// ms without a change. A hand that moves a slider stops for a moment again and again, and would begin a question about all curves each time.
const REST: Record<Pace, number> = {quick: 0, exact: 70, after: 70, slow: 200};
const nameOf = (w: Wish) => w.as ?? w.want.command;
/// The name of a quick result that stands in for that of the command until it follows.
export const draftOf = (command: string) => `draft of ${command}`;
const textOf = ({want, settings}: Wish) => JSON.stringify([want, settings]);
const paceOf = ({exact, after, slow}: Wish): Pace => (slow ? 'slow' : after ? 'after' : exact ? 'exact' : 'quick');

export class Asker {
  problems: Problem[] = [];
  trouble = '';  // why the engine does not answer
  private readonly results = new Map<string, Kept>();
  private readonly good = new Map<string, Kept & {file: number}>();  // the newest of each that could be computed
  private underWay: {pace: Pace; revision: number; began: number; end: AbortController} | null = null;
  private asked: Record<Pace, number> = {quick: -1, exact: -1, after: -1, slow: -1};
  private changedAt = 0;  // time of the last change of the state [ms]
  private seen = -1;  // its revision
  private restTimer: ReturnType<typeof setTimeout> | undefined;
  private idleUntil = 0;  // time of the next question of a moving slider [ms]
  private readonly listeners = new Set<() => void>();

  /// @param patience  ms after which also a question of a moving slider gives way to a newer state
  /// @param idle  after a question of a moving slider so many times its duration pass before the next, while it moves: others want the processor too
  constructor(private readonly engine: Pick<Engine, 'ask'>, private readonly state: State, private readonly wishes: () => Wish[],
              private readonly patience = Infinity, private readonly idle = 0) {
    state.subscribe(() => this.next());
  }

  /// The newest result of a command or its draft, or of a wish with a name, if it is of the machine on the page. It may be of an earlier
  /// position of a slider. While the file has errors it is that of its last state without.
  result<T>(command: string): T | null {
    return (this.shown(command)?.outcome.json ?? null) as T | null;
  }
  /// Is the result that of the last state of the file without errors, and not of the state on the page?
  isOutdated(command: string): boolean {
    const shown = this.shown(command);
    return shown !== undefined && shown !== this.present(command);
  }
  get hasErrors(): boolean {
    return this.problems.some(p => p.severity === 'error');
  }
  notes(command: string): readonly string[] {
    const kept = this.results.get(command);
    return kept?.generation === this.state.generation ? kept.outcome.notes ?? [] : [];
  }
  failure(command: string): string {
    const kept = this.results.get(command);
    if (!kept || kept.generation !== this.state.generation || kept.outcome.ok) return '';
    return kept.outcome.failure || kept.outcome.problems.map(p => p.message).join('\n');
  }
  /// Why there is no result.
  missing(command: string): string {
    if (this.hasErrors) return 'The file has errors; see the messages above.';
    return this.failure(command) || 'Computing …';
  }
  /// Is the answer for the state on the page not there yet?
  isOld = (name: string) => this.present(name)?.revision !== this.state.revision;
  /// Of the state to which the result belongs; −1 if there is none.
  revisionOf = (name: string): number => (this.shown(name) ?? this.present(name))?.revision ?? -1;
  /// What is wanted of the state on the page, without drafts; null while something of it is computed.
  get finished(): Answer | null {
    const wished = this.wishes().filter(w => w.as === undefined);
    if (this.underWay || !wished.length || wished.some(w => this.results.get(nameOf(w))?.revision !== this.state.revision)) return null;
    const results = wished.map((w): Outcome => {
      const {hash: _, same: __, ...outcome} = this.results.get(nameOf(w))!.outcome;
      return outcome;
    });
    return {revision: this.state.revision, ok: results.every(r => r.ok), problems: this.problems, results};
  }
  /// A wish changed, or the engine is to try again: asks for what there is not yet.
  again() {
    this.trouble = '';
    this.asked = {quick: -1, exact: -1, after: -1, slow: -1};
    this.next();
  }
  /// The program was started again: asks for everything.
  afresh() {
    for (const kept of this.results.values()) kept.asked = '';
    this.again();
  }
  subscribe(listener: () => void) {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }

  /// Asks the first question that is due. A question of a state at rest, or one that takes long, gives way to a newer state.
  private next() {
    const {revision} = this.state, now = performance.now();
    if (revision !== this.seen) [this.seen, this.changedAt] = [revision, now];
    clearTimeout(this.restTimer);
    if (this.underWay) {
      const {pace, began, end, revision: asked} = this.underWay, left = pace === 'quick' ? began + this.patience - now : 0;
      if (asked !== revision && left <= 0) end.abort();
      else if (asked !== revision && Number.isFinite(left)) this.restTimer = setTimeout(() => this.next(), left);
      return;
    }
    const pace = PACES.find(p => this.asked[p] !== revision);
    if (!pace) return;
    const wait = (pace === 'quick' ? Math.min(this.idleUntil, this.changedAt + REST.slow) : this.changedAt + REST[pace]) - now;
    if (wait <= 0) void this.send(pace, revision);
    else this.restTimer = setTimeout(() => this.next(), wait);
  }
  private async send(pace: Pace, revision: number) {
    const wished = this.wishes().filter(w => paceOf(w) === pace && !this.isKept(w));
    const {generation, change} = this.state;
    this.asked[pace] = revision;
    if (wished.length) {
      const {began, end} = this.underWay = {pace, revision, began: performance.now(), end: new AbortController()};
      try {
        const settings = [...change.settings, ...wished.flatMap(w => w.settings ?? [])];
        this.take(await this.engine.ask(revision, {...change, settings}, wished.map(w => this.unknown(w)), end.signal), wished, generation);
        this.trouble = '';
      } catch (error) {
        if (!end.signal.aborted) this.trouble = error instanceof EngineError ? error.message : String(error);
      }
      this.underWay = null;
      const now = performance.now();
      if (pace === 'quick') this.idleUntil = now + this.idle * (now - began);
      if (!end.signal.aborted) for (const listener of this.listeners) listener();
    }
    if (!this.trouble || this.state.revision !== revision) this.next();
  }
  /// What is drawn: the result of the machine on the page, or of the last one without errors.
  private shown(command: string): Kept | undefined {
    const present = this.present(command);
    if (present?.outcome.ok) return present;
    const good = this.hasErrors ? newest(command, this.good) : undefined;
    return good?.file === this.state.file ? good : undefined;
  }
  /// The newest answer about the machine on the page.
  private present(command: string): Kept | undefined {
    const kept = newest(command, this.results);
    return kept?.generation === this.state.generation ? kept : undefined;
  }
  /// Is the result that of the state on the page and of just this wish?
  private isKept(wish: Wish) {
    const kept = this.results.get(nameOf(wish)), {revision, generation} = this.state;
    return kept?.outcome.ok && kept.revision === revision && kept.generation === generation && kept.asked === textOf(wish);
  }
  /// A want that need not be answered if the result is the one that is kept: most sliders change nothing of the scene.
  private unknown(wish: Wish): Want {
    const hash = this.results.get(nameOf(wish))?.outcome.hash;
    return hash ? {...wish.want, known: hash} : wish.want;
  }
  /// Keeps results only if they are newer than those that are kept, and of the same machine.
  private take(answer: Answer, wished: readonly Wish[], generation: number) {
    if (generation !== this.state.generation) return;
    this.problems = answer.problems;
    for (const outcome of answer.results) {
      const wish = wished.find(w => w.want.command === outcome.command), name = wish ? nameOf(wish) : outcome.command, drawn = this.results.get(name);
      if (drawn && drawn.generation === generation && drawn.revision > answer.revision) continue;
      const json = outcome.same && drawn ? drawn.outcome.json : outcome.json;
      const kept = {revision: answer.revision, generation, asked: wish ? textOf(wish) : '', outcome: {...outcome, json}};
      this.results.set(name, kept);
      if (outcome.ok) this.good.set(name, {...kept, file: this.state.file});
    }
  }
}
/// A draft that is newer than the result stands in for it, unless it failed.
function newest<K extends Kept>(command: string, all: ReadonlyMap<string, K>): K | undefined {
  const kept = all.get(command), draft = all.get(draftOf(command));
  const replaces = draft?.outcome.ok && (!kept || draft.generation > kept.generation || draft.revision > kept.revision);
  return replaces ? draft : kept;
}
