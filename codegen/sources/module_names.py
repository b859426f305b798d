"""Names of modules that are taken: on the board, and where the program is simulated, each name is there once."""

# fmt: off
FIRMWARE = frozenset((
    "absences", "accepted_values", "access", "adc_faults", "adc_inputs", "ages", "board", "bytewise", "checksum",
    "clock_plain", "clock_service", "clock_viper", "command_cancel", "command_table", "commands", "connection",
    "conversion", "curve", "dialect", "doubles", "enums", "failsafe", "failsafes", "fields", "floats_plain",
    "floats_viper", "frames", "frames_plain", "frames_viper", "further_reading", "guard", "heard", "ina219",
    "ina226", "inbox", "key_service", "letters", "listed_stations", "listeners", "listening", "lists",
    "live_fields", "long_commands", "made_floats", "main", "mavlink", "message", "message_fields", "messages",
    "mode_service", "nearest", "network_port", "nmea", "nmea_plain", "nmea_viper", "own_commands",
    "parameter_service", "parameters", "polling", "pulse", "rare_commands", "readiness", "reading_turns",
    "reals_plain", "reals_viper", "receiver", "receiving", "receiving_plain", "receiving_viper", "reception",
    "registers", "rows", "samples_plain", "samples_viper", "satellite_clock", "scan_plain", "scan_viper",
    "scheduler", "sender", "sentences_plain", "sentences_viper", "serial_port", "services", "set_mode", "signing",
    "sources", "state", "state_plain", "state_viper", "station", "stations", "storage", "streams", "tcp_client",
    "tcp_peer", "tcp_port", "tcp_server", "tcp_stations", "telemetry", "telemetry_plain", "telemetry_viper",
    "texts", "thresholds", "turns_plain", "turns_viper", "twins", "udp_port", "user_source", "vehicle", "watchdog",
    "wholes_plain", "wholes_viper", "wide", "words",
))
"""Modules that some firmware has; a project has those of them that it needs, tomorrow perhaps another one."""

SIMULATION = frozenset((
    "mock_asyncio", "mock_board", "mock_ticks_viper", "mock_time", "sim", "sim_adc", "sim_course", "sim_failures",
    "sim_ground", "sim_machine", "sim_pace", "sim_records", "sim_source", "sim_state", "sim_watch", "sim_wire",
))
"""Modules that stand in for the board, beside those that have the names of MicroPython's."""

MICROPYTHON = frozenset((
    "array", "asyncio", "binascii", "bluetooth", "btree", "builtins", "cmath", "collections", "cryptolib",
    "deflate", "errno", "esp", "esp32", "framebuf", "gc", "hashlib", "heapq", "io", "json", "lwip", "machine",
    "math", "micropython", "neopixel", "network", "ntptime", "onewire", "os", "platform", "pyb", "random", "re",
    "rp2", "select", "socket", "ssl", "stm", "struct", "sys", "time", "tls", "uarray", "uasyncio", "ubinascii",
    "uctypes", "uhashlib", "uio", "ujson", "umachine", "uos", "urandom", "ure", "uselect", "usocket", "ustruct",
    "usys", "utime", "vfs", "websocket", "zlib",
))
"""Modules of MicroPython on any board: a file of that name hides it, or is hidden."""
# fmt: on


def taken_by(module: str) -> str | None:
    """Return what else has a module of this name, for people, or None; one that has parts is called as its first."""
    first = module.partition(".")[0]
    owners = {"the firmware": FIRMWARE, "the simulation": SIMULATION, "MicroPython": MICROPYTHON}
    return next((owner for owner, names in owners.items() if first in names), None)
