"""The message types between Python and the browser. Imports no other package of the project.

All messages are built from these frozen structs. Incoming messages are decoded into them, so malformed ones are
rejected before any other code sees them. `make protocol` writes docs/protocol.md and the TypeScript declarations from
them.

    numbers    numbers of a picture that the browser computes: polynomials in named quantities
    text       sentences as HTML, and short texts of a drawing as runs, pieces of one style
    shapes     the parts of a stage
    signals    numbers that depend on time, evaluated sixty times a second without the server
    plots      curves, bands, handles, marks and the heading of a plot
    blocks     the arrangement of the paper
    controls   the control panel and the values of its controls
    picture    everything that depends on the parameters
    state      the state of a page: scene, parameters, frame, hidden parts
    messages   the messages of the browser and of the server
"""
