/* Generated from machines/dmu60p_5axis.toml, do not edit; regenerate with: trueaxis derive machines/dmu60p_5axis.toml
 * Kernels of DECKEL MAHO DMU60P, all five axes: geometric error model in C17.
 * Spec: sha256 1e9ea96f6f8f6e09b7241f720eb3aea43e5fed8e47f7e01dd1ada9d8988cb39b
 *
 * Every function computes n points; row k of an array that has a value per point holds point i at [k * stride + i],
 * n <= stride. Arrays must not overlap. Lengths mm, angles rad, rotary axes deg. Rows and units: kernels.c.
 */
#ifndef DMU60P_5AXIS_KERNELS_H
#define DMU60P_5AXIS_KERNELS_H

#include <stddef.h>

#define TRUEAXIS_KERNEL_ABI 1

/* The ABI that these kernels were compiled with. */
int dmu60p_5axis_kernel_abi(void);

/* SHA-256 of the parsed spec that they were derived from. */
const char *dmu60p_5axis_spec_hash(void);

/* Ideal position of a tool point in the workpiece frame. */
void dmu60p_5axis_tool_in_workpiece_ideal(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict ideal);

/* Deviation of a tool point in the workpiece frame, exact. */
void dmu60p_5axis_tool_in_workpiece_deviation(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict deviation);

/* Deviation of a tool point in the workpiece frame, to first order in the errors. */
void dmu60p_5axis_tool_in_workpiece_deviation_first_order(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict deviation);

/* Sensitivity of a tool point in the workpiece frame to every error, at the error-free machine. */
void dmu60p_5axis_tool_in_workpiece_sensitivity(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict sensitivity);

/* Ideal position of a tool point in the bed frame. */
void dmu60p_5axis_tool_in_bed_ideal(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict ideal);

/* Deviation of a tool point in the bed frame, exact. */
void dmu60p_5axis_tool_in_bed_deviation(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict deviation);

/* Deviation of a tool point in the bed frame, to first order in the errors. */
void dmu60p_5axis_tool_in_bed_deviation_first_order(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict deviation);

/* Sensitivity of a tool point in the bed frame to every error, at the error-free machine. */
void dmu60p_5axis_tool_in_bed_sensitivity(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict sensitivity);

/* Ideal position of a workpiece point in the bed frame. */
void dmu60p_5axis_workpiece_in_bed_ideal(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict ideal);

/* Deviation of a workpiece point in the bed frame, exact. */
void dmu60p_5axis_workpiece_in_bed_deviation(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict deviation);

/* Deviation of a workpiece point in the bed frame, to first order in the errors. */
void dmu60p_5axis_workpiece_in_bed_deviation_first_order(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict deviation);

/* Sensitivity of a workpiece point in the bed frame to every error, at the error-free machine. */
void dmu60p_5axis_workpiece_in_bed_sensitivity(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict sensitivity);

/* Ideal position of a bed point in the workpiece frame. */
void dmu60p_5axis_bed_in_workpiece_ideal(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict ideal);

/* Deviation of a bed point in the workpiece frame, exact. */
void dmu60p_5axis_bed_in_workpiece_deviation(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict deviation);

/* Deviation of a bed point in the workpiece frame, to first order in the errors. */
void dmu60p_5axis_bed_in_workpiece_deviation_first_order(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict deviation);

/* Sensitivity of a bed point in the workpiece frame to every error, at the error-free machine. */
void dmu60p_5axis_bed_in_workpiece_sensitivity(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict sensitivity);

/* Actual position of the tool point in the workpiece frame, exact. */
void dmu60p_5axis_tool_in_workpiece_position(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict position);

/* Actual position of the tool point in the workpiece frame, to first order. */
void dmu60p_5axis_tool_in_workpiece_position_first_order(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict position);

/* Ideal direction of a vector of the tool frame in the workpiece frame. */
void dmu60p_5axis_tool_orientation_ideal(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict direction,
    double *restrict ideal);

/* Deviation of a direction of the tool frame in the workpiece frame, exact. */
void dmu60p_5axis_tool_orientation_deviation(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict direction,
    double *restrict deviation);

/* Deviation of a direction of the tool frame in the workpiece frame, to first order. */
void dmu60p_5axis_tool_orientation_deviation_first_order(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict direction,
    double *restrict deviation);

/* Deviation of the tool point under polynomial error curves, exact. */
void dmu60p_5axis_tool_in_workpiece_deviation_curves(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict curves,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict deviation);

/* Deviation of the tool point under polynomial error curves, to first order. */
void dmu60p_5axis_tool_in_workpiece_deviation_first_order_curves(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict curves,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict deviation);

/* Positioning error of a ball bar between a tool ball and a workpiece ball, exact. */
void dmu60p_5axis_ballbar_error(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict point,
    const double *restrict ball,
    const double *restrict length,
    double *restrict error);

/* Moves of the linear axes that displace the ideal tool point by the given vector. */
void dmu60p_5axis_correction(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict deviation,
    double *restrict moves);

/* Motion equation of X: displacement of the tool point since home, to first order. */
void dmu60p_5axis_motion_X(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict tool_point,
    double *restrict displacement);

/* Motion equation of Y: displacement of the workpiece point since home, to first order. */
void dmu60p_5axis_motion_Y(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict workpiece_point,
    double *restrict displacement);

/* Motion equation of Z: displacement of the tool point since home, to first order. */
void dmu60p_5axis_motion_Z(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict tool_point,
    double *restrict displacement);

/* Motion equation of B: displacement of the tool point since home, to first order. */
void dmu60p_5axis_motion_B(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict tool_point,
    double *restrict displacement);

/* Motion equation of C: displacement of the workpiece point since home, to first order. */
void dmu60p_5axis_motion_C(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict workpiece_point,
    double *restrict displacement);

/* Motion equation of X and Y: displacement of the workpiece point minus tool point since home, to first order. */
void dmu60p_5axis_motion_XY(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict workpiece_point,
    const double *restrict tool_point,
    double *restrict displacement);

/* Motion equation of X and Z: displacement of the tool point since home, to first order. */
void dmu60p_5axis_motion_XZ(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict tool_point,
    double *restrict displacement);

/* Motion equation of Y and Z: displacement of the workpiece point minus tool point since home, to first order. */
void dmu60p_5axis_motion_YZ(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict workpiece_point,
    const double *restrict tool_point,
    double *restrict displacement);

#endif
