// SPDX-License-Identifier: BSD-3-Clause

/// Gives a text to the user as a file.
export function download(name: string, text: string) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([text], {type: 'application/toml'}));
  link.download = name;
  link.click();
  URL.revokeObjectURL(link.href);
}
