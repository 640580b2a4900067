# SPDX-License-Identifier: BSD-3-Clause
"""What the program computes is on the page if it takes longer than a moment."""
import json
import time

from conftest import settled, unanswered
from test_play import set_number


def test_what_takes_long_is_named(serve):
    served = serve('genset/genset.toml')
    page = served.page()
    settled(page)
    assert page.locator('progress-line').inner_text() == ''
    served.requests.clear()
    page.wait_for_timeout(1000)  # the page asks every half second while a question takes long
    assert not any(address.endswith('/progress') for address in served.requests)
    page.route('**/progress', lambda route: route.fulfill(json={'task': 'boundary', 'fraction': 0.42}))
    with unanswered(page):
        set_number(page, 'mass of genset, value', '4500 kg')
        page.locator('progress-line').get_by_text('Computing: boundary 42 %').wait_for()
    settled(page)
    page.wait_for_function("() => !document.querySelector('progress-line').textContent.trim()")


def test_two_tabs_compute_side_by_side(serve):
    """The map of one tab, asked by its own question, does not delay the sliders of the other one."""
    served = serve('paper/map.toml')
    first, second = served.page(), served.page()
    settled(first)
    settled(second)
    body = json.dumps({'wants': [{'command': 'map', 'keys': {'points': '3000'}}]})
    first.evaluate(
        """body => { window.map = fetch('/ask', {method: 'POST', body, headers: {'Content-Type': 'application/json',
        'X-Trivet-Token': sessionStorage.getItem('token'), 'X-Trivet-Client': 'map'}}).then(() => { window.mapped = true; }); }""",
        body,
    )
    began = time.monotonic()
    field = second.locator('.sliders input.number').first
    number, *unit = field.input_value().split(' ')
    field.fill(' '.join([f'{1.1 * float(number):.5g}', *unit]))
    field.press('Enter')
    settled(second)
    assert time.monotonic() - began < 20 and not first.evaluate('() => window.mapped === true')
