// The connection over Bokeh's WebSocket. A model in Bokeh's document carries the messages as events.

import {bokeh} from "./bokeh.js"

/** @typedef {{send: (message: page.BrowserMessage) => void, close: () => void}} Wire */

const LINE_FEED = 10
const FROM_SERVER = "from_server" // event type of messages from the server

/** @type {boolean} true once the model is registered with Bokeh */
let defined = false

/** The browser half of components/session/panel_bridge.py. */
function define() {
  if (defined) return
  defined = true
  const {ModelEvent} = Bokeh.require("core/bokeh_events")
  class FromBrowser extends ModelEvent {
    event_name = "from_browser"

    get event_values() {
      return {model: this.origin, data: this.data}
    }
  }
  class Wire extends Bokeh.require("model").Model {
    static __name__ = "Wire"
    static __module__ = "components.session.panel_bridge"

    /** @param {page.BrowserMessage} message */
    send(message) {
      this.document.event_manager.send_event(Object.assign(new FromBrowser(), {origin: this, data: message}))
    }
  }
  Bokeh.require("base").default_resolver.register(Wire)
}

/**
 * Opens a connection to the session of a token. `receive` gets its messages; `lost` is called when it breaks.
 * @param {string} token @param {(packet: Packet) => void} receive @param {() => void} lost @returns {Promise<Wire>}
 */
export async function connect(token, receive, lost) {
  await bokeh()
  define()
  const address = new URL("ws", document.baseURI)
  address.protocol = address.protocol.replace("http", "ws")
  const session = await Bokeh.require("client/connection").pull_session(address.href, token, null)
  const {document: shared} = session
  const [wire] = shared.roots()
  const forward = (/** @type {ArrayBuffer} */ message) => receive(packetIn(message))
  shared.on_message(FROM_SERVER, forward)
  shared.on_event("connection_lost", lost)
  shared.notify_idle(wire) // Panel sends nothing before it has received this event
  return {send: message => wire.send(message), close: () => close(session, forward)}
}

/** The parts of a message: components/state/wire.py. @param {ArrayBuffer} message @returns {Packet} */
function packetIn(message) {
  const bytes = new Uint8Array(message)
  const end = bytes.indexOf(LINE_FEED)
  return {sheet: new TextDecoder().decode(bytes.subarray(0, end)), data: message.slice(end + 1)}
}

/**
 * Closes a session, and removes it from Bokeh's list of all documents, which would keep it in memory.
 * @param {BokehModel} session @param {(message: ArrayBuffer) => void} forward
 */
function close(session, forward) {
  session.document.remove_on_message(FROM_SERVER, forward)
  session.close()
  const index = Bokeh.documents.indexOf(session.document)
  if (index >= 0) Bokeh.documents.splice(index, 1)
}
