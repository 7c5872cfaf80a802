"""Rare failures of an FMU whose output has a probability in closed form, told by campaigns.

`search = "rare"` with 5,000 runs at 1e-4 and at 1e-3, the latter beside plain random runs. Margins
come from runs of planner, crane and this FMU, as those of any campaign.
"""

from __future__ import annotations

from pathlib import Path
from statistics import NormalDist
from tempfile import TemporaryDirectory

from pythonfmu.builder import FmuBuilder

from benchmarks.report import Part, Record, Section, Settings
from benchmarks.sum_of_normals import MEAN, NAMES
from segfmu.validation.campaigns.campaign import load_campaign
from segfmu.validation.campaigns.probability import Probability
from segfmu.validation.campaigns.run import run_campaign

HERE = Path(__file__).parent
MISSION = HERE.parent / "models" / "inteco.toml"
TITLE = "rare failures of an FMU with a closed form, told by campaigns"
RARE, LESS_RARE = 1e-4, 1e-3
RUNS, PLAIN = 5000, 20_000
SCENARIO = """
name = "sum of normals"
mission = "{mission}"
step = 0.1

[[fmus]]
name = "Sum"
path = "SumOfNormals.fmu"
values = {{ {values} }}

[[criteria]]
name = "below the bound"
signal = "y"
bound = {bound!r}
"""
CAMPAIGN = """
name = "rare"
scenarios = ["scenario.toml"]
{search}

[sampling]
kind = "random"
runs = {runs}
seed = {seed}
"""
FACTOR = """
[[factors]]
name = "{name}"
key = "fmus.Sum.values.{name}"
range = [-1.0, 1.0]
"""


def measure(settings: Settings) -> Part:
    """What is told of both probabilities, over the true ones."""
    quick = settings.samples <= 100
    runs, plain = (500, 500) if quick else (RUNS, PLAIN)
    seeds = range(1, 2 if quick else 3)
    records = [told(RARE, runs, seed, rare=True) for seed in seeds]
    records += [told(LESS_RARE, runs, seed, rare=True) for seed in seeds]
    records.append(told(LESS_RARE, plain, 1, rare=False))
    return Part(TITLE, (Section("told by runs", records),), (
        "true: of a sum of normal numbers; plain: random runs, interval of Clopper and Pearson",
    ))


def told(probability: float, runs: int, seed: int, *, rare: bool) -> Record:
    """What a campaign tells of a failure with this probability."""
    with TemporaryDirectory() as folder, TemporaryDirectory() as output:
        task = load_campaign(_written(Path(folder), probability, runs, seed, rare))
        result = run_campaign(task, Path(output))
        (summary,) = result.summaries
        found = summary.fails
        assert found is not None
        low, high = found.interval
        share = (
            found.failed / found.draws if isinstance(found, Probability) else found.probability
        )
        return {
            "true": probability, "by": "rare" if rare else "plain", "seed": seed,
            "runs": result.table.num_rows, "told": share, "low": low, "high": high,
            "over the true one": share / probability,
        }


def _written(folder: Path, probability: float, runs: int, seed: int, rare: bool) -> Path:
    """Files of a campaign; returns that of the campaign itself."""
    FmuBuilder.build_FMU(HERE / "sum_of_normals.py", dest=folder)
    (folder / "scenario.toml").write_text(SCENARIO.format(
        mission=MISSION.as_posix(), bound=NormalDist(MEAN).inv_cdf(1.0 - probability),
        values=", ".join(f"{name} = 0.0" for name in NAMES),
    ), encoding="utf-8")
    text = CAMPAIGN.format(search='search = "rare"' if rare else "", runs=runs, seed=seed)
    text += "".join(FACTOR.format(name=name) for name in NAMES)
    path = folder / "campaign.toml"
    path.write_text(text, encoding="utf-8")
    return path
