// SPDX-License-Identifier: BSD-3-Clause
// Which numbers are sliders: those of [parameters], those that the user pinned in the tree, else masses and mounts.
import {inUnit} from './file_units.ts';
import {pathInCase, quantityOf, type TextIndex} from './numbers_of_text.ts';
import {number, quantity, written} from './quantities.ts';
import type {Scene} from './results.ts';
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
  written?: string;  // the number as it is set, if it has a unit and the slider none, or one that cannot be converted here: then `value` only places the thumb
}

/// @param name  of the case on the page: a number that it changes is moved in the case, and not in the base model
/// @param machine  states which numbers scale the stiffness of its elements; null: not known yet
export function sliders(design: Design, index: TextIndex, pins: readonly string[], name = '', machine: Pick<Scene, 'elements' | 'bodies'> | null = null): Slider[] {
  const inCase: InCase = path => pathInCase(path, name, index);
  const own = ofParameters(design, index, inCase), pinned = pins.map(path => ofNumber(path, design, index, inCase)).filter(s => s !== null);
  return own.length || pinned.length || !machine ? [...own, ...pinned] : usual(design, index, inCase, machine);
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
    const neutral = Math.min(Math.max(1, from.value), to.value);
    result.push({name, paths, unit, from: inUnit(from.value, from.unit, unit) ?? from.value, to: to.value,
                 logarithmic: textOf(key('spacing')) === 'logarithmic', ...inSliderUnit(now, unit, neutral, paths[0]!.factor)});
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
          ...inSliderUnit(now, base.unit, base.value)};
}
/// A number that is set, in the unit of its slider. @param otherwise  the place of the thumb if it has none
function inSliderUnit(now: ReturnType<typeof quantity>, unit: string, otherwise: number, factor = 1): Pick<Slider, 'value' | 'written'> {
  const value = now ? inUnit(now.value, now.unit, unit) : null;
  const isShown = now !== null && (value === null || !unit && now.unit !== '');
  return {value: (value ?? otherwise) / factor, ...isShown ? {written: `${number(now.value / factor, 5)} ${now.unit}`.trim()} : {}};
}
const MOST = 4;  // elements and bodies
type Machine = Pick<Scene, 'elements' | 'bodies'>;

/// For a file without parameters: the stiffness of each type of mount, else of the first elements, and the masses. A step of each gives
/// a machine that is possible.
function usual(design: Design, index: TextIndex, inCase: InCase, machine: Machine): Slider[] {
  const keys = keysOfTypes(index, machine);
  const ofTypes = [...keys].flatMap(([name, key]) => (key ? [{name, parts: ['element_types', name], key}] : []));
  const ofElements = machine.elements.flatMap(({name, stiffness_key: key}) => (key ? [{name, parts: ['elements', name], key}] : []));
  const scales = (ofTypes.length ? ofTypes : ofElements.slice(0, MOST)).map(({name, parts, key}) =>
    ofFactor(`stiffness of ${name}`, inCase(`${pathText(parts)}.${key}`), 4, design, index));
  return [...scales, ...machine.bodies.filter(b => !b.node && b.mass > 0).slice(0, MOST).map(({name}) => ofMass(name, design, index, inCase))];
}
/// The number of each type that scales the stiffness of its elements; null: nothing does.
function keysOfTypes(index: TextIndex, {elements}: Machine): Map<string, string | null> {
  const keys = new Map<string, string | null>();
  for (const {path} of index.byPath.values()) if (path[0] === 'element_types' && path.length > 1) keys.set(path[1]!, 'scale');  // of elements in another file
  for (const {name, stiffness_key: key} of elements) {
    const type = typeInText(name, index);
    if (keys.has(type)) keys.set(type, key ?? null);
  }
  return keys;
}
/// The type of an element as the text has it: in its table, or in its row of a table of elements.
function typeInText(name: string, {byPath}: TextIndex): string {
  const own = byPath.get(['elements', name, 'type'].join('\0'));
  if (own) return textOf(own);
  const row = [...byPath.values()].find(e => e.path[0] === 'tables' && e.path.length === 5 && e.path[4] === 'name' && textOf(e) === name);
  return row ? textOf(byPath.get([...row.path.slice(0, 4), 'type'].join('\0'))) : '';
}
/// The mass in the unit of the file. An inertia about the pole would be that of another body with another mass, and solids may have a
/// density instead: then it is a factor that keeps the centre of mass and the inertia about it.
function ofMass(name: string, design: Design, index: TextIndex, inCase: InCase): Slider {
  const body = ['bodies', name], path = pathText([...body, 'mass']), about = index.byPath.get([...body, 'inertia', 'about'].join('\0'));
  if (index.numbers.has(path) && textOf(about) !== 'pole') return {...ofNumber(path, design, index, inCase)!, name: `mass of ${name}`};
  return ofFactor(`mass of ${name}, factor`, inCase(pathText([...body, 'mass_about_center'])), 2, design, index);
}
/// A factor, which is 1 if the text has none. @param most  its largest value, and the inverse of its least one
function ofFactor(name: string, path: string, most: number, design: Design, index: TextIndex): Slider {
  return {name, paths: [{path, factor: 1}], from: 1 / most, to: most, logarithmic: true, unit: '', ...inSliderUnit(quantityOf(path, design, index), '', 1)};
}
