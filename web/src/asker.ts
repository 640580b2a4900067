// SPDX-License-Identifier: BSD-3-Clause
// Keeps the results on the page up to date: at most one question is under way, and the newest state wins.
import {EngineError, type Answer, type Engine, type Outcome, type Want} from './engine.ts';
import type {Problem} from './results.ts';
import type {State} from './state.ts';

/// A result and the state that it belongs to.
export interface Kept {
  revision: number;
  generation: number;
  outcome: Outcome;
}
/// A command that the page wants. `slow`: asked when the state rests. `settings`: of the question, not of the design.
export interface Wish {
  want: Want;
  slow?: boolean;
  settings?: readonly string[];
}

const REST = 200;  // ms without a change, after which slow results are asked for

export class Asker {
  problems: Problem[] = [];
  trouble = '';  // why the engine does not answer
  private readonly results = new Map<string, Kept>();
  private underWay = false;
  private asked = {quick: -1, slow: -1};
  private restTimer = 0;
  private readonly listeners = new Set<() => void>();

  constructor(private readonly engine: Engine, private readonly state: State, private readonly wishes: () => Wish[]) {
    state.subscribe(() => this.next());
  }

  /// The newest result of a command, if it is of the machine on the page. It may be of an earlier position of a slider.
  result<T>(command: string): T | null {
    const kept = this.results.get(command);
    return kept && kept.generation === this.state.generation && kept.outcome.ok ? kept.outcome.json as T : null;
  }
  failure(command: string): string {
    const kept = this.results.get(command);
    if (!kept || kept.generation !== this.state.generation || kept.outcome.ok) return '';
    return kept.outcome.failure || kept.outcome.problems.map(p => p.message).join('\n');
  }
  /// Why there is no result.
  missing(command: string): string {
    if (this.problems.some(p => p.severity === 'error')) return 'The file has errors; see the messages above.';
    return this.failure(command) || 'Computing …';
  }
  /// Is the result not yet that of the state on the page?
  isOld = (command: string) => this.results.get(command)?.revision !== this.state.revision;
  /// A wish changed, or the program is there again: ask again.
  again() {
    this.asked = {quick: -1, slow: -1};
    this.next();
  }
  subscribe(listener: () => void) {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }

  private next() {
    if (this.underWay) return;
    const {revision} = this.state;
    if (this.asked.quick !== revision) return void this.send('quick', revision);
    if (this.asked.slow === revision) return;
    clearTimeout(this.restTimer);
    this.restTimer = window.setTimeout(() => {
      if (!this.underWay && this.state.revision === revision) this.send('slow', revision);
    }, REST);
  }
  private async send(pace: 'quick' | 'slow', revision: number) {
    const wished = this.wishes().filter(w => (pace === 'slow') === (w.slow ?? false)), wants = wished.map(w => w.want);
    const {generation, change} = this.state;
    this.asked[pace] = revision;
    if (wants.length) {
      this.underWay = true;
      try {
        this.take(await this.engine.ask(revision, {...change, settings: [...change.settings, ...wished.flatMap(w => w.settings ?? [])]}, wants), generation);
        this.trouble = '';
      } catch (error) {
        this.trouble = error instanceof EngineError ? error.message : String(error);
      }
      this.underWay = false;
      for (const listener of this.listeners) listener();
    }
    if (!this.trouble) this.next();
  }
  /// Draws an answer only if it is newer than what is drawn and of the same machine.
  private take(answer: Answer, generation: number) {
    if (generation !== this.state.generation) return;
    this.problems = answer.problems;
    for (const outcome of answer.results) {
      const drawn = this.results.get(outcome.command);
      if (drawn && drawn.generation === generation && drawn.revision > answer.revision) continue;
      this.results.set(outcome.command, {revision: answer.revision, generation, outcome});
    }
  }
}
