// SPDX-License-Identifier: BSD-3-Clause
// Which steady motions of a nonlinear machine one can choose.
import type {Asker} from './asker.ts';
import {stabilityWords} from './chart/steady_readings.ts';
import type {Display} from './display.ts';
import {frequency} from './quantities.ts';
import type {Steady, SteadyMotion} from './results.ts';

const SAME = 1e-9;  // of a frequency that the program reports again

/// Frequencies at which the program reports all harmonics: within the band, over frequency.
export function isInBand(steady: Steady, omega: number): boolean {
  if (steady.over !== 'frequency') return false;
  const all = steady.points.map(p => p.angular_frequency);
  return omega >= Math.min(...all) && omega <= Math.max(...all);
}
/// All motions that are known at a frequency. Null: not computed yet.
export function motionsAt(steady: Steady | null, omega: number): SteadyMotion[] | null {
  return steady?.at?.find(a => Math.abs(a.angular_frequency - omega) <= SAME * omega)?.motions ?? null;
}
export function wordsOf({stable, periods}: SteadyMotion): string {
  const words = stabilityWords({stable});
  return periods > 1 ? `${words}, ${periods} periods` : words;
}
/// The frequency of the stable motion in which the first result is largest: where one begins.
export function largestAt(steady: Steady): number | null {
  const size = (p: Steady['points'][number]) => (p.results[0] ? p.results[0].largest - p.results[0].smallest : 0);
  const stable = steady.over === 'frequency' ? steady.points.filter(p => p.stable) : [];
  return stable.length ? stable.reduce((a, b) => (size(b) > size(a) ? b : a)).angular_frequency : null;
}

/// Why there is no such motion.
export function missingSteady(asker: Asker, omega: number): string {
  if (motionsAt(asker.result<Steady>('steady'), omega)) return 'no such steady motion is known here';
  return asker.failure('steady') || 'steady motion: computing …';
}

export interface Choice {
  omega: number;
  motion: number;
  words: string;
}
/// Those at the frequency that is shown, or the first one at the largest response.
export function steadyChoices(steady: Steady | null, {shown, frequencyUnit}: Pick<Display, 'shown' | 'frequencyUnit'>): Choice[] {
  if (!steady) return [];
  const omega = 'omega' in shown && isInBand(steady, shown.omega) ? shown.omega : largestAt(steady);
  if (omega === null) return [];
  const at = frequency(omega, frequencyUnit), motions = motionsAt(steady, omega);
  if (!motions) return [{omega, motion: 0, words: `steady motion at ${at}`}];
  return motions.map((m, motion) => ({omega, motion, words: `steady motion${motions.length > 1 ? ` ${motion + 1}` : ''} at ${at}, ${wordsOf(m)}`}));
}
