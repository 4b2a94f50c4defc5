/* Generated from machines/headhead_mill.toml, do not edit; regenerate with: trueaxis derive machines/headhead_mill.toml
 * SPDX-License-Identifier: MIT
 * Kernels of Five-axis gantry mill with a fork head for the cycle of a control, in C17.
 * Spec: sha256 0ad0abbfc8d51366123f481bf464ef2a99342c0dbb5431fe1300b173adc7b15c
 *
 * Lengths mm, angles rad, positions of rotary axes deg.
 * Equations after: Prediction and compensation of geometric error for translational axes in multi-axis machine tools
 */
#include "control.h"

#include <math.h>

/*
 * Deviation of a tool point in the workpiece frame, exact.
 * Source: Eqs. (1)-(4). Operations: 173 per point.
 * in positions: 5 values, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 values, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ
 *     EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 20 values, mm, rad; home positions and location errors (q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z
 *     EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T EZ0T)
 * in point: 3 values, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 values, mm; tool point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void headhead_mill_point_tool_in_workpiece_deviation(
    const double *positions,
    const double *errors,
    const double *parameters,
    const double *point,
    double *deviation)
{
    const double q_Bx = parameters[0];
    const double q_By = parameters[1];
    const double q_Bz = parameters[2];
    const double q_Tx = parameters[3];
    const double q_Ty = parameters[4];
    const double q_Tz = parameters[5];
    const double EC0Y = parameters[6];
    const double EA0Z = parameters[7];
    const double EB0Z = parameters[8];
    const double EX0C = parameters[9];
    const double EY0C = parameters[10];
    const double EA0C = parameters[11];
    const double EB0C = parameters[12];
    const double EX0B = parameters[13];
    const double EZ0B = parameters[14];
    const double EA0B = parameters[15];
    const double EC0B = parameters[16];
    const double EX0T = parameters[17];
    const double EY0T = parameters[18];
    const double EZ0T = parameters[19];
    const double b = positions[3];
    const double c = positions[4];
    const double cos_b = cos(0.017453292519943295*b);
    const double sin_b = sin(0.017453292519943295*b);
    const double cos_c = cos(0.017453292519943295*c);
    const double sin_c = sin(0.017453292519943295*c);
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
    const double EXB = errors[18];
    const double EYB = errors[19];
    const double EZB = errors[20];
    const double EAB = errors[21];
    const double EBB = errors[22];
    const double ECB = errors[23];
    const double EXC = errors[24];
    const double EYC = errors[25];
    const double EZC = errors[26];
    const double EAC = errors[27];
    const double EBC = errors[28];
    const double ECC = errors[29];
    const double rx = point[0];
    const double ry = point[1];
    const double rz = point[2];
    const double w0 = q_Tx + rx;
    const double w1 = q_Tz + rz;
    const double w2 = cos_b*w1 - sin_b*w0;
    const double w3 = q_Bz + w2;
    const double w4 = w3 + z;
    const double w5 = cos_b*w0 + sin_b*w1;
    const double w6 = q_Bx + w5;
    const double w7 = q_Ty + ry;
    const double w8 = q_By + w7;
    const double w9 = cos_c*w8 + sin_c*w6;
    const double w10 = EZ0T + w1;
    const double w11 = EX0T + w0;
    const double w12 = -EAB*w10 + ECB*w11 + EY0T + EYB;
    const double w13 = EY0T + w7;
    const double w14 = EBB*w10 - ECB*w13 + EX0T + EXB;
    const double w15 = EAB*w13 - EBB*w11 + EZ0T + EZB;
    const double w16 = cos_b*w14 + sin_b*w15;
    const double w17 = cos_b*w15 - sin_b*w14;
    const double w18 = -EA0B*(w17 + w2) + EC0B*(w16 + w5) + w12;
    const double w19 = w18 + w8;
    const double w20 = w12 + w7;
    const double w21 = -EC0B*w20 + EX0B + w16;
    const double w22 = w21 + w6;
    const double w23 = EA0B*w20 + EZ0B + w17;
    const double w24 = EAC*w19 - EBC*w22 + EZC + w23;
    const double w25 = w24 + w3;
    const double w26 = w23 + w3;
    const double w27 = EBC*w26 - ECC*w19 + EXC + w21;
    const double w28 = -EAC*w26 + ECC*w22 + EYC + w18;
    const double w29 = cos_c*w28 + sin_c*w27;
    const double w30 = -EA0C*w25 + EY0C + w29;
    const double w31 = w30 + w9;
    const double w32 = cos_c*w6 - sin_c*w8;
    const double w33 = cos_c*w27 - sin_c*w28;
    const double w34 = EB0C*w25 + EX0C + w33;
    const double w35 = w32 + w34;
    const double w36 = EA0C*(w29 + w9) - EB0C*(w32 + w33) + w24;
    const double w37 = EAZ*w31 - EBZ*w35 + EZZ + w36;
    const double w38 = w37 + w4;
    const double w39 = w3 + w36;
    const double w40 = -EAZ*w39 + ECZ*w35 + EYZ + w30;
    const double w41 = -EA0Z*w38 + w40;
    const double w42 = w41 + w9;
    const double w43 = EBZ*w39 - ECZ*w31 + EXZ + w34;
    const double w44 = EB0Z*w38 + w43;
    const double w45 = w32 + w44;
    const double w46 = EA0Z*(w40 + w9) - EB0Z*(w32 + w43) + w37;
    const double w47 = EAY*w42 - EBY*w45 + EZY + w46;
    const double w48 = w4 + w47;
    const double w49 = w9 + y;
    const double w50 = w4 + w46;
    const double w51 = EBY*w50 - ECY*w42 + EXY + w44;
    const double w52 = -EAY*w50 + ECY*w45 + EYY + w41;
    const double w53 = EC0Y*(w32 + w51) + w52;
    const double w54 = w49 + w53;
    const double w55 = -EC0Y*(w49 + w52) + w51;
    const double w56 = w32 + w55;
    deviation[0] = EBX*w48 - ECX*w54 + EXX + w55;
    deviation[1] = -EAX*w48 + ECX*w56 + EYX + w53;
    deviation[2] = EAX*w54 - EBX*w56 + EZX + w47;
}

/*
 * Moves of the linear axes that displace the ideal tool point by the given vector.
 * Source: Eqs. (53)-(55), inverse. Operations: 0 per point.
 * in positions: 5 values, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in deviation: 3 values, mm; displacement of the tool point in the workpiece frame (dx dy dz)
 * out moves: 3 values, mm; moves of X Y Z (move_x move_y move_z)
 */
void headhead_mill_point_correction(
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
static void moves_off(const headhead_mill_machine *machine, const double *positions, double *moves)
{
    double errors[30];
    double deviation[3];
    machine->component_errors(machine->curves, positions, errors);
    headhead_mill_point_tool_in_workpiece_deviation(
        positions,
        errors,
        machine->parameters,
        machine->point,
        deviation);
    headhead_mill_point_correction(positions, deviation, moves);
    for (int k = 0; k < 3; ++k) {
        moves[k] *= machine->share;
    }
}

/* The rows of the linear axes. */
static const int linear_rows[3] = { 0, 1, 2 };

int headhead_mill_forward(
    const headhead_mill_machine *machine,
    const double *positions,
    double *pose)
{
    int finite = 1;
    double moves[3];
    moves_off(machine, positions, moves);
    for (int row = 0; row < 5; ++row) {
        pose[row] = positions[row];
    }
    for (int k = 0; k < 3; ++k) {
        pose[linear_rows[k]] += moves[k];
    }
    for (int row = 0; row < 5; ++row) {
        finite = finite && isfinite(pose[row]);
    }
    return finite ? 0 : -1;
}

int headhead_mill_inverse(
    const headhead_mill_machine *machine,
    const double *pose,
    double tolerance,
    int most_steps,
    double *positions)
{
    for (int row = 0; row < 5; ++row) {
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
