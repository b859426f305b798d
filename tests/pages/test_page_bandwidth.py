"""The numbers on the pages are those of the specification, and each bar is as long as its number says."""

import re
from fractions import Fraction
from types import SimpleNamespace
from typing import Any

import pytest
from lxml import html
from rendered import Program

from codegen.model.price import Range, frame_size, message_price, price
from codegen.model.spec.spec import Generation
from codegen.model.system import PopulatedMessage, System
from codegen.targets.pages.bars import Amount, chart
from codegen.targets.pages.budget import beyond_version_1


def rows_of(page: html.HtmlElement, box: str) -> list[list[str]]:
    """The cells of a table's body, by the label of its box."""
    return [[cell.text_content() for cell in row] for row in page.xpath(f"//div[@aria-label='{box}']//tbody/tr")]


def bars_of(page: html.HtmlElement, name: str) -> dict[str, tuple[str, Fraction, Fraction]]:
    """By label the value and the ends of the bar, in the unit of the chart, of the chart with an id."""
    (section,) = page.xpath(f"//section[@id='{name}']")
    last = Fraction(section.xpath("string(.//div[@class='scale']/span[last()])").split()[0])
    found = {}
    for bar in section.xpath(".//div[starts-with(@class, 'bar ')]"):
        label, value = (
            bar.xpath("string(div[@class='what']/a | div[@class='what']/text())"),
            bar.xpath("string(div[2])"),
        )
        sure = Fraction(bar.xpath("string(.//rect[@class='sure']/@width)"))
        more = Fraction(bar.xpath("string(.//rect[@class='may']/@width)") or 0)
        found[label] = (value, sure * last / 100, (sure + more) * last / 100)
    return found


def ends(text: str) -> tuple[float, float]:
    """``94 to 126`` or ``21``."""
    numbers = [float(number) for number in re.findall(r"-?\d+(?:\.\d+)?", text)]
    return numbers[0], numbers[-1]


def sent(system: System, choice: Generation | None = None) -> list[PopulatedMessage]:
    """Return the streamed messages, worked out from the names in streams.yaml."""
    others = {
        name
        for generations in system.generations
        for name in {*generations.old, *generations.new} - {*generations.names(choice or generations.default)}
    }
    return [message for message in system.messages if message.stream and message.name not in others]


def test_the_table_has_what_each_message_costs(every: list[Program]) -> None:
    for program in every:
        by_name = {message.name: message for message in program.system.messages}
        rows = rows_of(program.page("bandwidth.html"), "The numbers")
        assert {row[1].rstrip(" *") for row in rows} == set(by_name)
        idle = {row[1].rstrip(" *") for row in rows if row[1].endswith("*")}
        streamed = {message.name for message in by_name.values() if message.stream}
        assert streamed - idle == {message.name for message in sent(program.system)}
        for row in rows:
            message = by_name[row[1].rstrip(" *")]
            assert row[2] == " / ".join(dict.fromkeys(str(frame_size(message, i, 2)) for i in range(message.instances)))
            assert row[3] == (str(8 + message.wire.base_length) if message.wire.id <= 255 else "")
            assert row[5] == (str(message_price(message, program.system).whole) if message.stream else "")


def test_the_sum_is_that_of_what_is_sent(every: list[Program]) -> None:
    for program in every:
        prices = [message_price(message, program.system).whole for message in sent(program.system)]
        low, high = sum(each.low for each in prices), sum(each.high for each in prices)
        page = program.page("bandwidth.html")
        foot = page.xpath("string(//tfoot//td[contains(@class, 'number')][1])")
        assert foot == str(Range(Fraction(low), Fraction(high)))
        assert f"{foot} bytes/s" in page.xpath("//dl//dd/text()")
        assert f"{foot} bytes/s" in program.page("index.html").xpath("//dl//dd/text()")


def test_bars_are_as_long_as_their_numbers_say(every: list[Program]) -> None:
    count = 0
    for program in every:
        page = program.page("bandwidth.html")
        for name in page.xpath("//section[@id]/@id"):
            for label, (value, low, high) in bars_of(page, name).items():
                expected = ends(value)
                scale = max(abs(expected[1]), 1.0)
                assert abs(float(low) - expected[0]) <= 0.06 + 0.002 * scale, f"{name}: {label}"
                assert abs(float(high) - expected[1]) <= 0.06 + 0.002 * scale, f"{name}: {label}"
                count += 1
    assert count > 40


def test_streams_take_what_their_messages_take(every: list[Program]) -> None:
    for program in every:
        bars = bars_of(program.page("bandwidth.html"), "streams")
        expected: dict[str, list[Range]] = {}
        for message in sent(program.system):
            assert message.stream
            whole = message_price(message, program.system).whole
            expected.setdefault(message.stream.name, []).append(whole)
        assert {name: bar[0] for name, bar in bars.items()} == {
            name: str(Range(Fraction(sum(each.low for each in prices)), Fraction(sum(each.high for each in prices))))
            for name, prices in expected.items()
        }


def test_generations_cost_what_the_model_says(shipped: list[Program]) -> None:
    """The difference between two choices is that of their messages alone; MAVLink 1 has no room for ids above 255."""
    for program in shipped:
        system = program.system
        (generations,) = system.generations
        bars = bars_of(program.page("bandwidth.html"), "generations")
        common = [message for message in sent(system) if message.name not in (*generations.old, *generations.new)]
        rest = [message_price(message, system).whole for message in common]
        for choice in Generation:
            own = price(generations, choice, system)
            whole = Range(own.low + sum(each.low for each in rest), own.high + sum(each.high for each in rest))
            assert bars[f"{choice.value}, MAVLink 2"][0] == str(whole)
            old = [message for message in sent(system, choice) if message.wire.id <= 255 and message.stream]
            frames = [
                (8 + message.wire.base_length) * message.stream.default_rate * sum(message_price(message, system).is_on)
                for message in old
                if message.stream
            ]
            assert bars[f"{choice.value}, MAVLink 1"][0] == str(Range(Fraction(sum(frames)), Fraction(sum(frames))))


def test_a_uart_carries_a_tenth_of_its_baud_rate(shipped: list[Program]) -> None:
    """57600 baud are 5760 bytes/s; what goes over UDP has no limit that is known."""
    rover, battery = shipped
    prices = [message_price(message, battery.system).whole for message in sent(battery.system)]
    share = ends(bars_of(battery.page("bandwidth.html"), "link-autopilot")["at the default rates"][0])
    assert share == (
        round(float(sum(each.low for each in prices) / 57.60), 1),
        round(float(sum(each.high for each in prices) / 57.60), 1),
    )
    assert "UDP, no limit known" in rover.page("bandwidth.html").xpath("//dl//dd/text()")


def test_fastest_rates_are_those_that_streams_allow(shipped: list[Program]) -> None:
    rows = {row[1].rstrip(" *"): row for row in rows_of(shipped[0].page("bandwidth.html"), "The numbers")}
    assert rows["BATTERY_STATUS"][7:] == ["50", "2350 to 3150"]
    assert rows["HEARTBEAT"][7:] == ["50", "1050"]
    assert rows["SMART_BATTERY_INFO"][7] == "1"
    assert rows["AUTOPILOT_VERSION"][4:6] == ["", ""]
    assert rows["AUTOPILOT_VERSION"][7] == "10"


@pytest.mark.parametrize(
    "top", [Fraction(1, 30), Fraction(9, 10), Fraction(7), Fraction(126), Fraction(7349), Fraction(0)]
)
def test_scales_end_beyond_the_longest_bar(top: Fraction) -> None:
    drawn = chart("x", "", "", "", [Amount("a", Range(top / 2, top), "")])
    assert 2 <= len(drawn.ticks) <= 5
    assert drawn.ticks[-1].at == 100
    assert top <= Fraction(drawn.ticks[-1].label)
    assert drawn.bars[0].low + drawn.bars[0].more <= 100


def test_more_than_a_link_carries_is_said_in_words() -> None:
    """And the bar ends where the link does."""
    over = chart("x", "", "", "%", [Amount("a", Range(Fraction(90), Fraction(250)), "", style="over")], Fraction(100))
    assert (over.bars[0].low, over.bars[0].more, over.bars[0].style) == (90, 10, "over")


@pytest.mark.parametrize(("number", "stream", "is_beyond"), [(255, "S", False), (256, "S", True), (256, None, False)])
def test_the_one_byte_of_an_id_has_255_in_it(number: int, stream: str | None, is_beyond: bool) -> None:
    message: Any = SimpleNamespace(name="M", stream=stream, wire=SimpleNamespace(id=number))
    assert beyond_version_1([message]) == ("M",) * is_beyond
