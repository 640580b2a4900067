// SPDX-License-Identifier: BSD-3-Clause
import {html, nothing, svg} from 'lit';
import {BEYOND, STEPS} from './machine/colour_scale.ts';
import {missingValues, type Colouring, type MountValues} from './mount_colouring.ts';

const css = (colour: number) => `#${colour.toString(16).padStart(6, '0')}`;

/// The scale of the mounts' colours, with the mount that has the largest value.
export function colourLegend(colouring: Colouring, shown: MountValues | null, isOld: boolean, missing: string) {
  if (colouring === 'none') return nothing;
  if (!shown) return html`<div class="legend">${missing || missingValues(colouring)}</div>`;
  const {title, values, words, top, limited} = shown, largest = [...values].reduce((a, b) => (Math.abs(b[1]) > Math.abs(a[1]) ? b : a));
  return html`<div class="legend" role="img" aria-label="Colours of mounts: ${title}, from 0 to ${words(top)}; largest: ${largest[0]}, ${words(largest[1])}">
    <b>${title}${isOld ? html` <span class="old">…</span>` : nothing}</b>
    <svg viewBox="0 0 150 10" aria-hidden="true">
      <defs><linearGradient id="mount-colours">${STEPS.map((colour, i) => svg`<stop offset=${i / (STEPS.length - 1)} stop-color=${css(colour)}></stop>`)}</linearGradient></defs>
      <rect width=${limited ? 128 : 150} height="10" fill="url(#mount-colours)"></rect>
      ${limited ? svg`<rect x="134" width="16" height="10" fill=${css(BEYOND)}></rect>` : nothing}
    </svg>
    <span class=${limited ? 'ticks limited' : 'ticks'}><span>0</span><span>${words(top)}</span>${limited ? html`<span>over</span>` : nothing}</span>
    <span>most: ${largest[0]}, ${words(largest[1])}</span></div>`;
}
