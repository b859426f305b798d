"""The checks of behaviour.py in the generated suite: those of a system, and the criterion that asks for each."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from codegen.model.code.clock import CLOCK
from codegen.model.price import default_rate, on_by_default
from codegen.model.system import System
from codegen.targets.firmware.messages.streams import StreamView, stream_views
from codegen.targets.firmware.readings.board import ReaderView, plain_readers
from codegen.targets.suite.facts.components import ComponentFacts, component_facts
from codegen.targets.suite.facts.readings import ReadingFacts, reading_facts
from codegen.targets.suite.withheld import WithheldMessage, withheld_messages


class BehaviourCheck(NamedTuple):
    """A function of behaviour.py; ``criterion`` is empty where nothing is cited."""

    criterion: str
    name: str

    @property
    def identifier(self) -> str:
        """Return what the suite calls it: ``battery_mean-FR-00066.2``."""
        return f"{self.name}-{self.criterion}" if self.criterion else self.name


class SharedMessage(NamedTuple):
    """A message of several tables: its frames in 40 s at the default rates, and in one turn of all of them."""

    identifier: str
    id: int
    in_40_s: int
    turn: int


def shared_messages(system: System) -> tuple[SharedMessage, ...]:
    """The messages of which there are several tables, in the order of their ids."""
    sent: dict[str, list[tuple[int, int]]] = {}
    for message in system.messages:
        tables = system.tables(message.wire.name)
        if len(tables) > 1:
            frames = message.pages * sum(on_by_default(message.component, system))
            sent.setdefault(message.wire.name, []).append((round(40 * default_rate(message)) * frames, frames))
    return tuple(
        SharedMessage(
            name.lower(),
            system.tables(name)[0].wire.id,
            sum(all_of for all_of, _ in each),
            sum(turn for _, turn in each),
        )
        for name, each in sent.items()
    )


def behaviour_checks(
    readers: Sequence[ReaderView],
    readings: Sequence[ReadingFacts],
    streams: Sequence[StreamView],
    components: Sequence[ComponentFacts],
    shared: Sequence[SharedMessage],
    withheld: Sequence[WithheldMessage],
) -> tuple[BehaviourCheck, ...]:
    """The checks in the order in which they run."""
    measured = [component for component in components if component.measured]
    checks = [check for pair in zip(readers, measured, strict=True) for check in _of_reading(*pair)]
    checks += [check for reading in readings for check in _of_single(reading)]
    checks += [BehaviourCheck(stream.citation, f"{stream.identifier}_stream_keeps_its_rate") for stream in streams]
    checks += [BehaviourCheck("", f"{message.identifier}_tables_keep_their_rates") for message in shared]
    checks += [
        BehaviourCheck(message.criterion, f"{message.identifier}_is_withheld_while_unknown") for message in withheld
    ]
    checks.append(BehaviourCheck("", "everything_starts_as_specified"))
    checks.append(BehaviourCheck("", "every_value_allocates_nothing"))
    if any(quantity.beyond for component in components for quantity in component.quantities):
        checks.append(BehaviourCheck("", "what_is_limited_is_counted_and_told_once"))
        checks.append(BehaviourCheck("", "all_that_is_limited_is_told"))
    for component in components:
        for quantity in component.quantities:
            if quantity.stale_after_ms is not None:
                name = f"{component.name}_{quantity.name}_is_forgotten"
                checks.append(BehaviourCheck(quantity.stale_criterion, name))
            name = f"{component.name}_{quantity.name}"
            if quantity.elements is not None and not quantity.is_object:
                checks.append(BehaviourCheck("", f"{name}_allocate_nothing"))
            if quantity.elements is not None:
                check = "as_a_row" if quantity.row else "in_their_unit"
                checks.append(BehaviourCheck(quantity.citation, f"{name}_{check}"))
            if quantity.is_object:
                checks.append(BehaviourCheck("", f"{component.name}_{quantity.name}_is_sent_without_allocating"))
    if any(component.name == CLOCK for component in components):
        checks.append(BehaviourCheck("", "clocks_are_right_for_sixty_days"))
    general = ("late_pass_sends_no_burst", "parameters_start_with_their_defaults", "parameters_keep_their_limits")
    return (*checks, *(BehaviourCheck("", name) for name in general))


def _of_reading(reader: ReaderView, component: ComponentFacts) -> Iterator[BehaviourCheck]:
    measured, together = component.measured, component.set_together
    assert measured is not None
    found = [
        (reader.cited["samples"], "mean", True),
        (reader.cited["reference"], "full_scale", True),
        (reader.cited["failure"], "failed_reading_keeps_the_last_value", True),
        (measured.cited["invalid_after"], "repeated_failures_make_it_unknown", bool(measured.invalid_after)),
        (reader.cited["absence"], "absent_converter_is_no_reason_to_stop", True),
        (component.cited["robustness"], "broken_board_does_not_raise", True),
        (reader.cited["read_limit"], "late_reading_keeps_the_last_value", bool(reader.read_limit_us)),
        ("", "readings_are_timed", True),
        (measured.cited["stale_after"], "old_reading_is_unknown", measured.stale_after_ms is not None),
        (measured.cited["set_stale_after"], "what_code_sets_counts_for_a_while", measured.represented is not None),
        (together.citation if together else "", "what_code_sets_beside_is_forgotten", together is not None),
        (measured.cited["warn_above"], "high_value_warns_now_and_then", measured.warns),
        (measured.citation, "formula_of_people_agrees", True),
        (measured.cited["calibration"], "calibration", True),
        (component.cited["scenarios"], "scenarios", True),
        (component.cited["steady"], "steady_cycle_allocates_nothing", True),
    ]
    found += [(extreme.citation, f"{extreme.name}_is_found", True) for extreme in component.extremes]
    for criterion, name, is_there in found:
        if is_there:
            yield BehaviourCheck(criterion, f"{reader.component}_{name}")


def _of_single(reading: ReadingFacts) -> Iterator[BehaviourCheck]:
    cited = reading.cited
    found = [
        (cited["failure"], "fails_alone", True),
        (cited["stale_after"], "ages_alone", reading.stale_after_ms is not None),
        (cited["robustness"], "raises_nothing", True),
        (cited["when"], "is_left_alone_where_it_is_off", bool(reading.off)),
        (cited["pin"], "is_what_its_instance_has", bool(reading.apart)),
        (cited["steady"], "allocates_nothing", True),
        (reading.lasting.citation if reading.lasting else "", "lasts_at_the_mean", reading.lasting is not None),
        (next((each.citation for each in reading.sums), ""), "is_summed_exactly", bool(reading.sums)),
    ]
    for criterion, name, is_there in found:
        if is_there:
            yield BehaviourCheck(criterion, f"{reading.own.name}_{name}")


def checks_of_behaviour(system: System) -> tuple[BehaviourCheck, ...]:
    """The same for a system of which no view has been made."""
    components, shared, withheld = component_facts(system), shared_messages(system), withheld_messages(system)
    return behaviour_checks(
        plain_readers(system), reading_facts(system), stream_views(system), components, shared, withheld
    )
