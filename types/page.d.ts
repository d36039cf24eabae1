// Written by `make protocol` from components/language; a change there is a change here.

declare namespace page {
  type SaidName = string

  type Text = string

  /** In thousandths of the frame, from its foot. */
  type Height = number

  /** A sketched curve: its heights, null where there is a gap. */
  type Sketched = (Height | null)[]

  /** An answer to a step of a walk: an option by its place, the text of a number, a place on the axis, or curves by
   * name.
   *
   * `seed` is that of the step's numbers, 0 for those of its file; `vote` counts how often the question has been put to
   * a class, from 1 on; `sure` is how sure of it somebody is: 1 for a guess, 2 for fairly, 3 for certain, 0 if not said. */
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

  /** Anything that the browser says. */
  interface FromBrowser {
    number?: number
  }

  /** Sets quantities by name, in SI: from sliders and handles.
   *
   * While a hand is `holding` on to what is drawn, the axes that it moves `along` and the scale of the stage stay; the
   * others grow. When it has let go, or a slider or key has, an axis that is hardly used is fitted again, but none that
   * the hand moved `along`. Without `holding` a value is on its way. */
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

  /** Presses a button, which does its action. */
  interface Act extends FromBrowser {
    type: "act"
    name: SaidName
  }

  /** Sets a choice by its word, or a list by its words. */
  interface Choose extends FromBrowser {
    type: "choose"
    name: SaidName
    value: Text | SaidName[]
  }

  /** Starts or ends the measurement of a scene that measures. */
  interface RunOrder extends FromBrowser {
    type: "run"
    order: "start" | "cancel" | "skip"
  }

  /** Puts the session into a state; another scene then has what it shares with those before, where that is asked to be
   * `carried`. In a picture that is to be compared with the one that stands, other quantities of one scene, the frame
   * that stands `keeps` its place. */
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

  /** Has this session alone run a walk from the text of its file. */
  interface RunWalk extends FromBrowser {
    type: "walk"
    name: SaidName
    text: string
  }

  /** Sends all that is shown from now on to those who follow the class of this code; the room knows the key. */
  interface Lead extends FromBrowser {
    type: "lead"
    code: string
    key: SaidName
  }

  /** Asks for the numbers of all plots as CSV; `page` is the address that their link begins with. */
  interface AskCsv extends FromBrowser {
    type: "csv"
    page?: Text
  }

  /** Asks for the known errors of the numbers that are drawn. */
  interface AskAbout extends FromBrowser {
    type: "about"
  }

  type Said = SetValues | Typed | Act | Choose | RunOrder | Open | GiveAnswer | RunWalk | Lead | AskCsv | AskAbout

  /** Anything that the browser is told; `answer` is the number of the message that it answers. */
  interface Told {
    answer: number | null
  }

  /** The page as it now is.
   *
   * `sheet` is the address of the scene's sheet, `held` the picture held beside it, `settings` what the controls show by
   * parameter, `preset` names the one in force, `here` the places where the scene is, `errors` what was refused of the
   * last message by parameter, `problems` what was refused of a link, `query` the link of this state. */
  interface Shown extends Told {
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

  /** The answer to letting go if the page does not change. */
  interface Kept extends Told {
    type: "kept"
  }

  /** A file to keep, and its media type. */
  interface File extends Told {
    type: "file"
    name: string
    kind: string
    content: bytes
  }

  /** One number in twenty digits: as drawn, as it truly is, and how far off in ulp. */
  interface AboutPoint {
    name: Html
    place: Html
    drawn: string
    true: string
    off: string
  }

  /** Points under the sentence that bounds their errors. */
  interface AboutTable {
    bound: Html
    rows: AboutPoint[]
  }

  /** The known errors of the numbers that are drawn. */
  interface AboutNumbers extends Told {
    type: "about"
    reading: Html
    tables: AboutTable[]
    notes: Html[]
  }

  /** The lesson of a step, in answer to what was given; `refused` says why there is none, `is_busy` that others come
   * first: it may be asked again. */
  interface Taught extends Told {
    type: "taught"
    walk: string
    step: string
    lesson: Lesson | null
    refused: string
    is_busy: boolean
  }

  /** A walk that this session runs; `refused` says what is wrong with its file, `is_busy` that others come first. */
  interface Walking extends Told {
    type: "walking"
    sheet: WalkSheet | null
    refused: string
    is_busy: boolean
  }

  type ToldAny = Shown | Kept | File | AboutNumbers | Taught | Walking

  /** A link to another scene: what is `given`, and the parameters of this scene that are taken along. */
  interface Onward {
    label: string
    scene: string
    given: Record<string, string>
    taken: string[]
  }

  /** A view of a scene: its name in links, the name on its tab, its task, and the parameters whose controls are the
   * first of the panel. */
  interface ViewTab {
    word: string
    name: string
    task: Html
    keys: string[]
  }

  /** All that the browser must know of a scene once, the same for every visitor: an immutable file.
   *
   * Messages about the scene are deflated with `usual` before them, which they refer to. `hidden` are the curves that it
   * opens without, `spoken` the numbers that are read aloud after a change: by what they are called, texts with {live
   * numbers}. A scene without `views` always shows its whole paper; the parameter `view` says which one is shown. */
  interface SceneSheet {
    slug: string
    title: string
    headline: string
    hidden: string[]
    runs: boolean
    about: boolean
    onward: Onward[]
    usual: string
    spoken: Record<string, string>
    views: ViewTab[]
    paper: Block
    panel: Panel
  }

  /** A quantity in SI (None: the scene's own choice), the word of a choice, or a list of words. */
  type Value = number | string | string[] | null

  /** A frame for a picture: the ranges of its axes by name, its time window in s, the scale of its stage, and its
   * speed, simulated over real seconds. One that came with a link is `given`: no hand that lets go fits it anew. */
  interface Frame {
    ranges: Record<string, [number, number]>
    window: number | null
    scale: number | null
    speed: number | null
    given: boolean
  }

  /** All that a page stands for: a scene, its parameters that are not at their defaults, its frame where it is not the
   * fitted one, the parameters held for comparison, the plots and values covered, the parameters from before the change
   * to be predicted, the hidden curves where they are not the scene's own, the step of a walk: "d34/d34-07", and
   * "d34/d34-07/5" where its numbers have a seed, and the parts to show in place of those of its view. */
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
   * `place` says where in the lecture it is, `given` stands over the question, `options` are the answers of a choice,
   * shown in another order unless they are `fixed`, none of them right in a `poll`, `unit` is that of a number; `plot`
   * is where a point is marked or a sketch drawn, `axis` the one of the point, `curves` what is drawn, by name, and
   * `frame` the axes x and y of a sketch that a class shares. `opens` is the state that the question is asked of,
   * `reveals` the one of the answer, where the parameters in `controls` may be moved. The `core` steps make a shorter
   * walk. A step with `derive` shows how its answer follows by one more press; a vote on one that `closes` is closed at
   * the end of a countdown. `variants` are cards of its question with other numbers, under the seeds from 1 on. */
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

  /** A walk from its first step to its last, and the sentences on what it has shown. */
  interface WalkSheet {
    name: string
    title: string
    steps: StepCard[]
    end: Html[]
  }

  /** The verdict on one answer of a choice: its sentence, and the state of a case of which that speaks, if any. */
  interface Verdict {
    right: boolean
    reply: Html
    where: State | null
  }

  /** A feature that a sketch has or misses: its name, what is said of it, and where in the plot it is, in places of
   * its axes. */
  interface Finding {
    has: boolean
    name: Html
    words: Html
    at: [number, number] | null
  }

  /** The lesson of a step, told once it has been answered.
   *
   * `right` is None where nothing was answered; `reply` is the sentence of the answer given, `where` the state of a case
   * of which it speaks; `verdicts` are those of the options, `findings` those of a sketch, `truth` the right number or
   * places; `places` has them in the unit of the
   * number, or on the axis of the point. `shows` is the state of the answer where that is not the card's `reveals`. */
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
  type Deed = "next" | "back" | "show" | "votes" | "derive" | "again" | "poll" | "sure" | "countdown" | "closing" | "blank" | "close" | "go" | "end"

  /** Anything that the instructor's page asks of the room. */
  interface Ordered {
  }

  /** Sets the class's clock: the lecture's stood at `t` at the server's time `at`, in ms, and goes on by `rate` a
   * second, up to `end`: in the unit of the time axis. */
  interface RunClock extends Ordered {
    type: "clock"
    t: number
    rate: number
    end: number
    at: number
  }

  /** Puts the question of a step to all; where `vote` is given, as that vote: one more than before, or the last one of
   * a question that comes back. A vote that was `answered` takes no more answers: the class has seen the answer. */
  interface PutQuestion extends Ordered {
    type: "put"
    walk: SaidName
    step: SaidName
    vote: number
    answered: boolean
  }

  /** Hands in a walk from the instructor's own file, whose questions can be put from now on. */
  interface HandWalk extends Ordered {
    type: "walk"
    name: SaidName
    text: string
  }

  /** Shows all the lesson of the step; no answer is taken any more. */
  interface ShowAnswer extends Ordered {
    type: "show"
  }

  /** Closes the vote: no answer is taken until the question is put as another vote. Nothing is shown. */
  interface CloseVote extends Ordered {
    type: "close"
  }

  /** Asks of those who answer the question that is put how sure they are. */
  interface AskSure extends Ordered {
    type: "sure"
  }

  /** Counts down for the question that is put: so many seconds, or so many more where it counts already. At 0 the vote
   * `closes`, or the count just ends. */
  interface CountDown extends Ordered {
    type: "countdown"
    seconds: number
    closes: boolean
  }

  /** Withdraws the question: none is open. */
  interface Withdraw extends Ordered {
    type: "withdraw"
  }

  /** An answer as a class keeps it: when it was given, in seconds since 1970, and how many were here. */
  interface Voted extends Given {
    at: number
    here: number
  }

  /** Gives back answers that the server has lost, by the names in the tokens of those who gave them: the
   * instructor's page keeps them. None takes the place of one that is there. */
  interface RestoreAnswers extends Ordered {
    type: "restore"
    answers: Record<string, Voted>
  }

  /** Describes the instructor's screen for a remote control: the words of the next press, the other buttons that do
   * something now, and whether the screen is blank. */
  interface DescribeScreen extends Ordered {
    type: "screen"
    next: string
    blank: boolean
    deeds: Deed[]
  }

  /** Ends the class: the room and all that was answered are forgotten. */
  interface EndRoom extends Ordered {
    type: "end"
  }

  type Order = RunClock | HandWalk | PutQuestion | ShowAnswer | CloseVote | AskSure | CountDown | Withdraw | RestoreAnswers | DescribeScreen | EndRoom

  /** The answers to a vote for those who gave them: how many, how many are right, how many chose each option or have
   * each of the features asked for. It `judges` where answers are right or wrong. */
  interface Split {
    answered: number
    right: number
    judges: boolean
    options: number[]
    having: number[]
  }

  /** The question that is put: a step of a walk, its card, its place in the lecture, the vote from 1 on, and what it
   * teaches once the answer is shown; a vote that is `closed` takes no answers; one that was `answered` had its answer
   * shown, which is hidden again; `sure` asks how sure an answer is; a countdown ends at the
   * server's time `until`, in ms, if it is not 0, and then the vote `closes` or does not; `split` comes with the answer.
   * Without a step none is. */
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

  /** The picture of the instructor's page: a packed `Shown` and the sheet whose usual text it refers to. */
  interface SentPicture {
    sheet: string
    data: bytes
  }

  /** The changes in a room since the last news; the first that a follower hears has all of it.
   *
   * `number` is this state's, `here` says how many follow, `answered` how many have answered the question, `lost` that
   * the store which replicas share does not answer, `ended` that the class is over. The instructor's page alone hears of
   * `answers` given, of the `deed` of a remote control, with the `step` that it is to go to, or that the lead was taken
   * over, and of all `remotes` that wait to be let in, by the two digits that each shows. */
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

  /** Opens the room of a code anew, with its key, where a server has lost it: as often as it is asked for. `control`
   * is what the page was told when it let a remote control in. */
  interface Reopen {
    control: string
  }

  /** One sketch and which of the features asked for it has. */
  interface SketchOf {
    curves: Record<string, Sketched>
    has: boolean[]
  }

  /** The answers to one vote: how many, of each option, as numbers or places on the axis of a point, as sketches: some
   * hundreds of them, and how many of all have each of the features asked for. `sure` has for each of the three levels
   * how many are as sure, and how many of these are right; nothing where nobody has said it. */
  interface Counted {
    answered: number
    options: number[]
    numbers: number[]
    sketches: SketchOf[]
    having: number[]
    sure: [number, number][]
  }

  /** The answers to the question that is put, for the instructor; `before` is the first vote where this is another,
   * `features` what a right sketch has, by name, `right` how many answers are. */
  interface Tally {
    walk: string
    step: string
    vote: number
    now: Counted
    before: Counted | null
    features: Html[]
    right: number
  }

  /** The contents of a remote control: the question that is put, how many are here, the count of its answers without
   * single numbers and sketches, its lesson also before the answer is shown, whether its answers are right or wrong, the
   * instructor's notes, and the instructor's screen. `number` is the room's state that it shows. */
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

  /** The answers to a vote by their number, and how many of them were right. */
  interface VoteSummary {
    vote: number
    answered: number
    right: number
  }

  /** The number of answers that a class stores, and of the questions that they answer. */
  interface Stored {
    answers: number
    questions: number
  }

  /** A question that a class has answered, a step of a walk: its place there, from 1 on, its votes, and the wrong
   * answer that was given most often in the last, by how many; "" where that cannot be said in a few words. */
  interface StepSummary {
    walk: string
    step: string
    place: number
    question: Html
    votes: VoteSummary[]
    mistake: string
    mistaken: number
  }

  /** A follower's way in: the code as it is written, and the token under which answers are kept. */
  interface Entered {
    code: string
    token: string
  }

  /** A ticket for a remote control, good once: its address, also as a QR code (SVG); the phone sends the secret
   * alone. */
  interface Ticket {
    address: string
    square: string
  }

  /** A remote control that waits: the two digits that it shows, and the key that is good once it has been let in. */
  interface Paired {
    digits: string
    key: string
  }

  /** Asks for a word with which another computer leads the class from now on, at the page of this link. `shown` has
   * the vote after which the class saw the answer, by question. */
  interface HandOver {
    query: string
    shown: Record<string, number>
  }

  /** Takes the lead of a class with such a word, good once. */
  interface TakeOver {
    word: string
  }

  /** A room that another computer led, the link of the page that it showed, the answers that the class saw, the walks
   * from its files, by name, and what was kept of its remote control. */
  interface TakenOver extends Opened {
    query: string
    shown: Record<string, number>
    walks: Record<string, string>
    control: string
  }

  /** The digits that the instructor has seen on the phone. */
  interface Confirmed {
    digits: string
  }

  /** A press of a button on a remote control; `step` is the one to go to. `end` asks on the lecturer's screen
   * whether to end the class, and ends it if that is asked already. */
  interface Done {
    deed: Deed
    step: SaidName
  }

  /** A step in the contents of a remote control, by its title. */
  interface Listed {
    step: string
    title: Html
  }

  /** An axis as it is drawn: places are numbers in units of `factor` (SI) times 10**exponent, raised to `power`, or
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

  /** Simulated over real seconds: what the speed Auto plays at, and the fastest at which the motion can be seen. */
  interface Pace {
    auto: number
    limit: number | null
  }

  /** The digits of a moving number: its decimals, and whether its sign always stands. */
  type Digits = [decimals: number, signed: boolean]

  /** The progress of a measurement: so many of a total, counted in `unit`. */
  interface Progress {
    state: "idle" | "waiting" | "running" | "done"
    done: number
    total: number
    unit: string
    text: string
  }

  /** A column: the name of the axis that it is drawn on, and how many numbers it has. */
  type Drawn = [axis: string, count: number]

  /** Signals that are drawn over time, at `count` equally spaced instants from 0 to `end`: they are the column t, and
   * columns of these names; `signals` are those that are called otherwise. */
  type Trace = [end: number, count: number, names: string[], signals: Record<string, string>]

  /** A picture as the browser shows it.
   *
   * `columns`   the columns by source and name; their numbers follow the message, then those of the runs of `signals`
   * `axes`      the axes by name; `time` is the name of the one that the clock runs through, "" where nothing moves
   * `signals`   what moves, by name, in the order in which they build on each other
   * `traces`    those of them that are drawn over time, by the source whose columns they are
   * `scalars`   numbers that shapes and marks use
   * `values`    texts of live numbers, by name; `live` is how those that move are shown, by signal
   * `forms`     which variant of a formula or sentence stands, by name; "" hides it
   * `notes`     what the visitor must know about this picture
   * `left_out`  the quantities that are not sent because they are covered; a shape that needs one is not drawn */
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
    left_out: string[]
  }

  /** A number of the picture held and of the one that stands, in `unit`, and what became of it; "?" is covered. */
  interface LedgerRow {
    symbol: Html
    tint: string
    held: string
    now: string
    unit: string
    ratio: string
    same: boolean
  }

  /** The picture held beside the one that stands, on its axes, as far as it differs and is drawn.
   *
   * Its numbers follow those of the view. `signals` and `scalars` are those of its `traces` and of what a hand can take
   * on the stage, `values` the numbers of the sliders that have been moved since, `ledger` what is compared. */
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

  /** A slider with its field: `label` is what it is called but for its unit, `soft` what it spans; `says` continues
   * the symbol to a sentence. */
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

  /** Joined buttons, or small pictures: the shapes of a stage by value. */
  interface ChoiceRow {
    kind: "choice"
    name: string
    label: string
    options: Option[]
    pictures: Record<string, AnyShape[]>
  }

  type ControlRow = SliderRow | ChoiceRow

  /** A button that has the server set several parameters; a place shows whether the scene is there. */
  interface ActionButton {
    name: string
    label: string
    place: boolean
  }

  /** Controls that belong together; without a title they go on with those before. `facts` are rows of cells.
   *
   * A folded one opens when asked for and when one of its values is not the default; it stands by the form `form`. */
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

  /** A preset by its name: what it is called, the parameters that it sets, its outline (SVG path data in a box of 128
   * by 46, or none), and what to watch in it.
   *
   * It sets all that any preset of the scene speaks of; the others stay. */
  interface PresetButton {
    name: string
    label: string
    sets: Record<string, Value>
    outline: string
    watch: string
  }

  /** All controls of a scene; `start` is the title over the presets, which a folded one hides until asked for. */
  interface Panel {
    start: string
    folded: boolean
    presets: PresetButton[]
    groups: GroupSection[]
  }

  /** The state of a parameter's control: its value (in its own unit) and the text of its field.
   *
   * `unit` is the one that is shown and typed, of which one is `size`; `changed` says that it is not the default. */
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
   * `part` is its name in lists of what a step shows: stage, plot:x, words:why, table. Without any `views` it is in all
   * of them. `grow` and `basis` say how a block shares the height (in a column) or the width (in a row), `phone` its
   * place from top to bottom on a narrow screen and `height` its height there; it stands while the picture has the form
   * `form`, and with the large type of a `hall` or not there. */
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

  /** Blocks one under the other. */
  interface Column extends Part {
    kind: "column"
    blocks: Block[]
    gap: number
  }

  /** The picture; `label` describes it to those who do not see it. Where it stands alone it is at most `widest` times
   * as wide as high. */
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

  /** Rows of cells under their heads; the first cell of a row is its name. */
  interface TableBlock extends Part {
    kind: "table"
    head: Html[]
    rows: Forms[][]
  }

  /** A value of a choice, by its word, and its name on the screen. */
  interface Option {
    value: string
    label: string
  }

  /** A joined segment of options that sets the parameter `name`. */
  interface ChoiceBlock extends Part {
    kind: "choice"
    name: string
    label: string
    options: Option[]
  }

  /** A plot: `x` and `y` name axes of the picture, `title` is its text alternative, `brief` its name in a list.
   *
   * `time` says whether its abscissa is the instant shown, which then can be dragged; `square` draws both axes to one
   * scale; `plain` leaves out numbers at the axes; `shapes` are drawn over it as on a stage; a press near a point of a
   * curve sets the list `pick` to its source and its place in the column. The frame leaves free the room around it, so
   * that what stands over the figure has its place before the figure is there. */
  interface PlotBlock extends Part {
    kind: "plot"
    name: string
    title: string
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
    figure: Record<string, unknown>
  }

  type Block = Row | Column | StageBlock | WordsBlock | TableBlock | ChoiceBlock | PlotBlock

  /** The room around the frame of a plot, in pixels: for numbers at the left and below, labels at the right, flags
   * over it. */
  interface Room {
    left: number
    right: number
    top: number
    bottom: number
  }

  /** A line: column `y` of `source` over its column `x`, coloured as the quantity `tint`.
   *
   * `signal` moves a dot along it (with `signal_x` as its abscissa where that is not the time); `label` stands at its
   * right end and in the read-out at the pointer, `read` there alone; `group` is the name by which it is switched off.
   * With a `marker` its points are marked; with width "none" only they are drawn. Of a group drawn as a band its name
   * stands at the band's middle. */
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

  /** A pill on an axis that sets a parameter, no lower than `least`.
   *
   * It shows `symbol` and the parameter's number, or the value called `text`, then `unit`; where it stands over the unit
   * of the axis it says `covering`. A `bare` one is moved by a press on the plot alone. It stands by the form `form`. */
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
  }

  /** A line with a flag across the plot at the scalar `at`, a place on the axis.
   *
   * The flag is the button for the action `act`, or sets the parameter `set` to the scalar `exactly` where given, else
   * to what the place stands for. `lift` is its height over the frame, `shift` its way to the right, in pixels. */
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
   * `form` names the picture's form that says which variant stands; the variant "formula" where the picture has none. */
  interface Term {
    variants: Record<string, Html>
    curve: string
    form: string
    key: "sum" | "line" | "dash" | "band" | "none"
    tint: string
  }

  type Anchor = "start" | "middle" | "end" | "beside"

  type Side = "left" | "right" | "top" | "bottom"

  /** A rule that makes a value of `parameter`, of which one is `size` in SI, of the place of a hand; "" sets nothing.
   *
   * `moves` is the signal or scalar, counted on `axis` ("" for one without), that is drawn where the hand is, at once.
   * A flick adds its velocity to the start of the parameter `rate`. */
  interface Way {
    parameter: string
    moves: string
    axis: string
    size: number
    rate: string
  }

  /** A way along a line: 0 stands at the pixel `zero`, one of the axis is `unit` pixels long, to the right or down; a
   * hand takes it no lower than `least` and no higher than `most`, both in SI. */
  interface Stretch extends Way {
    across: "x" | "y"
    zero: Number
    unit: Number
    least: number | null
    most: number | null
  }

  /** A way whose value is the place of the hand. */
  interface Along extends Stretch {
    kind: "along"
  }

  /** A way to set one of two parts of a value: `share` times the place of the hand, and the signal `rest`. */
  interface Share extends Stretch {
    kind: "share"
    share: Number
    rest: string
  }

  /** A way that sets the value of `over`, divided by the place of the hand. */
  interface Quotient extends Stretch {
    kind: "quotient"
    over: string
  }

  /** A way to hold a root of s^2 + 2 z s + 1 by its distance p to the left of the imaginary axis, and to set z: p on
   * the circle, (p + 1/p)/2 on the real axis, where it is beyond 1 or says `real`. */
  interface Root extends Stretch {
    kind: "root"
    real: boolean
  }

  /** A way that takes the place of the hand, times `counted`, as a turning point of a sine: the value is its
   * amplitude, or where `of` says so its phase, in rad. What moves is `share` of it. A flick gives it a velocity; `turn`
   * is the signal of its argument. */
  interface Swung extends Stretch {
    kind: "swung"
    of: "amplitude" | "phase"
    counted: Number
    share: Number
    turn: string
  }

  /** A way about a point (x, y): the angle in rad, from straight down, counted to the right (anticlockwise): 0 stands
   * at `zero`, one is `unit` rad. Of a circle seen from the side `tall` is the height over the width. */
  interface Turn extends Way {
    kind: "turn"
    x: Number
    y: Number
    zero: number
    unit: number
    tall: number
  }

  /** A way that trades height for speed without loss: the excess of speed in level flight at a height, by the height
   * `head` (v_0^2/g); no higher than where the speed is used up. */
  interface Trade extends Way {
    kind: "trade"
    zero: Number
    unit: Number
    head: string
  }

  type AnyWay = Along | Share | Quotient | Root | Swung | Turn | Trade

  /** The start of a motion from what is seen: `parameter` takes the value of the signal `of` on `axis`, or 0. Of what
   * goes on as it was every digit is taken `exactly`; an angle, in rad, without whole turns. */
  interface Begin {
    parameter: string
    of: string
    axis: string
    size: number
    exactly: boolean
    angle: boolean
  }

  /** A shape's answer to a hand: the values that it sets; `label` names it for a screen reader.
   *
   * Where it `begins` a motion, time stops, what is seen becomes the new `start`, and letting go plays it. The hand does
   * not leave the frame of the plot `inside`. */
  interface Grab {
    label: string
    ways: AnyWay[]
    begins: boolean
    start: Begin[]
    inside: string
  }

  /** The fields that all shapes have: `tint`, the class of a colour, and `style`, more classes; drawn while the
   * picture has all the scalars `show`, none of them 0; `inside` names the plot whose frame cuts it, `grab` what a hand
   * does with it; what begins a motion in a hand, and what says `held`, is drawn of a picture held too. */
  interface Look {
    tint: string
    style: string
    show: string[]
    inside: string
    grab: Grab | null
    held: boolean
  }

  /** A zigzag of nine teeth between two points: stretch is pitch, stiffness is the width of the wire. */
  interface Spring extends Look {
    kind: "spring"
    x1: Number
    y1: Number
    x2: Number
    y2: Number
    wire: Number
    height: Number
  }

  /** A square mass, given by the middle of its foot; `corner` puts its label over it, to the left. */
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

  /** An arrow with a head of so many pixels, moved ahead along itself by `gap`. */
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

  /** size sin(2 pi turns s + phase) upwards over a length from (x, y); with a `depth` filled down to there. */
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

  /** `count` slices of a medium from (x, y) to the right, their edges displaced along it by size sin(2 pi turns s). */
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

  /** Words at a place of the stage. Words `beside` a point of the plot over which they lie stand to its right or left,
   * clear of the lines. */
  interface Label extends Look {
    kind: "text"
    x: Number
    y: Number
    words: Runs
    anchor: Anchor
  }

  /** A hatched wall; (x, y) is its upper or left end, `side` where the solid is, `depth` the size of its hatching. */
  interface Wall extends Look {
    kind: "wall"
    x: Number
    y: Number
    length: Number
    side: Side
    depth: Number
  }

  type AnyShape = Spring | Box | Line | Arrow | Circle | Path | Arc | Wave | Layers | Label | Wall

  /** Anything that has a number at every instant. */
  interface Signal {
  }

  /** (size + slope t) exp(-decay t) sin(omega t + phase); a plain exponential has omega = 0 and phase = pi/2. */
  type Sine = [size: number, omega: number, phase: number, decay: number, slope: number]

  /** a + b t and a sum of sines; line = (a, b). */
  interface Sines extends Signal {
    kind: "sines"
    sines: Sine[]
    line: [number, number]
  }

  /** size g(t), from rest, with g'' + omega_n^2 g = sin(omega t); regular at resonance and at omega_n = 0. */
  type Response = [size: number, omega: number, omega_n: number]

  /** A sum of responses to a drive. */
  interface Responses extends Signal {
    kind: "responses"
    responses: Response[]
  }

  /** The free motion of a damped mass, or its rate: exp(-slow t) (start C + rate S).
   *
   * C = cos(swing t), S = sin(swing t)/swing where it swings; else C = 1, S = (1 - exp(-apart t))/apart, at critical
   * damping t. Once apart t > 1 it is the sum of both exponentials, of the sizes `late`. */
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
   * t): regular at resonance, at critical damping and without damping.
   *
   * `slow`, `apart` and `swing` are those of its free motion, `detuning` is omega - swing. */
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

  /** A polynomial in the signals before it. */
  interface Derived extends Signal {
    kind: "derived"
    value: Expression
  }

  /** The sine of an angle in rad, a signal before it. */
  interface SineOf extends Signal {
    kind: "sine"
    of: string
  }

  /** The cosine of an angle in rad, a signal before it. */
  interface CosineOf extends Signal {
    kind: "cosine"
    of: string
  }

  /** Numbers that follow their message: how many, the least and the greatest. */
  interface Samples {
    count: number
    low: number
    high: number
  }

  /** A periodic motion in equally spaced values and slopes over one period, joined by Hermite pieces; `drift` is
   * gained each period. */
  interface Sampled extends Signal {
    kind: "sampled"
    period: number
    y: number[] | Samples
    dy: number[] | Samples
    drift: number
  }

  type AnySignal = Sines | Responses | DampedMass | DrivenMass | Derived | SineOf | CosineOf | Sampled

  /** A coefficient times named quantities. */
  type Product = [factor: number, names: string[]]

  /** A sum of products of named quantities: signals, scalars, W and H, the frames of plots.
   *
   * Anything else than a number may convert itself by its own reflected operators. */
  interface Expression {
    terms: Product[]
  }

  /** A number of a shape: fixed, or worked out at every frame. */
  type Number = number | Expression

  /** HTML that components.layout.text made of our own source; live numbers in it are elements with `data-value`. */
  type Html = string

  /** A piece of a text in a drawing: plain, the symbol of a quantity, its index, or the live number of that name. */
  interface TextRun {
    kind: "plain" | "symbol" | "index" | "value"
    text: string
  }

  type Runs = TextRun[]

  /** A sentence in several forms: the picture's form called `name` says which stands, "" that none does.
   *
   * Without a name the only form, "", always stands. */
  interface Forms {
    variants: Record<string, Html>
    name: string
  }
}
