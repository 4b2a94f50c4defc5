/* All points through the C that CasADi generates: `single` takes one point per call, `mapped` takes MAPPED of them. */
#include <stddef.h>

#include "casadi_generated.c"

static const double *arg[ROOM_ARG];
static double *res[ROOM_RES];
static casadi_int iw[ROOM_IW];
static double w[ROOM_W];

#define LOOP(NAME, POINTS)                                                                                    \
    void loop_##NAME(size_t n, const double *position, const double *curves, const double *parameters,        \
                     const double *point, double *deviation)                                                  \
    {                                                                                                         \
        for (size_t i = 0; i < n; i += POINTS) {                                                              \
            arg[0] = position + 3 * i;                                                                        \
            arg[1] = curves;                                                                                  \
            arg[2] = parameters;                                                                              \
            arg[3] = point;                                                                                   \
            res[0] = deviation + 3 * i;                                                                       \
            NAME(arg, res, iw, w, 0);                                                                         \
        }                                                                                                     \
    }

LOOP(single, 1)
LOOP(mapped, MAPPED)
