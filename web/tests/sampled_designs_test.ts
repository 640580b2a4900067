// SPDX-License-Identifier: BSD-3-Clause
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {Asker} from '../src/asker.ts';
import {bandAt, bandOverlays} from '../src/chart/overlays.ts';
import type {Answer, Change, Engine, Want} from '../src/engine.ts';
import type {App} from '../src/part.ts';
import type {Sample} from '../src/results.ts';
import {sampledDesigns, sampleWishes} from '../src/sampled_designs.ts';
import {State} from '../src/state.ts';

const after = (ms: number) => new Promise(done => setTimeout(done, ms));
const TEXT = (designs: string) => `[tolerances.rubber]\npath = "elements.mount.scale"\nhalf_width = "15 %"\n[requirements]\nlimits = {"m.z" = "1 mm"}\n${designs}`;

/// A page whose questions about samples are answered when the test wants.
function played(text: string, patience?: number, assembled = '', idle = 0) {
  const state = new State(), asked: {settings: readonly string[]; signal: AbortSignal | undefined; answer: () => void}[] = [];
  const engine: Pick<Engine, 'ask'> = {ask: (revision: number, {settings}: Change, wants: readonly Want[], signal?: AbortSignal) => new Promise<Answer>((done, failed) => {
    signal?.addEventListener('abort', () => failed(new Error('aborted')));
    const designs = Number(settings.findLast(s => s.startsWith('analyses.sample.designs'))!.split(' = ')[1]);
    asked.push({settings, signal, answer: () => done({revision, ok: true, problems: [], results: wants.map(({command}) => ({command, ok: true, problems: [],
      json: {designs, confidence: 0.95, yield: {shown_share: '90 %', shown_interval: '80 % … 100 %'}, failed: 0, cases: [{case: '', no_kernels: assembled}]} satisfies Sample}))})});
  })};
  const sampler = new Asker(engine, state, () => sampleWishes(app), patience, idle);
  const app = {state, sampler, get index() { return state.index; }} as unknown as App;
  state.open(text, '1');
  return {state, app, asked};
}
const designsOf = ({settings}: {settings: readonly string[]}) => settings.find(s => s.startsWith('analyses.sample.designs'))!.split(' = ')[1];

test('few designs follow a slider, and those of the file are judged when it rests', async () => {
  const {state, app, asked} = played(TEXT('[analyses.sample]\ndesigns = 20_000\nworst_case = true'));
  assert.equal(sampledDesigns(app), null);
  assert.deepEqual(asked.map(designsOf), ['1024']);
  assert.ok(asked[0]!.settings.includes('analyses.sample.worst_case = false'));
  asked[0]!.answer();
  await after(5);
  assert.deepEqual([sampledDesigns(app)?.found.designs, sampledDesigns(app)?.old], [1024, true]);
  await after(230);
  assert.deepEqual(asked.map(designsOf), ['1024', '20000']);
  asked[1]!.answer();
  await after(5);
  assert.deepEqual([sampledDesigns(app)?.found.designs, sampledDesigns(app)?.old], [20000, false]);
  state.set({'bodies.m.mass': '2'}, true);
  assert.equal(sampledDesigns(app)?.old, true);
  assert.deepEqual(asked.slice(2).map(designsOf), ['1024']);
  asked[2]!.answer();
  await after(5);
  assert.equal(sampledDesigns(app)?.found.designs, 1024);  // of the newer state
  state.chooseCase('cold');
  assert.equal(sampledDesigns(app), null);
});
test('a file without tolerances or without requirements has no sample, and a long one is cut', async () => {
  assert.equal(played(TEXT('').replace('tolerances', 'parameters')).asked.length, 0);
  assert.equal(played(TEXT('').replace(/\[requirements\][^]*/, '')).asked.length, 0);
  const wanted = (designs: string) => sampleWishes(played(TEXT(designs)).app).map(w => w.settings![0]);
  assert.deepEqual(wanted('[analyses]\nsample = {designs = 1_000_000_000}'), ['analyses.sample.designs = 1024', 'analyses.sample.designs = 100000']);
  assert.deepEqual(wanted('[analyses]\nsample.designs = 500'), ['analyses.sample.designs = 500']);
});
test('of models that are assembled one by one only few are judged, also at rest', async () => {
  const {app, asked} = played(TEXT(''), undefined, 'a requirement without a kernel');
  asked[0]!.answer();
  await after(230);
  assert.deepEqual([asked.length, sampledDesigns(app)?.old], [1, false]);
});
test('a sample that takes long gives way to the newest state, a short one is finished', async () => {
  const {state, asked} = played(TEXT(''), 60);
  state.set({'bodies.m.mass': '2'}, true);
  assert.ok(!asked[0]!.signal!.aborted);
  await after(90);
  assert.ok(asked[0]!.signal!.aborted);
  assert.equal(asked.length, 2);
  assert.ok(asked[1]!.settings.includes('bodies.m.mass = 2'));
  await after(90);
  assert.ok(!asked[1]!.signal!.aborted);  // it is of the newest state
});
test('samples of a moving slider leave most of the time to others', async () => {
  const {state, asked} = played(TEXT(''), undefined, '', 3);
  await after(40);
  asked[0]!.answer();
  await after(5);
  state.set({'bodies.m.mass': '2'}, true);
  await after(60);
  assert.equal(asked.length, 1);  // three times 40 ms have not passed
  await after(90);
  assert.equal(asked.length, 2);
  assert.ok(asked[1]!.settings.includes('bodies.m.mass = 2'));
});
test('a band is drawn with the curve of its result and unit, and read at the cursor', () => {
  const band = {result: 'm.z', unit: 'm', angular_frequency: [1, 2], low: [1, 2], median: [2, 3], high: [3, null]};
  const [drawn, ...more] = bandOverlays([band, {...band, unit: 'm/s'}, {...band, result: 'm.y'}], 'm', ['m.x', 'm.z'], 10, v => 2 * v);
  assert.deepEqual([drawn!.stroke, drawn!.kind, drawn!.points, drawn!.upper, more], [1, 'band', [[10, 2], [20, 4]], [[10, 6], [20, null]], []]);
  assert.deepEqual([bandAt(drawn!, 10), bandAt(drawn!, 15), bandAt(drawn!, 30)], [[2, 6], null, null]);
});
