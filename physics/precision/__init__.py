"""Numbers with more than double precision, and functions of them."""
