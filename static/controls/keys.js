// Keys that work everywhere except in text fields. `?` opens a list of them, with buttons. Keys of a single letter can
// be switched off.

import {browserStorage} from "../core/storage.js"
import {using} from "../later.js"
import {blank} from "../shell/blank.js"
import {BEGINS_NUMBER} from "../core/numbers.js"

/**
 * A key: its names in events, its label, its description, and its action. If the focused element matches `own`, it
 * handles the key itself; a `shared` key is passed on to other listeners too.
 * @typedef {(lecture: LectureHost) => void} Act
 * @typedef {{keys: string[], shown: string, does: string, act: Act, own?: string, shared?: boolean}} Key
 */

const PRESSED = "button, a, summary, input, select, [role=slider], [role=application]"
const MOVED = "input, [role=slider], [role=application], [role=menuitem], [role=tab]"
const OVERLAYS = ".walks[open], .scene-menu[open], dialog.keys, dialog.class-large"
const OPEN = `${OVERLAYS}, .card .follows[open]`
const OFF = "single-keys"
const BOUNCE = 400 // ms within which a second press of a clicker counts as the first

/** @param {LectureHost} lecture @param {() => void} act runs if no question stops the clock */
function timed({page}, act) {
  if (!page.compare.still && !page.transport.element.inert && !page.transport.element.classList.contains("idle")) act()
}

/** @param {number} n @returns {Key["act"]} */
const numbered =
  n =>
  ({walks, page}) => {
    if (walks.walk) walks.walk.choose(n - 1)
    else page.controls.presets.buttons[n - 1]?.click()
  }

/** @type {Key[]} */
export const KEYS = [
  {keys: [" "], shown: "Space", does: "Play or pause", own: PRESSED, act: l => timed(l, () => l.clock.toggle())},
  {keys: ["["], shown: "[", does: "Step back in time", act: l => timed(l, () => l.clock.step(-1))},
  {keys: ["]"], shown: "]", does: "Step forward in time", act: l => timed(l, () => l.clock.step(1))},
  {keys: ["Home"], shown: "Home", does: "Restart", own: MOVED, act: l => timed(l, () => l.clock.seek(0))},
  {keys: [","], shown: ",", does: "Previous view", act: l => l.page.views.turn(-1)},
  {keys: [";"], shown: ";", does: "Next view", act: l => l.page.views.turn(1)},
  {keys: ["0"], shown: "0", does: "Fit axes, time window and speed", act: l => l.fit()},
  {
    keys: ["PageDown"],
    shown: "Page Down",
    does: "In a walk: show the answer, the explanation, the next step; in a scene: back to the walk",
    act: l => l.walks.turn(1),
  },
  {
    keys: ["PageUp"],
    shown: "Page Up",
    does: "In a walk: undo the last Page Down",
    act: l => l.walks.turn(-1),
  },
  ...[1, 2, 3, 4].map(n => ({keys: [`${n}`], shown: `${n}`, does: `Answer ${n}, or preset ${n}`, act: numbered(n)})),
  {
    keys: ["h", "H"],
    shown: "H",
    does: "Hold: keep these curves for comparison, or release them",
    act: l => l.page.compare.toggle(),
  },
  {keys: ["w", "W"], shown: "W", does: "Choose a walk, leave it, or come back to it", act: l => l.walks.toggle()},
  {keys: ["r", "R"], shown: "R", does: "Reveal what is covered", act: l => l.walks.reveal()},
  {keys: ["c", "C"], shown: "C", does: "Hide the controls, or show them again", act: l => l.hall.fold()},
  {keys: ["p", "P"], shown: "P", does: "Projector: large type for a lecture hall", act: l => l.hall.toggle()},
  {keys: ["f", "F"], shown: "F", does: "Full screen", act: l => l.hall.full()},
  {keys: ["t", "T"], shown: "T", does: "Start a live class", act: l => void (l.classes.led ?? l.classes.begin())},
  {
    keys: ["v", "V"],
    shown: "V",
    does: "Vote A to D on a question asked aloud, in a live class",
    act: l => l.classes.poll(),
  },
  {
    keys: ["s", "S"],
    shown: "S",
    does: "Ask how sure everybody is of the answer, in a live class",
    act: l => l.classes.askSure(),
  },
  {
    keys: ["d", "D"],
    shown: "D",
    does: "Start a countdown of 30 s for a vote; press again to add 15 s",
    act: l => l.classes.countDown(),
  },
  {
    keys: ["j", "J"],
    shown: "J",
    does: "Show the code of the class, large",
    act: l => l.classes.led?.joinScreen.toggle(),
  },
  {keys: [".", "b", "B"], shown: "B or .", does: "Blank the screen; any key brings it back", act: () => blank()},
  {keys: ["Escape"], shown: "Esc", does: "Close what is open", act: close, shared: true},
  {keys: ["?"], shown: "?", does: "Show this list", act: list},
]

const isLetter = (/** @type {string} */ key) => /^[a-z.]$/i.test(key)

/** True if keys of a single letter are on; the browser stores the choice. */
export const singles = {
  off: false,
  read() {
    this.off = browserStorage.text(OFF) === "off"
  },
  /** @param {boolean} off */
  set(off) {
    this.off = off
    browserStorage.keepOrSay(OFF, off ? "off" : "on")
  },
}

/** @param {LectureHost} lecture */
export function listen(lecture) {
  singles.read()
  document.querySelector("#keys")?.addEventListener("click", () => list(lecture))
  addEventListener("keydown", event => handleKey(event, lecture), true)
}

/**
 * Handles a key. Page Down and Page Up go to the walk, or to the focused element if there is no walk.
 * @param {KeyboardEvent} event @param {LectureHost} lecture
 */
function handleKey(event, lecture) {
  const black = document.querySelector(".blank")
  if (black) {
    // The key that ends a blank screen does nothing else.
    black.remove()
    event.preventDefault()
    return event.stopImmediatePropagation()
  }
  const known = KEYS.find(({keys}) => keys.includes(event.key))
  if (!known || !lecture.page || !acts(event, known)) return
  const turns = event.key.startsWith("Page")
  if (turns && !lecture.walks.turns) return
  if (!known.shared) {
    event.preventDefault()
    event.stopPropagation()
  }
  if (turns && isBounced(event)) return
  if (turns && isOverlaid()) return close()
  known.act(lecture)
}

let turned = -Infinity

/** @param {KeyboardEvent} event */
function isBounced({timeStamp}) {
  const since = timeStamp - turned
  if (since >= BOUNCE) turned = timeStamp
  return since < BOUNCE
}

/** True if a dialog or menu covers the page; a clicker closes it first. */
const isOverlaid = () => document.querySelector(OVERLAYS) !== null

/** @param {KeyboardEvent} event @param {Key} known */
function acts(event, {own}) {
  const {target, key} = event
  if (event.ctrlKey || event.metaKey || event.altKey) return false
  if (document.querySelector("dialog:modal") || (singles.off && isLetter(key))) return false
  if (!(target instanceof HTMLElement)) return true
  const isTyped = key.length === 1 || key === "Home"
  if (isTyped && isTyping(target)) return false
  // A digit opens the field of a slider.
  return !(BEGINS_NUMBER.test(key) && target.matches("[type=range]")) && !(own && target.matches(own))
}

/** @param {HTMLElement} target */
const isTyping = target =>
  target.isContentEditable || target.matches("input:not([type=range], [type=checkbox]), textarea, select")

/** Closes menus, the equations of a step and the list of keys. Only its own key leaves a walk. */
function close() {
  for (const open of document.querySelectorAll(OPEN)) {
    const summary = open.querySelector("summary")
    if (summary && open.contains(document.activeElement)) summary.focus()
    if (open instanceof HTMLDetailsElement) open.open = false
    else if (open instanceof HTMLDialogElement) open.close()
    else open.remove()
  }
}

/** @param {LectureHost} lecture */
function list(lecture) {
  using("controls/key_list", ({toggleList}) => toggleList(KEYS, singles, ({act}) => act(lecture)))
}
