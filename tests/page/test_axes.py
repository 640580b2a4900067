# SPDX-License-Identifier: BSD-3-Clause
"""Logarithmic axes of the chart."""
from conftest import settled
from test_limits import choose_quantity


def test_an_axis_may_begin_just_below_a_power_of_ten(serve):
    page = serve('compressor/requirements.toml').page()
    settled(page)
    choose_quantity(page, 'force')
    for curve in page.locator('.readings button.curve[aria-pressed=true]').all_inner_texts():
        if curve.strip() != 'ground.force.z':
            page.locator('.readings').get_by_role('button', name=curve.strip(), exact=True).click()
    for limit in (0.127, 0.0127):  # the axis begins 1.3 below it, just below a power of ten
        field = page.get_by_label('Limit: ground.force.z', exact=False).first
        field.fill(f'{limit} N')
        field.press('Enter')
        settled(page)
        line = page.get_by_role('slider', name='Limit of ground.force.z', exact=True)
        line.get_by_text(f'{limit} N').wait_for(timeout=10000)
        chart, drawn = page.locator('.amplitude .u-over').bounding_box(), line.bounding_box()
        above_the_end = chart['y'] + chart['height'] - drawn['y'] - drawn['height'] / 2
        assert 0 < above_the_end < 0.2 * chart['height'], limit
