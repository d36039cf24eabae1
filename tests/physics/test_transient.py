"""The damped chain from any start: against the matrix exponential in many digits, at double roots, in its limits."""

import math

import mpmath as mp
import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from physics.absorber import damped_solution
from physics.coupled import TwoMassChain
from physics.precision.polynomials import context
from physics.reference.damped_chain import braked_points
from physics.transient import DIGITS, DRAWING, FILE, DampedModes
from tests.grids import tries
from tests.physics.chain_families import FAMILIES, chain_with, drawn
from tests.physics.chain_truth import U, rows, ulps

MACHINE = TwoMassChain(m1=100.0, m2=16.0, k1=250e3, k2=36864.0)
LECTURE = TwoMassChain(m1=2.0, m2=1.0, k1=4.0, k2=2.0)
WITHIN = ("moderate", "1e+-8", "tuned weak coupling", "k1 = 0", "k2 = 0", "k1 = k2 = 0", "small integers")
EQUAL_EXPONENTS = [
    (TwoMassChain(m1=1.0, m2=1.0, k1=0.0, k2=2.0), 2.0),  # a critical pair, no wall
    (TwoMassChain(m1=1.0, m2=1.0, k1=2.0, k2=0.5), 1.0),  # (s^2 + s + 1)^2
    (TwoMassChain(m1=5.0, m2=20.0, k1=25.0, k2=4.0), 16.0),  # (s + 1)^4
]


def truth(modes, t):
    """x1, x2, x2 - x1, v1, v2 from exp(A t), with the drive as an additional oscillator."""
    chain = modes.chain
    parameters = (chain.m1, chain.m2, chain.k1, chain.k2, modes.c, modes.c1, modes.F_0, modes.omega)
    m1, m2, k1, k2, c, c1, F, omega = map(mp.mpf, parameters)
    A = mp.matrix(6, 6)
    A[0, 2] = A[1, 3] = 1
    for i, m, sign, wall, brake in ((2, m1, 1, k1, c1), (3, m2, -1, 0, 0)):
        A[i, 0], A[i, 1] = (-sign * k2 - wall) / m, sign * k2 / m
        A[i, 2], A[i, 3] = (-sign * c - brake) / m, sign * c / m
    A[2, 4] = F / m1
    A[4, 5], A[5, 4] = omega, -omega
    x1, x2, v1, v2, _, _ = mp.expm(A * mp.mpf(t)) * mp.matrix([*modes.x_0, *modes.v_0, 0, 1])
    return x1, x2, x2 - x1, v1, v2


def check(modes, times):
    """Every number within 0.51 ulp, the smallest too."""
    motion = modes.motion(times)
    for n, t in enumerate(times):
        for row, aim in zip(rows(motion), truth(modes, t), strict=True):
            assert ulps(row[n], aim) <= 0.51


def modes_of(chain, c, F_0=1.0, omega=1.0, x_0=(0.0, 0.0), v_0=(0.0, 0.0), c1=0.0):
    return DampedModes(chain=chain, c=c, F_0=F_0, omega=omega, x_0=x_0, v_0=v_0, c1=c1)


@pytest.mark.parametrize("family", WITHIN)
@settings(max_examples=tries(8))
@given(data=st.data())
def test_motion_is_rounded_once(family, data):
    chain = chain_with(data.draw(drawn(FAMILIES[family])))
    fast = float(chain.modes().omega[1]) or 1.0
    share = st.just(0.0) | st.floats(-6.0, 2.0).map(lambda e: 10.0**e)
    c, c1 = (math.sqrt(chain.m1 * chain.m2) * fast * data.draw(share) for _ in range(2))
    omega = fast * 10.0 ** data.draw(st.floats(-3.0, 1.0))
    x_0 = data.draw(st.tuples(st.floats(-1.0, 1.0), st.floats(-1.0, 1.0)))
    v_0 = data.draw(st.sampled_from([(0.0, 0.0), (fast, -fast)]))
    times = [10.0 ** data.draw(st.floats(low, high)) / fast for low, high in ((-4.0, 0.0), (0.0, 2.0), (0.0, 4.0))]
    F_0 = data.draw(st.sampled_from([0.0, 1.0])) * chain.m1 * fast**2
    assume((c or c1) and max(abs(number) for number in (F_0, omega, c, c1, *times)) < 1e100)
    check(modes_of(chain, c, F_0, omega, x_0, v_0, c1), [0.0, *times])


def special():
    """Motions where digits are lost first, and times."""
    small = TwoMassChain(m1=1.0, m2=1.0, k1=1.0, k2=1.0)
    for size in (2.2250738585072014e-308, 5e-320):
        yield modes_of(small, 1.618033988749895, F_0=0.0, x_0=(size, 0.0)), np.linspace(0.0, 5.0, 10).tolist()
    for chain, c in EQUAL_EXPONENTS:
        yield modes_of(chain, c, omega=0.7, x_0=(0.3, -1.0)), [0.0, 1e-6, 0.1, 1.0, 30.0, 200.0]
        for apart in (1e-15, 1e-9, 1e-3):
            yield modes_of(chain, c * (1 + apart), omega=0.7), [1e-3, 1.0, 20.0]
    for ratio in (1e3, 1e9):  # overdamped: the rates differ by a factor ratio^2
        yield modes_of(LECTURE, 3.0 * ratio, x_0=(1.0, 0.0)), [1e-9, 1e-3, 1.0, 40.0, 1e4]
    for c in (5e-324, 1e-100, 1e-20):  # at resonance x_p and the transient are 1/c large
        for omega in (1.0, 1.0 + 1e-9, 1.7):
            yield modes_of(LECTURE, c, 1.0, omega), [1e-4, 0.3, 5.0, 100.0]
    loose = TwoMassChain(m1=1.0, m2=1.0, k1=0.0, k2=0.0)  # mass 1 stays while the other moves
    yield modes_of(loose, 0.0, 0.0, 0.0, (0.1, 0.2), (0.0, 0.3), c1=0.5), [0.0, 1.0, 7.0]


@pytest.mark.parametrize(("modes", "times"), list(special()))
def test_special_motions_are_rounded_once(modes, times):
    check(modes, times)


@pytest.mark.parametrize(
    ("chain", "c", "room"),
    [
        *((MACHINE, c, 1e-12) for c in (0.0, 1e-6, 1.0, 313.7, 1e6)),
        *((chain, c * (1 + apart), 1e-5) for chain, c in EQUAL_EXPONENTS for apart in (0.0, 1e-15, 1e-3)),
    ],
)
def test_the_motion_is_its_particular_solution_and_its_transient(chain, c, room):
    """Drawn in plain doubles it is the same, and the reference of the scenes too."""
    modes = modes_of(chain, c, 500.0, 0.96 * float(chain.modes().omega[1]), (0.3, -1.0), (1.0, 0.0))
    t = np.linspace(0.0, 30.0, 100) / float(chain.modes().omega[1])
    motion = modes.motion(t)
    x = np.array([*motion.x, motion.e[1]])
    size = np.max(np.abs(x))
    assert np.max(np.abs(modes.particular_motion(t) + modes.complementary(t) - x)) < room * size
    drawn_x, drawn_v = modes.drawn(t)
    assert np.max(np.abs(drawn_x - x)) < room * size
    assert np.max(np.abs(drawn_v[:2] - motion.v)) < room * np.max(np.abs(motion.v))
    for row, points in zip(motion.x, braked_points(modes, t[::33]).values(), strict=True):
        assert row[::33] == pytest.approx([float(one.value) for one in points], abs=8 * U * size)
    assert np.array_equal(modes.particular[:2], damped_solution(chain, c, 500.0, modes.omega, modes.c1))
    for exponent, (amplitude, *_) in modes.transient:
        assert exponent.imag >= 0.0 and (exponent.real < 0.0 or not (c and chain.k1))
        assert amplitude[2] == pytest.approx(amplitude[1] - amplitude[0], abs=1e-14 * np.max(np.abs(amplitude)))


def test_no_particular_solution_at_an_undamped_resonance():
    modes = modes_of(LECTURE, 0.0, 1.0, 1.0)
    for refused in ("transient", "particular"):
        with pytest.raises(ValueError, match="omega = 1 rad/s is at a natural frequency"):
            getattr(modes, refused)
    assert np.all(np.isfinite(modes.motion([100.0]).x))


DAMPED = DampedModes(chain=TwoMassChain(m1=100.0, m2=16.0, k1=250e3, k2=36864.0), c=100.0, F_0=500.0, omega=48.0)


def test_work_beyond_that_of_a_picture_or_a_file_is_refused():
    """At first, where x2 starts like t^4, all but everything cancels; much later few digits are needed."""
    few, many = np.linspace(0.5e-100, 1e-100, 3), np.linspace(0.5e-100, 1e-100, 500)
    np.testing.assert_array_equal(DAMPED.motion(few, DRAWING).x, DAMPED.motion(few).x)
    for budget in (DRAWING, FILE):
        with pytest.raises(ValueError, match="more digits of arithmetic than are allowed"):
            DAMPED.motion(many, budget)
    t = np.linspace(5e12, 1e13, 50)
    exact = DAMPED.motion(t).x
    np.testing.assert_allclose(DAMPED.motion(t, DRAWING).x, exact, rtol=0, atol=1e-12 * np.abs(exact).max())


def test_what_died_out_long_ago_is_not_worked_out(monkeypatch):
    """An exponent of -1e189 is an integer, to whose power mpmath would raise e, squaring by squaring."""
    asked, ctx = [], context(DIGITS)
    exp = ctx.exp
    monkeypatch.setattr(ctx, "exp", lambda z: asked.append(z.real) or exp(z))
    modes = DampedModes(chain=LECTURE, c=1.0, F_0=1.0, omega=1e-189, x_0=(1.0, 0.0))
    far = modes.motion([1e189, 2e189])
    np.testing.assert_allclose(far.x, np.sin([1.0, 2.0]) * modes.particular[:2, None].real, rtol=1e-9)
    assert asked and min(asked) > -1e6
