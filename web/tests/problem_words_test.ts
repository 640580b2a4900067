// SPDX-License-Identifier: BSD-3-Clause
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {indexOf} from '../src/numbers_of_text.ts';
import {errorAbout, lineOf, settingOf, worded} from '../src/problem_words.ts';
import type {Problem} from '../src/results.ts';

const TEXT = 'trivet = 1\r\n\r\n[bodies."pump = set"]\r\nmass = "4200 kg"\r\ncenter_of_mass = [0, 0,\r\n  0.5]\r\n', INDEX = indexOf(TEXT);
const problem = (setting: string, path: string): Problem => ({severity: 'error', file: `--set ${setting}`, line: 1, subject: path,
  message: `--set ${setting}: error: ${path}: -1; a mass must be > 0`});

test('a message on a setting has the line of its number in the text', () => {
  const path = 'bodies."pump = set".mass', wrong = problem(`${path} = "-1 kg"`, path);
  assert.equal(settingOf(wrong), path);
  assert.equal(lineOf(wrong, TEXT, INDEX), 4);
  assert.equal(worded(wrong, 4), `line 4: ${path}: -1; a mass must be > 0`);
  assert.equal(lineOf(problem('bodies."pump = set".center_of_mass.z = 1', ''), TEXT, INDEX), 6);
  assert.equal(lineOf(problem('element_types.mount.scale = -1', ''), TEXT, INDEX), 0);
});
test('a message on the file is left as it is', () => {
  const wrong: Problem = {severity: 'error', file: 'a.toml', line: 7, message: 'a.toml:7: error: mass'};
  assert.deepEqual([settingOf(wrong), lineOf(wrong, TEXT, INDEX), worded(wrong)], [null, 7, 'line 7: a.toml:7: error: mass']);
});
test('an error belongs to the field of its number, a warning to none', () => {
  const wrong = problem('a.mass = -1', 'a.mass');
  assert.equal(errorAbout(['b.mass', 'a.mass'], [{...wrong, severity: 'warning'}, wrong]), 1);
  assert.equal(errorAbout(['b.mass'], [wrong]), -1);
});
