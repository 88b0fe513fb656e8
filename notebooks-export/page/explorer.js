// SPDX-License-Identifier: GPL-3.0-or-later
"use strict";
// The closed forms, evaluated in binary64 for the letters that the sliders set. `motion` is written by shortfall.
(() => {
  const explorer = document.getElementById("explorer");
  const SVG = "http://www.w3.org/2000/svg";
  const WIDTH = 680, HEIGHT = 300, LEFT = 62, RIGHT = 150, TOP = 14, BOTTOM = 44;

  const value = (name) => Number(document.getElementById(`letter-${name}`).value);
  const letters = () => {
    const all = {};
    for (const letter of motion.letters) all[letter.name] = value(letter.name);
    all.h = 1 / value("rate");
    return all;
  };
  const number = (x, digits) => (x === 0 ? "0" : Number(x.toPrecision(digits)).toString().replace("-", "\u2212"));

  function frames(at, corrected) {
    const last = Math.floor(value("duration") / at.h + 1e-9);
    const started = corrected ? motion.launched(at) : at;
    const points = [];
    for (let n = motion.first; n <= last; ++n) {
      const t = n * at.h;
      const x = motion.position(started, t, n) + (corrected ? motion.readout(at, t, n, motion.velocity(started, t, n)) : 0);
      points.push({ t, x, short: motion.exact(at, t) - x });
    }
    return points;
  }

  const element = (name, attributes, text) => {
    const e = document.createElementNS(SVG, name);
    for (const [key, v] of Object.entries(attributes)) e.setAttribute(key, v);
    if (text !== undefined) e.textContent = text;
    return e;
  };

  function ticks(low, high) {
    const raw = (high - low) / 5, power = 10 ** Math.floor(Math.log10(raw));
    const step = [1, 2, 5, 10].map((m) => m * power).find((s) => s >= raw);
    const list = [];
    for (let k = Math.ceil(low / step); k * step <= high * (1 + 1e-12) + 1e-300; ++k) list.push(k * step);
    return list;
  }

  function chart(svg, what, curves) {
    svg.replaceChildren();
    svg.setAttribute("viewBox", `0 0 ${WIDTH} ${HEIGHT}`);
    const all = curves.flatMap((c) => c.points);
    const duration = value("duration");
    let low = Math.min(0, ...all.map((p) => p.y)), high = Math.max(0, ...all.map((p) => p.y));
    if (!(high - low > 1e-12)) high = low + 1;
    const room = (high - low) * 0.05;
    low -= room; high += room;
    const px = (t) => LEFT + (t / duration) * (WIDTH - LEFT - RIGHT);
    const py = (y) => TOP + ((high - y) / (high - low)) * (HEIGHT - TOP - BOTTOM);
    const text = { fill: "var(--soft)", "font-size": 13, class: "tick" };
    for (const y of ticks(low, high)) {
      svg.append(element("line", { x1: LEFT, x2: WIDTH - RIGHT, y1: py(y), y2: py(y), stroke: "var(--line)" }));
      svg.append(element("text", { ...text, x: LEFT - 8, y: py(y) + 4, "text-anchor": "end" }, number(y, 3)));
    }
    for (const t of ticks(0, duration))
      svg.append(element("text", { ...text, x: px(t), y: HEIGHT - BOTTOM + 18, "text-anchor": "middle" }, number(t, 3)));
    svg.append(element("text", { ...text, x: (LEFT + WIDTH - RIGHT) / 2, y: HEIGHT - 6, "text-anchor": "middle" }, "time (s)"));
    svg.append(element("text", { ...text, x: 14, y: (TOP + HEIGHT - BOTTOM) / 2, "text-anchor": "middle",
      transform: `rotate(-90 14 ${(TOP + HEIGHT - BOTTOM) / 2})` }, what));
    let labels = [];
    for (const c of curves) {
      const path = c.points.map((p, i) => `${i ? "L" : "M"}${px(p.t).toFixed(2)} ${py(p.y).toFixed(2)}`).join("");
      svg.append(element("path", { d: path, fill: "none", stroke: c.ink, "stroke-width": c.dots ? 1 : 2, "stroke-dasharray": c.dash || "none" }));
      if (c.dots && c.points.length < 200)
        for (const p of c.points)
          svg.append(element("circle", { cx: px(p.t), cy: py(p.y), r: 2.6, fill: c.ink }));
      const end = c.points[c.points.length - 1];
      labels.push({ y: py(end.y), text: c.name, ink: c.ink });
    }
    // Labels at the curves' ends, moved apart where they would touch.
    labels = labels.sort((a, b) => a.y - b.y);
    for (let i = 1; i < labels.length; ++i) labels[i].y = Math.max(labels[i].y, labels[i - 1].y + 17);
    const over = labels.length ? Math.max(0, labels[labels.length - 1].y - (HEIGHT - BOTTOM)) : 0;
    for (const l of labels)
      svg.append(element("text", { x: WIDTH - RIGHT + 10, y: l.y - over + 4, fill: l.ink, "font-size": 13, class: "tick" }, l.text));
  }

  function draw() {
    const at = letters();
    const show = motion.correctable && document.getElementById("corrected").checked;
    const plain = frames(at, false), fixed = show ? frames(at, true) : [];
    const smooth = [];
    for (let i = 0; i <= 200; ++i) {
      const t = (value("duration") * i) / 200;
      smooth.push({ t, y: motion.exact(at, t) });
    }
    const of = (points, key, scale) => points.map((p) => ({ t: p.t, y: p[key] * scale }));
    const arcs = [{ name: "true motion", points: smooth, ink: "var(--true)" },
      { name: "the integrator", points: of(plain, "x", 1), ink: "var(--plain)", dots: true }];
    const errors = [{ name: "as it comes", points: of(plain, "short", 100), ink: "var(--plain)", dots: true }];
    if (show) {
      arcs.push({ name: "corrected", points: of(fixed, "x", 1), ink: "var(--fixed)", dots: true, dash: "4 3" });
      errors.push({ name: "corrected", points: of(fixed, "short", 100), ink: "var(--fixed)", dots: true, dash: "4 3" });
    }
    chart(document.getElementById("arcs"), "x (m)", arcs);
    chart(document.getElementById("errors"), "shortfall of x (cm)", errors);
    const worst = (points) => points.reduce((w, p) => (Math.abs(p.short) > Math.abs(w.short) ? p : w));
    const w = worst(plain), way = w.short > 0 ? "too low" : "too high";
    let said = Math.abs(w.short) < 1e-12 ? "The integrator is where it should be at every frame." :
      `At ${number(at.h > 0 ? 1 / at.h : 0, 4)} frames a second the integrator is at worst ${number(Math.abs(w.short) * 100, 4)} cm ${way}, after ${number(w.t, 3)} s.`;
    if (show) {
      const c = worst(fixed);
      said += Math.abs(c.short) < 1e-9 ? " Corrected, it is exact at every frame (up to the rounding of this page)." :
        ` Corrected, at worst ${number(Math.abs(c.short) * 100, 3)} cm.`;
    }
    document.getElementById("said").textContent = said;
    for (const input of explorer.querySelectorAll("input[type=range]"))
      document.getElementById(`${input.id}-value`).textContent = number(Number(input.value), 4);
  }

  explorer.hidden = false;
  explorer.addEventListener("input", draw);
  draw();
})();
