// SPDX-License-Identifier: BSD-3-Clause
// Where the keys and values of a project file are in its text: for the tree, for completion and for the sliders. It skips
// what it does not understand; the program's own reader judges the file.

export interface Entry {
  path: readonly string[];
  from: number;  // of the value in the text
  to: number;
  keyFrom: number;
  kind: 'number' | 'text' | 'other' | 'array' | 'table';
  raw: string;
  children: Entry[];
}

/// Entries of the file in its order; a header [a.b] is an entry of kind 'table' with its keys as children.
export function outline(text: string): Entry[] {
  return new Reader(text).file();
}
export function* allEntries(entries: readonly Entry[]): Generator<Entry> {
  for (const entry of entries) {
    yield entry;
    yield* allEntries(entry.children);
  }
}
/// A path as the program writes it: elements."front left".at.y.
export const pathText = (path: readonly string[]) =>
  path.map(part => (/^[\w-]+$/.test(part) ? part : `"${part.replace(/["\\]/g, '\\$&')}"`)).join('.');
export function pathParts(path: string): string[] {
  return new Reader(path).key();
}

class Reader {
  private at = 0;
  constructor(private readonly text: string) {}

  file(): Entry[] {
    const top: Entry[] = [];
    let table: Entry | null = null;
    while (this.at < this.text.length) {
      this.skipBlank();
      const start = this.at;
      if (this.text[this.at] === '[') {
        table = this.header(start);
        top.push(table);
      } else if (this.at < this.text.length) {
        const entry = this.pair(table?.path ?? []);
        if (entry) (table ? table.children : top).push(entry);
        if (table) table.to = this.at;
      }
      this.skipLine();
      if (this.at === start) this.at++;
    }
    return top;
  }
  /// a."b c".d
  key(): string[] {
    const parts: string[] = [];
    for (;;) {
      this.skipSpaces();
      const c = this.text[this.at];
      if (c === '"' || c === "'") parts.push(this.quoted());
      else {
        const bare = this.match(/[\w\-]+/y);
        if (!bare) break;
        parts.push(bare);
      }
      this.skipSpaces();
      if (this.text[this.at] !== '.') break;
      this.at++;
    }
    return parts;
  }

  private header(start: number): Entry {
    this.match(/\[+/y);
    const path = this.key();
    this.match(/\s*\]+/y);
    return {path, from: this.at, to: this.at, keyFrom: start, kind: 'table', raw: '', children: []};
  }
  private pair(above: readonly string[]): Entry | null {
    const keyFrom = this.at, key = this.key();
    this.skipSpaces();
    if (!key.length || this.text[this.at] !== '=') return null;
    this.at++;
    this.skipSpaces();
    return this.value([...above, ...key], keyFrom);
  }
  private value(path: readonly string[], keyFrom: number): Entry {
    const from = this.at, c = this.text[from];
    let kind: Entry['kind'] = 'other', children: Entry[] = [];
    if (c === '[') [kind, children] = ['array', this.array(path)];
    else if (c === '{') [kind, children] = ['table', this.inlineTable(path)];
    else if (c === '"' || c === "'") {
      const content = this.quoted();
      kind = /^\s*[-+]?(\d|\.\d)/.test(content) && !/^\d+[\w-]*:/.test(content) ? 'number' : 'text';
    } else {
      const bare = this.match(/[^\s,\]}#]+/y) ?? '';
      kind = /^[-+]?(\d|\.\d|inf|nan)/.test(bare) ? 'number' : 'other';
    }
    return {path, from, to: this.at, keyFrom, kind, raw: this.text.slice(from, this.at), children};
  }
  private array(path: readonly string[]): Entry[] {
    const items: Entry[] = [];
    this.at++;
    for (;;) {
      this.skipBlank();
      if (this.at >= this.text.length || this.text[this.at] === ']') break;
      const before = this.at;
      items.push(this.value([...path, String(items.length)], this.at));
      this.skipBlank();
      if (this.text[this.at] === ',') this.at++;
      if (this.at === before) break;
    }
    this.at++;
    return items;
  }
  private inlineTable(path: readonly string[]): Entry[] {
    const items: Entry[] = [];
    this.at++;
    for (;;) {
      this.skipBlank();
      if (this.at >= this.text.length || this.text[this.at] === '}') break;
      const item = this.pair(path);
      if (!item) break;
      items.push(item);
      this.skipBlank();
      if (this.text[this.at] === ',') this.at++;
    }
    this.at++;
    return items;
  }
  private quoted(): string {
    const quote = this.text[this.at]!, three = quote.repeat(3);
    if (this.text.startsWith(three, this.at)) {
      const end = this.text.indexOf(three, this.at + 3), from = this.at + 3;
      this.at = end < 0 ? this.text.length : end + 3;
      return this.text.slice(from, end < 0 ? undefined : end);
    }
    const match = this.match(quote === '"' ? /"(?:[^"\\\n]|\\.)*"?/y : /'[^'\n]*'?/y)!;
    const content = match.replace(/^["']|["']$/g, '');
    return quote === '"' ? content.replace(/\\(["\\])/g, '$1') : content;
  }
  private skipSpaces() { this.match(/[ \t]*/y); }
  private skipBlank() { this.match(/(?:\s|#[^\n]*)*/y); }
  private skipLine() { this.match(/[^\n]*\n?/y); }
  private match(pattern: RegExp): string | null {
    pattern.lastIndex = this.at;
    const found = pattern.exec(this.text);
    if (!found) return null;
    this.at = pattern.lastIndex;
    return found[0];
  }
}
