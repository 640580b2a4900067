// SPDX-License-Identifier: BSD-3-Clause
import type {LimitMoves} from './chart/limit_handles.ts';
import type {PresentLine} from './chart/limit_lines.ts';
import type {Limit} from './chart/limits.ts';
import type {PresentLimit} from './chart/picture.ts';
import {limitNumber, PresentLimits, rounded, setLimit, type LimitNumber} from './limit_number.ts';
import {levelsOf, scaleLevels, type Level} from './limit_line.ts';
import type {App} from './part.ts';
import {number} from './quantities.ts';
import type {Curves, Requirement, Verdict} from './results.ts';

/// Limits of the file as numbers that the chart moves. The verdict follows.
export class LimitMover implements LimitMoves {
  private readonly values = new PresentLimits();
  private known = new Map<string, {number: LimitNumber; allowed: number}>();  // by the id of the chart
  private pulled: {place: string; value: number} | null = null;  // of a number that is written only when it is dropped

  private lines = new Map<string, {levels: Level[]; pulled: number}>();  // over frequency, by the id of the chart
  private readonly judgedLevels = new Map<string, number>();  // the first level of the file to which the curves belong
  private pulledLine: {id: string; factor: number} | null = null;
  private heights = new Map<string, number>();  // where lines are seized, by their id

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

  /// Limits over frequency of the curves, at their present levels.
  presentLines({lines = []}: Curves): PresentLine[] {
    const {asker, state, index, engine} = this.app, old = asker.isOld('curves');
    this.lines = new Map();
    return lines.map((line, i): PresentLine => {
      const id = `line ${i} ${line.name}`, levels = levelsOf(line.name, state.case, index), key = `${state.case} ${id}`, first = levels?.[0]!.value ?? 1;
      if (!old || !this.judgedLevels.has(key)) this.judgedLevels.set(key, first);
      const pulled = this.pulledLine?.id === id ? this.pulledLine.factor : 1, movable = levels !== null && engine.isLive;
      if (movable) this.lines.set(id, {levels, pulled});
      return {id, line, factor: pulled * first / this.judgedLevels.get(key)!, movable, old: old || pulled !== 1, binding: this.areBinding};
    });
  }
  /// Where lines are seized, so that a height becomes a factor.
  placed(handles: readonly {id: string; y: number}[]) { this.heights = new Map(handles.map(h => [h.id, this.si(h.y)])); }

  private get verdict() {
    const {asker, state} = this.app;
    return asker.result<Verdict>('verdict')?.cases.find(c => c.case === state.case);
  }
  began = () => {};
  moved = (id: string, y: number) => {
    const at = this.known.get(id), si = this.si(y), line = this.lines.get(id), height = this.heights.get(id);
    if (line && height && si > 0) {
      this.pulledLine = {id, factor: line.pulled * si / height};
      this.changed();
    }
    if (at && si > 0) this.set(at.number, at.number.value * si / at.allowed, true);
  };
  dropped = (id: string) => {
    const at = this.known.get(id), {pulled, pulledLine} = this, line = this.lines.get(id);
    this.pulled = this.pulledLine = null;
    if (line && pulledLine) return scaleLevels(this.app.state, line.levels, pulledLine.factor);
    if (at && pulled) setLimit(this.app.state, at.number, pulled.value);
    else this.app.state.dropped();
  };
  stepped = (id: string, factor: number) => {
    const at = this.known.get(id);
    if (at) this.set(at.number, at.number.value * factor, false);
    const line = this.lines.get(id);
    if (line) scaleLevels(this.app.state, line.levels, factor);
  };

  private set(limit: LimitNumber, value: number, drag: boolean) {
    const next = rounded(value);
    if (!limit.path && drag) this.pulled = {place: placeOf(limit), value: next};
    setLimit(this.app.state, limit, next, drag);
    if (this.pulled) this.changed();
  }
}
const placeOf = ({entry: {path}}: LimitNumber) => (path[0] === 'cases' ? path.slice(2) : path).join('.');
