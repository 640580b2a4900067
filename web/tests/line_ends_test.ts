// SPDX-License-Identifier: BSD-3-Clause
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {EditorState} from '@codemirror/state';
import {edited, withPlainEnds, type Edit} from '../src/line_ends.ts';

const FILES = ['a = 1\r\nb = 2\r\n\r\n# ä\r\n', 'a = 1\nb = 2\r\nc = 3\rd = 4\n', 'a = 1\r\n', '\r\n', 'a', '', '\uFEFFa = 1\r\nb = 2'];

test('the editor has the text with plain line ends', () => {
  for (const text of FILES) assert.equal(EditorState.create({doc: text}).doc.toString(), withPlainEnds(text));
});
test('no edit changes nothing', () => {
  for (const text of FILES) assert.equal(edited(text, []), text);
});
test('every line that is not edited keeps its end', () => {
  const text = 'a = 1\nb = 2\r\nc = 3\rd = 4\n';
  assert.equal(edited(text, [{from: 12, to: 17, insert: 'c = 30'}]), 'a = 1\nb = 2\r\nc = 30\rd = 4\n');
  assert.equal(edited(text, [{from: 6, to: 12, insert: ''}]), 'a = 1\nc = 3\rd = 4\n');
  assert.equal(edited(text, [{from: 0, to: 1, insert: 'A'}, {from: 22, to: 23, insert: '5'}]), 'A = 1\nb = 2\r\nc = 3\rd = 5\n');
});
test('a new line ends as that in which it begins', () => {
  const text = 'a = 1\nb = 2\r\nc = 3';
  assert.equal(edited(text, [{from: 8, to: 8, insert: '\n'}]), 'a = 1\nb \r\n= 2\r\nc = 3');
  assert.equal(edited(text, [{from: 17, to: 17, insert: '\nd = 4\n'}]), 'a = 1\nb = 2\r\nc = 3\r\nd = 4\r\n');
  assert.equal(edited('', [{from: 0, to: 0, insert: 'a\nb'}]), 'a\nb');
});
test('the file has what the editor shows after any edits', () => {
  let seed = 1;
  const below = (n: number) => (seed = seed * 48271 % 2147483647) % n;
  const inserts = ['', 'x', '\n', 'y\nz\n', '\n\n'];
  for (let round = 0; round < 2000; round++) {
    const text = FILES[below(FILES.length)]!, shown = EditorState.create({doc: text}), edits: Edit[] = [];
    for (let at = below(4); at <= shown.doc.length && edits.length < 3;) {
      const to = Math.min(at + below(5), shown.doc.length);
      edits.push({from: at, to, insert: inserts[below(inserts.length)]!});
      at = to + 1 + below(5);
    }
    const after = shown.update({changes: edits}).state.doc.toString();
    assert.equal(withPlainEnds(edited(text, edits)), after, JSON.stringify([text, edits]));
  }
});
