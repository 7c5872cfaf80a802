"""Binaries: made once, from a cache, and the same wherever they are made."""

from __future__ import annotations

import ctypes
import re
import shutil
import struct
import subprocess
import time
import zipfile
from dataclasses import replace
from pathlib import Path

import pytest

from segfmu.errors import BuildError
from segfmu.fmu.gantry_crane import interface as gantry_crane
from segfmu.fmu.gantry_feedforward import interface as gantry_feedforward
from segfmu.fmu.native import archive, binaries, compilers
from segfmu.fmu.standard.spec import started
from tests.campaign import soaked
from tests.compiler import CC, compiled, needs_cc, needs_native

SPECS = (gantry_feedforward.native_spec(), gantry_crane.native_spec())
SMALL = {"fmu.c": b'#include "part.h"\n#ifdef _WIN32\n__declspec(dllexport)\n#else\n'
         b'__attribute__((visibility("default")))\n#endif\nint some(void) { return PART; }\n',
         "part.h": b"#define PART 7\n"}
needs_zig = pytest.mark.skipif(
    not compilers._has_zig(), reason="needs ziglang, of the extra segfmu[platforms]"
)


@pytest.fixture
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty cache."""
    monkeypatch.setenv("SEGFMU_CACHE", str(tmp_path / "cache"))
    return tmp_path / "cache"


def test_no_source_depends_on_a_mission(tmp_path: Path, native_fmus) -> None:
    moved = gantry_feedforward.spec(40)
    values = {"waypoint.count": 40, "crane.payload_mass": 40e3, "planner.shape": "smoothstep"}
    spec = gantry_feedforward.native_spec(started(moved, values))
    entries = archive.entries(spec, 2, ())
    with zipfile.ZipFile(native_fmus[2][0]) as usual:
        for name in usual.namelist():
            if name.startswith("sources/"):
                assert usual.read(name) == entries[name], name
        assert usual.read("resources/start.bin") != entries["resources/start.bin"]


@needs_native
def test_a_library_is_compiled_once(cache: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    platform = compilers.host()
    assert platform is not None
    first = binaries.binary("Some", SMALL, platform)
    kept = [p for p in cache.iterdir() if not p.name.startswith(".")]
    assert len(kept) == 1 and kept[0].name.startswith(f"Some-{platform}-")
    with monkeypatch.context() as patch:
        patch.setattr(compilers.Compiler, "build", None)
        assert binaries.binary("Some", SMALL, platform) == first
    changed = binaries.binary("Some", SMALL | {"part.h": b"#define PART 8\n"}, platform)
    assert changed != first and len(list(cache.iterdir())) == 2


KERNELS = dict.fromkeys(binaries.SHARED, b"") | {"core.c": b"int kernel(void) { return 7; }\n"}
OWN = b"""
#ifdef SEGFMU_KERNELS_APART
int kernel(void);
#else
#include "core.c"
#endif
__attribute__((visibility("default"))) int %s(void) { return kernel(); }
"""


@needs_native
def test_kernels_of_all_models_are_compiled_once(
    cache: Path, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    platform = compilers.host()
    assert platform is not None
    compiled, compile = [], compilers.Compiler.compile

    def counting(self: compilers.Compiler, source: Path, *options: str) -> Path:
        compiled.append((source.name, options))
        return compile(self, source, *options)

    monkeypatch.setattr(compilers.Compiler, "compile", counting)
    chosen = compilers.compiler(platform)
    for name in ("one", "another"):
        texts = KERNELS | {"fmu.c": OWN % name.encode()}
        library = tmp_path / f"{name}.library"
        library.write_bytes(binaries.binary(name, texts, platform, compiler=chosen))
        found = ctypes.CDLL(str(library))
        assert found[name]() == 7
        # as in a library of one unit
        assert not hasattr(found, "kernel")
    apart = ("fmu.c", ("-DSEGFMU_KERNELS_APART",))
    assert compiled == [("core.c", ()), apart, apart]


@needs_zig
def test_both_fmus_of_a_page_share_their_kernels(
    cache: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    compiled = []

    def compile(_: compilers.Compiler, source: Path, *options: str) -> Path:
        compiled.append(source.name)
        return source

    monkeypatch.setattr(compilers.Compiler, "compile", compile)
    monkeypatch.setattr(compilers.Compiler, "link", lambda _, target, first, *__: first)
    for name in ("one", "another"):
        texts = KERNELS | {"fmu.c": OWN % name.encode()}
        assert binaries.binary(name, texts, compilers.BROWSER.name) == texts["fmu.c"]
    assert compiled == ["core.c", "fmu.c", "fmu.c"]


@needs_native
def test_the_cache_removes_old_libraries_alone(
    cache: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    platform = compilers.host()
    assert platform is not None
    monkeypatch.setattr(binaries, "KEPT", 2)
    cache.mkdir()
    for i in range(3):
        (cache / f"notes_{i}.txt").write_text("of somebody else")
    for i in range(4):
        binaries.binary("Some", SMALL | {"part.h": b"#define PART %d\n" % i}, platform)
    names = sorted(p.name.partition("-")[0] for p in cache.iterdir())
    assert names == ["Some", "Some", "notes_0.txt", "notes_1.txt", "notes_2.txt"]


@needs_native
def test_the_cache_keeps_libraries_that_are_used(
    cache: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    platform = compilers.host()
    assert platform is not None
    monkeypatch.setattr(binaries, "KEPT", 2)
    for name in ("Used", "Left", "Used", "New"):
        binaries.binary(name, SMALL, platform)
    assert sorted(p.name.partition("-")[0] for p in cache.iterdir()) == ["New", "Used"]


@needs_native
def test_a_damaged_entry_is_made_again(cache: Path) -> None:
    platform = compilers.host()
    assert platform is not None
    first = binaries.binary("Some", SMALL, platform)
    (entry,) = cache.iterdir()
    for damaged in (b"", entry.read_bytes()[:-1], b"x" * 2000):
        entry.write_bytes(damaged)
        assert binaries.binary("Some", SMALL, platform) == first


@needs_native
def test_a_cache_that_cannot_be_written_is_done_without(cache: Path) -> None:
    platform = compilers.host()
    assert platform is not None
    cache.write_text("a file where the folder would be")
    assert binaries.binary("Some", SMALL, platform)


def test_without_compiler_the_way_out_is_told(cache: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(compilers, "_own", lambda: None)
    monkeypatch.setattr(compilers, "_has_zig", lambda: False)
    with pytest.raises(BuildError, match="no C compiler for x86_64-windows; install the extra"):
        binaries.binary("Some", SMALL, "x86_64-windows")


# what zig makes of C's library for a platform takes it up to three minutes, and is for soaks
BARE = ("-nostdlib", "-Wl,-e,some")
LINKED = [BARE, *soaked(())]


def built(folder: Path, name: str, link: tuple[str, ...]) -> bytes:
    """The small library, built in a folder with options for the linker."""
    folder.mkdir(parents=True, exist_ok=True)
    usual = compilers.compiler(name)
    platform = replace(usual.platform, link=(*usual.platform.link, *link))
    for source, text in SMALL.items():
        (folder / source).write_bytes(text)
    library = folder / f"Some{platform.suffix}"
    replace(usual, platform=platform).build(folder / "fmu.c", library)
    return library.read_bytes()


@needs_zig
@pytest.mark.parametrize("link", LINKED)
@pytest.mark.parametrize("name", compilers.PLATFORMS)
def test_the_folder_of_a_build_leaves_no_trace(
    name: str, link: tuple[str, ...], tmp_path: Path
) -> None:
    one = built(tmp_path / "one", name, link)
    if name.endswith("windows"):
        # its linker tells the second at which it linked
        time.sleep(1.0)
    assert built(tmp_path / "another" / "longer" / "place", name, link) == one


@needs_zig
@pytest.mark.parametrize("link", LINKED)
@pytest.mark.parametrize("name", ["x86_64-darwin", "aarch64-darwin"])
def test_macos_binaries_run_from_macos_11_on(
    name: str, link: tuple[str, ...], tmp_path: Path
) -> None:
    content = built(tmp_path, name, link)
    commands, place, asked = struct.unpack_from("<I", content, 16)[0], 32, []
    for _ in range(commands):
        command, size = struct.unpack_from("<II", content, place)
        # LC_BUILD_VERSION of Apple's mach-o/loader.h: platform, then the least system
        if command == 0x32:
            asked.append(struct.unpack_from("<I", content, place + 12)[0] >> 16)
        place += size
    assert asked == [11]


@needs_native
def test_linux_binaries_run_on_old_systems(native_fmus, tmp_path: Path) -> None:
    platform, tool = compilers.host(), shutil.which("objdump")
    if platform is None or not platform.endswith("linux") or tool is None:
        pytest.skip("needs Linux and objdump")
    for fmi in (2, 3):
        for path in native_fmus[fmi]:
            place = compilers.PLATFORMS[platform].folder if fmi == 2 else platform
            with zipfile.ZipFile(path) as fmu:
                library = fmu.extract(f"binaries/{place}/{path.stem}.so", tmp_path)
            told = subprocess.run([tool, "-T", library], capture_output=True, text=True, check=True)
            versions = re.findall(r"GLIBC_([\d.]+)", told.stdout)
            asked = {tuple(map(int, v.split("."))) for v in versions}
            assert asked and max(asked) <= (2, 17)


PROGRAM = """
#include <stdio.h>
#include <string.h>
#include <stdarg.h>
#include "fmi2FunctionTypes.h"

#define FMU(name) \\
    fmi2Component name##_fmi2Instantiate(fmi2String, fmi2Type, fmi2String, fmi2String, \\
        const fmi2CallbackFunctions *, fmi2Boolean, fmi2Boolean); \\
    fmi2Status name##_fmi2SetupExperiment(fmi2Component, fmi2Boolean, fmi2Real, fmi2Real, \\
        fmi2Boolean, fmi2Real); \\
    fmi2Status name##_fmi2EnterInitializationMode(fmi2Component); \\
    fmi2Status name##_fmi2ExitInitializationMode(fmi2Component); \\
    fmi2Status name##_fmi2DoStep(fmi2Component, fmi2Real, fmi2Real, fmi2Boolean); \\
    void name##_fmi2FreeInstance(fmi2Component);
FMU(GantryFeedforward)
FMU(GantryCrane)

static void hear(void *environment, fmi2String name, fmi2Status status, fmi2String category,
                 fmi2String message, ...)
{
    printf("%s\\n", message);
}

#define STEP(name, token, resources) do { \\
        fmi2Component c = name##_fmi2Instantiate("one", fmi2CoSimulation, token, resources, \\
                                                 &functions, 0, 0); \\
        if (c == NULL || name##_fmi2SetupExperiment(c, 0, 0.0, 0.0, 0, 0.0) != fmi2OK \\
            || name##_fmi2EnterInitializationMode(c) != fmi2OK \\
            || name##_fmi2ExitInitializationMode(c) != fmi2OK \\
            || name##_fmi2DoStep(c, 0.0, 1e-3, fmi2True) != fmi2OK) return 1; \\
        name##_fmi2FreeInstance(c); \\
    } while (0)

int main(int count, char **words)
{
    fmi2CallbackFunctions functions = {hear, NULL, NULL, NULL, NULL};
    STEP(GantryFeedforward, words[1], words[2]);
    STEP(GantryCrane, words[3], words[4]);
    printf("both stepped\\n");
    return 0;
}
"""


@needs_cc
def test_both_fmus_link_into_one_program(native_fmus, tmp_path: Path) -> None:
    objects, words = [], []
    # the crane compiles in half the time without the kernels that it does not call, which -O0 keeps
    for path, spec, level in zip(native_fmus[2], SPECS, ("-O0", "-Og"), strict=True):
        folder = tmp_path / path.stem
        with zipfile.ZipFile(path) as fmu:
            fmu.extractall(folder)
        objects.append(compiled(
            folder / "fmu.o", ["-std=c99", level, "-Wall", "-Wextra", "-Werror",
                               f"-DFMI2_FUNCTION_PREFIX={path.stem}_", "-c", "fmu.c"],
            folder / "sources",
        ))
        root = (folder / "modelDescription.xml").read_text(encoding="utf-8")
        words += [re.search(r'guid="([^"]+)"', root)[1], str(folder / "resources")]
        assert spec.name == path.stem
    (tmp_path / "main.c").write_text(PROGRAM)
    program = tmp_path / "both"
    subprocess.run(
        [CC, "-std=c99", f"-I{tmp_path / 'GantryCrane' / 'sources'}", tmp_path / "main.c",
         *objects, "-lm", "-o", program],
        check=True,
    )
    done = subprocess.run([program, *words], capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout) == (0, "both stepped\n")


@needs_cc
def test_a_compiler_without_room_names_the_temporary_files(tmp_path: Path, cache: Path) -> None:
    """Not the folder of the archives, in which they are made."""
    cc = compilers.compiler(compilers.host() or "")
    with pytest.raises(BuildError, match="temporary files cannot be written in"):
        binaries.compiled("one", {"a": b"", "a/b": b""}, cc)
