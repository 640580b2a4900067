// SPDX-License-Identifier: BSD-3-Clause
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {Asker, type Wish} from '../src/asker.ts';
import {DrawnCurves} from '../src/drawn_curves.ts';
import type {Answer, Change, Engine, Want} from '../src/engine.ts';
import type {Curves} from '../src/results.ts';
import {State} from '../src/state.ts';

const WISHES: Wish[] = [{want: {command: 'curves', keys: {draft: true}}, as: 'draft'}, {want: {command: 'curves'}, exact: true},
                        {want: {command: 'check'}, slow: true}];
interface Question {
  revision: number;
  wants: readonly Want[];
  signal: AbortSignal;
  answer: () => void;
}
/// An engine that answers when the test wants; a question that is no longer wanted fails.
class SlowEngine {
  readonly asked: Question[] = [];
  ask(revision: number, _: Change, wants: readonly Want[], signal: AbortSignal): Promise<Answer> {
    return new Promise((resolve, reject) => {
      signal.addEventListener('abort', () => reject(new Error('aborted')));
      this.asked.push({revision, wants, signal, answer: () => resolve({revision, ok: true, problems: [], results: wants.map(want =>
        ({command: want.command, ok: true, problems: [], json: curves(want.keys ? [] : [{result: 'z', limit: revision}])}))})});
    });
  }
}
const curves = (limits: Curves['limits']): Curves => ({band: [0, 1], results: [], models: [], peaks: [], natural: [], limits, vanishing: limits.length ? ['y'] : []});
const after = (ms: number) => new Promise(done => setTimeout(done, ms));

function played() {
  const state = new State(), engine = new SlowEngine(), asker = new Asker(engine as unknown as Engine, state, () => WISHES);
  state.open('mass = 1', '1');
  return {state, engine, asker};
}
const wanted = (question?: Question) => question?.wants.map(w => w.command + (w.keys ? ' draft' : '')).join();

test('curves come as a draft at once, and with exact peaks when the slider rests', async () => {
  const start = performance.now(), {state, engine, asker} = played();
  assert.equal(wanted(engine.asked[0]), 'curves draft');
  engine.asked[0]!.answer();
  await after(5);
  if (performance.now() - start < 65) assert.equal(engine.asked.length, 1);  // it does not rest yet
  assert.ok(!asker.isOld('draft') && asker.isOld('curves'));
  await after(130);
  assert.equal(wanted(engine.asked[1]), 'curves');
  engine.asked[1]!.answer();
  await after(5);
  assert.ok(!asker.isOld('curves'));
  assert.equal(engine.asked.length, 2);
  await after(220);
  assert.equal(wanted(engine.asked[2]), 'check');
  assert.ok(engine.asked.every(q => q.revision === state.revision));
});
test('a hand that stops for a moment asks for no exact peaks', async () => {
  const {state, engine} = played();
  engine.asked[0]!.answer();
  await after(5);
  let longest = 0, last = performance.now();
  for (let move = 0; move < 4; move++) {
    state.set({mass: String(move)}, true);
    longest = Math.max(longest, performance.now() - last);
    last = performance.now();
    await after(5);
    engine.asked.at(-1)!.answer();
    await after(40);
  }
  if (longest < 65) assert.ok(engine.asked.every(q => wanted(q) === 'curves draft'));  // the machine is not busy
});
test('a question that failed is asked again if the user wants it, though the quick results are there', async () => {
  const state = new State(), asked: string[] = [];
  let refuses = true;
  const engine = {ask: (revision: number, _: Change, wants: readonly Want[]) => {
    asked.push(wants.map(w => w.command + (w.keys ? ' draft' : '')).join());
    if (!wants[0]!.keys && refuses) return Promise.reject(new Error('refused'));
    return Promise.resolve({revision, ok: true, problems: [], results: wants.map(w => ({command: w.command, ok: true, problems: [], json: curves([])}))});
  }};
  const asker = new Asker(engine as unknown as Engine, state, () => WISHES.slice(0, 2));
  state.open('mass = 1', '1');
  await after(130);
  assert.match(asker.trouble, /refused/);
  assert.deepEqual(asked, ['curves draft', 'curves']);
  refuses = false;
  asker.again();
  await after(5);
  assert.deepEqual(asked, ['curves draft', 'curves', 'curves']);
  assert.ok(!asker.trouble && !asker.isOld('curves'));
});
test('what is asked after the exact results does not keep them waiting', async () => {
  const state = new State(), engine = new SlowEngine(), wishes: Wish[] = [{want: {command: 'modes'}, after: true}, {want: {command: 'curves'}, exact: true}];
  const asker = new Asker(engine as unknown as Engine, state, () => wishes);
  state.open('mass = 1', '1');
  await after(130);
  assert.deepEqual(engine.asked.map(wanted), ['curves']);
  engine.asked[0]!.answer();
  await after(5);
  assert.ok(!asker.isOld('curves'));
  assert.deepEqual(engine.asked.map(wanted), ['curves', 'modes']);
});
test('after a failure the newest state is asked for, and the failed one is not asked again', async () => {
  const state = new State(), asked: number[] = [];
  const refusing = {ask: (revision: number) => (asked.push(revision), after(5).then(() => { throw new Error('refused'); }))};
  const asker = new Asker(refusing as unknown as Engine, state, () => WISHES);
  state.open('mass = 1', '1');
  state.open('mass = 2', '2');
  await after(130);
  assert.equal(asker.trouble, 'Error: refused');
  assert.deepEqual(asked, [asked[0], state.revision]);
});
test('a question about a slider at rest gives way to one about the next move', async () => {
  const {state, engine, asker} = played();
  engine.asked[0]!.answer();
  await after(130);
  assert.equal(wanted(engine.asked[1]), 'curves');
  state.set({mass: '2'}, true);
  assert.ok(engine.asked[1]!.signal.aborted);
  await after(5);
  assert.equal(wanted(engine.asked[2]), 'curves draft');
  assert.equal(engine.asked[2]!.revision, state.revision);
  assert.equal(asker.trouble, '');
});
test('a draft is drawn with the limits of the finished curves, until these are finished, too', async () => {
  const {state, engine, asker} = played(), drawn = new DrawnCurves();
  engine.asked[0]!.answer();
  await after(130);
  assert.equal(drawn.of(asker), null);
  engine.asked[1]!.answer();
  await after(5);
  const first = drawn.of(asker);
  assert.deepEqual(first, asker.result('curves'));
  state.set({mass: '2'}, true);
  assert.equal(drawn.of(asker), first);
  engine.asked.at(-1)!.answer();
  await after(5);
  const draft = drawn.of(asker);
  assert.notEqual(draft, first);
  assert.deepEqual([draft?.limits, draft?.vanishing], [first?.limits, ['y']]);
  assert.equal(drawn.of(asker), draft);
  await after(130);
  engine.asked.at(-1)!.answer();
  await after(5);
  assert.deepEqual(drawn.of(asker)?.limits, [{result: 'z', limit: state.revision}]);
});
test('a result that is the same is not sent again and stays the same object', async () => {
  const asked: Want[] = [], scene = {size: 1};
  const engine = {ask: async (revision: number, _: Change, wants: readonly Want[]): Promise<Answer> => {
    asked.push(...wants);
    const same = wants[0]!.known === 'a';
    return {revision, ok: true, problems: [], results: [{command: 'scene', ok: true, problems: [], hash: 'a', same, json: same ? null : scene}]};
  }};
  const state = new State(), asker = new Asker(engine as unknown as Engine, state, () => [{want: {command: 'scene'}}]);
  state.open('mass = 1', '1');
  await after(5);
  state.set({mass: '2'}, true);
  await after(5);
  assert.deepEqual(asked.map(w => w.known), [undefined, 'a']);
  assert.equal(asker.result('scene'), scene);
  assert.ok(!asker.isOld('scene'));
  state.chooseCase('cold');
  await after(5);
  assert.equal(asker.result('scene'), scene);
});
test('curves in another quantity are asked for although the numbers are the same', async () => {
  const asked: Want[] = [], wish: Wish = {want: {command: 'curves', keys: {}}, exact: true};
  const engine = {ask: async (revision: number, _: Change, wants: readonly Want[]): Promise<Answer> => {
    asked.push(...wants);
    return {revision, ok: true, problems: [], results: [{command: 'curves', ok: true, problems: [], json: curves([])}]};
  }};
  const state = new State(), asker = new Asker(engine as unknown as Engine, state, () => [wish]);
  state.open('mass = 1', '1');
  await after(130);
  asker.again();
  await after(130);
  assert.equal(asked.length, 1);
  wish.want = {command: 'curves', keys: {quantity: 'velocity'}};
  asker.again();
  await after(130);
  assert.deepEqual(asked.at(-1), {command: 'curves', keys: {quantity: 'velocity'}});
});
test('a further wish asks for nothing that is there, and a program that was started again is asked for everything', async () => {
  const {engine, asker} = played(), wants = () => engine.asked.map(wanted);
  const answered = async () => {
    for (const pace of [5, 130, 230]) {
      await after(pace);
      engine.asked.at(-1)!.answer();
    }
    await after(5);
  };
  await answered();
  assert.deepEqual(wants(), ['curves draft', 'curves', 'check']);
  asker.again();
  await after(230);
  assert.equal(engine.asked.length, 3);
  asker.afresh();
  await answered();
  assert.deepEqual(wants().slice(3), ['curves draft', 'curves', 'check']);
});
test('while the file has errors, the results of its last state without errors stay and are known to be that', async () => {
  let wrong = false;
  const engine = {ask: async (revision: number, _: Change, wants: readonly Want[]): Promise<Answer> => ({revision, ok: !wrong, problems: wrong ? [{severity: 'error', message: 'impossible'}] : [],
    results: wants.map(({command}) => ({command, ok: !wrong, problems: [], json: wrong ? null : `${command} of ${revision}`}))})};
  const state = new State(), asker = new Asker(engine, state, () => WISHES);
  const answered = async () => { while (asker.isOld('curves') || asker.isOld('check')) await after(5); };
  state.open('mass = 1', '1');
  await answered();
  const [good, before] = [state.revision, asker.result('curves')];
  assert.deepEqual([before, asker.isOutdated('curves')], [`curves of ${good}`, false]);
  wrong = true;
  for (const change of [() => state.set({mass: '-1'}), () => state.edit('mass = -1'), () => state.chooseCase('hot')]) {
    change();
    await answered();
    for (const command of ['curves', 'check']) assert.deepEqual([asker.result(command), asker.isOutdated(command), asker.isOld(command)], [`${command} of ${good}`, true, false]);
  }
  wrong = false;
  state.edit('mass = 2');
  await answered();
  assert.deepEqual([asker.result('curves'), asker.isOutdated('curves')], [`curves of ${state.revision}`, false]);
  wrong = true;
  state.open('another file', '2');
  await answered();
  assert.deepEqual([asker.result('curves'), asker.missing('curves')], [null, 'The file has errors; see the messages above.']);
});
