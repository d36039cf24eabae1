// Starts the lecture that the page was served for.

import {begin} from "./main.js"

begin()
