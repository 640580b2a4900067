// SPDX-License-Identifier: BSD-3-Clause
// Shows the selected case and all cases together, with the controls and the address of the page.
import {caseName, cases, frequency, groups, largestOf, smallestOf} from './report_data.ts';
import {bandOf, curvesOf, frequencies, landmarksOf, styled} from './case_curves.ts';
import {byId, draw, frequencyRange, html, makeChart, makeLegend, phaseRange, suitsLogarithm} from './charts.js';
import {allCharts, axisFactor, change, frequencyUnit, onCase, onChange, shownCharts, view, zoomTo} from './view.js';

const SWITCHES = ['ylog', 'xlog', 'hz'];

// ---------------------------------------------------------------- charts of a case and of all cases

/// Charts of a case, and the nodes with them, one for each group of curves.
export function chartsOfCase(index, options = {}) {
  const c = cases[index], curves = curvesOf(c), band = bandOf(c), landmarks = landmarksOf(c), made = [];
  const row = (name, members, logarithmic) => {
    const own = members.map((member, i) => styled({...curves[member.curve], label: member.label}, i));
    const legend = makeLegend(own, true), title = `${name}, ${own.map(curve => curve.label).join(', ')}`;
    const caption = options.width ? html('span', {class: 'caption'}) : null;
    if (caption) legend.node.prepend(caption);
    const common = {curves: own, legend, unit: own[0].unit, band, landmarks, modes: c.modes, ...options};
    const pair = [makeChart({...common, logarithmic, caption, title: `Amplitude of ${title}`}),
                  makeChart({...common, phase: phaseRange(own), title: `Phase of ${title}`})];
    made.push(...pair);
    return html('div', {class: 'row'}, legend.node, html('div', {class: 'pair'}, pair.map(chart => chart.holder)));
  };
  const shown = frequencies(c).length > 1 ? groups[index] : [];
  const nodes = shown.map(({name, rows, logarithmic}) =>
    html('div', {}, html('h3', {}, name), rows.map((members, i) => (members.length ? row(name, members, logarithmic[i]) : []))));
  return {nodes, charts: made};
}
/// What the marks in the charts of a case mean.
export const marksWords = ({peaks, modes}) => [peaks.length ? 'Circles: resonance peaks.' : '',
  modes.length ? 'Grey ticks on the upper edge: undamped natural frequencies.' : ''].filter(Boolean).join(' ');
function buildCharts() {
  const made = chartsOfCase(view.case);
  byId('marks').textContent = marksWords(cases[view.case]);
  shownCharts.ofCase = made.charts;
  byId('pictures').replaceChildren(...made.nodes);
  byId('characteristics').hidden = !made.nodes.length;
}

const drawable = () => cases.filter(c => frequencies(c).length > 1);
export const comparedNames = () => [...new Set(drawable().flatMap(c => c.response.results.map(r => r.name)))];

/// Chart of one curve in all cases.
export function comparisonOf(name, options = {}) {
  const curves = cases.flatMap((c, i) => {
    const curve = frequencies(c).length > 1 && curvesOf(c).find(one => one.name === name);
    return curve ? [styled({...curve, key: `case ${i}`, label: caseName(i)}, i)] : [];
  });
  const bands = drawable().map(bandOf), limits = cases[view.case].limits.filter(l => l.name === name);
  return makeChart({curves, legend: makeLegend(curves, false), joined: true, unit: curves[0].unit, limits,
                    band: [smallestOf(bands.map(b => b[0])), largestOf(bands.map(b => b[1]))],
                    landmarks: drawable().flatMap(landmarksOf),
                    title: `Amplitude of ${name} in all cases`, ...options});
}
function buildComparison() {
  const names = comparedNames(), has = cases.length > 1 && names.length > 0;
  shownCharts.comparison = null;
  byId('comparison').hidden = !has;
  if (!has) return;
  if (!names.includes(view.compare)) view.compare = names[0];
  const comparison = shownCharts.comparison = comparisonOf(view.compare, {height: 360});
  byId('compare').replaceChildren(...names.map(name => html('option', {}, name)));
  byId('compare').value = view.compare;
  byId('compared').replaceChildren(comparison.legend.node, comparison.holder);
}

// ---------------------------------------------------------------- the page

function buildCase() {
  for (const block of document.querySelectorAll('[data-case]')) block.hidden = Number(block.dataset.case) !== view.case;
  buildCharts();
  buildComparison();
  for (const build of onCase) build();
  const sections = [...document.querySelectorAll('main section:not(.case-head)')];
  const shown = sections.filter(s => !s.closest('[hidden]'));
  const link = s => html('button', {type: 'button', class: 'link', onclick: () => s.scrollIntoView()},
                         s.querySelector('h2').textContent);
  byId('contents').replaceChildren(...shown.map(link));
  byId('switches').hidden = !allCharts().length;
}

/// Updates controls and address to the view and redraws the charts.
/// @param what  'all', or 'range' if only the zoom changed
function refresh(what = 'all') {
  for (const key of SWITCHES) byId(key).checked = view[key];
  const wide = allCharts().filter(chart => !chart.phase).map(suitsLogarithm);
  byId('ylog').checked = view.ylog ?? wide.includes(true);
  byId('ylog').indeterminate = view.ylog === null && wide.includes(true) && wide.includes(false);
  byId('case').value = view.case;
  const range = allCharts().length ? frequencyRange(allCharts()[0]) : [0, 0];
  [byId('from').value, byId('to').value] = range.map(w => Number((w * axisFactor()).toPrecision(5)));
  byId('zoom-unit').textContent = frequencyUnit();
  byId('unzoom').disabled = !view.zoom;
  document.querySelectorAll('.glance tbody tr').forEach((row, i) =>
    row.classList.toggle('selected', i === view.case && cases.length > 1));
  for (const chart of allCharts()) {
    chart.stale = chart.plot && what === 'range' && chart.stale !== 'all' ? 'range' : 'all';
    draw(chart);
  }
  soon('address', writeAddress);
}
onChange.push(names => {
  if (names.includes('case')) buildCase();
  refresh(names.join() === 'zoom' ? 'range' : 'all');
});

/// Calls a function after the last of several events.
const timers = new Map();
export function soon(name, action) {
  clearTimeout(timers.get(name));
  timers.set(name, setTimeout(action, 150));
}

/// The view in the address, as in #case=1&ylog&xlog&hz&zoom=2,40&compare=pump.z&hide=pump.x
export function writeAddress() {
  const parts = SWITCHES.filter(key => view[key]);
  if (view.ylog === false) parts.push('ylog=0');
  if (view.case) parts.unshift(`case=${view.case}`);
  if (view.zoom) parts.push(`zoom=${view.zoom.map(w => Number(w.toPrecision(6))).join(',')}`);
  if (view.compare && view.compare !== comparedNames()[0]) parts.push(`compare=${encodeURIComponent(view.compare)}`);
  if (view.design) parts.push(`design=${view.design}`);
  if (view.hidden.size) parts.push(`hide=${[...view.hidden].map(encodeURIComponent).join(',')}`);
  try {
    history.replaceState(null, '', `#${parts.join('&')}`);
  } catch { /* some browsers do not allow this for files */ }
}
function decoded(text) {
  try { return decodeURIComponent(text); } catch { return ''; }
}
function readAddress() {
  if (byId(location.hash.slice(1))) return;  // a link to a part of the page
  const parts = location.hash.slice(1).split('&').map(part => /^([^=]*)=?(.*)$/.exec(part));
  const given = new Map(parts.map(([, name, value]) => [name, value]));
  const index = Number(given.get('case') ?? 0), zoom = (given.get('zoom') ?? '').split(',').map(Number);
  view.case = cases[index] ? index : 0;
  for (const key of SWITCHES) view[key] = given.has(key);
  view.ylog = given.has('ylog') ? given.get('ylog') !== '0' : null;
  view.zoom = zoom.length === 2 && zoom[0] >= 0 && zoom[1] > zoom[0] ? zoom : null;
  view.design = /^\d+,\d+$/.test(given.get('design')) ? given.get('design').split(',').map(Number) : null;
  view.compare = decoded(given.get('compare') ?? '');
  view.hidden = new Set((given.get('hide') ?? '').split(',').filter(Boolean).map(decoded));
  buildCase();
  refresh();
}

function listenToControls() {
  const listen = (id, type, action) => byId(id).addEventListener(type, action);
  listen('case', 'change', event => change({case: Number(event.target.value)}));
  for (const key of SWITCHES) listen(key, 'change', event => change({[key]: event.target.checked}));
  for (const id of ['from', 'to'])
    listen(id, 'change', () => zoomTo(...['from', 'to'].map(end => byId(end).valueAsNumber / axisFactor())));
  listen('unzoom', 'click', () => change({zoom: null}));
  listen('controls', 'submit', event => event.preventDefault());
  listen('compare', 'change', event => {
    view.compare = event.target.value;
    buildComparison();
    refresh();
  });
  for (const button of document.querySelectorAll('[data-select]'))
    button.addEventListener('click', event => {
      event.preventDefault();
      change({case: Number(button.dataset.select)});
      document.querySelector('.case-head:not([hidden] *)').scrollIntoView();
    });
  window.addEventListener('resize', () => soon('size', refresh));
  window.addEventListener('scroll', () => allCharts().forEach(draw), {passive: true});
  document.addEventListener('toggle', () => allCharts().forEach(draw), true);  // a part that opens by a click
  window.addEventListener('hashchange', readAddress);
}

/// Shows the view in the address.
export function begin() {
  if (cases.length) {
    listenToControls();
    readAddress();
  }
  byId('controls').hidden = !cases.length;
  byId('hz').parentNode.hidden = frequency?.unit === 'Hz';  // the axes are in it already
  if (byId('overview')) byId('overview').hidden = !drawable().length;
}
