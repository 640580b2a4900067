// SPDX-License-Identifier: BSD-3-Clause
import type {LimitMoves} from './chart/limit_handles.ts';
import type {Limit} from './chart/limits.ts';
import type {PresentLimit} from './chart/picture.ts';
import {limitNumber, PresentLimits, rounded, setLimit, type LimitNumber} from './limit_number.ts';
import type {App} from './part.ts';
import {number} from './quantities.ts';
import type {Requirement, Verdict} from './results.ts';

/// Limits of the file as numbers that the chart moves. The verdict follows.
export class LimitMover implements LimitMoves {
  private readonly values = new PresentLimits();
  private known = new Map<string, {number: LimitNumber; allowed: number}>();  // by the id of the chart
  private pulled: {place: string; value: number} | null = null;  // of a number that is written only when it is dropped

  /// @param si  SI value at a height of the chart  @param changed  the limit moved, and no setting did
  constructor(private readonly app: App, private readonly si: (y: number) => number, private readonly changed: () => void) {}

  /// Those of the case on the page.
  get requirements(): readonly Requirement[] {
    return this.verdict?.requirements ?? [];
  }
  get areBinding(): boolean {
    return this.verdict?.decides !== false;
  }
  present(limits: readonly Limit[]): PresentLimit[] {
    const {asker, state, index} = this.app, old = asker.isOld('verdict'), binding = this.areBinding;
    this.known = new Map();
    return limits.map((limit, i): PresentLimit => {
      const {requirement: r} = limit, place = r.place.join('.'), found = limitNumber(r.place, state.case, state.design, index);
      if (found && this.pulled?.place === place) found.value = this.pulled.value;
      const allowed = found && this.values.allowed(r, found, !old && !this.pulled);
      if (found && allowed !== null && this.app.engine.isLive) this.known.set(`${i} ${place}`, {number: found, allowed});
      return {limit, allowed: allowed ?? r.allowed!, written: found ? `${number(found.value)} ${found.unit}`.trim() : r.requirement, movable: allowed !== null && this.app.engine.isLive, old, binding};
    });
  }

  private get verdict() {
    const {asker, state} = this.app;
    return asker.result<Verdict>('verdict')?.cases.find(c => c.case === state.case);
  }
  began = () => {};
  moved = (id: string, y: number) => {
    const at = this.known.get(id), si = this.si(y);
    if (at && si > 0) this.set(at.number, at.number.value * si / at.allowed, true);
  };
  dropped = (id: string) => {
    const at = this.known.get(id), {pulled} = this;
    this.pulled = null;
    if (at && pulled) setLimit(this.app.state, at.number, pulled.value);
    else this.app.state.dropped();
  };
  stepped = (id: string, factor: number) => {
    const at = this.known.get(id);
    if (at) this.set(at.number, at.number.value * factor, false);
  };

  private set(limit: LimitNumber, value: number, drag: boolean) {
    const next = rounded(value);
    if (!limit.path && drag) this.pulled = {place: placeOf(limit), value: next};
    setLimit(this.app.state, limit, next, drag);
    if (this.pulled) this.changed();
  }
}
const placeOf = ({entry: {path}}: LimitNumber) => (path[0] === 'cases' ? path.slice(2) : path).join('.');
