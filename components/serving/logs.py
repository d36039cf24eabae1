"""The log of a server: one line per request, as text or JSON.

Unless LOG_VISITORS is set, no line has an address or a query; each traceback is logged once.
"""

from __future__ import annotations

import json
import logging
from datetime import UTC, datetime

from components.quantities.refusals import Once
from components.serving.handlers import LectureHandler

log = logging.getLogger(__name__)


class JsonLines(logging.Formatter):
    """A log format: each record as a JSON object in one line."""

    def format(self, record: logging.LogRecord) -> str:
        facts: dict[str, object] = {
            "time": datetime.fromtimestamp(record.created, UTC).isoformat(timespec="milliseconds"),
            "level": record.levelname,
            "logger": record.name,
            "message": record.getMessage(),
            **getattr(record, "facts", {}),
        }
        if record.exc_info:
            facts["traceback"] = self.formatException(record.exc_info)
        return json.dumps(facts, ensure_ascii=False)


def log_request(handler: LectureHandler) -> None:
    """Replace Tornado's log line, which contains address and query."""
    status, request, visitors = handler.get_status(), handler.request, handler.context.settings.log_visitors
    level = logging.WARNING if status >= 400 else handler.log_level
    facts = {"status": status, "method": request.method, "path": request.uri if visitors else request.path}
    facts |= {"ms": round(1000 * request.request_time(), 1)} | ({"address": handler.visitor} if visitors else {})
    log.log(level, " ".join(map(str, facts.values())), extra={"facts": facts})


def set_up(form: str, visitors: bool) -> None:
    """Send the log to standard error, as `form`: text or json."""
    line = JsonLines() if form == "json" else logging.Formatter("%(levelname)s %(asctime)s %(message)s")
    handler = logging.StreamHandler()
    handler.setFormatter(line)
    logging.basicConfig(level=logging.INFO, handlers=[handler])
    # Log warnings, because NumPy's would otherwise go to stderr, again after each change of the filters.
    logging.captureWarnings(True)
    logging.getLogger("py.warnings").addFilter(Once())
    # These libraries log every session and socket, and Tornado's warnings contain addresses.
    quiet = {"bokeh": logging.WARNING, "panel": logging.WARNING, "tornado.general": logging.ERROR}
    for name, level in quiet.items():
        logging.getLogger(name).setLevel(logging.INFO if visitors else level)
