// Placement of texts that must not overlap: pure functions of boxes and lengths in one unit.

import {clamp} from "../core/ruler.js"

/**
 * @typedef {{left: number, right: number, top: number, bottom: number}} Box
 * @typedef {{at: number, size: number}} Extent middle and length of an interval on a line
 */
/**
 * A text: its preferred boxes, best first; its largest shift from there, sideways and up or
 * down; and the room that it must not leave.
 * @typedef {{wishes: Box[], across?: number, down?: number, room?: Box}} Text
 */

const TOUCH = 0.01 // a smaller overlap counts as none
export const EVERYWHERE = {left: -Infinity, right: Infinity, top: -Infinity, bottom: Infinity}

/**
 * Places one text after the other: avoiding all fixed boxes and earlier texts, with the smallest shift; null if there
 * is no place for it.
 * @param {Text[]} texts @param {Box[]} [fixed] @returns {(Box | null)[]}
 */
export function places(texts, fixed = []) {
  const standing = [...fixed]
  return texts.map(text => {
    const place = placeOf(text, standing)
    if (place) standing.push(place)
    return place
  })
}

/** @param {Text} text @param {Box[]} others @returns {Box | null} */
function placeOf({wishes, across = 0, down = 0, room = EVERYWHERE}, others) {
  let best = null
  let least = Infinity
  for (const wish of wishes) {
    if (wish.right - wish.left > room.right - room.left || wish.bottom - wish.top > room.bottom - room.top) continue
    const box = moved(
      wish,
      inward(wish.left, wish.right, room.left, room.right),
      inward(wish.top, wish.bottom, room.top, room.bottom),
    )
    const wide = reach(box.left, box.right, room.left, room.right, across)
    const high = reach(box.top, box.bottom, room.top, room.bottom, down)
    const way = shortest(box, others, wide, high, least)
    if (way) [best, least] = [moved(box, ...way), Math.hypot(...way)]
  }
  return best
}

/**
 * The shortest shift by which a box avoids all others, if it is shorter than `limit`. The box then touches one of them
 * from the side, from above or from below, or two of them.
 * @param {Box} box @param {Box[]} others @param {[number, number]} wide @param {[number, number]} high
 * @param {number} limit @returns {[number, number] | null}
 */
function shortest(box, others, wide, [least, most], limit) {
  const near = others.filter(
    ({left, right, top, bottom}) =>
      left < box.right + wide[1] && right > box.left + wide[0] && top < box.bottom + most && bottom > box.top + least,
  )
  const downs = near.flatMap(({top, bottom}) => [top - box.bottom, bottom - box.top])
  const allowed = [0, ...downs].filter(down => down >= least && down <= most)
  let best = null
  for (const down of allowed.toSorted((one, other) => Math.abs(one) - Math.abs(other))) {
    if (Math.abs(down) >= limit) break
    const {top, bottom} = moved(box, 0, down)
    const level = near.filter(other => overlap(top, bottom, other.top, other.bottom))
    const across = step(
      level.map(({left, right}) => /** @type {[number, number]} */ ([left - box.right, right - box.left])),
      wide,
    )
    if (across === null || Math.hypot(across, down) >= limit) continue
    best = /** @type {[number, number]} */ ([across, down])
    limit = Math.hypot(across, down)
  }
  return best
}

/**
 * The smallest shift in range that is in none of these intervals, or null.
 * @param {[number, number][]} gaps @param {[number, number]} reach
 */
function step(gaps, [least, most]) {
  let [back, on] = [0, 0]
  for (const [start, end] of gaps.toSorted(([one], [other]) => one - other))
    if (start < on - TOUCH && end > on + TOUCH) on = end
  for (const [start, end] of gaps.toSorted(([, one], [, other]) => other - one))
    if (end > back + TOUCH && start < back - TOUCH) back = start
  const ways = [on, back].filter(way => way >= least && way <= most)
  return ways.length ? ways.reduce((one, other) => (Math.abs(other) < Math.abs(one) ? other : one)) : null
}

/** @param {number} start @param {number} end @param {number} from @param {number} to */
const overlap = (start, end, from, to) => start < to - TOUCH && from < end - TOUCH

/** True if two boxes overlap. @param {Box} one @param {Box} other */
export const meet = (one, other) =>
  overlap(one.left, one.right, other.left, other.right) && overlap(one.top, one.bottom, other.top, other.bottom)

/** @param {Box} box @param {number} across @param {number} down @returns {Box} */
export const moved = (box, across, down) =>
  across || down
    ? {left: box.left + across, right: box.right + across, top: box.top + down, bottom: box.bottom + down}
    : box

/**
 * The smallest shift that brings an interval into a range.
 * @param {number} low @param {number} high @param {number} least @param {number} most
 */
const inward = (low, high, least, most) => Math.max(Math.min(0, most - high), least - low)

/**
 * The distances by which an interval may move down (<= 0) and up (>= 0) within its range, at most `far` each.
 * @param {number} low @param {number} high @param {number} least @param {number} most @param {number} far
 * @returns {[number, number]}
 */
const reach = (low, high, least, most, far) => [
  Math.min(Math.max(-far, least - low), 0),
  Math.max(Math.min(far, most - high), 0),
]

/**
 * Places intervals in a row without overlaps, with the smallest shifts (least squares), between `least` and `most`. If
 * they do not fit, the row begins at `least`. Returns their middles.
 * @param {Extent[]} spans @param {number} [least] @param {number} [most]
 */
export function inLine(spans, least = -Infinity, most = Infinity) {
  const order = spans.map((_, i) => i).toSorted((i, j) => spans[i].at - spans[j].at)
  let length = 0
  /** @type {{sum: number, count: number}[]} of spans that touch: the sum of the starts of the row that they prefer */
  const groups = []
  const ends = order.map(i => (length += spans[i].size))
  for (const [place, i] of order.entries()) {
    let group = {sum: spans[i].at - ends[place] + spans[i].size / 2, count: 1}
    for (let last = groups.at(-1); last && last.sum / last.count >= group.sum / group.count; last = groups.at(-1)) {
      groups.pop()
      group = {sum: last.sum + group.sum, count: last.count + group.count}
    }
    groups.push(group)
  }
  const starts = groups.flatMap(({sum, count}) => Array.from({length: count}, () => sum / count))
  const middles = spans.map(({at}) => at)
  for (const [place, i] of order.entries()) {
    const start = clamp(starts[place], least, most - length)
    middles[i] = start + ends[place] - spans[i].size / 2
  }
  return middles
}

/** @param {Extent} one @param {Extent} next */
const touch = (one, next) => Math.abs(next.at - one.at) < (one.size + next.size) / 2

/** The least n such that every n-th span, counted from the last, does not touch the next. @param {Extent[]} spans */
export function everyWhich(spans) {
  const last = spans.length - 1
  let which = 1
  while (spans.some((span, i) => (last - i) % which === 0 && i + which <= last && touch(span, spans[i + which])))
    which++
  return which
}
