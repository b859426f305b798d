"""The statements of the methods with which the vehicle acts on failsafes that are up."""

from codegen.model.program import Program


def check_statements(program: Program, *, recovers: bool, sets_status: bool) -> tuple[str, ...]:
    """The body of _check(failsafes), which looks at some of them; ``sets_status``: the vehicle tells that one is up."""
    status = ["self._set_status()"] if sets_status else []
    if program.priority:
        return (
            '"""Look at them; of what all that are up ask for, the most severe holds, and is done once."""',
            "now_ms = ticks_ms()",
            "for failsafe in failsafes:",
            "    if failsafe.update(now_ms):",
            "        self._asked = None",
            "if self._asked != self.parameters.changes:",
            "    self._asked = self.parameters.changes",
            *(f"    {line}" for line in status),
            "    self._settle(self._most_severe())",
        )
    return (
        '"""Do what the highest level asks for that is reached just now, unless a higher one was reached before."""',
        "now_ms = ticks_ms()",
        "for failsafe in failsafes:",
        f"    if failsafe.update(now_ms){' > 0' if recovers else ''}:",
        "        self._note_reached(failsafe)",
        *(f"{line}  # a failsafe may have ended" for line in status if recovers),
        "if self._reached is not None:",
        "    self._follow_reached(failsafes)",
    )


def choosing_statements(program: Program, everything: str, *, recovers: bool, sets_status: bool) -> tuple[str, ...]:
    """The method that says which failsafe, or which action, it is."""
    if program.priority:
        values = ", ".join(str(action.value) for action in program.priority)
        return (
            "def _settle(self, action):",
            "    if action != self._in_force:",
            "        self._in_force = action",
            "        self._act(action)",
            "",
            "def _most_severe(self):",
            f"    for action in ({values}{',' if len(program.priority) == 1 else ''}):",
            "        if self._is_asked_for(action):",
            "            return action",
            "    return 0",
            "",
            "def _is_asked_for(self, action):",
            f"    failsafes = {everything}",
            "    for index in range(len(failsafes)):",
            "        if failsafes[index].level and failsafes[index].action() == action:",
            "            return True",
            "    return False",
        )
    return (
        "def _note_reached(self, failsafe):",
        "    if self._reached is None or failsafe.level > self._reached.level:",
        "        self._reached = failsafe",
        "",
        "def _follow_reached(self, failsafes):",
        "    acting = self._reached",
        "    self._reached = None",
        "    if acting.level >= self._highest(failsafes):",
        *(["        self._set_status()"] if sets_status and not recovers else []),
        "        self._act(acting.action())",
    )
