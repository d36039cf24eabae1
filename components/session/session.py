"""The session of one visitor: it has the state of the page and answers its messages.

It knows neither Panel nor sockets.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Mapping
from concurrent.futures import Future
from typing import Protocol

from msgspec.structs import replace

from components.language.messages import (
    AskAbout,
    AskCsv,
    BrowserMessage,
    CancelFit,
    Fitted,
    GiveAnswer,
    Given,
    Kept,
    Lead,
    RunOrder,
    RunWalk,
    SendRows,
    SetValues,
    Shown,
    Taught,
    Walking,
)
from components.layout.controls import preset_name, settings
from components.quantities.formatting import excerpt
from components.quantities.refusals import SORRY, report
from components.scene import Scene
from components.scene.about import no_numbers
from components.scene.running import Later, Running
from components.session.exports import AboutExport, PageExport
from components.session.measured import Fitting, MeasuredRows
from components.session.worker import Here, Reading, Replied, Teaching, Worker, WorkerJob
from components.state.commands import Errors, RefusalError
from components.state.comparison import compared_message
from components.state.encoding import view_of
from components.state.page_state import PageState, changed, with_values
from components.state.scene_sheet import preset_dictionary, sheet_address
from components.state.sent_picture import drawn_on, sent_picture
from components.state.wire import Packet, decoded, packed
from components.walks import Walks
from components.walks.judging import taught
from components.walks.walk import Step

MOST_MESSAGES = 2**53
"""Message numbers are below this limit, up to which JavaScript's integers are exact."""

MOST_OWN = 5
TOO_MANY = (
    f"A page keeps at most {MOST_OWN} walks from files. Give this one the name of a walk that it may replace, "
    "or open another tab."
)
ONE_AT_A_TIME = "The server is still working on the last request of this page. Try again in a moment."
AT_ONCE = Replied(refused=ONE_AT_A_TIME, is_busy=True)

Send = Callable[[Packet], None]


class Publish(Protocol):
    """A function that sends pictures to a class. It gets a function that encodes the picture, called only if needed."""

    def __call__(self, make: Callable[[], Packet], /) -> None: ...

    def end(self) -> None: ...


class Session:
    """One visitor's session. A message changes only the attribute `now`: a new immutable state replaces the old one.

    `send` gets the packed messages for the browser; `scenes` are the available scenes; `later` runs a function under
    the page's lock, for calls from another thread.
    """

    def __init__(
        self,
        now: PageState,
        problems: tuple[str, ...] = (),
        *,
        scenes: Mapping[str, type[Scene]] | None = None,
        walks: Walks | None = None,
    ) -> None:
        self.scenes = scenes or {}
        self.walks: Walks = walks or {}
        self.worker: Worker | None = None
        """The worker process for long jobs. Without one, the session does them itself."""
        self._job: tuple[int | None, Future[Replied]] | None = None
        """The worker's future answer, by the number of the request."""
        self._rows = MeasuredRows()
        self._fit: Future[Replied] | None = None
        """The last job, if it was a fit."""
        self.send: Send = lambda packet: None
        self.first: Packet | None = None
        """The first picture, computed when the link was checked."""
        self._errors: Errors = {}
        """The reasons of the last refusal."""
        self._problems = problems
        self.later: Later = lambda act: act()
        self.network = ""
        """The visitor's network, if known: each network may have one waiting measurement and one walk."""
        self.lead: Callable[[str, str], Publish | None] = lambda code, key: None
        self._publish: Publish | None = None
        self.running = self._work_for(now)
        self.now = with_news(dataclasses.replace(now, in_view=True), self.running)

    def close(self) -> None:
        """Forget the visitor, who has left."""
        if self._job:
            self._job[1].cancel()
        if self.running:
            self.running.close()
        self._end_publishing()

    def _end_publishing(self) -> None:
        if self._publish:
            self._publish.end()

    def opening(self) -> Packet:
        """Return the first page, with the rejected parts of its link."""
        return self._packed(self.now, problems=self._problems)

    def handle(self, data: object) -> None:
        """Handle a message and always answer, because the browser waits. The message may be malformed; its number is
        returned only if it is a number."""
        number = data.get("number") if isinstance(data, dict) else None
        answer = number if isinstance(number, int) and 0 <= number < MOST_MESSAGES else None
        before = self.now
        try:
            reply = self._reply(self._decoded(data), answer)
        except RefusalError as refused:
            self._errors = refused.errors
            reply = self._packed(before, answer)
        except Exception as error:
            report(error)
            self._errors = {}
            reply = self._packed(before, answer, (SORRY,))
        if reply:
            self.send(reply)
        if self.running or not self.now.sends_the_same_as(before):
            self._send_to_class()

    def _decoded(self, data: object) -> BrowserMessage:
        try:
            return decoded(data)
        except ValueError as error:
            raise RefusalError({"message": excerpt(str(error), 200)}) from error

    def _reply(self, message: BrowserMessage, answer: int | None) -> Packet | None:
        """Return the answer to a message, or None if it comes later. A repeated message is only answered again, because
        its first answer was lost."""
        match message:
            case AskCsv(page=page):
                return self._ask_worker(PageExport(self.now.state, page, answer), answer)
            case AskAbout():
                return self._ask_worker(AboutExport(self.now.state, answer), answer)
            case GiveAnswer(answer=given) if step := self._own_step(given):
                return self._ask_worker(Teaching(given, step), answer)
            case GiveAnswer(answer=given):
                return packed(replace(taught(given, self.walks, self.scenes), answer=answer))
            case RunWalk():
                return self._ask_worker(Reading(message.name, message.text), answer)
            case SendRows():
                return self._take_rows(message, answer)
            case CancelFit():
                self._cancel_fit()
                return packed(Fitted(answer=answer))
            case Lead(code=code, key=key):
                self._end_publishing()
                self._publish = self.lead(code, key) if code else None
                self._send_to_class()
                return self._packed(self.now, answer)
        if answer is not None and answer == self.now.number:
            return self._packed(self.now, answer)
        after = (
            self._ordered(message.order) if isinstance(message, RunOrder) else changed(self.now, message, self.scenes)
        )
        after = dataclasses.replace(after, number=answer)
        if self._is_kept(message, after):
            self.now = after
            return packed(Kept(answer=answer))
        return self._set_state(after, answer)

    def _take_rows(self, message: SendRows, answer: int | None) -> Packet | None:
        """Take a piece of a measured record, and give the complete record to the worker."""
        if self._job and self._job[0] == answer and self._fit and not self._fit.done():
            return None  # the last piece is repeated while its rows are fitted
        if message.piece == 0:
            self._cancel_fit()
        try:
            job = self._rows.take(message)
        except ValueError as reason:
            return packed(Fitted(answer=answer, refused=str(reason)))
        return self._ask_worker(job, answer) if job else packed(Fitted(answer=answer, piece=self._rows.next))

    def _cancel_fit(self) -> None:
        """Cancel the fit of an earlier record if it still waits for its turn."""
        if self._fit:
            self._fit.cancel()
        self._fit = None

    def _is_kept(self, message: BrowserMessage, after: PageState) -> bool:
        """Return True if a drag has ended and the page does not change; then its picture is not sent again."""
        lets_go = isinstance(message, SetValues) and message.holding is False and not message.values
        return lets_go and not self._errors and not self.running and after.sends_the_same_as(self.now)

    def _ordered(self, order: str) -> PageState:
        if self.running is None:
            raise RefusalError({"run": f"“{excerpt(order)}” is not possible: there is nothing to run here."})
        try:
            self.running.obey(order, self.now.scene)
        except ValueError as error:
            raise RefusalError({"run": str(error)}) from error
        return self.now

    def _set_state(self, after: PageState, answer: int | None) -> Packet:
        """Set the new state of the page, after it has been encoded."""
        running = self.running if after.kind is self.now.kind else self._work_for(after)
        after = with_news(after, running)
        reply = self._packed(after, answer, errors={}, running=running)
        if self.running and running is not self.running:
            self.running.close()
        self.now, self.running, self._errors = after, running, {}
        return reply

    def _work_for(self, now: PageState) -> Running | None:
        """Return the background work of a scene, if it has some."""
        if now.kind.work is None:
            return None
        running = now.kind.work(lambda: self.network)
        running.notify = lambda: self.later(lambda: self._send_results(running))
        return running

    def _send_results(self, running: Running) -> None:
        """Send the results of background work at once, unless the visitor has left the scene."""
        if running is self.running:
            self.now = with_news(self.now, running)
            self.send(self._packed(self.now))
            self._send_to_class()

    def _own_step(self, given: Given) -> Step | None:
        """Return the answered step, if it is in a walk from the visitor's own files."""
        steps = self.now.own[given.walk].steps if given.walk in self.now.own else ()
        return next((step for step in steps if step.id == given.step), None)

    def _ask_worker(self, asked: WorkerJob, answer: int | None) -> Packet | None:
        """Give the worker a job, one at a time, and send its result later."""
        if self._job and not self._job[1].done():
            return None if self._job[0] == answer else self._worker_packet(asked, AT_ONCE, answer)
        worker = self.worker
        if worker is None:
            worker = Here(self.walks, {self.now.scene.slug: self.now.kind, **self.scenes})
        future = worker.ask(asked, self.network)
        self._job = answer, future
        self._fit = future if isinstance(asked, Fitting) else None

        def send_reply(done: Future[Replied]) -> None:
            if not done.cancelled():
                self.later(lambda: self.send(self._worker_packet(asked, done.result(), answer)))

        future.add_done_callback(send_reply)
        return None

    def _worker_packet(self, asked: WorkerJob, replied: Replied, answer: int | None) -> Packet:
        if replied.packet:
            return replied.packet
        match asked:
            case Teaching(given=given):
                nothing = Taught(
                    walk=given.walk, step=given.step, lesson=None, refused=replied.refused, is_busy=replied.is_busy
                )
                return packed(replace(replied.taught or nothing, answer=answer))
            case AboutExport():
                return packed(no_numbers(replied.refused, answer))
            case Fitting():
                nothing_fitted = Fitted(refused=replied.refused, is_busy=replied.is_busy)
                return packed(replace(replied.fitted or nothing_fitted, answer=answer))
            case Reading():
                return self._walk_packet(replied, answer)
        self._errors = {"message": replied.refused}
        return self._packed(self.now, answer)

    def _walk_packet(self, replied: Replied, answer: int | None) -> Packet:
        if replied.walk:
            own = {**self.now.own, replied.walk.name: replied.walk}
            if len(own) > MOST_OWN:
                return packed(Walking(answer=answer, sheet=None, refused=TOO_MANY))
            self.now = dataclasses.replace(self.now, own=own)
        return packed(Walking(answer=answer, sheet=replied.sheet, refused=replied.refused, is_busy=replied.is_busy))

    def _send_to_class(self) -> None:
        """Send the page's picture to the followers, with no error messages."""
        if self._publish:
            self._publish(lambda: self._packed(self.now, errors={}))

    def _packed(
        self,
        now: PageState,
        answer: int | None = None,
        problems: tuple[str, ...] = (),
        *,
        errors: Errors | None = None,
        running: Running | None = None,
    ) -> Packet:
        """Return everything that the browser needs to show the current state."""
        shown, left_out = now.to_send
        view, numbers = view_of(sent_picture(now, shown), drawn_on(now), left_out)
        held, more = compared_message(now, shown)
        scene, work = now.scene, running or self.running
        reply = Shown(
            answer=answer,
            scene=scene.slug,
            sheet=sheet_address(now.kind),
            view=view,
            held=held,
            settings=settings(now.kind.param.objects("existing"), scene.values, scene.units(), now.asked.shown.spans),
            state=now.state,
            preset=preset_name(label) if (label := scene.preset()) else None,
            here=tuple(now.asked.scene.here()),
            errors=self._errors if errors is None else errors,
            problems=problems,
            query=now.query,
            progress=work.progress(scene) if work and now.kind.work else None,
        )
        return packed(reply, [*numbers, *more], sheet=reply.sheet, preset_dictionary=preset_dictionary(now.kind))


def with_news(now: PageState, running: Running | None) -> PageState:
    """Return the page state, with all results of background work."""
    return with_values(now, running.news(now.scene)) if running else now
