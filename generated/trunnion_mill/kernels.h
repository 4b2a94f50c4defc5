/* Generated from machines/trunnion_mill.toml, do not edit; regenerate with: trueaxis derive machines/trunnion_mill.toml
 * SPDX-License-Identifier: MIT
 * Kernels of Five-axis mill with a trunnion table: geometric error model in C17, for C17 and C++17.
 * Spec: sha256 fff68e3a25ed33ff02fbf9ab6e0875735d9de644fc7b3d9d269b461961e2d9f2
 * Equations after: Prediction and compensation of geometric error for translational axes in multi-axis machine tools
 *
 * Every function computes n points; row k of an array that has a value per point holds point i at [k * stride + i],
 * n <= stride. Arrays must not overlap. Lengths mm, angles rad, positions of rotary axes deg.
 *
 * positions: x mm, y mm, z mm, a deg, c deg
 * errors: EXX mm, EYX mm, EZX mm, EAX rad, EBX rad, ECX rad, EXY mm, EYY mm, EZY mm, EAY rad, EBY rad, ECY rad, EXZ
 *     mm, EYZ mm, EZZ mm, EAZ rad, EBZ rad, ECZ rad, EXA mm, EYA mm, EZA mm, EAA rad, EBA rad, ECA rad, EXC mm, EYC
 *     mm, EZC mm, EAC rad, EBC rad, ECC rad
 * parameters: q_Ax mm, q_Ay mm, q_Az mm, q_Cx mm, q_Cy mm, q_Cz mm, q_wx mm, q_wy mm, q_wz mm, q_Tx mm, q_Ty mm, q_Tz
 *     mm, EC0Y rad, EY0A mm, EZ0A mm, EB0A rad, EC0A rad, EX0C mm, EY0C mm, EA0C rad, EB0C rad, EA0Z rad, EB0Z rad
 */
#ifndef TRUNNION_MILL_KERNELS_H
#define TRUNNION_MILL_KERNELS_H

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
int trunnion_mill_kernel_abi(void);

/* SHA-256 of the parsed spec that they were derived from. */
const char *trunnion_mill_spec_hash(void);

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
    double *TRUEAXIS_RESTRICT ideal);

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
    double *TRUEAXIS_RESTRICT deviation);

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
    double *TRUEAXIS_RESTRICT deviation);

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
    double *TRUEAXIS_RESTRICT sensitivity);

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
    double *TRUEAXIS_RESTRICT ideal);

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
    double *TRUEAXIS_RESTRICT deviation);

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
    double *TRUEAXIS_RESTRICT deviation);

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
    double *TRUEAXIS_RESTRICT sensitivity);

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
    double *TRUEAXIS_RESTRICT ideal);

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
    double *TRUEAXIS_RESTRICT deviation);

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
    double *TRUEAXIS_RESTRICT deviation);

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
    double *TRUEAXIS_RESTRICT sensitivity);

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
    double *TRUEAXIS_RESTRICT ideal);

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
    double *TRUEAXIS_RESTRICT deviation);

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
    double *TRUEAXIS_RESTRICT deviation);

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
    double *TRUEAXIS_RESTRICT sensitivity);

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
    double *TRUEAXIS_RESTRICT position);

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
    double *TRUEAXIS_RESTRICT position);

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
    double *TRUEAXIS_RESTRICT ideal);

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
    double *TRUEAXIS_RESTRICT deviation);

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
    double *TRUEAXIS_RESTRICT deviation);

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
    double *TRUEAXIS_RESTRICT deviation);

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
    double *TRUEAXIS_RESTRICT deviation);

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
    double *TRUEAXIS_RESTRICT error);

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
    double *TRUEAXIS_RESTRICT moves);

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
    double *TRUEAXIS_RESTRICT displacement);

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
    double *TRUEAXIS_RESTRICT displacement);

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
    double *TRUEAXIS_RESTRICT displacement);

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
    double *TRUEAXIS_RESTRICT displacement);

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
    double *TRUEAXIS_RESTRICT displacement);

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
    double *TRUEAXIS_RESTRICT displacement);

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
    double *TRUEAXIS_RESTRICT displacement);

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
    double *TRUEAXIS_RESTRICT displacement);

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
void trunnion_mill_effect_backlash(
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
void trunnion_mill_effect_backlash_slope(
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
void trunnion_mill_effect_cyclic(
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
void trunnion_mill_effect_thermal_expansion(
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
void trunnion_mill_effect_thermal_offset(
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
void trunnion_mill_effect_warm_up(
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
void trunnion_mill_effect_drift(
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
void trunnion_mill_effect_servo_lag(
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
void trunnion_mill_effect_reversal_spike(
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
void trunnion_mill_effect_cross_axis(
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
void trunnion_mill_effect_laser_cosine(
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
void trunnion_mill_effect_laser_scale(
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
void trunnion_mill_effect_laser_step(
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
void trunnion_mill_effect_ballbar_length(
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
void trunnion_mill_effect_ballbar_lobes(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT context,
    const double *TRUEAXIS_RESTRICT parameters,
    double *TRUEAXIS_RESTRICT term);

#ifdef __cplusplus
}
#endif

#endif
