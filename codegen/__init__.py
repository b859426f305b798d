"""Generate MicroPython telemetry firmware from requirement documents, field tables and MAVLink dialects."""

__version__ = "0.2.0"
