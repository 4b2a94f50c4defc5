# Generated from machines/cframe_mill.toml, do not edit; regenerate with: trueaxis derive machines/cframe_mill.toml
# SPDX-License-Identifier: MIT
"""Kernels of C-frame mill: geometric error model in NumPy.

Arrays are float64 with the quantity first and the point last: positions (n_axes, n), errors (n_components, n),
deviation (3, n). An array that is the same at all points may have n = 1. Lengths mm, angles rad.
An array of another shape is a ValueError that names it.

Equations after: Prediction and compensation of geometric error for translational axes in multi-axis machine tools
"""

import numpy as np

ABI = 3
SPEC_HASH = "e0bab1439083d465e60d898b33f648fd88b066b0d41217ad88014752dc9315ad"

META = {
    'machine': 'cframe_mill',
    'title': 'C-frame mill',
    'axes': ['X', 'Y', 'Z'],
    'position_units': ['mm', 'mm', 'mm'],
    'travel': {'X': [0.0, 600.0], 'Y': [0.0, 400.0], 'Z': [-500.0, 0.0]},
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
    'parameters': ['EC0X', 'EA0Z', 'EB0Z'],
    'parameter_units': ['rad', 'rad', 'rad'],
    'parameter_descriptions': [
        'location error: squareness error of X to Y, about Z; X slide on Y slide',
        'location error: squareness error of Z to Y, about X; Z slide on the bed',
        'location error: squareness error of Z to X, about Y; Z slide on the bed',
    ],
    'dimensions': [],
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
                {'name': 'parameters', 'shape': [3], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'ideal', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 3,
            'operations_per_call': 0,
        },
        'tool_in_workpiece_deviation': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [3], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 135,
            'operations_per_call': 3,
        },
        'tool_in_workpiece_deviation_first_order': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [3], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 57,
            'operations_per_call': 0,
        },
        'tool_in_workpiece_sensitivity': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'parameters', 'shape': [3], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'sensitivity', 'shape': [3, 21], 'per_point': True, 'unit': 'mm/mm, mm/rad'}],
            'operations': 15,
            'operations_per_call': 0,
        },
        'tool_in_bed_ideal': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'parameters', 'shape': [3], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'ideal', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 1,
            'operations_per_call': 0,
        },
        'tool_in_bed_deviation': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [3], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 24,
            'operations_per_call': 0,
        },
        'tool_in_bed_deviation_first_order': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [3], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 21,
            'operations_per_call': 0,
        },
        'tool_in_bed_sensitivity': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'parameters', 'shape': [3], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'sensitivity', 'shape': [3, 21], 'per_point': True, 'unit': 'mm/mm, mm/rad'}],
            'operations': 5,
            'operations_per_call': 0,
        },
        'workpiece_in_bed_ideal': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'parameters', 'shape': [3], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'ideal', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 2,
            'operations_per_call': 0,
        },
        'workpiece_in_bed_deviation': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [3], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 37,
            'operations_per_call': 0,
        },
        'workpiece_in_bed_deviation_first_order': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [3], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 32,
            'operations_per_call': 0,
        },
        'workpiece_in_bed_sensitivity': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'parameters', 'shape': [3], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'sensitivity', 'shape': [3, 21], 'per_point': True, 'unit': 'mm/mm, mm/rad'}],
            'operations': 5,
            'operations_per_call': 0,
        },
        'bed_in_workpiece_ideal': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'parameters', 'shape': [3], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'ideal', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 2,
            'operations_per_call': 0,
        },
        'bed_in_workpiece_deviation': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [3], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 108,
            'operations_per_call': 3,
        },
        'bed_in_workpiece_deviation_first_order': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [3], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 33,
            'operations_per_call': 0,
        },
        'bed_in_workpiece_sensitivity': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'parameters', 'shape': [3], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'sensitivity', 'shape': [3, 21], 'per_point': True, 'unit': 'mm/mm, mm/rad'}],
            'operations': 12,
            'operations_per_call': 0,
        },
        'tool_in_workpiece_position': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [3], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'position', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 138,
            'operations_per_call': 3,
        },
        'tool_in_workpiece_position_first_order': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [3], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'position', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 60,
            'operations_per_call': 0,
        },
        'tool_in_workpiece_deviation_curves': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'curves', 'shape': [18, 7], 'per_point': False, 'unit': 'mm/mm^k, rad/mm^k'},
                {'name': 'parameters', 'shape': [3], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': False, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 369,
            'operations_per_call': 3,
        },
        'tool_in_workpiece_deviation_first_order_curves': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'curves', 'shape': [18, 7], 'per_point': False, 'unit': 'mm/mm^k, rad/mm^k'},
                {'name': 'parameters', 'shape': [3], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': False, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 225,
            'operations_per_call': 262,
        },
        'ballbar_error': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [3], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'ball', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'length', 'shape': [1], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'error', 'shape': [4], 'per_point': True, 'unit': 'mm'}],
            'operations': 171,
            'operations_per_call': 3,
        },
        'correction': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'moves', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 2,
            'operations_per_call': 0,
        },
        'motion_X': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [3], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'workpiece_point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'displacement', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 15,
            'operations_per_call': 0,
        },
        'motion_Y': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [3], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'workpiece_point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'displacement', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 13,
            'operations_per_call': 0,
        },
        'motion_Z': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [3], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'tool_point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'displacement', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 17,
            'operations_per_call': 0,
        },
        'motion_XY': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [3], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'workpiece_point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'displacement', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 32,
            'operations_per_call': 0,
        },
        'motion_XZ': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [3], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'workpiece_point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'tool_point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'displacement', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 35,
            'operations_per_call': 0,
        },
        'motion_YZ': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [3], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'workpiece_point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'tool_point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'displacement', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 33,
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

    Source: Eqs. (1)-(4) without errors. Operations: 3 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        parameters (3,): home positions and location errors [mm, rad]
            rows: EC0X EA0Z EB0Z
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        ideal (3, n): tool point in the workpiece frame, without errors [mm]
            rows: px py pz
    """
    n, positions, point = _points(positions=(positions, 3), point=(point, 3))
    parameters = _constant("parameters", parameters, (3,))
    ideal = np.zeros((3, n))
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        x = positions[0, at]
        y = positions[1, at]
        z = positions[2, at]
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # per point
        ideal[0, at] = rx - x
        ideal[1, at] = ry - y
        ideal[2, at] = rz + z
    return ideal


def tool_in_workpiece_deviation(positions, errors, parameters, point):
    """Deviation of a tool point in the workpiece frame, exact.

    Source: Eqs. (1)-(4). Operations: 135 per point, 3 per call.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (3,): home positions and location errors [mm, rad]
            rows: EC0X EA0Z EB0Z
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): tool point in the workpiece frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions, errors, point = _points(positions=(positions, 3), errors=(errors, 18), point=(point, 3))
    parameters = _constant("parameters", parameters, (3,))
    deviation = np.zeros((3, n))
    # constants
    EC0X = float(parameters[0])
    EA0Z = float(parameters[1])
    EB0Z = float(parameters[2])
    # once per call
    w22 = (EC0X*EC0X)
    w23 = 1.0/(w22 + 1)
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
        w0 = rx - x
        w1 = EAZ*ry - EBZ*rx + EZZ
        w2 = rz + z
        w3 = w1 + w2
        w4 = EBZ*rz - ECZ*ry + EXZ
        w5 = EB0Z*w3 + w4
        w6 = -EXY + w5
        w7 = ry - y
        w8 = -EAZ*rz + ECZ*rx + EYZ
        w9 = -EA0Z*w3 + w8
        w10 = -EYY + w9
        w11 = w10 + w7
        w12 = EA0Z*(ry + w8) - EB0Z*(rx + w4) + w1
        w13 = -EZY + w12
        w14 = w13 + w2
        w15 = rx + w6
        w16 = EAY*w15 + EBY*w11 + ECY*w14
        w17 = (EAY*EAY) + (EBY*EBY) + (ECY*ECY)
        w18 = 1.0/(w17 + 1)
        w19 = w18*(EAY*w16 - EBY*w14 + ECY*w11 - rx*w17 + w6)
        w20 = w18*(EAY*w14 + EBY*w16 - ECY*w15 + w10 - w17*w7)
        w21 = w20 + w7
        w24 = w23*(EC0X*w21 - rx*w22 + w19)
        w25 = -EXX + w24
        w26 = rx + w19
        w27 = w23*(-EC0X*w26 + w20 - w22*w7)
        w28 = -EYX + w27
        w29 = w28 + w7
        w30 = w18*(-EAY*w11 + EBY*w15 + ECY*w16 + w13 - w17*w2)
        w31 = w2 + w30
        w32 = EC0X*w31
        w33 = w23*(EC0X*w32 - w2*w22 + w30)
        w34 = -EZX + w33
        w35 = w2 + w34
        w36 = w0 + w25
        w37 = EAX*w36 + EBX*w29 + ECX*w35
        w38 = (EAX*EAX) + (EBX*EBX) + (ECX*ECX)
        w39 = 1.0/(w38 + 1)
        deviation[0, at] = w39*(EAX*w37 - EBX*w35 + ECX*w29 - w0*w38 + w25)
        deviation[1, at] = w39*(EAX*w35 + EBX*w37 - ECX*w36 + w28 - w38*w7)
        deviation[2, at] = w39*(-EAX*w29 + EBX*w36 + ECX*w37 - w2*w38 + w34)
    return deviation


def tool_in_workpiece_deviation_first_order(positions, errors, parameters, point):
    """Deviation of a tool point in the workpiece frame, to first order in the errors.

    Source: Eqs. (1)-(4). Operations: 57 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (3,): home positions and location errors [mm, rad]
            rows: EC0X EA0Z EB0Z
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): tool point in the workpiece frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions, errors, point = _points(positions=(positions, 3), errors=(errors, 18), point=(point, 3))
    parameters = _constant("parameters", parameters, (3,))
    deviation = np.zeros((3, n))
    # constants
    EC0X = float(parameters[0])
    EA0Z = float(parameters[1])
    EB0Z = float(parameters[2])
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
        w0 = rz + z
        w1 = ry - y
        w2 = EBZ*rz - ECZ*ry + EXZ
        w3 = EB0Z*w0 + w2
        w4 = -EBY*w0 + ECY*w1 - EXY + w3
        w5 = EC0X*w1 + w4
        deviation[0, at] = -EBX*w0 + ECX*w1 - EXX + w5
        w6 = -EAZ*rz + ECZ*rx + EYZ
        w7 = -EA0Z*w0 + w6
        w8 = EAY*w0 - ECY*rx - EYY + w7
        w9 = -EC0X*rx + w8
        w10 = rx - x
        deviation[1, at] = EAX*w0 - ECX*w10 - EYX + w9
        w11 = EAZ*ry - EBZ*rx + EZZ
        w12 = EA0Z*ry - EB0Z*rx + w11
        w13 = -EAY*w1 + EBY*rx - EZY + w12
        deviation[2, at] = -EAX*w1 + EBX*w10 - EZX + w13
    return deviation


def tool_in_workpiece_sensitivity(positions, parameters, point):
    """Sensitivity of a tool point in the workpiece frame to every error, at the error-free machine.

    Source: Eqs. (1)-(4), first order. Operations: 15 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        parameters (3,): home positions and location errors [mm, rad]
            rows: EC0X EA0Z EB0Z
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        sensitivity (3, 21, n): derivative of the deviation by each component error, then by each location error [mm/mm, mm/rad]
            rows: dx_EXX dx_EYX .. dz_EB0Z, last index fastest
    """
    n, positions, point = _points(positions=(positions, 3), point=(point, 3))
    parameters = _constant("parameters", parameters, (3,))
    sensitivity = np.zeros((63, n))
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        x = positions[0, at]
        y = positions[1, at]
        z = positions[2, at]
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # per point
        sensitivity[20, at] = dx_EB0Z = rz + z
        sensitivity[4, at] = dx_EBX = -dx_EB0Z
        sensitivity[5, at] = dx_ECX = ry - y
        sensitivity[46, at] = dz_EBX = rx - x
        sensitivity[32, at] = dy_ECY = -rx
        sensitivity[45, at] = dz_EAX = -dx_ECX
        sensitivity[0, at] = -1.0
        sensitivity[6, at] = -1.0
        sensitivity[10, at] = dx_EBX
        sensitivity[11, at] = dx_ECX
        sensitivity[12, at] = 1.0
        sensitivity[16, at] = rz
        sensitivity[17, at] = -ry
        sensitivity[18, at] = dx_ECX
        sensitivity[22, at] = -1.0
        sensitivity[24, at] = dx_EB0Z
        sensitivity[26, at] = -dz_EBX
        sensitivity[28, at] = -1.0
        sensitivity[30, at] = dx_EB0Z
        sensitivity[34, at] = 1.0
        sensitivity[36, at] = -rz
        sensitivity[38, at] = rx
        sensitivity[39, at] = dy_ECY
        sensitivity[40, at] = dx_EBX
        sensitivity[44, at] = -1.0
        sensitivity[50, at] = -1.0
        sensitivity[51, at] = dz_EAX
        sensitivity[52, at] = rx
        sensitivity[56, at] = 1.0
        sensitivity[57, at] = ry
        sensitivity[58, at] = dy_ECY
        sensitivity[61, at] = ry
        sensitivity[62, at] = dy_ECY
    return sensitivity.reshape(3, 21, n)


def tool_in_bed_ideal(positions, parameters, point):
    """Ideal position of a tool point in the bed frame.

    Source: Eqs. (1)-(4) without errors. Operations: 1 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        parameters (3,): home positions and location errors [mm, rad]
            rows: EC0X EA0Z EB0Z
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        ideal (3, n): tool point in the bed frame, without errors [mm]
            rows: px py pz
    """
    n, positions, point = _points(positions=(positions, 3), point=(point, 3))
    parameters = _constant("parameters", parameters, (3,))
    ideal = np.zeros((3, n))
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        z = positions[2, at]
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # per point
        ideal[0, at] = rx
        ideal[1, at] = ry
        ideal[2, at] = rz + z
    return ideal


def tool_in_bed_deviation(positions, errors, parameters, point):
    """Deviation of a tool point in the bed frame, exact.

    Source: Eqs. (1)-(4). Operations: 24 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (3,): home positions and location errors [mm, rad]
            rows: EC0X EA0Z EB0Z
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): tool point in the bed frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions, errors, point = _points(positions=(positions, 3), errors=(errors, 18), point=(point, 3))
    parameters = _constant("parameters", parameters, (3,))
    deviation = np.zeros((3, n))
    # constants
    EA0Z = float(parameters[1])
    EB0Z = float(parameters[2])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        z = positions[2, at]
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
        w0 = EAZ*ry - EBZ*rx + EZZ
        w1 = rz + z
        w2 = w0 + w1
        w3 = EBZ*rz - ECZ*ry + EXZ
        deviation[0, at] = EB0Z*w2 + w3
        w4 = -EAZ*rz + ECZ*rx + EYZ
        deviation[1, at] = -EA0Z*w2 + w4
        deviation[2, at] = EA0Z*(ry + w4) - EB0Z*(rx + w3) + w0
    return deviation


def tool_in_bed_deviation_first_order(positions, errors, parameters, point):
    """Deviation of a tool point in the bed frame, to first order in the errors.

    Source: Eqs. (1)-(4). Operations: 21 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (3,): home positions and location errors [mm, rad]
            rows: EC0X EA0Z EB0Z
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): tool point in the bed frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions, errors, point = _points(positions=(positions, 3), errors=(errors, 18), point=(point, 3))
    parameters = _constant("parameters", parameters, (3,))
    deviation = np.zeros((3, n))
    # constants
    EA0Z = float(parameters[1])
    EB0Z = float(parameters[2])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        z = positions[2, at]
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
        w0 = EBZ*rz - ECZ*ry + EXZ
        w1 = rz + z
        deviation[0, at] = EB0Z*w1 + w0
        w2 = -EAZ*rz + ECZ*rx + EYZ
        deviation[1, at] = -EA0Z*w1 + w2
        w3 = EAZ*ry - EBZ*rx + EZZ
        deviation[2, at] = EA0Z*ry - EB0Z*rx + w3
    return deviation


def tool_in_bed_sensitivity(positions, parameters, point):
    """Sensitivity of a tool point in the bed frame to every error, at the error-free machine.

    Source: Eqs. (1)-(4), first order. Operations: 5 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        parameters (3,): home positions and location errors [mm, rad]
            rows: EC0X EA0Z EB0Z
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        sensitivity (3, 21, n): derivative of the deviation by each component error, then by each location error [mm/mm, mm/rad]
            rows: dx_EXX dx_EYX .. dz_EB0Z, last index fastest
    """
    n, positions, point = _points(positions=(positions, 3), point=(point, 3))
    parameters = _constant("parameters", parameters, (3,))
    sensitivity = np.zeros((63, n))
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        z = positions[2, at]
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # per point
        sensitivity[20, at] = dx_EB0Z = rz + z
        sensitivity[58, at] = dz_EBZ = -rx
        sensitivity[12, at] = 1.0
        sensitivity[16, at] = rz
        sensitivity[17, at] = -ry
        sensitivity[34, at] = 1.0
        sensitivity[36, at] = -rz
        sensitivity[38, at] = rx
        sensitivity[40, at] = -dx_EB0Z
        sensitivity[56, at] = 1.0
        sensitivity[57, at] = ry
        sensitivity[61, at] = ry
        sensitivity[62, at] = dz_EBZ
    return sensitivity.reshape(3, 21, n)


def workpiece_in_bed_ideal(positions, parameters, point):
    """Ideal position of a workpiece point in the bed frame.

    Source: Eqs. (1)-(4) without errors. Operations: 2 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        parameters (3,): home positions and location errors [mm, rad]
            rows: EC0X EA0Z EB0Z
        point (3, n): point in the workpiece frame [mm]
            rows: rx ry rz

    Returns:
        ideal (3, n): workpiece point in the bed frame, without errors [mm]
            rows: px py pz
    """
    n, positions, point = _points(positions=(positions, 3), point=(point, 3))
    parameters = _constant("parameters", parameters, (3,))
    ideal = np.zeros((3, n))
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        x = positions[0, at]
        y = positions[1, at]
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # per point
        ideal[0, at] = rx + x
        ideal[1, at] = ry + y
        ideal[2, at] = rz
    return ideal


def workpiece_in_bed_deviation(positions, errors, parameters, point):
    """Deviation of a workpiece point in the bed frame, exact.

    Source: Eqs. (1)-(4). Operations: 37 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (3,): home positions and location errors [mm, rad]
            rows: EC0X EA0Z EB0Z
        point (3, n): point in the workpiece frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): workpiece point in the bed frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions, errors, point = _points(positions=(positions, 3), errors=(errors, 18), point=(point, 3))
    parameters = _constant("parameters", parameters, (3,))
    deviation = np.zeros((3, n))
    # constants
    EC0X = float(parameters[0])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        x = positions[0, at]
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
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # per point
        w0 = EAX*ry - EBX*rx + EZX
        w1 = rz + w0
        w2 = EBX*rz - ECX*ry + EXX
        w3 = -EAX*rz + ECX*rx + EYX
        w4 = rx + x
        w5 = EC0X*(w2 + w4) + w3
        w6 = ry + w5
        w7 = -EC0X*(ry + w3) + w2
        deviation[0, at] = EBY*w1 - ECY*w6 + EXY + w7
        w8 = w4 + w7
        deviation[1, at] = -EAY*w1 + ECY*w8 + EYY + w5
        deviation[2, at] = EAY*w6 - EBY*w8 + EZY + w0
    return deviation


def workpiece_in_bed_deviation_first_order(positions, errors, parameters, point):
    """Deviation of a workpiece point in the bed frame, to first order in the errors.

    Source: Eqs. (1)-(4). Operations: 32 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (3,): home positions and location errors [mm, rad]
            rows: EC0X EA0Z EB0Z
        point (3, n): point in the workpiece frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): workpiece point in the bed frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions, errors, point = _points(positions=(positions, 3), errors=(errors, 18), point=(point, 3))
    parameters = _constant("parameters", parameters, (3,))
    deviation = np.zeros((3, n))
    # constants
    EC0X = float(parameters[0])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        x = positions[0, at]
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
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # per point
        w0 = EBX*rz - ECX*ry + EXX
        w1 = -EC0X*ry + w0
        deviation[0, at] = EBY*rz - ECY*ry + EXY + w1
        w2 = rx + x
        w3 = -EAX*rz + ECX*rx + EYX
        w4 = EC0X*w2 + w3
        deviation[1, at] = -EAY*rz + ECY*w2 + EYY + w4
        w5 = EAX*ry - EBX*rx + EZX
        deviation[2, at] = EAY*ry - EBY*w2 + EZY + w5
    return deviation


def workpiece_in_bed_sensitivity(positions, parameters, point):
    """Sensitivity of a workpiece point in the bed frame to every error, at the error-free machine.

    Source: Eqs. (1)-(4), first order. Operations: 5 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        parameters (3,): home positions and location errors [mm, rad]
            rows: EC0X EA0Z EB0Z
        point (3, n): point in the workpiece frame [mm]
            rows: rx ry rz

    Returns:
        sensitivity (3, 21, n): derivative of the deviation by each component error, then by each location error [mm/mm, mm/rad]
            rows: dx_EXX dx_EYX .. dz_EB0Z, last index fastest
    """
    n, positions, point = _points(positions=(positions, 3), point=(point, 3))
    parameters = _constant("parameters", parameters, (3,))
    sensitivity = np.zeros((63, n))
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        x = positions[0, at]
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # per point
        sensitivity[5, at] = dx_ECX = -ry
        sensitivity[24, at] = dy_EAX = -rz
        sensitivity[32, at] = dy_ECY = rx + x
        sensitivity[0, at] = 1.0
        sensitivity[4, at] = rz
        sensitivity[6, at] = 1.0
        sensitivity[10, at] = rz
        sensitivity[11, at] = dx_ECX
        sensitivity[18, at] = dx_ECX
        sensitivity[22, at] = 1.0
        sensitivity[26, at] = rx
        sensitivity[28, at] = 1.0
        sensitivity[30, at] = dy_EAX
        sensitivity[39, at] = dy_ECY
        sensitivity[44, at] = 1.0
        sensitivity[45, at] = ry
        sensitivity[46, at] = -rx
        sensitivity[50, at] = 1.0
        sensitivity[51, at] = ry
        sensitivity[52, at] = -dy_ECY
    return sensitivity.reshape(3, 21, n)


def bed_in_workpiece_ideal(positions, parameters, point):
    """Ideal position of a bed point in the workpiece frame.

    Source: Eqs. (1)-(4) without errors. Operations: 2 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        parameters (3,): home positions and location errors [mm, rad]
            rows: EC0X EA0Z EB0Z
        point (3, n): point in the bed frame [mm]
            rows: rx ry rz

    Returns:
        ideal (3, n): bed point in the workpiece frame, without errors [mm]
            rows: px py pz
    """
    n, positions, point = _points(positions=(positions, 3), point=(point, 3))
    parameters = _constant("parameters", parameters, (3,))
    ideal = np.zeros((3, n))
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        x = positions[0, at]
        y = positions[1, at]
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # per point
        ideal[0, at] = rx - x
        ideal[1, at] = ry - y
        ideal[2, at] = rz
    return ideal


def bed_in_workpiece_deviation(positions, errors, parameters, point):
    """Deviation of a bed point in the workpiece frame, exact.

    Source: Eqs. (1)-(4). Operations: 108 per point, 3 per call.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (3,): home positions and location errors [mm, rad]
            rows: EC0X EA0Z EB0Z
        point (3, n): point in the bed frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): bed point in the workpiece frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions, errors, point = _points(positions=(positions, 3), errors=(errors, 18), point=(point, 3))
    parameters = _constant("parameters", parameters, (3,))
    deviation = np.zeros((3, n))
    # constants
    EC0X = float(parameters[0])
    # once per call
    w11 = (EC0X*EC0X)
    w12 = 1.0/(w11 + 1)
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
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # per point
        w0 = rx - x
        w1 = ry - y
        w2 = -EYY + w1
        w3 = -EZY + rz
        w4 = -EXY + rx
        w5 = EAY*w4 + EBY*w2 + ECY*w3
        w6 = (EAY*EAY) + (EBY*EBY) + (ECY*ECY)
        w7 = 1.0/(w6 + 1)
        w8 = w7*(EAY*w5 - EBY*w3 + ECY*w2 - EXY - rx*w6)
        w9 = w7*(EAY*w3 + EBY*w5 - ECY*w4 - EYY - w1*w6)
        w10 = w1 + w9
        w13 = w12*(EC0X*w10 - rx*w11 + w8)
        w14 = -EXX + w13
        w15 = rx + w8
        w16 = w12*(-EC0X*w15 - w1*w11 + w9)
        w17 = -EYX + w16
        w18 = w1 + w17
        w19 = w7*(-EAY*w2 + EBY*w4 + ECY*w5 - EZY - rz*w6)
        w20 = rz + w19
        w21 = EC0X*w20
        w22 = w12*(EC0X*w21 - rz*w11 + w19)
        w23 = -EZX + w22
        w24 = rz + w23
        w25 = w0 + w14
        w26 = EAX*w25 + EBX*w18 + ECX*w24
        w27 = (EAX*EAX) + (EBX*EBX) + (ECX*ECX)
        w28 = 1.0/(w27 + 1)
        deviation[0, at] = w28*(EAX*w26 - EBX*w24 + ECX*w18 - w0*w27 + w14)
        deviation[1, at] = w28*(EAX*w24 + EBX*w26 - ECX*w25 - w1*w27 + w17)
        deviation[2, at] = w28*(-EAX*w18 + EBX*w25 + ECX*w26 - rz*w27 + w23)
    return deviation


def bed_in_workpiece_deviation_first_order(positions, errors, parameters, point):
    """Deviation of a bed point in the workpiece frame, to first order in the errors.

    Source: Eqs. (1)-(4). Operations: 33 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (3,): home positions and location errors [mm, rad]
            rows: EC0X EA0Z EB0Z
        point (3, n): point in the bed frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): bed point in the workpiece frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions, errors, point = _points(positions=(positions, 3), errors=(errors, 18), point=(point, 3))
    parameters = _constant("parameters", parameters, (3,))
    deviation = np.zeros((3, n))
    # constants
    EC0X = float(parameters[0])
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
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # per point
        w0 = ry - y
        w1 = -EBY*rz + ECY*w0 - EXY
        w2 = EC0X*w0 + w1
        deviation[0, at] = -EBX*rz + ECX*w0 - EXX + w2
        w3 = EAY*rz - ECY*rx - EYY
        w4 = -EC0X*rx + w3
        w5 = rx - x
        deviation[1, at] = EAX*rz - ECX*w5 - EYX + w4
        w6 = -EAY*w0 + EBY*rx - EZY
        deviation[2, at] = -EAX*w0 + EBX*w5 - EZX + w6
    return deviation


def bed_in_workpiece_sensitivity(positions, parameters, point):
    """Sensitivity of a bed point in the workpiece frame to every error, at the error-free machine.

    Source: Eqs. (1)-(4), first order. Operations: 12 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        parameters (3,): home positions and location errors [mm, rad]
            rows: EC0X EA0Z EB0Z
        point (3, n): point in the bed frame [mm]
            rows: rx ry rz

    Returns:
        sensitivity (3, 21, n): derivative of the deviation by each component error, then by each location error [mm/mm, mm/rad]
            rows: dx_EXX dx_EYX .. dz_EB0Z, last index fastest
    """
    n, positions, point = _points(positions=(positions, 3), point=(point, 3))
    parameters = _constant("parameters", parameters, (3,))
    sensitivity = np.zeros((63, n))
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        x = positions[0, at]
        y = positions[1, at]
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # per point
        sensitivity[4, at] = dx_EBX = -rz
        sensitivity[5, at] = dx_ECX = ry - y
        sensitivity[46, at] = dz_EBX = rx - x
        sensitivity[32, at] = dy_ECY = -rx
        sensitivity[45, at] = dz_EAX = -dx_ECX
        sensitivity[0, at] = -1.0
        sensitivity[6, at] = -1.0
        sensitivity[10, at] = dx_EBX
        sensitivity[11, at] = dx_ECX
        sensitivity[18, at] = dx_ECX
        sensitivity[22, at] = -1.0
        sensitivity[24, at] = rz
        sensitivity[26, at] = -dz_EBX
        sensitivity[28, at] = -1.0
        sensitivity[30, at] = rz
        sensitivity[39, at] = dy_ECY
        sensitivity[44, at] = -1.0
        sensitivity[50, at] = -1.0
        sensitivity[51, at] = dz_EAX
        sensitivity[52, at] = rx
    return sensitivity.reshape(3, 21, n)


def tool_in_workpiece_position(positions, errors, parameters, point):
    """Actual position of the tool point in the workpiece frame, exact.

    Source: Eq. (4). Operations: 138 per point, 3 per call.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (3,): home positions and location errors [mm, rad]
            rows: EC0X EA0Z EB0Z
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        position (3, n): actual position P_T^W of the tool point in the workpiece frame [mm]
            rows: px py pz
    """
    n, positions, errors, point = _points(positions=(positions, 3), errors=(errors, 18), point=(point, 3))
    parameters = _constant("parameters", parameters, (3,))
    position = np.zeros((3, n))
    # constants
    EC0X = float(parameters[0])
    EA0Z = float(parameters[1])
    EB0Z = float(parameters[2])
    # once per call
    w22 = (EC0X*EC0X)
    w23 = 1.0/(w22 + 1)
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
        w0 = rx - x
        w1 = EAZ*ry - EBZ*rx + EZZ
        w2 = rz + z
        w3 = w1 + w2
        w4 = EBZ*rz - ECZ*ry + EXZ
        w5 = EB0Z*w3 + w4
        w6 = -EXY + w5
        w7 = ry - y
        w8 = -EAZ*rz + ECZ*rx + EYZ
        w9 = -EA0Z*w3 + w8
        w10 = -EYY + w9
        w11 = w10 + w7
        w12 = EA0Z*(ry + w8) - EB0Z*(rx + w4) + w1
        w13 = -EZY + w12
        w14 = w13 + w2
        w15 = rx + w6
        w16 = EAY*w15 + EBY*w11 + ECY*w14
        w17 = (EAY*EAY) + (EBY*EBY) + (ECY*ECY)
        w18 = 1.0/(w17 + 1)
        w19 = w18*(EAY*w16 - EBY*w14 + ECY*w11 - rx*w17 + w6)
        w20 = w18*(EAY*w14 + EBY*w16 - ECY*w15 + w10 - w17*w7)
        w21 = w20 + w7
        w24 = w23*(EC0X*w21 - rx*w22 + w19)
        w25 = -EXX + w24
        w26 = rx + w19
        w27 = w23*(-EC0X*w26 + w20 - w22*w7)
        w28 = -EYX + w27
        w29 = w28 + w7
        w30 = w18*(-EAY*w11 + EBY*w15 + ECY*w16 + w13 - w17*w2)
        w31 = w2 + w30
        w32 = EC0X*w31
        w33 = w23*(EC0X*w32 - w2*w22 + w30)
        w34 = -EZX + w33
        w35 = w2 + w34
        w36 = w0 + w25
        w37 = EAX*w36 + EBX*w29 + ECX*w35
        w38 = (EAX*EAX) + (EBX*EBX) + (ECX*ECX)
        w39 = 1.0/(w38 + 1)
        w40 = w39*(EAX*w37 - EBX*w35 + ECX*w29 - w0*w38 + w25)
        position[0, at] = w0 + w40
        w41 = w39*(EAX*w35 + EBX*w37 - ECX*w36 + w28 - w38*w7)
        position[1, at] = w41 + w7
        w42 = w39*(-EAX*w29 + EBX*w36 + ECX*w37 - w2*w38 + w34)
        position[2, at] = w2 + w42
    return position


def tool_in_workpiece_position_first_order(positions, errors, parameters, point):
    """Actual position of the tool point in the workpiece frame, to first order.

    Source: Eq. (4). Operations: 60 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (3,): home positions and location errors [mm, rad]
            rows: EC0X EA0Z EB0Z
        point (3, n): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        position (3, n): actual position P_T^W of the tool point in the workpiece frame [mm]
            rows: px py pz
    """
    n, positions, errors, point = _points(positions=(positions, 3), errors=(errors, 18), point=(point, 3))
    parameters = _constant("parameters", parameters, (3,))
    position = np.zeros((3, n))
    # constants
    EC0X = float(parameters[0])
    EA0Z = float(parameters[1])
    EB0Z = float(parameters[2])
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
        w0 = rx - x
        w1 = rz + z
        w2 = ry - y
        w3 = EBZ*rz - ECZ*ry + EXZ
        w4 = EB0Z*w1 + w3
        w5 = -EBY*w1 + ECY*w2 - EXY + w4
        w6 = EC0X*w2 + w5
        w7 = -EBX*w1 + ECX*w2 - EXX + w6
        position[0, at] = w0 + w7
        w8 = -EAZ*rz + ECZ*rx + EYZ
        w9 = -EA0Z*w1 + w8
        w10 = EAY*w1 - ECY*rx - EYY + w9
        w11 = -EC0X*rx + w10
        w12 = EAX*w1 - ECX*w0 - EYX + w11
        position[1, at] = w12 + w2
        w13 = EAZ*ry - EBZ*rx + EZZ
        w14 = EA0Z*ry - EB0Z*rx + w13
        w15 = -EAY*w2 + EBY*rx - EZY + w14
        w16 = -EAX*w2 + EBX*w0 - EZX + w15
        position[2, at] = w1 + w16
    return position


def tool_in_workpiece_deviation_curves(positions, curves, parameters, point):
    """Deviation of the tool point under polynomial error curves, exact.

    Source: Eqs. (1)-(4), (44). Operations: 369 per point, 3 per call.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        curves (18, 7): coefficients of the powers 1 to 7 of the axis position, per component error [mm/mm^k, rad/mm^k]
            rows: EXX_1 EXX_2 .. ECZ_7, last index fastest
        parameters (3,): home positions and location errors [mm, rad]
            rows: EC0X EA0Z EB0Z
        point (3,): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): tool point in the workpiece frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions = _points(positions=(positions, 3))
    curves = _constant("curves", curves, (18, 7))
    parameters = _constant("parameters", parameters, (3,))
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
    EC0X = float(parameters[0])
    EA0Z = float(parameters[1])
    EB0Z = float(parameters[2])
    rx = float(point[0])
    ry = float(point[1])
    rz = float(point[2])
    # once per call
    w38 = (EC0X*EC0X)
    w39 = 1.0/(w38 + 1)
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        x = positions[0, at]
        y = positions[1, at]
        z = positions[2, at]
        # per point
        w0 = _polynomial(x, EAX_1, EAX_2, EAX_3, EAX_4, EAX_5, EAX_6, EAX_7)
        w1 = _polynomial(x, EBX_1, EBX_2, EBX_3, EBX_4, EBX_5, EBX_6, EBX_7)
        w2 = _polynomial(x, ECX_1, ECX_2, ECX_3, ECX_4, ECX_5, ECX_6, ECX_7)
        w3 = rx - x
        w4 = _polynomial(x, EXX_1, EXX_2, EXX_3, EXX_4, EXX_5, EXX_6, EXX_7)
        w5 = _polynomial(y, EAY_1, EAY_2, EAY_3, EAY_4, EAY_5, EAY_6, EAY_7)
        w6 = _polynomial(y, EBY_1, EBY_2, EBY_3, EBY_4, EBY_5, EBY_6, EBY_7)
        w7 = _polynomial(y, ECY_1, ECY_2, ECY_3, ECY_4, ECY_5, ECY_6, ECY_7)
        w8 = _polynomial(y, EXY_1, EXY_2, EXY_3, EXY_4, EXY_5, EXY_6, EXY_7)
        w9 = _polynomial(z, EZZ_1, EZZ_2, EZZ_3, EZZ_4, EZZ_5, EZZ_6, EZZ_7)
        w10 = _polynomial(z, EAZ_1, EAZ_2, EAZ_3, EAZ_4, EAZ_5, EAZ_6, EAZ_7)
        w11 = _polynomial(z, EBZ_1, EBZ_2, EBZ_3, EBZ_4, EBZ_5, EBZ_6, EBZ_7)
        w12 = -rx*w11 + ry*w10 + w9
        w13 = rz + z
        w14 = w12 + w13
        w15 = _polynomial(z, EXZ_1, EXZ_2, EXZ_3, EXZ_4, EXZ_5, EXZ_6, EXZ_7)
        w16 = _polynomial(z, ECZ_1, ECZ_2, ECZ_3, ECZ_4, ECZ_5, ECZ_6, ECZ_7)
        w17 = -ry*w16 + rz*w11 + w15
        w18 = EB0Z*w14 + w17
        w19 = w18 - w8
        w20 = ry - y
        w21 = _polynomial(y, EYY_1, EYY_2, EYY_3, EYY_4, EYY_5, EYY_6, EYY_7)
        w22 = _polynomial(z, EYZ_1, EYZ_2, EYZ_3, EYZ_4, EYZ_5, EYZ_6, EYZ_7)
        w23 = rx*w16 - rz*w10 + w22
        w24 = -EA0Z*w14 + w23
        w25 = -w21 + w24
        w26 = w20 + w25
        w27 = _polynomial(y, EZY_1, EZY_2, EZY_3, EZY_4, EZY_5, EZY_6, EZY_7)
        w28 = EA0Z*(ry + w23) - EB0Z*(rx + w17) + w12
        w29 = -w27 + w28
        w30 = w13 + w29
        w31 = rx + w19
        w32 = w26*w6 + w30*w7 + w31*w5
        w33 = (w5*w5) + (w6*w6) + (w7*w7)
        w34 = 1.0/(w33 + 1)
        w35 = w34*(-rx*w33 + w19 + w26*w7 - w30*w6 + w32*w5)
        w36 = w34*(-w20*w33 + w25 + w30*w5 - w31*w7 + w32*w6)
        w37 = w20 + w36
        w40 = w39*(EC0X*w37 - rx*w38 + w35)
        w41 = -w4 + w40
        w42 = _polynomial(x, EYX_1, EYX_2, EYX_3, EYX_4, EYX_5, EYX_6, EYX_7)
        w43 = rx + w35
        w44 = w39*(-EC0X*w43 - w20*w38 + w36)
        w45 = -w42 + w44
        w46 = w20 + w45
        w47 = _polynomial(x, EZX_1, EZX_2, EZX_3, EZX_4, EZX_5, EZX_6, EZX_7)
        w48 = w34*(-w13*w33 - w26*w5 + w29 + w31*w6 + w32*w7)
        w49 = w13 + w48
        w50 = EC0X*w49
        w51 = w39*(EC0X*w50 - w13*w38 + w48)
        w52 = -w47 + w51
        w53 = w13 + w52
        w54 = w3 + w41
        w55 = w0*w54 + w1*w46 + w2*w53
        w56 = (w0*w0) + (w1*w1) + (w2*w2)
        w57 = 1.0/(w56 + 1)
        deviation[0, at] = w57*(w0*w55 - w1*w53 + w2*w46 - w3*w56 + w41)
        deviation[1, at] = w57*(w0*w53 + w1*w55 - w2*w54 - w20*w56 + w45)
        deviation[2, at] = w57*(-w0*w46 + w1*w54 - w13*w56 + w2*w55 + w52)
    return deviation


def tool_in_workpiece_deviation_first_order_curves(positions, curves, parameters, point):
    """Deviation of the tool point under polynomial error curves, to first order, constants folded once per call.

    Source: Eqs. (1)-(4), (44). Operations: 225 per point, 262 per call.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        curves (18, 7): coefficients of the powers 1 to 7 of the axis position, per component error [mm/mm^k, rad/mm^k]
            rows: EXX_1 EXX_2 .. ECZ_7, last index fastest
        parameters (3,): home positions and location errors [mm, rad]
            rows: EC0X EA0Z EB0Z
        point (3,): point in the tool frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): tool point in the workpiece frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions = _points(positions=(positions, 3))
    curves = _constant("curves", curves, (18, 7))
    parameters = _constant("parameters", parameters, (3,))
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
    EC0X = float(parameters[0])
    EA0Z = float(parameters[1])
    EB0Z = float(parameters[2])
    rx = float(point[0])
    ry = float(point[1])
    rz = float(point[2])
    # once per call
    w0 = EBZ_1*rz - ECZ_1*ry + EXZ_1
    w1 = EBZ_2*rz - ECZ_2*ry + EXZ_2
    w2 = EBZ_3*rz - ECZ_3*ry + EXZ_3
    w3 = EBZ_4*rz - ECZ_4*ry + EXZ_4
    w4 = EBZ_5*rz - ECZ_5*ry + EXZ_5
    w5 = EBZ_6*rz - ECZ_6*ry + EXZ_6
    w6 = EBZ_7*rz - ECZ_7*ry + EXZ_7
    w8 = EB0Z*rz + EC0X*ry
    w9 = -EBY_1*rz + ECY_1*ry - EXY_1
    w10 = -EBY_2*rz + ECY_2*ry - EXY_2
    w11 = -EBY_3*rz + ECY_3*ry - EXY_3
    w12 = -EBY_4*rz + ECY_4*ry - EXY_4
    w13 = -EBY_5*rz + ECY_5*ry - EXY_5
    w14 = -EBY_6*rz + ECY_6*ry - EXY_6
    w15 = -EBY_7*rz + ECY_7*ry - EXY_7
    w17 = -EBX_1*rz + ECX_1*ry - EXX_1
    w18 = -EBX_2*rz + ECX_2*ry - EXX_2
    w19 = -EBX_3*rz + ECX_3*ry - EXX_3
    w20 = -EBX_4*rz + ECX_4*ry - EXX_4
    w21 = -EBX_5*rz + ECX_5*ry - EXX_5
    w22 = -EBX_6*rz + ECX_6*ry - EXX_6
    w23 = -EBX_7*rz + ECX_7*ry - EXX_7
    w36 = -EAZ_1*rz + ECZ_1*rx + EYZ_1
    w37 = -EAZ_2*rz + ECZ_2*rx + EYZ_2
    w38 = -EAZ_3*rz + ECZ_3*rx + EYZ_3
    w39 = -EAZ_4*rz + ECZ_4*rx + EYZ_4
    w40 = -EAZ_5*rz + ECZ_5*rx + EYZ_5
    w41 = -EAZ_6*rz + ECZ_6*rx + EYZ_6
    w42 = -EAZ_7*rz + ECZ_7*rx + EYZ_7
    w44 = -EA0Z*rz - EC0X*rx
    w45 = EAY_1*rz - ECY_1*rx - EYY_1
    w46 = EAY_2*rz - ECY_2*rx - EYY_2
    w47 = EAY_3*rz - ECY_3*rx - EYY_3
    w48 = EAY_4*rz - ECY_4*rx - EYY_4
    w49 = EAY_5*rz - ECY_5*rx - EYY_5
    w50 = EAY_6*rz - ECY_6*rx - EYY_6
    w51 = EAY_7*rz - ECY_7*rx - EYY_7
    w53 = EAX_1*rz - ECX_1*rx - EYX_1
    w54 = EAX_2*rz - ECX_2*rx - EYX_2
    w55 = EAX_3*rz - ECX_3*rx - EYX_3
    w56 = EAX_4*rz - ECX_4*rx - EYX_4
    w57 = EAX_5*rz - ECX_5*rx - EYX_5
    w58 = EAX_6*rz - ECX_6*rx - EYX_6
    w59 = EAX_7*rz - ECX_7*rx - EYX_7
    w70 = EAZ_1*ry - EBZ_1*rx + EZZ_1
    w71 = EAZ_2*ry - EBZ_2*rx + EZZ_2
    w72 = EAZ_3*ry - EBZ_3*rx + EZZ_3
    w73 = EAZ_4*ry - EBZ_4*rx + EZZ_4
    w74 = EAZ_5*ry - EBZ_5*rx + EZZ_5
    w75 = EAZ_6*ry - EBZ_6*rx + EZZ_6
    w76 = EAZ_7*ry - EBZ_7*rx + EZZ_7
    w78 = EA0Z*ry - EB0Z*rx
    w79 = -EAY_1*ry + EBY_1*rx - EZY_1
    w80 = -EAY_2*ry + EBY_2*rx - EZY_2
    w81 = -EAY_3*ry + EBY_3*rx - EZY_3
    w82 = -EAY_4*ry + EBY_4*rx - EZY_4
    w83 = -EAY_5*ry + EBY_5*rx - EZY_5
    w84 = -EAY_6*ry + EBY_6*rx - EZY_6
    w85 = -EAY_7*ry + EBY_7*rx - EZY_7
    w87 = -EAX_1*ry + EBX_1*rx - EZX_1
    w88 = -EAX_2*ry + EBX_2*rx - EZX_2
    w89 = -EAX_3*ry + EBX_3*rx - EZX_3
    w90 = -EAX_4*ry + EBX_4*rx - EZX_4
    w91 = -EAX_5*ry + EBX_5*rx - EZX_5
    w92 = -EAX_6*ry + EBX_6*rx - EZX_6
    w93 = -EAX_7*ry + EBX_7*rx - EZX_7
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        x = positions[0, at]
        y = positions[1, at]
        z = positions[2, at]
        # per point
        w7 = _polynomial(z, w0, w1, w2, w3, w4, w5, w6)
        w16 = _polynomial(y, w9, w10, w11, w12, w13, w14, w15)
        w24 = _polynomial(x, w17, w18, w19, w20, w21, w22, w23)
        w25 = w16 + w24 + w7 + w8
        w26 = _polynomial(y, EBY_1, EBY_2, EBY_3, EBY_4, EBY_5, EBY_6, EBY_7)
        w27 = _polynomial(x, EBX_1, EBX_2, EBX_3, EBX_4, EBX_5, EBX_6, EBX_7)
        w28 = w27
        w29 = EB0Z - w26 - w28
        w30 = w29*z
        w31 = _polynomial(y, ECY_1, ECY_2, ECY_3, ECY_4, ECY_5, ECY_6, ECY_7)
        w32 = _polynomial(x, ECX_1, ECX_2, ECX_3, ECX_4, ECX_5, ECX_6, ECX_7)
        w33 = w32
        w34 = -EC0X - w31 - w33
        w35 = w34*y
        deviation[0, at] = w25 + w30 + w35
        w43 = _polynomial(z, w36, w37, w38, w39, w40, w41, w42)
        w52 = _polynomial(y, w45, w46, w47, w48, w49, w50, w51)
        w60 = _polynomial(x, w53, w54, w55, w56, w57, w58, w59)
        w61 = w43 + w44 + w52 + w60
        w62 = _polynomial(y, EAY_1, EAY_2, EAY_3, EAY_4, EAY_5, EAY_6, EAY_7)
        w63 = w62
        w64 = _polynomial(x, EAX_1, EAX_2, EAX_3, EAX_4, EAX_5, EAX_6, EAX_7)
        w65 = w64
        w66 = -EA0Z + w63 + w65
        w67 = w66*z
        w68 = w32
        w69 = w68*x
        deviation[1, at] = w61 + w67 + w69
        w77 = _polynomial(z, w70, w71, w72, w73, w74, w75, w76)
        w86 = _polynomial(y, w79, w80, w81, w82, w83, w84, w85)
        w94 = _polynomial(x, w87, w88, w89, w90, w91, w92, w93)
        w95 = w77 + w78 + w86 + w94
        w96 = w62
        w97 = w64
        w98 = w96 + w97
        w99 = w98*y
        w100 = w27
        w101 = -w100*x
        deviation[2, at] = w101 + w95 + w99
    return deviation


def ballbar_error(positions, errors, parameters, point, ball, length):
    """Positioning error of a ball bar between a tool ball and a workpiece ball, exact.

    Source: Eqs. (5), (6). Operations: 171 per point, 3 per call.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (3,): home positions and location errors [mm, rad]
            rows: EC0X EA0Z EB0Z
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
    parameters = _constant("parameters", parameters, (3,))
    error = np.zeros((4, n))
    # constants
    EC0X = float(parameters[0])
    EA0Z = float(parameters[1])
    EB0Z = float(parameters[2])
    # once per call
    w22 = (EC0X*EC0X)
    w23 = 1.0/(w22 + 1)
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
        w0 = rx - x
        w1 = EAZ*ry - EBZ*rx + EZZ
        w2 = rz + z
        w3 = w1 + w2
        w4 = EBZ*rz - ECZ*ry + EXZ
        w5 = EB0Z*w3 + w4
        w6 = -EXY + w5
        w7 = ry - y
        w8 = -EAZ*rz + ECZ*rx + EYZ
        w9 = -EA0Z*w3 + w8
        w10 = -EYY + w9
        w11 = w10 + w7
        w12 = EA0Z*(ry + w8) - EB0Z*(rx + w4) + w1
        w13 = -EZY + w12
        w14 = w13 + w2
        w15 = rx + w6
        w16 = EAY*w15 + EBY*w11 + ECY*w14
        w17 = (EAY*EAY) + (EBY*EBY) + (ECY*ECY)
        w18 = 1.0/(w17 + 1)
        w19 = w18*(EAY*w16 - EBY*w14 + ECY*w11 - rx*w17 + w6)
        w20 = w18*(EAY*w14 + EBY*w16 - ECY*w15 + w10 - w17*w7)
        w21 = w20 + w7
        w24 = w23*(EC0X*w21 - rx*w22 + w19)
        w25 = -EXX + w24
        w26 = rx + w19
        w27 = w23*(-EC0X*w26 + w20 - w22*w7)
        w28 = -EYX + w27
        w29 = w28 + w7
        w30 = w18*(-EAY*w11 + EBY*w15 + ECY*w16 + w13 - w17*w2)
        w31 = w2 + w30
        w32 = EC0X*w31
        w33 = w23*(EC0X*w32 - w2*w22 + w30)
        w34 = -EZX + w33
        w35 = w2 + w34
        w36 = w0 + w25
        w37 = EAX*w36 + EBX*w29 + ECX*w35
        w38 = (EAX*EAX) + (EBX*EBX) + (ECX*ECX)
        w39 = 1.0/(w38 + 1)
        w40 = w39*(EAX*w37 - EBX*w35 + ECX*w29 - w0*w38 + w25)
        w41 = w39*(EAX*w35 + EBX*w37 - ECX*w36 + w28 - w38*w7)
        w42 = w39*(-EAX*w29 + EBX*w36 + ECX*w37 - w2*w38 + w34)
        w43 = -bx + w0
        w44 = -by + w7
        w45 = -bz + w2
        w46 = w40 + w43
        w47 = w41 + w44
        w48 = w42 + w45
        w49 = np.sqrt((w43*w43) + (w44*w44) + (w45*w45))
        w50 = np.sqrt((w46*w46) + (w47*w47) + (w48*w48))
        error[0, at] = e = -length_ + w49 + (w40*(w43 + w46) + w41*(w44 + w47) + w42*(w45 + w48))/(w49 + w50)
        w51 = e/w50
        error[1, at] = w46*w51
        error[2, at] = w47*w51
        error[3, at] = w48*w51
    return error


def correction(positions, deviation):
    """Moves of the linear axes that displace the ideal tool point by the given vector.

    Source: Eqs. (53)-(55), inverse. Operations: 2 per point.

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
        moves[0, at] = -dx
        moves[1, at] = -dy
        moves[2, at] = dz
    return moves


def motion_X(positions, errors, parameters, workpiece_point):
    """Motion equation of X: displacement of the workpiece point since home, to first order.

    Source: Eqs. (7)-(11). Operations: 15 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (3,): home positions and location errors [mm, rad]
            rows: EC0X EA0Z EB0Z
        workpiece_point (3, n): point in the workpiece frame [mm]
            rows: rWx rWy rWz

    Returns:
        displacement (3, n): workpiece point, displacement since home, in the bed frame [mm]
            rows: dx dy dz
    """
    n, positions, errors, workpiece_point = _points(positions=(positions, 3), errors=(errors, 18), workpiece_point=(workpiece_point, 3))
    parameters = _constant("parameters", parameters, (3,))
    displacement = np.zeros((3, n))
    # constants
    EC0X = float(parameters[0])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        x = positions[0, at]
        EXX = errors[0, at]
        EYX = errors[1, at]
        EZX = errors[2, at]
        EAX = errors[3, at]
        EBX = errors[4, at]
        ECX = errors[5, at]
        rWx = workpiece_point[0, at]
        rWy = workpiece_point[1, at]
        rWz = workpiece_point[2, at]
        # per point
        displacement[0, at] = EBX*rWz - ECX*rWy + EXX + x
        displacement[1, at] = -EAX*rWz + EC0X*x + ECX*rWx + EYX
        displacement[2, at] = EAX*rWy - EBX*rWx + EZX
    return displacement


def motion_Y(positions, errors, parameters, workpiece_point):
    """Motion equation of Y: displacement of the workpiece point since home, to first order.

    Source: Eqs. (7)-(11). Operations: 13 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (3,): home positions and location errors [mm, rad]
            rows: EC0X EA0Z EB0Z
        workpiece_point (3, n): point in the workpiece frame [mm]
            rows: rWx rWy rWz

    Returns:
        displacement (3, n): workpiece point, displacement since home, in the bed frame [mm]
            rows: dx dy dz
    """
    n, positions, errors, workpiece_point = _points(positions=(positions, 3), errors=(errors, 18), workpiece_point=(workpiece_point, 3))
    parameters = _constant("parameters", parameters, (3,))
    displacement = np.zeros((3, n))
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
        displacement[0, at] = EBY*rWz - ECY*rWy + EXY
        displacement[1, at] = -EAY*rWz + ECY*rWx + EYY + y
        displacement[2, at] = EAY*rWy - EBY*rWx + EZY
    return displacement


def motion_Z(positions, errors, parameters, tool_point):
    """Motion equation of Z: displacement of the tool point since home, to first order.

    Source: Eqs. (7)-(11). Operations: 17 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (3,): home positions and location errors [mm, rad]
            rows: EC0X EA0Z EB0Z
        tool_point (3, n): point in the tool frame [mm]
            rows: rTx rTy rTz

    Returns:
        displacement (3, n): tool point, displacement since home, in the bed frame [mm]
            rows: dx dy dz
    """
    n, positions, errors, tool_point = _points(positions=(positions, 3), errors=(errors, 18), tool_point=(tool_point, 3))
    parameters = _constant("parameters", parameters, (3,))
    displacement = np.zeros((3, n))
    # constants
    EA0Z = float(parameters[1])
    EB0Z = float(parameters[2])
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
        displacement[0, at] = EB0Z*z + EBZ*rTz - ECZ*rTy + EXZ
        displacement[1, at] = -EA0Z*z - EAZ*rTz + ECZ*rTx + EYZ
        displacement[2, at] = EAZ*rTy - EBZ*rTx + EZZ + z
    return displacement


def motion_XY(positions, errors, parameters, workpiece_point):
    """Motion equation of X and Y: displacement of the workpiece point since home, to first order.

    Source: Eqs. (7)-(11). Operations: 32 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (3,): home positions and location errors [mm, rad]
            rows: EC0X EA0Z EB0Z
        workpiece_point (3, n): point in the workpiece frame [mm]
            rows: rWx rWy rWz

    Returns:
        displacement (3, n): workpiece point, displacement since home, in the bed frame [mm]
            rows: dx dy dz
    """
    n, positions, errors, workpiece_point = _points(positions=(positions, 3), errors=(errors, 18), workpiece_point=(workpiece_point, 3))
    parameters = _constant("parameters", parameters, (3,))
    displacement = np.zeros((3, n))
    # constants
    EC0X = float(parameters[0])
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
        # per point
        displacement[0, at] = EBX*rWz + EBY*rWz - ECX*rWy - ECY*rWy + EXX + EXY + x
        w0 = rWx + x
        displacement[1, at] = -EAX*rWz - EAY*rWz + EC0X*x + ECX*rWx + ECY*w0 + EYX + EYY + y
        displacement[2, at] = EAX*rWy + EAY*rWy - EBX*rWx - EBY*w0 + EZX + EZY
    return displacement


def motion_XZ(positions, errors, parameters, workpiece_point, tool_point):
    """Motion equation of X and Z: displacement of the workpiece point minus tool point since home, to first order.

    Source: Eqs. (7)-(11). Operations: 35 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (3,): home positions and location errors [mm, rad]
            rows: EC0X EA0Z EB0Z
        workpiece_point (3, n): point in the workpiece frame [mm]
            rows: rWx rWy rWz
        tool_point (3, n): point in the tool frame [mm]
            rows: rTx rTy rTz

    Returns:
        displacement (3, n): workpiece point minus tool point, displacement since home, in the bed frame [mm]
            rows: dx dy dz
    """
    n, positions, errors, workpiece_point, tool_point = _points(positions=(positions, 3), errors=(errors, 18), workpiece_point=(workpiece_point, 3), tool_point=(tool_point, 3))
    parameters = _constant("parameters", parameters, (3,))
    displacement = np.zeros((3, n))
    # constants
    EC0X = float(parameters[0])
    EA0Z = float(parameters[1])
    EB0Z = float(parameters[2])
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
        rWx = workpiece_point[0, at]
        rWy = workpiece_point[1, at]
        rWz = workpiece_point[2, at]
        rTx = tool_point[0, at]
        rTy = tool_point[1, at]
        rTz = tool_point[2, at]
        # per point
        displacement[0, at] = -EB0Z*z + EBX*rWz - EBZ*rTz - ECX*rWy + ECZ*rTy + EXX - EXZ + x
        displacement[1, at] = EA0Z*z - EAX*rWz + EAZ*rTz + EC0X*x + ECX*rWx - ECZ*rTx + EYX - EYZ
        displacement[2, at] = EAX*rWy - EAZ*rTy - EBX*rWx + EBZ*rTx + EZX - EZZ - z
    return displacement


def motion_YZ(positions, errors, parameters, workpiece_point, tool_point):
    """Motion equation of Y and Z: displacement of the workpiece point minus tool point since home, to first order.

    Source: Eqs. (7)-(11). Operations: 33 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (3,): home positions and location errors [mm, rad]
            rows: EC0X EA0Z EB0Z
        workpiece_point (3, n): point in the workpiece frame [mm]
            rows: rWx rWy rWz
        tool_point (3, n): point in the tool frame [mm]
            rows: rTx rTy rTz

    Returns:
        displacement (3, n): workpiece point minus tool point, displacement since home, in the bed frame [mm]
            rows: dx dy dz
    """
    n, positions, errors, workpiece_point, tool_point = _points(positions=(positions, 3), errors=(errors, 18), workpiece_point=(workpiece_point, 3), tool_point=(tool_point, 3))
    parameters = _constant("parameters", parameters, (3,))
    displacement = np.zeros((3, n))
    # constants
    EA0Z = float(parameters[1])
    EB0Z = float(parameters[2])
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
        displacement[0, at] = -EB0Z*z + EBY*rWz - EBZ*rTz - ECY*rWy + ECZ*rTy + EXY - EXZ
        displacement[1, at] = EA0Z*z - EAY*rWz + EAZ*rTz + ECY*rWx - ECZ*rTx + EYY - EYZ + y
        displacement[2, at] = EAY*rWy - EAZ*rTy - EBY*rWx + EBZ*rTx + EZY - EZZ - z
    return displacement
