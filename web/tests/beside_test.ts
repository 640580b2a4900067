// SPDX-License-Identifier: BSD-3-Clause
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {BesideResults, type Question} from '../src/beside.ts';
import type {Answer, Change, Engine} from '../src/engine.ts';
import {partOn, ticksOf} from '../src/map_axis.ts';
import type {MapAxis} from '../src/results.ts';

Object.assign(globalThis, {window: globalThis});  // timers

const change = (...settings: string[]): Change => ({text: 'mass = 1', version: null, settings, case: ''});
const rest = (ms = 400) => new Promise(done => setTimeout(done, ms));
async function until(condition: () => boolean) {
  for (let i = 0; i < 500 && !condition(); i++) await rest(10);
  assert.ok(condition());
}
/// An engine that answers after some time, unless it is stopped.
function besides(ms: number, wanted: () => Question[]) {
  const asked: Change[] = [], stopped: Change[] = [];
  const engine = {ask: (_: number, about: Change, __: unknown, stop: AbortSignal) => new Promise<Answer>((resolve, reject) => {
    asked.push(about);
    const timer = setTimeout(() => resolve({revision: 0, ok: true, problems: [], results: [{command: 'map', ok: true, problems: [], json: about.settings.join()}]}), ms);
    stop.addEventListener('abort', () => { clearTimeout(timer); stopped.push(about); reject(new Error('aborted')); });
  })};
  return {beside: new BesideResults(engine as unknown as Engine, wanted), asked, stopped};
}

test('a result beside is asked for at rest, and again only if what it depends on changes', async () => {
  let now = change('a = 1');
  const {beside, asked} = besides(1, () => [{key: 'map', change: now, want: {command: 'map'}}]);
  for (let i = 0; i < 5; i++) beside.rest();
  assert.equal(asked.length, 0);
  await rest();
  assert.equal(beside.result('map'), 'a = 1');
  beside.rest();
  await rest();
  assert.equal(asked.length, 1);
  now = change('a = 2');
  assert.ok(beside.isOld('map'));
  beside.rest();
  await rest();
  assert.deepEqual([beside.result('map'), beside.isOld('map')], ['a = 2', false]);
});
test('the page does not wait: its own question stops the one beside, which is asked again later', async () => {
  const {beside, asked, stopped} = besides(60, () => [{key: 'map', change: change(), want: {command: 'map'}}]);
  beside.rest();
  await rest(370);
  assert.equal(asked.length, 1);
  beside.yield();
  await rest(10);
  assert.equal(stopped.length, 1);
  assert.equal(beside.failure('map'), '');
  await rest(500);
  assert.deepEqual([asked.length, beside.result('map')], [2, '']);
});
test('what takes long is given up until the user waits for it', async () => {
  const {beside, asked} = besides(80, () => [{key: 'map', change: change('a = 1'), want: {command: 'map'}, patience: 20}]);
  beside.rest();
  await until(() => beside.takesLong('map'));
  assert.equal(beside.result('map'), null);
  beside.rest();
  await rest();
  assert.equal(asked.length, 1);
  beside.waitFor('map');
  await until(() => beside.result('map') !== null);
  assert.deepEqual([beside.result('map'), beside.takesLong('map')], ['a = 1', false]);
});
test('what takes long leaves the earlier result, as an old one, until the user waits', async () => {
  let now = change('a = 1'), patience = 1000;
  const {beside, asked} = besides(80, () => [{key: 'map', change: now, want: {command: 'map'}, patience}]);
  beside.rest();
  await until(() => beside.result('map') !== null);
  [now, patience] = [change('a = 2'), 20];
  beside.rest();
  await until(() => beside.takesLong('map'));
  assert.deepEqual([beside.result('map'), beside.isOld('map'), asked.length], ['a = 1', true, 2]);
  beside.waitFor('map');
  assert.deepEqual([beside.result('map'), beside.takesLong('map')], ['a = 1', false]);
  await until(() => !beside.isOld('map'));
  assert.deepEqual([beside.result('map'), asked.length], ['a = 2', 3]);
});
test('without patience it is asked only when the user wants it, and an old result stays', async () => {
  let now = change('a = 1');
  const {beside, asked} = besides(1, () => [{key: 'map', change: now, want: {command: 'map'}, patience: 0}]);
  assert.ok(beside.takesLong('map'));
  beside.rest();
  await rest();
  assert.equal(asked.length, 0);
  beside.waitFor('map');
  assert.ok(!beside.takesLong('map'));
  await until(() => beside.result('map') !== null);
  assert.ok(!beside.takesLong('map'));
  now = change('a = 2');
  beside.rest();
  await rest();
  assert.deepEqual([asked.length, beside.result('map'), beside.isOld('map'), beside.takesLong('map')], [1, 'a = 1', true, true]);
});
test('axes of maps have round numbers, and places between their ends', () => {
  const axis = (from: number, to: number, spacing: MapAxis['spacing']) => ({from, to, spacing}) as MapAxis;
  assert.deepEqual(ticksOf(axis(0.3, 10, 'logarithmic'), 8), [0.5, 1, 2, 5, 10]);
  assert.deepEqual(ticksOf(axis(1e-3, 1e3, 'logarithmic'), 7), [1e-3, 1e-2, 0.1, 1, 10, 100, 1000]);
  assert.deepEqual(ticksOf(axis(120, 460, 'linear'), 4), [200, 300, 400]);
  assert.deepEqual(ticksOf(axis(-1, 1, 'linear'), 4), [-1, -0.5, 0, 0.5, 1]);
  assert.ok(Math.abs(partOn(axis(0.01, 1, 'logarithmic'), 0.1) - 0.5) < 1e-12);
  assert.equal(partOn(axis(2, 4, 'linear'), 2.5), 0.25);
});
