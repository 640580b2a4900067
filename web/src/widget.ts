// SPDX-License-Identifier: BSD-3-Clause
// The widget of `project.show()` in notebooks: a module of anywidget, and the still that takes its place without a kernel.
import {KernelEngine, type Model, type Opened} from './kernel_engine.ts';
import {KeptEngine, type Kept} from './kept_engine.ts';
import {newApp} from './new_app.ts';
import {NotebookView} from './notebook_view.ts';
import {followTheme} from './notebook_theme.ts';
import type {App} from './part.ts';
import {keepAtRest, showAgain} from './shown_state.ts';
import type {Engine} from './engine.ts';

declare const WIDGET_CSS: string, WIDGET_BUILD: string;  // by build.mjs
const STILL = 'data-trivet-still';

/// The page may have the elements of another build: those of a kernel before it was updated.
const page = globalThis as {trivetWidgetBuild?: string};
const isFirstBuild = () => (page.trivetWidgetBuild ??= WIDGET_BUILD) === WIDGET_BUILD;

/// anywidget calls this for each view. Without a kernel there is no answer, nothing is drawn, and the still is seen.
function render({model, el}: {model: Model; el: HTMLElement}) {
  const engine = new KernelEngine(model), ends: (() => void)[] = [() => engine.close()];
  let closed = false;
  engine.opened().then(opened => {
    if (closed) return;
    hideStill(opened.key);
    const app = mount(el, engine, opened);
    if (app) ends.push(followTheme(app), keepAtRest(app, engine, model));
  }, (error: unknown) => { el.textContent = error instanceof Error ? error.message : String(error); });
  return () => {
    closed = true;
    for (const end of ends) end();
  };
}

function mount(el: HTMLElement, engine: Engine, opened: Opened): App | null {
  if (!isFirstBuild()) {
    el.textContent = 'This page already has the widget of another build of Trivet. Reload the page.';
    return null;
  }
  const host = document.createElement('div'), root = host.attachShadow({mode: 'open'}), sheet = new CSSStyleSheet();
  sheet.replaceSync(WIDGET_CSS);
  root.adoptedStyleSheets = [sheet];
  host.dataset['lmSuppressShortcuts'] = 'true';  // keys of the widget are no commands of JupyterLab
  host.addEventListener('keydown', event => event.stopPropagation());
  const view = new NotebookView(), app = newApp(engine, opened);
  view.app = app;
  app.display.pins = opened.sliders;
  app.state.open(opened.text, '', opened.settings, opened.case);
  root.append(view);
  el.replaceChildren(host);
  return app;
}

/// A live widget is in the place of its still, also of those that come later.
function hideStill(key: string) {
  for (const still of document.querySelectorAll(`[${STILL}="${key}"]`)) still.replaceChildren();
  const style = document.createElement('style');
  style.textContent = `[${STILL}="${key}"] { display: none; }`;
  document.head.append(style);
}

/// Shows the last states in a document without a kernel; `data-kept` is their JSON, compressed.
export async function showStills() {
  for (const still of document.querySelectorAll<HTMLElement>(`[${STILL}][data-kept]`)) {
    if (getComputedStyle(still).display === 'none') continue;
    const kept = JSON.parse(await unpacked(still.dataset['kept']!)) as Kept;
    delete still.dataset['kept'];
    const app = mount(still, new KeptEngine(kept), kept.opened);
    if (app) showAgain(app, kept.view);
    if (app) followTheme(app);
  }
}
async function unpacked(base64: string): Promise<string> {
  const bytes = Uint8Array.from(atob(base64), c => c.charCodeAt(0));
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'))).text();
}

export default {render};
