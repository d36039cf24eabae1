"""The page of a walk's file has only words and MathML, whatever the file contains; its formulas may end in pieces."""

from __future__ import annotations

from html.parser import HTMLParser

import pytest
from hypothesis import given
from hypothesis import strategies as st

from components.layout.markup import CLASSES, LENGTHS, MATH, NAMES
from components.layout.text import mathml, rich
from components.scenes import SCENES
from components.walks.cards import walk_sheet
from components.walks.checking import problems
from components.walks.loading import load_walks, read_walk, steps_of
from components.walks.texts import line, pieces
from components.walks.walk import Step

KNOWN = steps_of(load_walks(()).values())
REFRESH = r"\text{<meta http-equiv=refresh content='0;//a.example'>}"
LINKED = r"\href{https://a.example}{x}"
PIECES = (
    *("$", "$$", "*", "**", "_", "{x}", "[m1|", "[notice|", "[scene:modes|", "]", "%", "?", ". Is it", ": ", " ", "a"),
    *(REFRESH, LINKED, r"\class{notice}{x}", r"\style{position:fixed}{x}", r"\text{", "}", "{", r"\frac", r"\quad "),
    *("<!--", "-->", "<![CDATA[", "]]>", "<?a", "&lt;", "&", "'", '"', "="),
    *(r"\val{x}", r"\tint{k}", r"\hspace{-900em}"),
)
texts = st.lists(st.sampled_from(PIECES), min_size=1, max_size=9).map("".join)


class Found(HTMLParser):
    """A second parser, independent of the checking one, that reads a text as a browser does."""

    def __init__(self, html: str) -> None:
        super().__init__()
        self.strange: list[str] = []
        self.feed(html)
        self.close()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        if tag not in MATH | {"b", "sub", "span", "a"}:
            self.strange.append(tag)
        for name, value in attrs:
            known = name in NAMES | LENGTHS | {"class"} or (name, tag) in {("href", "a"), ("xmlns", "math")}
            if not known or (name == "href" and not str(value).startswith("?scene=")):
                self.strange.append(f"{name}={value}")
            if name == "class" and not CLASSES.issuperset(str(value).split()):
                self.strange.append(f"class {value}")

    def handle_comment(self, data: str) -> None:
        self.strange.append(data)

    handle_decl = handle_pi = unknown_decl = handle_comment


@given(texts, texts)
def test_whatever_is_written_becomes_words_and_formulas(one: str, two: str) -> None:
    for make, text in ((rich, one + two), (line, one), (rich, f"Let ${one}$ be. Is ${two}$ so?")):
        try:
            html = make(text)
        except ValueError:
            continue
        assert Found(html).strange == []


@pytest.mark.parametrize(
    ("field", "text"),
    [
        ("explain", f"A *$* sign, {REFRESH}$ and $ again."),
        ("question", f"Given $a. Is {REFRESH}$ so?"),
        ("follows", rf"a = b % \quad c = d \quad {REFRESH}"),
        ("explain", f"${LINKED}$"),
        ("explain", r"$\hspace{-900em} x$"),
    ],
)
def test_what_is_set_is_checked_not_its_source(field: str, text: str) -> None:
    step = f'title = "t"\n[[step]]\nid = "one"\nfrom = "d31-03"\n{field} = """{text}"""\n'.replace("\\", "\\\\")
    walk = read_walk(step, "mine", KNOWN)
    told = list(problems(walk, SCENES))
    if told:
        assert told[0].startswith(f"mine, step 1 (one), {field}") and "“" in told[0]
        return
    (card,) = walk_sheet(walk, SCENES).steps
    assert Found(card.given + card.question).strange == []
    assert all(not Found(line(latex)).strange for latex in walk.steps[0].equations)


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        (r"F = -k x, \quad k > 0", [r"F = -k x, \quad ", "k > 0"]),
        (r"a = b \;\Rightarrow\; c = d = e", [r"a = b \;", r"\Rightarrow\; c = d ", "= e"]),
        (r"x = 0 \text{ at } t = 0", ["x = 0 ", r"\text{ at } t = 0"]),
        (r"(a = b = c) = \frac{a = b}{c}", [r"(a = b = c) = \frac{a = b}{c}"]),
        (r"\left\{a = b = c\right. \quad d", [r"\left\{a = b = c\right. \quad d"]),
        (r"\begin{matrix} a = b = c & d \end{matrix} = e", [r"\begin{matrix} a = b = c & d \end{matrix} = e"]),
        (r"a = b = c \over d", [r"a = b = c \over d"]),
    ],
)
def test_a_line_ends_between_its_pieces(latex: str, expected: list[str]) -> None:
    assert pieces(latex) == expected


@pytest.mark.parametrize("step", [step for step in KNOWN.values() if step.equations], ids=lambda step: step.id)
def test_the_pieces_are_formulas_that_make_the_whole(step: Step) -> None:
    for latex in step.equations:
        assert "".join(pieces(latex)) == latex
        for piece in pieces(latex):
            mathml(piece)
        assert line(latex).count("<math") == len(pieces(latex))
