// SPDX-License-Identifier: BSD-3-Clause
import assert from 'node:assert/strict';
import {readdirSync, readFileSync} from 'node:fs';
import {dirname, join} from 'node:path';
import {test} from 'node:test';

/// Modules that a module needs when it runs; types are gone then.
const imports = (file: string) => [...readFileSync(file, 'utf8').matchAll(/^(?:import|export) (?!type)(?:[^;']*from )?'(\.[^']+)'/gm)].map(m => join(dirname(file), m[1]!));

test('no module imports itself through others', () => {
  const files = readdirSync('src', {recursive: true, encoding: 'utf8'}).filter(name => /\.[jt]s$/.test(name)).map(name => join('src', name));
  const needs = new Map(files.map(file => [file, imports(file).filter(name => files.includes(name))])), free = new Set<string>();
  const cycle = (file: string, above: readonly string[]): readonly string[] => {
    if (above.includes(file)) return [...above.slice(above.indexOf(file)), file];
    if (free.has(file)) return [];
    for (const next of needs.get(file)!) {
      const found = cycle(next, [...above, file]);
      if (found.length) return found;
    }
    free.add(file);
    return [];
  };
  assert.ok([...needs.values()].flat().length > files.length);
  for (const file of files) assert.deepEqual(cycle(file, []), []);
});
