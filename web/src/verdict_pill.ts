// SPDX-License-Identifier: BSD-3-Clause
import {html} from 'lit';
import {judgement} from './judgement.ts';
import type {App} from './part.ts';

const SIGNS = {met: '✓', violated: '✗', unjudged: '?', unbinding: '(✗)', none: '○', error: '!', unknown: '…'};

/// The verdict on the design in one line.
export function verdictPill(app: App) {
  const said = judgement(app);
  return html`<span class="pill ${said.state}" role="status">${SIGNS[said.state]} ${said.words}${said.old ? ' …' : ''}</span>`;
}
