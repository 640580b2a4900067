# SPDX-License-Identifier: BSD-3-Clause
"""`trivet serve` and a browser with it. TRIVET names the program; Chromium draws in software."""
import contextlib
import os
import pathlib
import shutil
import subprocess

import pytest
from playwright.sync_api import sync_playwright

ROOT = pathlib.Path(__file__).resolve().parents[2]
TRIVET = os.environ.get('TRIVET', str(ROOT / 'build/release/apps/cli/trivet'))
CHROMIUM = shutil.which('chromium') or '/usr/bin/chromium'
# For each page Chromium would start a process with the 400 scripts of its own address bar, and one for a page that never comes.
UNUSED = 'WebUIOmniboxPopup,WebUIOmniboxAimPopup,WebUIOmniboxFullPopup,SpareRendererForSitePerProcess'


@pytest.fixture(scope='session')
def browser():
    with sync_playwright() as playwright:
        arguments = ['--enable-unsafe-swiftshader', '--no-sandbox', f'--disable-features={UNUSED}']
        opened = playwright.chromium.launch(executable_path=CHROMIUM, args=arguments)
        yield opened
        opened.close()


def complaints(messages):
    """Those of a console that are not of the browser itself, which writes that it draws in software, and that a question was refused:
    one that began before a save is asked again with its text (412), and one that an older question replaced is asked again (409).
    """
    usual = ('GPU stall due to ReadPixels', 'status of 412', 'status of 409')
    return [message for message in messages if not any(words in message for words in usual)]


class Served:
    """A copy of an example that `trivet serve` opened, and pages on it."""

    def __init__(self, browser, folder, example):
        self.browser, self.pages = browser, []
        self.messages, self.requests = [], []  # of the consoles; addresses asked for
        self.words = [TRIVET, 'serve', '--no-browser']
        if example:
            source = ROOT / 'examples' / example
            shutil.copytree(source.parent, folder, dirs_exist_ok=True)
            self.file = folder / source.name
            self.words.append(str(self.file))
        self.login = folder.with_name(folder.name + ' login')  # a private folder, as a login of the system has one
        self.login.mkdir(mode=0o700)
        self.start()

    def start(self, *words, login=True):
        environment = os.environ | {'XDG_RUNTIME_DIR': str(self.login) if login else ''}
        self.process = subprocess.Popen([*self.words, *words], stdout=subprocess.PIPE, text=True, env=environment)
        self.address = self.process.stdout.readline().strip()
        assert self.address.startswith('http://127.0.0.1:'), self.address

    @property
    def port(self):
        return self.address.split(':')[2].split('/')[0]

    def page(self, size=(1280, 800), theme='light', still=True):
        """A page that shows the machine; with `still` nothing moves by itself."""
        context = self.browser.new_context(
            viewport={'width': size[0], 'height': size[1]},
            color_scheme=theme,
            reduced_motion='reduce' if still else 'no-preference',
        )
        page = context.new_page()
        page.on('console', lambda message: self.messages.append(message.text))
        page.on('pageerror', lambda error: self.messages.append(str(error)))
        page.on('request', lambda request: self.requests.append(request.url))
        page.goto(self.address)
        self.pages.append(context)
        return page

    def kill(self):
        self.process.kill()
        self.process.wait(timeout=10)
        self.process.stdout.close()

    def close(self):
        for context in self.pages:
            context.close()
        if self.process.poll() is None:
            self.process.terminate()
            self.process.wait(timeout=10)
            self.process.stdout.close()


@pytest.fixture
def serve(browser, tmp_path):
    """serve('genset/genset.toml'): that example, served; its page may write nothing to the console."""
    all_served = []

    def start(example=''):
        all_served.append(Served(browser, tmp_path / str(len(all_served)), example))
        return all_served[-1]

    yield start
    for served in all_served:
        served.close()
    for served in all_served:
        assert complaints(served.messages) == []
        assert all(address.startswith((served.address.split('#')[0], 'blob:', 'data:')) for address in served.requests)


@contextlib.contextmanager
def unanswered(page):
    """Holds every question of the page to the program until the end of the block, then lets them and all later ones pass."""
    held, ended = [], []
    page.route('**/ask', lambda route: route.continue_() if ended else held.append(route))
    try:
        yield
    finally:
        ended.append(True)
        for route in held:
            route.continue_()


def settled(page):
    """Waits until every result on the page is that of the present state."""
    page.wait_for_function("() => document.querySelector('curve-chart .u-over') && !document.querySelector('.old')")


def drawn(page):
    """Waits until machine and charts are drawn as the present state has them."""
    settled(page)
    page.wait_for_function(
        "() => { const {stage} = document.querySelector('machine-view'); return !stage.isBehind && !stage.wanted; }"
    )
    painted(page)


def painted(page):
    """Waits until what was changed is laid out and painted."""
    page.evaluate('() => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))')
