"""The only Panel component of a page. It carries the session's messages, one in each direction per change."""

from __future__ import annotations

from functools import partial
from typing import Any, ClassVar

from bokeh.document import Document
from bokeh.document.events import MessageSentEvent
from bokeh.events import ModelEvent
from bokeh.model import Model
from panel.widgets.base import Widget

from components.session.session import Session
from components.state.wire import Packet, in_one

FROM_SERVER = "from_server"
"""Bokeh's event type for messages of the server."""


class Wire(Model):  # type: ignore[misc]  # Bokeh's are not looked into
    """The Bokeh model through which browser and server exchange messages. Its other half is static/net/wire.js."""


class SaidEvent(ModelEvent):  # type: ignore[misc]  # Bokeh's are not looked into
    """A message of the browser, as JSON."""

    event_name = "from_browser"

    def __init__(self, model: Wire | None, data: object = None) -> None:
        super().__init__(model=model)
        self.data = data

    def event_values(self) -> dict[str, Any]:
        return {**super().event_values(), "data": self.data}


class SceneView(Widget):
    """A session as a Panel widget. The page contains the first picture; later ones are sent as messages."""

    _widget_type: ClassVar[type[Model]] = Wire
    _linked_properties = ()  # the browser sends messages and sets no properties

    def __init__(self, session: Session, **params: Any) -> None:
        self.session = session
        super().__init__(**params)

    def _get_properties(self, doc: Document | None) -> dict[str, Any]:  # declared by Panel
        """Removes Panel's properties, because the wire has no size and no style."""
        return {}

    def _get_model(self, doc: Document, root: Any = None, parent: Any = None, comm: Any = None) -> Model:
        model = super()._get_model(doc, root, parent, comm)
        # Bypass Panel's counting of events for its busy indicator, which takes a fifth of the cost of a change.
        model.on_event(SaidEvent.event_name, lambda event: self.session.handle(event.data))
        self.session.send = partial(self._tell, doc)
        return model

    def _tell(self, doc: Document, packet: Packet) -> None:
        """Send a message through Bokeh's queue. Panel's own method skips the queue and fails if the visitor is just
        leaving. The message is one of the document, not an event of the model, because its envelope is half as long.
        """
        doc.callbacks.trigger_on_change(MessageSentEvent(doc, FROM_SERVER, in_one(packet)))
