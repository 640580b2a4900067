// SPDX-License-Identifier: BSD-3-Clause
// Keys of the project file and their descriptions, from `trivet schema`.

type Node = {[key: string]: unknown};
export interface Key {
  name: string;
  description: string;
  choices: string[];
}

export class Schema {
  constructor(private readonly root: Node) {}

  description(path: readonly string[]): string {
    for (const node of this.at(path)) if (typeof node['description'] === 'string') return node['description'];
    return '';
  }
  /// Keys that may follow a path.
  keys(path: readonly string[]): Key[] {
    const found = new Map<string, Key>();
    for (const node of this.at(path))
      for (const name of Object.keys((node['properties'] ?? {}) as Node))
        if (!found.has(name))
          found.set(name, {name, description: this.description([...path, name]), choices: this.choices([...path, name])});
    return [...found.values()].sort((a, b) => a.name.localeCompare(b.name));
  }
  /// Texts that a key accepts.
  choices(path: readonly string[]): string[] {
    const all = this.at(path).flatMap(node => [...((node['enum'] as unknown[]) ?? []), node['const']]);
    return [...new Set(all.filter((v): v is string => typeof v === 'string'))];
  }

  /// All alternatives of the schema for a path.
  private at(path: readonly string[]): Node[] {
    let nodes = this.alternatives(this.root);
    for (const part of path) {
      nodes = nodes.flatMap(node => {
        const named = ((node['properties'] ?? {}) as Node)[part] as Node | undefined;
        const other = node['additionalProperties'], items = /^\d+$/.test(part) ? node['items'] : undefined;
        const next = named ?? (typeof other === 'object' ? other as Node : undefined) ?? items as Node | undefined;
        return next ? this.alternatives(next) : [];
      });
    }
    return nodes;
  }
  private alternatives(node: Node, depth = 0): Node[] {
    if (depth > 12) return [node];
    const result = [node];
    const ref = node['$ref'];
    if (typeof ref === 'string') result.push(...this.alternatives(this.definition(ref), depth + 1));
    for (const word of ['anyOf', 'oneOf', 'allOf'])
      for (const one of (node[word] ?? []) as Node[]) result.push(...this.alternatives(one, depth + 1));
    for (const word of ['then', 'else'])
      if (typeof node[word] === 'object') result.push(...this.alternatives(node[word] as Node, depth + 1));
    return result;
  }
  private definition(ref: string): Node {
    return ref.replace(/^#\//, '').split('/').reduce((node: unknown, part) => (node as Node)?.[part], this.root) as Node ?? {};
  }
}
