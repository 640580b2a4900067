// SPDX-License-Identifier: BSD-3-Clause
const OF_ITS_EIGENVALUE = / \((?:free|grows)\)$/;
const DIRECTION = / \([^(),]+,[^(),]+,[^(),]+\)/;  // three components

/// The name of a mode in a narrow column: "mostly rotation about (…) through (…) m" as "≈ about skew axis".
export function briefMode(name: string): string {
  const [end = ''] = OF_ITS_EIGENVALUE.exec(name) ?? [], motion = name.slice(0, name.length - end.length);
  return motion.replace('mostly ', '≈ ').replace('translation ', '').replace('rotation ', '').replace(/ through .*/, '').replace(DIRECTION, ' skew axis') + end;
}
