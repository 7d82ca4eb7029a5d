
// The controls and figures beside the drawing.

// A figure with so many decimal places, without a negative zero.
function fixed(x, places) {
    const text = x.toFixed(places);
    return (Number(text) === 0 ? text.replace("-", "") : text).replace("-", "−");
}

// A figure of four digits.
function figure(x, digits = 4) {
    const size = Math.abs(x);
    if (size !== 0 && (size < 1e-4 || size >= 1e7)) return x.toExponential(digits - 2).replace(/-/g, "−");
    return fixed(x, Math.min(4, Math.max(0, digits - 1 - Math.floor(Math.log10(Math.max(size, 0.1))))));
}

class Panel {
    constructor(root, arms) {
        this.arms = arms;
        this.most = arms.reduce((a, b) => (b.n > a.n ? b : a));
        const all = (selector) => [...root.querySelectorAll(selector)];
        this.sliders = all("input[data-q]");
        this.positions = all("[data-position]");
        this.rates = ["qd", "qdd"].map((name) => all(`input[data-${name}]`));
        const cells = (name) => arms.map((_, a) => all(`[data-${name}^="${a}."]`));
        this.torques = cells("torque");
        this.holding = cells("gravity");
        this.bars = cells("bar");
        this.tools = all("[data-tool]");
        this.measures = all("[data-measure]");
        this.conditions = all("[data-condition]");
        this.matrices = { jacobian: all("[data-jacobian]"), mass: all("[data-mass]") };
        // What fills a bar: the joint's limit of torque, else the most that the motion needs.
        this.full = arms[0].data.joints.map((joint, j) => Math.max(
            joint.limits.torque ?? 0,
            ...(joint.limits.torque ? [] : arms.flatMap((arm) => (arm.data.motion.torque[j] ?? []).map(Math.abs))),
            1e-9,
        ));
        // Decimal places that show four digits of a full bar: figures do not jump as they change.
        this.places = this.full.map((full) => Math.min(4, Math.max(0, 3 - Math.floor(Math.log10(full)))));
    }

    read() {
        const numbers = (inputs) => inputs.map((input) => Number(input.value) || 0);
        return [numbers(this.sliders), ...this.rates.map(numbers)];
    }

    write(q, qd, qdd) {
        this.sliders.forEach((slider, j) => (slider.value = q[j]));
        [qd, qdd].forEach((values, k) => this.rates[k].forEach((input, j) => (input.value = Number(values[j].toPrecision(4)))));
    }

    show(q) {
        this.sliders.forEach((slider, j) => {
            const revolute = this.most.data.joints[j].kind === "revolute";
            const degrees = (q[j] * 180) / Math.PI;
            const number = revolute ? fixed(degrees, 1) : fixed(q[j], 3);
            set(this.positions[j], number + (revolute ? "°" : " m"));
            slider.setAttribute("aria-valuetext", `${number} ${revolute ? "degrees" : "metres"}`);
        });
        this.arms.forEach((arm, a) => {
            for (let j = 0; j < arm.n; ++j) {
                set(this.torques[a][j], fixed(arm.torque[j], this.places[j]));
                set(this.holding[a][j], fixed(arm.gravity[j], this.places[j]));
                const share = Math.max(-1, Math.min(1, arm.torque[j] / this.full[j]));
                const bar = this.bars[a][j];
                bar.style.transform = `scaleX(${share.toFixed(4)})`;
                bar.classList.toggle("over", Math.abs(arm.torque[j]) > this.full[j]);
            }
            const { measure, condition } = arm.manipulability();
            set(this.tools[a], arm.pose.tool.map((x) => fixed(x, 4)).join("  "));
            set(this.measures[a], figure(measure));
            set(this.conditions[a], condition > 9999 ? "singular" : figure(condition, 3));
            this.matrix(this.matrices.jacobian[a], arm.jacobian, 4);
            this.matrix(this.matrices.mass[a], arm.mass, 4);
        });
    }

    // Fills a table that is unfolded.
    matrix(table, values, places) {
        if (!table || !table.closest("details").open) return;
        table.querySelectorAll("td").forEach((cell, k) => set(cell, fixed(values[k], places)));
    }
}

function set(element, text) {
    if (element && element.textContent !== text) element.textContent = text;
}
