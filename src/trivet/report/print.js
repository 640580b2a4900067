// SPDX-License-Identifier: BSD-3-Clause
// The page on paper: all cases below each other, each with its charts, all comparisons, nothing folded, no wide tables.

const PAPER_WIDTH = 702;  // of the text [px]: A4 without the margins in page.css; Letter is wider
const PAPER_CHART = {width: 344, height: 218};
const LEAST_FONT = 7.5;   // of a table [px]
const undo = [];          // steps back to the screen
let paperCharts = [];

function unfold() {
  for (const part of document.querySelectorAll('details:not([open])')) {
    part.open = true;
    undo.push(() => { part.open = false; });
  }
}
function moveForPrint(node, target) {
  const {parentNode, nextSibling} = node;
  target.append(node);
  undo.push(() => parentNode.insertBefore(node, nextSibling));
}

/// What the user left out of the charts.
function viewWords() {
  const words = [];
  if (view.zoom) words.push(`Only ω = ${view.zoom.map(w => number(w, 5)).join(' … ')} rad/s is drawn.`);
  const hidden = [...view.hidden].map(key => (/^case \d+$/.test(key) ? caseName(Number(key.slice(5))) : key));
  if (hidden.length) words.push(`Not drawn: ${hidden.join(', ')}.`);
  return words.length ? html('p', {class: 'hint'}, words.join(' ')) : null;
}
const drawnWords = 'Circles: resonance peaks. Grey ticks on the upper edge: undamped natural frequencies.';

/// Would a linear axis show only a spike? On the screen a switch chooses the axis.
function isSpiky(chart) {
  const spiky = 10, lines = shownCurves(chart).map(curve => inRange(curve, ...frequencyRange(chart)));
  const highest = line => largestOf(line.map(p => p[1])), common = largestOf(lines.map(commonTop));
  return common > 0 && largestOf(lines.map(highest)) > spiky * common;
}

/// Heading, charts, results and tables of a case.
function paperCase(index) {
  const {nodes, charts: made} = chartsOfCase(index, PAPER_CHART);
  paperCharts.push(...made);
  const page = html('div', {class: 'paper-case'}), title = html('h2', {}, 'Amplitude and phase characteristics');
  const [head, ...rest] = document.querySelectorAll(`[data-case="${index}"]`);
  moveForPrint(head, page);
  if (nodes.length)
    page.append(html('section', {}, title, html('p', {class: 'hint'}, drawnWords), viewWords(), nodes));
  for (const block of rest) moveForPrint(block, page);
  return page;
}

/// All curves above round-off, each in all cases, two charts in a row.
function paperComparison() {
  const all = comparedNames().map(name => ({name, chart: comparisonOf(name, PAPER_CHART)})), rows = [];
  const made = all.filter(({chart}) => chart.curves.some(curve => !curve.vanishes));
  const vanishing = all.filter(one => !made.includes(one)).map(({name}) => name).join(', ');
  const left = vanishing ? html('p', {class: 'hint'}, `Below round-off in all cases: ${vanishing}.`) : null;
  for (let i = 0; i < made.length; i += 2) {
    const pair = made.slice(i, i + 2);
    const shown = pair.map(({name, chart}) => html('div', {}, html('h4', {}, name), chart.holder));
    const legend = makeLegend(pair[0].chart.curves.map(curve => ({...curve, vanishes: false})), false).node;
    legend.classList.add('names-only');
    rows.push(html('div', {class: 'row'}, legend, html('div', {class: 'pair'}, shown)));
  }
  paperCharts.push(...made.map(({chart}) => chart));
  return html('section', {}, html('h2', {}, 'Comparison of cases'), viewWords(), rows, left);
}

/// Groups of as many columns as fit into `room`, each with the first column; one group if cells cover several columns.
function columnGroups(table, widths, room) {
  const others = widths.map((_, i) => i).slice(1);
  if (!others.length || table.querySelector('[colspan]')) return [[0, ...others]];
  const widest = largestOf(widths.slice(1)), fit = Math.max(1, Math.floor((room - widths[0]) / widest));
  const each = Math.ceil(others.length / Math.ceil(others.length / fit)), groups = [];
  for (let i = 0; i < others.length; i += each) groups.push([0, ...others.slice(i, i + each)]);
  return groups;
}
/// Replaces a table by several below each other, each with some of its columns.
function splitTable(table, parts) {
  const pieces = parts.map(columns => {
    const piece = table.cloneNode(true);
    piece.classList.add('piece');
    for (const row of piece.rows) [...row.cells].forEach((cell, i) => { if (!columns.includes(i)) cell.remove(); });
    return piece;
  });
  table.after(...pieces);
  table.hidden = true;
  undo.push(() => {
    for (const piece of pieces) piece.remove();
    table.hidden = false;
  });
  return pieces;
}

/// Tables that are wider than the paper even if their texts are wrapped get a smaller font, or else are split.
function narrowTables() {
  const tables = [...document.querySelectorAll('table')];
  document.body.classList.add('measured');
  const sizes = tables.map(table => ({font: parseFloat(getComputedStyle(table).fontSize), width: table.offsetWidth,
                                      columns: [...table.rows[0].cells].map(cell => cell.offsetWidth)}));
  document.body.classList.remove('measured');
  tables.forEach((table, k) => {
    const {font, width, columns} = sizes[k];
    if (width <= PAPER_WIDTH) return;
    const least = PAPER_WIDTH * font / LEAST_FONT;  // the widest table, in its own font, that only gets a smaller one
    const parts = width > least ? columnGroups(table, columns, least) : [[]];
    const pieces = parts.length > 1 ? splitTable(table, parts) : [table];
    const used = parts.length > 1 ? largestOf(parts.map(part => part.reduce((sum, i) => sum + columns[i], 0))) : width;
    for (const piece of pieces) piece.style.fontSize = `${font * Math.min(1, PAPER_WIDTH / used)}px`;
    undo.push(() => { table.style.fontSize = ''; });
  });
}

function layOutPages() {
  if (undo.length) return;
  document.body.classList.add('paper');
  undo.push(() => document.body.classList.remove('paper'));
  unfold();
  const parts = cases.map((c, index) => paperCase(index));
  if (!byId('comparison').hidden) parts.unshift(paperComparison());
  const all = html('div', {}, parts);
  byId('controls').after(all);
  undo.push(() => all.remove());
  for (const chart of paperCharts) {
    chart.spiky = !chart.phase && isSpiky(chart);
    draw(chart);
  }
  narrowTables();
}
function backToScreen() {
  for (const chart of paperCharts) chart.plot?.destroy();
  paperCharts = [];
  while (undo.length) undo.pop()();
}
