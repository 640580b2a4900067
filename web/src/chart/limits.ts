// SPDX-License-Identifier: BSD-3-Clause
// Which limits of the file belong to the drawn curves, and where. Their values and margins are those of the verdict.
import {number, quantityName} from '../quantities.ts';
import type {Curves, Requirement, Verdict} from '../results.ts';

/// A limit beside a curve of its quantity, under the same excitations; or of the steady motions of a nonlinear machine.
export interface Limit {
  requirement: Requirement;
  result: string;
  from: number;  // ω [rad/s]; of a speed that of the shaft
  to: number;  // infinite without an upper end
  isOfCurve: boolean;  // else the judged value is another one: of all orders together at a speed, or of steady motions
}
/// What other limits of a result bound, which no curve over the frequency of one excitation shows.
const OTHER_NUMBERS: Record<string, string> = {rms: 'the root mean square under the random excitations', largest: 'the largest value over time', static: 'the value at rest', band_line: 'the levels in bands of frequencies, of which no curve is drawn'};

export interface NotDrawn {
  words: string;
  why: string;
}

/// Limits of amplitudes in the file, beside the curves of a model; and those that the curves do not show, with the reason.
export function limitsOf(curves: Curves, model: number, requirements: readonly Requirement[]): {drawn: Limit[]; not: NotDrawn[]} {
  const drawn: Limit[] = [], not: NotDrawn[] = [];
  for (const requirement of requirements) {
    const {kind, subject, unit, speed, band, place, order, excitations, level = null} = requirement;
    const curve = curves.results.find(r => r.name === subject), other = OTHER_NUMBERS[kind];
    if (curve && other) not.push({words: withMargin(requirement), why: `it limits ${other}`});
    if (!place.length || kind !== 'amplitude' && kind !== 'operation' && kind !== 'steady') continue;
    const drives = curves.models[model]?.excitations ?? [];
    const why = !curve ? `no curve of ${subject} is drawn`
      : curve.unit !== unit ? otherQuantity(unit, curve.unit)
      : kind === 'operation' && level !== (curve.level ?? null) ? `it is judged ${level ?? 'without a level'}, of all orders together, and the axis is ${curve.level ?? 'without a level'}`
      : order !== null ? `it holds for order ${order} of the shaft alone`
      : kind === 'amplitude' && excitations.length && !sameNames(excitations, drives) ? `it holds under ${excitations.join(', ')} alone` : '';
    if (why) not.push({words: kind === 'operation' ? withMargin(requirement) : requirement.shown_requirement ?? requirement.requirement, why});
    else drawn.push({requirement: asCurve(requirement, curve!.level_factor), result: subject, from: (speed ?? band)?.[0] ?? 0, to: (speed ?? band)?.[1] ?? Infinity, isOfCurve: speed === null && kind !== 'steady'});
  }
  for (const line of curves.lines ?? []) {
    const curve = curves.results.find(r => r.name === line.result);
    if (curve && curve.unit !== line.unit) not.push({words: `${line.result} within "${line.name}"`, why: otherQuantity(line.unit, curve.unit)});
  }
  return {drawn, not};
}
/// Unit of the first limit of a motion or a force that decides: the quantity that one wants to see first. Null: there is none.
export function unitOfFirstLimit({cases}: Verdict, {lines = []}: Curves): string | null {
  const first = cases.filter(c => c.decides).flatMap(c => c.requirements).find(r => ['amplitude', 'operation', 'steady', 'limit_line', 'rms', 'largest'].includes(r.kind));
  return first?.kind === 'limit_line' ? lines.find(l => l.result === first.subject)?.unit ?? null : first?.unit ?? null;
}
/// Its numbers as the axis takes those of the curves: one at a speed is at the level of the file, which is that of the axis. It is never
/// converted, for the peak of several orders is no multiple of their rms value.
function asCurve(r: Requirement, share = 1): Requirement {
  const over = (value: number | null) => (value === null ? null : value / share);
  return r.kind === 'operation' ? {...r, allowed: over(r.allowed), value: over(r.value)} : r;
}
const withMargin = (r: Requirement) => `${r.shown_requirement ?? r.requirement} (${!r.judged ? 'not judged' : `${r.shown_value ? `${r.shown_value}, ` : ''}margin ${number(r.margin ?? Infinity, 3)}`})`;
const otherQuantity = (limited: string, drawn: string) => `it limits the ${quantityName(limited)}, the curve is the ${quantityName(drawn)}`;
const sameNames = (a: readonly string[], b: readonly string[]) => a.length === b.length && a.every(name => b.includes(name));
