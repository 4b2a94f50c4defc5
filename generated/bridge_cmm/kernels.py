# Generated from machines/bridge_cmm.toml, do not edit; regenerate with: trueaxis derive machines/bridge_cmm.toml
# SPDX-License-Identifier: MIT
"""Kernels of Bridge coordinate measuring machine: geometric error model in NumPy.

Arrays are float64 with the quantity first and the point last: positions (n_axes, n), errors (n_components, n),
deviation (3, n). An array that is the same at all points may have n = 1. Lengths mm, angles rad.
An array of another shape is a ValueError that names it.

Equations after: Prediction and compensation of geometric error for translational axes in multi-axis machine tools
"""

import numpy as np

ABI = 3
SPEC_HASH = "316443eb7e27d6b078d5a40b3776dd9c4bae13a4f2e33b47e425a6d867458069"

META = {
    'machine': 'bridge_cmm',
    'title': 'Bridge coordinate measuring machine',
    'axes': ['X', 'Y', 'Z'],
    'position_units': ['mm', 'mm', 'mm'],
    'travel': {'X': [0.0, 900.0], 'Y': [0.0, 1200.0], 'Z': [-700.0, 0.0]},
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
    'parameters': ['q_Px', 'q_Py', 'q_Pz', 'EC0X', 'EA0Z', 'EB0Z'],
    'parameter_units': ['mm', 'mm', 'mm', 'rad', 'rad', 'rad'],
    'parameter_descriptions': [
        'home position along X, body 6 (tool) on body 5', 'home position along Y, body 6 (tool) on body 5',
        'home position along Z, body 6 (tool) on body 5',
        'location error, rotation about Z, body 4 (X slide) on body 3',
        'location error, rotation about X, body 5 (Z slide) on body 4',
        'location error, rotation about Y, body 5 (Z slide) on body 4',
    ],
    'dimensions': ['q_Px', 'q_Py', 'q_Pz'],
    'location_errors': ['EC0X', 'EA0Z', 'EB0Z'],
    'curve_degree': 7,
    'squareness': [
        {'axes': ['X', 'Y'], 'location_errors': {'EC0X': 1.0}},
        {'axes': ['X', 'Z'], 'location_errors': {'EB0Z': 1.0}},
        {'axes': ['Y', 'Z'], 'location_errors': {'EA0Z': -1.0}},
    ],
    'effects': {'kinds': {}, 'terms': []},
    'routines': {
        'tool_in_workpiece_ideal': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'parameters', 'shape': [6], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'ideal', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 6,
            'operations_per_call': 0,
        },
        'tool_in_workpiece_deviation': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [6], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 70,
            'operations_per_call': 0,
        },
        'tool_in_workpiece_deviation_first_order': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [6], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 59,
            'operations_per_call': 0,
        },
        'tool_in_workpiece_sensitivity': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'parameters', 'shape': [6], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'sensitivity', 'shape': [3, 21], 'per_point': True, 'unit': 'mm/mm, mm/rad'}],
            'operations': 10,
            'operations_per_call': 0,
        },
        'tool_in_bed_ideal': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'parameters', 'shape': [6], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'ideal', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 6,
            'operations_per_call': 0,
        },
        'tool_in_bed_deviation': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [6], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 70,
            'operations_per_call': 0,
        },
        'tool_in_bed_deviation_first_order': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [6], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 59,
            'operations_per_call': 0,
        },
        'tool_in_bed_sensitivity': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'parameters', 'shape': [6], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'sensitivity', 'shape': [3, 21], 'per_point': True, 'unit': 'mm/mm, mm/rad'}],
            'operations': 10,
            'operations_per_call': 0,
        },
        'workpiece_in_bed_ideal': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'parameters', 'shape': [6], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'ideal', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 0,
            'operations_per_call': 0,
        },
        'workpiece_in_bed_deviation': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [6], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 0,
            'operations_per_call': 0,
        },
        'workpiece_in_bed_deviation_first_order': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [6], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 0,
            'operations_per_call': 0,
        },
        'workpiece_in_bed_sensitivity': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'parameters', 'shape': [6], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'sensitivity', 'shape': [3, 21], 'per_point': True, 'unit': 'mm/mm, mm/rad'}],
            'operations': 0,
            'operations_per_call': 0,
        },
        'bed_in_workpiece_ideal': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'parameters', 'shape': [6], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'ideal', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 0,
            'operations_per_call': 0,
        },
        'bed_in_workpiece_deviation': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [6], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 0,
            'operations_per_call': 0,
        },
        'bed_in_workpiece_deviation_first_order': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [6], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 0,
            'operations_per_call': 0,
        },
        'bed_in_workpiece_sensitivity': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'parameters', 'shape': [6], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'sensitivity', 'shape': [3, 21], 'per_point': True, 'unit': 'mm/mm, mm/rad'}],
            'operations': 0,
            'operations_per_call': 0,
        },
        'tool_in_workpiece_position': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [6], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'position', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 74,
            'operations_per_call': 0,
        },
        'tool_in_workpiece_position_first_order': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [6], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'position', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 63,
            'operations_per_call': 0,
        },
        'tool_in_workpiece_deviation_curves': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'curves', 'shape': [18, 7], 'per_point': False, 'unit': 'mm/mm^k, rad/mm^k'},
                {'name': 'parameters', 'shape': [6], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': False, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 301,
            'operations_per_call': 3,
        },
        'tool_in_workpiece_deviation_first_order_curves': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'curves', 'shape': [18, 7], 'per_point': False, 'unit': 'mm/mm^k, rad/mm^k'},
                {'name': 'parameters', 'shape': [6], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': False, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 206,
            'operations_per_call': 267,
        },
        'ballbar_error': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [6], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'ball', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'length', 'shape': [1], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'error', 'shape': [4], 'per_point': True, 'unit': 'mm'}],
            'operations': 107,
            'operations_per_call': 0,
        },
        'correction': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'moves', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 0,
            'operations_per_call': 0,
        },
        'motion_X': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [6], 'per_point': False, 'unit': 'mm, rad'},
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
                {'name': 'parameters', 'shape': [6], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'tool_point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'displacement', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 16,
            'operations_per_call': 0,
        },
        'motion_Z': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [6], 'per_point': False, 'unit': 'mm, rad'},
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
                {'name': 'parameters', 'shape': [6], 'per_point': False, 'unit': 'mm, rad'},
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
                {'name': 'parameters', 'shape': [6], 'per_point': False, 'unit': 'mm, rad'},
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
                {'name': 'parameters', 'shape': [6], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'tool_point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'displacement', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 39,
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

    Source: Eqs. (1)-(4) without errors. Operations: 6 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        parameters (6,): home positions and location errors [mm, rad]
            rows: q_Px q_Py q_Pz EC0X EA0Z EB0Z
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        ideal (3, n): tool point in the workpiece frame, without errors [mm]
            rows: px py pz
    """
    n, positions, point = _points(positions=(positions, 3), point=(point, 3))
    parameters = _constant("parameters", parameters, (6,))
    ideal = np.zeros((3, n))
    # constants
    q_Px = float(parameters[0])
    q_Py = float(parameters[1])
    q_Pz = float(parameters[2])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        x = positions[0, at]
        y = positions[1, at]
        z = positions[2, at]
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # per point
        ideal[0, at] = q_Px + rx + x
        ideal[1, at] = q_Py + ry + y
        ideal[2, at] = q_Pz + rz + z
    return ideal


def tool_in_workpiece_deviation(positions, errors, parameters, point):
    """Deviation of a tool point in the workpiece frame, exact.

    Source: Eqs. (1)-(4). Operations: 70 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (6,): home positions and location errors [mm, rad]
            rows: q_Px q_Py q_Pz EC0X EA0Z EB0Z
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): tool point in the workpiece frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions, errors, point = _points(positions=(positions, 3), errors=(errors, 18), point=(point, 3))
    parameters = _constant("parameters", parameters, (6,))
    deviation = np.zeros((3, n))
    # constants
    q_Px = float(parameters[0])
    q_Py = float(parameters[1])
    q_Pz = float(parameters[2])
    EC0X = float(parameters[3])
    EA0Z = float(parameters[4])
    EB0Z = float(parameters[5])
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
        w0 = q_Pz + rz
        w1 = w0 + z
        w2 = q_Py + ry
        w3 = q_Px + rx
        w4 = EAZ*w2 - EBZ*w3 + EZZ
        w5 = w1 + w4
        w6 = -EAZ*w0 + ECZ*w3 + EYZ
        w7 = -EA0Z*w5 + w6
        w8 = w2 + w7
        w9 = EBZ*w0 - ECZ*w2 + EXZ
        w10 = EB0Z*w5 + w9
        w11 = w10 + w3
        w12 = EA0Z*(w2 + w6) - EB0Z*(w3 + w9) + w4
        w13 = EAX*w8 - EBX*w11 + EZX + w12
        w14 = w1 + w13
        w15 = w1 + w12
        w16 = EBX*w15 - ECX*w8 + EXX + w10
        w17 = -EAX*w15 + ECX*w11 + EYX + w7
        w18 = w3 + x
        w19 = EC0X*(w16 + w18) + w17
        w20 = w19 + w2
        w21 = -EC0X*(w17 + w2) + w16
        deviation[0, at] = EBY*w14 - ECY*w20 + EXY + w21
        w22 = w18 + w21
        deviation[1, at] = -EAY*w14 + ECY*w22 + EYY + w19
        deviation[2, at] = EAY*w20 - EBY*w22 + EZY + w13
    return deviation


def tool_in_workpiece_deviation_first_order(positions, errors, parameters, point):
    """Deviation of a tool point in the workpiece frame, to first order in the errors.

    Source: Eqs. (1)-(4). Operations: 59 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (6,): home positions and location errors [mm, rad]
            rows: q_Px q_Py q_Pz EC0X EA0Z EB0Z
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): tool point in the workpiece frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions, errors, point = _points(positions=(positions, 3), errors=(errors, 18), point=(point, 3))
    parameters = _constant("parameters", parameters, (6,))
    deviation = np.zeros((3, n))
    # constants
    q_Px = float(parameters[0])
    q_Py = float(parameters[1])
    q_Pz = float(parameters[2])
    EC0X = float(parameters[3])
    EA0Z = float(parameters[4])
    EB0Z = float(parameters[5])
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
        w0 = q_Py + ry
        w1 = q_Pz + rz
        w2 = w1 + z
        w3 = EBZ*w1 - ECZ*w0 + EXZ
        w4 = EB0Z*w2 + w3
        w5 = EBX*w2 - ECX*w0 + EXX + w4
        w6 = -EC0X*w0 + w5
        deviation[0, at] = EBY*w2 - ECY*w0 + EXY + w6
        w7 = q_Px + rx
        w8 = w7 + x
        w9 = -EAZ*w1 + ECZ*w7 + EYZ
        w10 = -EA0Z*w2 + w9
        w11 = -EAX*w2 + ECX*w7 + EYX + w10
        w12 = EC0X*w8 + w11
        deviation[1, at] = -EAY*w2 + ECY*w8 + EYY + w12
        w13 = EAZ*w0 - EBZ*w7 + EZZ
        w14 = EA0Z*w0 - EB0Z*w7 + w13
        w15 = EAX*w0 - EBX*w7 + EZX + w14
        deviation[2, at] = EAY*w0 - EBY*w8 + EZY + w15
    return deviation


def tool_in_workpiece_sensitivity(positions, parameters, point):
    """Sensitivity of a tool point in the workpiece frame to every error, at the error-free machine.

    Source: Eqs. (1)-(4), first order. Operations: 10 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        parameters (6,): home positions and location errors [mm, rad]
            rows: q_Px q_Py q_Pz EC0X EA0Z EB0Z
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        sensitivity (3, 21, n): derivative of the deviation by each component error, then by each location error [mm/mm, mm/rad]
            rows: dx_EXX dx_EYX .. dz_EB0Z, last index fastest
    """
    n, positions, point = _points(positions=(positions, 3), point=(point, 3))
    parameters = _constant("parameters", parameters, (6,))
    sensitivity = np.zeros((63, n))
    # constants
    q_Px = float(parameters[0])
    q_Py = float(parameters[1])
    q_Pz = float(parameters[2])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        x = positions[0, at]
        z = positions[2, at]
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # per point
        sensitivity[16, at] = dx_EBZ = q_Pz + rz
        sensitivity[4, at] = dx_EBX = dx_EBZ + z
        sensitivity[45, at] = dz_EAX = q_Py + ry
        sensitivity[5, at] = dx_ECX = -dz_EAX
        sensitivity[24, at] = dy_EAX = -dx_EBX
        sensitivity[26, at] = dy_ECX = q_Px + rx
        sensitivity[32, at] = dy_ECY = dy_ECX + x
        sensitivity[46, at] = dz_EBX = -dy_ECX
        sensitivity[0, at] = 1.0
        sensitivity[6, at] = 1.0
        sensitivity[10, at] = dx_EBX
        sensitivity[11, at] = dx_ECX
        sensitivity[12, at] = 1.0
        sensitivity[17, at] = dx_ECX
        sensitivity[18, at] = dx_ECX
        sensitivity[20, at] = dx_EBX
        sensitivity[22, at] = 1.0
        sensitivity[28, at] = 1.0
        sensitivity[30, at] = dy_EAX
        sensitivity[34, at] = 1.0
        sensitivity[36, at] = -dx_EBZ
        sensitivity[38, at] = dy_ECX
        sensitivity[39, at] = dy_ECY
        sensitivity[40, at] = dy_EAX
        sensitivity[44, at] = 1.0
        sensitivity[50, at] = 1.0
        sensitivity[51, at] = dz_EAX
        sensitivity[52, at] = -dy_ECY
        sensitivity[56, at] = 1.0
        sensitivity[57, at] = dz_EAX
        sensitivity[58, at] = dz_EBX
        sensitivity[61, at] = dz_EAX
        sensitivity[62, at] = dz_EBX
    return sensitivity.reshape(3, 21, n)


def tool_in_bed_ideal(positions, parameters, point):
    """Ideal position of a tool point in the bed frame.

    Source: Eqs. (1)-(4) without errors. Operations: 6 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        parameters (6,): home positions and location errors [mm, rad]
            rows: q_Px q_Py q_Pz EC0X EA0Z EB0Z
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        ideal (3, n): tool point in the bed frame, without errors [mm]
            rows: px py pz
    """
    n, positions, point = _points(positions=(positions, 3), point=(point, 3))
    parameters = _constant("parameters", parameters, (6,))
    ideal = np.zeros((3, n))
    # constants
    q_Px = float(parameters[0])
    q_Py = float(parameters[1])
    q_Pz = float(parameters[2])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        x = positions[0, at]
        y = positions[1, at]
        z = positions[2, at]
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # per point
        ideal[0, at] = q_Px + rx + x
        ideal[1, at] = q_Py + ry + y
        ideal[2, at] = q_Pz + rz + z
    return ideal


def tool_in_bed_deviation(positions, errors, parameters, point):
    """Deviation of a tool point in the bed frame, exact.

    Source: Eqs. (1)-(4). Operations: 70 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (6,): home positions and location errors [mm, rad]
            rows: q_Px q_Py q_Pz EC0X EA0Z EB0Z
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): tool point in the bed frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions, errors, point = _points(positions=(positions, 3), errors=(errors, 18), point=(point, 3))
    parameters = _constant("parameters", parameters, (6,))
    deviation = np.zeros((3, n))
    # constants
    q_Px = float(parameters[0])
    q_Py = float(parameters[1])
    q_Pz = float(parameters[2])
    EC0X = float(parameters[3])
    EA0Z = float(parameters[4])
    EB0Z = float(parameters[5])
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
        w0 = q_Pz + rz
        w1 = w0 + z
        w2 = q_Py + ry
        w3 = q_Px + rx
        w4 = EAZ*w2 - EBZ*w3 + EZZ
        w5 = w1 + w4
        w6 = -EAZ*w0 + ECZ*w3 + EYZ
        w7 = -EA0Z*w5 + w6
        w8 = w2 + w7
        w9 = EBZ*w0 - ECZ*w2 + EXZ
        w10 = EB0Z*w5 + w9
        w11 = w10 + w3
        w12 = EA0Z*(w2 + w6) - EB0Z*(w3 + w9) + w4
        w13 = EAX*w8 - EBX*w11 + EZX + w12
        w14 = w1 + w13
        w15 = w1 + w12
        w16 = EBX*w15 - ECX*w8 + EXX + w10
        w17 = -EAX*w15 + ECX*w11 + EYX + w7
        w18 = w3 + x
        w19 = EC0X*(w16 + w18) + w17
        w20 = w19 + w2
        w21 = -EC0X*(w17 + w2) + w16
        deviation[0, at] = EBY*w14 - ECY*w20 + EXY + w21
        w22 = w18 + w21
        deviation[1, at] = -EAY*w14 + ECY*w22 + EYY + w19
        deviation[2, at] = EAY*w20 - EBY*w22 + EZY + w13
    return deviation


def tool_in_bed_deviation_first_order(positions, errors, parameters, point):
    """Deviation of a tool point in the bed frame, to first order in the errors.

    Source: Eqs. (1)-(4). Operations: 59 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (6,): home positions and location errors [mm, rad]
            rows: q_Px q_Py q_Pz EC0X EA0Z EB0Z
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): tool point in the bed frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions, errors, point = _points(positions=(positions, 3), errors=(errors, 18), point=(point, 3))
    parameters = _constant("parameters", parameters, (6,))
    deviation = np.zeros((3, n))
    # constants
    q_Px = float(parameters[0])
    q_Py = float(parameters[1])
    q_Pz = float(parameters[2])
    EC0X = float(parameters[3])
    EA0Z = float(parameters[4])
    EB0Z = float(parameters[5])
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
        w0 = q_Py + ry
        w1 = q_Pz + rz
        w2 = w1 + z
        w3 = EBZ*w1 - ECZ*w0 + EXZ
        w4 = EB0Z*w2 + w3
        w5 = EBX*w2 - ECX*w0 + EXX + w4
        w6 = -EC0X*w0 + w5
        deviation[0, at] = EBY*w2 - ECY*w0 + EXY + w6
        w7 = q_Px + rx
        w8 = w7 + x
        w9 = -EAZ*w1 + ECZ*w7 + EYZ
        w10 = -EA0Z*w2 + w9
        w11 = -EAX*w2 + ECX*w7 + EYX + w10
        w12 = EC0X*w8 + w11
        deviation[1, at] = -EAY*w2 + ECY*w8 + EYY + w12
        w13 = EAZ*w0 - EBZ*w7 + EZZ
        w14 = EA0Z*w0 - EB0Z*w7 + w13
        w15 = EAX*w0 - EBX*w7 + EZX + w14
        deviation[2, at] = EAY*w0 - EBY*w8 + EZY + w15
    return deviation


def tool_in_bed_sensitivity(positions, parameters, point):
    """Sensitivity of a tool point in the bed frame to every error, at the error-free machine.

    Source: Eqs. (1)-(4), first order. Operations: 10 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        parameters (6,): home positions and location errors [mm, rad]
            rows: q_Px q_Py q_Pz EC0X EA0Z EB0Z
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        sensitivity (3, 21, n): derivative of the deviation by each component error, then by each location error [mm/mm, mm/rad]
            rows: dx_EXX dx_EYX .. dz_EB0Z, last index fastest
    """
    n, positions, point = _points(positions=(positions, 3), point=(point, 3))
    parameters = _constant("parameters", parameters, (6,))
    sensitivity = np.zeros((63, n))
    # constants
    q_Px = float(parameters[0])
    q_Py = float(parameters[1])
    q_Pz = float(parameters[2])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        x = positions[0, at]
        z = positions[2, at]
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # per point
        sensitivity[16, at] = dx_EBZ = q_Pz + rz
        sensitivity[4, at] = dx_EBX = dx_EBZ + z
        sensitivity[45, at] = dz_EAX = q_Py + ry
        sensitivity[5, at] = dx_ECX = -dz_EAX
        sensitivity[24, at] = dy_EAX = -dx_EBX
        sensitivity[26, at] = dy_ECX = q_Px + rx
        sensitivity[32, at] = dy_ECY = dy_ECX + x
        sensitivity[46, at] = dz_EBX = -dy_ECX
        sensitivity[0, at] = 1.0
        sensitivity[6, at] = 1.0
        sensitivity[10, at] = dx_EBX
        sensitivity[11, at] = dx_ECX
        sensitivity[12, at] = 1.0
        sensitivity[17, at] = dx_ECX
        sensitivity[18, at] = dx_ECX
        sensitivity[20, at] = dx_EBX
        sensitivity[22, at] = 1.0
        sensitivity[28, at] = 1.0
        sensitivity[30, at] = dy_EAX
        sensitivity[34, at] = 1.0
        sensitivity[36, at] = -dx_EBZ
        sensitivity[38, at] = dy_ECX
        sensitivity[39, at] = dy_ECY
        sensitivity[40, at] = dy_EAX
        sensitivity[44, at] = 1.0
        sensitivity[50, at] = 1.0
        sensitivity[51, at] = dz_EAX
        sensitivity[52, at] = -dy_ECY
        sensitivity[56, at] = 1.0
        sensitivity[57, at] = dz_EAX
        sensitivity[58, at] = dz_EBX
        sensitivity[61, at] = dz_EAX
        sensitivity[62, at] = dz_EBX
    return sensitivity.reshape(3, 21, n)


def workpiece_in_bed_ideal(positions, parameters, point):
    """Ideal position of a workpiece point in the bed frame.

    Source: Eqs. (1)-(4) without errors. Operations: 0 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        parameters (6,): home positions and location errors [mm, rad]
            rows: q_Px q_Py q_Pz EC0X EA0Z EB0Z
        point (3, n): point in the workpiece frame [mm]
            rows: rx ry rz

    Returns:
        ideal (3, n): workpiece point in the bed frame, without errors [mm]
            rows: px py pz
    """
    n, positions, point = _points(positions=(positions, 3), point=(point, 3))
    parameters = _constant("parameters", parameters, (6,))
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
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (6,): home positions and location errors [mm, rad]
            rows: q_Px q_Py q_Pz EC0X EA0Z EB0Z
        point (3, n): point in the workpiece frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): workpiece point in the bed frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions, errors, point = _points(positions=(positions, 3), errors=(errors, 18), point=(point, 3))
    parameters = _constant("parameters", parameters, (6,))
    deviation = np.zeros((3, n))
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        # per point
    return deviation


def workpiece_in_bed_deviation_first_order(positions, errors, parameters, point):
    """Deviation of a workpiece point in the bed frame, to first order in the errors.

    Source: Eqs. (1)-(4). Operations: 0 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (6,): home positions and location errors [mm, rad]
            rows: q_Px q_Py q_Pz EC0X EA0Z EB0Z
        point (3, n): point in the workpiece frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): workpiece point in the bed frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions, errors, point = _points(positions=(positions, 3), errors=(errors, 18), point=(point, 3))
    parameters = _constant("parameters", parameters, (6,))
    deviation = np.zeros((3, n))
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        # per point
    return deviation


def workpiece_in_bed_sensitivity(positions, parameters, point):
    """Sensitivity of a workpiece point in the bed frame to every error, at the error-free machine.

    Source: Eqs. (1)-(4), first order. Operations: 0 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        parameters (6,): home positions and location errors [mm, rad]
            rows: q_Px q_Py q_Pz EC0X EA0Z EB0Z
        point (3, n): point in the workpiece frame [mm]
            rows: rx ry rz

    Returns:
        sensitivity (3, 21, n): derivative of the deviation by each component error, then by each location error [mm/mm, mm/rad]
            rows: dx_EXX dx_EYX .. dz_EB0Z, last index fastest
    """
    n, positions, point = _points(positions=(positions, 3), point=(point, 3))
    parameters = _constant("parameters", parameters, (6,))
    sensitivity = np.zeros((63, n))
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        # per point
    return sensitivity.reshape(3, 21, n)


def bed_in_workpiece_ideal(positions, parameters, point):
    """Ideal position of a bed point in the workpiece frame.

    Source: Eqs. (1)-(4) without errors. Operations: 0 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        parameters (6,): home positions and location errors [mm, rad]
            rows: q_Px q_Py q_Pz EC0X EA0Z EB0Z
        point (3, n): point in the bed frame [mm]
            rows: rx ry rz

    Returns:
        ideal (3, n): bed point in the workpiece frame, without errors [mm]
            rows: px py pz
    """
    n, positions, point = _points(positions=(positions, 3), point=(point, 3))
    parameters = _constant("parameters", parameters, (6,))
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
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (6,): home positions and location errors [mm, rad]
            rows: q_Px q_Py q_Pz EC0X EA0Z EB0Z
        point (3, n): point in the bed frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): bed point in the workpiece frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions, errors, point = _points(positions=(positions, 3), errors=(errors, 18), point=(point, 3))
    parameters = _constant("parameters", parameters, (6,))
    deviation = np.zeros((3, n))
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        # per point
    return deviation


def bed_in_workpiece_deviation_first_order(positions, errors, parameters, point):
    """Deviation of a bed point in the workpiece frame, to first order in the errors.

    Source: Eqs. (1)-(4). Operations: 0 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (6,): home positions and location errors [mm, rad]
            rows: q_Px q_Py q_Pz EC0X EA0Z EB0Z
        point (3, n): point in the bed frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): bed point in the workpiece frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions, errors, point = _points(positions=(positions, 3), errors=(errors, 18), point=(point, 3))
    parameters = _constant("parameters", parameters, (6,))
    deviation = np.zeros((3, n))
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        # per point
    return deviation


def bed_in_workpiece_sensitivity(positions, parameters, point):
    """Sensitivity of a bed point in the workpiece frame to every error, at the error-free machine.

    Source: Eqs. (1)-(4), first order. Operations: 0 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        parameters (6,): home positions and location errors [mm, rad]
            rows: q_Px q_Py q_Pz EC0X EA0Z EB0Z
        point (3, n): point in the bed frame [mm]
            rows: rx ry rz

    Returns:
        sensitivity (3, 21, n): derivative of the deviation by each component error, then by each location error [mm/mm, mm/rad]
            rows: dx_EXX dx_EYX .. dz_EB0Z, last index fastest
    """
    n, positions, point = _points(positions=(positions, 3), point=(point, 3))
    parameters = _constant("parameters", parameters, (6,))
    sensitivity = np.zeros((63, n))
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        # per point
    return sensitivity.reshape(3, 21, n)


def tool_in_workpiece_position(positions, errors, parameters, point):
    """Actual position of the tool point in the workpiece frame, exact.

    Source: Eq. (4). Operations: 74 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (6,): home positions and location errors [mm, rad]
            rows: q_Px q_Py q_Pz EC0X EA0Z EB0Z
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        position (3, n): actual position P_T^W of the tool point in the workpiece frame [mm]
            rows: px py pz
    """
    n, positions, errors, point = _points(positions=(positions, 3), errors=(errors, 18), point=(point, 3))
    parameters = _constant("parameters", parameters, (6,))
    position = np.zeros((3, n))
    # constants
    q_Px = float(parameters[0])
    q_Py = float(parameters[1])
    q_Pz = float(parameters[2])
    EC0X = float(parameters[3])
    EA0Z = float(parameters[4])
    EB0Z = float(parameters[5])
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
        w0 = q_Px + rx
        w1 = w0 + x
        w2 = q_Pz + rz
        w3 = w2 + z
        w4 = q_Py + ry
        w5 = EAZ*w4 - EBZ*w0 + EZZ
        w6 = w3 + w5
        w7 = -EAZ*w2 + ECZ*w0 + EYZ
        w8 = -EA0Z*w6 + w7
        w9 = w4 + w8
        w10 = EBZ*w2 - ECZ*w4 + EXZ
        w11 = EB0Z*w6 + w10
        w12 = w0 + w11
        w13 = EA0Z*(w4 + w7) - EB0Z*(w0 + w10) + w5
        w14 = EAX*w9 - EBX*w12 + EZX + w13
        w15 = w14 + w3
        w16 = w13 + w3
        w17 = EBX*w16 - ECX*w9 + EXX + w11
        w18 = -EAX*w16 + ECX*w12 + EYX + w8
        w19 = EC0X*(w1 + w17) + w18
        w20 = w19 + w4
        w21 = -EC0X*(w18 + w4) + w17
        w22 = EBY*w15 - ECY*w20 + EXY + w21
        position[0, at] = w1 + w22
        w23 = w1 + w21
        w24 = -EAY*w15 + ECY*w23 + EYY + w19
        w25 = w4 + y
        position[1, at] = w24 + w25
        w26 = EAY*w20 - EBY*w23 + EZY + w14
        position[2, at] = w26 + w3
    return position


def tool_in_workpiece_position_first_order(positions, errors, parameters, point):
    """Actual position of the tool point in the workpiece frame, to first order.

    Source: Eq. (4). Operations: 63 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (6,): home positions and location errors [mm, rad]
            rows: q_Px q_Py q_Pz EC0X EA0Z EB0Z
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        position (3, n): actual position P_T^W of the tool point in the workpiece frame [mm]
            rows: px py pz
    """
    n, positions, errors, point = _points(positions=(positions, 3), errors=(errors, 18), point=(point, 3))
    parameters = _constant("parameters", parameters, (6,))
    position = np.zeros((3, n))
    # constants
    q_Px = float(parameters[0])
    q_Py = float(parameters[1])
    q_Pz = float(parameters[2])
    EC0X = float(parameters[3])
    EA0Z = float(parameters[4])
    EB0Z = float(parameters[5])
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
        w0 = q_Px + rx
        w1 = w0 + x
        w2 = q_Py + ry
        w3 = q_Pz + rz
        w4 = w3 + z
        w5 = EBZ*w3 - ECZ*w2 + EXZ
        w6 = EB0Z*w4 + w5
        w7 = EBX*w4 - ECX*w2 + EXX + w6
        w8 = -EC0X*w2 + w7
        w9 = EBY*w4 - ECY*w2 + EXY + w8
        position[0, at] = w1 + w9
        w10 = -EAZ*w3 + ECZ*w0 + EYZ
        w11 = -EA0Z*w4 + w10
        w12 = -EAX*w4 + ECX*w0 + EYX + w11
        w13 = EC0X*w1 + w12
        w14 = -EAY*w4 + ECY*w1 + EYY + w13
        w15 = w2 + y
        position[1, at] = w14 + w15
        w16 = EAZ*w2 - EBZ*w0 + EZZ
        w17 = EA0Z*w2 - EB0Z*w0 + w16
        w18 = EAX*w2 - EBX*w0 + EZX + w17
        w19 = EAY*w2 - EBY*w1 + EZY + w18
        position[2, at] = w19 + w4
    return position


def tool_in_workpiece_deviation_curves(positions, curves, parameters, point):
    """Deviation of the tool point under polynomial error curves, exact.

    Source: Eqs. (1)-(4), (44). Operations: 301 per point, 3 per call.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        curves (18, 7): coefficients of the powers 1 to 7 of the axis position, per component error [mm/mm^k, rad/mm^k]
            rows: EXX_1 EXX_2 .. ECZ_7, last index fastest
        parameters (6,): home positions and location errors [mm, rad]
            rows: q_Px q_Py q_Pz EC0X EA0Z EB0Z
        point (3,): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): tool point in the workpiece frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions = _points(positions=(positions, 3))
    curves = _constant("curves", curves, (18, 7))
    parameters = _constant("parameters", parameters, (6,))
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
    q_Px = float(parameters[0])
    q_Py = float(parameters[1])
    q_Pz = float(parameters[2])
    EC0X = float(parameters[3])
    EA0Z = float(parameters[4])
    EB0Z = float(parameters[5])
    rx = float(point[0])
    ry = float(point[1])
    rz = float(point[2])
    # once per call
    w0 = q_Pz + rz
    w2 = q_Py + ry
    w6 = q_Px + rx
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        x = positions[0, at]
        y = positions[1, at]
        z = positions[2, at]
        # per point
        w1 = w0 + z
        w3 = _polynomial(z, EZZ_1, EZZ_2, EZZ_3, EZZ_4, EZZ_5, EZZ_6, EZZ_7)
        w4 = _polynomial(z, EAZ_1, EAZ_2, EAZ_3, EAZ_4, EAZ_5, EAZ_6, EAZ_7)
        w5 = _polynomial(z, EBZ_1, EBZ_2, EBZ_3, EBZ_4, EBZ_5, EBZ_6, EBZ_7)
        w7 = w2*w4 + w3 - w5*w6
        w8 = w1 + w7
        w9 = _polynomial(z, EYZ_1, EYZ_2, EYZ_3, EYZ_4, EYZ_5, EYZ_6, EYZ_7)
        w10 = _polynomial(z, ECZ_1, ECZ_2, ECZ_3, ECZ_4, ECZ_5, ECZ_6, ECZ_7)
        w11 = -w0*w4 + w10*w6 + w9
        w12 = -EA0Z*w8 + w11
        w13 = w12 + w2
        w14 = _polynomial(z, EXZ_1, EXZ_2, EXZ_3, EXZ_4, EXZ_5, EXZ_6, EXZ_7)
        w15 = w0*w5 - w10*w2 + w14
        w16 = EB0Z*w8 + w15
        w17 = w16 + w6
        w18 = _polynomial(x, EZX_1, EZX_2, EZX_3, EZX_4, EZX_5, EZX_6, EZX_7)
        w19 = _polynomial(x, EAX_1, EAX_2, EAX_3, EAX_4, EAX_5, EAX_6, EAX_7)
        w20 = _polynomial(x, EBX_1, EBX_2, EBX_3, EBX_4, EBX_5, EBX_6, EBX_7)
        w21 = EA0Z*(w11 + w2) - EB0Z*(w15 + w6) + w7
        w22 = w13*w19 - w17*w20 + w18 + w21
        w23 = w1 + w22
        w24 = w1 + w21
        w25 = _polynomial(x, EXX_1, EXX_2, EXX_3, EXX_4, EXX_5, EXX_6, EXX_7)
        w26 = _polynomial(x, ECX_1, ECX_2, ECX_3, ECX_4, ECX_5, ECX_6, ECX_7)
        w27 = -w13*w26 + w16 + w20*w24 + w25
        w28 = _polynomial(x, EYX_1, EYX_2, EYX_3, EYX_4, EYX_5, EYX_6, EYX_7)
        w29 = w12 + w17*w26 - w19*w24 + w28
        w30 = w6 + x
        w31 = EC0X*(w27 + w30) + w29
        w32 = w2 + w31
        w33 = _polynomial(y, EXY_1, EXY_2, EXY_3, EXY_4, EXY_5, EXY_6, EXY_7)
        w34 = _polynomial(y, EBY_1, EBY_2, EBY_3, EBY_4, EBY_5, EBY_6, EBY_7)
        w35 = _polynomial(y, ECY_1, ECY_2, ECY_3, ECY_4, ECY_5, ECY_6, ECY_7)
        w36 = -EC0X*(w2 + w29) + w27
        deviation[0, at] = w23*w34 - w32*w35 + w33 + w36
        w37 = w30 + w36
        w38 = _polynomial(y, EYY_1, EYY_2, EYY_3, EYY_4, EYY_5, EYY_6, EYY_7)
        w39 = _polynomial(y, EAY_1, EAY_2, EAY_3, EAY_4, EAY_5, EAY_6, EAY_7)
        deviation[1, at] = -w23*w39 + w31 + w35*w37 + w38
        w40 = _polynomial(y, EZY_1, EZY_2, EZY_3, EZY_4, EZY_5, EZY_6, EZY_7)
        deviation[2, at] = w22 + w32*w39 - w34*w37 + w40
    return deviation


def tool_in_workpiece_deviation_first_order_curves(positions, curves, parameters, point):
    """Deviation of the tool point under polynomial error curves, to first order, constants folded once per call.

    Source: Eqs. (1)-(4), (44). Operations: 206 per point, 267 per call.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        curves (18, 7): coefficients of the powers 1 to 7 of the axis position, per component error [mm/mm^k, rad/mm^k]
            rows: EXX_1 EXX_2 .. ECZ_7, last index fastest
        parameters (6,): home positions and location errors [mm, rad]
            rows: q_Px q_Py q_Pz EC0X EA0Z EB0Z
        point (3,): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): tool point in the workpiece frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions = _points(positions=(positions, 3))
    curves = _constant("curves", curves, (18, 7))
    parameters = _constant("parameters", parameters, (6,))
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
    q_Px = float(parameters[0])
    q_Py = float(parameters[1])
    q_Pz = float(parameters[2])
    EC0X = float(parameters[3])
    EA0Z = float(parameters[4])
    EB0Z = float(parameters[5])
    rx = float(point[0])
    ry = float(point[1])
    rz = float(point[2])
    # once per call
    w0 = q_Pz + rz
    w1 = q_Py + ry
    w2 = -w1
    w3 = EBZ_1*w0 + ECZ_1*w2 + EXZ_1
    w4 = EBZ_2*w0 + ECZ_2*w2 + EXZ_2
    w5 = EBZ_3*w0 + ECZ_3*w2 + EXZ_3
    w6 = EBZ_4*w0 + ECZ_4*w2 + EXZ_4
    w7 = EBZ_5*w0 + ECZ_5*w2 + EXZ_5
    w8 = EBZ_6*w0 + ECZ_6*w2 + EXZ_6
    w9 = EBZ_7*w0 + ECZ_7*w2 + EXZ_7
    w11 = EB0Z*w0 + EC0X*w2
    w12 = EBX_1*w0 + ECX_1*w2 + EXX_1
    w13 = EBX_2*w0 + ECX_2*w2 + EXX_2
    w14 = EBX_3*w0 + ECX_3*w2 + EXX_3
    w15 = EBX_4*w0 + ECX_4*w2 + EXX_4
    w16 = EBX_5*w0 + ECX_5*w2 + EXX_5
    w17 = EBX_6*w0 + ECX_6*w2 + EXX_6
    w18 = EBX_7*w0 + ECX_7*w2 + EXX_7
    w20 = EBY_1*w0 + ECY_1*w2 + EXY_1
    w21 = EBY_2*w0 + ECY_2*w2 + EXY_2
    w22 = EBY_3*w0 + ECY_3*w2 + EXY_3
    w23 = EBY_4*w0 + ECY_4*w2 + EXY_4
    w24 = EBY_5*w0 + ECY_5*w2 + EXY_5
    w25 = EBY_6*w0 + ECY_6*w2 + EXY_6
    w26 = EBY_7*w0 + ECY_7*w2 + EXY_7
    w34 = q_Px + rx
    w35 = -w0
    w36 = EAZ_1*w35 + ECZ_1*w34 + EYZ_1
    w37 = EAZ_2*w35 + ECZ_2*w34 + EYZ_2
    w38 = EAZ_3*w35 + ECZ_3*w34 + EYZ_3
    w39 = EAZ_4*w35 + ECZ_4*w34 + EYZ_4
    w40 = EAZ_5*w35 + ECZ_5*w34 + EYZ_5
    w41 = EAZ_6*w35 + ECZ_6*w34 + EYZ_6
    w42 = EAZ_7*w35 + ECZ_7*w34 + EYZ_7
    w44 = EA0Z*w35 + EC0X*w34
    w45 = EAX_1*w35 + ECX_1*w34 + EYX_1
    w46 = EAX_2*w35 + ECX_2*w34 + EYX_2
    w47 = EAX_3*w35 + ECX_3*w34 + EYX_3
    w48 = EAX_4*w35 + ECX_4*w34 + EYX_4
    w49 = EAX_5*w35 + ECX_5*w34 + EYX_5
    w50 = EAX_6*w35 + ECX_6*w34 + EYX_6
    w51 = EAX_7*w35 + ECX_7*w34 + EYX_7
    w53 = EAY_1*w35 + ECY_1*w34 + EYY_1
    w54 = EAY_2*w35 + ECY_2*w34 + EYY_2
    w55 = EAY_3*w35 + ECY_3*w34 + EYY_3
    w56 = EAY_4*w35 + ECY_4*w34 + EYY_4
    w57 = EAY_5*w35 + ECY_5*w34 + EYY_5
    w58 = EAY_6*w35 + ECY_6*w34 + EYY_6
    w59 = EAY_7*w35 + ECY_7*w34 + EYY_7
    w69 = -w34
    w70 = EAZ_1*w1 + EBZ_1*w69 + EZZ_1
    w71 = EAZ_2*w1 + EBZ_2*w69 + EZZ_2
    w72 = EAZ_3*w1 + EBZ_3*w69 + EZZ_3
    w73 = EAZ_4*w1 + EBZ_4*w69 + EZZ_4
    w74 = EAZ_5*w1 + EBZ_5*w69 + EZZ_5
    w75 = EAZ_6*w1 + EBZ_6*w69 + EZZ_6
    w76 = EAZ_7*w1 + EBZ_7*w69 + EZZ_7
    w78 = EA0Z*w1 + EB0Z*w69
    w79 = EAX_1*w1 + EBX_1*w69 + EZX_1
    w80 = EAX_2*w1 + EBX_2*w69 + EZX_2
    w81 = EAX_3*w1 + EBX_3*w69 + EZX_3
    w82 = EAX_4*w1 + EBX_4*w69 + EZX_4
    w83 = EAX_5*w1 + EBX_5*w69 + EZX_5
    w84 = EAX_6*w1 + EBX_6*w69 + EZX_6
    w85 = EAX_7*w1 + EBX_7*w69 + EZX_7
    w87 = EAY_1*w1 + EBY_1*w69 + EZY_1
    w88 = EAY_2*w1 + EBY_2*w69 + EZY_2
    w89 = EAY_3*w1 + EBY_3*w69 + EZY_3
    w90 = EAY_4*w1 + EBY_4*w69 + EZY_4
    w91 = EAY_5*w1 + EBY_5*w69 + EZY_5
    w92 = EAY_6*w1 + EBY_6*w69 + EZY_6
    w93 = EAY_7*w1 + EBY_7*w69 + EZY_7
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        x = positions[0, at]
        y = positions[1, at]
        z = positions[2, at]
        # per point
        w10 = _polynomial(z, w3, w4, w5, w6, w7, w8, w9)
        w19 = _polynomial(x, w12, w13, w14, w15, w16, w17, w18)
        w27 = _polynomial(y, w20, w21, w22, w23, w24, w25, w26)
        w28 = w10 + w11 + w19 + w27
        w29 = _polynomial(x, EBX_1, EBX_2, EBX_3, EBX_4, EBX_5, EBX_6, EBX_7)
        w30 = _polynomial(y, EBY_1, EBY_2, EBY_3, EBY_4, EBY_5, EBY_6, EBY_7)
        w31 = w30
        w32 = EB0Z + w29 + w31
        w33 = w32*z
        deviation[0, at] = w28 + w33
        w43 = _polynomial(z, w36, w37, w38, w39, w40, w41, w42)
        w52 = _polynomial(x, w45, w46, w47, w48, w49, w50, w51)
        w60 = _polynomial(y, w53, w54, w55, w56, w57, w58, w59)
        w61 = w43 + w44 + w52 + w60
        w62 = _polynomial(x, EAX_1, EAX_2, EAX_3, EAX_4, EAX_5, EAX_6, EAX_7)
        w63 = _polynomial(y, EAY_1, EAY_2, EAY_3, EAY_4, EAY_5, EAY_6, EAY_7)
        w64 = -EA0Z - w62 - w63
        w65 = w64*z
        w66 = _polynomial(y, ECY_1, ECY_2, ECY_3, ECY_4, ECY_5, ECY_6, ECY_7)
        w67 = EC0X + w66
        w68 = w67*x
        deviation[1, at] = w61 + w65 + w68
        w77 = _polynomial(z, w70, w71, w72, w73, w74, w75, w76)
        w86 = _polynomial(x, w79, w80, w81, w82, w83, w84, w85)
        w94 = _polynomial(y, w87, w88, w89, w90, w91, w92, w93)
        w95 = w77 + w78 + w86 + w94
        w96 = w30
        w97 = -w96*x
        deviation[2, at] = w95 + w97
    return deviation


def ballbar_error(positions, errors, parameters, point, ball, length):
    """Positioning error of a ball bar between a tool ball and a workpiece ball, exact.

    Source: Eqs. (5), (6). Operations: 107 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (6,): home positions and location errors [mm, rad]
            rows: q_Px q_Py q_Pz EC0X EA0Z EB0Z
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
    parameters = _constant("parameters", parameters, (6,))
    error = np.zeros((4, n))
    # constants
    q_Px = float(parameters[0])
    q_Py = float(parameters[1])
    q_Pz = float(parameters[2])
    EC0X = float(parameters[3])
    EA0Z = float(parameters[4])
    EB0Z = float(parameters[5])
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
        w0 = q_Pz + rz
        w1 = w0 + z
        w2 = q_Py + ry
        w3 = q_Px + rx
        w4 = EAZ*w2 - EBZ*w3 + EZZ
        w5 = w1 + w4
        w6 = -EAZ*w0 + ECZ*w3 + EYZ
        w7 = -EA0Z*w5 + w6
        w8 = w2 + w7
        w9 = EBZ*w0 - ECZ*w2 + EXZ
        w10 = EB0Z*w5 + w9
        w11 = w10 + w3
        w12 = EA0Z*(w2 + w6) - EB0Z*(w3 + w9) + w4
        w13 = EAX*w8 - EBX*w11 + EZX + w12
        w14 = w1 + w13
        w15 = w1 + w12
        w16 = EBX*w15 - ECX*w8 + EXX + w10
        w17 = -EAX*w15 + ECX*w11 + EYX + w7
        w18 = w3 + x
        w19 = EC0X*(w16 + w18) + w17
        w20 = w19 + w2
        w21 = -EC0X*(w17 + w2) + w16
        w22 = EBY*w14 - ECY*w20 + EXY + w21
        w23 = w18 + w21
        w24 = -EAY*w14 + ECY*w23 + EYY + w19
        w25 = EAY*w20 - EBY*w23 + EZY + w13
        w26 = -bx + w18
        w27 = w2 + y
        w28 = -by + w27
        w29 = -bz + w1
        w30 = w22 + w26
        w31 = w24 + w28
        w32 = w25 + w29
        w33 = np.sqrt((w26*w26) + (w28*w28) + (w29*w29))
        w34 = np.sqrt((w30*w30) + (w31*w31) + (w32*w32))
        error[0, at] = e = -length_ + w33 + (w22*(w26 + w30) + w24*(w28 + w31) + w25*(w29 + w32))/(w33 + w34)
        w35 = e/w34
        error[1, at] = w30*w35
        error[2, at] = w31*w35
        error[3, at] = w32*w35
    return error


def correction(positions, deviation):
    """Moves of the linear axes that displace the ideal tool point by the given vector.

    Source: Eqs. (53)-(55), inverse. Operations: 0 per point.

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
        moves[1, at] = dy
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
        parameters (6,): home positions and location errors [mm, rad]
            rows: q_Px q_Py q_Pz EC0X EA0Z EB0Z
        tool_point (3, n): point in the tool frame [mm]
            rows: rTx rTy rTz

    Returns:
        displacement (3, n): tool point, displacement since home, in the bed frame [mm]
            rows: dx dy dz
    """
    n, positions, errors, tool_point = _points(positions=(positions, 3), errors=(errors, 18), tool_point=(tool_point, 3))
    parameters = _constant("parameters", parameters, (6,))
    displacement = np.zeros((3, n))
    # constants
    q_Px = float(parameters[0])
    q_Py = float(parameters[1])
    q_Pz = float(parameters[2])
    EC0X = float(parameters[3])
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
        w0 = q_Pz + rTz
        w1 = q_Py + rTy
        displacement[0, at] = EBX*w0 - ECX*w1 + EXX + x
        w2 = q_Px + rTx
        displacement[1, at] = -EAX*w0 + EC0X*x + ECX*w2 + EYX
        displacement[2, at] = EAX*w1 - EBX*w2 + EZX
    return displacement


def motion_Y(positions, errors, parameters, tool_point):
    """Motion equation of Y: displacement of the tool point since home, to first order.

    Source: Eqs. (7)-(11). Operations: 16 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (6,): home positions and location errors [mm, rad]
            rows: q_Px q_Py q_Pz EC0X EA0Z EB0Z
        tool_point (3, n): point in the tool frame [mm]
            rows: rTx rTy rTz

    Returns:
        displacement (3, n): tool point, displacement since home, in the bed frame [mm]
            rows: dx dy dz
    """
    n, positions, errors, tool_point = _points(positions=(positions, 3), errors=(errors, 18), tool_point=(tool_point, 3))
    parameters = _constant("parameters", parameters, (6,))
    displacement = np.zeros((3, n))
    # constants
    q_Px = float(parameters[0])
    q_Py = float(parameters[1])
    q_Pz = float(parameters[2])
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
        w0 = q_Pz + rTz
        w1 = q_Py + rTy
        displacement[0, at] = EBY*w0 - ECY*w1 + EXY
        w2 = q_Px + rTx
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
        parameters (6,): home positions and location errors [mm, rad]
            rows: q_Px q_Py q_Pz EC0X EA0Z EB0Z
        tool_point (3, n): point in the tool frame [mm]
            rows: rTx rTy rTz

    Returns:
        displacement (3, n): tool point, displacement since home, in the bed frame [mm]
            rows: dx dy dz
    """
    n, positions, errors, tool_point = _points(positions=(positions, 3), errors=(errors, 18), tool_point=(tool_point, 3))
    parameters = _constant("parameters", parameters, (6,))
    displacement = np.zeros((3, n))
    # constants
    q_Px = float(parameters[0])
    q_Py = float(parameters[1])
    q_Pz = float(parameters[2])
    EA0Z = float(parameters[4])
    EB0Z = float(parameters[5])
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
        w0 = q_Pz + rTz
        w1 = q_Py + rTy
        displacement[0, at] = EB0Z*z + EBZ*w0 - ECZ*w1 + EXZ
        w2 = q_Px + rTx
        displacement[1, at] = -EA0Z*z - EAZ*w0 + ECZ*w2 + EYZ
        displacement[2, at] = EAZ*w1 - EBZ*w2 + EZZ + z
    return displacement


def motion_XY(positions, errors, parameters, tool_point):
    """Motion equation of X and Y: displacement of the tool point since home, to first order.

    Source: Eqs. (7)-(11). Operations: 37 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (6,): home positions and location errors [mm, rad]
            rows: q_Px q_Py q_Pz EC0X EA0Z EB0Z
        tool_point (3, n): point in the tool frame [mm]
            rows: rTx rTy rTz

    Returns:
        displacement (3, n): tool point, displacement since home, in the bed frame [mm]
            rows: dx dy dz
    """
    n, positions, errors, tool_point = _points(positions=(positions, 3), errors=(errors, 18), tool_point=(tool_point, 3))
    parameters = _constant("parameters", parameters, (6,))
    displacement = np.zeros((3, n))
    # constants
    q_Px = float(parameters[0])
    q_Py = float(parameters[1])
    q_Pz = float(parameters[2])
    EC0X = float(parameters[3])
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
        w0 = q_Pz + rTz
        w1 = q_Py + rTy
        w2 = -w1
        displacement[0, at] = EBX*w0 + EBY*w0 + ECX*w2 + ECY*w2 + EXX + EXY + x
        w3 = q_Px + rTx
        w4 = w3 + x
        w5 = -w0
        displacement[1, at] = EAX*w5 + EAY*w5 + EC0X*x + ECX*w3 + ECY*w4 + EYX + EYY + y
        displacement[2, at] = EAX*w1 + EAY*w1 - EBX*w3 - EBY*w4 + EZX + EZY
    return displacement


def motion_XZ(positions, errors, parameters, tool_point):
    """Motion equation of X and Z: displacement of the tool point since home, to first order.

    Source: Eqs. (7)-(11). Operations: 41 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (6,): home positions and location errors [mm, rad]
            rows: q_Px q_Py q_Pz EC0X EA0Z EB0Z
        tool_point (3, n): point in the tool frame [mm]
            rows: rTx rTy rTz

    Returns:
        displacement (3, n): tool point, displacement since home, in the bed frame [mm]
            rows: dx dy dz
    """
    n, positions, errors, tool_point = _points(positions=(positions, 3), errors=(errors, 18), tool_point=(tool_point, 3))
    parameters = _constant("parameters", parameters, (6,))
    displacement = np.zeros((3, n))
    # constants
    q_Px = float(parameters[0])
    q_Py = float(parameters[1])
    q_Pz = float(parameters[2])
    EC0X = float(parameters[3])
    EA0Z = float(parameters[4])
    EB0Z = float(parameters[5])
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
        w0 = q_Pz + rTz
        w1 = w0 + z
        w2 = q_Py + rTy
        w3 = -w2
        displacement[0, at] = EB0Z*z + EBX*w1 + EBZ*w0 + ECX*w3 + ECZ*w3 + EXX + EXZ + x
        w4 = q_Px + rTx
        displacement[1, at] = -EA0Z*z - EAX*w1 - EAZ*w0 + EC0X*x + ECX*w4 + ECZ*w4 + EYX + EYZ
        w5 = -w4
        displacement[2, at] = EAX*w2 + EAZ*w2 + EBX*w5 + EBZ*w5 + EZX + EZZ + z
    return displacement


def motion_YZ(positions, errors, parameters, tool_point):
    """Motion equation of Y and Z: displacement of the tool point since home, to first order.

    Source: Eqs. (7)-(11). Operations: 39 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (6,): home positions and location errors [mm, rad]
            rows: q_Px q_Py q_Pz EC0X EA0Z EB0Z
        tool_point (3, n): point in the tool frame [mm]
            rows: rTx rTy rTz

    Returns:
        displacement (3, n): tool point, displacement since home, in the bed frame [mm]
            rows: dx dy dz
    """
    n, positions, errors, tool_point = _points(positions=(positions, 3), errors=(errors, 18), tool_point=(tool_point, 3))
    parameters = _constant("parameters", parameters, (6,))
    displacement = np.zeros((3, n))
    # constants
    q_Px = float(parameters[0])
    q_Py = float(parameters[1])
    q_Pz = float(parameters[2])
    EA0Z = float(parameters[4])
    EB0Z = float(parameters[5])
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
        w0 = q_Pz + rTz
        w1 = w0 + z
        w2 = q_Py + rTy
        w3 = -w2
        displacement[0, at] = EB0Z*z + EBY*w1 + EBZ*w0 + ECY*w3 + ECZ*w3 + EXY + EXZ
        w4 = q_Px + rTx
        displacement[1, at] = -EA0Z*z - EAY*w1 - EAZ*w0 + ECY*w4 + ECZ*w4 + EYY + EYZ + y
        w5 = -w4
        displacement[2, at] = EAY*w2 + EAZ*w2 + EBY*w5 + EBZ*w5 + EZY + EZZ + z
    return displacement
