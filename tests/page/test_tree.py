# SPDX-License-Identifier: BSD-3-Clause
"""The model as a tree: each number is readable, and has a name of its own."""

import collections

import pytest
from conftest import painted, settled

FIELDS = '[...document.querySelectorAll("model-tree input")]'


def opened_tree(page):
    settled(page)
    page.get_by_role('tab', name='Model', exact=True).click()
    page.locator('model-tree input').first.wait_for(state='attached')
    page.evaluate('document.querySelectorAll("model-tree details").forEach(e => { e.open = true; })')
    painted(page)


@pytest.mark.parametrize('example', ['genset/genset.toml', 'bogie/loaded_frame.toml'])
def test_numbers_and_units_are_read_without_scrolling(serve, example):
    page = serve(example).page()
    opened_tree(page)
    texts = page.evaluate(f'{FIELDS}.map(e => e.value)')
    assert any(text.endswith(' mm') for text in texts) and len(texts) > 30
    for width, height in ((1280, 800), (1920, 1080)):
        page.set_viewport_size({'width': width, 'height': height})
        painted(page)
        assert page.evaluate(f'{FIELDS}.filter(e => e.scrollWidth > e.clientWidth).map(e => e.value)') == [], width
        beyond = '(e => e.scrollWidth - e.clientWidth)(document.querySelector("model-tree").parentElement)'
        assert page.evaluate(beyond) <= 0, width


def test_every_field_has_a_name_of_its_own(serve):
    page = serve('genset/genset.toml').page()
    opened_tree(page)
    names = page.evaluate(f'{FIELDS}.map(e => e.getAttribute("aria-label"))')
    assert [name for name, count in collections.Counter(names).items() if count > 1] == []
    field = page.get_by_label('elements front left at x', exact=True)
    before = page.locator('model-tree .changed').count()
    field.fill('1.5')
    field.press('Enter')
    settled(page)
    assert field.input_value() == '1.5' and page.locator('model-tree .changed').count() == before + 1
