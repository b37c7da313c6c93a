// Work that runs the machine at full speed: it gives up before the page seems frozen.

const BUDGET = 3000; // ms
const SLICE = 10; // seconds of machine time between two looks at the clock

/** Do `work`, whose runs of `machine` are cut into slices. Throws an error when the time is over. */
export function limited(machine, work) {
  const end = performance.now() + BUDGET;
  const whole = machine.run.bind(machine);
  machine.run = (seconds = Infinity) => {
    for (let left = seconds; ; left -= SLICE) {
      const stop = whole(Math.min(left, SLICE));
      if (stop.reason !== "limit" || left <= SLICE) return stop;
      if (performance.now() > end) throw new Error(`given up after ${BUDGET / 1000} s of computing; the program may be in a loop`);
    }
  };
  try {
    return work();
  } finally {
    delete machine.run;
  }
}
