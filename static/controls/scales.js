// Scales of sliders: conversion between positions and numbers, and the next number for a key.

import {MINUS} from "../core/numbers.js"
import {clamp} from "../core/ruler.js"

/**
 * Conversion between a value and its position on a slider, from 0 to 1; `finest` is the smallest step, 0 for three
 * digits.
 * @typedef {(number: number, low: number, high: number) => number} Mapping
 * @typedef {{value: Mapping, place: Mapping, finest: (low: number, high: number) => number}} Scale
 */

/** @type {Scale} */
const linear = {
  value: (place, low, high) => low + (high - low) * place,
  place: (value, low, high) => (value - low) / (high - low),
  finest: (low, high) => (high - low) / 400,
}
/** @type {Record<page.SliderRow["scale"], Scale>} */
const SCALES = {
  linear,
  count: {...linear, finest: () => 1},
  log: {
    value: (place, low, high) => low * (high / low) ** place,
    place: (value, low, high) => Math.log(value / low) / Math.log(high / low),
    finest: () => 0,
  },
  near0: {
    value: (place, _, high) => high * place ** 3,
    place: (value, _, high) => Math.cbrt(value / high),
    finest: (_, high) => high / 10000,
  },
}

/** @param {page.SliderRow["scale"]} scale @param {number} place @param {[number, number]} soft */
export function sliderValue(scale, place, [low, high]) {
  const {value, finest} = SCALES[scale]
  const raw = value(place, low, high)
  if (!finest(low, high)) return Number(raw.toPrecision(3))
  const unit = 10 ** Math.floor(Math.log10(finest(low, high)))
  return Number((Math.round(raw / unit) * unit).toPrecision(3)) + 0
}

/** @param {page.SliderRow["scale"]} scale @param {number} value @param {[number, number]} soft */
export function sliderPlace(scale, value, [low, high]) {
  const place = SCALES[scale].place(clamp(value, low, high), low, high)
  return clamp(place, 0, 1)
}

/**
 * The next number of two digits: 0.10, 0.11 ... 0.99, 1.0, 1.1.
 * @param {number} value @param {1 | -1} direction @param {[number, number]} soft
 */
export function atTwoDigits(value, direction, soft) {
  const unit = 10 ** (Math.floor(Math.log10(value)) - 1)
  const steps = value / unit
  const next = direction > 0 ? Math.floor(steps + 1e-9) + 1 : Math.ceil(steps - 1e-9) - 1
  return clamp(Number((next * unit).toPrecision(2)), ...soft)
}

/**
 * The value after Page Up or Page Down: ten times as large or small; on a linear scale, a tenth of the slider away.
 * @param {page.SliderRow["scale"]} scale @param {number} value @param {1 | -1} direction @param {[number, number]} soft
 */
export function leapt(scale, value, direction, [low, high]) {
  const least = high / 1000
  if (scale === "log" || (scale === "near0" && value * 10 ** direction >= least))
    return clamp(Number((value * 10 ** direction).toPrecision(12)), low, high)
  if (scale === "near0") return direction > 0 ? least : low
  const next = Number((value + (direction * (high - low)) / 10).toPrecision(12))
  return clamp(scale === "count" ? Math.round(next) : next, low, high)
}

/**
 * The number in `text`, changed by one unit of its last digit up or down; null if it is no plain number.
 * @param {string} text @param {1 | -1} direction
 */
export function stepped(text, direction) {
  const match = text
    .trim()
    .replaceAll(MINUS, "-")
    .replace(",", ".")
    .match(/^([+-]?)(\d+)(?:\.(\d*))?(e[+-]?\d+)?$/i)
  if (!match) return null
  const [, sign, whole, fraction = "", exponent = ""] = match
  const units = BigInt(`${sign === "-" ? "-" : ""}${whole}${fraction}`) + BigInt(direction)
  const digits = String(units < 0n ? -units : units).padStart(fraction.length + 1, "0")
  const point = digits.length - fraction.length
  const shown = fraction ? `${digits.slice(0, point)}.${digits.slice(point)}` : digits
  return (units < 0n ? "-" : "") + shown + exponent
}
