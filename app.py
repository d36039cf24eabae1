"""The page of one visitor: the scene that the link names, with the link's parameters, in the shell."""

from __future__ import annotations

from functools import partial

import panel as pn

from components.scene import Scene
from components.scenes import SCENES
from components.shell import answer_at_once, ending, navigation, page_template, when_open
from components.url import read_query
from components.view import SceneView

pn.config.browser_info = False
link = read_query(pn.state.session_args, SCENES)
scene: Scene = SCENES[link.slug]()
problems = list(link.problems)
try:
    scene.set(link.values)
except ValueError as reason:
    problems.append(f"{reason} The link's parameters were not used.")

document = pn.state.curdoc
assert document is not None  # a script is only ever served
document.title = scene.headline
document.template = page_template()
document.template_variables.update(
    headline=scene.headline, scene_title=scene.title, navigation=navigation(SCENES, scene.slug)
)
scene.later = partial(when_open, document)
pn.state.onload(partial(answer_at_once, document))
pn.state.on_session_destroyed(ending(scene.close))
SceneView(scene, problems=tuple(problems)).server_doc(document, location=False)
