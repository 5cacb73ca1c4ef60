/**
 * Weights of a linear prediction that learn from what came: recursive least squares, which begins at zero
 * and forgets (Haykin, Adaptive Filter Theory).
 */

/** How far it is believed that the weights are 0. */
const DOUBT = 1000;
/** Each sample counts so much of the next one. */
const FORGETTING = 0.98;
/** Nothing is forgotten while a feature says nothing: what is known of it would be lost. */
const MOST_DOUBT = 1e6;

export class LeastSquares {
  #weights;
  /** The inverse of the covariance of the features. @type {number[][]} */
  #inverse = [];

  /** @param {number} size */
  constructor(size) {
    this.#weights = new Array(size).fill(0);
    this.#begin();
  }

  #begin() {
    this.#weights.fill(0);
    this.#inverse = this.#weights.map((_, i) =>
      this.#weights.map((__, j) => (i === j ? DOUBT : 0)),
    );
  }

  /** @param {number[]} features */
  predict(features) {
    return features.reduce((sum, value, i) => sum + value * this.#weights[i], 0);
  }

  /**
   * @param {number[]} features
   * @param {number} value that they should have given
   */
  learn(features, value) {
    const error = value - this.predict(features);
    const inverse = this.#inverse;
    const kept = inverse.every((row, i) => row[i] < MOST_DOUBT) ? FORGETTING : 1;
    const gain = inverse.map((row) => row.reduce((sum, one, j) => sum + one * features[j], 0));
    const scale = kept + features.reduce((sum, one, i) => sum + one * gain[i], 0);
    // Rounding has made it meaningless.
    if (!(scale >= kept)) return this.#begin();
    for (let i = 0; i < gain.length; i++) {
      this.#weights[i] += (gain[i] / scale) * error;
      for (let j = 0; j < gain.length; j++)
        inverse[i][j] = (inverse[i][j] - (gain[i] * gain[j]) / scale) / kept;
    }
  }
}
