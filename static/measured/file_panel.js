// The panel for a measurement: its file, the chosen columns, and the numbers of the fit.

import {chip, element, marked, reword} from "../core/dom.js"
import {VALUES, TIMES, unitIn} from "./record.js"
import {canRecord, Recorder} from "./recorder.js"

const HINT =
  "Or drop it here, or paste columns from a spreadsheet. A CSV file, also in a zip file, has a column of times and "
const KINDS = "of displacements, velocities or accelerations."

const RECORD = "Record with this phone"

/** @typedef {import("./record.js").Column} Column */

export class FilePanel {
  /** @type {Recorder | null} */
  recording = null

  /**
   * @param {HTMLElement} host of the file @param {HTMLElement} fitHost of the numbers
   * @param {Record<string, string>} examples names of files by their labels
   * @param {import("./measured.js").MeasuredView} measured
   */
  constructor(host, fitHost, examples, measured) {
    this.host = host
    this.measured = measured
    this.empty = this.#offer(examples)
    this.name = element("p", {class: "measured-name"})
    this.columns = element("div", {class: "measured-columns"})
    this.numbers = element("table", {class: "facts-table"})
    this.sentence = element("p", {class: "measured-sentence"})
    this.more = element("p", {class: "measured-more"})
    this.fit = chip("Fit to data", () => measured.take())
    this.csv = chip("Save residuals", () => measured.save())
    this.cancel = chip("Cancel", () => measured.cancel())
    this.again = chip("Fit again", () => measured.choose({}))
    const remove = chip("Remove", () => measured.remove())
    const buttons = element("p", {class: "measured-buttons"}, this.cancel, this.again, this.fit, this.csv, remove)
    this.file = element("div", {}, this.name, this.columns, buttons)
    this.status = element("p", {class: "measured-status", role: "status"})
    this.heard = element("p", {class: "heard", role: "status"})
    host.append(this.empty, this.status, this.file, this.heard)
    fitHost.append(this.sentence, this.more, this.numbers)
  }

  /** The ways to get a file. @param {Record<string, string>} examples */
  #offer(examples) {
    const {measured} = this
    const types = ".csv,.tsv,.txt,.zip,text/csv,text/plain,application/zip"
    const input = element("input", {type: "file", accept: types, hidden: ""})
    input.addEventListener("change", () => {
      const [file] = input.files ?? []
      if (file) measured.open(file)
      input.value = ""
    })
    const choose = chip("Choose a file", () => input.click())
    const ready = Object.entries(examples).map(([label, name]) => chip(label, () => this.#example(name)))
    const isOne = measured.labels.length === 1
    const record = isOne && canRecord() ? [this.#recorder()] : []
    const hint = element("p", {class: "mute"}, `${HINT}${isOne ? "one" : "one for each mass,"} ${KINDS}`)
    return element("div", {class: "measured-empty"}, input, choose, ...record, ...ready, hint)
  }

  /** The button that starts and stops a recording with this phone. */
  #recorder() {
    const record = chip(RECORD, () => {
      if (this.recording) return this.#leaveRecording(record)
      this.recording = new Recorder({
        waits: left => {
          reword(record, `Cancel: it starts in ${left} s`)
          reword(this.status, "Fix the phone to the spring, and let it swing.")
        },
        records: left => {
          reword(record, `Stop: ${left} s left`)
          reword(this.status, "It records: do not touch the phone.")
        },
        done: table => {
          this.#endRecording(record)
          this.measured.begin("Recorded by this phone", table)
        },
        refused: reason => {
          this.#endRecording(record)
          this.show(reason)
        },
      })
    })
    return record
  }

  /** @param {HTMLElement} record */
  #leaveRecording(record) {
    const {recording} = this
    if (recording?.isRunning) return recording.stop()
    this.#endRecording(record)
    this.show("")
  }

  /** @param {HTMLElement} record */
  #endRecording(record) {
    this.recording?.leave()
    this.recording = null
    reword(record, RECORD)
  }

  /** Ends a running recording when the scene is left. */
  leave() {
    this.recording?.leave()
  }

  /** @param {string} name */
  async #example(name) {
    const answer = await fetch(new URL(name, import.meta.url)).catch(() => null)
    if (answer?.ok) this.measured.read(name, await answer.text())
    else this.show("The example could not be loaded. Try again in a moment.")
  }

  /** Shows the file and its fit, and a sentence; the focus stays in the panel. @param {string} sentence */
  show(sentence) {
    const before = this.host.contains(document.activeElement) ? document.activeElement : null
    this.#write(sentence)
    if (!before || before.checkVisibility()) return
    const label = before.getAttribute("aria-label")
    const controls = [.../** @type {NodeListOf<HTMLElement>} */ (this.host.querySelectorAll("button, select"))]
    const seen = controls.filter(one => one.checkVisibility())
    const same = seen.find(one => label && one.getAttribute("aria-label") === label)
    ;(same ?? seen[0]).focus()
  }

  /** @param {string} sentence */
  #write(sentence) {
    const {opened} = this.measured
    reword(this.status, sentence)
    this.empty.hidden = Boolean(opened)
    this.file.hidden = !opened
    this.#number(opened?.fit)
    if (!opened) return
    const {name, choice, rows} = opened
    const count = rows
      ? `${rows.t.length} points${rows.left ? `, ${rows.left} rows without a number left out` : ""}`
      : ""
    this.name.replaceChildren(element("b", {}, name), count ? `: ${count}` : "")
    const {time, motions} = choice
    this.columns.replaceChildren(
      ...this.#tables(),
      ...this.#choice("Time", time, TIMES, column => ({time: column})),
      ...this.measured.labels.flatMap((label, i) =>
        this.#choice(label, motions[i], VALUES, column => ({motions: motions.with(i, column)})),
      ),
    )
  }

  /** A choice between the tables of a zip file. */
  #tables() {
    const {tables, place} = this.measured.opened ?? {tables: [], place: 0}
    if (tables.length < 2) return []
    const choice = select(
      "Table",
      tables.map(({name}, i) => [String(i), name]),
      String(place),
    )
    choice.addEventListener("change", () => this.measured.turnTo(Number(choice.value)))
    return [element("span", {}, "Table"), choice, element("span", {})]
  }

  /** @param {page.Fitted | null} [fit] */
  #number(fit) {
    this.csv.disabled = !fit
    this.fit.disabled = !fit?.parameters
    this.cancel.hidden = !this.measured.isFitting
    this.again.hidden = this.measured.isFitting || Boolean(fit) || !this.measured.opened?.rows
    const {numbers, sentences} = fit ?? {numbers: [], sentences: []}
    this.numbers.replaceChildren(...numbers.map(line))
    reword(this.sentence, sentences[0] ?? "")
    reword(this.more, sentences.slice(1).join(" "))
    reword(this.heard, fit ? `Fitted: ${numbers.map(spoken).join(", ")}. ${sentences.join(" ")}` : "")
  }

  /**
   * A column and its unit.
   * @param {string} label @param {Column} chosen @param {Record<string, number>} units that are possible
   * @param {(column: Column) => Partial<import("./record.js").ColumnChoice>} to
   */
  #choice(label, {place, unit}, units, to) {
    const names = this.measured.opened?.table.names ?? []
    const column = select(
      `${label}: column`,
      names.map((name, i) => [String(i), name]),
      String(place),
    )
    column.addEventListener("change", () => {
      const other = Number(column.value)
      this.measured.choose(to({place: other, unit: unitIn(names[other], units) || unit}))
    })
    const asked = /** @type {[string, string][]} */ (unit ? [] : [["", "unit?"]])
    const size = select(
      `${label}: unit`,
      [...asked, ...Object.keys(units).map(one => /** @type {[string, string]} */ ([one, one]))],
      unit,
    )
    size.addEventListener("change", () => this.measured.choose(to({place, unit: size.value})))
    return [element("span", {}, label), column, size]
  }
}

/** @param {string} label @param {[string, string][]} options value and text @param {string} chosen */
function select(label, options, chosen) {
  const made = element(
    "select",
    {"aria-label": label},
    ...options.map(([value, text]) => element("option", {value}, text)),
  )
  made.value = chosen
  return made
}

/** @param {page.FittedNumber} number */
function line({symbol, name, value, error, unit}) {
  const title = marked("th", {scope: "row", "aria-label": name}, symbol)
  const errors = element("td", {}, error && `± ${error}`)
  return element("tr", {}, title, element("td", {class: "number"}, value), errors, element("td", {class: "unit"}, unit))
}

/** @param {page.FittedNumber} number */
const spoken = ({name, value, error, unit}) => `${name} ${value}${error && ` plus or minus ${error}`} ${unit}`.trim()
