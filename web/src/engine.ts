// SPDX-License-Identifier: BSD-3-Clause
// The seam: what the page asks and who answers. Everything that the page shows is a result of a command of the program.
import type {Problem} from './results.ts';

/// What is on the page: the text of the project file, the numbers that sliders changed, and the case.
export interface Change {
  text: string | null;  // null: the file as it was opened
  settings: readonly string[];  // "PATH = VALUE", as with --set
  case: string;
}
export interface Want {
  command: string;
  keys?: Record<string, unknown>;
}
export interface Outcome {
  command: string;
  ok: boolean;
  problems: Problem[];
  failure?: string;
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
export interface Project {
  name: string | null;
  title?: string;
  text?: string;
  version?: string;
  read_only?: boolean;
  cases?: string[];
  program?: string;
  examples?: Example[];
}
/// `conflict`: another hand changed the file meanwhile; `text` is what is on disk now.
export type Saved = {conflict: false; version: string} | {conflict: true; version: string; text: string};

export interface Engine {
  project(): Promise<Project>;
  schema(): Promise<unknown>;
  ask(revision: number, change: Change, wants: readonly Want[]): Promise<Answer>;
  /// The text with the settings written into it; every other byte stays.
  text(change: Change): Promise<string>;
  save(version: string, change: Change): Promise<Saved>;
}

/// The server went away, or it rejected the request: `message` says what to do.
export class EngineError extends Error {}

/// The engine behind `trivet serve`.
export class ServerEngine implements Engine {
  private readonly client = crypto.randomUUID();  // a newer question ends an older one of the same tab only

  constructor(private readonly token: string) {}

  project = () => this.get<Project>('/project');
  schema = () => this.get<unknown>('/schema');

  ask(revision: number, change: Change, wants: readonly Want[]): Promise<Answer> {
    return this.post<Answer>('/ask', {revision, ...body(change), wants});
  }
  async text(change: Change): Promise<string> {
    return (await this.post<{text: string}>('/text', body(change))).text;
  }
  async save(version: string, change: Change): Promise<Saved> {
    const response = await this.request('/save', {version, ...body(change)});
    if (response.status === 409) return {conflict: true, ...(await response.json())};
    return {conflict: false, ...(await content<{version: string}>(response))};
  }

  private get = async <T>(path: string): Promise<T> => content<T>(await this.request(path));
  private post = async <T>(path: string, data: unknown): Promise<T> => content<T>(await this.request(path, data));
  private async request(path: string, data?: unknown): Promise<Response> {
    const headers: Record<string, string> = {'X-Trivet-Token': this.token, 'X-Trivet-Client': this.client};
    if (data !== undefined) headers['Content-Type'] = 'application/json';
    try {
      return await fetch(path, data === undefined ? {headers} : {method: 'POST', headers, body: JSON.stringify(data)});
    } catch {
      throw new EngineError('The program does not answer. Start "trivet serve" again; your edits are still on this page.');
    }
  }
}

const body = ({text, settings, case: name}: Change) => ({...(text === null ? {} : {text}), settings, case: name});

async function content<T>(response: Response): Promise<T> {
  if (response.ok) return response.json() as Promise<T>;
  const {error, problems = []} = await response.json().catch(() => ({error: `The program answered ${response.status}.`})) as
      {error: string; problems?: Problem[]};
  throw new EngineError([error, ...problems.map(p => p.message)].join(': '));
}

/// The token of this tab: once in the fragment of the address, then only in the storage of the tab.
export function tokenOfTab(): string {
  const inAddress = new URLSearchParams(location.hash.slice(1)).get('token');
  if (inAddress) {
    sessionStorage.setItem('token', inAddress);
    history.replaceState(null, '', location.pathname);
  }
  return sessionStorage.getItem('token') ?? '';
}
