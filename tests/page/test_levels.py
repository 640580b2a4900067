# SPDX-License-Identifier: BSD-3-Clause
"""Amplitudes are shown at the levels of the command line, and say so: velocities rms, others 0-p."""
import os
import re
import subprocess

from conftest import TRIVET, settled
from test_limits import choose_quantity, judged
from test_play import command


def printed(served, words):
    environment = os.environ | {'COLUMNS': '200'}
    return subprocess.run([TRIVET, words, str(served.file)], capture_output=True, text=True, env=environment).stdout


def test_rows_of_requirements_are_those_of_the_command_line_and_velocities_are_rms(serve):
    served = serve('fan/fan.toml')
    page = served.page()
    judged(page)
    page.get_by_role('tab', name='Requirements').click()
    text = printed(served, 'verdict')
    rows = page.locator('result-tables tbody tr')
    seen = [(r.locator('th').inner_text().strip(), r.locator('td').all_inner_texts()) for r in rows.all()]
    levelled = [(words, cells) for words, cells in seen if ' rms' in words]
    assert levelled
    for words, cells in levelled:
        value = next(c for c in cells if c.endswith(' rms'))
        assert re.search(re.escape(words) + r' +' + re.escape(value) + ' ', text)
    # peaks and the chart
    found = command('curves', served.file, '--quantity', 'velocity')
    levels = {r['unit']: (r['level'], r['level_factor']) for r in found['results']}
    assert levels['m/s'][0] == 'rms' and abs(levels['m/s'][1] * 2**0.5 - 1) < 1e-12 and levels['N'] == ('0-p', 1)
    choose_quantity(page, 'velocity')
    page.get_by_role('tab', name='Peaks').click()
    peak = next(p for p in found['peaks'] if p['result'].startswith('fan.bearing.z') and p['amplitude'])
    rows = page.locator('result-tables tbody tr').filter(has_text=peak['result'])
    shown = [re.search(r'([\d.]+) (m|µ)m/s rms', words).groups() for words in rows.all_inner_texts()]
    values = [float(number) * {'m': 1e-3, 'µ': 1e-6}[prefix] for number, prefix in shown]
    assert any(abs(v * 2**0.5 / peak['amplitude'] - 1) < 1e-3 for v in values)
    page.get_by_label('table', exact=True).check()
    assert 'mm/s rms]' in page.locator('curve-chart caption').inner_text()


def test_the_column_met_is_seen_and_a_limit_is_whole(serve):
    page = serve('compressor/requirements.toml').page((1280, 800))
    judged(page)
    page.get_by_role('tab', name='Requirements').click()
    assert page.locator('#table-panel').evaluate('e => e.scrollWidth <= e.clientWidth')
    assert page.locator('#table-panel input').evaluate_all('all => all.every(e => e.scrollWidth <= e.clientWidth)')
