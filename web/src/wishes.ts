// SPDX-License-Identifier: BSD-3-Clause
import type {Wish} from './asker.ts';
import type {Display} from './display.ts';

/// Commands whose results are on the page.
export function wishes(display: Display, {hasSomethingToJudge, hasSteady}: {hasSomethingToJudge: boolean; hasSteady: boolean}): Wish[] {
  const {shown} = display, all: Wish[] = [{want: {command: 'scene'}}, {want: {command: 'modes'}}, {want: {command: 'curves'}}];
  if (shown.kind === 'frequency') all.push({want: {command: 'shapes'}, settings: [`analyses.shapes.at = ["${shown.omega} rad/s"]`]});
  all.push({want: {command: 'roots'}, slow: !display.damped}, {want: {command: 'check'}, slow: true});
  if (hasSomethingToJudge) all.push({want: {command: 'verdict'}, slow: true});
  if (hasSteady) all.push({want: {command: 'steady'}, slow: true});
  return all;
}
