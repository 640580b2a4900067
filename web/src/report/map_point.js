// SPDX-License-Identifier: BSD-3-Clause
// The point of a map of designs: moved by mouse, touch and keys to the nearest stored design, whose verdict and curves
// follow. Nothing between stored designs is shown.
import {cases, designGroups, factorOf, number, read} from './report_data.ts';
import {bandOf, curvesOf, landmarksOf, styled} from './case_curves.ts';
import {caseOfDesign, readDesigns} from './design_case.ts';
import {byId, draw, html, makeChart, makeLegend} from './charts.js';
import {soon, writeAddress} from './page.js';
import {onCase, shownCharts, view} from './view.js';

const maps = byId('designs') ? read('designs').map(map => map && readDesigns(map)) : [];
for (const map of maps.filter(Boolean))
  map.limits = map.rules.filter(rule => rule.limit !== undefined)
    .map(rule => ({...rule, limit: rule.limit * factorOf(rule.unit)}));
const STEP_WITH_SHIFT = 5;
let shown = null;  // the parts of the page that show the point of the selected case

const svgNode = (tag, attributes) => {
  const node = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
  return node;
};

// ---------------------------------------------------------------- the design under the point

const placeOf = map => {
  const inside = view.design?.every((k, axis) => k < [map.x, map.y][axis].values.length);
  return inside ? view.design : map.start;
};
const nodeOf = (map, [i, j]) => j * map.x.values.length + i;
const pixelOf = ({frame: [x, y, width, height], x: across, y: up}, [i, j]) =>
  [x + across.shares[i] * width, y + (1 - up.shares[j]) * height];

/// The rule with the least margin, as the map judged the design.
function verdictOf(map, node) {
  const governing = map.governing[node], margin = map.margins[node];
  if (governing === map.no_model) return {style: 'unsure', words: 'no valid model'};
  if (governing === map.not_computed) return {style: 'unsure', words: 'not computed'};
  if (margin === Infinity) return {style: 'good', words: '✓ met: no rule limits it'};
  const least = `least margin ${number(margin, 4)}, of “${map.rules[governing].words}”`;
  return margin >= 1 ? {style: 'good', words: `✓ met: ${least}`} : {style: 'bad', words: `✗ VIOLATED: ${least}`};
}
const numbersOf = ({x, y}, [i, j]) => `${x.name} = ${x.words[i]}, ${y.name} = ${y.words[j]}`;

/// What is stored, and how exactly.
function storedWords(map) {
  const {x, y, curves} = map, count = axis => axis.values.length;
  const grid = `${count(x)} × ${count(y)} of the ${x.points} × ${y.points} designs of the map are stored in this page`;
  if (!curves) return `${grid}, without their curves: ${map.reason}.`;
  return `${grid}; the point moves from one to the next, and nothing is interpolated between them. ` +
         `Verdicts are those of the map. Curves are evaluated from poles and residues, within ` +
         `${number(curves.error, 2)} of the program's. Circles: maxima of the drawn curves.`;
}

// ---------------------------------------------------------------- parts of the page

/// A part of a picture with names of its own, for a second copy on the page.
function copyOf(svg, [x, y, width, height], name) {
  const holder = html('div', {class: 'crop'});
  holder.innerHTML = svg.outerHTML.replaceAll('id="', `id="${name}-`).replaceAll('url(#', `url(#${name}-`);
  const copy = holder.firstElementChild;
  copy.setAttribute('viewBox', [x, y, width, height].join(' '));
  copy.setAttribute('width', width);
  copy.setAttribute('height', height);
  return holder;
}

/// The sign of the point: a ring with lines to the frame.
function ringIn(map) {
  const lines = ['x', 'y'].map(() => svgNode('line', {class: 'to-frame'}));
  const group = svgNode('g', {class: 'map-point'}), [left, top, width, height] = map.frame;
  group.append(...lines, svgNode('circle', {r: 9, class: 'halo'}), svgNode('circle', {r: 9, class: 'ring'}));
  const move = ([x, y]) => {
    for (const circle of group.querySelectorAll('circle')) [circle.cx.baseVal.value, circle.cy.baseVal.value] = [x, y];
    const ends = [[x, top, x, top + height], [left, y, left + width, y]];
    lines.forEach((line, k) => ['x1', 'y1', 'x2', 'y2'].forEach((name, n) => line.setAttribute(name, ends[k][n])));
  };
  return {group, move};
}

/// The map with its point, over a copy of the picture without its key.
function movableMap(map, svg, index) {
  const [left, top, width, height] = map.frame, box = [0, top - 14, left + width + 14, height + 65];
  const holder = copyOf(svg, box, `point-${index}`), ring = ringIn(map);
  const layer = svgNode('svg', {class: 'map-layer', viewBox: box.join(' '), 'aria-label': 'Point of the map'});
  const area = svgNode('rect', {class: 'map-area', x: left, y: top, width, height});
  const handle = svgNode('circle', {r: 24, class: 'map-handle', tabindex: 0, role: 'application',
                                    'aria-roledescription': 'point on the map, moved by the arrow keys'});
  layer.append(area, ring.group, handle);
  holder.append(layer);
  const nearest = (shares, share) => shares.reduce(
    (best, s, k) => (Math.abs(s - share) < Math.abs(shares[best] - share) ? k : best), 0);
  const moveTo = event => {
    const {left: x0, top: y0, width: w} = layer.getBoundingClientRect(), scale = box[2] / w;
    const x = box[0] + (event.clientX - x0) * scale, y = box[1] + (event.clientY - y0) * scale;
    setPlace([nearest(map.x.shares, (x - left) / width), nearest(map.y.shares, 1 - (y - top) / height)]);
  };
  for (const node of [area, handle])
    node.addEventListener('pointerdown', event => {
      if (event.button !== 0 || (node === area && event.pointerType === 'touch')) return;
      event.preventDefault();
      handle.focus({preventScroll: true});
      node.setPointerCapture(event.pointerId);
      if (node === area) moveTo(event);
    });
  for (const node of [area, handle])
    node.addEventListener('pointermove', event => { if (node.hasPointerCapture(event.pointerId)) moveTo(event); });
  area.addEventListener('click', moveTo);  // a touch that does not scroll
  handle.addEventListener('keydown', event => {
    const [dx, dy] = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]}[event.key] ?? [0, 0];
    if (!dx && !dy) return;
    event.preventDefault();
    const by = event.shiftKey ? STEP_WITH_SHIFT : 1, [i, j] = placeOf(map);
    const within = (k, {values}) => Math.max(0, Math.min(values.length - 1, k));
    setPlace([within(i + by * dx, map.x), within(j + by * dy, map.y)]);
  });
  const move = ([x, y], words) => {
    ring.move([x, y]);
    [handle.cx.baseVal.value, handle.cy.baseVal.value] = [x, y];
    handle.setAttribute('aria-label', words);
  };
  return {holder, move};
}

/// A slider over the stored values of an axis.
function sliderOf(map, axis, k) {
  const value = html('output', {}), {name, words} = axis;
  const input = html('input', {type: 'range', min: 0, max: words.length - 1, step: 1, 'aria-label': name, oninput: () =>
    setPlace(placeOf(map).map((old, n) => (n === k ? input.valueAsNumber : old)))});
  const move = at => {
    [input.value, value.textContent] = [at, words[at]];
    input.setAttribute('aria-valuetext', words[at]);
  };
  return {row: html('label', {class: 'design-slider'}, html('span', {}, name), input, value), move};
}

/// Parts that show the point of a map, in the place of its picture; on paper the picture itself is there.
function partsOf(index) {
  const map = maps[index], figure = document.querySelector(`[data-case="${index}"] section.map figure`);
  const svg = figure.querySelector('svg'), ring = ringIn(map), movable = movableMap(map, svg, index);
  const [left, top, width, height] = map.frame, edge = left + width + 14;
  const {width: all, height: high} = svg.viewBox.baseVal;
  const key = copyOf(svg, [edge, top - 14, all - edge, height + 14], `key-${index}`);
  const notes = copyOf(svg, [left - 4, top + height + 53, all - left, high - top - height - 53], `notes-${index}`);
  svg.append(ring.group);
  const sliders = [sliderOf(map, map.x, 0), sliderOf(map, map.y, 1)];
  const verdict = html('p', {class: 'verdict', role: 'status'}), onPaper = html('p', {class: 'design-on-paper'});
  const groupChoice = html('select', {onchange: event => { shown.group = Number(event.target.value); showDesign(); }});
  const choice = html('label', {}, 'Curves of ', groupChoice), drawn = html('div', {});
  groupChoice.append(...designGroups[index].map(({name}, k) => html('option', {value: k}, name)));
  choice.hidden = designGroups[index].length < 2;
  const live = html('div', {class: 'design-view'},
                    html('div', {}, movable.holder, sliders.map(({row}) => row)),
                    html('div', {class: 'design-curves'}, verdict, choice, drawn),
                    html('p', {class: 'below hint'}, storedWords(map)), html('div', {class: 'below'}, key, notes));
  figure.classList.add('on-paper');
  figure.after(live, onPaper);
  return {index, map, ring, movable, sliders, verdict, onPaper, drawn, groupChoice, group: 0};
}

// ---------------------------------------------------------------- changes

/// Limits of curves in one chart; those at one height are one line.
function limitsTogether(curves) {
  const lines = new Map();
  for (const {label, limits} of curves)
    for (const l of limits) lines.set(l.limit, {...l, label: [...(lines.get(l.limit)?.label ?? []), label]});
  return [...lines.values()].map(l => ({...l, label: l.label.join(', ')}));
}
/// Amplitude charts of a group of curves of the design.
function chartsOfDesign(made, {rows}) {
  const curves = curvesOf(made), band = bandOf(made), built = [];
  const nodes = rows.filter(members => members.length).map(members => {
    const own = members.map((member, i) => styled({...curves[member.curve], label: member.label}, i));
    const legend = makeLegend(own, false);
    const chart = makeChart({curves: own, legend, unit: own[0].unit, band, landmarks: landmarksOf(made), height: 250,
                             limits: limitsTogether(own),
                             title: `Amplitude of ${own.map(curve => curve.label).join(', ')} of the design`});
    built.push(chart);
    return html('div', {class: 'row'}, legend.node, chart.holder);
  });
  return {nodes, built};
}
function showDesign() {
  const {index, map, ring, movable, sliders, verdict, onPaper, drawn} = shown, place = placeOf(map);
  const node = nodeOf(map, place), numbers = numbersOf(map, place), judged = verdictOf(map, node);
  for (const {move} of [ring, movable]) move(pixelOf(map, place), numbers);
  sliders.forEach(({move}, k) => move(place[k]));
  const words = () => [`${numbers}: `, html('span', {class: judged.style}, judged.words)];
  verdict.replaceChildren(...words());
  onPaper.replaceChildren('Design at the ring: ', ...words());
  for (const part of [ring.group, onPaper]) part.classList.toggle('unmoved', !view.design);
  for (const chart of shownCharts.ofDesign) chart.plot?.destroy();
  shownCharts.ofDesign = [];
  drawn.replaceChildren();
  if (!map.curves || !designGroups[index].length) return;
  if (!map.curves.drawn[node]) {
    const reason = 'No curves of this design are stored: it has no valid model, or its poles are double.';
    drawn.append(html('p', {class: 'hint'}, reason));
    return;
  }
  const {nodes, built} = chartsOfDesign(caseOfDesign(cases[index], map, node), designGroups[index][shown.group]);
  drawn.append(...nodes);
  shownCharts.ofDesign = built;
  for (const chart of built) draw(chart);
}
let waiting = 0;
function setPlace(place) {
  if (view.design?.every((k, axis) => k === place[axis])) return;
  view.design = place;
  waiting ||= requestAnimationFrame(() => {
    waiting = 0;
    showDesign();
    soon('address', writeAddress);
  });
}

const parts = new Map();
onCase.push(() => {
  const index = view.case;
  shownCharts.ofDesign = [];
  if (!maps[index]) return;
  if (!parts.has(index)) parts.set(index, partsOf(index));
  shown = parts.get(index);
  showDesign();
});
