// SPDX-License-Identifier: BSD-3-Clause
// The two numbers of a map: where the design on the page is on it, and which settings move it there.
import {inUnit} from './file_units.ts';
import {quantityOf} from './numbers_of_text.ts';
import type {App} from './part.ts';
import {written} from './quantities.ts';
import type {DesignMap, MapAxis} from './results.ts';
import {settingsOf, sliders} from './slider_list.ts';

export class AxisNumber {
  constructor(private readonly app: App, private readonly axis: MapAxis, private readonly map: DesignMap, private readonly which: 'x' | 'y') {}

  /// Paths of the file that the axis moves.
  get paths(): string[] {
    return this.slider?.paths.map(p => p.path) ?? [this.axis.parameter];
  }
  /// The value on the page in the unit of the axis; null: the file has no such number.
  get value(): number | null {
    const {state, index} = this.app, {axis} = this, isSet = this.paths.some(p => state.design.settings.has(p));
    const mark = this.map.marks.find(m => m.case === state.case)?.[this.which] ?? null;
    if (!isSet && state.case && mark !== null) return mark;
    const {slider} = this;
    if (slider) return inUnit(slider.value, slider.unit, axis.unit);
    const now = quantityOf(axis.parameter, state.design, index);
    if (now) return inUnit(now.value, now.unit, axis.unit);
    return mark ?? (axis.unit === '' && axis.from <= 1 && axis.to >= 1 ? 1 : null);  // a factor that is not in the file is 1
  }
  /// Settings for a value in the unit of the axis.
  settings(value: number): Record<string, string> {
    const {slider, axis} = this, rounded = Number(value.toPrecision(4));
    if (!slider) return {[axis.parameter]: written(rounded, axis.unit)};
    return settingsOf(slider, inUnit(rounded, axis.unit, slider.unit) ?? rounded);
  }
  /// Value at a part 0 … 1 of the axis, and the part of a value.
  at(part: number): number {
    const {from, to, spacing} = this.axis;
    return spacing === 'logarithmic' ? from * (to / from) ** part : from + part * (to - from);
  }
  private get slider() {
    const {state, index} = this.app;
    return sliders(state.design, index, []).find(s => s.name === this.axis.parameter) ?? null;
  }
}
export const partOn = ({from, to, spacing}: MapAxis, value: number) => (spacing === 'logarithmic' ? Math.log(value / from) / Math.log(to / from) : (value - from) / (to - from));

/// Round numbers on an axis, at most about `most`.
export function ticksOf({from, to, spacing}: MapAxis, most: number): number[] {
  if (spacing === 'logarithmic') {
    const all = [1, 2, 5], digits = Math.log10(to / from) * 3 > most ? [1] : all, found: number[] = [];
    for (let decade = Math.floor(Math.log10(from)); decade <= Math.log10(to); decade++) for (const d of digits) found.push(Number((d * 10 ** decade).toPrecision(3)));
    return found.filter(v => v >= from * (1 - 1e-9) && v <= to * (1 + 1e-9));
  }
  const rough = (to - from) / most, decade = 10 ** Math.floor(Math.log10(rough)), step = decade * ([1, 2, 5, 10].find(s => s * decade >= rough) ?? 10);
  const first = Math.ceil(from / step - 1e-9);
  return Array.from({length: Math.floor(to / step + 1e-9) - first + 1}, (_, i) => Number(((first + i) * step).toPrecision(12)));
}
