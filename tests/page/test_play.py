# SPDX-License-Identifier: BSD-3-Clause
"""One opens a machine, moves a slider, edits, undoes, saves; with the mouse and with the keyboard alone."""
import difflib
import json
import re
import subprocess

from conftest import TRIVET, settled


NAME_OF_FOCUS = """() => {
  const focus = document.activeElement;
  return focus === document.body ? '' : focus.getAttribute('aria-label') || (focus.closest('label') || focus).innerText;
}"""


def command(name, file, *words):
    """What the command line prints of the same file."""
    output = subprocess.run(
        [TRIVET, name, str(file), '--json', *words], capture_output=True, text=True, check=True
    ).stdout
    return json.loads(output)


def shown_frequencies(page):
    """Natural frequencies [Hz] in the table of modes, with four digits."""
    page.get_by_role('tab', name='Modes').click()
    return [float(cell) for cell in page.locator('result-tables tbody td:nth-child(2)').all_inner_texts()]


def computed_frequencies(file, *words):
    return [float(f"{mode['frequency_hz']:.4g}") for mode in command('modes', file, *words)['modes']]


def changed_lines(before, after):
    lines = difflib.unified_diff(before.splitlines(), after.splitlines(), lineterm='', n=0)
    return [line for line in lines if line[0] in '+-' and line[:3] not in ('+++', '---')]


def set_number(page, label, value):
    field = page.get_by_label(label, exact=True)
    field.fill(value)
    field.press('Enter')
    field.blur()


def test_modes_are_those_of_the_command_line_before_and_after_a_slider(serve):
    served = serve('genset/genset.toml')
    page = served.page()
    settled(page)
    assert shown_frequencies(page) == computed_frequencies(served.file)
    set_number(page, 'mass of genset, value', '5000 kg')
    settled(page)
    changed = computed_frequencies(served.file, '--set', 'bodies.genset.mass=5000 kg')
    assert shown_frequencies(page) == changed != computed_frequencies(served.file)


def test_a_dragged_slider_moves_the_results_and_undo_brings_them_back(serve):
    served = serve('genset/genset.toml')
    page = served.page()
    settled(page)
    before = shown_frequencies(page)
    slider = page.get_by_role('slider', name='stiffness of mount')
    box = slider.bounding_box()
    middle = box['y'] + box['height'] / 2
    page.mouse.move(box['x'] + box['width'] / 2, middle)
    page.mouse.down()
    for part in (0.6, 0.7, 0.8, 0.9):
        page.mouse.move(box['x'] + part * box['width'], middle)
        page.wait_for_timeout(60)
    page.mouse.up()
    settled(page)
    assert min(shown_frequencies(page)) > 1.2 * min(before)
    page.get_by_role('button', name='Undo').click()  # the drag is one step
    settled(page)
    assert shown_frequencies(page) == before
    assert page.get_by_role('button', name='Undo').is_disabled()


def test_saving_an_edited_mass_changes_one_line(serve):
    served = serve('genset/genset.toml')
    page = served.page()
    settled(page)
    before = served.file.read_text()
    set_number(page, 'mass of genset, value', '4500 kg')
    page.get_by_role('button', name='Save').click()
    page.get_by_text('genset.toml is saved.').wait_for()
    lines = changed_lines(before, served.file.read_text())
    assert len(lines) == 2 and '4200 kg' in lines[0] and '4500 kg' in lines[1]
    page.reload()
    settled(page)
    assert page.get_by_label('mass of genset, value', exact=True).input_value() == '4500 kg'
    assert page.get_by_role('button', name='Save').is_disabled()


def test_a_file_that_another_program_changed_is_not_overwritten(serve):
    served = serve('genset/genset.toml')
    page = served.page()
    settled(page)
    theirs = served.file.read_text() + '# theirs\n'
    served.file.write_text(theirs)
    set_number(page, 'mass of genset, value', '4500 kg')
    page.get_by_role('button', name='Save').click()
    page.get_by_text('Nothing was written.').wait_for()
    assert served.file.read_text() == theirs
    served.messages.clear()  # Chromium writes the status 409 to the console
    page.get_by_role('button', name='Overwrite it with mine').click()
    page.get_by_text('genset.toml is saved.').wait_for()
    assert '# theirs' not in served.file.read_text()


def test_a_broken_requirement_is_red_and_its_margin_is_the_programs(serve):
    served = serve('compressor/requirements.toml')
    page = served.page()
    page.get_by_text('met here, violated in case cold').wait_for()
    set_number(page, 'stiffness of foot, value', '3')
    page.get_by_text(re.compile(r'of 16 requirements violated')).wait_for()
    settled(page)
    verdict = command('verdict', served.file, '--set', 'element_types.foot.scale=3')['cases'][0]
    least = min((r for r in verdict['requirements'] if r['margin'] is not None), key=lambda r: r['margin'])
    row = page.locator('result-tables tr.violated').first.inner_text()
    assert least['requirement'] in row and f"{least['margin']:.3g}" in row


def test_a_click_on_a_curve_makes_the_machine_swing_there(serve):
    served = serve('genset/genset.toml')
    page = served.page()
    settled(page)
    plot = page.locator('.amplitude .u-over')
    box = plot.bounding_box()
    plot.click(position={'x': box['width'] * 0.4, 'y': 40})
    page.locator('.caption').get_by_text(re.compile(r'Operating shape, \d+')).wait_for()
    frequency = float(page.locator('.caption').inner_text().split(',')[1].split()[0])
    assert abs(frequency - (2 + 0.4 * 58)) < 0.5  # the band is 2 … 60 Hz


def test_a_wrong_text_has_its_message_at_the_line_and_keeps_the_page(serve):
    served = serve('genset/genset.toml')
    page = served.page()
    settled(page)
    page.get_by_role('tab', name='Text').click()
    editor = page.get_by_role('textbox', name='Project file')
    editor.click()
    page.keyboard.press('Control+End')
    page.keyboard.type('\n[bodies.genset.colour]\n')
    page.get_by_text(re.compile('error.* in the file')).wait_for()
    assert page.locator('problem-list li').count() >= 1
    page.get_by_role('button', name='Undo').click()
    page.get_by_text('1 of 1 requirements violated').wait_for()


def test_text_shows_what_a_slider_changed(serve):
    served = serve('genset/genset.toml')
    page = served.page()
    settled(page)
    set_number(page, 'mass of genset, value', '4567 kg')
    page.get_by_role('tab', name='Text').click()
    page.get_by_text('"4567 kg"').wait_for()
    assert '4200 kg' in served.file.read_text()  # not saved


def test_every_step_without_a_mouse(serve):
    served = serve('genset/genset.toml')
    page = served.page()
    settled(page)
    before = shown_frequencies(page)

    def tab_to(name, most=60):
        for _ in range(most):
            page.keyboard.press('Tab')
            if name in page.evaluate(NAME_OF_FOCUS):
                return
        raise AssertionError(f'{name} is not reached by Tab')

    page.locator('body').focus()
    tab_to('stiffness of mount')
    for _ in range(5):
        page.keyboard.press('PageUp')
    settled(page)
    page.evaluate('() => document.activeElement.blur()')
    tab_to('Machine in 3D')
    page.keyboard.press('n')
    page.locator('.caption').get_by_text(re.compile('^Mode 2')).wait_for()
    page.keyboard.press('s')
    page.locator('.hover').get_by_text('genset').wait_for()
    page.keyboard.press('ArrowLeft')
    tab_to('Characteristics')
    page.keyboard.press('PageDown')
    said = page.locator('curve-chart [role=status]')
    page.wait_for_function("() => /Hz: genset/.test(document.querySelector('curve-chart [role=status]').textContent)")
    first = said.inner_text()
    page.keyboard.press('ArrowRight')
    page.wait_for_function(
        'before => document.querySelector("curve-chart [role=status]").textContent !== before', arg=first
    )
    page.keyboard.press('Enter')
    page.locator('.caption').get_by_text(re.compile('Operating shape')).wait_for()
    assert shown_frequencies(page) != before
    page.keyboard.press('Control+s')
    page.get_by_text('genset.toml is saved.').wait_for()
    for _ in range(5):  # each key of the slider is a step, also after saving
        page.keyboard.press('Control+z')
    settled(page)
    assert shown_frequencies(page) == before


def test_a_text_that_is_no_number_changes_nothing(serve):
    page = serve('genset/genset.toml').page()
    settled(page)
    field = page.get_by_label('mass of genset, value')
    field.fill('abc')
    field.press('Tab')
    page.get_by_text('"abc" is not a number').wait_for()
    assert field.input_value() == '4200 kg'
