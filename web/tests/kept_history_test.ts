// SPDX-License-Identifier: BSD-3-Clause
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {historyOf, keptHistory} from '../src/kept_history.ts';
import {State} from '../src/state.ts';

/// A page with steps of a slider, of the text and of a case, then loaded again from JSON.
function reloaded(state: State): State {
  const again = new State(), kept = JSON.parse(JSON.stringify(keptHistory(state.history))) as ReturnType<typeof keptHistory>;
  again.open('mass = 1', 'v1');
  again.resume(state.design, state.case, historyOf(kept));
  return again;
}
const seen = (state: State) => [state.design.text, [...state.design.settings], state.case, state.isSaved];

test('undo and redo go the same way after a reload', () => {
  const state = new State();
  state.open('mass = 1', 'v1');
  state.set({mass: '2'});
  state.edit('mass = 3');
  state.put({text: 'mass = 3\n[cases.hot]', settings: new Map([['a', '1'], ['b', '2']])}, 'hot');
  state.set({a: '5'});
  state.undo();
  const again = reloaded(state);
  for (const step of ['redo', 'redo', 'undo', 'undo', 'undo', 'undo', 'undo', 'redo'] as const) {
    state[step]();
    again[step]();
    assert.deepEqual(seen(again), seen(state));
  }
});
test('the steps nearest to the present are kept, and each text once', () => {
  const state = new State(), text = 'x'.repeat(1000);
  state.open(text, 'v1');
  for (let i = 0; i < 200; i++) state.set({mass: String(i)});
  for (let i = 0; i < 30; i++) state.undo();
  const {texts, past, future} = keptHistory(state.history);
  assert.deepEqual([texts, past.length, future.length], [[text], 50, 0]);
  assert.equal(past.at(-1)!.settings[0]![1], '168');
  assert.deepEqual([keptHistory(state.history, 190).past.length, keptHistory(state.history, 190).future.length], [170, 20]);
});
test('a history of large texts is bounded', () => {
  const state = new State();
  state.open('a', 'v1');
  for (let i = 0; i < 40; i++) state.edit(`${i}"`.padEnd(100_000, '\n'));
  const kept = keptHistory(state.history);
  assert.ok(kept.past.length > 2 && JSON.stringify(kept).length < 1_010_000);
});
test('without a history the edits are one step of undo', () => {
  const state = new State();
  state.open('mass = 1', 'v1');
  state.resume({text: 'mass = 2', settings: new Map()}, '', {past: [], future: []});
  state.undo();
  assert.ok(state.isSaved && !state.canUndo);
});
