/* Generated from machines/dmu60p.toml, do not edit; regenerate with: trueaxis derive machines/dmu60p.toml
 * SPDX-License-Identifier: MIT
 * Kernels of DECKEL MAHO DMU60P, translational axes: geometric error model in C17.
 * Spec: sha256 0190651706d05e74f47ba63b348c7b25aa718138f26d87af62dcbb754cacd8ee
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

int dmu60p_kernel_abi(void)
{
    return TRUEAXIS_KERNEL_ABI;
}

const char *dmu60p_spec_hash(void)
{
    return "0190651706d05e74f47ba63b348c7b25aa718138f26d87af62dcbb754cacd8ee";
}

/*
 * Ideal position of a tool point in the workpiece frame.
 * Source: Eqs. (1)-(4) without errors. Operations: 9 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in parameters: 9 values, mm, rad; home positions and location errors (q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz
 *     eps_xz)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out ideal: 3 rows of stride, mm; tool point in the workpiece frame, without errors (px py pz)
 */
void dmu60p_tool_in_workpiece_ideal(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT ideal)
{
    /* once per call */
    const double q_wx = parameters[0];
    const double q_wy = parameters[1];
    const double q_wz = parameters[2];
    const double q_Tx = parameters[3];
    const double q_Ty = parameters[4];
    const double q_Tz = parameters[5];
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
        const double x = positions[0 * stride + i];
        const double y = positions[1 * stride + i];
        const double z = positions[2 * stride + i];
        const double rx = point[0 * stride + i];
        const double ry = point[1 * stride + i];
        const double rz = point[2 * stride + i];
        ideal[0 * stride + i] = q_Tx - q_wx + rx + x;
        ideal[1 * stride + i] = q_Ty - q_wy + ry - y;
        ideal[2 * stride + i] = q_Tz - q_wz + rz + z;
    }
}

/*
 * Deviation of a tool point in the workpiece frame, exact.
 * Source: Eqs. (1)-(4). Operations: 98 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 9 values, mm, rad; home positions and location errors (q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz
 *     eps_xz)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; tool point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void dmu60p_tool_in_workpiece_deviation(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation)
{
    /* once per call */
    const double q_Tx = parameters[3];
    const double q_Ty = parameters[4];
    const double q_Tz = parameters[5];
    const double eps_xy = parameters[6];
    const double eps_yz = parameters[7];
    const double eps_xz = parameters[8];
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
        const double w0 = q_Tx + rx;
        const double w1 = w0 + x;
        const double w2 = q_Ty + ry;
        const double w3 = q_Tz + rz;
        const double w4 = w3 + z;
        const double w5 = EBZ*w3 - ECZ*w2 + EXZ;
        const double w6 = -EAZ*w3 + ECZ*w0 + EYZ;
        const double w7 = EAZ*w2 - EBZ*w0 + EZZ;
        const double w8 = -eps_xz*(w0 + w5) + eps_yz*(w2 + w6) + w7;
        const double w9 = w4 + w8;
        const double w10 = w4 + w7;
        const double w11 = -eps_yz*w10 + w6;
        const double w12 = w11 + w2;
        const double w13 = eps_xz*w10 + w5;
        const double w14 = EBX*w9 - ECX*w12 + EXX + w13;
        const double w15 = w0 + w13;
        const double w16 = -EAX*w9 + ECX*w15 + EYX + w11;
        const double w17 = -eps_xy*(w16 + w2) + w14;
        const double w18 = -EXY + w17;
        const double w19 = w2 - y;
        const double w20 = eps_xy*(w1 + w14) + w16;
        const double w21 = -EYY + w20;
        const double w22 = w19 + w21;
        const double w23 = EAX*w12 - EBX*w15 + EZX + w8;
        const double w24 = -EZY + w23;
        const double w25 = w24 + w4;
        const double w26 = w1 + w18;
        const double w27 = EAY*w26 + EBY*w22 + ECY*w25;
        const double w28 = (EAY*EAY) + (EBY*EBY) + (ECY*ECY);
        const double w29 = (1.0/(w28 + 1.0));
        deviation[0 * stride + i] = w29*(EAY*w27 - EBY*w25 + ECY*w22 - w1*w28 + w18);
        deviation[1 * stride + i] = w29*(EAY*w25 + EBY*w27 - ECY*w26 - w19*w28 + w21);
        deviation[2 * stride + i] = w29*(-EAY*w22 + EBY*w26 + ECY*w27 + w24 - w28*w4);
    }
}

/*
 * Deviation of a tool point in the workpiece frame, to first order in the errors.
 * Source: Eqs. (1)-(4). Operations: 60 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 9 values, mm, rad; home positions and location errors (q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz
 *     eps_xz)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; tool point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void dmu60p_tool_in_workpiece_deviation_first_order(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation)
{
    /* once per call */
    const double q_Tx = parameters[3];
    const double q_Ty = parameters[4];
    const double q_Tz = parameters[5];
    const double eps_xy = parameters[6];
    const double eps_yz = parameters[7];
    const double eps_xz = parameters[8];
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
        const double w0 = q_Tz + rz;
        const double w1 = w0 + z;
        const double w2 = q_Ty + ry;
        const double w3 = EBZ*w0 - ECZ*w2 + EXZ;
        const double w4 = eps_xz*w1 + w3;
        const double w5 = EBX*w1 - ECX*w2 + EXX + w4;
        const double w6 = -eps_xy*w2 + w5;
        const double w7 = w2 - y;
        const double w8 = q_Tx + rx;
        const double w9 = w8 + x;
        const double w10 = -EAZ*w0 + ECZ*w8 + EYZ;
        const double w11 = -eps_yz*w1 + w10;
        const double w12 = -EAX*w1 + ECX*w8 + EYX + w11;
        const double w13 = eps_xy*w9 + w12;
        const double w14 = EAZ*w2 - EBZ*w8 + EZZ;
        const double w15 = -eps_xz*w8 + eps_yz*w2 + w14;
        const double w16 = EAX*w2 - EBX*w8 + EZX + w15;
        deviation[0 * stride + i] = -EBY*w1 + ECY*w7 - EXY + w6;
        deviation[1 * stride + i] = EAY*w1 - ECY*w9 - EYY + w13;
        deviation[2 * stride + i] = -EAY*w7 + EBY*w9 - EZY + w16;
    }
}

/*
 * Sensitivity of a tool point in the workpiece frame to every error, at the error-free machine.
 * Source: Eqs. (1)-(4), first order. Operations: 15 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in parameters: 9 values, mm, rad; home positions and location errors (q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz
 *     eps_xz)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out sensitivity: 63 rows of stride, mm/mm, mm/rad; derivative of the deviation by each component error, then by each
 *     location error (dx_EXX dx_EYX .. dz_eps_xz, last index fastest)
 */
void dmu60p_tool_in_workpiece_sensitivity(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT sensitivity)
{
    /* once per call */
    const double q_Tx = parameters[3];
    const double q_Ty = parameters[4];
    const double q_Tz = parameters[5];
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
        const double x = positions[0 * stride + i];
        const double y = positions[1 * stride + i];
        const double z = positions[2 * stride + i];
        const double rx = point[0 * stride + i];
        const double ry = point[1 * stride + i];
        const double rz = point[2 * stride + i];
        const double dx_EBZ = q_Tz + rz;
        const double dx_EBX = dx_EBZ + z;
        const double dz_EAX = q_Ty + ry;
        const double dx_ECX = -dz_EAX;
        const double dx_EBY = -dx_EBX;
        const double dx_ECY = dz_EAX - y;
        const double dy_ECX = q_Tx + rx;
        const double dy_eps_xy = dy_ECX + x;
        const double dz_EBX = -dy_ECX;
        sensitivity[0 * stride + i] = 1.0;
        sensitivity[1 * stride + i] = 0.0;
        sensitivity[2 * stride + i] = 0.0;
        sensitivity[3 * stride + i] = 0.0;
        sensitivity[4 * stride + i] = dx_EBX;
        sensitivity[5 * stride + i] = dx_ECX;
        sensitivity[6 * stride + i] = -1.0;
        sensitivity[7 * stride + i] = 0.0;
        sensitivity[8 * stride + i] = 0.0;
        sensitivity[9 * stride + i] = 0.0;
        sensitivity[10 * stride + i] = dx_EBY;
        sensitivity[11 * stride + i] = dx_ECY;
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
        sensitivity[24 * stride + i] = dx_EBY;
        sensitivity[25 * stride + i] = 0.0;
        sensitivity[26 * stride + i] = dy_ECX;
        sensitivity[27 * stride + i] = 0.0;
        sensitivity[28 * stride + i] = -1.0;
        sensitivity[29 * stride + i] = 0.0;
        sensitivity[30 * stride + i] = dx_EBX;
        sensitivity[31 * stride + i] = 0.0;
        sensitivity[32 * stride + i] = -dy_eps_xy;
        sensitivity[33 * stride + i] = 0.0;
        sensitivity[34 * stride + i] = 1.0;
        sensitivity[35 * stride + i] = 0.0;
        sensitivity[36 * stride + i] = -dx_EBZ;
        sensitivity[37 * stride + i] = 0.0;
        sensitivity[38 * stride + i] = dy_ECX;
        sensitivity[39 * stride + i] = dy_eps_xy;
        sensitivity[40 * stride + i] = dx_EBY;
        sensitivity[41 * stride + i] = 0.0;
        sensitivity[42 * stride + i] = 0.0;
        sensitivity[43 * stride + i] = 0.0;
        sensitivity[44 * stride + i] = 1.0;
        sensitivity[45 * stride + i] = dz_EAX;
        sensitivity[46 * stride + i] = dz_EBX;
        sensitivity[47 * stride + i] = 0.0;
        sensitivity[48 * stride + i] = 0.0;
        sensitivity[49 * stride + i] = 0.0;
        sensitivity[50 * stride + i] = -1.0;
        sensitivity[51 * stride + i] = -dx_ECY;
        sensitivity[52 * stride + i] = dy_eps_xy;
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
 * Source: Eqs. (1)-(4) without errors. Operations: 5 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in parameters: 9 values, mm, rad; home positions and location errors (q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz
 *     eps_xz)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out ideal: 3 rows of stride, mm; tool point in the bed frame, without errors (px py pz)
 */
void dmu60p_tool_in_bed_ideal(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT ideal)
{
    /* once per call */
    const double q_Tx = parameters[3];
    const double q_Ty = parameters[4];
    const double q_Tz = parameters[5];
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
 * Source: Eqs. (1)-(4). Operations: 52 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 9 values, mm, rad; home positions and location errors (q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz
 *     eps_xz)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; tool point in the bed frame, actual minus ideal (dx dy dz)
 */
void dmu60p_tool_in_bed_deviation(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation)
{
    /* once per call */
    const double q_Tx = parameters[3];
    const double q_Ty = parameters[4];
    const double q_Tz = parameters[5];
    const double eps_xy = parameters[6];
    const double eps_yz = parameters[7];
    const double eps_xz = parameters[8];
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
        const double rx = point[0 * stride + i];
        const double ry = point[1 * stride + i];
        const double rz = point[2 * stride + i];
        const double w0 = q_Ty + ry;
        const double w1 = q_Tx + rx;
        const double w2 = EAZ*w0 - EBZ*w1 + EZZ;
        const double w3 = q_Tz + rz;
        const double w4 = w3 + z;
        const double w5 = w2 + w4;
        const double w6 = -EAZ*w3 + ECZ*w1 + EYZ;
        const double w7 = -eps_yz*w5 + w6;
        const double w8 = w0 + w7;
        const double w9 = EBZ*w3 - ECZ*w0 + EXZ;
        const double w10 = eps_xz*w5 + w9;
        const double w11 = w1 + w10;
        const double w12 = -eps_xz*(w1 + w9) + eps_yz*(w0 + w6) + w2;
        const double w13 = w12 + w4;
        const double w14 = EBX*w13 - ECX*w8 + EXX + w10;
        const double w15 = -EAX*w13 + ECX*w11 + EYX + w7;
        const double w16 = w1 + x;
        deviation[0 * stride + i] = -eps_xy*(w0 + w15) + w14;
        deviation[1 * stride + i] = eps_xy*(w14 + w16) + w15;
        deviation[2 * stride + i] = EAX*w8 - EBX*w11 + EZX + w12;
    }
}

/*
 * Deviation of a tool point in the bed frame, to first order in the errors.
 * Source: Eqs. (1)-(4). Operations: 44 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 9 values, mm, rad; home positions and location errors (q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz
 *     eps_xz)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; tool point in the bed frame, actual minus ideal (dx dy dz)
 */
void dmu60p_tool_in_bed_deviation_first_order(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation)
{
    /* once per call */
    const double q_Tx = parameters[3];
    const double q_Ty = parameters[4];
    const double q_Tz = parameters[5];
    const double eps_xy = parameters[6];
    const double eps_yz = parameters[7];
    const double eps_xz = parameters[8];
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
        const double rx = point[0 * stride + i];
        const double ry = point[1 * stride + i];
        const double rz = point[2 * stride + i];
        const double w0 = q_Tx + rx;
        const double w1 = q_Ty + ry;
        const double w2 = EAZ*w1 - EBZ*w0 + EZZ;
        const double w3 = -eps_xz*w0 + eps_yz*w1 + w2;
        const double w4 = q_Tz + rz;
        const double w5 = w4 + z;
        const double w6 = EBZ*w4 - ECZ*w1 + EXZ;
        const double w7 = eps_xz*w5 + w6;
        const double w8 = EBX*w5 - ECX*w1 + EXX + w7;
        const double w9 = -EAZ*w4 + ECZ*w0 + EYZ;
        const double w10 = -eps_yz*w5 + w9;
        const double w11 = -EAX*w5 + ECX*w0 + EYX + w10;
        const double w12 = w0 + x;
        deviation[0 * stride + i] = -eps_xy*w1 + w8;
        deviation[1 * stride + i] = eps_xy*w12 + w11;
        deviation[2 * stride + i] = EAX*w1 - EBX*w0 + EZX + w3;
    }
}

/*
 * Sensitivity of a tool point in the bed frame to every error, at the error-free machine.
 * Source: Eqs. (1)-(4), first order. Operations: 9 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in parameters: 9 values, mm, rad; home positions and location errors (q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz
 *     eps_xz)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out sensitivity: 63 rows of stride, mm/mm, mm/rad; derivative of the deviation by each component error, then by each
 *     location error (dx_EXX dx_EYX .. dz_eps_xz, last index fastest)
 */
void dmu60p_tool_in_bed_sensitivity(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT sensitivity)
{
    /* once per call */
    const double q_Tx = parameters[3];
    const double q_Ty = parameters[4];
    const double q_Tz = parameters[5];
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
        const double x = positions[0 * stride + i];
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
        sensitivity[28 * stride + i] = 0.0;
        sensitivity[29 * stride + i] = 0.0;
        sensitivity[30 * stride + i] = 0.0;
        sensitivity[31 * stride + i] = 0.0;
        sensitivity[32 * stride + i] = 0.0;
        sensitivity[33 * stride + i] = 0.0;
        sensitivity[34 * stride + i] = 1.0;
        sensitivity[35 * stride + i] = 0.0;
        sensitivity[36 * stride + i] = -dx_EBZ;
        sensitivity[37 * stride + i] = 0.0;
        sensitivity[38 * stride + i] = dy_ECX;
        sensitivity[39 * stride + i] = dy_ECX + x;
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
        sensitivity[50 * stride + i] = 0.0;
        sensitivity[51 * stride + i] = 0.0;
        sensitivity[52 * stride + i] = 0.0;
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
 * Source: Eqs. (1)-(4) without errors. Operations: 4 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in parameters: 9 values, mm, rad; home positions and location errors (q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz
 *     eps_xz)
 * in point: 3 rows of stride, mm; point in the workpiece frame (rx ry rz)
 * out ideal: 3 rows of stride, mm; workpiece point in the bed frame, without errors (px py pz)
 */
void dmu60p_workpiece_in_bed_ideal(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT ideal)
{
    /* once per call */
    const double q_wx = parameters[0];
    const double q_wy = parameters[1];
    const double q_wz = parameters[2];
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
        const double y = positions[1 * stride + i];
        const double rx = point[0 * stride + i];
        const double ry = point[1 * stride + i];
        const double rz = point[2 * stride + i];
        ideal[0 * stride + i] = q_wx + rx;
        ideal[1 * stride + i] = q_wy + ry + y;
        ideal[2 * stride + i] = q_wz + rz;
    }
}

/*
 * Deviation of a workpiece point in the bed frame, exact.
 * Source: Eqs. (1)-(4). Operations: 15 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 9 values, mm, rad; home positions and location errors (q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz
 *     eps_xz)
 * in point: 3 rows of stride, mm; point in the workpiece frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; workpiece point in the bed frame, actual minus ideal (dx dy dz)
 */
void dmu60p_workpiece_in_bed_deviation(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation)
{
    (void)positions;
    /* once per call */
    const double q_wx = parameters[0];
    const double q_wy = parameters[1];
    const double q_wz = parameters[2];
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
        const double EXY = errors[6 * stride + i];
        const double EYY = errors[7 * stride + i];
        const double EZY = errors[8 * stride + i];
        const double EAY = errors[9 * stride + i];
        const double EBY = errors[10 * stride + i];
        const double ECY = errors[11 * stride + i];
        const double rx = point[0 * stride + i];
        const double ry = point[1 * stride + i];
        const double rz = point[2 * stride + i];
        const double w0 = q_wy + ry;
        const double w1 = q_wz + rz;
        const double w2 = q_wx + rx;
        deviation[0 * stride + i] = EBY*w1 - ECY*w0 + EXY;
        deviation[1 * stride + i] = -EAY*w1 + ECY*w2 + EYY;
        deviation[2 * stride + i] = EAY*w0 - EBY*w2 + EZY;
    }
}

/*
 * Deviation of a workpiece point in the bed frame, to first order in the errors.
 * Source: Eqs. (1)-(4). Operations: 15 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 9 values, mm, rad; home positions and location errors (q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz
 *     eps_xz)
 * in point: 3 rows of stride, mm; point in the workpiece frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; workpiece point in the bed frame, actual minus ideal (dx dy dz)
 */
void dmu60p_workpiece_in_bed_deviation_first_order(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation)
{
    (void)positions;
    /* once per call */
    const double q_wx = parameters[0];
    const double q_wy = parameters[1];
    const double q_wz = parameters[2];
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
        const double EXY = errors[6 * stride + i];
        const double EYY = errors[7 * stride + i];
        const double EZY = errors[8 * stride + i];
        const double EAY = errors[9 * stride + i];
        const double EBY = errors[10 * stride + i];
        const double ECY = errors[11 * stride + i];
        const double rx = point[0 * stride + i];
        const double ry = point[1 * stride + i];
        const double rz = point[2 * stride + i];
        const double w0 = q_wy + ry;
        const double w1 = q_wz + rz;
        const double w2 = q_wx + rx;
        deviation[0 * stride + i] = EBY*w1 - ECY*w0 + EXY;
        deviation[1 * stride + i] = -EAY*w1 + ECY*w2 + EYY;
        deviation[2 * stride + i] = EAY*w0 - EBY*w2 + EZY;
    }
}

/*
 * Sensitivity of a workpiece point in the bed frame to every error, at the error-free machine.
 * Source: Eqs. (1)-(4), first order. Operations: 6 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in parameters: 9 values, mm, rad; home positions and location errors (q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz
 *     eps_xz)
 * in point: 3 rows of stride, mm; point in the workpiece frame (rx ry rz)
 * out sensitivity: 63 rows of stride, mm/mm, mm/rad; derivative of the deviation by each component error, then by each
 *     location error (dx_EXX dx_EYX .. dz_eps_xz, last index fastest)
 */
void dmu60p_workpiece_in_bed_sensitivity(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT sensitivity)
{
    (void)positions;
    /* once per call */
    const double q_wx = parameters[0];
    const double q_wy = parameters[1];
    const double q_wz = parameters[2];
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
        const double rx = point[0 * stride + i];
        const double ry = point[1 * stride + i];
        const double rz = point[2 * stride + i];
        const double dx_EBY = q_wz + rz;
        const double dz_EAY = q_wy + ry;
        const double dy_ECY = q_wx + rx;
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
        sensitivity[24 * stride + i] = 0.0;
        sensitivity[25 * stride + i] = 0.0;
        sensitivity[26 * stride + i] = 0.0;
        sensitivity[27 * stride + i] = 0.0;
        sensitivity[28 * stride + i] = 1.0;
        sensitivity[29 * stride + i] = 0.0;
        sensitivity[30 * stride + i] = -dx_EBY;
        sensitivity[31 * stride + i] = 0.0;
        sensitivity[32 * stride + i] = dy_ECY;
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
        sensitivity[50 * stride + i] = 1.0;
        sensitivity[51 * stride + i] = dz_EAY;
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
 * Source: Eqs. (1)-(4) without errors. Operations: 4 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in parameters: 9 values, mm, rad; home positions and location errors (q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz
 *     eps_xz)
 * in point: 3 rows of stride, mm; point in the bed frame (rx ry rz)
 * out ideal: 3 rows of stride, mm; bed point in the workpiece frame, without errors (px py pz)
 */
void dmu60p_bed_in_workpiece_ideal(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT ideal)
{
    /* once per call */
    const double q_wx = parameters[0];
    const double q_wy = parameters[1];
    const double q_wz = parameters[2];
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
        const double y = positions[1 * stride + i];
        const double rx = point[0 * stride + i];
        const double ry = point[1 * stride + i];
        const double rz = point[2 * stride + i];
        ideal[0 * stride + i] = -q_wx + rx;
        ideal[1 * stride + i] = -q_wy + ry - y;
        ideal[2 * stride + i] = -q_wz + rz;
    }
}

/*
 * Deviation of a bed point in the workpiece frame, exact.
 * Source: Eqs. (1)-(4). Operations: 47 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 9 values, mm, rad; home positions and location errors (q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz
 *     eps_xz)
 * in point: 3 rows of stride, mm; point in the bed frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; bed point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void dmu60p_bed_in_workpiece_deviation(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation)
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
        const double rx = point[0 * stride + i];
        const double ry = point[1 * stride + i];
        const double rz = point[2 * stride + i];
        const double w0 = ry - y;
        const double w1 = -EYY + w0;
        const double w2 = -rz;
        const double w3 = -EZY - w2;
        const double w4 = -rx;
        const double w5 = -EXY - w4;
        const double w6 = EAY*w5 + EBY*w1 + ECY*w3;
        const double w7 = (EAY*EAY) + (EBY*EBY) + (ECY*ECY);
        const double w8 = (1.0/(w7 + 1.0));
        deviation[0 * stride + i] = w8*(EAY*w6 - EBY*w3 + ECY*w1 - EXY - rx*w7);
        deviation[1 * stride + i] = w8*(EAY*w3 + EBY*w6 - ECY*w5 - EYY - w0*w7);
        deviation[2 * stride + i] = w8*(-EAY*w1 + EBY*w5 + ECY*w6 - EZY - rz*w7);
    }
}

/*
 * Deviation of a bed point in the workpiece frame, to first order in the errors.
 * Source: Eqs. (1)-(4). Operations: 13 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 9 values, mm, rad; home positions and location errors (q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz
 *     eps_xz)
 * in point: 3 rows of stride, mm; point in the bed frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; bed point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void dmu60p_bed_in_workpiece_deviation_first_order(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation)
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
        const double rx = point[0 * stride + i];
        const double ry = point[1 * stride + i];
        const double rz = point[2 * stride + i];
        const double w0 = ry - y;
        deviation[0 * stride + i] = -EBY*rz + ECY*w0 - EXY;
        deviation[1 * stride + i] = EAY*rz - ECY*rx - EYY;
        deviation[2 * stride + i] = -EAY*w0 + EBY*rx - EZY;
    }
}

/*
 * Sensitivity of a bed point in the workpiece frame to every error, at the error-free machine.
 * Source: Eqs. (1)-(4), first order. Operations: 7 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in parameters: 9 values, mm, rad; home positions and location errors (q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz
 *     eps_xz)
 * in point: 3 rows of stride, mm; point in the bed frame (rx ry rz)
 * out sensitivity: 63 rows of stride, mm/mm, mm/rad; derivative of the deviation by each component error, then by each
 *     location error (dx_EXX dx_EYX .. dz_eps_xz, last index fastest)
 */
void dmu60p_bed_in_workpiece_sensitivity(
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
        const double rx = point[0 * stride + i];
        const double ry = point[1 * stride + i];
        const double rz = point[2 * stride + i];
        const double dx_ECY = ry - y;
        sensitivity[0 * stride + i] = 0.0;
        sensitivity[1 * stride + i] = 0.0;
        sensitivity[2 * stride + i] = 0.0;
        sensitivity[3 * stride + i] = 0.0;
        sensitivity[4 * stride + i] = 0.0;
        sensitivity[5 * stride + i] = 0.0;
        sensitivity[6 * stride + i] = -1.0;
        sensitivity[7 * stride + i] = 0.0;
        sensitivity[8 * stride + i] = 0.0;
        sensitivity[9 * stride + i] = 0.0;
        sensitivity[10 * stride + i] = -rz;
        sensitivity[11 * stride + i] = dx_ECY;
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
        sensitivity[28 * stride + i] = -1.0;
        sensitivity[29 * stride + i] = 0.0;
        sensitivity[30 * stride + i] = rz;
        sensitivity[31 * stride + i] = 0.0;
        sensitivity[32 * stride + i] = -rx;
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
        sensitivity[50 * stride + i] = -1.0;
        sensitivity[51 * stride + i] = -dx_ECY;
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
 * Source: Eq. (4). Operations: 104 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 9 values, mm, rad; home positions and location errors (q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz
 *     eps_xz)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out position: 3 rows of stride, mm; actual position P_T^W of the tool point in the workpiece frame (px py pz)
 */
void dmu60p_tool_in_workpiece_position(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT position)
{
    /* once per call */
    const double q_wx = parameters[0];
    const double q_wy = parameters[1];
    const double q_wz = parameters[2];
    const double q_Tx = parameters[3];
    const double q_Ty = parameters[4];
    const double q_Tz = parameters[5];
    const double eps_xy = parameters[6];
    const double eps_yz = parameters[7];
    const double eps_xz = parameters[8];
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
        const double w0 = q_Tx + rx;
        const double w1 = w0 + x;
        const double w2 = q_Ty + ry;
        const double w3 = q_Tz + rz;
        const double w4 = w3 + z;
        const double w5 = EBZ*w3 - ECZ*w2 + EXZ;
        const double w6 = -EAZ*w3 + ECZ*w0 + EYZ;
        const double w7 = EAZ*w2 - EBZ*w0 + EZZ;
        const double w8 = -eps_xz*(w0 + w5) + eps_yz*(w2 + w6) + w7;
        const double w9 = w4 + w8;
        const double w10 = w4 + w7;
        const double w11 = -eps_yz*w10 + w6;
        const double w12 = w11 + w2;
        const double w13 = eps_xz*w10 + w5;
        const double w14 = EBX*w9 - ECX*w12 + EXX + w13;
        const double w15 = w0 + w13;
        const double w16 = -EAX*w9 + ECX*w15 + EYX + w11;
        const double w17 = -eps_xy*(w16 + w2) + w14;
        const double w18 = -EXY + w17;
        const double w19 = w2 - y;
        const double w20 = eps_xy*(w1 + w14) + w16;
        const double w21 = -EYY + w20;
        const double w22 = w19 + w21;
        const double w23 = EAX*w12 - EBX*w15 + EZX + w8;
        const double w24 = -EZY + w23;
        const double w25 = w24 + w4;
        const double w26 = w1 + w18;
        const double w27 = EAY*w26 + EBY*w22 + ECY*w25;
        const double w28 = (EAY*EAY) + (EBY*EBY) + (ECY*ECY);
        const double w29 = (1.0/(w28 + 1.0));
        const double w30 = w29*(EAY*w27 - EBY*w25 + ECY*w22 - w1*w28 + w18);
        const double w31 = -q_wx + w1;
        const double w32 = w29*(EAY*w25 + EBY*w27 - ECY*w26 - w19*w28 + w21);
        const double w33 = -q_wy + w19;
        const double w34 = w29*(-EAY*w22 + EBY*w26 + ECY*w27 + w24 - w28*w4);
        const double w35 = -q_wz + w4;
        position[0 * stride + i] = w30 + w31;
        position[1 * stride + i] = w32 + w33;
        position[2 * stride + i] = w34 + w35;
    }
}

/*
 * Actual position of the tool point in the workpiece frame, to first order.
 * Source: Eq. (4). Operations: 66 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 9 values, mm, rad; home positions and location errors (q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz
 *     eps_xz)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out position: 3 rows of stride, mm; actual position P_T^W of the tool point in the workpiece frame (px py pz)
 */
void dmu60p_tool_in_workpiece_position_first_order(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT position)
{
    /* once per call */
    const double q_wx = parameters[0];
    const double q_wy = parameters[1];
    const double q_wz = parameters[2];
    const double q_Tx = parameters[3];
    const double q_Ty = parameters[4];
    const double q_Tz = parameters[5];
    const double eps_xy = parameters[6];
    const double eps_yz = parameters[7];
    const double eps_xz = parameters[8];
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
        const double w0 = q_Tz + rz;
        const double w1 = w0 + z;
        const double w2 = q_Ty + ry;
        const double w3 = EBZ*w0 - ECZ*w2 + EXZ;
        const double w4 = eps_xz*w1 + w3;
        const double w5 = EBX*w1 - ECX*w2 + EXX + w4;
        const double w6 = -eps_xy*w2 + w5;
        const double w7 = w2 - y;
        const double w8 = -EBY*w1 + ECY*w7 - EXY + w6;
        const double w9 = q_Tx + rx;
        const double w10 = w9 + x;
        const double w11 = -q_wx + w10;
        const double w12 = -EAZ*w0 + ECZ*w9 + EYZ;
        const double w13 = -eps_yz*w1 + w12;
        const double w14 = -EAX*w1 + ECX*w9 + EYX + w13;
        const double w15 = eps_xy*w10 + w14;
        const double w16 = EAY*w1 - ECY*w10 - EYY + w15;
        const double w17 = -q_wy + w7;
        const double w18 = EAZ*w2 - EBZ*w9 + EZZ;
        const double w19 = -eps_xz*w9 + eps_yz*w2 + w18;
        const double w20 = EAX*w2 - EBX*w9 + EZX + w19;
        const double w21 = -EAY*w7 + EBY*w10 - EZY + w20;
        const double w22 = -q_wz + w1;
        position[0 * stride + i] = w11 + w8;
        position[1 * stride + i] = w16 + w17;
        position[2 * stride + i] = w21 + w22;
    }
}

/*
 * Deviation of the tool point under polynomial error curves, exact.
 * Source: Eqs. (1)-(4), (44). Operations: 329 per point, 3 once per call.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in curves: 126 values, mm/mm^k, rad/mm^k; coefficients of the powers 1 to 7 of the axis position, per component
 *     error (EXX_1 EXX_2 .. ECZ_7, last index fastest)
 * in parameters: 9 values, mm, rad; home positions and location errors (q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz
 *     eps_xz)
 * in point: 3 values, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; tool point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void dmu60p_tool_in_workpiece_deviation_curves(
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
    const double q_Tx = parameters[3];
    const double q_Ty = parameters[4];
    const double q_Tz = parameters[5];
    const double eps_xy = parameters[6];
    const double eps_yz = parameters[7];
    const double eps_xz = parameters[8];
    const double rx = point[0];
    const double ry = point[1];
    const double rz = point[2];
    const double w3 = q_Tx + rx;
    const double w6 = q_Ty + ry;
    const double w7 = q_Tz + rz;
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
        const double x = positions[0 * stride + i];
        const double y = positions[1 * stride + i];
        const double z = positions[2 * stride + i];
        const double w0 = y*(EAY_1 + y*(EAY_2 + y*(EAY_3 + y*(EAY_4 + y*(EAY_5 + y*(EAY_6 + EAY_7*y))))));
        const double w1 = y*(EBY_1 + y*(EBY_2 + y*(EBY_3 + y*(EBY_4 + y*(EBY_5 + y*(EBY_6 + EBY_7*y))))));
        const double w2 = y*(ECY_1 + y*(ECY_2 + y*(ECY_3 + y*(ECY_4 + y*(ECY_5 + y*(ECY_6 + ECY_7*y))))));
        const double w4 = w3 + x;
        const double w5 = y*(EXY_1 + y*(EXY_2 + y*(EXY_3 + y*(EXY_4 + y*(EXY_5 + y*(EXY_6 + EXY_7*y))))));
        const double w8 = w7 + z;
        const double w9 = z*(EXZ_1 + z*(EXZ_2 + z*(EXZ_3 + z*(EXZ_4 + z*(EXZ_5 + z*(EXZ_6 + EXZ_7*z))))));
        const double w10 = z*(EBZ_1 + z*(EBZ_2 + z*(EBZ_3 + z*(EBZ_4 + z*(EBZ_5 + z*(EBZ_6 + EBZ_7*z))))));
        const double w11 = z*(ECZ_1 + z*(ECZ_2 + z*(ECZ_3 + z*(ECZ_4 + z*(ECZ_5 + z*(ECZ_6 + ECZ_7*z))))));
        const double w12 = w10*w7 - w11*w6 + w9;
        const double w13 = z*(EYZ_1 + z*(EYZ_2 + z*(EYZ_3 + z*(EYZ_4 + z*(EYZ_5 + z*(EYZ_6 + EYZ_7*z))))));
        const double w14 = z*(EAZ_1 + z*(EAZ_2 + z*(EAZ_3 + z*(EAZ_4 + z*(EAZ_5 + z*(EAZ_6 + EAZ_7*z))))));
        const double w15 = w11*w3 + w13 - w14*w7;
        const double w16 = z*(EZZ_1 + z*(EZZ_2 + z*(EZZ_3 + z*(EZZ_4 + z*(EZZ_5 + z*(EZZ_6 + EZZ_7*z))))));
        const double w17 = -w10*w3 + w14*w6 + w16;
        const double w18 = -eps_xz*(w12 + w3) + eps_yz*(w15 + w6) + w17;
        const double w19 = w18 + w8;
        const double w20 = w17 + w8;
        const double w21 = -eps_yz*w20 + w15;
        const double w22 = w21 + w6;
        const double w23 = x*(EXX_1 + x*(EXX_2 + x*(EXX_3 + x*(EXX_4 + x*(EXX_5 + x*(EXX_6 + EXX_7*x))))));
        const double w24 = x*(EBX_1 + x*(EBX_2 + x*(EBX_3 + x*(EBX_4 + x*(EBX_5 + x*(EBX_6 + EBX_7*x))))));
        const double w25 = x*(ECX_1 + x*(ECX_2 + x*(ECX_3 + x*(ECX_4 + x*(ECX_5 + x*(ECX_6 + ECX_7*x))))));
        const double w26 = eps_xz*w20 + w12;
        const double w27 = w19*w24 - w22*w25 + w23 + w26;
        const double w28 = w26 + w3;
        const double w29 = x*(EYX_1 + x*(EYX_2 + x*(EYX_3 + x*(EYX_4 + x*(EYX_5 + x*(EYX_6 + EYX_7*x))))));
        const double w30 = x*(EAX_1 + x*(EAX_2 + x*(EAX_3 + x*(EAX_4 + x*(EAX_5 + x*(EAX_6 + EAX_7*x))))));
        const double w31 = -w19*w30 + w21 + w25*w28 + w29;
        const double w32 = -eps_xy*(w31 + w6) + w27;
        const double w33 = w32 - w5;
        const double w34 = w6 - y;
        const double w35 = y*(EYY_1 + y*(EYY_2 + y*(EYY_3 + y*(EYY_4 + y*(EYY_5 + y*(EYY_6 + EYY_7*y))))));
        const double w36 = eps_xy*(w27 + w4) + w31;
        const double w37 = -w35 + w36;
        const double w38 = w34 + w37;
        const double w39 = y*(EZY_1 + y*(EZY_2 + y*(EZY_3 + y*(EZY_4 + y*(EZY_5 + y*(EZY_6 + EZY_7*y))))));
        const double w40 = x*(EZX_1 + x*(EZX_2 + x*(EZX_3 + x*(EZX_4 + x*(EZX_5 + x*(EZX_6 + EZX_7*x))))));
        const double w41 = w18 + w22*w30 - w24*w28 + w40;
        const double w42 = -w39 + w41;
        const double w43 = w42 + w8;
        const double w44 = w33 + w4;
        const double w45 = w0*w44 + w1*w38 + w2*w43;
        const double w46 = (w0*w0) + (w1*w1) + (w2*w2);
        const double w47 = (1.0/(w46 + 1.0));
        deviation[0 * stride + i] = w47*(w0*w45 - w1*w43 + w2*w38 + w33 - w4*w46);
        deviation[1 * stride + i] = w47*(w0*w43 + w1*w45 - w2*w44 - w34*w46 + w37);
        deviation[2 * stride + i] = w47*(-w0*w38 + w1*w44 + w2*w45 + w42 - w46*w8);
    }
}

/*
 * Deviation of the tool point under polynomial error curves, to first order, constants folded once per call.
 * Source: Eqs. (1)-(4), (44). Operations: 209 per point, 267 once per call.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in curves: 126 values, mm/mm^k, rad/mm^k; coefficients of the powers 1 to 7 of the axis position, per component
 *     error (EXX_1 EXX_2 .. ECZ_7, last index fastest)
 * in parameters: 9 values, mm, rad; home positions and location errors (q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz
 *     eps_xz)
 * in point: 3 values, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; tool point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void dmu60p_tool_in_workpiece_deviation_first_order_curves(
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
    const double q_Tx = parameters[3];
    const double q_Ty = parameters[4];
    const double q_Tz = parameters[5];
    const double eps_xy = parameters[6];
    const double eps_yz = parameters[7];
    const double eps_xz = parameters[8];
    const double rx = point[0];
    const double ry = point[1];
    const double rz = point[2];
    const double w0 = q_Tz + rz;
    const double w1 = q_Ty + ry;
    const double w2 = -w1;
    const double w3 = EBZ_1*w0 + ECZ_1*w2 + EXZ_1;
    const double w4 = EBZ_2*w0 + ECZ_2*w2 + EXZ_2;
    const double w5 = EBZ_3*w0 + ECZ_3*w2 + EXZ_3;
    const double w6 = EBZ_4*w0 + ECZ_4*w2 + EXZ_4;
    const double w7 = EBZ_5*w0 + ECZ_5*w2 + EXZ_5;
    const double w8 = EBZ_6*w0 + ECZ_6*w2 + EXZ_6;
    const double w9 = EBZ_7*w0 + ECZ_7*w2 + EXZ_7;
    const double w11 = eps_xy*w2 + eps_xz*w0;
    const double w12 = EBX_1*w0 + ECX_1*w2 + EXX_1;
    const double w13 = EBX_2*w0 + ECX_2*w2 + EXX_2;
    const double w14 = EBX_3*w0 + ECX_3*w2 + EXX_3;
    const double w15 = EBX_4*w0 + ECX_4*w2 + EXX_4;
    const double w16 = EBX_5*w0 + ECX_5*w2 + EXX_5;
    const double w17 = EBX_6*w0 + ECX_6*w2 + EXX_6;
    const double w18 = EBX_7*w0 + ECX_7*w2 + EXX_7;
    const double w20 = -w0;
    const double w21 = EBY_1*w20 + ECY_1*w1 - EXY_1;
    const double w22 = EBY_2*w20 + ECY_2*w1 - EXY_2;
    const double w23 = EBY_3*w20 + ECY_3*w1 - EXY_3;
    const double w24 = EBY_4*w20 + ECY_4*w1 - EXY_4;
    const double w25 = EBY_5*w20 + ECY_5*w1 - EXY_5;
    const double w26 = EBY_6*w20 + ECY_6*w1 - EXY_6;
    const double w27 = EBY_7*w20 + ECY_7*w1 - EXY_7;
    const double w38 = q_Tx + rx;
    const double w39 = EAZ_1*w20 + ECZ_1*w38 + EYZ_1;
    const double w40 = EAZ_2*w20 + ECZ_2*w38 + EYZ_2;
    const double w41 = EAZ_3*w20 + ECZ_3*w38 + EYZ_3;
    const double w42 = EAZ_4*w20 + ECZ_4*w38 + EYZ_4;
    const double w43 = EAZ_5*w20 + ECZ_5*w38 + EYZ_5;
    const double w44 = EAZ_6*w20 + ECZ_6*w38 + EYZ_6;
    const double w45 = EAZ_7*w20 + ECZ_7*w38 + EYZ_7;
    const double w47 = eps_xy*w38 + eps_yz*w20;
    const double w48 = EAX_1*w20 + ECX_1*w38 + EYX_1;
    const double w49 = EAX_2*w20 + ECX_2*w38 + EYX_2;
    const double w50 = EAX_3*w20 + ECX_3*w38 + EYX_3;
    const double w51 = EAX_4*w20 + ECX_4*w38 + EYX_4;
    const double w52 = EAX_5*w20 + ECX_5*w38 + EYX_5;
    const double w53 = EAX_6*w20 + ECX_6*w38 + EYX_6;
    const double w54 = EAX_7*w20 + ECX_7*w38 + EYX_7;
    const double w56 = -w38;
    const double w57 = EAY_1*w0 + ECY_1*w56 - EYY_1;
    const double w58 = EAY_2*w0 + ECY_2*w56 - EYY_2;
    const double w59 = EAY_3*w0 + ECY_3*w56 - EYY_3;
    const double w60 = EAY_4*w0 + ECY_4*w56 - EYY_4;
    const double w61 = EAY_5*w0 + ECY_5*w56 - EYY_5;
    const double w62 = EAY_6*w0 + ECY_6*w56 - EYY_6;
    const double w63 = EAY_7*w0 + ECY_7*w56 - EYY_7;
    const double w74 = EAZ_1*w1 + EBZ_1*w56 + EZZ_1;
    const double w75 = EAZ_2*w1 + EBZ_2*w56 + EZZ_2;
    const double w76 = EAZ_3*w1 + EBZ_3*w56 + EZZ_3;
    const double w77 = EAZ_4*w1 + EBZ_4*w56 + EZZ_4;
    const double w78 = EAZ_5*w1 + EBZ_5*w56 + EZZ_5;
    const double w79 = EAZ_6*w1 + EBZ_6*w56 + EZZ_6;
    const double w80 = EAZ_7*w1 + EBZ_7*w56 + EZZ_7;
    const double w82 = eps_xz*w56 + eps_yz*w1;
    const double w83 = EAX_1*w1 + EBX_1*w56 + EZX_1;
    const double w84 = EAX_2*w1 + EBX_2*w56 + EZX_2;
    const double w85 = EAX_3*w1 + EBX_3*w56 + EZX_3;
    const double w86 = EAX_4*w1 + EBX_4*w56 + EZX_4;
    const double w87 = EAX_5*w1 + EBX_5*w56 + EZX_5;
    const double w88 = EAX_6*w1 + EBX_6*w56 + EZX_6;
    const double w89 = EAX_7*w1 + EBX_7*w56 + EZX_7;
    const double w91 = EAY_1*w2 + EBY_1*w38 - EZY_1;
    const double w92 = EAY_2*w2 + EBY_2*w38 - EZY_2;
    const double w93 = EAY_3*w2 + EBY_3*w38 - EZY_3;
    const double w94 = EAY_4*w2 + EBY_4*w38 - EZY_4;
    const double w95 = EAY_5*w2 + EBY_5*w38 - EZY_5;
    const double w96 = EAY_6*w2 + EBY_6*w38 - EZY_6;
    const double w97 = EAY_7*w2 + EBY_7*w38 - EZY_7;
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
        const double x = positions[0 * stride + i];
        const double y = positions[1 * stride + i];
        const double z = positions[2 * stride + i];
        const double w10 = z*(w3 + z*(w4 + z*(w5 + z*(w6 + z*(w7 + z*(w8 + w9*z))))));
        const double w19 = x*(w12 + x*(w13 + x*(w14 + x*(w15 + x*(w16 + x*(w17 + w18*x))))));
        const double w28 = y*(w21 + y*(w22 + y*(w23 + y*(w24 + y*(w25 + y*(w26 + w27*y))))));
        const double w29 = w10 + w11 + w19 + w28;
        const double w30 = x*(EBX_1 + x*(EBX_2 + x*(EBX_3 + x*(EBX_4 + x*(EBX_5 + x*(EBX_6 + EBX_7*x))))));
        const double w31 = y*(EBY_1 + y*(EBY_2 + y*(EBY_3 + y*(EBY_4 + y*(EBY_5 + y*(EBY_6 + EBY_7*y))))));
        const double w32 = w31;
        const double w33 = eps_xz + w30 - w32;
        const double w34 = w33*z;
        const double w35 = y*(ECY_1 + y*(ECY_2 + y*(ECY_3 + y*(ECY_4 + y*(ECY_5 + y*(ECY_6 + ECY_7*y))))));
        const double w36 = w35;
        const double w37 = -w36*y;
        const double w46 = z*(w39 + z*(w40 + z*(w41 + z*(w42 + z*(w43 + z*(w44 + w45*z))))));
        const double w55 = x*(w48 + x*(w49 + x*(w50 + x*(w51 + x*(w52 + x*(w53 + w54*x))))));
        const double w64 = y*(w57 + y*(w58 + y*(w59 + y*(w60 + y*(w61 + y*(w62 + w63*y))))));
        const double w65 = w46 + w47 + w55 + w64;
        const double w66 = x*(EAX_1 + x*(EAX_2 + x*(EAX_3 + x*(EAX_4 + x*(EAX_5 + x*(EAX_6 + EAX_7*x))))));
        const double w67 = y*(EAY_1 + y*(EAY_2 + y*(EAY_3 + y*(EAY_4 + y*(EAY_5 + y*(EAY_6 + EAY_7*y))))));
        const double w68 = w67;
        const double w69 = -eps_yz - w66 + w68;
        const double w70 = w69*z;
        const double w71 = w35;
        const double w72 = eps_xy - w71;
        const double w73 = w72*x;
        const double w81 = z*(w74 + z*(w75 + z*(w76 + z*(w77 + z*(w78 + z*(w79 + w80*z))))));
        const double w90 = x*(w83 + x*(w84 + x*(w85 + x*(w86 + x*(w87 + x*(w88 + w89*x))))));
        const double w98 = y*(w91 + y*(w92 + y*(w93 + y*(w94 + y*(w95 + y*(w96 + w97*y))))));
        const double w99 = w81 + w82 + w90 + w98;
        const double w100 = w67;
        const double w101 = w100*y;
        const double w102 = w31;
        const double w103 = w102*x;
        deviation[0 * stride + i] = w29 + w34 + w37;
        deviation[1 * stride + i] = w65 + w70 + w73;
        deviation[2 * stride + i] = w101 + w103 + w99;
    }
}

/*
 * Positioning error of a ball bar between a tool ball and a workpiece ball, exact.
 * Source: Eqs. (5), (6). Operations: 137 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 9 values, mm, rad; home positions and location errors (q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz
 *     eps_xz)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * in ball: 3 rows of stride, mm; point in the workpiece frame (bx by bz)
 * in length: 1 rows of stride, mm; ideal length of the ball bar (length)
 * out error: 4 rows of stride, mm; positioning error E, then its components E_x, E_y, E_z (e ex ey ez)
 */
void dmu60p_ballbar_error(
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
    const double q_wx = parameters[0];
    const double q_wy = parameters[1];
    const double q_wz = parameters[2];
    const double q_Tx = parameters[3];
    const double q_Ty = parameters[4];
    const double q_Tz = parameters[5];
    const double eps_xy = parameters[6];
    const double eps_yz = parameters[7];
    const double eps_xz = parameters[8];
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
        const double w0 = q_Tx + rx;
        const double w1 = w0 + x;
        const double w2 = q_Ty + ry;
        const double w3 = q_Tz + rz;
        const double w4 = w3 + z;
        const double w5 = EBZ*w3 - ECZ*w2 + EXZ;
        const double w6 = -EAZ*w3 + ECZ*w0 + EYZ;
        const double w7 = EAZ*w2 - EBZ*w0 + EZZ;
        const double w8 = -eps_xz*(w0 + w5) + eps_yz*(w2 + w6) + w7;
        const double w9 = w4 + w8;
        const double w10 = w4 + w7;
        const double w11 = -eps_yz*w10 + w6;
        const double w12 = w11 + w2;
        const double w13 = eps_xz*w10 + w5;
        const double w14 = EBX*w9 - ECX*w12 + EXX + w13;
        const double w15 = w0 + w13;
        const double w16 = -EAX*w9 + ECX*w15 + EYX + w11;
        const double w17 = -eps_xy*(w16 + w2) + w14;
        const double w18 = -EXY + w17;
        const double w19 = w2 - y;
        const double w20 = eps_xy*(w1 + w14) + w16;
        const double w21 = -EYY + w20;
        const double w22 = w19 + w21;
        const double w23 = EAX*w12 - EBX*w15 + EZX + w8;
        const double w24 = -EZY + w23;
        const double w25 = w24 + w4;
        const double w26 = w1 + w18;
        const double w27 = EAY*w26 + EBY*w22 + ECY*w25;
        const double w28 = (EAY*EAY) + (EBY*EBY) + (ECY*ECY);
        const double w29 = (1.0/(w28 + 1.0));
        const double w30 = w29*(EAY*w27 - EBY*w25 + ECY*w22 - w1*w28 + w18);
        const double w31 = w29*(EAY*w25 + EBY*w27 - ECY*w26 - w19*w28 + w21);
        const double w32 = w29*(-EAY*w22 + EBY*w26 + ECY*w27 + w24 - w28*w4);
        const double w33 = -q_wx + w1;
        const double w34 = -bx + w33;
        const double w35 = -q_wy + w19;
        const double w36 = -by + w35;
        const double w37 = -q_wz + w4;
        const double w38 = -bz + w37;
        const double w39 = w30 + w34;
        const double w40 = w31 + w36;
        const double w41 = w32 + w38;
        const double w42 = sqrt((w34*w34) + (w36*w36) + (w38*w38));
        const double w43 = sqrt((w39*w39) + (w40*w40) + (w41*w41));
        const double e = -length_ + w42 + (w30*(w34 + w39) + w31*(w36 + w40) + w32*(w38 + w41))/(w42 + w43);
        const double w44 = e/w43;
        error[0 * stride + i] = e;
        error[1 * stride + i] = w39*w44;
        error[2 * stride + i] = w40*w44;
        error[3 * stride + i] = w41*w44;
    }
}

/*
 * Moves of the linear axes that displace the ideal tool point by the given vector.
 * Source: Eqs. (53)-(55), inverse. Operations: 1 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in deviation: 3 rows of stride, mm; displacement of the tool point in the workpiece frame (dx dy dz)
 * out moves: 3 rows of stride, mm; moves of X Y Z (move_x move_y move_z)
 */
void dmu60p_correction(
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
        moves[1 * stride + i] = -dy;
        moves[2 * stride + i] = dz;
    }
}

/*
 * Motion equation of X: displacement of the tool point since home, to first order.
 * Source: Eqs. (7)-(11). Operations: 18 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 9 values, mm, rad; home positions and location errors (q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz
 *     eps_xz)
 * in tool_point: 3 rows of stride, mm; point in the tool frame (rTx rTy rTz)
 * out displacement: 3 rows of stride, mm; tool point, displacement since home, in the bed frame (dx dy dz)
 */
void dmu60p_motion_X(
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
    const double eps_xy = parameters[6];
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
        displacement[1 * stride + i] = -EAX*w0 + ECX*w2 + EYX + eps_xy*x;
        displacement[2 * stride + i] = EAX*w1 - EBX*w2 + EZX;
    }
}

/*
 * Motion equation of Y: displacement of the workpiece point since home, to first order.
 * Source: Eqs. (7)-(11). Operations: 16 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 9 values, mm, rad; home positions and location errors (q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz
 *     eps_xz)
 * in workpiece_point: 3 rows of stride, mm; point in the workpiece frame (rWx rWy rWz)
 * out displacement: 3 rows of stride, mm; workpiece point, displacement since home, in the bed frame (dx dy dz)
 */
void dmu60p_motion_Y(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT workpiece_point,
    double *TRUEAXIS_RESTRICT displacement)
{
    /* once per call */
    const double q_wx = parameters[0];
    const double q_wy = parameters[1];
    const double q_wz = parameters[2];
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
        const double w0 = q_wz + rWz;
        const double w1 = q_wy + rWy;
        const double w2 = q_wx + rWx;
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
 * in parameters: 9 values, mm, rad; home positions and location errors (q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz
 *     eps_xz)
 * in tool_point: 3 rows of stride, mm; point in the tool frame (rTx rTy rTz)
 * out displacement: 3 rows of stride, mm; tool point, displacement since home, in the bed frame (dx dy dz)
 */
void dmu60p_motion_Z(
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
    const double eps_yz = parameters[7];
    const double eps_xz = parameters[8];
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
        displacement[0 * stride + i] = EBZ*w0 - ECZ*w1 + EXZ + eps_xz*z;
        displacement[1 * stride + i] = -EAZ*w0 + ECZ*w2 + EYZ - eps_yz*z;
        displacement[2 * stride + i] = EAZ*w1 - EBZ*w2 + EZZ + z;
    }
}

/*
 * Motion equation of X and Y: displacement of the workpiece point minus tool point since home, to first order.
 * Source: Eqs. (7)-(11). Operations: 37 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 9 values, mm, rad; home positions and location errors (q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz
 *     eps_xz)
 * in workpiece_point: 3 rows of stride, mm; point in the workpiece frame (rWx rWy rWz)
 * in tool_point: 3 rows of stride, mm; point in the tool frame (rTx rTy rTz)
 * out displacement: 3 rows of stride, mm; workpiece point minus tool point, displacement since home, in the bed frame
 *     (dx dy dz)
 */
void dmu60p_motion_XY(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT workpiece_point,
    const double *TRUEAXIS_RESTRICT tool_point,
    double *TRUEAXIS_RESTRICT displacement)
{
    /* once per call */
    const double q_wx = parameters[0];
    const double q_wy = parameters[1];
    const double q_wz = parameters[2];
    const double q_Tx = parameters[3];
    const double q_Ty = parameters[4];
    const double q_Tz = parameters[5];
    const double eps_xy = parameters[6];
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
        const double w0 = q_wz + rWz;
        const double w1 = q_Ty + rTy;
        const double w2 = q_Tz + rTz;
        const double w3 = q_wy + rWy;
        const double w4 = q_wx + rWx;
        const double w5 = q_Tx + rTx;
        displacement[0 * stride + i] = -EBX*w2 + EBY*w0 + ECX*w1 - ECY*w3 - EXX + EXY - x;
        displacement[1 * stride + i] = EAX*w2 - EAY*w0 - ECX*w5 + ECY*w4 - EYX + EYY - eps_xy*x + y;
        displacement[2 * stride + i] = -EAX*w1 + EAY*w3 + EBX*w5 - EBY*w4 - EZX + EZY;
    }
}

/*
 * Motion equation of X and Z: displacement of the tool point since home, to first order.
 * Source: Eqs. (7)-(11). Operations: 41 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 9 values, mm, rad; home positions and location errors (q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz
 *     eps_xz)
 * in tool_point: 3 rows of stride, mm; point in the tool frame (rTx rTy rTz)
 * out displacement: 3 rows of stride, mm; tool point, displacement since home, in the bed frame (dx dy dz)
 */
void dmu60p_motion_XZ(
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
    const double eps_xy = parameters[6];
    const double eps_yz = parameters[7];
    const double eps_xz = parameters[8];
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
        displacement[0 * stride + i] = EBX*w1 + EBZ*w0 + ECX*w3 + ECZ*w3 + EXX + EXZ + eps_xz*z + x;
        displacement[1 * stride + i] = -EAX*w1 - EAZ*w0 + ECX*w4 + ECZ*w4 + EYX + EYZ + eps_xy*x - eps_yz*z;
        displacement[2 * stride + i] = EAX*w2 + EAZ*w2 + EBX*w5 + EBZ*w5 + EZX + EZZ + z;
    }
}

/*
 * Motion equation of Y and Z: displacement of the workpiece point minus tool point since home, to first order.
 * Source: Eqs. (7)-(11). Operations: 39 per point.
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 9 values, mm, rad; home positions and location errors (q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz
 *     eps_xz)
 * in workpiece_point: 3 rows of stride, mm; point in the workpiece frame (rWx rWy rWz)
 * in tool_point: 3 rows of stride, mm; point in the tool frame (rTx rTy rTz)
 * out displacement: 3 rows of stride, mm; workpiece point minus tool point, displacement since home, in the bed frame
 *     (dx dy dz)
 */
void dmu60p_motion_YZ(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT workpiece_point,
    const double *TRUEAXIS_RESTRICT tool_point,
    double *TRUEAXIS_RESTRICT displacement)
{
    /* once per call */
    const double q_wx = parameters[0];
    const double q_wy = parameters[1];
    const double q_wz = parameters[2];
    const double q_Tx = parameters[3];
    const double q_Ty = parameters[4];
    const double q_Tz = parameters[5];
    const double eps_yz = parameters[7];
    const double eps_xz = parameters[8];
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
        const double w0 = q_wz + rWz;
        const double w1 = q_Ty + rTy;
        const double w2 = q_Tz + rTz;
        const double w3 = q_wy + rWy;
        const double w4 = q_wx + rWx;
        const double w5 = q_Tx + rTx;
        displacement[0 * stride + i] = EBY*w0 - EBZ*w2 - ECY*w3 + ECZ*w1 + EXY - EXZ - eps_xz*z;
        displacement[1 * stride + i] = -EAY*w0 + EAZ*w2 + ECY*w4 - ECZ*w5 + EYY - EYZ + eps_yz*z + y;
        displacement[2 * stride + i] = EAY*w3 - EAZ*w1 - EBY*w4 + EBZ*w5 + EZY - EZZ - z;
    }
}

/*
 * EXX, ECX, EBX from the readings X-1, X-2, X-3.
 * Source: Sects. 3.2-3.5, closed form. Operations: 39 per point, 22 once per call.
 * in readings: 3 rows of stride, mm; displacements read in X-1, X-2, X-3, less those of the error-free machine (L1 L2
 *     L3)
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 9 values, mm, rad; home positions and location errors (q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz
 *     eps_xz)
 * in points: 9 values, mm; xyz of tool point 1, xyz of tool point 2, xyz of tool point 3 (rT1x rT1y rT1z rT2x rT2y
 *     rT2z rT3x rT3y rT3z)
 * out unknowns: 3 rows of stride, mm, rad; EXX, ECX, EBX (identified_EXX identified_ECX identified_EBX)
 */
void dmu60p_system_1(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT readings,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT points,
    double *TRUEAXIS_RESTRICT unknowns)
{
    (void)positions;
    (void)errors;
    /* once per call */
    const double q_Ty = parameters[4];
    const double q_Tz = parameters[5];
    const double rT1y = points[1];
    const double rT1z = points[2];
    const double rT2y = points[4];
    const double rT2z = points[5];
    const double rT3y = points[7];
    const double rT3z = points[8];
    const double w0 = q_Ty*rT2z;
    const double w1 = q_Tz*rT2y;
    const double w2 = rT2y*rT3z;
    const double w3 = -q_Ty*rT3z + q_Tz*rT3y;
    const double w4 = rT1y*rT2z;
    const double w5 = -rT1y*rT3z + rT1z*rT3y;
    const double w6 = (1.0/(rT1z*rT2y + rT2z*rT3y - w2 - w4 - w5));
    const double w8 = q_Ty*rT1z - q_Tz*rT1y;
    const double w11 = -rT3z;
    const double w12 = -rT3y;
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
        const double L1 = readings[0 * stride + i];
        const double L2 = readings[1 * stride + i];
        const double L3 = readings[2 * stride + i];
        const double w7 = L1*w6;
        const double w9 = L2*w6;
        const double w10 = L3*w6;
        unknowns[0 * stride + i] = w10*(rT1z*rT2y - w0 + w1 - w4 + w8) + w7*(rT2z*rT3y + w0 - w1 - w2 + w3) +
            w9*(-w3 - w5 - w8);
        unknowns[1 * stride + i] = w10*(rT1z - rT2z) + w7*(rT2z + w11) + w9*(-rT1z - w11);
        unknowns[2 * stride + i] = w10*(rT1y - rT2y) + w7*(rT2y + w12) + w9*(-rT1y - w12);
    }
}

/*
 * EYY, ECY, EAY from the readings Y-4, Y-5, Y-6.
 * Source: Sects. 3.2-3.5, closed form. Operations: 39 per point, 22 once per call.
 * in readings: 3 rows of stride, mm; displacements read in Y-4, Y-5, Y-6, less those of the error-free machine (L1 L2
 *     L3)
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 9 values, mm, rad; home positions and location errors (q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz
 *     eps_xz)
 * in points: 9 values, mm; xyz of workpiece point 1, xyz of workpiece point 2, xyz of workpiece point 3 (rW1x rW1y
 *     rW1z rW2x rW2y rW2z rW3x rW3y rW3z)
 * out unknowns: 3 rows of stride, mm, rad; EYY, ECY, EAY (identified_EYY identified_ECY identified_EAY)
 */
void dmu60p_system_2(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT readings,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT points,
    double *TRUEAXIS_RESTRICT unknowns)
{
    (void)positions;
    (void)errors;
    /* once per call */
    const double q_wx = parameters[0];
    const double q_wz = parameters[2];
    const double rW1x = points[0];
    const double rW1z = points[2];
    const double rW2x = points[3];
    const double rW2z = points[5];
    const double rW3x = points[6];
    const double rW3z = points[8];
    const double w0 = q_wx*rW2z;
    const double w1 = q_wz*rW2x;
    const double w2 = rW2x*rW3z;
    const double w3 = -q_wx*rW3z + q_wz*rW3x;
    const double w4 = rW1x*rW2z;
    const double w5 = -rW1x*rW3z + rW1z*rW3x;
    const double w6 = (1.0/(rW1z*rW2x + rW2z*rW3x - w2 - w4 - w5));
    const double w8 = q_wx*rW1z - q_wz*rW1x;
    const double w11 = -rW3z;
    const double w12 = -rW3x;
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
        const double L1 = readings[0 * stride + i];
        const double L2 = readings[1 * stride + i];
        const double L3 = readings[2 * stride + i];
        const double w7 = L1*w6;
        const double w9 = L2*w6;
        const double w10 = L3*w6;
        unknowns[0 * stride + i] = w10*(rW1z*rW2x - w0 + w1 - w4 + w8) + w7*(rW2z*rW3x + w0 - w1 - w2 + w3) +
            w9*(-w3 - w5 - w8);
        unknowns[1 * stride + i] = w10*(-rW1z + rW2z) + w7*(-rW2z - w11) + w9*(rW1z + w11);
        unknowns[2 * stride + i] = w10*(-rW1x + rW2x) + w7*(-rW2x - w12) + w9*(rW1x + w12);
    }
}

/*
 * EZZ, EBZ, EAZ from the readings Z-7, Z-8, Z-9. At the points of these runs the rank is 2: division by zero there.
 * Source: Sects. 3.2-3.5, closed form. Operations: 39 per point, 22 once per call.
 * in readings: 3 rows of stride, mm; displacements read in Z-7, Z-8, Z-9, less those of the error-free machine (L1 L2
 *     L3)
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 9 values, mm, rad; home positions and location errors (q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz
 *     eps_xz)
 * in points: 9 values, mm; xyz of tool point 1, xyz of tool point 2, xyz of tool point 3 (rT4x rT4y rT4z rT5x rT5y
 *     rT5z rT6x rT6y rT6z)
 * out unknowns: 3 rows of stride, mm, rad; EZZ, EBZ, EAZ (identified_EZZ identified_EBZ identified_EAZ)
 */
void dmu60p_system_3(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT readings,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT points,
    double *TRUEAXIS_RESTRICT unknowns)
{
    (void)positions;
    (void)errors;
    /* once per call */
    const double q_Tx = parameters[3];
    const double q_Ty = parameters[4];
    const double rT4x = points[0];
    const double rT4y = points[1];
    const double rT5x = points[3];
    const double rT5y = points[4];
    const double rT6x = points[6];
    const double rT6y = points[7];
    const double w0 = q_Tx*rT5y;
    const double w1 = q_Ty*rT5x;
    const double w2 = rT5x*rT6y;
    const double w3 = -q_Tx*rT6y + q_Ty*rT6x;
    const double w4 = rT4x*rT5y;
    const double w5 = -rT4x*rT6y + rT4y*rT6x;
    const double w6 = (1.0/(rT4y*rT5x + rT5y*rT6x - w2 - w4 - w5));
    const double w8 = q_Tx*rT4y - q_Ty*rT4x;
    const double w11 = -rT6y;
    const double w12 = -rT6x;
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
        const double L1 = readings[0 * stride + i];
        const double L2 = readings[1 * stride + i];
        const double L3 = readings[2 * stride + i];
        const double w7 = L1*w6;
        const double w9 = L2*w6;
        const double w10 = L3*w6;
        unknowns[0 * stride + i] = w10*(rT4y*rT5x - w0 + w1 - w4 + w8) + w7*(rT5y*rT6x + w0 - w1 - w2 + w3) +
            w9*(-w3 - w5 - w8);
        unknowns[1 * stride + i] = w10*(rT4y - rT5y) + w7*(rT5y + w11) + w9*(-rT4y - w11);
        unknowns[2 * stride + i] = w10*(rT4x - rT5x) + w7*(rT5x + w12) + w9*(-rT4x - w12);
    }
}

/*
 * EXZ, ECZ from the readings XZ-1x, XZ-2x.
 * Source: Sects. 3.2-3.5, closed form. Operations: 25 per point, 7 once per call.
 * in readings: 2 rows of stride, mm; displacements read in XZ-1x, XZ-2x, less those of the error-free machine (L1 L2)
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 9 values, mm, rad; home positions and location errors (q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz
 *     eps_xz)
 * in points: 6 values, mm; xyz of tool point 1, xyz of tool point 2 (rT7x rT7y rT7z rT8x rT8y rT8z)
 * out unknowns: 2 rows of stride, mm, rad; EXZ, ECZ (identified_EXZ identified_ECZ)
 */
void dmu60p_system_4(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT readings,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT points,
    double *TRUEAXIS_RESTRICT unknowns)
{
    /* once per call */
    const double q_Ty = parameters[4];
    const double q_Tz = parameters[5];
    const double eps_xz = parameters[8];
    const double rT7y = points[1];
    const double rT7z = points[2];
    const double rT8y = points[4];
    const double rT8z = points[5];
    const double w0 = q_Ty + rT7y;
    const double w1 = (1.0/(rT7y - rT8y));
    const double w2 = -q_Ty - rT8y;
    const double w3 = q_Tz + rT8z;
    const double w6 = q_Tz + rT7z;
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
        const double L1 = readings[0 * stride + i];
        const double L2 = readings[1 * stride + i];
        const double z = positions[2 * stride + i];
        const double EXX = errors[0 * stride + i];
        const double EBX = errors[4 * stride + i];
        const double ECX = errors[5 * stride + i];
        const double EBZ = errors[16 * stride + i];
        const double w4 = EXX + eps_xz*z;
        const double w5 = -EBX*(w3 + z) - EBZ*w3 - ECX*w2 + L2 - w4;
        const double w7 = w1*(-EBX*(w6 + z) - EBZ*w6 + ECX*w0 + L1 - w4);
        unknowns[0 * stride + i] = w0*w1*w5 + w2*w7;
        unknowns[1 * stride + i] = w1*w5 - w7;
    }
}

/*
 * EZX, EAX from the readings XZ-1z, XZ-2z.
 * Source: Sects. 3.2-3.5, closed form. Operations: 21 per point, 8 once per call.
 * in readings: 2 rows of stride, mm; displacements read in XZ-1z, XZ-2z, less those of the error-free machine (L1 L2)
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 9 values, mm, rad; home positions and location errors (q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz
 *     eps_xz)
 * in points: 6 values, mm; xyz of tool point 1, xyz of tool point 2 (rT7x rT7y rT7z rT8x rT8y rT8z)
 * out unknowns: 2 rows of stride, mm, rad; EZX, EAX (identified_EZX identified_EAX)
 */
void dmu60p_system_5(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT readings,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT points,
    double *TRUEAXIS_RESTRICT unknowns)
{
    (void)positions;
    /* once per call */
    const double q_Tx = parameters[3];
    const double q_Ty = parameters[4];
    const double rT7x = points[0];
    const double rT7y = points[1];
    const double rT8x = points[3];
    const double rT8y = points[4];
    const double w0 = q_Ty + rT8y;
    const double w1 = (1.0/(-rT7y + rT8y));
    const double w2 = q_Ty + rT7y;
    const double w3 = -q_Tx - rT7x;
    const double w5 = -q_Tx - rT8x;
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
        const double L1 = readings[0 * stride + i];
        const double L2 = readings[1 * stride + i];
        const double EBX = errors[4 * stride + i];
        const double EZZ = errors[14 * stride + i];
        const double EAZ = errors[15 * stride + i];
        const double EBZ = errors[16 * stride + i];
        const double w4 = w1*(-EAZ*w2 - EBX*w3 - EBZ*w3 - EZZ + L1);
        const double w6 = -EAZ*w0 - EBX*w5 - EBZ*w5 - EZZ + L2;
        unknowns[0 * stride + i] = w0*w4 - w1*w2*w6;
        unknowns[1 * stride + i] = w1*w6 - w4;
    }
}

/*
 * EXY, EBY from the readings XY-1x, XY-2x.
 * Source: Sects. 3.2-3.5, closed form. Operations: 34 per point, 2 once per call.
 * in readings: 2 rows of stride, mm; displacements read in XY-1x, XY-2x, less those of the error-free machine (L1 L2)
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 9 values, mm, rad; home positions and location errors (q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz
 *     eps_xz)
 * in points: 12 values, mm; xyz of workpiece point 1, xyz of tool point 2, xyz of workpiece point 3, xyz of tool point
 *     4 (rW4x rW4y rW4z rT9x rT9y rT9z rW5x rW5y rW5z rT10x rT10y rT10z)
 * out unknowns: 2 rows of stride, mm, rad; EXY, EBY (identified_EXY identified_EBY)
 */
void dmu60p_system_6(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT readings,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT points,
    double *TRUEAXIS_RESTRICT unknowns)
{
    (void)positions;
    /* once per call */
    const double q_wy = parameters[1];
    const double q_wz = parameters[2];
    const double q_Ty = parameters[4];
    const double q_Tz = parameters[5];
    const double rW4y = points[1];
    const double rW4z = points[2];
    const double rT9y = points[4];
    const double rT9z = points[5];
    const double rW5y = points[7];
    const double rW5z = points[8];
    const double rT10y = points[10];
    const double rT10z = points[11];
    const double w0 = (1.0/(-rW4z + rW5z));
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
        const double L1 = readings[0 * stride + i];
        const double L2 = readings[1 * stride + i];
        const double EXX = errors[0 * stride + i];
        const double EBX = errors[4 * stride + i];
        const double ECX = errors[5 * stride + i];
        const double ECY = errors[11 * stride + i];
        const double w1 = -EXX;
        const double w2 = w0*(-EBX*(-q_Tz - rT9z) - ECX*(q_Ty + rT9y) - ECY*(-q_wy - rW4y) + L1 - w1);
        const double w3 = w0*(-EBX*(-q_Tz - rT10z) - ECX*(q_Ty + rT10y) - ECY*(-q_wy - rW5y) + L2 - w1);
        unknowns[0 * stride + i] = w2*(q_wz + rW5z) + w3*(-q_wz - rW4z);
        unknowns[1 * stride + i] = -w2 + w3;
    }
}

/*
 * EYX from the readings XY-1y.
 * Source: Sects. 3.2-3.5, closed form. Operations: 17 per point.
 * in readings: 1 rows of stride, mm; displacements read in XY-1y, less those of the error-free machine (L1)
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 9 values, mm, rad; home positions and location errors (q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz
 *     eps_xz)
 * in points: 6 values, mm; xyz of workpiece point 1, xyz of tool point 2 (rW4x rW4y rW4z rT9x rT9y rT9z)
 * out unknowns: 1 rows of stride, mm, rad; EYX (identified_EYX)
 */
void dmu60p_system_7(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT readings,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT points,
    double *TRUEAXIS_RESTRICT unknowns)
{
    /* once per call */
    const double q_wx = parameters[0];
    const double q_wz = parameters[2];
    const double q_Tx = parameters[3];
    const double q_Tz = parameters[5];
    const double eps_xy = parameters[6];
    const double rW4x = points[0];
    const double rW4z = points[2];
    const double rT9x = points[3];
    const double rT9z = points[5];
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
        const double L1 = readings[0 * stride + i];
        const double x = positions[0 * stride + i];
        const double EAX = errors[3 * stride + i];
        const double ECX = errors[5 * stride + i];
        const double EYY = errors[7 * stride + i];
        const double EAY = errors[9 * stride + i];
        const double ECY = errors[11 * stride + i];
        unknowns[0 * stride + i] = EAX*(q_Tz + rT9z) + EAY*(-q_wz - rW4z) + ECX*(-q_Tx - rT9x) + ECY*(q_wx + rW4x) +
            EYY - L1 - eps_xy*x;
    }
}

/*
 * EYZ from the readings YZ-1y.
 * Source: Sects. 3.2-3.5, closed form. Operations: 17 per point.
 * in readings: 1 rows of stride, mm; displacements read in YZ-1y, less those of the error-free machine (L1)
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 9 values, mm, rad; home positions and location errors (q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz
 *     eps_xz)
 * in points: 6 values, mm; xyz of workpiece point 1, xyz of tool point 2 (rW6x rW6y rW6z rT11x rT11y rT11z)
 * out unknowns: 1 rows of stride, mm, rad; EYZ (identified_EYZ)
 */
void dmu60p_system_8(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT readings,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT points,
    double *TRUEAXIS_RESTRICT unknowns)
{
    /* once per call */
    const double q_wx = parameters[0];
    const double q_wz = parameters[2];
    const double q_Tx = parameters[3];
    const double q_Tz = parameters[5];
    const double eps_yz = parameters[7];
    const double rW6x = points[0];
    const double rW6z = points[2];
    const double rT11x = points[3];
    const double rT11z = points[5];
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
        const double L1 = readings[0 * stride + i];
        const double z = positions[2 * stride + i];
        const double EYY = errors[7 * stride + i];
        const double EAY = errors[9 * stride + i];
        const double ECY = errors[11 * stride + i];
        const double EAZ = errors[15 * stride + i];
        const double ECZ = errors[17 * stride + i];
        unknowns[0 * stride + i] = EAY*(-q_wz - rW6z) + EAZ*(q_Tz + rT11z) + ECY*(q_wx + rW6x) + ECZ*(-q_Tx - rT11x)
            + EYY - L1 + eps_yz*z;
    }
}

/*
 * EZY from the readings YZ-1z.
 * Source: Sects. 3.2-3.5, closed form. Operations: 15 per point.
 * in readings: 1 rows of stride, mm; displacements read in YZ-1z, less those of the error-free machine (L1)
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 9 values, mm, rad; home positions and location errors (q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz
 *     eps_xz)
 * in points: 6 values, mm; xyz of workpiece point 1, xyz of tool point 2 (rW6x rW6y rW6z rT11x rT11y rT11z)
 * out unknowns: 1 rows of stride, mm, rad; EZY (identified_EZY)
 */
void dmu60p_system_9(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT readings,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT points,
    double *TRUEAXIS_RESTRICT unknowns)
{
    (void)positions;
    /* once per call */
    const double q_wx = parameters[0];
    const double q_wy = parameters[1];
    const double q_Tx = parameters[3];
    const double q_Ty = parameters[4];
    const double rW6x = points[0];
    const double rW6y = points[1];
    const double rT11x = points[3];
    const double rT11y = points[4];
    /* per point */
    POINTS_ARE_INDEPENDENT
    for (size_t i = 0; i < n; ++i) {
        const double L1 = readings[0 * stride + i];
        const double EAY = errors[9 * stride + i];
        const double EBY = errors[10 * stride + i];
        const double EZZ = errors[14 * stride + i];
        const double EAZ = errors[15 * stride + i];
        const double EBZ = errors[16 * stride + i];
        unknowns[0 * stride + i] = -EAY*(q_wy + rW6y) - EAZ*(-q_Ty - rT11y) - EBY*(-q_wx - rW6x) - EBZ*(q_Tx +
            rT11x) + EZZ + L1;
    }
}
