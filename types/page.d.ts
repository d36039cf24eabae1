// Written by `make protocol` from components/language. Edit the code, not this file.

declare namespace page {
  type SaidName = string

  type Text = string

  /** A height in thousandths of the frame, from its lower edge. */
  type Height = number

  /** A sketched curve: its heights; null in gaps. */
  type Sketched = (Height | null)[]

  /** One column of a piece of a measured record. */
  type RowNumbers = number[]

  /** An answer to a step of a walk: the index of an option, a number or a few words as text, a place on the axis, or
   * curves by name.
   *
   * `seed` chooses the step's numbers; 0 means the numbers of the file. `vote` counts how often the class has voted on
   * the question, from 1 on. `sure` is the student's confidence: 1 for a guess, 2 for fairly, 3 for certain, 0 if not
   * given. */
  interface Given {
    walk: SaidName
    step: SaidName
    seed?: number
    vote?: number
    option?: number | null
    text?: string
    value?: number | null
    curves?: Record<SaidName, Sketched>
    sure?: number
  }

  /** Any message of the browser. */
  interface FromBrowser {
    number?: number
  }

  /** Sets quantities by name, in SI: from sliders and handles.
   *
   * While a hand is dragging (`holding` is true), neither the axes in `along` nor the scale of the stage change; other
   * axes may grow. At the end of a drag or key press (false), a mostly empty axis is fitted again, unless the hand moved
   * `along` it. If `holding` is None, the value may still change. */
  interface SetValues extends FromBrowser {
    type: "set"
    values: Record<SaidName, number | null>
    holding?: boolean | null
    along?: SaidName[]
  }

  /** Sets a quantity by the text of its field, in the unit that it shows. */
  interface Typed extends FromBrowser {
    type: "typed"
    name: SaidName
    text: Text
  }

  /** Presses a button. */
  interface Act extends FromBrowser {
    type: "act"
    name: SaidName
  }

  /** Sets a choice by the word of its option, or a list by its words. */
  interface Choose extends FromBrowser {
    type: "choose"
    name: SaidName
    value: Text | SaidName[]
  }

  /** Starts or ends a measurement. */
  interface RunOrder extends FromBrowser {
    type: "run"
    order: "start" | "cancel" | "skip"
  }

  /** Opens a state in this session. If `carried`, another scene takes over the parameters that it shares with earlier
   * scenes. If `keeps`, the current frame stays, so that two pictures of one scene can be compared. */
  interface Open extends FromBrowser {
    type: "open"
    state: State
    carried?: boolean
    keeps?: boolean
  }

  /** Gives an answer to a step of a walk. */
  interface GiveAnswer extends FromBrowser {
    type: "given"
    answer: Given
  }

  /** Runs a walk from the text of its file, in this session only. */
  interface RunWalk extends FromBrowser {
    type: "walk"
    name: SaidName
    text: string
  }

  /** Sends the pictures of this page to the followers of a class from now on; `key` permits the page to lead. */
  interface Lead extends FromBrowser {
    type: "lead"
    code: string
    key: SaidName
  }

  /** Requests the numbers of all plots as CSV; `page` is the address that the link in the file begins with. */
  interface AskCsv extends FromBrowser {
    type: "csv"
    page?: Text
  }

  /** Requests the known errors of the displayed numbers. */
  interface AskAbout extends FromBrowser {
    type: "about"
  }

  /** Sends a piece of a measured record: times in s that never decrease, and for each mass a column of displacements
   * in m, or of their first or second derivative, as `derivative` says.
   *
   * The pieces have the numbers 0 to `of` - 1 and arrive in this order; after the last one the server fits a motion
   * with as many frequencies as columns. Each row is the mean of `size` neighbouring rows of the file. A session keeps
   * no rows after the fit. */
  interface SendRows extends FromBrowser {
    type: "rows"
    piece: number
    of: number
    size?: number
    derivative?: number
    t: RowNumbers
    columns: RowNumbers[]
  }

  /** Cancels the fit that waits for its turn; the page no longer waits for its answer. */
  interface CancelFit extends FromBrowser {
    type: "cancel_fit"
  }

  type BrowserMessage = SetValues | Typed | Act | Choose | RunOrder | Open | GiveAnswer | RunWalk | Lead | AskCsv | AskAbout | SendRows | CancelFit

  /** Any message of the server; `answer` is the number of the message that it answers. */
  interface ServerMessage {
    answer: number | null
  }

  /** The current page.
   *
   * `sheet` is the address of the scene's sheet, `held` the compared picture, `settings` the values of the controls by
   * parameter, `preset` the name of the current preset, `here` the buttons whose values the scene has now, `errors` the
   * reasons for rejected values of the last message by parameter, `problems` the rejected parts of a link, `query` the
   * link of this state. */
  interface Shown extends ServerMessage {
    type: "shown"
    scene: string
    sheet: string
    view: PagePicture
    held: Held | null
    settings: Record<string, Setting>
    state: State
    preset: string | null
    here: string[]
    errors: Record<string, string>
    problems: string[]
    query: string
    progress: Progress | null
  }

  /** The answer to the end of a drag if the page does not change. */
  interface Kept extends ServerMessage {
    type: "kept"
  }

  /** A file to save, and its media type. */
  interface File extends ServerMessage {
    type: "file"
    name: string
    kind: string
    content: bytes
  }

  /** One number in twenty digits: as drawn, the exact value, and the error in ulp. */
  interface AboutPoint {
    name: Html
    place: Html
    drawn: string
    true: string
    off: string
  }

  /** Numbers with the sentence that bounds their errors. */
  interface AboutTable {
    bound: Html
    rows: AboutPoint[]
  }

  /** The known errors of the displayed numbers. */
  interface AboutNumbers extends ServerMessage {
    type: "about"
    reading: Html
    tables: AboutTable[]
    notes: Html[]
  }

  /** The lesson of a step, in answer to `GiveAnswer`. `refused` is the reason if there is none; if `is_busy`, the
   * server has no time now and the page may ask again. */
  interface Taught extends ServerMessage {
    type: "taught"
    walk: string
    step: string
    lesson: Lesson | null
    refused: string
    is_busy: boolean
  }

  /** A walk that this session runs. `refused` says what is wrong with its file; if `is_busy`, the server has no time
   * now. */
  interface Walking extends ServerMessage {
    type: "walking"
    sheet: WalkSheet | null
    refused: string
    is_busy: boolean
  }

  /** A number of a fit and its standard error, as text; `error` is "" if it has none. */
  interface FittedNumber {
    symbol: Html
    name: string
    value: string
    error: string
    unit: string
  }

  /** A fitted column, in SI units: the displacement is the sum over the frequencies of e^(-decay t) (C cos omega t +
   * S sin omega t), with t counted from the first row. The rows are its derivative plus offset + drift t; `scatter` is
   * the standard deviation of their residuals. */
  interface FittedColumn {
    C: number[]
    S: number[]
    offset: number
    drift: number
    scatter: number
  }

  /** A fitted motion: the frequencies in rad/s and decays in 1/s that its columns share. */
  interface FittedMotion {
    omega: number[]
    decay: number[]
    columns: FittedColumn[]
  }

  /** The parameters of a scene that follow from a fit: `values` as they are, and `per_mass` for each kg of the
   * parameter `mass`, which the scene keeps. */
  interface FittedParameters {
    mass: string
    values: Record<string, number | string>
    per_mass: Record<string, number>
  }

  /** The answer to `SendRows`.
   *
   * `piece` is the number of the piece that the server needs next, 0 to begin again. The answer to the last piece has
   * the fit, or in `refused` the reason why there is none; if `is_busy`, the server has no time now. `parameters` is
   * None if the scene has no motion like the fitted one. */
  interface Fitted extends ServerMessage {
    type: "fitted"
    piece: number
    motion: FittedMotion | null
    parameters: FittedParameters | null
    numbers: FittedNumber[]
    sentences: string[]
    refused: string
    is_busy: boolean
  }

  type AnyServerMessage = Shown | Kept | File | AboutNumbers | Taught | Walking | Fitted

  /** A view of a scene: its name in links, the name on its tab, its task, the parameters whose controls are the first
   * of the panel, and the parts that its task is about. */
  interface ViewTab {
    word: string
    name: string
    task: Html
    keys: string[]
    names: string[]
  }

  /** Everything about a scene that is the same for every visitor: an immutable file.
   *
   * `preset_dictionary` compresses the messages about the scene. `hidden` are the curves that
   * are switched off at first. `spoken` maps names to texts with {live numbers} that are read aloud after a change. A
   * scene with `views` shows one at a time, chosen by the parameter `view`; other scenes always show the whole paper. */
  interface SceneSheet {
    slug: string
    title: string
    headline: string
    hidden: string[]
    runs: boolean
    about: boolean
    onward: Onward[]
    preset_dictionary: string
    spoken: Record<string, string>
    views: ViewTab[]
    paper: Block
    panel: Panel
  }

  /** A value in a state: a quantity in SI (None if the scene chooses it), the word of a choice, or a list of words. */
  type Value = number | string | string[] | null

  /** A frame for a picture: the ranges of its axes by name, its time window in s, the scale of its stage, and its
   * speed in simulated seconds per second. `given`: it came with a link, so the end of a drag does not fit it again. */
  interface Frame {
    ranges: Record<string, [number, number]>
    window: number | null
    scale: number | null
    speed: number | null
    given: boolean
  }

  /** The state of a page.
   *
   * A scene, its parameters that are not at their defaults, its frame if it is not the fitted one, the parameters of the
   * compared picture, the hidden plots and values, the parameters from before a change that is to be predicted, the
   * switched-off curves if not the scene's default, the step of a walk ("d34/d34-07", or "d34/d34-07/5" with a seed for
   * its numbers), and the parts to show in place of the parts of its view. */
  interface State {
    scene: string
    parameters: Record<string, Value>
    frame: Frame | null
    held: Record<string, Value> | null
    covered: string[]
    before: Record<string, Value> | null
    hidden: string[] | null
    step: string
    show: string[]
  }

  /** The card of a step, before its answer.
   *
   * `place` is its position in the lecture, `given` a text above the question. `options` are the answers of a choice,
   * shown in random order unless `fixed`; in a `poll` none is right. `unit` is the unit of a number, `plot` the plot for
   * a point or a sketch, `axis` the axis of the point, `curves` the curves to draw, by name, and `frame` the axes x and
   * y of a sketch that a class shares. `opens` is the state for the question, `reveals` the one for the answer, in which
   * the parameters in `controls` can be changed. The `core` steps make a shorter walk. A step with `derive` has one more
   * press, which shows the derivation. If it `closes`, the end of a countdown closes the vote. `variants` are cards of
   * its question with other numbers, for the seeds from 1 on. */
  interface StepCard {
    id: string
    kind: string
    place: string
    scene: string
    given: Html
    question: Html
    minutes: number
    core: boolean
    derive: boolean
    closes: boolean
    opens: State
    reveals: State
    controls: string[]
    options: Html[]
    fixed: boolean
    poll: boolean
    unit: string
    plot: string
    axis: "" | "x" | "y"
    curves: string[]
    frame: [Ruler, Ruler] | null
    variants: StepCard[]
  }

  /** A scene to try after the last step: its slug, what to do there, and a sentence. */
  interface WalkTrial {
    scene: string
    title: Html
    text: Html
  }

  /** A walk from its first step to its last, the sentences of its summary, and the scenes to try after it. */
  interface WalkSheet {
    name: string
    title: string
    steps: StepCard[]
    end: Html[]
    trials: WalkTrial[]
  }

  /** The comment on one option of a choice, and the state of the case that it mentions, if any. */
  interface Verdict {
    right: boolean
    reply: Html
    where: State | null
  }

  /** A feature that a sketch has or misses: its name, a comment, and its position in coordinates of the plot's
   * axes. */
  interface Finding {
    has: boolean
    name: Html
    words: Html
    at: [number, number] | null
  }

  /** The lesson of a step, sent after its answer.
   *
   * `right` is None if no answer was given. `reply` is the sentence for the answer, `where` the state of a case that it
   * mentions; `verdicts` are the comments on the options, `findings` those on a sketch, `truth` the right number or
   * places; `places` has them in the unit of the number, or on the axis of the point. `shows` is the state of the answer
   * if it is not the card's `reveals`. */
  interface Lesson {
    title: Html
    explain: Html
    follows: Html[]
    next: Html
    right: boolean | null
    reply: Html
    where: State | null
    verdicts: Verdict[]
    findings: Finding[]
    truth: string
    shows: State | null
    places: number[]
  }

  /** Buttons of a remote control. */
  type Deed = "next" | "back" | "show" | "derive" | "again" | "poll" | "sure" | "countdown" | "closing" | "blank" | "close" | "go" | "allow" | "remove" | "end"

  /** Any request of the instructor's page to the room. */
  interface Ordered {
  }

  /** Sets the class's clock: it showed `t` at the server's time `at`, in ms, and advances by `rate` per second, up to
   * `end`; `t`, `rate` and `end` are in the unit of the time axis. */
  interface RunClock extends Ordered {
    type: "clock"
    t: number
    rate: number
    end: number
    at: number
  }

  /** Asks the class the question of a step. `vote` is the number of the vote: one more for a new vote, the same as
   * last time if the instructor returns to the question. If `answered`,
   * the class has seen the answer and the vote takes no more answers. */
  interface PutQuestion extends Ordered {
    type: "put"
    walk: SaidName
    step: SaidName
    vote: number
    answered: boolean
  }

  /** Adds a walk from the instructor's own file, so that its questions can be asked. */
  interface HandWalk extends Ordered {
    type: "walk"
    name: SaidName
    text: string
  }

  /** Shows the lesson of the step to all and ends the vote. */
  interface ShowAnswer extends Ordered {
    type: "show"
  }

  /** Closes the vote without showing the answer: the question takes no more answers until the next vote on it. */
  interface CloseVote extends Ordered {
    type: "close"
  }

  /** Asks the followers how sure they are of their answers to the current question. */
  interface AskSure extends Ordered {
    type: "sure"
  }

  /** Starts a countdown for the current question, or adds seconds to a running one. At its end the vote closes if
   * `closes`. */
  interface CountDown extends Ordered {
    type: "countdown"
    seconds: number
    closes: boolean
  }

  /** Shows the hall an answer in words, with all answers equal to it, or removes them. */
  interface Moderate extends Ordered {
    type: "moderate"
    text: string
    shows: boolean
  }

  /** Withdraws the question, so that none is open. */
  interface Withdraw extends Ordered {
    type: "withdraw"
  }

  /** An answer as a class stores it, with its time in seconds since 1970 and the number of followers at that time. */
  interface Voted extends Given {
    at: number
    here: number
  }

  /** Restores answers that the server has lost, by the names in their followers' tokens; the instructor's page has
   * copies. Existing answers are not replaced. */
  interface RestoreAnswers extends Ordered {
    type: "restore"
    answers: Record<string, Voted>
  }

  /** Describes the instructor's screen for a remote control: the label of the button Next, the other active buttons,
   * and whether the screen is blank. */
  interface DescribeScreen extends Ordered {
    type: "screen"
    next: string
    blank: boolean
    deeds: Deed[]
  }

  /** Ends the class and deletes the room with all its answers. */
  interface EndRoom extends Ordered {
    type: "end"
  }

  type Order = RunClock | HandWalk | PutQuestion | ShowAnswer | CloseVote | AskSure | CountDown | Moderate | Withdraw | RestoreAnswers | DescribeScreen | EndRoom

  /** The result of a vote for the followers: the number of answers, of right ones, and of answers with each option or
   * feature. `judges`: answers can be right or wrong. */
  interface Split {
    answered: number
    right: number
    judges: boolean
    options: number[]
    having: number[]
  }

  /** The current question of the class: a step of a walk, its card, its position in the lecture, the number of the
   * vote from 1 on, and its lesson once the answer is shown.
   *
   * `closed`: the vote takes no more answers. `answered`: its answer was shown before and is hidden again. `sure`:
   * followers are asked how sure they are. `until` is the end of a countdown in ms of the server's time, 0 for none; if
   * `closes`, the vote closes at that time. `split` comes with the answer. If `step` is empty, there is no question. */
  interface PutTo {
    walk: string
    step: string
    card: StepCard | null
    place: string
    vote: number
    closed: boolean
    answered: boolean
    sure: boolean
    until: number
    closes: boolean
    lesson: Lesson | null
    split: Split | null
  }

  /** The picture of the instructor's page: a packed `Shown`, and the sheet with the dictionary for its compression. */
  interface SentPicture {
    sheet: string
    data: bytes
  }

  /** The changes in a room since the last news; a follower's first news has the complete state.
   *
   * `number` is the number of this state, `here` the number of followers, `answered` the number of answers to the
   * question. `lost`: the store that replicas share does not answer. `ended`: the class is over. Only the instructor's
   * page gets the `answers`, the `deed` of a remote control with its `step`, the notice that another computer leads now,
   * and all waiting `remotes`, by the two digits on their screens. */
  interface News {
    number: string
    picture: SentPicture | null
    clock: RunClock | null
    question: PutTo | null
    here: number | null
    answered: number | null
    lost: boolean | null
    ended: boolean
    answers: boolean
    deed: Deed | "" | "taken"
    step: string
    remotes: string[] | null
  }

  /** A room: its code, its key, which its instructor's browser keeps, and the address to join at, also as a QR code
   * (SVG). */
  interface Opened {
    code: string
    key: string
    address: string
    square: string
  }

  /** Opens the room of a code again, with its key, after a server has lost it; it may be repeated. `control` is the
   * proof that the page got when it admitted a remote control. */
  interface Reopen {
    control: string
  }

  /** One sketch, and its features. */
  interface SketchOf {
    curves: Record<string, Sketched>
    has: boolean[]
  }

  /** Equal answers in words: the newest of them, how many there are, and whether the instructor shows them. */
  interface WordGroup {
    text: string
    count: number
    shown: boolean
  }

  /** The answers to one vote: their number, the number for each option, the numbers or places on the axis of a point,
   * some hundreds of sketches, and the number of sketches with each feature. `sure` has for each of the three levels of
   * confidence the number of answers and of right ones; it is empty if nobody gave a level. `words` are the newest
   * groups of equal answers in words, without the removed ones. */
  interface Counted {
    answered: number
    options: number[]
    numbers: number[]
    sketches: SketchOf[]
    having: number[]
    sure: [number, number][]
    words: WordGroup[]
  }

  /** The answers to the current question, for the instructor. `before` is the first vote if there are two, `features`
   * the features of a right sketch, by name, `right` the number of right answers. */
  interface Tally {
    walk: string
    step: string
    vote: number
    now: Counted
    before: Counted | null
    features: Html[]
    right: number
  }

  /** The contents of a remote control: the current question, the number of followers, the counted answers without
   * single numbers and sketches, the lesson (also before the answer is shown), if the answers can be right or wrong, the
   * instructor's notes, and the instructor's screen. `number` is the number of the room's state. */
  interface RemoteView {
    number: string
    question: PutTo
    here: number
    tally: Tally | null
    lesson: Lesson | null
    judges: boolean
    notes: Html[]
    screen: DescribeScreen | null
  }

  /** The number of answers to a vote, and of right ones. */
  interface VoteSummary {
    vote: number
    answered: number
    right: number
  }

  /** The number of stored answers of a class, and of their questions. */
  interface Stored {
    answers: number
    questions: number
  }

  /** A question that a class has answered: its position in the walk, from 1 on, its votes, and the most frequent wrong
   * answer of the last vote with its count; "" if it does not fit into a few words. */
  interface StepSummary {
    walk: string
    step: string
    place: number
    question: Html
    votes: VoteSummary[]
    mistake: string
    mistaken: number
  }

  /** The entry of a follower: the normalised code, and the token under which answers are kept. */
  interface Entered {
    code: string
    token: string
  }

  /** A ticket for one remote control: its address, also as a QR code (SVG). The phone sends only the secret. */
  interface Ticket {
    address: string
    square: string
  }

  /** A waiting remote control: its two digits, and the key that is valid once the instructor has admitted it. */
  interface Paired {
    digits: string
    key: string
  }

  /** Requests a word with which another computer can take over the class; it then opens the page of this link. `shown`
   * has
   * the number of the vote whose answer the class has seen, by question. */
  interface HandOver {
    query: string
    shown: Record<string, number>
  }

  /** Takes the lead of a class with such a word, which is valid once. */
  interface TakeOver {
    word: string
  }

  /** A room that another computer led: the link of its page, the answers that the class saw, the walks from files by
   * their names, and the saved state of the remote control. */
  interface TakenOver extends Opened {
    query: string
    shown: Record<string, number>
    walks: Record<string, string>
    control: string
  }

  /** Admits a remote control by the digits that the instructor has seen on the phone. */
  interface Confirmed {
    digits: string
  }

  /** A press of a button on a remote control; `step` is the step to open, `text` the answer to allow or remove. The
   * first `end` asks the instructor to confirm, the second ends the class. */
  interface Done {
    deed: Deed
    step: SaidName
    text: string
  }

  /** A step in the list of steps of a remote control. */
  interface Listed {
    step: string
    title: Html
  }

  /** An axis as drawn: coordinates are numbers in units of `factor` (SI) times 10**exponent, raised to `power`, or
   * their logarithms to base ten. */
  interface Ruler {
    start: number
    end: number
    ticks: number[]
    labels: string[]
    unit: string
    exponent: number
    factor: number
    power: number
    log: boolean
  }

  /** Simulated seconds per real second: at the speed Auto, and the highest at which the motion can still be seen. */
  interface Pace {
    auto: number
    limit: number | null
  }

  /** The format of a moving number: its decimals, and if its sign is always shown. */
  type Digits = [decimals: number, signed: boolean]

  /** The progress of a measurement: `done` of `total`, counted in `unit`. */
  interface Progress {
    state: "idle" | "waiting" | "running" | "done"
    done: number
    total: number
    unit: string
    text: string
  }

  /** A column: the name of the axis that it is drawn on, and how many numbers it has. */
  type Drawn = [axis: string, count: number]

  /** Signals that are drawn over time, at `count` equally spaced instants from 0 to `end`. They are the column t and
   * columns of these names; `signals` maps a column to a signal with another name. */
  type Trace = [end: number, count: number, names: string[], signals: Record<string, string>]

  /** A link to another scene: the values that it sets (`given`), and its parameters with those of this scene whose
   * values they take (`taken`). */
  interface Onward {
    label: string
    scene: string
    given: Record<string, number | string>
    taken: Record<string, string>
  }

  /** A picture for the browser.
   *
   * `columns`   the columns by source and name; their numbers are bytes after the message, before samples of `signals`
   * `axes`      the axes by name; `time` is the name of the time axis, "" if nothing moves
   * `signals`   the moving numbers by name; each may use the ones before it
   * `traces`    for each source, the signals that are drawn over time
   * `scalars`   numbers that shapes and marks use
   * `values`    texts of live numbers, by name; `live` has the format of the moving ones, by signal
   * `forms`     the current variant of a formula or sentence, by name; "" hides it
   * `notes`     what the visitor must know about this picture
   * `onward`    links to scenes that show the same system for these values
   * `left_out`  the quantities that are not sent because they are hidden; shapes that need one are not drawn */
  interface PagePicture {
    columns: Record<string, Record<string, Drawn>>
    axes: Record<string, Ruler>
    time: string
    pace: Pace
    signals: Record<string, AnySignal>
    traces: Record<string, Trace>
    scalars: Record<string, number>
    values: Record<string, string>
    live: Record<string, Digits>
    forms: Record<string, string>
    notes: string[]
    onward: Onward[]
    left_out: string[]
  }

  /** A number of the compared picture and of the current one, in `unit`, and the change; "?" means hidden. */
  interface LedgerRow {
    symbol: Html
    tint: string
    held: string
    now: string
    unit: string
    ratio: string
    same: boolean
  }

  /** The compared picture, on the axes of the current one: only its drawn curves, and only where they differ.
   *
   * Its numbers follow the numbers of the view. `signals` and `scalars` are for its `traces` and for draggable shapes on
   * the stage, `values` the numbers of the sliders that have changed since, `ledger` the compared numbers. */
  interface Held {
    columns: Record<string, Record<string, Drawn>>
    signals: Record<string, AnySignal>
    traces: Record<string, Trace>
    scalars: Record<string, number>
    values: Record<string, number | null>
    ledger: LedgerRow[]
  }

  /** A value with a name under its slider. */
  interface NamedValue {
    value: number
    text: string
  }

  /** A slider with its field: `label` is its name without the unit, `soft` its range; `says` is help text that
   * continues the symbol: "m is the mass". */
  interface SliderRow {
    kind: "slider"
    name: string
    symbol: string
    label: string
    unit: string
    tint: string
    scale: "linear" | "log" | "near0" | "count"
    soft: [number, number]
    says: string
    marks: NamedValue[]
  }

  /** A choice: joined buttons, or small pictures made of the shapes of a stage, by value. */
  interface ChoiceRow {
    kind: "choice"
    name: string
    label: string
    options: Option[]
    pictures: Record<string, AnyShape[]>
  }

  type ControlRow = SliderRow | ChoiceRow

  /** A button that makes the server set several parameters; if `place`, it shows when the scene has these values. */
  interface ActionButton {
    name: string
    label: string
    place: boolean
  }

  /** Controls that belong together; a section without a title continues the one before. `facts` are rows of cells.
   *
   * A folded section opens on request, or if one of its values is not the default. It is visible while the picture has
   * the form `form`. */
  interface GroupSection {
    title: string
    hint: string
    rows: ControlRow[]
    actions: ActionButton[]
    folded: boolean
    form: string
    dense: boolean
    facts: Html[][]
  }

  /** A preset: its label, the parameters that it sets, its outline (SVG path data in a box of 128 by 46, or none), and
   * a sentence on what to watch.
   *
   * It sets every parameter that any preset of the scene sets; other parameters keep their values. */
  interface PresetButton {
    name: string
    label: string
    sets: Record<string, Value>
    outline: string
    watch: string
  }

  /** All controls of a scene; `start` is the title above the presets. A folded list of presets opens on request. */
  interface Panel {
    start: string
    folded: boolean
    presets: PresetButton[]
    groups: GroupSection[]
  }

  /** The state of a parameter's control: its value (in its own unit) and the text of its field.
   *
   * `unit` is the unit of display and input, `size` its size in the parameter's own unit; `changed`: not the default. */
  interface Setting {
    value: number | string | null
    text: string
    unit: string | null
    size: number
    soft: [number, number] | null
    changed: boolean
  }

  /** The fields that all blocks have.
   *
   * `part` is the block's name in links and walks: stage, plot:x, words:why, table. A block without `views` is in all of
   * them. `grow` and `basis` divide the height (in a column) or the width (in a row). `phone` is its position from top
   * to bottom on a narrow screen and `height` its height there. It is visible while the picture has the form `form`.
   * `hall`, if set, shows it only with (or only without) the large type of hall mode. */
  interface Part {
    part: string
    views: string[]
    grow: number
    basis: number
    phone: number | null
    height: number | null
    form: string
    hall: boolean
    style: string
  }

  /** Blocks side by side. */
  interface Row extends Part {
    kind: "row"
    blocks: Block[]
    gap: number
  }

  /** Blocks below each other. */
  interface Column extends Part {
    kind: "column"
    blocks: Block[]
    gap: number
  }

  /** The animated drawing of a scene; `label` describes it for screen readers. Alone in a row, it is at most `widest`
   * times as wide as high. */
  interface StageBlock extends Part {
    kind: "stage"
    shapes: AnyShape[]
    label: string
    widest: number
  }

  /** Sentences and formulas. */
  interface WordsBlock extends Part {
    kind: "words"
    items: Forms[]
  }

  /** Rows of cells with column headings; the first cell of a row is its name. */
  interface TableBlock extends Part {
    kind: "table"
    head: Html[]
    rows: Forms[][]
  }

  /** A value of a choice: its word in links, and its label. */
  interface Option {
    value: string
    label: string
  }

  /** Joined buttons for the options of the parameter `name`. */
  interface ChoiceBlock extends Part {
    kind: "choice"
    name: string
    label: string
    options: Option[]
  }

  /** Buttons with the mode shapes of the modal signal `of`; if there are many modes, only of the strongest.
   *
   * Each button sets the parameter `name` to the number of its mode, and the values in `sets`. If only one mode moves,
   * the picture's text `chosen` is its number. */
  interface ModesBlock extends Part {
    kind: "modes"
    name: string
    label: string
    of: string
    chosen: string
    sets: Record<string, string>
  }

  /** A part of a visitor's measured record: the file, the numbers of its fit, or the residuals of the column `column`
   * below the plot `plot` with its points. `examples` maps the names of files that are ready to their addresses. */
  interface MeasuredBlock extends Part {
    kind: "measured"
    shows: "file" | "fit" | "residuals"
    plot: string
    column: string
    examples: Record<string, string>
  }

  /** A plot: `x` and `y` name axes of the picture, `title` is its text alternative, `brief` its name in a list.
   *
   * `time`: its abscissa is time, and the visitor can drag the time cursor. `square`: both axes have the same scale.
   * `plain`: no numbers at the axes. `shapes` are drawn over it as on a stage. A press near a point of a curve sets the
   * list `pick` to its source and its index in the column. `room` is the margin around the frame; labels and handles are
   * placed with it before the figure is loaded. `modal`: a signal whose masses are drawn under the curves, one column
   * each, with time downwards and colours for displacements; the scalar `full` is the displacement with the full colour.
   * `says` maps names to texts with {live numbers} that a screen reader reads with the title and after a change. */
  interface PlotBlock extends Part {
    kind: "plot"
    name: string
    title: string
    says: Record<string, string>
    brief: string
    x: string
    y: string
    curves: Curve[]
    regions: Region[]
    heading: Term[]
    handles: Handle[]
    marks: Mark[]
    shapes: AnyShape[]
    room: Room
    x_labels: boolean
    cursor: boolean
    time: boolean
    square: boolean
    plain: boolean
    pick: string
    modal: string
    full: string
    figure: Record<string, unknown>
  }

  type Block = Row | Column | StageBlock | WordsBlock | TableBlock | ChoiceBlock | ModesBlock | MeasuredBlock | PlotBlock

  /** The margins of the frame of a plot, in pixels: for numbers at the left and below, labels at the right, flags
   * above. */
  interface Room {
    left: number
    right: number
    top: number
    bottom: number
  }

  /** A line: column `y` of `source` over its column `x`, in the colour of the quantity `tint`.
   *
   * `signal` moves a dot along it (with `signal_x` as its abscissa if that is not time). `label` is at its right end and
   * in the tooltip, `read` only in the tooltip. Curves of one `group` are switched on and off together. `marker` marks
   * its points;
   * with width "none" only the markers are drawn. In a group drawn as a band, its label is at the band's middle. */
  interface Curve {
    source: string
    x: string
    y: string
    group: string
    tint: string
    width: "sum" | "line" | "dash" | "dots" | "thin" | "none"
    label: Runs
    read: string
    signal: string
    signal_x: string
    marker: "" | "disc" | "ring"
  }

  /** A filled band between the columns `low` and `high`: the envelope of the curve `of`, or a layer of a stack. */
  interface Region {
    source: string
    x: string
    low: string
    high: string
    tint: string
    alpha: number
    group: string
    of: string
    label: Runs
    read: string
  }

  /** A handle on an axis that sets a parameter, to at least `least`.
   *
   * It shows `symbol` and the parameter's number, or the value called `text`, then `unit`. `covering`: it hides the unit
   * of the axis behind it. `bare`: it has no pill; a press on the plot moves it. It is visible while the picture has the
   * form `form`. `whole`: it sets whole numbers. */
  interface Handle {
    parameter: string
    label: string
    symbol: string
    tint: string
    axis: "x" | "y"
    least: number | null
    text: string
    unit: string
    covering: string
    form: string
    bare: boolean
    whole: boolean
  }

  /** A line with a flag across the plot at the scalar `at`, a coordinate of the axis.
   *
   * The flag is a button. It does the action `act`, or sets the parameter `set` to the scalar `exactly` if given, else
   * to the value at its position. `lift` is its height above the frame, `shift` its offset to the right, in pixels. */
  interface Mark {
    at: string
    tint: string
    html: Html
    label: string
    set: string
    exactly: string
    act: string
    axis: "x" | "y"
    style: string
    flag: string
    lift: number | null
    shift: number
  }

  /** One term of the heading: a formula or words by form, a sample of the line, and the switch of the group `curve`.
   *
   * `form` names the picture's form that chooses the variant; the default is the variant "formula". */
  interface Term {
    variants: Record<string, Html>
    curve: string
    form: string
    key: "sum" | "line" | "dash" | "band" | "none"
    tint: string
  }

  type Anchor = "start" | "middle" | "end" | "beside"

  type Side = "left" | "right" | "top" | "bottom"

  /** A rule for dragging: computes the value of `parameter` ("" for none) from the position of the pointer ("the
   * hand"). `size` is the unit of the parameter in SI.
   *
   * `moves` is the signal or scalar, on `axis` ("" for none), that follows the hand at once, before the server answers.
   * A throw adds its velocity to the initial value of the parameter `rate`. */
  interface Way {
    parameter: string
    moves: string
    axis: string
    size: number
    rate: string
  }

  /** A rule for a drag along a line: 0 is at the pixel `zero`, and one unit of the axis is `unit` pixels, to the right
   * or down. The drag is limited to `least` to `most`, both in SI. */
  interface Stretch extends Way {
    across: "x" | "y"
    zero: Number
    unit: Number
    least: number | null
    most: number | null
  }

  /** Sets the parameter to the value at the position of the hand. */
  interface Along extends Stretch {
    kind: "along"
  }

  /** Sets the parameter to `share` times the position of the hand, plus the signal `rest`. */
  interface Share extends Stretch {
    kind: "share"
    share: Number
    rest: string
  }

  /** Sets the parameter to the value of `over`, divided by the position of the hand. */
  interface Quotient extends Stretch {
    kind: "quotient"
    over: string
  }

  /** Sets z by dragging a root of s^2 + 2 z s + 1. With p, its distance to the left of the imaginary axis, z
   * is p on the circle, and (p + 1/p)/2 on the real axis: for p > 1, or if `real`. */
  interface Root extends Stretch {
    kind: "root"
    real: boolean
  }

  /** A rule for a shape that oscillates: the position of the hand, times `counted`, becomes a turning point of a sine.
   * The value is
   * its amplitude or, by `of`, its phase in rad. The dragged shape moves by `share` of the sine. A throw gives it a
   * velocity; `turn` is the signal with the argument of the sine. */
  interface Swung extends Stretch {
    kind: "swung"
    of: "amplitude" | "phase"
    counted: Number
    share: Number
    turn: string
  }

  /** A rule for a drag around a point (x, y): the angle in rad, from straight down, counted anticlockwise. 0 is at
   * `zero`, and one
   * unit is `unit` rad. `tall` is height over width, for a circle seen from the side. */
  interface Turn extends Way {
    kind: "turn"
    x: Number
    y: Number
    zero: number
    unit: number
    tall: number
  }

  /** A rule that exchanges height for speed without loss. It sets the excess of speed over level flight from a height;
   * `head` is the height v_0^2/g. The height is limited by the speed. */
  interface Trade extends Way {
    kind: "trade"
    zero: Number
    unit: Number
    head: string
  }

  /** A rule for dragging a root s of P(s) = A(s) + u B(s) + u^2 C(s). It sets `base` + `slope` u, with the u >= 0 for
   * which
   * |P| is least at the hand.
   *
   * `terms` are the coefficients of A, B and C, constants first. The point s = 0 is at (`x`, `y`). One unit of the plane
   * is `right` pixels to the right, or `down` pixels downwards, a negative number. The search for u starts at `now`. */
  interface ChainRoot extends Way {
    kind: "chain_root"
    x: Number
    y: Number
    right: Number
    down: Number
    terms: [Number[], Number[], Number[]]
    base: Number
    slope: Number
    now: Number
  }

  /** A rule for a drag along the curve of a response in the complex plane, A(s) over the product of all s - p, at s =
   * i w, w >= 0.
   * It sets `unit` times w; the rules after it use the nearest point on the curve.
   *
   * `above` are the coefficients of A, constants first, and `poles` the real and imaginary parts of each p. The point 0
   * is at (`x`, `y`). One unit of the plane is `right` pixels to the right, or `down` pixels downwards, a negative
   * number. The current w is `now`. */
  interface Locus extends Way {
    kind: "locus"
    x: Number
    y: Number
    right: Number
    down: Number
    above: Number[]
    poles: [Number, Number][]
    unit: Number
    now: Number
  }

  type AnyWay = Along | Share | Quotient | Root | Swung | Turn | Trade | ChainRoot | Locus

  /** An initial condition taken from the motion when a drag begins: `parameter` takes the current value of the signal
   * `of` on `axis`, or 0.
   * `exactly`: with all digits, so that the motion continues. `angle`: in rad, without whole turns. */
  interface Begin {
    parameter: string
    of: string
    axis: string
    size: number
    exactly: boolean
    angle: boolean
  }

  /** The response of a shape to dragging: the values that it sets; `label` names it for a screen reader.
   *
   * If it `begins` a motion, time stops, the current positions become the initial conditions (`start`), and the release
   * plays the motion. The hand
   * cannot leave the frame of the plot `inside`. */
  interface Grab {
    label: string
    ways: AnyWay[]
    begins: boolean
    start: Begin[]
    inside: string
  }

  /** The fields that all shapes have.
   *
   * `tint` is the class of a colour, `style` are more classes. A shape is drawn if the picture has all the scalars
   * `show`, none of them 0. The frame of the plot `inside` cuts it off. `grab` is its response to dragging. Of a
   * compared picture, only shapes that begin a motion, or with `held`, are drawn. */
  interface Look {
    tint: string
    style: string
    show: string[]
    inside: string
    grab: Grab | null
    held: boolean
  }

  /** A zigzag of nine teeth between two points. Its pitch shows the stretch, the width of the wire the stiffness. */
  interface Spring extends Look {
    kind: "spring"
    x1: Number
    y1: Number
    x2: Number
    y2: Number
    wire: Number
    height: Number
  }

  /** A square mass, given by the middle of its lower edge; `corner` puts its label above it, to the left. */
  interface Box extends Look {
    kind: "box"
    x: Number
    y: Number
    side: Number
    label: Runs
    corner: boolean
  }

  /** A straight line. */
  interface Line extends Look {
    kind: "line"
    x1: Number
    y1: Number
    x2: Number
    y2: Number
  }

  /** An arrow with a head of `head` pixels, shifted by `gap` along its direction. */
  interface Arrow extends Look {
    kind: "arrow"
    x1: Number
    y1: Number
    x2: Number
    y2: Number
    head: Number
    gap: Number
  }

  /** A disc or, by its style, a ring. */
  interface Circle extends Look {
    kind: "circle"
    x: Number
    y: Number
    r: Number
  }

  /** A fixed outline (SVG path data), moved to (x, y), scaled by (sx, sy) and turned by `turn` rad, clockwise on the
   * screen, or so that its right end points along (dx, dy). */
  interface Path extends Look {
    kind: "path"
    d: string
    x: Number
    y: Number
    turn: Number
    dx: Number
    dy: Number
    sx: Number
    sy: Number
  }

  /** Part of a circle, between two angles in rad from straight down, counted to the right (anticlockwise). */
  interface Arc extends Look {
    kind: "arc"
    x: Number
    y: Number
    r: Number
    start: Number
    end: Number
  }

  /** A sine wave, size sin(2 pi turns s + phase) upwards, over a length from (x, y); with `depth`, filled down to
   * there. */
  interface Wave extends Look {
    kind: "wave"
    x: Number
    y: Number
    length: Number
    size: Number
    turns: Number
    phase: Number
    depth: Number
  }

  /** `count` slices of a medium from (x, y) to the right; their edges are displaced along it by size sin(2 pi turns
   * s). */
  interface Layers extends Look {
    kind: "layers"
    x: Number
    y: Number
    length: Number
    height: Number
    count: number
    size: Number
    turns: Number
  }

  /** Text on the stage. With the anchor `beside`, a text over a plot is to the right or left of its point, where it
   * covers no lines. */
  interface Label extends Look {
    kind: "text"
    x: Number
    y: Number
    words: Runs
    anchor: Anchor
  }

  /** A hatched wall; (x, y) is its upper or left end, `side` the solid side, `depth` the size of its hatching. */
  interface Wall extends Look {
    kind: "wall"
    x: Number
    y: Number
    length: Number
    side: Side
    depth: Number
  }

  /** The masses of the modal signal `of` on their springs.
   *
   * The line from (x, y) to the right has `parts` equal parts; at rest, mass p is `first` + p - 1 parts from its start.
   * One unit
   * of its displacement, less the `drift` of all masses, is `across` pixels up or `along` pixels to the right. Springs
   * lead to the walls `left` and `right` unless these are 0. Masses displaced by more than `least` have the colour of
   * their side. While `picks` is not 0, the signal `at` becomes the mass at the pointer. */
  interface Beads extends Look {
    kind: "beads"
    of: string
    count: Number
    x: Number
    y: Number
    length: Number
    first: Number
    parts: Number
    across: Number
    along: Number
    left: Number
    right: Number
    least: Number
    drift: Number
    at: string
    picks: Number
  }

  type AnyShape = Spring | Box | Line | Arrow | Circle | Path | Arc | Wave | Layers | Label | Wall | Beads

  /** Base of all signals. */
  interface Signal {
  }

  /** A damped sine, (size + slope t) exp(-decay t) sin(omega t + phase); an exponential has omega = 0 and phase =
   * pi/2. */
  type Sine = [size: number, omega: number, phase: number, decay: number, slope: number]

  /** A sum of sines and a + b t; line = (a, b). */
  interface Sines extends Signal {
    kind: "sines"
    sines: Sine[]
    line: [number, number]
  }

  /** Response from rest, size g(t) with g'' + omega_n^2 g = sin(omega t); regular at resonance and at omega_n = 0. */
  type Response = [size: number, omega: number, omega_n: number]

  /** A sum of responses to a drive. */
  interface Responses extends Signal {
    kind: "responses"
    responses: Response[]
  }

  /** The free motion of a damped mass, or its rate: exp(-slow t) (start C + rate S).
   *
   * C = cos(swing t), S = sin(swing t)/swing if underdamped; else C = 1, S = (1 - exp(-apart t))/apart, and S = t at
   * critical damping. For apart t > 1 it is computed as a sum of both exponentials with the amplitudes `late`. */
  interface DampedMass extends Signal {
    kind: "damped"
    start: number
    rate: number
    slow: number
    apart: number
    swing: number
    late: [number, number]
  }

  /** The motion of a damped mass from rest, Im((re + i im) E), E'' + (2 slow + apart) E' + omega_n^2 E = exp(i omega
   * t): regular at resonance, at critical damping and for zero damping.
   *
   * `slow`, `apart` and `swing` are the rates of its free motion, `detuning` is omega - swing. */
  interface DrivenMass extends Signal {
    kind: "driven"
    re: number
    im: number
    omega: number
    omega_n: number
    slow: number
    apart: number
    swing: number
    detuning: number
  }

  /** The motion of a chain of equal masses as the sum of its modes; its value is the displacement of the mass `at`, a
   * signal before it.
   *
   * Mode j has sizes[j] sin(omega[j] t + phases[j]) times its orthonormal shape, which follows from the number of modes
   * and the `ends`; `line` = (a, b) adds a + b t to all. Mass p = 1, 2, ... has the displacement called `name` and its
   * number, x3. If `by` is not 0, all displacements are proportional to the scalar `of`, whose value here is `by`. */
  interface Modal extends Signal {
    kind: "modal"
    name: string
    ends: "fixed-fixed" | "fixed-free" | "free-free"
    omega: number[]
    sizes: number[]
    phases: number[]
    at: string
    of: string
    by: number
    line: [number, number]
  }

  /** A polynomial in earlier signals. */
  interface Derived extends Signal {
    kind: "derived"
    value: Expression
  }

  /** The sine of an earlier signal, an angle in rad. */
  interface SineOf extends Signal {
    kind: "sine"
    of: string
  }

  /** The cosine of an earlier signal, an angle in rad. */
  interface CosineOf extends Signal {
    kind: "cosine"
    of: string
  }

  /** Samples that follow the JSON of their message: their count, minimum and maximum. */
  interface Samples {
    count: number
    low: number
    high: number
  }

  /** A periodic motion from equally spaced values and slopes over one period, with Hermite interpolation; `drift` is
   * added each period. */
  interface Sampled extends Signal {
    kind: "sampled"
    period: number
    y: number[] | Samples
    dy: number[] | Samples
    drift: number
  }

  type AnySignal = Sines | Responses | DampedMass | DrivenMass | Modal | Derived | SineOf | CosineOf | Sampled

  /** A coefficient times named quantities. */
  type Product = [factor: number, names: string[]]

  /** A sum of products of named quantities: signals, scalars, W and H, the frames of plots.
   *
   * An operator returns NotImplemented for other types, so that they can define the reflected one. */
  interface Expression {
    terms: Product[]
  }

  /** A number of a shape: fixed, or computed for every frame. */
  type Number = number | Expression

  /** HTML made by components.layout.text from the texts of this project; live numbers are elements with `data-value`. */
  type Html = string

  /** A piece of a text in a drawing: plain, the symbol of a quantity, its index, or the live number of that name. */
  interface TextRun {
    kind: "plain" | "symbol" | "index" | "value"
    text: string
  }

  type Runs = TextRun[]

  /** A sentence in several forms: the picture's form called `name` chooses the variant, "" for no sentence.
   *
   * If `name` is empty, the variant "" is always visible. */
  interface Forms {
    variants: Record<string, Html>
    name: string
  }
}
