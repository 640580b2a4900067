// SPDX-License-Identifier: BSD-3-Clause
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {Asker} from '../src/asker.ts';
import type {Answer, Change, Engine} from '../src/engine.ts';
import {partsAbove} from '../src/chart/parts_above.ts';
import {State} from '../src/state.ts';

Object.assign(globalThis, {window: globalThis});  // timers

function opened(): State {
  const state = new State();
  state.open('mass = 1', true);
  return state;
}
test('a drag is one step of undo', () => {
  const state = opened();
  for (const value of ['2', '3', '4']) state.set({mass: value}, true);
  state.dropped();
  state.set({mass: '9'});
  state.undo();
  assert.equal(state.design.settings.get('mass'), '4');
  state.undo();
  assert.equal(state.design.settings.size, 0);
  assert.ok(!state.canUndo && state.isSaved);
  state.redo();
  assert.equal(state.design.settings.get('mass'), '4');
});
test('an unchanged text is not sent again', () => {
  const state = opened();
  state.set({mass: '2'});
  assert.deepEqual(state.change, {text: null, settings: ['mass = 2'], case: ''});
  state.edit('mass = 3');
  assert.equal(state.change.text, 'mass = 3');
});
test('a new edit ends what redo could bring back', () => {
  const state = opened();
  state.edit('a');
  state.undo();
  state.edit('b');
  assert.ok(!state.canRedo);
});

/// An engine that answers when the test wants.
class SlowEngine {
  readonly asked: {revision: number; change: Change; answer: (json: unknown) => Promise<void>}[] = [];
  ask(revision: number, change: Change): Promise<Answer> {
    return new Promise(resolve => this.asked.push({revision, change, answer: async json => {
      resolve({revision, ok: true, problems: [], results: [{command: 'modes', ok: true, problems: [], json}]});
      await new Promise(done => setTimeout(done, 0));
    }}));
  }
}
function playing() {
  const engine = new SlowEngine(), state = opened(), asker = new Asker(engine as unknown as Engine, state, () => [{want: {command: 'modes'}}]);
  state.set({mass: '1'}, true);
  return {engine, state, asker};
}
test('one question is under way, and the next is about the newest state', async () => {
  const {engine, state} = playing();
  for (const value of ['2', '3', '4']) state.set({mass: value}, true);
  assert.equal(engine.asked.length, 1);
  await engine.asked[0]!.answer('first');
  assert.equal(engine.asked.length, 2);
  assert.deepEqual(engine.asked[1]!.change.settings, ['mass = 4']);
});
test('a result of an earlier position is drawn and marked as old', async () => {
  const {engine, state, asker} = playing();
  state.set({mass: '2'}, true);
  await engine.asked[0]!.answer('first');
  assert.equal(asker.result('modes'), 'first');
  assert.ok(asker.isOld('modes'));
  await engine.asked[1]!.answer('second');
  assert.ok(!asker.isOld('modes'));
});
test('a result of another text or case is never drawn', async () => {
  const {engine, state, asker} = playing();
  state.chooseCase('cold');
  await engine.asked[0]!.answer('of the base model');
  assert.equal(asker.result('modes'), null);
  await engine.asked[1]!.answer('of the cold case');
  assert.equal(asker.result('modes'), 'of the cold case');
});
test('the part of a curve above its limit begins and ends on it', () => {
  assert.deepEqual(partsAbove([0, 1, 2, 3], [0, 4, 0, null], 2), [[[0.5, 2], [1, 4], [1.5, 2]]]);
  assert.deepEqual(partsAbove([0, 1], [1, 1], 2), []);
});
