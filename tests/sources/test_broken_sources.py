"""Sensors and quantities that cannot be: each is reported at its place, with what to do."""

import cProfile
import pstats
import shutil
from pathlib import Path

import pytest

from codegen.cli import main

PROJECT = Path(__file__).resolve().parents[1] / "projects" / "minimal"

SONAR = "sonar: {driver: user, class: sonar.Sonar, unit: m, stored: mm, min: 0, max: 100}"
SHAKEN = "sonar: {driver: user, class: sonar.Sonar, unit: G, stored: mm/s/s, min: -16, max: 16}"
TWO = f"{SONAR}\n  far: {SONAR[7:].replace('mm', 'dm')}\ninstances:\n  boat: [{{}}, {{}}]"
DEPTH = "depth: {doc: Depth., unit: m, stored: mm, source: sonar}"
IMU = "imu: {driver: user, class: imu.Imu, outputs: {roll: {unit: rad, stored: mrad}, pitch: {unit: rad}}}"

INA = "power: {driver: ina226, i2c: 0, sda: 4, scl: 5, shunt: 2 mOhm}"
SOLAR = "\n  solar: {driver: ina219, i2c: 0, sda: 4, scl: 5, address: 0x41, shunt: 1 mOhm}"
OWN = "own: {driver: laser, gain: 2, fast: true, trigger: 3, i2c: 0, sda: 4, scl: 5}"
PLACED = "{driver: placed, i2c: 0, sda: 4, scl: 5, address: 0x40}"
PICO = "board: pico_2\n"
LASER = """\
class Laser:
    values = ()

    def __init__(self, opened, **keys):
        pass

    def begin(self):
        pass

    def poll(self, now_ms):
        pass
"""
DRIVER = """\
doc: A laser.
class: Laser
bus: i2c
keys:
  gain: {doc: g, min: 1, max: 4}
  fast: {doc: f, kind: boolean, default: false}
  trigger: {doc: t, kind: pin}
  name: {doc: n, kind: text, default: laser}
outputs:
  distance: {unit: m, stored: mm, min: 0, max: 100}
"""

GPS = PICO + "gps: {driver: nmea, uart: 1, tx: 8, rx: 9}"
SPEED = "speed: {doc: d, unit: m/s, source: gps.speed, stale_after: 1 s}"
AMPERES = "amperes: {driver: user, class: a.A, unit: A, stored: mA, min: -20, max: 20, rate: 10 Hz}"
VOLTS = "\n  volts: {driver: adc, gpio: 26, multiplier: 1, samples: 1, rate: 10 Hz}"
CURRENT = "current: {doc: d, unit: A, stored: mA, source: amperes, stale_after: 2 s}"
KELVINS = "water: {driver: adc, gpio: 26, multiplier: 100 K/V, offset: 0 V, samples: 1, rate: 10 Hz}"
WATER = "water: {doc: d, unit: degC, stored: cdegC, source: water, stale_after: 2 s}"
IN_KELVINS = WATER.replace("unit: degC, stored: cdegC", "unit: K, stored: cK")
MEASURED = "\n      voltage: {doc: d, unit: V, stored: mV, source: volts, stale_after: 2 s}"
CONSUMED = "\n      consumed: {doc: d, unit: mAh, integral_of: current}"
ENERGY = "\n      energy: {doc: d, unit: hJ, integral_of: current, times: voltage}"
LEFT = "\n      left: {doc: d, unit: mAh, left_of: FULL, after: consumed, min: 0}"
LASTS = "\n      lasting: {doc: d, unit: s, lasts: left, at: current, over: 250 ms, min: 0, max: 9000}"
SIZES = """\
parameters:
  FULL: {doc: d, unit: mAh, type: int32, default: 3300, min: 0, max: 9000, step: 1}
  SIZE: {doc: d, unit: mAh, type: int32, default: 3300, min: 0, max: 9000, step: 1, reboot: true}
"""

# What board.yaml says under sources, what the component boat of state.yaml has, and what is found.
CASES = [
    ("nothing is wrong", SONAR, DEPTH, []),
    ("kelvins for degC", PICO + KELVINS, WATER,
     ["error uncarried-conversion: 100 K/V makes K of a voltage, and from those to degC leads an offset",
      "hint: give it in degC/V, and as offset the voltage at 0 degC"]),
    ("degC for kelvins", PICO + KELVINS.replace("K/V", "degC/V"), IN_KELVINS,
     ["error uncarried-conversion: 100 degC/V makes degC of a voltage", "hint: give it in K/V"]),
    ("thousandths for degC", PICO + KELVINS.replace("100 K/V", "100000 mK/V"), WATER,
     ["100000 mK/V makes mK of a voltage"]),
    ("degC from their zero", PICO + KELVINS.replace("100 K/V, offset: 0 V", "100 degC/V, offset: 2.7315 V"), WATER, []),
    ("kelvins for K", PICO + KELVINS, IN_KELVINS, []),
    ("nothing for a volt", PICO + KELVINS.replace("100 K/V", "0 degC/V"), WATER,
     ["specs/board.yaml:3:46: error bad-amount: water is 0 whatever is measured: its multiplier is 0 degC/V"]),
    ("a quotient by nothing", PICO + KELVINS.replace("100 K/V", "360/0"), WATER,
     ["specs/board.yaml:3:46: error bad-amount: '360/0' is neither a parameter nor an amount"]),
    ("a trend of what code sets", SONAR, "depth: {doc: d, unit: m, stored: mm}\n"
     "      change: {doc: d, unit: m/s, stored: mm/s, trend_of: depth, window: 1 s}\n    update_rate: 10 Hz",
     ["bad-trend: depth is set by code, and a trend follows what the ADC of the component measures",
      "hint: write adc and multiplier at depth, or set change by code"]),
    ("a trend of a sensor in a component without a rate", SONAR, DEPTH.replace("}", ", stale_after: 1 s}")
     + "\n      change: {doc: d, unit: m/s, stored: mm/s, trend_of: depth, window: 1 s}",
     ["bad-trend: depth is given by a sensor, and a trend follows"]),
    ("for ever, but for an initial value", SONAR, DEPTH.replace("}", ", initial: 0}"),
     ["warning believed-for-ever: nothing makes boat.depth unknown", "hint: add invalid_after: 3"]),
    ("a trend of a sensor", SONAR, DEPTH.replace("}", ", stale_after: 1 s}")
     + "\n      change: {doc: d, unit: m/s, stored: mm/s, trend_of: depth, window: 1 s}\n    update_rate: 10 Hz",
     ["bad-trend: depth is given by a sensor, and a trend follows"]),
    ("a driver", SONAR.replace("user", "usr"), DEPTH, ["2:19: error unknown-driver: there is no driver usr", "user"]),
    ("a key", SONAR.replace("min", "mni"), "", ["error unknown-key: unknown key 'mni'", "did you mean min"]),
    ("a class", SONAR.replace("sonar.Sonar", "Sonar"), DEPTH, ["bad-source-driver: Sonar is no class of a module"]),
    ("a name", SONAR.replace("sonar:", "Sonar:"), "", ["2:3: error bad-source-driver: Sonar cannot be the name"]),
    *((f"what all sensors have: {name}", SONAR.replace("sonar:", f"{name}:"), "",
       [f"2:3: error bad-source-driver: {name} cannot be the name"]) for name in ("every", "turn", "watch")),
    ("a rate", SONAR.replace("}", ", rate: 2000 Hz}"), DEPTH, ["bad-time: 2000 Hz is not a rate"]),
    ("steps of another instance", TWO,
     "depth: {doc: d, unit: m, source: [far, sonar], stale_after: 1 s}",
     ["warning coarse-quantity: boat.depth is kept in dm as far gives it, and sonar gives mm", "hint: stored: mm"]),
    ("steps of another instance, meant", TWO,
     "depth: {doc: d, unit: m, stored: dm, source: [far, sonar], stale_after: 1 s}", []),
    ("a slow rate", SONAR.replace("}", ", rate: 0.001 Hz}"), DEPTH, ["bad-source-driver: sonar is asked less than"]),
    ("a step", SONAR.replace("mm", "ms"), DEPTH, ["error unit-mismatch: m cannot be rounded to ms"]),
    ("a step with pi between", SONAR.replace("unit: m, stored: mm", "unit: rad, stored: cdeg"), "",
     ["error uncarried-conversion: rad cannot be rounded to cdeg", "hint: stored: urad, to which a factor leads"]),
    ("a step with an offset between", SONAR.replace("unit: m, stored: mm", "unit: degC, stored: cK"), "",
     ["error uncarried-conversion: degC cannot be rounded to cK", "hint: stored: cdegC, to which a factor leads"]),
    ("a step that nothing is as fine as", SONAR.replace("unit: m, stored: mm", "unit: rev, stored: mrad"), "",
     ["error uncarried-conversion", "hint: write a unit to which a factor leads from rev"]),
    ("a sum of whole units", AMPERES.replace("stored: mA, ", ""), f"{CURRENT}{CONSUMED}",
     ["2:3: warning coarse-quantity: amperes is rounded to whole A where it is read, and boat.consumed is summed up",
      "hint: stored: mA at the output, or stored: A if whole units are meant"]),
    ("limits between two steps", SONAR.replace("100", "0.1234").replace("min: 0", "min: -0.0016"), DEPTH, []),
    ("limits in another unit", SHAKEN,
     "x: {doc: d, unit: mm/s/s, source: sonar, min: -156906, max: 156906, stale_after: 1 s}", []),
    ("limits go to the nearest step", SONAR.replace("100", "0.1236").replace("min: 0", "min: -0.0016"),
     DEPTH.replace("}", ", min: -0.001, max: 0.123, stale_after: 1 s}"),
     ["source-beyond-limits: sonar gives boat.depth -2 to 124 mm"]),
    ("a limit", SONAR.replace("100", "5000000"), DEPTH,
     ["bad-source-driver: max is 5000000000 steps of mm, more than the 32 bits",
      "hint: narrow min and max, or take a coarser unit for stored"]),
    ("limits", SONAR.replace("100", "-1"), DEPTH, ["bad-source-driver: max is below min"]),
    ("both", IMU.replace("outputs", "unit: m, outputs"), "",
     ["unit is that of a single number, and there are outputs"]),
    ("an output", IMU.replace("roll:", "Roll:"), "", ["Roll cannot be the name of an output"]),
    ("an aspect", SONAR.replace("}", ", criteria: {speed: FR-1}}"), DEPTH,
     ["unknown-aspect: there is no aspect speed"]),
    ("a source", SONAR, DEPTH.replace("source: sonar", "source: sonr"),
     ["error unknown-source: board.yaml has no sensor sonr", "did you mean sonar?"]),
    ("no part", IMU, "roll: {doc: d, unit: rad, source: imu}",
     ["error unknown-source: imu gives several numbers: roll, pitch", "hint: imu.roll"]),
    ("a part", IMU, "roll: {doc: d, unit: rad, source: imu.rol}", ["imu gives no rol", "did you mean roll?"]),
    ("a part of one", SONAR, DEPTH.replace("source: sonar", "source: sonar.depth"),
     ["gives no depth", "hint: sonar\n"]),
    ("an only one", PICO + OWN, "depth: {doc: d, unit: m, stored: mm, source: own, stale_after: 1 s}", []),
    ("one that nobody takes", f"{SONAR}\n  far: {SONAR[7:]}", DEPTH,
     ["3:3: warning unused-sensor: no quantity has the sensor far as its source", "hint: write source: far"]),
    ("an only one by its name", PICO + OWN, DEPTH.replace("source: sonar", "source: own.distance"), []),
    ("an only one that is summed up", AMPERES.replace("unit: A, stored: mA, min: -20, max: 20",
     "outputs: {drawn: {unit: A, stored: mA, min: -20, max: 20}}"), f"{CURRENT}{CONSUMED}", []),
    ("a list", SONAR, DEPTH.replace("source: sonar", "source: [sonar, sonar]"),
     ["boat has 1 instances, and depth 2 sources", "hint: a list has one for each: [depth_1]"]),
    ("a unit", SONAR, "depth: {doc: d, unit: s, stored: ms, source: sonar}",
     ["unit-mismatch: sonar is in mm, not in ms"]),
    ("a boolean", SONAR, "wet: {doc: d, boolean: true, initial: false, source: sonar}",
     ["error bad-sourced: wet is a boolean quantity, and a sensor gives numbers"]),
    ("elements", SONAR, "depth: {doc: d, unit: m, stored: mm, elements: 3, source: sonar}",
     ["bad-elements: a quantity with elements has numbers that other code sets, and no source"]),
    ("initial and stale", SONAR, "depth: {doc: d, unit: m, stored: mm, initial: 0, stale_after: 1 s, source: sonar}",
     ["bad-quantity: depth has an initial value in place of unknown, so stale_after says nothing"]),
    ("too fine", SONAR.replace("mm", "km").replace("100", "1000"),
     "depth: {doc: d, unit: m, stored: nm, source: sonar, min: 0, max: 0.1}",
     ["bad-sourced: sonar * 1000000000000 needs numbers of more than 30 bits"]),
    ("finer than anything that it could give", SONAR.replace("mm, min: 0, max: 100", "m"),
     "depth: {doc: d, unit: m, stored: mm, source: sonar, stale_after: 1 s}",
     ["bad-sourced: sonar * 1000 needs numbers of more than 30 bits: it goes from -1073741823 to 1073741823",
      "hint: say what is plausible: min and max of sonar in board.yaml"]),
    ("no board", "gps: {driver: nmea, uart: 1, tx: 8, rx: 9}", "", ["UART 1 is on no known board", "board: pico_2_w"]),
    ("a UART", PICO + "gps: {driver: nmea, uart: 3, tx: 8, rx: 9}", "",
     ["the Raspberry Pi Pico 2 has UART 0 and 1 for sensors, and no UART 3"]),
    ("a pin", PICO + "gps: {driver: nmea, uart: 1, tx: 9, rx: 9}", "",
     ["3:36: error bad-source-driver: tx of UART 1 is GPIO 4", "not 9"]),
    ("a silence", PICO + "gps: {driver: nmea, uart: 1, tx: 8, rx: 9, silence: 3}", "", ["wrong-type: silence wants"]),
    ("an I2C bus", PICO + INA.replace("i2c: 0", "i2c: 2"), "", ["has I2C 0 and 1, and no I2C 2"]),
    ("a clock", PICO + INA.replace("}", ", frequency: 5 MHz}"), "", ["5 MHz is no clock of 10 kHz to 1 MHz"]),
    ("a shunt", PICO + INA.replace("2 mOhm", "2 kOhm"), "", ["a shunt of 2 kOhm is not one of"]),
    ("no shunt", PICO + INA.replace("2 mOhm", "2 mV"), "", ["unit-mismatch: 2 mV is a voltage"]),
    ("an address", PICO + INA.replace("}", ", address: 0x50}"), "", ["0x50 is no address of an INA226"]),
    ("an average", PICO + INA.replace("}", ", average: 3}"), "", ["does not average 3 conversions", "known: 1, 4, 16"]),
    ("a taken pin", PICO + "log: {driver: pulse, gpio: 25}", "",
     ["not 25: the Raspberry Pi Pico 2 needs it for the LED\n  hint: gpio: 26"]),
    ("a gate", PICO + "log: {driver: pulse, gpio: 2, gate: 2 min}", "", ["gate is 120000, not 1 to 60000"]),
    ("a shared pin", PICO + INA + "\n  log: {driver: pulse, gpio: 4}", "",
     ["4:30: error shared-pin: sda of power and gpio of log are both on GPIO 4", "gpio: 0"]),
    ("a shared bus", PICO + INA + SOLAR, "",

     []),
    ("a shared address", PICO + INA + "\n  solar: {driver: ina219, i2c: 0, sda: 4, scl: 5, shunt: 1 mOhm}", "",
     ["error shared-port: power and solar both take address 0x40 of I2C 0"]),
    ("another bus", PICO + INA + SOLAR.replace("sda: 4", "sda: 8"), "",

     ["shared-port: SDA of I2C 0 is GPIO 4 for power, and GPIO 8 for solar", "hint: sda: 4"]),
    ("the address of own drivers", PICO + f"one: {PLACED}\n  two: {PLACED}", "",
     ["4:58: error shared-port: one and two both take address 0x40 of I2C 0", "hint: give two another address"]),
    ("the address of an own driver and another", PICO + INA + f"\n  own: {PLACED}", "",
     ["4:58: error shared-port: power and own both take address 0x40 of I2C 0"]),
    ("another address", PICO + INA + f"\n  own: {PLACED.replace('0x40', '0x41')}", "", []),
    ("one address on another bus", PICO + INA
     + f"\n  own: {PLACED.replace('i2c: 0, sda: 4, scl: 5', 'i2c: 1, sda: 6, scl: 7')}", "", []),
    ("an address that is not said", PICO + INA.replace("}", ", address: 0x42}")
     + f"\n  own: {PLACED.replace(', address: 0x40', '')}", "",
     ["4:3: error shared-port: power and own both take address 0x42 of I2C 0"]),
    ("another clock", PICO + INA.replace("}", ", frequency: 100 kHz}") + SOLAR, "",
     ["4:3: error shared-port: I2C 0 runs at 100 kHz for power, and at 400 kHz for solar",
      "hint: frequency: 100 kHz"]),
    ("another clock behind", PICO + INA + SOLAR.replace("}", ", frequency: 50 kHz}"), "",
     ["3:3: error shared-port: I2C 0 runs at 50 kHz for solar, and at 400 kHz for power"]),
    ("one clock", PICO + INA.replace("}", ", frequency: 100 kHz}") + SOLAR.replace("}", ", frequency: 0.1 MHz}"), "",
     []),
    ("another bus with another clock", PICO + INA.replace("}", ", frequency: 100 kHz}")
     + SOLAR.replace("i2c: 0, sda: 4, scl: 5", "i2c: 1, sda: 6, scl: 7"), "", []),
    ("the clock of an own driver", PICO + OWN.replace("}", ", frequency: 100 kHz}") + SOLAR, "",
     ["error shared-port: I2C 0 runs at 100 kHz for own, and at 400 kHz for solar"]),
    ("no clock of an own driver", PICO + OWN.replace("}", ", frequency: 100 s}"), "",
     ["3:92: error unit-mismatch: 100 s is a time"]),
    ("too fast a clock of an own driver", PICO + OWN.replace("}", ", frequency: 5 MHz}"), "",
     ["3:92: error bad-source-driver: 5 MHz is no clock of 10 kHz to 1 MHz", "hint: frequency: 400 kHz"]),
    ("a shared UART", PICO + "a: {driver: nmea, uart: 1, tx: 8, rx: 9}\n  b: {driver: nmea, uart: 1, tx: 4, rx: 5}", "",
     ["4:27: error shared-port: a and b both take UART 1"]),
    ("too soon", SONAR, DEPTH.replace("}", ", stale_after: 100 ms}"),
     ["error stale-before-reading: boat.depth is old after 100 ms, and sonar is asked every 100 ms"]),
    ("before a conversion", PICO + INA.replace("}", ", average: 512}"),
     CURRENT.replace("amperes, stale_after: 2 s", "power.current, stale_after: 1.3 s") + CONSUMED,
     ["error stale-before-reading: boat.current is old after 1300 ms, and power gives a new value every 1300 ms",
      "hint: stale_after: 3900 ms, so that one failure changes nothing, or another average of power"]),
    ("after a conversion", PICO + INA.replace("}", ", average: 512}"),
     CURRENT.replace("amperes, stale_after: 2 s", "power.current, stale_after: 1301 ms") + CONSUMED, []),
    ("a conversion of an INA219", PICO + SOLAR.strip().replace("}", ", average: 128, rate: 100 Hz}"),
     "volts: {doc: d, unit: V, source: solar.voltage, stale_after: 160 ms}",
     ["stale-before-reading: boat.volts is old after 160 ms, and solar gives a new value every 160 ms"]),
    ("before a fix", GPS, SPEED,
     ["error stale-before-reading: boat.speed is old after 1000 ms, and gps gives a new value every 1100 ms",
      "hint: stale_after: 3300 ms, so that one failure changes nothing, or another fixes of gps"]),
    ("after a fix", GPS, SPEED.replace("1 s", "1.2 s"), []),
    ("after one of five", GPS.replace("}", ", fixes: 5 Hz}"), SPEED, []),
    ("no rate of fixes", GPS.replace("}", ", fixes: 2000 Hz}"), "", ["bad-time: 2000 Hz is not a rate"]),
    ("a small buffer", GPS.replace("}", ", baud: 115200, buffer: 512}"), "",
     ["3:68: error bad-source-driver: 576 bytes come between two turns at 115200 bits per second, and 512 have room",
      "hint: buffer: 1152, or a higher rate"]),
    ("a buffer for a fast line", GPS.replace("}", ", baud: 115200, buffer: 576}"), "", []),
    ("a fast line that is asked seldom", GPS.replace("}", ", baud: 115200, rate: 0.1 Hz}"), "",
     ["3:66: error bad-source-driver: 115200 bytes come between two turns at 115200 bits", "hint: rate: 20 Hz"]),
    ("a fast line", GPS.replace("}", ", baud: 115200}"), "", []),
    ("silent between two", GPS.replace("}", ", fixes: 0.25 Hz}"), "",
     ["bad-source-driver: it counts as failed after 3000 ms, before a fix comes every 4000 ms", "silence: 12000 ms"]),
    ("for ever", SONAR, DEPTH, ["warning believed-for-ever: nothing makes boat.depth unknown when sonar fails"]),
    ("beyond", SONAR, DEPTH.replace("}", ", min: 0, max: 50, invalid_after: 3}"),
     ["error source-beyond-limits: sonar gives boat.depth 0 to 100000 mm, and the limits of boat.depth leave 0 to",
      "hint: widen min and max of boat.depth, or narrow min and max of sonar\n"]),
    ("no driver file", PICO + "own: {driver: lase, address: 1}", "",
     ["error unknown-driver: there is no driver lase\n  hint: did you mean laser or pulse or placed?"]),
    ("an own driver", PICO + OWN, "", []),
    ("a key of it", PICO + OWN.replace("gain", "gian"), "", ["no key gian", "did you mean gain?"]),
    ("a missing key", PICO + OWN.replace("gain: 2, ", ""), "", ["gain is missing, which the driver laser needs"]),
    ("a number", PICO + OWN.replace("gain: 2", "gain: two"), "",
     ["3:30: error bad-source-driver: gain is two, no whole"]),
    ("too large", PICO + OWN.replace("gain: 2", "gain: 9"), "", ["gain is 9, not 1 to 4"]),
    ("a boolean key", PICO + OWN.replace("fast: true", "fast: 1"), "", ["fast is 1, no boolean"]),
    ("a pin key", PICO + OWN.replace("trigger: 3", "trigger: 40"), "", ["trigger is GPIO 0 to 22", "not 40"]),
    ("its bus", PICO + OWN.replace("sda: 4", "sda: 5"), "", ["sda of I2C 0 is GPIO", "not 5"]),
    ("no bus", PICO + OWN.replace("sda: 4, ", ""), "", ["sda is missing"]),
    ("its pins", PICO + OWN.replace("trigger: 3", "trigger: 5"), "",
     ["shared-pin: scl of own and keys.trigger of own are both on GPIO 5"]),
    ("two derivations", SONAR, "depth: {doc: d, unit: m, stored: mm, source: sonar, trend_of: depth, window: 1 s}",
     ["the value of depth has one source, not both"]),
    ("sums", AMPERES, f"{CURRENT}{CONSUMED}", []),
    ("a sum without an end", AMPERES, f"{CURRENT.replace(', stale_after: 2 s', ', invalid_after: 3')}{CONSUMED}",
     ["error bad-integral: current has no stale_after", "hint: write stale_after at current"]),
    ("a sum of anything", AMPERES.replace(", min: -20, max: 20", ""), f"{CURRENT}{CONSUMED}",
     ["error allocating-arithmetic: boat.consumed: counting it reaches", "a smaller max of its parameters or of its"]),
    ("a sum of what code sets", AMPERES, f"{CURRENT.replace('source: amperes, ', '')}{CONSUMED}",
     ["error bad-integral: current is not measured, by an ADC or another sensor"]),
    ("a sum of two kinds", PICO + AMPERES + VOLTS, f"{CURRENT}{MEASURED}{ENERGY}",
     ["error bad-integral: an ADC measures one of current and voltage, and another sensor gives the other"]),
    ("a store that changes", AMPERES, f"{CURRENT}{CONSUMED}{LEFT}",
     ["error bad-remainder: FULL can change at any time", "hint: reboot: true at FULL"]),
    ("a time of half a reading", AMPERES, f"{CURRENT}{CONSUMED}{LEFT.replace('FULL', 'SIZE')}{LASTS}",
     ["error bad-remainder: 250 ms is not 1 to 1000 readings"]),
    ("a sensor with a fault, and a time that is counted in its readings", PICO + INA.replace("2 mOhm", "0 mOhm"),
     f"{CURRENT.replace('amperes', 'power.current')}{CONSUMED}{LEFT.replace('FULL', 'SIZE')}{LASTS}", ["0 mOhm"]),
    ("a limit of a whole turn", SONAR.replace("}", ", rate: 10 Hz, limit: 100 ms}"), DEPTH, []),
    ("a limit beyond a turn", SONAR.replace("}", ", rate: 10 Hz, limit: 101 ms}"), DEPTH,
     ["bad-source-driver: sonar may take 101 ms each time, and is asked every 100 ms", "hint: limit: 100 ms at most"]),
    ("an amount in digits of another script", PICO + KELVINS.replace("100 K", "\u0663 K"), WATER,
     ["error bad-amount: '\u0663 K/V' is neither a parameter nor an amount"]),
    ("a number in digits of another script", PICO + KELVINS.replace("100 K/V", "\u0663"), WATER,
     ["error bad-amount: '\u0663' is neither a parameter nor an amount"]),
    ("fixes that no line brings", GPS.replace("}", ", baud: 4800, fixes: 10 Hz}"), "",
     ["bad-source-driver: 10 Hz do not come over a line of 4800 bits per second: 70 bytes of one sentence each need",
      "7000 bits per second", "hint: baud: 38400, as the receiver has to be set up, or fixes: 1.7 Hz"]),
    ("fixes that come with fewer sentences", GPS.replace("}", ", baud: 9600, fixes: 5 Hz}"), "",
     ["warning crowded-receiver: 5 Hz over a line of 9600 bits per second leave out sentences: GGA, RMC, GSA and VTG, "
      "280 bytes, need 14000", "hint: baud: 19200"]),
    ("fixes that fit", GPS.replace("}", ", baud: 19200, fixes: 5 Hz}"), "", []),
    ("steps beyond the range", SONAR.replace("min: 0, max: 100", "min: 0.2, max: 40"),
     DEPTH.replace("mm", "km").replace("}", ", stale_after: 1 s}"),
     ["error single-step-quantity: boat.depth is always 0 km: it goes from 0.2 to 40 m, and is kept in whole km",
      "hint: stored: mm"]),
    ("two steps in the range", SONAR.replace("min: 0, max: 100", "min: 0.2, max: 501"),
     DEPTH.replace("mm", "km").replace("}", ", stale_after: 1 s}"), []),
    ("an output of coarser steps", SONAR.replace("stored: mm", "stored: m"),
     DEPTH.replace("mm", "cm").replace("}", ", stale_after: 1 s}"),
     ["warning coarse-quantity: sonar is rounded to whole m, and boat.depth is kept in cm",
      "hint: stored: cm at the output, or stored: m at the quantity"]),
]  # fmt: skip


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = Path(shutil.copytree(PROJECT, tmp_path_factory.mktemp("broken") / "project"))
    (folder / "specs" / "drivers").mkdir()
    (folder / "specs" / "drivers" / "laser.yaml").write_text(DRIVER)
    (folder / "specs" / "parameters.yaml").write_text(SIZES)
    placed = DRIVER.partition("keys:")[0] + "keys: {address: {doc: a, default: 0x42}}\noutputs: {distance: {unit: m}}\n"
    (folder / "specs" / "drivers" / "placed.yaml").write_text(placed)
    (folder / "specs" / "drivers" / "placed.py").write_text(LASER)
    (folder / "specs" / "drivers" / "laser.py").write_text(LASER)
    return folder


@pytest.mark.parametrize(("sources", "quantity", "expected"), [case[1:] for case in CASES], ids=[c[0] for c in CASES])
def test_is_reported(sources, quantity, expected, folder, monkeypatch, capsys):
    """The place, the rule, the words and the hint; no other error follows from it."""
    specs = PROJECT / "specs"
    board = PICO if sources.startswith(PICO) else ""
    (folder / "specs" / "board.yaml").write_text(f"{board}sources:\n  {sources.removeprefix(PICO)}\n")
    own = f"  boat:\n    doc: d\n    quantities:\n      {quantity or 'x: {doc: d, initial: 0}'}\n"
    (folder / "specs" / "state.yaml").write_text((specs / "state.yaml").read_text() + own)
    monkeypatch.chdir(folder)
    code = main(["check"])
    told = capsys.readouterr().out
    errors = [] if "warning" in " ".join(expected) else expected
    assert code == (1 if errors else 0), told
    for words in expected:
        assert words in told
    assert told.count(": error ") == bool(errors), told


def test_work_grows_as_the_number_of_wrong_outputs(folder, monkeypatch):
    """Calls are counted: from n outputs that cannot be to 2 n as many more as from none to n."""
    (folder / "specs" / "state.yaml").write_text((PROJECT / "specs" / "state.yaml").read_text())
    monkeypatch.chdir(folder)

    def calls(count):
        outputs = ", ".join(f"N{number}: {{unit: rad}}" for number in range(count))
        (folder / "specs" / "board.yaml").write_text(
            f"sources:\n  imu: {{driver: user, class: imu.Imu, outputs: {{{outputs}}}}}\n"
        )
        profile = cProfile.Profile()
        assert profile.runcall(main, ["check"]) == 1
        return pstats.Stats(profile).total_calls

    calls(1)  # imports
    few, some, many = (calls(number) for number in (1, 400, 800))
    assert (many - some) < 1.25 * (some - few)


def test_a_driver_whose_outputs_cannot_be_read_is_one_finding(folder, monkeypatch, capsys):
    """What takes a number of it says nothing more."""
    driver = folder / "specs" / "drivers" / "laser.yaml"
    driver.write_text(DRIVER.replace("{unit: m, stored: mm, min: 0, max: 100}", "fix.yaw"))
    (folder / "specs" / "board.yaml").write_text(f"{PICO}sources:\n  {OWN}\n")
    depth = "  boat:\n    doc: d\n    quantities:\n      depth: {doc: d, unit: m, stored: mm, source: own.distance}\n"
    (folder / "specs" / "state.yaml").write_text((PROJECT / "specs" / "state.yaml").read_text() + depth)
    monkeypatch.chdir(folder)
    code = main(["check"])
    driver.write_text(DRIVER)
    told = capsys.readouterr().out
    assert (code, told.count(": error ")) == (1, 1), told
    assert "specs/drivers/laser.yaml:10:13: error wrong-type: a mapping is wanted here" in told


def test_a_driver_says_the_clock_of_its_bus(folder, monkeypatch, capsys):
    """Its sensors have it unless they say another one, and it is that of the bus that is opened."""
    driver = folder / "specs" / "drivers" / "laser.yaml"
    driver.write_text(DRIVER.replace("bus: i2c", "bus: i2c\nfrequency: 50 kHz"))
    (folder / "specs" / "state.yaml").write_text((PROJECT / "specs" / "state.yaml").read_text())
    monkeypatch.chdir(folder)
    found = []
    for said in ("", ", frequency: 400 kHz"):
        (folder / "specs" / "board.yaml").write_text(f"{PICO}sources:\n  {OWN.replace('}', said + '}')}{SOLAR}\n")
        found.append((main(["check"]), capsys.readouterr().out))
    (folder / "specs" / "board.yaml").write_text(f"{PICO}sources:\n  {OWN}\n")
    built = main(["build"])
    driver.write_text(DRIVER)
    opened = (folder / "generated" / "firmware" / "sources.py").read_text()
    shutil.rmtree(folder / "generated")
    assert [code for code, _ in found] == [1, 0]
    assert "shared-port: I2C 0 runs at 50 kHz for own, and at 400 kHz for solar" in found[0][1]
    assert built == 0
    assert "machine.I2C(0, sda=machine.Pin(4), scl=machine.Pin(5), freq=50000)" in opened


@pytest.mark.parametrize(
    ("baud", "rate", "room", "taken"),
    [
        (9600, "20 Hz", 512, ""),
        (38400, "20 Hz", 512, ",240,"),
        (115200, "20 Hz", 1152, ",720,"),
        (115200, "90 Hz", 512, ",160,"),
    ],
)
def test_a_receiver_takes_what_its_line_brings(baud, rate, room, taken, folder, monkeypatch):
    """A turn takes a quarter more than comes at this speed until the next one, and twice as much may wait."""
    gps = f"gps: {{driver: nmea, uart: 1, tx: 8, rx: 9, baud: {baud}, rate: {rate}}}"
    (folder / "specs" / "board.yaml").write_text(f"{PICO}sources:\n  {gps}\n")
    (folder / "specs" / "state.yaml").write_text((PROJECT / "specs" / "state.yaml").read_text())
    monkeypatch.chdir(folder)
    assert main(["build"]) == 0
    made = (folder / "generated" / "firmware" / "sources.py").read_text()
    shutil.rmtree(folder / "generated")
    assert f"timeout=0,rxbuf={room}){taken})," in "".join(made.split()), made


def test_a_link_and_a_sensor_on_one_uart(folder, monkeypatch, capsys):
    """One UART is one part's, whichever kind of part that is."""
    gps = "a: {driver: nmea, uart: 1, tx: 8, rx: 9, baud: 9600}"
    radio = "links:\n  radio: {uart: 1, tx: 4, rx: 5, baud: 57600}\n"
    (folder / "specs" / "board.yaml").write_text(f"{PICO}sources:\n  {gps}\n{radio}")
    (folder / "specs" / "state.yaml").write_text((PROJECT / "specs" / "state.yaml").read_text())
    monkeypatch.chdir(folder)
    assert main(["check"]) == 1
    assert "error shared-port: radio and a both take UART 1" in capsys.readouterr().out


def test_a_broken_driver_is_one_finding_whatever_its_sensors_say(folder, monkeypatch, capsys):
    """Keys of a bus that could not be read are not unknown ones."""
    driver = folder / "specs" / "drivers" / "laser.yaml"
    driver.write_text(DRIVER.replace("bus: i2c", "bus: spi"))
    (folder / "specs" / "board.yaml").write_text(f"{PICO}sources:\n  {OWN}\n")
    (folder / "specs" / "state.yaml").write_text((PROJECT / "specs" / "state.yaml").read_text())
    monkeypatch.chdir(folder)
    code = main(["check"])
    driver.write_text(DRIVER)
    told = capsys.readouterr().out
    assert (code, told.count(": error ")) == (1, 1), told
    assert "specs/drivers/laser.yaml:3:6: error unknown-choice: bus is 'spi', not i2c or uart" in told


def test_a_link_on_a_pin_that_the_board_needs_says_what_for_and_which_is_near(folder, monkeypatch, capsys):
    links = "board: esp32_s3\nlinks:\n  radio: {uart: 1, tx: 17, rx: 19, baud: 57600}\n"
    (folder / "specs" / "board.yaml").write_text(links)
    (folder / "specs" / "state.yaml").write_text((PROJECT / "specs" / "state.yaml").read_text())
    monkeypatch.chdir(folder)
    assert main(["check"]) == 1
    told = capsys.readouterr().out
    assert "not 19: the ESP32-S3 development board needs it for USB\n  hint: rx: 18\n" in told
