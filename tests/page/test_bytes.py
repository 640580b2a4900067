# SPDX-License-Identifier: BSD-3-Clause
"""The bytes of the file: line ends stay."""
from test_other_hands import MASS, opened
from test_play import set_number

def with_crlf(served):
    content = served.file.read_bytes().replace(b'\n', b'\r\n')
    served.file.write_bytes(content)
    return content


def show_text(page):
    page.get_by_role('tab', name='Text').click()
    page.locator('text-view .cm-content').wait_for()
    page.wait_for_timeout(600)  # longer than the pause after a key


def save(page):
    page.get_by_role('button', name='Save').click()
    page.get_by_text('is saved.').wait_for()


def test_the_text_of_a_file_with_crlf_is_shown_without_an_edit(serve):
    served = serve('genset/genset.toml')
    with_crlf(served)
    page = opened(served)
    show_text(page)
    assert page.get_by_role('button', name='Save').is_disabled()


def test_saving_keeps_line_ends(serve):
    served = serve('genset/genset.toml')
    content = with_crlf(served)
    page = opened(served)
    set_number(page, MASS, '4500 kg')
    show_text(page)
    page.locator('text-view .cm-content').click()
    page.keyboard.press('Control+End')
    page.keyboard.type('# new')
    page.keyboard.press('Enter')
    page.wait_for_timeout(600)
    save(page)
    assert served.file.read_bytes() == content.replace(b'"4200 kg"', b'"4500 kg"', 1) + b'# new\r\n'
