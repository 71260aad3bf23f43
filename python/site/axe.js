// Opens every page of the site in headless Chromium, at 1280 and 390 px and in dark mode: no serious finding of axe, no page wider than its
// window, no error on the console, no request to another host.
//
// node axe.js SITE [--pictures FOLDER] [PAGE ...]
import { readFileSync, readdirSync, mkdirSync } from "node:fs";
import { createServer } from "node:http";
import { createRequire } from "node:module";
import { extname, join } from "node:path";
import puppeteer from "puppeteer-core";

const [site, ...rest] = process.argv.slice(2);
const at = rest.indexOf("--pictures");
const pictures = at >= 0 ? rest.splice(at, 2)[1] : null;
const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const types = { ".html": "text/html", ".css": "text/css", ".js": "text/javascript", ".svg": "image/svg+xml", ".json": "application/json" };
const server = createServer((request, response) => {
  try {
    const path = decodeURIComponent(new URL(request.url, "http://x").pathname);
    response.setHeader("content-type", types[extname(path)] ?? "application/octet-stream");
    response.end(readFileSync(join(site, path)));
  } catch {
    response.writeHead(404).end();
  }
}).listen(0, "127.0.0.1");
await new Promise((ready) => server.once("listening", ready));
const origin = `http://127.0.0.1:${server.address().port}`;

const every = readdirSync(site, { recursive: true }).filter((f) => f.endsWith(".html") && !/^(rust|demo)\//.test(f));
const pages = rest.length ? rest : every.filter((f) => f !== "404.html").sort();
const browser = await puppeteer.launch({ protocolTimeout: 300_000, executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: ["--no-sandbox"] });
const faults = [];
async function pass(scheme, width) {
  const context = await browser.createBrowserContext(); // The theme stores the scheme.
  const page = await context.newPage();
  page.setDefaultTimeout(300_000); // Other work may have the processors.
  await page.setViewport({ width, height: 900 });
  await page.emulateMediaFeatures([{ name: "prefers-color-scheme", value: scheme }]);
  let name = "";
  const fault = (text) => faults.push(`${name} (${width} px, ${scheme}): ${text}`);
  page.on("console", (line) => line.type() === "error" && fault(line.text()));
  page.on("pageerror", (error) => fault(error.message));
  page.on("request", (request) => /^http/.test(request.url()) && !request.url().startsWith(origin) && fault(`asks ${request.url()}`));
  for (name of pages) {
    await page.goto(`${origin}/${name}`, { waitUntil: "load" });
    const wide = await page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
    if (wide > 0) fault(`the page is ${wide} px wider than the window`);
    await page.evaluate(axe);
    // What depends on the scheme is colour; all else is looked for once.
    const rules = scheme === "dark" ? { runOnly: { type: "rule", values: ["color-contrast", "link-in-text-block"] } } : {};
    const asked = { ...rules, resultTypes: ["violations"], iframes: false };
    const { violations } = await page.evaluate((options) => window.axe.run(options), asked);
    for (const found of violations.filter((v) => ["serious", "critical"].includes(v.impact)))
      fault(`${found.id}: ${found.help}: ${found.nodes.length} times, as ${found.nodes[0].html.slice(0, 160)}`);
    if (pictures) {
      mkdirSync(pictures, { recursive: true });
      await page.screenshot({ path: join(pictures, `${name.replaceAll("/", "-")}-${width}-${scheme}.png`), fullPage: true });
    }
  }
  await context.close();
}
// Side by side: each has a process of its own.
await Promise.all([pass("light", 1280), pass("light", 390), pass("dark", 1280), ...(pictures ? [pass("dark", 390)] : [])]);
await browser.close();
server.close();
console.log([...new Set(faults)].join("\n"));
console.log(`${pages.length} pages in 2 schemes, at 1280 and 390 px: ${faults.length} faults`);
process.exit(faults.length ? 1 : 0);
