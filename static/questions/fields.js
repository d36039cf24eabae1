// Fields of the form with which instructors write a question.

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

/** A check box. @param {string} name @param {string} value @param {string} label @param {boolean} isSet */
export function box(name, value, label, isSet = false) {
  const input = element("input", {type: "checkbox", name, value, checked: isSet ? "" : undefined})
  return element("label", {class: "ask-box"}, input, ` ${label}`)
}

/** The fields of a right answer, as a number or as an expression in the scene's numbers. @param {string} label */
export const answerFields = label => [labelled(label, "is"), labelled("or an expression, such as 2 * tau", "of")]

/**
 * The typed numbers as text; the session parses them like a field's. An expression stays as it is typed.
 * @param {HTMLFormElement} form @param {string} unit
 */
export function answerIn(form, unit) {
  const [is, of] = [text(form, "is"), text(form, "of")]
  /** @type {import("./question.js").Fields} */
  const target = of ? {of} : {is}
  return {...target, ...(of && is ? {is} : {}), unit, tol: text(form, "tol")}
}
