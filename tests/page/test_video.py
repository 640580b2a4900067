# SPDX-License-Identifier: BSD-3-Clause
"""The video of one period: its file is read by the rules of EBML, and played by Chromium."""
import base64
import io

import pytest
from PIL import Image

from conftest import drawn, settled
from test_pictures import picture, share_changed

ELEMENTS_WITHIN = {0x1A45DFA3, 0x18538067, 0x1549A966, 0x1654AE6B, 0xAE, 0xE0, 0x1F43B675}


def elements(data):
    """(identifier, content) of all elements of an EBML file, those within others after these."""
    at = 0

    def number(with_marker):
        nonlocal at
        width = 9 - data[at].bit_length()
        value = data[at] if with_marker else data[at] & (0xFF >> width)
        value = int.from_bytes(bytes([value]) + data[at + 1 : at + width], 'big')
        at += width
        return value

    while at < len(data):
        identifier, size = number(True), number(False)
        content = data[at : at + size]
        assert len(content) == size
        yield identifier, content
        if identifier in ELEMENTS_WITHIN:
            yield from elements(content)
        at += size


PLAYED = """async source => {
  const video = document.createElement('video');
  video.src = source;
  await new Promise((done, failed) => { video.onloadeddata = done; video.onerror = () => failed(video.error.message); });
  const canvas = document.createElement('canvas');
  [canvas.width, canvas.height] = [video.videoWidth, video.videoHeight];
  const at = async time => {
    await new Promise(done => { video.onseeked = done; video.currentTime = time; });
    canvas.getContext('2d').drawImage(video, 0, 0);
    return canvas.toDataURL();
  };
  return {duration: video.duration, pictures: [await at(0.001), await at(video.duration / 2)]};
}"""


def test_the_video_has_the_frames_of_exactly_one_period(serve, browser, tmp_path):
    page = serve('bogie/loaded_frame.toml').page()
    settled(page)
    page.get_by_role('slider', name='Speed').fill('2')
    page.get_by_label('Motion', exact=True).select_option('3')
    drawn(page)
    still = picture(page.locator('canvas.machine'))
    with page.expect_download(timeout=120_000) as download:
        page.get_by_role('button', name='Video').click()
    download.value.save_as(tmp_path / 'machine.webm')
    data = (tmp_path / 'machine.webm').read_bytes()
    frames, apart = 24, 21  # half a second: a period at 2 Hz
    blocks = [content for identifier, content in elements(data) if identifier == 0xA3]
    assert [int.from_bytes(block[1:3], 'big') for block in blocks] == [apart * i for i in range(frames)]
    assert len({block[4:] for block in blocks}) > frames / 2  # they move
    player = browser.new_page()
    played = player.evaluate(PLAYED, 'data:video/webm;base64,' + base64.b64encode(data).decode())
    player.close()
    assert played['duration'] == pytest.approx(frames * apart / 1000, abs=1e-3)
    first, half = (
        Image.open(io.BytesIO(base64.b64decode(p.split(',')[1]))).convert('RGB').resize(still.size)
        for p in played['pictures']
    )
    # The caption is not in the video, which has an even number of pixels and the losses of its coding.
    assert 2 * share_changed(still, first) < share_changed(still, half)
    assert share_changed(first, half) > 0.02
    assert page.get_by_role('slider', name='Phase').input_value() == '0'
