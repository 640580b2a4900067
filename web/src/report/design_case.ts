// SPDX-License-Identifier: BSD-3-Clause
// A stored design of a map as a case of the report.
import {same} from './case_curves.ts';
import type {Sample} from './adaptive_sampling.ts';
import {designAt, maximumBetween, resonancesOf, riseOf, unpacked, type Fractions} from './pole_fractions.ts';
import {factorOf, largestOf, type Case, type Limit, type Named} from './report_data.ts';

/// As the program stores the designs of a map (map_point_json): long lists in base64.
interface StoredDesigns {
  margins: string;
  governing: string;
  limits: Limit[];
  curves?: StoredCurves;
}
interface StoredCurves extends Omit<Fractions, 'denominators' | 'numerators'> {
  results: Named[];
  band: readonly [number, number];
  rounded: boolean;  // numerators have 32 bits
  drawn: string;     // has the design curves?
  denominators: string;
  numerators: string;
}

/// The stored designs with their numbers in arrays.
export function readDesigns(map: StoredDesigns) {
  const {curves} = map;
  return {...map, margins: unpacked(map.margins, Float32Array), governing: unpacked(map.governing, Uint8Array),
          curves: curves && {...curves, drawn: unpacked(curves.drawn, Uint8Array), denominators: unpacked(curves.denominators, Float64Array),
                             numerators: unpacked(curves.numerators, curves.rounded ? Float32Array : Float64Array)}};
}
type Designs = ReturnType<typeof readDesigns>;

/// A case of the page in which the response is that of a design. `limits` are those of the map.
export function caseOfDesign(of: Case, {curves, limits}: Designs & {curves: NonNullable<Designs['curves']>}, design: number): Case {
  const visible = 1e-3, {band} = curves;
  const results = curves.results.map(r => ({...r, extrema: [], first_phase: null}));
  const at = (w: number) => designAt(curves, design, w), sizeOf = (v: Float64Array, c: number) => Math.hypot(v[2 * c]!, v[2 * c + 1]!);
  const made: Case = {...of, peaks: [], modes: [], limits};
  /// Adds the maxima to the drawn points, and to the peaks of the case.
  const completed = (points: Sample[]) => {
    const more: Sample[] = [];
    results.forEach((r, c) => {
      if ((of.vanishing ?? []).some(v => same(v, r))) return;
      const sizes = points.map(({v}) => sizeOf(v, c)), top = largestOf(sizes);
      for (let i = 1; i + 1 < sizes.length; i++) {
        const here = sizes[i]!;
        if (!(here > sizes[i - 1]! && here >= sizes[i + 1]! && here > 1e-6 * top) || riseOf(sizes, i) < visible) continue;
        const size = (w: number) => sizeOf(at(w), c);
        const w = maximumBetween(size, points[i - 1]!.w, points[i + 1]!.w);
        more.push({w, v: at(w)});
        made.peaks.push({...r, angular_frequency: w, amplitude: size(w) * factorOf(r.unit), unbounded: false, ratio_to_static: null});
      }
    });
    return [...points, ...more].sort((a, b) => a.w - b.w).filter(({w}, i, all) => i === 0 || w > all[i - 1]!.w);
  };
  made.response = {results, band, at, completed, undefined_at: [], continuous_phase: false,
                   pieces: [{band, nodes: resonancesOf(curves, design, band)}]};
  return made;
}
