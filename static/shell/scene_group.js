// The scenes of one lecture in the navigation: links, or on a narrow screen a button that opens their list.

const STEPS = new Map([
  ["ArrowDown", 1],
  ["ArrowUp", -1],
])

export class Group {
  /** @param {Element} element */
  constructor(element) {
    this.element = element
    this.button = /** @type {HTMLButtonElement} */ (element.querySelector("button"))
    /** @type {HTMLAnchorElement[]} */
    this.links = [...element.querySelectorAll("a")]
    this.button.addEventListener("click", () => this.#open(!this.isOpen))
    element.addEventListener("keydown", event => this.#key(/** @type {KeyboardEvent} */ (event)))
    element.addEventListener("focusout", event => {
      const {relatedTarget: to} = /** @type {FocusEvent} */ (event)
      if (to && !element.contains(/** @type {Node} */ (to))) this.close()
    })
    addEventListener("pointerdown", ({target}) => {
      if (!element.contains(/** @type {Node} */ (target))) this.close()
    })
  }

  get isOpen() {
    return this.button.getAttribute("aria-expanded") === "true"
  }

  /** @param {boolean} isOpen */
  #open(isOpen) {
    this.button.setAttribute("aria-expanded", String(isOpen))
  }

  close() {
    this.#open(false)
  }

  /** True if the current scene is one of these. */
  turned() {
    this.element.classList.toggle(
      "here",
      this.links.some(link => link.classList.contains("here")),
    )
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    const step = STEPS.get(event.key)
    const at = this.links.findIndex(link => link === document.activeElement)
    if (event.key === "Escape" && this.isOpen) {
      this.close()
      this.button.focus()
    } else if (step && (this.isOpen || document.activeElement === this.button)) {
      this.#open(true)
      const {length} = this.links
      this.links[at < 0 && step < 0 ? length - 1 : (at + step + length) % length].focus()
    } else return
    event.preventDefault()
    event.stopPropagation()
  }
}
