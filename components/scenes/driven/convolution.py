"""The view Convolution of the driven mass: the slices of a push, the responses to them, and their sum."""

from __future__ import annotations

from components.language.blocks import Block
from components.layout.views import in_views
from components.paper.plots import curve, either, form_of, words
from components.scenes.driven.grips import grips
from components.scenes.driven.plots import FORCE, SIDES, SUM, c

SLICED = form_of(c.has_slices)


def in_convolution() -> list[Block]:
    """Return the blocks of the view."""
    return [in_views(one, "convolution") for one in (tails(), slices(), sentence())]


def tails() -> Block:
    """Return the plot of the motion, of the responses to the slices, and of their sum."""
    paths = SUM.in_frame(c, "tails", lambda c, t, x: c.tail_path(), optional=True)
    return SUM.block(
        curve(c.x_sliced, "dash", "xp", words="sum", read="sum of the slices", dot=True),
        curve(c.x, "sum", "m1", label="*x*", words="exact motion *x*", fast="ringing", dot=True),
        curve(
            paths, "thin", "F", columns=("tail_t", "tail"), read="what slices leave",
            words=either(
                c.tail_form, each="from each slice", some="from some slices", each_jolt="from each impulse",
                some_jolt="from some impulses",
            ),
        ),
        title="Displacement, the motions that slices of the push leave, and their sum, against time",
        room=SIDES, grow=330, phone=10, height=160,
    )  # fmt: skip


def slices() -> Block:
    """Return the plot of the push with its slices."""
    paths = FORCE.in_frame(c, "outline", lambda c, t, F: c.slice_path(), optional=True)
    return FORCE.block(
        curve(c.push_F, "line", "F", words="push *F*", read="push"),
        curve(
            paths, "thin", "mute", columns=("slice_t", "slice"), read="slices", fill=0.3,
            words=either(c.is_impulsive, yes="impulses", no="its slices"),
        ),
        title="The push and its slices against time", over=grips(FORCE, FORCE.y, FORCE.up),
        room=SIDES, grow=170, phone=12, height=110,
    )  # fmt: skip


def sentence() -> Block:
    """The sentence on how well the sum follows the motion."""
    width = f"A slice lasts {c.slice_width} of a natural period"
    said = either(
        c.sums,
        follows=f"**{width}: short enough to act as one impulse. The sum misses the motion by at most {c.misses} m.**",
        coarse=f"**{width}: too long to act as one impulse. The sum misses the motion by up to {c.misses} m.**",
        changes=f"**{width}, but the push changes within slices. The sum misses the motion by up to {c.misses} m.**",
        impulses="**An impulse is a slice already: the motion is the sum of what the impulses leave.**",
        fast="**The motion is too fast for a line in this window. For a picture of the slices, choose a shorter one.**",
        other="**This view is about a force. Choose Force as the drive.**",
        idle="**No push: the motion is that of the start alone.**",
    )
    return words(said, phone=16, name="sums")
