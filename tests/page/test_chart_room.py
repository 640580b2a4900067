# SPDX-License-Identifier: BSD-3-Clause
"""The chart stays readable: labels of limits do not cover each other, and other parts do not take its room."""
import itertools

from conftest import drawn, settled
from test_compare import compare

LEAST_HEIGHT = 180  # of the amplitudes [px]
SIX = """
[requirements]
limits = {"frame.x" = "0.2 mm", "frame.y" = "1 mm", "frame.z" = "1 mm", "frame.side bearer.x" = "0.5 mm", "frame.side bearer.y" = "1.1 mm", "frame.side bearer.z" = "1.05 mm"}
"""


def box_of(locator):
    box = locator.bounding_box()
    return box['x'], box['y'], box['x'] + box['width'], box['y'] + box['height']


def overlap(a, b):
    return a[0] < b[2] and a[2] > b[0] and a[1] < b[3] and a[3] > b[1]


def test_labels_of_six_limits_do_not_cover_each_other_and_are_near_their_lines(serve):
    served = serve('bogie/loaded_frame.toml')
    served.file.write_text(served.file.read_text() + SIX)
    page = served.page()
    page.locator('.limit').nth(5).wait_for()
    settled(page)
    for width, height in ((1280, 800), (1920, 1080)):
        page.set_viewport_size({'width': width, 'height': height})
        drawn(page)
        plot, lines = box_of(page.locator('.amplitude .u-over')), page.locator('.limit').all()
        labels = [box_of(line.locator('span')) for line in lines]
        assert len(labels) == 6
        assert not [pair for pair in itertools.combinations(labels, 2) if overlap(*pair)], width
        for line, label in zip(lines, labels, strict=True):
            assert plot[0] <= label[0] and label[2] <= plot[2] + 1
            assert plot[1] - 10 <= label[1] and label[3] <= plot[3] + 1
            _, top, _, bottom = box_of(line)
            assert (
                label[1] - bottom < 50 and top - label[3] < 50
            )  # in the third row at most: peaks have their places first
            assert 'margin' in line.inner_text()


def test_a_label_without_room_is_within_the_chart_when_its_line_has_the_focus(serve):
    served = serve('bogie/loaded_frame.toml')
    many = ', '.join(f'{{limit = "{1 + k / 1000} mm", band = ["{1 + k / 100} Hz", "12 Hz"]}}' for k in range(60))
    served.file.write_text(served.file.read_text() + f'[requirements]\nlimits = {{"frame.z" = [{many}]}}\n')
    page = served.page()
    page.locator('.limit').nth(59).wait_for()
    settled(page)
    plot, unseen = box_of(page.locator('.amplitude .u-over')), page.locator('.limit:has(.unseen)')
    assert unseen.count() > 0
    unseen.first.focus()
    label = box_of(unseen.first.locator('span'))
    assert plot[0] <= label[0] and plot[2] - 2 <= label[2] <= plot[2] + 1  # it ends with its line


def test_with_a_table_and_two_comparisons_the_chart_keeps_its_height_and_the_column_scrolls(serve):
    page = serve('paper/corrected.toml').page()
    settled(page)
    for case in ('case Figure 4', 'case Figure 6'):
        compare(page, case)
    page.locator('curve-chart').get_by_label('table', exact=True).check()
    page.locator('.plots').focus()
    page.keyboard.press('Shift+ArrowRight')  # the readings have their values
    settled(page)
    amplitude, phase = (page.locator(f'{part} .u-over').bounding_box() for part in ('.amplitude', '.phase'))
    assert amplitude['height'] >= LEAST_HEIGHT and phase['height'] > 40
    page.locator('section.right').evaluate('column => column.scrollTo(0, column.scrollHeight)')
    assert box_of(page.locator('result-tables'))[3] <= 800.5  # all of it is reached
    assert page.evaluate('() => document.documentElement.scrollHeight - innerHeight') == 0
