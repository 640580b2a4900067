// SPDX-License-Identifier: BSD-3-Clause
// Which limits of the file belong to the drawn curves, and where. Their values and margins are those of the verdict.
import {quantityName} from '../quantities.ts';
import type {Curves, Requirement} from '../results.ts';

/// A limit beside a curve of its quantity, under the same excitations.
export interface Limit {
  requirement: Requirement;
  result: string;
  from: number;  // ω [rad/s]; of a speed that of the shaft
  to: number;  // infinite without an upper end
  atSpeed: boolean;  // the judged value is that of all orders together, not of the curve
}
export interface NotDrawn {
  words: string;
  why: string;
}

/// Limits of amplitudes in the file, beside the curves of a model; and those that the curves do not show, with the reason.
export function limitsOf(curves: Curves, model: number, requirements: readonly Requirement[]): {drawn: Limit[]; not: NotDrawn[]} {
  const drawn: Limit[] = [], not: NotDrawn[] = [];
  for (const requirement of requirements) {
    const {kind, subject, unit, speed, band, place, order, excitations} = requirement;
    if (!place.length || kind !== 'amplitude' && kind !== 'operation') continue;
    const curve = curves.results.find(r => r.name === subject), drives = curves.models[model]?.excitations ?? [];
    const why = !curve ? `no curve of ${subject} is drawn`
      : curve.unit !== unit ? otherQuantity(unit, curve.unit)
      : order !== null ? `it holds for order ${order} of the shaft alone`
      : kind === 'amplitude' && excitations.length && !sameNames(excitations, drives) ? `it holds under ${excitations.join(', ')} alone` : '';
    if (why) not.push({words: requirement.requirement, why});
    else drawn.push({requirement, result: subject, from: (speed ?? band)?.[0] ?? 0, to: (speed ?? band)?.[1] ?? Infinity, atSpeed: speed !== null});
  }
  for (const line of curves.lines ?? []) {
    const curve = curves.results.find(r => r.name === line.result);
    if (curve && curve.unit !== line.unit) not.push({words: `${line.result} within "${line.name}"`, why: otherQuantity(line.unit, curve.unit)});
  }
  return {drawn, not};
}
const otherQuantity = (limited: string, drawn: string) => `it limits the ${quantityName(limited)}, the curve is the ${quantityName(drawn)}`;
const sameNames = (a: readonly string[], b: readonly string[]) => a.length === b.length && a.every(name => b.includes(name));
