// SPDX-License-Identifier: BSD-3-Clause
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {limitsOf, unitOfFirstLimit} from '../src/chart/limits.ts';
import {amplitudeAt, shownAmplitude, shownLimits} from '../src/chart/picture.ts';
import type {Display} from '../src/display.ts';
import {levelsOf, scaleLevels} from '../src/limit_line.ts';
import {limitNumber, PresentLimits, rounded, setLimit} from '../src/limit_number.ts';
import {indexOf} from '../src/numbers_of_text.ts';
import {shareAtLevel} from '../src/quantities.ts';
import type {Curves, Requirement, Verdict} from '../src/results.ts';
import {State} from '../src/state.ts';

const TEXT = `trivet = 1
[limits]
"m.z" = "2 mm p-p"
[requirements.limits]
"m.x" = [
  {limit = "2.8 mm/s rms", band = ["20 Hz", "25 Hz"]},  # in operation
  {limit = "0.3 mm"},
]
[operation]
limits = {"m.y" = 0.001}
[cases.cold]
requirements.limits = {"m.x" = "3 mm"}
`;
const opened = () => {
  const state = new State();
  state.open(TEXT, '1');
  return state;
};
const at = (state: State, place: string[], caseName = '') => limitNumber(place, caseName, state.design, indexOf(state.design.text))!;
const limited = (more: Partial<Requirement>): Requirement => ({kind: 'amplitude', subject: 'm.z', requirement: 'm.z ≤ 1 mm', unit: 'm', allowed: 1e-3, value: 2e-3, margin: 0.5, judged: true, met: false,
  reason: '', detail: '', angular_frequency: 10, band: [5, 20], speed: null, excitations: [], order: null, place: ['limits', 'm.z'], ...more});

test('a limit is a setting in the unit and level of the file, and a drag one step of undo', () => {
  const state = opened(), values = new PresentLimits();
  assert.equal(values.allowed(limited({}), at(state, ['limits', 'm.z']), true), 1e-3);
  for (const value of [1.5, 1.2]) setLimit(state, at(state, ['limits', 'm.z']), value, true);
  state.dropped();
  assert.deepEqual(state.change.settings, ['limits."m.z" = "1.2 mm p-p"']);
  assert.equal(values.allowed(limited({}), at(state, ['limits', 'm.z']), false), 0.6e-3);  // before it is judged again
  state.undo();
  assert.equal(state.design.settings.size, 0);
});
test('a limit in a list or of a case is replaced in the text, once, when it is dropped', () => {
  const state = opened(), place = ['requirements', 'limits', 'm.x', '0', 'limit'];
  setLimit(state, at(state, place), 3.5, true);
  assert.equal(state.design.text, TEXT);
  setLimit(state, at(state, place), 3.5);
  assert.equal(state.design.text, TEXT.replace('2.8 mm/s rms', '3.5 mm/s rms'));
  setLimit(state, at(state, ['requirements', 'limits', 'm.x'], 'cold'), 4);
  assert.equal(state.design.text, TEXT.replace('2.8 mm/s rms', '3.5 mm/s rms').replace('"3 mm"', '"4 mm"'));
});
test('a limit in a list is moved like a slider: its results stay until they are judged again, also at undo and redo', () => {
  const state = opened(), {generation} = state, place = ['requirements', 'limits', 'm.x', '0', 'limit'];
  for (const step of [() => setLimit(state, at(state, place), 3.5), () => state.undo(), () => state.redo()]) {
    const {revision} = state;
    step();
    assert.deepEqual([state.generation, state.revision], [generation, revision + 1]);
  }
  assert.equal(state.design.text, TEXT.replace('2.8 mm/s rms', '3.5 mm/s rms'));
  state.edit('trivet = 1');
  assert.equal(state.generation, generation + 1);
});
test('a bare number stays one, and a limit in a new unit has no SI value before it is judged', () => {
  const state = opened(), values = new PresentLimits(), place = ['operation', 'limits', 'm.y'];
  const before = at(state, place);
  values.allowed(limited({place}), before, true);
  setLimit(state, before, 0.002);
  assert.deepEqual(state.change.settings, ['operation.limits."m.y" = 0.002']);
  assert.equal(values.allowed(limited({place}), {...before, unit: 'in'}, false), null);
  assert.equal(rounded(4.5454), 4.55);
});
test('a limit is drawn beside a curve of its quantity under its excitations alone', () => {
  const curves = {results: [{name: 'm.z', unit: 'm'}], models: [{excitations: ['push', 'pull']}]} as unknown as Curves;
  const why = (more: Partial<Requirement>) => limitsOf(curves, 0, [limited(more)]).not.map(n => n.why);
  assert.deepEqual(limitsOf(curves, 0, [limited({})]).drawn.map(l => [l.result, l.from, l.to, l.isOfCurve]), [['m.z', 5, 20, true]]);
  assert.equal(limitsOf(curves, 0, [limited({band: [5, null]})]).drawn[0]!.to, Infinity);
  assert.deepEqual(why({unit: 'm/s'}), ['it limits the velocity, the curve is the displacement']);
  assert.deepEqual(why({excitations: ['push']}), ['it holds under push alone']);
  assert.deepEqual(why({excitations: ['pull', 'push']}), []);
  assert.deepEqual(why({order: 2}), ['it holds for order 2 of the shaft alone']);
  assert.deepEqual(why({subject: 'm.x'}), ['no curve of m.x is drawn']);
  assert.deepEqual(limitsOf(curves, 0, [limited({kind: 'mount_load'}), limited({place: []})]), {drawn: [], not: []});
  const lined = {...curves, lines: [{name: 'severity', result: 'm.z', unit: 'm/s'}]} as unknown as Curves;
  assert.deepEqual(limitsOf(lined, 0, []).not, [{words: 'm.z within "severity"', why: 'it limits the velocity, the curve is the displacement'}]);
  const [speed] = limitsOf(curves, 0, [limited({kind: 'operation', speed: [60, 60], band: null})]).drawn;
  assert.deepEqual([speed!.from, speed!.to, speed!.isOfCurve], [60, 60, false]);
});
test('a limit of steady motions is a line that no curve judges, and of other numbers there are words with the margin', () => {
  const curves = {results: [{name: 'm.z', unit: 'm'}], models: [{excitations: ['push']}]} as unknown as Curves, one = {shown_requirement: 'm.z ≤ 2 mm', judged: true, margin: 1.25};
  const {drawn, not} = limitsOf(curves, 0, [limited({kind: 'steady', excitations: []}), limited({...one, kind: 'rms'}), limited({...one, kind: 'static', judged: false}), limited({...one, kind: 'band_line', place: []}), limited({...one, kind: 'rms', subject: 'm.x'})]);
  assert.deepEqual(drawn.map(l => [l.result, l.from, l.to, l.isOfCurve]), [['m.z', 5, 20, false]]);
  assert.deepEqual(not, [{words: 'm.z ≤ 2 mm (margin 1.25)', why: 'it limits the root mean square under the random excitations'},
                         {words: 'm.z ≤ 2 mm (not judged)', why: 'it limits the value at rest'},
                         {words: 'm.z ≤ 2 mm (margin 1.25)', why: 'it limits the levels in bands of frequencies, of which no curve is drawn'}]);  // m.x has no curve
});
test('the first limit that decides names the quantity to begin with', () => {
  const of = (kind: string, unit: string, subject = 'm.z') => ({kind, unit, subject}), curves = {lines: [{result: 'm.y', unit: 'm/s'}]} as unknown as Curves;
  const unit = (...cases: [boolean, ReturnType<typeof of>[]][]) => unitOfFirstLimit({cases: cases.map(([decides, requirements]) => ({decides, requirements}))} as unknown as Verdict, curves);
  assert.equal(unit([false, [of('amplitude', 'm')]], [true, [of('mount_load', 'N'), of('amplitude', 'm/s'), of('amplitude', 'm')]]), 'm/s');
  assert.equal(unit([true, [of('limit_line', '1', 'm.y')]]), 'm/s');  // a ratio to its line, which has the unit
  assert.equal(unit([false, [of('amplitude', 'm')]]), null);
});
test('a height of the chart is the amplitude that is drawn there', () => {
  for (const decibel of [false, true]) {
    const display = {decibel, logarithmicAmplitude: true} as Display, scale = {factor: decibel ? 1 : 1e3, unit: 'mm'};
    assert.ok(Math.abs(amplitudeAt(shownAmplitude(2e-3, scale, display)!, scale, display) - 2e-3) < 1e-15);
  }
});
test('the share of each level is that of a sine', () => {
  const turn = Array.from({length: 360}, (_, i) => Math.sin(i * Math.PI / 180)), most = Math.max(...turn);
  const rms = Math.sqrt(turn.reduce((sum, y) => sum + y * y, 0) / turn.length);
  for (const [level, share] of [['rms', rms], ['0-p', most], ['p-p', most - Math.min(...turn)], [null, 1]] as const)
    assert.ok(Math.abs(shareAtLevel(level) - share) < 1e-12, `${level}`);
});
test('a limit at a speed is drawn only at the level of the axis: a peak of several orders is no multiple of their rms value', () => {
  const curves = {results: [{name: 'm.z', unit: 'm/s', level: 'rms', level_factor: Math.SQRT1_2}], models: [{excitations: []}]} as unknown as Curves;
  const speed = (level: string) => limited({kind: 'operation', unit: 'm/s', level, speed: [60, 60], band: null, allowed: 7.1e-3, value: 4.333e-3, margin: 1.638, met: true,
    shown_requirement: `m.z ≤ 7.1 mm/s ${level} at 592 rpm`, shown_value: `4.333 mm/s ${level}`});
  const {drawn, not} = limitsOf(curves, 0, ['rms', '0-p', 'p-p'].map(speed)), scale = {factor: 1e3 * Math.SQRT1_2, unit: 'mm/s rms'}, display = {logarithmicAmplitude: true, frequencyUnit: 'Hz', theme: 'light'} as Display;
  assert.deepEqual(not, ['0-p', 'p-p'].map(level => ({words: `m.z ≤ 7.1 mm/s ${level} at 592 rpm (4.333 mm/s ${level}, margin 1.64)`, why: `it is judged ${level}, of all orders together, and the axis is rms`})));
  const [limit] = drawn, shown = shownLimits([{limit: limit!, allowed: limit!.requirement.allowed!, written: '7.1 mm/s rms', movable: true, old: false, binding: true}], ['m.z'], new Set(), scale, display);
  assert.deepEqual(shown.map(l => [Number(l.y.toPrecision(9)), Number(l.at!.y.toPrecision(9)), l.label]), [[7.1, 4.333, '≤ 7.1 mm/s rms · margin 1.64']]);
});
test('a limit that is not drawn has its words at its level', () => {
  const curves = {results: [], models: [{excitations: []}]} as unknown as Curves;
  assert.deepEqual(limitsOf(curves, 0, [limited({subject: 'FL.force.z', requirement: 'FL.force.z ≤ 2 kN', shown_requirement: 'FL.force.z ≤ 2 kN rms'})]).not.map(n => n.words), ['FL.force.z ≤ 2 kN rms']);
});
test('a short label has the number of the file, and its unit and level where the axis has others', () => {
  const display = {logarithmicAmplitude: true, frequencyUnit: 'Hz', theme: 'light'} as Display, scale = {factor: 1e6, unit: 'µm 0-p'};
  const short = (written: string) => shownLimits([{limit: {requirement: limited({level: '0-p', margin: 2}), result: 'm.z', from: 0, to: Infinity, isOfCurve: true}, allowed: 5.5e-5, written, movable: true, old: false, binding: true}],
    ['m.z'], new Set(), scale, display)[0]!.short;
  assert.deepEqual(['55 µm', '55 µm 0-p', '110 µm p-p', '0.055 mm', '5.5e-5'].map(short), ['≤ 55 · margin 2', '≤ 55 · margin 2', '≤ 110 µm p-p · margin 2', '≤ 0.055 mm 0-p · margin 2', '≤ 55 · margin 2']);
});
test('a limit has the dash of its curve: seven curves have six colours', () => {
  const display = {logarithmicAmplitude: true, frequencyUnit: 'Hz', theme: 'light'} as Display, names = ['a', 'b', 'c', 'd', 'e', 'f', 'm.z'];
  const of = (result: string) => shownLimits([{limit: {requirement: limited({}), result, from: 0, to: Infinity, isOfCurve: true}, allowed: 1e-3, written: '1 mm', movable: true, old: false, binding: true}], names, new Set(), {factor: 1, unit: 'm'}, display)[0]!;
  assert.equal(of('a').colour, of('m.z').colour);
  assert.deepEqual([of('a').dash, of('m.z').dash], [[], [7, 4]]);
});
test('all levels of a line are scaled in the text, in one step; a published line has none', () => {
  const text = '[limit_lines.a]\nrows = [[10, "4.5 mm/s"], [60, 0.002]]  # mine\n[limit_lines.b]\nline = "VC-C"\n[cases.cold]\nlimit_lines.a.rows = [[1, 1], [2, 3]]\n';
  const state = new State();
  state.open(text, '1');
  const levels = (name: string, caseName = '') => levelsOf(name, caseName, state.index);
  assert.equal(levels('b'), null);
  assert.deepEqual(levels('a', 'cold')!.map(l => l.value), [1, 3]);
  scaleLevels(state, levels('a')!, 1.1);
  assert.equal(state.design.text, text.replace('4.5', '4.95').replace('0.002', '0.0022'));
  state.undo();
  assert.equal(state.design.text, text);
  assert.equal(state.canUndo, false);
});
