// The number of answers to a question of a class, in words.

/**
 * "12 of 30 have answered". Followers who have left are no longer counted in `here`. @param {number} answered @param
 * {number} here
 */
export const haveAnswered = (answered, here) => `${answered}${answered > here ? "" : ` of ${here}`} have answered`
