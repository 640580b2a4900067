# SPDX-License-Identifier: BSD-3-Clause
"""The middle of the page: colours of mounts, steady motions, ghosts, screw axes and foundations."""
import re

from conftest import drawn, settled
from test_pictures import assert_alive, picture, share_changed
from test_play import command, set_number


PROGRAMS = "() => document.querySelector('machine-view').stage.renderer.info.programs.length"


def choose(page, label, value):
    page.get_by_label(label, exact=True).select_option(value)
    drawn(page)


def red(image):
    """Share of pixels with the colour of a violated limit, however it is lit."""
    data = image.convert('RGB').tobytes()
    pixels = zip(data[0::3], data[1::3], data[2::3])
    return 3 * sum(r > 90 and r > 2.5 * g and r > 1.8 * b for r, g, b in pixels) / len(data)


def words_of(share):
    return f'{100 * share:.3g} %'


def test_mounts_are_coloured_by_the_share_of_their_limit_that_the_program_states(serve):
    served = serve('compressor/requirements.toml')
    page = served.page()
    settled(page)
    stage, plain = page.locator('.stage'), picture(page.locator('.stage'))
    choose(page, 'Colour of mounts', 'limit')
    assert share_changed(plain, picture(stage)) > 0.002
    assert_alive(page)
    elements = command('verdict', served.file)['cases'][0]['elements']
    most = max(elements, key=lambda e: e['share'])
    legend = page.locator('.legend')
    assert f"{most['element']}, {words_of(most['share'])}" in legend.inner_text()
    assert most['share'] < 1
    reddish = red(picture(stage))  # arrows of forces
    set_number(page, 'mass of compressor, value', '900 kg')
    settled(page)
    heavy = command('verdict', served.file, '--set', 'bodies.compressor.mass=900 kg')['cases'][0]['elements']
    most = max(heavy, key=lambda e: e['share'])
    assert most['share'] > 1 and words_of(most['share']) in legend.inner_text()
    assert red(picture(stage)) > reddish + 1e-3


POLES = """() => {
  const view = document.querySelector('machine-view'), {camera} = view.stage, {left, top, width, height} = view.querySelector('canvas').getBoundingClientRect();
  return view.machine.root.children.filter(c => (c.userData.words ?? '').startsWith('pole of ')).map(mark => {
    const at = mark.position.clone().project(camera);
    return {words: mark.userData.words, place: mark.position.toArray(), x: left + (at.x + 1) / 2 * width, y: top + (1 - at.y) / 2 * height};
  });
}"""


def test_a_pole_that_no_other_mark_shows_has_its_own(serve):
    served = serve('two_stage/pump_on_raft.toml')
    page = served.page()
    choose(page, 'Motion', 'rest')
    bodies, marks = command('scene', served.file)['bodies'], page.evaluate(POLES)
    assert {m['words'].removeprefix('pole of '): m['place'] for m in marks} == {b['name']: b['pole'] for b in bodies}
    assert 'pole of a body' in page.locator('.stage .marks').inner_text()
    for mark in marks:
        page.mouse.move(mark['x'], mark['y'])
        page.locator('.hover').get_by_text(mark['words'], exact=True).wait_for()
    page.mouse.click(mark['x'], mark['y'])
    chosen = page.evaluate("() => document.querySelector('page-shell').app.state.selection")
    assert chosen == {'kind': 'body', 'name': mark['words'].removeprefix('pole of ')}
    choose(page, 'Motion', '1')
    assert page.evaluate(POLES) != marks  # it moves with its body
    origin = serve('genset/genset.toml').page()
    drawn(origin)
    assert origin.evaluate(POLES) == [] and origin.locator('.stage .marks').count() == 0


def test_mounts_without_limits_have_a_sentence_and_their_deflections_a_scale(serve):
    served = serve('genset/genset.toml')
    page = served.page()
    settled(page)
    choose(page, 'Colour of mounts', 'limit')
    legend = page.locator('.legend')
    assert 'has a limit in this file' in legend.inner_text()
    choose(page, 'Colour of mounts', 'deflection')
    most = max(command('check', served.file)['mounts'], key=lambda m: abs(m['deflection']))
    assert f"most: {most['element']}, −{abs(1e3 * most['deflection']):.3g} mm" in legend.inner_text()


def test_a_steady_motion_of_a_nonlinear_machine_moves_with_its_harmonics(serve):
    served = serve('isolator/hardening.toml')
    page = served.page()
    settled(page)
    motion, caption, stage = page.get_by_label('Motion', exact=True), page.locator('.caption'), page.locator('.stage')
    motion.select_option('steady 0')  # at the largest response
    caption.get_by_text(re.compile(r'^Steady motion, [\d.]+ Hz.*stable')).wait_for()
    settled(page)
    first = picture(stage)
    page.get_by_role('slider', name='Phase').fill('90')
    drawn(page)
    assert share_changed(first, picture(stage)) > 0.002
    assert_alive(page)


def test_all_steady_motions_at_a_clicked_frequency_can_be_chosen(serve):
    served = serve('isolator/hardening.toml')
    page = served.page()
    settled(page)
    plot, motion, caption = (
        page.locator('.amplitude .u-over'),
        page.get_by_label('Motion', exact=True),
        page.locator('.caption'),
    )
    box = plot.bounding_box()
    plot.click(position={'x': box['width'] * 0.3, 'y': box['height'] * 0.7})
    caption.get_by_text(re.compile('^Operating shape')).wait_for()
    frequency = caption.inner_text().split(',')[1].split('·')[0].strip()
    motion.select_option('steady 0')
    caption.get_by_text(re.compile(r'^Steady motion')).wait_for()
    settled(page)
    found = command('steady', served.file, '--at', frequency)['at'][0]['motions']
    offered = motion.locator('option[value^=steady]').all_inner_texts()
    assert len(offered) == len(found)
    for words, one in zip(offered, found):
        assert f'at {frequency}' in words and words.endswith(', stable' if one['stable'] else ', unstable')


def test_ghosts_and_flashes_stand_beside_the_moving_machine(serve):
    page = serve('bogie/loaded_frame.toml').page()
    settled(page)
    stage, edges = page.locator('.stage'), picture(page.locator('.stage'))
    choose(page, 'Motion against', 'rest')
    rest = picture(stage)
    assert share_changed(edges, rest) > 0.005
    choose(page, 'Motion against', 'strobe')
    assert share_changed(rest, picture(stage)) > 0.003
    assert page.evaluate(PROGRAMS) == 3  # of surfaces, of lines and flat marks, of signs
    choose(page, 'Motion against', 'edges')
    assert share_changed(edges, picture(stage)) == 0  # nothing is left behind
    assert_alive(page)


def test_the_screw_axis_of_a_selected_body_is_that_of_the_mode(serve):
    served = serve('genset/genset.toml')
    page = served.page()
    settled(page)
    page.locator('.stage').focus()
    page.keyboard.press('s')  # selects the first body
    hover, stage = page.locator('.hover'), page.locator('.stage')
    hover.get_by_text('screw axis').wait_for()
    shown, prefix = re.search(r'pitch ([−\d.]+) ([mµ]?)m/rad', hover.inner_text()).groups()
    pitch = command('modes', served.file)['modes'][0]['screws'][0]['pitch']
    assert abs(float(shown.replace('−', '-')) * {'': 1, 'm': 1e-3, 'µ': 1e-6}[prefix] / pitch - 1) < 5e-3
    drawn(page)
    with_axis = picture(stage)
    page.get_by_label('Motion', exact=True).select_option('rest')  # no motion, no axis
    drawn(page)
    assert 'axis' not in hover.inner_text()
    assert share_changed(with_axis, picture(stage)) > 0.001
    assert_alive(page)


def test_the_foundation_under_the_mounts_moves_in_a_mode_and_in_the_damped_one_alike(serve):
    served = serve('genset/genset.toml')
    page = served.page()
    settled(page)
    found = command('modes', served.file)
    assert len(found['feet']) == 6 and found['modes'][6]['foundation_kinetic_energy_share'] > 0.8
    page.get_by_label('Motion', exact=True).select_option(
        '7'
    )  # of the deck: the genset hardly moves; it is damped by 1.5 %
    page.get_by_role('button', name='front', exact=True).click()

    def ends():
        pictures = []
        for phase in ('0', '180'):
            page.get_by_role('slider', name='Phase').fill(phase)
            drawn(page)
            pictures.append(picture(page.locator('.stage')))
        return pictures

    up, down = ends()
    assert share_changed(up, down) > 0.001
    page.get_by_label('damped', exact=True).check()
    settled(page)
    nearest = min(share_changed(up, other) for other in ends())  # the sign of a mode is arbitrary
    assert nearest < 0.5 * share_changed(up, down), (nearest, share_changed(up, down))
    assert_alive(page)
