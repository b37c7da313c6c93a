// Starts the language server, `pal --lsp`, and for each debugging session the debugger, `pdp8 dap`.
const vscode = require("vscode");
const { LanguageClient } = require("vscode-languageclient/node");

let client;

function setting(name) {
  return vscode.workspace.getConfiguration("pdp8").get(name);
}

function activate(context) {
  const server = { command: setting("pal"), args: ["--lsp", "--dialect", setting("dialect")] };
  client = new LanguageClient("pal", "PAL", server, {
    documentSelector: [{ language: "pal" }],
    initializationOptions: { programs: setting("programs") },
    synchronize: { configurationSection: "pdp8" },
  });
  client.start().catch((error) => {
    const advice = `pip install "pdp8[lsp]", or set pdp8.pal to where it is`;
    vscode.window.showErrorMessage(`${server.command} --lsp did not start: ${advice} (${error.message})`);
  });
  const debuggers = {
    createDebugAdapterDescriptor: (session) =>
      new vscode.DebugAdapterExecutable(setting("pdp8"), ["dap"], { cwd: session.workspaceFolder?.uri.fsPath }),
  };
  const configurations = {
    resolveDebugConfiguration: (folder, given) =>
      given.type ? given : { type: "pdp8", request: "launch", name: "PDP-8/L", program: "${file}", stopOnEntry: true },
  };
  context.subscriptions.push(
    vscode.debug.registerDebugAdapterDescriptorFactory("pdp8", debuggers),
    vscode.debug.registerDebugConfigurationProvider("pdp8", configurations),
  );
}

function deactivate() {
  return client?.stop();
}

module.exports = { activate, deactivate };
