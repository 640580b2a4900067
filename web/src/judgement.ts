// SPDX-License-Identifier: BSD-3-Clause
import type {App} from './part.ts';
import {number} from './quantities.ts';
import type {Verdict} from './results.ts';

/// What the pill says of the design.
export interface Judgement {
  state: 'met' | 'violated' | 'unjudged' | 'unbinding' | 'none' | 'error' | 'unknown';  // unbinding: violated, but only where nothing is binding
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

type CaseVerdict = Verdict['cases'][number];
const nameOf = (one: {case: string}) => (one.case ? `case ${one.case}` : 'the base model');
const violates = (one: CaseVerdict) => one.requirements.some(r => r.judged && !r.met);

export function judgement(app: App): Judgement {
  const {asker, state} = app, errors = asker.problems.filter(p => p.severity === 'error');
  if (errors.length) return {state: 'error', words: errors.length === 1 ? '1 error in the file' : `${errors.length} errors in the file`, old: false};
  const verdict = asker.result<Verdict>('verdict');
  if (verdict) {
    const found = verdict.cases.find(c => c.case === state.case) ?? verdict.cases[0], all = found?.requirements ?? [];
    const violated = all.filter(r => r.judged && !r.met), unjudged = all.filter(r => !r.judged), old = asker.isOld('verdict');
    const not = unjudged.length ? `${unjudged.length} of ${all.length} requirements not judged` : '';
    const wrong = [...violated.length ? [`${violated.length} of ${all.length} requirements violated`] : [], ...not ? [not] : []].join(', ');
    if (!found?.met && found?.decides !== false) return {state: violated.length ? 'violated' : 'unjudged', words: wrong || 'not met', old};
    const elsewhere = verdict.cases.find(c => c !== found && c.decides && !c.met);
    const there = elsewhere ? `${violates(elsewhere) ? 'violated' : 'not judged'} in ${nameOf(elsewhere)}` : '', here = `${wrong} here, not binding`;
    if (there) return {state: 'violated', words: found.met ? `met here, ${there}` : `${there}; ${here}`, old};
    if (!found.met) return {state: 'unbinding', words: here, old};
    const least = verdict.least_margin, where = least && least.case !== found.case ? ` in ${nameOf(least)}` : '';
    return {state: 'met', words: `${all.length === 1 ? 'the requirement is' : `all ${all.length} requirements`} met${least ? `, least margin ${number(least.margin, 4)}${where}` : ''}`, old};
  }
  if (!hasSomethingToJudge(app)) return {state: 'none', words: 'no requirements', old: false};
  return {state: 'unknown', words: asker.failure('verdict') ? 'not judged' : 'judging', old: !asker.failure('verdict')};
}
