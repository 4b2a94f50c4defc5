/* Generated from machines/gantry_mill.toml, do not edit; regenerate with: trueaxis derive machines/gantry_mill.toml
 * SPDX-License-Identifier: MIT
 * Kernels of Gantry mill for the cycle of a control, in C17.
 * Spec: sha256 436048e019673a322f57c00f796d232113d4f9b52648375eb9f68dfede1c3920
 *
 * Lengths mm, angles rad.
 * Equations after: Prediction and compensation of geometric error for translational axes in multi-axis machine tools
 */
#include "control.h"

#include <math.h>

/*
 * Deviation of a tool point in the workpiece frame, exact.
 * Source: Eqs. (1)-(4). Operations: 67 per point.
 * in positions: 3 values, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 values, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ
 *     EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0Y EA0Z EB0Z)
 * in point: 3 values, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 values, mm; tool point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void gantry_mill_point_tool_in_workpiece_deviation(
    const double *positions,
    const double *errors,
    const double *parameters,
    const double *point,
    double *deviation)
{
    const double EC0Y = parameters[0];
    const double EA0Z = parameters[1];
    const double EB0Z = parameters[2];
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
    const double w0 = rz + z;
    const double w1 = EAZ*ry - EBZ*rx + EZZ;
    const double w2 = w0 + w1;
    const double w3 = -EAZ*rz + ECZ*rx + EYZ;
    const double w4 = -EA0Z*w2 + w3;
    const double w5 = ry + w4;
    const double w6 = EBZ*rz - ECZ*ry + EXZ;
    const double w7 = EB0Z*w2 + w6;
    const double w8 = rx + w7;
    const double w9 = EA0Z*(ry + w3) - EB0Z*(rx + w6) + w1;
    const double w10 = EAY*w5 - EBY*w8 + EZY + w9;
    const double w11 = w0 + w10;
    const double w12 = ry + y;
    const double w13 = w0 + w9;
    const double w14 = EBY*w13 - ECY*w5 + EXY + w7;
    const double w15 = -EAY*w13 + ECY*w8 + EYY + w4;
    const double w16 = EC0Y*(rx + w14) + w15;
    const double w17 = w12 + w16;
    const double w18 = -EC0Y*(w12 + w15) + w14;
    const double w19 = rx + w18;
    deviation[0] = EBX*w11 - ECX*w17 + EXX + w18;
    deviation[1] = -EAX*w11 + ECX*w19 + EYX + w16;
    deviation[2] = EAX*w17 - EBX*w19 + EZX + w10;
}

/*
 * Moves of the linear axes that displace the ideal tool point by the given vector.
 * Source: Eqs. (53)-(55), inverse. Operations: 0 per point.
 * in positions: 3 values, mm; commanded positions of X Y Z (x y z)
 * in deviation: 3 values, mm; displacement of the tool point in the workpiece frame (dx dy dz)
 * out moves: 3 values, mm; moves of X Y Z (move_x move_y move_z)
 */
void gantry_mill_point_correction(
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
static void moves_off(const gantry_mill_machine *machine, const double *positions, double *moves)
{
    double errors[18];
    double deviation[3];
    machine->component_errors(machine->curves, positions, errors);
    gantry_mill_point_tool_in_workpiece_deviation(
        positions,
        errors,
        machine->parameters,
        machine->point,
        deviation);
    gantry_mill_point_correction(positions, deviation, moves);
    for (int k = 0; k < 3; ++k) {
        moves[k] *= machine->share;
    }
}

/* The rows of the linear axes. */
static const int linear_rows[3] = { 0, 1, 2 };

int gantry_mill_forward(
    const gantry_mill_machine *machine,
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

int gantry_mill_inverse(
    const gantry_mill_machine *machine,
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
