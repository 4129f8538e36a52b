# SPDX-License-Identifier: MIT
"""What a frame costs under any setting of its knobs, from counts of some settings.

A frame is made of parts that ask some of the knobs each, so its cost is a sum of one function a part. Counted are the
standard setting and all combinations of the knobs of each part, with the others at their standard; then the effect of
some knobs together, beyond the effects of fewer of them, is 0 unless a part asks them all.
"""
import itertools
from typing import Iterable

from measure import Failure

Setting = dict[str, str]
# Of each frame, as measure.COUNTED names them.
Counts = list[list[int]]


class Sums:
    """Costs of a program's settings. `counted`: counts of each frame, by the setting's text."""

    def __init__(self, scene: dict, counted: dict[str, Counts]):
        self._counted = counted
        self._standard = {knob["name"]: knob["standard"] for knob in scene["knobs"]}
        together: set[frozenset[str]] = set()
        for part in scene["parts"]:
            for size in range(len(part) + 1):
                together.update(frozenset(knobs) for knobs in itertools.combinations(part, size))
        self._together = sorted(together, key=len)
        self._parts = scene["parts"]

    def _partly(self, setting: Setting, knobs: Iterable[str]) -> Setting:
        """The setting with all other knobs at their standard."""
        return {knob: setting[knob] if knob in knobs else usual for knob, usual in self._standard.items()}

    def parts_of(self, setting: Setting) -> list[Setting]:
        """The counted settings that a setting is a sum of, one a part."""
        return [self._partly(setting, part) for part in self._parts]

    def of(self, setting: Setting) -> Counts:
        """Counts of each frame: the sum of the effects of knobs together, each the counts under these knobs less the
        effects of fewer of them."""
        effects: dict[frozenset[str], Counts] = {}
        for knobs in self._together:
            counts = self._counted[_text(self._partly(setting, knobs))]
            for fewer, effect in effects.items():
                if fewer < knobs:
                    counts = [[a - b for a, b in zip(*pair)] for pair in zip(counts, effect)]
            effects[knobs] = counts
        return [[sum(numbers) for numbers in zip(*frames)] for frames in zip(*effects.values())]

    def check(self, setting: Setting, name: str) -> None:
        """Fails if a setting that was counted isn't the sum of its parts."""
        for counted, summed in zip(self._counted[_text(setting)], self.of(setting)):
            if counted != summed:
                raise Failure(f"{name}: counted {counted}, the sum of its parts is {summed}: a part of the program asks "
                              "knobs that its scene doesn't name together")


def _text(setting: Setting) -> str:
    from frames import setting_text  # here, for frames uses this

    return setting_text(setting)
