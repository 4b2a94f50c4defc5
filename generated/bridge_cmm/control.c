/* Generated from machines/bridge_cmm.toml, do not edit; regenerate with: trueaxis derive machines/bridge_cmm.toml
 * SPDX-License-Identifier: MIT
 * Kernels of Bridge coordinate measuring machine for the cycle of a control, in C17.
 * Spec: sha256 316443eb7e27d6b078d5a40b3776dd9c4bae13a4f2e33b47e425a6d867458069
 *
 * Lengths mm, angles rad.
 * Equations after: Prediction and compensation of geometric error for translational axes in multi-axis machine tools
 */
#include "control.h"

#include <math.h>

/*
 * Deviation of a tool point in the workpiece frame, exact.
 * Source: Eqs. (1)-(4). Operations: 70 per point.
 * in positions: 3 values, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 values, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ
 *     EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 6 values, mm, rad; home positions and location errors (q_Px q_Py q_Pz EC0X EA0Z EB0Z)
 * in point: 3 values, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 values, mm; tool point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void bridge_cmm_point_tool_in_workpiece_deviation(
    const double *positions,
    const double *errors,
    const double *parameters,
    const double *point,
    double *deviation)
{
    const double q_Px = parameters[0];
    const double q_Py = parameters[1];
    const double q_Pz = parameters[2];
    const double EC0X = parameters[3];
    const double EA0Z = parameters[4];
    const double EB0Z = parameters[5];
    const double x = positions[0];
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
    const double w0 = q_Pz + rz;
    const double w1 = w0 + z;
    const double w2 = q_Py + ry;
    const double w3 = q_Px + rx;
    const double w4 = EAZ*w2 - EBZ*w3 + EZZ;
    const double w5 = w1 + w4;
    const double w6 = -EAZ*w0 + ECZ*w3 + EYZ;
    const double w7 = -EA0Z*w5 + w6;
    const double w8 = w2 + w7;
    const double w9 = EBZ*w0 - ECZ*w2 + EXZ;
    const double w10 = EB0Z*w5 + w9;
    const double w11 = w10 + w3;
    const double w12 = EA0Z*(w2 + w6) - EB0Z*(w3 + w9) + w4;
    const double w13 = EAX*w8 - EBX*w11 + EZX + w12;
    const double w14 = w1 + w13;
    const double w15 = w1 + w12;
    const double w16 = EBX*w15 - ECX*w8 + EXX + w10;
    const double w17 = -EAX*w15 + ECX*w11 + EYX + w7;
    const double w18 = w3 + x;
    const double w19 = EC0X*(w16 + w18) + w17;
    const double w20 = w19 + w2;
    const double w21 = -EC0X*(w17 + w2) + w16;
    const double w22 = w18 + w21;
    deviation[0] = EBY*w14 - ECY*w20 + EXY + w21;
    deviation[1] = -EAY*w14 + ECY*w22 + EYY + w19;
    deviation[2] = EAY*w20 - EBY*w22 + EZY + w13;
}

/*
 * Moves of the linear axes that displace the ideal tool point by the given vector.
 * Source: Eqs. (53)-(55), inverse. Operations: 0 per point.
 * in positions: 3 values, mm; commanded positions of X Y Z (x y z)
 * in deviation: 3 values, mm; displacement of the tool point in the workpiece frame (dx dy dz)
 * out moves: 3 values, mm; moves of X Y Z (move_x move_y move_z)
 */
void bridge_cmm_point_correction(
    const double *positions,
    const double *deviation,
    double *moves)
{
    (void)positions;
    const double dx = deviation[0];
    const double dy = deviation[1];
    const double dz = deviation[2];
    moves[0] = dx;
    moves[1] = dy;
    moves[2] = dz;
}

/* Moves of the linear axes that displace the ideal tool point as far as the tool point is off at these positions. */
static void moves_off(const bridge_cmm_machine *machine, const double *positions, double *moves)
{
    double errors[18];
    double deviation[3];
    machine->component_errors(machine->curves, positions, errors);
    bridge_cmm_point_tool_in_workpiece_deviation(
        positions,
        errors,
        machine->parameters,
        machine->point,
        deviation);
    bridge_cmm_point_correction(positions, deviation, moves);
    for (int k = 0; k < 3; ++k) {
        moves[k] *= machine->share;
    }
}

/* The rows of the linear axes. */
static const int linear_rows[3] = { 0, 1, 2 };

int bridge_cmm_forward(
    const bridge_cmm_machine *machine,
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

int bridge_cmm_inverse(
    const bridge_cmm_machine *machine,
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
