# SPDX-License-Identifier: BSD-3-Clause
"""The middle of the page: with what the moving machine is compared."""
from conftest import settled
from test_pictures import assert_alive, picture, share_changed


def choose(page, label, value):
    page.get_by_label(label, exact=True).select_option(value)
    page.wait_for_timeout(300)


def test_ghosts_and_flashes_stand_beside_the_moving_machine(serve):
    page = serve('bogie/loaded_frame.toml').page()
    settled(page)
    stage, edges = page.locator('.stage'), picture(page.locator('.stage'))
    choose(page, 'Compared with', 'rest')
    rest = picture(stage)
    assert share_changed(edges, rest) > 0.005
    choose(page, 'Compared with', 'strobe')
    assert share_changed(rest, picture(stage)) > 0.003
    choose(page, 'Compared with', 'edges')
    assert share_changed(edges, picture(stage)) == 0  # nothing is left behind
    assert_alive(page)
