/* Generated from machines/headhead_mill.toml, do not edit; regenerate with: trueaxis derive machines/headhead_mill.toml
 * Kernels of Five-axis gantry mill with a fork head: geometric error model in C17.
 * Spec: sha256 6c45bf8c51eb4a9377b8bc8680569d3bb73d572df352aa3afb546c2376b62e16
 *
 * Every function computes n points; row k of an array that has a value per point holds point i at [k * stride + i],
 * n <= stride. Arrays must not overlap. Lengths mm, angles rad, rotary axes deg. Rows and units: kernels.c.
 */
#ifndef HEADHEAD_MILL_KERNELS_H
#define HEADHEAD_MILL_KERNELS_H

#include <stddef.h>

#define TRUEAXIS_KERNEL_ABI 1

/* The ABI that these kernels were compiled with. */
int headhead_mill_kernel_abi(void);

/* SHA-256 of the parsed spec that they were derived from. */
const char *headhead_mill_spec_hash(void);

/* Ideal position of a tool point in the workpiece frame. */
void headhead_mill_tool_in_workpiece_ideal(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict ideal);

/* Deviation of a tool point in the workpiece frame, exact. */
void headhead_mill_tool_in_workpiece_deviation(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict deviation);

/* Deviation of a tool point in the workpiece frame, to first order in the errors. */
void headhead_mill_tool_in_workpiece_deviation_first_order(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict deviation);

/* Sensitivity of a tool point in the workpiece frame to every error, at the error-free machine. */
void headhead_mill_tool_in_workpiece_sensitivity(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict sensitivity);

/* Ideal position of a tool point in the bed frame. */
void headhead_mill_tool_in_bed_ideal(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict ideal);

/* Deviation of a tool point in the bed frame, exact. */
void headhead_mill_tool_in_bed_deviation(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict deviation);

/* Deviation of a tool point in the bed frame, to first order in the errors. */
void headhead_mill_tool_in_bed_deviation_first_order(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict deviation);

/* Sensitivity of a tool point in the bed frame to every error, at the error-free machine. */
void headhead_mill_tool_in_bed_sensitivity(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict sensitivity);

/* Ideal position of a workpiece point in the bed frame. */
void headhead_mill_workpiece_in_bed_ideal(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict ideal);

/* Deviation of a workpiece point in the bed frame, exact. */
void headhead_mill_workpiece_in_bed_deviation(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict deviation);

/* Deviation of a workpiece point in the bed frame, to first order in the errors. */
void headhead_mill_workpiece_in_bed_deviation_first_order(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict deviation);

/* Sensitivity of a workpiece point in the bed frame to every error, at the error-free machine. */
void headhead_mill_workpiece_in_bed_sensitivity(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict sensitivity);

/* Ideal position of a bed point in the workpiece frame. */
void headhead_mill_bed_in_workpiece_ideal(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict ideal);

/* Deviation of a bed point in the workpiece frame, exact. */
void headhead_mill_bed_in_workpiece_deviation(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict deviation);

/* Deviation of a bed point in the workpiece frame, to first order in the errors. */
void headhead_mill_bed_in_workpiece_deviation_first_order(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict deviation);

/* Sensitivity of a bed point in the workpiece frame to every error, at the error-free machine. */
void headhead_mill_bed_in_workpiece_sensitivity(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict sensitivity);

/* Actual position of the tool point in the workpiece frame, exact. */
void headhead_mill_tool_in_workpiece_position(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict position);

/* Actual position of the tool point in the workpiece frame, to first order. */
void headhead_mill_tool_in_workpiece_position_first_order(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict position);

/* Ideal direction of a vector of the tool frame in the workpiece frame. */
void headhead_mill_tool_orientation_ideal(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict direction,
    double *restrict ideal);

/* Deviation of a direction of the tool frame in the workpiece frame, exact. */
void headhead_mill_tool_orientation_deviation(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict direction,
    double *restrict deviation);

/* Deviation of a direction of the tool frame in the workpiece frame, to first order. */
void headhead_mill_tool_orientation_deviation_first_order(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict direction,
    double *restrict deviation);

/* Deviation of the tool point under polynomial error curves, exact. */
void headhead_mill_tool_in_workpiece_deviation_curves(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict curves,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict deviation);

/* Deviation of the tool point under polynomial error curves, to first order. */
void headhead_mill_tool_in_workpiece_deviation_first_order_curves(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict curves,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict deviation);

/* Positioning error of a ball bar between a tool ball and a workpiece ball, exact. */
void headhead_mill_ballbar_error(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict point,
    const double *restrict ball,
    const double *restrict length,
    double *restrict error);

/* Moves of the linear axes that displace the ideal tool point by the given vector. */
void headhead_mill_correction(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict deviation,
    double *restrict moves);

/* Motion equation of X: displacement of the tool point since home, to first order. */
void headhead_mill_motion_X(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict tool_point,
    double *restrict displacement);

/* Motion equation of Y: displacement of the tool point since home, to first order. */
void headhead_mill_motion_Y(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict tool_point,
    double *restrict displacement);

/* Motion equation of Z: displacement of the tool point since home, to first order. */
void headhead_mill_motion_Z(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict tool_point,
    double *restrict displacement);

/* Motion equation of B: displacement of the tool point since home, to first order. */
void headhead_mill_motion_B(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict tool_point,
    double *restrict displacement);

/* Motion equation of C: displacement of the tool point since home, to first order. */
void headhead_mill_motion_C(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict tool_point,
    double *restrict displacement);

/* Motion equation of X and Y: displacement of the tool point since home, to first order. */
void headhead_mill_motion_XY(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict tool_point,
    double *restrict displacement);

/* Motion equation of X and Z: displacement of the tool point since home, to first order. */
void headhead_mill_motion_XZ(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict tool_point,
    double *restrict displacement);

/* Motion equation of Y and Z: displacement of the tool point since home, to first order. */
void headhead_mill_motion_YZ(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict tool_point,
    double *restrict displacement);

#endif
