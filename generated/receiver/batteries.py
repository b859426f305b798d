# Generated from specs/board.yaml, specs/messages/battery_cell_voltages.yaml,
#   specs/messages/battery_info.yaml, specs/messages/battery_status.yaml,
#   specs/messages/battery_status_v2.yaml, specs/messages/smart_battery_info.yaml,
#   specs/parameters.yaml, specs/receiver.yaml, specs/state.yaml, specs/streams.yaml,
#   dialect common: do not edit.
# Inputs: d0b9364c748366ac
"""Batteries: what messages say about batteries, in units, one view for each, FR-00075.

The inverse of the tables that the firmware of pico-trail is made from. README.md has an example.
"""

import enum_names
import messages
from readings import added, entry, flags, is_entry, is_set, joined, page, plausible, scaled, single, text, values_of
from view import Info, View
from views import Views


def _read_battery_status(message):
    """Return what BATTERY_STATUS (147) says."""
    get = message.get
    raw = message.raw
    return {
        "consumed": get("current_consumed"),  # mAh
        "energy": get("energy_consumed"),  # hJ
        "temperature": scaled(get("temperature"), 1, 100),  # degC
        "current": scaled(get("current_battery"), 1, 100),  # A
        "battery_function": entry(enum_names.MAV_BATTERY_FUNCTION, get("battery_function")),
        "info.chemistry": entry(enum_names.MAV_BATTERY_TYPE, get("type")),
        "remaining": plausible(get("battery_remaining"), 0, 100),  # %
        "time_left": plausible(get("time_remaining"), 0, 1000000),  # s
        "is_charging": is_entry(get("charge_state"), 7),
        "mode": entry(enum_names.MAV_BATTERY_MODE, get("mode")),
        "fault_bitmask": flags(enum_names.MAV_BATTERY_FAULT, get("fault_bitmask")),
        "over_current": is_set(get("fault_bitmask"), 0x8),
        "hot": is_set(get("fault_bitmask"), 0x10),
        "cold": is_set(get("fault_bitmask"), 0x20),
        "cells": single(
            values_of(raw("voltages"), 0, 10, 65535, 1, 1000) + values_of(raw("voltages_ext"), 0, 4, 0, 1, 1000),
            65.534,
        ),  # V
        "voltage": scaled(
            added(joined(raw("voltages"), 0, 10, 65535), joined(raw("voltages_ext"), 0, 4, 0)),
            1,
            1000,
        ),  # V
    }


def _read_battery_status_v2(message):
    """Return what BATTERY_STATUS_V2 (369) says."""
    get = message.get
    return {
        "voltage": get("voltage"),  # V
        "current": get("current"),  # A
        "consumed": scaled(get("capacity_consumed"), 1000, 1),  # mAh
        "left": plausible(scaled(get("capacity_remaining"), 1000, 1), 0, None),  # mAh
        "remaining": plausible(get("state_of_charge"), 0, 100),  # %
        "status_flags": flags(enum_names.MAV_BATTERY_STATUS_FLAGS, get("status_flags")),
        "charging": is_set(get("status_flags"), 0x2),
        "protected": is_set(get("status_flags"), 0x80),
        "hot": is_set(get("status_flags"), 0x800),
        "cold": is_set(get("status_flags"), 0x1000),
        "over_current": is_set(get("status_flags"), 0x2000),
        "counted_from_full": is_set(get("status_flags"), 0x40000),
        "is_charging": is_set(get("status_flags"), 0x2),
        "temperature": scaled(get("temperature"), 1, 100),  # degC
    }


def _read_smart_battery_info(message):
    """Return what SMART_BATTERY_INFO (370) says."""
    get = message.get
    return {
        "info.capacity_full_specification": get("capacity_full_specification"),  # mAh
        "info.capacity_full": get("capacity_full"),  # mAh
        "info.cycle_count": get("cycle_count"),
        "info.weight": scaled(get("weight"), 1, 1000),  # kg
        "info.discharge_minimum_voltage": scaled(get("discharge_minimum_voltage"), 1, 1000),  # V
        "info.charging_minimum_voltage": scaled(get("charging_minimum_voltage"), 1, 1000),  # V
        "info.resting_minimum_voltage": scaled(get("resting_minimum_voltage"), 1, 1000),  # V
        "info.battery_function": entry(enum_names.MAV_BATTERY_FUNCTION, get("battery_function")),
        "info.chemistry": entry(enum_names.MAV_BATTERY_TYPE, get("type")),
        "info.serial_number": text(get("serial_number")),
        "info.name": text(get("device_name")),
        "info.charging_maximum_voltage": scaled(get("charging_maximum_voltage"), 1, 1000),  # V
        "info.cells": get("cells_in_series"),
        "info.discharge_maximum_current": scaled(get("discharge_maximum_current"), 1, 1000),  # A
        "info.discharge_maximum_burst_current": scaled(get("discharge_maximum_burst_current"), 1, 1000),  # A
        "info.manufacture_date": text(get("manufacture_date")),
    }


def _read_battery_info(message):
    """Return what BATTERY_INFO (372) says."""
    get = message.get
    return {
        "info.discharge_minimum_voltage": get("discharge_minimum_voltage"),  # V
        "info.charging_minimum_voltage": get("charging_minimum_voltage"),  # V
        "info.resting_minimum_voltage": get("resting_minimum_voltage"),  # V
        "info.charging_maximum_voltage": get("charging_maximum_voltage"),  # V
        "info.charging_maximum_current": get("charging_maximum_current"),  # A
        "info.nominal_voltage": get("nominal_voltage"),  # V
        "info.discharge_maximum_current": get("discharge_maximum_current"),  # A
        "info.discharge_maximum_burst_current": get("discharge_maximum_burst_current"),  # A
        "info.design_capacity": scaled(get("design_capacity"), 1000, 1),  # mAh
        "info.full_charge_capacity": scaled(get("full_charge_capacity"), 1000, 1),  # mAh
        "info.cycle_count": get("cycle_count"),
        "info.weight": scaled(get("weight"), 1, 1000),  # kg
        "info.battery_function": entry(enum_names.MAV_BATTERY_FUNCTION, get("battery_function")),
        "info.chemistry": entry(enum_names.MAV_BATTERY_TYPE, get("type")),
        "info.state_of_health": get("state_of_health"),  # %
        "info.cells": get("cells_in_series"),
        "info.manufacture_date": text(get("manufacture_date")),
        "info.serial_number": text(get("serial_number")),
        "info.name": text(get("name")),
    }


def _read_battery_cell_voltages(message):
    """Return what BATTERY_CELL_VOLTAGES (54371) says."""
    get = message.get
    raw = message.raw
    return {
        "cells": page(get("index"), values_of(raw("voltages"), 0, 12, 0, 1, 1000, keep=True)),  # V
    }


class BatteryInfo(Info):
    """The values that do not change as long as it is the same one; None while unknown."""

    @property
    def battery_function(self):
        """`battery_function` of BATTERY_INFO, SMART_BATTERY_INFO."""
        return self._fact("info.battery_function")

    @property
    def capacity_full(self):
        """`capacity_full` of SMART_BATTERY_INFO. Unit: mAh."""
        return self._fact("info.capacity_full")

    @property
    def capacity_full_specification(self):
        """`capacity_full_specification` of SMART_BATTERY_INFO. Unit: mAh."""
        return self._fact("info.capacity_full_specification")

    @property
    def cells(self):
        """`cells_in_series` of BATTERY_INFO, SMART_BATTERY_INFO."""
        return self._fact("info.cells")

    @property
    def charging_maximum_current(self):
        """`charging_maximum_current` of BATTERY_INFO. Unit: A."""
        return self._fact("info.charging_maximum_current")

    @property
    def charging_maximum_voltage(self):
        """`charging_maximum_voltage` of BATTERY_INFO, SMART_BATTERY_INFO. Unit: V."""
        return self._fact("info.charging_maximum_voltage")

    @property
    def charging_minimum_voltage(self):
        """`charging_minimum_voltage` of BATTERY_INFO, SMART_BATTERY_INFO. Unit: V."""
        return self._fact("info.charging_minimum_voltage")

    @property
    def chemistry(self):
        """`type` of BATTERY_INFO, SMART_BATTERY_INFO, BATTERY_STATUS."""
        return self._fact("info.chemistry")

    @property
    def cycle_count(self):
        """`cycle_count` of BATTERY_INFO, SMART_BATTERY_INFO."""
        return self._fact("info.cycle_count")

    @property
    def design_capacity(self):
        """`design_capacity` of BATTERY_INFO. Unit: mAh."""
        return self._fact("info.design_capacity")

    @property
    def discharge_maximum_burst_current(self):
        """`discharge_maximum_burst_current` of BATTERY_INFO, SMART_BATTERY_INFO. Unit: A."""
        return self._fact("info.discharge_maximum_burst_current")

    @property
    def discharge_maximum_current(self):
        """`discharge_maximum_current` of BATTERY_INFO, SMART_BATTERY_INFO. Unit: A."""
        return self._fact("info.discharge_maximum_current")

    @property
    def discharge_minimum_voltage(self):
        """`discharge_minimum_voltage` of BATTERY_INFO, SMART_BATTERY_INFO. Unit: V."""
        return self._fact("info.discharge_minimum_voltage")

    @property
    def full_charge_capacity(self):
        """`full_charge_capacity` of BATTERY_INFO. Unit: mAh."""
        return self._fact("info.full_charge_capacity")

    @property
    def manufacture_date(self):
        """`manufacture_date` of BATTERY_INFO, SMART_BATTERY_INFO."""
        return self._fact("info.manufacture_date")

    @property
    def name(self):
        """`name` of BATTERY_INFO, else `device_name` of SMART_BATTERY_INFO."""
        return self._fact("info.name")

    @property
    def nominal_voltage(self):
        """`nominal_voltage` of BATTERY_INFO. Unit: V."""
        return self._fact("info.nominal_voltage")

    @property
    def resting_minimum_voltage(self):
        """`resting_minimum_voltage` of BATTERY_INFO, SMART_BATTERY_INFO. Unit: V."""
        return self._fact("info.resting_minimum_voltage")

    @property
    def serial_number(self):
        """`serial_number` of BATTERY_INFO, SMART_BATTERY_INFO."""
        return self._fact("info.serial_number")

    @property
    def state_of_health(self):
        """`state_of_health` of BATTERY_INFO. Unit: %."""
        return self._fact("info.state_of_health")

    @property
    def weight(self):
        """`weight` of BATTERY_INFO, SMART_BATTERY_INFO. Unit: kg."""
        return self._fact("info.weight")


class BatteryView(View):
    """One battery of the rover. Each attribute is None while unknown."""

    MESSAGES = ("BATTERY_STATUS", "BATTERY_STATUS_V2", "SMART_BATTERY_INFO", "BATTERY_INFO", "BATTERY_CELL_VOLTAGES")
    STALE_MS = (10000, 10000, 60000, 60000, 10000)
    SILENT_MS = 10000
    WINDOW_MS = 30000
    CARRIERS = {
        "battery_function": (0,),
        "cells": (4, 0),
        "charging": (1,),
        "cold": (1, 0),
        "consumed": (1, 0),
        "counted_from_full": (1,),
        "current": (1, 0),
        "energy": (0,),
        "fault_bitmask": (0,),
        "hot": (1, 0),
        "info.battery_function": (3, 2),
        "info.capacity_full": (2,),
        "info.capacity_full_specification": (2,),
        "info.cells": (3, 2),
        "info.charging_maximum_current": (3,),
        "info.charging_maximum_voltage": (3, 2),
        "info.charging_minimum_voltage": (3, 2),
        "info.chemistry": (3, 2, 0),
        "info.cycle_count": (3, 2),
        "info.design_capacity": (3,),
        "info.discharge_maximum_burst_current": (3, 2),
        "info.discharge_maximum_current": (3, 2),
        "info.discharge_minimum_voltage": (3, 2),
        "info.full_charge_capacity": (3,),
        "info.manufacture_date": (3, 2),
        "info.name": (3, 2),
        "info.nominal_voltage": (3,),
        "info.resting_minimum_voltage": (3, 2),
        "info.serial_number": (3, 2),
        "info.state_of_health": (3,),
        "info.weight": (3, 2),
        "is_charging": (1, 0),
        "left": (1,),
        "mode": (0,),
        "over_current": (1, 0),
        "protected": (1,),
        "remaining": (1, 0),
        "status_flags": (1,),
        "temperature": (1, 0),
        "time_left": (0,),
        "voltage": (1, 0),
    }
    FLAGS = ("fault_bitmask", "status_flags")
    IS_COUNTED_ANEW = True
    ROLES = {
        "charging": (("is_charging", 1),),
        "consumed": (("consumed", 0.001),),
        "count": (("info.cells", 1),),
        "current": (("current", 1),),
        "cycles": (("info.cycle_count", 1),),
        "full": (("info.capacity_full", 0.001), ("info.full_charge_capacity", 0.001)),
        "left": (("left", 0.001),),
        "percent": (("remaining", 1),),
        "serial": (("info.serial_number", 1),),
    }

    def __init__(self, receiver, system, number):
        super().__init__(receiver, system, number)
        self.info = BatteryInfo(self)

    @property
    def battery_function(self):
        """`battery_function` of BATTERY_STATUS."""
        return self._quantity("battery_function")

    @property
    def cells(self):
        """Voltage of each cell, as a tuple. Unit: V."""
        return self._elements("cells")

    @property
    def charging(self):
        """Whether current flows into the pack."""
        return self._quantity("charging")

    @property
    def cold(self):
        """Whether the pack is colder than it may be while it is discharged."""
        return self._quantity("cold")

    @property
    def consumed(self):
        """Charge drawn since the start, or since the pack was put in. Unit: mAh."""
        return self._quantity("consumed")

    @property
    def counted_from_full(self):
        """Whether the charge that was drawn counts from a full pack, and not from power-on."""
        return self._quantity("counted_from_full")

    @property
    def current(self):
        """Current drawn from the pack, negative while charging. Unit: A."""
        return self._quantity("current")

    @property
    def energy(self):
        """Energy drawn since the start, or since the pack was put in. Unit: hJ."""
        return self._quantity("energy")

    @property
    def fault_bitmask(self):
        """The flags of `fault_bitmask` that are set, by their names, as a tuple."""
        return self._quantity("fault_bitmask")

    @property
    def hot(self):
        """Whether the pack is warmer than it may be while it is discharged."""
        return self._quantity("hot")

    @property
    def left(self):
        """Charge that is left of BATT_CAPACITY, where current is measured. Unit: mAh."""
        return self._quantity("left")

    @property
    def mode(self):
        """`mode` of BATTERY_STATUS."""
        return self._quantity("mode")

    @property
    def over_current(self):
        """Whether more is drawn than the pack stands for seconds."""
        return self._quantity("over_current")

    @property
    def protected(self):
        """Whether protective circuits in the pack are on."""
        return self._quantity("protected")

    @property
    def remaining(self):
        """Charge that is left, of a full pack. Unit: %."""
        return self._quantity("remaining")

    @property
    def status_flags(self):
        """The flags of `status_flags` that are set, by their names, as a tuple."""
        return self._quantity("status_flags")

    @property
    def temperature(self):
        """Temperature of the pack. Unit: degC."""
        return self._quantity("temperature")

    @property
    def time_left(self):
        """How long the charge is enough, as far as the last half minute tells. Unit: s."""
        return self._quantity("time_left")

    @property
    def voltage(self):
        """Voltage of the whole pack. Unit: V."""
        return self._quantity("voltage")


class Batteries(Views):
    """A view for each number of each system."""

    VIEW = BatteryView
    READERS = [
        (messages.BatteryStatus, "id", _read_battery_status),
        (messages.BatteryStatusV2, "id", _read_battery_status_v2),
        (messages.SmartBatteryInfo, "id", _read_smart_battery_info),
        (messages.BatteryInfo, "id", _read_battery_info),
        (messages.BatteryCellVoltages, "id", _read_battery_cell_voltages),
    ]
