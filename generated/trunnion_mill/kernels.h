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

#define TRUEAXIS_KERNEL_ABI 3

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

#ifdef __cplusplus
}
#endif

#endif
