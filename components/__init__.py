"""The app behind the page: scenes and their parts, walks, a visitor's session, the server, the live class."""
