"""Whatever is wrong in a dialect file is reported at its line and column, and the rest of the file is still read."""

from collections.abc import Callable
from types import SimpleNamespace

import pytest

from codegen.diagnostics import Severity

Read = Callable[..., SimpleNamespace]


def in_message(fields: str, attributes: str = 'id="1" name="M"') -> str:
    """A dialect with one message, whose content starts in line 4, column 1."""
    return f"<mavlink>\n <messages>\n  <message {attributes}>\n{fields}\n  </message>\n </messages>\n</mavlink>"


def in_enum(entries: str, attributes: str = 'name="E"') -> str:
    """A dialect with one enum, whose content starts in line 4, column 1."""
    return f"<mavlink>\n <enums>\n  <enum {attributes}>\n{entries}\n  </enum>\n </enums>\n</mavlink>"


GOOD = '<field type="uint8_t" name="good"/>'
ENTRY = '<entry name="A" value="1"/>'


@pytest.mark.parametrize(
    ("xml", "expected"),
    [
        pytest.param("<html>\n</html>", ["1:1 dialect-root"], id="other root"),
        pytest.param("<mavlink>\n <version>x</version></mavlink>", ["2:2 dialect-version"], id="version"),
        pytest.param("<mavlink>\n <dialect>256</dialect></mavlink>", ["2:2 dialect-version"], id="dialect number"),
        pytest.param("<mavlink>\n\n  <include> </include></mavlink>", ["3:3 dialect-include-empty"], id="include"),
        pytest.param("<mavlink>\n <mesages/></mavlink>", ["2:2 dialect-unknown-element"], id="unknown group"),
        pytest.param(
            "<mavlink><messages>\n <enum/></messages></mavlink>", ["2:2 dialect-unknown-element"], id="wrong group"
        ),
        pytest.param(in_message(GOOD, 'name="M"'), ["3:3 dialect-missing-attribute"], id="no id"),
        pytest.param(in_message(GOOD, 'id="1"'), ["3:3 dialect-missing-attribute"], id="no message name"),
        pytest.param(in_message(GOOD, 'id="0x10" name="M"'), ["3:3 message-id"], id="id not decimal"),
        pytest.param(in_message(GOOD, 'id="-1" name="M"'), ["3:3 message-id"], id="id negative"),
        pytest.param(in_message(GOOD, 'id="16777216" name="M"'), ["3:3 message-id"], id="id too large"),
        pytest.param(in_message(GOOD, f'id="{"9" * 5000}" name="M"'), ["3:3 message-id"], id="id enormous"),
        pytest.param(in_message(GOOD, 'id="²" name="M"'), ["3:3 message-id"], id="id not ascii"),
        pytest.param(in_message(GOOD, 'id="1" name="M-1"'), ["3:3 dialect-name"], id="message name"),
        pytest.param(in_message(GOOD, 'id="1" name="Mé"'), ["3:3 dialect-name"], id="name not ascii"),
        pytest.param(in_message(GOOD, 'id="1" name="M" nam="x"'), ["3:3 dialect-unknown-attribute"], id="attribute"),
        pytest.param(in_message(""), ["3:3 message-field-count"], id="no fields"),
        pytest.param(
            in_message("".join(f'<field type="uint8_t" name="f{n}"/>' for n in range(65))),
            ["3:3 message-field-count"],
            id="65 fields",
        ),
        pytest.param(in_message(f"{GOOD}\n <feild/>"), ["5:2 dialect-unknown-element"], id="unknown in message"),
        pytest.param(
            in_message(f"{GOOD}<extensions/>\n<extensions/>"),
            ["5:1 message-extensions-repeated"],
            id="extensions twice",
        ),
        pytest.param(in_message(f"{GOOD}\n  {GOOD}"), ["5:3 field-duplicate"], id="field twice"),
        pytest.param(
            in_message('<field type="uint8_t" name="v"/>\n<field type="uint8_t" name="V"/>'),
            ["5:1 field-duplicate"],
            id="field twice but for capitals",
        ),
        pytest.param(in_message('<field name="f"/>'), ["4:1 dialect-missing-attribute"], id="no type"),
        pytest.param(in_message('<field type="uint8_t"/>'), ["4:1 dialect-missing-attribute"], id="no field name"),
        pytest.param(in_message('<field type="uint8" name="f"/>'), ["4:1 field-type"], id="type"),
        pytest.param(in_message('<field type="uint8_t[2" name="f"/>'), ["4:1 field-type"], id="open bracket"),
        pytest.param(
            in_message('<field type="uint8_t_mavlink_version[2]" name="f"/>'), ["4:1 field-type"], id="versions"
        ),
        pytest.param(in_message('<field type="char[0]" name="f"/>'), ["4:1 field-array-length"], id="length 0"),
        pytest.param(in_message('<field type="char[256]" name="f"/>'), ["4:1 field-array-length"], id="length 256"),
        pytest.param(in_message('<field type="char[]" name="f"/>'), ["4:1 field-array-length"], id="no length"),
        pytest.param(in_message('<field type="char[-1]" name="f"/>'), ["4:1 field-array-length"], id="length -1"),
        pytest.param(in_message('<field type="char[x]" name="f"/>'), ["4:1 field-array-length"], id="length x"),
        pytest.param(
            in_message('<field type="char" name="f" instance="yes"/>'), ["4:1 dialect-boolean"], id="instance"
        ),
        pytest.param(in_message('<field type="char" name="f" display="bits"/>'), ["4:1 field-display"], id="display"),
        pytest.param(in_message('<field type="char" name="f" enum="X"/>'), ["4:1 field-unknown-enum"], id="enum"),
        pytest.param(
            in_message('<field type="char" name="f" invald="0"/>'), ["4:1 dialect-unknown-attribute"], id="invald"
        ),
        pytest.param(in_message('<field type="uint8_t" name="f" invalid="x"/>'), ["4:1 sentinel-text"], id="invalid"),
        pytest.param(in_message('<field type="uint8_t" name="f" invalid="-1"/>'), ["4:1 sentinel-range"], id="range"),
        pytest.param(in_message('<field type="double[32]" name="f"/>'), ["3:3 message-payload"], id="payload"),
        pytest.param(
            in_message(f"<deprecated/>{GOOD}"),
            ["4:1 dialect-missing-attribute", "4:1 dialect-missing-attribute"],
            id="deprecated without date",
        ),
        pytest.param(in_enum(ENTRY, "bitmask='1'"), ["3:3 dialect-missing-attribute"], id="no enum name"),
        pytest.param(in_enum(ENTRY, 'name="E" bitmask="yes"'), ["3:3 dialect-boolean"], id="bitmask"),
        pytest.param(in_enum(""), ["3:3 enum-without-entries"], id="no entries"),
        pytest.param(in_enum("<entry value='1'/>"), ["4:1 dialect-missing-attribute"], id="no entry name"),
        pytest.param(in_enum('<entry name="1A" value="1"/>'), ["4:1 dialect-name"], id="entry name"),
        pytest.param(in_enum('<entry name="A" value="two"/>'), ["4:1 enum-entry-value"], id="value"),
        pytest.param(in_enum('<entry name="A" value="-1"/>'), ["4:1 enum-entry-value"], id="value negative"),
        pytest.param(in_enum('<entry name="A" value="2**64"/>'), ["4:1 enum-entry-value"], id="value of 65 bits"),
        pytest.param(in_enum('<entry name="A" value="010"/>'), ["4:1 enum-entry-value"], id="octal or decimal"),
        pytest.param(
            in_enum('<entry name="A" value="__import__(&quot;os&quot;).getpid()"/>'),
            ["4:1 enum-entry-value"],
            id="code in a value, which mavgen runs",
        ),
        pytest.param(in_enum(f'{ENTRY}\n <entry name="A" value="2"/>'), ["5:2 enum-conflict"], id="entry twice"),
        pytest.param(in_enum(f'{ENTRY}\n <entry name="B" value="1"/>'), ["5:2 enum-conflict"], id="value twice"),
        pytest.param(in_enum(f"{ENTRY}\n <entri/>"), ["5:2 dialect-unknown-element"], id="unknown in enum"),
    ],
)
def test_what_is_wrong_is_reported_where_it_stands(xml: str, expected: list[str], read: Read) -> None:
    """Line, column and rule, exactly; nothing else is reported as a consequence."""
    assert read(xml).found == expected


def test_everything_wrong_is_reported_in_one_run(read: Read) -> None:
    """And what is right beside it is read."""
    result = read(
        "<mavlink>\n<enums>\n<enum name='E'>\n<entry name='A' value='x'/>\n<entry name='B' value='7'/>\n</enum></enums>"
        "<messages>\n<message id='x' name='M1'><field type='int' name='f'/></message>\n"
        "<message id='2' name='M2'>\n<field type='int' name='f'/>\n<field type='char' name='g'/>\n</message>\n"
        "<message id='3' name='M3'><field type='uint8_t' name='f'/></message></messages></mavlink>"
    )
    assert result.found == [
        "4:1 enum-entry-value",
        "7:1 message-id",
        "7:27 field-type",
        "9:1 field-type",
    ]
    assert list(result.dialect.messages) == ["M2", "M3"]
    assert [field.name for field in result.dialect.messages["M2"].fields] == ["g"]
    assert [(entry.name, entry.value) for entry in result.dialect.enums["E"].entries] == [("B", 7)]


@pytest.mark.parametrize(
    ("first", "second"), [(("1", "A"), ("2", "A")), (("1", "A"), ("1", "B")), (("1", "A"), ("2", "a"))]
)
def test_two_messages_of_one_name_or_id(first: tuple[str, str], second: tuple[str, str], read: Read) -> None:
    """Within a file; the finding names the first one."""
    messages = "\n".join(f'<message id="{id_}" name="{name}">{GOOD}</message>' for id_, name in (first, second))
    result = read(f"<mavlink><messages>\n{messages}</messages></mavlink>")
    assert result.found == ["3:1 message-duplicate"]
    assert [place.line for place, _ in next(iter(result.report)).related] == [2]
    assert list(result.dialect.messages) == ["A"]


def test_unknown_parts_are_warnings_with_suggestions(read: Read) -> None:
    """A newer dialect may have attributes that are not known yet, and must still build."""
    report = read(in_message('<field type="uint8_t" name="f" invald="0"/><extension/>')).report
    assert {one.rule.severity for one in report} == {Severity.WARNING}
    assert [one.hint for one in report] == ["did you mean invalid?", "did you mean extensions?"]
    assert report.exit_code == 0


def test_attributes_of_other_namespaces_are_left_alone(read: Read) -> None:
    """A schema location or xml:space is not MAVLink's business."""
    schema = 'xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xsi:noNamespaceSchemaLocation="mavschema.xsd"'
    xml = in_message(GOOD).replace("<mavlink>", f"<mavlink {schema}>")
    assert read(xml).found == []


def test_attributes_are_decoded_as_written(read: Read) -> None:
    """Each attribute of a field, the instance that says no, and the description on one line."""
    field = (
        '<field type="int16_t[3]" name="f" units="cdegC" instance="false" display="bitmask" multiplier="1E-2" '
        'minValue="-5" maxValue="5" print_format="0x%04x" invalid="[0]" default="0" increment="1">Two\n   lines</field>'
    )
    result = read(in_message(f'{field}<extensions/><field type="char" name="g" instance="1"/>'))
    assert result.found == []
    first, second = result.dialect.messages["M"].definition.fields
    assert (first.type, first.length, first.units, first.is_instance, first.is_bitmask) == (
        ("int16_t", 3, "cdegC", False, True)
    )
    assert (first.multiplier, first.minimum, first.maximum, first.print_format, first.invalid) == (
        ("1E-2", "-5", "5", "0x%04x", "[0]")
    )
    assert (first.description, first.is_extension) == ("Two lines", False)
    assert (second.length, second.is_extension, second.is_instance) == (None, True, True)


def test_lifecycle_of_messages_enums_and_entries(read: Read) -> None:
    """wip, deprecated and superseded, with their dates, successors and remarks."""
    old = '<deprecated since="2020-01" replaced_by="N">Was\n wrong.</deprecated>'
    superseded = '<superseded since="2021-02" replaced_by=""><description>Is better.</description></superseded>'
    result = read(
        f"<mavlink><enums><enum name='E'>{superseded}<entry name='A' value='1'><wip/></entry></enum></enums>"
        f"<messages><message id='1' name='M'>{old}<wip/>{GOOD}</message></messages></mavlink>"
    )
    assert result.found == []
    message = result.dialect.messages["M"].definition.lifecycle
    enum = result.dialect.enums["E"]
    assert (message.wip, message.deprecated_since, message.replaced_by) == (True, "2020-01", "N")
    assert (message.remark, message.superseded_since) == ("Was wrong.", None)
    assert (enum.lifecycle.superseded_since, enum.lifecycle.replaced_by) == ("2021-02", None)
    assert (enum.lifecycle.remark, enum.lifecycle.deprecated_since) == ("Is better.", None)
    assert enum.entries[0].lifecycle.wip
