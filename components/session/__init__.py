"""The session of one visitor."""
