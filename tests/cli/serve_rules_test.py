# SPDX-License-Identifier: BSD-3-Clause
"""Who and what the server of the page refuses, spoken to through raw sockets, and attacks on it."""
import contextlib
import json
import math
import pathlib
import re
import socket
import time
import unittest

from serving import Served, answer, slower
from trivet_test import PAPER, SOURCE


class Rules(Served):
    def test_fields_of_every_answer(self):
        server = self.serve(PAPER)
        for method, path in (
            ("GET", "/"),
            ("GET", "/project"),
            ("GET", "/schema"),
            ("GET", "/nothing"),
            ("POST", "/ask"),
        ):
            _, fields, _ = server.send(method, path, {} if method == "POST" else b"")
            self.assertEqual(fields["x-content-type-options"], "nosniff")
            self.assertEqual(fields["cross-origin-resource-policy"], "same-origin")
            policy = fields["content-security-policy"]
            self.assertNotIn("unsafe", policy)
            for part in (
                "default-src 'none'",
                "script-src 'self'",
                "style-src 'self'",
                "frame-ancestors 'none'",
                "form-action 'none'",
            ):
                self.assertIn(part, policy)
            self.assertFalse([name for name in fields if name.startswith("access-control") or name == "set-cookie"])

    def test_files_of_the_page_are_those_of_the_bundle(self):
        server = self.serve(PAPER)
        types = {".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".txt": "text/plain"}
        others = ("widget.js", "report.js", "report_lines.js", "report_machine.js")  # of notebooks and reports
        bundle = sorted(file for file in (SOURCE / "web/dist").iterdir() if file.name not in others)
        self.assertIn("index.html", [file.name for file in bundle])
        for file in bundle:
            status, fields, content = server.send("GET", "/" + file.name, X_Trivet_Token=None)
            self.assertEqual((status, content), (200, file.read_bytes()), file.name)
            self.assertEqual(fields["content-type"], types[file.suffix] + "; charset=utf-8")

    def test_files_of_the_page_need_no_token_and_data_do(self):
        server = self.serve(PAPER)
        status, fields, page = server.send("GET", "/", X_Trivet_Token=None)
        self.assertEqual((status, fields["content-type"]), (200, "text/html; charset=utf-8"))
        self.assertIn(b"<html", page)
        for token in (None, "", "0" * 64, server.token[:-1], server.token + "0"):
            for method, path in (
                ("GET", "/project"),
                ("GET", "/schema"),
                ("GET", "/version"),
                ("GET", "/progress"),
                ("POST", "/ask"),
                ("POST", "/save"),
                ("POST", "/text"),
            ):
                self.assertEqual(server.send(method, path, X_Trivet_Token=token)[0], 401, (token, path))
        self.assertEqual(server.send("GET", f"/project?token={server.token}", X_Trivet_Token=None)[0], 401)

    def test_hosts_origins_and_sites(self):
        server = self.serve(PAPER)
        port = server.port
        for path in ("/", "/project"):
            for host, status in (
                (f"localhost:{port}", 200),
                (f"LOCALHOST:{port}", 200),
                (f"[::1]:{port}", 200),
                ("127.0.0.1", 403),
                (f"127.0.0.1:{port + 1}", 403),
                (f"rebound.example:{port}", 403),
                (f"127.0.0.1:{port}.example", 403),
                (None, 400),
            ):
                self.assertEqual(server.send("GET", path, Host=host)[0], status, (path, host))
            for origin, status in (
                (f"http://127.0.0.1:{port}", 200),
                (f"http://127.0.0.1:{port + 1}", 403),
                (f"https://127.0.0.1:{port}", 403),
                ("https://example.com", 403),
                ("null", 403),
            ):
                self.assertEqual(server.send("GET", path, Origin=origin)[0], status, (path, origin))
        for site in ("cross-site", "same-site", "none", "strange"):
            self.assertEqual(server.send("GET", "/project", Sec_Fetch_Site=site)[0], 403, site)
        self.assertEqual(server.send("GET", "/project", Sec_Fetch_Site=None)[0], 200)
        self.assertEqual(server.send("GET", "/", Sec_Fetch_Site="cross-site")[0], 403)
        opened = {"Sec_Fetch_Site": "cross-site", "Sec_Fetch_Mode": "navigate"}
        self.assertEqual(server.send("GET", "/", Sec_Fetch_Dest="document", **opened)[0], 200)
        self.assertEqual(server.send("GET", "/", Sec_Fetch_Dest="iframe", **opened)[0], 403)
        self.assertEqual(server.send("GET", "/project", Sec_Fetch_Dest="document", **opened)[0], 403)
        twice = server.head("GET", "/").replace(b"\r\n\r\n", b"\r\nHost: example.com\r\n\r\n")
        connection = server.connect()
        connection.sendall(twice)
        self.assertEqual(answer(connection)[0], 400)

    def test_methods_lengths_and_types(self):
        server = self.serve(PAPER)
        for method in ("PUT", "DELETE", "OPTIONS", "HEAD", "TRACE", "NONSENSE"):
            self.assertEqual(server.send(method, "/project")[0], 405, method)
        status, fields, _ = server.send("POST", "/project", {})
        self.assertEqual((status, fields["allow"]), (405, "GET"))
        self.assertEqual(server.send("GET", "/ask")[0], 405)
        self.assertEqual(server.send("GET", "/../serve.log")[0], 404)
        self.assertEqual(server.send("GET", "http://example.com/")[0], 400)
        for type_ in (
            None,
            "text/plain",
            "application/x-www-form-urlencoded",
            "multipart/form-data",
            "application/jsonp",
        ):
            self.assertEqual(server.send("POST", "/ask", {}, Content_Type=type_)[0], 415, type_)
        self.assertEqual(server.send("POST", "/ask", {}, Content_Type="application/json; charset=utf-8")[0], 200)
        for length, status in (
            (None, 411),
            (8_000_001, 413),
            (10**9, 413),
            (10**30, 400),
            ("-1", 400),
            ("2x", 400),
            ("", 400),
        ):
            connection = server.connect()
            connection.sendall(server.head("POST", "/ask", length))  # answered before the body is sent
            self.assertEqual(answer(connection)[0], status, length)
        for encoding in ("chunked", "identity", "gzip, chunked"):
            connection = server.connect()
            head = server.head("POST", "/ask", None, Transfer_Encoding=encoding)
            connection.sendall(head + b"2;extension=1\r\n{}\r\n0\r\n\r\n")
            self.assertEqual(answer(connection)[0], 411, encoding)
        connection = server.connect()
        connection.sendall(server.head("GET", "/", Content_Length=2) + b"{}")
        self.assertEqual(answer(connection)[0], 400)
        largest = json.dumps({"text": "#" * 7_999_900}).encode()
        self.assertEqual(server.send("POST", "/ask", largest)[0], 200)

    def test_heads_that_are_no_requests(self):
        server = self.serve(PAPER)
        many = "".join(f"X-{i}: 1\r\n" for i in range(70)).encode()
        for head, status in (
            (server.head("GET", "/").replace(b"\r\n\r\n", b"\r\n" + many + b"\r\n"), 431),
            (b"GET / HTTP/1.1\r\n" + b"".join(b"X-%d: 1\r\n" % i for i in range(10_000)), 431),
            (b"GET /" + b"a" * 100_000, 431),
            (b"\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03" + b"\x00" * 50 + b"\r\n\r\n", 400),
            (b"nonsense\r\n\r\n", 400),
            (b"GET / HTTP/9.9\r\n\r\n", 400),
            (b"GET / HTTP/1.1\r\nA\x00B: 1\r\n\r\n", 400),
        ):
            connection = server.connect()
            connection.sendall(head)
            self.assertEqual(answer(connection)[0], status, head[:60])
        self.assertEqual(server.send("GET", "/")[0], 200)
        server.end()

    def test_refusals_are_logged_on_lines_of_their_own(self):
        server = self.serve(PAPER)
        for i in range(30):
            server.send("GET", "/project", X_Trivet_Token="x")
        server.send("GET", "/\x1b[2Jnothing")
        time.sleep(1.1)
        server.send("GET", "/nothing")
        log = server.log()
        self.assertIn("refused: 401 GET /project: X-Trivet-Token", log)
        self.assertRegex(log, r"refused: \d+ more")
        self.assertNotIn("\x1b", log)
        self.assertNotIn(server.token, log)
        self.assertLessEqual(len(log.splitlines()), 25)


class Attacks(Served):
    def assert_quick(self, server):
        """A good request is answered within 100 ms: the quickest of some, since this machine may have other work."""
        quickest = math.inf
        for _ in range(20):
            began = time.monotonic()
            self.assertEqual(server.send("GET", "/project")[0], 200)
            quickest = min(quickest, time.monotonic() - began)
            if quickest < 0.1 * slower:
                return
        self.fail(f"the quickest answer took {quickest:.2f} s")

    def memory(self, server):
        return (
            int(re.search(r"VmRSS:\s+(\d+)", pathlib.Path(f"/proc/{server.process.pid}/status").read_text())[1]) / 1000
        )

    def test_slow_clients_keep_nobody_out(self):
        server = self.serve(PAPER)
        self.assert_quick(server)
        before = self.memory(server)
        attackers = [server.connect() for _ in range(200)]
        self.assert_quick(server)
        open_files = len(list(pathlib.Path(f"/proc/{server.process.pid}/fd").iterdir()))
        self.assertLess(open_files, 64 + 20)  # connections, and files of the process
        for i in range(8):
            for connection in attackers:
                with contextlib.suppress(OSError):
                    connection.sendall(server.head("GET", "/")[i : i + 1])
            self.assert_quick(server)
            time.sleep(0.5)
        time.sleep(2.5)  # the deadline of 5 s has passed for all of them
        closed = 0
        for connection in attackers:
            connection.settimeout(1)
            try:
                while piece := connection.recv(4096):
                    self.assertTrue(piece.startswith(b"HTTP/1.1 408"), piece)
                closed += 1
            except ConnectionError:
                closed += 1
            except TimeoutError:
                pass
        self.assertEqual(closed, 200)
        self.assertLess(self.memory(server) - before, 50)

    def test_clients_that_do_not_read(self):
        server = self.serve(PAPER)
        self.assert_quick(server)
        before = self.memory(server)
        for _ in range(60):
            connection = server.connect()
            connection.sendall(server.head("GET", "/schema") * 20)
        self.assert_quick(server)
        held = []
        for _ in range(300):  # of files that need no token; they stay, and read nothing
            held.append(server.connect())
            with contextlib.suppress(OSError):
                held[-1].sendall(server.head("GET", "/page.js", X_Trivet_Token=None) * 20)
            if len(held) % 30 == 0:
                self.assert_quick(server)
        for _ in range(1000):
            with socket.create_connection(("127.0.0.1", server.port)) as connection:
                connection.sendall(server.head("GET", "/schema"))  # and leave
        self.assert_quick(server)
        self.assertLess(self.memory(server) - before, 50)

    def test_bodies_without_end(self):
        server = self.serve(PAPER)
        self.assert_quick(server)
        before = self.memory(server)
        for head in (
            server.head("POST", "/ask", 10**9),
            server.head("POST", "/ask", 8_000_000, X_Trivet_Token="x"),
            server.head("POST", "/ask", None, Transfer_Encoding="chunked") + b"ffffffff\r\n",
        ):
            connection = server.connect()
            connection.sendall(head)
            with contextlib.suppress(OSError):
                for _ in range(200):
                    connection.sendall(b"x" * 1_000_000)
                self.fail("200 MB were taken")
            self.assert_quick(server)
        self.assertLess(self.memory(server) - before, 50)


if __name__ == "__main__":
    unittest.main()
