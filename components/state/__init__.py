"""All that a page stands for, one value: how a message changes it, what is covered, held and told of it."""
