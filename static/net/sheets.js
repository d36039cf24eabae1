// Sheets of scenes and walks: each is fetched once, because it never changes.

export class Sheets {
  /** @type {Map<string, Promise<unknown>>} by address */
  known = new Map()

  /** `patience` is the longest time for one request. @param {number} [patience] ms */
  constructor(patience) {
    this.patience = patience
  }

  /** @template [Sheet=page.SceneSheet] @param {string} address @returns {Promise<Sheet>} */
  fetch(address) {
    const known = this.known.get(address)
    if (known) return /** @type {Promise<Sheet>} */ (known)
    const signal = this.patience ? AbortSignal.timeout(this.patience) : null
    const fetched = fetch(new URL(`assets/${address}`, document.baseURI), {signal}).then(answer => {
      if (!answer.ok) throw new Error(`${address}: ${answer.status}`)
      return answer.json()
    })
    fetched.catch(() => this.known.delete(address))
    this.known.set(address, fetched)
    return fetched
  }
}
