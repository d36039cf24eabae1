// A Bokeh figure: puts it into the page, fills it with the columns of a message, and gives curves the colours of their
// quantities.

import {colour, element, unitSize, units} from "../core/dom.js"

/** The style token with the width of a line. @type {Partial<Record<page.Curve["width"], string>>} */
const LINES = {sum: "w2", line: "w1", dash: "w1", dots: "w0", thin: "w0"}
const LENGTHS = ["line_dash", "size"]

const LEAST = 0.25 // of the width is the frame at least
const NUMBERS = 30 // units under a frame with numbers: components/layout/plots.py

const LACK = "The program that draws the curves could not be loaded. Trying again."

export class Figure {
  /** @type {HTMLElement | undefined} */
  lack

  /** @param {page.PlotBlock} block */
  constructor(block) {
    this.block = block
    this.numbered = block.x_labels
    this.says = element("p", {class: "heard", id: `says-${block.name}`})
    this.element = element("div", {
      class: "figure",
      role: "img",
      "aria-label": block.title,
      "aria-describedby": this.says.id,
    })
  }

  /** Creates the models without a view. Properties that are set now are drawn only once, when the figure is mounted. */
  make() {
    const {Document} = Bokeh.require("document")
    this.document = Document.from_json(this.block.figure)
    this.model = this.document.roots()[0]
    const names = new Set([...this.block.curves, ...this.block.regions].map(part => part.source))
    this.sources = [...names].map(name => ({name, source: this.document.get_model_by_name(name)}))
    /**
     * @type {{model: BokehModel, lengths: Record<string, number | number[]>}[]} lengths of the models at one pixel per
     * unit
     */
    this.drawn = [...this.model.renderers.map((/** @type {BokehModel} */ {glyph}) => glyph), ...this.model.center].map(
      model => ({
        model,
        lengths: Object.fromEntries(LENGTHS.filter(name => name in model).map(name => [name, bare(model[name])])),
      }),
    )
    this.theme()
    this.fit()
  }

  /** Shows a message in place of the figure, because BokehJS could not be fetched. */
  lacks() {
    this.lack ??= element("p", {class: "lack"}, LACK)
    this.element.after(this.lack)
  }

  /** Call this while the element is in the document. */
  async mount() {
    this.lack?.remove()
    this.manager = await Bokeh.embed.add_document_standalone(this.document, this.element)
    const [view] = this.manager
    view.canvas_view.events_el.removeAttribute("tabindex") // keys do nothing on a figure, so Tab skips it
    if (this.left) this.leave()
  }

  /** The margins of the frame, in whole pixels. The right one, for names, leaves the frame its least width. */
  get room() {
    const {left, right, top} = this.block.room
    const bottom = this.numbered ? Math.max(NUMBERS, this.block.room.bottom) : this.block.room.bottom
    const [l, r, t, b] = [left, right, top, bottom].map(size => Math.round(size * unitSize()))
    const most = Math.max(0, Math.floor((1 - LEAST) * this.element.clientWidth) - l)
    return {left: l, right: Math.min(r, most), top: t, bottom: b}
  }

  /** Fits the width to the text. */
  fit() {
    if (!this.model) return
    this.model.below[0].visible = this.numbered
    const {left, right, top, bottom} = this.room
    this.model.setv({min_border_left: left, min_border_right: right, min_border_top: top, min_border_bottom: bottom})
    for (const {model, lengths} of this.drawn ?? []) {
      model.setv(Object.fromEntries(Object.entries(lengths).map(([name, length]) => [name, grown(length)])))
    }
    for (const renderer of this.model.renderers) this.#widen(renderer)
    for (const model of this.model.center) {
      if (model.type === "Span") model.setv({line_width: grown(units("w0"))})
      if (model.type === "Grid") model.setv({grid_line_width: grown(units("w0"))})
    }
    const label = {
      major_label_text_font_size: `${units("t0") * unitSize()}px`,
      major_label_standoff: Math.round(5 * unitSize()),
    }
    for (const axis of [...this.model.below, ...this.model.left]) axis.setv(label)
  }

  /** @param {BokehModel} renderer */
  #widen(renderer) {
    const drawn = this.#drawn(renderer)
    const token = renderer.glyph.type === "Scatter" ? "w1" : "width" in drawn && LINES[drawn.width]
    if (token) renderer.glyph.setv({line_width: grown(units(token))})
  }

  // Bokeh keeps all documents in a list, so that they would stay in memory.
  leave() {
    this.left = true
    if (!this.manager) return
    const {documents} = Bokeh
    const index = documents.indexOf(this.document)
    this.manager.clear()
    if (index >= 0) documents.splice(index, 1)
  }

  /**
   * Draws the curves that have columns and are switched on.
   * @param {Columns} columns @param {Set<string>} hidden
   */
  fill(columns, hidden) {
    for (const {name, source} of this.sources ?? []) fill(source, columns[name] ?? {})
    for (const renderer of this.model.renderers) {
      const given = columns[renderer.data_source.name] ?? {}
      const {glyph} = renderer
      const needed = [glyph.x, glyph.y, glyph.y1, glyph.y2].filter(Boolean).map(value => value.field)
      const group = this.#drawn(renderer).group
      renderer.visible = !hidden.has(group) && needed.every(column => given[column]?.length)
    }
  }

  /** @param {Span} x @param {Span} y */
  setRanges(x, y) {
    this.model.x_range.setv({start: x.start, end: x.end})
    this.model.y_range.setv({start: y.start, end: y.end})
  }

  /** @param {number[]} x @param {number[]} y */
  setTicks(x, y) {
    this.model.below[0].ticker.ticks = x
    this.model.left[0].ticker.ticks = y
  }

  /** The texts under the horizontal axis. @param {Map<number, string>} labels */
  setLabels(labels) {
    this.model.below[0].major_label_overrides = labels
  }

  theme() {
    if (!this.model) return
    for (const renderer of this.model.renderers) this.#paint(renderer)
    for (const model of this.model.center) {
      if (model.type === "Span") model.setv({line_color: colour("rule")})
      if (model.type === "Grid") model.setv({grid_line_color: colour("grid")})
    }
    const label = {
      major_label_text_color: colour("mute"),
      major_label_text_font: colour("sans"),
    }
    for (const axis of [...this.model.below, ...this.model.left]) axis.setv(label)
  }

  /** @param {BokehModel} renderer */
  #paint(renderer) {
    const {glyph} = renderer
    const drawn = this.#drawn(renderer)
    const ink = colour(drawn.tint)
    if ("line_color" in glyph && glyph.type !== "VArea") glyph.setv({line_color: ink})
    if ("fill_color" in glyph) {
      const isRing = "marker" in drawn && drawn.marker === "ring"
      glyph.setv({fill_color: isRing ? colour("paper") : ink})
    }
  }

  /**
   * The curve or region of the block that a renderer draws. Its name is its place in the block, such as "curves.0".
   * @param {BokehModel} renderer
   */
  #drawn(renderer) {
    const [list, index] = renderer.name.split(".")
    return list === "curves" ? this.block.curves[Number(index)] : this.block.regions[Number(index)]
  }
}

/**
 * Fills columns that the picture lacks, because Bokeh needs columns of equal length. Their renderers are hidden.
 * @param {BokehModel} source @param {Record<string, Float64Array>} given
 */
function fill(source, given) {
  const nothing = new Float64Array(Object.values(given)[0]?.length ?? 0)
  source.data = Object.fromEntries(Object.keys(source.data).map(key => [key, given[key] ?? nothing]))
}

/** The value of a length property, without Bokeh's wrapper. @param {BokehModel} length */
const bare = length => (length?.value !== undefined ? length.value : length)

/** @param {number | number[]} length */
const grown = length => (Array.isArray(length) ? length.map(one => one * unitSize()) : length * unitSize())
