// SPDX-License-Identifier: BSD-3-Clause
// What is drawn beside the curves of the page: other cases, the machine on three springs, measurements.
import type {Question} from './beside.ts';
import type {Compared} from './chart/overlays.ts';
import type {App} from './part.ts';
import type {Curves, Measurement} from './results.ts';

export const KEPT = 'kept';
const CASE = 'case ', SPRINGS = 'three springs', MEASURED = 'measured';
const DASHES: readonly (readonly number[])[] = [[7, 3], [2, 3], [9, 3, 2, 3], [4, 2, 1, 2, 1, 2]];

/// What can be compared with the curves of this file.
export function comparable(app: App): string[] {
  if (!app.engine.isLive) return [];
  const {cases, state, index} = app, measured = [...index.byPath.values()].some(e => e.path[0] === 'measurements');
  return [...cases.filter(c => c !== state.case).map(c => CASE + c), SPRINGS, ...measured ? [MEASURED] : []];
}
export const wordsOf = (key: string) => (key === CASE ? 'base model' : key === SPRINGS ? 'mounts as three springs' : key);

/// Those that the user chose; measurements until he puts them away.
const chosen = (app: App) => comparable(app).filter(key => app.display.compared.get(key) ?? key === MEASURED);
export const isCompared = (app: App, key: string) => chosen(app).includes(key);

export function comparedQuestions(app: App): Question[] {
  const {change} = app.state, {quantity} = app.display, keys = quantity ? {quantity} : {};
  return chosen(app).map((key): Question => {
    if (key === MEASURED) return {key, change, want: {command: 'measurements'}};
    if (key === SPRINGS) return {key, change, want: {command: 'curves', keys: {...keys, 'three-springs': true}}};
    return {key, change: {...change, case: key.slice(CASE.length)}, want: {command: 'curves', keys}};
  });
}
export function comparisons(app: App, kept: Curves | null): Compared[] {
  const {beside} = app, excited = app.asker.result<Curves>('curves')?.models[0]?.excitations ?? [];
  const found = chosen(app).map((key, i): Compared => {
    const measured = key === MEASURED ? beside.result<Measurement[]>(key) ?? [] : undefined;
    const alone = measured?.map(m => m.excitation).filter(e => e !== null && !(excited.length === 1 && excited[0] === e)) ?? [];
    return {key, label: wordsOf(key) + (alone.length ? ` (${alone.join(', ')} alone)` : ''), curves: measured ? null : beside.result<Curves>(key), ...measured ? {measured} : {}, old: beside.isOld(key),
            failure: beside.failure(key), dash: DASHES[i % DASHES.length]!};
  });
  return kept ? [...found, {key: KEPT, label: 'kept', curves: kept, old: false, failure: '', dash: [4, 3]}] : found;
}
