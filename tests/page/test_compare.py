# SPDX-License-Identifier: BSD-3-Clause
"""What is drawn beside the curves: other cases, three springs, measurements, kept curves."""
import json
import math
import re

from conftest import settled
from test_pictures import picture, share_changed
from test_play import command, set_number


def watched(page):
    """The questions that the page asks from now on."""
    asked = []
    page.on('request', lambda r: asked.append(json.loads(r.post_data)) if r.url.endswith('/ask') else None)
    return asked


def compare(page, words, on=True):
    page.locator('.menu summary').click()
    page.locator('.menu').get_by_label(words, exact=True).set_checked(on)
    page.locator('.menu summary').click()
    settled(page)


def test_another_case_is_drawn_beside_the_shown_one_and_follows_the_sliders(serve):
    page = serve('compressor/requirements.toml').page()
    settled(page)
    asked, alone = watched(page), picture(page.locator('.amplitude'))
    compare(page, 'case cold')
    assert asked[-1]['case'] == 'cold' and [w['command'] for w in asked[-1]['wants']] == ['curves']
    assert share_changed(alone, picture(page.locator('.amplitude'))) > 0.001
    assert 'case cold' in page.locator('.readings').inner_text()
    set_number(page, 'mass of compressor, value', '300 kg')
    page.wait_for_function("() => document.querySelector('.readings').textContent.includes('…')")
    settled(page)
    cold = [q for q in asked if q['case'] == 'cold']
    assert cold[0]['settings'] == [] and cold[-1]['settings'] == ['bodies.compressor.mass = "300 kg"']
    compare(page, 'case cold', False)
    assert 'case cold' not in page.locator('.readings').inner_text()


def test_what_is_compared_has_its_values_at_the_cursor_in_the_readings_and_in_words(serve):
    served = serve('compressor/requirements.toml')
    page = served.page()
    settled(page)
    compare(page, 'case cold')
    page.locator('.plots').focus()
    page.keyboard.press('Home')
    page.keyboard.press('Shift+ArrowRight')
    reading = page.locator('.readings .curve', has_text='case cold')
    page.wait_for_function("() => [...document.querySelectorAll('.readings .curve b')].length > 6")
    at = float(page.locator('.readings .cursor').inner_text().split()[0])
    name, shown = re.search(r'case cold: (\S+) ([\d.]+), .* µm 0-p$', reading.inner_text()).groups()
    found = command('response', served.file, '--case', 'cold', '--at', f'{at} Hz')
    amplitude = math.hypot(*next(c for c in found['results'] if c['name'] == name)['complex'][0])
    assert abs(1e6 * amplitude / float(shown) - 1) < 0.02
    spoken = page.locator('curve-chart [role=status]').inner_text()
    assert f'; case cold: {name} {shown} µm 0-p' in spoken


def test_the_machine_on_three_springs_is_drawn_beside_it(serve):
    page = serve('three_coil_springs/machine.toml').page()
    settled(page)
    asked, alone = watched(page), picture(page.locator('.amplitude'))
    compare(page, 'mounts as three springs')
    assert asked[-1]['wants'] == [{'command': 'curves', 'keys': {'three-springs': True}}]
    assert share_changed(alone, picture(page.locator('.amplitude'))) > 0.001


def test_measured_values_are_drawn_until_they_are_put_away(serve):
    page = serve('measured_response/machine.toml').page()
    settled(page)
    assert 'measured' in page.locator('.readings').inner_text()
    dots = picture(page.locator('.amplitude'))
    compare(page, 'measured', False)
    assert 'measured' not in page.locator('.readings').inner_text()
    assert share_changed(dots, picture(page.locator('.amplitude'))) > 0.005


def test_kept_curves_stay_where_they_are_while_a_slider_moves(serve):
    page = serve('genset/genset.toml').page()
    settled(page)
    compare(page, 'keep these curves')
    assert 'kept' in page.locator('.readings').inner_text()
    set_number(page, 'mass of genset, value', '5000 kg')
    settled(page)
    both = picture(page.locator('.amplitude'))
    compare(page, 'keep these curves', False)
    assert share_changed(both, picture(page.locator('.amplitude'))) > 0.001


def test_the_menu_closes_at_escape_and_is_whole_on_a_narrow_page(serve):
    page = serve('compressor/requirements.toml').page((390, 844))
    settled(page)
    assert page.evaluate('() => document.body.scrollWidth') == 390
    menu = page.locator('.menu')
    menu.locator('summary').click()
    box = menu.locator('div').bounding_box()
    assert box['x'] >= 0 and box['x'] + box['width'] <= 390
    menu.get_by_label('case cold', exact=True).focus()
    page.keyboard.press('Escape')
    assert menu.get_attribute('open') is None
    assert page.evaluate('() => document.activeElement.tagName') == 'SUMMARY'
