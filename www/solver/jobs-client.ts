/**
 * Page side of the second worker, which does what takes long. It starts with the first call, with
 * the module that the solver's worker has compiled. A job that takes long can be cancelled.
 */

import { Emitter } from './emitter.ts';
import { Cancelled, retryIfCollateral } from './errors.ts';
import { calling, Waiting, type Answer, type Call, type Remote } from './remote.ts';
import type { JobCall, Jobs } from '../worker/jobs-worker.ts';
import type { Holder } from '../worker/jobs/model-copy.ts';
import type { ModelCopy } from '../pkg/engine/shape_up.js';
import type { Snapshot } from './types.ts';

type ErrorOf = (name: string, place: number) => Error;

/** Time after which the user may want to cancel a job, in milliseconds. */
const LONG_MS = 1500;

export class JobsClient extends Emitter<{
  /** whether a job, by its name, takes long */
  busy: { busy: boolean; job: string };
  /** what the current job does, in words */
  told: { words: string };
}> {
  #module;
  #worker: Promise<Worker> | null = null;
  #waiting = new Waiting();
  /** Timer of the current call, until it is long. */
  #timer: ReturnType<typeof setTimeout> | undefined;
  #isBusy = false;
  /** Returns the error of a call that the last end of the worker has ended. */
  #ended: ErrorOf = () => new Cancelled();

  /** Raised when the worker ends: what it had made is lost. */
  generation = 0;

  /** The methods of the worker. */
  readonly ask: Remote<Jobs> = calling((name, given) => this.#call(name, given));

  /** @param module the compiled engine */
  constructor(module: Promise<WebAssembly.Module>) {
    super();
    this.#module = module;
  }

  /**
   * The methods of a copy of a model, which is made first unless the worker has it. What waited when
   * another job was cancelled is asked for again, since it needs nothing that the worker had.
   */
  copy = (model: Snapshot, holder: Holder = 'questions'): Remote<ModelCopy> =>
    calling((name, given) => retryIfCollateral(() => this.#call(name, given, { model, holder })));

  /**
   * A copy of a model of its own, for work in several calls: `ask` is about it until `free`, whatever
   * others ask.
   */
  of(holder: Exclude<Holder, 'questions'>) {
    const ask: Remote<ModelCopy> = calling((name, given) => this.#call(name, given, { holder }));
    return { copy: (model: Snapshot) => this.copy(model, holder), ask };
  }

  /**
   * Cancels the current job, or those with these names. What waits for the worker ends with it, as
   * collateral that can be asked for again.
   */
  cancel(...names: (keyof Remote<Jobs & ModelCopy>)[]) {
    const direct: string[] = names;
    this.#end(
      (name, place) => new Cancelled(names.length > 0 ? direct.includes(name) : place === 0),
    );
  }

  async #call(name: string, given: unknown[], of: Omit<JobCall, keyof Call> = {}) {
    const place = this.#worker ? 1 : 0;
    const started = (this.#worker ??= this.#start());
    const worker = await started;
    if (this.#worker !== started) throw this.#ended(name, place);
    const answer = this.#waiting.call(name, given, (call) =>
      worker.postMessage({ ...call, ...of } satisfies JobCall),
    );
    if (this.#waiting.size === 1) this.#follow();
    return answer;
  }

  async #start() {
    const module = await this.#module;
    const worker = new Worker(new URL('../worker/jobs-worker.ts', import.meta.url), {
      type: 'module',
      name: 'jobs',
    });
    worker.onmessage = ({ data }: MessageEvent<Answer | { told: string }>) => {
      if ('told' in data) this.emit('told', { words: data.told });
      else this.#receive(data);
    };
    worker.onerror = (event) => {
      event.preventDefault();
      this.#end(() => new Error('A part of the page could not be fetched. Check the network.'));
    };
    worker.postMessage(module);
    return worker;
  }

  #receive(answer: Answer) {
    this.#waiting.receive(answer);
    // What the engine had is lost; the next call starts another worker.
    if ('refused' in answer && answer.isDead) this.#end(() => new Error(answer.refused));
    else this.#follow();
  }

  /** Ends the worker; its calls fail. */
  #end(errorOf: ErrorOf) {
    void this.#worker?.then((worker) => worker.terminate());
    this.#worker = null;
    this.generation += 1;
    this.#ended = errorOf;
    this.#waiting.fail(errorOf);
    this.#follow();
  }

  /** Tells when the next call has become long. */
  #follow() {
    clearTimeout(this.#timer);
    this.#setBusy(false);
    if (this.#waiting.size > 0) this.#timer = setTimeout(() => this.#setBusy(true), LONG_MS);
  }

  #setBusy(busy: boolean) {
    if (busy === this.#isBusy) return;
    this.#isBusy = busy;
    this.emit('busy', { busy, job: this.#waiting.first });
  }
}
