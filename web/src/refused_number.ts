// SPDX-License-Identifier: BSD-3-Clause
import type {App} from './part.ts';

/// A text that is no such number changes nothing: the field shows the number that holds, and the page says so.
export function refuse(input: HTMLInputElement, {display}: App, valid: string, wanted = 'a number') {
  const isTooLarge = Math.abs(Number(input.value.trim().match(/^[-+]?[\d.]+e\+?\d+/i)?.[0])) === Infinity;
  display.set({notice: isTooLarge ? `"${input.value}" is too large a number; it stays ${valid}.`
                                    : `"${input.value}" is not ${wanted}, perhaps with a unit; it stays ${valid}.`});
  input.value = valid;
}
