// Fields of the form in which a question is written.

import {element} from "../core/dom.js"

/** @param {string} label @param {string} name @param {string} [value] @param {boolean} [required] */
export function labelled(label, name, value = "", required = false) {
  const input = element("input", {name, value, autocomplete: "off", required: required ? "" : undefined})
  return element("label", {class: `ask-${name}`}, element("span", {}, label), input)
}

/** @param {string} label @param {string} name @param {{value: string, label: string}[]} options */
export function chooser(label, name, options) {
  const select = element("select", {name}, ...options.map(one => element("option", {value: one.value}, one.label)))
  return element("label", {}, element("span", {}, label), select)
}

/** @param {HTMLFormElement} form @param {string} name */
export const text = (form, name) => String(new FormData(form).get(name) ?? "").trim()

/**
 * Its numbers as they are typed: the session reads them as it reads a field.
 * @param {HTMLFormElement} form @param {string} unit
 */
export const answerIn = (form, unit) => ({is: text(form, "is"), unit, tol: text(form, "tol")})
