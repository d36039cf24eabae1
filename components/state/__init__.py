"""The state of a page as one immutable value: changes by messages, hidden parts, the compared picture, encoding."""
