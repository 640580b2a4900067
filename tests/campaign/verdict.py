# SPDX-License-Identifier: BSD-3-Clause
"""Runs the program once and lists the faults of its end."""
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import threading

MOST_LINES = 101  # a hundred messages, and one for the number of the others
MOST_MEMORY = 1.5e9  # [bytes]
LIBRARY_WORDS = re.compile(
    r"std::|bad_alloc|length_error|json\.exception|basic_filebuf|basic_string|max_size|filesystem error|vector::|terminate called|what\(\)|Eigen::|[Aa]ssertion|"
    r"stod|stoi|map::at|Sanitizer|runtime error|iostream error|[Ss]egmentation"
)
NOT_A_NUMBER = re.compile(r"(?<![\w.\"])[-+]?(?:nan|inf)(?![\w.\"])")
NAN = re.compile(r"(?<![\w.\"])[-+]?nan(?![\w.\"])")  # a peak over a minimum of 0 has an infinite relative prominence
CONTROL = re.compile(r"[\x00-\x08\x0b-\x1f\x7f]")


def measured_run(command, environment, folder, seconds):
    """Exit code (None: out of time), output, messages, and the largest memory [bytes]."""
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
        child = subprocess.Popen(command, stdout=out, stderr=err, stdin=subprocess.DEVNULL, env=environment, cwd=folder)
        late = threading.Event()
        clock = threading.Timer(seconds, lambda: (late.set(), child.kill()))
        clock.start()
        _, status, usage = os.wait4(child.pid, 0)
        clock.cancel()
        child.returncode = os.waitstatus_to_exitcode(status)
        out.seek(0), err.seek(0)
        return None if late.is_set() else child.returncode, out.read(), err.read(), 1024 * usage.ru_maxrss


def left_behind(folder, known):
    return sorted(str(p.relative_to(folder)) for p in pathlib.Path(folder).rglob("*") if p not in known)


def holds_no_number(path):
    text = path.read_text(errors="replace")
    return path.suffix in (".csv", ".json") and NAN.search(text) is not None


def faults(trivet, arguments, folder, cache, seconds, memory=MOST_MEMORY, plausible=False):
    """All violations of the contract of docs/project-file.md by this run; empty: none. A plausible machine is refused
    only if it falls over, or if nothing acts on it."""
    private = pathlib.Path(tempfile.mkdtemp(prefix="campaign-tmp-"))
    result = pathlib.Path(folder) / "result"
    known = set(pathlib.Path(folder).rglob("*"))
    environment = {**os.environ, "TMPDIR": str(private), "TRIVET_CACHE": str(cache), "TERM": "dumb"}
    running = arguments[0] == "run"
    writing = running or arguments[0] == "export"
    command = [trivet, *arguments] + (["-o", str(result)] if writing else [])
    found = []
    try:
        code, out, err, most = measured_run(command, environment, folder, seconds)
        output, messages = out.decode(errors="replace"), err.decode(errors="replace")
        if code is None:
            return [f"no end within {seconds} s"]
        if code not in (0, 1, 2):
            found.append(f"exit code {code}")
        said = messages + (output if running else "")
        told = any(words in said for words in ("error:", "NOT COMPUTED", "ends before the end"))
        if code != 0 and not told and "DISAGREES" not in output:
            found.append("no message")
        if plausible and code == 2 and not any(words in messages for words in ("falls over", "no harmonic excitation")):
            found.append("a plausible machine is refused")
        if messages.count("\n") > MOST_LINES:
            found.append(f"{messages.count(chr(10))} lines of messages")
        if word := LIBRARY_WORDS.search(messages + output):
            found.append(f"words of a library: {word.group()}")
        if word := NOT_A_NUMBER.search(output):
            found.append(f"{word.group()} in the output")
        if word := CONTROL.search(messages + output):
            found.append(f"control character {word.group()!r}")
        try:
            err.decode(), out.decode()
        except UnicodeDecodeError:
            found.append("output that is no UTF-8")
        if most > memory:
            found.append(f"{most / 1e9:.1f} GB of memory")
        if running and result.exists():
            found += [f"nan in {p.name}" for p in result.rglob("*") if p.is_file() and holds_no_number(p)]
            if code == 2:
                found.append("a result of a wrong input")
            shutil.rmtree(result)
        elif writing and code == 0:
            for written in [result, *pathlib.Path(folder).glob("result_*")]:
                if written.is_dir():
                    shutil.rmtree(written)
                else:
                    written.unlink(missing_ok=True)
        if left := left_behind(folder, known) + left_behind(private, set()):
            found.append("left behind: " + ", ".join(left[:5]))
        if found and (messages or code):
            found.append("it said: " + (messages or output)[-300:].strip())
        return found
    finally:
        shutil.rmtree(private, ignore_errors=True)
