
// An arm: its data, and the emitted kernel on arrays of its own.

class Arm {
    constructor(data, kernel) {
        this.data = data;
        this.kernel = kernel;
        this.n = data.joints.length;
        const sizes = (name) => data.kernel.functions[name].outputs.map((length) => new Float64Array(length));
        [this.torque] = sizes("inverse_dynamics");
        [this.gravity] = sizes("gravity");
        [this.mass] = sizes("mass_matrix");
        [this.places, this.turns] = sizes("link_poses");
        [this.toolPose] = sizes("forward_kinematics");
        [this.jacobian] = sizes("jacobian");
        this.remembers = data.kernel.functions.inverse_dynamics.remembers;
        this.memory = null;
    }

    // Everything at a state; of what remembers, dt [s] after the last one, at rest without it.
    move(q, qd, qdd, dt = null) {
        const own = [q, qd, qdd].map((x) => x.slice(0, this.n));
        if (this.remembers) {
            if (dt === null || !this.memory) {
                this.memory = this.kernel.initial_state();
                dt = 0;
            }
            this.kernel.inverse_dynamics(...own, this.torque, this.memory, dt);
        } else {
            this.kernel.inverse_dynamics(...own, this.torque);
        }
        this.kernel.gravity(own[0], this.gravity);
        this.kernel.mass_matrix(own[0], this.mass);
        this.kernel.jacobian(own[0], this.jacobian);
        this.locate(own[0]);
    }

    // Frames of the links and of the tool: origins, and axes by rows.
    locate(q) {
        this.kernel.link_poses(q.slice(0, this.n), this.places, this.turns);
        this.kernel.forward_kinematics(q.slice(0, this.n), this.toolPose);
        const T = this.toolPose;
        const column = (m, start, k, width) => [m[start + k], m[start + width + k], m[start + 2 * width + k]];
        const each = Array.from({ length: this.n }, (_, i) => i);
        this.pose = {
            base: this.data.base ? this.data.base.xyz : [0, 0, 0],
            origins: each.map((i) => [...this.places.subarray(3 * i, 3 * i + 3)]),
            axes: each.map((i) => [0, 1, 2].map((k) => column(this.turns, 9 * i, k, 3))),
            tool: [T[3], T[7], T[11]],
            toolAxes: [0, 1, 2].map((k) => column(T, 0, k, 4)),
        };
    }

    // Yoshikawa's measure of the tool's velocity, sqrt det(J J^T), and the ratio of the ellipsoid's axes.
    manipulability() {
        const n = this.n;
        const m = square(Array.from({ length: n }, (_, j) => [0, 1, 2].map((i) => this.jacobian[i * n + j])));
        const values = eigenvalues(m);
        return {
            measure: Math.sqrt(Math.max(values[0] * values[1] * values[2], 0)),
            condition: values[2] > 1e-14 * values[0] ? Math.sqrt(values[0] / values[2]) : Infinity,
        };
    }

    // Position, velocity and acceleration of the motion at t [s].
    motion(t) {
        const { period, mean, sines, cosines } = this.data.motion;
        const w = (2 * Math.PI) / period;
        const state = [mean.slice(), mean.map(() => 0), mean.map(() => 0)];
        for (let j = 0; j < this.n; ++j) {
            sines[j].forEach((a, k) => {
                const rate = (k + 1) * w;
                const [s, c, b] = [Math.sin(rate * t), Math.cos(rate * t), cosines[j][k]];
                state[0][j] += a * s + b * c;
                state[1][j] += rate * (a * c - b * s);
                state[2][j] -= rate * rate * (a * s + b * c);
            });
        }
        return state;
    }
}

// Of a symmetric matrix of three rows, largest first (Smith 1961).
function eigenvalues(m) {
    const mean = (m[0][0] + m[1][1] + m[2][2]) / 3;
    const b = m.map((row, i) => row.map((x, j) => x - (i === j ? mean : 0)));
    const size = Math.sqrt(b.flat().reduce((sum, x) => sum + x * x, 0) / 6);
    if (size === 0) return [mean, mean, mean];
    const half = (dot(b[0], [
        b[1][1] * b[2][2] - b[1][2] * b[2][1], b[1][2] * b[2][0] - b[1][0] * b[2][2],
        b[1][0] * b[2][1] - b[1][1] * b[2][0],
    ])) / (2 * size ** 3);
    const angle = Math.acos(Math.min(1, Math.max(-1, half))) / 3;
    return [0, 1, 2].map((k) => mean + 2 * size * Math.cos(angle - (2 * Math.PI * k) / 3)).sort((x, y) => y - x);
}
