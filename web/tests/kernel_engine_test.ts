// SPDX-License-Identifier: BSD-3-Clause
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {KeptEngine} from '../src/kept_engine.ts';
import {KernelEngine, type Model} from '../src/kernel_engine.ts';

const change = {text: '', version: null, settings: ['bodies.a.mass = 2'], case: 'full'};

/// A model that keeps what was sent, and its kernel's part.
function model() {
  const sent: {id: string; ask: string; question?: unknown}[] = [], listeners = new Map<string, Set<(...values: unknown[]) => void>>();
  const of = (event: string) => listeners.get(event) ?? listeners.set(event, new Set()).get(event)!;
  const fake = {get() {}, set() {}, save_changes() {}, send: (content: typeof sent[number]) => { sent.push(content); },
                on: (event: string, call: never) => { of(event).add(call); }, off: (event: string, call: never) => { of(event).delete(call); }};
  const emit = (event: string, ...values: unknown[]) => { for (const call of of(event)) call(...values); };
  const answer = (id: string, value: unknown) => emit('msg:custom', {id}, [new DataView(new TextEncoder().encode(JSON.stringify(value)).buffer)]);
  return {fake: fake as unknown as Model, sent, emit, answer, count: () => [...listeners.values()].reduce((sum, all) => sum + all.size, 0)};
}

test('an answer belongs to its question, whatever the order and the view', async () => {
  const {fake, sent, answer} = model(), one = new KernelEngine(fake), other = new KernelEngine(fake);
  const first = one.ask(4, change, [{command: 'modes'}]), second = one.ask(5, change, []), third = other.ask(6, change, []);
  assert.deepEqual(sent[0]!.question, {revision: 4, settings: ['bodies.a.mass = 2'], case: 'full', wants: [{command: 'modes'}]});
  for (const at of [2, 0, 1]) answer(sent[at]!.id, {revision: 4 + at});
  assert.deepEqual(await Promise.all([first, second, third]), [{revision: 4}, {revision: 5}, {revision: 6}]);
});

test('an error of the kernel and its end are reasons, and nothing waits for ever', async () => {
  const {fake, sent, emit} = model(), engine = new KernelEngine(fake), failed = engine.ask(1, change, []), waiting = engine.ask(2, change, []);
  emit('msg:custom', {id: sent[0]!.id, error: 'interrupted'}, []);
  await assert.rejects(failed, /interrupted/);
  emit('comm_live_update');
  await assert.rejects(waiting, /kernel has ended/);
  await assert.rejects(engine.ask(3, change, []), /kernel has ended/);
  assert.equal(sent.length, 2);
});

test('a question that is no longer wanted fails at once, and its answer is dropped', async () => {
  const {fake, sent, answer} = model(), engine = new KernelEngine(fake), end = new AbortController();
  const old = engine.ask(1, change, [], end.signal), wanted = engine.ask(2, change, []);
  end.abort();
  await assert.rejects(old, {name: 'AbortError'});
  answer(sent[0]!.id, {revision: 1});
  answer(sent[1]!.id, {revision: 2});
  assert.deepEqual(await wanted, {revision: 2});
  await assert.rejects(engine.ask(3, change, [], end.signal), {name: 'AbortError'});
  assert.equal(sent.length, 2);
});

test('a closed view hears nothing more', () => {
  const {fake, count} = model(), engine = new KernelEngine(fake);
  assert.equal(count(), 3);
  engine.close();
  assert.equal(count(), 0);
});

test('kept results answer every revision; others have a reason', async () => {
  const modes = {command: 'modes', ok: true, problems: [], json: {modes: []}};
  const engine = new KeptEngine({opened: {} as never, view: {}, answer: {revision: 0, ok: true, problems: [], results: [modes]}});
  const answer = await engine.ask(7, change, [{command: 'modes'}, {command: 'shapes'}]);
  assert.equal(answer.revision, 7);
  assert.equal(answer.results[0], modes);
  assert.deepEqual([answer.results[1]!.ok, answer.results[1]!.failure], [false, 'This result was not kept.']);
});
