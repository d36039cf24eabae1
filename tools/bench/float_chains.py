"""The two-mass chain in plain float64, with which the accuracy table compares.

Every class answers the same questions: modes() -> (omega, ratio, beat), particular(F_0, omega) -> (Xp1, Xp2),
free(x_0, v_0, t) and driven(F_0, omega, t) -> x1, x2, e2, v1, v2.
"""

import numpy as np
import scipy.linalg

from physics.coupled import TwoMassChain, free_motion
from physics.forced import forced_motion, particular_solution
from tests.physics.truth import rows


class Project:
    """The forms of this project."""

    name = "this project"

    def __init__(self, parameters):
        self.chain = TwoMassChain(**dict(zip(("m1", "m2", "k1", "k2"), parameters, strict=True)))

    def modes(self):
        modes = self.chain.modes()
        return modes.omega, modes.ratio, modes.beat

    def particular(self, F_0, omega):
        return particular_solution(self.chain, F_0, omega)

    def free(self, x_0, v_0, t):
        return rows(free_motion(self.chain, x_0, v_0, t))

    def driven(self, F_0, omega, t):
        return rows(forced_motion(self.chain, F_0, omega, t))


class FloatModes:
    """Motions from frequencies and mode shapes found in float64, however they were found."""

    def __init__(self, parameters):
        self.parameters = np.array(parameters)
        self.omega, self.shape = self.solve(*self.parameters)  # shape[mode, mass]
        self.mass = self.shape**2 @ self.parameters[:2]

    def modes(self):
        return self.omega, self.shape[:, 1] / self.shape[:, 0], self.omega[1] - self.omega[0]

    def free(self, x_0, v_0, t):
        m = self.parameters[:2]
        q, p = self.shape @ (m * x_0) / self.mass, self.shape @ (m * v_0) / self.mass
        size, phase = np.hypot(q, p / self.omega), np.arctan2(q * self.omega, p)
        turn = np.outer(self.omega, t) + phase[:, np.newaxis]
        return self._together(size[:, np.newaxis] * np.sin(turn), (size * self.omega)[:, np.newaxis] * np.cos(turn))

    def driven(self, F_0, omega, t):
        """Complementary plus particular, mode by mode."""
        w, share = self.omega[:, np.newaxis], (F_0 * self.shape[:, 0] / self.mass)[:, np.newaxis]
        share = share / (w**2 - omega**2)
        g = np.sin(omega * t) - omega / w * np.sin(w * t)
        return self._together(share * g, share * omega * (np.cos(omega * t) - np.cos(w * t)))

    def _together(self, q, p):
        x, v = self.shape.T @ q, self.shape.T @ p
        return [x[0], x[1], x[1] - x[0], v[0], v[1]]

    def particular(self, F_0, omega):
        m1, m2, _, k2 = self.parameters
        D = m1 * m2 * (omega**2 - self.omega[0] ** 2) * (omega**2 - self.omega[1] ** 2)
        return (k2 - m2 * omega**2) * F_0 / D, k2 * F_0 / D


class Slides(FloatModes):
    """The formulas as written on the slides."""

    name = "slides in float64"

    def solve(self, m1, m2, k1, k2):
        b = m1 * k2 + m2 * (k1 + k2)
        root = np.sqrt(b**2 - 4 * m1 * m2 * k1 * k2)
        omega = np.sqrt(np.array([b - root, b + root]) / (2 * m1 * m2))
        gamma = m1 / (2 * m2) - (k1 + k2) / (2 * k2)
        delta = np.sqrt(gamma**2 + m1 / m2)
        return omega, np.array([[1.0, -gamma + delta], [1.0, -gamma - delta]])


class NumpyEigh(FloatModes):
    """numpy.linalg.eigh of the matrix of stiffness over masses, made symmetric."""

    name = "numpy.linalg.eigh"

    def solve(self, m1, m2, k1, k2):
        roots = np.sqrt([m1, m2])
        squares, vectors = np.linalg.eigh(np.array([[k1 + k2, -k2], [-k2, k2]]) / np.outer(roots, roots))
        return np.sqrt(squares), _with_x1_positive(vectors.T / roots)


class ScipyEigh(FloatModes):
    """scipy.linalg.eigh of stiffness and masses."""

    name = "scipy.linalg.eigh"

    def solve(self, m1, m2, k1, k2):
        squares, vectors = scipy.linalg.eigh([[k1 + k2, -k2], [-k2, k2]], np.diag([m1, m2]))
        return np.sqrt(squares), _with_x1_positive(vectors.T)


def _with_x1_positive(shape):
    return shape * np.where(shape[:, :1] < 0.0, -1.0, 1.0)


METHODS = (Project, Slides, NumpyEigh, ScipyEigh)
