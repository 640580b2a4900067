# SPDX-License-Identifier: BSD-3-Clause
"""The messages of the widget: its answers are the results of the command line, without a browser."""

import base64
import gzip
import json
import re
import subprocess
import sys

import pytest
from conftest import example

import trivet
from trivet._widget import Widget

GENSET = example("genset/genset.toml")
MASS = "bodies.genset.mass"


def sent_to(widget, message):
    """What the widget sends when the page sends a message."""
    sent = []
    widget.send = lambda content, buffers=(): sent.append((content, [bytes(one) for one in buffers]))
    widget._handle_custom_msg(message, [])
    return sent


def answer_to(widget, wants, settings=(), **more):
    question = {"revision": 3, "settings": list(settings), "case": "", "wants": wants, **more}
    ((content, (data,)),) = sent_to(widget, {"id": "a 1", "ask": "answer", "question": question})
    assert content == {"id": "a 1"}
    return json.loads(data)


def kept_in(html):
    """The state that a still has."""
    return json.loads(gzip.decompress(base64.b64decode(re.search(r'data-kept="([^"]+)"', html)[1])))


@pytest.fixture
def widget():
    return trivet.open(GENSET).show()


@pytest.mark.parametrize("settings", [(), (f'{MASS} = "5 t"',)], ids=["as in the file", "changed"])
def test_results_are_those_of_the_command_line(widget, command_line, settings):
    words = [word for setting in settings for word in ("--set", setting)]
    found = answer_to(widget, [{"command": "modes"}, {"command": "scene"}, {"command": "curves"}], settings)
    assert (found["revision"], found["ok"]) == (3, True)
    for result in found["results"]:
        assert result["ok"]
        assert result["json"] == json.loads(command_line(result["command"], GENSET, "--json", *words))


def test_a_wrong_number_is_content_and_a_wrong_question_an_error(widget):
    found = answer_to(widget, [{"command": "modes"}], [f"{MASS} = -1"])
    assert not found["ok"]
    assert any(problem["severity"] == "error" and "mass" in problem["message"] for problem in found["problems"])
    refused = answer_to(widget, [{"command": "map", "keys": {"picture": "map.svg"}}])["results"][0]
    assert "writes no files" in refused["problems"][0]["message"]
    ((content, buffers),) = sent_to(widget, {"id": "a 2", "ask": "answer", "question": {"text": "trivet = 1"}})
    assert content["id"] == "a 2" and "file is fixed" in content["error"] and not buffers


def test_a_failure_of_the_kernel_reaches_the_page(widget, monkeypatch):
    def interrupted(message):
        raise KeyboardInterrupt

    monkeypatch.setattr(widget, "_answer", interrupted)
    sent = []
    monkeypatch.setattr(widget, "send", lambda content, buffers=(): sent.append(content))
    with pytest.raises(KeyboardInterrupt):
        widget._receive(widget, {"id": "a 3", "ask": "answer"}, [])
    assert sent == [{"id": "a 3", "error": "The computation was interrupted."}]


def test_the_page_opens_with_the_changes_of_the_project():
    project = trivet.open(GENSET, {MASS: "5 t"})
    widget = project.show(sliders='bodies."genset".inertia.xx')
    ((content, (data,)),) = sent_to(widget, {"id": "b 1", "ask": "open"})
    opened = json.loads(data)
    assert opened["text"] == trivet.open(GENSET).to_toml()
    assert opened["settings"] == [[MASS, '"5 t"']]
    assert opened["sliders"] == ["bodies.genset.inertia.xx"]


def test_the_project_of_the_sliders_is_a_project(widget):
    assert widget.project == trivet.open(GENSET)
    widget.set_state({"_settings": [f'{MASS} = "5 t"']})  # as the page does
    assert widget.project == trivet.open(GENSET, {MASS: "5 t"})
    assert widget.project.bodies["genset"].mass == 5000.0


def test_a_still_has_the_last_state(widget):
    heavier = [f'{MASS} = "5 t"']
    found = answer_to(widget, [{"command": "scene"}, {"command": "modes"}, {"command": "curves"}], heavier)
    widget.set_state({"_settings": heavier})
    # What the page asks besides is no part of its state: a result that it has, a draft, what it compares.
    asked = [{"command": "scene", "known": found["results"][0]["hash"]}]
    assert answer_to(widget, asked, heavier)["results"][0]["json"] is None
    answer_to(widget, [{"command": "curves", "keys": {"three_springs": True}}], heavier)
    answer_to(widget, [{"command": "curves", "keys": {"draft": True}}])
    updated = []
    widget._stills = [type("Handle", (), {"update": lambda self, html: updated.append(html.data)})()]
    sent_to(widget, {"ask": "keep", "view": {"damped": True}, "answer": found})
    kept = kept_in(updated[-1])
    assert kept["view"] == {"damped": True}
    assert kept["opened"]["settings"] == [[MASS, '"5 t"']]
    assert kept["answer"] == found
    assert "<table" in updated[-1]  # without scripts


def test_a_still_has_results_before_a_page_asks(widget, monkeypatch, command_line):
    shown = []
    monkeypatch.setattr("trivet._widget._notebook.display", lambda data, **_: shown.append(data))
    widget._ipython_display_()
    (still,) = (one.data for one in shown if "data-trivet-still=" in getattr(one, "data", ""))
    results = {result["command"]: result["json"] for result in kept_in(still)["answer"]["results"]}
    for command in ("scene", "modes", "curves", "roots", "check", "verdict"):
        assert results[command] == json.loads(command_line(command, GENSET, "--json"))


def test_wrong_sliders_and_cases_are_reported(machine):
    with pytest.raises(trivet.UnknownName, match="bodies.machine.mas"):
        machine.show(sliders=["bodies.machine.mas"])
    with pytest.raises(trivet.InputError, match="one number"):
        machine.show(sliders=["elements.a.translation"])
    with pytest.raises(trivet.UnknownName, match="winter"):
        machine.show(case="winter")


def test_without_anywidget_the_message_says_what_to_install():
    code = (
        "import sys; sys.modules['anywidget'] = None; import trivet\n"
        "trivet.Project.from_toml(trivet.starter()).show()"
    )
    found = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert found.returncode == 1
    assert 'pip install "trivet[notebook]"' in found.stderr


def test_the_class_is_the_one_of_the_annotation(machine):
    assert isinstance(machine.show(), Widget)
