/* Generated from machines/dmu60p_5axis.toml, do not edit; regenerate with: trueaxis derive machines/dmu60p_5axis.toml
 * SPDX-License-Identifier: MIT
 * Kernels of DECKEL MAHO DMU60P, all five axes for the cycle of a control, in C17.
 * Spec: sha256 1b0a63b86ea881e06983b884ca7f951aa51e2ebb46ef2eaccf5755fd64d1985f
 *
 * Lengths mm, angles rad, positions of rotary axes deg.
 * Equations after: Prediction and compensation of geometric error for translational axes in multi-axis machine tools
 */
#include "control.h"

#include <math.h>

/*
 * Deviation of a tool point in the workpiece frame, exact.
 * Source: Eqs. (1)-(4). Operations: 244 per point, 5 once per call.
 * in positions: 5 values, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 values, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ
 *     EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in point: 3 values, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 values, mm; tool point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void dmu60p_5axis_point_tool_in_workpiece_deviation(
    const double *positions,
    const double *errors,
    const double *parameters,
    const double *point,
    double *deviation)
{
    const double q_Cx = parameters[0];
    const double q_Cy = parameters[1];
    const double q_Cz = parameters[2];
    const double q_Bx = parameters[6];
    const double q_By = parameters[7];
    const double q_Bz = parameters[8];
    const double q_Sx = parameters[9];
    const double q_Sy = parameters[10];
    const double q_Sz = parameters[11];
    const double q_Tx = parameters[12];
    const double q_Ty = parameters[13];
    const double q_Tz = parameters[14];
    const double EX0C = parameters[15];
    const double EY0C = parameters[16];
    const double EA0C = parameters[17];
    const double EB0C = parameters[18];
    const double eps_xy = parameters[19];
    const double eps_yz = parameters[20];
    const double eps_xz = parameters[21];
    const double EX0B = parameters[22];
    const double EZ0B = parameters[23];
    const double EA0B = parameters[24];
    const double EC0B = parameters[25];
    const double w63 = (EA0C*EA0C) + (EB0C*EB0C);
    const double w64 = (1.0/(w63 + 1.0));
    const double b = positions[3];
    const double c = positions[4];
    const double cos_b = cos(0.017453292519943295*b);
    const double sin_b = sin(0.017453292519943295*b);
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
    const double w1 = q_Sx + w0;
    const double w2 = q_Tz + rz;
    const double w3 = q_Sz + w2;
    const double w4 = cos_b*w1 + sin_b*w3;
    const double w5 = q_Bx + w4;
    const double w6 = w5 + x;
    const double w7 = -q_Cx + w6;
    const double w8 = q_Ty + ry;
    const double w9 = q_Sy + w8;
    const double w10 = q_By + w9;
    const double w11 = w10 - y;
    const double w12 = -q_Cy + w11;
    const double w13 = cos_c*w7 + sin_c*w12;
    const double w14 = cos_b*w3 - sin_b*w1;
    const double w15 = q_Bz + w14;
    const double w16 = w15 + z;
    const double w17 = -EAB*w3 + ECB*w1 + EYB;
    const double w18 = w17 + w9;
    const double w19 = EBB*w3 - ECB*w9 + EXB;
    const double w20 = EAB*w9 - EBB*w1 + EZB;
    const double w21 = cos_b*w20 - sin_b*w19;
    const double w22 = EA0B*w18 + EZ0B + w21;
    const double w23 = w15 + w22;
    const double w24 = cos_b*w19 + sin_b*w20;
    const double w25 = -EA0B*(w14 + w21) + EC0B*(w24 + w4) + w17;
    const double w26 = w10 + w25;
    const double w27 = -EC0B*w18 + EX0B + w24;
    const double w28 = EBZ*w23 - ECZ*w26 + EXZ + w27;
    const double w29 = w27 + w5;
    const double w30 = -EAZ*w23 + ECZ*w29 + EYZ + w25;
    const double w31 = EAZ*w26 - EBZ*w29 + EZZ + w22;
    const double w32 = -eps_xz*(w28 + w5) + eps_yz*(w10 + w30) + w31;
    const double w33 = w16 + w32;
    const double w34 = w16 + w31;
    const double w35 = -eps_yz*w34 + w30;
    const double w36 = w10 + w35;
    const double w37 = eps_xz*w34 + w28;
    const double w38 = EBX*w33 - ECX*w36 + EXX + w37;
    const double w39 = w37 + w5;
    const double w40 = -EAX*w33 + ECX*w39 + EYX + w35;
    const double w41 = -eps_xy*(w10 + w40) + w38;
    const double w42 = -EXY + w41;
    const double w43 = eps_xy*(w38 + w6) + w40;
    const double w44 = -EYY + w43;
    const double w45 = w11 + w44;
    const double w46 = EAX*w36 - EBX*w39 + EZX + w32;
    const double w47 = -EZY + w46;
    const double w48 = w16 + w47;
    const double w49 = w42 + w6;
    const double w50 = EAY*w49 + EBY*w45 + ECY*w48;
    const double w51 = (EAY*EAY) + (EBY*EBY) + (ECY*ECY);
    const double w52 = (1.0/(w51 + 1.0));
    const double w53 = w52*(EAY*w50 - EBY*w48 + ECY*w45 + w42 - w51*w6);
    const double w54 = -EX0C + w53;
    const double w55 = w52*(-EAY*w45 + EBY*w49 + ECY*w50 - w16*w51 + w47);
    const double w56 = -q_Cz + w16;
    const double w57 = w55 + w56;
    const double w58 = w54 + w7;
    const double w59 = w52*(EAY*w48 + EBY*w50 - ECY*w49 - w11*w51 + w44);
    const double w60 = -EY0C + w59;
    const double w61 = w12 + w60;
    const double w62 = EA0C*w58 + EB0C*w61;
    const double w65 = w64*(EA0C*w62 - EB0C*w57 + w54 - w63*w7);
    const double w66 = w64*(EA0C*w57 + EB0C*w62 - w12*w63 + w60);
    const double w67 = cos_c*w65 + sin_c*w66;
    const double w68 = -EXC + w67;
    const double w69 = cos_c*w12 - sin_c*w7;
    const double w70 = cos_c*w66 - sin_c*w65;
    const double w71 = -EYC + w70;
    const double w72 = w69 + w71;
    const double w73 = w64*(-EA0C*w61 + EB0C*w58 + w55 - w56*w63);
    const double w74 = -EZC + w73;
    const double w75 = w56 + w74;
    const double w76 = w13 + w68;
    const double w77 = EAC*w76 + EBC*w72 + ECC*w75;
    const double w78 = (EAC*EAC) + (EBC*EBC) + (ECC*ECC);
    const double w79 = (1.0/(w78 + 1.0));
    deviation[0] = w79*(EAC*w77 - EBC*w75 + ECC*w72 - w13*w78 + w68);
    deviation[1] = w79*(EAC*w75 + EBC*w77 - ECC*w76 - w69*w78 + w71);
    deviation[2] = w79*(-EAC*w72 + EBC*w76 + ECC*w77 - w56*w78 + w74);
}

/*
 * Moves of the linear axes that displace the ideal tool point by the given vector.
 * Source: Eqs. (53)-(55), inverse. Operations: 11 per point.
 * in positions: 5 values, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in deviation: 3 values, mm; displacement of the tool point in the workpiece frame (dx dy dz)
 * out moves: 3 values, mm; moves of X Y Z (move_x move_y move_z)
 */
void dmu60p_5axis_point_correction(
    const double *positions,
    const double *deviation,
    double *moves)
{
    const double c = positions[4];
    const double cos_c = cos(0.017453292519943295*c);
    const double sin_c = sin(0.017453292519943295*c);
    const double dx = deviation[0];
    const double dy = deviation[1];
    const double dz = deviation[2];
    moves[0] = cos_c*dx - dy*sin_c;
    moves[1] = -cos_c*dy - dx*sin_c;
    moves[2] = dz;
}

/* Moves of the linear axes that displace the ideal tool point as far as the tool point is off at these positions. */
static void moves_off(const dmu60p_5axis_machine *machine, const double *positions, double *moves)
{
    double errors[30];
    double deviation[3];
    machine->component_errors(machine->curves, positions, errors);
    dmu60p_5axis_point_tool_in_workpiece_deviation(
        positions,
        errors,
        machine->parameters,
        machine->point,
        deviation);
    dmu60p_5axis_point_correction(positions, deviation, moves);
    for (int k = 0; k < 3; ++k) {
        moves[k] *= machine->share;
    }
}

/* The rows of the linear axes. */
static const int linear_rows[3] = { 0, 1, 2 };

int dmu60p_5axis_forward(
    const dmu60p_5axis_machine *machine,
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

int dmu60p_5axis_inverse(
    const dmu60p_5axis_machine *machine,
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
