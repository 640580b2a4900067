// SPDX-License-Identifier: BSD-3-Clause
// Which numbers are sliders: those of [parameters], those that the user pinned in the tree, else masses and mounts.
import {inUnit} from './file_units.ts';
import {pathInCase, quantityOf, type TextIndex} from './numbers_of_text.ts';
import {quantity, written} from './quantities.ts';
import type {Design} from './state.ts';
import {pathText, type Entry} from './toml_outline.ts';

export interface Slider {
  name: string;
  paths: {path: string; factor: number}[];
  from: number;
  to: number;
  logarithmic: boolean;
  unit: string;
  value: number;
}

/// @param name  of the case on the page: a number that it changes is moved in the case, and not in the base model
export function sliders(design: Design, index: TextIndex, pins: readonly string[], name = ''): Slider[] {
  const inCase: InCase = path => pathInCase(path, name, index);
  const own = ofParameters(design, index, inCase), pinned = pins.map(path => ofNumber(path, design, index, inCase)).filter(s => s !== null);
  return own.length || pinned.length ? [...own, ...pinned] : usual(design, index, inCase);
}
type InCase = (path: string) => string;
/// Settings that move a slider to a value.
export const settingsOf = ({paths, unit}: Slider, value: number) =>
  Object.fromEntries(paths.map(({path, factor}) => [path, written(value * factor, unit)]));

/// What a parameter of the file moves.
export const pathsOfParameter = (name: string, index: TextIndex) => pathsOf(index.byPath.get(['parameters', name, 'path'].join('\0')), index);

const textOf = (entry?: Entry) => (entry?.raw ?? '').replace(/^["']|["']$/g, '');

function ofParameters(design: Design, index: TextIndex, inCase: InCase): Slider[] {
  const names = new Set([...index.byPath.values()].filter(e => e.path[0] === 'parameters' && e.path.length > 1).map(e => e.path[1]!));
  const result: Slider[] = [];
  for (const name of names) {
    const key = (last: string) => index.byPath.get(['parameters', name, last].join('\0'));
    const from = quantity(key('from')?.raw ?? ''), to = quantity(key('to')?.raw ?? ''), paths = pathsOf(key('path'), index).map(p => ({...p, path: inCase(p.path)}));
    if (!from || !to || !paths.length) continue;  // a choice of mounts is not a number
    const unit = to.unit || from.unit, now = quantityOf(paths[0]!.path, design, index);
    const shown = now ? inUnit(now.value, now.unit, unit) : null, neutral = Math.min(Math.max(1, from.value), to.value);
    result.push({name, paths, unit, from: inUnit(from.value, from.unit, unit) ?? from.value, to: to.value,
                 logarithmic: textOf(key('spacing')) === 'logarithmic', value: (shown ?? neutral) / paths[0]!.factor});
  }
  return result;
}
/// One path, several, or several with factors.
function pathsOf(entry: Entry | undefined, index: TextIndex): {path: string; factor: number}[] {
  if (entry?.kind === 'array') return entry.children.map(e => ({path: textOf(e), factor: 1}));
  if (entry?.kind === 'table') return entry.children.map(e => ({path: e.path.slice(3).join('.'), factor: quantity(e.raw)?.value ?? 1}));
  if (entry) return [{path: textOf(entry), factor: 1}];
  const inner = [...index.byPath.values()].filter(e => e.path[0] === 'parameters' && e.path[2] === 'path' && e.kind === 'number');
  return inner.map(e => ({path: e.path.slice(3).join('.'), factor: quantity(e.raw)?.value ?? 1}));
}
/// From half to twice its value in the text.
function ofNumber(name: string, design: Design, index: TextIndex, inCase: InCase): Slider | null {
  const path = inCase(name);
  const raw = index.numbers.get(path)?.raw, base = raw ? quantity(raw) : {value: 1, unit: ''}, now = quantityOf(path, design, index) ?? base;
  if (!base || !now) return null;
  const size = Math.abs(base.value), ends = size > 0 ? [base.value / 2, base.value * 2].sort((a, b) => a - b) : [-1, 1];
  return {name, paths: [{path, factor: 1}], from: ends[0]!, to: ends[1]!, logarithmic: base.value > 0, unit: base.unit,
          value: inUnit(now.value, now.unit, base.unit) ?? base.value};
}
/// For a file without parameters: the stiffness of each type of mount, else of the first elements, and the masses.
function usual(design: Design, index: TextIndex, inCase: InCase): Slider[] {
  const namesIn = (table: string) => [...new Set([...index.byPath.values()].filter(e => e.path[0] === table && e.path.length > 1).map(e => e.path[1]!))];
  const types = namesIn('element_types').map(name => ['element_types', name]), elements = namesIn('elements').map(name => ['elements', name]);
  const scales = (types.length ? types : elements.slice(0, 4)).map((parts): Slider => {
    const path = inCase(pathText([...parts, 'scale']));
    return {name: `stiffness of ${parts[1]}`, paths: [{path, factor: 1}], from: 0.25, to: 4, logarithmic: true, unit: '',
            value: quantityOf(path, design, index)?.value ?? 1};
  });
  const masses = namesIn('bodies').map(name => ({path: pathText(['bodies', name, 'mass']), name})).filter(({path}) => index.numbers.has(path))
    .map(({path, name}) => ({...ofNumber(path, design, index, inCase)!, name: `mass of ${name}`}));
  return [...scales, ...masses.slice(0, 4)];
}
