"""The language between Python and the browser: types only, and nothing of ours is imported.

Whatever crosses is one of these frozen structs. What comes in is decoded by them, so that a malformed message is
refused before anybody reads it; what goes out is built from them alone. `make protocol` writes docs/protocol.md and the
browser's type definitions from them.

    numbers    numbers of a picture that the browser works out: polynomials in named quantities
    text       sentences as HTML, and short texts of a drawing as runs
    shapes     what a stage is drawn from
    signals    what moves, sixty times a second without a server
    plots      curves, bands, handles, marks and the heading of a plot
    blocks     what stands where on the paper
    controls   the panel, and what its controls show
    picture    everything that a change of parameters changes
    state      what a page stands for: scene, parameters, frame, what is hidden
    messages   what the browser says, and what it is told
"""
