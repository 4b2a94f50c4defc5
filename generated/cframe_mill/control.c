/* Generated from machines/cframe_mill.toml, do not edit; regenerate with: trueaxis derive machines/cframe_mill.toml
 * SPDX-License-Identifier: MIT
 * Kernels of C-frame mill for the cycle of a control, in C17.
 * Spec: sha256 e0bab1439083d465e60d898b33f648fd88b066b0d41217ad88014752dc9315ad
 *
 * Lengths mm, angles rad.
 * Equations after: Prediction and compensation of geometric error for translational axes in multi-axis machine tools
 */
#include "control.h"

#include <math.h>

/*
 * Deviation of a tool point in the workpiece frame, exact.
 * Source: Eqs. (1)-(4). Operations: 135 per point, 3 once per call.
 * in positions: 3 values, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 values, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ
 *     EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0X EA0Z EB0Z)
 * in point: 3 values, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 values, mm; tool point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void cframe_mill_point_tool_in_workpiece_deviation(
    const double *positions,
    const double *errors,
    const double *parameters,
    const double *point,
    double *deviation)
{
    const double EC0X = parameters[0];
    const double EA0Z = parameters[1];
    const double EB0Z = parameters[2];
    const double w22 = (EC0X*EC0X);
    const double w23 = (1.0/(w22 + 1.0));
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
    const double w0 = rx - x;
    const double w1 = EAZ*ry - EBZ*rx + EZZ;
    const double w2 = rz + z;
    const double w3 = w1 + w2;
    const double w4 = EBZ*rz - ECZ*ry + EXZ;
    const double w5 = EB0Z*w3 + w4;
    const double w6 = -EXY + w5;
    const double w7 = ry - y;
    const double w8 = -EAZ*rz + ECZ*rx + EYZ;
    const double w9 = -EA0Z*w3 + w8;
    const double w10 = -EYY + w9;
    const double w11 = w10 + w7;
    const double w12 = EA0Z*(ry + w8) - EB0Z*(rx + w4) + w1;
    const double w13 = -EZY + w12;
    const double w14 = w13 + w2;
    const double w15 = rx + w6;
    const double w16 = EAY*w15 + EBY*w11 + ECY*w14;
    const double w17 = (EAY*EAY) + (EBY*EBY) + (ECY*ECY);
    const double w18 = (1.0/(w17 + 1.0));
    const double w19 = w18*(EAY*w16 - EBY*w14 + ECY*w11 - rx*w17 + w6);
    const double w20 = w18*(EAY*w14 + EBY*w16 - ECY*w15 + w10 - w17*w7);
    const double w21 = w20 + w7;
    const double w24 = w23*(EC0X*w21 - rx*w22 + w19);
    const double w25 = -EXX + w24;
    const double w26 = rx + w19;
    const double w27 = w23*(-EC0X*w26 + w20 - w22*w7);
    const double w28 = -EYX + w27;
    const double w29 = w28 + w7;
    const double w30 = w18*(-EAY*w11 + EBY*w15 + ECY*w16 + w13 - w17*w2);
    const double w31 = w2 + w30;
    const double w32 = EC0X*w31;
    const double w33 = w23*(EC0X*w32 - w2*w22 + w30);
    const double w34 = -EZX + w33;
    const double w35 = w2 + w34;
    const double w36 = w0 + w25;
    const double w37 = EAX*w36 + EBX*w29 + ECX*w35;
    const double w38 = (EAX*EAX) + (EBX*EBX) + (ECX*ECX);
    const double w39 = (1.0/(w38 + 1.0));
    deviation[0] = w39*(EAX*w37 - EBX*w35 + ECX*w29 - w0*w38 + w25);
    deviation[1] = w39*(EAX*w35 + EBX*w37 - ECX*w36 + w28 - w38*w7);
    deviation[2] = w39*(-EAX*w29 + EBX*w36 + ECX*w37 - w2*w38 + w34);
}

/*
 * Moves of the linear axes that displace the ideal tool point by the given vector.
 * Source: Eqs. (53)-(55), inverse. Operations: 2 per point.
 * in positions: 3 values, mm; commanded positions of X Y Z (x y z)
 * in deviation: 3 values, mm; displacement of the tool point in the workpiece frame (dx dy dz)
 * out moves: 3 values, mm; moves of X Y Z (move_x move_y move_z)
 */
void cframe_mill_point_correction(
    const double *positions,
    const double *deviation,
    double *moves)
{
    (void)positions;
    const double dx = deviation[0];
    const double dy = deviation[1];
    const double dz = deviation[2];
    moves[0] = -dx;
    moves[1] = -dy;
    moves[2] = dz;
}

/* Moves of the linear axes that displace the ideal tool point as far as the tool point is off at these positions. */
static void moves_off(const cframe_mill_machine *machine, const double *positions, double *moves)
{
    double errors[18];
    double deviation[3];
    machine->component_errors(machine->curves, positions, errors);
    cframe_mill_point_tool_in_workpiece_deviation(
        positions,
        errors,
        machine->parameters,
        machine->point,
        deviation);
    cframe_mill_point_correction(positions, deviation, moves);
    for (int k = 0; k < 3; ++k) {
        moves[k] *= machine->share;
    }
}

/* The rows of the linear axes. */
static const int linear_rows[3] = { 0, 1, 2 };

int cframe_mill_forward(
    const cframe_mill_machine *machine,
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

int cframe_mill_inverse(
    const cframe_mill_machine *machine,
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
