# SPDX-License-Identifier: BSD-3-Clause
"""The server of the page, spoken to through raw sockets: its answers and files."""
import json
import os
import pathlib
import select
import signal
import stat
import time
import unittest

from serving import GENSET, Served, answer, slower
from trivet_test import PAPER, SOURCE, trivet


class Answers(Served):
    def test_results_are_the_bytes_that_the_commands_print(self):
        for name in ("paper/corrected.toml", "isolator/hardening.toml", "genset/genset.toml"):
            file = SOURCE / "examples" / name
            server = self.serve(file)
            project = server.data("GET", "/project")
            self.assertEqual(project["name"], file.name)
            self.assertEqual(project["text"], file.read_text())
            self.assertEqual(project["problems"], [])
            self.assertEqual(project["cases"][0], "")
            names = {command["name"] for command in project["commands"]}
            self.assertLessEqual({"modes", "response", "verdict"}, names)
            self.assertFalse({"run", "export", "new"} & names)
            for command, keys in (
                ("modes", {}),
                ("roots", {}),
                ("response", {"band": "0.5 Hz, 30 Hz"}),
                ("static", {}),
            ):
                want = {"command": command, "keys": keys}
                status, _, body = server.send("POST", "/ask", {"revision": 7, "wants": [want]})
                found = json.loads(body)
                self.assertEqual((status, found["revision"], found["ok"]), (200, 7, True), body[:500])
                options = [word for key, value in keys.items() for word in (f"--{key}", value)]
                printed = trivet(command, file, "--json", *options)
                if printed.returncode != 0:
                    self.assertFalse(found["results"][0]["ok"])
                    continue
                self.assertIn(b'"json":' + printed.stdout.encode() + b"}", body, f"{name} {command}")

    def test_settings_texts_and_cases(self):
        server = self.serve(GENSET)
        settings = ['bodies.genset.mass = "5 t"']
        wants = [{"command": "modes"}]
        plain = server.data("POST", "/ask", {"wants": wants})["results"][0]["json"]
        changed = server.data("POST", "/ask", {"settings": settings, "wants": wants})["results"][0]["json"]
        printed = trivet("modes", GENSET, "--json", "--set", settings[0])
        self.assertEqual(changed, json.loads(printed.stdout))
        self.assertNotEqual(plain["modes"], changed["modes"])
        written = server.data("POST", "/text", {"settings": settings})["text"]
        self.assertEqual(
            server.data("POST", "/ask", {"text": written, "wants": wants})["results"][0]["json"]["modes"],
            changed["modes"],
        )
        unknown = server.data("POST", "/ask", {"case": "no such", "wants": wants})["results"][0]
        self.assertFalse(unknown["ok"])
        self.assertIn("no such case", json.dumps(unknown["problems"]))

    def test_a_version_stands_for_its_text(self):
        file = self.file(GENSET.read_text())
        server = self.serve(file)
        opened = server.data("GET", "/project")["version"]
        question = {"version": opened, "wants": [{"command": "modes"}]}
        before = server.data("POST", "/ask", question)["results"][0]["json"]
        self.assertEqual(server.data("GET", "/version")["version"], opened)
        file.write_text(file.read_text().replace('mass = "4200 kg"', 'mass = "4900 kg"', 1))
        changed = server.data("GET", "/version")["version"]
        self.assertNotEqual(changed, opened)
        self.assertEqual(server.data("POST", "/ask", question)["results"][0]["json"], before)  # not opened yet
        self.assertEqual(server.data("GET", "/project")["version"], changed)
        for path in ("/ask", "/text"):  # of which a text would be the wrong one
            self.assertIn("send the text", server.data("POST", path, question, status=412)["error"])
        after = server.data("POST", "/ask", question | {"version": changed})["results"][0]["json"]
        self.assertNotEqual(after["modes"], before["modes"])
        text = server.data("POST", "/ask", question | {"text": GENSET.read_text()})["results"][0]["json"]
        self.assertEqual(text["modes"], before["modes"])
        file.unlink()
        self.assertEqual(server.data("GET", "/version")["version"], "")

    def test_a_wrong_text_is_content(self):
        server = self.serve(GENSET)
        text = GENSET.read_text().replace('mass = "4200 kg"', 'mass = "-4200 kg"', 1)
        found = server.data("POST", "/ask", {"text": text, "wants": [{"command": "modes"}]})
        self.assertFalse(found["ok"])
        problem = found["problems"][0]
        self.assertEqual((problem["severity"], problem["subject"]), ("error", "bodies.genset.mass"))
        self.assertEqual(problem["line"], 1 + text[: text.index('mass = "-4200')].count("\n"))
        # A wrong table that a command does not look at is no reason against its result.
        text = GENSET.read_text() + '\n[requirements]\nlimits = {"nobody.z" = "1 mm"}\n'
        found = server.data("POST", "/ask", {"text": text, "wants": [{"command": "modes"}]})
        self.assertFalse(found["ok"])
        self.assertTrue(found["results"][0]["ok"])

    def test_a_wrong_project_is_served(self):
        file = self.file("trivet = 1\ntitle = \"half\"\n[bodies.b]\nmass = \"two\"\n")
        project = self.serve(file).data("GET", "/project")
        self.assertEqual(project["title"], "half")
        self.assertIn("mass", json.dumps(project["problems"]))

    def test_without_a_project_there_are_examples(self):
        server = self.serve()
        project = server.data("GET", "/project")
        self.assertIsNone(project["name"])
        self.assertEqual(len(project["examples"]), 3)
        for example in project["examples"]:
            found = server.data("POST", "/ask", {"text": example["text"], "wants": [{"command": "modes"}]})
            self.assertTrue(found["ok"] and found["results"][0]["ok"], found["problems"])
            self.assertTrue(example["title"])
        self.assertIn("error", server.data("POST", "/save", {"text": "x = 1"}, status=409))

    def test_a_result_that_the_page_knows_is_not_sent_again(self):
        server = self.serve(PAPER)

        def asked(setting, known=""):
            wants = [{"command": name, **({"known": known} if known else {})} for name in ("scene", "modes")]
            return server.data("POST", "/ask", {"settings": [setting], "wants": wants})["results"]

        scene, modes = asked("elements.suspension.scale = 1")
        self.assertFalse(scene["same"])
        again, other = asked("elements.suspension.scale = 2", scene["hash"])  # the scene does not show a stiffness
        self.assertEqual((again["same"], again["json"], again["hash"]), (True, None, scene["hash"]))
        self.assertNotEqual(other["hash"], modes["hash"])
        printed = trivet("modes", PAPER, "--json", "--set", "elements.suspension.scale=2")
        self.assertEqual(other["json"]["modes"], json.loads(printed.stdout)["modes"])

    def test_what_a_page_cannot_want(self):
        server = self.serve(PAPER)
        for want in (
            {"command": "run", "keys": {"output": str(self.folder / "out")}},
            {"command": "export", "keys": {"to": "matlab", "output": str(self.folder / "out.mat")}},
            {"command": "response", "keys": {"at": "1 Hz", "picture": str(self.folder / "out.svg")}},
            {"command": "nothing"},
        ):
            found = server.data("POST", "/ask", {"wants": [want]})["results"][0]
            self.assertFalse(found["ok"], want)
            self.assertTrue(found["problems"], want)
        self.assertEqual([path.name for path in self.folder.iterdir()], ["serve.log"])

    def test_wrong_bodies(self):
        server = self.serve(PAPER)
        for body in (
            b"",
            b"{",
            b"[]",
            b'{"wants": 1}',
            b'{"wants": [{"keys": {}}]}',
            b'{"settings": [1]}',
            b'{"nobody": 1}',
            b'{"text": "\xff"}',
            b"[" * 100_000,
            b'{"wants": [' + b"{}," * 200_000 + b"{}]}",
        ):
            self.assertIn("error", server.data("POST", "/ask", body, status=400), body[:50])

    def test_a_newer_question_ends_the_older(self):
        server = self.serve(SOURCE / "examples/paper/map.toml")
        slow = {"wants": [{"command": "map", "keys": {"points": "3000"}}]}
        other, older = server.connect(), server.connect()
        body = json.dumps(slow).encode()
        older.sendall(server.head("POST", "/ask", len(body)) + body)
        time.sleep(0.3)
        self.assertEqual(server.send("GET", "/")[0], 200)  # while the older is computed
        self.assertEqual(server.send("GET", "/project")[0], 200)
        self.assertEqual(select.select([older], [], [], 0)[0], [])
        found = server.data("POST", "/ask", {"wants": [{"command": "modes"}]}, connection=other)
        self.assertTrue(found["ok"])
        status, _, text = answer(older)
        self.assertEqual(status, 409, text[:200])

    def opening_slowly(self):
        """A server, and a question about a text whose solid mount takes long to condense; the mount is kept in a cache."""
        mount = (
            'type = "solid_mount"\non = "cube"\nat = [0, 0, 0]\nshape = "block"\nwidth_x = "50 mm"\nwidth_y = "30 mm"\n'
            'thickness = "20 mm"\nmesh_level = 8\nmaterial = {G = "0.7 MPa"}\n'
        )
        cube = 'trivet = 1\n[bodies.cube]\nmass = 6\nfree = ["z"]\n'
        text = f"{cube}[elements.mount]\n{mount}"
        cache = self.folder / "cache"
        cache.mkdir()
        server = self.serve(self.file(text), env=os.environ | {"TRIVET_CACHE": str(cache)})
        question = json.dumps({"text": text + "# a page's\n", "wants": [{"command": "modes"}]}).encode()
        asking = server.connect()
        asking.sendall(server.head("POST", "/ask", len(question)) + question)
        for _ in range(100 * slower):
            if server.data("GET", "/progress")["task"] == "condensing the solid":
                break
            time.sleep(0.05)
        else:
            self.fail("the project is not being opened")
        return server, asking, cache

    def test_opening_ends_with_a_newer_question(self):
        server, asking, cache = self.opening_slowly()
        soft = PAPER.read_text()
        began = time.monotonic()
        self.assertTrue(server.data("POST", "/ask", {"text": soft, "wants": [{"command": "modes"}]})["ok"])
        self.assertLess(time.monotonic() - began, 2 * slower)
        self.assertEqual(answer(asking)[0], 409)
        self.assertEqual(list(cache.iterdir()), [])  # it was not condensed to the end

    def test_opening_ends_with_its_connection(self):
        server, asking, cache = self.opening_slowly()
        asking.close()
        for _ in range(20 * slower):
            if server.data("GET", "/progress")["task"] is None:
                break
            time.sleep(0.1)
        else:
            self.fail("the project is still being opened")
        self.assertEqual(list(cache.iterdir()), [])

    def test_interrupting_a_server_that_opens_ends_it_with_a_message(self):
        server, _, cache = self.opening_slowly()
        began = time.monotonic()
        self.assertEqual(server.end(signal.SIGINT), 128 + signal.SIGINT)
        self.assertLess(time.monotonic() - began, 2 * slower)
        self.assertIn("interrupted", pathlib.Path(server.log_file.name).read_text())
        self.assertEqual(list(cache.iterdir()), [])

    def test_a_question_ends_with_its_connection(self):
        server = self.serve(SOURCE / "examples/paper/map.toml")
        body = json.dumps({"wants": [{"command": "map", "keys": {"points": "3000"}}]}).encode()
        leaving = server.connect()
        leaving.sendall(server.head("POST", "/ask", len(body), X_Trivet_Client="a") + body)
        time.sleep(0.3)
        leaving.close()
        began = time.monotonic()
        server.data("POST", "/ask", {"wants": [{"command": "modes"}]}, X_Trivet_Client="b")
        self.assertLess(time.monotonic() - began, 10 * slower)  # the map alone takes longer

    def test_a_long_question_of_one_page_keeps_no_other_waiting(self):
        server = self.serve(SOURCE / "examples/paper/map.toml")
        self.assertIsNone(server.data("GET", "/progress", X_Trivet_Client="a")["task"])
        body = json.dumps({"wants": [{"command": "map", "keys": {"points": "3000"}}]}).encode()
        long = server.connect()
        long.sendall(server.head("POST", "/ask", len(body), X_Trivet_Client="a") + body)
        seen = set()
        for client, command in (("b", "modes"), ("c", "roots"), ("b", "peaks"), ("", "modes")):
            found = server.data("POST", "/ask", {"wants": [{"command": command}]}, X_Trivet_Client=client)
            self.assertTrue(found["results"][0]["ok"])
            doing = server.data("GET", "/progress", X_Trivet_Client="a")
            seen.add(doing["task"])
            self.assertTrue(0 <= doing["fraction"] <= 1, doing)
            self.assertIsNone(server.data("GET", "/progress", X_Trivet_Client=client)["task"])
            self.assertEqual(select.select([long], [], [], 0)[0], [])  # the map is still computed
        self.assertFalse(None in seen, seen)
        # The next question of the same page ends it, and waits for its end.
        found = server.data("POST", "/ask", {"wants": [{"command": "modes"}]}, X_Trivet_Client="a")
        self.assertTrue(found["results"][0]["ok"])
        self.assertEqual(answer(long)[0], 409)

    def test_more_long_questions_than_threads_wait_and_can_be_ended(self):
        server = self.serve(SOURCE / "examples/paper/map.toml")
        body = json.dumps({"wants": [{"command": "map", "keys": {"points": "3000"}}]}).encode()
        pages = [server.connect() for _ in range(5)]
        for i, page in enumerate(pages):
            page.sendall(server.head("POST", "/ask", len(body), X_Trivet_Client=f"page {i}") + body)
        time.sleep(0.5)
        self.assertEqual(server.data("GET", "/progress", X_Trivet_Client="page 4")["task"], "waiting for other pages")
        pages[0].close()
        for _ in range(100 * slower):
            if server.data("GET", "/progress", X_Trivet_Client="page 4")["task"] != "waiting for other pages":
                break
            time.sleep(0.1)
        else:
            self.fail("the fifth page still waits")

    def test_pages_with_different_texts_keep_their_sessions(self):
        server = self.serve(GENSET)
        texts = [GENSET.read_text().replace('mass = "4200 kg"', f'mass = "{mass} kg"', 1) for mass in (4300, 4400)]
        expected = [json.loads(trivet("modes", self.file(text), "--json").stdout)["modes"] for text in texts]
        for _ in range(3):
            for client, text in enumerate(texts):
                question = {"text": text, "wants": [{"command": "modes"}]}
                found = server.data("POST", "/ask", question, X_Trivet_Client=str(client))
                self.assertEqual(found["results"][0]["json"]["modes"], expected[client])

    def test_one_connection_for_several_requests(self):
        server = self.serve(PAPER)
        connection = server.connect()
        for _ in range(3):
            self.assertEqual(server.send("GET", "/", connection=connection)[0], 200)
            server.data("POST", "/ask", {"wants": [{"command": "modes"}]}, connection=connection)
        connection.sendall(server.head("GET", "/") + server.head("GET", "/schema"))
        self.assertEqual(answer(connection)[0], 200)


class Files(Served):
    def test_saving_changes_one_value_and_keeps_permissions(self):
        file = self.file(GENSET.read_text())
        file.chmod(0o640)
        server = self.serve(file)
        settings = ['bodies.genset.mass = "5 t"']
        version = server.data("GET", "/project")["version"]
        expected = server.data("POST", "/text", {"settings": settings})["text"]
        saved = server.data("POST", "/save", {"version": version, "settings": settings})
        self.assertEqual(file.read_text(), expected)
        self.assertEqual(stat.S_IMODE(file.stat().st_mode), 0o640)
        self.assertEqual(expected, GENSET.read_text().replace('mass = "4200 kg"', 'mass = "5000 kg"', 1))
        self.assertEqual(server.data("GET", "/project")["version"], saved["version"])
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["project.toml", "serve.log"])

    def test_a_file_that_another_hand_changed_is_not_overwritten(self):
        file = self.file(PAPER.read_text())
        server = self.serve(file)
        version = server.data("GET", "/project")["version"]
        theirs = file.read_text() + "# theirs\n"
        file.write_text(theirs)
        found = server.data("POST", "/save", {"version": version, "text": "# ours\n"}, status=409)
        self.assertEqual(found["text"], theirs)
        self.assertEqual(file.read_text(), theirs)
        server.data("POST", "/save", {"version": found["version"], "text": "# ours\n"})
        self.assertEqual(file.read_text(), "# ours\n")
        file.unlink()
        version = server.data("GET", "/project")["version"]
        self.assertEqual(version, "")
        found = server.data("POST", "/save", {"version": "0", "text": "# again\n"}, status=409)
        server.data("POST", "/save", {"version": found["version"], "text": "# again\n"})
        self.assertEqual(file.read_text(), "# again\n")

    def test_of_a_link_the_target_is_replaced(self):
        (self.folder / "data").mkdir()
        target = self.folder / "data/machine.toml"
        target.write_text(PAPER.read_text())
        link = self.folder / "link.toml"
        link.symlink_to("data/machine.toml")
        server = self.serve(link)
        version = server.data("GET", "/project")["version"]
        server.data("POST", "/save", {"version": version, "text": "# saved\n"})
        self.assertTrue(link.is_symlink())
        self.assertEqual(target.read_text(), "# saved\n")

    def test_read_only(self):
        file = self.file(PAPER.read_text())
        server = self.serve(file, "--read-only")
        project = server.data("GET", "/project")
        self.assertTrue(project["read_only"])
        server.data("POST", "/save", {"version": project["version"], "text": "# ours\n"}, status=403)
        self.assertEqual(file.read_text(), PAPER.read_text())

    def test_a_file_without_write_permission(self):
        file = self.file(PAPER.read_text())
        file.chmod(0o444)
        self.folder.chmod(0o777)
        server = self.serve(file, **({"user": 65534, "group": 65534} if os.geteuid() == 0 else {}))
        version = server.data("GET", "/project")["version"]
        found = server.data("POST", "/save", {"version": version, "text": "# ours\n"}, status=500)
        self.assertIn("Permission denied", found["error"])

    def test_texts_name_no_files_but_those_of_the_project(self):
        secret = self.folder / "secret.csv"
        secret.write_text("frequency,level\n1,SECRET\n")
        folder = self.folder / "project"
        (folder / ".hidden").mkdir(parents=True)
        (folder / ".hidden/key.csv").write_text("SECRET\n")
        (folder / "link.csv").symlink_to(secret)
        (folder / "inside.csv").write_text("name,on,at.x,at.y,at.z\nedge,aggregate,1,0,0\n")
        file = folder / "machine.toml"
        named = self.folder / "named.csv"
        named.write_text("name,on,at.x,at.y,at.z\nedge,aggregate,1,0,0\n")
        file.write_text(PAPER.read_text() + '\n[tables.points]\nfile = "../named.csv"\n')
        server = self.serve(file)
        for name, permitted in (
            ("inside.csv", True),
            ("../named.csv", True),  # the file on disk names it
            ("./link.csv", False),
            ("../secret.csv", False),
            (str(secret), False),
            ("/etc/passwd", False),
            (".hidden/key.csv", False),
            ("nothing.csv", True),
            ("../nothing.csv", False),
        ):
            text = PAPER.read_text() + f'\n[tables.points]\nfile = "{name}"\n'
            for found in (
                server.data("POST", "/ask", {"text": text}),
                server.data("POST", "/ask", {"settings": [f'tables.points.file = "{name}"']}),
            ):
                refused = [p for p in found["problems"] if "a page may name files" in json.dumps(p)]
                self.assertEqual(not refused, permitted, (name, found["problems"]))
                self.assertNotIn("SECRET", json.dumps(found))
            if not permitted:
                project = server.data("GET", "/project")
                server.data("POST", "/save", {"text": text, "version": project["version"]}, status=422)
                server.data("POST", "/text", {"text": text}, status=422)


if __name__ == "__main__":
    unittest.main()
