# SPDX-License-Identifier: BSD-3-Clause
"""axe finds no violation in any tab, light or dark."""
import pytest

from conftest import ROOT, painted, settled
from test_play import set_number

AXE = ROOT / 'web/node_modules/axe-core/axe.min.js'  # installed by scripts/web


# What changed since axe was last asked about this page: parts of it, or all. The class of `main` names the chosen tab.
CHANGED = """() => {
  const PARTS = 'header, .tabs, #left-panel, .middle, curve-chart, result-tables';
  const parts = [...document.querySelectorAll(PARTS)], others = document.documentElement.cloneNode(true);
  for (const part of others.querySelectorAll(PARTS)) part.remove();
  others.querySelector('main')?.removeAttribute('class');
  const now = [others, ...parts].map(part => part.outerHTML), before = window.judged ?? [];
  window.judged = now;
  if (now[0] !== before[0] || now.length !== before.length) return document;
  return {include: parts.filter((_, i) => now[i + 1] !== before[i + 1])};
}"""


def violations(page):
    """The first time of the whole page; then in what changed since the last time, but rules about a document as a whole."""
    if not page.evaluate('() => "axe" in window'):
        page.evaluate(AXE.read_text())
    found = page.evaluate(f"async () => (await axe.run(({CHANGED})(), {{resultTypes: ['violations']}})).violations")
    return [f"{v['id']}: {node['html'][:160]} {node['failureSummary'][:300]}" for v in found for node in v['nodes']]


@pytest.mark.parametrize('example', ['compressor/requirements.toml', 'genset/genset.toml'])  # genset hides curves
@pytest.mark.parametrize('theme', ['light', 'dark'])
def test_no_violation(serve, theme, example):
    page = serve(example).page(theme=theme)
    settled(page)
    page.get_by_role('checkbox', name='table').check()
    for tab in ('Modes', 'Requirements', 'Mounts', 'Peaks'):
        page.get_by_role('tab', name=tab).click()
        assert violations(page) == []
    for tab in ('Model', 'Text', 'Sliders'):
        page.get_by_role('tab', name=tab, exact=True).click()
        painted(page)
        assert violations(page) == []


def test_no_violation_while_the_file_has_errors(serve):
    page = serve('compressor/requirements.toml').page()
    settled(page)
    set_number(page, 'mass of compressor, value', '-3 t')
    page.locator('.outdated-note').first.wait_for()
    assert violations(page) == []


def test_no_violation_without_a_file(serve):
    page = serve().page()
    page.locator('.examples button').first.wait_for()
    assert violations(page) == []
