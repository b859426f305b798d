"""Texts of every kind of YAML file, right and wrong, that decoder and schemas are both held against."""

GOOD = {
    "codegen": "project: rover\ndialect: common\noverlays: [a.xml]\nsystem_id: 7\n",
    "state": (
        "components:\n  battery:\n    doc: A battery.\n    update_rate: 10 Hz\n    quantities:\n"
        "      voltage: {doc: Volts., unit: V, min: -0.5, boolean: false, invalid_after: 5, initial: 12}\n"
        "      mode: {doc: Mode., enum: E, initial: E_ONE}\n      armed: {doc: Armed., boolean: true, initial: false}\n"
    ),
    "board": (
        "board: pico_2\nadc:\n  pack: {gpio: 26, bits: 12, reference: 3.3 V}\n"
        "facts:\n  battery: {cells: 3, kind: LIPO}\n"
        "links:\n  a: {uart: 0, tx: 0, rx: 1, baud: 57600}\n  b: {usb: true}\n"
        "  c: {udp: 14550, to: 10.0.0.1, credentials: w.json, retry: 5 s, local_port: 1, buffer: 512}\n"
        "curves:\n  c: {choice: kind, per: cells, by: {LIPO: {4.2 V: 100, 3.27 V: 0}}}\n  d: {points: {1 V: 2}}\n"
        "sources:\n  sonar: {driver: user, class: a.B, unit: m, stored: mm, rate: 5 Hz, outputs: {}}\n"
        "  own: {driver: mine, address: 0x40, gain: 2, on: true, limit: 2 ms}\n"
    ),
    "driver": (
        "doc: d\nclass: C\nbus: i2c\nrate: 5 Hz\nkeys:\n  a: {doc: d, kind: pin, default: 3}\n"
        "  b: {doc: d, min: 0, max: 1.5}\n"
        "outputs:\n  x: {doc: d, unit: m, stored: mm, min: 0, max: 5}\n  y: {}\n"
    ),
    "parameters": "parameters:\n  MULT: {doc: d, default: 3.95, min: 1, max: 0x0a, step: 0.0001}\n"
    "  PIN: {doc: d, default: 1, min: 0, max: 2, step: 1, type: int8, reboot: true, values: {0: Off, 1: On}}\n",
    "streams": "streams:\n  A: {doc: d, rate: 2 Hz}\n  B: {doc: d, parameter: P, data_stream: D, fastest: 50 Hz}\n",
    "vehicle": (
        "control: {rate: 400 Hz, report_every: 10 s, links: 100 Hz}\n"
        "storage: {files: [a, b], chunk: 64, step_limit: 10 ms, requirement: R}\n"
        "arming: {force: 21196}\nservices: {fastest: 10 Hz}\nsystem_id: SYSID\nfailsafes:\n  battery:\n"
        "    watches: battery.voltage\n    levels:\n      low: {below: LOW, action: LOW_ACT}\n"
        "      critical: {below: CRT, action: CRT_ACT, requirement: R.1}\n    after: TIMER\n    requirement: R\n"
        "actions:\n  - {value: 1, call: hold, mode: 4, doc: d}\n  - {value: 2, call: stop, disarm: true, doc: d}\n"
    ),
    "receiver": "component: battery\nstale_after: 10 s\nrate_over: 1 min\nrequirement: R.1\n",
    "message": (
        "message: BATTERY_STATUS\nrequirement: FR-00068\nstream: EXTRA1\nfields:\n"
        "  id: {state: battery.instance}\n  voltages: {state: battery.volts, split: true, rounding: down, max: 65 V}\n"
        "  energy_consumed: unknown\n  flags: {flags: [A, B if battery.low]}\n  load: {constant: 1.5, min: 0}\n"
        "  rest: {unknown: true, note: none}\n"
    ),
    "corrections": (
        "corrections:\n  - message: M\n    field: f\n    set: {invalid: 0xFFFF, units: mV, instance: true}\n"
        "    reason: r\n    source: s\n"
    ),
    "waivers": (
        "waivers:\n  - {id: W1, rule: a-rule, document: a.md, fingerprint: 012345678901, reason: r, owner: o,\n"
        "     expires: 2030-01-31}\n"
    ),
    "scenarios": (
        "scenarios:\n  a: {doc: d, duration: 5 s, courses: {a.b: {value: 12 V, noise: 1 mV, wired: {MULT: 4}}}}\n"
        "  b:\n    doc: d\n    duration: 5 s\n    seed: 3\n    courses: {a.b: {points: [[0 s, 1 V], [5 s, unknown]]}}\n"
        "    events: [{at: 1 s, arm: false}, {at: 2 s, fault: slow, of: a.b, delay: 1 ms, for: 1 s}, "
        "{at: 3 s, reboot: true}]\n    expect: [{at: 1 s, state: a.b, between: [1 V, 2 V]}, {no_text: x}]\n"
    ),
}


def field(answer: str) -> str:
    """A population table whose only field has this answer, which begins at 5:6."""
    return f"message: M\nrequirement: R\nstream: S\nfields:\n  f: {answer}\n"


VEHICLE = (
    "control: {rate: 400 Hz, report_every: 10 s, links: 100 Hz}\n"
    "storage: {files: [a, b], chunk: 64, step_limit: 1 ms}\narming: {force: 1}\n"
    "services: {fastest: 10 Hz}\n"
)

# kind, text, findings, whether a record is left; a JSON Schema says no to each of them, too.
BROKEN: list[tuple[str, str, list[tuple[str, int, int]], bool]] = [
    ("codegen", "project: r\ndialect: common\nsystemid: 1\n", [("unknown-key", 3, 1)], True),
    ("codegen", "project: r\n", [("missing-key", 1, 1)], False),
    ("codegen", "projct: r\ndialect: common\n", [("unknown-key", 1, 1)], False),
    ("codegen", "project: r\ndialect: 3\n", [("wrong-type", 2, 10)], False),
    ("codegen", "project: r\ndialect: c\nsystem_id: one\n", [("wrong-type", 3, 12)], True),
    ("codegen", "project: r\ndialect: c\nsystem_id: 1.5\n", [("wrong-type", 3, 12)], True),
    ("codegen", "project: r\ndialect: c\nsystem_id: '1'\n", [("wrong-type", 3, 12)], True),
    ("codegen", "project: r\ndialect: c\noverlays: a.xml\n", [("wrong-type", 3, 11)], True),
    ("codegen", "project: r\ndialect: c\noverlays: {a: b}\n", [("wrong-type", 3, 11)], True),
    ("codegen", "project: r\ndialect: c\noverlays: [1, [b]]\n", [("wrong-type", 3, 12), ("wrong-type", 3, 15)], True),
    ("codegen", "project: r\ndialect:\n", [("missing-value", 2, 1)], False),
    ("codegen", "project: r\ndialect: c\noverlays:\n", [("missing-value", 3, 1)], True),
    ("codegen", "- project: r\n", [("wrong-type", 1, 1)], False),
    ("codegen", "rover\n", [("wrong-type", 1, 1)], False),
    ("codegen", "~\n", [("missing-value", 1, 1)], False),
    ("receiver", "stale_after: 10 s\n", [("missing-key", 1, 1)], False),
    ("receiver", "component: b\nstale_after: 10\n", [("wrong-type", 2, 14)], True),
    ("receiver", "component: [a, b]\n", [("wrong-type", 1, 12)], False),
    ("receiver", "component: b\nstale: 10 s\n", [("unknown-key", 2, 1)], True),
    ("waivers", "waivers: {id: W1}\n", [("wrong-type", 1, 10)], True),
    (
        "waivers",
        "waivers:\n  - {id: W1, rule: r, document: 3, fingerprint: 0e1, owner: o, expire: 2030-01-31}\n",
        [("missing-key", 2, 5), ("unknown-key", 2, 64), ("wrong-type", 2, 33)],
        True,
    ),
    ("state", "components: {}\n", [("empty-mapping", 1, 13)], False),
    ("state", "components: []\n", [("wrong-type", 1, 13)], False),
    ("state", "components:\n  b: {doc: d}\n", [("missing-key", 2, 3)], True),
    ("state", "components:\n  b:\n", [("missing-value", 2, 3)], True),
    (
        "state",
        "components:\n  b:\n    doc: d\n    quantities:\n      q: {doc: d, boolean: yes, initial: [1], min: .nan}\n",
        [("unusable-number", 5, 52), ("wrong-type", 5, 28), ("wrong-type", 5, 42)],
        True,
    ),
    (
        "state",
        "components:\n  b: {doc: d, update_rate: 10, quantities: {'': {doc: d}, q: {doc: d, max: 3 V}}}\n",
        [("wrong-type", 2, 28), ("wrong-type", 2, 45), ("wrong-type", 2, 76)],
        True,
    ),
    ("board", "board: b\nadc: {a: {gpio: 1, bits: 2, reference: fast}}\n", [("wrong-type", 2, 40)], True),
    ("board", "board: b\nfacts: {b: {c: true}}\n", [("wrong-type", 2, 16)], True),
    ("board", "board: b\nfacts: {b: 1}\n", [("wrong-type", 2, 12)], True),
    (
        "parameters",
        "parameters:\n  A: {doc: d, default: a, max: 2, step: 1}\n",
        [("missing-key", 2, 3), ("wrong-type", 2, 24)],
        True,
    ),
    ("streams", "streams:\n  A: {doc: d, rate: 2}\n", [("wrong-type", 2, 21)], True),
    ("streams", "streams:\n  A: {doc: d, rates: 2 Hz}\n", [("unknown-key", 2, 15)], True),
    ("message", field("unknwn"), [("wrong-type", 5, 6)], True),
    ("message", field("{}"), [("one-of-keys", 5, 3)], True),
    ("message", field("{note: n}"), [("one-of-keys", 5, 3)], True),
    ("message", field("{state: a.b, enum: E, flags: []}"), [("one-of-keys", 5, 19)], True),
    ("message", field("{sate: a.b}"), [("unknown-key", 5, 7)], True),
    ("message", field("{unknown: false}"), [("wrong-type", 5, 16)], True),
    ("message", field("{unknown: 1}"), [("wrong-type", 5, 16)], True),
    ("message", field("{constant: 1, rounding: nerest}"), [("unknown-choice", 5, 30)], True),
    ("message", field("{constant: 1, rounding: 1}"), [("wrong-type", 5, 30)], True),
    ("message", field("{constant: true}"), [("wrong-type", 5, 17)], True),
    ("message", field("{flags: A}"), [("wrong-type", 5, 14)], True),
    ("message", field("[state]"), [("wrong-type", 5, 6)], True),
    ("message", "message: M\nrequirement: R\nstream: S\nfields: {}\n", [("empty-mapping", 4, 9)], False),
    ("message", "message: M\nrequirement: R\nstream: S\nfields:\n", [("missing-value", 4, 1)], False),
    (
        "corrections",
        "corrections:\n  - message: M\n    field: f\n    set: {}\n    reason: r\n    source: s\n",
        [("empty-mapping", 4, 10)],
        True,
    ),
    (
        "corrections",
        "corrections:\n  - set: {invalid: [0]}\n    reason: r\n",
        [("missing-key", 2, 5), ("wrong-type", 2, 20)],
        True,
    ),
    ("corrections", "corrections: {message: M}\n", [("wrong-type", 1, 14)], True),
    *(
        ("vehicle", VEHICLE + text, [(rule, 5, column)], is_left)
        for text, rule, column, is_left in (
            ("controls: {}\n", "unknown-key", 1, True),
            ("system_id: 1\n", "wrong-type", 12, True),
            ("failsafes: [battery]\n", "wrong-type", 12, True),
            ("failsafes: {b: 1}\n", "wrong-type", 16, True),
            ("actions: {value: 1}\n", "wrong-type", 10, True),
            ("actions: [{value: 1.5, call: c, doc: d}]\n", "wrong-type", 19, True),
            ("actions: [{value: 1, call: c, doc: d, disarm: 1}]\n", "wrong-type", 47, True),
            ("actions: [{value: 1, call: c}]\n", "missing-key", 11, True),
            ("actions: [{value: 1, call: c, doc: d, mod: 4}]\n", "unknown-key", 39, True),
        )
    ),
    ("vehicle", VEHICLE.replace("400 Hz", "400"), [("wrong-type", 1, 17)], False),
    ("vehicle", VEHICLE.replace("chunk: 64", "chunk: big"), [("wrong-type", 2, 33)], False),
    ("vehicle", VEHICLE.replace("[a, b]", "a"), [("wrong-type", 2, 18)], False),
    ("vehicle", VEHICLE.replace("services: {fastest: 10 Hz}\n", ""), [("missing-key", 1, 1)], False),
    ("board", "sources: {a: {driver: user, class: a.B, rates: 1 Hz}}\n", [("unknown-key", 1, 41)], True),
    ("board", "sources: {a: {driver: user, class: 1}}\n", [("wrong-type", 1, 36)], True),
    ("board", "sources: {a: {driver: 3}}\n", [("wrong-type", 1, 23)], True),
    ("board", "sources: {a: {class: a.B}}\n", [("missing-key", 1, 11)], True),
    ("board", "sources: {a: {driver: mine, gain: [1]}}\n", [("wrong-type", 1, 35)], True),
    ("board", "board: b\nlinks: {a: {usb: false}}\n", [("wrong-type", 2, 18)], True),
    ("board", "board: b\nlinks: {a: {usb: true, udp: 1}}\n", [("one-of-keys", 2, 24)], True),
    ("board", "board: b\nlinks: {a: {tx: 1}}\n", [("one-of-keys", 2, 9)], True),
    ("board", "board: b\ncurves: {L: {points: {4 V: full}}}\n", [("wrong-type", 2, 28)], True),
    (
        "parameters",
        "parameters:\n  A: {doc: d, default: 1, min: 0, max: 2, step: 1, type: int64, values: {1: 2}}\n",
        [("unknown-choice", 2, 58), ("wrong-type", 2, 77)],
        True,
    ),
    (
        "scenarios",
        "scenarios:\n  a: {doc: d, duration: 5 s, courses: {a.b: {value: 1 V}}, events: [{at: 1 s, adc: broken}]}\n",
        [("one-of-keys", 2, 69), ("unknown-key", 2, 79)],
        True,
    ),
    (
        "scenarios",
        "scenarios:\n  a: {doc: d, duration: 5 s, corses: {a.b: {value: 1}}}\n",
        [("unknown-key", 2, 30)],
        True,
    ),
    ("scenarios", "scenarios: [a]\n", [("wrong-type", 1, 12)], False),
    (
        "scenarios",
        "scenarios:\n  a: {doc: d, duration: 5 s, courses: {a.b: {points: [0 s, [12 V, [3]]]}}}\n",
        [("wrong-type", 2, 55), ("wrong-type", 2, 67)],
        True,
    ),
    (
        "scenarios",
        "scenarios:\n  a: {doc: d, duration: 5 s, courses: {a.b: {value: {at: 1 s}}}}\n",
        [("wrong-type", 2, 53)],
        True,
    ),
    (
        "scenarios",
        (
            "scenarios:\n  a: {doc: d, duration: 5, courses: {a.b: {value: 12 V}},\n"
            "    events: [{at: 1 s, arm: true, reboot: true}]}\n"
        ),
        [("one-of-keys", 3, 35), ("wrong-type", 2, 25)],
        True,
    ),
]
