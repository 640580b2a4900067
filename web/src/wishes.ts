// SPDX-License-Identifier: BSD-3-Clause
import type {Wish} from './asker.ts';
import type {Display} from './display.ts';

/// Commands whose results are on the page.
export function wishes(display: Display, {hasSomethingToJudge, hasSteady}: {hasSomethingToJudge: boolean; hasSteady: boolean}): Wish[] {
  const {shown} = display, all: Wish[] = [{want: {command: 'scene'}}, {want: {command: 'modes'}}, ...curves(display)];
  if (shown.kind === 'frequency') all.push({want: {command: 'shapes'}, settings: [`analyses.shapes.at = ["${shown.omega} rad/s"]`]});
  all.push({want: {command: 'roots'}, slow: !display.damped}, {want: {command: 'check'}, slow: true});
  if (hasSomethingToJudge) all.push({want: {command: 'verdict'}, slow: true});
  if (hasSteady) all.push({want: {command: 'steady'}, slow: true});
  return all;
}
/// The drawn curves follow a slider as a draft; all curves with exact peaks follow when it rests.
function curves({drawn}: Display): Wish[] {
  const finished = {want: {command: 'curves'}};
  if (!drawn.length) return [finished];  // which ones are drawn is not yet known
  return [{want: {command: 'curves', keys: {draft: true, of: drawn}}, as: 'draft'}, {...finished, exact: true}];
}
