/* Generated from machines/trunnion_mill.toml, do not edit; regenerate with: trueaxis derive machines/trunnion_mill.toml
 * SPDX-License-Identifier: MIT
 * Kernels of Five-axis mill with a trunnion table: geometric error model in C17.
 * Spec: sha256 fff68e3a25ed33ff02fbf9ab6e0875735d9de644fc7b3d9d269b461961e2d9f2
 *
 * Row k of an array that has a value per point holds point i at [k * stride + i]; n <= stride points are computed.
 * Arrays must not overlap. Lengths mm, angles rad, positions of rotary axes deg.
 * Equations after: Prediction and compensation of geometric error for translational axes in multi-axis machine tools
 */
#include "kernels.h"

#include <math.h>

/* The rows of an output never overlap, which no type of C can say: points are independent of one another. */
#if defined(__clang__)
#define POINTS_ARE_INDEPENDENT _Pragma("clang loop vectorize(assume_safety)")
#elif defined(__GNUC__)
#define POINTS_ARE_INDEPENDENT _Pragma("GCC ivdep")
#else
#define POINTS_ARE_INDEPENDENT
#endif

/* Points whose cosines and sines are computed ahead of their arithmetic. */
enum { BLOCK = 512 };

int trunnion_mill_kernel_abi(void)
{
    return TRUEAXIS_KERNEL_ABI;
}

const char *trunnion_mill_spec_hash(void)
{
    return "fff68e3a25ed33ff02fbf9ab6e0875735d9de644fc7b3d9d269b461961e2d9f2";
}

/*
 * Ideal position of a tool point in the workpiece frame.
 * Source: Eqs. (1)-(4) without errors. Operations: 90 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z A C (x y z a c)
 * in parameters: 23 values, mm, rad; home positions and location errors (q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz
 *     q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C EA0C EB0C EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out ideal: 3 rows of stride, mm; tool point in the workpiece frame, without errors (px py pz)
 */
void trunnion_mill_tool_in_workpiece_ideal(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT ideal)
{
    /* once per call */
    const double q_Ax = parameters[0];
    const double q_Ay = parameters[1];
    const double q_Az = parameters[2];
    const double q_Cx = parameters[3];
    const double q_Cy = parameters[4];
    const double q_Cz = parameters[5];
    const double q_wx = parameters[6];
    const double q_wy = parameters[7];
    const double q_wz = parameters[8];
    const double q_Tx = parameters[9];
    const double q_Ty = parameters[10];
    const double q_Tz = parameters[11];
    for (size_t start = 0; start < n; start += BLOCK) {
        const size_t count = n - start < BLOCK ? n - start : (size_t)BLOCK;
        /* cosines and sines */
        double cos_a_block[BLOCK];
        double sin_a_block[BLOCK];
        double cos_c_block[BLOCK];
        double sin_c_block[BLOCK];
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double a = positions[3 * stride + i];
            const double c = positions[4 * stride + i];
            cos_a_block[j] = cos(0.017453292519943295*a);
            sin_a_block[j] = sin(0.017453292519943295*a);
            cos_c_block[j] = cos(0.017453292519943295*c);
            sin_c_block[j] = sin(0.017453292519943295*c);
        }
        /* per point */
        POINTS_ARE_INDEPENDENT
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double cos_a = cos_a_block[j];
            const double sin_a = sin_a_block[j];
            const double cos_c = cos_c_block[j];
            const double sin_c = sin_c_block[j];
            const double x = positions[0 * stride + i];
            const double y = positions[1 * stride + i];
            const double z = positions[2 * stride + i];
            const double rx = point[0 * stride + i];
            const double ry = point[1 * stride + i];
            const double rz = point[2 * stride + i];
            const double w0 = cos_a*sin_c;
            const double w1 = sin_a*sin_c;
            const double w2 = cos_a*cos_c;
            ideal[0 * stride + i] = -cos_c*q_Ax - cos_c*q_Cx + cos_c*q_Tx + cos_c*rx + cos_c*x - q_Ay*w0 - q_Az*w1 -
                q_Cy*sin_c + q_Ty*w0 + q_Tz*w1 - q_wx + ry*w0 + rz*w1 - w0*y + w1*z;
            ideal[1 * stride + i] = cos_a*cos_c*q_Ty + cos_a*cos_c*ry - cos_c*q_Az*sin_a - cos_c*q_Cy + cos_c*q_Tz*sin_a
                + cos_c*rz*sin_a + cos_c*sin_a*z + q_Ax*sin_c - q_Ay*w2 + q_Cx*sin_c - q_Tx*sin_c - q_wy - rx*sin_c -
                sin_c*x - w2*y;
            ideal[2 * stride + i] = -cos_a*q_Az + cos_a*q_Tz + cos_a*rz + cos_a*z + q_Ay*sin_a - q_Cz - q_Ty*sin_a -
                q_wz - ry*sin_a + sin_a*y;
        }
    }
}

/*
 * Deviation of a tool point in the workpiece frame, exact.
 * Source: Eqs. (1)-(4). Operations: 297 per point, 13 once per call.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z A C (x y z a c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXA EYA EZA EAA EBA ECA EXC EYC EZC EAC EBC ECC)
 * in parameters: 23 values, mm, rad; home positions and location errors (q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz
 *     q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C EA0C EB0C EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; tool point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void trunnion_mill_tool_in_workpiece_deviation(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation)
{
    /* once per call */
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
    for (size_t start = 0; start < n; start += BLOCK) {
        const size_t count = n - start < BLOCK ? n - start : (size_t)BLOCK;
        /* cosines and sines */
        double cos_a_block[BLOCK];
        double sin_a_block[BLOCK];
        double cos_c_block[BLOCK];
        double sin_c_block[BLOCK];
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double a = positions[3 * stride + i];
            const double c = positions[4 * stride + i];
            cos_a_block[j] = cos(0.017453292519943295*a);
            sin_a_block[j] = sin(0.017453292519943295*a);
            cos_c_block[j] = cos(0.017453292519943295*c);
            sin_c_block[j] = sin(0.017453292519943295*c);
        }
        /* per point */
        POINTS_ARE_INDEPENDENT
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double cos_a = cos_a_block[j];
            const double sin_a = sin_a_block[j];
            const double cos_c = cos_c_block[j];
            const double sin_c = sin_c_block[j];
            const double x = positions[0 * stride + i];
            const double y = positions[1 * stride + i];
            const double z = positions[2 * stride + i];
            const double EXX = errors[0 * stride + i];
            const double EYX = errors[1 * stride + i];
            const double EZX = errors[2 * stride + i];
            const double EAX = errors[3 * stride + i];
            const double EBX = errors[4 * stride + i];
            const double ECX = errors[5 * stride + i];
            const double EXY = errors[6 * stride + i];
            const double EYY = errors[7 * stride + i];
            const double EZY = errors[8 * stride + i];
            const double EAY = errors[9 * stride + i];
            const double EBY = errors[10 * stride + i];
            const double ECY = errors[11 * stride + i];
            const double EXZ = errors[12 * stride + i];
            const double EYZ = errors[13 * stride + i];
            const double EZZ = errors[14 * stride + i];
            const double EAZ = errors[15 * stride + i];
            const double EBZ = errors[16 * stride + i];
            const double ECZ = errors[17 * stride + i];
            const double EXA = errors[18 * stride + i];
            const double EYA = errors[19 * stride + i];
            const double EZA = errors[20 * stride + i];
            const double EAA = errors[21 * stride + i];
            const double EBA = errors[22 * stride + i];
            const double ECA = errors[23 * stride + i];
            const double EXC = errors[24 * stride + i];
            const double EYC = errors[25 * stride + i];
            const double EZC = errors[26 * stride + i];
            const double EAC = errors[27 * stride + i];
            const double EBC = errors[28 * stride + i];
            const double ECC = errors[29 * stride + i];
            const double rx = point[0 * stride + i];
            const double ry = point[1 * stride + i];
            const double rz = point[2 * stride + i];
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
            deviation[0 * stride + i] = w96*(EAC*w94 - EBC*w92 + ECC*w89 - w12*w95 + w85);
            deviation[1 * stride + i] = w96*(EAC*w92 + EBC*w94 - ECC*w93 - w86*w95 + w88);
            deviation[2 * stride + i] = w96*(-EAC*w89 + EBC*w93 + ECC*w94 - w73*w95 + w91);
        }
    }
}

/*
 * Deviation of a tool point in the workpiece frame, to first order in the errors.
 * Source: Eqs. (1)-(4). Operations: 148 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z A C (x y z a c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXA EYA EZA EAA EBA ECA EXC EYC EZC EAC EBC ECC)
 * in parameters: 23 values, mm, rad; home positions and location errors (q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz
 *     q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C EA0C EB0C EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; tool point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void trunnion_mill_tool_in_workpiece_deviation_first_order(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation)
{
    /* once per call */
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
    for (size_t start = 0; start < n; start += BLOCK) {
        const size_t count = n - start < BLOCK ? n - start : (size_t)BLOCK;
        /* cosines and sines */
        double cos_a_block[BLOCK];
        double sin_a_block[BLOCK];
        double cos_c_block[BLOCK];
        double sin_c_block[BLOCK];
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double a = positions[3 * stride + i];
            const double c = positions[4 * stride + i];
            cos_a_block[j] = cos(0.017453292519943295*a);
            sin_a_block[j] = sin(0.017453292519943295*a);
            cos_c_block[j] = cos(0.017453292519943295*c);
            sin_c_block[j] = sin(0.017453292519943295*c);
        }
        /* per point */
        POINTS_ARE_INDEPENDENT
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double cos_a = cos_a_block[j];
            const double sin_a = sin_a_block[j];
            const double cos_c = cos_c_block[j];
            const double sin_c = sin_c_block[j];
            const double x = positions[0 * stride + i];
            const double y = positions[1 * stride + i];
            const double z = positions[2 * stride + i];
            const double EXX = errors[0 * stride + i];
            const double EYX = errors[1 * stride + i];
            const double EZX = errors[2 * stride + i];
            const double EAX = errors[3 * stride + i];
            const double EBX = errors[4 * stride + i];
            const double ECX = errors[5 * stride + i];
            const double EXY = errors[6 * stride + i];
            const double EYY = errors[7 * stride + i];
            const double EZY = errors[8 * stride + i];
            const double EAY = errors[9 * stride + i];
            const double EBY = errors[10 * stride + i];
            const double ECY = errors[11 * stride + i];
            const double EXZ = errors[12 * stride + i];
            const double EYZ = errors[13 * stride + i];
            const double EZZ = errors[14 * stride + i];
            const double EAZ = errors[15 * stride + i];
            const double EBZ = errors[16 * stride + i];
            const double ECZ = errors[17 * stride + i];
            const double EXA = errors[18 * stride + i];
            const double EYA = errors[19 * stride + i];
            const double EZA = errors[20 * stride + i];
            const double EAA = errors[21 * stride + i];
            const double EBA = errors[22 * stride + i];
            const double ECA = errors[23 * stride + i];
            const double EXC = errors[24 * stride + i];
            const double EYC = errors[25 * stride + i];
            const double EZC = errors[26 * stride + i];
            const double EAC = errors[27 * stride + i];
            const double EBC = errors[28 * stride + i];
            const double ECC = errors[29 * stride + i];
            const double rx = point[0 * stride + i];
            const double ry = point[1 * stride + i];
            const double rz = point[2 * stride + i];
            const double w0 = q_Ty + ry;
            const double w1 = w0 - y;
            const double w2 = -q_Ay + w1;
            const double w3 = q_Tz + rz;
            const double w4 = w3 + z;
            const double w5 = -q_Az + w4;
            const double w6 = cos_a*w5 - sin_a*w2;
            const double w7 = -q_Cz + w6;
            const double w8 = q_Tx + rx;
            const double w9 = w8 + x;
            const double w10 = -q_Ax + w9;
            const double w11 = -q_Cx + w10;
            const double w12 = cos_a*w2 + sin_a*w5;
            const double w13 = -q_Cy + w12;
            const double w14 = cos_c*w13 - sin_c*w11;
            const double w15 = EBZ*w3 - ECZ*w0 + EXZ;
            const double w16 = EB0Z*w4 + w15;
            const double w17 = EBX*w4 - ECX*w0 + EXX + w16;
            const double w18 = EC0Y*w0 + w17;
            const double w19 = -EBY*w4 + ECY*w1 - EXY + w18;
            const double w20 = -EB0A*w5 + EC0A*w2 + w19;
            const double w21 = -EBA*w6 + ECA*w12 - EXA + w20;
            const double w22 = -EB0C*w7 - EX0C + w21;
            const double w23 = -EAZ*w3 + ECZ*w8 + EYZ;
            const double w24 = -EA0Z*w4 + w23;
            const double w25 = -EAX*w4 + ECX*w8 + EYX + w24;
            const double w26 = -EC0Y*w9 + w25;
            const double w27 = EAY*w4 - ECY*w9 - EYY + w26;
            const double w28 = -EC0A*w10 - EY0A + w27;
            const double w29 = EAZ*w0 - EBZ*w8 + EZZ;
            const double w30 = EA0Z*w0 - EB0Z*w8 + w29;
            const double w31 = EAX*w0 - EBX*w8 + EZX + w30;
            const double w32 = -EAY*w1 + EBY*w9 - EZY + w31;
            const double w33 = EB0A*w10 - EZ0A + w32;
            const double w34 = cos_a*w28 + sin_a*w33;
            const double w35 = EAA*w6 - ECA*w10 - EYA + w34;
            const double w36 = EA0C*w7 - EY0C + w35;
            const double w37 = cos_c*w22 + sin_c*w36;
            const double w38 = cos_c*w11 + sin_c*w13;
            const double w39 = cos_c*w36 - sin_c*w22;
            const double w40 = cos_a*w33 - sin_a*w28;
            const double w41 = -EAA*w12 + EBA*w10 - EZA + w40;
            const double w42 = -EA0C*w13 + EB0C*w11 + w41;
            deviation[0 * stride + i] = -EBC*w7 + ECC*w14 - EXC + w37;
            deviation[1 * stride + i] = EAC*w7 - ECC*w38 - EYC + w39;
            deviation[2 * stride + i] = -EAC*w14 + EBC*w38 - EZC + w42;
        }
    }
}

/*
 * Sensitivity of a tool point in the workpiece frame to every error, at the error-free machine.
 * Source: Eqs. (1)-(4), first order. Operations: 261 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z A C (x y z a c)
 * in parameters: 23 values, mm, rad; home positions and location errors (q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz
 *     q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C EA0C EB0C EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out sensitivity: 123 rows of stride, mm/mm, mm/rad; derivative of the deviation by each component error, then by
 *     each location error (dx_EXX dx_EYX .. dz_EB0Z, last index fastest)
 */
void trunnion_mill_tool_in_workpiece_sensitivity(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT sensitivity)
{
    /* once per call */
    const double q_Ax = parameters[0];
    const double q_Ay = parameters[1];
    const double q_Az = parameters[2];
    const double q_Cx = parameters[3];
    const double q_Cy = parameters[4];
    const double q_Cz = parameters[5];
    const double q_Tx = parameters[9];
    const double q_Ty = parameters[10];
    const double q_Tz = parameters[11];
    for (size_t start = 0; start < n; start += BLOCK) {
        const size_t count = n - start < BLOCK ? n - start : (size_t)BLOCK;
        /* cosines and sines */
        double cos_a_block[BLOCK];
        double sin_a_block[BLOCK];
        double cos_c_block[BLOCK];
        double sin_c_block[BLOCK];
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double a = positions[3 * stride + i];
            const double c = positions[4 * stride + i];
            cos_a_block[j] = cos(0.017453292519943295*a);
            sin_a_block[j] = sin(0.017453292519943295*a);
            cos_c_block[j] = cos(0.017453292519943295*c);
            sin_c_block[j] = sin(0.017453292519943295*c);
        }
        /* per point */
        POINTS_ARE_INDEPENDENT
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double cos_a = cos_a_block[j];
            const double sin_a = sin_a_block[j];
            const double cos_c = cos_c_block[j];
            const double sin_c = sin_c_block[j];
            const double x = positions[0 * stride + i];
            const double y = positions[1 * stride + i];
            const double z = positions[2 * stride + i];
            const double rx = point[0 * stride + i];
            const double ry = point[1 * stride + i];
            const double rz = point[2 * stride + i];
            const double dx_EYX = cos_a*sin_c;
            const double dx_EZX = sin_a*sin_c;
            const double w0 = dx_EYX*q_Tz + dx_EYX*rz - dx_EZX*q_Ty - dx_EZX*ry;
            const double w1 = dx_EYX*z + w0;
            const double dx_EAX = -w1;
            const double w2 = cos_c*q_Tz;
            const double w3 = cos_c*rz;
            const double w4 = dx_EZX*q_Tx;
            const double w5 = dx_EZX*rx;
            const double dx_EBZ = w2 + w3 - w4 - w5;
            const double w6 = cos_c*z;
            const double dx_EBX = dx_EBZ + w6;
            const double w7 = cos_c*q_Ty;
            const double w8 = cos_c*ry;
            const double dx_ECX = dx_EYX*q_Tx + dx_EYX*rx - w7 - w8;
            const double dx_EXY = -cos_c;
            const double dx_EYY = -dx_EYX;
            const double dx_EZY = -dx_EZX;
            const double dx_EAY = dx_EZX*y + w1;
            const double dx_EYA = -sin_c;
            const double dx_EAA = dx_EAY - dx_EYX*q_Az + dx_EZX*q_Ay;
            const double w9 = cos_c*y;
            const double w10 = cos_a*w2 + cos_a*w3 - sin_a*w7 - sin_a*w8;
            const double w11 = cos_a*w6 + w10;
            const double dy_EAY = sin_a*w9 + w11;
            const double w12 = q_Ay*sin_a;
            const double dy_EAA = -cos_a*cos_c*q_Az + cos_c*w12 + dy_EAY;
            const double dy_EAC = -cos_a*q_Az + cos_a*q_Tz + cos_a*rz + cos_a*z - q_Cz - q_Ty*sin_a - ry*sin_a + sin_a*y
                + w12;
            const double w13 = cos_c*q_Ay;
            const double w14 = cos_c*q_Az;
            const double w15 = -cos_a*cos_c*q_Ty - cos_a*cos_c*ry + cos_a*w13 + cos_a*w9 - cos_c*q_Tz*sin_a -
                cos_c*rz*sin_a - cos_c*sin_a*z - q_Ax*sin_c + q_Tx*sin_c + rx*sin_c + sin_a*w14 + sin_c*x;
            const double dz_EAC = cos_c*q_Cy - q_Cx*sin_c + w15;
            const double dx_EA0C = dx_EAA - q_Cz*sin_c;
            const double dy_EA0C = -cos_c*q_Cz + dy_EAA;
            const double dy_EYX = cos_a*cos_c;
            const double dy_EZX = cos_c*sin_a;
            const double dy_EAX = -w11;
            const double w16 = dy_EZX*q_Tx + dy_EZX*rx + q_Tz*sin_c + rz*sin_c;
            const double w17 = sin_c*z + w16;
            const double dy_EBX = -w17;
            const double dy_ECX = dy_EYX*q_Tx + dy_EYX*rx + q_Ty*sin_c + ry*sin_c;
            const double dy_EYY = -dy_EYX;
            const double dy_EZY = -dy_EZX;
            const double dy_EBY = dy_EZX*x + w17;
            const double w18 = -cos_a*q_Ay*sin_c - cos_a*sin_c*y - cos_c*q_Ax + cos_c*q_Tx + cos_c*rx + cos_c*x +
                dx_EYX*q_Ty + dx_EYX*ry + dx_EZX*q_Tz + dx_EZX*rz + dx_EZX*z - q_Az*sin_a*sin_c;
            const double dz_EBC = -cos_c*q_Cx - q_Cy*sin_c + w18;
            const double dz_EYX = -sin_a;
            const double dz_EAZ = cos_a*q_Ty + cos_a*ry + q_Tz*sin_a + rz*sin_a;
            const double dz_EAX = dz_EAZ + sin_a*z;
            const double w19 = cos_a*q_Tx + cos_a*rx;
            const double dz_EBX = -w19;
            const double w20 = q_Tx*sin_a + rx*sin_a;
            const double dz_ECX = -w20;
            const double dz_EZY = -cos_a;
            const double dz_EBY = cos_a*x + w19;
            const double dz_ECY = sin_a*x + w20;
            const double dz_EBA = -q_Ax + q_Tx + rx + x;
            const double w21 = dx_ECX + dx_EYX*x;
            const double w22 = w21 + w9;
            const double w23 = dy_ECX + dy_EYX*x;
            const double w24 = -sin_c*y + w23;
            const double w25 = -cos_a*y + dz_EAX;
            const double w26 = -cos_a*q_Ay - q_Az*sin_a + w25;
            sensitivity[0 * stride + i] = cos_c;
            sensitivity[1 * stride + i] = dx_EYX;
            sensitivity[2 * stride + i] = dx_EZX;
            sensitivity[3 * stride + i] = dx_EAX;
            sensitivity[4 * stride + i] = dx_EBX;
            sensitivity[5 * stride + i] = dx_ECX;
            sensitivity[6 * stride + i] = dx_EXY;
            sensitivity[7 * stride + i] = dx_EYY;
            sensitivity[8 * stride + i] = dx_EZY;
            sensitivity[9 * stride + i] = dx_EAY;
            sensitivity[10 * stride + i] = -dx_EBX + sin_a*sin_c*x;
            sensitivity[11 * stride + i] = -w22;
            sensitivity[12 * stride + i] = cos_c;
            sensitivity[13 * stride + i] = dx_EYX;
            sensitivity[14 * stride + i] = dx_EZX;
            sensitivity[15 * stride + i] = -w0;
            sensitivity[16 * stride + i] = dx_EBZ;
            sensitivity[17 * stride + i] = dx_ECX;
            sensitivity[18 * stride + i] = dx_EXY;
            sensitivity[19 * stride + i] = dx_EYA;
            sensitivity[20 * stride + i] = 0.0;
            sensitivity[21 * stride + i] = dx_EAA;
            sensitivity[22 * stride + i] = -dy_EAA;
            sensitivity[23 * stride + i] = -w15;
            sensitivity[24 * stride + i] = -1.0;
            sensitivity[25 * stride + i] = 0.0;
            sensitivity[26 * stride + i] = 0.0;
            sensitivity[27 * stride + i] = 0.0;
            sensitivity[28 * stride + i] = -dy_EAC;
            sensitivity[29 * stride + i] = -dz_EAC;
            sensitivity[30 * stride + i] = -w21;
            sensitivity[31 * stride + i] = dx_EYY;
            sensitivity[32 * stride + i] = dx_EZY;
            sensitivity[33 * stride + i] = -dx_EZX*q_Ax + dx_EZX*x + w14 - w2 - w3 + w4 + w5 - w6;
            sensitivity[34 * stride + i] = cos_a*q_Ax*sin_c - w13 - w22;
            sensitivity[35 * stride + i] = dx_EXY;
            sensitivity[36 * stride + i] = dx_EYA;
            sensitivity[37 * stride + i] = dx_EA0C;
            sensitivity[38 * stride + i] = -dy_EA0C;
            sensitivity[39 * stride + i] = dx_EAX;
            sensitivity[40 * stride + i] = dx_EBX;
            sensitivity[41 * stride + i] = dx_EYA;
            sensitivity[42 * stride + i] = dy_EYX;
            sensitivity[43 * stride + i] = dy_EZX;
            sensitivity[44 * stride + i] = dy_EAX;
            sensitivity[45 * stride + i] = dy_EBX;
            sensitivity[46 * stride + i] = dy_ECX;
            sensitivity[47 * stride + i] = sin_c;
            sensitivity[48 * stride + i] = dy_EYY;
            sensitivity[49 * stride + i] = dy_EZY;
            sensitivity[50 * stride + i] = dy_EAY;
            sensitivity[51 * stride + i] = dy_EBY;
            sensitivity[52 * stride + i] = -w24;
            sensitivity[53 * stride + i] = dx_EYA;
            sensitivity[54 * stride + i] = dy_EYX;
            sensitivity[55 * stride + i] = dy_EZX;
            sensitivity[56 * stride + i] = -w10;
            sensitivity[57 * stride + i] = -w16;
            sensitivity[58 * stride + i] = dy_ECX;
            sensitivity[59 * stride + i] = sin_c;
            sensitivity[60 * stride + i] = dx_EXY;
            sensitivity[61 * stride + i] = 0.0;
            sensitivity[62 * stride + i] = dy_EAA;
            sensitivity[63 * stride + i] = dx_EAA;
            sensitivity[64 * stride + i] = -w18;
            sensitivity[65 * stride + i] = 0.0;
            sensitivity[66 * stride + i] = -1.0;
            sensitivity[67 * stride + i] = 0.0;
            sensitivity[68 * stride + i] = dy_EAC;
            sensitivity[69 * stride + i] = 0.0;
            sensitivity[70 * stride + i] = -dz_EBC;
            sensitivity[71 * stride + i] = -w23;
            sensitivity[72 * stride + i] = dy_EYY;
            sensitivity[73 * stride + i] = dy_EZY;
            sensitivity[74 * stride + i] = dy_EBY - dy_EZX*q_Ax - q_Az*sin_c;
            sensitivity[75 * stride + i] = cos_a*cos_c*q_Ax + q_Ay*sin_c - w24;
            sensitivity[76 * stride + i] = sin_c;
            sensitivity[77 * stride + i] = dx_EXY;
            sensitivity[78 * stride + i] = dy_EA0C;
            sensitivity[79 * stride + i] = dx_EA0C;
            sensitivity[80 * stride + i] = dy_EAX;
            sensitivity[81 * stride + i] = dy_EBX;
            sensitivity[82 * stride + i] = 0.0;
            sensitivity[83 * stride + i] = dz_EYX;
            sensitivity[84 * stride + i] = cos_a;
            sensitivity[85 * stride + i] = dz_EAX;
            sensitivity[86 * stride + i] = dz_EBX;
            sensitivity[87 * stride + i] = dz_ECX;
            sensitivity[88 * stride + i] = 0.0;
            sensitivity[89 * stride + i] = sin_a;
            sensitivity[90 * stride + i] = dz_EZY;
            sensitivity[91 * stride + i] = -w25;
            sensitivity[92 * stride + i] = dz_EBY;
            sensitivity[93 * stride + i] = dz_ECY;
            sensitivity[94 * stride + i] = 0.0;
            sensitivity[95 * stride + i] = dz_EYX;
            sensitivity[96 * stride + i] = cos_a;
            sensitivity[97 * stride + i] = dz_EAZ;
            sensitivity[98 * stride + i] = dz_EBX;
            sensitivity[99 * stride + i] = dz_ECX;
            sensitivity[100 * stride + i] = 0.0;
            sensitivity[101 * stride + i] = 0.0;
            sensitivity[102 * stride + i] = -1.0;
            sensitivity[103 * stride + i] = -w26;
            sensitivity[104 * stride + i] = dz_EBA;
            sensitivity[105 * stride + i] = 0.0;
            sensitivity[106 * stride + i] = 0.0;
            sensitivity[107 * stride + i] = 0.0;
            sensitivity[108 * stride + i] = -1.0;
            sensitivity[109 * stride + i] = dz_EAC;
            sensitivity[110 * stride + i] = dz_EBC;
            sensitivity[111 * stride + i] = 0.0;
            sensitivity[112 * stride + i] = dz_ECY;
            sensitivity[113 * stride + i] = sin_a;
            sensitivity[114 * stride + i] = dz_EZY;
            sensitivity[115 * stride + i] = -cos_a*q_Ax + dz_EBY;
            sensitivity[116 * stride + i] = dz_ECY - q_Ax*sin_a;
            sensitivity[117 * stride + i] = 0.0;
            sensitivity[118 * stride + i] = 0.0;
            sensitivity[119 * stride + i] = q_Cy - w26;
            sensitivity[120 * stride + i] = dz_EBA - q_Cx;
            sensitivity[121 * stride + i] = dz_EAX;
            sensitivity[122 * stride + i] = dz_EBX;
        }
    }
}

/*
 * Ideal position of a tool point in the bed frame.
 * Source: Eqs. (1)-(4) without errors. Operations: 5 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z A C (x y z a c)
 * in parameters: 23 values, mm, rad; home positions and location errors (q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz
 *     q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C EA0C EB0C EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out ideal: 3 rows of stride, mm; tool point in the bed frame, without errors (px py pz)
 */
void trunnion_mill_tool_in_bed_ideal(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT ideal)
{
    /* once per call */
    const double q_Tx = parameters[9];
    const double q_Ty = parameters[10];
    const double q_Tz = parameters[11];
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
        const double x = positions[0 * stride + i];
        const double z = positions[2 * stride + i];
        const double rx = point[0 * stride + i];
        const double ry = point[1 * stride + i];
        const double rz = point[2 * stride + i];
        ideal[0 * stride + i] = q_Tx + rx + x;
        ideal[1 * stride + i] = q_Ty + ry;
        ideal[2 * stride + i] = q_Tz + rz + z;
    }
}

/*
 * Deviation of a tool point in the bed frame, exact.
 * Source: Eqs. (1)-(4). Operations: 45 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z A C (x y z a c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXA EYA EZA EAA EBA ECA EXC EYC EZC EAC EBC ECC)
 * in parameters: 23 values, mm, rad; home positions and location errors (q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz
 *     q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C EA0C EB0C EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; tool point in the bed frame, actual minus ideal (dx dy dz)
 */
void trunnion_mill_tool_in_bed_deviation(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation)
{
    /* once per call */
    const double q_Tx = parameters[9];
    const double q_Ty = parameters[10];
    const double q_Tz = parameters[11];
    const double EA0Z = parameters[21];
    const double EB0Z = parameters[22];
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
        const double z = positions[2 * stride + i];
        const double EXX = errors[0 * stride + i];
        const double EYX = errors[1 * stride + i];
        const double EZX = errors[2 * stride + i];
        const double EAX = errors[3 * stride + i];
        const double EBX = errors[4 * stride + i];
        const double ECX = errors[5 * stride + i];
        const double EXZ = errors[12 * stride + i];
        const double EYZ = errors[13 * stride + i];
        const double EZZ = errors[14 * stride + i];
        const double EAZ = errors[15 * stride + i];
        const double EBZ = errors[16 * stride + i];
        const double ECZ = errors[17 * stride + i];
        const double rx = point[0 * stride + i];
        const double ry = point[1 * stride + i];
        const double rz = point[2 * stride + i];
        const double w0 = q_Tz + rz;
        const double w1 = w0 + z;
        const double w2 = q_Tx + rx;
        const double w3 = q_Ty + ry;
        const double w4 = EBZ*w0 - ECZ*w3 + EXZ;
        const double w5 = -EAZ*w0 + ECZ*w2 + EYZ;
        const double w6 = EAZ*w3 - EBZ*w2 + EZZ;
        const double w7 = EA0Z*(w3 + w5) - EB0Z*(w2 + w4) + w6;
        const double w8 = w1 + w7;
        const double w9 = w1 + w6;
        const double w10 = -EA0Z*w9 + w5;
        const double w11 = w10 + w3;
        const double w12 = EB0Z*w9 + w4;
        const double w13 = w12 + w2;
        deviation[0 * stride + i] = EBX*w8 - ECX*w11 + EXX + w12;
        deviation[1 * stride + i] = -EAX*w8 + ECX*w13 + EYX + w10;
        deviation[2 * stride + i] = EAX*w11 - EBX*w13 + EZX + w7;
    }
}

/*
 * Deviation of a tool point in the bed frame, to first order in the errors.
 * Source: Eqs. (1)-(4). Operations: 39 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z A C (x y z a c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXA EYA EZA EAA EBA ECA EXC EYC EZC EAC EBC ECC)
 * in parameters: 23 values, mm, rad; home positions and location errors (q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz
 *     q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C EA0C EB0C EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; tool point in the bed frame, actual minus ideal (dx dy dz)
 */
void trunnion_mill_tool_in_bed_deviation_first_order(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation)
{
    /* once per call */
    const double q_Tx = parameters[9];
    const double q_Ty = parameters[10];
    const double q_Tz = parameters[11];
    const double EA0Z = parameters[21];
    const double EB0Z = parameters[22];
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
        const double z = positions[2 * stride + i];
        const double EXX = errors[0 * stride + i];
        const double EYX = errors[1 * stride + i];
        const double EZX = errors[2 * stride + i];
        const double EAX = errors[3 * stride + i];
        const double EBX = errors[4 * stride + i];
        const double ECX = errors[5 * stride + i];
        const double EXZ = errors[12 * stride + i];
        const double EYZ = errors[13 * stride + i];
        const double EZZ = errors[14 * stride + i];
        const double EAZ = errors[15 * stride + i];
        const double EBZ = errors[16 * stride + i];
        const double ECZ = errors[17 * stride + i];
        const double rx = point[0 * stride + i];
        const double ry = point[1 * stride + i];
        const double rz = point[2 * stride + i];
        const double w0 = q_Ty + ry;
        const double w1 = q_Tz + rz;
        const double w2 = w1 + z;
        const double w3 = EBZ*w1 - ECZ*w0 + EXZ;
        const double w4 = EB0Z*w2 + w3;
        const double w5 = q_Tx + rx;
        const double w6 = -EAZ*w1 + ECZ*w5 + EYZ;
        const double w7 = -EA0Z*w2 + w6;
        const double w8 = EAZ*w0 - EBZ*w5 + EZZ;
        const double w9 = EA0Z*w0 - EB0Z*w5 + w8;
        deviation[0 * stride + i] = EBX*w2 - ECX*w0 + EXX + w4;
        deviation[1 * stride + i] = -EAX*w2 + ECX*w5 + EYX + w7;
        deviation[2 * stride + i] = EAX*w0 - EBX*w5 + EZX + w9;
    }
}

/*
 * Sensitivity of a tool point in the bed frame to every error, at the error-free machine.
 * Source: Eqs. (1)-(4), first order. Operations: 8 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z A C (x y z a c)
 * in parameters: 23 values, mm, rad; home positions and location errors (q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz
 *     q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C EA0C EB0C EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out sensitivity: 123 rows of stride, mm/mm, mm/rad; derivative of the deviation by each component error, then by
 *     each location error (dx_EXX dx_EYX .. dz_EB0Z, last index fastest)
 */
void trunnion_mill_tool_in_bed_sensitivity(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT sensitivity)
{
    /* once per call */
    const double q_Tx = parameters[9];
    const double q_Ty = parameters[10];
    const double q_Tz = parameters[11];
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
        const double z = positions[2 * stride + i];
        const double rx = point[0 * stride + i];
        const double ry = point[1 * stride + i];
        const double rz = point[2 * stride + i];
        const double dx_EBZ = q_Tz + rz;
        const double dx_EBX = dx_EBZ + z;
        const double dz_EAX = q_Ty + ry;
        const double dx_ECX = -dz_EAX;
        const double dy_EAX = -dx_EBX;
        const double dy_ECX = q_Tx + rx;
        const double dz_EBX = -dy_ECX;
        sensitivity[0 * stride + i] = 1.0;
        sensitivity[1 * stride + i] = 0.0;
        sensitivity[2 * stride + i] = 0.0;
        sensitivity[3 * stride + i] = 0.0;
        sensitivity[4 * stride + i] = dx_EBX;
        sensitivity[5 * stride + i] = dx_ECX;
        sensitivity[6 * stride + i] = 0.0;
        sensitivity[7 * stride + i] = 0.0;
        sensitivity[8 * stride + i] = 0.0;
        sensitivity[9 * stride + i] = 0.0;
        sensitivity[10 * stride + i] = 0.0;
        sensitivity[11 * stride + i] = 0.0;
        sensitivity[12 * stride + i] = 1.0;
        sensitivity[13 * stride + i] = 0.0;
        sensitivity[14 * stride + i] = 0.0;
        sensitivity[15 * stride + i] = 0.0;
        sensitivity[16 * stride + i] = dx_EBZ;
        sensitivity[17 * stride + i] = dx_ECX;
        sensitivity[18 * stride + i] = 0.0;
        sensitivity[19 * stride + i] = 0.0;
        sensitivity[20 * stride + i] = 0.0;
        sensitivity[21 * stride + i] = 0.0;
        sensitivity[22 * stride + i] = 0.0;
        sensitivity[23 * stride + i] = 0.0;
        sensitivity[24 * stride + i] = 0.0;
        sensitivity[25 * stride + i] = 0.0;
        sensitivity[26 * stride + i] = 0.0;
        sensitivity[27 * stride + i] = 0.0;
        sensitivity[28 * stride + i] = 0.0;
        sensitivity[29 * stride + i] = 0.0;
        sensitivity[30 * stride + i] = 0.0;
        sensitivity[31 * stride + i] = 0.0;
        sensitivity[32 * stride + i] = 0.0;
        sensitivity[33 * stride + i] = 0.0;
        sensitivity[34 * stride + i] = 0.0;
        sensitivity[35 * stride + i] = 0.0;
        sensitivity[36 * stride + i] = 0.0;
        sensitivity[37 * stride + i] = 0.0;
        sensitivity[38 * stride + i] = 0.0;
        sensitivity[39 * stride + i] = 0.0;
        sensitivity[40 * stride + i] = dx_EBX;
        sensitivity[41 * stride + i] = 0.0;
        sensitivity[42 * stride + i] = 1.0;
        sensitivity[43 * stride + i] = 0.0;
        sensitivity[44 * stride + i] = dy_EAX;
        sensitivity[45 * stride + i] = 0.0;
        sensitivity[46 * stride + i] = dy_ECX;
        sensitivity[47 * stride + i] = 0.0;
        sensitivity[48 * stride + i] = 0.0;
        sensitivity[49 * stride + i] = 0.0;
        sensitivity[50 * stride + i] = 0.0;
        sensitivity[51 * stride + i] = 0.0;
        sensitivity[52 * stride + i] = 0.0;
        sensitivity[53 * stride + i] = 0.0;
        sensitivity[54 * stride + i] = 1.0;
        sensitivity[55 * stride + i] = 0.0;
        sensitivity[56 * stride + i] = -dx_EBZ;
        sensitivity[57 * stride + i] = 0.0;
        sensitivity[58 * stride + i] = dy_ECX;
        sensitivity[59 * stride + i] = 0.0;
        sensitivity[60 * stride + i] = 0.0;
        sensitivity[61 * stride + i] = 0.0;
        sensitivity[62 * stride + i] = 0.0;
        sensitivity[63 * stride + i] = 0.0;
        sensitivity[64 * stride + i] = 0.0;
        sensitivity[65 * stride + i] = 0.0;
        sensitivity[66 * stride + i] = 0.0;
        sensitivity[67 * stride + i] = 0.0;
        sensitivity[68 * stride + i] = 0.0;
        sensitivity[69 * stride + i] = 0.0;
        sensitivity[70 * stride + i] = 0.0;
        sensitivity[71 * stride + i] = 0.0;
        sensitivity[72 * stride + i] = 0.0;
        sensitivity[73 * stride + i] = 0.0;
        sensitivity[74 * stride + i] = 0.0;
        sensitivity[75 * stride + i] = 0.0;
        sensitivity[76 * stride + i] = 0.0;
        sensitivity[77 * stride + i] = 0.0;
        sensitivity[78 * stride + i] = 0.0;
        sensitivity[79 * stride + i] = 0.0;
        sensitivity[80 * stride + i] = dy_EAX;
        sensitivity[81 * stride + i] = 0.0;
        sensitivity[82 * stride + i] = 0.0;
        sensitivity[83 * stride + i] = 0.0;
        sensitivity[84 * stride + i] = 1.0;
        sensitivity[85 * stride + i] = dz_EAX;
        sensitivity[86 * stride + i] = dz_EBX;
        sensitivity[87 * stride + i] = 0.0;
        sensitivity[88 * stride + i] = 0.0;
        sensitivity[89 * stride + i] = 0.0;
        sensitivity[90 * stride + i] = 0.0;
        sensitivity[91 * stride + i] = 0.0;
        sensitivity[92 * stride + i] = 0.0;
        sensitivity[93 * stride + i] = 0.0;
        sensitivity[94 * stride + i] = 0.0;
        sensitivity[95 * stride + i] = 0.0;
        sensitivity[96 * stride + i] = 1.0;
        sensitivity[97 * stride + i] = dz_EAX;
        sensitivity[98 * stride + i] = dz_EBX;
        sensitivity[99 * stride + i] = 0.0;
        sensitivity[100 * stride + i] = 0.0;
        sensitivity[101 * stride + i] = 0.0;
        sensitivity[102 * stride + i] = 0.0;
        sensitivity[103 * stride + i] = 0.0;
        sensitivity[104 * stride + i] = 0.0;
        sensitivity[105 * stride + i] = 0.0;
        sensitivity[106 * stride + i] = 0.0;
        sensitivity[107 * stride + i] = 0.0;
        sensitivity[108 * stride + i] = 0.0;
        sensitivity[109 * stride + i] = 0.0;
        sensitivity[110 * stride + i] = 0.0;
        sensitivity[111 * stride + i] = 0.0;
        sensitivity[112 * stride + i] = 0.0;
        sensitivity[113 * stride + i] = 0.0;
        sensitivity[114 * stride + i] = 0.0;
        sensitivity[115 * stride + i] = 0.0;
        sensitivity[116 * stride + i] = 0.0;
        sensitivity[117 * stride + i] = 0.0;
        sensitivity[118 * stride + i] = 0.0;
        sensitivity[119 * stride + i] = 0.0;
        sensitivity[120 * stride + i] = 0.0;
        sensitivity[121 * stride + i] = dz_EAX;
        sensitivity[122 * stride + i] = dz_EBX;
    }
}

/*
 * Ideal position of a workpiece point in the bed frame.
 * Source: Eqs. (1)-(4) without errors. Operations: 54 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z A C (x y z a c)
 * in parameters: 23 values, mm, rad; home positions and location errors (q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz
 *     q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C EA0C EB0C EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the workpiece frame (rx ry rz)
 * out ideal: 3 rows of stride, mm; workpiece point in the bed frame, without errors (px py pz)
 */
void trunnion_mill_workpiece_in_bed_ideal(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT ideal)
{
    /* once per call */
    const double q_Ax = parameters[0];
    const double q_Ay = parameters[1];
    const double q_Az = parameters[2];
    const double q_Cx = parameters[3];
    const double q_Cy = parameters[4];
    const double q_Cz = parameters[5];
    const double q_wx = parameters[6];
    const double q_wy = parameters[7];
    const double q_wz = parameters[8];
    for (size_t start = 0; start < n; start += BLOCK) {
        const size_t count = n - start < BLOCK ? n - start : (size_t)BLOCK;
        /* cosines and sines */
        double cos_a_block[BLOCK];
        double sin_a_block[BLOCK];
        double cos_c_block[BLOCK];
        double sin_c_block[BLOCK];
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double a = positions[3 * stride + i];
            const double c = positions[4 * stride + i];
            cos_a_block[j] = cos(0.017453292519943295*a);
            sin_a_block[j] = sin(0.017453292519943295*a);
            cos_c_block[j] = cos(0.017453292519943295*c);
            sin_c_block[j] = sin(0.017453292519943295*c);
        }
        /* per point */
        POINTS_ARE_INDEPENDENT
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double cos_a = cos_a_block[j];
            const double sin_a = sin_a_block[j];
            const double cos_c = cos_c_block[j];
            const double sin_c = sin_c_block[j];
            const double y = positions[1 * stride + i];
            const double rx = point[0 * stride + i];
            const double ry = point[1 * stride + i];
            const double rz = point[2 * stride + i];
            const double w0 = cos_a*cos_c;
            const double w1 = cos_a*sin_c;
            const double w2 = cos_c*sin_a;
            const double w3 = sin_a*sin_c;
            ideal[0 * stride + i] = cos_c*q_wx + cos_c*rx + q_Ax + q_Cx - q_wy*sin_c - ry*sin_c;
            ideal[1 * stride + i] = cos_a*q_Cy + q_Ay - q_Cz*sin_a + q_wx*w1 + q_wy*w0 - q_wz*sin_a + rx*w1 + ry*w0 -
                rz*sin_a + y;
            ideal[2 * stride + i] = cos_a*q_Cz + cos_a*q_wz + cos_a*rz + q_Az + q_Cy*sin_a + q_wx*w3 + q_wy*w2 + rx*w3 +
                ry*w2;
        }
    }
}

/*
 * Deviation of a workpiece point in the bed frame, exact.
 * Source: Eqs. (1)-(4). Operations: 122 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z A C (x y z a c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXA EYA EZA EAA EBA ECA EXC EYC EZC EAC EBC ECC)
 * in parameters: 23 values, mm, rad; home positions and location errors (q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz
 *     q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C EA0C EB0C EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the workpiece frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; workpiece point in the bed frame, actual minus ideal (dx dy dz)
 */
void trunnion_mill_workpiece_in_bed_deviation(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation)
{
    /* once per call */
    const double q_Ax = parameters[0];
    const double q_Ay = parameters[1];
    const double q_Az = parameters[2];
    const double q_Cx = parameters[3];
    const double q_Cy = parameters[4];
    const double q_Cz = parameters[5];
    const double q_wx = parameters[6];
    const double q_wy = parameters[7];
    const double q_wz = parameters[8];
    const double EC0Y = parameters[12];
    const double EY0A = parameters[13];
    const double EZ0A = parameters[14];
    const double EB0A = parameters[15];
    const double EC0A = parameters[16];
    const double EX0C = parameters[17];
    const double EY0C = parameters[18];
    const double EA0C = parameters[19];
    const double EB0C = parameters[20];
    for (size_t start = 0; start < n; start += BLOCK) {
        const size_t count = n - start < BLOCK ? n - start : (size_t)BLOCK;
        /* cosines and sines */
        double cos_a_block[BLOCK];
        double sin_a_block[BLOCK];
        double cos_c_block[BLOCK];
        double sin_c_block[BLOCK];
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double a = positions[3 * stride + i];
            const double c = positions[4 * stride + i];
            cos_a_block[j] = cos(0.017453292519943295*a);
            sin_a_block[j] = sin(0.017453292519943295*a);
            cos_c_block[j] = cos(0.017453292519943295*c);
            sin_c_block[j] = sin(0.017453292519943295*c);
        }
        /* per point */
        POINTS_ARE_INDEPENDENT
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double cos_a = cos_a_block[j];
            const double sin_a = sin_a_block[j];
            const double cos_c = cos_c_block[j];
            const double sin_c = sin_c_block[j];
            const double y = positions[1 * stride + i];
            const double EXY = errors[6 * stride + i];
            const double EYY = errors[7 * stride + i];
            const double EZY = errors[8 * stride + i];
            const double EAY = errors[9 * stride + i];
            const double EBY = errors[10 * stride + i];
            const double ECY = errors[11 * stride + i];
            const double EXA = errors[18 * stride + i];
            const double EYA = errors[19 * stride + i];
            const double EZA = errors[20 * stride + i];
            const double EAA = errors[21 * stride + i];
            const double EBA = errors[22 * stride + i];
            const double ECA = errors[23 * stride + i];
            const double EXC = errors[24 * stride + i];
            const double EYC = errors[25 * stride + i];
            const double EZC = errors[26 * stride + i];
            const double EAC = errors[27 * stride + i];
            const double EBC = errors[28 * stride + i];
            const double ECC = errors[29 * stride + i];
            const double rx = point[0 * stride + i];
            const double ry = point[1 * stride + i];
            const double rz = point[2 * stride + i];
            const double w0 = q_wx + rx;
            const double w1 = q_wy + ry;
            const double w2 = cos_c*w0 - sin_c*w1;
            const double w3 = q_Cx + w2;
            const double w4 = EAC*w1 - EBC*w0 + EZC;
            const double w5 = cos_c*w1 + sin_c*w0;
            const double w6 = q_wz + rz;
            const double w7 = EBC*w6 - ECC*w1 + EXC;
            const double w8 = -EAC*w6 + ECC*w0 + EYC;
            const double w9 = cos_c*w7 - sin_c*w8;
            const double w10 = cos_c*w8 + sin_c*w7;
            const double w11 = EA0C*(w10 + w5) - EB0C*(w2 + w9) + w4;
            const double w12 = q_Cz + w6;
            const double w13 = w11 + w12;
            const double w14 = w4 + w6;
            const double w15 = -EA0C*w14 + EY0C + w10;
            const double w16 = q_Cy + w5;
            const double w17 = w15 + w16;
            const double w18 = EB0C*w14 + EX0C + w9;
            const double w19 = EBA*w13 - ECA*w17 + EXA + w18;
            const double w20 = w19 + w3;
            const double w21 = w18 + w3;
            const double w22 = -EAA*w13 + ECA*w21 + EYA + w15;
            const double w23 = EAA*w17 - EBA*w21 + EZA + w11;
            const double w24 = cos_a*w22 - sin_a*w23;
            const double w25 = EC0A*w20 + EY0A + w24;
            const double w26 = cos_a*w16 - sin_a*w12;
            const double w27 = q_Ay + w26;
            const double w28 = w25 + w27;
            const double w29 = cos_a*w12 + sin_a*w16;
            const double w30 = cos_a*w23 + sin_a*w22;
            const double w31 = EB0A*(w29 + w30) - EC0A*(w24 + w26) + w19;
            const double w32 = q_Ax + w3;
            const double w33 = w31 + w32;
            const double w34 = -EB0A*w20 + EZ0A + w30;
            const double w35 = q_Az + w29;
            const double w36 = w34 + w35;
            const double w37 = EBY*w36 - ECY*w28 + EXY + w31;
            const double w38 = -EAY*w36 + ECY*w33 + EYY + w25;
            const double w39 = w27 + y;
            deviation[0 * stride + i] = -EC0Y*(w38 + w39) + w37;
            deviation[1 * stride + i] = EC0Y*(w32 + w37) + w38;
            deviation[2 * stride + i] = EAY*w28 - EBY*w33 + EZY + w34;
        }
    }
}

/*
 * Deviation of a workpiece point in the bed frame, to first order in the errors.
 * Source: Eqs. (1)-(4). Operations: 108 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z A C (x y z a c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXA EYA EZA EAA EBA ECA EXC EYC EZC EAC EBC ECC)
 * in parameters: 23 values, mm, rad; home positions and location errors (q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz
 *     q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C EA0C EB0C EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the workpiece frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; workpiece point in the bed frame, actual minus ideal (dx dy dz)
 */
void trunnion_mill_workpiece_in_bed_deviation_first_order(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation)
{
    /* once per call */
    const double q_Ax = parameters[0];
    const double q_Ay = parameters[1];
    const double q_Az = parameters[2];
    const double q_Cx = parameters[3];
    const double q_Cy = parameters[4];
    const double q_Cz = parameters[5];
    const double q_wx = parameters[6];
    const double q_wy = parameters[7];
    const double q_wz = parameters[8];
    const double EC0Y = parameters[12];
    const double EY0A = parameters[13];
    const double EZ0A = parameters[14];
    const double EB0A = parameters[15];
    const double EC0A = parameters[16];
    const double EX0C = parameters[17];
    const double EY0C = parameters[18];
    const double EA0C = parameters[19];
    const double EB0C = parameters[20];
    for (size_t start = 0; start < n; start += BLOCK) {
        const size_t count = n - start < BLOCK ? n - start : (size_t)BLOCK;
        /* cosines and sines */
        double cos_a_block[BLOCK];
        double sin_a_block[BLOCK];
        double cos_c_block[BLOCK];
        double sin_c_block[BLOCK];
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double a = positions[3 * stride + i];
            const double c = positions[4 * stride + i];
            cos_a_block[j] = cos(0.017453292519943295*a);
            sin_a_block[j] = sin(0.017453292519943295*a);
            cos_c_block[j] = cos(0.017453292519943295*c);
            sin_c_block[j] = sin(0.017453292519943295*c);
        }
        /* per point */
        POINTS_ARE_INDEPENDENT
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double cos_a = cos_a_block[j];
            const double sin_a = sin_a_block[j];
            const double cos_c = cos_c_block[j];
            const double sin_c = sin_c_block[j];
            const double y = positions[1 * stride + i];
            const double EXY = errors[6 * stride + i];
            const double EYY = errors[7 * stride + i];
            const double EZY = errors[8 * stride + i];
            const double EAY = errors[9 * stride + i];
            const double EBY = errors[10 * stride + i];
            const double ECY = errors[11 * stride + i];
            const double EXA = errors[18 * stride + i];
            const double EYA = errors[19 * stride + i];
            const double EZA = errors[20 * stride + i];
            const double EAA = errors[21 * stride + i];
            const double EBA = errors[22 * stride + i];
            const double ECA = errors[23 * stride + i];
            const double EXC = errors[24 * stride + i];
            const double EYC = errors[25 * stride + i];
            const double EZC = errors[26 * stride + i];
            const double EAC = errors[27 * stride + i];
            const double EBC = errors[28 * stride + i];
            const double ECC = errors[29 * stride + i];
            const double rx = point[0 * stride + i];
            const double ry = point[1 * stride + i];
            const double rz = point[2 * stride + i];
            const double w0 = q_wx + rx;
            const double w1 = q_wy + ry;
            const double w2 = cos_c*w0 - sin_c*w1;
            const double w3 = q_Cx + w2;
            const double w4 = q_wz + rz;
            const double w5 = EBC*w4 - ECC*w1 + EXC;
            const double w6 = -EAC*w4 + ECC*w0 + EYC;
            const double w7 = cos_c*w6 + sin_c*w5;
            const double w8 = -EA0C*w4 + EY0C + w7;
            const double w9 = q_Cz + w4;
            const double w10 = -EAA*w9 + ECA*w3 + EYA + w8;
            const double w11 = EAC*w1 - EBC*w0 + EZC;
            const double w12 = cos_c*w1 + sin_c*w0;
            const double w13 = EA0C*w12 - EB0C*w2 + w11;
            const double w14 = q_Cy + w12;
            const double w15 = EAA*w14 - EBA*w3 + EZA + w13;
            const double w16 = cos_a*w15 + sin_a*w10;
            const double w17 = -EB0A*w3 + EZ0A + w16;
            const double w18 = q_Ax + w3;
            const double w19 = cos_a*w14 - sin_a*w9;
            const double w20 = q_Ay + w19;
            const double w21 = cos_c*w5 - sin_c*w6;
            const double w22 = EB0C*w4 + EX0C + w21;
            const double w23 = EBA*w9 - ECA*w14 + EXA + w22;
            const double w24 = cos_a*w9 + sin_a*w14;
            const double w25 = EB0A*w24 - EC0A*w19 + w23;
            const double w26 = q_Az + w24;
            const double w27 = EBY*w26 - ECY*w20 + EXY + w25;
            const double w28 = w20 + y;
            const double w29 = cos_a*w10 - sin_a*w15;
            const double w30 = EC0A*w3 + EY0A + w29;
            const double w31 = -EAY*w26 + ECY*w18 + EYY + w30;
            deviation[0 * stride + i] = -EC0Y*w28 + w27;
            deviation[1 * stride + i] = EC0Y*w18 + w31;
            deviation[2 * stride + i] = EAY*w20 - EBY*w18 + EZY + w17;
        }
    }
}

/*
 * Sensitivity of a workpiece point in the bed frame to every error, at the error-free machine.
 * Source: Eqs. (1)-(4), first order. Operations: 133 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z A C (x y z a c)
 * in parameters: 23 values, mm, rad; home positions and location errors (q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz
 *     q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C EA0C EB0C EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the workpiece frame (rx ry rz)
 * out sensitivity: 123 rows of stride, mm/mm, mm/rad; derivative of the deviation by each component error, then by
 *     each location error (dx_EXX dx_EYX .. dz_EB0Z, last index fastest)
 */
void trunnion_mill_workpiece_in_bed_sensitivity(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT sensitivity)
{
    /* once per call */
    const double q_Ax = parameters[0];
    const double q_Ay = parameters[1];
    const double q_Az = parameters[2];
    const double q_Cx = parameters[3];
    const double q_Cy = parameters[4];
    const double q_Cz = parameters[5];
    const double q_wx = parameters[6];
    const double q_wy = parameters[7];
    const double q_wz = parameters[8];
    for (size_t start = 0; start < n; start += BLOCK) {
        const size_t count = n - start < BLOCK ? n - start : (size_t)BLOCK;
        /* cosines and sines */
        double cos_a_block[BLOCK];
        double sin_a_block[BLOCK];
        double cos_c_block[BLOCK];
        double sin_c_block[BLOCK];
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double a = positions[3 * stride + i];
            const double c = positions[4 * stride + i];
            cos_a_block[j] = cos(0.017453292519943295*a);
            sin_a_block[j] = sin(0.017453292519943295*a);
            cos_c_block[j] = cos(0.017453292519943295*c);
            sin_c_block[j] = sin(0.017453292519943295*c);
        }
        /* per point */
        POINTS_ARE_INDEPENDENT
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double cos_a = cos_a_block[j];
            const double sin_a = sin_a_block[j];
            const double cos_c = cos_c_block[j];
            const double sin_c = sin_c_block[j];
            const double y = positions[1 * stride + i];
            const double rx = point[0 * stride + i];
            const double ry = point[1 * stride + i];
            const double rz = point[2 * stride + i];
            const double w0 = cos_a*q_wz;
            const double w1 = cos_a*rz;
            const double w2 = cos_c*q_wy;
            const double w3 = cos_c*ry;
            const double w4 = q_wx*sin_c;
            const double w5 = rx*sin_c;
            const double w6 = sin_a*w2 + sin_a*w3 + sin_a*w4 + sin_a*w5 + w0 + w1;
            const double dx_EB0A = cos_a*q_Cz + q_Cy*sin_a + w6;
            const double dx_EBY = dx_EB0A + q_Az;
            const double w7 = q_wz*sin_a;
            const double w8 = rz*sin_a;
            const double dz_EA0C = cos_a*w2 + cos_a*w3 + cos_a*w4 + cos_a*w5 - w7 - w8;
            const double dz_EAA = cos_a*q_Cy + dz_EA0C - q_Cz*sin_a;
            const double dz_EAY = dz_EAA + q_Ay;
            const double dx_EB0C = q_wz + rz;
            const double w9 = cos_c*q_wx;
            const double w10 = cos_c*rx;
            const double w11 = q_wy*sin_c;
            const double w12 = ry*sin_c;
            const double dy_EC0A = q_Cx + w10 - w11 - w12 + w9;
            const double dy_ECY = dy_EC0A + q_Ax;
            const double dy_EZA = -sin_a;
            const double dy_EB0C = sin_a*w10 - sin_a*w11 - sin_a*w12 + sin_a*w9;
            const double dy_EBA = dy_EB0C + q_Cx*sin_a;
            const double dy_ECC = cos_a*w10 - cos_a*w11 - cos_a*w12 + cos_a*w9;
            const double dy_ECA = cos_a*q_Cx + dy_ECC;
            const double w13 = w2 + w3 + w4 + w5;
            sensitivity[0 * stride + i] = 0.0;
            sensitivity[1 * stride + i] = 0.0;
            sensitivity[2 * stride + i] = 0.0;
            sensitivity[3 * stride + i] = 0.0;
            sensitivity[4 * stride + i] = 0.0;
            sensitivity[5 * stride + i] = 0.0;
            sensitivity[6 * stride + i] = 1.0;
            sensitivity[7 * stride + i] = 0.0;
            sensitivity[8 * stride + i] = 0.0;
            sensitivity[9 * stride + i] = 0.0;
            sensitivity[10 * stride + i] = dx_EBY;
            sensitivity[11 * stride + i] = -dz_EAY;
            sensitivity[12 * stride + i] = 0.0;
            sensitivity[13 * stride + i] = 0.0;
            sensitivity[14 * stride + i] = 0.0;
            sensitivity[15 * stride + i] = 0.0;
            sensitivity[16 * stride + i] = 0.0;
            sensitivity[17 * stride + i] = 0.0;
            sensitivity[18 * stride + i] = 1.0;
            sensitivity[19 * stride + i] = 0.0;
            sensitivity[20 * stride + i] = 0.0;
            sensitivity[21 * stride + i] = 0.0;
            sensitivity[22 * stride + i] = dx_EB0C + q_Cz;
            sensitivity[23 * stride + i] = -q_Cy - w13;
            sensitivity[24 * stride + i] = cos_c;
            sensitivity[25 * stride + i] = -sin_c;
            sensitivity[26 * stride + i] = 0.0;
            sensitivity[27 * stride + i] = q_wz*sin_c + rz*sin_c;
            sensitivity[28 * stride + i] = cos_c*q_wz + cos_c*rz;
            sensitivity[29 * stride + i] = -w13;
            sensitivity[30 * stride + i] = -dz_EAY - y;
            sensitivity[31 * stride + i] = 0.0;
            sensitivity[32 * stride + i] = 0.0;
            sensitivity[33 * stride + i] = dx_EB0A;
            sensitivity[34 * stride + i] = -dz_EAA;
            sensitivity[35 * stride + i] = 1.0;
            sensitivity[36 * stride + i] = 0.0;
            sensitivity[37 * stride + i] = 0.0;
            sensitivity[38 * stride + i] = dx_EB0C;
            sensitivity[39 * stride + i] = 0.0;
            sensitivity[40 * stride + i] = 0.0;
            sensitivity[41 * stride + i] = 0.0;
            sensitivity[42 * stride + i] = 0.0;
            sensitivity[43 * stride + i] = 0.0;
            sensitivity[44 * stride + i] = 0.0;
            sensitivity[45 * stride + i] = 0.0;
            sensitivity[46 * stride + i] = 0.0;
            sensitivity[47 * stride + i] = 0.0;
            sensitivity[48 * stride + i] = 1.0;
            sensitivity[49 * stride + i] = 0.0;
            sensitivity[50 * stride + i] = -dx_EBY;
            sensitivity[51 * stride + i] = 0.0;
            sensitivity[52 * stride + i] = dy_ECY;
            sensitivity[53 * stride + i] = 0.0;
            sensitivity[54 * stride + i] = 0.0;
            sensitivity[55 * stride + i] = 0.0;
            sensitivity[56 * stride + i] = 0.0;
            sensitivity[57 * stride + i] = 0.0;
            sensitivity[58 * stride + i] = 0.0;
            sensitivity[59 * stride + i] = 0.0;
            sensitivity[60 * stride + i] = cos_a;
            sensitivity[61 * stride + i] = dy_EZA;
            sensitivity[62 * stride + i] = -dx_EB0A;
            sensitivity[63 * stride + i] = dy_EBA;
            sensitivity[64 * stride + i] = dy_ECA;
            sensitivity[65 * stride + i] = cos_a*sin_c;
            sensitivity[66 * stride + i] = cos_a*cos_c;
            sensitivity[67 * stride + i] = dy_EZA;
            sensitivity[68 * stride + i] = -cos_c*w0 - cos_c*w1 - q_wy*sin_a - ry*sin_a;
            sensitivity[69 * stride + i] = q_wx*sin_a + rx*sin_a + sin_c*w0 + sin_c*w1;
            sensitivity[70 * stride + i] = dy_ECC;
            sensitivity[71 * stride + i] = dy_ECY;
            sensitivity[72 * stride + i] = 1.0;
            sensitivity[73 * stride + i] = 0.0;
            sensitivity[74 * stride + i] = 0.0;
            sensitivity[75 * stride + i] = dy_EC0A;
            sensitivity[76 * stride + i] = 0.0;
            sensitivity[77 * stride + i] = cos_a;
            sensitivity[78 * stride + i] = -w6;
            sensitivity[79 * stride + i] = dy_EB0C;
            sensitivity[80 * stride + i] = 0.0;
            sensitivity[81 * stride + i] = 0.0;
            sensitivity[82 * stride + i] = 0.0;
            sensitivity[83 * stride + i] = 0.0;
            sensitivity[84 * stride + i] = 0.0;
            sensitivity[85 * stride + i] = 0.0;
            sensitivity[86 * stride + i] = 0.0;
            sensitivity[87 * stride + i] = 0.0;
            sensitivity[88 * stride + i] = 0.0;
            sensitivity[89 * stride + i] = 0.0;
            sensitivity[90 * stride + i] = 1.0;
            sensitivity[91 * stride + i] = dz_EAY;
            sensitivity[92 * stride + i] = -dy_ECY;
            sensitivity[93 * stride + i] = 0.0;
            sensitivity[94 * stride + i] = 0.0;
            sensitivity[95 * stride + i] = 0.0;
            sensitivity[96 * stride + i] = 0.0;
            sensitivity[97 * stride + i] = 0.0;
            sensitivity[98 * stride + i] = 0.0;
            sensitivity[99 * stride + i] = 0.0;
            sensitivity[100 * stride + i] = 0.0;
            sensitivity[101 * stride + i] = sin_a;
            sensitivity[102 * stride + i] = cos_a;
            sensitivity[103 * stride + i] = dz_EAA;
            sensitivity[104 * stride + i] = -dy_ECA;
            sensitivity[105 * stride + i] = dy_EBA;
            sensitivity[106 * stride + i] = sin_a*sin_c;
            sensitivity[107 * stride + i] = cos_c*sin_a;
            sensitivity[108 * stride + i] = cos_a;
            sensitivity[109 * stride + i] = cos_a*q_wy + cos_a*ry - cos_c*w7 - cos_c*w8;
            sensitivity[110 * stride + i] = -cos_a*q_wx - cos_a*rx + q_wz*sin_a*sin_c + rz*sin_a*sin_c;
            sensitivity[111 * stride + i] = dy_EB0C;
            sensitivity[112 * stride + i] = 0.0;
            sensitivity[113 * stride + i] = 0.0;
            sensitivity[114 * stride + i] = 1.0;
            sensitivity[115 * stride + i] = -dy_EC0A;
            sensitivity[116 * stride + i] = 0.0;
            sensitivity[117 * stride + i] = 0.0;
            sensitivity[118 * stride + i] = sin_a;
            sensitivity[119 * stride + i] = dz_EA0C;
            sensitivity[120 * stride + i] = -dy_ECC;
            sensitivity[121 * stride + i] = 0.0;
            sensitivity[122 * stride + i] = 0.0;
        }
    }
}

/*
 * Ideal position of a bed point in the workpiece frame.
 * Source: Eqs. (1)-(4) without errors. Operations: 63 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z A C (x y z a c)
 * in parameters: 23 values, mm, rad; home positions and location errors (q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz
 *     q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C EA0C EB0C EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the bed frame (rx ry rz)
 * out ideal: 3 rows of stride, mm; bed point in the workpiece frame, without errors (px py pz)
 */
void trunnion_mill_bed_in_workpiece_ideal(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT ideal)
{
    /* once per call */
    const double q_Ax = parameters[0];
    const double q_Ay = parameters[1];
    const double q_Az = parameters[2];
    const double q_Cx = parameters[3];
    const double q_Cy = parameters[4];
    const double q_Cz = parameters[5];
    const double q_wx = parameters[6];
    const double q_wy = parameters[7];
    const double q_wz = parameters[8];
    for (size_t start = 0; start < n; start += BLOCK) {
        const size_t count = n - start < BLOCK ? n - start : (size_t)BLOCK;
        /* cosines and sines */
        double cos_a_block[BLOCK];
        double sin_a_block[BLOCK];
        double cos_c_block[BLOCK];
        double sin_c_block[BLOCK];
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double a = positions[3 * stride + i];
            const double c = positions[4 * stride + i];
            cos_a_block[j] = cos(0.017453292519943295*a);
            sin_a_block[j] = sin(0.017453292519943295*a);
            cos_c_block[j] = cos(0.017453292519943295*c);
            sin_c_block[j] = sin(0.017453292519943295*c);
        }
        /* per point */
        POINTS_ARE_INDEPENDENT
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double cos_a = cos_a_block[j];
            const double sin_a = sin_a_block[j];
            const double cos_c = cos_c_block[j];
            const double sin_c = sin_c_block[j];
            const double y = positions[1 * stride + i];
            const double rx = point[0 * stride + i];
            const double ry = point[1 * stride + i];
            const double rz = point[2 * stride + i];
            const double w0 = cos_a*sin_c;
            const double w1 = cos_a*cos_c;
            ideal[0 * stride + i] = cos_a*ry*sin_c - cos_c*q_Ax - cos_c*q_Cx + cos_c*rx - q_Ay*w0 - q_Az*sin_a*sin_c -
                q_Cy*sin_c - q_wx + rz*sin_a*sin_c - w0*y;
            ideal[1 * stride + i] = cos_a*cos_c*ry - cos_c*q_Az*sin_a - cos_c*q_Cy + cos_c*rz*sin_a + q_Ax*sin_c -
                q_Ay*w1 + q_Cx*sin_c - q_wy - rx*sin_c - w1*y;
            ideal[2 * stride + i] = -cos_a*q_Az + cos_a*rz + q_Ay*sin_a - q_Cz - q_wz - ry*sin_a + sin_a*y;
        }
    }
}

/*
 * Deviation of a bed point in the workpiece frame, exact.
 * Source: Eqs. (1)-(4). Operations: 246 per point, 13 once per call.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z A C (x y z a c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXA EYA EZA EAA EBA ECA EXC EYC EZC EAC EBC ECC)
 * in parameters: 23 values, mm, rad; home positions and location errors (q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz
 *     q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C EA0C EB0C EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the bed frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; bed point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void trunnion_mill_bed_in_workpiece_deviation(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation)
{
    /* once per call */
    const double q_Ax = parameters[0];
    const double q_Ay = parameters[1];
    const double q_Az = parameters[2];
    const double q_Cx = parameters[3];
    const double q_Cy = parameters[4];
    const double q_Cz = parameters[5];
    const double EC0Y = parameters[12];
    const double EY0A = parameters[13];
    const double EZ0A = parameters[14];
    const double EB0A = parameters[15];
    const double EC0A = parameters[16];
    const double EX0C = parameters[17];
    const double EY0C = parameters[18];
    const double EA0C = parameters[19];
    const double EB0C = parameters[20];
    const double w8 = (EC0Y*EC0Y);
    const double w9 = (1.0/(w8 + 1.0));
    const double w30 = (EB0A*EB0A) + (EC0A*EC0A);
    const double w31 = (1.0/(w30 + 1.0));
    const double w59 = (EA0C*EA0C) + (EB0C*EB0C);
    const double w60 = (1.0/(w59 + 1.0));
    for (size_t start = 0; start < n; start += BLOCK) {
        const size_t count = n - start < BLOCK ? n - start : (size_t)BLOCK;
        /* cosines and sines */
        double cos_a_block[BLOCK];
        double sin_a_block[BLOCK];
        double cos_c_block[BLOCK];
        double sin_c_block[BLOCK];
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double a = positions[3 * stride + i];
            const double c = positions[4 * stride + i];
            cos_a_block[j] = cos(0.017453292519943295*a);
            sin_a_block[j] = sin(0.017453292519943295*a);
            cos_c_block[j] = cos(0.017453292519943295*c);
            sin_c_block[j] = sin(0.017453292519943295*c);
        }
        /* per point */
        POINTS_ARE_INDEPENDENT
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double cos_a = cos_a_block[j];
            const double sin_a = sin_a_block[j];
            const double cos_c = cos_c_block[j];
            const double sin_c = sin_c_block[j];
            const double y = positions[1 * stride + i];
            const double EXY = errors[6 * stride + i];
            const double EYY = errors[7 * stride + i];
            const double EZY = errors[8 * stride + i];
            const double EAY = errors[9 * stride + i];
            const double EBY = errors[10 * stride + i];
            const double ECY = errors[11 * stride + i];
            const double EXA = errors[18 * stride + i];
            const double EYA = errors[19 * stride + i];
            const double EZA = errors[20 * stride + i];
            const double EAA = errors[21 * stride + i];
            const double EBA = errors[22 * stride + i];
            const double ECA = errors[23 * stride + i];
            const double EXC = errors[24 * stride + i];
            const double EYC = errors[25 * stride + i];
            const double EZC = errors[26 * stride + i];
            const double EAC = errors[27 * stride + i];
            const double EBC = errors[28 * stride + i];
            const double ECC = errors[29 * stride + i];
            const double rx = point[0 * stride + i];
            const double ry = point[1 * stride + i];
            const double rz = point[2 * stride + i];
            const double w0 = -q_Ax + rx;
            const double w1 = -q_Cx + w0;
            const double w2 = ry - y;
            const double w3 = -q_Ay + w2;
            const double w4 = -q_Az + rz;
            const double w5 = cos_a*w3 + sin_a*w4;
            const double w6 = -q_Cy + w5;
            const double w7 = cos_c*w1 + sin_c*w6;
            const double w10 = w9*(EC0Y*ry - rx*w8);
            const double w11 = -EXY + w10;
            const double w12 = w9*(-EC0Y*rx - ry*w8);
            const double w13 = -EYY + w12;
            const double w14 = w13 + w2;
            const double w15 = EC0Y*rz;
            const double w16 = w9*(EC0Y*w15 - rz*w8);
            const double w17 = -EZY + w16;
            const double w18 = rz + w17;
            const double w19 = rx + w11;
            const double w20 = EAY*w19 + EBY*w14 + ECY*w18;
            const double w21 = (EAY*EAY) + (EBY*EBY) + (ECY*ECY);
            const double w22 = (1.0/(w21 + 1.0));
            const double w23 = w22*(EAY*w20 - EBY*w18 + ECY*w14 - rx*w21 + w11);
            const double w24 = w22*(EAY*w18 + EBY*w20 - ECY*w19 + w13 - w2*w21);
            const double w25 = -EY0A + w24;
            const double w26 = w25 + w3;
            const double w27 = w22*(-EAY*w14 + EBY*w19 + ECY*w20 - rz*w21 + w17);
            const double w28 = -EZ0A + w27;
            const double w29 = w28 + w4;
            const double w32 = w31*(-EB0A*w29 + EC0A*w26 - w0*w30 + w23);
            const double w33 = -EXA + w32;
            const double w34 = w0 + w23;
            const double w35 = EB0A*w26 + EC0A*w29;
            const double w36 = w31*(EB0A*w35 - EC0A*w34 + w25 - w3*w30);
            const double w37 = w31*(EB0A*w34 + EC0A*w35 + w28 - w30*w4);
            const double w38 = cos_a*w36 + sin_a*w37;
            const double w39 = -EYA + w38;
            const double w40 = w39 + w5;
            const double w41 = cos_a*w4 - sin_a*w3;
            const double w42 = cos_a*w37 - sin_a*w36;
            const double w43 = -EZA + w42;
            const double w44 = w41 + w43;
            const double w45 = w0 + w33;
            const double w46 = EAA*w45 + EBA*w40 + ECA*w44;
            const double w47 = (EAA*EAA) + (EBA*EBA) + (ECA*ECA);
            const double w48 = (1.0/(w47 + 1.0));
            const double w49 = w48*(EAA*w46 - EBA*w44 + ECA*w40 - w0*w47 + w33);
            const double w50 = -EX0C + w49;
            const double w51 = w48*(-EAA*w40 + EBA*w45 + ECA*w46 - w41*w47 + w43);
            const double w52 = -q_Cz + w41;
            const double w53 = w51 + w52;
            const double w54 = w1 + w50;
            const double w55 = w48*(EAA*w44 + EBA*w46 - ECA*w45 + w39 - w47*w5);
            const double w56 = -EY0C + w55;
            const double w57 = w56 + w6;
            const double w58 = EA0C*w54 + EB0C*w57;
            const double w61 = w60*(EA0C*w58 - EB0C*w53 - w1*w59 + w50);
            const double w62 = w60*(EA0C*w53 + EB0C*w58 + w56 - w59*w6);
            const double w63 = cos_c*w61 + sin_c*w62;
            const double w64 = -EXC + w63;
            const double w65 = cos_c*w6 - sin_c*w1;
            const double w66 = cos_c*w62 - sin_c*w61;
            const double w67 = -EYC + w66;
            const double w68 = w65 + w67;
            const double w69 = w60*(-EA0C*w57 + EB0C*w54 + w51 - w52*w59);
            const double w70 = -EZC + w69;
            const double w71 = w52 + w70;
            const double w72 = w64 + w7;
            const double w73 = EAC*w72 + EBC*w68 + ECC*w71;
            const double w74 = (EAC*EAC) + (EBC*EBC) + (ECC*ECC);
            const double w75 = (1.0/(w74 + 1.0));
            deviation[0 * stride + i] = w75*(EAC*w73 - EBC*w71 + ECC*w68 + w64 - w7*w74);
            deviation[1 * stride + i] = w75*(EAC*w71 + EBC*w73 - ECC*w72 - w65*w74 + w67);
            deviation[2 * stride + i] = w75*(-EAC*w68 + EBC*w72 + ECC*w73 - w52*w74 + w70);
        }
    }
}

/*
 * Deviation of a bed point in the workpiece frame, to first order in the errors.
 * Source: Eqs. (1)-(4). Operations: 106 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z A C (x y z a c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXA EYA EZA EAA EBA ECA EXC EYC EZC EAC EBC ECC)
 * in parameters: 23 values, mm, rad; home positions and location errors (q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz
 *     q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C EA0C EB0C EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the bed frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; bed point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void trunnion_mill_bed_in_workpiece_deviation_first_order(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation)
{
    /* once per call */
    const double q_Ax = parameters[0];
    const double q_Ay = parameters[1];
    const double q_Az = parameters[2];
    const double q_Cx = parameters[3];
    const double q_Cy = parameters[4];
    const double q_Cz = parameters[5];
    const double EC0Y = parameters[12];
    const double EY0A = parameters[13];
    const double EZ0A = parameters[14];
    const double EB0A = parameters[15];
    const double EC0A = parameters[16];
    const double EX0C = parameters[17];
    const double EY0C = parameters[18];
    const double EA0C = parameters[19];
    const double EB0C = parameters[20];
    for (size_t start = 0; start < n; start += BLOCK) {
        const size_t count = n - start < BLOCK ? n - start : (size_t)BLOCK;
        /* cosines and sines */
        double cos_a_block[BLOCK];
        double sin_a_block[BLOCK];
        double cos_c_block[BLOCK];
        double sin_c_block[BLOCK];
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double a = positions[3 * stride + i];
            const double c = positions[4 * stride + i];
            cos_a_block[j] = cos(0.017453292519943295*a);
            sin_a_block[j] = sin(0.017453292519943295*a);
            cos_c_block[j] = cos(0.017453292519943295*c);
            sin_c_block[j] = sin(0.017453292519943295*c);
        }
        /* per point */
        POINTS_ARE_INDEPENDENT
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double cos_a = cos_a_block[j];
            const double sin_a = sin_a_block[j];
            const double cos_c = cos_c_block[j];
            const double sin_c = sin_c_block[j];
            const double y = positions[1 * stride + i];
            const double EXY = errors[6 * stride + i];
            const double EYY = errors[7 * stride + i];
            const double EZY = errors[8 * stride + i];
            const double EAY = errors[9 * stride + i];
            const double EBY = errors[10 * stride + i];
            const double ECY = errors[11 * stride + i];
            const double EXA = errors[18 * stride + i];
            const double EYA = errors[19 * stride + i];
            const double EZA = errors[20 * stride + i];
            const double EAA = errors[21 * stride + i];
            const double EBA = errors[22 * stride + i];
            const double ECA = errors[23 * stride + i];
            const double EXC = errors[24 * stride + i];
            const double EYC = errors[25 * stride + i];
            const double EZC = errors[26 * stride + i];
            const double EAC = errors[27 * stride + i];
            const double EBC = errors[28 * stride + i];
            const double ECC = errors[29 * stride + i];
            const double rx = point[0 * stride + i];
            const double ry = point[1 * stride + i];
            const double rz = point[2 * stride + i];
            const double w0 = ry - y;
            const double w1 = -q_Ay + w0;
            const double w2 = -q_Az + rz;
            const double w3 = cos_a*w2 - sin_a*w1;
            const double w4 = -q_Cz + w3;
            const double w5 = -q_Ax + rx;
            const double w6 = -q_Cx + w5;
            const double w7 = cos_a*w1 + sin_a*w2;
            const double w8 = -q_Cy + w7;
            const double w9 = cos_c*w8 - sin_c*w6;
            const double w10 = EC0Y*ry;
            const double w11 = -EBY*rz + ECY*w0 - EXY + w10;
            const double w12 = -EB0A*w2 + EC0A*w1 + w11;
            const double w13 = -EBA*w3 + ECA*w7 - EXA + w12;
            const double w14 = -EB0C*w4 - EX0C + w13;
            const double w15 = -EC0Y*rx;
            const double w16 = EAY*rz - ECY*rx - EYY + w15;
            const double w17 = -EC0A*w5 - EY0A + w16;
            const double w18 = -EAY*w0 + EBY*rx - EZY;
            const double w19 = EB0A*w5 - EZ0A + w18;
            const double w20 = cos_a*w17 + sin_a*w19;
            const double w21 = EAA*w3 - ECA*w5 - EYA + w20;
            const double w22 = EA0C*w4 - EY0C + w21;
            const double w23 = cos_c*w14 + sin_c*w22;
            const double w24 = cos_c*w6 + sin_c*w8;
            const double w25 = cos_c*w22 - sin_c*w14;
            const double w26 = cos_a*w19 - sin_a*w17;
            const double w27 = -EAA*w7 + EBA*w5 - EZA + w26;
            const double w28 = -EA0C*w8 + EB0C*w6 + w27;
            deviation[0 * stride + i] = -EBC*w4 + ECC*w9 - EXC + w23;
            deviation[1 * stride + i] = EAC*w4 - ECC*w24 - EYC + w25;
            deviation[2 * stride + i] = -EAC*w9 + EBC*w24 - EZC + w28;
        }
    }
}

/*
 * Sensitivity of a bed point in the workpiece frame to every error, at the error-free machine.
 * Source: Eqs. (1)-(4), first order. Operations: 183 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z A C (x y z a c)
 * in parameters: 23 values, mm, rad; home positions and location errors (q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz
 *     q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C EA0C EB0C EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the bed frame (rx ry rz)
 * out sensitivity: 123 rows of stride, mm/mm, mm/rad; derivative of the deviation by each component error, then by
 *     each location error (dx_EXX dx_EYX .. dz_EB0Z, last index fastest)
 */
void trunnion_mill_bed_in_workpiece_sensitivity(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT sensitivity)
{
    /* once per call */
    const double q_Ax = parameters[0];
    const double q_Ay = parameters[1];
    const double q_Az = parameters[2];
    const double q_Cx = parameters[3];
    const double q_Cy = parameters[4];
    const double q_Cz = parameters[5];
    for (size_t start = 0; start < n; start += BLOCK) {
        const size_t count = n - start < BLOCK ? n - start : (size_t)BLOCK;
        /* cosines and sines */
        double cos_a_block[BLOCK];
        double sin_a_block[BLOCK];
        double cos_c_block[BLOCK];
        double sin_c_block[BLOCK];
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double a = positions[3 * stride + i];
            const double c = positions[4 * stride + i];
            cos_a_block[j] = cos(0.017453292519943295*a);
            sin_a_block[j] = sin(0.017453292519943295*a);
            cos_c_block[j] = cos(0.017453292519943295*c);
            sin_c_block[j] = sin(0.017453292519943295*c);
        }
        /* per point */
        POINTS_ARE_INDEPENDENT
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double cos_a = cos_a_block[j];
            const double sin_a = sin_a_block[j];
            const double cos_c = cos_c_block[j];
            const double sin_c = sin_c_block[j];
            const double y = positions[1 * stride + i];
            const double rx = point[0 * stride + i];
            const double ry = point[1 * stride + i];
            const double rz = point[2 * stride + i];
            const double dx_EXY = -cos_c;
            const double w0 = cos_a*sin_c;
            const double dx_EYY = -w0;
            const double w1 = sin_a*sin_c;
            const double dx_EZY = -w1;
            const double w2 = ry*w1;
            const double dx_EAY = rz*w0 + w1*y - w2;
            const double dx_EYA = -sin_c;
            const double w3 = q_Az*w0;
            const double dx_EAA = dx_EAY + q_Ay*w1 - w3;
            const double w4 = cos_c*rz;
            const double w5 = cos_a*w4;
            const double w6 = cos_c*y;
            const double w7 = sin_a*w6;
            const double w8 = cos_c*ry*sin_a;
            const double dy_EAY = w5 + w7 - w8;
            const double w9 = q_Ay*sin_a;
            const double w10 = cos_c*w9;
            const double w11 = cos_a*q_Az;
            const double w12 = cos_c*w11;
            const double dy_EAA = dy_EAY + w10 - w12;
            const double dx_EBC = -cos_a*rz + q_Cz + ry*sin_a - sin_a*y + w11 - w9;
            const double w13 = cos_c*q_Ay;
            const double w14 = cos_c*q_Az;
            const double w15 = -cos_a*cos_c*ry + cos_a*w13 + cos_a*w6 - cos_c*rz*sin_a - q_Ax*sin_c + rx*sin_c +
                sin_a*w14;
            const double dz_EAC = cos_c*q_Cy - q_Cx*sin_c + w15;
            const double dx_EA0C = cos_a*rz*sin_c + q_Ay*sin_a*sin_c - q_Cz*sin_c + sin_a*sin_c*y - w2 - w3;
            const double dx_EB0C = cos_c*q_Cz - w10 + w12 - w5 - w7 + w8;
            const double w16 = cos_a*cos_c;
            const double dy_EYY = -w16;
            const double w17 = cos_c*sin_a;
            const double dy_EZY = -w17;
            const double dy_ECA = cos_c*q_Ax - cos_c*rx + q_Ay*w0 + q_Az*w1 - ry*w0 - rz*w1 + w0*y;
            const double dy_ECC = cos_c*q_Cx + dy_ECA + q_Cy*sin_c;
            const double dz_EZY = -cos_a;
            const double dz_ECY = rx*sin_a;
            const double w18 = cos_a*ry;
            const double w19 = rz*sin_a;
            const double dz_EAA = cos_a*q_Ay + cos_a*y + q_Az*sin_a - w18 - w19;
            const double w20 = -cos_c*ry + rx*w0;
            const double w21 = w20 + w6;
            const double w22 = ry*sin_c;
            const double w23 = rx*w16;
            const double w24 = w22 + w23;
            const double w25 = q_Ax - rx;
            sensitivity[0 * stride + i] = 0.0;
            sensitivity[1 * stride + i] = 0.0;
            sensitivity[2 * stride + i] = 0.0;
            sensitivity[3 * stride + i] = 0.0;
            sensitivity[4 * stride + i] = 0.0;
            sensitivity[5 * stride + i] = 0.0;
            sensitivity[6 * stride + i] = dx_EXY;
            sensitivity[7 * stride + i] = dx_EYY;
            sensitivity[8 * stride + i] = dx_EZY;
            sensitivity[9 * stride + i] = dx_EAY;
            sensitivity[10 * stride + i] = rx*sin_a*sin_c - w4;
            sensitivity[11 * stride + i] = -w21;
            sensitivity[12 * stride + i] = 0.0;
            sensitivity[13 * stride + i] = 0.0;
            sensitivity[14 * stride + i] = 0.0;
            sensitivity[15 * stride + i] = 0.0;
            sensitivity[16 * stride + i] = 0.0;
            sensitivity[17 * stride + i] = 0.0;
            sensitivity[18 * stride + i] = dx_EXY;
            sensitivity[19 * stride + i] = dx_EYA;
            sensitivity[20 * stride + i] = 0.0;
            sensitivity[21 * stride + i] = dx_EAA;
            sensitivity[22 * stride + i] = -dy_EAA;
            sensitivity[23 * stride + i] = -w15;
            sensitivity[24 * stride + i] = -1.0;
            sensitivity[25 * stride + i] = 0.0;
            sensitivity[26 * stride + i] = 0.0;
            sensitivity[27 * stride + i] = 0.0;
            sensitivity[28 * stride + i] = dx_EBC;
            sensitivity[29 * stride + i] = -dz_EAC;
            sensitivity[30 * stride + i] = -w20;
            sensitivity[31 * stride + i] = dx_EYY;
            sensitivity[32 * stride + i] = dx_EZY;
            sensitivity[33 * stride + i] = -q_Ax*w1 + rx*w1 + w14 - w4;
            sensitivity[34 * stride + i] = cos_a*q_Ax*sin_c - w13 - w21;
            sensitivity[35 * stride + i] = dx_EXY;
            sensitivity[36 * stride + i] = dx_EYA;
            sensitivity[37 * stride + i] = dx_EA0C;
            sensitivity[38 * stride + i] = dx_EB0C;
            sensitivity[39 * stride + i] = 0.0;
            sensitivity[40 * stride + i] = 0.0;
            sensitivity[41 * stride + i] = 0.0;
            sensitivity[42 * stride + i] = 0.0;
            sensitivity[43 * stride + i] = 0.0;
            sensitivity[44 * stride + i] = 0.0;
            sensitivity[45 * stride + i] = 0.0;
            sensitivity[46 * stride + i] = 0.0;
            sensitivity[47 * stride + i] = sin_c;
            sensitivity[48 * stride + i] = dy_EYY;
            sensitivity[49 * stride + i] = dy_EZY;
            sensitivity[50 * stride + i] = dy_EAY;
            sensitivity[51 * stride + i] = rx*w17 + rz*sin_c;
            sensitivity[52 * stride + i] = sin_c*y - w24;
            sensitivity[53 * stride + i] = 0.0;
            sensitivity[54 * stride + i] = 0.0;
            sensitivity[55 * stride + i] = 0.0;
            sensitivity[56 * stride + i] = 0.0;
            sensitivity[57 * stride + i] = 0.0;
            sensitivity[58 * stride + i] = 0.0;
            sensitivity[59 * stride + i] = sin_c;
            sensitivity[60 * stride + i] = dx_EXY;
            sensitivity[61 * stride + i] = 0.0;
            sensitivity[62 * stride + i] = dy_EAA;
            sensitivity[63 * stride + i] = dx_EAA;
            sensitivity[64 * stride + i] = dy_ECA;
            sensitivity[65 * stride + i] = 0.0;
            sensitivity[66 * stride + i] = -1.0;
            sensitivity[67 * stride + i] = 0.0;
            sensitivity[68 * stride + i] = -dx_EBC;
            sensitivity[69 * stride + i] = 0.0;
            sensitivity[70 * stride + i] = dy_ECC;
            sensitivity[71 * stride + i] = -w24;
            sensitivity[72 * stride + i] = dy_EYY;
            sensitivity[73 * stride + i] = dy_EZY;
            sensitivity[74 * stride + i] = cos_c*rx*sin_a - q_Ax*w17 - q_Az*sin_c + rz*sin_c;
            sensitivity[75 * stride + i] = q_Ax*w16 + q_Ay*sin_c + sin_c*y - w22 - w23;
            sensitivity[76 * stride + i] = sin_c;
            sensitivity[77 * stride + i] = dx_EXY;
            sensitivity[78 * stride + i] = -dx_EB0C;
            sensitivity[79 * stride + i] = dx_EA0C;
            sensitivity[80 * stride + i] = 0.0;
            sensitivity[81 * stride + i] = 0.0;
            sensitivity[82 * stride + i] = 0.0;
            sensitivity[83 * stride + i] = 0.0;
            sensitivity[84 * stride + i] = 0.0;
            sensitivity[85 * stride + i] = 0.0;
            sensitivity[86 * stride + i] = 0.0;
            sensitivity[87 * stride + i] = 0.0;
            sensitivity[88 * stride + i] = 0.0;
            sensitivity[89 * stride + i] = sin_a;
            sensitivity[90 * stride + i] = dz_EZY;
            sensitivity[91 * stride + i] = cos_a*y - w18 - w19;
            sensitivity[92 * stride + i] = cos_a*rx;
            sensitivity[93 * stride + i] = dz_ECY;
            sensitivity[94 * stride + i] = 0.0;
            sensitivity[95 * stride + i] = 0.0;
            sensitivity[96 * stride + i] = 0.0;
            sensitivity[97 * stride + i] = 0.0;
            sensitivity[98 * stride + i] = 0.0;
            sensitivity[99 * stride + i] = 0.0;
            sensitivity[100 * stride + i] = 0.0;
            sensitivity[101 * stride + i] = 0.0;
            sensitivity[102 * stride + i] = -1.0;
            sensitivity[103 * stride + i] = dz_EAA;
            sensitivity[104 * stride + i] = -w25;
            sensitivity[105 * stride + i] = 0.0;
            sensitivity[106 * stride + i] = 0.0;
            sensitivity[107 * stride + i] = 0.0;
            sensitivity[108 * stride + i] = -1.0;
            sensitivity[109 * stride + i] = dz_EAC;
            sensitivity[110 * stride + i] = -dy_ECC;
            sensitivity[111 * stride + i] = 0.0;
            sensitivity[112 * stride + i] = dz_ECY;
            sensitivity[113 * stride + i] = sin_a;
            sensitivity[114 * stride + i] = dz_EZY;
            sensitivity[115 * stride + i] = -cos_a*q_Ax + cos_a*rx;
            sensitivity[116 * stride + i] = -q_Ax*sin_a + rx*sin_a;
            sensitivity[117 * stride + i] = 0.0;
            sensitivity[118 * stride + i] = 0.0;
            sensitivity[119 * stride + i] = dz_EAA + q_Cy;
            sensitivity[120 * stride + i] = -q_Cx - w25;
            sensitivity[121 * stride + i] = 0.0;
            sensitivity[122 * stride + i] = 0.0;
        }
    }
}

/*
 * Actual position of the tool point in the workpiece frame, exact.
 * Source: Eq. (4). Operations: 303 per point, 13 once per call.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z A C (x y z a c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXA EYA EZA EAA EBA ECA EXC EYC EZC EAC EBC ECC)
 * in parameters: 23 values, mm, rad; home positions and location errors (q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz
 *     q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C EA0C EB0C EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out position: 3 rows of stride, mm; actual position P_T^W of the tool point in the workpiece frame (px py pz)
 */
void trunnion_mill_tool_in_workpiece_position(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT position)
{
    /* once per call */
    const double q_Ax = parameters[0];
    const double q_Ay = parameters[1];
    const double q_Az = parameters[2];
    const double q_Cx = parameters[3];
    const double q_Cy = parameters[4];
    const double q_Cz = parameters[5];
    const double q_wx = parameters[6];
    const double q_wy = parameters[7];
    const double q_wz = parameters[8];
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
    for (size_t start = 0; start < n; start += BLOCK) {
        const size_t count = n - start < BLOCK ? n - start : (size_t)BLOCK;
        /* cosines and sines */
        double cos_a_block[BLOCK];
        double sin_a_block[BLOCK];
        double cos_c_block[BLOCK];
        double sin_c_block[BLOCK];
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double a = positions[3 * stride + i];
            const double c = positions[4 * stride + i];
            cos_a_block[j] = cos(0.017453292519943295*a);
            sin_a_block[j] = sin(0.017453292519943295*a);
            cos_c_block[j] = cos(0.017453292519943295*c);
            sin_c_block[j] = sin(0.017453292519943295*c);
        }
        /* per point */
        POINTS_ARE_INDEPENDENT
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double cos_a = cos_a_block[j];
            const double sin_a = sin_a_block[j];
            const double cos_c = cos_c_block[j];
            const double sin_c = sin_c_block[j];
            const double x = positions[0 * stride + i];
            const double y = positions[1 * stride + i];
            const double z = positions[2 * stride + i];
            const double EXX = errors[0 * stride + i];
            const double EYX = errors[1 * stride + i];
            const double EZX = errors[2 * stride + i];
            const double EAX = errors[3 * stride + i];
            const double EBX = errors[4 * stride + i];
            const double ECX = errors[5 * stride + i];
            const double EXY = errors[6 * stride + i];
            const double EYY = errors[7 * stride + i];
            const double EZY = errors[8 * stride + i];
            const double EAY = errors[9 * stride + i];
            const double EBY = errors[10 * stride + i];
            const double ECY = errors[11 * stride + i];
            const double EXZ = errors[12 * stride + i];
            const double EYZ = errors[13 * stride + i];
            const double EZZ = errors[14 * stride + i];
            const double EAZ = errors[15 * stride + i];
            const double EBZ = errors[16 * stride + i];
            const double ECZ = errors[17 * stride + i];
            const double EXA = errors[18 * stride + i];
            const double EYA = errors[19 * stride + i];
            const double EZA = errors[20 * stride + i];
            const double EAA = errors[21 * stride + i];
            const double EBA = errors[22 * stride + i];
            const double ECA = errors[23 * stride + i];
            const double EXC = errors[24 * stride + i];
            const double EYC = errors[25 * stride + i];
            const double EZC = errors[26 * stride + i];
            const double EAC = errors[27 * stride + i];
            const double EBC = errors[28 * stride + i];
            const double ECC = errors[29 * stride + i];
            const double rx = point[0 * stride + i];
            const double ry = point[1 * stride + i];
            const double rz = point[2 * stride + i];
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
            const double w97 = w96*(EAC*w94 - EBC*w92 + ECC*w89 - w12*w95 + w85);
            const double w98 = -q_wx + w12;
            const double w99 = w96*(EAC*w92 + EBC*w94 - ECC*w93 - w86*w95 + w88);
            const double w100 = -q_wy + w86;
            const double w101 = w96*(-EAC*w89 + EBC*w93 + ECC*w94 - w73*w95 + w91);
            const double w102 = -q_wz + w73;
            position[0 * stride + i] = w97 + w98;
            position[1 * stride + i] = w100 + w99;
            position[2 * stride + i] = w101 + w102;
        }
    }
}

/*
 * Actual position of the tool point in the workpiece frame, to first order.
 * Source: Eq. (4). Operations: 154 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z A C (x y z a c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXA EYA EZA EAA EBA ECA EXC EYC EZC EAC EBC ECC)
 * in parameters: 23 values, mm, rad; home positions and location errors (q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz
 *     q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C EA0C EB0C EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out position: 3 rows of stride, mm; actual position P_T^W of the tool point in the workpiece frame (px py pz)
 */
void trunnion_mill_tool_in_workpiece_position_first_order(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT position)
{
    /* once per call */
    const double q_Ax = parameters[0];
    const double q_Ay = parameters[1];
    const double q_Az = parameters[2];
    const double q_Cx = parameters[3];
    const double q_Cy = parameters[4];
    const double q_Cz = parameters[5];
    const double q_wx = parameters[6];
    const double q_wy = parameters[7];
    const double q_wz = parameters[8];
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
    for (size_t start = 0; start < n; start += BLOCK) {
        const size_t count = n - start < BLOCK ? n - start : (size_t)BLOCK;
        /* cosines and sines */
        double cos_a_block[BLOCK];
        double sin_a_block[BLOCK];
        double cos_c_block[BLOCK];
        double sin_c_block[BLOCK];
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double a = positions[3 * stride + i];
            const double c = positions[4 * stride + i];
            cos_a_block[j] = cos(0.017453292519943295*a);
            sin_a_block[j] = sin(0.017453292519943295*a);
            cos_c_block[j] = cos(0.017453292519943295*c);
            sin_c_block[j] = sin(0.017453292519943295*c);
        }
        /* per point */
        POINTS_ARE_INDEPENDENT
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double cos_a = cos_a_block[j];
            const double sin_a = sin_a_block[j];
            const double cos_c = cos_c_block[j];
            const double sin_c = sin_c_block[j];
            const double x = positions[0 * stride + i];
            const double y = positions[1 * stride + i];
            const double z = positions[2 * stride + i];
            const double EXX = errors[0 * stride + i];
            const double EYX = errors[1 * stride + i];
            const double EZX = errors[2 * stride + i];
            const double EAX = errors[3 * stride + i];
            const double EBX = errors[4 * stride + i];
            const double ECX = errors[5 * stride + i];
            const double EXY = errors[6 * stride + i];
            const double EYY = errors[7 * stride + i];
            const double EZY = errors[8 * stride + i];
            const double EAY = errors[9 * stride + i];
            const double EBY = errors[10 * stride + i];
            const double ECY = errors[11 * stride + i];
            const double EXZ = errors[12 * stride + i];
            const double EYZ = errors[13 * stride + i];
            const double EZZ = errors[14 * stride + i];
            const double EAZ = errors[15 * stride + i];
            const double EBZ = errors[16 * stride + i];
            const double ECZ = errors[17 * stride + i];
            const double EXA = errors[18 * stride + i];
            const double EYA = errors[19 * stride + i];
            const double EZA = errors[20 * stride + i];
            const double EAA = errors[21 * stride + i];
            const double EBA = errors[22 * stride + i];
            const double ECA = errors[23 * stride + i];
            const double EXC = errors[24 * stride + i];
            const double EYC = errors[25 * stride + i];
            const double EZC = errors[26 * stride + i];
            const double EAC = errors[27 * stride + i];
            const double EBC = errors[28 * stride + i];
            const double ECC = errors[29 * stride + i];
            const double rx = point[0 * stride + i];
            const double ry = point[1 * stride + i];
            const double rz = point[2 * stride + i];
            const double w0 = q_Ty + ry;
            const double w1 = w0 - y;
            const double w2 = -q_Ay + w1;
            const double w3 = q_Tz + rz;
            const double w4 = w3 + z;
            const double w5 = -q_Az + w4;
            const double w6 = cos_a*w5 - sin_a*w2;
            const double w7 = -q_Cz + w6;
            const double w8 = q_Tx + rx;
            const double w9 = w8 + x;
            const double w10 = -q_Ax + w9;
            const double w11 = -q_Cx + w10;
            const double w12 = cos_a*w2 + sin_a*w5;
            const double w13 = -q_Cy + w12;
            const double w14 = cos_c*w13 - sin_c*w11;
            const double w15 = EBZ*w3 - ECZ*w0 + EXZ;
            const double w16 = EB0Z*w4 + w15;
            const double w17 = EBX*w4 - ECX*w0 + EXX + w16;
            const double w18 = EC0Y*w0 + w17;
            const double w19 = -EBY*w4 + ECY*w1 - EXY + w18;
            const double w20 = -EB0A*w5 + EC0A*w2 + w19;
            const double w21 = -EBA*w6 + ECA*w12 - EXA + w20;
            const double w22 = -EB0C*w7 - EX0C + w21;
            const double w23 = -EAZ*w3 + ECZ*w8 + EYZ;
            const double w24 = -EA0Z*w4 + w23;
            const double w25 = -EAX*w4 + ECX*w8 + EYX + w24;
            const double w26 = -EC0Y*w9 + w25;
            const double w27 = EAY*w4 - ECY*w9 - EYY + w26;
            const double w28 = -EC0A*w10 - EY0A + w27;
            const double w29 = EAZ*w0 - EBZ*w8 + EZZ;
            const double w30 = EA0Z*w0 - EB0Z*w8 + w29;
            const double w31 = EAX*w0 - EBX*w8 + EZX + w30;
            const double w32 = -EAY*w1 + EBY*w9 - EZY + w31;
            const double w33 = EB0A*w10 - EZ0A + w32;
            const double w34 = cos_a*w28 + sin_a*w33;
            const double w35 = EAA*w6 - ECA*w10 - EYA + w34;
            const double w36 = EA0C*w7 - EY0C + w35;
            const double w37 = cos_c*w22 + sin_c*w36;
            const double w38 = -EBC*w7 + ECC*w14 - EXC + w37;
            const double w39 = cos_c*w11 + sin_c*w13;
            const double w40 = -q_wx + w39;
            const double w41 = cos_c*w36 - sin_c*w22;
            const double w42 = EAC*w7 - ECC*w39 - EYC + w41;
            const double w43 = -q_wy + w14;
            const double w44 = cos_a*w33 - sin_a*w28;
            const double w45 = -EAA*w12 + EBA*w10 - EZA + w44;
            const double w46 = -EA0C*w13 + EB0C*w11 + w45;
            const double w47 = -EAC*w14 + EBC*w39 - EZC + w46;
            const double w48 = -q_wz + w7;
            position[0 * stride + i] = w38 + w40;
            position[1 * stride + i] = w42 + w43;
            position[2 * stride + i] = w47 + w48;
        }
    }
}

/*
 * Ideal direction of a vector of the tool frame in the workpiece frame.
 * Source: Eqs. (1)-(4) without errors, rotations alone. Operations: 20 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z A C (x y z a c)
 * in direction: 3 rows of stride, 1; unit vector in the tool frame, (0, 0, 1) for the tool axis (tx ty tz)
 * out ideal: 3 rows of stride, 1; the vector in the workpiece frame, without errors (ix iy iz)
 */
void trunnion_mill_tool_orientation_ideal(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT direction,
    double *TRUEAXIS_RESTRICT ideal)
{
    for (size_t start = 0; start < n; start += BLOCK) {
        const size_t count = n - start < BLOCK ? n - start : (size_t)BLOCK;
        /* cosines and sines */
        double cos_a_block[BLOCK];
        double sin_a_block[BLOCK];
        double cos_c_block[BLOCK];
        double sin_c_block[BLOCK];
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double a = positions[3 * stride + i];
            const double c = positions[4 * stride + i];
            cos_a_block[j] = cos(0.017453292519943295*a);
            sin_a_block[j] = sin(0.017453292519943295*a);
            cos_c_block[j] = cos(0.017453292519943295*c);
            sin_c_block[j] = sin(0.017453292519943295*c);
        }
        /* per point */
        POINTS_ARE_INDEPENDENT
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double cos_a = cos_a_block[j];
            const double sin_a = sin_a_block[j];
            const double cos_c = cos_c_block[j];
            const double sin_c = sin_c_block[j];
            const double tx = direction[0 * stride + i];
            const double ty = direction[1 * stride + i];
            const double tz = direction[2 * stride + i];
            const double w0 = cos_a*ty + sin_a*tz;
            ideal[0 * stride + i] = cos_c*tx + sin_c*w0;
            ideal[1 * stride + i] = cos_c*w0 - sin_c*tx;
            ideal[2 * stride + i] = cos_a*tz - sin_a*ty;
        }
    }
}

/*
 * Deviation of a direction of the tool frame in the workpiece frame, exact.
 * Source: Eqs. (1)-(4), rotations alone. Operations: 266 per point, 13 once per call.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z A C (x y z a c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXA EYA EZA EAA EBA ECA EXC EYC EZC EAC EBC ECC)
 * in parameters: 23 values, mm, rad; home positions and location errors (q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz
 *     q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C EA0C EB0C EA0Z EB0Z)
 * in direction: 3 rows of stride, 1; unit vector in the tool frame, (0, 0, 1) for the tool axis (tx ty tz)
 * out deviation: 3 rows of stride, 1; the vector in the workpiece frame, actual minus ideal (dx dy dz)
 */
void trunnion_mill_tool_orientation_deviation(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT direction,
    double *TRUEAXIS_RESTRICT deviation)
{
    /* once per call */
    const double EC0Y = parameters[12];
    const double EB0A = parameters[15];
    const double EC0A = parameters[16];
    const double EA0C = parameters[19];
    const double EB0C = parameters[20];
    const double EA0Z = parameters[21];
    const double EB0Z = parameters[22];
    const double w15 = (EC0Y*EC0Y);
    const double w16 = (1.0/(w15 + 1.0));
    const double w35 = (EB0A*EB0A) + (EC0A*EC0A);
    const double w36 = (1.0/(w35 + 1.0));
    const double w58 = (EA0C*EA0C) + (EB0C*EB0C);
    const double w59 = (1.0/(w58 + 1.0));
    for (size_t start = 0; start < n; start += BLOCK) {
        const size_t count = n - start < BLOCK ? n - start : (size_t)BLOCK;
        /* cosines and sines */
        double cos_a_block[BLOCK];
        double sin_a_block[BLOCK];
        double cos_c_block[BLOCK];
        double sin_c_block[BLOCK];
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double a = positions[3 * stride + i];
            const double c = positions[4 * stride + i];
            cos_a_block[j] = cos(0.017453292519943295*a);
            sin_a_block[j] = sin(0.017453292519943295*a);
            cos_c_block[j] = cos(0.017453292519943295*c);
            sin_c_block[j] = sin(0.017453292519943295*c);
        }
        /* per point */
        POINTS_ARE_INDEPENDENT
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double cos_a = cos_a_block[j];
            const double sin_a = sin_a_block[j];
            const double cos_c = cos_c_block[j];
            const double sin_c = sin_c_block[j];
            const double EAX = errors[3 * stride + i];
            const double EBX = errors[4 * stride + i];
            const double ECX = errors[5 * stride + i];
            const double EAY = errors[9 * stride + i];
            const double EBY = errors[10 * stride + i];
            const double ECY = errors[11 * stride + i];
            const double EAZ = errors[15 * stride + i];
            const double EBZ = errors[16 * stride + i];
            const double ECZ = errors[17 * stride + i];
            const double EAA = errors[21 * stride + i];
            const double EBA = errors[22 * stride + i];
            const double ECA = errors[23 * stride + i];
            const double EAC = errors[27 * stride + i];
            const double EBC = errors[28 * stride + i];
            const double ECC = errors[29 * stride + i];
            const double tx = direction[0 * stride + i];
            const double ty = direction[1 * stride + i];
            const double tz = direction[2 * stride + i];
            const double w0 = cos_a*ty + sin_a*tz;
            const double w1 = cos_c*tx + sin_c*w0;
            const double w2 = EBZ*tz - ECZ*ty;
            const double w3 = -EAZ*tz + ECZ*tx;
            const double w4 = EAZ*ty - EBZ*tx;
            const double w5 = EA0Z*(ty + w3) - EB0Z*(tx + w2) + w4;
            const double w6 = tz + w5;
            const double w7 = tz + w4;
            const double w8 = -EA0Z*w7 + w3;
            const double w9 = ty + w8;
            const double w10 = EB0Z*w7 + w2;
            const double w11 = EBX*w6 - ECX*w9 + w10;
            const double w12 = tx + w10;
            const double w13 = -EAX*w6 + ECX*w12 + w8;
            const double w14 = ty + w13;
            const double w17 = w16*(EC0Y*w14 - tx*w15 + w11);
            const double w18 = tx + w11;
            const double w19 = w16*(-EC0Y*w18 - ty*w15 + w13);
            const double w20 = ty + w19;
            const double w21 = EAX*w9 - EBX*w12 + w5;
            const double w22 = tz + w21;
            const double w23 = EC0Y*w22;
            const double w24 = w16*(EC0Y*w23 - tz*w15 + w21);
            const double w25 = tz + w24;
            const double w26 = tx + w17;
            const double w27 = EAY*w26 + EBY*w20 + ECY*w25;
            const double w28 = (EAY*EAY) + (EBY*EBY) + (ECY*ECY);
            const double w29 = (1.0/(w28 + 1.0));
            const double w30 = w29*(EAY*w27 - EBY*w25 + ECY*w20 - tx*w28 + w17);
            const double w31 = w29*(EAY*w25 + EBY*w27 - ECY*w26 - ty*w28 + w19);
            const double w32 = ty + w31;
            const double w33 = w29*(-EAY*w20 + EBY*w26 + ECY*w27 - tz*w28 + w24);
            const double w34 = tz + w33;
            const double w37 = w36*(-EB0A*w34 + EC0A*w32 - tx*w35 + w30);
            const double w38 = tx + w30;
            const double w39 = EB0A*w32 + EC0A*w34;
            const double w40 = w36*(EB0A*w39 - EC0A*w38 - ty*w35 + w31);
            const double w41 = w36*(EB0A*w38 + EC0A*w39 - tz*w35 + w33);
            const double w42 = cos_a*w40 + sin_a*w41;
            const double w43 = w0 + w42;
            const double w44 = cos_a*tz - sin_a*ty;
            const double w45 = cos_a*w41 - sin_a*w40;
            const double w46 = w44 + w45;
            const double w47 = tx + w37;
            const double w48 = EAA*w47 + EBA*w43 + ECA*w46;
            const double w49 = (EAA*EAA) + (EBA*EBA) + (ECA*ECA);
            const double w50 = (1.0/(w49 + 1.0));
            const double w51 = w50*(EAA*w48 - EBA*w46 + ECA*w43 - tx*w49 + w37);
            const double w52 = w50*(-EAA*w43 + EBA*w47 + ECA*w48 - w44*w49 + w45);
            const double w53 = w44 + w52;
            const double w54 = tx + w51;
            const double w55 = w50*(EAA*w46 + EBA*w48 - ECA*w47 - w0*w49 + w42);
            const double w56 = w0 + w55;
            const double w57 = EA0C*w54 + EB0C*w56;
            const double w60 = w59*(EA0C*w57 - EB0C*w53 - tx*w58 + w51);
            const double w61 = w59*(EA0C*w53 + EB0C*w57 - w0*w58 + w55);
            const double w62 = cos_c*w60 + sin_c*w61;
            const double w63 = cos_c*w0 - sin_c*tx;
            const double w64 = cos_c*w61 - sin_c*w60;
            const double w65 = w63 + w64;
            const double w66 = w59*(-EA0C*w56 + EB0C*w54 - w44*w58 + w52);
            const double w67 = w44 + w66;
            const double w68 = w1 + w62;
            const double w69 = EAC*w68 + EBC*w65 + ECC*w67;
            const double w70 = (EAC*EAC) + (EBC*EBC) + (ECC*ECC);
            const double w71 = (1.0/(w70 + 1.0));
            deviation[0 * stride + i] = w71*(EAC*w69 - EBC*w67 + ECC*w65 - w1*w70 + w62);
            deviation[1 * stride + i] = w71*(EAC*w67 + EBC*w69 - ECC*w68 - w63*w70 + w64);
            deviation[2 * stride + i] = w71*(-EAC*w65 + EBC*w68 + ECC*w69 - w44*w70 + w66);
        }
    }
}

/*
 * Deviation of a direction of the tool frame in the workpiece frame, to first order.
 * Source: Eqs. (1)-(4), rotations alone. Operations: 117 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z A C (x y z a c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXA EYA EZA EAA EBA ECA EXC EYC EZC EAC EBC ECC)
 * in parameters: 23 values, mm, rad; home positions and location errors (q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz
 *     q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C EA0C EB0C EA0Z EB0Z)
 * in direction: 3 rows of stride, 1; unit vector in the tool frame, (0, 0, 1) for the tool axis (tx ty tz)
 * out deviation: 3 rows of stride, 1; the vector in the workpiece frame, actual minus ideal (dx dy dz)
 */
void trunnion_mill_tool_orientation_deviation_first_order(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT direction,
    double *TRUEAXIS_RESTRICT deviation)
{
    /* once per call */
    const double EC0Y = parameters[12];
    const double EB0A = parameters[15];
    const double EC0A = parameters[16];
    const double EA0C = parameters[19];
    const double EB0C = parameters[20];
    const double EA0Z = parameters[21];
    const double EB0Z = parameters[22];
    for (size_t start = 0; start < n; start += BLOCK) {
        const size_t count = n - start < BLOCK ? n - start : (size_t)BLOCK;
        /* cosines and sines */
        double cos_a_block[BLOCK];
        double sin_a_block[BLOCK];
        double cos_c_block[BLOCK];
        double sin_c_block[BLOCK];
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double a = positions[3 * stride + i];
            const double c = positions[4 * stride + i];
            cos_a_block[j] = cos(0.017453292519943295*a);
            sin_a_block[j] = sin(0.017453292519943295*a);
            cos_c_block[j] = cos(0.017453292519943295*c);
            sin_c_block[j] = sin(0.017453292519943295*c);
        }
        /* per point */
        POINTS_ARE_INDEPENDENT
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double cos_a = cos_a_block[j];
            const double sin_a = sin_a_block[j];
            const double cos_c = cos_c_block[j];
            const double sin_c = sin_c_block[j];
            const double EAX = errors[3 * stride + i];
            const double EBX = errors[4 * stride + i];
            const double ECX = errors[5 * stride + i];
            const double EAY = errors[9 * stride + i];
            const double EBY = errors[10 * stride + i];
            const double ECY = errors[11 * stride + i];
            const double EAZ = errors[15 * stride + i];
            const double EBZ = errors[16 * stride + i];
            const double ECZ = errors[17 * stride + i];
            const double EAA = errors[21 * stride + i];
            const double EBA = errors[22 * stride + i];
            const double ECA = errors[23 * stride + i];
            const double EAC = errors[27 * stride + i];
            const double EBC = errors[28 * stride + i];
            const double ECC = errors[29 * stride + i];
            const double tx = direction[0 * stride + i];
            const double ty = direction[1 * stride + i];
            const double tz = direction[2 * stride + i];
            const double w0 = cos_a*tz - sin_a*ty;
            const double w1 = cos_a*ty + sin_a*tz;
            const double w2 = cos_c*w1 - sin_c*tx;
            const double w3 = EBZ*tz - ECZ*ty;
            const double w4 = EB0Z*tz + w3;
            const double w5 = EBX*tz - ECX*ty + w4;
            const double w6 = EC0Y*ty + w5;
            const double w7 = -EBY*tz + ECY*ty + w6;
            const double w8 = -EB0A*tz + EC0A*ty + w7;
            const double w9 = -EBA*w0 + ECA*w1 + w8;
            const double w10 = -EB0C*w0 + w9;
            const double w11 = -EAZ*tz + ECZ*tx;
            const double w12 = -EA0Z*tz + w11;
            const double w13 = -EAX*tz + ECX*tx + w12;
            const double w14 = -EC0Y*tx + w13;
            const double w15 = EAY*tz - ECY*tx + w14;
            const double w16 = -EC0A*tx + w15;
            const double w17 = EAZ*ty - EBZ*tx;
            const double w18 = EA0Z*ty - EB0Z*tx + w17;
            const double w19 = EAX*ty - EBX*tx + w18;
            const double w20 = -EAY*ty + EBY*tx + w19;
            const double w21 = EB0A*tx + w20;
            const double w22 = cos_a*w16 + sin_a*w21;
            const double w23 = EAA*w0 - ECA*tx + w22;
            const double w24 = EA0C*w0 + w23;
            const double w25 = cos_c*w10 + sin_c*w24;
            const double w26 = cos_c*tx + sin_c*w1;
            const double w27 = cos_c*w24 - sin_c*w10;
            const double w28 = cos_a*w21 - sin_a*w16;
            const double w29 = -EAA*w1 + EBA*tx + w28;
            const double w30 = -EA0C*w1 + EB0C*tx + w29;
            deviation[0 * stride + i] = -EBC*w0 + ECC*w2 + w25;
            deviation[1 * stride + i] = EAC*w0 - ECC*w26 + w27;
            deviation[2 * stride + i] = -EAC*w2 + EBC*w26 + w30;
        }
    }
}

/*
 * Deviation of the tool point under polynomial error curves, exact.
 * Source: Eqs. (1)-(4), (44). Operations: 684 per point, 16 once per call.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z A C (x y z a c)
 * in curves: 210 values, mm/mm^k, rad/mm^k (deg^k for rotary axes); coefficients of the powers 1 to 7 of the axis
 *     position, per component error (EXX_1 EXX_2 .. ECC_7, last index fastest)
 * in parameters: 23 values, mm, rad; home positions and location errors (q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz
 *     q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C EA0C EB0C EA0Z EB0Z)
 * in point: 3 values, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; tool point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void trunnion_mill_tool_in_workpiece_deviation_curves(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT curves,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation)
{
    /* once per call */
    const double EXX_1 = curves[0];
    const double EXX_2 = curves[1];
    const double EXX_3 = curves[2];
    const double EXX_4 = curves[3];
    const double EXX_5 = curves[4];
    const double EXX_6 = curves[5];
    const double EXX_7 = curves[6];
    const double EYX_1 = curves[7];
    const double EYX_2 = curves[8];
    const double EYX_3 = curves[9];
    const double EYX_4 = curves[10];
    const double EYX_5 = curves[11];
    const double EYX_6 = curves[12];
    const double EYX_7 = curves[13];
    const double EZX_1 = curves[14];
    const double EZX_2 = curves[15];
    const double EZX_3 = curves[16];
    const double EZX_4 = curves[17];
    const double EZX_5 = curves[18];
    const double EZX_6 = curves[19];
    const double EZX_7 = curves[20];
    const double EAX_1 = curves[21];
    const double EAX_2 = curves[22];
    const double EAX_3 = curves[23];
    const double EAX_4 = curves[24];
    const double EAX_5 = curves[25];
    const double EAX_6 = curves[26];
    const double EAX_7 = curves[27];
    const double EBX_1 = curves[28];
    const double EBX_2 = curves[29];
    const double EBX_3 = curves[30];
    const double EBX_4 = curves[31];
    const double EBX_5 = curves[32];
    const double EBX_6 = curves[33];
    const double EBX_7 = curves[34];
    const double ECX_1 = curves[35];
    const double ECX_2 = curves[36];
    const double ECX_3 = curves[37];
    const double ECX_4 = curves[38];
    const double ECX_5 = curves[39];
    const double ECX_6 = curves[40];
    const double ECX_7 = curves[41];
    const double EXY_1 = curves[42];
    const double EXY_2 = curves[43];
    const double EXY_3 = curves[44];
    const double EXY_4 = curves[45];
    const double EXY_5 = curves[46];
    const double EXY_6 = curves[47];
    const double EXY_7 = curves[48];
    const double EYY_1 = curves[49];
    const double EYY_2 = curves[50];
    const double EYY_3 = curves[51];
    const double EYY_4 = curves[52];
    const double EYY_5 = curves[53];
    const double EYY_6 = curves[54];
    const double EYY_7 = curves[55];
    const double EZY_1 = curves[56];
    const double EZY_2 = curves[57];
    const double EZY_3 = curves[58];
    const double EZY_4 = curves[59];
    const double EZY_5 = curves[60];
    const double EZY_6 = curves[61];
    const double EZY_7 = curves[62];
    const double EAY_1 = curves[63];
    const double EAY_2 = curves[64];
    const double EAY_3 = curves[65];
    const double EAY_4 = curves[66];
    const double EAY_5 = curves[67];
    const double EAY_6 = curves[68];
    const double EAY_7 = curves[69];
    const double EBY_1 = curves[70];
    const double EBY_2 = curves[71];
    const double EBY_3 = curves[72];
    const double EBY_4 = curves[73];
    const double EBY_5 = curves[74];
    const double EBY_6 = curves[75];
    const double EBY_7 = curves[76];
    const double ECY_1 = curves[77];
    const double ECY_2 = curves[78];
    const double ECY_3 = curves[79];
    const double ECY_4 = curves[80];
    const double ECY_5 = curves[81];
    const double ECY_6 = curves[82];
    const double ECY_7 = curves[83];
    const double EXZ_1 = curves[84];
    const double EXZ_2 = curves[85];
    const double EXZ_3 = curves[86];
    const double EXZ_4 = curves[87];
    const double EXZ_5 = curves[88];
    const double EXZ_6 = curves[89];
    const double EXZ_7 = curves[90];
    const double EYZ_1 = curves[91];
    const double EYZ_2 = curves[92];
    const double EYZ_3 = curves[93];
    const double EYZ_4 = curves[94];
    const double EYZ_5 = curves[95];
    const double EYZ_6 = curves[96];
    const double EYZ_7 = curves[97];
    const double EZZ_1 = curves[98];
    const double EZZ_2 = curves[99];
    const double EZZ_3 = curves[100];
    const double EZZ_4 = curves[101];
    const double EZZ_5 = curves[102];
    const double EZZ_6 = curves[103];
    const double EZZ_7 = curves[104];
    const double EAZ_1 = curves[105];
    const double EAZ_2 = curves[106];
    const double EAZ_3 = curves[107];
    const double EAZ_4 = curves[108];
    const double EAZ_5 = curves[109];
    const double EAZ_6 = curves[110];
    const double EAZ_7 = curves[111];
    const double EBZ_1 = curves[112];
    const double EBZ_2 = curves[113];
    const double EBZ_3 = curves[114];
    const double EBZ_4 = curves[115];
    const double EBZ_5 = curves[116];
    const double EBZ_6 = curves[117];
    const double EBZ_7 = curves[118];
    const double ECZ_1 = curves[119];
    const double ECZ_2 = curves[120];
    const double ECZ_3 = curves[121];
    const double ECZ_4 = curves[122];
    const double ECZ_5 = curves[123];
    const double ECZ_6 = curves[124];
    const double ECZ_7 = curves[125];
    const double EXA_1 = curves[126];
    const double EXA_2 = curves[127];
    const double EXA_3 = curves[128];
    const double EXA_4 = curves[129];
    const double EXA_5 = curves[130];
    const double EXA_6 = curves[131];
    const double EXA_7 = curves[132];
    const double EYA_1 = curves[133];
    const double EYA_2 = curves[134];
    const double EYA_3 = curves[135];
    const double EYA_4 = curves[136];
    const double EYA_5 = curves[137];
    const double EYA_6 = curves[138];
    const double EYA_7 = curves[139];
    const double EZA_1 = curves[140];
    const double EZA_2 = curves[141];
    const double EZA_3 = curves[142];
    const double EZA_4 = curves[143];
    const double EZA_5 = curves[144];
    const double EZA_6 = curves[145];
    const double EZA_7 = curves[146];
    const double EAA_1 = curves[147];
    const double EAA_2 = curves[148];
    const double EAA_3 = curves[149];
    const double EAA_4 = curves[150];
    const double EAA_5 = curves[151];
    const double EAA_6 = curves[152];
    const double EAA_7 = curves[153];
    const double EBA_1 = curves[154];
    const double EBA_2 = curves[155];
    const double EBA_3 = curves[156];
    const double EBA_4 = curves[157];
    const double EBA_5 = curves[158];
    const double EBA_6 = curves[159];
    const double EBA_7 = curves[160];
    const double ECA_1 = curves[161];
    const double ECA_2 = curves[162];
    const double ECA_3 = curves[163];
    const double ECA_4 = curves[164];
    const double ECA_5 = curves[165];
    const double ECA_6 = curves[166];
    const double ECA_7 = curves[167];
    const double EXC_1 = curves[168];
    const double EXC_2 = curves[169];
    const double EXC_3 = curves[170];
    const double EXC_4 = curves[171];
    const double EXC_5 = curves[172];
    const double EXC_6 = curves[173];
    const double EXC_7 = curves[174];
    const double EYC_1 = curves[175];
    const double EYC_2 = curves[176];
    const double EYC_3 = curves[177];
    const double EYC_4 = curves[178];
    const double EYC_5 = curves[179];
    const double EYC_6 = curves[180];
    const double EYC_7 = curves[181];
    const double EZC_1 = curves[182];
    const double EZC_2 = curves[183];
    const double EZC_3 = curves[184];
    const double EZC_4 = curves[185];
    const double EZC_5 = curves[186];
    const double EZC_6 = curves[187];
    const double EZC_7 = curves[188];
    const double EAC_1 = curves[189];
    const double EAC_2 = curves[190];
    const double EAC_3 = curves[191];
    const double EAC_4 = curves[192];
    const double EAC_5 = curves[193];
    const double EAC_6 = curves[194];
    const double EAC_7 = curves[195];
    const double EBC_1 = curves[196];
    const double EBC_2 = curves[197];
    const double EBC_3 = curves[198];
    const double EBC_4 = curves[199];
    const double EBC_5 = curves[200];
    const double EBC_6 = curves[201];
    const double EBC_7 = curves[202];
    const double ECC_1 = curves[203];
    const double ECC_2 = curves[204];
    const double ECC_3 = curves[205];
    const double ECC_4 = curves[206];
    const double ECC_5 = curves[207];
    const double ECC_6 = curves[208];
    const double ECC_7 = curves[209];
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
    const double rx = point[0];
    const double ry = point[1];
    const double rz = point[2];
    const double w3 = q_Tx + rx;
    const double w7 = q_Ty + ry;
    const double w10 = q_Tz + rz;
    const double w49 = (EC0Y*EC0Y);
    const double w50 = (1.0/(w49 + 1.0));
    const double w77 = (EB0A*EB0A) + (EC0A*EC0A);
    const double w78 = (1.0/(w77 + 1.0));
    const double w108 = (EA0C*EA0C) + (EB0C*EB0C);
    const double w109 = (1.0/(w108 + 1.0));
    for (size_t start = 0; start < n; start += BLOCK) {
        const size_t count = n - start < BLOCK ? n - start : (size_t)BLOCK;
        /* cosines and sines */
        double cos_a_block[BLOCK];
        double sin_a_block[BLOCK];
        double cos_c_block[BLOCK];
        double sin_c_block[BLOCK];
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double a = positions[3 * stride + i];
            const double c = positions[4 * stride + i];
            cos_a_block[j] = cos(0.017453292519943295*a);
            sin_a_block[j] = sin(0.017453292519943295*a);
            cos_c_block[j] = cos(0.017453292519943295*c);
            sin_c_block[j] = sin(0.017453292519943295*c);
        }
        /* per point */
        POINTS_ARE_INDEPENDENT
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double cos_a = cos_a_block[j];
            const double sin_a = sin_a_block[j];
            const double cos_c = cos_c_block[j];
            const double sin_c = sin_c_block[j];
            const double x = positions[0 * stride + i];
            const double y = positions[1 * stride + i];
            const double z = positions[2 * stride + i];
            const double a = positions[3 * stride + i];
            const double c = positions[4 * stride + i];
            const double w0 = c*(EAC_1 + c*(EAC_2 + c*(EAC_3 + c*(EAC_4 + c*(EAC_5 + c*(EAC_6 + EAC_7*c))))));
            const double w1 = c*(EBC_1 + c*(EBC_2 + c*(EBC_3 + c*(EBC_4 + c*(EBC_5 + c*(EBC_6 + EBC_7*c))))));
            const double w2 = c*(ECC_1 + c*(ECC_2 + c*(ECC_3 + c*(ECC_4 + c*(ECC_5 + c*(ECC_6 + ECC_7*c))))));
            const double w4 = w3 + x;
            const double w5 = -q_Ax + w4;
            const double w6 = -q_Cx + w5;
            const double w8 = w7 - y;
            const double w9 = -q_Ay + w8;
            const double w11 = w10 + z;
            const double w12 = -q_Az + w11;
            const double w13 = cos_a*w9 + sin_a*w12;
            const double w14 = -q_Cy + w13;
            const double w15 = cos_c*w6 + sin_c*w14;
            const double w16 = c*(EXC_1 + c*(EXC_2 + c*(EXC_3 + c*(EXC_4 + c*(EXC_5 + c*(EXC_6 + EXC_7*c))))));
            const double w17 = a*(EAA_1 + a*(EAA_2 + a*(EAA_3 + a*(EAA_4 + a*(EAA_5 + a*(EAA_6 + EAA_7*a))))));
            const double w18 = a*(EBA_1 + a*(EBA_2 + a*(EBA_3 + a*(EBA_4 + a*(EBA_5 + a*(EBA_6 + EBA_7*a))))));
            const double w19 = a*(ECA_1 + a*(ECA_2 + a*(ECA_3 + a*(ECA_4 + a*(ECA_5 + a*(ECA_6 + ECA_7*a))))));
            const double w20 = a*(EXA_1 + a*(EXA_2 + a*(EXA_3 + a*(EXA_4 + a*(EXA_5 + a*(EXA_6 + EXA_7*a))))));
            const double w21 = y*(EAY_1 + y*(EAY_2 + y*(EAY_3 + y*(EAY_4 + y*(EAY_5 + y*(EAY_6 + EAY_7*y))))));
            const double w22 = y*(EBY_1 + y*(EBY_2 + y*(EBY_3 + y*(EBY_4 + y*(EBY_5 + y*(EBY_6 + EBY_7*y))))));
            const double w23 = y*(ECY_1 + y*(ECY_2 + y*(ECY_3 + y*(ECY_4 + y*(ECY_5 + y*(ECY_6 + ECY_7*y))))));
            const double w24 = y*(EXY_1 + y*(EXY_2 + y*(EXY_3 + y*(EXY_4 + y*(EXY_5 + y*(EXY_6 + EXY_7*y))))));
            const double w25 = z*(EXZ_1 + z*(EXZ_2 + z*(EXZ_3 + z*(EXZ_4 + z*(EXZ_5 + z*(EXZ_6 + EXZ_7*z))))));
            const double w26 = z*(EBZ_1 + z*(EBZ_2 + z*(EBZ_3 + z*(EBZ_4 + z*(EBZ_5 + z*(EBZ_6 + EBZ_7*z))))));
            const double w27 = z*(ECZ_1 + z*(ECZ_2 + z*(ECZ_3 + z*(ECZ_4 + z*(ECZ_5 + z*(ECZ_6 + ECZ_7*z))))));
            const double w28 = w10*w26 + w25 - w27*w7;
            const double w29 = z*(EYZ_1 + z*(EYZ_2 + z*(EYZ_3 + z*(EYZ_4 + z*(EYZ_5 + z*(EYZ_6 + EYZ_7*z))))));
            const double w30 = z*(EAZ_1 + z*(EAZ_2 + z*(EAZ_3 + z*(EAZ_4 + z*(EAZ_5 + z*(EAZ_6 + EAZ_7*z))))));
            const double w31 = -w10*w30 + w27*w3 + w29;
            const double w32 = z*(EZZ_1 + z*(EZZ_2 + z*(EZZ_3 + z*(EZZ_4 + z*(EZZ_5 + z*(EZZ_6 + EZZ_7*z))))));
            const double w33 = -w26*w3 + w30*w7 + w32;
            const double w34 = EA0Z*(w31 + w7) - EB0Z*(w28 + w3) + w33;
            const double w35 = w11 + w34;
            const double w36 = w11 + w33;
            const double w37 = -EA0Z*w36 + w31;
            const double w38 = w37 + w7;
            const double w39 = x*(EXX_1 + x*(EXX_2 + x*(EXX_3 + x*(EXX_4 + x*(EXX_5 + x*(EXX_6 + EXX_7*x))))));
            const double w40 = x*(EBX_1 + x*(EBX_2 + x*(EBX_3 + x*(EBX_4 + x*(EBX_5 + x*(EBX_6 + EBX_7*x))))));
            const double w41 = x*(ECX_1 + x*(ECX_2 + x*(ECX_3 + x*(ECX_4 + x*(ECX_5 + x*(ECX_6 + ECX_7*x))))));
            const double w42 = EB0Z*w36 + w28;
            const double w43 = w35*w40 - w38*w41 + w39 + w42;
            const double w44 = w3 + w42;
            const double w45 = x*(EYX_1 + x*(EYX_2 + x*(EYX_3 + x*(EYX_4 + x*(EYX_5 + x*(EYX_6 + EYX_7*x))))));
            const double w46 = x*(EAX_1 + x*(EAX_2 + x*(EAX_3 + x*(EAX_4 + x*(EAX_5 + x*(EAX_6 + EAX_7*x))))));
            const double w47 = -w35*w46 + w37 + w41*w44 + w45;
            const double w48 = w47 + w7;
            const double w51 = w50*(EC0Y*w48 - w4*w49 + w43);
            const double w52 = -w24 + w51;
            const double w53 = y*(EYY_1 + y*(EYY_2 + y*(EYY_3 + y*(EYY_4 + y*(EYY_5 + y*(EYY_6 + EYY_7*y))))));
            const double w54 = w4 + w43;
            const double w55 = w50*(-EC0Y*w54 + w47 - w49*w7);
            const double w56 = -w53 + w55;
            const double w57 = w56 + w8;
            const double w58 = y*(EZY_1 + y*(EZY_2 + y*(EZY_3 + y*(EZY_4 + y*(EZY_5 + y*(EZY_6 + EZY_7*y))))));
            const double w59 = x*(EZX_1 + x*(EZX_2 + x*(EZX_3 + x*(EZX_4 + x*(EZX_5 + x*(EZX_6 + EZX_7*x))))));
            const double w60 = w34 + w38*w46 - w40*w44 + w59;
            const double w61 = w11 + w60;
            const double w62 = EC0Y*w61;
            const double w63 = w50*(EC0Y*w62 - w11*w49 + w60);
            const double w64 = -w58 + w63;
            const double w65 = w11 + w64;
            const double w66 = w4 + w52;
            const double w67 = w21*w66 + w22*w57 + w23*w65;
            const double w68 = (w21*w21) + (w22*w22) + (w23*w23);
            const double w69 = (1.0/(w68 + 1.0));
            const double w70 = w69*(w21*w67 - w22*w65 + w23*w57 - w4*w68 + w52);
            const double w71 = w69*(w21*w65 + w22*w67 - w23*w66 + w56 - w68*w8);
            const double w72 = -EY0A + w71;
            const double w73 = w72 + w9;
            const double w74 = w69*(-w11*w68 - w21*w57 + w22*w66 + w23*w67 + w64);
            const double w75 = -EZ0A + w74;
            const double w76 = w12 + w75;
            const double w79 = w78*(-EB0A*w76 + EC0A*w73 - w5*w77 + w70);
            const double w80 = -w20 + w79;
            const double w81 = a*(EYA_1 + a*(EYA_2 + a*(EYA_3 + a*(EYA_4 + a*(EYA_5 + a*(EYA_6 + EYA_7*a))))));
            const double w82 = w5 + w70;
            const double w83 = EB0A*w73 + EC0A*w76;
            const double w84 = w78*(EB0A*w83 - EC0A*w82 + w72 - w77*w9);
            const double w85 = w78*(EB0A*w82 + EC0A*w83 - w12*w77 + w75);
            const double w86 = cos_a*w84 + sin_a*w85;
            const double w87 = -w81 + w86;
            const double w88 = w13 + w87;
            const double w89 = cos_a*w12 - sin_a*w9;
            const double w90 = a*(EZA_1 + a*(EZA_2 + a*(EZA_3 + a*(EZA_4 + a*(EZA_5 + a*(EZA_6 + EZA_7*a))))));
            const double w91 = cos_a*w85 - sin_a*w84;
            const double w92 = -w90 + w91;
            const double w93 = w89 + w92;
            const double w94 = w5 + w80;
            const double w95 = w17*w94 + w18*w88 + w19*w93;
            const double w96 = (w17*w17) + (w18*w18) + (w19*w19);
            const double w97 = (1.0/(w96 + 1.0));
            const double w98 = w97*(w17*w95 - w18*w93 + w19*w88 - w5*w96 + w80);
            const double w99 = -EX0C + w98;
            const double w100 = w97*(-w17*w88 + w18*w94 + w19*w95 - w89*w96 + w92);
            const double w101 = -q_Cz + w89;
            const double w102 = w100 + w101;
            const double w103 = w6 + w99;
            const double w104 = w97*(-w13*w96 + w17*w93 + w18*w95 - w19*w94 + w87);
            const double w105 = -EY0C + w104;
            const double w106 = w105 + w14;
            const double w107 = EA0C*w103 + EB0C*w106;
            const double w110 = w109*(EA0C*w107 - EB0C*w102 - w108*w6 + w99);
            const double w111 = w109*(EA0C*w102 + EB0C*w107 + w105 - w108*w14);
            const double w112 = cos_c*w110 + sin_c*w111;
            const double w113 = w112 - w16;
            const double w114 = cos_c*w14 - sin_c*w6;
            const double w115 = c*(EYC_1 + c*(EYC_2 + c*(EYC_3 + c*(EYC_4 + c*(EYC_5 + c*(EYC_6 + EYC_7*c))))));
            const double w116 = cos_c*w111 - sin_c*w110;
            const double w117 = -w115 + w116;
            const double w118 = w114 + w117;
            const double w119 = c*(EZC_1 + c*(EZC_2 + c*(EZC_3 + c*(EZC_4 + c*(EZC_5 + c*(EZC_6 + EZC_7*c))))));
            const double w120 = w109*(-EA0C*w106 + EB0C*w103 + w100 - w101*w108);
            const double w121 = -w119 + w120;
            const double w122 = w101 + w121;
            const double w123 = w113 + w15;
            const double w124 = w0*w123 + w1*w118 + w122*w2;
            const double w125 = (w0*w0) + (w1*w1) + (w2*w2);
            const double w126 = (1.0/(w125 + 1.0));
            deviation[0 * stride + i] = w126*(w0*w124 - w1*w122 + w113 + w118*w2 - w125*w15);
            deviation[1 * stride + i] = w126*(w0*w122 + w1*w124 - w114*w125 + w117 - w123*w2);
            deviation[2 * stride + i] = w126*(-w0*w118 + w1*w123 - w101*w125 + w121 + w124*w2);
        }
    }
}

/*
 * Deviation of the tool point under polynomial error curves, to first order.
 * Source: Eqs. (1)-(4), (44). Operations: 535 per point, 3 once per call.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z A C (x y z a c)
 * in curves: 210 values, mm/mm^k, rad/mm^k (deg^k for rotary axes); coefficients of the powers 1 to 7 of the axis
 *     position, per component error (EXX_1 EXX_2 .. ECC_7, last index fastest)
 * in parameters: 23 values, mm, rad; home positions and location errors (q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz
 *     q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C EA0C EB0C EA0Z EB0Z)
 * in point: 3 values, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; tool point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void trunnion_mill_tool_in_workpiece_deviation_first_order_curves(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT curves,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation)
{
    /* once per call */
    const double EXX_1 = curves[0];
    const double EXX_2 = curves[1];
    const double EXX_3 = curves[2];
    const double EXX_4 = curves[3];
    const double EXX_5 = curves[4];
    const double EXX_6 = curves[5];
    const double EXX_7 = curves[6];
    const double EYX_1 = curves[7];
    const double EYX_2 = curves[8];
    const double EYX_3 = curves[9];
    const double EYX_4 = curves[10];
    const double EYX_5 = curves[11];
    const double EYX_6 = curves[12];
    const double EYX_7 = curves[13];
    const double EZX_1 = curves[14];
    const double EZX_2 = curves[15];
    const double EZX_3 = curves[16];
    const double EZX_4 = curves[17];
    const double EZX_5 = curves[18];
    const double EZX_6 = curves[19];
    const double EZX_7 = curves[20];
    const double EAX_1 = curves[21];
    const double EAX_2 = curves[22];
    const double EAX_3 = curves[23];
    const double EAX_4 = curves[24];
    const double EAX_5 = curves[25];
    const double EAX_6 = curves[26];
    const double EAX_7 = curves[27];
    const double EBX_1 = curves[28];
    const double EBX_2 = curves[29];
    const double EBX_3 = curves[30];
    const double EBX_4 = curves[31];
    const double EBX_5 = curves[32];
    const double EBX_6 = curves[33];
    const double EBX_7 = curves[34];
    const double ECX_1 = curves[35];
    const double ECX_2 = curves[36];
    const double ECX_3 = curves[37];
    const double ECX_4 = curves[38];
    const double ECX_5 = curves[39];
    const double ECX_6 = curves[40];
    const double ECX_7 = curves[41];
    const double EXY_1 = curves[42];
    const double EXY_2 = curves[43];
    const double EXY_3 = curves[44];
    const double EXY_4 = curves[45];
    const double EXY_5 = curves[46];
    const double EXY_6 = curves[47];
    const double EXY_7 = curves[48];
    const double EYY_1 = curves[49];
    const double EYY_2 = curves[50];
    const double EYY_3 = curves[51];
    const double EYY_4 = curves[52];
    const double EYY_5 = curves[53];
    const double EYY_6 = curves[54];
    const double EYY_7 = curves[55];
    const double EZY_1 = curves[56];
    const double EZY_2 = curves[57];
    const double EZY_3 = curves[58];
    const double EZY_4 = curves[59];
    const double EZY_5 = curves[60];
    const double EZY_6 = curves[61];
    const double EZY_7 = curves[62];
    const double EAY_1 = curves[63];
    const double EAY_2 = curves[64];
    const double EAY_3 = curves[65];
    const double EAY_4 = curves[66];
    const double EAY_5 = curves[67];
    const double EAY_6 = curves[68];
    const double EAY_7 = curves[69];
    const double EBY_1 = curves[70];
    const double EBY_2 = curves[71];
    const double EBY_3 = curves[72];
    const double EBY_4 = curves[73];
    const double EBY_5 = curves[74];
    const double EBY_6 = curves[75];
    const double EBY_7 = curves[76];
    const double ECY_1 = curves[77];
    const double ECY_2 = curves[78];
    const double ECY_3 = curves[79];
    const double ECY_4 = curves[80];
    const double ECY_5 = curves[81];
    const double ECY_6 = curves[82];
    const double ECY_7 = curves[83];
    const double EXZ_1 = curves[84];
    const double EXZ_2 = curves[85];
    const double EXZ_3 = curves[86];
    const double EXZ_4 = curves[87];
    const double EXZ_5 = curves[88];
    const double EXZ_6 = curves[89];
    const double EXZ_7 = curves[90];
    const double EYZ_1 = curves[91];
    const double EYZ_2 = curves[92];
    const double EYZ_3 = curves[93];
    const double EYZ_4 = curves[94];
    const double EYZ_5 = curves[95];
    const double EYZ_6 = curves[96];
    const double EYZ_7 = curves[97];
    const double EZZ_1 = curves[98];
    const double EZZ_2 = curves[99];
    const double EZZ_3 = curves[100];
    const double EZZ_4 = curves[101];
    const double EZZ_5 = curves[102];
    const double EZZ_6 = curves[103];
    const double EZZ_7 = curves[104];
    const double EAZ_1 = curves[105];
    const double EAZ_2 = curves[106];
    const double EAZ_3 = curves[107];
    const double EAZ_4 = curves[108];
    const double EAZ_5 = curves[109];
    const double EAZ_6 = curves[110];
    const double EAZ_7 = curves[111];
    const double EBZ_1 = curves[112];
    const double EBZ_2 = curves[113];
    const double EBZ_3 = curves[114];
    const double EBZ_4 = curves[115];
    const double EBZ_5 = curves[116];
    const double EBZ_6 = curves[117];
    const double EBZ_7 = curves[118];
    const double ECZ_1 = curves[119];
    const double ECZ_2 = curves[120];
    const double ECZ_3 = curves[121];
    const double ECZ_4 = curves[122];
    const double ECZ_5 = curves[123];
    const double ECZ_6 = curves[124];
    const double ECZ_7 = curves[125];
    const double EXA_1 = curves[126];
    const double EXA_2 = curves[127];
    const double EXA_3 = curves[128];
    const double EXA_4 = curves[129];
    const double EXA_5 = curves[130];
    const double EXA_6 = curves[131];
    const double EXA_7 = curves[132];
    const double EYA_1 = curves[133];
    const double EYA_2 = curves[134];
    const double EYA_3 = curves[135];
    const double EYA_4 = curves[136];
    const double EYA_5 = curves[137];
    const double EYA_6 = curves[138];
    const double EYA_7 = curves[139];
    const double EZA_1 = curves[140];
    const double EZA_2 = curves[141];
    const double EZA_3 = curves[142];
    const double EZA_4 = curves[143];
    const double EZA_5 = curves[144];
    const double EZA_6 = curves[145];
    const double EZA_7 = curves[146];
    const double EAA_1 = curves[147];
    const double EAA_2 = curves[148];
    const double EAA_3 = curves[149];
    const double EAA_4 = curves[150];
    const double EAA_5 = curves[151];
    const double EAA_6 = curves[152];
    const double EAA_7 = curves[153];
    const double EBA_1 = curves[154];
    const double EBA_2 = curves[155];
    const double EBA_3 = curves[156];
    const double EBA_4 = curves[157];
    const double EBA_5 = curves[158];
    const double EBA_6 = curves[159];
    const double EBA_7 = curves[160];
    const double ECA_1 = curves[161];
    const double ECA_2 = curves[162];
    const double ECA_3 = curves[163];
    const double ECA_4 = curves[164];
    const double ECA_5 = curves[165];
    const double ECA_6 = curves[166];
    const double ECA_7 = curves[167];
    const double EXC_1 = curves[168];
    const double EXC_2 = curves[169];
    const double EXC_3 = curves[170];
    const double EXC_4 = curves[171];
    const double EXC_5 = curves[172];
    const double EXC_6 = curves[173];
    const double EXC_7 = curves[174];
    const double EYC_1 = curves[175];
    const double EYC_2 = curves[176];
    const double EYC_3 = curves[177];
    const double EYC_4 = curves[178];
    const double EYC_5 = curves[179];
    const double EYC_6 = curves[180];
    const double EYC_7 = curves[181];
    const double EZC_1 = curves[182];
    const double EZC_2 = curves[183];
    const double EZC_3 = curves[184];
    const double EZC_4 = curves[185];
    const double EZC_5 = curves[186];
    const double EZC_6 = curves[187];
    const double EZC_7 = curves[188];
    const double EAC_1 = curves[189];
    const double EAC_2 = curves[190];
    const double EAC_3 = curves[191];
    const double EAC_4 = curves[192];
    const double EAC_5 = curves[193];
    const double EAC_6 = curves[194];
    const double EAC_7 = curves[195];
    const double EBC_1 = curves[196];
    const double EBC_2 = curves[197];
    const double EBC_3 = curves[198];
    const double EBC_4 = curves[199];
    const double EBC_5 = curves[200];
    const double EBC_6 = curves[201];
    const double EBC_7 = curves[202];
    const double ECC_1 = curves[203];
    const double ECC_2 = curves[204];
    const double ECC_3 = curves[205];
    const double ECC_4 = curves[206];
    const double ECC_5 = curves[207];
    const double ECC_6 = curves[208];
    const double ECC_7 = curves[209];
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
    const double rx = point[0];
    const double ry = point[1];
    const double rz = point[2];
    const double w3 = q_Ty + ry;
    const double w6 = q_Tz + rz;
    const double w11 = q_Tx + rx;
    for (size_t start = 0; start < n; start += BLOCK) {
        const size_t count = n - start < BLOCK ? n - start : (size_t)BLOCK;
        /* cosines and sines */
        double cos_a_block[BLOCK];
        double sin_a_block[BLOCK];
        double cos_c_block[BLOCK];
        double sin_c_block[BLOCK];
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double a = positions[3 * stride + i];
            const double c = positions[4 * stride + i];
            cos_a_block[j] = cos(0.017453292519943295*a);
            sin_a_block[j] = sin(0.017453292519943295*a);
            cos_c_block[j] = cos(0.017453292519943295*c);
            sin_c_block[j] = sin(0.017453292519943295*c);
        }
        /* per point */
        POINTS_ARE_INDEPENDENT
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double cos_a = cos_a_block[j];
            const double sin_a = sin_a_block[j];
            const double cos_c = cos_c_block[j];
            const double sin_c = sin_c_block[j];
            const double x = positions[0 * stride + i];
            const double y = positions[1 * stride + i];
            const double z = positions[2 * stride + i];
            const double a = positions[3 * stride + i];
            const double c = positions[4 * stride + i];
            const double w0 = c*(EXC_1 + c*(EXC_2 + c*(EXC_3 + c*(EXC_4 + c*(EXC_5 + c*(EXC_6 + EXC_7*c))))));
            const double w1 = c*(EBC_1 + c*(EBC_2 + c*(EBC_3 + c*(EBC_4 + c*(EBC_5 + c*(EBC_6 + EBC_7*c))))));
            const double w2 = c*(ECC_1 + c*(ECC_2 + c*(ECC_3 + c*(ECC_4 + c*(ECC_5 + c*(ECC_6 + ECC_7*c))))));
            const double w4 = w3 - y;
            const double w5 = -q_Ay + w4;
            const double w7 = w6 + z;
            const double w8 = -q_Az + w7;
            const double w9 = cos_a*w8 - sin_a*w5;
            const double w10 = -q_Cz + w9;
            const double w12 = w11 + x;
            const double w13 = -q_Ax + w12;
            const double w14 = -q_Cx + w13;
            const double w15 = cos_a*w5 + sin_a*w8;
            const double w16 = -q_Cy + w15;
            const double w17 = cos_c*w16 - sin_c*w14;
            const double w18 = a*(EXA_1 + a*(EXA_2 + a*(EXA_3 + a*(EXA_4 + a*(EXA_5 + a*(EXA_6 + EXA_7*a))))));
            const double w19 = a*(EBA_1 + a*(EBA_2 + a*(EBA_3 + a*(EBA_4 + a*(EBA_5 + a*(EBA_6 + EBA_7*a))))));
            const double w20 = a*(ECA_1 + a*(ECA_2 + a*(ECA_3 + a*(ECA_4 + a*(ECA_5 + a*(ECA_6 + ECA_7*a))))));
            const double w21 = y*(EXY_1 + y*(EXY_2 + y*(EXY_3 + y*(EXY_4 + y*(EXY_5 + y*(EXY_6 + EXY_7*y))))));
            const double w22 = y*(EBY_1 + y*(EBY_2 + y*(EBY_3 + y*(EBY_4 + y*(EBY_5 + y*(EBY_6 + EBY_7*y))))));
            const double w23 = y*(ECY_1 + y*(ECY_2 + y*(ECY_3 + y*(ECY_4 + y*(ECY_5 + y*(ECY_6 + ECY_7*y))))));
            const double w24 = x*(EXX_1 + x*(EXX_2 + x*(EXX_3 + x*(EXX_4 + x*(EXX_5 + x*(EXX_6 + EXX_7*x))))));
            const double w25 = x*(EBX_1 + x*(EBX_2 + x*(EBX_3 + x*(EBX_4 + x*(EBX_5 + x*(EBX_6 + EBX_7*x))))));
            const double w26 = x*(ECX_1 + x*(ECX_2 + x*(ECX_3 + x*(ECX_4 + x*(ECX_5 + x*(ECX_6 + ECX_7*x))))));
            const double w27 = z*(EXZ_1 + z*(EXZ_2 + z*(EXZ_3 + z*(EXZ_4 + z*(EXZ_5 + z*(EXZ_6 + EXZ_7*z))))));
            const double w28 = z*(EBZ_1 + z*(EBZ_2 + z*(EBZ_3 + z*(EBZ_4 + z*(EBZ_5 + z*(EBZ_6 + EBZ_7*z))))));
            const double w29 = z*(ECZ_1 + z*(ECZ_2 + z*(ECZ_3 + z*(ECZ_4 + z*(ECZ_5 + z*(ECZ_6 + ECZ_7*z))))));
            const double w30 = w27 + w28*w6 - w29*w3;
            const double w31 = EB0Z*w7 + w30;
            const double w32 = w24 + w25*w7 - w26*w3 + w31;
            const double w33 = EC0Y*w3 + w32;
            const double w34 = -w21 - w22*w7 + w23*w4 + w33;
            const double w35 = -EB0A*w8 + EC0A*w5 + w34;
            const double w36 = w15*w20 - w18 - w19*w9 + w35;
            const double w37 = -EB0C*w10 - EX0C + w36;
            const double w38 = a*(EYA_1 + a*(EYA_2 + a*(EYA_3 + a*(EYA_4 + a*(EYA_5 + a*(EYA_6 + EYA_7*a))))));
            const double w39 = a*(EAA_1 + a*(EAA_2 + a*(EAA_3 + a*(EAA_4 + a*(EAA_5 + a*(EAA_6 + EAA_7*a))))));
            const double w40 = y*(EYY_1 + y*(EYY_2 + y*(EYY_3 + y*(EYY_4 + y*(EYY_5 + y*(EYY_6 + EYY_7*y))))));
            const double w41 = y*(EAY_1 + y*(EAY_2 + y*(EAY_3 + y*(EAY_4 + y*(EAY_5 + y*(EAY_6 + EAY_7*y))))));
            const double w42 = x*(EYX_1 + x*(EYX_2 + x*(EYX_3 + x*(EYX_4 + x*(EYX_5 + x*(EYX_6 + EYX_7*x))))));
            const double w43 = x*(EAX_1 + x*(EAX_2 + x*(EAX_3 + x*(EAX_4 + x*(EAX_5 + x*(EAX_6 + EAX_7*x))))));
            const double w44 = z*(EYZ_1 + z*(EYZ_2 + z*(EYZ_3 + z*(EYZ_4 + z*(EYZ_5 + z*(EYZ_6 + EYZ_7*z))))));
            const double w45 = z*(EAZ_1 + z*(EAZ_2 + z*(EAZ_3 + z*(EAZ_4 + z*(EAZ_5 + z*(EAZ_6 + EAZ_7*z))))));
            const double w46 = w11*w29 + w44 - w45*w6;
            const double w47 = -EA0Z*w7 + w46;
            const double w48 = w11*w26 + w42 - w43*w7 + w47;
            const double w49 = -EC0Y*w12 + w48;
            const double w50 = -w12*w23 - w40 + w41*w7 + w49;
            const double w51 = -EC0A*w13 - EY0A + w50;
            const double w52 = y*(EZY_1 + y*(EZY_2 + y*(EZY_3 + y*(EZY_4 + y*(EZY_5 + y*(EZY_6 + EZY_7*y))))));
            const double w53 = x*(EZX_1 + x*(EZX_2 + x*(EZX_3 + x*(EZX_4 + x*(EZX_5 + x*(EZX_6 + EZX_7*x))))));
            const double w54 = z*(EZZ_1 + z*(EZZ_2 + z*(EZZ_3 + z*(EZZ_4 + z*(EZZ_5 + z*(EZZ_6 + EZZ_7*z))))));
            const double w55 = -w11*w28 + w3*w45 + w54;
            const double w56 = EA0Z*w3 - EB0Z*w11 + w55;
            const double w57 = -w11*w25 + w3*w43 + w53 + w56;
            const double w58 = w12*w22 - w4*w41 - w52 + w57;
            const double w59 = EB0A*w13 - EZ0A + w58;
            const double w60 = cos_a*w51 + sin_a*w59;
            const double w61 = -w13*w20 - w38 + w39*w9 + w60;
            const double w62 = EA0C*w10 - EY0C + w61;
            const double w63 = cos_c*w37 + sin_c*w62;
            const double w64 = c*(EYC_1 + c*(EYC_2 + c*(EYC_3 + c*(EYC_4 + c*(EYC_5 + c*(EYC_6 + EYC_7*c))))));
            const double w65 = c*(EAC_1 + c*(EAC_2 + c*(EAC_3 + c*(EAC_4 + c*(EAC_5 + c*(EAC_6 + EAC_7*c))))));
            const double w66 = cos_c*w14 + sin_c*w16;
            const double w67 = cos_c*w62 - sin_c*w37;
            const double w68 = c*(EZC_1 + c*(EZC_2 + c*(EZC_3 + c*(EZC_4 + c*(EZC_5 + c*(EZC_6 + EZC_7*c))))));
            const double w69 = a*(EZA_1 + a*(EZA_2 + a*(EZA_3 + a*(EZA_4 + a*(EZA_5 + a*(EZA_6 + EZA_7*a))))));
            const double w70 = cos_a*w59 - sin_a*w51;
            const double w71 = w13*w19 - w15*w39 - w69 + w70;
            const double w72 = -EA0C*w16 + EB0C*w14 + w71;
            deviation[0 * stride + i] = -w0 - w1*w10 + w17*w2 + w63;
            deviation[1 * stride + i] = w10*w65 - w2*w66 - w64 + w67;
            deviation[2 * stride + i] = w1*w66 - w17*w65 - w68 + w72;
        }
    }
}

/*
 * Positioning error of a ball bar between a tool ball and a workpiece ball, exact.
 * Source: Eqs. (5), (6). Operations: 336 per point, 13 once per call.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z A C (x y z a c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXA EYA EZA EAA EBA ECA EXC EYC EZC EAC EBC ECC)
 * in parameters: 23 values, mm, rad; home positions and location errors (q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz
 *     q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C EA0C EB0C EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * in ball: 3 rows of stride, mm; point in the workpiece frame (bx by bz)
 * in length: 1 rows of stride, mm; ideal length of the ball bar (length)
 * out error: 4 rows of stride, mm; positioning error E, then its components E_x, E_y, E_z (e ex ey ez)
 */
void trunnion_mill_ballbar_error(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    const double *TRUEAXIS_RESTRICT ball,
    const double *TRUEAXIS_RESTRICT length,
    double *TRUEAXIS_RESTRICT error)
{
    /* once per call */
    const double q_Ax = parameters[0];
    const double q_Ay = parameters[1];
    const double q_Az = parameters[2];
    const double q_Cx = parameters[3];
    const double q_Cy = parameters[4];
    const double q_Cz = parameters[5];
    const double q_wx = parameters[6];
    const double q_wy = parameters[7];
    const double q_wz = parameters[8];
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
    for (size_t start = 0; start < n; start += BLOCK) {
        const size_t count = n - start < BLOCK ? n - start : (size_t)BLOCK;
        /* cosines and sines */
        double cos_a_block[BLOCK];
        double sin_a_block[BLOCK];
        double cos_c_block[BLOCK];
        double sin_c_block[BLOCK];
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double a = positions[3 * stride + i];
            const double c = positions[4 * stride + i];
            cos_a_block[j] = cos(0.017453292519943295*a);
            sin_a_block[j] = sin(0.017453292519943295*a);
            cos_c_block[j] = cos(0.017453292519943295*c);
            sin_c_block[j] = sin(0.017453292519943295*c);
        }
        /* per point */
        POINTS_ARE_INDEPENDENT
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double cos_a = cos_a_block[j];
            const double sin_a = sin_a_block[j];
            const double cos_c = cos_c_block[j];
            const double sin_c = sin_c_block[j];
            const double x = positions[0 * stride + i];
            const double y = positions[1 * stride + i];
            const double z = positions[2 * stride + i];
            const double EXX = errors[0 * stride + i];
            const double EYX = errors[1 * stride + i];
            const double EZX = errors[2 * stride + i];
            const double EAX = errors[3 * stride + i];
            const double EBX = errors[4 * stride + i];
            const double ECX = errors[5 * stride + i];
            const double EXY = errors[6 * stride + i];
            const double EYY = errors[7 * stride + i];
            const double EZY = errors[8 * stride + i];
            const double EAY = errors[9 * stride + i];
            const double EBY = errors[10 * stride + i];
            const double ECY = errors[11 * stride + i];
            const double EXZ = errors[12 * stride + i];
            const double EYZ = errors[13 * stride + i];
            const double EZZ = errors[14 * stride + i];
            const double EAZ = errors[15 * stride + i];
            const double EBZ = errors[16 * stride + i];
            const double ECZ = errors[17 * stride + i];
            const double EXA = errors[18 * stride + i];
            const double EYA = errors[19 * stride + i];
            const double EZA = errors[20 * stride + i];
            const double EAA = errors[21 * stride + i];
            const double EBA = errors[22 * stride + i];
            const double ECA = errors[23 * stride + i];
            const double EXC = errors[24 * stride + i];
            const double EYC = errors[25 * stride + i];
            const double EZC = errors[26 * stride + i];
            const double EAC = errors[27 * stride + i];
            const double EBC = errors[28 * stride + i];
            const double ECC = errors[29 * stride + i];
            const double rx = point[0 * stride + i];
            const double ry = point[1 * stride + i];
            const double rz = point[2 * stride + i];
            const double bx = ball[0 * stride + i];
            const double by = ball[1 * stride + i];
            const double bz = ball[2 * stride + i];
            const double length_ = length[0 * stride + i];
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
            const double w97 = w96*(EAC*w94 - EBC*w92 + ECC*w89 - w12*w95 + w85);
            const double w98 = w96*(EAC*w92 + EBC*w94 - ECC*w93 - w86*w95 + w88);
            const double w99 = w96*(-EAC*w89 + EBC*w93 + ECC*w94 - w73*w95 + w91);
            const double w100 = -q_wx + w12;
            const double w101 = -bx + w100;
            const double w102 = -q_wy + w86;
            const double w103 = -by + w102;
            const double w104 = -q_wz + w73;
            const double w105 = -bz + w104;
            const double w106 = w101 + w97;
            const double w107 = w103 + w98;
            const double w108 = w105 + w99;
            const double w109 = sqrt((w101*w101) + (w103*w103) + (w105*w105));
            const double w110 = sqrt((w106*w106) + (w107*w107) + (w108*w108));
            const double e = -length_ + w109 + (w97*(w101 + w106) + w98*(w103 + w107) + w99*(w105 + w108))/(w109 +
                w110);
            const double w111 = e/w110;
            error[0 * stride + i] = e;
            error[1 * stride + i] = w106*w111;
            error[2 * stride + i] = w107*w111;
            error[3 * stride + i] = w108*w111;
        }
    }
}

/*
 * Moves of the linear axes that displace the ideal tool point by the given vector.
 * Source: Eqs. (53)-(55), inverse. Operations: 23 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z A C (x y z a c)
 * in deviation: 3 rows of stride, mm; displacement of the tool point in the workpiece frame (dx dy dz)
 * out moves: 3 rows of stride, mm; moves of X Y Z (move_x move_y move_z)
 */
void trunnion_mill_correction(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT deviation,
    double *TRUEAXIS_RESTRICT moves)
{
    for (size_t start = 0; start < n; start += BLOCK) {
        const size_t count = n - start < BLOCK ? n - start : (size_t)BLOCK;
        /* cosines and sines */
        double cos_a_block[BLOCK];
        double sin_a_block[BLOCK];
        double cos_c_block[BLOCK];
        double sin_c_block[BLOCK];
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double a = positions[3 * stride + i];
            const double c = positions[4 * stride + i];
            cos_a_block[j] = cos(0.017453292519943295*a);
            sin_a_block[j] = sin(0.017453292519943295*a);
            cos_c_block[j] = cos(0.017453292519943295*c);
            sin_c_block[j] = sin(0.017453292519943295*c);
        }
        /* per point */
        POINTS_ARE_INDEPENDENT
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double cos_a = cos_a_block[j];
            const double sin_a = sin_a_block[j];
            const double cos_c = cos_c_block[j];
            const double sin_c = sin_c_block[j];
            const double dx = deviation[0 * stride + i];
            const double dy = deviation[1 * stride + i];
            const double dz = deviation[2 * stride + i];
            const double w0 = cos_c*dy;
            const double w1 = dx*sin_c;
            moves[0 * stride + i] = cos_c*dx - dy*sin_c;
            moves[1 * stride + i] = -cos_a*w0 - cos_a*w1 + dz*sin_a;
            moves[2 * stride + i] = cos_a*dz + sin_a*w0 + sin_a*w1;
        }
    }
}

/*
 * Motion equation of X: displacement of the tool point since home, to first order.
 * Source: Eqs. (7)-(11). Operations: 16 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z A C (x y z a c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXA EYA EZA EAA EBA ECA EXC EYC EZC EAC EBC ECC)
 * in parameters: 23 values, mm, rad; home positions and location errors (q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz
 *     q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C EA0C EB0C EA0Z EB0Z)
 * in tool_point: 3 rows of stride, mm; point in the tool frame (rTx rTy rTz)
 * out displacement: 3 rows of stride, mm; tool point, displacement since home, in the bed frame (dx dy dz)
 */
void trunnion_mill_motion_X(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT tool_point,
    double *TRUEAXIS_RESTRICT displacement)
{
    /* once per call */
    const double q_Tx = parameters[9];
    const double q_Ty = parameters[10];
    const double q_Tz = parameters[11];
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
        const double x = positions[0 * stride + i];
        const double EXX = errors[0 * stride + i];
        const double EYX = errors[1 * stride + i];
        const double EZX = errors[2 * stride + i];
        const double EAX = errors[3 * stride + i];
        const double EBX = errors[4 * stride + i];
        const double ECX = errors[5 * stride + i];
        const double rTx = tool_point[0 * stride + i];
        const double rTy = tool_point[1 * stride + i];
        const double rTz = tool_point[2 * stride + i];
        const double w0 = q_Tz + rTz;
        const double w1 = q_Ty + rTy;
        const double w2 = q_Tx + rTx;
        displacement[0 * stride + i] = EBX*w0 - ECX*w1 + EXX + x;
        displacement[1 * stride + i] = -EAX*w0 + ECX*w2 + EYX;
        displacement[2 * stride + i] = EAX*w1 - EBX*w2 + EZX;
    }
}

/*
 * Motion equation of Y: displacement of the workpiece point since home, to first order.
 * Source: Eqs. (7)-(11). Operations: 24 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z A C (x y z a c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXA EYA EZA EAA EBA ECA EXC EYC EZC EAC EBC ECC)
 * in parameters: 23 values, mm, rad; home positions and location errors (q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz
 *     q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C EA0C EB0C EA0Z EB0Z)
 * in workpiece_point: 3 rows of stride, mm; point in the workpiece frame (rWx rWy rWz)
 * out displacement: 3 rows of stride, mm; workpiece point, displacement since home, in the bed frame (dx dy dz)
 */
void trunnion_mill_motion_Y(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT workpiece_point,
    double *TRUEAXIS_RESTRICT displacement)
{
    /* once per call */
    const double q_Ax = parameters[0];
    const double q_Ay = parameters[1];
    const double q_Az = parameters[2];
    const double q_Cx = parameters[3];
    const double q_Cy = parameters[4];
    const double q_Cz = parameters[5];
    const double q_wx = parameters[6];
    const double q_wy = parameters[7];
    const double q_wz = parameters[8];
    const double EC0Y = parameters[12];
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
        const double y = positions[1 * stride + i];
        const double EXY = errors[6 * stride + i];
        const double EYY = errors[7 * stride + i];
        const double EZY = errors[8 * stride + i];
        const double EAY = errors[9 * stride + i];
        const double EBY = errors[10 * stride + i];
        const double ECY = errors[11 * stride + i];
        const double rWx = workpiece_point[0 * stride + i];
        const double rWy = workpiece_point[1 * stride + i];
        const double rWz = workpiece_point[2 * stride + i];
        const double w0 = q_Az + q_Cz + q_wz + rWz;
        const double w1 = q_Ay + q_Cy + q_wy + rWy;
        const double w2 = q_Ax + q_Cx + q_wx + rWx;
        displacement[0 * stride + i] = EBY*w0 - EC0Y*y - ECY*w1 + EXY;
        displacement[1 * stride + i] = -EAY*w0 + ECY*w2 + EYY + y;
        displacement[2 * stride + i] = EAY*w1 - EBY*w2 + EZY;
    }
}

/*
 * Motion equation of Z: displacement of the tool point since home, to first order.
 * Source: Eqs. (7)-(11). Operations: 20 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z A C (x y z a c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXA EYA EZA EAA EBA ECA EXC EYC EZC EAC EBC ECC)
 * in parameters: 23 values, mm, rad; home positions and location errors (q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz
 *     q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C EA0C EB0C EA0Z EB0Z)
 * in tool_point: 3 rows of stride, mm; point in the tool frame (rTx rTy rTz)
 * out displacement: 3 rows of stride, mm; tool point, displacement since home, in the bed frame (dx dy dz)
 */
void trunnion_mill_motion_Z(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT tool_point,
    double *TRUEAXIS_RESTRICT displacement)
{
    /* once per call */
    const double q_Tx = parameters[9];
    const double q_Ty = parameters[10];
    const double q_Tz = parameters[11];
    const double EA0Z = parameters[21];
    const double EB0Z = parameters[22];
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
        const double z = positions[2 * stride + i];
        const double EXZ = errors[12 * stride + i];
        const double EYZ = errors[13 * stride + i];
        const double EZZ = errors[14 * stride + i];
        const double EAZ = errors[15 * stride + i];
        const double EBZ = errors[16 * stride + i];
        const double ECZ = errors[17 * stride + i];
        const double rTx = tool_point[0 * stride + i];
        const double rTy = tool_point[1 * stride + i];
        const double rTz = tool_point[2 * stride + i];
        const double w0 = q_Tz + rTz;
        const double w1 = q_Ty + rTy;
        const double w2 = q_Tx + rTx;
        displacement[0 * stride + i] = EB0Z*z + EBZ*w0 - ECZ*w1 + EXZ;
        displacement[1 * stride + i] = -EA0Z*z - EAZ*w0 + ECZ*w2 + EYZ;
        displacement[2 * stride + i] = EAZ*w1 - EBZ*w2 + EZZ + z;
    }
}

/*
 * Motion equation of A: displacement of the workpiece point since home, to first order.
 * Source: Eqs. (7)-(11). Operations: 101 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z A C (x y z a c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXA EYA EZA EAA EBA ECA EXC EYC EZC EAC EBC ECC)
 * in parameters: 23 values, mm, rad; home positions and location errors (q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz
 *     q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C EA0C EB0C EA0Z EB0Z)
 * in workpiece_point: 3 rows of stride, mm; point in the workpiece frame (rWx rWy rWz)
 * out displacement: 3 rows of stride, mm; workpiece point, displacement since home, in the bed frame (dx dy dz)
 */
void trunnion_mill_motion_A(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT workpiece_point,
    double *TRUEAXIS_RESTRICT displacement)
{
    /* once per call */
    const double q_Cx = parameters[3];
    const double q_Cy = parameters[4];
    const double q_Cz = parameters[5];
    const double q_wx = parameters[6];
    const double q_wy = parameters[7];
    const double q_wz = parameters[8];
    const double EC0Y = parameters[12];
    const double EB0A = parameters[15];
    const double EC0A = parameters[16];
    const double EY0C = parameters[18];
    const double EA0C = parameters[19];
    const double EB0C = parameters[20];
    for (size_t start = 0; start < n; start += BLOCK) {
        const size_t count = n - start < BLOCK ? n - start : (size_t)BLOCK;
        /* cosines and sines */
        double cos_a_block[BLOCK];
        double sin_a_block[BLOCK];
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double a = positions[3 * stride + i];
            cos_a_block[j] = cos(0.017453292519943295*a);
            sin_a_block[j] = sin(0.017453292519943295*a);
        }
        /* per point */
        POINTS_ARE_INDEPENDENT
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double cos_a = cos_a_block[j];
            const double sin_a = sin_a_block[j];
            const double EXA = errors[18 * stride + i];
            const double EYA = errors[19 * stride + i];
            const double EZA = errors[20 * stride + i];
            const double EAA = errors[21 * stride + i];
            const double EBA = errors[22 * stride + i];
            const double ECA = errors[23 * stride + i];
            const double rWx = workpiece_point[0 * stride + i];
            const double rWy = workpiece_point[1 * stride + i];
            const double rWz = workpiece_point[2 * stride + i];
            const double w0 = q_wy + rWy;
            const double w1 = q_Cy + w0;
            const double w2 = q_Cz*sin_a;
            const double w3 = cos_a*q_Cy;
            const double w4 = q_wz*sin_a;
            const double w5 = rWz*sin_a;
            const double w6 = cos_a*q_wy;
            const double w7 = cos_a*rWy;
            const double w8 = w4 + w5 - w6 - w7;
            const double w9 = w1 + w2 - w3 + w8;
            const double w10 = cos_a*q_wz + cos_a*rWz + q_wy*sin_a + rWy*sin_a;
            const double w11 = -q_wz - rWz + w10;
            const double w12 = cos_a*q_Cz + q_Cy*sin_a;
            const double w13 = -q_Cz + w11 + w12;
            const double w14 = q_wx*sin_a + rWx*sin_a;
            const double w15 = q_Cx*sin_a + w14;
            const double w16 = cos_a*q_wx + cos_a*rWx;
            const double w17 = cos_a*q_Cx + w16;
            const double w18 = -w2 + w3 - w4 - w5 + w6 + w7;
            displacement[0 * stride + i] = EB0A*w13 + EBA*(q_Cz + q_wz + rWz) + EC0A*w9 + EC0Y*w9 - ECA*w1 + EXA;
            displacement[1 * stride + i] = -EA0C*w11 + EAA*(-w10 - w12) + EB0C*w14 + EBA*w15 + ECA*w17 + EY0C*(cos_a -
                1.0) + EYA*cos_a - EZA*sin_a - q_Cy - q_wy - rWy + w18;
            displacement[2 * stride + i] = EA0C*(-w0 - w8) + EAA*w18 + EB0C*(q_wx + rWx - w16) - EBA*w17 + ECA*w15 +
                EY0C*sin_a + EYA*sin_a + EZA*cos_a + w13;
        }
    }
}

/*
 * Motion equation of C: displacement of the workpiece point since home, to first order.
 * Source: Eqs. (7)-(11). Operations: 76 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z A C (x y z a c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXA EYA EZA EAA EBA ECA EXC EYC EZC EAC EBC ECC)
 * in parameters: 23 values, mm, rad; home positions and location errors (q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz
 *     q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C EA0C EB0C EA0Z EB0Z)
 * in workpiece_point: 3 rows of stride, mm; point in the workpiece frame (rWx rWy rWz)
 * out displacement: 3 rows of stride, mm; workpiece point, displacement since home, in the bed frame (dx dy dz)
 */
void trunnion_mill_motion_C(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT workpiece_point,
    double *TRUEAXIS_RESTRICT displacement)
{
    /* once per call */
    const double q_wx = parameters[6];
    const double q_wy = parameters[7];
    const double q_wz = parameters[8];
    const double EC0Y = parameters[12];
    const double EB0A = parameters[15];
    const double EC0A = parameters[16];
    const double EA0C = parameters[19];
    const double EB0C = parameters[20];
    for (size_t start = 0; start < n; start += BLOCK) {
        const size_t count = n - start < BLOCK ? n - start : (size_t)BLOCK;
        /* cosines and sines */
        double cos_c_block[BLOCK];
        double sin_c_block[BLOCK];
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double c = positions[4 * stride + i];
            cos_c_block[j] = cos(0.017453292519943295*c);
            sin_c_block[j] = sin(0.017453292519943295*c);
        }
        /* per point */
        POINTS_ARE_INDEPENDENT
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double cos_c = cos_c_block[j];
            const double sin_c = sin_c_block[j];
            const double EXC = errors[24 * stride + i];
            const double EYC = errors[25 * stride + i];
            const double EZC = errors[26 * stride + i];
            const double EAC = errors[27 * stride + i];
            const double EBC = errors[28 * stride + i];
            const double ECC = errors[29 * stride + i];
            const double rWx = workpiece_point[0 * stride + i];
            const double rWy = workpiece_point[1 * stride + i];
            const double rWz = workpiece_point[2 * stride + i];
            const double w0 = q_wz*sin_c + rWz*sin_c;
            const double w1 = cos_c*q_wz + cos_c*rWz;
            const double w2 = cos_c*q_wy + cos_c*rWy + q_wx*sin_c + rWx*sin_c;
            const double w3 = -q_wy - rWy + w2;
            const double w4 = -w3;
            const double w5 = q_wy*sin_c;
            const double w6 = rWy*sin_c;
            const double w7 = cos_c*q_wx + cos_c*rWx - w5 - w6;
            const double w8 = q_wx + rWx;
            const double w9 = -cos_c*q_wx - cos_c*rWx + w5 + w6 + w8;
            const double w10 = -w9;
            displacement[0 * stride + i] = EAC*w0 + EBC*w1 + EC0A*w4 + EC0Y*w4 - ECC*w2 + EXC*cos_c - EYC*sin_c - q_wx -
                rWx + w7;
            displacement[1 * stride + i] = -EAC*w1 + EBC*w0 + EC0A*w10 + EC0Y*w10 + ECC*w7 + EXC*sin_c + EYC*cos_c + w3;
            displacement[2 * stride + i] = EA0C*w3 + EAC*(q_wy + rWy) + EB0A*w9 + EB0C*w9 - EBC*w8 + EZC;
        }
    }
}

/*
 * Motion equation of X and Y: displacement of the workpiece point minus tool point since home, to first order.
 * Source: Eqs. (7)-(11). Operations: 43 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z A C (x y z a c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXA EYA EZA EAA EBA ECA EXC EYC EZC EAC EBC ECC)
 * in parameters: 23 values, mm, rad; home positions and location errors (q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz
 *     q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C EA0C EB0C EA0Z EB0Z)
 * in workpiece_point: 3 rows of stride, mm; point in the workpiece frame (rWx rWy rWz)
 * in tool_point: 3 rows of stride, mm; point in the tool frame (rTx rTy rTz)
 * out displacement: 3 rows of stride, mm; workpiece point minus tool point, displacement since home, in the bed frame
 *     (dx dy dz)
 */
void trunnion_mill_motion_XY(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT workpiece_point,
    const double *TRUEAXIS_RESTRICT tool_point,
    double *TRUEAXIS_RESTRICT displacement)
{
    /* once per call */
    const double q_Ax = parameters[0];
    const double q_Ay = parameters[1];
    const double q_Az = parameters[2];
    const double q_Cx = parameters[3];
    const double q_Cy = parameters[4];
    const double q_Cz = parameters[5];
    const double q_wx = parameters[6];
    const double q_wy = parameters[7];
    const double q_wz = parameters[8];
    const double q_Tx = parameters[9];
    const double q_Ty = parameters[10];
    const double q_Tz = parameters[11];
    const double EC0Y = parameters[12];
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
        const double x = positions[0 * stride + i];
        const double y = positions[1 * stride + i];
        const double EXX = errors[0 * stride + i];
        const double EYX = errors[1 * stride + i];
        const double EZX = errors[2 * stride + i];
        const double EAX = errors[3 * stride + i];
        const double EBX = errors[4 * stride + i];
        const double ECX = errors[5 * stride + i];
        const double EXY = errors[6 * stride + i];
        const double EYY = errors[7 * stride + i];
        const double EZY = errors[8 * stride + i];
        const double EAY = errors[9 * stride + i];
        const double EBY = errors[10 * stride + i];
        const double ECY = errors[11 * stride + i];
        const double rWx = workpiece_point[0 * stride + i];
        const double rWy = workpiece_point[1 * stride + i];
        const double rWz = workpiece_point[2 * stride + i];
        const double rTx = tool_point[0 * stride + i];
        const double rTy = tool_point[1 * stride + i];
        const double rTz = tool_point[2 * stride + i];
        const double w0 = q_Ty + rTy;
        const double w1 = q_Az + q_Cz + q_wz + rWz;
        const double w2 = q_Tz + rTz;
        const double w3 = q_Ay + q_Cy + q_wy + rWy;
        const double w4 = q_Ax + q_Cx + q_wx + rWx;
        const double w5 = q_Tx + rTx;
        displacement[0 * stride + i] = -EBX*w2 + EBY*w1 - EC0Y*y + ECX*w0 - ECY*w3 - EXX + EXY - x;
        displacement[1 * stride + i] = EAX*w2 - EAY*w1 - ECX*w5 + ECY*w4 - EYX + EYY + y;
        displacement[2 * stride + i] = -EAX*w0 + EAY*w3 + EBX*w5 - EBY*w4 - EZX + EZY;
    }
}

/*
 * Motion equation of X and Z: displacement of the tool point since home, to first order.
 * Source: Eqs. (7)-(11). Operations: 39 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z A C (x y z a c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXA EYA EZA EAA EBA ECA EXC EYC EZC EAC EBC ECC)
 * in parameters: 23 values, mm, rad; home positions and location errors (q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz
 *     q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C EA0C EB0C EA0Z EB0Z)
 * in tool_point: 3 rows of stride, mm; point in the tool frame (rTx rTy rTz)
 * out displacement: 3 rows of stride, mm; tool point, displacement since home, in the bed frame (dx dy dz)
 */
void trunnion_mill_motion_XZ(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT tool_point,
    double *TRUEAXIS_RESTRICT displacement)
{
    /* once per call */
    const double q_Tx = parameters[9];
    const double q_Ty = parameters[10];
    const double q_Tz = parameters[11];
    const double EA0Z = parameters[21];
    const double EB0Z = parameters[22];
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
        const double x = positions[0 * stride + i];
        const double z = positions[2 * stride + i];
        const double EXX = errors[0 * stride + i];
        const double EYX = errors[1 * stride + i];
        const double EZX = errors[2 * stride + i];
        const double EAX = errors[3 * stride + i];
        const double EBX = errors[4 * stride + i];
        const double ECX = errors[5 * stride + i];
        const double EXZ = errors[12 * stride + i];
        const double EYZ = errors[13 * stride + i];
        const double EZZ = errors[14 * stride + i];
        const double EAZ = errors[15 * stride + i];
        const double EBZ = errors[16 * stride + i];
        const double ECZ = errors[17 * stride + i];
        const double rTx = tool_point[0 * stride + i];
        const double rTy = tool_point[1 * stride + i];
        const double rTz = tool_point[2 * stride + i];
        const double w0 = q_Tz + rTz;
        const double w1 = w0 + z;
        const double w2 = q_Ty + rTy;
        const double w3 = -w2;
        const double w4 = q_Tx + rTx;
        const double w5 = -w4;
        displacement[0 * stride + i] = EB0Z*z + EBX*w1 + EBZ*w0 + ECX*w3 + ECZ*w3 + EXX + EXZ + x;
        displacement[1 * stride + i] = -EA0Z*z - EAX*w1 - EAZ*w0 + ECX*w4 + ECZ*w4 + EYX + EYZ;
        displacement[2 * stride + i] = EAX*w2 + EAZ*w2 + EBX*w5 + EBZ*w5 + EZX + EZZ + z;
    }
}

/*
 * Motion equation of Y and Z: displacement of the workpiece point minus tool point since home, to first order.
 * Source: Eqs. (7)-(11). Operations: 47 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z A C (x y z a c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXA EYA EZA EAA EBA ECA EXC EYC EZC EAC EBC ECC)
 * in parameters: 23 values, mm, rad; home positions and location errors (q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz
 *     q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C EA0C EB0C EA0Z EB0Z)
 * in workpiece_point: 3 rows of stride, mm; point in the workpiece frame (rWx rWy rWz)
 * in tool_point: 3 rows of stride, mm; point in the tool frame (rTx rTy rTz)
 * out displacement: 3 rows of stride, mm; workpiece point minus tool point, displacement since home, in the bed frame
 *     (dx dy dz)
 */
void trunnion_mill_motion_YZ(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT workpiece_point,
    const double *TRUEAXIS_RESTRICT tool_point,
    double *TRUEAXIS_RESTRICT displacement)
{
    /* once per call */
    const double q_Ax = parameters[0];
    const double q_Ay = parameters[1];
    const double q_Az = parameters[2];
    const double q_Cx = parameters[3];
    const double q_Cy = parameters[4];
    const double q_Cz = parameters[5];
    const double q_wx = parameters[6];
    const double q_wy = parameters[7];
    const double q_wz = parameters[8];
    const double q_Tx = parameters[9];
    const double q_Ty = parameters[10];
    const double q_Tz = parameters[11];
    const double EC0Y = parameters[12];
    const double EA0Z = parameters[21];
    const double EB0Z = parameters[22];
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
        const double y = positions[1 * stride + i];
        const double z = positions[2 * stride + i];
        const double EXY = errors[6 * stride + i];
        const double EYY = errors[7 * stride + i];
        const double EZY = errors[8 * stride + i];
        const double EAY = errors[9 * stride + i];
        const double EBY = errors[10 * stride + i];
        const double ECY = errors[11 * stride + i];
        const double EXZ = errors[12 * stride + i];
        const double EYZ = errors[13 * stride + i];
        const double EZZ = errors[14 * stride + i];
        const double EAZ = errors[15 * stride + i];
        const double EBZ = errors[16 * stride + i];
        const double ECZ = errors[17 * stride + i];
        const double rWx = workpiece_point[0 * stride + i];
        const double rWy = workpiece_point[1 * stride + i];
        const double rWz = workpiece_point[2 * stride + i];
        const double rTx = tool_point[0 * stride + i];
        const double rTy = tool_point[1 * stride + i];
        const double rTz = tool_point[2 * stride + i];
        const double w0 = q_Ty + rTy;
        const double w1 = q_Az + q_Cz + q_wz + rWz;
        const double w2 = q_Tz + rTz;
        const double w3 = q_Ay + q_Cy + q_wy + rWy;
        const double w4 = q_Ax + q_Cx + q_wx + rWx;
        const double w5 = q_Tx + rTx;
        displacement[0 * stride + i] = -EB0Z*z + EBY*w1 - EBZ*w2 - EC0Y*y - ECY*w3 + ECZ*w0 + EXY - EXZ;
        displacement[1 * stride + i] = EA0Z*z - EAY*w1 + EAZ*w2 + ECY*w4 - ECZ*w5 + EYY - EYZ + y;
        displacement[2 * stride + i] = EAY*w3 - EAZ*w0 - EBY*w4 + EBZ*w5 + EZY - EZZ - z;
    }
}
