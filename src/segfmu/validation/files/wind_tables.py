"""Tables of a crane file: wind on the load."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from segfmu.validation.files.keys import (
    AXES,
    Frequency,
    Key,
    NotNegative,
    NotNegativeTriple,
    Number,
    Positive,
    Seed,
    Table,
    Triple,
)


class GustTable(Table):
    """One gust."""

    start: Annotated[Number, Key("start", "s", ("wind.gust.start",))] = 0.0
    duration: Annotated[Positive, Key("duration", "s", ("wind.gust.duration",))]
    shape: Annotated[
        Literal["cosine", "sine"],
        Key("1 - cosine, or half a sine", "", ("wind.gust.shape",)),
    ] = "cosine"
    force: Annotated[
        Triple | None,
        Key("peak of the force", "N", tuple(f"wind.gust.force.{a}" for a in AXES), "none",
            parts=AXES),
    ] = None
    speed: Annotated[
        Triple | None,
        Key("peak of the air's speed", "m/s", tuple(f"wind.gust.speed.{a}" for a in AXES), "none",
            parts=AXES),
    ] = None


class WindNoiseTable(Table):
    """Random wind."""

    deviation: Annotated[
        NotNegativeTriple,
        Key("standard deviations", "N",
            tuple(f"wind.noise.deviation.{a}" for a in AXES), parts=AXES),
    ]
    bandwidth: Annotated[
        Frequency, Key("greatest frequency", "Hz", ("wind.noise.bandwidth",))
    ] = 1.0
    seed: Annotated[Seed, Key("of the noise", "", ("wind.noise.seed",))] = 0


class TurbulenceTable(Table):
    """Turbulence of the air, with Davenport's spectrum; it needs a mean speed."""

    deviation: Annotated[
        NotNegativeTriple,
        Key("standard deviations", "m/s", tuple(f"wind.turbulence.deviation.{a}" for a in AXES),
            parts=AXES),
    ]
    length: Annotated[
        Annotated[Number, Field(ge=1e-3)],
        Key("length scale", "m", ("wind.turbulence.length",)),
    ] = 1200.0
    bandwidth: Annotated[
        Frequency, Key("greatest frequency", "Hz", ("wind.turbulence.bandwidth",))
    ] = 1.0
    seed: Annotated[Seed, Key("of the turbulence", "", ("wind.turbulence.seed",))] = 0


class WindTable(Table):
    """Wind on the load: forces, and the speed of the air, which acts on its drag area."""

    constant: Annotated[
        Triple | None,
        Key("constant force", "N",
            tuple(f"wind.constant.{a}" for a in AXES), "none", parts=AXES),
    ] = None
    gust: Annotated[GustTable | None, Key("one gust", default="none")] = None
    noise: Annotated[WindNoiseTable | None, Key("random wind", default="none")] = None
    speed: Annotated[
        Triple | None,
        Key("mean speed of the air", "m/s", tuple(f"wind.speed.{a}" for a in AXES), "none",
            parts=AXES),
    ] = None
    turbulence: Annotated[
        TurbulenceTable | None, Key("turbulence of the air", default="none")
    ] = None
    air_density: Annotated[
        NotNegative | None, Key("density of the air", "kg/m3", ("wind.air_density",))
    ] = None
