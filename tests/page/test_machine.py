# SPDX-License-Identifier: BSD-3-Clause
"""The middle of the page: ghosts and screw axes."""
import re

from conftest import settled
from test_pictures import assert_alive, picture, share_changed
from test_play import command


def choose(page, label, value):
    page.get_by_label(label, exact=True).select_option(value)
    page.wait_for_timeout(300)


def test_ghosts_and_flashes_stand_beside_the_moving_machine(serve):
    page = serve('bogie/loaded_frame.toml').page()
    settled(page)
    stage, edges = page.locator('.stage'), picture(page.locator('.stage'))
    choose(page, 'Motion against', 'rest')
    rest = picture(stage)
    assert share_changed(edges, rest) > 0.005
    choose(page, 'Motion against', 'strobe')
    assert share_changed(rest, picture(stage)) > 0.003
    choose(page, 'Motion against', 'edges')
    assert share_changed(edges, picture(stage)) == 0  # nothing is left behind
    assert_alive(page)


def test_the_screw_axis_of_a_selected_body_is_that_of_the_mode(serve):
    served = serve('genset/genset.toml')
    page = served.page()
    settled(page)
    page.locator('.stage').focus()
    page.keyboard.press('s')  # selects the first body
    hover, stage = page.locator('.hover'), page.locator('.stage')
    hover.get_by_text('screw axis').wait_for()
    shown, prefix = re.search(r'pitch ([−\d.]+) ([mµ]?)m/rad', hover.inner_text()).groups()
    pitch = command('modes', served.file)['modes'][0]['screws'][0]['pitch']
    assert abs(float(shown.replace('−', '-')) * {'': 1, 'm': 1e-3, 'µ': 1e-6}[prefix] / pitch - 1) < 5e-3
    page.wait_for_timeout(300)
    with_axis = picture(stage)
    page.get_by_label('Motion', exact=True).select_option('rest')  # no motion, no axis
    page.wait_for_timeout(300)
    assert 'axis' not in hover.inner_text()
    assert share_changed(with_axis, picture(stage)) > 0.001
    assert_alive(page)
