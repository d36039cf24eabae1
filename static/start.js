// Starts the lecture that the page was served for.

import {begin} from "./main.js"

// A page that follows a class has no own picture.
if (document.getElementById("opening")) begin()
