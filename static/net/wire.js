// The wire to the server: Bokeh's connection, with a model in its document whose events are the messages.

import {bokeh} from "./bokeh.js"

/** @typedef {{send: (message: page.Said) => void, close: () => void}} Wire */

/** @type {boolean} whether Bokeh knows the model */
let defined = false

/** The other half of components/session/panel_bridge.py. */
function define() {
  if (defined) return
  defined = true
  const {ModelEvent, server_event} = Bokeh.require("core/bokeh_events")
  class Said extends ModelEvent {
    event_name = "said"

    get event_values() {
      return {model: this.origin, data: this.data}
    }
  }
  class Told extends ModelEvent {
    /** @param {{model: BokehModel} & Packet} values */
    static from_values({model, ...packet}) {
      return Object.assign(new Told(), {origin: model, packet})
    }
  }
  server_event("told")(Told)
  class Wire extends Bokeh.require("model").Model {
    static __name__ = "Wire"
    static __module__ = "components.session.panel_bridge"

    /** @param {page.Said} message */
    send(message) {
      this.document.event_manager.send_event(Object.assign(new Said(), {origin: this, data: message}))
    }

    /** @param {unknown} event */
    _process_event(event) {
      if (event instanceof Told) this.receive(event.packet)
    }
  }
  Bokeh.require("base").default_resolver.register(Wire)
}

/**
 * A wire to the session that the token opens; `receive` takes what comes, `lost` is called when it breaks.
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
  wire.receive = receive
  shared.on_event("connection_lost", lost)
  shared.notify_idle(wire) // Panel tells nothing before it has heard of this
  return {send: message => wire.send(message), close: () => close(session, wire)}
}

/** Bokeh keeps every document in a list of its own. @param {BokehModel} session @param {BokehModel} wire */
function close(session, wire) {
  wire.receive = () => {}
  session.close()
  const index = Bokeh.documents.indexOf(session.document)
  if (index >= 0) Bokeh.documents.splice(index, 1)
}
