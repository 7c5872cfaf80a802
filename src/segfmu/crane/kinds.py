"""Every crane that there is a model of: a further one is added here."""

from __future__ import annotations

from segfmu.crane.hook import HookCrane
from segfmu.crane.parameters import Crane

AnyCrane = Crane | HookCrane
