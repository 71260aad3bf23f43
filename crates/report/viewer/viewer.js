"use strict";
// The flights are in the element #data: positions in metres in the inertial frame (z up), attitudes as rotation matrices, row by row.
const data = JSON.parse(document.getElementById("data").textContent);
const byId = (id) => document.getElementById(id);
const canvas = byId("view");
const pen = canvas.getContext("2d");
const add = (a, b, k = 1) => [a[0] + k * b[0], a[1] + k * b[1], a[2] + k * b[2]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = (a) => { const n = Math.hypot(...a); return n > 0 ? a.map((v) => v / n) : [0, 0, 0]; };
const column = (m, k) => [m[k], m[3 + k], m[6 + k]];

let flight, scene, time = 0, playing = false, last = 0;
let view = "free", turn = [0, 0.38], zoom = 1;
let colours = {};

/// Size and place of everything that is drawn of a flight, and the heading of its path.
function measure(of) {
  const points = of.position.concat(...of.measured.map((row) => row.filter(Boolean)));
  const low = [0, 1, 2].map((k) => points.reduce((a, p) => Math.min(a, p[k]), Infinity));
  const high = [0, 1, 2].map((k) => points.reduce((a, p) => Math.max(a, p[k]), -Infinity));
  const first = of.position[0], end = of.position[of.position.length - 1];
  const extent = Math.max(...[0, 1, 2].map((k) => high[k] - low[k]), 0.5);
  // The ground is drawn where the flight is near it; a grid at the lowest point otherwise.
  const ground = low[2] >= -0.05 && low[2] < 1.2 * extent ? 0 : low[2] - 0.1 * extent;
  low[2] = Math.min(low[2], ground);
  return {
    middle: add(low, high).map((v) => v / 2),
    extent: Math.max(Math.hypot(high[0] - low[0], high[1] - low[1]), high[2] - low[2], 0.5),
    heading: Math.atan2(end[1] - first[1], end[0] - first[0]),
    low, high, ground,
    // Without markers the size of the body is not known.
    radius: data.radius || extent / 22,
    larger: data.radius ? Math.max(1, extent / 22 / data.radius) : 1,
  };
}

/// Camera: the axes of the picture (right, up, towards the eye).
function camera() {
  const h = scene.heading;
  const along = [Math.cos(h), Math.sin(h), 0], left = [-Math.sin(h), Math.cos(h), 0], up = [0, 0, 1];
  if (view === "side") return { right: along, up, eye: left.map((v) => -v), flat: true };
  if (view === "top") return { right: along, up: left, eye: up, flat: true };
  const a = turn[0] - 0.9, e = turn[1];
  const away = add(add([0, 0, 0], along, Math.cos(e) * Math.sin(a)), left, -Math.cos(e) * Math.cos(a));
  const eye = add(away, up, Math.sin(e));
  const right = unit(cross(up, eye));
  return { right, up: cross(eye, right), eye, flat: false };
}

function projection() {
  const c = camera(), wide = canvas.clientWidth, tall = canvas.clientHeight;
  const corners = [];
  for (const x of [scene.low[0], scene.high[0]]) for (const y of [scene.low[1], scene.high[1]]) for (const z of [scene.low[2], scene.high[2]]) corners.push([x, y, z]);
  const far = 2.6 * scene.extent;
  const flat = (p) => {
    const d = add(p, scene.middle, -1);
    const k = c.flat ? 1 : far / Math.max(far - dot(d, c.eye), 0.05 * far);
    return [dot(d, c.right) * k, dot(d, c.up) * k, dot(d, c.eye)];
  };
  const at = corners.map(flat);
  const ends = [0, 1].map((k) => [Math.min(...at.map((p) => p[k])), Math.max(...at.map((p) => p[k]))]);
  const room = 2.6 * scene.radius * scene.larger;
  const size = Math.min(wide / (ends[0][1] - ends[0][0] + room), tall / (ends[1][1] - ends[1][0] + room)) * 0.92 * zoom;
  const centre = ends.map((e) => (e[0] + e[1]) / 2);
  const to = (p) => { const q = flat(p); return [wide / 2 + size * (q[0] - centre[0]), tall / 2 - size * (q[1] - centre[1]), q[2]]; };
  return { to, eye: c.eye, size };
}

function path(points, to, close) {
  pen.beginPath();
  let begun = false;
  for (const p of points) {
    if (!p) { begun = false; continue; }
    const [x, y] = to(p);
    if (begun) pen.lineTo(x, y); else pen.moveTo(x, y);
    begun = true;
  }
  if (close) pen.closePath();
}

function stroke(points, to, colour, width, alpha = 1) {
  pen.globalAlpha = alpha; pen.strokeStyle = colour; pen.lineWidth = width;
  path(points, to); pen.stroke(); pen.globalAlpha = 1;
}

function spot(p, to, colour, radius, alpha = 1) {
  const [x, y] = to(p);
  pen.globalAlpha = alpha; pen.fillStyle = colour;
  pen.beginPath(); pen.arc(x, y, radius, 0, 7); pen.fill(); pen.globalAlpha = 1;
}

function label(text, p, to, colour) {
  const [x, y] = to(p);
  pen.fillStyle = colour; pen.font = "13px system-ui, sans-serif"; pen.fillText(text, x + 5, y - 5);
}

function arrow(from, by, to, colour, name) {
  const end = add(from, by), [x0, y0] = to(from), [x1, y1] = to(end);
  stroke([from, end], to, colour, 2.4);
  const a = Math.atan2(y1 - y0, x1 - x0);
  pen.fillStyle = colour; pen.beginPath(); pen.moveTo(x1, y1);
  for (const s of [-1, 1]) pen.lineTo(x1 - 9 * Math.cos(a + s * 0.42), y1 - 9 * Math.sin(a + s * 0.42));
  pen.fill(); label(name, end, to, colour);
}

function grid(to) {
  const rough = scene.extent / 8, power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((m) => m * power).find((s) => s >= rough);
  const from = [0, 1].map((k) => Math.floor(scene.low[k] / step - 1) * step), till = [0, 1].map((k) => Math.ceil(scene.high[k] / step + 1) * step);
  for (let x = from[0]; x <= till[0] + step / 2; x += step) stroke([[x, from[1], scene.ground], [x, till[1], scene.ground]], to, colours.grid, 1);
  for (let y = from[1]; y <= till[1] + step / 2; y += step) stroke([[from[0], y, scene.ground], [till[0], y, scene.ground]], to, colours.grid, 1);
  const z = scene.ground === 0 ? "ground, z = 0" : "grid at z = " + scene.ground.toFixed(2) + " m";
  byId("legend").dataset.ground = z + "; squares of " + (+step.toPrecision(3)) + " m";
  if (view === "free") {
    const at = [from[0], from[1], scene.ground];
    arrow(at, [step, 0, 0], to, colours.soft, "x"); arrow(at, [0, step, 0], to, colours.soft, "y"); arrow(at, [0, 0, step], to, colours.soft, "z");
  }
}

/// Index of the last sample at or before the time, and the part of the way to the next one.
function place(t) {
  const times = flight.times;
  let low = 0, high = times.length - 1;
  while (high - low > 1) { const middle = (low + high) >> 1; if (times[middle] <= t) low = middle; else high = middle; }
  if (high <= low) return [0, 0];
  return [low, Math.min(1, Math.max(0, (t - times[low]) / (times[high] - times[low])))];
}

const nearest = (t) => { const [i, part] = place(t); return Math.min(flight.times.length - 1, part > 0.5 ? i + 1 : i); };

/// A disc of unit vectors about an axis.
function circle(centre, axis, radius) {
  const one = unit(cross(axis, Math.abs(axis[0]) < 0.8 ? [1, 0, 0] : [0, 1, 0])), two = cross(axis, one);
  return Array.from({ length: 41 }, (_, k) => add(add(centre, one, radius * Math.cos(k * Math.PI / 20)), two, radius * Math.sin(k * Math.PI / 20)));
}

function body(i, to, eye) {
  const radius = scene.radius * scene.larger, centre = flight.position[i], turned = flight.attitude && flight.attitude[i];
  const grown = (p) => add(centre, add(p, centre, -1), scene.larger);
  spot([centre[0], centre[1], scene.ground], to, colours.soft, 3.5, 0.5);
  stroke([centre, [centre[0], centre[1], scene.ground]], to, colours.soft, 1, 0.4);
  const seen = flight.measured[i] || [], expected = flight.predicted[i] || [];
  if (!turned) {
    const [x, y] = to(centre), [x1] = to(add(centre, cross(eye, unit(cross(Math.abs(eye[2]) < 0.9 ? [0, 0, 1] : [1, 0, 0], eye))), radius));
    pen.fillStyle = colours.model; pen.globalAlpha = 0.75; pen.beginPath(); pen.arc(x, y, Math.max(5, Math.abs(x1 - x)), 0, 7); pen.fill(); pen.globalAlpha = 1;
  } else {
    const axes = [0, 1, 2].map((k) => column(turned, k));
    if (data.shape === "disc") {
      path(circle(centre, axes[2], radius), to, true);
      pen.fillStyle = colours.model; pen.globalAlpha = dot(axes[2], eye) > 0 ? 0.55 : 0.3; pen.fill(); pen.globalAlpha = 1;
      pen.strokeStyle = colours.model; pen.lineWidth = 1.8; pen.stroke();
    }
    ["1", "2", "3"].forEach((name, k) => {
      const length = (k === 2 ? 0.9 : 1.35) * radius;
      stroke([centre, add(centre, axes[k], length)], to, colours.model, k === 2 ? 2.6 : 1.6);
      label(name, add(centre, axes[k], length), to, colours.model);
    });
    const both = seen.map((p, m) => [p, expected[m]]).filter((b) => b[0] && b[1]);
    if (data.shape === "disc" && both.length >= 3) {
      const normal = (k) => unit(cross(add(both[1][k], both[0][k], -1), add(both[2][k], both[0][k], -1)));
      const [from, into] = [normal(1), normal(0)];
      // The rotation that takes the predicted plane of the markers to the measured one, applied to the axis.
      const about = cross(from, into), c = dot(from, into), a = axes[2];
      const axis = c > -0.99 ? add(add(a.map((v) => v * c), cross(about, a)), about, dot(about, a) / (1 + c)) : a;
      const shift = both.reduce((s, b) => add(s, add(b[0], b[1], -1), scene.larger / both.length), [0, 0, 0]);
      path(circle(add(centre, shift), axis, radius), to, true);
      pen.strokeStyle = colours.measured; pen.lineWidth = 1.8; pen.stroke();
    }
  }
  expected.forEach((p) => { if (p) spot(grown(p), to, colours.model, 3.4); });
  seen.forEach((p) => { if (p) spot(grown(p), to, colours.measured, 3); });
}

function draw() {
  const ratio = window.devicePixelRatio || 1, wide = canvas.clientWidth, tall = canvas.clientHeight;
  if (canvas.width !== Math.round(wide * ratio) || canvas.height !== Math.round(tall * ratio)) { canvas.width = Math.round(wide * ratio); canvas.height = Math.round(tall * ratio); }
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  pen.clearRect(0, 0, wide, tall);
  const { to, eye } = projection(), [i] = place(time), now = nearest(time);
  if (view !== "side") grid(to);
  else stroke([[-1, 0], [1, 0]].map(([s]) => add([scene.middle[0], scene.middle[1], scene.ground], camera().right, s * scene.extent)), to, colours.soft, 1.4);
  stroke(flight.position.map((p) => [p[0], p[1], scene.ground]), to, colours.soft, 1, 0.35);
  stroke(flight.position, to, colours.model, 1.4, 0.3);
  stroke(flight.position.slice(0, i + 1).concat([flight.position[now]]), to, colours.model, 2.4);
  flight.trail.forEach((p, k) => { if (p && flight.trail_times[k] <= time) spot(p, to, colours.measured, 1.7, 0.75); });
  flight.arrows.forEach((a) => {
    const size = Math.hypot(...a.value);
    const at = [scene.low[0], scene.high[1], scene.high[2]];
    if (size > 0) arrow(at, unit(a.value).map((v) => v * scene.extent / 8), to, colours.wind, a.name + " " + size.toFixed(1) + " " + a.unit);
  });
  body(now, to, eye);
  byId("time").textContent = time.toFixed(3) + " s";
  byId("scrub").value = String(Math.round(1000 * (time - flight.times[0]) / (end() - flight.times[0] || 1)));
  flight.numbers.forEach((n, k) => { byId("n" + k).textContent = format(n.values[now]) + (n.unit ? " " + n.unit : ""); });
  byId("ground").textContent = byId("legend").dataset.ground || "";
}

const format = (v) => v === null || v === undefined ? "–" : (Math.abs(v) >= 1e5 || (v !== 0 && Math.abs(v) < 1e-3) ? v.toExponential(2) : String(+v.toPrecision(4))).replace("-", "−");
const end = () => flight.times[flight.times.length - 1];
const element = (name, text, kind) => { const e = document.createElement(name); e.textContent = text; if (kind) e.className = kind; return e; };

function choose(k) {
  flight = data.flights[k]; scene = measure(flight); time = flight.times[0]; zoom = 1; play(false);
  const legend = byId("legend");
  const seen = flight.measured.some((row) => row.some(Boolean));
  legend.replaceChildren(element("b", seen ? "predicted" : "simulated", "model"));
  if (seen) legend.append(" · ", element("b", "measured", "measured"));
  if (flight.note) legend.append(" · " + flight.note);
  if (scene.larger > 1.05) legend.append(" · body and markers drawn " + scene.larger.toPrecision(2) + " times as large");
  if (!data.radius) legend.append(" · body not to scale");
  legend.append(" · ");
  const ground = element("span", ""); ground.id = "ground"; legend.append(ground);
  byId("numbers").replaceChildren(...flight.numbers.map((n, i) => { const row = document.createElement("div"), value = element("dd", ""); value.id = "n" + i; row.append(element("dt", n.name), value); return row; }));
  draw();
}

function play(on) {
  playing = on;
  if (on && time >= end()) time = flight.times[0];
  byId("play").textContent = on ? "Pause" : "Play";
  byId("play").setAttribute("aria-pressed", String(on));
  if (on) { last = performance.now(); requestAnimationFrame(step); }
}

function step(now) {
  if (!playing) return;
  time = Math.min(end(), time + Math.max(0, now - last) / 1000 * +byId("speed").value);
  last = now;
  draw();
  if (time >= end()) play(false); else requestAnimationFrame(step);
}

function look(at) {
  view = at;
  document.querySelectorAll("[data-view]").forEach((b) => b.setAttribute("aria-pressed", String(b.dataset.view === at)));
  draw();
}

function read() {
  const style = getComputedStyle(document.documentElement);
  for (const name of ["grid", "soft", "model", "measured", "wind"]) colours[name] = style.getPropertyValue("--" + name).trim();
}

function nudge(by) { play(false); const i = nearest(time); time = flight.times[Math.min(flight.times.length - 1, Math.max(0, i + by))]; draw(); }
function closer(by) { zoom = Math.min(20, Math.max(0.3, zoom * by)); draw(); }

data.flights.forEach((f, k) => { const o = element("option", f.name); o.value = String(k); byId("flight").append(o); });
byId("choose").hidden = data.flights.length < 2;
byId("flight").addEventListener("change", (e) => choose(+e.target.value));
byId("play").addEventListener("click", () => play(!playing));
byId("scrub").addEventListener("input", (e) => { play(false); time = flight.times[0] + (end() - flight.times[0]) * e.target.value / 1000; draw(); });
document.querySelectorAll("[data-view]").forEach((b) => b.addEventListener("click", () => look(b.dataset.view)));
document.addEventListener("keydown", (e) => {
  if (["SELECT", "BUTTON", "INPUT"].includes(e.target.tagName) || e.ctrlKey || e.metaKey || e.altKey) return;
  const turns = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1] };
  if (e.key === " ") play(!playing);
  else if (e.shiftKey && turns[e.key]) { look("free"); turned(turns[e.key]); }
  else if (e.key === "ArrowLeft") nudge(-1);
  else if (e.key === "ArrowRight") nudge(1);
  else if (e.key === "1" || e.key === "2" || e.key === "3") look(["free", "side", "top"][+e.key - 1]);
  else if (e.key === "+" || e.key === "=") closer(1.2);
  else if (e.key === "-") closer(1 / 1.2);
  else return;
  e.preventDefault();
});
function turned([a, e]) { turn = [turn[0] + a, Math.min(1.55, Math.max(-0.2, turn[1] + e))]; draw(); }
let held = null;
canvas.addEventListener("pointerdown", (e) => { held = [e.clientX, e.clientY]; canvas.setPointerCapture(e.pointerId); });
canvas.addEventListener("pointermove", (e) => {
  if (!held) return;
  if (view === "free") turned([-(e.clientX - held[0]) / 160, (e.clientY - held[1]) / 160]);
  held = [e.clientX, e.clientY];
});
for (const name of ["pointerup", "pointercancel"]) canvas.addEventListener(name, () => { held = null; });
canvas.addEventListener("wheel", (e) => { e.preventDefault(); closer(Math.exp(-e.deltaY / 500)); }, { passive: false });
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => { read(); draw(); });
new ResizeObserver(() => flight && draw()).observe(canvas);
read();
// The address may end in #NAME of a flight, or #NAME@SECONDS.
const [named, at] = decodeURIComponent(location.hash.slice(1)).split("@");
const wanted = Math.max(0, data.flights.findIndex((f) => f.name === named));
choose(wanted);
byId("flight").value = String(wanted);
if (at && isFinite(+at)) { time = Math.min(end(), Math.max(flight.times[0], +at)); draw(); }
