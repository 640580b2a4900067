// SPDX-License-Identifier: BSD-3-Clause
import {ofMode, ofRoot, ofShape, ofSteady, type Motion} from './motion.ts';
import type {App} from './part.ts';
import type {Modes, Roots, Scene, Shapes, Steady} from './results.ts';
import {motionsAt, wordsOf} from './steady_motions.ts';

/// The motion that the user chose, from the newest results. Null: at rest, or not computed.
export class ShownMotion {
  private from: unknown[] = [];
  private motion: Motion | null = null;

  /// The same object until a result or the choice changes.
  of({asker, display: {shown, damped}}: App): Motion | null {
    const scene = asker.result<Scene>('scene'), modes = asker.result<Modes>('modes');
    const roots = damped ? asker.result<Roots>('roots') : null, shapes = shown.kind === 'frequency' ? asker.result<Shapes>('shapes') : null;
    const steady = shown.kind === 'steady' ? asker.result<Steady>('steady') : null;
    const from = [shown, scene, modes, roots, shapes, steady];
    if (from.every((value, i) => value === this.from[i]) && this.from.length) return this.motion;
    this.from = from;
    const bodies = scene?.bodies ?? [];
    if (shown.kind === 'steady') {
      const motions = motionsAt(steady, shown.omega), motion = motions?.[shown.motion];
      this.motion = motion ? ofSteady(motion, shown.omega, `${motions.length > 1 ? `${shown.motion + 1} of ${motions.length}, ` : ''}${wordsOf(motion)}`, bodies) : null;
    } else if (shown.kind === 'frequency') this.motion = shapes && ofShape(shapes, bodies);
    else if (shown.kind === 'rest' || !modes) this.motion = null;
    else {
      const index = modes.modes.findIndex(m => m.number === shown.number), decaying = roots && ofRoot(roots, shown.number, bodies);
      this.motion = decaying ? {...decaying, words: modes.modes[index]?.name ?? ''} : ofMode(modes, index, bodies);
    }
    return this.motion;
  }
}
