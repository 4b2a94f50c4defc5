/* Generated from machines/headhead_mill.toml, do not edit; regenerate with: trueaxis derive machines/headhead_mill.toml
 * SPDX-License-Identifier: MIT
 * Kernels of Five-axis gantry mill with a fork head: geometric error model in C17.
 * Spec: sha256 0ad0abbfc8d51366123f481bf464ef2a99342c0dbb5431fe1300b173adc7b15c
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

int headhead_mill_kernel_abi(void)
{
    return TRUEAXIS_KERNEL_ABI;
}

const char *headhead_mill_spec_hash(void)
{
    return "0ad0abbfc8d51366123f481bf464ef2a99342c0dbb5431fe1300b173adc7b15c";
}

/*
 * Ideal position of a tool point in the workpiece frame.
 * Source: Eqs. (1)-(4) without errors. Operations: 53 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in parameters: 20 values, mm, rad; home positions and location errors (q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z
 *     EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T EZ0T)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out ideal: 3 rows of stride, mm; tool point in the workpiece frame, without errors (px py pz)
 */
void headhead_mill_tool_in_workpiece_ideal(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT ideal)
{
    /* once per call */
    const double q_Bx = parameters[0];
    const double q_By = parameters[1];
    const double q_Bz = parameters[2];
    const double q_Tx = parameters[3];
    const double q_Ty = parameters[4];
    const double q_Tz = parameters[5];
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
            ideal[0 * stride + i] = cos_c*q_Bx - q_By*sin_c + q_Tx*w0 - q_Ty*sin_c + q_Tz*w1 + rx*w0 - ry*sin_c + rz*w1
                + x;
            ideal[1 * stride + i] = cos_c*q_By + cos_c*q_Ty + cos_c*ry + q_Bx*sin_c + q_Tx*w2 + q_Tz*w3 + rx*w2 + rz*w3
                + y;
            ideal[2 * stride + i] = cos_b*q_Tz + cos_b*rz + q_Bz - q_Tx*sin_b - rx*sin_b + z;
        }
    }
}

/*
 * Deviation of a tool point in the workpiece frame, exact.
 * Source: Eqs. (1)-(4). Operations: 173 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 20 values, mm, rad; home positions and location errors (q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z
 *     EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T EZ0T)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; tool point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void headhead_mill_tool_in_workpiece_deviation(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation)
{
    /* once per call */
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
            deviation[0 * stride + i] = EBX*w48 - ECX*w54 + EXX + w55;
            deviation[1 * stride + i] = -EAX*w48 + ECX*w56 + EYX + w53;
            deviation[2 * stride + i] = EAX*w54 - EBX*w56 + EZX + w47;
        }
    }
}

/*
 * Deviation of a tool point in the workpiece frame, to first order in the errors.
 * Source: Eqs. (1)-(4). Operations: 147 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 20 values, mm, rad; home positions and location errors (q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z
 *     EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T EZ0T)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; tool point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void headhead_mill_tool_in_workpiece_deviation_first_order(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation)
{
    /* once per call */
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
            const double w1 = q_Tz + rz;
            const double w2 = cos_b*w1 - sin_b*w0;
            const double w3 = q_Bz + w2;
            const double w4 = w3 + z;
            const double w5 = cos_b*w0 + sin_b*w1;
            const double w6 = q_Bx + w5;
            const double w7 = q_Ty + ry;
            const double w8 = q_By + w7;
            const double w9 = cos_c*w8 + sin_c*w6;
            const double w10 = w9 + y;
            const double w11 = EBB*w1 - ECB*w7 + EX0T + EXB;
            const double w12 = EAB*w7 - EBB*w0 + EZ0T + EZB;
            const double w13 = cos_b*w11 + sin_b*w12;
            const double w14 = -EC0B*w7 + EX0B + w13;
            const double w15 = EBC*w3 - ECC*w8 + EXC + w14;
            const double w16 = -EAB*w1 + ECB*w0 + EY0T + EYB;
            const double w17 = -EA0B*w2 + EC0B*w5 + w16;
            const double w18 = -EAC*w3 + ECC*w6 + EYC + w17;
            const double w19 = cos_c*w15 - sin_c*w18;
            const double w20 = EB0C*w3 + EX0C + w19;
            const double w21 = EBZ*w3 - ECZ*w9 + EXZ + w20;
            const double w22 = EB0Z*w4 + w21;
            const double w23 = EBY*w4 - ECY*w9 + EXY + w22;
            const double w24 = -EC0Y*w10 + w23;
            const double w25 = cos_c*w6 - sin_c*w8;
            const double w26 = cos_c*w18 + sin_c*w15;
            const double w27 = -EA0C*w3 + EY0C + w26;
            const double w28 = -EAZ*w3 + ECZ*w25 + EYZ + w27;
            const double w29 = -EA0Z*w4 + w28;
            const double w30 = -EAY*w4 + ECY*w25 + EYY + w29;
            const double w31 = EC0Y*w25 + w30;
            const double w32 = cos_b*w12 - sin_b*w11;
            const double w33 = EA0B*w7 + EZ0B + w32;
            const double w34 = EAC*w8 - EBC*w6 + EZC + w33;
            const double w35 = EA0C*w9 - EB0C*w25 + w34;
            const double w36 = EAZ*w9 - EBZ*w25 + EZZ + w35;
            const double w37 = EA0Z*w9 - EB0Z*w25 + w36;
            const double w38 = EAY*w9 - EBY*w25 + EZY + w37;
            deviation[0 * stride + i] = EBX*w4 - ECX*w10 + EXX + w24;
            deviation[1 * stride + i] = -EAX*w4 + ECX*w25 + EYX + w31;
            deviation[2 * stride + i] = EAX*w10 - EBX*w25 + EZX + w38;
        }
    }
}

/*
 * Sensitivity of a tool point in the workpiece frame to every error, at the error-free machine.
 * Source: Eqs. (1)-(4), first order. Operations: 129 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in parameters: 20 values, mm, rad; home positions and location errors (q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z
 *     EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T EZ0T)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out sensitivity: 132 rows of stride, mm/mm, mm/rad; derivative of the deviation by each component error, then by
 *     each location error (dx_EXX dx_EYX .. dz_EZ0T, last index fastest)
 */
void headhead_mill_tool_in_workpiece_sensitivity(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT sensitivity)
{
    /* once per call */
    const double q_Bx = parameters[0];
    const double q_By = parameters[1];
    const double q_Bz = parameters[2];
    const double q_Tx = parameters[3];
    const double q_Ty = parameters[4];
    const double q_Tz = parameters[5];
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
            const double y = positions[1 * stride + i];
            const double z = positions[2 * stride + i];
            const double rx = point[0 * stride + i];
            const double ry = point[1 * stride + i];
            const double rz = point[2 * stride + i];
            const double w0 = cos_b*q_Tz;
            const double w1 = cos_b*rz;
            const double w2 = q_Tx*sin_b;
            const double w3 = rx*sin_b;
            const double dx_EBZ = q_Bz + w0 + w1 - w2 - w3;
            const double dx_EBX = dx_EBZ + z;
            const double w4 = cos_c*q_Ty;
            const double w5 = cos_c*ry;
            const double w6 = q_Tx*sin_c;
            const double w7 = rx*sin_c;
            const double w8 = q_Tz*sin_c;
            const double w9 = rz*sin_c;
            const double w10 = cos_b*w6 + cos_b*w7 + sin_b*w8 + sin_b*w9 + w4 + w5;
            const double dz_EAY = cos_c*q_By + q_Bx*sin_c + w10;
            const double dz_EAX = dz_EAY + y;
            const double dx_ECX = -dz_EAX;
            const double dx_ECY = -dz_EAY;
            const double dx_EXB = cos_b*cos_c;
            const double dx_EYB = -sin_c;
            const double dx_EZB = cos_c*sin_b;
            const double dx_EBB = cos_c*w0 + cos_c*w1 - cos_c*w2 - cos_c*w3;
            const double dx_EA0B = sin_c*w0 + sin_c*w1 - sin_c*w2 - sin_c*w3;
            const double dx_EAC = dx_EA0B + q_Bz*sin_c;
            const double dx_EBC = cos_c*q_Bz + dx_EBB;
            const double dy_EAX = -dx_EBX;
            const double w11 = q_Ty*sin_c;
            const double w12 = ry*sin_c;
            const double dy_EC0B = dx_EXB*q_Tx + dx_EXB*rx + dx_EZB*q_Tz + dx_EZB*rz - w11 - w12;
            const double dy_ECX = cos_c*q_Bx + dy_EC0B - q_By*sin_c;
            const double dy_EAZ = -dx_EBZ;
            const double dy_EXB = cos_b*sin_c;
            const double dy_EZB = sin_b*sin_c;
            const double dz_EBX = -dy_ECX;
            const double dz_EXB = -sin_b;
            const double dz_EA0B = q_Ty + ry;
            const double w13 = cos_b*q_Tx + cos_b*rx + q_Tz*sin_b + rz*sin_b;
            sensitivity[0 * stride + i] = 1.0;
            sensitivity[1 * stride + i] = 0.0;
            sensitivity[2 * stride + i] = 0.0;
            sensitivity[3 * stride + i] = 0.0;
            sensitivity[4 * stride + i] = dx_EBX;
            sensitivity[5 * stride + i] = dx_ECX;
            sensitivity[6 * stride + i] = 1.0;
            sensitivity[7 * stride + i] = 0.0;
            sensitivity[8 * stride + i] = 0.0;
            sensitivity[9 * stride + i] = 0.0;
            sensitivity[10 * stride + i] = dx_EBX;
            sensitivity[11 * stride + i] = dx_ECY;
            sensitivity[12 * stride + i] = 1.0;
            sensitivity[13 * stride + i] = 0.0;
            sensitivity[14 * stride + i] = 0.0;
            sensitivity[15 * stride + i] = 0.0;
            sensitivity[16 * stride + i] = dx_EBZ;
            sensitivity[17 * stride + i] = dx_ECY;
            sensitivity[18 * stride + i] = dx_EXB;
            sensitivity[19 * stride + i] = dx_EYB;
            sensitivity[20 * stride + i] = dx_EZB;
            sensitivity[21 * stride + i] = sin_b*w4 + sin_b*w5 + w8 + w9;
            sensitivity[22 * stride + i] = dx_EBB;
            sensitivity[23 * stride + i] = -cos_b*w4 - cos_b*w5 - w6 - w7;
            sensitivity[24 * stride + i] = cos_c;
            sensitivity[25 * stride + i] = dx_EYB;
            sensitivity[26 * stride + i] = 0.0;
            sensitivity[27 * stride + i] = dx_EAC;
            sensitivity[28 * stride + i] = dx_EBC;
            sensitivity[29 * stride + i] = dx_ECY;
            sensitivity[30 * stride + i] = dx_ECX;
            sensitivity[31 * stride + i] = 0.0;
            sensitivity[32 * stride + i] = dx_EBX;
            sensitivity[33 * stride + i] = 1.0;
            sensitivity[34 * stride + i] = 0.0;
            sensitivity[35 * stride + i] = 0.0;
            sensitivity[36 * stride + i] = dx_EBZ;
            sensitivity[37 * stride + i] = cos_c;
            sensitivity[38 * stride + i] = 0.0;
            sensitivity[39 * stride + i] = dx_EA0B;
            sensitivity[40 * stride + i] = -w10;
            sensitivity[41 * stride + i] = dx_EXB;
            sensitivity[42 * stride + i] = dx_EYB;
            sensitivity[43 * stride + i] = dx_EZB;
            sensitivity[44 * stride + i] = 0.0;
            sensitivity[45 * stride + i] = 1.0;
            sensitivity[46 * stride + i] = 0.0;
            sensitivity[47 * stride + i] = dy_EAX;
            sensitivity[48 * stride + i] = 0.0;
            sensitivity[49 * stride + i] = dy_ECX;
            sensitivity[50 * stride + i] = 0.0;
            sensitivity[51 * stride + i] = 1.0;
            sensitivity[52 * stride + i] = 0.0;
            sensitivity[53 * stride + i] = dy_EAX;
            sensitivity[54 * stride + i] = 0.0;
            sensitivity[55 * stride + i] = dy_ECX;
            sensitivity[56 * stride + i] = 0.0;
            sensitivity[57 * stride + i] = 1.0;
            sensitivity[58 * stride + i] = 0.0;
            sensitivity[59 * stride + i] = dy_EAZ;
            sensitivity[60 * stride + i] = 0.0;
            sensitivity[61 * stride + i] = dy_ECX;
            sensitivity[62 * stride + i] = dy_EXB;
            sensitivity[63 * stride + i] = cos_c;
            sensitivity[64 * stride + i] = dy_EZB;
            sensitivity[65 * stride + i] = -cos_c*q_Tz - cos_c*rz + q_Ty*sin_b*sin_c + ry*sin_b*sin_c;
            sensitivity[66 * stride + i] = dx_EA0B;
            sensitivity[67 * stride + i] = -cos_b*w11 - cos_b*w12 + cos_c*q_Tx + cos_c*rx;
            sensitivity[68 * stride + i] = sin_c;
            sensitivity[69 * stride + i] = cos_c;
            sensitivity[70 * stride + i] = 0.0;
            sensitivity[71 * stride + i] = -dx_EBC;
            sensitivity[72 * stride + i] = dx_EAC;
            sensitivity[73 * stride + i] = dy_ECX;
            sensitivity[74 * stride + i] = dy_ECX;
            sensitivity[75 * stride + i] = dy_EAX;
            sensitivity[76 * stride + i] = 0.0;
            sensitivity[77 * stride + i] = 0.0;
            sensitivity[78 * stride + i] = 1.0;
            sensitivity[79 * stride + i] = dy_EAZ;
            sensitivity[80 * stride + i] = 0.0;
            sensitivity[81 * stride + i] = sin_c;
            sensitivity[82 * stride + i] = 0.0;
            sensitivity[83 * stride + i] = -dx_EBB;
            sensitivity[84 * stride + i] = dy_EC0B;
            sensitivity[85 * stride + i] = dy_EXB;
            sensitivity[86 * stride + i] = cos_c;
            sensitivity[87 * stride + i] = dy_EZB;
            sensitivity[88 * stride + i] = 0.0;
            sensitivity[89 * stride + i] = 0.0;
            sensitivity[90 * stride + i] = 1.0;
            sensitivity[91 * stride + i] = dz_EAX;
            sensitivity[92 * stride + i] = dz_EBX;
            sensitivity[93 * stride + i] = 0.0;
            sensitivity[94 * stride + i] = 0.0;
            sensitivity[95 * stride + i] = 0.0;
            sensitivity[96 * stride + i] = 1.0;
            sensitivity[97 * stride + i] = dz_EAY;
            sensitivity[98 * stride + i] = dz_EBX;
            sensitivity[99 * stride + i] = 0.0;
            sensitivity[100 * stride + i] = 0.0;
            sensitivity[101 * stride + i] = 0.0;
            sensitivity[102 * stride + i] = 1.0;
            sensitivity[103 * stride + i] = dz_EAY;
            sensitivity[104 * stride + i] = dz_EBX;
            sensitivity[105 * stride + i] = 0.0;
            sensitivity[106 * stride + i] = dz_EXB;
            sensitivity[107 * stride + i] = 0.0;
            sensitivity[108 * stride + i] = cos_b;
            sensitivity[109 * stride + i] = cos_b*q_Ty + cos_b*ry;
            sensitivity[110 * stride + i] = -w13;
            sensitivity[111 * stride + i] = q_Ty*sin_b + ry*sin_b;
            sensitivity[112 * stride + i] = 0.0;
            sensitivity[113 * stride + i] = 0.0;
            sensitivity[114 * stride + i] = 1.0;
            sensitivity[115 * stride + i] = dz_EA0B + q_By;
            sensitivity[116 * stride + i] = -q_Bx - w13;
            sensitivity[117 * stride + i] = 0.0;
            sensitivity[118 * stride + i] = 0.0;
            sensitivity[119 * stride + i] = dz_EAY;
            sensitivity[120 * stride + i] = dz_EBX;
            sensitivity[121 * stride + i] = 0.0;
            sensitivity[122 * stride + i] = 0.0;
            sensitivity[123 * stride + i] = dz_EAY;
            sensitivity[124 * stride + i] = dz_EBX;
            sensitivity[125 * stride + i] = 0.0;
            sensitivity[126 * stride + i] = 1.0;
            sensitivity[127 * stride + i] = dz_EA0B;
            sensitivity[128 * stride + i] = 0.0;
            sensitivity[129 * stride + i] = dz_EXB;
            sensitivity[130 * stride + i] = 0.0;
            sensitivity[131 * stride + i] = cos_b;
        }
    }
}

/*
 * Ideal position of a tool point in the bed frame.
 * Source: Eqs. (1)-(4) without errors. Operations: 53 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in parameters: 20 values, mm, rad; home positions and location errors (q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z
 *     EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T EZ0T)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out ideal: 3 rows of stride, mm; tool point in the bed frame, without errors (px py pz)
 */
void headhead_mill_tool_in_bed_ideal(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT ideal)
{
    /* once per call */
    const double q_Bx = parameters[0];
    const double q_By = parameters[1];
    const double q_Bz = parameters[2];
    const double q_Tx = parameters[3];
    const double q_Ty = parameters[4];
    const double q_Tz = parameters[5];
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
            ideal[0 * stride + i] = cos_c*q_Bx - q_By*sin_c + q_Tx*w0 - q_Ty*sin_c + q_Tz*w1 + rx*w0 - ry*sin_c + rz*w1
                + x;
            ideal[1 * stride + i] = cos_c*q_By + cos_c*q_Ty + cos_c*ry + q_Bx*sin_c + q_Tx*w2 + q_Tz*w3 + rx*w2 + rz*w3
                + y;
            ideal[2 * stride + i] = cos_b*q_Tz + cos_b*rz + q_Bz - q_Tx*sin_b - rx*sin_b + z;
        }
    }
}

/*
 * Deviation of a tool point in the bed frame, exact.
 * Source: Eqs. (1)-(4). Operations: 173 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 20 values, mm, rad; home positions and location errors (q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z
 *     EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T EZ0T)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; tool point in the bed frame, actual minus ideal (dx dy dz)
 */
void headhead_mill_tool_in_bed_deviation(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation)
{
    /* once per call */
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
            deviation[0 * stride + i] = EBX*w48 - ECX*w54 + EXX + w55;
            deviation[1 * stride + i] = -EAX*w48 + ECX*w56 + EYX + w53;
            deviation[2 * stride + i] = EAX*w54 - EBX*w56 + EZX + w47;
        }
    }
}

/*
 * Deviation of a tool point in the bed frame, to first order in the errors.
 * Source: Eqs. (1)-(4). Operations: 147 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 20 values, mm, rad; home positions and location errors (q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z
 *     EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T EZ0T)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; tool point in the bed frame, actual minus ideal (dx dy dz)
 */
void headhead_mill_tool_in_bed_deviation_first_order(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation)
{
    /* once per call */
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
            const double w1 = q_Tz + rz;
            const double w2 = cos_b*w1 - sin_b*w0;
            const double w3 = q_Bz + w2;
            const double w4 = w3 + z;
            const double w5 = cos_b*w0 + sin_b*w1;
            const double w6 = q_Bx + w5;
            const double w7 = q_Ty + ry;
            const double w8 = q_By + w7;
            const double w9 = cos_c*w8 + sin_c*w6;
            const double w10 = w9 + y;
            const double w11 = EBB*w1 - ECB*w7 + EX0T + EXB;
            const double w12 = EAB*w7 - EBB*w0 + EZ0T + EZB;
            const double w13 = cos_b*w11 + sin_b*w12;
            const double w14 = -EC0B*w7 + EX0B + w13;
            const double w15 = EBC*w3 - ECC*w8 + EXC + w14;
            const double w16 = -EAB*w1 + ECB*w0 + EY0T + EYB;
            const double w17 = -EA0B*w2 + EC0B*w5 + w16;
            const double w18 = -EAC*w3 + ECC*w6 + EYC + w17;
            const double w19 = cos_c*w15 - sin_c*w18;
            const double w20 = EB0C*w3 + EX0C + w19;
            const double w21 = EBZ*w3 - ECZ*w9 + EXZ + w20;
            const double w22 = EB0Z*w4 + w21;
            const double w23 = EBY*w4 - ECY*w9 + EXY + w22;
            const double w24 = -EC0Y*w10 + w23;
            const double w25 = cos_c*w6 - sin_c*w8;
            const double w26 = cos_c*w18 + sin_c*w15;
            const double w27 = -EA0C*w3 + EY0C + w26;
            const double w28 = -EAZ*w3 + ECZ*w25 + EYZ + w27;
            const double w29 = -EA0Z*w4 + w28;
            const double w30 = -EAY*w4 + ECY*w25 + EYY + w29;
            const double w31 = EC0Y*w25 + w30;
            const double w32 = cos_b*w12 - sin_b*w11;
            const double w33 = EA0B*w7 + EZ0B + w32;
            const double w34 = EAC*w8 - EBC*w6 + EZC + w33;
            const double w35 = EA0C*w9 - EB0C*w25 + w34;
            const double w36 = EAZ*w9 - EBZ*w25 + EZZ + w35;
            const double w37 = EA0Z*w9 - EB0Z*w25 + w36;
            const double w38 = EAY*w9 - EBY*w25 + EZY + w37;
            deviation[0 * stride + i] = EBX*w4 - ECX*w10 + EXX + w24;
            deviation[1 * stride + i] = -EAX*w4 + ECX*w25 + EYX + w31;
            deviation[2 * stride + i] = EAX*w10 - EBX*w25 + EZX + w38;
        }
    }
}

/*
 * Sensitivity of a tool point in the bed frame to every error, at the error-free machine.
 * Source: Eqs. (1)-(4), first order. Operations: 129 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in parameters: 20 values, mm, rad; home positions and location errors (q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z
 *     EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T EZ0T)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out sensitivity: 132 rows of stride, mm/mm, mm/rad; derivative of the deviation by each component error, then by
 *     each location error (dx_EXX dx_EYX .. dz_EZ0T, last index fastest)
 */
void headhead_mill_tool_in_bed_sensitivity(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT sensitivity)
{
    /* once per call */
    const double q_Bx = parameters[0];
    const double q_By = parameters[1];
    const double q_Bz = parameters[2];
    const double q_Tx = parameters[3];
    const double q_Ty = parameters[4];
    const double q_Tz = parameters[5];
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
            const double y = positions[1 * stride + i];
            const double z = positions[2 * stride + i];
            const double rx = point[0 * stride + i];
            const double ry = point[1 * stride + i];
            const double rz = point[2 * stride + i];
            const double w0 = cos_b*q_Tz;
            const double w1 = cos_b*rz;
            const double w2 = q_Tx*sin_b;
            const double w3 = rx*sin_b;
            const double dx_EBZ = q_Bz + w0 + w1 - w2 - w3;
            const double dx_EBX = dx_EBZ + z;
            const double w4 = cos_c*q_Ty;
            const double w5 = cos_c*ry;
            const double w6 = q_Tx*sin_c;
            const double w7 = rx*sin_c;
            const double w8 = q_Tz*sin_c;
            const double w9 = rz*sin_c;
            const double w10 = cos_b*w6 + cos_b*w7 + sin_b*w8 + sin_b*w9 + w4 + w5;
            const double dz_EAY = cos_c*q_By + q_Bx*sin_c + w10;
            const double dz_EAX = dz_EAY + y;
            const double dx_ECX = -dz_EAX;
            const double dx_ECY = -dz_EAY;
            const double dx_EXB = cos_b*cos_c;
            const double dx_EYB = -sin_c;
            const double dx_EZB = cos_c*sin_b;
            const double dx_EBB = cos_c*w0 + cos_c*w1 - cos_c*w2 - cos_c*w3;
            const double dx_EA0B = sin_c*w0 + sin_c*w1 - sin_c*w2 - sin_c*w3;
            const double dx_EAC = dx_EA0B + q_Bz*sin_c;
            const double dx_EBC = cos_c*q_Bz + dx_EBB;
            const double dy_EAX = -dx_EBX;
            const double w11 = q_Ty*sin_c;
            const double w12 = ry*sin_c;
            const double dy_EC0B = dx_EXB*q_Tx + dx_EXB*rx + dx_EZB*q_Tz + dx_EZB*rz - w11 - w12;
            const double dy_ECX = cos_c*q_Bx + dy_EC0B - q_By*sin_c;
            const double dy_EAZ = -dx_EBZ;
            const double dy_EXB = cos_b*sin_c;
            const double dy_EZB = sin_b*sin_c;
            const double dz_EBX = -dy_ECX;
            const double dz_EXB = -sin_b;
            const double dz_EA0B = q_Ty + ry;
            const double w13 = cos_b*q_Tx + cos_b*rx + q_Tz*sin_b + rz*sin_b;
            sensitivity[0 * stride + i] = 1.0;
            sensitivity[1 * stride + i] = 0.0;
            sensitivity[2 * stride + i] = 0.0;
            sensitivity[3 * stride + i] = 0.0;
            sensitivity[4 * stride + i] = dx_EBX;
            sensitivity[5 * stride + i] = dx_ECX;
            sensitivity[6 * stride + i] = 1.0;
            sensitivity[7 * stride + i] = 0.0;
            sensitivity[8 * stride + i] = 0.0;
            sensitivity[9 * stride + i] = 0.0;
            sensitivity[10 * stride + i] = dx_EBX;
            sensitivity[11 * stride + i] = dx_ECY;
            sensitivity[12 * stride + i] = 1.0;
            sensitivity[13 * stride + i] = 0.0;
            sensitivity[14 * stride + i] = 0.0;
            sensitivity[15 * stride + i] = 0.0;
            sensitivity[16 * stride + i] = dx_EBZ;
            sensitivity[17 * stride + i] = dx_ECY;
            sensitivity[18 * stride + i] = dx_EXB;
            sensitivity[19 * stride + i] = dx_EYB;
            sensitivity[20 * stride + i] = dx_EZB;
            sensitivity[21 * stride + i] = sin_b*w4 + sin_b*w5 + w8 + w9;
            sensitivity[22 * stride + i] = dx_EBB;
            sensitivity[23 * stride + i] = -cos_b*w4 - cos_b*w5 - w6 - w7;
            sensitivity[24 * stride + i] = cos_c;
            sensitivity[25 * stride + i] = dx_EYB;
            sensitivity[26 * stride + i] = 0.0;
            sensitivity[27 * stride + i] = dx_EAC;
            sensitivity[28 * stride + i] = dx_EBC;
            sensitivity[29 * stride + i] = dx_ECY;
            sensitivity[30 * stride + i] = dx_ECX;
            sensitivity[31 * stride + i] = 0.0;
            sensitivity[32 * stride + i] = dx_EBX;
            sensitivity[33 * stride + i] = 1.0;
            sensitivity[34 * stride + i] = 0.0;
            sensitivity[35 * stride + i] = 0.0;
            sensitivity[36 * stride + i] = dx_EBZ;
            sensitivity[37 * stride + i] = cos_c;
            sensitivity[38 * stride + i] = 0.0;
            sensitivity[39 * stride + i] = dx_EA0B;
            sensitivity[40 * stride + i] = -w10;
            sensitivity[41 * stride + i] = dx_EXB;
            sensitivity[42 * stride + i] = dx_EYB;
            sensitivity[43 * stride + i] = dx_EZB;
            sensitivity[44 * stride + i] = 0.0;
            sensitivity[45 * stride + i] = 1.0;
            sensitivity[46 * stride + i] = 0.0;
            sensitivity[47 * stride + i] = dy_EAX;
            sensitivity[48 * stride + i] = 0.0;
            sensitivity[49 * stride + i] = dy_ECX;
            sensitivity[50 * stride + i] = 0.0;
            sensitivity[51 * stride + i] = 1.0;
            sensitivity[52 * stride + i] = 0.0;
            sensitivity[53 * stride + i] = dy_EAX;
            sensitivity[54 * stride + i] = 0.0;
            sensitivity[55 * stride + i] = dy_ECX;
            sensitivity[56 * stride + i] = 0.0;
            sensitivity[57 * stride + i] = 1.0;
            sensitivity[58 * stride + i] = 0.0;
            sensitivity[59 * stride + i] = dy_EAZ;
            sensitivity[60 * stride + i] = 0.0;
            sensitivity[61 * stride + i] = dy_ECX;
            sensitivity[62 * stride + i] = dy_EXB;
            sensitivity[63 * stride + i] = cos_c;
            sensitivity[64 * stride + i] = dy_EZB;
            sensitivity[65 * stride + i] = -cos_c*q_Tz - cos_c*rz + q_Ty*sin_b*sin_c + ry*sin_b*sin_c;
            sensitivity[66 * stride + i] = dx_EA0B;
            sensitivity[67 * stride + i] = -cos_b*w11 - cos_b*w12 + cos_c*q_Tx + cos_c*rx;
            sensitivity[68 * stride + i] = sin_c;
            sensitivity[69 * stride + i] = cos_c;
            sensitivity[70 * stride + i] = 0.0;
            sensitivity[71 * stride + i] = -dx_EBC;
            sensitivity[72 * stride + i] = dx_EAC;
            sensitivity[73 * stride + i] = dy_ECX;
            sensitivity[74 * stride + i] = dy_ECX;
            sensitivity[75 * stride + i] = dy_EAX;
            sensitivity[76 * stride + i] = 0.0;
            sensitivity[77 * stride + i] = 0.0;
            sensitivity[78 * stride + i] = 1.0;
            sensitivity[79 * stride + i] = dy_EAZ;
            sensitivity[80 * stride + i] = 0.0;
            sensitivity[81 * stride + i] = sin_c;
            sensitivity[82 * stride + i] = 0.0;
            sensitivity[83 * stride + i] = -dx_EBB;
            sensitivity[84 * stride + i] = dy_EC0B;
            sensitivity[85 * stride + i] = dy_EXB;
            sensitivity[86 * stride + i] = cos_c;
            sensitivity[87 * stride + i] = dy_EZB;
            sensitivity[88 * stride + i] = 0.0;
            sensitivity[89 * stride + i] = 0.0;
            sensitivity[90 * stride + i] = 1.0;
            sensitivity[91 * stride + i] = dz_EAX;
            sensitivity[92 * stride + i] = dz_EBX;
            sensitivity[93 * stride + i] = 0.0;
            sensitivity[94 * stride + i] = 0.0;
            sensitivity[95 * stride + i] = 0.0;
            sensitivity[96 * stride + i] = 1.0;
            sensitivity[97 * stride + i] = dz_EAY;
            sensitivity[98 * stride + i] = dz_EBX;
            sensitivity[99 * stride + i] = 0.0;
            sensitivity[100 * stride + i] = 0.0;
            sensitivity[101 * stride + i] = 0.0;
            sensitivity[102 * stride + i] = 1.0;
            sensitivity[103 * stride + i] = dz_EAY;
            sensitivity[104 * stride + i] = dz_EBX;
            sensitivity[105 * stride + i] = 0.0;
            sensitivity[106 * stride + i] = dz_EXB;
            sensitivity[107 * stride + i] = 0.0;
            sensitivity[108 * stride + i] = cos_b;
            sensitivity[109 * stride + i] = cos_b*q_Ty + cos_b*ry;
            sensitivity[110 * stride + i] = -w13;
            sensitivity[111 * stride + i] = q_Ty*sin_b + ry*sin_b;
            sensitivity[112 * stride + i] = 0.0;
            sensitivity[113 * stride + i] = 0.0;
            sensitivity[114 * stride + i] = 1.0;
            sensitivity[115 * stride + i] = dz_EA0B + q_By;
            sensitivity[116 * stride + i] = -q_Bx - w13;
            sensitivity[117 * stride + i] = 0.0;
            sensitivity[118 * stride + i] = 0.0;
            sensitivity[119 * stride + i] = dz_EAY;
            sensitivity[120 * stride + i] = dz_EBX;
            sensitivity[121 * stride + i] = 0.0;
            sensitivity[122 * stride + i] = 0.0;
            sensitivity[123 * stride + i] = dz_EAY;
            sensitivity[124 * stride + i] = dz_EBX;
            sensitivity[125 * stride + i] = 0.0;
            sensitivity[126 * stride + i] = 1.0;
            sensitivity[127 * stride + i] = dz_EA0B;
            sensitivity[128 * stride + i] = 0.0;
            sensitivity[129 * stride + i] = dz_EXB;
            sensitivity[130 * stride + i] = 0.0;
            sensitivity[131 * stride + i] = cos_b;
        }
    }
}

/*
 * Ideal position of a workpiece point in the bed frame.
 * Source: Eqs. (1)-(4) without errors. Operations: 0 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in parameters: 20 values, mm, rad; home positions and location errors (q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z
 *     EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T EZ0T)
 * in point: 3 rows of stride, mm; point in the workpiece frame (rx ry rz)
 * out ideal: 3 rows of stride, mm; workpiece point in the bed frame, without errors (px py pz)
 */
void headhead_mill_workpiece_in_bed_ideal(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT ideal)
{
    (void)positions;
    (void)parameters;
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
        const double rx = point[0 * stride + i];
        const double ry = point[1 * stride + i];
        const double rz = point[2 * stride + i];
        ideal[0 * stride + i] = rx;
        ideal[1 * stride + i] = ry;
        ideal[2 * stride + i] = rz;
    }
}

/*
 * Deviation of a workpiece point in the bed frame, exact.
 * Source: Eqs. (1)-(4). Operations: 0 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 20 values, mm, rad; home positions and location errors (q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z
 *     EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T EZ0T)
 * in point: 3 rows of stride, mm; point in the workpiece frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; workpiece point in the bed frame, actual minus ideal (dx dy dz)
 */
void headhead_mill_workpiece_in_bed_deviation(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation)
{
    (void)positions;
    (void)errors;
    (void)parameters;
    (void)point;
    /* every row is zero, whatever is given */
    for (size_t row = 0; row < 3; ++row) {
        POINTS_ARE_INDEPENDENT
        for (size_t i = 0; i < n; ++i) {
            deviation[row * stride + i] = 0.0;
        }
    }
}

/*
 * Deviation of a workpiece point in the bed frame, to first order in the errors.
 * Source: Eqs. (1)-(4). Operations: 0 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 20 values, mm, rad; home positions and location errors (q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z
 *     EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T EZ0T)
 * in point: 3 rows of stride, mm; point in the workpiece frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; workpiece point in the bed frame, actual minus ideal (dx dy dz)
 */
void headhead_mill_workpiece_in_bed_deviation_first_order(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation)
{
    (void)positions;
    (void)errors;
    (void)parameters;
    (void)point;
    /* every row is zero, whatever is given */
    for (size_t row = 0; row < 3; ++row) {
        POINTS_ARE_INDEPENDENT
        for (size_t i = 0; i < n; ++i) {
            deviation[row * stride + i] = 0.0;
        }
    }
}

/*
 * Sensitivity of a workpiece point in the bed frame to every error, at the error-free machine.
 * Source: Eqs. (1)-(4), first order. Operations: 0 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in parameters: 20 values, mm, rad; home positions and location errors (q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z
 *     EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T EZ0T)
 * in point: 3 rows of stride, mm; point in the workpiece frame (rx ry rz)
 * out sensitivity: 132 rows of stride, mm/mm, mm/rad; derivative of the deviation by each component error, then by
 *     each location error (dx_EXX dx_EYX .. dz_EZ0T, last index fastest)
 */
void headhead_mill_workpiece_in_bed_sensitivity(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT sensitivity)
{
    (void)positions;
    (void)parameters;
    (void)point;
    /* every row is zero, whatever is given */
    for (size_t row = 0; row < 132; ++row) {
        POINTS_ARE_INDEPENDENT
        for (size_t i = 0; i < n; ++i) {
            sensitivity[row * stride + i] = 0.0;
        }
    }
}

/*
 * Ideal position of a bed point in the workpiece frame.
 * Source: Eqs. (1)-(4) without errors. Operations: 0 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in parameters: 20 values, mm, rad; home positions and location errors (q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z
 *     EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T EZ0T)
 * in point: 3 rows of stride, mm; point in the bed frame (rx ry rz)
 * out ideal: 3 rows of stride, mm; bed point in the workpiece frame, without errors (px py pz)
 */
void headhead_mill_bed_in_workpiece_ideal(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT ideal)
{
    (void)positions;
    (void)parameters;
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
        const double rx = point[0 * stride + i];
        const double ry = point[1 * stride + i];
        const double rz = point[2 * stride + i];
        ideal[0 * stride + i] = rx;
        ideal[1 * stride + i] = ry;
        ideal[2 * stride + i] = rz;
    }
}

/*
 * Deviation of a bed point in the workpiece frame, exact.
 * Source: Eqs. (1)-(4). Operations: 0 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 20 values, mm, rad; home positions and location errors (q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z
 *     EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T EZ0T)
 * in point: 3 rows of stride, mm; point in the bed frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; bed point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void headhead_mill_bed_in_workpiece_deviation(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation)
{
    (void)positions;
    (void)errors;
    (void)parameters;
    (void)point;
    /* every row is zero, whatever is given */
    for (size_t row = 0; row < 3; ++row) {
        POINTS_ARE_INDEPENDENT
        for (size_t i = 0; i < n; ++i) {
            deviation[row * stride + i] = 0.0;
        }
    }
}

/*
 * Deviation of a bed point in the workpiece frame, to first order in the errors.
 * Source: Eqs. (1)-(4). Operations: 0 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 20 values, mm, rad; home positions and location errors (q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z
 *     EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T EZ0T)
 * in point: 3 rows of stride, mm; point in the bed frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; bed point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void headhead_mill_bed_in_workpiece_deviation_first_order(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation)
{
    (void)positions;
    (void)errors;
    (void)parameters;
    (void)point;
    /* every row is zero, whatever is given */
    for (size_t row = 0; row < 3; ++row) {
        POINTS_ARE_INDEPENDENT
        for (size_t i = 0; i < n; ++i) {
            deviation[row * stride + i] = 0.0;
        }
    }
}

/*
 * Sensitivity of a bed point in the workpiece frame to every error, at the error-free machine.
 * Source: Eqs. (1)-(4), first order. Operations: 0 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in parameters: 20 values, mm, rad; home positions and location errors (q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z
 *     EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T EZ0T)
 * in point: 3 rows of stride, mm; point in the bed frame (rx ry rz)
 * out sensitivity: 132 rows of stride, mm/mm, mm/rad; derivative of the deviation by each component error, then by
 *     each location error (dx_EXX dx_EYX .. dz_EZ0T, last index fastest)
 */
void headhead_mill_bed_in_workpiece_sensitivity(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT sensitivity)
{
    (void)positions;
    (void)parameters;
    (void)point;
    /* every row is zero, whatever is given */
    for (size_t row = 0; row < 132; ++row) {
        POINTS_ARE_INDEPENDENT
        for (size_t i = 0; i < n; ++i) {
            sensitivity[row * stride + i] = 0.0;
        }
    }
}

/*
 * Actual position of the tool point in the workpiece frame, exact.
 * Source: Eq. (4). Operations: 177 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 20 values, mm, rad; home positions and location errors (q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z
 *     EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T EZ0T)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out position: 3 rows of stride, mm; actual position P_T^W of the tool point in the workpiece frame (px py pz)
 */
void headhead_mill_tool_in_workpiece_position(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT position)
{
    /* once per call */
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
            const double w56 = EBX*w48 - ECX*w54 + EXX + w55;
            const double w57 = w32 + x;
            const double w58 = w32 + w55;
            const double w59 = -EAX*w48 + ECX*w58 + EYX + w53;
            const double w60 = EAX*w54 - EBX*w58 + EZX + w47;
            position[0 * stride + i] = w56 + w57;
            position[1 * stride + i] = w49 + w59;
            position[2 * stride + i] = w4 + w60;
        }
    }
}

/*
 * Actual position of the tool point in the workpiece frame, to first order.
 * Source: Eq. (4). Operations: 151 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 20 values, mm, rad; home positions and location errors (q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z
 *     EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T EZ0T)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out position: 3 rows of stride, mm; actual position P_T^W of the tool point in the workpiece frame (px py pz)
 */
void headhead_mill_tool_in_workpiece_position_first_order(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT position)
{
    /* once per call */
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
            const double w1 = q_Tz + rz;
            const double w2 = cos_b*w1 - sin_b*w0;
            const double w3 = q_Bz + w2;
            const double w4 = w3 + z;
            const double w5 = cos_b*w0 + sin_b*w1;
            const double w6 = q_Bx + w5;
            const double w7 = q_Ty + ry;
            const double w8 = q_By + w7;
            const double w9 = cos_c*w8 + sin_c*w6;
            const double w10 = w9 + y;
            const double w11 = EBB*w1 - ECB*w7 + EX0T + EXB;
            const double w12 = EAB*w7 - EBB*w0 + EZ0T + EZB;
            const double w13 = cos_b*w11 + sin_b*w12;
            const double w14 = -EC0B*w7 + EX0B + w13;
            const double w15 = EBC*w3 - ECC*w8 + EXC + w14;
            const double w16 = -EAB*w1 + ECB*w0 + EY0T + EYB;
            const double w17 = -EA0B*w2 + EC0B*w5 + w16;
            const double w18 = -EAC*w3 + ECC*w6 + EYC + w17;
            const double w19 = cos_c*w15 - sin_c*w18;
            const double w20 = EB0C*w3 + EX0C + w19;
            const double w21 = EBZ*w3 - ECZ*w9 + EXZ + w20;
            const double w22 = EB0Z*w4 + w21;
            const double w23 = EBY*w4 - ECY*w9 + EXY + w22;
            const double w24 = -EC0Y*w10 + w23;
            const double w25 = EBX*w4 - ECX*w10 + EXX + w24;
            const double w26 = cos_c*w6 - sin_c*w8;
            const double w27 = w26 + x;
            const double w28 = cos_c*w18 + sin_c*w15;
            const double w29 = -EA0C*w3 + EY0C + w28;
            const double w30 = -EAZ*w3 + ECZ*w26 + EYZ + w29;
            const double w31 = -EA0Z*w4 + w30;
            const double w32 = -EAY*w4 + ECY*w26 + EYY + w31;
            const double w33 = EC0Y*w26 + w32;
            const double w34 = -EAX*w4 + ECX*w26 + EYX + w33;
            const double w35 = cos_b*w12 - sin_b*w11;
            const double w36 = EA0B*w7 + EZ0B + w35;
            const double w37 = EAC*w8 - EBC*w6 + EZC + w36;
            const double w38 = EA0C*w9 - EB0C*w26 + w37;
            const double w39 = EAZ*w9 - EBZ*w26 + EZZ + w38;
            const double w40 = EA0Z*w9 - EB0Z*w26 + w39;
            const double w41 = EAY*w9 - EBY*w26 + EZY + w40;
            const double w42 = EAX*w10 - EBX*w26 + EZX + w41;
            position[0 * stride + i] = w25 + w27;
            position[1 * stride + i] = w10 + w34;
            position[2 * stride + i] = w4 + w42;
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
void headhead_mill_tool_orientation_ideal(
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
            ideal[0 * stride + i] = cos_c*w0 - sin_c*ty;
            ideal[1 * stride + i] = cos_c*ty + sin_c*w0;
            ideal[2 * stride + i] = cos_b*tz - sin_b*tx;
        }
    }
}

/*
 * Deviation of a direction of the tool frame in the workpiece frame, exact.
 * Source: Eqs. (1)-(4), rotations alone. Operations: 140 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 20 values, mm, rad; home positions and location errors (q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z
 *     EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T EZ0T)
 * in direction: 3 rows of stride, 1; unit vector in the tool frame, (0, 0, 1) for the tool axis (tx ty tz)
 * out deviation: 3 rows of stride, 1; the vector in the workpiece frame, actual minus ideal (dx dy dz)
 */
void headhead_mill_tool_orientation_deviation(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT direction,
    double *TRUEAXIS_RESTRICT deviation)
{
    /* once per call */
    const double EC0Y = parameters[6];
    const double EA0Z = parameters[7];
    const double EB0Z = parameters[8];
    const double EA0C = parameters[11];
    const double EB0C = parameters[12];
    const double EA0B = parameters[15];
    const double EC0B = parameters[16];
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
            const double w2 = cos_c*ty + sin_c*w1;
            const double w3 = -EAB*tz + ECB*tx;
            const double w4 = EBB*tz - ECB*ty;
            const double w5 = EAB*ty - EBB*tx;
            const double w6 = cos_b*w4 + sin_b*w5;
            const double w7 = cos_b*w5 - sin_b*w4;
            const double w8 = -EA0B*(w0 + w7) + EC0B*(w1 + w6) + w3;
            const double w9 = ty + w8;
            const double w10 = ty + w3;
            const double w11 = -EC0B*w10 + w6;
            const double w12 = w1 + w11;
            const double w13 = EA0B*w10 + w7;
            const double w14 = EAC*w9 - EBC*w12 + w13;
            const double w15 = w0 + w14;
            const double w16 = w0 + w13;
            const double w17 = EBC*w16 - ECC*w9 + w11;
            const double w18 = -EAC*w16 + ECC*w12 + w8;
            const double w19 = cos_c*w18 + sin_c*w17;
            const double w20 = -EA0C*w15 + w19;
            const double w21 = w2 + w20;
            const double w22 = cos_c*w1 - sin_c*ty;
            const double w23 = cos_c*w17 - sin_c*w18;
            const double w24 = EB0C*w15 + w23;
            const double w25 = w22 + w24;
            const double w26 = EA0C*(w19 + w2) - EB0C*(w22 + w23) + w14;
            const double w27 = EAZ*w21 - EBZ*w25 + w26;
            const double w28 = w0 + w27;
            const double w29 = w0 + w26;
            const double w30 = -EAZ*w29 + ECZ*w25 + w20;
            const double w31 = -EA0Z*w28 + w30;
            const double w32 = w2 + w31;
            const double w33 = EBZ*w29 - ECZ*w21 + w24;
            const double w34 = EB0Z*w28 + w33;
            const double w35 = w22 + w34;
            const double w36 = EA0Z*(w2 + w30) - EB0Z*(w22 + w33) + w27;
            const double w37 = EAY*w32 - EBY*w35 + w36;
            const double w38 = w0 + w37;
            const double w39 = w0 + w36;
            const double w40 = EBY*w39 - ECY*w32 + w34;
            const double w41 = -EAY*w39 + ECY*w35 + w31;
            const double w42 = EC0Y*(w22 + w40) + w41;
            const double w43 = w2 + w42;
            const double w44 = -EC0Y*(w2 + w41) + w40;
            const double w45 = w22 + w44;
            deviation[0 * stride + i] = EBX*w38 - ECX*w43 + w44;
            deviation[1 * stride + i] = -EAX*w38 + ECX*w45 + w42;
            deviation[2 * stride + i] = EAX*w43 - EBX*w45 + w37;
        }
    }
}

/*
 * Deviation of a direction of the tool frame in the workpiece frame, to first order.
 * Source: Eqs. (1)-(4), rotations alone. Operations: 117 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 20 values, mm, rad; home positions and location errors (q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z
 *     EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T EZ0T)
 * in direction: 3 rows of stride, 1; unit vector in the tool frame, (0, 0, 1) for the tool axis (tx ty tz)
 * out deviation: 3 rows of stride, 1; the vector in the workpiece frame, actual minus ideal (dx dy dz)
 */
void headhead_mill_tool_orientation_deviation_first_order(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT direction,
    double *TRUEAXIS_RESTRICT deviation)
{
    /* once per call */
    const double EC0Y = parameters[6];
    const double EA0Z = parameters[7];
    const double EB0Z = parameters[8];
    const double EA0C = parameters[11];
    const double EB0C = parameters[12];
    const double EA0B = parameters[15];
    const double EC0B = parameters[16];
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
            const double w2 = cos_c*ty + sin_c*w1;
            const double w3 = EBB*tz - ECB*ty;
            const double w4 = EAB*ty - EBB*tx;
            const double w5 = cos_b*w3 + sin_b*w4;
            const double w6 = -EC0B*ty + w5;
            const double w7 = EBC*w0 - ECC*ty + w6;
            const double w8 = -EAB*tz + ECB*tx;
            const double w9 = -EA0B*w0 + EC0B*w1 + w8;
            const double w10 = -EAC*w0 + ECC*w1 + w9;
            const double w11 = cos_c*w7 - sin_c*w10;
            const double w12 = EB0C*w0 + w11;
            const double w13 = EBZ*w0 - ECZ*w2 + w12;
            const double w14 = EB0Z*w0 + w13;
            const double w15 = EBY*w0 - ECY*w2 + w14;
            const double w16 = -EC0Y*w2 + w15;
            const double w17 = cos_c*w1 - sin_c*ty;
            const double w18 = cos_c*w10 + sin_c*w7;
            const double w19 = -EA0C*w0 + w18;
            const double w20 = -EAZ*w0 + ECZ*w17 + w19;
            const double w21 = -EA0Z*w0 + w20;
            const double w22 = -EAY*w0 + ECY*w17 + w21;
            const double w23 = EC0Y*w17 + w22;
            const double w24 = cos_b*w4 - sin_b*w3;
            const double w25 = EA0B*ty + w24;
            const double w26 = EAC*ty - EBC*w1 + w25;
            const double w27 = EA0C*w2 - EB0C*w17 + w26;
            const double w28 = EAZ*w2 - EBZ*w17 + w27;
            const double w29 = EA0Z*w2 - EB0Z*w17 + w28;
            const double w30 = EAY*w2 - EBY*w17 + w29;
            deviation[0 * stride + i] = EBX*w0 - ECX*w2 + w16;
            deviation[1 * stride + i] = -EAX*w0 + ECX*w17 + w23;
            deviation[2 * stride + i] = EAX*w2 - EBX*w17 + w30;
        }
    }
}

/*
 * Deviation of the tool point under polynomial error curves, exact.
 * Source: Eqs. (1)-(4), (44). Operations: 556 per point, 7 once per call.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in curves: 210 values, mm/mm^k, rad/mm^k (deg^k for rotary axes); coefficients of the powers 1 to 7 of the axis
 *     position, per component error (EXX_1 EXX_2 .. ECC_7, last index fastest)
 * in parameters: 20 values, mm, rad; home positions and location errors (q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z
 *     EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T EZ0T)
 * in point: 3 values, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; tool point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void headhead_mill_tool_in_workpiece_deviation_curves(
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
    const double rx = point[0];
    const double ry = point[1];
    const double rz = point[2];
    const double w0 = q_Tx + rx;
    const double w1 = q_Tz + rz;
    const double w7 = q_Ty + ry;
    const double w8 = q_By + w7;
    const double w10 = EZ0T + w1;
    const double w11 = EX0T + w0;
    const double w16 = EY0T + w7;
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
            const double w2 = cos_b*w1 - sin_b*w0;
            const double w3 = q_Bz + w2;
            const double w4 = w3 + z;
            const double w5 = cos_b*w0 + sin_b*w1;
            const double w6 = q_Bx + w5;
            const double w9 = cos_c*w8 + sin_c*w6;
            const double w12 = b*(EYB_1 + b*(EYB_2 + b*(EYB_3 + b*(EYB_4 + b*(EYB_5 + b*(EYB_6 + EYB_7*b))))));
            const double w13 = b*(EAB_1 + b*(EAB_2 + b*(EAB_3 + b*(EAB_4 + b*(EAB_5 + b*(EAB_6 + EAB_7*b))))));
            const double w14 = b*(ECB_1 + b*(ECB_2 + b*(ECB_3 + b*(ECB_4 + b*(ECB_5 + b*(ECB_6 + ECB_7*b))))));
            const double w15 = EY0T - w10*w13 + w11*w14 + w12;
            const double w17 = b*(EXB_1 + b*(EXB_2 + b*(EXB_3 + b*(EXB_4 + b*(EXB_5 + b*(EXB_6 + EXB_7*b))))));
            const double w18 = b*(EBB_1 + b*(EBB_2 + b*(EBB_3 + b*(EBB_4 + b*(EBB_5 + b*(EBB_6 + EBB_7*b))))));
            const double w19 = EX0T + w10*w18 - w14*w16 + w17;
            const double w20 = b*(EZB_1 + b*(EZB_2 + b*(EZB_3 + b*(EZB_4 + b*(EZB_5 + b*(EZB_6 + EZB_7*b))))));
            const double w21 = EZ0T - w11*w18 + w13*w16 + w20;
            const double w22 = cos_b*w19 + sin_b*w21;
            const double w23 = cos_b*w21 - sin_b*w19;
            const double w24 = -EA0B*(w2 + w23) + EC0B*(w22 + w5) + w15;
            const double w25 = w24 + w8;
            const double w26 = w15 + w7;
            const double w27 = -EC0B*w26 + EX0B + w22;
            const double w28 = w27 + w6;
            const double w29 = c*(EZC_1 + c*(EZC_2 + c*(EZC_3 + c*(EZC_4 + c*(EZC_5 + c*(EZC_6 + EZC_7*c))))));
            const double w30 = c*(EAC_1 + c*(EAC_2 + c*(EAC_3 + c*(EAC_4 + c*(EAC_5 + c*(EAC_6 + EAC_7*c))))));
            const double w31 = c*(EBC_1 + c*(EBC_2 + c*(EBC_3 + c*(EBC_4 + c*(EBC_5 + c*(EBC_6 + EBC_7*c))))));
            const double w32 = EA0B*w26 + EZ0B + w23;
            const double w33 = w25*w30 - w28*w31 + w29 + w32;
            const double w34 = w3 + w33;
            const double w35 = w3 + w32;
            const double w36 = c*(EXC_1 + c*(EXC_2 + c*(EXC_3 + c*(EXC_4 + c*(EXC_5 + c*(EXC_6 + EXC_7*c))))));
            const double w37 = c*(ECC_1 + c*(ECC_2 + c*(ECC_3 + c*(ECC_4 + c*(ECC_5 + c*(ECC_6 + ECC_7*c))))));
            const double w38 = -w25*w37 + w27 + w31*w35 + w36;
            const double w39 = c*(EYC_1 + c*(EYC_2 + c*(EYC_3 + c*(EYC_4 + c*(EYC_5 + c*(EYC_6 + EYC_7*c))))));
            const double w40 = w24 + w28*w37 - w30*w35 + w39;
            const double w41 = cos_c*w40 + sin_c*w38;
            const double w42 = -EA0C*w34 + EY0C + w41;
            const double w43 = w42 + w9;
            const double w44 = cos_c*w6 - sin_c*w8;
            const double w45 = cos_c*w38 - sin_c*w40;
            const double w46 = EB0C*w34 + EX0C + w45;
            const double w47 = w44 + w46;
            const double w48 = z*(EZZ_1 + z*(EZZ_2 + z*(EZZ_3 + z*(EZZ_4 + z*(EZZ_5 + z*(EZZ_6 + EZZ_7*z))))));
            const double w49 = z*(EAZ_1 + z*(EAZ_2 + z*(EAZ_3 + z*(EAZ_4 + z*(EAZ_5 + z*(EAZ_6 + EAZ_7*z))))));
            const double w50 = z*(EBZ_1 + z*(EBZ_2 + z*(EBZ_3 + z*(EBZ_4 + z*(EBZ_5 + z*(EBZ_6 + EBZ_7*z))))));
            const double w51 = EA0C*(w41 + w9) - EB0C*(w44 + w45) + w33;
            const double w52 = w43*w49 - w47*w50 + w48 + w51;
            const double w53 = w4 + w52;
            const double w54 = w3 + w51;
            const double w55 = z*(EYZ_1 + z*(EYZ_2 + z*(EYZ_3 + z*(EYZ_4 + z*(EYZ_5 + z*(EYZ_6 + EYZ_7*z))))));
            const double w56 = z*(ECZ_1 + z*(ECZ_2 + z*(ECZ_3 + z*(ECZ_4 + z*(ECZ_5 + z*(ECZ_6 + ECZ_7*z))))));
            const double w57 = w42 + w47*w56 - w49*w54 + w55;
            const double w58 = -EA0Z*w53 + w57;
            const double w59 = w58 + w9;
            const double w60 = z*(EXZ_1 + z*(EXZ_2 + z*(EXZ_3 + z*(EXZ_4 + z*(EXZ_5 + z*(EXZ_6 + EXZ_7*z))))));
            const double w61 = -w43*w56 + w46 + w50*w54 + w60;
            const double w62 = EB0Z*w53 + w61;
            const double w63 = w44 + w62;
            const double w64 = y*(EZY_1 + y*(EZY_2 + y*(EZY_3 + y*(EZY_4 + y*(EZY_5 + y*(EZY_6 + EZY_7*y))))));
            const double w65 = y*(EAY_1 + y*(EAY_2 + y*(EAY_3 + y*(EAY_4 + y*(EAY_5 + y*(EAY_6 + EAY_7*y))))));
            const double w66 = y*(EBY_1 + y*(EBY_2 + y*(EBY_3 + y*(EBY_4 + y*(EBY_5 + y*(EBY_6 + EBY_7*y))))));
            const double w67 = EA0Z*(w57 + w9) - EB0Z*(w44 + w61) + w52;
            const double w68 = w59*w65 - w63*w66 + w64 + w67;
            const double w69 = w4 + w68;
            const double w70 = w9 + y;
            const double w71 = w4 + w67;
            const double w72 = y*(EXY_1 + y*(EXY_2 + y*(EXY_3 + y*(EXY_4 + y*(EXY_5 + y*(EXY_6 + EXY_7*y))))));
            const double w73 = y*(ECY_1 + y*(ECY_2 + y*(ECY_3 + y*(ECY_4 + y*(ECY_5 + y*(ECY_6 + ECY_7*y))))));
            const double w74 = -w59*w73 + w62 + w66*w71 + w72;
            const double w75 = y*(EYY_1 + y*(EYY_2 + y*(EYY_3 + y*(EYY_4 + y*(EYY_5 + y*(EYY_6 + EYY_7*y))))));
            const double w76 = w58 + w63*w73 - w65*w71 + w75;
            const double w77 = EC0Y*(w44 + w74) + w76;
            const double w78 = w70 + w77;
            const double w79 = x*(EXX_1 + x*(EXX_2 + x*(EXX_3 + x*(EXX_4 + x*(EXX_5 + x*(EXX_6 + EXX_7*x))))));
            const double w80 = x*(EBX_1 + x*(EBX_2 + x*(EBX_3 + x*(EBX_4 + x*(EBX_5 + x*(EBX_6 + EBX_7*x))))));
            const double w81 = x*(ECX_1 + x*(ECX_2 + x*(ECX_3 + x*(ECX_4 + x*(ECX_5 + x*(ECX_6 + ECX_7*x))))));
            const double w82 = -EC0Y*(w70 + w76) + w74;
            const double w83 = w44 + w82;
            const double w84 = x*(EYX_1 + x*(EYX_2 + x*(EYX_3 + x*(EYX_4 + x*(EYX_5 + x*(EYX_6 + EYX_7*x))))));
            const double w85 = x*(EAX_1 + x*(EAX_2 + x*(EAX_3 + x*(EAX_4 + x*(EAX_5 + x*(EAX_6 + EAX_7*x))))));
            const double w86 = x*(EZX_1 + x*(EZX_2 + x*(EZX_3 + x*(EZX_4 + x*(EZX_5 + x*(EZX_6 + EZX_7*x))))));
            deviation[0 * stride + i] = w69*w80 - w78*w81 + w79 + w82;
            deviation[1 * stride + i] = -w69*w85 + w77 + w81*w83 + w84;
            deviation[2 * stride + i] = w68 + w78*w85 - w80*w83 + w86;
        }
    }
}

/*
 * Deviation of the tool point under polynomial error curves, to first order.
 * Source: Eqs. (1)-(4), (44). Operations: 533 per point, 4 once per call.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in curves: 210 values, mm/mm^k, rad/mm^k (deg^k for rotary axes); coefficients of the powers 1 to 7 of the axis
 *     position, per component error (EXX_1 EXX_2 .. ECC_7, last index fastest)
 * in parameters: 20 values, mm, rad; home positions and location errors (q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z
 *     EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T EZ0T)
 * in point: 3 values, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; tool point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void headhead_mill_tool_in_workpiece_deviation_first_order_curves(
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
    const double rx = point[0];
    const double ry = point[1];
    const double rz = point[2];
    const double w3 = q_Tx + rx;
    const double w4 = q_Tz + rz;
    const double w10 = q_Ty + ry;
    const double w11 = q_By + w10;
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
            const double w0 = x*(EXX_1 + x*(EXX_2 + x*(EXX_3 + x*(EXX_4 + x*(EXX_5 + x*(EXX_6 + EXX_7*x))))));
            const double w1 = x*(EBX_1 + x*(EBX_2 + x*(EBX_3 + x*(EBX_4 + x*(EBX_5 + x*(EBX_6 + EBX_7*x))))));
            const double w2 = x*(ECX_1 + x*(ECX_2 + x*(ECX_3 + x*(ECX_4 + x*(ECX_5 + x*(ECX_6 + ECX_7*x))))));
            const double w5 = cos_b*w4 - sin_b*w3;
            const double w6 = q_Bz + w5;
            const double w7 = w6 + z;
            const double w8 = cos_b*w3 + sin_b*w4;
            const double w9 = q_Bx + w8;
            const double w12 = cos_c*w11 + sin_c*w9;
            const double w13 = w12 + y;
            const double w14 = y*(EXY_1 + y*(EXY_2 + y*(EXY_3 + y*(EXY_4 + y*(EXY_5 + y*(EXY_6 + EXY_7*y))))));
            const double w15 = y*(EBY_1 + y*(EBY_2 + y*(EBY_3 + y*(EBY_4 + y*(EBY_5 + y*(EBY_6 + EBY_7*y))))));
            const double w16 = y*(ECY_1 + y*(ECY_2 + y*(ECY_3 + y*(ECY_4 + y*(ECY_5 + y*(ECY_6 + ECY_7*y))))));
            const double w17 = z*(EXZ_1 + z*(EXZ_2 + z*(EXZ_3 + z*(EXZ_4 + z*(EXZ_5 + z*(EXZ_6 + EXZ_7*z))))));
            const double w18 = z*(EBZ_1 + z*(EBZ_2 + z*(EBZ_3 + z*(EBZ_4 + z*(EBZ_5 + z*(EBZ_6 + EBZ_7*z))))));
            const double w19 = z*(ECZ_1 + z*(ECZ_2 + z*(ECZ_3 + z*(ECZ_4 + z*(ECZ_5 + z*(ECZ_6 + ECZ_7*z))))));
            const double w20 = c*(EXC_1 + c*(EXC_2 + c*(EXC_3 + c*(EXC_4 + c*(EXC_5 + c*(EXC_6 + EXC_7*c))))));
            const double w21 = c*(EBC_1 + c*(EBC_2 + c*(EBC_3 + c*(EBC_4 + c*(EBC_5 + c*(EBC_6 + EBC_7*c))))));
            const double w22 = c*(ECC_1 + c*(ECC_2 + c*(ECC_3 + c*(ECC_4 + c*(ECC_5 + c*(ECC_6 + ECC_7*c))))));
            const double w23 = b*(EXB_1 + b*(EXB_2 + b*(EXB_3 + b*(EXB_4 + b*(EXB_5 + b*(EXB_6 + EXB_7*b))))));
            const double w24 = b*(EBB_1 + b*(EBB_2 + b*(EBB_3 + b*(EBB_4 + b*(EBB_5 + b*(EBB_6 + EBB_7*b))))));
            const double w25 = b*(ECB_1 + b*(ECB_2 + b*(ECB_3 + b*(ECB_4 + b*(ECB_5 + b*(ECB_6 + ECB_7*b))))));
            const double w26 = EX0T - w10*w25 + w23 + w24*w4;
            const double w27 = b*(EZB_1 + b*(EZB_2 + b*(EZB_3 + b*(EZB_4 + b*(EZB_5 + b*(EZB_6 + EZB_7*b))))));
            const double w28 = b*(EAB_1 + b*(EAB_2 + b*(EAB_3 + b*(EAB_4 + b*(EAB_5 + b*(EAB_6 + EAB_7*b))))));
            const double w29 = EZ0T + w10*w28 - w24*w3 + w27;
            const double w30 = cos_b*w26 + sin_b*w29;
            const double w31 = -EC0B*w10 + EX0B + w30;
            const double w32 = -w11*w22 + w20 + w21*w6 + w31;
            const double w33 = c*(EYC_1 + c*(EYC_2 + c*(EYC_3 + c*(EYC_4 + c*(EYC_5 + c*(EYC_6 + EYC_7*c))))));
            const double w34 = c*(EAC_1 + c*(EAC_2 + c*(EAC_3 + c*(EAC_4 + c*(EAC_5 + c*(EAC_6 + EAC_7*c))))));
            const double w35 = b*(EYB_1 + b*(EYB_2 + b*(EYB_3 + b*(EYB_4 + b*(EYB_5 + b*(EYB_6 + EYB_7*b))))));
            const double w36 = EY0T + w25*w3 - w28*w4 + w35;
            const double w37 = -EA0B*w5 + EC0B*w8 + w36;
            const double w38 = w22*w9 + w33 - w34*w6 + w37;
            const double w39 = cos_c*w32 - sin_c*w38;
            const double w40 = EB0C*w6 + EX0C + w39;
            const double w41 = -w12*w19 + w17 + w18*w6 + w40;
            const double w42 = EB0Z*w7 + w41;
            const double w43 = -w12*w16 + w14 + w15*w7 + w42;
            const double w44 = -EC0Y*w13 + w43;
            const double w45 = x*(EYX_1 + x*(EYX_2 + x*(EYX_3 + x*(EYX_4 + x*(EYX_5 + x*(EYX_6 + EYX_7*x))))));
            const double w46 = x*(EAX_1 + x*(EAX_2 + x*(EAX_3 + x*(EAX_4 + x*(EAX_5 + x*(EAX_6 + EAX_7*x))))));
            const double w47 = cos_c*w9 - sin_c*w11;
            const double w48 = y*(EYY_1 + y*(EYY_2 + y*(EYY_3 + y*(EYY_4 + y*(EYY_5 + y*(EYY_6 + EYY_7*y))))));
            const double w49 = y*(EAY_1 + y*(EAY_2 + y*(EAY_3 + y*(EAY_4 + y*(EAY_5 + y*(EAY_6 + EAY_7*y))))));
            const double w50 = z*(EYZ_1 + z*(EYZ_2 + z*(EYZ_3 + z*(EYZ_4 + z*(EYZ_5 + z*(EYZ_6 + EYZ_7*z))))));
            const double w51 = z*(EAZ_1 + z*(EAZ_2 + z*(EAZ_3 + z*(EAZ_4 + z*(EAZ_5 + z*(EAZ_6 + EAZ_7*z))))));
            const double w52 = cos_c*w38 + sin_c*w32;
            const double w53 = -EA0C*w6 + EY0C + w52;
            const double w54 = w19*w47 + w50 - w51*w6 + w53;
            const double w55 = -EA0Z*w7 + w54;
            const double w56 = w16*w47 + w48 - w49*w7 + w55;
            const double w57 = EC0Y*w47 + w56;
            const double w58 = x*(EZX_1 + x*(EZX_2 + x*(EZX_3 + x*(EZX_4 + x*(EZX_5 + x*(EZX_6 + EZX_7*x))))));
            const double w59 = y*(EZY_1 + y*(EZY_2 + y*(EZY_3 + y*(EZY_4 + y*(EZY_5 + y*(EZY_6 + EZY_7*y))))));
            const double w60 = z*(EZZ_1 + z*(EZZ_2 + z*(EZZ_3 + z*(EZZ_4 + z*(EZZ_5 + z*(EZZ_6 + EZZ_7*z))))));
            const double w61 = c*(EZC_1 + c*(EZC_2 + c*(EZC_3 + c*(EZC_4 + c*(EZC_5 + c*(EZC_6 + EZC_7*c))))));
            const double w62 = cos_b*w29 - sin_b*w26;
            const double w63 = EA0B*w10 + EZ0B + w62;
            const double w64 = w11*w34 - w21*w9 + w61 + w63;
            const double w65 = EA0C*w12 - EB0C*w47 + w64;
            const double w66 = w12*w51 - w18*w47 + w60 + w65;
            const double w67 = EA0Z*w12 - EB0Z*w47 + w66;
            const double w68 = w12*w49 - w15*w47 + w59 + w67;
            deviation[0 * stride + i] = w0 + w1*w7 - w13*w2 + w44;
            deviation[1 * stride + i] = w2*w47 + w45 - w46*w7 + w57;
            deviation[2 * stride + i] = -w1*w47 + w13*w46 + w58 + w68;
        }
    }
}

/*
 * Positioning error of a ball bar between a tool ball and a workpiece ball, exact.
 * Source: Eqs. (5), (6). Operations: 210 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 20 values, mm, rad; home positions and location errors (q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z
 *     EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T EZ0T)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * in ball: 3 rows of stride, mm; point in the workpiece frame (bx by bz)
 * in length: 1 rows of stride, mm; ideal length of the ball bar (length)
 * out error: 4 rows of stride, mm; positioning error E, then its components E_x, E_y, E_z (e ex ey ez)
 */
void headhead_mill_ballbar_error(
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
            const double w56 = EBX*w48 - ECX*w54 + EXX + w55;
            const double w57 = w32 + w55;
            const double w58 = -EAX*w48 + ECX*w57 + EYX + w53;
            const double w59 = EAX*w54 - EBX*w57 + EZX + w47;
            const double w60 = w32 + x;
            const double w61 = -bx + w60;
            const double w62 = -by + w49;
            const double w63 = -bz + w4;
            const double w64 = w56 + w61;
            const double w65 = w58 + w62;
            const double w66 = w59 + w63;
            const double w67 = sqrt((w61*w61) + (w62*w62) + (w63*w63));
            const double w68 = sqrt((w64*w64) + (w65*w65) + (w66*w66));
            const double e = -length_ + w67 + (w56*(w61 + w64) + w58*(w62 + w65) + w59*(w63 + w66))/(w67 + w68);
            const double w69 = e/w68;
            error[0 * stride + i] = e;
            error[1 * stride + i] = w64*w69;
            error[2 * stride + i] = w65*w69;
            error[3 * stride + i] = w66*w69;
        }
    }
}

/*
 * Moves of the linear axes that displace the ideal tool point by the given vector.
 * Source: Eqs. (53)-(55), inverse. Operations: 0 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in deviation: 3 rows of stride, mm; displacement of the tool point in the workpiece frame (dx dy dz)
 * out moves: 3 rows of stride, mm; moves of X Y Z (move_x move_y move_z)
 */
void headhead_mill_correction(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT deviation,
    double *TRUEAXIS_RESTRICT moves)
{
    (void)positions;
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
        const double dx = deviation[0 * stride + i];
        const double dy = deviation[1 * stride + i];
        const double dz = deviation[2 * stride + i];
        moves[0 * stride + i] = dx;
        moves[1 * stride + i] = dy;
        moves[2 * stride + i] = dz;
    }
}

/*
 * Motion equation of X: displacement of the tool point since home, to first order.
 * Source: Eqs. (7)-(11). Operations: 19 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 20 values, mm, rad; home positions and location errors (q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z
 *     EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T EZ0T)
 * in tool_point: 3 rows of stride, mm; point in the tool frame (rTx rTy rTz)
 * out displacement: 3 rows of stride, mm; tool point, displacement since home, in the bed frame (dx dy dz)
 */
void headhead_mill_motion_X(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT tool_point,
    double *TRUEAXIS_RESTRICT displacement)
{
    /* once per call */
    const double q_Bx = parameters[0];
    const double q_By = parameters[1];
    const double q_Bz = parameters[2];
    const double q_Tx = parameters[3];
    const double q_Ty = parameters[4];
    const double q_Tz = parameters[5];
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
        const double w0 = q_Bz + q_Tz + rTz;
        const double w1 = q_By + q_Ty + rTy;
        const double w2 = q_Bx + q_Tx + rTx;
        displacement[0 * stride + i] = EBX*w0 - ECX*w1 + EXX + x;
        displacement[1 * stride + i] = -EAX*w0 + ECX*w2 + EYX;
        displacement[2 * stride + i] = EAX*w1 - EBX*w2 + EZX;
    }
}

/*
 * Motion equation of Y: displacement of the tool point since home, to first order.
 * Source: Eqs. (7)-(11). Operations: 21 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 20 values, mm, rad; home positions and location errors (q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z
 *     EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T EZ0T)
 * in tool_point: 3 rows of stride, mm; point in the tool frame (rTx rTy rTz)
 * out displacement: 3 rows of stride, mm; tool point, displacement since home, in the bed frame (dx dy dz)
 */
void headhead_mill_motion_Y(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT tool_point,
    double *TRUEAXIS_RESTRICT displacement)
{
    /* once per call */
    const double q_Bx = parameters[0];
    const double q_By = parameters[1];
    const double q_Bz = parameters[2];
    const double q_Tx = parameters[3];
    const double q_Ty = parameters[4];
    const double q_Tz = parameters[5];
    const double EC0Y = parameters[6];
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
        const double rTx = tool_point[0 * stride + i];
        const double rTy = tool_point[1 * stride + i];
        const double rTz = tool_point[2 * stride + i];
        const double w0 = q_Bz + q_Tz + rTz;
        const double w1 = q_By + q_Ty + rTy;
        const double w2 = q_Bx + q_Tx + rTx;
        displacement[0 * stride + i] = EBY*w0 - EC0Y*y - ECY*w1 + EXY;
        displacement[1 * stride + i] = -EAY*w0 + ECY*w2 + EYY + y;
        displacement[2 * stride + i] = EAY*w1 - EBY*w2 + EZY;
    }
}

/*
 * Motion equation of Z: displacement of the tool point since home, to first order.
 * Source: Eqs. (7)-(11). Operations: 23 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 20 values, mm, rad; home positions and location errors (q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z
 *     EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T EZ0T)
 * in tool_point: 3 rows of stride, mm; point in the tool frame (rTx rTy rTz)
 * out displacement: 3 rows of stride, mm; tool point, displacement since home, in the bed frame (dx dy dz)
 */
void headhead_mill_motion_Z(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT tool_point,
    double *TRUEAXIS_RESTRICT displacement)
{
    /* once per call */
    const double q_Bx = parameters[0];
    const double q_By = parameters[1];
    const double q_Bz = parameters[2];
    const double q_Tx = parameters[3];
    const double q_Ty = parameters[4];
    const double q_Tz = parameters[5];
    const double EA0Z = parameters[7];
    const double EB0Z = parameters[8];
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
        const double w0 = q_Bz + q_Tz + rTz;
        const double w1 = q_By + q_Ty + rTy;
        const double w2 = q_Bx + q_Tx + rTx;
        displacement[0 * stride + i] = EB0Z*z + EBZ*w0 - ECZ*w1 + EXZ;
        displacement[1 * stride + i] = -EA0Z*z - EAZ*w0 + ECZ*w2 + EYZ;
        displacement[2 * stride + i] = EAZ*w1 - EBZ*w2 + EZZ + z;
    }
}

/*
 * Motion equation of B: displacement of the tool point since home, to first order.
 * Source: Eqs. (7)-(11). Operations: 89 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 20 values, mm, rad; home positions and location errors (q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z
 *     EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T EZ0T)
 * in tool_point: 3 rows of stride, mm; point in the tool frame (rTx rTy rTz)
 * out displacement: 3 rows of stride, mm; tool point, displacement since home, in the bed frame (dx dy dz)
 */
void headhead_mill_motion_B(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT tool_point,
    double *TRUEAXIS_RESTRICT displacement)
{
    /* once per call */
    const double q_Tx = parameters[3];
    const double q_Ty = parameters[4];
    const double q_Tz = parameters[5];
    const double EC0Y = parameters[6];
    const double EA0Z = parameters[7];
    const double EB0Z = parameters[8];
    const double EA0C = parameters[11];
    const double EB0C = parameters[12];
    const double EA0B = parameters[15];
    const double EC0B = parameters[16];
    const double EX0T = parameters[17];
    const double EZ0T = parameters[19];
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
            const double w0 = q_Ty*sin_b + rTy*sin_b;
            const double w1 = q_Tx*sin_b;
            const double w2 = rTx*sin_b;
            const double w3 = q_Tz + rTz;
            const double w4 = -cos_b*q_Tz - cos_b*rTz + w1 + w2 + w3;
            const double w5 = -w4;
            const double w6 = cos_b*q_Tz + cos_b*rTz - w1 - w2;
            const double w7 = cos_b*q_Ty + cos_b*rTy;
            const double w8 = cos_b - 1.0;
            const double w9 = cos_b*q_Tx + cos_b*rTx + q_Tz*sin_b + rTz*sin_b;
            const double w10 = -q_Tx - rTx + w9;
            const double w11 = -w10;
            displacement[0 * stride + i] = EAB*w0 + EB0C*w5 + EB0Z*w5 + EBB*w6 - ECB*w7 + EX0T*w8 + EXB*cos_b +
                EZ0T*sin_b + EZB*sin_b + w10;
            displacement[1 * stride + i] = EA0B*w4 + EA0C*w4 + EA0Z*w4 - EAB*w3 + EC0B*w10 + EC0Y*w10 + ECB*(q_Tx + rTx)
                + EYB;
            displacement[2 * stride + i] = EAB*w7 + EB0C*w11 + EB0Z*w11 - EBB*w9 + ECB*w0 - EX0T*sin_b - EXB*sin_b +
                EZ0T*w8 + EZB*cos_b - q_Tz - rTz + w6;
        }
    }
}

/*
 * Motion equation of C: displacement of the tool point since home, to first order.
 * Source: Eqs. (7)-(11). Operations: 118 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 20 values, mm, rad; home positions and location errors (q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z
 *     EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T EZ0T)
 * in tool_point: 3 rows of stride, mm; point in the tool frame (rTx rTy rTz)
 * out displacement: 3 rows of stride, mm; tool point, displacement since home, in the bed frame (dx dy dz)
 */
void headhead_mill_motion_C(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT tool_point,
    double *TRUEAXIS_RESTRICT displacement)
{
    /* once per call */
    const double q_Bx = parameters[0];
    const double q_By = parameters[1];
    const double q_Bz = parameters[2];
    const double q_Tx = parameters[3];
    const double q_Ty = parameters[4];
    const double q_Tz = parameters[5];
    const double EC0Y = parameters[6];
    const double EA0Z = parameters[7];
    const double EB0Z = parameters[8];
    const double EA0C = parameters[11];
    const double EB0C = parameters[12];
    const double EX0B = parameters[13];
    const double EA0B = parameters[15];
    const double EC0B = parameters[16];
    const double EX0T = parameters[17];
    const double EY0T = parameters[18];
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
            const double rTx = tool_point[0 * stride + i];
            const double rTy = tool_point[1 * stride + i];
            const double rTz = tool_point[2 * stride + i];
            const double w0 = q_Tz*sin_c + rTz*sin_c;
            const double w1 = q_Bz*sin_c + w0;
            const double w2 = cos_c*q_Tz + cos_c*rTz;
            const double w3 = cos_c*q_Bz + w2;
            const double w4 = cos_c*q_Ty + cos_c*rTy + q_Tx*sin_c + rTx*sin_c;
            const double w5 = -q_Ty - rTy + w4;
            const double w6 = cos_c*q_By + q_Bx*sin_c;
            const double w7 = -q_By + w5 + w6;
            const double w8 = cos_c - 1.0;
            const double w9 = q_By*sin_c;
            const double w10 = q_Ty*sin_c;
            const double w11 = rTy*sin_c;
            const double w12 = cos_c*q_Bx + cos_c*q_Tx + cos_c*rTx - w10 - w11 - w9;
            const double w13 = q_Tx + rTx;
            const double w14 = -cos_c*q_Tx - cos_c*rTx + w10 + w11;
            const double w15 = q_Bx + w13;
            const double w16 = -cos_c*q_Bx + w14 + w15 + w9;
            displacement[0 * stride + i] = EA0B*w0 + EAC*w1 + EBC*w3 - EC0B*w5 - EC0Y*w7 + ECC*(-w4 - w6) + EX0B*w8 +
                EX0T*w8 + EXC*cos_c - EY0T*sin_c - EYC*sin_c - q_Bx - q_Tx - rTx + w12;
            displacement[1 * stride + i] = EA0B*(q_Tz + rTz - w2) - EAC*w3 + EBC*w1 + EC0B*(-w13 - w14) - EC0Y*w16 +
                ECC*w12 + EX0B*sin_c + EX0T*sin_c + EXC*sin_c + EY0T*w8 + EYC*cos_c + w7;
            displacement[2 * stride + i] = EA0C*w7 + EA0Z*w7 + EAC*(q_By + q_Ty + rTy) + EB0C*w16 + EB0Z*w16 - EBC*w15 +
                EZC;
        }
    }
}

/*
 * Motion equation of X and Y: displacement of the tool point since home, to first order.
 * Source: Eqs. (7)-(11). Operations: 40 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 20 values, mm, rad; home positions and location errors (q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z
 *     EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T EZ0T)
 * in tool_point: 3 rows of stride, mm; point in the tool frame (rTx rTy rTz)
 * out displacement: 3 rows of stride, mm; tool point, displacement since home, in the bed frame (dx dy dz)
 */
void headhead_mill_motion_XY(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT tool_point,
    double *TRUEAXIS_RESTRICT displacement)
{
    /* once per call */
    const double q_Bx = parameters[0];
    const double q_By = parameters[1];
    const double q_Bz = parameters[2];
    const double q_Tx = parameters[3];
    const double q_Ty = parameters[4];
    const double q_Tz = parameters[5];
    const double EC0Y = parameters[6];
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
        const double rTx = tool_point[0 * stride + i];
        const double rTy = tool_point[1 * stride + i];
        const double rTz = tool_point[2 * stride + i];
        const double w0 = q_Bz + q_Tz + rTz;
        const double w1 = q_By + q_Ty + rTy;
        const double w2 = w1 + y;
        const double w3 = q_Bx + q_Tx + rTx;
        const double w4 = -w0;
        const double w5 = -w3;
        displacement[0 * stride + i] = EBX*w0 + EBY*w0 - EC0Y*y - ECX*w2 - ECY*w1 + EXX + EXY + x;
        displacement[1 * stride + i] = EAX*w4 + EAY*w4 + ECX*w3 + ECY*w3 + EYX + EYY + y;
        displacement[2 * stride + i] = EAX*w2 + EAY*w1 + EBX*w5 + EBY*w5 + EZX + EZY;
    }
}

/*
 * Motion equation of X and Z: displacement of the tool point since home, to first order.
 * Source: Eqs. (7)-(11). Operations: 42 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 20 values, mm, rad; home positions and location errors (q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z
 *     EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T EZ0T)
 * in tool_point: 3 rows of stride, mm; point in the tool frame (rTx rTy rTz)
 * out displacement: 3 rows of stride, mm; tool point, displacement since home, in the bed frame (dx dy dz)
 */
void headhead_mill_motion_XZ(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT tool_point,
    double *TRUEAXIS_RESTRICT displacement)
{
    /* once per call */
    const double q_Bx = parameters[0];
    const double q_By = parameters[1];
    const double q_Bz = parameters[2];
    const double q_Tx = parameters[3];
    const double q_Ty = parameters[4];
    const double q_Tz = parameters[5];
    const double EA0Z = parameters[7];
    const double EB0Z = parameters[8];
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
        const double w0 = q_Bz + q_Tz + rTz;
        const double w1 = w0 + z;
        const double w2 = q_By + q_Ty + rTy;
        const double w3 = -w2;
        const double w4 = q_Bx + q_Tx + rTx;
        const double w5 = -w4;
        displacement[0 * stride + i] = EB0Z*z + EBX*w1 + EBZ*w0 + ECX*w3 + ECZ*w3 + EXX + EXZ + x;
        displacement[1 * stride + i] = -EA0Z*z - EAX*w1 - EAZ*w0 + ECX*w4 + ECZ*w4 + EYX + EYZ;
        displacement[2 * stride + i] = EAX*w2 + EAZ*w2 + EBX*w5 + EBZ*w5 + EZX + EZZ + z;
    }
}

/*
 * Motion equation of Y and Z: displacement of the tool point since home, to first order.
 * Source: Eqs. (7)-(11). Operations: 44 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 20 values, mm, rad; home positions and location errors (q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z
 *     EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T EZ0T)
 * in tool_point: 3 rows of stride, mm; point in the tool frame (rTx rTy rTz)
 * out displacement: 3 rows of stride, mm; tool point, displacement since home, in the bed frame (dx dy dz)
 */
void headhead_mill_motion_YZ(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT tool_point,
    double *TRUEAXIS_RESTRICT displacement)
{
    /* once per call */
    const double q_Bx = parameters[0];
    const double q_By = parameters[1];
    const double q_Bz = parameters[2];
    const double q_Tx = parameters[3];
    const double q_Ty = parameters[4];
    const double q_Tz = parameters[5];
    const double EC0Y = parameters[6];
    const double EA0Z = parameters[7];
    const double EB0Z = parameters[8];
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
        const double rTx = tool_point[0 * stride + i];
        const double rTy = tool_point[1 * stride + i];
        const double rTz = tool_point[2 * stride + i];
        const double w0 = q_Bz + q_Tz + rTz;
        const double w1 = w0 + z;
        const double w2 = q_By + q_Ty + rTy;
        const double w3 = -w2;
        const double w4 = q_Bx + q_Tx + rTx;
        const double w5 = -w4;
        displacement[0 * stride + i] = EB0Z*z + EBY*w1 + EBZ*w0 - EC0Y*y + ECY*w3 + ECZ*w3 + EXY + EXZ;
        displacement[1 * stride + i] = -EA0Z*z - EAY*w1 - EAZ*w0 + ECY*w4 + ECZ*w4 + EYY + EYZ + y;
        displacement[2 * stride + i] = EAY*w2 + EAZ*w2 + EBY*w5 + EBZ*w5 + EZY + EZZ + z;
    }
}
