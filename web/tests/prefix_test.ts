// SPDX-License-Identifier: BSD-3-Clause
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {scaleAtLevel, withUnit} from '../src/quantities.ts';

// The same cases as tests/unit/foundation/unit_prefix_test.cpp: one rule on the page, in the report and on the screen.
test('numbers are near one to a thousand, velocities of machines in mm/s', () => {
  assert.equal(withUnit(0.01053, 'm'), '10.53 mm');
  assert.equal(withUnit(2.437e5, 'N/m'), '243.7 kN/m');
  assert.equal(withUnit(0.5, 'kg'), '0.5 kg');
  assert.equal(withUnit(836.4e-6, 'm/s'), '0.8364 mm/s');
  assert.equal(withUnit(100e-6, 'm/s'), '0.1 mm/s');
  assert.equal(withUnit(50e-6, 'm/s'), '50 µm/s');
  assert.deepEqual(scaleAtLevel(836.4e-6, 'm/s', {level: 'rms', level_factor: 1}), {factor: 1e3, unit: 'mm/s rms'});
});
