# SPDX-License-Identifier: BSD-3-Clause
"""The share of machines within the tolerances that meet all requirements, and the bands of their amplitudes: those of
`trivet sample`."""
import re

import pytest
from conftest import settled
from test_accessible import violations
from test_pictures import picture
from test_play import command, set_number

FEW = '--set', 'analyses.sample.designs=1024'
STIFFNESS = 'stiffness of suspension'
SAMPLE = "name => document.querySelector('yield-pill').app.sampler.result(name)"
BANDS = """() => {
  const {picture} = document.querySelector('curve-chart');
  return picture.overlays.filter(o => o.kind === 'band').map(({name, points, upper}) => ({
    name, omega: points.map(p => 2 * Math.PI * p[0]),
    low: points.map(p => p[1] / picture.scale.factor), high: upper.map(p => p[1] / picture.scale.factor)}));
}"""


def opened(serve):
    served = serve('paper/robust.toml')
    served.file.write_text(served.file.read_text().replace('designs = 100_000', 'designs = 20_000'))
    return served


def sampled(page, designs='20,000'):
    """What the page says of the yield, once so many designs are judged of the present numbers."""
    page.wait_for_function(
        """designs => {
          const {textContent: words} = document.querySelector('yield-pill');
          return words.includes(`${designs} designs`) && !words.includes('…', words.indexOf('designs'));
        }""",
        arg=designs,
    )
    return page.locator('yield-pill').inner_text()


def assert_states(words, program):
    """ "yield 94.9 % 93.3 % … 96.4 %, 1,024 designs": the numbers of the program, the interval rounded outwards."""
    share, low, high = re.match(r'yield ([\d.]+) %\s+([\d.]+) % … ([\d.]+) %', words).groups()
    place = 10.0 ** -len(share.partition('.')[2])
    for shown, exact in ((share, program['share']), (low, program['from']), (high, program['to'])):
        assert abs(float(shown) - 100 * exact) <= place, (words, program)
    assert float(low) <= 100 * program['from'] and float(high) >= 100 * program['to']


def test_the_yield_follows_a_slider_and_is_that_of_the_program(serve):
    served = opened(serve)
    page = served.page()
    settled(page)
    words, found = sampled(page), command('sample', served.file)
    assert page.evaluate(SAMPLE, 'sample') == found  # the whole document
    assert_states(words, found['yield'])
    page.get_by_role('slider', name='mass of aggregate').focus()
    seen = set()
    for _ in range(300):  # the few designs of the numbers on the way; a busy machine judges two samples a second
        page.keyboard.press('ArrowLeft')
        page.wait_for_timeout(40)
        seen.add(page.locator('yield-pill').inner_text().split('%')[0])
        if len(seen) > 3:
            break
    assert len(seen) > 3 and '1,024 designs' in page.locator('yield-pill').inner_text(), seen
    set_number(page, f'{STIFFNESS}, value', '5.5')
    sampled(page)
    page.get_by_role('button', name='Save').click()
    page.get_by_text('robust.toml is saved.').wait_for()
    assert 'scale = 5.5' in served.file.read_text()
    saved = command('sample', served.file)
    assert saved['yield'] != found['yield'] and page.evaluate(SAMPLE, 'sample')['yield'] == saved['yield']
    assert_states(sampled(page), saved['yield'])
    assert page.evaluate(SAMPLE, 'few designs') == command('sample', served.file, *FEW)
    assert violations(page) == []


def test_bands_are_those_of_the_program_and_follow_a_slider(serve):
    served = opened(serve)
    page = served.page()
    settled(page)
    sampled(page)

    def drawn(*settings):
        (band,), (found,) = page.evaluate(BANDS), command('sample', served.file, *settings)['bands'][0]['results']
        assert band['name'] == found['result'] == 'aggregate.y'
        for mine, program in (('omega', 'angular_frequency'), ('low', 'low'), ('high', 'high')):
            assert band[mine] == pytest.approx(found[program])
        return band

    first = drawn()
    page.locator('.plots').focus()
    for _ in range(30):
        page.keyboard.press('ArrowRight')
    legend = page.locator('.readings .curve', has_text='5 … 95 % of 20,000 designs')
    low, high = (float(n) for n in re.search(r'aggregate.y\s+([\d.]+) … ([\d.]+)', legend.inner_text()).groups())
    assert 0 < low < high
    set_number(page, f'{STIFFNESS}, value', '5')
    sampled(page)
    settled(page)
    assert drawn('--set', 'elements.suspension.scale=5') != first
    with_band = picture(page.locator('.amplitude'))
    page.locator('.readings button.curve', has_text='aggregate.y').click()
    settled(page)
    assert page.evaluate(BANDS) == [] and picture(page.locator('.amplitude')) != with_band


def test_a_file_without_tolerances_has_no_yield(serve):
    page = serve('genset/genset.toml').page()
    settled(page)
    page.wait_for_timeout(300)
    assert page.locator('yield-pill').inner_text() == ''


def test_a_file_with_errors_has_no_yield(serve):
    """A tolerance of a number that the file does not have is an error of the file."""
    served = opened(serve)
    page = served.page()
    settled(page)
    sampled(page)
    page.get_by_role('tab', name='Text').click()
    page.locator('.cm-content').click()
    page.keyboard.press('Control+End')
    page.keyboard.type('\n[tolerances.x]\npath = "bodies.aggregate.size"\nhalf_width = "1 %"\n')
    page.get_by_text('error in the file').first.wait_for()
    assert page.locator('yield-pill').inner_text() == ''
