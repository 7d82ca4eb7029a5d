/* A run: what it was asked for, and where it is. All of its state is here, so that it can be advanced in parts. */
#ifndef RUN_H
#define RUN_H
#include <stddef.h>
#include "system.h"
#include "settings.h"
#include "linear.h"

enum { STAGES = 7 };
enum { GOING, NOT_FINITE, NO_ACCELERATION, TOO_MANY_STEPS, STEP_TOO_SMALL };
enum { STEPS, REJECTED, EVALUATIONS, EVENTS, ITERATIONS, COUNTERS };

/* The rows of the elements that are stuck: `row` [rows] is a basis of them all, `coefficient` how all of them come
 * from it; the multipliers of all are the least ones that make the same force. */
typedef struct {
    int count, rows, stuck[E1], row[E1];
    double coefficient[E1][E1], normal[E1][E1], inverse[E1];
} basis;

struct run {
    settings is;
    double t, x[SIZE];
    long recorded, samples, counter[COUNTERS];
    int status;

    /* control */
    long instant;      /* of the control that is due next */
    int next_break;
    double finish;     /* the run's end: steps stay before it */
    double until;      /* the stage times stay before this: the next discontinuity */
    double command[N], applied[N], tau[N];

    /* dry friction: s is the direction, 0 where stuck; `rest` where u = 0, stuck or about to move */
    double s[E1], lambda[E1], square[E1];
    int rest[E1], unit[E1], colour[E1], colours;
    int hold;          /* elements at rest stay stuck, whatever their multipliers: there were too many events */
    int burst;         /* events since the last step without one */
    basis stuck;

    /* accelerations, and the factors they came from */
    double a[N], mu[E1], M[N][N], inverse[N], force[N], X[E1][N], G[E1][E1], g_inverse[E1];
    int pivot[N], g_pivot[E1];

    /* the step: the slopes of its stages, its end, its error, and the interpolant of the last one */
    double k[STAGES][SIZE], end[SIZE], error, h, last_error;
    int known;         /* k[0] is the slope at t */
    int landing;       /* the step has ended on an event, which is yet to be carried out */
    double moved[E1];  /* what the speeds of the elements changed by in it */
    double from, length, coefficient[5][SIZE];
};
#endif
