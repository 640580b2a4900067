// SPDX-License-Identifier: BSD-3-Clause
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {Asker, type Wish} from '../src/asker.ts';
import type {Answer, Change, Want} from '../src/engine.ts';
import type {KernelEngine, Model} from '../src/kernel_engine.ts';
import type {App} from '../src/part.ts';
import {keepAtRest} from '../src/shown_state.ts';
import {State} from '../src/state.ts';

Object.assign(globalThis, {window: globalThis});  // timers

const WISHES: Wish[] = [{want: {command: 'scene'}}, {want: {command: 'curves', keys: {draft: true}}, as: 'draft'},
                        {want: {command: 'curves'}, exact: true}, {want: {command: 'verdict'}, slow: true}];
async function until(condition: () => boolean) {
  for (let i = 0; i < 500 && !condition(); i++) await new Promise(done => setTimeout(done, 10));
  assert.ok(condition());
}
/// A machine whose scene is always the same, and what is kept of it.
function played() {
  const kept: {view: unknown; answer: Answer}[] = [], wants: Want[] = [], state = new State();
  const engine = {
    keep(view: unknown, answer: Answer) { kept.push({view, answer}); },
    ask: async (revision: number, {settings}: Change, wanted: readonly Want[]): Promise<Answer> => {
      wants.push(...wanted);
      return {revision, ok: true, problems: [], results: wanted.map(({command, keys, known}) => {
        const json = command === 'scene' ? 'box' : `${command}${keys ? ' draft' : ''} of ${settings}`, hash = json, same = known === hash;
        return {command, ok: true, problems: [], hash, same, json: same ? null : json};
      })};
    }};
  const asker = new Asker(engine, state, () => WISHES), display = {shown: {kind: 'rest'}, subscribe: () => () => {}};
  const model = {set() {}, save_changes() {}} as unknown as Model;
  const end = keepAtRest({state, asker, display} as unknown as App, engine as unknown as KernelEngine, model);
  return {state, asker, kept, wants, end};
}

test('what is kept is the whole page at rest: also results that were not sent again, and no drafts', async () => {
  const {state, asker, kept, wants, end} = played();
  state.open('mass = 1', '1');
  assert.equal(asker.finished, null);
  await until(() => kept.length === 1);
  state.set({mass: '2'}, true);
  assert.equal(asker.finished, null);
  await until(() => kept.length === 2);
  assert.ok(wants.some(w => w.command === 'scene' && w.known === 'box'));
  const result = (command: string, json: string) => ({command, ok: true, problems: [], json});
  assert.deepEqual(kept[1]!.answer.results, [result('scene', 'box'), result('curves', 'curves of mass = 2'), result('verdict', 'verdict of mass = 2')]);
  asker.again();  // with the same results
  await new Promise(done => setTimeout(done, 900));
  assert.equal(kept.length, 2);
  end();
});
