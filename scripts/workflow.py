"""Studies past one machine: the workflow is killed while it runs, started again, and compared with a run of one process.

Ends with one line `N passed, N failed`, or with `skipped: REASON` where Snakemake cannot be installed; it is kept in
.tools/workflow. Call it in the project's folder. Arguments are passed on to Snakemake, such as
`--workflow-profile workflow/profiles/slurm` on a cluster; `install` alone installs and ends.
"""

import json
import os
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

HOME = Path(".tools/workflow")
SNAKEMAKE = HOME / "bin" / "snakemake"
REQUIREMENTS = Path("workflow/requirements.txt")
SOURCES = ["connection_pool"]  # of which there is no built package
SHARDS, SEEDS = 4, 12
# A run takes a moment, all of them take seconds even where the machine is fast.
STUDY = {
    "study": "workflow",
    "scenario": {"preset": "foraging"},
    "steps": 3000,
    "grid": {"geese.agents": [50, 100]},
    "seeds": {"first": 1, "count": SEEDS},
    "metrics": ["share", "steps", "distinct_programs"],
    "figure": {"kind": "box", "metric": "share", "x": "geese.agents"},
}
# Seconds.
TO_INSTALL, TO_BUILD, FOR_ONE = 600, 1100, 600


def main(arguments):
    reason = install()
    if arguments == ["install"]:
        print(reason or f"Snakemake is in {HOME}.")
        return 1 if reason else 0
    if not Path("/proc/self/stat").exists():
        reason = "processes are found as on Linux, to kill them"
    if reason:
        print(f"skipped: {reason}")
        return 0
    program = build()
    folder = program.parent.parent / "workflow check"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    study = folder / "workflow.json"
    study.write_text(json.dumps(STUDY))
    command = [str(SNAKEMAKE), "--snakefile", "workflow/Snakefile", "--config", f"study={study}", f"program={program}"]
    command += [f"shards={SHARDS}", "scenarios=scenarios", f"out={folder / 'out'}", "--cores", "2", *arguments]
    checks = Checks(program, folder, study, command)
    failed = 0
    for name in ("two_at_once_are_refused_and_a_killed_one_goes_on_without_loss", "merged_it_is_the_file_of_one_process",
                 "a_second_start_has_nothing_to_do"):
        try:
            getattr(checks, name)()
            print(f"ok {name}")
        except (AssertionError, OSError, subprocess.SubprocessError) as error:
            failed += 1
            print(f"FAIL {name}: {error}")
    print(f"{3 - failed} passed, {failed} failed")
    return 1 if failed else 0


class Checks:
    """The checks, in their order: each goes on from the one before."""

    def __init__(self, program, folder, study, command):
        self.program, self.folder, self.study, self.command = program, folder, study, command

    def two_at_once_are_refused_and_a_killed_one_goes_on_without_loss(self):
        running = subprocess.Popen(self.command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        end = time.monotonic() + FOR_ONE
        while len(self.rows()) < 3:
            assert running.poll() is None, "the workflow ended before it could be killed"
            assert time.monotonic() < end, "no run was made"
            time.sleep(0.05)
        second = subprocess.run(self.command, capture_output=True, text=True, timeout=FOR_ONE)
        assert "another workflow that is still running" in second.stderr, second.stderr[-2000:]
        kill_all(running)
        before = self.rows()
        assert 0 < len(before) < len(STUDY["grid"]["geese.agents"]) * SEEDS, f"{len(before)} rows when it was killed"
        again = subprocess.run(self.command, capture_output=True, text=True, timeout=FOR_ONE)
        assert again.returncode == 0, again.stderr[-2000:]
        after = self.rows()
        assert before <= after, "rows that were there before the kill are gone"
        numbers = [row.split(",")[0] for row in sorted(after)]
        assert len(numbers) == len(set(numbers)) == 24, f"{len(numbers)} rows of {len(set(numbers))} runs"

    def merged_it_is_the_file_of_one_process(self):
        one = self.folder / "one.csv"
        self.run("study", str(self.study), "--scenarios", "scenarios", "--jobs", "2", "--out", str(one))
        report = self.run("report", str(one))
        for mine, theirs in ((one.read_bytes(), "workflow.csv"), (report, "report.md"),
                             (one.with_suffix(".study.json").read_bytes(), "workflow.study.json")):
            assert mine == (self.folder / "out" / theirs).read_bytes(), f"{theirs} differs"

    def a_second_start_has_nothing_to_do(self):
        again = subprocess.run(self.command, capture_output=True, text=True, timeout=FOR_ONE)
        assert "Nothing to be done" in again.stdout + again.stderr, again.stderr[-2000:]

    def run(self, *words):
        """What the command line prints."""
        return subprocess.run([str(self.program), *words], check=True, capture_output=True, timeout=FOR_ONE).stdout

    def rows(self):
        """Whole rows of all shards."""
        found = set()
        for path in (self.folder / "out" / "partial").glob("*.csv"):
            found.update(line for line in path.read_text().splitlines(keepends=True)[1:] if line.endswith("\n"))
        return found


def kill_all(process):
    """Ends a process and all its descendants at once, as a machine that goes down does; they need not share a group."""
    parents = {}
    for stat in Path("/proc").glob("[0-9]*/stat"):
        try:
            fields = stat.read_text().rsplit(")", 1)[1].split()
        except OSError:
            continue  # it has just ended
        parents.setdefault(int(fields[1]), []).append(int(stat.parent.name))
    doomed = [process.pid]
    for pid in doomed:
        doomed += parents.get(pid, [])
    for pid in doomed:
        try:
            os.kill(pid, signal.SIGKILL)
        except ProcessLookupError:
            pass  # it has just ended
    process.wait()


def install():
    """Why Snakemake is not there; None when it is."""
    stamp = HOME / "requirements.txt"
    if sys.version_info < (3, 11):
        return f"Snakemake needs Python 3.11 or later, this is {sys.version.split()[0]}"
    if stamp.exists() and stamp.read_text() == REQUIREMENTS.read_text():
        return None
    steps = [
        [sys.executable, "-m", "venv", "--clear", str(HOME)],
        [str(HOME / "bin" / "python"), "-m", "pip", "--disable-pip-version-check", "--retries", "1", "--timeout", "20"]
        + ["install", "--quiet", "--only-binary", ":all:", "--no-binary", ",".join(SOURCES)]
        + ["--requirement", str(REQUIREMENTS)],
    ]
    HOME.parent.mkdir(exist_ok=True)
    for step in steps:
        try:
            done = subprocess.run(step, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=TO_INSTALL)
        except (OSError, subprocess.TimeoutExpired) as error:
            return f"Snakemake cannot be installed: {error}"
        if done.returncode != 0:
            told = (done.stderr + done.stdout).strip().splitlines() or ["no message"]
            return f"Snakemake cannot be installed: {told[-1]}"
    shutil.copy(REQUIREMENTS, stamp)
    return None


def build():
    """Our program, as the tests have built it."""
    done = subprocess.run(["cargo", "build", "--locked", "--quiet"], capture_output=True, text=True, timeout=TO_BUILD)
    if done.returncode != 0:
        raise SystemExit(done.stdout + done.stderr)
    about = ["cargo", "metadata", "--locked", "--no-deps", "--format-version", "1"]
    target = json.loads(subprocess.run(about, check=True, capture_output=True, timeout=60).stdout)["target_directory"]
    return Path(target) / "debug" / "swarm-playground"


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
