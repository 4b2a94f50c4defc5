/* Generated from machines/cframe_mill.toml, do not edit; regenerate with: trueaxis derive machines/cframe_mill.toml
 * SPDX-License-Identifier: MIT
 * Kernels of C-frame mill: geometric error model in C17.
 * Spec: sha256 e0bab1439083d465e60d898b33f648fd88b066b0d41217ad88014752dc9315ad
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

int cframe_mill_kernel_abi(void)
{
    return TRUEAXIS_KERNEL_ABI;
}

const char *cframe_mill_spec_hash(void)
{
    return "e0bab1439083d465e60d898b33f648fd88b066b0d41217ad88014752dc9315ad";
}

/*
 * Ideal position of a tool point in the workpiece frame.
 * Source: Eqs. (1)-(4) without errors. Operations: 3 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0X EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out ideal: 3 rows of stride, mm; tool point in the workpiece frame, without errors (px py pz)
 */
void cframe_mill_tool_in_workpiece_ideal(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT ideal)
{
    (void)parameters;
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
        const double x = positions[0 * stride + i];
        const double y = positions[1 * stride + i];
        const double z = positions[2 * stride + i];
        const double rx = point[0 * stride + i];
        const double ry = point[1 * stride + i];
        const double rz = point[2 * stride + i];
        ideal[0 * stride + i] = rx - x;
        ideal[1 * stride + i] = ry - y;
        ideal[2 * stride + i] = rz + z;
    }
}

/*
 * Deviation of a tool point in the workpiece frame, exact.
 * Source: Eqs. (1)-(4). Operations: 135 per point, 3 once per call.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0X EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; tool point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void cframe_mill_tool_in_workpiece_deviation(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation)
{
    /* once per call */
    const double EC0X = parameters[0];
    const double EA0Z = parameters[1];
    const double EB0Z = parameters[2];
    const double w22 = (EC0X*EC0X);
    const double w23 = (1.0/(w22 + 1.0));
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
        deviation[0 * stride + i] = w39*(EAX*w37 - EBX*w35 + ECX*w29 - w0*w38 + w25);
        deviation[1 * stride + i] = w39*(EAX*w35 + EBX*w37 - ECX*w36 + w28 - w38*w7);
        deviation[2 * stride + i] = w39*(-EAX*w29 + EBX*w36 + ECX*w37 - w2*w38 + w34);
    }
}

/*
 * Deviation of a tool point in the workpiece frame, to first order in the errors.
 * Source: Eqs. (1)-(4). Operations: 57 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0X EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; tool point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void cframe_mill_tool_in_workpiece_deviation_first_order(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation)
{
    /* once per call */
    const double EC0X = parameters[0];
    const double EA0Z = parameters[1];
    const double EB0Z = parameters[2];
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
        const double w0 = rz + z;
        const double w1 = ry - y;
        const double w2 = EBZ*rz - ECZ*ry + EXZ;
        const double w3 = EB0Z*w0 + w2;
        const double w4 = -EBY*w0 + ECY*w1 - EXY + w3;
        const double w5 = EC0X*w1 + w4;
        const double w6 = -EAZ*rz + ECZ*rx + EYZ;
        const double w7 = -EA0Z*w0 + w6;
        const double w8 = EAY*w0 - ECY*rx - EYY + w7;
        const double w9 = -EC0X*rx + w8;
        const double w10 = rx - x;
        const double w11 = EAZ*ry - EBZ*rx + EZZ;
        const double w12 = EA0Z*ry - EB0Z*rx + w11;
        const double w13 = -EAY*w1 + EBY*rx - EZY + w12;
        deviation[0 * stride + i] = -EBX*w0 + ECX*w1 - EXX + w5;
        deviation[1 * stride + i] = EAX*w0 - ECX*w10 - EYX + w9;
        deviation[2 * stride + i] = -EAX*w1 + EBX*w10 - EZX + w13;
    }
}

/*
 * Sensitivity of a tool point in the workpiece frame to every error, at the error-free machine.
 * Source: Eqs. (1)-(4), first order. Operations: 15 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0X EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out sensitivity: 63 rows of stride, mm/mm, mm/rad; derivative of the deviation by each component error, then by each
 *     location error (dx_EXX dx_EYX .. dz_EB0Z, last index fastest)
 */
void cframe_mill_tool_in_workpiece_sensitivity(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT sensitivity)
{
    (void)parameters;
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
        const double x = positions[0 * stride + i];
        const double y = positions[1 * stride + i];
        const double z = positions[2 * stride + i];
        const double rx = point[0 * stride + i];
        const double ry = point[1 * stride + i];
        const double rz = point[2 * stride + i];
        const double dx_EB0Z = rz + z;
        const double dx_EBX = -dx_EB0Z;
        const double dx_ECX = ry - y;
        const double dz_EBX = rx - x;
        const double dy_ECY = -rx;
        const double dz_EAX = -dx_ECX;
        sensitivity[0 * stride + i] = -1.0;
        sensitivity[1 * stride + i] = 0.0;
        sensitivity[2 * stride + i] = 0.0;
        sensitivity[3 * stride + i] = 0.0;
        sensitivity[4 * stride + i] = dx_EBX;
        sensitivity[5 * stride + i] = dx_ECX;
        sensitivity[6 * stride + i] = -1.0;
        sensitivity[7 * stride + i] = 0.0;
        sensitivity[8 * stride + i] = 0.0;
        sensitivity[9 * stride + i] = 0.0;
        sensitivity[10 * stride + i] = dx_EBX;
        sensitivity[11 * stride + i] = dx_ECX;
        sensitivity[12 * stride + i] = 1.0;
        sensitivity[13 * stride + i] = 0.0;
        sensitivity[14 * stride + i] = 0.0;
        sensitivity[15 * stride + i] = 0.0;
        sensitivity[16 * stride + i] = rz;
        sensitivity[17 * stride + i] = -ry;
        sensitivity[18 * stride + i] = dx_ECX;
        sensitivity[19 * stride + i] = 0.0;
        sensitivity[20 * stride + i] = dx_EB0Z;
        sensitivity[21 * stride + i] = 0.0;
        sensitivity[22 * stride + i] = -1.0;
        sensitivity[23 * stride + i] = 0.0;
        sensitivity[24 * stride + i] = dx_EB0Z;
        sensitivity[25 * stride + i] = 0.0;
        sensitivity[26 * stride + i] = -dz_EBX;
        sensitivity[27 * stride + i] = 0.0;
        sensitivity[28 * stride + i] = -1.0;
        sensitivity[29 * stride + i] = 0.0;
        sensitivity[30 * stride + i] = dx_EB0Z;
        sensitivity[31 * stride + i] = 0.0;
        sensitivity[32 * stride + i] = dy_ECY;
        sensitivity[33 * stride + i] = 0.0;
        sensitivity[34 * stride + i] = 1.0;
        sensitivity[35 * stride + i] = 0.0;
        sensitivity[36 * stride + i] = -rz;
        sensitivity[37 * stride + i] = 0.0;
        sensitivity[38 * stride + i] = rx;
        sensitivity[39 * stride + i] = dy_ECY;
        sensitivity[40 * stride + i] = dx_EBX;
        sensitivity[41 * stride + i] = 0.0;
        sensitivity[42 * stride + i] = 0.0;
        sensitivity[43 * stride + i] = 0.0;
        sensitivity[44 * stride + i] = -1.0;
        sensitivity[45 * stride + i] = dz_EAX;
        sensitivity[46 * stride + i] = dz_EBX;
        sensitivity[47 * stride + i] = 0.0;
        sensitivity[48 * stride + i] = 0.0;
        sensitivity[49 * stride + i] = 0.0;
        sensitivity[50 * stride + i] = -1.0;
        sensitivity[51 * stride + i] = dz_EAX;
        sensitivity[52 * stride + i] = rx;
        sensitivity[53 * stride + i] = 0.0;
        sensitivity[54 * stride + i] = 0.0;
        sensitivity[55 * stride + i] = 0.0;
        sensitivity[56 * stride + i] = 1.0;
        sensitivity[57 * stride + i] = ry;
        sensitivity[58 * stride + i] = dy_ECY;
        sensitivity[59 * stride + i] = 0.0;
        sensitivity[60 * stride + i] = 0.0;
        sensitivity[61 * stride + i] = ry;
        sensitivity[62 * stride + i] = dy_ECY;
    }
}

/*
 * Ideal position of a tool point in the bed frame.
 * Source: Eqs. (1)-(4) without errors. Operations: 1 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0X EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out ideal: 3 rows of stride, mm; tool point in the bed frame, without errors (px py pz)
 */
void cframe_mill_tool_in_bed_ideal(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT ideal)
{
    (void)parameters;
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
        const double z = positions[2 * stride + i];
        const double rx = point[0 * stride + i];
        const double ry = point[1 * stride + i];
        const double rz = point[2 * stride + i];
        ideal[0 * stride + i] = rx;
        ideal[1 * stride + i] = ry;
        ideal[2 * stride + i] = rz + z;
    }
}

/*
 * Deviation of a tool point in the bed frame, exact.
 * Source: Eqs. (1)-(4). Operations: 24 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0X EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; tool point in the bed frame, actual minus ideal (dx dy dz)
 */
void cframe_mill_tool_in_bed_deviation(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation)
{
    /* once per call */
    const double EA0Z = parameters[1];
    const double EB0Z = parameters[2];
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
        const double rx = point[0 * stride + i];
        const double ry = point[1 * stride + i];
        const double rz = point[2 * stride + i];
        const double w0 = EAZ*ry - EBZ*rx + EZZ;
        const double w1 = rz + z;
        const double w2 = w0 + w1;
        const double w3 = EBZ*rz - ECZ*ry + EXZ;
        const double w4 = -EAZ*rz + ECZ*rx + EYZ;
        deviation[0 * stride + i] = EB0Z*w2 + w3;
        deviation[1 * stride + i] = -EA0Z*w2 + w4;
        deviation[2 * stride + i] = EA0Z*(ry + w4) - EB0Z*(rx + w3) + w0;
    }
}

/*
 * Deviation of a tool point in the bed frame, to first order in the errors.
 * Source: Eqs. (1)-(4). Operations: 21 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0X EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; tool point in the bed frame, actual minus ideal (dx dy dz)
 */
void cframe_mill_tool_in_bed_deviation_first_order(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation)
{
    /* once per call */
    const double EA0Z = parameters[1];
    const double EB0Z = parameters[2];
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
        const double rx = point[0 * stride + i];
        const double ry = point[1 * stride + i];
        const double rz = point[2 * stride + i];
        const double w0 = EBZ*rz - ECZ*ry + EXZ;
        const double w1 = rz + z;
        const double w2 = -EAZ*rz + ECZ*rx + EYZ;
        const double w3 = EAZ*ry - EBZ*rx + EZZ;
        deviation[0 * stride + i] = EB0Z*w1 + w0;
        deviation[1 * stride + i] = -EA0Z*w1 + w2;
        deviation[2 * stride + i] = EA0Z*ry - EB0Z*rx + w3;
    }
}

/*
 * Sensitivity of a tool point in the bed frame to every error, at the error-free machine.
 * Source: Eqs. (1)-(4), first order. Operations: 5 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0X EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out sensitivity: 63 rows of stride, mm/mm, mm/rad; derivative of the deviation by each component error, then by each
 *     location error (dx_EXX dx_EYX .. dz_EB0Z, last index fastest)
 */
void cframe_mill_tool_in_bed_sensitivity(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT sensitivity)
{
    (void)parameters;
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
        const double z = positions[2 * stride + i];
        const double rx = point[0 * stride + i];
        const double ry = point[1 * stride + i];
        const double rz = point[2 * stride + i];
        const double dx_EB0Z = rz + z;
        const double dz_EBZ = -rx;
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
        sensitivity[12 * stride + i] = 1.0;
        sensitivity[13 * stride + i] = 0.0;
        sensitivity[14 * stride + i] = 0.0;
        sensitivity[15 * stride + i] = 0.0;
        sensitivity[16 * stride + i] = rz;
        sensitivity[17 * stride + i] = -ry;
        sensitivity[18 * stride + i] = 0.0;
        sensitivity[19 * stride + i] = 0.0;
        sensitivity[20 * stride + i] = dx_EB0Z;
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
        sensitivity[34 * stride + i] = 1.0;
        sensitivity[35 * stride + i] = 0.0;
        sensitivity[36 * stride + i] = -rz;
        sensitivity[37 * stride + i] = 0.0;
        sensitivity[38 * stride + i] = rx;
        sensitivity[39 * stride + i] = 0.0;
        sensitivity[40 * stride + i] = -dx_EB0Z;
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
        sensitivity[56 * stride + i] = 1.0;
        sensitivity[57 * stride + i] = ry;
        sensitivity[58 * stride + i] = dz_EBZ;
        sensitivity[59 * stride + i] = 0.0;
        sensitivity[60 * stride + i] = 0.0;
        sensitivity[61 * stride + i] = ry;
        sensitivity[62 * stride + i] = dz_EBZ;
    }
}

/*
 * Ideal position of a workpiece point in the bed frame.
 * Source: Eqs. (1)-(4) without errors. Operations: 2 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0X EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the workpiece frame (rx ry rz)
 * out ideal: 3 rows of stride, mm; workpiece point in the bed frame, without errors (px py pz)
 */
void cframe_mill_workpiece_in_bed_ideal(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT ideal)
{
    (void)parameters;
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
        const double x = positions[0 * stride + i];
        const double y = positions[1 * stride + i];
        const double rx = point[0 * stride + i];
        const double ry = point[1 * stride + i];
        const double rz = point[2 * stride + i];
        ideal[0 * stride + i] = rx + x;
        ideal[1 * stride + i] = ry + y;
        ideal[2 * stride + i] = rz;
    }
}

/*
 * Deviation of a workpiece point in the bed frame, exact.
 * Source: Eqs. (1)-(4). Operations: 37 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0X EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the workpiece frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; workpiece point in the bed frame, actual minus ideal (dx dy dz)
 */
void cframe_mill_workpiece_in_bed_deviation(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation)
{
    /* once per call */
    const double EC0X = parameters[0];
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
        const double EXY = errors[6 * stride + i];
        const double EYY = errors[7 * stride + i];
        const double EZY = errors[8 * stride + i];
        const double EAY = errors[9 * stride + i];
        const double EBY = errors[10 * stride + i];
        const double ECY = errors[11 * stride + i];
        const double rx = point[0 * stride + i];
        const double ry = point[1 * stride + i];
        const double rz = point[2 * stride + i];
        const double w0 = EAX*ry - EBX*rx + EZX;
        const double w1 = rz + w0;
        const double w2 = EBX*rz - ECX*ry + EXX;
        const double w3 = -EAX*rz + ECX*rx + EYX;
        const double w4 = rx + x;
        const double w5 = EC0X*(w2 + w4) + w3;
        const double w6 = ry + w5;
        const double w7 = -EC0X*(ry + w3) + w2;
        const double w8 = w4 + w7;
        deviation[0 * stride + i] = EBY*w1 - ECY*w6 + EXY + w7;
        deviation[1 * stride + i] = -EAY*w1 + ECY*w8 + EYY + w5;
        deviation[2 * stride + i] = EAY*w6 - EBY*w8 + EZY + w0;
    }
}

/*
 * Deviation of a workpiece point in the bed frame, to first order in the errors.
 * Source: Eqs. (1)-(4). Operations: 32 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0X EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the workpiece frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; workpiece point in the bed frame, actual minus ideal (dx dy dz)
 */
void cframe_mill_workpiece_in_bed_deviation_first_order(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation)
{
    /* once per call */
    const double EC0X = parameters[0];
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
        const double EXY = errors[6 * stride + i];
        const double EYY = errors[7 * stride + i];
        const double EZY = errors[8 * stride + i];
        const double EAY = errors[9 * stride + i];
        const double EBY = errors[10 * stride + i];
        const double ECY = errors[11 * stride + i];
        const double rx = point[0 * stride + i];
        const double ry = point[1 * stride + i];
        const double rz = point[2 * stride + i];
        const double w0 = EBX*rz - ECX*ry + EXX;
        const double w1 = -EC0X*ry + w0;
        const double w2 = rx + x;
        const double w3 = -EAX*rz + ECX*rx + EYX;
        const double w4 = EC0X*w2 + w3;
        const double w5 = EAX*ry - EBX*rx + EZX;
        deviation[0 * stride + i] = EBY*rz - ECY*ry + EXY + w1;
        deviation[1 * stride + i] = -EAY*rz + ECY*w2 + EYY + w4;
        deviation[2 * stride + i] = EAY*ry - EBY*w2 + EZY + w5;
    }
}

/*
 * Sensitivity of a workpiece point in the bed frame to every error, at the error-free machine.
 * Source: Eqs. (1)-(4), first order. Operations: 5 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0X EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the workpiece frame (rx ry rz)
 * out sensitivity: 63 rows of stride, mm/mm, mm/rad; derivative of the deviation by each component error, then by each
 *     location error (dx_EXX dx_EYX .. dz_EB0Z, last index fastest)
 */
void cframe_mill_workpiece_in_bed_sensitivity(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT sensitivity)
{
    (void)parameters;
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
        const double x = positions[0 * stride + i];
        const double rx = point[0 * stride + i];
        const double ry = point[1 * stride + i];
        const double rz = point[2 * stride + i];
        const double dx_ECX = -ry;
        const double dy_EAX = -rz;
        const double dy_ECY = rx + x;
        sensitivity[0 * stride + i] = 1.0;
        sensitivity[1 * stride + i] = 0.0;
        sensitivity[2 * stride + i] = 0.0;
        sensitivity[3 * stride + i] = 0.0;
        sensitivity[4 * stride + i] = rz;
        sensitivity[5 * stride + i] = dx_ECX;
        sensitivity[6 * stride + i] = 1.0;
        sensitivity[7 * stride + i] = 0.0;
        sensitivity[8 * stride + i] = 0.0;
        sensitivity[9 * stride + i] = 0.0;
        sensitivity[10 * stride + i] = rz;
        sensitivity[11 * stride + i] = dx_ECX;
        sensitivity[12 * stride + i] = 0.0;
        sensitivity[13 * stride + i] = 0.0;
        sensitivity[14 * stride + i] = 0.0;
        sensitivity[15 * stride + i] = 0.0;
        sensitivity[16 * stride + i] = 0.0;
        sensitivity[17 * stride + i] = 0.0;
        sensitivity[18 * stride + i] = dx_ECX;
        sensitivity[19 * stride + i] = 0.0;
        sensitivity[20 * stride + i] = 0.0;
        sensitivity[21 * stride + i] = 0.0;
        sensitivity[22 * stride + i] = 1.0;
        sensitivity[23 * stride + i] = 0.0;
        sensitivity[24 * stride + i] = dy_EAX;
        sensitivity[25 * stride + i] = 0.0;
        sensitivity[26 * stride + i] = rx;
        sensitivity[27 * stride + i] = 0.0;
        sensitivity[28 * stride + i] = 1.0;
        sensitivity[29 * stride + i] = 0.0;
        sensitivity[30 * stride + i] = dy_EAX;
        sensitivity[31 * stride + i] = 0.0;
        sensitivity[32 * stride + i] = dy_ECY;
        sensitivity[33 * stride + i] = 0.0;
        sensitivity[34 * stride + i] = 0.0;
        sensitivity[35 * stride + i] = 0.0;
        sensitivity[36 * stride + i] = 0.0;
        sensitivity[37 * stride + i] = 0.0;
        sensitivity[38 * stride + i] = 0.0;
        sensitivity[39 * stride + i] = dy_ECY;
        sensitivity[40 * stride + i] = 0.0;
        sensitivity[41 * stride + i] = 0.0;
        sensitivity[42 * stride + i] = 0.0;
        sensitivity[43 * stride + i] = 0.0;
        sensitivity[44 * stride + i] = 1.0;
        sensitivity[45 * stride + i] = ry;
        sensitivity[46 * stride + i] = -rx;
        sensitivity[47 * stride + i] = 0.0;
        sensitivity[48 * stride + i] = 0.0;
        sensitivity[49 * stride + i] = 0.0;
        sensitivity[50 * stride + i] = 1.0;
        sensitivity[51 * stride + i] = ry;
        sensitivity[52 * stride + i] = -dy_ECY;
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
 * Source: Eqs. (1)-(4) without errors. Operations: 2 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0X EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the bed frame (rx ry rz)
 * out ideal: 3 rows of stride, mm; bed point in the workpiece frame, without errors (px py pz)
 */
void cframe_mill_bed_in_workpiece_ideal(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT ideal)
{
    (void)parameters;
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
        const double x = positions[0 * stride + i];
        const double y = positions[1 * stride + i];
        const double rx = point[0 * stride + i];
        const double ry = point[1 * stride + i];
        const double rz = point[2 * stride + i];
        ideal[0 * stride + i] = rx - x;
        ideal[1 * stride + i] = ry - y;
        ideal[2 * stride + i] = rz;
    }
}

/*
 * Deviation of a bed point in the workpiece frame, exact.
 * Source: Eqs. (1)-(4). Operations: 108 per point, 3 once per call.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0X EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the bed frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; bed point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void cframe_mill_bed_in_workpiece_deviation(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation)
{
    /* once per call */
    const double EC0X = parameters[0];
    const double w11 = (EC0X*EC0X);
    const double w12 = (1.0/(w11 + 1.0));
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
        const double rx = point[0 * stride + i];
        const double ry = point[1 * stride + i];
        const double rz = point[2 * stride + i];
        const double w0 = rx - x;
        const double w1 = ry - y;
        const double w2 = -EYY + w1;
        const double w3 = -EZY + rz;
        const double w4 = -EXY + rx;
        const double w5 = EAY*w4 + EBY*w2 + ECY*w3;
        const double w6 = (EAY*EAY) + (EBY*EBY) + (ECY*ECY);
        const double w7 = (1.0/(w6 + 1.0));
        const double w8 = w7*(EAY*w5 - EBY*w3 + ECY*w2 - EXY - rx*w6);
        const double w9 = w7*(EAY*w3 + EBY*w5 - ECY*w4 - EYY - w1*w6);
        const double w10 = w1 + w9;
        const double w13 = w12*(EC0X*w10 - rx*w11 + w8);
        const double w14 = -EXX + w13;
        const double w15 = rx + w8;
        const double w16 = w12*(-EC0X*w15 - w1*w11 + w9);
        const double w17 = -EYX + w16;
        const double w18 = w1 + w17;
        const double w19 = w7*(-EAY*w2 + EBY*w4 + ECY*w5 - EZY - rz*w6);
        const double w20 = rz + w19;
        const double w21 = EC0X*w20;
        const double w22 = w12*(EC0X*w21 - rz*w11 + w19);
        const double w23 = -EZX + w22;
        const double w24 = rz + w23;
        const double w25 = w0 + w14;
        const double w26 = EAX*w25 + EBX*w18 + ECX*w24;
        const double w27 = (EAX*EAX) + (EBX*EBX) + (ECX*ECX);
        const double w28 = (1.0/(w27 + 1.0));
        deviation[0 * stride + i] = w28*(EAX*w26 - EBX*w24 + ECX*w18 - w0*w27 + w14);
        deviation[1 * stride + i] = w28*(EAX*w24 + EBX*w26 - ECX*w25 - w1*w27 + w17);
        deviation[2 * stride + i] = w28*(-EAX*w18 + EBX*w25 + ECX*w26 - rz*w27 + w23);
    }
}

/*
 * Deviation of a bed point in the workpiece frame, to first order in the errors.
 * Source: Eqs. (1)-(4). Operations: 33 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0X EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the bed frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; bed point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void cframe_mill_bed_in_workpiece_deviation_first_order(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation)
{
    /* once per call */
    const double EC0X = parameters[0];
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
        const double rx = point[0 * stride + i];
        const double ry = point[1 * stride + i];
        const double rz = point[2 * stride + i];
        const double w0 = ry - y;
        const double w1 = -EBY*rz + ECY*w0 - EXY;
        const double w2 = EC0X*w0 + w1;
        const double w3 = EAY*rz - ECY*rx - EYY;
        const double w4 = -EC0X*rx + w3;
        const double w5 = rx - x;
        const double w6 = -EAY*w0 + EBY*rx - EZY;
        deviation[0 * stride + i] = -EBX*rz + ECX*w0 - EXX + w2;
        deviation[1 * stride + i] = EAX*rz - ECX*w5 - EYX + w4;
        deviation[2 * stride + i] = -EAX*w0 + EBX*w5 - EZX + w6;
    }
}

/*
 * Sensitivity of a bed point in the workpiece frame to every error, at the error-free machine.
 * Source: Eqs. (1)-(4), first order. Operations: 12 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0X EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the bed frame (rx ry rz)
 * out sensitivity: 63 rows of stride, mm/mm, mm/rad; derivative of the deviation by each component error, then by each
 *     location error (dx_EXX dx_EYX .. dz_EB0Z, last index fastest)
 */
void cframe_mill_bed_in_workpiece_sensitivity(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT sensitivity)
{
    (void)parameters;
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
        const double x = positions[0 * stride + i];
        const double y = positions[1 * stride + i];
        const double rx = point[0 * stride + i];
        const double ry = point[1 * stride + i];
        const double rz = point[2 * stride + i];
        const double dx_EBX = -rz;
        const double dx_ECX = ry - y;
        const double dz_EBX = rx - x;
        const double dy_ECY = -rx;
        const double dz_EAX = -dx_ECX;
        sensitivity[0 * stride + i] = -1.0;
        sensitivity[1 * stride + i] = 0.0;
        sensitivity[2 * stride + i] = 0.0;
        sensitivity[3 * stride + i] = 0.0;
        sensitivity[4 * stride + i] = dx_EBX;
        sensitivity[5 * stride + i] = dx_ECX;
        sensitivity[6 * stride + i] = -1.0;
        sensitivity[7 * stride + i] = 0.0;
        sensitivity[8 * stride + i] = 0.0;
        sensitivity[9 * stride + i] = 0.0;
        sensitivity[10 * stride + i] = dx_EBX;
        sensitivity[11 * stride + i] = dx_ECX;
        sensitivity[12 * stride + i] = 0.0;
        sensitivity[13 * stride + i] = 0.0;
        sensitivity[14 * stride + i] = 0.0;
        sensitivity[15 * stride + i] = 0.0;
        sensitivity[16 * stride + i] = 0.0;
        sensitivity[17 * stride + i] = 0.0;
        sensitivity[18 * stride + i] = dx_ECX;
        sensitivity[19 * stride + i] = 0.0;
        sensitivity[20 * stride + i] = 0.0;
        sensitivity[21 * stride + i] = 0.0;
        sensitivity[22 * stride + i] = -1.0;
        sensitivity[23 * stride + i] = 0.0;
        sensitivity[24 * stride + i] = rz;
        sensitivity[25 * stride + i] = 0.0;
        sensitivity[26 * stride + i] = -dz_EBX;
        sensitivity[27 * stride + i] = 0.0;
        sensitivity[28 * stride + i] = -1.0;
        sensitivity[29 * stride + i] = 0.0;
        sensitivity[30 * stride + i] = rz;
        sensitivity[31 * stride + i] = 0.0;
        sensitivity[32 * stride + i] = dy_ECY;
        sensitivity[33 * stride + i] = 0.0;
        sensitivity[34 * stride + i] = 0.0;
        sensitivity[35 * stride + i] = 0.0;
        sensitivity[36 * stride + i] = 0.0;
        sensitivity[37 * stride + i] = 0.0;
        sensitivity[38 * stride + i] = 0.0;
        sensitivity[39 * stride + i] = dy_ECY;
        sensitivity[40 * stride + i] = 0.0;
        sensitivity[41 * stride + i] = 0.0;
        sensitivity[42 * stride + i] = 0.0;
        sensitivity[43 * stride + i] = 0.0;
        sensitivity[44 * stride + i] = -1.0;
        sensitivity[45 * stride + i] = dz_EAX;
        sensitivity[46 * stride + i] = dz_EBX;
        sensitivity[47 * stride + i] = 0.0;
        sensitivity[48 * stride + i] = 0.0;
        sensitivity[49 * stride + i] = 0.0;
        sensitivity[50 * stride + i] = -1.0;
        sensitivity[51 * stride + i] = dz_EAX;
        sensitivity[52 * stride + i] = rx;
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
 * Source: Eq. (4). Operations: 138 per point, 3 once per call.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0X EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out position: 3 rows of stride, mm; actual position P_T^W of the tool point in the workpiece frame (px py pz)
 */
void cframe_mill_tool_in_workpiece_position(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT position)
{
    /* once per call */
    const double EC0X = parameters[0];
    const double EA0Z = parameters[1];
    const double EB0Z = parameters[2];
    const double w22 = (EC0X*EC0X);
    const double w23 = (1.0/(w22 + 1.0));
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
        const double w40 = w39*(EAX*w37 - EBX*w35 + ECX*w29 - w0*w38 + w25);
        const double w41 = w39*(EAX*w35 + EBX*w37 - ECX*w36 + w28 - w38*w7);
        const double w42 = w39*(-EAX*w29 + EBX*w36 + ECX*w37 - w2*w38 + w34);
        position[0 * stride + i] = w0 + w40;
        position[1 * stride + i] = w41 + w7;
        position[2 * stride + i] = w2 + w42;
    }
}

/*
 * Actual position of the tool point in the workpiece frame, to first order.
 * Source: Eq. (4). Operations: 60 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0X EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out position: 3 rows of stride, mm; actual position P_T^W of the tool point in the workpiece frame (px py pz)
 */
void cframe_mill_tool_in_workpiece_position_first_order(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT position)
{
    /* once per call */
    const double EC0X = parameters[0];
    const double EA0Z = parameters[1];
    const double EB0Z = parameters[2];
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
        const double w0 = rx - x;
        const double w1 = rz + z;
        const double w2 = ry - y;
        const double w3 = EBZ*rz - ECZ*ry + EXZ;
        const double w4 = EB0Z*w1 + w3;
        const double w5 = -EBY*w1 + ECY*w2 - EXY + w4;
        const double w6 = EC0X*w2 + w5;
        const double w7 = -EBX*w1 + ECX*w2 - EXX + w6;
        const double w8 = -EAZ*rz + ECZ*rx + EYZ;
        const double w9 = -EA0Z*w1 + w8;
        const double w10 = EAY*w1 - ECY*rx - EYY + w9;
        const double w11 = -EC0X*rx + w10;
        const double w12 = EAX*w1 - ECX*w0 - EYX + w11;
        const double w13 = EAZ*ry - EBZ*rx + EZZ;
        const double w14 = EA0Z*ry - EB0Z*rx + w13;
        const double w15 = -EAY*w2 + EBY*rx - EZY + w14;
        const double w16 = -EAX*w2 + EBX*w0 - EZX + w15;
        position[0 * stride + i] = w0 + w7;
        position[1 * stride + i] = w12 + w2;
        position[2 * stride + i] = w1 + w16;
    }
}

/*
 * Deviation of the tool point under polynomial error curves, exact.
 * Source: Eqs. (1)-(4), (44). Operations: 369 per point, 3 once per call.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in curves: 126 values, mm/mm^k, rad/mm^k; coefficients of the powers 1 to 7 of the axis position, per component
 *     error (EXX_1 EXX_2 .. ECZ_7, last index fastest)
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0X EA0Z EB0Z)
 * in point: 3 values, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; tool point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void cframe_mill_tool_in_workpiece_deviation_curves(
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
    const double EC0X = parameters[0];
    const double EA0Z = parameters[1];
    const double EB0Z = parameters[2];
    const double rx = point[0];
    const double ry = point[1];
    const double rz = point[2];
    const double w38 = (EC0X*EC0X);
    const double w39 = (1.0/(w38 + 1.0));
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
        const double x = positions[0 * stride + i];
        const double y = positions[1 * stride + i];
        const double z = positions[2 * stride + i];
        const double w0 = x*(EAX_1 + x*(EAX_2 + x*(EAX_3 + x*(EAX_4 + x*(EAX_5 + x*(EAX_6 + EAX_7*x))))));
        const double w1 = x*(EBX_1 + x*(EBX_2 + x*(EBX_3 + x*(EBX_4 + x*(EBX_5 + x*(EBX_6 + EBX_7*x))))));
        const double w2 = x*(ECX_1 + x*(ECX_2 + x*(ECX_3 + x*(ECX_4 + x*(ECX_5 + x*(ECX_6 + ECX_7*x))))));
        const double w3 = rx - x;
        const double w4 = x*(EXX_1 + x*(EXX_2 + x*(EXX_3 + x*(EXX_4 + x*(EXX_5 + x*(EXX_6 + EXX_7*x))))));
        const double w5 = y*(EAY_1 + y*(EAY_2 + y*(EAY_3 + y*(EAY_4 + y*(EAY_5 + y*(EAY_6 + EAY_7*y))))));
        const double w6 = y*(EBY_1 + y*(EBY_2 + y*(EBY_3 + y*(EBY_4 + y*(EBY_5 + y*(EBY_6 + EBY_7*y))))));
        const double w7 = y*(ECY_1 + y*(ECY_2 + y*(ECY_3 + y*(ECY_4 + y*(ECY_5 + y*(ECY_6 + ECY_7*y))))));
        const double w8 = y*(EXY_1 + y*(EXY_2 + y*(EXY_3 + y*(EXY_4 + y*(EXY_5 + y*(EXY_6 + EXY_7*y))))));
        const double w9 = z*(EZZ_1 + z*(EZZ_2 + z*(EZZ_3 + z*(EZZ_4 + z*(EZZ_5 + z*(EZZ_6 + EZZ_7*z))))));
        const double w10 = z*(EAZ_1 + z*(EAZ_2 + z*(EAZ_3 + z*(EAZ_4 + z*(EAZ_5 + z*(EAZ_6 + EAZ_7*z))))));
        const double w11 = z*(EBZ_1 + z*(EBZ_2 + z*(EBZ_3 + z*(EBZ_4 + z*(EBZ_5 + z*(EBZ_6 + EBZ_7*z))))));
        const double w12 = -rx*w11 + ry*w10 + w9;
        const double w13 = rz + z;
        const double w14 = w12 + w13;
        const double w15 = z*(EXZ_1 + z*(EXZ_2 + z*(EXZ_3 + z*(EXZ_4 + z*(EXZ_5 + z*(EXZ_6 + EXZ_7*z))))));
        const double w16 = z*(ECZ_1 + z*(ECZ_2 + z*(ECZ_3 + z*(ECZ_4 + z*(ECZ_5 + z*(ECZ_6 + ECZ_7*z))))));
        const double w17 = -ry*w16 + rz*w11 + w15;
        const double w18 = EB0Z*w14 + w17;
        const double w19 = w18 - w8;
        const double w20 = ry - y;
        const double w21 = y*(EYY_1 + y*(EYY_2 + y*(EYY_3 + y*(EYY_4 + y*(EYY_5 + y*(EYY_6 + EYY_7*y))))));
        const double w22 = z*(EYZ_1 + z*(EYZ_2 + z*(EYZ_3 + z*(EYZ_4 + z*(EYZ_5 + z*(EYZ_6 + EYZ_7*z))))));
        const double w23 = rx*w16 - rz*w10 + w22;
        const double w24 = -EA0Z*w14 + w23;
        const double w25 = -w21 + w24;
        const double w26 = w20 + w25;
        const double w27 = y*(EZY_1 + y*(EZY_2 + y*(EZY_3 + y*(EZY_4 + y*(EZY_5 + y*(EZY_6 + EZY_7*y))))));
        const double w28 = EA0Z*(ry + w23) - EB0Z*(rx + w17) + w12;
        const double w29 = -w27 + w28;
        const double w30 = w13 + w29;
        const double w31 = rx + w19;
        const double w32 = w26*w6 + w30*w7 + w31*w5;
        const double w33 = (w5*w5) + (w6*w6) + (w7*w7);
        const double w34 = (1.0/(w33 + 1.0));
        const double w35 = w34*(-rx*w33 + w19 + w26*w7 - w30*w6 + w32*w5);
        const double w36 = w34*(-w20*w33 + w25 + w30*w5 - w31*w7 + w32*w6);
        const double w37 = w20 + w36;
        const double w40 = w39*(EC0X*w37 - rx*w38 + w35);
        const double w41 = -w4 + w40;
        const double w42 = x*(EYX_1 + x*(EYX_2 + x*(EYX_3 + x*(EYX_4 + x*(EYX_5 + x*(EYX_6 + EYX_7*x))))));
        const double w43 = rx + w35;
        const double w44 = w39*(-EC0X*w43 - w20*w38 + w36);
        const double w45 = -w42 + w44;
        const double w46 = w20 + w45;
        const double w47 = x*(EZX_1 + x*(EZX_2 + x*(EZX_3 + x*(EZX_4 + x*(EZX_5 + x*(EZX_6 + EZX_7*x))))));
        const double w48 = w34*(-w13*w33 - w26*w5 + w29 + w31*w6 + w32*w7);
        const double w49 = w13 + w48;
        const double w50 = EC0X*w49;
        const double w51 = w39*(EC0X*w50 - w13*w38 + w48);
        const double w52 = -w47 + w51;
        const double w53 = w13 + w52;
        const double w54 = w3 + w41;
        const double w55 = w0*w54 + w1*w46 + w2*w53;
        const double w56 = (w0*w0) + (w1*w1) + (w2*w2);
        const double w57 = (1.0/(w56 + 1.0));
        deviation[0 * stride + i] = w57*(w0*w55 - w1*w53 + w2*w46 - w3*w56 + w41);
        deviation[1 * stride + i] = w57*(w0*w53 + w1*w55 - w2*w54 - w20*w56 + w45);
        deviation[2 * stride + i] = w57*(-w0*w46 + w1*w54 - w13*w56 + w2*w55 + w52);
    }
}

/*
 * Deviation of the tool point under polynomial error curves, to first order, constants folded once per call.
 * Source: Eqs. (1)-(4), (44). Operations: 225 per point, 262 once per call.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in curves: 126 values, mm/mm^k, rad/mm^k; coefficients of the powers 1 to 7 of the axis position, per component
 *     error (EXX_1 EXX_2 .. ECZ_7, last index fastest)
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0X EA0Z EB0Z)
 * in point: 3 values, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; tool point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void cframe_mill_tool_in_workpiece_deviation_first_order_curves(
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
    const double EC0X = parameters[0];
    const double EA0Z = parameters[1];
    const double EB0Z = parameters[2];
    const double rx = point[0];
    const double ry = point[1];
    const double rz = point[2];
    const double w0 = EBZ_1*rz - ECZ_1*ry + EXZ_1;
    const double w1 = EBZ_2*rz - ECZ_2*ry + EXZ_2;
    const double w2 = EBZ_3*rz - ECZ_3*ry + EXZ_3;
    const double w3 = EBZ_4*rz - ECZ_4*ry + EXZ_4;
    const double w4 = EBZ_5*rz - ECZ_5*ry + EXZ_5;
    const double w5 = EBZ_6*rz - ECZ_6*ry + EXZ_6;
    const double w6 = EBZ_7*rz - ECZ_7*ry + EXZ_7;
    const double w8 = EB0Z*rz + EC0X*ry;
    const double w9 = -EBY_1*rz + ECY_1*ry - EXY_1;
    const double w10 = -EBY_2*rz + ECY_2*ry - EXY_2;
    const double w11 = -EBY_3*rz + ECY_3*ry - EXY_3;
    const double w12 = -EBY_4*rz + ECY_4*ry - EXY_4;
    const double w13 = -EBY_5*rz + ECY_5*ry - EXY_5;
    const double w14 = -EBY_6*rz + ECY_6*ry - EXY_6;
    const double w15 = -EBY_7*rz + ECY_7*ry - EXY_7;
    const double w17 = -EBX_1*rz + ECX_1*ry - EXX_1;
    const double w18 = -EBX_2*rz + ECX_2*ry - EXX_2;
    const double w19 = -EBX_3*rz + ECX_3*ry - EXX_3;
    const double w20 = -EBX_4*rz + ECX_4*ry - EXX_4;
    const double w21 = -EBX_5*rz + ECX_5*ry - EXX_5;
    const double w22 = -EBX_6*rz + ECX_6*ry - EXX_6;
    const double w23 = -EBX_7*rz + ECX_7*ry - EXX_7;
    const double w36 = -EAZ_1*rz + ECZ_1*rx + EYZ_1;
    const double w37 = -EAZ_2*rz + ECZ_2*rx + EYZ_2;
    const double w38 = -EAZ_3*rz + ECZ_3*rx + EYZ_3;
    const double w39 = -EAZ_4*rz + ECZ_4*rx + EYZ_4;
    const double w40 = -EAZ_5*rz + ECZ_5*rx + EYZ_5;
    const double w41 = -EAZ_6*rz + ECZ_6*rx + EYZ_6;
    const double w42 = -EAZ_7*rz + ECZ_7*rx + EYZ_7;
    const double w44 = -EA0Z*rz - EC0X*rx;
    const double w45 = EAY_1*rz - ECY_1*rx - EYY_1;
    const double w46 = EAY_2*rz - ECY_2*rx - EYY_2;
    const double w47 = EAY_3*rz - ECY_3*rx - EYY_3;
    const double w48 = EAY_4*rz - ECY_4*rx - EYY_4;
    const double w49 = EAY_5*rz - ECY_5*rx - EYY_5;
    const double w50 = EAY_6*rz - ECY_6*rx - EYY_6;
    const double w51 = EAY_7*rz - ECY_7*rx - EYY_7;
    const double w53 = EAX_1*rz - ECX_1*rx - EYX_1;
    const double w54 = EAX_2*rz - ECX_2*rx - EYX_2;
    const double w55 = EAX_3*rz - ECX_3*rx - EYX_3;
    const double w56 = EAX_4*rz - ECX_4*rx - EYX_4;
    const double w57 = EAX_5*rz - ECX_5*rx - EYX_5;
    const double w58 = EAX_6*rz - ECX_6*rx - EYX_6;
    const double w59 = EAX_7*rz - ECX_7*rx - EYX_7;
    const double w70 = EAZ_1*ry - EBZ_1*rx + EZZ_1;
    const double w71 = EAZ_2*ry - EBZ_2*rx + EZZ_2;
    const double w72 = EAZ_3*ry - EBZ_3*rx + EZZ_3;
    const double w73 = EAZ_4*ry - EBZ_4*rx + EZZ_4;
    const double w74 = EAZ_5*ry - EBZ_5*rx + EZZ_5;
    const double w75 = EAZ_6*ry - EBZ_6*rx + EZZ_6;
    const double w76 = EAZ_7*ry - EBZ_7*rx + EZZ_7;
    const double w78 = EA0Z*ry - EB0Z*rx;
    const double w79 = -EAY_1*ry + EBY_1*rx - EZY_1;
    const double w80 = -EAY_2*ry + EBY_2*rx - EZY_2;
    const double w81 = -EAY_3*ry + EBY_3*rx - EZY_3;
    const double w82 = -EAY_4*ry + EBY_4*rx - EZY_4;
    const double w83 = -EAY_5*ry + EBY_5*rx - EZY_5;
    const double w84 = -EAY_6*ry + EBY_6*rx - EZY_6;
    const double w85 = -EAY_7*ry + EBY_7*rx - EZY_7;
    const double w87 = -EAX_1*ry + EBX_1*rx - EZX_1;
    const double w88 = -EAX_2*ry + EBX_2*rx - EZX_2;
    const double w89 = -EAX_3*ry + EBX_3*rx - EZX_3;
    const double w90 = -EAX_4*ry + EBX_4*rx - EZX_4;
    const double w91 = -EAX_5*ry + EBX_5*rx - EZX_5;
    const double w92 = -EAX_6*ry + EBX_6*rx - EZX_6;
    const double w93 = -EAX_7*ry + EBX_7*rx - EZX_7;
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
        const double x = positions[0 * stride + i];
        const double y = positions[1 * stride + i];
        const double z = positions[2 * stride + i];
        const double w7 = z*(w0 + z*(w1 + z*(w2 + z*(w3 + z*(w4 + z*(w5 + w6*z))))));
        const double w16 = y*(w9 + y*(w10 + y*(w11 + y*(w12 + y*(w13 + y*(w14 + w15*y))))));
        const double w24 = x*(w17 + x*(w18 + x*(w19 + x*(w20 + x*(w21 + x*(w22 + w23*x))))));
        const double w25 = w16 + w24 + w7 + w8;
        const double w26 = y*(EBY_1 + y*(EBY_2 + y*(EBY_3 + y*(EBY_4 + y*(EBY_5 + y*(EBY_6 + EBY_7*y))))));
        const double w27 = x*(EBX_1 + x*(EBX_2 + x*(EBX_3 + x*(EBX_4 + x*(EBX_5 + x*(EBX_6 + EBX_7*x))))));
        const double w28 = w27;
        const double w29 = EB0Z - w26 - w28;
        const double w30 = w29*z;
        const double w31 = y*(ECY_1 + y*(ECY_2 + y*(ECY_3 + y*(ECY_4 + y*(ECY_5 + y*(ECY_6 + ECY_7*y))))));
        const double w32 = x*(ECX_1 + x*(ECX_2 + x*(ECX_3 + x*(ECX_4 + x*(ECX_5 + x*(ECX_6 + ECX_7*x))))));
        const double w33 = w32;
        const double w34 = -EC0X - w31 - w33;
        const double w35 = w34*y;
        const double w43 = z*(w36 + z*(w37 + z*(w38 + z*(w39 + z*(w40 + z*(w41 + w42*z))))));
        const double w52 = y*(w45 + y*(w46 + y*(w47 + y*(w48 + y*(w49 + y*(w50 + w51*y))))));
        const double w60 = x*(w53 + x*(w54 + x*(w55 + x*(w56 + x*(w57 + x*(w58 + w59*x))))));
        const double w61 = w43 + w44 + w52 + w60;
        const double w62 = y*(EAY_1 + y*(EAY_2 + y*(EAY_3 + y*(EAY_4 + y*(EAY_5 + y*(EAY_6 + EAY_7*y))))));
        const double w63 = w62;
        const double w64 = x*(EAX_1 + x*(EAX_2 + x*(EAX_3 + x*(EAX_4 + x*(EAX_5 + x*(EAX_6 + EAX_7*x))))));
        const double w65 = w64;
        const double w66 = -EA0Z + w63 + w65;
        const double w67 = w66*z;
        const double w68 = w32;
        const double w69 = w68*x;
        const double w77 = z*(w70 + z*(w71 + z*(w72 + z*(w73 + z*(w74 + z*(w75 + w76*z))))));
        const double w86 = y*(w79 + y*(w80 + y*(w81 + y*(w82 + y*(w83 + y*(w84 + w85*y))))));
        const double w94 = x*(w87 + x*(w88 + x*(w89 + x*(w90 + x*(w91 + x*(w92 + w93*x))))));
        const double w95 = w77 + w78 + w86 + w94;
        const double w96 = w62;
        const double w97 = w64;
        const double w98 = w96 + w97;
        const double w99 = w98*y;
        const double w100 = w27;
        const double w101 = -w100*x;
        deviation[0 * stride + i] = w25 + w30 + w35;
        deviation[1 * stride + i] = w61 + w67 + w69;
        deviation[2 * stride + i] = w101 + w95 + w99;
    }
}

/*
 * Positioning error of a ball bar between a tool ball and a workpiece ball, exact.
 * Source: Eqs. (5), (6). Operations: 171 per point, 3 once per call.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0X EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * in ball: 3 rows of stride, mm; point in the workpiece frame (bx by bz)
 * in length: 1 rows of stride, mm; ideal length of the ball bar (length)
 * out error: 4 rows of stride, mm; positioning error E, then its components E_x, E_y, E_z (e ex ey ez)
 */
void cframe_mill_ballbar_error(
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
    const double EC0X = parameters[0];
    const double EA0Z = parameters[1];
    const double EB0Z = parameters[2];
    const double w22 = (EC0X*EC0X);
    const double w23 = (1.0/(w22 + 1.0));
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
        const double w40 = w39*(EAX*w37 - EBX*w35 + ECX*w29 - w0*w38 + w25);
        const double w41 = w39*(EAX*w35 + EBX*w37 - ECX*w36 + w28 - w38*w7);
        const double w42 = w39*(-EAX*w29 + EBX*w36 + ECX*w37 - w2*w38 + w34);
        const double w43 = -bx + w0;
        const double w44 = -by + w7;
        const double w45 = -bz + w2;
        const double w46 = w40 + w43;
        const double w47 = w41 + w44;
        const double w48 = w42 + w45;
        const double w49 = sqrt((w43*w43) + (w44*w44) + (w45*w45));
        const double w50 = sqrt((w46*w46) + (w47*w47) + (w48*w48));
        const double e = -length_ + w49 + (w40*(w43 + w46) + w41*(w44 + w47) + w42*(w45 + w48))/(w49 + w50);
        const double w51 = e/w50;
        error[0 * stride + i] = e;
        error[1 * stride + i] = w46*w51;
        error[2 * stride + i] = w47*w51;
        error[3 * stride + i] = w48*w51;
    }
}

/*
 * Moves of the linear axes that displace the ideal tool point by the given vector.
 * Source: Eqs. (53)-(55), inverse. Operations: 2 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in deviation: 3 rows of stride, mm; displacement of the tool point in the workpiece frame (dx dy dz)
 * out moves: 3 rows of stride, mm; moves of X Y Z (move_x move_y move_z)
 */
void cframe_mill_correction(
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
        moves[0 * stride + i] = -dx;
        moves[1 * stride + i] = -dy;
        moves[2 * stride + i] = dz;
    }
}

/*
 * Motion equation of X: displacement of the workpiece point since home, to first order.
 * Source: Eqs. (7)-(11). Operations: 15 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0X EA0Z EB0Z)
 * in workpiece_point: 3 rows of stride, mm; point in the workpiece frame (rWx rWy rWz)
 * out displacement: 3 rows of stride, mm; workpiece point, displacement since home, in the bed frame (dx dy dz)
 */
void cframe_mill_motion_X(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT workpiece_point,
    double *TRUEAXIS_RESTRICT displacement)
{
    /* once per call */
    const double EC0X = parameters[0];
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
        const double rWx = workpiece_point[0 * stride + i];
        const double rWy = workpiece_point[1 * stride + i];
        const double rWz = workpiece_point[2 * stride + i];
        displacement[0 * stride + i] = EBX*rWz - ECX*rWy + EXX + x;
        displacement[1 * stride + i] = -EAX*rWz + EC0X*x + ECX*rWx + EYX;
        displacement[2 * stride + i] = EAX*rWy - EBX*rWx + EZX;
    }
}

/*
 * Motion equation of Y: displacement of the workpiece point since home, to first order.
 * Source: Eqs. (7)-(11). Operations: 13 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0X EA0Z EB0Z)
 * in workpiece_point: 3 rows of stride, mm; point in the workpiece frame (rWx rWy rWz)
 * out displacement: 3 rows of stride, mm; workpiece point, displacement since home, in the bed frame (dx dy dz)
 */
void cframe_mill_motion_Y(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT workpiece_point,
    double *TRUEAXIS_RESTRICT displacement)
{
    (void)parameters;
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
        displacement[0 * stride + i] = EBY*rWz - ECY*rWy + EXY;
        displacement[1 * stride + i] = -EAY*rWz + ECY*rWx + EYY + y;
        displacement[2 * stride + i] = EAY*rWy - EBY*rWx + EZY;
    }
}

/*
 * Motion equation of Z: displacement of the tool point since home, to first order.
 * Source: Eqs. (7)-(11). Operations: 17 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0X EA0Z EB0Z)
 * in tool_point: 3 rows of stride, mm; point in the tool frame (rTx rTy rTz)
 * out displacement: 3 rows of stride, mm; tool point, displacement since home, in the bed frame (dx dy dz)
 */
void cframe_mill_motion_Z(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT tool_point,
    double *TRUEAXIS_RESTRICT displacement)
{
    /* once per call */
    const double EA0Z = parameters[1];
    const double EB0Z = parameters[2];
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
        displacement[0 * stride + i] = EB0Z*z + EBZ*rTz - ECZ*rTy + EXZ;
        displacement[1 * stride + i] = -EA0Z*z - EAZ*rTz + ECZ*rTx + EYZ;
        displacement[2 * stride + i] = EAZ*rTy - EBZ*rTx + EZZ + z;
    }
}

/*
 * Motion equation of X and Y: displacement of the workpiece point since home, to first order.
 * Source: Eqs. (7)-(11). Operations: 32 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0X EA0Z EB0Z)
 * in workpiece_point: 3 rows of stride, mm; point in the workpiece frame (rWx rWy rWz)
 * out displacement: 3 rows of stride, mm; workpiece point, displacement since home, in the bed frame (dx dy dz)
 */
void cframe_mill_motion_XY(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT workpiece_point,
    double *TRUEAXIS_RESTRICT displacement)
{
    /* once per call */
    const double EC0X = parameters[0];
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
        const double w0 = rWx + x;
        displacement[0 * stride + i] = EBX*rWz + EBY*rWz - ECX*rWy - ECY*rWy + EXX + EXY + x;
        displacement[1 * stride + i] = -EAX*rWz - EAY*rWz + EC0X*x + ECX*rWx + ECY*w0 + EYX + EYY + y;
        displacement[2 * stride + i] = EAX*rWy + EAY*rWy - EBX*rWx - EBY*w0 + EZX + EZY;
    }
}

/*
 * Motion equation of X and Z: displacement of the workpiece point minus tool point since home, to first order.
 * Source: Eqs. (7)-(11). Operations: 35 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0X EA0Z EB0Z)
 * in workpiece_point: 3 rows of stride, mm; point in the workpiece frame (rWx rWy rWz)
 * in tool_point: 3 rows of stride, mm; point in the tool frame (rTx rTy rTz)
 * out displacement: 3 rows of stride, mm; workpiece point minus tool point, displacement since home, in the bed frame
 *     (dx dy dz)
 */
void cframe_mill_motion_XZ(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT workpiece_point,
    const double *TRUEAXIS_RESTRICT tool_point,
    double *TRUEAXIS_RESTRICT displacement)
{
    /* once per call */
    const double EC0X = parameters[0];
    const double EA0Z = parameters[1];
    const double EB0Z = parameters[2];
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
        const double rWx = workpiece_point[0 * stride + i];
        const double rWy = workpiece_point[1 * stride + i];
        const double rWz = workpiece_point[2 * stride + i];
        const double rTx = tool_point[0 * stride + i];
        const double rTy = tool_point[1 * stride + i];
        const double rTz = tool_point[2 * stride + i];
        displacement[0 * stride + i] = -EB0Z*z + EBX*rWz - EBZ*rTz - ECX*rWy + ECZ*rTy + EXX - EXZ + x;
        displacement[1 * stride + i] = EA0Z*z - EAX*rWz + EAZ*rTz + EC0X*x + ECX*rWx - ECZ*rTx + EYX - EYZ;
        displacement[2 * stride + i] = EAX*rWy - EAZ*rTy - EBX*rWx + EBZ*rTx + EZX - EZZ - z;
    }
}

/*
 * Motion equation of Y and Z: displacement of the workpiece point minus tool point since home, to first order.
 * Source: Eqs. (7)-(11). Operations: 33 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0X EA0Z EB0Z)
 * in workpiece_point: 3 rows of stride, mm; point in the workpiece frame (rWx rWy rWz)
 * in tool_point: 3 rows of stride, mm; point in the tool frame (rTx rTy rTz)
 * out displacement: 3 rows of stride, mm; workpiece point minus tool point, displacement since home, in the bed frame
 *     (dx dy dz)
 */
void cframe_mill_motion_YZ(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT workpiece_point,
    const double *TRUEAXIS_RESTRICT tool_point,
    double *TRUEAXIS_RESTRICT displacement)
{
    /* once per call */
    const double EA0Z = parameters[1];
    const double EB0Z = parameters[2];
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
        displacement[0 * stride + i] = -EB0Z*z + EBY*rWz - EBZ*rTz - ECY*rWy + ECZ*rTy + EXY - EXZ;
        displacement[1 * stride + i] = EA0Z*z - EAY*rWz + EAZ*rTz + ECY*rWx - ECZ*rTx + EYY - EYZ + y;
        displacement[2 * stride + i] = EAY*rWy - EAZ*rTy - EBY*rWx + EBZ*rTx + EZY - EZZ - z;
    }
}
