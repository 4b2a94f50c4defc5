/* Generated from machines/cframe_mill.toml, do not edit; regenerate with: trueaxis derive machines/cframe_mill.toml
 * Kernels of C-frame mill: geometric error model in C17.
 * Spec: sha256 69979ea05081b646266ff61dfa49b1225795e10d671a62300f526ba5a2a9755d
 *
 * Every function computes n points; row k of an array that has a value per point holds point i at [k * stride + i],
 * n <= stride. Arrays must not overlap. Lengths mm, angles rad, rotary axes deg. Rows and units: kernels.c.
 */
#ifndef CFRAME_MILL_KERNELS_H
#define CFRAME_MILL_KERNELS_H

#include <stddef.h>

#define TRUEAXIS_KERNEL_ABI 1

/* The ABI that these kernels were compiled with. */
int cframe_mill_kernel_abi(void);

/* SHA-256 of the parsed spec that they were derived from. */
const char *cframe_mill_spec_hash(void);

/* Ideal position of a tool point in the workpiece frame. */
void cframe_mill_tool_in_workpiece_ideal(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict ideal);

/* Deviation of a tool point in the workpiece frame, exact. */
void cframe_mill_tool_in_workpiece_deviation(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict deviation);

/* Deviation of a tool point in the workpiece frame, to first order in the errors. */
void cframe_mill_tool_in_workpiece_deviation_first_order(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict deviation);

/* Sensitivity of a tool point in the workpiece frame to every error, at the error-free machine. */
void cframe_mill_tool_in_workpiece_sensitivity(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict sensitivity);

/* Ideal position of a tool point in the bed frame. */
void cframe_mill_tool_in_bed_ideal(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict ideal);

/* Deviation of a tool point in the bed frame, exact. */
void cframe_mill_tool_in_bed_deviation(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict deviation);

/* Deviation of a tool point in the bed frame, to first order in the errors. */
void cframe_mill_tool_in_bed_deviation_first_order(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict deviation);

/* Sensitivity of a tool point in the bed frame to every error, at the error-free machine. */
void cframe_mill_tool_in_bed_sensitivity(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict sensitivity);

/* Ideal position of a workpiece point in the bed frame. */
void cframe_mill_workpiece_in_bed_ideal(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict ideal);

/* Deviation of a workpiece point in the bed frame, exact. */
void cframe_mill_workpiece_in_bed_deviation(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict deviation);

/* Deviation of a workpiece point in the bed frame, to first order in the errors. */
void cframe_mill_workpiece_in_bed_deviation_first_order(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict deviation);

/* Sensitivity of a workpiece point in the bed frame to every error, at the error-free machine. */
void cframe_mill_workpiece_in_bed_sensitivity(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict sensitivity);

/* Ideal position of a bed point in the workpiece frame. */
void cframe_mill_bed_in_workpiece_ideal(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict ideal);

/* Deviation of a bed point in the workpiece frame, exact. */
void cframe_mill_bed_in_workpiece_deviation(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict deviation);

/* Deviation of a bed point in the workpiece frame, to first order in the errors. */
void cframe_mill_bed_in_workpiece_deviation_first_order(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict deviation);

/* Sensitivity of a bed point in the workpiece frame to every error, at the error-free machine. */
void cframe_mill_bed_in_workpiece_sensitivity(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict sensitivity);

/* Actual position of the tool point in the workpiece frame, exact. */
void cframe_mill_tool_in_workpiece_position(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict position);

/* Actual position of the tool point in the workpiece frame, to first order. */
void cframe_mill_tool_in_workpiece_position_first_order(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict position);

/* Deviation of the tool point under polynomial error curves, exact. */
void cframe_mill_tool_in_workpiece_deviation_curves(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict curves,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict deviation);

/* Deviation of the tool point under polynomial error curves, to first order, constants folded once per call. */
void cframe_mill_tool_in_workpiece_deviation_first_order_curves(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict curves,
    const double *restrict parameters,
    const double *restrict point,
    double *restrict deviation);

/* Positioning error of a ball bar between a tool ball and a workpiece ball, exact. */
void cframe_mill_ballbar_error(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict point,
    const double *restrict ball,
    const double *restrict length,
    double *restrict error);

/* Moves of the linear axes that displace the ideal tool point by the given vector. */
void cframe_mill_correction(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict deviation,
    double *restrict moves);

/* Motion equation of X: displacement of the workpiece point since home, to first order. */
void cframe_mill_motion_X(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict workpiece_point,
    double *restrict displacement);

/* Motion equation of Y: displacement of the workpiece point since home, to first order. */
void cframe_mill_motion_Y(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict workpiece_point,
    double *restrict displacement);

/* Motion equation of Z: displacement of the tool point since home, to first order. */
void cframe_mill_motion_Z(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict tool_point,
    double *restrict displacement);

/* Motion equation of X and Y: displacement of the workpiece point since home, to first order. */
void cframe_mill_motion_XY(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict workpiece_point,
    double *restrict displacement);

/* Motion equation of X and Z: displacement of the workpiece point minus tool point since home, to first order. */
void cframe_mill_motion_XZ(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict workpiece_point,
    const double *restrict tool_point,
    double *restrict displacement);

/* Motion equation of Y and Z: displacement of the workpiece point minus tool point since home, to first order. */
void cframe_mill_motion_YZ(
    size_t n, size_t stride,
    const double *restrict positions,
    const double *restrict errors,
    const double *restrict parameters,
    const double *restrict workpiece_point,
    const double *restrict tool_point,
    double *restrict displacement);

#endif
