# SPDX-License-Identifier: BSD-3-Clause
"""Sliders of a file without [parameters]: the first step of each is a machine that is possible."""

import pytest
from conftest import settled


def steps_without_errors(page):
    settled(page)
    sliders = page.locator('slider-panel input[type=range]')
    assert sliders.count() > 0
    for i in range(sliders.count()):
        for key in ('ArrowRight', 'PageUp', 'PageUp'):
            sliders.nth(i).press(key)
            settled(page)
            assert page.locator('.problems.error').count() == 0, (page.locator('slider-panel').inner_text(), key)
    return page.locator('slider-panel li > label > span').all_inner_texts()


@pytest.mark.parametrize(
    'example', ['bogie/loaded_frame.toml', 'paper/corrected.toml', 'rubber_mounts/compressor.toml', 'fan/fan.toml']
)
def test_every_step_of_a_slider_gives_a_machine(serve, example):
    names = steps_without_errors(serve(example).page())
    assert not any('damper' in name for name in names)


def test_a_slider_of_a_preloaded_spring_moves_the_modes_and_is_saved(serve):
    served = serve('bogie/loaded_frame.toml')
    page = served.page()
    settled(page)
    frequency = page.locator('result-tables tbody tr td').first
    before = frequency.inner_text()
    field = page.get_by_label('stiffness of spring front left, value')
    field.fill('0.5')
    field.press('Enter')
    settled(page)
    assert float(frequency.inner_text()) < float(before)
    page.get_by_role('button', name='Save').click()
    page.get_by_text('Saved').wait_for()
    assert 'stiffness_factor' in served.file.read_text()


def test_the_mass_of_the_form_is_a_slider(serve):
    page = serve().page()
    page.get_by_role('button', name='Make it').click()
    assert steps_without_errors(page) == ['stiffness of mount', 'mass of machine']
