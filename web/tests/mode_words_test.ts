// SPDX-License-Identifier: BSD-3-Clause
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {briefMode} from '../src/mode_words.ts';

test('a free or growing mode keeps its word, which is no direction', () => {
  assert.equal(briefMode('translation along x (free)'), 'along x (free)');
  assert.equal(briefMode('hull: mostly rotation about z through (0, 0.1, 0) m (free)'), 'hull: ≈ about z (free)');
  assert.equal(briefMode('mostly translation along z (grows)'), '≈ along z (grows)');
});
test('only three components are a skew axis', () => {
  assert.equal(briefMode('mostly rotation about (0.1, -0.2, 0.97) through (0, 0, 1e-05) m'), '≈ about skew axis');
  assert.equal(briefMode('translation along (0.6, 0, 0.8) (free)'), 'along skew axis (free)');
  assert.equal(briefMode('pump (left, new): mostly translation along y'), 'pump (left, new): ≈ along y');
});
