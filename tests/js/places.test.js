// Places for labels: none overlaps another or leaves the area, the order stays, and moves are minimal.

import assert from "node:assert/strict"
import {test} from "node:test"

import {everyWhich, inLine, places} from "../../static/scene/places.js"

const ROOM = {left: 0, right: 300, top: 0, bottom: 200}

/** Numbers from 0 to 1, the same in each run. */
function numbers(seed) {
  let state = (seed * 1_299_709) % 2147483647
  return () => (state = (state * 16807) % 2147483647) / 2147483647
}

const box = (left, top, width, height) => ({left, right: left + width, top, bottom: top + height})
const some = (count, make) => Array.from({length: count}, (_, i) => make(i))
const meet = (one, other) =>
  Math.min(one.right, other.right) - Math.max(one.left, other.left) > 0.02 &&
  Math.min(one.bottom, other.bottom) - Math.max(one.top, other.top) > 0.02
const isIn = ({left, right, top, bottom}, room) =>
  left >= room.left - 0.02 && right <= room.right + 0.02 && top >= room.top - 0.02 && bottom <= room.bottom + 0.02
const far = (one, other) => Math.hypot(one.left - other.left, one.top - other.top)

/** Random texts and fixed boxes. */
function crowd(seed) {
  const number = numbers(seed)
  const fixed = some(Math.floor(12 * number()), () => box(280 * number(), 180 * number(), 60 * number(), 30 * number()))
  const texts = some(1 + Math.floor(9 * number()), () => ({
    wishes: some(1 + Math.floor(2 * number()), () =>
      box(320 * number() - 20, 220 * number() - 20, 20 + 50 * number(), 14),
    ),
    across: number() < 0.3 ? 300 : 0,
    down: number() < 0.8 ? 60 * number() : 0,
    room: ROOM,
  }))
  return {fixed, texts}
}

test("no text overlaps another or a fixed box, and none leaves the area", () => {
  for (let seed = 1; seed < 400; seed++) {
    const {fixed, texts} = crowd(seed)
    const found = places(texts, fixed)
    assert.deepEqual(found, places(texts, fixed), "found anew")
    const standing = found.filter(Boolean)
    for (const [i, one] of standing.entries()) {
      assert.ok(isIn(one, ROOM))
      assert.ok(![...fixed, ...standing.slice(0, i)].some(other => meet(one, other)), `seed ${seed}`)
    }
  }
})

test("texts move no further than an exhaustive search finds, and disappear only if there is no place", () => {
  let moved = 0
  let gone = 0
  for (let seed = 1; seed < 400; seed++) {
    const {fixed, texts} = crowd(seed)
    const [{wishes, across, down}] = texts
    const wish = wishes[0]
    if (!isIn(wish, ROOM)) continue
    const [place] = places([{wishes: [wish], across, down, room: ROOM}], fixed)
    for (let dx = -across; dx <= across; dx += 3) {
      for (let dy = -Math.floor(down); dy <= down; dy++) {
        const there = box(wish.left + dx, wish.top + dy, wish.right - wish.left, 14)
        if (!isIn(there, ROOM) || fixed.some(other => meet(there, other))) continue
        assert.ok(place && far(wish, place) <= Math.hypot(dx, dy) + 0.03, `seed ${seed}`)
      }
    }
    if (place && far(wish, place) > 0) moved++
    if (!place) gone++
  }
  assert.ok(moved > 3 && gone > 0)
})

test("a text without collisions stays, at its first preferred place", () => {
  const [wish, other] = [box(10, 10, 40, 14), box(10, 60, 40, 14)]
  assert.equal(places([{wishes: [wish, other]}])[0], wish)
  assert.equal(places([{wishes: [wish, other], down: 5}], [box(0, 0, 100, 20)])[0], other)
  assert.deepEqual(places([{wishes: [wish, other], down: 50}], [box(0, 0, 100, 12), other])[0], box(10, 12, 40, 14))
})

test("a text is moved into its area, and has no place if the area is too small", () => {
  assert.deepEqual(places([{wishes: [box(-20, 190, 40, 14)], room: ROOM}]), [box(0, 186, 40, 14)])
  assert.deepEqual(places([{wishes: [box(-20, 10, 400, 14)], room: ROOM}]), [null])
})

test("on a line texts keep their order, none touches the next or leaves, and texts without neighbours stay", () => {
  for (let seed = 1; seed < 400; seed++) {
    const number = numbers(seed)
    const spans = some(Math.floor(8 * number()), () => ({at: 240 * number() - 20, size: 5 + 20 * number()}))
    const length = spans.reduce((sum, {size}) => sum + size, 0)
    const found = inLine(spans, 0, 200)
    const order = spans.map((_, i) => i).sort((i, j) => spans[i].at - spans[j].at)
    for (const [place, i] of order.entries()) {
      const next = order[place + 1]
      assert.ok(found[i] + spans[i].size / 2 <= 200 + 1e-9)
      if (length <= 200) assert.ok(found[i] - spans[i].size / 2 >= -1e-9)
      if (next !== undefined) assert.ok(found[next] - found[i] >= (spans[i].size + spans[next].size) / 2 - 1e-9)
    }
  }
  const apart = [
    {at: 150, size: 10},
    {at: 20, size: 20},
    {at: 100, size: 90},
  ]
  assert.deepEqual(inLine(apart), [150, 20, 100])
})

test("two texts that would touch move equally, and no other arrangement is closer to all preferred places", () => {
  assert.deepEqual(
    inLine([
      {at: 100, size: 16},
      {at: 104, size: 16},
    ]),
    [94, 110],
  )
  assert.deepEqual(
    inLine(
      [
        {at: 0, size: 16},
        {at: 4, size: 16},
      ],
      0,
    ),
    [8, 24],
  )
  const cost = (found, spans) => found.reduce((sum, at, i) => sum + (at - spans[i].at) ** 2, 0)
  for (let seed = 1; seed < 60; seed++) {
    const number = numbers(seed)
    const spans = some(4, () => ({at: 100 * number(), size: 20})).sort((one, other) => one.at - other.at)
    const found = inLine(spans)
    for (let i = 0; i < 2000; i++) {
      const other = found.map(at => at + 8 * (number() - 0.5))
      if (other.every((at, j) => j === 0 || at - other[j - 1] >= 20))
        assert.ok(cost(other, spans) >= cost(found, spans) - 1e-9)
    }
  }
})

test("of ticks that would touch, every second or fewer is shown, always the last", () => {
  const row = (gap, size, count = 6) => some(count, i => ({at: i * gap, size}))
  assert.equal(everyWhich(row(10, 10)), 1)
  assert.equal(everyWhich(row(10, 11)), 2)
  assert.equal(everyWhich(row(-10, 25)), 3)
  assert.equal(everyWhich(row(1, 1000)), 6)
  assert.equal(everyWhich([]), 1)
})
