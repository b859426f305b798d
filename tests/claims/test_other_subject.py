"""A number that was taken for one message's is no error where it is right for another that the document names."""

from collections.abc import Callable

import pytest

from codegen.diagnostics import Diagnostic

Check = Callable[[str], list[Diagnostic]]

ELSEWHERE = '''```python
"""Makes GPS_INPUT.

The scaling is not that of GPS_RAW_INT.
"""
IGNORED = 8
KNOWN = 1


{claim}
```
'''
RIGHT = {
    "a number of a button": "## One\n\n- `WINCH_STATUS` (9005, 34 bytes).\n\n## Two\n\n- Buttons:\n  - relax 0\n  - length 1\n",
    "a length of the first message, behind another one": ELSEWHERE.format(claim="# 63 payload bytes without yaw"),
    "a length in parentheses": "- PARAM_EXT_SET has 147 bytes, one more than PARAM_EXT_ACK (146).\n",
    "the length of the message, not of the array": "PLAY_TUNE has `tune`, and 200 more in `tune2`: 32 bytes grow to 232.\n",
    "the last one alone is the extension": "## MISSION_ACK\n\nTarget system, `type`, and `mission_type` as an extension.\n",
    "the payload goes over the wire": "## ESC_TELEMETRY_1_TO_4\n\n44 bytes on the wire, CRC_EXTRA 144.\n",
}
WRONG = {
    "right for none": (ELSEWHERE.format(claim="# 61 payload bytes without yaw"), "claim-message-size"),
    "the heading names it": ("# Missions\n\n## MISSION_COUNT\n\nId 44.\n\n## MISSION_ACK\n\n`type`, and `mission_type` as an extension. Without the extension the payload has 4 bytes.\n", "claim-message-size"),
    "a type that names it": (
        "```ts\n// HEARTBEAT comes first\nexport const PING = {\n  id: 0,\n  crcExtra: 237,\n};\n```\n",
        "claim-message-id",
    ),
    "both are extensions": ("## MISSION_ACK\n\n`type` and `mission_type` are extensions.\n", "claim-extension"),
}  # fmt: skip


@pytest.mark.parametrize("name", RIGHT)
def test_what_is_right_for_another_is_no_error(name: str, check: Check) -> None:
    assert [str(each) for each in check(RIGHT[name])] == []


@pytest.mark.parametrize("name", WRONG)
def test_what_is_wrong_for_all_is_found(name: str, check: Check) -> None:
    text, rule = WRONG[name]
    assert [each.rule.id for each in check(text)] == [rule]
