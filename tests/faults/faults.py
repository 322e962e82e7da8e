#!/usr/bin/env python3
"""What a hostile world does to a run, and what must hold after it:

    tests/faults/faults.py build/ricochet [words of names of cases ...]

A short scene is run once in peace. Then each case below starts it again, lets something happen, and looks: what is there is whole (rows of
the history are those of the run in peace, JSON parses, HDF5 opens), the message is one and says what to do, and 'run --resume' brings the
history to the same bytes. Moments are random but for their seed, which is printed and may be given as RICOCHET_FAULTS_SEED.
"""
import contextlib
import json
import os
import pathlib
import random
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time

PROGRAM = pathlib.Path(sys.argv[1]).resolve()
SOURCE = pathlib.Path(__file__).resolve().parents[2]
SEED = int(os.environ.get("RICOCHET_FAULTS_SEED", time.time_ns() % 100000))
RANDOM = random.Random(SEED)
MPIRUN = ["mpirun", "--oversubscribe", "--bind-to", "none", "-np"]
LONGEST = 300  # [s] of anything here, on a busy machine

SETTINGS = ["Plate 1/Grid spacing=4 mm", "Output/Checkpoint interval=5 us", "Output/Frame interval=30 us",
            "Output/History interval=1 us", "Output/Pictures=false", "Output/Report=false", "Time/Final time=100 us",
            "Time/Stop early=false"]


class Failure(Exception):
    pass


def demand(statement, what):
    if not statement:
        raise Failure(what)


def sets(settings):
    return [word for setting in settings for word in ("--set", setting)]


def command(folder, more=(), ranks=1, file=SOURCE / "prm/quickstart.prm"):
    launcher = MPIRUN + [str(ranks)] if ranks > 1 else []
    return launcher + [str(PROGRAM), "run", str(file), "--output", str(folder)] + sets(SETTINGS) + list(more)


def start(arguments, **options):
    return subprocess.Popen(arguments, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                            start_new_session=True, **options)


def end(process):
    try:
        out, err = process.communicate(timeout=LONGEST)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        process.communicate()
        raise Failure(f"still runs after {LONGEST} s")
    return process.returncode, out, err


def run(arguments, **options):
    return end(start(arguments, **options))


def wait_until(statement, process, what):
    stop = time.monotonic() + LONGEST
    while not statement():
        demand(process.poll() is None, f"the run ended before {what}")
        demand(time.monotonic() < stop, f"no {what} after {LONGEST} s")
        time.sleep(0.005)


def checkpoints(folder):
    return sorted(path for path in (folder / "checkpoint").glob("step_*") if not path.suffix)


def rows(folder):
    path = folder / "history.csv"
    return path.read_bytes() if path.exists() else b""


def wait_for_checkpoint(folder, process, n=1):
    wait_until(lambda: len(checkpoints(folder)) >= n, process, f"checkpoint {n}")


def demand_whole(folder, reference):
    history = rows(folder)
    demand(reference.startswith(history[:history.rfind(b"\n") + 1]), "rows of the history are not those of the run in peace")
    for path in folder.rglob("*.json"):
        json.loads(path.read_text())
    with contextlib.suppress(ImportError):
        import h5py
        for path in folder.rglob("*.h5"):
            if ".tmp" not in str(path) and path.name != "history.h5":
                with h5py.File(path):
                    pass


def resume(folder, ranks=1, more=()):
    launcher = MPIRUN + [str(ranks)] if ranks > 1 else []
    return run(launcher + [str(PROGRAM), "run", "--resume", str(folder), *more])


def demand_resumed(folder, reference, ranks=1):
    status, _, err = resume(folder, ranks)
    demand(status == 0, f"--resume ended with {status}: {err}")
    demand(rows(folder) == reference, "the history after --resume is not that of the run in peace")
    demand(not list(folder.rglob("*.tmp")), f"left behind: {list(folder.rglob('*.tmp'))}")


def demand_message(text, words):
    for word in words:
        demand(word in text, f"no '{word}' in: {text}")


def ranks_of(mpirun):
    children = pathlib.Path(f"/proc/{mpirun.pid}/task/{mpirun.pid}/children").read_text().split()
    return [int(pid) for pid in children if "ricochet" in pathlib.Path(f"/proc/{pid}/comm").read_text()]


# The cases: each gets an empty folder that does not exist yet, and the history of the run in peace.

def killed_at_a_random_moment(folder, reference):
    for turn in range(3):
        target = folder.with_name(f"{folder.name}_{turn}")
        process = start(command(target))
        wait_until(lambda: (target / "used.prm").exists(), process, "used.prm")
        time.sleep(RANDOM.uniform(0., 2.))
        process.kill()
        end(process)
        demand_whole(target, reference)
        if not (target / "summary.json").exists():
            demand_resumed(target, reference)


def killed_while_a_checkpoint_is_written(folder, reference):
    for turn in range(3):
        target = folder.with_name(f"{folder.name}_{turn}")
        process = start(command(target))
        wait_for_checkpoint(target, process)
        wait_until(lambda: list((target / "checkpoint").glob("*.tmp")), process, "half a checkpoint")
        time.sleep(RANDOM.uniform(0., 0.005))
        process.kill()
        end(process)
        demand_whole(target, reference)
        demand_resumed(target, reference)


def one_rank_killed(folder, reference):
    process = start(command(folder, ranks=3))
    wait_for_checkpoint(folder, process)
    os.kill(RANDOM.choice(ranks_of(process)), signal.SIGKILL)
    status, _, _ = end(process)
    demand(status != 0, "mpirun ended well")
    demand_whole(folder, reference)
    demand_resumed(folder, reference, ranks=2)


def all_ranks_killed(folder, reference):
    process = start(command(folder, ranks=2))
    wait_for_checkpoint(folder, process)
    for rank in ranks_of(process):
        os.kill(rank, signal.SIGKILL)
    end(process)
    demand_whole(folder, reference)
    demand_resumed(folder, reference, ranks=3)


def stopped_by(number, folder, reference):
    process = start(command(folder))
    wait_for_checkpoint(folder, process)
    process.send_signal(number)
    status, out, err = end(process)
    demand(status == 130, f"ended with {status} instead of 130: {err}")
    demand_message(out + err, ["--resume"])
    demand(json.loads((folder / "summary.json").read_text())["interrupted"], "the summary does not say that it was interrupted")
    demand_whole(folder, reference)
    demand_resumed(folder, reference)


def sigterm(folder, reference):
    stopped_by(signal.SIGTERM, folder, reference)


def sigint(folder, reference):
    stopped_by(signal.SIGINT, folder, reference)


def sighup(folder, reference):
    stopped_by(signal.SIGHUP, folder, reference)


def sigxcpu(folder, reference):
    stopped_by(signal.SIGXCPU, folder, reference)


def sigint_twice(folder, reference):
    process = start(command(folder))
    wait_for_checkpoint(folder, process)
    process.send_signal(signal.SIGINT)
    time.sleep(RANDOM.uniform(0., 0.05))
    process.send_signal(signal.SIGINT)
    status, _, _ = end(process)
    demand(status in (130, -signal.SIGINT), f"ended with {status}")
    demand_whole(folder, reference)
    demand_resumed(folder, reference)


def sigterm_to_mpirun(folder, reference):
    process = start(command(folder, ranks=2))
    wait_for_checkpoint(folder, process)
    process.send_signal(signal.SIGTERM)
    end(process)
    demand_whole(folder, reference)
    demand((folder / "summary.json").exists(), "no summary")
    demand_resumed(folder, reference, ranks=2)


def asleep_for_a_while(folder, reference):
    process = start(command(folder))
    wait_for_checkpoint(folder, process)
    process.send_signal(signal.SIGSTOP)
    time.sleep(1.)
    process.send_signal(signal.SIGCONT)
    status, _, err = end(process)
    demand(status == 0, f"ended with {status}: {err}")
    demand(rows(folder) == reference, "another history")


def disk_full(folder, reference):
    # From now on files may not grow beyond 4 KiB: what a full disk does, without one.
    process = start(command(folder))
    wait_for_checkpoint(folder, process)
    resource.prlimit(process.pid, resource.RLIMIT_FSIZE, (4096, resource.getrlimit(resource.RLIMIT_FSIZE)[1]))
    status, _, err = end(process)
    demand(status == 3, f"ended with {status} instead of 3: {err}")
    demand_message(err, ["File too large"])
    demand_whole(folder, reference)
    demand_resumed(folder, reference)


def folder_that_may_not_be_written(folder, _):
    if os.geteuid() == 0:
        parent = pathlib.Path("/proc/ricochet_results")  # root may write everywhere else
    else:
        folder.mkdir()
        folder.chmod(0o500)
        parent = folder / "below"
    status, _, err = run(command(parent))
    demand(status == 3, f"ended with {status} instead of 3: {err}")
    demand_message(err, [str(parent)])


def folder_removed(folder, _):
    process = start(command(folder))
    wait_for_checkpoint(folder, process)
    shutil.rmtree(folder, ignore_errors=True)
    status, _, err = end(process)
    demand(status == 3, f"ended with {status} instead of 3: {err}")
    demand_message(err, [str(folder)])


def two_runs_in_one_folder(folder, reference):
    first = start(command(folder))
    wait_for_checkpoint(folder, first)
    first.send_signal(signal.SIGSTOP)  # so that it is there as long as the others try
    for more in ([], ["--force"]):
        status, _, err = run(command(folder, more))
        demand(status == 3, f"the second ended with {status} instead of 3")
        demand_message(err, ["Another ricochet process" if more else "not empty"])
    first.send_signal(signal.SIGCONT)
    status, _, err = end(first)
    demand(status == 0, f"the first ended with {status}: {err}")
    demand(rows(folder) == reference, "another history")


def two_resumes_of_one_folder(folder, reference):
    process = start(command(folder))
    wait_for_checkpoint(folder, process)
    process.kill()
    end(process)
    both = [start([str(PROGRAM), "run", "--resume", str(folder)]) for _ in range(2)]
    ends = sorted(end(one)[::2] for one in both)
    demand([status for status, _ in ends] == [0, 3], f"they ended with {ends}")
    demand_message(ends[1][1], ["Another ricochet process"])
    demand(rows(folder) == reference, "another history")


def no_matplotlib(folder, reference):
    modules = folder.with_name("modules")
    modules.mkdir()
    (modules / "matplotlib.py").write_text("raise ImportError('none here')\n")
    process = start(command(folder))
    wait_for_checkpoint(folder, process)
    process.kill()
    end(process)
    status, _, err = run([str(PROGRAM), "run", "--resume", str(folder), "--set", "Output/Pictures=true"],
                         env=dict(os.environ, PYTHONPATH=str(modules)))
    demand(status == 0, f"ended with {status}: {err}")
    demand_message(err, ["No pictures", "matplotlib"])
    demand(rows(folder) == reference, "another history")


def no_home(folder, reference):
    environment = {name: value for name, value in os.environ.items() if name not in ("HOME", "XDG_CACHE_HOME")}
    status, _, err = run(command(folder), env=environment)
    demand(status == 0 and rows(folder) == reference, f"ended with {status}: {err}")


def other_locale(folder, reference):
    for name in ("de_DE.UTF-8", "C", "nowhere"):
        target = folder.with_name(f"{folder.name}_{name}")
        status, _, err = run(command(target), env=dict(os.environ, LC_ALL=name, LANG=name))
        demand(status == 0 and rows(target) == reference, f"{name}: ended with {status}: {err}")


def blanks_in_paths(folder, reference):
    target = folder.with_name("a folder with blanks, ä and 'quotes'")
    status, _, err = run(command(target))
    demand(status == 0 and rows(target) == reference, f"ended with {status}: {err}")


def nobody_reads(folder, reference):
    process = start(command(folder))
    process.stdout.close()
    process.stderr.close()
    demand(process.wait(LONGEST) in (0, 130), f"ended with {process.returncode}")
    demand_whole(folder, reference)
    if rows(folder) != reference:
        demand_resumed(folder, reference)


CASES = [killed_at_a_random_moment, killed_while_a_checkpoint_is_written, one_rank_killed, all_ranks_killed, sigterm,
         sigint, sighup, sigxcpu, sigint_twice, sigterm_to_mpirun, asleep_for_a_while, disk_full, folder_that_may_not_be_written,
         folder_removed, two_runs_in_one_folder, two_resumes_of_one_folder, no_matplotlib, no_home, other_locale,
         blanks_in_paths, nobody_reads]


def main():
    wanted = sys.argv[2:]
    print(f"RICOCHET_FAULTS_SEED={SEED}", flush=True)
    n_failed = 0
    with tempfile.TemporaryDirectory(prefix="ricochet_faults_") as name:
        place = pathlib.Path(name)
        status, _, err = run(command(place / "peace"))
        if status != 0:
            sys.exit(f"the run in peace ended with {status}: {err}")
        reference = rows(place / "peace")
        for case in CASES:
            if wanted and not any(word in case.__name__ for word in wanted):
                continue
            begin = time.monotonic()
            (place / case.__name__).mkdir()
            try:
                case(place / case.__name__ / "results", reference)
                verdict = "ok"
            except (Failure, OSError, ValueError) as failure:
                n_failed += 1
                verdict = f"FAILED: {failure}"
            print(f"{case.__name__.replace('_', ' ')}: {verdict} ({time.monotonic() - begin:.1f} s)", flush=True)
    sys.exit(1 if n_failed else 0)


main()
