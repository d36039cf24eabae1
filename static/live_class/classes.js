// Opens or joins a live class from an ordinary page; the modules for that are loaded on demand.

import {later} from "../later.js"
import {inWords} from "../core/notes.js"
import {LED, LEFT, SOUGHT, tabStorage} from "../core/storage.js"

export class Classes {
  /** @type {import("./teach.js").Teach | null} the class that this page leads */
  led = null

  code = "" // of the class that this page leads or has led; it decides the order of options

  askedStep = "" // the question of the lecture while this page looks around outside the class

  /** @param {LectureHost} lecture */
  constructor(lecture) {
    this.lecture = lecture
    const form = document.querySelector(".class-join")
    form?.addEventListener("submit", event => {
      event.preventDefault()
      const code = /** @type {HTMLInputElement} */ (form.querySelector("input")).value
      location.assign(`./?class=${encodeURIComponent(code)}`)
    })
  }

  /**
   * Opens a class, or returns to the one that this browser leads. If this page leads a class already,
   * shows or hides the code of that class.
   */
  async begin() {
    if (this.led) return this.led.joinScreen.toggle()
    if (this.opening) return
    this.opening = true
    try {
      const {teach} = await later("live_class/teach")
      this.led = await teach(this.lecture)
      this.code = this.led.room.code
    } catch (reason) {
      this.lecture.page.notice.tell(inWords(reason))
    }
    this.opening = false
  }

  /** Starts a vote A to D on a question asked aloud. */
  poll() {
    if (this.led) this.led.poll()
    else this.lecture.page.notice.tell("A vote needs a live class: press T.")
  }

  /** Asks the students how sure they are of their answers. */
  askSure() {
    if (this.led) this.led.askSure()
    else this.lecture.page.notice.tell("How sure a class is can be asked in a live class: press T.")
  }

  /** Starts or extends the countdown of the vote. */
  countDown() {
    if (this.led) this.led.countDown()
    else this.lecture.page.notice.tell("A countdown needs a vote of a live class: press T.")
  }

  /** True if questions have the numbers of a class: this page leads one, has led one, or is about to return to one. */
  get hasNumbers() {
    return Boolean(this.code || tabStorage.text(LED))
  }

  opening = false // true while a class is being opened, so that a second press opens no other one

  /** Called for each new connection, whose session must know of the class. */
  connected() {
    if (this.led) this.led.lead()
    else if (!this.asked) this.#kept()
    this.asked = true
  }

  asked = false

  /** Returns to the class that this tab leads, or offers a follower who looks around the way back to the class. */
  async #kept() {
    if (tabStorage.text(LED)) await this.begin()
    const left = tabStorage.text(LEFT)
    const sought = /** @type {page.State | null} */ (tabStorage.value(SOUGHT))
    tabStorage.forget(SOUGHT)
    if (left && sought) this.lecture.open(sought)
    if (left) (await later("live_class/looking_around")).ownWay(left, step => (this.askedStep = step))
  }
}
