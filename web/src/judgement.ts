// SPDX-License-Identifier: BSD-3-Clause
import type {App} from './part.ts';
import {number} from './quantities.ts';
import type {Verdict} from './results.ts';

/// What the pill says of the design.
export interface Judgement {
  state: 'met' | 'violated' | 'none' | 'error' | 'unknown';
  words: string;
  old: boolean;
}

/// Tables that `verdict` judges, also those of a case.
const JUDGED = ['requirements', 'limits', 'limit_lines', 'clearances', 'operation'];
export const hasSomethingToJudge = (app: App) =>
  [...app.index.byPath.values()].some(({path}) => {
    const [table, key] = path[0] === 'cases' ? path.slice(2) : path;
    return JUDGED.includes(String(table)) && (table !== 'operation' || key === 'limits');
  });

export function judgement(app: App): Judgement {
  const {asker, state} = app, errors = asker.problems.filter(p => p.severity === 'error');
  if (errors.length) return {state: 'error', words: errors.length === 1 ? '1 error in the file' : `${errors.length} errors in the file`, old: false};
  const verdict = asker.result<Verdict>('verdict');
  if (verdict) {
    const found = verdict.cases.find(c => c.case === state.case) ?? verdict.cases[0], all = found?.requirements ?? [];
    const violated = all.filter(r => r.judged && !r.met), old = asker.isOld('verdict');
    if (violated.length) return {state: 'violated', words: `${violated.length} of ${all.length} requirements violated`, old};
    const elsewhere = verdict.cases.find(c => c.decides && !c.met);
    if (elsewhere) return {state: 'violated', words: `met here, violated in ${elsewhere.case ? `case ${elsewhere.case}` : 'the base model'}`, old};
    const margin = found?.governing == null ? null : all[found.governing]?.margin;
    return {state: 'met', words: `all ${all.length} requirements met${margin == null ? '' : `, least margin ${number(margin, 3)}`}`, old};
  }
  if (!hasSomethingToJudge(app)) return {state: 'none', words: 'no requirements', old: false};
  return {state: 'unknown', words: asker.failure('verdict') ? 'not judged' : 'judging', old: !asker.failure('verdict')};
}
