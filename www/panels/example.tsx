/** Note on the open example: its figure, what to look for, and links to its neighbours. */

import { useEffect, useState } from 'preact/hooks';
import { linkToExample } from '../solver/examples.ts';
import { performNamed } from '../store/perform.ts';
import { useApp } from '../store/use-app.ts';
import { Button } from '../ui/components/buttons.tsx';
import type { Example } from '../solver/examples.ts';

export function ExampleNote() {
  const { example } = useApp().store.state;
  return (
    <section id="example-note" aria-labelledby="heading-example" hidden={!example}>
      {example && <Note example={example} />}
    </section>
  );
}

function Note({ example: { id, figure, summary, statement, plots, kinds } }: { example: Example }) {
  const app = useApp();
  const all = useExamples();
  const at = all.findIndex((one) => one.id === id);
  return (
    <>
      <h2 id="heading-example">
        {figure === null ? 'Example' : `Figure ${figure} of the paper Shape-Up`}
      </h2>
      <p>{summary}</p>
      {/* An example without constraints is a flat map: nothing is solved. */}
      <p class="quiet">
        {kinds.length > 0 ? 'Once solved' : 'Once flattened'}: {statement}
      </p>
      {plots.map(({ label, plot }) => (
        <Button
          key={plot}
          class="bordered small"
          onClick={() => {
            app.actions.look({ plot });
            // Once the plot is there.
            queueMicrotask(() => performNamed('show-plots', app));
          }}
        >
          {label}
        </Button>
      ))}
      <nav class="beside" aria-label="Examples one by one">
        {at > 0 && <Neighbour words="Previous" to={all[at - 1]} />}
        <a href="./gallery.html">Gallery</a>
        {at >= 0 && at + 1 < all.length && <Neighbour words="Next" to={all[at + 1]} />}
      </nav>
    </>
  );
}

/** All examples, none before they are known. */
function useExamples() {
  const { files, actions } = useApp();
  const [all, setAll] = useState<Example[]>([]);
  useEffect(() => {
    void actions.reportErrors(files.examples()).then((found) => found && setAll(found));
  }, []);
  return all;
}

function Neighbour({ words, to }: { words: string; to: Example }) {
  const { files, actions } = useApp();
  const link = linkToExample(to.id);
  return (
    <a
      href={link}
      title={to.title}
      onClick={(event) => {
        // A link to the current address would do nothing.
        if (location.hash !== link) return;
        event.preventDefault();
        void actions.reportErrors(files.openExample(to));
      }}
    >
      {words}
    </a>
  );
}
