// SPDX-License-Identifier: BSD-3-Clause
import {html} from 'lit';

/// Is on what is drawn of a state of the file before it had errors.
export const outdatedNote = html`<p class="outdated-note">of the last state without errors</p>`;
