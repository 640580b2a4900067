// SPDX-License-Identifier: BSD-3-Clause
import {Color} from 'three';
import type {MountValues} from '../mount_colouring.ts';

/// From nothing to the top of a scale: lightness grows steadily, and blue to yellow is seen by every eye (cividis).
export const STEPS = [0x00306f, 0x434e6c, 0x7b7b78, 0xb8a96e, 0xfee838] as const;
/// Beyond the limit; no step of the scale is like it, also without hue.
export const BEYOND = 0xd1003c;

export function colourOf(value: number, {top, limited}: MountValues): Color {
  const share = Math.abs(value) / top;
  if (limited && share > 1) return new Color(BEYOND);
  const place = Math.min(share, 1) * (STEPS.length - 1), step = Math.min(Math.floor(place), STEPS.length - 2);
  return new Color(STEPS[step]).lerp(new Color(STEPS[step + 1]), place - step);
}
