// Saves files on the visitor's computer.

import {element} from "../core/dom.js"

const KEPT = 40000 // ms until the file is released, because Safari reads it only some time after the click

/** @param {string} name @param {BlobPart} content @param {string} kind its media type */
export function save(name, content, kind) {
  const link = element("a", {href: URL.createObjectURL(new Blob([content], {type: kind})), download: name})
  link.click()
  setTimeout(() => URL.revokeObjectURL(link.href), KEPT)
}

/** A file that the server has made. @param {page.File} file */
export const download = ({name, kind, content}) =>
  save(
    name,
    Uint8Array.from(atob(content), sign => sign.charCodeAt(0)),
    kind,
  )
