"""Kinds of sensors, a folder for each: its keys, how it is resolved, its driver, its mock and its page.

``codegen/model/quantities/source_kind.py`` says what the stages ask a sensor. A folder has ``kind.py``, and MicroPython
in ``firmware`` (drivers), ``mocks`` and ``tests``, which is copied where a project has such a sensor. To add a kind,
list it here.
"""

from collections.abc import Mapping

from codegen.model.spec.source import SourceSpec
from codegen.sources.adc.spec import AdcSourceSpec
from codegen.sources.ina219.kind import INA219
from codegen.sources.ina226.kind import INA226
from codegen.sources.kind import KindOfSource
from codegen.sources.nmea.kind import NMEA
from codegen.sources.pulse.kind import PULSE
from codegen.sources.user.kind import USER

KINDS: Mapping[str, KindOfSource] = {kind.name: kind for kind in (INA219, INA226, NMEA, PULSE, USER)}
"""The kinds by the word that stands behind ``driver``."""

SPECS: Mapping[str, type[SourceSpec]] = {"adc": AdcSourceSpec, **{name: kind.spec for name, kind in KINDS.items()}}
"""The classes of their keys; inputs of the converter are channels before sensors are resolved (adc_sources.py)."""
