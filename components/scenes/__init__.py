"""The scenes, in the lecture's order: the only list of them."""

from __future__ import annotations

from components.scene import Scene
from components.scene.docstrings import documented
from components.scenes.absorber import Absorber
from components.scenes.accuracy import Accuracy
from components.scenes.analogues import Analogues
from components.scenes.chain import Chain
from components.scenes.coupled import Coupled
from components.scenes.damped import Damped
from components.scenes.driven import DrivenScene
from components.scenes.energy import Energy
from components.scenes.forced import Forced
from components.scenes.modes import ModesScene
from components.scenes.oscillator import OscillatorScene
from components.scenes.phugoid import Phugoid

SCENES: dict[str, type[Scene]] = {
    scene.slug: scene
    for scene in (
        OscillatorScene,
        Energy,
        Analogues,
        Phugoid,
        Damped,
        DrivenScene,
        ModesScene,
        Coupled,
        Forced,
        Absorber,
        Chain,
        Accuracy,
    )
}

for _scene in SCENES.values():
    _scene.__doc__ = documented(_scene)
