/* Generated from machines/dmu60p_5axis.toml, do not edit; regenerate with: trueaxis derive machines/dmu60p_5axis.toml
 * SPDX-License-Identifier: MIT
 * Kernels of DECKEL MAHO DMU60P, all five axes: geometric error model in C17, for C17 and C++17.
 * Spec: sha256 1b0a63b86ea881e06983b884ca7f951aa51e2ebb46ef2eaccf5755fd64d1985f
 * Equations after: Prediction and compensation of geometric error for translational axes in multi-axis machine tools
 *
 * Every function computes n points; row k of an array that has a value per point holds point i at [k * stride + i],
 * n <= stride. Arrays must not overlap. Lengths mm, angles rad, positions of rotary axes deg.
 *
 * positions: x mm, y mm, z mm, b deg, c deg
 * errors: EXX mm, EYX mm, EZX mm, EAX rad, EBX rad, ECX rad, EXY mm, EYY mm, EZY mm, EAY rad, EBY rad, ECY rad, EXZ
 *     mm, EYZ mm, EZZ mm, EAZ rad, EBZ rad, ECZ rad, EXB mm, EYB mm, EZB mm, EAB rad, EBB rad, ECB rad, EXC mm, EYC
 *     mm, EZC mm, EAC rad, EBC rad, ECC rad
 * parameters: q_Cx mm, q_Cy mm, q_Cz mm, q_wx mm, q_wy mm, q_wz mm, q_Bx mm, q_By mm, q_Bz mm, q_Sx mm, q_Sy mm, q_Sz
 *     mm, q_Tx mm, q_Ty mm, q_Tz mm, EX0C mm, EY0C mm, EA0C rad, EB0C rad, eps_xy rad, eps_yz rad, eps_xz rad, EX0B
 *     mm, EZ0B mm, EA0B rad, EC0B rad
 */
#ifndef DMU60P_5AXIS_KERNELS_H
#define DMU60P_5AXIS_KERNELS_H

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
int dmu60p_5axis_kernel_abi(void);

/* SHA-256 of the parsed spec that they were derived from. */
const char *dmu60p_5axis_spec_hash(void);

/*
 * Ideal position of a tool point in the workpiece frame.
 * Source: Eqs. (1)-(4) without errors. Operations: 87 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out ideal: 3 rows of stride, mm; tool point in the workpiece frame, without errors (px py pz)
 */
void dmu60p_5axis_tool_in_workpiece_ideal(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT ideal);

/*
 * Deviation of a tool point in the workpiece frame, exact.
 * Source: Eqs. (1)-(4). Operations: 244 per point, 5 once per call.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; tool point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void dmu60p_5axis_tool_in_workpiece_deviation(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation);

/*
 * Deviation of a tool point in the workpiece frame, to first order in the errors.
 * Source: Eqs. (1)-(4). Operations: 151 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; tool point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void dmu60p_5axis_tool_in_workpiece_deviation_first_order(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation);

/*
 * Sensitivity of a tool point in the workpiece frame to every error, at the error-free machine.
 * Source: Eqs. (1)-(4), first order. Operations: 219 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out sensitivity: 123 rows of stride, mm/mm, mm/rad; derivative of the deviation by each component error, then by
 *     each location error (dx_EXX dx_EYX .. dz_EC0B, last index fastest)
 */
void dmu60p_5axis_tool_in_workpiece_sensitivity(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT sensitivity);

/*
 * Ideal position of a tool point in the bed frame.
 * Source: Eqs. (1)-(4) without errors. Operations: 33 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out ideal: 3 rows of stride, mm; tool point in the bed frame, without errors (px py pz)
 */
void dmu60p_5axis_tool_in_bed_ideal(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT ideal);

/*
 * Deviation of a tool point in the bed frame, exact.
 * Source: Eqs. (1)-(4). Operations: 105 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; tool point in the bed frame, actual minus ideal (dx dy dz)
 */
void dmu60p_5axis_tool_in_bed_deviation(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation);

/*
 * Deviation of a tool point in the bed frame, to first order in the errors.
 * Source: Eqs. (1)-(4). Operations: 91 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; tool point in the bed frame, actual minus ideal (dx dy dz)
 */
void dmu60p_5axis_tool_in_bed_deviation_first_order(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation);

/*
 * Sensitivity of a tool point in the bed frame to every error, at the error-free machine.
 * Source: Eqs. (1)-(4), first order. Operations: 57 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out sensitivity: 123 rows of stride, mm/mm, mm/rad; derivative of the deviation by each component error, then by
 *     each location error (dx_EXX dx_EYX .. dz_EC0B, last index fastest)
 */
void dmu60p_5axis_tool_in_bed_sensitivity(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT sensitivity);

/*
 * Ideal position of a workpiece point in the bed frame.
 * Source: Eqs. (1)-(4) without errors. Operations: 23 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in point: 3 rows of stride, mm; point in the workpiece frame (rx ry rz)
 * out ideal: 3 rows of stride, mm; workpiece point in the bed frame, without errors (px py pz)
 */
void dmu60p_5axis_workpiece_in_bed_ideal(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT ideal);

/*
 * Deviation of a workpiece point in the bed frame, exact.
 * Source: Eqs. (1)-(4). Operations: 65 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in point: 3 rows of stride, mm; point in the workpiece frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; workpiece point in the bed frame, actual minus ideal (dx dy dz)
 */
void dmu60p_5axis_workpiece_in_bed_deviation(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation);

/*
 * Deviation of a workpiece point in the bed frame, to first order in the errors.
 * Source: Eqs. (1)-(4). Operations: 59 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in point: 3 rows of stride, mm; point in the workpiece frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; workpiece point in the bed frame, actual minus ideal (dx dy dz)
 */
void dmu60p_5axis_workpiece_in_bed_deviation_first_order(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation);

/*
 * Sensitivity of a workpiece point in the bed frame to every error, at the error-free machine.
 * Source: Eqs. (1)-(4), first order. Operations: 39 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in point: 3 rows of stride, mm; point in the workpiece frame (rx ry rz)
 * out sensitivity: 123 rows of stride, mm/mm, mm/rad; derivative of the deviation by each component error, then by
 *     each location error (dx_EXX dx_EYX .. dz_EC0B, last index fastest)
 */
void dmu60p_5axis_workpiece_in_bed_sensitivity(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT sensitivity);

/*
 * Ideal position of a bed point in the workpiece frame.
 * Source: Eqs. (1)-(4) without errors. Operations: 26 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in point: 3 rows of stride, mm; point in the bed frame (rx ry rz)
 * out ideal: 3 rows of stride, mm; bed point in the workpiece frame, without errors (px py pz)
 */
void dmu60p_5axis_bed_in_workpiece_ideal(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT ideal);

/*
 * Deviation of a bed point in the workpiece frame, exact.
 * Source: Eqs. (1)-(4). Operations: 142 per point, 5 once per call.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in point: 3 rows of stride, mm; point in the bed frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; bed point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void dmu60p_5axis_bed_in_workpiece_deviation(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation);

/*
 * Deviation of a bed point in the workpiece frame, to first order in the errors.
 * Source: Eqs. (1)-(4). Operations: 57 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in point: 3 rows of stride, mm; point in the bed frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; bed point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void dmu60p_5axis_bed_in_workpiece_deviation_first_order(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation);

/*
 * Sensitivity of a bed point in the workpiece frame to every error, at the error-free machine.
 * Source: Eqs. (1)-(4), first order. Operations: 48 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in point: 3 rows of stride, mm; point in the bed frame (rx ry rz)
 * out sensitivity: 123 rows of stride, mm/mm, mm/rad; derivative of the deviation by each component error, then by
 *     each location error (dx_EXX dx_EYX .. dz_EC0B, last index fastest)
 */
void dmu60p_5axis_bed_in_workpiece_sensitivity(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT sensitivity);

/*
 * Actual position of the tool point in the workpiece frame, exact.
 * Source: Eq. (4). Operations: 250 per point, 5 once per call.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out position: 3 rows of stride, mm; actual position P_T^W of the tool point in the workpiece frame (px py pz)
 */
void dmu60p_5axis_tool_in_workpiece_position(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT position);

/*
 * Actual position of the tool point in the workpiece frame, to first order.
 * Source: Eq. (4). Operations: 157 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * out position: 3 rows of stride, mm; actual position P_T^W of the tool point in the workpiece frame (px py pz)
 */
void dmu60p_5axis_tool_in_workpiece_position_first_order(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT position);

/*
 * Ideal direction of a vector of the tool frame in the workpiece frame.
 * Source: Eqs. (1)-(4) without errors, rotations alone. Operations: 20 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in direction: 3 rows of stride, 1; unit vector in the tool frame, (0, 0, 1) for the tool axis (tx ty tz)
 * out ideal: 3 rows of stride, 1; the vector in the workpiece frame, without errors (ix iy iz)
 */
void dmu60p_5axis_tool_orientation_ideal(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT direction,
    double *TRUEAXIS_RESTRICT ideal);

/*
 * Deviation of a direction of the tool frame in the workpiece frame, exact.
 * Source: Eqs. (1)-(4), rotations alone. Operations: 210 per point, 5 once per call.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in direction: 3 rows of stride, 1; unit vector in the tool frame, (0, 0, 1) for the tool axis (tx ty tz)
 * out deviation: 3 rows of stride, 1; the vector in the workpiece frame, actual minus ideal (dx dy dz)
 */
void dmu60p_5axis_tool_orientation_deviation(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT direction,
    double *TRUEAXIS_RESTRICT deviation);

/*
 * Deviation of a direction of the tool frame in the workpiece frame, to first order.
 * Source: Eqs. (1)-(4), rotations alone. Operations: 117 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in direction: 3 rows of stride, 1; unit vector in the tool frame, (0, 0, 1) for the tool axis (tx ty tz)
 * out deviation: 3 rows of stride, 1; the vector in the workpiece frame, actual minus ideal (dx dy dz)
 */
void dmu60p_5axis_tool_orientation_deviation_first_order(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT direction,
    double *TRUEAXIS_RESTRICT deviation);

/*
 * Deviation of the tool point under polynomial error curves, exact.
 * Source: Eqs. (1)-(4), (44). Operations: 627 per point, 12 once per call.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in curves: 210 values, mm/mm^k, rad/mm^k (deg^k for rotary axes); coefficients of the powers 1 to 7 of the axis
 *     position, per component error (EXX_1 EXX_2 .. ECC_7, last index fastest)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in point: 3 values, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; tool point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void dmu60p_5axis_tool_in_workpiece_deviation_curves(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT curves,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation);

/*
 * Deviation of the tool point under polynomial error curves, to first order.
 * Source: Eqs. (1)-(4), (44). Operations: 534 per point, 7 once per call.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in curves: 210 values, mm/mm^k, rad/mm^k (deg^k for rotary axes); coefficients of the powers 1 to 7 of the axis
 *     position, per component error (EXX_1 EXX_2 .. ECC_7, last index fastest)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in point: 3 values, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 rows of stride, mm; tool point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void dmu60p_5axis_tool_in_workpiece_deviation_first_order_curves(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT curves,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT point,
    double *TRUEAXIS_RESTRICT deviation);

/*
 * Positioning error of a ball bar between a tool ball and a workpiece ball, exact.
 * Source: Eqs. (5), (6). Operations: 283 per point, 5 once per call.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in point: 3 rows of stride, mm; point in the tool frame (rx ry rz)
 * in ball: 3 rows of stride, mm; point in the workpiece frame (bx by bz)
 * in length: 1 rows of stride, mm; ideal length of the ball bar (length)
 * out error: 4 rows of stride, mm; positioning error E, then its components E_x, E_y, E_z (e ex ey ez)
 */
void dmu60p_5axis_ballbar_error(
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
 * Source: Eqs. (53)-(55), inverse. Operations: 11 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in deviation: 3 rows of stride, mm; displacement of the tool point in the workpiece frame (dx dy dz)
 * out moves: 3 rows of stride, mm; moves of X Y Z (move_x move_y move_z)
 */
void dmu60p_5axis_correction(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT deviation,
    double *TRUEAXIS_RESTRICT moves);

/*
 * Motion equation of X: displacement of the tool point since home, to first order.
 * Source: Eqs. (7)-(11). Operations: 24 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in tool_point: 3 rows of stride, mm; point in the tool frame (rTx rTy rTz)
 * out displacement: 3 rows of stride, mm; tool point, displacement since home, in the bed frame (dx dy dz)
 */
void dmu60p_5axis_motion_X(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT tool_point,
    double *TRUEAXIS_RESTRICT displacement);

/*
 * Motion equation of Y: displacement of the workpiece point since home, to first order.
 * Source: Eqs. (7)-(11). Operations: 19 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in workpiece_point: 3 rows of stride, mm; point in the workpiece frame (rWx rWy rWz)
 * out displacement: 3 rows of stride, mm; workpiece point, displacement since home, in the bed frame (dx dy dz)
 */
void dmu60p_5axis_motion_Y(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT workpiece_point,
    double *TRUEAXIS_RESTRICT displacement);

/*
 * Motion equation of Z: displacement of the tool point since home, to first order.
 * Source: Eqs. (7)-(11). Operations: 26 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in tool_point: 3 rows of stride, mm; point in the tool frame (rTx rTy rTz)
 * out displacement: 3 rows of stride, mm; tool point, displacement since home, in the bed frame (dx dy dz)
 */
void dmu60p_5axis_motion_Z(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT tool_point,
    double *TRUEAXIS_RESTRICT displacement);

/*
 * Motion equation of B: displacement of the tool point since home, to first order.
 * Source: Eqs. (7)-(11). Operations: 91 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in tool_point: 3 rows of stride, mm; point in the tool frame (rTx rTy rTz)
 * out displacement: 3 rows of stride, mm; tool point, displacement since home, in the bed frame (dx dy dz)
 */
void dmu60p_5axis_motion_B(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT tool_point,
    double *TRUEAXIS_RESTRICT displacement);

/*
 * Motion equation of C: displacement of the workpiece point since home, to first order.
 * Source: Eqs. (7)-(11). Operations: 62 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in workpiece_point: 3 rows of stride, mm; point in the workpiece frame (rWx rWy rWz)
 * out displacement: 3 rows of stride, mm; workpiece point, displacement since home, in the bed frame (dx dy dz)
 */
void dmu60p_5axis_motion_C(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT workpiece_point,
    double *TRUEAXIS_RESTRICT displacement);

/*
 * Motion equation of X and Y: displacement of the workpiece point minus tool point since home, to first order.
 * Source: Eqs. (7)-(11). Operations: 46 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in workpiece_point: 3 rows of stride, mm; point in the workpiece frame (rWx rWy rWz)
 * in tool_point: 3 rows of stride, mm; point in the tool frame (rTx rTy rTz)
 * out displacement: 3 rows of stride, mm; workpiece point minus tool point, displacement since home, in the bed frame
 *     (dx dy dz)
 */
void dmu60p_5axis_motion_XY(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT workpiece_point,
    const double *TRUEAXIS_RESTRICT tool_point,
    double *TRUEAXIS_RESTRICT displacement);

/*
 * Motion equation of X and Z: displacement of the tool point since home, to first order.
 * Source: Eqs. (7)-(11). Operations: 47 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in tool_point: 3 rows of stride, mm; point in the tool frame (rTx rTy rTz)
 * out displacement: 3 rows of stride, mm; tool point, displacement since home, in the bed frame (dx dy dz)
 */
void dmu60p_5axis_motion_XZ(
    size_t n, size_t stride,
    const double *TRUEAXIS_RESTRICT positions,
    const double *TRUEAXIS_RESTRICT errors,
    const double *TRUEAXIS_RESTRICT parameters,
    const double *TRUEAXIS_RESTRICT tool_point,
    double *TRUEAXIS_RESTRICT displacement);

/*
 * Motion equation of Y and Z: displacement of the workpiece point minus tool point since home, to first order.
 * Source: Eqs. (7)-(11). Operations: 48 per point.
 * in positions: 5 rows of stride, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 rows of stride, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY
 *     ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 26 values, mm, rad; home positions and location errors (q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz
 *     q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B)
 * in workpiece_point: 3 rows of stride, mm; point in the workpiece frame (rWx rWy rWz)
 * in tool_point: 3 rows of stride, mm; point in the tool frame (rTx rTy rTz)
 * out displacement: 3 rows of stride, mm; workpiece point minus tool point, displacement since home, in the bed frame
 *     (dx dy dz)
 */
void dmu60p_5axis_motion_YZ(
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
