# Generated from specs/codegen.yaml, specs/dialects/battery_cell_voltages_rfc_0018.xml,
#   specs/dialects/battery_info_upstream.xml, specs/dialects/battery_upstream.xml,
#   specs/dialects/corrections_rfc_0018.yaml, specs/dialects/protocol_version.xml,
#   specs/dialects/upstream.xml, specs/messages/autopilot_version.yaml,
#   specs/messages/battery_cell_faults_rfc_0018.yaml,
#   specs/messages/battery_cell_voltages.yaml, specs/messages/battery_status.yaml,
#   specs/messages/battery_status_v2.yaml, specs/messages/battery_status_v2_rfc_0018.yaml,
#   specs/messages/protocol_version.yaml, specs/smart_battery/board.yaml,
#   specs/smart_battery/codegen.yaml, specs/smart_battery/messages/battery_info.yaml,
#   specs/smart_battery/messages/heartbeat.yaml,
#   specs/smart_battery/messages/smart_battery_info.yaml,
#   specs/smart_battery/parameters.yaml, specs/smart_battery/state.yaml,
#   specs/smart_battery/streams.yaml, specs/smart_battery/vehicle.yaml: do not edit.
# Inputs: 8bab26911d6138fd
"""Facts of the specification about the program, which its checks compare with."""

CONTROL_US = 50000
LINKS_US = 50000
CHECKS_US = 100000
ARMING_US = 100000  # between two looks at what speaks against arming
# Each job of the main loop in its order: how often it is due, in microseconds, and its name; and how many in a pass.
JOBS = (
    (100000, "measure"),
    (100000, "battery"),
    (50000, "links"),
    (10000000, "report"),
    (1000000, "reminder"),
)
JOBS_OF_A_PASS = 6
SILENCE_MS = 10000
STEP_LIMIT_US = 10000
REPORT_MS = 10000
FORGETS = False
HEALTH_MS = 0
FILES = ("parameters.0", "parameters.1")
CHUNK = 64
FORCE_ARM = None
TELLS_STATUS = False  # of the vehicle, which failsafes change
TOLD_ARMED = (False, False)  # whether HEARTBEAT has its flag while disarmed, and while armed
SYSTEM_ID = 1
COMPONENT_ID = 180
VERSION = 2
LENGTHS = ((0, 54), (97, 97), (107, 107))  # of payloads that go out, the first and the last of each range

# The user's module and the class in it, which the board starts.
USER = ("pack", "Pack")

# The links of the board: the kind of each, and its settings.
LINKS = (
    (
        "uart",
        {
            "name": "autopilot",
            "uart": 0,
            "tx": 0,
            "rx": 1,
            "baud": 57600,
            "size": 1024,
        },
    ),
)

# Questions about what the vehicle does not have, by the ids of messages, each with that of its answer.
ABSENT = ()

# Numbers of the commands that not every program answers.
ANSWERED = ()

# The links on which signed frames count, frames of listed systems, and a new key; and the file of the key.
ACCESS = None

# The timeout of the watchdog, how often it is fed, and what resets come from by their numbers; None without one.
WATCHDOG = {
    "timeout_ms": 2000,
    "look_ms": 500,
    "causes": {3: "a restart", 1: "power on"},
}

# The criteria that the specification names for each aspect of the program; a check of another one is no evidence.
CRITERIA = {
    "component.allocation": ("FR-00067.4",),
    "component.mock": ("NFR-00062.1",),
    "component.rate": ("FR-00067.1",),
    "component.reported": ("FR-00068.1",),
    "component.robustness": ("FR-00067.5",),
    "component.scenarios": ("NFR-00062.2",),
    "component.steady": ("NFR-00060.3",),
    "control.missed": ("FR-00071.3",),
    "generations.choice": ("FR-00072.2",),
    "generations.other": ("FR-00072.3",),
    "generations.price": ("FR-00072.7",),
    "message.besides": ("FR-00076.6",),
    "message.change": ("FR-00076.5",),
    "message.connection": ("FR-00076.3",),
    "message.request": ("FR-00076.4",),
    "quantity.calibration": ("FR-00069.6",),
    "quantity.invalid_after": ("FR-00067.3",),
    "quantity.multiplier": ("FR-00069.2",),
    "quantity.rounding": ("FR-00069.7",),
    "quantity.stale_after": ("FR-00067.3",),
    "quantity.warn_above": ("FR-00069.5",),
    "reading.absence": ("FR-00066.5",),
    "reading.failure": ("FR-00066.4",),
    "reading.first": ("FR-00066.5",),
    "reading.monitor": ("FR-00066.3",),
    "reading.pin": ("FR-00066.1",),
    "reading.rate": ("FR-00066.3",),
    "reading.read_limit": ("NFR-00060.2",),
    "reading.samples": ("FR-00066.2",),
    "services.commands": ("FR-00070.1",),
    "services.data_streams": ("FR-00070.4",),
    "services.garbage": ("FR-00070.9",),
    "services.intervals": ("FR-00070.3",),
    "services.links": ("FR-00070.10",),
    "services.ping": ("FR-00070.7",),
    "services.request": ("FR-00070.2",),
    "services.restart": ("FR-00070.6",),
    "services.texts": ("FR-00070.8",),
    "services.twins": ("FR-00074.10",),
    "storage.defaults": ("NFR-00061.2",),
    "storage.kept": ("NFR-00061.1",),
    "storage.over_link": ("NFR-00061.8",),
    "storage.power_cut": ("NFR-00061.3",),
    "storage.read": ("NFR-00061.6",),
    "storage.reboot": ("NFR-00061.7",),
    "storage.set": ("NFR-00061.5",),
    "storage.steps": ("NFR-00061.4",),
    "streams.fixed": ("FR-00074.1", "FR-00074.4"),
    "streams.rate": ("FR-00074.3",),
    "watchdog.fed": ("FR-00071.6",),
    "watchdog.hung": ("FR-00071.5",),
    "watchdog.told": ("FR-00071.7",),
}

# Measured components: where they are read, how counts become stored steps, and when a value is given up.
MEASURED = (
    {
        "component": "battery",
        "first": "battery",
        "instances": 1,
        "name": "voltage",
        "attribute": "voltage_mv",
        "gpios": [26],
        "are_on": [True],
        "set_by_code": [],
        "pin": "batt_volt_pin",
        "spare_bits": 0,
        "full_scale": 4095,
        "samples": 5,
        "read_limit_us": 2000,
        "multiplier": "batt_volt_mult",
        "multiplier_name": "BATT_VOLT_MULT",
        "latched": True,
        "numerator": 11,
        "denominator": 136500,
        "warn_every_ms": 10000,
        "warning_counts": [4085],
        # Count, multiplier in steps, what is kept of them, and whether it is warned about.
        "edges": [
            (4093, 88663, 29244, True),
            (4095, 10050, 3317, False),
            (4095, 39393, 13000, False),
            (4095, 39396, 13001, True),
        ],
        "invalid_after": 5,
        "stale_after_ms": 1000,
        "period_us": 100000,
        "enabled": "monitored",
        "enabled_by": "batt_monitor",
        "families": {
            "pin": [],
            "multiplier": [],
            "enabled_by": [],
        },
        "returns": {
            "gone": "absent",
            "below": [3000],
            "back_from": [6000],
            "count": "swaps_number",
            "title": "Battery",
            "restarting": [],
        },
        "trend": None,
        "trend_half": 0,
        "estimated": [],
        "not_estimated": [],
        "estimates": [],
    },
)

# Failsafes of two levels below parameters; a threshold in stored steps is the parameter's steps times its scale.
FAILSAFES = ()

# Further inputs at which no failsafe holds: the number of the pin, and what a converter of 16 bits shows there.
CALM = ()

# All failsafes, each with the time between two readings of what it looks at in these passes; None: it looks with all
# other checks. Of a condition: level (0 is looked at for arming alone), attribute, what holds, parameter and factor of
# the threshold, whether 0 switches it off, parameter and milliseconds of the time, hysteresis, the quantity's limits.
WATCHED = ()

# Actions: value of the parameter, call, drive mode (None: stays), whether the vehicle is disarmed.
ACTIONS = ()

# Their values, the most severe first; nothing where each failsafe acts for itself.
PRIORITY = ()

# Whether whole parameters go over the wire as their bytes; else all are the number as a float.
BYTEWISE = False

# Parameters: name, attribute, default, smallest and largest in steps; a value is steps * numerator / denominator.
PARAMETERS = (
    {
        "name": "BATT_CAPACITY",
        "attribute": "batt_capacity",
        "default": 3300,
        "minimum": 0,
        "maximum": 1000000,
        "numerator": 1,
        "denominator": 1,
        "type": 6,
        "after_restart": False,
        "choices": (),
    },
    {
        "name": "BATT_ID",
        "attribute": "batt_id",
        "default": 2,
        "minimum": 0,
        "maximum": 9,
        "numerator": 1,
        "denominator": 1,
        "type": 1,
        "after_restart": True,
        "choices": (),
    },
    {
        "name": "BATT_MONITOR",
        "attribute": "batt_monitor",
        "default": 3,
        "minimum": 0,
        "maximum": 3,
        "numerator": 1,
        "denominator": 1,
        "type": 2,
        "after_restart": True,
        "choices": (0, 3),
    },
    {
        "name": "BATT_REPORT",
        "attribute": "batt_report",
        "default": 0,
        "minimum": 0,
        "maximum": 2,
        "numerator": 1,
        "denominator": 1,
        "type": 2,
        "after_restart": False,
        "choices": (0, 1, 2),
    },
    {
        "name": "BATT_STATUS_RATE",
        "attribute": "batt_status_rate",
        "default": 5,
        "minimum": 0,
        "maximum": 100,
        "numerator": 1,
        "denominator": 10,
        "type": 9,
        "after_restart": False,
        "choices": (),
    },
    {
        "name": "BATT_V2_RATE",
        "attribute": "batt_v2_rate",
        "default": 10,
        "minimum": 0,
        "maximum": 100,
        "numerator": 1,
        "denominator": 10,
        "type": 9,
        "after_restart": False,
        "choices": (),
    },
    {
        "name": "BATT_VOLT_MULT",
        "attribute": "batt_volt_mult",
        "default": 39500,
        "minimum": 10000,
        "maximum": 100000,
        "numerator": 1,
        "denominator": 10000,
        "type": 9,
        "after_restart": True,
        "choices": (),
    },
    {
        "name": "BATT_VOLT_PIN",
        "attribute": "batt_volt_pin",
        "default": 26,
        "minimum": 26,
        "maximum": 28,
        "numerator": 1,
        "denominator": 1,
        "type": 2,
        "after_restart": True,
        "choices": (),
    },
    {
        "name": "COMPID_BATT",
        "attribute": "compid_batt",
        "default": 180,
        "minimum": 1,
        "maximum": 255,
        "numerator": 1,
        "denominator": 1,
        "type": 4,
        "after_restart": True,
        "choices": (),
    },
    {
        "name": "SYSID_THISMAV",
        "attribute": "sysid_thismav",
        "default": 1,
        "minimum": 1,
        "maximum": 255,
        "numerator": 1,
        "denominator": 1,
        "type": 4,
        "after_restart": True,
        "choices": (),
    },
)

# Streams: a fixed period in ms, numerator / denominator, or a parameter that sets the rate in Hz. Messages are
# (id, instances that are on by default, whether they are left out with the monitor off).
STREAMS = (
    {
        "name": "HEARTBEAT",
        "period_numerator": 1000,
        "period_denominator": 1,
        "parameter": None,
        "parameter_name": "",
        "numerator": 1,
        "denominator": 1,
        "default": 0,
        "minimum": 0,
        "maximum": 0,
        "data_stream": None,
        "fastest_hz": 10,
        "messages": [(0, 1, False)],
    },
    {
        "name": "EXTRA1",
        "period_numerator": 0,
        "period_denominator": 1,
        "parameter": "batt_status_rate",
        "parameter_name": "BATT_STATUS_RATE",
        "numerator": 1,
        "denominator": 10,
        "default": 5,
        "minimum": 0,
        "maximum": 100,
        "data_stream": 10,
        "fastest_hz": 10,
        "messages": [(147, 1, True)],
    },
    {
        "name": "EXTRA3",
        "period_numerator": 0,
        "period_denominator": 1,
        "parameter": "batt_v2_rate",
        "parameter_name": "BATT_V2_RATE",
        "numerator": 1,
        "denominator": 10,
        "default": 10,
        "minimum": 0,
        "maximum": 100,
        "data_stream": 12,
        "fastest_hz": 10,
        "messages": [(369, 1, True)],
    },
    {
        "name": "INFO",
        "period_numerator": 20000,
        "period_denominator": 1,
        "parameter": None,
        "parameter_name": "",
        "numerator": 1,
        "denominator": 1,
        "default": 0,
        "minimum": 0,
        "maximum": 0,
        "data_stream": None,
        "fastest_hz": 1,
        "messages": [(370, 1, True), (372, 1, True)],
    },
)

# Ids of the messages that are sent on request only, and the shortest interval of each message in microseconds.
ON_REQUEST = [148, 300, 54371]
SENT = (0, 147, 369, 370, 372, 148, 300, 54371)
SHORTEST_US = (100000, 100000, 100000, 1000000, 1000000, 100000, 100000, 100000)

# Generations of messages: the parameter that chooses ("" for a fixed choice), the ids of each, bytes per second of the
# old one, the new one and both: the least and the most.
GENERATIONS = (
    {
        "parameter": "BATT_REPORT",
        "attribute": "batt_report",
        "default": 0,
        "old": (147, 370),
        "new": (369, 372),
        "prices": ((28.95, 36.95), (18.95, 44.95), (47.9, 81.9)),
    },
)

# Messages by id: the component that they are about with the boolean that switches it on, the default rate in Hz, the
# least and the most bytes of a frame by instance, what announces them, and where they have the number of the instance.
MESSAGES = {
    0: {
        "component": None,
        "enabled": None,
        "instances": 1,
        "pages": 1,
        "rate": 1.0,
        "frames": ((21, 21),),
        "on_connection": False,
        "number_at": None,
        "watched": None,
    },
    147: {
        "component": "battery",
        "enabled": "monitored",
        "instances": 1,
        "pages": 1,
        "rate": 0.5,
        "frames": ((47, 63),),
        "on_connection": False,
        "number_at": 32,
        "watched": None,
    },
    148: {
        "component": None,
        "enabled": None,
        "instances": 1,
        "pages": 1,
        "rate": 0.0,
        "frames": ((32, 32),),
        "on_connection": False,
        "number_at": None,
        "watched": None,
    },
    300: {
        "component": None,
        "enabled": None,
        "instances": 1,
        "pages": 1,
        "rate": 0.0,
        "frames": ((17, 17),),
        "on_connection": False,
        "number_at": None,
        "watched": None,
    },
    369: {
        "component": "battery",
        "enabled": "monitored",
        "instances": 1,
        "pages": 1,
        "rate": 1.0,
        "frames": ((13, 39),),
        "on_connection": False,
        "number_at": 26,
        "watched": None,
    },
    370: {
        "component": "battery",
        "enabled": "monitored",
        "instances": 1,
        "pages": 1,
        "rate": 0.05,
        "frames": ((109, 109),),
        "on_connection": True,
        "number_at": 18,
        "watched": ("battery", "swaps_number"),
    },
    372: {
        "component": "battery",
        "enabled": "monitored",
        "instances": 1,
        "pages": 1,
        "rate": 0.05,
        "frames": ((119, 119),),
        "on_connection": True,
        "number_at": 44,
        "watched": ("battery", "swaps_number"),
    },
    54371: {
        "component": "battery",
        "enabled": "monitored",
        "instances": 1,
        "pages": 1,
        "rate": 0.0,
        "frames": ((13, 40),),
        "on_connection": False,
        "number_at": 0,
        "watched": None,
    },
}

# The tables of messages that have several, by id, with the shortest interval in microseconds. All else leaves them out:
# a frame does not tell which table it is of.
SHARED = {}

# Component, instance, attribute and a value of all that a message is withheld for while it is unknown, with the place
# of the word that says how long it is believed, if it ages; and by id the quantities that withhold a message.
KNOWN = ()
WITHHELD = {}
