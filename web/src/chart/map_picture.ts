// SPDX-License-Identifier: BSD-3-Clause
// Draws a map of designs in the colours that the program states, as in the report: full where a rule is violated and light where all
// are met; the exact boundary between both; cases, and the best design.
import type {Theme} from '../display.ts';
import {partOn, ticksOf} from '../map_axis.ts';
import {number} from '../quantities.ts';
import type {DesignMap, MapAxis} from '../results.ts';
import {overlap, type Box} from './label_places.ts';
import {chartColours} from './strokes.ts';

const LEFT = 54, RIGHT = 10, TOP = 8, BOTTOM = 34;  // px around the plot
const DOT = 3.5;  // radius of a case [px]

export interface Plotted {
  left: number;
  top: number;
  width: number;
  height: number;
}
export const plottedIn = (width: number, height: number): Plotted => ({left: LEFT, top: TOP, width: width - LEFT - RIGHT, height: height - TOP - BOTTOM});

export function drawMap(pen: CanvasRenderingContext2D, map: DesignMap, width: number, height: number, theme: Theme) {
  const area = plottedIn(width, height), colours = chartColours(theme), {x, y} = map;
  const across = (value: number) => area.left + partOn(x, value) * area.width, up = (value: number) => area.top + (1 - partOn(y, value)) * area.height;
  pen.clearRect(0, 0, width, height);
  pen.font = '11px system-ui, sans-serif';
  pen.save();
  pen.beginPath();
  pen.rect(area.left, area.top, area.width, area.height);
  pen.clip();
  pen.imageSmoothingEnabled = false;
  const [cellX, cellY] = [area.width / (x.points - 1), area.height / (y.points - 1)];  // a design is the middle of its cell
  pen.drawImage(cells(map), area.left - cellX / 2, area.top - cellY / 2, area.width + cellX, area.height + cellY);
  for (const line of map.feasible.boundary) {
    pen.beginPath();
    line.forEach(([a, b], i) => (i ? pen.lineTo(across(a), up(b)) : pen.moveTo(across(a), up(b))));
    pen.strokeStyle = colours.text;
    pen.lineWidth = 2;
    pen.stroke();
  }
  pen.restore();
  frame(pen, area, map, colours.axis, colours.text);
  const marks = map.marks.flatMap(mark => (mark.of_this_model && mark.x !== null && mark.y !== null && inside(x, mark.x) && inside(y, mark.y) ? [{mark, at: [across(mark.x), up(mark.y)] as const}] : []));
  for (const {mark, at} of marks) {
    pen.beginPath();
    pen.arc(...at, DOT, 0, 7);
    pen.fillStyle = mark.kept === undefined ? colours.axis : mark.kept ? colours.text : mark.decides ? colours.violated : colours.unbinding;
    pen.fill();
    pen.strokeStyle = theme === 'dark' ? '#000' : '#fff';
    pen.lineWidth = 1;
    pen.stroke();
  }
  const taken = marks.map(({at: [a, b]}): Box => [a - DOT, b - DOT, a + DOT, b + DOT]);
  for (const {mark, at} of marks) written(pen, mark.case || 'base model', at, area, taken, theme);
  if (map.best) star(pen, [across(map.best.x), up(map.best.y)], colours.text, theme);
}
const inside = ({from, to}: MapAxis, value: number) => value >= from && value <= to;

const FULL = 255, LIGHT = 71;  // opacity: a colour under the white of the report, which covers 72 % of it

/// A picture with a pixel for each design.
function cells({x, y, grid, colours}: DesignMap): HTMLCanvasElement {
  const canvas = document.createElement('canvas');
  [canvas.width, canvas.height] = [x.points, y.points];
  const pen = canvas.getContext('2d')!, image = pen.createImageData(x.points, y.points);
  const colourOf = new Map(colours.map(({governing, colour}) => [governing as number | string, rgb(colour)]));
  grid.governing.forEach((governing, k) => {
    const row = y.points - 1 - Math.floor(k / x.points), at = 4 * (row * x.points + k % x.points), margin = grid.margin[k] ?? null;
    const met = governing === 'none' || margin !== null && margin >= 1;
    const [r, g, b] = colourOf.get(governing === 'no model' ? 'not computed' : governing)!;
    image.data.set([r!, g!, b!, met ? LIGHT : FULL], at);
  });
  pen.putImageData(image, 0, 0);
  return canvas;
}
const rgb = (colour: string) => [1, 3, 5].map(i => parseInt(colour.slice(i, i + 2), 16));

function frame(pen: CanvasRenderingContext2D, area: Plotted, {x, y}: DesignMap, line: string, text: string) {
  const {left, top, width, height} = area;
  pen.strokeStyle = line;
  pen.lineWidth = 1;
  pen.strokeRect(left + 0.5, top + 0.5, width - 1, height - 1);
  pen.fillStyle = text;
  pen.textAlign = 'center';
  let last = -Infinity;
  for (const value of ticksOf(x, width / 55)) {
    const at = left + partOn(x, value) * width, words = number(value, 4);
    pen.fillRect(at, top + height, 1, 4);
    if (at - last < pen.measureText(words).width + 8) continue;
    last = at;
    pen.fillText(words, Math.min(Math.max(at, left + 6), left + width - 6), top + height + 15);
  }
  pen.textAlign = 'right';
  let above = Infinity;
  for (const value of ticksOf(y, height / 28)) {
    const at = top + (1 - partOn(y, value)) * height;
    pen.fillRect(left - 4, at, 4, 1);
    if (above - at < 13) continue;
    above = at;
    pen.fillText(number(value, 4), left - 7, Math.min(at + 4, top + height));
  }
  pen.textAlign = 'center';
  pen.fillText(titleOf(x), left + width / 2, top + height + 29);
  pen.save();
  pen.translate(11, top + height / 2);
  pen.rotate(-Math.PI / 2);
  pen.fillText(titleOf(y), 0, 0);
  pen.restore();
}
export const titleOf = ({name, unit}: MapAxis) => (unit ? `${name} [${unit}]` : name);

/// Writes a name beside its dot, where it covers neither another dot nor another name; without room not at all.
function written(pen: CanvasRenderingContext2D, words: string, [x, y]: readonly [number, number], area: Plotted, taken: Box[], theme: Theme) {
  const width = pen.measureText(words).width, sides = [x + 6, x - 6 - width].filter(left => left >= area.left && left + width <= area.left + area.width);
  const free = [y - 5, y + 14].flatMap(bottom => sides.map((left): Box => [left, bottom - 10, left + width, bottom + 2])).find(box => box[1] >= area.top && !taken.some(other => overlap(box, other)));
  if (!free) return;
  taken.push(free);
  pen.textAlign = 'left';
  pen.lineWidth = 3;
  pen.strokeStyle = chartColours(theme).back;
  pen.fillStyle = chartColours(theme).text;
  pen.strokeText(words, free[0], free[3] - 2);
  pen.fillText(words, free[0], free[3] - 2);
}
function star(pen: CanvasRenderingContext2D, [x, y]: readonly [number, number], colour: string, theme: Theme) {
  pen.beginPath();
  for (let i = 0; i < 10; i++) {
    const size = i % 2 ? 3.2 : 8, angle = Math.PI * (i / 5 - 0.5);
    pen.lineTo(x + size * Math.cos(angle), y + size * Math.sin(angle));
  }
  pen.closePath();
  pen.fillStyle = colour;
  pen.fill();
  pen.lineWidth = 1;
  pen.strokeStyle = theme === 'dark' ? '#000' : '#fff';
  pen.stroke();
}
