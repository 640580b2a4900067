# SPDX-License-Identifier: BSD-3-Clause
"""`trivet serve` without a file teaches by three examples."""
import json
import re
import subprocess

from conftest import TRIVET, settled


def test_three_examples_can_be_opened_and_saved_as_a_download(serve, tmp_path):
    served = serve()
    page = served.page()
    buttons = page.locator('.examples button')
    buttons.first.wait_for()
    assert buttons.count() == 3
    for i in range(3):
        page = served.page()
        page.locator('.examples button').nth(i).click()
        settled(page)
        assert page.locator('result-tables').is_visible()
    with page.expect_download() as download:
        page.get_by_role('button', name='Save').click()
    download.value.save_as(tmp_path / 'machine.toml')
    assert 'trivet = 1' in (tmp_path / 'machine.toml').read_text()


def test_the_form_makes_a_machine_that_is_judged(serve):
    page = serve().page()
    page.get_by_label('Mass [kg]').fill('abc')
    page.get_by_role('button', name='Make it').click()
    page.get_by_text('Mass: a number above 0 is expected.').wait_for()
    page.get_by_label('Mass [kg]').fill('650')
    page.get_by_label('Name').fill('Fan "north"')
    page.get_by_role('button', name='Make it').click()
    settled(page)
    assert page.locator('header .title').inner_text() == 'Fan "north"'
    page.locator('.pill').get_by_text(re.compile('requirements (met|violated)')).wait_for()


def test_the_form_takes_mounts_of_the_catalogue(serve, tmp_path):
    page = serve().page()
    page.get_by_label('Mounts', exact=True).select_option('disc 30x15 40 ShA')
    assert page.get_by_label(re.compile('Vertical stiffness')).count() == 0
    page.get_by_role('button', name='Make it').click()
    settled(page)
    page.get_by_text(re.compile('requirements violated')).wait_for()  # 981 N on a mount for 179 N
    page.get_by_role('button', name='Examples').click()
    page.get_by_label('Mounts', exact=True).select_option('disc 75x25 40 ShA')
    page.get_by_role('button', name='Make it').click()
    settled(page)
    with page.expect_download() as download:
        page.get_by_role('button', name='Save').click()
    file = tmp_path / 'machine.toml'
    download.value.save_as(file)
    assert sum(line.startswith('#') or '  # ' in line for line in file.read_text().splitlines()) >= 6
    subprocess.run([TRIVET, 'check', file, '--strict'], check=True)
    verdict = json.loads(subprocess.run([TRIVET, 'verdict', file, '--json'], stdout=subprocess.PIPE).stdout)
    loads = [r for r in verdict['cases'][0]['requirements'] if r['kind'] == 'mount_load']
    assert len(loads) == 4 and all(r['met'] for r in loads)


def test_a_machine_that_is_left_with_edits_can_be_opened_again(serve):
    page = serve().page()
    page.get_by_label('Name').fill('Fan "north"')
    page.get_by_role('button', name='Make it').click()
    settled(page)
    page.evaluate(
        "() => { const {state} = document.querySelector('page-shell').app; state.edit(state.design.text + '# mine\\n'); }"
    )
    page.get_by_role('button', name='Examples').click()
    page.locator('.examples:not(.left) button').first.click()
    settled(page)
    page.get_by_role('button', name='Examples').click()  # an example without edits is not kept
    left = page.locator('.examples.left button')
    assert left.count() == 1
    page.reload()
    page.once('dialog', lambda dialog: dialog.accept())
    left.first.wait_for()
    assert 'Fan "north"' in left.inner_text()
    left.click()
    settled(page)
    text = "() => document.querySelector('page-shell').app.state.design.text"
    assert page.evaluate(text).endswith('# mine\n')
    page.get_by_role('button', name='Undo').click()
    assert not page.evaluate(text).endswith('# mine\n')
    page.get_by_role('button', name='Examples').click()
    assert left.count() == 1
