"""Files that are written: they appear complete, where links lead, and devices stay devices."""

from __future__ import annotations

import os
import stat
import threading
from pathlib import Path

import pytest

from segfmu.cosim.result import replacing
from segfmu.errors import InputError


def write(path: Path, text: str) -> None:
    with replacing(path) as temporary:
        temporary.write_text(text)


def test_a_link_stays_one_and_its_file_is_replaced(tmp_path: Path) -> None:
    (tmp_path / "far").mkdir()
    target, link = tmp_path / "far" / "page.html", tmp_path / "page.html"
    link.symlink_to(target)
    for text in ("new", "newer"):
        write(link, text)
        assert link.is_symlink() and target.read_text() == text
    assert sorted(os.listdir(tmp_path)) == ["far", "page.html"]
    assert os.listdir(tmp_path / "far") == ["page.html"]


def test_a_pipe_gets_the_bytes_and_stays_one(tmp_path: Path) -> None:
    pipe, heard = tmp_path / "pipe", list[str]()
    os.mkfifo(pipe)
    reader = threading.Thread(target=lambda: heard.append(pipe.read_text()), daemon=True)
    reader.start()
    write(pipe, "all of it")
    reader.join(10.0)
    assert heard == ["all of it"] and stat.S_ISFIFO(pipe.stat().st_mode)


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="a full device is Linux'")
def test_a_device_is_not_replaced_and_its_error_is_told(tmp_path: Path) -> None:
    # a link: if it were replaced, that would be the link alone
    device = tmp_path / "full"
    device.symlink_to("/dev/full")
    with pytest.raises(InputError, match="full: cannot be written: No space left on device"):
        write(device, "text")
    assert device.is_symlink() and stat.S_ISCHR(device.stat().st_mode)
