// The map of a fleet: search, filters by type and effect, and what a cell shows, by mouse and by keyboard.
"use strict";

const fleet = JSON.parse(document.getElementById("fleet").textContent);
const SHOWN = 20;

// How unusual a unit is at a place, in tenths, by the feature that is furthest from usual there.
function furthest(unit, place, kind) {
    const [type, , unusual] = unit;
    let best = null;
    fleet.types[type].features.forEach(([, joint, of], k) => {
        if (joint !== place || (kind !== null && of !== kind) || unusual[k] === null) return;
        if (best === null || Math.abs(unusual[k]) > Math.abs(unusual[best])) best = k;
    });
    return best;
}

function figure(tenths) {
    const value = Math.abs(tenths) >= 100 ? String(Math.round(Math.abs(tenths) / 10)) : (Math.abs(tenths) / 10).toFixed(1);
    return tenths > 0 ? `+${value}` : tenths < 0 ? `\u2212${value}` : value;
}

function looks(tenths, isNamed) {
    const steps = fleet.shades.filter((bound) => Math.abs(tenths) >= 10 * bound).length;
    return ["v", steps ? (tenths > 0 ? "p" : "m") + steps : "", isNamed ? "named" : ""].filter(Boolean).join(" ");
}

function element(name, text, parent, css) {
    const made = document.createElement(name);
    made.textContent = text;
    if (css) made.className = css;
    parent.append(made);
    return made;
}

class FleetMap {
    constructor(root) {
        this.root = root;
        this.types = [...root.querySelectorAll("div.type")];
        this.rows = [...root.querySelectorAll("tr[data-u]")];
        this.rows.forEach((row, k) => { row.place = k; });
        this.fields = Object.fromEntries(["search", "type", "kind", "only"].map((id) => [id, root.querySelector(`#${id}`)]));
        this.count = root.querySelector("#count");
        this.detail = root.querySelector("#detail");
        this.opened = new Map(this.types.map((type) => [type, false]));
        this.kind = null;
        for (const part of [root.querySelector("#tools"), root.querySelector("#keys"), this.detail]) part.hidden = false;
        for (const field of Object.values(this.fields)) {
            for (const event of ["input", "change"]) field.addEventListener(event, () => this.filter());
        }
        for (const table of root.querySelectorAll("table.map")) this.listen(table);
        this.tell(null);
        this.filter();
    }

    listen(table) {
        table.setAttribute("role", "grid");
        table.addEventListener("mouseover", (event) => this.tell(event.target.closest("td.v")));
        table.addEventListener("focusin", (event) => {
            const cell = event.target.closest("td.v");
            if (!cell) return;
            this.stop(table, cell);
            this.tell(cell);
        });
        table.addEventListener("mousedown", (event) => event.target.closest("td.v")?.focus());
        table.addEventListener("keydown", (event) => this.key(table, event));
        for (const cell of table.querySelectorAll("td.v")) cell.tabIndex = -1;
    }

    // The one cell of a table to which Tab comes.
    stop(table, cell) {
        for (const other of table.querySelectorAll('td.v[tabindex="0"]')) other.tabIndex = -1;
        if (cell) cell.tabIndex = 0;
    }

    key(table, event) {
        const cell = event.target.closest("td.v");
        if (!cell || event.ctrlKey || event.altKey || event.metaKey) return;
        const rows = [...table.querySelectorAll("tr[data-u]:not([hidden])")];
        const row = cell.parentElement;
        const cells = [...row.querySelectorAll("td.v")];
        const [down, across] = [rows.indexOf(row), cells.indexOf(cell)];
        const moves = {
            ArrowDown: [down + 1, across], ArrowUp: [down - 1, across],
            ArrowRight: [down, across + 1], ArrowLeft: [down, across - 1],
            Home: [down, 0], End: [down, cells.length - 1],
            PageDown: [Math.min(down + 10, rows.length - 1), across], PageUp: [Math.max(down - 10, 0), across],
        };
        if (event.key === "Enter") row.querySelector("a").click();
        else if (event.key in moves) rows[moves[event.key][0]]?.querySelectorAll("td.v")[moves[event.key][1]]?.focus();
        else return;
        event.preventDefault();
    }

    filter() {
        const words = this.fields.search.value.trim().toLowerCase();
        const type = this.fields.type.value;
        const kind = this.fields.kind.value === "" ? null : Number(this.fields.kind.value);
        const only = this.fields.only.checked;
        if (kind !== this.kind) this.shade(kind);
        let shown = 0;
        for (const row of this.rows) {
            const unit = fleet.units[row.dataset.u];
            row.hidden = (type !== "" && unit[0] !== Number(type)) || !unit[1].toLowerCase().includes(words)
                || (only && !this.named(unit).length);
            shown += !row.hidden;
        }
        const narrowed = words !== "" || only;
        for (const part of this.types) {
            const folded = part.querySelector("details");
            part.hidden = !part.querySelector("tr[data-u]:not([hidden])");
            for (const table of part.querySelectorAll("table.map")) this.enter(table);
            if (!folded) continue;
            const rest = folded.querySelectorAll("tr[data-u]:not([hidden])").length;
            folded.hidden = rest === 0;
            folded.querySelector("summary").textContent = `${rest} more of ${fleet.types[part.dataset.type].name}`;
            if (narrowed !== this.opened.get(part)) folded.open = narrowed && rest > 0;
            this.opened.set(part, narrowed);
        }
        const total = fleet.units.length;
        const all = `${total.toLocaleString("en")} ${total === 1 ? "unit" : "units"}`;
        this.count.textContent = shown === total ? all : `${shown.toLocaleString("en")} of ${all}`;
    }

    // What is named of a unit, of the kind that is shown.
    named([type, , , , named]) {
        return named.filter((k) => this.kind === null || fleet.types[type].features[k][2] === this.kind);
    }

    // Cells of one kind of effects, or of all; rows in the order of what they show.
    shade(kind) {
        this.kind = kind;
        const order = new Map();
        for (const row of this.rows) {
            const unit = fleet.units[row.dataset.u];
            const { places, features } = fleet.types[unit[0]];
            const named = this.named(unit);
            let most = 0;
            row.querySelectorAll("td.v").forEach((cell, k) => {
                const best = furthest(unit, places[k], kind);
                const tenths = best === null ? 0 : unit[2][best];
                cell.className = looks(tenths, named.some((f) => features[f][1] === places[k]));
                cell.firstElementChild.textContent = best === null ? "\u2013" : figure(tenths);
                most = Math.max(most, Math.abs(tenths));
            });
            order.set(row, kind === null ? [0, row.place] : [named.length ? 0 : 1, -most]);
        }
        for (const part of this.types) {
            const [first, rest] = part.querySelectorAll("tbody");
            const rows = this.rows.filter((row) => part.contains(row)).sort((a, b) => {
                const [p, q] = [order.get(a), order.get(b)];
                return p[0] - q[0] || p[1] - q[1] || a.place - b.place;
            });
            first.append(...rows.slice(0, SHOWN));
            rest?.append(...rows.slice(SHOWN));
        }
    }

    // Tab comes to the first cell that is seen.
    enter(table) {
        const stop = table.querySelector('tr:not([hidden]) td.v[tabindex="0"]');
        if (!stop) this.stop(table, table.querySelector("tr[data-u]:not([hidden]) td.v"));
    }

    tell(cell) {
        if (cell === null) {
            if (!this.detail.firstChild) element("p", "Point at a cell, or move to it with the keyboard, to see what it shows.", this.detail, "soft");
            return;
        }
        const row = cell.parentElement;
        const unit = fleet.units[row.dataset.u];
        const { places, features, name } = fleet.types[unit[0]];
        const place = places[[...row.querySelectorAll("td.v")].indexOf(cell)];
        this.detail.replaceChildren();
        const head = element("p", "", this.detail);
        element("b", unit[1], head);
        head.append(`, ${name}, ${place ? `joint ${place}` : "the whole arm"}`);
        const list = features
            .map((feature, k) => [feature, unit[2][k], unit[3][k], unit[4].includes(k)])
            .filter(([feature]) => feature[1] === place && (this.kind === null || feature[2] === this.kind))
            .sort((a, b) => Math.abs(b[1] ?? 0) - Math.abs(a[1] ?? 0));
        for (const [[title, , , usual], tenths, now, isNamed] of list) {
            const line = element("p", "", this.detail, isNamed ? "" : "soft");
            element("b", tenths === null ? "\u2013" : figure(tenths), line);
            line.append(` ${title}: ${now || "not known"}, usual ${usual}${isNamed ? "; named" : ""}`);
        }
        if (!list.length) element("p", "No feature of this joint is seen by the logs.", this.detail, "soft");
    }
}

const units = document.getElementById("units");
if (units) globalThis.fleetMap = new FleetMap(units);
