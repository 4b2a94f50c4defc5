# Generated from machines/trunnion_mill.toml, do not edit; regenerate with: trueaxis derive machines/trunnion_mill.toml
# SPDX-License-Identifier: MIT
"""Kernels of Five-axis mill with a trunnion table: geometric error model in NumPy.

Arrays are float64 with the quantity first and the point last: positions (n_axes, n), errors (n_components, n),
deviation (3, n). An array that is the same at all points may have n = 1. Lengths mm, angles rad, positions of
rotary axes deg.
An array of another shape is a ValueError that names it.

Equations after: Prediction and compensation of geometric error for translational axes in multi-axis machine tools
"""

import numpy as np

ABI = 3
SPEC_HASH = "fff68e3a25ed33ff02fbf9ab6e0875735d9de644fc7b3d9d269b461961e2d9f2"

META = {
    'machine': 'trunnion_mill',
    'title': 'Five-axis mill with a trunnion table',
    'axes': ['X', 'Y', 'Z', 'A', 'C'],
    'position_units': ['mm', 'mm', 'mm', 'deg', 'deg'],
    'travel': {'X': [0.0, 500.0], 'Y': [0.0, 450.0], 'Z': [0.0, 400.0], 'A': [-120.0, 30.0], 'C': [-360.0, 360.0]},
    'components': [
        'EXX', 'EYX', 'EZX', 'EAX', 'EBX', 'ECX', 'EXY', 'EYY', 'EZY', 'EAY', 'EBY', 'ECY', 'EXZ', 'EYZ', 'EZZ',
        'EAZ', 'EBZ', 'ECZ', 'EXA', 'EYA', 'EZA', 'EAA', 'EBA', 'ECA', 'EXC', 'EYC', 'EZC', 'EAC', 'EBC', 'ECC',
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
        'error motion of A along X', 'error motion of A along Y', 'error motion of A along Z',
        'angular positioning error of A', 'tilt error of A about B', 'tilt error of A about C',
        'error motion of C along X', 'error motion of C along Y', 'error motion of C along Z',
        'tilt error of C about A', 'tilt error of C about B', 'angular positioning error of C',
    ],
    'parameters': [
        'q_Ax', 'q_Ay', 'q_Az', 'q_Cx', 'q_Cy', 'q_Cz', 'q_wx', 'q_wy', 'q_wz', 'q_Tx', 'q_Ty', 'q_Tz', 'EC0Y',
        'EY0A', 'EZ0A', 'EB0A', 'EC0A', 'EX0C', 'EY0C', 'EA0C', 'EB0C', 'EA0Z', 'EB0Z',
    ],
    'parameter_units': [
        'mm', 'mm', 'mm', 'mm', 'mm', 'mm', 'mm', 'mm', 'mm', 'mm', 'mm', 'mm', 'rad', 'mm', 'mm', 'rad', 'rad', 'mm',
        'mm', 'rad', 'rad', 'rad', 'rad',
    ],
    'parameter_descriptions': [
        'home position along X, body 3 (A table) on body 2', 'home position along Y, body 3 (A table) on body 2',
        'home position along Z, body 3 (A table) on body 2', 'home position along X, body 4 (C table) on body 3',
        'home position along Y, body 4 (C table) on body 3', 'home position along Z, body 4 (C table) on body 3',
        'home position along X, body 5 (workpiece) on body 4', 'home position along Y, body 5 (workpiece) on body 4',
        'home position along Z, body 5 (workpiece) on body 4', 'home position along X, body 8 (tool) on body 7',
        'home position along Y, body 8 (tool) on body 7', 'home position along Z, body 8 (tool) on body 7',
        'location error, rotation about Z, body 2 (Y slide) on body 1',
        'location error, displacement along Y, body 3 (A table) on body 2',
        'location error, displacement along Z, body 3 (A table) on body 2',
        'location error, rotation about Y, body 3 (A table) on body 2',
        'location error, rotation about Z, body 3 (A table) on body 2',
        'location error, displacement along X, body 4 (C table) on body 3',
        'location error, displacement along Y, body 4 (C table) on body 3',
        'location error, rotation about X, body 4 (C table) on body 3',
        'location error, rotation about Y, body 4 (C table) on body 3',
        'location error, rotation about X, body 7 (Z slide) on body 6',
        'location error, rotation about Y, body 7 (Z slide) on body 6',
    ],
    'dimensions': ['q_Ax', 'q_Ay', 'q_Az', 'q_Cx', 'q_Cy', 'q_Cz', 'q_wx', 'q_wy', 'q_wz', 'q_Tx', 'q_Ty', 'q_Tz'],
    'location_errors': ['EC0Y', 'EY0A', 'EZ0A', 'EB0A', 'EC0A', 'EX0C', 'EY0C', 'EA0C', 'EB0C', 'EA0Z', 'EB0Z'],
    'curve_degree': 7,
    'squareness': [
        {'axes': ['X', 'Y'], 'location_errors': {'EC0Y': -1.0}},
        {'axes': ['X', 'Z'], 'location_errors': {'EB0Z': 1.0}},
        {'axes': ['Y', 'Z'], 'location_errors': {'EA0Z': -1.0}},
    ],
    'effects': {'kinds': {}, 'terms': []},
    'routines': {
        'tool_in_workpiece_ideal': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'parameters', 'shape': [23], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'ideal', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 90,
            'operations_per_call': 0,
        },
        'tool_in_workpiece_deviation': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [23], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 297,
            'operations_per_call': 13,
        },
        'tool_in_workpiece_deviation_first_order': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [23], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 148,
            'operations_per_call': 0,
        },
        'tool_in_workpiece_sensitivity': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'parameters', 'shape': [23], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'sensitivity', 'shape': [3, 41], 'per_point': True, 'unit': 'mm/mm, mm/rad'}],
            'operations': 261,
            'operations_per_call': 0,
        },
        'tool_in_bed_ideal': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'parameters', 'shape': [23], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'ideal', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 5,
            'operations_per_call': 0,
        },
        'tool_in_bed_deviation': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [23], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 45,
            'operations_per_call': 0,
        },
        'tool_in_bed_deviation_first_order': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [23], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 39,
            'operations_per_call': 0,
        },
        'tool_in_bed_sensitivity': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'parameters', 'shape': [23], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'sensitivity', 'shape': [3, 41], 'per_point': True, 'unit': 'mm/mm, mm/rad'}],
            'operations': 8,
            'operations_per_call': 0,
        },
        'workpiece_in_bed_ideal': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'parameters', 'shape': [23], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'ideal', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 54,
            'operations_per_call': 0,
        },
        'workpiece_in_bed_deviation': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [23], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 122,
            'operations_per_call': 0,
        },
        'workpiece_in_bed_deviation_first_order': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [23], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 108,
            'operations_per_call': 0,
        },
        'workpiece_in_bed_sensitivity': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'parameters', 'shape': [23], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'sensitivity', 'shape': [3, 41], 'per_point': True, 'unit': 'mm/mm, mm/rad'}],
            'operations': 133,
            'operations_per_call': 0,
        },
        'bed_in_workpiece_ideal': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'parameters', 'shape': [23], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'ideal', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 63,
            'operations_per_call': 0,
        },
        'bed_in_workpiece_deviation': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [23], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 246,
            'operations_per_call': 13,
        },
        'bed_in_workpiece_deviation_first_order': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [23], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 106,
            'operations_per_call': 0,
        },
        'bed_in_workpiece_sensitivity': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'parameters', 'shape': [23], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'sensitivity', 'shape': [3, 41], 'per_point': True, 'unit': 'mm/mm, mm/rad'}],
            'operations': 183,
            'operations_per_call': 0,
        },
        'tool_in_workpiece_position': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [23], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'position', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 303,
            'operations_per_call': 13,
        },
        'tool_in_workpiece_position_first_order': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [23], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'position', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 154,
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
                {'name': 'parameters', 'shape': [23], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'direction', 'shape': [3], 'per_point': True, 'unit': '1'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': '1'}],
            'operations': 266,
            'operations_per_call': 13,
        },
        'tool_orientation_deviation_first_order': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [23], 'per_point': False, 'unit': 'mm, rad'},
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
                {'name': 'parameters', 'shape': [23], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': False, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 684,
            'operations_per_call': 16,
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
                {'name': 'parameters', 'shape': [23], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': False, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 535,
            'operations_per_call': 3,
        },
        'ballbar_error': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [23], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'ball', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'length', 'shape': [1], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'error', 'shape': [4], 'per_point': True, 'unit': 'mm'}],
            'operations': 336,
            'operations_per_call': 13,
        },
        'correction': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'moves', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 23,
            'operations_per_call': 0,
        },
        'motion_X': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [23], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'tool_point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'displacement', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 16,
            'operations_per_call': 0,
        },
        'motion_Y': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [23], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'workpiece_point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'displacement', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 24,
            'operations_per_call': 0,
        },
        'motion_Z': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [23], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'tool_point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'displacement', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 20,
            'operations_per_call': 0,
        },
        'motion_A': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [23], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'workpiece_point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'displacement', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 101,
            'operations_per_call': 0,
        },
        'motion_C': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [23], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'workpiece_point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'displacement', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 76,
            'operations_per_call': 0,
        },
        'motion_XY': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [23], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'workpiece_point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'tool_point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'displacement', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 43,
            'operations_per_call': 0,
        },
        'motion_XZ': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [23], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'tool_point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'displacement', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 39,
            'operations_per_call': 0,
        },
        'motion_YZ': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [23], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'workpiece_point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'tool_point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'displacement', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 47,
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

    Source: Eqs. (1)-(4) without errors. Operations: 90 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z A C [mm, rotary axes deg]
            rows: x y z a c
        parameters (23,): home positions and location errors [mm, rad]
            rows: q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C
                EA0C EB0C EA0Z EB0Z
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        ideal (3, n): tool point in the workpiece frame, without errors [mm]
            rows: px py pz
    """
    n, positions, point = _points(positions=(positions, 5), point=(point, 3))
    parameters = _constant("parameters", parameters, (23,))
    ideal = np.zeros((3, n))
    # constants
    q_Ax = float(parameters[0])
    q_Ay = float(parameters[1])
    q_Az = float(parameters[2])
    q_Cx = float(parameters[3])
    q_Cy = float(parameters[4])
    q_Cz = float(parameters[5])
    q_wx = float(parameters[6])
    q_wy = float(parameters[7])
    q_wz = float(parameters[8])
    q_Tx = float(parameters[9])
    q_Ty = float(parameters[10])
    q_Tz = float(parameters[11])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        x = positions[0, at]
        y = positions[1, at]
        z = positions[2, at]
        a = positions[3, at]
        c = positions[4, at]
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # cosines and sines
        cos_a = np.cos(0.017453292519943295*a)
        sin_a = np.sin(0.017453292519943295*a)
        cos_c = np.cos(0.017453292519943295*c)
        sin_c = np.sin(0.017453292519943295*c)
        # per point
        w0 = cos_a*sin_c
        w1 = sin_a*sin_c
        ideal[0, at] = -cos_c*q_Ax - cos_c*q_Cx + cos_c*q_Tx + cos_c*rx + cos_c*x - q_Ay*w0 - q_Az*w1 - q_Cy*sin_c + q_Ty*w0 + q_Tz*w1 - q_wx + ry*w0 + rz*w1 - w0*y + w1*z
        w2 = cos_a*cos_c
        ideal[1, at] = cos_a*cos_c*q_Ty + cos_a*cos_c*ry - cos_c*q_Az*sin_a - cos_c*q_Cy + cos_c*q_Tz*sin_a + cos_c*rz*sin_a + cos_c*sin_a*z + q_Ax*sin_c - q_Ay*w2 + q_Cx*sin_c - q_Tx*sin_c - q_wy - rx*sin_c - sin_c*x - w2*y
        ideal[2, at] = -cos_a*q_Az + cos_a*q_Tz + cos_a*rz + cos_a*z + q_Ay*sin_a - q_Cz - q_Ty*sin_a - q_wz - ry*sin_a + sin_a*y
    return ideal


def tool_in_workpiece_deviation(positions, errors, parameters, point):
    """Deviation of a tool point in the workpiece frame, exact.

    Source: Eqs. (1)-(4). Operations: 297 per point, 13 per call.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z A C [mm, rotary axes deg]
            rows: x y z a c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXA EYA EZA EAA EBA
                ECA EXC EYC EZC EAC EBC ECC
        parameters (23,): home positions and location errors [mm, rad]
            rows: q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C
                EA0C EB0C EA0Z EB0Z
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): tool point in the workpiece frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions, errors, point = _points(positions=(positions, 5), errors=(errors, 30), point=(point, 3))
    parameters = _constant("parameters", parameters, (23,))
    deviation = np.zeros((3, n))
    # constants
    q_Ax = float(parameters[0])
    q_Ay = float(parameters[1])
    q_Az = float(parameters[2])
    q_Cx = float(parameters[3])
    q_Cy = float(parameters[4])
    q_Cz = float(parameters[5])
    q_Tx = float(parameters[9])
    q_Ty = float(parameters[10])
    q_Tz = float(parameters[11])
    EC0Y = float(parameters[12])
    EY0A = float(parameters[13])
    EZ0A = float(parameters[14])
    EB0A = float(parameters[15])
    EC0A = float(parameters[16])
    EX0C = float(parameters[17])
    EY0C = float(parameters[18])
    EA0C = float(parameters[19])
    EB0C = float(parameters[20])
    EA0Z = float(parameters[21])
    EB0Z = float(parameters[22])
    # once per call
    w26 = (EC0Y*EC0Y)
    w27 = 1.0/(w26 + 1)
    w51 = (EB0A*EB0A) + (EC0A*EC0A)
    w52 = 1.0/(w51 + 1)
    w80 = (EA0C*EA0C) + (EB0C*EB0C)
    w81 = 1.0/(w80 + 1)
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        x = positions[0, at]
        y = positions[1, at]
        z = positions[2, at]
        a = positions[3, at]
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
        EXA = errors[18, at]
        EYA = errors[19, at]
        EZA = errors[20, at]
        EAA = errors[21, at]
        EBA = errors[22, at]
        ECA = errors[23, at]
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
        cos_a = np.cos(0.017453292519943295*a)
        sin_a = np.sin(0.017453292519943295*a)
        cos_c = np.cos(0.017453292519943295*c)
        sin_c = np.sin(0.017453292519943295*c)
        # per point
        w0 = q_Tx + rx
        w1 = w0 + x
        w2 = -q_Ax + w1
        w3 = -q_Cx + w2
        w4 = q_Ty + ry
        w5 = w4 - y
        w6 = -q_Ay + w5
        w7 = q_Tz + rz
        w8 = w7 + z
        w9 = -q_Az + w8
        w10 = cos_a*w6 + sin_a*w9
        w11 = -q_Cy + w10
        w12 = cos_c*w3 + sin_c*w11
        w13 = EBZ*w7 - ECZ*w4 + EXZ
        w14 = -EAZ*w7 + ECZ*w0 + EYZ
        w15 = EAZ*w4 - EBZ*w0 + EZZ
        w16 = EA0Z*(w14 + w4) - EB0Z*(w0 + w13) + w15
        w17 = w16 + w8
        w18 = w15 + w8
        w19 = -EA0Z*w18 + w14
        w20 = w19 + w4
        w21 = EB0Z*w18 + w13
        w22 = EBX*w17 - ECX*w20 + EXX + w21
        w23 = w0 + w21
        w24 = -EAX*w17 + ECX*w23 + EYX + w19
        w25 = w24 + w4
        w28 = w27*(EC0Y*w25 - w1*w26 + w22)
        w29 = -EXY + w28
        w30 = w1 + w22
        w31 = w27*(-EC0Y*w30 + w24 - w26*w4)
        w32 = -EYY + w31
        w33 = w32 + w5
        w34 = EAX*w20 - EBX*w23 + EZX + w16
        w35 = w34 + w8
        w36 = EC0Y*w35
        w37 = w27*(EC0Y*w36 - w26*w8 + w34)
        w38 = -EZY + w37
        w39 = w38 + w8
        w40 = w1 + w29
        w41 = EAY*w40 + EBY*w33 + ECY*w39
        w42 = (EAY*EAY) + (EBY*EBY) + (ECY*ECY)
        w43 = 1.0/(w42 + 1)
        w44 = w43*(EAY*w41 - EBY*w39 + ECY*w33 - w1*w42 + w29)
        w45 = w43*(EAY*w39 + EBY*w41 - ECY*w40 + w32 - w42*w5)
        w46 = -EY0A + w45
        w47 = w46 + w6
        w48 = w43*(-EAY*w33 + EBY*w40 + ECY*w41 + w38 - w42*w8)
        w49 = -EZ0A + w48
        w50 = w49 + w9
        w53 = w52*(-EB0A*w50 + EC0A*w47 - w2*w51 + w44)
        w54 = -EXA + w53
        w55 = w2 + w44
        w56 = EB0A*w47 + EC0A*w50
        w57 = w52*(EB0A*w56 - EC0A*w55 + w46 - w51*w6)
        w58 = w52*(EB0A*w55 + EC0A*w56 + w49 - w51*w9)
        w59 = cos_a*w57 + sin_a*w58
        w60 = -EYA + w59
        w61 = w10 + w60
        w62 = cos_a*w9 - sin_a*w6
        w63 = cos_a*w58 - sin_a*w57
        w64 = -EZA + w63
        w65 = w62 + w64
        w66 = w2 + w54
        w67 = EAA*w66 + EBA*w61 + ECA*w65
        w68 = (EAA*EAA) + (EBA*EBA) + (ECA*ECA)
        w69 = 1.0/(w68 + 1)
        w70 = w69*(EAA*w67 - EBA*w65 + ECA*w61 - w2*w68 + w54)
        w71 = -EX0C + w70
        w72 = w69*(-EAA*w61 + EBA*w66 + ECA*w67 - w62*w68 + w64)
        w73 = -q_Cz + w62
        w74 = w72 + w73
        w75 = w3 + w71
        w76 = w69*(EAA*w65 + EBA*w67 - ECA*w66 - w10*w68 + w60)
        w77 = -EY0C + w76
        w78 = w11 + w77
        w79 = EA0C*w75 + EB0C*w78
        w82 = w81*(EA0C*w79 - EB0C*w74 - w3*w80 + w71)
        w83 = w81*(EA0C*w74 + EB0C*w79 - w11*w80 + w77)
        w84 = cos_c*w82 + sin_c*w83
        w85 = -EXC + w84
        w86 = cos_c*w11 - sin_c*w3
        w87 = cos_c*w83 - sin_c*w82
        w88 = -EYC + w87
        w89 = w86 + w88
        w90 = w81*(-EA0C*w78 + EB0C*w75 + w72 - w73*w80)
        w91 = -EZC + w90
        w92 = w73 + w91
        w93 = w12 + w85
        w94 = EAC*w93 + EBC*w89 + ECC*w92
        w95 = (EAC*EAC) + (EBC*EBC) + (ECC*ECC)
        w96 = 1.0/(w95 + 1)
        deviation[0, at] = w96*(EAC*w94 - EBC*w92 + ECC*w89 - w12*w95 + w85)
        deviation[1, at] = w96*(EAC*w92 + EBC*w94 - ECC*w93 - w86*w95 + w88)
        deviation[2, at] = w96*(-EAC*w89 + EBC*w93 + ECC*w94 - w73*w95 + w91)
    return deviation


def tool_in_workpiece_deviation_first_order(positions, errors, parameters, point):
    """Deviation of a tool point in the workpiece frame, to first order in the errors.

    Source: Eqs. (1)-(4). Operations: 148 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z A C [mm, rotary axes deg]
            rows: x y z a c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXA EYA EZA EAA EBA
                ECA EXC EYC EZC EAC EBC ECC
        parameters (23,): home positions and location errors [mm, rad]
            rows: q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C
                EA0C EB0C EA0Z EB0Z
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): tool point in the workpiece frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions, errors, point = _points(positions=(positions, 5), errors=(errors, 30), point=(point, 3))
    parameters = _constant("parameters", parameters, (23,))
    deviation = np.zeros((3, n))
    # constants
    q_Ax = float(parameters[0])
    q_Ay = float(parameters[1])
    q_Az = float(parameters[2])
    q_Cx = float(parameters[3])
    q_Cy = float(parameters[4])
    q_Cz = float(parameters[5])
    q_Tx = float(parameters[9])
    q_Ty = float(parameters[10])
    q_Tz = float(parameters[11])
    EC0Y = float(parameters[12])
    EY0A = float(parameters[13])
    EZ0A = float(parameters[14])
    EB0A = float(parameters[15])
    EC0A = float(parameters[16])
    EX0C = float(parameters[17])
    EY0C = float(parameters[18])
    EA0C = float(parameters[19])
    EB0C = float(parameters[20])
    EA0Z = float(parameters[21])
    EB0Z = float(parameters[22])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        x = positions[0, at]
        y = positions[1, at]
        z = positions[2, at]
        a = positions[3, at]
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
        EXA = errors[18, at]
        EYA = errors[19, at]
        EZA = errors[20, at]
        EAA = errors[21, at]
        EBA = errors[22, at]
        ECA = errors[23, at]
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
        cos_a = np.cos(0.017453292519943295*a)
        sin_a = np.sin(0.017453292519943295*a)
        cos_c = np.cos(0.017453292519943295*c)
        sin_c = np.sin(0.017453292519943295*c)
        # per point
        w0 = q_Ty + ry
        w1 = w0 - y
        w2 = -q_Ay + w1
        w3 = q_Tz + rz
        w4 = w3 + z
        w5 = -q_Az + w4
        w6 = cos_a*w5 - sin_a*w2
        w7 = -q_Cz + w6
        w8 = q_Tx + rx
        w9 = w8 + x
        w10 = -q_Ax + w9
        w11 = -q_Cx + w10
        w12 = cos_a*w2 + sin_a*w5
        w13 = -q_Cy + w12
        w14 = cos_c*w13 - sin_c*w11
        w15 = EBZ*w3 - ECZ*w0 + EXZ
        w16 = EB0Z*w4 + w15
        w17 = EBX*w4 - ECX*w0 + EXX + w16
        w18 = EC0Y*w0 + w17
        w19 = -EBY*w4 + ECY*w1 - EXY + w18
        w20 = -EB0A*w5 + EC0A*w2 + w19
        w21 = -EBA*w6 + ECA*w12 - EXA + w20
        w22 = -EB0C*w7 - EX0C + w21
        w23 = -EAZ*w3 + ECZ*w8 + EYZ
        w24 = -EA0Z*w4 + w23
        w25 = -EAX*w4 + ECX*w8 + EYX + w24
        w26 = -EC0Y*w9 + w25
        w27 = EAY*w4 - ECY*w9 - EYY + w26
        w28 = -EC0A*w10 - EY0A + w27
        w29 = EAZ*w0 - EBZ*w8 + EZZ
        w30 = EA0Z*w0 - EB0Z*w8 + w29
        w31 = EAX*w0 - EBX*w8 + EZX + w30
        w32 = -EAY*w1 + EBY*w9 - EZY + w31
        w33 = EB0A*w10 - EZ0A + w32
        w34 = cos_a*w28 + sin_a*w33
        w35 = EAA*w6 - ECA*w10 - EYA + w34
        w36 = EA0C*w7 - EY0C + w35
        w37 = cos_c*w22 + sin_c*w36
        deviation[0, at] = -EBC*w7 + ECC*w14 - EXC + w37
        w38 = cos_c*w11 + sin_c*w13
        w39 = cos_c*w36 - sin_c*w22
        deviation[1, at] = EAC*w7 - ECC*w38 - EYC + w39
        w40 = cos_a*w33 - sin_a*w28
        w41 = -EAA*w12 + EBA*w10 - EZA + w40
        w42 = -EA0C*w13 + EB0C*w11 + w41
        deviation[2, at] = -EAC*w14 + EBC*w38 - EZC + w42
    return deviation


def tool_in_workpiece_sensitivity(positions, parameters, point):
    """Sensitivity of a tool point in the workpiece frame to every error, at the error-free machine.

    Source: Eqs. (1)-(4), first order. Operations: 261 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z A C [mm, rotary axes deg]
            rows: x y z a c
        parameters (23,): home positions and location errors [mm, rad]
            rows: q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C
                EA0C EB0C EA0Z EB0Z
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        sensitivity (3, 41, n): derivative of the deviation by each component error, then by each location error [mm/mm, mm/rad]
            rows: dx_EXX dx_EYX .. dz_EB0Z, last index fastest
    """
    n, positions, point = _points(positions=(positions, 5), point=(point, 3))
    parameters = _constant("parameters", parameters, (23,))
    sensitivity = np.zeros((123, n))
    # constants
    q_Ax = float(parameters[0])
    q_Ay = float(parameters[1])
    q_Az = float(parameters[2])
    q_Cx = float(parameters[3])
    q_Cy = float(parameters[4])
    q_Cz = float(parameters[5])
    q_Tx = float(parameters[9])
    q_Ty = float(parameters[10])
    q_Tz = float(parameters[11])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        x = positions[0, at]
        y = positions[1, at]
        z = positions[2, at]
        a = positions[3, at]
        c = positions[4, at]
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # cosines and sines
        cos_a = np.cos(0.017453292519943295*a)
        sin_a = np.sin(0.017453292519943295*a)
        cos_c = np.cos(0.017453292519943295*c)
        sin_c = np.sin(0.017453292519943295*c)
        # per point
        sensitivity[1, at] = dx_EYX = cos_a*sin_c
        sensitivity[2, at] = dx_EZX = sin_a*sin_c
        w0 = dx_EYX*q_Tz + dx_EYX*rz - dx_EZX*q_Ty - dx_EZX*ry
        w1 = dx_EYX*z + w0
        sensitivity[3, at] = dx_EAX = -w1
        w2 = cos_c*q_Tz
        w3 = cos_c*rz
        w4 = dx_EZX*q_Tx
        w5 = dx_EZX*rx
        sensitivity[16, at] = dx_EBZ = w2 + w3 - w4 - w5
        w6 = cos_c*z
        sensitivity[4, at] = dx_EBX = dx_EBZ + w6
        w7 = cos_c*q_Ty
        w8 = cos_c*ry
        sensitivity[5, at] = dx_ECX = dx_EYX*q_Tx + dx_EYX*rx - w7 - w8
        sensitivity[6, at] = dx_EXY = -cos_c
        sensitivity[7, at] = dx_EYY = -dx_EYX
        sensitivity[8, at] = dx_EZY = -dx_EZX
        sensitivity[9, at] = dx_EAY = dx_EZX*y + w1
        sensitivity[19, at] = dx_EYA = -sin_c
        sensitivity[21, at] = dx_EAA = dx_EAY - dx_EYX*q_Az + dx_EZX*q_Ay
        w9 = cos_c*y
        w10 = cos_a*w2 + cos_a*w3 - sin_a*w7 - sin_a*w8
        w11 = cos_a*w6 + w10
        sensitivity[50, at] = dy_EAY = sin_a*w9 + w11
        w12 = q_Ay*sin_a
        sensitivity[62, at] = dy_EAA = -cos_a*cos_c*q_Az + cos_c*w12 + dy_EAY
        sensitivity[68, at] = dy_EAC = -cos_a*q_Az + cos_a*q_Tz + cos_a*rz + cos_a*z - q_Cz - q_Ty*sin_a - ry*sin_a + sin_a*y + w12
        w13 = cos_c*q_Ay
        w14 = cos_c*q_Az
        w15 = -cos_a*cos_c*q_Ty - cos_a*cos_c*ry + cos_a*w13 + cos_a*w9 - cos_c*q_Tz*sin_a - cos_c*rz*sin_a - cos_c*sin_a*z - q_Ax*sin_c + q_Tx*sin_c + rx*sin_c + sin_a*w14 + sin_c*x
        sensitivity[109, at] = dz_EAC = cos_c*q_Cy - q_Cx*sin_c + w15
        sensitivity[37, at] = dx_EA0C = dx_EAA - q_Cz*sin_c
        sensitivity[78, at] = dy_EA0C = -cos_c*q_Cz + dy_EAA
        sensitivity[42, at] = dy_EYX = cos_a*cos_c
        sensitivity[43, at] = dy_EZX = cos_c*sin_a
        sensitivity[44, at] = dy_EAX = -w11
        w16 = dy_EZX*q_Tx + dy_EZX*rx + q_Tz*sin_c + rz*sin_c
        w17 = sin_c*z + w16
        sensitivity[45, at] = dy_EBX = -w17
        sensitivity[46, at] = dy_ECX = dy_EYX*q_Tx + dy_EYX*rx + q_Ty*sin_c + ry*sin_c
        sensitivity[48, at] = dy_EYY = -dy_EYX
        sensitivity[49, at] = dy_EZY = -dy_EZX
        sensitivity[51, at] = dy_EBY = dy_EZX*x + w17
        w18 = -cos_a*q_Ay*sin_c - cos_a*sin_c*y - cos_c*q_Ax + cos_c*q_Tx + cos_c*rx + cos_c*x + dx_EYX*q_Ty + dx_EYX*ry + dx_EZX*q_Tz + dx_EZX*rz + dx_EZX*z - q_Az*sin_a*sin_c
        sensitivity[110, at] = dz_EBC = -cos_c*q_Cx - q_Cy*sin_c + w18
        sensitivity[83, at] = dz_EYX = -sin_a
        sensitivity[97, at] = dz_EAZ = cos_a*q_Ty + cos_a*ry + q_Tz*sin_a + rz*sin_a
        sensitivity[85, at] = dz_EAX = dz_EAZ + sin_a*z
        w19 = cos_a*q_Tx + cos_a*rx
        sensitivity[86, at] = dz_EBX = -w19
        w20 = q_Tx*sin_a + rx*sin_a
        sensitivity[87, at] = dz_ECX = -w20
        sensitivity[90, at] = dz_EZY = -cos_a
        sensitivity[92, at] = dz_EBY = cos_a*x + w19
        sensitivity[93, at] = dz_ECY = sin_a*x + w20
        sensitivity[104, at] = dz_EBA = -q_Ax + q_Tx + rx + x
        sensitivity[0, at] = cos_c
        sensitivity[10, at] = -dx_EBX + sin_a*sin_c*x
        w21 = dx_ECX + dx_EYX*x
        w22 = w21 + w9
        sensitivity[11, at] = -w22
        sensitivity[12, at] = cos_c
        sensitivity[13, at] = dx_EYX
        sensitivity[14, at] = dx_EZX
        sensitivity[15, at] = -w0
        sensitivity[17, at] = dx_ECX
        sensitivity[18, at] = dx_EXY
        sensitivity[22, at] = -dy_EAA
        sensitivity[23, at] = -w15
        sensitivity[24, at] = -1.0
        sensitivity[28, at] = -dy_EAC
        sensitivity[29, at] = -dz_EAC
        sensitivity[30, at] = -w21
        sensitivity[31, at] = dx_EYY
        sensitivity[32, at] = dx_EZY
        sensitivity[33, at] = -dx_EZX*q_Ax + dx_EZX*x + w14 - w2 - w3 + w4 + w5 - w6
        sensitivity[34, at] = cos_a*q_Ax*sin_c - w13 - w22
        sensitivity[35, at] = dx_EXY
        sensitivity[36, at] = dx_EYA
        sensitivity[38, at] = -dy_EA0C
        sensitivity[39, at] = dx_EAX
        sensitivity[40, at] = dx_EBX
        sensitivity[41, at] = dx_EYA
        sensitivity[47, at] = sin_c
        w23 = dy_ECX + dy_EYX*x
        w24 = -sin_c*y + w23
        sensitivity[52, at] = -w24
        sensitivity[53, at] = dx_EYA
        sensitivity[54, at] = dy_EYX
        sensitivity[55, at] = dy_EZX
        sensitivity[56, at] = -w10
        sensitivity[57, at] = -w16
        sensitivity[58, at] = dy_ECX
        sensitivity[59, at] = sin_c
        sensitivity[60, at] = dx_EXY
        sensitivity[63, at] = dx_EAA
        sensitivity[64, at] = -w18
        sensitivity[66, at] = -1.0
        sensitivity[70, at] = -dz_EBC
        sensitivity[71, at] = -w23
        sensitivity[72, at] = dy_EYY
        sensitivity[73, at] = dy_EZY
        sensitivity[74, at] = dy_EBY - dy_EZX*q_Ax - q_Az*sin_c
        sensitivity[75, at] = cos_a*cos_c*q_Ax + q_Ay*sin_c - w24
        sensitivity[76, at] = sin_c
        sensitivity[77, at] = dx_EXY
        sensitivity[79, at] = dx_EA0C
        sensitivity[80, at] = dy_EAX
        sensitivity[81, at] = dy_EBX
        sensitivity[84, at] = cos_a
        sensitivity[89, at] = sin_a
        w25 = -cos_a*y + dz_EAX
        sensitivity[91, at] = -w25
        sensitivity[95, at] = dz_EYX
        sensitivity[96, at] = cos_a
        sensitivity[98, at] = dz_EBX
        sensitivity[99, at] = dz_ECX
        sensitivity[102, at] = -1.0
        w26 = -cos_a*q_Ay - q_Az*sin_a + w25
        sensitivity[103, at] = -w26
        sensitivity[108, at] = -1.0
        sensitivity[112, at] = dz_ECY
        sensitivity[113, at] = sin_a
        sensitivity[114, at] = dz_EZY
        sensitivity[115, at] = -cos_a*q_Ax + dz_EBY
        sensitivity[116, at] = dz_ECY - q_Ax*sin_a
        sensitivity[119, at] = q_Cy - w26
        sensitivity[120, at] = dz_EBA - q_Cx
        sensitivity[121, at] = dz_EAX
        sensitivity[122, at] = dz_EBX
    return sensitivity.reshape(3, 41, n)


def tool_in_bed_ideal(positions, parameters, point):
    """Ideal position of a tool point in the bed frame.

    Source: Eqs. (1)-(4) without errors. Operations: 5 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z A C [mm, rotary axes deg]
            rows: x y z a c
        parameters (23,): home positions and location errors [mm, rad]
            rows: q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C
                EA0C EB0C EA0Z EB0Z
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        ideal (3, n): tool point in the bed frame, without errors [mm]
            rows: px py pz
    """
    n, positions, point = _points(positions=(positions, 5), point=(point, 3))
    parameters = _constant("parameters", parameters, (23,))
    ideal = np.zeros((3, n))
    # constants
    q_Tx = float(parameters[9])
    q_Ty = float(parameters[10])
    q_Tz = float(parameters[11])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        x = positions[0, at]
        z = positions[2, at]
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # per point
        ideal[0, at] = q_Tx + rx + x
        ideal[1, at] = q_Ty + ry
        ideal[2, at] = q_Tz + rz + z
    return ideal


def tool_in_bed_deviation(positions, errors, parameters, point):
    """Deviation of a tool point in the bed frame, exact.

    Source: Eqs. (1)-(4). Operations: 45 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z A C [mm, rotary axes deg]
            rows: x y z a c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXA EYA EZA EAA EBA
                ECA EXC EYC EZC EAC EBC ECC
        parameters (23,): home positions and location errors [mm, rad]
            rows: q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C
                EA0C EB0C EA0Z EB0Z
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): tool point in the bed frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions, errors, point = _points(positions=(positions, 5), errors=(errors, 30), point=(point, 3))
    parameters = _constant("parameters", parameters, (23,))
    deviation = np.zeros((3, n))
    # constants
    q_Tx = float(parameters[9])
    q_Ty = float(parameters[10])
    q_Tz = float(parameters[11])
    EA0Z = float(parameters[21])
    EB0Z = float(parameters[22])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
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
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # per point
        w0 = q_Tz + rz
        w1 = w0 + z
        w2 = q_Tx + rx
        w3 = q_Ty + ry
        w4 = EBZ*w0 - ECZ*w3 + EXZ
        w5 = -EAZ*w0 + ECZ*w2 + EYZ
        w6 = EAZ*w3 - EBZ*w2 + EZZ
        w7 = EA0Z*(w3 + w5) - EB0Z*(w2 + w4) + w6
        w8 = w1 + w7
        w9 = w1 + w6
        w10 = -EA0Z*w9 + w5
        w11 = w10 + w3
        w12 = EB0Z*w9 + w4
        deviation[0, at] = EBX*w8 - ECX*w11 + EXX + w12
        w13 = w12 + w2
        deviation[1, at] = -EAX*w8 + ECX*w13 + EYX + w10
        deviation[2, at] = EAX*w11 - EBX*w13 + EZX + w7
    return deviation


def tool_in_bed_deviation_first_order(positions, errors, parameters, point):
    """Deviation of a tool point in the bed frame, to first order in the errors.

    Source: Eqs. (1)-(4). Operations: 39 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z A C [mm, rotary axes deg]
            rows: x y z a c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXA EYA EZA EAA EBA
                ECA EXC EYC EZC EAC EBC ECC
        parameters (23,): home positions and location errors [mm, rad]
            rows: q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C
                EA0C EB0C EA0Z EB0Z
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): tool point in the bed frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions, errors, point = _points(positions=(positions, 5), errors=(errors, 30), point=(point, 3))
    parameters = _constant("parameters", parameters, (23,))
    deviation = np.zeros((3, n))
    # constants
    q_Tx = float(parameters[9])
    q_Ty = float(parameters[10])
    q_Tz = float(parameters[11])
    EA0Z = float(parameters[21])
    EB0Z = float(parameters[22])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
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
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # per point
        w0 = q_Ty + ry
        w1 = q_Tz + rz
        w2 = w1 + z
        w3 = EBZ*w1 - ECZ*w0 + EXZ
        w4 = EB0Z*w2 + w3
        deviation[0, at] = EBX*w2 - ECX*w0 + EXX + w4
        w5 = q_Tx + rx
        w6 = -EAZ*w1 + ECZ*w5 + EYZ
        w7 = -EA0Z*w2 + w6
        deviation[1, at] = -EAX*w2 + ECX*w5 + EYX + w7
        w8 = EAZ*w0 - EBZ*w5 + EZZ
        w9 = EA0Z*w0 - EB0Z*w5 + w8
        deviation[2, at] = EAX*w0 - EBX*w5 + EZX + w9
    return deviation


def tool_in_bed_sensitivity(positions, parameters, point):
    """Sensitivity of a tool point in the bed frame to every error, at the error-free machine.

    Source: Eqs. (1)-(4), first order. Operations: 8 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z A C [mm, rotary axes deg]
            rows: x y z a c
        parameters (23,): home positions and location errors [mm, rad]
            rows: q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C
                EA0C EB0C EA0Z EB0Z
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        sensitivity (3, 41, n): derivative of the deviation by each component error, then by each location error [mm/mm, mm/rad]
            rows: dx_EXX dx_EYX .. dz_EB0Z, last index fastest
    """
    n, positions, point = _points(positions=(positions, 5), point=(point, 3))
    parameters = _constant("parameters", parameters, (23,))
    sensitivity = np.zeros((123, n))
    # constants
    q_Tx = float(parameters[9])
    q_Ty = float(parameters[10])
    q_Tz = float(parameters[11])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        z = positions[2, at]
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # per point
        sensitivity[16, at] = dx_EBZ = q_Tz + rz
        sensitivity[4, at] = dx_EBX = dx_EBZ + z
        sensitivity[85, at] = dz_EAX = q_Ty + ry
        sensitivity[5, at] = dx_ECX = -dz_EAX
        sensitivity[44, at] = dy_EAX = -dx_EBX
        sensitivity[46, at] = dy_ECX = q_Tx + rx
        sensitivity[86, at] = dz_EBX = -dy_ECX
        sensitivity[0, at] = 1.0
        sensitivity[12, at] = 1.0
        sensitivity[17, at] = dx_ECX
        sensitivity[40, at] = dx_EBX
        sensitivity[42, at] = 1.0
        sensitivity[54, at] = 1.0
        sensitivity[56, at] = -dx_EBZ
        sensitivity[58, at] = dy_ECX
        sensitivity[80, at] = dy_EAX
        sensitivity[84, at] = 1.0
        sensitivity[96, at] = 1.0
        sensitivity[97, at] = dz_EAX
        sensitivity[98, at] = dz_EBX
        sensitivity[121, at] = dz_EAX
        sensitivity[122, at] = dz_EBX
    return sensitivity.reshape(3, 41, n)


def workpiece_in_bed_ideal(positions, parameters, point):
    """Ideal position of a workpiece point in the bed frame.

    Source: Eqs. (1)-(4) without errors. Operations: 54 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z A C [mm, rotary axes deg]
            rows: x y z a c
        parameters (23,): home positions and location errors [mm, rad]
            rows: q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C
                EA0C EB0C EA0Z EB0Z
        point (3, n): point in the workpiece frame [mm]
            rows: rx ry rz

    Returns:
        ideal (3, n): workpiece point in the bed frame, without errors [mm]
            rows: px py pz
    """
    n, positions, point = _points(positions=(positions, 5), point=(point, 3))
    parameters = _constant("parameters", parameters, (23,))
    ideal = np.zeros((3, n))
    # constants
    q_Ax = float(parameters[0])
    q_Ay = float(parameters[1])
    q_Az = float(parameters[2])
    q_Cx = float(parameters[3])
    q_Cy = float(parameters[4])
    q_Cz = float(parameters[5])
    q_wx = float(parameters[6])
    q_wy = float(parameters[7])
    q_wz = float(parameters[8])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        y = positions[1, at]
        a = positions[3, at]
        c = positions[4, at]
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # cosines and sines
        cos_a = np.cos(0.017453292519943295*a)
        sin_a = np.sin(0.017453292519943295*a)
        cos_c = np.cos(0.017453292519943295*c)
        sin_c = np.sin(0.017453292519943295*c)
        # per point
        ideal[0, at] = cos_c*q_wx + cos_c*rx + q_Ax + q_Cx - q_wy*sin_c - ry*sin_c
        w0 = cos_a*cos_c
        w1 = cos_a*sin_c
        ideal[1, at] = cos_a*q_Cy + q_Ay - q_Cz*sin_a + q_wx*w1 + q_wy*w0 - q_wz*sin_a + rx*w1 + ry*w0 - rz*sin_a + y
        w2 = cos_c*sin_a
        w3 = sin_a*sin_c
        ideal[2, at] = cos_a*q_Cz + cos_a*q_wz + cos_a*rz + q_Az + q_Cy*sin_a + q_wx*w3 + q_wy*w2 + rx*w3 + ry*w2
    return ideal


def workpiece_in_bed_deviation(positions, errors, parameters, point):
    """Deviation of a workpiece point in the bed frame, exact.

    Source: Eqs. (1)-(4). Operations: 122 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z A C [mm, rotary axes deg]
            rows: x y z a c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXA EYA EZA EAA EBA
                ECA EXC EYC EZC EAC EBC ECC
        parameters (23,): home positions and location errors [mm, rad]
            rows: q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C
                EA0C EB0C EA0Z EB0Z
        point (3, n): point in the workpiece frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): workpiece point in the bed frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions, errors, point = _points(positions=(positions, 5), errors=(errors, 30), point=(point, 3))
    parameters = _constant("parameters", parameters, (23,))
    deviation = np.zeros((3, n))
    # constants
    q_Ax = float(parameters[0])
    q_Ay = float(parameters[1])
    q_Az = float(parameters[2])
    q_Cx = float(parameters[3])
    q_Cy = float(parameters[4])
    q_Cz = float(parameters[5])
    q_wx = float(parameters[6])
    q_wy = float(parameters[7])
    q_wz = float(parameters[8])
    EC0Y = float(parameters[12])
    EY0A = float(parameters[13])
    EZ0A = float(parameters[14])
    EB0A = float(parameters[15])
    EC0A = float(parameters[16])
    EX0C = float(parameters[17])
    EY0C = float(parameters[18])
    EA0C = float(parameters[19])
    EB0C = float(parameters[20])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        y = positions[1, at]
        a = positions[3, at]
        c = positions[4, at]
        EXY = errors[6, at]
        EYY = errors[7, at]
        EZY = errors[8, at]
        EAY = errors[9, at]
        EBY = errors[10, at]
        ECY = errors[11, at]
        EXA = errors[18, at]
        EYA = errors[19, at]
        EZA = errors[20, at]
        EAA = errors[21, at]
        EBA = errors[22, at]
        ECA = errors[23, at]
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
        cos_a = np.cos(0.017453292519943295*a)
        sin_a = np.sin(0.017453292519943295*a)
        cos_c = np.cos(0.017453292519943295*c)
        sin_c = np.sin(0.017453292519943295*c)
        # per point
        w0 = q_wx + rx
        w1 = q_wy + ry
        w2 = cos_c*w0 - sin_c*w1
        w3 = q_Cx + w2
        w4 = EAC*w1 - EBC*w0 + EZC
        w5 = cos_c*w1 + sin_c*w0
        w6 = q_wz + rz
        w7 = EBC*w6 - ECC*w1 + EXC
        w8 = -EAC*w6 + ECC*w0 + EYC
        w9 = cos_c*w7 - sin_c*w8
        w10 = cos_c*w8 + sin_c*w7
        w11 = EA0C*(w10 + w5) - EB0C*(w2 + w9) + w4
        w12 = q_Cz + w6
        w13 = w11 + w12
        w14 = w4 + w6
        w15 = -EA0C*w14 + EY0C + w10
        w16 = q_Cy + w5
        w17 = w15 + w16
        w18 = EB0C*w14 + EX0C + w9
        w19 = EBA*w13 - ECA*w17 + EXA + w18
        w20 = w19 + w3
        w21 = w18 + w3
        w22 = -EAA*w13 + ECA*w21 + EYA + w15
        w23 = EAA*w17 - EBA*w21 + EZA + w11
        w24 = cos_a*w22 - sin_a*w23
        w25 = EC0A*w20 + EY0A + w24
        w26 = cos_a*w16 - sin_a*w12
        w27 = q_Ay + w26
        w28 = w25 + w27
        w29 = cos_a*w12 + sin_a*w16
        w30 = cos_a*w23 + sin_a*w22
        w31 = EB0A*(w29 + w30) - EC0A*(w24 + w26) + w19
        w32 = q_Ax + w3
        w33 = w31 + w32
        w34 = -EB0A*w20 + EZ0A + w30
        deviation[2, at] = EAY*w28 - EBY*w33 + EZY + w34
        w35 = q_Az + w29
        w36 = w34 + w35
        w37 = EBY*w36 - ECY*w28 + EXY + w31
        w38 = -EAY*w36 + ECY*w33 + EYY + w25
        w39 = w27 + y
        deviation[0, at] = -EC0Y*(w38 + w39) + w37
        deviation[1, at] = EC0Y*(w32 + w37) + w38
    return deviation


def workpiece_in_bed_deviation_first_order(positions, errors, parameters, point):
    """Deviation of a workpiece point in the bed frame, to first order in the errors.

    Source: Eqs. (1)-(4). Operations: 108 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z A C [mm, rotary axes deg]
            rows: x y z a c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXA EYA EZA EAA EBA
                ECA EXC EYC EZC EAC EBC ECC
        parameters (23,): home positions and location errors [mm, rad]
            rows: q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C
                EA0C EB0C EA0Z EB0Z
        point (3, n): point in the workpiece frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): workpiece point in the bed frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions, errors, point = _points(positions=(positions, 5), errors=(errors, 30), point=(point, 3))
    parameters = _constant("parameters", parameters, (23,))
    deviation = np.zeros((3, n))
    # constants
    q_Ax = float(parameters[0])
    q_Ay = float(parameters[1])
    q_Az = float(parameters[2])
    q_Cx = float(parameters[3])
    q_Cy = float(parameters[4])
    q_Cz = float(parameters[5])
    q_wx = float(parameters[6])
    q_wy = float(parameters[7])
    q_wz = float(parameters[8])
    EC0Y = float(parameters[12])
    EY0A = float(parameters[13])
    EZ0A = float(parameters[14])
    EB0A = float(parameters[15])
    EC0A = float(parameters[16])
    EX0C = float(parameters[17])
    EY0C = float(parameters[18])
    EA0C = float(parameters[19])
    EB0C = float(parameters[20])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        y = positions[1, at]
        a = positions[3, at]
        c = positions[4, at]
        EXY = errors[6, at]
        EYY = errors[7, at]
        EZY = errors[8, at]
        EAY = errors[9, at]
        EBY = errors[10, at]
        ECY = errors[11, at]
        EXA = errors[18, at]
        EYA = errors[19, at]
        EZA = errors[20, at]
        EAA = errors[21, at]
        EBA = errors[22, at]
        ECA = errors[23, at]
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
        cos_a = np.cos(0.017453292519943295*a)
        sin_a = np.sin(0.017453292519943295*a)
        cos_c = np.cos(0.017453292519943295*c)
        sin_c = np.sin(0.017453292519943295*c)
        # per point
        w0 = q_wx + rx
        w1 = q_wy + ry
        w2 = cos_c*w0 - sin_c*w1
        w3 = q_Cx + w2
        w4 = q_wz + rz
        w5 = EBC*w4 - ECC*w1 + EXC
        w6 = -EAC*w4 + ECC*w0 + EYC
        w7 = cos_c*w6 + sin_c*w5
        w8 = -EA0C*w4 + EY0C + w7
        w9 = q_Cz + w4
        w10 = -EAA*w9 + ECA*w3 + EYA + w8
        w11 = EAC*w1 - EBC*w0 + EZC
        w12 = cos_c*w1 + sin_c*w0
        w13 = EA0C*w12 - EB0C*w2 + w11
        w14 = q_Cy + w12
        w15 = EAA*w14 - EBA*w3 + EZA + w13
        w16 = cos_a*w15 + sin_a*w10
        w17 = -EB0A*w3 + EZ0A + w16
        w18 = q_Ax + w3
        w19 = cos_a*w14 - sin_a*w9
        w20 = q_Ay + w19
        deviation[2, at] = EAY*w20 - EBY*w18 + EZY + w17
        w21 = cos_c*w5 - sin_c*w6
        w22 = EB0C*w4 + EX0C + w21
        w23 = EBA*w9 - ECA*w14 + EXA + w22
        w24 = cos_a*w9 + sin_a*w14
        w25 = EB0A*w24 - EC0A*w19 + w23
        w26 = q_Az + w24
        w27 = EBY*w26 - ECY*w20 + EXY + w25
        w28 = w20 + y
        deviation[0, at] = -EC0Y*w28 + w27
        w29 = cos_a*w10 - sin_a*w15
        w30 = EC0A*w3 + EY0A + w29
        w31 = -EAY*w26 + ECY*w18 + EYY + w30
        deviation[1, at] = EC0Y*w18 + w31
    return deviation


def workpiece_in_bed_sensitivity(positions, parameters, point):
    """Sensitivity of a workpiece point in the bed frame to every error, at the error-free machine.

    Source: Eqs. (1)-(4), first order. Operations: 133 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z A C [mm, rotary axes deg]
            rows: x y z a c
        parameters (23,): home positions and location errors [mm, rad]
            rows: q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C
                EA0C EB0C EA0Z EB0Z
        point (3, n): point in the workpiece frame [mm]
            rows: rx ry rz

    Returns:
        sensitivity (3, 41, n): derivative of the deviation by each component error, then by each location error [mm/mm, mm/rad]
            rows: dx_EXX dx_EYX .. dz_EB0Z, last index fastest
    """
    n, positions, point = _points(positions=(positions, 5), point=(point, 3))
    parameters = _constant("parameters", parameters, (23,))
    sensitivity = np.zeros((123, n))
    # constants
    q_Ax = float(parameters[0])
    q_Ay = float(parameters[1])
    q_Az = float(parameters[2])
    q_Cx = float(parameters[3])
    q_Cy = float(parameters[4])
    q_Cz = float(parameters[5])
    q_wx = float(parameters[6])
    q_wy = float(parameters[7])
    q_wz = float(parameters[8])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        y = positions[1, at]
        a = positions[3, at]
        c = positions[4, at]
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # cosines and sines
        cos_a = np.cos(0.017453292519943295*a)
        sin_a = np.sin(0.017453292519943295*a)
        cos_c = np.cos(0.017453292519943295*c)
        sin_c = np.sin(0.017453292519943295*c)
        # per point
        w0 = cos_a*q_wz
        w1 = cos_a*rz
        w2 = cos_c*q_wy
        w3 = cos_c*ry
        w4 = q_wx*sin_c
        w5 = rx*sin_c
        w6 = sin_a*w2 + sin_a*w3 + sin_a*w4 + sin_a*w5 + w0 + w1
        sensitivity[33, at] = dx_EB0A = cos_a*q_Cz + q_Cy*sin_a + w6
        sensitivity[10, at] = dx_EBY = dx_EB0A + q_Az
        w7 = q_wz*sin_a
        w8 = rz*sin_a
        sensitivity[119, at] = dz_EA0C = cos_a*w2 + cos_a*w3 + cos_a*w4 + cos_a*w5 - w7 - w8
        sensitivity[103, at] = dz_EAA = cos_a*q_Cy + dz_EA0C - q_Cz*sin_a
        sensitivity[91, at] = dz_EAY = dz_EAA + q_Ay
        sensitivity[38, at] = dx_EB0C = q_wz + rz
        w9 = cos_c*q_wx
        w10 = cos_c*rx
        w11 = q_wy*sin_c
        w12 = ry*sin_c
        sensitivity[75, at] = dy_EC0A = q_Cx + w10 - w11 - w12 + w9
        sensitivity[52, at] = dy_ECY = dy_EC0A + q_Ax
        sensitivity[61, at] = dy_EZA = -sin_a
        sensitivity[79, at] = dy_EB0C = sin_a*w10 - sin_a*w11 - sin_a*w12 + sin_a*w9
        sensitivity[63, at] = dy_EBA = dy_EB0C + q_Cx*sin_a
        sensitivity[70, at] = dy_ECC = cos_a*w10 - cos_a*w11 - cos_a*w12 + cos_a*w9
        sensitivity[64, at] = dy_ECA = cos_a*q_Cx + dy_ECC
        sensitivity[6, at] = 1.0
        sensitivity[11, at] = -dz_EAY
        sensitivity[18, at] = 1.0
        sensitivity[22, at] = dx_EB0C + q_Cz
        w13 = w2 + w3 + w4 + w5
        sensitivity[23, at] = -q_Cy - w13
        sensitivity[24, at] = cos_c
        sensitivity[25, at] = -sin_c
        sensitivity[27, at] = q_wz*sin_c + rz*sin_c
        sensitivity[28, at] = cos_c*q_wz + cos_c*rz
        sensitivity[29, at] = -w13
        sensitivity[30, at] = -dz_EAY - y
        sensitivity[34, at] = -dz_EAA
        sensitivity[35, at] = 1.0
        sensitivity[48, at] = 1.0
        sensitivity[50, at] = -dx_EBY
        sensitivity[60, at] = cos_a
        sensitivity[62, at] = -dx_EB0A
        sensitivity[65, at] = cos_a*sin_c
        sensitivity[66, at] = cos_a*cos_c
        sensitivity[67, at] = dy_EZA
        sensitivity[68, at] = -cos_c*w0 - cos_c*w1 - q_wy*sin_a - ry*sin_a
        sensitivity[69, at] = q_wx*sin_a + rx*sin_a + sin_c*w0 + sin_c*w1
        sensitivity[71, at] = dy_ECY
        sensitivity[72, at] = 1.0
        sensitivity[77, at] = cos_a
        sensitivity[78, at] = -w6
        sensitivity[90, at] = 1.0
        sensitivity[92, at] = -dy_ECY
        sensitivity[101, at] = sin_a
        sensitivity[102, at] = cos_a
        sensitivity[104, at] = -dy_ECA
        sensitivity[105, at] = dy_EBA
        sensitivity[106, at] = sin_a*sin_c
        sensitivity[107, at] = cos_c*sin_a
        sensitivity[108, at] = cos_a
        sensitivity[109, at] = cos_a*q_wy + cos_a*ry - cos_c*w7 - cos_c*w8
        sensitivity[110, at] = -cos_a*q_wx - cos_a*rx + q_wz*sin_a*sin_c + rz*sin_a*sin_c
        sensitivity[111, at] = dy_EB0C
        sensitivity[114, at] = 1.0
        sensitivity[115, at] = -dy_EC0A
        sensitivity[118, at] = sin_a
        sensitivity[120, at] = -dy_ECC
    return sensitivity.reshape(3, 41, n)


def bed_in_workpiece_ideal(positions, parameters, point):
    """Ideal position of a bed point in the workpiece frame.

    Source: Eqs. (1)-(4) without errors. Operations: 63 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z A C [mm, rotary axes deg]
            rows: x y z a c
        parameters (23,): home positions and location errors [mm, rad]
            rows: q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C
                EA0C EB0C EA0Z EB0Z
        point (3, n): point in the bed frame [mm]
            rows: rx ry rz

    Returns:
        ideal (3, n): bed point in the workpiece frame, without errors [mm]
            rows: px py pz
    """
    n, positions, point = _points(positions=(positions, 5), point=(point, 3))
    parameters = _constant("parameters", parameters, (23,))
    ideal = np.zeros((3, n))
    # constants
    q_Ax = float(parameters[0])
    q_Ay = float(parameters[1])
    q_Az = float(parameters[2])
    q_Cx = float(parameters[3])
    q_Cy = float(parameters[4])
    q_Cz = float(parameters[5])
    q_wx = float(parameters[6])
    q_wy = float(parameters[7])
    q_wz = float(parameters[8])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        y = positions[1, at]
        a = positions[3, at]
        c = positions[4, at]
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # cosines and sines
        cos_a = np.cos(0.017453292519943295*a)
        sin_a = np.sin(0.017453292519943295*a)
        cos_c = np.cos(0.017453292519943295*c)
        sin_c = np.sin(0.017453292519943295*c)
        # per point
        w0 = cos_a*sin_c
        ideal[0, at] = cos_a*ry*sin_c - cos_c*q_Ax - cos_c*q_Cx + cos_c*rx - q_Ay*w0 - q_Az*sin_a*sin_c - q_Cy*sin_c - q_wx + rz*sin_a*sin_c - w0*y
        w1 = cos_a*cos_c
        ideal[1, at] = cos_a*cos_c*ry - cos_c*q_Az*sin_a - cos_c*q_Cy + cos_c*rz*sin_a + q_Ax*sin_c - q_Ay*w1 + q_Cx*sin_c - q_wy - rx*sin_c - w1*y
        ideal[2, at] = -cos_a*q_Az + cos_a*rz + q_Ay*sin_a - q_Cz - q_wz - ry*sin_a + sin_a*y
    return ideal


def bed_in_workpiece_deviation(positions, errors, parameters, point):
    """Deviation of a bed point in the workpiece frame, exact.

    Source: Eqs. (1)-(4). Operations: 246 per point, 13 per call.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z A C [mm, rotary axes deg]
            rows: x y z a c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXA EYA EZA EAA EBA
                ECA EXC EYC EZC EAC EBC ECC
        parameters (23,): home positions and location errors [mm, rad]
            rows: q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C
                EA0C EB0C EA0Z EB0Z
        point (3, n): point in the bed frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): bed point in the workpiece frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions, errors, point = _points(positions=(positions, 5), errors=(errors, 30), point=(point, 3))
    parameters = _constant("parameters", parameters, (23,))
    deviation = np.zeros((3, n))
    # constants
    q_Ax = float(parameters[0])
    q_Ay = float(parameters[1])
    q_Az = float(parameters[2])
    q_Cx = float(parameters[3])
    q_Cy = float(parameters[4])
    q_Cz = float(parameters[5])
    EC0Y = float(parameters[12])
    EY0A = float(parameters[13])
    EZ0A = float(parameters[14])
    EB0A = float(parameters[15])
    EC0A = float(parameters[16])
    EX0C = float(parameters[17])
    EY0C = float(parameters[18])
    EA0C = float(parameters[19])
    EB0C = float(parameters[20])
    # once per call
    w8 = (EC0Y*EC0Y)
    w9 = 1.0/(w8 + 1)
    w30 = (EB0A*EB0A) + (EC0A*EC0A)
    w31 = 1.0/(w30 + 1)
    w59 = (EA0C*EA0C) + (EB0C*EB0C)
    w60 = 1.0/(w59 + 1)
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        y = positions[1, at]
        a = positions[3, at]
        c = positions[4, at]
        EXY = errors[6, at]
        EYY = errors[7, at]
        EZY = errors[8, at]
        EAY = errors[9, at]
        EBY = errors[10, at]
        ECY = errors[11, at]
        EXA = errors[18, at]
        EYA = errors[19, at]
        EZA = errors[20, at]
        EAA = errors[21, at]
        EBA = errors[22, at]
        ECA = errors[23, at]
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
        cos_a = np.cos(0.017453292519943295*a)
        sin_a = np.sin(0.017453292519943295*a)
        cos_c = np.cos(0.017453292519943295*c)
        sin_c = np.sin(0.017453292519943295*c)
        # per point
        w0 = -q_Ax + rx
        w1 = -q_Cx + w0
        w2 = ry - y
        w3 = -q_Ay + w2
        w4 = -q_Az + rz
        w5 = cos_a*w3 + sin_a*w4
        w6 = -q_Cy + w5
        w7 = cos_c*w1 + sin_c*w6
        w10 = w9*(EC0Y*ry - rx*w8)
        w11 = -EXY + w10
        w12 = w9*(-EC0Y*rx - ry*w8)
        w13 = -EYY + w12
        w14 = w13 + w2
        w15 = EC0Y*rz
        w16 = w9*(EC0Y*w15 - rz*w8)
        w17 = -EZY + w16
        w18 = rz + w17
        w19 = rx + w11
        w20 = EAY*w19 + EBY*w14 + ECY*w18
        w21 = (EAY*EAY) + (EBY*EBY) + (ECY*ECY)
        w22 = 1.0/(w21 + 1)
        w23 = w22*(EAY*w20 - EBY*w18 + ECY*w14 - rx*w21 + w11)
        w24 = w22*(EAY*w18 + EBY*w20 - ECY*w19 + w13 - w2*w21)
        w25 = -EY0A + w24
        w26 = w25 + w3
        w27 = w22*(-EAY*w14 + EBY*w19 + ECY*w20 - rz*w21 + w17)
        w28 = -EZ0A + w27
        w29 = w28 + w4
        w32 = w31*(-EB0A*w29 + EC0A*w26 - w0*w30 + w23)
        w33 = -EXA + w32
        w34 = w0 + w23
        w35 = EB0A*w26 + EC0A*w29
        w36 = w31*(EB0A*w35 - EC0A*w34 + w25 - w3*w30)
        w37 = w31*(EB0A*w34 + EC0A*w35 + w28 - w30*w4)
        w38 = cos_a*w36 + sin_a*w37
        w39 = -EYA + w38
        w40 = w39 + w5
        w41 = cos_a*w4 - sin_a*w3
        w42 = cos_a*w37 - sin_a*w36
        w43 = -EZA + w42
        w44 = w41 + w43
        w45 = w0 + w33
        w46 = EAA*w45 + EBA*w40 + ECA*w44
        w47 = (EAA*EAA) + (EBA*EBA) + (ECA*ECA)
        w48 = 1.0/(w47 + 1)
        w49 = w48*(EAA*w46 - EBA*w44 + ECA*w40 - w0*w47 + w33)
        w50 = -EX0C + w49
        w51 = w48*(-EAA*w40 + EBA*w45 + ECA*w46 - w41*w47 + w43)
        w52 = -q_Cz + w41
        w53 = w51 + w52
        w54 = w1 + w50
        w55 = w48*(EAA*w44 + EBA*w46 - ECA*w45 + w39 - w47*w5)
        w56 = -EY0C + w55
        w57 = w56 + w6
        w58 = EA0C*w54 + EB0C*w57
        w61 = w60*(EA0C*w58 - EB0C*w53 - w1*w59 + w50)
        w62 = w60*(EA0C*w53 + EB0C*w58 + w56 - w59*w6)
        w63 = cos_c*w61 + sin_c*w62
        w64 = -EXC + w63
        w65 = cos_c*w6 - sin_c*w1
        w66 = cos_c*w62 - sin_c*w61
        w67 = -EYC + w66
        w68 = w65 + w67
        w69 = w60*(-EA0C*w57 + EB0C*w54 + w51 - w52*w59)
        w70 = -EZC + w69
        w71 = w52 + w70
        w72 = w64 + w7
        w73 = EAC*w72 + EBC*w68 + ECC*w71
        w74 = (EAC*EAC) + (EBC*EBC) + (ECC*ECC)
        w75 = 1.0/(w74 + 1)
        deviation[0, at] = w75*(EAC*w73 - EBC*w71 + ECC*w68 + w64 - w7*w74)
        deviation[1, at] = w75*(EAC*w71 + EBC*w73 - ECC*w72 - w65*w74 + w67)
        deviation[2, at] = w75*(-EAC*w68 + EBC*w72 + ECC*w73 - w52*w74 + w70)
    return deviation


def bed_in_workpiece_deviation_first_order(positions, errors, parameters, point):
    """Deviation of a bed point in the workpiece frame, to first order in the errors.

    Source: Eqs. (1)-(4). Operations: 106 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z A C [mm, rotary axes deg]
            rows: x y z a c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXA EYA EZA EAA EBA
                ECA EXC EYC EZC EAC EBC ECC
        parameters (23,): home positions and location errors [mm, rad]
            rows: q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C
                EA0C EB0C EA0Z EB0Z
        point (3, n): point in the bed frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): bed point in the workpiece frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions, errors, point = _points(positions=(positions, 5), errors=(errors, 30), point=(point, 3))
    parameters = _constant("parameters", parameters, (23,))
    deviation = np.zeros((3, n))
    # constants
    q_Ax = float(parameters[0])
    q_Ay = float(parameters[1])
    q_Az = float(parameters[2])
    q_Cx = float(parameters[3])
    q_Cy = float(parameters[4])
    q_Cz = float(parameters[5])
    EC0Y = float(parameters[12])
    EY0A = float(parameters[13])
    EZ0A = float(parameters[14])
    EB0A = float(parameters[15])
    EC0A = float(parameters[16])
    EX0C = float(parameters[17])
    EY0C = float(parameters[18])
    EA0C = float(parameters[19])
    EB0C = float(parameters[20])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        y = positions[1, at]
        a = positions[3, at]
        c = positions[4, at]
        EXY = errors[6, at]
        EYY = errors[7, at]
        EZY = errors[8, at]
        EAY = errors[9, at]
        EBY = errors[10, at]
        ECY = errors[11, at]
        EXA = errors[18, at]
        EYA = errors[19, at]
        EZA = errors[20, at]
        EAA = errors[21, at]
        EBA = errors[22, at]
        ECA = errors[23, at]
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
        cos_a = np.cos(0.017453292519943295*a)
        sin_a = np.sin(0.017453292519943295*a)
        cos_c = np.cos(0.017453292519943295*c)
        sin_c = np.sin(0.017453292519943295*c)
        # per point
        w0 = ry - y
        w1 = -q_Ay + w0
        w2 = -q_Az + rz
        w3 = cos_a*w2 - sin_a*w1
        w4 = -q_Cz + w3
        w5 = -q_Ax + rx
        w6 = -q_Cx + w5
        w7 = cos_a*w1 + sin_a*w2
        w8 = -q_Cy + w7
        w9 = cos_c*w8 - sin_c*w6
        w10 = EC0Y*ry
        w11 = -EBY*rz + ECY*w0 - EXY + w10
        w12 = -EB0A*w2 + EC0A*w1 + w11
        w13 = -EBA*w3 + ECA*w7 - EXA + w12
        w14 = -EB0C*w4 - EX0C + w13
        w15 = -EC0Y*rx
        w16 = EAY*rz - ECY*rx - EYY + w15
        w17 = -EC0A*w5 - EY0A + w16
        w18 = -EAY*w0 + EBY*rx - EZY
        w19 = EB0A*w5 - EZ0A + w18
        w20 = cos_a*w17 + sin_a*w19
        w21 = EAA*w3 - ECA*w5 - EYA + w20
        w22 = EA0C*w4 - EY0C + w21
        w23 = cos_c*w14 + sin_c*w22
        deviation[0, at] = -EBC*w4 + ECC*w9 - EXC + w23
        w24 = cos_c*w6 + sin_c*w8
        w25 = cos_c*w22 - sin_c*w14
        deviation[1, at] = EAC*w4 - ECC*w24 - EYC + w25
        w26 = cos_a*w19 - sin_a*w17
        w27 = -EAA*w7 + EBA*w5 - EZA + w26
        w28 = -EA0C*w8 + EB0C*w6 + w27
        deviation[2, at] = -EAC*w9 + EBC*w24 - EZC + w28
    return deviation


def bed_in_workpiece_sensitivity(positions, parameters, point):
    """Sensitivity of a bed point in the workpiece frame to every error, at the error-free machine.

    Source: Eqs. (1)-(4), first order. Operations: 183 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z A C [mm, rotary axes deg]
            rows: x y z a c
        parameters (23,): home positions and location errors [mm, rad]
            rows: q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C
                EA0C EB0C EA0Z EB0Z
        point (3, n): point in the bed frame [mm]
            rows: rx ry rz

    Returns:
        sensitivity (3, 41, n): derivative of the deviation by each component error, then by each location error [mm/mm, mm/rad]
            rows: dx_EXX dx_EYX .. dz_EB0Z, last index fastest
    """
    n, positions, point = _points(positions=(positions, 5), point=(point, 3))
    parameters = _constant("parameters", parameters, (23,))
    sensitivity = np.zeros((123, n))
    # constants
    q_Ax = float(parameters[0])
    q_Ay = float(parameters[1])
    q_Az = float(parameters[2])
    q_Cx = float(parameters[3])
    q_Cy = float(parameters[4])
    q_Cz = float(parameters[5])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        y = positions[1, at]
        a = positions[3, at]
        c = positions[4, at]
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # cosines and sines
        cos_a = np.cos(0.017453292519943295*a)
        sin_a = np.sin(0.017453292519943295*a)
        cos_c = np.cos(0.017453292519943295*c)
        sin_c = np.sin(0.017453292519943295*c)
        # per point
        sensitivity[6, at] = dx_EXY = -cos_c
        w0 = cos_a*sin_c
        sensitivity[7, at] = dx_EYY = -w0
        w1 = sin_a*sin_c
        sensitivity[8, at] = dx_EZY = -w1
        w2 = ry*w1
        sensitivity[9, at] = dx_EAY = rz*w0 + w1*y - w2
        sensitivity[19, at] = dx_EYA = -sin_c
        w3 = q_Az*w0
        sensitivity[21, at] = dx_EAA = dx_EAY + q_Ay*w1 - w3
        w4 = cos_c*rz
        w5 = cos_a*w4
        w6 = cos_c*y
        w7 = sin_a*w6
        w8 = cos_c*ry*sin_a
        sensitivity[50, at] = dy_EAY = w5 + w7 - w8
        w9 = q_Ay*sin_a
        w10 = cos_c*w9
        w11 = cos_a*q_Az
        w12 = cos_c*w11
        sensitivity[62, at] = dy_EAA = dy_EAY + w10 - w12
        sensitivity[28, at] = dx_EBC = -cos_a*rz + q_Cz + ry*sin_a - sin_a*y + w11 - w9
        w13 = cos_c*q_Ay
        w14 = cos_c*q_Az
        w15 = -cos_a*cos_c*ry + cos_a*w13 + cos_a*w6 - cos_c*rz*sin_a - q_Ax*sin_c + rx*sin_c + sin_a*w14
        sensitivity[109, at] = dz_EAC = cos_c*q_Cy - q_Cx*sin_c + w15
        sensitivity[37, at] = dx_EA0C = cos_a*rz*sin_c + q_Ay*sin_a*sin_c - q_Cz*sin_c + sin_a*sin_c*y - w2 - w3
        sensitivity[38, at] = dx_EB0C = cos_c*q_Cz - w10 + w12 - w5 - w7 + w8
        w16 = cos_a*cos_c
        sensitivity[48, at] = dy_EYY = -w16
        w17 = cos_c*sin_a
        sensitivity[49, at] = dy_EZY = -w17
        sensitivity[64, at] = dy_ECA = cos_c*q_Ax - cos_c*rx + q_Ay*w0 + q_Az*w1 - ry*w0 - rz*w1 + w0*y
        sensitivity[70, at] = dy_ECC = cos_c*q_Cx + dy_ECA + q_Cy*sin_c
        sensitivity[90, at] = dz_EZY = -cos_a
        sensitivity[93, at] = dz_ECY = rx*sin_a
        w18 = cos_a*ry
        w19 = rz*sin_a
        sensitivity[103, at] = dz_EAA = cos_a*q_Ay + cos_a*y + q_Az*sin_a - w18 - w19
        sensitivity[10, at] = rx*sin_a*sin_c - w4
        w20 = -cos_c*ry + rx*w0
        w21 = w20 + w6
        sensitivity[11, at] = -w21
        sensitivity[18, at] = dx_EXY
        sensitivity[22, at] = -dy_EAA
        sensitivity[23, at] = -w15
        sensitivity[24, at] = -1.0
        sensitivity[29, at] = -dz_EAC
        sensitivity[30, at] = -w20
        sensitivity[31, at] = dx_EYY
        sensitivity[32, at] = dx_EZY
        sensitivity[33, at] = -q_Ax*w1 + rx*w1 + w14 - w4
        sensitivity[34, at] = cos_a*q_Ax*sin_c - w13 - w21
        sensitivity[35, at] = dx_EXY
        sensitivity[36, at] = dx_EYA
        sensitivity[47, at] = sin_c
        sensitivity[51, at] = rx*w17 + rz*sin_c
        w22 = ry*sin_c
        w23 = rx*w16
        w24 = w22 + w23
        sensitivity[52, at] = sin_c*y - w24
        sensitivity[59, at] = sin_c
        sensitivity[60, at] = dx_EXY
        sensitivity[63, at] = dx_EAA
        sensitivity[66, at] = -1.0
        sensitivity[68, at] = -dx_EBC
        sensitivity[71, at] = -w24
        sensitivity[72, at] = dy_EYY
        sensitivity[73, at] = dy_EZY
        sensitivity[74, at] = cos_c*rx*sin_a - q_Ax*w17 - q_Az*sin_c + rz*sin_c
        sensitivity[75, at] = q_Ax*w16 + q_Ay*sin_c + sin_c*y - w22 - w23
        sensitivity[76, at] = sin_c
        sensitivity[77, at] = dx_EXY
        sensitivity[78, at] = -dx_EB0C
        sensitivity[79, at] = dx_EA0C
        sensitivity[89, at] = sin_a
        sensitivity[91, at] = cos_a*y - w18 - w19
        sensitivity[92, at] = cos_a*rx
        sensitivity[102, at] = -1.0
        w25 = q_Ax - rx
        sensitivity[104, at] = -w25
        sensitivity[108, at] = -1.0
        sensitivity[110, at] = -dy_ECC
        sensitivity[112, at] = dz_ECY
        sensitivity[113, at] = sin_a
        sensitivity[114, at] = dz_EZY
        sensitivity[115, at] = -cos_a*q_Ax + cos_a*rx
        sensitivity[116, at] = -q_Ax*sin_a + rx*sin_a
        sensitivity[119, at] = dz_EAA + q_Cy
        sensitivity[120, at] = -q_Cx - w25
    return sensitivity.reshape(3, 41, n)


def tool_in_workpiece_position(positions, errors, parameters, point):
    """Actual position of the tool point in the workpiece frame, exact.

    Source: Eq. (4). Operations: 303 per point, 13 per call.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z A C [mm, rotary axes deg]
            rows: x y z a c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXA EYA EZA EAA EBA
                ECA EXC EYC EZC EAC EBC ECC
        parameters (23,): home positions and location errors [mm, rad]
            rows: q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C
                EA0C EB0C EA0Z EB0Z
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        position (3, n): actual position P_T^W of the tool point in the workpiece frame [mm]
            rows: px py pz
    """
    n, positions, errors, point = _points(positions=(positions, 5), errors=(errors, 30), point=(point, 3))
    parameters = _constant("parameters", parameters, (23,))
    position = np.zeros((3, n))
    # constants
    q_Ax = float(parameters[0])
    q_Ay = float(parameters[1])
    q_Az = float(parameters[2])
    q_Cx = float(parameters[3])
    q_Cy = float(parameters[4])
    q_Cz = float(parameters[5])
    q_wx = float(parameters[6])
    q_wy = float(parameters[7])
    q_wz = float(parameters[8])
    q_Tx = float(parameters[9])
    q_Ty = float(parameters[10])
    q_Tz = float(parameters[11])
    EC0Y = float(parameters[12])
    EY0A = float(parameters[13])
    EZ0A = float(parameters[14])
    EB0A = float(parameters[15])
    EC0A = float(parameters[16])
    EX0C = float(parameters[17])
    EY0C = float(parameters[18])
    EA0C = float(parameters[19])
    EB0C = float(parameters[20])
    EA0Z = float(parameters[21])
    EB0Z = float(parameters[22])
    # once per call
    w26 = (EC0Y*EC0Y)
    w27 = 1.0/(w26 + 1)
    w51 = (EB0A*EB0A) + (EC0A*EC0A)
    w52 = 1.0/(w51 + 1)
    w80 = (EA0C*EA0C) + (EB0C*EB0C)
    w81 = 1.0/(w80 + 1)
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        x = positions[0, at]
        y = positions[1, at]
        z = positions[2, at]
        a = positions[3, at]
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
        EXA = errors[18, at]
        EYA = errors[19, at]
        EZA = errors[20, at]
        EAA = errors[21, at]
        EBA = errors[22, at]
        ECA = errors[23, at]
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
        cos_a = np.cos(0.017453292519943295*a)
        sin_a = np.sin(0.017453292519943295*a)
        cos_c = np.cos(0.017453292519943295*c)
        sin_c = np.sin(0.017453292519943295*c)
        # per point
        w0 = q_Tx + rx
        w1 = w0 + x
        w2 = -q_Ax + w1
        w3 = -q_Cx + w2
        w4 = q_Ty + ry
        w5 = w4 - y
        w6 = -q_Ay + w5
        w7 = q_Tz + rz
        w8 = w7 + z
        w9 = -q_Az + w8
        w10 = cos_a*w6 + sin_a*w9
        w11 = -q_Cy + w10
        w12 = cos_c*w3 + sin_c*w11
        w13 = EBZ*w7 - ECZ*w4 + EXZ
        w14 = -EAZ*w7 + ECZ*w0 + EYZ
        w15 = EAZ*w4 - EBZ*w0 + EZZ
        w16 = EA0Z*(w14 + w4) - EB0Z*(w0 + w13) + w15
        w17 = w16 + w8
        w18 = w15 + w8
        w19 = -EA0Z*w18 + w14
        w20 = w19 + w4
        w21 = EB0Z*w18 + w13
        w22 = EBX*w17 - ECX*w20 + EXX + w21
        w23 = w0 + w21
        w24 = -EAX*w17 + ECX*w23 + EYX + w19
        w25 = w24 + w4
        w28 = w27*(EC0Y*w25 - w1*w26 + w22)
        w29 = -EXY + w28
        w30 = w1 + w22
        w31 = w27*(-EC0Y*w30 + w24 - w26*w4)
        w32 = -EYY + w31
        w33 = w32 + w5
        w34 = EAX*w20 - EBX*w23 + EZX + w16
        w35 = w34 + w8
        w36 = EC0Y*w35
        w37 = w27*(EC0Y*w36 - w26*w8 + w34)
        w38 = -EZY + w37
        w39 = w38 + w8
        w40 = w1 + w29
        w41 = EAY*w40 + EBY*w33 + ECY*w39
        w42 = (EAY*EAY) + (EBY*EBY) + (ECY*ECY)
        w43 = 1.0/(w42 + 1)
        w44 = w43*(EAY*w41 - EBY*w39 + ECY*w33 - w1*w42 + w29)
        w45 = w43*(EAY*w39 + EBY*w41 - ECY*w40 + w32 - w42*w5)
        w46 = -EY0A + w45
        w47 = w46 + w6
        w48 = w43*(-EAY*w33 + EBY*w40 + ECY*w41 + w38 - w42*w8)
        w49 = -EZ0A + w48
        w50 = w49 + w9
        w53 = w52*(-EB0A*w50 + EC0A*w47 - w2*w51 + w44)
        w54 = -EXA + w53
        w55 = w2 + w44
        w56 = EB0A*w47 + EC0A*w50
        w57 = w52*(EB0A*w56 - EC0A*w55 + w46 - w51*w6)
        w58 = w52*(EB0A*w55 + EC0A*w56 + w49 - w51*w9)
        w59 = cos_a*w57 + sin_a*w58
        w60 = -EYA + w59
        w61 = w10 + w60
        w62 = cos_a*w9 - sin_a*w6
        w63 = cos_a*w58 - sin_a*w57
        w64 = -EZA + w63
        w65 = w62 + w64
        w66 = w2 + w54
        w67 = EAA*w66 + EBA*w61 + ECA*w65
        w68 = (EAA*EAA) + (EBA*EBA) + (ECA*ECA)
        w69 = 1.0/(w68 + 1)
        w70 = w69*(EAA*w67 - EBA*w65 + ECA*w61 - w2*w68 + w54)
        w71 = -EX0C + w70
        w72 = w69*(-EAA*w61 + EBA*w66 + ECA*w67 - w62*w68 + w64)
        w73 = -q_Cz + w62
        w74 = w72 + w73
        w75 = w3 + w71
        w76 = w69*(EAA*w65 + EBA*w67 - ECA*w66 - w10*w68 + w60)
        w77 = -EY0C + w76
        w78 = w11 + w77
        w79 = EA0C*w75 + EB0C*w78
        w82 = w81*(EA0C*w79 - EB0C*w74 - w3*w80 + w71)
        w83 = w81*(EA0C*w74 + EB0C*w79 - w11*w80 + w77)
        w84 = cos_c*w82 + sin_c*w83
        w85 = -EXC + w84
        w86 = cos_c*w11 - sin_c*w3
        w87 = cos_c*w83 - sin_c*w82
        w88 = -EYC + w87
        w89 = w86 + w88
        w90 = w81*(-EA0C*w78 + EB0C*w75 + w72 - w73*w80)
        w91 = -EZC + w90
        w92 = w73 + w91
        w93 = w12 + w85
        w94 = EAC*w93 + EBC*w89 + ECC*w92
        w95 = (EAC*EAC) + (EBC*EBC) + (ECC*ECC)
        w96 = 1.0/(w95 + 1)
        w97 = w96*(EAC*w94 - EBC*w92 + ECC*w89 - w12*w95 + w85)
        w98 = -q_wx + w12
        position[0, at] = w97 + w98
        w99 = w96*(EAC*w92 + EBC*w94 - ECC*w93 - w86*w95 + w88)
        w100 = -q_wy + w86
        position[1, at] = w100 + w99
        w101 = w96*(-EAC*w89 + EBC*w93 + ECC*w94 - w73*w95 + w91)
        w102 = -q_wz + w73
        position[2, at] = w101 + w102
    return position


def tool_in_workpiece_position_first_order(positions, errors, parameters, point):
    """Actual position of the tool point in the workpiece frame, to first order.

    Source: Eq. (4). Operations: 154 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z A C [mm, rotary axes deg]
            rows: x y z a c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXA EYA EZA EAA EBA
                ECA EXC EYC EZC EAC EBC ECC
        parameters (23,): home positions and location errors [mm, rad]
            rows: q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C
                EA0C EB0C EA0Z EB0Z
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        position (3, n): actual position P_T^W of the tool point in the workpiece frame [mm]
            rows: px py pz
    """
    n, positions, errors, point = _points(positions=(positions, 5), errors=(errors, 30), point=(point, 3))
    parameters = _constant("parameters", parameters, (23,))
    position = np.zeros((3, n))
    # constants
    q_Ax = float(parameters[0])
    q_Ay = float(parameters[1])
    q_Az = float(parameters[2])
    q_Cx = float(parameters[3])
    q_Cy = float(parameters[4])
    q_Cz = float(parameters[5])
    q_wx = float(parameters[6])
    q_wy = float(parameters[7])
    q_wz = float(parameters[8])
    q_Tx = float(parameters[9])
    q_Ty = float(parameters[10])
    q_Tz = float(parameters[11])
    EC0Y = float(parameters[12])
    EY0A = float(parameters[13])
    EZ0A = float(parameters[14])
    EB0A = float(parameters[15])
    EC0A = float(parameters[16])
    EX0C = float(parameters[17])
    EY0C = float(parameters[18])
    EA0C = float(parameters[19])
    EB0C = float(parameters[20])
    EA0Z = float(parameters[21])
    EB0Z = float(parameters[22])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        x = positions[0, at]
        y = positions[1, at]
        z = positions[2, at]
        a = positions[3, at]
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
        EXA = errors[18, at]
        EYA = errors[19, at]
        EZA = errors[20, at]
        EAA = errors[21, at]
        EBA = errors[22, at]
        ECA = errors[23, at]
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
        cos_a = np.cos(0.017453292519943295*a)
        sin_a = np.sin(0.017453292519943295*a)
        cos_c = np.cos(0.017453292519943295*c)
        sin_c = np.sin(0.017453292519943295*c)
        # per point
        w0 = q_Ty + ry
        w1 = w0 - y
        w2 = -q_Ay + w1
        w3 = q_Tz + rz
        w4 = w3 + z
        w5 = -q_Az + w4
        w6 = cos_a*w5 - sin_a*w2
        w7 = -q_Cz + w6
        w8 = q_Tx + rx
        w9 = w8 + x
        w10 = -q_Ax + w9
        w11 = -q_Cx + w10
        w12 = cos_a*w2 + sin_a*w5
        w13 = -q_Cy + w12
        w14 = cos_c*w13 - sin_c*w11
        w15 = EBZ*w3 - ECZ*w0 + EXZ
        w16 = EB0Z*w4 + w15
        w17 = EBX*w4 - ECX*w0 + EXX + w16
        w18 = EC0Y*w0 + w17
        w19 = -EBY*w4 + ECY*w1 - EXY + w18
        w20 = -EB0A*w5 + EC0A*w2 + w19
        w21 = -EBA*w6 + ECA*w12 - EXA + w20
        w22 = -EB0C*w7 - EX0C + w21
        w23 = -EAZ*w3 + ECZ*w8 + EYZ
        w24 = -EA0Z*w4 + w23
        w25 = -EAX*w4 + ECX*w8 + EYX + w24
        w26 = -EC0Y*w9 + w25
        w27 = EAY*w4 - ECY*w9 - EYY + w26
        w28 = -EC0A*w10 - EY0A + w27
        w29 = EAZ*w0 - EBZ*w8 + EZZ
        w30 = EA0Z*w0 - EB0Z*w8 + w29
        w31 = EAX*w0 - EBX*w8 + EZX + w30
        w32 = -EAY*w1 + EBY*w9 - EZY + w31
        w33 = EB0A*w10 - EZ0A + w32
        w34 = cos_a*w28 + sin_a*w33
        w35 = EAA*w6 - ECA*w10 - EYA + w34
        w36 = EA0C*w7 - EY0C + w35
        w37 = cos_c*w22 + sin_c*w36
        w38 = -EBC*w7 + ECC*w14 - EXC + w37
        w39 = cos_c*w11 + sin_c*w13
        w40 = -q_wx + w39
        position[0, at] = w38 + w40
        w41 = cos_c*w36 - sin_c*w22
        w42 = EAC*w7 - ECC*w39 - EYC + w41
        w43 = -q_wy + w14
        position[1, at] = w42 + w43
        w44 = cos_a*w33 - sin_a*w28
        w45 = -EAA*w12 + EBA*w10 - EZA + w44
        w46 = -EA0C*w13 + EB0C*w11 + w45
        w47 = -EAC*w14 + EBC*w39 - EZC + w46
        w48 = -q_wz + w7
        position[2, at] = w47 + w48
    return position


def tool_orientation_ideal(positions, direction):
    """Ideal direction of a vector of the tool frame in the workpiece frame.

    Source: Eqs. (1)-(4) without errors, rotations alone. Operations: 20 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z A C [mm, rotary axes deg]
            rows: x y z a c
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
        a = positions[3, at]
        c = positions[4, at]
        tx = direction[0, at]
        ty = direction[1, at]
        tz = direction[2, at]
        # cosines and sines
        cos_a = np.cos(0.017453292519943295*a)
        sin_a = np.sin(0.017453292519943295*a)
        cos_c = np.cos(0.017453292519943295*c)
        sin_c = np.sin(0.017453292519943295*c)
        # per point
        ideal[2, at] = cos_a*tz - sin_a*ty
        w0 = cos_a*ty + sin_a*tz
        ideal[0, at] = cos_c*tx + sin_c*w0
        ideal[1, at] = cos_c*w0 - sin_c*tx
    return ideal


def tool_orientation_deviation(positions, errors, parameters, direction):
    """Deviation of a direction of the tool frame in the workpiece frame, exact.

    Source: Eqs. (1)-(4), rotations alone. Operations: 266 per point, 13 per call.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z A C [mm, rotary axes deg]
            rows: x y z a c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXA EYA EZA EAA EBA
                ECA EXC EYC EZC EAC EBC ECC
        parameters (23,): home positions and location errors [mm, rad]
            rows: q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C
                EA0C EB0C EA0Z EB0Z
        direction (3, n): unit vector in the tool frame, (0, 0, 1) for the tool axis [1]
            rows: tx ty tz

    Returns:
        deviation (3, n): the vector in the workpiece frame, actual minus ideal [1]
            rows: dx dy dz
    """
    n, positions, errors, direction = _points(positions=(positions, 5), errors=(errors, 30), direction=(direction, 3))
    parameters = _constant("parameters", parameters, (23,))
    deviation = np.zeros((3, n))
    # constants
    EC0Y = float(parameters[12])
    EB0A = float(parameters[15])
    EC0A = float(parameters[16])
    EA0C = float(parameters[19])
    EB0C = float(parameters[20])
    EA0Z = float(parameters[21])
    EB0Z = float(parameters[22])
    # once per call
    w15 = (EC0Y*EC0Y)
    w16 = 1.0/(w15 + 1)
    w35 = (EB0A*EB0A) + (EC0A*EC0A)
    w36 = 1.0/(w35 + 1)
    w58 = (EA0C*EA0C) + (EB0C*EB0C)
    w59 = 1.0/(w58 + 1)
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        a = positions[3, at]
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
        EAA = errors[21, at]
        EBA = errors[22, at]
        ECA = errors[23, at]
        EAC = errors[27, at]
        EBC = errors[28, at]
        ECC = errors[29, at]
        tx = direction[0, at]
        ty = direction[1, at]
        tz = direction[2, at]
        # cosines and sines
        cos_a = np.cos(0.017453292519943295*a)
        sin_a = np.sin(0.017453292519943295*a)
        cos_c = np.cos(0.017453292519943295*c)
        sin_c = np.sin(0.017453292519943295*c)
        # per point
        w0 = cos_a*ty + sin_a*tz
        w1 = cos_c*tx + sin_c*w0
        w2 = EBZ*tz - ECZ*ty
        w3 = -EAZ*tz + ECZ*tx
        w4 = EAZ*ty - EBZ*tx
        w5 = EA0Z*(ty + w3) - EB0Z*(tx + w2) + w4
        w6 = tz + w5
        w7 = tz + w4
        w8 = -EA0Z*w7 + w3
        w9 = ty + w8
        w10 = EB0Z*w7 + w2
        w11 = EBX*w6 - ECX*w9 + w10
        w12 = tx + w10
        w13 = -EAX*w6 + ECX*w12 + w8
        w14 = ty + w13
        w17 = w16*(EC0Y*w14 - tx*w15 + w11)
        w18 = tx + w11
        w19 = w16*(-EC0Y*w18 - ty*w15 + w13)
        w20 = ty + w19
        w21 = EAX*w9 - EBX*w12 + w5
        w22 = tz + w21
        w23 = EC0Y*w22
        w24 = w16*(EC0Y*w23 - tz*w15 + w21)
        w25 = tz + w24
        w26 = tx + w17
        w27 = EAY*w26 + EBY*w20 + ECY*w25
        w28 = (EAY*EAY) + (EBY*EBY) + (ECY*ECY)
        w29 = 1.0/(w28 + 1)
        w30 = w29*(EAY*w27 - EBY*w25 + ECY*w20 - tx*w28 + w17)
        w31 = w29*(EAY*w25 + EBY*w27 - ECY*w26 - ty*w28 + w19)
        w32 = ty + w31
        w33 = w29*(-EAY*w20 + EBY*w26 + ECY*w27 - tz*w28 + w24)
        w34 = tz + w33
        w37 = w36*(-EB0A*w34 + EC0A*w32 - tx*w35 + w30)
        w38 = tx + w30
        w39 = EB0A*w32 + EC0A*w34
        w40 = w36*(EB0A*w39 - EC0A*w38 - ty*w35 + w31)
        w41 = w36*(EB0A*w38 + EC0A*w39 - tz*w35 + w33)
        w42 = cos_a*w40 + sin_a*w41
        w43 = w0 + w42
        w44 = cos_a*tz - sin_a*ty
        w45 = cos_a*w41 - sin_a*w40
        w46 = w44 + w45
        w47 = tx + w37
        w48 = EAA*w47 + EBA*w43 + ECA*w46
        w49 = (EAA*EAA) + (EBA*EBA) + (ECA*ECA)
        w50 = 1.0/(w49 + 1)
        w51 = w50*(EAA*w48 - EBA*w46 + ECA*w43 - tx*w49 + w37)
        w52 = w50*(-EAA*w43 + EBA*w47 + ECA*w48 - w44*w49 + w45)
        w53 = w44 + w52
        w54 = tx + w51
        w55 = w50*(EAA*w46 + EBA*w48 - ECA*w47 - w0*w49 + w42)
        w56 = w0 + w55
        w57 = EA0C*w54 + EB0C*w56
        w60 = w59*(EA0C*w57 - EB0C*w53 - tx*w58 + w51)
        w61 = w59*(EA0C*w53 + EB0C*w57 - w0*w58 + w55)
        w62 = cos_c*w60 + sin_c*w61
        w63 = cos_c*w0 - sin_c*tx
        w64 = cos_c*w61 - sin_c*w60
        w65 = w63 + w64
        w66 = w59*(-EA0C*w56 + EB0C*w54 - w44*w58 + w52)
        w67 = w44 + w66
        w68 = w1 + w62
        w69 = EAC*w68 + EBC*w65 + ECC*w67
        w70 = (EAC*EAC) + (EBC*EBC) + (ECC*ECC)
        w71 = 1.0/(w70 + 1)
        deviation[0, at] = w71*(EAC*w69 - EBC*w67 + ECC*w65 - w1*w70 + w62)
        deviation[1, at] = w71*(EAC*w67 + EBC*w69 - ECC*w68 - w63*w70 + w64)
        deviation[2, at] = w71*(-EAC*w65 + EBC*w68 + ECC*w69 - w44*w70 + w66)
    return deviation


def tool_orientation_deviation_first_order(positions, errors, parameters, direction):
    """Deviation of a direction of the tool frame in the workpiece frame, to first order.

    Source: Eqs. (1)-(4), rotations alone. Operations: 117 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z A C [mm, rotary axes deg]
            rows: x y z a c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXA EYA EZA EAA EBA
                ECA EXC EYC EZC EAC EBC ECC
        parameters (23,): home positions and location errors [mm, rad]
            rows: q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C
                EA0C EB0C EA0Z EB0Z
        direction (3, n): unit vector in the tool frame, (0, 0, 1) for the tool axis [1]
            rows: tx ty tz

    Returns:
        deviation (3, n): the vector in the workpiece frame, actual minus ideal [1]
            rows: dx dy dz
    """
    n, positions, errors, direction = _points(positions=(positions, 5), errors=(errors, 30), direction=(direction, 3))
    parameters = _constant("parameters", parameters, (23,))
    deviation = np.zeros((3, n))
    # constants
    EC0Y = float(parameters[12])
    EB0A = float(parameters[15])
    EC0A = float(parameters[16])
    EA0C = float(parameters[19])
    EB0C = float(parameters[20])
    EA0Z = float(parameters[21])
    EB0Z = float(parameters[22])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        a = positions[3, at]
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
        EAA = errors[21, at]
        EBA = errors[22, at]
        ECA = errors[23, at]
        EAC = errors[27, at]
        EBC = errors[28, at]
        ECC = errors[29, at]
        tx = direction[0, at]
        ty = direction[1, at]
        tz = direction[2, at]
        # cosines and sines
        cos_a = np.cos(0.017453292519943295*a)
        sin_a = np.sin(0.017453292519943295*a)
        cos_c = np.cos(0.017453292519943295*c)
        sin_c = np.sin(0.017453292519943295*c)
        # per point
        w0 = cos_a*tz - sin_a*ty
        w1 = cos_a*ty + sin_a*tz
        w2 = cos_c*w1 - sin_c*tx
        w3 = EBZ*tz - ECZ*ty
        w4 = EB0Z*tz + w3
        w5 = EBX*tz - ECX*ty + w4
        w6 = EC0Y*ty + w5
        w7 = -EBY*tz + ECY*ty + w6
        w8 = -EB0A*tz + EC0A*ty + w7
        w9 = -EBA*w0 + ECA*w1 + w8
        w10 = -EB0C*w0 + w9
        w11 = -EAZ*tz + ECZ*tx
        w12 = -EA0Z*tz + w11
        w13 = -EAX*tz + ECX*tx + w12
        w14 = -EC0Y*tx + w13
        w15 = EAY*tz - ECY*tx + w14
        w16 = -EC0A*tx + w15
        w17 = EAZ*ty - EBZ*tx
        w18 = EA0Z*ty - EB0Z*tx + w17
        w19 = EAX*ty - EBX*tx + w18
        w20 = -EAY*ty + EBY*tx + w19
        w21 = EB0A*tx + w20
        w22 = cos_a*w16 + sin_a*w21
        w23 = EAA*w0 - ECA*tx + w22
        w24 = EA0C*w0 + w23
        w25 = cos_c*w10 + sin_c*w24
        deviation[0, at] = -EBC*w0 + ECC*w2 + w25
        w26 = cos_c*tx + sin_c*w1
        w27 = cos_c*w24 - sin_c*w10
        deviation[1, at] = EAC*w0 - ECC*w26 + w27
        w28 = cos_a*w21 - sin_a*w16
        w29 = -EAA*w1 + EBA*tx + w28
        w30 = -EA0C*w1 + EB0C*tx + w29
        deviation[2, at] = -EAC*w2 + EBC*w26 + w30
    return deviation


def tool_in_workpiece_deviation_curves(positions, curves, parameters, point):
    """Deviation of the tool point under polynomial error curves, exact.

    Source: Eqs. (1)-(4), (44). Operations: 684 per point, 16 per call.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z A C [mm, rotary axes deg]
            rows: x y z a c
        curves (30, 7): coefficients of the powers 1 to 7 of the axis position, per component error [mm/mm^k, rad/mm^k (deg^k for rotary axes)]
            rows: EXX_1 EXX_2 .. ECC_7, last index fastest
        parameters (23,): home positions and location errors [mm, rad]
            rows: q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C
                EA0C EB0C EA0Z EB0Z
        point (3,): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): tool point in the workpiece frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions = _points(positions=(positions, 5))
    curves = _constant("curves", curves, (30, 7))
    parameters = _constant("parameters", parameters, (23,))
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
    EXA_1 = float(curves[18, 0])
    EXA_2 = float(curves[18, 1])
    EXA_3 = float(curves[18, 2])
    EXA_4 = float(curves[18, 3])
    EXA_5 = float(curves[18, 4])
    EXA_6 = float(curves[18, 5])
    EXA_7 = float(curves[18, 6])
    EYA_1 = float(curves[19, 0])
    EYA_2 = float(curves[19, 1])
    EYA_3 = float(curves[19, 2])
    EYA_4 = float(curves[19, 3])
    EYA_5 = float(curves[19, 4])
    EYA_6 = float(curves[19, 5])
    EYA_7 = float(curves[19, 6])
    EZA_1 = float(curves[20, 0])
    EZA_2 = float(curves[20, 1])
    EZA_3 = float(curves[20, 2])
    EZA_4 = float(curves[20, 3])
    EZA_5 = float(curves[20, 4])
    EZA_6 = float(curves[20, 5])
    EZA_7 = float(curves[20, 6])
    EAA_1 = float(curves[21, 0])
    EAA_2 = float(curves[21, 1])
    EAA_3 = float(curves[21, 2])
    EAA_4 = float(curves[21, 3])
    EAA_5 = float(curves[21, 4])
    EAA_6 = float(curves[21, 5])
    EAA_7 = float(curves[21, 6])
    EBA_1 = float(curves[22, 0])
    EBA_2 = float(curves[22, 1])
    EBA_3 = float(curves[22, 2])
    EBA_4 = float(curves[22, 3])
    EBA_5 = float(curves[22, 4])
    EBA_6 = float(curves[22, 5])
    EBA_7 = float(curves[22, 6])
    ECA_1 = float(curves[23, 0])
    ECA_2 = float(curves[23, 1])
    ECA_3 = float(curves[23, 2])
    ECA_4 = float(curves[23, 3])
    ECA_5 = float(curves[23, 4])
    ECA_6 = float(curves[23, 5])
    ECA_7 = float(curves[23, 6])
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
    q_Ax = float(parameters[0])
    q_Ay = float(parameters[1])
    q_Az = float(parameters[2])
    q_Cx = float(parameters[3])
    q_Cy = float(parameters[4])
    q_Cz = float(parameters[5])
    q_Tx = float(parameters[9])
    q_Ty = float(parameters[10])
    q_Tz = float(parameters[11])
    EC0Y = float(parameters[12])
    EY0A = float(parameters[13])
    EZ0A = float(parameters[14])
    EB0A = float(parameters[15])
    EC0A = float(parameters[16])
    EX0C = float(parameters[17])
    EY0C = float(parameters[18])
    EA0C = float(parameters[19])
    EB0C = float(parameters[20])
    EA0Z = float(parameters[21])
    EB0Z = float(parameters[22])
    rx = float(point[0])
    ry = float(point[1])
    rz = float(point[2])
    # once per call
    w3 = q_Tx + rx
    w7 = q_Ty + ry
    w10 = q_Tz + rz
    w49 = (EC0Y*EC0Y)
    w50 = 1.0/(w49 + 1)
    w77 = (EB0A*EB0A) + (EC0A*EC0A)
    w78 = 1.0/(w77 + 1)
    w108 = (EA0C*EA0C) + (EB0C*EB0C)
    w109 = 1.0/(w108 + 1)
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        x = positions[0, at]
        y = positions[1, at]
        z = positions[2, at]
        a = positions[3, at]
        c = positions[4, at]
        # cosines and sines
        cos_a = np.cos(0.017453292519943295*a)
        sin_a = np.sin(0.017453292519943295*a)
        cos_c = np.cos(0.017453292519943295*c)
        sin_c = np.sin(0.017453292519943295*c)
        # per point
        w0 = _polynomial(c, EAC_1, EAC_2, EAC_3, EAC_4, EAC_5, EAC_6, EAC_7)
        w1 = _polynomial(c, EBC_1, EBC_2, EBC_3, EBC_4, EBC_5, EBC_6, EBC_7)
        w2 = _polynomial(c, ECC_1, ECC_2, ECC_3, ECC_4, ECC_5, ECC_6, ECC_7)
        w4 = w3 + x
        w5 = -q_Ax + w4
        w6 = -q_Cx + w5
        w8 = w7 - y
        w9 = -q_Ay + w8
        w11 = w10 + z
        w12 = -q_Az + w11
        w13 = cos_a*w9 + sin_a*w12
        w14 = -q_Cy + w13
        w15 = cos_c*w6 + sin_c*w14
        w16 = _polynomial(c, EXC_1, EXC_2, EXC_3, EXC_4, EXC_5, EXC_6, EXC_7)
        w17 = _polynomial(a, EAA_1, EAA_2, EAA_3, EAA_4, EAA_5, EAA_6, EAA_7)
        w18 = _polynomial(a, EBA_1, EBA_2, EBA_3, EBA_4, EBA_5, EBA_6, EBA_7)
        w19 = _polynomial(a, ECA_1, ECA_2, ECA_3, ECA_4, ECA_5, ECA_6, ECA_7)
        w20 = _polynomial(a, EXA_1, EXA_2, EXA_3, EXA_4, EXA_5, EXA_6, EXA_7)
        w21 = _polynomial(y, EAY_1, EAY_2, EAY_3, EAY_4, EAY_5, EAY_6, EAY_7)
        w22 = _polynomial(y, EBY_1, EBY_2, EBY_3, EBY_4, EBY_5, EBY_6, EBY_7)
        w23 = _polynomial(y, ECY_1, ECY_2, ECY_3, ECY_4, ECY_5, ECY_6, ECY_7)
        w24 = _polynomial(y, EXY_1, EXY_2, EXY_3, EXY_4, EXY_5, EXY_6, EXY_7)
        w25 = _polynomial(z, EXZ_1, EXZ_2, EXZ_3, EXZ_4, EXZ_5, EXZ_6, EXZ_7)
        w26 = _polynomial(z, EBZ_1, EBZ_2, EBZ_3, EBZ_4, EBZ_5, EBZ_6, EBZ_7)
        w27 = _polynomial(z, ECZ_1, ECZ_2, ECZ_3, ECZ_4, ECZ_5, ECZ_6, ECZ_7)
        w28 = w10*w26 + w25 - w27*w7
        w29 = _polynomial(z, EYZ_1, EYZ_2, EYZ_3, EYZ_4, EYZ_5, EYZ_6, EYZ_7)
        w30 = _polynomial(z, EAZ_1, EAZ_2, EAZ_3, EAZ_4, EAZ_5, EAZ_6, EAZ_7)
        w31 = -w10*w30 + w27*w3 + w29
        w32 = _polynomial(z, EZZ_1, EZZ_2, EZZ_3, EZZ_4, EZZ_5, EZZ_6, EZZ_7)
        w33 = -w26*w3 + w30*w7 + w32
        w34 = EA0Z*(w31 + w7) - EB0Z*(w28 + w3) + w33
        w35 = w11 + w34
        w36 = w11 + w33
        w37 = -EA0Z*w36 + w31
        w38 = w37 + w7
        w39 = _polynomial(x, EXX_1, EXX_2, EXX_3, EXX_4, EXX_5, EXX_6, EXX_7)
        w40 = _polynomial(x, EBX_1, EBX_2, EBX_3, EBX_4, EBX_5, EBX_6, EBX_7)
        w41 = _polynomial(x, ECX_1, ECX_2, ECX_3, ECX_4, ECX_5, ECX_6, ECX_7)
        w42 = EB0Z*w36 + w28
        w43 = w35*w40 - w38*w41 + w39 + w42
        w44 = w3 + w42
        w45 = _polynomial(x, EYX_1, EYX_2, EYX_3, EYX_4, EYX_5, EYX_6, EYX_7)
        w46 = _polynomial(x, EAX_1, EAX_2, EAX_3, EAX_4, EAX_5, EAX_6, EAX_7)
        w47 = -w35*w46 + w37 + w41*w44 + w45
        w48 = w47 + w7
        w51 = w50*(EC0Y*w48 - w4*w49 + w43)
        w52 = -w24 + w51
        w53 = _polynomial(y, EYY_1, EYY_2, EYY_3, EYY_4, EYY_5, EYY_6, EYY_7)
        w54 = w4 + w43
        w55 = w50*(-EC0Y*w54 + w47 - w49*w7)
        w56 = -w53 + w55
        w57 = w56 + w8
        w58 = _polynomial(y, EZY_1, EZY_2, EZY_3, EZY_4, EZY_5, EZY_6, EZY_7)
        w59 = _polynomial(x, EZX_1, EZX_2, EZX_3, EZX_4, EZX_5, EZX_6, EZX_7)
        w60 = w34 + w38*w46 - w40*w44 + w59
        w61 = w11 + w60
        w62 = EC0Y*w61
        w63 = w50*(EC0Y*w62 - w11*w49 + w60)
        w64 = -w58 + w63
        w65 = w11 + w64
        w66 = w4 + w52
        w67 = w21*w66 + w22*w57 + w23*w65
        w68 = (w21*w21) + (w22*w22) + (w23*w23)
        w69 = 1.0/(w68 + 1)
        w70 = w69*(w21*w67 - w22*w65 + w23*w57 - w4*w68 + w52)
        w71 = w69*(w21*w65 + w22*w67 - w23*w66 + w56 - w68*w8)
        w72 = -EY0A + w71
        w73 = w72 + w9
        w74 = w69*(-w11*w68 - w21*w57 + w22*w66 + w23*w67 + w64)
        w75 = -EZ0A + w74
        w76 = w12 + w75
        w79 = w78*(-EB0A*w76 + EC0A*w73 - w5*w77 + w70)
        w80 = -w20 + w79
        w81 = _polynomial(a, EYA_1, EYA_2, EYA_3, EYA_4, EYA_5, EYA_6, EYA_7)
        w82 = w5 + w70
        w83 = EB0A*w73 + EC0A*w76
        w84 = w78*(EB0A*w83 - EC0A*w82 + w72 - w77*w9)
        w85 = w78*(EB0A*w82 + EC0A*w83 - w12*w77 + w75)
        w86 = cos_a*w84 + sin_a*w85
        w87 = -w81 + w86
        w88 = w13 + w87
        w89 = cos_a*w12 - sin_a*w9
        w90 = _polynomial(a, EZA_1, EZA_2, EZA_3, EZA_4, EZA_5, EZA_6, EZA_7)
        w91 = cos_a*w85 - sin_a*w84
        w92 = -w90 + w91
        w93 = w89 + w92
        w94 = w5 + w80
        w95 = w17*w94 + w18*w88 + w19*w93
        w96 = (w17*w17) + (w18*w18) + (w19*w19)
        w97 = 1.0/(w96 + 1)
        w98 = w97*(w17*w95 - w18*w93 + w19*w88 - w5*w96 + w80)
        w99 = -EX0C + w98
        w100 = w97*(-w17*w88 + w18*w94 + w19*w95 - w89*w96 + w92)
        w101 = -q_Cz + w89
        w102 = w100 + w101
        w103 = w6 + w99
        w104 = w97*(-w13*w96 + w17*w93 + w18*w95 - w19*w94 + w87)
        w105 = -EY0C + w104
        w106 = w105 + w14
        w107 = EA0C*w103 + EB0C*w106
        w110 = w109*(EA0C*w107 - EB0C*w102 - w108*w6 + w99)
        w111 = w109*(EA0C*w102 + EB0C*w107 + w105 - w108*w14)
        w112 = cos_c*w110 + sin_c*w111
        w113 = w112 - w16
        w114 = cos_c*w14 - sin_c*w6
        w115 = _polynomial(c, EYC_1, EYC_2, EYC_3, EYC_4, EYC_5, EYC_6, EYC_7)
        w116 = cos_c*w111 - sin_c*w110
        w117 = -w115 + w116
        w118 = w114 + w117
        w119 = _polynomial(c, EZC_1, EZC_2, EZC_3, EZC_4, EZC_5, EZC_6, EZC_7)
        w120 = w109*(-EA0C*w106 + EB0C*w103 + w100 - w101*w108)
        w121 = -w119 + w120
        w122 = w101 + w121
        w123 = w113 + w15
        w124 = w0*w123 + w1*w118 + w122*w2
        w125 = (w0*w0) + (w1*w1) + (w2*w2)
        w126 = 1.0/(w125 + 1)
        deviation[0, at] = w126*(w0*w124 - w1*w122 + w113 + w118*w2 - w125*w15)
        deviation[1, at] = w126*(w0*w122 + w1*w124 - w114*w125 + w117 - w123*w2)
        deviation[2, at] = w126*(-w0*w118 + w1*w123 - w101*w125 + w121 + w124*w2)
    return deviation


def tool_in_workpiece_deviation_first_order_curves(positions, curves, parameters, point):
    """Deviation of the tool point under polynomial error curves, to first order.

    Source: Eqs. (1)-(4), (44). Operations: 535 per point, 3 per call.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z A C [mm, rotary axes deg]
            rows: x y z a c
        curves (30, 7): coefficients of the powers 1 to 7 of the axis position, per component error [mm/mm^k, rad/mm^k (deg^k for rotary axes)]
            rows: EXX_1 EXX_2 .. ECC_7, last index fastest
        parameters (23,): home positions and location errors [mm, rad]
            rows: q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C
                EA0C EB0C EA0Z EB0Z
        point (3,): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): tool point in the workpiece frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions = _points(positions=(positions, 5))
    curves = _constant("curves", curves, (30, 7))
    parameters = _constant("parameters", parameters, (23,))
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
    EXA_1 = float(curves[18, 0])
    EXA_2 = float(curves[18, 1])
    EXA_3 = float(curves[18, 2])
    EXA_4 = float(curves[18, 3])
    EXA_5 = float(curves[18, 4])
    EXA_6 = float(curves[18, 5])
    EXA_7 = float(curves[18, 6])
    EYA_1 = float(curves[19, 0])
    EYA_2 = float(curves[19, 1])
    EYA_3 = float(curves[19, 2])
    EYA_4 = float(curves[19, 3])
    EYA_5 = float(curves[19, 4])
    EYA_6 = float(curves[19, 5])
    EYA_7 = float(curves[19, 6])
    EZA_1 = float(curves[20, 0])
    EZA_2 = float(curves[20, 1])
    EZA_3 = float(curves[20, 2])
    EZA_4 = float(curves[20, 3])
    EZA_5 = float(curves[20, 4])
    EZA_6 = float(curves[20, 5])
    EZA_7 = float(curves[20, 6])
    EAA_1 = float(curves[21, 0])
    EAA_2 = float(curves[21, 1])
    EAA_3 = float(curves[21, 2])
    EAA_4 = float(curves[21, 3])
    EAA_5 = float(curves[21, 4])
    EAA_6 = float(curves[21, 5])
    EAA_7 = float(curves[21, 6])
    EBA_1 = float(curves[22, 0])
    EBA_2 = float(curves[22, 1])
    EBA_3 = float(curves[22, 2])
    EBA_4 = float(curves[22, 3])
    EBA_5 = float(curves[22, 4])
    EBA_6 = float(curves[22, 5])
    EBA_7 = float(curves[22, 6])
    ECA_1 = float(curves[23, 0])
    ECA_2 = float(curves[23, 1])
    ECA_3 = float(curves[23, 2])
    ECA_4 = float(curves[23, 3])
    ECA_5 = float(curves[23, 4])
    ECA_6 = float(curves[23, 5])
    ECA_7 = float(curves[23, 6])
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
    q_Ax = float(parameters[0])
    q_Ay = float(parameters[1])
    q_Az = float(parameters[2])
    q_Cx = float(parameters[3])
    q_Cy = float(parameters[4])
    q_Cz = float(parameters[5])
    q_Tx = float(parameters[9])
    q_Ty = float(parameters[10])
    q_Tz = float(parameters[11])
    EC0Y = float(parameters[12])
    EY0A = float(parameters[13])
    EZ0A = float(parameters[14])
    EB0A = float(parameters[15])
    EC0A = float(parameters[16])
    EX0C = float(parameters[17])
    EY0C = float(parameters[18])
    EA0C = float(parameters[19])
    EB0C = float(parameters[20])
    EA0Z = float(parameters[21])
    EB0Z = float(parameters[22])
    rx = float(point[0])
    ry = float(point[1])
    rz = float(point[2])
    # once per call
    w3 = q_Ty + ry
    w6 = q_Tz + rz
    w11 = q_Tx + rx
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        x = positions[0, at]
        y = positions[1, at]
        z = positions[2, at]
        a = positions[3, at]
        c = positions[4, at]
        # cosines and sines
        cos_a = np.cos(0.017453292519943295*a)
        sin_a = np.sin(0.017453292519943295*a)
        cos_c = np.cos(0.017453292519943295*c)
        sin_c = np.sin(0.017453292519943295*c)
        # per point
        w0 = _polynomial(c, EXC_1, EXC_2, EXC_3, EXC_4, EXC_5, EXC_6, EXC_7)
        w1 = _polynomial(c, EBC_1, EBC_2, EBC_3, EBC_4, EBC_5, EBC_6, EBC_7)
        w2 = _polynomial(c, ECC_1, ECC_2, ECC_3, ECC_4, ECC_5, ECC_6, ECC_7)
        w4 = w3 - y
        w5 = -q_Ay + w4
        w7 = w6 + z
        w8 = -q_Az + w7
        w9 = cos_a*w8 - sin_a*w5
        w10 = -q_Cz + w9
        w12 = w11 + x
        w13 = -q_Ax + w12
        w14 = -q_Cx + w13
        w15 = cos_a*w5 + sin_a*w8
        w16 = -q_Cy + w15
        w17 = cos_c*w16 - sin_c*w14
        w18 = _polynomial(a, EXA_1, EXA_2, EXA_3, EXA_4, EXA_5, EXA_6, EXA_7)
        w19 = _polynomial(a, EBA_1, EBA_2, EBA_3, EBA_4, EBA_5, EBA_6, EBA_7)
        w20 = _polynomial(a, ECA_1, ECA_2, ECA_3, ECA_4, ECA_5, ECA_6, ECA_7)
        w21 = _polynomial(y, EXY_1, EXY_2, EXY_3, EXY_4, EXY_5, EXY_6, EXY_7)
        w22 = _polynomial(y, EBY_1, EBY_2, EBY_3, EBY_4, EBY_5, EBY_6, EBY_7)
        w23 = _polynomial(y, ECY_1, ECY_2, ECY_3, ECY_4, ECY_5, ECY_6, ECY_7)
        w24 = _polynomial(x, EXX_1, EXX_2, EXX_3, EXX_4, EXX_5, EXX_6, EXX_7)
        w25 = _polynomial(x, EBX_1, EBX_2, EBX_3, EBX_4, EBX_5, EBX_6, EBX_7)
        w26 = _polynomial(x, ECX_1, ECX_2, ECX_3, ECX_4, ECX_5, ECX_6, ECX_7)
        w27 = _polynomial(z, EXZ_1, EXZ_2, EXZ_3, EXZ_4, EXZ_5, EXZ_6, EXZ_7)
        w28 = _polynomial(z, EBZ_1, EBZ_2, EBZ_3, EBZ_4, EBZ_5, EBZ_6, EBZ_7)
        w29 = _polynomial(z, ECZ_1, ECZ_2, ECZ_3, ECZ_4, ECZ_5, ECZ_6, ECZ_7)
        w30 = w27 + w28*w6 - w29*w3
        w31 = EB0Z*w7 + w30
        w32 = w24 + w25*w7 - w26*w3 + w31
        w33 = EC0Y*w3 + w32
        w34 = -w21 - w22*w7 + w23*w4 + w33
        w35 = -EB0A*w8 + EC0A*w5 + w34
        w36 = w15*w20 - w18 - w19*w9 + w35
        w37 = -EB0C*w10 - EX0C + w36
        w38 = _polynomial(a, EYA_1, EYA_2, EYA_3, EYA_4, EYA_5, EYA_6, EYA_7)
        w39 = _polynomial(a, EAA_1, EAA_2, EAA_3, EAA_4, EAA_5, EAA_6, EAA_7)
        w40 = _polynomial(y, EYY_1, EYY_2, EYY_3, EYY_4, EYY_5, EYY_6, EYY_7)
        w41 = _polynomial(y, EAY_1, EAY_2, EAY_3, EAY_4, EAY_5, EAY_6, EAY_7)
        w42 = _polynomial(x, EYX_1, EYX_2, EYX_3, EYX_4, EYX_5, EYX_6, EYX_7)
        w43 = _polynomial(x, EAX_1, EAX_2, EAX_3, EAX_4, EAX_5, EAX_6, EAX_7)
        w44 = _polynomial(z, EYZ_1, EYZ_2, EYZ_3, EYZ_4, EYZ_5, EYZ_6, EYZ_7)
        w45 = _polynomial(z, EAZ_1, EAZ_2, EAZ_3, EAZ_4, EAZ_5, EAZ_6, EAZ_7)
        w46 = w11*w29 + w44 - w45*w6
        w47 = -EA0Z*w7 + w46
        w48 = w11*w26 + w42 - w43*w7 + w47
        w49 = -EC0Y*w12 + w48
        w50 = -w12*w23 - w40 + w41*w7 + w49
        w51 = -EC0A*w13 - EY0A + w50
        w52 = _polynomial(y, EZY_1, EZY_2, EZY_3, EZY_4, EZY_5, EZY_6, EZY_7)
        w53 = _polynomial(x, EZX_1, EZX_2, EZX_3, EZX_4, EZX_5, EZX_6, EZX_7)
        w54 = _polynomial(z, EZZ_1, EZZ_2, EZZ_3, EZZ_4, EZZ_5, EZZ_6, EZZ_7)
        w55 = -w11*w28 + w3*w45 + w54
        w56 = EA0Z*w3 - EB0Z*w11 + w55
        w57 = -w11*w25 + w3*w43 + w53 + w56
        w58 = w12*w22 - w4*w41 - w52 + w57
        w59 = EB0A*w13 - EZ0A + w58
        w60 = cos_a*w51 + sin_a*w59
        w61 = -w13*w20 - w38 + w39*w9 + w60
        w62 = EA0C*w10 - EY0C + w61
        w63 = cos_c*w37 + sin_c*w62
        deviation[0, at] = -w0 - w1*w10 + w17*w2 + w63
        w64 = _polynomial(c, EYC_1, EYC_2, EYC_3, EYC_4, EYC_5, EYC_6, EYC_7)
        w65 = _polynomial(c, EAC_1, EAC_2, EAC_3, EAC_4, EAC_5, EAC_6, EAC_7)
        w66 = cos_c*w14 + sin_c*w16
        w67 = cos_c*w62 - sin_c*w37
        deviation[1, at] = w10*w65 - w2*w66 - w64 + w67
        w68 = _polynomial(c, EZC_1, EZC_2, EZC_3, EZC_4, EZC_5, EZC_6, EZC_7)
        w69 = _polynomial(a, EZA_1, EZA_2, EZA_3, EZA_4, EZA_5, EZA_6, EZA_7)
        w70 = cos_a*w59 - sin_a*w51
        w71 = w13*w19 - w15*w39 - w69 + w70
        w72 = -EA0C*w16 + EB0C*w14 + w71
        deviation[2, at] = w1*w66 - w17*w65 - w68 + w72
    return deviation


def ballbar_error(positions, errors, parameters, point, ball, length):
    """Positioning error of a ball bar between a tool ball and a workpiece ball, exact.

    Source: Eqs. (5), (6). Operations: 336 per point, 13 per call.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z A C [mm, rotary axes deg]
            rows: x y z a c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXA EYA EZA EAA EBA
                ECA EXC EYC EZC EAC EBC ECC
        parameters (23,): home positions and location errors [mm, rad]
            rows: q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C
                EA0C EB0C EA0Z EB0Z
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
    parameters = _constant("parameters", parameters, (23,))
    error = np.zeros((4, n))
    # constants
    q_Ax = float(parameters[0])
    q_Ay = float(parameters[1])
    q_Az = float(parameters[2])
    q_Cx = float(parameters[3])
    q_Cy = float(parameters[4])
    q_Cz = float(parameters[5])
    q_wx = float(parameters[6])
    q_wy = float(parameters[7])
    q_wz = float(parameters[8])
    q_Tx = float(parameters[9])
    q_Ty = float(parameters[10])
    q_Tz = float(parameters[11])
    EC0Y = float(parameters[12])
    EY0A = float(parameters[13])
    EZ0A = float(parameters[14])
    EB0A = float(parameters[15])
    EC0A = float(parameters[16])
    EX0C = float(parameters[17])
    EY0C = float(parameters[18])
    EA0C = float(parameters[19])
    EB0C = float(parameters[20])
    EA0Z = float(parameters[21])
    EB0Z = float(parameters[22])
    # once per call
    w26 = (EC0Y*EC0Y)
    w27 = 1.0/(w26 + 1)
    w51 = (EB0A*EB0A) + (EC0A*EC0A)
    w52 = 1.0/(w51 + 1)
    w80 = (EA0C*EA0C) + (EB0C*EB0C)
    w81 = 1.0/(w80 + 1)
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        x = positions[0, at]
        y = positions[1, at]
        z = positions[2, at]
        a = positions[3, at]
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
        EXA = errors[18, at]
        EYA = errors[19, at]
        EZA = errors[20, at]
        EAA = errors[21, at]
        EBA = errors[22, at]
        ECA = errors[23, at]
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
        cos_a = np.cos(0.017453292519943295*a)
        sin_a = np.sin(0.017453292519943295*a)
        cos_c = np.cos(0.017453292519943295*c)
        sin_c = np.sin(0.017453292519943295*c)
        # per point
        w0 = q_Tx + rx
        w1 = w0 + x
        w2 = -q_Ax + w1
        w3 = -q_Cx + w2
        w4 = q_Ty + ry
        w5 = w4 - y
        w6 = -q_Ay + w5
        w7 = q_Tz + rz
        w8 = w7 + z
        w9 = -q_Az + w8
        w10 = cos_a*w6 + sin_a*w9
        w11 = -q_Cy + w10
        w12 = cos_c*w3 + sin_c*w11
        w13 = EBZ*w7 - ECZ*w4 + EXZ
        w14 = -EAZ*w7 + ECZ*w0 + EYZ
        w15 = EAZ*w4 - EBZ*w0 + EZZ
        w16 = EA0Z*(w14 + w4) - EB0Z*(w0 + w13) + w15
        w17 = w16 + w8
        w18 = w15 + w8
        w19 = -EA0Z*w18 + w14
        w20 = w19 + w4
        w21 = EB0Z*w18 + w13
        w22 = EBX*w17 - ECX*w20 + EXX + w21
        w23 = w0 + w21
        w24 = -EAX*w17 + ECX*w23 + EYX + w19
        w25 = w24 + w4
        w28 = w27*(EC0Y*w25 - w1*w26 + w22)
        w29 = -EXY + w28
        w30 = w1 + w22
        w31 = w27*(-EC0Y*w30 + w24 - w26*w4)
        w32 = -EYY + w31
        w33 = w32 + w5
        w34 = EAX*w20 - EBX*w23 + EZX + w16
        w35 = w34 + w8
        w36 = EC0Y*w35
        w37 = w27*(EC0Y*w36 - w26*w8 + w34)
        w38 = -EZY + w37
        w39 = w38 + w8
        w40 = w1 + w29
        w41 = EAY*w40 + EBY*w33 + ECY*w39
        w42 = (EAY*EAY) + (EBY*EBY) + (ECY*ECY)
        w43 = 1.0/(w42 + 1)
        w44 = w43*(EAY*w41 - EBY*w39 + ECY*w33 - w1*w42 + w29)
        w45 = w43*(EAY*w39 + EBY*w41 - ECY*w40 + w32 - w42*w5)
        w46 = -EY0A + w45
        w47 = w46 + w6
        w48 = w43*(-EAY*w33 + EBY*w40 + ECY*w41 + w38 - w42*w8)
        w49 = -EZ0A + w48
        w50 = w49 + w9
        w53 = w52*(-EB0A*w50 + EC0A*w47 - w2*w51 + w44)
        w54 = -EXA + w53
        w55 = w2 + w44
        w56 = EB0A*w47 + EC0A*w50
        w57 = w52*(EB0A*w56 - EC0A*w55 + w46 - w51*w6)
        w58 = w52*(EB0A*w55 + EC0A*w56 + w49 - w51*w9)
        w59 = cos_a*w57 + sin_a*w58
        w60 = -EYA + w59
        w61 = w10 + w60
        w62 = cos_a*w9 - sin_a*w6
        w63 = cos_a*w58 - sin_a*w57
        w64 = -EZA + w63
        w65 = w62 + w64
        w66 = w2 + w54
        w67 = EAA*w66 + EBA*w61 + ECA*w65
        w68 = (EAA*EAA) + (EBA*EBA) + (ECA*ECA)
        w69 = 1.0/(w68 + 1)
        w70 = w69*(EAA*w67 - EBA*w65 + ECA*w61 - w2*w68 + w54)
        w71 = -EX0C + w70
        w72 = w69*(-EAA*w61 + EBA*w66 + ECA*w67 - w62*w68 + w64)
        w73 = -q_Cz + w62
        w74 = w72 + w73
        w75 = w3 + w71
        w76 = w69*(EAA*w65 + EBA*w67 - ECA*w66 - w10*w68 + w60)
        w77 = -EY0C + w76
        w78 = w11 + w77
        w79 = EA0C*w75 + EB0C*w78
        w82 = w81*(EA0C*w79 - EB0C*w74 - w3*w80 + w71)
        w83 = w81*(EA0C*w74 + EB0C*w79 - w11*w80 + w77)
        w84 = cos_c*w82 + sin_c*w83
        w85 = -EXC + w84
        w86 = cos_c*w11 - sin_c*w3
        w87 = cos_c*w83 - sin_c*w82
        w88 = -EYC + w87
        w89 = w86 + w88
        w90 = w81*(-EA0C*w78 + EB0C*w75 + w72 - w73*w80)
        w91 = -EZC + w90
        w92 = w73 + w91
        w93 = w12 + w85
        w94 = EAC*w93 + EBC*w89 + ECC*w92
        w95 = (EAC*EAC) + (EBC*EBC) + (ECC*ECC)
        w96 = 1.0/(w95 + 1)
        w97 = w96*(EAC*w94 - EBC*w92 + ECC*w89 - w12*w95 + w85)
        w98 = w96*(EAC*w92 + EBC*w94 - ECC*w93 - w86*w95 + w88)
        w99 = w96*(-EAC*w89 + EBC*w93 + ECC*w94 - w73*w95 + w91)
        w100 = -q_wx + w12
        w101 = -bx + w100
        w102 = -q_wy + w86
        w103 = -by + w102
        w104 = -q_wz + w73
        w105 = -bz + w104
        w106 = w101 + w97
        w107 = w103 + w98
        w108 = w105 + w99
        w109 = np.sqrt((w101*w101) + (w103*w103) + (w105*w105))
        w110 = np.sqrt((w106*w106) + (w107*w107) + (w108*w108))
        error[0, at] = e = -length_ + w109 + (w97*(w101 + w106) + w98*(w103 + w107) + w99*(w105 + w108))/(w109 + w110)
        w111 = e/w110
        error[1, at] = w106*w111
        error[2, at] = w107*w111
        error[3, at] = w108*w111
    return error


def correction(positions, deviation):
    """Moves of the linear axes that displace the ideal tool point by the given vector.

    Source: Eqs. (53)-(55), inverse. Operations: 23 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z A C [mm, rotary axes deg]
            rows: x y z a c
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
        a = positions[3, at]
        c = positions[4, at]
        dx = deviation[0, at]
        dy = deviation[1, at]
        dz = deviation[2, at]
        # cosines and sines
        cos_a = np.cos(0.017453292519943295*a)
        sin_a = np.sin(0.017453292519943295*a)
        cos_c = np.cos(0.017453292519943295*c)
        sin_c = np.sin(0.017453292519943295*c)
        # per point
        moves[0, at] = cos_c*dx - dy*sin_c
        w0 = cos_c*dy
        w1 = dx*sin_c
        moves[1, at] = -cos_a*w0 - cos_a*w1 + dz*sin_a
        moves[2, at] = cos_a*dz + sin_a*w0 + sin_a*w1
    return moves


def motion_X(positions, errors, parameters, tool_point):
    """Motion equation of X: displacement of the tool point since home, to first order.

    Source: Eqs. (7)-(11). Operations: 16 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z A C [mm, rotary axes deg]
            rows: x y z a c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXA EYA EZA EAA EBA
                ECA EXC EYC EZC EAC EBC ECC
        parameters (23,): home positions and location errors [mm, rad]
            rows: q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C
                EA0C EB0C EA0Z EB0Z
        tool_point (3, n): point in the tool frame [mm]
            rows: rTx rTy rTz

    Returns:
        displacement (3, n): tool point, displacement since home, in the bed frame [mm]
            rows: dx dy dz
    """
    n, positions, errors, tool_point = _points(positions=(positions, 5), errors=(errors, 30), tool_point=(tool_point, 3))
    parameters = _constant("parameters", parameters, (23,))
    displacement = np.zeros((3, n))
    # constants
    q_Tx = float(parameters[9])
    q_Ty = float(parameters[10])
    q_Tz = float(parameters[11])
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
        w0 = q_Tz + rTz
        w1 = q_Ty + rTy
        displacement[0, at] = EBX*w0 - ECX*w1 + EXX + x
        w2 = q_Tx + rTx
        displacement[1, at] = -EAX*w0 + ECX*w2 + EYX
        displacement[2, at] = EAX*w1 - EBX*w2 + EZX
    return displacement


def motion_Y(positions, errors, parameters, workpiece_point):
    """Motion equation of Y: displacement of the workpiece point since home, to first order.

    Source: Eqs. (7)-(11). Operations: 24 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z A C [mm, rotary axes deg]
            rows: x y z a c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXA EYA EZA EAA EBA
                ECA EXC EYC EZC EAC EBC ECC
        parameters (23,): home positions and location errors [mm, rad]
            rows: q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C
                EA0C EB0C EA0Z EB0Z
        workpiece_point (3, n): point in the workpiece frame [mm]
            rows: rWx rWy rWz

    Returns:
        displacement (3, n): workpiece point, displacement since home, in the bed frame [mm]
            rows: dx dy dz
    """
    n, positions, errors, workpiece_point = _points(positions=(positions, 5), errors=(errors, 30), workpiece_point=(workpiece_point, 3))
    parameters = _constant("parameters", parameters, (23,))
    displacement = np.zeros((3, n))
    # constants
    q_Ax = float(parameters[0])
    q_Ay = float(parameters[1])
    q_Az = float(parameters[2])
    q_Cx = float(parameters[3])
    q_Cy = float(parameters[4])
    q_Cz = float(parameters[5])
    q_wx = float(parameters[6])
    q_wy = float(parameters[7])
    q_wz = float(parameters[8])
    EC0Y = float(parameters[12])
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
        w0 = q_Az + q_Cz + q_wz + rWz
        w1 = q_Ay + q_Cy + q_wy + rWy
        displacement[0, at] = EBY*w0 - EC0Y*y - ECY*w1 + EXY
        w2 = q_Ax + q_Cx + q_wx + rWx
        displacement[1, at] = -EAY*w0 + ECY*w2 + EYY + y
        displacement[2, at] = EAY*w1 - EBY*w2 + EZY
    return displacement


def motion_Z(positions, errors, parameters, tool_point):
    """Motion equation of Z: displacement of the tool point since home, to first order.

    Source: Eqs. (7)-(11). Operations: 20 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z A C [mm, rotary axes deg]
            rows: x y z a c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXA EYA EZA EAA EBA
                ECA EXC EYC EZC EAC EBC ECC
        parameters (23,): home positions and location errors [mm, rad]
            rows: q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C
                EA0C EB0C EA0Z EB0Z
        tool_point (3, n): point in the tool frame [mm]
            rows: rTx rTy rTz

    Returns:
        displacement (3, n): tool point, displacement since home, in the bed frame [mm]
            rows: dx dy dz
    """
    n, positions, errors, tool_point = _points(positions=(positions, 5), errors=(errors, 30), tool_point=(tool_point, 3))
    parameters = _constant("parameters", parameters, (23,))
    displacement = np.zeros((3, n))
    # constants
    q_Tx = float(parameters[9])
    q_Ty = float(parameters[10])
    q_Tz = float(parameters[11])
    EA0Z = float(parameters[21])
    EB0Z = float(parameters[22])
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
        w0 = q_Tz + rTz
        w1 = q_Ty + rTy
        displacement[0, at] = EB0Z*z + EBZ*w0 - ECZ*w1 + EXZ
        w2 = q_Tx + rTx
        displacement[1, at] = -EA0Z*z - EAZ*w0 + ECZ*w2 + EYZ
        displacement[2, at] = EAZ*w1 - EBZ*w2 + EZZ + z
    return displacement


def motion_A(positions, errors, parameters, workpiece_point):
    """Motion equation of A: displacement of the workpiece point since home, to first order.

    Source: Eqs. (7)-(11). Operations: 101 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z A C [mm, rotary axes deg]
            rows: x y z a c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXA EYA EZA EAA EBA
                ECA EXC EYC EZC EAC EBC ECC
        parameters (23,): home positions and location errors [mm, rad]
            rows: q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C
                EA0C EB0C EA0Z EB0Z
        workpiece_point (3, n): point in the workpiece frame [mm]
            rows: rWx rWy rWz

    Returns:
        displacement (3, n): workpiece point, displacement since home, in the bed frame [mm]
            rows: dx dy dz
    """
    n, positions, errors, workpiece_point = _points(positions=(positions, 5), errors=(errors, 30), workpiece_point=(workpiece_point, 3))
    parameters = _constant("parameters", parameters, (23,))
    displacement = np.zeros((3, n))
    # constants
    q_Cx = float(parameters[3])
    q_Cy = float(parameters[4])
    q_Cz = float(parameters[5])
    q_wx = float(parameters[6])
    q_wy = float(parameters[7])
    q_wz = float(parameters[8])
    EC0Y = float(parameters[12])
    EB0A = float(parameters[15])
    EC0A = float(parameters[16])
    EY0C = float(parameters[18])
    EA0C = float(parameters[19])
    EB0C = float(parameters[20])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        a = positions[3, at]
        EXA = errors[18, at]
        EYA = errors[19, at]
        EZA = errors[20, at]
        EAA = errors[21, at]
        EBA = errors[22, at]
        ECA = errors[23, at]
        rWx = workpiece_point[0, at]
        rWy = workpiece_point[1, at]
        rWz = workpiece_point[2, at]
        # cosines and sines
        cos_a = np.cos(0.017453292519943295*a)
        sin_a = np.sin(0.017453292519943295*a)
        # per point
        w0 = q_wy + rWy
        w1 = q_Cy + w0
        w2 = q_Cz*sin_a
        w3 = cos_a*q_Cy
        w4 = q_wz*sin_a
        w5 = rWz*sin_a
        w6 = cos_a*q_wy
        w7 = cos_a*rWy
        w8 = w4 + w5 - w6 - w7
        w9 = w1 + w2 - w3 + w8
        w10 = cos_a*q_wz + cos_a*rWz + q_wy*sin_a + rWy*sin_a
        w11 = -q_wz - rWz + w10
        w12 = cos_a*q_Cz + q_Cy*sin_a
        w13 = -q_Cz + w11 + w12
        displacement[0, at] = EB0A*w13 + EBA*(q_Cz + q_wz + rWz) + EC0A*w9 + EC0Y*w9 - ECA*w1 + EXA
        w14 = q_wx*sin_a + rWx*sin_a
        w15 = q_Cx*sin_a + w14
        w16 = cos_a*q_wx + cos_a*rWx
        w17 = cos_a*q_Cx + w16
        w18 = -w2 + w3 - w4 - w5 + w6 + w7
        displacement[1, at] = -EA0C*w11 + EAA*(-w10 - w12) + EB0C*w14 + EBA*w15 + ECA*w17 + EY0C*(cos_a - 1) + EYA*cos_a - EZA*sin_a - q_Cy - q_wy - rWy + w18
        displacement[2, at] = EA0C*(-w0 - w8) + EAA*w18 + EB0C*(q_wx + rWx - w16) - EBA*w17 + ECA*w15 + EY0C*sin_a + EYA*sin_a + EZA*cos_a + w13
    return displacement


def motion_C(positions, errors, parameters, workpiece_point):
    """Motion equation of C: displacement of the workpiece point since home, to first order.

    Source: Eqs. (7)-(11). Operations: 76 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z A C [mm, rotary axes deg]
            rows: x y z a c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXA EYA EZA EAA EBA
                ECA EXC EYC EZC EAC EBC ECC
        parameters (23,): home positions and location errors [mm, rad]
            rows: q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C
                EA0C EB0C EA0Z EB0Z
        workpiece_point (3, n): point in the workpiece frame [mm]
            rows: rWx rWy rWz

    Returns:
        displacement (3, n): workpiece point, displacement since home, in the bed frame [mm]
            rows: dx dy dz
    """
    n, positions, errors, workpiece_point = _points(positions=(positions, 5), errors=(errors, 30), workpiece_point=(workpiece_point, 3))
    parameters = _constant("parameters", parameters, (23,))
    displacement = np.zeros((3, n))
    # constants
    q_wx = float(parameters[6])
    q_wy = float(parameters[7])
    q_wz = float(parameters[8])
    EC0Y = float(parameters[12])
    EB0A = float(parameters[15])
    EC0A = float(parameters[16])
    EA0C = float(parameters[19])
    EB0C = float(parameters[20])
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
        w3 = -q_wy - rWy + w2
        w4 = -w3
        w5 = q_wy*sin_c
        w6 = rWy*sin_c
        w7 = cos_c*q_wx + cos_c*rWx - w5 - w6
        displacement[0, at] = EAC*w0 + EBC*w1 + EC0A*w4 + EC0Y*w4 - ECC*w2 + EXC*cos_c - EYC*sin_c - q_wx - rWx + w7
        w8 = q_wx + rWx
        w9 = -cos_c*q_wx - cos_c*rWx + w5 + w6 + w8
        w10 = -w9
        displacement[1, at] = -EAC*w1 + EBC*w0 + EC0A*w10 + EC0Y*w10 + ECC*w7 + EXC*sin_c + EYC*cos_c + w3
        displacement[2, at] = EA0C*w3 + EAC*(q_wy + rWy) + EB0A*w9 + EB0C*w9 - EBC*w8 + EZC
    return displacement


def motion_XY(positions, errors, parameters, workpiece_point, tool_point):
    """Motion equation of X and Y: displacement of the workpiece point minus tool point since home, to first order.

    Source: Eqs. (7)-(11). Operations: 43 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z A C [mm, rotary axes deg]
            rows: x y z a c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXA EYA EZA EAA EBA
                ECA EXC EYC EZC EAC EBC ECC
        parameters (23,): home positions and location errors [mm, rad]
            rows: q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C
                EA0C EB0C EA0Z EB0Z
        workpiece_point (3, n): point in the workpiece frame [mm]
            rows: rWx rWy rWz
        tool_point (3, n): point in the tool frame [mm]
            rows: rTx rTy rTz

    Returns:
        displacement (3, n): workpiece point minus tool point, displacement since home, in the bed frame [mm]
            rows: dx dy dz
    """
    n, positions, errors, workpiece_point, tool_point = _points(positions=(positions, 5), errors=(errors, 30), workpiece_point=(workpiece_point, 3), tool_point=(tool_point, 3))
    parameters = _constant("parameters", parameters, (23,))
    displacement = np.zeros((3, n))
    # constants
    q_Ax = float(parameters[0])
    q_Ay = float(parameters[1])
    q_Az = float(parameters[2])
    q_Cx = float(parameters[3])
    q_Cy = float(parameters[4])
    q_Cz = float(parameters[5])
    q_wx = float(parameters[6])
    q_wy = float(parameters[7])
    q_wz = float(parameters[8])
    q_Tx = float(parameters[9])
    q_Ty = float(parameters[10])
    q_Tz = float(parameters[11])
    EC0Y = float(parameters[12])
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
        w0 = q_Ty + rTy
        w1 = q_Az + q_Cz + q_wz + rWz
        w2 = q_Tz + rTz
        w3 = q_Ay + q_Cy + q_wy + rWy
        displacement[0, at] = -EBX*w2 + EBY*w1 - EC0Y*y + ECX*w0 - ECY*w3 - EXX + EXY - x
        w4 = q_Ax + q_Cx + q_wx + rWx
        w5 = q_Tx + rTx
        displacement[1, at] = EAX*w2 - EAY*w1 - ECX*w5 + ECY*w4 - EYX + EYY + y
        displacement[2, at] = -EAX*w0 + EAY*w3 + EBX*w5 - EBY*w4 - EZX + EZY
    return displacement


def motion_XZ(positions, errors, parameters, tool_point):
    """Motion equation of X and Z: displacement of the tool point since home, to first order.

    Source: Eqs. (7)-(11). Operations: 39 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z A C [mm, rotary axes deg]
            rows: x y z a c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXA EYA EZA EAA EBA
                ECA EXC EYC EZC EAC EBC ECC
        parameters (23,): home positions and location errors [mm, rad]
            rows: q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C
                EA0C EB0C EA0Z EB0Z
        tool_point (3, n): point in the tool frame [mm]
            rows: rTx rTy rTz

    Returns:
        displacement (3, n): tool point, displacement since home, in the bed frame [mm]
            rows: dx dy dz
    """
    n, positions, errors, tool_point = _points(positions=(positions, 5), errors=(errors, 30), tool_point=(tool_point, 3))
    parameters = _constant("parameters", parameters, (23,))
    displacement = np.zeros((3, n))
    # constants
    q_Tx = float(parameters[9])
    q_Ty = float(parameters[10])
    q_Tz = float(parameters[11])
    EA0Z = float(parameters[21])
    EB0Z = float(parameters[22])
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
        w0 = q_Tz + rTz
        w1 = w0 + z
        w2 = q_Ty + rTy
        w3 = -w2
        displacement[0, at] = EB0Z*z + EBX*w1 + EBZ*w0 + ECX*w3 + ECZ*w3 + EXX + EXZ + x
        w4 = q_Tx + rTx
        displacement[1, at] = -EA0Z*z - EAX*w1 - EAZ*w0 + ECX*w4 + ECZ*w4 + EYX + EYZ
        w5 = -w4
        displacement[2, at] = EAX*w2 + EAZ*w2 + EBX*w5 + EBZ*w5 + EZX + EZZ + z
    return displacement


def motion_YZ(positions, errors, parameters, workpiece_point, tool_point):
    """Motion equation of Y and Z: displacement of the workpiece point minus tool point since home, to first order.

    Source: Eqs. (7)-(11). Operations: 47 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z A C [mm, rotary axes deg]
            rows: x y z a c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXA EYA EZA EAA EBA
                ECA EXC EYC EZC EAC EBC ECC
        parameters (23,): home positions and location errors [mm, rad]
            rows: q_Ax q_Ay q_Az q_Cx q_Cy q_Cz q_wx q_wy q_wz q_Tx q_Ty q_Tz EC0Y EY0A EZ0A EB0A EC0A EX0C EY0C
                EA0C EB0C EA0Z EB0Z
        workpiece_point (3, n): point in the workpiece frame [mm]
            rows: rWx rWy rWz
        tool_point (3, n): point in the tool frame [mm]
            rows: rTx rTy rTz

    Returns:
        displacement (3, n): workpiece point minus tool point, displacement since home, in the bed frame [mm]
            rows: dx dy dz
    """
    n, positions, errors, workpiece_point, tool_point = _points(positions=(positions, 5), errors=(errors, 30), workpiece_point=(workpiece_point, 3), tool_point=(tool_point, 3))
    parameters = _constant("parameters", parameters, (23,))
    displacement = np.zeros((3, n))
    # constants
    q_Ax = float(parameters[0])
    q_Ay = float(parameters[1])
    q_Az = float(parameters[2])
    q_Cx = float(parameters[3])
    q_Cy = float(parameters[4])
    q_Cz = float(parameters[5])
    q_wx = float(parameters[6])
    q_wy = float(parameters[7])
    q_wz = float(parameters[8])
    q_Tx = float(parameters[9])
    q_Ty = float(parameters[10])
    q_Tz = float(parameters[11])
    EC0Y = float(parameters[12])
    EA0Z = float(parameters[21])
    EB0Z = float(parameters[22])
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
        w0 = q_Ty + rTy
        w1 = q_Az + q_Cz + q_wz + rWz
        w2 = q_Tz + rTz
        w3 = q_Ay + q_Cy + q_wy + rWy
        displacement[0, at] = -EB0Z*z + EBY*w1 - EBZ*w2 - EC0Y*y - ECY*w3 + ECZ*w0 + EXY - EXZ
        w4 = q_Ax + q_Cx + q_wx + rWx
        w5 = q_Tx + rTx
        displacement[1, at] = EA0Z*z - EAY*w1 + EAZ*w2 + ECY*w4 - ECZ*w5 + EYY - EYZ + y
        displacement[2, at] = EAY*w3 - EAZ*w0 - EBY*w4 + EBZ*w5 + EZY - EZZ - z
    return displacement
