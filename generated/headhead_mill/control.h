/* Generated from machines/headhead_mill.toml, do not edit; regenerate with: trueaxis derive machines/headhead_mill.toml
 * SPDX-License-Identifier: MIT
 * Kernels of Five-axis gantry mill with a fork head for the cycle of a control, in C17.
 * Spec: sha256 0ad0abbfc8d51366123f481bf464ef2a99342c0dbb5431fe1300b173adc7b15c
 * Equations after: Prediction and compensation of geometric error for translational axes in multi-axis machine tools
 *
 * Every function computes one point, has no state and allocates nothing. Arrays must not overlap.
 * Lengths mm, angles rad, positions of rotary axes deg.
 *
 * positions: x mm, y mm, z mm, b deg, c deg
 * errors: EXX mm, EYX mm, EZX mm, EAX rad, EBX rad, ECX rad, EXY mm, EYY mm, EZY mm, EAY rad, EBY rad, ECY rad, EXZ
 *     mm, EYZ mm, EZZ mm, EAZ rad, EBZ rad, ECZ rad, EXB mm, EYB mm, EZB mm, EAB rad, EBB rad, ECB rad, EXC mm, EYC
 *     mm, EZC mm, EAC rad, EBC rad, ECC rad
 * parameters: q_Bx mm, q_By mm, q_Bz mm, q_Tx mm, q_Ty mm, q_Tz mm, EC0Y rad, EA0Z rad, EB0Z rad, EX0C mm, EY0C mm,
 *     EA0C rad, EB0C rad, EX0B mm, EZ0B mm, EA0B rad, EC0B rad, EX0T mm, EY0T mm, EZ0T mm
 */
#ifndef HEADHEAD_MILL_CONTROL_H
#define HEADHEAD_MILL_CONTROL_H

#ifdef __cplusplus
extern "C" {
#endif

/* Writes the component errors (30 values, mm and rad) at commanded positions (5 values). */
typedef void (*headhead_mill_component_errors)(
    const void *curves, const double *positions, double *errors);

/*
 * The machine as it is. curves: is handed to component_errors; parameters: as below; point: the tool point in the tool
 * frame (3 values, mm); share: of the deviation that counts, 0 (the ideal machine) to 1.
 */
typedef struct {
    headhead_mill_component_errors component_errors;
    const void *curves;
    const double *parameters;
    const double *point;
    double share;
} headhead_mill_machine;

/*
 * Forward kinematics: from commanded positions to the pose, the positions at which the ideal machine would have its
 * tool point where this one has it. Positions of rotary axes stay as they are.
 * in positions: 5 values, mm, rotary axes deg; out pose: 5 values
 * Returns 0, or -1 where the pose is not finite.
 */
int headhead_mill_forward(
    const headhead_mill_machine *machine,
    const double *positions,
    double *pose);

/*
 * Inverse kinematics: from a pose to the positions to be commanded, Eqs. (55) and (56): the fixed point of
 * positions = pose - moves(deviation(positions)), reached when a step moves no axis by more than the tolerance.
 * in pose: 5 values, mm, rotary axes deg; tolerance: mm; most_steps: after which it gives up
 * out positions: 5 values
 * Returns the number of steps, or -1 where it gave up or the positions are not finite; they are then of no use.
 */
int headhead_mill_inverse(
    const headhead_mill_machine *machine,
    const double *pose,
    double tolerance,
    int most_steps,
    double *positions);

/*
 * Deviation of a tool point in the workpiece frame, exact.
 * Source: Eqs. (1)-(4). Operations: 173 per point.
 * in positions: 5 values, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in errors: 30 values, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ
 *     EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB ECB EXC EYC EZC EAC EBC ECC)
 * in parameters: 20 values, mm, rad; home positions and location errors (q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z
 *     EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T EZ0T)
 * in point: 3 values, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 values, mm; tool point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void headhead_mill_point_tool_in_workpiece_deviation(
    const double *positions,
    const double *errors,
    const double *parameters,
    const double *point,
    double *deviation);

/*
 * Moves of the linear axes that displace the ideal tool point by the given vector.
 * Source: Eqs. (53)-(55), inverse. Operations: 0 per point.
 * in positions: 5 values, mm, rotary axes deg; commanded positions of X Y Z B C (x y z b c)
 * in deviation: 3 values, mm; displacement of the tool point in the workpiece frame (dx dy dz)
 * out moves: 3 values, mm; moves of X Y Z (move_x move_y move_z)
 */
void headhead_mill_point_correction(
    const double *positions,
    const double *deviation,
    double *moves);

#ifdef __cplusplus
}
#endif

#endif
