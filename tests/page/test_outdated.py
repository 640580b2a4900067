# SPDX-License-Identifier: BSD-3-Clause
"""While the file has errors, what is drawn is that of its last state without, faded, and says so."""

from conftest import settled
from test_play import set_number

NOTE = 'of the last state without errors'
OPACITY = "place => Number(getComputedStyle(document.querySelector(place + ' canvas')).opacity)"


def notes(page):
    return page.get_by_text(NOTE).count()


def wrong(page):
    page.locator('.problems.error').wait_for()
    settled(page)


def test_results_of_a_file_with_errors_are_faded_and_said_to_be_earlier_ones(serve):
    page = serve('genset/genset.toml').page()
    settled(page)
    assert notes(page) == 0 and page.evaluate(OPACITY, '.stage') == 1
    peaks = page.evaluate("document.querySelector('curve-chart').picture.curves.map(c => c.peaks)")
    set_number(page, 'mass of genset, value', '-5 t')
    wrong(page)
    assert notes(page) == 3  # machine, characteristics, table
    for place in ('.stage', '.amplitude', '.phase'):
        assert page.evaluate(OPACITY, place) < 0.5
    assert page.locator('.plots .missing, .stage .missing').count() == 0
    assert page.get_by_label('Quantity').is_visible()
    assert page.evaluate("document.querySelector('curve-chart').picture.curves.map(c => c.peaks)") == peaks
    assert page.locator('result-tables tbody tr').count() > 0
    page.get_by_role('button', name='Undo').click()
    settled(page)
    assert notes(page) == 0 and page.evaluate(OPACITY, '.stage') == 1


def test_a_text_with_errors_keeps_the_last_results(serve):
    page = serve('genset/genset.toml').page()
    settled(page)
    page.get_by_role('tab', name='Text').click()
    page.locator('text-view .cm-content').click()
    page.keyboard.press('Control+End')
    page.keyboard.type('\nnonsense')
    wrong(page)
    assert notes(page) == 3
    for _ in 'nonsense':
        page.keyboard.press('Backspace')
    page.locator('.problems.error').wait_for(state='detached')
    settled(page)
    assert notes(page) == 0
