# SPDX-License-Identifier: BSD-3-Clause
"""The widget of a project in notebooks: its page is web/src/widget.ts, its answers are those of `trivet serve`."""

from __future__ import annotations

import base64
import gzip
import json
import pathlib
import re
import uuid
from collections.abc import Callable
from html import escape
from typing import TYPE_CHECKING, Any

import anywidget
import IPython.display
import traitlets

from trivet import _core, _html
from trivet._arguments import require_text
from trivet._errors import InputError, NotComputable, problem, unknown_name
from trivet._result import Result
from trivet._values import key_text

if TYPE_CHECKING:
    from trivet._project import Project

_notebook: Any = IPython.display  # its functions have no types
_program = pathlib.Path(__file__).parent / "page" / "widget.js"
_number = re.compile(r"[+-]?[\d.][\d.eE+-]*(\s|$)")
#: Results of a still that no page has sent: of a notebook that was executed without a front end.
_first_results = ("scene", "modes", "curves", "roots", "check", "verdict")


class Widget(anywidget.AnyWidget):
    """A machine in a notebook: `project.show()`. It is shown as the result of a cell, or with IPython's `display`."""

    _esm = _program
    _settings = traitlets.List(traitlets.Unicode()).tag(sync=True)
    _case = traitlets.Unicode().tag(sync=True)

    def __init__(self, project: Project, sliders: list[str], case: str) -> None:
        sliders = [_number_path(project, path) for path in sliders]
        require_text("case", case)
        if case and case not in project.cases:
            raise unknown_name("case", case, "case", project.cases)
        super().__init__(_settings=project._inner.settings, _case=case)
        self._project, self._sliders = project, sliders
        self._answers = _core.Answers(project._inner, project._folder)
        self._still = ""  # HTML of the state at which the page last was at rest
        self._key = uuid.uuid4().hex
        self._stills: list[Any] = []  # handles of the stills in cells
        self.on_msg(self._receive)

    @property
    def project(self) -> Project:
        """The project with the numbers that the sliders have now. Raises InputError if they are wrong."""
        return self._project._changed(dict(setting.split(" = ", 1) for setting in self._settings))

    @property
    def case(self) -> str:
        """Name of the case on the widget; "" is the base model."""
        return str(self._case)

    def _ipython_display_(self) -> None:
        """The widget, and in its place a still for when no kernel answers: in an exported or reopened notebook."""
        if not self._still:
            self._still = self._still_of({}, self._first_answer())
        if (bundle := self._repr_mimebundle_()) is not None:
            _notebook.display(bundle[0], raw=True)
        still = _notebook.display(_notebook.HTML(self._still), display_id=True)
        if still is not None:
            self._stills.append(still)
        _notebook.display(_notebook.HTML(_still_program()))

    def _receive(self, _: object, message: dict[str, Any], buffers: object) -> None:
        """A message of the page. A question has an id, and gets one answer."""
        replies: dict[str, Callable[[dict[str, Any]], str]] = {
            "open": lambda _: json.dumps(self._opened()), "answer": self._answer, "keep": self._keep,
        }  # fmt: skip
        identity = message.get("id")
        try:
            answer = replies[message["ask"]](message)
        except BaseException as reason:  # also of Ctrl-C: the page must not wait for ever
            self.send({"id": identity, "error": str(reason) or "The computation was interrupted."})
            if not isinstance(reason, (InputError, NotComputable)):
                raise
        else:
            if identity is not None:
                self.send({"id": identity}, buffers=[answer.encode()])

    def _opened(self) -> dict[str, Any]:
        """What the page has to know of the project."""
        project = self._project
        return {
            "name": pathlib.Path(project.source).name,
            "title": project.title,
            "text": project._inner.text,
            "settings": [setting.split(" = ", 1) for setting in self._settings],
            "case": self._case,
            "sliders": self._sliders,
            "key": self._key,
        }

    def _first_answer(self) -> dict[str, Any]:
        steady = ["steady"] if "steady" in self._project._tables().get("analyses", {}) else []
        wants = [{"command": name} for name in [*_first_results, *steady]]
        question = {"revision": 0, "settings": self._settings, "case": self._case, "wants": wants}
        answer: dict[str, Any] = json.loads(self._answer({"question": question}))
        return answer

    def _answer(self, message: dict[str, Any]) -> str:
        return self._answers.answer(json.dumps(message["question"]))

    def _keep(self, message: dict[str, Any]) -> str:
        """The page is at rest: what it shows becomes the still."""
        self._still = self._still_of(message["view"], message["answer"])
        for still in self._stills:
            still.update(_notebook.HTML(self._still))
        return ""

    def _still_of(self, view: dict[str, Any], answer: dict[str, Any]) -> str:
        """The present state, for a document without a kernel. Without scripts it is a table.

        view: how the results are shown; answer: the results, as of `trivet serve`
        """
        kept = json.dumps({"opened": self._opened(), "view": view, "answer": answer})
        return f'<div data-trivet-still="{self._key}" data-kept="{_packed(kept)}">{self._tables()}</div>'

    def _tables(self) -> str:
        try:
            project = self.project
            modes = Result(project._inner.ask("modes", self._case), project)
        except (InputError, NotComputable) as reason:
            return f"<pre>{escape(str(reason))}</pre>"
        return _html.project(project) + _html.result(modes)


def _still_program() -> str:
    """Draws the stills of a page in which no widget has come to life, with the program of the widget."""
    return f"""<script>setTimeout(async () => {{
  const open = () => [...document.querySelectorAll("[data-trivet-still][data-kept]")].some(still => still.offsetParent);
  if (!open()) return;
  const bytes = Uint8Array.from(atob("{_packed(_program.read_text("utf-8"))}"), c => c.charCodeAt(0));
  const text = await new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"))).text();
  const widget = await import(URL.createObjectURL(new Blob([text], {{type: "text/javascript"}})));
  if (open()) await widget.showStills();
}}, 1000)</script>"""


def _packed(text: str) -> str:
    return base64.b64encode(gzip.compress(text.encode(), mtime=0)).decode()


def _number_path(project: Project, path: str) -> str:
    """The path as the page writes it. Raises InputError unless it is of a number of the file, perhaps with a unit."""
    value = project[path]
    if isinstance(value, bool) or not _number.match(str(value)):
        raise InputError([problem("sliders", path, "a slider moves one number of the file", "name another path")])
    return ".".join(key_text(key) for key in _core.path_keys(path))
