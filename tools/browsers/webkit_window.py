"""A window of WebKitGTK of any size, for its WebDriver; MiniBrowser's window is at least 447 px wide.

Runs in the system's Python, which has the bindings that `python3-gi` and `gir1.2-webkit2-4.1` install.
"""

import gi

gi.require_version("Gtk", "3.0")
gi.require_version("WebKit2", "4.1")
from gi.repository import Gtk, WebKit2  # noqa: E402


def show(context: WebKit2.WebContext) -> WebKit2.WebView:
    """Return a view under the driver's control, in its own window."""
    view = WebKit2.WebView(web_context=context, is_controlled_by_automation=True)
    window = Gtk.Window()
    window.set_default_size(1280, 720)
    window.add(view)
    window.show_all()
    window.connect("destroy", Gtk.main_quit)
    return view


def main() -> None:
    # Scrollbars that take room, as with a mouse.
    Gtk.Settings.get_default().set_property("gtk-overlay-scrolling", False)
    context = WebKit2.WebContext.new_ephemeral()
    context.set_automation_allowed(True)
    context.connect(
        "automation-started",
        lambda _, session: session.connect("create-web-view", lambda *_: show(context)),
    )
    Gtk.main()


if __name__ == "__main__":
    main()
