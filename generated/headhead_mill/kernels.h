/* Generated from machines/headhead_mill.toml, do not edit; regenerate with: trueaxis derive machines/headhead_mill.toml
 * Kernels of Five-axis gantry mill with a fork head: geometric error model in C17.
 * Spec: sha256 0ad0abbfc8d51366123f481bf464ef2a99342c0dbb5431fe1300b173adc7b15c
 *
 * Every function computes n points; row k of an array that has a value per point holds point i at [k * stride + i],
 * n <= stride. Arrays must not overlap. Lengths mm, angles rad, rotary axes deg. Rows and units: kernels.c.
 */
#ifndef HEADHEAD_MILL_KERNELS_H
#define HEADHEAD_MILL_KERNELS_H

#include <stddef.h>

#define TRUEAXIS_KERNEL_ABI 2

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

/* Term of the effect backlash: play or elastic wind-up in the drive (along the axis: lost motion) or in the guides (across: lateral play). */
void headhead_mill_effect_backlash(
    size_t n, size_t stride,
    const double *restrict context,
    const double *restrict parameters,
    double *restrict term);

/* Term of the effect backlash_slope: lost motion that varies along the travel: a worn part of the screw, wind-up that depends on its free length. */
void headhead_mill_effect_backlash_slope(
    size_t n, size_t stride,
    const double *restrict context,
    const double *restrict parameters,
    double *restrict term);

/* Term of the effect cyclic: a periodic error: pitch of the screw, its coupling, an eccentric encoder, interpolation of a scale. */
void headhead_mill_effect_cyclic(
    size_t n, size_t stride,
    const double *restrict context,
    const double *restrict parameters,
    double *restrict term);

/* Term of the effect thermal_expansion: a scale or screw that grows with its temperature. */
void headhead_mill_effect_thermal_expansion(
    size_t n, size_t stride,
    const double *restrict context,
    const double *restrict parameters,
    double *restrict term);

/* Term of the effect thermal_offset: a structure that bends or shifts with its temperature. */
void headhead_mill_effect_thermal_offset(
    size_t n, size_t stride,
    const double *restrict context,
    const double *restrict parameters,
    double *restrict term);

/* Term of the effect warm_up: a screw or scale that warms up by its own friction. */
void headhead_mill_effect_warm_up(
    size_t n, size_t stride,
    const double *restrict context,
    const double *restrict parameters,
    double *restrict term);

/* Term of the effect drift: something creeps while it is measured: temperature, foundation, fixture. */
void headhead_mill_effect_drift(
    size_t n, size_t stride,
    const double *restrict context,
    const double *restrict parameters,
    double *restrict term);

/* Term of the effect servo_lag: following error of the position loop; only its difference between axes shows in a circle. */
void headhead_mill_effect_servo_lag(
    size_t n, size_t stride,
    const double *restrict context,
    const double *restrict parameters,
    double *restrict term);

/* Term of the effect reversal_spike: friction that the position loop has to overcome at a reversal (quadrant glitch). */
void headhead_mill_effect_reversal_spike(
    size_t n, size_t stride,
    const double *restrict context,
    const double *restrict parameters,
    double *restrict term);

/* Term of the effect cross_axis: a body that bends under another one: the component error of one axis depends on where another axis stands. */
void headhead_mill_effect_cross_axis(
    size_t n, size_t stride,
    const double *restrict context,
    const double *restrict parameters,
    double *restrict term);

/* Term of the effect laser_cosine: the laser beam was not parallel to the motion: it reads short. */
void headhead_mill_effect_laser_cosine(
    size_t n, size_t stride,
    const double *restrict context,
    const double *restrict parameters,
    double *restrict term);

/* Term of the effect laser_scale: wavelength of the laser: air temperature, pressure or humidity were not what was entered. */
void headhead_mill_effect_laser_scale(
    size_t n, size_t stride,
    const double *restrict context,
    const double *restrict parameters,
    double *restrict term);

/* Term of the effect laser_step: something slipped or lost counts in the middle of a run. */
void headhead_mill_effect_laser_step(
    size_t n, size_t stride,
    const double *restrict context,
    const double *restrict parameters,
    double *restrict term);

/* Term of the effect ballbar_length: the bar is longer than it is said to be (shorter, where the length is negative). */
void headhead_mill_effect_ballbar_length(
    size_t n, size_t stride,
    const double *restrict context,
    const double *restrict parameters,
    double *restrict term);

/* Term of the effect ballbar_lobes: form error of the balls or of the bar's sockets: three lobes. */
void headhead_mill_effect_ballbar_lobes(
    size_t n, size_t stride,
    const double *restrict context,
    const double *restrict parameters,
    double *restrict term);

#endif
