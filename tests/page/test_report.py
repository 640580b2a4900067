# SPDX-License-Identifier: BSD-3-Clause
"""The report alone, opened from disk: the point of a map is moved by mouse, touch and keys, and its design follows."""
import json
import re
import subprocess

import pytest

from conftest import ROOT, TRIVET

PROJECT = ROOT / 'examples/paper/map.toml'
AXE = ROOT / 'web/node_modules/axe-core/axe.min.js'  # installed by scripts/web
WITHIN = 1e-4  # of the program's results


@pytest.fixture(scope='module')
def report(tmp_path_factory):
    out = tmp_path_factory.mktemp('report') / 'out'
    subprocess.run([TRIVET, 'run', str(PROJECT), '-o', str(out)], check=True, capture_output=True)
    return out / 'report.html'


@pytest.fixture
def opened(browser, report):
    """opened(view, **context): the report in a browser whose console stays empty, without any request but its file."""
    contexts, messages, requests = [], [], []

    def open_report(view='', **options):
        options = {'viewport': {'width': 1280, 'height': 800}, **options}
        contexts.append(browser.new_context(**options))
        page = contexts[-1].new_page()
        page.on('console', lambda message: messages.append(message.text))
        page.on('pageerror', lambda error: messages.append(str(error)))
        page.on('request', lambda request: requests.append(request.url))
        page.goto(report.as_uri() + view)
        page.locator('.design-view').evaluate('node => node.scrollIntoView()')
        page.locator('.design-curves canvas').first.wait_for()
        return page

    yield open_report
    for context in contexts:
        context.close()
    assert messages == []
    assert all(address.startswith((report.as_uri(), 'data:')) for address in requests)


def verdict(page):
    return page.locator('.design-curves .verdict').inner_text()


def place(page):
    """Column and row of the design under the point."""
    return [int(page.locator('.design-slider input').nth(k).input_value()) for k in (0, 1)]


def stored(page):
    return json.loads(page.locator('#designs').text_content())[0]


def centre(locator):
    box = locator.bounding_box()
    return box['x'] + box['width'] / 2, box['y'] + box['height'] / 2


def moved(page, before):
    """The verdict once it differs from the one before."""
    page.wait_for_function(f"document.querySelector('.design-curves .verdict').innerText !== {json.dumps(before)}")
    return verdict(page)


def test_the_point_moves_by_mouse_and_the_verdict_names_the_nearest_design(opened):
    page = opened()
    before, start = verdict(page), place(page)
    x, y = centre(page.locator('.map-handle'))
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x - 120, y + 60, steps=6)
    page.mouse.up()
    after, now = moved(page, before), place(page)
    assert now[0] < start[0] and now[1] < start[1]
    axes = stored(page)
    for axis, k in (('x', now[0]), ('y', now[1])):
        assert f"{axes[axis]['name']} = {axes[axis]['words'][k]}" in after
    page.wait_for_function(f"location.hash.includes('design={now[0]},{now[1]}')")  # it is written at a rest


def test_a_click_on_the_map_moves_the_point(opened):
    page = opened()
    before = verdict(page)
    box = page.locator('.map-area').bounding_box()
    page.mouse.click(box['x'] + 2, box['y'] + box['height'] - 2)
    moved(page, before)
    assert place(page) == [0, 0]


def test_the_arrow_keys_move_the_point_by_one_design_and_with_shift_by_five(opened):
    page = opened('#design=10,10')
    page.locator('.map-handle').focus()
    for key, expected in (
        ('ArrowRight', [11, 10]),
        ('ArrowUp', [11, 11]),
        ('Shift+ArrowLeft', [6, 11]),
        ('Shift+ArrowDown', [6, 6]),
    ):
        before = verdict(page)
        page.keyboard.press(key)
        moved(page, before)
        assert place(page) == expected


def test_a_slider_moves_the_point_along_one_axis(opened):
    page = opened('#design=10,10')
    before = verdict(page)
    page.locator('.design-slider input').first.focus()
    page.keyboard.press('ArrowRight')
    moved(page, before)
    assert place(page) == [11, 10]


def test_a_finger_drags_the_point_and_does_not_scroll(opened):
    page = opened(viewport={'width': 390, 'height': 844}, has_touch=True, is_mobile=True)
    handle = page.locator('.map-handle')
    handle.scroll_into_view_if_needed()
    before, scrolled = verdict(page), page.evaluate('scrollY')
    x, y = centre(handle)
    touch = page.context.new_cdp_session(page)
    send = lambda kind, points: touch.send('Input.dispatchTouchEvent', {'type': kind, 'touchPoints': points})
    send('touchStart', [{'x': x, 'y': y}])
    for k in range(1, 8):
        send('touchMove', [{'x': x - 8 * k, 'y': y + 5 * k}])
    send('touchEnd', [])
    moved(page, before)
    assert page.evaluate('scrollY') == scrolled
    assert page.evaluate('document.documentElement.scrollWidth') <= 390


@pytest.mark.parametrize('design', ['0,50', '25,25', '50,0'])
def test_the_marked_maxima_are_the_exact_peaks_of_the_program(opened, design):
    page = opened(f'#design={design}')
    column, row = place(page)
    axes = stored(page)
    settings = [f"{axes[a]['parameter']}={axes[a]['values'][k]!r}" for a, k in (('x', column), ('y', row))]
    words = [word for setting in settings for word in ('--set', setting)]
    done = subprocess.run([TRIVET, 'peaks', str(PROJECT), '--json', *words], check=True, capture_output=True)
    exact = json.loads(done.stdout)['peaks']
    titles = page.locator('.design-curves .peak').evaluate_all('list => list.map(one => one.title)')
    units = {'m': 1, 'mm': 1e-3, 'µm': 1e-6, 'rad': 1, 'mrad': 1e-3, 'µrad': 1e-6}
    assert titles
    for title in titles:
        name, value, unit = re.match(r'peak of (\S+): ([0-9.e-]+) (\S+)', title).groups()
        frequency = float(re.search(r'\n([0-9.]+) rad/s', title).group(1))
        same = [p for p in exact if p['name'].endswith('.' + name.replace('θ', 'r'))]
        nearest = min(same, key=lambda p: abs(p['angular_frequency'] - frequency))
        assert abs(nearest['angular_frequency'] / frequency - 1) < 1e-4
        assert abs(nearest['amplitude'] / (float(value) * units[unit]) - 1) < WITHIN


@pytest.mark.parametrize('theme', ['light', 'dark'])
def test_axe_finds_nothing_in_the_view_of_the_design(opened, theme):
    page = opened(color_scheme=theme)
    page.evaluate(AXE.read_text())
    run = "async () => (await axe.run('.design-view', {resultTypes: ['violations']})).violations"
    assert [(v['id'], [n['html'][:120] for n in v['nodes']]) for v in page.evaluate(run)] == []


@pytest.mark.parametrize('scheme', ['light', 'dark'])
def test_hashes_fit_a_phone(browser, tmp_path, scheme):
    project = ROOT / 'examples/measured_mount/motor.toml'
    subprocess.run([TRIVET, 'run', str(project), '-o', str(tmp_path / 'out')], check=True, capture_output=True)
    context = browser.new_context(viewport={'width': 390, 'height': 844}, color_scheme=scheme)
    page = context.new_page()
    page.goto((tmp_path / 'out/report.html').as_uri())
    hashes = page.locator('.hashes td:nth-child(2)')
    assert hashes.count() == 3
    for i in range(hashes.count()):
        box = hashes.nth(i).bounding_box()
        assert box['x'] + box['width'] <= 390
    cut = page.locator('.hashes .scroll').evaluate('node => node.scrollWidth > node.clientWidth')
    assert not cut
    label = page.locator('.title-block dt', has_text='SHA-256').evaluate('node => node.getClientRects().length')
    assert label == 1
    context.close()
