// A pointer that holds something: followed until it lets go, while the page stands still under it.

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
 * Keeps a part where it stands in the window, whatever lines come and go above it: the page scrolls by as much.
 * @param {Element} part @returns {() => void} what ends it
 */
export function steady(part) {
  const top = () => part.getBoundingClientRect().top
  const stood = top()
  const observer = new ResizeObserver(() => scrollBy(0, top() - stood))
  // The page is as tall as before where one line comes above and another goes below: each part beside it is asked.
  for (let inner = part; inner.parentElement && inner !== document.body; inner = inner.parentElement)
    for (const beside of inner.parentElement.children) observer.observe(beside)
  return () => observer.disconnect()
}
