// SPDX-License-Identifier: BSD-3-Clause
// The kernel of a notebook as the engine: questions are messages of the widget, answers are those of `trivet serve`.
import {EngineError, type Answer, type Change, type Engine, type Project, type Want} from './engine.ts';

/// What anywidget gives a widget of its model.
export interface Model {
  get(name: string): unknown;
  set(name: string, value: unknown): void;
  save_changes(): void;
  send(content: unknown): void;
  on(event: string, callback: (...values: never[]) => void): void;
  off(event: string, callback: (...values: never[]) => void): void;
}
/// The project of a widget when it is opened.
export interface Opened extends Project {
  text: string;
  settings: [path: string, value: string][];
  case: string;
  sliders: string[];  // paths that are sliders besides those of the page
  key: string;  // of its still in the notebook
}
interface Waiting {
  done(text: string): void;
  failed(reason: EngineError): void;
}

const ENDED = 'The kernel has ended. Run the cell again.';
const edit = () => Promise.reject(new EngineError('A notebook edits and saves its project in Python.'));

export class KernelEngine implements Engine {
  readonly isLive = true;
  readonly oneAtATime = true;
  private readonly client = Math.random().toString(36).slice(2);  // several views of a widget share its messages
  private readonly waiting = new Map<string, Waiting>();
  private count = 0;
  private ended = false;

  constructor(private readonly model: Model) {
    model.on('msg:custom', this.receive);
    model.on('comm:close', this.end);
    model.on('comm_live_update', this.end);  // the kernel was restarted or is gone
  }
  /// Without a kernel there is never an answer.
  opened = () => this.send<Opened>({ask: 'open'});
  ask(revision: number, {settings, case: name}: Change, wants: readonly Want[], signal?: AbortSignal): Promise<Answer> {
    return this.send<Answer>({ask: 'answer', question: {revision, settings, case: name, wants}}, signal);
  }
  /// The notebook shows this state when there is no kernel any more.
  keep(view: unknown, answer: Answer) { this.model.send({ask: 'keep', view, answer}); }
  close() {
    this.model.off('msg:custom', this.receive);
    this.model.off('comm:close', this.end);
    this.model.off('comm_live_update', this.end);
  }
  project = () => this.opened();
  schema = edit;
  text = edit;
  newCase = edit;
  save = edit;

  /// The kernel computes on when the answer is no longer wanted; it is dropped.
  private send<T>(content: object, signal?: AbortSignal): Promise<T> {
    if (this.ended) return Promise.reject(new EngineError(ENDED));
    if (signal?.aborted) return Promise.reject(signal.reason);
    const id = `${this.client} ${++this.count}`;
    return new Promise((done, failed) => {
      this.waiting.set(id, {done: text => done(JSON.parse(text) as T), failed});
      signal?.addEventListener('abort', () => { if (this.waiting.delete(id)) failed(signal.reason); });
      this.model.send({id, ...content});
    });
  }
  private receive = ({id, error}: {id: string; error?: string}, [data]: DataView[]) => {
    const waiting = this.waiting.get(id);
    if (!waiting) return;  // of another view
    this.waiting.delete(id);
    if (error !== undefined || !data) waiting.failed(new EngineError(error ?? 'The kernel sent no answer.'));
    else waiting.done(new TextDecoder().decode(data));
  };
  private end = () => {
    this.ended = true;
    for (const {failed} of this.waiting.values()) failed(new EngineError(ENDED));
    this.waiting.clear();
  };
}
