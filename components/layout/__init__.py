"""The arrangement of a scene: sheets, stages, plots, controls, texts."""
