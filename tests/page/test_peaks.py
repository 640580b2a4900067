# SPDX-License-Identifier: BSD-3-Clause
"""Peaks of the chart: the highest have their values, which labels of limits do not cover, and one without end is marked as that."""

import pytest
from conftest import drawn, settled

PEAKS = """() => {
    const {plot, peaks: {peaks}} = document.querySelector('curve-chart').amplitude, {left, top} = plot.over.getBoundingClientRect();
    const ratio = devicePixelRatio, {bbox} = plot;
    return peaks.map(p => ({text: p.text, hasText: p.middle !== null, x: left + (p.left - bbox.left) / ratio, y: top + (p.top - bbox.top) / ratio}));
}"""
LABELS = """() => [...document.querySelectorAll('curve-chart .limit:not([hidden]) span:not(.unseen)')].map(e => {
    const {left, top, right, bottom} = e.getBoundingClientRect();
    return {words: e.textContent, left, top, right, bottom};
})"""
UNDAMPED = """trivet = 1
title = "Undamped"
[bodies.machine]
mass = 400
center_of_mass = [0, 0, 0.25]
inertia = {about = "center_of_mass", xx = 20, yy = 56, zz = 60}
[elements.mount]
type = "bushing"
on = "machine"
at = [0, 0, 0.25]
translation = ["600 N/mm", "600 N/mm", "1200 N/mm"]
rotation = [1e5, 1e5, 1e5]
[excitations.f]
type = "harmonic"
on = "machine"
at = [0, 0, 0.25]
force = [0, 0, 100]
[analyses.response]
band = ["1 Hz", "40 Hz"]
of = ["machine"]
"""


@pytest.mark.parametrize('mounts', ['by their stiffness', 'disc 75x25 40 ShA'])
def test_the_highest_peaks_have_their_values_beside_the_label_of_a_limit(serve, mounts):
    page = serve().page()
    page.get_by_label('Mounts', exact=True).select_option(mounts if mounts.startswith('disc') else '')
    page.get_by_role('button', name='Make it').click()
    settled(page)
    page.locator('curve-chart .limit span').first.wait_for()
    drawn(page)
    for log in (True, False):
        page.get_by_label('log', exact=True).set_checked(log)
        drawn(page)
        peaks, labels = page.evaluate(PEAKS), page.evaluate(LABELS)
        assert len(peaks) >= 3 and labels
        assert all(p['hasText'] for p in sorted(peaks, key=lambda p: p['y'])[:2]), peaks
        for peak in peaks:
            for label in labels:
                beside = not (
                    label['left'] <= peak['x'] <= label['right'] and label['top'] <= peak['y'] <= label['bottom']
                )
                assert beside, (peak, label)


def test_a_peak_without_end_is_marked_at_its_frequency(serve):
    served = serve('genset/genset.toml')
    served.file.write_text(UNDAMPED)
    page = served.page()
    settled(page)
    for log in (True, False):
        page.get_by_label('log', exact=True).set_checked(log)
        drawn(page)
        (mark,) = [p for p in page.evaluate(PEAKS) if p['text'] == '∞']
        assert mark['hasText']
        over = page.locator('.amplitude .u-over').bounding_box()
        frequency = 1 + 39 * (mark['x'] - over['x']) / over['width']
        assert abs(frequency - (1.2e6 / 400) ** 0.5 / 6.283185) < 0.1
    page.locator('.plots').press('Home')
    page.locator('.plots').press('PageDown')
    assert 'machine.z ∞' in page.locator('.readings').inner_text().replace('\n', ' ')
    assert 'machine.z ∞' in page.locator('curve-chart [role=status]').inner_text()
