"""The text of ``codegen --help``, written out so that it can be printed before argparse is imported."""

COMMANDS = (
    *("init", "build", "check", "diff", "explain", "trace", "import", "codec", "sim", "deploy", "bench", "watch"),
    "completion",
)
"""Each is a module of this package with ``add_command``."""

BEGINNING = """\
codegen makes MicroPython firmware that talks MAVLink, with its tests and
documents, from requirement documents, field tables and dialects.

  codegen init boat        begin a project in the folder boat
  codegen build            make its firmware, mocks, tests and documents
  codegen check            say what is wrong with the specification
  codegen sim              run the firmware here, for a ground station to see
  codegen explain TOPIC    tell all about a message, a field or a finding

codegen --help lists all commands, codegen COMMAND --help their options.
"""
"""The output of ``codegen`` alone: how one begins."""

HELP = """\
usage: codegen [-h] [--project FILE] [--debug] [--version] COMMAND ...

Generate MicroPython telemetry firmware, mocks and tests from requirement
documents, field tables and MAVLink dialects.

options:
  -h, --help      show this help message and exit
  --project FILE  the codegen.yaml to work on (default: the nearest
                  specs/codegen.yaml or codegen.yaml, from the working
                  directory upwards)
  --debug         show the traceback of an internal error
  --version       show program's version number and exit

commands:
  COMMAND
    init          begin a project that builds as it is
    build         generate the firmware, mocks, tests and documents
    check         check the specification against the dialect, and what
                  documents claim
    diff          say what changed between two versions, and who breaks
    explain       tell the whole story of a message, a field, a parameter or a
                  rule
    trace         what answers to each requirement: rows, symbols, tests and
                  their results
    import        make a population table from a requirement document, or
                  documents from ReqIF or needs.json
    codec         make MicroPython encoders and decoders for any dialect,
                  without a specification
    sim           run the generated firmware on this host against a scenario
    deploy        bring the firmware to a board over USB: only what changed
    bench         time the program on its board, and write down what it found
    watch         build and check again whenever a file changes
    completion    print what a shell needs to complete commands and options

Exit codes: 0 clean; 1 findings, stale output or a breaking change; 2 usage,
configuration or unreadable input; 3 internal error.
"""
