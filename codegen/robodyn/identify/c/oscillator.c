/* A link on its spring: mass * a + (rub + damping) * v + stiff * x + spring(x) = load, at even steps, by the
 * trapezoidal rule, which adds no damping and is stable at any step (Newmark 1959).
 *
 * load, mass, rub, stiff [count]: at the times of the steps. The spring is piecewise linear: its forces
 * [places] stand at low, low + width, ...; beyond them it goes on as it ends. */
#include <math.h>
#include <stddef.h>

enum { CORRECTIONS = 8 };

typedef struct {
    const double *load, *mass, *rub, *stiff;
    double step;
    const double *force;
    size_t places;
    double low, width, damping;
} link_on_spring;

/* The piece of the spring at x: its slope, and its force at x = 0. */
static inline double piece(const link_on_spring *s, double turns, double x, double *here)
{
    const double at = (x - s->low) * turns;
    const size_t i = !(at > 0.0) ? 0 : at >= (double)(s->places - 2) ? s->places - 2 : (size_t)at;
    const double slope = (s->force[i + 1] - s->force[i]) * turns;
    *here = s->force[i] - slope * (s->low + (double)i * s->width);
    return slope;
}

/* One row from state[3] = x, v, a to the next; the first row is where it begins. Whether it is finite. */
static inline int advanced(const link_on_spring *s, size_t row, double turns, double state[3])
{
    const double half = s->step / 2.0, quarter = s->step * s->step / 4.0;
    const double weight = row ? quarter : 0.0, turn = row ? half : 0.0;
    const double v_free = row ? state[1] + half * state[2] : state[1];
    const double x_free = row ? state[0] + s->step * state[1] + quarter * state[2] : state[0];
    const double drag = s->rub[row] + s->damping;
    const double rest = s->load[row] - drag * v_free - s->stiff[row] * x_free;
    const double own = s->mass[row] + drag * turn + s->stiff[row] * weight;
    double x = state[0], a = 0.0;
    int k;
    for (k = 0; k < CORRECTIONS; ++k) {
        const double before = x;
        double here;
        const double slope = piece(s, turns, x, &here);
        a = (rest - here - slope * x_free) / (own + slope * weight);
        x = x_free + weight * a;
        if (fabs(x - before) <= 1e-3 * s->width)
            break;
    }
    state[0] = x;
    state[1] = v_free + turn * a;
    state[2] = a;
    return isfinite(x + state[1] + a);
}

/* out [count][3] gets x, v, a of a link that begins at x and v. Returns how many rows are finite. */
size_t oscillator(const link_on_spring *s, size_t count, double x, double v, double *out)
{
    const double turns = 1.0 / s->width;
    double state[3] = {x, v, 0.0};
    size_t row;
    for (row = 0; row < count; ++row) {
        const int finite = advanced(s, row, turns, state);
        out[3 * row] = state[0];
        out[3 * row + 1] = state[1];
        out[3 * row + 2] = state[2];
        if (!finite)
            break;
    }
    return row;
}

/* left [count] gets what the spring passes on less what was measured to pass. Returns how many rows are
 * finite. */
size_t oscillator_misfit(const link_on_spring *s, size_t count, double x, double v, const double *passed,
                         double *left)
{
    const double turns = 1.0 / s->width;
    double state[3] = {x, v, 0.0};
    size_t row;
    for (row = 0; row < count; ++row) {
        double here;
        const int finite = advanced(s, row, turns, state);
        const double slope = piece(s, turns, state[0], &here);
        left[row] = here + slope * state[0] + s->damping * state[1] - passed[row];
        if (!finite)
            break;
    }
    return row;
}

/* z [count] gets the deflection of a Dahl contact, as a share of the limit at which it slides, along the
 * positions q; exact between samples. */
void dahl(const double *q, size_t count, double limit, double *z)
{
    double now = 0.0;
    size_t row;
    for (row = 0; row < count; ++row) {
        const double way = row ? (q[row] - q[row - 1]) / limit : 0.0;
        const double left = exp(-fabs(way)), gone = -expm1(-fabs(way));
        now = now * left + (way > 0.0 ? gone : way < 0.0 ? -gone : 0.0);
        z[row] = now;
    }
}
