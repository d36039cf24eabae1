// The view of a visitor's own measurement: a file, its points over the model, the fit and the residuals. The rows stay
// in this page; the server gets them only to fit a motion, and keeps nothing.

import {Points, Residuals, residualsOf} from "./drawn.js"
import {FilePanel} from "./file_panel.js"
import {parser} from "./parser.js"
import {guessed, piecesOf, rowsOf} from "./record.js"
import {MOST_BYTES, tableOf} from "./table.js"
import {save} from "../export/save.js"
import {inWords} from "../core/notes.js"

const AGAIN = 2000 // ms until a fit is requested again for which the server had no time
const MOST_TRIES = 5
const FITTING = "Computing the fit. It may have to wait for those of other visitors."
const BUSY = "The fit could not be computed now. Remove the file, and open it again in a moment."

/**
 * A file: its table, the chosen columns, and the rows and the fit if there are any.
 * @typedef {{name: string, table: import("./table.js").Table, choice: import("./record.js").ColumnChoice,
 *   rows: import("./record.js").Rows | null, fit: page.Fitted | null}} Opened
 */

/** @type {Opened | null} the file of this tab, which other scenes and connections keep */
let opened = null

/** @implements {Part} */
export class MeasuredView {
  /** @type {import("./drawn.js").DrawnPoints | null} */
  shown = null

  /** @param {PartHost} page @param {Map<page.MeasuredBlock, HTMLElement>} hosts of the blocks by block */
  constructor(page, hosts) {
    this.page = page
    const [[{plot: name}]] = hosts
    this.plot = /** @type {PlotHost} */ (page.plots.find(({block}) => block.name === name))
    this.points = new Points(this.plot)
    const host = Object.fromEntries([...hosts].map(([{shows}, element]) => [shows, element]))
    this.lane = new Residuals(host.residuals, this.plot)
    this.panel = new FilePanel(host.file, host.fit, this)
    this.#listen()
    this.update()
    this.#tell("")
  }

  get opened() {
    return opened
  }

  /** True while the view is shown. */
  get isSeen() {
    return this.panel.host.checkVisibility()
  }

  #listen() {
    const {paper} = this.page
    paper.addEventListener("drop", event => {
      const file = event.dataTransfer?.files[0]
      if (!file || !this.isSeen || file.name.endsWith(".toml")) return
      event.preventDefault()
      event.stopPropagation() // a walk's file goes to the menu
      this.open(file)
    })
    this.pasted = (/** @type {ClipboardEvent} */ event) => {
      const text = event.clipboardData?.getData("text/plain")
      const isField = event.target instanceof Element && event.target.closest("input, textarea")
      if (text?.includes("\n") && this.isSeen && !isField) this.read("Pasted rows", text)
    }
    document.addEventListener("paste", this.pasted)
  }

  leave() {
    if (this.pasted) document.removeEventListener("paste", this.pasted)
    this.lane.leave()
  }

  /** @param {File} file */
  async open(file) {
    if (file.size > MOST_BYTES) {
      const size = (file.size / 2 ** 20).toFixed(1)
      return this.#tell(`${file.name} has ${size} MB: files of at most 5 MB are read.`)
    }
    await this.read(file.name, await file.text())
  }

  /** @param {string} name @param {string} text */
  async read(name, text) {
    try {
      const table = tableOf(text, await parser())
      opened = {name, table, choice: guessed(table), rows: null, fit: null}
      this.choose({})
    } catch (reason) {
      this.#tell(`${name}: ${inWords(reason)}`)
    }
  }

  /** Chooses columns or units, and fits again. @param {Partial<import("./record.js").ColumnChoice>} change */
  choose(change) {
    if (!opened) return
    /** @type {Opened} */
    const file = {...opened, choice: {...opened.choice, ...change}, rows: null, fit: null}
    opened = file
    const {timeUnit, valueUnit} = file.choice
    if (!timeUnit || !valueUnit) return this.#tell(`Choose the unit of the ${timeUnit ? "motion" : "time"}.`)
    try {
      file.rows = rowsOf(file.table, file.choice)
      this.#tell(FITTING)
      this.#send(file, piecesOf(file.rows))
    } catch (reason) {
      this.#tell(`${file.name}: ${inWords(reason)}`)
    }
  }

  /**
   * Sends a piece of the rows and then what the server needs next, until it has fitted a motion. A new session, or a
   * server without time, begins again.
   * @param {Opened} file @param {page.SendRows[]} pieces @param {number} [piece] @param {number} [tries]
   * @returns {Promise<void>}
   */
  async #send(file, pieces, piece = 0, tries = 0) {
    if (opened !== file) return
    const answer = /** @type {page.Fitted} */ (await this.page.host.messages.request?.(pieces[piece]))
    const isLate = answer.is_busy || answer.piece <= piece
    if (answer.motion || (answer.refused && !answer.is_busy)) return this.#fitted(file, answer)
    if (isLate && tries === MOST_TRIES) return this.#fitted(file, {...answer, refused: answer.refused || BUSY})
    if (answer.is_busy) await new Promise(done => setTimeout(done, AGAIN))
    await this.#send(file, pieces, answer.is_busy ? 0 : answer.piece, tries + Number(isLate))
  }

  /** @param {Opened} file @param {page.Fitted} answer */
  #fitted(file, answer) {
    if (opened !== file) return
    file.fit = answer.motion ? answer : null
    this.#tell(answer.refused)
  }

  /** Sets the parameters of the scene to the fit. */
  take() {
    const {fit, rows} = opened ?? {}
    if (!fit?.motion || !rows) return
    const {omega, C, S, decay} = fit.motion
    const a = Math.max(decay, 0) // a dashpot only takes energy
    const m = Number(this.page.shown.settings.m.value)
    const [k, c] = [m * (omega ** 2 + a ** 2), 2 * m * a]
    this.page.host.take({k, c, keep: "c", x_0: C, v_0: omega * S - decay * C, window: rows.t[rows.t.length - 1]})
  }

  remove() {
    opened = null
    this.#tell("")
  }

  /** Saves the points with the curve and the residuals. */
  save() {
    const {shown} = this
    if (!opened || !shown) return
    const place = residualsOf(this.plot, shown)
    const {exponent, factor} = this.plot.y
    const lines = [...shown.t].map((t, i) => {
      const residual = place[i] * 10 ** exponent * factor
      const rest = Number.isNaN(residual) ? "," : `${(shown.x[i] - residual).toPrecision(9)},${residual.toPrecision(4)}`
      return `${t},${shown.x[i].toPrecision(9)},${rest}`
    })
    const head = "t [s],point - offset [m],curve [m],residual [m]"
    save("residuals.csv", `${[head, ...lines].join("\r\n")}\r\n`, "text/csv")
  }

  /** Shows a sentence and updates everything else. @param {string} sentence */
  #tell(sentence) {
    this.panel.show(sentence)
    this.shown = shownOf(opened)
    this.points.show(this.shown)
    this.#draw()
  }

  #draw() {
    if (this.plot.absent) return
    this.lane.show(this.shown, this.shown ? residualsOf(this.plot, this.shown) : new Float64Array())
  }

  update() {
    this.points.path.style.display = this.isSeen ? "" : "none"
    if (this.isSeen) this.#draw()
  }
}

/**
 * The points as they are drawn: displacements without the fitted offset and drift. A velocity or an acceleration is
 * drawn at the fitted displacement, with its residual over the same power of the natural frequency.
 * @param {Opened | null} file
 */
function shownOf(file) {
  if (!file?.rows || (file.rows.derivative && !file.fit)) return null
  const {t, x, derivative} = file.rows
  const {offset = 0, drift = 0, scatter = 0, omega = 1, decay = 0, C = 0, S = 0} = file.fit?.motion ?? {}
  const scale = Math.hypot(omega, decay) ** derivative
  const turn = derivative * Math.atan2(omega, -decay)
  const [size, phase] = [Math.hypot(C, S), Math.atan2(-S, C)]
  const points = x.map((one, i) => {
    const motion = (/** @type {number} */ more) =>
      size * Math.exp(-decay * t[i]) * Math.cos(omega * t[i] + phase + more)
    return motion(0) + (one - offset - drift * t[i]) / scale - motion(turn)
  })
  return {t, x: points, scatter: scatter / scale}
}
