"""Ways to compute the motion of the driven chain at any time, without steps or with exact ones.

Each is a `Runner`, which has no use for its setting.

Sources: lecture D34, slides 3 to 8; with a dashpot, beyond lecture D31.
"""

import numpy as np

from physics.coupled import free_motion
from physics.forced import forced_motion
from physics.integrators.problem import Problem, StoppedError, Trajectory, Watch, trajectory
from physics.precision.exact import Array


def closed_form(problem: Problem, _: float, watch: Watch) -> Trajectory:
    """The closed form of this project. Parameters and result as in `Runner`."""
    watch.evaluations = problem.t.size
    if problem.c:
        return _with_dashpot(problem)
    if problem.F_0:
        motion = forced_motion(problem.chain, problem.F_0, problem.omega, problem.t, problem.x_0, problem.v_0)
    else:
        motion = free_motion(problem.chain, problem.x_0, problem.v_0, problem.t)
    return Trajectory(x=motion.x, v=motion.v, stretch=motion.e[1])


def _with_dashpot(problem: Problem) -> Trajectory:
    """The particular solution Im(X exp(i omega t)) and the free decay that fits the start."""
    omega, t = problem.omega, problem.t
    X = problem.F_0 / complex(problem.chain.k1 - problem.chain.m1 * omega**2, problem.c * omega) if problem.F_0 else 0j
    free = problem.damped.motion(problem.x_0[0] - X.imag, problem.v_0[0] - omega * X.real, t)
    S, C = np.sin(omega * t), np.cos(omega * t)
    x, v = free.x + X.real * S + X.imag * C, free.v + omega * (X.real * C - X.imag * S)
    still = np.zeros_like(x)
    return Trajectory(x=np.stack([x, still]), v=np.stack([v, still]), stretch=-x)


def slide_formulas(problem: Problem, _: float, watch: Watch) -> Trajectory:
    """The lecture's formulas (D34, slides 3 to 8) in the order they are printed, in float64; with a dashpot D31's.

    Parameters and result as in `Runner`.
    """
    chain = problem.chain
    if problem.c:
        return _damped_exponentials(problem, watch)
    b = chain.m1 * chain.k2 + chain.m2 * (chain.k1 + chain.k2)
    root = np.sqrt(b * b - 4 * chain.m1 * chain.m2 * chain.k1 * chain.k2)
    squares = np.array([b - root, b + root]) / (2 * chain.m1 * chain.m2)
    ratios = -(chain.m1 * squares - chain.k1 - chain.k2) / chain.k2
    particular = _slide_particular(problem, squares)
    return _superposed(problem, np.sqrt(squares), np.array([[1.0, 1.0], ratios]), particular, watch)


def _damped_exponentials(problem: Problem, watch: Watch) -> Trajectory:
    """A exp(s_1 t) + B exp(s_2 t) and the particular solution, s from the textbook's quadratic formula."""
    watch.evaluations = problem.t.size
    m, k, c, omega, t = problem.chain.m1, problem.chain.k1, problem.c, problem.omega, problem.t
    root = np.sqrt(c * c - 4 * m * k)
    slow, fast = (-c + root) / (2 * m), (-c - root) / (2 * m)
    X = problem.F_0 / complex(k - m * omega**2, c * omega) if problem.F_0 else 0j
    x_0, v_0 = problem.x_0[0] - X.imag, problem.v_0[0] - omega * X.real
    A, B = (v_0 - fast * x_0) / (slow - fast), (v_0 - slow * x_0) / (fast - slow)
    first, second, turning = A * np.exp(slow * t), B * np.exp(fast * t), X * np.exp(1j * omega * t)
    x, v = first + second + turning.imag, slow * first + fast * second + omega * turning.real
    still = np.zeros_like(x)
    return _trajectory(np.stack([x, still]), np.stack([v, still]))


def dense_eigh(problem: Problem, _: float, watch: Watch) -> Trajectory:
    """Frequencies and shapes from scipy.linalg.eigh(K, M); of each mode the free motion and the response from rest.

    The response is [cos(d t) sin(s t)/s - cos(s t) sin(d t)/d]/(2 omega_n) with the half sum s and the half difference
    d of omega and omega_n, which nothing divides by zero. Parameters and result as in `Runner`.
    """
    omega, shapes, forces = _eigenmodes(problem)
    free = _superposed(problem, omega, shapes, np.zeros(2), watch)
    if not problem.F_0:
        return free
    n, t = omega[:, None], problem.t
    s, d = (problem.omega + n) / 2, (problem.omega - n) / 2
    slow, fast = t * np.sinc(d * t / np.pi), np.sin(s * t)
    response = (np.cos(d * t) * fast / s - np.cos(s * t) * slow) / (2 * n)
    rate = problem.omega * fast * slow / (2 * s)
    pushed = shapes * forces
    return _trajectory(free.x + pushed @ response, free.v + pushed @ rate)


def naive_eigh(problem: Problem, _: float, watch: Watch) -> Trajectory:
    """Modes by eigh with the usual particular solution, mode by mode f/(omega_n^2 - omega^2).

    Parameters and result as in `Runner`.
    """
    omega, shapes, forces = _eigenmodes(problem)
    return _superposed(problem, omega, shapes, shapes @ (forces / (omega**2 - problem.omega**2)), watch)


def _eigenmodes(problem: Problem) -> tuple[Array, Array, Array]:
    """omega (2,), shapes (2, 2) in columns, and the drive's share of each."""
    from scipy.linalg import eigh

    stiffness, mass = matrices(problem)
    squares, shapes = eigh(stiffness, np.diag(mass))
    return np.sqrt(squares), shapes, shapes[0] * problem.F_0


def matrix_exponential(problem: Problem, _: float, watch: Watch) -> Trajectory:
    """Multiply by exp(A dt) from one output time to the next, with the drive as an additional oscillator.

    Parameters and result as in `Runner`.
    """
    from scipy.linalg import expm

    stiffness, mass = matrices(problem)
    A = np.zeros((6, 6))
    A[:2, 2:4] = np.eye(2)
    A[2:4, :2] = -stiffness / mass[:, None]
    A[2, 4] = problem.F_0 / mass[0]
    A[4, 5], A[5, 4] = problem.omega, -problem.omega
    A[2, 2] = -problem.c / mass[0]
    step = expm(A * problem.spacing)
    states = np.empty((problem.t.size, 6))
    states[0] = *problem.start, 0.0, 1.0
    multiply = step.dot
    for n in range(1, problem.t.size):
        states[n] = multiply(states[n - 1])
        watch.check(float(problem.t[n]))
    watch.evaluations = watch.steps = problem.t.size - 1
    return trajectory(states)


def matrices(problem: Problem) -> tuple[Array, Array]:
    """Return K (2, 2) in N/m and the diagonal of M (2,) in kg of a `problem`."""
    chain = problem.chain
    stiffness = np.array([[chain.k1 + chain.k2, -chain.k2], [-chain.k2, chain.k2]])
    return stiffness, np.array([chain.m1, chain.m2])


def _slide_particular(problem: Problem, squares: Array) -> Array:
    """Xp of slide 8."""
    chain, square = problem.chain, problem.omega**2
    D = chain.m1 * chain.m2 * (square - squares[0]) * (square - squares[1])
    if not D:
        raise StoppedError("D(omega) = 0: no particular solution", 0.0)
    amplitudes: Array = np.array([chain.k2 - chain.m2 * square, chain.k2]) * problem.F_0 / D
    return amplitudes


def _superposed(problem: Problem, omega: Array, shapes: Array, particular: Array, watch: Watch) -> Trajectory:
    """x_c + x_p: the columns of shapes at the frequencies omega, with constants that fit the start."""
    watch.evaluations = problem.t.size
    drive = problem.omega * problem.t
    cosine = np.linalg.solve(shapes, np.array(problem.x_0))
    sine = np.linalg.solve(shapes, np.array(problem.v_0) - problem.omega * particular) / omega
    angle = np.outer(omega, problem.t)
    q = cosine[:, None] * np.cos(angle) + sine[:, None] * np.sin(angle)
    p = omega[:, None] * (sine[:, None] * np.cos(angle) - cosine[:, None] * np.sin(angle))
    return _trajectory(
        shapes @ q + np.outer(particular, np.sin(drive)),
        shapes @ p + problem.omega * np.outer(particular, np.cos(drive)),
    )


def _trajectory(x: Array, v: Array) -> Trajectory:
    return Trajectory(x=x, v=v, stretch=x[1] - x[0])
