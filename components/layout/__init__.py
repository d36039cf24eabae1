"""What stands where: sheets, stages, plots, controls, texts."""
