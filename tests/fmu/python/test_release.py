"""Processes that have loaded an FMU of the Python backend end without a crash."""

from __future__ import annotations

import os
import subprocess
import sys
import sysconfig
from pathlib import Path

import pytest
from fmpy import extract, read_model_description

from segfmu.fmu.native import archive as native
from tests.campaign import SOAK

HERE = Path(__file__).parent
HEADERS = Path(native.__file__).parent / "c" / "fmi"


def python(text: str, *arguments: object) -> str:
    """What a program prints that has to end well."""
    done = subprocess.run(
        [sys.executable, "-c", text, *map(str, arguments)], capture_output=True, text=True,
        check=False, timeout=120,
    )
    assert (done.returncode, done.stderr) == (0, "")
    return done.stdout


@pytest.fixture(scope="module")
def compiled(tmp_path_factory: pytest.TempPathFactory):
    """A function that compiles a C source, with options."""
    folder = tmp_path_factory.mktemp("compiled")

    def build(name: str, source: Path, *options: str) -> Path:
        command = ["cc", "-std=gnu99", f"-I{HEADERS}", *options, str(source), "-o",
                   str(folder / name), "-ldl"]
        subprocess.run(command, check=True)
        return folder / name

    return build


@pytest.mark.skipif(sys.platform != "linux", reason="what is mended is on Linux alone")
def test_a_loaded_library_is_told_before_the_process_ends(compiled, tmp_path: Path) -> None:
    source = tmp_path / "library.c"
    source.write_text(
        '#include <unistd.h>\n'
        'void finalizePythonInterpreter(void) { write(1, "finalised\\n", 10); }\n',
        encoding="utf-8",
    )
    library = compiled("library.so", source, "-shared", "-fPIC")
    text = (
        "import ctypes, sys\nfrom pathlib import Path\n"
        "from segfmu.fmu.python.release import release_at_exit\n"
        "if sys.argv[2] == 'loaded': ctypes.CDLL(sys.argv[1])\n"
        "release_at_exit(Path(sys.argv[1]))\nrelease_at_exit(Path(sys.argv[1]))\n"
        "print('ends', flush=True)"
    )
    assert python(text, library, "loaded") == "ends\nfinalised\n"
    # one that nobody has loaded is left alone, and so is one that is not there
    assert python(text, library, "left") == "ends\n"
    assert python(text, tmp_path / "none.so", "left") == "ends\n"


@pytest.mark.skipif(sys.platform != "linux", reason="what is mended is on Linux alone")
def test_every_instance_has_its_library_told(fmus) -> None:
    text = (
        "import sys\nfrom pathlib import Path\nfrom segfmu.cosim.load import load\n"
        "from segfmu.fmu.python import release\n"
        "for path in sys.argv[1:]:\n"
        "    for _ in range(2):\n"
        "        with load(Path(path)): pass\n"
        "print(*sorted(p.name for p in release._held))"
    )
    names = "GantryCrane.so GantryCrane.so GantryFeedforward.so GantryFeedforward.so\n"
    assert python(text, *fmus) == names


def test_slaves_do_not_load_what_cannot_be_finalised() -> None:
    # SciPy's _uarray frees its module's state twice when an embedded interpreter ends
    text = (
        "import sys, segfmu.fmu.gantry_crane.slave, segfmu.fmu.gantry_feedforward.slave\n"
        "from segfmu import Crane\n"
        "from segfmu.crane.feedback import design\n"
        "design(Crane(1.0, 1.0, 1.0), sample_time=0.01, shortest=0.2, longest=0.9)\n"
        "print('scipy.linalg' in sys.modules, 'scipy._lib._uarray' in sys.modules)"
    )
    assert python(text) == "True False\n"


@pytest.mark.skipif(
    sys.platform != "linux" or not sysconfig.get_config_var("Py_ENABLE_SHARED"),
    reason="needs Linux and a Python with libpython as a shared library",
)
@pytest.mark.soak
@pytest.mark.parametrize("index", [0, 1])
def test_an_importer_without_python_ends_well(compiled, fmus, index: int, tmp_path: Path) -> None:
    importer = compiled("embedding", HERE / "c" / "embedding.c")
    extract(str(fmus[index]), unzipdir=str(tmp_path))
    found = read_model_description(str(fmus[index]))
    libpython = Path(sysconfig.get_config_var("LIBDIR")) / sysconfig.get_config_var("INSTSONAME")
    environment = os.environ | {
        "PYTHONHOME": sys.base_prefix, "PYTHONPATH": os.pathsep.join(p for p in sys.path if p),
    }
    for _ in range(4 if SOAK else 2):
        done = subprocess.run(
            [importer, libpython, tmp_path / "binaries" / "linux64" / f"{found.modelName}.so",
             found.guid, (tmp_path / "resources").as_uri()],
            env=environment, capture_output=True, text=True, check=False, timeout=120,
        )
        assert (done.returncode, done.stdout) == (0, "done\n"), done.stderr
