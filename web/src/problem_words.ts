// SPDX-License-Identifier: BSD-3-Clause
import type {Problem} from './results.ts';

/// A message of the program with its line.
export const worded = ({line, message}: Problem) => (line ? `line ${line}: ${message}` : message);
/// A message about the file that is on the page.
export const findingOf = ({line, finding, rule, remedy, message}: Problem) =>
  `${line ? `line ${line}: ` : ''}${finding ? [finding, rule, remedy].filter(Boolean).join('; ') : message}`;
