# SPDX-License-Identifier: BSD-3-Clause
"""The widget in a browser, with this process as its kernel."""

import base64
import gzip
import io
import json
import pathlib
import re
import shutil

import pytest
from conftest import example
from PIL import Image
from playwright.sync_api import sync_playwright

import trivet

GENSET = example("genset/genset.toml")
PROGRAM = pathlib.Path(trivet.__file__).parent / "page" / "widget.js"
PAGE = pathlib.Path(__file__).parent / "notebook_page.html"
SETTLED = """() => {
  const root = document.querySelector('#cell > div')?.shadowRoot;
  return root && root.querySelector('curve-chart .u-over') && !root.querySelector('.old');
}"""


@pytest.fixture(scope="module")
def browser():
    with sync_playwright() as playwright:
        path = shutil.which("chromium")
        assert path, "the tests of the widget need chromium"
        words = ["--enable-unsafe-swiftshader", "--no-sandbox"]
        opened = playwright.chromium.launch(executable_path=path, args=words)
        yield opened
        opened.close()


def new_page(browser, still=True):
    """A page, and what its console said; nothing is asked of the network."""
    context = browser.new_context(
        viewport={"width": 1000, "height": 900}, reduced_motion="reduce" if still else "no-preference"
    )
    page, said = context.new_page(), []
    # Chromium itself says that it draws in software.
    page.on("console", lambda message: "GPU stall" in message.text or said.append(message.text))
    page.on("pageerror", lambda error: said.append(str(error)))
    return page, said


@pytest.fixture
def shown(browser):
    """show(widget): a page with it; this process is its kernel."""
    contexts = []

    def show(widget, still=True):
        page, said = new_page(browser, still)
        contexts.append((page.context, said))

        def kernel(content):
            sent = []
            widget.send = lambda reply, buffers=(): sent.append(
                (reply, [base64.b64encode(b).decode() for b in buffers])
            )
            widget._handle_custom_msg(content, [])
            return sent

        page.expose_function("kernel", kernel)
        page.expose_function("kernelState", widget.set_state)
        page.route("**/*", lambda route: route.abort())
        page.route("http://notebook.test/", lambda route: route.fulfill(path=PAGE))
        page.route("http://notebook.test/widget.js", lambda route: route.fulfill(path=PROGRAM))
        page.goto("http://notebook.test/")
        page.wait_for_function(SETTLED)
        return page

    yield show
    for context, said in contexts:
        context.close()
        assert said == []


def frequencies_shown(page):
    page.get_by_role("tab", name="Modes").click()
    return [float(cell) for cell in page.locator("result-tables tbody td:nth-child(2)").all_inner_texts()]


def frequencies_of(project):
    return [float(f"{mode['frequency_hz']:.4g}") for mode in json.loads(project.modes().to_json())["modes"]]


def picture(locator):
    return Image.open(io.BytesIO(locator.screenshot())).convert("RGB")


def colours(image):
    return len(image.getcolors(maxcolors=1 << 24))


def test_a_slider_asks_the_kernel_and_python_has_its_project(shown):
    widget = trivet.open(GENSET).show()
    page = shown(widget)
    assert frequencies_shown(page) == frequencies_of(trivet.open(GENSET))
    number = page.get_by_label("mass of genset, value", exact=True)
    number.fill("5000 kg")
    number.press("Enter")
    page.wait_for_function(SETTLED)
    heavier = trivet.open(GENSET, {"bodies.genset.mass": "5000 kg"})
    assert frequencies_shown(page) == frequencies_of(heavier) != frequencies_of(trivet.open(GENSET))
    assert widget.project == heavier
    page.get_by_role("button", name="Undo").click()
    page.wait_for_function(SETTLED)
    assert widget.project == trivet.open(GENSET)


def test_a_click_on_a_curve_makes_the_machine_swing(shown):
    page = shown(trivet.open(GENSET).show())
    page.locator(".amplitude .u-over").click(position={"x": 120, "y": 60})
    page.wait_for_function(SETTLED)
    assert page.get_by_label("Motion", exact=True).input_value() == "frequency"
    assert "Operating shape" in page.locator(".caption").inner_text()


def kept_in(widget):
    """The results of the still, by command."""
    kept = gzip.decompress(base64.b64decode(re.search(r'data-kept="([^"]+)"', widget._still)[1]))
    return {result["command"]: result["json"] for result in json.loads(kept)["answer"]["results"]}


def test_a_still_has_the_whole_page_at_rest_and_nothing_compared(shown):
    widget = trivet.open(GENSET).show()
    page = shown(widget)
    page.get_by_text("compare", exact=True).click()
    page.get_by_label("mounts as three springs").check()
    number = page.get_by_label("mass of genset, value", exact=True)
    number.fill("5000 kg")
    number.press("Enter")
    page.wait_for_function(SETTLED)
    page.wait_for_timeout(1500)
    page.get_by_label("damped").check()
    page.wait_for_timeout(1500)
    heavier, kept = trivet.open(GENSET, {"bodies.genset.mass": "5000 kg"}), kept_in(widget)
    for command in ("scene", "modes", "curves", "roots", "check", "verdict"):
        keys = {"quantity": "velocity"} if command == "curves" else {}  # that of the limit, which is shown first
        assert kept[command] == json.loads(heavier._inner.ask(command, "", keys).json())


def test_a_map_is_computed_when_the_user_asks_for_it(shown):
    widget = trivet.open(example("paper/map.toml")).show()
    asked, answer = [], widget._answers.answer
    widget._answers = type("Answers", (), {"answer": lambda _, text: asked.append(text) or answer(text)})()
    page = shown(widget)
    page.get_by_role("tab", name="Map").click()
    compute = page.get_by_role("button", name="Compute the map")
    compute.wait_for()
    page.wait_for_timeout(1000)
    assert not [text for text in asked if '"map"' in text]
    compute.click()
    page.locator("map-panel canvas").wait_for()
    assert len([text for text in asked if '"map"' in text]) == 1
    assert compute.count() == 0


def test_the_styles_of_the_notebook_end_at_the_widget(shown):
    page = shown(trivet.open(GENSET).show())
    assert page.get_by_role("button", name="Play").is_visible()  # the notebook hides its own buttons
    assert "system-ui" in page.locator("machine-view .caption").evaluate("e => getComputedStyle(e).fontFamily")
    background = "() => getComputedStyle(document.body).backgroundColor"
    assert page.evaluate(background) == "rgb(255, 255, 255)"
    assert colours(picture(page.locator(".stage"))) > 200
    light = picture(page.locator("notebook-view header"))
    page.evaluate("() => { document.body.dataset.jpThemeLight = 'false'; }")
    page.wait_for_timeout(300)
    assert sum(picture(page.locator("notebook-view header")).getpixel((4, 4))) < 200 < sum(light.getpixel((4, 4)))
