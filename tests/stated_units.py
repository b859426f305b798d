"""Every unit that a dialect of pymavlink states, by hand: how much of another unit one of it is, and what it measures.

The amounts come from the definitions of the units and from the comments beside them in pymavlink's mavschema.xsd.
"""

from fractions import Fraction

_TEXT = """
s         1           s      time
ds        0.1         s      time
cs        0.01        s      time
ms        0.001       s      time
us        0.000001    s      time
ns        0.000000001 s      time
Hz        1           Hz     frequency
MHz       1000000     Hz     frequency
km        1000        m      length
dam       10          m      length
m         1           m      length
dm        0.1         m      length
cm        0.01        m      length
mm        0.001       m      length
m^2       1           m^2    area
cm^2      0.0001      m^2    area
m/s       1           m/s    speed
m/s*5     0.2         m/s    speed
dm/s      0.1         m/s    speed
cm/s      0.01        m/s    speed
mm/s      0.001       m/s    speed
mm/h      1/3600000   m/s    speed
m/s/s     1           m/s/s  acceleration
mG        0.00980665  m/s/s  acceleration
K         1           K      temperature
degC      1           K      temperature
cdegC     0.01        K      temperature
deg       1           deg    angle
deg/2     2           deg    angle
cdeg      0.01        deg    angle
degE5     0.00001     deg    angle
degE7     0.0000001   deg    angle
rad       180/pi      deg    angle
deg/s     1           deg/s  rotation
ddeg/s    0.1         deg/s  rotation
cdeg/s    0.01        deg/s  rotation
rad/s     180/pi      deg/s  rotation
mrad/s    0.18/pi     deg/s  rotation
rpm       6           deg/s  rotation
V         1           V      voltage
cV        0.01        V      voltage
mV        0.001       V      voltage
A         1           A      current
cA        0.01        A      current
mA        0.001       A      current
Ah        3600        C      charge
mAh       3.6         C      charge
W         1           W      power
hJ        100         J      energy
mT        0.001       T      magnetic_field
gauss     0.0001      T      magnetic_field
mgauss    0.0000001   T      magnetic_field
g         0.001       kg     mass
kg        1           kg     mass
g/min     1/60000     kg/s   mass_flow
Pa        1           Pa     pressure
hPa       100         Pa     pressure
kPa       1000        Pa     pressure
mbar      100         Pa     pressure
%         1           %      ratio
d%        0.1         %      ratio
c%        0.01        %      ratio
dB        1           dB     level
dBm       1           dBm    power_level
bytes     8           bits   data
KiB       8192        bits   data
MiB       8388608     bits   data
bits/s    1           bits/s data_rate
bytes/s   8           bits/s data_rate
KiB/s     8192        bits/s data_rate
MiB/s     8388608     bits/s data_rate
pix       1           pix    pixels
dpix      0.1         pix    pixels
cm^3      0.001       l      volume
l         1           l      volume
L         1           l      volume
cm^3/min  1/60000     l/s    flow
L/h       1/3600      l/s    flow
"""


def _stated(line: str) -> tuple[str, tuple[Fraction, int, str, str]]:
    name, amount, of, kind = line.split()
    numerator, _, denominator = amount.removesuffix("/pi").partition("/")
    factor = Fraction(numerator) / Fraction(denominator or "1")
    return name, (factor, -1 if amount.endswith("/pi") else 0, of, kind.replace("_", " "))


STATED = dict(_stated(line) for line in _TEXT.strip().splitlines())
"""Factor, power of pi, the unit that these count, and what is measured, by the unit's spelling in the dialects."""
