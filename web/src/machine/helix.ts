// SPDX-License-Identifier: BSD-3-Clause
import {Curve, Vector3} from 'three';
import type {Coil} from '../results.ts';

type Winding = Pick<Coil, 'mean_diameter' | 'turns' | 'dead_turns' | 'left_handed' | 'start_angle'>;

/// Centre line of the wire of a coil spring from z = 0 to z = length; dead turns at its ends have hardly any pitch.
export class Helix extends Curve<Vector3> {
  readonly turns: number;

  constructor(private readonly coil: Winding, private readonly length: number) {
    super();
    this.turns = coil.turns + coil.dead_turns[0] + coil.dead_turns[1];
  }
  override getPoint(part: number, target = new Vector3()): Vector3 {
    const {mean_diameter, turns, dead_turns: [first], left_handed, start_angle} = this.coil, turn = part * this.turns;
    const angle = start_angle + (left_handed ? -1 : 1) * 2 * Math.PI * turn;
    const active = Math.min(Math.max((turn - first) / turns, 0), 1);
    return target.set(mean_diameter / 2 * Math.cos(angle), mean_diameter / 2 * Math.sin(angle), this.length * active);
  }
}
