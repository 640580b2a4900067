// SPDX-License-Identifier: BSD-3-Clause
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {judgement} from '../src/judgement.ts';
import type {App} from '../src/part.ts';

const requirement = (margin: number) => ({judged: true, met: margin >= 1, margin});
function said(least_margin: unknown, shown = '') {
  const verdict = {met: true, least_margin, cases: [
    {case: '', decides: true, met: true, governing: 0, requirements: [requirement(1.5), requirement(3)]},
    {case: 'hot', decides: true, met: true, governing: 1, requirements: [requirement(9), requirement(1.25)]},
    {case: 'trial', decides: false, met: true, governing: 0, requirements: [requirement(1.1)]}]};
  return judgement({asker: {problems: [], result: () => verdict, isOld: () => false}, state: {case: shown}} as unknown as App);
}
test('the least margin is the one that the program states', () => {
  assert.equal(said({case: '', requirement: 0, margin: 1.5}).words, 'all 2 requirements met, least margin 1.5');
  assert.equal(said({case: 'hot', requirement: 1, margin: 1.25}).words, 'all 2 requirements met, least margin 1.25 in case hot');
  assert.equal(said({case: 'hot', requirement: 1, margin: 1.25}, 'trial').words, 'the requirement is met, least margin 1.25 in case hot');
  assert.equal(said({case: '', requirement: 0, margin: 1.5}, 'hot').words, 'all 2 requirements met, least margin 1.5 in the base model');
  assert.equal(said(null).words, 'all 2 requirements met');
  assert.equal(said(null).state, 'met');
});
test('what is not judged is no violation', () => {
  const verdict = {met: false, least_margin: null, cases: [
    {case: '', decides: true, met: false, governing: 0, requirements: [requirement(1.5), {judged: false, met: false, margin: null}]}]};
  const found = judgement({asker: {problems: [], result: () => verdict, isOld: () => false}, state: {case: ''}} as unknown as App);
  assert.deepEqual([found.state, found.words], ['unjudged', '1 of 2 requirements not judged']);
});
