// SPDX-License-Identifier: BSD-3-Clause
// The page on paper: all cases below each other, each with its charts, all comparisons, nothing folded, no wide tables.
import {caseName, cases, largestOf, number} from './report_data.ts';
import {amplitudeWords, byId, draw, html, makeLegend} from './charts.js';
import {chartsOfCase, comparedNames, comparisonOf, marksWords} from './page.js';
import {view} from './view.js';

const PAPER_WIDTH = 702;  // of the text [px]: A4 without the margins in page.css; Letter is wider
const PAPER_CHART = {width: 344, height: 126};
const LEAST_FONT = 7.5;   // of a table [px]
const COLUMN_GAP = 19;    // between parts of a narrow table side by side [px], as in page.css
const FEW_ROWS = 10;      // such a table is not divided
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

function replaceOnPaper(part, sentence) {
  part.after(sentence);
  part.hidden = true;
  undo.push(() => { sentence.remove(); part.hidden = false; });
}

/// What the user left out of the charts.
function viewWords() {
  const words = [];
  if (view.zoom) words.push(`Only ω = ${view.zoom.map(w => number(w, 5)).join(' … ')} rad/s is drawn.`);
  const hidden = [...view.hidden].map(key => (/^case \d+$/.test(key) ? caseName(Number(key.slice(5))) : key));
  if (hidden.length) words.push(`Not drawn: ${hidden.join(', ')}.`);
  return words.length ? html('p', {class: 'hint'}, words.join(' ')) : null;
}
/// Heading, charts, results and tables of a case.
function paperCase(index) {
  const {nodes, charts: made} = chartsOfCase(index, PAPER_CHART);
  paperCharts.push(...made);
  const page = html('div', {class: 'paper-case'}), title = html('h2', {}, 'Amplitude and phase characteristics');
  const [head, ...rest] = document.querySelectorAll(`[data-case="${index}"]`);
  moveForPrint(head, page);
  if (nodes.length)
    page.append(html('section', {}, title, html('p', {class: 'hint'}, marksWords(cases[index])), viewWords(), nodes));
  for (const block of rest) moveForPrint(block, page);
  return page;
}

/// All curves above round-off, each in all cases, two charts in a row.
function paperComparison() {
  const caption = () => html('span', {class: 'caption'}), rows = [];
  const all = comparedNames().map(name => ({name, chart: comparisonOf(name, {...PAPER_CHART, caption: caption()})}));
  const made = all.filter(({chart}) => chart.curves.some(curve => !curve.vanishes));
  const vanishing = all.filter(one => !made.includes(one)).map(({name}) => name).join(', ');
  const left = vanishing ? html('p', {class: 'hint'}, `Below round-off in all cases: ${vanishing}.`) : null;
  for (let i = 0; i < made.length; i += 2) {
    const pair = made.slice(i, i + 2);
    const shown = pair.map(({name, chart}) =>
      html('div', {}, html('h4', {}, `${name}: `, chart.caption), chart.holder));
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

/// Widths of tables in which no cell is wrapped, only headings.
function widthsOnOneLine(tables) {
  document.body.classList.add('measured', 'one-line');
  const widths = tables.map(table => table.offsetWidth);
  document.body.classList.remove('measured', 'one-line');
  return widths;
}
const fontOf = table => parseFloat(getComputedStyle(table).fontSize);
/// The font in which a table fits into a width.
const fittingFont = (table, width, room) => fontOf(table) * Math.min(1, room / width);
/// Gives a table the font in which it fits into a width; false if that would be too small.
function fitTable(table, width, room) {
  const fitting = fittingFont(table, width, room);
  if (fitting < LEAST_FONT) return false;
  if (fitting < fontOf(table)) {
    table.style.fontSize = `${fitting}px`;
    undo.push(() => { table.style.fontSize = ''; });
  }
  return true;
}
const HALF = (PAPER_WIDTH - COLUMN_GAP) / 2;

/// Divides long narrow tables into columns side by side.
function divideLongTables() {
  const tables = [...document.querySelectorAll('.scroll > table:only-child:not([hidden])')];
  const widths = widthsOnOneLine(tables);
  tables.forEach((table, k) => {
    const {parentNode} = table, most = Math.ceil(table.rows.length / FEW_ROWS);
    if (most < 2) return;
    if (!fitTable(table, widths[k], HALF)) {
      table.classList.add('tight');
      undo.push(() => table.classList.remove('tight'));
      if (!fitTable(table, widthsOnOneLine([table])[0], HALF)) return;
    }
    parentNode.classList.add('side-by-side');
    table.classList.add('one-line');  // as measured: its headings are wrapped, its cells are not
    undo.push(() => table.classList.remove('one-line'));
    const columns = Math.min(most, Math.max(2, Math.floor(PAPER_WIDTH / (widths[k] + COLUMN_GAP))));
    parentNode.style.columnCount = columns;
    // A short one does not continue on the next page, where its headings might be missing.
    if (table.rows.length <= 1.5 * columns * FEW_ROWS) parentNode.style.breakInside = 'avoid';
    undo.push(() => {
      parentNode.classList.remove('side-by-side');
      parentNode.style.columnCount = parentNode.style.breakInside = '';
    });
  });
}

/// Places folded parts with narrow tables in pairs side by side.
function pairFoldedTables() {
  const parts = [...document.querySelectorAll('details')].filter(part => part.querySelectorAll('table').length === 1);
  const tables = parts.map(part => part.querySelector('table')), widths = widthsOnOneLine(tables);
  for (let k = 0; k + 1 < parts.length; k++) {
    const rows = tables[k].rows.length + tables[k + 1].rows.length;
    const fits = [k, k + 1].every(i => fittingFont(tables[i], widths[i], HALF) >= LEAST_FONT);
    if (parts[k].nextElementSibling !== parts[k + 1] || rows > 4 * FEW_ROWS || !fits) continue;
    const pair = html('div', {class: 'two-tables'});
    parts[k].before(pair);
    undo.push(() => pair.remove());
    for (const i of [k, k + 1]) {
      fitTable(tables[i], widths[i], HALF);
      moveForPrint(parts[i], pair);
    }
    k++;
  }
}

/// Parts of a case that are the same as in a case before it are replaced by a sentence.
function nameRepeatedParts() {
  const known = new Map();
  /// The first case with the same part at the same place, if it is not this one.
  const earlier = (part, where, index) => {
    const key = `${where}\n${part.innerHTML}`;
    if (!known.has(key)) known.set(key, index);
    return known.get(key) === index ? null : caseName(known.get(key));
  };
  const sentence = (what, name) => html('p', {class: 'hint'}, `${what}: as in the case ${name}.`);
  const hide = part => { part.hidden = true; undo.push(() => { part.hidden = false; }); };
  for (const section of document.querySelectorAll('.paper-case > [data-case] > section:not(.case-head)')) {
    const index = Number(section.parentNode.dataset.case), [title, ...parts] = section.children;
    const same = earlier(section, '', index);
    if (same !== null) replaceOnPaper(section, sentence(title.textContent, same));
    let heading = title;
    for (const part of same === null ? parts : []) {
      if (part.matches('h3')) heading = part;
      if (!part.matches('.scroll, [data-in-file], details, figure')) continue;
      const before = earlier(part, heading.textContent, index), about = part.querySelector('summary') ?? heading;
      if (before === null) continue;
      if (about.matches('h3')) hide(about);
      replaceOnPaper(part, sentence(about.textContent, before));
    }
  }
}

/// Tables of what the input file in the appendix states are not printed twice.
function leaveOutWhatTheInputFileHas() {
  for (const part of document.querySelectorAll('[data-in-file]'))
    replaceOnPaper(part, html('p', {class: 'hint'}, 'As in the input file, in the appendix.'));
}

/// On paper, long tables have only the rows that are not grey; the page and the files have all.
function leaveOutMinorRows() {
  for (const table of document.querySelectorAll('.tall > table')) {
    const minor = table.querySelectorAll('tbody tr.minor');
    if (!minor.length) continue;
    for (const row of minor) row.hidden = true;
    const words = `${minor.length} less important rows are on the screen and in the files.`;
    const sentence = html('p', {class: 'hint'}, words);
    table.parentNode.after(sentence);
    undo.push(() => {
      for (const row of minor) row.hidden = false;
      sentence.remove();
    });
  }
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
  nameRepeatedParts();
  leaveOutMinorRows();
  leaveOutWhatTheInputFileHas();
  for (const chart of paperCharts) {
    draw(chart);
    if (!chart.phase) chart.caption.textContent = amplitudeWords(chart, chart.plot);
  }
  narrowTables();
  pairFoldedTables();
  divideLongTables();
}
function backToScreen() {
  for (const chart of paperCharts) chart.plot?.destroy();
  paperCharts = [];
  while (undo.length) undo.pop()();
}

if (cases.length) {
  window.addEventListener('beforeprint', layOutPages);
  window.addEventListener('afterprint', backToScreen);
}
