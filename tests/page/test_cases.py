# SPDX-License-Identifier: BSD-3-Clause
"""Cases: a new one like the case on the page, and its numbers."""
import tomllib

from conftest import settled
from test_play import changed_lines, computed_frequencies, set_number, shown_frequencies


def test_a_case_is_duplicated_with_the_moved_sliders_and_saved(serve):
    served = serve('compressor/requirements.toml')
    page = served.page()
    settled(page)
    before = served.file.read_text()
    page.get_by_label('Case', exact=True).select_option('cold')
    settled(page)
    assert shown_frequencies(page) == computed_frequencies(served.file, '--case', 'cold')
    set_number(page, 'mass of compressor, value', '300 kg')
    settled(page)
    page.get_by_role('button', name='New case like this one').click()
    page.get_by_label('Name of the new case').fill('cold')
    page.keyboard.press('Enter')
    page.get_by_text('a new case needs a name that no other case has').wait_for()
    page.get_by_label('Name of the new case').fill('cold and heavy')
    page.keyboard.press('Enter')
    page.wait_for_function("() => document.querySelector('case-bar select').value === 'cold and heavy'")
    settled(page)
    page.get_by_role('button', name='Save').click()
    page.get_by_text('requirements.toml is saved.').wait_for()
    lines = changed_lines(before, served.file.read_text())
    assert all(line[0] == '+' for line in lines)
    cases = tomllib.loads(served.file.read_text())['cases']
    assert cases['cold and heavy'] == cases['cold'] | {'bodies': {'compressor': {'mass': '300 kg'}}}
    assert shown_frequencies(page) == computed_frequencies(served.file, '--case', 'cold and heavy')
    page.get_by_role('button', name='Undo').click()
    settled(page)
    served.messages.clear()  # the status 422 of the wrong name


def test_a_slider_moves_the_number_of_the_case_and_can_be_saved(serve):
    served = serve('compressor/requirements.toml')
    page = served.page()
    settled(page)
    before, base = served.file.read_text(), computed_frequencies(served.file)
    page.get_by_label('Case', exact=True).select_option('cold')
    settled(page)
    label = 'stiffness of foot, value'
    assert page.get_by_label(label, exact=True).input_value() == '1.4'
    assert page.get_by_text('of case cold').count() == 1
    set_number(page, label, '1.6')
    settled(page)
    page.get_by_role('button', name='Save').click()
    page.get_by_text('requirements.toml is saved.').wait_for()
    lines = changed_lines(before, served.file.read_text())
    assert lines == ['-element_types.foot.scale = 1.4', '+element_types.foot.scale = 1.6']
    assert shown_frequencies(page) == computed_frequencies(served.file, '--case', 'cold')
    assert computed_frequencies(served.file) == base
