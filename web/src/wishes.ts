// SPDX-License-Identifier: BSD-3-Clause
import {draftOf, type Wish} from './asker.ts';
import type {Question} from './beside.ts';
import {comparedQuestions} from './comparisons.ts';
import type {Display} from './display.ts';
import type {App} from './part.ts';
import {pathsOfParameter} from './slider_list.ts';
import {pathParts} from './toml_outline.ts';
import {tableOnPage} from './result_tables.ts';

/// Commands whose results are on the page.
export function wishes(display: Display, {hasSomethingToJudge, hasSteady, bodies}: {hasSomethingToJudge: boolean; hasSteady: boolean; bodies: number}): Wish[] {
  const {shown} = display, all: Wish[] = [{want: {command: 'scene'}}, ...modes(display, bodies), ...curves(display)];
  if (shown.kind === 'frequency') all.push({want: {command: 'shapes'}, settings: [`analyses.shapes.at = ["${shown.omega} rad/s"]`]});
  all.push({want: {command: 'roots'}, slow: !display.damped}, {want: {command: 'check'}, slow: true});
  if (hasSomethingToJudge) all.push({want: {command: 'verdict'}, slow: true});
  if (hasSteady) all.push({want: {command: 'steady', ...(shown.kind === 'steady' ? {keys: {at: `${shown.omega} rad/s`}} : {})}, slow: true});
  return all;
}
/// All modes, but of several bodies only the shape that moves follows a slider; the others, which are long, follow the exact peaks when it rests.
function modes({shown}: Display, bodies: number): Wish[] {
  const finished = {want: {command: 'modes'}};
  if (bodies < 2) return [finished];
  return [{want: {command: 'modes', keys: {'shapes-of': shown.kind === 'mode' ? shown.number : 1}}, as: draftOf('modes')}, {...finished, after: true}];
}
/// The drawn curves follow a slider as a draft; all curves with exact peaks follow when it rests.
function curves({drawn, quantity}: Display): Wish[] {
  const keys = quantity ? {quantity} : {}, finished = {want: {command: 'curves', keys}};
  if (!drawn.length) return [finished];  // which ones are drawn is not yet known
  return [{want: {command: 'curves', keys: {...keys, draft: true, of: drawn}}, as: 'draft'}, {...finished, exact: true}];
}

const PATIENCE = 1000;  // ms for a map that nobody asked for

/// Results beside those of the state: what is compared, and the map while it is shown, which does not depend on the numbers along
/// its axes.
export function questionsBeside(app: App): Question[] {
  if (!app.state.design.text) return [];
  return [...comparedQuestions(app), ...tableOnPage(app) === 'map' ? [mapQuestion(app)] : []];
}
function mapQuestion(app: App): Question {
  const {change} = app.state, moved = mapPaths(app), patience = app.engine.oneAtATime ? 0 : PATIENCE;
  const settings = change.settings.filter(s => !moved.has(s.slice(0, s.indexOf(' = '))));
  return {key: 'map', change: {...change, settings}, want: {command: 'map'}, patience};
}
/// Paths that the axes of the map move.
function mapPaths({index}: App): Set<string> {
  const text = (path: string[]) => index.byPath.get(path.join('\0'))?.raw.replace(/^["']|["']$/g, '');
  const axes = ['x', 'y'].map(axis => text(['analyses', 'map', axis, 'parameter'])).filter(p => p !== undefined);
  return new Set(axes.flatMap(name => (pathParts(name).length > 1 ? [name] : pathsOfParameter(name, index).map(p => p.path))));
}
