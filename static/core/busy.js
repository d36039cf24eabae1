// Busy: a pointer is down or a field is being edited, so the page must not reload yet.

export class Busy {
  isPressed = false
  edits = false

  /** @type {(() => void) | null} */
  act = null

  constructor() {
    this.#on(["pointerdown"], () => (this.isPressed = true))
    this.#on(["pointerup", "pointercancel"], () => (this.isPressed = false))
    this.#on(["input"], ({target}) => (this.edits = target instanceof HTMLInputElement && target.type === "text"))
    this.#on(["change", "focusout"], () => (this.edits = false))
  }

  /** @param {string[]} events @param {(event: Event) => void} note */
  #on(events, note) {
    for (const name of events) {
      addEventListener(
        name,
        event => {
          note(event)
          setTimeout(() => this.#look()) // after all other handlers of the event
        },
        true,
      )
    }
  }

  /** @param {() => void} act */
  whenFree(act) {
    this.act = act
    this.#look()
  }

  #look() {
    const {act, isPressed, edits} = this
    if (!act || isPressed || edits) return
    this.act = null
    act()
  }
}
