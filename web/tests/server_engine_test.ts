// SPDX-License-Identifier: BSD-3-Clause
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {ServerEngine, type Change} from '../src/engine.ts';

const CHANGE: Change = {text: 'mass = 1', version: '1', settings: [], case: ''};

/// A program that answers with these in turn.
function answering(...answers: [number, unknown][]) {
  const asked: string[] = [];
  globalThis.fetch = async (path, init) => {
    asked.push(`${String(path)} ${String(init?.body)}`);
    const [status, json] = answers.shift()!;
    return new Response(JSON.stringify(json), {status});
  };
  return asked;
}

test('a question that an older one replaced in the program is asked again', async () => {
  const asked = answering([409, {error: 'a newer question of this page replaced this one'}], [200, {revision: 7}]);
  assert.equal((await new ServerEngine('token').ask(7, CHANGE, [], new AbortController().signal)).revision, 7);
  assert.equal(asked.length, 2);
  assert.equal(asked[0], asked[1]);
});
test('one that is no longer wanted is not', async () => {
  const end = new AbortController(), asked = answering([409, {error: 'replaced'}]);
  end.abort();
  await assert.rejects(new ServerEngine('token').ask(7, CHANGE, [], end.signal), /replaced/);
  assert.equal(asked.length, 1);
});
test('the text is sent if the program has another version, and again if it was replaced', async () => {
  const asked = answering([412, {}], [409, {error: 'replaced'}], [200, {revision: 1}]);
  await new ServerEngine('token').ask(1, CHANGE, []);
  assert.deepEqual(asked.map(one => one.includes('"text"')), [false, true, true]);
});
test('a program that always says so is not asked for ever', async () => {
  const asked = answering(...Array.from({length: 9}, (): [number, unknown] => [409, {error: 'replaced'}]));
  await assert.rejects(new ServerEngine('token').ask(7, CHANGE, []), /replaced/);
  assert.equal(asked.length, 4);
});
