# SPDX-License-Identifier: BSD-3-Clause
"""Limits over frequency: moved as a whole in the chart, in the text by one factor; the margin is that of the program."""
import re

import pytest
from conftest import settled
from test_limits import choose_quantity, judged, margin_on
from test_play import changed_lines, command

LINE = 'Limit of genset.turbocharger.y'
# of the amplitudes on the axis, so many px above the line and at it
FACTOR = """up => {
  const {plot, picture} = document.querySelector('curve-chart').amplitude, {y} = picture.limits.find(limit => limit.isLine);
  return plot.posToVal(plot.valToPos(y, 'y') - up, 'y') / y;
}"""


def opened(served):
    page = served.page()
    settled(page)
    choose_quantity(page, 'velocity')
    return page, page.get_by_role('slider', name=LINE, exact=True)


def levels(text):
    return [float(level) for level in re.findall(r'\[\d+, ([\d.e-]+)\]', text.split('vibration severity')[1])]


def margin(file):
    (line,) = [r for r in command('verdict', file)['cases'][0]['requirements'] if r['kind'] == 'limit_line']
    return float(f"{line['margin']:.3g}")


def test_a_dragged_line_is_one_change_of_all_its_levels(serve):
    served = serve('genset/genset.toml')
    served.file.write_text(served.file.read_text().replace('[60, 2e-3]', '[60, 1e-3]'))
    before = served.file.read_text()
    page, line = opened(served)
    assert margin_on(line) == margin(served.file) and 'violated' in line.get_attribute('class')
    box = line.bounding_box()
    x, y = box['x'] + box['width'] / 2, box['y'] + box['height'] / 2
    factor = page.evaluate(FACTOR, 20)
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x, y - 10)
    page.mouse.move(x, y - 20)
    line.get_by_text('…').wait_for()
    page.mouse.up()
    judged(page)
    page.get_by_role('button', name='Save').click()
    page.get_by_text('genset.toml is saved.').wait_for()
    after = served.file.read_text()
    first, second = levels(after)
    assert len(changed_lines(before, after)) == 2 and factor > 1.05
    assert [first, second] == [float(f'{level * factor:.3g}') for level in (2e-3, 1e-3)]
    assert margin_on(line) == margin(served.file)
    page.get_by_role('button', name='Undo').click()  # the drag is one step
    page.get_by_role('button', name='Save').click()
    page.wait_for_function("() => document.querySelector('page-shell').app.state.isSaved")
    assert served.file.read_text() == before


def test_a_line_moves_by_keyboard_until_it_is_met(serve):
    served = serve('genset/genset.toml')
    page, line = opened(served)
    line.focus()
    while 'violated' in line.get_attribute('class'):
        page.keyboard.press('PageUp')
        judged(page)
    assert page.evaluate("() => document.activeElement.getAttribute('aria-label')") == LINE
    page.get_by_role('button', name='Save').click()
    page.get_by_text('genset.toml is saved.').wait_for()
    assert levels(served.file.read_text()) == [3.54e-3] * 2  # six times 1.1, of three digits each
    assert margin_on(line) == margin(served.file) > 1


def test_a_published_line_cannot_be_dragged_and_says_why(serve):
    """It is of levels in third octaves: listed with its margin, not drawn beside curves of single frequencies."""
    served = serve('microscope/microscope.toml')
    hand = '[excitations.hand]\ntype = "harmonic"\non = "table"\nat = [0, 0, 0]\nforce = [1, 1, 1]\n'
    response = (
        'response = {band = ["1 Hz", "80 Hz"], of = ["table.objective"], quantity = "velocity", excitations = ["hand"]}'
    )
    served.file.write_text(served.file.read_text().replace('modes = {}', f'modes = {{}}\n{response}', 1) + hand)
    page = served.page()
    judged(page)
    found = [r for r in command('verdict', served.file)['cases'][0]['requirements'] if r['kind'] == 'band_line']
    assert len(found) == 3 and page.locator('.limit').count() == 0
    reasons = page.locator('.readings summary', has_text='limits are not drawn')
    reasons.click()
    listed = page.locator('.readings').inner_text()
    for one in found:
        words = f"{one['shown_requirement']} ({one['shown_value']}, margin {one['margin']:.3g})"
        assert 'VC-E along' in words
        assert f'{words}: it limits the levels in bands of frequencies, of which no curve is drawn' in listed, listed
    reasons.click()
    page.get_by_role('tab', name='Requirements').click()
    rows = page.locator('result-tables tbody tr', has_text='VC-E along')
    assert rows.count() == 3 and rows.locator('input').count() == 0  # nor is its number edited there
    box = page.locator('.amplitude .u-over').bounding_box()
    for down in (0.1, 0.3, 0.5, 0.7, 0.9):  # nothing in the chart takes hold of it
        page.mouse.move(box['x'] + box['width'] / 2, box['y'] + down * box['height'])
        page.mouse.down()
        page.mouse.move(box['x'] + box['width'] / 2, box['y'] + down * box['height'] + 12)
        page.mouse.up()
    settled(page)
    assert page.get_by_role('button', name='Save').is_disabled()
    assert page.get_by_role('button', name='Undo').is_disabled()


def test_a_line_of_another_file_stays_and_says_why(serve):
    served = serve('genset/genset.toml')
    served.file.write_text(served.file.read_text().replace('rows = [[10, 2e-3], [60, 2e-3]]', 'file = "line.csv"'))
    served.file.with_name('line.csv').write_text('frequency_hz,limit\n10,2e-3\n60,2e-3\n')
    page, line = opened(served)
    assert line.get_attribute('aria-disabled') == 'true' and 'cannot be moved here' in line.get_attribute('title')
    before = line.bounding_box()
    line.press('PageUp')
    settled(page)
    assert line.bounding_box() == before and page.get_by_role('button', name='Save').is_disabled()
