// Plays a conversation with a debug adapter through Microsoft's own client (npm: @vscode/debugadapter-testsupport).
// Standard input: {"adapter": ["pdp8", "dap"], "steps": [[request, arguments, event to wait for], ...]}; the step
// ["edit", script] runs a script of Python, and has no answer.
// Standard output: for each step {"body"} or {"error"}, and the event's body; then all that was put out.
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { DebugClient } from "@vscode/debugadapter-testsupport";

const { adapter, steps } = JSON.parse(readFileSync(0, "utf8"));
const client = new DebugClient(adapter[0], adapter[1], "pdp8");
const output = [];
client.on("output", (event) => output.push([event.body.category, event.body.output]));
await client.start();
const answers = [];
for (const [request, given, awaited] of steps) {
  if (request === "edit") {
    execFileSync("python3", ["-c", given]);
    continue;
  }
  const event = awaited ? client.waitForEvent(awaited, 10000) : null;
  const answer = await client.send(request, given).then(
    (response) => ({ body: response.body ?? null }),
    (error) => ({ error: error.message }),
  );
  if (event && !("error" in answer)) answer.event = (await event).body ?? null;
  else event?.catch(() => null);
  answers.push(answer);
}
console.log(JSON.stringify({ answers, output }));
process.exit(0);
