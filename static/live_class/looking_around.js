// The bar for a follower who looks around outside the class. It leads back, and says when the lecture asks a question.

import {element} from "../core/dom.js"
import {LEFT, tabStorage} from "../core/storage.js"
import {forget, mine} from "./my_answers.js"
import {Stream} from "./stream.js"

/** @param {string} code @param {(step: string) => void} asks called with the current question of the lecture, if any */
export function ownWay(code, asks) {
  const token = mine(code)?.token
  if (!token) return
  const line = element("span", {role: "status"}, code)
  const back = element("a", {class: "act filled", href: `./?class=${code}`}, "Back to the lecture")
  back.addEventListener("click", () => tabStorage.forget(LEFT))
  const bar = element("footer", {class: "class-bar"})
  bar.append(element("div", {}, element("b", {}, "On your own"), line), back)
  document.body.append(bar)
  const over = () => {
    stream.close()
    bar.remove()
    asks("")
    forget(code)
  }
  const stream = new Stream(code, token, {
    news: ({question, ended}) => {
      if (question) {
        const isOpen = question.step && !question.lesson && !question.answered
        line.textContent = isOpen ? `a question is open: ${question.place}` : code
        asks(isOpen ? `${question.walk}/${question.step}` : "")
      }
      if (ended) over()
    },
    refused: () => over(),
    connected: () => {},
    sleeps: true,
  })
}
