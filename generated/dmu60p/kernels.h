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

#define TRUEAXIS_KERNEL_ABI 3

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
 * EXX, ECX, EBX from the readings.
 * Source: Sects. 3.2-3.5, closed form. Operations: 39 per point, 22 once per call.
 * in readings: 3 rows of stride, mm; displacements read in, less those of the error-free machine (L1 L2
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
    double *TRUEAXIS_RESTRICT unknowns);

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
    double *TRUEAXIS_RESTRICT unknowns);

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
    double *TRUEAXIS_RESTRICT unknowns);

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
    double *TRUEAXIS_RESTRICT unknowns);

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
    double *TRUEAXIS_RESTRICT unknowns);

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
    double *TRUEAXIS_RESTRICT unknowns);

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
    double *TRUEAXIS_RESTRICT unknowns);

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
    double *TRUEAXIS_RESTRICT unknowns);

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
    double *TRUEAXIS_RESTRICT unknowns);

#ifdef __cplusplus
}
#endif

#endif
