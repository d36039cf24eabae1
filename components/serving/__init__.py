"""The server between the network and the page: start, settings, routes, sockets, files, the shell around a scene."""
