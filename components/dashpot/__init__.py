"""Code that the scenes about one mass on a spring and a dashpot share."""

from components.dashpot.case import DashpotCase
from components.dashpot.parameters import DashpotScene, keeping, parts
from components.dashpot.stage import NARROW_BELOW, apparatus
