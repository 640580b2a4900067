// SPDX-License-Identifier: BSD-3-Clause
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {Asker} from '../src/asker.ts';
import {Display} from '../src/display.ts';
import type {Answer, Change, Engine, Want} from '../src/engine.ts';
import {State} from '../src/state.ts';
import {wishes} from '../src/wishes.ts';

Object.assign(globalThis, {window: globalThis, matchMedia: () => ({matches: false})});
const wanted = (bodies: number, display = new Display()) =>
  wishes(display, {hasSomethingToJudge: false, hasSteady: false, bodies}).filter(w => w.want.command === 'modes');

test('of several bodies one mode shape follows a slider, and all follow at rest', () => {
  const display = new Display();
  display.set({shown: {kind: 'mode', number: 7}});
  const [draft, all] = wanted(10, display);
  assert.deepEqual(draft!.want, {command: 'modes', keys: {'shapes-of': 7}});
  assert.deepEqual([all!.want, all!.after], [{command: 'modes'}, true]);
  assert.deepEqual(wanted(1), [{want: {command: 'modes'}}]);
});

/// Answers at once; modes of which one shape is wanted fail if `failing`.
class QuickEngine {
  failing = false;
  readonly asked: string[] = [];
  ask(revision: number, _: Change, wants: readonly Want[]): Promise<Answer> {
    this.asked.push(wants.map(w => JSON.stringify(w.keys ?? 'all')).join());
    return Promise.resolve({revision, ok: true, problems: [], results: wants.map(({command, keys}) =>
      ({command, ok: !(keys && this.failing), problems: [], json: `${keys ? 'one shape' : 'all shapes'} of ${revision}`}))});
  }
}
const after = (ms: number) => new Promise(done => setTimeout(done, ms));
function played(failing: boolean) {
  const state = new State(), engine = new QuickEngine();
  engine.failing = failing;
  const asker = new Asker(engine as unknown as Engine, state, () => wanted(10));
  state.open('mass = 1', '1');
  return {state, engine, asker, modes: () => asker.result('modes'), still: () => asker.finished};
}
test('a draft stands in for the modes until all of them follow', async () => {
  const {state, asker, engine, modes, still} = played(false), first = state.revision;
  await after(5);
  assert.equal(modes(), `one shape of ${first}`);
  assert.ok(!asker.isOld('modes'));
  assert.equal(still(), null);  // a still has all shapes
  await after(130);
  assert.equal(modes(), `all shapes of ${first}`);
  assert.deepEqual(still()?.results.map(r => r.json), [`all shapes of ${first}`]);
  state.set({mass: '2'}, true);
  await after(5);
  assert.equal(modes(), `one shape of ${state.revision}`);
  assert.deepEqual(engine.asked.slice(0, 3), ['{"shapes-of":1}', '"all"', '{"shapes-of":1}']);
});
test('a draft that fails leaves the modes as they are', async () => {
  const {state, modes} = played(true);
  await after(130);
  assert.equal(modes(), `all shapes of ${state.revision}`);
});
