// SPDX-License-Identifier: BSD-3-Clause
// Lines in which two texts differ, for people who choose between them.

export interface DifferentLine {
  side: 'first' | 'second';
  number: number;  // from 1
  text: string;
}
const LARGEST = 4e6;  // pairs of lines that are compared; a larger middle part differs as a whole

/// Lines of only one of the texts, in their order: of a changed place first those of the first text.
export function differentLines(first: string, second: string): DifferentLine[] {
  const a = first.split('\n'), b = second.split('\n');
  let start = 0, ends = 0;
  while (start < Math.min(a.length, b.length) && a[start] === b[start]) start++;
  while (ends < Math.min(a.length, b.length) - start && a[a.length - 1 - ends] === b[b.length - 1 - ends]) ends++;
  const rows = a.length - start - ends, columns = b.length - start - ends, result: DifferentLine[] = [];
  const of = (side: DifferentLine['side'], i: number) => result.push({side, number: start + i + 1, text: (side === 'first' ? a : b)[start + i]!});
  const common = rows * columns <= LARGEST ? longestCommon(a.slice(start, start + rows), b.slice(start, start + columns)) : null;
  let i = 0, j = 0;
  while (i < rows || j < columns) {
    if (common && i < rows && j < columns && a[start + i] === b[start + j]) [i, j] = [i + 1, j + 1];
    else if (i < rows && (j >= columns || !common || common(i + 1, j) >= common(i, j + 1))) of('first', i++);
    else of('second', j++);
  }
  return result;
}

/// Number of lines that the rests of both from i and j on have in common, in order.
function longestCommon(a: readonly string[], b: readonly string[]): (i: number, j: number) => number {
  const width = b.length + 1, table = new Uint32Array((a.length + 1) * width);
  for (let i = a.length - 1; i >= 0; i--)
    for (let j = b.length - 1; j >= 0; j--)
      table[i * width + j] = a[i] === b[j] ? table[(i + 1) * width + j + 1]! + 1 : Math.max(table[(i + 1) * width + j]!, table[i * width + j + 1]!);
  return (i, j) => table[i * width + j]!;
}
