// SPDX-License-Identifier: BSD-3-Clause
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {Asker} from '../src/asker.ts';
import {ServerEngine, type Answer, type Change, type Engine} from '../src/engine.ts';
import {partsAbove} from '../src/chart/parts_above.ts';
import {State} from '../src/state.ts';

Object.assign(globalThis, {window: globalThis});  // timers

function opened(): State {
  const state = new State();
  state.open('mass = 1', 'v1');
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
test('an unchanged text has the version of the file', () => {
  const state = opened();
  state.set({mass: '2'});
  assert.deepEqual(state.change, {text: 'mass = 1', version: 'v1', settings: ['mass = 2'], case: ''});
  state.edit('mass = 3');
  assert.deepEqual([state.change.text, state.change.version], ['mass = 3', null]);
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
test('another text on the disk is one step of undo, and then the page has edits', () => {
  const state = opened();
  state.replaced('mass = 2', 'v2');
  assert.ok(state.isSaved && !state.hasEdits);
  assert.equal(state.change.version, 'v2');
  state.undo();
  assert.ok(!state.isSaved && state.hasEdits);
  assert.equal(state.design.text, 'mass = 1');
});
test('a deleted file can be saved without an edit', () => {
  const state = opened();
  state.wasDeleted();
  assert.ok(!state.isSaved && !state.hasEdits);
  assert.equal(state.change.version, null);
  state.wasSaved('mass = 1', 'v1');
  assert.ok(state.isSaved);
});

test('a version that the program has no longer is replaced by its text', async () => {
  const bodies: Record<string, unknown>[] = [];
  Object.assign(globalThis, {fetch: (_path: string, {body}: {body: string}) => {
    const asked = JSON.parse(body) as Record<string, unknown>;
    bodies.push(asked);
    return Promise.resolve(new Response('{"results": []}', {status: asked['version'] ? 412 : 200}));
  }});
  const engine = new ServerEngine('token'), state = opened();
  await engine.ask(1, state.change, []);
  await engine.ask(2, state.change, []);
  assert.deepEqual(bodies.map(b => [b['revision'], b['version'], b['text']]),
                   [[1, 'v1', undefined], [1, undefined, 'mass = 1'], [2, undefined, 'mass = 1']]);
});
test('edits made while a file is saved stay', () => {
  const state = opened();
  state.set({'bodies.a.mass': '2'});
  const saved = state.design;
  state.set({'bodies.a.mass': '3'});
  state.wasSaved('mass = 2', 'v2', saved);
  assert.equal(state.design.settings.get('bodies.a.mass'), '3');
  assert.ok(!state.isSaved);
});
test('undo of a new case shows the case before', () => {
  const state = opened();
  state.put({text: 'mass = 1\n[cases.hot]\n', settings: new Map()}, 'hot');
  state.undo();
  assert.equal(state.case, '');
  state.redo();
  assert.equal(state.case, 'hot');
  state.replaced('mass = 1', 'v2');  // another hand removed the case
  assert.equal(state.case, '');
});
test('a setting of the base model leaves a case alone that has its own number', () => {
  const state = new State();
  state.open('[bodies.a]\nmass = 1\n[cases.hot]\nbodies.a.mass = 2\n', 'v1');
  assert.deepEqual(state.change.settings, []);
  state.set({'bodies.a.mass': '3'});
  assert.deepEqual(state.change.settings, ['bodies.a.mass = 3', 'cases.hot.bodies.a.mass = 2']);
  state.set({'cases.hot.bodies.a.mass': '4'});
  assert.deepEqual(state.change.settings, ['bodies.a.mass = 3', 'cases.hot.bodies.a.mass = 4']);
});
