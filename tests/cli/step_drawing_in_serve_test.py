# SPDX-License-Identifier: BSD-3-Clause
"""A page that waits for the drawing of a STEP file keeps no question waiting, its own or of another page."""
import json
import os
import shutil
import time
import unittest

from serving import Served, answer, slower
from step_drawing_test import DATA, PROJECT

MESHING = 60  # [s]
SOON = 8 * slower  # [s] to open the project, with gmsh, and answer
NAME = "cylinder.step"


@unittest.skipUnless(shutil.which("gmsh"), "no gmsh")
class StepDrawingInServe(Served):
    def gmsh(self, instead):
        """PATH with a gmsh that does these lines of sh first when it is to mesh a surface; each such job adds a line to `jobs`."""
        programs = self.folder / "bin"
        programs.mkdir(exist_ok=True)
        (programs / "gmsh").write_text(
            f'#!/bin/sh\nif grep -q "Mesh 2;" job.geo; then\necho >> "{self.folder}/jobs"\n{instead}\nfi\n'
            f'exec {shutil.which("gmsh")} "$@"\n'
        )
        (programs / "gmsh").chmod(0o755)
        return os.environ | {"PATH": f"{programs}{os.pathsep}{os.environ['PATH']}", "TRIVET_GMSH_SECONDS": str(MESHING)}

    def jobs(self):
        path = self.folder / "jobs"
        return len(path.read_text().splitlines()) if path.exists() else 0

    def project(self, name=NAME):
        text = PROJECT.replace("FILE", name).replace("CHOICE", "")
        (self.folder / "machine.toml").write_text(text)
        return self.folder / "machine.toml"

    def setUp(self):
        super().setUp()
        for name in (NAME, "second.step"):
            shutil.copy(DATA / NAME, self.folder / name)

    def served(self, instead):
        return self.serve(self.project(), env=self.gmsh(instead))

    def ask(self, server, command, client="a", **question):
        """The connection on which the answer arrives."""
        body = json.dumps({"wants": [{"command": command}], **question}).encode()
        connection = server.connect()
        connection.sendall(server.head("POST", "/ask", len(body), X_Trivet_Client=client) + body)
        return connection

    def drawing(self, server, client="a"):
        """A question for a scene, when gmsh meshes for it."""
        asking = self.ask(server, "scene", client)
        self.wait_for_gmsh()
        return asking

    def wait_for_gmsh(self):
        for _ in range(200 * slower):
            if self.jobs():
                return
            time.sleep(0.05)
        self.fail("gmsh does not mesh")

    def drawn_as(self, connection):
        status, _, content = answer(connection)
        self.assertEqual(status, 200, content[:500])
        return json.loads(content)["results"][0]["json"]["bodies"][0]["drawn_as"]

    def test_a_newer_question_ends_the_drawing(self):
        server = self.served(f"sleep {MESHING}")
        asking = self.drawing(server)
        began = time.monotonic()
        self.assertEqual(answer(self.ask(server, "modes"))[0], 200)
        self.assertLess(time.monotonic() - began, SOON)
        self.assertEqual(answer(asking)[0], 409)

    def test_a_page_that_waits_for_the_drawing_of_another_can_go_on(self):
        server = self.served(f"sleep {MESHING}")
        self.drawing(server)
        waiting = self.ask(server, "scene", "b")
        time.sleep(1)
        began = time.monotonic()
        self.assertEqual(answer(self.ask(server, "modes", "b"))[0], 200)
        self.assertLess(time.monotonic() - began, SOON)
        self.assertEqual(answer(waiting)[0], 409)
        self.assertEqual(self.jobs(), 1)

    def test_the_drawing_of_another_file_does_not_wait(self):
        server = self.served(f"mkdir '{self.folder}/first' 2>/dev/null && sleep {MESHING}")
        self.drawing(server)
        text = self.project("second.step").read_text()
        began = time.monotonic()
        self.assertEqual(self.drawn_as(self.ask(server, "scene", "b", text=text)), "1 solid")
        self.assertLess(time.monotonic() - began, SOON)

    def test_an_interrupted_drawing_is_made_when_it_is_next_asked_for(self):
        server = self.served(f"mkdir '{self.folder}/first' 2>/dev/null && sleep {MESHING}")
        asking = self.drawing(server)
        self.assertEqual(answer(self.ask(server, "modes"))[0], 200)
        self.assertEqual(answer(asking)[0], 409)
        self.assertEqual(self.drawn_as(self.ask(server, "scene")), "1 solid")

    def test_a_failure_is_tried_again_but_not_at_once(self):
        server = self.served(f"mkdir '{self.folder}/first' 2>/dev/null && sleep 1 && exit 1")
        began = time.monotonic()
        self.assertEqual(self.drawn_as(self.ask(server, "scene")), "box of equal inertia")
        took = time.monotonic() - began
        self.assertEqual(self.drawn_as(self.ask(server, "scene")), "box of equal inertia")
        self.assertEqual(self.jobs(), 1)
        time.sleep(10 * took)
        self.assertEqual(self.drawn_as(self.ask(server, "scene")), "1 solid")
        self.assertEqual(self.jobs(), 2)

    def test_a_file_that_changed_is_drawn_anew_and_once(self):
        server = self.served("true")
        for job in (1, 2):
            for _ in range(2):
                self.assertEqual(self.drawn_as(self.ask(server, "scene")), "1 solid")
                self.assertEqual(self.jobs(), job)
            os.utime(self.folder / NAME, (job, job))


if __name__ == "__main__":
    unittest.main()
