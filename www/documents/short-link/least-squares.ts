/**
 * Adaptive linear prediction by recursive least squares with exponential forgetting, starting from
 * zero weights (Haykin, Adaptive Filter Theory).
 */

/** Initial diagonal of the inverse covariance: large, as the zero weights are only a guess. */
const DOUBT = 1000;
/** Forgetting factor: each sample weighs so much relative to the next one. */
const FORGETTING = 0.98;
/** Diagonal above which nothing is forgotten: for a zero feature it would grow without bound. */
const MOST_DOUBT = 1e6;

export class LeastSquares {
  #weights;
  /** Inverse of the covariance of the features. */
  #inverse: number[][] = [];

  constructor(size: number) {
    this.#weights = new Array(size).fill(0);
    this.#begin();
  }

  #begin() {
    this.#weights.fill(0);
    this.#inverse = this.#weights.map((_, i) =>
      this.#weights.map((__, j) => (i === j ? DOUBT : 0)),
    );
  }

  predict(features: number[]) {
    return features.reduce((sum, value, i) => sum + value * this.#weights[i], 0);
  }

  /** @param value correct value */
  learn(features: number[], value: number) {
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
