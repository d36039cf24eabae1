"""One visitor's conversation with the server."""
