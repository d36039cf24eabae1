"""The kinds of question, each a class: what a walk's file has of it, and how it is checked, asked, judged, counted and
written down. components/walks/walk.py has them all."""
