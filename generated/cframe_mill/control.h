/* Generated from machines/cframe_mill.toml, do not edit; regenerate with: trueaxis derive machines/cframe_mill.toml
 * SPDX-License-Identifier: MIT
 * Kernels of C-frame mill for the cycle of a control, in C17.
 * Spec: sha256 e0bab1439083d465e60d898b33f648fd88b066b0d41217ad88014752dc9315ad
 * Equations after: Prediction and compensation of geometric error for translational axes in multi-axis machine tools
 *
 * Every function computes one point, has no state and allocates nothing. Arrays must not overlap.
 * Lengths mm, angles rad.
 *
 * positions: x mm, y mm, z mm
 * errors: EXX mm, EYX mm, EZX mm, EAX rad, EBX rad, ECX rad, EXY mm, EYY mm, EZY mm, EAY rad, EBY rad, ECY rad, EXZ
 *     mm, EYZ mm, EZZ mm, EAZ rad, EBZ rad, ECZ rad
 * parameters: EC0X rad, EA0Z rad, EB0Z rad
 */
#ifndef CFRAME_MILL_CONTROL_H
#define CFRAME_MILL_CONTROL_H

#ifdef __cplusplus
extern "C" {
#endif

/* Writes the component errors (18 values, mm and rad) at commanded positions (3 values). */
typedef void (*cframe_mill_component_errors)(
    const void *curves, const double *positions, double *errors);

/*
 * The machine as it is. curves: is handed to component_errors; parameters: as below; point: the tool point in the tool
 * frame (3 values, mm); share: of the deviation that counts, 0 (the ideal machine) to 1.
 */
typedef struct {
    cframe_mill_component_errors component_errors;
    const void *curves;
    const double *parameters;
    const double *point;
    double share;
} cframe_mill_machine;

/*
 * Forward kinematics: from commanded positions to the pose, the positions at which the ideal machine would have its
 * tool point where this one has it.
 * in positions: 3 values, mm; out pose: 3 values
 * Returns 0, or -1 where the pose is not finite.
 */
int cframe_mill_forward(
    const cframe_mill_machine *machine,
    const double *positions,
    double *pose);

/*
 * Inverse kinematics: from a pose to the positions to be commanded, Eqs. (55) and (56): the fixed point of
 * positions = pose - moves(deviation(positions)), reached when a step moves no axis by more than the tolerance.
 * in pose: 3 values, mm; tolerance: mm; most_steps: after which it gives up
 * out positions: 3 values
 * Returns the number of steps, or -1 where it gave up or the positions are not finite; they are then of no use.
 */
int cframe_mill_inverse(
    const cframe_mill_machine *machine,
    const double *pose,
    double tolerance,
    int most_steps,
    double *positions);

/*
 * Deviation of a tool point in the workpiece frame, exact.
 * Source: Eqs. (1)-(4). Operations: 135 per point, 3 once per call.
 * in positions: 3 values, mm; commanded positions of X Y Z (x y z)
 * in errors: 18 values, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ
 *     EYZ EZZ EAZ EBZ ECZ)
 * in parameters: 3 values, mm, rad; home positions and location errors (EC0X EA0Z EB0Z)
 * in point: 3 values, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 values, mm; tool point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void cframe_mill_point_tool_in_workpiece_deviation(
    const double *positions,
    const double *errors,
    const double *parameters,
    const double *point,
    double *deviation);

/*
 * Moves of the linear axes that displace the ideal tool point by the given vector.
 * Source: Eqs. (53)-(55), inverse. Operations: 2 per point.
 * in positions: 3 values, mm; commanded positions of X Y Z (x y z)
 * in deviation: 3 values, mm; displacement of the tool point in the workpiece frame (dx dy dz)
 * out moves: 3 values, mm; moves of X Y Z (move_x move_y move_z)
 */
void cframe_mill_point_correction(
    const double *positions,
    const double *deviation,
    double *moves);

#ifdef __cplusplus
}
#endif

#endif
