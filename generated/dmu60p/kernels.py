# Generated from machines/dmu60p.toml, do not edit; regenerate with: trueaxis derive machines/dmu60p.toml
# SPDX-License-Identifier: MIT
"""Kernels of DECKEL MAHO DMU60P, translational axes: geometric error model in NumPy.

Arrays are float64 with the quantity first and the point last: positions (n_axes, n), errors (n_components, n),
deviation (3, n). An array that is the same at all points may have n = 1. Lengths mm, angles rad.
An array of another shape is a ValueError that names it.

Equations after: Prediction and compensation of geometric error for translational axes in multi-axis machine tools
"""

import numpy as np

ABI = 3
SPEC_HASH = "0190651706d05e74f47ba63b348c7b25aa718138f26d87af62dcbb754cacd8ee"

META = {
    'machine': 'dmu60p',
    'title': 'DECKEL MAHO DMU60P, translational axes',
    'axes': ['X', 'Y', 'Z'],
    'position_units': ['mm', 'mm', 'mm'],
    'travel': {'X': [0.0, 540.0], 'Y': [0.0, 700.0], 'Z': [0.0, 600.0]},
    'components': [
        'EXX', 'EYX', 'EZX', 'EAX', 'EBX', 'ECX', 'EXY', 'EYY', 'EZY', 'EAY', 'EBY', 'ECY', 'EXZ', 'EYZ', 'EZZ',
        'EAZ', 'EBZ', 'ECZ',
    ],
    'component_units': [
        'mm', 'mm', 'mm', 'rad', 'rad', 'rad', 'mm', 'mm', 'mm', 'rad', 'rad', 'rad', 'mm', 'mm', 'mm', 'rad', 'rad',
        'rad',
    ],
    'component_descriptions': [
        'positioning error of X', 'straightness error of X in Y', 'straightness error of X in Z', 'roll error of X',
        'angular error of X about Y (pitch or yaw)', 'angular error of X about Z (pitch or yaw)',
        'straightness error of Y in X', 'positioning error of Y', 'straightness error of Y in Z',
        'angular error of Y about X (pitch or yaw)', 'roll error of Y', 'angular error of Y about Z (pitch or yaw)',
        'straightness error of Z in X', 'straightness error of Z in Y', 'positioning error of Z',
        'angular error of Z about X (pitch or yaw)', 'angular error of Z about Y (pitch or yaw)', 'roll error of Z',
    ],
    'parameters': ['q_wx', 'q_wy', 'q_wz', 'q_Tx', 'q_Ty', 'q_Tz', 'eps_xy', 'eps_yz', 'eps_xz'],
    'parameter_units': ['mm', 'mm', 'mm', 'mm', 'mm', 'mm', 'rad', 'rad', 'rad'],
    'parameter_descriptions': [
        'home position along X, body 4 (workpiece) on body 2', 'home position along Y, body 4 (workpiece) on body 2',
        'home position along Z, body 4 (workpiece) on body 2', 'home position along X, body 9 (tool) on body 6',
        'home position along Y, body 9 (tool) on body 6', 'home position along Z, body 9 (tool) on body 6',
        'location error: squareness error of X to Y, about Z; X slide carriage on the bed',
        'location error: squareness error of Z to Y, about X; Z slide carriage on X slide carriage',
        'location error: squareness error of Z to X, about Y; Z slide carriage on X slide carriage',
    ],
    'dimensions': ['q_wx', 'q_wy', 'q_wz', 'q_Tx', 'q_Ty', 'q_Tz'],
    'location_errors': ['eps_xy', 'eps_yz', 'eps_xz'],
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
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'parameters', 'shape': [9], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'ideal', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 9,
            'operations_per_call': 0,
        },
        'tool_in_workpiece_deviation': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [9], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 98,
            'operations_per_call': 0,
        },
        'tool_in_workpiece_deviation_first_order': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [9], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 60,
            'operations_per_call': 0,
        },
        'tool_in_workpiece_sensitivity': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'parameters', 'shape': [9], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'sensitivity', 'shape': [3, 21], 'per_point': True, 'unit': 'mm/mm, mm/rad'}],
            'operations': 15,
            'operations_per_call': 0,
        },
        'tool_in_bed_ideal': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'parameters', 'shape': [9], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'ideal', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 5,
            'operations_per_call': 0,
        },
        'tool_in_bed_deviation': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [9], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 52,
            'operations_per_call': 0,
        },
        'tool_in_bed_deviation_first_order': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [9], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 44,
            'operations_per_call': 0,
        },
        'tool_in_bed_sensitivity': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'parameters', 'shape': [9], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'sensitivity', 'shape': [3, 21], 'per_point': True, 'unit': 'mm/mm, mm/rad'}],
            'operations': 9,
            'operations_per_call': 0,
        },
        'workpiece_in_bed_ideal': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'parameters', 'shape': [9], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'ideal', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 4,
            'operations_per_call': 0,
        },
        'workpiece_in_bed_deviation': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [9], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 15,
            'operations_per_call': 0,
        },
        'workpiece_in_bed_deviation_first_order': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [9], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 15,
            'operations_per_call': 0,
        },
        'workpiece_in_bed_sensitivity': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'parameters', 'shape': [9], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'sensitivity', 'shape': [3, 21], 'per_point': True, 'unit': 'mm/mm, mm/rad'}],
            'operations': 6,
            'operations_per_call': 0,
        },
        'bed_in_workpiece_ideal': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'parameters', 'shape': [9], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'ideal', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 4,
            'operations_per_call': 0,
        },
        'bed_in_workpiece_deviation': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [9], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 47,
            'operations_per_call': 0,
        },
        'bed_in_workpiece_deviation_first_order': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [9], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 13,
            'operations_per_call': 0,
        },
        'bed_in_workpiece_sensitivity': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'parameters', 'shape': [9], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'sensitivity', 'shape': [3, 21], 'per_point': True, 'unit': 'mm/mm, mm/rad'}],
            'operations': 7,
            'operations_per_call': 0,
        },
        'tool_in_workpiece_position': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [9], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'position', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 104,
            'operations_per_call': 0,
        },
        'tool_in_workpiece_position_first_order': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [9], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'position', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 66,
            'operations_per_call': 0,
        },
        'tool_in_workpiece_deviation_curves': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'curves', 'shape': [18, 7], 'per_point': False, 'unit': 'mm/mm^k, rad/mm^k'},
                {'name': 'parameters', 'shape': [9], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': False, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 329,
            'operations_per_call': 3,
        },
        'tool_in_workpiece_deviation_first_order_curves': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'curves', 'shape': [18, 7], 'per_point': False, 'unit': 'mm/mm^k, rad/mm^k'},
                {'name': 'parameters', 'shape': [9], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': False, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 209,
            'operations_per_call': 267,
        },
        'ballbar_error': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [9], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'ball', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'length', 'shape': [1], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'error', 'shape': [4], 'per_point': True, 'unit': 'mm'}],
            'operations': 137,
            'operations_per_call': 0,
        },
        'correction': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'moves', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 1,
            'operations_per_call': 0,
        },
        'motion_X': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [9], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'tool_point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'displacement', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 18,
            'operations_per_call': 0,
        },
        'motion_Y': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [9], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'workpiece_point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'displacement', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 16,
            'operations_per_call': 0,
        },
        'motion_Z': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [9], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'tool_point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'displacement', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 20,
            'operations_per_call': 0,
        },
        'motion_XY': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [9], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'workpiece_point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'tool_point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'displacement', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 37,
            'operations_per_call': 0,
        },
        'motion_XZ': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [9], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'tool_point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'displacement', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 41,
            'operations_per_call': 0,
        },
        'motion_YZ': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [9], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'workpiece_point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'tool_point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'displacement', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 39,
            'operations_per_call': 0,
        },
        'system_1': {
            'inputs': [
                {'name': 'readings', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [9], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'points', 'shape': [3, 3], 'per_point': False, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'unknowns', 'shape': [3], 'per_point': True, 'unit': 'mm, rad'}],
            'operations': 39,
            'operations_per_call': 22,
        },
        'system_2': {
            'inputs': [
                {'name': 'readings', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [9], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'points', 'shape': [3, 3], 'per_point': False, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'unknowns', 'shape': [3], 'per_point': True, 'unit': 'mm, rad'}],
            'operations': 39,
            'operations_per_call': 22,
        },
        'system_3': {
            'inputs': [
                {'name': 'readings', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [9], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'points', 'shape': [3, 3], 'per_point': False, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'unknowns', 'shape': [3], 'per_point': True, 'unit': 'mm, rad'}],
            'operations': 39,
            'operations_per_call': 22,
        },
        'system_4': {
            'inputs': [
                {'name': 'readings', 'shape': [2], 'per_point': True, 'unit': 'mm'},
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [9], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'points', 'shape': [2, 3], 'per_point': False, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'unknowns', 'shape': [2], 'per_point': True, 'unit': 'mm, rad'}],
            'operations': 25,
            'operations_per_call': 7,
        },
        'system_5': {
            'inputs': [
                {'name': 'readings', 'shape': [2], 'per_point': True, 'unit': 'mm'},
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [9], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'points', 'shape': [2, 3], 'per_point': False, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'unknowns', 'shape': [2], 'per_point': True, 'unit': 'mm, rad'}],
            'operations': 21,
            'operations_per_call': 8,
        },
        'system_6': {
            'inputs': [
                {'name': 'readings', 'shape': [2], 'per_point': True, 'unit': 'mm'},
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [9], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'points', 'shape': [4, 3], 'per_point': False, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'unknowns', 'shape': [2], 'per_point': True, 'unit': 'mm, rad'}],
            'operations': 34,
            'operations_per_call': 2,
        },
        'system_7': {
            'inputs': [
                {'name': 'readings', 'shape': [1], 'per_point': True, 'unit': 'mm'},
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [9], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'points', 'shape': [2, 3], 'per_point': False, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'unknowns', 'shape': [1], 'per_point': True, 'unit': 'mm, rad'}],
            'operations': 17,
            'operations_per_call': 0,
        },
        'system_8': {
            'inputs': [
                {'name': 'readings', 'shape': [1], 'per_point': True, 'unit': 'mm'},
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [9], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'points', 'shape': [2, 3], 'per_point': False, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'unknowns', 'shape': [1], 'per_point': True, 'unit': 'mm, rad'}],
            'operations': 17,
            'operations_per_call': 0,
        },
        'system_9': {
            'inputs': [
                {'name': 'readings', 'shape': [1], 'per_point': True, 'unit': 'mm'},
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [9], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'points', 'shape': [2, 3], 'per_point': False, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'unknowns', 'shape': [1], 'per_point': True, 'unit': 'mm, rad'}],
            'operations': 15,
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

    Source: Eqs. (1)-(4) without errors. Operations: 9 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        parameters (9,): home positions and location errors [mm, rad]
            rows: q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz eps_xz
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        ideal (3, n): tool point in the workpiece frame, without errors [mm]
            rows: px py pz
    """
    n, positions, point = _points(positions=(positions, 3), point=(point, 3))
    parameters = _constant("parameters", parameters, (9,))
    ideal = np.zeros((3, n))
    # constants
    q_wx = float(parameters[0])
    q_wy = float(parameters[1])
    q_wz = float(parameters[2])
    q_Tx = float(parameters[3])
    q_Ty = float(parameters[4])
    q_Tz = float(parameters[5])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        x = positions[0, at]
        y = positions[1, at]
        z = positions[2, at]
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # per point
        ideal[0, at] = q_Tx - q_wx + rx + x
        ideal[1, at] = q_Ty - q_wy + ry - y
        ideal[2, at] = q_Tz - q_wz + rz + z
    return ideal


def tool_in_workpiece_deviation(positions, errors, parameters, point):
    """Deviation of a tool point in the workpiece frame, exact.

    Source: Eqs. (1)-(4). Operations: 98 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (9,): home positions and location errors [mm, rad]
            rows: q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz eps_xz
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): tool point in the workpiece frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions, errors, point = _points(positions=(positions, 3), errors=(errors, 18), point=(point, 3))
    parameters = _constant("parameters", parameters, (9,))
    deviation = np.zeros((3, n))
    # constants
    q_Tx = float(parameters[3])
    q_Ty = float(parameters[4])
    q_Tz = float(parameters[5])
    eps_xy = float(parameters[6])
    eps_yz = float(parameters[7])
    eps_xz = float(parameters[8])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        x = positions[0, at]
        y = positions[1, at]
        z = positions[2, at]
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
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # per point
        w0 = q_Tx + rx
        w1 = w0 + x
        w2 = q_Ty + ry
        w3 = q_Tz + rz
        w4 = w3 + z
        w5 = EBZ*w3 - ECZ*w2 + EXZ
        w6 = -EAZ*w3 + ECZ*w0 + EYZ
        w7 = EAZ*w2 - EBZ*w0 + EZZ
        w8 = -eps_xz*(w0 + w5) + eps_yz*(w2 + w6) + w7
        w9 = w4 + w8
        w10 = w4 + w7
        w11 = -eps_yz*w10 + w6
        w12 = w11 + w2
        w13 = eps_xz*w10 + w5
        w14 = EBX*w9 - ECX*w12 + EXX + w13
        w15 = w0 + w13
        w16 = -EAX*w9 + ECX*w15 + EYX + w11
        w17 = -eps_xy*(w16 + w2) + w14
        w18 = -EXY + w17
        w19 = w2 - y
        w20 = eps_xy*(w1 + w14) + w16
        w21 = -EYY + w20
        w22 = w19 + w21
        w23 = EAX*w12 - EBX*w15 + EZX + w8
        w24 = -EZY + w23
        w25 = w24 + w4
        w26 = w1 + w18
        w27 = EAY*w26 + EBY*w22 + ECY*w25
        w28 = (EAY*EAY) + (EBY*EBY) + (ECY*ECY)
        w29 = 1.0/(w28 + 1)
        deviation[0, at] = w29*(EAY*w27 - EBY*w25 + ECY*w22 - w1*w28 + w18)
        deviation[1, at] = w29*(EAY*w25 + EBY*w27 - ECY*w26 - w19*w28 + w21)
        deviation[2, at] = w29*(-EAY*w22 + EBY*w26 + ECY*w27 + w24 - w28*w4)
    return deviation


def tool_in_workpiece_deviation_first_order(positions, errors, parameters, point):
    """Deviation of a tool point in the workpiece frame, to first order in the errors.

    Source: Eqs. (1)-(4). Operations: 60 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (9,): home positions and location errors [mm, rad]
            rows: q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz eps_xz
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): tool point in the workpiece frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions, errors, point = _points(positions=(positions, 3), errors=(errors, 18), point=(point, 3))
    parameters = _constant("parameters", parameters, (9,))
    deviation = np.zeros((3, n))
    # constants
    q_Tx = float(parameters[3])
    q_Ty = float(parameters[4])
    q_Tz = float(parameters[5])
    eps_xy = float(parameters[6])
    eps_yz = float(parameters[7])
    eps_xz = float(parameters[8])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        x = positions[0, at]
        y = positions[1, at]
        z = positions[2, at]
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
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # per point
        w0 = q_Tz + rz
        w1 = w0 + z
        w2 = q_Ty + ry
        w3 = EBZ*w0 - ECZ*w2 + EXZ
        w4 = eps_xz*w1 + w3
        w5 = EBX*w1 - ECX*w2 + EXX + w4
        w6 = -eps_xy*w2 + w5
        w7 = w2 - y
        deviation[0, at] = -EBY*w1 + ECY*w7 - EXY + w6
        w8 = q_Tx + rx
        w9 = w8 + x
        w10 = -EAZ*w0 + ECZ*w8 + EYZ
        w11 = -eps_yz*w1 + w10
        w12 = -EAX*w1 + ECX*w8 + EYX + w11
        w13 = eps_xy*w9 + w12
        deviation[1, at] = EAY*w1 - ECY*w9 - EYY + w13
        w14 = EAZ*w2 - EBZ*w8 + EZZ
        w15 = -eps_xz*w8 + eps_yz*w2 + w14
        w16 = EAX*w2 - EBX*w8 + EZX + w15
        deviation[2, at] = -EAY*w7 + EBY*w9 - EZY + w16
    return deviation


def tool_in_workpiece_sensitivity(positions, parameters, point):
    """Sensitivity of a tool point in the workpiece frame to every error, at the error-free machine.

    Source: Eqs. (1)-(4), first order. Operations: 15 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        parameters (9,): home positions and location errors [mm, rad]
            rows: q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz eps_xz
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        sensitivity (3, 21, n): derivative of the deviation by each component error, then by each location error [mm/mm, mm/rad]
            rows: dx_EXX dx_EYX .. dz_eps_xz, last index fastest
    """
    n, positions, point = _points(positions=(positions, 3), point=(point, 3))
    parameters = _constant("parameters", parameters, (9,))
    sensitivity = np.zeros((63, n))
    # constants
    q_Tx = float(parameters[3])
    q_Ty = float(parameters[4])
    q_Tz = float(parameters[5])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        x = positions[0, at]
        y = positions[1, at]
        z = positions[2, at]
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # per point
        sensitivity[16, at] = dx_EBZ = q_Tz + rz
        sensitivity[4, at] = dx_EBX = dx_EBZ + z
        sensitivity[45, at] = dz_EAX = q_Ty + ry
        sensitivity[5, at] = dx_ECX = -dz_EAX
        sensitivity[10, at] = dx_EBY = -dx_EBX
        sensitivity[11, at] = dx_ECY = dz_EAX - y
        sensitivity[26, at] = dy_ECX = q_Tx + rx
        sensitivity[39, at] = dy_eps_xy = dy_ECX + x
        sensitivity[46, at] = dz_EBX = -dy_ECX
        sensitivity[0, at] = 1.0
        sensitivity[6, at] = -1.0
        sensitivity[12, at] = 1.0
        sensitivity[17, at] = dx_ECX
        sensitivity[18, at] = dx_ECX
        sensitivity[20, at] = dx_EBX
        sensitivity[22, at] = 1.0
        sensitivity[24, at] = dx_EBY
        sensitivity[28, at] = -1.0
        sensitivity[30, at] = dx_EBX
        sensitivity[32, at] = -dy_eps_xy
        sensitivity[34, at] = 1.0
        sensitivity[36, at] = -dx_EBZ
        sensitivity[38, at] = dy_ECX
        sensitivity[40, at] = dx_EBY
        sensitivity[44, at] = 1.0
        sensitivity[50, at] = -1.0
        sensitivity[51, at] = -dx_ECY
        sensitivity[52, at] = dy_eps_xy
        sensitivity[56, at] = 1.0
        sensitivity[57, at] = dz_EAX
        sensitivity[58, at] = dz_EBX
        sensitivity[61, at] = dz_EAX
        sensitivity[62, at] = dz_EBX
    return sensitivity.reshape(3, 21, n)


def tool_in_bed_ideal(positions, parameters, point):
    """Ideal position of a tool point in the bed frame.

    Source: Eqs. (1)-(4) without errors. Operations: 5 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        parameters (9,): home positions and location errors [mm, rad]
            rows: q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz eps_xz
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        ideal (3, n): tool point in the bed frame, without errors [mm]
            rows: px py pz
    """
    n, positions, point = _points(positions=(positions, 3), point=(point, 3))
    parameters = _constant("parameters", parameters, (9,))
    ideal = np.zeros((3, n))
    # constants
    q_Tx = float(parameters[3])
    q_Ty = float(parameters[4])
    q_Tz = float(parameters[5])
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

    Source: Eqs. (1)-(4). Operations: 52 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (9,): home positions and location errors [mm, rad]
            rows: q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz eps_xz
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): tool point in the bed frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions, errors, point = _points(positions=(positions, 3), errors=(errors, 18), point=(point, 3))
    parameters = _constant("parameters", parameters, (9,))
    deviation = np.zeros((3, n))
    # constants
    q_Tx = float(parameters[3])
    q_Ty = float(parameters[4])
    q_Tz = float(parameters[5])
    eps_xy = float(parameters[6])
    eps_yz = float(parameters[7])
    eps_xz = float(parameters[8])
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
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # per point
        w0 = q_Ty + ry
        w1 = q_Tx + rx
        w2 = EAZ*w0 - EBZ*w1 + EZZ
        w3 = q_Tz + rz
        w4 = w3 + z
        w5 = w2 + w4
        w6 = -EAZ*w3 + ECZ*w1 + EYZ
        w7 = -eps_yz*w5 + w6
        w8 = w0 + w7
        w9 = EBZ*w3 - ECZ*w0 + EXZ
        w10 = eps_xz*w5 + w9
        w11 = w1 + w10
        w12 = -eps_xz*(w1 + w9) + eps_yz*(w0 + w6) + w2
        deviation[2, at] = EAX*w8 - EBX*w11 + EZX + w12
        w13 = w12 + w4
        w14 = EBX*w13 - ECX*w8 + EXX + w10
        w15 = -EAX*w13 + ECX*w11 + EYX + w7
        deviation[0, at] = -eps_xy*(w0 + w15) + w14
        w16 = w1 + x
        deviation[1, at] = eps_xy*(w14 + w16) + w15
    return deviation


def tool_in_bed_deviation_first_order(positions, errors, parameters, point):
    """Deviation of a tool point in the bed frame, to first order in the errors.

    Source: Eqs. (1)-(4). Operations: 44 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (9,): home positions and location errors [mm, rad]
            rows: q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz eps_xz
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): tool point in the bed frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions, errors, point = _points(positions=(positions, 3), errors=(errors, 18), point=(point, 3))
    parameters = _constant("parameters", parameters, (9,))
    deviation = np.zeros((3, n))
    # constants
    q_Tx = float(parameters[3])
    q_Ty = float(parameters[4])
    q_Tz = float(parameters[5])
    eps_xy = float(parameters[6])
    eps_yz = float(parameters[7])
    eps_xz = float(parameters[8])
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
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # per point
        w0 = q_Tx + rx
        w1 = q_Ty + ry
        w2 = EAZ*w1 - EBZ*w0 + EZZ
        w3 = -eps_xz*w0 + eps_yz*w1 + w2
        deviation[2, at] = EAX*w1 - EBX*w0 + EZX + w3
        w4 = q_Tz + rz
        w5 = w4 + z
        w6 = EBZ*w4 - ECZ*w1 + EXZ
        w7 = eps_xz*w5 + w6
        w8 = EBX*w5 - ECX*w1 + EXX + w7
        deviation[0, at] = -eps_xy*w1 + w8
        w9 = -EAZ*w4 + ECZ*w0 + EYZ
        w10 = -eps_yz*w5 + w9
        w11 = -EAX*w5 + ECX*w0 + EYX + w10
        w12 = w0 + x
        deviation[1, at] = eps_xy*w12 + w11
    return deviation


def tool_in_bed_sensitivity(positions, parameters, point):
    """Sensitivity of a tool point in the bed frame to every error, at the error-free machine.

    Source: Eqs. (1)-(4), first order. Operations: 9 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        parameters (9,): home positions and location errors [mm, rad]
            rows: q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz eps_xz
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        sensitivity (3, 21, n): derivative of the deviation by each component error, then by each location error [mm/mm, mm/rad]
            rows: dx_EXX dx_EYX .. dz_eps_xz, last index fastest
    """
    n, positions, point = _points(positions=(positions, 3), point=(point, 3))
    parameters = _constant("parameters", parameters, (9,))
    sensitivity = np.zeros((63, n))
    # constants
    q_Tx = float(parameters[3])
    q_Ty = float(parameters[4])
    q_Tz = float(parameters[5])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        x = positions[0, at]
        z = positions[2, at]
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # per point
        sensitivity[16, at] = dx_EBZ = q_Tz + rz
        sensitivity[4, at] = dx_EBX = dx_EBZ + z
        sensitivity[45, at] = dz_EAX = q_Ty + ry
        sensitivity[5, at] = dx_ECX = -dz_EAX
        sensitivity[24, at] = dy_EAX = -dx_EBX
        sensitivity[26, at] = dy_ECX = q_Tx + rx
        sensitivity[46, at] = dz_EBX = -dy_ECX
        sensitivity[0, at] = 1.0
        sensitivity[12, at] = 1.0
        sensitivity[17, at] = dx_ECX
        sensitivity[18, at] = dx_ECX
        sensitivity[20, at] = dx_EBX
        sensitivity[22, at] = 1.0
        sensitivity[34, at] = 1.0
        sensitivity[36, at] = -dx_EBZ
        sensitivity[38, at] = dy_ECX
        sensitivity[39, at] = dy_ECX + x
        sensitivity[40, at] = dy_EAX
        sensitivity[44, at] = 1.0
        sensitivity[56, at] = 1.0
        sensitivity[57, at] = dz_EAX
        sensitivity[58, at] = dz_EBX
        sensitivity[61, at] = dz_EAX
        sensitivity[62, at] = dz_EBX
    return sensitivity.reshape(3, 21, n)


def workpiece_in_bed_ideal(positions, parameters, point):
    """Ideal position of a workpiece point in the bed frame.

    Source: Eqs. (1)-(4) without errors. Operations: 4 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        parameters (9,): home positions and location errors [mm, rad]
            rows: q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz eps_xz
        point (3, n): point in the workpiece frame [mm]
            rows: rx ry rz

    Returns:
        ideal (3, n): workpiece point in the bed frame, without errors [mm]
            rows: px py pz
    """
    n, positions, point = _points(positions=(positions, 3), point=(point, 3))
    parameters = _constant("parameters", parameters, (9,))
    ideal = np.zeros((3, n))
    # constants
    q_wx = float(parameters[0])
    q_wy = float(parameters[1])
    q_wz = float(parameters[2])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        y = positions[1, at]
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # per point
        ideal[0, at] = q_wx + rx
        ideal[1, at] = q_wy + ry + y
        ideal[2, at] = q_wz + rz
    return ideal


def workpiece_in_bed_deviation(positions, errors, parameters, point):
    """Deviation of a workpiece point in the bed frame, exact.

    Source: Eqs. (1)-(4). Operations: 15 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (9,): home positions and location errors [mm, rad]
            rows: q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz eps_xz
        point (3, n): point in the workpiece frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): workpiece point in the bed frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions, errors, point = _points(positions=(positions, 3), errors=(errors, 18), point=(point, 3))
    parameters = _constant("parameters", parameters, (9,))
    deviation = np.zeros((3, n))
    # constants
    q_wx = float(parameters[0])
    q_wy = float(parameters[1])
    q_wz = float(parameters[2])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        EXY = errors[6, at]
        EYY = errors[7, at]
        EZY = errors[8, at]
        EAY = errors[9, at]
        EBY = errors[10, at]
        ECY = errors[11, at]
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # per point
        w0 = q_wy + ry
        w1 = q_wz + rz
        deviation[0, at] = EBY*w1 - ECY*w0 + EXY
        w2 = q_wx + rx
        deviation[1, at] = -EAY*w1 + ECY*w2 + EYY
        deviation[2, at] = EAY*w0 - EBY*w2 + EZY
    return deviation


def workpiece_in_bed_deviation_first_order(positions, errors, parameters, point):
    """Deviation of a workpiece point in the bed frame, to first order in the errors.

    Source: Eqs. (1)-(4). Operations: 15 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (9,): home positions and location errors [mm, rad]
            rows: q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz eps_xz
        point (3, n): point in the workpiece frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): workpiece point in the bed frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions, errors, point = _points(positions=(positions, 3), errors=(errors, 18), point=(point, 3))
    parameters = _constant("parameters", parameters, (9,))
    deviation = np.zeros((3, n))
    # constants
    q_wx = float(parameters[0])
    q_wy = float(parameters[1])
    q_wz = float(parameters[2])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        EXY = errors[6, at]
        EYY = errors[7, at]
        EZY = errors[8, at]
        EAY = errors[9, at]
        EBY = errors[10, at]
        ECY = errors[11, at]
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # per point
        w0 = q_wy + ry
        w1 = q_wz + rz
        deviation[0, at] = EBY*w1 - ECY*w0 + EXY
        w2 = q_wx + rx
        deviation[1, at] = -EAY*w1 + ECY*w2 + EYY
        deviation[2, at] = EAY*w0 - EBY*w2 + EZY
    return deviation


def workpiece_in_bed_sensitivity(positions, parameters, point):
    """Sensitivity of a workpiece point in the bed frame to every error, at the error-free machine.

    Source: Eqs. (1)-(4), first order. Operations: 6 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        parameters (9,): home positions and location errors [mm, rad]
            rows: q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz eps_xz
        point (3, n): point in the workpiece frame [mm]
            rows: rx ry rz

    Returns:
        sensitivity (3, 21, n): derivative of the deviation by each component error, then by each location error [mm/mm, mm/rad]
            rows: dx_EXX dx_EYX .. dz_eps_xz, last index fastest
    """
    n, positions, point = _points(positions=(positions, 3), point=(point, 3))
    parameters = _constant("parameters", parameters, (9,))
    sensitivity = np.zeros((63, n))
    # constants
    q_wx = float(parameters[0])
    q_wy = float(parameters[1])
    q_wz = float(parameters[2])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # per point
        sensitivity[10, at] = dx_EBY = q_wz + rz
        sensitivity[51, at] = dz_EAY = q_wy + ry
        sensitivity[32, at] = dy_ECY = q_wx + rx
        sensitivity[6, at] = 1.0
        sensitivity[11, at] = -dz_EAY
        sensitivity[28, at] = 1.0
        sensitivity[30, at] = -dx_EBY
        sensitivity[50, at] = 1.0
        sensitivity[52, at] = -dy_ECY
    return sensitivity.reshape(3, 21, n)


def bed_in_workpiece_ideal(positions, parameters, point):
    """Ideal position of a bed point in the workpiece frame.

    Source: Eqs. (1)-(4) without errors. Operations: 4 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        parameters (9,): home positions and location errors [mm, rad]
            rows: q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz eps_xz
        point (3, n): point in the bed frame [mm]
            rows: rx ry rz

    Returns:
        ideal (3, n): bed point in the workpiece frame, without errors [mm]
            rows: px py pz
    """
    n, positions, point = _points(positions=(positions, 3), point=(point, 3))
    parameters = _constant("parameters", parameters, (9,))
    ideal = np.zeros((3, n))
    # constants
    q_wx = float(parameters[0])
    q_wy = float(parameters[1])
    q_wz = float(parameters[2])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        y = positions[1, at]
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # per point
        ideal[0, at] = -q_wx + rx
        ideal[1, at] = -q_wy + ry - y
        ideal[2, at] = -q_wz + rz
    return ideal


def bed_in_workpiece_deviation(positions, errors, parameters, point):
    """Deviation of a bed point in the workpiece frame, exact.

    Source: Eqs. (1)-(4). Operations: 47 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (9,): home positions and location errors [mm, rad]
            rows: q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz eps_xz
        point (3, n): point in the bed frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): bed point in the workpiece frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions, errors, point = _points(positions=(positions, 3), errors=(errors, 18), point=(point, 3))
    parameters = _constant("parameters", parameters, (9,))
    deviation = np.zeros((3, n))
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        y = positions[1, at]
        EXY = errors[6, at]
        EYY = errors[7, at]
        EZY = errors[8, at]
        EAY = errors[9, at]
        EBY = errors[10, at]
        ECY = errors[11, at]
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # per point
        w0 = ry - y
        w1 = -EYY + w0
        w2 = -rz
        w3 = -EZY - w2
        w4 = -rx
        w5 = -EXY - w4
        w6 = EAY*w5 + EBY*w1 + ECY*w3
        w7 = (EAY*EAY) + (EBY*EBY) + (ECY*ECY)
        w8 = 1.0/(w7 + 1)
        deviation[0, at] = w8*(EAY*w6 - EBY*w3 + ECY*w1 - EXY - rx*w7)
        deviation[1, at] = w8*(EAY*w3 + EBY*w6 - ECY*w5 - EYY - w0*w7)
        deviation[2, at] = w8*(-EAY*w1 + EBY*w5 + ECY*w6 - EZY - rz*w7)
    return deviation


def bed_in_workpiece_deviation_first_order(positions, errors, parameters, point):
    """Deviation of a bed point in the workpiece frame, to first order in the errors.

    Source: Eqs. (1)-(4). Operations: 13 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (9,): home positions and location errors [mm, rad]
            rows: q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz eps_xz
        point (3, n): point in the bed frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): bed point in the workpiece frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions, errors, point = _points(positions=(positions, 3), errors=(errors, 18), point=(point, 3))
    parameters = _constant("parameters", parameters, (9,))
    deviation = np.zeros((3, n))
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        y = positions[1, at]
        EXY = errors[6, at]
        EYY = errors[7, at]
        EZY = errors[8, at]
        EAY = errors[9, at]
        EBY = errors[10, at]
        ECY = errors[11, at]
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # per point
        w0 = ry - y
        deviation[0, at] = -EBY*rz + ECY*w0 - EXY
        deviation[1, at] = EAY*rz - ECY*rx - EYY
        deviation[2, at] = -EAY*w0 + EBY*rx - EZY
    return deviation


def bed_in_workpiece_sensitivity(positions, parameters, point):
    """Sensitivity of a bed point in the workpiece frame to every error, at the error-free machine.

    Source: Eqs. (1)-(4), first order. Operations: 7 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        parameters (9,): home positions and location errors [mm, rad]
            rows: q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz eps_xz
        point (3, n): point in the bed frame [mm]
            rows: rx ry rz

    Returns:
        sensitivity (3, 21, n): derivative of the deviation by each component error, then by each location error [mm/mm, mm/rad]
            rows: dx_EXX dx_EYX .. dz_eps_xz, last index fastest
    """
    n, positions, point = _points(positions=(positions, 3), point=(point, 3))
    parameters = _constant("parameters", parameters, (9,))
    sensitivity = np.zeros((63, n))
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        y = positions[1, at]
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # per point
        sensitivity[11, at] = dx_ECY = ry - y
        sensitivity[6, at] = -1.0
        sensitivity[10, at] = -rz
        sensitivity[28, at] = -1.0
        sensitivity[30, at] = rz
        sensitivity[32, at] = -rx
        sensitivity[50, at] = -1.0
        sensitivity[51, at] = -dx_ECY
        sensitivity[52, at] = rx
    return sensitivity.reshape(3, 21, n)


def tool_in_workpiece_position(positions, errors, parameters, point):
    """Actual position of the tool point in the workpiece frame, exact.

    Source: Eq. (4). Operations: 104 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (9,): home positions and location errors [mm, rad]
            rows: q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz eps_xz
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        position (3, n): actual position P_T^W of the tool point in the workpiece frame [mm]
            rows: px py pz
    """
    n, positions, errors, point = _points(positions=(positions, 3), errors=(errors, 18), point=(point, 3))
    parameters = _constant("parameters", parameters, (9,))
    position = np.zeros((3, n))
    # constants
    q_wx = float(parameters[0])
    q_wy = float(parameters[1])
    q_wz = float(parameters[2])
    q_Tx = float(parameters[3])
    q_Ty = float(parameters[4])
    q_Tz = float(parameters[5])
    eps_xy = float(parameters[6])
    eps_yz = float(parameters[7])
    eps_xz = float(parameters[8])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        x = positions[0, at]
        y = positions[1, at]
        z = positions[2, at]
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
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # per point
        w0 = q_Tx + rx
        w1 = w0 + x
        w2 = q_Ty + ry
        w3 = q_Tz + rz
        w4 = w3 + z
        w5 = EBZ*w3 - ECZ*w2 + EXZ
        w6 = -EAZ*w3 + ECZ*w0 + EYZ
        w7 = EAZ*w2 - EBZ*w0 + EZZ
        w8 = -eps_xz*(w0 + w5) + eps_yz*(w2 + w6) + w7
        w9 = w4 + w8
        w10 = w4 + w7
        w11 = -eps_yz*w10 + w6
        w12 = w11 + w2
        w13 = eps_xz*w10 + w5
        w14 = EBX*w9 - ECX*w12 + EXX + w13
        w15 = w0 + w13
        w16 = -EAX*w9 + ECX*w15 + EYX + w11
        w17 = -eps_xy*(w16 + w2) + w14
        w18 = -EXY + w17
        w19 = w2 - y
        w20 = eps_xy*(w1 + w14) + w16
        w21 = -EYY + w20
        w22 = w19 + w21
        w23 = EAX*w12 - EBX*w15 + EZX + w8
        w24 = -EZY + w23
        w25 = w24 + w4
        w26 = w1 + w18
        w27 = EAY*w26 + EBY*w22 + ECY*w25
        w28 = (EAY*EAY) + (EBY*EBY) + (ECY*ECY)
        w29 = 1.0/(w28 + 1)
        w30 = w29*(EAY*w27 - EBY*w25 + ECY*w22 - w1*w28 + w18)
        w31 = -q_wx + w1
        position[0, at] = w30 + w31
        w32 = w29*(EAY*w25 + EBY*w27 - ECY*w26 - w19*w28 + w21)
        w33 = -q_wy + w19
        position[1, at] = w32 + w33
        w34 = w29*(-EAY*w22 + EBY*w26 + ECY*w27 + w24 - w28*w4)
        w35 = -q_wz + w4
        position[2, at] = w34 + w35
    return position


def tool_in_workpiece_position_first_order(positions, errors, parameters, point):
    """Actual position of the tool point in the workpiece frame, to first order.

    Source: Eq. (4). Operations: 66 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (9,): home positions and location errors [mm, rad]
            rows: q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz eps_xz
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        position (3, n): actual position P_T^W of the tool point in the workpiece frame [mm]
            rows: px py pz
    """
    n, positions, errors, point = _points(positions=(positions, 3), errors=(errors, 18), point=(point, 3))
    parameters = _constant("parameters", parameters, (9,))
    position = np.zeros((3, n))
    # constants
    q_wx = float(parameters[0])
    q_wy = float(parameters[1])
    q_wz = float(parameters[2])
    q_Tx = float(parameters[3])
    q_Ty = float(parameters[4])
    q_Tz = float(parameters[5])
    eps_xy = float(parameters[6])
    eps_yz = float(parameters[7])
    eps_xz = float(parameters[8])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        x = positions[0, at]
        y = positions[1, at]
        z = positions[2, at]
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
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # per point
        w0 = q_Tz + rz
        w1 = w0 + z
        w2 = q_Ty + ry
        w3 = EBZ*w0 - ECZ*w2 + EXZ
        w4 = eps_xz*w1 + w3
        w5 = EBX*w1 - ECX*w2 + EXX + w4
        w6 = -eps_xy*w2 + w5
        w7 = w2 - y
        w8 = -EBY*w1 + ECY*w7 - EXY + w6
        w9 = q_Tx + rx
        w10 = w9 + x
        w11 = -q_wx + w10
        position[0, at] = w11 + w8
        w12 = -EAZ*w0 + ECZ*w9 + EYZ
        w13 = -eps_yz*w1 + w12
        w14 = -EAX*w1 + ECX*w9 + EYX + w13
        w15 = eps_xy*w10 + w14
        w16 = EAY*w1 - ECY*w10 - EYY + w15
        w17 = -q_wy + w7
        position[1, at] = w16 + w17
        w18 = EAZ*w2 - EBZ*w9 + EZZ
        w19 = -eps_xz*w9 + eps_yz*w2 + w18
        w20 = EAX*w2 - EBX*w9 + EZX + w19
        w21 = -EAY*w7 + EBY*w10 - EZY + w20
        w22 = -q_wz + w1
        position[2, at] = w21 + w22
    return position


def tool_in_workpiece_deviation_curves(positions, curves, parameters, point):
    """Deviation of the tool point under polynomial error curves, exact.

    Source: Eqs. (1)-(4), (44). Operations: 329 per point, 3 per call.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        curves (18, 7): coefficients of the powers 1 to 7 of the axis position, per component error [mm/mm^k, rad/mm^k]
            rows: EXX_1 EXX_2 .. ECZ_7, last index fastest
        parameters (9,): home positions and location errors [mm, rad]
            rows: q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz eps_xz
        point (3,): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): tool point in the workpiece frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions = _points(positions=(positions, 3))
    curves = _constant("curves", curves, (18, 7))
    parameters = _constant("parameters", parameters, (9,))
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
    q_Tx = float(parameters[3])
    q_Ty = float(parameters[4])
    q_Tz = float(parameters[5])
    eps_xy = float(parameters[6])
    eps_yz = float(parameters[7])
    eps_xz = float(parameters[8])
    rx = float(point[0])
    ry = float(point[1])
    rz = float(point[2])
    # once per call
    w3 = q_Tx + rx
    w6 = q_Ty + ry
    w7 = q_Tz + rz
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        x = positions[0, at]
        y = positions[1, at]
        z = positions[2, at]
        # per point
        w0 = _polynomial(y, EAY_1, EAY_2, EAY_3, EAY_4, EAY_5, EAY_6, EAY_7)
        w1 = _polynomial(y, EBY_1, EBY_2, EBY_3, EBY_4, EBY_5, EBY_6, EBY_7)
        w2 = _polynomial(y, ECY_1, ECY_2, ECY_3, ECY_4, ECY_5, ECY_6, ECY_7)
        w4 = w3 + x
        w5 = _polynomial(y, EXY_1, EXY_2, EXY_3, EXY_4, EXY_5, EXY_6, EXY_7)
        w8 = w7 + z
        w9 = _polynomial(z, EXZ_1, EXZ_2, EXZ_3, EXZ_4, EXZ_5, EXZ_6, EXZ_7)
        w10 = _polynomial(z, EBZ_1, EBZ_2, EBZ_3, EBZ_4, EBZ_5, EBZ_6, EBZ_7)
        w11 = _polynomial(z, ECZ_1, ECZ_2, ECZ_3, ECZ_4, ECZ_5, ECZ_6, ECZ_7)
        w12 = w10*w7 - w11*w6 + w9
        w13 = _polynomial(z, EYZ_1, EYZ_2, EYZ_3, EYZ_4, EYZ_5, EYZ_6, EYZ_7)
        w14 = _polynomial(z, EAZ_1, EAZ_2, EAZ_3, EAZ_4, EAZ_5, EAZ_6, EAZ_7)
        w15 = w11*w3 + w13 - w14*w7
        w16 = _polynomial(z, EZZ_1, EZZ_2, EZZ_3, EZZ_4, EZZ_5, EZZ_6, EZZ_7)
        w17 = -w10*w3 + w14*w6 + w16
        w18 = -eps_xz*(w12 + w3) + eps_yz*(w15 + w6) + w17
        w19 = w18 + w8
        w20 = w17 + w8
        w21 = -eps_yz*w20 + w15
        w22 = w21 + w6
        w23 = _polynomial(x, EXX_1, EXX_2, EXX_3, EXX_4, EXX_5, EXX_6, EXX_7)
        w24 = _polynomial(x, EBX_1, EBX_2, EBX_3, EBX_4, EBX_5, EBX_6, EBX_7)
        w25 = _polynomial(x, ECX_1, ECX_2, ECX_3, ECX_4, ECX_5, ECX_6, ECX_7)
        w26 = eps_xz*w20 + w12
        w27 = w19*w24 - w22*w25 + w23 + w26
        w28 = w26 + w3
        w29 = _polynomial(x, EYX_1, EYX_2, EYX_3, EYX_4, EYX_5, EYX_6, EYX_7)
        w30 = _polynomial(x, EAX_1, EAX_2, EAX_3, EAX_4, EAX_5, EAX_6, EAX_7)
        w31 = -w19*w30 + w21 + w25*w28 + w29
        w32 = -eps_xy*(w31 + w6) + w27
        w33 = w32 - w5
        w34 = w6 - y
        w35 = _polynomial(y, EYY_1, EYY_2, EYY_3, EYY_4, EYY_5, EYY_6, EYY_7)
        w36 = eps_xy*(w27 + w4) + w31
        w37 = -w35 + w36
        w38 = w34 + w37
        w39 = _polynomial(y, EZY_1, EZY_2, EZY_3, EZY_4, EZY_5, EZY_6, EZY_7)
        w40 = _polynomial(x, EZX_1, EZX_2, EZX_3, EZX_4, EZX_5, EZX_6, EZX_7)
        w41 = w18 + w22*w30 - w24*w28 + w40
        w42 = -w39 + w41
        w43 = w42 + w8
        w44 = w33 + w4
        w45 = w0*w44 + w1*w38 + w2*w43
        w46 = (w0*w0) + (w1*w1) + (w2*w2)
        w47 = 1.0/(w46 + 1)
        deviation[0, at] = w47*(w0*w45 - w1*w43 + w2*w38 + w33 - w4*w46)
        deviation[1, at] = w47*(w0*w43 + w1*w45 - w2*w44 - w34*w46 + w37)
        deviation[2, at] = w47*(-w0*w38 + w1*w44 + w2*w45 + w42 - w46*w8)
    return deviation


def tool_in_workpiece_deviation_first_order_curves(positions, curves, parameters, point):
    """Deviation of the tool point under polynomial error curves, to first order, constants folded once per call.

    Source: Eqs. (1)-(4), (44). Operations: 209 per point, 267 per call.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        curves (18, 7): coefficients of the powers 1 to 7 of the axis position, per component error [mm/mm^k, rad/mm^k]
            rows: EXX_1 EXX_2 .. ECZ_7, last index fastest
        parameters (9,): home positions and location errors [mm, rad]
            rows: q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz eps_xz
        point (3,): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): tool point in the workpiece frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions = _points(positions=(positions, 3))
    curves = _constant("curves", curves, (18, 7))
    parameters = _constant("parameters", parameters, (9,))
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
    q_Tx = float(parameters[3])
    q_Ty = float(parameters[4])
    q_Tz = float(parameters[5])
    eps_xy = float(parameters[6])
    eps_yz = float(parameters[7])
    eps_xz = float(parameters[8])
    rx = float(point[0])
    ry = float(point[1])
    rz = float(point[2])
    # once per call
    w0 = q_Tz + rz
    w1 = q_Ty + ry
    w2 = -w1
    w3 = EBZ_1*w0 + ECZ_1*w2 + EXZ_1
    w4 = EBZ_2*w0 + ECZ_2*w2 + EXZ_2
    w5 = EBZ_3*w0 + ECZ_3*w2 + EXZ_3
    w6 = EBZ_4*w0 + ECZ_4*w2 + EXZ_4
    w7 = EBZ_5*w0 + ECZ_5*w2 + EXZ_5
    w8 = EBZ_6*w0 + ECZ_6*w2 + EXZ_6
    w9 = EBZ_7*w0 + ECZ_7*w2 + EXZ_7
    w11 = eps_xy*w2 + eps_xz*w0
    w12 = EBX_1*w0 + ECX_1*w2 + EXX_1
    w13 = EBX_2*w0 + ECX_2*w2 + EXX_2
    w14 = EBX_3*w0 + ECX_3*w2 + EXX_3
    w15 = EBX_4*w0 + ECX_4*w2 + EXX_4
    w16 = EBX_5*w0 + ECX_5*w2 + EXX_5
    w17 = EBX_6*w0 + ECX_6*w2 + EXX_6
    w18 = EBX_7*w0 + ECX_7*w2 + EXX_7
    w20 = -w0
    w21 = EBY_1*w20 + ECY_1*w1 - EXY_1
    w22 = EBY_2*w20 + ECY_2*w1 - EXY_2
    w23 = EBY_3*w20 + ECY_3*w1 - EXY_3
    w24 = EBY_4*w20 + ECY_4*w1 - EXY_4
    w25 = EBY_5*w20 + ECY_5*w1 - EXY_5
    w26 = EBY_6*w20 + ECY_6*w1 - EXY_6
    w27 = EBY_7*w20 + ECY_7*w1 - EXY_7
    w38 = q_Tx + rx
    w39 = EAZ_1*w20 + ECZ_1*w38 + EYZ_1
    w40 = EAZ_2*w20 + ECZ_2*w38 + EYZ_2
    w41 = EAZ_3*w20 + ECZ_3*w38 + EYZ_3
    w42 = EAZ_4*w20 + ECZ_4*w38 + EYZ_4
    w43 = EAZ_5*w20 + ECZ_5*w38 + EYZ_5
    w44 = EAZ_6*w20 + ECZ_6*w38 + EYZ_6
    w45 = EAZ_7*w20 + ECZ_7*w38 + EYZ_7
    w47 = eps_xy*w38 + eps_yz*w20
    w48 = EAX_1*w20 + ECX_1*w38 + EYX_1
    w49 = EAX_2*w20 + ECX_2*w38 + EYX_2
    w50 = EAX_3*w20 + ECX_3*w38 + EYX_3
    w51 = EAX_4*w20 + ECX_4*w38 + EYX_4
    w52 = EAX_5*w20 + ECX_5*w38 + EYX_5
    w53 = EAX_6*w20 + ECX_6*w38 + EYX_6
    w54 = EAX_7*w20 + ECX_7*w38 + EYX_7
    w56 = -w38
    w57 = EAY_1*w0 + ECY_1*w56 - EYY_1
    w58 = EAY_2*w0 + ECY_2*w56 - EYY_2
    w59 = EAY_3*w0 + ECY_3*w56 - EYY_3
    w60 = EAY_4*w0 + ECY_4*w56 - EYY_4
    w61 = EAY_5*w0 + ECY_5*w56 - EYY_5
    w62 = EAY_6*w0 + ECY_6*w56 - EYY_6
    w63 = EAY_7*w0 + ECY_7*w56 - EYY_7
    w74 = EAZ_1*w1 + EBZ_1*w56 + EZZ_1
    w75 = EAZ_2*w1 + EBZ_2*w56 + EZZ_2
    w76 = EAZ_3*w1 + EBZ_3*w56 + EZZ_3
    w77 = EAZ_4*w1 + EBZ_4*w56 + EZZ_4
    w78 = EAZ_5*w1 + EBZ_5*w56 + EZZ_5
    w79 = EAZ_6*w1 + EBZ_6*w56 + EZZ_6
    w80 = EAZ_7*w1 + EBZ_7*w56 + EZZ_7
    w82 = eps_xz*w56 + eps_yz*w1
    w83 = EAX_1*w1 + EBX_1*w56 + EZX_1
    w84 = EAX_2*w1 + EBX_2*w56 + EZX_2
    w85 = EAX_3*w1 + EBX_3*w56 + EZX_3
    w86 = EAX_4*w1 + EBX_4*w56 + EZX_4
    w87 = EAX_5*w1 + EBX_5*w56 + EZX_5
    w88 = EAX_6*w1 + EBX_6*w56 + EZX_6
    w89 = EAX_7*w1 + EBX_7*w56 + EZX_7
    w91 = EAY_1*w2 + EBY_1*w38 - EZY_1
    w92 = EAY_2*w2 + EBY_2*w38 - EZY_2
    w93 = EAY_3*w2 + EBY_3*w38 - EZY_3
    w94 = EAY_4*w2 + EBY_4*w38 - EZY_4
    w95 = EAY_5*w2 + EBY_5*w38 - EZY_5
    w96 = EAY_6*w2 + EBY_6*w38 - EZY_6
    w97 = EAY_7*w2 + EBY_7*w38 - EZY_7
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        x = positions[0, at]
        y = positions[1, at]
        z = positions[2, at]
        # per point
        w10 = _polynomial(z, w3, w4, w5, w6, w7, w8, w9)
        w19 = _polynomial(x, w12, w13, w14, w15, w16, w17, w18)
        w28 = _polynomial(y, w21, w22, w23, w24, w25, w26, w27)
        w29 = w10 + w11 + w19 + w28
        w30 = _polynomial(x, EBX_1, EBX_2, EBX_3, EBX_4, EBX_5, EBX_6, EBX_7)
        w31 = _polynomial(y, EBY_1, EBY_2, EBY_3, EBY_4, EBY_5, EBY_6, EBY_7)
        w32 = w31
        w33 = eps_xz + w30 - w32
        w34 = w33*z
        w35 = _polynomial(y, ECY_1, ECY_2, ECY_3, ECY_4, ECY_5, ECY_6, ECY_7)
        w36 = w35
        w37 = -w36*y
        deviation[0, at] = w29 + w34 + w37
        w46 = _polynomial(z, w39, w40, w41, w42, w43, w44, w45)
        w55 = _polynomial(x, w48, w49, w50, w51, w52, w53, w54)
        w64 = _polynomial(y, w57, w58, w59, w60, w61, w62, w63)
        w65 = w46 + w47 + w55 + w64
        w66 = _polynomial(x, EAX_1, EAX_2, EAX_3, EAX_4, EAX_5, EAX_6, EAX_7)
        w67 = _polynomial(y, EAY_1, EAY_2, EAY_3, EAY_4, EAY_5, EAY_6, EAY_7)
        w68 = w67
        w69 = -eps_yz - w66 + w68
        w70 = w69*z
        w71 = w35
        w72 = eps_xy - w71
        w73 = w72*x
        deviation[1, at] = w65 + w70 + w73
        w81 = _polynomial(z, w74, w75, w76, w77, w78, w79, w80)
        w90 = _polynomial(x, w83, w84, w85, w86, w87, w88, w89)
        w98 = _polynomial(y, w91, w92, w93, w94, w95, w96, w97)
        w99 = w81 + w82 + w90 + w98
        w100 = w67
        w101 = w100*y
        w102 = w31
        w103 = w102*x
        deviation[2, at] = w101 + w103 + w99
    return deviation


def ballbar_error(positions, errors, parameters, point, ball, length):
    """Positioning error of a ball bar between a tool ball and a workpiece ball, exact.

    Source: Eqs. (5), (6). Operations: 137 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (9,): home positions and location errors [mm, rad]
            rows: q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz eps_xz
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
    n, positions, errors, point, ball, length = _points(positions=(positions, 3), errors=(errors, 18), point=(point, 3), ball=(ball, 3), length=(length, 1))
    parameters = _constant("parameters", parameters, (9,))
    error = np.zeros((4, n))
    # constants
    q_wx = float(parameters[0])
    q_wy = float(parameters[1])
    q_wz = float(parameters[2])
    q_Tx = float(parameters[3])
    q_Ty = float(parameters[4])
    q_Tz = float(parameters[5])
    eps_xy = float(parameters[6])
    eps_yz = float(parameters[7])
    eps_xz = float(parameters[8])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        x = positions[0, at]
        y = positions[1, at]
        z = positions[2, at]
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
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        bx = ball[0, at]
        by = ball[1, at]
        bz = ball[2, at]
        length_ = length[0, at]
        # per point
        w0 = q_Tx + rx
        w1 = w0 + x
        w2 = q_Ty + ry
        w3 = q_Tz + rz
        w4 = w3 + z
        w5 = EBZ*w3 - ECZ*w2 + EXZ
        w6 = -EAZ*w3 + ECZ*w0 + EYZ
        w7 = EAZ*w2 - EBZ*w0 + EZZ
        w8 = -eps_xz*(w0 + w5) + eps_yz*(w2 + w6) + w7
        w9 = w4 + w8
        w10 = w4 + w7
        w11 = -eps_yz*w10 + w6
        w12 = w11 + w2
        w13 = eps_xz*w10 + w5
        w14 = EBX*w9 - ECX*w12 + EXX + w13
        w15 = w0 + w13
        w16 = -EAX*w9 + ECX*w15 + EYX + w11
        w17 = -eps_xy*(w16 + w2) + w14
        w18 = -EXY + w17
        w19 = w2 - y
        w20 = eps_xy*(w1 + w14) + w16
        w21 = -EYY + w20
        w22 = w19 + w21
        w23 = EAX*w12 - EBX*w15 + EZX + w8
        w24 = -EZY + w23
        w25 = w24 + w4
        w26 = w1 + w18
        w27 = EAY*w26 + EBY*w22 + ECY*w25
        w28 = (EAY*EAY) + (EBY*EBY) + (ECY*ECY)
        w29 = 1.0/(w28 + 1)
        w30 = w29*(EAY*w27 - EBY*w25 + ECY*w22 - w1*w28 + w18)
        w31 = w29*(EAY*w25 + EBY*w27 - ECY*w26 - w19*w28 + w21)
        w32 = w29*(-EAY*w22 + EBY*w26 + ECY*w27 + w24 - w28*w4)
        w33 = -q_wx + w1
        w34 = -bx + w33
        w35 = -q_wy + w19
        w36 = -by + w35
        w37 = -q_wz + w4
        w38 = -bz + w37
        w39 = w30 + w34
        w40 = w31 + w36
        w41 = w32 + w38
        w42 = np.sqrt((w34*w34) + (w36*w36) + (w38*w38))
        w43 = np.sqrt((w39*w39) + (w40*w40) + (w41*w41))
        error[0, at] = e = -length_ + w42 + (w30*(w34 + w39) + w31*(w36 + w40) + w32*(w38 + w41))/(w42 + w43)
        w44 = e/w43
        error[1, at] = w39*w44
        error[2, at] = w40*w44
        error[3, at] = w41*w44
    return error


def correction(positions, deviation):
    """Moves of the linear axes that displace the ideal tool point by the given vector.

    Source: Eqs. (53)-(55), inverse. Operations: 1 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        deviation (3, n): displacement of the tool point in the workpiece frame [mm]
            rows: dx dy dz

    Returns:
        moves (3, n): moves of X Y Z [mm]
            rows: move_x move_y move_z
    """
    n, positions, deviation = _points(positions=(positions, 3), deviation=(deviation, 3))
    moves = np.zeros((3, n))
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        dx = deviation[0, at]
        dy = deviation[1, at]
        dz = deviation[2, at]
        # per point
        moves[0, at] = dx
        moves[1, at] = -dy
        moves[2, at] = dz
    return moves


def motion_X(positions, errors, parameters, tool_point):
    """Motion equation of X: displacement of the tool point since home, to first order.

    Source: Eqs. (7)-(11). Operations: 18 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (9,): home positions and location errors [mm, rad]
            rows: q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz eps_xz
        tool_point (3, n): point in the tool frame [mm]
            rows: rTx rTy rTz

    Returns:
        displacement (3, n): tool point, displacement since home, in the bed frame [mm]
            rows: dx dy dz
    """
    n, positions, errors, tool_point = _points(positions=(positions, 3), errors=(errors, 18), tool_point=(tool_point, 3))
    parameters = _constant("parameters", parameters, (9,))
    displacement = np.zeros((3, n))
    # constants
    q_Tx = float(parameters[3])
    q_Ty = float(parameters[4])
    q_Tz = float(parameters[5])
    eps_xy = float(parameters[6])
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
        displacement[1, at] = -EAX*w0 + ECX*w2 + EYX + eps_xy*x
        displacement[2, at] = EAX*w1 - EBX*w2 + EZX
    return displacement


def motion_Y(positions, errors, parameters, workpiece_point):
    """Motion equation of Y: displacement of the workpiece point since home, to first order.

    Source: Eqs. (7)-(11). Operations: 16 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (9,): home positions and location errors [mm, rad]
            rows: q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz eps_xz
        workpiece_point (3, n): point in the workpiece frame [mm]
            rows: rWx rWy rWz

    Returns:
        displacement (3, n): workpiece point, displacement since home, in the bed frame [mm]
            rows: dx dy dz
    """
    n, positions, errors, workpiece_point = _points(positions=(positions, 3), errors=(errors, 18), workpiece_point=(workpiece_point, 3))
    parameters = _constant("parameters", parameters, (9,))
    displacement = np.zeros((3, n))
    # constants
    q_wx = float(parameters[0])
    q_wy = float(parameters[1])
    q_wz = float(parameters[2])
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
        w0 = q_wz + rWz
        w1 = q_wy + rWy
        displacement[0, at] = EBY*w0 - ECY*w1 + EXY
        w2 = q_wx + rWx
        displacement[1, at] = -EAY*w0 + ECY*w2 + EYY + y
        displacement[2, at] = EAY*w1 - EBY*w2 + EZY
    return displacement


def motion_Z(positions, errors, parameters, tool_point):
    """Motion equation of Z: displacement of the tool point since home, to first order.

    Source: Eqs. (7)-(11). Operations: 20 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (9,): home positions and location errors [mm, rad]
            rows: q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz eps_xz
        tool_point (3, n): point in the tool frame [mm]
            rows: rTx rTy rTz

    Returns:
        displacement (3, n): tool point, displacement since home, in the bed frame [mm]
            rows: dx dy dz
    """
    n, positions, errors, tool_point = _points(positions=(positions, 3), errors=(errors, 18), tool_point=(tool_point, 3))
    parameters = _constant("parameters", parameters, (9,))
    displacement = np.zeros((3, n))
    # constants
    q_Tx = float(parameters[3])
    q_Ty = float(parameters[4])
    q_Tz = float(parameters[5])
    eps_yz = float(parameters[7])
    eps_xz = float(parameters[8])
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
        displacement[0, at] = EBZ*w0 - ECZ*w1 + EXZ + eps_xz*z
        w2 = q_Tx + rTx
        displacement[1, at] = -EAZ*w0 + ECZ*w2 + EYZ - eps_yz*z
        displacement[2, at] = EAZ*w1 - EBZ*w2 + EZZ + z
    return displacement


def motion_XY(positions, errors, parameters, workpiece_point, tool_point):
    """Motion equation of X and Y: displacement of the workpiece point minus tool point since home, to first order.

    Source: Eqs. (7)-(11). Operations: 37 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (9,): home positions and location errors [mm, rad]
            rows: q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz eps_xz
        workpiece_point (3, n): point in the workpiece frame [mm]
            rows: rWx rWy rWz
        tool_point (3, n): point in the tool frame [mm]
            rows: rTx rTy rTz

    Returns:
        displacement (3, n): workpiece point minus tool point, displacement since home, in the bed frame [mm]
            rows: dx dy dz
    """
    n, positions, errors, workpiece_point, tool_point = _points(positions=(positions, 3), errors=(errors, 18), workpiece_point=(workpiece_point, 3), tool_point=(tool_point, 3))
    parameters = _constant("parameters", parameters, (9,))
    displacement = np.zeros((3, n))
    # constants
    q_wx = float(parameters[0])
    q_wy = float(parameters[1])
    q_wz = float(parameters[2])
    q_Tx = float(parameters[3])
    q_Ty = float(parameters[4])
    q_Tz = float(parameters[5])
    eps_xy = float(parameters[6])
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
        w0 = q_wz + rWz
        w1 = q_Ty + rTy
        w2 = q_Tz + rTz
        w3 = q_wy + rWy
        displacement[0, at] = -EBX*w2 + EBY*w0 + ECX*w1 - ECY*w3 - EXX + EXY - x
        w4 = q_wx + rWx
        w5 = q_Tx + rTx
        displacement[1, at] = EAX*w2 - EAY*w0 - ECX*w5 + ECY*w4 - EYX + EYY - eps_xy*x + y
        displacement[2, at] = -EAX*w1 + EAY*w3 + EBX*w5 - EBY*w4 - EZX + EZY
    return displacement


def motion_XZ(positions, errors, parameters, tool_point):
    """Motion equation of X and Z: displacement of the tool point since home, to first order.

    Source: Eqs. (7)-(11). Operations: 41 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (9,): home positions and location errors [mm, rad]
            rows: q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz eps_xz
        tool_point (3, n): point in the tool frame [mm]
            rows: rTx rTy rTz

    Returns:
        displacement (3, n): tool point, displacement since home, in the bed frame [mm]
            rows: dx dy dz
    """
    n, positions, errors, tool_point = _points(positions=(positions, 3), errors=(errors, 18), tool_point=(tool_point, 3))
    parameters = _constant("parameters", parameters, (9,))
    displacement = np.zeros((3, n))
    # constants
    q_Tx = float(parameters[3])
    q_Ty = float(parameters[4])
    q_Tz = float(parameters[5])
    eps_xy = float(parameters[6])
    eps_yz = float(parameters[7])
    eps_xz = float(parameters[8])
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
        displacement[0, at] = EBX*w1 + EBZ*w0 + ECX*w3 + ECZ*w3 + EXX + EXZ + eps_xz*z + x
        w4 = q_Tx + rTx
        displacement[1, at] = -EAX*w1 - EAZ*w0 + ECX*w4 + ECZ*w4 + EYX + EYZ + eps_xy*x - eps_yz*z
        w5 = -w4
        displacement[2, at] = EAX*w2 + EAZ*w2 + EBX*w5 + EBZ*w5 + EZX + EZZ + z
    return displacement


def motion_YZ(positions, errors, parameters, workpiece_point, tool_point):
    """Motion equation of Y and Z: displacement of the workpiece point minus tool point since home, to first order.

    Source: Eqs. (7)-(11). Operations: 39 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (9,): home positions and location errors [mm, rad]
            rows: q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz eps_xz
        workpiece_point (3, n): point in the workpiece frame [mm]
            rows: rWx rWy rWz
        tool_point (3, n): point in the tool frame [mm]
            rows: rTx rTy rTz

    Returns:
        displacement (3, n): workpiece point minus tool point, displacement since home, in the bed frame [mm]
            rows: dx dy dz
    """
    n, positions, errors, workpiece_point, tool_point = _points(positions=(positions, 3), errors=(errors, 18), workpiece_point=(workpiece_point, 3), tool_point=(tool_point, 3))
    parameters = _constant("parameters", parameters, (9,))
    displacement = np.zeros((3, n))
    # constants
    q_wx = float(parameters[0])
    q_wy = float(parameters[1])
    q_wz = float(parameters[2])
    q_Tx = float(parameters[3])
    q_Ty = float(parameters[4])
    q_Tz = float(parameters[5])
    eps_yz = float(parameters[7])
    eps_xz = float(parameters[8])
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
        w0 = q_wz + rWz
        w1 = q_Ty + rTy
        w2 = q_Tz + rTz
        w3 = q_wy + rWy
        displacement[0, at] = EBY*w0 - EBZ*w2 - ECY*w3 + ECZ*w1 + EXY - EXZ - eps_xz*z
        w4 = q_wx + rWx
        w5 = q_Tx + rTx
        displacement[1, at] = -EAY*w0 + EAZ*w2 + ECY*w4 - ECZ*w5 + EYY - EYZ + eps_yz*z + y
        displacement[2, at] = EAY*w3 - EAZ*w1 - EBY*w4 + EBZ*w5 + EZY - EZZ - z
    return displacement


def system_1(readings, positions, errors, parameters, points):
    """EXX, ECX, EBX from the readings X-1, X-2, X-3.

    Source: Sects. 3.2-3.5, closed form. Operations: 39 per point, 22 per call.

    Arguments (float64):
        readings (3, n): displacements read in X-1, X-2, X-3, less those of the error-free machine [mm]
            rows: L1 L2 L3
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (9,): home positions and location errors [mm, rad]
            rows: q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz eps_xz
        points (3, 3): xyz of tool point 1, xyz of tool point 2, xyz of tool point 3 [mm]
            rows: rT1x rT1y rT1z rT2x rT2y rT2z rT3x rT3y rT3z

    Returns:
        unknowns (3, n): EXX, ECX, EBX [mm, rad]
            rows: identified_EXX identified_ECX identified_EBX
    """
    n, readings, positions, errors = _points(readings=(readings, 3), positions=(positions, 3), errors=(errors, 18))
    parameters = _constant("parameters", parameters, (9,))
    points = _constant("points", points, (3, 3))
    unknowns = np.zeros((3, n))
    # constants
    q_Ty = float(parameters[4])
    q_Tz = float(parameters[5])
    rT1y = float(points[0, 1])
    rT1z = float(points[0, 2])
    rT2y = float(points[1, 1])
    rT2z = float(points[1, 2])
    rT3y = float(points[2, 1])
    rT3z = float(points[2, 2])
    # once per call
    w0 = q_Ty*rT2z
    w1 = q_Tz*rT2y
    w2 = rT2y*rT3z
    w3 = -q_Ty*rT3z + q_Tz*rT3y
    w4 = rT1y*rT2z
    w5 = -rT1y*rT3z + rT1z*rT3y
    w6 = 1.0/(rT1z*rT2y + rT2z*rT3y - w2 - w4 - w5)
    w8 = q_Ty*rT1z - q_Tz*rT1y
    w11 = -rT3z
    w12 = -rT3y
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        L1 = readings[0, at]
        L2 = readings[1, at]
        L3 = readings[2, at]
        # per point
        w7 = L1*w6
        w9 = L2*w6
        w10 = L3*w6
        unknowns[0, at] = w10*(rT1z*rT2y - w0 + w1 - w4 + w8) + w7*(rT2z*rT3y + w0 - w1 - w2 + w3) + w9*(-w3 - w5 - w8)
        unknowns[1, at] = w10*(rT1z - rT2z) + w7*(rT2z + w11) + w9*(-rT1z - w11)
        unknowns[2, at] = w10*(rT1y - rT2y) + w7*(rT2y + w12) + w9*(-rT1y - w12)
    return unknowns


def system_2(readings, positions, errors, parameters, points):
    """EYY, ECY, EAY from the readings Y-4, Y-5, Y-6.

    Source: Sects. 3.2-3.5, closed form. Operations: 39 per point, 22 per call.

    Arguments (float64):
        readings (3, n): displacements read in Y-4, Y-5, Y-6, less those of the error-free machine [mm]
            rows: L1 L2 L3
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (9,): home positions and location errors [mm, rad]
            rows: q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz eps_xz
        points (3, 3): xyz of workpiece point 1, xyz of workpiece point 2, xyz of workpiece point 3 [mm]
            rows: rW1x rW1y rW1z rW2x rW2y rW2z rW3x rW3y rW3z

    Returns:
        unknowns (3, n): EYY, ECY, EAY [mm, rad]
            rows: identified_EYY identified_ECY identified_EAY
    """
    n, readings, positions, errors = _points(readings=(readings, 3), positions=(positions, 3), errors=(errors, 18))
    parameters = _constant("parameters", parameters, (9,))
    points = _constant("points", points, (3, 3))
    unknowns = np.zeros((3, n))
    # constants
    q_wx = float(parameters[0])
    q_wz = float(parameters[2])
    rW1x = float(points[0, 0])
    rW1z = float(points[0, 2])
    rW2x = float(points[1, 0])
    rW2z = float(points[1, 2])
    rW3x = float(points[2, 0])
    rW3z = float(points[2, 2])
    # once per call
    w0 = q_wx*rW2z
    w1 = q_wz*rW2x
    w2 = rW2x*rW3z
    w3 = -q_wx*rW3z + q_wz*rW3x
    w4 = rW1x*rW2z
    w5 = -rW1x*rW3z + rW1z*rW3x
    w6 = 1.0/(rW1z*rW2x + rW2z*rW3x - w2 - w4 - w5)
    w8 = q_wx*rW1z - q_wz*rW1x
    w11 = -rW3z
    w12 = -rW3x
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        L1 = readings[0, at]
        L2 = readings[1, at]
        L3 = readings[2, at]
        # per point
        w7 = L1*w6
        w9 = L2*w6
        w10 = L3*w6
        unknowns[0, at] = w10*(rW1z*rW2x - w0 + w1 - w4 + w8) + w7*(rW2z*rW3x + w0 - w1 - w2 + w3) + w9*(-w3 - w5 - w8)
        unknowns[1, at] = w10*(-rW1z + rW2z) + w7*(-rW2z - w11) + w9*(rW1z + w11)
        unknowns[2, at] = w10*(-rW1x + rW2x) + w7*(-rW2x - w12) + w9*(rW1x + w12)
    return unknowns


def system_3(readings, positions, errors, parameters, points):
    """EZZ, EBZ, EAZ from the readings Z-7, Z-8, Z-9. At the points of these runs the rank is 2: division by zero there.

    Source: Sects. 3.2-3.5, closed form. Operations: 39 per point, 22 per call.

    Arguments (float64):
        readings (3, n): displacements read in Z-7, Z-8, Z-9, less those of the error-free machine [mm]
            rows: L1 L2 L3
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (9,): home positions and location errors [mm, rad]
            rows: q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz eps_xz
        points (3, 3): xyz of tool point 1, xyz of tool point 2, xyz of tool point 3 [mm]
            rows: rT4x rT4y rT4z rT5x rT5y rT5z rT6x rT6y rT6z

    Returns:
        unknowns (3, n): EZZ, EBZ, EAZ [mm, rad]
            rows: identified_EZZ identified_EBZ identified_EAZ
    """
    n, readings, positions, errors = _points(readings=(readings, 3), positions=(positions, 3), errors=(errors, 18))
    parameters = _constant("parameters", parameters, (9,))
    points = _constant("points", points, (3, 3))
    unknowns = np.zeros((3, n))
    # constants
    q_Tx = float(parameters[3])
    q_Ty = float(parameters[4])
    rT4x = float(points[0, 0])
    rT4y = float(points[0, 1])
    rT5x = float(points[1, 0])
    rT5y = float(points[1, 1])
    rT6x = float(points[2, 0])
    rT6y = float(points[2, 1])
    # once per call
    w0 = q_Tx*rT5y
    w1 = q_Ty*rT5x
    w2 = rT5x*rT6y
    w3 = -q_Tx*rT6y + q_Ty*rT6x
    w4 = rT4x*rT5y
    w5 = -rT4x*rT6y + rT4y*rT6x
    w6 = 1.0/(rT4y*rT5x + rT5y*rT6x - w2 - w4 - w5)
    w8 = q_Tx*rT4y - q_Ty*rT4x
    w11 = -rT6y
    w12 = -rT6x
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        L1 = readings[0, at]
        L2 = readings[1, at]
        L3 = readings[2, at]
        # per point
        w7 = L1*w6
        w9 = L2*w6
        w10 = L3*w6
        unknowns[0, at] = w10*(rT4y*rT5x - w0 + w1 - w4 + w8) + w7*(rT5y*rT6x + w0 - w1 - w2 + w3) + w9*(-w3 - w5 - w8)
        unknowns[1, at] = w10*(rT4y - rT5y) + w7*(rT5y + w11) + w9*(-rT4y - w11)
        unknowns[2, at] = w10*(rT4x - rT5x) + w7*(rT5x + w12) + w9*(-rT4x - w12)
    return unknowns


def system_4(readings, positions, errors, parameters, points):
    """EXZ, ECZ from the readings XZ-1x, XZ-2x.

    Source: Sects. 3.2-3.5, closed form. Operations: 25 per point, 7 per call.

    Arguments (float64):
        readings (2, n): displacements read in XZ-1x, XZ-2x, less those of the error-free machine [mm]
            rows: L1 L2
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (9,): home positions and location errors [mm, rad]
            rows: q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz eps_xz
        points (2, 3): xyz of tool point 1, xyz of tool point 2 [mm]
            rows: rT7x rT7y rT7z rT8x rT8y rT8z

    Returns:
        unknowns (2, n): EXZ, ECZ [mm, rad]
            rows: identified_EXZ identified_ECZ
    """
    n, readings, positions, errors = _points(readings=(readings, 2), positions=(positions, 3), errors=(errors, 18))
    parameters = _constant("parameters", parameters, (9,))
    points = _constant("points", points, (2, 3))
    unknowns = np.zeros((2, n))
    # constants
    q_Ty = float(parameters[4])
    q_Tz = float(parameters[5])
    eps_xz = float(parameters[8])
    rT7y = float(points[0, 1])
    rT7z = float(points[0, 2])
    rT8y = float(points[1, 1])
    rT8z = float(points[1, 2])
    # once per call
    w0 = q_Ty + rT7y
    w1 = 1.0/(rT7y - rT8y)
    w2 = -q_Ty - rT8y
    w3 = q_Tz + rT8z
    w6 = q_Tz + rT7z
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        L1 = readings[0, at]
        L2 = readings[1, at]
        z = positions[2, at]
        EXX = errors[0, at]
        EBX = errors[4, at]
        ECX = errors[5, at]
        EBZ = errors[16, at]
        # per point
        w4 = EXX + eps_xz*z
        w5 = -EBX*(w3 + z) - EBZ*w3 - ECX*w2 + L2 - w4
        w7 = w1*(-EBX*(w6 + z) - EBZ*w6 + ECX*w0 + L1 - w4)
        unknowns[0, at] = w0*w1*w5 + w2*w7
        unknowns[1, at] = w1*w5 - w7
    return unknowns


def system_5(readings, positions, errors, parameters, points):
    """EZX, EAX from the readings XZ-1z, XZ-2z.

    Source: Sects. 3.2-3.5, closed form. Operations: 21 per point, 8 per call.

    Arguments (float64):
        readings (2, n): displacements read in XZ-1z, XZ-2z, less those of the error-free machine [mm]
            rows: L1 L2
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (9,): home positions and location errors [mm, rad]
            rows: q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz eps_xz
        points (2, 3): xyz of tool point 1, xyz of tool point 2 [mm]
            rows: rT7x rT7y rT7z rT8x rT8y rT8z

    Returns:
        unknowns (2, n): EZX, EAX [mm, rad]
            rows: identified_EZX identified_EAX
    """
    n, readings, positions, errors = _points(readings=(readings, 2), positions=(positions, 3), errors=(errors, 18))
    parameters = _constant("parameters", parameters, (9,))
    points = _constant("points", points, (2, 3))
    unknowns = np.zeros((2, n))
    # constants
    q_Tx = float(parameters[3])
    q_Ty = float(parameters[4])
    rT7x = float(points[0, 0])
    rT7y = float(points[0, 1])
    rT8x = float(points[1, 0])
    rT8y = float(points[1, 1])
    # once per call
    w0 = q_Ty + rT8y
    w1 = 1.0/(-rT7y + rT8y)
    w2 = q_Ty + rT7y
    w3 = -q_Tx - rT7x
    w5 = -q_Tx - rT8x
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        L1 = readings[0, at]
        L2 = readings[1, at]
        EBX = errors[4, at]
        EZZ = errors[14, at]
        EAZ = errors[15, at]
        EBZ = errors[16, at]
        # per point
        w4 = w1*(-EAZ*w2 - EBX*w3 - EBZ*w3 - EZZ + L1)
        w6 = -EAZ*w0 - EBX*w5 - EBZ*w5 - EZZ + L2
        unknowns[0, at] = w0*w4 - w1*w2*w6
        unknowns[1, at] = w1*w6 - w4
    return unknowns


def system_6(readings, positions, errors, parameters, points):
    """EXY, EBY from the readings XY-1x, XY-2x.

    Source: Sects. 3.2-3.5, closed form. Operations: 34 per point, 2 per call.

    Arguments (float64):
        readings (2, n): displacements read in XY-1x, XY-2x, less those of the error-free machine [mm]
            rows: L1 L2
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (9,): home positions and location errors [mm, rad]
            rows: q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz eps_xz
        points (4, 3): xyz of workpiece point 1, xyz of tool point 2, xyz of workpiece point 3, xyz of tool point 4 [mm]
            rows: rW4x rW4y rW4z rT9x rT9y rT9z rW5x rW5y rW5z rT10x rT10y rT10z

    Returns:
        unknowns (2, n): EXY, EBY [mm, rad]
            rows: identified_EXY identified_EBY
    """
    n, readings, positions, errors = _points(readings=(readings, 2), positions=(positions, 3), errors=(errors, 18))
    parameters = _constant("parameters", parameters, (9,))
    points = _constant("points", points, (4, 3))
    unknowns = np.zeros((2, n))
    # constants
    q_wy = float(parameters[1])
    q_wz = float(parameters[2])
    q_Ty = float(parameters[4])
    q_Tz = float(parameters[5])
    rW4y = float(points[0, 1])
    rW4z = float(points[0, 2])
    rT9y = float(points[1, 1])
    rT9z = float(points[1, 2])
    rW5y = float(points[2, 1])
    rW5z = float(points[2, 2])
    rT10y = float(points[3, 1])
    rT10z = float(points[3, 2])
    # once per call
    w0 = 1.0/(-rW4z + rW5z)
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        L1 = readings[0, at]
        L2 = readings[1, at]
        EXX = errors[0, at]
        EBX = errors[4, at]
        ECX = errors[5, at]
        ECY = errors[11, at]
        # per point
        w1 = -EXX
        w2 = w0*(-EBX*(-q_Tz - rT9z) - ECX*(q_Ty + rT9y) - ECY*(-q_wy - rW4y) + L1 - w1)
        w3 = w0*(-EBX*(-q_Tz - rT10z) - ECX*(q_Ty + rT10y) - ECY*(-q_wy - rW5y) + L2 - w1)
        unknowns[0, at] = w2*(q_wz + rW5z) + w3*(-q_wz - rW4z)
        unknowns[1, at] = -w2 + w3
    return unknowns


def system_7(readings, positions, errors, parameters, points):
    """EYX from the readings XY-1y.

    Source: Sects. 3.2-3.5, closed form. Operations: 17 per point.

    Arguments (float64):
        readings (1, n): displacements read in XY-1y, less those of the error-free machine [mm]
            rows: L1
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (9,): home positions and location errors [mm, rad]
            rows: q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz eps_xz
        points (2, 3): xyz of workpiece point 1, xyz of tool point 2 [mm]
            rows: rW4x rW4y rW4z rT9x rT9y rT9z

    Returns:
        unknowns (1, n): EYX [mm, rad]
            rows: identified_EYX
    """
    n, readings, positions, errors = _points(readings=(readings, 1), positions=(positions, 3), errors=(errors, 18))
    parameters = _constant("parameters", parameters, (9,))
    points = _constant("points", points, (2, 3))
    unknowns = np.zeros((1, n))
    # constants
    q_wx = float(parameters[0])
    q_wz = float(parameters[2])
    q_Tx = float(parameters[3])
    q_Tz = float(parameters[5])
    eps_xy = float(parameters[6])
    rW4x = float(points[0, 0])
    rW4z = float(points[0, 2])
    rT9x = float(points[1, 0])
    rT9z = float(points[1, 2])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        L1 = readings[0, at]
        x = positions[0, at]
        EAX = errors[3, at]
        ECX = errors[5, at]
        EYY = errors[7, at]
        EAY = errors[9, at]
        ECY = errors[11, at]
        # per point
        unknowns[0, at] = EAX*(q_Tz + rT9z) + EAY*(-q_wz - rW4z) + ECX*(-q_Tx - rT9x) + ECY*(q_wx + rW4x) + EYY - L1 - eps_xy*x
    return unknowns


def system_8(readings, positions, errors, parameters, points):
    """EYZ from the readings YZ-1y.

    Source: Sects. 3.2-3.5, closed form. Operations: 17 per point.

    Arguments (float64):
        readings (1, n): displacements read in YZ-1y, less those of the error-free machine [mm]
            rows: L1
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (9,): home positions and location errors [mm, rad]
            rows: q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz eps_xz
        points (2, 3): xyz of workpiece point 1, xyz of tool point 2 [mm]
            rows: rW6x rW6y rW6z rT11x rT11y rT11z

    Returns:
        unknowns (1, n): EYZ [mm, rad]
            rows: identified_EYZ
    """
    n, readings, positions, errors = _points(readings=(readings, 1), positions=(positions, 3), errors=(errors, 18))
    parameters = _constant("parameters", parameters, (9,))
    points = _constant("points", points, (2, 3))
    unknowns = np.zeros((1, n))
    # constants
    q_wx = float(parameters[0])
    q_wz = float(parameters[2])
    q_Tx = float(parameters[3])
    q_Tz = float(parameters[5])
    eps_yz = float(parameters[7])
    rW6x = float(points[0, 0])
    rW6z = float(points[0, 2])
    rT11x = float(points[1, 0])
    rT11z = float(points[1, 2])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        L1 = readings[0, at]
        z = positions[2, at]
        EYY = errors[7, at]
        EAY = errors[9, at]
        ECY = errors[11, at]
        EAZ = errors[15, at]
        ECZ = errors[17, at]
        # per point
        unknowns[0, at] = EAY*(-q_wz - rW6z) + EAZ*(q_Tz + rT11z) + ECY*(q_wx + rW6x) + ECZ*(-q_Tx - rT11x) + EYY - L1 + eps_yz*z
    return unknowns


def system_9(readings, positions, errors, parameters, points):
    """EZY from the readings YZ-1z.

    Source: Sects. 3.2-3.5, closed form. Operations: 15 per point.

    Arguments (float64):
        readings (1, n): displacements read in YZ-1z, less those of the error-free machine [mm]
            rows: L1
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (9,): home positions and location errors [mm, rad]
            rows: q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz eps_xz
        points (2, 3): xyz of workpiece point 1, xyz of tool point 2 [mm]
            rows: rW6x rW6y rW6z rT11x rT11y rT11z

    Returns:
        unknowns (1, n): EZY [mm, rad]
            rows: identified_EZY
    """
    n, readings, positions, errors = _points(readings=(readings, 1), positions=(positions, 3), errors=(errors, 18))
    parameters = _constant("parameters", parameters, (9,))
    points = _constant("points", points, (2, 3))
    unknowns = np.zeros((1, n))
    # constants
    q_wx = float(parameters[0])
    q_wy = float(parameters[1])
    q_Tx = float(parameters[3])
    q_Ty = float(parameters[4])
    rW6x = float(points[0, 0])
    rW6y = float(points[0, 1])
    rT11x = float(points[1, 0])
    rT11y = float(points[1, 1])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        L1 = readings[0, at]
        EAY = errors[9, at]
        EBY = errors[10, at]
        EZZ = errors[14, at]
        EAZ = errors[15, at]
        EBZ = errors[16, at]
        # per point
        unknowns[0, at] = -EAY*(q_wy + rW6y) - EAZ*(-q_Ty - rT11y) - EBY*(-q_wx - rW6x) - EBZ*(q_Tx + rT11x) + EZZ + L1
    return unknowns
