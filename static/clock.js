// The page's only clock: it plays through the time window in the browser alone.

const STEPS_PER_CYCLE = 24

export class Clock {
  constructor(draw) {
    this.draw = draw
    this.t = 0                 // in the unit of the time axis
    this.end = 1
    this.unit = 1              // seconds in that unit
    this.pace = 1              // simulated over real seconds that 'auto' plays at
    this.limit = Infinity      // the fastest at which the fastest motion can still be seen
    this.choice = "auto"
    this.playing = !matchMedia("(prefers-reduced-motion: reduce)").matches
    this.last = null
    this.dirty = true
    this.running = true
    this.frames = 0
    this.listeners = []
    requestAnimationFrame(now => this.tick(now))
  }

  get factor() {
    return Math.min(this.choice === "auto" ? this.pace : this.choice, this.limit)
  }

  get slowed() {
    return (this.choice === "auto" ? this.pace : this.choice) > this.limit
  }

  update(axis, scalars) {
    this.end = axis.end
    this.unit = 10 ** axis.exponent
    this.pace = scalars.pace ?? 1
    this.limit = scalars.limit ?? Infinity
    if (this.t > this.end) this.t = 0
    this.touch()
  }

  touch() {
    this.dirty = true
    this.listeners.forEach(listen => listen())
  }

  toggle() {
    this.playing = !this.playing
    this.touch()
  }

  seek(t) {
    this.t = Math.min(Math.max(t, 0), this.end)
    this.touch()
  }

  // A step is a twenty-fourth of what takes 6 s at the auto speed: about a swing.
  step(direction) {
    this.playing = false
    this.seek(this.t + direction * Math.min(6 * Math.min(this.pace, this.limit) / this.unit, this.end) / STEPS_PER_CYCLE)
  }

  faster(power) {
    this.choice = Math.min(Math.max(2 ** (Math.round(Math.log2(this.choice === "auto" ? 1 : this.choice)) + power), 1 / 16), 16)
    this.touch()
  }

  auto() {
    this.choice = "auto"
    this.touch()
  }

  tick(now) {
    if (!this.running) return
    requestAnimationFrame(later => this.tick(later))
    if (this.playing && this.last !== null) {
      // A tab that was hidden goes on from where it stood.
      const seconds = Math.min((now - this.last) / 1000, 0.1)
      this.t += seconds * this.factor / this.unit
      if (this.t > this.end) this.t %= this.end
      this.dirty = true
    }
    this.last = now
    if (!this.dirty) return
    this.dirty = false
    this.frames += 1
    this.draw(this.t)
  }

  stop() {
    this.running = false
  }
}
