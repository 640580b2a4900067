# SPDX-License-Identifier: BSD-3-Clause
"""Limits of the file as lines in the chart: dragged and by keyboard; the verdict follows, and saving changes one number."""
import re

from conftest import drawn, settled
from test_pictures import picture
from test_play import changed_lines, command


def limit_of(page, result, number):
    """The line of a limit with this number of the file."""
    return page.get_by_role('slider', name=f'Limit of {result}', exact=True).filter(has_text=number)


def margin_on(line):
    return float(re.search(r'margin ([\d.]+)', line.inner_text()).group(1))


def requirement(file, subject, *words):
    return next(
        r
        for r in command('verdict', file, *words)['cases'][0]['requirements']
        if r['place'] and r['subject'] == subject
    )


def judged(page):
    """Waits until the margins at the lines are those of the present numbers."""
    settled(page)
    page.wait_for_function("() => ![...document.querySelectorAll('.limit')].some(l => l.textContent.includes('…'))")


def begins_with(page, words):
    """Does a settled page draw the quantity of the first limit that decides?"""
    return page.get_by_label('Quantity', exact=True).locator('option:checked').inner_text() == words


def choose_quantity(page, words):
    page.get_by_label('Quantity', exact=True).select_option(label=words)
    judged(page)


def test_a_dragged_limit_is_a_setting_and_its_margin_that_of_the_program(serve):
    served = serve('compressor/requirements.toml')
    page = served.page()
    settled(page)
    before = served.file.read_text()
    choose_quantity(page, 'force')
    line = limit_of(page, 'ground.force.z', '60 N')
    assert margin_on(line) == float(f"{requirement(served.file, 'ground.force.z')['margin']:.3g}")
    box = line.bounding_box()
    x, y = box['x'] + box['width'] / 2, box['y'] + box['height'] / 2
    page.mouse.move(x, y)
    page.mouse.down()
    for down in (6, 12, 18, 24):
        page.mouse.move(x, y + down)
        page.wait_for_timeout(40)
    page.mouse.up()
    moved = page.get_by_role('slider', name='Limit of ground.force.z', exact=True)
    judged(page)
    number = float(re.search(r'≤ ([\d.]+) N 0-p', moved.inner_text()).group(1))
    assert number < 59
    there = requirement(served.file, 'ground.force.z', '--set', f'requirements.limits."ground.force.z"="{number} N"')
    assert margin_on(moved) == float(f"{there['margin']:.3g}")
    assert (
        16 < moved.bounding_box()['y'] - box['y'] < 34
    )  # where it was dropped, in a chart that may have another height
    page.get_by_role('button', name='Save').click()
    page.get_by_text('requirements.toml is saved.').wait_for()
    lines = changed_lines(before, served.file.read_text())
    assert len(lines) == 2 and f'"ground.force.z" = "{number:g} N"' in lines[1]
    page.get_by_role('button', name='Undo').click()  # the drag is one step
    settled(page)
    assert '60 N' in moved.inner_text()


def test_a_limit_moves_by_keyboard_and_the_verdict_follows(serve):
    served = serve('compressor/requirements.toml')
    page = served.page()
    settled(page)
    page.get_by_text('met here, violated in case cold').wait_for()
    choose_quantity(page, 'force')
    line = page.get_by_role('slider', name='Limit of ground.force.z', exact=True)
    line.focus()
    page.keyboard.press('ArrowUp')
    judged(page)
    assert '60.6 N' in line.inner_text()
    while margin_on(line) > 1:
        page.keyboard.press('PageDown')
        judged(page)
    page.get_by_text(re.compile('1 of 16 requirements violated')).wait_for()
    assert 'violated' in line.get_attribute('class') and 'violated' in line.get_attribute('aria-valuetext')


def test_a_limit_is_drawn_with_curves_of_its_quantity_alone_and_others_are_stated(serve):
    served = serve('compressor/requirements.toml')
    page = served.page()
    judged(page)
    assert begins_with(page, 'displacement')
    limit_of(page, 'compressor.flange.x', '0.2 mm').wait_for()
    velocity = limit_of(page, 'compressor.flange.z', '4.5 mm/s')
    assert velocity.count() == 0
    page.locator('.readings summary').click()
    readings = page.locator('.readings').inner_text()
    assert 'it limits the velocity, the curve is the displacement' in readings
    at_rest = next(r for r in command('verdict', served.file)['cases'][0]['requirements'] if r['kind'] == 'static')
    words = f"{at_rest['shown_requirement']} ({at_rest['shown_value']}, margin {at_rest['margin']:.3g}): it limits the value at rest"
    assert words in readings
    choose_quantity(page, 'velocity')
    velocity.wait_for()
    assert limit_of(page, 'compressor.flange.x', '0.2 mm').count() == 0
    assert margin_on(velocity) == float(f"{requirement(served.file, 'compressor.flange.z')['margin']:.3g}")


def test_limits_of_speeds_and_of_lists_are_lines_too(serve):
    served = serve('fan/fan.toml')
    page = served.page()
    settled(page)
    assert begins_with(page, 'velocity')
    line = limit_of(page, 'fan.bearing.z', '4.5 mm/s rms')
    line.wait_for()
    assert margin_on(line) == float(f"{requirement(served.file, 'fan.bearing.z')['margin']:.3g}")
    served = serve('pump_set/pump.toml')
    page = served.page()
    settled(page)
    line = limit_of(page, 'pump.bearing.z', '2.3 mm/s')
    line.focus()
    page.keyboard.press('PageDown')
    settled(page)
    page.get_by_role('button', name='Save').click()
    page.get_by_text('pump.toml is saved.').wait_for()
    assert '{limit = "2.09 mm/s", band = ["1450 rpm", "1500 rpm"]},     # in operation' in served.file.read_text()


def test_a_curve_is_red_where_it_exceeds_a_limit_line_of_its_quantity(serve):
    page = serve('genset/genset.toml').page()
    settled(page)
    assert begins_with(page, 'velocity')
    choose_quantity(page, 'displacement')
    violated = (198, 26, 26)  # the colour of violated limits in light colours

    def red():
        drawn(page)
        return sum(n for n, colour in picture(page.locator('.amplitude')).getcolors(1 << 24) if colour == violated)

    assert red() == 0
    page.locator('.readings summary').click()
    assert (
        'genset.turbocharger.y within "vibration severity": it limits the velocity'
        in page.locator('.readings').inner_text()
    )
    choose_quantity(page, 'velocity')
    assert red() > 20
    assert page.locator('.readings summary').count() == 0


def test_a_limit_of_steady_motions_is_a_line_with_the_judged_value(serve):
    served = serve('snubber/genset.toml')
    page = served.page()
    judged(page)
    line = page.get_by_role('slider', name='Limit of genset.z', exact=True)
    line.wait_for()
    assert line.inner_text().startswith('steady ≤ 1.2')  # peaks leave room for the short form
    assert margin_on(line) == float(f"{requirement(served.file, 'genset.z')['margin']:.3g}")
    assert 'the largest deviation of the steady motions from rest' in line.get_attribute('aria-valuetext')


def test_a_limit_of_a_list_keeps_its_line_and_the_focus_while_it_moves(serve):
    page = serve('pump_set/pump.toml').page()
    judged(page)
    line = limit_of(page, 'pump.bearing.z', '2.3 mm/s')
    line.focus()
    page.evaluate(
        """() => {
          window.removed = 0;
          const count = all => all.forEach(m => { window.removed += m.removedNodes.length; });
          new MutationObserver(count).observe(document.querySelector('.limits'), {childList: true});
        }"""
    )
    for key, number in (('ArrowUp', '2.32 mm/s'), ('PageDown', '2.11 mm/s'), ('Control+z', '2.32 mm/s')):
        page.keyboard.press(key)
        limit_of(page, 'pump.bearing.z', number).wait_for()
        judged(page)
        assert page.evaluate("() => [window.removed, document.activeElement.getAttribute('role')]") == [0, 'slider']
