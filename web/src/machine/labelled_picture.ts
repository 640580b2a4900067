// SPDX-License-Identifier: BSD-3-Clause
import type {Colours} from './colours.ts';

const SIZE = 15, LEADING = 1.3, MARGIN = 10;  // px on the page

/// A copy of a drawing with lines of text at its top, the first one as its title; long lines are broken.
/// @param ratio  pixels of the drawing per pixel of the page
export function labelledPicture(drawing: HTMLCanvasElement, lines: readonly string[], {background, text}: Colours, ratio: number): HTMLCanvasElement {
  const copy = document.createElement('canvas');
  [copy.width, copy.height] = [drawing.width, drawing.height];
  const pen = copy.getContext('2d')!;
  pen.drawImage(drawing, 0, 0);
  pen.scale(ratio, ratio);
  pen.textBaseline = 'top';
  pen.lineWidth = 4;
  pen.lineJoin = 'round';
  pen.strokeStyle = `#${background.toString(16).padStart(6, '0')}`;
  pen.fillStyle = text;
  let top = MARGIN;
  lines.forEach((line, i) => {
    pen.font = `${i ? 400 : 650} ${SIZE}px system-ui, "DejaVu Sans", sans-serif`;
    for (const part of broken(line, copy.width / ratio - 2 * MARGIN, words => pen.measureText(words).width)) {
      pen.strokeText(part, MARGIN, top);
      pen.fillText(part, MARGIN, top);
      top += LEADING * SIZE;
    }
  });
  return copy;
}
/// A line in parts that are not wider than `width`, broken between words.
export function broken(line: string, width: number, widthOf: (words: string) => number): string[] {
  const parts: string[] = [];
  for (const word of line.split(' ')) {
    const longer = parts.length ? `${parts.at(-1)} ${word}` : word;
    if (parts.length && widthOf(longer) <= width) parts[parts.length - 1] = longer;
    else parts.push(word);
  }
  return parts;
}
