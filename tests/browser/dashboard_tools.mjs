// What the dashboard's stories are told with: programs that run, a browser, and what is on its pages.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { once } from "node:events";
import { createRequire } from "node:module";

const [packages, striate, work, screens] = process.argv.slice(2);
export { screens, striate, work };
const { chromium } = createRequire(`${packages}/`)("playwright-core");
export const corridor = ["run", "config/tasks/corridor.yaml", "--world", "config/worlds/short.yaml", "--seed", "3", "--quiet"];
const kPatience_ms = 90_000; // a busy machine
const running = new Set();

// A program that tells its address; `ended` is its exit code.
export async function start(words, { prefix = "" } = {}) {
  const child = spawn(striate, words, { stdio: ["ignore", "ignore", "pipe"] });
  running.add(child);
  const ended = once(child, "exit").then(([code]) => (running.delete(child), code));
  let said = "";
  const url = await new Promise((resolve, reject) => {
    child.stderr.on("data", (piece) => {
      said += piece;
      const found = /Dashboard: (\S+)/.exec(said);
      if (found) resolve(prefix + found[1]);
    });
    child.on("exit", () => reject(new Error(`no address: ${said}`)));
  });
  return { url, ended, child, said: () => said };
}

// Without an address to wait for.
export async function run(words, { expected = 0 } = {}) {
  const child = spawn(striate, words, { stdio: ["ignore", "pipe", "pipe"] });
  let out = "";
  child.stdout.on("data", (piece) => (out += piece));
  child.stderr.on("data", (piece) => (out += piece));
  const [code] = await once(child, "exit");
  assert.equal(code, expected, out);
  return out;
}

export const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  // Debian's Chromium asks for rights that root in a container has not; the pages are our own.
  args: ["--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--force-color-profile=srgb"],
});

// A page that complains about anything fails its story, unless `quiet`: then only what it throws.
export async function open(url, { width = 1280, height = 720, dark = false, quiet = false, scale = 1 } = {}) {
  const context = await browser.newContext({ viewport: { width, height }, colorScheme: dark ? "dark" : "light", deviceScaleFactor: scale });
  const page = await context.newPage();
  page.setDefaultTimeout(kPatience_ms);
  page.complaints = [];
  page.on("pageerror", (error) => page.complaints.push(`threw: ${error.message}`));
  page.on("console", (message) => !quiet && message.type() === "error" && page.complaints.push(message.text()));
  page.on("dialog", (dialog) => (page.complaints.push(`dialog: ${dialog.message()}`), dialog.dismiss()));
  await page.goto(url);
  return page;
}
export async function close(page) {
  assert.deepEqual(page.complaints, []);
  await page.context().close();
}

export const text = (page, selector) => page.locator(selector).first().innerText();
// What is asked for may not be on the page yet.
export async function until(page, what, condition, argument) {
  const end = Date.now() + kPatience_ms;
  let why = "it never came true";
  while (Date.now() < end) {
    try {
      if (await page.evaluate(condition, argument)) return;
    } catch (error) {
      why = error.message;
    }
    await new Promise((resolve) => setTimeout(resolve, 100));
  }
  throw new Error(`${what}: ${why}`);
}
// How many colours a canvas shows: one that nothing was drawn on has one.
export const coloursOf = (page, selector) => page.locator(selector).evaluate((canvas) => {
  const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
  const colours = new Set();
  for (let k = 0; k < data.length; k += 28) colours.add((data[k] << 16) | (data[k + 1] << 8) | data[k + 2]);
  return colours.size;
});
export async function screenshot(page, name) {
  await page.screenshot({ path: `${screens}/${name}.png` });
}
// Nothing stands out of the window to the right.
export async function fits(page) {
  const [wide, window] = await page.evaluate(() => [document.documentElement.scrollWidth, document.documentElement.clientWidth]);
  assert.ok(wide <= window + 1, `the page is ${wide} px wide in a window of ${window}`);
}

// All of them, or with STORY=name in the environment that one.
export async function tell(stories) {
  const { STORY: only } = process.env;
  try {
    for (const story of stories.filter(({ name }) => !only || name === only)) {
      const began = Date.now();
      await story();
      console.log(`ok: ${story.name} (${((Date.now() - began) / 1000).toFixed(1)} s)`);
    }
    await browser.close();
  } finally {
    for (const child of running) child.kill("SIGKILL");
  }
  process.exit(0);
}
