// A pointer that drags: followed until it is released; the page does not scroll under it.

export const SIDEWAYS = 8 // px that a finger moves sideways before it drags instead of scrolling
const BY_HAND = "by-hand" // the class of an element with the focus from a pointer: no focus ring until a key is pressed

/**
 * Gives a part the focus for keys, with no focus ring.
 * @param {HTMLElement} part
 */
export function focusByHand(part) {
  part.focus({preventScroll: true}) // the help for it can move the page
  if (part.classList.contains(BY_HAND)) return
  const ended = new AbortController()
  const end = () => {
    part.classList.remove(BY_HAND)
    ended.abort()
  }
  part.classList.add(BY_HAND)
  for (const event of ["keydown", "focus"]) part.addEventListener(event, end, {signal: ended.signal})
}

/**
 * Calls `act` with a press. A finger may be about to scroll, so its press counts when it has moved sideways, or when it
 * is lifted. If the browser scrolls, nothing is called.
 * @param {HTMLElement} host @param {PointerEvent} event @param {(event: PointerEvent) => void} act
 */
export function unlessScrolled(host, event, act) {
  if (event.pointerType !== "touch" || getComputedStyle(host).touchAction === "none") return act(event)
  const waiting = new AbortController()
  const {signal} = waiting
  const decide = (/** @type {PointerEvent} */ later) => {
    if (later.pointerId !== event.pointerId) return
    const [across, along] = [later.clientX - event.clientX, later.clientY - event.clientY].map(Math.abs)
    const isDrag = across > SIDEWAYS && across > along
    if (later.type === "pointermove" && !isDrag) return
    waiting.abort()
    if (later.type !== "pointercancel") act(later)
  }
  for (const name of /** @type {const} */ (["pointermove", "pointerup", "pointercancel"]))
    host.addEventListener(name, decide, {signal})
}

/**
 * Follows a pointer from a press until it is released; a press that is over already, a tap, is followed by its end.
 * @param {HTMLElement} host @param {PointerEvent} event @param {(event: PointerEvent) => void} move
 * @param {() => void} end
 */
export function whilePressed(host, event, move, end) {
  move(event)
  if (event.type === "pointerup") return end()
  host.setPointerCapture(event.pointerId)
  whileHeld(host, move, end)
}

/**
 * Follows a pointer that `host` has captured.
 * @param {HTMLElement} host @param {(event: PointerEvent) => void} move @param {() => void} end
 */
export function whileHeld(host, move, end) {
  const free = steady(host.offsetParent ?? host)
  host.addEventListener("pointermove", move)
  const stop = (/** @type {PointerEvent} */ {target}) => {
    if (target !== host) return // a part in it that a finger was on before
    host.removeEventListener("pointermove", move)
    host.removeEventListener("lostpointercapture", stop)
    free()
    end()
  }
  host.addEventListener("lostpointercapture", stop)
}

/**
 * Keeps a part at its position in the window by scrolling when lines appear or disappear above it.
 * @param {Element} part @returns {() => void} ends it
 */
export function steady(part) {
  const top = () => part.getBoundingClientRect().top
  const stood = top()
  const observer = new ResizeObserver(() => part.getClientRects().length && scrollBy(0, top() - stood))
  // If a line appears above and another disappears below, the page keeps its height, so each part is measured.
  for (let inner = part; inner.parentElement && inner !== document.body; inner = inner.parentElement)
    for (const beside of inner.parentElement.children) observer.observe(beside)
  return () => observer.disconnect()
}
