// SPDX-License-Identifier: BSD-3-Clause
// Undo and redo over a reload: the steps nearest to the present design, as JSON of bounded size. Most of them have the same text.
import type {History, Step} from './state.ts';

interface KeptStep {
  text: number;  // among `texts`
  settings: [string, string][];
  case: string | null;
}
export interface KeptHistory {
  texts: string[];
  past: KeptStep[];
  future: KeptStep[];
}
const MOST = 50, LARGEST = 1_000_000;  // steps, characters

/// Those that undo reaches first, then those that redo does.
export function keptHistory({past, future}: History, most = MOST, largest = LARGEST): KeptHistory {
  const kept: KeptHistory = {texts: [], past: [], future: []};
  let [steps, size] = [0, 0];
  const keep = (list: readonly Step[], into: KeptStep[]) => {
    for (const {design, case: name} of [...list].reverse()) {
      const settings = [...design.settings], known = kept.texts.indexOf(design.text);
      const added = JSON.stringify(settings).length + (name ?? '').length + (known < 0 ? JSON.stringify(design.text).length : 0);
      if (steps === most || size + added > largest) return;
      [steps, size] = [steps + 1, size + added];
      into.unshift({text: known < 0 ? kept.texts.push(design.text) - 1 : known, settings, case: name});
    }
  };
  keep(past, kept.past);
  keep(future, kept.future);
  return kept;
}
export function historyOf({texts, past, future}: KeptHistory): History {
  const step = (kept: KeptStep): Step => ({design: {text: texts[kept.text]!, settings: new Map(kept.settings)}, case: kept.case});
  return {past: past.map(step), future: future.map(step)};
}
