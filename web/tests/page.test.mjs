// The page in Debian's headless Chromium: what each panel says is so, files are opened, keys and phones work.
import { gzipSync } from "node:zlib";
import assert from "node:assert/strict";
import { mkdirSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { open } from "./browser.mjs";
import { serve } from "./server.mjs";

let server, browser, page, url;
before(async () => {
  [server, browser] = [await serve(), await open()];
  url = `${server.url}/web/page/index.html`;
  page = await browser.page(url);
  await page.until("window.dq8?.ready");
});
after(async () => { await browser?.close(); server?.close(); });

const near = (got, expected, bound, what) => assert.ok(Math.abs(got - expected) <= bound, `${what} is ${got}, not ${expected}`);
const set = (id, value) => page.evaluate(`{ const input = document.getElementById("${id}"); input.value = ${value}; input.dispatchEvent(new Event("input")); }`);
const said = (section) => page.evaluate(`document.querySelector("#${section} output").textContent`);
const dropped = (name, body) => page.evaluate(`(async () => {
  const data = new DataTransfer(), before = document.getElementById("told").textContent;
  data.items.add(new File([${typeof body === "string" ? JSON.stringify(body) : `Uint8Array.from(${JSON.stringify([...body])})`}], ${JSON.stringify(name)}));
  document.dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true }));
  for (let i = 0; i < 200 && document.getElementById("told").textContent === before; i++) await new Promise((later) => setTimeout(later, 20));
  return document.getElementById("told").className + "|" + document.getElementById("told").textContent; })()`);

test("dual quaternions keep the volume of a twisted sleeve, matrices pinch it", async () => {
  assert.equal(await page.evaluate(`getComputedStyle(document.getElementById("yours")).display`), "none", "there is no file yet");
  await set("twist", 0);
  for (const volume of await page.evaluate("dq8.sleeve.volumes")) near(volume, 1, 1e-5, "the volume at rest");
  await set("twist", 180);
  const [linear, dual, mixed] = await page.evaluate("dq8.sleeve.volumes");
  // Rings shrink by |1 − 2w| where matrices blend: over 1/1.6 of the length, a third is left; the rings are 41.
  near(linear, 1 - (2 / 3) / 1.6, 0.01, "linear");
  near(dual, 1, 0.01, "dual");
  assert.ok(linear < mixed && mixed < dual);
  await set("twist", 150);
  assert.match(await said("sleeve"), /Linear \d\d\.\d %.*Dual quaternions (99|100)\.\d %/);
});

test("a screw keeps its distance from the axis, slerp and lerp cut the corner, matrices shrink", async () => {
  for (const [turn, way] of [[150, 50], [90, 50], [150, 0], [0, 30]]) {
    await set("turn", turn); await set("way", way);
    const { radii: [screw, apart, matrices], size } = await page.evaluate("dq8.between"), angle = turn * Math.PI / 180, t = way / 100;
    const chord = Math.hypot(1 - t + t * Math.cos(angle), t * Math.sin(angle));
    near(screw, 1, 2e-6, "screw"); near(apart, chord, 2e-6, "slerp and lerp"); near(matrices, chord, 2e-6, "matrices"); near(size, chord, 2e-6, "size");
  }
  await set("turn", 150); await set("way", 50);
});

test("the crowd is where plain JavaScript has it, its feet on the ground", async () => {
  await page.evaluate(`document.getElementById("pause").checked = true; for (let i = 0; i < 16; i++) dq8.crowd.frame(0.037, false)`);
  // Where a leg is nearly straight, its knee goes by the square root of a rounding.
  near(await page.evaluate("dq8.crowd.difference()"), 0, 2e-4, "the difference of palettes");
  near(await page.evaluate("dq8.crowd.feet()"), 0, 2e-5, "a foot from its target");
  assert.ok(await page.evaluate("dq8.crowd.gl"), "WebGL draws");
  assert.equal(await page.evaluate("dq8.crowd.people"), 400);
  assert.match(await said("crowd"), /dq8 \d+\.\d ms.*JavaScript \d+\.\d ms/);
});

test("the hand follows the keys, and words say what it cannot reach", async () => {
  await page.evaluate(`document.querySelector("#robot canvas").focus()`);
  const before = await page.evaluate("dq8.robot.hand");
  for (let i = 0; i < 3; i++) await page.key("ArrowLeft");
  const { hand, goal, report } = await page.evaluate("dq8.robot");
  assert.equal(report.outcome, "converged");
  assert.ok(Math.hypot(...hand.map((x, k) => x - before[k])) > 0.01, "it has moved");
  hand.forEach((x, k) => near(x, goal[k], 2e-5, "the hand"));
  assert.match(await said("robot"), /The hand is there/);
  for (let i = 0; i < 80; i++) await page.key("ArrowUp");
  assert.match(await said("robot"), /Too far: the arm is stretched toward it, and \d+ mm are missing/);
  for (let i = 0; i < 80; i++) await page.key("ArrowDown");
  assert.match(await said("robot"), /The hand is there|As near as it gets|limits/);
});

const BVH = `HIERARCHY\nROOT hips\n{\n OFFSET 0 1 0\n CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n JOINT knee\n {\n  OFFSET 0 -0.5 0\n  CHANNELS 3 Zrotation Xrotation Yrotation\n  End Site\n  {\n   OFFSET 0 -0.5 0\n  }\n }\n}\nMOTION\nFrames: 2\nFrame Time: 0.5\n0 1 0 0 0 0 0 10 0\n0 1 0 0 0 0 0 40 0\n`;

/** A mesh of three vertices that follows two joints. */
function model(scale) {
  const numbers = [Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0), Uint16Array.of(0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0), Float32Array.of(1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0)], views = [];
  let at = 0;
  for (const { byteLength } of numbers) { views.push({ buffer: 0, byteOffset: at, byteLength }); at += byteLength; }
  const accessor = (bufferView, componentType, type) => ({ bufferView, componentType, type, count: 3 });
  const json = { asset: { version: "2.0" }, buffers: [{ byteLength: at }], bufferViews: views, accessors: [accessor(0, 5126, "VEC3"), accessor(1, 5123, "VEC4"), accessor(2, 5126, "VEC4")],
    meshes: [{ primitives: [{ attributes: { POSITION: 0, JOINTS_0: 1, WEIGHTS_0: 2 } }] }], skins: [{ joints: [1, 2] }], nodes: [{ mesh: 0, skin: 0 }, { children: [2], name: "arm", ...scale }, { translation: [0, 1, 0] }] };
  const text = Buffer.from(JSON.stringify(json)), pad = Buffer.alloc((4 - text.length % 4) % 4, 32), head = Buffer.alloc(20), chunk = Buffer.alloc(8), body = Buffer.concat(numbers.map((part) => Buffer.from(part.buffer)));
  [0x46546c67, 2, 28 + text.length + pad.length + body.length, text.length + pad.length, 0x4e4f534a].forEach((word, i) => head.writeUInt32LE(word, 4 * i));
  chunk.writeUInt32LE(body.length, 0); chunk.writeUInt32LE(0x004e4942, 4);
  return Buffer.concat([head, text, pad, chunk, body]);
}

test("a dropped file plays; a bad one says where it is bad and changes nothing", async () => {
  assert.match(await dropped("legs.bvh", BVH), /^\|legs\.bvh: 3 joints, 2 frames/);
  assert.deepEqual(await page.evaluate("[dq8.yours.joints, dq8.yours.frames]"), [3, 2]);
  assert.match(await dropped("bad.bvh", BVH.replace("OFFSET 0 -0.5 0", "OFFSET 0 x 0")), /^bad\|bad\.bvh: line 8: a number is expected, not x/);
  assert.match(await dropped("short.bvh", BVH.slice(0, -20)), /^bad\|short\.bvh: line 19: the file ends too early/);
  assert.match(await dropped("bad.urdf", "<robot name='r'>\n<link/></robot>"), /^bad\|bad\.urdf: .*line 2/);
  assert.match(await dropped("scaled.glb", model({ scale: [2, 2, 1] })), /^bad\|scaled\.glb: nodes\[1\] \(arm\): scale is 2, 2, 1/);
  assert.match(await dropped("cut.glb", model().subarray(0, 60)), /^bad\|cut\.glb: byte 12: a chunk ends beyond the file/);
  assert.match(await dropped("notes.txt", "x"), /^bad\|notes\.txt: none of/);
  assert.deepEqual(await page.evaluate("[dq8.yours.name, dq8.yours.joints]"), ["legs.bvh", 3], "what played goes on");
  assert.match(await dropped("armature.glb", model({ scale: [0.01, 0.01, 0.01] })), /^\|armature\.glb: 2 joints/);
  assert.match(await dropped("arm.glb", model()), /^\|arm\.glb: 2 joints, .*3 vertices/);
  const robot = readFileSync(new URL("../../robot/robots/arm6.urdf", import.meta.url));
  assert.match(await dropped("arm6.urdf", robot), /^\|arm6\.urdf: \d+ links, \d+ values/);
});

test("keys turn a panel and move a slider, and every panel is reached by them", async () => {
  await page.evaluate(`document.getElementById("twist").focus()`);
  await set("twist", 150);
  await page.key("ArrowLeft");
  assert.equal(await page.evaluate(`document.getElementById("twist").value`), "149");
  const stops = await page.evaluate(`[...document.querySelectorAll("canvas, input, a")].filter((one) => one.tabIndex < 0).length`);
  assert.equal(stops, 0);
});

test("nothing has been said to the console, and the page is small", () => {
  assert.deepEqual(page.messages, []);
  const folder = new URL("../page/", import.meta.url), bytes = readdirSync(folder).filter((name) => /\.(html|js)$/.test(name)).reduce((sum, name) => sum + gzipSync(readFileSync(new URL(name, folder))).length, 0);
  // As servers send it.
  assert.ok(bytes <= 22_000, `${bytes} bytes`);
});

test("a phone has it in its width; without WebGL it says so and goes on", async (t) => {
  const phone = await browser.page(url, { width: 360, height: 740, mobile: true, before: `{ const of = HTMLCanvasElement.prototype.getContext; HTMLCanvasElement.prototype.getContext = function (kind, ...more) { return kind === "webgl2" ? null : of.call(this, kind, ...more); }; }` });
  await phone.until("window.dq8?.ready");
  assert.equal(await phone.evaluate("document.documentElement.scrollWidth"), 360, "nothing lies beside it");
  assert.match(await phone.evaluate(`document.querySelector("#crowd output").textContent`), /has no WebGL/);
  // With nothing to draw in software, ten thousand are soon computed.
  await phone.evaluate(`document.getElementById("people").value = 100; document.getElementById("pause").checked = true; dq8.crowd.frame(0.1)`);
  assert.match(await phone.evaluate(`document.querySelector("#crowd output").textContent`), /10,000 people.*warming up/);
  assert.equal(await phone.evaluate("dq8.crowd.ratio ?? null"), null, "no ratio before both have run");
  await phone.evaluate(`for (let i = 0; i < 14; i++) dq8.crowd.frame(0.1)`);
  assert.ok(await phone.evaluate("dq8.crowd.ratio") > 0);
  near(await phone.evaluate("dq8.crowd.difference()"), 0, 2e-4, "the difference of palettes");
  t.diagnostic(await phone.evaluate(`document.querySelector("#crowd output").textContent`));
  assert.deepEqual(phone.messages, []);
  mkdirSync(new URL("../target/", import.meta.url), { recursive: true });
  writeFileSync(new URL("../target/phone.png", import.meta.url), await phone.screenshot());
});

test("a picture of the page is kept", async () => {
  const whole = await browser.page(url, { width: 1000, height: 640 });
  await whole.until("window.dq8?.ready");
  await whole.evaluate(`document.getElementById("pause").checked = true; for (let i = 0; i < 120; i++) dq8.crowd.frame(0.037, false); dq8.crowd.frame(0.037)`);
  const picture = await whole.screenshot(0.6);
  assert.ok(picture.length > 50000);
  writeFileSync(new URL("../target/page.png", import.meta.url), picture);
});
