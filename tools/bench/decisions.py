"""The figures of docs/decisions: python -m tools.bench.decisions sliders | figures | digits | formulas | modules

Times are processor times of this process, the median of several; what is timed makes no use of a cache.
"""

from __future__ import annotations

import argparse
import re
from collections.abc import Callable, Iterator
from pathlib import Path
from random import Random
from statistics import median
from time import process_time

import bokeh.server
import brotli
import mpmath as mp
import msgspec
import numpy as np
import panel as pn
from bokeh.document import Document
from bokeh.models import Model

from components.layout.controls import settings
from components.layout.plots import with_figures
from components.scenes import SCENES
from components.serving.assets import static_files, written_files
from components.serving.scripts import FIRST
from components.state.scene_sheet import plots as scene_plots
from physics.coupled import TwoMassChain, free_motion
from physics.precision import exact
from tests.physics.truth import FAMILIES, WORKING_BITS
from tools.bench.accuracy_table import drawn, errors
from tools.bench.float_chains import METHODS

CHAIN = {"m1": 2.0, "m2": 1.0, "k1": 4.0, "k2": 2.0}
FAMILY_NAMES = ("moderate", "all doubles", "tuned weak coupling", "mass ratios to 1e+-300")
SAMPLES = 20


def milliseconds(act: Callable[[], object], times: int = 15) -> float:
    found = []
    for _ in range(times):
        start = process_time()
        act()
        found.append((process_time() - start) * 1e3)
    return median(found)


def models_of(build: Callable[[], Model]) -> Document:
    document = Document()
    document.add_root(build())
    document.to_json()
    return document


def sliders() -> Iterator[str]:
    """Eight quantities as Panel's sliders with a field, and as settings of our own panel."""

    def build() -> Model:
        fields = [pn.widgets.EditableFloatSlider(name=f"k{i}", start=0, end=10, value=2) for i in range(8)]
        return pn.Column(*fields).get_root()

    document, scene = models_of(build), SCENES["coupled"]()
    yield f"Panel, 8 sliders with a field: {milliseconds(lambda: models_of(build)):.1f} ms a session, "
    yield f"    {len(document.models)} models, {len(msgspec.json.encode(document.to_json())) / 1e3:.1f} kB of JSON"
    given = scene.param.objects("existing"), scene.values, scene.units(), scene.shown.spans
    told = settings(*given)
    taken = milliseconds(lambda: settings(*given), 50)
    yield f"ours, {len(told)} controls: {taken:.2f} ms a session, "
    yield f"    no model, {len(msgspec.json.encode(told)) / 1e3:.1f} kB of JSON"


def figures() -> Iterator[str]:
    """The time to build the figures of `coupled`, and the time of a session that shares them."""
    scene = SCENES["coupled"]
    written = milliseconds(lambda: with_figures(scene.sheet()))
    yield f"{len(list(scene_plots(scene)))} figures: {written:.0f} ms to build and to write, once a process"
    yield f"a scene that shares them, its first picture included: {milliseconds(scene):.1f} ms"


def digits() -> Iterator[str]:
    """Worst errors, in units of 2^-53, and times with fewer and more digits than the project's."""
    for count in (20, 40, 60, exact.DIGITS, 160):
        exact._CONTEXT.prec = count
        worst = ", ".join(f"{name} {worst_error(name):.2g}" for name in FAMILY_NAMES)
        modes = milliseconds(lambda: [TwoMassChain(**CHAIN).modes() for _ in range(100)]) / 100
        yield f"{count} digits: {worst}; modes in {modes:.3f} ms"
    exact._CONTEXT.prec = exact.DIGITS
    t = np.linspace(0.0, 20.0, 700)
    motion = milliseconds(lambda: free_motion(TwoMassChain(**CHAIN), (1.0, 0.0), (0.0, 0.0), t))
    yield f"free motion at 700 instants: {motion:.2f} ms"


def worst_error(family: str) -> float:
    random = Random(1)
    with mp.workprec(WORKING_BITS), np.errstate(all="ignore"):
        samples = [drawn(FAMILIES[family](random.uniform), random) for _ in range(SAMPLES)]
        return max(error for sample in samples for _, error in errors(METHODS[0], sample))


def formulas() -> Iterator[str]:
    """The weight of the formulas as MathML, and of a library that sets them in the browser."""
    start = process_time()
    sheets = [msgspec.json.encode(scene.sheet(), enc_hook=str) for scene in SCENES.values()]
    all_of_it = re.findall(rb"<math.*?</math>", b"".join(sheets))
    taken = process_time() - start
    yield f"{len(set(all_of_it))} formulas: all sheets built in {taken:.1f} s, once a process"
    yield f"{len(all_of_it)} in the sheets: {packed(b''.join(all_of_it)):.0f} kB with brotli"
    yield f"the font: {len(static_files()['fonts/stix-two-math.woff']) / 1e3:.0f} kB"
    folder = Path(pn.__file__).parent / "dist/bundled/katex"
    katex = next(folder.rglob("katex.min.js")).read_bytes(), next(folder.rglob("katex.min.css")).read_bytes()
    yield f"KaTeX: {packed(b''.join(katex)):.0f} kB with brotli, without its fonts"
    mathjax = Path(bokeh.server.__file__).parent / "static/js/bokeh-mathjax.min.js"
    yield f"MathJax as Bokeh has it: {packed(mathjax.read_bytes()):.0f} kB with brotli"


def modules() -> Iterator[str]:
    """Our scripts one by one, and as one file."""
    sent = static_files()
    written = {name: content for name, content in written_files().items() if name.endswith(".js")}
    files, one = [content for name, content in written.items() if name == FIRST or name not in sent], sent[FIRST]
    yield f"{len(files)} modules: {sum(map(len, files)) / 1e3:.0f} kB, {sum(map(packed, files)):.1f} kB with brotli"
    yield f"one file: {len(one) / 1e3:.0f} kB, {packed(one):.1f} kB with brotli"


def packed(content: bytes) -> float:
    return len(brotli.compress(content)) / 1e3


QUESTIONS = {each.__name__: each for each in (sliders, figures, digits, formulas, modules)}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("question", choices=QUESTIONS)
    for line in QUESTIONS[parser.parse_args().question]():
        print(line)


if __name__ == "__main__":
    main()
