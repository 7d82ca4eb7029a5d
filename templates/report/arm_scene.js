// The drawing: an arm in orthographic projection on a canvas, far things first.

const FRAME_COLOURS = ["#d5433f", "#3f9a4b", "#3b78d8"];

class Scene {
    constructor(canvas) {
        this.canvas = canvas;
        this.context = canvas.getContext("2d");
        this.start = { yaw: -0.9, pitch: 0.42, zoom: 1 };
        this.view = { ...this.start };
        this.centre = [0, 0, 0];
        this.radius = 1;
        this.floor = 0;
        this.shows = { frames: false, inertia: false, velocity: false };
        this.selected = -1;
        this.many = 1;
        this.middle = 0;
        this.paint();
    }

    // Reads the colours of the page's scheme.
    paint() {
        const style = getComputedStyle(document.documentElement);
        const of = (name) => style.getPropertyValue(name).trim();
        this.colours = {
            ink: of("--ink"), soft: of("--soft"), rule: of("--rule"), card: of("--card"),
            arms: [of("--after"), of("--before")], body: of("--body"), edge: of("--edge"), cap: of("--cap"),
        };
    }

    // Centre and radius of a ball about all points, and how low the lowest is.
    fit(points, floor) {
        const low = [0, 1, 2].map((k) => Math.min(...points.map((p) => p[k])));
        const high = [0, 1, 2].map((k) => Math.max(...points.map((p) => p[k])));
        this.centre = low.map((x, k) => (x + high[k]) / 2);
        this.radius = Math.max(1e-6, ...points.map((p) => Math.hypot(...p.map((x, k) => x - this.centre[k]))));
        this.floor = floor;
    }

    resize() {
        const box = this.canvas.getBoundingClientRect();
        const ratio = Math.min(globalThis.devicePixelRatio || 1, 2);
        this.width = box.width;
        this.height = box.height;
        const [wide, high] = [Math.round(box.width * ratio), Math.round(box.height * ratio)];
        if (this.canvas.width !== wide || this.canvas.height !== high) {
            this.canvas.width = wide;
            this.canvas.height = high;
        }
        this.context.setTransform(ratio, 0, 0, ratio, 0, 0);
    }

    // The camera's axes: to the right, up, and towards the viewer.
    look() {
        const { yaw, pitch, zoom } = this.view;
        const [cy, sy, cp, sp] = [Math.cos(yaw), Math.sin(yaw), Math.cos(pitch), Math.sin(pitch)];
        this.right = [-sy, cy, 0];
        this.up = [-sp * cy, -sp * sy, cp];
        this.toward = [cp * cy, cp * sy, sp];
        this.scale = (zoom * Math.min(this.width / this.many, this.height)) / 2.05 / this.radius;
    }

    place(p) {
        const d = [p[0] - this.centre[0], p[1] - this.centre[1], p[2] - this.centre[2]];
        return [
            this.middle + this.scale * dot(d, this.right),
            this.height / 2 - this.scale * dot(d, this.up),
            dot(d, this.toward),
        ];
    }

    draw(arms) {
        if (!this.width) return;
        this.many = arms.length;
        this.look();
        this.context.clearRect(0, 0, this.width, this.height);
        arms.forEach((arm, k) => {
            this.middle = (this.width * (2 * k + 1)) / (2 * this.many);
            this.grid();
            const parts = [];
            this.arm(arm, k, parts);
            parts.sort((a, b) => a.depth - b.depth);
            for (const part of parts) part.draw();
        });
        this.triad();
    }

    // The floor: lines a round number apart, within a circle.
    grid() {
        const step = 10 ** Math.floor(Math.log10(this.radius));
        const pitch = this.radius / step > 4 ? step : this.radius / step > 2 ? step / 2 : step / 4;
        const reach = Math.ceil(((this.many > 1 ? 0.8 : 1.1) * this.radius) / pitch);
        const [x, y] = [0, 1].map((k) => pitch * Math.round(this.centre[k] / pitch));
        const line = this.context;
        line.strokeStyle = this.colours.rule;
        line.lineWidth = 1;
        line.beginPath();
        for (let i = -reach; i <= reach; ++i) {
            const half = pitch * Math.sqrt(Math.max(0, (reach + 0.5) ** 2 - i * i));
            this.segment([x + i * pitch, y - half, this.floor], [x + i * pitch, y + half, this.floor]);
            this.segment([x - half, y + i * pitch, this.floor], [x + half, y + i * pitch, this.floor]);
        }
        line.stroke();
    }

    segment(a, b) {
        const [p, q] = [this.place(a), this.place(b)];
        this.context.moveTo(p[0], p[1]);
        this.context.lineTo(q[0], q[1]);
    }

    arm(arm, which, parts) {
        const { origins, axes, tool, toolAxes, base } = arm.pose;
        const thick = 0.032 * this.radius;
        const n = origins.length;
        const size = (i) => thick * (1 - (0.5 * i) / Math.max(n, 2));
        const colour = this.colours.body;
        this.tube([base, origins[0]], size(0), colour, parts);
        for (let i = 0; i < n; ++i) {
            const next = i + 1 < n ? origins[i + 1] : tool;
            const a = i + 1 < n ? arm.data.joints[i + 1].row.a : 0;
            const corner = add(origins[i], axes[i][0], a);
            this.tube([origins[i], corner, next], size(i + 1), colour, parts);
            this.joint(arm.data.joints[i], origins[i], axes[i], size(i), i, which, parts);
            if (this.shows.frames) this.frame(origins[i], axes[i], 4.2 * size(i), parts);
            if (this.shows.inertia) this.inertia(arm.data.links[i], origins[i], axes[i], parts);
        }
        const last = arm.data.links[n - 1];
        if (Math.hypot(...sub(tool, origins[n - 1])) < 1e-3 * this.radius) { // a pendulum's link ends nowhere
            this.tube([origins[n - 1], centreOf(last, origins[n - 1], axes[n - 1])], size(n), colour, parts);
        }
        this.gripper(tool, toolAxes, size(n), parts);
        if (this.shows.frames) this.frame(tool, toolAxes, 4.2 * size(n), parts);
        if (this.shows.velocity) this.velocity(arm, tool, which, parts);
    }

    // A line of even thickness through points, with an edge.
    tube(points, radius, colour, parts) {
        for (let k = 0; k + 1 < points.length; ++k) {
            const [p, q] = [this.place(points[k]), this.place(points[k + 1])];
            if (Math.hypot(p[0] - q[0], p[1] - q[1]) < 0.3) continue;
            parts.push({
                depth: (p[2] + q[2]) / 2,
                draw: () => {
                    for (const [width, stroke] of [
                        [2 * radius * this.scale, this.colours.edge], [2 * radius * this.scale - 2.4, colour],
                    ]) this.stroke([p, q], Math.max(width, 1), stroke);
                },
            });
        }
    }

    stroke(points, width, colour, dashes = []) {
        const line = this.context;
        line.lineCap = "round";
        line.lineWidth = width;
        line.strokeStyle = colour;
        line.setLineDash(dashes);
        line.beginPath();
        points.forEach((p, k) => (k ? line.lineTo(p[0], p[1]) : line.moveTo(p[0], p[1])));
        line.stroke();
        line.setLineDash([]);
    }

    // A drum about the axis of a revolute joint, a box along that of a prismatic one.
    joint(joint, origin, axes, thick, index, which, parts) {
        const sides = joint.kind === "revolute" ? 24 : 4;
        const [radius, half] = joint.kind === "revolute" ? [1.55 * thick, 1.7 * thick] : [1.5 * thick, 2.6 * thick];
        const turned = sides === 4 ? Math.PI / 4 : 0;
        const ends = [1, -1].map((way) => Array.from({ length: sides }, (_, k) => {
            const angle = turned + (2 * Math.PI * k) / sides;
            const rim = add(add(origin, axes[0], radius * Math.cos(angle)), axes[1], radius * Math.sin(angle));
            return this.place(add(rim, axes[2], way * half));
        }));
        const near = ends[dot(axes[2], this.toward) >= 0 ? 0 : 1];
        const shown = index === this.selected;
        const accent = this.colours.arms[which];
        parts.push({
            depth: dot(sub(origin, this.centre), this.toward) + 0.5 * thick,
            draw: () => {
                this.shape(hull([...ends[0], ...ends[1]]), shown ? accent : this.colours.body, this.colours.edge);
                this.shape(near, shown ? accent : this.colours.cap, this.colours.edge);
                const middle = near.reduce((sum, p) => [sum[0] + p[0] / sides, sum[1] + p[1] / sides], [0, 0]);
                this.dot(middle, 2, shown ? this.colours.card : accent);
            },
        });
        if (shown || this.shows.frames) {
            const [a, b] = [-1, 1].map((way) => this.place(add(origin, axes[2], 3.6 * way * thick)));
            parts.push({ depth: Infinity, draw: () => this.stroke([a, b], 1.2, accent, [6, 3, 1.5, 3]) });
        }
    }

    shape(points, fill, edge) {
        const line = this.context;
        line.beginPath();
        points.forEach((p, k) => (k ? line.lineTo(p[0], p[1]) : line.moveTo(p[0], p[1])));
        line.closePath();
        line.fillStyle = fill;
        line.fill();
        line.lineWidth = 1.2;
        line.strokeStyle = edge;
        line.stroke();
    }

    dot(p, radius, colour) {
        this.context.beginPath();
        this.context.arc(p[0], p[1], radius, 0, 2 * Math.PI);
        this.context.fillStyle = colour;
        this.context.fill();
    }

    frame(origin, axes, length, parts) {
        const from = this.place(origin);
        axes.forEach((axis, k) => {
            const to = this.place(add(origin, axis, length));
            parts.push({ depth: Infinity, draw: () => this.stroke([from, to], 2, FRAME_COLOURS[k]) });
        });
    }

    gripper(tool, axes, thick, parts) {
        const reach = 1.6 * thick;
        const at = (y, z) => this.place(add(add(tool, axes[1], y), axes[2], z));
        const fingers = [[at(-reach, reach), at(-reach, 0), at(reach, 0), at(reach, reach)]];
        parts.push({
            depth: fingers[0][1][2],
            draw: () => fingers.forEach((points) => this.stroke(points, 2.2, this.colours.ink)),
        });
    }

    // The ellipsoid of equal inertia about the centre of mass.
    inertia(link, origin, axes, parts) {
        const centre = centreOf(link, origin, axes);
        const place = this.place(centre);
        if (link.ellipsoid) {
            const { semi_axes: sizes, directions } = link.ellipsoid;
            const own = [0, 1, 2].map((k) => axes.reduce((v, axis, i) => add(v, axis, directions[i][k]), [0, 0, 0]));
            const matrix = square(own.map((axis, k) => axis.map((x) => x * sizes[k])));
            parts.push({ depth: Infinity, draw: () => this.ellipse(place, matrix, this.scale, this.colours.arms[1]) });
        }
        if (link.mass) parts.push({ depth: Infinity, draw: () => this.dot(place, 3, this.colours.arms[1]) });
    }

    // How fast the tool moves for joint rates of size 1: the ellipsoid of J J^T.
    velocity(arm, tool, which, parts) {
        const n = arm.data.joints.length;
        const columns = Array.from({ length: n }, (_, j) => [0, 1, 2].map((i) => arm.jacobian[i * n + j]));
        const matrix = square(columns);
        const largest = Math.sqrt(Math.max(matrix[0][0] + matrix[1][1] + matrix[2][2], 1e-12));
        const scale = (this.scale * 0.35 * this.radius) / largest;
        const place = this.place(tool);
        parts.push({ depth: Infinity, draw: () => this.ellipse(place, matrix, scale, this.colours.arms[which]) });
    }

    // The outline of the ellipsoid x^T matrix^-1 x = 1.
    ellipse(place, matrix, scale, colour) {
        const [u, v] = [this.right, this.up];
        const [a, b, c] = [form(matrix, u, u), form(matrix, u, v), form(matrix, v, v)];
        const middle = (a + c) / 2;
        const off = Math.hypot((a - c) / 2, b);
        const line = this.context;
        line.beginPath();
        line.ellipse(
            place[0], place[1], scale * Math.sqrt(middle + off), scale * Math.sqrt(Math.max(middle - off, 0)),
            -Math.atan2(2 * b, a - c) / 2, 0, 2 * Math.PI,
        );
        line.globalAlpha = 0.14;
        line.fillStyle = colour;
        line.fill();
        line.globalAlpha = 1;
        line.lineWidth = 1.4;
        line.strokeStyle = colour;
        line.stroke();
    }

    // The axes of the world in a corner.
    triad() {
        const [x, y] = [34, this.height - 34];
        const ends = [0, 1, 2].map((k) => [x + 20 * this.right[k], y - 20 * this.up[k], this.toward[k], k]);
        this.context.font = "600 11px system-ui, sans-serif";
        this.context.textAlign = "center";
        this.context.textBaseline = "middle";
        for (const [u, v, , k] of ends.sort((a, b) => a[2] - b[2])) {
            this.stroke([[x, y], [u, v]], 2, FRAME_COLOURS[k]);
            this.context.fillStyle = this.colours.ink;
            this.context.fillText("xyz"[k], x + (u - x) * 1.45, y + (v - y) * 1.45);
        }
    }
}

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const sub = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const add = (a, b, s) => [a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]];
const form = (m, u, v) => m.reduce((sum, row, i) => sum + u[i] * dot(row, v), 0);
// Where the centre of mass of a link is.
const centreOf = (link, origin, axes) => axes.reduce((p, axis, k) => add(p, axis, link.com[k]), origin);
// The sum of v v^T.
const square = (vectors) => [0, 1, 2].map((i) => [0, 1, 2].map((j) => vectors.reduce((s, v) => s + v[i] * v[j], 0)));

// The convex hull of points of a plane (Andrew 1979).
function hull(points) {
    const sorted = [...points].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
    const half = (list) => {
        const chain = [];
        for (const p of list) {
            while (chain.length > 1) {
                const [a, b] = chain.slice(-2);
                if ((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) > 0) break;
                chain.pop();
            }
            chain.push(p);
        }
        return chain.slice(0, -1);
    };
    return [...half(sorted), ...half(sorted.reverse())];
}
