// SPDX-License-Identifier: BSD-3-Clause
import {Asker, type Wish} from './asker.ts';
import {BesideResults} from './beside.ts';
import {Display} from './display.ts';
import type {Engine, Project} from './engine.ts';
import {hasSomethingToJudge} from './judgement.ts';
import {App} from './part.ts';
import type {Scene} from './results.ts';
import {State} from './state.ts';
import {sampleWishes} from './sampled_designs.ts';
import {questionsBeside, wishes} from './wishes.ts';

const PATIENCE = 1000;  // ms for a sample while a slider moves
const IDLE = 3;  // then samples take a quarter of the time, and curves do not wait for them

/// What the parts of a page on this project share. Nothing is asked before a text is opened.
/// @param aside  answers what is beside the results of the page
/// @param sampling  answers at the same time what is asked about the tolerances; null: nothing is
export function newApp(engine: Engine, project: Project, aside: Pick<Engine, 'ask'> = engine, sampling: Pick<Engine, 'ask'> | null = null): App {
  const state = new State(), display = new Display();
  const wanted = (): Wish[] => (state.design.text ? wishes(display, {hasSomethingToJudge: hasSomethingToJudge(app), hasSteady: app.index.byPath.has('analyses\0steady'),
    bodies: asker.result<Scene>('scene')?.bodies.length ?? 0}) : []);
  const beside = new BesideResults(aside, () => questionsBeside(app));
  const first: Pick<Engine, 'ask'> = {ask(...question) {  // the page does not wait for what is beside it
    if (!engine.oneAtATime) beside.yield();  // else its answer comes first anyway
    return engine.ask(...question);
  }};
  const asker = new Asker(first, state, wanted), sampler = sampling && new Asker(sampling, state, () => sampleWishes(app), PATIENCE, IDLE);
  const app: App = new App(engine, project, state, display, asker, beside, sampler);
  asker.subscribe(() => { if (sampler?.trouble && !asker.trouble) sampler.afresh(); });
  state.subscribe(beside.rest);
  asker.subscribe(beside.rest);
  return app;
}
