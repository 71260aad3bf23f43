// Starts `hyzer lsp` for files of models and effects.
"use strict";

const fs = require("fs");
const path = require("path");
const vscode = require("vscode");
const { LanguageClient } = require("vscode-languageclient/node");

let client;

/** The program: as set, else the one in the extension's folder, else the one on the PATH. */
function program(context) {
  const stated = vscode.workspace.getConfiguration("hyzer").get("path");
  if (stated) return stated;
  const name = process.platform === "win32" ? "hyzer.exe" : "hyzer";
  const bundled = path.join(context.extensionPath, "bin", name);
  return fs.existsSync(bundled) ? bundled : name;
}

async function start(context) {
  const command = program(context);
  client = new LanguageClient(
    "hyzer",
    "hyzer",
    { command, args: ["lsp"] },
    { documentSelector: [{ language: "hyzer" }] },
  );
  try {
    await client.start();
  } catch (error) {
    client = undefined;
    const hint = "Install hyzer, or set `hyzer.path` to the program.";
    vscode.window.showErrorMessage(`hyzer: \`${command} lsp\` cannot be started (${error.message}). ${hint}`);
  }
}

async function stop() {
  const running = client;
  client = undefined;
  if (running) await running.stop();
}

async function activate(context) {
  const restart = async () => {
    await stop();
    await start(context);
  };
  context.subscriptions.push(
    vscode.commands.registerCommand("hyzer.restart", restart),
    vscode.workspace.onDidChangeConfiguration((change) => {
      if (change.affectsConfiguration("hyzer.path")) return restart();
    }),
  );
  await start(context);
}

module.exports = { activate, deactivate: stop };
