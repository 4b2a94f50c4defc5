/* Generated from machines/cframe_mill.toml, do not edit; regenerate with: trueaxis derive machines/cframe_mill.toml
 * SPDX-License-Identifier: MIT
 * Kernels of C-frame mill: geometric error model in C17, for C17 and C++17.
 * Spec: sha256 e0bab1439083d465e60d898b33f648fd88b066b0d41217ad88014752dc9315ad
 * Equations after: Prediction and compensation of geometric error for translational axes in multi-axis machine tools
 *
 * Every function computes n points; row k of an array that has a value per point holds point i at [k * stride + i],
 * n <= stride. Arrays must not overlap. Lengths mm, angles rad.
 *
 * positions: x mm, y mm, z mm
 * errors: EXX mm, EYX mm, EZX mm, EAX rad, EBX rad, ECX rad, EXY mm, EYY mm, EZY mm, EAY rad, EBY rad, ECY rad, EXZ
 *     mm, EYZ mm, EZZ mm, EAZ rad, EBZ rad, ECZ rad
 * parameters: EC0X rad, EA0Z rad, EB0Z rad
 */
#ifndef CFRAME_MILL_KERNELS_H
#define CFRAME_MILL_KERNELS_H

#include <stddef.h>

/* C++ has no `restrict`; its compilers have a word of their own. */
#ifndef TRUEAXIS_RESTRICT
#if !defined(__cplusplus)
#define TRUEAXIS_RESTRICT restrict
#elif defined(__GNUC__) || defined(__clang__) || defined(_MSC_VER)
#define TRUEAXIS_RESTRICT __restrict
#else
#define TRUEAXIS_RESTRICT
#endif
#endif

#define TRUEAXIS_KERNEL_ABI 3

#ifdef __cplusplus
extern "C" {
#endif

/* The ABI that these kernels were compiled with. */
int cframe_mill_kernel_abi(void);

/* SHA-256 of the parsed spec that they were derived from. */
const char *cframe_mill_spec_hash(void);

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
    double *TRUEAXIS_RESTRICT ideal);

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
    double *TRUEAXIS_RESTRICT deviation);

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
    double *TRUEAXIS_RESTRICT deviation);

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
    double *TRUEAXIS_RESTRICT sensitivity);

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
    double *TRUEAXIS_RESTRICT ideal);

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
    double *TRUEAXIS_RESTRICT deviation);

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
    double *TRUEAXIS_RESTRICT deviation);

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
    double *TRUEAXIS_RESTRICT sensitivity);

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
    double *TRUEAXIS_RESTRICT ideal);

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
    double *TRUEAXIS_RESTRICT deviation);

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
    double *TRUEAXIS_RESTRICT deviation);

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
    double *TRUEAXIS_RESTRICT sensitivity);

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
    double *TRUEAXIS_RESTRICT ideal);

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
    double *TRUEAXIS_RESTRICT deviation);

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
    double *TRUEAXIS_RESTRICT deviation);

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
    double *TRUEAXIS_RESTRICT sensitivity);

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
    double *TRUEAXIS_RESTRICT position);

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
    double *TRUEAXIS_RESTRICT position);

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
    double *TRUEAXIS_RESTRICT deviation);

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
    double *TRUEAXIS_RESTRICT deviation);

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
    double *TRUEAXIS_RESTRICT error);

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
    double *TRUEAXIS_RESTRICT moves);

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
    double *TRUEAXIS_RESTRICT displacement);

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
    double *TRUEAXIS_RESTRICT displacement);

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
    double *TRUEAXIS_RESTRICT displacement);

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
    double *TRUEAXIS_RESTRICT displacement);

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
    double *TRUEAXIS_RESTRICT displacement);

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
    double *TRUEAXIS_RESTRICT displacement);

#ifdef __cplusplus
}
#endif

#endif
