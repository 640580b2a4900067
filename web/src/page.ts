// SPDX-License-Identifier: BSD-3-Clause
// Starts the page of `trivet serve`.
import {ServerEngine} from './engine.ts';
import {newApp} from './new_app.ts';
import {PageShell} from './page_shell.ts';
import {ProjectFile} from './project_file.ts';
import {Schema} from './schema.ts';
import {tokenOfTab} from './token.ts';

async function start() {
  const engine = new ServerEngine(tokenOfTab()), project = await engine.project(), app = newApp(engine, project, engine.beside(), engine.beside());
  const {state, asker, display} = app, file = app.file = new ProjectFile(engine, project, state, asker, (notice, listed) => display.set({notice, listed: listed ? notice : ''}));
  const shell = new PageShell();
  shell.app = app;
  file.begin();
  addEventListener('hashchange', () => {  // the address of another start of the program was opened in this tab
    engine.useToken(tokenOfTab());
    void engine.project().finally(() => file.look());  // it has another key
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
