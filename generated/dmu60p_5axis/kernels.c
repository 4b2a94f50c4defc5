/* Generated from machines/dmu60p_5axis.toml, do not edit; regenerate with: trueaxis derive machines/dmu60p_5axis.toml
 * SPDX-License-Identifier: MIT
 * Kernels of DECKEL MAHO DMU60P, all five axes: geometric error model in C17.
 * Spec: sha256 1b0a63b86ea881e06983b884ca7f951aa51e2ebb46ef2eaccf5755fd64d1985f
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

int dmu60p_5axis_kernel_abi(void)
{
    return TRUEAXIS_KERNEL_ABI;
}

const char *dmu60p_5axis_spec_hash(void)
{
    return "1b0a63b86ea881e06983b884ca7f951aa51e2ebb46ef2eaccf5755fd64d1985f";
}

/*
 * Ideal position of a tool point in the workpiece frame.
 * Source: Eqs. (1)-(4) without errors. Operations: 87 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out ideal: 3 rows of stride, mm; tool point in the workpiece frame, without errors (px py pz)
 */
void dmu60p_5axis_tool_in_workpiece_ideal(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT ideal)
{
    /* once per call */
    const double q_Cx = parameters[0];
    const double q_Cy = parameters[1];
    const double q_Cz = parameters[2];
    const double q_wx = parameters[3];
    const double q_wy = parameters[4];
    const double q_wz = parameters[5];
    const double q_Bx = parameters[6];
    const double q_By = parameters[7];
    const double q_Bz = parameters[8];
    const double q_Sx = parameters[9];
    const double q_Sy = parameters[10];
    const double q_Sz = parameters[11];
    const double q_Tx = parameters[12];
    const double q_Ty = parameters[13];
    const double q_Tz = parameters[14];
    for (size_t start = 0; start < n; start += BLOCK) {
        const size_t count = n - start < BLOCK ? n - start : (size_t)BLOCK;
        /* cosines and sines */
        double cos_b_block[BLOCK];
        double sin_b_block[BLOCK];
        double cos_c_block[BLOCK];
        double sin_c_block[BLOCK];
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double b = positions[3 * stride + i];
            const double c = positions[4 * stride + i];
            cos_b_block[j] = cos(0.017453292519943295*b);
            sin_b_block[j] = sin(0.017453292519943295*b);
            cos_c_block[j] = cos(0.017453292519943295*c);
            sin_c_block[j] = sin(0.017453292519943295*c);
        }
        /* per point */
        POINTS_ARE_INDEPENDENT
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double cos_b = cos_b_block[j];
            const double sin_b = sin_b_block[j];
            const double cos_c = cos_c_block[j];
            const double sin_c = sin_c_block[j];
            const double x = positions[0 * stride + i];
            const double y = positions[1 * stride + i];
            const double z = positions[2 * stride + i];
            const double rx = point[0 * stride + i];
            const double ry = point[1 * stride + i];
            const double rz = point[2 * stride + i];
            const double w0 = cos_b*cos_c;
            const double w1 = cos_c*sin_b;
            const double w2 = cos_b*sin_c;
            const double w3 = sin_b*sin_c;
            ideal[0 * stride + i] = cos_c*q_Bx - cos_c*q_Cx + cos_c*x + q_By*sin_c - q_Cy*sin_c + q_Sx*w0 + q_Sy*sin_c +
                q_Sz*w1 + q_Tx*w0 + q_Ty*sin_c + q_Tz*w1 - q_wx + rx*w0 + ry*sin_c + rz*w1 - sin_c*y;
            ideal[1 * stride + i] = cos_c*q_By - cos_c*q_Cy + cos_c*q_Sy + cos_c*q_Ty + cos_c*ry - cos_c*y - q_Bx*sin_c
                + q_Cx*sin_c - q_Sx*w2 - q_Sz*w3 - q_Tx*w2 - q_Tz*w3 - q_wy - rx*w2 - rz*w3 - sin_c*x;
            ideal[2 * stride + i] = cos_b*q_Sz + cos_b*q_Tz + cos_b*rz + q_Bz - q_Cz - q_Sx*sin_b - q_Tx*sin_b - q_wz -
                rx*sin_b + z;
        }
    }
}

/*
 * Deviation of a tool point in the workpiece frame, exact.
 * Source: Eqs. (1)-(4). Operations: 244 per point, 5 once per call.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; tool point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void dmu60p_5axis_tool_in_workpiece_deviation(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation)
{
    /* once per call */
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
    for (size_t start = 0; start < n; start += BLOCK) {
        const size_t count = n - start < BLOCK ? n - start : (size_t)BLOCK;
        /* cosines and sines */
        double cos_b_block[BLOCK];
        double sin_b_block[BLOCK];
        double cos_c_block[BLOCK];
        double sin_c_block[BLOCK];
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double b = positions[3 * stride + i];
            const double c = positions[4 * stride + i];
            cos_b_block[j] = cos(0.017453292519943295*b);
            sin_b_block[j] = sin(0.017453292519943295*b);
            cos_c_block[j] = cos(0.017453292519943295*c);
            sin_c_block[j] = sin(0.017453292519943295*c);
        }
        /* per point */
        POINTS_ARE_INDEPENDENT
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double cos_b = cos_b_block[j];
            const double sin_b = sin_b_block[j];
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
            const double EXB = errors[18 * stride + i];
            const double EYB = errors[19 * stride + i];
            const double EZB = errors[20 * stride + i];
            const double EAB = errors[21 * stride + i];
            const double EBB = errors[22 * stride + i];
            const double ECB = errors[23 * stride + i];
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
            deviation[0 * stride + i] = w79*(EAC*w77 - EBC*w75 + ECC*w72 - w13*w78 + w68);
            deviation[1 * stride + i] = w79*(EAC*w75 + EBC*w77 - ECC*w76 - w69*w78 + w71);
            deviation[2 * stride + i] = w79*(-EAC*w72 + EBC*w76 + ECC*w77 - w56*w78 + w74);
        }
    }
}

/*
 * Deviation of a tool point in the workpiece frame, to first order in the errors.
 * Source: Eqs. (1)-(4). Operations: 151 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; tool point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void dmu60p_5axis_tool_in_workpiece_deviation_first_order(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation)
{
    /* once per call */
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
    for (size_t start = 0; start < n; start += BLOCK) {
        const size_t count = n - start < BLOCK ? n - start : (size_t)BLOCK;
        /* cosines and sines */
        double cos_b_block[BLOCK];
        double sin_b_block[BLOCK];
        double cos_c_block[BLOCK];
        double sin_c_block[BLOCK];
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double b = positions[3 * stride + i];
            const double c = positions[4 * stride + i];
            cos_b_block[j] = cos(0.017453292519943295*b);
            sin_b_block[j] = sin(0.017453292519943295*b);
            cos_c_block[j] = cos(0.017453292519943295*c);
            sin_c_block[j] = sin(0.017453292519943295*c);
        }
        /* per point */
        POINTS_ARE_INDEPENDENT
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double cos_b = cos_b_block[j];
            const double sin_b = sin_b_block[j];
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
            const double EXB = errors[18 * stride + i];
            const double EYB = errors[19 * stride + i];
            const double EZB = errors[20 * stride + i];
            const double EAB = errors[21 * stride + i];
            const double EBB = errors[22 * stride + i];
            const double ECB = errors[23 * stride + i];
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
            const double w1 = q_Sx + w0;
            const double w2 = q_Tz + rz;
            const double w3 = q_Sz + w2;
            const double w4 = cos_b*w3 - sin_b*w1;
            const double w5 = q_Bz + w4;
            const double w6 = w5 + z;
            const double w7 = -q_Cz + w6;
            const double w8 = cos_b*w1 + sin_b*w3;
            const double w9 = q_Bx + w8;
            const double w10 = w9 + x;
            const double w11 = -q_Cx + w10;
            const double w12 = q_Ty + ry;
            const double w13 = q_Sy + w12;
            const double w14 = q_By + w13;
            const double w15 = w14 - y;
            const double w16 = -q_Cy + w15;
            const double w17 = cos_c*w16 - sin_c*w11;
            const double w18 = EBB*w3 - ECB*w13 + EXB;
            const double w19 = EAB*w13 - EBB*w1 + EZB;
            const double w20 = cos_b*w18 + sin_b*w19;
            const double w21 = -EC0B*w13 + EX0B + w20;
            const double w22 = EBZ*w5 - ECZ*w14 + EXZ + w21;
            const double w23 = eps_xz*w6 + w22;
            const double w24 = EBX*w6 - ECX*w14 + EXX + w23;
            const double w25 = -eps_xy*w14 + w24;
            const double w26 = -EBY*w6 + ECY*w15 - EXY + w25;
            const double w27 = -EB0C*w7 - EX0C + w26;
            const double w28 = -EAB*w3 + ECB*w1 + EYB;
            const double w29 = -EA0B*w4 + EC0B*w8 + w28;
            const double w30 = -EAZ*w5 + ECZ*w9 + EYZ + w29;
            const double w31 = -eps_yz*w6 + w30;
            const double w32 = -EAX*w6 + ECX*w9 + EYX + w31;
            const double w33 = eps_xy*w10 + w32;
            const double w34 = EAY*w6 - ECY*w10 - EYY + w33;
            const double w35 = EA0C*w7 - EY0C + w34;
            const double w36 = cos_c*w27 + sin_c*w35;
            const double w37 = cos_c*w11 + sin_c*w16;
            const double w38 = cos_c*w35 - sin_c*w27;
            const double w39 = cos_b*w19 - sin_b*w18;
            const double w40 = EA0B*w13 + EZ0B + w39;
            const double w41 = EAZ*w14 - EBZ*w9 + EZZ + w40;
            const double w42 = -eps_xz*w9 + eps_yz*w14 + w41;
            const double w43 = EAX*w14 - EBX*w9 + EZX + w42;
            const double w44 = -EAY*w15 + EBY*w10 - EZY + w43;
            const double w45 = -EA0C*w16 + EB0C*w11 + w44;
            deviation[0 * stride + i] = -EBC*w7 + ECC*w17 - EXC + w36;
            deviation[1 * stride + i] = EAC*w7 - ECC*w37 - EYC + w38;
            deviation[2 * stride + i] = -EAC*w17 + EBC*w37 - EZC + w45;
        }
    }
}

/*
 * Sensitivity of a tool point in the workpiece frame to every error, at the error-free machine.
 * Source: Eqs. (1)-(4), first order. Operations: 219 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out sensitivity: 123 rows of stride, mm/mm, mm/rad; derivative of the deviation by each component error, then by
 *     each location error (dx_EXX dx_EYX .. dz_EC0B, last index fastest)
 */
void dmu60p_5axis_tool_in_workpiece_sensitivity(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT sensitivity)
{
    /* once per call */
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
    for (size_t start = 0; start < n; start += BLOCK) {
        const size_t count = n - start < BLOCK ? n - start : (size_t)BLOCK;
        /* cosines and sines */
        double cos_b_block[BLOCK];
        double sin_b_block[BLOCK];
        double cos_c_block[BLOCK];
        double sin_c_block[BLOCK];
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double b = positions[3 * stride + i];
            const double c = positions[4 * stride + i];
            cos_b_block[j] = cos(0.017453292519943295*b);
            sin_b_block[j] = sin(0.017453292519943295*b);
            cos_c_block[j] = cos(0.017453292519943295*c);
            sin_c_block[j] = sin(0.017453292519943295*c);
        }
        /* per point */
        POINTS_ARE_INDEPENDENT
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double cos_b = cos_b_block[j];
            const double sin_b = sin_b_block[j];
            const double cos_c = cos_c_block[j];
            const double sin_c = sin_c_block[j];
            const double x = positions[0 * stride + i];
            const double y = positions[1 * stride + i];
            const double z = positions[2 * stride + i];
            const double rx = point[0 * stride + i];
            const double ry = point[1 * stride + i];
            const double rz = point[2 * stride + i];
            const double w0 = q_Sz*sin_c;
            const double w1 = q_Tz*sin_c;
            const double w2 = rz*sin_c;
            const double w3 = q_Sx*sin_c;
            const double w4 = q_Tx*sin_c;
            const double w5 = rx*sin_c;
            const double w6 = cos_b*w0 + cos_b*w1 + cos_b*w2 - sin_b*w3 - sin_b*w4 - sin_b*w5;
            const double w7 = q_Bz*sin_c + w6;
            const double dx_EAY = sin_c*z + w7;
            const double dx_EAX = -dx_EAY;
            const double dx_EXB = cos_b*cos_c;
            const double dx_EZB = cos_c*sin_b;
            const double dx_EBB = dx_EXB*q_Sz + dx_EXB*q_Tz + dx_EXB*rz - dx_EZB*q_Sx - dx_EZB*q_Tx - dx_EZB*rx;
            const double dx_EBZ = cos_c*q_Bz + dx_EBB;
            const double dx_EBX = cos_c*z + dx_EBZ;
            const double w8 = cos_c*q_Sy;
            const double w9 = cos_c*q_Ty;
            const double w10 = cos_c*ry;
            const double dx_EC0B = cos_b*w3 + cos_b*w4 + cos_b*w5 + sin_b*w0 + sin_b*w1 + sin_b*w2 - w10 - w8 - w9;
            const double dx_ECX = -cos_c*q_By + dx_EC0B + q_Bx*sin_c;
            const double dx_EXY = -cos_c;
            const double dx_EYY = -sin_c;
            const double dx_EBY = -dx_EBX;
            const double dx_eps_xy = dx_ECX + sin_c*x;
            const double dx_EAZ = -w7;
            const double dy_EAC = cos_b*q_Sz + cos_b*q_Tz + cos_b*rz + q_Bz - q_Cz - q_Sx*sin_b - q_Tx*sin_b - rx*sin_b
                + z;
            const double w11 = cos_c*y + dx_eps_xy;
            const double dz_EAC = cos_c*q_Cy - q_Cx*sin_c + w11;
            const double dx_EA0C = dx_EAY - q_Cz*sin_c;
            const double dy_EA0C = -cos_c*q_Cz + dx_EBX;
            const double dx_EA0B = -w6;
            const double w12 = q_Sy*sin_c;
            const double w13 = q_Ty*sin_c;
            const double w14 = ry*sin_c;
            const double dy_EC0B = dx_EXB*q_Sx + dx_EXB*q_Tx + dx_EXB*rx + dx_EZB*q_Sz + dx_EZB*q_Tz + dx_EZB*rz + w12 +
                w13 + w14;
            const double dy_ECX = cos_c*q_Bx + dy_EC0B + q_By*sin_c;
            const double dy_eps_xy = cos_c*x + dy_ECX;
            const double w15 = dy_eps_xy - sin_c*y;
            const double dz_EBC = -cos_c*q_Cx - q_Cy*sin_c + w15;
            const double dz_EA0B = q_Sy + q_Ty + ry;
            const double dz_EAX = dz_EA0B + q_By;
            const double w16 = cos_b*q_Sx + cos_b*q_Tx + cos_b*rx + q_Sz*sin_b + q_Tz*sin_b + rz*sin_b;
            const double w17 = q_Bx + w16;
            const double dz_EBX = -w17;
            const double dz_EBY = w17 + x;
            const double w18 = dz_EAX - y;
            sensitivity[0 * stride + i] = cos_c;
            sensitivity[1 * stride + i] = sin_c;
            sensitivity[2 * stride + i] = 0.0;
            sensitivity[3 * stride + i] = dx_EAX;
            sensitivity[4 * stride + i] = dx_EBX;
            sensitivity[5 * stride + i] = dx_ECX;
            sensitivity[6 * stride + i] = dx_EXY;
            sensitivity[7 * stride + i] = dx_EYY;
            sensitivity[8 * stride + i] = 0.0;
            sensitivity[9 * stride + i] = dx_EAY;
            sensitivity[10 * stride + i] = dx_EBY;
            sensitivity[11 * stride + i] = -w11;
            sensitivity[12 * stride + i] = cos_c;
            sensitivity[13 * stride + i] = sin_c;
            sensitivity[14 * stride + i] = 0.0;
            sensitivity[15 * stride + i] = dx_EAZ;
            sensitivity[16 * stride + i] = dx_EBZ;
            sensitivity[17 * stride + i] = dx_ECX;
            sensitivity[18 * stride + i] = dx_EXB;
            sensitivity[19 * stride + i] = sin_c;
            sensitivity[20 * stride + i] = dx_EZB;
            sensitivity[21 * stride + i] = sin_b*w10 + sin_b*w8 + sin_b*w9 - w0 - w1 - w2;
            sensitivity[22 * stride + i] = dx_EBB;
            sensitivity[23 * stride + i] = -cos_b*w10 - cos_b*w8 - cos_b*w9 + q_Sx*sin_c + q_Tx*sin_c + rx*sin_c;
            sensitivity[24 * stride + i] = -1.0;
            sensitivity[25 * stride + i] = 0.0;
            sensitivity[26 * stride + i] = 0.0;
            sensitivity[27 * stride + i] = 0.0;
            sensitivity[28 * stride + i] = -dy_EAC;
            sensitivity[29 * stride + i] = -dz_EAC;
            sensitivity[30 * stride + i] = dx_EXY;
            sensitivity[31 * stride + i] = dx_EYY;
            sensitivity[32 * stride + i] = dx_EA0C;
            sensitivity[33 * stride + i] = -dy_EA0C;
            sensitivity[34 * stride + i] = dx_eps_xy;
            sensitivity[35 * stride + i] = dx_EAX;
            sensitivity[36 * stride + i] = dx_EBX;
            sensitivity[37 * stride + i] = cos_c;
            sensitivity[38 * stride + i] = 0.0;
            sensitivity[39 * stride + i] = dx_EA0B;
            sensitivity[40 * stride + i] = dx_EC0B;
            sensitivity[41 * stride + i] = dx_EYY;
            sensitivity[42 * stride + i] = cos_c;
            sensitivity[43 * stride + i] = 0.0;
            sensitivity[44 * stride + i] = dx_EBY;
            sensitivity[45 * stride + i] = dx_EAX;
            sensitivity[46 * stride + i] = dy_ECX;
            sensitivity[47 * stride + i] = sin_c;
            sensitivity[48 * stride + i] = dx_EXY;
            sensitivity[49 * stride + i] = 0.0;
            sensitivity[50 * stride + i] = dx_EBX;
            sensitivity[51 * stride + i] = dx_EAY;
            sensitivity[52 * stride + i] = -w15;
            sensitivity[53 * stride + i] = dx_EYY;
            sensitivity[54 * stride + i] = cos_c;
            sensitivity[55 * stride + i] = 0.0;
            sensitivity[56 * stride + i] = -dx_EBZ;
            sensitivity[57 * stride + i] = dx_EAZ;
            sensitivity[58 * stride + i] = dy_ECX;
            sensitivity[59 * stride + i] = -cos_b*sin_c;
            sensitivity[60 * stride + i] = cos_c;
            sensitivity[61 * stride + i] = -sin_b*sin_c;
            sensitivity[62 * stride + i] = -cos_c*q_Sz - cos_c*q_Tz - cos_c*rz - sin_b*w12 - sin_b*w13 - sin_b*w14;
            sensitivity[63 * stride + i] = dx_EA0B;
            sensitivity[64 * stride + i] = cos_b*w12 + cos_b*w13 + cos_b*w14 + cos_c*q_Sx + cos_c*q_Tx + cos_c*rx;
            sensitivity[65 * stride + i] = 0.0;
            sensitivity[66 * stride + i] = -1.0;
            sensitivity[67 * stride + i] = 0.0;
            sensitivity[68 * stride + i] = dy_EAC;
            sensitivity[69 * stride + i] = 0.0;
            sensitivity[70 * stride + i] = -dz_EBC;
            sensitivity[71 * stride + i] = sin_c;
            sensitivity[72 * stride + i] = dx_EXY;
            sensitivity[73 * stride + i] = dy_EA0C;
            sensitivity[74 * stride + i] = dx_EA0C;
            sensitivity[75 * stride + i] = dy_eps_xy;
            sensitivity[76 * stride + i] = dx_EBY;
            sensitivity[77 * stride + i] = dx_EAX;
            sensitivity[78 * stride + i] = dx_EYY;
            sensitivity[79 * stride + i] = 0.0;
            sensitivity[80 * stride + i] = -dx_EBB;
            sensitivity[81 * stride + i] = dy_EC0B;
            sensitivity[82 * stride + i] = 0.0;
            sensitivity[83 * stride + i] = 0.0;
            sensitivity[84 * stride + i] = 1.0;
            sensitivity[85 * stride + i] = dz_EAX;
            sensitivity[86 * stride + i] = dz_EBX;
            sensitivity[87 * stride + i] = 0.0;
            sensitivity[88 * stride + i] = 0.0;
            sensitivity[89 * stride + i] = 0.0;
            sensitivity[90 * stride + i] = -1.0;
            sensitivity[91 * stride + i] = -w18;
            sensitivity[92 * stride + i] = dz_EBY;
            sensitivity[93 * stride + i] = 0.0;
            sensitivity[94 * stride + i] = 0.0;
            sensitivity[95 * stride + i] = 0.0;
            sensitivity[96 * stride + i] = 1.0;
            sensitivity[97 * stride + i] = dz_EAX;
            sensitivity[98 * stride + i] = dz_EBX;
            sensitivity[99 * stride + i] = 0.0;
            sensitivity[100 * stride + i] = -sin_b;
            sensitivity[101 * stride + i] = 0.0;
            sensitivity[102 * stride + i] = cos_b;
            sensitivity[103 * stride + i] = cos_b*q_Sy + cos_b*q_Ty + cos_b*ry;
            sensitivity[104 * stride + i] = -w16;
            sensitivity[105 * stride + i] = q_Sy*sin_b + q_Ty*sin_b + ry*sin_b;
            sensitivity[106 * stride + i] = 0.0;
            sensitivity[107 * stride + i] = 0.0;
            sensitivity[108 * stride + i] = -1.0;
            sensitivity[109 * stride + i] = dz_EAC;
            sensitivity[110 * stride + i] = dz_EBC;
            sensitivity[111 * stride + i] = 0.0;
            sensitivity[112 * stride + i] = 0.0;
            sensitivity[113 * stride + i] = 0.0;
            sensitivity[114 * stride + i] = q_Cy - w18;
            sensitivity[115 * stride + i] = dz_EBY - q_Cx;
            sensitivity[116 * stride + i] = 0.0;
            sensitivity[117 * stride + i] = dz_EAX;
            sensitivity[118 * stride + i] = dz_EBX;
            sensitivity[119 * stride + i] = 0.0;
            sensitivity[120 * stride + i] = 1.0;
            sensitivity[121 * stride + i] = dz_EA0B;
            sensitivity[122 * stride + i] = 0.0;
        }
    }
}

/*
 * Ideal position of a tool point in the bed frame.
 * Source: Eqs. (1)-(4) without errors. Operations: 33 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out ideal: 3 rows of stride, mm; tool point in the bed frame, without errors (px py pz)
 */
void dmu60p_5axis_tool_in_bed_ideal(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT ideal)
{
    /* once per call */
    const double q_Bx = parameters[6];
    const double q_By = parameters[7];
    const double q_Bz = parameters[8];
    const double q_Sx = parameters[9];
    const double q_Sy = parameters[10];
    const double q_Sz = parameters[11];
    const double q_Tx = parameters[12];
    const double q_Ty = parameters[13];
    const double q_Tz = parameters[14];
    for (size_t start = 0; start < n; start += BLOCK) {
        const size_t count = n - start < BLOCK ? n - start : (size_t)BLOCK;
        /* cosines and sines */
        double cos_b_block[BLOCK];
        double sin_b_block[BLOCK];
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double b = positions[3 * stride + i];
            cos_b_block[j] = cos(0.017453292519943295*b);
            sin_b_block[j] = sin(0.017453292519943295*b);
        }
        /* per point */
        POINTS_ARE_INDEPENDENT
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double cos_b = cos_b_block[j];
            const double sin_b = sin_b_block[j];
            const double x = positions[0 * stride + i];
            const double z = positions[2 * stride + i];
            const double rx = point[0 * stride + i];
            const double ry = point[1 * stride + i];
            const double rz = point[2 * stride + i];
            ideal[0 * stride + i] = cos_b*q_Sx + cos_b*q_Tx + cos_b*rx + q_Bx + q_Sz*sin_b + q_Tz*sin_b + rz*sin_b + x;
            ideal[1 * stride + i] = q_By + q_Sy + q_Ty + ry;
            ideal[2 * stride + i] = cos_b*q_Sz + cos_b*q_Tz + cos_b*rz + q_Bz - q_Sx*sin_b - q_Tx*sin_b - rx*sin_b + z;
        }
    }
}

/*
 * Deviation of a tool point in the bed frame, exact.
 * Source: Eqs. (1)-(4). Operations: 105 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; tool point in the bed frame, actual minus ideal (dx dy dz)
 */
void dmu60p_5axis_tool_in_bed_deviation(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation)
{
    /* once per call */
    const double q_Bx = parameters[6];
    const double q_By = parameters[7];
    const double q_Bz = parameters[8];
    const double q_Sx = parameters[9];
    const double q_Sy = parameters[10];
    const double q_Sz = parameters[11];
    const double q_Tx = parameters[12];
    const double q_Ty = parameters[13];
    const double q_Tz = parameters[14];
    const double eps_xy = parameters[19];
    const double eps_yz = parameters[20];
    const double eps_xz = parameters[21];
    const double EX0B = parameters[22];
    const double EZ0B = parameters[23];
    const double EA0B = parameters[24];
    const double EC0B = parameters[25];
    for (size_t start = 0; start < n; start += BLOCK) {
        const size_t count = n - start < BLOCK ? n - start : (size_t)BLOCK;
        /* cosines and sines */
        double cos_b_block[BLOCK];
        double sin_b_block[BLOCK];
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double b = positions[3 * stride + i];
            cos_b_block[j] = cos(0.017453292519943295*b);
            sin_b_block[j] = sin(0.017453292519943295*b);
        }
        /* per point */
        POINTS_ARE_INDEPENDENT
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double cos_b = cos_b_block[j];
            const double sin_b = sin_b_block[j];
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
            const double EXB = errors[18 * stride + i];
            const double EYB = errors[19 * stride + i];
            const double EZB = errors[20 * stride + i];
            const double EAB = errors[21 * stride + i];
            const double EBB = errors[22 * stride + i];
            const double ECB = errors[23 * stride + i];
            const double rx = point[0 * stride + i];
            const double ry = point[1 * stride + i];
            const double rz = point[2 * stride + i];
            const double w0 = q_Ty + ry;
            const double w1 = q_Sy + w0;
            const double w2 = q_By + w1;
            const double w3 = q_Tx + rx;
            const double w4 = q_Sx + w3;
            const double w5 = q_Tz + rz;
            const double w6 = q_Sz + w5;
            const double w7 = -EAB*w6 + ECB*w4 + EYB;
            const double w8 = cos_b*w4 + sin_b*w6;
            const double w9 = cos_b*w6 - sin_b*w4;
            const double w10 = EBB*w6 - ECB*w1 + EXB;
            const double w11 = EAB*w1 - EBB*w4 + EZB;
            const double w12 = cos_b*w10 + sin_b*w11;
            const double w13 = cos_b*w11 - sin_b*w10;
            const double w14 = -EA0B*(w13 + w9) + EC0B*(w12 + w8) + w7;
            const double w15 = w14 + w2;
            const double w16 = w1 + w7;
            const double w17 = -EC0B*w16 + EX0B + w12;
            const double w18 = q_Bx + w8;
            const double w19 = w17 + w18;
            const double w20 = EA0B*w16 + EZ0B + w13;
            const double w21 = EAZ*w15 - EBZ*w19 + EZZ + w20;
            const double w22 = q_Bz + w9;
            const double w23 = w22 + z;
            const double w24 = w21 + w23;
            const double w25 = w20 + w22;
            const double w26 = -EAZ*w25 + ECZ*w19 + EYZ + w14;
            const double w27 = -eps_yz*w24 + w26;
            const double w28 = w2 + w27;
            const double w29 = EBZ*w25 - ECZ*w15 + EXZ + w17;
            const double w30 = eps_xz*w24 + w29;
            const double w31 = w18 + w30;
            const double w32 = -eps_xz*(w18 + w29) + eps_yz*(w2 + w26) + w21;
            const double w33 = w23 + w32;
            const double w34 = EBX*w33 - ECX*w28 + EXX + w30;
            const double w35 = -EAX*w33 + ECX*w31 + EYX + w27;
            const double w36 = w18 + x;
            deviation[0 * stride + i] = -eps_xy*(w2 + w35) + w34;
            deviation[1 * stride + i] = eps_xy*(w34 + w36) + w35;
            deviation[2 * stride + i] = EAX*w28 - EBX*w31 + EZX + w32;
        }
    }
}

/*
 * Deviation of a tool point in the bed frame, to first order in the errors.
 * Source: Eqs. (1)-(4). Operations: 91 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; tool point in the bed frame, actual minus ideal (dx dy dz)
 */
void dmu60p_5axis_tool_in_bed_deviation_first_order(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation)
{
    /* once per call */
    const double q_Bx = parameters[6];
    const double q_By = parameters[7];
    const double q_Bz = parameters[8];
    const double q_Sx = parameters[9];
    const double q_Sy = parameters[10];
    const double q_Sz = parameters[11];
    const double q_Tx = parameters[12];
    const double q_Ty = parameters[13];
    const double q_Tz = parameters[14];
    const double eps_xy = parameters[19];
    const double eps_yz = parameters[20];
    const double eps_xz = parameters[21];
    const double EX0B = parameters[22];
    const double EZ0B = parameters[23];
    const double EA0B = parameters[24];
    const double EC0B = parameters[25];
    for (size_t start = 0; start < n; start += BLOCK) {
        const size_t count = n - start < BLOCK ? n - start : (size_t)BLOCK;
        /* cosines and sines */
        double cos_b_block[BLOCK];
        double sin_b_block[BLOCK];
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double b = positions[3 * stride + i];
            cos_b_block[j] = cos(0.017453292519943295*b);
            sin_b_block[j] = sin(0.017453292519943295*b);
        }
        /* per point */
        POINTS_ARE_INDEPENDENT
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double cos_b = cos_b_block[j];
            const double sin_b = sin_b_block[j];
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
            const double EXB = errors[18 * stride + i];
            const double EYB = errors[19 * stride + i];
            const double EZB = errors[20 * stride + i];
            const double EAB = errors[21 * stride + i];
            const double EBB = errors[22 * stride + i];
            const double ECB = errors[23 * stride + i];
            const double rx = point[0 * stride + i];
            const double ry = point[1 * stride + i];
            const double rz = point[2 * stride + i];
            const double w0 = q_Tx + rx;
            const double w1 = q_Sx + w0;
            const double w2 = q_Tz + rz;
            const double w3 = q_Sz + w2;
            const double w4 = cos_b*w1 + sin_b*w3;
            const double w5 = q_Bx + w4;
            const double w6 = q_Ty + ry;
            const double w7 = q_Sy + w6;
            const double w8 = q_By + w7;
            const double w9 = EBB*w3 - ECB*w7 + EXB;
            const double w10 = EAB*w7 - EBB*w1 + EZB;
            const double w11 = cos_b*w10 - sin_b*w9;
            const double w12 = EA0B*w7 + EZ0B + w11;
            const double w13 = EAZ*w8 - EBZ*w5 + EZZ + w12;
            const double w14 = -eps_xz*w5 + eps_yz*w8 + w13;
            const double w15 = cos_b*w3 - sin_b*w1;
            const double w16 = q_Bz + w15;
            const double w17 = w16 + z;
            const double w18 = cos_b*w9 + sin_b*w10;
            const double w19 = -EC0B*w7 + EX0B + w18;
            const double w20 = EBZ*w16 - ECZ*w8 + EXZ + w19;
            const double w21 = eps_xz*w17 + w20;
            const double w22 = EBX*w17 - ECX*w8 + EXX + w21;
            const double w23 = -EAB*w3 + ECB*w1 + EYB;
            const double w24 = -EA0B*w15 + EC0B*w4 + w23;
            const double w25 = -EAZ*w16 + ECZ*w5 + EYZ + w24;
            const double w26 = -eps_yz*w17 + w25;
            const double w27 = -EAX*w17 + ECX*w5 + EYX + w26;
            const double w28 = w5 + x;
            deviation[0 * stride + i] = -eps_xy*w8 + w22;
            deviation[1 * stride + i] = eps_xy*w28 + w27;
            deviation[2 * stride + i] = EAX*w8 - EBX*w5 + EZX + w14;
        }
    }
}

/*
 * Sensitivity of a tool point in the bed frame to every error, at the error-free machine.
 * Source: Eqs. (1)-(4), first order. Operations: 57 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out sensitivity: 123 rows of stride, mm/mm, mm/rad; derivative of the deviation by each component error, then by
 *     each location error (dx_EXX dx_EYX .. dz_EC0B, last index fastest)
 */
void dmu60p_5axis_tool_in_bed_sensitivity(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT sensitivity)
{
    /* once per call */
    const double q_Bx = parameters[6];
    const double q_By = parameters[7];
    const double q_Bz = parameters[8];
    const double q_Sx = parameters[9];
    const double q_Sy = parameters[10];
    const double q_Sz = parameters[11];
    const double q_Tx = parameters[12];
    const double q_Ty = parameters[13];
    const double q_Tz = parameters[14];
    for (size_t start = 0; start < n; start += BLOCK) {
        const size_t count = n - start < BLOCK ? n - start : (size_t)BLOCK;
        /* cosines and sines */
        double cos_b_block[BLOCK];
        double sin_b_block[BLOCK];
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double b = positions[3 * stride + i];
            cos_b_block[j] = cos(0.017453292519943295*b);
            sin_b_block[j] = sin(0.017453292519943295*b);
        }
        /* per point */
        POINTS_ARE_INDEPENDENT
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double cos_b = cos_b_block[j];
            const double sin_b = sin_b_block[j];
            const double x = positions[0 * stride + i];
            const double z = positions[2 * stride + i];
            const double rx = point[0 * stride + i];
            const double ry = point[1 * stride + i];
            const double rz = point[2 * stride + i];
            const double dx_EBB = cos_b*q_Sz + cos_b*q_Tz + cos_b*rz - q_Sx*sin_b - q_Tx*sin_b - rx*sin_b;
            const double dx_EBZ = dx_EBB + q_Bz;
            const double dx_EBX = dx_EBZ + z;
            const double dz_EA0B = q_Sy + q_Ty + ry;
            const double dz_EAX = dz_EA0B + q_By;
            const double dx_ECX = -dz_EAX;
            const double dx_EAB = q_Sy*sin_b + q_Ty*sin_b + ry*sin_b;
            const double dz_EAB = cos_b*q_Sy + cos_b*q_Ty + cos_b*ry;
            const double dy_EAX = -dx_EBX;
            const double dy_EC0B = cos_b*q_Sx + cos_b*q_Tx + cos_b*rx + q_Sz*sin_b + q_Tz*sin_b + rz*sin_b;
            const double dy_ECX = dy_EC0B + q_Bx;
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
            sensitivity[18 * stride + i] = cos_b;
            sensitivity[19 * stride + i] = 0.0;
            sensitivity[20 * stride + i] = sin_b;
            sensitivity[21 * stride + i] = dx_EAB;
            sensitivity[22 * stride + i] = dx_EBB;
            sensitivity[23 * stride + i] = -dz_EAB;
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
            sensitivity[34 * stride + i] = dx_ECX;
            sensitivity[35 * stride + i] = 0.0;
            sensitivity[36 * stride + i] = dx_EBX;
            sensitivity[37 * stride + i] = 1.0;
            sensitivity[38 * stride + i] = 0.0;
            sensitivity[39 * stride + i] = 0.0;
            sensitivity[40 * stride + i] = -dz_EA0B;
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
            sensitivity[60 * stride + i] = 1.0;
            sensitivity[61 * stride + i] = 0.0;
            sensitivity[62 * stride + i] = -q_Sz - q_Tz - rz;
            sensitivity[63 * stride + i] = 0.0;
            sensitivity[64 * stride + i] = q_Sx + q_Tx + rx;
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
            sensitivity[75 * stride + i] = dy_ECX + x;
            sensitivity[76 * stride + i] = dy_EAX;
            sensitivity[77 * stride + i] = 0.0;
            sensitivity[78 * stride + i] = 0.0;
            sensitivity[79 * stride + i] = 0.0;
            sensitivity[80 * stride + i] = -dx_EBB;
            sensitivity[81 * stride + i] = dy_EC0B;
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
            sensitivity[100 * stride + i] = -sin_b;
            sensitivity[101 * stride + i] = 0.0;
            sensitivity[102 * stride + i] = cos_b;
            sensitivity[103 * stride + i] = dz_EAB;
            sensitivity[104 * stride + i] = -dy_EC0B;
            sensitivity[105 * stride + i] = dx_EAB;
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
            sensitivity[117 * stride + i] = dz_EAX;
            sensitivity[118 * stride + i] = dz_EBX;
            sensitivity[119 * stride + i] = 0.0;
            sensitivity[120 * stride + i] = 1.0;
            sensitivity[121 * stride + i] = dz_EA0B;
            sensitivity[122 * stride + i] = 0.0;
        }
    }
}

/*
 * Ideal position of a workpiece point in the bed frame.
 * Source: Eqs. (1)-(4) without errors. Operations: 23 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in point: 3 rows of stride, mm; point in the workpiece frame (rx ry rz)
 * out ideal: 3 rows of stride, mm; workpiece point in the bed frame, without errors (px py pz)
 */
void dmu60p_5axis_workpiece_in_bed_ideal(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT ideal)
{
    /* once per call */
    const double q_Cx = parameters[0];
    const double q_Cy = parameters[1];
    const double q_Cz = parameters[2];
    const double q_wx = parameters[3];
    const double q_wy = parameters[4];
    const double q_wz = parameters[5];
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
            const double y = positions[1 * stride + i];
            const double rx = point[0 * stride + i];
            const double ry = point[1 * stride + i];
            const double rz = point[2 * stride + i];
            ideal[0 * stride + i] = cos_c*q_wx + cos_c*rx + q_Cx - q_wy*sin_c - ry*sin_c;
            ideal[1 * stride + i] = cos_c*q_wy + cos_c*ry + q_Cy + q_wx*sin_c + rx*sin_c + y;
            ideal[2 * stride + i] = q_Cz + q_wz + rz;
        }
    }
}

/*
 * Deviation of a workpiece point in the bed frame, exact.
 * Source: Eqs. (1)-(4). Operations: 65 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in point: 3 rows of stride, mm; point in the workpiece frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; workpiece point in the bed frame, actual minus ideal (dx dy dz)
 */
void dmu60p_5axis_workpiece_in_bed_deviation(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation)
{
    /* once per call */
    const double q_Cx = parameters[0];
    const double q_Cy = parameters[1];
    const double q_Cz = parameters[2];
    const double q_wx = parameters[3];
    const double q_wy = parameters[4];
    const double q_wz = parameters[5];
    const double EX0C = parameters[15];
    const double EY0C = parameters[16];
    const double EA0C = parameters[17];
    const double EB0C = parameters[18];
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
            const double EXY = errors[6 * stride + i];
            const double EYY = errors[7 * stride + i];
            const double EZY = errors[8 * stride + i];
            const double EAY = errors[9 * stride + i];
            const double EBY = errors[10 * stride + i];
            const double ECY = errors[11 * stride + i];
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
            const double w2 = EAC*w1 - EBC*w0 + EZC;
            const double w3 = cos_c*w0 - sin_c*w1;
            const double w4 = cos_c*w1 + sin_c*w0;
            const double w5 = q_wz + rz;
            const double w6 = EBC*w5 - ECC*w1 + EXC;
            const double w7 = -EAC*w5 + ECC*w0 + EYC;
            const double w8 = cos_c*w6 - sin_c*w7;
            const double w9 = cos_c*w7 + sin_c*w6;
            const double w10 = EA0C*(w4 + w9) - EB0C*(w3 + w8) + w2;
            const double w11 = q_Cz + w5;
            const double w12 = w10 + w11;
            const double w13 = w2 + w5;
            const double w14 = -EA0C*w13 + EY0C + w9;
            const double w15 = q_Cy + w4;
            const double w16 = w14 + w15;
            const double w17 = EB0C*w13 + EX0C + w8;
            const double w18 = q_Cx + w3;
            const double w19 = w17 + w18;
            deviation[0 * stride + i] = EBY*w12 - ECY*w16 + EXY + w17;
            deviation[1 * stride + i] = -EAY*w12 + ECY*w19 + EYY + w14;
            deviation[2 * stride + i] = EAY*w16 - EBY*w19 + EZY + w10;
        }
    }
}

/*
 * Deviation of a workpiece point in the bed frame, to first order in the errors.
 * Source: Eqs. (1)-(4). Operations: 59 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in point: 3 rows of stride, mm; point in the workpiece frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; workpiece point in the bed frame, actual minus ideal (dx dy dz)
 */
void dmu60p_5axis_workpiece_in_bed_deviation_first_order(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation)
{
    /* once per call */
    const double q_Cx = parameters[0];
    const double q_Cy = parameters[1];
    const double q_Cz = parameters[2];
    const double q_wx = parameters[3];
    const double q_wy = parameters[4];
    const double q_wz = parameters[5];
    const double EX0C = parameters[15];
    const double EY0C = parameters[16];
    const double EA0C = parameters[17];
    const double EB0C = parameters[18];
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
            const double EXY = errors[6 * stride + i];
            const double EYY = errors[7 * stride + i];
            const double EZY = errors[8 * stride + i];
            const double EAY = errors[9 * stride + i];
            const double EBY = errors[10 * stride + i];
            const double ECY = errors[11 * stride + i];
            const double EXC = errors[24 * stride + i];
            const double EYC = errors[25 * stride + i];
            const double EZC = errors[26 * stride + i];
            const double EAC = errors[27 * stride + i];
            const double EBC = errors[28 * stride + i];
            const double ECC = errors[29 * stride + i];
            const double rx = point[0 * stride + i];
            const double ry = point[1 * stride + i];
            const double rz = point[2 * stride + i];
            const double w0 = q_wz + rz;
            const double w1 = q_wy + ry;
            const double w2 = EBC*w0 - ECC*w1 + EXC;
            const double w3 = q_wx + rx;
            const double w4 = -EAC*w0 + ECC*w3 + EYC;
            const double w5 = cos_c*w2 - sin_c*w4;
            const double w6 = EB0C*w0 + EX0C + w5;
            const double w7 = cos_c*w1 + sin_c*w3;
            const double w8 = q_Cy + w7;
            const double w9 = q_Cz + w0;
            const double w10 = cos_c*w4 + sin_c*w2;
            const double w11 = -EA0C*w0 + EY0C + w10;
            const double w12 = cos_c*w3 - sin_c*w1;
            const double w13 = q_Cx + w12;
            const double w14 = EAC*w1 - EBC*w3 + EZC;
            const double w15 = EA0C*w7 - EB0C*w12 + w14;
            deviation[0 * stride + i] = EBY*w9 - ECY*w8 + EXY + w6;
            deviation[1 * stride + i] = -EAY*w9 + ECY*w13 + EYY + w11;
            deviation[2 * stride + i] = EAY*w8 - EBY*w13 + EZY + w15;
        }
    }
}

/*
 * Sensitivity of a workpiece point in the bed frame to every error, at the error-free machine.
 * Source: Eqs. (1)-(4), first order. Operations: 39 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in point: 3 rows of stride, mm; point in the workpiece frame (rx ry rz)
 * out sensitivity: 123 rows of stride, mm/mm, mm/rad; derivative of the deviation by each component error, then by
 *     each location error (dx_EXX dx_EYX .. dz_EC0B, last index fastest)
 */
void dmu60p_5axis_workpiece_in_bed_sensitivity(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT sensitivity)
{
    /* once per call */
    const double q_Cx = parameters[0];
    const double q_Cy = parameters[1];
    const double q_Cz = parameters[2];
    const double q_wx = parameters[3];
    const double q_wy = parameters[4];
    const double q_wz = parameters[5];
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
            const double rx = point[0 * stride + i];
            const double ry = point[1 * stride + i];
            const double rz = point[2 * stride + i];
            const double dx_EB0C = q_wz + rz;
            const double dx_EBY = dx_EB0C + q_Cz;
            const double dz_EA0C = cos_c*q_wy + cos_c*ry + q_wx*sin_c + rx*sin_c;
            const double dz_EAY = dz_EA0C + q_Cy;
            const double dx_EAC = q_wz*sin_c + rz*sin_c;
            const double dx_EBC = cos_c*q_wz + cos_c*rz;
            const double dy_ECC = cos_c*q_wx + cos_c*rx - q_wy*sin_c - ry*sin_c;
            const double dy_ECY = dy_ECC + q_Cx;
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
            sensitivity[18 * stride + i] = 0.0;
            sensitivity[19 * stride + i] = 0.0;
            sensitivity[20 * stride + i] = 0.0;
            sensitivity[21 * stride + i] = 0.0;
            sensitivity[22 * stride + i] = 0.0;
            sensitivity[23 * stride + i] = 0.0;
            sensitivity[24 * stride + i] = cos_c;
            sensitivity[25 * stride + i] = -sin_c;
            sensitivity[26 * stride + i] = 0.0;
            sensitivity[27 * stride + i] = dx_EAC;
            sensitivity[28 * stride + i] = dx_EBC;
            sensitivity[29 * stride + i] = -dz_EA0C;
            sensitivity[30 * stride + i] = 1.0;
            sensitivity[31 * stride + i] = 0.0;
            sensitivity[32 * stride + i] = 0.0;
            sensitivity[33 * stride + i] = dx_EB0C;
            sensitivity[34 * stride + i] = 0.0;
            sensitivity[35 * stride + i] = 0.0;
            sensitivity[36 * stride + i] = 0.0;
            sensitivity[37 * stride + i] = 0.0;
            sensitivity[38 * stride + i] = 0.0;
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
            sensitivity[60 * stride + i] = 0.0;
            sensitivity[61 * stride + i] = 0.0;
            sensitivity[62 * stride + i] = 0.0;
            sensitivity[63 * stride + i] = 0.0;
            sensitivity[64 * stride + i] = 0.0;
            sensitivity[65 * stride + i] = sin_c;
            sensitivity[66 * stride + i] = cos_c;
            sensitivity[67 * stride + i] = 0.0;
            sensitivity[68 * stride + i] = -dx_EBC;
            sensitivity[69 * stride + i] = dx_EAC;
            sensitivity[70 * stride + i] = dy_ECC;
            sensitivity[71 * stride + i] = 0.0;
            sensitivity[72 * stride + i] = 1.0;
            sensitivity[73 * stride + i] = -dx_EB0C;
            sensitivity[74 * stride + i] = 0.0;
            sensitivity[75 * stride + i] = 0.0;
            sensitivity[76 * stride + i] = 0.0;
            sensitivity[77 * stride + i] = 0.0;
            sensitivity[78 * stride + i] = 0.0;
            sensitivity[79 * stride + i] = 0.0;
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
            sensitivity[101 * stride + i] = 0.0;
            sensitivity[102 * stride + i] = 0.0;
            sensitivity[103 * stride + i] = 0.0;
            sensitivity[104 * stride + i] = 0.0;
            sensitivity[105 * stride + i] = 0.0;
            sensitivity[106 * stride + i] = 0.0;
            sensitivity[107 * stride + i] = 0.0;
            sensitivity[108 * stride + i] = 1.0;
            sensitivity[109 * stride + i] = q_wy + ry;
            sensitivity[110 * stride + i] = -q_wx - rx;
            sensitivity[111 * stride + i] = 0.0;
            sensitivity[112 * stride + i] = 0.0;
            sensitivity[113 * stride + i] = 0.0;
            sensitivity[114 * stride + i] = dz_EA0C;
            sensitivity[115 * stride + i] = -dy_ECC;
            sensitivity[116 * stride + i] = 0.0;
            sensitivity[117 * stride + i] = 0.0;
            sensitivity[118 * stride + i] = 0.0;
            sensitivity[119 * stride + i] = 0.0;
            sensitivity[120 * stride + i] = 0.0;
            sensitivity[121 * stride + i] = 0.0;
            sensitivity[122 * stride + i] = 0.0;
        }
    }
}

/*
 * Ideal position of a bed point in the workpiece frame.
 * Source: Eqs. (1)-(4) without errors. Operations: 26 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in point: 3 rows of stride, mm; point in the bed frame (rx ry rz)
 * out ideal: 3 rows of stride, mm; bed point in the workpiece frame, without errors (px py pz)
 */
void dmu60p_5axis_bed_in_workpiece_ideal(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT ideal)
{
    /* once per call */
    const double q_Cx = parameters[0];
    const double q_Cy = parameters[1];
    const double q_Cz = parameters[2];
    const double q_wx = parameters[3];
    const double q_wy = parameters[4];
    const double q_wz = parameters[5];
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
            const double y = positions[1 * stride + i];
            const double rx = point[0 * stride + i];
            const double ry = point[1 * stride + i];
            const double rz = point[2 * stride + i];
            ideal[0 * stride + i] = -cos_c*q_Cx + cos_c*rx - q_Cy*sin_c - q_wx + ry*sin_c - sin_c*y;
            ideal[1 * stride + i] = -cos_c*q_Cy + cos_c*ry - cos_c*y + q_Cx*sin_c - q_wy - rx*sin_c;
            ideal[2 * stride + i] = -q_Cz - q_wz + rz;
        }
    }
}

/*
 * Deviation of a bed point in the workpiece frame, exact.
 * Source: Eqs. (1)-(4). Operations: 142 per point, 5 once per call.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in point: 3 rows of stride, mm; point in the bed frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; bed point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void dmu60p_5axis_bed_in_workpiece_deviation(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation)
{
    /* once per call */
    const double q_Cx = parameters[0];
    const double q_Cy = parameters[1];
    const double q_Cz = parameters[2];
    const double EX0C = parameters[15];
    const double EY0C = parameters[16];
    const double EA0C = parameters[17];
    const double EB0C = parameters[18];
    const double w22 = (EA0C*EA0C) + (EB0C*EB0C);
    const double w23 = (1.0/(w22 + 1.0));
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
            const double y = positions[1 * stride + i];
            const double EXY = errors[6 * stride + i];
            const double EYY = errors[7 * stride + i];
            const double EZY = errors[8 * stride + i];
            const double EAY = errors[9 * stride + i];
            const double EBY = errors[10 * stride + i];
            const double ECY = errors[11 * stride + i];
            const double EXC = errors[24 * stride + i];
            const double EYC = errors[25 * stride + i];
            const double EZC = errors[26 * stride + i];
            const double EAC = errors[27 * stride + i];
            const double EBC = errors[28 * stride + i];
            const double ECC = errors[29 * stride + i];
            const double rx = point[0 * stride + i];
            const double ry = point[1 * stride + i];
            const double rz = point[2 * stride + i];
            const double w0 = -rx;
            const double w1 = -q_Cx - w0;
            const double w2 = ry - y;
            const double w3 = -q_Cy + w2;
            const double w4 = cos_c*w1 + sin_c*w3;
            const double w5 = -EYY + w2;
            const double w6 = -rz;
            const double w7 = -EZY - w6;
            const double w8 = -EXY - w0;
            const double w9 = EAY*w8 + EBY*w5 + ECY*w7;
            const double w10 = (EAY*EAY) + (EBY*EBY) + (ECY*ECY);
            const double w11 = (1.0/(w10 + 1.0));
            const double w12 = w11*(EAY*w9 - EBY*w7 + ECY*w5 - EXY - rx*w10);
            const double w13 = -EX0C + w12;
            const double w14 = w11*(-EAY*w5 + EBY*w8 + ECY*w9 - EZY - rz*w10);
            const double w15 = -q_Cz - w6;
            const double w16 = w14 + w15;
            const double w17 = w1 + w13;
            const double w18 = w11*(EAY*w7 + EBY*w9 - ECY*w8 - EYY - w10*w2);
            const double w19 = -EY0C + w18;
            const double w20 = w19 + w3;
            const double w21 = EA0C*w17 + EB0C*w20;
            const double w24 = w23*(EA0C*w21 - EB0C*w16 - w1*w22 + w13);
            const double w25 = w23*(EA0C*w16 + EB0C*w21 + w19 - w22*w3);
            const double w26 = cos_c*w24 + sin_c*w25;
            const double w27 = -EXC + w26;
            const double w28 = cos_c*w3 - sin_c*w1;
            const double w29 = cos_c*w25 - sin_c*w24;
            const double w30 = -EYC + w29;
            const double w31 = w28 + w30;
            const double w32 = w23*(-EA0C*w20 + EB0C*w17 + w14 - w15*w22);
            const double w33 = -EZC + w32;
            const double w34 = w15 + w33;
            const double w35 = w27 + w4;
            const double w36 = EAC*w35 + EBC*w31 + ECC*w34;
            const double w37 = (EAC*EAC) + (EBC*EBC) + (ECC*ECC);
            const double w38 = (1.0/(w37 + 1.0));
            deviation[0 * stride + i] = w38*(EAC*w36 - EBC*w34 + ECC*w31 + w27 - w37*w4);
            deviation[1 * stride + i] = w38*(EAC*w34 + EBC*w36 - ECC*w35 - w28*w37 + w30);
            deviation[2 * stride + i] = w38*(-EAC*w31 + EBC*w35 + ECC*w36 - w15*w37 + w33);
        }
    }
}

/*
 * Deviation of a bed point in the workpiece frame, to first order in the errors.
 * Source: Eqs. (1)-(4). Operations: 57 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in point: 3 rows of stride, mm; point in the bed frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; bed point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void dmu60p_5axis_bed_in_workpiece_deviation_first_order(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation)
{
    /* once per call */
    const double q_Cx = parameters[0];
    const double q_Cy = parameters[1];
    const double q_Cz = parameters[2];
    const double EX0C = parameters[15];
    const double EY0C = parameters[16];
    const double EA0C = parameters[17];
    const double EB0C = parameters[18];
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
            const double y = positions[1 * stride + i];
            const double EXY = errors[6 * stride + i];
            const double EYY = errors[7 * stride + i];
            const double EZY = errors[8 * stride + i];
            const double EAY = errors[9 * stride + i];
            const double EBY = errors[10 * stride + i];
            const double ECY = errors[11 * stride + i];
            const double EXC = errors[24 * stride + i];
            const double EYC = errors[25 * stride + i];
            const double EZC = errors[26 * stride + i];
            const double EAC = errors[27 * stride + i];
            const double EBC = errors[28 * stride + i];
            const double ECC = errors[29 * stride + i];
            const double rx = point[0 * stride + i];
            const double ry = point[1 * stride + i];
            const double rz = point[2 * stride + i];
            const double w0 = -q_Cz + rz;
            const double w1 = -q_Cx + rx;
            const double w2 = ry - y;
            const double w3 = -q_Cy + w2;
            const double w4 = cos_c*w3 - sin_c*w1;
            const double w5 = -EBY*rz + ECY*w2 - EXY;
            const double w6 = -EB0C*w0 - EX0C + w5;
            const double w7 = EAY*rz - ECY*rx - EYY;
            const double w8 = EA0C*w0 - EY0C + w7;
            const double w9 = cos_c*w6 + sin_c*w8;
            const double w10 = cos_c*w1 + sin_c*w3;
            const double w11 = cos_c*w8 - sin_c*w6;
            const double w12 = -EAY*w2 + EBY*rx - EZY;
            const double w13 = -EA0C*w3 + EB0C*w1 + w12;
            deviation[0 * stride + i] = -EBC*w0 + ECC*w4 - EXC + w9;
            deviation[1 * stride + i] = EAC*w0 - ECC*w10 - EYC + w11;
            deviation[2 * stride + i] = -EAC*w4 + EBC*w10 - EZC + w13;
        }
    }
}

/*
 * Sensitivity of a bed point in the workpiece frame to every error, at the error-free machine.
 * Source: Eqs. (1)-(4), first order. Operations: 48 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in point: 3 rows of stride, mm; point in the bed frame (rx ry rz)
 * out sensitivity: 123 rows of stride, mm/mm, mm/rad; derivative of the deviation by each component error, then by
 *     each location error (dx_EXX dx_EYX .. dz_EC0B, last index fastest)
 */
void dmu60p_5axis_bed_in_workpiece_sensitivity(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT sensitivity)
{
    /* once per call */
    const double q_Cx = parameters[0];
    const double q_Cy = parameters[1];
    const double q_Cz = parameters[2];
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
            const double y = positions[1 * stride + i];
            const double rx = point[0 * stride + i];
            const double ry = point[1 * stride + i];
            const double rz = point[2 * stride + i];
            const double dx_EXY = -cos_c;
            const double dx_EYY = -sin_c;
            const double dx_EAY = rz*sin_c;
            const double dy_EAY = cos_c*rz;
            const double dx_EBY = -dy_EAY;
            const double dx_EBC = q_Cz - rz;
            const double w0 = -cos_c*ry + cos_c*y + rx*sin_c;
            const double dz_EAC = cos_c*q_Cy - q_Cx*sin_c + w0;
            const double dx_EA0C = -q_Cz*sin_c + rz*sin_c;
            const double dx_EB0C = cos_c*q_Cz + dx_EBY;
            const double w1 = cos_c*rx;
            const double w2 = ry*sin_c;
            const double w3 = sin_c*y;
            const double dy_ECC = cos_c*q_Cx + q_Cy*sin_c - w1 - w2 + w3;
            sensitivity[0 * stride + i] = 0.0;
            sensitivity[1 * stride + i] = 0.0;
            sensitivity[2 * stride + i] = 0.0;
            sensitivity[3 * stride + i] = 0.0;
            sensitivity[4 * stride + i] = 0.0;
            sensitivity[5 * stride + i] = 0.0;
            sensitivity[6 * stride + i] = dx_EXY;
            sensitivity[7 * stride + i] = dx_EYY;
            sensitivity[8 * stride + i] = 0.0;
            sensitivity[9 * stride + i] = dx_EAY;
            sensitivity[10 * stride + i] = dx_EBY;
            sensitivity[11 * stride + i] = -w0;
            sensitivity[12 * stride + i] = 0.0;
            sensitivity[13 * stride + i] = 0.0;
            sensitivity[14 * stride + i] = 0.0;
            sensitivity[15 * stride + i] = 0.0;
            sensitivity[16 * stride + i] = 0.0;
            sensitivity[17 * stride + i] = 0.0;
            sensitivity[18 * stride + i] = 0.0;
            sensitivity[19 * stride + i] = 0.0;
            sensitivity[20 * stride + i] = 0.0;
            sensitivity[21 * stride + i] = 0.0;
            sensitivity[22 * stride + i] = 0.0;
            sensitivity[23 * stride + i] = 0.0;
            sensitivity[24 * stride + i] = -1.0;
            sensitivity[25 * stride + i] = 0.0;
            sensitivity[26 * stride + i] = 0.0;
            sensitivity[27 * stride + i] = 0.0;
            sensitivity[28 * stride + i] = dx_EBC;
            sensitivity[29 * stride + i] = -dz_EAC;
            sensitivity[30 * stride + i] = dx_EXY;
            sensitivity[31 * stride + i] = dx_EYY;
            sensitivity[32 * stride + i] = dx_EA0C;
            sensitivity[33 * stride + i] = dx_EB0C;
            sensitivity[34 * stride + i] = 0.0;
            sensitivity[35 * stride + i] = 0.0;
            sensitivity[36 * stride + i] = 0.0;
            sensitivity[37 * stride + i] = 0.0;
            sensitivity[38 * stride + i] = 0.0;
            sensitivity[39 * stride + i] = 0.0;
            sensitivity[40 * stride + i] = 0.0;
            sensitivity[41 * stride + i] = 0.0;
            sensitivity[42 * stride + i] = 0.0;
            sensitivity[43 * stride + i] = 0.0;
            sensitivity[44 * stride + i] = 0.0;
            sensitivity[45 * stride + i] = 0.0;
            sensitivity[46 * stride + i] = 0.0;
            sensitivity[47 * stride + i] = sin_c;
            sensitivity[48 * stride + i] = dx_EXY;
            sensitivity[49 * stride + i] = 0.0;
            sensitivity[50 * stride + i] = dy_EAY;
            sensitivity[51 * stride + i] = dx_EAY;
            sensitivity[52 * stride + i] = -w1 - w2 + w3;
            sensitivity[53 * stride + i] = 0.0;
            sensitivity[54 * stride + i] = 0.0;
            sensitivity[55 * stride + i] = 0.0;
            sensitivity[56 * stride + i] = 0.0;
            sensitivity[57 * stride + i] = 0.0;
            sensitivity[58 * stride + i] = 0.0;
            sensitivity[59 * stride + i] = 0.0;
            sensitivity[60 * stride + i] = 0.0;
            sensitivity[61 * stride + i] = 0.0;
            sensitivity[62 * stride + i] = 0.0;
            sensitivity[63 * stride + i] = 0.0;
            sensitivity[64 * stride + i] = 0.0;
            sensitivity[65 * stride + i] = 0.0;
            sensitivity[66 * stride + i] = -1.0;
            sensitivity[67 * stride + i] = 0.0;
            sensitivity[68 * stride + i] = -dx_EBC;
            sensitivity[69 * stride + i] = 0.0;
            sensitivity[70 * stride + i] = dy_ECC;
            sensitivity[71 * stride + i] = sin_c;
            sensitivity[72 * stride + i] = dx_EXY;
            sensitivity[73 * stride + i] = -dx_EB0C;
            sensitivity[74 * stride + i] = dx_EA0C;
            sensitivity[75 * stride + i] = 0.0;
            sensitivity[76 * stride + i] = 0.0;
            sensitivity[77 * stride + i] = 0.0;
            sensitivity[78 * stride + i] = 0.0;
            sensitivity[79 * stride + i] = 0.0;
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
            sensitivity[90 * stride + i] = -1.0;
            sensitivity[91 * stride + i] = -ry + y;
            sensitivity[92 * stride + i] = rx;
            sensitivity[93 * stride + i] = 0.0;
            sensitivity[94 * stride + i] = 0.0;
            sensitivity[95 * stride + i] = 0.0;
            sensitivity[96 * stride + i] = 0.0;
            sensitivity[97 * stride + i] = 0.0;
            sensitivity[98 * stride + i] = 0.0;
            sensitivity[99 * stride + i] = 0.0;
            sensitivity[100 * stride + i] = 0.0;
            sensitivity[101 * stride + i] = 0.0;
            sensitivity[102 * stride + i] = 0.0;
            sensitivity[103 * stride + i] = 0.0;
            sensitivity[104 * stride + i] = 0.0;
            sensitivity[105 * stride + i] = 0.0;
            sensitivity[106 * stride + i] = 0.0;
            sensitivity[107 * stride + i] = 0.0;
            sensitivity[108 * stride + i] = -1.0;
            sensitivity[109 * stride + i] = dz_EAC;
            sensitivity[110 * stride + i] = -dy_ECC;
            sensitivity[111 * stride + i] = 0.0;
            sensitivity[112 * stride + i] = 0.0;
            sensitivity[113 * stride + i] = 0.0;
            sensitivity[114 * stride + i] = q_Cy - ry + y;
            sensitivity[115 * stride + i] = -q_Cx + rx;
            sensitivity[116 * stride + i] = 0.0;
            sensitivity[117 * stride + i] = 0.0;
            sensitivity[118 * stride + i] = 0.0;
            sensitivity[119 * stride + i] = 0.0;
            sensitivity[120 * stride + i] = 0.0;
            sensitivity[121 * stride + i] = 0.0;
            sensitivity[122 * stride + i] = 0.0;
        }
    }
}

/*
 * Actual position of the tool point in the workpiece frame, exact.
 * Source: Eq. (4). Operations: 250 per point, 5 once per call.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out position: 3 rows of stride, mm; actual position P_T^W of the tool point in the workpiece frame (px py pz)
 */
void dmu60p_5axis_tool_in_workpiece_position(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT position)
{
    /* once per call */
    const double q_Cx = parameters[0];
    const double q_Cy = parameters[1];
    const double q_Cz = parameters[2];
    const double q_wx = parameters[3];
    const double q_wy = parameters[4];
    const double q_wz = parameters[5];
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
    for (size_t start = 0; start < n; start += BLOCK) {
        const size_t count = n - start < BLOCK ? n - start : (size_t)BLOCK;
        /* cosines and sines */
        double cos_b_block[BLOCK];
        double sin_b_block[BLOCK];
        double cos_c_block[BLOCK];
        double sin_c_block[BLOCK];
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double b = positions[3 * stride + i];
            const double c = positions[4 * stride + i];
            cos_b_block[j] = cos(0.017453292519943295*b);
            sin_b_block[j] = sin(0.017453292519943295*b);
            cos_c_block[j] = cos(0.017453292519943295*c);
            sin_c_block[j] = sin(0.017453292519943295*c);
        }
        /* per point */
        POINTS_ARE_INDEPENDENT
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double cos_b = cos_b_block[j];
            const double sin_b = sin_b_block[j];
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
            const double EXB = errors[18 * stride + i];
            const double EYB = errors[19 * stride + i];
            const double EZB = errors[20 * stride + i];
            const double EAB = errors[21 * stride + i];
            const double EBB = errors[22 * stride + i];
            const double ECB = errors[23 * stride + i];
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
            const double w80 = w79*(EAC*w77 - EBC*w75 + ECC*w72 - w13*w78 + w68);
            const double w81 = -q_wx + w13;
            const double w82 = w79*(EAC*w75 + EBC*w77 - ECC*w76 - w69*w78 + w71);
            const double w83 = -q_wy + w69;
            const double w84 = w79*(-EAC*w72 + EBC*w76 + ECC*w77 - w56*w78 + w74);
            const double w85 = -q_wz + w56;
            position[0 * stride + i] = w80 + w81;
            position[1 * stride + i] = w82 + w83;
            position[2 * stride + i] = w84 + w85;
        }
    }
}

/*
 * Actual position of the tool point in the workpiece frame, to first order.
 * Source: Eq. (4). Operations: 157 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out position: 3 rows of stride, mm; actual position P_T^W of the tool point in the workpiece frame (px py pz)
 */
void dmu60p_5axis_tool_in_workpiece_position_first_order(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT position)
{
    /* once per call */
    const double q_Cx = parameters[0];
    const double q_Cy = parameters[1];
    const double q_Cz = parameters[2];
    const double q_wx = parameters[3];
    const double q_wy = parameters[4];
    const double q_wz = parameters[5];
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
    for (size_t start = 0; start < n; start += BLOCK) {
        const size_t count = n - start < BLOCK ? n - start : (size_t)BLOCK;
        /* cosines and sines */
        double cos_b_block[BLOCK];
        double sin_b_block[BLOCK];
        double cos_c_block[BLOCK];
        double sin_c_block[BLOCK];
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double b = positions[3 * stride + i];
            const double c = positions[4 * stride + i];
            cos_b_block[j] = cos(0.017453292519943295*b);
            sin_b_block[j] = sin(0.017453292519943295*b);
            cos_c_block[j] = cos(0.017453292519943295*c);
            sin_c_block[j] = sin(0.017453292519943295*c);
        }
        /* per point */
        POINTS_ARE_INDEPENDENT
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double cos_b = cos_b_block[j];
            const double sin_b = sin_b_block[j];
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
            const double EXB = errors[18 * stride + i];
            const double EYB = errors[19 * stride + i];
            const double EZB = errors[20 * stride + i];
            const double EAB = errors[21 * stride + i];
            const double EBB = errors[22 * stride + i];
            const double ECB = errors[23 * stride + i];
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
            const double w1 = q_Sx + w0;
            const double w2 = q_Tz + rz;
            const double w3 = q_Sz + w2;
            const double w4 = cos_b*w3 - sin_b*w1;
            const double w5 = q_Bz + w4;
            const double w6 = w5 + z;
            const double w7 = -q_Cz + w6;
            const double w8 = cos_b*w1 + sin_b*w3;
            const double w9 = q_Bx + w8;
            const double w10 = w9 + x;
            const double w11 = -q_Cx + w10;
            const double w12 = q_Ty + ry;
            const double w13 = q_Sy + w12;
            const double w14 = q_By + w13;
            const double w15 = w14 - y;
            const double w16 = -q_Cy + w15;
            const double w17 = cos_c*w16 - sin_c*w11;
            const double w18 = EBB*w3 - ECB*w13 + EXB;
            const double w19 = EAB*w13 - EBB*w1 + EZB;
            const double w20 = cos_b*w18 + sin_b*w19;
            const double w21 = -EC0B*w13 + EX0B + w20;
            const double w22 = EBZ*w5 - ECZ*w14 + EXZ + w21;
            const double w23 = eps_xz*w6 + w22;
            const double w24 = EBX*w6 - ECX*w14 + EXX + w23;
            const double w25 = -eps_xy*w14 + w24;
            const double w26 = -EBY*w6 + ECY*w15 - EXY + w25;
            const double w27 = -EB0C*w7 - EX0C + w26;
            const double w28 = -EAB*w3 + ECB*w1 + EYB;
            const double w29 = -EA0B*w4 + EC0B*w8 + w28;
            const double w30 = -EAZ*w5 + ECZ*w9 + EYZ + w29;
            const double w31 = -eps_yz*w6 + w30;
            const double w32 = -EAX*w6 + ECX*w9 + EYX + w31;
            const double w33 = eps_xy*w10 + w32;
            const double w34 = EAY*w6 - ECY*w10 - EYY + w33;
            const double w35 = EA0C*w7 - EY0C + w34;
            const double w36 = cos_c*w27 + sin_c*w35;
            const double w37 = -EBC*w7 + ECC*w17 - EXC + w36;
            const double w38 = cos_c*w11 + sin_c*w16;
            const double w39 = -q_wx + w38;
            const double w40 = cos_c*w35 - sin_c*w27;
            const double w41 = EAC*w7 - ECC*w38 - EYC + w40;
            const double w42 = -q_wy + w17;
            const double w43 = cos_b*w19 - sin_b*w18;
            const double w44 = EA0B*w13 + EZ0B + w43;
            const double w45 = EAZ*w14 - EBZ*w9 + EZZ + w44;
            const double w46 = -eps_xz*w9 + eps_yz*w14 + w45;
            const double w47 = EAX*w14 - EBX*w9 + EZX + w46;
            const double w48 = -EAY*w15 + EBY*w10 - EZY + w47;
            const double w49 = -EA0C*w16 + EB0C*w11 + w48;
            const double w50 = -EAC*w17 + EBC*w38 - EZC + w49;
            const double w51 = -q_wz + w7;
            position[0 * stride + i] = w37 + w39;
            position[1 * stride + i] = w41 + w42;
            position[2 * stride + i] = w50 + w51;
        }
    }
}

/*
 * Ideal direction of a vector of the tool frame in the workpiece frame.
 * Source: Eqs. (1)-(4) without errors, rotations alone. Operations: 20 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in direction: 3 rows of stride, 1; unit vector in the tool frame, (0, 0, 1) for the tool axis (tx ty tz)
 * out ideal: 3 rows of stride, 1; the vector in the workpiece frame, without errors (ix iy iz)
 */
void dmu60p_5axis_tool_orientation_ideal(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT direction,
    double *TRUEAXIS_RESTRICT ideal)
{
    for (size_t start = 0; start < n; start += BLOCK) {
        const size_t count = n - start < BLOCK ? n - start : (size_t)BLOCK;
        /* cosines and sines */
        double cos_b_block[BLOCK];
        double sin_b_block[BLOCK];
        double cos_c_block[BLOCK];
        double sin_c_block[BLOCK];
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double b = positions[3 * stride + i];
            const double c = positions[4 * stride + i];
            cos_b_block[j] = cos(0.017453292519943295*b);
            sin_b_block[j] = sin(0.017453292519943295*b);
            cos_c_block[j] = cos(0.017453292519943295*c);
            sin_c_block[j] = sin(0.017453292519943295*c);
        }
        /* per point */
        POINTS_ARE_INDEPENDENT
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double cos_b = cos_b_block[j];
            const double sin_b = sin_b_block[j];
            const double cos_c = cos_c_block[j];
            const double sin_c = sin_c_block[j];
            const double tx = direction[0 * stride + i];
            const double ty = direction[1 * stride + i];
            const double tz = direction[2 * stride + i];
            const double w0 = cos_b*tx + sin_b*tz;
            ideal[0 * stride + i] = cos_c*w0 + sin_c*ty;
            ideal[1 * stride + i] = cos_c*ty - sin_c*w0;
            ideal[2 * stride + i] = cos_b*tz - sin_b*tx;
        }
    }
}

/*
 * Deviation of a direction of the tool frame in the workpiece frame, exact.
 * Source: Eqs. (1)-(4), rotations alone. Operations: 210 per point, 5 once per call.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in direction: 3 rows of stride, 1; unit vector in the tool frame, (0, 0, 1) for the tool axis (tx ty tz)
 * out deviation: 3 rows of stride, 1; the vector in the workpiece frame, actual minus ideal (dx dy dz)
 */
void dmu60p_5axis_tool_orientation_deviation(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT direction,
    double *TRUEAXIS_RESTRICT deviation)
{
    /* once per call */
    const double EA0C = parameters[17];
    const double EB0C = parameters[18];
    const double eps_xy = parameters[19];
    const double eps_yz = parameters[20];
    const double eps_xz = parameters[21];
    const double EA0B = parameters[24];
    const double EC0B = parameters[25];
    const double w43 = (EA0C*EA0C) + (EB0C*EB0C);
    const double w44 = (1.0/(w43 + 1.0));
    for (size_t start = 0; start < n; start += BLOCK) {
        const size_t count = n - start < BLOCK ? n - start : (size_t)BLOCK;
        /* cosines and sines */
        double cos_b_block[BLOCK];
        double sin_b_block[BLOCK];
        double cos_c_block[BLOCK];
        double sin_c_block[BLOCK];
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double b = positions[3 * stride + i];
            const double c = positions[4 * stride + i];
            cos_b_block[j] = cos(0.017453292519943295*b);
            sin_b_block[j] = sin(0.017453292519943295*b);
            cos_c_block[j] = cos(0.017453292519943295*c);
            sin_c_block[j] = sin(0.017453292519943295*c);
        }
        /* per point */
        POINTS_ARE_INDEPENDENT
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double cos_b = cos_b_block[j];
            const double sin_b = sin_b_block[j];
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
            const double EAB = errors[21 * stride + i];
            const double EBB = errors[22 * stride + i];
            const double ECB = errors[23 * stride + i];
            const double EAC = errors[27 * stride + i];
            const double EBC = errors[28 * stride + i];
            const double ECC = errors[29 * stride + i];
            const double tx = direction[0 * stride + i];
            const double ty = direction[1 * stride + i];
            const double tz = direction[2 * stride + i];
            const double w0 = cos_b*tx + sin_b*tz;
            const double w1 = cos_c*w0 + sin_c*ty;
            const double w2 = cos_b*tz - sin_b*tx;
            const double w3 = -EAB*tz + ECB*tx;
            const double w4 = ty + w3;
            const double w5 = EBB*tz - ECB*ty;
            const double w6 = EAB*ty - EBB*tx;
            const double w7 = cos_b*w6 - sin_b*w5;
            const double w8 = EA0B*w4 + w7;
            const double w9 = w2 + w8;
            const double w10 = cos_b*w5 + sin_b*w6;
            const double w11 = -EA0B*(w2 + w7) + EC0B*(w0 + w10) + w3;
            const double w12 = ty + w11;
            const double w13 = -EC0B*w4 + w10;
            const double w14 = EBZ*w9 - ECZ*w12 + w13;
            const double w15 = w0 + w13;
            const double w16 = -EAZ*w9 + ECZ*w15 + w11;
            const double w17 = EAZ*w12 - EBZ*w15 + w8;
            const double w18 = -eps_xz*(w0 + w14) + eps_yz*(ty + w16) + w17;
            const double w19 = w18 + w2;
            const double w20 = w17 + w2;
            const double w21 = -eps_yz*w20 + w16;
            const double w22 = ty + w21;
            const double w23 = eps_xz*w20 + w14;
            const double w24 = EBX*w19 - ECX*w22 + w23;
            const double w25 = w0 + w23;
            const double w26 = -EAX*w19 + ECX*w25 + w21;
            const double w27 = -eps_xy*(ty + w26) + w24;
            const double w28 = eps_xy*(w0 + w24) + w26;
            const double w29 = ty + w28;
            const double w30 = EAX*w22 - EBX*w25 + w18;
            const double w31 = w2 + w30;
            const double w32 = w0 + w27;
            const double w33 = EAY*w32 + EBY*w29 + ECY*w31;
            const double w34 = (EAY*EAY) + (EBY*EBY) + (ECY*ECY);
            const double w35 = (1.0/(w34 + 1.0));
            const double w36 = w35*(EAY*w33 - EBY*w31 + ECY*w29 - w0*w34 + w27);
            const double w37 = w35*(-EAY*w29 + EBY*w32 + ECY*w33 - w2*w34 + w30);
            const double w38 = w2 + w37;
            const double w39 = w0 + w36;
            const double w40 = w35*(EAY*w31 + EBY*w33 - ECY*w32 - ty*w34 + w28);
            const double w41 = ty + w40;
            const double w42 = EA0C*w39 + EB0C*w41;
            const double w45 = w44*(EA0C*w42 - EB0C*w38 - w0*w43 + w36);
            const double w46 = w44*(EA0C*w38 + EB0C*w42 - ty*w43 + w40);
            const double w47 = cos_c*w45 + sin_c*w46;
            const double w48 = cos_c*ty - sin_c*w0;
            const double w49 = cos_c*w46 - sin_c*w45;
            const double w50 = w48 + w49;
            const double w51 = w44*(-EA0C*w41 + EB0C*w39 - w2*w43 + w37);
            const double w52 = w2 + w51;
            const double w53 = w1 + w47;
            const double w54 = EAC*w53 + EBC*w50 + ECC*w52;
            const double w55 = (EAC*EAC) + (EBC*EBC) + (ECC*ECC);
            const double w56 = (1.0/(w55 + 1.0));
            deviation[0 * stride + i] = w56*(EAC*w54 - EBC*w52 + ECC*w50 - w1*w55 + w47);
            deviation[1 * stride + i] = w56*(EAC*w52 + EBC*w54 - ECC*w53 - w48*w55 + w49);
            deviation[2 * stride + i] = w56*(-EAC*w50 + EBC*w53 + ECC*w54 - w2*w55 + w51);
        }
    }
}

/*
 * Deviation of a direction of the tool frame in the workpiece frame, to first order.
 * Source: Eqs. (1)-(4), rotations alone. Operations: 117 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in direction: 3 rows of stride, 1; unit vector in the tool frame, (0, 0, 1) for the tool axis (tx ty tz)
 * out deviation: 3 rows of stride, 1; the vector in the workpiece frame, actual minus ideal (dx dy dz)
 */
void dmu60p_5axis_tool_orientation_deviation_first_order(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT direction,
    double *TRUEAXIS_RESTRICT deviation)
{
    /* once per call */
    const double EA0C = parameters[17];
    const double EB0C = parameters[18];
    const double eps_xy = parameters[19];
    const double eps_yz = parameters[20];
    const double eps_xz = parameters[21];
    const double EA0B = parameters[24];
    const double EC0B = parameters[25];
    for (size_t start = 0; start < n; start += BLOCK) {
        const size_t count = n - start < BLOCK ? n - start : (size_t)BLOCK;
        /* cosines and sines */
        double cos_b_block[BLOCK];
        double sin_b_block[BLOCK];
        double cos_c_block[BLOCK];
        double sin_c_block[BLOCK];
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double b = positions[3 * stride + i];
            const double c = positions[4 * stride + i];
            cos_b_block[j] = cos(0.017453292519943295*b);
            sin_b_block[j] = sin(0.017453292519943295*b);
            cos_c_block[j] = cos(0.017453292519943295*c);
            sin_c_block[j] = sin(0.017453292519943295*c);
        }
        /* per point */
        POINTS_ARE_INDEPENDENT
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double cos_b = cos_b_block[j];
            const double sin_b = sin_b_block[j];
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
            const double EAB = errors[21 * stride + i];
            const double EBB = errors[22 * stride + i];
            const double ECB = errors[23 * stride + i];
            const double EAC = errors[27 * stride + i];
            const double EBC = errors[28 * stride + i];
            const double ECC = errors[29 * stride + i];
            const double tx = direction[0 * stride + i];
            const double ty = direction[1 * stride + i];
            const double tz = direction[2 * stride + i];
            const double w0 = cos_b*tz - sin_b*tx;
            const double w1 = cos_b*tx + sin_b*tz;
            const double w2 = cos_c*ty - sin_c*w1;
            const double w3 = EBB*tz - ECB*ty;
            const double w4 = EAB*ty - EBB*tx;
            const double w5 = cos_b*w3 + sin_b*w4;
            const double w6 = -EC0B*ty + w5;
            const double w7 = EBZ*w0 - ECZ*ty + w6;
            const double w8 = eps_xz*w0 + w7;
            const double w9 = EBX*w0 - ECX*ty + w8;
            const double w10 = -eps_xy*ty + w9;
            const double w11 = -EBY*w0 + ECY*ty + w10;
            const double w12 = -EB0C*w0 + w11;
            const double w13 = -EAB*tz + ECB*tx;
            const double w14 = -EA0B*w0 + EC0B*w1 + w13;
            const double w15 = -EAZ*w0 + ECZ*w1 + w14;
            const double w16 = -eps_yz*w0 + w15;
            const double w17 = -EAX*w0 + ECX*w1 + w16;
            const double w18 = eps_xy*w1 + w17;
            const double w19 = EAY*w0 - ECY*w1 + w18;
            const double w20 = EA0C*w0 + w19;
            const double w21 = cos_c*w12 + sin_c*w20;
            const double w22 = cos_c*w1 + sin_c*ty;
            const double w23 = cos_c*w20 - sin_c*w12;
            const double w24 = cos_b*w4 - sin_b*w3;
            const double w25 = EA0B*ty + w24;
            const double w26 = EAZ*ty - EBZ*w1 + w25;
            const double w27 = -eps_xz*w1 + eps_yz*ty + w26;
            const double w28 = EAX*ty - EBX*w1 + w27;
            const double w29 = -EAY*ty + EBY*w1 + w28;
            const double w30 = -EA0C*ty + EB0C*w1 + w29;
            deviation[0 * stride + i] = -EBC*w0 + ECC*w2 + w21;
            deviation[1 * stride + i] = EAC*w0 - ECC*w22 + w23;
            deviation[2 * stride + i] = -EAC*w2 + EBC*w22 + w30;
        }
    }
}

/*
 * Deviation of the tool point under polynomial error curves, exact.
 * Source: Eqs. (1)-(4), (44). Operations: 627 per point, 12 once per call.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in curves: 210 values, mm/mm^k, rad/mm^k (deg^k for rotary axes); coefficients of the powers 1 to 7 of the axis
 *     position, per component error (EXX_1 EXX_2 .. ECC_7, last index fastest)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in point: 3 values, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; tool point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void dmu60p_5axis_tool_in_workpiece_deviation_curves(
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
    const double EXB_1 = curves[126];
    const double EXB_2 = curves[127];
    const double EXB_3 = curves[128];
    const double EXB_4 = curves[129];
    const double EXB_5 = curves[130];
    const double EXB_6 = curves[131];
    const double EXB_7 = curves[132];
    const double EYB_1 = curves[133];
    const double EYB_2 = curves[134];
    const double EYB_3 = curves[135];
    const double EYB_4 = curves[136];
    const double EYB_5 = curves[137];
    const double EYB_6 = curves[138];
    const double EYB_7 = curves[139];
    const double EZB_1 = curves[140];
    const double EZB_2 = curves[141];
    const double EZB_3 = curves[142];
    const double EZB_4 = curves[143];
    const double EZB_5 = curves[144];
    const double EZB_6 = curves[145];
    const double EZB_7 = curves[146];
    const double EAB_1 = curves[147];
    const double EAB_2 = curves[148];
    const double EAB_3 = curves[149];
    const double EAB_4 = curves[150];
    const double EAB_5 = curves[151];
    const double EAB_6 = curves[152];
    const double EAB_7 = curves[153];
    const double EBB_1 = curves[154];
    const double EBB_2 = curves[155];
    const double EBB_3 = curves[156];
    const double EBB_4 = curves[157];
    const double EBB_5 = curves[158];
    const double EBB_6 = curves[159];
    const double EBB_7 = curves[160];
    const double ECB_1 = curves[161];
    const double ECB_2 = curves[162];
    const double ECB_3 = curves[163];
    const double ECB_4 = curves[164];
    const double ECB_5 = curves[165];
    const double ECB_6 = curves[166];
    const double ECB_7 = curves[167];
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
    const double rx = point[0];
    const double ry = point[1];
    const double rz = point[2];
    const double w3 = q_Tx + rx;
    const double w4 = q_Sx + w3;
    const double w5 = q_Tz + rz;
    const double w6 = q_Sz + w5;
    const double w11 = q_Ty + ry;
    const double w12 = q_Sy + w11;
    const double w13 = q_By + w12;
    const double w91 = (EA0C*EA0C) + (EB0C*EB0C);
    const double w92 = (1.0/(w91 + 1.0));
    for (size_t start = 0; start < n; start += BLOCK) {
        const size_t count = n - start < BLOCK ? n - start : (size_t)BLOCK;
        /* cosines and sines */
        double cos_b_block[BLOCK];
        double sin_b_block[BLOCK];
        double cos_c_block[BLOCK];
        double sin_c_block[BLOCK];
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double b = positions[3 * stride + i];
            const double c = positions[4 * stride + i];
            cos_b_block[j] = cos(0.017453292519943295*b);
            sin_b_block[j] = sin(0.017453292519943295*b);
            cos_c_block[j] = cos(0.017453292519943295*c);
            sin_c_block[j] = sin(0.017453292519943295*c);
        }
        /* per point */
        POINTS_ARE_INDEPENDENT
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double cos_b = cos_b_block[j];
            const double sin_b = sin_b_block[j];
            const double cos_c = cos_c_block[j];
            const double sin_c = sin_c_block[j];
            const double x = positions[0 * stride + i];
            const double y = positions[1 * stride + i];
            const double z = positions[2 * stride + i];
            const double b = positions[3 * stride + i];
            const double c = positions[4 * stride + i];
            const double w0 = c*(EAC_1 + c*(EAC_2 + c*(EAC_3 + c*(EAC_4 + c*(EAC_5 + c*(EAC_6 + EAC_7*c))))));
            const double w1 = c*(EBC_1 + c*(EBC_2 + c*(EBC_3 + c*(EBC_4 + c*(EBC_5 + c*(EBC_6 + EBC_7*c))))));
            const double w2 = c*(ECC_1 + c*(ECC_2 + c*(ECC_3 + c*(ECC_4 + c*(ECC_5 + c*(ECC_6 + ECC_7*c))))));
            const double w7 = cos_b*w4 + sin_b*w6;
            const double w8 = q_Bx + w7;
            const double w9 = w8 + x;
            const double w10 = -q_Cx + w9;
            const double w14 = w13 - y;
            const double w15 = -q_Cy + w14;
            const double w16 = cos_c*w10 + sin_c*w15;
            const double w17 = c*(EXC_1 + c*(EXC_2 + c*(EXC_3 + c*(EXC_4 + c*(EXC_5 + c*(EXC_6 + EXC_7*c))))));
            const double w18 = y*(EAY_1 + y*(EAY_2 + y*(EAY_3 + y*(EAY_4 + y*(EAY_5 + y*(EAY_6 + EAY_7*y))))));
            const double w19 = y*(EBY_1 + y*(EBY_2 + y*(EBY_3 + y*(EBY_4 + y*(EBY_5 + y*(EBY_6 + EBY_7*y))))));
            const double w20 = y*(ECY_1 + y*(ECY_2 + y*(ECY_3 + y*(ECY_4 + y*(ECY_5 + y*(ECY_6 + ECY_7*y))))));
            const double w21 = y*(EXY_1 + y*(EXY_2 + y*(EXY_3 + y*(EXY_4 + y*(EXY_5 + y*(EXY_6 + EXY_7*y))))));
            const double w22 = cos_b*w6 - sin_b*w4;
            const double w23 = q_Bz + w22;
            const double w24 = w23 + z;
            const double w25 = b*(EYB_1 + b*(EYB_2 + b*(EYB_3 + b*(EYB_4 + b*(EYB_5 + b*(EYB_6 + EYB_7*b))))));
            const double w26 = b*(EAB_1 + b*(EAB_2 + b*(EAB_3 + b*(EAB_4 + b*(EAB_5 + b*(EAB_6 + EAB_7*b))))));
            const double w27 = b*(ECB_1 + b*(ECB_2 + b*(ECB_3 + b*(ECB_4 + b*(ECB_5 + b*(ECB_6 + ECB_7*b))))));
            const double w28 = w25 - w26*w6 + w27*w4;
            const double w29 = w12 + w28;
            const double w30 = b*(EXB_1 + b*(EXB_2 + b*(EXB_3 + b*(EXB_4 + b*(EXB_5 + b*(EXB_6 + EXB_7*b))))));
            const double w31 = b*(EBB_1 + b*(EBB_2 + b*(EBB_3 + b*(EBB_4 + b*(EBB_5 + b*(EBB_6 + EBB_7*b))))));
            const double w32 = -w12*w27 + w30 + w31*w6;
            const double w33 = b*(EZB_1 + b*(EZB_2 + b*(EZB_3 + b*(EZB_4 + b*(EZB_5 + b*(EZB_6 + EZB_7*b))))));
            const double w34 = w12*w26 - w31*w4 + w33;
            const double w35 = cos_b*w34 - sin_b*w32;
            const double w36 = EA0B*w29 + EZ0B + w35;
            const double w37 = w23 + w36;
            const double w38 = cos_b*w32 + sin_b*w34;
            const double w39 = -EA0B*(w22 + w35) + EC0B*(w38 + w7) + w28;
            const double w40 = w13 + w39;
            const double w41 = z*(EXZ_1 + z*(EXZ_2 + z*(EXZ_3 + z*(EXZ_4 + z*(EXZ_5 + z*(EXZ_6 + EXZ_7*z))))));
            const double w42 = z*(EBZ_1 + z*(EBZ_2 + z*(EBZ_3 + z*(EBZ_4 + z*(EBZ_5 + z*(EBZ_6 + EBZ_7*z))))));
            const double w43 = z*(ECZ_1 + z*(ECZ_2 + z*(ECZ_3 + z*(ECZ_4 + z*(ECZ_5 + z*(ECZ_6 + ECZ_7*z))))));
            const double w44 = -EC0B*w29 + EX0B + w38;
            const double w45 = w37*w42 - w40*w43 + w41 + w44;
            const double w46 = w44 + w8;
            const double w47 = z*(EYZ_1 + z*(EYZ_2 + z*(EYZ_3 + z*(EYZ_4 + z*(EYZ_5 + z*(EYZ_6 + EYZ_7*z))))));
            const double w48 = z*(EAZ_1 + z*(EAZ_2 + z*(EAZ_3 + z*(EAZ_4 + z*(EAZ_5 + z*(EAZ_6 + EAZ_7*z))))));
            const double w49 = -w37*w48 + w39 + w43*w46 + w47;
            const double w50 = z*(EZZ_1 + z*(EZZ_2 + z*(EZZ_3 + z*(EZZ_4 + z*(EZZ_5 + z*(EZZ_6 + EZZ_7*z))))));
            const double w51 = w36 + w40*w48 - w42*w46 + w50;
            const double w52 = -eps_xz*(w45 + w8) + eps_yz*(w13 + w49) + w51;
            const double w53 = w24 + w52;
            const double w54 = w24 + w51;
            const double w55 = -eps_yz*w54 + w49;
            const double w56 = w13 + w55;
            const double w57 = x*(EXX_1 + x*(EXX_2 + x*(EXX_3 + x*(EXX_4 + x*(EXX_5 + x*(EXX_6 + EXX_7*x))))));
            const double w58 = x*(EBX_1 + x*(EBX_2 + x*(EBX_3 + x*(EBX_4 + x*(EBX_5 + x*(EBX_6 + EBX_7*x))))));
            const double w59 = x*(ECX_1 + x*(ECX_2 + x*(ECX_3 + x*(ECX_4 + x*(ECX_5 + x*(ECX_6 + ECX_7*x))))));
            const double w60 = eps_xz*w54 + w45;
            const double w61 = w53*w58 - w56*w59 + w57 + w60;
            const double w62 = w60 + w8;
            const double w63 = x*(EYX_1 + x*(EYX_2 + x*(EYX_3 + x*(EYX_4 + x*(EYX_5 + x*(EYX_6 + EYX_7*x))))));
            const double w64 = x*(EAX_1 + x*(EAX_2 + x*(EAX_3 + x*(EAX_4 + x*(EAX_5 + x*(EAX_6 + EAX_7*x))))));
            const double w65 = -w53*w64 + w55 + w59*w62 + w63;
            const double w66 = -eps_xy*(w13 + w65) + w61;
            const double w67 = -w21 + w66;
            const double w68 = y*(EYY_1 + y*(EYY_2 + y*(EYY_3 + y*(EYY_4 + y*(EYY_5 + y*(EYY_6 + EYY_7*y))))));
            const double w69 = eps_xy*(w61 + w9) + w65;
            const double w70 = -w68 + w69;
            const double w71 = w14 + w70;
            const double w72 = y*(EZY_1 + y*(EZY_2 + y*(EZY_3 + y*(EZY_4 + y*(EZY_5 + y*(EZY_6 + EZY_7*y))))));
            const double w73 = x*(EZX_1 + x*(EZX_2 + x*(EZX_3 + x*(EZX_4 + x*(EZX_5 + x*(EZX_6 + EZX_7*x))))));
            const double w74 = w52 + w56*w64 - w58*w62 + w73;
            const double w75 = -w72 + w74;
            const double w76 = w24 + w75;
            const double w77 = w67 + w9;
            const double w78 = w18*w77 + w19*w71 + w20*w76;
            const double w79 = (w18*w18) + (w19*w19) + (w20*w20);
            const double w80 = (1.0/(w79 + 1.0));
            const double w81 = w80*(w18*w78 - w19*w76 + w20*w71 + w67 - w79*w9);
            const double w82 = -EX0C + w81;
            const double w83 = w80*(-w18*w71 + w19*w77 + w20*w78 - w24*w79 + w75);
            const double w84 = -q_Cz + w24;
            const double w85 = w83 + w84;
            const double w86 = w10 + w82;
            const double w87 = w80*(-w14*w79 + w18*w76 + w19*w78 - w20*w77 + w70);
            const double w88 = -EY0C + w87;
            const double w89 = w15 + w88;
            const double w90 = EA0C*w86 + EB0C*w89;
            const double w93 = w92*(EA0C*w90 - EB0C*w85 - w10*w91 + w82);
            const double w94 = w92*(EA0C*w85 + EB0C*w90 - w15*w91 + w88);
            const double w95 = cos_c*w93 + sin_c*w94;
            const double w96 = -w17 + w95;
            const double w97 = cos_c*w15 - sin_c*w10;
            const double w98 = c*(EYC_1 + c*(EYC_2 + c*(EYC_3 + c*(EYC_4 + c*(EYC_5 + c*(EYC_6 + EYC_7*c))))));
            const double w99 = cos_c*w94 - sin_c*w93;
            const double w100 = -w98 + w99;
            const double w101 = w100 + w97;
            const double w102 = c*(EZC_1 + c*(EZC_2 + c*(EZC_3 + c*(EZC_4 + c*(EZC_5 + c*(EZC_6 + EZC_7*c))))));
            const double w103 = w92*(-EA0C*w89 + EB0C*w86 + w83 - w84*w91);
            const double w104 = -w102 + w103;
            const double w105 = w104 + w84;
            const double w106 = w16 + w96;
            const double w107 = w0*w106 + w1*w101 + w105*w2;
            const double w108 = (w0*w0) + (w1*w1) + (w2*w2);
            const double w109 = (1.0/(w108 + 1.0));
            deviation[0 * stride + i] = w109*(w0*w107 - w1*w105 + w101*w2 - w108*w16 + w96);
            deviation[1 * stride + i] = w109*(w0*w105 + w1*w107 + w100 - w106*w2 - w108*w97);
            deviation[2 * stride + i] = w109*(-w0*w101 + w1*w106 + w104 + w107*w2 - w108*w84);
        }
    }
}

/*
 * Deviation of the tool point under polynomial error curves, to first order.
 * Source: Eqs. (1)-(4), (44). Operations: 534 per point, 7 once per call.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in curves: 210 values, mm/mm^k, rad/mm^k (deg^k for rotary axes); coefficients of the powers 1 to 7 of the axis
 *     position, per component error (EXX_1 EXX_2 .. ECC_7, last index fastest)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in point: 3 values, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; tool point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void dmu60p_5axis_tool_in_workpiece_deviation_first_order_curves(
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
    const double EXB_1 = curves[126];
    const double EXB_2 = curves[127];
    const double EXB_3 = curves[128];
    const double EXB_4 = curves[129];
    const double EXB_5 = curves[130];
    const double EXB_6 = curves[131];
    const double EXB_7 = curves[132];
    const double EYB_1 = curves[133];
    const double EYB_2 = curves[134];
    const double EYB_3 = curves[135];
    const double EYB_4 = curves[136];
    const double EYB_5 = curves[137];
    const double EYB_6 = curves[138];
    const double EYB_7 = curves[139];
    const double EZB_1 = curves[140];
    const double EZB_2 = curves[141];
    const double EZB_3 = curves[142];
    const double EZB_4 = curves[143];
    const double EZB_5 = curves[144];
    const double EZB_6 = curves[145];
    const double EZB_7 = curves[146];
    const double EAB_1 = curves[147];
    const double EAB_2 = curves[148];
    const double EAB_3 = curves[149];
    const double EAB_4 = curves[150];
    const double EAB_5 = curves[151];
    const double EAB_6 = curves[152];
    const double EAB_7 = curves[153];
    const double EBB_1 = curves[154];
    const double EBB_2 = curves[155];
    const double EBB_3 = curves[156];
    const double EBB_4 = curves[157];
    const double EBB_5 = curves[158];
    const double EBB_6 = curves[159];
    const double EBB_7 = curves[160];
    const double ECB_1 = curves[161];
    const double ECB_2 = curves[162];
    const double ECB_3 = curves[163];
    const double ECB_4 = curves[164];
    const double ECB_5 = curves[165];
    const double ECB_6 = curves[166];
    const double ECB_7 = curves[167];
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
    const double rx = point[0];
    const double ry = point[1];
    const double rz = point[2];
    const double w3 = q_Tx + rx;
    const double w4 = q_Sx + w3;
    const double w5 = q_Tz + rz;
    const double w6 = q_Sz + w5;
    const double w15 = q_Ty + ry;
    const double w16 = q_Sy + w15;
    const double w17 = q_By + w16;
    for (size_t start = 0; start < n; start += BLOCK) {
        const size_t count = n - start < BLOCK ? n - start : (size_t)BLOCK;
        /* cosines and sines */
        double cos_b_block[BLOCK];
        double sin_b_block[BLOCK];
        double cos_c_block[BLOCK];
        double sin_c_block[BLOCK];
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double b = positions[3 * stride + i];
            const double c = positions[4 * stride + i];
            cos_b_block[j] = cos(0.017453292519943295*b);
            sin_b_block[j] = sin(0.017453292519943295*b);
            cos_c_block[j] = cos(0.017453292519943295*c);
            sin_c_block[j] = sin(0.017453292519943295*c);
        }
        /* per point */
        POINTS_ARE_INDEPENDENT
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double cos_b = cos_b_block[j];
            const double sin_b = sin_b_block[j];
            const double cos_c = cos_c_block[j];
            const double sin_c = sin_c_block[j];
            const double x = positions[0 * stride + i];
            const double y = positions[1 * stride + i];
            const double z = positions[2 * stride + i];
            const double b = positions[3 * stride + i];
            const double c = positions[4 * stride + i];
            const double w0 = c*(EXC_1 + c*(EXC_2 + c*(EXC_3 + c*(EXC_4 + c*(EXC_5 + c*(EXC_6 + EXC_7*c))))));
            const double w1 = c*(EBC_1 + c*(EBC_2 + c*(EBC_3 + c*(EBC_4 + c*(EBC_5 + c*(EBC_6 + EBC_7*c))))));
            const double w2 = c*(ECC_1 + c*(ECC_2 + c*(ECC_3 + c*(ECC_4 + c*(ECC_5 + c*(ECC_6 + ECC_7*c))))));
            const double w7 = cos_b*w6 - sin_b*w4;
            const double w8 = q_Bz + w7;
            const double w9 = w8 + z;
            const double w10 = -q_Cz + w9;
            const double w11 = cos_b*w4 + sin_b*w6;
            const double w12 = q_Bx + w11;
            const double w13 = w12 + x;
            const double w14 = -q_Cx + w13;
            const double w18 = w17 - y;
            const double w19 = -q_Cy + w18;
            const double w20 = cos_c*w19 - sin_c*w14;
            const double w21 = y*(EXY_1 + y*(EXY_2 + y*(EXY_3 + y*(EXY_4 + y*(EXY_5 + y*(EXY_6 + EXY_7*y))))));
            const double w22 = y*(EBY_1 + y*(EBY_2 + y*(EBY_3 + y*(EBY_4 + y*(EBY_5 + y*(EBY_6 + EBY_7*y))))));
            const double w23 = y*(ECY_1 + y*(ECY_2 + y*(ECY_3 + y*(ECY_4 + y*(ECY_5 + y*(ECY_6 + ECY_7*y))))));
            const double w24 = x*(EXX_1 + x*(EXX_2 + x*(EXX_3 + x*(EXX_4 + x*(EXX_5 + x*(EXX_6 + EXX_7*x))))));
            const double w25 = x*(EBX_1 + x*(EBX_2 + x*(EBX_3 + x*(EBX_4 + x*(EBX_5 + x*(EBX_6 + EBX_7*x))))));
            const double w26 = x*(ECX_1 + x*(ECX_2 + x*(ECX_3 + x*(ECX_4 + x*(ECX_5 + x*(ECX_6 + ECX_7*x))))));
            const double w27 = z*(EXZ_1 + z*(EXZ_2 + z*(EXZ_3 + z*(EXZ_4 + z*(EXZ_5 + z*(EXZ_6 + EXZ_7*z))))));
            const double w28 = z*(EBZ_1 + z*(EBZ_2 + z*(EBZ_3 + z*(EBZ_4 + z*(EBZ_5 + z*(EBZ_6 + EBZ_7*z))))));
            const double w29 = z*(ECZ_1 + z*(ECZ_2 + z*(ECZ_3 + z*(ECZ_4 + z*(ECZ_5 + z*(ECZ_6 + ECZ_7*z))))));
            const double w30 = b*(EXB_1 + b*(EXB_2 + b*(EXB_3 + b*(EXB_4 + b*(EXB_5 + b*(EXB_6 + EXB_7*b))))));
            const double w31 = b*(EBB_1 + b*(EBB_2 + b*(EBB_3 + b*(EBB_4 + b*(EBB_5 + b*(EBB_6 + EBB_7*b))))));
            const double w32 = b*(ECB_1 + b*(ECB_2 + b*(ECB_3 + b*(ECB_4 + b*(ECB_5 + b*(ECB_6 + ECB_7*b))))));
            const double w33 = -w16*w32 + w30 + w31*w6;
            const double w34 = b*(EZB_1 + b*(EZB_2 + b*(EZB_3 + b*(EZB_4 + b*(EZB_5 + b*(EZB_6 + EZB_7*b))))));
            const double w35 = b*(EAB_1 + b*(EAB_2 + b*(EAB_3 + b*(EAB_4 + b*(EAB_5 + b*(EAB_6 + EAB_7*b))))));
            const double w36 = w16*w35 - w31*w4 + w34;
            const double w37 = cos_b*w33 + sin_b*w36;
            const double w38 = -EC0B*w16 + EX0B + w37;
            const double w39 = -w17*w29 + w27 + w28*w8 + w38;
            const double w40 = eps_xz*w9 + w39;
            const double w41 = -w17*w26 + w24 + w25*w9 + w40;
            const double w42 = -eps_xy*w17 + w41;
            const double w43 = w18*w23 - w21 - w22*w9 + w42;
            const double w44 = -EB0C*w10 - EX0C + w43;
            const double w45 = y*(EYY_1 + y*(EYY_2 + y*(EYY_3 + y*(EYY_4 + y*(EYY_5 + y*(EYY_6 + EYY_7*y))))));
            const double w46 = y*(EAY_1 + y*(EAY_2 + y*(EAY_3 + y*(EAY_4 + y*(EAY_5 + y*(EAY_6 + EAY_7*y))))));
            const double w47 = x*(EYX_1 + x*(EYX_2 + x*(EYX_3 + x*(EYX_4 + x*(EYX_5 + x*(EYX_6 + EYX_7*x))))));
            const double w48 = x*(EAX_1 + x*(EAX_2 + x*(EAX_3 + x*(EAX_4 + x*(EAX_5 + x*(EAX_6 + EAX_7*x))))));
            const double w49 = z*(EYZ_1 + z*(EYZ_2 + z*(EYZ_3 + z*(EYZ_4 + z*(EYZ_5 + z*(EYZ_6 + EYZ_7*z))))));
            const double w50 = z*(EAZ_1 + z*(EAZ_2 + z*(EAZ_3 + z*(EAZ_4 + z*(EAZ_5 + z*(EAZ_6 + EAZ_7*z))))));
            const double w51 = b*(EYB_1 + b*(EYB_2 + b*(EYB_3 + b*(EYB_4 + b*(EYB_5 + b*(EYB_6 + EYB_7*b))))));
            const double w52 = w32*w4 - w35*w6 + w51;
            const double w53 = -EA0B*w7 + EC0B*w11 + w52;
            const double w54 = w12*w29 + w49 - w50*w8 + w53;
            const double w55 = -eps_yz*w9 + w54;
            const double w56 = w12*w26 + w47 - w48*w9 + w55;
            const double w57 = eps_xy*w13 + w56;
            const double w58 = -w13*w23 - w45 + w46*w9 + w57;
            const double w59 = EA0C*w10 - EY0C + w58;
            const double w60 = cos_c*w44 + sin_c*w59;
            const double w61 = c*(EYC_1 + c*(EYC_2 + c*(EYC_3 + c*(EYC_4 + c*(EYC_5 + c*(EYC_6 + EYC_7*c))))));
            const double w62 = c*(EAC_1 + c*(EAC_2 + c*(EAC_3 + c*(EAC_4 + c*(EAC_5 + c*(EAC_6 + EAC_7*c))))));
            const double w63 = cos_c*w14 + sin_c*w19;
            const double w64 = cos_c*w59 - sin_c*w44;
            const double w65 = c*(EZC_1 + c*(EZC_2 + c*(EZC_3 + c*(EZC_4 + c*(EZC_5 + c*(EZC_6 + EZC_7*c))))));
            const double w66 = y*(EZY_1 + y*(EZY_2 + y*(EZY_3 + y*(EZY_4 + y*(EZY_5 + y*(EZY_6 + EZY_7*y))))));
            const double w67 = x*(EZX_1 + x*(EZX_2 + x*(EZX_3 + x*(EZX_4 + x*(EZX_5 + x*(EZX_6 + EZX_7*x))))));
            const double w68 = z*(EZZ_1 + z*(EZZ_2 + z*(EZZ_3 + z*(EZZ_4 + z*(EZZ_5 + z*(EZZ_6 + EZZ_7*z))))));
            const double w69 = cos_b*w36 - sin_b*w33;
            const double w70 = EA0B*w16 + EZ0B + w69;
            const double w71 = -w12*w28 + w17*w50 + w68 + w70;
            const double w72 = -eps_xz*w12 + eps_yz*w17 + w71;
            const double w73 = -w12*w25 + w17*w48 + w67 + w72;
            const double w74 = w13*w22 - w18*w46 - w66 + w73;
            const double w75 = -EA0C*w19 + EB0C*w14 + w74;
            deviation[0 * stride + i] = -w0 - w1*w10 + w2*w20 + w60;
            deviation[1 * stride + i] = w10*w62 - w2*w63 - w61 + w64;
            deviation[2 * stride + i] = w1*w63 - w20*w62 - w65 + w75;
        }
    }
}

/*
 * Positioning error of a ball bar between a tool ball and a workpiece ball, exact.
 * Source: Eqs. (5), (6). Operations: 283 per point, 5 once per call.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * in ball: 3 rows of stride, mm; point in the workpiece frame (bx by bz)
 * in length: 1 rows of stride, mm; ideal length of the ball bar (length)
 * out error: 4 rows of stride, mm; positioning error E, then its components E_x, E_y, E_z (e ex ey ez)
 */
void dmu60p_5axis_ballbar_error(
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
    const double q_Cx = parameters[0];
    const double q_Cy = parameters[1];
    const double q_Cz = parameters[2];
    const double q_wx = parameters[3];
    const double q_wy = parameters[4];
    const double q_wz = parameters[5];
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
    for (size_t start = 0; start < n; start += BLOCK) {
        const size_t count = n - start < BLOCK ? n - start : (size_t)BLOCK;
        /* cosines and sines */
        double cos_b_block[BLOCK];
        double sin_b_block[BLOCK];
        double cos_c_block[BLOCK];
        double sin_c_block[BLOCK];
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double b = positions[3 * stride + i];
            const double c = positions[4 * stride + i];
            cos_b_block[j] = cos(0.017453292519943295*b);
            sin_b_block[j] = sin(0.017453292519943295*b);
            cos_c_block[j] = cos(0.017453292519943295*c);
            sin_c_block[j] = sin(0.017453292519943295*c);
        }
        /* per point */
        POINTS_ARE_INDEPENDENT
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double cos_b = cos_b_block[j];
            const double sin_b = sin_b_block[j];
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
            const double EXB = errors[18 * stride + i];
            const double EYB = errors[19 * stride + i];
            const double EZB = errors[20 * stride + i];
            const double EAB = errors[21 * stride + i];
            const double EBB = errors[22 * stride + i];
            const double ECB = errors[23 * stride + i];
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
            const double w80 = w79*(EAC*w77 - EBC*w75 + ECC*w72 - w13*w78 + w68);
            const double w81 = w79*(EAC*w75 + EBC*w77 - ECC*w76 - w69*w78 + w71);
            const double w82 = w79*(-EAC*w72 + EBC*w76 + ECC*w77 - w56*w78 + w74);
            const double w83 = -q_wx + w13;
            const double w84 = -bx + w83;
            const double w85 = -q_wy + w69;
            const double w86 = -by + w85;
            const double w87 = -q_wz + w56;
            const double w88 = -bz + w87;
            const double w89 = w80 + w84;
            const double w90 = w81 + w86;
            const double w91 = w82 + w88;
            const double w92 = sqrt((w84*w84) + (w86*w86) + (w88*w88));
            const double w93 = sqrt((w89*w89) + (w90*w90) + (w91*w91));
            const double e = -length_ + w92 + (w80*(w84 + w89) + w81*(w86 + w90) + w82*(w88 + w91))/(w92 + w93);
            const double w94 = e/w93;
            error[0 * stride + i] = e;
            error[1 * stride + i] = w89*w94;
            error[2 * stride + i] = w90*w94;
            error[3 * stride + i] = w91*w94;
        }
    }
}

/*
 * Moves of the linear axes that displace the ideal tool point by the given vector.
 * Source: Eqs. (53)-(55), inverse. Operations: 11 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in deviation: 3 rows of stride, mm; displacement of the tool point in the workpiece frame (dx dy dz)
 * out moves: 3 rows of stride, mm; moves of X Y Z (move_x move_y move_z)
 */
void dmu60p_5axis_correction(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT deviation,
    double *TRUEAXIS_RESTRICT moves)
{
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
            const double dx = deviation[0 * stride + i];
            const double dy = deviation[1 * stride + i];
            const double dz = deviation[2 * stride + i];
            moves[0 * stride + i] = cos_c*dx - dy*sin_c;
            moves[1 * stride + i] = -cos_c*dy - dx*sin_c;
            moves[2 * stride + i] = dz;
        }
    }
}

/*
 * Motion equation of X: displacement of the tool point since home, to first order.
 * Source: Eqs. (7)-(11). Operations: 24 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in tool_point: 3 rows of stride, mm; point in the tool frame (rTx rTy rTz)
 * out displacement: 3 rows of stride, mm; tool point, displacement since home, in the bed frame (dx dy dz)
 */
void dmu60p_5axis_motion_X(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT tool_point,
    double *TRUEAXIS_RESTRICT displacement)
{
    /* once per call */
    const double q_Bx = parameters[6];
    const double q_By = parameters[7];
    const double q_Bz = parameters[8];
    const double q_Sx = parameters[9];
    const double q_Sy = parameters[10];
    const double q_Sz = parameters[11];
    const double q_Tx = parameters[12];
    const double q_Ty = parameters[13];
    const double q_Tz = parameters[14];
    const double eps_xy = parameters[19];
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
        const double w0 = q_Bz + q_Sz + q_Tz + rTz;
        const double w1 = q_By + q_Sy + q_Ty + rTy;
        const double w2 = q_Bx + q_Sx + q_Tx + rTx;
        displacement[0 * stride + i] = EBX*w0 - ECX*w1 + EXX + x;
        displacement[1 * stride + i] = -EAX*w0 + ECX*w2 + EYX + eps_xy*x;
        displacement[2 * stride + i] = EAX*w1 - EBX*w2 + EZX;
    }
}

/*
 * Motion equation of Y: displacement of the workpiece point since home, to first order.
 * Source: Eqs. (7)-(11). Operations: 19 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in workpiece_point: 3 rows of stride, mm; point in the workpiece frame (rWx rWy rWz)
 * out displacement: 3 rows of stride, mm; workpiece point, displacement since home, in the bed frame (dx dy dz)
 */
void dmu60p_5axis_motion_Y(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT workpiece_point,
    double *TRUEAXIS_RESTRICT displacement)
{
    /* once per call */
    const double q_Cx = parameters[0];
    const double q_Cy = parameters[1];
    const double q_Cz = parameters[2];
    const double q_wx = parameters[3];
    const double q_wy = parameters[4];
    const double q_wz = parameters[5];
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
        const double w0 = q_Cz + q_wz + rWz;
        const double w1 = q_Cy + q_wy + rWy;
        const double w2 = q_Cx + q_wx + rWx;
        displacement[0 * stride + i] = EBY*w0 - ECY*w1 + EXY;
        displacement[1 * stride + i] = -EAY*w0 + ECY*w2 + EYY + y;
        displacement[2 * stride + i] = EAY*w1 - EBY*w2 + EZY;
    }
}

/*
 * Motion equation of Z: displacement of the tool point since home, to first order.
 * Source: Eqs. (7)-(11). Operations: 26 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in tool_point: 3 rows of stride, mm; point in the tool frame (rTx rTy rTz)
 * out displacement: 3 rows of stride, mm; tool point, displacement since home, in the bed frame (dx dy dz)
 */
void dmu60p_5axis_motion_Z(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT tool_point,
    double *TRUEAXIS_RESTRICT displacement)
{
    /* once per call */
    const double q_Bx = parameters[6];
    const double q_By = parameters[7];
    const double q_Bz = parameters[8];
    const double q_Sx = parameters[9];
    const double q_Sy = parameters[10];
    const double q_Sz = parameters[11];
    const double q_Tx = parameters[12];
    const double q_Ty = parameters[13];
    const double q_Tz = parameters[14];
    const double eps_yz = parameters[20];
    const double eps_xz = parameters[21];
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
        const double w0 = q_Bz + q_Sz + q_Tz + rTz;
        const double w1 = q_By + q_Sy + q_Ty + rTy;
        const double w2 = q_Bx + q_Sx + q_Tx + rTx;
        displacement[0 * stride + i] = EBZ*w0 - ECZ*w1 + EXZ + eps_xz*z;
        displacement[1 * stride + i] = -EAZ*w0 + ECZ*w2 + EYZ - eps_yz*z;
        displacement[2 * stride + i] = EAZ*w1 - EBZ*w2 + EZZ + z;
    }
}

/*
 * Motion equation of B: displacement of the tool point since home, to first order.
 * Source: Eqs. (7)-(11). Operations: 91 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in tool_point: 3 rows of stride, mm; point in the tool frame (rTx rTy rTz)
 * out displacement: 3 rows of stride, mm; tool point, displacement since home, in the bed frame (dx dy dz)
 */
void dmu60p_5axis_motion_B(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT tool_point,
    double *TRUEAXIS_RESTRICT displacement)
{
    /* once per call */
    const double q_Sx = parameters[9];
    const double q_Sy = parameters[10];
    const double q_Sz = parameters[11];
    const double q_Tx = parameters[12];
    const double q_Ty = parameters[13];
    const double q_Tz = parameters[14];
    const double eps_xy = parameters[19];
    const double eps_yz = parameters[20];
    const double eps_xz = parameters[21];
    const double EA0B = parameters[24];
    const double EC0B = parameters[25];
    for (size_t start = 0; start < n; start += BLOCK) {
        const size_t count = n - start < BLOCK ? n - start : (size_t)BLOCK;
        /* cosines and sines */
        double cos_b_block[BLOCK];
        double sin_b_block[BLOCK];
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double b = positions[3 * stride + i];
            cos_b_block[j] = cos(0.017453292519943295*b);
            sin_b_block[j] = sin(0.017453292519943295*b);
        }
        /* per point */
        POINTS_ARE_INDEPENDENT
        for (size_t j = 0; j < count; ++j) {
            const size_t i = start + j;
            const double cos_b = cos_b_block[j];
            const double sin_b = sin_b_block[j];
            const double EXB = errors[18 * stride + i];
            const double EYB = errors[19 * stride + i];
            const double EZB = errors[20 * stride + i];
            const double EAB = errors[21 * stride + i];
            const double EBB = errors[22 * stride + i];
            const double ECB = errors[23 * stride + i];
            const double rTx = tool_point[0 * stride + i];
            const double rTy = tool_point[1 * stride + i];
            const double rTz = tool_point[2 * stride + i];
            const double w0 = q_Sy*sin_b + q_Ty*sin_b + rTy*sin_b;
            const double w1 = q_Sx*sin_b;
            const double w2 = q_Tx*sin_b;
            const double w3 = rTx*sin_b;
            const double w4 = cos_b*q_Sz + cos_b*q_Tz + cos_b*rTz - w1 - w2 - w3;
            const double w5 = cos_b*q_Sy + cos_b*q_Ty + cos_b*rTy;
            const double w6 = q_Sz + q_Tz + rTz;
            const double w7 = -cos_b*q_Sz - cos_b*q_Tz - cos_b*rTz + w1 + w2 + w3 + w6;
            const double w8 = cos_b*q_Sx + cos_b*q_Tx + cos_b*rTx + q_Sz*sin_b + q_Tz*sin_b + rTz*sin_b;
            const double w9 = -q_Sx - q_Tx - rTx + w8;
            displacement[0 * stride + i] = EAB*w0 + EBB*w4 - ECB*w5 + EXB*cos_b + EZB*sin_b - eps_xz*w7 + w9;
            displacement[1 * stride + i] = EA0B*w7 - EAB*w6 + EC0B*w9 + ECB*(q_Sx + q_Tx + rTx) + EYB + eps_xy*w9 +
                eps_yz*w7;
            displacement[2 * stride + i] = EAB*w5 - EBB*w8 + ECB*w0 - EXB*sin_b + EZB*cos_b - eps_xz*w9 - q_Sz - q_Tz -
                rTz + w4;
        }
    }
}

/*
 * Motion equation of C: displacement of the workpiece point since home, to first order.
 * Source: Eqs. (7)-(11). Operations: 62 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in workpiece_point: 3 rows of stride, mm; point in the workpiece frame (rWx rWy rWz)
 * out displacement: 3 rows of stride, mm; workpiece point, displacement since home, in the bed frame (dx dy dz)
 */
void dmu60p_5axis_motion_C(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT workpiece_point,
    double *TRUEAXIS_RESTRICT displacement)
{
    /* once per call */
    const double q_wx = parameters[3];
    const double q_wy = parameters[4];
    const double q_wz = parameters[5];
    const double EA0C = parameters[17];
    const double EB0C = parameters[18];
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
            const double w3 = cos_c*q_wx;
            const double w4 = cos_c*rWx;
            const double w5 = q_wy*sin_c;
            const double w6 = rWy*sin_c;
            const double w7 = w3 + w4 - w5 - w6;
            const double w8 = -q_wy - rWy + w2;
            const double w9 = q_wx + rWx;
            displacement[0 * stride + i] = EAC*w0 + EBC*w1 - ECC*w2 + EXC*cos_c - EYC*sin_c - q_wx - rWx + w7;
            displacement[1 * stride + i] = -EAC*w1 + EBC*w0 + ECC*w7 + EXC*sin_c + EYC*cos_c + w8;
            displacement[2 * stride + i] = EA0C*w8 + EAC*(q_wy + rWy) + EB0C*(-w3 - w4 + w5 + w6 + w9) - EBC*w9 + EZC;
        }
    }
}

/*
 * Motion equation of X and Y: displacement of the workpiece point minus tool point since home, to first order.
 * Source: Eqs. (7)-(11). Operations: 46 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in workpiece_point: 3 rows of stride, mm; point in the workpiece frame (rWx rWy rWz)
 * in tool_point: 3 rows of stride, mm; point in the tool frame (rTx rTy rTz)
 * out displacement: 3 rows of stride, mm; workpiece point minus tool point, displacement since home, in the bed frame
 *     (dx dy dz)
 */
void dmu60p_5axis_motion_XY(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT workpiece_point,
    const double *TRUEAXIS_RESTRICT tool_point,
    double *TRUEAXIS_RESTRICT displacement)
{
    /* once per call */
    const double q_Cx = parameters[0];
    const double q_Cy = parameters[1];
    const double q_Cz = parameters[2];
    const double q_wx = parameters[3];
    const double q_wy = parameters[4];
    const double q_wz = parameters[5];
    const double q_Bx = parameters[6];
    const double q_By = parameters[7];
    const double q_Bz = parameters[8];
    const double q_Sx = parameters[9];
    const double q_Sy = parameters[10];
    const double q_Sz = parameters[11];
    const double q_Tx = parameters[12];
    const double q_Ty = parameters[13];
    const double q_Tz = parameters[14];
    const double eps_xy = parameters[19];
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
        const double w0 = q_Cz + q_wz + rWz;
        const double w1 = q_By + q_Sy + q_Ty + rTy;
        const double w2 = q_Cy + q_wy + rWy;
        const double w3 = q_Bz + q_Sz + q_Tz + rTz;
        const double w4 = q_Cx + q_wx + rWx;
        const double w5 = q_Bx + q_Sx + q_Tx + rTx;
        displacement[0 * stride + i] = -EBX*w3 + EBY*w0 + ECX*w1 - ECY*w2 - EXX + EXY - x;
        displacement[1 * stride + i] = EAX*w3 - EAY*w0 - ECX*w5 + ECY*w4 - EYX + EYY - eps_xy*x + y;
        displacement[2 * stride + i] = -EAX*w1 + EAY*w2 + EBX*w5 - EBY*w4 - EZX + EZY;
    }
}

/*
 * Motion equation of X and Z: displacement of the tool point since home, to first order.
 * Source: Eqs. (7)-(11). Operations: 47 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in tool_point: 3 rows of stride, mm; point in the tool frame (rTx rTy rTz)
 * out displacement: 3 rows of stride, mm; tool point, displacement since home, in the bed frame (dx dy dz)
 */
void dmu60p_5axis_motion_XZ(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT tool_point,
    double *TRUEAXIS_RESTRICT displacement)
{
    /* once per call */
    const double q_Bx = parameters[6];
    const double q_By = parameters[7];
    const double q_Bz = parameters[8];
    const double q_Sx = parameters[9];
    const double q_Sy = parameters[10];
    const double q_Sz = parameters[11];
    const double q_Tx = parameters[12];
    const double q_Ty = parameters[13];
    const double q_Tz = parameters[14];
    const double eps_xy = parameters[19];
    const double eps_yz = parameters[20];
    const double eps_xz = parameters[21];
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
        const double w0 = q_Bz + q_Sz + q_Tz + rTz;
        const double w1 = w0 + z;
        const double w2 = q_By + q_Sy + q_Ty + rTy;
        const double w3 = -w2;
        const double w4 = q_Bx + q_Sx + q_Tx + rTx;
        const double w5 = -w4;
        displacement[0 * stride + i] = EBX*w1 + EBZ*w0 + ECX*w3 + ECZ*w3 + EXX + EXZ + eps_xz*z + x;
        displacement[1 * stride + i] = -EAX*w1 - EAZ*w0 + ECX*w4 + ECZ*w4 + EYX + EYZ + eps_xy*x - eps_yz*z;
        displacement[2 * stride + i] = EAX*w2 + EAZ*w2 + EBX*w5 + EBZ*w5 + EZX + EZZ + z;
    }
}

/*
 * Motion equation of Y and Z: displacement of the workpiece point minus tool point since home, to first order.
 * Source: Eqs. (7)-(11). Operations: 48 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in workpiece_point: 3 rows of stride, mm; point in the workpiece frame (rWx rWy rWz)
 * in tool_point: 3 rows of stride, mm; point in the tool frame (rTx rTy rTz)
 * out displacement: 3 rows of stride, mm; workpiece point minus tool point, displacement since home, in the bed frame
 *     (dx dy dz)
 */
void dmu60p_5axis_motion_YZ(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT workpiece_point,
    const double *TRUEAXIS_RESTRICT tool_point,
    double *TRUEAXIS_RESTRICT displacement)
{
    /* once per call */
    const double q_Cx = parameters[0];
    const double q_Cy = parameters[1];
    const double q_Cz = parameters[2];
    const double q_wx = parameters[3];
    const double q_wy = parameters[4];
    const double q_wz = parameters[5];
    const double q_Bx = parameters[6];
    const double q_By = parameters[7];
    const double q_Bz = parameters[8];
    const double q_Sx = parameters[9];
    const double q_Sy = parameters[10];
    const double q_Sz = parameters[11];
    const double q_Tx = parameters[12];
    const double q_Ty = parameters[13];
    const double q_Tz = parameters[14];
    const double eps_yz = parameters[20];
    const double eps_xz = parameters[21];
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
        const double w0 = q_Cz + q_wz + rWz;
        const double w1 = q_By + q_Sy + q_Ty + rTy;
        const double w2 = q_Cy + q_wy + rWy;
        const double w3 = q_Bz + q_Sz + q_Tz + rTz;
        const double w4 = q_Cx + q_wx + rWx;
        const double w5 = q_Bx + q_Sx + q_Tx + rTx;
        displacement[0 * stride + i] = EBY*w0 - EBZ*w3 - ECY*w2 + ECZ*w1 + EXY - EXZ - eps_xz*z;
        displacement[1 * stride + i] = -EAY*w0 + EAZ*w3 + ECY*w4 - ECZ*w5 + EYY - EYZ + eps_yz*z + y;
        displacement[2 * stride + i] = EAY*w2 - EAZ*w1 - EBY*w4 + EBZ*w5 + EZY - EZZ - z;
    }
}
