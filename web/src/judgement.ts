// SPDX-License-Identifier: BSD-3-Clause
import type {App} from './part.ts';
import {number} from './quantities.ts';
import type {Curves, Verdict} from './results.ts';

/// What the pill says of the design.
export interface Judgement {
  state: 'met' | 'violated' | 'none' | 'error' | 'unknown';
  words: string;
  old: boolean;
}
export const hasRequirements = (app: App) => [...app.index.byPath.values()].some(e => e.path[0] === 'requirements');

export function judgement(app: App): Judgement {
  const {asker, state} = app, errors = asker.problems.filter(p => p.severity === 'error');
  if (errors.length) return {state: 'error', words: errors.length === 1 ? '1 error in the file' : `${errors.length} errors in the file`, old: false};
  const verdict = asker.result<Verdict>('verdict'), curves = asker.result<Curves>('curves');
  if (verdict) {
    const found = verdict.cases.find(c => c.case === state.case) ?? verdict.cases[0], all = found?.requirements ?? [];
    const violated = all.filter(r => r.judged && !r.met), old = asker.isOld('verdict');
    if (violated.length) return {state: 'violated', words: `${violated.length} of ${all.length} requirements violated`, old};
    const elsewhere = verdict.cases.find(c => c.decides && !c.met);
    if (elsewhere) return {state: 'violated', words: `met here, violated in ${elsewhere.case ? `case ${elsewhere.case}` : 'the base model'}`, old};
    const margin = found?.governing == null ? null : all[found.governing]?.margin;
    return {state: 'met', words: `all ${all.length} requirements met${margin == null ? '' : `, least margin ${number(margin, 3)}`}`, old};
  }
  if (hasRequirements(app)) return {state: 'unknown', words: asker.failure('verdict') ? 'not judged' : 'judging', old: !asker.failure('verdict')};
  const limits = curves?.limits ?? [];
  if (!limits.length) return {state: 'none', words: 'no requirements', old: false};
  const over = limits.filter(l => curves!.peaks.some(p => p.result === l.result && (p.amplitude === null || p.amplitude > l.limit)));
  return over.length ? {state: 'violated', words: `${over.length} of ${limits.length} limits exceeded`, old: asker.isOld('curves')}
                     : {state: 'met', words: `below all ${limits.length} limits`, old: asker.isOld('curves')};
}
