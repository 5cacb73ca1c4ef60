/** What features that follow a moving shape share. */

/** Features that compute much for each shape follow larger meshes only at rest. */
export const MOST_LIVE_VERTICES = 3000;
