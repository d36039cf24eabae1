// The switch between light and dark.

import {browserStorage} from "../core/storage.js"

export function turnTheme() {
  const {dataset} = document.documentElement
  dataset.theme = dataset.theme === "dark" ? "light" : "dark"
  browserStorage.keepOrSay("theme", dataset.theme)
}
