"""The program around the telemetry, and what it tells ground stations."""
