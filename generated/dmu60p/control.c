/* Generated from machines/dmu60p.toml, do not edit; regenerate with: trueaxis derive machines/dmu60p.toml
 * SPDX-License-Identifier: MIT
 * Kernels of DECKEL MAHO DMU60P, translational axes for the cycle of a control, in C17.
 * Spec: sha256 0190651706d05e74f47ba63b348c7b25aa718138f26d87af62dcbb754cacd8ee
 *
 * Lengths mm, angles rad.
 * Equations after: Prediction and compensation of geometric error for translational axes in multi-axis machine tools
 */
#include "control.h"

#include <math.h>

/*
 * Deviation of a tool point in the workpiece frame, exact.
 * Source: Eqs. (1)-(4). Operations: 98 per point.
 * in positions: 3 values, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 values, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ
 *     EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 9 values, mm, rad; home positions and location errors (q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz
 *     eps_xz)
 * in point: 3 values, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 values, mm; tool point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void dmu60p_point_tool_in_workpiece_deviation(
    const double *positions,
    const double *errors,
    const double *parameters,
    const double *point,
    double *deviation)
{
    const double q_Tx = parameters[3];
    const double q_Ty = parameters[4];
    const double q_Tz = parameters[5];
    const double eps_xy = parameters[6];
    const double eps_yz = parameters[7];
    const double eps_xz = parameters[8];
    const double x = positions[0];
    const double y = positions[1];
    const double z = positions[2];
    const double EXX = errors[0];
    const double EYX = errors[1];
    const double EZX = errors[2];
    const double EAX = errors[3];
    const double EBX = errors[4];
    const double ECX = errors[5];
    const double EXY = errors[6];
    const double EYY = errors[7];
    const double EZY = errors[8];
    const double EAY = errors[9];
    const double EBY = errors[10];
    const double ECY = errors[11];
    const double EXZ = errors[12];
    const double EYZ = errors[13];
    const double EZZ = errors[14];
    const double EAZ = errors[15];
    const double EBZ = errors[16];
    const double ECZ = errors[17];
    const double rx = point[0];
    const double ry = point[1];
    const double rz = point[2];
    const double w0 = q_Tx + rx;
    const double w1 = w0 + x;
    const double w2 = q_Ty + ry;
    const double w3 = q_Tz + rz;
    const double w4 = w3 + z;
    const double w5 = EBZ*w3 - ECZ*w2 + EXZ;
    const double w6 = -EAZ*w3 + ECZ*w0 + EYZ;
    const double w7 = EAZ*w2 - EBZ*w0 + EZZ;
    const double w8 = -eps_xz*(w0 + w5) + eps_yz*(w2 + w6) + w7;
    const double w9 = w4 + w8;
    const double w10 = w4 + w7;
    const double w11 = -eps_yz*w10 + w6;
    const double w12 = w11 + w2;
    const double w13 = eps_xz*w10 + w5;
    const double w14 = EBX*w9 - ECX*w12 + EXX + w13;
    const double w15 = w0 + w13;
    const double w16 = -EAX*w9 + ECX*w15 + EYX + w11;
    const double w17 = -eps_xy*(w16 + w2) + w14;
    const double w18 = -EXY + w17;
    const double w19 = w2 - y;
    const double w20 = eps_xy*(w1 + w14) + w16;
    const double w21 = -EYY + w20;
    const double w22 = w19 + w21;
    const double w23 = EAX*w12 - EBX*w15 + EZX + w8;
    const double w24 = -EZY + w23;
    const double w25 = w24 + w4;
    const double w26 = w1 + w18;
    const double w27 = EAY*w26 + EBY*w22 + ECY*w25;
    const double w28 = (EAY*EAY) + (EBY*EBY) + (ECY*ECY);
    const double w29 = (1.0/(w28 + 1.0));
    deviation[0] = w29*(EAY*w27 - EBY*w25 + ECY*w22 - w1*w28 + w18);
    deviation[1] = w29*(EAY*w25 + EBY*w27 - ECY*w26 - w19*w28 + w21);
    deviation[2] = w29*(-EAY*w22 + EBY*w26 + ECY*w27 + w24 - w28*w4);
}

/*
 * Moves of the linear axes that displace the ideal tool point by the given vector.
 * Source: Eqs. (53)-(55), inverse. Operations: 1 per point.
 * in positions: 3 values, mm; commanded positions of X Y Z (x y z)
 * in deviation: 3 values, mm; displacement of the tool point in the workpiece frame (dx dy dz)
 * out moves: 3 values, mm; moves of X Y Z (move_x move_y move_z)
 */
void dmu60p_point_correction(
    const double *positions,
    const double *deviation,
    double *moves)
{
    (void)positions;
    const double dx = deviation[0];
    const double dy = deviation[1];
    const double dz = deviation[2];
    moves[0] = dx;
    moves[1] = -dy;
    moves[2] = dz;
}

/* Moves of the linear axes that displace the ideal tool point as far as the tool point is off at these positions. */
static void moves_off(const dmu60p_machine *machine, const double *positions, double *moves)
{
    double errors[18];
    double deviation[3];
    machine->component_errors(machine->curves, positions, errors);
    dmu60p_point_tool_in_workpiece_deviation(
        positions,
        errors,
        machine->parameters,
        machine->point,
        deviation);
    dmu60p_point_correction(positions, deviation, moves);
    for (int k = 0; k < 3; ++k) {
        moves[k] *= machine->share;
    }
}

/* The rows of the linear axes. */
static const int linear_rows[3] = { 0, 1, 2 };

int dmu60p_forward(
    const dmu60p_machine *machine,
    const double *positions,
    double *pose)
{
    int finite = 1;
    double moves[3];
    moves_off(machine, positions, moves);
    for (int row = 0; row < 3; ++row) {
        pose[row] = positions[row];
    }
    for (int k = 0; k < 3; ++k) {
        pose[linear_rows[k]] += moves[k];
    }
    for (int row = 0; row < 3; ++row) {
        finite = finite && isfinite(pose[row]);
    }
    return finite ? 0 : -1;
}

int dmu60p_inverse(
    const dmu60p_machine *machine,
    const double *pose,
    double tolerance,
    int most_steps,
    double *positions)
{
    for (int row = 0; row < 3; ++row) {
        positions[row] = pose[row];
        if (!isfinite(pose[row])) {
            return -1;
        }
    }
    for (int step_number = 1; step_number <= most_steps; ++step_number) {
        int finite = 1;
        double largest = 0.0;
        double moves[3];
        moves_off(machine, positions, moves);
        for (int k = 0; k < 3; ++k) {
            const double next = pose[linear_rows[k]] - moves[k];
            finite = finite && isfinite(next);
            largest = fmax(largest, fabs(next - positions[linear_rows[k]]));
            positions[linear_rows[k]] = next;
        }
        if (!finite) {
            return -1;
        }
        if (largest <= tolerance) {
            return step_number;
        }
    }
    return -1;
}
