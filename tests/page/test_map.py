# SPDX-License-Identifier: BSD-3-Clause
"""The map of a file: its point is the design on the page."""
import re

from conftest import settled
from test_accessible import violations
from test_pictures import picture
from test_play import command, computed_frequencies, shown_frequencies

STIFFNESS, DAMPING = 'elements.suspension.scale', 'elements.suspension.damping.proportional'


def map_of(served):
    """The page with its computed map."""
    page = served.page()
    settled(page)
    page.get_by_role('tab', name='Map').click()
    page.locator('map-panel').get_by_text(re.compile('designs meet|longer than a second')).wait_for()
    if page.get_by_role('button', name='Compute the map').count():
        page.get_by_role('button', name='Compute the map').click()
    page.locator('.map').wait_for()
    return page


def design(page):
    """Both numbers of the design on the page."""
    words = page.locator('map-panel').get_by_text('Nearest design of the map').first.inner_text()
    return [float(n) for n in re.match(r'stiffness scale ([\d.]+), δ ([\d.]+) s', words).groups()]


def test_the_best_design_of_the_map_becomes_the_design_on_the_page(serve):
    served = serve('paper/map.toml')
    page = map_of(served)
    assert design(page) == [1, 0.05]
    found = command('map', served.file)
    assert f"{found['kept']} of {found['designs']} designs" in page.locator('map-panel').inner_text()
    page.get_by_role('button', name='best').click()
    settled(page)
    best = [float(f"{found['best'][axis]:.4g}") for axis in 'xy']
    assert design(page) == best
    settings = ['--set', f'{STIFFNESS}={best[0]}', '--set', f'{DAMPING}={best[1]}']
    page.get_by_role('tab', name='Modes').click()
    assert shown_frequencies(page) == computed_frequencies(served.file, *settings)


def test_the_point_is_dragged_one_undo_brings_it_back_and_keys_move_it(serve):
    page = map_of(serve('paper/map.toml'))
    box, point = page.locator('.map').bounding_box(), page.locator('.design').bounding_box()
    at = [point['x'] + point['width'] / 2, point['y'] + point['height'] / 2]
    page.mouse.move(*at)
    page.mouse.down()
    for part in (1, 2, 3, 4):
        page.mouse.move(at[0] + 20 * part, at[1] - 8 * part)
        page.wait_for_timeout(40)
    page.mouse.up()
    settled(page)
    stiffness, damping = design(page)
    plot = box['width'] - 64  # between the margins of the axes
    assert abs(stiffness / (10 / 0.3) ** (80 / plot) - 1) < 0.05 and damping > 0.05
    moved = page.locator('.design').bounding_box()
    assert abs(moved['x'] - point['x'] - 80) < 2 and abs(moved['y'] - point['y'] + 32) < 2
    page.get_by_role('button', name='Undo').click()
    settled(page)
    assert design(page) == [1, 0.05] and page.get_by_role('button', name='Undo').is_disabled()
    page.locator('.map').focus()
    page.keyboard.press('ArrowRight')
    page.keyboard.press('Shift+ArrowUp')
    settled(page)
    stiffness, damping = design(page)
    assert stiffness == float(f'{(10 / 0.3) ** 0.01:.4g}') and damping == float(f'{0.05 * 50 ** 0.1:.4g}')
    assert f'δ {damping:g} s' in page.locator('map-panel [role=status]').inner_text()


def test_the_colours_of_the_rules_are_those_of_the_program_and_axe_finds_no_violation(serve):
    served = serve('paper/map.toml')
    page = map_of(served)
    key = command('map', served.file)['colours']
    shown = page.locator('.rules li:has(rect)')
    assert shown.all_inner_texts() == [one['words'] for one in key]
    assert [shown.nth(i).locator('rect').get_attribute('fill') for i in range(len(key))] == [
        one['colour'] for one in key
    ]
    drawn = {colour: n for n, colour in picture(page.locator('.map')).getcolors(1 << 24)}
    first = tuple(int(key[0]['colour'][i : i + 2], 16) for i in (1, 3, 5))
    assert drawn.get(first, 0) > 1000  # it governs most designs, which violate it
    assert violations(page) == []
