// SPDX-License-Identifier: BSD-3-Clause
// The last state of a notebook's widget, without a kernel: it has the results that were kept, and computes nothing.
import {EngineError, type Answer, type Change, type Engine, type Want} from './engine.ts';
import type {Opened} from './kernel_engine.ts';

export interface Kept {
  opened: Opened;
  view: object;  // how the results were shown; see `shownState`
  answer: Answer;
}
const edit = () => Promise.reject(new EngineError('There is no kernel.'));

export class KeptEngine implements Engine {
  readonly isLive = false;
  constructor(private readonly kept: Kept) {}

  project = async () => this.kept.opened;
  schema = edit;
  text = edit;
  newCase = edit;
  save = edit;
  async ask(revision: number, _: Change, wants: readonly Want[]): Promise<Answer> {
    const {ok, problems, results} = this.kept.answer;
    const missing = {ok: false, problems: [], failure: 'This result was not kept.', json: null};
    return {revision, ok, problems, results: wants.map(({command}) => results.find(r => r.command === command) ?? {command, ...missing})};
  }
}
