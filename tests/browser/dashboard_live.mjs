// A person and a robot that runs: dashboard_live.mjs PACKAGES STRIATE WORK SCREENS
import assert from "node:assert/strict";
import { readFile, writeFile } from "node:fs/promises";
import http from "node:http";
import { close, coloursOf, corridor, fits, open, run, screenshot, start, tell, text, until, work } from "./dashboard_tools.mjs";

// In a long corridor: on a busy machine a short mission is over before all is asked for.
const long = corridor.map((word) => word.replace("short.yaml", "corridor_a.yaml"));
const live = (...more) => start([...long, "--view", "0", "--real-time", ...more]);
const moves = () => parseFloat(document.querySelector(".now .big").textContent) > 0.15;

// Without what the clock on the wall says.
async function result(file) {
  const { mean_cycle_ms, realtime_factor, ...rest } = JSON.parse(await readFile(file, "utf8"));
  return rest;
}

async function aMissionIsWatchedToItsEndAndIsTheSameBitForBit() {
  await run([...corridor, "--result", `${work}/alone.json`, "--record", `${work}/alone.rec`]);
  const robot = await start([...corridor, "--view", "0", "--real-time", "--result", `${work}/seen.json`, "--record", `${work}/seen.rec`]);
  const page = await open(robot.url, { quiet: true });
  // One that never reads what it asks for is no hindrance.
  const deaf = await open(robot.url, { quiet: true });
  await until(deaf, "it is deaf", () => {
    window.striate.stream.socket.onmessage = () => { for (const end = Date.now() + 1000; Date.now() < end;); };
    return true;
  });
  // First what holds only while it runs: on a busy machine the rest takes longer than the mission.
  await until(page, "it moves", moves);
  assert.match(await text(page, "#state"), /runs/);
  await until(page, "the tree runs", () => document.querySelector('.tree li[data-state="r"] li[data-state="r"]') !== null);
  assert.match(await text(page, ".tree"), /task corridor/);
  assert.ok((await page.locator(".log li time").count()) > 0, "decisions are told");
  await until(page, "it has ended well", () => document.querySelector("#state").textContent.includes("succeeded"));
  await until(page, "and says so", () => document.querySelector("#notice").textContent.includes("The mission has ended: succeeded"));
  assert.equal(await robot.ended, 0);
  assert.deepEqual(await result(`${work}/seen.json`), await result(`${work}/alone.json`));
  assert.ok((await readFile(`${work}/seen.rec`)).equals(await readFile(`${work}/alone.rec`)), "the recordings are the same");
  await close(page);
  await deaf.context().close();
}

async function whatItSeesIsDrawnInLayers() {
  const robot = await live();
  const page = await open(robot.url, { quiet: true });
  await until(page, "it moves", moves);
  await until(page, "an image is drawn", () => document.querySelector(".camera .note").textContent.includes("salient regions"));
  assert.ok((await coloursOf(page, ".camera canvas")) > 50, "the camera shows a picture");
  await until(page, "the map is drawn", () => window.striate.store.get("/map/local") !== null);
  assert.ok((await coloursOf(page, ".floor canvas")) > 4, "the map shows something");
  for (const layer of ["disparity", "saliency", "keypoints"]) await page.locator(`[data-layer="${layer}"]`).check();
  await until(page, "the layers come", () => window.striate.store.get("/stereo/disparity") && window.striate.store.get("/saliency"));
  await page.locator("#stop").click();
  assert.equal(await robot.ended, 130);
  await close(page);
}

async function stopLetsTheWheelsStand() {
  const robot = await live();
  const page = await open(robot.url, { quiet: true });
  await until(page, "it moves", moves);
  await page.locator("#pause").click();
  await until(page, "it stands", () => Math.abs(parseFloat(document.querySelector(".now .big").textContent)) < 0.01);
  assert.match(await text(page, ".whyline"), /A person drives|paused/i);
  await page.locator("#resume").click();
  await until(page, "it goes on", moves);
  await page.locator("#stop").click();
  assert.equal(await robot.ended, 130);
  await until(page, "the wheels stand", () => Math.abs(window.striate.store.get("/odom").twist.twist.linear.x) < 0.02);
  await until(page, "it says so", () => document.querySelector("#notice").textContent.includes("interrupted"));
  await close(page);
}

async function aProgramThatIsKilledIsToldAndComesBack() {
  const robot = await live();
  const page = await open(robot.url, { quiet: true });
  await until(page, "it moves", moves);
  robot.child.kill("SIGKILL");
  await until(page, "the page says so", () => document.querySelector("#notice").textContent.includes("The program is gone"));
  assert.equal(await text(page, "#state"), "not connected");
  assert.ok(await page.locator("#stop").isDisabled());
  const again = await start([...long, "--real-time", "--view", new URL(robot.url).port]);
  await until(page, "it is there again", () => document.querySelector("#notice").textContent.includes("there again"));
  await until(page, "it moves again", moves);
  again.child.kill("SIGINT");
  assert.equal(await again.ended, 130);
  await close(page);
}

async function keysDriveOnlyWhereTheyMay() {
  const looking = await live();
  const watcher = await open(looking.url, { quiet: true });
  await until(watcher, "it moves", moves);
  assert.equal(await watcher.locator("#drive").count(), 0);
  looking.child.kill("SIGINT");
  await looking.ended;
  await close(watcher);
  const robot = await live("--view-drive");
  const page = await open(robot.url, { quiet: true });
  await until(page, "it moves", moves);
  await page.locator("#drive").click();
  await page.keyboard.down("s");
  await until(page, "it goes back", () => window.striate.store.get("/odom").twist.twist.linear.x < -0.05);
  assert.match(await text(page, ".whyline"), /A person drives/);
  await page.keyboard.up("s");
  await until(page, "the task drives again", () => window.striate.store.get("/striate/wish").driver === "behaviour");
  robot.child.kill("SIGINT");
  await robot.ended;
  await close(page);
}

// A task whose names try to be more than text, with 300 steps.
async function hostileNamesAreText() {
  const name = '<img src=x onerror="window.hacked=1"><script>window.hacked=1</script>';
  const steps = Array.from({ length: 300 }, (_, k) => `  - do:\n      - wait: {for: ${k === 0 ? "20 s" : "0.1 s"}}`);
  await writeFile(`${work}/hostile.yaml`, `striate: 1\nmission: ${JSON.stringify(name)}\ndo:\n${steps.join("\n")}\n`);
  const robot = await start(["run", `${work}/hostile.yaml`, "--world", "config/worlds/short.yaml", "--quiet", "--real-time", "--view", "0"]);
  const page = await open(robot.url, { quiet: true });
  await until(page, "the tree is there", () => document.querySelectorAll(".tree li").length > 600);
  const shown = await text(page, ".tree li .what");
  assert.ok(shown.includes("<img src=x onerror="), shown);
  // Marks that the reader of scripts lets through nowhere, as a file of others may hold them.
  await page.evaluate(() => window.striate.store.put("/log", 1e9, { stamp: { sec: 1, nanosec: 0 }, level: 20, name: "task", msg: "<b>a\u202eevil\u0007\u200b" }));
  await until(page, "it is shown", () => document.querySelector(".log li span").textContent === "<b>a\u27e8U+202E\u27e9evil\u27e8U+0007\u27e9\u27e8U+200B\u27e9");
  assert.ok((await page.title()).includes("<img"));
  assert.equal(await page.evaluate(() => document.querySelectorAll("main img, header img[src=x], main script").length + (window.hacked ?? 0)), 0);
  await page.getByRole("button", { name: "Fold", exact: true }).click();
  assert.ok((await page.locator(".tree li:visible").count()) < 10);
  robot.child.kill("SIGINT");
  await robot.ended;
  await close(page);
}

// A page of another address, here another port, wants to read the robot and to stop it.
async function foreignPagesAreKeptOut() {
  const robot = await live();
  const foreign = http.createServer((_, answer) => answer.writeHead(200, { "Content-Type": "text/html" }).end("<title>foreign</title>"));
  await new Promise((resolve) => foreign.listen(0, "127.0.0.1", resolve));
  const page = await open(`http://127.0.0.1:${foreign.address().port}/`, { quiet: true });
  const tried = await page.evaluate(async (url) => {
    const socket = (protocol) => new Promise((resolve) => {
      const one = new WebSocket(url.replace("http", "ws"), [protocol]);
      one.onopen = () => resolve("open");
      one.onerror = () => resolve("refused");
    });
    const read = (path, how) => fetch(url + path, how).then(async (answer) => (answer.type === "opaque" ? "opaque" : `read: ${await answer.text()}`), () => "refused");
    const tag = (name, attribute) => new Promise((resolve) => {
      const one = document.createElement(name);
      one.onload = () => resolve("loaded");
      one.onerror = () => resolve("refused");
      one[attribute] = `${url}app.js`;
      document.body.append(one);
    });
    return [await socket("foxglove.sdk.v1"), await read("api/what"), await read("api/what", { mode: "no-cors" }), await tag("script", "src"),
      await read("api/memory/change", { method: "POST", mode: "no-cors", body: '{"what":"forget"}' })];
  }, robot.url);
  for (const one of tried) assert.equal(one, "refused", JSON.stringify(tried));
  const { host } = new URL(robot.url);
  const ask = (headers) => new Promise((resolve) => http.get({ host: "127.0.0.1", port: host.split(":")[1], path: "/api/what", headers }, (answer) => resolve(answer.statusCode)));
  assert.equal(await ask({ host }), 200);
  assert.equal(await ask({ host: "evil.example" }), 403); // DNS that was turned to here
  assert.equal(await ask({ host, origin: "null" }), 403);
  assert.equal(await ask({ host, origin: "http://evil.example" }), 403);
  assert.equal(await ask({ host, "sec-fetch-site": "cross-site" }), 403);
  await close(page);
  foreign.close();
  robot.child.kill("SIGINT");
  assert.equal(await robot.ended, 130);
}

async function beyondLoopbackATokenIsNeeded() {
  const robot = await live("--listen", "0.0.0.0");
  const { port, searchParams } = new URL(robot.url);
  assert.equal(searchParams.get("token").length, 32);
  const page = await open(`http://127.0.0.1:${port}/?token=${searchParams.get("token")}`, { quiet: true });
  await until(page, "it moves", moves);
  assert.ok(!page.url().includes("token"), "the address does not keep it");
  await page.reload(); // by its cookie
  await until(page, "it moves", moves);
  for (const path of ["", "?token=0123", "app.js", "api/what"]) {
    const answer = await fetch(`http://127.0.0.1:${port}/${path}`);
    assert.equal(answer.status, 403, path);
  }
  robot.child.kill("SIGINT");
  await robot.ended;
  await close(page);
}

async function itIsGoodToLookAt() {
  const robot = await live();
  for (const [name, how] of Object.entries({
    live: {}, live_small: { scale: 0.6 }, live_dark: { dark: true }, live_phone: { width: 390, height: 844 }, live_phone_dark: { width: 390, height: 844, dark: true },
  })) {
    const page = await open(robot.url, { ...how, quiet: true });
    await until(page, "it moves", moves);
    await until(page, "there is a map", () => window.striate.store.get("/map/local") && window.striate.live.camera.bitmap);
    await page.waitForTimeout(1500);
    await fits(page);
    await screenshot(page, name);
    await close(page);
  }
  robot.child.kill("SIGINT");
  await robot.ended;
}

await tell([aMissionIsWatchedToItsEndAndIsTheSameBitForBit, whatItSeesIsDrawnInLayers, stopLetsTheWheelsStand, aProgramThatIsKilledIsToldAndComesBack,
  keysDriveOnlyWhereTheyMay, hostileNamesAreText, foreignPagesAreKeptOut, beyondLoopbackATokenIsNeeded, itIsGoodToLookAt]);
