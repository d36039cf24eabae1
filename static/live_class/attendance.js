// The attendance of a phone, kept until the class is over: its token, and its answers by question.

import {browserStorage} from "../core/storage.js"

/** @typedef {{token: string, answers: Record<string, page.Given>}} Mine */

const OF_A_CLASS = /^class-[0-9A-Z]{4}$/

/** @param {string} code */
const name = code => `class-${code}`

/** @param {string} code @returns {Mine | null} */
export function mine(code) {
  /** @type {Partial<Mine>} */
  const {token, answers = {}} = browserStorage.value(name(code)) ?? {}
  return token ? {token, answers} : null
}

/** Another class takes the place of those before. @param {string} code @param {string} token */
export function enter(code, token) {
  browserStorage.forget(...browserStorage.names().filter(key => OF_A_CLASS.test(key)))
  keep(code, {token, answers: {}})
}

/** @param {string} code @param {string} question @param {page.Given} vote */
export function answer(code, question, vote) {
  const known = mine(code)
  if (known) keep(code, {...known, answers: {...known.answers, [question]: vote}})
}

/** @param {string} code */
export const forget = code => browserStorage.forget(name(code))

/** @param {string} code @param {Mine} known */
const keep = (code, known) => browserStorage.keepOrSay(name(code), known)
