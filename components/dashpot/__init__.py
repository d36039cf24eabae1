"""A mass on a spring and a dashpot: what the scenes about it share."""

from components.dashpot.case import DashpotCase
from components.dashpot.parameters import DashpotScene, keeping, parts
from components.dashpot.stage import NARROW_BELOW, apparatus
