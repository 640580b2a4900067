# SPDX-License-Identifier: BSD-3-Clause
"""axe finds no violation in any tab, light or dark."""
import pytest

from conftest import ROOT, painted, settled
from test_play import set_number

AXE = ROOT / 'web/node_modules/axe-core/axe.min.js'  # installed by scripts/web


def violations(page):
    if not page.evaluate('() => "axe" in window'):
        page.evaluate(AXE.read_text())
    found = page.evaluate("async () => (await axe.run(document, {resultTypes: ['violations']})).violations")
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
