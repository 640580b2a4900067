// SPDX-License-Identifier: BSD-3-Clause

/// Gives a file to the user.
export function download(name: string, content: Blob) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(content);
  link.download = name;
  link.click();
  URL.revokeObjectURL(link.href);
}
/// Gives the text of a project file to the user.
export const downloadProject = (name: string, text: string) => download(name, new Blob([text], {type: 'application/toml'}));
