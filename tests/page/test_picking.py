# SPDX-License-Identifier: BSD-3-Clause
"""Every machine is drawn, and every mount that is seen can be selected in the picture, through a body in front of it, too."""
import pytest

from conftest import drawn, settled
from test_pictures import assert_alive

# Places on the screen along each element, from end to end, as the camera projects them.
PLACES = """() => {
  const view = document.querySelector('machine-view'), {camera} = view.stage, {left, top, width, height} = view.querySelector('canvas').getBoundingClientRect();
  return view.machine.elements.map(({element, ends}) => ({name: element.name, places: [0.1, 0.3, 0.5, 0.7, 0.9].map(share => {
    const at = ends.from.clone().lerp(ends.to, share).project(camera);
    return [left + (at.x + 1) / 2 * width, top + (1 - at.y) / 2 * height];
  })}));
}"""


def selected(page):
    return page.evaluate("() => document.querySelector('page-shell').app.state.selection")


def at_rest(serve, example):
    page = serve(example).page()
    settled(page)
    page.get_by_label('Motion', exact=True).select_option('rest')
    drawn(page)
    return page


@pytest.mark.parametrize(
    ('example', 'most_covered'),
    [
        ('genset/genset.toml', 0),
        ('compressor/requirements.toml', 0),
        ('powertrain/decoupled.toml', 0),
        ('two_stage/pump_on_raft.toml', 0),
        ('bogie/loaded_frame.toml', 0),
        ('roll_stop/engine.toml', 1),  # two stops at one place
    ],
)
def test_every_machine_is_drawn_and_its_elements_can_be_selected(serve, example, most_covered):
    page = at_rest(serve, example)
    assert_alive(page)
    missed = []
    for element in page.evaluate(PLACES):
        found = []
        for x, y in element['places']:
            page.mouse.click(x, y)
            found.append(selected(page))
        if {'kind': 'element', 'name': element['name']} not in found:
            missed.append((element['name'], found))
    assert len(missed) <= most_covered, missed


def test_an_excitation_is_selected_at_its_arrow_alone(serve):
    page = at_rest(serve, 'genset/genset.toml')
    canvas = page.locator('canvas.machine').bounding_box()
    hits = {}
    for i in range(1, 16):
        for j in range(1, 16):
            x, y = canvas['x'] + i * canvas['width'] / 16, canvas['y'] + j * canvas['height'] / 16
            page.mouse.click(x, y)
            found = selected(page)
            kind = found['kind'] if found else ''
            hits[kind] = hits.get(kind, 0) + 1
    assert hits.get('force', 0) <= 4 and hits['body'] > 20 and hits[''] > 50, hits
