"""Findings as text: for a terminal, as JSON, as annotations of GitHub, as SARIF. All of it pure."""
