// SPDX-License-Identifier: BSD-3-Clause
import type {Asker} from './asker.ts';
import type {Curves} from './results.ts';

/// The curves to draw: those with exact peaks if they are of the present state, else the draft, which comes with every move of a slider.
/// A draft has only the results that are drawn, no limits, and does not know which results vanish: before the first finished curves none is
/// drawn.
export class DrawnCurves {
  private from: readonly (Curves | null)[] = [];
  private curves: Curves | null = null;

  /// The same object until a result changes.
  of(asker: Asker): Curves | null {
    const finished = asker.result<Curves>('curves');
    const draft = asker.revisionOf('draft') > asker.revisionOf('curves') ? asker.result<Curves>('draft') : null;
    if (this.from.length && finished === this.from[0] && draft === this.from[1]) return this.curves;
    this.from = [finished, draft];
    this.curves = draft && finished && isOfSameQuantity(draft, finished) ? completed(draft, finished) : finished;
    return this.curves;
  }
}

/// Not if one has just chosen velocities instead of displacements.
const isOfSameQuantity = (draft: Curves, finished: Curves) =>
  draft.results.every(({name, unit}) => finished.results.some(r => r.name === name && r.unit === unit));

/// A draft with the results, in their order, and the limits of finished curves. Results that it does not have are empty.
function completed(draft: Curves, finished: Curves): Curves {
  const places = finished.results.map(r => draft.results.findIndex(d => d.name === r.name)), count = draft.results.length;
  const models = draft.models.map(model => ({...model, pieces: model.pieces.map(piece =>
    ({...piece, values: model.delays.flatMap((_, d) => places.map(p => (p < 0 ? [] : piece.values[d * count + p]!)))}))}));
  const results = finished.results.map(({extrema: _, ...result}) => result);
  return {...draft, draft: true, results, models, limits: finished.limits, lines: finished.lines ?? [], vanishing: finished.vanishing ?? []};
}
