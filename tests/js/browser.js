// Parts of a browser (document, network, clock) for tests of scripts in Node.

import {mock} from "node:test"

class FakeElement extends EventTarget {
  children = []
  classList = {add() {}, contains: () => false, remove() {}}
  dataset = {}
  style = {}

  append = (...children) => void this.children.push(...children)
  prepend = (...children) => void this.children.unshift(...children)
  getAttribute = name => this[name]
  setAttribute = (name, value) => void (this[name] = value)
  getBoundingClientRect = () => ({left: 0, right: 640, top: 0, bottom: 240})
  getContext = () => ({})
  click() {}
  closest() {}
  focus() {}
  setPointerCapture() {}
  remove() {}
}

const page = new EventTarget()
globalThis.addEventListener = page.addEventListener.bind(page)

/** Dispatch an event of the window. @param {string} name */
export const happens = name => page.dispatchEvent(new Event(name))

globalThis.document = Object.assign(new EventTarget(), {
  baseURI: "http://lecture.example/",
  body: new FakeElement(),
  documentElement: new FakeElement(),
  hidden: false,
  createElement: () => new FakeElement(),
  createElementNS: () => new FakeElement(),
  elementsFromPoint: () => [],
})
document.documentElement.dataset.version = "1"
globalThis.getComputedStyle = () => ({fontSize: "16px", getPropertyValue: () => ""})
globalThis.matchMedia = () => ({matches: false})
globalThis.requestAnimationFrame = () => {}
globalThis.ResizeObserver = class {
  observe() {}
}
globalThis.SVGTextElement = class {}

/** Install a clock that the test advances from 0; Math.random always returns 0.5. */
export function clock() {
  mock.timers.enable({apis: ["setTimeout", "setInterval", "Date"], now: 0})
  mock.method(Math, "random", () => 0.5)
  mock.method(AbortSignal, "timeout", ms => {
    const control = new AbortController()
    setTimeout(() => control.abort(new DOMException("The operation timed out.", "TimeoutError")), ms)
    return control.signal
  })
}

/** Let time pass and run everything that is due, to the next `step`. @param {number} ms @param {number} [step] */
export async function pass(ms, step = 5) {
  const end = Date.now() + ms
  await settled()
  while (Date.now() < end) {
    mock.timers.tick(Math.min(step, end - Date.now()))
    await settled()
  }
}

async function settled() {
  for (let i = 0; i < 3; i++) await new Promise(done => setImmediate(done))
}

/** The server of a class: records requests and returns the answers that the test sets. */
export class FakeServer {
  asked = []

  /** The answer to a path, or nothing. @type {(path: string) => Response | undefined | void} */
  answers = () => {}

  constructor() {
    globalThis.fetch = (address, how) =>
      new Promise((done, failed) => {
        const {signal} = how
        const path = String(address).replace("http://lecture.example/class/", "")
        this.asked.push({path, at: Date.now(), signal})
        if (signal.aborted) failed(signal.reason)
        signal.addEventListener("abort", () => failed(signal.reason))
        const answer = this.answers(path, signal, how) // an exception rejects
        if (answer) done(answer)
      })
  }

  /** The times at which a path was requested. @param {string} part */
  times(part) {
    return this.asked.filter(({path}) => path.includes(part)).map(({at}) => at)
  }
}

/** A stream of server events that the test writes to. @param {AbortSignal} signal */
export function events(signal) {
  let control
  const body = new ReadableStream({start: one => void (control = one)})
  signal.addEventListener("abort", () => control.error(signal.reason))
  const answer = new Response(body, {headers: {"Lecture-Version": "1"}})
  const say = news => control.enqueue(new TextEncoder().encode(`data: ${JSON.stringify(news)}\n\n`))
  return {answer, say, end: () => control.close()}
}

/** A server's refusal with a sentence. @param {number} status @param {string} sentence */
export const refusing = (status, sentence) => () => Response.json({sentence}, {status})

/** Numbers from 0 to 1, the same in each run. */
export function numbers(seed = 1) {
  let state = (seed * 1_299_709) % 2147483647
  return () => (state = (state * 16807) % 2147483647) / 2147483647
}

/** A browser's storage, whose names are its own keys. */
export function storage(setItem) {
  const kept = Object.create({
    getItem: name => kept[name] ?? null,
    setItem: setItem ?? ((name, text) => void (kept[name] = String(text))),
    removeItem: name => delete kept[name],
  })
  return kept
}
