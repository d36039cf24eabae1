"""Numerical methods, their stability, and the race between them."""
