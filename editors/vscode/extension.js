// Starts the language server, `pal --lsp`, and for each debugging session the debugger, `pdp8 dap`.
const vscode = require("vscode");
const { LanguageClient } = require("vscode-languageclient/node");

let client;

function setting(name) {
  return vscode.workspace.getConfiguration("pdp8").get(name);
}

function activate(context) {
  const server = { command: setting("pal"), args: ["--lsp", "--dialect", setting("dialect")] };
  client = new LanguageClient("pal", "PAL", server, { documentSelector: [{ language: "pal" }] });
  client.start();
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
