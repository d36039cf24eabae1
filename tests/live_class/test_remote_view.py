"""The summary of a question on a remote control, and the orders that it refuses."""

from __future__ import annotations

from tests.live_class.caller import Answered, Class, called
from tests.live_class.served import CHOICE, teaching

NOTED = (
    'title = "Noted"\n[[step]]\nid = "one"\nfrom = "d31-03"\nnotes = """\nShow the *real* spring.\n\nThen wait."""\n'
)


class Remote:
    """An admitted remote control."""

    def __init__(self, url: str, path: str, key: str) -> None:
        self.url, self.path, self.key = url, path, key

    @classmethod
    async def pair(cls, url: str, lesson: Class) -> Remote:
        path = f"/class/{lesson.code}/"
        ticket = (await called(url, path + "tickets", "POST", word=lesson.key)).json["address"]
        secret = {"address": ticket.partition("remote=")[2]}
        paired = (await called(url, path + "remote", "PUT", secret)).json
        await called(url, path + "tickets", "PUT", {"digits": paired["digits"]}, lesson.key)
        return cls(url, path + "remote", paired["key"])

    async def look(self, after: str = "") -> Answered:
        return await called(self.url, f"{self.path}?after={after}", word=self.key)


async def test_it_has_the_split_the_right_answer_and_the_notes_before_the_answer_is_shown() -> None:
    async with teaching() as (_, url):
        lesson = await Class.open(url)
        remote = await Remote.pair(url, lesson)
        await lesson.order("walk", name="noted", text=NOTED)
        await lesson.order("put", walk="noted", step="one")
        for option in (0, 0, 1):
            await lesson.vote(await lesson.token(), walk="noted", step="one", option=option)
        view = (await remote.look()).json
        assert view["tally"]["now"]["options"] == [2, 1, 0] and view["tally"]["right"] == 2 and view["judges"]
        assert view["question"]["lesson"] is None
        assert [one["right"] for one in view["lesson"]["verdicts"]] == [True, False, False]
        assert view["notes"] == ['Show the <span class="v">real</span> spring.', "Then wait."]
        assert (await remote.look(view["number"])).status == 204
        await lesson.vote(await lesson.token(), walk="noted", step="one", option=2)
        assert (await remote.look(view["number"])).json["tally"]["now"]["answered"] == 4


async def test_it_has_counts_of_numbers_and_sketches_and_none_of_them_single() -> None:
    async with teaching() as (_, url):
        lesson = await Class.open(url)
        remote = await Remote.pair(url, lesson)
        for step, given in (("d31-02", {"text": "2"}), ("d34-14", {"curves": {"Xp1": [500] * 101}})):
            asked = {"walk": step.partition("-")[0], "step": step}
            await lesson.order("put", **asked)
            assert (await lesson.vote(await lesson.token(), **asked, **given)).status == 204
            now = (await remote.look()).json["tally"]["now"]
            assert now["answered"] == 1 and now["numbers"] == [] and now["sketches"] == []


async def test_the_words_of_the_next_press_come_from_the_instructors_screen() -> None:
    async with teaching() as (_, url):
        lesson = await Class.open(url)
        remote, stream = await Remote.pair(url, lesson), await lesson.follow()
        await lesson.order("put", **CHOICE)
        assert (await remote.look()).json["screen"] is None
        screen = {"next": "Show the votes", "blank": False, "deeds": ["back", "go"]}
        assert (await lesson.order("screen", **screen)).status == 204
        assert screen.items() <= (await remote.look()).json["screen"].items()
        for wrong in ({"next": "x" * 10_000}, {"deeds": ["fly"]}, {"deeds": ["go"] * 21}, {"next": 1}):
            refused = await lesson.order("screen", **wrong)
            assert refused.status == 400 and refused.json["sentence"] == "This is not what the lecture's page sends."
        assert not any("screen" in event for _, event in stream.heard)  # phones get nothing
        await stream.close()
