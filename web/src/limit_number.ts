// SPDX-License-Identifier: BSD-3-Clause
// The number of a limit in the project file: where it is, what it is now, and how a hand changes it. Its unit and level stay;
// the program converts it.
import {quantity, written} from './quantities.ts';
import type {TextIndex} from './numbers_of_text.ts';
import type {Requirement} from './results.ts';
import type {Design, State} from './state.ts';
import {pathText, type Entry} from './toml_outline.ts';

export interface LimitNumber {
  entry: Entry;
  path: string | null;  // for a setting; null: it is replaced in the text, because it is in a list or in a case
  value: number;  // as the file has it now
  unit: string;
}

/// The number at a place of the file, in a case first that of the case. Null: the text has none there.
export function limitNumber(place: readonly string[], caseName: string, design: Design, index: TextIndex): LimitNumber | null {
  const ofCase = caseName ? index.byPath.get(['cases', caseName, ...place].join('\0')) : undefined, entry = ofCase ?? index.byPath.get(place.join('\0'));
  if (!entry) return null;
  const inList = place.some((_, i) => index.byPath.get(place.slice(0, i + 1).join('\0'))?.kind === 'array');
  const path = ofCase || inList ? null : pathText(place), now = quantity((path && design.settings.get(path)) || entry.raw);
  return now && {entry, path, ...now};
}
/// As many digits as a hand would write.
export const rounded = (value: number) => Number(value.toPrecision(3));

/// Sets the number; a drag is one step of undo.
export function setLimit(state: State, {entry, path, unit}: LimitNumber, value: number, drag = false) {
  if (path) return state.set({[path]: written(value, unit)}, drag);
  if (drag) return;  // the text is replaced once, at the end
  state.replaceNumber(entry, written(value, unit));
}

/// SI values of limits while their numbers change faster than they are judged.
export class PresentLimits {
  private readonly factors = new Map<string, number>();  // SI over the unit of the file

  /// @param fresh  the requirement is that of the present numbers  @returns null if the SI value of a new unit is not known yet
  allowed({place, allowed}: Requirement, {value, unit}: LimitNumber, fresh: boolean): number | null {
    const key = [...place, unit].join('\0');
    if (fresh && allowed !== null) this.factors.set(key, allowed / value);
    const factor = this.factors.get(key);
    return factor === undefined ? null : value * factor;
  }
}
