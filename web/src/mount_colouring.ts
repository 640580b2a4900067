// SPDX-License-Identifier: BSD-3-Clause
// What the mounts are coloured by: numbers of results, and the scale that they are read on.
import {number, scaleOf} from './quantities.ts';
import type {Check, Modes, Verdict} from './results.ts';

export const COLOURINGS = {
  none: 'plain',
  limit: 'share of its limit',
  utilisation: "load over the maker's range",
  deflection: 'deflection at rest',
  compression: 'compression at rest',
  energy: 'strain energy of the mode',
} as const;
export type Colouring = keyof typeof COLOURINGS;

/// Values of elements from 0 to `top`. With `limited`, 1 is the limit: what exceeds it has a colour of its own.
export interface MountValues {
  title: string;
  values: ReadonlyMap<string, number>;  // Infinity: nothing of the limit is left
  words: (value: number) => string;
  top: number;
  limited: boolean;
}
export interface MountResults {
  verdict: Verdict | null;
  check: Check | null;
  modes: Modes | null;
}

/// Null: no such result, see `missingValues`.
export function mountValues(colouring: Colouring, {verdict, check, modes}: MountResults, ofCase: string, mode: number | null): MountValues | null {
  const title = COLOURINGS[colouring];
  switch (colouring) {
    case 'none': return null;
    case 'limit': {
      const found = verdict?.cases.find(c => c.case === ofCase);
      return shares(found?.decides === false ? `${title}, not binding in this case` : title, (found?.elements ?? []).map(e => [e.element, e.share ?? Infinity]));
    }
    case 'utilisation': return shares(title, atRest(check, ofCase).flatMap(m => (m.utilisation === null ? [] : [[m.element, m.utilisation]])));
    case 'deflection': return sizes(title, 'm', atRest(check, ofCase).map(m => [m.element, m.deflection]));
    case 'compression': return sizes(title, 'N', atRest(check, ofCase).map(m => [m.element, m.compression]));
    case 'energy': {
      const found = modes?.modes.find(m => m.number === mode)?.strain_energy_share;
      const values = found?.map((share, e): [string, number] => [modes!.elements[e]!, share]) ?? [];
      return values.length ? {title, values: new Map(values), words: percent, top: Math.max(...values.map(v => Math.abs(v[1])), 1e-12), limited: false} : null;
    }
  }
}
/// Why there is nothing to colour by.
export function missingValues(colouring: Colouring): string {
  switch (colouring) {
    case 'none': return '';
    case 'limit': return 'No load, force or deflection of a mount has a limit in this file.';
    case 'utilisation': return 'No mount of this file has a load range of its maker.';
    case 'energy': return 'No mode is shown, or it strains no element.';
    case 'deflection': return 'No mount deflects at rest: nothing loads it, or a preload bears the load.';
    case 'compression': return 'Nothing loads the mounts at rest: the file has no gravity.';
  }
}

/// Mounts of a case; it is listed only if it differs from the base model.
function atRest(check: Check | null, ofCase: string) {
  const all = check?.mounts ?? [], own = all.filter(m => m.case === ofCase);
  return own.length ? own : all.filter(m => m.case === '');
}
const percent = (share: number) => (Number.isFinite(share) ? `${number(100 * share, 3)} %` : '∞');
const shares = (title: string, values: [string, number][]): MountValues | null =>
  (values.length ? {title, values: new Map(values), words: percent, top: 1, limited: true} : null);
function sizes(title: string, unit: string, values: [string, number][]): MountValues | null {
  const top = Math.max(0, ...values.map(v => Math.abs(v[1]))), scale = scaleOf(top, unit);
  return top > 0 ? {title, values: new Map(values), words: value => `${number(value * scale.factor, 3)} ${scale.unit}`, top, limited: false} : null;
}
