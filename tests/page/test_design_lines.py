# SPDX-License-Identifier: BSD-3-Clause
"""Designs within tolerances as lines in a page of `trivet sample` and in the report, opened from disk: ranges on the axes are selected by
mouse, touch and keys, and lines outside them fade."""
import json
import re
import subprocess

import pytest

from conftest import ROOT, TRIVET

PROJECT = ROOT / 'examples/paper/robust.toml'
AXE = ROOT / 'web/node_modules/axe-core/axe.min.js'  # installed by scripts/web
DESIGNS = 2000


@pytest.fixture(scope='module')
def project(tmp_path_factory):
    folder = tmp_path_factory.mktemp('robust')
    (folder / 'robust.toml').write_text(PROJECT.read_text().replace('100_000', str(DESIGNS)))
    return folder / 'robust.toml'


@pytest.fixture(scope='module')
def sampled(project):
    page = project.with_name('sample.html')
    subprocess.run([TRIVET, 'sample', str(project), '-o', str(page)], check=True, capture_output=True)
    return page


@pytest.fixture(scope='module')
def kept(project):
    """Kept designs as data, and the names of their numbers."""
    done = subprocess.run([TRIVET, 'sample', str(project), '--json'], check=True, capture_output=True, text=True)
    found = json.loads(done.stdout)
    return found['kept'], [one['drawn'] for one in found['kept_numbers']]


@pytest.fixture
def opened(browser, sampled):
    """opened(**context): the page in a browser whose console stays empty."""
    contexts, messages = [], []

    def open_page(file=sampled, **options):
        contexts.append(browser.new_context(**{'viewport': {'width': 1280, 'height': 900}, **options}))
        page = contexts[-1].new_page()
        page.on('console', lambda message: messages.append(message.text))
        page.on('pageerror', lambda error: messages.append(str(error)))
        page.goto(file.as_uri())
        return page

    yield open_page
    for context in contexts:
        context.close()
    assert messages == []


def count(page):
    page.evaluate('() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))')
    return page.locator('.design-count').inner_text()


def axis_of(page, name):
    axis = page.locator(f'.design-range[aria-label="{name}"]')
    axis.scroll_into_view_if_needed()
    return axis


def drag(page, axis, start, end):
    box = axis.bounding_box()
    at = [box['x'] + share * box['width'] for share in (start, end)]
    y = box['y'] + box['height'] / 2
    page.mouse.move(at[0], y)
    page.mouse.down()
    page.mouse.move(at[1], y, steps=5)
    page.mouse.up()


def selected(page):
    """Number of selected first designs, and of those that meet all requirements."""
    return [int(number) for number in re.match(r'(\d+) of 400 designs selected, (\d+) meet', count(page)).groups()]


def expected(kept, name, values):
    """The same from the data, of a range of one number."""
    designs, names = kept
    column = names.index(name)
    first = [one for one in designs if one['design'] < 400]
    inside = [one for one in first if values[0] <= one['numbers'][column] <= values[1]]
    return [len(inside), sum(one['verdict'] == 'met' for one in inside)]


def test_a_drag_selects_the_designs_in_its_range(opened, kept):
    page = opened()
    assert count(page).startswith('400 designs, ')
    outside = page.locator('[data-verdict] .outside')
    assert outside.count() == 0
    axis = axis_of(page, 'rubber')
    drag(page, axis, 0.25, 0.6)
    ends = [float(axis.locator('.design-end').nth(k).get_attribute('aria-valuenow')) for k in (0, 1)]
    assert selected(page) == expected(kept, 'rubber', ends)
    lines = page.locator('[data-verdict] polyline').count()
    assert 0 < outside.count() < lines == len(kept[0])
    assert page.locator('figure > .hint').inner_text().startswith('Selected: rubber: ')
    alone = selected(page)
    drag(page, axis_of(page, 'casting'), 0.5, 1)
    both = selected(page)
    assert 0 < both[0] < alone[0]  # ranges combine
    axis_of(page, 'casting').dblclick(position={'x': 400, 'y': 12})
    assert selected(page) == alone
    page.get_by_role('button', name='Clear all ranges').click()
    assert count(page).startswith('400 designs, ')
    assert outside.count() == 0


def test_margins_below_one_select_what_violates(opened):
    page = opened()
    axis = page.locator('.design-range[aria-label*="aggregate.x ≤"]').first
    axis.scroll_into_view_if_needed()
    line = page.locator('.design-axis[data-name*="aggregate.x ≤"]').first
    low, high, end = (float(line.get_attribute(f'data-{name}')) for name in ('from', 'to', 'end'))
    assert low < 1 < high
    assert line.get_attribute('data-logarithmic') is None
    drag(page, axis, 0, end * (1 - low) / (high - low) - 0.004)
    inside, met = selected(page)
    assert inside > 0 and met == 0


def test_a_range_is_moved_and_its_ends_too(opened):
    page = opened()
    axis = axis_of(page, 'rubber')
    ends = axis.locator('.design-end')
    shares = lambda: [float(ends.nth(k).evaluate('node => parseFloat(node.style.left)')) for k in (0, 1)]
    drag(page, axis, 0.2, 0.4)
    assert shares() == pytest.approx([20, 40], abs=0.5)
    drag(page, axis, 0.3, 0.5)  # the range
    assert shares() == pytest.approx([40, 60], abs=0.5)
    drag(page, axis, 0.6, 0.9)  # its end
    assert shares() == pytest.approx([40, 90], abs=0.8)
    drag(page, axis, 0.1, 0.2)  # another range
    assert shares() == pytest.approx([10, 20], abs=0.5)


def test_keys_move_the_ends_and_escape_clears(opened, kept):
    page = opened()
    axis = axis_of(page, 'rubber')
    end = axis.locator('.design-end').nth(1)
    end.focus()
    for key in ('Shift+ArrowLeft', 'Shift+ArrowLeft', 'ArrowLeft', 'ArrowRight', 'ArrowLeft'):
        page.keyboard.press(key)
    assert end.evaluate('node => node.style.left') == '79%'
    assert selected(page) == expected(kept, 'rubber', [0, float(end.get_attribute('aria-valuenow'))])
    assert end.get_attribute('aria-valuetext')
    page.keyboard.press('Shift+Tab')
    page.keyboard.press('End')  # not beyond the other end
    assert axis.locator('.design-end').nth(0).evaluate('node => node.style.left') == '79%'
    page.keyboard.press('Escape')
    assert count(page).startswith('400 designs, ')


def test_a_finger_selects_and_the_page_does_not_scroll(opened):
    page = opened(viewport={'width': 390, 'height': 844}, has_touch=True, is_mobile=True)
    axis = axis_of(page, 'rubber')
    page.locator('.scroll:has(.design-lines)').evaluate('node => { node.scrollLeft = 150; }')
    scrolled, box = page.evaluate('scrollY'), axis.bounding_box()
    touch = page.context.new_cdp_session(page)
    send = lambda kind, points: touch.send('Input.dispatchTouchEvent', {'type': kind, 'touchPoints': points})
    x, y = max(box['x'], 0) + 60, box['y'] + box['height'] / 2
    send('touchStart', [{'x': x, 'y': y}])
    for k in range(1, 9):
        send('touchMove', [{'x': x + 10 * k, 'y': y}])
    send('touchEnd', [])
    inside, _ = selected(page)
    assert 0 < inside < 400
    assert page.evaluate('scrollY') == scrolled
    assert page.evaluate('document.documentElement.scrollWidth') <= 390


def test_paper_and_pages_without_scripts_have_all_lines(opened):
    page = opened()
    drag(page, axis_of(page, 'rubber'), 0.4, 0.5)
    assert selected(page)[0] < 400
    page.emulate_media(media='print')
    line = page.locator('[data-verdict] .outside').first
    assert line.evaluate('node => getComputedStyle(node).stroke') in ('rgb(0, 114, 178)', 'rgb(213, 94, 0)')
    assert not page.locator('.design-status').is_visible()
    assert not page.locator('.design-range').first.is_visible()
    without = opened(java_script_enabled=False)
    assert without.locator('[data-verdict] polyline').count() > 400
    assert without.locator('.design-range').count() == 0


def test_the_report_has_it_too_and_is_accessible(opened, project):
    out = project.with_name('out')
    subprocess.run([TRIVET, 'run', str(project), '-o', str(out)], check=True, capture_output=True)
    page = opened(out / 'report.html')
    drag(page, axis_of(page, 'rubber'), 0.25, 0.6)
    assert 0 < selected(page)[0] < 400
    page.add_script_tag(path=AXE)
    run = "async () => (await axe.run('figure:has(.design-axis)', {resultTypes: ['violations']})).violations"
    assert [one['id'] for one in page.evaluate(run)] == []
