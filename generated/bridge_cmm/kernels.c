/* Generated from machines/bridge_cmm.toml, do not edit; regenerate with: trueaxis derive machines/bridge_cmm.toml
 * SPDX-License-Identifier: MIT
 * Kernels of Bridge coordinate measuring machine: geometric error model in C17.
 * Spec: sha256 316443eb7e27d6b078d5a40b3776dd9c4bae13a4f2e33b47e425a6d867458069
 *
 * Row k of an array that has a value per point holds point i at [k * stride + i]; n <= stride points are computed.
 * Arrays must not overlap. Lengths mm, angles rad.
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

int bridge_cmm_kernel_abi(void)
{
    return TRUEAXIS_KERNEL_ABI;
}

const char *bridge_cmm_spec_hash(void)
{
    return "316443eb7e27d6b078d5a40b3776dd9c4bae13a4f2e33b47e425a6d867458069";
}

/*
 * Ideal position of a tool point in the workpiece frame.
 * Source: Eqs. (1)-(4) without errors. Operations: 6 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in parameters: 6 values, mm, rad; home positions and location errors (q_Px q_Py q_Pz EC0X EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out ideal: 3 rows of stride, mm; tool point in the workpiece frame, without errors (px py pz)
 */
void bridge_cmm_tool_in_workpiece_ideal(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT ideal)
{
    /* once per call */
    const double q_Px = parameters[0];
    const double q_Py = parameters[1];
    const double q_Pz = parameters[2];
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
        const double x = positions[0 * stride + i];
        const double y = positions[1 * stride + i];
        const double z = positions[2 * stride + i];
        const double rx = point[0 * stride + i];
        const double ry = point[1 * stride + i];
        const double rz = point[2 * stride + i];
        ideal[0 * stride + i] = q_Px + rx + x;
        ideal[1 * stride + i] = q_Py + ry + y;
        ideal[2 * stride + i] = q_Pz + rz + z;
    }
}

/*
 * Deviation of a tool point in the workpiece frame, exact.
 * Source: Eqs. (1)-(4). Operations: 70 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 6 values, mm, rad; home positions and location errors (q_Px q_Py q_Pz EC0X EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; tool point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void bridge_cmm_tool_in_workpiece_deviation(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation)
{
    /* once per call */
    const double q_Px = parameters[0];
    const double q_Py = parameters[1];
    const double q_Pz = parameters[2];
    const double EC0X = parameters[3];
    const double EA0Z = parameters[4];
    const double EB0Z = parameters[5];
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
        const double rx = point[0 * stride + i];
        const double ry = point[1 * stride + i];
        const double rz = point[2 * stride + i];
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
        deviation[0 * stride + i] = EBY*w14 - ECY*w20 + EXY + w21;
        deviation[1 * stride + i] = -EAY*w14 + ECY*w22 + EYY + w19;
        deviation[2 * stride + i] = EAY*w20 - EBY*w22 + EZY + w13;
    }
}

/*
 * Deviation of a tool point in the workpiece frame, to first order in the errors.
 * Source: Eqs. (1)-(4). Operations: 59 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 6 values, mm, rad; home positions and location errors (q_Px q_Py q_Pz EC0X EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; tool point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void bridge_cmm_tool_in_workpiece_deviation_first_order(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation)
{
    /* once per call */
    const double q_Px = parameters[0];
    const double q_Py = parameters[1];
    const double q_Pz = parameters[2];
    const double EC0X = parameters[3];
    const double EA0Z = parameters[4];
    const double EB0Z = parameters[5];
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
        const double rx = point[0 * stride + i];
        const double ry = point[1 * stride + i];
        const double rz = point[2 * stride + i];
        const double w0 = q_Py + ry;
        const double w1 = q_Pz + rz;
        const double w2 = w1 + z;
        const double w3 = EBZ*w1 - ECZ*w0 + EXZ;
        const double w4 = EB0Z*w2 + w3;
        const double w5 = EBX*w2 - ECX*w0 + EXX + w4;
        const double w6 = -EC0X*w0 + w5;
        const double w7 = q_Px + rx;
        const double w8 = w7 + x;
        const double w9 = -EAZ*w1 + ECZ*w7 + EYZ;
        const double w10 = -EA0Z*w2 + w9;
        const double w11 = -EAX*w2 + ECX*w7 + EYX + w10;
        const double w12 = EC0X*w8 + w11;
        const double w13 = EAZ*w0 - EBZ*w7 + EZZ;
        const double w14 = EA0Z*w0 - EB0Z*w7 + w13;
        const double w15 = EAX*w0 - EBX*w7 + EZX + w14;
        deviation[0 * stride + i] = EBY*w2 - ECY*w0 + EXY + w6;
        deviation[1 * stride + i] = -EAY*w2 + ECY*w8 + EYY + w12;
        deviation[2 * stride + i] = EAY*w0 - EBY*w8 + EZY + w15;
    }
}

/*
 * Sensitivity of a tool point in the workpiece frame to every error, at the error-free machine.
 * Source: Eqs. (1)-(4), first order. Operations: 10 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in parameters: 6 values, mm, rad; home positions and location errors (q_Px q_Py q_Pz EC0X EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out sensitivity: 63 rows of stride, mm/mm, mm/rad; derivative of the deviation by each component error, then by each
 *     location error (dx_EXX dx_EYX .. dz_EB0Z, last index fastest)
 */
void bridge_cmm_tool_in_workpiece_sensitivity(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT sensitivity)
{
    /* once per call */
    const double q_Px = parameters[0];
    const double q_Py = parameters[1];
    const double q_Pz = parameters[2];
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
        const double x = positions[0 * stride + i];
        const double z = positions[2 * stride + i];
        const double rx = point[0 * stride + i];
        const double ry = point[1 * stride + i];
        const double rz = point[2 * stride + i];
        const double dx_EBZ = q_Pz + rz;
        const double dx_EBX = dx_EBZ + z;
        const double dz_EAX = q_Py + ry;
        const double dx_ECX = -dz_EAX;
        const double dy_EAX = -dx_EBX;
        const double dy_ECX = q_Px + rx;
        const double dy_ECY = dy_ECX + x;
        const double dz_EBX = -dy_ECX;
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
        sensitivity[11 * stride + i] = dx_ECX;
        sensitivity[12 * stride + i] = 1.0;
        sensitivity[13 * stride + i] = 0.0;
        sensitivity[14 * stride + i] = 0.0;
        sensitivity[15 * stride + i] = 0.0;
        sensitivity[16 * stride + i] = dx_EBZ;
        sensitivity[17 * stride + i] = dx_ECX;
        sensitivity[18 * stride + i] = dx_ECX;
        sensitivity[19 * stride + i] = 0.0;
        sensitivity[20 * stride + i] = dx_EBX;
        sensitivity[21 * stride + i] = 0.0;
        sensitivity[22 * stride + i] = 1.0;
        sensitivity[23 * stride + i] = 0.0;
        sensitivity[24 * stride + i] = dy_EAX;
        sensitivity[25 * stride + i] = 0.0;
        sensitivity[26 * stride + i] = dy_ECX;
        sensitivity[27 * stride + i] = 0.0;
        sensitivity[28 * stride + i] = 1.0;
        sensitivity[29 * stride + i] = 0.0;
        sensitivity[30 * stride + i] = dy_EAX;
        sensitivity[31 * stride + i] = 0.0;
        sensitivity[32 * stride + i] = dy_ECY;
        sensitivity[33 * stride + i] = 0.0;
        sensitivity[34 * stride + i] = 1.0;
        sensitivity[35 * stride + i] = 0.0;
        sensitivity[36 * stride + i] = -dx_EBZ;
        sensitivity[37 * stride + i] = 0.0;
        sensitivity[38 * stride + i] = dy_ECX;
        sensitivity[39 * stride + i] = dy_ECY;
        sensitivity[40 * stride + i] = dy_EAX;
        sensitivity[41 * stride + i] = 0.0;
        sensitivity[42 * stride + i] = 0.0;
        sensitivity[43 * stride + i] = 0.0;
        sensitivity[44 * stride + i] = 1.0;
        sensitivity[45 * stride + i] = dz_EAX;
        sensitivity[46 * stride + i] = dz_EBX;
        sensitivity[47 * stride + i] = 0.0;
        sensitivity[48 * stride + i] = 0.0;
        sensitivity[49 * stride + i] = 0.0;
        sensitivity[50 * stride + i] = 1.0;
        sensitivity[51 * stride + i] = dz_EAX;
        sensitivity[52 * stride + i] = -dy_ECY;
        sensitivity[53 * stride + i] = 0.0;
        sensitivity[54 * stride + i] = 0.0;
        sensitivity[55 * stride + i] = 0.0;
        sensitivity[56 * stride + i] = 1.0;
        sensitivity[57 * stride + i] = dz_EAX;
        sensitivity[58 * stride + i] = dz_EBX;
        sensitivity[59 * stride + i] = 0.0;
        sensitivity[60 * stride + i] = 0.0;
        sensitivity[61 * stride + i] = dz_EAX;
        sensitivity[62 * stride + i] = dz_EBX;
    }
}

/*
 * Ideal position of a tool point in the bed frame.
 * Source: Eqs. (1)-(4) without errors. Operations: 6 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in parameters: 6 values, mm, rad; home positions and location errors (q_Px q_Py q_Pz EC0X EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out ideal: 3 rows of stride, mm; tool point in the bed frame, without errors (px py pz)
 */
void bridge_cmm_tool_in_bed_ideal(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT ideal)
{
    /* once per call */
    const double q_Px = parameters[0];
    const double q_Py = parameters[1];
    const double q_Pz = parameters[2];
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
        const double x = positions[0 * stride + i];
        const double y = positions[1 * stride + i];
        const double z = positions[2 * stride + i];
        const double rx = point[0 * stride + i];
        const double ry = point[1 * stride + i];
        const double rz = point[2 * stride + i];
        ideal[0 * stride + i] = q_Px + rx + x;
        ideal[1 * stride + i] = q_Py + ry + y;
        ideal[2 * stride + i] = q_Pz + rz + z;
    }
}

/*
 * Deviation of a tool point in the bed frame, exact.
 * Source: Eqs. (1)-(4). Operations: 70 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 6 values, mm, rad; home positions and location errors (q_Px q_Py q_Pz EC0X EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; tool point in the bed frame, actual minus ideal (dx dy dz)
 */
void bridge_cmm_tool_in_bed_deviation(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation)
{
    /* once per call */
    const double q_Px = parameters[0];
    const double q_Py = parameters[1];
    const double q_Pz = parameters[2];
    const double EC0X = parameters[3];
    const double EA0Z = parameters[4];
    const double EB0Z = parameters[5];
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
        const double rx = point[0 * stride + i];
        const double ry = point[1 * stride + i];
        const double rz = point[2 * stride + i];
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
        deviation[0 * stride + i] = EBY*w14 - ECY*w20 + EXY + w21;
        deviation[1 * stride + i] = -EAY*w14 + ECY*w22 + EYY + w19;
        deviation[2 * stride + i] = EAY*w20 - EBY*w22 + EZY + w13;
    }
}

/*
 * Deviation of a tool point in the bed frame, to first order in the errors.
 * Source: Eqs. (1)-(4). Operations: 59 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 6 values, mm, rad; home positions and location errors (q_Px q_Py q_Pz EC0X EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; tool point in the bed frame, actual minus ideal (dx dy dz)
 */
void bridge_cmm_tool_in_bed_deviation_first_order(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation)
{
    /* once per call */
    const double q_Px = parameters[0];
    const double q_Py = parameters[1];
    const double q_Pz = parameters[2];
    const double EC0X = parameters[3];
    const double EA0Z = parameters[4];
    const double EB0Z = parameters[5];
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
        const double rx = point[0 * stride + i];
        const double ry = point[1 * stride + i];
        const double rz = point[2 * stride + i];
        const double w0 = q_Py + ry;
        const double w1 = q_Pz + rz;
        const double w2 = w1 + z;
        const double w3 = EBZ*w1 - ECZ*w0 + EXZ;
        const double w4 = EB0Z*w2 + w3;
        const double w5 = EBX*w2 - ECX*w0 + EXX + w4;
        const double w6 = -EC0X*w0 + w5;
        const double w7 = q_Px + rx;
        const double w8 = w7 + x;
        const double w9 = -EAZ*w1 + ECZ*w7 + EYZ;
        const double w10 = -EA0Z*w2 + w9;
        const double w11 = -EAX*w2 + ECX*w7 + EYX + w10;
        const double w12 = EC0X*w8 + w11;
        const double w13 = EAZ*w0 - EBZ*w7 + EZZ;
        const double w14 = EA0Z*w0 - EB0Z*w7 + w13;
        const double w15 = EAX*w0 - EBX*w7 + EZX + w14;
        deviation[0 * stride + i] = EBY*w2 - ECY*w0 + EXY + w6;
        deviation[1 * stride + i] = -EAY*w2 + ECY*w8 + EYY + w12;
        deviation[2 * stride + i] = EAY*w0 - EBY*w8 + EZY + w15;
    }
}

/*
 * Sensitivity of a tool point in the bed frame to every error, at the error-free machine.
 * Source: Eqs. (1)-(4), first order. Operations: 10 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in parameters: 6 values, mm, rad; home positions and location errors (q_Px q_Py q_Pz EC0X EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out sensitivity: 63 rows of stride, mm/mm, mm/rad; derivative of the deviation by each component error, then by each
 *     location error (dx_EXX dx_EYX .. dz_EB0Z, last index fastest)
 */
void bridge_cmm_tool_in_bed_sensitivity(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT sensitivity)
{
    /* once per call */
    const double q_Px = parameters[0];
    const double q_Py = parameters[1];
    const double q_Pz = parameters[2];
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
        const double x = positions[0 * stride + i];
        const double z = positions[2 * stride + i];
        const double rx = point[0 * stride + i];
        const double ry = point[1 * stride + i];
        const double rz = point[2 * stride + i];
        const double dx_EBZ = q_Pz + rz;
        const double dx_EBX = dx_EBZ + z;
        const double dz_EAX = q_Py + ry;
        const double dx_ECX = -dz_EAX;
        const double dy_EAX = -dx_EBX;
        const double dy_ECX = q_Px + rx;
        const double dy_ECY = dy_ECX + x;
        const double dz_EBX = -dy_ECX;
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
        sensitivity[11 * stride + i] = dx_ECX;
        sensitivity[12 * stride + i] = 1.0;
        sensitivity[13 * stride + i] = 0.0;
        sensitivity[14 * stride + i] = 0.0;
        sensitivity[15 * stride + i] = 0.0;
        sensitivity[16 * stride + i] = dx_EBZ;
        sensitivity[17 * stride + i] = dx_ECX;
        sensitivity[18 * stride + i] = dx_ECX;
        sensitivity[19 * stride + i] = 0.0;
        sensitivity[20 * stride + i] = dx_EBX;
        sensitivity[21 * stride + i] = 0.0;
        sensitivity[22 * stride + i] = 1.0;
        sensitivity[23 * stride + i] = 0.0;
        sensitivity[24 * stride + i] = dy_EAX;
        sensitivity[25 * stride + i] = 0.0;
        sensitivity[26 * stride + i] = dy_ECX;
        sensitivity[27 * stride + i] = 0.0;
        sensitivity[28 * stride + i] = 1.0;
        sensitivity[29 * stride + i] = 0.0;
        sensitivity[30 * stride + i] = dy_EAX;
        sensitivity[31 * stride + i] = 0.0;
        sensitivity[32 * stride + i] = dy_ECY;
        sensitivity[33 * stride + i] = 0.0;
        sensitivity[34 * stride + i] = 1.0;
        sensitivity[35 * stride + i] = 0.0;
        sensitivity[36 * stride + i] = -dx_EBZ;
        sensitivity[37 * stride + i] = 0.0;
        sensitivity[38 * stride + i] = dy_ECX;
        sensitivity[39 * stride + i] = dy_ECY;
        sensitivity[40 * stride + i] = dy_EAX;
        sensitivity[41 * stride + i] = 0.0;
        sensitivity[42 * stride + i] = 0.0;
        sensitivity[43 * stride + i] = 0.0;
        sensitivity[44 * stride + i] = 1.0;
        sensitivity[45 * stride + i] = dz_EAX;
        sensitivity[46 * stride + i] = dz_EBX;
        sensitivity[47 * stride + i] = 0.0;
        sensitivity[48 * stride + i] = 0.0;
        sensitivity[49 * stride + i] = 0.0;
        sensitivity[50 * stride + i] = 1.0;
        sensitivity[51 * stride + i] = dz_EAX;
        sensitivity[52 * stride + i] = -dy_ECY;
        sensitivity[53 * stride + i] = 0.0;
        sensitivity[54 * stride + i] = 0.0;
        sensitivity[55 * stride + i] = 0.0;
        sensitivity[56 * stride + i] = 1.0;
        sensitivity[57 * stride + i] = dz_EAX;
        sensitivity[58 * stride + i] = dz_EBX;
        sensitivity[59 * stride + i] = 0.0;
        sensitivity[60 * stride + i] = 0.0;
        sensitivity[61 * stride + i] = dz_EAX;
        sensitivity[62 * stride + i] = dz_EBX;
    }
}

/*
 * Ideal position of a workpiece point in the bed frame.
 * Source: Eqs. (1)-(4) without errors. Operations: 0 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in parameters: 6 values, mm, rad; home positions and location errors (q_Px q_Py q_Pz EC0X EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the workpiece frame (rx ry rz)
 * out ideal: 3 rows of stride, mm; workpiece point in the bed frame, without errors (px py pz)
 */
void bridge_cmm_workpiece_in_bed_ideal(
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
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 6 values, mm, rad; home positions and location errors (q_Px q_Py q_Pz EC0X EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the workpiece frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; workpiece point in the bed frame, actual minus ideal (dx dy dz)
 */
void bridge_cmm_workpiece_in_bed_deviation(
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
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
        deviation[0 * stride + i] = 0.0;
        deviation[1 * stride + i] = 0.0;
        deviation[2 * stride + i] = 0.0;
    }
}

/*
 * Deviation of a workpiece point in the bed frame, to first order in the errors.
 * Source: Eqs. (1)-(4). Operations: 0 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 6 values, mm, rad; home positions and location errors (q_Px q_Py q_Pz EC0X EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the workpiece frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; workpiece point in the bed frame, actual minus ideal (dx dy dz)
 */
void bridge_cmm_workpiece_in_bed_deviation_first_order(
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
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
        deviation[0 * stride + i] = 0.0;
        deviation[1 * stride + i] = 0.0;
        deviation[2 * stride + i] = 0.0;
    }
}

/*
 * Sensitivity of a workpiece point in the bed frame to every error, at the error-free machine.
 * Source: Eqs. (1)-(4), first order. Operations: 0 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in parameters: 6 values, mm, rad; home positions and location errors (q_Px q_Py q_Pz EC0X EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the workpiece frame (rx ry rz)
 * out sensitivity: 63 rows of stride, mm/mm, mm/rad; derivative of the deviation by each component error, then by each
 *     location error (dx_EXX dx_EYX .. dz_EB0Z, last index fastest)
 */
void bridge_cmm_workpiece_in_bed_sensitivity(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT sensitivity)
{
    (void)positions;
    (void)parameters;
    (void)point;
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
        sensitivity[0 * stride + i] = 0.0;
        sensitivity[1 * stride + i] = 0.0;
        sensitivity[2 * stride + i] = 0.0;
        sensitivity[3 * stride + i] = 0.0;
        sensitivity[4 * stride + i] = 0.0;
        sensitivity[5 * stride + i] = 0.0;
        sensitivity[6 * stride + i] = 0.0;
        sensitivity[7 * stride + i] = 0.0;
        sensitivity[8 * stride + i] = 0.0;
        sensitivity[9 * stride + i] = 0.0;
        sensitivity[10 * stride + i] = 0.0;
        sensitivity[11 * stride + i] = 0.0;
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
        sensitivity[40 * stride + i] = 0.0;
        sensitivity[41 * stride + i] = 0.0;
        sensitivity[42 * stride + i] = 0.0;
        sensitivity[43 * stride + i] = 0.0;
        sensitivity[44 * stride + i] = 0.0;
        sensitivity[45 * stride + i] = 0.0;
        sensitivity[46 * stride + i] = 0.0;
        sensitivity[47 * stride + i] = 0.0;
        sensitivity[48 * stride + i] = 0.0;
        sensitivity[49 * stride + i] = 0.0;
        sensitivity[50 * stride + i] = 0.0;
        sensitivity[51 * stride + i] = 0.0;
        sensitivity[52 * stride + i] = 0.0;
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
    }
}

/*
 * Ideal position of a bed point in the workpiece frame.
 * Source: Eqs. (1)-(4) without errors. Operations: 0 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in parameters: 6 values, mm, rad; home positions and location errors (q_Px q_Py q_Pz EC0X EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the bed frame (rx ry rz)
 * out ideal: 3 rows of stride, mm; bed point in the workpiece frame, without errors (px py pz)
 */
void bridge_cmm_bed_in_workpiece_ideal(
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
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 6 values, mm, rad; home positions and location errors (q_Px q_Py q_Pz EC0X EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the bed frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; bed point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void bridge_cmm_bed_in_workpiece_deviation(
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
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
        deviation[0 * stride + i] = 0.0;
        deviation[1 * stride + i] = 0.0;
        deviation[2 * stride + i] = 0.0;
    }
}

/*
 * Deviation of a bed point in the workpiece frame, to first order in the errors.
 * Source: Eqs. (1)-(4). Operations: 0 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 6 values, mm, rad; home positions and location errors (q_Px q_Py q_Pz EC0X EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the bed frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; bed point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void bridge_cmm_bed_in_workpiece_deviation_first_order(
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
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
        deviation[0 * stride + i] = 0.0;
        deviation[1 * stride + i] = 0.0;
        deviation[2 * stride + i] = 0.0;
    }
}

/*
 * Sensitivity of a bed point in the workpiece frame to every error, at the error-free machine.
 * Source: Eqs. (1)-(4), first order. Operations: 0 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in parameters: 6 values, mm, rad; home positions and location errors (q_Px q_Py q_Pz EC0X EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the bed frame (rx ry rz)
 * out sensitivity: 63 rows of stride, mm/mm, mm/rad; derivative of the deviation by each component error, then by each
 *     location error (dx_EXX dx_EYX .. dz_EB0Z, last index fastest)
 */
void bridge_cmm_bed_in_workpiece_sensitivity(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT sensitivity)
{
    (void)positions;
    (void)parameters;
    (void)point;
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
        sensitivity[0 * stride + i] = 0.0;
        sensitivity[1 * stride + i] = 0.0;
        sensitivity[2 * stride + i] = 0.0;
        sensitivity[3 * stride + i] = 0.0;
        sensitivity[4 * stride + i] = 0.0;
        sensitivity[5 * stride + i] = 0.0;
        sensitivity[6 * stride + i] = 0.0;
        sensitivity[7 * stride + i] = 0.0;
        sensitivity[8 * stride + i] = 0.0;
        sensitivity[9 * stride + i] = 0.0;
        sensitivity[10 * stride + i] = 0.0;
        sensitivity[11 * stride + i] = 0.0;
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
        sensitivity[40 * stride + i] = 0.0;
        sensitivity[41 * stride + i] = 0.0;
        sensitivity[42 * stride + i] = 0.0;
        sensitivity[43 * stride + i] = 0.0;
        sensitivity[44 * stride + i] = 0.0;
        sensitivity[45 * stride + i] = 0.0;
        sensitivity[46 * stride + i] = 0.0;
        sensitivity[47 * stride + i] = 0.0;
        sensitivity[48 * stride + i] = 0.0;
        sensitivity[49 * stride + i] = 0.0;
        sensitivity[50 * stride + i] = 0.0;
        sensitivity[51 * stride + i] = 0.0;
        sensitivity[52 * stride + i] = 0.0;
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
    }
}

/*
 * Actual position of the tool point in the workpiece frame, exact.
 * Source: Eq. (4). Operations: 74 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 6 values, mm, rad; home positions and location errors (q_Px q_Py q_Pz EC0X EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out position: 3 rows of stride, mm; actual position P_T^W of the tool point in the workpiece frame (px py pz)
 */
void bridge_cmm_tool_in_workpiece_position(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT position)
{
    /* once per call */
    const double q_Px = parameters[0];
    const double q_Py = parameters[1];
    const double q_Pz = parameters[2];
    const double EC0X = parameters[3];
    const double EA0Z = parameters[4];
    const double EB0Z = parameters[5];
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
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
        const double rx = point[0 * stride + i];
        const double ry = point[1 * stride + i];
        const double rz = point[2 * stride + i];
        const double w0 = q_Px + rx;
        const double w1 = w0 + x;
        const double w2 = q_Pz + rz;
        const double w3 = w2 + z;
        const double w4 = q_Py + ry;
        const double w5 = EAZ*w4 - EBZ*w0 + EZZ;
        const double w6 = w3 + w5;
        const double w7 = -EAZ*w2 + ECZ*w0 + EYZ;
        const double w8 = -EA0Z*w6 + w7;
        const double w9 = w4 + w8;
        const double w10 = EBZ*w2 - ECZ*w4 + EXZ;
        const double w11 = EB0Z*w6 + w10;
        const double w12 = w0 + w11;
        const double w13 = EA0Z*(w4 + w7) - EB0Z*(w0 + w10) + w5;
        const double w14 = EAX*w9 - EBX*w12 + EZX + w13;
        const double w15 = w14 + w3;
        const double w16 = w13 + w3;
        const double w17 = EBX*w16 - ECX*w9 + EXX + w11;
        const double w18 = -EAX*w16 + ECX*w12 + EYX + w8;
        const double w19 = EC0X*(w1 + w17) + w18;
        const double w20 = w19 + w4;
        const double w21 = -EC0X*(w18 + w4) + w17;
        const double w22 = EBY*w15 - ECY*w20 + EXY + w21;
        const double w23 = w1 + w21;
        const double w24 = -EAY*w15 + ECY*w23 + EYY + w19;
        const double w25 = w4 + y;
        const double w26 = EAY*w20 - EBY*w23 + EZY + w14;
        position[0 * stride + i] = w1 + w22;
        position[1 * stride + i] = w24 + w25;
        position[2 * stride + i] = w26 + w3;
    }
}

/*
 * Actual position of the tool point in the workpiece frame, to first order.
 * Source: Eq. (4). Operations: 63 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 6 values, mm, rad; home positions and location errors (q_Px q_Py q_Pz EC0X EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out position: 3 rows of stride, mm; actual position P_T^W of the tool point in the workpiece frame (px py pz)
 */
void bridge_cmm_tool_in_workpiece_position_first_order(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT position)
{
    /* once per call */
    const double q_Px = parameters[0];
    const double q_Py = parameters[1];
    const double q_Pz = parameters[2];
    const double EC0X = parameters[3];
    const double EA0Z = parameters[4];
    const double EB0Z = parameters[5];
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
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
        const double rx = point[0 * stride + i];
        const double ry = point[1 * stride + i];
        const double rz = point[2 * stride + i];
        const double w0 = q_Px + rx;
        const double w1 = w0 + x;
        const double w2 = q_Py + ry;
        const double w3 = q_Pz + rz;
        const double w4 = w3 + z;
        const double w5 = EBZ*w3 - ECZ*w2 + EXZ;
        const double w6 = EB0Z*w4 + w5;
        const double w7 = EBX*w4 - ECX*w2 + EXX + w6;
        const double w8 = -EC0X*w2 + w7;
        const double w9 = EBY*w4 - ECY*w2 + EXY + w8;
        const double w10 = -EAZ*w3 + ECZ*w0 + EYZ;
        const double w11 = -EA0Z*w4 + w10;
        const double w12 = -EAX*w4 + ECX*w0 + EYX + w11;
        const double w13 = EC0X*w1 + w12;
        const double w14 = -EAY*w4 + ECY*w1 + EYY + w13;
        const double w15 = w2 + y;
        const double w16 = EAZ*w2 - EBZ*w0 + EZZ;
        const double w17 = EA0Z*w2 - EB0Z*w0 + w16;
        const double w18 = EAX*w2 - EBX*w0 + EZX + w17;
        const double w19 = EAY*w2 - EBY*w1 + EZY + w18;
        position[0 * stride + i] = w1 + w9;
        position[1 * stride + i] = w14 + w15;
        position[2 * stride + i] = w19 + w4;
    }
}

/*
 * Deviation of the tool point under polynomial error curves, exact.
 * Source: Eqs. (1)-(4), (44). Operations: 301 per point, 3 once per call.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in curves: 126 values, mm/mm^k, rad/mm^k; coefficients of the powers 1 to 7 of the axis position, per component
 *     error (EXX_1 EXX_2 .. ECZ_7, last index fastest)
 * in parameters: 6 values, mm, rad; home positions and location errors (q_Px q_Py q_Pz EC0X EA0Z EB0Z)
 * in point: 3 values, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; tool point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void bridge_cmm_tool_in_workpiece_deviation_curves(
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
    const double q_Px = parameters[0];
    const double q_Py = parameters[1];
    const double q_Pz = parameters[2];
    const double EC0X = parameters[3];
    const double EA0Z = parameters[4];
    const double EB0Z = parameters[5];
    const double rx = point[0];
    const double ry = point[1];
    const double rz = point[2];
    const double w0 = q_Pz + rz;
    const double w2 = q_Py + ry;
    const double w6 = q_Px + rx;
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
        const double x = positions[0 * stride + i];
        const double y = positions[1 * stride + i];
        const double z = positions[2 * stride + i];
        const double w1 = w0 + z;
        const double w3 = z*(EZZ_1 + z*(EZZ_2 + z*(EZZ_3 + z*(EZZ_4 + z*(EZZ_5 + z*(EZZ_6 + EZZ_7*z))))));
        const double w4 = z*(EAZ_1 + z*(EAZ_2 + z*(EAZ_3 + z*(EAZ_4 + z*(EAZ_5 + z*(EAZ_6 + EAZ_7*z))))));
        const double w5 = z*(EBZ_1 + z*(EBZ_2 + z*(EBZ_3 + z*(EBZ_4 + z*(EBZ_5 + z*(EBZ_6 + EBZ_7*z))))));
        const double w7 = w2*w4 + w3 - w5*w6;
        const double w8 = w1 + w7;
        const double w9 = z*(EYZ_1 + z*(EYZ_2 + z*(EYZ_3 + z*(EYZ_4 + z*(EYZ_5 + z*(EYZ_6 + EYZ_7*z))))));
        const double w10 = z*(ECZ_1 + z*(ECZ_2 + z*(ECZ_3 + z*(ECZ_4 + z*(ECZ_5 + z*(ECZ_6 + ECZ_7*z))))));
        const double w11 = -w0*w4 + w10*w6 + w9;
        const double w12 = -EA0Z*w8 + w11;
        const double w13 = w12 + w2;
        const double w14 = z*(EXZ_1 + z*(EXZ_2 + z*(EXZ_3 + z*(EXZ_4 + z*(EXZ_5 + z*(EXZ_6 + EXZ_7*z))))));
        const double w15 = w0*w5 - w10*w2 + w14;
        const double w16 = EB0Z*w8 + w15;
        const double w17 = w16 + w6;
        const double w18 = x*(EZX_1 + x*(EZX_2 + x*(EZX_3 + x*(EZX_4 + x*(EZX_5 + x*(EZX_6 + EZX_7*x))))));
        const double w19 = x*(EAX_1 + x*(EAX_2 + x*(EAX_3 + x*(EAX_4 + x*(EAX_5 + x*(EAX_6 + EAX_7*x))))));
        const double w20 = x*(EBX_1 + x*(EBX_2 + x*(EBX_3 + x*(EBX_4 + x*(EBX_5 + x*(EBX_6 + EBX_7*x))))));
        const double w21 = EA0Z*(w11 + w2) - EB0Z*(w15 + w6) + w7;
        const double w22 = w13*w19 - w17*w20 + w18 + w21;
        const double w23 = w1 + w22;
        const double w24 = w1 + w21;
        const double w25 = x*(EXX_1 + x*(EXX_2 + x*(EXX_3 + x*(EXX_4 + x*(EXX_5 + x*(EXX_6 + EXX_7*x))))));
        const double w26 = x*(ECX_1 + x*(ECX_2 + x*(ECX_3 + x*(ECX_4 + x*(ECX_5 + x*(ECX_6 + ECX_7*x))))));
        const double w27 = -w13*w26 + w16 + w20*w24 + w25;
        const double w28 = x*(EYX_1 + x*(EYX_2 + x*(EYX_3 + x*(EYX_4 + x*(EYX_5 + x*(EYX_6 + EYX_7*x))))));
        const double w29 = w12 + w17*w26 - w19*w24 + w28;
        const double w30 = w6 + x;
        const double w31 = EC0X*(w27 + w30) + w29;
        const double w32 = w2 + w31;
        const double w33 = y*(EXY_1 + y*(EXY_2 + y*(EXY_3 + y*(EXY_4 + y*(EXY_5 + y*(EXY_6 + EXY_7*y))))));
        const double w34 = y*(EBY_1 + y*(EBY_2 + y*(EBY_3 + y*(EBY_4 + y*(EBY_5 + y*(EBY_6 + EBY_7*y))))));
        const double w35 = y*(ECY_1 + y*(ECY_2 + y*(ECY_3 + y*(ECY_4 + y*(ECY_5 + y*(ECY_6 + ECY_7*y))))));
        const double w36 = -EC0X*(w2 + w29) + w27;
        const double w37 = w30 + w36;
        const double w38 = y*(EYY_1 + y*(EYY_2 + y*(EYY_3 + y*(EYY_4 + y*(EYY_5 + y*(EYY_6 + EYY_7*y))))));
        const double w39 = y*(EAY_1 + y*(EAY_2 + y*(EAY_3 + y*(EAY_4 + y*(EAY_5 + y*(EAY_6 + EAY_7*y))))));
        const double w40 = y*(EZY_1 + y*(EZY_2 + y*(EZY_3 + y*(EZY_4 + y*(EZY_5 + y*(EZY_6 + EZY_7*y))))));
        deviation[0 * stride + i] = w23*w34 - w32*w35 + w33 + w36;
        deviation[1 * stride + i] = -w23*w39 + w31 + w35*w37 + w38;
        deviation[2 * stride + i] = w22 + w32*w39 - w34*w37 + w40;
    }
}

/*
 * Deviation of the tool point under polynomial error curves, to first order, constants folded once per call.
 * Source: Eqs. (1)-(4), (44). Operations: 206 per point, 267 once per call.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in curves: 126 values, mm/mm^k, rad/mm^k; coefficients of the powers 1 to 7 of the axis position, per component
 *     error (EXX_1 EXX_2 .. ECZ_7, last index fastest)
 * in parameters: 6 values, mm, rad; home positions and location errors (q_Px q_Py q_Pz EC0X EA0Z EB0Z)
 * in point: 3 values, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; tool point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void bridge_cmm_tool_in_workpiece_deviation_first_order_curves(
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
    const double q_Px = parameters[0];
    const double q_Py = parameters[1];
    const double q_Pz = parameters[2];
    const double EC0X = parameters[3];
    const double EA0Z = parameters[4];
    const double EB0Z = parameters[5];
    const double rx = point[0];
    const double ry = point[1];
    const double rz = point[2];
    const double w0 = q_Pz + rz;
    const double w1 = q_Py + ry;
    const double w2 = -w1;
    const double w3 = EBZ_1*w0 + ECZ_1*w2 + EXZ_1;
    const double w4 = EBZ_2*w0 + ECZ_2*w2 + EXZ_2;
    const double w5 = EBZ_3*w0 + ECZ_3*w2 + EXZ_3;
    const double w6 = EBZ_4*w0 + ECZ_4*w2 + EXZ_4;
    const double w7 = EBZ_5*w0 + ECZ_5*w2 + EXZ_5;
    const double w8 = EBZ_6*w0 + ECZ_6*w2 + EXZ_6;
    const double w9 = EBZ_7*w0 + ECZ_7*w2 + EXZ_7;
    const double w11 = EB0Z*w0 + EC0X*w2;
    const double w12 = EBX_1*w0 + ECX_1*w2 + EXX_1;
    const double w13 = EBX_2*w0 + ECX_2*w2 + EXX_2;
    const double w14 = EBX_3*w0 + ECX_3*w2 + EXX_3;
    const double w15 = EBX_4*w0 + ECX_4*w2 + EXX_4;
    const double w16 = EBX_5*w0 + ECX_5*w2 + EXX_5;
    const double w17 = EBX_6*w0 + ECX_6*w2 + EXX_6;
    const double w18 = EBX_7*w0 + ECX_7*w2 + EXX_7;
    const double w20 = EBY_1*w0 + ECY_1*w2 + EXY_1;
    const double w21 = EBY_2*w0 + ECY_2*w2 + EXY_2;
    const double w22 = EBY_3*w0 + ECY_3*w2 + EXY_3;
    const double w23 = EBY_4*w0 + ECY_4*w2 + EXY_4;
    const double w24 = EBY_5*w0 + ECY_5*w2 + EXY_5;
    const double w25 = EBY_6*w0 + ECY_6*w2 + EXY_6;
    const double w26 = EBY_7*w0 + ECY_7*w2 + EXY_7;
    const double w34 = q_Px + rx;
    const double w35 = -w0;
    const double w36 = EAZ_1*w35 + ECZ_1*w34 + EYZ_1;
    const double w37 = EAZ_2*w35 + ECZ_2*w34 + EYZ_2;
    const double w38 = EAZ_3*w35 + ECZ_3*w34 + EYZ_3;
    const double w39 = EAZ_4*w35 + ECZ_4*w34 + EYZ_4;
    const double w40 = EAZ_5*w35 + ECZ_5*w34 + EYZ_5;
    const double w41 = EAZ_6*w35 + ECZ_6*w34 + EYZ_6;
    const double w42 = EAZ_7*w35 + ECZ_7*w34 + EYZ_7;
    const double w44 = EA0Z*w35 + EC0X*w34;
    const double w45 = EAX_1*w35 + ECX_1*w34 + EYX_1;
    const double w46 = EAX_2*w35 + ECX_2*w34 + EYX_2;
    const double w47 = EAX_3*w35 + ECX_3*w34 + EYX_3;
    const double w48 = EAX_4*w35 + ECX_4*w34 + EYX_4;
    const double w49 = EAX_5*w35 + ECX_5*w34 + EYX_5;
    const double w50 = EAX_6*w35 + ECX_6*w34 + EYX_6;
    const double w51 = EAX_7*w35 + ECX_7*w34 + EYX_7;
    const double w53 = EAY_1*w35 + ECY_1*w34 + EYY_1;
    const double w54 = EAY_2*w35 + ECY_2*w34 + EYY_2;
    const double w55 = EAY_3*w35 + ECY_3*w34 + EYY_3;
    const double w56 = EAY_4*w35 + ECY_4*w34 + EYY_4;
    const double w57 = EAY_5*w35 + ECY_5*w34 + EYY_5;
    const double w58 = EAY_6*w35 + ECY_6*w34 + EYY_6;
    const double w59 = EAY_7*w35 + ECY_7*w34 + EYY_7;
    const double w69 = -w34;
    const double w70 = EAZ_1*w1 + EBZ_1*w69 + EZZ_1;
    const double w71 = EAZ_2*w1 + EBZ_2*w69 + EZZ_2;
    const double w72 = EAZ_3*w1 + EBZ_3*w69 + EZZ_3;
    const double w73 = EAZ_4*w1 + EBZ_4*w69 + EZZ_4;
    const double w74 = EAZ_5*w1 + EBZ_5*w69 + EZZ_5;
    const double w75 = EAZ_6*w1 + EBZ_6*w69 + EZZ_6;
    const double w76 = EAZ_7*w1 + EBZ_7*w69 + EZZ_7;
    const double w78 = EA0Z*w1 + EB0Z*w69;
    const double w79 = EAX_1*w1 + EBX_1*w69 + EZX_1;
    const double w80 = EAX_2*w1 + EBX_2*w69 + EZX_2;
    const double w81 = EAX_3*w1 + EBX_3*w69 + EZX_3;
    const double w82 = EAX_4*w1 + EBX_4*w69 + EZX_4;
    const double w83 = EAX_5*w1 + EBX_5*w69 + EZX_5;
    const double w84 = EAX_6*w1 + EBX_6*w69 + EZX_6;
    const double w85 = EAX_7*w1 + EBX_7*w69 + EZX_7;
    const double w87 = EAY_1*w1 + EBY_1*w69 + EZY_1;
    const double w88 = EAY_2*w1 + EBY_2*w69 + EZY_2;
    const double w89 = EAY_3*w1 + EBY_3*w69 + EZY_3;
    const double w90 = EAY_4*w1 + EBY_4*w69 + EZY_4;
    const double w91 = EAY_5*w1 + EBY_5*w69 + EZY_5;
    const double w92 = EAY_6*w1 + EBY_6*w69 + EZY_6;
    const double w93 = EAY_7*w1 + EBY_7*w69 + EZY_7;
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
        const double x = positions[0 * stride + i];
        const double y = positions[1 * stride + i];
        const double z = positions[2 * stride + i];
        const double w10 = z*(w3 + z*(w4 + z*(w5 + z*(w6 + z*(w7 + z*(w8 + w9*z))))));
        const double w19 = x*(w12 + x*(w13 + x*(w14 + x*(w15 + x*(w16 + x*(w17 + w18*x))))));
        const double w27 = y*(w20 + y*(w21 + y*(w22 + y*(w23 + y*(w24 + y*(w25 + w26*y))))));
        const double w28 = w10 + w11 + w19 + w27;
        const double w29 = x*(EBX_1 + x*(EBX_2 + x*(EBX_3 + x*(EBX_4 + x*(EBX_5 + x*(EBX_6 + EBX_7*x))))));
        const double w30 = y*(EBY_1 + y*(EBY_2 + y*(EBY_3 + y*(EBY_4 + y*(EBY_5 + y*(EBY_6 + EBY_7*y))))));
        const double w31 = w30;
        const double w32 = EB0Z + w29 + w31;
        const double w33 = w32*z;
        const double w43 = z*(w36 + z*(w37 + z*(w38 + z*(w39 + z*(w40 + z*(w41 + w42*z))))));
        const double w52 = x*(w45 + x*(w46 + x*(w47 + x*(w48 + x*(w49 + x*(w50 + w51*x))))));
        const double w60 = y*(w53 + y*(w54 + y*(w55 + y*(w56 + y*(w57 + y*(w58 + w59*y))))));
        const double w61 = w43 + w44 + w52 + w60;
        const double w62 = x*(EAX_1 + x*(EAX_2 + x*(EAX_3 + x*(EAX_4 + x*(EAX_5 + x*(EAX_6 + EAX_7*x))))));
        const double w63 = y*(EAY_1 + y*(EAY_2 + y*(EAY_3 + y*(EAY_4 + y*(EAY_5 + y*(EAY_6 + EAY_7*y))))));
        const double w64 = -EA0Z - w62 - w63;
        const double w65 = w64*z;
        const double w66 = y*(ECY_1 + y*(ECY_2 + y*(ECY_3 + y*(ECY_4 + y*(ECY_5 + y*(ECY_6 + ECY_7*y))))));
        const double w67 = EC0X + w66;
        const double w68 = w67*x;
        const double w77 = z*(w70 + z*(w71 + z*(w72 + z*(w73 + z*(w74 + z*(w75 + w76*z))))));
        const double w86 = x*(w79 + x*(w80 + x*(w81 + x*(w82 + x*(w83 + x*(w84 + w85*x))))));
        const double w94 = y*(w87 + y*(w88 + y*(w89 + y*(w90 + y*(w91 + y*(w92 + w93*y))))));
        const double w95 = w77 + w78 + w86 + w94;
        const double w96 = w30;
        const double w97 = -w96*x;
        deviation[0 * stride + i] = w28 + w33;
        deviation[1 * stride + i] = w61 + w65 + w68;
        deviation[2 * stride + i] = w95 + w97;
    }
}

/*
 * Positioning error of a ball bar between a tool ball and a workpiece ball, exact.
 * Source: Eqs. (5), (6). Operations: 107 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 6 values, mm, rad; home positions and location errors (q_Px q_Py q_Pz EC0X EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * in ball: 3 rows of stride, mm; point in the workpiece frame (bx by bz)
 * in length: 1 rows of stride, mm; ideal length of the ball bar (length)
 * out error: 4 rows of stride, mm; positioning error E, then its components E_x, E_y, E_z (e ex ey ez)
 */
void bridge_cmm_ballbar_error(
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
    const double q_Px = parameters[0];
    const double q_Py = parameters[1];
    const double q_Pz = parameters[2];
    const double EC0X = parameters[3];
    const double EA0Z = parameters[4];
    const double EB0Z = parameters[5];
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
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
        const double rx = point[0 * stride + i];
        const double ry = point[1 * stride + i];
        const double rz = point[2 * stride + i];
        const double bx = ball[0 * stride + i];
        const double by = ball[1 * stride + i];
        const double bz = ball[2 * stride + i];
        const double length_ = length[0 * stride + i];
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
        const double w22 = EBY*w14 - ECY*w20 + EXY + w21;
        const double w23 = w18 + w21;
        const double w24 = -EAY*w14 + ECY*w23 + EYY + w19;
        const double w25 = EAY*w20 - EBY*w23 + EZY + w13;
        const double w26 = -bx + w18;
        const double w27 = w2 + y;
        const double w28 = -by + w27;
        const double w29 = -bz + w1;
        const double w30 = w22 + w26;
        const double w31 = w24 + w28;
        const double w32 = w25 + w29;
        const double w33 = sqrt((w26*w26) + (w28*w28) + (w29*w29));
        const double w34 = sqrt((w30*w30) + (w31*w31) + (w32*w32));
        const double e = -length_ + w33 + (w22*(w26 + w30) + w24*(w28 + w31) + w25*(w29 + w32))/(w33 + w34);
        const double w35 = e/w34;
        error[0 * stride + i] = e;
        error[1 * stride + i] = w30*w35;
        error[2 * stride + i] = w31*w35;
        error[3 * stride + i] = w32*w35;
    }
}

/*
 * Moves of the linear axes that displace the ideal tool point by the given vector.
 * Source: Eqs. (53)-(55), inverse. Operations: 0 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in deviation: 3 rows of stride, mm; displacement of the tool point in the workpiece frame (dx dy dz)
 * out moves: 3 rows of stride, mm; moves of X Y Z (move_x move_y move_z)
 */
void bridge_cmm_correction(
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
 * Source: Eqs. (7)-(11). Operations: 18 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 6 values, mm, rad; home positions and location errors (q_Px q_Py q_Pz EC0X EA0Z EB0Z)
 * in tool_point: 3 rows of stride, mm; point in the tool frame (rTx rTy rTz)
 * out displacement: 3 rows of stride, mm; tool point, displacement since home, in the bed frame (dx dy dz)
 */
void bridge_cmm_motion_X(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT tool_point,
    double *TRUEAXIS_RESTRICT displacement)
{
    /* once per call */
    const double q_Px = parameters[0];
    const double q_Py = parameters[1];
    const double q_Pz = parameters[2];
    const double EC0X = parameters[3];
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
        const double w0 = q_Pz + rTz;
        const double w1 = q_Py + rTy;
        const double w2 = q_Px + rTx;
        displacement[0 * stride + i] = EBX*w0 - ECX*w1 + EXX + x;
        displacement[1 * stride + i] = -EAX*w0 + EC0X*x + ECX*w2 + EYX;
        displacement[2 * stride + i] = EAX*w1 - EBX*w2 + EZX;
    }
}

/*
 * Motion equation of Y: displacement of the tool point since home, to first order.
 * Source: Eqs. (7)-(11). Operations: 16 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 6 values, mm, rad; home positions and location errors (q_Px q_Py q_Pz EC0X EA0Z EB0Z)
 * in tool_point: 3 rows of stride, mm; point in the tool frame (rTx rTy rTz)
 * out displacement: 3 rows of stride, mm; tool point, displacement since home, in the bed frame (dx dy dz)
 */
void bridge_cmm_motion_Y(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT tool_point,
    double *TRUEAXIS_RESTRICT displacement)
{
    /* once per call */
    const double q_Px = parameters[0];
    const double q_Py = parameters[1];
    const double q_Pz = parameters[2];
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
        const double w0 = q_Pz + rTz;
        const double w1 = q_Py + rTy;
        const double w2 = q_Px + rTx;
        displacement[0 * stride + i] = EBY*w0 - ECY*w1 + EXY;
        displacement[1 * stride + i] = -EAY*w0 + ECY*w2 + EYY + y;
        displacement[2 * stride + i] = EAY*w1 - EBY*w2 + EZY;
    }
}

/*
 * Motion equation of Z: displacement of the tool point since home, to first order.
 * Source: Eqs. (7)-(11). Operations: 20 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 6 values, mm, rad; home positions and location errors (q_Px q_Py q_Pz EC0X EA0Z EB0Z)
 * in tool_point: 3 rows of stride, mm; point in the tool frame (rTx rTy rTz)
 * out displacement: 3 rows of stride, mm; tool point, displacement since home, in the bed frame (dx dy dz)
 */
void bridge_cmm_motion_Z(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT tool_point,
    double *TRUEAXIS_RESTRICT displacement)
{
    /* once per call */
    const double q_Px = parameters[0];
    const double q_Py = parameters[1];
    const double q_Pz = parameters[2];
    const double EA0Z = parameters[4];
    const double EB0Z = parameters[5];
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
        const double w0 = q_Pz + rTz;
        const double w1 = q_Py + rTy;
        const double w2 = q_Px + rTx;
        displacement[0 * stride + i] = EB0Z*z + EBZ*w0 - ECZ*w1 + EXZ;
        displacement[1 * stride + i] = -EA0Z*z - EAZ*w0 + ECZ*w2 + EYZ;
        displacement[2 * stride + i] = EAZ*w1 - EBZ*w2 + EZZ + z;
    }
}

/*
 * Motion equation of X and Y: displacement of the tool point since home, to first order.
 * Source: Eqs. (7)-(11). Operations: 37 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 6 values, mm, rad; home positions and location errors (q_Px q_Py q_Pz EC0X EA0Z EB0Z)
 * in tool_point: 3 rows of stride, mm; point in the tool frame (rTx rTy rTz)
 * out displacement: 3 rows of stride, mm; tool point, displacement since home, in the bed frame (dx dy dz)
 */
void bridge_cmm_motion_XY(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT tool_point,
    double *TRUEAXIS_RESTRICT displacement)
{
    /* once per call */
    const double q_Px = parameters[0];
    const double q_Py = parameters[1];
    const double q_Pz = parameters[2];
    const double EC0X = parameters[3];
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
        const double w0 = q_Pz + rTz;
        const double w1 = q_Py + rTy;
        const double w2 = -w1;
        const double w3 = q_Px + rTx;
        const double w4 = w3 + x;
        const double w5 = -w0;
        displacement[0 * stride + i] = EBX*w0 + EBY*w0 + ECX*w2 + ECY*w2 + EXX + EXY + x;
        displacement[1 * stride + i] = EAX*w5 + EAY*w5 + EC0X*x + ECX*w3 + ECY*w4 + EYX + EYY + y;
        displacement[2 * stride + i] = EAX*w1 + EAY*w1 - EBX*w3 - EBY*w4 + EZX + EZY;
    }
}

/*
 * Motion equation of X and Z: displacement of the tool point since home, to first order.
 * Source: Eqs. (7)-(11). Operations: 41 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 6 values, mm, rad; home positions and location errors (q_Px q_Py q_Pz EC0X EA0Z EB0Z)
 * in tool_point: 3 rows of stride, mm; point in the tool frame (rTx rTy rTz)
 * out displacement: 3 rows of stride, mm; tool point, displacement since home, in the bed frame (dx dy dz)
 */
void bridge_cmm_motion_XZ(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT tool_point,
    double *TRUEAXIS_RESTRICT displacement)
{
    /* once per call */
    const double q_Px = parameters[0];
    const double q_Py = parameters[1];
    const double q_Pz = parameters[2];
    const double EC0X = parameters[3];
    const double EA0Z = parameters[4];
    const double EB0Z = parameters[5];
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
        const double w0 = q_Pz + rTz;
        const double w1 = w0 + z;
        const double w2 = q_Py + rTy;
        const double w3 = -w2;
        const double w4 = q_Px + rTx;
        const double w5 = -w4;
        displacement[0 * stride + i] = EB0Z*z + EBX*w1 + EBZ*w0 + ECX*w3 + ECZ*w3 + EXX + EXZ + x;
        displacement[1 * stride + i] = -EA0Z*z - EAX*w1 - EAZ*w0 + EC0X*x + ECX*w4 + ECZ*w4 + EYX + EYZ;
        displacement[2 * stride + i] = EAX*w2 + EAZ*w2 + EBX*w5 + EBZ*w5 + EZX + EZZ + z;
    }
}

/*
 * Motion equation of Y and Z: displacement of the tool point since home, to first order.
 * Source: Eqs. (7)-(11). Operations: 39 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 6 values, mm, rad; home positions and location errors (q_Px q_Py q_Pz EC0X EA0Z EB0Z)
 * in tool_point: 3 rows of stride, mm; point in the tool frame (rTx rTy rTz)
 * out displacement: 3 rows of stride, mm; tool point, displacement since home, in the bed frame (dx dy dz)
 */
void bridge_cmm_motion_YZ(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT tool_point,
    double *TRUEAXIS_RESTRICT displacement)
{
    /* once per call */
    const double q_Px = parameters[0];
    const double q_Py = parameters[1];
    const double q_Pz = parameters[2];
    const double EA0Z = parameters[4];
    const double EB0Z = parameters[5];
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
        const double w0 = q_Pz + rTz;
        const double w1 = w0 + z;
        const double w2 = q_Py + rTy;
        const double w3 = -w2;
        const double w4 = q_Px + rTx;
        const double w5 = -w4;
        displacement[0 * stride + i] = EB0Z*z + EBY*w1 + EBZ*w0 + ECY*w3 + ECZ*w3 + EXY + EXZ;
        displacement[1 * stride + i] = -EA0Z*z - EAY*w1 - EAZ*w0 + ECY*w4 + ECZ*w4 + EYY + EYZ + y;
        displacement[2 * stride + i] = EAY*w2 + EAZ*w2 + EBY*w5 + EBZ*w5 + EZY + EZZ + z;
    }
}
