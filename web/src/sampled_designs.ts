// SPDX-License-Identifier: BSD-3-Clause
// Machines within the tolerances of the file: few of them follow a slider, all of the file are judged when it rests.
import type {Wish} from './asker.ts';
import {hasSomethingToJudge} from './judgement.ts';
import {quantityOf} from './numbers_of_text.ts';
import type {App} from './part.ts';
import type {Sample, SampledBand} from './results.ts';

export const FEW = 1024;  // designs while a slider moves
export const MOST = 100_000;  // designs at rest, as in a report: some seconds
const BY_DEFAULT = 100_000, NAME_OF_FEW = 'few designs';

/// Designs that the file wants.
const wantedDesigns = ({state: {design, index}}: App) => quantityOf('analyses.sample.designs', design, index)?.value ?? BY_DEFAULT;
/// What `trivet sample` is asked with --set. A search of worst designs takes longer than a hand waits.
const settings = (designs: number) => [`analyses.sample.designs = ${designs}`, 'analyses.sample.worst_case = false'];

export function sampleWishes(app: App): Wish[] {
  const {state, index} = app, has = [...index.byPath.keys()].some(path => path.startsWith('tolerances\0'));
  if (!state.design.text || !has || !hasSomethingToJudge(app)) return [];
  const wanted = wantedDesigns(app), few: Wish = {want: {command: 'sample'}, as: NAME_OF_FEW, settings: settings(Math.min(FEW, wanted))};
  return wanted <= FEW || !isQuick(app) ? [few] : [few, {want: {command: 'sample'}, slow: true, settings: settings(Math.min(MOST, wanted))}];
}
/// Kernels judge the designs; models that are assembled one by one take thousand times as long. Not known before the first ones.
const isQuick = ({sampler}: App) => sampler?.result<Sample>(NAME_OF_FEW)?.cases.every(c => c.no_kernels === '') ?? true;

export interface Sampled {
  found: Sample;
  old: boolean;  // the designs that are wanted are not judged yet
  wanted: number;  // designs of the file
}
/// The newest sample of the machine on the page. Null: none is wanted, or it is not there.
export function sampledDesigns(app: App): Sampled | null {
  const {sampler} = app, wishes = sampler ? sampleWishes(app) : [];
  if (!sampler || !wishes.length || sampler.hasErrors) return null;
  const name = sampler.revisionOf(NAME_OF_FEW) > sampler.revisionOf('sample') ? NAME_OF_FEW : 'sample', found = sampler.result<Sample>(name);
  return found && {found, old: wishes.some(wish => sampler.isOld(wish.as ?? 'sample')), wanted: wantedDesigns(app)};
}
/// Why there is none of the numbers on the page; empty: it is being computed, or none is wanted.
export function sampleFailure(app: App): string {
  const {sampler} = app;
  if (!sampler || sampler.hasErrors) return '';
  return sampleWishes(app).map(wish => wish.as ?? 'sample').filter(name => !sampler.isOld(name)).map(name => sampler.failure(name)).find(Boolean) ?? '';
}
/// Bands of amplitudes in the case on the page.
export const sampledBands = ({found}: Sampled, name: string): readonly SampledBand[] => found.bands?.find(one => one.case === name)?.results ?? NONE;
const NONE: readonly SampledBand[] = [];
