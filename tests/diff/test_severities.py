"""The severity of a change can be set, and a dialect's maintainer waives changes as a project does."""

import json
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

from codegen.cli import main
from codegen.diff.judging.severities import version_of

Run = Callable[..., tuple[int, str, str]]

OLD = (
    '<mavlink><enums><enum name="E"><entry value="1" name="A"/></enum></enums><messages>'
    '<message id="7" name="M"><description>d</description><field type="uint8_t" name="a" units="m">a</field></message>'
    '<message id="8" name="N"><description>d</description><field type="uint8_t" name="b" units="m">b</field></message>'
    "</messages></mavlink>"
)
MORE = '<entry value="1" name="A"/><entry value="2" name="B"/>'
NEW = OLD.replace('units="m"', 'units="cm"').replace('<entry value="1" name="A"/>', MORE)


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Run:
    """A comparison of two dialects with a file of waivers and severities."""
    (tmp_path / "old.xml").write_text(OLD)
    (tmp_path / "sub").mkdir()
    (tmp_path / "sub" / "dialect-2.5.xml").write_text(NEW)
    monkeypatch.chdir(tmp_path)

    def command(settings: str, *more: str) -> tuple[int, str, str]:
        (tmp_path / "w.yaml").write_text(settings)
        code = main(["diff", "old.xml", "sub/dialect-2.5.xml", "--waivers", "w.yaml", *more])
        captured = capsys.readouterr()
        return code, captured.out, captured.err

    return command


def setting(kind: str, severity: str, **more: str) -> str:
    keys = {"kind": kind, "severity": severity, "reason": "we say so", **more}
    stated = ", ".join(f"{key}: {json.dumps(value)}" for key, value in keys.items())
    return f"  - {{{stated}}}\n"


@pytest.mark.parametrize("kind", ["enum-entry-added", "field-units-changed"])
@pytest.mark.parametrize(
    ("fail_on", "code"),
    [("breaking", 1), ("person", 1), ("silent", 1), ("trace", 1), ("message-removed", 1), ("any", 1), ("never", 0)],
)
def test_what_is_set_to_be_an_error_fails_whatever_is_asked_for(kind: str, fail_on: str, code: int, run: Run) -> None:
    """It makes the comparison fail, says docs/reference.md; a harmless change as well as one that breaks somebody."""
    settings = f"severities:\n{setting('any', 'off')}{setting(kind, 'error')}"
    assert run(settings, "--fail-on", fail_on)[0] == code
    assert run(settings.replace('"error"', '"warning"'), "--fail-on", "trace")[0] == 0


def test_severities_hold_for_kinds_subjects_files_and_versions(run: Run) -> None:
    """The headline, the exit code and the report follow them alike."""
    code, out, err = run("severities: []\n")
    assert code == 1
    assert "3 changes: 2 break somebody silently" in err
    for about, is_meant in (
        ({}, True),
        ({"subject": "M"}, False),
        ({"subject": "?"}, True),
        ({"subject": "?.[ab]"}, True),
        ({"file": "sub/*.xml"}, True),
        ({"file": "other/*.xml"}, False),
        ({"since": "2.5"}, True),
        ({"since": "2.6"}, False),
        ({"since": "2.4", "until": "2.5.1"}, True),
    ):
        for kind in ("field-units-changed", "behaviour", "silent", "any"):
            code, out, err = run(f"severities:\n{setting(kind, 'info', **about)}")
            assert code == (0 if is_meant else 1), (kind, about)
            assert ("break somebody silently" in err) is (not is_meant and not about.get("subject")), (kind, about)
    assert "info field-units-changed: M.a: m -> cm" in out
    assert "set to info: we say so" in out


def test_what_is_off_is_counted_and_what_is_raised_fails(run: Run) -> None:
    """The last setting holds."""
    off = f"severities:\n{setting('any', 'off')}{setting('enum-entry-added', 'error', subject='E')}"
    code, out, err = run(off)
    assert code == 1
    assert out.startswith("sub/dialect-2.5.xml:1:")
    assert "error enum-entry-added: E.B" in out
    assert "field-units-changed" not in out
    assert "1 change: 1 set to be an error" in err
    assert "2 changes are switched off" in err
    stated = json.loads(run(off, "--format", "json")[1])
    assert (stated["off"], [change["severity"] for change in stated["changes"]]) == (2, ["error"])
    for form, said in (("markdown", "### Set to be errors"), ("html", "1 set to be an error"), ("github", "::error")):
        assert said in run(off, "--format", form)[1]
    levels = json.loads(run(f"severities:\n{setting('any', 'info')}", "--format", "sarif")[1])["runs"][0]["results"]
    assert {result["level"] for result in levels} == {"note"}


def test_a_severity_of_one_of_several_that_change_alike(run: Run, tmp_path: Path) -> None:
    """They are one line of the report as long as the same setting holds for all of them; what one of them is set to
    is not decided by the others.
    """
    field = '<field type="uint8_t" name="{}" units="{}">it</field>'
    whole = '<mavlink><messages><message id="7" name="M"><description>d</description>{}</message></messages></mavlink>'
    for file, unit in (("old.xml", "m"), ("sub/dialect-2.5.xml", "cm")):
        (tmp_path / file).write_text(whole.format("".join(field.format(name, unit) for name in "abc")))
    assert "M: a, b, c: m -> cm" in run("severities: []\n")[1]

    code, out, err = run(f"severities:\n{setting('any', 'off')}{setting('silent', 'error', subject='M.b')}")
    assert (code, out.count("field-units-changed")) == (1, 1)
    assert "error field-units-changed: M.b: m -> cm" in out
    assert "1 change: 1 breaks somebody silently" in err
    assert "2 changes are switched off" in err

    code, out, err = run(f"severities:\n{setting('any', 'info', subject='M.[ac]')}")
    assert code == 1
    assert "info field-units-changed: M: a, c: m -> cm" in out
    assert "error field-units-changed: M.b: m -> cm" in out


def test_a_report_of_what_is_off_alone_does_not_say_that_nothing_changed(run: Run) -> None:
    """A reviewer who gets a page or a comment is told that something is left out of it."""
    off = f"severities:\n{setting('any', 'off')}"
    code, out, err = run(off)
    assert (code, out) == (0, "")
    for text in (err, *(run(off, "--format", form)[1] for form in ("markdown", "html"))):
        assert "othing changed but what is switched off" in text
        assert "3 changes are switched off" in text
    some = f"severities:\n{setting('silent', 'off')}"
    assert "2 changes are switched off." in run(some, "--format", "html")[1]


def test_a_dialect_s_change_is_waived(run: Run) -> None:
    """With reason, owner and day, as a project's; one that is not used is told."""
    found = json.loads(run("waivers: []\n", "--format", "json")[1])["changes"]
    waivers = "waivers:\n"
    for number, change in enumerate(change for change in found if change["breaks"]):
        waivers += (
            f"  - {{id: W{number}, rule: {change['rule']}, document: dialect-2.5.xml, owner: us, reason: all at once,\n"
            f'     fingerprint: "{change["fingerprint"]}", expires: "2999-01-01"}}\n'
        )
    code, out, err = run(waivers)
    assert code == 0
    assert "waived: W0, us, until 2999-01-01: all at once" in out
    assert "2 waived" in err
    code, _, err = run(waivers.replace(found[0]["fingerprint"], "0" * 12))
    assert code == 1
    assert "waiver-unused" in err
    code, _, err = run(waivers.replace("2999-", "2001-"))
    assert code == 1
    assert err.count("warning waiver-expired: ") == 2
    for form in ("json", "markdown", "html", "github", "sarif", "junit", "gitlab"):
        report = run(waivers.replace("2999-", "2001-"), "--format", form)[1]
        assert "W0 ended on " in report, form
    code, _, err = run(waivers.replace(f"rule: {found[0]['rule']}", "rule: field-unit-changed"))
    assert code == 1
    assert "error waiver-unknown-rule: there is no rule field-unit-changed" in err
    code, _, err = run(waivers.replace(f"rule: {found[0]['rule']}", "rule: claim-message-size"), "--fail-on", "never")
    assert (code, "waiver-" in err) == (0, False), "it is one of codegen check"


@pytest.mark.parametrize(
    ("settings", "rule"),
    [
        (setting("field-unit-changed", "off"), "error severity-unknown-kind: codegen diff knows no kind"),
        (setting("any", "off", since="next"), "error severity-version: next: no version is written so"),
        (setting("any", "loud"), "error "),
        ('  - {kind: any, severity: off, reason: ""}\n', "error waiver-form: the severity of any has no reason"),
    ],
)  # fmt: skip
def test_what_could_never_be_used_is_told(settings: str, rule: str, run: Run) -> None:
    code, _, err = run(f"severities:\n{settings}")
    assert code == 1
    assert rule in err


def test_a_file_that_is_missing_is_told(run: Run) -> None:
    code, _, err = run("waivers: []\n", "--waivers", "none.yaml")
    assert code != 0
    assert "none.yaml" in err


def test_versions_stand_in_the_names_of_sides() -> None:
    assert version_of("/x/pymavlink-2.4.43-py3-none-any.whl:common") == (2, 4, 43)
    assert version_of("pymavlink-2.4.20.tar.gz:common") == (2, 4, 20)
    assert version_of("v1.2") == (1, 2)
    assert version_of("work tree") is None


def test_a_folder_of_dialects_at_a_revision_is_one(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """The dialect is the one of ``--dialect``, as in a release; on disk a folder needs no common dialect either."""
    git = ["git", "-c", "user.name=T", "-c", "user.email=t@example.com"]
    (tmp_path / "xml").mkdir()
    monkeypatch.chdir(tmp_path)
    subprocess.run([*git, "init", "-q", "-b", "main"], check=True)
    for text in (OLD, NEW):
        (tmp_path / "xml" / "mine.xml").write_text(text)
        subprocess.run([*git, "add", "-A"], check=True)
        subprocess.run([*git, "commit", "-q", "-m", "m"], check=True)
    for head in ("HEAD:xml", "xml", "HEAD:xml/mine.xml"):
        assert main(["diff", "HEAD~1:xml", head, "--dialect", "mine"]) == 1
        assert "M.a: m -> cm" in capsys.readouterr().out
    assert main(["diff", "HEAD~1:xml", "HEAD:xml", "--dialect", "other"]) == 2


@pytest.mark.parametrize("form", ["text", "markdown", "json", "sarif"])
def test_waivers_that_cannot_be_read_are_trouble_and_no_change(form: str, run: Run) -> None:
    """A workflow tells a breaking change, 1, from a path that is wrong, 2: nobody has to look for the change."""
    for path in ("missing.yaml", "sub"):
        assert run("waivers: []\n", "--waivers", path, "--format", form, "--fail-on", "never")[0] == 2
    code, _, err = run("waivers: [{id: W}]\n", "--fail-on", "never")
    assert code == 1
    assert "missing-key" in err
