"""Numbers carried beyond double precision, and what is computed with them."""
