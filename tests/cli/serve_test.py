# SPDX-License-Identifier: BSD-3-Clause
"""The server of the page, spoken to through raw sockets: its answers, files, starts and ends."""
import hashlib
import json
import os
import pathlib
import re
import select
import signal
import stat
import subprocess
import time
import unittest

from serving import GENSET, Served, answer, slower
from trivet_test import PAPER, SOURCE, TRIVET, trivet


def opened_token(found, key, port, nonce):
    """The token in an answer of /resume, as a page reads it; None without a proof."""

    def keyed(words):
        inner = hashlib.sha256((key + words).encode()).hexdigest()
        return hashlib.sha256((key + inner).encode()).hexdigest()

    words = f"{port} {nonce} {found['nonce']}"
    token = f"{int(found['sealed'], 16) ^ int(keyed('token ' + words), 16):064x}"
    return token if keyed(f"proof {words} {token}") == found["proof"] else None


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


class Starts(Served):
    def test_the_browser_gets_a_private_file(self):
        browser = self.folder / "browser"
        browser.write_text(
            '#!/bin/sh\nstat -c "%a %n" "$1" "$(dirname "$1")" >"$OUT.new"\ncat "$1" >>"$OUT.new"\nmv "$OUT.new" "$OUT"\n'
        )
        browser.chmod(0o755)
        out = self.folder / "out"
        environment = os.environ | {"BROWSER": str(browser), "OUT": str(out)}
        process = subprocess.Popen(
            [TRIVET, "serve", str(PAPER)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=environment
        )
        self.addCleanup(lambda: process.poll() is None and process.kill())
        line = process.stdout.readline()
        port = re.search(r"http://127\.0\.0\.1:(\d+)/;", line)[1]
        self.assertNotIn("token", line)
        for _ in range(100):
            if out.exists():
                break
            time.sleep(0.05)
        first, second, page = out.read_text().split("\n", 2)
        self.assertTrue(first.startswith("600 ") and second.startswith("700 "), out.read_text())
        self.assertRegex(page, rf"url=http://127\.0\.0\.1:{port}/#token=[0-9a-f]{{64}}\"")
        command = pathlib.Path(f"/proc/{process.pid}/cmdline").read_text()
        self.assertNotIn("token", command)
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(timeout=30), 130)
        self.assertFalse(pathlib.Path(first[4:]).exists())
        process.stdout.close()
        process.stderr.close()

    def test_a_page_goes_on_with_the_next_start(self):
        login = self.folder / "login"
        login.mkdir(mode=0o700)
        environment = os.environ | {"XDG_RUNTIME_DIR": str(login)}
        first = self.serve(PAPER, env=environment)
        key = first.data("GET", "/project")["resume_key"]
        self.assertRegex(key, r"^[0-9a-f]{64}$")
        other = self.serve(PAPER, env=environment)  # at the same time: another port, the same key
        self.assertNotEqual(other.port, first.port)
        self.assertNotEqual(self.serve(GENSET, env=environment).data("GET", "/project")["resume_key"], key)
        other.end(signal.SIGKILL)
        second = self.serve(PAPER, env=environment)
        self.assertEqual(second.port, other.port)
        self.assertNotEqual(second.token, other.token)
        nonce = "0123456789abcdef" * 4
        found = second.data("GET", "/resume", X_Trivet_Token=None, X_Trivet_Nonce=nonce)
        self.assertEqual(opened_token(found, key, second.port, nonce), second.token)
        self.assertIsNone(opened_token(found, key, first.port, nonce))  # the answer of another port, passed on
        self.assertIsNone(opened_token(found, key[::-1], second.port, nonce))
        again = second.data("GET", "/resume", X_Trivet_Token=None, X_Trivet_Nonce=nonce)
        self.assertNotEqual(again["sealed"], found["sealed"])
        self.assertEqual(second.send("GET", "/resume", X_Trivet_Token=None)[0], 400)
        self.assertEqual(second.send("GET", "/resume", X_Trivet_Nonce=nonce, Sec_Fetch_Site="same-site")[0], 403)

    def test_without_a_private_folder_no_page_goes_on(self):
        login = self.folder / "login"
        login.mkdir()
        for folder, mode in ((str(login), 0o750), ("", 0o700), ("login", 0o700), (str(self.folder / "no"), 0o700)):
            login.chmod(mode)
            server = self.serve(PAPER, env=os.environ | {"XDG_RUNTIME_DIR": folder}, cwd=self.folder)
            key, nonce = server.data("GET", "/project")["resume_key"], "0" * 64
            found = server.data("GET", "/resume", X_Trivet_Token=None, X_Trivet_Nonce=nonce)
            self.assertEqual(opened_token(found, key, server.port, nonce), server.token)  # of this start alone
            server.end()
            again = self.serve(PAPER, "--port", str(server.port), env=os.environ | {"XDG_RUNTIME_DIR": folder})
            found = again.data("GET", "/resume", X_Trivet_Token=None, X_Trivet_Nonce=nonce)
            self.assertIsNone(opened_token(found, key, server.port, nonce))
            self.assertEqual(list(login.iterdir()), [])
        login.chmod(0o700)
        environment = os.environ | {"XDG_RUNTIME_DIR": str(login)}
        self.serve(PAPER, env=environment).end()
        kept = next((login / "trivet").iterdir())
        for wrong in ("", "x", "70000 " + "0" * 64, "1 " + "0" * 63, "0" * 300):
            kept.write_text(wrong)
            key = self.serve(PAPER, env=environment).data("GET", "/project")["resume_key"]
            self.assertRegex(key, r"^[0-9a-f]{64}$")
            self.assertNotEqual(key, "0" * 64)

    def test_no_other_user_can_read_the_key(self):
        login = self.folder / "login"
        login.mkdir(mode=0o700)
        environment = os.environ | {"XDG_RUNTIME_DIR": str(login)}
        old_mask = os.umask(0)
        self.addCleanup(os.umask, old_mask)

        def start():
            """The key of a start, and what it prints on standard error."""
            server = self.serve(PAPER, env=environment)
            key = server.data("GET", "/project")["resume_key"]
            log = server.log()
            server.end()
            return key, log

        key, log = start()
        folder, file = login / "trivet", next((login / "trivet").iterdir())
        self.assertEqual((folder.stat().st_mode & 0o7777, file.stat().st_mode & 0o7777), (0o700, 0o600))
        self.assertEqual((start()[0], log), (key, ""))
        wrong = [(file, lambda: file.chmod(0o640)), (folder, lambda: folder.chmod(0o755))]
        if os.geteuid() == 0:
            wrong += [(file, lambda: os.chown(file, 65534, -1)), (folder, lambda: os.chown(folder, 65534, -1))]
        for place, spoil in wrong:
            for good, mode in ((folder, 0o700), (file, 0o600)):
                os.chown(good, os.geteuid(), -1)
                good.chmod(mode)
            key, _ = start()
            spoil()
            mode, owner, text = place.stat().st_mode & 0o7777, place.stat().st_uid, file.read_text()
            found, log = start()
            self.assertNotEqual(found, key)
            self.assertIn(f"{place} has mode {mode:04o} and belongs to user {owner}; mode 0", log)
            self.assertEqual(log.count("\n"), 1)
            if place == folder:
                self.assertEqual(file.read_text(), text)  # nothing is kept there
            else:
                self.assertEqual(start(), (found, ""))  # replaced

    def test_signals_end_it_within_a_second(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            self.assertLess(min(self.seconds_to_end(number) for _ in range(3)), 1 * slower)

    def seconds_to_end(self, number):
        server = self.serve(SOURCE / "examples/paper/map.toml")
        body = json.dumps({"wants": [{"command": "map", "keys": {"points": "3000"}}]}).encode()
        server.connect().sendall(server.head("POST", "/ask", len(body)) + body)
        time.sleep(0.3)
        began = time.monotonic()
        self.assertEqual(server.end(number), 128 + number)
        return time.monotonic() - began

    def test_wrong_starts(self):
        server = self.serve(PAPER)
        done = trivet("serve", PAPER, "--no-browser", "--port", server.port)
        self.assertEqual(done.returncode, 2)
        self.assertIn(f"port {server.port}: Address already in use; choose another with --port", done.stderr)
        done = trivet("serve", self.folder / "missing.toml", "--no-browser")
        self.assertEqual(done.returncode, 2)
        self.assertIn("No such file", done.stderr)
        self.assertEqual(trivet("serve", self.folder, "--no-browser").returncode, 2)
        self.assertEqual(trivet("serve", "-", "--no-browser", input="x").returncode, 2)
        self.assertEqual(trivet("serve", PAPER, "--port", "0").returncode, 2)
        self.assertEqual(trivet("serve", PAPER, "--port", "70000").returncode, 2)

    def test_only_this_machine_is_served(self):
        server = self.serve(PAPER)
        table = pathlib.Path("/proc/net/tcp").read_text() + pathlib.Path("/proc/net/tcp6").read_text()
        listening = [line.split()[1] for line in table.splitlines() if line.split()[3] == "0A"]
        ours = [place for place in listening if place.endswith(f":{server.port:04X}")]
        self.assertEqual(ours, [f"0100007F:{server.port:04X}"])


if __name__ == "__main__":
    unittest.main()
