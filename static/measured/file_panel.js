// The file of a measurement, its columns, and the numbers of its fit.

import {chip, element, marked, reword} from "../core/dom.js"
import {VALUES, TIMES, unitIn} from "./record.js"

const HINT = "Or drop it here, or paste columns from a spreadsheet. A CSV file has a column of times and "
const KINDS = "of displacements, velocities or accelerations."

/** @typedef {import("./record.js").Column} Column */

export class FilePanel {
  /**
   * @param {HTMLElement} host of the file @param {HTMLElement} fitHost of the numbers
   * @param {Record<string, string>} examples names of files by their labels
   * @param {import("./measured.js").MeasuredView} measured
   */
  constructor(host, fitHost, examples, measured) {
    this.host = host
    this.measured = measured
    this.input = element("input", {type: "file", accept: ".csv,.tsv,.txt,text/csv,text/plain", hidden: ""})
    this.input.addEventListener("change", () => {
      const [file] = this.input.files ?? []
      if (file) measured.open(file)
      this.input.value = ""
    })
    const choose = () => this.input.click()
    const ready = Object.entries(examples).map(([label, name]) => chip(label, () => this.#example(name)))
    const columns = measured.labels.length > 1 ? "one for each mass," : "one"
    this.empty = element(
      "div",
      {class: "measured-empty"},
      chip("Choose a file", choose),
      ...ready,
      element("p", {class: "mute"}, `${HINT}${columns} ${KINDS}`),
    )
    this.name = element("p", {class: "measured-name"})
    this.columns = element("div", {class: "measured-columns"})
    this.numbers = element("table", {class: "facts-table"})
    this.sentence = element("p", {class: "measured-sentence"})
    this.more = element("p", {class: "measured-more"})
    this.fit = chip("Fit to data", () => measured.take())
    this.csv = chip("Save residuals", () => measured.save())
    const buttons = element(
      "p",
      {class: "measured-buttons"},
      this.fit,
      this.csv,
      chip("Remove", () => measured.remove()),
    )
    this.file = element("div", {}, this.name, this.columns, buttons)
    this.status = element("p", {class: "measured-status", role: "status"})
    this.heard = element("p", {class: "heard", role: "status"})
    host.append(this.input, this.empty, this.status, this.file, this.heard)
    fitHost.append(this.sentence, this.more, this.numbers)
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
      ...this.#choice("Time", time, TIMES, column => ({time: column})),
      ...this.measured.labels.flatMap((label, i) =>
        this.#choice(label, motions[i], VALUES, column => ({motions: motions.with(i, column)})),
      ),
    )
  }

  /** @param {page.Fitted | null} [fit] */
  #number(fit) {
    this.csv.disabled = !fit
    this.fit.disabled = !fit?.parameters
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
