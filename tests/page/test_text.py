# SPDX-License-Identifier: BSD-3-Clause
"""The file as text."""

from conftest import painted, settled


def test_the_caret_stays_in_view_when_messages_open(serve):
    page = serve('genset/genset.toml').page(size=(1280, 620))
    settled(page)
    page.get_by_role('tab', name='Text').click()
    page.locator('text-view .cm-content').click()
    page.keyboard.press('Control+End')
    page.keyboard.type('\nmas = 3')
    page.locator('.problems.error').wait_for()
    settled(page)
    painted(page)
    line, bottom, last = page.evaluate(
        """() => {
            const {editor} = document.querySelector('text-view'), {head} = editor.state.selection.main;
            return [editor.coordsAtPos(head).bottom, editor.scrollDOM.getBoundingClientRect().bottom, editor.state.doc.length === head];
        }"""
    )
    assert last and line <= bottom
