/* Generated from machines/trunnion_mill.toml, do not edit; regenerate with: trueaxis derive machines/trunnion_mill.toml
 * SPDX-License-Identifier: MIT
 * Kernels of Five-axis mill with a trunnion table for the cycle of a control, in C17.
 * Spec: sha256 fff68e3a25ed33ff02fbf9ab6e0875735d9de644fc7b3d9d269b461961e2d9f2
 *
 * Lengths mm, angles rad, positions of rotary axes deg.
 * Equations after: Prediction and compensation of geometric error for translational axes in multi-axis machine tools
 */
#include "control.h"

#include <math.h>

/*
 * Deviation of a tool point in the workpiece frame, exact.
 * Source: Eqs. (1)-(4). Operations: 297 per point, 13 once per call.
 * in positions: 5 values, mm, rotary axes deg; commanded positions of X Y Z A C (x y z a c)
 * in errors: 30 values, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ
 *     EYZ EZZ EAZ EBZ ECZ EXA EYA EZA EAA EBA ECA EXC EYC EZC EAC EBC ECC)
 * in parameters: 23 values, mm, rad; home positions and location errors (q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz
 *     q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C EA0C EB0C EA0Z EB0Z)
 * in point: 3 values, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 values, mm; tool point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void trunnion_mill_point_tool_in_workpiece_deviation(
    const double *positions,
    const double *errors,
    const double *parameters,
    const double *point,
    double *deviation)
{
    const double q_Ax = parameters[0];
    const double q_Ay = parameters[1];
    const double q_Az = parameters[2];
    const double q_Cx = parameters[3];
    const double q_Cy = parameters[4];
    const double q_Cz = parameters[5];
    const double q_Tx = parameters[9];
    const double q_Ty = parameters[10];
    const double q_Tz = parameters[11];
    const double EC0Y = parameters[12];
    const double EY0A = parameters[13];
    const double EZ0A = parameters[14];
    const double EB0A = parameters[15];
    const double EC0A = parameters[16];
    const double EX0C = parameters[17];
    const double EY0C = parameters[18];
    const double EA0C = parameters[19];
    const double EB0C = parameters[20];
    const double EA0Z = parameters[21];
    const double EB0Z = parameters[22];
    const double w26 = (EC0Y*EC0Y);
    const double w27 = (1.0/(w26 + 1.0));
    const double w51 = (EB0A*EB0A) + (EC0A*EC0A);
    const double w52 = (1.0/(w51 + 1.0));
    const double w80 = (EA0C*EA0C) + (EB0C*EB0C);
    const double w81 = (1.0/(w80 + 1.0));
    const double a = positions[3];
    const double c = positions[4];
    const double cos_a = cos(0.017453292519943295*a);
    const double sin_a = sin(0.017453292519943295*a);
    const double cos_c = cos(0.017453292519943295*c);
    const double sin_c = sin(0.017453292519943295*c);
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
    const double EXA = errors[18];
    const double EYA = errors[19];
    const double EZA = errors[20];
    const double EAA = errors[21];
    const double EBA = errors[22];
    const double ECA = errors[23];
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
    const double w1 = w0 + x;
    const double w2 = -q_Ax + w1;
    const double w3 = -q_Cx + w2;
    const double w4 = q_Ty + ry;
    const double w5 = w4 - y;
    const double w6 = -q_Ay + w5;
    const double w7 = q_Tz + rz;
    const double w8 = w7 + z;
    const double w9 = -q_Az + w8;
    const double w10 = cos_a*w6 + sin_a*w9;
    const double w11 = -q_Cy + w10;
    const double w12 = cos_c*w3 + sin_c*w11;
    const double w13 = EBZ*w7 - ECZ*w4 + EXZ;
    const double w14 = -EAZ*w7 + ECZ*w0 + EYZ;
    const double w15 = EAZ*w4 - EBZ*w0 + EZZ;
    const double w16 = EA0Z*(w14 + w4) - EB0Z*(w0 + w13) + w15;
    const double w17 = w16 + w8;
    const double w18 = w15 + w8;
    const double w19 = -EA0Z*w18 + w14;
    const double w20 = w19 + w4;
    const double w21 = EB0Z*w18 + w13;
    const double w22 = EBX*w17 - ECX*w20 + EXX + w21;
    const double w23 = w0 + w21;
    const double w24 = -EAX*w17 + ECX*w23 + EYX + w19;
    const double w25 = w24 + w4;
    const double w28 = w27*(EC0Y*w25 - w1*w26 + w22);
    const double w29 = -EXY + w28;
    const double w30 = w1 + w22;
    const double w31 = w27*(-EC0Y*w30 + w24 - w26*w4);
    const double w32 = -EYY + w31;
    const double w33 = w32 + w5;
    const double w34 = EAX*w20 - EBX*w23 + EZX + w16;
    const double w35 = w34 + w8;
    const double w36 = EC0Y*w35;
    const double w37 = w27*(EC0Y*w36 - w26*w8 + w34);
    const double w38 = -EZY + w37;
    const double w39 = w38 + w8;
    const double w40 = w1 + w29;
    const double w41 = EAY*w40 + EBY*w33 + ECY*w39;
    const double w42 = (EAY*EAY) + (EBY*EBY) + (ECY*ECY);
    const double w43 = (1.0/(w42 + 1.0));
    const double w44 = w43*(EAY*w41 - EBY*w39 + ECY*w33 - w1*w42 + w29);
    const double w45 = w43*(EAY*w39 + EBY*w41 - ECY*w40 + w32 - w42*w5);
    const double w46 = -EY0A + w45;
    const double w47 = w46 + w6;
    const double w48 = w43*(-EAY*w33 + EBY*w40 + ECY*w41 + w38 - w42*w8);
    const double w49 = -EZ0A + w48;
    const double w50 = w49 + w9;
    const double w53 = w52*(-EB0A*w50 + EC0A*w47 - w2*w51 + w44);
    const double w54 = -EXA + w53;
    const double w55 = w2 + w44;
    const double w56 = EB0A*w47 + EC0A*w50;
    const double w57 = w52*(EB0A*w56 - EC0A*w55 + w46 - w51*w6);
    const double w58 = w52*(EB0A*w55 + EC0A*w56 + w49 - w51*w9);
    const double w59 = cos_a*w57 + sin_a*w58;
    const double w60 = -EYA + w59;
    const double w61 = w10 + w60;
    const double w62 = cos_a*w9 - sin_a*w6;
    const double w63 = cos_a*w58 - sin_a*w57;
    const double w64 = -EZA + w63;
    const double w65 = w62 + w64;
    const double w66 = w2 + w54;
    const double w67 = EAA*w66 + EBA*w61 + ECA*w65;
    const double w68 = (EAA*EAA) + (EBA*EBA) + (ECA*ECA);
    const double w69 = (1.0/(w68 + 1.0));
    const double w70 = w69*(EAA*w67 - EBA*w65 + ECA*w61 - w2*w68 + w54);
    const double w71 = -EX0C + w70;
    const double w72 = w69*(-EAA*w61 + EBA*w66 + ECA*w67 - w62*w68 + w64);
    const double w73 = -q_Cz + w62;
    const double w74 = w72 + w73;
    const double w75 = w3 + w71;
    const double w76 = w69*(EAA*w65 + EBA*w67 - ECA*w66 - w10*w68 + w60);
    const double w77 = -EY0C + w76;
    const double w78 = w11 + w77;
    const double w79 = EA0C*w75 + EB0C*w78;
    const double w82 = w81*(EA0C*w79 - EB0C*w74 - w3*w80 + w71);
    const double w83 = w81*(EA0C*w74 + EB0C*w79 - w11*w80 + w77);
    const double w84 = cos_c*w82 + sin_c*w83;
    const double w85 = -EXC + w84;
    const double w86 = cos_c*w11 - sin_c*w3;
    const double w87 = cos_c*w83 - sin_c*w82;
    const double w88 = -EYC + w87;
    const double w89 = w86 + w88;
    const double w90 = w81*(-EA0C*w78 + EB0C*w75 + w72 - w73*w80);
    const double w91 = -EZC + w90;
    const double w92 = w73 + w91;
    const double w93 = w12 + w85;
    const double w94 = EAC*w93 + EBC*w89 + ECC*w92;
    const double w95 = (EAC*EAC) + (EBC*EBC) + (ECC*ECC);
    const double w96 = (1.0/(w95 + 1.0));
    deviation[0] = w96*(EAC*w94 - EBC*w92 + ECC*w89 - w12*w95 + w85);
    deviation[1] = w96*(EAC*w92 + EBC*w94 - ECC*w93 - w86*w95 + w88);
    deviation[2] = w96*(-EAC*w89 + EBC*w93 + ECC*w94 - w73*w95 + w91);
}

/*
 * Moves of the linear axes that displace the ideal tool point by the given vector.
 * Source: Eqs. (53)-(55), inverse. Operations: 23 per point.
 * in positions: 5 values, mm, rotary axes deg; commanded positions of X Y Z A C (x y z a c)
 * in deviation: 3 values, mm; displacement of the tool point in the workpiece frame (dx dy dz)
 * out moves: 3 values, mm; moves of X Y Z (move_x move_y move_z)
 */
void trunnion_mill_point_correction(
    const double *positions,
    const double *deviation,
    double *moves)
{
    const double a = positions[3];
    const double c = positions[4];
    const double cos_a = cos(0.017453292519943295*a);
    const double sin_a = sin(0.017453292519943295*a);
    const double cos_c = cos(0.017453292519943295*c);
    const double sin_c = sin(0.017453292519943295*c);
    const double dx = deviation[0];
    const double dy = deviation[1];
    const double dz = deviation[2];
    const double w0 = cos_c*dy;
    const double w1 = dx*sin_c;
    moves[0] = cos_c*dx - dy*sin_c;
    moves[1] = -cos_a*w0 - cos_a*w1 + dz*sin_a;
    moves[2] = cos_a*dz + sin_a*w0 + sin_a*w1;
}

/* Moves of the linear axes that displace the ideal tool point as far as the tool point is off at these positions. */
static void moves_off(const trunnion_mill_machine *machine, const double *positions, double *moves)
{
    double errors[30];
    double deviation[3];
    machine->component_errors(machine->curves, positions, errors);
    trunnion_mill_point_tool_in_workpiece_deviation(
        positions,
        errors,
        machine->parameters,
        machine->point,
        deviation);
    trunnion_mill_point_correction(positions, deviation, moves);
    for (int k = 0; k < 3; ++k) {
        moves[k] *= machine->share;
    }
}

/* The rows of the linear axes. */
static const int linear_rows[3] = { 0, 1, 2 };

int trunnion_mill_forward(
    const trunnion_mill_machine *machine,
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

int trunnion_mill_inverse(
    const trunnion_mill_machine *machine,
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
