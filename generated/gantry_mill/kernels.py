# Generated from machines/gantry_mill.toml, do not edit; regenerate with: trueaxis derive machines/gantry_mill.toml
# SPDX-License-Identifier: MIT
"""Kernels of Gantry mill: geometric error model in NumPy.

Arrays are float64 with the quantity first and the point last: positions (n_axes, n), errors (n_components, n),
deviation (3, n). An array that is the same at all points may have n = 1. Lengths mm, angles rad.
An array of another shape is a ValueError that names it.

Equations after: Prediction and compensation of geometric error for translational axes in multi-axis machine tools
"""

import numpy as np

ABI = 3
SPEC_HASH = "436048e019673a322f57c00f796d232113d4f9b52648375eb9f68dfede1c3920"

META = {
    'machine': 'gantry_mill',
    'title': 'Gantry mill',
    'axes': ['X', 'Y', 'Z'],
    'position_units': ['mm', 'mm', 'mm'],
    'travel': {'X': [0.0, 3000.0], 'Y': [0.0, 1500.0], 'Z': [-600.0, 0.0]},
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
    'parameters': ['EC0Y', 'EA0Z', 'EB0Z'],
    'parameter_units': ['rad', 'rad', 'rad'],
    'parameter_descriptions': [
        'location error, rotation about Z, body 4 (Y slide) on body 3',
        'location error, rotation about X, body 5 (Z slide) on body 4',
        'location error, rotation about Y, body 5 (Z slide) on body 4',
    ],
    'dimensions': [],
    'location_errors': ['EC0Y', 'EA0Z', 'EB0Z'],
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
            'operations': 67,
            'operations_per_call': 0,
        },
        'tool_in_workpiece_deviation_first_order': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [3], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 56,
            'operations_per_call': 0,
        },
        'tool_in_workpiece_sensitivity': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'parameters', 'shape': [3], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'sensitivity', 'shape': [3, 21], 'per_point': True, 'unit': 'mm/mm, mm/rad'}],
            'operations': 7,
            'operations_per_call': 0,
        },
        'tool_in_bed_ideal': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'parameters', 'shape': [3], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'ideal', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 3,
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
            'operations': 67,
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
            'operations': 56,
            'operations_per_call': 0,
        },
        'tool_in_bed_sensitivity': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'parameters', 'shape': [3], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'sensitivity', 'shape': [3, 21], 'per_point': True, 'unit': 'mm/mm, mm/rad'}],
            'operations': 7,
            'operations_per_call': 0,
        },
        'workpiece_in_bed_ideal': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'parameters', 'shape': [3], 'per_point': False, 'unit': 'mm, rad'},
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
                {'name': 'parameters', 'shape': [3], 'per_point': False, 'unit': 'mm, rad'},
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
                {'name': 'parameters', 'shape': [3], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 0,
            'operations_per_call': 0,
        },
        'workpiece_in_bed_sensitivity': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'parameters', 'shape': [3], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'sensitivity', 'shape': [3, 21], 'per_point': True, 'unit': 'mm/mm, mm/rad'}],
            'operations': 0,
            'operations_per_call': 0,
        },
        'bed_in_workpiece_ideal': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'parameters', 'shape': [3], 'per_point': False, 'unit': 'mm, rad'},
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
                {'name': 'parameters', 'shape': [3], 'per_point': False, 'unit': 'mm, rad'},
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
                {'name': 'parameters', 'shape': [3], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 0,
            'operations_per_call': 0,
        },
        'bed_in_workpiece_sensitivity': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'parameters', 'shape': [3], 'per_point': False, 'unit': 'mm, rad'},
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
                {'name': 'parameters', 'shape': [3], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'position', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 71,
            'operations_per_call': 0,
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
            'operations': 301,
            'operations_per_call': 0,
        },
        'tool_in_workpiece_deviation_first_order_curves': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'curves', 'shape': [18, 7], 'per_point': False, 'unit': 'mm/mm^k, rad/mm^k'},
                {'name': 'parameters', 'shape': [3], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'point', 'shape': [3], 'per_point': False, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'deviation', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 206,
            'operations_per_call': 261,
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
            'operations': 104,
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
                {'name': 'parameters', 'shape': [3], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'tool_point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'displacement', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 13,
            'operations_per_call': 0,
        },
        'motion_Y': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [3], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'tool_point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'displacement', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 15,
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
                {'name': 'tool_point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
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
                {'name': 'tool_point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'displacement', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 34,
            'operations_per_call': 0,
        },
        'motion_YZ': {
            'inputs': [
                {'name': 'positions', 'shape': [3], 'per_point': True, 'unit': 'mm'},
                {'name': 'errors', 'shape': [18], 'per_point': True, 'unit': 'mm, rad'},
                {'name': 'parameters', 'shape': [3], 'per_point': False, 'unit': 'mm, rad'},
                {'name': 'tool_point', 'shape': [3], 'per_point': True, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'displacement', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 36,
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
            rows: EC0Y EA0Z EB0Z
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
        ideal[0, at] = rx + x
        ideal[1, at] = ry + y
        ideal[2, at] = rz + z
    return ideal


def tool_in_workpiece_deviation(positions, errors, parameters, point):
    """Deviation of a tool point in the workpiece frame, exact.

    Source: Eqs. (1)-(4). Operations: 67 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (3,): home positions and location errors [mm, rad]
            rows: EC0Y EA0Z EB0Z
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
    EC0Y = float(parameters[0])
    EA0Z = float(parameters[1])
    EB0Z = float(parameters[2])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
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
        w1 = EAZ*ry - EBZ*rx + EZZ
        w2 = w0 + w1
        w3 = -EAZ*rz + ECZ*rx + EYZ
        w4 = -EA0Z*w2 + w3
        w5 = ry + w4
        w6 = EBZ*rz - ECZ*ry + EXZ
        w7 = EB0Z*w2 + w6
        w8 = rx + w7
        w9 = EA0Z*(ry + w3) - EB0Z*(rx + w6) + w1
        w10 = EAY*w5 - EBY*w8 + EZY + w9
        w11 = w0 + w10
        w12 = ry + y
        w13 = w0 + w9
        w14 = EBY*w13 - ECY*w5 + EXY + w7
        w15 = -EAY*w13 + ECY*w8 + EYY + w4
        w16 = EC0Y*(rx + w14) + w15
        w17 = w12 + w16
        w18 = -EC0Y*(w12 + w15) + w14
        deviation[0, at] = EBX*w11 - ECX*w17 + EXX + w18
        w19 = rx + w18
        deviation[1, at] = -EAX*w11 + ECX*w19 + EYX + w16
        deviation[2, at] = EAX*w17 - EBX*w19 + EZX + w10
    return deviation


def tool_in_workpiece_deviation_first_order(positions, errors, parameters, point):
    """Deviation of a tool point in the workpiece frame, to first order in the errors.

    Source: Eqs. (1)-(4). Operations: 56 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (3,): home positions and location errors [mm, rad]
            rows: EC0Y EA0Z EB0Z
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
    EC0Y = float(parameters[0])
    EA0Z = float(parameters[1])
    EB0Z = float(parameters[2])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
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
        w1 = ry + y
        w2 = EBZ*rz - ECZ*ry + EXZ
        w3 = EB0Z*w0 + w2
        w4 = EBY*w0 - ECY*ry + EXY + w3
        w5 = -EC0Y*w1 + w4
        deviation[0, at] = EBX*w0 - ECX*w1 + EXX + w5
        w6 = -EAZ*rz + ECZ*rx + EYZ
        w7 = -EA0Z*w0 + w6
        w8 = -EAY*w0 + ECY*rx + EYY + w7
        w9 = EC0Y*rx + w8
        deviation[1, at] = -EAX*w0 + ECX*rx + EYX + w9
        w10 = EAZ*ry - EBZ*rx + EZZ
        w11 = EA0Z*ry - EB0Z*rx + w10
        w12 = EAY*ry - EBY*rx + EZY + w11
        deviation[2, at] = EAX*w1 - EBX*rx + EZX + w12
    return deviation


def tool_in_workpiece_sensitivity(positions, parameters, point):
    """Sensitivity of a tool point in the workpiece frame to every error, at the error-free machine.

    Source: Eqs. (1)-(4), first order. Operations: 7 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        parameters (3,): home positions and location errors [mm, rad]
            rows: EC0Y EA0Z EB0Z
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
        y = positions[1, at]
        z = positions[2, at]
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # per point
        sensitivity[4, at] = dx_EBX = rz + z
        sensitivity[45, at] = dz_EAX = ry + y
        sensitivity[5, at] = dx_ECX = -dz_EAX
        sensitivity[11, at] = dx_ECY = -ry
        sensitivity[24, at] = dy_EAX = -dx_EBX
        sensitivity[46, at] = dz_EBX = -rx
        sensitivity[0, at] = 1.0
        sensitivity[6, at] = 1.0
        sensitivity[10, at] = dx_EBX
        sensitivity[12, at] = 1.0
        sensitivity[16, at] = rz
        sensitivity[17, at] = dx_ECY
        sensitivity[18, at] = dx_ECX
        sensitivity[20, at] = dx_EBX
        sensitivity[22, at] = 1.0
        sensitivity[26, at] = rx
        sensitivity[28, at] = 1.0
        sensitivity[30, at] = dy_EAX
        sensitivity[32, at] = rx
        sensitivity[34, at] = 1.0
        sensitivity[36, at] = -rz
        sensitivity[38, at] = rx
        sensitivity[39, at] = rx
        sensitivity[40, at] = dy_EAX
        sensitivity[44, at] = 1.0
        sensitivity[50, at] = 1.0
        sensitivity[51, at] = ry
        sensitivity[52, at] = dz_EBX
        sensitivity[56, at] = 1.0
        sensitivity[57, at] = ry
        sensitivity[58, at] = dz_EBX
        sensitivity[61, at] = ry
        sensitivity[62, at] = dz_EBX
    return sensitivity.reshape(3, 21, n)


def tool_in_bed_ideal(positions, parameters, point):
    """Ideal position of a tool point in the bed frame.

    Source: Eqs. (1)-(4) without errors. Operations: 3 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        parameters (3,): home positions and location errors [mm, rad]
            rows: EC0Y EA0Z EB0Z
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
        x = positions[0, at]
        y = positions[1, at]
        z = positions[2, at]
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # per point
        ideal[0, at] = rx + x
        ideal[1, at] = ry + y
        ideal[2, at] = rz + z
    return ideal


def tool_in_bed_deviation(positions, errors, parameters, point):
    """Deviation of a tool point in the bed frame, exact.

    Source: Eqs. (1)-(4). Operations: 67 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (3,): home positions and location errors [mm, rad]
            rows: EC0Y EA0Z EB0Z
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
    EC0Y = float(parameters[0])
    EA0Z = float(parameters[1])
    EB0Z = float(parameters[2])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
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
        w1 = EAZ*ry - EBZ*rx + EZZ
        w2 = w0 + w1
        w3 = -EAZ*rz + ECZ*rx + EYZ
        w4 = -EA0Z*w2 + w3
        w5 = ry + w4
        w6 = EBZ*rz - ECZ*ry + EXZ
        w7 = EB0Z*w2 + w6
        w8 = rx + w7
        w9 = EA0Z*(ry + w3) - EB0Z*(rx + w6) + w1
        w10 = EAY*w5 - EBY*w8 + EZY + w9
        w11 = w0 + w10
        w12 = ry + y
        w13 = w0 + w9
        w14 = EBY*w13 - ECY*w5 + EXY + w7
        w15 = -EAY*w13 + ECY*w8 + EYY + w4
        w16 = EC0Y*(rx + w14) + w15
        w17 = w12 + w16
        w18 = -EC0Y*(w12 + w15) + w14
        deviation[0, at] = EBX*w11 - ECX*w17 + EXX + w18
        w19 = rx + w18
        deviation[1, at] = -EAX*w11 + ECX*w19 + EYX + w16
        deviation[2, at] = EAX*w17 - EBX*w19 + EZX + w10
    return deviation


def tool_in_bed_deviation_first_order(positions, errors, parameters, point):
    """Deviation of a tool point in the bed frame, to first order in the errors.

    Source: Eqs. (1)-(4). Operations: 56 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (3,): home positions and location errors [mm, rad]
            rows: EC0Y EA0Z EB0Z
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
    EC0Y = float(parameters[0])
    EA0Z = float(parameters[1])
    EB0Z = float(parameters[2])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
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
        w1 = ry + y
        w2 = EBZ*rz - ECZ*ry + EXZ
        w3 = EB0Z*w0 + w2
        w4 = EBY*w0 - ECY*ry + EXY + w3
        w5 = -EC0Y*w1 + w4
        deviation[0, at] = EBX*w0 - ECX*w1 + EXX + w5
        w6 = -EAZ*rz + ECZ*rx + EYZ
        w7 = -EA0Z*w0 + w6
        w8 = -EAY*w0 + ECY*rx + EYY + w7
        w9 = EC0Y*rx + w8
        deviation[1, at] = -EAX*w0 + ECX*rx + EYX + w9
        w10 = EAZ*ry - EBZ*rx + EZZ
        w11 = EA0Z*ry - EB0Z*rx + w10
        w12 = EAY*ry - EBY*rx + EZY + w11
        deviation[2, at] = EAX*w1 - EBX*rx + EZX + w12
    return deviation


def tool_in_bed_sensitivity(positions, parameters, point):
    """Sensitivity of a tool point in the bed frame to every error, at the error-free machine.

    Source: Eqs. (1)-(4), first order. Operations: 7 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        parameters (3,): home positions and location errors [mm, rad]
            rows: EC0Y EA0Z EB0Z
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
        y = positions[1, at]
        z = positions[2, at]
        rx = point[0, at]
        ry = point[1, at]
        rz = point[2, at]
        # per point
        sensitivity[4, at] = dx_EBX = rz + z
        sensitivity[45, at] = dz_EAX = ry + y
        sensitivity[5, at] = dx_ECX = -dz_EAX
        sensitivity[11, at] = dx_ECY = -ry
        sensitivity[24, at] = dy_EAX = -dx_EBX
        sensitivity[46, at] = dz_EBX = -rx
        sensitivity[0, at] = 1.0
        sensitivity[6, at] = 1.0
        sensitivity[10, at] = dx_EBX
        sensitivity[12, at] = 1.0
        sensitivity[16, at] = rz
        sensitivity[17, at] = dx_ECY
        sensitivity[18, at] = dx_ECX
        sensitivity[20, at] = dx_EBX
        sensitivity[22, at] = 1.0
        sensitivity[26, at] = rx
        sensitivity[28, at] = 1.0
        sensitivity[30, at] = dy_EAX
        sensitivity[32, at] = rx
        sensitivity[34, at] = 1.0
        sensitivity[36, at] = -rz
        sensitivity[38, at] = rx
        sensitivity[39, at] = rx
        sensitivity[40, at] = dy_EAX
        sensitivity[44, at] = 1.0
        sensitivity[50, at] = 1.0
        sensitivity[51, at] = ry
        sensitivity[52, at] = dz_EBX
        sensitivity[56, at] = 1.0
        sensitivity[57, at] = ry
        sensitivity[58, at] = dz_EBX
        sensitivity[61, at] = ry
        sensitivity[62, at] = dz_EBX
    return sensitivity.reshape(3, 21, n)


def workpiece_in_bed_ideal(positions, parameters, point):
    """Ideal position of a workpiece point in the bed frame.

    Source: Eqs. (1)-(4) without errors. Operations: 0 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        parameters (3,): home positions and location errors [mm, rad]
            rows: EC0Y EA0Z EB0Z
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
        parameters (3,): home positions and location errors [mm, rad]
            rows: EC0Y EA0Z EB0Z
        point (3, n): point in the workpiece frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): workpiece point in the bed frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions, errors, point = _points(positions=(positions, 3), errors=(errors, 18), point=(point, 3))
    parameters = _constant("parameters", parameters, (3,))
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
        parameters (3,): home positions and location errors [mm, rad]
            rows: EC0Y EA0Z EB0Z
        point (3, n): point in the workpiece frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): workpiece point in the bed frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions, errors, point = _points(positions=(positions, 3), errors=(errors, 18), point=(point, 3))
    parameters = _constant("parameters", parameters, (3,))
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
        parameters (3,): home positions and location errors [mm, rad]
            rows: EC0Y EA0Z EB0Z
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
        # per point
    return sensitivity.reshape(3, 21, n)


def bed_in_workpiece_ideal(positions, parameters, point):
    """Ideal position of a bed point in the workpiece frame.

    Source: Eqs. (1)-(4) without errors. Operations: 0 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        parameters (3,): home positions and location errors [mm, rad]
            rows: EC0Y EA0Z EB0Z
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
        parameters (3,): home positions and location errors [mm, rad]
            rows: EC0Y EA0Z EB0Z
        point (3, n): point in the bed frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): bed point in the workpiece frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions, errors, point = _points(positions=(positions, 3), errors=(errors, 18), point=(point, 3))
    parameters = _constant("parameters", parameters, (3,))
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
        parameters (3,): home positions and location errors [mm, rad]
            rows: EC0Y EA0Z EB0Z
        point (3, n): point in the bed frame [mm]
            rows: rx ry rz

    Returns:
        deviation (3, n): bed point in the workpiece frame, actual minus ideal [mm]
            rows: dx dy dz
    """
    n, positions, errors, point = _points(positions=(positions, 3), errors=(errors, 18), point=(point, 3))
    parameters = _constant("parameters", parameters, (3,))
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
        parameters (3,): home positions and location errors [mm, rad]
            rows: EC0Y EA0Z EB0Z
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
        # per point
    return sensitivity.reshape(3, 21, n)


def tool_in_workpiece_position(positions, errors, parameters, point):
    """Actual position of the tool point in the workpiece frame, exact.

    Source: Eq. (4). Operations: 71 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (3,): home positions and location errors [mm, rad]
            rows: EC0Y EA0Z EB0Z
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
    EC0Y = float(parameters[0])
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
        w1 = EAZ*ry - EBZ*rx + EZZ
        w2 = w0 + w1
        w3 = -EAZ*rz + ECZ*rx + EYZ
        w4 = -EA0Z*w2 + w3
        w5 = ry + w4
        w6 = EBZ*rz - ECZ*ry + EXZ
        w7 = EB0Z*w2 + w6
        w8 = rx + w7
        w9 = EA0Z*(ry + w3) - EB0Z*(rx + w6) + w1
        w10 = EAY*w5 - EBY*w8 + EZY + w9
        w11 = w0 + w10
        w12 = ry + y
        w13 = w0 + w9
        w14 = EBY*w13 - ECY*w5 + EXY + w7
        w15 = -EAY*w13 + ECY*w8 + EYY + w4
        w16 = EC0Y*(rx + w14) + w15
        w17 = w12 + w16
        w18 = -EC0Y*(w12 + w15) + w14
        w19 = EBX*w11 - ECX*w17 + EXX + w18
        w20 = rx + x
        position[0, at] = w19 + w20
        w21 = rx + w18
        w22 = -EAX*w11 + ECX*w21 + EYX + w16
        position[1, at] = w12 + w22
        w23 = EAX*w17 - EBX*w21 + EZX + w10
        position[2, at] = w0 + w23
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
            rows: EC0Y EA0Z EB0Z
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
    EC0Y = float(parameters[0])
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
        w1 = ry + y
        w2 = EBZ*rz - ECZ*ry + EXZ
        w3 = EB0Z*w0 + w2
        w4 = EBY*w0 - ECY*ry + EXY + w3
        w5 = -EC0Y*w1 + w4
        w6 = EBX*w0 - ECX*w1 + EXX + w5
        w7 = rx + x
        position[0, at] = w6 + w7
        w8 = -EAZ*rz + ECZ*rx + EYZ
        w9 = -EA0Z*w0 + w8
        w10 = -EAY*w0 + ECY*rx + EYY + w9
        w11 = EC0Y*rx + w10
        w12 = -EAX*w0 + ECX*rx + EYX + w11
        position[1, at] = w1 + w12
        w13 = EAZ*ry - EBZ*rx + EZZ
        w14 = EA0Z*ry - EB0Z*rx + w13
        w15 = EAY*ry - EBY*rx + EZY + w14
        w16 = EAX*w1 - EBX*rx + EZX + w15
        position[2, at] = w0 + w16
    return position


def tool_in_workpiece_deviation_curves(positions, curves, parameters, point):
    """Deviation of the tool point under polynomial error curves, exact.

    Source: Eqs. (1)-(4), (44). Operations: 301 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        curves (18, 7): coefficients of the powers 1 to 7 of the axis position, per component error [mm/mm^k, rad/mm^k]
            rows: EXX_1 EXX_2 .. ECZ_7, last index fastest
        parameters (3,): home positions and location errors [mm, rad]
            rows: EC0Y EA0Z EB0Z
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
    EC0Y = float(parameters[0])
    EA0Z = float(parameters[1])
    EB0Z = float(parameters[2])
    rx = float(point[0])
    ry = float(point[1])
    rz = float(point[2])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        x = positions[0, at]
        y = positions[1, at]
        z = positions[2, at]
        # per point
        w0 = rz + z
        w1 = _polynomial(z, EZZ_1, EZZ_2, EZZ_3, EZZ_4, EZZ_5, EZZ_6, EZZ_7)
        w2 = _polynomial(z, EAZ_1, EAZ_2, EAZ_3, EAZ_4, EAZ_5, EAZ_6, EAZ_7)
        w3 = _polynomial(z, EBZ_1, EBZ_2, EBZ_3, EBZ_4, EBZ_5, EBZ_6, EBZ_7)
        w4 = -rx*w3 + ry*w2 + w1
        w5 = w0 + w4
        w6 = _polynomial(z, EYZ_1, EYZ_2, EYZ_3, EYZ_4, EYZ_5, EYZ_6, EYZ_7)
        w7 = _polynomial(z, ECZ_1, ECZ_2, ECZ_3, ECZ_4, ECZ_5, ECZ_6, ECZ_7)
        w8 = rx*w7 - rz*w2 + w6
        w9 = -EA0Z*w5 + w8
        w10 = ry + w9
        w11 = _polynomial(z, EXZ_1, EXZ_2, EXZ_3, EXZ_4, EXZ_5, EXZ_6, EXZ_7)
        w12 = -ry*w7 + rz*w3 + w11
        w13 = EB0Z*w5 + w12
        w14 = rx + w13
        w15 = _polynomial(y, EZY_1, EZY_2, EZY_3, EZY_4, EZY_5, EZY_6, EZY_7)
        w16 = _polynomial(y, EAY_1, EAY_2, EAY_3, EAY_4, EAY_5, EAY_6, EAY_7)
        w17 = _polynomial(y, EBY_1, EBY_2, EBY_3, EBY_4, EBY_5, EBY_6, EBY_7)
        w18 = EA0Z*(ry + w8) - EB0Z*(rx + w12) + w4
        w19 = w10*w16 - w14*w17 + w15 + w18
        w20 = w0 + w19
        w21 = ry + y
        w22 = w0 + w18
        w23 = _polynomial(y, EXY_1, EXY_2, EXY_3, EXY_4, EXY_5, EXY_6, EXY_7)
        w24 = _polynomial(y, ECY_1, ECY_2, ECY_3, ECY_4, ECY_5, ECY_6, ECY_7)
        w25 = -w10*w24 + w13 + w17*w22 + w23
        w26 = _polynomial(y, EYY_1, EYY_2, EYY_3, EYY_4, EYY_5, EYY_6, EYY_7)
        w27 = w14*w24 - w16*w22 + w26 + w9
        w28 = EC0Y*(rx + w25) + w27
        w29 = w21 + w28
        w30 = _polynomial(x, EXX_1, EXX_2, EXX_3, EXX_4, EXX_5, EXX_6, EXX_7)
        w31 = _polynomial(x, EBX_1, EBX_2, EBX_3, EBX_4, EBX_5, EBX_6, EBX_7)
        w32 = _polynomial(x, ECX_1, ECX_2, ECX_3, ECX_4, ECX_5, ECX_6, ECX_7)
        w33 = -EC0Y*(w21 + w27) + w25
        deviation[0, at] = w20*w31 - w29*w32 + w30 + w33
        w34 = rx + w33
        w35 = _polynomial(x, EYX_1, EYX_2, EYX_3, EYX_4, EYX_5, EYX_6, EYX_7)
        w36 = _polynomial(x, EAX_1, EAX_2, EAX_3, EAX_4, EAX_5, EAX_6, EAX_7)
        deviation[1, at] = -w20*w36 + w28 + w32*w34 + w35
        w37 = _polynomial(x, EZX_1, EZX_2, EZX_3, EZX_4, EZX_5, EZX_6, EZX_7)
        deviation[2, at] = w19 + w29*w36 - w31*w34 + w37
    return deviation


def tool_in_workpiece_deviation_first_order_curves(positions, curves, parameters, point):
    """Deviation of the tool point under polynomial error curves, to first order, constants folded once per call.

    Source: Eqs. (1)-(4), (44). Operations: 206 per point, 261 per call.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        curves (18, 7): coefficients of the powers 1 to 7 of the axis position, per component error [mm/mm^k, rad/mm^k]
            rows: EXX_1 EXX_2 .. ECZ_7, last index fastest
        parameters (3,): home positions and location errors [mm, rad]
            rows: EC0Y EA0Z EB0Z
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
    EC0Y = float(parameters[0])
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
    w8 = EB0Z*rz - EC0Y*ry
    w9 = EBY_1*rz - ECY_1*ry + EXY_1
    w10 = EBY_2*rz - ECY_2*ry + EXY_2
    w11 = EBY_3*rz - ECY_3*ry + EXY_3
    w12 = EBY_4*rz - ECY_4*ry + EXY_4
    w13 = EBY_5*rz - ECY_5*ry + EXY_5
    w14 = EBY_6*rz - ECY_6*ry + EXY_6
    w15 = EBY_7*rz - ECY_7*ry + EXY_7
    w17 = EBX_1*rz - ECX_1*ry + EXX_1
    w18 = EBX_2*rz - ECX_2*ry + EXX_2
    w19 = EBX_3*rz - ECX_3*ry + EXX_3
    w20 = EBX_4*rz - ECX_4*ry + EXX_4
    w21 = EBX_5*rz - ECX_5*ry + EXX_5
    w22 = EBX_6*rz - ECX_6*ry + EXX_6
    w23 = EBX_7*rz - ECX_7*ry + EXX_7
    w33 = -EAZ_1*rz + ECZ_1*rx + EYZ_1
    w34 = -EAZ_2*rz + ECZ_2*rx + EYZ_2
    w35 = -EAZ_3*rz + ECZ_3*rx + EYZ_3
    w36 = -EAZ_4*rz + ECZ_4*rx + EYZ_4
    w37 = -EAZ_5*rz + ECZ_5*rx + EYZ_5
    w38 = -EAZ_6*rz + ECZ_6*rx + EYZ_6
    w39 = -EAZ_7*rz + ECZ_7*rx + EYZ_7
    w41 = -EA0Z*rz + EC0Y*rx
    w42 = -EAY_1*rz + ECY_1*rx + EYY_1
    w43 = -EAY_2*rz + ECY_2*rx + EYY_2
    w44 = -EAY_3*rz + ECY_3*rx + EYY_3
    w45 = -EAY_4*rz + ECY_4*rx + EYY_4
    w46 = -EAY_5*rz + ECY_5*rx + EYY_5
    w47 = -EAY_6*rz + ECY_6*rx + EYY_6
    w48 = -EAY_7*rz + ECY_7*rx + EYY_7
    w50 = -EAX_1*rz + ECX_1*rx + EYX_1
    w51 = -EAX_2*rz + ECX_2*rx + EYX_2
    w52 = -EAX_3*rz + ECX_3*rx + EYX_3
    w53 = -EAX_4*rz + ECX_4*rx + EYX_4
    w54 = -EAX_5*rz + ECX_5*rx + EYX_5
    w55 = -EAX_6*rz + ECX_6*rx + EYX_6
    w56 = -EAX_7*rz + ECX_7*rx + EYX_7
    w64 = EAZ_1*ry - EBZ_1*rx + EZZ_1
    w65 = EAZ_2*ry - EBZ_2*rx + EZZ_2
    w66 = EAZ_3*ry - EBZ_3*rx + EZZ_3
    w67 = EAZ_4*ry - EBZ_4*rx + EZZ_4
    w68 = EAZ_5*ry - EBZ_5*rx + EZZ_5
    w69 = EAZ_6*ry - EBZ_6*rx + EZZ_6
    w70 = EAZ_7*ry - EBZ_7*rx + EZZ_7
    w72 = EA0Z*ry - EB0Z*rx
    w73 = EAY_1*ry - EBY_1*rx + EZY_1
    w74 = EAY_2*ry - EBY_2*rx + EZY_2
    w75 = EAY_3*ry - EBY_3*rx + EZY_3
    w76 = EAY_4*ry - EBY_4*rx + EZY_4
    w77 = EAY_5*ry - EBY_5*rx + EZY_5
    w78 = EAY_6*ry - EBY_6*rx + EZY_6
    w79 = EAY_7*ry - EBY_7*rx + EZY_7
    w81 = EAX_1*ry - EBX_1*rx + EZX_1
    w82 = EAX_2*ry - EBX_2*rx + EZX_2
    w83 = EAX_3*ry - EBX_3*rx + EZX_3
    w84 = EAX_4*ry - EBX_4*rx + EZX_4
    w85 = EAX_5*ry - EBX_5*rx + EZX_5
    w86 = EAX_6*ry - EBX_6*rx + EZX_6
    w87 = EAX_7*ry - EBX_7*rx + EZX_7
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
        w28 = EB0Z + w26 + w27
        w29 = w28*z
        w30 = _polynomial(x, ECX_1, ECX_2, ECX_3, ECX_4, ECX_5, ECX_6, ECX_7)
        w31 = -EC0Y - w30
        w32 = w31*y
        deviation[0, at] = w25 + w29 + w32
        w40 = _polynomial(z, w33, w34, w35, w36, w37, w38, w39)
        w49 = _polynomial(y, w42, w43, w44, w45, w46, w47, w48)
        w57 = _polynomial(x, w50, w51, w52, w53, w54, w55, w56)
        w58 = w40 + w41 + w49 + w57
        w59 = _polynomial(y, EAY_1, EAY_2, EAY_3, EAY_4, EAY_5, EAY_6, EAY_7)
        w60 = _polynomial(x, EAX_1, EAX_2, EAX_3, EAX_4, EAX_5, EAX_6, EAX_7)
        w61 = w60
        w62 = -EA0Z - w59 - w61
        w63 = w62*z
        deviation[1, at] = w58 + w63
        w71 = _polynomial(z, w64, w65, w66, w67, w68, w69, w70)
        w80 = _polynomial(y, w73, w74, w75, w76, w77, w78, w79)
        w88 = _polynomial(x, w81, w82, w83, w84, w85, w86, w87)
        w89 = w71 + w72 + w80 + w88
        w90 = w60
        w91 = w90*y
        deviation[2, at] = w89 + w91
    return deviation


def ballbar_error(positions, errors, parameters, point, ball, length):
    """Positioning error of a ball bar between a tool ball and a workpiece ball, exact.

    Source: Eqs. (5), (6). Operations: 104 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (3,): home positions and location errors [mm, rad]
            rows: EC0Y EA0Z EB0Z
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
    EC0Y = float(parameters[0])
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
        bx = ball[0, at]
        by = ball[1, at]
        bz = ball[2, at]
        length_ = length[0, at]
        # per point
        w0 = rz + z
        w1 = EAZ*ry - EBZ*rx + EZZ
        w2 = w0 + w1
        w3 = -EAZ*rz + ECZ*rx + EYZ
        w4 = -EA0Z*w2 + w3
        w5 = ry + w4
        w6 = EBZ*rz - ECZ*ry + EXZ
        w7 = EB0Z*w2 + w6
        w8 = rx + w7
        w9 = EA0Z*(ry + w3) - EB0Z*(rx + w6) + w1
        w10 = EAY*w5 - EBY*w8 + EZY + w9
        w11 = w0 + w10
        w12 = ry + y
        w13 = w0 + w9
        w14 = EBY*w13 - ECY*w5 + EXY + w7
        w15 = -EAY*w13 + ECY*w8 + EYY + w4
        w16 = EC0Y*(rx + w14) + w15
        w17 = w12 + w16
        w18 = -EC0Y*(w12 + w15) + w14
        w19 = EBX*w11 - ECX*w17 + EXX + w18
        w20 = rx + w18
        w21 = -EAX*w11 + ECX*w20 + EYX + w16
        w22 = EAX*w17 - EBX*w20 + EZX + w10
        w23 = rx + x
        w24 = -bx + w23
        w25 = -by + w12
        w26 = -bz + w0
        w27 = w19 + w24
        w28 = w21 + w25
        w29 = w22 + w26
        w30 = np.sqrt((w24*w24) + (w25*w25) + (w26*w26))
        w31 = np.sqrt((w27*w27) + (w28*w28) + (w29*w29))
        error[0, at] = e = -length_ + w30 + (w19*(w24 + w27) + w21*(w25 + w28) + w22*(w26 + w29))/(w30 + w31)
        w32 = e/w31
        error[1, at] = w27*w32
        error[2, at] = w28*w32
        error[3, at] = w29*w32
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

    Source: Eqs. (7)-(11). Operations: 13 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (3,): home positions and location errors [mm, rad]
            rows: EC0Y EA0Z EB0Z
        tool_point (3, n): point in the tool frame [mm]
            rows: rTx rTy rTz

    Returns:
        displacement (3, n): tool point, displacement since home, in the bed frame [mm]
            rows: dx dy dz
    """
    n, positions, errors, tool_point = _points(positions=(positions, 3), errors=(errors, 18), tool_point=(tool_point, 3))
    parameters = _constant("parameters", parameters, (3,))
    displacement = np.zeros((3, n))
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
        displacement[0, at] = EBX*rTz - ECX*rTy + EXX + x
        displacement[1, at] = -EAX*rTz + ECX*rTx + EYX
        displacement[2, at] = EAX*rTy - EBX*rTx + EZX
    return displacement


def motion_Y(positions, errors, parameters, tool_point):
    """Motion equation of Y: displacement of the tool point since home, to first order.

    Source: Eqs. (7)-(11). Operations: 15 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (3,): home positions and location errors [mm, rad]
            rows: EC0Y EA0Z EB0Z
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
    EC0Y = float(parameters[0])
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
        displacement[0, at] = EBY*rTz - EC0Y*y - ECY*rTy + EXY
        displacement[1, at] = -EAY*rTz + ECY*rTx + EYY + y
        displacement[2, at] = EAY*rTy - EBY*rTx + EZY
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
            rows: EC0Y EA0Z EB0Z
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


def motion_XY(positions, errors, parameters, tool_point):
    """Motion equation of X and Y: displacement of the tool point since home, to first order.

    Source: Eqs. (7)-(11). Operations: 32 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (3,): home positions and location errors [mm, rad]
            rows: EC0Y EA0Z EB0Z
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
    EC0Y = float(parameters[0])
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
        w0 = rTy + y
        displacement[0, at] = EBX*rTz + EBY*rTz - EC0Y*y - ECX*w0 - ECY*rTy + EXX + EXY + x
        displacement[1, at] = -EAX*rTz - EAY*rTz + ECX*rTx + ECY*rTx + EYX + EYY + y
        displacement[2, at] = EAX*w0 + EAY*rTy - EBX*rTx - EBY*rTx + EZX + EZY
    return displacement


def motion_XZ(positions, errors, parameters, tool_point):
    """Motion equation of X and Z: displacement of the tool point since home, to first order.

    Source: Eqs. (7)-(11). Operations: 34 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (3,): home positions and location errors [mm, rad]
            rows: EC0Y EA0Z EB0Z
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
        w0 = rTz + z
        displacement[0, at] = EB0Z*z + EBX*w0 + EBZ*rTz - ECX*rTy - ECZ*rTy + EXX + EXZ + x
        displacement[1, at] = -EA0Z*z - EAX*w0 - EAZ*rTz + ECX*rTx + ECZ*rTx + EYX + EYZ
        displacement[2, at] = EAX*rTy + EAZ*rTy - EBX*rTx - EBZ*rTx + EZX + EZZ + z
    return displacement


def motion_YZ(positions, errors, parameters, tool_point):
    """Motion equation of Y and Z: displacement of the tool point since home, to first order.

    Source: Eqs. (7)-(11). Operations: 36 per point.

    Arguments (float64):
        positions (3, n): commanded positions of X Y Z [mm]
            rows: x y z
        errors (18, n): component errors at the point [mm, rad]
            rows: EXX EYX EZX EAX EBX ECX EXY EYY EZY EAY EBY ECY EXZ EYZ EZZ EAZ EBZ ECZ
        parameters (3,): home positions and location errors [mm, rad]
            rows: EC0Y EA0Z EB0Z
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
    EC0Y = float(parameters[0])
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
        rTx = tool_point[0, at]
        rTy = tool_point[1, at]
        rTz = tool_point[2, at]
        # per point
        w0 = rTz + z
        displacement[0, at] = EB0Z*z + EBY*w0 + EBZ*rTz - EC0Y*y - ECY*rTy - ECZ*rTy + EXY + EXZ
        displacement[1, at] = -EA0Z*z - EAY*w0 - EAZ*rTz + ECY*rTx + ECZ*rTx + EYY + EYZ + y
        displacement[2, at] = EAY*rTy + EAZ*rTy - EBY*rTx - EBZ*rTx + EZY + EZZ + z
    return displacement
