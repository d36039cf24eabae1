// The number of tables that the CSV export has: several are packed into one ZIP file (components/csv_export.py).

/** @param {page.PlotBlock[]} blocks @param {Drawn["view"]} view */
export function tables(blocks, view) {
  /** @type {Map<string, string>} the axis of each column */
  const axes = new Map()
  for (const {curves, regions, x, y} of blocks) {
    for (const curve of curves) axes.set(`${curve.source}.${curve.x}`, x).set(`${curve.source}.${curve.y}`, y)
    for (const {source, ...own} of regions)
      axes.set(`${source}.${own.x}`, x).set(`${source}.${own.low}`, y).set(`${source}.${own.high}`, y)
  }
  const heads = Object.entries(view.columns).map(([source, columns]) =>
    Object.keys(columns).filter(name => columns[name].length && (axes.get(`${source}.${name}`) ?? "") in view.axes),
  )
  return new Set(heads.filter(names => names.length).map(names => names.toSorted().join())).size
}
