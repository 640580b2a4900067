# SPDX-License-Identifier: BSD-3-Clause
"""Reports in a browser are usable without seeing well or without a mouse: names, order of headings, contrast."""
import html
import json
import os
import re
import shutil
import subprocess
import unittest

from trivet_test import HANGS_AFTER, SOURCE, InTemporaryFolder, trivet

BROWSER = os.environ.get("TRIVET_BROWSER") or shutil.which("chromium") or shutil.which("google-chrome")
EXAMPLES = ("fan/fan", "paper/corrected", "paper/map", "genset/genset")
SCHEMES = {"light": "1", "dark": "0"}
# Contrast by WCAG 2.1, success criterion 1.4.3; pictures, which a filter inverts in the dark scheme, are left out.
FIND = r"""
addEventListener('load', () => setTimeout(() => {
  const found = [], counts = {controls: 0, images: 0, headings: 0, texts: 0};
  const about = node => `<${node.localName} ${node.className?.baseVal ?? node.className}> ${node.textContent.slice(0, 40)}`;
  const isShown = node => node.checkVisibility() && node.getClientRects().length > 0;
  const text = node => (node?.textContent ?? '').trim();
  for (const node of document.querySelectorAll('button, input, select, a[href], summary')) {
    if (!isShown(node)) continue;
    counts.controls++;
    const name = node.getAttribute('aria-label') || [...(node.labels ?? [])].map(text).join('') ||
      (node.localName === 'input' || node.localName === 'select' ? '' : text(node));
    if (!name) found.push(`no name: ${about(node)}`);
  }
  for (const node of document.querySelectorAll('img, svg, [role=img]')) {
    if (!isShown(node) || node.closest('[aria-hidden=true]') || node.parentNode.closest('button, [role=img]')) continue;
    counts.images++;
    if (!(node.getAttribute('aria-label') || node.getAttribute('alt') || text(node.querySelector('title'))))
      found.push(`image without text: ${about(node)}`);
  }
  let level = 0;
  for (const node of document.querySelectorAll('h1, h2, h3, h4, h5, h6')) {
    if (!isShown(node)) continue;
    counts.headings++;
    const own = Number(node.localName[1]);
    if (own > level + 1) found.push(`heading skips a level: ${about(node)}`);
    level = own;
  }
  if (document.querySelectorAll('h1').length !== 1) found.push('not one h1');
  if (!document.documentElement.lang) found.push('no language');
  const ids = [...document.querySelectorAll('[id]')].map(node => node.id);
  for (const id of new Set(ids.filter((one, i) => ids.indexOf(one) !== i))) found.push(`id twice: ${id}`);
  for (const node of document.querySelectorAll('*')) {
    const style = getComputedStyle(node);
    if (isShown(node) && /auto|scroll/.test(style.overflowX) && node.scrollWidth > node.clientWidth + 1 &&
        node.tabIndex < 0 && !node.querySelector('a, button, [tabindex="0"]'))
      found.push(`scrolls, but not by keys: ${about(node)}`);
  }
  const colour = words => { const [r, g, b, a = 1] = words.match(/[\d.]+/g).map(Number); return [r, g, b, a]; };
  const over = (top, below) => [0, 1, 2].map(i => top[3] * top[i] + (1 - top[3]) * below[i]);
  const background = node => {
    const layers = [];
    for (let one = node; one; one = one.parentElement) layers.push(colour(getComputedStyle(one).backgroundColor));
    return layers.reverse().reduce((below, layer) => over(layer, below), [255, 255, 255]);
  };
  const luminance = rgb => rgb.map(v => v / 255)
    .map(v => (v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4))
    .reduce((sum, v, i) => sum + v * [0.2126, 0.7152, 0.0722][i], 0);
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  for (let node; (node = walker.nextNode());) {
    const parent = node.parentElement;
    if (!node.textContent.trim() || !isShown(parent) || parent.closest('script, svg, .picture, :disabled, option')) continue;
    const style = getComputedStyle(parent), below = background(parent);
    const [a, b] = [luminance(over(colour(style.color), below)), luminance(below)].sort((x, y) => y - x);
    const size = parseFloat(style.fontSize), large = size >= 24 || (size >= 18.66 && style.fontWeight >= 700);
    counts.texts++;
    if ((a + 0.05) / (b + 0.05) < (large ? 3 : 4.5))
      found.push(`contrast ${((a + 0.05) / (b + 0.05)).toFixed(2)}: ${about(parent)}`);
  }
  const answer = document.createElement('pre');
  answer.id = 'access';
  answer.textContent = JSON.stringify({counts, found: [...new Set(found)]});
  document.body.append(answer);
}, 1500));
"""


@unittest.skipUnless(BROWSER, "no browser")
class Access(InTemporaryFolder):
    def answer(self, page, scheme):
        tested = page.with_name("tested.html")
        tested.write_text(page.read_text().replace("</head>", f"<script>{FIND}</script></head>", 1))
        arguments = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-background-networking"]
        arguments += ["--window-size=1280,9000", "--virtual-time-budget=9000"]
        arguments += [f"--blink-settings=preferredColorScheme={SCHEMES[scheme]}"]
        done = subprocess.run(
            [BROWSER, *arguments, f"--user-data-dir={self.folder / 'profile'}", "--dump-dom", tested.as_uri()],
            capture_output=True,
            text=True,
            timeout=HANGS_AFTER,
        )
        answer = re.search(r'<pre id="access">(.*?)</pre>', done.stdout, re.DOTALL)
        self.assertIsNotNone(answer, done.stderr)
        return json.loads(html.unescape(answer.group(1)))

    def report(self, project, form):
        done = trivet("run", project, "-o", self.folder / "out", "--report", form)
        self.assertEqual(done.returncode, 0, done.stderr)
        return self.folder / "out/report.html"

    def test_reports_have_names_and_contrast_in_both_colour_schemes(self):
        for example in EXAMPLES:
            for form in ("full", "short"):
                page = self.report(SOURCE / f"examples/{example}.toml", form)
                for scheme in SCHEMES:
                    with self.subTest(example=example, form=form, scheme=scheme):
                        answer = self.answer(page, scheme)
                        self.assertEqual(answer["found"], [])
                        for what in ("images", "headings", "texts"):
                            self.assertGreater(answer["counts"][what], 0, what)

    def test_faults_are_found(self):
        page = self.report(SOURCE / "examples/fan/fan.toml", "short")
        faults = (
            "<h5>skipped</h5><button></button><svg width='9' height='9'></svg>"
            "<p style='color:#aaa;background:#fff'>pale</p><p id='speck'>a</p><p id='speck'>b</p>"
            "<div style='overflow:auto;width:9px'><p style='width:99px'>wide</p></div>"
        )
        page.write_text(page.read_text().replace("</main>", faults + "</main>", 1))
        found = " ".join(self.answer(page, "light")["found"])
        for words in ("skips a level", "no name", "without text", "contrast 2.32", "id twice", "not by keys"):
            self.assertIn(words, found)


if __name__ == "__main__":
    unittest.main()
