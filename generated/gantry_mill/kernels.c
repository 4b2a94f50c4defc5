/* Generated from machines/gantry_mill.toml, do not edit; regenerate with: trueaxis derive machines/gantry_mill.toml
 * SPDX-License-Identifier: MIT
 * Kernels of Gantry mill: geometric error model in C17.
 * Spec: sha256 436048e019673a322f57c00f796d232113d4f9b52648375eb9f68dfede1c3920
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

int gantry_mill_kernel_abi(void)
{
    return TRUEAXIS_KERNEL_ABI;
}

const char *gantry_mill_spec_hash(void)
{
    return "436048e019673a322f57c00f796d232113d4f9b52648375eb9f68dfede1c3920";
}

/*
 * Ideal position of a tool point in the workpiece frame.
 * Source: Eqs. (1)-(4) without errors. Operations: 3 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0Y EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out ideal: 3 rows of stride, mm; tool point in the workpiece frame, without errors (px py pz)
 */
void gantry_mill_tool_in_workpiece_ideal(
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
        ideal[0 * stride + i] = rx + x;
        ideal[1 * stride + i] = ry + y;
        ideal[2 * stride + i] = rz + z;
    }
}

/*
 * Deviation of a tool point in the workpiece frame, exact.
 * Source: Eqs. (1)-(4). Operations: 67 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0Y EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; tool point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void gantry_mill_tool_in_workpiece_deviation(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation)
{
    /* once per call */
    const double EC0Y = parameters[0];
    const double EA0Z = parameters[1];
    const double EB0Z = parameters[2];
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
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
        deviation[0 * stride + i] = EBX*w11 - ECX*w17 + EXX + w18;
        deviation[1 * stride + i] = -EAX*w11 + ECX*w19 + EYX + w16;
        deviation[2 * stride + i] = EAX*w17 - EBX*w19 + EZX + w10;
    }
}

/*
 * Deviation of a tool point in the workpiece frame, to first order in the errors.
 * Source: Eqs. (1)-(4). Operations: 56 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0Y EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; tool point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void gantry_mill_tool_in_workpiece_deviation_first_order(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation)
{
    /* once per call */
    const double EC0Y = parameters[0];
    const double EA0Z = parameters[1];
    const double EB0Z = parameters[2];
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
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
        const double w1 = ry + y;
        const double w2 = EBZ*rz - ECZ*ry + EXZ;
        const double w3 = EB0Z*w0 + w2;
        const double w4 = EBY*w0 - ECY*ry + EXY + w3;
        const double w5 = -EC0Y*w1 + w4;
        const double w6 = -EAZ*rz + ECZ*rx + EYZ;
        const double w7 = -EA0Z*w0 + w6;
        const double w8 = -EAY*w0 + ECY*rx + EYY + w7;
        const double w9 = EC0Y*rx + w8;
        const double w10 = EAZ*ry - EBZ*rx + EZZ;
        const double w11 = EA0Z*ry - EB0Z*rx + w10;
        const double w12 = EAY*ry - EBY*rx + EZY + w11;
        deviation[0 * stride + i] = EBX*w0 - ECX*w1 + EXX + w5;
        deviation[1 * stride + i] = -EAX*w0 + ECX*rx + EYX + w9;
        deviation[2 * stride + i] = EAX*w1 - EBX*rx + EZX + w12;
    }
}

/*
 * Sensitivity of a tool point in the workpiece frame to every error, at the error-free machine.
 * Source: Eqs. (1)-(4), first order. Operations: 7 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0Y EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out sensitivity: 63 rows of stride, mm/mm, mm/rad; derivative of the deviation by each component error, then by each
 *     location error (dx_EXX dx_EYX .. dz_EB0Z, last index fastest)
 */
void gantry_mill_tool_in_workpiece_sensitivity(
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
        const double y = positions[1 * stride + i];
        const double z = positions[2 * stride + i];
        const double rx = point[0 * stride + i];
        const double ry = point[1 * stride + i];
        const double rz = point[2 * stride + i];
        const double dx_EBX = rz + z;
        const double dz_EAX = ry + y;
        const double dx_ECX = -dz_EAX;
        const double dx_ECY = -ry;
        const double dy_EAX = -dx_EBX;
        const double dz_EBX = -rx;
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
        sensitivity[16 * stride + i] = rz;
        sensitivity[17 * stride + i] = dx_ECY;
        sensitivity[18 * stride + i] = dx_ECX;
        sensitivity[19 * stride + i] = 0.0;
        sensitivity[20 * stride + i] = dx_EBX;
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
        sensitivity[32 * stride + i] = rx;
        sensitivity[33 * stride + i] = 0.0;
        sensitivity[34 * stride + i] = 1.0;
        sensitivity[35 * stride + i] = 0.0;
        sensitivity[36 * stride + i] = -rz;
        sensitivity[37 * stride + i] = 0.0;
        sensitivity[38 * stride + i] = rx;
        sensitivity[39 * stride + i] = rx;
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
        sensitivity[51 * stride + i] = ry;
        sensitivity[52 * stride + i] = dz_EBX;
        sensitivity[53 * stride + i] = 0.0;
        sensitivity[54 * stride + i] = 0.0;
        sensitivity[55 * stride + i] = 0.0;
        sensitivity[56 * stride + i] = 1.0;
        sensitivity[57 * stride + i] = ry;
        sensitivity[58 * stride + i] = dz_EBX;
        sensitivity[59 * stride + i] = 0.0;
        sensitivity[60 * stride + i] = 0.0;
        sensitivity[61 * stride + i] = ry;
        sensitivity[62 * stride + i] = dz_EBX;
    }
}

/*
 * Ideal position of a tool point in the bed frame.
 * Source: Eqs. (1)-(4) without errors. Operations: 3 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0Y EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out ideal: 3 rows of stride, mm; tool point in the bed frame, without errors (px py pz)
 */
void gantry_mill_tool_in_bed_ideal(
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
        ideal[0 * stride + i] = rx + x;
        ideal[1 * stride + i] = ry + y;
        ideal[2 * stride + i] = rz + z;
    }
}

/*
 * Deviation of a tool point in the bed frame, exact.
 * Source: Eqs. (1)-(4). Operations: 67 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0Y EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; tool point in the bed frame, actual minus ideal (dx dy dz)
 */
void gantry_mill_tool_in_bed_deviation(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation)
{
    /* once per call */
    const double EC0Y = parameters[0];
    const double EA0Z = parameters[1];
    const double EB0Z = parameters[2];
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
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
        deviation[0 * stride + i] = EBX*w11 - ECX*w17 + EXX + w18;
        deviation[1 * stride + i] = -EAX*w11 + ECX*w19 + EYX + w16;
        deviation[2 * stride + i] = EAX*w17 - EBX*w19 + EZX + w10;
    }
}

/*
 * Deviation of a tool point in the bed frame, to first order in the errors.
 * Source: Eqs. (1)-(4). Operations: 56 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0Y EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; tool point in the bed frame, actual minus ideal (dx dy dz)
 */
void gantry_mill_tool_in_bed_deviation_first_order(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation)
{
    /* once per call */
    const double EC0Y = parameters[0];
    const double EA0Z = parameters[1];
    const double EB0Z = parameters[2];
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
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
        const double w1 = ry + y;
        const double w2 = EBZ*rz - ECZ*ry + EXZ;
        const double w3 = EB0Z*w0 + w2;
        const double w4 = EBY*w0 - ECY*ry + EXY + w3;
        const double w5 = -EC0Y*w1 + w4;
        const double w6 = -EAZ*rz + ECZ*rx + EYZ;
        const double w7 = -EA0Z*w0 + w6;
        const double w8 = -EAY*w0 + ECY*rx + EYY + w7;
        const double w9 = EC0Y*rx + w8;
        const double w10 = EAZ*ry - EBZ*rx + EZZ;
        const double w11 = EA0Z*ry - EB0Z*rx + w10;
        const double w12 = EAY*ry - EBY*rx + EZY + w11;
        deviation[0 * stride + i] = EBX*w0 - ECX*w1 + EXX + w5;
        deviation[1 * stride + i] = -EAX*w0 + ECX*rx + EYX + w9;
        deviation[2 * stride + i] = EAX*w1 - EBX*rx + EZX + w12;
    }
}

/*
 * Sensitivity of a tool point in the bed frame to every error, at the error-free machine.
 * Source: Eqs. (1)-(4), first order. Operations: 7 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0Y EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out sensitivity: 63 rows of stride, mm/mm, mm/rad; derivative of the deviation by each component error, then by each
 *     location error (dx_EXX dx_EYX .. dz_EB0Z, last index fastest)
 */
void gantry_mill_tool_in_bed_sensitivity(
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
        const double y = positions[1 * stride + i];
        const double z = positions[2 * stride + i];
        const double rx = point[0 * stride + i];
        const double ry = point[1 * stride + i];
        const double rz = point[2 * stride + i];
        const double dx_EBX = rz + z;
        const double dz_EAX = ry + y;
        const double dx_ECX = -dz_EAX;
        const double dx_ECY = -ry;
        const double dy_EAX = -dx_EBX;
        const double dz_EBX = -rx;
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
        sensitivity[16 * stride + i] = rz;
        sensitivity[17 * stride + i] = dx_ECY;
        sensitivity[18 * stride + i] = dx_ECX;
        sensitivity[19 * stride + i] = 0.0;
        sensitivity[20 * stride + i] = dx_EBX;
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
        sensitivity[32 * stride + i] = rx;
        sensitivity[33 * stride + i] = 0.0;
        sensitivity[34 * stride + i] = 1.0;
        sensitivity[35 * stride + i] = 0.0;
        sensitivity[36 * stride + i] = -rz;
        sensitivity[37 * stride + i] = 0.0;
        sensitivity[38 * stride + i] = rx;
        sensitivity[39 * stride + i] = rx;
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
        sensitivity[51 * stride + i] = ry;
        sensitivity[52 * stride + i] = dz_EBX;
        sensitivity[53 * stride + i] = 0.0;
        sensitivity[54 * stride + i] = 0.0;
        sensitivity[55 * stride + i] = 0.0;
        sensitivity[56 * stride + i] = 1.0;
        sensitivity[57 * stride + i] = ry;
        sensitivity[58 * stride + i] = dz_EBX;
        sensitivity[59 * stride + i] = 0.0;
        sensitivity[60 * stride + i] = 0.0;
        sensitivity[61 * stride + i] = ry;
        sensitivity[62 * stride + i] = dz_EBX;
    }
}

/*
 * Ideal position of a workpiece point in the bed frame.
 * Source: Eqs. (1)-(4) without errors. Operations: 0 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0Y EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the workpiece frame (rx ry rz)
 * out ideal: 3 rows of stride, mm; workpiece point in the bed frame, without errors (px py pz)
 */
void gantry_mill_workpiece_in_bed_ideal(
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
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0Y EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the workpiece frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; workpiece point in the bed frame, actual minus ideal (dx dy dz)
 */
void gantry_mill_workpiece_in_bed_deviation(
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
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0Y EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the workpiece frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; workpiece point in the bed frame, actual minus ideal (dx dy dz)
 */
void gantry_mill_workpiece_in_bed_deviation_first_order(
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
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0Y EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the workpiece frame (rx ry rz)
 * out sensitivity: 63 rows of stride, mm/mm, mm/rad; derivative of the deviation by each component error, then by each
 *     location error (dx_EXX dx_EYX .. dz_EB0Z, last index fastest)
 */
void gantry_mill_workpiece_in_bed_sensitivity(
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
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0Y EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the bed frame (rx ry rz)
 * out ideal: 3 rows of stride, mm; bed point in the workpiece frame, without errors (px py pz)
 */
void gantry_mill_bed_in_workpiece_ideal(
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
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0Y EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the bed frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; bed point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void gantry_mill_bed_in_workpiece_deviation(
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
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0Y EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the bed frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; bed point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void gantry_mill_bed_in_workpiece_deviation_first_order(
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
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0Y EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the bed frame (rx ry rz)
 * out sensitivity: 63 rows of stride, mm/mm, mm/rad; derivative of the deviation by each component error, then by each
 *     location error (dx_EXX dx_EYX .. dz_EB0Z, last index fastest)
 */
void gantry_mill_bed_in_workpiece_sensitivity(
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
 * Source: Eq. (4). Operations: 71 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0Y EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out position: 3 rows of stride, mm; actual position P_T^W of the tool point in the workpiece frame (px py pz)
 */
void gantry_mill_tool_in_workpiece_position(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT position)
{
    /* once per call */
    const double EC0Y = parameters[0];
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
        const double w19 = EBX*w11 - ECX*w17 + EXX + w18;
        const double w20 = rx + x;
        const double w21 = rx + w18;
        const double w22 = -EAX*w11 + ECX*w21 + EYX + w16;
        const double w23 = EAX*w17 - EBX*w21 + EZX + w10;
        position[0 * stride + i] = w19 + w20;
        position[1 * stride + i] = w12 + w22;
        position[2 * stride + i] = w0 + w23;
    }
}

/*
 * Actual position of the tool point in the workpiece frame, to first order.
 * Source: Eq. (4). Operations: 60 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0Y EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out position: 3 rows of stride, mm; actual position P_T^W of the tool point in the workpiece frame (px py pz)
 */
void gantry_mill_tool_in_workpiece_position_first_order(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT position)
{
    /* once per call */
    const double EC0Y = parameters[0];
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
        const double w1 = ry + y;
        const double w2 = EBZ*rz - ECZ*ry + EXZ;
        const double w3 = EB0Z*w0 + w2;
        const double w4 = EBY*w0 - ECY*ry + EXY + w3;
        const double w5 = -EC0Y*w1 + w4;
        const double w6 = EBX*w0 - ECX*w1 + EXX + w5;
        const double w7 = rx + x;
        const double w8 = -EAZ*rz + ECZ*rx + EYZ;
        const double w9 = -EA0Z*w0 + w8;
        const double w10 = -EAY*w0 + ECY*rx + EYY + w9;
        const double w11 = EC0Y*rx + w10;
        const double w12 = -EAX*w0 + ECX*rx + EYX + w11;
        const double w13 = EAZ*ry - EBZ*rx + EZZ;
        const double w14 = EA0Z*ry - EB0Z*rx + w13;
        const double w15 = EAY*ry - EBY*rx + EZY + w14;
        const double w16 = EAX*w1 - EBX*rx + EZX + w15;
        position[0 * stride + i] = w6 + w7;
        position[1 * stride + i] = w1 + w12;
        position[2 * stride + i] = w0 + w16;
    }
}

/*
 * Deviation of the tool point under polynomial error curves, exact.
 * Source: Eqs. (1)-(4), (44). Operations: 301 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in curves: 126 values, mm/mm^k, rad/mm^k; coefficients of the powers 1 to 7 of the axis position, per component
 *     error (EXX_1 EXX_2 .. ECZ_7, last index fastest)
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0Y EA0Z EB0Z)
 * in point: 3 values, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; tool point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void gantry_mill_tool_in_workpiece_deviation_curves(
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
    const double EC0Y = parameters[0];
    const double EA0Z = parameters[1];
    const double EB0Z = parameters[2];
    const double rx = point[0];
    const double ry = point[1];
    const double rz = point[2];
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
        const double x = positions[0 * stride + i];
        const double y = positions[1 * stride + i];
        const double z = positions[2 * stride + i];
        const double w0 = rz + z;
        const double w1 = z*(EZZ_1 + z*(EZZ_2 + z*(EZZ_3 + z*(EZZ_4 + z*(EZZ_5 + z*(EZZ_6 + EZZ_7*z))))));
        const double w2 = z*(EAZ_1 + z*(EAZ_2 + z*(EAZ_3 + z*(EAZ_4 + z*(EAZ_5 + z*(EAZ_6 + EAZ_7*z))))));
        const double w3 = z*(EBZ_1 + z*(EBZ_2 + z*(EBZ_3 + z*(EBZ_4 + z*(EBZ_5 + z*(EBZ_6 + EBZ_7*z))))));
        const double w4 = -rx*w3 + ry*w2 + w1;
        const double w5 = w0 + w4;
        const double w6 = z*(EYZ_1 + z*(EYZ_2 + z*(EYZ_3 + z*(EYZ_4 + z*(EYZ_5 + z*(EYZ_6 + EYZ_7*z))))));
        const double w7 = z*(ECZ_1 + z*(ECZ_2 + z*(ECZ_3 + z*(ECZ_4 + z*(ECZ_5 + z*(ECZ_6 + ECZ_7*z))))));
        const double w8 = rx*w7 - rz*w2 + w6;
        const double w9 = -EA0Z*w5 + w8;
        const double w10 = ry + w9;
        const double w11 = z*(EXZ_1 + z*(EXZ_2 + z*(EXZ_3 + z*(EXZ_4 + z*(EXZ_5 + z*(EXZ_6 + EXZ_7*z))))));
        const double w12 = -ry*w7 + rz*w3 + w11;
        const double w13 = EB0Z*w5 + w12;
        const double w14 = rx + w13;
        const double w15 = y*(EZY_1 + y*(EZY_2 + y*(EZY_3 + y*(EZY_4 + y*(EZY_5 + y*(EZY_6 + EZY_7*y))))));
        const double w16 = y*(EAY_1 + y*(EAY_2 + y*(EAY_3 + y*(EAY_4 + y*(EAY_5 + y*(EAY_6 + EAY_7*y))))));
        const double w17 = y*(EBY_1 + y*(EBY_2 + y*(EBY_3 + y*(EBY_4 + y*(EBY_5 + y*(EBY_6 + EBY_7*y))))));
        const double w18 = EA0Z*(ry + w8) - EB0Z*(rx + w12) + w4;
        const double w19 = w10*w16 - w14*w17 + w15 + w18;
        const double w20 = w0 + w19;
        const double w21 = ry + y;
        const double w22 = w0 + w18;
        const double w23 = y*(EXY_1 + y*(EXY_2 + y*(EXY_3 + y*(EXY_4 + y*(EXY_5 + y*(EXY_6 + EXY_7*y))))));
        const double w24 = y*(ECY_1 + y*(ECY_2 + y*(ECY_3 + y*(ECY_4 + y*(ECY_5 + y*(ECY_6 + ECY_7*y))))));
        const double w25 = -w10*w24 + w13 + w17*w22 + w23;
        const double w26 = y*(EYY_1 + y*(EYY_2 + y*(EYY_3 + y*(EYY_4 + y*(EYY_5 + y*(EYY_6 + EYY_7*y))))));
        const double w27 = w14*w24 - w16*w22 + w26 + w9;
        const double w28 = EC0Y*(rx + w25) + w27;
        const double w29 = w21 + w28;
        const double w30 = x*(EXX_1 + x*(EXX_2 + x*(EXX_3 + x*(EXX_4 + x*(EXX_5 + x*(EXX_6 + EXX_7*x))))));
        const double w31 = x*(EBX_1 + x*(EBX_2 + x*(EBX_3 + x*(EBX_4 + x*(EBX_5 + x*(EBX_6 + EBX_7*x))))));
        const double w32 = x*(ECX_1 + x*(ECX_2 + x*(ECX_3 + x*(ECX_4 + x*(ECX_5 + x*(ECX_6 + ECX_7*x))))));
        const double w33 = -EC0Y*(w21 + w27) + w25;
        const double w34 = rx + w33;
        const double w35 = x*(EYX_1 + x*(EYX_2 + x*(EYX_3 + x*(EYX_4 + x*(EYX_5 + x*(EYX_6 + EYX_7*x))))));
        const double w36 = x*(EAX_1 + x*(EAX_2 + x*(EAX_3 + x*(EAX_4 + x*(EAX_5 + x*(EAX_6 + EAX_7*x))))));
        const double w37 = x*(EZX_1 + x*(EZX_2 + x*(EZX_3 + x*(EZX_4 + x*(EZX_5 + x*(EZX_6 + EZX_7*x))))));
        deviation[0 * stride + i] = w20*w31 - w29*w32 + w30 + w33;
        deviation[1 * stride + i] = -w20*w36 + w28 + w32*w34 + w35;
        deviation[2 * stride + i] = w19 + w29*w36 - w31*w34 + w37;
    }
}

/*
 * Deviation of the tool point under polynomial error curves, to first order, constants folded once per call.
 * Source: Eqs. (1)-(4), (44). Operations: 206 per point, 261 once per call.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in curves: 126 values, mm/mm^k, rad/mm^k; coefficients of the powers 1 to 7 of the axis position, per component
 *     error (EXX_1 EXX_2 .. ECZ_7, last index fastest)
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0Y EA0Z EB0Z)
 * in point: 3 values, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; tool point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void gantry_mill_tool_in_workpiece_deviation_first_order_curves(
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
    const double EC0Y = parameters[0];
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
    const double w8 = EB0Z*rz - EC0Y*ry;
    const double w9 = EBY_1*rz - ECY_1*ry + EXY_1;
    const double w10 = EBY_2*rz - ECY_2*ry + EXY_2;
    const double w11 = EBY_3*rz - ECY_3*ry + EXY_3;
    const double w12 = EBY_4*rz - ECY_4*ry + EXY_4;
    const double w13 = EBY_5*rz - ECY_5*ry + EXY_5;
    const double w14 = EBY_6*rz - ECY_6*ry + EXY_6;
    const double w15 = EBY_7*rz - ECY_7*ry + EXY_7;
    const double w17 = EBX_1*rz - ECX_1*ry + EXX_1;
    const double w18 = EBX_2*rz - ECX_2*ry + EXX_2;
    const double w19 = EBX_3*rz - ECX_3*ry + EXX_3;
    const double w20 = EBX_4*rz - ECX_4*ry + EXX_4;
    const double w21 = EBX_5*rz - ECX_5*ry + EXX_5;
    const double w22 = EBX_6*rz - ECX_6*ry + EXX_6;
    const double w23 = EBX_7*rz - ECX_7*ry + EXX_7;
    const double w33 = -EAZ_1*rz + ECZ_1*rx + EYZ_1;
    const double w34 = -EAZ_2*rz + ECZ_2*rx + EYZ_2;
    const double w35 = -EAZ_3*rz + ECZ_3*rx + EYZ_3;
    const double w36 = -EAZ_4*rz + ECZ_4*rx + EYZ_4;
    const double w37 = -EAZ_5*rz + ECZ_5*rx + EYZ_5;
    const double w38 = -EAZ_6*rz + ECZ_6*rx + EYZ_6;
    const double w39 = -EAZ_7*rz + ECZ_7*rx + EYZ_7;
    const double w41 = -EA0Z*rz + EC0Y*rx;
    const double w42 = -EAY_1*rz + ECY_1*rx + EYY_1;
    const double w43 = -EAY_2*rz + ECY_2*rx + EYY_2;
    const double w44 = -EAY_3*rz + ECY_3*rx + EYY_3;
    const double w45 = -EAY_4*rz + ECY_4*rx + EYY_4;
    const double w46 = -EAY_5*rz + ECY_5*rx + EYY_5;
    const double w47 = -EAY_6*rz + ECY_6*rx + EYY_6;
    const double w48 = -EAY_7*rz + ECY_7*rx + EYY_7;
    const double w50 = -EAX_1*rz + ECX_1*rx + EYX_1;
    const double w51 = -EAX_2*rz + ECX_2*rx + EYX_2;
    const double w52 = -EAX_3*rz + ECX_3*rx + EYX_3;
    const double w53 = -EAX_4*rz + ECX_4*rx + EYX_4;
    const double w54 = -EAX_5*rz + ECX_5*rx + EYX_5;
    const double w55 = -EAX_6*rz + ECX_6*rx + EYX_6;
    const double w56 = -EAX_7*rz + ECX_7*rx + EYX_7;
    const double w64 = EAZ_1*ry - EBZ_1*rx + EZZ_1;
    const double w65 = EAZ_2*ry - EBZ_2*rx + EZZ_2;
    const double w66 = EAZ_3*ry - EBZ_3*rx + EZZ_3;
    const double w67 = EAZ_4*ry - EBZ_4*rx + EZZ_4;
    const double w68 = EAZ_5*ry - EBZ_5*rx + EZZ_5;
    const double w69 = EAZ_6*ry - EBZ_6*rx + EZZ_6;
    const double w70 = EAZ_7*ry - EBZ_7*rx + EZZ_7;
    const double w72 = EA0Z*ry - EB0Z*rx;
    const double w73 = EAY_1*ry - EBY_1*rx + EZY_1;
    const double w74 = EAY_2*ry - EBY_2*rx + EZY_2;
    const double w75 = EAY_3*ry - EBY_3*rx + EZY_3;
    const double w76 = EAY_4*ry - EBY_4*rx + EZY_4;
    const double w77 = EAY_5*ry - EBY_5*rx + EZY_5;
    const double w78 = EAY_6*ry - EBY_6*rx + EZY_6;
    const double w79 = EAY_7*ry - EBY_7*rx + EZY_7;
    const double w81 = EAX_1*ry - EBX_1*rx + EZX_1;
    const double w82 = EAX_2*ry - EBX_2*rx + EZX_2;
    const double w83 = EAX_3*ry - EBX_3*rx + EZX_3;
    const double w84 = EAX_4*ry - EBX_4*rx + EZX_4;
    const double w85 = EAX_5*ry - EBX_5*rx + EZX_5;
    const double w86 = EAX_6*ry - EBX_6*rx + EZX_6;
    const double w87 = EAX_7*ry - EBX_7*rx + EZX_7;
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
        const double w28 = EB0Z + w26 + w27;
        const double w29 = w28*z;
        const double w30 = x*(ECX_1 + x*(ECX_2 + x*(ECX_3 + x*(ECX_4 + x*(ECX_5 + x*(ECX_6 + ECX_7*x))))));
        const double w31 = -EC0Y - w30;
        const double w32 = w31*y;
        const double w40 = z*(w33 + z*(w34 + z*(w35 + z*(w36 + z*(w37 + z*(w38 + w39*z))))));
        const double w49 = y*(w42 + y*(w43 + y*(w44 + y*(w45 + y*(w46 + y*(w47 + w48*y))))));
        const double w57 = x*(w50 + x*(w51 + x*(w52 + x*(w53 + x*(w54 + x*(w55 + w56*x))))));
        const double w58 = w40 + w41 + w49 + w57;
        const double w59 = y*(EAY_1 + y*(EAY_2 + y*(EAY_3 + y*(EAY_4 + y*(EAY_5 + y*(EAY_6 + EAY_7*y))))));
        const double w60 = x*(EAX_1 + x*(EAX_2 + x*(EAX_3 + x*(EAX_4 + x*(EAX_5 + x*(EAX_6 + EAX_7*x))))));
        const double w61 = w60;
        const double w62 = -EA0Z - w59 - w61;
        const double w63 = w62*z;
        const double w71 = z*(w64 + z*(w65 + z*(w66 + z*(w67 + z*(w68 + z*(w69 + w70*z))))));
        const double w80 = y*(w73 + y*(w74 + y*(w75 + y*(w76 + y*(w77 + y*(w78 + w79*y))))));
        const double w88 = x*(w81 + x*(w82 + x*(w83 + x*(w84 + x*(w85 + x*(w86 + w87*x))))));
        const double w89 = w71 + w72 + w80 + w88;
        const double w90 = w60;
        const double w91 = w90*y;
        deviation[0 * stride + i] = w25 + w29 + w32;
        deviation[1 * stride + i] = w58 + w63;
        deviation[2 * stride + i] = w89 + w91;
    }
}

/*
 * Positioning error of a ball bar between a tool ball and a workpiece ball, exact.
 * Source: Eqs. (5), (6). Operations: 104 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0Y EA0Z EB0Z)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * in ball: 3 rows of stride, mm; point in the workpiece frame (bx by bz)
 * in length: 1 rows of stride, mm; ideal length of the ball bar (length)
 * out error: 4 rows of stride, mm; positioning error E, then its components E_x, E_y, E_z (e ex ey ez)
 */
void gantry_mill_ballbar_error(
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
    const double EC0Y = parameters[0];
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
        const double bx = ball[0 * stride + i];
        const double by = ball[1 * stride + i];
        const double bz = ball[2 * stride + i];
        const double length_ = length[0 * stride + i];
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
        const double w19 = EBX*w11 - ECX*w17 + EXX + w18;
        const double w20 = rx + w18;
        const double w21 = -EAX*w11 + ECX*w20 + EYX + w16;
        const double w22 = EAX*w17 - EBX*w20 + EZX + w10;
        const double w23 = rx + x;
        const double w24 = -bx + w23;
        const double w25 = -by + w12;
        const double w26 = -bz + w0;
        const double w27 = w19 + w24;
        const double w28 = w21 + w25;
        const double w29 = w22 + w26;
        const double w30 = sqrt((w24*w24) + (w25*w25) + (w26*w26));
        const double w31 = sqrt((w27*w27) + (w28*w28) + (w29*w29));
        const double e = -length_ + w30 + (w19*(w24 + w27) + w21*(w25 + w28) + w22*(w26 + w29))/(w30 + w31);
        const double w32 = e/w31;
        error[0 * stride + i] = e;
        error[1 * stride + i] = w27*w32;
        error[2 * stride + i] = w28*w32;
        error[3 * stride + i] = w29*w32;
    }
}

/*
 * Moves of the linear axes that displace the ideal tool point by the given vector.
 * Source: Eqs. (53)-(55), inverse. Operations: 0 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in deviation: 3 rows of stride, mm; displacement of the tool point in the workpiece frame (dx dy dz)
 * out moves: 3 rows of stride, mm; moves of X Y Z (move_x move_y move_z)
 */
void gantry_mill_correction(
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
 * Source: Eqs. (7)-(11). Operations: 13 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0Y EA0Z EB0Z)
 * in tool_point: 3 rows of stride, mm; point in the tool frame (rTx rTy rTz)
 * out displacement: 3 rows of stride, mm; tool point, displacement since home, in the bed frame (dx dy dz)
 */
void gantry_mill_motion_X(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT tool_point,
    double *TRUEAXIS_RESTRICT displacement)
{
    (void)parameters;
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
        displacement[0 * stride + i] = EBX*rTz - ECX*rTy + EXX + x;
        displacement[1 * stride + i] = -EAX*rTz + ECX*rTx + EYX;
        displacement[2 * stride + i] = EAX*rTy - EBX*rTx + EZX;
    }
}

/*
 * Motion equation of Y: displacement of the tool point since home, to first order.
 * Source: Eqs. (7)-(11). Operations: 15 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0Y EA0Z EB0Z)
 * in tool_point: 3 rows of stride, mm; point in the tool frame (rTx rTy rTz)
 * out displacement: 3 rows of stride, mm; tool point, displacement since home, in the bed frame (dx dy dz)
 */
void gantry_mill_motion_Y(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT tool_point,
    double *TRUEAXIS_RESTRICT displacement)
{
    /* once per call */
    const double EC0Y = parameters[0];
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
        displacement[0 * stride + i] = EBY*rTz - EC0Y*y - ECY*rTy + EXY;
        displacement[1 * stride + i] = -EAY*rTz + ECY*rTx + EYY + y;
        displacement[2 * stride + i] = EAY*rTy - EBY*rTx + EZY;
    }
}

/*
 * Motion equation of Z: displacement of the tool point since home, to first order.
 * Source: Eqs. (7)-(11). Operations: 17 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0Y EA0Z EB0Z)
 * in tool_point: 3 rows of stride, mm; point in the tool frame (rTx rTy rTz)
 * out displacement: 3 rows of stride, mm; tool point, displacement since home, in the bed frame (dx dy dz)
 */
void gantry_mill_motion_Z(
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
 * Motion equation of X and Y: displacement of the tool point since home, to first order.
 * Source: Eqs. (7)-(11). Operations: 32 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0Y EA0Z EB0Z)
 * in tool_point: 3 rows of stride, mm; point in the tool frame (rTx rTy rTz)
 * out displacement: 3 rows of stride, mm; tool point, displacement since home, in the bed frame (dx dy dz)
 */
void gantry_mill_motion_XY(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT tool_point,
    double *TRUEAXIS_RESTRICT displacement)
{
    /* once per call */
    const double EC0Y = parameters[0];
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
        const double w0 = rTy + y;
        displacement[0 * stride + i] = EBX*rTz + EBY*rTz - EC0Y*y - ECX*w0 - ECY*rTy + EXX + EXY + x;
        displacement[1 * stride + i] = -EAX*rTz - EAY*rTz + ECX*rTx + ECY*rTx + EYX + EYY + y;
        displacement[2 * stride + i] = EAX*w0 + EAY*rTy - EBX*rTx - EBY*rTx + EZX + EZY;
    }
}

/*
 * Motion equation of X and Z: displacement of the tool point since home, to first order.
 * Source: Eqs. (7)-(11). Operations: 34 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0Y EA0Z EB0Z)
 * in tool_point: 3 rows of stride, mm; point in the tool frame (rTx rTy rTz)
 * out displacement: 3 rows of stride, mm; tool point, displacement since home, in the bed frame (dx dy dz)
 */
void gantry_mill_motion_XZ(
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
        const double w0 = rTz + z;
        displacement[0 * stride + i] = EB0Z*z + EBX*w0 + EBZ*rTz - ECX*rTy - ECZ*rTy + EXX + EXZ + x;
        displacement[1 * stride + i] = -EA0Z*z - EAX*w0 - EAZ*rTz + ECX*rTx + ECZ*rTx + EYX + EYZ;
        displacement[2 * stride + i] = EAX*rTy + EAZ*rTy - EBX*rTx - EBZ*rTx + EZX + EZZ + z;
    }
}

/*
 * Motion equation of Y and Z: displacement of the tool point since home, to first order.
 * Source: Eqs. (7)-(11). Operations: 36 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0Y EA0Z EB0Z)
 * in tool_point: 3 rows of stride, mm; point in the tool frame (rTx rTy rTz)
 * out displacement: 3 rows of stride, mm; tool point, displacement since home, in the bed frame (dx dy dz)
 */
void gantry_mill_motion_YZ(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT tool_point,
    double *TRUEAXIS_RESTRICT displacement)
{
    /* once per call */
    const double EC0Y = parameters[0];
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
        const double rTx = tool_point[0 * stride + i];
        const double rTy = tool_point[1 * stride + i];
        const double rTz = tool_point[2 * stride + i];
        const double w0 = rTz + z;
        displacement[0 * stride + i] = EB0Z*z + EBY*w0 + EBZ*rTz - EC0Y*y - ECY*rTy - ECZ*rTy + EXY + EXZ;
        displacement[1 * stride + i] = -EA0Z*z - EAY*w0 - EAZ*rTz + ECY*rTx + ECZ*rTx + EYY + EYZ + y;
        displacement[2 * stride + i] = EAY*rTy + EAZ*rTy - EBY*rTx - EBZ*rTx + EZY + EZZ + z;
    }
}
