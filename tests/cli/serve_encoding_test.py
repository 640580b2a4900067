# SPDX-License-Identifier: BSD-3-Clause
"""The bytes of a project file that `trivet serve` opened: what is not UTF-8 is neither shown nor overwritten, line ends stay."""
import unittest

from serving import GENSET, Served

LATIN = "# Masse des Geräts\n".encode("latin-1") + GENSET.read_bytes()
COMMENT = GENSET.read_bytes() + "# geändert\n".encode("latin-1")
SETTING = ['bodies.genset.mass = "5 t"']


class Encoding(Served):
    def test_a_file_that_is_not_utf_8_is_not_shown(self):
        for content, line, place in (
            (LATIN, 1, "byte 16 of the line is E4"),
            (COMMENT, 1 + GENSET.read_bytes().count(b"\n"), "byte 5 of the line is E4"),
            (b"\xff\xfe" + GENSET.read_bytes(), 1, "byte 1 of the line is FF"),
            (GENSET.read_bytes() + b"# \xe2\x82", 1 + GENSET.read_bytes().count(b"\n"), "byte 3 of the line is E2"),
        ):
            file = self.file("")
            file.write_bytes(content)
            server = self.serve(file)
            project = server.data("GET", "/project")
            self.assertIsNone(project["text"])
            self.assertTrue(project["version"])
            for problems in (
                project["problems"],
                server.data("POST", "/ask", {"wants": [{"command": "modes"}]})["problems"],
                server.data("POST", "/text", {"settings": SETTING}, status=422)["problems"],
            ):
                self.assertEqual(len(problems), 1)
                self.assertEqual(problems[0]["line"], line)
                self.assertIn(place + ", which is not UTF-8", problems[0]["message"])

    def test_nothing_is_written_over_it(self):
        for content in (LATIN, b"\xff\xfe", b"\0"):
            file = self.file(GENSET.read_text())
            server = self.serve(file)
            opened = server.data("GET", "/project")["version"]
            file.write_bytes(content)
            found = server.data("POST", "/save", {"version": opened, "settings": SETTING}, status=409)
            self.assertIsNone(found["text"])
            self.assertIn("UTF-8", found["problems"][0]["message"])
            self.assertEqual(server.data("GET", "/version")["version"], found["version"])
            for change in ({"text": GENSET.read_text()}, {"settings": SETTING}):
                answer = server.data("POST", "/save", {"version": found["version"], **change}, status=422)
                self.assertIn("UTF-8", answer["problems"][0]["message"])
            self.assertEqual(file.read_bytes(), content)

    def test_a_blank_file_has_nothing_to_lose(self):
        file = self.file(GENSET.read_text())
        server = self.serve(file)
        file.write_bytes(b" \n")
        self.assertEqual(server.data("GET", "/version")["version"], "")
        server.data("POST", "/save", {"version": "", "text": GENSET.read_text()})
        self.assertEqual(file.read_text(), GENSET.read_text())

    def test_line_ends_and_a_byte_order_mark_stay(self):
        lines = GENSET.read_bytes().splitlines()
        for before in (
            b"\r\n".join(lines),
            b"".join(line + (b"\r\n" if i % 3 else b"\n") for i, line in enumerate(lines)),
            b"\xef\xbb\xbf" + b"\r\n".join(lines) + b"\r\n",
        ):
            file = self.file("")
            file.write_bytes(before)
            server = self.serve(file)
            project = server.data("GET", "/project")
            self.assertEqual(project["text"].encode(), before)
            saved = {"version": project["version"], "text": project["text"], "settings": SETTING}
            server.data("POST", "/save", saved)
            self.assertEqual(file.read_bytes(), before.replace(b'"4200 kg"', b'"5000 kg"', 1))

    def test_a_new_case_ends_its_lines_as_the_file(self):
        text = GENSET.read_text().replace("\n", "\r\n")
        server = self.serve(GENSET)
        written = server.data("POST", "/text", {"text": text, "settings": SETTING, "case": "", "new_case": "heavy"})[
            "text"
        ]
        self.assertEqual(written.count("\n"), written.count("\r\n"))


if __name__ == "__main__":
    unittest.main()
