"""Views of the program around the telemetry: main loop, commands, parameters."""
