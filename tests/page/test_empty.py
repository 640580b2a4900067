# SPDX-License-Identifier: BSD-3-Clause
"""`trivet serve` without a file teaches by three examples."""
from conftest import settled


def test_three_examples_can_be_opened_and_saved_as_a_download(serve, tmp_path):
    served = serve()
    page = served.page()
    buttons = page.locator('.examples button')
    buttons.first.wait_for()
    assert buttons.count() == 3
    for i in range(3):
        page = served.page()
        page.locator('.examples button').nth(i).click()
        settled(page)
        assert page.locator('result-tables').is_visible()
    with page.expect_download() as download:
        page.get_by_role('button', name='Save').click()
    download.value.save_as(tmp_path / 'machine.toml')
    assert 'trivet = 1' in (tmp_path / 'machine.toml').read_text()
