// SPDX-License-Identifier: BSD-3-Clause
import {hasSomethingToJudge} from './judgement.ts';
import type {App} from './part.ts';

/// What drives a machine to which no curve over frequency belongs, by the type of its excitation.
const OTHER_DRIVES: Record<string, string> = {orders: 'orders', random: 'random excitations', time: 'forces over time'};

/// Why there are no curves. A machine that other excitations drive needs no advice to add a harmonic one.
/// @param app  with the failure of `curves`, whose words name what is missing
export function missingCurves(app: App): string {
  const {asker, index} = app, types = [...index.byPath.values()].filter(e => e.path[0] === 'excitations' && e.path.length === 3 && e.path[2] === 'type').map(e => e.raw.slice(1, -1));
  const drives = Object.keys(OTHER_DRIVES).filter(type => types.includes(type)).map(type => OTHER_DRIVES[type]!);
  const missing = asker.missing('curves');
  if (!missing.includes('no harmonic excitation in the model') || !drives.length) return missing;
  const has = drives.length > 1 ? `${drives.slice(0, -1).join(', ')} and ${drives.at(-1)}` : drives[0]!;
  return `Curves over frequency belong to a harmonic excitation; this machine has ${has}.${hasSomethingToJudge(app) ? ' What is required of it is judged in the table Requirements.' : ''}`;
}
