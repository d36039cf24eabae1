"""The one Panel component of a page: it carries the session's messages, one each way for every change."""

from __future__ import annotations

from functools import partial
from typing import Any, ClassVar

from bokeh.document import Document
from bokeh.events import ModelEvent
from bokeh.model import Model
from panel.widgets.base import Widget

from components.session.session import Session
from components.state.wire import Packet


class Wire(Model):  # type: ignore[misc]  # Bokeh's are not looked into
    """The Bokeh model through which browser and server exchange messages. Its other half is static/net/wire.js."""


class SaidEvent(ModelEvent):  # type: ignore[misc]  # Bokeh's are not looked into
    """A message of the browser, as JSON has it."""

    event_name = "said"

    def __init__(self, model: Wire | None, data: object = None) -> None:
        super().__init__(model=model)
        self.data = data

    def event_values(self) -> dict[str, Any]:
        return {**super().event_values(), "data": self.data}


class ToldEvent(ModelEvent):  # type: ignore[misc]
    """A message of the server, packed."""

    event_name = "told"

    def __init__(self, model: Wire, packet: Packet) -> None:
        super().__init__(model=model)
        self.packet = packet

    def event_values(self) -> dict[str, Any]:
        return {**super().event_values(), **self.packet}


class SceneView(Widget):
    """A session as a Panel widget. The page itself brings the first picture; what follows are messages."""

    _widget_type: ClassVar[type[Model]] = Wire
    _linked_properties = ()  # the browser sets no properties: what it has to say comes as messages

    def __init__(self, session: Session, **params: Any) -> None:
        self.session = session
        super().__init__(**params)

    def _get_properties(self, doc: Document | None) -> dict[str, Any]:  # as Panel declares it
        """None of Panel's: the wire has no size and no style."""
        return {}

    def _get_model(self, doc: Document, root: Any = None, parent: Any = None, comm: Any = None) -> Model:
        model = super()._get_model(doc, root, parent, comm)
        # Past Panel, which counts for its indicators how many events are at work: a fifth of what a change costs.
        model.on_event(SaidEvent.event_name, lambda event: self.session.hear(event.data))
        self.session.send = partial(self._tell, doc, model)
        return model

    def _tell(self, doc: Document, model: Model, packet: Packet) -> None:
        """By Bokeh's own way: Panel's goes past its queue, and loses sight of a write to who leaves meanwhile."""
        doc.callbacks.send_event(ToldEvent(model, packet))
