"""The live class: rooms that an instructor opens and a class follows, in memory or in a store that is shared."""
