"""The live class: rooms that an instructor opens and phones follow, in memory or in a shared store."""
