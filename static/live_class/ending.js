// The dialog that ends a class: says what is deleted, and offers to save the answers as CSV first.

import {button, element} from "../core/dom.js"
import {inWords} from "../core/notes.js"
import {save} from "../export/save.js"
import {fetchJson, asked} from "./requests.js"

const PATIENCE = 60000 // ms for the answers of a whole lecture

export class Ending {
  /** @type {HTMLDialogElement | null} */
  dialog = null

  isOpening = false

  /** @param {page.Opened} room @param {{end: () => void, tell: (sentence: string) => void}} acts */
  constructor(room, {end, tell}) {
    this.room = room
    this.end = end
    this.tell = tell
  }

  /** Asks whether to end the class. Throws a Refusal if the server does not say how much that would delete. */
  async open() {
    if (this.dialog || this.isOpening) return
    this.isOpening = true
    const {code, key} = this.room
    /** @type {page.Stored} */
    const stored = await fetchJson(`${code}/stored`, {word: key}).finally(() => (this.isOpening = false))
    const status = element("p", {class: "done", role: "status"})
    const end = button({class: "act"}, () => this.#end(status), "End the class")
    const cancel = button({class: "act"}, () => this.close(), "Cancel")
    const csv = button({class: "act"}, () => this.#save(status, end), "Save the answers as CSV")
    const buttons = stored.answers ? [csv, end, cancel] : [cancel, end]
    buttons[0].classList.add("filled")
    const about = {class: "asking class-ending", "aria-labelledby": "ending"}
    const heading = element("h1", {id: "ending"}, `End the class ${code}?`)
    this.dialog = element("dialog", about, heading, element("p", {}, deleted(stored)), status)
    this.dialog.append(element("div", {class: "tools"}, ...buttons))
    this.dialog.addEventListener("close", () => this.close()) // by Esc
    document.body.append(this.dialog)
    this.dialog.showModal()
    buttons[0].focus()
  }

  /** A press of End on a remote control: the first press opens the dialog, the second ends the class. */
  press() {
    if (this.dialog) this.end()
    else this.open().catch(reason => this.tell(inWords(reason)))
  }

  /** @param {HTMLElement} status */
  #end(status) {
    status.textContent = "Ending the class."
    this.end()
  }

  /** Closes the dialog; returns true if it was open. */
  close() {
    const {dialog} = this
    this.dialog = null
    dialog?.remove()
    return dialog !== null
  }

  /** @param {HTMLElement} status @param {HTMLElement} end the button that is focused next */
  async #save(status, end) {
    status.textContent = ""
    try {
      const name = await saveAnswers(this.room)
      status.textContent = `Saved as ${name}.`
      end.focus()
    } catch (reason) {
      status.textContent = `Not saved. ${inWords(reason)}`
    }
    status.className = status.textContent.startsWith("Saved") ? "done" : "problem"
  }
}

/** Says in a sentence how much the end of a class deletes. @param {page.Stored} stored */
export function deleted({answers, questions}) {
  if (!answers) return "Nobody has answered yet. The code stops working, and phones leave the class."
  const what = `${counted(answers, "answer")} to ${counted(questions, "question")}`
  return `This deletes ${what}. The code stops working, and phones leave the class.`
}

/** @param {number} count @param {string} one */
const counted = (count, one) => `${count} ${one}${count === 1 ? "" : "s"}`

/** Save all answers of a class as a file; return its name. @param {page.Opened} room */
export async function saveAnswers({code, key}) {
  const answer = await asked(`${code}/answers.csv`, {word: key, signal: AbortSignal.timeout(PATIENCE)})
  const name = `class-${code}.csv`
  save(name, await answer.blob(), "text/csv")
  return name
}
