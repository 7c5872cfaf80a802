"""Bad input to the command: one line on stderr that names file and key, exit code 2."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from segfmu import InputError, load_mission
from segfmu.validation.files.scenario_file import load_scenario
from tests.command import called as segfmu

CRANE = "bridge_mass = 2.2\ntrolley_mass = 1.155\npayload_mass = 1.0\n"
LIMITS = "".join(
    f"[limits.{a}]\nvelocity = 1.0\nacceleration = 1.0\njerk = 2.0\nsnap = 20.0\n" for a in "xyz"
)
POINTS = (
    "[[waypoints]]\nposition = [0.0, 0.0, -0.5]\n"
    "[[waypoints]]\nposition = [0.3, 0.2, -0.5]\n"
)
GOOD = 'crane = "crane.toml"\n' + LIMITS + POINTS


COMMAND = Path(sys.executable).with_name("segfmu")


def refused(cwd: Path, *words: str) -> str:
    """The one line on stderr of a command that is refused."""
    done = segfmu(*words, cwd=cwd)
    assert (done.returncode, done.stdout) == (2, ""), done.stderr
    assert done.stderr.count("\n") == 1 and done.stderr.startswith("segfmu: ")
    return done.stderr


def files(folder: Path, mission: str = GOOD, crane: str = CRANE) -> None:
    (folder / "mission.toml").write_text(mission, encoding="utf-8")
    (folder / "crane.toml").write_text(crane, encoding="utf-8")


# what is written in place of what, and what the line says
MISSIONS = {
    "no rope": ("0.2, -0.5", "0.2, -6e-17",
                "waypoints.2.position: z -6e-17 m must be below the trolley, z <= -1e-06"),
    "many points": (POINTS, 129 * POINTS, "waypoints: must have at most 256 values, got 258"),
    "no name": ("crane =", 'name = ""\ncrane =', "name: must not be empty, got ''"),
    "far": ("[0.3,", "[1e300,", "waypoints.2.position, x: must be at most 1e+06 m, got 1e+300"),
    "slow": ("velocity = 1.0", "velocity = 1e-12", "limits.x.velocity: must be at least 1e-06 m/s"),
    "fast": ("velocity = 1.0", "velocity = 1e300", "limits.x.velocity: must be at most 1e+06 m/s"),
    "jerk": ("jerk = 2.0", "jerk = 1e30", "limits.x.jerk: must be at most 1e+12 m/s3, got 1e+30"),
    "low snap": ("snap = 20.0", "snap = 1e-300", "limits.x.snap: must be at least 1e-06 m/s4"),
    "high snap": ("snap = 20.0", "snap = 1e300", "limits.x.snap: must be at most 1e+12 m/s4"),
    "sample time": ("crane =", "sample_time = 1e-300\ncrane =", "sample_time: must be at least"),
    "missing crane": ("crane.toml", "nowhere.toml", "crane: nowhere.toml: cannot be read: No such"),
    "crane of no name": ("crane.toml", "", "crane: no file is named, got ''"),
    "crane in a folder": ("crane.toml", ".", "crane: .: this is a folder; name a file in it"),
    "capital letter": ("[limits.x]", "[limits.X]", "limits.X: unknown key; did you mean x? (and "),
    "no number": ("[0.3,", "[nan,", "waypoints.2.position, x: must be a finite number, got nan"),
    "huge list": ("[0.3,", f"[{'0.3, ' * 9999}", "waypoints.2.position: must have 3 values (x,"),
    "two numbers": ("[0.3, 0.2, -0.5]", "[0.3, 0.2]", "must have 3 values (x, y, z), got [0.3, 0"),
    "no obstacles": ("crane =", "obstacles = 5\ncrane =", "obstacles: must be a list, got 5"),
    "misspelt table": ("[limits.x]", "[limit.x]", "limit: unknown key; did you mean limits?"),
    "key of a crane": ("crane =", "rope_max = 1.0\ncrane =", "a key elsewhere: crane.rope_max"),
    "as in Python": ("[limits.x]", "[limits]\nvelocity = 1.0\n[limits.x]", "limits.velocity: "
                     "unknown key; it is a key elsewhere: limits.x.velocity, limits.y.vel"),
    "only misplaced": (GOOD[GOOD.index("[limits.x]"):], "[limits]\nvelocity = 1.0\n",
                       "limits.velocity: unknown key; it is a key elsewhere: limits.x.velocity"),
    "wrong type": ("[0.0, 0.0, -0.5]", '"origin"', "waypoints.1.position: "),
}


def test_a_process_of_its_own_says_the_same(tmp_path: Path) -> None:
    files(tmp_path, GOOD.replace("jerk = 2.0", "jerk = 1e30"))
    for words in (("plan", "mission.toml"), ("plann",), ("plan", "mission.toml", "-o", "")):
        done = subprocess.run(
            [COMMAND, *words], capture_output=True, text=True, cwd=tmp_path, timeout=120,
        )
        assert (done.returncode, done.stdout) == (2, "")
        assert done.stderr == refused(tmp_path, *words)


@pytest.mark.parametrize("name", MISSIONS)
def test_a_bad_mission_is_one_line(name: str, tmp_path: Path) -> None:
    old, new, words = MISSIONS[name]
    assert old in GOOD
    files(tmp_path, GOOD.replace(old, new, 1))
    line = refused(tmp_path, "plan", "mission.toml", "-o", "out")
    assert line.startswith("segfmu: mission.toml: ") and words in line
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("given", [
    "5", "[0.1, 0]", "{}", "nan", '["free", 0, 0]', '"Free"', "[nan, 0, 0]", "[0.1, 0, true]",
])
@pytest.mark.parametrize("state", ["velocity", "acceleration"])
def test_states_are_numbers_or_free(state: str, given: str, tmp_path: Path) -> None:
    files(tmp_path, f"{GOOD}{state} = {given}\n")
    with pytest.raises(InputError) as info:
        load_mission(tmp_path / "mission.toml")
    line = str(info.value).partition("mission.toml: ")[2]
    assert line.startswith(f'waypoints.2.{state}: must be three numbers or "free", got ')
    assert "(and" not in line


@pytest.mark.parametrize("key", ["force_max", "velocity_max", "acceleration_max", "power_max"])
def test_bounds_of_drives_are_no_rounding_errors(key: str, tmp_path: Path) -> None:
    files(tmp_path, crane=f"{CRANE}[bridge]\n{key} = 1e-300\n")
    with pytest.raises(InputError, match=rf"bridge.{key}: must be at least 1e-05 .*, got 1e-300"):
        load_mission(tmp_path / "mission.toml")


SCENARIO = 'name = "s"\nmission = "mission.toml"\n'
CRITERION = '[[criteria]]\nname = "c"\nsignal = "sway.x.angle"\nbound = 1.0\n'
PROFILE = '[[profiles]]\nvariable = "a"\ntimes = [0, 1]\nvalues = [1, 2]\n'
RECORDED = '[[profiles]]\nfile = "r.csv"\n'
SCENARIOS = {
    "twice": (SCENARIO + 2 * CRITERION, "sc.toml: criteria: two of them are called c"),
    "events": (SCENARIO + CRITERION + 2 * "[[events]]\ntime = 0.1\nvalues = { a = 1.0 }\n",
               "sc.toml: events: two of them set a at 0.1, of which only one could act; leave one "
               "out, or move it"),
    "lead": (SCENARIO + "lead = true\n" + CRITERION, 'sc.toml: lead is for coupling = "parallel"'),
    "kind": (SCENARIO + CRITERION + 'kind = "at"\n', "criteria.1: at is missing, which the kind at "
             "needs"),
    "signal": (SCENARIO + CRITERION.replace('"sway.x.angle"', "5"), "sc.toml: criteria.1.signal: "
               "must be the name of a variable, or a list of names, got 5"),
    "window": (SCENARIO + CRITERION + "window = [0]\n", "window: must have at least 2 values, got "
               "[0]"),
    "no time": (SCENARIO + CRITERION + "window = [nan, 1]", "sc.toml: criteria.1.window.1: must be "
                'a time, or "start", "arrival" or "end" plus or minus a time, got nan'),
    "endless time": (SCENARIO + CRITERION + "[[events]]\ntime = inf\nvalues = { a = 1 }",
                     'sc.toml: events.1.time: must be a time, or "start", "arrival" or "end" plus '
                     "or minus a time, got inf"),
    "no name": (SCENARIO + CRITERION.replace('"sway.x.angle"', '""'), "sc.toml: criteria.1.signal: "
                "must have at least 1 character, got ''"),
    "no text": (SCENARIO + CRITERION + "[[events]]\ntime = 1\nvalues = { 'a.b' = [1] }", "sc.toml: "
                "events.1.values.a.b: must be a number, true, false, or the name of an item"),
    "no number": (SCENARIO + CRITERION + "[[events]]\ntime = 1\nvalues = { a = nan }",
                  "sc.toml: events.1.values.a: must be finite, got nan"),
    "endless sample": (SCENARIO + CRITERION + PROFILE.replace("2]", "-inf]"),
                       "sc.toml: profiles.1.values.2: must be finite, got -inf"),
    "two profiles": (SCENARIO + CRITERION + 2 * PROFILE,
                     "sc.toml: profiles: two of them have a; join their samples"),
    "profile and file": (SCENARIO + CRITERION + PROFILE + RECORDED,
                         "sc.toml: profiles: two of them have a; join their samples"),
    "no recording": (SCENARIO + CRITERION + RECORDED.replace("r.csv", "no.csv"),
                     "no.csv: cannot be read: No such file or directory"),
    "base of another kind": ('base = "mission.toml"\n' + CRITERION,
                             "mission.toml: this is a mission file, not a scenario file; segfmu "
                             "plan, build and simulate take it"),
    **{
        f"times {times}": (
            f'{SCENARIO}{CRITERION}[[profiles]]\nvariable = "a"\ntimes = {times}\n'
            "values = [1, 2]", f"sc.toml: profiles.1: times must increase, got {words}; sort the "
            "samples and give one for each time",
        ) for times, words in (
            ("[2, 1]", "1.0 after 2.0"), ("[1, 1]", "1.0 after 1.0"),
            ('["start + 1", 0.5]', "0.5 after 'start + 1'"),
        )
    },
}


@pytest.mark.parametrize("name", SCENARIOS)
def test_a_bad_scenario_names_its_key(name: str, tmp_path: Path) -> None:
    text, words = SCENARIOS[name]
    files(tmp_path)
    (tmp_path / "sc.toml").write_text(text, encoding="utf-8")
    (tmp_path / "r.csv").write_text("time,a\n0,1\n", encoding="utf-8")
    with pytest.raises(InputError) as info:
        load_scenario(tmp_path / "sc.toml")
    assert str(info.value).startswith(f"{tmp_path / 'sc.toml'}: ")
    assert str(info.value).endswith(words)


def test_two_criteria_of_one_name_are_refused_beside_those_of_the_base(tmp_path: Path) -> None:
    files(tmp_path)
    (tmp_path / "_base.toml").write_text(SCENARIO + CRITERION, encoding="utf-8")
    own = CRITERION.replace("1.0", "0.5")
    for count in (1, 2):
        text = 'name = "s"\nbase = "_base.toml"\n' + count * own
        (tmp_path / "sc.toml").write_text(text, encoding="utf-8")
        if count == 1:
            (criterion,) = load_scenario(tmp_path / "sc.toml").file.criteria
            assert criterion.bound == 0.5
            continue
        with pytest.raises(InputError, match=r"criteria: two of them are called c$"):
            load_scenario(tmp_path / "sc.toml")


@pytest.mark.parametrize("state", ["velocity", "acceleration"])
def test_the_load_rests_at_both_ends(state: str, tmp_path: Path) -> None:
    moving = f"{state} = [0.1, 0.0, 0.0]\n"
    files(tmp_path, GOOD + moving)
    line = refused(tmp_path, "plan", "mission.toml")
    assert f"mission.toml: waypoints.2.{state}: the last waypoint must be at rest" in line
    files(tmp_path, GOOD.replace("-0.5]\n", f"-0.5]\n{moving}", 1))
    line = refused(tmp_path, "plan", "mission.toml")
    assert f"mission.toml: waypoints.1.{state}: the first waypoint must be at rest" in line


# what is written before the last mass, and what the line says
CRANES = {
    "gravity": ("gravity = 1e9\n", "gravity: must be at most 1000 m/s2, got 1000000000.0"),
    "lag": ("bridge = { lag = -1 }\n", "bridge.lag: must be at least 0 s, got -1"),
    "short lag": ('drive = "velocity"\nhoist = { lag = 1e-6 }\n',
                  "hoist.lag must be 0 or at least 1e-05 s, got 1e-06 s; 0 is an ideal drive"),
    "long delay": ("bridge = { dead_time = 1e3 }\ncontroller = { sample_time = 1e-3 }\n",
                   "bridge.dead_time 1000 s is longer than 100000 periods of 0.001 s; lower it or "
                   "raise controller.sample_time"),
    "place": ("lag = 1\n", "lag: unknown key; it is a key elsewhere: bridge.lag, trolley.lag"),
    "stops": ("travel = { trolley = [3, 1] }\n", "travel.trolley: min 3 m must be below max 1 m"),
    "broken": ("gravity = = 1\n", "not valid TOML"),
    "misspelt": ("payload_mas = 1.0  # ", "payload_mas: unknown key; did you mean payload_mass?"),
    "missing": ("# ", "payload_mass: this key is missing"),
    "no name": ('name = ""\n', "name: must not be empty, got ''"),
    "blank name": ('name = "  "\n', "name: must not be empty, got ' '"),
    "two changes": ("load.changes = [{ time = 2, mass = 1.0 }, { time = 2.0, mass = 2.0 }]\n",
                    "two changes of the load are at 2 s, and one alone can count; leave one out"),
}


@pytest.mark.parametrize("name", CRANES)
def test_a_bad_crane_is_one_line_with_both_files(name: str, tmp_path: Path) -> None:
    new, words = CRANES[name]
    files(tmp_path, crane=CRANE.replace("payload", f"{new}payload", 1))
    line = refused(tmp_path, "plan", "mission.toml")
    assert line.startswith("segfmu: mission.toml: crane: crane.toml: ") and words in line


@pytest.mark.parametrize("table", ["crane", "true_crane"])
def test_a_crane_is_told_with_the_drives_of_the_run(table: str, tmp_path: Path) -> None:
    driven = f'[simulation]\ndrive = "velocity"\n[{table}]\nbridge = {{ lag = 1e-6 }}\n'
    mission = GOOD.replace('crane = "crane.toml"\n', "")
    head = "" if table == "crane" else f"[crane]\n{CRANE}"
    own = CRANE if table == "crane" else ""
    files(tmp_path, f"{head}{mission}{driven}{own}")
    words = f"{table}: bridge.lag must be 0 or at least 1e-05 s, got 1e-06 s"
    assert words in refused(tmp_path, "plan", "mission.toml")


def test_a_trolley_that_the_load_moves_as_it_likes_is_refused(tmp_path: Path) -> None:
    light = CRANE.replace("1.155", "9.9e-4")
    files(tmp_path, crane=light)
    words = "trolley_mass: 0.00099 kg swings against a load of 1 kg too fast to be followed; give "
    assert f"{words}it 0.001 kg or more" in refused(tmp_path, "simulate", "mission.toml")
    # no mass acts on the motion of velocity drives
    files(tmp_path, crane=f'{light}drive = "velocity"\n')
    load_mission(tmp_path / "mission.toml")


# what is written in place of the crane's name, and what the line says
LONG = {
    "decimal": ("9" * 5000, "not valid TOML: a number of 5000 digits (at line 1)"),
    "parted": ("9_" * 4500 + "9", "not valid TOML: a number of 9001 digits (at line 1)"),
    "hexadecimal": ("0x" + "f" * 5000, "not valid TOML: crane has more than the 64 bits of an"),
    "less": (str(2**63), "not valid TOML: crane has more than the 64 bits of an integer"),
    "in lists": (f"[[1], [{2**63}]]", "not valid TOML: crane has more than the 64 bits"),
    "deep": ("[" * 5000, "not valid TOML: tables or lists in each other too deep"),
}


@pytest.mark.parametrize(("text", "told"), [
    ("gravity = 9.8\ngravity = 9.9", "gravity is there twice (at line 2)"),
    ("[a]\n'b c' = 1\n'b c' = [\n1,\n[2]\n] # d = 3\n", "'b c' is there twice (at line 3)"),
    ("a.b = 1\na.b = 2\n", "a.b is there twice (at line 2)"),
    ("a = 1\n[[ a ]] # again\n", "a is there twice (at line 2)"),
    ("[a.b]\n\n[a.b]\n", "a.b is there twice (at line 3)"),
    ("a = { b = 1 }\na.c = 2\n", "a.c is there twice (at line 2)"),
    ('"a+b" = 1\n"a+b" = 2\n', '"a+b" is there twice (at line 2)'),
    ('x = 1\n"q =[" = 2\n"q =[" = 3\n', '"q =[" is there twice (at line 3)'),
])
def test_a_key_that_is_there_twice_is_told(text: str, told: str, tmp_path: Path) -> None:
    files(tmp_path, text)
    line = refused(tmp_path, "plan", "mission.toml")
    assert f"mission.toml: not valid TOML: {told}" in line


@pytest.mark.parametrize("name", LONG)
def test_integers_and_depths_that_nothing_reads(name: str, tmp_path: Path) -> None:
    value, words = LONG[name]
    files(tmp_path, GOOD.replace('"crane.toml"', value))
    line = refused(tmp_path, "plan", "mission.toml")
    assert words in line and len(line) < 150


@pytest.mark.parametrize("changes", [
    {"crane": {"payload_mass": 10**400}}, {"crane": {"payload_mass": 1 << 70000}},
    {"waypoints": [{"position": [0, 0, -1], "velocity": [10**400, 0, 0]}] * 2},
    {"smoothness": 1 << 70000}, {"name": 1 << 70000}, {"limits": 1 << 70000},
])
def test_huge_integers_of_python_are_one_short_line(changes: dict, tmp_path: Path) -> None:
    files(tmp_path)
    with pytest.raises(InputError, match=r": must .* got ") as info:
        load_mission(tmp_path / "mission.toml", changes)
    assert len(str(info.value)) < 300


@pytest.mark.parametrize(("stops", "words"), [
    ("bridge = [-1.0, 0.2]", "waypoints.2.position, x: 0.3 m takes the bridge to 0.3 m, beyond"),
    ("trolley = [0.1, 1.0]", "waypoints.1.position, y: 0.0 m takes the trolley to 0.0 m, beyond"),
    ("rope = [0.6, 1.0]", "waypoints.1.position, z: -0.5 m takes the rope to 0.5 m, beyond"),
])
def test_waypoints_are_between_the_end_stops(stops: str, words: str, tmp_path: Path) -> None:
    files(tmp_path, crane=f"{CRANE}[travel]\n{stops}\n")
    assert words in refused(tmp_path, "plan", "mission.toml")


@pytest.mark.parametrize(("stops", "words"), [
    ("bridge = [0.0, 0.31]", "takes the bridge to 0.3"),
    ("trolley = [0.0, 0.21]", "takes the trolley to 0.2"),
])
def test_the_way_between_waypoints_is_between_the_end_stops(
    stops: str, words: str, tmp_path: Path
) -> None:
    # it arrives moving outwards, turns and comes back
    moving = POINTS.replace(
        "[[waypoints]]\nposition = [0.3, 0.2, -0.5]\n",
        "[[waypoints]]\nposition = [0.29, 0.19, -0.5]\nvelocity = [0.3, 0.3, 0.0]\n"
        "[[waypoints]]\nposition = [0.29, 0.19, -0.45]\n",
    )
    files(tmp_path, GOOD.replace(POINTS, moving))
    assert segfmu("plan", "mission.toml", cwd=tmp_path).returncode == 0
    files(tmp_path, GOOD.replace(POINTS, moving), f"{CRANE}[travel]\n{stops}\n")
    done = segfmu("plan", "mission.toml", cwd=tmp_path)
    assert (done.returncode, done.stdout, done.stderr.count("\n")) == (1, "", 1)
    assert words in done.stderr and "travel." in done.stderr


@pytest.mark.parametrize("encoding", ["ascii", "cp1252"])
def test_output_without_the_characters_of_a_name(encoding: str, tmp_path: Path) -> None:
    files(tmp_path, 'name = "Kran \u2192 S\u00fcd"\n' + GOOD)
    done = subprocess.run(
        [COMMAND, "plan", "mission.toml"], cwd=tmp_path,
        capture_output=True, timeout=120, env=os.environ | {"PYTHONIOENCODING": encoding},
    )
    assert (done.returncode, done.stderr) == (0, b"")
    assert b"Kran \\u2192 S" in done.stdout


def test_room_for_fewer_waypoints_than_the_mission_has(tmp_path: Path) -> None:
    more = "".join(f"[[waypoints]]\nposition = [0.{i}, 0.1, -0.5]\n" for i in range(4, 8))
    files(tmp_path, GOOD + more)
    assert "room for 3 is less than the 6 of the mission" in refused(
        tmp_path, "build", "mission.toml", "--waypoints", "3"
    )


def test_a_byte_order_mark_is_accepted(tmp_path: Path) -> None:
    files(tmp_path, "\ufeff" + GOOD, "\ufeff" + CRANE)
    done = segfmu("plan", "mission.toml", cwd=tmp_path)
    assert (done.returncode, done.stderr) == (0, "")


def test_crane_and_mission_in_each_others_place(tmp_path: Path) -> None:
    files(tmp_path, GOOD.replace("crane.toml", "mission.toml"))
    line = refused(tmp_path, "plan", "mission.toml")
    assert line.endswith(
        "crane: mission.toml: this is a mission file, not a crane file; segfmu plan, build and "
        "simulate take it\n"
    )
    line = refused(tmp_path, "simulate", "crane.toml")
    assert line == (
        "segfmu: crane.toml: this is a crane file, not a mission file; a mission names it, as "
        'crane = "crane.toml"\n'
    )


KINDS = {
    "crane": "crane_lab.toml", "mission": "paper.toml", "scenario": "scenarios/gust.toml",
    "campaign": "campaigns/paper.toml",
}


@pytest.mark.parametrize(("command", "wanted"), [
    ("plan", "mission"), ("build", "mission"), ("simulate", "mission"), ("validate", "scenario"),
    ("campaign", "campaign"),
])
@pytest.mark.parametrize("given", KINDS)
def test_a_file_of_another_kind_is_named(
    command: str, wanted: str, given: str, tmp_path: Path
) -> None:
    if given == wanted:
        return
    path = Path(__file__).parents[1] / "models" / KINDS[given]
    line = refused(tmp_path, command, str(path))
    assert f": this is a {given} file, not a {wanted} file; " in line


def test_a_long_plan_is_thinned_and_says_so(tmp_path: Path) -> None:
    files(tmp_path, GOOD.replace("-0.5]\n", "-0.5]\ndwell = 4575.0\n", 1))
    done = segfmu("plan", "mission.toml", "-o", "out", cwd=tmp_path)
    assert done.returncode == 0
    assert "plan.csv has a row every 0.229 s, not every step of 0.001 s" in done.stdout
    table = tmp_path / "out" / "plan.csv"
    rows = table.read_text().splitlines()
    assert len(rows) <= 20_002 and table.stat().st_size < 10e6
    # the end of the plan is there
    assert float(rows[-1].split(",")[0]) == pytest.approx(4575 + 1.8, abs=1e-2)
    # a run of so many steps is refused before anything is built
    line = refused(tmp_path, "simulate", "mission.toml", "-o", "run")
    assert "mission.toml: simulation.step: 4579.8 s in steps of 0.001 s are" in line
    assert not (tmp_path / "run").exists()


def test_the_user_chooses_the_rows(tmp_path: Path) -> None:
    files(tmp_path, GOOD + "[simulation]\noutput_step = 0.1\n")
    done = segfmu("plan", "mission.toml", "-o", "out", cwd=tmp_path)
    times = [
        float(line.split(",")[0])
        for line in (tmp_path / "out" / "plan.csv").read_text().splitlines()[1:]
    ]
    assert times[:3] == pytest.approx([0.0, 0.1, 0.2]) and times[-1] - times[-2] < 0.1
    assert "plan.csv has a row every 0.1 s" in done.stdout


FOLDERS = {
    "": "output is empty", "taken": "output taken: this is no folder, but a file",
    "taken/below": "Not a directory",
    "astray": "output astray: this is no folder, but a link that leads nowhere; name another one",
}


@pytest.mark.parametrize("folder", FOLDERS)
def test_folders_that_cannot_be(folder: str, tmp_path: Path) -> None:
    files(tmp_path)
    (tmp_path / "taken").write_text("x", encoding="utf-8")
    (tmp_path / "astray").symlink_to("nowhere")
    before = sorted(tmp_path.iterdir())
    for command in ("plan", "simulate", "build"):
        line = refused(tmp_path, command, "mission.toml", "-o", folder)
        assert FOLDERS[folder] in line
    assert sorted(tmp_path.iterdir()) == before


def test_a_folder_that_is_there_and_takes_no_file(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    files(tmp_path)
    (tmp_path / "shut").mkdir()
    # who runs as root can write everywhere
    monkeypatch.setattr("os.access", lambda path, _: Path(path) != Path("shut"))
    line = refused(tmp_path, "plan", "mission.toml", "-o", "shut")
    assert line.endswith("output shut: cannot write into this folder: Permission denied\n")
    monkeypatch.setattr("os.access", lambda path, _: Path(path).name != "shut")
    line = refused(tmp_path, "validate", "nowhere.toml", "--junit", "shut/j.xml")
    assert line.endswith("shut/j.xml: cannot be written: Permission denied\n")


def test_names_and_files_that_are_none(tmp_path: Path) -> None:
    (tmp_path / "folder.toml").mkdir()
    (tmp_path / "empty.toml").touch()
    (tmp_path / "latin.toml").write_bytes("name = 'Kräne'".encode("latin-1"))
    for words, said in (
        (("folder.toml",), "folder.toml: this is a folder; name a file in it"),
        (("",), ".: this is a folder; name a file in it"),
        (("empty.toml",), "empty.toml: crane: this key is missing"),
        (("latin.toml",), "latin.toml: not a text file in UTF-8"),
        (("of\ntwo lines.toml",), "of two lines.toml: cannot be read"),
        (("/dev/zero",), "/dev/zero: larger than 4 MB"),
        ((), "Missing argument"),
        (("empty.toml", "--colour"), "No such option: --colour; see segfmu plan --help"),
        (("empty.toml", "-o"), "requires an argument"),
    ):
        assert said in refused(tmp_path, "plan", *words)


def test_wrong_commands_and_values_of_options(tmp_path: Path) -> None:
    assert "did you mean 'plan'" in refused(tmp_path, "plann").lower()
    assert "step must be finite" in refused(tmp_path, "simulate", "m.toml", "--step", "nan")
    assert "--waypoints" in refused(tmp_path, "build", "--waypoints", "1")
    assert "platforms is empty; name some" in refused(tmp_path, "build", "--platforms", "")


def test_places_of_output_are_checked_first(tmp_path: Path) -> None:
    files(tmp_path)
    (tmp_path / "dir" / "plan.csv").mkdir(parents=True)
    (tmp_path / "dir" / "results.json").mkdir()
    (tmp_path / "afile").touch()
    # a scenario that cannot be run: what is said of the output comes before
    for words, said in (
        (("plan", "mission.toml", "-o", "dir"), "dir/plan.csv: cannot be written: Is a directory"),
        (("validate", "nowhere.toml", "-o", "afile"), "output afile: this is no folder, but a"),
        (("validate", "nowhere.toml", "-o", "dir"), "dir/results.json: cannot be written"),
        (("validate", "nowhere.toml", "--junit", "dir"), "dir: cannot be written: Is a directory"),
        (("validate", "nowhere.toml", "--junit", "afile/x"), "afile/x: cannot be written: Not a"),
        (("validate", "nowhere.toml", "-o", "new", "--junit", "new/x"), "nowhere.toml: cannot be "),
    ):
        assert said in refused(tmp_path, *words)
    assert not (tmp_path / "new").exists()


def test_tables_without_rows_are_refused_in_one_line(tmp_path: Path) -> None:
    (tmp_path / "empty.csv").touch()
    (tmp_path / "names.csv").write_text("time,a\n", encoding="utf-8")
    (tmp_path / "good.csv").write_text("time,a\n0,1\n1,2\n", encoding="utf-8")
    line = refused(tmp_path, "compare", "empty.csv", "good.csv")
    assert "empty.csv: empty; the first line names the columns" in line
    line = refused(tmp_path, "compare", "names.csv", "good.csv")
    assert "names.csv: there is no row of numbers" in line


def test_tables_of_different_units_are_not_compared(tmp_path: Path) -> None:
    """Signals of other FMUs, whose units only the headers tell: 1 mV agreed with 1 V."""
    for unit in ("V", "mV"):
        (tmp_path / f"{unit}.csv").write_text(f"time,a [{unit}]\n0,1\n1,2\n", encoding="utf-8")
    (tmp_path / "more.csv").write_text("time,a\n0,1\n1,2.5\n", encoding="utf-8")
    line = refused(tmp_path, "compare", "mV.csv", "V.csv")
    assert "a is in mV in mV.csv and in V in V.csv; give both in one unit" in line
    done = segfmu("compare", "more.csv", "V.csv", cwd=tmp_path)
    assert "by 0.5 V (at most by 0.5 V)" in done.stdout and done.returncode == 1
