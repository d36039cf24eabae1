// Starts the lecture that the page was served for.

import {begin} from "./main.js"

// A page that follows a class contains no first picture.
if (document.getElementById("opening")) begin()
