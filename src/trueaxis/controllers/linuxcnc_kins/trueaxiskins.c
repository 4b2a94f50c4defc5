/* LinuxCNC kinematics of a machine with its geometric errors: written by trueaxis, see README.md beside it.
 * SPDX-License-Identifier: MIT
 *
 * World coordinates are the positions of the axes of an ideal machine. Joints are the positions at which this machine
 * has its tool point where the ideal one would have it. Built with: halcompile --install trueaxiskins.c
 */
#include "rtapi.h"
#include "rtapi_app.h"
#include "rtapi_math.h"
#include "hal.h"
#include "kinematics.h"

#include "control.c"
#include "curves.h"
#include "machine.h"
#include "joints.h"

MODULE_AUTHOR("trueaxis");
MODULE_DESCRIPTION("Kinematics of " MACHINE_NAME " with its geometric errors");
MODULE_LICENSE("Dual MIT/GPL");

#define TOLERANCE 1e-11    /* mm: of the last step, the error left is some 1e-4 of it; doubles hold 2e-12 mm at 10 m */
#define MOST_STEPS 20      /* a machine within 5 mm needs 3 to 6; one that needs more has values that are wrong */
#define SHORTEST_RAMP 0.1  /* s: 0.1 mm of correction then come with 1.5 mm/s at most */
#define DEFAULT_RAMP 1.0   /* s */
#define LONGEST_TOOL 2000.0 /* mm: an offset beyond is no tool's */

typedef struct {
    hal_bit_t *enable;      /* in: whether to correct */
    hal_bit_t *reset;       /* in: takes fault back */
    hal_float_t *tool[3];   /* in: what G43 adds to X, Y, Z, mm: motion.tooloffset.x y z */
    hal_float_t *ramp_time; /* in: s, from no correction to all of it, and from one tool to another */
    hal_float_t *share;     /* out: of the correction that acts, 0 to 1 */
    hal_bit_t *settled;     /* out: nothing is ramping */
    hal_bit_t *fault;       /* out: something was not finite or too large; stays until reset */
    hal_bit_t *converged;   /* out: whether the last inverse came to its end */
    hal_s32_t *steps;       /* out: of the last inverse */
    hal_float_t *correction[3]; /* out: of X, Y, Z by the last inverse, mm */
} pin_set;

static pin_set *pins;
static int component_id;

/* What `update` moves and what was good last. */
static double enable_phase;
static double share;
static double tool_phase = 1.0;
static double tool_from[3], tool_to[3], tool_now[3];
static double point[3]; /* the tip, tool frame, mm */
static double good_moves[AXES];
static double good_joints[MOST_JOINTS];
static double good_pose[AXES];

static void component_errors(const void *unused, const double *positions, double *errors)
{
    double at[AXES];
    (void)unused;
    for (int row = 0; row < AXES; ++row) {
        const double position = positions[row];
        at[row] = position < LOWEST[row] ? LOWEST[row] : position > HIGHEST[row] ? HIGHEST[row] : position;
    }
    for (int k = 0; k < COMPONENTS; ++k) {
        errors[k] = curve_at(&CURVES[k], at[CURVES[k].axis]);
    }
    add_effects(at, errors);
}

static MACHINE(machine) machine_now(void)
{
    MACHINE(machine) now;
    now.component_errors = component_errors;
    now.curves = 0;
    now.parameters = PARAMETERS;
    now.point = point;
    now.share = share;
    return now;
}

/* 0 to 1 with no step of velocity. */
static double smooth(double phase)
{
    return phase * phase * (3.0 - 2.0 * phase);
}

static void ramp_tool(double by)
{
    double asked[3]; /* read once: another thread may write the pins */
    int usable = 1;
    int changed = 0;
    for (int k = 0; k < 3; ++k) {
        asked[k] = *pins->tool[k];
        usable = usable && fabs(asked[k]) <= LONGEST_TOOL; /* false for NaN */
        changed = changed || asked[k] != tool_to[k];
    }
    if (!usable) {
        *pins->fault = 1;
    } else if (changed) {
        for (int k = 0; k < 3; ++k) {
            tool_from[k] = tool_now[k];
            tool_to[k] = asked[k];
        }
        tool_phase = 0.0;
    }
    tool_phase = enable_phase > 0.0 ? fmin(tool_phase + by, 1.0) : 1.0;
    for (int k = 0; k < 3; ++k) {
        const double way = smooth(tool_phase);
        tool_now[k] = (1.0 - way) * tool_from[k] + way * tool_to[k];
    }
    for (int row = 0; row < 3; ++row) {
        point[row] = TOOL_POINT[row];
        for (int k = 0; k < 3; ++k) {
            point[row] -= TOOL_SHIFT[row][k] * tool_now[k];
        }
    }
}

/* Once a servo cycle, before motion-controller: a step of an input becomes a ramp. */
static void update(void *unused, long period)
{
    const int enabled = *pins->enable;
    const double asked = *pins->ramp_time;
    const double ramp = asked >= SHORTEST_RAMP && asked < HUGE_VAL ? asked : SHORTEST_RAMP;
    const double by = (double)period * 1e-9 / ramp;
    (void)unused;
    if (*pins->reset) {
        *pins->fault = 0;
    }
    ramp_tool(by);
    enable_phase = enabled ? fmin(enable_phase + by, 1.0) : fmax(enable_phase - by, 0.0);
    share = smooth(enable_phase);
    *pins->share = share;
    *pins->settled = enable_phase == (enabled ? 1.0 : 0.0) && tool_phase == 1.0;
}

int kinematicsForward(const double *joints, EmcPose *world, const KINEMATICS_FORWARD_FLAGS *fflags,
    KINEMATICS_INVERSE_FLAGS *iflags)
{
    const MACHINE(machine) now = machine_now();
    double positions[AXES];
    double pose[AXES];
    int good;
    (void)fflags;
    (void)iflags;
    for (int row = 0; row < AXES; ++row) {
        positions[row] = joints[joint_of_axis[row]];
    }
    good = MACHINE(forward)(&now, positions, pose) == 0;
    for (int joint = joint_count - 1; joint >= 0; --joint) { /* of joints with one letter the first counts */
        good = good && isfinite(joints[joint]);
        if (good) {
            *coordinate(world, letter_of_joint[joint]) = joints[joint];
        }
    }
    if (!good) {
        *pins->fault = 1;
    }
    for (int row = 0; row < AXES; ++row) {
        good_pose[row] = good ? pose[row] : good_pose[row];
        *coordinate(world, AXIS_ROWS[row]) = good_pose[row];
    }
    return good ? 0 : -1;
}

/* Positions of the axes for a pose; what they are worth: 1, or 0 where they are held by what was good last. */
static int solved(const double *pose, double *positions)
{
    const MACHINE(machine) now = machine_now();
    const int steps = MACHINE(inverse)(&now, pose, TOLERANCE, MOST_STEPS, positions);
    int good = steps >= 0;
    *pins->converged = good;
    *pins->steps = steps >= 0 ? steps : MOST_STEPS;
    for (int row = 0; row < AXES; ++row) {
        good = good && fabs(positions[row] - pose[row]) <= BEYOND;
    }
    for (int row = 0; row < AXES; ++row) {
        good_moves[row] = good ? positions[row] - pose[row] : good_moves[row];
        positions[row] = good ? positions[row] : pose[row] + good_moves[row];
    }
    for (int k = 0; k < 3; ++k) {
        *pins->correction[k] = good_moves[LINEAR_ROWS[k]];
    }
    return good;
}

int kinematicsInverse(const EmcPose *world, double *joints, const KINEMATICS_INVERSE_FLAGS *iflags,
    KINEMATICS_FORWARD_FLAGS *fflags)
{
    EmcPose copy = *world;
    double wanted[MOST_JOINTS];
    double pose[AXES];
    double positions[AXES];
    int finite = 1;
    int good;
    (void)iflags;
    (void)fflags;
    for (int joint = 0; joint < joint_count; ++joint) {
        wanted[joint] = *coordinate(&copy, letter_of_joint[joint]);
        finite = finite && isfinite(wanted[joint]);
    }
    for (int row = 0; row < AXES; ++row) {
        pose[row] = wanted[joint_of_axis[row]];
    }
    good = finite && solved(pose, positions);
    if (finite) {
        for (int joint = 0; joint < joint_count; ++joint) {
            good_joints[joint] = wanted[joint];
            for (int row = 0; row < AXES; ++row) {
                if (AXIS_ROWS[row] == letter_of_joint[joint]) {
                    good_joints[joint] = positions[row];
                }
            }
        }
    }
    if (!good) {
        *pins->fault = 1;
    }
    for (int joint = 0; joint < joint_count; ++joint) {
        joints[joint] = good_joints[joint];
    }
    return good ? 0 : -1;
}

KINEMATICS_TYPE kinematicsType(void)
{
    return KINEMATICS_BOTH;
}

/* LinuxCNC 2.9 asks whether there are several kinematics to switch between. */
int kinematicsSwitchable(void);
int kinematicsSwitch(int type);

int kinematicsSwitchable(void)
{
    return 0;
}

int kinematicsSwitch(int type)
{
    (void)type;
    return 0;
}

EXPORT_SYMBOL(kinematicsForward);
EXPORT_SYMBOL(kinematicsInverse);
EXPORT_SYMBOL(kinematicsType);
EXPORT_SYMBOL(kinematicsSwitchable);
EXPORT_SYMBOL(kinematicsSwitch);

static int export_pins(void)
{
    static const char *const names[] = { "x", "y", "z" };
    int failed = 0;
    failed |= hal_pin_bit_newf(HAL_IN, &pins->enable, component_id, "trueaxiskins.enable");
    failed |= hal_pin_bit_newf(HAL_IN, &pins->reset, component_id, "trueaxiskins.reset");
    failed |= hal_pin_float_newf(HAL_IN, &pins->ramp_time, component_id, "trueaxiskins.ramp-time");
    failed |= hal_pin_float_newf(HAL_OUT, &pins->share, component_id, "trueaxiskins.share");
    failed |= hal_pin_bit_newf(HAL_OUT, &pins->settled, component_id, "trueaxiskins.settled");
    failed |= hal_pin_bit_newf(HAL_OUT, &pins->fault, component_id, "trueaxiskins.fault");
    failed |= hal_pin_bit_newf(HAL_OUT, &pins->converged, component_id, "trueaxiskins.converged");
    failed |= hal_pin_s32_newf(HAL_OUT, &pins->steps, component_id, "trueaxiskins.steps");
    for (int k = 0; k < 3; ++k) {
        failed |= hal_pin_float_newf(HAL_IN, &pins->tool[k], component_id, "trueaxiskins.tool-%s", names[k]);
        failed |= hal_pin_float_newf(
            HAL_OUT, &pins->correction[k], component_id, "trueaxiskins.correction-%s", names[k]);
    }
    return failed;
}

int rtapi_app_main(void)
{
    if (read_coordinates() < 0) {
        return -1;
    }
    component_id = hal_init("trueaxiskins");
    if (component_id < 0) {
        return component_id;
    }
    pins = hal_malloc(sizeof(pin_set));
    if (pins == 0 || export_pins() != 0
        || hal_export_funct("trueaxiskins.update", update, 0, 1, 0, component_id) != 0) {
        hal_exit(component_id);
        return -1;
    }
    *pins->ramp_time = DEFAULT_RAMP;
    return hal_ready(component_id);
}

void rtapi_app_exit(void)
{
    hal_exit(component_id);
}
