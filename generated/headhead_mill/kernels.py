# Generated from machines/headhead_mill.toml, do not edit; regenerate with: trueaxis derive machines/headhead_mill.toml
# SPDX-License-Identifier: MIT
"""Kernels of Five-axis gantry mill with a fork head: geometric error model in NumPy.

Arrays are float64 with the quantity first and the point last: positions (n_axes, n), errors (n_components, n),
deviation (3, n). An array that is the same at all points may have n = 1. Lengths mm, angles rad, positions of
rotary axes deg.
An array of another shape is a ValueError that names it.

Equations after: Prediction and compensation of geometric error for translational axes in multi-axis machine tools
"""

import numpy as np

ABI = 3
SPEC_HASH = "0ad0abbfc8d51366123f481bf464ef2a99342c0dbb5431fe1300b173adc7b15c"

META = {
    'machine': 'headhead_mill',
    'title': 'Five-axis gantry mill with a fork head',
    'axes': ['X', 'Y', 'Z', 'B', 'C'],
    'position_units': ['mm', 'mm', 'mm', 'deg', 'deg'],
    'travel': {
        'X': [-2000.0, 2000.0],
        'Y': [-1000.0, 1000.0],
        'Z': [-1000.0, 1000.0],
        'B': [-120.0, 120.0],
        'C': [-360.0, 360.0],
    },
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
        'q_Bx', 'q_By', 'q_Bz', 'q_Tx', 'q_Ty', 'q_Tz', 'EC0Y', 'EA0Z', 'EB0Z', 'EX0C', 'EY0C', 'EA0C', 'EB0C',
        'EX0B', 'EZ0B', 'EA0B', 'EC0B', 'EX0T', 'EY0T', 'EZ0T',
    ],
    'parameter_units': [
        'mm', 'mm', 'mm', 'mm', 'mm', 'mm', 'rad', 'rad', 'rad', 'mm', 'mm', 'rad', 'rad', 'mm', 'mm', 'rad', 'rad',
        'mm', 'mm', 'mm',
    ],
    'parameter_descriptions': [
        'home position along X, body 7 (B head) on body 6', 'home position along Y, body 7 (B head) on body 6',
        'home position along Z, body 7 (B head) on body 6', 'home position along X, body 8 (tool) on body 7',
        'home position along Y, body 8 (tool) on body 7', 'home position along Z, body 8 (tool) on body 7',
        'location error: squareness error of Y to X, about Z; Y slide on X slide',
        'location error: squareness error of Z to Y, about X; Z slide on Y slide',
        'location error: squareness error of Z to X, about Y; Z slide on Y slide',
        'location error: error of the position of C in X; C head on Z slide',
        'location error: error of the position of C in Y; C head on Z slide',
        'location error: error of the orientation of C about X; C head on Z slide',
        'location error: error of the orientation of C about Y; C head on Z slide',
        'location error: error of the position of B in X; B head on C head',
        'location error: error of the position of B in Z; B head on C head',
        'location error: error of the orientation of B about X; B head on C head',
        'location error: error of the orientation of B about Z; B head on C head',
        'location error: displacement along X; tool on B head',
        'location error: displacement along Y; tool on B head',
        'location error: displacement along Z; tool on B head',
    ],
    'dimensions': ['q_Bx', 'q_By', 'q_Bz', 'q_Tx', 'q_Ty', 'q_Tz'],
    'location_errors': [
        'EC0Y', 'EA0Z', 'EB0Z', 'EX0C', 'EY0C', 'EA0C', 'EB0C', 'EX0B', 'EZ0B', 'EA0B', 'EC0B', 'EX0T', 'EY0T',
        'EZ0T',
    ],
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
                {'name': 'parameters', 'shape': [20], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'ideal', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 53,
            'operations_per_call': 0,
        },
        'tool_in_workpiece_deviation': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [20], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 173,
            'operations_per_call': 0,
        },
        'tool_in_workpiece_deviation_first_order': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [20], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 147,
            'operations_per_call': 0,
        },
        'tool_in_workpiece_sensitivity': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'parameters', 'shape': [20], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'sensitivity', 'shape': [3, 44], 'per_point': True, 'unit': 'mm/mm, mm/rad'}],
            'operations': 129,
            'operations_per_call': 0,
        },
        'tool_in_bed_ideal': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'parameters', 'shape': [20], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'ideal', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 53,
            'operations_per_call': 0,
        },
        'tool_in_bed_deviation': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [20], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 173,
            'operations_per_call': 0,
        },
        'tool_in_bed_deviation_first_order': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [20], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 147,
            'operations_per_call': 0,
        },
        'tool_in_bed_sensitivity': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'parameters', 'shape': [20], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'sensitivity', 'shape': [3, 44], 'per_point': True, 'unit': 'mm/mm, mm/rad'}],
            'operations': 129,
            'operations_per_call': 0,
        },
        'workpiece_in_bed_ideal': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'parameters', 'shape': [20], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'ideal', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 0,
            'operations_per_call': 0,
        },
        'workpiece_in_bed_deviation': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [20], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 0,
            'operations_per_call': 0,
        },
        'workpiece_in_bed_deviation_first_order': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [20], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 0,
            'operations_per_call': 0,
        },
        'workpiece_in_bed_sensitivity': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'parameters', 'shape': [20], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'sensitivity', 'shape': [3, 44], 'per_point': True, 'unit': 'mm/mm, mm/rad'}],
            'operations': 0,
            'operations_per_call': 0,
        },
        'bed_in_workpiece_ideal': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'parameters', 'shape': [20], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'ideal', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 0,
            'operations_per_call': 0,
        },
        'bed_in_workpiece_deviation': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [20], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 0,
            'operations_per_call': 0,
        },
        'bed_in_workpiece_deviation_first_order': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [20], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 0,
            'operations_per_call': 0,
        },
        'bed_in_workpiece_sensitivity': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'parameters', 'shape': [20], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'sensitivity', 'shape': [3, 44], 'per_point': True, 'unit': 'mm/mm, mm/rad'}],
            'operations': 0,
            'operations_per_call': 0,
        },
        'tool_in_workpiece_position': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [20], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'position', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 177,
            'operations_per_call': 0,
        },
        'tool_in_workpiece_position_first_order': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [20], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'position', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 151,
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
                {'name': 'parameters', 'shape': [20], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'direction', 'shape': [3], 'per_point': True, 'unit': '1'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': '1'}],
            'operations': 140,
            'operations_per_call': 0,
        },
        'tool_orientation_deviation_first_order': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [20], 'per_point': False, 'unit': 'mm, rad'},
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
                {'name': 'parameters', 'shape': [20], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': False, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 556,
            'operations_per_call': 7,
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
                {'name': 'parameters', 'shape': [20], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': False, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 533,
            'operations_per_call': 4,
        },
        'ballbar_error': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [20], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'ball', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'length', 'shape': [1], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'error', 'shape': [4], 'per_point': True, 'unit': 'mm'}],
            'operations': 210,
            'operations_per_call': 0,
        },
        'correction': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'moves', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 0,
            'operations_per_call': 0,
        },
        'motion_X': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [20], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'tool_point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'displacement', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 19,
            'operations_per_call': 0,
        },
        'motion_Y': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [20], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'tool_point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'displacement', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 21,
            'operations_per_call': 0,
        },
        'motion_Z': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [20], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'tool_point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'displacement', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 23,
            'operations_per_call': 0,
        },
        'motion_B': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [20], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'tool_point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'displacement', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 89,
            'operations_per_call': 0,
        },
        'motion_C': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [20], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'tool_point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'displacement', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 118,
            'operations_per_call': 0,
        },
        'motion_XY': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [20], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'tool_point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'displacement', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 40,
            'operations_per_call': 0,
        },
        'motion_XZ': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [20], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'tool_point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'displacement', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 42,
            'operations_per_call': 0,
        },
        'motion_YZ': {
            'inputs': [
                {'name': 'positions', 'shape': [5], 'per_point': True, 'unit': 'mm, rotary axes deg'},
                {'name': 'errors', 'shape': [30], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [20], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'tool_point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'displacement', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 44,
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

    Source: Eqs. (1)-(4) without errors. Operations: 53 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        parameters (20,): home positions and location errors [mm, rad]
            rows: q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T
                EZ0T
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        ideal (3, n): tool point in the workpiece frame, without errors [mm]
            rows: px py pz
    """
    n, positions, point = _points(positions=(positions, 5), point=(point, 3))
    parameters = _constant("parameters", parameters, (20,))
    ideal = np.zeros((3, n))
    # constants
    q_Bx = float(parameters[0])
    q_By = float(parameters[1])
    q_Bz = float(parameters[2])
    q_Tx = float(parameters[3])
    q_Ty = float(parameters[4])
    q_Tz = float(parameters[5])
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
        ideal[0, at] = cos_c*q_Bx - q_By*sin_c + q_Tx*w0 - q_Ty*sin_c + q_Tz*w1 + rx*w0 - ry*sin_c + rz*w1 + x
        w2 = cos_b*sin_c
        w3 = sin_b*sin_c
        ideal[1, at] = cos_c*q_By + cos_c*q_Ty + cos_c*ry + q_Bx*sin_c + q_Tx*w2 + q_Tz*w3 + rx*w2 + rz*w3 + y
        ideal[2, at] = cos_b*q_Tz + cos_b*rz + q_Bz - q_Tx*sin_b - rx*sin_b + z
    return ideal


def tool_in_workpiece_deviation(positions, errors, parameters, point):
    """Deviation of a tool point in the workpiece frame, exact.

    Source: Eqs. (1)-(4). Operations: 173 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB
                ECB EXC EYC EZC EAC EBC ECC
        parameters (20,): home positions and location errors [mm, rad]
            rows: q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T
                EZ0T
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): tool point in the workpiece frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions, errors, point = _points(positions=(positions, 5), errors=(errors, 30), point=(point, 3))
    parameters = _constant("parameters", parameters, (20,))
    deviation = np.zeros((3, n))
    # constants
    q_Bx = float(parameters[0])
    q_By = float(parameters[1])
    q_Bz = float(parameters[2])
    q_Tx = float(parameters[3])
    q_Ty = float(parameters[4])
    q_Tz = float(parameters[5])
    EC0Y = float(parameters[6])
    EA0Z = float(parameters[7])
    EB0Z = float(parameters[8])
    EX0C = float(parameters[9])
    EY0C = float(parameters[10])
    EA0C = float(parameters[11])
    EB0C = float(parameters[12])
    EX0B = float(parameters[13])
    EZ0B = float(parameters[14])
    EA0B = float(parameters[15])
    EC0B = float(parameters[16])
    EX0T = float(parameters[17])
    EY0T = float(parameters[18])
    EZ0T = float(parameters[19])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
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
        w1 = q_Tz + rz
        w2 = cos_b*w1 - sin_b*w0
        w3 = q_Bz + w2
        w4 = w3 + z
        w5 = cos_b*w0 + sin_b*w1
        w6 = q_Bx + w5
        w7 = q_Ty + ry
        w8 = q_By + w7
        w9 = cos_c*w8 + sin_c*w6
        w10 = EZ0T + w1
        w11 = EX0T + w0
        w12 = -EAB*w10 + ECB*w11 + EY0T + EYB
        w13 = EY0T + w7
        w14 = EBB*w10 - ECB*w13 + EX0T + EXB
        w15 = EAB*w13 - EBB*w11 + EZ0T + EZB
        w16 = cos_b*w14 + sin_b*w15
        w17 = cos_b*w15 - sin_b*w14
        w18 = -EA0B*(w17 + w2) + EC0B*(w16 + w5) + w12
        w19 = w18 + w8
        w20 = w12 + w7
        w21 = -EC0B*w20 + EX0B + w16
        w22 = w21 + w6
        w23 = EA0B*w20 + EZ0B + w17
        w24 = EAC*w19 - EBC*w22 + EZC + w23
        w25 = w24 + w3
        w26 = w23 + w3
        w27 = EBC*w26 - ECC*w19 + EXC + w21
        w28 = -EAC*w26 + ECC*w22 + EYC + w18
        w29 = cos_c*w28 + sin_c*w27
        w30 = -EA0C*w25 + EY0C + w29
        w31 = w30 + w9
        w32 = cos_c*w6 - sin_c*w8
        w33 = cos_c*w27 - sin_c*w28
        w34 = EB0C*w25 + EX0C + w33
        w35 = w32 + w34
        w36 = EA0C*(w29 + w9) - EB0C*(w32 + w33) + w24
        w37 = EAZ*w31 - EBZ*w35 + EZZ + w36
        w38 = w37 + w4
        w39 = w3 + w36
        w40 = -EAZ*w39 + ECZ*w35 + EYZ + w30
        w41 = -EA0Z*w38 + w40
        w42 = w41 + w9
        w43 = EBZ*w39 - ECZ*w31 + EXZ + w34
        w44 = EB0Z*w38 + w43
        w45 = w32 + w44
        w46 = EA0Z*(w40 + w9) - EB0Z*(w32 + w43) + w37
        w47 = EAY*w42 - EBY*w45 + EZY + w46
        w48 = w4 + w47
        w49 = w9 + y
        w50 = w4 + w46
        w51 = EBY*w50 - ECY*w42 + EXY + w44
        w52 = -EAY*w50 + ECY*w45 + EYY + w41
        w53 = EC0Y*(w32 + w51) + w52
        w54 = w49 + w53
        w55 = -EC0Y*(w49 + w52) + w51
        deviation[0, at] = EBX*w48 - ECX*w54 + EXX + w55
        w56 = w32 + w55
        deviation[1, at] = -EAX*w48 + ECX*w56 + EYX + w53
        deviation[2, at] = EAX*w54 - EBX*w56 + EZX + w47
    return deviation


def tool_in_workpiece_deviation_first_order(positions, errors, parameters, point):
    """Deviation of a tool point in the workpiece frame, to first order in the errors.

    Source: Eqs. (1)-(4). Operations: 147 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB
                ECB EXC EYC EZC EAC EBC ECC
        parameters (20,): home positions and location errors [mm, rad]
            rows: q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T
                EZ0T
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): tool point in the workpiece frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions, errors, point = _points(positions=(positions, 5), errors=(errors, 30), point=(point, 3))
    parameters = _constant("parameters", parameters, (20,))
    deviation = np.zeros((3, n))
    # constants
    q_Bx = float(parameters[0])
    q_By = float(parameters[1])
    q_Bz = float(parameters[2])
    q_Tx = float(parameters[3])
    q_Ty = float(parameters[4])
    q_Tz = float(parameters[5])
    EC0Y = float(parameters[6])
    EA0Z = float(parameters[7])
    EB0Z = float(parameters[8])
    EX0C = float(parameters[9])
    EY0C = float(parameters[10])
    EA0C = float(parameters[11])
    EB0C = float(parameters[12])
    EX0B = float(parameters[13])
    EZ0B = float(parameters[14])
    EA0B = float(parameters[15])
    EC0B = float(parameters[16])
    EX0T = float(parameters[17])
    EY0T = float(parameters[18])
    EZ0T = float(parameters[19])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
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
        w1 = q_Tz + rz
        w2 = cos_b*w1 - sin_b*w0
        w3 = q_Bz + w2
        w4 = w3 + z
        w5 = cos_b*w0 + sin_b*w1
        w6 = q_Bx + w5
        w7 = q_Ty + ry
        w8 = q_By + w7
        w9 = cos_c*w8 + sin_c*w6
        w10 = w9 + y
        w11 = EBB*w1 - ECB*w7 + EX0T + EXB
        w12 = EAB*w7 - EBB*w0 + EZ0T + EZB
        w13 = cos_b*w11 + sin_b*w12
        w14 = -EC0B*w7 + EX0B + w13
        w15 = EBC*w3 - ECC*w8 + EXC + w14
        w16 = -EAB*w1 + ECB*w0 + EY0T + EYB
        w17 = -EA0B*w2 + EC0B*w5 + w16
        w18 = -EAC*w3 + ECC*w6 + EYC + w17
        w19 = cos_c*w15 - sin_c*w18
        w20 = EB0C*w3 + EX0C + w19
        w21 = EBZ*w3 - ECZ*w9 + EXZ + w20
        w22 = EB0Z*w4 + w21
        w23 = EBY*w4 - ECY*w9 + EXY + w22
        w24 = -EC0Y*w10 + w23
        deviation[0, at] = EBX*w4 - ECX*w10 + EXX + w24
        w25 = cos_c*w6 - sin_c*w8
        w26 = cos_c*w18 + sin_c*w15
        w27 = -EA0C*w3 + EY0C + w26
        w28 = -EAZ*w3 + ECZ*w25 + EYZ + w27
        w29 = -EA0Z*w4 + w28
        w30 = -EAY*w4 + ECY*w25 + EYY + w29
        w31 = EC0Y*w25 + w30
        deviation[1, at] = -EAX*w4 + ECX*w25 + EYX + w31
        w32 = cos_b*w12 - sin_b*w11
        w33 = EA0B*w7 + EZ0B + w32
        w34 = EAC*w8 - EBC*w6 + EZC + w33
        w35 = EA0C*w9 - EB0C*w25 + w34
        w36 = EAZ*w9 - EBZ*w25 + EZZ + w35
        w37 = EA0Z*w9 - EB0Z*w25 + w36
        w38 = EAY*w9 - EBY*w25 + EZY + w37
        deviation[2, at] = EAX*w10 - EBX*w25 + EZX + w38
    return deviation


def tool_in_workpiece_sensitivity(positions, parameters, point):
    """Sensitivity of a tool point in the workpiece frame to every error, at the error-free machine.

    Source: Eqs. (1)-(4), first order. Operations: 129 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        parameters (20,): home positions and location errors [mm, rad]
            rows: q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T
                EZ0T
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        sensitivity (3, 44, n): derivative of the deviation by each component error, then by each location error [mm/mm, mm/rad]
            rows: dx_EXX dx_EYX .. dz_EZ0T, last index fastest
    """
    n, positions, point = _points(positions=(positions, 5), point=(point, 3))
    parameters = _constant("parameters", parameters, (20,))
    sensitivity = np.zeros((132, n))
    # constants
    q_Bx = float(parameters[0])
    q_By = float(parameters[1])
    q_Bz = float(parameters[2])
    q_Tx = float(parameters[3])
    q_Ty = float(parameters[4])
    q_Tz = float(parameters[5])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
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
        w0 = cos_b*q_Tz
        w1 = cos_b*rz
        w2 = q_Tx*sin_b
        w3 = rx*sin_b
        sensitivity[16, at] = dx_EBZ = q_Bz + w0 + w1 - w2 - w3
        sensitivity[4, at] = dx_EBX = dx_EBZ + z
        w4 = cos_c*q_Ty
        w5 = cos_c*ry
        w6 = q_Tx*sin_c
        w7 = rx*sin_c
        w8 = q_Tz*sin_c
        w9 = rz*sin_c
        w10 = cos_b*w6 + cos_b*w7 + sin_b*w8 + sin_b*w9 + w4 + w5
        sensitivity[97, at] = dz_EAY = cos_c*q_By + q_Bx*sin_c + w10
        sensitivity[91, at] = dz_EAX = dz_EAY + y
        sensitivity[5, at] = dx_ECX = -dz_EAX
        sensitivity[11, at] = dx_ECY = -dz_EAY
        sensitivity[18, at] = dx_EXB = cos_b*cos_c
        sensitivity[19, at] = dx_EYB = -sin_c
        sensitivity[20, at] = dx_EZB = cos_c*sin_b
        sensitivity[22, at] = dx_EBB = cos_c*w0 + cos_c*w1 - cos_c*w2 - cos_c*w3
        sensitivity[39, at] = dx_EA0B = sin_c*w0 + sin_c*w1 - sin_c*w2 - sin_c*w3
        sensitivity[27, at] = dx_EAC = dx_EA0B + q_Bz*sin_c
        sensitivity[28, at] = dx_EBC = cos_c*q_Bz + dx_EBB
        sensitivity[47, at] = dy_EAX = -dx_EBX
        w11 = q_Ty*sin_c
        w12 = ry*sin_c
        sensitivity[84, at] = dy_EC0B = dx_EXB*q_Tx + dx_EXB*rx + dx_EZB*q_Tz + dx_EZB*rz - w11 - w12
        sensitivity[49, at] = dy_ECX = cos_c*q_Bx + dy_EC0B - q_By*sin_c
        sensitivity[59, at] = dy_EAZ = -dx_EBZ
        sensitivity[62, at] = dy_EXB = cos_b*sin_c
        sensitivity[64, at] = dy_EZB = sin_b*sin_c
        sensitivity[92, at] = dz_EBX = -dy_ECX
        sensitivity[106, at] = dz_EXB = -sin_b
        sensitivity[127, at] = dz_EA0B = q_Ty + ry
        sensitivity[0, at] = 1.0
        sensitivity[6, at] = 1.0
        sensitivity[10, at] = dx_EBX
        sensitivity[12, at] = 1.0
        sensitivity[17, at] = dx_ECY
        sensitivity[21, at] = sin_b*w4 + sin_b*w5 + w8 + w9
        sensitivity[23, at] = -cos_b*w4 - cos_b*w5 - w6 - w7
        sensitivity[24, at] = cos_c
        sensitivity[25, at] = dx_EYB
        sensitivity[29, at] = dx_ECY
        sensitivity[30, at] = dx_ECX
        sensitivity[32, at] = dx_EBX
        sensitivity[33, at] = 1.0
        sensitivity[36, at] = dx_EBZ
        sensitivity[37, at] = cos_c
        sensitivity[40, at] = -w10
        sensitivity[41, at] = dx_EXB
        sensitivity[42, at] = dx_EYB
        sensitivity[43, at] = dx_EZB
        sensitivity[45, at] = 1.0
        sensitivity[51, at] = 1.0
        sensitivity[53, at] = dy_EAX
        sensitivity[55, at] = dy_ECX
        sensitivity[57, at] = 1.0
        sensitivity[61, at] = dy_ECX
        sensitivity[63, at] = cos_c
        sensitivity[65, at] = -cos_c*q_Tz - cos_c*rz + q_Ty*sin_b*sin_c + ry*sin_b*sin_c
        sensitivity[66, at] = dx_EA0B
        sensitivity[67, at] = -cos_b*w11 - cos_b*w12 + cos_c*q_Tx + cos_c*rx
        sensitivity[68, at] = sin_c
        sensitivity[69, at] = cos_c
        sensitivity[71, at] = -dx_EBC
        sensitivity[72, at] = dx_EAC
        sensitivity[73, at] = dy_ECX
        sensitivity[74, at] = dy_ECX
        sensitivity[75, at] = dy_EAX
        sensitivity[78, at] = 1.0
        sensitivity[79, at] = dy_EAZ
        sensitivity[81, at] = sin_c
        sensitivity[83, at] = -dx_EBB
        sensitivity[85, at] = dy_EXB
        sensitivity[86, at] = cos_c
        sensitivity[87, at] = dy_EZB
        sensitivity[90, at] = 1.0
        sensitivity[96, at] = 1.0
        sensitivity[98, at] = dz_EBX
        sensitivity[102, at] = 1.0
        sensitivity[103, at] = dz_EAY
        sensitivity[104, at] = dz_EBX
        sensitivity[108, at] = cos_b
        sensitivity[109, at] = cos_b*q_Ty + cos_b*ry
        w13 = cos_b*q_Tx + cos_b*rx + q_Tz*sin_b + rz*sin_b
        sensitivity[110, at] = -w13
        sensitivity[111, at] = q_Ty*sin_b + ry*sin_b
        sensitivity[114, at] = 1.0
        sensitivity[115, at] = dz_EA0B + q_By
        sensitivity[116, at] = -q_Bx - w13
        sensitivity[119, at] = dz_EAY
        sensitivity[120, at] = dz_EBX
        sensitivity[123, at] = dz_EAY
        sensitivity[124, at] = dz_EBX
        sensitivity[126, at] = 1.0
        sensitivity[129, at] = dz_EXB
        sensitivity[131, at] = cos_b
    return sensitivity.reshape(3, 44, n)


def tool_in_bed_ideal(positions, parameters, point):
    """Ideal position of a tool point in the bed frame.

    Source: Eqs. (1)-(4) without errors. Operations: 53 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        parameters (20,): home positions and location errors [mm, rad]
            rows: q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T
                EZ0T
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        ideal (3, n): tool point in the bed frame, without errors [mm]
            rows: px py pz
    """
    n, positions, point = _points(positions=(positions, 5), point=(point, 3))
    parameters = _constant("parameters", parameters, (20,))
    ideal = np.zeros((3, n))
    # constants
    q_Bx = float(parameters[0])
    q_By = float(parameters[1])
    q_Bz = float(parameters[2])
    q_Tx = float(parameters[3])
    q_Ty = float(parameters[4])
    q_Tz = float(parameters[5])
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
        ideal[0, at] = cos_c*q_Bx - q_By*sin_c + q_Tx*w0 - q_Ty*sin_c + q_Tz*w1 + rx*w0 - ry*sin_c + rz*w1 + x
        w2 = cos_b*sin_c
        w3 = sin_b*sin_c
        ideal[1, at] = cos_c*q_By + cos_c*q_Ty + cos_c*ry + q_Bx*sin_c + q_Tx*w2 + q_Tz*w3 + rx*w2 + rz*w3 + y
        ideal[2, at] = cos_b*q_Tz + cos_b*rz + q_Bz - q_Tx*sin_b - rx*sin_b + z
    return ideal


def tool_in_bed_deviation(positions, errors, parameters, point):
    """Deviation of a tool point in the bed frame, exact.

    Source: Eqs. (1)-(4). Operations: 173 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB
                ECB EXC EYC EZC EAC EBC ECC
        parameters (20,): home positions and location errors [mm, rad]
            rows: q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T
                EZ0T
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): tool point in the bed frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions, errors, point = _points(positions=(positions, 5), errors=(errors, 30), point=(point, 3))
    parameters = _constant("parameters", parameters, (20,))
    deviation = np.zeros((3, n))
    # constants
    q_Bx = float(parameters[0])
    q_By = float(parameters[1])
    q_Bz = float(parameters[2])
    q_Tx = float(parameters[3])
    q_Ty = float(parameters[4])
    q_Tz = float(parameters[5])
    EC0Y = float(parameters[6])
    EA0Z = float(parameters[7])
    EB0Z = float(parameters[8])
    EX0C = float(parameters[9])
    EY0C = float(parameters[10])
    EA0C = float(parameters[11])
    EB0C = float(parameters[12])
    EX0B = float(parameters[13])
    EZ0B = float(parameters[14])
    EA0B = float(parameters[15])
    EC0B = float(parameters[16])
    EX0T = float(parameters[17])
    EY0T = float(parameters[18])
    EZ0T = float(parameters[19])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
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
        w1 = q_Tz + rz
        w2 = cos_b*w1 - sin_b*w0
        w3 = q_Bz + w2
        w4 = w3 + z
        w5 = cos_b*w0 + sin_b*w1
        w6 = q_Bx + w5
        w7 = q_Ty + ry
        w8 = q_By + w7
        w9 = cos_c*w8 + sin_c*w6
        w10 = EZ0T + w1
        w11 = EX0T + w0
        w12 = -EAB*w10 + ECB*w11 + EY0T + EYB
        w13 = EY0T + w7
        w14 = EBB*w10 - ECB*w13 + EX0T + EXB
        w15 = EAB*w13 - EBB*w11 + EZ0T + EZB
        w16 = cos_b*w14 + sin_b*w15
        w17 = cos_b*w15 - sin_b*w14
        w18 = -EA0B*(w17 + w2) + EC0B*(w16 + w5) + w12
        w19 = w18 + w8
        w20 = w12 + w7
        w21 = -EC0B*w20 + EX0B + w16
        w22 = w21 + w6
        w23 = EA0B*w20 + EZ0B + w17
        w24 = EAC*w19 - EBC*w22 + EZC + w23
        w25 = w24 + w3
        w26 = w23 + w3
        w27 = EBC*w26 - ECC*w19 + EXC + w21
        w28 = -EAC*w26 + ECC*w22 + EYC + w18
        w29 = cos_c*w28 + sin_c*w27
        w30 = -EA0C*w25 + EY0C + w29
        w31 = w30 + w9
        w32 = cos_c*w6 - sin_c*w8
        w33 = cos_c*w27 - sin_c*w28
        w34 = EB0C*w25 + EX0C + w33
        w35 = w32 + w34
        w36 = EA0C*(w29 + w9) - EB0C*(w32 + w33) + w24
        w37 = EAZ*w31 - EBZ*w35 + EZZ + w36
        w38 = w37 + w4
        w39 = w3 + w36
        w40 = -EAZ*w39 + ECZ*w35 + EYZ + w30
        w41 = -EA0Z*w38 + w40
        w42 = w41 + w9
        w43 = EBZ*w39 - ECZ*w31 + EXZ + w34
        w44 = EB0Z*w38 + w43
        w45 = w32 + w44
        w46 = EA0Z*(w40 + w9) - EB0Z*(w32 + w43) + w37
        w47 = EAY*w42 - EBY*w45 + EZY + w46
        w48 = w4 + w47
        w49 = w9 + y
        w50 = w4 + w46
        w51 = EBY*w50 - ECY*w42 + EXY + w44
        w52 = -EAY*w50 + ECY*w45 + EYY + w41
        w53 = EC0Y*(w32 + w51) + w52
        w54 = w49 + w53
        w55 = -EC0Y*(w49 + w52) + w51
        deviation[0, at] = EBX*w48 - ECX*w54 + EXX + w55
        w56 = w32 + w55
        deviation[1, at] = -EAX*w48 + ECX*w56 + EYX + w53
        deviation[2, at] = EAX*w54 - EBX*w56 + EZX + w47
    return deviation


def tool_in_bed_deviation_first_order(positions, errors, parameters, point):
    """Deviation of a tool point in the bed frame, to first order in the errors.

    Source: Eqs. (1)-(4). Operations: 147 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB
                ECB EXC EYC EZC EAC EBC ECC
        parameters (20,): home positions and location errors [mm, rad]
            rows: q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T
                EZ0T
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): tool point in the bed frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions, errors, point = _points(positions=(positions, 5), errors=(errors, 30), point=(point, 3))
    parameters = _constant("parameters", parameters, (20,))
    deviation = np.zeros((3, n))
    # constants
    q_Bx = float(parameters[0])
    q_By = float(parameters[1])
    q_Bz = float(parameters[2])
    q_Tx = float(parameters[3])
    q_Ty = float(parameters[4])
    q_Tz = float(parameters[5])
    EC0Y = float(parameters[6])
    EA0Z = float(parameters[7])
    EB0Z = float(parameters[8])
    EX0C = float(parameters[9])
    EY0C = float(parameters[10])
    EA0C = float(parameters[11])
    EB0C = float(parameters[12])
    EX0B = float(parameters[13])
    EZ0B = float(parameters[14])
    EA0B = float(parameters[15])
    EC0B = float(parameters[16])
    EX0T = float(parameters[17])
    EY0T = float(parameters[18])
    EZ0T = float(parameters[19])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
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
        w1 = q_Tz + rz
        w2 = cos_b*w1 - sin_b*w0
        w3 = q_Bz + w2
        w4 = w3 + z
        w5 = cos_b*w0 + sin_b*w1
        w6 = q_Bx + w5
        w7 = q_Ty + ry
        w8 = q_By + w7
        w9 = cos_c*w8 + sin_c*w6
        w10 = w9 + y
        w11 = EBB*w1 - ECB*w7 + EX0T + EXB
        w12 = EAB*w7 - EBB*w0 + EZ0T + EZB
        w13 = cos_b*w11 + sin_b*w12
        w14 = -EC0B*w7 + EX0B + w13
        w15 = EBC*w3 - ECC*w8 + EXC + w14
        w16 = -EAB*w1 + ECB*w0 + EY0T + EYB
        w17 = -EA0B*w2 + EC0B*w5 + w16
        w18 = -EAC*w3 + ECC*w6 + EYC + w17
        w19 = cos_c*w15 - sin_c*w18
        w20 = EB0C*w3 + EX0C + w19
        w21 = EBZ*w3 - ECZ*w9 + EXZ + w20
        w22 = EB0Z*w4 + w21
        w23 = EBY*w4 - ECY*w9 + EXY + w22
        w24 = -EC0Y*w10 + w23
        deviation[0, at] = EBX*w4 - ECX*w10 + EXX + w24
        w25 = cos_c*w6 - sin_c*w8
        w26 = cos_c*w18 + sin_c*w15
        w27 = -EA0C*w3 + EY0C + w26
        w28 = -EAZ*w3 + ECZ*w25 + EYZ + w27
        w29 = -EA0Z*w4 + w28
        w30 = -EAY*w4 + ECY*w25 + EYY + w29
        w31 = EC0Y*w25 + w30
        deviation[1, at] = -EAX*w4 + ECX*w25 + EYX + w31
        w32 = cos_b*w12 - sin_b*w11
        w33 = EA0B*w7 + EZ0B + w32
        w34 = EAC*w8 - EBC*w6 + EZC + w33
        w35 = EA0C*w9 - EB0C*w25 + w34
        w36 = EAZ*w9 - EBZ*w25 + EZZ + w35
        w37 = EA0Z*w9 - EB0Z*w25 + w36
        w38 = EAY*w9 - EBY*w25 + EZY + w37
        deviation[2, at] = EAX*w10 - EBX*w25 + EZX + w38
    return deviation


def tool_in_bed_sensitivity(positions, parameters, point):
    """Sensitivity of a tool point in the bed frame to every error, at the error-free machine.

    Source: Eqs. (1)-(4), first order. Operations: 129 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        parameters (20,): home positions and location errors [mm, rad]
            rows: q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T
                EZ0T
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        sensitivity (3, 44, n): derivative of the deviation by each component error, then by each location error [mm/mm, mm/rad]
            rows: dx_EXX dx_EYX .. dz_EZ0T, last index fastest
    """
    n, positions, point = _points(positions=(positions, 5), point=(point, 3))
    parameters = _constant("parameters", parameters, (20,))
    sensitivity = np.zeros((132, n))
    # constants
    q_Bx = float(parameters[0])
    q_By = float(parameters[1])
    q_Bz = float(parameters[2])
    q_Tx = float(parameters[3])
    q_Ty = float(parameters[4])
    q_Tz = float(parameters[5])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
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
        w0 = cos_b*q_Tz
        w1 = cos_b*rz
        w2 = q_Tx*sin_b
        w3 = rx*sin_b
        sensitivity[16, at] = dx_EBZ = q_Bz + w0 + w1 - w2 - w3
        sensitivity[4, at] = dx_EBX = dx_EBZ + z
        w4 = cos_c*q_Ty
        w5 = cos_c*ry
        w6 = q_Tx*sin_c
        w7 = rx*sin_c
        w8 = q_Tz*sin_c
        w9 = rz*sin_c
        w10 = cos_b*w6 + cos_b*w7 + sin_b*w8 + sin_b*w9 + w4 + w5
        sensitivity[97, at] = dz_EAY = cos_c*q_By + q_Bx*sin_c + w10
        sensitivity[91, at] = dz_EAX = dz_EAY + y
        sensitivity[5, at] = dx_ECX = -dz_EAX
        sensitivity[11, at] = dx_ECY = -dz_EAY
        sensitivity[18, at] = dx_EXB = cos_b*cos_c
        sensitivity[19, at] = dx_EYB = -sin_c
        sensitivity[20, at] = dx_EZB = cos_c*sin_b
        sensitivity[22, at] = dx_EBB = cos_c*w0 + cos_c*w1 - cos_c*w2 - cos_c*w3
        sensitivity[39, at] = dx_EA0B = sin_c*w0 + sin_c*w1 - sin_c*w2 - sin_c*w3
        sensitivity[27, at] = dx_EAC = dx_EA0B + q_Bz*sin_c
        sensitivity[28, at] = dx_EBC = cos_c*q_Bz + dx_EBB
        sensitivity[47, at] = dy_EAX = -dx_EBX
        w11 = q_Ty*sin_c
        w12 = ry*sin_c
        sensitivity[84, at] = dy_EC0B = dx_EXB*q_Tx + dx_EXB*rx + dx_EZB*q_Tz + dx_EZB*rz - w11 - w12
        sensitivity[49, at] = dy_ECX = cos_c*q_Bx + dy_EC0B - q_By*sin_c
        sensitivity[59, at] = dy_EAZ = -dx_EBZ
        sensitivity[62, at] = dy_EXB = cos_b*sin_c
        sensitivity[64, at] = dy_EZB = sin_b*sin_c
        sensitivity[92, at] = dz_EBX = -dy_ECX
        sensitivity[106, at] = dz_EXB = -sin_b
        sensitivity[127, at] = dz_EA0B = q_Ty + ry
        sensitivity[0, at] = 1.0
        sensitivity[6, at] = 1.0
        sensitivity[10, at] = dx_EBX
        sensitivity[12, at] = 1.0
        sensitivity[17, at] = dx_ECY
        sensitivity[21, at] = sin_b*w4 + sin_b*w5 + w8 + w9
        sensitivity[23, at] = -cos_b*w4 - cos_b*w5 - w6 - w7
        sensitivity[24, at] = cos_c
        sensitivity[25, at] = dx_EYB
        sensitivity[29, at] = dx_ECY
        sensitivity[30, at] = dx_ECX
        sensitivity[32, at] = dx_EBX
        sensitivity[33, at] = 1.0
        sensitivity[36, at] = dx_EBZ
        sensitivity[37, at] = cos_c
        sensitivity[40, at] = -w10
        sensitivity[41, at] = dx_EXB
        sensitivity[42, at] = dx_EYB
        sensitivity[43, at] = dx_EZB
        sensitivity[45, at] = 1.0
        sensitivity[51, at] = 1.0
        sensitivity[53, at] = dy_EAX
        sensitivity[55, at] = dy_ECX
        sensitivity[57, at] = 1.0
        sensitivity[61, at] = dy_ECX
        sensitivity[63, at] = cos_c
        sensitivity[65, at] = -cos_c*q_Tz - cos_c*rz + q_Ty*sin_b*sin_c + ry*sin_b*sin_c
        sensitivity[66, at] = dx_EA0B
        sensitivity[67, at] = -cos_b*w11 - cos_b*w12 + cos_c*q_Tx + cos_c*rx
        sensitivity[68, at] = sin_c
        sensitivity[69, at] = cos_c
        sensitivity[71, at] = -dx_EBC
        sensitivity[72, at] = dx_EAC
        sensitivity[73, at] = dy_ECX
        sensitivity[74, at] = dy_ECX
        sensitivity[75, at] = dy_EAX
        sensitivity[78, at] = 1.0
        sensitivity[79, at] = dy_EAZ
        sensitivity[81, at] = sin_c
        sensitivity[83, at] = -dx_EBB
        sensitivity[85, at] = dy_EXB
        sensitivity[86, at] = cos_c
        sensitivity[87, at] = dy_EZB
        sensitivity[90, at] = 1.0
        sensitivity[96, at] = 1.0
        sensitivity[98, at] = dz_EBX
        sensitivity[102, at] = 1.0
        sensitivity[103, at] = dz_EAY
        sensitivity[104, at] = dz_EBX
        sensitivity[108, at] = cos_b
        sensitivity[109, at] = cos_b*q_Ty + cos_b*ry
        w13 = cos_b*q_Tx + cos_b*rx + q_Tz*sin_b + rz*sin_b
        sensitivity[110, at] = -w13
        sensitivity[111, at] = q_Ty*sin_b + ry*sin_b
        sensitivity[114, at] = 1.0
        sensitivity[115, at] = dz_EA0B + q_By
        sensitivity[116, at] = -q_Bx - w13
        sensitivity[119, at] = dz_EAY
        sensitivity[120, at] = dz_EBX
        sensitivity[123, at] = dz_EAY
        sensitivity[124, at] = dz_EBX
        sensitivity[126, at] = 1.0
        sensitivity[129, at] = dz_EXB
        sensitivity[131, at] = cos_b
    return sensitivity.reshape(3, 44, n)


def workpiece_in_bed_ideal(positions, parameters, point):
    """Ideal position of a workpiece point in the bed frame.

    Source: Eqs. (1)-(4) without errors. Operations: 0 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        parameters (20,): home positions and location errors [mm, rad]
            rows: q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T
                EZ0T
        point (3, n): point in the workpiece frame [mm]
            rows: rx ry rz

    Returns:
        ideal (3, n): workpiece point in the bed frame, without errors [mm]
            rows: px py pz
    """
    n, positions, point = _points(positions=(positions, 5), point=(point, 3))
    parameters = _constant("parameters", parameters, (20,))
    ideal = np.zeros((3, n))
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # per point
        ideal[0, at] = rx
        ideal[1, at] = ry
        ideal[2, at] = rz
    return ideal


def workpiece_in_bed_deviation(positions, errors, parameters, point):
    """Deviation of a workpiece point in the bed frame, exact.

    Source: Eqs. (1)-(4). Operations: 0 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB
                ECB EXC EYC EZC EAC EBC ECC
        parameters (20,): home positions and location errors [mm, rad]
            rows: q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T
                EZ0T
        point (3, n): point in the workpiece frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): workpiece point in the bed frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions, errors, point = _points(positions=(positions, 5), errors=(errors, 30), point=(point, 3))
    parameters = _constant("parameters", parameters, (20,))
    deviation = np.zeros((3, n))
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        # per point
    return deviation


def workpiece_in_bed_deviation_first_order(positions, errors, parameters, point):
    """Deviation of a workpiece point in the bed frame, to first order in the errors.

    Source: Eqs. (1)-(4). Operations: 0 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB
                ECB EXC EYC EZC EAC EBC ECC
        parameters (20,): home positions and location errors [mm, rad]
            rows: q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T
                EZ0T
        point (3, n): point in the workpiece frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): workpiece point in the bed frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions, errors, point = _points(positions=(positions, 5), errors=(errors, 30), point=(point, 3))
    parameters = _constant("parameters", parameters, (20,))
    deviation = np.zeros((3, n))
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        # per point
    return deviation


def workpiece_in_bed_sensitivity(positions, parameters, point):
    """Sensitivity of a workpiece point in the bed frame to every error, at the error-free machine.

    Source: Eqs. (1)-(4), first order. Operations: 0 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        parameters (20,): home positions and location errors [mm, rad]
            rows: q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T
                EZ0T
        point (3, n): point in the workpiece frame [mm]
            rows: rx ry rz

    Returns:
        sensitivity (3, 44, n): derivative of the deviation by each component error, then by each location error [mm/mm, mm/rad]
            rows: dx_EXX dx_EYX .. dz_EZ0T, last index fastest
    """
    n, positions, point = _points(positions=(positions, 5), point=(point, 3))
    parameters = _constant("parameters", parameters, (20,))
    sensitivity = np.zeros((132, n))
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        # per point
    return sensitivity.reshape(3, 44, n)


def bed_in_workpiece_ideal(positions, parameters, point):
    """Ideal position of a bed point in the workpiece frame.

    Source: Eqs. (1)-(4) without errors. Operations: 0 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        parameters (20,): home positions and location errors [mm, rad]
            rows: q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T
                EZ0T
        point (3, n): point in the bed frame [mm]
            rows: rx ry rz

    Returns:
        ideal (3, n): bed point in the workpiece frame, without errors [mm]
            rows: px py pz
    """
    n, positions, point = _points(positions=(positions, 5), point=(point, 3))
    parameters = _constant("parameters", parameters, (20,))
    ideal = np.zeros((3, n))
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # per point
        ideal[0, at] = rx
        ideal[1, at] = ry
        ideal[2, at] = rz
    return ideal


def bed_in_workpiece_deviation(positions, errors, parameters, point):
    """Deviation of a bed point in the workpiece frame, exact.

    Source: Eqs. (1)-(4). Operations: 0 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB
                ECB EXC EYC EZC EAC EBC ECC
        parameters (20,): home positions and location errors [mm, rad]
            rows: q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T
                EZ0T
        point (3, n): point in the bed frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): bed point in the workpiece frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions, errors, point = _points(positions=(positions, 5), errors=(errors, 30), point=(point, 3))
    parameters = _constant("parameters", parameters, (20,))
    deviation = np.zeros((3, n))
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        # per point
    return deviation


def bed_in_workpiece_deviation_first_order(positions, errors, parameters, point):
    """Deviation of a bed point in the workpiece frame, to first order in the errors.

    Source: Eqs. (1)-(4). Operations: 0 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB
                ECB EXC EYC EZC EAC EBC ECC
        parameters (20,): home positions and location errors [mm, rad]
            rows: q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T
                EZ0T
        point (3, n): point in the bed frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): bed point in the workpiece frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions, errors, point = _points(positions=(positions, 5), errors=(errors, 30), point=(point, 3))
    parameters = _constant("parameters", parameters, (20,))
    deviation = np.zeros((3, n))
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        # per point
    return deviation


def bed_in_workpiece_sensitivity(positions, parameters, point):
    """Sensitivity of a bed point in the workpiece frame to every error, at the error-free machine.

    Source: Eqs. (1)-(4), first order. Operations: 0 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        parameters (20,): home positions and location errors [mm, rad]
            rows: q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T
                EZ0T
        point (3, n): point in the bed frame [mm]
            rows: rx ry rz

    Returns:
        sensitivity (3, 44, n): derivative of the deviation by each component error, then by each location error [mm/mm, mm/rad]
            rows: dx_EXX dx_EYX .. dz_EZ0T, last index fastest
    """
    n, positions, point = _points(positions=(positions, 5), point=(point, 3))
    parameters = _constant("parameters", parameters, (20,))
    sensitivity = np.zeros((132, n))
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        # per point
    return sensitivity.reshape(3, 44, n)


def tool_in_workpiece_position(positions, errors, parameters, point):
    """Actual position of the tool point in the workpiece frame, exact.

    Source: Eq. (4). Operations: 177 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB
                ECB EXC EYC EZC EAC EBC ECC
        parameters (20,): home positions and location errors [mm, rad]
            rows: q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T
                EZ0T
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        position (3, n): actual position P_T^W of the tool point in the workpiece frame [mm]
            rows: px py pz
    """
    n, positions, errors, point = _points(positions=(positions, 5), errors=(errors, 30), point=(point, 3))
    parameters = _constant("parameters", parameters, (20,))
    position = np.zeros((3, n))
    # constants
    q_Bx = float(parameters[0])
    q_By = float(parameters[1])
    q_Bz = float(parameters[2])
    q_Tx = float(parameters[3])
    q_Ty = float(parameters[4])
    q_Tz = float(parameters[5])
    EC0Y = float(parameters[6])
    EA0Z = float(parameters[7])
    EB0Z = float(parameters[8])
    EX0C = float(parameters[9])
    EY0C = float(parameters[10])
    EA0C = float(parameters[11])
    EB0C = float(parameters[12])
    EX0B = float(parameters[13])
    EZ0B = float(parameters[14])
    EA0B = float(parameters[15])
    EC0B = float(parameters[16])
    EX0T = float(parameters[17])
    EY0T = float(parameters[18])
    EZ0T = float(parameters[19])
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
        w1 = q_Tz + rz
        w2 = cos_b*w1 - sin_b*w0
        w3 = q_Bz + w2
        w4 = w3 + z
        w5 = cos_b*w0 + sin_b*w1
        w6 = q_Bx + w5
        w7 = q_Ty + ry
        w8 = q_By + w7
        w9 = cos_c*w8 + sin_c*w6
        w10 = EZ0T + w1
        w11 = EX0T + w0
        w12 = -EAB*w10 + ECB*w11 + EY0T + EYB
        w13 = EY0T + w7
        w14 = EBB*w10 - ECB*w13 + EX0T + EXB
        w15 = EAB*w13 - EBB*w11 + EZ0T + EZB
        w16 = cos_b*w14 + sin_b*w15
        w17 = cos_b*w15 - sin_b*w14
        w18 = -EA0B*(w17 + w2) + EC0B*(w16 + w5) + w12
        w19 = w18 + w8
        w20 = w12 + w7
        w21 = -EC0B*w20 + EX0B + w16
        w22 = w21 + w6
        w23 = EA0B*w20 + EZ0B + w17
        w24 = EAC*w19 - EBC*w22 + EZC + w23
        w25 = w24 + w3
        w26 = w23 + w3
        w27 = EBC*w26 - ECC*w19 + EXC + w21
        w28 = -EAC*w26 + ECC*w22 + EYC + w18
        w29 = cos_c*w28 + sin_c*w27
        w30 = -EA0C*w25 + EY0C + w29
        w31 = w30 + w9
        w32 = cos_c*w6 - sin_c*w8
        w33 = cos_c*w27 - sin_c*w28
        w34 = EB0C*w25 + EX0C + w33
        w35 = w32 + w34
        w36 = EA0C*(w29 + w9) - EB0C*(w32 + w33) + w24
        w37 = EAZ*w31 - EBZ*w35 + EZZ + w36
        w38 = w37 + w4
        w39 = w3 + w36
        w40 = -EAZ*w39 + ECZ*w35 + EYZ + w30
        w41 = -EA0Z*w38 + w40
        w42 = w41 + w9
        w43 = EBZ*w39 - ECZ*w31 + EXZ + w34
        w44 = EB0Z*w38 + w43
        w45 = w32 + w44
        w46 = EA0Z*(w40 + w9) - EB0Z*(w32 + w43) + w37
        w47 = EAY*w42 - EBY*w45 + EZY + w46
        w48 = w4 + w47
        w49 = w9 + y
        w50 = w4 + w46
        w51 = EBY*w50 - ECY*w42 + EXY + w44
        w52 = -EAY*w50 + ECY*w45 + EYY + w41
        w53 = EC0Y*(w32 + w51) + w52
        w54 = w49 + w53
        w55 = -EC0Y*(w49 + w52) + w51
        w56 = EBX*w48 - ECX*w54 + EXX + w55
        w57 = w32 + x
        position[0, at] = w56 + w57
        w58 = w32 + w55
        w59 = -EAX*w48 + ECX*w58 + EYX + w53
        position[1, at] = w49 + w59
        w60 = EAX*w54 - EBX*w58 + EZX + w47
        position[2, at] = w4 + w60
    return position


def tool_in_workpiece_position_first_order(positions, errors, parameters, point):
    """Actual position of the tool point in the workpiece frame, to first order.

    Source: Eq. (4). Operations: 151 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB
                ECB EXC EYC EZC EAC EBC ECC
        parameters (20,): home positions and location errors [mm, rad]
            rows: q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T
                EZ0T
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        position (3, n): actual position P_T^W of the tool point in the workpiece frame [mm]
            rows: px py pz
    """
    n, positions, errors, point = _points(positions=(positions, 5), errors=(errors, 30), point=(point, 3))
    parameters = _constant("parameters", parameters, (20,))
    position = np.zeros((3, n))
    # constants
    q_Bx = float(parameters[0])
    q_By = float(parameters[1])
    q_Bz = float(parameters[2])
    q_Tx = float(parameters[3])
    q_Ty = float(parameters[4])
    q_Tz = float(parameters[5])
    EC0Y = float(parameters[6])
    EA0Z = float(parameters[7])
    EB0Z = float(parameters[8])
    EX0C = float(parameters[9])
    EY0C = float(parameters[10])
    EA0C = float(parameters[11])
    EB0C = float(parameters[12])
    EX0B = float(parameters[13])
    EZ0B = float(parameters[14])
    EA0B = float(parameters[15])
    EC0B = float(parameters[16])
    EX0T = float(parameters[17])
    EY0T = float(parameters[18])
    EZ0T = float(parameters[19])
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
        w1 = q_Tz + rz
        w2 = cos_b*w1 - sin_b*w0
        w3 = q_Bz + w2
        w4 = w3 + z
        w5 = cos_b*w0 + sin_b*w1
        w6 = q_Bx + w5
        w7 = q_Ty + ry
        w8 = q_By + w7
        w9 = cos_c*w8 + sin_c*w6
        w10 = w9 + y
        w11 = EBB*w1 - ECB*w7 + EX0T + EXB
        w12 = EAB*w7 - EBB*w0 + EZ0T + EZB
        w13 = cos_b*w11 + sin_b*w12
        w14 = -EC0B*w7 + EX0B + w13
        w15 = EBC*w3 - ECC*w8 + EXC + w14
        w16 = -EAB*w1 + ECB*w0 + EY0T + EYB
        w17 = -EA0B*w2 + EC0B*w5 + w16
        w18 = -EAC*w3 + ECC*w6 + EYC + w17
        w19 = cos_c*w15 - sin_c*w18
        w20 = EB0C*w3 + EX0C + w19
        w21 = EBZ*w3 - ECZ*w9 + EXZ + w20
        w22 = EB0Z*w4 + w21
        w23 = EBY*w4 - ECY*w9 + EXY + w22
        w24 = -EC0Y*w10 + w23
        w25 = EBX*w4 - ECX*w10 + EXX + w24
        w26 = cos_c*w6 - sin_c*w8
        w27 = w26 + x
        position[0, at] = w25 + w27
        w28 = cos_c*w18 + sin_c*w15
        w29 = -EA0C*w3 + EY0C + w28
        w30 = -EAZ*w3 + ECZ*w26 + EYZ + w29
        w31 = -EA0Z*w4 + w30
        w32 = -EAY*w4 + ECY*w26 + EYY + w31
        w33 = EC0Y*w26 + w32
        w34 = -EAX*w4 + ECX*w26 + EYX + w33
        position[1, at] = w10 + w34
        w35 = cos_b*w12 - sin_b*w11
        w36 = EA0B*w7 + EZ0B + w35
        w37 = EAC*w8 - EBC*w6 + EZC + w36
        w38 = EA0C*w9 - EB0C*w26 + w37
        w39 = EAZ*w9 - EBZ*w26 + EZZ + w38
        w40 = EA0Z*w9 - EB0Z*w26 + w39
        w41 = EAY*w9 - EBY*w26 + EZY + w40
        w42 = EAX*w10 - EBX*w26 + EZX + w41
        position[2, at] = w4 + w42
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
        ideal[0, at] = cos_c*w0 - sin_c*ty
        ideal[1, at] = cos_c*ty + sin_c*w0
    return ideal


def tool_orientation_deviation(positions, errors, parameters, direction):
    """Deviation of a direction of the tool frame in the workpiece frame, exact.

    Source: Eqs. (1)-(4), rotations alone. Operations: 140 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB
                ECB EXC EYC EZC EAC EBC ECC
        parameters (20,): home positions and location errors [mm, rad]
            rows: q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T
                EZ0T
        direction (3, n): unit vector in the tool frame, (0, 0, 1) for the tool axis [1]
            rows: tx ty tz

    Returns:
        deviation (3, n): the vector in the workpiece frame, actual minus ideal [1]
            rows: dx dy dz
    """
    n, positions, errors, direction = _points(positions=(positions, 5), errors=(errors, 30), direction=(direction, 3))
    parameters = _constant("parameters", parameters, (20,))
    deviation = np.zeros((3, n))
    # constants
    EC0Y = float(parameters[6])
    EA0Z = float(parameters[7])
    EB0Z = float(parameters[8])
    EA0C = float(parameters[11])
    EB0C = float(parameters[12])
    EA0B = float(parameters[15])
    EC0B = float(parameters[16])
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
        w2 = cos_c*ty + sin_c*w1
        w3 = -EAB*tz + ECB*tx
        w4 = EBB*tz - ECB*ty
        w5 = EAB*ty - EBB*tx
        w6 = cos_b*w4 + sin_b*w5
        w7 = cos_b*w5 - sin_b*w4
        w8 = -EA0B*(w0 + w7) + EC0B*(w1 + w6) + w3
        w9 = ty + w8
        w10 = ty + w3
        w11 = -EC0B*w10 + w6
        w12 = w1 + w11
        w13 = EA0B*w10 + w7
        w14 = EAC*w9 - EBC*w12 + w13
        w15 = w0 + w14
        w16 = w0 + w13
        w17 = EBC*w16 - ECC*w9 + w11
        w18 = -EAC*w16 + ECC*w12 + w8
        w19 = cos_c*w18 + sin_c*w17
        w20 = -EA0C*w15 + w19
        w21 = w2 + w20
        w22 = cos_c*w1 - sin_c*ty
        w23 = cos_c*w17 - sin_c*w18
        w24 = EB0C*w15 + w23
        w25 = w22 + w24
        w26 = EA0C*(w19 + w2) - EB0C*(w22 + w23) + w14
        w27 = EAZ*w21 - EBZ*w25 + w26
        w28 = w0 + w27
        w29 = w0 + w26
        w30 = -EAZ*w29 + ECZ*w25 + w20
        w31 = -EA0Z*w28 + w30
        w32 = w2 + w31
        w33 = EBZ*w29 - ECZ*w21 + w24
        w34 = EB0Z*w28 + w33
        w35 = w22 + w34
        w36 = EA0Z*(w2 + w30) - EB0Z*(w22 + w33) + w27
        w37 = EAY*w32 - EBY*w35 + w36
        w38 = w0 + w37
        w39 = w0 + w36
        w40 = EBY*w39 - ECY*w32 + w34
        w41 = -EAY*w39 + ECY*w35 + w31
        w42 = EC0Y*(w22 + w40) + w41
        w43 = w2 + w42
        w44 = -EC0Y*(w2 + w41) + w40
        deviation[0, at] = EBX*w38 - ECX*w43 + w44
        w45 = w22 + w44
        deviation[1, at] = -EAX*w38 + ECX*w45 + w42
        deviation[2, at] = EAX*w43 - EBX*w45 + w37
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
        parameters (20,): home positions and location errors [mm, rad]
            rows: q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T
                EZ0T
        direction (3, n): unit vector in the tool frame, (0, 0, 1) for the tool axis [1]
            rows: tx ty tz

    Returns:
        deviation (3, n): the vector in the workpiece frame, actual minus ideal [1]
            rows: dx dy dz
    """
    n, positions, errors, direction = _points(positions=(positions, 5), errors=(errors, 30), direction=(direction, 3))
    parameters = _constant("parameters", parameters, (20,))
    deviation = np.zeros((3, n))
    # constants
    EC0Y = float(parameters[6])
    EA0Z = float(parameters[7])
    EB0Z = float(parameters[8])
    EA0C = float(parameters[11])
    EB0C = float(parameters[12])
    EA0B = float(parameters[15])
    EC0B = float(parameters[16])
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
        w2 = cos_c*ty + sin_c*w1
        w3 = EBB*tz - ECB*ty
        w4 = EAB*ty - EBB*tx
        w5 = cos_b*w3 + sin_b*w4
        w6 = -EC0B*ty + w5
        w7 = EBC*w0 - ECC*ty + w6
        w8 = -EAB*tz + ECB*tx
        w9 = -EA0B*w0 + EC0B*w1 + w8
        w10 = -EAC*w0 + ECC*w1 + w9
        w11 = cos_c*w7 - sin_c*w10
        w12 = EB0C*w0 + w11
        w13 = EBZ*w0 - ECZ*w2 + w12
        w14 = EB0Z*w0 + w13
        w15 = EBY*w0 - ECY*w2 + w14
        w16 = -EC0Y*w2 + w15
        deviation[0, at] = EBX*w0 - ECX*w2 + w16
        w17 = cos_c*w1 - sin_c*ty
        w18 = cos_c*w10 + sin_c*w7
        w19 = -EA0C*w0 + w18
        w20 = -EAZ*w0 + ECZ*w17 + w19
        w21 = -EA0Z*w0 + w20
        w22 = -EAY*w0 + ECY*w17 + w21
        w23 = EC0Y*w17 + w22
        deviation[1, at] = -EAX*w0 + ECX*w17 + w23
        w24 = cos_b*w4 - sin_b*w3
        w25 = EA0B*ty + w24
        w26 = EAC*ty - EBC*w1 + w25
        w27 = EA0C*w2 - EB0C*w17 + w26
        w28 = EAZ*w2 - EBZ*w17 + w27
        w29 = EA0Z*w2 - EB0Z*w17 + w28
        w30 = EAY*w2 - EBY*w17 + w29
        deviation[2, at] = EAX*w2 - EBX*w17 + w30
    return deviation


def tool_in_workpiece_deviation_curves(positions, curves, parameters, point):
    """Deviation of the tool point under polynomial error curves, exact.

    Source: Eqs. (1)-(4), (44). Operations: 556 per point, 7 per call.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        curves (30, 7): coefficients of the powers 1 to 7 of the axis position, per component error [mm/mm^k, rad/mm^k (deg^k for rotary axes)]
            rows: EXX_1 EXX_2 .. ECC_7, last index fastest
        parameters (20,): home positions and location errors [mm, rad]
            rows: q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T
                EZ0T
        point (3,): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): tool point in the workpiece frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions = _points(positions=(positions, 5))
    curves = _constant("curves", curves, (30, 7))
    parameters = _constant("parameters", parameters, (20,))
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
    q_Bx = float(parameters[0])
    q_By = float(parameters[1])
    q_Bz = float(parameters[2])
    q_Tx = float(parameters[3])
    q_Ty = float(parameters[4])
    q_Tz = float(parameters[5])
    EC0Y = float(parameters[6])
    EA0Z = float(parameters[7])
    EB0Z = float(parameters[8])
    EX0C = float(parameters[9])
    EY0C = float(parameters[10])
    EA0C = float(parameters[11])
    EB0C = float(parameters[12])
    EX0B = float(parameters[13])
    EZ0B = float(parameters[14])
    EA0B = float(parameters[15])
    EC0B = float(parameters[16])
    EX0T = float(parameters[17])
    EY0T = float(parameters[18])
    EZ0T = float(parameters[19])
    rx = float(point[0])
    ry = float(point[1])
    rz = float(point[2])
    # once per call
    w0 = q_Tx + rx
    w1 = q_Tz + rz
    w7 = q_Ty + ry
    w8 = q_By + w7
    w10 = EZ0T + w1
    w11 = EX0T + w0
    w16 = EY0T + w7
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
        w2 = cos_b*w1 - sin_b*w0
        w3 = q_Bz + w2
        w4 = w3 + z
        w5 = cos_b*w0 + sin_b*w1
        w6 = q_Bx + w5
        w9 = cos_c*w8 + sin_c*w6
        w12 = _polynomial(b, EYB_1, EYB_2, EYB_3, EYB_4, EYB_5, EYB_6, EYB_7)
        w13 = _polynomial(b, EAB_1, EAB_2, EAB_3, EAB_4, EAB_5, EAB_6, EAB_7)
        w14 = _polynomial(b, ECB_1, ECB_2, ECB_3, ECB_4, ECB_5, ECB_6, ECB_7)
        w15 = EY0T - w10*w13 + w11*w14 + w12
        w17 = _polynomial(b, EXB_1, EXB_2, EXB_3, EXB_4, EXB_5, EXB_6, EXB_7)
        w18 = _polynomial(b, EBB_1, EBB_2, EBB_3, EBB_4, EBB_5, EBB_6, EBB_7)
        w19 = EX0T + w10*w18 - w14*w16 + w17
        w20 = _polynomial(b, EZB_1, EZB_2, EZB_3, EZB_4, EZB_5, EZB_6, EZB_7)
        w21 = EZ0T - w11*w18 + w13*w16 + w20
        w22 = cos_b*w19 + sin_b*w21
        w23 = cos_b*w21 - sin_b*w19
        w24 = -EA0B*(w2 + w23) + EC0B*(w22 + w5) + w15
        w25 = w24 + w8
        w26 = w15 + w7
        w27 = -EC0B*w26 + EX0B + w22
        w28 = w27 + w6
        w29 = _polynomial(c, EZC_1, EZC_2, EZC_3, EZC_4, EZC_5, EZC_6, EZC_7)
        w30 = _polynomial(c, EAC_1, EAC_2, EAC_3, EAC_4, EAC_5, EAC_6, EAC_7)
        w31 = _polynomial(c, EBC_1, EBC_2, EBC_3, EBC_4, EBC_5, EBC_6, EBC_7)
        w32 = EA0B*w26 + EZ0B + w23
        w33 = w25*w30 - w28*w31 + w29 + w32
        w34 = w3 + w33
        w35 = w3 + w32
        w36 = _polynomial(c, EXC_1, EXC_2, EXC_3, EXC_4, EXC_5, EXC_6, EXC_7)
        w37 = _polynomial(c, ECC_1, ECC_2, ECC_3, ECC_4, ECC_5, ECC_6, ECC_7)
        w38 = -w25*w37 + w27 + w31*w35 + w36
        w39 = _polynomial(c, EYC_1, EYC_2, EYC_3, EYC_4, EYC_5, EYC_6, EYC_7)
        w40 = w24 + w28*w37 - w30*w35 + w39
        w41 = cos_c*w40 + sin_c*w38
        w42 = -EA0C*w34 + EY0C + w41
        w43 = w42 + w9
        w44 = cos_c*w6 - sin_c*w8
        w45 = cos_c*w38 - sin_c*w40
        w46 = EB0C*w34 + EX0C + w45
        w47 = w44 + w46
        w48 = _polynomial(z, EZZ_1, EZZ_2, EZZ_3, EZZ_4, EZZ_5, EZZ_6, EZZ_7)
        w49 = _polynomial(z, EAZ_1, EAZ_2, EAZ_3, EAZ_4, EAZ_5, EAZ_6, EAZ_7)
        w50 = _polynomial(z, EBZ_1, EBZ_2, EBZ_3, EBZ_4, EBZ_5, EBZ_6, EBZ_7)
        w51 = EA0C*(w41 + w9) - EB0C*(w44 + w45) + w33
        w52 = w43*w49 - w47*w50 + w48 + w51
        w53 = w4 + w52
        w54 = w3 + w51
        w55 = _polynomial(z, EYZ_1, EYZ_2, EYZ_3, EYZ_4, EYZ_5, EYZ_6, EYZ_7)
        w56 = _polynomial(z, ECZ_1, ECZ_2, ECZ_3, ECZ_4, ECZ_5, ECZ_6, ECZ_7)
        w57 = w42 + w47*w56 - w49*w54 + w55
        w58 = -EA0Z*w53 + w57
        w59 = w58 + w9
        w60 = _polynomial(z, EXZ_1, EXZ_2, EXZ_3, EXZ_4, EXZ_5, EXZ_6, EXZ_7)
        w61 = -w43*w56 + w46 + w50*w54 + w60
        w62 = EB0Z*w53 + w61
        w63 = w44 + w62
        w64 = _polynomial(y, EZY_1, EZY_2, EZY_3, EZY_4, EZY_5, EZY_6, EZY_7)
        w65 = _polynomial(y, EAY_1, EAY_2, EAY_3, EAY_4, EAY_5, EAY_6, EAY_7)
        w66 = _polynomial(y, EBY_1, EBY_2, EBY_3, EBY_4, EBY_5, EBY_6, EBY_7)
        w67 = EA0Z*(w57 + w9) - EB0Z*(w44 + w61) + w52
        w68 = w59*w65 - w63*w66 + w64 + w67
        w69 = w4 + w68
        w70 = w9 + y
        w71 = w4 + w67
        w72 = _polynomial(y, EXY_1, EXY_2, EXY_3, EXY_4, EXY_5, EXY_6, EXY_7)
        w73 = _polynomial(y, ECY_1, ECY_2, ECY_3, ECY_4, ECY_5, ECY_6, ECY_7)
        w74 = -w59*w73 + w62 + w66*w71 + w72
        w75 = _polynomial(y, EYY_1, EYY_2, EYY_3, EYY_4, EYY_5, EYY_6, EYY_7)
        w76 = w58 + w63*w73 - w65*w71 + w75
        w77 = EC0Y*(w44 + w74) + w76
        w78 = w70 + w77
        w79 = _polynomial(x, EXX_1, EXX_2, EXX_3, EXX_4, EXX_5, EXX_6, EXX_7)
        w80 = _polynomial(x, EBX_1, EBX_2, EBX_3, EBX_4, EBX_5, EBX_6, EBX_7)
        w81 = _polynomial(x, ECX_1, ECX_2, ECX_3, ECX_4, ECX_5, ECX_6, ECX_7)
        w82 = -EC0Y*(w70 + w76) + w74
        deviation[0, at] = w69*w80 - w78*w81 + w79 + w82
        w83 = w44 + w82
        w84 = _polynomial(x, EYX_1, EYX_2, EYX_3, EYX_4, EYX_5, EYX_6, EYX_7)
        w85 = _polynomial(x, EAX_1, EAX_2, EAX_3, EAX_4, EAX_5, EAX_6, EAX_7)
        deviation[1, at] = -w69*w85 + w77 + w81*w83 + w84
        w86 = _polynomial(x, EZX_1, EZX_2, EZX_3, EZX_4, EZX_5, EZX_6, EZX_7)
        deviation[2, at] = w68 + w78*w85 - w80*w83 + w86
    return deviation


def tool_in_workpiece_deviation_first_order_curves(positions, curves, parameters, point):
    """Deviation of the tool point under polynomial error curves, to first order.

    Source: Eqs. (1)-(4), (44). Operations: 533 per point, 4 per call.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        curves (30, 7): coefficients of the powers 1 to 7 of the axis position, per component error [mm/mm^k, rad/mm^k (deg^k for rotary axes)]
            rows: EXX_1 EXX_2 .. ECC_7, last index fastest
        parameters (20,): home positions and location errors [mm, rad]
            rows: q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T
                EZ0T
        point (3,): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): tool point in the workpiece frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions = _points(positions=(positions, 5))
    curves = _constant("curves", curves, (30, 7))
    parameters = _constant("parameters", parameters, (20,))
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
    q_Bx = float(parameters[0])
    q_By = float(parameters[1])
    q_Bz = float(parameters[2])
    q_Tx = float(parameters[3])
    q_Ty = float(parameters[4])
    q_Tz = float(parameters[5])
    EC0Y = float(parameters[6])
    EA0Z = float(parameters[7])
    EB0Z = float(parameters[8])
    EX0C = float(parameters[9])
    EY0C = float(parameters[10])
    EA0C = float(parameters[11])
    EB0C = float(parameters[12])
    EX0B = float(parameters[13])
    EZ0B = float(parameters[14])
    EA0B = float(parameters[15])
    EC0B = float(parameters[16])
    EX0T = float(parameters[17])
    EY0T = float(parameters[18])
    EZ0T = float(parameters[19])
    rx = float(point[0])
    ry = float(point[1])
    rz = float(point[2])
    # once per call
    w3 = q_Tx + rx
    w4 = q_Tz + rz
    w10 = q_Ty + ry
    w11 = q_By + w10
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
        w0 = _polynomial(x, EXX_1, EXX_2, EXX_3, EXX_4, EXX_5, EXX_6, EXX_7)
        w1 = _polynomial(x, EBX_1, EBX_2, EBX_3, EBX_4, EBX_5, EBX_6, EBX_7)
        w2 = _polynomial(x, ECX_1, ECX_2, ECX_3, ECX_4, ECX_5, ECX_6, ECX_7)
        w5 = cos_b*w4 - sin_b*w3
        w6 = q_Bz + w5
        w7 = w6 + z
        w8 = cos_b*w3 + sin_b*w4
        w9 = q_Bx + w8
        w12 = cos_c*w11 + sin_c*w9
        w13 = w12 + y
        w14 = _polynomial(y, EXY_1, EXY_2, EXY_3, EXY_4, EXY_5, EXY_6, EXY_7)
        w15 = _polynomial(y, EBY_1, EBY_2, EBY_3, EBY_4, EBY_5, EBY_6, EBY_7)
        w16 = _polynomial(y, ECY_1, ECY_2, ECY_3, ECY_4, ECY_5, ECY_6, ECY_7)
        w17 = _polynomial(z, EXZ_1, EXZ_2, EXZ_3, EXZ_4, EXZ_5, EXZ_6, EXZ_7)
        w18 = _polynomial(z, EBZ_1, EBZ_2, EBZ_3, EBZ_4, EBZ_5, EBZ_6, EBZ_7)
        w19 = _polynomial(z, ECZ_1, ECZ_2, ECZ_3, ECZ_4, ECZ_5, ECZ_6, ECZ_7)
        w20 = _polynomial(c, EXC_1, EXC_2, EXC_3, EXC_4, EXC_5, EXC_6, EXC_7)
        w21 = _polynomial(c, EBC_1, EBC_2, EBC_3, EBC_4, EBC_5, EBC_6, EBC_7)
        w22 = _polynomial(c, ECC_1, ECC_2, ECC_3, ECC_4, ECC_5, ECC_6, ECC_7)
        w23 = _polynomial(b, EXB_1, EXB_2, EXB_3, EXB_4, EXB_5, EXB_6, EXB_7)
        w24 = _polynomial(b, EBB_1, EBB_2, EBB_3, EBB_4, EBB_5, EBB_6, EBB_7)
        w25 = _polynomial(b, ECB_1, ECB_2, ECB_3, ECB_4, ECB_5, ECB_6, ECB_7)
        w26 = EX0T - w10*w25 + w23 + w24*w4
        w27 = _polynomial(b, EZB_1, EZB_2, EZB_3, EZB_4, EZB_5, EZB_6, EZB_7)
        w28 = _polynomial(b, EAB_1, EAB_2, EAB_3, EAB_4, EAB_5, EAB_6, EAB_7)
        w29 = EZ0T + w10*w28 - w24*w3 + w27
        w30 = cos_b*w26 + sin_b*w29
        w31 = -EC0B*w10 + EX0B + w30
        w32 = -w11*w22 + w20 + w21*w6 + w31
        w33 = _polynomial(c, EYC_1, EYC_2, EYC_3, EYC_4, EYC_5, EYC_6, EYC_7)
        w34 = _polynomial(c, EAC_1, EAC_2, EAC_3, EAC_4, EAC_5, EAC_6, EAC_7)
        w35 = _polynomial(b, EYB_1, EYB_2, EYB_3, EYB_4, EYB_5, EYB_6, EYB_7)
        w36 = EY0T + w25*w3 - w28*w4 + w35
        w37 = -EA0B*w5 + EC0B*w8 + w36
        w38 = w22*w9 + w33 - w34*w6 + w37
        w39 = cos_c*w32 - sin_c*w38
        w40 = EB0C*w6 + EX0C + w39
        w41 = -w12*w19 + w17 + w18*w6 + w40
        w42 = EB0Z*w7 + w41
        w43 = -w12*w16 + w14 + w15*w7 + w42
        w44 = -EC0Y*w13 + w43
        deviation[0, at] = w0 + w1*w7 - w13*w2 + w44
        w45 = _polynomial(x, EYX_1, EYX_2, EYX_3, EYX_4, EYX_5, EYX_6, EYX_7)
        w46 = _polynomial(x, EAX_1, EAX_2, EAX_3, EAX_4, EAX_5, EAX_6, EAX_7)
        w47 = cos_c*w9 - sin_c*w11
        w48 = _polynomial(y, EYY_1, EYY_2, EYY_3, EYY_4, EYY_5, EYY_6, EYY_7)
        w49 = _polynomial(y, EAY_1, EAY_2, EAY_3, EAY_4, EAY_5, EAY_6, EAY_7)
        w50 = _polynomial(z, EYZ_1, EYZ_2, EYZ_3, EYZ_4, EYZ_5, EYZ_6, EYZ_7)
        w51 = _polynomial(z, EAZ_1, EAZ_2, EAZ_3, EAZ_4, EAZ_5, EAZ_6, EAZ_7)
        w52 = cos_c*w38 + sin_c*w32
        w53 = -EA0C*w6 + EY0C + w52
        w54 = w19*w47 + w50 - w51*w6 + w53
        w55 = -EA0Z*w7 + w54
        w56 = w16*w47 + w48 - w49*w7 + w55
        w57 = EC0Y*w47 + w56
        deviation[1, at] = w2*w47 + w45 - w46*w7 + w57
        w58 = _polynomial(x, EZX_1, EZX_2, EZX_3, EZX_4, EZX_5, EZX_6, EZX_7)
        w59 = _polynomial(y, EZY_1, EZY_2, EZY_3, EZY_4, EZY_5, EZY_6, EZY_7)
        w60 = _polynomial(z, EZZ_1, EZZ_2, EZZ_3, EZZ_4, EZZ_5, EZZ_6, EZZ_7)
        w61 = _polynomial(c, EZC_1, EZC_2, EZC_3, EZC_4, EZC_5, EZC_6, EZC_7)
        w62 = cos_b*w29 - sin_b*w26
        w63 = EA0B*w10 + EZ0B + w62
        w64 = w11*w34 - w21*w9 + w61 + w63
        w65 = EA0C*w12 - EB0C*w47 + w64
        w66 = w12*w51 - w18*w47 + w60 + w65
        w67 = EA0Z*w12 - EB0Z*w47 + w66
        w68 = w12*w49 - w15*w47 + w59 + w67
        deviation[2, at] = -w1*w47 + w13*w46 + w58 + w68
    return deviation


def ballbar_error(positions, errors, parameters, point, ball, length):
    """Positioning error of a ball bar between a tool ball and a workpiece ball, exact.

    Source: Eqs. (5), (6). Operations: 210 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB
                ECB EXC EYC EZC EAC EBC ECC
        parameters (20,): home positions and location errors [mm, rad]
            rows: q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T
                EZ0T
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
    parameters = _constant("parameters", parameters, (20,))
    error = np.zeros((4, n))
    # constants
    q_Bx = float(parameters[0])
    q_By = float(parameters[1])
    q_Bz = float(parameters[2])
    q_Tx = float(parameters[3])
    q_Ty = float(parameters[4])
    q_Tz = float(parameters[5])
    EC0Y = float(parameters[6])
    EA0Z = float(parameters[7])
    EB0Z = float(parameters[8])
    EX0C = float(parameters[9])
    EY0C = float(parameters[10])
    EA0C = float(parameters[11])
    EB0C = float(parameters[12])
    EX0B = float(parameters[13])
    EZ0B = float(parameters[14])
    EA0B = float(parameters[15])
    EC0B = float(parameters[16])
    EX0T = float(parameters[17])
    EY0T = float(parameters[18])
    EZ0T = float(parameters[19])
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
        w1 = q_Tz + rz
        w2 = cos_b*w1 - sin_b*w0
        w3 = q_Bz + w2
        w4 = w3 + z
        w5 = cos_b*w0 + sin_b*w1
        w6 = q_Bx + w5
        w7 = q_Ty + ry
        w8 = q_By + w7
        w9 = cos_c*w8 + sin_c*w6
        w10 = EZ0T + w1
        w11 = EX0T + w0
        w12 = -EAB*w10 + ECB*w11 + EY0T + EYB
        w13 = EY0T + w7
        w14 = EBB*w10 - ECB*w13 + EX0T + EXB
        w15 = EAB*w13 - EBB*w11 + EZ0T + EZB
        w16 = cos_b*w14 + sin_b*w15
        w17 = cos_b*w15 - sin_b*w14
        w18 = -EA0B*(w17 + w2) + EC0B*(w16 + w5) + w12
        w19 = w18 + w8
        w20 = w12 + w7
        w21 = -EC0B*w20 + EX0B + w16
        w22 = w21 + w6
        w23 = EA0B*w20 + EZ0B + w17
        w24 = EAC*w19 - EBC*w22 + EZC + w23
        w25 = w24 + w3
        w26 = w23 + w3
        w27 = EBC*w26 - ECC*w19 + EXC + w21
        w28 = -EAC*w26 + ECC*w22 + EYC + w18
        w29 = cos_c*w28 + sin_c*w27
        w30 = -EA0C*w25 + EY0C + w29
        w31 = w30 + w9
        w32 = cos_c*w6 - sin_c*w8
        w33 = cos_c*w27 - sin_c*w28
        w34 = EB0C*w25 + EX0C + w33
        w35 = w32 + w34
        w36 = EA0C*(w29 + w9) - EB0C*(w32 + w33) + w24
        w37 = EAZ*w31 - EBZ*w35 + EZZ + w36
        w38 = w37 + w4
        w39 = w3 + w36
        w40 = -EAZ*w39 + ECZ*w35 + EYZ + w30
        w41 = -EA0Z*w38 + w40
        w42 = w41 + w9
        w43 = EBZ*w39 - ECZ*w31 + EXZ + w34
        w44 = EB0Z*w38 + w43
        w45 = w32 + w44
        w46 = EA0Z*(w40 + w9) - EB0Z*(w32 + w43) + w37
        w47 = EAY*w42 - EBY*w45 + EZY + w46
        w48 = w4 + w47
        w49 = w9 + y
        w50 = w4 + w46
        w51 = EBY*w50 - ECY*w42 + EXY + w44
        w52 = -EAY*w50 + ECY*w45 + EYY + w41
        w53 = EC0Y*(w32 + w51) + w52
        w54 = w49 + w53
        w55 = -EC0Y*(w49 + w52) + w51
        w56 = EBX*w48 - ECX*w54 + EXX + w55
        w57 = w32 + w55
        w58 = -EAX*w48 + ECX*w57 + EYX + w53
        w59 = EAX*w54 - EBX*w57 + EZX + w47
        w60 = w32 + x
        w61 = -bx + w60
        w62 = -by + w49
        w63 = -bz + w4
        w64 = w56 + w61
        w65 = w58 + w62
        w66 = w59 + w63
        w67 = np.sqrt((w61*w61) + (w62*w62) + (w63*w63))
        w68 = np.sqrt((w64*w64) + (w65*w65) + (w66*w66))
        error[0, at] = e = -length_ + w67 + (w56*(w61 + w64) + w58*(w62 + w65) + w59*(w63 + w66))/(w67 + w68)
        w69 = e/w68
        error[1, at] = w64*w69
        error[2, at] = w65*w69
        error[3, at] = w66*w69
    return error


def correction(positions, deviation):
    """Moves of the linear axes that displace the ideal tool point by the given vector.

    Source: Eqs. (53)-(55), inverse. Operations: 0 per point.

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
        dx = deviation[0, at]
        dy = deviation[1, at]
        dz = deviation[2, at]
        # per point
        moves[0, at] = dx
        moves[1, at] = dy
        moves[2, at] = dz
    return moves


def motion_X(positions, errors, parameters, tool_point):
    """Motion equation of X: displacement of the tool point since home, to first order.

    Source: Eqs. (7)-(11). Operations: 19 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB
                ECB EXC EYC EZC EAC EBC ECC
        parameters (20,): home positions and location errors [mm, rad]
            rows: q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T
                EZ0T
        tool_point (3, n): point in the tool frame [mm]
            rows: rTx rTy rTz

    Returns:
        displacement (3, n): tool point, displacement since home, in the bed frame [mm]
            rows: dx dy dz
    """
    n, positions, errors, tool_point = _points(positions=(positions, 5), errors=(errors, 30), tool_point=(tool_point, 3))
    parameters = _constant("parameters", parameters, (20,))
    displacement = np.zeros((3, n))
    # constants
    q_Bx = float(parameters[0])
    q_By = float(parameters[1])
    q_Bz = float(parameters[2])
    q_Tx = float(parameters[3])
    q_Ty = float(parameters[4])
    q_Tz = float(parameters[5])
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
        w0 = q_Bz + q_Tz + rTz
        w1 = q_By + q_Ty + rTy
        displacement[0, at] = EBX*w0 - ECX*w1 + EXX + x
        w2 = q_Bx + q_Tx + rTx
        displacement[1, at] = -EAX*w0 + ECX*w2 + EYX
        displacement[2, at] = EAX*w1 - EBX*w2 + EZX
    return displacement


def motion_Y(positions, errors, parameters, tool_point):
    """Motion equation of Y: displacement of the tool point since home, to first order.

    Source: Eqs. (7)-(11). Operations: 21 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB
                ECB EXC EYC EZC EAC EBC ECC
        parameters (20,): home positions and location errors [mm, rad]
            rows: q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T
                EZ0T
        tool_point (3, n): point in the tool frame [mm]
            rows: rTx rTy rTz

    Returns:
        displacement (3, n): tool point, displacement since home, in the bed frame [mm]
            rows: dx dy dz
    """
    n, positions, errors, tool_point = _points(positions=(positions, 5), errors=(errors, 30), tool_point=(tool_point, 3))
    parameters = _constant("parameters", parameters, (20,))
    displacement = np.zeros((3, n))
    # constants
    q_Bx = float(parameters[0])
    q_By = float(parameters[1])
    q_Bz = float(parameters[2])
    q_Tx = float(parameters[3])
    q_Ty = float(parameters[4])
    q_Tz = float(parameters[5])
    EC0Y = float(parameters[6])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        y = positions[1, at]
        EXY = errors[6, at]
        EYY = errors[7, at]
        EZY = errors[8, at]
        EAY = errors[9, at]
        EBY = errors[10, at]
        ECY = errors[11, at]
        rTx = tool_point[0, at]
        rTy = tool_point[1, at]
        rTz = tool_point[2, at]
        # per point
        w0 = q_Bz + q_Tz + rTz
        w1 = q_By + q_Ty + rTy
        displacement[0, at] = EBY*w0 - EC0Y*y - ECY*w1 + EXY
        w2 = q_Bx + q_Tx + rTx
        displacement[1, at] = -EAY*w0 + ECY*w2 + EYY + y
        displacement[2, at] = EAY*w1 - EBY*w2 + EZY
    return displacement


def motion_Z(positions, errors, parameters, tool_point):
    """Motion equation of Z: displacement of the tool point since home, to first order.

    Source: Eqs. (7)-(11). Operations: 23 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB
                ECB EXC EYC EZC EAC EBC ECC
        parameters (20,): home positions and location errors [mm, rad]
            rows: q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T
                EZ0T
        tool_point (3, n): point in the tool frame [mm]
            rows: rTx rTy rTz

    Returns:
        displacement (3, n): tool point, displacement since home, in the bed frame [mm]
            rows: dx dy dz
    """
    n, positions, errors, tool_point = _points(positions=(positions, 5), errors=(errors, 30), tool_point=(tool_point, 3))
    parameters = _constant("parameters", parameters, (20,))
    displacement = np.zeros((3, n))
    # constants
    q_Bx = float(parameters[0])
    q_By = float(parameters[1])
    q_Bz = float(parameters[2])
    q_Tx = float(parameters[3])
    q_Ty = float(parameters[4])
    q_Tz = float(parameters[5])
    EA0Z = float(parameters[7])
    EB0Z = float(parameters[8])
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
        w0 = q_Bz + q_Tz + rTz
        w1 = q_By + q_Ty + rTy
        displacement[0, at] = EB0Z*z + EBZ*w0 - ECZ*w1 + EXZ
        w2 = q_Bx + q_Tx + rTx
        displacement[1, at] = -EA0Z*z - EAZ*w0 + ECZ*w2 + EYZ
        displacement[2, at] = EAZ*w1 - EBZ*w2 + EZZ + z
    return displacement


def motion_B(positions, errors, parameters, tool_point):
    """Motion equation of B: displacement of the tool point since home, to first order.

    Source: Eqs. (7)-(11). Operations: 89 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB
                ECB EXC EYC EZC EAC EBC ECC
        parameters (20,): home positions and location errors [mm, rad]
            rows: q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T
                EZ0T
        tool_point (3, n): point in the tool frame [mm]
            rows: rTx rTy rTz

    Returns:
        displacement (3, n): tool point, displacement since home, in the bed frame [mm]
            rows: dx dy dz
    """
    n, positions, errors, tool_point = _points(positions=(positions, 5), errors=(errors, 30), tool_point=(tool_point, 3))
    parameters = _constant("parameters", parameters, (20,))
    displacement = np.zeros((3, n))
    # constants
    q_Tx = float(parameters[3])
    q_Ty = float(parameters[4])
    q_Tz = float(parameters[5])
    EC0Y = float(parameters[6])
    EA0Z = float(parameters[7])
    EB0Z = float(parameters[8])
    EA0C = float(parameters[11])
    EB0C = float(parameters[12])
    EA0B = float(parameters[15])
    EC0B = float(parameters[16])
    EX0T = float(parameters[17])
    EZ0T = float(parameters[19])
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
        w0 = q_Ty*sin_b + rTy*sin_b
        w1 = q_Tx*sin_b
        w2 = rTx*sin_b
        w3 = q_Tz + rTz
        w4 = -cos_b*q_Tz - cos_b*rTz + w1 + w2 + w3
        w5 = -w4
        w6 = cos_b*q_Tz + cos_b*rTz - w1 - w2
        w7 = cos_b*q_Ty + cos_b*rTy
        w8 = cos_b - 1
        w9 = cos_b*q_Tx + cos_b*rTx + q_Tz*sin_b + rTz*sin_b
        w10 = -q_Tx - rTx + w9
        displacement[0, at] = EAB*w0 + EB0C*w5 + EB0Z*w5 + EBB*w6 - ECB*w7 + EX0T*w8 + EXB*cos_b + EZ0T*sin_b + EZB*sin_b + w10
        displacement[1, at] = EA0B*w4 + EA0C*w4 + EA0Z*w4 - EAB*w3 + EC0B*w10 + EC0Y*w10 + ECB*(q_Tx + rTx) + EYB
        w11 = -w10
        displacement[2, at] = EAB*w7 + EB0C*w11 + EB0Z*w11 - EBB*w9 + ECB*w0 - EX0T*sin_b - EXB*sin_b + EZ0T*w8 + EZB*cos_b - q_Tz - rTz + w6
    return displacement


def motion_C(positions, errors, parameters, tool_point):
    """Motion equation of C: displacement of the tool point since home, to first order.

    Source: Eqs. (7)-(11). Operations: 118 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB
                ECB EXC EYC EZC EAC EBC ECC
        parameters (20,): home positions and location errors [mm, rad]
            rows: q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T
                EZ0T
        tool_point (3, n): point in the tool frame [mm]
            rows: rTx rTy rTz

    Returns:
        displacement (3, n): tool point, displacement since home, in the bed frame [mm]
            rows: dx dy dz
    """
    n, positions, errors, tool_point = _points(positions=(positions, 5), errors=(errors, 30), tool_point=(tool_point, 3))
    parameters = _constant("parameters", parameters, (20,))
    displacement = np.zeros((3, n))
    # constants
    q_Bx = float(parameters[0])
    q_By = float(parameters[1])
    q_Bz = float(parameters[2])
    q_Tx = float(parameters[3])
    q_Ty = float(parameters[4])
    q_Tz = float(parameters[5])
    EC0Y = float(parameters[6])
    EA0Z = float(parameters[7])
    EB0Z = float(parameters[8])
    EA0C = float(parameters[11])
    EB0C = float(parameters[12])
    EX0B = float(parameters[13])
    EA0B = float(parameters[15])
    EC0B = float(parameters[16])
    EX0T = float(parameters[17])
    EY0T = float(parameters[18])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        c = positions[4, at]
        EXC = errors[24, at]
        EYC = errors[25, at]
        EZC = errors[26, at]
        EAC = errors[27, at]
        EBC = errors[28, at]
        ECC = errors[29, at]
        rTx = tool_point[0, at]
        rTy = tool_point[1, at]
        rTz = tool_point[2, at]
        # cosines and sines
        cos_c = np.cos(0.017453292519943295*c)
        sin_c = np.sin(0.017453292519943295*c)
        # per point
        w0 = q_Tz*sin_c + rTz*sin_c
        w1 = q_Bz*sin_c + w0
        w2 = cos_c*q_Tz + cos_c*rTz
        w3 = cos_c*q_Bz + w2
        w4 = cos_c*q_Ty + cos_c*rTy + q_Tx*sin_c + rTx*sin_c
        w5 = -q_Ty - rTy + w4
        w6 = cos_c*q_By + q_Bx*sin_c
        w7 = -q_By + w5 + w6
        w8 = cos_c - 1
        w9 = q_By*sin_c
        w10 = q_Ty*sin_c
        w11 = rTy*sin_c
        w12 = cos_c*q_Bx + cos_c*q_Tx + cos_c*rTx - w10 - w11 - w9
        displacement[0, at] = EA0B*w0 + EAC*w1 + EBC*w3 - EC0B*w5 - EC0Y*w7 + ECC*(-w4 - w6) + EX0B*w8 + EX0T*w8 + EXC*cos_c - EY0T*sin_c - EYC*sin_c - q_Bx - q_Tx - rTx + w12
        w13 = q_Tx + rTx
        w14 = -cos_c*q_Tx - cos_c*rTx + w10 + w11
        w15 = q_Bx + w13
        w16 = -cos_c*q_Bx + w14 + w15 + w9
        displacement[1, at] = EA0B*(q_Tz + rTz - w2) - EAC*w3 + EBC*w1 + EC0B*(-w13 - w14) - EC0Y*w16 + ECC*w12 + EX0B*sin_c + EX0T*sin_c + EXC*sin_c + EY0T*w8 + EYC*cos_c + w7
        displacement[2, at] = EA0C*w7 + EA0Z*w7 + EAC*(q_By + q_Ty + rTy) + EB0C*w16 + EB0Z*w16 - EBC*w15 + EZC
    return displacement


def motion_XY(positions, errors, parameters, tool_point):
    """Motion equation of X and Y: displacement of the tool point since home, to first order.

    Source: Eqs. (7)-(11). Operations: 40 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB
                ECB EXC EYC EZC EAC EBC ECC
        parameters (20,): home positions and location errors [mm, rad]
            rows: q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T
                EZ0T
        tool_point (3, n): point in the tool frame [mm]
            rows: rTx rTy rTz

    Returns:
        displacement (3, n): tool point, displacement since home, in the bed frame [mm]
            rows: dx dy dz
    """
    n, positions, errors, tool_point = _points(positions=(positions, 5), errors=(errors, 30), tool_point=(tool_point, 3))
    parameters = _constant("parameters", parameters, (20,))
    displacement = np.zeros((3, n))
    # constants
    q_Bx = float(parameters[0])
    q_By = float(parameters[1])
    q_Bz = float(parameters[2])
    q_Tx = float(parameters[3])
    q_Ty = float(parameters[4])
    q_Tz = float(parameters[5])
    EC0Y = float(parameters[6])
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
        rTx = tool_point[0, at]
        rTy = tool_point[1, at]
        rTz = tool_point[2, at]
        # per point
        w0 = q_Bz + q_Tz + rTz
        w1 = q_By + q_Ty + rTy
        w2 = w1 + y
        displacement[0, at] = EBX*w0 + EBY*w0 - EC0Y*y - ECX*w2 - ECY*w1 + EXX + EXY + x
        w3 = q_Bx + q_Tx + rTx
        w4 = -w0
        displacement[1, at] = EAX*w4 + EAY*w4 + ECX*w3 + ECY*w3 + EYX + EYY + y
        w5 = -w3
        displacement[2, at] = EAX*w2 + EAY*w1 + EBX*w5 + EBY*w5 + EZX + EZY
    return displacement


def motion_XZ(positions, errors, parameters, tool_point):
    """Motion equation of X and Z: displacement of the tool point since home, to first order.

    Source: Eqs. (7)-(11). Operations: 42 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB
                ECB EXC EYC EZC EAC EBC ECC
        parameters (20,): home positions and location errors [mm, rad]
            rows: q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T
                EZ0T
        tool_point (3, n): point in the tool frame [mm]
            rows: rTx rTy rTz

    Returns:
        displacement (3, n): tool point, displacement since home, in the bed frame [mm]
            rows: dx dy dz
    """
    n, positions, errors, tool_point = _points(positions=(positions, 5), errors=(errors, 30), tool_point=(tool_point, 3))
    parameters = _constant("parameters", parameters, (20,))
    displacement = np.zeros((3, n))
    # constants
    q_Bx = float(parameters[0])
    q_By = float(parameters[1])
    q_Bz = float(parameters[2])
    q_Tx = float(parameters[3])
    q_Ty = float(parameters[4])
    q_Tz = float(parameters[5])
    EA0Z = float(parameters[7])
    EB0Z = float(parameters[8])
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
        w0 = q_Bz + q_Tz + rTz
        w1 = w0 + z
        w2 = q_By + q_Ty + rTy
        w3 = -w2
        displacement[0, at] = EB0Z*z + EBX*w1 + EBZ*w0 + ECX*w3 + ECZ*w3 + EXX + EXZ + x
        w4 = q_Bx + q_Tx + rTx
        displacement[1, at] = -EA0Z*z - EAX*w1 - EAZ*w0 + ECX*w4 + ECZ*w4 + EYX + EYZ
        w5 = -w4
        displacement[2, at] = EAX*w2 + EAZ*w2 + EBX*w5 + EBZ*w5 + EZX + EZZ + z
    return displacement


def motion_YZ(positions, errors, parameters, tool_point):
    """Motion equation of Y and Z: displacement of the tool point since home, to first order.

    Source: Eqs. (7)-(11). Operations: 44 per point.

    Arguments (float64):
        positions (5, n): commanded positions of X Y Z B C [mm, rotary axes deg]
            rows: x y z b c
        errors (30, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ EXB EYB EZB EAB EBB
                ECB EXC EYC EZC EAC EBC ECC
        parameters (20,): home positions and location errors [mm, rad]
            rows: q_Bx q_By q_Bz q_Tx q_Ty q_Tz EC0Y EA0Z EB0Z EX0C EY0C EA0C EB0C EX0B EZ0B EA0B EC0B EX0T EY0T
                EZ0T
        tool_point (3, n): point in the tool frame [mm]
            rows: rTx rTy rTz

    Returns:
        displacement (3, n): tool point, displacement since home, in the bed frame [mm]
            rows: dx dy dz
    """
    n, positions, errors, tool_point = _points(positions=(positions, 5), errors=(errors, 30), tool_point=(tool_point, 3))
    parameters = _constant("parameters", parameters, (20,))
    displacement = np.zeros((3, n))
    # constants
    q_Bx = float(parameters[0])
    q_By = float(parameters[1])
    q_Bz = float(parameters[2])
    q_Tx = float(parameters[3])
    q_Ty = float(parameters[4])
    q_Tz = float(parameters[5])
    EC0Y = float(parameters[6])
    EA0Z = float(parameters[7])
    EB0Z = float(parameters[8])
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
        rTx = tool_point[0, at]
        rTy = tool_point[1, at]
        rTz = tool_point[2, at]
        # per point
        w0 = q_Bz + q_Tz + rTz
        w1 = w0 + z
        w2 = q_By + q_Ty + rTy
        w3 = -w2
        displacement[0, at] = EB0Z*z + EBY*w1 + EBZ*w0 - EC0Y*y + ECY*w3 + ECZ*w3 + EXY + EXZ
        w4 = q_Bx + q_Tx + rTx
        displacement[1, at] = -EA0Z*z - EAY*w1 - EAZ*w0 + ECY*w4 + ECZ*w4 + EYY + EYZ + y
        w5 = -w4
        displacement[2, at] = EAY*w2 + EAZ*w2 + EBY*w5 + EBZ*w5 + EZY + EZZ + z
    return displacement
