// SPDX-License-Identifier: BSD-3-Clause
// The seam: what the page asks and who answers. Everything that the page shows is a result of a command of the program.
import {worded} from './problem_words.ts';
import type {Problem} from './results.ts';
import {keepToken, newNonce, openedToken, type SealedToken} from './token.ts';

/// What is on the page: the text of the project file, the numbers that sliders changed, and the case.
export interface Change {
  text: string;
  version: string | null;  // of the file on the disk that had this text; null: the text was edited
  settings: readonly string[];  // "PATH = VALUE", as with --set
  case: string;
}
export interface Want {
  command: string;
  keys?: Record<string, unknown>;
  known?: string;  // hash of a result that is not sent again if it is the same
}
export interface Outcome {
  command: string;
  ok: boolean;
  problems: Problem[];
  failure?: string;
  notes?: readonly string[];  // what the program prints before the result
  hash?: string;
  same?: boolean;  // the known one
  json: unknown;
}
export interface Answer {
  revision: number;
  ok: boolean;
  problems: Problem[];
  results: Outcome[];
}
export interface Example {
  name: string;
  title: string;
  text: string;
}
/// A mount of the catalogue that comes with the program.
export interface CatalogueMount {
  name: string;
  stiffness: [number, number, number];  // [N/m]
  static_load: [number, number] | null;  // along its axis [N]
}
export interface Project {
  name: string | null;
  title?: string;
  text?: string | null;  // null: the page cannot have it; `problems` say why
  version?: string;
  problems?: Problem[];
  read_only?: boolean;
  cases?: string[];
  program?: string;
  examples?: Example[];
  mounts?: CatalogueMount[];
  resume_key?: string;
}
/// What the program computes now.
export interface Doing {
  task: string;
  fraction: number;  // 0 … 1
}
/// What is on the disk now; `text` is null if the page cannot have it, and `problems` say why.
export interface OnDisk {
  version: string;
  text: string | null;
  problems: Problem[];
}
/// `conflict`: another hand changed the file meanwhile.
export type Saved = {conflict: false; version: string} | {conflict: true} & OnDisk;

export interface Engine {
  /// False: it has kept results only, and computes nothing new.
  readonly isLive: boolean;
  /// True: a question cannot be ended, and others wait until it is answered.
  readonly oneAtATime?: boolean;
  project(): Promise<Project>;
  schema(): Promise<unknown>;
  /// Of the project file as it is on the disk now; empty: it cannot be read. Absent: there is no file that could change.
  version?(): Promise<string>;
  /// `signal`: the answer is no longer wanted.
  ask(revision: number, change: Change, wants: readonly Want[], signal?: AbortSignal): Promise<Answer>;
  /// Null: no question of this page takes longer than a moment.
  doing?(): Promise<Doing | null>;
  /// The text with the settings written into it; every other byte stays.
  text(change: Change): Promise<string>;
  /// The text with a further case: the changes of the case on the page, and the settings.
  newCase(change: Change, name: string): Promise<string>;
  save(version: string, change: Change): Promise<Saved>;
}

/// The server went away, or it rejected the request: `message` says what to do.
export class EngineError extends Error {
  /// @param isSilent  the program does not answer at all
  /// @param isListed  its problems are more than the message states: the list of messages has them
  constructor(message: string, readonly isSilent = false, readonly isListed = false) { super(message); }
}

/// The engine behind `trivet serve`.
export class ServerEngine implements Engine {
  readonly isLive = true;
  private readonly client = crypto.randomUUID();  // a newer question ends an older one of the same tab only

  private resumeKey = '';  // not in the storage of the tab: another program at this port could read it after a reload
  private isLost = false;  // until the program answers again, and has proved that it is it
  private isForeign = false;  // what answers is not it, or has a token that this tab cannot get

  constructor(private token: string) {}
  /// Of another start of the program.
  useToken(token: string) {
    [this.token, this.isLost, this.isForeign] = [token, false, false];
  }
  async project(): Promise<Project> {
    const project = await this.get<Project>('/project');
    this.resumeKey = project.resume_key ?? '';
    return project;
  }
  schema = () => this.get<unknown>('/schema');
  async version(): Promise<string> {
    if (this.isLost) await this.resume();
    return (await this.get<{version: string}>('/version')).version;
  }

  /// An unedited text is not sent again, unless the program has opened another version of the file meanwhile.
  ask(...question: Parameters<Engine['ask']>): Promise<Answer> {
    return this.askAs(this.client, ...question);
  }
  /// The same program for questions beside those of the page: neither ends the other.
  beside(): Pick<Engine, 'ask'> {
    const client = crypto.randomUUID();
    return {ask: (...question) => this.askAs(client, ...question)};
  }
  private async askAs(client: string, revision: number, {text, version, settings, case: name}: Change, wants: readonly Want[],
                      signal?: AbortSignal): Promise<Answer> {
    const question = {revision, settings, case: name, wants}, began = {at: performance.now(), client};
    this.underWay.add(began);
    try {
      if (version && version !== this.closed) {
        const response = await this.posed({version, ...question}, signal, client);
        if (response.status !== 412) return await content<Answer>(response);
        this.closed = version;
      }
      return await content<Answer>(await this.posed({text, ...question}, signal, client));
    } finally {
      this.underWay.delete(began);
    }
  }
  /// A client has one question at a time. An aborted one may still reach the program after the next, on another connection, and
  /// replace it there (409): then the next is asked again.
  private async posed(question: unknown, signal: AbortSignal | undefined, client: string): Promise<Response> {
    for (let tries = 1; ; tries++) {
      const response = await this.request('/ask', question, signal, client);
      if (response.status !== 409 || signal?.aborted || tries === MOST_TRIES) return response;
    }
  }
  async doing(): Promise<Doing | null> {
    const now = performance.now();
    const longest = [...this.underWay].find(({at}) => now - at > MOMENT);
    if (!longest) return null;
    const response = await this.request('/progress', undefined, undefined, longest.client);
    const {task, fraction = 0} = await content<{task: string | null; fraction?: number}>(response);
    return task === null ? null : {task, fraction};
  }
  private readonly underWay = new Set<{at: number; client: string}>()  // the oldest first;
  private closed = '';  // version that the program has no longer
  async text(change: Change): Promise<string> {
    return (await this.post<{text: string}>('/text', textOf(change))).text;
  }
  async newCase(change: Change, name: string): Promise<string> {
    return (await this.post<{text: string}>('/text', {...textOf(change), case: change.case, new_case: name})).text;
  }
  async save(version: string, change: Change): Promise<Saved> {
    const response = await this.request('/save', {version, ...textOf(change)});
    if (response.status === 409) return {conflict: true, ...(await response.json())};
    return {conflict: false, ...(await content<{version: string}>(response))};
  }

  private get = async <T>(path: string): Promise<T> => content<T>(await this.request(path));
  private post = async <T>(path: string, data: unknown): Promise<T> => content<T>(await this.request(path, data));
  private async request(path: string, data?: unknown, signal?: AbortSignal, client: string = this.client): Promise<Response> {
    if (this.isLost) throw new EngineError(SILENT, true);  // until `version` finds it again: nothing goes to a stranger
    const headers: Record<string, string> = {'X-Trivet-Token': this.token, 'X-Trivet-Client': client};
    if (data !== undefined) headers['Content-Type'] = 'application/json';
    const response = await this.fetched(path, data === undefined ? {headers} : {method: 'POST', headers, body: JSON.stringify(data), ...(signal ? {signal} : {})});
    if (response.status === 401) this.isLost = true;  // another start of the program, or another program
    return response;
  }
  private async fetched(path: string, init: RequestInit): Promise<Response> {
    try {
      return await fetch(path, init);
    } catch (reason) {
      if (init.signal?.aborted) throw reason;
      this.isLost = true;
      throw new EngineError(SILENT, true);
    }
  }
  /// Goes on with a program that was started again, at this address and with another token.
  private async resume() {
    if (this.isForeign) throw new EngineError(STRANGER);
    const key = this.resumeKey, nonce = newNonce(), response = await this.fetched('/resume', {headers: {'X-Trivet-Nonce': nonce}});
    const token = response.ok && key ? await openedToken(await response.json() as SealedToken, key, location.port, nonce) : null;
    if (token === null) throw this.foreign();
    keepToken(token);
    this.token = token;
    if ((await this.fetched('/version', {headers: {'X-Trivet-Token': this.token}})).status === 401) throw this.foreign();
    this.isLost = false;
  }
  private foreign() {
    this.isForeign = true;
    return new EngineError(STRANGER);
  }
}
const MOMENT = 500;  // ms
const MOST_TRIES = 4;  // of a question: one aborted question replaces it at most once
const SILENT = 'The program does not answer. The page goes on by itself when it runs again.';
const STRANGER = 'The program was started again with another token. Open the address that it prints in this tab.';

const textOf = ({text, settings}: Change) => ({text, settings});

async function content<T>(response: Response): Promise<T> {
  if (response.ok) return response.json() as Promise<T>;
  const {error, problems = []} = await response.json().catch(() => ({error: `The program answered ${response.status}.`})) as
      {error: string; problems?: Problem[]};
  const errors = problems.filter(p => p.severity === 'error');
  if (errors.length > 1) throw new EngineError(`${error}: ${errors.length} errors`, false, true);
  throw new EngineError([error, ...errors.map(p => worded(p))].join(': '));
}
