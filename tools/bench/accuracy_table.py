"""Worst errors of the physics of the chain and of one mass, family by family, compared with plain float64.

    python -m tools.bench.accuracy_table [--samples 100] [--seed 1] [--out build/accuracy]

prints a table and writes it as accuracy.md and accuracy.csv. Frequencies, ratios, the beat and amplitudes are
measured in ulp, motions in u = 2^-53 of their amplitude or envelope, against arbitrary precision. Drives lie
at detunings of 0 and 1e-17 to 100 from the modes, times up to 1e12 slow periods while omega_+ t < 1e15.
"""

import argparse
import csv
import math
import sys
import warnings
from collections.abc import Iterator
from pathlib import Path
from random import Random

import mpmath as mp
import numpy as np

from tests.physics.truth import FAMILIES, SETUP_BITS, WORKING_BITS, Truth, U, ulps, units
from tools.bench import braked_chain, one_mass
from tools.bench.float_chains import METHODS

QUANTITIES = (
    "frequencies, ulp",
    "ratios, ulp",
    "beat, ulp",
    "Xp, ulp",
    "free motion, u",
    "energy of the free motion, u",
    "forced motion, u",
)
INSIDE = mp.mpf("1e-290"), mp.mpf("1e290")  # where no method can blame the range of its results
LOST = 2.0**53


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--samples", type=int, default=100, help="chains of each family")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--out", type=Path, default=Path("build/accuracy"))
    options = parser.parse_args()
    with mp.workprec(WORKING_BITS), np.errstate(all="ignore"), warnings.catch_warnings():
        warnings.simplefilter("ignore")  # what the plain forms overflow to is their result
        table = {name: measured(family, options.samples, options.seed) for name, family in FAMILIES.items()}
    options.out.mkdir(parents=True, exist_ok=True)
    text = markdown(table, options.samples, options.seed)
    for add in (one_mass.table, one_mass.push_table, braked_chain.table):
        text += add(options.samples, options.seed)
    (options.out / "accuracy.md").write_text(text)
    write_csv(table, options.out / "accuracy.csv")
    print(text)


def measured(family, samples, seed):
    """{(quantity, method): (worst error, share of results that are no number)}."""
    random = Random(seed)
    found = {(quantity, method.name): [] for quantity in QUANTITIES for method in METHODS}
    for _ in range(samples):
        sample = drawn(family(random.uniform), random)
        for method in METHODS:
            for quantity, error in errors(method, sample):
                found[quantity, method.name].append(error)
    return {key: summary(values) for key, values in found.items()}


def summary(values):
    numbers = [error for error in values if math.isfinite(error)]
    worst = max(numbers, default=math.inf if values else 0.0)
    return worst, 1.0 - len(numbers) / len(values) if values else 0.0


def drawn(parameters, random):
    """One chain, its truth, a start, a drive, and times."""
    true = Truth(*parameters)
    fast = true.omega[1] or mp.mpf(1)
    slow = true.omega[0] or fast
    turns = [(fast, random.uniform(-2, 14)), (fast, random.uniform(-2, 4)), (slow, random.uniform(-2, 12))]
    times = [mp.mpf(10) ** e / omega for omega, e in turns]
    detuning = random.choice([0.0, 10.0 ** random.uniform(-17, 2), -(10.0 ** random.uniform(-17, 0))])
    x_0 = random.uniform(-1, 1), random.uniform(-1, 1)
    v_0 = [random.uniform(-1, 1) * float(slow) for _ in range(2)]
    omega = np.float64(random.choice([slow, fast]) * (1 + mp.mpf(detuning)))
    t = np.array([float(s) for s in times if fast * s < 1e15 and omega * s < 1e15 and s < INSIDE[1]])
    return parameters, true, np.array(x_0), np.array(v_0), omega, t


def errors(method, sample) -> Iterator[tuple[str, float]]:
    try:
        chain = method(sample[0])
        yield from scalar_errors(chain, sample)
        yield from motion_errors(chain, sample)
    except (ValueError, np.linalg.LinAlgError):
        yield from ((quantity, math.inf) for quantity in QUANTITIES)


def scalar_errors(chain, sample):
    _, true, _, _, omega, _ = sample
    frequencies, ratios, beat = chain.modes()
    for quantity, found, exactly in (
        ("frequencies, ulp", frequencies, true.omega),
        ("ratios, ulp", ratios, true.ratio),
        ("beat, ulp", [beat], [true.beat]),
    ):
        for value, aim in zip(found, exactly, strict=True):
            if measurable(aim):
                yield quantity, number(ulps, value, aim)
    Xp = particular(true, 1.0, omega)
    if all(measurable(aim) for aim in Xp):
        for value, aim in zip(chain.particular(1.0, omega), Xp, strict=True):
            yield "Xp, ulp", number(ulps, value, aim)


def particular(true, F_0, omega):
    """Xp1, Xp2; inf exactly at resonance."""
    with mp.workprec(SETUP_BITS):
        F, square = mp.mpf(F_0), mp.mpf(omega) ** 2
        D = (true.m1 * square - true.k1 - true.k2) * (true.m2 * square - true.k2) - true.k2**2
        if not true.k2:
            stiffness = true.k1 - true.m1 * square
            return (F / stiffness if stiffness else mp.inf), mp.mpf(0)
        return tuple(X / D if D else mp.inf for X in ((true.k2 - true.m2 * square) * F, true.k2 * F))


def motion_errors(chain, sample):
    _, true, x_0, v_0, omega, t = sample
    for quantity, exactly, find in (
        ("free motion, u", lambda s: true.free(x_0, v_0, s), lambda: chain.free(x_0, v_0, t)),
        ("forced motion, u", lambda s: true.driven(1.0, omega, s), lambda: chain.driven(1.0, omega, t)),
    ):
        aims = [exactly(s) for s in t]
        if all(measurable(scale) for _, scales in aims for scale in scales):
            found = find()
            for n, (values, scales) in enumerate(aims):
                row = [float(entry[n]) for entry in found]
                for entry, value, scale in zip(row, values, scales, strict=True):
                    yield quantity, number(units, entry, value, scale)
                if quantity.startswith("free"):
                    yield "energy of the free motion, u", energy_error(true, row, values)


def energy_error(true, row, values):
    if not np.all(np.isfinite(row)):
        return math.inf
    aim = energy(true, values)
    return float(abs(energy(true, [mp.mpf(entry) for entry in row]) - aim) / (aim * U))


def energy(true, values):
    """T + V of x1, x2, e2, v1, v2."""
    x1, _, e2, v1, v2 = values
    return (true.m1 * v1**2 + true.m2 * v2**2 + true.k1 * x1**2 + true.k2 * e2**2) / 2


def measurable(aim):
    return not aim or INSIDE[0] < abs(aim) < INSIDE[1]


def number(measure, value, *aim):
    return measure(value, *aim) if np.isfinite(value) else math.inf


def shown(worst, failures):
    if math.isinf(worst):
        return "no number"
    text = "no digit" if worst >= LOST else f"{worst:.2f}" if worst < 100 else f"{worst:.0e}"
    return f"{text}, {100 * failures:.0f} % no number" if failures else text


def markdown(table, samples, seed):
    lines = [
        "# Accuracy of the chain's physics",
        "",
        f"Worst error of {samples} chains of each family (seed {seed}), against arbitrary precision. "
        "u = 2^-53; 0.50 ulp is correct rounding, 2^53 ulp or u are no digit at all; "
        "'no number' is NaN, an infinity or an exception.",
        "",
        f"Python {sys.version.split()[0]}, NumPy {np.__version__}.",
    ]
    for quantity in QUANTITIES:
        names = [method.name for method in METHODS]
        lines += ["", f"## {quantity.split(', ')[0].capitalize()}, in {quantity.split(', ')[1]}", ""]
        lines += ["| family | " + " | ".join(names) + " |", "|---" * (len(names) + 1) + "|"]
        for family, worst in table.items():
            lines.append(f"| {family} | " + " | ".join(shown(*worst[quantity, name]) for name in names) + " |")
    return "\n".join(lines) + "\n"


def write_csv(table, path):
    with path.open("w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(["quantity", "unit", "family", "method", "worst_error", "share_without_number"])
        for family, worst in table.items():
            for (quantity, method), (error, failures) in worst.items():
                writer.writerow([*quantity.split(", "), family, method, repr(error), failures])


if __name__ == "__main__":
    main()
