/** Histograms as SVG: bars, or an outline drawn over them. */

/** The least relative height of a non-empty bar: one outlier among thousands must be visible. */
const LEAST = 1 / 15;

/** The outline of all bars. */
export function Outline({ counts, most }: { counts: number[]; most: number }) {
  return <Drawing look="outline" counts={counts} most={most} />;
}

/** The bars, of which the greatest has full height. */
export function Bars({ counts }: { counts: number[] }) {
  const most = Math.max(...counts, 1);
  const seen = counts.map((count) => (count > 0 ? Math.max(count, LEAST * most) : 0));
  return <Drawing look="bars" counts={seen} most={most} />;
}

/** @param props.most the count at full height */
function Drawing({ look, counts, most }: { look: string; counts: number[]; most: number }) {
  const steps = counts.map((count, k) => {
    const y = Math.round(1e4 * (1 - count / Math.max(most, 1))) / 1e4;
    return `L${k} ${y}L${k + 1} ${y}`;
  });
  return (
    <svg
      class={look}
      aria-hidden="true"
      preserveAspectRatio="none"
      viewBox={`0 0 ${counts.length} 1`}
    >
      <path d={`M0 1${steps.join('')}L${counts.length} 1`} />
    </svg>
  );
}
