# SPDX-License-Identifier: BSD-3-Clause
"""How `trivet serve` starts and ends: addresses, keys for open pages, signals."""
import hashlib
import json
import os
import pathlib
import re
import signal
import subprocess
import time
import unittest

from serving import GENSET, Served, slower
from trivet_test import HANGS_AFTER, PAPER, SOURCE, TRIVET, trivet


def opened_token(found, key, port, nonce):
    """The token in an answer of /resume, as a page reads it; None without a proof."""

    def keyed(words):
        inner = hashlib.sha256((key + words).encode()).hexdigest()
        return hashlib.sha256((key + inner).encode()).hexdigest()

    words = f"{port} {nonce} {found['nonce']}"
    token = f"{int(found['sealed'], 16) ^ int(keyed('token ' + words), 16):064x}"
    return token if keyed(f"proof {words} {token}") == found["proof"] else None


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
        self.assertEqual(process.wait(timeout=HANGS_AFTER), 130)
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
