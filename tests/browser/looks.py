"""Checks of a loaded page that only read it: each returns sentences about faults. Scenes and sizes to look at."""

from collections.abc import Iterator
from pathlib import Path
from typing import cast

import axe_playwright_python
from playwright.sync_api import Page

from components.scene import Scene
from tests.browser.waiting import passed, seek
from tests.scenes.checks import choices

GRID = (
    *((1250, 590), (1024, 768), (844, 390), (360, 640)),
    *((1280, 720), (1249, 1000), (1920, 1080), (2560, 1440), (3840, 2160), (1600, 480)),
    *((853, 480), (768, 1024), (640, 360), (600, 800), (390, 844), (320, 640), (320, 320)),
)
"""Sizes of windows."""


def seen(scene: type[Scene]) -> Iterator[Scene]:
    """The scene as it opens, then with each other option of each choice."""
    yield (opens := scene.at())
    yield from (scene.at(choice) for choice in choices(scene) if opens.differing(choice))


FAULTS = r"""([least, leastIndex]) => {
  const faults = []
  const style = element => getComputedStyle(element)
  const hasSize = ({width, height}) => width > 1 && height > 1
  // An SVG text inside a group that is not drawn passes for visible, but has no size.
  const stands = element =>
    element.checkVisibility({opacityProperty: true, visibilityProperty: true}) &&
    hasSize(element.getBoundingClientRect())
  const scrollers = new Map()
  const scroller = element => {
    if (!element || element === document.body) return null
    if (!scrollers.has(element)) {
      const {overflowX, overflowY, display} = style(element)
      const holds = display !== "contents" && /auto|scroll|hidden|clip/.test(overflowX + overflowY)
      scrollers.set(element, holds && !(element instanceof SVGElement) ? element : scroller(element.parentElement))
    }
    return scrollers.get(element)
  }
  const named = ({owner, text}) => {
    const place = owner.closest(".block, .group, .transport, .nav, .panel, .page")
    return `${(place?.getAttribute("class") ?? "").trim()}: ${text.replace(/\s+/g, " ")}`
  }
  const pieces = new Map()
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT)
  const range = document.createRange()
  while (walker.nextNode()) {
    const node = walker.currentNode, element = node.parentElement
    const owner = element.closest("text, math, td, th") ?? element
    if (!node.textContent.trim() || !stands(element) || !stands(owner) || element.closest("option, .figure")) continue
    range.selectNodeContents(node)
    const piece = pieces.get(owner) ?? {owner, text: "", boxes: []}
    piece.text += node.textContent
    piece.boxes.push(...[...range.getClientRects()].filter(hasSize))
    pieces.set(owner, piece)
    const size = parseFloat(style(element).fontSize) * (element.getScreenCTM?.().a ?? 1)
    const isIndex = element.closest("sub, sup, .sub, msub, msup, msubsup, mover, mfrac, tspan")
    if (size < (isIndex ? leastIndex : least) - 0.01) faults.push(`small, ${size.toFixed(1)} px: ${named(piece)}`)
  }
  const texts = [...pieces.values()]
  const controls = [...document.querySelectorAll("button, input, summary, .pill, .flag, nav a")].filter(stands)
  for (const field of controls) {
    if (field.matches("input:not([type=range])") && field.scrollWidth > field.clientWidth + 1)
      faults.push(`cut in its field: ${field.name} ${field.value}`)
  }
  if (document.documentElement.scrollWidth > innerWidth) faults.push("the page scrolls sideways")

  const wide = holder => holder.scrollWidth > holder.clientWidth + 1 && style(holder).overflowX !== "hidden"
  const parts = controls.map(owner => ({owner, text: owner.getAttribute("aria-label") ?? owner.textContent,
                                       boxes: [owner.getBoundingClientRect()]}))
  const staying = [...document.querySelectorAll(".paper *")]
    .filter(part => style(part).position === "sticky" && stands(part))
    .map(part => ({part, box: part.getBoundingClientRect()}))
  const isCut = ({left, right}, frame) => left < frame.left - 1.5 || right > frame.right + 1.5
  for (const piece of [...texts, ...parts]) {
    const holder = scroller(piece.owner)
    const frame = holder?.getBoundingClientRect() ?? {left: 0, right: innerWidth, top: -Infinity, bottom: Infinity}
    // A list that scrolls sideways may continue beyond its edge.
    const isList = holder?.matches(".tabs, .tiles, .chips, .mode-row, .roles, .words, .table, .choice, .head, .group")
    if (isList && wide(holder)) piece.gone = true
    else if (piece.boxes.some(box => isCut(box, frame))) faults.push(`cut: ${named(piece)}`)
    piece.boxes = piece.boxes.filter(({top, bottom}) => bottom > frame.top && top < frame.bottom)
    if (!piece.boxes.length) piece.gone = true
    // Nor is what lies under a part that stays in sight.
    const lies = ({top, bottom}, over) => top < over.bottom && bottom > over.top
    for (const {part, box} of staying)
      if (!part.contains(piece.owner) && piece.boxes.some(one => lies(one, box))) piece.gone = true
  }

  const seen = texts.filter(piece => !piece.gone)
  // Whatever is clicked through, what lies uppermost at the foot of a text is that text, or can be seen through.
  const reached = document.head.appendChild(document.createElement("style"))
  reached.textContent = "*:not(.pointer) { pointer-events: auto !important }"
  const isClear = colour => /^(none|transparent|rgba\(.*, 0\))$/.test(colour)
  const hides = (part, owner) => {
    if (part instanceof SVGRectElement && !isClear(style(part).fill)) return part
    for (; part && !part.contains(owner); part = part.parentElement)
      if (!isClear(style(part).backgroundColor)) return part
  }
  for (const piece of seen) {
    const {left, width, bottom, height} = piece.boxes[piece.boxes.length - 1]
    const y = bottom - height / 3
    const covers = [0.2, 0.5, 0.8].map(share => left + share * width).map(x => {
      const over = document.elementFromPoint(x, y)
      const cover = over && !piece.owner.contains(over) && hides(over, piece.owner)
      // A finger's handle is hit beyond its box, where it shows nothing.
      const box = cover && cover.getBoundingClientRect()
      return box && x > box.left && x < box.right && y > box.top && y < box.bottom && cover
    })
    const cover = covers.find(cover => cover && stands(cover))
    if (cover) faults.push(`under ${cover.getAttribute("class")}: ${named(piece)}`)
  }
  reached.remove()
  // Letters do not fill their line: a quarter of it above and below is air.
  const meet = (one, other) =>
    one.left + 1.5 < other.right && other.left + 1.5 < one.right &&
    one.top + one.height / 4 < other.bottom - other.height / 4 &&
    other.top + other.height / 4 < one.bottom - one.height / 4
  for (const [i, one] of seen.entries()) {
    for (const other of seen.slice(i + 1)) {
      if (one.owner.contains(other.owner) || other.owner.contains(one.owner)) continue
      if (one.boxes.some(box => other.boxes.some(another => meet(box, another))))
        faults.push(`overlap: ${named(one)} | ${named(other)}`)
    }
  }
  return faults
}"""


def faults(page: Page, least: float = 12, index: float = 11) -> list[str]:
    """Return the faults in the layout of a page: parts that overlap, are cut off, leave their frame, or have letters
    below `least` pixels of the page, an index below `index`.
    """
    return cast(list[str], page.evaluate(FAULTS, [least, index]))


AXE = (Path(axe_playwright_python.__file__).parent / "axe.min.js").read_text(encoding="utf-8")
# Results are marked on the page, because axe names texts by positions that change if a stage changes its size.
RUN_AXE = """async () => {
  const wanted = {resultTypes: ["violations", "incomplete"], elementRef: true}
  const {violations, incomplete} = await axe.run(document, wanted)
  let found = 0
  return [...violations, ...incomplete].flatMap(({id, nodes}, i) => nodes.map(({element, html}) => {
    element.dataset.found ??= ++found
    const target = `[data-found="${element.dataset.found}"]`
    return {id, html: html.slice(0, 160), target, fault: i < violations.length}
  }))
}"""
# A drawing has no background. A text is on the paper, or on the mass that it names; a halo in the colour of the paper
# separates it from lines.
CONTRAST = """targets => {
  const channel = c => (c /= 255, c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4)
  const parsed = colour => colour.match(/[\\d.]+/g).map(Number)
  const light = ([r, g, b]) => 0.2126 * channel(r) + 0.7152 * channel(g) + 0.0722 * channel(b)
  const opaque = colour => colour.startsWith("rgb") && (parsed(colour)[3] ?? 1) === 1
  const ground = one => {
    const label = one.closest("text.on")
    for (let at = label; at; at = at.previousElementSibling ?? at.parentElement?.previousElementSibling) {
      const filled = [at, ...at.children].filter(part => part.matches(".mass, .body, .fill, circle, rect"))
      const fill = filled.map(part => getComputedStyle(part).fill).find(opaque)
      if (fill) return fill
    }
    for (let at = one; at; at = at.parentElement) {
      const {backgroundColor} = getComputedStyle(at)
      if (opaque(backgroundColor)) return backgroundColor
    }
  }
  return targets.map(selector => {
    const one = document.querySelector(selector), style = getComputedStyle(one)
    const [a, b] = [one instanceof SVGElement ? style.fill : style.color, ground(one)].map(c => light(parsed(c)))
    const large = parseFloat(style.fontSize) >= (style.fontWeight >= 600 ? 18.66 : 24)
    return (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05) < (large ? 3 : 4.5)
  })
}"""


def axe(page: Page) -> list[str]:
    """The faults that axe-core finds. It cannot decide the contrast of texts over drawings, which is computed here."""
    page.evaluate(AXE)
    found = page.evaluate(RUN_AXE)
    undecided = [one for one in found if not one["fault"] and one["id"] == "color-contrast"]
    pale = page.evaluate(CONTRAST, [one["target"] for one in undecided])
    faults = [one for one in found if one not in undecided]
    faults += [one for one, is_pale in zip(undecided, pale, strict=True) if is_pale]
    page.evaluate("document.querySelectorAll('[data-found]').forEach(one => one.removeAttribute('data-found'))")
    return [f"axe {one['id']}: {one['html']}" for one in faults]


TARGETS = r"""least => {
  const pressed = "a[href], button, input, summary, [role=slider]"
  const moved = ".grip, .pill"
  const faults = []
  const seen = one => one.checkVisibility({opacityProperty: true, visibilityProperty: true}) && !one.disabled
  for (const one of document.querySelectorAll(pressed)) {
    // A link in a sentence is as high as its line.
    if (!seen(one) || one.closest(".skip, .words, p") || one.matches(".take")) continue
    one.scrollIntoView({block: "center", inline: "center"})
    const {left, right, top, bottom} = one.getBoundingClientRect()
    if (right - left < 1 || bottom - top < 1) continue
    const [x, y] = [(left + right) / 2, (top + bottom) / 2]
    const hits = (dx, dy) => {
      const hit = document.elementFromPoint(x + dx, y + dy)
      // Handles with equal values cover each other: only the upper one can be dragged.
      const shared = one.matches(moved) && hit?.closest(moved)
      return hit && (one.contains(hit) || shared || (hit.control ?? hit.closest("label")?.control) === one)
    }
    const reach = (dx, dy) => {
      let far = 0
      while (far < least && hits(dx * far, dy * far)) far += 0.5
      return far
    }
    const [wide, high] = [reach(-1, 0) + reach(1, 0), reach(0, -1) + reach(0, 1)]
    if (wide >= least - 1 && high >= least - 1) continue
    const name = one.getAttribute("aria-label") ?? one.name ?? ""
    faults.push(`target ${one.className || one.tagName}: ${name || one.textContent.trim()} ${wide} x ${high}`)
  }
  scrollTo(0, 0)
  return faults
}"""
"""Everything that is pressed or dragged and is smaller than this many pixels, where a pointer hits it."""
ORDER = r"""() => {
  const texts = "p, h1, h2, table, .item, .note, summary, label"
  const stops = "a[href], button, input, select, [tabindex]"
  const isSeen = part => part.checkVisibility({visibilityProperty: true, opacityProperty: true}) &&
    !part.closest(".heard, .skip, .foot") // the foot of a card stays at the bottom of the screen
  const pictures = ".plot-area, .block.stage" // what is over a picture has no order from top to bottom
  const parts = [...document.querySelectorAll(`.page :is(${texts}, ${stops}, ${pictures})`)]
    .filter(part => isSeen(part) && !part.parentElement.closest(`${pictures}, ${texts}, button`))
  const range = document.createRange()
  const boxed = part => {
    range.selectNodeContents(part)
    let {left, right, top, bottom} = (part.matches(texts) ? range : part).getBoundingClientRect()
    for (let holder = part; holder !== document.body; holder = holder.parentElement) {
      if (getComputedStyle(holder).overflowX === "visible") continue
      const frame = holder.getBoundingClientRect() // what is scrolled out of it is not seen
      ;[left, right] = [Math.max(left, frame.left), Math.min(right, frame.right)]
    }
    return {part, left, right, top, bottom, name: part.ariaLabel || part.textContent.trim() || part.className}
  }
  const boxes = parts.map(boxed).filter(({left, right, top, bottom}) => right - left > 1 && bottom - top > 1)
  const isBefore = (one, other) => {
    if (one.part.closest(".control") && one.part.closest(".control") === other.part.closest(".control")) return false
    const across = Math.min(one.right, other.right) - Math.max(one.left, other.left)
    const along = Math.min(one.bottom, other.bottom) - Math.max(one.top, other.top)
    const least = Math.min(one.bottom - one.top, other.bottom - other.top)
    return (one.bottom <= other.top + 3 && across > 3) || (along > least / 2 && one.right <= other.left + 3)
  }
  return boxes.flatMap((one, i) => boxes.slice(i + 1).filter(later => isBefore(later, one))
    .map(later => `“${later.name.slice(0, 40)}” comes after “${one.name.slice(0, 40)}” for the Tab key and readers`))
}"""
"""Parts of which one is above the other, or left of it in the same line, but later in the document."""
TWICE = """() => {
  const names = [...document.querySelectorAll("button, [role=slider], input")]
    .filter(one => one.checkVisibility() && !one.closest(".seg"))
    .map(one => `${one.localName} ${one.type ?? ""} ${one.getAttribute("aria-label") ?? one.textContent.trim()}`)
  const ordered = document.querySelectorAll("[tabindex]:not([tabindex='0'], [tabindex='-1'])")
  return [...names.filter((name, i) => names.indexOf(name) !== i).map(name => `two have the name ${name}`),
    ...[...ordered].map(one => `tabindex of ${one.className}`)]
}"""
"""Names that two things to press have, except the words of a choice, which its group names."""
TICKS = """() => [
  ...oscillations.plots.filter(({host}) => host.checkVisibility()).flatMap(plot => {
    const bare = text => text.replaceAll(" ", "")
    return [...plot.labels.scale.children].filter(number => !plot.y.ticks.some((tick, i) =>
      bare(plot.y.labels[i]) === bare(number.textContent) &&
      Math.abs(number.getAttribute("y") - plot.py(tick)) < 5
    )).map(number => `not at its tick: ${number.textContent} of ${plot.block.name}`)
  }),
  ...[...document.querySelectorAll("svg *")].filter(one =>
    [...one.attributes].some(attribute => /NaN|undefined|Infinity/.test(attribute.value)))
    .map(one => `not a number: ${one.outerHTML.slice(0, 80)}`),
]"""
"""Numbers away from their ticks, drawings without numbers."""
LOST = """() => {
  const style = document.head.appendChild(document.createElement("style"))
  const cut = () => [...document.querySelectorAll("h1, h2, p, label, button, a, summary, td, .chip")].filter(one => {
    const {overflowX, overflowY} = getComputedStyle(one)
    const wide = overflowX !== "visible" && one.scrollWidth > one.clientWidth + 1
    const high = overflowY !== "visible" && one.scrollHeight > one.clientHeight + 1
    return one.checkVisibility() && !one.closest(".heard") && (wide || high)
  })
  const before = new Set(cut())
  style.textContent = `
    * { line-height: 1.5 !important; letter-spacing: 0.12em !important; word-spacing: 0.16em !important }
    p { margin-bottom: 2em !important }`
  const lost = cut().filter(one => !before.has(one)).map(one => `cut in wider text: ${one.outerHTML.slice(0, 120)}`)
  if (document.documentElement.scrollWidth > innerWidth) lost.push("wider text scrolls sideways")
  style.remove()
  return lost
}"""
"""Texts that are cut with the spacing of WCAG 1.4.12."""
UNINKED = """() => oscillations.plots.filter(plot => plot.host.offsetParent && !plot.absent).filter(plot => {
  const below = one => [one, ...(one.shadowRoot ? within(one.shadowRoot) : [])]
  const within = root => [...root.querySelectorAll('*')].flatMap(below)
  const canvases = within(plot.host).filter(one => one.tagName === 'CANVAS' && one.width)
  const pixels = canvases.map(one => one.getContext('2d').getImageData(0, 0, one.width, one.height).data)
  const probe = document.createElement('canvas').getContext('2d')
  const has = tint => {
    probe.fillStyle = getComputedStyle(document.documentElement).getPropertyValue('--' + tint).trim()
    probe.fillRect(0, 0, 1, 1)
    const ink = probe.getImageData(0, 0, 1, 1).data
    return pixels.some(data => {
      for (let i = 0; i < data.length; i += 4)
        if (data[i + 3] > 99 && [0, 1, 2].every(part => Math.abs(data[i + part] - ink[part]) < 40)) return true
      return false
    })
  }
  const {curves, regions} = plot.block
  return curves.length + regions.length && ![...curves, ...regions].some(part => has(part.tint))
}).map(plot => `no curve is drawn in ${plot.block.name}`)"""
"""Plots without a pixel in the colour of any of their curves."""
SIZES = """() => {
  scrollTo(0, 500)
  const staying = [...document.querySelectorAll(".paper *, .nav")].filter(one =>
    getComputedStyle(one).position === "sticky" && one.checkVisibility()).map(one => one.getBoundingClientRect().height)
  scrollTo(0, 0)
  const share = staying.reduce((sum, height) => sum + height, 0) / innerHeight
  const most = document.querySelector(".transport .note:not(:empty)") ? 0.48 : 0.45 // a note is a second line
  return share > most ? [`what stays in sight covers ${share}`] : []
}"""
"""Parts that stay in sight and leave no room."""
FIELDS = """() => {
  const fields = "input:not([type=checkbox], [type=radio], [type=range]), select, textarea"
  return [...document.querySelectorAll(fields)].filter(one => parseFloat(getComputedStyle(one).fontSize) < 16)
    .map(one => `a phone zooms in to ${one.name || one.id || one.type}`)
}"""
"""Fields with text so small that Safari on a phone zooms in, and stays there."""
DESK = """() => {
  const faults = [], page = document.documentElement, paper = document.querySelector(".paper")
  const closing = paper.parentElement.querySelector(".notice")?.offsetHeight ?? 0 // gives its room back
  const hidden = paper.scrollHeight - paper.clientHeight - closing
  if (hidden > 1) faults.push(`${hidden} px of the sheet are out of sight`)
  if (innerHeight >= 700 && page.scrollHeight > innerHeight) faults.push("the page scrolls down")
  return faults
}"""
"""On a desk the whole sheet is visible, with its handles."""
PANEL = """() => {
  const {scrollHeight, clientHeight} = document.querySelector(".panel")
  return innerHeight >= 700 && scrollHeight > clientHeight ? [`the panel is ${scrollHeight} px high`] : []
}"""
"""The folded panel of a scene as it opens is visible, too."""
FIRST = """([names, screens, room]) => {
  const most = screens * innerHeight + room
  const seen = one => one?.checkVisibility()
  const hosts = [...oscillations.page.sheet.hosts].map(([{part}, host]) => [part, host])
    .filter(([part]) => names.includes(part))
  const keys = [...document.querySelectorAll(".keys-of-view:not([hidden]) > :not(h2, [hidden])")]
    .map(host => ["keys", host]).filter(() => names.includes("keys") || screens > 1)
  const below = [...hosts, ...keys].filter(([, host]) =>
    !seen(host) || Math.round(host.getBoundingClientRect().bottom + scrollY) > most)
  const missing = names.filter(name => ![...hosts, ...keys].some(([part]) => part === name))
  const task = [...document.querySelectorAll(".view-task")].find(seen)
  const {lineHeight, paddingTop, paddingBottom} = getComputedStyle(task)
  const letters = task.clientHeight - parseFloat(paddingTop) - parseFloat(paddingBottom)
  const headline = document.createRange()
  headline.selectNodeContents(document.querySelector("h1"))
  const lines = new Set([...headline.getClientRects()].map(({top}) => Math.round(top))).size
  return [
    ...missing.map(part => `${part} of the task is missing`),
    ...below.map(([part]) => `${part} of the task is below ${most} px`),
    ...(screens > 1 || letters < 3.5 * parseFloat(lineHeight) ? [] : ["the task has more than three lines"]),
    ...(screens > 1 || lines < 3 ? [] : ["the headline has more than two lines"]),
  ]
}"""
"""Parts that a task names and that end more than `room` px below so many screens; long tasks and headlines."""
SIDEWAYS = """() => {
  const seen = kind => [...document.querySelectorAll(`.block.${kind}`)].filter(one => one.checkVisibility())
    .map(one => one.getBoundingClientRect()).sort((one, other) => one.top - other.top)[0]
  const [stage, plot] = [seen("plot.path") ?? seen("stage"), seen("plot:not(.path)")] // a path is a picture, too
  const play = [...document.querySelectorAll(".transport .play")].filter(one => one.checkVisibility())
    .filter(one => one.getBoundingClientRect().bottom > innerHeight)
  const {bottom} = document.querySelector(".transport").getBoundingClientRect() // of the picture with its clock
  const beside = !stage || !plot || (stage.right <= plot.left + 1 && stage.top < plot.bottom && plot.top < bottom)
  return [...(beside ? [] : ["the plot is not next to the picture"]), ...play.map(() => "Play is out of sight")]
}"""
"""On a phone held sideways the plot is next to the picture, and Play is visible."""


def of(page: Page, *scripts: str, given: object = None) -> list[str]:
    """The faults that scripts report."""
    return [fault for script in scripts for fault in cast(list[str], page.evaluate(script, given))]


LAID = "oscillations.walks.walk.card?.page === oscillations.page"
TAUGHT = (
    "oscillations.walks.walk.lesson && "
    "oscillations.shown.state.covered.length === oscillations.walks.walk.step.reveals.covered.length"
)
"""A step is laid out and its answer is visible."""
SCROLLED = """() => [...document.querySelectorAll("body *")].filter(part => {
  if (part instanceof SVGElement || part.closest(".figure, .in-force, .heard") || !part.checkVisibility()) return false
  const {overflowX, overflowY} = getComputedStyle(part)
  const [wide, high] = [part.scrollWidth - part.clientWidth, part.scrollHeight - part.clientHeight]
  return (overflowY !== "visible" && high > 1) || (overflowX !== "visible" && wide > 1)
}).map(part => `${part.tagName} ${part.className}: ${part.scrollWidth - part.clientWidth} px to the side, ` +
  `${part.scrollHeight - part.clientHeight} px down`)"""
"""Parts whose content is larger than their box."""
LARGE = (
    *("h1.waits", "h1:not(.waits)", ".asked-line", ".answers .name", ".card .why", ".act"),
    *(".corner-words b", ".vote-count", ".votes .all", ".scale text", ".stage text", ".block .head"),
)
"""Parts that everybody reads: question, answers, explanation, drawings; the code of a class, and its answers."""
SMALL = """([least, kinds]) => {
  const size = part => parseFloat(getComputedStyle(part).fontSize) * (part.getScreenCTM?.().a ?? 1)
  return kinds.flatMap(kind => [...document.querySelectorAll(kind)]
    .filter(part => part.checkVisibility() && size(part) < least - 0.01)
    .map(part => `${kind} is small: ${part.textContent}`))
}"""
LOW = """least => [...document.querySelectorAll(".plot-area")]
  .map(area => [area.checkVisibility() ? area.getBoundingClientRect().height : least, area])
  .filter(([height]) => height < least)
  .map(([height, area]) => `a plot is ${height.toFixed()} px high: ${area.parentElement.textContent.slice(0, 20)}`)"""
"""Plots that are lower than this many pixels, and therefore unreadable."""


def in_hall(page: Page, height: int, when: str) -> Iterator[str]:
    """The faults of a page in a hall whose window has this height."""
    passed(page)
    seek(page, 0.0)
    small = [22 * height / 1080, 19 * height / 1080]
    found = [*faults(page, *small), *page.evaluate(SCROLLED), *page.evaluate(SMALL, [27 * height / 1080, LARGE])]
    found += page.evaluate(LOW, height / 30)
    # Words at the mark that the student has set may overlap others.
    yield from (f"{when} Show: {fault}" for fault in found if "under pill-mark" not in fault)
