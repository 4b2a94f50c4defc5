# Generated from machines/dmu60p_5axis.toml, do not edit; regenerate with: trueaxis derive machines/dmu60p_5axis.toml
# SPDX-License-Identifier: MIT
"""Kernels of DECKEL MAHO DMU60P, all five axes: geometric error model in NumPy.

Arrays are float64 with the quantity first and the point last: positions (n_axes, n), errors (n_components, n),
deviation (3, n). An array that is the same at all points may have n = 1. Lengths mm, angles rad, positions of
rotary axes deg.
An array of another shape is a ValueError that names it.

Equations after: Prediction and compensation of geometric error for translational axes in multi-axis machine tools
"""

import numpy as np

ABI = 3
SPEC_HASH = "1b0a63b86ea881e06983b884ca7f951aa51e2ebb46ef2eaccf5755fd64d1985f"

META = {
    'machine': 'dmu60p_5axis',
    'title': 'DECKEL MAHO DMU60P, all five axes',
    'axes': ['X', 'Y', 'Z', 'B', 'C'],
    'position_units': ['mm', 'mm', 'mm', 'deg', 'deg'],
    'travel': {'X': [0.0, 540.0], 'Y': [0.0, 700.0], 'Z': [0.0, 600.0], 'B': [-120.0, 120.0], 'C': [-360.0, 360.0]},
    'components': [
        'EXX', 'EYX', 'EZX', 'EAX', 'EBX', 'ECX', 'EXY', 'EYY', 'EZY', 'EAY', 'EBY', 'ECY', 'EXZ', 'EYZ', 'EZZ',
        'EAZ', 'EBZ', 'ECZ', 'EXB', 'EYB', 'EZB', 'EAB', 'EBB', 'ECB', 'EXC', 'EYC', 'EZC', 'EAC', 'EBC', 'ECC',
    ],
    'component_units': [
        'mm', 'mm', 'mm', 'rad', 'rad', 'rad', 'mm', 'mm', 'mm', 'rad', 'rad', 'rad', 'mm', 'mm', 'mm', 'rad', 'rad',
        'rad', 'mm', 'mm', 'mm', 'rad', 'rad', 'rad', 'mm', 'mm', 'mm', 'rad', 'rad', 'rad',
    ],
    'component_descriptions': [
        'positioning error of X', 'straightness error of X in Y', 'straightness error of X in Z', 'roll error of X',
        'angular error of X about Y (pitch or yaw)', 'angular error of X about Z (pitch or yaw)',
        'straightness error of Y in X', 'positioning error of Y', 'straightness error of Y in Z',
        'angular error of Y about X (pitch or yaw)', 'roll error of Y', 'angular error of Y about Z (pitch or yaw)',
        'straightness error of Z in X', 'straightness error of Z in Y', 'positioning error of Z',
        'angular error of Z about X (pitch or yaw)', 'angular error of Z about Y (pitch or yaw)', 'roll error of Z',
        'radial error motion of B in X', 'axial error motion of B, along Y', 'radial error motion of B in Z',
        'tilt error motion of B about X', 'angular positioning error of B', 'tilt error motion of B about Z',
        'radial error motion of C in X', 'radial error motion of C in Y', 'axial error motion of C, along Z',
        'tilt error motion of C about X', 'tilt error motion of C about Y', 'angular positioning error of C',
    ],
    'parameters': [
        'q_Cx', 'q_Cy', 'q_Cz', 'q_wx', 'q_wy', 'q_wz', 'q_Bx', 'q_By', 'q_Bz', 'q_Sx', 'q_Sy', 'q_Sz', 'q_Tx',
        'q_Ty', 'q_Tz', 'EX0C', 'EY0C', 'EA0C', 'EB0C', 'eps_xy', 'eps_yz', 'eps_xz', 'EX0B', 'EZ0B', 'EA0B', 'EC0B',
    ],
    'parameter_units': [
        'mm', 'mm', 'mm', 'mm', 'mm', 'mm', 'mm', 'mm', 'mm', 'mm', 'mm', 'mm', 'mm', 'mm', 'mm', 'mm', 'mm', 'rad',
        'rad', 'rad', 'rad', 'rad', 'mm', 'mm', 'rad', 'rad',
    ],
    'parameter_descriptions': [
        'home position along X, body 3 (C axis, worktable) on body 2',
        'home position along Y, body 3 (C axis, worktable) on body 2',
        'home position along Z, body 3 (C axis, worktable) on body 2',
        'home position along X, body 4 (workpiece) on body 3', 'home position along Y, body 4 (workpiece) on body 3',
        'home position along Z, body 4 (workpiece) on body 3',
        'home position along X, body 7 (B axis, head) on body 6',
        'home position along Y, body 7 (B axis, head) on body 6',
        'home position along Z, body 7 (B axis, head) on body 6',
        'home position along X, body 8 (tool spindle) on body 7',
        'home position along Y, body 8 (tool spindle) on body 7',
        'home position along Z, body 8 (tool spindle) on body 7', 'home position along X, body 9 (tool) on body 8',
        'home position along Y, body 9 (tool) on body 8', 'home position along Z, body 9 (tool) on body 8',
        'location error: error of the position of C in X; C axis, worktable on Y slide carriage',
        'location error: error of the position of C in Y; C axis, worktable on Y slide carriage',
        'location error: error of the orientation of C about X; C axis, worktable on Y slide carriage',
        'location error: error of the orientation of C about Y; C axis, worktable on Y slide carriage',
        'location error: squareness error of X to Y, about Z; X slide carriage on the bed',
        'location error: squareness error of Z to Y, about X; Z slide carriage on X slide carriage',
        'location error: squareness error of Z to X, about Y; Z slide carriage on X slide carriage',
        'location error: error of the position of B in X; B axis, head on Z slide carriage',
        'location error: error of the position of B in Z; B axis, head on Z slide carriage',
        'location error: error of the orientation of B about X; B axis, head on Z slide carriage',
        'location error: error of the orientation of B about Z; B axis, head on Z slide carriage',
    ],
    'dimensions': [
        'q_Cx', 'q_Cy', 'q_Cz', 'q_wx', 'q_wy', 'q_wz', 'q_Bx', 'q_By', 'q_Bz', 'q_Sx', 'q_Sy', 'q_Sz', 'q_Tx',
        'q_Ty', 'q_Tz',
    ],
    'location_errors': [
        'EX0C', 'EY0C', 'EA0C', 'EB0C', 'eps_xy', 'eps_yz', 'eps_xz', 'EX0B', 'EZ0B', 'EA0B', 'EC0B',
    ],
    'curve_degree': 7,
    'squareness': [
        {'axes': ['X', 'Y'], 'location_errors': {'eps_xy': 1.0}},
        {'axes': ['X', 'Z'], 'location_errors': {'eps_xz': 1.0}},
        {'axes': ['Y', 'Z'], 'location_errors': {'eps_yz': -1.0}},
    ],
    'effects': {'kinds': {}, 'terms': []},
    'routines': {
        'tool_in_workpiece_ideal': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'parameters', 'shape': [26], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'ideal', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 87,
            'operations_per_call': 0,
        },
        'tool_in_workpiece_deviation': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [26], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 244,
            'operations_per_call': 5,
        },
        'tool_in_workpiece_deviation_first_order': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [26], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 151,
            'operations_per_call': 0,
        },
        'tool_in_workpiece_sensitivity': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'parameters', 'shape': [26], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'sensitivity', 'shape': [3, 41], 'per_point': True, 'unit': 'mm/mm, mm/rad'}],
            'operations': 219,
            'operations_per_call': 0,
        },
        'tool_in_bed_ideal': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'parameters', 'shape': [26], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'ideal', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 33,
            'operations_per_call': 0,
        },
        'tool_in_bed_deviation': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [26], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 105,
            'operations_per_call': 0,
        },
        'tool_in_bed_deviation_first_order': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [26], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 91,
            'operations_per_call': 0,
        },
        'tool_in_bed_sensitivity': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'parameters', 'shape': [26], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'sensitivity', 'shape': [3, 41], 'per_point': True, 'unit': 'mm/mm, mm/rad'}],
            'operations': 57,
            'operations_per_call': 0,
        },
        'workpiece_in_bed_ideal': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'parameters', 'shape': [26], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'ideal', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 23,
            'operations_per_call': 0,
        },
        'workpiece_in_bed_deviation': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [26], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 65,
            'operations_per_call': 0,
        },
        'workpiece_in_bed_deviation_first_order': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [26], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 59,
            'operations_per_call': 0,
        },
        'workpiece_in_bed_sensitivity': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'parameters', 'shape': [26], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'sensitivity', 'shape': [3, 41], 'per_point': True, 'unit': 'mm/mm, mm/rad'}],
            'operations': 39,
            'operations_per_call': 0,
        },
        'bed_in_workpiece_ideal': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'parameters', 'shape': [26], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'ideal', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 26,
            'operations_per_call': 0,
        },
        'bed_in_workpiece_deviation': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [26], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 142,
            'operations_per_call': 5,
        },
        'bed_in_workpiece_deviation_first_order': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [26], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 57,
            'operations_per_call': 0,
        },
        'bed_in_workpiece_sensitivity': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'parameters', 'shape': [26], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'sensitivity', 'shape': [3, 41], 'per_point': True, 'unit': 'mm/mm, mm/rad'}],
            'operations': 48,
            'operations_per_call': 0,
        },
        'tool_in_workpiece_position': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [26], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'position', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 250,
            'operations_per_call': 5,
        },
        'tool_in_workpiece_position_first_order': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [26], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'position', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 157,
            'operations_per_call': 0,
        },
        'tool_orientation_ideal': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'direction', 'shape': [3], 'per_point': True, 'unit': '1'},
            ],
            'outputs': [{'name': 'ideal', 'shape': [3], 'per_point': True, 'unit': '1'}],
            'operations': 20,
            'operations_per_call': 0,
        },
        'tool_orientation_deviation': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [26], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'direction', 'shape': [3], 'per_point': True, 'unit': '1'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': '1'}],
            'operations': 210,
            'operations_per_call': 5,
        },
        'tool_orientation_deviation_first_order': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [26], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'direction', 'shape': [3], 'per_point': True, 'unit': '1'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': '1'}],
            'operations': 117,
            'operations_per_call': 0,
        },
        'tool_in_workpiece_deviation_curves': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {
                    'name': 'curves',
                    'shape': [30, 7],
                    'per_point': False,
                    'unit': 'mm/mm^k, rad/mm^k (deg^k for rotary axes)',
                },
                {'name': 'parameters', 'shape': [26], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': False, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 627,
            'operations_per_call': 12,
        },
        'tool_in_workpiece_deviation_first_order_curves': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {
                    'name': 'curves',
                    'shape': [30, 7],
                    'per_point': False,
                    'unit': 'mm/mm^k, rad/mm^k (deg^k for rotary axes)',
                },
                {'name': 'parameters', 'shape': [26], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': False, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 534,
            'operations_per_call': 7,
        },
        'ballbar_error': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [26], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'ball', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'length', 'shape': [1], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'error', 'shape': [4], 'per_point': True, 'unit': 'mm'}],
            'operations': 283,
            'operations_per_call': 5,
        },
        'correction': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'moves', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 11,
            'operations_per_call': 0,
        },
        'motion_X': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [26], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'tool_point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'displacement', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 24,
            'operations_per_call': 0,
        },
        'motion_Y': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [26], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'workpiece_point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'displacement', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 19,
            'operations_per_call': 0,
        },
        'motion_Z': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [26], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'tool_point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'displacement', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 26,
            'operations_per_call': 0,
        },
        'motion_B': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [26], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'tool_point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'displacement', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 91,
            'operations_per_call': 0,
        },
        'motion_C': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [26], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'workpiece_point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'displacement', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 62,
            'operations_per_call': 0,
        },
        'motion_XY': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [26], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'workpiece_point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'tool_point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'displacement', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 46,
            'operations_per_call': 0,
        },
        'motion_XZ': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [26], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'tool_point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'displacement', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 47,
            'operations_per_call': 0,
        },
        'motion_YZ': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [26], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'workpiece_point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'tool_point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'displacement', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 48,
            'operations_per_call': 0,
        },
    },
}

# Points per block: the intermediate rows of a block stay in the processor's second-level cache.
BLOCK = 8192


def _points(**arrays):
    """The arrays, each given as (array, rows), broadcast to one number of points, and that number."""
    checked = {}
    for name, (array, rows) in arrays.items():
        array = np.asarray(array, dtype=np.float64)
        if array.shape[:-1] != (rows,):
            raise ValueError(f"{name} has the shape {array.shape}, not ({rows}, n)")
        checked[name] = array
    counts = {name: array.shape[1] for name, array in checked.items()}
    n = next((count for count in counts.values() if count != 1), 1)
    for name, count in counts.items():
        if count not in (1, n):
            raise ValueError(f"{name} has {count} points, not {n} or 1: the points of the arrays are {counts}")
    return n, *(np.broadcast_to(array, (len(array), n)) for array in checked.values())


def _constant(name, array, shape):
    """An array that is the same at all points, of its shape."""
    array = np.asarray(array, dtype=np.float64)
    if array.shape != shape:
        raise ValueError(f"{name} has the shape {array.shape}, not {shape}")
    return array


def _polynomial(s, *coefficients):
    """c1 s + c2 s^2 + ..: Horner's form, in place, so that one row of memory is gone over again and again."""
    value = coefficients[-1] * s
    for c in coefficients[-2::-1]:
        value += c
        value *= s
    return value


def tool_in_workpiece_ideal(positions, parameters, point):
    """Ideal position of a tool point in the workpiece frame.

    Source: Eqs. (1)-(4) without errors. Operations: 87 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        parameters (26,): home positions and location errors [mm, rad]
            rows: q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C
                eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        ideal (3, n): tool point in the workpiece frame, without errors [mm]
            rows: px py pz
    """
    n, positions, point = _points(positions=(positions, 5), point=(point, 3))
    parameters = _constant("parameters", parameters, (26,))
    ideal = np.zeros((3, n))
    # constants
    q_Cx = float(parameters[0])
    q_Cy = float(parameters[1])
    q_Cz = float(parameters[2])
    q_wx = float(parameters[3])
    q_wy = float(parameters[4])
    q_wz = float(parameters[5])
    q_Bx = float(parameters[6])
    q_By = float(parameters[7])
    q_Bz = float(parameters[8])
    q_Sx = float(parameters[9])
    q_Sy = float(parameters[10])
    q_Sz = float(parameters[11])
    q_Tx = float(parameters[12])
    q_Ty = float(parameters[13])
    q_Tz = float(parameters[14])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        x = positions[0, at]
        y = positions[1, at]
        z = positions[2, at]
        b = positions[3, at]
        c = positions[4, at]
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # cosines and sines
        cos_b = np.cos(0.017453292519943295*b)
        sin_b = np.sin(0.017453292519943295*b)
        cos_c = np.cos(0.017453292519943295*c)
        sin_c = np.sin(0.017453292519943295*c)
        # per point
        w0 = cos_b*cos_c
        w1 = cos_c*sin_b
        ideal[0, at] = cos_c*q_Bx - cos_c*q_Cx + cos_c*x + q_By*sin_c - q_Cy*sin_c + q_Sx*w0 + q_Sy*sin_c + q_Sz*w1 + q_Tx*w0 + q_Ty*sin_c + q_Tz*w1 - q_wx + rx*w0 + ry*sin_c + rz*w1 - sin_c*y
        w2 = cos_b*sin_c
        w3 = sin_b*sin_c
        ideal[1, at] = cos_c*q_By - cos_c*q_Cy + cos_c*q_Sy + cos_c*q_Ty + cos_c*ry - cos_c*y - q_Bx*sin_c + q_Cx*sin_c - q_Sx*w2 - q_Sz*w3 - q_Tx*w2 - q_Tz*w3 - q_wy - rx*w2 - rz*w3 - sin_c*x
        ideal[2, at] = cos_b*q_Sz + cos_b*q_Tz + cos_b*rz + q_Bz - q_Cz - q_Sx*sin_b - q_Tx*sin_b - q_wz - rx*sin_b + z
    return ideal


def tool_in_workpiece_deviation(positions, errors, parameters, point):
    """Deviation of a tool point in the workpiece frame, exact.

    Source: Eqs. (1)-(4). Operations: 244 per point, 5 per call.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB
                ECB EXC EYC EZC EAC EBC ECC
        parameters (26,): home positions and location errors [mm, rad]
            rows: q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C
                eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): tool point in the workpiece frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions, errors, point = _points(positions=(positions, 5), errors=(errors, 30), point=(point, 3))
    parameters = _constant("parameters", parameters, (26,))
    deviation = np.zeros((3, n))
    # constants
    q_Cx = float(parameters[0])
    q_Cy = float(parameters[1])
    q_Cz = float(parameters[2])
    q_Bx = float(parameters[6])
    q_By = float(parameters[7])
    q_Bz = float(parameters[8])
    q_Sx = float(parameters[9])
    q_Sy = float(parameters[10])
    q_Sz = float(parameters[11])
    q_Tx = float(parameters[12])
    q_Ty = float(parameters[13])
    q_Tz = float(parameters[14])
    EX0C = float(parameters[15])
    EY0C = float(parameters[16])
    EA0C = float(parameters[17])
    EB0C = float(parameters[18])
    eps_xy = float(parameters[19])
    eps_yz = float(parameters[20])
    eps_xz = float(parameters[21])
    EX0B = float(parameters[22])
    EZ0B = float(parameters[23])
    EA0B = float(parameters[24])
    EC0B = float(parameters[25])
    # once per call
    w63 = (EA0C*EA0C) + (EB0C*EB0C)
    w64 = 1.0/(w63 + 1)
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        x = positions[0, at]
        y = positions[1, at]
        z = positions[2, at]
        b = positions[3, at]
        c = positions[4, at]
        EXX = errors[0, at]
        EYX = errors[1, at]
        EZX = errors[2, at]
        EAX = errors[3, at]
        EBX = errors[4, at]
        ECX = errors[5, at]
        EXY = errors[6, at]
        EYY = errors[7, at]
        EZY = errors[8, at]
        EAY = errors[9, at]
        EBY = errors[10, at]
        ECY = errors[11, at]
        EXZ = errors[12, at]
        EYZ = errors[13, at]
        EZZ = errors[14, at]
        EAZ = errors[15, at]
        EBZ = errors[16, at]
        ECZ = errors[17, at]
        EXB = errors[18, at]
        EYB = errors[19, at]
        EZB = errors[20, at]
        EAB = errors[21, at]
        EBB = errors[22, at]
        ECB = errors[23, at]
        EXC = errors[24, at]
        EYC = errors[25, at]
        EZC = errors[26, at]
        EAC = errors[27, at]
        EBC = errors[28, at]
        ECC = errors[29, at]
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # cosines and sines
        cos_b = np.cos(0.017453292519943295*b)
        sin_b = np.sin(0.017453292519943295*b)
        cos_c = np.cos(0.017453292519943295*c)
        sin_c = np.sin(0.017453292519943295*c)
        # per point
        w0 = q_Tx + rx
        w1 = q_Sx + w0
        w2 = q_Tz + rz
        w3 = q_Sz + w2
        w4 = cos_b*w1 + sin_b*w3
        w5 = q_Bx + w4
        w6 = w5 + x
        w7 = -q_Cx + w6
        w8 = q_Ty + ry
        w9 = q_Sy + w8
        w10 = q_By + w9
        w11 = w10 - y
        w12 = -q_Cy + w11
        w13 = cos_c*w7 + sin_c*w12
        w14 = cos_b*w3 - sin_b*w1
        w15 = q_Bz + w14
        w16 = w15 + z
        w17 = -EAB*w3 + ECB*w1 + EYB
        w18 = w17 + w9
        w19 = EBB*w3 - ECB*w9 + EXB
        w20 = EAB*w9 - EBB*w1 + EZB
        w21 = cos_b*w20 - sin_b*w19
        w22 = EA0B*w18 + EZ0B + w21
        w23 = w15 + w22
        w24 = cos_b*w19 + sin_b*w20
        w25 = -EA0B*(w14 + w21) + EC0B*(w24 + w4) + w17
        w26 = w10 + w25
        w27 = -EC0B*w18 + EX0B + w24
        w28 = EBZ*w23 - ECZ*w26 + EXZ + w27
        w29 = w27 + w5
        w30 = -EAZ*w23 + ECZ*w29 + EYZ + w25
        w31 = EAZ*w26 - EBZ*w29 + EZZ + w22
        w32 = -eps_xz*(w28 + w5) + eps_yz*(w10 + w30) + w31
        w33 = w16 + w32
        w34 = w16 + w31
        w35 = -eps_yz*w34 + w30
        w36 = w10 + w35
        w37 = eps_xz*w34 + w28
        w38 = EBX*w33 - ECX*w36 + EXX + w37
        w39 = w37 + w5
        w40 = -EAX*w33 + ECX*w39 + EYX + w35
        w41 = -eps_xy*(w10 + w40) + w38
        w42 = -EXY + w41
        w43 = eps_xy*(w38 + w6) + w40
        w44 = -EYY + w43
        w45 = w11 + w44
        w46 = EAX*w36 - EBX*w39 + EZX + w32
        w47 = -EZY + w46
        w48 = w16 + w47
        w49 = w42 + w6
        w50 = EAY*w49 + EBY*w45 + ECY*w48
        w51 = (EAY*EAY) + (EBY*EBY) + (ECY*ECY)
        w52 = 1.0/(w51 + 1)
        w53 = w52*(EAY*w50 - EBY*w48 + ECY*w45 + w42 - w51*w6)
        w54 = -EX0C + w53
        w55 = w52*(-EAY*w45 + EBY*w49 + ECY*w50 - w16*w51 + w47)
        w56 = -q_Cz + w16
        w57 = w55 + w56
        w58 = w54 + w7
        w59 = w52*(EAY*w48 + EBY*w50 - ECY*w49 - w11*w51 + w44)
        w60 = -EY0C + w59
        w61 = w12 + w60
        w62 = EA0C*w58 + EB0C*w61
        w65 = w64*(EA0C*w62 - EB0C*w57 + w54 - w63*w7)
        w66 = w64*(EA0C*w57 + EB0C*w62 - w12*w63 + w60)
        w67 = cos_c*w65 + sin_c*w66
        w68 = -EXC + w67
        w69 = cos_c*w12 - sin_c*w7
        w70 = cos_c*w66 - sin_c*w65
        w71 = -EYC + w70
        w72 = w69 + w71
        w73 = w64*(-EA0C*w61 + EB0C*w58 + w55 - w56*w63)
        w74 = -EZC + w73
        w75 = w56 + w74
        w76 = w13 + w68
        w77 = EAC*w76 + EBC*w72 + ECC*w75
        w78 = (EAC*EAC) + (EBC*EBC) + (ECC*ECC)
        w79 = 1.0/(w78 + 1)
        deviation[0, at] = w79*(EAC*w77 - EBC*w75 + ECC*w72 - w13*w78 + w68)
        deviation[1, at] = w79*(EAC*w75 + EBC*w77 - ECC*w76 - w69*w78 + w71)
        deviation[2, at] = w79*(-EAC*w72 + EBC*w76 + ECC*w77 - w56*w78 + w74)
    return deviation


def tool_in_workpiece_deviation_first_order(positions, errors, parameters, point):
    """Deviation of a tool point in the workpiece frame, to first order in the errors.

    Source: Eqs. (1)-(4). Operations: 151 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB
                ECB EXC EYC EZC EAC EBC ECC
        parameters (26,): home positions and location errors [mm, rad]
            rows: q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C
                eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): tool point in the workpiece frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions, errors, point = _points(positions=(positions, 5), errors=(errors, 30), point=(point, 3))
    parameters = _constant("parameters", parameters, (26,))
    deviation = np.zeros((3, n))
    # constants
    q_Cx = float(parameters[0])
    q_Cy = float(parameters[1])
    q_Cz = float(parameters[2])
    q_Bx = float(parameters[6])
    q_By = float(parameters[7])
    q_Bz = float(parameters[8])
    q_Sx = float(parameters[9])
    q_Sy = float(parameters[10])
    q_Sz = float(parameters[11])
    q_Tx = float(parameters[12])
    q_Ty = float(parameters[13])
    q_Tz = float(parameters[14])
    EX0C = float(parameters[15])
    EY0C = float(parameters[16])
    EA0C = float(parameters[17])
    EB0C = float(parameters[18])
    eps_xy = float(parameters[19])
    eps_yz = float(parameters[20])
    eps_xz = float(parameters[21])
    EX0B = float(parameters[22])
    EZ0B = float(parameters[23])
    EA0B = float(parameters[24])
    EC0B = float(parameters[25])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        x = positions[0, at]
        y = positions[1, at]
        z = positions[2, at]
        b = positions[3, at]
        c = positions[4, at]
        EXX = errors[0, at]
        EYX = errors[1, at]
        EZX = errors[2, at]
        EAX = errors[3, at]
        EBX = errors[4, at]
        ECX = errors[5, at]
        EXY = errors[6, at]
        EYY = errors[7, at]
        EZY = errors[8, at]
        EAY = errors[9, at]
        EBY = errors[10, at]
        ECY = errors[11, at]
        EXZ = errors[12, at]
        EYZ = errors[13, at]
        EZZ = errors[14, at]
        EAZ = errors[15, at]
        EBZ = errors[16, at]
        ECZ = errors[17, at]
        EXB = errors[18, at]
        EYB = errors[19, at]
        EZB = errors[20, at]
        EAB = errors[21, at]
        EBB = errors[22, at]
        ECB = errors[23, at]
        EXC = errors[24, at]
        EYC = errors[25, at]
        EZC = errors[26, at]
        EAC = errors[27, at]
        EBC = errors[28, at]
        ECC = errors[29, at]
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # cosines and sines
        cos_b = np.cos(0.017453292519943295*b)
        sin_b = np.sin(0.017453292519943295*b)
        cos_c = np.cos(0.017453292519943295*c)
        sin_c = np.sin(0.017453292519943295*c)
        # per point
        w0 = q_Tx + rx
        w1 = q_Sx + w0
        w2 = q_Tz + rz
        w3 = q_Sz + w2
        w4 = cos_b*w3 - sin_b*w1
        w5 = q_Bz + w4
        w6 = w5 + z
        w7 = -q_Cz + w6
        w8 = cos_b*w1 + sin_b*w3
        w9 = q_Bx + w8
        w10 = w9 + x
        w11 = -q_Cx + w10
        w12 = q_Ty + ry
        w13 = q_Sy + w12
        w14 = q_By + w13
        w15 = w14 - y
        w16 = -q_Cy + w15
        w17 = cos_c*w16 - sin_c*w11
        w18 = EBB*w3 - ECB*w13 + EXB
        w19 = EAB*w13 - EBB*w1 + EZB
        w20 = cos_b*w18 + sin_b*w19
        w21 = -EC0B*w13 + EX0B + w20
        w22 = EBZ*w5 - ECZ*w14 + EXZ + w21
        w23 = eps_xz*w6 + w22
        w24 = EBX*w6 - ECX*w14 + EXX + w23
        w25 = -eps_xy*w14 + w24
        w26 = -EBY*w6 + ECY*w15 - EXY + w25
        w27 = -EB0C*w7 - EX0C + w26
        w28 = -EAB*w3 + ECB*w1 + EYB
        w29 = -EA0B*w4 + EC0B*w8 + w28
        w30 = -EAZ*w5 + ECZ*w9 + EYZ + w29
        w31 = -eps_yz*w6 + w30
        w32 = -EAX*w6 + ECX*w9 + EYX + w31
        w33 = eps_xy*w10 + w32
        w34 = EAY*w6 - ECY*w10 - EYY + w33
        w35 = EA0C*w7 - EY0C + w34
        w36 = cos_c*w27 + sin_c*w35
        deviation[0, at] = -EBC*w7 + ECC*w17 - EXC + w36
        w37 = cos_c*w11 + sin_c*w16
        w38 = cos_c*w35 - sin_c*w27
        deviation[1, at] = EAC*w7 - ECC*w37 - EYC + w38
        w39 = cos_b*w19 - sin_b*w18
        w40 = EA0B*w13 + EZ0B + w39
        w41 = EAZ*w14 - EBZ*w9 + EZZ + w40
        w42 = -eps_xz*w9 + eps_yz*w14 + w41
        w43 = EAX*w14 - EBX*w9 + EZX + w42
        w44 = -EAY*w15 + EBY*w10 - EZY + w43
        w45 = -EA0C*w16 + EB0C*w11 + w44
        deviation[2, at] = -EAC*w17 + EBC*w37 - EZC + w45
    return deviation


def tool_in_workpiece_sensitivity(positions, parameters, point):
    """Sensitivity of a tool point in the workpiece frame to every error, at the error-free machine.

    Source: Eqs. (1)-(4), first order. Operations: 219 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        parameters (26,): home positions and location errors [mm, rad]
            rows: q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C
                eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        sensitivity (3, 41, n): derivative of the deviation by each component error, then by each location error [mm/mm, mm/rad]
            rows: dx_EXX dx_EYX .. dz_EC0B, last index fastest
    """
    n, positions, point = _points(positions=(positions, 5), point=(point, 3))
    parameters = _constant("parameters", parameters, (26,))
    sensitivity = np.zeros((123, n))
    # constants
    q_Cx = float(parameters[0])
    q_Cy = float(parameters[1])
    q_Cz = float(parameters[2])
    q_Bx = float(parameters[6])
    q_By = float(parameters[7])
    q_Bz = float(parameters[8])
    q_Sx = float(parameters[9])
    q_Sy = float(parameters[10])
    q_Sz = float(parameters[11])
    q_Tx = float(parameters[12])
    q_Ty = float(parameters[13])
    q_Tz = float(parameters[14])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        x = positions[0, at]
        y = positions[1, at]
        z = positions[2, at]
        b = positions[3, at]
        c = positions[4, at]
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # cosines and sines
        cos_b = np.cos(0.017453292519943295*b)
        sin_b = np.sin(0.017453292519943295*b)
        cos_c = np.cos(0.017453292519943295*c)
        sin_c = np.sin(0.017453292519943295*c)
        # per point
        w0 = q_Sz*sin_c
        w1 = q_Tz*sin_c
        w2 = rz*sin_c
        w3 = q_Sx*sin_c
        w4 = q_Tx*sin_c
        w5 = rx*sin_c
        w6 = cos_b*w0 + cos_b*w1 + cos_b*w2 - sin_b*w3 - sin_b*w4 - sin_b*w5
        w7 = q_Bz*sin_c + w6
        sensitivity[9, at] = dx_EAY = sin_c*z + w7
        sensitivity[3, at] = dx_EAX = -dx_EAY
        sensitivity[18, at] = dx_EXB = cos_b*cos_c
        sensitivity[20, at] = dx_EZB = cos_c*sin_b
        sensitivity[22, at] = dx_EBB = dx_EXB*q_Sz + dx_EXB*q_Tz + dx_EXB*rz - dx_EZB*q_Sx - dx_EZB*q_Tx - dx_EZB*rx
        sensitivity[16, at] = dx_EBZ = cos_c*q_Bz + dx_EBB
        sensitivity[4, at] = dx_EBX = cos_c*z + dx_EBZ
        w8 = cos_c*q_Sy
        w9 = cos_c*q_Ty
        w10 = cos_c*ry
        sensitivity[40, at] = dx_EC0B = cos_b*w3 + cos_b*w4 + cos_b*w5 + sin_b*w0 + sin_b*w1 + sin_b*w2 - w10 - w8 - w9
        sensitivity[5, at] = dx_ECX = -cos_c*q_By + dx_EC0B + q_Bx*sin_c
        sensitivity[6, at] = dx_EXY = -cos_c
        sensitivity[7, at] = dx_EYY = -sin_c
        sensitivity[10, at] = dx_EBY = -dx_EBX
        sensitivity[34, at] = dx_eps_xy = dx_ECX + sin_c*x
        sensitivity[15, at] = dx_EAZ = -w7
        sensitivity[68, at] = dy_EAC = cos_b*q_Sz + cos_b*q_Tz + cos_b*rz + q_Bz - q_Cz - q_Sx*sin_b - q_Tx*sin_b - rx*sin_b + z
        w11 = cos_c*y + dx_eps_xy
        sensitivity[109, at] = dz_EAC = cos_c*q_Cy - q_Cx*sin_c + w11
        sensitivity[32, at] = dx_EA0C = dx_EAY - q_Cz*sin_c
        sensitivity[73, at] = dy_EA0C = -cos_c*q_Cz + dx_EBX
        sensitivity[39, at] = dx_EA0B = -w6
        w12 = q_Sy*sin_c
        w13 = q_Ty*sin_c
        w14 = ry*sin_c
        sensitivity[81, at] = dy_EC0B = dx_EXB*q_Sx + dx_EXB*q_Tx + dx_EXB*rx + dx_EZB*q_Sz + dx_EZB*q_Tz + dx_EZB*rz + w12 + w13 + w14
        sensitivity[46, at] = dy_ECX = cos_c*q_Bx + dy_EC0B + q_By*sin_c
        sensitivity[75, at] = dy_eps_xy = cos_c*x + dy_ECX
        w15 = dy_eps_xy - sin_c*y
        sensitivity[110, at] = dz_EBC = -cos_c*q_Cx - q_Cy*sin_c + w15
        sensitivity[121, at] = dz_EA0B = q_Sy + q_Ty + ry
        sensitivity[85, at] = dz_EAX = dz_EA0B + q_By
        w16 = cos_b*q_Sx + cos_b*q_Tx + cos_b*rx + q_Sz*sin_b + q_Tz*sin_b + rz*sin_b
        w17 = q_Bx + w16
        sensitivity[86, at] = dz_EBX = -w17
        sensitivity[92, at] = dz_EBY = w17 + x
        sensitivity[0, at] = cos_c
        sensitivity[1, at] = sin_c
        sensitivity[11, at] = -w11
        sensitivity[12, at] = cos_c
        sensitivity[13, at] = sin_c
        sensitivity[17, at] = dx_ECX
        sensitivity[19, at] = sin_c
        sensitivity[21, at] = sin_b*w10 + sin_b*w8 + sin_b*w9 - w0 - w1 - w2
        sensitivity[23, at] = -cos_b*w10 - cos_b*w8 - cos_b*w9 + q_Sx*sin_c + q_Tx*sin_c + rx*sin_c
        sensitivity[24, at] = -1.0
        sensitivity[28, at] = -dy_EAC
        sensitivity[29, at] = -dz_EAC
        sensitivity[30, at] = dx_EXY
        sensitivity[31, at] = dx_EYY
        sensitivity[33, at] = -dy_EA0C
        sensitivity[35, at] = dx_EAX
        sensitivity[36, at] = dx_EBX
        sensitivity[37, at] = cos_c
        sensitivity[41, at] = dx_EYY
        sensitivity[42, at] = cos_c
        sensitivity[44, at] = dx_EBY
        sensitivity[45, at] = dx_EAX
        sensitivity[47, at] = sin_c
        sensitivity[48, at] = dx_EXY
        sensitivity[50, at] = dx_EBX
        sensitivity[51, at] = dx_EAY
        sensitivity[52, at] = -w15
        sensitivity[53, at] = dx_EYY
        sensitivity[54, at] = cos_c
        sensitivity[56, at] = -dx_EBZ
        sensitivity[57, at] = dx_EAZ
        sensitivity[58, at] = dy_ECX
        sensitivity[59, at] = -cos_b*sin_c
        sensitivity[60, at] = cos_c
        sensitivity[61, at] = -sin_b*sin_c
        sensitivity[62, at] = -cos_c*q_Sz - cos_c*q_Tz - cos_c*rz - sin_b*w12 - sin_b*w13 - sin_b*w14
        sensitivity[63, at] = dx_EA0B
        sensitivity[64, at] = cos_b*w12 + cos_b*w13 + cos_b*w14 + cos_c*q_Sx + cos_c*q_Tx + cos_c*rx
        sensitivity[66, at] = -1.0
        sensitivity[70, at] = -dz_EBC
        sensitivity[71, at] = sin_c
        sensitivity[72, at] = dx_EXY
        sensitivity[74, at] = dx_EA0C
        sensitivity[76, at] = dx_EBY
        sensitivity[77, at] = dx_EAX
        sensitivity[78, at] = dx_EYY
        sensitivity[80, at] = -dx_EBB
        sensitivity[84, at] = 1.0
        sensitivity[90, at] = -1.0
        w18 = dz_EAX - y
        sensitivity[91, at] = -w18
        sensitivity[96, at] = 1.0
        sensitivity[97, at] = dz_EAX
        sensitivity[98, at] = dz_EBX
        sensitivity[100, at] = -sin_b
        sensitivity[102, at] = cos_b
        sensitivity[103, at] = cos_b*q_Sy + cos_b*q_Ty + cos_b*ry
        sensitivity[104, at] = -w16
        sensitivity[105, at] = q_Sy*sin_b + q_Ty*sin_b + ry*sin_b
        sensitivity[108, at] = -1.0
        sensitivity[114, at] = q_Cy - w18
        sensitivity[115, at] = dz_EBY - q_Cx
        sensitivity[117, at] = dz_EAX
        sensitivity[118, at] = dz_EBX
        sensitivity[120, at] = 1.0
    return sensitivity.reshape(3, 41, n)


def tool_in_bed_ideal(positions, parameters, point):
    """Ideal position of a tool point in the bed frame.

    Source: Eqs. (1)-(4) without errors. Operations: 33 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        parameters (26,): home positions and location errors [mm, rad]
            rows: q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C
                eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        ideal (3, n): tool point in the bed frame, without errors [mm]
            rows: px py pz
    """
    n, positions, point = _points(positions=(positions, 5), point=(point, 3))
    parameters = _constant("parameters", parameters, (26,))
    ideal = np.zeros((3, n))
    # constants
    q_Bx = float(parameters[6])
    q_By = float(parameters[7])
    q_Bz = float(parameters[8])
    q_Sx = float(parameters[9])
    q_Sy = float(parameters[10])
    q_Sz = float(parameters[11])
    q_Tx = float(parameters[12])
    q_Ty = float(parameters[13])
    q_Tz = float(parameters[14])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        x = positions[0, at]
        z = positions[2, at]
        b = positions[3, at]
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # cosines and sines
        cos_b = np.cos(0.017453292519943295*b)
        sin_b = np.sin(0.017453292519943295*b)
        # per point
        ideal[0, at] = cos_b*q_Sx + cos_b*q_Tx + cos_b*rx + q_Bx + q_Sz*sin_b + q_Tz*sin_b + rz*sin_b + x
        ideal[1, at] = q_By + q_Sy + q_Ty + ry
        ideal[2, at] = cos_b*q_Sz + cos_b*q_Tz + cos_b*rz + q_Bz - q_Sx*sin_b - q_Tx*sin_b - rx*sin_b + z
    return ideal


def tool_in_bed_deviation(positions, errors, parameters, point):
    """Deviation of a tool point in the bed frame, exact.

    Source: Eqs. (1)-(4). Operations: 105 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB
                ECB EXC EYC EZC EAC EBC ECC
        parameters (26,): home positions and location errors [mm, rad]
            rows: q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C
                eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): tool point in the bed frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions, errors, point = _points(positions=(positions, 5), errors=(errors, 30), point=(point, 3))
    parameters = _constant("parameters", parameters, (26,))
    deviation = np.zeros((3, n))
    # constants
    q_Bx = float(parameters[6])
    q_By = float(parameters[7])
    q_Bz = float(parameters[8])
    q_Sx = float(parameters[9])
    q_Sy = float(parameters[10])
    q_Sz = float(parameters[11])
    q_Tx = float(parameters[12])
    q_Ty = float(parameters[13])
    q_Tz = float(parameters[14])
    eps_xy = float(parameters[19])
    eps_yz = float(parameters[20])
    eps_xz = float(parameters[21])
    EX0B = float(parameters[22])
    EZ0B = float(parameters[23])
    EA0B = float(parameters[24])
    EC0B = float(parameters[25])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        x = positions[0, at]
        z = positions[2, at]
        b = positions[3, at]
        EXX = errors[0, at]
        EYX = errors[1, at]
        EZX = errors[2, at]
        EAX = errors[3, at]
        EBX = errors[4, at]
        ECX = errors[5, at]
        EXZ = errors[12, at]
        EYZ = errors[13, at]
        EZZ = errors[14, at]
        EAZ = errors[15, at]
        EBZ = errors[16, at]
        ECZ = errors[17, at]
        EXB = errors[18, at]
        EYB = errors[19, at]
        EZB = errors[20, at]
        EAB = errors[21, at]
        EBB = errors[22, at]
        ECB = errors[23, at]
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # cosines and sines
        cos_b = np.cos(0.017453292519943295*b)
        sin_b = np.sin(0.017453292519943295*b)
        # per point
        w0 = q_Ty + ry
        w1 = q_Sy + w0
        w2 = q_By + w1
        w3 = q_Tx + rx
        w4 = q_Sx + w3
        w5 = q_Tz + rz
        w6 = q_Sz + w5
        w7 = -EAB*w6 + ECB*w4 + EYB
        w8 = cos_b*w4 + sin_b*w6
        w9 = cos_b*w6 - sin_b*w4
        w10 = EBB*w6 - ECB*w1 + EXB
        w11 = EAB*w1 - EBB*w4 + EZB
        w12 = cos_b*w10 + sin_b*w11
        w13 = cos_b*w11 - sin_b*w10
        w14 = -EA0B*(w13 + w9) + EC0B*(w12 + w8) + w7
        w15 = w14 + w2
        w16 = w1 + w7
        w17 = -EC0B*w16 + EX0B + w12
        w18 = q_Bx + w8
        w19 = w17 + w18
        w20 = EA0B*w16 + EZ0B + w13
        w21 = EAZ*w15 - EBZ*w19 + EZZ + w20
        w22 = q_Bz + w9
        w23 = w22 + z
        w24 = w21 + w23
        w25 = w20 + w22
        w26 = -EAZ*w25 + ECZ*w19 + EYZ + w14
        w27 = -eps_yz*w24 + w26
        w28 = w2 + w27
        w29 = EBZ*w25 - ECZ*w15 + EXZ + w17
        w30 = eps_xz*w24 + w29
        w31 = w18 + w30
        w32 = -eps_xz*(w18 + w29) + eps_yz*(w2 + w26) + w21
        deviation[2, at] = EAX*w28 - EBX*w31 + EZX + w32
        w33 = w23 + w32
        w34 = EBX*w33 - ECX*w28 + EXX + w30
        w35 = -EAX*w33 + ECX*w31 + EYX + w27
        deviation[0, at] = -eps_xy*(w2 + w35) + w34
        w36 = w18 + x
        deviation[1, at] = eps_xy*(w34 + w36) + w35
    return deviation


def tool_in_bed_deviation_first_order(positions, errors, parameters, point):
    """Deviation of a tool point in the bed frame, to first order in the errors.

    Source: Eqs. (1)-(4). Operations: 91 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB
                ECB EXC EYC EZC EAC EBC ECC
        parameters (26,): home positions and location errors [mm, rad]
            rows: q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C
                eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): tool point in the bed frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions, errors, point = _points(positions=(positions, 5), errors=(errors, 30), point=(point, 3))
    parameters = _constant("parameters", parameters, (26,))
    deviation = np.zeros((3, n))
    # constants
    q_Bx = float(parameters[6])
    q_By = float(parameters[7])
    q_Bz = float(parameters[8])
    q_Sx = float(parameters[9])
    q_Sy = float(parameters[10])
    q_Sz = float(parameters[11])
    q_Tx = float(parameters[12])
    q_Ty = float(parameters[13])
    q_Tz = float(parameters[14])
    eps_xy = float(parameters[19])
    eps_yz = float(parameters[20])
    eps_xz = float(parameters[21])
    EX0B = float(parameters[22])
    EZ0B = float(parameters[23])
    EA0B = float(parameters[24])
    EC0B = float(parameters[25])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        x = positions[0, at]
        z = positions[2, at]
        b = positions[3, at]
        EXX = errors[0, at]
        EYX = errors[1, at]
        EZX = errors[2, at]
        EAX = errors[3, at]
        EBX = errors[4, at]
        ECX = errors[5, at]
        EXZ = errors[12, at]
        EYZ = errors[13, at]
        EZZ = errors[14, at]
        EAZ = errors[15, at]
        EBZ = errors[16, at]
        ECZ = errors[17, at]
        EXB = errors[18, at]
        EYB = errors[19, at]
        EZB = errors[20, at]
        EAB = errors[21, at]
        EBB = errors[22, at]
        ECB = errors[23, at]
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # cosines and sines
        cos_b = np.cos(0.017453292519943295*b)
        sin_b = np.sin(0.017453292519943295*b)
        # per point
        w0 = q_Tx + rx
        w1 = q_Sx + w0
        w2 = q_Tz + rz
        w3 = q_Sz + w2
        w4 = cos_b*w1 + sin_b*w3
        w5 = q_Bx + w4
        w6 = q_Ty + ry
        w7 = q_Sy + w6
        w8 = q_By + w7
        w9 = EBB*w3 - ECB*w7 + EXB
        w10 = EAB*w7 - EBB*w1 + EZB
        w11 = cos_b*w10 - sin_b*w9
        w12 = EA0B*w7 + EZ0B + w11
        w13 = EAZ*w8 - EBZ*w5 + EZZ + w12
        w14 = -eps_xz*w5 + eps_yz*w8 + w13
        deviation[2, at] = EAX*w8 - EBX*w5 + EZX + w14
        w15 = cos_b*w3 - sin_b*w1
        w16 = q_Bz + w15
        w17 = w16 + z
        w18 = cos_b*w9 + sin_b*w10
        w19 = -EC0B*w7 + EX0B + w18
        w20 = EBZ*w16 - ECZ*w8 + EXZ + w19
        w21 = eps_xz*w17 + w20
        w22 = EBX*w17 - ECX*w8 + EXX + w21
        deviation[0, at] = -eps_xy*w8 + w22
        w23 = -EAB*w3 + ECB*w1 + EYB
        w24 = -EA0B*w15 + EC0B*w4 + w23
        w25 = -EAZ*w16 + ECZ*w5 + EYZ + w24
        w26 = -eps_yz*w17 + w25
        w27 = -EAX*w17 + ECX*w5 + EYX + w26
        w28 = w5 + x
        deviation[1, at] = eps_xy*w28 + w27
    return deviation


def tool_in_bed_sensitivity(positions, parameters, point):
    """Sensitivity of a tool point in the bed frame to every error, at the error-free machine.

    Source: Eqs. (1)-(4), first order. Operations: 57 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        parameters (26,): home positions and location errors [mm, rad]
            rows: q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C
                eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        sensitivity (3, 41, n): derivative of the deviation by each component error, then by each location error [mm/mm, mm/rad]
            rows: dx_EXX dx_EYX .. dz_EC0B, last index fastest
    """
    n, positions, point = _points(positions=(positions, 5), point=(point, 3))
    parameters = _constant("parameters", parameters, (26,))
    sensitivity = np.zeros((123, n))
    # constants
    q_Bx = float(parameters[6])
    q_By = float(parameters[7])
    q_Bz = float(parameters[8])
    q_Sx = float(parameters[9])
    q_Sy = float(parameters[10])
    q_Sz = float(parameters[11])
    q_Tx = float(parameters[12])
    q_Ty = float(parameters[13])
    q_Tz = float(parameters[14])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        x = positions[0, at]
        z = positions[2, at]
        b = positions[3, at]
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # cosines and sines
        cos_b = np.cos(0.017453292519943295*b)
        sin_b = np.sin(0.017453292519943295*b)
        # per point
        sensitivity[22, at] = dx_EBB = cos_b*q_Sz + cos_b*q_Tz + cos_b*rz - q_Sx*sin_b - q_Tx*sin_b - rx*sin_b
        sensitivity[16, at] = dx_EBZ = dx_EBB + q_Bz
        sensitivity[4, at] = dx_EBX = dx_EBZ + z
        sensitivity[121, at] = dz_EA0B = q_Sy + q_Ty + ry
        sensitivity[85, at] = dz_EAX = dz_EA0B + q_By
        sensitivity[5, at] = dx_ECX = -dz_EAX
        sensitivity[21, at] = dx_EAB = q_Sy*sin_b + q_Ty*sin_b + ry*sin_b
        sensitivity[103, at] = dz_EAB = cos_b*q_Sy + cos_b*q_Ty + cos_b*ry
        sensitivity[44, at] = dy_EAX = -dx_EBX
        sensitivity[81, at] = dy_EC0B = cos_b*q_Sx + cos_b*q_Tx + cos_b*rx + q_Sz*sin_b + q_Tz*sin_b + rz*sin_b
        sensitivity[46, at] = dy_ECX = dy_EC0B + q_Bx
        sensitivity[86, at] = dz_EBX = -dy_ECX
        sensitivity[0, at] = 1.0
        sensitivity[12, at] = 1.0
        sensitivity[17, at] = dx_ECX
        sensitivity[18, at] = cos_b
        sensitivity[20, at] = sin_b
        sensitivity[23, at] = -dz_EAB
        sensitivity[34, at] = dx_ECX
        sensitivity[36, at] = dx_EBX
        sensitivity[37, at] = 1.0
        sensitivity[40, at] = -dz_EA0B
        sensitivity[42, at] = 1.0
        sensitivity[54, at] = 1.0
        sensitivity[56, at] = -dx_EBZ
        sensitivity[58, at] = dy_ECX
        sensitivity[60, at] = 1.0
        sensitivity[62, at] = -q_Sz - q_Tz - rz
        sensitivity[64, at] = q_Sx + q_Tx + rx
        sensitivity[75, at] = dy_ECX + x
        sensitivity[76, at] = dy_EAX
        sensitivity[80, at] = -dx_EBB
        sensitivity[84, at] = 1.0
        sensitivity[96, at] = 1.0
        sensitivity[97, at] = dz_EAX
        sensitivity[98, at] = dz_EBX
        sensitivity[100, at] = -sin_b
        sensitivity[102, at] = cos_b
        sensitivity[104, at] = -dy_EC0B
        sensitivity[105, at] = dx_EAB
        sensitivity[117, at] = dz_EAX
        sensitivity[118, at] = dz_EBX
        sensitivity[120, at] = 1.0
    return sensitivity.reshape(3, 41, n)


def workpiece_in_bed_ideal(positions, parameters, point):
    """Ideal position of a workpiece point in the bed frame.

    Source: Eqs. (1)-(4) without errors. Operations: 23 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        parameters (26,): home positions and location errors [mm, rad]
            rows: q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C
                eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B
        point (3, n): point in the workpiece frame [mm]
            rows: rx ry rz

    Returns:
        ideal (3, n): workpiece point in the bed frame, without errors [mm]
            rows: px py pz
    """
    n, positions, point = _points(positions=(positions, 5), point=(point, 3))
    parameters = _constant("parameters", parameters, (26,))
    ideal = np.zeros((3, n))
    # constants
    q_Cx = float(parameters[0])
    q_Cy = float(parameters[1])
    q_Cz = float(parameters[2])
    q_wx = float(parameters[3])
    q_wy = float(parameters[4])
    q_wz = float(parameters[5])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        y = positions[1, at]
        c = positions[4, at]
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # cosines and sines
        cos_c = np.cos(0.017453292519943295*c)
        sin_c = np.sin(0.017453292519943295*c)
        # per point
        ideal[0, at] = cos_c*q_wx + cos_c*rx + q_Cx - q_wy*sin_c - ry*sin_c
        ideal[1, at] = cos_c*q_wy + cos_c*ry + q_Cy + q_wx*sin_c + rx*sin_c + y
        ideal[2, at] = q_Cz + q_wz + rz
    return ideal


def workpiece_in_bed_deviation(positions, errors, parameters, point):
    """Deviation of a workpiece point in the bed frame, exact.

    Source: Eqs. (1)-(4). Operations: 65 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB
                ECB EXC EYC EZC EAC EBC ECC
        parameters (26,): home positions and location errors [mm, rad]
            rows: q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C
                eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B
        point (3, n): point in the workpiece frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): workpiece point in the bed frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions, errors, point = _points(positions=(positions, 5), errors=(errors, 30), point=(point, 3))
    parameters = _constant("parameters", parameters, (26,))
    deviation = np.zeros((3, n))
    # constants
    q_Cx = float(parameters[0])
    q_Cy = float(parameters[1])
    q_Cz = float(parameters[2])
    q_wx = float(parameters[3])
    q_wy = float(parameters[4])
    q_wz = float(parameters[5])
    EX0C = float(parameters[15])
    EY0C = float(parameters[16])
    EA0C = float(parameters[17])
    EB0C = float(parameters[18])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        c = positions[4, at]
        EXY = errors[6, at]
        EYY = errors[7, at]
        EZY = errors[8, at]
        EAY = errors[9, at]
        EBY = errors[10, at]
        ECY = errors[11, at]
        EXC = errors[24, at]
        EYC = errors[25, at]
        EZC = errors[26, at]
        EAC = errors[27, at]
        EBC = errors[28, at]
        ECC = errors[29, at]
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # cosines and sines
        cos_c = np.cos(0.017453292519943295*c)
        sin_c = np.sin(0.017453292519943295*c)
        # per point
        w0 = q_wx + rx
        w1 = q_wy + ry
        w2 = EAC*w1 - EBC*w0 + EZC
        w3 = cos_c*w0 - sin_c*w1
        w4 = cos_c*w1 + sin_c*w0
        w5 = q_wz + rz
        w6 = EBC*w5 - ECC*w1 + EXC
        w7 = -EAC*w5 + ECC*w0 + EYC
        w8 = cos_c*w6 - sin_c*w7
        w9 = cos_c*w7 + sin_c*w6
        w10 = EA0C*(w4 + w9) - EB0C*(w3 + w8) + w2
        w11 = q_Cz + w5
        w12 = w10 + w11
        w13 = w2 + w5
        w14 = -EA0C*w13 + EY0C + w9
        w15 = q_Cy + w4
        w16 = w14 + w15
        w17 = EB0C*w13 + EX0C + w8
        deviation[0, at] = EBY*w12 - ECY*w16 + EXY + w17
        w18 = q_Cx + w3
        w19 = w17 + w18
        deviation[1, at] = -EAY*w12 + ECY*w19 + EYY + w14
        deviation[2, at] = EAY*w16 - EBY*w19 + EZY + w10
    return deviation


def workpiece_in_bed_deviation_first_order(positions, errors, parameters, point):
    """Deviation of a workpiece point in the bed frame, to first order in the errors.

    Source: Eqs. (1)-(4). Operations: 59 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB
                ECB EXC EYC EZC EAC EBC ECC
        parameters (26,): home positions and location errors [mm, rad]
            rows: q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C
                eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B
        point (3, n): point in the workpiece frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): workpiece point in the bed frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions, errors, point = _points(positions=(positions, 5), errors=(errors, 30), point=(point, 3))
    parameters = _constant("parameters", parameters, (26,))
    deviation = np.zeros((3, n))
    # constants
    q_Cx = float(parameters[0])
    q_Cy = float(parameters[1])
    q_Cz = float(parameters[2])
    q_wx = float(parameters[3])
    q_wy = float(parameters[4])
    q_wz = float(parameters[5])
    EX0C = float(parameters[15])
    EY0C = float(parameters[16])
    EA0C = float(parameters[17])
    EB0C = float(parameters[18])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        c = positions[4, at]
        EXY = errors[6, at]
        EYY = errors[7, at]
        EZY = errors[8, at]
        EAY = errors[9, at]
        EBY = errors[10, at]
        ECY = errors[11, at]
        EXC = errors[24, at]
        EYC = errors[25, at]
        EZC = errors[26, at]
        EAC = errors[27, at]
        EBC = errors[28, at]
        ECC = errors[29, at]
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # cosines and sines
        cos_c = np.cos(0.017453292519943295*c)
        sin_c = np.sin(0.017453292519943295*c)
        # per point
        w0 = q_wz + rz
        w1 = q_wy + ry
        w2 = EBC*w0 - ECC*w1 + EXC
        w3 = q_wx + rx
        w4 = -EAC*w0 + ECC*w3 + EYC
        w5 = cos_c*w2 - sin_c*w4
        w6 = EB0C*w0 + EX0C + w5
        w7 = cos_c*w1 + sin_c*w3
        w8 = q_Cy + w7
        w9 = q_Cz + w0
        deviation[0, at] = EBY*w9 - ECY*w8 + EXY + w6
        w10 = cos_c*w4 + sin_c*w2
        w11 = -EA0C*w0 + EY0C + w10
        w12 = cos_c*w3 - sin_c*w1
        w13 = q_Cx + w12
        deviation[1, at] = -EAY*w9 + ECY*w13 + EYY + w11
        w14 = EAC*w1 - EBC*w3 + EZC
        w15 = EA0C*w7 - EB0C*w12 + w14
        deviation[2, at] = EAY*w8 - EBY*w13 + EZY + w15
    return deviation


def workpiece_in_bed_sensitivity(positions, parameters, point):
    """Sensitivity of a workpiece point in the bed frame to every error, at the error-free machine.

    Source: Eqs. (1)-(4), first order. Operations: 39 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        parameters (26,): home positions and location errors [mm, rad]
            rows: q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C
                eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B
        point (3, n): point in the workpiece frame [mm]
            rows: rx ry rz

    Returns:
        sensitivity (3, 41, n): derivative of the deviation by each component error, then by each location error [mm/mm, mm/rad]
            rows: dx_EXX dx_EYX .. dz_EC0B, last index fastest
    """
    n, positions, point = _points(positions=(positions, 5), point=(point, 3))
    parameters = _constant("parameters", parameters, (26,))
    sensitivity = np.zeros((123, n))
    # constants
    q_Cx = float(parameters[0])
    q_Cy = float(parameters[1])
    q_Cz = float(parameters[2])
    q_wx = float(parameters[3])
    q_wy = float(parameters[4])
    q_wz = float(parameters[5])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        c = positions[4, at]
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # cosines and sines
        cos_c = np.cos(0.017453292519943295*c)
        sin_c = np.sin(0.017453292519943295*c)
        # per point
        sensitivity[33, at] = dx_EB0C = q_wz + rz
        sensitivity[10, at] = dx_EBY = dx_EB0C + q_Cz
        sensitivity[114, at] = dz_EA0C = cos_c*q_wy + cos_c*ry + q_wx*sin_c + rx*sin_c
        sensitivity[91, at] = dz_EAY = dz_EA0C + q_Cy
        sensitivity[27, at] = dx_EAC = q_wz*sin_c + rz*sin_c
        sensitivity[28, at] = dx_EBC = cos_c*q_wz + cos_c*rz
        sensitivity[70, at] = dy_ECC = cos_c*q_wx + cos_c*rx - q_wy*sin_c - ry*sin_c
        sensitivity[52, at] = dy_ECY = dy_ECC + q_Cx
        sensitivity[6, at] = 1.0
        sensitivity[11, at] = -dz_EAY
        sensitivity[24, at] = cos_c
        sensitivity[25, at] = -sin_c
        sensitivity[29, at] = -dz_EA0C
        sensitivity[30, at] = 1.0
        sensitivity[48, at] = 1.0
        sensitivity[50, at] = -dx_EBY
        sensitivity[65, at] = sin_c
        sensitivity[66, at] = cos_c
        sensitivity[68, at] = -dx_EBC
        sensitivity[69, at] = dx_EAC
        sensitivity[72, at] = 1.0
        sensitivity[73, at] = -dx_EB0C
        sensitivity[90, at] = 1.0
        sensitivity[92, at] = -dy_ECY
        sensitivity[108, at] = 1.0
        sensitivity[109, at] = q_wy + ry
        sensitivity[110, at] = -q_wx - rx
        sensitivity[115, at] = -dy_ECC
    return sensitivity.reshape(3, 41, n)


def bed_in_workpiece_ideal(positions, parameters, point):
    """Ideal position of a bed point in the workpiece frame.

    Source: Eqs. (1)-(4) without errors. Operations: 26 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        parameters (26,): home positions and location errors [mm, rad]
            rows: q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C
                eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B
        point (3, n): point in the bed frame [mm]
            rows: rx ry rz

    Returns:
        ideal (3, n): bed point in the workpiece frame, without errors [mm]
            rows: px py pz
    """
    n, positions, point = _points(positions=(positions, 5), point=(point, 3))
    parameters = _constant("parameters", parameters, (26,))
    ideal = np.zeros((3, n))
    # constants
    q_Cx = float(parameters[0])
    q_Cy = float(parameters[1])
    q_Cz = float(parameters[2])
    q_wx = float(parameters[3])
    q_wy = float(parameters[4])
    q_wz = float(parameters[5])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        y = positions[1, at]
        c = positions[4, at]
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # cosines and sines
        cos_c = np.cos(0.017453292519943295*c)
        sin_c = np.sin(0.017453292519943295*c)
        # per point
        ideal[0, at] = -cos_c*q_Cx + cos_c*rx - q_Cy*sin_c - q_wx + ry*sin_c - sin_c*y
        ideal[1, at] = -cos_c*q_Cy + cos_c*ry - cos_c*y + q_Cx*sin_c - q_wy - rx*sin_c
        ideal[2, at] = -q_Cz - q_wz + rz
    return ideal


def bed_in_workpiece_deviation(positions, errors, parameters, point):
    """Deviation of a bed point in the workpiece frame, exact.

    Source: Eqs. (1)-(4). Operations: 142 per point, 5 per call.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB
                ECB EXC EYC EZC EAC EBC ECC
        parameters (26,): home positions and location errors [mm, rad]
            rows: q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C
                eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B
        point (3, n): point in the bed frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): bed point in the workpiece frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions, errors, point = _points(positions=(positions, 5), errors=(errors, 30), point=(point, 3))
    parameters = _constant("parameters", parameters, (26,))
    deviation = np.zeros((3, n))
    # constants
    q_Cx = float(parameters[0])
    q_Cy = float(parameters[1])
    q_Cz = float(parameters[2])
    EX0C = float(parameters[15])
    EY0C = float(parameters[16])
    EA0C = float(parameters[17])
    EB0C = float(parameters[18])
    # once per call
    w22 = (EA0C*EA0C) + (EB0C*EB0C)
    w23 = 1.0/(w22 + 1)
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        y = positions[1, at]
        c = positions[4, at]
        EXY = errors[6, at]
        EYY = errors[7, at]
        EZY = errors[8, at]
        EAY = errors[9, at]
        EBY = errors[10, at]
        ECY = errors[11, at]
        EXC = errors[24, at]
        EYC = errors[25, at]
        EZC = errors[26, at]
        EAC = errors[27, at]
        EBC = errors[28, at]
        ECC = errors[29, at]
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # cosines and sines
        cos_c = np.cos(0.017453292519943295*c)
        sin_c = np.sin(0.017453292519943295*c)
        # per point
        w0 = -rx
        w1 = -q_Cx - w0
        w2 = ry - y
        w3 = -q_Cy + w2
        w4 = cos_c*w1 + sin_c*w3
        w5 = -EYY + w2
        w6 = -rz
        w7 = -EZY - w6
        w8 = -EXY - w0
        w9 = EAY*w8 + EBY*w5 + ECY*w7
        w10 = (EAY*EAY) + (EBY*EBY) + (ECY*ECY)
        w11 = 1.0/(w10 + 1)
        w12 = w11*(EAY*w9 - EBY*w7 + ECY*w5 - EXY - rx*w10)
        w13 = -EX0C + w12
        w14 = w11*(-EAY*w5 + EBY*w8 + ECY*w9 - EZY - rz*w10)
        w15 = -q_Cz - w6
        w16 = w14 + w15
        w17 = w1 + w13
        w18 = w11*(EAY*w7 + EBY*w9 - ECY*w8 - EYY - w10*w2)
        w19 = -EY0C + w18
        w20 = w19 + w3
        w21 = EA0C*w17 + EB0C*w20
        w24 = w23*(EA0C*w21 - EB0C*w16 - w1*w22 + w13)
        w25 = w23*(EA0C*w16 + EB0C*w21 + w19 - w22*w3)
        w26 = cos_c*w24 + sin_c*w25
        w27 = -EXC + w26
        w28 = cos_c*w3 - sin_c*w1
        w29 = cos_c*w25 - sin_c*w24
        w30 = -EYC + w29
        w31 = w28 + w30
        w32 = w23*(-EA0C*w20 + EB0C*w17 + w14 - w15*w22)
        w33 = -EZC + w32
        w34 = w15 + w33
        w35 = w27 + w4
        w36 = EAC*w35 + EBC*w31 + ECC*w34
        w37 = (EAC*EAC) + (EBC*EBC) + (ECC*ECC)
        w38 = 1.0/(w37 + 1)
        deviation[0, at] = w38*(EAC*w36 - EBC*w34 + ECC*w31 + w27 - w37*w4)
        deviation[1, at] = w38*(EAC*w34 + EBC*w36 - ECC*w35 - w28*w37 + w30)
        deviation[2, at] = w38*(-EAC*w31 + EBC*w35 + ECC*w36 - w15*w37 + w33)
    return deviation


def bed_in_workpiece_deviation_first_order(positions, errors, parameters, point):
    """Deviation of a bed point in the workpiece frame, to first order in the errors.

    Source: Eqs. (1)-(4). Operations: 57 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB
                ECB EXC EYC EZC EAC EBC ECC
        parameters (26,): home positions and location errors [mm, rad]
            rows: q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C
                eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B
        point (3, n): point in the bed frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): bed point in the workpiece frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions, errors, point = _points(positions=(positions, 5), errors=(errors, 30), point=(point, 3))
    parameters = _constant("parameters", parameters, (26,))
    deviation = np.zeros((3, n))
    # constants
    q_Cx = float(parameters[0])
    q_Cy = float(parameters[1])
    q_Cz = float(parameters[2])
    EX0C = float(parameters[15])
    EY0C = float(parameters[16])
    EA0C = float(parameters[17])
    EB0C = float(parameters[18])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        y = positions[1, at]
        c = positions[4, at]
        EXY = errors[6, at]
        EYY = errors[7, at]
        EZY = errors[8, at]
        EAY = errors[9, at]
        EBY = errors[10, at]
        ECY = errors[11, at]
        EXC = errors[24, at]
        EYC = errors[25, at]
        EZC = errors[26, at]
        EAC = errors[27, at]
        EBC = errors[28, at]
        ECC = errors[29, at]
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # cosines and sines
        cos_c = np.cos(0.017453292519943295*c)
        sin_c = np.sin(0.017453292519943295*c)
        # per point
        w0 = -q_Cz + rz
        w1 = -q_Cx + rx
        w2 = ry - y
        w3 = -q_Cy + w2
        w4 = cos_c*w3 - sin_c*w1
        w5 = -EBY*rz + ECY*w2 - EXY
        w6 = -EB0C*w0 - EX0C + w5
        w7 = EAY*rz - ECY*rx - EYY
        w8 = EA0C*w0 - EY0C + w7
        w9 = cos_c*w6 + sin_c*w8
        deviation[0, at] = -EBC*w0 + ECC*w4 - EXC + w9
        w10 = cos_c*w1 + sin_c*w3
        w11 = cos_c*w8 - sin_c*w6
        deviation[1, at] = EAC*w0 - ECC*w10 - EYC + w11
        w12 = -EAY*w2 + EBY*rx - EZY
        w13 = -EA0C*w3 + EB0C*w1 + w12
        deviation[2, at] = -EAC*w4 + EBC*w10 - EZC + w13
    return deviation


def bed_in_workpiece_sensitivity(positions, parameters, point):
    """Sensitivity of a bed point in the workpiece frame to every error, at the error-free machine.

    Source: Eqs. (1)-(4), first order. Operations: 48 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        parameters (26,): home positions and location errors [mm, rad]
            rows: q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C
                eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B
        point (3, n): point in the bed frame [mm]
            rows: rx ry rz

    Returns:
        sensitivity (3, 41, n): derivative of the deviation by each component error, then by each location error [mm/mm, mm/rad]
            rows: dx_EXX dx_EYX .. dz_EC0B, last index fastest
    """
    n, positions, point = _points(positions=(positions, 5), point=(point, 3))
    parameters = _constant("parameters", parameters, (26,))
    sensitivity = np.zeros((123, n))
    # constants
    q_Cx = float(parameters[0])
    q_Cy = float(parameters[1])
    q_Cz = float(parameters[2])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        y = positions[1, at]
        c = positions[4, at]
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # cosines and sines
        cos_c = np.cos(0.017453292519943295*c)
        sin_c = np.sin(0.017453292519943295*c)
        # per point
        sensitivity[6, at] = dx_EXY = -cos_c
        sensitivity[7, at] = dx_EYY = -sin_c
        sensitivity[9, at] = dx_EAY = rz*sin_c
        sensitivity[50, at] = dy_EAY = cos_c*rz
        sensitivity[10, at] = dx_EBY = -dy_EAY
        sensitivity[28, at] = dx_EBC = q_Cz - rz
        w0 = -cos_c*ry + cos_c*y + rx*sin_c
        sensitivity[109, at] = dz_EAC = cos_c*q_Cy - q_Cx*sin_c + w0
        sensitivity[32, at] = dx_EA0C = -q_Cz*sin_c + rz*sin_c
        sensitivity[33, at] = dx_EB0C = cos_c*q_Cz + dx_EBY
        w1 = cos_c*rx
        w2 = ry*sin_c
        w3 = sin_c*y
        sensitivity[70, at] = dy_ECC = cos_c*q_Cx + q_Cy*sin_c - w1 - w2 + w3
        sensitivity[11, at] = -w0
        sensitivity[24, at] = -1.0
        sensitivity[29, at] = -dz_EAC
        sensitivity[30, at] = dx_EXY
        sensitivity[31, at] = dx_EYY
        sensitivity[47, at] = sin_c
        sensitivity[48, at] = dx_EXY
        sensitivity[51, at] = dx_EAY
        sensitivity[52, at] = -w1 - w2 + w3
        sensitivity[66, at] = -1.0
        sensitivity[68, at] = -dx_EBC
        sensitivity[71, at] = sin_c
        sensitivity[72, at] = dx_EXY
        sensitivity[73, at] = -dx_EB0C
        sensitivity[74, at] = dx_EA0C
        sensitivity[90, at] = -1.0
        sensitivity[91, at] = -ry + y
        sensitivity[92, at] = rx
        sensitivity[108, at] = -1.0
        sensitivity[110, at] = -dy_ECC
        sensitivity[114, at] = q_Cy - ry + y
        sensitivity[115, at] = -q_Cx + rx
    return sensitivity.reshape(3, 41, n)


def tool_in_workpiece_position(positions, errors, parameters, point):
    """Actual position of the tool point in the workpiece frame, exact.

    Source: Eq. (4). Operations: 250 per point, 5 per call.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB
                ECB EXC EYC EZC EAC EBC ECC
        parameters (26,): home positions and location errors [mm, rad]
            rows: q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C
                eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        position (3, n): actual position P_T^W of the tool point in the workpiece frame [mm]
            rows: px py pz
    """
    n, positions, errors, point = _points(positions=(positions, 5), errors=(errors, 30), point=(point, 3))
    parameters = _constant("parameters", parameters, (26,))
    position = np.zeros((3, n))
    # constants
    q_Cx = float(parameters[0])
    q_Cy = float(parameters[1])
    q_Cz = float(parameters[2])
    q_wx = float(parameters[3])
    q_wy = float(parameters[4])
    q_wz = float(parameters[5])
    q_Bx = float(parameters[6])
    q_By = float(parameters[7])
    q_Bz = float(parameters[8])
    q_Sx = float(parameters[9])
    q_Sy = float(parameters[10])
    q_Sz = float(parameters[11])
    q_Tx = float(parameters[12])
    q_Ty = float(parameters[13])
    q_Tz = float(parameters[14])
    EX0C = float(parameters[15])
    EY0C = float(parameters[16])
    EA0C = float(parameters[17])
    EB0C = float(parameters[18])
    eps_xy = float(parameters[19])
    eps_yz = float(parameters[20])
    eps_xz = float(parameters[21])
    EX0B = float(parameters[22])
    EZ0B = float(parameters[23])
    EA0B = float(parameters[24])
    EC0B = float(parameters[25])
    # once per call
    w63 = (EA0C*EA0C) + (EB0C*EB0C)
    w64 = 1.0/(w63 + 1)
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        x = positions[0, at]
        y = positions[1, at]
        z = positions[2, at]
        b = positions[3, at]
        c = positions[4, at]
        EXX = errors[0, at]
        EYX = errors[1, at]
        EZX = errors[2, at]
        EAX = errors[3, at]
        EBX = errors[4, at]
        ECX = errors[5, at]
        EXY = errors[6, at]
        EYY = errors[7, at]
        EZY = errors[8, at]
        EAY = errors[9, at]
        EBY = errors[10, at]
        ECY = errors[11, at]
        EXZ = errors[12, at]
        EYZ = errors[13, at]
        EZZ = errors[14, at]
        EAZ = errors[15, at]
        EBZ = errors[16, at]
        ECZ = errors[17, at]
        EXB = errors[18, at]
        EYB = errors[19, at]
        EZB = errors[20, at]
        EAB = errors[21, at]
        EBB = errors[22, at]
        ECB = errors[23, at]
        EXC = errors[24, at]
        EYC = errors[25, at]
        EZC = errors[26, at]
        EAC = errors[27, at]
        EBC = errors[28, at]
        ECC = errors[29, at]
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # cosines and sines
        cos_b = np.cos(0.017453292519943295*b)
        sin_b = np.sin(0.017453292519943295*b)
        cos_c = np.cos(0.017453292519943295*c)
        sin_c = np.sin(0.017453292519943295*c)
        # per point
        w0 = q_Tx + rx
        w1 = q_Sx + w0
        w2 = q_Tz + rz
        w3 = q_Sz + w2
        w4 = cos_b*w1 + sin_b*w3
        w5 = q_Bx + w4
        w6 = w5 + x
        w7 = -q_Cx + w6
        w8 = q_Ty + ry
        w9 = q_Sy + w8
        w10 = q_By + w9
        w11 = w10 - y
        w12 = -q_Cy + w11
        w13 = cos_c*w7 + sin_c*w12
        w14 = cos_b*w3 - sin_b*w1
        w15 = q_Bz + w14
        w16 = w15 + z
        w17 = -EAB*w3 + ECB*w1 + EYB
        w18 = w17 + w9
        w19 = EBB*w3 - ECB*w9 + EXB
        w20 = EAB*w9 - EBB*w1 + EZB
        w21 = cos_b*w20 - sin_b*w19
        w22 = EA0B*w18 + EZ0B + w21
        w23 = w15 + w22
        w24 = cos_b*w19 + sin_b*w20
        w25 = -EA0B*(w14 + w21) + EC0B*(w24 + w4) + w17
        w26 = w10 + w25
        w27 = -EC0B*w18 + EX0B + w24
        w28 = EBZ*w23 - ECZ*w26 + EXZ + w27
        w29 = w27 + w5
        w30 = -EAZ*w23 + ECZ*w29 + EYZ + w25
        w31 = EAZ*w26 - EBZ*w29 + EZZ + w22
        w32 = -eps_xz*(w28 + w5) + eps_yz*(w10 + w30) + w31
        w33 = w16 + w32
        w34 = w16 + w31
        w35 = -eps_yz*w34 + w30
        w36 = w10 + w35
        w37 = eps_xz*w34 + w28
        w38 = EBX*w33 - ECX*w36 + EXX + w37
        w39 = w37 + w5
        w40 = -EAX*w33 + ECX*w39 + EYX + w35
        w41 = -eps_xy*(w10 + w40) + w38
        w42 = -EXY + w41
        w43 = eps_xy*(w38 + w6) + w40
        w44 = -EYY + w43
        w45 = w11 + w44
        w46 = EAX*w36 - EBX*w39 + EZX + w32
        w47 = -EZY + w46
        w48 = w16 + w47
        w49 = w42 + w6
        w50 = EAY*w49 + EBY*w45 + ECY*w48
        w51 = (EAY*EAY) + (EBY*EBY) + (ECY*ECY)
        w52 = 1.0/(w51 + 1)
        w53 = w52*(EAY*w50 - EBY*w48 + ECY*w45 + w42 - w51*w6)
        w54 = -EX0C + w53
        w55 = w52*(-EAY*w45 + EBY*w49 + ECY*w50 - w16*w51 + w47)
        w56 = -q_Cz + w16
        w57 = w55 + w56
        w58 = w54 + w7
        w59 = w52*(EAY*w48 + EBY*w50 - ECY*w49 - w11*w51 + w44)
        w60 = -EY0C + w59
        w61 = w12 + w60
        w62 = EA0C*w58 + EB0C*w61
        w65 = w64*(EA0C*w62 - EB0C*w57 + w54 - w63*w7)
        w66 = w64*(EA0C*w57 + EB0C*w62 - w12*w63 + w60)
        w67 = cos_c*w65 + sin_c*w66
        w68 = -EXC + w67
        w69 = cos_c*w12 - sin_c*w7
        w70 = cos_c*w66 - sin_c*w65
        w71 = -EYC + w70
        w72 = w69 + w71
        w73 = w64*(-EA0C*w61 + EB0C*w58 + w55 - w56*w63)
        w74 = -EZC + w73
        w75 = w56 + w74
        w76 = w13 + w68
        w77 = EAC*w76 + EBC*w72 + ECC*w75
        w78 = (EAC*EAC) + (EBC*EBC) + (ECC*ECC)
        w79 = 1.0/(w78 + 1)
        w80 = w79*(EAC*w77 - EBC*w75 + ECC*w72 - w13*w78 + w68)
        w81 = -q_wx + w13
        position[0, at] = w80 + w81
        w82 = w79*(EAC*w75 + EBC*w77 - ECC*w76 - w69*w78 + w71)
        w83 = -q_wy + w69
        position[1, at] = w82 + w83
        w84 = w79*(-EAC*w72 + EBC*w76 + ECC*w77 - w56*w78 + w74)
        w85 = -q_wz + w56
        position[2, at] = w84 + w85
    return position


def tool_in_workpiece_position_first_order(positions, errors, parameters, point):
    """Actual position of the tool point in the workpiece frame, to first order.

    Source: Eq. (4). Operations: 157 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB
                ECB EXC EYC EZC EAC EBC ECC
        parameters (26,): home positions and location errors [mm, rad]
            rows: q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C
                eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        position (3, n): actual position P_T^W of the tool point in the workpiece frame [mm]
            rows: px py pz
    """
    n, positions, errors, point = _points(positions=(positions, 5), errors=(errors, 30), point=(point, 3))
    parameters = _constant("parameters", parameters, (26,))
    position = np.zeros((3, n))
    # constants
    q_Cx = float(parameters[0])
    q_Cy = float(parameters[1])
    q_Cz = float(parameters[2])
    q_wx = float(parameters[3])
    q_wy = float(parameters[4])
    q_wz = float(parameters[5])
    q_Bx = float(parameters[6])
    q_By = float(parameters[7])
    q_Bz = float(parameters[8])
    q_Sx = float(parameters[9])
    q_Sy = float(parameters[10])
    q_Sz = float(parameters[11])
    q_Tx = float(parameters[12])
    q_Ty = float(parameters[13])
    q_Tz = float(parameters[14])
    EX0C = float(parameters[15])
    EY0C = float(parameters[16])
    EA0C = float(parameters[17])
    EB0C = float(parameters[18])
    eps_xy = float(parameters[19])
    eps_yz = float(parameters[20])
    eps_xz = float(parameters[21])
    EX0B = float(parameters[22])
    EZ0B = float(parameters[23])
    EA0B = float(parameters[24])
    EC0B = float(parameters[25])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        x = positions[0, at]
        y = positions[1, at]
        z = positions[2, at]
        b = positions[3, at]
        c = positions[4, at]
        EXX = errors[0, at]
        EYX = errors[1, at]
        EZX = errors[2, at]
        EAX = errors[3, at]
        EBX = errors[4, at]
        ECX = errors[5, at]
        EXY = errors[6, at]
        EYY = errors[7, at]
        EZY = errors[8, at]
        EAY = errors[9, at]
        EBY = errors[10, at]
        ECY = errors[11, at]
        EXZ = errors[12, at]
        EYZ = errors[13, at]
        EZZ = errors[14, at]
        EAZ = errors[15, at]
        EBZ = errors[16, at]
        ECZ = errors[17, at]
        EXB = errors[18, at]
        EYB = errors[19, at]
        EZB = errors[20, at]
        EAB = errors[21, at]
        EBB = errors[22, at]
        ECB = errors[23, at]
        EXC = errors[24, at]
        EYC = errors[25, at]
        EZC = errors[26, at]
        EAC = errors[27, at]
        EBC = errors[28, at]
        ECC = errors[29, at]
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # cosines and sines
        cos_b = np.cos(0.017453292519943295*b)
        sin_b = np.sin(0.017453292519943295*b)
        cos_c = np.cos(0.017453292519943295*c)
        sin_c = np.sin(0.017453292519943295*c)
        # per point
        w0 = q_Tx + rx
        w1 = q_Sx + w0
        w2 = q_Tz + rz
        w3 = q_Sz + w2
        w4 = cos_b*w3 - sin_b*w1
        w5 = q_Bz + w4
        w6 = w5 + z
        w7 = -q_Cz + w6
        w8 = cos_b*w1 + sin_b*w3
        w9 = q_Bx + w8
        w10 = w9 + x
        w11 = -q_Cx + w10
        w12 = q_Ty + ry
        w13 = q_Sy + w12
        w14 = q_By + w13
        w15 = w14 - y
        w16 = -q_Cy + w15
        w17 = cos_c*w16 - sin_c*w11
        w18 = EBB*w3 - ECB*w13 + EXB
        w19 = EAB*w13 - EBB*w1 + EZB
        w20 = cos_b*w18 + sin_b*w19
        w21 = -EC0B*w13 + EX0B + w20
        w22 = EBZ*w5 - ECZ*w14 + EXZ + w21
        w23 = eps_xz*w6 + w22
        w24 = EBX*w6 - ECX*w14 + EXX + w23
        w25 = -eps_xy*w14 + w24
        w26 = -EBY*w6 + ECY*w15 - EXY + w25
        w27 = -EB0C*w7 - EX0C + w26
        w28 = -EAB*w3 + ECB*w1 + EYB
        w29 = -EA0B*w4 + EC0B*w8 + w28
        w30 = -EAZ*w5 + ECZ*w9 + EYZ + w29
        w31 = -eps_yz*w6 + w30
        w32 = -EAX*w6 + ECX*w9 + EYX + w31
        w33 = eps_xy*w10 + w32
        w34 = EAY*w6 - ECY*w10 - EYY + w33
        w35 = EA0C*w7 - EY0C + w34
        w36 = cos_c*w27 + sin_c*w35
        w37 = -EBC*w7 + ECC*w17 - EXC + w36
        w38 = cos_c*w11 + sin_c*w16
        w39 = -q_wx + w38
        position[0, at] = w37 + w39
        w40 = cos_c*w35 - sin_c*w27
        w41 = EAC*w7 - ECC*w38 - EYC + w40
        w42 = -q_wy + w17
        position[1, at] = w41 + w42
        w43 = cos_b*w19 - sin_b*w18
        w44 = EA0B*w13 + EZ0B + w43
        w45 = EAZ*w14 - EBZ*w9 + EZZ + w44
        w46 = -eps_xz*w9 + eps_yz*w14 + w45
        w47 = EAX*w14 - EBX*w9 + EZX + w46
        w48 = -EAY*w15 + EBY*w10 - EZY + w47
        w49 = -EA0C*w16 + EB0C*w11 + w48
        w50 = -EAC*w17 + EBC*w38 - EZC + w49
        w51 = -q_wz + w7
        position[2, at] = w50 + w51
    return position


def tool_orientation_ideal(positions, direction):
    """Ideal direction of a vector of the tool frame in the workpiece frame.

    Source: Eqs. (1)-(4) without errors, rotations alone. Operations: 20 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        direction (3, n): unit vector in the tool frame, (0, 0, 1) for the tool axis [1]
            rows: tx ty tz

    Returns:
        ideal (3, n): the vector in the workpiece frame, without errors [1]
            rows: ix iy iz
    """
    n, positions, direction = _points(positions=(positions, 5), direction=(direction, 3))
    ideal = np.zeros((3, n))
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        b = positions[3, at]
        c = positions[4, at]
        tx = direction[0, at]
        ty = direction[1, at]
        tz = direction[2, at]
        # cosines and sines
        cos_b = np.cos(0.017453292519943295*b)
        sin_b = np.sin(0.017453292519943295*b)
        cos_c = np.cos(0.017453292519943295*c)
        sin_c = np.sin(0.017453292519943295*c)
        # per point
        ideal[2, at] = cos_b*tz - sin_b*tx
        w0 = cos_b*tx + sin_b*tz
        ideal[0, at] = cos_c*w0 + sin_c*ty
        ideal[1, at] = cos_c*ty - sin_c*w0
    return ideal


def tool_orientation_deviation(positions, errors, parameters, direction):
    """Deviation of a direction of the tool frame in the workpiece frame, exact.

    Source: Eqs. (1)-(4), rotations alone. Operations: 210 per point, 5 per call.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB
                ECB EXC EYC EZC EAC EBC ECC
        parameters (26,): home positions and location errors [mm, rad]
            rows: q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C
                eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B
        direction (3, n): unit vector in the tool frame, (0, 0, 1) for the tool axis [1]
            rows: tx ty tz

    Returns:
        deviation (3, n): the vector in the workpiece frame, actual minus ideal [1]
            rows: dx dy dz
    """
    n, positions, errors, direction = _points(positions=(positions, 5), errors=(errors, 30), direction=(direction, 3))
    parameters = _constant("parameters", parameters, (26,))
    deviation = np.zeros((3, n))
    # constants
    EA0C = float(parameters[17])
    EB0C = float(parameters[18])
    eps_xy = float(parameters[19])
    eps_yz = float(parameters[20])
    eps_xz = float(parameters[21])
    EA0B = float(parameters[24])
    EC0B = float(parameters[25])
    # once per call
    w43 = (EA0C*EA0C) + (EB0C*EB0C)
    w44 = 1.0/(w43 + 1)
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        b = positions[3, at]
        c = positions[4, at]
        EAX = errors[3, at]
        EBX = errors[4, at]
        ECX = errors[5, at]
        EAY = errors[9, at]
        EBY = errors[10, at]
        ECY = errors[11, at]
        EAZ = errors[15, at]
        EBZ = errors[16, at]
        ECZ = errors[17, at]
        EAB = errors[21, at]
        EBB = errors[22, at]
        ECB = errors[23, at]
        EAC = errors[27, at]
        EBC = errors[28, at]
        ECC = errors[29, at]
        tx = direction[0, at]
        ty = direction[1, at]
        tz = direction[2, at]
        # cosines and sines
        cos_b = np.cos(0.017453292519943295*b)
        sin_b = np.sin(0.017453292519943295*b)
        cos_c = np.cos(0.017453292519943295*c)
        sin_c = np.sin(0.017453292519943295*c)
        # per point
        w0 = cos_b*tx + sin_b*tz
        w1 = cos_c*w0 + sin_c*ty
        w2 = cos_b*tz - sin_b*tx
        w3 = -EAB*tz + ECB*tx
        w4 = ty + w3
        w5 = EBB*tz - ECB*ty
        w6 = EAB*ty - EBB*tx
        w7 = cos_b*w6 - sin_b*w5
        w8 = EA0B*w4 + w7
        w9 = w2 + w8
        w10 = cos_b*w5 + sin_b*w6
        w11 = -EA0B*(w2 + w7) + EC0B*(w0 + w10) + w3
        w12 = ty + w11
        w13 = -EC0B*w4 + w10
        w14 = EBZ*w9 - ECZ*w12 + w13
        w15 = w0 + w13
        w16 = -EAZ*w9 + ECZ*w15 + w11
        w17 = EAZ*w12 - EBZ*w15 + w8
        w18 = -eps_xz*(w0 + w14) + eps_yz*(ty + w16) + w17
        w19 = w18 + w2
        w20 = w17 + w2
        w21 = -eps_yz*w20 + w16
        w22 = ty + w21
        w23 = eps_xz*w20 + w14
        w24 = EBX*w19 - ECX*w22 + w23
        w25 = w0 + w23
        w26 = -EAX*w19 + ECX*w25 + w21
        w27 = -eps_xy*(ty + w26) + w24
        w28 = eps_xy*(w0 + w24) + w26
        w29 = ty + w28
        w30 = EAX*w22 - EBX*w25 + w18
        w31 = w2 + w30
        w32 = w0 + w27
        w33 = EAY*w32 + EBY*w29 + ECY*w31
        w34 = (EAY*EAY) + (EBY*EBY) + (ECY*ECY)
        w35 = 1.0/(w34 + 1)
        w36 = w35*(EAY*w33 - EBY*w31 + ECY*w29 - w0*w34 + w27)
        w37 = w35*(-EAY*w29 + EBY*w32 + ECY*w33 - w2*w34 + w30)
        w38 = w2 + w37
        w39 = w0 + w36
        w40 = w35*(EAY*w31 + EBY*w33 - ECY*w32 - ty*w34 + w28)
        w41 = ty + w40
        w42 = EA0C*w39 + EB0C*w41
        w45 = w44*(EA0C*w42 - EB0C*w38 - w0*w43 + w36)
        w46 = w44*(EA0C*w38 + EB0C*w42 - ty*w43 + w40)
        w47 = cos_c*w45 + sin_c*w46
        w48 = cos_c*ty - sin_c*w0
        w49 = cos_c*w46 - sin_c*w45
        w50 = w48 + w49
        w51 = w44*(-EA0C*w41 + EB0C*w39 - w2*w43 + w37)
        w52 = w2 + w51
        w53 = w1 + w47
        w54 = EAC*w53 + EBC*w50 + ECC*w52
        w55 = (EAC*EAC) + (EBC*EBC) + (ECC*ECC)
        w56 = 1.0/(w55 + 1)
        deviation[0, at] = w56*(EAC*w54 - EBC*w52 + ECC*w50 - w1*w55 + w47)
        deviation[1, at] = w56*(EAC*w52 + EBC*w54 - ECC*w53 - w48*w55 + w49)
        deviation[2, at] = w56*(-EAC*w50 + EBC*w53 + ECC*w54 - w2*w55 + w51)
    return deviation


def tool_orientation_deviation_first_order(positions, errors, parameters, direction):
    """Deviation of a direction of the tool frame in the workpiece frame, to first order.

    Source: Eqs. (1)-(4), rotations alone. Operations: 117 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB
                ECB EXC EYC EZC EAC EBC ECC
        parameters (26,): home positions and location errors [mm, rad]
            rows: q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C
                eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B
        direction (3, n): unit vector in the tool frame, (0, 0, 1) for the tool axis [1]
            rows: tx ty tz

    Returns:
        deviation (3, n): the vector in the workpiece frame, actual minus ideal [1]
            rows: dx dy dz
    """
    n, positions, errors, direction = _points(positions=(positions, 5), errors=(errors, 30), direction=(direction, 3))
    parameters = _constant("parameters", parameters, (26,))
    deviation = np.zeros((3, n))
    # constants
    EA0C = float(parameters[17])
    EB0C = float(parameters[18])
    eps_xy = float(parameters[19])
    eps_yz = float(parameters[20])
    eps_xz = float(parameters[21])
    EA0B = float(parameters[24])
    EC0B = float(parameters[25])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        b = positions[3, at]
        c = positions[4, at]
        EAX = errors[3, at]
        EBX = errors[4, at]
        ECX = errors[5, at]
        EAY = errors[9, at]
        EBY = errors[10, at]
        ECY = errors[11, at]
        EAZ = errors[15, at]
        EBZ = errors[16, at]
        ECZ = errors[17, at]
        EAB = errors[21, at]
        EBB = errors[22, at]
        ECB = errors[23, at]
        EAC = errors[27, at]
        EBC = errors[28, at]
        ECC = errors[29, at]
        tx = direction[0, at]
        ty = direction[1, at]
        tz = direction[2, at]
        # cosines and sines
        cos_b = np.cos(0.017453292519943295*b)
        sin_b = np.sin(0.017453292519943295*b)
        cos_c = np.cos(0.017453292519943295*c)
        sin_c = np.sin(0.017453292519943295*c)
        # per point
        w0 = cos_b*tz - sin_b*tx
        w1 = cos_b*tx + sin_b*tz
        w2 = cos_c*ty - sin_c*w1
        w3 = EBB*tz - ECB*ty
        w4 = EAB*ty - EBB*tx
        w5 = cos_b*w3 + sin_b*w4
        w6 = -EC0B*ty + w5
        w7 = EBZ*w0 - ECZ*ty + w6
        w8 = eps_xz*w0 + w7
        w9 = EBX*w0 - ECX*ty + w8
        w10 = -eps_xy*ty + w9
        w11 = -EBY*w0 + ECY*ty + w10
        w12 = -EB0C*w0 + w11
        w13 = -EAB*tz + ECB*tx
        w14 = -EA0B*w0 + EC0B*w1 + w13
        w15 = -EAZ*w0 + ECZ*w1 + w14
        w16 = -eps_yz*w0 + w15
        w17 = -EAX*w0 + ECX*w1 + w16
        w18 = eps_xy*w1 + w17
        w19 = EAY*w0 - ECY*w1 + w18
        w20 = EA0C*w0 + w19
        w21 = cos_c*w12 + sin_c*w20
        deviation[0, at] = -EBC*w0 + ECC*w2 + w21
        w22 = cos_c*w1 + sin_c*ty
        w23 = cos_c*w20 - sin_c*w12
        deviation[1, at] = EAC*w0 - ECC*w22 + w23
        w24 = cos_b*w4 - sin_b*w3
        w25 = EA0B*ty + w24
        w26 = EAZ*ty - EBZ*w1 + w25
        w27 = -eps_xz*w1 + eps_yz*ty + w26
        w28 = EAX*ty - EBX*w1 + w27
        w29 = -EAY*ty + EBY*w1 + w28
        w30 = -EA0C*ty + EB0C*w1 + w29
        deviation[2, at] = -EAC*w2 + EBC*w22 + w30
    return deviation


def tool_in_workpiece_deviation_curves(positions, curves, parameters, point):
    """Deviation of the tool point under polynomial error curves, exact.

    Source: Eqs. (1)-(4), (44). Operations: 627 per point, 12 per call.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        curves (30, 7): coefficients of the powers 1 to 7 of the axis position, per component error [mm/mm^k, rad/mm^k (deg^k for rotary axes)]
            rows: EXX_1 EXX_2 .. ECC_7, last index fastest
        parameters (26,): home positions and location errors [mm, rad]
            rows: q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C
                eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B
        point (3,): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): tool point in the workpiece frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions = _points(positions=(positions, 5))
    curves = _constant("curves", curves, (30, 7))
    parameters = _constant("parameters", parameters, (26,))
    point = _constant("point", point, (3,))
    deviation = np.zeros((3, n))
    # constants
    EXX_1 = float(curves[0, 0])
    EXX_2 = float(curves[0, 1])
    EXX_3 = float(curves[0, 2])
    EXX_4 = float(curves[0, 3])
    EXX_5 = float(curves[0, 4])
    EXX_6 = float(curves[0, 5])
    EXX_7 = float(curves[0, 6])
    EYX_1 = float(curves[1, 0])
    EYX_2 = float(curves[1, 1])
    EYX_3 = float(curves[1, 2])
    EYX_4 = float(curves[1, 3])
    EYX_5 = float(curves[1, 4])
    EYX_6 = float(curves[1, 5])
    EYX_7 = float(curves[1, 6])
    EZX_1 = float(curves[2, 0])
    EZX_2 = float(curves[2, 1])
    EZX_3 = float(curves[2, 2])
    EZX_4 = float(curves[2, 3])
    EZX_5 = float(curves[2, 4])
    EZX_6 = float(curves[2, 5])
    EZX_7 = float(curves[2, 6])
    EAX_1 = float(curves[3, 0])
    EAX_2 = float(curves[3, 1])
    EAX_3 = float(curves[3, 2])
    EAX_4 = float(curves[3, 3])
    EAX_5 = float(curves[3, 4])
    EAX_6 = float(curves[3, 5])
    EAX_7 = float(curves[3, 6])
    EBX_1 = float(curves[4, 0])
    EBX_2 = float(curves[4, 1])
    EBX_3 = float(curves[4, 2])
    EBX_4 = float(curves[4, 3])
    EBX_5 = float(curves[4, 4])
    EBX_6 = float(curves[4, 5])
    EBX_7 = float(curves[4, 6])
    ECX_1 = float(curves[5, 0])
    ECX_2 = float(curves[5, 1])
    ECX_3 = float(curves[5, 2])
    ECX_4 = float(curves[5, 3])
    ECX_5 = float(curves[5, 4])
    ECX_6 = float(curves[5, 5])
    ECX_7 = float(curves[5, 6])
    EXY_1 = float(curves[6, 0])
    EXY_2 = float(curves[6, 1])
    EXY_3 = float(curves[6, 2])
    EXY_4 = float(curves[6, 3])
    EXY_5 = float(curves[6, 4])
    EXY_6 = float(curves[6, 5])
    EXY_7 = float(curves[6, 6])
    EYY_1 = float(curves[7, 0])
    EYY_2 = float(curves[7, 1])
    EYY_3 = float(curves[7, 2])
    EYY_4 = float(curves[7, 3])
    EYY_5 = float(curves[7, 4])
    EYY_6 = float(curves[7, 5])
    EYY_7 = float(curves[7, 6])
    EZY_1 = float(curves[8, 0])
    EZY_2 = float(curves[8, 1])
    EZY_3 = float(curves[8, 2])
    EZY_4 = float(curves[8, 3])
    EZY_5 = float(curves[8, 4])
    EZY_6 = float(curves[8, 5])
    EZY_7 = float(curves[8, 6])
    EAY_1 = float(curves[9, 0])
    EAY_2 = float(curves[9, 1])
    EAY_3 = float(curves[9, 2])
    EAY_4 = float(curves[9, 3])
    EAY_5 = float(curves[9, 4])
    EAY_6 = float(curves[9, 5])
    EAY_7 = float(curves[9, 6])
    EBY_1 = float(curves[10, 0])
    EBY_2 = float(curves[10, 1])
    EBY_3 = float(curves[10, 2])
    EBY_4 = float(curves[10, 3])
    EBY_5 = float(curves[10, 4])
    EBY_6 = float(curves[10, 5])
    EBY_7 = float(curves[10, 6])
    ECY_1 = float(curves[11, 0])
    ECY_2 = float(curves[11, 1])
    ECY_3 = float(curves[11, 2])
    ECY_4 = float(curves[11, 3])
    ECY_5 = float(curves[11, 4])
    ECY_6 = float(curves[11, 5])
    ECY_7 = float(curves[11, 6])
    EXZ_1 = float(curves[12, 0])
    EXZ_2 = float(curves[12, 1])
    EXZ_3 = float(curves[12, 2])
    EXZ_4 = float(curves[12, 3])
    EXZ_5 = float(curves[12, 4])
    EXZ_6 = float(curves[12, 5])
    EXZ_7 = float(curves[12, 6])
    EYZ_1 = float(curves[13, 0])
    EYZ_2 = float(curves[13, 1])
    EYZ_3 = float(curves[13, 2])
    EYZ_4 = float(curves[13, 3])
    EYZ_5 = float(curves[13, 4])
    EYZ_6 = float(curves[13, 5])
    EYZ_7 = float(curves[13, 6])
    EZZ_1 = float(curves[14, 0])
    EZZ_2 = float(curves[14, 1])
    EZZ_3 = float(curves[14, 2])
    EZZ_4 = float(curves[14, 3])
    EZZ_5 = float(curves[14, 4])
    EZZ_6 = float(curves[14, 5])
    EZZ_7 = float(curves[14, 6])
    EAZ_1 = float(curves[15, 0])
    EAZ_2 = float(curves[15, 1])
    EAZ_3 = float(curves[15, 2])
    EAZ_4 = float(curves[15, 3])
    EAZ_5 = float(curves[15, 4])
    EAZ_6 = float(curves[15, 5])
    EAZ_7 = float(curves[15, 6])
    EBZ_1 = float(curves[16, 0])
    EBZ_2 = float(curves[16, 1])
    EBZ_3 = float(curves[16, 2])
    EBZ_4 = float(curves[16, 3])
    EBZ_5 = float(curves[16, 4])
    EBZ_6 = float(curves[16, 5])
    EBZ_7 = float(curves[16, 6])
    ECZ_1 = float(curves[17, 0])
    ECZ_2 = float(curves[17, 1])
    ECZ_3 = float(curves[17, 2])
    ECZ_4 = float(curves[17, 3])
    ECZ_5 = float(curves[17, 4])
    ECZ_6 = float(curves[17, 5])
    ECZ_7 = float(curves[17, 6])
    EXB_1 = float(curves[18, 0])
    EXB_2 = float(curves[18, 1])
    EXB_3 = float(curves[18, 2])
    EXB_4 = float(curves[18, 3])
    EXB_5 = float(curves[18, 4])
    EXB_6 = float(curves[18, 5])
    EXB_7 = float(curves[18, 6])
    EYB_1 = float(curves[19, 0])
    EYB_2 = float(curves[19, 1])
    EYB_3 = float(curves[19, 2])
    EYB_4 = float(curves[19, 3])
    EYB_5 = float(curves[19, 4])
    EYB_6 = float(curves[19, 5])
    EYB_7 = float(curves[19, 6])
    EZB_1 = float(curves[20, 0])
    EZB_2 = float(curves[20, 1])
    EZB_3 = float(curves[20, 2])
    EZB_4 = float(curves[20, 3])
    EZB_5 = float(curves[20, 4])
    EZB_6 = float(curves[20, 5])
    EZB_7 = float(curves[20, 6])
    EAB_1 = float(curves[21, 0])
    EAB_2 = float(curves[21, 1])
    EAB_3 = float(curves[21, 2])
    EAB_4 = float(curves[21, 3])
    EAB_5 = float(curves[21, 4])
    EAB_6 = float(curves[21, 5])
    EAB_7 = float(curves[21, 6])
    EBB_1 = float(curves[22, 0])
    EBB_2 = float(curves[22, 1])
    EBB_3 = float(curves[22, 2])
    EBB_4 = float(curves[22, 3])
    EBB_5 = float(curves[22, 4])
    EBB_6 = float(curves[22, 5])
    EBB_7 = float(curves[22, 6])
    ECB_1 = float(curves[23, 0])
    ECB_2 = float(curves[23, 1])
    ECB_3 = float(curves[23, 2])
    ECB_4 = float(curves[23, 3])
    ECB_5 = float(curves[23, 4])
    ECB_6 = float(curves[23, 5])
    ECB_7 = float(curves[23, 6])
    EXC_1 = float(curves[24, 0])
    EXC_2 = float(curves[24, 1])
    EXC_3 = float(curves[24, 2])
    EXC_4 = float(curves[24, 3])
    EXC_5 = float(curves[24, 4])
    EXC_6 = float(curves[24, 5])
    EXC_7 = float(curves[24, 6])
    EYC_1 = float(curves[25, 0])
    EYC_2 = float(curves[25, 1])
    EYC_3 = float(curves[25, 2])
    EYC_4 = float(curves[25, 3])
    EYC_5 = float(curves[25, 4])
    EYC_6 = float(curves[25, 5])
    EYC_7 = float(curves[25, 6])
    EZC_1 = float(curves[26, 0])
    EZC_2 = float(curves[26, 1])
    EZC_3 = float(curves[26, 2])
    EZC_4 = float(curves[26, 3])
    EZC_5 = float(curves[26, 4])
    EZC_6 = float(curves[26, 5])
    EZC_7 = float(curves[26, 6])
    EAC_1 = float(curves[27, 0])
    EAC_2 = float(curves[27, 1])
    EAC_3 = float(curves[27, 2])
    EAC_4 = float(curves[27, 3])
    EAC_5 = float(curves[27, 4])
    EAC_6 = float(curves[27, 5])
    EAC_7 = float(curves[27, 6])
    EBC_1 = float(curves[28, 0])
    EBC_2 = float(curves[28, 1])
    EBC_3 = float(curves[28, 2])
    EBC_4 = float(curves[28, 3])
    EBC_5 = float(curves[28, 4])
    EBC_6 = float(curves[28, 5])
    EBC_7 = float(curves[28, 6])
    ECC_1 = float(curves[29, 0])
    ECC_2 = float(curves[29, 1])
    ECC_3 = float(curves[29, 2])
    ECC_4 = float(curves[29, 3])
    ECC_5 = float(curves[29, 4])
    ECC_6 = float(curves[29, 5])
    ECC_7 = float(curves[29, 6])
    q_Cx = float(parameters[0])
    q_Cy = float(parameters[1])
    q_Cz = float(parameters[2])
    q_Bx = float(parameters[6])
    q_By = float(parameters[7])
    q_Bz = float(parameters[8])
    q_Sx = float(parameters[9])
    q_Sy = float(parameters[10])
    q_Sz = float(parameters[11])
    q_Tx = float(parameters[12])
    q_Ty = float(parameters[13])
    q_Tz = float(parameters[14])
    EX0C = float(parameters[15])
    EY0C = float(parameters[16])
    EA0C = float(parameters[17])
    EB0C = float(parameters[18])
    eps_xy = float(parameters[19])
    eps_yz = float(parameters[20])
    eps_xz = float(parameters[21])
    EX0B = float(parameters[22])
    EZ0B = float(parameters[23])
    EA0B = float(parameters[24])
    EC0B = float(parameters[25])
    rx = float(point[0])
    ry = float(point[1])
    rz = float(point[2])
    # once per call
    w3 = q_Tx + rx
    w4 = q_Sx + w3
    w5 = q_Tz + rz
    w6 = q_Sz + w5
    w11 = q_Ty + ry
    w12 = q_Sy + w11
    w13 = q_By + w12
    w91 = (EA0C*EA0C) + (EB0C*EB0C)
    w92 = 1.0/(w91 + 1)
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        x = positions[0, at]
        y = positions[1, at]
        z = positions[2, at]
        b = positions[3, at]
        c = positions[4, at]
        # cosines and sines
        cos_b = np.cos(0.017453292519943295*b)
        sin_b = np.sin(0.017453292519943295*b)
        cos_c = np.cos(0.017453292519943295*c)
        sin_c = np.sin(0.017453292519943295*c)
        # per point
        w0 = _polynomial(c, EAC_1, EAC_2, EAC_3, EAC_4, EAC_5, EAC_6, EAC_7)
        w1 = _polynomial(c, EBC_1, EBC_2, EBC_3, EBC_4, EBC_5, EBC_6, EBC_7)
        w2 = _polynomial(c, ECC_1, ECC_2, ECC_3, ECC_4, ECC_5, ECC_6, ECC_7)
        w7 = cos_b*w4 + sin_b*w6
        w8 = q_Bx + w7
        w9 = w8 + x
        w10 = -q_Cx + w9
        w14 = w13 - y
        w15 = -q_Cy + w14
        w16 = cos_c*w10 + sin_c*w15
        w17 = _polynomial(c, EXC_1, EXC_2, EXC_3, EXC_4, EXC_5, EXC_6, EXC_7)
        w18 = _polynomial(y, EAY_1, EAY_2, EAY_3, EAY_4, EAY_5, EAY_6, EAY_7)
        w19 = _polynomial(y, EBY_1, EBY_2, EBY_3, EBY_4, EBY_5, EBY_6, EBY_7)
        w20 = _polynomial(y, ECY_1, ECY_2, ECY_3, ECY_4, ECY_5, ECY_6, ECY_7)
        w21 = _polynomial(y, EXY_1, EXY_2, EXY_3, EXY_4, EXY_5, EXY_6, EXY_7)
        w22 = cos_b*w6 - sin_b*w4
        w23 = q_Bz + w22
        w24 = w23 + z
        w25 = _polynomial(b, EYB_1, EYB_2, EYB_3, EYB_4, EYB_5, EYB_6, EYB_7)
        w26 = _polynomial(b, EAB_1, EAB_2, EAB_3, EAB_4, EAB_5, EAB_6, EAB_7)
        w27 = _polynomial(b, ECB_1, ECB_2, ECB_3, ECB_4, ECB_5, ECB_6, ECB_7)
        w28 = w25 - w26*w6 + w27*w4
        w29 = w12 + w28
        w30 = _polynomial(b, EXB_1, EXB_2, EXB_3, EXB_4, EXB_5, EXB_6, EXB_7)
        w31 = _polynomial(b, EBB_1, EBB_2, EBB_3, EBB_4, EBB_5, EBB_6, EBB_7)
        w32 = -w12*w27 + w30 + w31*w6
        w33 = _polynomial(b, EZB_1, EZB_2, EZB_3, EZB_4, EZB_5, EZB_6, EZB_7)
        w34 = w12*w26 - w31*w4 + w33
        w35 = cos_b*w34 - sin_b*w32
        w36 = EA0B*w29 + EZ0B + w35
        w37 = w23 + w36
        w38 = cos_b*w32 + sin_b*w34
        w39 = -EA0B*(w22 + w35) + EC0B*(w38 + w7) + w28
        w40 = w13 + w39
        w41 = _polynomial(z, EXZ_1, EXZ_2, EXZ_3, EXZ_4, EXZ_5, EXZ_6, EXZ_7)
        w42 = _polynomial(z, EBZ_1, EBZ_2, EBZ_3, EBZ_4, EBZ_5, EBZ_6, EBZ_7)
        w43 = _polynomial(z, ECZ_1, ECZ_2, ECZ_3, ECZ_4, ECZ_5, ECZ_6, ECZ_7)
        w44 = -EC0B*w29 + EX0B + w38
        w45 = w37*w42 - w40*w43 + w41 + w44
        w46 = w44 + w8
        w47 = _polynomial(z, EYZ_1, EYZ_2, EYZ_3, EYZ_4, EYZ_5, EYZ_6, EYZ_7)
        w48 = _polynomial(z, EAZ_1, EAZ_2, EAZ_3, EAZ_4, EAZ_5, EAZ_6, EAZ_7)
        w49 = -w37*w48 + w39 + w43*w46 + w47
        w50 = _polynomial(z, EZZ_1, EZZ_2, EZZ_3, EZZ_4, EZZ_5, EZZ_6, EZZ_7)
        w51 = w36 + w40*w48 - w42*w46 + w50
        w52 = -eps_xz*(w45 + w8) + eps_yz*(w13 + w49) + w51
        w53 = w24 + w52
        w54 = w24 + w51
        w55 = -eps_yz*w54 + w49
        w56 = w13 + w55
        w57 = _polynomial(x, EXX_1, EXX_2, EXX_3, EXX_4, EXX_5, EXX_6, EXX_7)
        w58 = _polynomial(x, EBX_1, EBX_2, EBX_3, EBX_4, EBX_5, EBX_6, EBX_7)
        w59 = _polynomial(x, ECX_1, ECX_2, ECX_3, ECX_4, ECX_5, ECX_6, ECX_7)
        w60 = eps_xz*w54 + w45
        w61 = w53*w58 - w56*w59 + w57 + w60
        w62 = w60 + w8
        w63 = _polynomial(x, EYX_1, EYX_2, EYX_3, EYX_4, EYX_5, EYX_6, EYX_7)
        w64 = _polynomial(x, EAX_1, EAX_2, EAX_3, EAX_4, EAX_5, EAX_6, EAX_7)
        w65 = -w53*w64 + w55 + w59*w62 + w63
        w66 = -eps_xy*(w13 + w65) + w61
        w67 = -w21 + w66
        w68 = _polynomial(y, EYY_1, EYY_2, EYY_3, EYY_4, EYY_5, EYY_6, EYY_7)
        w69 = eps_xy*(w61 + w9) + w65
        w70 = -w68 + w69
        w71 = w14 + w70
        w72 = _polynomial(y, EZY_1, EZY_2, EZY_3, EZY_4, EZY_5, EZY_6, EZY_7)
        w73 = _polynomial(x, EZX_1, EZX_2, EZX_3, EZX_4, EZX_5, EZX_6, EZX_7)
        w74 = w52 + w56*w64 - w58*w62 + w73
        w75 = -w72 + w74
        w76 = w24 + w75
        w77 = w67 + w9
        w78 = w18*w77 + w19*w71 + w20*w76
        w79 = (w18*w18) + (w19*w19) + (w20*w20)
        w80 = 1.0/(w79 + 1)
        w81 = w80*(w18*w78 - w19*w76 + w20*w71 + w67 - w79*w9)
        w82 = -EX0C + w81
        w83 = w80*(-w18*w71 + w19*w77 + w20*w78 - w24*w79 + w75)
        w84 = -q_Cz + w24
        w85 = w83 + w84
        w86 = w10 + w82
        w87 = w80*(-w14*w79 + w18*w76 + w19*w78 - w20*w77 + w70)
        w88 = -EY0C + w87
        w89 = w15 + w88
        w90 = EA0C*w86 + EB0C*w89
        w93 = w92*(EA0C*w90 - EB0C*w85 - w10*w91 + w82)
        w94 = w92*(EA0C*w85 + EB0C*w90 - w15*w91 + w88)
        w95 = cos_c*w93 + sin_c*w94
        w96 = -w17 + w95
        w97 = cos_c*w15 - sin_c*w10
        w98 = _polynomial(c, EYC_1, EYC_2, EYC_3, EYC_4, EYC_5, EYC_6, EYC_7)
        w99 = cos_c*w94 - sin_c*w93
        w100 = -w98 + w99
        w101 = w100 + w97
        w102 = _polynomial(c, EZC_1, EZC_2, EZC_3, EZC_4, EZC_5, EZC_6, EZC_7)
        w103 = w92*(-EA0C*w89 + EB0C*w86 + w83 - w84*w91)
        w104 = -w102 + w103
        w105 = w104 + w84
        w106 = w16 + w96
        w107 = w0*w106 + w1*w101 + w105*w2
        w108 = (w0*w0) + (w1*w1) + (w2*w2)
        w109 = 1.0/(w108 + 1)
        deviation[0, at] = w109*(w0*w107 - w1*w105 + w101*w2 - w108*w16 + w96)
        deviation[1, at] = w109*(w0*w105 + w1*w107 + w100 - w106*w2 - w108*w97)
        deviation[2, at] = w109*(-w0*w101 + w1*w106 + w104 + w107*w2 - w108*w84)
    return deviation


def tool_in_workpiece_deviation_first_order_curves(positions, curves, parameters, point):
    """Deviation of the tool point under polynomial error curves, to first order.

    Source: Eqs. (1)-(4), (44). Operations: 534 per point, 7 per call.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        curves (30, 7): coefficients of the powers 1 to 7 of the axis position, per component error [mm/mm^k, rad/mm^k (deg^k for rotary axes)]
            rows: EXX_1 EXX_2 .. ECC_7, last index fastest
        parameters (26,): home positions and location errors [mm, rad]
            rows: q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C
                eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B
        point (3,): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): tool point in the workpiece frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions = _points(positions=(positions, 5))
    curves = _constant("curves", curves, (30, 7))
    parameters = _constant("parameters", parameters, (26,))
    point = _constant("point", point, (3,))
    deviation = np.zeros((3, n))
    # constants
    EXX_1 = float(curves[0, 0])
    EXX_2 = float(curves[0, 1])
    EXX_3 = float(curves[0, 2])
    EXX_4 = float(curves[0, 3])
    EXX_5 = float(curves[0, 4])
    EXX_6 = float(curves[0, 5])
    EXX_7 = float(curves[0, 6])
    EYX_1 = float(curves[1, 0])
    EYX_2 = float(curves[1, 1])
    EYX_3 = float(curves[1, 2])
    EYX_4 = float(curves[1, 3])
    EYX_5 = float(curves[1, 4])
    EYX_6 = float(curves[1, 5])
    EYX_7 = float(curves[1, 6])
    EZX_1 = float(curves[2, 0])
    EZX_2 = float(curves[2, 1])
    EZX_3 = float(curves[2, 2])
    EZX_4 = float(curves[2, 3])
    EZX_5 = float(curves[2, 4])
    EZX_6 = float(curves[2, 5])
    EZX_7 = float(curves[2, 6])
    EAX_1 = float(curves[3, 0])
    EAX_2 = float(curves[3, 1])
    EAX_3 = float(curves[3, 2])
    EAX_4 = float(curves[3, 3])
    EAX_5 = float(curves[3, 4])
    EAX_6 = float(curves[3, 5])
    EAX_7 = float(curves[3, 6])
    EBX_1 = float(curves[4, 0])
    EBX_2 = float(curves[4, 1])
    EBX_3 = float(curves[4, 2])
    EBX_4 = float(curves[4, 3])
    EBX_5 = float(curves[4, 4])
    EBX_6 = float(curves[4, 5])
    EBX_7 = float(curves[4, 6])
    ECX_1 = float(curves[5, 0])
    ECX_2 = float(curves[5, 1])
    ECX_3 = float(curves[5, 2])
    ECX_4 = float(curves[5, 3])
    ECX_5 = float(curves[5, 4])
    ECX_6 = float(curves[5, 5])
    ECX_7 = float(curves[5, 6])
    EXY_1 = float(curves[6, 0])
    EXY_2 = float(curves[6, 1])
    EXY_3 = float(curves[6, 2])
    EXY_4 = float(curves[6, 3])
    EXY_5 = float(curves[6, 4])
    EXY_6 = float(curves[6, 5])
    EXY_7 = float(curves[6, 6])
    EYY_1 = float(curves[7, 0])
    EYY_2 = float(curves[7, 1])
    EYY_3 = float(curves[7, 2])
    EYY_4 = float(curves[7, 3])
    EYY_5 = float(curves[7, 4])
    EYY_6 = float(curves[7, 5])
    EYY_7 = float(curves[7, 6])
    EZY_1 = float(curves[8, 0])
    EZY_2 = float(curves[8, 1])
    EZY_3 = float(curves[8, 2])
    EZY_4 = float(curves[8, 3])
    EZY_5 = float(curves[8, 4])
    EZY_6 = float(curves[8, 5])
    EZY_7 = float(curves[8, 6])
    EAY_1 = float(curves[9, 0])
    EAY_2 = float(curves[9, 1])
    EAY_3 = float(curves[9, 2])
    EAY_4 = float(curves[9, 3])
    EAY_5 = float(curves[9, 4])
    EAY_6 = float(curves[9, 5])
    EAY_7 = float(curves[9, 6])
    EBY_1 = float(curves[10, 0])
    EBY_2 = float(curves[10, 1])
    EBY_3 = float(curves[10, 2])
    EBY_4 = float(curves[10, 3])
    EBY_5 = float(curves[10, 4])
    EBY_6 = float(curves[10, 5])
    EBY_7 = float(curves[10, 6])
    ECY_1 = float(curves[11, 0])
    ECY_2 = float(curves[11, 1])
    ECY_3 = float(curves[11, 2])
    ECY_4 = float(curves[11, 3])
    ECY_5 = float(curves[11, 4])
    ECY_6 = float(curves[11, 5])
    ECY_7 = float(curves[11, 6])
    EXZ_1 = float(curves[12, 0])
    EXZ_2 = float(curves[12, 1])
    EXZ_3 = float(curves[12, 2])
    EXZ_4 = float(curves[12, 3])
    EXZ_5 = float(curves[12, 4])
    EXZ_6 = float(curves[12, 5])
    EXZ_7 = float(curves[12, 6])
    EYZ_1 = float(curves[13, 0])
    EYZ_2 = float(curves[13, 1])
    EYZ_3 = float(curves[13, 2])
    EYZ_4 = float(curves[13, 3])
    EYZ_5 = float(curves[13, 4])
    EYZ_6 = float(curves[13, 5])
    EYZ_7 = float(curves[13, 6])
    EZZ_1 = float(curves[14, 0])
    EZZ_2 = float(curves[14, 1])
    EZZ_3 = float(curves[14, 2])
    EZZ_4 = float(curves[14, 3])
    EZZ_5 = float(curves[14, 4])
    EZZ_6 = float(curves[14, 5])
    EZZ_7 = float(curves[14, 6])
    EAZ_1 = float(curves[15, 0])
    EAZ_2 = float(curves[15, 1])
    EAZ_3 = float(curves[15, 2])
    EAZ_4 = float(curves[15, 3])
    EAZ_5 = float(curves[15, 4])
    EAZ_6 = float(curves[15, 5])
    EAZ_7 = float(curves[15, 6])
    EBZ_1 = float(curves[16, 0])
    EBZ_2 = float(curves[16, 1])
    EBZ_3 = float(curves[16, 2])
    EBZ_4 = float(curves[16, 3])
    EBZ_5 = float(curves[16, 4])
    EBZ_6 = float(curves[16, 5])
    EBZ_7 = float(curves[16, 6])
    ECZ_1 = float(curves[17, 0])
    ECZ_2 = float(curves[17, 1])
    ECZ_3 = float(curves[17, 2])
    ECZ_4 = float(curves[17, 3])
    ECZ_5 = float(curves[17, 4])
    ECZ_6 = float(curves[17, 5])
    ECZ_7 = float(curves[17, 6])
    EXB_1 = float(curves[18, 0])
    EXB_2 = float(curves[18, 1])
    EXB_3 = float(curves[18, 2])
    EXB_4 = float(curves[18, 3])
    EXB_5 = float(curves[18, 4])
    EXB_6 = float(curves[18, 5])
    EXB_7 = float(curves[18, 6])
    EYB_1 = float(curves[19, 0])
    EYB_2 = float(curves[19, 1])
    EYB_3 = float(curves[19, 2])
    EYB_4 = float(curves[19, 3])
    EYB_5 = float(curves[19, 4])
    EYB_6 = float(curves[19, 5])
    EYB_7 = float(curves[19, 6])
    EZB_1 = float(curves[20, 0])
    EZB_2 = float(curves[20, 1])
    EZB_3 = float(curves[20, 2])
    EZB_4 = float(curves[20, 3])
    EZB_5 = float(curves[20, 4])
    EZB_6 = float(curves[20, 5])
    EZB_7 = float(curves[20, 6])
    EAB_1 = float(curves[21, 0])
    EAB_2 = float(curves[21, 1])
    EAB_3 = float(curves[21, 2])
    EAB_4 = float(curves[21, 3])
    EAB_5 = float(curves[21, 4])
    EAB_6 = float(curves[21, 5])
    EAB_7 = float(curves[21, 6])
    EBB_1 = float(curves[22, 0])
    EBB_2 = float(curves[22, 1])
    EBB_3 = float(curves[22, 2])
    EBB_4 = float(curves[22, 3])
    EBB_5 = float(curves[22, 4])
    EBB_6 = float(curves[22, 5])
    EBB_7 = float(curves[22, 6])
    ECB_1 = float(curves[23, 0])
    ECB_2 = float(curves[23, 1])
    ECB_3 = float(curves[23, 2])
    ECB_4 = float(curves[23, 3])
    ECB_5 = float(curves[23, 4])
    ECB_6 = float(curves[23, 5])
    ECB_7 = float(curves[23, 6])
    EXC_1 = float(curves[24, 0])
    EXC_2 = float(curves[24, 1])
    EXC_3 = float(curves[24, 2])
    EXC_4 = float(curves[24, 3])
    EXC_5 = float(curves[24, 4])
    EXC_6 = float(curves[24, 5])
    EXC_7 = float(curves[24, 6])
    EYC_1 = float(curves[25, 0])
    EYC_2 = float(curves[25, 1])
    EYC_3 = float(curves[25, 2])
    EYC_4 = float(curves[25, 3])
    EYC_5 = float(curves[25, 4])
    EYC_6 = float(curves[25, 5])
    EYC_7 = float(curves[25, 6])
    EZC_1 = float(curves[26, 0])
    EZC_2 = float(curves[26, 1])
    EZC_3 = float(curves[26, 2])
    EZC_4 = float(curves[26, 3])
    EZC_5 = float(curves[26, 4])
    EZC_6 = float(curves[26, 5])
    EZC_7 = float(curves[26, 6])
    EAC_1 = float(curves[27, 0])
    EAC_2 = float(curves[27, 1])
    EAC_3 = float(curves[27, 2])
    EAC_4 = float(curves[27, 3])
    EAC_5 = float(curves[27, 4])
    EAC_6 = float(curves[27, 5])
    EAC_7 = float(curves[27, 6])
    EBC_1 = float(curves[28, 0])
    EBC_2 = float(curves[28, 1])
    EBC_3 = float(curves[28, 2])
    EBC_4 = float(curves[28, 3])
    EBC_5 = float(curves[28, 4])
    EBC_6 = float(curves[28, 5])
    EBC_7 = float(curves[28, 6])
    ECC_1 = float(curves[29, 0])
    ECC_2 = float(curves[29, 1])
    ECC_3 = float(curves[29, 2])
    ECC_4 = float(curves[29, 3])
    ECC_5 = float(curves[29, 4])
    ECC_6 = float(curves[29, 5])
    ECC_7 = float(curves[29, 6])
    q_Cx = float(parameters[0])
    q_Cy = float(parameters[1])
    q_Cz = float(parameters[2])
    q_Bx = float(parameters[6])
    q_By = float(parameters[7])
    q_Bz = float(parameters[8])
    q_Sx = float(parameters[9])
    q_Sy = float(parameters[10])
    q_Sz = float(parameters[11])
    q_Tx = float(parameters[12])
    q_Ty = float(parameters[13])
    q_Tz = float(parameters[14])
    EX0C = float(parameters[15])
    EY0C = float(parameters[16])
    EA0C = float(parameters[17])
    EB0C = float(parameters[18])
    eps_xy = float(parameters[19])
    eps_yz = float(parameters[20])
    eps_xz = float(parameters[21])
    EX0B = float(parameters[22])
    EZ0B = float(parameters[23])
    EA0B = float(parameters[24])
    EC0B = float(parameters[25])
    rx = float(point[0])
    ry = float(point[1])
    rz = float(point[2])
    # once per call
    w3 = q_Tx + rx
    w4 = q_Sx + w3
    w5 = q_Tz + rz
    w6 = q_Sz + w5
    w15 = q_Ty + ry
    w16 = q_Sy + w15
    w17 = q_By + w16
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        x = positions[0, at]
        y = positions[1, at]
        z = positions[2, at]
        b = positions[3, at]
        c = positions[4, at]
        # cosines and sines
        cos_b = np.cos(0.017453292519943295*b)
        sin_b = np.sin(0.017453292519943295*b)
        cos_c = np.cos(0.017453292519943295*c)
        sin_c = np.sin(0.017453292519943295*c)
        # per point
        w0 = _polynomial(c, EXC_1, EXC_2, EXC_3, EXC_4, EXC_5, EXC_6, EXC_7)
        w1 = _polynomial(c, EBC_1, EBC_2, EBC_3, EBC_4, EBC_5, EBC_6, EBC_7)
        w2 = _polynomial(c, ECC_1, ECC_2, ECC_3, ECC_4, ECC_5, ECC_6, ECC_7)
        w7 = cos_b*w6 - sin_b*w4
        w8 = q_Bz + w7
        w9 = w8 + z
        w10 = -q_Cz + w9
        w11 = cos_b*w4 + sin_b*w6
        w12 = q_Bx + w11
        w13 = w12 + x
        w14 = -q_Cx + w13
        w18 = w17 - y
        w19 = -q_Cy + w18
        w20 = cos_c*w19 - sin_c*w14
        w21 = _polynomial(y, EXY_1, EXY_2, EXY_3, EXY_4, EXY_5, EXY_6, EXY_7)
        w22 = _polynomial(y, EBY_1, EBY_2, EBY_3, EBY_4, EBY_5, EBY_6, EBY_7)
        w23 = _polynomial(y, ECY_1, ECY_2, ECY_3, ECY_4, ECY_5, ECY_6, ECY_7)
        w24 = _polynomial(x, EXX_1, EXX_2, EXX_3, EXX_4, EXX_5, EXX_6, EXX_7)
        w25 = _polynomial(x, EBX_1, EBX_2, EBX_3, EBX_4, EBX_5, EBX_6, EBX_7)
        w26 = _polynomial(x, ECX_1, ECX_2, ECX_3, ECX_4, ECX_5, ECX_6, ECX_7)
        w27 = _polynomial(z, EXZ_1, EXZ_2, EXZ_3, EXZ_4, EXZ_5, EXZ_6, EXZ_7)
        w28 = _polynomial(z, EBZ_1, EBZ_2, EBZ_3, EBZ_4, EBZ_5, EBZ_6, EBZ_7)
        w29 = _polynomial(z, ECZ_1, ECZ_2, ECZ_3, ECZ_4, ECZ_5, ECZ_6, ECZ_7)
        w30 = _polynomial(b, EXB_1, EXB_2, EXB_3, EXB_4, EXB_5, EXB_6, EXB_7)
        w31 = _polynomial(b, EBB_1, EBB_2, EBB_3, EBB_4, EBB_5, EBB_6, EBB_7)
        w32 = _polynomial(b, ECB_1, ECB_2, ECB_3, ECB_4, ECB_5, ECB_6, ECB_7)
        w33 = -w16*w32 + w30 + w31*w6
        w34 = _polynomial(b, EZB_1, EZB_2, EZB_3, EZB_4, EZB_5, EZB_6, EZB_7)
        w35 = _polynomial(b, EAB_1, EAB_2, EAB_3, EAB_4, EAB_5, EAB_6, EAB_7)
        w36 = w16*w35 - w31*w4 + w34
        w37 = cos_b*w33 + sin_b*w36
        w38 = -EC0B*w16 + EX0B + w37
        w39 = -w17*w29 + w27 + w28*w8 + w38
        w40 = eps_xz*w9 + w39
        w41 = -w17*w26 + w24 + w25*w9 + w40
        w42 = -eps_xy*w17 + w41
        w43 = w18*w23 - w21 - w22*w9 + w42
        w44 = -EB0C*w10 - EX0C + w43
        w45 = _polynomial(y, EYY_1, EYY_2, EYY_3, EYY_4, EYY_5, EYY_6, EYY_7)
        w46 = _polynomial(y, EAY_1, EAY_2, EAY_3, EAY_4, EAY_5, EAY_6, EAY_7)
        w47 = _polynomial(x, EYX_1, EYX_2, EYX_3, EYX_4, EYX_5, EYX_6, EYX_7)
        w48 = _polynomial(x, EAX_1, EAX_2, EAX_3, EAX_4, EAX_5, EAX_6, EAX_7)
        w49 = _polynomial(z, EYZ_1, EYZ_2, EYZ_3, EYZ_4, EYZ_5, EYZ_6, EYZ_7)
        w50 = _polynomial(z, EAZ_1, EAZ_2, EAZ_3, EAZ_4, EAZ_5, EAZ_6, EAZ_7)
        w51 = _polynomial(b, EYB_1, EYB_2, EYB_3, EYB_4, EYB_5, EYB_6, EYB_7)
        w52 = w32*w4 - w35*w6 + w51
        w53 = -EA0B*w7 + EC0B*w11 + w52
        w54 = w12*w29 + w49 - w50*w8 + w53
        w55 = -eps_yz*w9 + w54
        w56 = w12*w26 + w47 - w48*w9 + w55
        w57 = eps_xy*w13 + w56
        w58 = -w13*w23 - w45 + w46*w9 + w57
        w59 = EA0C*w10 - EY0C + w58
        w60 = cos_c*w44 + sin_c*w59
        deviation[0, at] = -w0 - w1*w10 + w2*w20 + w60
        w61 = _polynomial(c, EYC_1, EYC_2, EYC_3, EYC_4, EYC_5, EYC_6, EYC_7)
        w62 = _polynomial(c, EAC_1, EAC_2, EAC_3, EAC_4, EAC_5, EAC_6, EAC_7)
        w63 = cos_c*w14 + sin_c*w19
        w64 = cos_c*w59 - sin_c*w44
        deviation[1, at] = w10*w62 - w2*w63 - w61 + w64
        w65 = _polynomial(c, EZC_1, EZC_2, EZC_3, EZC_4, EZC_5, EZC_6, EZC_7)
        w66 = _polynomial(y, EZY_1, EZY_2, EZY_3, EZY_4, EZY_5, EZY_6, EZY_7)
        w67 = _polynomial(x, EZX_1, EZX_2, EZX_3, EZX_4, EZX_5, EZX_6, EZX_7)
        w68 = _polynomial(z, EZZ_1, EZZ_2, EZZ_3, EZZ_4, EZZ_5, EZZ_6, EZZ_7)
        w69 = cos_b*w36 - sin_b*w33
        w70 = EA0B*w16 + EZ0B + w69
        w71 = -w12*w28 + w17*w50 + w68 + w70
        w72 = -eps_xz*w12 + eps_yz*w17 + w71
        w73 = -w12*w25 + w17*w48 + w67 + w72
        w74 = w13*w22 - w18*w46 - w66 + w73
        w75 = -EA0C*w19 + EB0C*w14 + w74
        deviation[2, at] = w1*w63 - w20*w62 - w65 + w75
    return deviation


def ballbar_error(positions, errors, parameters, point, ball, length):
    """Positioning error of a ball bar between a tool ball and a workpiece ball, exact.

    Source: Eqs. (5), (6). Operations: 283 per point, 5 per call.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB
                ECB EXC EYC EZC EAC EBC ECC
        parameters (26,): home positions and location errors [mm, rad]
            rows: q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C
                eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz
        ball (3, n): point in the workpiece frame [mm]
            rows: bx by bz
        length (1, n): ideal length of the ball bar [mm]
            rows: length

    Returns:
        error (4, n): positioning error E, then its components E_x, E_y, E_z [mm]
            rows: e ex ey ez
    """
    n, positions, errors, point, ball, length = _points(positions=(positions, 5), errors=(errors, 30), point=(point, 3), ball=(ball, 3), length=(length, 1))
    parameters = _constant("parameters", parameters, (26,))
    error = np.zeros((4, n))
    # constants
    q_Cx = float(parameters[0])
    q_Cy = float(parameters[1])
    q_Cz = float(parameters[2])
    q_wx = float(parameters[3])
    q_wy = float(parameters[4])
    q_wz = float(parameters[5])
    q_Bx = float(parameters[6])
    q_By = float(parameters[7])
    q_Bz = float(parameters[8])
    q_Sx = float(parameters[9])
    q_Sy = float(parameters[10])
    q_Sz = float(parameters[11])
    q_Tx = float(parameters[12])
    q_Ty = float(parameters[13])
    q_Tz = float(parameters[14])
    EX0C = float(parameters[15])
    EY0C = float(parameters[16])
    EA0C = float(parameters[17])
    EB0C = float(parameters[18])
    eps_xy = float(parameters[19])
    eps_yz = float(parameters[20])
    eps_xz = float(parameters[21])
    EX0B = float(parameters[22])
    EZ0B = float(parameters[23])
    EA0B = float(parameters[24])
    EC0B = float(parameters[25])
    # once per call
    w63 = (EA0C*EA0C) + (EB0C*EB0C)
    w64 = 1.0/(w63 + 1)
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        x = positions[0, at]
        y = positions[1, at]
        z = positions[2, at]
        b = positions[3, at]
        c = positions[4, at]
        EXX = errors[0, at]
        EYX = errors[1, at]
        EZX = errors[2, at]
        EAX = errors[3, at]
        EBX = errors[4, at]
        ECX = errors[5, at]
        EXY = errors[6, at]
        EYY = errors[7, at]
        EZY = errors[8, at]
        EAY = errors[9, at]
        EBY = errors[10, at]
        ECY = errors[11, at]
        EXZ = errors[12, at]
        EYZ = errors[13, at]
        EZZ = errors[14, at]
        EAZ = errors[15, at]
        EBZ = errors[16, at]
        ECZ = errors[17, at]
        EXB = errors[18, at]
        EYB = errors[19, at]
        EZB = errors[20, at]
        EAB = errors[21, at]
        EBB = errors[22, at]
        ECB = errors[23, at]
        EXC = errors[24, at]
        EYC = errors[25, at]
        EZC = errors[26, at]
        EAC = errors[27, at]
        EBC = errors[28, at]
        ECC = errors[29, at]
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        bx = ball[0, at]
        by = ball[1, at]
        bz = ball[2, at]
        length_ = length[0, at]
        # cosines and sines
        cos_b = np.cos(0.017453292519943295*b)
        sin_b = np.sin(0.017453292519943295*b)
        cos_c = np.cos(0.017453292519943295*c)
        sin_c = np.sin(0.017453292519943295*c)
        # per point
        w0 = q_Tx + rx
        w1 = q_Sx + w0
        w2 = q_Tz + rz
        w3 = q_Sz + w2
        w4 = cos_b*w1 + sin_b*w3
        w5 = q_Bx + w4
        w6 = w5 + x
        w7 = -q_Cx + w6
        w8 = q_Ty + ry
        w9 = q_Sy + w8
        w10 = q_By + w9
        w11 = w10 - y
        w12 = -q_Cy + w11
        w13 = cos_c*w7 + sin_c*w12
        w14 = cos_b*w3 - sin_b*w1
        w15 = q_Bz + w14
        w16 = w15 + z
        w17 = -EAB*w3 + ECB*w1 + EYB
        w18 = w17 + w9
        w19 = EBB*w3 - ECB*w9 + EXB
        w20 = EAB*w9 - EBB*w1 + EZB
        w21 = cos_b*w20 - sin_b*w19
        w22 = EA0B*w18 + EZ0B + w21
        w23 = w15 + w22
        w24 = cos_b*w19 + sin_b*w20
        w25 = -EA0B*(w14 + w21) + EC0B*(w24 + w4) + w17
        w26 = w10 + w25
        w27 = -EC0B*w18 + EX0B + w24
        w28 = EBZ*w23 - ECZ*w26 + EXZ + w27
        w29 = w27 + w5
        w30 = -EAZ*w23 + ECZ*w29 + EYZ + w25
        w31 = EAZ*w26 - EBZ*w29 + EZZ + w22
        w32 = -eps_xz*(w28 + w5) + eps_yz*(w10 + w30) + w31
        w33 = w16 + w32
        w34 = w16 + w31
        w35 = -eps_yz*w34 + w30
        w36 = w10 + w35
        w37 = eps_xz*w34 + w28
        w38 = EBX*w33 - ECX*w36 + EXX + w37
        w39 = w37 + w5
        w40 = -EAX*w33 + ECX*w39 + EYX + w35
        w41 = -eps_xy*(w10 + w40) + w38
        w42 = -EXY + w41
        w43 = eps_xy*(w38 + w6) + w40
        w44 = -EYY + w43
        w45 = w11 + w44
        w46 = EAX*w36 - EBX*w39 + EZX + w32
        w47 = -EZY + w46
        w48 = w16 + w47
        w49 = w42 + w6
        w50 = EAY*w49 + EBY*w45 + ECY*w48
        w51 = (EAY*EAY) + (EBY*EBY) + (ECY*ECY)
        w52 = 1.0/(w51 + 1)
        w53 = w52*(EAY*w50 - EBY*w48 + ECY*w45 + w42 - w51*w6)
        w54 = -EX0C + w53
        w55 = w52*(-EAY*w45 + EBY*w49 + ECY*w50 - w16*w51 + w47)
        w56 = -q_Cz + w16
        w57 = w55 + w56
        w58 = w54 + w7
        w59 = w52*(EAY*w48 + EBY*w50 - ECY*w49 - w11*w51 + w44)
        w60 = -EY0C + w59
        w61 = w12 + w60
        w62 = EA0C*w58 + EB0C*w61
        w65 = w64*(EA0C*w62 - EB0C*w57 + w54 - w63*w7)
        w66 = w64*(EA0C*w57 + EB0C*w62 - w12*w63 + w60)
        w67 = cos_c*w65 + sin_c*w66
        w68 = -EXC + w67
        w69 = cos_c*w12 - sin_c*w7
        w70 = cos_c*w66 - sin_c*w65
        w71 = -EYC + w70
        w72 = w69 + w71
        w73 = w64*(-EA0C*w61 + EB0C*w58 + w55 - w56*w63)
        w74 = -EZC + w73
        w75 = w56 + w74
        w76 = w13 + w68
        w77 = EAC*w76 + EBC*w72 + ECC*w75
        w78 = (EAC*EAC) + (EBC*EBC) + (ECC*ECC)
        w79 = 1.0/(w78 + 1)
        w80 = w79*(EAC*w77 - EBC*w75 + ECC*w72 - w13*w78 + w68)
        w81 = w79*(EAC*w75 + EBC*w77 - ECC*w76 - w69*w78 + w71)
        w82 = w79*(-EAC*w72 + EBC*w76 + ECC*w77 - w56*w78 + w74)
        w83 = -q_wx + w13
        w84 = -bx + w83
        w85 = -q_wy + w69
        w86 = -by + w85
        w87 = -q_wz + w56
        w88 = -bz + w87
        w89 = w80 + w84
        w90 = w81 + w86
        w91 = w82 + w88
        w92 = np.sqrt((w84*w84) + (w86*w86) + (w88*w88))
        w93 = np.sqrt((w89*w89) + (w90*w90) + (w91*w91))
        error[0, at] = e = -length_ + w92 + (w80*(w84 + w89) + w81*(w86 + w90) + w82*(w88 + w91))/(w92 + w93)
        w94 = e/w93
        error[1, at] = w89*w94
        error[2, at] = w90*w94
        error[3, at] = w91*w94
    return error


def correction(positions, deviation):
    """Moves of the linear axes that displace the ideal tool point by the given vector.

    Source: Eqs. (53)-(55), inverse. Operations: 11 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        deviation (3, n): displacement of the tool point in the workpiece frame [mm]
            rows: dx dy dz

    Returns:
        moves (3, n): moves of X Y Z [mm]
            rows: move_x move_y move_z
    """
    n, positions, deviation = _points(positions=(positions, 5), deviation=(deviation, 3))
    moves = np.zeros((3, n))
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        c = positions[4, at]
        dx = deviation[0, at]
        dy = deviation[1, at]
        dz = deviation[2, at]
        # cosines and sines
        cos_c = np.cos(0.017453292519943295*c)
        sin_c = np.sin(0.017453292519943295*c)
        # per point
        moves[0, at] = cos_c*dx - dy*sin_c
        moves[1, at] = -cos_c*dy - dx*sin_c
        moves[2, at] = dz
    return moves


def motion_X(positions, errors, parameters, tool_point):
    """Motion equation of X: displacement of the tool point since home, to first order.

    Source: Eqs. (7)-(11). Operations: 24 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB
                ECB EXC EYC EZC EAC EBC ECC
        parameters (26,): home positions and location errors [mm, rad]
            rows: q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C
                eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B
        tool_point (3, n): point in the tool frame [mm]
            rows: rTx rTy rTz

    Returns:
        displacement (3, n): tool point, displacement since home, in the bed frame [mm]
            rows: dx dy dz
    """
    n, positions, errors, tool_point = _points(positions=(positions, 5), errors=(errors, 30), tool_point=(tool_point, 3))
    parameters = _constant("parameters", parameters, (26,))
    displacement = np.zeros((3, n))
    # constants
    q_Bx = float(parameters[6])
    q_By = float(parameters[7])
    q_Bz = float(parameters[8])
    q_Sx = float(parameters[9])
    q_Sy = float(parameters[10])
    q_Sz = float(parameters[11])
    q_Tx = float(parameters[12])
    q_Ty = float(parameters[13])
    q_Tz = float(parameters[14])
    eps_xy = float(parameters[19])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        x = positions[0, at]
        EXX = errors[0, at]
        EYX = errors[1, at]
        EZX = errors[2, at]
        EAX = errors[3, at]
        EBX = errors[4, at]
        ECX = errors[5, at]
        rTx = tool_point[0, at]
        rTy = tool_point[1, at]
        rTz = tool_point[2, at]
        # per point
        w0 = q_Bz + q_Sz + q_Tz + rTz
        w1 = q_By + q_Sy + q_Ty + rTy
        displacement[0, at] = EBX*w0 - ECX*w1 + EXX + x
        w2 = q_Bx + q_Sx + q_Tx + rTx
        displacement[1, at] = -EAX*w0 + ECX*w2 + EYX + eps_xy*x
        displacement[2, at] = EAX*w1 - EBX*w2 + EZX
    return displacement


def motion_Y(positions, errors, parameters, workpiece_point):
    """Motion equation of Y: displacement of the workpiece point since home, to first order.

    Source: Eqs. (7)-(11). Operations: 19 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB
                ECB EXC EYC EZC EAC EBC ECC
        parameters (26,): home positions and location errors [mm, rad]
            rows: q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C
                eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B
        workpiece_point (3, n): point in the workpiece frame [mm]
            rows: rWx rWy rWz

    Returns:
        displacement (3, n): workpiece point, displacement since home, in the bed frame [mm]
            rows: dx dy dz
    """
    n, positions, errors, workpiece_point = _points(positions=(positions, 5), errors=(errors, 30), workpiece_point=(workpiece_point, 3))
    parameters = _constant("parameters", parameters, (26,))
    displacement = np.zeros((3, n))
    # constants
    q_Cx = float(parameters[0])
    q_Cy = float(parameters[1])
    q_Cz = float(parameters[2])
    q_wx = float(parameters[3])
    q_wy = float(parameters[4])
    q_wz = float(parameters[5])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        y = positions[1, at]
        EXY = errors[6, at]
        EYY = errors[7, at]
        EZY = errors[8, at]
        EAY = errors[9, at]
        EBY = errors[10, at]
        ECY = errors[11, at]
        rWx = workpiece_point[0, at]
        rWy = workpiece_point[1, at]
        rWz = workpiece_point[2, at]
        # per point
        w0 = q_Cz + q_wz + rWz
        w1 = q_Cy + q_wy + rWy
        displacement[0, at] = EBY*w0 - ECY*w1 + EXY
        w2 = q_Cx + q_wx + rWx
        displacement[1, at] = -EAY*w0 + ECY*w2 + EYY + y
        displacement[2, at] = EAY*w1 - EBY*w2 + EZY
    return displacement


def motion_Z(positions, errors, parameters, tool_point):
    """Motion equation of Z: displacement of the tool point since home, to first order.

    Source: Eqs. (7)-(11). Operations: 26 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB
                ECB EXC EYC EZC EAC EBC ECC
        parameters (26,): home positions and location errors [mm, rad]
            rows: q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C
                eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B
        tool_point (3, n): point in the tool frame [mm]
            rows: rTx rTy rTz

    Returns:
        displacement (3, n): tool point, displacement since home, in the bed frame [mm]
            rows: dx dy dz
    """
    n, positions, errors, tool_point = _points(positions=(positions, 5), errors=(errors, 30), tool_point=(tool_point, 3))
    parameters = _constant("parameters", parameters, (26,))
    displacement = np.zeros((3, n))
    # constants
    q_Bx = float(parameters[6])
    q_By = float(parameters[7])
    q_Bz = float(parameters[8])
    q_Sx = float(parameters[9])
    q_Sy = float(parameters[10])
    q_Sz = float(parameters[11])
    q_Tx = float(parameters[12])
    q_Ty = float(parameters[13])
    q_Tz = float(parameters[14])
    eps_yz = float(parameters[20])
    eps_xz = float(parameters[21])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        z = positions[2, at]
        EXZ = errors[12, at]
        EYZ = errors[13, at]
        EZZ = errors[14, at]
        EAZ = errors[15, at]
        EBZ = errors[16, at]
        ECZ = errors[17, at]
        rTx = tool_point[0, at]
        rTy = tool_point[1, at]
        rTz = tool_point[2, at]
        # per point
        w0 = q_Bz + q_Sz + q_Tz + rTz
        w1 = q_By + q_Sy + q_Ty + rTy
        displacement[0, at] = EBZ*w0 - ECZ*w1 + EXZ + eps_xz*z
        w2 = q_Bx + q_Sx + q_Tx + rTx
        displacement[1, at] = -EAZ*w0 + ECZ*w2 + EYZ - eps_yz*z
        displacement[2, at] = EAZ*w1 - EBZ*w2 + EZZ + z
    return displacement


def motion_B(positions, errors, parameters, tool_point):
    """Motion equation of B: displacement of the tool point since home, to first order.

    Source: Eqs. (7)-(11). Operations: 91 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB
                ECB EXC EYC EZC EAC EBC ECC
        parameters (26,): home positions and location errors [mm, rad]
            rows: q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C
                eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B
        tool_point (3, n): point in the tool frame [mm]
            rows: rTx rTy rTz

    Returns:
        displacement (3, n): tool point, displacement since home, in the bed frame [mm]
            rows: dx dy dz
    """
    n, positions, errors, tool_point = _points(positions=(positions, 5), errors=(errors, 30), tool_point=(tool_point, 3))
    parameters = _constant("parameters", parameters, (26,))
    displacement = np.zeros((3, n))
    # constants
    q_Sx = float(parameters[9])
    q_Sy = float(parameters[10])
    q_Sz = float(parameters[11])
    q_Tx = float(parameters[12])
    q_Ty = float(parameters[13])
    q_Tz = float(parameters[14])
    eps_xy = float(parameters[19])
    eps_yz = float(parameters[20])
    eps_xz = float(parameters[21])
    EA0B = float(parameters[24])
    EC0B = float(parameters[25])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        b = positions[3, at]
        EXB = errors[18, at]
        EYB = errors[19, at]
        EZB = errors[20, at]
        EAB = errors[21, at]
        EBB = errors[22, at]
        ECB = errors[23, at]
        rTx = tool_point[0, at]
        rTy = tool_point[1, at]
        rTz = tool_point[2, at]
        # cosines and sines
        cos_b = np.cos(0.017453292519943295*b)
        sin_b = np.sin(0.017453292519943295*b)
        # per point
        w0 = q_Sy*sin_b + q_Ty*sin_b + rTy*sin_b
        w1 = q_Sx*sin_b
        w2 = q_Tx*sin_b
        w3 = rTx*sin_b
        w4 = cos_b*q_Sz + cos_b*q_Tz + cos_b*rTz - w1 - w2 - w3
        w5 = cos_b*q_Sy + cos_b*q_Ty + cos_b*rTy
        w6 = q_Sz + q_Tz + rTz
        w7 = -cos_b*q_Sz - cos_b*q_Tz - cos_b*rTz + w1 + w2 + w3 + w6
        w8 = cos_b*q_Sx + cos_b*q_Tx + cos_b*rTx + q_Sz*sin_b + q_Tz*sin_b + rTz*sin_b
        w9 = -q_Sx - q_Tx - rTx + w8
        displacement[0, at] = EAB*w0 + EBB*w4 - ECB*w5 + EXB*cos_b + EZB*sin_b - eps_xz*w7 + w9
        displacement[1, at] = EA0B*w7 - EAB*w6 + EC0B*w9 + ECB*(q_Sx + q_Tx + rTx) + EYB + eps_xy*w9 + eps_yz*w7
        displacement[2, at] = EAB*w5 - EBB*w8 + ECB*w0 - EXB*sin_b + EZB*cos_b - eps_xz*w9 - q_Sz - q_Tz - rTz + w4
    return displacement


def motion_C(positions, errors, parameters, workpiece_point):
    """Motion equation of C: displacement of the workpiece point since home, to first order.

    Source: Eqs. (7)-(11). Operations: 62 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB
                ECB EXC EYC EZC EAC EBC ECC
        parameters (26,): home positions and location errors [mm, rad]
            rows: q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C
                eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B
        workpiece_point (3, n): point in the workpiece frame [mm]
            rows: rWx rWy rWz

    Returns:
        displacement (3, n): workpiece point, displacement since home, in the bed frame [mm]
            rows: dx dy dz
    """
    n, positions, errors, workpiece_point = _points(positions=(positions, 5), errors=(errors, 30), workpiece_point=(workpiece_point, 3))
    parameters = _constant("parameters", parameters, (26,))
    displacement = np.zeros((3, n))
    # constants
    q_wx = float(parameters[3])
    q_wy = float(parameters[4])
    q_wz = float(parameters[5])
    EA0C = float(parameters[17])
    EB0C = float(parameters[18])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        c = positions[4, at]
        EXC = errors[24, at]
        EYC = errors[25, at]
        EZC = errors[26, at]
        EAC = errors[27, at]
        EBC = errors[28, at]
        ECC = errors[29, at]
        rWx = workpiece_point[0, at]
        rWy = workpiece_point[1, at]
        rWz = workpiece_point[2, at]
        # cosines and sines
        cos_c = np.cos(0.017453292519943295*c)
        sin_c = np.sin(0.017453292519943295*c)
        # per point
        w0 = q_wz*sin_c + rWz*sin_c
        w1 = cos_c*q_wz + cos_c*rWz
        w2 = cos_c*q_wy + cos_c*rWy + q_wx*sin_c + rWx*sin_c
        w3 = cos_c*q_wx
        w4 = cos_c*rWx
        w5 = q_wy*sin_c
        w6 = rWy*sin_c
        w7 = w3 + w4 - w5 - w6
        displacement[0, at] = EAC*w0 + EBC*w1 - ECC*w2 + EXC*cos_c - EYC*sin_c - q_wx - rWx + w7
        w8 = -q_wy - rWy + w2
        displacement[1, at] = -EAC*w1 + EBC*w0 + ECC*w7 + EXC*sin_c + EYC*cos_c + w8
        w9 = q_wx + rWx
        displacement[2, at] = EA0C*w8 + EAC*(q_wy + rWy) + EB0C*(-w3 - w4 + w5 + w6 + w9) - EBC*w9 + EZC
    return displacement


def motion_XY(positions, errors, parameters, workpiece_point, tool_point):
    """Motion equation of X and Y: displacement of the workpiece point minus tool point since home, to first order.

    Source: Eqs. (7)-(11). Operations: 46 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB
                ECB EXC EYC EZC EAC EBC ECC
        parameters (26,): home positions and location errors [mm, rad]
            rows: q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C
                eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B
        workpiece_point (3, n): point in the workpiece frame [mm]
            rows: rWx rWy rWz
        tool_point (3, n): point in the tool frame [mm]
            rows: rTx rTy rTz

    Returns:
        displacement (3, n): workpiece point minus tool point, displacement since home, in the bed frame [mm]
            rows: dx dy dz
    """
    n, positions, errors, workpiece_point, tool_point = _points(positions=(positions, 5), errors=(errors, 30), workpiece_point=(workpiece_point, 3), tool_point=(tool_point, 3))
    parameters = _constant("parameters", parameters, (26,))
    displacement = np.zeros((3, n))
    # constants
    q_Cx = float(parameters[0])
    q_Cy = float(parameters[1])
    q_Cz = float(parameters[2])
    q_wx = float(parameters[3])
    q_wy = float(parameters[4])
    q_wz = float(parameters[5])
    q_Bx = float(parameters[6])
    q_By = float(parameters[7])
    q_Bz = float(parameters[8])
    q_Sx = float(parameters[9])
    q_Sy = float(parameters[10])
    q_Sz = float(parameters[11])
    q_Tx = float(parameters[12])
    q_Ty = float(parameters[13])
    q_Tz = float(parameters[14])
    eps_xy = float(parameters[19])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        x = positions[0, at]
        y = positions[1, at]
        EXX = errors[0, at]
        EYX = errors[1, at]
        EZX = errors[2, at]
        EAX = errors[3, at]
        EBX = errors[4, at]
        ECX = errors[5, at]
        EXY = errors[6, at]
        EYY = errors[7, at]
        EZY = errors[8, at]
        EAY = errors[9, at]
        EBY = errors[10, at]
        ECY = errors[11, at]
        rWx = workpiece_point[0, at]
        rWy = workpiece_point[1, at]
        rWz = workpiece_point[2, at]
        rTx = tool_point[0, at]
        rTy = tool_point[1, at]
        rTz = tool_point[2, at]
        # per point
        w0 = q_Cz + q_wz + rWz
        w1 = q_By + q_Sy + q_Ty + rTy
        w2 = q_Cy + q_wy + rWy
        w3 = q_Bz + q_Sz + q_Tz + rTz
        displacement[0, at] = -EBX*w3 + EBY*w0 + ECX*w1 - ECY*w2 - EXX + EXY - x
        w4 = q_Cx + q_wx + rWx
        w5 = q_Bx + q_Sx + q_Tx + rTx
        displacement[1, at] = EAX*w3 - EAY*w0 - ECX*w5 + ECY*w4 - EYX + EYY - eps_xy*x + y
        displacement[2, at] = -EAX*w1 + EAY*w2 + EBX*w5 - EBY*w4 - EZX + EZY
    return displacement


def motion_XZ(positions, errors, parameters, tool_point):
    """Motion equation of X and Z: displacement of the tool point since home, to first order.

    Source: Eqs. (7)-(11). Operations: 47 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB
                ECB EXC EYC EZC EAC EBC ECC
        parameters (26,): home positions and location errors [mm, rad]
            rows: q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C
                eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B
        tool_point (3, n): point in the tool frame [mm]
            rows: rTx rTy rTz

    Returns:
        displacement (3, n): tool point, displacement since home, in the bed frame [mm]
            rows: dx dy dz
    """
    n, positions, errors, tool_point = _points(positions=(positions, 5), errors=(errors, 30), tool_point=(tool_point, 3))
    parameters = _constant("parameters", parameters, (26,))
    displacement = np.zeros((3, n))
    # constants
    q_Bx = float(parameters[6])
    q_By = float(parameters[7])
    q_Bz = float(parameters[8])
    q_Sx = float(parameters[9])
    q_Sy = float(parameters[10])
    q_Sz = float(parameters[11])
    q_Tx = float(parameters[12])
    q_Ty = float(parameters[13])
    q_Tz = float(parameters[14])
    eps_xy = float(parameters[19])
    eps_yz = float(parameters[20])
    eps_xz = float(parameters[21])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        x = positions[0, at]
        z = positions[2, at]
        EXX = errors[0, at]
        EYX = errors[1, at]
        EZX = errors[2, at]
        EAX = errors[3, at]
        EBX = errors[4, at]
        ECX = errors[5, at]
        EXZ = errors[12, at]
        EYZ = errors[13, at]
        EZZ = errors[14, at]
        EAZ = errors[15, at]
        EBZ = errors[16, at]
        ECZ = errors[17, at]
        rTx = tool_point[0, at]
        rTy = tool_point[1, at]
        rTz = tool_point[2, at]
        # per point
        w0 = q_Bz + q_Sz + q_Tz + rTz
        w1 = w0 + z
        w2 = q_By + q_Sy + q_Ty + rTy
        w3 = -w2
        displacement[0, at] = EBX*w1 + EBZ*w0 + ECX*w3 + ECZ*w3 + EXX + EXZ + eps_xz*z + x
        w4 = q_Bx + q_Sx + q_Tx + rTx
        displacement[1, at] = -EAX*w1 - EAZ*w0 + ECX*w4 + ECZ*w4 + EYX + EYZ + eps_xy*x - eps_yz*z
        w5 = -w4
        displacement[2, at] = EAX*w2 + EAZ*w2 + EBX*w5 + EBZ*w5 + EZX + EZZ + z
    return displacement


def motion_YZ(positions, errors, parameters, workpiece_point, tool_point):
    """Motion equation of Y and Z: displacement of the workpiece point minus tool point since home, to first order.

    Source: Eqs. (7)-(11). Operations: 48 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB
                ECB EXC EYC EZC EAC EBC ECC
        parameters (26,): home positions and location errors [mm, rad]
            rows: q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Bx q_By q_Bz q_Sx q_Sy q_Sz q_Tx q_Ty q_Tz EX0C EY0C EA0C EB0C
                eps_xy eps_yz eps_xz EX0B EZ0B EA0B EC0B
        workpiece_point (3, n): point in the workpiece frame [mm]
            rows: rWx rWy rWz
        tool_point (3, n): point in the tool frame [mm]
            rows: rTx rTy rTz

    Returns:
        displacement (3, n): workpiece point minus tool point, displacement since home, in the bed frame [mm]
            rows: dx dy dz
    """
    n, positions, errors, workpiece_point, tool_point = _points(positions=(positions, 5), errors=(errors, 30), workpiece_point=(workpiece_point, 3), tool_point=(tool_point, 3))
    parameters = _constant("parameters", parameters, (26,))
    displacement = np.zeros((3, n))
    # constants
    q_Cx = float(parameters[0])
    q_Cy = float(parameters[1])
    q_Cz = float(parameters[2])
    q_wx = float(parameters[3])
    q_wy = float(parameters[4])
    q_wz = float(parameters[5])
    q_Bx = float(parameters[6])
    q_By = float(parameters[7])
    q_Bz = float(parameters[8])
    q_Sx = float(parameters[9])
    q_Sy = float(parameters[10])
    q_Sz = float(parameters[11])
    q_Tx = float(parameters[12])
    q_Ty = float(parameters[13])
    q_Tz = float(parameters[14])
    eps_yz = float(parameters[20])
    eps_xz = float(parameters[21])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        y = positions[1, at]
        z = positions[2, at]
        EXY = errors[6, at]
        EYY = errors[7, at]
        EZY = errors[8, at]
        EAY = errors[9, at]
        EBY = errors[10, at]
        ECY = errors[11, at]
        EXZ = errors[12, at]
        EYZ = errors[13, at]
        EZZ = errors[14, at]
        EAZ = errors[15, at]
        EBZ = errors[16, at]
        ECZ = errors[17, at]
        rWx = workpiece_point[0, at]
        rWy = workpiece_point[1, at]
        rWz = workpiece_point[2, at]
        rTx = tool_point[0, at]
        rTy = tool_point[1, at]
        rTz = tool_point[2, at]
        # per point
        w0 = q_Cz + q_wz + rWz
        w1 = q_By + q_Sy + q_Ty + rTy
        w2 = q_Cy + q_wy + rWy
        w3 = q_Bz + q_Sz + q_Tz + rTz
        displacement[0, at] = EBY*w0 - EBZ*w3 - ECY*w2 + ECZ*w1 + EXY - EXZ - eps_xz*z
        w4 = q_Cx + q_wx + rWx
        w5 = q_Bx + q_Sx + q_Tx + rTx
        displacement[1, at] = -EAY*w0 + EAZ*w3 + ECY*w4 - ECZ*w5 + EYY - EYZ + eps_yz*z + y
        displacement[2, at] = EAY*w2 - EAZ*w1 - EBY*w4 + EBZ*w5 + EZY - EZZ - z
    return displacement
