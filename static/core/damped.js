// The free and driven motion of one damped mass; exact at critical damping, at resonance and without damping.

const EARLY = 2 // rad; up to here the power series is exact to the last digit
const TERMS = 34
const SERIES = 20

/** @typedef {[number, number]} Complex */

/** The phase, or 0 if it overflowed and is therefore unknown. @param {number} phase */
export const circled = phase => (Number.isFinite(phase) ? phase : 0)

/** exp(re + i im). @param {number} re @param {number} im @returns {Complex} */
function exponential(re, im) {
  const size = Math.exp(re)
  return [size * Math.cos(circled(im)), size * Math.sin(circled(im))]
}

/** @param {Complex} a @param {Complex} b @returns {Complex} */
const times = ([a, b], [c, d]) => [a * c - b * d, a * d + b * c]

/** @param {Complex} a @param {Complex} b @returns {Complex} */
const minus = ([a, b], [c, d]) => [a - c, b - d]

/** @param {Complex} a @param {Complex} b @returns {Complex} */
function over(a, [c, d]) {
  const size = Math.max(Math.abs(c), Math.abs(d))
  const [e, f] = [c / size, d / size]
  const square = (e * e + f * f) * size
  return times(a, [e / square, -f / square])
}

/**
 * The free motion from 0 with initial velocity 1, without its decay factor; at critical damping it is t.
 * @param {number} apart @param {number} swing @param {number} t
 */
function grown(apart, swing, t) {
  if (swing) return Math.sin(circled(swing * t)) / swing
  return apart ? -Math.expm1(-apart * t) / apart : t
}

/** @param {page.DampedMass} signal @param {number} t */
export function damped({start, rate, slow, apart, swing, late: [A, B]}, t) {
  if (apart * t > 1) return A * Math.exp(-slow * t) + B * Math.exp(-(slow + apart) * t)
  const decay = slow ? Math.exp(-slow * t) : 1
  const cosine = swing ? Math.cos(circled(swing * t)) : 1
  return decay * (start * cosine + rate * grown(apart, swing, t))
}

/** @param {page.DrivenMass} signal @param {number} t */
export function driven(signal, t) {
  const [re, im] = fromRest(signal, t)
  return signal.re * im + signal.im * re
}

/**
 * The motion from rest, E'' + 2 a E' + omega_n^2 E = exp(i omega t). Chooses among four formulas the one that loses no
 * digits here.
 * @param {page.DrivenMass} signal @param {number} t
 */
function fromRest(signal, t) {
  const {omega, omega_n: own, slow, apart, swing} = signal
  if (Math.max(omega, own, slow + apart) * t <= EARLY) return byPowers(signal, t)
  const near = swing > 0 && slow < own / 2 && own / 2 < omega && omega < 2 * own
  return near || apart * t > 1 ? byParts(signal, t) : plainly(signal, t)
}

/** @param {page.DrivenMass} signal @param {number} t @returns {Complex} */
function byPowers({omega, omega_n: own, slow, apart}, t) {
  const damping = (2 * slow + apart) * t
  const square = (own * t) ** 2
  let [before, last, total] = [0, 0, 0]
  let [before_i, last_i, total_i] = [0, 0, 0]
  let [term, term_i] = [t * t, 0]
  for (let k = 0; k < TERMS; k++) {
    const below = (k + 2) * (k + 1)
    const next = (term - damping * (k + 1) * last - square * before) / below
    const next_i = (term_i - damping * (k + 1) * last_i - square * before_i) / below
    ;[before, last, before_i, last_i] = [last, next, last_i, next_i]
    total += next
    total_i += next_i
    const turn = (omega * t) / (k + 1)
    ;[term, term_i] = [-turn * term_i, turn * term]
  }
  return [total, total_i]
}

/**
 * The second divided difference of exp(s t) at i omega and the two roots: the difference of two first divided
 * differences.
 * @param {page.DrivenMass} signal @param {number} t
 */
function byParts({omega, slow, apart, swing, detuning}, t) {
  const one = divided(-slow, swing, [slow, swing ? detuning : omega], omega, t)
  const two = divided(-slow - apart, -swing, [slow + apart, omega + swing], omega, t)
  return over(minus(one, two), [apart, 2 * swing])
}

/**
 * (exp(i omega t) - exp(p t))/step, where step = i omega - p.
 * @param {number} re of p @param {number} im @param {Complex} step @param {number} omega @param {number} t
 */
function divided(re, im, step, omega, t) {
  const own = exponential(re * t, im * t)
  if (-re * t >= 1) return over(minus(exponential(0, omega * t), own), step)
  /** @type {Complex} */
  const z = [step[0] * t, step[1] * t]
  return times([own[0] * t, own[1] * t], perStep(z))
}

/** (exp(z) - 1)/z. @param {Complex} z @returns {Complex} */
function perStep(z) {
  if (Math.hypot(...z) >= 1) {
    const half = Math.sin(circled(z[1]) / 2)
    const grew = Math.expm1(z[0]) * Math.cos(circled(z[1])) - 2 * half * half
    return over([grew, Math.exp(z[0]) * Math.sin(circled(z[1]))], z)
  }
  /** @type {Complex} */
  let sum = [1, 0]
  for (let k = SERIES; k > 0; k--) {
    const [re, im] = times(z, sum)
    sum = [1 + re / (k + 1), im / (k + 1)]
  }
  return sum
}

/**
 * The steady motion minus the free motion with the same initial conditions.
 * @param {page.DrivenMass} signal @param {number} t
 */
function plainly({omega, omega_n: own, slow, apart, swing}, t) {
  const steady = over([1, 0], [(own - omega) * (own + omega), (2 * slow + apart) * omega])
  const decay = Math.exp(-slow * t)
  const cosine = decay * (swing ? Math.cos(circled(swing * t)) : 1)
  const sine = decay * grown(apart, swing, t)
  const turned = exponential(0, omega * t)
  return times(steady, [turned[0] - cosine - slow * sine, turned[1] - omega * sine])
}
