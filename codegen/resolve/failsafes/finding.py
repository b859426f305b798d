"""The rule that a failsafe breaks, whatever is wrong with it."""

from codegen.diagnostics import Rule

BAD_FAILSAFE = Rule(
    "bad-failsafe",
    "A failsafe watches one number of the state, or waits for ground stations. Its levels, the mildest first, "
    "each say below, above or unknown; thresholds are parameters or amounts in whole stored units of the "
    "quantity, times are at most four hours in whole milliseconds, there are 30 conditions at most, and "
    "hysteresis and over are for failsafes with latch: false. Every value of an action's parameter but 0 is one "
    "of the actions.",
    remedy="write watches and levels, each with one of below, above and unknown",
)
