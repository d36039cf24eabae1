"""Papers of scenes, written with deferred expressions of a case: what a picture shows, before there is a case."""
