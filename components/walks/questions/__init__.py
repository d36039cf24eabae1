"""The kinds of question, each a class: the fields in a walk's file, the check, the card, the judgement, the counting,
and the text of an answer. components/walks/walk.py lists them all.
"""
