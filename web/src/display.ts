// SPDX-License-Identifier: BSD-3-Clause
// How the results are shown: nothing here changes a result.
import type {Ghost} from './machine/ghosts.ts';
import type {Colouring} from './mount_colouring.ts';
import type {FrequencyUnit} from './quantities.ts';

/// The motion that the machine makes on the page.
/// `steady`: one of the steady motions of a nonlinear machine at a frequency, by its place in the list of the program.
export type Shown = {kind: 'mode'; number: number} | {kind: 'frequency'; omega: number} | {kind: 'steady'; omega: number; motion: number} | {kind: 'rest'};
export type Theme = 'light' | 'dark';
export type Table = 'modes' | 'requirements' | 'mounts' | 'peaks' | 'map';

export class Display {
  theme: Theme = matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light';
  frequencyUnit: FrequencyUnit = 'Hz';
  logarithmicFrequency = false;
  decibel = false;
  logarithmicAmplitude = true;
  shown: Shown = {kind: 'mode', number: 1};
  damped = false;
  playing = !matchMedia('(prefers-reduced-motion: reduce)').matches;
  share = 0.04;  // largest drawn displacement over the size of the machine
  speed = 0.5;  // drawn periods a second
  phase = 0;  // [rad]
  traces = false;
  ghost: Ghost = 'edges';  // what the moving machine is compared with
  colouring: Colouring = 'none';  // of the mounts
  cursor: number | null = null;  // ω [rad/s] of the linked cursor
  drawn: readonly string[] = [];  // names of the results that are drawn as curves; empty: not yet known
  pins: readonly string[] = [];  // numbers of the tree that are sliders, too
  leftTab: 'sliders' | 'model' | 'text' = 'sliders';
  compared: ReadonlyMap<string, boolean> = new Map();  // what is drawn beside the curves, see comparisons.ts
  quantity = '';  // of the motions in the curves; empty: that of the file
  table: Table | null = null;  // shown below the curves; null: the one that suits the file
  notice = '';  // one sentence for a few seconds
  listed = '';  // a notice with more in the list of messages
  private readonly listeners = new Set<() => void>();

  set(values: Partial<Omit<Display, 'set' | 'subscribe'>>) {
    Object.assign(this, values);
    for (const listener of this.listeners) listener();
  }
  subscribe(listener: () => void) {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }
}
