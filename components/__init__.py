"""What a visitor sees and touches: parameters, controls, plots, stage, links."""
