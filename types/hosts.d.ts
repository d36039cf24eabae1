// Hosts: the few members that a part knows of what it stands in, so that nothing needs the whole that is made of it.

/** A part of a page, or of a plot: it takes every picture, stands where there is room for it, and leaves at last. */
interface Part {
  update?(shown: Drawn, asked: import("../static/net/messages.js").Asked | null): void
  place?(): void
  leave?(): void
}

/** A page, for its parts. */
interface PartHost {
  readonly spec: page.SceneSheet
  readonly host: PageHost
  readonly shown: Drawn
  waiting: Waits
  readonly left: boolean
  readonly link: string
  readonly hidden: string[]
  readonly root: HTMLElement
  readonly paper: HTMLElement
  readonly panel: HTMLElement
  readonly heading: HTMLElement
  readonly clock: import("../static/core/clock.js").Clock
  readonly live: import("../static/scene/live.js").Live
  readonly hand: import("../static/controls/hand.js").Hand
  readonly compare: import("../static/compare/compare.js").Compare
  readonly controls: import("../static/controls/controls.js").Controls
  readonly sheet: import("../static/scene/sheet.js").Sheet
  readonly views: import("../static/scene/views.js").Views
  readonly plots: import("../static/scene/plots.js").Plot[]
  readonly stages: import("../static/scene/stage.js").Stage[]
  readonly transport: {readonly element: HTMLElement; readonly note: HTMLElement}
  send(message: page.BrowserMessage): void
  redraw(): void
  draw(at: number): void
  join(): Promise<void>
}

/** A plot, for its parts. A drawing of it is another. */
interface Canvas {
  readonly block: page.PlotBlock
  readonly over: SVGElement
  readonly controls: HTMLElement
  readonly host: HTMLElement
  readonly page: PartHost
  readonly view: Drawn["view"]
  readonly frame: Frame
  readonly x: page.Ruler
  readonly y: page.Ruler
  readonly hidden: Set<string>
  readonly ghost?: {name: SVGTextElement; end: number | null}
  readonly handles?: {cuts(tick: number, axis: "x" | "y"): boolean}
  px(value: number): number
  py(value: number): number
}

/** Measured points over a plot. */
interface PointsHost extends Part {
  readonly isSeen: boolean
  place(): void
  drawing(canvas: Canvas): SVGElement
}

/** A plot of the page, for its parts. */
interface PlotHost extends Canvas {
  readonly absent: boolean
  points?: PointsHost
  readonly shown: Drawn
  readonly down: boolean
  valueAt(event: PointerEvent, which?: "x" | "y"): number
  isInside(event: PointerEvent): boolean
  update(shown: Drawn): void
}

/** A host of pages: the lecture, or a follower of one, who sets nothing. */
interface PageHost {
  readonly hall: {readonly on: boolean; readonly ending: string}
  readonly messages: Pick<import("../static/net/messages.js").Messages, "send" | "last" | "rests"> &
    Partial<Pick<import("../static/net/messages.js").Messages, "request" | "abandon">>
  send(message: page.BrowserMessage): void
  take(sets: page.State["parameters"]): void
  open(state: Pick<page.State, "scene"> & Partial<page.State>): void
  change(to: (state: page.State) => Partial<page.State>): void
  fit(): void
}

/** A host of cards, which puts a step to somebody: a walk, or a phone that follows one. */
/** A press of the filled button: what it says, what it does, and whether it needs an answer. */
interface Press {
  words: string
  needsAnswer?: boolean
  act(always: boolean): void
}

interface WalkHost {
  readonly seed: string
  readonly sheet: {readonly steps: page.StepCard[]}
  readonly place: number
  readonly step: page.StepCard
  readonly where: string
  readonly isTour: boolean
  readonly answers: {of(step: string): unknown}
  readonly earlierAnswer: Pick<page.Given, "curves"> | null
  lesson: page.Lesson | null
  unfolded: boolean
  readonly press: Press
  show(always: boolean): void
  forward(): void
  back(): void
  next(): void
  again(): void
  open(): void
}

/** The lecture, for what stands around its pages. */
interface LectureHost extends PageHost {
  readonly page: import("../static/scene/page.js").Page
  readonly clock: import("../static/core/clock.js").Clock
  readonly messages: import("../static/net/messages.js").Messages
  readonly sheets: import("../static/net/sheets.js").Sheets
  readonly walks: import("../static/walks/walks.js").Walks
  readonly classes: import("../static/live_class/classes.js").Classes
  readonly hall: import("../static/shell/hall.js").Hall
  readonly kept: page.State
  open(state: Pick<page.State, "scene"> & Partial<page.State>, carried?: boolean): void
  readdress(): void
}
