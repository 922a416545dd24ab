"""Prints, as Markdown, what Figure 2 of BeTr-GEESE costs on different numbers of cores, from times measured here.

    python3 scripts/scaling.py [SEEDS]

Makes SEEDS runs (1 unless said) of each of the 18 cells and takes their processor seconds, so that other work on the
machine shows little, also for handing out a shard with the workflow; then plays through how shards and runs are handed out
to the cores, as workflow/Snakefile and the command line do, and prints the best numbers of shards and of runs at once. A
cluster's queue and slower disks are not in it.
"""

import heapq
import json
import os
import platform
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

STUDIES = ("studies/figure-2a.json", "studies/figure-2b.json")
CORES = (2, 64, 1000)
PROGRAM = "target/release/swarm-playground"
SNAKEMAKE = ".tools/workflow/bin/snakemake"
THREADS = (1, 2, 3, 4, 6, 8, 9, 12, 16, 18, 32)
SHARDS = (1, 2, 4, 8, 16, 32, 64)
SHARDS_COMPARED = (4, 44)


def main(seeds):
    subprocess.run(["cargo", "build", "--release", "--locked", "--quiet"], check=True)
    studies = [(json.loads(Path(path).read_text()), measured(path, seeds)) for path in STUDIES]
    overhead = shard_overhead()
    runs = []
    for study, cells in studies:
        runs += shards_of(cells, study["seeds"]["count"], 1)[0]
    version = subprocess.run([PROGRAM, "--version"], check=True, capture_output=True, text=True).stdout.split()[-1]
    print(f"Version {version}, {model()}, {seeds} measured {'run' if seeds == 1 else 'runs'} of each cell.\n")
    print("| study | cells | runs | processor seconds of a run: least, mean, most | core hours |")
    print("|---|---:|---:|---|---:|")
    for study, cells in studies:
        every = [seconds for cell in cells for seconds in cell]
        mean = sum(every) / len(every)
        count = len(cells) * study["seeds"]["count"]
        spread = f"{min(every):.1f}, {mean:.1f}, {max(every):.1f}"
        print(f"| {study['study']} | {len(cells)} | {count} | {spread} | {count * mean / 3600:.2f} |")
    print(f"\nThe workflow takes {overhead:.2f} s to hand out a shard on this machine, one after the other.\n")
    print("| cores | shards of a study | runs of a shard at once | time | of the cores' time used |")
    print("|---:|---:|---:|---:|---:|")
    for cores in CORES:
        choices = ((count, threads) for count in SHARDS for threads in THREADS if threads <= cores)
        tried = ((playthrough(studies, cores, *choice, overhead), *choice) for choice in choices)
        wall, count, threads = min(tried)
        print(f"| {cores:,} | {count} | {threads} | {words(wall)} | {100 * sum(runs) / (cores * wall):.0f} % |")
    hours = f"{len(runs):,} runs, {sum(runs) / 3600:.2f} core hours"
    print(f"\n{hours}; no number of cores goes below the longest run, {words(max(runs))}.")


def measured(path, seeds):
    """Processor seconds of the runs of each cell."""
    spec = json.loads(Path(path).read_text())
    preset = f"scenarios/{spec['scenario']['preset']}.json"
    cells = []
    for cell in spec["cells"]:
        command = [PROGRAM, "run", preset, *(f"--set={key}={json.dumps(value)}" for key, value in cell.get("set", {}).items())]
        cells.append([processor_seconds([*command, f"--seed={seed}"]) for seed in range(1, seeds + 1)])
        print(f"{cell['name']}: {cells[-1]}", file=sys.stderr)
    return cells


def processor_seconds(command):
    child = subprocess.Popen(command, stdout=subprocess.DEVNULL)
    _, status, usage = os.wait4(child.pid, 0)
    if status != 0:
        raise SystemExit(f"{' '.join(command)} failed")
    return usage.ru_utime + usage.ru_stime


def shard_overhead():
    """Processor seconds to hand out a shard: workflows with nothing to compute, in few and in many shards."""
    fewer, more = (empty_workflow(shards) for shards in SHARDS_COMPARED)
    return max(0.0, (more - fewer) / (SHARDS_COMPARED[1] - SHARDS_COMPARED[0]))


def empty_workflow(shards):
    """Processor seconds of a workflow that makes one step of two robots in each shard."""
    with tempfile.TemporaryDirectory() as folder:
        study = Path(folder) / "empty.json"
        spec = {"study": "empty", "scenario": {"world": "geese", "agents": 2, "steps": 1}, "metrics": ["share"]}
        study.write_text(json.dumps({**spec, "seeds": {"first": 1, "count": shards}}))
        command = [SNAKEMAKE, "--snakefile", "workflow/Snakefile", "--cores", "1", "--config", f"study={study}"]
        command += [f"program={PROGRAM}", f"out={folder}/out", f"shards={shards}"]
        return processor_seconds([*command, "--quiet", "all"])


def shards_of(cells, seeds, count):
    """The runs of every shard; seeds that were not measured take the times of those that were."""
    return [[cell[seed % len(cell)] for seed in range(part, seeds, count) for cell in cells] for part in range(count)]


def playthrough(studies, cores, count, threads, overhead):
    """Seconds until the last shard is done: handing out is one process's work, the shards are the cores'."""
    shards = [shard for study, cells in studies for shard in shards_of(cells, study["seeds"]["count"], count)]
    return handed_out([handed_out(shard, threads) for shard in shards], cores // threads, overhead)


def handed_out(durations, hands, pause=0.0):
    """Seconds until all is done, when whoever is free takes the next; before each there is a pause."""
    free = [0.0] * hands
    for number, duration in enumerate(durations, 1):
        heapq.heapreplace(free, max(free[0], number * pause) + duration)
    return max(free)


def words(seconds):
    if seconds < 120:
        return f"{seconds:.0f} s"
    return f"{seconds / 60:.0f} min" if seconds < 7200 else f"{seconds / 3600:.1f} h"


def model():
    """What the processor calls itself."""
    try:
        lines = Path("/proc/cpuinfo").read_text().splitlines()
        return next(line.split(":", 1)[1].strip() for line in lines if line.startswith("model name"))
    except (OSError, StopIteration):
        return platform.processor() or platform.machine()


if __name__ == "__main__":
    if not shutil.which(SNAKEMAKE):
        raise SystemExit("Snakemake is not installed: run make workflow-env")
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 1)
