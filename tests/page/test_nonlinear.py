# SPDX-License-Identifier: BSD-3-Clause
"""A nonlinear machine: the page says which numbers are of small motions about rest, and labels the largest steady motion."""
import json
import math
import re
import subprocess

from conftest import TRIVET, settled
from test_limits import choose_quantity

NOTE = 'nonlinear machine: all but static, steady and backbone is for small motions about rest'


def test_small_motions_are_said_to_be_so_and_steady_ones_are_read_at_the_cursor_spoken_and_in_the_table(serve):
    served = serve('isolator/hardening.toml')
    page = served.page()
    settled(page)
    page.locator('.readings').get_by_text(NOTE).wait_for()
    page.get_by_role('tab', name='Peaks').click()
    page.locator('result-tables').get_by_text(NOTE).wait_for()
    page.locator('.readings').get_by_text('thick: steady motion').wait_for()
    printed = json.loads(
        subprocess.run([TRIVET, 'steady', served.file, '--json'], stdout=subprocess.PIPE, check=True).stdout
    )
    motions = [
        (
            p['angular_frequency'] / (2 * math.pi),
            (p['results'][0]['largest'] - p['results'][0]['smallest']) / 2e-3,
            p['stable'],
        )
        for p in printed['points']
    ]
    page.evaluate(f"document.querySelector('page-shell').app.display.set({{cursor: {2 * math.pi * 11.6}}})")
    page.locator('.readings .cursor').wait_for(timeout=3000)  # at once, not at the next move
    page.locator('.plots').press('ArrowRight')
    page.locator('.plots').press('ArrowLeft')
    here = float(page.locator('.readings .cursor').inner_text().split()[0])
    assert abs(here - 11.6) < 0.1
    reading = page.locator('.readings .steady').filter(has_text='machine.z').inner_text()
    found = re.findall(r'([\d.]+) (stable|unstable)(?: at ([\d.]+) Hz)?', reading)
    assert [words for _, words, _ in found] == ['stable', 'unstable', 'stable'], reading
    for value, words, at in found:
        frequency = float(at or here)
        assert abs(frequency - here) < 0.06
        assert any(
            abs(f - frequency) < 6e-3 and abs(y - float(value)) < 6e-3 * y and stable == (words == 'stable')
            for f, y, stable in motions
        ), (value, words, at)
    spoken = page.locator('curve-chart [role=status]').inner_text()
    assert all(f'{value} mm 0-p {words}' in spoken for value, words, _ in found), spoken
    page.get_by_label('table', exact=True).check()
    rows = page.locator('table').filter(has_text='Steady motions').locator('tbody tr').all_inner_texts()
    assert len(rows) >= len(motions)
    for frequency, value, stable in motions[::40]:
        wanted = [f'{frequency:.4g}', f'{value:.3g}', 'stable' if stable else 'unstable']
        assert any(row.split() == wanted for row in rows), wanted
    choose_quantity(page, 'velocity')
    page.locator('.readings').get_by_text('the steady motion is not drawn: it is computed as displacement').wait_for()
