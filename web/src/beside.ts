// SPDX-License-Identifier: BSD-3-Clause
// Results beside those of the state on the page: of another case, or of a command that takes long. Such a question is asked
// when the page rests, is asked again only if something that it depends on changes, and never keeps the page waiting.
import {EngineError, type Answer, type Change, type Engine, type Outcome, type Want} from './engine.ts';

export interface Question {
  key: string;
  change: Change;
  want: Want;
  /// ms after which it is given up until the user wants to wait for it; 0: it is asked only then
  patience?: number;
}
interface Found {
  identity: string;  // of the question that was answered
  outcome: Outcome | null;
  givenUp: string;  // identity of the question that took longer than `patience`; the earlier result stays until another comes
}
const REST = 350;  // ms without a change or an answer of the page

export class BesideResults {
  private readonly found = new Map<string, Found>();
  private running: {key: string; identity: string; stop: AbortController} | null = null;
  private waiting = new Set<string>();  // keys of questions for which the user waits as long as they take
  private timer = 0;
  private readonly listeners = new Set<() => void>();

  constructor(private readonly engine: Pick<Engine, 'ask'>, private readonly wanted: () => readonly Question[]) {}

  result<T>(key: string): T | null {
    const {outcome} = this.found.get(key) ?? {outcome: null};
    return outcome?.ok ? outcome.json as T : null;
  }
  failure(key: string): string {
    const {outcome} = this.found.get(key) ?? {outcome: null};
    return outcome && !outcome.ok ? outcome.failure || outcome.problems.map(p => p.message).join('\n') : '';
  }
  /// Is the result not that of the present numbers?
  isOld(key: string): boolean {
    const question = this.wanted().find(q => q.key === key);
    return question !== undefined && this.found.get(key)?.identity !== identityOf(question);
  }
  /// Was it given up because it takes long, or not even asked?
  takesLong(key: string): boolean {
    const question = this.wanted().find(q => q.key === key), found = this.found.get(key);
    if (question?.patience === undefined || this.waiting.has(key)) return false;
    const now = identityOf(question);
    return found?.identity !== now && (question.patience === 0 || found?.givenUp === now);
  }
  isRunning = (key: string) => this.running?.key === key;
  /// Asks and waits as long as it takes.
  waitFor(key: string) {
    this.waiting.add(key);
    const found = this.found.get(key);
    if (found) found.givenUp = '';
    this.next();
  }
  /// The page asks something: this waits.
  yield() {
    this.running?.stop.abort();
    this.rest();
  }
  /// Something changed: ask once the page rests.
  rest = () => {
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => this.next(), REST);
  };
  subscribe(listener: () => void) {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }

  private next() {
    if (this.running) return;
    const question = this.wanted().find(q => {
      const found = this.found.get(q.key), now = identityOf(q);
      return (q.patience !== 0 || this.waiting.has(q.key)) && found?.identity !== now && found?.givenUp !== now;
    });
    if (question) void this.ask(question, identityOf(question));
  }
  private async ask({key, change, want, patience}: Question, identity: string) {
    const stop = new AbortController();
    let tired = false;
    const limit = patience && !this.waiting.has(key) ? window.setTimeout(() => {
      tired = true;
      stop.abort();
    }, patience) : 0;
    this.running = {key, identity, stop};
    this.notify();
    try {
      const answer: Answer = await this.engine.ask(0, change, [want], stop.signal);
      this.found.set(key, {identity, givenUp: '', outcome: answer.results[0] ?? failed(answer.problems[0]?.message ?? '')});
    } catch (error) {
      const earlier = this.found.get(key);
      if (tired) this.found.set(key, {...earlier?.outcome?.ok ? earlier : {identity: '', outcome: null}, givenUp: identity});
      else if (!stop.signal.aborted) this.found.set(key, {identity, givenUp: '', outcome: failed(error instanceof EngineError ? error.message : String(error))});
    }
    clearTimeout(limit);
    if (!stop.signal.aborted) this.waiting.delete(key);
    this.running = null;
    this.notify();
    if (stop.signal.aborted && !tired) this.rest();
    else this.next();
  }
  private notify() {
    for (const listener of this.listeners) listener();
  }
}
const identityOf = ({change, want}: Question) => JSON.stringify([change, want]);
const failed = (failure: string): Outcome => ({command: '', ok: false, problems: [], failure, json: null});
