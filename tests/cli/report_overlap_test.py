# SPDX-License-Identifier: BSD-3-Clause
"""In a browser, on a wide and on a narrow screen: no label of a picture lies on another or leaves its picture, no mark of a
mode on a peak, no cell is squeezed to one word a line, and no page is wider than its window."""
import html
import json
import os
import re
import shutil
import subprocess
import unittest

from trivet_test import HANGS_AFTER, SOURCE, InTemporaryFolder, trivet

BROWSER = os.environ.get("TRIVET_BROWSER") or shutil.which("chromium") or shutil.which("google-chrome")
EXAMPLES = (
    "genset/genset",
    "fan/fan",
    "paper/corrected",
    "optical_table/table",
    "roll_stop/idle",
    "bogie/loaded_frame",
    "isolator/hardening",
    "microscope/microscope",
    "compressor/requirements",  # several cases: the overview of their curves
)
WIDTHS = (1280, 390)
# Boxes of texts; of slanted ones only the centre is known to be covered.
MEASURE = r"""
addEventListener('load', () => setTimeout(() => {
  const found = [], most = 1.5;  // pixels of the picture: boxes of letters are higher than their ink
  const words = node => node.textContent.trim();
  const covered = (a, b) => Math.min(Math.min(a.right, b.right) - Math.max(a.left, b.left),
                                     Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top));
  const isSlanted = node => /rotate\((?!-?90[ ,)])/.test(node.getAttribute('transform') ?? '');
  let measured = 0;
  const check = (name, nodes, room, scale) => {
    const boxes = nodes.map(node => node.getBoundingClientRect());
    nodes.forEach((node, i) => {
      const box = boxes[i];
      if (!box.width) return;
      measured++;
      for (let j = 0; j < i; j++)
        if (boxes[j].width && covered(box, boxes[j]) > most * scale)
          found.push(`${name}: "${words(nodes[j])}" and "${words(node)}" overlap`);
      if (room && (box.left < room.left - 1 || box.right > room.right + 1 || box.top < room.top - 1 ||
                   box.bottom > room.bottom + 1))
        found.push(`${name}: "${words(node)}" leaves the picture`);
    });
  };
  for (const svg of document.querySelectorAll('figure svg')) {
    const room = svg.getBoundingClientRect();
    if (!room.width) continue;
    const texts = [...svg.querySelectorAll('text')].filter(node => words(node) && !isSlanted(node));
    const name = svg.querySelector('title').textContent, scale = room.width / svg.viewBox.baseVal.width;
    check(name, texts, room, scale);
    // Curves on words and boxes of words: only marks in a curve's panel, which have a halo, may lie on one.
    const sheets = [...svg.querySelectorAll('rect[fill=white]')].filter(one => one.parentNode === svg && one.getBoundingClientRect().width < 0.9 * room.width);
    const solid = [...texts.filter(node => !node.hasAttribute('paint-order')), ...sheets].map(node => [node, node.getBoundingClientRect()]);
    for (const curve of svg.querySelectorAll('polyline')) {
      const length = curve.getTotalLength(), matrix = curve.getScreenCTM(), hidden = new Set();
      for (let at = 0; at <= length; at += 3) {
        const {x, y} = curve.getPointAtLength(at).matrixTransform(matrix), edge = most * scale;
        for (const [node, box] of solid)
          if (x > box.left + edge && x < box.right - edge && y > box.top + edge && y < box.bottom - edge) hidden.add(node);
      }
      for (const node of hidden) found.push(`${name}: a curve lies on ${node.tagName} "${words(node)}"`);
    }
  }
  for (const marks of document.querySelectorAll('.marks')) check('marks', [...marks.querySelectorAll('b')], null, 1);
  for (const marks of document.querySelectorAll('.marks'))
    for (const mode of marks.querySelectorAll('.mode'))
      for (const peak of marks.querySelectorAll('.peak'))
        if (covered(mode.getBoundingClientRect(), peak.getBoundingClientRect()) > 5)  // beyond the ring that is drawn
          found.push(`the mark of a mode covers the peak "${peak.title}"`);
  for (const cell of document.querySelectorAll('.scroll > table :is(td, th)')) {
    const range = document.createRange(), {width} = cell.getBoundingClientRect();
    range.selectNodeContents(cell);
    const lines = range.getBoundingClientRect().height / parseFloat(getComputedStyle(cell).lineHeight);
    const isHidden = cell.closest('thead') && getComputedStyle(cell.closest('thead')).clipPath !== 'none';
    if (!isHidden && lines > 3.5 && width < 110)
      found.push(`the cell "${words(cell)}" has ${Math.round(lines)} lines of ${Math.round(width)} px`);
  }
  for (const cell of document.querySelectorAll('td[data-heading]')) {
    const style = getComputedStyle(cell, '::before'), probe = document.createElement('span');
    if (style.content === 'none') continue;
    probe.textContent = cell.dataset.heading;
    for (const key of ['display', 'width', 'font', 'whiteSpace', 'overflowWrap']) probe.style[key] = style[key];
    cell.append(probe);
    if (probe.scrollWidth > probe.clientWidth + 1)
      found.push(`the heading "${cell.dataset.heading}" lies on its value`);
    probe.remove();
  }
  for (const {parentNode: part} of document.querySelectorAll('table.records'))
    if (innerWidth <= 640 && part.scrollWidth > part.clientWidth + 1)
      found.push(`${part.closest('section').querySelector('h2').textContent}: the records are ${part.scrollWidth} px wide`);
  for (const drawing of document.querySelectorAll('.drawing')) {
    const [svg] = [...drawing.querySelectorAll('svg')].filter(one => one.getBoundingClientRect().width);
    const {width} = svg.getBoundingClientRect(), letters = 11 * width / svg.viewBox.baseVal.width;
    if (drawing.querySelector('.scroll').scrollWidth > document.documentElement.clientWidth || letters < 9)
      found.push(`the drawing of the machine is ${width} px wide, with letters of ${letters.toFixed(1)} px`);
  }
  const filters = new Set([...document.querySelectorAll('.legend svg, .picture')].map(one => getComputedStyle(one).filter));
  if (filters.size > 1) found.push('curves and their legend differ in colour');
  const wide = document.documentElement.scrollWidth - document.documentElement.clientWidth;
  if (wide > 0) found.push(`the page is ${wide} px wider than the window`);
  const marks = document.getElementById('marks').textContent;
  parent.postMessage({width: innerWidth, measured, found, marks}, '*');
}, 1500));
"""
FRAME = '<iframe src="measured.html" style="width:{width}px;height:9000px;border:0"></iframe>'
ANSWERS = """<pre id="answers"></pre><script>
const answers = {};
onmessage = ({data}) => {
  answers[data.width] = data;
  document.getElementById('answers').textContent = JSON.stringify(answers);
};
</script>"""


@unittest.skipUnless(BROWSER, "no browser")
class Overlaps(InTemporaryFolder):
    def answers(self, page, widths, scheme="1"):
        """Of the page in a frame of each width: windows have a least one."""
        page.with_name("measured.html").write_text(
            page.read_text().replace("</head>", f"<script>{MEASURE}</script></head>", 1)
        )
        frame = page.with_name("frame.html")
        frame.write_text(ANSWERS + "".join(FRAME.format(width=width) for width in widths))
        arguments = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-background-networking"]
        arguments += [f"--blink-settings=preferredColorScheme={scheme}"]
        arguments += ["--window-size=1400,9000", "--virtual-time-budget=9000", "--allow-file-access-from-files"]
        done = subprocess.run(
            [BROWSER, *arguments, f"--user-data-dir={self.folder / 'profile'}", "--dump-dom", frame.as_uri()],
            capture_output=True,
            text=True,
            timeout=HANGS_AFTER,
        )
        text = re.search(r'<pre id="answers">(.*?)</pre>', done.stdout, re.DOTALL)
        self.assertTrue(text and text[1], done.stderr[-2000:])
        answers = json.loads(html.unescape(text[1]))
        self.assertEqual(sorted(answers), sorted(map(str, widths)))
        return answers

    def test_labels_lie_beside_each_other(self):
        for example in EXAMPLES:
            target = self.folder / example.replace("/", "-")
            done = trivet("run", SOURCE / f"examples/{example}.toml", "-o", target)
            self.assertIn(done.returncode, (0, 1), done.stderr)
            for width, answer in self.answers(target / "report.html", WIDTHS).items():
                with self.subTest(example=example, width=width):
                    self.assertEqual(answer["found"], [])
                    self.assertGreater(answer["measured"], 10)

    def test_a_legend_in_the_dark_has_the_colours_of_its_curves_and_explains_only_marks_that_are_drawn(self):
        """The fan has modes and no peaks."""
        target = self.folder / "fan"
        trivet("run", SOURCE / "examples/fan/fan.toml", "-o", target)
        answer = self.answers(target / "report.html", (1280,), scheme="0")["1280"]
        self.assertEqual(answer["found"], [])
        self.assertEqual(answer["marks"], "Grey ticks on the upper edge: undamped natural frequencies.")


if __name__ == "__main__":
    unittest.main()
