// SPDX-License-Identifier: BSD-3-Clause
// The levels of a limit over frequency in the project file: a hand moves all of them by one factor.
import {rounded} from './limit_number.ts';
import type {TextIndex} from './numbers_of_text.ts';
import {quantity, written} from './quantities.ts';
import type {State} from './state.ts';
import type {Entry} from './toml_outline.ts';

export interface Level {
  entry: Entry;
  value: number;
  unit: string;
}
/// The levels of the rows, in a case first those of the case. Null: the file has none, but names another file or a published line.
export function levelsOf(name: string, caseName: string, {byPath}: TextIndex): Level[] | null {
  const ofCase = caseName ? byPath.get(['cases', caseName, 'limit_lines', name, 'rows'].join('\0')) : undefined;
  const rows = ofCase ?? byPath.get(['limit_lines', name, 'rows'].join('\0'));
  const levels = (rows?.children ?? []).map(({children: [, entry]}) => {
    const now = entry && quantity(entry.raw);
    return now && entry ? {entry, ...now} : null;
  });
  return levels.length && levels.every(level => level !== null) ? levels : null;
}
/// Multiplies the levels in the text, as one step of undo.
export const scaleLevels = (state: State, levels: readonly Level[], factor: number) =>
  state.replaceNumbers(levels.map(({entry, value, unit}) => [entry, written(rounded(value * factor), unit)]));
