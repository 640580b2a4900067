// SPDX-License-Identifier: BSD-3-Clause
import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import {test} from 'node:test';
import {Display} from '../src/display.ts';
import {wishes} from '../src/wishes.ts';

Object.assign(globalThis, {matchMedia: () => ({matches: false})});

test('a still that Python makes without a page has the results of the page at rest', () => {
  const python = readFileSync('../bindings/python/trivet/_widget.py', 'utf8');
  const kept = JSON.parse(/^_first_results = \((.*)\)$/m.exec(python)![1]!.replace(/^/, '[').replace(/$/, ']')) as string[];
  for (const bodies of [1, 10]) {
    const finished = wishes(new Display(), {hasSomethingToJudge: true, hasSteady: false, bodies}).filter(w => w.as === undefined);
    assert.deepEqual(finished.map(w => w.want), kept.map(command => (command === 'curves' ? {command, keys: {}} : {command})));
  }
});
