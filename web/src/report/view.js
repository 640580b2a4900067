// SPDX-License-Identifier: BSD-3-Clause
// What the reader chose to see, and which charts show it. Who shows something listens to changes.
import {frequency, largestOf, smallestOf, TURN} from './report_data.ts';

/// State chosen by the user. `ylog` is null while each chart chooses its amplitude axis. `zoom` is null or [from, to]
/// in rad/s; `hidden` contains the names of hidden curves.
/// `design` is null or [column, row] of the stored design under the point of the map.
export const view = {case: 0, ylog: null, xlog: false, hz: false, zoom: null, compare: '', hidden: new Set(), design: null};
/// The charts on the page: of the selected case, of all cases together, and of the design under the point of a map.
export const shownCharts = {ofCase: [], comparison: null, ofDesign: []};
export const allCharts = () => [...shownCharts.ofCase, ...shownCharts.ofDesign, ...(shownCharts.comparison ? [shownCharts.comparison] : [])];

export const axisFactor = () => (view.hz ? 1 / TURN : frequency?.factor ?? 1);  // from rad/s to the unit of the frequency axes
export const frequencyUnit = () => (view.hz ? 'Hz' : frequency?.unit ?? 'rad/s');

export const onCase = [];    // called when another case is shown
export const onChange = [];  // called with the names of what changed
export function change(patch) {
  Object.assign(view, 'case' in patch ? {design: null} : {}, patch);
  for (const listener of onChange) listener(Object.keys(patch));
}
/// Shows a range inside the bands of the charts; all of it means no zoom.
export function zoomTo(from, to) {
  const bands = allCharts().map(chart => chart.band);
  const least = smallestOf(bands.map(band => band[0])), most = largestOf(bands.map(band => band[1]));
  const shown = [Math.max(from, least), Math.min(to, most)];
  if (shown[1] > shown[0]) change({zoom: shown[0] <= least && shown[1] >= most ? null : shown});
}
/// Moves the shown range, in a linear or logarithmic measure, up to the ends of the band.
export function moveBy(step, to, back) {
  if (!view.zoom) return;
  const ends = largestOf(allCharts().map(chart => chart.band[1]));
  const moved = view.zoom.map(w => back(to(w) + step));
  if (moved[0] >= 0 && moved[1] <= ends) change({zoom: moved});
}
