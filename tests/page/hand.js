// The page's own stage, grips and drags in Node, on a made-up layout: the effect of a pointer on the draggable shapes
// of a sheet.

import {Compare} from "../../static/compare/compare.js"
import {Clock} from "../../static/core/clock.js"
import {PLAIN} from "../../static/core/ruler.js"
import {evaluate} from "../../static/core/signals.js"
import {Hand} from "../../static/controls/hand.js"
import {geometry, Plot} from "../../static/scene/plots.js"
import {Stage} from "../../static/scene/stage.js"

const ROOM = {W: 640, H: 240}
const FRAME = {left: 40, top: 20, width: 430, height: 170}
const ASIDE = 31 // between two plots

let page, stage, grip, plots, said

/** Opens a sheet in a layout: plots, shapes (the first is dragged), a picture and an instant. */
export function open(blocks, shapes, layout, view, t) {
  const messages = {last: 0, rests: true}
  const send = ({values}) => (messages.last++, Object.assign(said, values))
  page = {host: {messages}, send, clock: new Clock(() => {}), left: true}
  page.hand = new Hand(page)
  page.compare = Object.assign(Object.create(Compare.prototype), {page})
  stage = new Stage({shapes}, document.createElement("div"), page)
  stage.size = {...ROOM, ...layout}
  grip = stage.grips?.grips.get(shapes[0]) ?? {}
  plots = blocks
  show(view)
  page.clock.seek(t)
}

/** The answer of the server. */
export function show(view) {
  page.shown = {view, answer: page.host.messages.last, errors: {}}
  page.clock.update(page.shown)
  page.hand.update(page.shown)
  const stand = plots.filter(([, x, y]) => view.axes[x] && view.axes[y])
  stage.plots = framed(stand.map(([name, x, y]) => [name, view.axes[x], view.axes[y]]))
}

/** The positions of plots by name and axes. */
function framed(all) {
  const placed = ([name, x, y], i) =>
    geometry(Object.assign(Object.create(Plot.prototype), {box: FRAME, x, y}), name, ASIDE * i, ASIDE * i)
  return Object.assign({}, ...all.map(placed))
}

/** Draws shapes once for all visible plots. A name that neither they nor the picture have is an error. */
export function draw(blocks, shapes, layout, view) {
  open(blocks, shapes, layout, view, 0)
  stage.plots = framed(blocks.map(([name]) => [name, PLAIN, PLAIN]))
  const strange = stage.shapes.flatMap(({places}) => places).find(name => !(name in stage.plots))
  if (strange) throw new Error(`No plot has “${strange}”.`)
  at(false)
}

/** The position of the grip with the dragged values or those of the picture; null if it is not drawn. */
export function at(moved) {
  const {signals, scalars} = page.shown.view
  const {t} = page.clock
  grip.x = null
  stage.frame(moved ? page.compare.named(t) : evaluate(signals, scalars, t))
  return grip.x === null ? null : [grip.x, grip.y]
}

/** Takes the grip or moves it to a place; returns the values sent to the server. */
export function does(deed, x, y) {
  said = {}
  at(true)
  grip.grip.dispatchEvent(Object.assign(new Event(deed), {button: 0, clientX: x, clientY: y}))
  return said
}
