// The number of answers to a question of a class, in words.

/** Followers who have left since are not in `here`. @param {number} answered @param {number} here */
export const haveAnswered = (answered, here) => `${answered}${answered > here ? "" : ` of ${here}`} have answered`
