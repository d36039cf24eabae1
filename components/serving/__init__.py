"""The server: start, settings, routes, sockets, files, and the page around a scene."""
