// The instructor's screen, described for a remote control: what the next press does, and which buttons do something.

/**
 * Its description, with whether a question can be put once more and whether the join screen is open.
 * @param {LectureHost["walks"]} walks @param {boolean} canRepeat @param {boolean} joins @returns {page.DescribeScreen}
 */
export function describedScreen(walks, canRepeat, joins) {
  const {walk} = walks
  const isAsked = Boolean(walk?.step && !walk.lesson)
  /** @type {[page.Deed, boolean][]} */
  const possible = [
    ["back", Boolean(walk && (walk.lesson || walk.place > 0))],
    ["show", isAsked && !walk?.step.poll],
    ["derive", Boolean(walk?.lesson && walk.card?.fold && !walk.card.fold.open)],
    ["again", isAsked && canRepeat],
    ["poll", true],
    ["go", Boolean(walk)],
    ["close", joins],
  ]
  return {
    type: "screen",
    next: walks.turns ? (walk?.press.words ?? "Back to the walk") : "",
    blank: document.querySelector(".blank") !== null,
    deeds: possible.filter(([, is]) => is).map(([deed]) => deed),
  }
}
