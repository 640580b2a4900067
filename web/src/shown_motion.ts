// SPDX-License-Identifier: BSD-3-Clause
import {ofMode, ofRoot, ofShape, type Motion} from './motion.ts';
import type {App} from './part.ts';
import type {Modes, Roots, Scene, Shapes} from './results.ts';

/// The motion that the user chose, from the newest results. Null: at rest, or not computed.
export function shownMotion({asker, display}: App): Motion | null {
  const bodies = asker.result<Scene>('scene')?.bodies ?? [], {shown} = display;
  if (shown.kind === 'frequency') {
    const shapes = asker.result<Shapes>('shapes');
    return shapes ? ofShape(shapes, bodies) : null;
  }
  const modes = asker.result<Modes>('modes');
  if (shown.kind === 'rest' || !modes) return null;
  const roots = display.damped ? asker.result<Roots>('roots') : null;
  const index = modes.modes.findIndex(m => m.number === shown.number);
  const damped = roots && ofRoot(roots, shown.number, bodies);
  if (damped) return {...damped, label: `Damped mode ${shown.number}: ${modes.modes[index]?.name ?? ''}`};
  return ofMode(modes, index, bodies);
}
