// The contents in a separate window. A step that is chosen there opens on the page in the hall.

/* oxlint-disable unicorn/require-post-message-target-origin -- a channel is one origin's */

const NAME = "steps-of-the-lecture" // channel for messages between windows of one browser
export const STEPS = "#steps" // hash in the address of the window with the contents

/**
 * On the page in the hall: reports its walks from files, and opens the chosen step.
 * @param {LectureHost} lecture
 */
export function follow(lecture) {
  const channel = new BroadcastChannel(NAME)
  channel.addEventListener("message", ({data}) => {
    const {hall, walks} = lecture
    if (!hall.on) return
    if (data.asks) channel.postMessage({texts: walks.texts})
    else if (walks.names.includes(data.walk)) walks.enter(data.walk, data.place)
  })
  return channel
}

/**
 * Makes this the window with the contents. Choosing a step here opens it in the other window. @param
 * {LectureHost["walks"]} walks
 */
export function lead(walks) {
  const channel = new BroadcastChannel(NAME)
  channel.addEventListener("message", async ({data}) => {
    await Promise.all(Object.entries(data.texts ?? {}).map(([name, text]) => walks.check(name, text)))
    walks.walk?.open()
  })
  walks.choose = (walk, place) => channel.postMessage({walk, place})
  walks.walk?.open()
  channel.postMessage({asks: true})
}
