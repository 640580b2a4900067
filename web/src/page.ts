// SPDX-License-Identifier: BSD-3-Clause
// Starts the page of `trivet serve`.
import {Asker, type Wish} from './asker.ts';
import {BesideResults} from './beside.ts';
import {Display} from './display.ts';
import {ServerEngine, type Engine} from './engine.ts';
import {hasSomethingToJudge} from './judgement.ts';
import {PageShell} from './page_shell.ts';
import {App} from './part.ts';
import {ProjectFile} from './project_file.ts';
import {Schema} from './schema.ts';
import {State} from './state.ts';
import {tokenOfTab} from './token.ts';
import {questionsBeside, wishes} from './wishes.ts';

async function start() {
  const token = tokenOfTab(), engine = new ServerEngine(token), project = await engine.project();
  const state = new State(), display = new Display();
  const wanted = (): Wish[] => (state.design.text ? wishes(display, {hasSomethingToJudge: hasSomethingToJudge(app), hasSteady: app.index.byPath.has('analyses\0steady')}) : []);
  const beside = new BesideResults(engine.beside(), () => questionsBeside(app));
  const first: Pick<Engine, 'ask'> = {ask(...question) {  // the page does not wait for what is beside it
    beside.yield();
    return engine.ask(...question);
  }};
  const asker = new Asker(first, state, wanted), file = new ProjectFile(engine, project, state, asker, notice => display.set({notice}));
  const app: App = new App(engine, project, state, display, asker, file, beside);
  state.subscribe(beside.rest);
  asker.subscribe(beside.rest);
  const shell = new PageShell();
  shell.app = app;
  file.begin();
  addEventListener('hashchange', () => {  // the address of another start of the program was opened in this tab
    engine.useToken(tokenOfTab());
    void file.look();
  });
  document.body.replaceChildren(shell);
  app.schema = new Schema(await engine.schema() as ConstructorParameters<typeof Schema>[0]);
  shell.requestUpdate();
}

start().catch((error: unknown) => {
  const said = document.createElement('p');
  said.className = 'fatal';
  said.setAttribute('role', 'alert');
  said.textContent = error instanceof Error ? error.message : String(error);
  document.body.replaceChildren(said);
  addEventListener('hashchange', () => location.reload());
});
