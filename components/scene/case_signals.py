"""Signals of a picture, made from its motions: a sum or product of motions becomes one of signals."""

from __future__ import annotations

from collections.abc import Mapping

from components.language.expressions import Expression, Product
from components.language.signals import AnySignal
from components.quantities.axes import Axis
from components.quantities.formatting import power_unit
from components.quantities.motion import derived, played, scaled
from physics.motion import ONE, Elementary, ExactMotion, MotionPolynomial, MotionTerm


def signals_of(moving: Mapping[str, tuple[ExactMotion, Axis]], time: Axis) -> dict[str, AnySignal]:
    """Return the signals of motions in the units of their axes, by name. A signal comes after those that it needs."""
    return _Signals(moving, time).found


class _Signals:
    def __init__(self, moving: Mapping[str, tuple[ExactMotion, Axis]], time: Axis) -> None:
        self.time = time
        self.axes = {name: axis for name, (_, axis) in moving.items()}
        self.names = {id(moving[name][0]): name for name in reversed(list(moving))}
        self.found: dict[str, AnySignal] = {}
        for name, (motion, _) in moving.items():
            if self._name_of(motion) != name:  # the same motion, needed on another axis too
                self._define(name, MotionPolynomial(((ONE, (motion,)),)))

    def _name_of(self, motion: ExactMotion) -> str:
        """Define the signal of a motion and return its name; a motion without a name gets one."""
        if id(motion) not in self.names:
            self.names[id(motion)] = self._name_part(motion)
        name = self.names[id(motion)]
        if name not in self.found:
            self._define(name, motion)
        return name

    def _name_part(self, motion: ExactMotion) -> str:
        """Return a new name for a motion that is only a part of others; its axis has a power of ten for its size."""
        size, number, name = motion.size(), 2, motion.symbol
        while name in self.axes:
            number, name = number + 1, f"{motion.symbol}{number}"
        exponent, suffix = power_unit(size)
        self.axes[name] = Axis(-size, size, exponent=exponent, suffix=suffix)
        return name

    def _define(self, name: str, motion: ExactMotion) -> None:
        axis = self.axes[name]
        if isinstance(motion, Elementary):
            self.found[name] = played(motion.played, axis, self.time)
        elif isinstance(motion, MotionPolynomial):
            terms = motion.flat(whole=lambda part: id(part) in self.names)
            self.found[name] = derived(Expression(tuple(self._product(axis, term) for term in terms)))

    def _product(self, axis: Axis, term: MotionTerm) -> Product:
        factor, motions = term
        names = tuple(map(self._name_of, motions))
        units = [self.axes[name] for name in names]
        exponent = axis.exponent - sum(unit.exponent for unit in units)
        return Product(scaled(exponent, factor, 1 / axis.factor, *(unit.factor for unit in units)), names)
