"""A scene: an immutable set of parameter values, their picture, and the values that depend on a change."""

from __future__ import annotations

from abc import ABCMeta, abstractmethod
from collections.abc import Hashable, Mapping
from functools import cache, cached_property
from typing import Any, Self

import param
from param.parameterized import ParameterizedMetaclass

from components.language.blocks import Block
from components.language.state import Frame
from components.layout.sheet import axes_of_columns, sources_of_plots
from components.quantities.parameters import Quantity, Values, WordList, one_of
from components.quantities.readouts import Readout, SceneNumber
from components.quantities.refusals import in_words
from components.quantities.units import Unit
from components.scene.about import About
from components.scene.columns import with_units
from components.scene.frames import FITTED
from components.scene.picture import Picture, draw
from components.scene.scene_info import SceneInfo
from components.scene.traces import Columns

NONE: Values = {}
VIEW = "view"
"""The parameter of a scene that says which of its views is shown."""


class _SceneMeta(ParameterizedMetaclass, ABCMeta):
    """Metaclass: adds the parameter `view` to a scene with views; calling a scene class returns a `SceneFace`."""

    def __new__(mcs, name: str, bases: tuple[type, ...], given: dict[str, Any], **rest: Any) -> Any:
        if views := given.get("views", ()):
            given["view"] = one_of(views[0].slug, {view.slug: view.name for view in views}, "View")
        return super().__new__(mcs, name, bases, given, **rest)

    def __call__(cls, **values: Any) -> Any:
        from components.scene.face import face_of  # the server and the physics do not use it

        return face_of(cls)(**values)


class Scene(SceneInfo, metaclass=_SceneMeta):
    """One idea of the lecture: an immutable set of parameter values, with the picture and the numbers that follow.

    A subclass is final: it declares parameters, a sheet, and `picture`. `Scene.at(values)` returns an immutable scene,
    and `changed(values)` another one; the page uses only these. `Scene(**values)` returns a `SceneFace`, whose
    parameters can be set.

    Parameters
    ----------
    **values
        Parameters by name, in SI units and rad. The docstring of each scene lists them with units, limits and defaults.

    Raises
    ------
    ValueError
        If a value is not possible. The message names the value and what is allowed.

    Examples
    --------
    >>> from components.scenes import SCENES
    >>> scene = SCENES["damped"].at({"m": 1.0, "k": 16.0, "c": 4.0})
    >>> scene.numbers["zeta"].value
    0.5
    >>> scene.changed({"c": 8.0}).numbers["zeta"].value
    1.0
    """

    window = Quantity(
        default=None,
        allow_None=True,
        bounds=(0, None),
        inclusive_bounds=(False, False),
        softbounds=(1, 100),
        symbol="T",
        unit="s",
        says="the time window; empty for the scene's own choice.",
        allowed="a time window is a finite time above 0 s",
    )
    view: str
    """The current view, in a scene with views."""
    hidden = WordList(default=[], doc="The curves switched off, by group.")

    @classmethod
    @abstractmethod
    def sheet(cls) -> Block:
        """Return the arrangement of stage, plots and texts: components.layout.sheet."""

    @abstractmethod
    def picture(self, frame: Frame = FITTED) -> Picture:
        """Return the picture, a pure function of the parameters and the frame, whose missing parts are fitted.

        Raises ValueError if doubles cannot represent the result.
        """

    def picture_of(self, names: frozenset[str], frame: Frame) -> Picture:
        """Return a picture with at least the curves, numbers, texts and forms of these names, and with all axes."""
        return self.picture(frame)

    @classmethod
    def drawings(cls) -> dict[str, str]:
        """Return small pictures for presets, by label: SVG path data in a box of 128 by 46."""
        return {}

    def units(self) -> dict[str, Unit]:
        """Return the units of quantities that are currently shown and typed in another unit than their own."""
        return {}

    def following(self, changed: frozenset[str], before: Self | None, *, in_hand: bool) -> Values:
        """Return the values that depend on the parameters `changed`. `in_hand` is True during a drag.

        `before` is the scene before the change, None for a new scene.
        """
        return {}

    def action(self, name: str) -> Values:
        """Return the values that a button of a group sets. Raises ValueError, with a reason, if there are none."""
        raise NotImplementedError(name)

    def here(self) -> list[str]:
        """The names of the actions in `places` whose values the scene has now."""
        return [name for name in self.places if all(getattr(self, p) == v for p, v in self.action(name).items())]

    def about(self, shown: Picture) -> About | None:
        """The known errors of the displayed numbers, or None."""
        return None

    @classmethod
    def is_checked(cls) -> bool:
        """Return True if `about` compares the drawn numbers with exact ones."""
        return cls.about is not Scene.about

    @property
    def numbers(self) -> dict[str, SceneNumber]:
        """The numbers that the scene shows in any of its views: a dict of `SceneNumber` by name.

        Each has a `value` in SI units and rad, a `unit` ("" for a pure number) and a `description`. A number that does
        not exist for the current parameters is missing, such as the frequency of a mass that does not swing.

        Raises
        ------
        ValueError
            If the physics refuses the values of the parameters.

        Examples
        --------
        >>> from components.scenes import SCENES
        >>> scene = SCENES["damped"](m=1.0, k=16.0, c=4.0)
        >>> scene.numbers["zeta"]
        SceneNumber(value=0.5, unit='', description='damping ratio')
        """
        return {}

    def readouts(self) -> tuple[Readout, ...]:
        """Return the numbers that are listed in a comparison with another picture."""
        return ()

    def derived(self) -> frozenset[str]:
        """Return the parameters that currently depend on others; links omit them."""
        return frozenset()

    def off_default(self) -> Values:
        """Return the linked parameters that are not at their defaults and do not depend on others."""
        values, defaults, derived = self.values, self.parameters(), self.derived()
        return {name: values[name] for name in self.linked() if values[name] != defaults[name] and name not in derived}

    def preset(self) -> str | None:
        """The label of the current preset, if any."""
        now = [self.values[name] for name in self.preset_names()]
        return next((label for label, values in self.preset_values() if values == now), None)

    # The value.

    @classmethod
    def at(cls, values: Values = NONE) -> Self:
        """Return the scene with these values, and values that depend on them; the others have their defaults.

        Raises ValueError for values that are not possible.
        """
        cls._check_known(values)
        return cls._settled(values, frozenset(values), None, in_hand=False)

    def changed(self, values: Values, *, in_hand: bool = False) -> Self:
        """Return the scene with other values and those that depend on them; `self` if nothing changes."""
        defaults, changed = self.parameters(), self.differing(values)
        if not changed:
            return self
        others = {name: own for name, own in self.values.items() if own is not defaults[name]}
        return self._settled({**others, **values}, changed, self, in_hand=in_hand)

    @classmethod
    def _settled(cls, values: Values, changed: frozenset[str], before: Self | None, *, in_hand: bool) -> Self:
        scene = cls.__new__(cls)
        param.Parameterized.__init__(scene, **values)  # type: ignore[no-untyped-call]  # param's own has no types
        with in_words():
            following = scene.following(changed, before, in_hand=in_hand)
        followed = {name: value for name, value in following.items() if getattr(scene, name) != value}
        for name, value in followed.items():
            setattr(scene, name, value)
        given = {name: getattr(scene, name) for name in (*values, *followed)}
        vars(scene)["values"] = {**cls.parameters(), **given}
        return scene

    @classmethod
    @cache
    def parameters(cls) -> dict[str, Any]:
        """All parameters, with their defaults."""
        return {name: one.default for name, one in cls.param.objects("existing").items() if name != "name"}

    @classmethod
    def _check_known(cls, values: Values) -> None:
        if unknown := values.keys() - cls.parameters().keys():
            raise ValueError(f"{', '.join(sorted(unknown))}: not a parameter of {cls.__name__}")

    def differing(self, values: Values) -> frozenset[str]:
        """Return the names of values that differ from the scene's. Raises ValueError for unknown parameters."""
        self._check_known(values)
        return frozenset(name for name, value in values.items() if self.values[name] != value)

    @property
    def values(self) -> Mapping[str, Any]:
        """The values of all parameters."""
        values: Values = vars(self)["values"]
        return values

    @cached_property
    def key(self) -> Hashable:
        """A key that is equal for scenes with the same bits in all values: -0.0 differs from 0.0."""
        exact = (repr(value) if isinstance(value, (float, list)) else value for value in self.values.values())
        return type(self), tuple(exact)

    @cached_property
    def shown(self) -> Picture:
        """The picture of the scene in the fitted frame. Raises ValueError if doubles cannot represent it."""
        return draw(self).picture

    def frame(self, source: str = "") -> Columns:
        """Return the numbers of curves as columns of equal length, for `pandas.DataFrame`.

        Parameters
        ----------
        source : str
            The name of a source, such as "time", or of a plot, such as "response". The default is the first source
            that has numbers.

        Returns
        -------
        dict of str to numpy.ndarray
            A column (n,) of floats for each quantity, in SI units. Its name has the unit: "x1 [m]", "omega [rad/s]";
            that of a pure number is 1: "M [1]".

        Raises
        ------
        ValueError
            If there are no such numbers. The message lists the names that have some.

        Examples
        --------
        >>> from components.scenes import SCENES
        >>> list(SCENES["oscillator"](m=2.0).frame())
        ['t [s]', 'x [m]', 'v [m/s]', 'a [m/s^2]']
        """
        sheet = self.sheet()
        return with_units(self.shown, axes_of_columns(sheet), sources_of_plots(sheet), source)

    def __setattr__(self, name: str, value: Any) -> None:
        if "values" in vars(self):
            raise AttributeError(f"{name} cannot be set: changed({name}=...) is another scene")
        super().__setattr__(name, value)
