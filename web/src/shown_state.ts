// SPDX-License-Identifier: BSD-3-Clause
// What a notebook keeps of its widget: settings and case for Python, and for the still the results and how they are shown.
import type {Display} from './display.ts';
import type {KernelEngine, Model} from './kernel_engine.ts';
import type {App} from './part.ts';

const KEPT = ['shown', 'damped', 'share', 'speed', 'frequencyUnit', 'logarithmicFrequency', 'logarithmicAmplitude', 'decibel'] as const satisfies readonly (keyof Display)[];
const REST = 500;  // ms

export const showAgain = ({display, asker}: App, view: object) => {
  display.set(Object.fromEntries(KEPT.filter(name => name in view).map(name => [name, (view as Record<string, unknown>)[name]])));
  asker.again();
};

/// Sends settings as they change, and the results and the view when everything on it is computed. @returns what ends it
export function keepAtRest(app: App, engine: KernelEngine, model: Model): () => void {
  const {state, display, asker} = app;
  let timer = 0, sent = '', kept: unknown[] = [];
  const keep = () => {
    const answer = asker.finished;
    if (!answer) return;  // the next answer comes here again
    const view = Object.fromEntries(KEPT.map(name => [name, display[name]])), now = [state.revision, JSON.stringify(view), ...answer.results.map(r => r.json)];
    if (now.length === kept.length && now.every((value, i) => value === kept[i])) return;
    engine.keep(view, answer);
    kept = now;
  };
  const changed = () => {
    const {settings, case: name} = state.change, now = JSON.stringify([settings, name]);
    if (now !== sent) {
      model.set('_settings', settings);
      model.set('_case', name);
      model.save_changes();
      sent = now;
    }
    clearTimeout(timer);
    timer = window.setTimeout(keep, REST);
  };
  const ends = [state.subscribe(changed), display.subscribe(changed), asker.subscribe(changed), () => { clearTimeout(timer); }];
  changed();
  return () => { for (const end of ends) end(); };
}
