"""Papers of scenes: functions that say what pictures show. They use placeholders, because they run before there are
values."""
