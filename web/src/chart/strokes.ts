// SPDX-License-Identifier: BSD-3-Clause
// Colours and dashes of curves: the palette of Okabe and Ito, which colour-blind readers can tell apart; lighter when dark.
import type {Theme} from '../display.ts';

const PALETTE: Record<Theme, readonly string[]> = {
  light: ['#0072B2', '#D55E00', '#009E73', '#AA4499', '#8A6D00', '#3A3A3A'],
  dark: ['#56B4E9', '#F28E4B', '#2FC7A0', '#E39AC8', '#F0E442', '#D0D0D0']};
const DASHES: readonly (readonly number[])[] = [[], [7, 4], [2, 3]];

export const strokeOf = (index: number, theme: Theme) => {
  const colours = PALETTE[theme];
  return {colour: colours[index % colours.length]!, dash: [...DASHES[Math.floor(index / colours.length) % DASHES.length]!]};
};
export const chartColours = (theme: Theme) => theme === 'dark'
  ? {back: '#14191d', axis: '#9fb0bb', grid: '#2b343b', text: '#dbe5ec', limit: '#ffb347', violated: '#ff6b57', unbinding: '#b89a6a', mode: '#53616b'}
  : {back: '#ffffff', axis: '#50616c', grid: '#e3e8ec', text: '#24323b', limit: '#9a5b00', violated: '#c61a1a', unbinding: '#a98a5c', mode: '#b9c4cc'};
