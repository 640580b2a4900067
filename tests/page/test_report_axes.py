# SPDX-License-Identifier: BSD-3-Clause
"""Axes of amplitudes in a report: chosen by the program, by its rule for a part of the band, and by the reader."""
import subprocess

import pytest

from conftest import ROOT, TRIVET, complaints


@pytest.fixture
def report(browser, tmp_path):
    command = [TRIVET, 'run', str(ROOT / 'examples/fan/fan.toml'), '-o', str(tmp_path / 'out')]
    subprocess.run(command, check=True, capture_output=True)
    page = browser.new_page(viewport={'width': 1280, 'height': 800})
    messages = []
    page.on('console', lambda message: messages.append(message.text))
    page.on('pageerror', lambda error: messages.append(str(error)))
    page.goto((tmp_path / 'out/report.html').as_uri())
    page.locator('.picture').first.wait_for(state='attached')
    yield page
    page.close()
    assert complaints(messages) == []


def axes(page):
    """Which charts of amplitudes are logarithmic: 'all', 'some' or 'none'."""
    box = page.locator('#ylog')
    if box.evaluate('box => box.indeterminate'):
        return 'some'
    return 'all' if box.is_checked() else 'none'


def zoom(page, start, end):
    page.locator('#from').fill(str(start))
    page.locator('#to').fill(str(end))
    page.locator('#to').press('Enter')


def test_each_chart_has_the_axis_of_the_program_and_a_zoomed_one_by_the_same_rule(report):
    assert axes(report) == 'some'  # displacements fall by more than two decades, rotations do not
    zoom(report, 10, 20)  # above all resonances, where they fall slowly
    assert axes(report) == 'none'
    zoom(report, 1, 8)
    assert axes(report) == 'all'
    report.locator('#unzoom').click()
    assert axes(report) == 'some'
    for choice in ('none', 'all'):
        report.locator('#ylog').click()
        assert axes(report) == choice
