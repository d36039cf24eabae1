// A text to keep as a file.

import {element} from "../dom.js"

/** @param {string} name @param {string} text @param {string} kind its media type */
export function save(name, text, kind) {
  const link = element("a", {href: URL.createObjectURL(new Blob([text], {type: kind})), download: name})
  link.click()
  URL.revokeObjectURL(link.href)
}
