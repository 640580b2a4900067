# SPDX-License-Identifier: BSD-3-Clause
"""A running `trivet serve`, spoken to through raw sockets: for the tests of its answers and of its rules."""
import json
import pathlib
import re
import signal
import socket
import subprocess

from trivet_test import HANGS_AFTER, SOURCE, TRIVET, InTemporaryFolder

GENSET = SOURCE / "examples/genset/genset.toml"
slower = 10 if b"__asan_init" in pathlib.Path(TRIVET).read_bytes() else 1  # clang links the sanitizers statically


class Server:
    """A running `trivet serve`; its log is read when it has ended."""

    def __init__(self, folder, *words, **options):
        self.log_file = open(pathlib.Path(folder) / "serve.log", "w+")
        self.process = subprocess.Popen(
            [TRIVET, "serve", "--no-browser", *map(str, words)],
            stdout=subprocess.PIPE,
            stderr=self.log_file,
            text=True,
            **options,
        )
        self.address = self.process.stdout.readline().strip()
        found = re.fullmatch(r"http://127\.0\.0\.1:(\d+)/#token=([0-9a-f]{64})", self.address)
        if not found:
            raise AssertionError(f"no address: {self.address!r} {self.log()}")
        self.port, self.token = int(found[1]), found[2]

    def log(self):
        self.log_file.flush()
        return pathlib.Path(self.log_file.name).read_text()

    def end(self, number=signal.SIGTERM):
        self.process.send_signal(number)
        code = self.process.wait(timeout=HANGS_AFTER)
        self.process.stdout.close()
        self.log_file.close()
        return code

    def connect(self):
        connection = socket.create_connection(("127.0.0.1", self.port), timeout=HANGS_AFTER)
        opened.append(connection)
        return connection

    def head(self, method, path, length=None, **fields):
        """A request up to its body; None as a value leaves a field out, and names have _ for -."""
        fields = {name.replace("_", "-"): value for name, value in fields.items()}
        all_fields = {"Host": f"127.0.0.1:{self.port}", "X-Trivet-Token": self.token, "Sec-Fetch-Site": "same-origin"}
        if method == "POST":
            all_fields |= {"Content-Type": "application/json", "Content-Length": length}
        all_fields |= fields
        lines = [f"{method} {path} HTTP/1.1"]
        lines += [f"{name}: {value}" for name, value in all_fields.items() if value is not None]
        return ("\r\n".join(lines) + "\r\n\r\n").encode()

    def send(self, method, path, body=b"", connection=None, **fields):
        """(status, header fields in lower case, body) of one request."""
        if not isinstance(body, bytes):
            body = json.dumps(body).encode()
        if method == "POST":
            fields.setdefault("length", len(body))
        connection = connection or self.connect()
        connection.sendall(self.head(method, path, **fields) + body)
        return answer(connection)

    def data(self, method, path, body=b"", status=200, **fields):
        found, _, content = self.send(method, path, body, **fields)
        if found != status:
            raise AssertionError(f"{found} instead of {status}: {content[:500]}")
        return json.loads(content)


opened = []


def answer(connection):
    received = b""
    while b"\r\n\r\n" not in received:
        piece = connection.recv(65536)
        if not piece:
            raise ConnectionError(f"closed after {received!r}")
        received += piece
    head, _, body = received.partition(b"\r\n\r\n")
    lines = head.decode().split("\r\n")
    fields = {name.lower(): value for name, value in (line.split(": ", 1) for line in lines[1:])}
    while len(body) < int(fields["content-length"]):
        piece = connection.recv(1 << 20)
        if not piece:
            raise ConnectionError("closed within the body")
        body += piece
    return int(lines[0].split()[1]), fields, body


class Served(InTemporaryFolder):
    def setUp(self):
        super().setUp()
        self.addCleanup(self.close_all)

    def close_all(self):
        for connection in opened:
            connection.close()
        opened.clear()

    def serve(self, *words, **options):
        server = Server(self.folder, *words, **options)
        self.addCleanup(lambda: server.process.poll() is None and server.end())
        return server
