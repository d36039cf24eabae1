// A walk from the visitor's own file, dropped onto the page or chosen. Only this visitor's session checks and runs it.

const LARGEST = 48_000 // bytes of a file: components/walks/loading.py
const SENT = 60_000 // bytes of the message with the file

/** Runs a walk from a file, or shows why it cannot. @param {LectureHost["walks"]} walks @param {File} file */
export async function run(walks, file) {
  walks.lecture.page.notice.hide() // close the notice about an earlier file
  const refusal = await read(file).then(
    text => walks.run(nameOf(file.name), text),
    (/** @type {Error} */ error) => error.message,
  )
  if (refusal) walks.lecture.page.notice.tell(`${file.name}: ${refusal}`)
}

/** @param {File} file */
async function read(file) {
  if (file.size > LARGEST) throw new Error(`the file has ${file.size} bytes; at most ${LARGEST} are allowed.`)
  const bytes = await file.arrayBuffer()
  let text = ""
  try {
    text = new TextDecoder("utf-8", {fatal: true}).decode(bytes)
  } catch {
    throw new Error("this is not UTF-8 text. A walk is a TOML file: see docs/writing-a-walk.md.")
  }
  if (new Blob([JSON.stringify(text)]).size > SENT) throw new Error("the file has too many lines or quotes to be sent.")
  return text
}

/** The name of a walk: "my-walk" for "My walk.toml". @param {string} file */
function nameOf(file) {
  const words = file
    .replace(/\.[^.]*$/, "")
    .toLowerCase()
    .match(/[a-z0-9]+/g) ?? ["walk"]
  return words.join("-").slice(0, 40).replace(/-$/, "")
}
