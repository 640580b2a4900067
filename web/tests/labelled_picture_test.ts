// SPDX-License-Identifier: BSD-3-Clause
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {broken} from '../src/machine/labelled_picture.ts';

test('a line of text is broken between words, and a long word stays whole', () => {
  assert.deepEqual(broken('ab cd efghijk l', 5, words => words.length), ['ab cd', 'efghijk', 'l']);
});
