// A person and what a robot has left: memories, recordings, trials, scripts. dashboard_files.mjs PACKAGES STRIATE WORK SCREENS
// The ten questions of docs/dashboard.md are each answered within three clicks.
import assert from "node:assert/strict";
import { readFile, writeFile } from "node:fs/promises";
import { close, coloursOf, corridor, fits, open, run, screenshot, start, tell, text, until, work } from "./dashboard_tools.mjs";

const home = `${work}/home.db`;
const hostile = '<b onclick="window.hacked=1">book</b>';
let clicks = 0;
async function click(page, locator) {
  clicks++;
  await (typeof locator === "string" ? page.locator(locator).first() : locator).click();
}
// What a question was answered with, after three clicks at most.
async function asked(question, answer) {
  clicks = 0;
  await answer();
  assert.ok(clicks <= 3, `${question}: ${clicks} clicks`);
  console.log(`  "${question}": ${clicks} click${clicks === 1 ? "" : "s"}`);
}
const view = (...words) => start(["view", ...words, "--port", "0"]);
async function end(robot, page) {
  await close(page);
  robot.child.kill("SIGINT");
  assert.equal(await robot.ended, 0);
}

async function aMemoryIsReadChangedAndTakenBack() {
  const teach = (name, crop) => run(["teach", name, "--image", "data/pictures/overview.png", "--crop", crop, "--memory", home]);
  await teach("red book", "20,40,300,220");
  await teach("plant", "340,40,300,220");
  await teach(hostile, "700,40,300,220");
  await run([...corridor, "--var", "way=3 m", "--memory", home]);
  const robot = await view(home);
  assert.match(robot.url, /\?token=[0-9a-f]{32}$/, "what may change it needs a token");
  const page = await open(robot.url);
  await until(page, "the list is there", () => document.querySelectorAll("tr[data-name]").length === 3);
  await asked("What does it know about the red book?", async () => {
    await click(page, 'tr[data-name="red book"]');
    assert.match(await text(page, "#about"), /red book[^]*activation[^]*keypoints/);
  });
  await until(page, "its picture is there", () => [...document.querySelectorAll(".landmarks img")].some((image) => image.naturalWidth > 0));
  assert.ok((await coloursOf(page, "canvas.view")) > 30, "the view shows its picture");
  await asked("Will it forget it?", async () => assert.match(await text(page, ".fate"), /a person taught it, so it is not forgotten/i));
  await asked("What has happened with it?", async () => {
    await page.locator('[aria-label="Filter episodes"]').fill("red book");
    assert.match(await text(page, ".episodes"), /taught/);
  });
  await page.locator('[aria-label="Filter episodes"]').fill("");
  assert.equal(await text(page, "tr:nth-child(3) .name").then(() => page.evaluate(() => window.hacked ?? 0)), 0);
  assert.ok((await page.locator(".landmarks").innerText()).includes(hostile));
  await screenshot(page, "memory");

  await page.locator('[aria-label="New name"]').fill("blue book");
  await page.getByRole("button", { name: "Rename" }).click();
  await until(page, "it has its new name", () => document.querySelector('tr[data-name="blue book"]') !== null);
  assert.match(await run(["memory", home, "list"]), /blue book/);
  await page.getByRole("button", { name: "Forget" }).click();
  await until(page, "it is forgotten", () => document.querySelector('tr[data-name="blue book"]') === null);
  assert.doesNotMatch(await run(["memory", home, "list"]), /blue book/);
  await page.locator("#undo").click();
  await until(page, "it is back", () => document.querySelector('tr[data-name="blue book"]') !== null);
  await page.locator("#undo").click();
  await until(page, "and has its name", () => document.querySelector('tr[data-name="red book"]') !== null);
  assert.match(await run(["memory", home, "list"]), /red book/);
  await page.locator('[aria-label="New name"]').fill("plant");
  await page.locator("form button").click();
  await until(page, "a name that is taken is told", () => /plant/.test(document.querySelector("#notice").textContent) && !document.querySelector("#notice").hidden);
  page.complaints = page.complaints.filter((one) => !one.includes("409"));
  // What is learned meanwhile comes by itself.
  await teach("cup", "1020,40,300,220");
  await until(page, "a new one comes", () => document.querySelector('tr[data-name="cup"]') !== null);
  await end(robot, page);
}

async function aMemoryThatIsReadOnlyCannotBeChanged() {
  const robot = await view(home, "--read-only");
  const page = await open(robot.url, { dark: true });
  await page.locator('tr[data-name="plant"]').click();
  assert.equal(await page.getByRole("button", { name: "Forget" }).count(), 0);
  const answer = await fetch(`${robot.url}api/memory/change`, { method: "POST", headers: { "Content-Type": "application/json" }, body: '{"what":"forget","name":"plant"}' });
  assert.equal(answer.status, 404);
  await screenshot(page, "memory_dark");
  await page.setViewportSize({ width: 390, height: 844 });
  await fits(page);
  await end(robot, page);
}

async function aRecordingIsScrubbedSteppedAndPlayed() {
  const names = ["one", "two"].map((name) => `${work}/${name}.rec`);
  await run([...corridor, "--record", names[0]]);
  await run([...corridor.slice(0, -2), "4", "--quiet", "--record", names[1]]);
  const robot = await view(names[0]);
  const page = await open(robot.url);
  await until(page, "it is read", () => Number(document.querySelector("#scrub").max) > 50);
  await until(page, "to its end", () => !document.querySelector(".runbar .note").textContent.includes("being read"));
  await asked("What did it see and want in the middle of the run?", async () => {
    const box = await page.locator(".runbar canvas").boundingBox();
    clicks++;
    await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
    await until(page, "that cycle is shown", () => parseFloat(document.querySelector(".now .big").textContent) > 0.1);
  });
  await until(page, "the image is drawn", () => document.querySelector(".camera .note").textContent.includes("salient"));
  const place = () => text(page, "#place");
  const before = await place();
  await page.keyboard.press("ArrowRight");
  assert.notEqual(await place(), before);
  await page.keyboard.press("ArrowLeft");
  assert.equal(await place(), before);
  await asked("Why did it stand or slow down there?", async () => {
    const jump = page.locator('.jumps button').first();
    await click(page, jump);
    await until(page, "it says why", () => document.querySelector(".whyline").textContent.length > 3 && document.querySelector(".limit").textContent.length > 3);
  });
  await asked("What was decided, and when?", async () => {
    await click(page, ".log li time");
    assert.match(await place(), /cycle \d+/);
  });
  await page.locator("#scrub").fill("5");
  await page.locator('[aria-label="Speed"]').selectOption("10");
  await page.locator("#play").click();
  await until(page, "it plays", () => Number(document.querySelector("#scrub").value) > 40);
  await page.locator("#play").click();
  await fits(page);
  await screenshot(page, "recording");
  await end(robot, page);

  const both = await view(...names);
  const compared = await open(both.url);
  await asked("From where on do two runs differ, and in what?", async () => {
    await until(compared, "it is told", () => document.querySelector(".difference table") !== null && document.querySelectorAll(".runbar .note")[0].textContent.includes("cycles"));
    await click(compared, compared.getByRole("button", { name: "Show it" }));
    assert.match(await text(compared, ".difference"), /They decide otherwise from cycle \d+ on/);
  });
  await end(both, compared);
}

async function anMcapFileIsShownAsARecordingIs() {
  await run(["export", `${work}/one.rec`, "--mcap", `${work}/one.mcap`, "--quiet"]);
  const robot = await view(`${work}/one.mcap`);
  const page = await open(robot.url, { dark: true });
  // It may be looked at while it is read, and only as far as it is read.
  await until(page, "it is read that far", () => Number(document.querySelector("#scrub").max) >= 60);
  await page.locator("#scrub").fill("60");
  await until(page, "a cycle is shown", () => /cycle 61/.test(document.querySelector("#place").textContent) && document.querySelectorAll(".tree li").length > 1);
  await end(robot, page);
}

async function trialsAreATableAndRunsToDriveAgain() {
  await run(["trial", "--worlds", "config/worlds/short.yaml", "--runs", "2", "--out", `${work}/trial`]);
  // A run that has touched something, as the judge writes it.
  const file = `${work}/trial/runs/${(await import("node:fs")).readdirSync(`${work}/trial/runs`).find((name) => name.endsWith(".json"))}`;
  const json = JSON.parse(await readFile(file, "utf8"));
  Object.assign(json, { outcome: "collision", reason: "touched table 1", collisions: [{ time_s: 9, along_m: 5, left_m: 0.4, hit: "table <1>", light_level: 0.8, moving: false }] });
  await writeFile(file, JSON.stringify(json));
  const robot = await view(`${work}/trial`);
  const page = await open(robot.url);
  await until(page, "the runs are there", () => document.querySelectorAll(".runs tbody tr").length === 2);
  await asked("Which runs failed, where, and how do I drive one again?", async () => {
    await click(page, "#failed");
    await click(page, ".runs tbody tr");
    assert.match(await text(page, "pre.command"), /^striate run config\/tasks\/corridor.yaml --world .*short.yaml --seed \d/);
    assert.match(await text(page, ".trials .right"), /table <1>[^]*5.00 m along/);
  });
  assert.match(await text(page, ".markdown"), /What went wrong/);
  await screenshot(page, "trials");
  await end(robot, page);
}

async function aScriptIsMendedWhileItIsShown() {
  const file = `${work}/mine.yaml`;
  const good = await readFile("config/tasks/find_and_return.yaml", "utf8");
  const lines = (await readFile("config/tasks/corridor.yaml", "utf8")).split("\n");
  const wrong = lines.findIndex((line) => line.includes("traverse_corridor")) + 1;
  await writeFile(file, lines.join("\n").replace("traverse_corridor", "traverse_coridor"));
  const robot = await view(file);
  const page = await open(robot.url);
  await asked("What is wrong with my script, in which line?", async () => {
    await until(page, "the mistake is told", () => document.querySelector(".mistakes [data-kind=error]") !== null);
    assert.match(await text(page, ".mistakes [data-kind=error]"), new RegExp(`line ${wrong} unknown action 'traverse_coridor'`));
    assert.equal(await page.locator(".script li.wrong").getAttribute("data-line"), String(wrong));
  });
  await asked("What may I write there instead?", async () => {
    await page.locator('[aria-label="Filter actions"]').fill("traverse");
    await click(page, ".actions summary");
    assert.match(await text(page, ".actions details[open]"), /speed/);
  });
  await screenshot(page, "task");
  await writeFile(file, good);
  await until(page, "it is mended", () => document.querySelector(".mistakes [data-kind=good]") !== null && document.querySelectorAll(".tree li").length > 5);
  await end(robot, page);
}

async function aWrongFileIsToldInWords() {
  await writeFile(`${work}/empty`, "");
  for (const [file, words] of [[`${work}/nothing.rec`, /nothing.rec/], [work, /no folder of a trial/]]) {
    assert.match(await run(["view", file, "--port", "0"], { expected: 2 }), words);
  }
}

await tell([aMemoryIsReadChangedAndTakenBack, aMemoryThatIsReadOnlyCannotBeChanged, aRecordingIsScrubbedSteppedAndPlayed, anMcapFileIsShownAsARecordingIs,
  trialsAreATableAndRunsToDriveAgain, aScriptIsMendedWhileItIsShown, aWrongFileIsToldInWords]);
