# SPDX-License-Identifier: BSD-3-Clause
"""A violation where the requirements are not binding is said to be so, and is not red."""
from conftest import drawn
from test_limits import choose_quantity, judged
from test_map import map_of
from test_pictures import picture

RED, OCHRE = (198, 26, 26), (169, 138, 92)  # of violated limits in light colours, binding and not
SOFT_CASE = """trivet = 1
[bodies.machine]
mass = 4
inertia = {about = "center_of_mass", xx = 1, yy = 1, zz = 1}
free = ["z"]
[elements.spring]
type = "bushing"
on = "machine"
at = [0, 0, 0]
translation = [900, 900, 900]
damping = {proportional = 0.05}
[excitations.force]
type = "harmonic"
on = "machine"
at = [0, 0, 0]
force = [0, 0, 18]
[requirements]
limits = {"machine.z" = "29 mm"}
hold_in = [""]
[analyses]
response = {band = ["0 Hz", "6 Hz"]}
[analyses.map]
x = {parameter = "elements.spring.scale", from = 0.1, to = 4, points = 9}
y = {parameter = "elements.spring.damping.proportional", from = 0.01, to = 0.3, points = 9}
[cases.soft]
elements.spring.scale = 0.25
"""


def pixels(locator, colour):
    return sum(n for n, found in picture(locator).getcolors(1 << 24) if found == colour)


def background(locator):
    return locator.evaluate('e => getComputedStyle(e).backgroundColor')


def test_a_case_that_does_not_decide_has_no_red_violation(serve):
    page = serve('compressor/requirements.toml').page()
    judged(page)
    pill = page.locator('.pill')
    red = background(pill)  # violated in case cold
    page.get_by_label('Case', exact=True).select_option('stiffer')
    page.get_by_text('violated in case cold; 3 of 16 requirements violated here, not binding').wait_for()
    assert background(pill) == red
    page.get_by_text('The requirements are not binding in this case.').wait_for()
    assert page.locator('result-tables tr.violated').count() == 0
    assert page.locator('result-tables tr.unbinding').count() == 3
    choose_quantity(page, 'velocity')
    line = page.get_by_role('slider', name='Limit of compressor.flange.z', exact=True)
    assert 'margin 0.755, not binding' in line.inner_text() and 'violated' not in line.get_attribute('class')
    drawn(page)
    assert pixels(page.locator('.amplitude'), RED) == 0 and pixels(page.locator('.amplitude'), OCHRE) > 20


def test_only_violations_that_are_not_binding_are_no_red_verdict(serve):
    served = serve('compressor/requirements.toml')
    served.file.write_text(served.file.read_text().replace('hold_in = ["", "cold"]', 'hold_in = [""]'))
    page = served.page()
    judged(page)
    assert 'all 16 requirements met' in page.locator('.pill').inner_text()
    row = page.locator('result-tables tbody tr').filter(has_text='compressor.flange.z').first
    assert '0.714 cold, not binding' in row.inner_text() and row.locator('.bad').count() == 0
    page.get_by_label('Case', exact=True).select_option('cold')
    page.get_by_text('1 of 16 requirements violated here, not binding').wait_for()
    assert 'unbinding' in page.locator('.pill').get_attribute('class')


def test_a_case_on_a_map_is_red_only_if_the_design_has_to_hold_in_it(serve):
    page = map_of(serve('paper/map.toml'))  # without [requirements] the rules of the map decide in all cases
    assert pixels(page.locator('.map'), RED) > 5 and pixels(page.locator('.map'), OCHRE) == 0
    served = serve('isolator/hardening.toml')
    served.file.write_text(SOFT_CASE)
    page = map_of(served)
    assert pixels(page.locator('.map'), RED) == 0 and pixels(page.locator('.map'), OCHRE) > 5
    page.locator('map-panel').get_by_text('ochre where that is not binding').wait_for()
