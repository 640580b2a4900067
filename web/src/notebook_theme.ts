// SPDX-License-Identifier: BSD-3-Clause
import type {Theme} from './display.ts';
import type {App} from './part.ts';

/// Light or dark as the notebook is: JupyterLab and VS Code mark the body; others follow the system.
function themeOfNotebook(): Theme {
  const {dataset, classList} = document.body;
  if (dataset['jpThemeLight'] !== undefined) return dataset['jpThemeLight'] === 'true' ? 'light' : 'dark';
  if (classList.contains('vscode-light') || classList.contains('vscode-high-contrast-light')) return 'light';
  if (classList.contains('vscode-dark') || classList.contains('vscode-high-contrast')) return 'dark';
  return matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light';
}

/// @returns what ends it
export function followTheme({display}: App): () => void {
  const follow = () => { if (display.theme !== themeOfNotebook()) display.set({theme: themeOfNotebook()}); };
  const watcher = new MutationObserver(follow);
  watcher.observe(document.body, {attributes: true, attributeFilter: ['data-jp-theme-light', 'class']});
  follow();
  return () => watcher.disconnect();
}
