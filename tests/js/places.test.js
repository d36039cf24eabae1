// Places for labels, which do not overlap and move as little as possible, and for the steps of a handout on pages.

import assert from "node:assert/strict"
import {test} from "node:test"

import {numbers} from "./browser.js"

const {packed} = await import("../../static/export/pages.js")
const {everyWhich, inLine, places} = await import("../../static/scene/places.js")

const ROOM = {left: 0, right: 300, top: 0, bottom: 200}
const SEEDS = 400

const box = (left, top, width, height = 14) => ({left, right: left + width, top, bottom: top + height})
const some = (count, make) => Array.from({length: count}, (_, i) => make(i))
const isIn = ({left, right, top, bottom}, room) =>
  left >= room.left - 0.02 && right <= room.right + 0.02 && top >= room.top - 0.02 && bottom <= room.bottom + 0.02
const meet = (one, other) =>
  Math.min(one.right, other.right) - Math.max(one.left, other.left) > 0.01 &&
  Math.min(one.bottom, other.bottom) - Math.max(one.top, other.top) > 0.01
const far = (one, other) => Math.hypot(one.left - other.left, one.top - other.top)

/** Random texts and fixed boxes. */
function crowd(seed) {
  const number = numbers(seed)
  const fixed = some(Math.floor(12 * number()), () => box(280 * number(), 180 * number(), 60 * number(), 30 * number()))
  const wish = () => box(320 * number() - 20, 220 * number() - 20, 20 + 50 * number())
  const texts = some(1 + Math.floor(9 * number()), () => ({
    wishes: some(1 + Math.floor(2 * number()), wish),
    across: number() < 0.3 ? 300 : 0,
    down: number() < 0.8 ? 60 * number() : 0,
    room: ROOM,
  }))
  return {fixed, texts}
}

/** The shortest shift of a text to a free place, in steps of 3 sideways and 1 up or down. */
function shortest({wishes: [wish], across, down}, fixed) {
  let least = Infinity
  for (let dx = -across; dx <= across; dx += 3)
    for (let dy = -Math.floor(down); dy <= down; dy++) {
      const there = box(wish.left + dx, wish.top + dy, wish.right - wish.left)
      const isFree = isIn(there, ROOM) && !fixed.some(other => meet(there, other))
      if (isFree) least = Math.min(least, Math.hypot(dx, dy))
    }
  return least
}

test("texts do not overlap or leave the area, and move as little as an exhaustive search finds", () => {
  for (let seed = 1; seed < SEEDS; seed++) {
    const {fixed, texts} = crowd(seed)
    const standing = places(texts, fixed).filter(Boolean)
    for (const [i, one] of standing.entries()) {
      assert.ok(isIn(one, ROOM))
      assert.ok(![...fixed, ...standing.slice(0, i)].some(other => meet(one, other)), `seed ${seed}`)
    }
    const [{wishes, ...first}] = texts
    const [wish] = wishes
    if (!isIn(wish, ROOM)) continue
    const [place] = places([{...first, wishes: [wish]}], fixed)
    assert.ok((place ? far(wish, place) : Infinity) <= shortest(texts[0], fixed) + 0.03, `seed ${seed}`)
  }
})

const [WISH, NEXT] = [box(10, 10, 40), box(10, 60, 40)]
for (const [name, texts, fixed, expected] of [
  ["without collisions stays at its first preferred place", {wishes: [WISH, NEXT]}, [], WISH],
  ["takes the second one if the first is not free", {wishes: [WISH, NEXT], down: 5}, [box(0, 0, 100, 20)], NEXT],
  ["moves if neither is free", {wishes: [WISH, NEXT], down: 50}, [box(0, 0, 100, 12), NEXT], box(10, 12, 40)],
  ["is moved into its area", {wishes: [box(-20, 190, 40)], room: ROOM}, [], box(0, 186, 40)],
  ["has no place in an area that is too small", {wishes: [box(-20, 10, 400)], room: ROOM}, [], null],
])
  test(`a text ${name}`, () => assert.deepEqual(places([texts], fixed), [expected]))

test("texts on a line keep their order, do not touch or leave it, and move as little as possible", () => {
  for (let seed = 1; seed < SEEDS; seed++) {
    const number = numbers(seed)
    const spans = some(Math.floor(8 * number()), () => ({at: 240 * number() - 20, size: 5 + 20 * number()}))
    spans.sort((one, other) => one.at - other.at)
    const length = spans.reduce((sum, {size}) => sum + size, 0)
    const [bounded, free] = [inLine(spans, 0, 200), inLine(spans)]
    const apart = (at, i) => !i || at[i] - at[i - 1] >= (spans[i].size + spans[i - 1].size) / 2 - 1e-9
    const cost = at => spans.reduce((sum, span, i) => sum + (at[i] - span.at) ** 2, 0)
    for (const [i, {size}] of spans.entries()) {
      assert.ok(bounded[i] + size / 2 <= 200 + 1e-9 && (length > 200 || bounded[i] - size / 2 >= -1e-9))
      assert.ok(apart(bounded, i) && apart(free, i))
    }
    for (let i = 0; i < 100; i++) {
      const other = free.map(at => at + 8 * (number() - 0.5))
      assert.ok(!other.every((_, j) => apart(other, j)) || cost(other) >= cost(free) - 1e-9)
    }
    assert.deepEqual(inLine(spans.toReversed(), 0, 200).toReversed(), bounded)
  }
  const two = [{at: 0, size: 16}, {at: 4, size: 16}] // prettier-ignore
  assert.deepEqual([inLine(two), inLine(two, 0)], [[-6, 10], [8, 24]]) // prettier-ignore
})

test("of ticks that would touch, every second or fewer is shown, always the last", () => {
  const which = (gap, size, count = 6) => everyWhich(some(count, i => ({at: i * gap, size})))
  assert.deepEqual([which(10, 10), which(10, 11), which(-10, 25), which(1, 1000), which(1, 1, 0)], [1, 2, 3, 6, 1])
})

// prettier-ignore
for (const [heights, pages] of [
  [[300, 300, 300, 100], [[0, 2], [2, 4]]],
  [[100, 2000, 100], [[0, 1], [1, 2], [2, 3]]],
  [[400, 500, 60, 900], [[0, 1], [1, 3], [3, 4]]],
  [[500, 450, 900, 20, 20, 20], [[0, 2], [2, 3], [3, 6]]],
])
  test(`steps of ${heights} are unbroken, on few pages that are filled evenly; a long step has its own`, () => {
    assert.deepEqual(packed(heights, 950), pages)
  })
