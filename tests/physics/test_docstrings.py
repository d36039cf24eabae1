"""The public names of physics are documented: parameters and fields with units and shapes, results, errors, source."""

from tools.docstrings import gaps


def test_every_public_name_of_physics_is_documented() -> None:
    assert list(gaps()) == []
