"""The Panel face: a scene as Panel widgets and live Bokeh figures, for notebooks and `panel serve`."""
