// The page in the engine that the variable `ENGINE` names: it draws and moves, opens files, hears keys,
// and says nothing to the console. `web/tests` has the rest, in Chromium. A picture is left in
// `web/target/engines`.
import assert from "node:assert/strict";
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { File } from "../tests/glb.mjs";
import { serve } from "../tests/server.mjs";
import { drive } from "./browsers.mjs";

const { ENGINE } = process.env;
/** Keeps what scripts and files that are missing say, from before the page's own scripts on. */
const LISTENING = `<script>
  window.saidToConsole = [];
  for (const kind of ["error", "warn", "assert"]) {
    const own = console[kind];
    console[kind] = (...words) => {
      saidToConsole.push(kind + ": " + words.join(" "));
      own.apply(console, words);
    };
  }
  const say = (event) => saidToConsole.push(event.type + ": " + (event.reason ?? event.message ?? event.target?.src));
  for (const type of ["error", "unhandledrejection", "securitypolicyviolation"]) addEventListener(type, say, true);
</script>`;
let server, page, folder;
before(async () => {
  [server, folder] = [await serve(0, { first: LISTENING }), mkdtempSync(join(tmpdir(), "dq8-files-"))];
  page = await drive(ENGINE);
  await page.go(`${server.url}/web/page/index.html`);
  await page.until("window.dq8?.ready");
});
after(async () => {
  await page?.close();
  server?.close();
  rmSync(folder, { recursive: true, force: true });
});

const said = (section) => page.evaluate(`document.querySelector("#${section} .numbers").textContent`);
const told = () => page.until(`document.getElementById("told").textContent`);
/** Chooses a file, as people do. */
async function choose(name, body) {
  writeFileSync(join(folder, name), body);
  await page.evaluate(`document.getElementById("told").textContent = ""`);
  await page.type("#file", join(folder, name));
  return told();
}
/** The part of a panel that WebGL has drawn on. */
const covered = (section) => page.evaluate(`(() => {
  const { scene } = dq8.${section}, { gl } = scene, { width, height } = scene.below;
  scene.draw();
  const pixels = new Uint8Array(4 * width * height);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  return [pixels.filter((x, i) => i % 4 === 3 && x > 127).length / (width * height), gl.getError()];
})()`);

test("the crowd moves, WebGL draws it, and its palettes are those of plain JavaScript", async () => {
  const before = await page.evaluate("[dq8.crowd.scene.draws, dq8.crowd.crowd.at[0]]");
  await page.until(`dq8.crowd.scene.draws > ${before[0] + 2} && dq8.crowd.crowd.at[0] !== ${before[1]}`);
  assert.match(await said("crowd"), /^\d+\.\d ms for 400 people: .* 7,600 matrices$/);
  const [part, error] = await covered("crowd");
  assert.ok(part > 0.1 && error === 0, `${part} of the panel is drawn on; WebGL's error is ${error}`);
  const [difference, feet] = await page.evaluate(`(() => {
    document.getElementById("pause").checked = true;
    dq8.crowd.compare();
    for (let i = 0; i < 25; i++) dq8.crowd.frame(0.037);
    return [dq8.crowd.crowd.difference(), dq8.crowd.crowd.feet()];
  })()`);
  assert.ok(difference < 2e-4 && feet < 2e-5, `${difference} and ${feet}`);
});

test("all panels are drawn, with their numbers", async () => {
  for (const section of ["sleeve", "robot", "between"]) {
    await page.evaluate(`document.getElementById("${section}").scrollIntoView()`);
    await page.until(`dq8.${section}.scene.draws > 0`);
    assert.match(await said(section), /\d/);
    if (section === "between") continue;
    const [part, error] = await covered(section);
    assert.ok(part > 0.01 && error === 0, `${section}: ${part}; WebGL's error is ${error}`);
  }
});

test("keys move the hand of the robot", async () => {
  const before = await page.evaluate("dq8.robot.hand");
  await page.type("#robot canvas[tabindex]", "ArrowLeft");
  await page.until("!dq8.robot.asked");
  const hand = await page.evaluate("dq8.robot.hand");
  assert.ok(Math.hypot(...hand.map((x, k) => x - before[k])) > 0.005, `${before} to ${hand}`);
  assert.match(await said("robot"), /The hand is there/);
});

test("files that are chosen and dropped are read in a worker and play; a bad one is told", async () => {
  const file = new File(), attributes = {
    POSITION: file.accessor("VEC3", [0, 0, 0, 1, 0, 0, 0, 1, 0]),
    JOINTS_0: file.accessor("VEC4", Uint16Array.of(0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0)),
    WEIGHTS_0: file.accessor("VEC4", [1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0]),
  };
  const samplers = [{
    input: file.accessor("SCALAR", [0, 1]),
    output: file.accessor("VEC4", [0, 0, 0, 1, 0, 0, Math.SQRT1_2, Math.SQRT1_2]),
  }];
  const json = {
    meshes: [{ primitives: [{ attributes }] }],
    skins: [{ joints: [1, 2] }],
    nodes: [{ mesh: 0, skin: 0 }, { children: [2] }, { translation: [0, 1, 0] }],
    animations: [{ samplers, channels: [{ sampler: 0, target: { node: 1, path: "rotation" } }] }],
  };
  const body = Buffer.from(file.bytes(json));
  assert.match(await choose("arm.glb", body), /^arm\.glb: 2 joints, \d+ frames at 30 a second, 3 vertices$/);
  await page.until("dq8.yours.scene.draws > 1");
  const [part, error] = await covered("yours");
  assert.ok(part > 0.01 && error === 0, `${part} of the panel is drawn on; WebGL's error is ${error}`);
  assert.match(await choose("cut.glb", body.subarray(0, 60)), /^cut\.glb: byte 12: a chunk ends beyond the file/);
  await page.evaluate(`(() => {
    const data = new DataTransfer();
    data.items.add(new File([Uint8Array.from(${JSON.stringify([...body])})], "dropped.glb"));
    document.getElementById("told").textContent = "";
    document.dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true }));
  })()`);
  assert.match(await told(), /^dropped\.glb: 2 joints/);
});

test("nothing has been said to the console; a picture is kept", async () => {
  assert.deepEqual(await page.evaluate("saidToConsole"), []);
  assert.deepEqual(page.printed(server.url), []);
  await page.evaluate(`(() => {
    document.getElementById("pause").checked = false;
    scrollTo(0, 0);
    dq8.crowd.scene.ask();
  })()`);
  const draws = await page.evaluate("dq8.crowd.scene.draws");
  await page.until(`dq8.crowd.scene.draws > ${draws + 2}`);
  const picture = await page.picture(), target = new URL("../target/engines/", import.meta.url);
  mkdirSync(target, { recursive: true });
  writeFileSync(new URL(`${ENGINE}.png`, target), picture);
  assert.ok(picture.length > 50_000, `${picture.length} bytes`);
});
