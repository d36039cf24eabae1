// A pointer that drags: followed until it is released; the page does not scroll under it.

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
 * Follows a pointer that `host` has captured.
 * @param {HTMLElement} host @param {(event: PointerEvent) => void} move @param {() => void} end
 */
export function whileHeld(host, move, end) {
  const free = steady(host.offsetParent ?? host)
  host.addEventListener("pointermove", move)
  const stop = () => {
    host.removeEventListener("pointermove", move)
    free()
    end()
  }
  host.addEventListener("lostpointercapture", stop, {once: true})
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
