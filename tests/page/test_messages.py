# SPDX-License-Identifier: BSD-3-Clause
"""Messages about numbers: at their fields and at their places in the text."""
from conftest import settled

from test_other_hands import MASS, opened
from test_play import set_number


def test_a_wrong_number_is_marked_at_its_field(serve):
    served = serve('genset/genset.toml')
    page = opened(served)
    for wrong in ('-4200 kg', '4200 m'):
        assert_marked_at_its_field(page, served, wrong)
    served.messages.clear()  # the status 422 of the text that cannot be written


def assert_marked_at_its_field(page, served, wrong):
    line = 1 + served.file.read_text().split('mass = "4200 kg"')[0].count('\n')
    set_number(page, MASS, wrong)
    link = page.locator('problem-list .error .link')
    link.wait_for()
    assert link.inner_text().startswith(f'line {line}: bodies.genset.mass: ') and '--set' not in link.inner_text()
    for tab, label in (('Sliders', MASS), ('Model', 'bodies genset mass')):
        page.get_by_role('tab', name=tab).click()
        field = page.locator(f'.left input.number[aria-label^="{label}"]')
        assert field.get_attribute('aria-invalid') == 'true'
        assert page.locator(f'#{field.get_attribute("aria-describedby")}').inner_text() == link.inner_text()
        red = page.evaluate("() => getComputedStyle(document.querySelector('problem-list .error')).color")
        assert field.evaluate('input => getComputedStyle(input).borderColor') == red
        assert page.locator('.left [aria-invalid]').count() == 1
    link.click()
    chosen = page.locator('text-view').evaluate(
        'view => view.editor.state.doc.lineAt(view.editor.state.selection.main.head).number'
    )
    assert chosen == line
    page.get_by_role('tab', name='Sliders').click()
    set_number(page, MASS, '4300 kg')
    settled(page)
    assert page.locator('[aria-invalid]').count() == 0


def test_a_setting_without_a_place_in_the_text_leads_to_its_field(serve):
    served = serve('genset/genset.toml')
    page = opened(served)
    set_number(page, 'stiffness of mount, value', '-2')
    page.locator('problem-list .error .link').click()
    page.wait_for_function("() => document.activeElement.ariaLabel === 'stiffness of mount, value'")


def test_a_wrong_unit_stays_in_the_field_of_a_slider(serve):
    served = serve('genset/genset.toml')
    page = opened(served)
    field = page.get_by_label('stiffness of mount, value', exact=True)
    for typed in ('640 lb', '640 kg'):
        set_number(page, 'stiffness of mount, value', typed)
        page.locator('problem-list .error .link').wait_for()
        assert (field.input_value(), field.get_attribute('aria-invalid')) == (typed, 'true')
    served.messages.clear()  # the status 422 of the text that cannot be written


def test_a_number_that_is_too_large_is_called_so(serve):
    page = opened(serve('genset/genset.toml'))
    set_number(page, MASS, '1e400 kg')
    page.get_by_text('"1e400 kg" is too large a number').wait_for()


def test_saving_with_many_errors_is_one_sentence(serve):
    served = serve('genset/genset.toml')
    before = served.file.read_bytes()
    page = opened(served)
    page.evaluate(
        """() => document.querySelector('page-shell').app.state.set({'bodies.genset.mass': '"-1 kg"', 'element_types.mount.scale': '-1',
          'bodies.genset.inertia.xx': '"1 m"', 'bodies.genset.inertia.yy': '"2 m"', 'bodies.genset.inertia.zz': '"3 m"'})"""
    )
    page.locator('problem-list .error .link').first.wait_for()
    page.keyboard.press('Control+s')
    toast = page.locator('.toast')
    toast.filter(has_text='errors').wait_for()
    assert len(toast.inner_text()) < 120, toast.inner_text()
    toast.get_by_role('button', name='Show them').click()
    assert page.evaluate("() => !!document.activeElement.closest('problem-list')")
    assert served.file.read_bytes() == before
    served.messages.clear()  # the status 422
