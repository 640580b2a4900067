# SPDX-License-Identifier: BSD-3-Clause
"""The machine in 3D of a report that is opened from disk: it is drawn, it moves, and everything is done by mouse and keys."""
import subprocess
import time

import pytest

from conftest import ROOT, TRIVET, complaints
from test_accessible import AXE
from test_pictures import colours, picture, share_changed

VIEW, STAGE = '.machine-3d', '.machine-3d .stage'
LEAST = 0.005  # share of the pixels that differ where something else is drawn
WITHOUT_WEBGL = """const given = HTMLCanvasElement.prototype.getContext;
HTMLCanvasElement.prototype.getContext = function(kind, ...options) {
  return kind.startsWith('webgl') ? null : given.call(this, kind, ...options);
};"""

FAILURES = {
    'no WebGL any more': """const given = HTMLCanvasElement.prototype.getContext;
let asked = 0;
HTMLCanvasElement.prototype.getContext = function(kind, ...options) {
  return kind.startsWith('webgl') && asked++ > 0 ? null : given.call(this, kind, ...options);
};""",
    'nothing to unpack': "globalThis.DecompressionStream = class { constructor() { throw new Error('damaged'); } };",
    'damaged data': "Response.prototype.text = async () => '{';",
}


@pytest.fixture(scope='module')
def reports(tmp_path_factory):
    """reports('genset/genset.toml'): path of its report, made once."""
    made = {}

    def report(example):
        if example not in made:
            out = tmp_path_factory.mktemp('report') / 'out'
            subprocess.run(
                [TRIVET, 'run', str(ROOT / 'examples' / example), '-o', str(out)], check=True, capture_output=True
            )
            made[example] = out / 'report.html'
        return made[example]

    return report


@pytest.fixture
def opened(browser, reports):
    """opened(example, **context): its report, scrolled to the machine. Nothing is asked for, nor written to the console but what a
    test takes out of `opened.messages`."""
    contexts, messages, requests = [], [], []

    def open_report(example='genset/genset.toml', script='', loaded=True, **options):
        options = {'viewport': {'width': 1280, 'height': 800}, 'reduced_motion': 'reduce', **options}
        contexts.append(browser.new_context(**options))
        page = contexts[-1].new_page()
        page.on('console', lambda message: messages.append(message.text))
        page.on('pageerror', lambda error: messages.append(str(error)))
        page.on('request', lambda request: requests.append(request.url))
        page.add_init_script(script)
        page.goto(reports(example).as_uri())
        if loaded:
            page.locator(VIEW).evaluate("node => node.scrollIntoView({block: 'center'})")
            page.locator(f'{VIEW} canvas').wait_for()
            drawn(page)
        return page

    open_report.messages = messages
    yield open_report
    for context in contexts:
        context.close()
    assert complaints(messages) == []
    assert all(address.startswith('file:') and address.endswith('report.html') for address in requests)


def drawn(page):
    """The stage, after the pictures that are under way; if the machine does not move by itself, none is due any more."""
    page.wait_for_function(
        f"() => {{ const {{playing, stage}} = document.querySelector('{VIEW}').view; "
        'return playing || !stage.isBehind && !stage.wanted; }'
    )
    page.evaluate(
        '() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(() => requestAnimationFrame(done))))'
    )
    return picture(page.locator(STAGE))


def changed(page, before):
    """The stage as soon as it differs from a picture."""
    until = time.monotonic() + 30
    while share_changed(before, after := drawn(page)) <= LEAST:
        assert time.monotonic() < until, 'the same picture'
    return after


def words(page):
    return page.locator(f'{VIEW} [role=status]').inner_text()


def choose(page, label, text):
    select = page.locator(VIEW).get_by_label(label, exact=True)
    select.select_option(label=next(option for option in select.locator('option').all_inner_texts() if text in option))


@pytest.mark.parametrize('theme', ['light', 'dark'])
@pytest.mark.parametrize('example', ['genset/genset', 'bogie/loaded_frame', 'frame/frame', 'powertrain/decoupled'])
def test_the_machine_is_drawn_from_disk(opened, example, theme):
    page = opened(f'{example}.toml', color_scheme=theme)
    for width in (1280, 390):
        page.set_viewport_size({'width': width, 'height': 800})
        page.locator(VIEW).evaluate("node => node.scrollIntoView({block: 'center'})")
        image = drawn(page)
        assert colours(image) > 200, width
        assert (sum(image.getpixel((3, 3))) < 200) == (theme == 'dark'), width
        assert page.evaluate(f"() => !document.querySelector('{VIEW} canvas').getContext('webgl2').isContextLost()")
        assert page.evaluate('document.documentElement.scrollWidth') == width
        assert words(page).startswith('Mode 1: ')


def test_a_mode_moves_until_it_is_stopped(opened):
    page = opened(reduced_motion='no-preference')
    button = page.locator(f'{VIEW} .play')
    assert 'Stop' in button.inner_text()
    changed(page, drawn(page))
    button.click()
    assert 'Move' in button.inner_text()
    assert share_changed(drawn(page), drawn(page)) == 0


def test_modes_shapes_amplitudes_and_views_have_their_pictures(opened):
    page = opened()
    seen = [drawn(page)]
    assert share_changed(seen[0], drawn(page)) == 0  # reduced motion: it does not move by itself
    for change in (
        lambda: choose(page, 'Motion', 'Mode 3'),
        lambda: page.locator(VIEW).get_by_label('Size').fill('0.2'),
        lambda: choose(page, 'Motion', 'At rest'),
        lambda: page.locator(VIEW).get_by_role('button', name='front').click(),
        lambda: page.locator(VIEW).get_by_role('button', name='top').click(),
        lambda: page.locator(VIEW).get_by_role('button', name='side').click(),
    ):
        change()
        seen.append(drawn(page))
        assert share_changed(seen[-2], seen[-1]) > LEAST


def test_damped_modes_have_their_motions_and_frequencies(opened):
    page = opened('two_stage/pump_on_raft.toml')
    choose(page, 'Motion', 'Mode 7')
    page.locator(VIEW).get_by_label('Size').fill('0.2')
    before, undamped = words(page), drawn(page)
    page.locator(VIEW).get_by_role('checkbox', name='damped').check()
    assert words(page).startswith('Damped mode 7: ') and words(page)[-10:] == before[-10:]
    assert share_changed(undamped, drawn(page)) > LEAST / 10  # at the same phase
    page.locator(VIEW).get_by_role('checkbox', name='damped').uncheck()
    assert words(page) == before
    assert share_changed(undamped, drawn(page)) == 0


def test_the_keyboard_does_everything(opened):
    page = opened()
    page.locator(STAGE).focus()
    before = drawn(page)
    for key in ('ArrowRight', '+', 'ArrowUp', 'Home'):
        page.keyboard.press(key)
        after = drawn(page)
        assert share_changed(before, after) > LEAST, key
        before = after
    for key, expected in (('n', 'Mode 2: '), ('n', 'Mode 3: '), ('p', 'Mode 2: ')):
        page.keyboard.press(key)
        assert words(page).startswith(expected)
    page.keyboard.press(' ')
    assert 'Stop' in page.locator(f'{VIEW} .play').inner_text()


def test_the_wheel_scrolls_the_page_and_zooms_with_ctrl(opened):
    page = opened()
    page.locator(STAGE).hover()
    still, top = drawn(page), page.evaluate('scrollY')
    page.keyboard.down('Control')
    page.mouse.wheel(0, -200)
    changed(page, still)
    page.keyboard.up('Control')
    assert page.evaluate('scrollY') == top
    page.mouse.wheel(0, 120)
    page.wait_for_function(f'() => scrollY > {top}')


def test_a_case_has_its_own_modes(opened):
    page = opened('frame/frame.toml')
    before = words(page)
    options = page.locator(VIEW).get_by_label('Case in 3D').locator('option').all_inner_texts()
    assert options == page.locator('#case option').all_inner_texts()
    choose(page, 'Case in 3D', options[-1])
    assert words(page).startswith('Mode 1: ') and words(page) != before


@pytest.mark.parametrize('theme', ['light', 'dark'])
def test_axe_finds_nothing(opened, theme):
    page = opened('frame/frame.toml', color_scheme=theme)
    page.evaluate(AXE.read_text())
    run = f"async () => (await axe.run('{VIEW}', {{resultTypes: ['violations']}})).violations"
    assert [(v['id'], [n['html'][:120] for n in v['nodes']]) for v in page.evaluate(run)] == []


def test_paper_has_the_four_views_alone(opened):
    page = opened()
    page.emulate_media(media='print')
    assert not page.locator(VIEW).is_visible()
    assert page.locator('.machine .drawing svg').first.is_visible()


@pytest.mark.parametrize('what', ['no WebGL', 'no decompression', 'no script'])
def test_without_3d_the_four_views_remain_and_no_place_is_empty(opened, what):
    script = {'no WebGL': WITHOUT_WEBGL, 'no decompression': 'delete globalThis.DecompressionStream', 'no script': ''}[
        what
    ]
    page = opened(script=script, loaded=False, java_script_enabled=what != 'no script')
    page.locator('.machine .drawing svg').first.scroll_into_view_if_needed()
    page.mouse.wheel(0, 700)
    page.locator(VIEW).wait_for(state='detached')
    assert page.locator('.machine .drawing svg').first.is_visible()


@pytest.mark.parametrize('what', FAILURES)
def test_a_failure_in_3d_leaves_the_four_views_and_no_empty_place(opened, what):
    page = opened(script=FAILURES[what], loaded=False)
    page.locator(VIEW).evaluate("node => node.scrollIntoView({block: 'center'})")
    page.locator(VIEW).wait_for(state='detached')
    assert page.locator('.machine .drawing svg').first.is_visible()
    assert complaints(opened.messages)  # what failed, for those who look for it
    opened.messages.clear()
