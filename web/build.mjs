// SPDX-License-Identifier: BSD-3-Clause
// Bundles the page (page.js, page.css, index.html), the widget of notebooks (widget.js) and the scripts of the report
// (report.js; report_lines.js of designs within tolerances; report_machine.js, which it starts when it is wanted), all
// with their styles, into dist, with licences.txt for all, or with --tests the unit tests into build.
// --out FOLDER writes the page elsewhere, so that scripts/web can compare it with the committed one.
import {build} from 'esbuild';
import {createHash} from 'node:crypto';
import {copyFileSync, mkdirSync, readdirSync, readFileSync, writeFileSync} from 'node:fs';
import {dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
const NAMES = {uplot: 'uPlot', three: 'three.js', lit: 'Lit'};
const option = name => process.argv.includes(name);
const common = {absWorkingDir: here, bundle: true, format: 'esm', target: 'es2022', charset: 'utf8', logLevel: 'warning',
                tsconfig: 'tsconfig.json'};

/// Licences of the packages that are in the bundles, in the order of their names.
function licences(...metafiles) {
  const names = new Set();
  for (const file of metafiles.flatMap(metafile => Object.keys(metafile.inputs))) {
    const match = file.match(/node_modules\/((?:@[^/]+\/)?[^/]+)\//);
    if (match) names.add(match[1]);
  }
  const texts = [...names].sort().map(name => {
    const folder = join(here, 'node_modules', name);
    const {version, license} = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
    const file = readdirSync(folder).find(entry => /^licen[cs]e/i.test(entry));
    if (!file) throw new Error(`${name} has no licence file`);
    return `${name} ${version} (${license})\n\n${readFileSync(join(folder, file), 'utf8').trim()}\n`;
  });
  return `The page and the widget contain the following packages.\n\n${texts.join(`\n${'-'.repeat(78)}\n\n`)}`;
}

async function buildPage(out) {
  mkdirSync(out, {recursive: true});
  const result = await build({...common, entryPoints: ['src/page.ts', 'src/page.css'], outdir: out, minify: true,
                              metafile: true, legalComments: 'none'});
  const widget = await buildWidget(out);
  await buildReport(out);
  writeFileSync(join(out, 'licences.txt'), licences(result.metafile, widget.metafile));
  copyFileSync(join(here, 'src/index.html'), join(out, 'index.html'));
}

/// One module: anywidget takes a text. Its build is known by a hash of all that is in it.
async function buildWidget(out) {
  const css = (await build({...common, entryPoints: ['src/widget.css'], minify: true, write: false})).outputFiles[0].text;
  const bundle = (build_hash, options) => build({...common, ...options, entryPoints: ['src/widget.ts'], minify: true, metafile: true, legalComments: 'none',
    inject: ['src/own_elements.ts'], define: {WIDGET_CSS: JSON.stringify(css), WIDGET_BUILD: JSON.stringify(build_hash)}});
  const content = (await bundle('', {write: false})).outputFiles[0].contents;
  return bundle(createHash('sha256').update(content).digest('hex').slice(0, 16), {outdir: out});
}

/// Classic scripts within a page. Reports are mailed without licences.txt, so the licences of the libraries are in them.
async function buildReport(out) {
  const options = {...common, outdir: out, format: 'iife', minify: true, legalComments: 'none', loader: {'.css': 'text'}};
  await build({...options, entryPoints: ['src/report/report.js'], banner: {js: bannerOf('uplot')}});
  await build({...options, entryPoints: {report_lines: 'src/report/design_lines.ts'}, banner: {js: bannerOf()}});
  await build({...options, entryPoints: {report_machine: 'src/report/machine_view.ts'}, banner: {js: bannerOf('three', 'lit')}});
}
function bannerOf(...packages) {
  const licences = packages.map(name => {
    const folder = join(here, 'node_modules', name), {version} = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
    return `/* ${NAMES[name]} ${version}\n${readFileSync(join(folder, 'LICENSE'), 'utf8').trim()} */`;
  });
  return ['// SPDX-License-Identifier: BSD-3-Clause', ...licences].join('\n');
}

async function buildTests() {
  const tests = readdirSync(join(here, 'tests')).filter(file => file.endsWith('_test.ts'));
  await build({...common, entryPoints: tests.map(file => join('tests', file)), outdir: 'build/tests', platform: 'node',
               outExtension: {'.js': '.mjs'}});
}

const at = process.argv.indexOf('--out');
await (option('--tests') ? buildTests() : buildPage(at > 0 ? process.argv[at + 1] : join(here, 'dist')));
