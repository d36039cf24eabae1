// Types that the scripts share, and names that they find in the page.

/** BokehJS and its models, which are typed by none of its files. */
type BokehModel = any
declare const Bokeh: BokehModel

declare var oscillations: any

/** A page of ours in a frame. */
interface Window {
  oscillations?: any
}

/** Columns of numbers by source and name. */
type Columns = Record<string, Record<string, Float64Array>>

/** A view whose columns have come out of the array that was sent with it, and the page around it. */
type Drawn = Omit<page.Shown, "view" | "held"> & {
  view: Omit<page.PagePicture, "columns"> & {columns: Columns}
  held: Kept | null
}

/** The picture held, whose columns have come out as those of a view. */
type Kept = Omit<page.Held, "columns"> & {columns: Columns}

/** Values that have been set and wait for the server, by parameter. */
type Waits = Map<string, page.Value>

/** Numbers by name: signals at an instant, scalars, places of plots. */
type Named = Record<string, number>

/** A shape whose numbers are those of an instant. */
type AtInstant<Shape = page.AnyShape> = {[Key in keyof Shape]: page.Number extends Shape[Key] ? number : Shape[Key]}

/** A kind of shape: its elements are made once and moved at every frame; what a hand takes has a place and a size. */
interface Kind<Shape = page.AnyShape> {
  make(shape: Shape): SVGElement[]
  move(parts: SVGElement[], shape: AtInstant<Shape>, all: Named): void
  hold?(shape: AtInstant<Shape>): [x: number, y: number, size: number]
}

/** A value in a file of TOML. */
type Toml = string | number | boolean | Toml[] | {[name: string]: Toml}

/** Takes a message to the server. */
type Send = (message: page.BrowserMessage) => void

/** A rectangle in pixels. */
interface Frame {
  left: number
  top: number
  width: number
  height: number
}

interface Point {
  x: number
  y: number
}

interface Span {
  start: number
  end: number
}

/** A message as it comes: packed with the preset dictionary of a sheet, whose address is "" where there is none. */
interface Packet {
  sheet: string
  data: ArrayBuffer
}

/** A message of the server, unpacked. */
type ServerMessage = Drawn | page.Kept | page.File | page.AboutNumbers | page.Taught | page.Walking | page.Fitted
