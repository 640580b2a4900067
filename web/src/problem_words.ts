// SPDX-License-Identifier: BSD-3-Clause
// What the program's messages say, and of which number of the file.
import type {TextIndex} from './numbers_of_text.ts';
import type {Problem} from './results.ts';
import {pathParts, pathText} from './toml_outline.ts';

const OF_A_SETTING = '--set ';

/// Path of the setting that a message is about, or null.
export const settingOf = ({file = ''}: Problem) => (file.startsWith(OF_A_SETTING) ? pathText(pathParts(file.slice(OF_A_SETTING.length))) : null);

/// Line of the number or key in the text; 0 if it has none. That of a setting is where the text has its number.
export function lineOf(problem: Problem, text: string, index: TextIndex): number {
  const path = settingOf(problem);
  if (path === null) return problem.line ?? 0;
  const entry = index.numbers.get(path) ?? index.byPath.get(pathParts(path).join('\0'));
  return entry ? text.slice(0, entry.keyFrom).split('\n').length : 0;
}
/// A message with its line. That of a setting begins with its path, not with the words of the command line.
export function worded(problem: Problem, line = problem.line ?? 0): string {
  const {file = '', severity, message} = problem, before = `${file}: ${severity}: `;
  const words = settingOf(problem) !== null && message.startsWith(before) ? message.slice(before.length) : message;
  return line ? `line ${line}: ${words}` : words;
}
/// Place among the messages of the first error about one of these numbers; −1: there is none.
export const errorAbout = (paths: readonly string[], problems: readonly Problem[]) =>
  problems.findIndex(p => p.severity === 'error' && paths.some(path => path === settingOf(p) || path === p.subject));
/// Element of a message in the list, for fields that it describes.
export const idOf = (place: number) => `problem-${place}`;
/// A message about the file that is on the page.
export const findingOf = (p: Problem) => `${p.line ? `line ${p.line}: ` : ''}${p.finding ? `${p.finding}; ` : ''}${ruleOf(p)}`;
/// A message at its field, which names the number already.
export const ruleOf = ({rule, remedy, message}: Problem) => [rule, remedy].filter(Boolean).join('; ') || message;
