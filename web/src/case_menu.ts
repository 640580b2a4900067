// SPDX-License-Identifier: BSD-3-Clause
import {html, nothing} from 'lit';
import type {App} from './part.ts';

/// The choice of the case on the page, if there are several.
export function caseMenu({state, cases}: App) {
  return cases.length > 1 ? html`<select aria-label="Case" @change=${(e: Event) => state.chooseCase((e.target as HTMLSelectElement).value)}>
      ${cases.map(c => html`<option value=${c} .selected=${c === state.case}>${c || 'base model'}</option>`)}</select>` : nothing;
}
