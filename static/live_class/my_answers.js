// Data that a phone stores about a class: its token and its answers, sent and unsent. Deleted when the class is over.

import {browserStorage} from "../core/storage.js"
import {fetchJson, insist, isMissing, isRefused} from "./requests.js"

/**
 * Answers by question.
 * @typedef {Record<string, page.Given>} ByQuestion
 * @typedef {{token: string, answers: ByQuestion, unsent: ByQuestion}} Mine
 */

const OF_A_CLASS = /^class-[0-9A-Z]{4}$/
const DOUBT = 30000 // ms for which a scanned code may be unknown: a restarted server first restores its classes

/** @param {string} code */
const name = code => `class-${code}`

/** @param {string} code @returns {Mine | null} */
export function mine(code) {
  /** @type {Partial<Mine>} */
  const {token, answers = {}, unsent = {}} = browserStorage.value(name(code)) ?? {}
  return token ? {token, answers, unsent} : null
}

/** Starts to store a class, and deletes earlier ones. @param {string} code @param {string} token */
function enter(code, token) {
  browserStorage.forget(...browserStorage.names().filter(key => OF_A_CLASS.test(key)))
  keep(code, {token, answers: {}, unsent: {}})
}

/**
 * The code and the token of a class: the token that this browser keeps, or a new one. A wrong typed code fails at once;
 * a code from a QR code is tried for half a minute.
 * @param {string} typed @param {string} word of the QR code, "" if the code was typed
 * @param {(reason: unknown) => void} failed called after each failed try
 */
export async function entered(typed, word, failed) {
  const code = typed.toUpperCase().replace(/[\s-]/g, "")
  const known = () => ({code, token: mine(code)?.token ?? ""})
  if (known().token) return known()
  const doubts = Date.now() + (word ? DOUBT : 0)
  const isFinal = (/** @type {unknown} */ reason) => isRefused(reason) && !(isMissing(reason) && Date.now() < doubts)
  const request = () => fetchJson(`${encodeURIComponent(code)}/token`, {method: "POST", word})
  const found = await insist(request, {failed, isFinal})
  if (known().token) return known() // if another tab of this phone has joined meanwhile, both count as one follower
  enter(found.code, found.token)
  return found
}

/** @param {string} code @param {(known: Mine) => void} change */
export function amend(code, change) {
  const known = mine(code)
  if (!known) return
  change(known)
  keep(code, known)
}

/** @param {string} code */
export const forget = code => browserStorage.forget(name(code))

/** @param {string} code @param {Mine} known */
const keep = (code, known) => browserStorage.keepOrSay(name(code), known)
