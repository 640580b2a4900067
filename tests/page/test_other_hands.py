# SPDX-License-Identifier: BSD-3-Clause
"""Another tab, an editor, a program that ends, a browser that sleeps: the page says so, and no edit is lost."""
import re

from conftest import settled
from test_play import changed_lines, computed_frequencies, set_number, shown_frequencies

MASS = 'mass of genset, value'


def opened(served):
    page = served.page()
    settled(page)
    return page


def mass_of(page):
    return page.get_by_label(MASS, exact=True).input_value()


def change_file(served, mass):
    served.file.write_text(served.file.read_text().replace('"4200 kg"', f'"{mass}"'))


def test_a_page_without_edits_takes_what_an_editor_wrote(serve):
    served = serve('genset/genset.toml')
    page = opened(served)
    change_file(served, '4900 kg')
    page.get_by_text('Another program changed genset.toml').wait_for()
    settled(page)
    assert mass_of(page) == '4900 kg' and page.get_by_role('button', name='Save').is_disabled()
    assert shown_frequencies(page) == computed_frequencies(served.file)
    page.get_by_role('button', name='Undo').click()
    page.wait_for_function("() => document.querySelector('.sliders').textContent && !document.querySelector('.old')")
    page.get_by_role('tab', name='Sliders').click()
    assert mass_of(page) == '4200 kg' and page.get_by_role('button', name='Save').is_enabled()


def test_a_page_with_edits_asks_and_shows_what_differs(serve):
    served = serve('genset/genset.toml')
    page = opened(served)
    set_number(page, MASS, '4500 kg')
    settled(page)
    before = shown_frequencies(page)
    served.file.write_text(served.file.read_text() + '# theirs\n')
    box = page.get_by_role('alertdialog')
    box.get_by_text('this page has edits').wait_for()
    box.locator('.first').get_by_text('# theirs').wait_for()
    assert all(line.startswith('− ') for line in box.locator('.first').all_inner_texts())
    box.locator('.second').get_by_text('mass = "4500 kg"').wait_for()
    assert box.locator('.second').count() == 1
    page.get_by_role('button', name='Go on with mine').click()
    assert box.count() == 0 and shown_frequencies(page) == before
    page.get_by_role('button', name='Save').click()
    box.wait_for()
    assert '# theirs' in served.file.read_text() and '4200 kg' in served.file.read_text()
    page.get_by_role('button', name='Open the text on the disk').click()
    settled(page)
    assert mass_of(page) == '4200 kg'
    page.get_by_role('button', name='Undo').click()
    settled(page)
    assert mass_of(page) == '4500 kg'
    served.messages.clear()  # Chromium writes the status 409 to the console


def test_two_tabs(serve):
    served = serve('genset/genset.toml')
    first, second = opened(served), opened(served)
    set_number(first, MASS, '4500 kg')
    first.get_by_role('button', name='Save').click()
    second.get_by_text('Another program changed genset.toml').wait_for()
    settled(second)
    assert mass_of(second) == '4500 kg'
    set_number(second, MASS, '4700 kg')
    change_file(served, '4500 kg')  # nothing
    set_number(first, MASS, '4800 kg')
    first.get_by_role('button', name='Save').click()
    second.get_by_text('this page has edits').wait_for()
    settled(second)
    second.get_by_role('button', name='Go on with mine').click()
    # The program has opened 4800 kg now: the results of the second tab are those of its own text nevertheless.
    expected = computed_frequencies(served.file, '--set', 'bodies.genset.mass=4700 kg')
    assert shown_frequencies(second) == expected
    second.get_by_role('tab', name='Text').click()
    second.get_by_text('"4700 kg"').wait_for()
    settled(second)
    assert shown_frequencies(second) == expected
    served.messages.clear()  # statuses 409 and 412


def test_the_conflict_shows_the_text_that_would_be_written(serve):
    served = serve('genset/genset.toml')
    page = opened(served)
    page.get_by_role('tab', name='Text').click()
    page.wait_for_timeout(300)
    page.get_by_role('tab', name='Sliders').click()
    set_number(page, MASS, '5000 kg')
    change_file(served, '4444 kg')
    box = page.get_by_role('alertdialog')
    line_of_the_text = re.compile(r'\d\s+mass = "5000 kg"')  # no setting
    box.locator('.second').get_by_text(line_of_the_text).wait_for()
    assert '4444 kg' in box.locator('.first').inner_text() and '4200 kg' not in box.inner_text()
    page.get_by_role('button', name='Overwrite it with mine').click()
    page.get_by_text('genset.toml is saved.').wait_for()
    assert 'mass = "5000 kg"' in served.file.read_text()
    served.messages.clear()


def test_a_file_that_was_moved_away_and_back_is_no_conflict(serve):
    served = serve('genset/genset.toml')
    page = opened(served)
    away = served.file.with_suffix('.away')
    for mass in ('4200 kg', '4500 kg'):
        set_number(page, MASS, mass)
        served.file.rename(away)
        page.get_by_text('genset.toml is no longer on the disk').wait_for()
        away.rename(served.file)
        page.wait_for_function("() => !document.querySelector('file-notice').innerText.trim()")
        assert page.get_by_role('alertdialog').count() == 0 and mass_of(page) == mass
    page.get_by_role('button', name='Save').click()
    page.get_by_text('genset.toml is saved.').wait_for()
    assert 'mass = "4500 kg"' in served.file.read_text()


def test_a_deleted_file_can_be_written_again(serve):
    served = serve('genset/genset.toml')
    page = opened(served)
    before = served.file.read_text()
    served.file.unlink()
    page.get_by_text('genset.toml is no longer on the disk').wait_for()
    set_number(page, MASS, '4500 kg')
    settled(page)
    page.get_by_role('button', name='Write it again').click()
    page.get_by_text('genset.toml is saved.').wait_for()
    assert page.get_by_text('no longer on the disk').count() == 0
    assert len(changed_lines(before, served.file.read_text())) == 2
    served.messages.clear()


def test_edits_survive_a_reload(serve):
    served = serve('genset/genset.toml')
    page = opened(served)
    page.on('dialog', lambda dialog: dialog.accept())
    set_number(page, MASS, '4500 kg')
    settled(page)
    page.reload()
    page.get_by_text('Your edits are back').wait_for()
    settled(page)
    assert mass_of(page) == '4500 kg' and '4200 kg' in served.file.read_text()
    page.get_by_role('button', name='Undo').click()
    settled(page)
    assert mass_of(page) == '4200 kg'
    page.reload()
    settled(page)
    assert page.get_by_text('Your edits are back').count() == 0


def test_undo_and_redo_survive_a_reload(serve):
    served = serve('genset/genset.toml')
    page = opened(served)
    page.on('dialog', lambda dialog: dialog.accept())
    for mass in ('4300 kg', '4400 kg', '4500 kg', '4600 kg'):
        set_number(page, MASS, mass)
    settled(page)
    undo, redo = (page.get_by_role('button', name=name) for name in ('Undo', 'Redo'))
    undo.click()
    settled(page)
    page.reload()
    page.get_by_text('Your edits are back').wait_for()
    settled(page)
    assert mass_of(page) == '4500 kg'
    redo.click()
    settled(page)
    assert mass_of(page) == '4600 kg' and redo.is_disabled()
    for mass in ('4500 kg', '4400 kg', '4300 kg', '4200 kg'):
        undo.click()
        settled(page)
        assert mass_of(page) == mass
    assert undo.is_disabled() and page.get_by_role('button', name='Save').is_disabled()


def test_edits_over_a_reload_and_another_text_on_the_disk(serve):
    served = serve('genset/genset.toml')
    page = opened(served)
    page.on('dialog', lambda dialog: dialog.accept())
    set_number(page, MASS, '4500 kg')
    settled(page)
    page.goto('about:blank')
    change_file(served, '4900 kg')
    page.goto(served.address.split('#')[0])
    page.get_by_role('alertdialog').get_by_text('this page has edits').wait_for()
    assert mass_of(page) == '4500 kg'
    page.get_by_role('button', name='Open the text on the disk').click()
    settled(page)
    assert mass_of(page) == '4900 kg'


def test_a_program_that_ends_and_starts_again(serve):
    served = serve('genset/genset.toml')
    page = opened(served)
    set_number(page, MASS, '4500 kg')
    settled(page)
    port = served.port
    served.kill()
    page.get_by_text('The program does not answer.').wait_for()
    assert page.locator('file-notice pre').inner_text() == f'trivet serve genset.toml --port {port}'
    set_number(page, MASS, '4600 kg')  # without the program, too
    with page.expect_download() as download:
        page.get_by_role('button', name='Download the text').click()
    text = download.value.path().read_text()
    assert '4200 kg' in text and "--set 'bodies.genset.mass = \"4600 kg\"'" in text
    served.start()  # with another token, and the port of before
    assert served.port == port
    page.get_by_text('The program does not answer.').wait_for(state='detached')
    settled(page)
    assert shown_frequencies(page) == computed_frequencies(served.file, '--set', 'bodies.genset.mass=4600 kg')
    page.get_by_role('button', name='Save').click()
    page.get_by_text('genset.toml is saved.').wait_for()
    assert '4600 kg' in served.file.read_text()
    served.messages.clear()  # refused connections


def test_a_program_that_starts_again_without_a_private_folder(serve):
    served = serve('genset/genset.toml')
    served.kill()
    served.start(login=False)
    page = opened(served)
    set_number(page, MASS, '4500 kg')
    settled(page)
    port = served.port
    served.kill()
    page.get_by_text('The program does not answer.').wait_for()
    served.start('--port', port, login=False)
    page.get_by_text('Open the address that it prints in this tab.').wait_for()
    page.goto(served.address)  # only the fragment differs: the page stays
    page.get_by_text('started again').wait_for(state='detached')
    settled(page)
    assert mass_of(page) == '4500 kg'
    page.get_by_role('button', name='Save').click()
    page.get_by_text('genset.toml is saved.').wait_for()
    served.messages.clear()


def test_another_program_at_the_port_gets_nothing(serve):
    served = serve('genset/genset.toml')
    page = opened(served)
    set_number(page, MASS, '4500 kg')
    settled(page)
    port = served.port
    served.kill()
    page.get_by_text('The program does not answer.').wait_for()
    served.requests.clear()
    served.login.joinpath('trivet').rename(served.login / 'other')  # without the key it is another program
    served.start('--port', port)
    page.get_by_text('Open the address that it prints in this tab.').wait_for()
    set_number(page, MASS, '4600 kg')
    page.wait_for_timeout(1500)
    assert {address.rsplit('/', 1)[1] for address in served.requests} == {'resume'}
    served.messages.clear()


def test_a_tab_that_slept(serve):
    served = serve('genset/genset.toml')
    page = opened(served)
    devtools = page.context.new_cdp_session(page)
    devtools.send('Page.setWebLifecycleState', {'state': 'frozen'})
    change_file(served, '4900 kg')
    served.kill()
    served.start()
    devtools.send('Page.setWebLifecycleState', {'state': 'active'})
    page.get_by_text(re.compile('Another program changed genset.toml')).wait_for()
    settled(page)
    assert mass_of(page) == '4900 kg'
    served.messages.clear()
