/* A link on its spring: mass * a + (rub + damping) * v + stiff * x + spring(x) = load, at even steps, by the
 * trapezoidal rule, which adds no damping and is stable at any step (Newmark 1959).
 *
 * load, mass, rub, stiff [count]: at the times of the steps. The spring is piecewise linear: its forces
 * [places] stand at low, low + width, ...; beyond them it goes on as it ends. x and v at first; out [count][3]
 * gets x, v, a. Returns how many rows are finite. */
#include <math.h>
#include <stddef.h>

enum { CORRECTIONS = 8 };

size_t oscillator(const double *load, const double *mass, const double *rub, const double *stiff,
                  size_t count, double step, const double *force, size_t places, double low, double width,
                  double damping, double x, double v, double *out)
{
    const double half = step / 2.0, quarter = step * step / 4.0;
    double a = 0.0;
    size_t row;
    for (row = 0; row < count; ++row) {
        /* The first row is where it begins; then a step. */
        const double weight = row ? quarter : 0.0, turn = row ? half : 0.0;
        const double v_free = row ? v + half * a : v;
        const double x_free = row ? x + step * v + quarter * a : x;
        const double rest = load[row] - (rub[row] + damping) * v_free - stiff[row] * x_free;
        const double own = mass[row] + (rub[row] + damping) * turn + stiff[row] * weight;
        int k;
        for (k = 0; k < CORRECTIONS; ++k) {
            const double at = (x - low) / width;
            const size_t i = !(at > 0.0) ? 0 : at >= (double)(places - 2) ? places - 2 : (size_t)at;
            const double slope = (force[i + 1] - force[i]) / width;
            const double here = force[i] - slope * (low + (double)i * width);
            const double before = x;
            a = (rest - here - slope * x_free) / (own + slope * weight);
            x = x_free + weight * a;
            if (fabs(x - before) <= 1e-3 * width)
                break;
        }
        v = v_free + turn * a;
        out[3 * row] = x;
        out[3 * row + 1] = v;
        out[3 * row + 2] = a;
        if (!isfinite(x + v + a))
            break;
    }
    return row;
}
