// Follows a pointer that drags until it is released. The page does not scroll meanwhile.

export const SIDEWAYS = 8 // px that a finger moves sideways before it drags instead of scrolling
const BY_HAND = "by-hand" // class of an element focused by a pointer; it has no focus ring until a key is pressed

/**
 * Focuses a part, so that it receives keys, without a focus ring.
 * @param {HTMLElement} part
 */
export function focusByHand(part) {
  part.focus({preventScroll: true}) // the help text that appears can move the page
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
 * Follows a pointer from the press until the release. For a tap, which has ended already, it calls `end` at once.
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
    if (target !== host) return // the capture was lost by an element inside `host`, where the touch began
    host.removeEventListener("pointermove", move)
    host.removeEventListener("lostpointercapture", stop)
    free()
    end()
  }
  host.addEventListener("lostpointercapture", stop)
}

/**
 * Keeps a part at its position in the window by scrolling when lines appear or disappear above it.
 * @param {Element} part @returns {() => void} function that stops this
 */
export function steady(part) {
  const top = () => part.getBoundingClientRect().top
  const before = top()
  const observer = new ResizeObserver(() => part.getClientRects().length && scrollBy(0, top() - before))
  // If a line appears above and another disappears below, the page keeps its height, so each part is measured.
  for (let inner = part; inner.parentElement && inner !== document.body; inner = inner.parentElement)
    for (const beside of inner.parentElement.children) observer.observe(beside)
  return () => observer.disconnect()
}
