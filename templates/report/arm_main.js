
// The page: sliders, drawing and motion are brought together, one frame of the screen at a time.

const root = document.getElementById("live");
const arms = JSON.parse(document.getElementById("arms").textContent)
    .map((data, k) => new Arm(data, globalThis.robodynKernels[k]));
const canvas = root.querySelector("canvas");
const scene = new Scene(canvas);
const panel = new Panel(root, arms);
const play = root.querySelector("[data-play]");
const clock = root.querySelector("input[data-time]");
const cursors = [...document.querySelectorAll(".motion svg.chart")].map((chart) => {
    const line = document.createElementNS("http://www.w3.org/2000/svg", "line");
    line.setAttribute("class", "now");
    line.setAttribute("y2", "100%");
    line.style.display = "none";
    chart.append(line);
    return line;
});
const motion = { period: arms[0].data.motion.period, time: 0, playing: false, last: null };
const shares = { frames: 0, busy: 0 };
let waiting = false;
let due = { state: true, step: null };

function wanted(state) {
    due.state ||= state;
    if (waiting) return;
    waiting = true;
    requestAnimationFrame(frame);
}

function frame(now) {
    const begin = performance.now();
    waiting = false;
    if (motion.playing) {
        const step = motion.last === null ? 0 : Math.min((now - motion.last) / 1000, 0.1);
        motion.last = now;
        at((motion.time + step) % motion.period, step);
    }
    if (due.state) {
        const state = panel.state ?? panel.read();
        arms.forEach((arm) => arm.move(...state, due.step));
        panel.show(state[0]);
    }
    due = { state: false, step: null };
    scene.draw(arms);
    shares.frames += 1;
    shares.busy += performance.now() - begin;
    if (motion.playing) wanted(false);
}

// The moment t of the motion; of two arms that of the first.
function at(t, step) {
    motion.time = t;
    const longest = panel.most.n;
    const state = arms[0].motion(t).map((x) => [...x, ...new Array(Math.max(0, longest - x.length)).fill(0)]);
    panel.write(...state);
    panel.state = state;
    clock.value = t;
    clock.setAttribute("aria-valuetext", `${figure(t, 3)} seconds`);
    set(root.querySelector("[data-clock]"), `${t.toFixed(1)} s`);
    for (const line of cursors) {
        line.style.display = "";
        const x = `${((100 * t) / motion.period).toFixed(2)}%`;
        line.setAttribute("x1", x);
        line.setAttribute("x2", x);
    }
    due.step = step || null;
    wanted(true);
}

function running(on) {
    motion.playing = on;
    motion.last = null;
    play.setAttribute("aria-pressed", String(on));
    set(play.querySelector("span"), on ? "Pause" : "Play");
    wanted(false);
}

for (const input of root.querySelectorAll("input[data-q], input[data-qd], input[data-qdd]")) {
    input.addEventListener("input", () => {
        if (motion.playing) running(false);
        panel.state = null;
        wanted(true);
    });
}
panel.sliders.forEach((slider, j) => {
    const select = (index) => () => {
        scene.selected = index;
        wanted(false);
    };
    slider.addEventListener("focus", select(j));
    slider.addEventListener("pointerenter", select(j));
    slider.addEventListener("blur", select(-1));
    slider.addEventListener("pointerleave", select(-1));
});
play.addEventListener("click", () => running(!motion.playing));
clock.addEventListener("input", () => {
    running(false);
    at(Number(clock.value), 0);
});
root.querySelector("[data-home]").addEventListener("click", () => {
    running(false);
    const home = panel.sliders.map((_, j) => panel.most.data.home.position[j]);
    panel.write(home, home.map(() => 0), home.map(() => 0));
    panel.state = null;
    wanted(true);
});
for (const box of root.querySelectorAll("input[data-shows]")) {
    scene.shows[box.dataset.shows] = box.checked; // as a browser restores it
    box.addEventListener("change", () => {
        scene.shows[box.dataset.shows] = box.checked;
        wanted(false);
    });
}
for (const fold of root.querySelectorAll("details")) fold.addEventListener("toggle", () => wanted(true));

// --- the view ---

function turn(yaw, pitch) {
    scene.view.yaw += yaw;
    scene.view.pitch = Math.min(1.5707, Math.max(-1.5707, scene.view.pitch + pitch));
    wanted(false);
}

function zoom(factor) {
    scene.view.zoom = Math.min(8, Math.max(0.3, scene.view.zoom * factor));
    wanted(false);
}

const views = {
    reset: () => Object.assign(scene.view, scene.start),
    front: () => Object.assign(scene.view, { yaw: 0, pitch: 0 }),
    side: () => Object.assign(scene.view, { yaw: -Math.PI / 2, pitch: 0 }),
    top: () => Object.assign(scene.view, { yaw: -Math.PI / 2, pitch: 1.5707 }),
    nearer: () => zoom(1.2),
    farther: () => zoom(1 / 1.2),
};
for (const button of root.querySelectorAll("button[data-view]")) {
    button.addEventListener("click", () => {
        views[button.dataset.view]();
        wanted(false);
    });
}
let grip = null;
canvas.addEventListener("pointerdown", (event) => {
    grip = [event.clientX, event.clientY];
    canvas.setPointerCapture(event.pointerId);
});
canvas.addEventListener("pointermove", (event) => {
    if (!grip) return;
    const slide = event.pointerType === "touch" ? 0 : 0.008; // a finger that goes up or down scrolls the page
    turn(-0.008 * (event.clientX - grip[0]), slide * (event.clientY - grip[1]));
    grip = [event.clientX, event.clientY];
});
for (const name of ["pointerup", "pointercancel", "lostpointercapture"]) {
    canvas.addEventListener(name, () => (grip = null));
}
canvas.addEventListener("wheel", (event) => {
    if (!event.ctrlKey) return; // plain wheels scroll the page
    event.preventDefault();
    zoom(Math.exp(-0.01 * event.deltaY));
}, { passive: false });
canvas.addEventListener("keydown", (event) => {
    const keys = {
        ArrowLeft: () => turn(-0.09, 0), ArrowRight: () => turn(0.09, 0), ArrowUp: () => turn(0, 0.09),
        ArrowDown: () => turn(0, -0.09), "+": views.nearer, "=": views.nearer, "-": views.farther, 0: views.reset,
    };
    if (!(event.key in keys) || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    keys[event.key]();
    wanted(false);
});

// --- the window ---

function fitted() {
    const points = [];
    for (const arm of arms) {
        for (let k = 0; k < 24; ++k) {
            arm.locate(k ? arm.motion((k * motion.period) / 24)[0] : arm.data.home.position);
            points.push(arm.pose.base, ...arm.pose.origins, arm.pose.tool);
            points.push(...arm.data.links.map((link, i) => centreOf(link, arm.pose.origins[i], arm.pose.axes[i])));
        }
    }
    scene.fit(points, Math.min(...arms.map((arm) => (arm.data.base ? arm.data.base.xyz[2] : 0))));
}

function repainted() {
    scene.paint();
    scene.resize();
    scene.draw(arms);
}

fitted();
new ResizeObserver(() => {
    scene.resize();
    wanted(false);
}).observe(canvas);
for (const query of ["(prefers-color-scheme: dark)", "print"]) {
    matchMedia(query).addEventListener("change", repainted);
}
scene.resize();
panel.write(arms[0].data.home.position.concat(panel.most.data.home.position.slice(arms[0].n)), ...panel.rates.map((inputs) => inputs.map(() => 0)));
frame(performance.now());
globalThis.robodyn = { arms, scene, panel, motion, shares, turn, at, running };
