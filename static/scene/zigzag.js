// The outline of a spring between two points.

/**
 * @param {number} x1 @param {number} y1 @param {number} x2 @param {number} y2 @param {number} height half the width of
 * the teeth @param {number} [teeth]
 */
export function zigzag(x1, y1, x2, y2, height, teeth = 9) {
  const length = Math.hypot(x2 - x1, y2 - y1) || 1
  const ux = (x2 - x1) / length
  const uy = (y2 - y1) / length
  const ends = Math.min(12, length * 0.15)
  const step = (length - 2 * ends) / (2 * teeth)
  /** @param {number} along @param {number} across */
  const at = (along, across) =>
    `${(x1 + ux * along - uy * across).toFixed(2)} ${(y1 + uy * along + ux * across).toFixed(2)}`
  const points = [at(0, 0), at(ends, 0)]
  for (let i = 0; i < 2 * teeth; i++) points.push(at(ends + step * (i + 0.5), i % 2 ? height : -height))
  points.push(at(length - ends, 0), at(length, 0))
  return "M" + points.join("L")
}
