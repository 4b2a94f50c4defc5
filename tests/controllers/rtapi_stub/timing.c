/* How long the module takes for one call: mean over random poses within the travel. */
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "kinematics.h"

double stub_time(const double *low, const double *high, int calls, int forward);

static double now(void)
{
    struct timespec at;
    clock_gettime(CLOCK_MONOTONIC, &at);
    return (double)at.tv_sec * 1e9 + (double)at.tv_nsec;
}

/* ns a call; low, high: of X Y Z A B C */
double stub_time(const double *low, const double *high, int calls, int forward)
{
    enum { POSES = 1024 };
    static EmcPose poses[POSES];
    static double joints[POSES][16];
    double begun;
    srand(1);
    for (int k = 0; k < POSES; ++k) {
        double at[6];
        for (int axis = 0; axis < 6; ++axis) {
            at[axis] = low[axis] + (high[axis] - low[axis]) * rand() / RAND_MAX;
        }
        poses[k] = (EmcPose){ { at[0], at[1], at[2] }, at[3], at[4], at[5], 0.0, 0.0, 0.0 };
        kinematicsInverse(&poses[k], joints[k], NULL, NULL);
    }
    begun = now();
    for (int call = 0; call < calls; ++call) {
        const int k = call % POSES;
        if (forward) {
            kinematicsForward(joints[k], &poses[k], NULL, NULL);
        } else {
            kinematicsInverse(&poses[k], joints[k], NULL, NULL);
        }
    }
    return (now() - begun) / calls;
}
