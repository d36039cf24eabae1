// What moves: signals evaluated from a few scalars at any instant (the browser's half of components/motion.py).

const sinc = (rate, t) => (Math.abs(rate * t) < 1e-4 ? t * (1 - (rate * t) ** 2 / 6) : Math.sin(rate * t) / rate)

// From rest, x'' + n² x = sin(w t): the response, and its velocity; regular at w = n and at n = 0.
function response(w, n, t) {
  const largest = Math.max(w, n) * t
  if (largest < 1e-2) return [w * t ** 3 / 6, w * t ** 2 / 2]
  const velocity = (w / 2) * sinc((w + n) / 2, t) * sinc((w - n) / 2, t)
  if (n * t < 1e-4) return [(w * t - Math.sin(w * t)) / w ** 2, velocity]
  if (w * t < 1e-4) return [(w / n ** 2) * (t - Math.sin(n * t) / n), velocity]
  const s = (w + n) / 2, d = (w - n) / 2
  if (Math.abs(d) > 0.3 * s) return [(n * Math.sin(w * t) - w * Math.sin(n * t)) / (n * (n - w) * (n + w)), velocity]
  return [(Math.cos(d * t) * sinc(s, t) - Math.cos(s * t) * sinc(d, t)) / (2 * n), velocity]
}

function hermite({period, y, dy, drift}, t) {
  const turns = Math.floor(t / period), count = y.length - 1
  const place = Math.min((t / period - turns) * count, count - 1e-9)
  const i = Math.floor(place), u = place - i, h = period / count
  const a = (1 + 2 * u) * (1 - u) ** 2, b = u * (1 - u) ** 2, c = u * u * (3 - 2 * u), d = u * u * (u - 1)
  return turns * drift + a * y[i] + b * h * dy[i] + c * y[i + 1] + d * h * dy[i + 1]
}

export function polynomial(terms, named) {
  if (typeof terms === "number") return terms
  let sum = 0
  for (const term of terms) {
    let product = term[0]
    for (let i = 1; i < term.length; i++) product *= named[term[i]] ?? 0
    sum += product
  }
  return sum
}

// All signals at the instant t, in the order given, over the scalars.
export function evaluate(signals, scalars, t) {
  const named = {...scalars, t}
  for (const [name, signal] of Object.entries(signals)) {
    let value = 0
    if (signal.polynomial) value = polynomial(signal.polynomial, named)
    if (signal.line) value += signal.line[0] + signal.line[1] * t
    for (const [size, omega, phase] of signal.sines ?? []) value += size * Math.sin(omega * t + phase)
    for (const [size, w, n] of signal.responses ?? []) value += size * response(w, n, t)[0]
    for (const [size, w, n] of signal.rates ?? []) value += size * response(w, n, t)[1]
    if (signal.sine) value += Math.sin(named[signal.sine])
    if (signal.cosine) value += Math.cos(named[signal.cosine])
    if (signal.table) value += hermite(signal.table, t)
    named[name] = value
  }
  return named
}
