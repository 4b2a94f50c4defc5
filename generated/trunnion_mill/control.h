/* Generated from machines/trunnion_mill.toml, do not edit; regenerate with: trueaxis derive machines/trunnion_mill.toml
 * SPDX-License-Identifier: MIT
 * Kernels of Five-axis mill with a trunnion table for the cycle of a control, in C17.
 * Spec: sha256 fff68e3a25ed33ff02fbf9ab6e0875735d9de644fc7b3d9d269b461961e2d9f2
 * Equations after: Prediction and compensation of geometric error for translational axes in multi-axis machine tools
 *
 * Every function computes one point, has no state and allocates nothing. Arrays must not overlap.
 * Lengths mm, angles rad, positions of rotary axes deg.
 *
 * positions: x mm, y mm, z mm, a deg, c deg
 * errors: EXX mm, EYX mm, EZX mm, EAX rad, EBX rad, ECX rad, EXY mm, EYY mm, EZY mm, EAY rad, EBY rad, ECY rad, EXZ
 *     mm, EYZ mm, EZZ mm, EAZ rad, EBZ rad, ECZ rad, EXA mm, EYA mm, EZA mm, EAA rad, EBA rad, ECA rad, EXC mm, EYC
 *     mm, EZC mm, EAC rad, EBC rad, ECC rad
 * parameters: q_Ax mm, q_Ay mm, q_Az mm, q_Cx mm, q_Cy mm, q_Cz mm, q_wx mm, q_wy mm, q_wz mm, q_Tx mm, q_Ty mm, q_Tz
 *     mm, EC0Y rad, EY0A mm, EZ0A mm, EB0A rad, EC0A rad, EX0C mm, EY0C mm, EA0C rad, EB0C rad, EA0Z rad, EB0Z rad
 */
#ifndef TRUNNION_MILL_CONTROL_H
#define TRUNNION_MILL_CONTROL_H

#ifdef __cplusplus
extern "C" {
#endif

/* Writes the component errors (30 values, mm and rad) at commanded positions (5 values). */
typedef void (*trunnion_mill_component_errors)(
    const void *curves, const double *positions, double *errors);

/*
 * The machine as it is. curves: is handed to component_errors; parameters: as below; point: the tool point in the tool
 * frame (3 values, mm); share: of the deviation that counts, 0 (the ideal machine) to 1.
 */
typedef struct {
    trunnion_mill_component_errors component_errors;
    const void *curves;
    const double *parameters;
    const double *point;
    double share;
} trunnion_mill_machine;

/*
 * Forward kinematics: from commanded positions to the pose, the positions at which the ideal machine would have its
 * tool point where this one has it. Positions of rotary axes stay as they are.
 * in positions: 5 values, mm, rotary axes deg; out pose: 5 values
 * Returns 0, or -1 where the pose is not finite.
 */
int trunnion_mill_forward(
    const trunnion_mill_machine *machine,
    const double *positions,
    double *pose);

/*
 * Inverse kinematics: from a pose to the positions to be commanded, Eqs. (55) and (56): the fixed point of
 * positions = pose - moves(deviation(positions)), reached when a step moves no axis by more than the tolerance.
 * in pose: 5 values, mm, rotary axes deg; tolerance: mm; most_steps: after which it gives up
 * out positions: 5 values
 * Returns the number of steps, or -1 where it gave up or the positions are not finite; they are then of no use.
 */
int trunnion_mill_inverse(
    const trunnion_mill_machine *machine,
    const double *pose,
    double tolerance,
    int most_steps,
    double *positions);

/*
 * Deviation of a tool point in the workpiece frame, exact.
 * Source: Eqs. (1)-(4). Operations: 297 per point, 13 once per call.
 * in positions: 5 values, mm, rotary axes deg; commanded positions of X Y Z A C (x y z a c)
 * in errors: 30 values, mm, rad; component errors at the point (EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ
 *     EYZ EZZ EAZ EBZ ECZ EXA EYA EZA EAA EBA ECA EXC EYC EZC EAC EBC ECC)
 * in parameters: 23 values, mm, rad; home positions and location errors (q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz
 *     q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C EA0C EB0C EA0Z EB0Z)
 * in point: 3 values, mm; point in the tool frame (rx ry rz)
 * out deviation: 3 values, mm; tool point in the workpiece frame, actual minus ideal (dx dy dz)
 */
void trunnion_mill_point_tool_in_workpiece_deviation(
    const double *positions,
    const double *errors,
    const double *parameters,
    const double *point,
    double *deviation);

/*
 * Moves of the linear axes that displace the ideal tool point by the given vector.
 * Source: Eqs. (53)-(55), inverse. Operations: 23 per point.
 * in positions: 5 values, mm, rotary axes deg; commanded positions of X Y Z A C (x y z a c)
 * in deviation: 3 values, mm; displacement of the tool point in the workpiece frame (dx dy dz)
 * out moves: 3 values, mm; moves of X Y Z (move_x move_y move_z)
 */
void trunnion_mill_point_correction(
    const double *positions,
    const double *deviation,
    double *moves);

#ifdef __cplusplus
}
#endif

#endif
