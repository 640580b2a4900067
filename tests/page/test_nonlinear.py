# SPDX-License-Identifier: BSD-3-Clause
"""A nonlinear machine: the page says which numbers are of small motions about rest, and labels the largest steady motion."""
from conftest import settled
from test_limits import choose_quantity

NOTE = 'nonlinear machine: all but static, steady and backbone is for small motions about rest'


def test_the_chart_and_the_peaks_say_that_they_are_of_small_motions(serve):
    page = serve('isolator/hardening.toml').page()
    settled(page)
    page.locator('.readings').get_by_text(NOTE).wait_for()
    page.get_by_role('tab', name='Peaks').click()
    page.locator('result-tables').get_by_text(NOTE).wait_for()
    page.locator('.readings').get_by_text('thick: steady motion').wait_for()
    choose_quantity(page, 'velocity')
    page.locator('.readings').get_by_text('the steady motion is not drawn: it is computed as displacement').wait_for()
