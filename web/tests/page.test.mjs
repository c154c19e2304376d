// The page in Debian's headless Chromium: what each panel says is so, files are opened, keys,
// fingers and phones work.
import { gzipSync } from "node:zlib";
import assert from "node:assert/strict";
import { mkdirSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { open } from "./browser.mjs";
import { File } from "./glb.mjs";
import { serve } from "./server.mjs";

const DESK = { width: 1280, height: 900 },
  PHONE = { width: 390, height: 844, mobile: true };
let server, browser, page, url;
before(async () => {
  [server, browser] = [await serve(), await open()];
  url = `${server.url}/web/page/index.html`;
  page = await browser.page(url, DESK);
  await page.until("window.dq8?.ready");
});
after(async () => {
  await browser?.close();
  server?.close();
});

const near = (got, expected, bound, what) =>
  assert.ok(Math.abs(got - expected) <= bound, `${what} is ${got}, not ${expected}`);
const set = (id, value) =>
  page.evaluate(`{
    const input = document.getElementById("${id}");
    input.value = ${value};
    input.dispatchEvent(new Event("input"));
  }`);
const said = (section, on = page) => on.evaluate(`document.querySelector("#${section} .numbers").textContent`);
const dropped = (name, body, on = page, others = []) => {
  const part = typeof body === "string" ? JSON.stringify(body) : `Uint8Array.from(${JSON.stringify([...body])})`;
  return on.evaluate(`(async () => {
    const data = new DataTransfer(), told = document.getElementById("told");
    data.items.add(new File([${part}], ${JSON.stringify(name)}));
    for (const other of ${JSON.stringify(others)}) data.items.add(new File(["x"], other));
    told.textContent = "";
    document.dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true }));
    for (let i = 0; i < 500 && !told.textContent; i++) await new Promise((later) => setTimeout(later, 20));
    return told.className + "|" + told.textContent;
  })()`);
};
/** Waits until the robot's hand is where its worker has brought it. */
const arrived = (on = page) => on.until("!dq8.robot.asked");
/** Goes to a panel, and waits until it has been seen. */
const go = async (section, on = page) => {
  await on.evaluate(`document.getElementById("${section}").scrollIntoView()`);
  await on.until(`dq8.${section}.scene.seen`);
};

test("the first screen says for whom dq8 is, how to install it and where to read on; a crowd moves on it", async () => {
  for (const [name, size] of Object.entries({ DESK, PHONE })) {
    const own = size === DESK ? page : await browser.page(url, size);
    await own.until("window.dq8?.crowd?.scene.draws > 2");
    const parts = ["h1", "h1 + p", "pre", "nav", "#crowd .stage", "#crowd .numbers"];
    const outside = await own.evaluate(`${JSON.stringify(parts)}.filter((of) => {
      const { top, bottom, left, right, width } = document.querySelector(of).getBoundingClientRect();
      return !(width > 0 && top >= 0 && left >= 0 && bottom <= innerHeight && right <= innerWidth);
    })`);
    assert.deepEqual(outside, [], name);
    const before = await own.evaluate("[dq8.crowd.scene.draws, dq8.crowd.crowd.at[0]]");
    await own.until(`dq8.crowd.scene.draws > ${before[0] + 2} && dq8.crowd.crowd.at[0] !== ${before[1]}`);
    if (own !== page) await own.close();
  }
  assert.match(await said("crowd"), /^\d+\.\d ms for 400 people: .* 7,600 matrices$/);
  const meta = await page.evaluate(`["description", "og:title", "og:description", "og:image"].map((name) =>
    document.querySelector('meta[name="' + name + '"], meta[property="' + name + '"]').content.length)`);
  assert.ok(meta.every((length) => length > 5));
  // Where a link leads is there. The repository is linked as soon as the package says where it is.
  const links = await page.evaluate(`Promise.all([...document.querySelectorAll("a")].map(async ({ href }) =>
    [href, (await fetch(href)).status, !new URL(href).hash || Boolean(document.querySelector(new URL(href).hash))]))`);
  for (const link of links) assert.deepEqual(link.slice(1), [200, true], link[0]);
  const { repository } = JSON.parse(readFileSync(new URL("../package/package.json", import.meta.url)));
  if (repository) assert.ok(links.some(([href]) => href === (repository.url ?? repository)), "the repository");
});

test("every panel fits its window, with its numbers and what moves them", async () => {
  for (const size of [DESK, PHONE]) {
    const own = await browser.page(url, size);
    await own.until("window.dq8?.ready");
    await dropped("legs.bvh", BVH, own);
    for (const section of ["crowd", "yours", "sleeve", "robot", "between"]) {
      await go(section, own);
      const parts = `#${section} :is(h1, h2, p, .stage, input, button)`;
      const outside = await own.evaluate(`[...document.querySelectorAll("${parts}")]
        .filter((one) => one.getClientRects().length)
        .map((one) => [one.id || one.className || one.tagName, one.getBoundingClientRect()])
        .filter(([, { top, bottom }]) => top < -1 || bottom > innerHeight + 1).map(([name]) => name)`);
      assert.deepEqual(outside, [], `${section} at ${size.width}`);
      const [high, wide] = await own.evaluate(`(({ clientHeight, clientWidth }) => [clientHeight, clientWidth])(
        document.querySelector("#${section} canvas[tabindex]"))`);
      assert.ok(high >= 200 && wide >= 300, `${section} at ${size.width}: ${wide} × ${high}`);
      await own.until(`dq8.${section}.scene.draws > 0`);
    }
    assert.equal(await own.evaluate("document.documentElement.scrollWidth"), size.width, "nothing lies beside it");
    // All that may be said at once has room.
    const edges = await own.evaluate(`(() => {
      for (const id of ["compared", "told"]) {
        document.getElementById(id).textContent = "Many words are said. ".repeat(9);
      }
      document.getElementById("reading").hidden = false;
      const rect = (of) => document.querySelector(of).getBoundingClientRect();
      return [rect(".live").bottom, rect("#drop").top, rect("#drop").bottom, rect("#crowd").bottom];
    })()`);
    assert.deepEqual(edges, edges.slice().sort((a, b) => a - b), `what is in the first panel at ${size.width}`);
    assert.deepEqual(own.messages, []);
    await own.close();
  }
});

test("on a phone a swipe over a picture scrolls, across it turns it, and on the ring drags the hand", async () => {
  const phone = await browser.page(url, PHONE);
  await phone.until("window.dq8?.ready");
  // So few are soon drawn in software.
  await phone.evaluate(`document.getElementById("people").value = 5`);
  const state = (section) => phone.evaluate(`(() => {
    const { left, top, width, height } = document.querySelector("#${section} canvas[tabindex]").getBoundingClientRect();
    return { x: left + width / 2, y: top + height / 2, scroll: scrollY, yaw: dq8.${section}.scene.yaw };
  })()`);
  for (const section of ["crowd", "sleeve", "robot", "between"]) {
    await go(section, phone);
    const before = await state(section);
    // Beside the arm; down from the last panel, below which nothing is.
    const x = section === "robot" ? 40 : before.x,
      way = section === "between" ? 1 : -1;
    await phone.swipe(x, before.y, 0, way * 220);
    const scrolled = await state(section);
    assert.ok(-way * (scrolled.scroll - before.scroll) > 100, `${section}: ${before.scroll} to ${scrolled.scroll}`);
    if (section === "robot") continue;
    await go(section, phone);
    const again = await state(section);
    await phone.swipe(again.x, again.y, 120, 0);
    const turned = await state(section);
    near(turned.scroll, again.scroll, 1, `${section} stays: how far it is scrolled`);
    near(turned.yaw - again.yaw, 1.2, 0.3, `${section}: by how much it turns`);
  }
  await go("robot", phone);
  const [x, y, scroll] = await phone.evaluate(`(() => {
    const { scene, goal: [a, b, c] } = dq8.robot, [x, y] = scene.project()(a, c, -b),
      { left, top } = scene.canvas.getBoundingClientRect();
    return [left + x, top + y, scrollY];
  })()`);
  const before = await phone.evaluate("dq8.robot.goal");
  await phone.swipe(x, y, -10, -30);
  await arrived(phone);
  const { hand, goal } = await phone.evaluate("({ hand: dq8.robot.hand, goal: dq8.robot.goal })");
  assert.ok(goal[2] - before[2] > 0.01, `${before} to ${goal}`);
  hand.forEach((value, k) => near(value, goal[k], 1e-4, "the hand"));
  assert.equal(await phone.evaluate("scrollY"), scroll, "a finger on the ring does not scroll");
  assert.deepEqual(phone.messages, []);
  await phone.close();
});

test("what is out of view is not drawn, and goes on when it is in view again", async () => {
  const own = await browser.page(url, { width: 600, height: 400 });
  await own.until("window.dq8?.ready");
  await own.evaluate(`document.getElementById("people").value = 5`);
  await dropped("legs.bvh", BVH, own);
  await go("between", own);
  await own.until("!dq8.yours.scene.seen && !dq8.crowd.scene.seen");
  const draws = "Object.values(dq8).filter((panel) => panel?.scene).map(({ scene }) => scene.draws)";
  await own.evaluate(`document.getElementById("twist").dispatchEvent(new Event("input"))`);
  const before = await own.evaluate(draws);
  await own.evaluate("new Promise((later) => setTimeout(later, 1000))");
  const after = await own.evaluate(draws);
  // The panel that is seen may be drawn; it does not move by itself.
  assert.ok(after.reduce((sum, x, i) => sum + x - before[i], 0) <= 1, `${before} to ${after}`);
  await go("yours", own);
  const drawn = await own.evaluate("dq8.yours.scene.draws");
  await own.until(`dq8.yours.scene.draws > ${drawn + 2}`);
  await own.close();
});

test("text has a contrast of 4.5 in both schemes", async () => {
  const low = `(() => {
    const parts = (text) => text.match(/[\\d.]+/g).map(Number);
    const linear = (x) => x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4;
    const light = ([r, g, b]) => 0.2126 * linear(r / 255) + 0.7152 * linear(g / 255) + 0.0722 * linear(b / 255);
    const contrast = (a, b) => ((x, y) => (Math.max(x, y) + 0.05) / (Math.min(x, y) + 0.05))(light(a), light(b));
    const under = (one) => {
      const colour = parts(getComputedStyle(one).backgroundColor);
      return colour[3] === 0 ? under(one.parentElement) : colour;
    };
    const told = document.getElementById("told"), seen = [];
    told.className = "bad";
    told.textContent = "A file is bad.";
    document.getElementById("compared").textContent = "A comparison.";
    for (const one of document.querySelectorAll("body *")) {
      if (![...one.childNodes].some((node) => node.nodeType === 3 && node.data.trim())) continue;
      const own = parts(getComputedStyle(one).color);
      if (one.getClientRects().length) seen.push([one.tagName + one.className, own, under(one)]);
    }
    // Words on the pictures.
    const stage = parts(getComputedStyle(document.querySelector(".stage")).backgroundColor);
    for (const name of ["a", "b", "c"]) {
      seen.push(["--" + name, parts(getComputedStyle(document.querySelector("." + name)).color), stage]);
    }
    told.textContent = document.getElementById("compared").textContent = "";
    return [seen.length, seen.filter(([, a, b]) => contrast(a, b) < 4.5)];
  })()`;
  for (const value of ["light", "dark"]) {
    await page.call("Emulation.setEmulatedMedia", { features: [{ name: "prefers-color-scheme", value }] });
    const [count, bad] = await page.evaluate(low);
    assert.ok(count > 30, `${count} texts`);
    assert.deepEqual(bad, [], value);
  }
  await page.call("Emulation.setEmulatedMedia", { features: [] });
});

test("parts of the page have roles and names, and what is read aloud keeps still while the crowd moves", async () => {
  assert.equal(await page.evaluate(`document.querySelectorAll("main").length`), 1);
  const nameless = await page.evaluate(`[...document.querySelectorAll("canvas[tabindex], section, progress, nav")]
    .filter((one) => !one.ariaLabel && !document.getElementById(one.getAttribute("aria-labelledby"))
      || one.tagName === "CANVAS" && !(one.role && document.getElementById(one.getAttribute("aria-describedby"))))
    .map((one) => one.outerHTML)`);
  assert.deepEqual(nameless, []);
  await go("crowd");
  const changes = `new Promise((done) => {
    let count = 0;
    const live = document.querySelectorAll("[role=status], [role=alert], [role=log], [aria-live], output");
    const watch = new MutationObserver((all) => (count += all.length));
    for (const one of live) watch.observe(one, { childList: true, characterData: true, subtree: true });
    setTimeout(() => done([live.length, count]), 1500);
  })`;
  const [regions, moving] = await page.evaluate(changes);
  assert.ok(regions >= 3, `${regions} live regions`);
  assert.equal(moving, 0);
  // What a key has changed is read, once it has come to rest.
  await page.evaluate(`document.getElementById("twist").focus()`);
  for (let i = 0; i < 5; i++) await page.key("ArrowLeft");
  assert.equal((await page.evaluate(changes))[1] > 0, true);
  assert.match(await page.evaluate(`document.getElementById("said").textContent`), /Blended matrices \d\d\.\d %/);
});

test("dual quaternions keep the volume of a twisted sleeve, matrices pinch it", async () => {
  const shown = await page.evaluate(`getComputedStyle(document.getElementById("yours")).display`);
  assert.equal(shown, "none", "there is no file yet");
  await set("twist", 0);
  for (const volume of await page.evaluate("dq8.sleeve.volumes")) near(volume, 1, 1e-5, "the volume at rest");
  await set("twist", 180);
  const [linear, dual, mixed] = await page.evaluate("dq8.sleeve.volumes");
  // Rings shrink by |1 − 2w| where matrices blend: over 1/1.6 of the length, a third is left; the
  // rings are 41.
  near(linear, 1 - (2 / 3) / 1.6, 0.01, "linear");
  near(dual, 1, 0.01, "dual");
  assert.ok(linear < mixed && mixed < dual);
  await set("twist", 150);
  assert.match(await said("sleeve"), /matrices \d\d\.\d %, .*dual quaternions (99|100)\.\d %/);
});

test("a screw keeps its distance from the axis, slerp and lerp cut the corner, matrices shrink", async () => {
  for (const [turn, way] of [[150, 50], [90, 50], [150, 0], [0, 30]]) {
    await set("turn", turn);
    await set("way", way);
    const { radii: [screw, apart, matrices], size } = await page.evaluate(
        "({ radii: dq8.between.radii, size: dq8.between.size })",
      ),
      [angle, t] = [(turn * Math.PI) / 180, way / 100],
      chord = Math.hypot(1 - t + t * Math.cos(angle), t * Math.sin(angle));
    near(screw, 1, 2e-6, "screw");
    near(apart, chord, 2e-6, "slerp and lerp");
    near(matrices, chord, 2e-6, "matrices");
    near(size, chord, 2e-6, "size");
  }
  await set("turn", 150);
  await set("way", 50);
});

test("the crowd is where plain JavaScript has it, its feet on the ground; JavaScript runs on demand", async () => {
  const frames = (count, first = "") =>
    page.evaluate(`${first} for (let i = 0; i < ${count}; i++) dq8.crowd.frame(0.037)`);
  await page.evaluate(`document.getElementById("pause").checked = true`);
  await frames(5);
  assert.equal(await page.evaluate("dq8.crowd.crowd.plain ?? null"), null, "nobody has asked");
  // A clock that ticks when it is read: before and behind each half, and not over the ground.
  assert.equal(await page.evaluate("((ticks) => dq8.crowd.crowd.all(() => ticks++))(0)"), 2 * 2);
  // Batches, and a smaller last one.
  assert.deepEqual(await page.evaluate("dq8.crowd.crowd.batches.map(({ count }) => count)"), [256, 144]);
  // All rounds at once, before the page runs one by itself.
  await frames(25, `document.getElementById("compare").click();`);
  assert.ok((await page.evaluate("dq8.crowd.ratio")) > 0);
  const compared = await page.evaluate(`document.getElementById("compared").textContent`);
  assert.match(compared, /^The same loops in plain JavaScript: \d+\.\d ms, (\d+\.\d times as long|but there)/);
  // Where a leg is nearly straight, its knee goes by the square root of a rounding.
  near(await page.evaluate("dq8.crowd.crowd.difference()"), 0, 2e-4, "the difference of palettes");
  near(await page.evaluate("dq8.crowd.crowd.feet()"), 0, 2e-5, "a foot from its target");
  assert.ok(await page.evaluate("Boolean(dq8.crowd.scene.gl)"), "WebGL draws");
});

test("the hand follows the keys, and words say what it cannot reach", async () => {
  await page.evaluate(`document.querySelector("#robot canvas[tabindex]").focus()`);
  const before = await page.evaluate("dq8.robot.hand");
  for (let i = 0; i < 3; i++) await page.key("ArrowLeft");
  await arrived();
  const { hand, goal, report } = await page.evaluate(
    "({ hand: dq8.robot.hand, goal: dq8.robot.goal, report: dq8.robot.report })",
  );
  assert.equal(report.outcome, "converged");
  assert.ok(Math.hypot(...hand.map((x, k) => x - before[k])) > 0.01, "it has moved");
  hand.forEach((x, k) => near(x, goal[k], 2e-5, "the hand"));
  assert.match(await said("robot"), /The hand is there/);
  for (let i = 0; i < 80; i++) await page.key("ArrowUp");
  await arrived();
  assert.match(await said("robot"), /Too far: the arm is stretched toward it, and \d+ mm are missing/);
  for (let i = 0; i < 80; i++) await page.key("ArrowDown");
  await arrived();
  assert.match(await said("robot"), /The hand is there|As near as it gets|limits/);
});

const BVH = `HIERARCHY
ROOT hips
{
 OFFSET 0 1 0
 CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
 JOINT knee
 {
  OFFSET 0 -0.5 0
  CHANNELS 3 Zrotation Xrotation Yrotation
  End Site
  {
   OFFSET 0 -0.5 0
  }
 }
}
MOTION
Frames: 2
Frame Time: 0.5
0 1 0 0 0 0 0 10 0
0 1 0 0 0 0 0 40 0
`;

/** A mesh of three vertices that follows two joints. */
function model(scale) {
  const file = new File(),
    attributes = {
      POSITION: file.accessor("VEC3", [0, 0, 0, 1, 0, 0, 0, 1, 0]),
      JOINTS_0: file.accessor("VEC4", Uint16Array.of(0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0)),
      WEIGHTS_0: file.accessor("VEC4", [1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0]),
    };
  const nodes = [{ mesh: 0, skin: 0 }, { children: [2], name: "arm", ...scale }, { translation: [0, 1, 0] }];
  return new Uint8Array(file.bytes({ meshes: [{ primitives: [{ attributes }] }], skins: [{ joints: [1, 2] }], nodes }));
}

test("a dropped file plays; a bad one says where it is bad and changes nothing", async () => {
  assert.match(await dropped("legs.bvh", BVH), /^\|legs\.bvh: 3 joints, 2 frames/);
  assert.deepEqual(await page.evaluate("[dq8.yours.joints, dq8.yours.frames]"), [3, 2]);
  const bad = [
    ["bad.bvh", BVH.replace("OFFSET 0 -0.5 0", "OFFSET 0 x 0"), /^line 8: a number is expected, not x/],
    ["short.bvh", BVH.slice(0, -20), /^line 19: the file ends too early/],
    ["bad.urdf", "<robot name='r'>\n<link/></robot>", /line 2/],
    ["scaled.glb", model({ scale: [2, 2, 1] }), /^nodes\[1\] \(arm\): scale is 2, 2, 1/],
    ["cut.glb", model().subarray(0, 60), /^byte 12: a chunk ends beyond the file/],
    ["notes.txt", "x", /^none of/],
  ];
  for (const [name, body, text] of bad) {
    const [kind, told] = (await dropped(name, body)).split(/\|(.*)/s);
    assert.equal(kind, "bad", told);
    assert.ok(told.startsWith(`${name}: `), told);
    assert.match(told.slice(name.length + 2), text);
  }
  assert.deepEqual(await page.evaluate("[dq8.yours.name, dq8.yours.joints]"), ["legs.bvh", 3], "what played goes on");
  assert.match(await dropped("armature.glb", model({ scale: [0.01, 0.01, 0.01] })), /^\|armature\.glb: 2 joints/);
  assert.match(await dropped("arm.glb", model()), /^\|arm\.glb: 2 joints, .*3 vertices/);
});

test("of several files the first that can be played is, and words say that the others are not", async () => {
  assert.match(
    await dropped("legs.bvh", BVH, page, ["b.glb", "c.txt"]),
    /^\|legs\.bvh: 3 joints, 2 frames; one file is taken at a time, so not b\.glb, c\.txt$/,
  );
  assert.match(
    await dropped("a.bin", "x", page, ["a.bvh"]),
    /^bad\|a\.bvh: .*HIERARCHY.*; one file is taken at a time, so not a\.bin$/,
  );
  assert.match(
    await dropped("walk.gltf", "{}", page, ["walk.bin"]),
    /^bad\|walk\.gltf: none of \.glb, .*; a \.glb has in one file .*; one file is taken .* not walk\.bin$/,
  );
});

test("a browser whose workers are no modules says so", async () => {
  const old = await browser.page(url, { ...DESK, before: `{
    const Own = Worker;
    window.Worker = class extends Own {
      constructor(address) {
        super(address);
      }
    };
  }` });
  await old.until("window.dq8?.ready");
  assert.match(
    await dropped("legs.bvh", BVH, old),
    /^bad\|legs\.bvh: its reader, a worker that is a module, does not start, as in browsers before 2023: .*import/,
  );
  assert.match(await said("robot", old), /^its reader, a worker that is a module, does not start/);
  await old.close();
});

test("the picture has room for all poses of a clip, and a skeleton that walks away stays in its middle", async () => {
  await dropped("rises.bvh", BVH.replace("0 1 0 0 0 0 0 40 0", "7 5 0 0 0 0 0 0 0"));
  const [size, [x, y]] = await page.evaluate("[dq8.yours.scene.size, dq8.yours.scene.centre]");
  // From the end of the leg in the first pose to the hips in the last.
  const low = 1 - 0.5 * (1 + Math.cos(Math.PI / 18));
  near(y, (low + 5) / 2, 0.02, "the middle");
  near(size, 1.3 * (5 - low), 0.05, "the size");
  near(x, 0, 0.1, "the middle across");
});

test("a mesh is drawn by WebGL, where its joints have it", async () => {
  await dropped("arm.glb", model());
  const [covered, wanted] = await page.evaluate(`(() => {
    const { scene } = dq8.yours, { gl } = scene, pixels = new Uint8Array(4 * scene.below.width * scene.below.height);
    Object.assign(scene, { yaw: 0, pitch: 0 });
    scene.draw();
    gl.readPixels(0, 0, scene.below.width, scene.below.height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    return [pixels.filter((x, i) => i % 4 === 3 && x > 127).length, scene.scale ** 2];
  })()`);
  near(covered / wanted, 1, 0.02, "the part that is covered");
});

test("a robot with nothing that moves is told and changes nothing; another takes its place", async () => {
  const joint = `<joint name="j" type="fixed"><parent link="a"/><child link="b"/></joint>`;
  for (const rest of [`<link name="a"/>`, `<link name="a"/><link name="b"/>${joint}`]) {
    const before = await page.evaluate("[dq8.robot.goal, dq8.robot.hand]");
    assert.match(await dropped("still.urdf", `<robot name="r">${rest}</robot>`), /^bad\|.*none of its joints moves/);
    assert.deepEqual(await page.evaluate("[dq8.robot.goal, dq8.robot.hand]"), before);
    await page.evaluate(`document.querySelector("#robot canvas[tabindex]").focus()`);
    await page.key("ArrowLeft");
    await arrived();
    assert.notDeepEqual(await page.evaluate("dq8.robot.goal"), before[0], "keys still move its goal");
    assert.match(await said("robot"), /The hand is there|As near as it gets|limits/);
  }
  const robot = readFileSync(new URL("../../robot/robots/arm6.urdf", import.meta.url));
  assert.match(await dropped("arm6.urdf", robot), /^\|arm6\.urdf: \d+ links, \d+ values/);
  assert.match(await page.evaluate(`document.querySelector("#robot .about").textContent`), /^\d joints of arm6\.urdf,/);
});

/**
 * Drops a file of many parts, waits in the page until `ready` while it is read, runs `then` there, and gives up. Says
 * what `then` has given, and whether the file was read all the while. Nothing else is drawn, which takes turns of the
 * page where WebGL is computed.
 */
const givenUp = async (name, parts, ready, then) => {
  await go("between");
  await page.until("!dq8.crowd.scene.seen");
  return page.evaluate(`(async () => {
    const reading = document.getElementById("reading"), bar = reading.querySelector("progress");
    const told = document.getElementById("told");
    const pause = (time) => new Promise((later) => setTimeout(later, time));
    const data = new DataTransfer();
    told.textContent = "";
    data.items.add(new File(${parts}, ${JSON.stringify(name)}));
    document.dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true }));
    while (!told.textContent && (reading.hidden || !(${ready}))) await pause(5);
    const answer = await (${then})(), goesOn = !reading.hidden;
    reading.querySelector("button").click();
    while (!told.textContent) await pause(5);
    return [answer, goesOn, reading.hidden, told.textContent];
  })()`);
};

test("a long file is read in a worker, with a bar, and can be given up", async () => {
  await page.evaluate(`document.getElementById("stop").checked = true`);
  const before = await page.evaluate("dq8.yours.name");
  const [head] = BVH.split("0 1 0 0 0 0 0 10 0"),
    rows = `Array(120).fill("0 1 0 0 0 0 0 10 0\\n".repeat(20000))`;
  const [[part, later], ...rest] = await givenUp(
    "long.bvh",
    `[${JSON.stringify(head.replace("Frames: 2", `Frames: ${120 * 20000}`))}, ...${rows}]`,
    "bar.value > 0",
    // The page goes on while it is read.
    `async () => {
      const part = bar.value;
      for (let i = 0; i < 10; i++) await pause(20);
      return [part, bar.value];
    }`,
  );
  assert.ok(later > part, `${part} to ${later}`);
  assert.deepEqual(rest, [true, true, "long.bvh: given up"]);
  assert.equal(await page.evaluate("dq8.yours.name"), before, "what played goes on");
  assert.match(await dropped("legs.bvh", BVH), /^\|legs\.bvh: 3 joints/, "the next file is read");
});

test("a long URDF is read in a worker, and can be given up; one of too many links to be drawn is told", async () => {
  const before = await page.evaluate("[dq8.robot.goal, dq8.robot.hand]"),
    visual = '<visual><geometry><mesh filename="package://robot/part.dae"/></geometry></visual>\n',
    visuals = `Array(800).fill(${JSON.stringify(visual.repeat(1000))})`;
  const [hand, ...rest] = await givenUp(
    "long.urdf",
    `['<robot name="r"><link name="a">', ...${visuals}, "</link></robot>"]`,
    "true",
    // The robot of before follows keys while it is read.
    `async () => {
      const canvas = document.querySelector("#robot canvas[tabindex]");
      canvas.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowLeft" }));
      while (dq8.robot.asked) await pause(5);
      return dq8.robot.hand;
    }`,
  );
  assert.deepEqual(rest, [true, true, "long.urdf: given up"]);
  assert.ok(Math.hypot(...hand.map((x, k) => x - before[1][k])) > 0.005, `${before[1]} to ${hand}`);
  await page.evaluate(`document.querySelector("#robot canvas[tabindex]").focus()`);
  await page.key("ArrowRight");
  await arrived();
  const after = await page.evaluate("[dq8.robot.goal, dq8.robot.hand]");
  after.flat().forEach((x, k) => near(x, before.flat()[k], 1e-3, "the robot of before"));
  const joint = (i) => `<link name="l${i}"/><joint name="j${i}" type="continuous">
    <parent link="l${i - 1}"/><child link="l${i}"/></joint>`;
  const links = Array.from({ length: 2000 }, (_, i) => joint(i + 1)).join("");
  assert.match(
    await dropped("many.urdf", `<robot name="r"><link name="l0"/>${links}</robot>`),
    /^bad\|many\.urdf: it has 2001 links, of which at most 2000 are drawn here$/,
  );
  assert.deepEqual(await page.evaluate("[dq8.robot.goal, dq8.robot.hand]"), after);
});

test("a file that takes the place of one that is read says its own, and can be given up", async () => {
  const [said, ...rest] = await page.evaluate(`(async () => {
    const reading = document.getElementById("reading"), told = document.getElementById("told"), workers = [];
    const pause = (time) => new Promise((later) => setTimeout(later, time));
    const drop = (name, ...parts) => {
      const data = new DataTransfer();
      data.items.add(new File(parts, name));
      document.dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true }));
    };
    const long = ['<robot name="r"><link name="a">', "<visual/>".repeat(3000000)], own = Worker.prototype.postMessage;
    Worker.prototype.postMessage = function (...given) {
      workers.push(this);
      return own.apply(this, given);
    };
    drop("one.urdf", ...long);
    drop("notes.txt", "x");
    await pause(50);
    const said = told.textContent;
    drop("two.urdf", ...long);
    drop("three.urdf", ...long);
    Worker.prototype.postMessage = own;
    // What the reader that has been given up said before it ended.
    workers[1].dispatchEvent(new MessageEvent("message", { data: { error: "late" } }));
    while (reading.hidden && told.textContent === "two.urdf: given up") await pause(5);
    const shown = !reading.hidden, of = reading.querySelector("span").textContent;
    reading.querySelector("button").click();
    await pause(50);
    return [said, shown, of, reading.hidden, told.textContent];
  })()`);
  assert.match(said, /^notes\.txt: none of/);
  assert.deepEqual(rest, [true, "Reading three.urdf", true, "three.urdf: given up"]);
});

test("a robot that fails at one place says so, and goes to the next one", async () => {
  const own = await browser.page(url, DESK);
  await own.until("window.dq8?.ready");
  const press = `document.querySelector("#robot canvas[tabindex]")
    .dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowLeft" }))`;
  await own.evaluate(`{
    const post = Worker.prototype.postMessage;
    Worker.prototype.postMessage = function () {
      Worker.prototype.postMessage = post;
      return post.call(this, null);
    };
    ${press};
  }`);
  await own.until(`/null/.test(document.querySelector("#robot .numbers").textContent)`, 10);
  await own.evaluate(press);
  await own.until("!dq8.robot.asked", 10);
  assert.match(await said("robot", own), /The hand is there/);
  await own.close();
});

test("a robot that is dropped before the page's own has come stays, and files are taken before", async () => {
  const own = await browser.page(url, { ...DESK, before: `{
    const get = window.fetch;
    window.fetch = (...of) =>
      /arm7/.test(of[0]) ? new Promise((go) => (window.late = () => go(get(...of)))) : get(...of);
  }` });
  await own.until("window.dq8?.yours && window.late");
  const robot = readFileSync(new URL("../../robot/robots/arm6.urdf", import.meta.url));
  assert.match(await dropped("arm6.urdf", robot, own), /^\|arm6\.urdf: \d+ links/);
  await own.evaluate("late()");
  await own.until("dq8.ready", 20);
  assert.match(await own.evaluate(`document.querySelector("#robot .about").textContent`), /^\d joints of arm6\.urdf,/);
  await own.close();
});

test("where the hand is asked to go before it has come, it goes to the last place", async () => {
  const [asked, way] = await page.evaluate(`(async () => {
    const canvas = document.querySelector("#robot canvas[tabindex]"), places = [];
    const own = Worker.prototype.postMessage;
    Worker.prototype.postMessage = function (goal) {
      places.push(goal);
      return own.call(this, goal);
    };
    for (let i = 0; i < 20; i++) canvas.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowLeft" }));
    while (dq8.robot.asked) await new Promise((later) => setTimeout(later, 5));
    Worker.prototype.postMessage = own;
    return [places, dq8.robot.goal];
  })()`);
  assert.equal(asked.length, 2, "of twenty places the first and the last");
  assert.deepEqual(asked[1], way);
});

test("keys reach every panel, turn it and move its sliders", async () => {
  await dropped("legs.bvh", BVH);
  await page.evaluate(`document.getElementById("twist").focus()`);
  await set("twist", 150);
  await page.key("ArrowLeft");
  assert.equal(await page.evaluate(`document.getElementById("twist").value`), "149");
  for (const section of ["crowd", "yours", "sleeve", "between"]) {
    await page.evaluate(`document.querySelector("#${section} canvas[tabindex]").focus()`);
    const before = await page.evaluate(`dq8.${section}.scene.yaw`);
    await page.key("ArrowRight");
    near((await page.evaluate(`dq8.${section}.scene.yaw`)) - before, 0.1, 1e-9, section);
  }
  await page.evaluate("document.activeElement.blur()");
  const wanted = await page.evaluate(`[...document.querySelectorAll("canvas[tabindex], input, button, a")]
    .filter((one) => one.getClientRects().length).length`);
  const reached = await page.evaluate("window.reached = new Set(), 0");
  for (let i = reached; i < wanted + 4; i++) {
    await page.key("Tab");
    await page.evaluate("reached.add(document.activeElement), 0");
  }
  const missed = await page.evaluate(`[...document.querySelectorAll("canvas[tabindex], input, button, a")]
    .filter((one) => one.getClientRects().length && !reached.has(one)).map((one) => one.outerHTML)`);
  assert.deepEqual(missed, []);
});

test("nothing has been said to the console, and the page is small", (t) => {
  assert.deepEqual(page.messages, []);
  const folder = new URL("../page/", import.meta.url);
  // As a bundler joins scripts, and as servers compress them: without comments and indentation.
  const bytes = [/\.html$/, /\.js$/].reduce((sum, kind) => {
    const files = readdirSync(folder).filter((name) => kind.test(name)),
      text = files.map((name) => readFileSync(new URL(name, folder), "utf8")).join("\n");
    const lean = text.replace(/^\s*(\/\/.*|\/\*\*[^]*?\*\/)$/gm, "").replace(/^\s+/gm, "");
    return sum + gzipSync(lean, { level: 9 }).length;
  }, 0);
  t.diagnostic(`${bytes} bytes`);
  assert.ok(bytes <= 20_500, `${bytes} bytes`);
});

test("ten thousand people take less than half the time of JavaScript, a frame little more than dq8", async (t) => {
  // With nothing to draw in software, ten thousand are soon computed.
  const phone = await browser.page(url, { ...PHONE, before: `{
    const of = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (kind, ...more) {
      return kind === "webgl2" ? null : of.call(this, kind, ...more);
    };
  }` });
  await phone.until("window.dq8?.ready");
  const missing = await phone.evaluate(`[...document.querySelectorAll(".missing")].map((one) => one.textContent)`);
  assert.equal(missing.filter((text) => /no WebGL: nothing can be drawn/.test(text)).length, 3, "it is said");
  const [ratio, frame, people, difference] = await phone.evaluate(`(() => {
    document.getElementById("pause").checked = true;
    document.getElementById("people").value = 100;
    dq8.crowd.frame(0.1);
    // Others share the machine: the best of five comparisons, and each frame beside its own time.
    const ratios = Array.from({ length: 5 }, () => {
      dq8.crowd.compare();
      for (let i = 0; i < 25; i++) dq8.crowd.frame(0.1);
      return dq8.crowd.ratio;
    }), difference = dq8.crowd.crowd.difference();
    const parts = Array.from({ length: 15 }, () => {
      const start = performance.now();
      dq8.crowd.frame(0.1);
      return (performance.now() - start) / dq8.crowd.taken;
    }).sort((a, b) => a - b);
    return [Math.max(...ratios), parts[7], dq8.crowd.crowd.people, difference];
  })()`);
  t.diagnostic(`JavaScript takes ${ratio.toFixed(1)} times as long, a frame ${frame.toFixed(2)} times`);
  assert.equal(people, 10000);
  near(difference, 0, 2e-4, "the difference of palettes");
  assert.ok(ratio > 2, `${ratio} times`);
  assert.ok(frame < 1.4, `${frame} times`);
  assert.deepEqual(phone.messages, []);
  await phone.close();
});

test("pictures of the page are kept", async () => {
  mkdirSync(new URL("../target/", import.meta.url), { recursive: true });
  for (const [name, size, scale] of [["page", { width: 1000, height: 640 }, 0.6], ["phone", PHONE, 1]]) {
    const own = await browser.page(url, size);
    await own.until("window.dq8?.ready");
    // All panels are drawn once they have been seen.
    for (const section of ["sleeve", "robot", "between", "crowd"]) {
      await go(section, own);
      await own.until(`dq8.${section}.scene.draws > 0`);
    }
    await own.evaluate("for (let i = 0; i < 40; i++) dq8.crowd.frame(0.02)");
    const picture = await own.screenshot(scale);
    assert.ok(picture.length > 50000);
    writeFileSync(new URL(`../target/${name}.png`, import.meta.url), picture);
    await own.close();
  }
});
