// SPDX-License-Identifier: BSD-3-Clause
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {differentLines} from '../src/line_difference.ts';

const shown = (first: string, second: string) => differentLines(first, second).map(l => `${l.side === 'first' ? '-' : '+'}${l.number}${l.text}`);

test('lines of only one text are listed, changed places together', () => {
  assert.deepEqual(shown('a\nb\nc', 'a\nb\nc'), []);
  assert.deepEqual(shown('a\nb\nc', 'a\nB\nc'), ['-2b', '+2B']);
  assert.deepEqual(shown('a\nb\nc\nd\ne', 'b\nc\nx\nd'), ['-1a', '+3x', '-5e']);
  assert.deepEqual(shown('a', 'a\n'), ['+2']);
});
test('the lines that are not listed are the same in both texts', () => {
  let seed = 1;
  const random = () => (seed = seed * 48271 % 2147483647) / 2147483647;
  for (let round = 0; round < 200; round++) {
    const text = () => Array.from({length: 1 + Math.floor(random() * 12)}, () => 'abc'[Math.floor(random() * 3)]!).join('\n');
    const first = text(), second = text(), different = differentLines(first, second);
    const rest = (side: string, lines: string) => lines.split('\n').filter((_, i) => !different.some(l => l.side === side && l.number === i + 1));
    assert.deepEqual(rest('first', first), rest('second', second));
  }
});
test('texts too large to compare differ as a whole between what they begin and end with', () => {
  const lines = (word: string) => ['same', ...Array.from({length: 3000}, (_, i) => `${word} ${i}`), 'same'].join('\n');
  assert.equal(differentLines(lines('a'), lines('b')).length, 6000);
});
