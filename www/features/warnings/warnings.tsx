/** The messages about a shape, beside the page's alert. */

import '../../ui/styles/lists.css';
import { FreeVertices, Unpaired } from './free-vertices.tsx';
import { RunMessage } from './run-message.tsx';

export function Warnings() {
  return (
    <>
      <div aria-live="polite" id="conditions">
        <RunMessage />
      </div>
      <div aria-live="polite">
        <Unpaired />
      </div>
      <div aria-live="polite">
        <FreeVertices />
      </div>
    </>
  );
}
