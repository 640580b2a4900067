// SPDX-License-Identifier: BSD-3-Clause
import type {App} from './part.ts';

/// A text that is no such number changes nothing: the field shows the number that holds, and the page says so.
export function refuse(input: HTMLInputElement, {display}: App, valid: string, wanted = 'a number') {
  const isTooLarge = /^\s*[-+−]?[\d._]+e\+?\d+/i.test(input.value);
  display.set({notice: isTooLarge ? `"${input.value}" is too large a number; it stays ${valid}.`
                                    : `"${input.value}" is not ${wanted}, perhaps with a unit; it stays ${valid}.`});
  input.value = valid;
}
