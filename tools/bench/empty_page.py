"""The least that Panel can serve: what a session costs before there is an app in it."""

import panel as pn

pn.pane.HTML("").servable()
