# SPDX-License-Identifier: BSD-3-Clause
"""The bytes of the file: line ends stay, and what is not UTF-8 is never written over."""
from conftest import settled
from test_other_hands import MASS, mass_of, opened
from test_play import set_number

LATIN = '# Masse des Geräts\n'.encode('latin-1')


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


def test_a_file_that_is_not_utf_8_opens_with_its_line_and_byte(serve):
    served = serve('genset/genset.toml')
    good = served.file.read_bytes()
    served.file.write_bytes(LATIN + good)
    page = served.page()
    page.get_by_text('line 1: ').filter(has_text='byte 16 of the line is E4').wait_for()
    assert page.get_by_role('button', name='Save').is_disabled()
    assert (
        page.get_by_role('tab', name='Text').count() == 0 and page.get_by_role('button', name='Download').count() == 0
    )
    page.keyboard.press('Control+s')
    page.wait_for_timeout(300)
    assert served.file.read_bytes() == LATIN + good
    served.file.write_bytes(LATIN.decode('latin-1').encode() + good)  # an editor saves it as UTF-8
    settled(page)
    assert mass_of(page) == '4200 kg' and page.locator('file-notice').inner_text().strip() == ''


def test_an_editor_that_writes_latin_1_is_not_overwritten(serve):
    served = serve('genset/genset.toml')
    page = opened(served)
    theirs = LATIN + served.file.read_bytes()
    served.file.write_bytes(theirs)
    page.get_by_text('nothing is written over it').wait_for()
    set_number(page, MASS, '4500 kg')
    page.get_by_role('button', name='Save').click()
    page.wait_for_timeout(500)
    assert served.file.read_bytes() == theirs
    assert page.get_by_role('button', name='Overwrite it with mine').count() == 0
    served.file.write_bytes(b'\xff\xfe')
    page.get_by_text('byte 1 of the line is FF').wait_for()
    assert page.get_by_text('no longer on the disk').count() == 0
    served.messages.clear()  # the status 409
