"""The dialect of a project: its files, overlays and corrections as one."""
