// Draws a stage: shapes whose numbers are polynomials in the signals, evaluated at every frame.

import {beads, pointed} from "./beads.js"
import {LabelCollisions} from "./label_collisions.js"
import {coveredPlots, tells} from "../compare/cover.js"
import {inUnits, setAttributes, svg, unitSize, words} from "../core/dom.js"
import {Grips} from "../controls/grips.js"
import {atInstant} from "../core/signals.js"
import {zigzag} from "./zigzag.js"

/** A line, shifted along its direction by its gap. @param {AtInstant<page.Arrow>} line */
function ahead({x1, y1, x2, y2, gap}) {
  const length = Math.hypot(x2 - x1, y2 - y1) || 1
  const dx = ((x2 - x1) / length) * gap
  const dy = ((y2 - y1) / length) * gap
  return {x1: x1 + dx, y1: y1 + dy, x2: x2 + dx, y2: y2 + dy}
}

/** @type {{[Name in page.AnyShape["kind"]]: Kind<Extract<page.AnyShape, {kind: Name}>>}} */
const KINDS = {
  spring: {
    make: () => [svg("path", {class: "spring"})],
    move([path], s) {
      setAttributes(path, {d: zigzag(s.x1, s.y1, s.x2, s.y2, s.height)})
      path.style.strokeWidth = String(s.wire)
    },
  },
  box: {
    make: s => [
      svg("rect", {class: "mass", rx: 3}),
      svg("text", {class: "on v t3", "text-anchor": "middle"}, ...words(s.label)),
    ],
    move([rect, text], s) {
      setAttributes(rect, {x: s.x - s.side / 2, y: s.y - s.side, width: s.side, height: s.side})
      setAttributes(text, s.corner ? {x: s.x - s.side / 2 + 14, y: s.y - 9} : {x: s.x, y: s.y - s.side / 2 + 6})
      text.style.display = s.side < 24 ? "none" : ""
    },
    hold: s => [s.x, s.y - s.side / 2, s.side],
  },
  line: {
    make: () => [svg("line", {class: "ln"})],
    move([line], {x1, y1, x2, y2}) {
      setAttributes(line, {x1, y1, x2, y2})
    },
  },
  arrow: {
    make: () => [svg("line", {class: "shaft"}), svg("path", {class: "fill"})],
    move([line, head], s) {
      const {x1, y1, x2, y2} = s.gap ? ahead(s) : s
      const length = Math.hypot(x2 - x1, y2 - y1)
      const shown = length > 1
      const size = Math.min(s.head, length)
      const angle = Math.atan2(y2 - y1, x2 - x1)
      setAttributes(line, {x1, y1, x2: x2 - size * 0.8 * Math.cos(angle), y2: y2 - size * 0.8 * Math.sin(angle)})
      const transform = `translate(${x2} ${y2}) rotate(${(angle * 180) / Math.PI})`
      setAttributes(head, {d: `M0 0L${-size} ${-size * 0.5}L${-size} ${size * 0.5}Z`, transform})
      line.style.display = head.style.display = shown ? "" : "none"
    },
    hold: s => [s.x2, s.y2, 0],
  },
  circle: {
    make: () => [svg("circle", {class: "dot"})],
    move([circle], s) {
      setAttributes(circle, {cx: s.x, cy: s.y, r: Math.max(s.r, 0)})
    },
    hold: s => [s.x, s.y, 2 * s.r],
  },
  path: {
    make: s => [svg("path", {class: "ln", d: s.d})],
    move([path], s) {
      const turn = s.dx || s.dy ? Math.atan2(s.dy, s.dx) : s.turn
      setAttributes(path, {
        transform: `translate(${s.x} ${s.y}) rotate(${(turn * 180) / Math.PI}) scale(${s.sx} ${s.sy})`,
      })
    },
    hold: s => [s.x, s.y, 0],
  },
  arc: {
    make: () => [svg("path", {class: "ln"})],
    move([path], s) {
      /** @param {number} angle */
      const at = angle => `${(s.x + s.r * Math.sin(angle)).toFixed(2)} ${(s.y + s.r * Math.cos(angle)).toFixed(2)}`
      const middle = (s.start + s.end) / 2
      const sweep = s.end > s.start ? 0 : 1
      const arcs = [middle, s.end].map(angle => `A${s.r} ${s.r} 0 0 ${sweep} ${at(angle)}`)
      setAttributes(path, {d: `M${at(s.start)}${arcs.join("")}`})
    },
  },
  wave: {
    make: () => [svg("path", {class: "ln"})],
    move([path], s) {
      const count = 24 * Math.ceil(Math.abs(s.turns) + 1)
      const points = []
      for (let i = 0; i <= count; i++) {
        const share = i / count
        const angle = 2 * Math.PI * s.turns * share + s.phase
        points.push(`${(s.x + s.length * share).toFixed(2)} ${(s.y - s.size * Math.sin(angle)).toFixed(2)}`)
      }
      const floor = s.depth ? `L${s.x + s.length} ${s.y + s.depth}L${s.x} ${s.y + s.depth}Z` : ""
      setAttributes(path, {d: `M${points.join("L")}${floor}`})
    },
  },
  layers: {
    make: () => [svg("path", {class: "ln"})],
    move([path], s) {
      const strokes = []
      for (let i = 1; i < s.count; i++) {
        const share = i / s.count
        const x = s.x + s.length * share + s.size * Math.sin(2 * Math.PI * s.turns * share)
        strokes.push(`M${x.toFixed(2)} ${s.y}v${s.height}`)
      }
      setAttributes(path, {d: strokes.join("")})
    },
  },
  text: {
    make: s => [
      svg("text", {"text-anchor": s.anchor === "beside" ? "start" : s.anchor, class: "t1"}, ...words(s.words)),
    ],
    move([text], {x, y}) {
      setAttributes(text, {x, y})
    },
  },
  wall: {
    make: () => [svg("path", {class: "hatch"}), svg("line", {class: "wall"})],
    move([hatch, line], s) {
      const upright = s.side === "left" || s.side === "right"
      const long = s.depth
      const depth = s.side === "left" || s.side === "top" ? -long : long
      const strokes = []
      for (let at = 0; at <= s.length - long / 2; at += 0.9 * long) {
        strokes.push(upright ? `M${s.x} ${s.y + at}l${depth} ${long}` : `M${s.x + at + long} ${s.y}l${-long} ${depth}`)
      }
      setAttributes(hatch, {d: strokes.join("")})
      setAttributes(line, {x1: s.x, y1: s.y, x2: upright ? s.x : s.x + s.length, y2: upright ? s.y + s.length : s.y})
    },
  },
  beads,
}

/** @param {page.AnyShape} shape */
export const kindOf = shape => /** @type {Kind} */ (KINDS[shape.kind])

export class Stage {
  /** @type {Canvas | undefined} a plot under this stage, of the same size, whose texts are placed already */
  under

  /** @type {Named} `wide` is 1 if lines of plots continue on this stage */
  join = {}

  /** @type {Set<string>} the plots next to it */
  beside = new Set()

  /** @type {Named} */
  nowhere = {}

  /** @type {Named | undefined} all quantities of the last drawn frame */
  named

  /** @type {(() => void) | undefined} called when the size has changed */
  resized

  /** @type {IntersectionObserver | undefined} */
  eyes

  isSeen = true

  /**
   * If `page` is given, its shapes can be dragged.
   * @param {Pick<page.StageBlock, "shapes" | "label">} block @param {HTMLElement} host
   * @param {PartHost} [page]
   */
  constructor(block, host, page) {
    this.svg = svg(
      "svg",
      block.label ? {role: "img", "aria-label": block.label, class: "stage"} : {"aria-hidden": "true", class: "stage"},
    )
    host.append(this.svg)
    this.host = host
    /** @type {Named} */
    this.size = {W: 1, H: 1}
    /** @type {Named} */
    this.plots = {}
    /** @type {Map<string, {rect: SVGRectElement, id: string}>} */
    this.frames = new Map()
    this.shapes = block.shapes.map(spec => {
      const kind = kindOf(spec)
      const parts = kind.make(spec)
      const group = svg("g", {class: `${spec.tint} ${spec.style}`}, ...parts)
      for (const part of parts) if (spec.style) part.classList.add(...spec.style.split(" "))
      this.svg.append(group)
      if (spec.inside) group.setAttribute("clip-path", `url(#${this.#frame(spec.inside)})`)
      const moving = Object.entries(spec).filter(([, value]) => value?.terms)
      const needs = new Set(
        moving.flatMap(([, {terms}]) => terms.flatMap((/** @type {page.Product} */ term) => term[1])),
      )
      const places = [...needs].filter(name => name.includes("."))
      const plots = new Set(places.map(name => name.split(".")[0])) // the plots whose coordinates it uses
      return {spec, kind, parts, group, moving, needs, places, plots, covered: false}
    })
    if (page && block.shapes.some(shape => shape.grab)) this.grips = new Grips(host, page)
    for (const shape of block.shapes) if (shape.grab) this.grips?.add(shape, shape.grab)
    if (page) pointed(this, page)
    this.#joins()
    this.collisions = new LabelCollisions(this.shapes)
    this.observer = new ResizeObserver(() => {
      const before = this.size
      this.place()
      if (Object.entries(this.size).some(([name, value]) => value !== before[name])) this.resized?.()
    })
    this.observer.observe(host)
  }

  /** Updates its shapes only while it is on the screen. For small pictures in a row that scrolls. */
  skipUnseen() {
    this.eyes = new IntersectionObserver(seen => {
      this.isSeen = seen.at(-1)?.isIntersecting ?? true
      this.resized?.()
    })
    this.eyes.observe(this.host)
  }

  /** Finds the plots next to it on a wide screen, whose lines continue on the stage. */
  #joins() {
    const joined = this.shapes.filter(({needs}) => needs.has("wide"))
    this.beside = new Set(joined.flatMap(({plots}) => [...plots]))
    // Coordinates to use while those plots are elsewhere or hidden.
    this.nowhere = Object.fromEntries(joined.flatMap(({places}) => places.map(name => [name, 0])))
  }

  /** Adapts to the current size. */
  place() {
    const box = this.svg.getBoundingClientRect()
    const [W, H] = [box.width / unitSize(), box.height / unitSize()]
    inUnits(this.svg, W, H)
    this.collisions.forget()
    // The style sheets decide if blocks are stacked, visible in hall mode, or if a stage is low.
    const style = getComputedStyle(this.svg)
    const [narrow, hall, low] = ["--stacked", "--hall", "--low"].map(name => Number(style.getPropertyValue(name)))
    this.size = {W, H, narrow, wide: 1 - narrow, stacked: narrow, hall, desk: 1 - hall, low}
  }

  leave() {
    this.observer.disconnect()
    this.eyes?.disconnect()
  }

  /**
   * The positions of the plots relative to this stage; measured again only if the page has changed.
   * @param {{host: HTMLElement, geometry(origin: DOMRect): Named}[]} plots
   */
  measure(plots) {
    const origin = this.svg.getBoundingClientRect()
    this.collisions.measure(this.host, origin, this.under)
    this.plots = Object.assign({}, ...plots.map(plot => plot.geometry(origin)))
    const isJoined = !this.size.narrow && [...this.beside].every(name => `${name}.left` in this.plots)
    this.join = {wide: Number(isJoined), narrow: Number(!isJoined)}
    // On a phone the plot of a question is moved, so lines that join it to others would cross the card.
    this.apart = this.size.narrow > 0 && plots.some(({host}) => host.matches(".sketched, .marked"))
    for (const [plot, {rect}] of this.frames) {
      if (!(`${plot}.left` in this.plots)) continue
      const [left, right, top, bottom] = ["left", "right", "top", "bottom"].map(side => this.plots[`${plot}.${side}`])
      const [width, height] = [Math.max(right - left, 0) + 12, Math.max(bottom - top, 0) + 12]
      setAttributes(rect, {x: left - 6, y: top - 6, width, height})
    }
  }

  /** The clip path for shapes inside the frame of a plot, created on demand. @param {string} plot */
  #frame(plot) {
    const known = this.frames.get(plot)
    if (known) return known.id
    const rect = svg("rect")
    const clip = svg("clipPath", {id: `frame-of-${plot}`}, rect)
    this.svg.prepend(clip)
    this.frames.set(plot, {rect, id: clip.id})
    return clip.id
  }

  /** @param {Drawn} shown */
  update({view: {left_out: names, signals, scalars}, state}) {
    const absent = names.filter(name => !(name in signals || name in scalars))
    this.cover(absent, coveredPlots(state))
    this.grips?.update()
  }

  /** Hides shapes that would reveal hidden quantities. @param {string[]} leftOut @param {string[]} covered plots */
  cover(leftOut, covered) {
    for (const shape of this.shapes) shape.covered = tells(shape, leftOut, covered)
  }

  /** Called in each animation frame: draws all shapes for the quantities `named`. @param {Named} named */
  frame(named) {
    if (!this.isSeen || this.host.closest("[hidden]")) return
    // Inherit `named`, because copying it for each of many stages would take a seventh of a frame's time.
    const all = Object.assign(Object.create(named), this.nowhere, this.plots, this.size, this.join)
    this.named = all
    for (const shape of this.shapes) {
      const {spec, kind, parts, group, needs, places, plots, covered} = shape
      const away = covered || (this.apart && plots.size > 1)
      // Shapes over a plot are hidden with it; shapes that only continue it on a wide screen are not.
      const stands = (!all.wide && needs.has("wide")) || places.every(name => name in this.plots)
      const shown = !away && stands && spec.show.every(name => all[name])
      group.style.display = shown ? "" : "none"
      const now = shown ? atInstant(shape, all) : null
      if (now) kind.move(parts, now, all)
      this.grips?.place(spec, now && kind.hold?.(now), all)
    }
    this.collisions.place()
  }
}
