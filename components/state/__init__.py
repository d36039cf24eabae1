"""What a page stands for, one value: how a message changes it, what is covered and held, what of it is told."""
