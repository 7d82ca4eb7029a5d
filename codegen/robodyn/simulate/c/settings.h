/* What Python asks for. The arrays stay Python's and must live as long as the run. */
#ifndef SETTINGS_H
#define SETTINGS_H
/* declarations for Python start here */
typedef struct {
    int method;              /* 0 rk4, 1 adaptive */
    double step;             /* rk4: of this length or a little less; adaptive: the longest */
    double rtol, atol;
    double duration, sample_period;
    long max_steps;
    const double *y, *v, *z; /* the start */
    const double *parameters;
    const double *breaks;    /* ascending */
    int break_count;
    int control;             /* 0 held table, 1 linear table, 2 PD, 3 computed torque */
    int motors;
    const int *place, *seen; /* [motors] coordinate that is driven, that is measured */
    double period;           /* of the control and its tables */
    long rows;               /* of the tables, [rows, motors]; the last one holds on */
    const double *torque, *q, *qd, *qdd;
    const double *kp, *kd;   /* [motors] */
    const double *limit;     /* [motors], or null */
    double *record;          /* [samples, width] t y v a z s command applied work loss */
} settings;
typedef struct run run;
run *run_new(const settings *);
void run_free(run *);
int run_advance(run *, long evaluations);
double run_time(const run *);
long run_samples(const run *);
long run_recorded(const run *);
long run_counter(const run *, int which);
int engine_size(int which);
/* rows of [motors] each through the system's model; 1 if there is none */
int model_torques(long rows, const double *q, const double *qd, const double *qdd, double *tau, int motors,
                  const double *parameters);
/* declarations for Python end here */
#endif
