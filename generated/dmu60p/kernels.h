/* Generated from machines/dmu60p.toml, do not edit; regenerate with: trueaxis derive machines/dmu60p.toml
 * SPDX-License-Identifier: MIT
 * Kernels of DECKEL MAHO DMU60P, translational axes: geometric error model in C17, for C17 and C++17.
 * Spec: sha256 0190651706d05e74f47ba63b348c7b25aa718138f26d87af62dcbb754cacd8ee
 * Equations after: Prediction and compensation of geometric error for translational axes in multi-axis machine tools
 *
 * Every function computes n points; row k of an array that has a value per point holds point i at [k * stride + i],
 * n <= stride. Arrays must not overlap. Lengths mm, angles rad.
 *
 * positions: x mm, y mm, z mm
 * errors: EXX mm, EYX mm, EZX mm, EAX rad, EBX rad, ECX rad, EXY mm, EYY mm, EZY mm, EAY rad, EBY rad, ECY rad, EXZ
 *     mm, EYZ mm, EZZ mm, EAZ rad, EBZ rad, ECZ rad
 * parameters: q_wx mm, q_wy mm, q_wz mm, q_Tx mm, q_Ty mm, q_Tz mm, eps_xy rad, eps_yz rad, eps_xz rad
 */
#ifndef DMU60P_KERNELS_H
#define DMU60P_KERNELS_H

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

#define TRUEAXIS_KERNEL_ABI 2

#ifdef __cplusplus
extern "C" {
#endif

/* The ABI that these kernels were compiled with. */
int dmu60p_kernel_abi(void);

/* SHA-256 of the parsed spec that they were derived from. */
const char *dmu60p_spec_hash(void);

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
    double *TRUEAXIS_RESTRICT ideal);

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
    double *TRUEAXIS_RESTRICT deviation);

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
    double *TRUEAXIS_RESTRICT deviation);

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
    double *TRUEAXIS_RESTRICT sensitivity);

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
    double *TRUEAXIS_RESTRICT ideal);

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
    double *TRUEAXIS_RESTRICT deviation);

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
    double *TRUEAXIS_RESTRICT deviation);

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
    double *TRUEAXIS_RESTRICT sensitivity);

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
    double *TRUEAXIS_RESTRICT ideal);

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
    double *TRUEAXIS_RESTRICT deviation);

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
    double *TRUEAXIS_RESTRICT deviation);

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
    double *TRUEAXIS_RESTRICT sensitivity);

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
    double *TRUEAXIS_RESTRICT ideal);

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
    double *TRUEAXIS_RESTRICT deviation);

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
    double *TRUEAXIS_RESTRICT deviation);

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
    double *TRUEAXIS_RESTRICT sensitivity);

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
    double *TRUEAXIS_RESTRICT position);

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
    double *TRUEAXIS_RESTRICT position);

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
    double *TRUEAXIS_RESTRICT deviation);

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
    double *TRUEAXIS_RESTRICT deviation);

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
    double *TRUEAXIS_RESTRICT error);

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
    double *TRUEAXIS_RESTRICT moves);

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
    double *TRUEAXIS_RESTRICT displacement);

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
    double *TRUEAXIS_RESTRICT displacement);

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
    double *TRUEAXIS_RESTRICT displacement);

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
    double *TRUEAXIS_RESTRICT displacement);

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
    double *TRUEAXIS_RESTRICT displacement);

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
    double *TRUEAXIS_RESTRICT displacement);

/*
 * EXX, EBX, ECX from the readings.
 * Source: Sects. 3.2-3.5, closed form. Operations: 38 per point, 22 once per call.
 * in readings: 3 rows of stride, mm; readings of, X-3 (L1 L2 L3)
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 9 values, mm, rad; home positions and location errors (q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz
 *     eps_xz)
 * in points: 9 values, mm; xyz of tool point 1, xyz of tool point 2, xyz of tool point 3 (rT1x rT1y rT1z rT2x rT2y
 *     rT2z rT3x rT3y rT3z)
 * out unknowns: 3 rows of stride, mm, rad; EXX, EBX, ECX (found_EXX found_EBX found_ECX)
 */
void dmu60p_system_1(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT readings,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT points,
    double *TRUEAXIS_RESTRICT unknowns);

/*
 * EYY, EAY, ECY from the readings Y-4, Y-5, Y-6.
 * Source: Sects. 3.2-3.5, closed form. Operations: 38 per point, 22 once per call.
 * in readings: 3 rows of stride, mm; readings of Y-4, Y-5, Y-6 (L1 L2 L3)
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 9 values, mm, rad; home positions and location errors (q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz
 *     eps_xz)
 * in points: 9 values, mm; xyz of workpiece point 1, xyz of workpiece point 2, xyz of workpiece point 3 (rW1x rW1y
 *     rW1z rW2x rW2y rW2z rW3x rW3y rW3z)
 * out unknowns: 3 rows of stride, mm, rad; EYY, EAY, ECY (found_EYY found_EAY found_ECY)
 */
void dmu60p_system_2(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT readings,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT points,
    double *TRUEAXIS_RESTRICT unknowns);

/*
 * EZZ, EAZ, EBZ from the readings Z-7, Z-8, Z-9.
 * Source: Sects. 3.2-3.5, closed form. Operations: 38 per point, 22 once per call.
 * in readings: 3 rows of stride, mm; readings of Z-7, Z-8, Z-9 (L1 L2 L3)
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 9 values, mm, rad; home positions and location errors (q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz
 *     eps_xz)
 * in points: 9 values, mm; xyz of tool point 1, xyz of tool point 2, xyz of tool point 3 (rT4x rT4y rT4z rT5x rT5y
 *     rT5z rT6x rT6y rT6z)
 * out unknowns: 3 rows of stride, mm, rad; EZZ, EAZ, EBZ (found_EZZ found_EAZ found_EBZ)
 */
void dmu60p_system_3(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT readings,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT points,
    double *TRUEAXIS_RESTRICT unknowns);

/*
 * EXZ, ECZ from the readings XZ-1x, XZ-2x.
 * Source: Sects. 3.2-3.5, closed form. Operations: 25 per point, 7 once per call.
 * in readings: 2 rows of stride, mm; readings of XZ-1x, XZ-2x (L1 L2)
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 9 values, mm, rad; home positions and location errors (q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz
 *     eps_xz)
 * in points: 6 values, mm; xyz of tool point 1, xyz of tool point 2 (rT7x rT7y rT7z rT8x rT8y rT8z)
 * out unknowns: 2 rows of stride, mm, rad; EXZ, ECZ (found_EXZ found_ECZ)
 */
void dmu60p_system_4(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT readings,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT points,
    double *TRUEAXIS_RESTRICT unknowns);

/*
 * EZX, EAX from the readings XZ-1z, XZ-2z.
 * Source: Sects. 3.2-3.5, closed form. Operations: 21 per point, 8 once per call.
 * in readings: 2 rows of stride, mm; readings of XZ-1z, XZ-2z (L1 L2)
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 9 values, mm, rad; home positions and location errors (q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz
 *     eps_xz)
 * in points: 6 values, mm; xyz of tool point 1, xyz of tool point 2 (rT7x rT7y rT7z rT8x rT8y rT8z)
 * out unknowns: 2 rows of stride, mm, rad; EZX, EAX (found_EZX found_EAX)
 */
void dmu60p_system_5(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT readings,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT points,
    double *TRUEAXIS_RESTRICT unknowns);

/*
 * EXY, EBY from the readings XY-1x, XY-2x.
 * Source: Sects. 3.2-3.5, closed form. Operations: 34 per point, 2 once per call.
 * in readings: 2 rows of stride, mm; readings of XY-1x, XY-2x (L1 L2)
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 9 values, mm, rad; home positions and location errors (q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz
 *     eps_xz)
 * in points: 12 values, mm; xyz of workpiece point 1, xyz of tool point 2, xyz of workpiece point 3, xyz of tool point
 *     4 (rW4x rW4y rW4z rT9x rT9y rT9z rW5x rW5y rW5z rT10x rT10y rT10z)
 * out unknowns: 2 rows of stride, mm, rad; EXY, EBY (found_EXY found_EBY)
 */
void dmu60p_system_6(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT readings,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT points,
    double *TRUEAXIS_RESTRICT unknowns);

/*
 * EYX from the readings XY-1y.
 * Source: Sects. 3.2-3.5, closed form. Operations: 17 per point.
 * in readings: 1 rows of stride, mm; readings of XY-1y (L1)
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 9 values, mm, rad; home positions and location errors (q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz
 *     eps_xz)
 * in points: 6 values, mm; xyz of workpiece point 1, xyz of tool point 2 (rW4x rW4y rW4z rT9x rT9y rT9z)
 * out unknowns: 1 rows of stride, mm, rad; EYX (found_EYX)
 */
void dmu60p_system_7(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT readings,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT points,
    double *TRUEAXIS_RESTRICT unknowns);

/*
 * EYZ from the readings YZ-1y.
 * Source: Sects. 3.2-3.5, closed form. Operations: 17 per point.
 * in readings: 1 rows of stride, mm; readings of YZ-1y (L1)
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 9 values, mm, rad; home positions and location errors (q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz
 *     eps_xz)
 * in points: 6 values, mm; xyz of workpiece point 1, xyz of tool point 2 (rW6x rW6y rW6z rT11x rT11y rT11z)
 * out unknowns: 1 rows of stride, mm, rad; EYZ (found_EYZ)
 */
void dmu60p_system_8(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT readings,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT points,
    double *TRUEAXIS_RESTRICT unknowns);

/*
 * EZY from the readings YZ-1z.
 * Source: Sects. 3.2-3.5, closed form. Operations: 15 per point.
 * in readings: 1 rows of stride, mm; readings of YZ-1z (L1)
 * in positions: 3 rows of stride, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 9 values, mm, rad; home positions and location errors (q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz
 *     eps_xz)
 * in points: 6 values, mm; xyz of workpiece point 1, xyz of tool point 2 (rW6x rW6y rW6z rT11x rT11y rT11z)
 * out unknowns: 1 rows of stride, mm, rad; EZY (found_EZY)
 */
void dmu60p_system_9(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT readings,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT points,
    double *TRUEAXIS_RESTRICT unknowns);

/*
 * Term of the effect backlash: play or elastic wind-up in the drive (along the axis: lost motion) or in the guides
 * (across: lateral play).
 * Source: backlash = width/2*direction. Operations: 2 per point.
 * in context: 1 rows of stride, 1; direction: direction by which the axis came: +1, -1, 0 before it has moved (u: unit
 *     of the component, axis: of its axis) (direction)
 * in parameters: 1 values, u; width: lost motion: jump between the two directions of approach (u: unit of the
 *     component, axis: of its axis) (width)
 * out term: 2 rows of stride, u; the term in u, then its derivative by width (term term_by_width)
 */
void dmu60p_effect_backlash(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT context,
    const double *TRUEAXIS_RESTRICT parameters,
    double *TRUEAXIS_RESTRICT term);

/*
 * Term of the effect backlash_slope: lost motion that varies along the travel: a worn part of the screw, wind-up that
 * depends on its free length.
 * Source: backlash_slope = change*direction*(s - 1/2). Operations: 4 per point.
 * in context: 2 rows of stride, 1, 1; s: share of its travel, 0 at the lower end and 1 at the upper; direction:
 *     direction by which the axis came: +1, -1, 0 before it has moved (u: unit of the component, axis: of its axis) (s
 *     direction)
 * in parameters: 1 values, u; change: change of half the lost motion from one end of the travel to the other (u: unit
 *     of the component, axis: of its axis) (change)
 * out term: 2 rows of stride, u; the term in u, then its derivative by change (term term_by_change)
 */
void dmu60p_effect_backlash_slope(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT context,
    const double *TRUEAXIS_RESTRICT parameters,
    double *TRUEAXIS_RESTRICT term);

/*
 * Term of the effect cyclic: a periodic error: pitch of the screw, its coupling, an eccentric encoder, interpolation
 * of a scale.
 * Source: cyclic = amplitude*cos(2*pi*q/pitch + phase). Operations: 12 per point.
 * in context: 1 rows of stride, axis; q: commanded position of the axis (u: unit of the component, axis: of its axis)
 *     (q)
 * in parameters: 3 values, u, rad, axis; amplitude: amplitude; phase: phase at position 0; pitch: period (u: unit of
 *     the component, axis: of its axis) (amplitude phase pitch)
 * out term: 4 rows of stride, u; the term in u, then its derivative by amplitude, phase, pitch (term term_by_amplitude
 *     term_by_phase term_by_pitch)
 */
void dmu60p_effect_cyclic(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT context,
    const double *TRUEAXIS_RESTRICT parameters,
    double *TRUEAXIS_RESTRICT term);

/*
 * Term of the effect thermal_expansion: a scale or screw that grows with its temperature.
 * Source: thermal_expansion = coefficient*q*T. Operations: 2 per point.
 * in context: 2 rows of stride, axis, K; q: commanded position of the axis; T: temperature less 20 degC (u: unit of
 *     the component, axis: of its axis) (q T)
 * in parameters: 1 values, u/axis/K; coefficient: expansion per kelvin (u: unit of the component, axis: of its axis)
 *     (coefficient)
 * out term: 2 rows of stride, u; the term in u, then its derivative by coefficient (term term_by_coefficient)
 */
void dmu60p_effect_thermal_expansion(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT context,
    const double *TRUEAXIS_RESTRICT parameters,
    double *TRUEAXIS_RESTRICT term);

/*
 * Term of the effect thermal_offset: a structure that bends or shifts with its temperature.
 * Source: thermal_offset = coefficient*T. Operations: 1 per point.
 * in context: 1 rows of stride, K; T: temperature less 20 degC (u: unit of the component, axis: of its axis) (T)
 * in parameters: 1 values, u/K; coefficient: displacement or rotation per kelvin (u: unit of the component, axis: of
 *     its axis) (coefficient)
 * out term: 2 rows of stride, u; the term in u, then its derivative by coefficient (term term_by_coefficient)
 */
void dmu60p_effect_thermal_offset(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT context,
    const double *TRUEAXIS_RESTRICT parameters,
    double *TRUEAXIS_RESTRICT term);

/*
 * Term of the effect warm_up: a screw or scale that warms up by its own friction.
 * Source: warm_up = amplitude*s*exp(-t/tau). Operations: 7 per point.
 * in context: 2 rows of stride, 1, s; s: share of its travel, 0 at the lower end and 1 at the upper; t: time of the
 *     reading (u: unit of the component, axis: of its axis) (s t)
 * in parameters: 2 values, u, s; amplitude: growth still to come at time 0, at the upper end of the travel; tau: time
 *     constant (u: unit of the component, axis: of its axis) (amplitude tau)
 * out term: 3 rows of stride, u; the term in u, then its derivative by amplitude, tau (term term_by_amplitude
 *     term_by_tau)
 */
void dmu60p_effect_warm_up(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT context,
    const double *TRUEAXIS_RESTRICT parameters,
    double *TRUEAXIS_RESTRICT term);

/*
 * Term of the effect drift: something creeps while it is measured: temperature, foundation, fixture.
 * Source: drift = rate*t. Operations: 1 per point.
 * in context: 1 rows of stride, s; t: time of the reading (u: unit of the component, axis: of its axis) (t)
 * in parameters: 1 values, u/s; rate: change per second (u: unit of the component, axis: of its axis) (rate)
 * out term: 2 rows of stride, u; the term in u, then its derivative by rate (term term_by_rate)
 */
void dmu60p_effect_drift(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT context,
    const double *TRUEAXIS_RESTRICT parameters,
    double *TRUEAXIS_RESTRICT term);

/*
 * Term of the effect servo_lag: following error of the position loop; only its difference between axes shows in a
 * circle.
 * Source: servo_lag = -tau*v. Operations: 3 per point.
 * in context: 1 rows of stride, axis/s; v: its velocity while the reading is taken, 0 where it stands (u: unit of the
 *     component, axis: of its axis) (v)
 * in parameters: 1 values, s; tau: time by which the axis follows behind its command, beyond that of the others (u:
 *     unit of the component, axis: of its axis) (tau)
 * out term: 2 rows of stride, u; the term in u, then its derivative by tau (term term_by_tau)
 */
void dmu60p_effect_servo_lag(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT context,
    const double *TRUEAXIS_RESTRICT parameters,
    double *TRUEAXIS_RESTRICT term);

/*
 * Term of the effect reversal_spike: friction that the position loop has to overcome at a reversal (quadrant glitch).
 * Source: reversal_spike = height*direction*exp(-d/decay). Operations: 7 per point.
 * in context: 2 rows of stride, 1, axis; direction: direction by which the axis came: +1, -1, 0 before it has moved;
 *     d: distance since its last reversal, 1e9 before the first (u: unit of the component, axis: of its axis)
 *     (direction d)
 * in parameters: 2 values, u, axis; height: height right after the reversal; decay: way over which it dies away (u:
 *     unit of the component, axis: of its axis) (height decay)
 * out term: 3 rows of stride, u; the term in u, then its derivative by height, decay (term term_by_height
 *     term_by_decay)
 */
void dmu60p_effect_reversal_spike(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT context,
    const double *TRUEAXIS_RESTRICT parameters,
    double *TRUEAXIS_RESTRICT term);

/*
 * Term of the effect cross_axis: a body that bends under another one: the component error of one axis depends on where
 * another axis stands.
 * Source: cross_axis = k*s*s_b^2. Operations: 3 per point.
 * in context: 2 rows of stride, 1, 1; s: share of its travel, 0 at the lower end and 1 at the upper; s_b: share of its
 *     travel, 0 at the lower end and 1 at the upper (the other axis) (u: unit of the component, axis: of its axis) (s
 *     s_b)
 * in parameters: 1 values, u; k: value at the far ends of both travels (u: unit of the component, axis: of its axis)
 *     (k)
 * out term: 2 rows of stride, u; the term in u, then its derivative by k (term term_by_k)
 */
void dmu60p_effect_cross_axis(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT context,
    const double *TRUEAXIS_RESTRICT parameters,
    double *TRUEAXIS_RESTRICT term);

/*
 * Term of the effect laser_cosine: the laser beam was not parallel to the motion: it reads short.
 * Source: laser_cosine = -angle^2/2*along. Operations: 6 per point.
 * in context: 1 rows of stride, mm; along: ideal displacement that the instrument senses, since home (along)
 * in parameters: 1 values, rad; angle: angle between beam and motion (angle)
 * out term: 2 rows of stride, mm; the term in mm, then its derivative by angle (term term_by_angle)
 */
void dmu60p_effect_laser_cosine(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT context,
    const double *TRUEAXIS_RESTRICT parameters,
    double *TRUEAXIS_RESTRICT term);

/*
 * Term of the effect laser_scale: wavelength of the laser: air temperature, pressure or humidity were not what was
 * entered.
 * Source: laser_scale = k*along. Operations: 1 per point.
 * in context: 1 rows of stride, mm; along: ideal displacement that the instrument senses, since home (along)
 * in parameters: 1 values, 1; k: relative error of all laser distances (k)
 * out term: 2 rows of stride, mm; the term in mm, then its derivative by k (term term_by_k)
 */
void dmu60p_effect_laser_scale(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT context,
    const double *TRUEAXIS_RESTRICT parameters,
    double *TRUEAXIS_RESTRICT term);

/*
 * Term of the effect laser_step: something slipped or lost counts in the middle of a run.
 * Source: laser_step = jump*step(t - t_0). Operations: 3 per point.
 * in context: 1 rows of stride, s; t: time of the reading (t)
 * in parameters: 2 values, mm, s; jump: height of the jump; t_0: moment of the jump (jump t_0)
 * out term: 3 rows of stride, mm; the term in mm, then its derivative by jump, t_0 (term term_by_jump term_by_t_0)
 */
void dmu60p_effect_laser_step(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT context,
    const double *TRUEAXIS_RESTRICT parameters,
    double *TRUEAXIS_RESTRICT term);

/*
 * Term of the effect ballbar_length: the bar is longer than it is said to be (shorter, where the length is negative).
 * Source: ballbar_length = length. Operations: 0 per point.
 * in context: 1 rows of stride, rad; theta: polar angle of a ball bar in the plane of its circle (theta)
 * in parameters: 1 values, mm; length: actual minus nominal length of the bar (length)
 * out term: 2 rows of stride, mm; the term in mm, then its derivative by length (term term_by_length)
 */
void dmu60p_effect_ballbar_length(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT context,
    const double *TRUEAXIS_RESTRICT parameters,
    double *TRUEAXIS_RESTRICT term);

/*
 * Term of the effect ballbar_lobes: form error of the balls or of the bar's sockets: three lobes.
 * Source: ballbar_lobes = amplitude*cos(3*theta + phase). Operations: 7 per point.
 * in context: 1 rows of stride, rad; theta: polar angle of a ball bar in the plane of its circle (theta)
 * in parameters: 2 values, mm, rad; amplitude: amplitude; phase: phase at polar angle 0 (amplitude phase)
 * out term: 3 rows of stride, mm; the term in mm, then its derivative by amplitude, phase (term term_by_amplitude
 *     term_by_phase)
 */
void dmu60p_effect_ballbar_lobes(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT context,
    const double *TRUEAXIS_RESTRICT parameters,
    double *TRUEAXIS_RESTRICT term);

#ifdef __cplusplus
}
#endif

#endif
