// SPDX-License-Identifier: BSD-3-Clause
import assert from 'node:assert/strict';
import {createHash} from 'node:crypto';
import {test} from 'node:test';
import {openedToken} from '../src/token.ts';

const h = (text: string) => createHash('sha256').update(text).digest('hex');
const key = '1f'.repeat(32), token = 'a0'.repeat(32), ours = '0'.repeat(64), nonce = '9'.repeat(64), words = `4711 ${ours} ${nonce}`;
const mask = h(key + h(`${key}token ${words}`));
const sealed = [...token].map((c, i) => (parseInt(c, 16) ^ parseInt(mask[i]!, 16)).toString(16)).join('');
const answer = {nonce, sealed, proof: h(key + h(`${key}proof ${words} ${token}`))};

test('a token is opened with the key, at its port, for its nonce, and only with the proof', async () => {
  assert.equal(await openedToken(answer, key, '4711', ours), token);
  assert.equal(await openedToken(answer, key, '4712', ours), null);
  assert.equal(await openedToken(answer, '2f'.repeat(32), '4711', ours), null);
  assert.equal(await openedToken(answer, key, '4711', '1'.repeat(64)), null);
  assert.equal(await openedToken({...answer, sealed: token}, key, '4711', ours), null);
});
