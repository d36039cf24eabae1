// The answer to the step that stands, kept by this tab: a page that is loaded anew shows what it has shown.

import {tabStorage} from "../core/storage.js"

const KEY = "answered-step"

/** @typedef {{step: string, given: Partial<page.Given>}} Answered to a step of a walk, "d34/d34-07" */

/** @returns {Answered | null} */
export const answered = () => tabStorage.value(KEY)

/** @param {Answered} known */
export const keepAnswered = known => tabStorage.keep(KEY, known)

export const forgetAnswered = () => tabStorage.forget(KEY)
