"""Patterns are those of the standard library, compiled later; what they need is in every text in which they are found."""

import re
import re._constants as kinds
import re._parser as parser
from collections.abc import Iterator
