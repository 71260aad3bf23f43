import shutil
import signal
import subprocess
import sys
import sysconfig
import time
from importlib.metadata import version
from pathlib import Path

import pytest
from tests_of_program import program

SCRIPT = Path(sysconfig.get_path("scripts")) / "hyzer"


def test_the_package_brings_the_program() -> None:
    assert shutil.which("hyzer", path=str(SCRIPT.parent)) == str(SCRIPT)
    run = subprocess.run([SCRIPT, "--version"], capture_output=True, text=True, check=True)
    assert run.stdout == f"hyzer {version('hyzer')}\n"
    assert run.stdout == program("--version").stdout


@pytest.mark.parametrize(
    ("arguments", "status", "said"),
    [
        (["check", "disc"], 0, ""),
        (["check", "disc_appendix_printed"], 1, "[unit] Error"),
        (["fit", "nowhere"], 2, "nowhere: found no such folder, expected a dataset"),
        (["frob"], 2, "unrecognized subcommand 'frob'"),
        (["diff", "disc", "disc"], 0, ""),
    ],
)
def test_exit_statuses_are_those_of_the_program(
    arguments: list[str], status: int, said: str
) -> None:
    run = program(*arguments)
    assert run.returncode == status
    assert said in run.stderr
    assert "Traceback" not in run.stderr


@pytest.mark.alone
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
def test_a_signal_ends_the_program_at_once(number: signal.Signals, tmp_path: Path) -> None:
    out = str(tmp_path / "out")
    command = [sys.executable, "-m", "hyzer", "bootstrap", "examples/disc"]
    command += ["--refits", "1000000", "--out", out]
    with subprocess.Popen(command, stderr=subprocess.PIPE, text=True) as running:
        time.sleep(1.0)
        running.send_signal(number)
        begin = time.perf_counter()
        _, told = running.communicate()
        assert time.perf_counter() - begin < 0.5
    assert running.returncode == 130
    assert told.startswith("interrupted")


def test_a_closed_pipe_is_no_error() -> None:
    command = f"{sys.executable} -m hyzer effects | head -1"
    run = subprocess.run(command, shell=True, capture_output=True, text=True, check=True)
    assert run.stderr == ""
