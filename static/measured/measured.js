// The view of a visitor's own measurement: a file, its points over the model, the fit and the residuals. The rows stay
// in this page; the server gets them only to fit a motion, and keeps nothing.

import {Points, Residuals, residualsOf, shownOf} from "./drawn.js"
import {FilePanel} from "./file_panel.js"
import {parser} from "./parser.js"
import {guessed, piecesOf, rowsOf} from "./record.js"
import {MOST_BYTES, tableOf, tablesOf, textOf} from "./table.js"
import {isZip, unpacked} from "./zip.js"
import {save} from "../export/save.js"
import {inWords} from "../core/notes.js"

const AGAIN = 2000 // ms until a fit is requested again if the server was busy
const MOST_TRIES = 15
const FITTING = "Computing the fit. It may have to wait for those of other visitors."
const HEADS = ["point - offset [m]", "curve [m]", "residual [m]"]
const BUSY = "The fit could not be computed now. Press “Fit again” in a moment."
const CANCELLED = "The fit is cancelled. “Fit again” computes it."

/**
 * A file: its tables, the index of the chosen table, this table, the chosen columns, and the rows and the fit, or null.
 * @typedef {{name: string, tables: import("./table.js").NamedTable[], place: number,
 *   table: import("./table.js").Table, choice: import("./record.js").ColumnChoice,
 *   rows: import("./record.js").Rows | null, fit: page.Fitted | null}} Opened
 */

/** @type {Opened | null} the file of this tab; it stays open when the scene or the connection changes */
let opened = null

/**
 * A column of the record: its name, the plot with its points, and its residuals.
 * @typedef {{label: string, plot: PlotHost, points: Points, lane: Residuals}} Track
 */

/** @implements {Part} */
export class MeasuredView {
  /** @type {import("./drawn.js").DrawnPoints[] | null} by column */
  shown = null

  isFitting = false

  /** @param {PartHost} page @param {Map<page.MeasuredBlock, HTMLElement>} hosts of the blocks by block */
  constructor(page, hosts) {
    this.page = page
    const blocks = [...hosts]
    const hostOf = (/** @type {string} */ shows) => blocks.find(([block]) => block.shows === shows) ?? blocks[0]
    const lanes = blocks.filter(([{shows}]) => shows === "residuals")
    /** @type {Track[]} */
    this.tracks = lanes.map(([{plot: name, column: label}, host]) => {
      const plot = /** @type {PlotHost} */ (page.plots.find(({block}) => block.name === name))
      const head = `${lanes.length > 1 ? `${label}, residuals` : "Residuals"}: points minus curve`
      return {label, plot, points: new Points(plot), lane: new Residuals(host, plot, head)}
    })
    const [{examples}, host] = hostOf("file")
    this.panel = new FilePanel(host, hostOf("fit")[1], examples, this)
    this.#listen()
    this.update()
    if (opened && opened.choice.motions.length !== this.tracks.length) this.turnTo(opened.place)
    else if (opened && !opened.fit) this.choose({})
    else this.#tell("")
  }

  get opened() {
    return opened
  }

  /** The names of the columns. */
  get labels() {
    return this.tracks.map(({label}) => label)
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
      event.stopPropagation() // the menu opens files of walks
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
    this.tracks.forEach(({lane}) => lane.leave())
    this.#endFit()
    this.panel.leave()
  }

  /** @param {File} file */
  async open(file) {
    if (file.size > MOST_BYTES) {
      const size = (file.size / 2 ** 20).toFixed(1)
      return this.#tell(`${file.name} has ${size} MB: files of at most 5 MB are read.`)
    }
    const bytes = new Uint8Array(await file.arrayBuffer())
    if (!isZip(bytes)) return this.read(file.name, textOf(bytes))
    try {
      const files = await unpacked(bytes)
      this.#start(file.name, tablesOf(files, await parser()))
    } catch (reason) {
      this.#tell(`${file.name}: ${inWords(reason)}`)
    }
  }

  /** @param {string} name @param {string} text */
  async read(name, text) {
    try {
      this.begin(name, tableOf(text, await parser()))
    } catch (reason) {
      this.#tell(`${name}: ${inWords(reason)}`)
    }
  }

  /** Shows a table that is no file. @param {string} name @param {import("./table.js").Table} table */
  begin(name, table) {
    this.#start(name, [{name, table}])
  }

  /** Shows another table of the file. @param {number} place */
  turnTo(place) {
    if (opened) this.#start(opened.name, opened.tables, place)
  }

  /** @param {string} name @param {import("./table.js").NamedTable[]} tables @param {number} [place] */
  #start(name, tables, place = longest(tables)) {
    const {table} = tables[place]
    opened = {name, tables, place, table, choice: guessed(table, this.tracks.length), rows: null, fit: null}
    this.choose({})
  }

  /** Chooses columns or units, and fits again. @param {Partial<import("./record.js").ColumnChoice>} change */
  choose(change) {
    if (!opened) return
    this.#endFit()
    /** @type {Opened} */
    const file = {...opened, choice: {...opened.choice, ...change}, rows: null, fit: null}
    opened = file
    const {time, motions} = file.choice
    const unknown = [time, ...motions].findIndex(({unit}) => !unit)
    if (unknown >= 0) return this.#tell(`Choose the unit of “${["Time", ...this.labels][unknown]}”.`)
    try {
      file.rows = rowsOf(file.table, file.choice)
      this.isFitting = true
      this.#tell(FITTING)
      this.#send(file, piecesOf(file.rows))
    } catch (reason) {
      this.#tell(`${file.name}: ${inWords(reason)}`)
    }
  }

  /**
   * Sends a piece of the rows and then what the server needs next, until it has fitted a motion. If the session is new
   * or the server is busy, all pieces are sent again.
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
    this.isFitting = false
    file.fit = answer.motion ? answer : null
    this.#tell(answer.refused)
  }

  /** Cancels the fit that is being computed, and keeps the points. */
  cancel() {
    this.#endFit()
    this.#tell(CANCELLED)
  }

  /** Ends the wait for a fit; the server drops it. */
  #endFit() {
    const {messages} = this.page.host
    if (!this.isFitting || !opened) return
    this.isFitting = false
    opened = {...opened} // answers to the old object are then ignored
    messages.abandon?.("rows")
    messages.send({type: "cancel_fit"})
  }

  /** Sets the parameters of the scene to the fit. */
  take() {
    const {fit, rows} = opened ?? {}
    if (!fit?.parameters || !rows) return
    const {mass, values, per_mass: perMass} = fit.parameters
    const m = Number(this.page.shown.settings[mass].value)
    const sized = Object.fromEntries(Object.entries(perMass).map(([name, value]) => [name, m * value]))
    this.page.host.take({...values, ...sized, window: rows.t[rows.t.length - 1]})
  }

  remove() {
    this.#endFit()
    opened = null
    this.#tell("")
  }

  /** Saves the points with the curves and the residuals. */
  save() {
    const {shown} = this
    if (!opened || !shown) return
    const isOne = shown.length === 1
    const heads = this.labels.flatMap(label => HEADS.map(head => (isOne ? head : `${label}: ${head}`)))
    const columns = this.tracks.map(({plot}, i) => savedColumn(plot, shown[i]))
    const lines = [...shown[0].t].map((t, i) => [t, ...columns.map(cells => cells[i])].join(","))
    save("residuals.csv", `${["t [s]", ...heads].join(",")}\r\n${lines.join("\r\n")}\r\n`, "text/csv")
  }

  /** Shows a sentence and updates everything else. @param {string} sentence */
  #tell(sentence) {
    this.panel.show(sentence)
    this.shown = shownOf(opened)
    this.tracks.forEach(({points}, i) => points.show(this.shown?.[i] ?? null))
    this.#draw()
  }

  #draw() {
    this.tracks.forEach(({plot, lane}, i) => {
      const shown = this.shown?.[i] ?? null
      if (!plot.absent) lane.show(shown, shown ? residualsOf(plot, shown) : new Float64Array())
    })
  }

  update() {
    for (const {points} of this.tracks) points.path.style.display = this.isSeen ? "" : "none"
    if (this.isSeen) this.#draw()
  }
}

/** The index of the table with the most rows. @param {import("./table.js").NamedTable[]} tables */
function longest(tables) {
  const counts = tables.map(({table}) => table.lines.length)
  return counts.indexOf(Math.max(...counts))
}

/** The cells of each row of a column. @param {PlotHost} plot @param {import("./drawn.js").DrawnPoints} shown */
function savedColumn(plot, shown) {
  const place = residualsOf(plot, shown)
  const {exponent, factor} = plot.y
  return [...shown.x].map((x, i) => {
    const residual = place[i] * 10 ** exponent * factor
    const rest = Number.isNaN(residual) ? "," : `${(x - residual).toPrecision(9)},${residual.toPrecision(4)}`
    return `${x.toPrecision(9)},${rest}`
  })
}
