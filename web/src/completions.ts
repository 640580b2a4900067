// SPDX-License-Identifier: BSD-3-Clause
import type {Schema} from './schema.ts';
import {outline, pathParts} from './toml_outline.ts';

export interface Completion {
  name: string;
  description: string;
  apply: string;
}
export interface Completions {
  from: number;
  options: Completion[];
}

/// What may stand at a place of the text: keys of the table around it, or the texts that a key accepts.
export function completionsAt(text: string, at: number, schema: Schema): Completions | null {
  const lineStart = text.lastIndexOf('\n', at - 1) + 1, line = text.slice(lineStart, at);
  if (/^[^"']*#/.test(line)) return null;
  const word = line.match(/[\w-]*$/)![0], from = at - word.length, before = line.slice(0, line.length - word.length);
  const header = before.match(/^\s*\[([^\]]*)$/);
  if (header) return keysOf(schema, pathParts(header[1]!.replace(/\.$/, '')), from, '');
  const table = tableAround(text, lineStart), value = before.match(/([\w."' -]+?)\s*=\s*(")?$/);
  if (value) {
    const options = schema.choices([...table, ...inlineKeys(before.slice(0, value.index)), ...pathParts(value[1]!)]);
    const quote = value[2] ? '' : '"';
    return options.length ? {from, options: options.map(name => ({name, description: '', apply: `${quote}${name}${quote || '"'}`}))} : null;
  }
  const dotted = before.match(/([\w."'-]+)\.$/), above = dotted ? pathParts(dotted[1]!) : [];
  if (!/^\s*$|[{,]\s*$|\.$/.test(before)) return null;
  return keysOf(schema, [...table, ...inlineKeys(before), ...above], from, ' = ');
}

function keysOf(schema: Schema, path: readonly string[], from: number, after: string): Completions | null {
  const options = schema.keys(path).map(({name, description}) => ({name, description, apply: name + after}));
  return options.length ? {from, options} : null;
}
/// Path of the table that a line is in.
function tableAround(text: string, at: number): readonly string[] {
  return outline(text.slice(0, at)).findLast(e => e.kind === 'table' && e.keyFrom < at && /^\s*\[/.test(text.slice(e.keyFrom)))?.path ?? [];
}
/// Keys of the inline tables that are open at the end of a line: damping = {… → damping.
function inlineKeys(line: string): string[] {
  const open: string[][] = [];
  for (const part of line.matchAll(/([\w."'-]+)\s*=\s*\{|\}|\{/g)) {
    if (part[0] === '}') open.pop();
    else open.push(part[1] ? pathParts(part[1]) : []);
  }
  return open.flat();
}
