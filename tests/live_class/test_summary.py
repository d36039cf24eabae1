"""The summary of a class, and moving the lead to another computer."""

from __future__ import annotations

import csv

from components.live_class import lead_routes
from tests.live_class.caller import Class, called
from tests.live_class.served import CHOICE, teaching

NUMBER = {"walk": "d31", "step": "d31-02"}


async def test_a_summary_has_each_question_its_votes_and_the_mistake_that_is_made_most() -> None:
    async with teaching() as (_, url):
        lesson = await Class.open(url)
        path = f"/class/{lesson.code}/summary"
        assert (await called(url, path, word=lesson.key)).json == []
        tokens = [await lesson.token() for _ in range(4)]
        for vote, options in ((1, (0, 2, 2, 1)), (2, (0, 0, 2, 2))):
            await lesson.order("put", **CHOICE, vote=vote)
            for token, option in zip(tokens, options, strict=True):
                assert (await lesson.vote(token, **CHOICE, vote=vote, option=option)).status == 204
        await lesson.order("put", **NUMBER)
        assert (await lesson.vote(tokens[0], **NUMBER, text="1e9")).status == 204
        stored = await called(url, f"/class/{lesson.code}/stored", word=lesson.key)
        assert stored.json == {"answers": 9, "questions": 2}
        assert (await called(url, f"/class/{lesson.code}/stored", word=tokens[0])).status == 404
        choice, number = (await called(url, path, word=lesson.key)).json
        assert (choice["walk"], choice["step"], choice["place"]) == ("d31", "d31-03", 3)
        assert [(one["answered"], one["right"]) for one in choice["votes"]] == [(4, 1), (4, 2)]
        assert choice["mistake"].startswith("Shorter: the spring pulls") and choice["mistaken"] == 2
        assert (number["place"], number["mistaken"]) == (2, 1) and number["mistake"].endswith(" s")
        assert (await called(url, path, word=tokens[0])).status == 404


POLL = """
title = "Votes"
[[step]]
id = "vote-1"
kind = "choice"
poll = true
fixed = true
title = "Vote 1"
state = "?scene=coupled&k2=3"
question = "What is your answer to the question just asked?"
options = [{ text = "A" }, { text = "B" }]
explain = "The question was asked aloud."
"""


STORED = {"answers": 1, "questions": 1}


async def test_a_poll_is_counted_and_nobody_is_right_or_wrong() -> None:
    async with teaching() as (_, url):
        lesson = await Class.open(url)
        poll = {"walk": "votes", "step": "vote-1"}
        assert (await lesson.order("walk", name="votes", text=POLL)).status == 204
        await lesson.order("put", **poll)
        token = await lesson.token()
        assert (await lesson.vote(token, **poll, option=1)).status == 204
        assert (await lesson.vote(token, **poll, option=2)).status == 409
        tally = (await called(url, f"/class/{lesson.code}/tally", word=lesson.key)).json
        assert tally["now"]["options"] == [0, 1]
        assert (await called(url, f"/class/{lesson.code}/stored", word=lesson.key)).json == STORED
        assert (await called(url, f"/class/{lesson.code}/summary", word=lesson.key)).json == []
        table = (await called(url, f"/class/{lesson.code}/answers.csv", word=lesson.key)).text
        rows = list(csv.DictReader(table.splitlines()))
        assert [(row["step"], row["answer"], row["right"]) for row in rows] == [("vote-1", "B", "")]


async def test_another_computer_leads_with_a_word_that_is_good_once() -> None:
    async with teaching() as (_, url):
        lesson, other = await Class.open(url), await Class.open(url)
        path, link = f"/class/{lesson.code}/word", {"query": "scene=coupled&k2=3"}
        assert (await called(url, path, "POST", link, await lesson.token())).status == 404
        leader = await lesson.lead()
        mine = 'title = "Mine"\n[[step]]\nid = "pull"\nfrom = "d31-03"\n'
        assert (await lesson.order("walk", name="mine", text=mine)).status == 204
        address = (await called(url, path, "POST", link, lesson.key)).json["address"]
        moved = await called(url, "/" + address.rpartition("/")[2].lower())
        word = address.rpartition("-")[2]
        assert (moved.status, moved.headers["Location"]) == (302, f"./?class={lesson.code}&lead={word}")
        for wrong in ("ZZZZZZZZ", "", "x" * 30):
            refused = await called(url, path, "PUT", {"word": wrong})
            assert refused.status in (400, 403) and refused.json["sentence"].endswith(".")
        taken = (await called(url, path, "PUT", {"word": word})).json
        assert (taken["code"], taken["key"], taken["query"]) == (lesson.code, lesson.key, link["query"])
        assert taken["walks"] == {"mine": mine}
        assert (await leader.until(lambda event: event.get("deed")))["deed"] == "taken"
        again = await called(url, path, "PUT", {"word": word})
        assert (again.status, again.json["sentence"]) == (403, lead_routes.NO_WORD)
        words = [
            (await called(url, path, "POST", link, lesson.key)).json["address"].rpartition("-")[2] for _ in range(2)
        ]
        assert (await called(url, path, "PUT", {"word": words[0]})).status == 403  # the second one has replaced it
        assert (await called(url, f"/class/{other.code}/word", "PUT", {"word": words[1]})).status == 403
        assert (await called(url, path, "PUT", {"word": words[1]})).status == 200  # a wrong code does not use it up
        await leader.close()


async def test_words_cannot_be_guessed() -> None:
    async with teaching() as (server, url):
        lesson = await Class.open(url)
        await server.classes.registry.store.count("miss 127.0.0.0/24", 60.0, 300)
        refused = await called(url, f"/class/{lesson.code}/word", "PUT", {"word": "ZZZZZZZZ"})
        assert refused.status == 429
