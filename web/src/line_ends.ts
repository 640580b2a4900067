// SPDX-License-Identifier: BSD-3-Clause
// The editor ends every line by "\n". Its edits are made in the text of the file, whose line ends stay.

/// Replaces characters `from` … `to` by `insert`; places are those of the editor, before any of the edits.
export interface Edit {
  from: number;
  to: number;
  insert: string;
}
const LINE_END = /\r\n?|\n/g;

/// The text as the editor has it.
export const withPlainEnds = (text: string) => text.replace(LINE_END, '\n');

/// The text of the file with edits, which are in order. New lines end as the line in which they begin, the last one as that before it.
export function edited(text: string, edits: readonly Edit[]): string {
  const ends = [...text.matchAll(LINE_END)].map(({index, 0: end}) => ({index, end}));
  let line = 0, shorter = 0;  // line ends before a place, and by how much the editor's are shorter
  const inFile = (place: number) => {
    for (; line < ends.length && ends[line]!.index - shorter < place; line++) shorter += ends[line]!.end.length - 1;
    return place + shorter;
  };
  let result = '', done = 0;
  for (const {from, to, insert} of edits) {
    const begin = inFile(from), end = (ends[line] ?? ends[line - 1])?.end ?? '\n';
    result = joined(joined(result, text.slice(done, begin)), insert.replaceAll('\n', end));
    done = inFile(to);
  }
  return joined(result, text.slice(done));
}
/// Two line ends that meet stay two.
const joined = (first: string, second: string) => first + (first.endsWith('\r') && second.startsWith('\n') ? '\r' : '') + second;
