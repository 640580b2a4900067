// SPDX-License-Identifier: BSD-3-Clause
import type {Stage} from './machine/stage.ts';
import type {App} from './part.ts';
import type {Modes, Scene} from './results.ts';
import type {Selection} from './state.ts';

/// Turns of the camera to the right and upwards [rad], and closer.
export const TURNS: Record<string, readonly [number, number, number]> = {
  ArrowLeft: [-0.15, 0, 1], ArrowRight: [0.15, 0, 1], ArrowUp: [0, 0.12, 1], ArrowDown: [0, -0.12, 1],
  '+': [0, 0, 1 / 1.15], '-': [0, 0, 1.15]};

/// The keyboard does what the mouse does with the machine.
export function machineKeys(event: KeyboardEvent, {display, asker, state}: App, stage: Stage | null) {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const turn = TURNS[event.key], count = asker.result<Modes>('modes')?.modes.length ?? 0;
  const number = display.shown.kind === 'mode' ? display.shown.number : 0;
  if (turn) stage?.turn(...turn);
  else if (event.key === 'Home') stage?.look('oblique');
  else if (event.key === ' ') display.set({playing: !display.playing});
  else if (event.key === 'n' && count) display.set({shown: {kind: 'mode', number: Math.min(number + 1, count)}});
  else if (event.key === 'p' && count) display.set({shown: {kind: 'mode', number: Math.max(number - 1, 1)}});
  else if (event.key === 's') state.select(nextPart(asker.result<Scene>('scene'), state.selection));
  else return;
  event.preventDefault();
}

function nextPart(scene: Scene | null, selection: Selection | null): Selection | null {
  if (!scene) return null;
  const all: Selection[] = [...scene.bodies.map(b => ({kind: 'body' as const, name: b.name})),
                            ...scene.elements.map(e => ({kind: 'element' as const, name: e.name}))];
  const at = all.findIndex(s => s.kind === selection?.kind && s.name === selection.name);
  return all[at + 1] ?? null;
}
