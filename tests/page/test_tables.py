# SPDX-License-Identifier: BSD-3-Clause
"""Tables of the results: numbers of the program, with the case in which a margin is least."""
import json

from conftest import settled, unanswered
from test_limits import judged
from test_play import command


def row(page, words):
    return page.locator('result-tables tbody tr').filter(has=page.get_by_role('rowheader', name=words, exact=True))


def test_rows_of_modes_that_are_not_seen_follow_at_rest_and_when_they_are_scrolled_to(serve):
    served = serve('../benchmarks/ten_bodies.toml')
    page = served.page()
    settled(page)
    page.get_by_role('tab', name='Modes').click()
    rows = "() => [...document.querySelectorAll('#table-panel tbody td:nth-child(2)')].map(cell => cell.textContent)"
    before = page.evaluate(rows)
    page.evaluate(
        """() => {
      const {asker} = document.querySelector('page-shell').app;
      asker.isOld = name => name === 'curves';  // numbers move
    }"""
    )
    slider = page.locator('.sliders input[type=range]').first
    slider.fill('900')
    page.wait_for_function(
        f"before => JSON.stringify(({rows})()) !== before", arg=json.dumps(before, separators=(',', ':'))
    )
    moving = page.evaluate(rows)
    assert moving[30:] == before[30:] and len(moving) > 40
    page.locator('#table-panel').evaluate('panel => panel.scrollTo(0, panel.scrollHeight)')
    page.wait_for_function(
        f"before => JSON.stringify(({rows})().slice(30)) !== before", arg=json.dumps(before[30:], separators=(',', ':'))
    )


def test_a_requirement_names_the_case_with_the_least_margin_and_its_limit_is_edited(serve):
    served = serve('compressor/requirements.toml')
    page = served.page()
    judged(page)
    words = 'ground.force.z ≤ 60 N 0-p'
    cases = {c['case']: c['requirements'] for c in command('verdict', served.file)['cases']}
    others = {name: r['margin'] for name, all_of in cases.items() for r in all_of if name and r['requirement'] == words}
    worst = min(others, key=others.get)
    line = row(page, words)
    line.wait_for()
    assert f'{others[worst]:.3g} {worst}' in line.inner_text()
    page.get_by_label(f'Limit: {words}', exact=True).fill('0.1 kN')
    page.keyboard.press('Enter')
    changed = row(page, 'ground.force.z ≤ 100 N 0-p')
    changed.wait_for()
    margin = next(r['margin'] for r in cases[''] if r['requirement'] == words) * 100 / 60
    assert f'{margin:.3g}' in changed.inner_text()


def test_a_mount_has_the_margin_of_its_load_and_a_mode_its_strain_energies(serve):
    served = serve('compressor/requirements.toml')
    page = served.page()
    judged(page)
    page.get_by_role('tab', name='Mounts').click()
    loads = [r for r in command('verdict', served.file)['cases'][0]['requirements'] if r['kind'] == 'mount_load']
    assert len(loads) == 4
    for one in loads:
        cells = row(page, one['subject']).locator('td').all_inner_texts()
        assert cells[-1].strip() == f"{one['margin']:.3g}"
    page.get_by_role('tab', name='Modes').click()
    found = command('modes', served.file)
    shares = dict(zip(found['elements'], found['modes'][0]['strain_energy_share']))
    text = page.locator('result-tables').inner_text()
    assert all(f'{name} {100 * share:.3g} %' in text for name, share in shares.items())


def test_a_case_that_loads_no_mount_otherwise_has_the_loads_of_the_base_model(serve):
    served = serve('compressor/requirements.toml')
    served.file.write_text(served.file.read_text() + '\n[cases.balanced]\nexcitations.shaft.grade = 6.3\n')
    assert {m['case'] for m in command('check', served.file)['mounts']} == {'', 'cold', 'stiffer'}
    page = served.page()
    settled(page)
    page.get_by_label('Case', exact=True).select_option('balanced')
    settled(page)
    page.get_by_role('tab', name='Mounts').click()
    assert '766.6 N' in row(page, 'front left').inner_text()


def test_shares_above_100_percent_and_below_0_are_explained(serve):
    served = serve('paper/corrected.toml')
    page = served.page()
    settled(page)
    page.get_by_role('tab', name='Modes').click()
    found = command('modes', served.file)
    beyond = [share for m in found['modes'] for share in m['kinetic_energy_share'] if not -0.005 < share < 1.005]
    marked = page.locator('result-tables td.coupled')
    assert marked.all_inner_texts() == [f'{round(100 * share)}' for share in beyond] and beyond
    words = found['kinetic_energy_share_words']
    assert (
        marked.first.get_attribute('title') == words and words in page.locator('result-tables .hint').first.inner_text()
    )


def test_round_off_at_rest_is_no_load_and_no_deflection(serve):
    page = serve('bogie/loaded_frame.toml').page()
    settled(page)
    page.get_by_role('tab', name='Mounts').click()
    assert row(page, 'spring front left').inner_text().split('\t')[1:] == [
        '29.42 kN',
        '0 N',
        '0 m',
    ]  # a preload bears the load


def test_rows_of_requirements_are_marked_until_they_are_those_of_the_numbers(serve):
    page = serve('compressor/requirements.toml').page()
    judged(page)
    rows, marks = page.locator('result-tables tbody tr'), page.locator('result-tables tbody .old')
    assert marks.count() == 0
    with unanswered(page):
        page.locator('.sliders input[type=range]').first.fill('700')
        page.wait_for_function(
            'n => document.querySelectorAll("result-tables tbody .old").length == n', arg=rows.count()
        )
    judged(page)
    page.wait_for_function('() => !document.querySelector("result-tables tbody .old")')
