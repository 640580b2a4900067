# SPDX-License-Identifier: BSD-3-Clause
"""What is drawn: pictures are not empty, they change with what they show, and WebGL is alive."""
import io

import pytest
from PIL import Image, ImageChops

from conftest import drawn, painted, settled

# test_picking looks at further ones.
EXAMPLES = ['paper/corrected.toml', 'isolator/hardening.toml', 'rubber_mounts/compressor.toml', 'frame/frame.toml']


def picture(locator):
    return Image.open(io.BytesIO(locator.screenshot())).convert('RGB')


def colours(image):
    return len(image.getcolors(maxcolors=1 << 24))


def share_changed(first, second):
    changed = ImageChops.difference(first, second).convert('L').point(lambda v: 255 if v > 12 else 0)
    return changed.histogram()[255] / (first.width * first.height)


def assert_alive(page):
    """The context of WebGL is not lost, and its pixels are not all alike."""
    assert page.evaluate("() => !document.querySelector('canvas.machine').getContext('webgl2').isContextLost()")
    assert colours(picture(page.locator('.stage'))) > 200


@pytest.mark.parametrize('theme', ['light', 'dark'])
def test_machine_and_curves_are_drawn_in_both_themes(serve, theme):
    page = serve('genset/genset.toml').page(theme=theme)
    settled(page)
    for width, height in ((1280, 800), (1920, 1080)):
        page.set_viewport_size({'width': width, 'height': height})
        drawn(page)
        assert_alive(page)
        assert colours(picture(page.locator('.amplitude'))) > 20, width
        back = picture(page.locator('header')).getpixel((2, 2))
        assert (sum(back) < 200) == (theme == 'dark'), width
        overflow = page.evaluate(
            '() => [document.documentElement.scrollWidth - innerWidth, document.documentElement.scrollHeight - innerHeight]'
        )
        assert overflow == [0, 0], width


@pytest.mark.parametrize('example', EXAMPLES, ids=[e.split('/')[0] for e in EXAMPLES])
def test_every_machine_is_drawn(serve, example):
    page = serve(example).page()
    settled(page)
    assert_alive(page)


def test_a_mode_moves_and_a_still_machine_does_not(serve):
    page = serve('bogie/loaded_frame.toml').page()
    settled(page)
    stage = page.locator('.stage')
    still = picture(stage)
    page.wait_for_timeout(400)
    assert share_changed(still, picture(stage)) == 0  # reduced motion: nothing moves by itself
    page.get_by_role('button', name='Play').click()
    page.wait_for_function("() => document.querySelector('page-shell').app.display.phase > 1")
    page.get_by_role('button', name='Stop').click()
    drawn(page)
    assert share_changed(still, picture(stage)) > 0.002


def test_modes_and_phases_look_different(serve):
    page = serve('bogie/loaded_frame.toml').page()
    settled(page)
    stage = page.locator('.stage')
    first = picture(stage)
    page.get_by_label('Motion', exact=True).select_option('3')
    drawn(page)
    third = picture(stage)
    assert share_changed(first, third) > 0.002
    page.get_by_role('slider', name='Phase').fill('180')
    drawn(page)
    assert share_changed(third, picture(stage)) > 0.002
    page.get_by_label('Motion', exact=True).select_option('rest')
    drawn(page)
    assert share_changed(third, picture(stage)) > 0.002


def test_a_selected_mount_stands_out_in_the_picture_and_in_the_tree(serve):
    page = serve('bogie/loaded_frame.toml').page()
    settled(page)
    page.get_by_role('tab', name='Model').click()
    plain = picture(page.locator('.stage'))
    page.locator('model-tree summary', has_text='spring front left').click()
    drawn(page)
    assert share_changed(plain, picture(page.locator('.stage'))) > 0.0002
    assert page.locator('model-tree .chosen').inner_text() == 'spring front left'


def test_the_saved_picture_is_what_is_seen(serve, tmp_path):
    page = serve('bogie/loaded_frame.toml').page()
    settled(page)
    with page.expect_download() as download:
        page.get_by_role('button', name='PNG').click()
    download.value.save_as(tmp_path / 'machine.png')
    saved = Image.open(tmp_path / 'machine.png')
    assert colours(saved.convert('RGB')) > 200
    ink = (36, 50, 59)  # of the text; nothing of the machine is at the top of this picture
    title = saved.convert('RGB').crop((0, 0, saved.width, 60)).getcolors(1 << 24)
    assert sum(n for n, colour in title if colour == ink) > 300
    assert saved.width / saved.height == pytest.approx(
        page.evaluate(
            "() => { const c = document.querySelector('canvas.machine'); return c.clientWidth / c.clientHeight; }"
        ),
        rel=0.01,
    )


def test_the_picture_is_that_of_the_last_step_of_a_slider(serve):
    """Without a graphics processor pictures are left out while it moves."""
    page = serve('genset/genset.toml').page()
    settled(page)
    page.locator('.amplitude .u-over').click(position={'x': 60, 'y': 60})  # the operating shape at this frequency
    settled(page)
    stage = page.locator('.stage')
    before = picture(stage)
    slider = page.locator('.sliders input[type=range]').first
    for step in range(12):
        slider.fill(str(500 + 40 * step))
    settled(page)
    drawn(page)
    shown = picture(stage)
    page.evaluate("() => document.querySelector('machine-view').stage.drawNow()")
    painted(page)
    assert share_changed(shown, picture(stage)) == 0
    assert share_changed(before, shown) > 0.002
