// SPDX-License-Identifier: BSD-3-Clause
// Numbers of the project file by the paths that `--set` accepts, with the values that sliders and the tree changed.
import {quantity} from './quantities.ts';
import type {Design} from './state.ts';
import {allEntries, outline, pathParts, pathText, type Entry} from './toml_outline.ts';

const COMPONENTS = ['x', 'y', 'z'];

/// Path of a number for --set: a component of an array of three by its name, a row of a table of elements by the name of
/// the row. Null: it can be changed only in the text.
export function settingPath(entry: Entry, parents: ReadonlyMap<string, Entry>): string | null {
  let path = [...entry.path];
  if (path[0] === 'parameters' || path[0] === 'trivet') return null;
  if (path[0] === 'tables') {
    if (path[2] !== 'rows' || path[3] === undefined) return null;
    const row = parents.get(path.slice(0, 4).join('\0')), name = row?.children.find(e => e.path.at(-1) === 'name');
    if (!name) return null;
    path = [path[1]!, name.raw.slice(1, -1), ...path.slice(4)];
  }
  const arrays = entry.path.map((_, i) => parents.get(entry.path.slice(0, i + 1).join('\0'))).filter(e => e?.kind === 'array');
  const own = arrays.filter(a => a!.path[0] !== 'tables' || a!.path.length > 3);
  if (own.length > 1) return null;
  if (own.length === 1) {
    if (own[0]!.children.length !== 3 || own[0] !== parents.get(entry.path.slice(0, -1).join('\0'))) return null;
    path[path.length - 1] = COMPONENTS[Number(path.at(-1))]!;
  }
  return pathText(path);
}

/// The number that is valid in a case: of the case, if that changes it, else of the base model.
export function pathInCase(path: string, name: string, index: TextIndex): string {
  const ofCase = name ? pathText(['cases', name, ...pathParts(path)]) : path;
  return index.numbers.has(ofCase) ? ofCase : path;
}

/// All entries of a text by their joined path, and its numbers by setting path.
export function indexOf(text: string) {
  const entries = outline(text), byPath = new Map<string, Entry>();
  for (const entry of allEntries(entries)) byPath.set(entry.path.join('\0'), entry);
  const numbers = new Map<string, Entry>();
  for (const entry of byPath.values()) {
    const path = entry.kind === 'number' ? settingPath(entry, byPath) : null;
    if (path) numbers.set(path, entry);
  }
  return {entries, byPath, numbers};
}
export type TextIndex = ReturnType<typeof indexOf>;

/// Names of the cases; "" is the base model.
export const casesOf = ({byPath}: TextIndex) =>
  ['', ...new Set([...byPath.values()].filter(e => e.path[0] === 'cases' && e.path.length > 1).map(e => e.path[1]!))];

/// Numbers of cases that settings of the base model would replace: with their values in the text, unless they are set, too.
export function numbersOfCases(settings: ReadonlyMap<string, string>, index: TextIndex): [path: string, value: string][] {
  const found: [string, string][] = [];
  for (const path of settings.keys())
    for (const name of path.startsWith('cases.') ? [] : casesOf(index)) {
      const own = pathInCase(path, name, index), entry = index.numbers.get(own);
      if (own !== path && entry && !settings.has(own)) found.push([own, entry.raw]);
    }
  return found;
}

/// The value that is valid now, as it is written: of a setting, or of the text.
export function valueOf(path: string, design: Design, index: TextIndex): string | null {
  return design.settings.get(path) ?? index.numbers.get(path)?.raw ?? null;
}
export const quantityOf = (path: string, design: Design, index: TextIndex) => {
  const raw = valueOf(path, design, index);
  return raw === null ? null : quantity(raw);
};
