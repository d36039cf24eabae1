// Buttons with the shapes of a chain's modes: green if the mode takes part in the motion. If many do, only the
// strongest are green.
// Each button starts only its mode.

import {element, svg} from "../core/dom.js"
import {shapesOf} from "../core/modal.js"
import {three} from "../core/numbers.js"

const MOST = 8
const HALL = 4
const TAKES_PART = 0.002 // least share of the energy of a mode that takes part
const DOTTED = 12 // with more masses, a shape has no dots
const [WIDE, HIGH, NUMBER] = [66, 40, 12] // NUMBER: the width of the number, left of the shape

export class ModeButtons {
  /** @type {page.Modal | null} */
  drawn = null

  /** @param {HTMLElement} host @param {page.ModesBlock} block @param {PartHost} page */
  constructor(host, block, page) {
    this.block = block
    this.page = page
    this.says = element("p", {class: "mode-share"})
    this.row = element("div", {class: "mode-row", role: "group", "aria-label": block.label})
    host.append(this.row, this.says)
  }

  /** @param {Drawn["settings"]} _ @param {Drawn["view"]} view */
  update(_, view) {
    const signal = view.signals[this.block.of]
    if (signal?.kind !== "modal" || this.drawn === signal) return
    this.drawn = signal
    const shares = energies(signal)
    const strongest = [...shares.keys()].toSorted((i, j) => shares[j] - shares[i] || i - j).slice(0, MOST)
    const part = three(100 * strongest.reduce((sum, j) => sum + shares[j], 0))
    this.says.textContent = MOST < shares.length ? `${MOST} of ${shares.length} modes, ${part} % of the energy` : ""
    const focused = this.row.contains(document.activeElement) ? document.activeElement?.textContent : null
    const alone = Number(view.values[this.block.chosen]) - 1
    const made = strongest
      .toSorted((i, j) => i - j)
      .map(j => this.#button(signal, j, shares[j], j === alone, strongest.indexOf(j) >= HALL))
    this.row.replaceChildren(...made)
    const pressed = made.find(one => one.ariaPressed === "true")
    if (pressed) this.row.scrollLeft = pressed.offsetLeft - WIDE
    made.find(one => one.textContent === focused)?.focus({preventScroll: true})
  }

  /**
   * @param {page.Modal} signal @param {number} j @param {number} share of the energy @param {boolean} isAlone
   * @param {boolean} isLess not among the strongest few
   */
  #button(signal, j, share, isAlone, isLess) {
    const count = signal.omega.length
    const shape = shapesOf(signal).subarray(j * count, (j + 1) * count)
    const scale = HIGH / (2.3 * Math.max(...shape.map(Math.abs)))
    const step = (WIDE - NUMBER) / (count + 1)
    const points = Array.from(shape, (x, p) => [NUMBER + (p + 1) * step, HIGH / 2 - x * scale])
    const line = svg("polyline", {class: "ln", points: points.join(" ")})
    line.style.strokeWidth = `${1 + 2 * Math.sqrt(share)}px`
    const dots = count <= DOTTED ? points.map(([cx, cy]) => svg("circle", {class: "body", cx, cy, r: 2.5})) : []
    const tint = share > TAKES_PART ? "slow" : "k"
    const drawn = svg("svg", {viewBox: `0 0 ${WIDE} ${HIGH}`, class: tint, "aria-hidden": "true"}, line, ...dots)
    const label = `Mode ${j + 1}, ${three(100 * share)} % of the energy: start it alone`
    const made = element(
      "button",
      {type: "button", "aria-label": label, "aria-pressed": String(isAlone)},
      `${j + 1}`,
      drawn,
    )
    made.classList.toggle("at-desk", isLess)
    made.addEventListener("click", () => this.page.host.take({...this.block.sets, [this.block.name]: j + 1}))
    return made
  }
}

/** The share of each mode in the energy, not counting the drift of a free chain. @param {page.Modal} signal */
function energies({omega, sizes}) {
  const found = omega.map((w, j) => (w * sizes[j]) ** 2)
  const all = found.reduce((sum, one) => sum + one, 0) || 1
  return found.map(one => one / all)
}
