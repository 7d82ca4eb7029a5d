/* The Robotics Toolbox's ne.c (compiled beside this file), as its own frne calls it, without Python around it. */
#include "peer.h"
#include "frne.h"

#include <math.h>

static int count, n;
static const double *q, *qd, *qdd;
static double *tau;
static Robot robot;
static Vect gravity;

/* Rotation and offset of a link in modified DH frames, as the toolbox has it before every call of ne.c. */
static void place(Link *l, double theta, double d)
{
    double st = sin(theta), ct = cos(theta), sa = sin(l->alpha), ca = cos(l->alpha);
    l->R.n.x = ct;
    l->R.o.x = -st;
    l->R.a.x = 0.0;
    l->R.n.y = st * ca;
    l->R.o.y = ca * ct;
    l->R.a.y = -sa;
    l->R.n.z = st * sa;
    l->R.o.z = ct * sa;
    l->R.a.z = ca;
    l->r.x = l->A;
    l->r.y = -d * sa;
    l->r.z = d * ca;
}

int peer_open(const char *folder, int states, int joints, const double *p, const double *v, const double *a)
{
    static peer_arm arm;
    static Vect com[64];
    static double friction[2];
    int i;
    if (peer_read_arm(folder, &arm) || arm.n != joints)
        return 1;
    count = states;
    n = joints;
    gravity.x = -arm.gravity[0];
    gravity.y = -arm.gravity[1];
    gravity.z = -arm.gravity[2];
    robot.njoints = n;
    robot.gravity = &gravity;
    robot.dhtype = MODIFIED;
    robot.links = calloc((size_t)n, sizeof(Link));
    for (i = 0; i < n; i++) {
        Link *l = &robot.links[i];
        const peer_link *from = &arm.link[i];
        l->alpha = from->alpha[0];
        l->A = from->a;
        l->D = from->d;
        l->theta = from->theta[0];
        l->offset = from->revolute != 0 ? from->theta[0] : from->d;
        l->jointtype = from->revolute != 0 ? REVOLUTE : PRISMATIC;
        com[i].x = from->com[0];
        com[i].y = from->com[1];
        com[i].z = from->com[2];
        l->rbar = &com[i];
        l->m = from->mass;
        l->I = (double *)from->inertia;
        l->Jm = from->rotor;
        l->G = 1.0;
        l->Tc = friction;
    }
    q = peer_copy(p, (size_t)(count * n));
    qd = peer_copy(v, (size_t)(count * n));
    qdd = peer_copy(a, (size_t)(count * n));
    tau = calloc((size_t)(count * n), sizeof(double));
    return !tau;
}

void peer_run(void)
{
    static double nothing[6];
    int k, i;
    for (k = 0; k < count; k++) {
        for (i = 0; i < n; i++) {
            Link *l = &robot.links[i];
            double at = q[k * n + i] + l->offset;
            if (l->jointtype == REVOLUTE)
                place(l, at, l->D);
            else
                place(l, l->theta, at);
        }
        newton_euler(&robot, tau + k * n, (double *)(qd + k * n), (double *)(qdd + k * n), nothing, 1);
    }
}

void peer_result(double *out)
{
    int k;
    for (k = 0; k < count * n; k++)
        out[k] = tau[k];
}
