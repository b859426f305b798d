# Generated from templates/tests/program/failsafe_bench.py: do not edit.
# Inputs: 47ac3a242815d114
"""A failsafe with thresholds that are two levels, whatever the defaults of the specification are."""

from program_bench import Watch, needs
from program_facts import FAILSAFES, PARAMETERS

LOW, CRITICAL = 1, 2
TIMER = 10


def parameter_of(attribute):
    return next(each for each in PARAMETERS if each["attribute"] == attribute)


def _thresholds():
    """Return thresholds of low and critical in stored steps: the defaults, where these are two levels."""
    needs(FAILSAFES, "a failsafe")
    facts = FAILSAFES[0]
    low = parameter_of(facts["low"])["default"] * facts["low_scale"]
    critical = parameter_of(facts["critical"])["default"] * facts["critical_scale"]
    if 0 < critical < low - 4:
        return low, critical
    scale = facts["low_scale"] * facts["critical_scale"]
    return 40 * scale, 20 * scale


def new_watch(timer=TIMER, at_us=0):
    low, critical = _thresholds()
    watch = Watch(low, critical, timer, at_us)
    watch.low, watch.critical, watch.between, watch.deep = low, critical, (low + critical) // 2, critical - 1
    return watch


def armed_watch(timer=TIMER, at_us=0):
    watch = new_watch(timer, at_us)
    watch.arm()
    return watch
