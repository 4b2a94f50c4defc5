# Generated from effects/library.py, do not edit; regenerate with: python -m trueaxis.codegen.effect_library
# SPDX-License-Identifier: MIT
"""Kernels of the library of effects: geometric error model in NumPy.

Arrays are float64 with the quantity first and the point last: positions (n_axes, n), errors (n_components, n),
deviation (3, n). An array that is the same at all points may have n = 1. Lengths mm, angles rad, positions of
rotary axes deg.
An array of another shape is a ValueError that names it.

Equations after: Prediction and compensation of geometric error for translational axes in multi-axis machine tools
"""

import numpy as np

ABI = 3
SPEC_HASH = ""

META = {
    'effects': {
        'kinds': {
            'backlash': {'place': 'component', 'context': ['direction'], 'parameters': ['width']},
            'backlash_slope': {'place': 'component', 'context': ['s', 'direction'], 'parameters': ['change']},
            'cyclic': {'place': 'component', 'context': ['q'], 'parameters': ['amplitude', 'phase', 'pitch']},
            'thermal_expansion': {'place': 'component', 'context': ['q', 'T'], 'parameters': ['coefficient']},
            'thermal_offset': {'place': 'component', 'context': ['T'], 'parameters': ['coefficient']},
            'warm_up': {'place': 'component', 'context': ['s', 't'], 'parameters': ['amplitude', 'tau']},
            'drift': {'place': 'component', 'context': ['t'], 'parameters': ['rate']},
            'servo_lag': {'place': 'component', 'context': ['v'], 'parameters': ['tau']},
            'reversal_spike': {
                'place': 'component',
                'context': ['direction', 'd'],
                'parameters': ['height', 'decay'],
            },
            'reversal_spike_time': {
                'place': 'component',
                'context': ['direction', 'd_time'],
                'parameters': ['height', 'tau'],
            },
            'reversal_spike_path': {
                'place': 'component',
                'context': ['direction', 'd_path'],
                'parameters': ['height', 'decay'],
            },
            'cross_axis': {'place': 'component', 'context': ['s', 's_b'], 'parameters': ['k']},
            'laser_cosine': {'place': 'reading', 'context': ['along'], 'parameters': ['angle']},
            'laser_scale': {'place': 'reading', 'context': ['along'], 'parameters': ['k']},
            'laser_step': {'place': 'reading', 'context': ['t'], 'parameters': ['jump', 't_0']},
            'reading_zero': {'place': 'reading', 'context': ['along'], 'parameters': ['zero']},
            'reading_slope': {'place': 'reading', 'context': ['along_line'], 'parameters': ['slope']},
            'point_offset': {'place': 'point', 'context': [], 'parameters': ['x', 'y', 'z']},
            'ballbar_length': {'place': 'reading', 'context': ['theta'], 'parameters': ['length']},
            'ballbar_centre': {'place': 'point', 'context': [], 'parameters': ['x', 'y', 'z']},
            'ballbar_lobes': {'place': 'reading', 'context': ['theta'], 'parameters': ['amplitude', 'phase']},
            'squareness': {'place': 'location', 'context': [], 'parameters': ['angle']},
        },
    },
    'routines': {
        'effect_backlash': {
            'inputs': [
                {'name': 'context', 'shape': [1], 'per_point': True, 'unit': '1'},
                {'name': 'parameters', 'shape': [1], 'per_point': False, 'unit': 'u'},
            ],
            'outputs': [{'name': 'term', 'shape': [2], 'per_point': True, 'unit': 'u'}],
            'operations': 2,
            'operations_per_call': 0,
        },
        'effect_backlash_slope': {
            'inputs': [
                {'name': 'context', 'shape': [2], 'per_point': True, 'unit': '1, 1'},
                {'name': 'parameters', 'shape': [1], 'per_point': False, 'unit': 'u'},
            ],
            'outputs': [{'name': 'term', 'shape': [2], 'per_point': True, 'unit': 'u'}],
            'operations': 4,
            'operations_per_call': 0,
        },
        'effect_cyclic': {
            'inputs': [
                {'name': 'context', 'shape': [1], 'per_point': True, 'unit': 'axis'},
                {'name': 'parameters', 'shape': [3], 'per_point': False, 'unit': 'u, rad, axis'},
            ],
            'outputs': [{'name': 'term', 'shape': [4], 'per_point': True, 'unit': 'u'}],
            'operations': 12,
            'operations_per_call': 0,
        },
        'effect_thermal_expansion': {
            'inputs': [
                {'name': 'context', 'shape': [2], 'per_point': True, 'unit': 'axis, K'},
                {'name': 'parameters', 'shape': [1], 'per_point': False, 'unit': 'u/axis/K'},
            ],
            'outputs': [{'name': 'term', 'shape': [2], 'per_point': True, 'unit': 'u'}],
            'operations': 2,
            'operations_per_call': 0,
        },
        'effect_thermal_offset': {
            'inputs': [
                {'name': 'context', 'shape': [1], 'per_point': True, 'unit': 'K'},
                {'name': 'parameters', 'shape': [1], 'per_point': False, 'unit': 'u/K'},
            ],
            'outputs': [{'name': 'term', 'shape': [2], 'per_point': True, 'unit': 'u'}],
            'operations': 1,
            'operations_per_call': 0,
        },
        'effect_warm_up': {
            'inputs': [
                {'name': 'context', 'shape': [2], 'per_point': True, 'unit': '1, s'},
                {'name': 'parameters', 'shape': [2], 'per_point': False, 'unit': 'u, s'},
            ],
            'outputs': [{'name': 'term', 'shape': [3], 'per_point': True, 'unit': 'u'}],
            'operations': 7,
            'operations_per_call': 0,
        },
        'effect_drift': {
            'inputs': [
                {'name': 'context', 'shape': [1], 'per_point': True, 'unit': 's'},
                {'name': 'parameters', 'shape': [1], 'per_point': False, 'unit': 'u/s'},
            ],
            'outputs': [{'name': 'term', 'shape': [2], 'per_point': True, 'unit': 'u'}],
            'operations': 1,
            'operations_per_call': 0,
        },
        'effect_servo_lag': {
            'inputs': [
                {'name': 'context', 'shape': [1], 'per_point': True, 'unit': 'axis/s'},
                {'name': 'parameters', 'shape': [1], 'per_point': False, 'unit': 's'},
            ],
            'outputs': [{'name': 'term', 'shape': [2], 'per_point': True, 'unit': 'u'}],
            'operations': 3,
            'operations_per_call': 0,
        },
        'effect_reversal_spike': {
            'inputs': [
                {'name': 'context', 'shape': [2], 'per_point': True, 'unit': '1, axis'},
                {'name': 'parameters', 'shape': [2], 'per_point': False, 'unit': 'u, axis'},
            ],
            'outputs': [{'name': 'term', 'shape': [3], 'per_point': True, 'unit': 'u'}],
            'operations': 7,
            'operations_per_call': 0,
        },
        'effect_reversal_spike_time': {
            'inputs': [
                {'name': 'context', 'shape': [2], 'per_point': True, 'unit': '1, s'},
                {'name': 'parameters', 'shape': [2], 'per_point': False, 'unit': 'u, s'},
            ],
            'outputs': [{'name': 'term', 'shape': [3], 'per_point': True, 'unit': 'u'}],
            'operations': 7,
            'operations_per_call': 0,
        },
        'effect_reversal_spike_path': {
            'inputs': [
                {'name': 'context', 'shape': [2], 'per_point': True, 'unit': '1, mm'},
                {'name': 'parameters', 'shape': [2], 'per_point': False, 'unit': 'u, mm'},
            ],
            'outputs': [{'name': 'term', 'shape': [3], 'per_point': True, 'unit': 'u'}],
            'operations': 7,
            'operations_per_call': 0,
        },
        'effect_cross_axis': {
            'inputs': [
                {'name': 'context', 'shape': [2], 'per_point': True, 'unit': '1, 1'},
                {'name': 'parameters', 'shape': [1], 'per_point': False, 'unit': 'u'},
            ],
            'outputs': [{'name': 'term', 'shape': [2], 'per_point': True, 'unit': 'u'}],
            'operations': 3,
            'operations_per_call': 0,
        },
        'effect_laser_cosine': {
            'inputs': [
                {'name': 'context', 'shape': [1], 'per_point': True, 'unit': 'mm'},
                {'name': 'parameters', 'shape': [1], 'per_point': False, 'unit': 'rad'},
            ],
            'outputs': [{'name': 'term', 'shape': [2], 'per_point': True, 'unit': 'mm'}],
            'operations': 6,
            'operations_per_call': 0,
        },
        'effect_laser_scale': {
            'inputs': [
                {'name': 'context', 'shape': [1], 'per_point': True, 'unit': 'mm'},
                {'name': 'parameters', 'shape': [1], 'per_point': False, 'unit': '1'},
            ],
            'outputs': [{'name': 'term', 'shape': [2], 'per_point': True, 'unit': 'mm'}],
            'operations': 1,
            'operations_per_call': 0,
        },
        'effect_laser_step': {
            'inputs': [
                {'name': 'context', 'shape': [1], 'per_point': True, 'unit': 's'},
                {'name': 'parameters', 'shape': [2], 'per_point': False, 'unit': 'mm, s'},
            ],
            'outputs': [{'name': 'term', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 3,
            'operations_per_call': 0,
        },
        'effect_reading_zero': {
            'inputs': [
                {'name': 'context', 'shape': [1], 'per_point': True, 'unit': 'mm'},
                {'name': 'parameters', 'shape': [1], 'per_point': False, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'term', 'shape': [2], 'per_point': True, 'unit': 'mm'}],
            'operations': 0,
            'operations_per_call': 0,
        },
        'effect_reading_slope': {
            'inputs': [
                {'name': 'context', 'shape': [1], 'per_point': True, 'unit': 'mm'},
                {'name': 'parameters', 'shape': [1], 'per_point': False, 'unit': '1'},
            ],
            'outputs': [{'name': 'term', 'shape': [2], 'per_point': True, 'unit': 'mm'}],
            'operations': 1,
            'operations_per_call': 0,
        },
        'effect_ballbar_length': {
            'inputs': [
                {'name': 'context', 'shape': [1], 'per_point': True, 'unit': 'rad'},
                {'name': 'parameters', 'shape': [1], 'per_point': False, 'unit': 'mm'},
            ],
            'outputs': [{'name': 'term', 'shape': [2], 'per_point': True, 'unit': 'mm'}],
            'operations': 0,
            'operations_per_call': 0,
        },
        'effect_ballbar_lobes': {
            'inputs': [
                {'name': 'context', 'shape': [1], 'per_point': True, 'unit': 'rad'},
                {'name': 'parameters', 'shape': [2], 'per_point': False, 'unit': 'mm, rad'},
            ],
            'outputs': [{'name': 'term', 'shape': [3], 'per_point': True, 'unit': 'mm'}],
            'operations': 7,
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


def effect_backlash(context, parameters):
    """Term of the effect backlash: play or elastic wind-up in the drive (along the axis: lost motion) or in the guides (across: lateral play).

    Source: backlash = width/2*direction. Operations: 2 per point.

    Arguments (float64):
        context (1, n): direction: direction of the last motion of the axis: +1, -1, 0 before it has moved (u: unit of the component, axis: of its axis) [1]
            rows: direction
        parameters (1,): width: lost motion: jump between the two directions of approach (u: unit of the component, axis: of its axis) [u]
            rows: width

    Returns:
        term (2, n): the term in u, then its derivative by width [u]
            rows: term term_by_width
    """
    n, context = _points(context=(context, 1))
    parameters = _constant("parameters", parameters, (1,))
    term = np.zeros((2, n))
    # constants
    width = float(parameters[0])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        direction = context[0, at]
        # per point
        term[1, at] = term_by_width = (0.5)*direction
        term[0, at] = term_by_width*width
    return term


def effect_backlash_slope(context, parameters):
    """Term of the effect backlash_slope: lost motion that varies along the travel: a worn part of the screw, wind-up that depends on its free length.

    Source: backlash_slope = change*direction*(s - 1/2). Operations: 4 per point.

    Arguments (float64):
        context (2, n): s: share of its travel, 0 at the lower end and 1 at the upper; direction: direction of the last motion of the axis: +1, -1, 0 before it has moved (u: unit of the component, axis: of its axis) [1, 1]
            rows: s direction
        parameters (1,): change: change of half the lost motion from one end of the travel to the other (u: unit of the component, axis: of its axis) [u]
            rows: change

    Returns:
        term (2, n): the term in u, then its derivative by change [u]
            rows: term term_by_change
    """
    n, context = _points(context=(context, 2))
    parameters = _constant("parameters", parameters, (1,))
    term = np.zeros((2, n))
    # constants
    change = float(parameters[0])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        s = context[0, at]
        direction = context[1, at]
        # per point
        term[1, at] = term_by_change = direction*(s - 0.5)
        term[0, at] = change*term_by_change
    return term


def effect_cyclic(context, parameters):
    """Term of the effect cyclic: a periodic error: pitch of the screw, its coupling, an eccentric encoder, interpolation of a scale.

    Source: cyclic = amplitude*cos(2*pi*q/pitch + phase). Operations: 12 per point.

    Arguments (float64):
        context (1, n): q: commanded position of the axis (u: unit of the component, axis: of its axis) [axis]
            rows: q
        parameters (3,): amplitude: amplitude; phase: phase at position 0; pitch: period (u: unit of the component, axis: of its axis) [u, rad, axis]
            rows: amplitude phase pitch

    Returns:
        term (4, n): the term in u, then its derivative by amplitude, phase, pitch [u]
            rows: term term_by_amplitude term_by_phase term_by_pitch
    """
    n, context = _points(context=(context, 1))
    parameters = _constant("parameters", parameters, (3,))
    term = np.zeros((4, n))
    # constants
    amplitude = float(parameters[0])
    phase = float(parameters[1])
    pitch = float(parameters[2])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        q = context[0, at]
        # per point
        w0 = 2*3.141592653589793*q
        w1 = phase + w0/pitch
        term[1, at] = term_by_amplitude = np.cos(w1)
        term[0, at] = amplitude*term_by_amplitude
        w2 = amplitude*np.sin(w1)
        term[2, at] = -w2
        term[3, at] = w0*w2/(pitch*pitch)
    return term


def effect_thermal_expansion(context, parameters):
    """Term of the effect thermal_expansion: a scale or screw that grows with its temperature.

    Source: thermal_expansion = coefficient*q*T. Operations: 2 per point.

    Arguments (float64):
        context (2, n): q: commanded position of the axis; T: temperature minus 20 degC (u: unit of the component, axis: of its axis) [axis, K]
            rows: q T
        parameters (1,): coefficient: expansion per kelvin (u: unit of the component, axis: of its axis) [u/axis/K]
            rows: coefficient

    Returns:
        term (2, n): the term in u, then its derivative by coefficient [u]
            rows: term term_by_coefficient
    """
    n, context = _points(context=(context, 2))
    parameters = _constant("parameters", parameters, (1,))
    term = np.zeros((2, n))
    # constants
    coefficient = float(parameters[0])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        q = context[0, at]
        T = context[1, at]
        # per point
        term[1, at] = term_by_coefficient = T*q
        term[0, at] = coefficient*term_by_coefficient
    return term


def effect_thermal_offset(context, parameters):
    """Term of the effect thermal_offset: a structure that bends or shifts with its temperature.

    Source: thermal_offset = coefficient*T. Operations: 1 per point.

    Arguments (float64):
        context (1, n): T: temperature minus 20 degC (u: unit of the component, axis: of its axis) [K]
            rows: T
        parameters (1,): coefficient: displacement or rotation per kelvin (u: unit of the component, axis: of its axis) [u/K]
            rows: coefficient

    Returns:
        term (2, n): the term in u, then its derivative by coefficient [u]
            rows: term term_by_coefficient
    """
    n, context = _points(context=(context, 1))
    parameters = _constant("parameters", parameters, (1,))
    term = np.zeros((2, n))
    # constants
    coefficient = float(parameters[0])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        T = context[0, at]
        # per point
        term[0, at] = T*coefficient
        term[1, at] = T
    return term


def effect_warm_up(context, parameters):
    """Term of the effect warm_up: a screw or scale that warms up by its own friction.

    Source: warm_up = amplitude*s*exp(-t/tau). Operations: 7 per point.

    Arguments (float64):
        context (2, n): s: share of its travel, 0 at the lower end and 1 at the upper; t: time of the reading (u: unit of the component, axis: of its axis) [1, s]
            rows: s t
        parameters (2,): amplitude: growth still to come at time 0, at the upper end of the travel; tau: time constant (u: unit of the component, axis: of its axis) [u, s]
            rows: amplitude tau

    Returns:
        term (3, n): the term in u, then its derivative by amplitude, tau [u]
            rows: term term_by_amplitude term_by_tau
    """
    n, context = _points(context=(context, 2))
    parameters = _constant("parameters", parameters, (2,))
    term = np.zeros((3, n))
    # constants
    amplitude = float(parameters[0])
    tau = float(parameters[1])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        s = context[0, at]
        t = context[1, at]
        # per point
        term[1, at] = term_by_amplitude = s*np.exp(-t/tau)
        term[0, at] = term_ = amplitude*term_by_amplitude
        term[2, at] = t*term_/(tau*tau)
    return term


def effect_drift(context, parameters):
    """Term of the effect drift: something drifts during the measurement: temperature, foundation, fixture.

    Source: drift = rate*t. Operations: 1 per point.

    Arguments (float64):
        context (1, n): t: time of the reading (u: unit of the component, axis: of its axis) [s]
            rows: t
        parameters (1,): rate: change per second (u: unit of the component, axis: of its axis) [u/s]
            rows: rate

    Returns:
        term (2, n): the term in u, then its derivative by rate [u]
            rows: term term_by_rate
    """
    n, context = _points(context=(context, 1))
    parameters = _constant("parameters", parameters, (1,))
    term = np.zeros((2, n))
    # constants
    rate = float(parameters[0])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        t = context[0, at]
        # per point
        term[0, at] = rate*t
        term[1, at] = t
    return term


def effect_servo_lag(context, parameters):
    """Term of the effect servo_lag: following error of the position loop; only its difference between axes shows in a circle.

    Source: servo_lag = -tau*v. Operations: 3 per point.

    Arguments (float64):
        context (1, n): v: velocity of the axis while the reading is taken, 0 where it stands (u: unit of the component, axis: of its axis) [axis/s]
            rows: v
        parameters (1,): tau: time by which the axis lags its command, beyond that of the other axes (u: unit of the component, axis: of its axis) [s]
            rows: tau

    Returns:
        term (2, n): the term in u, then its derivative by tau [u]
            rows: term term_by_tau
    """
    n, context = _points(context=(context, 1))
    parameters = _constant("parameters", parameters, (1,))
    term = np.zeros((2, n))
    # constants
    tau = float(parameters[0])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        v = context[0, at]
        # per point
        term[0, at] = -tau*v
        term[1, at] = -v
    return term


def effect_reversal_spike(context, parameters):
    """Term of the effect reversal_spike: friction that the position loop has to overcome at a reversal (quadrant glitch).

    Source: reversal_spike = height*direction*exp(-d/decay). Operations: 7 per point.

    Arguments (float64):
        context (2, n): direction: direction of the last motion of the axis: +1, -1, 0 before it has moved; d: distance since its last reversal, 1e9 before the first (u: unit of the component, axis: of its axis) [1, axis]
            rows: direction d
        parameters (2,): height: height right after the reversal; decay: distance over which it decays (u: unit of the component, axis: of its axis) [u, axis]
            rows: height decay

    Returns:
        term (3, n): the term in u, then its derivative by height, decay [u]
            rows: term term_by_height term_by_decay
    """
    n, context = _points(context=(context, 2))
    parameters = _constant("parameters", parameters, (2,))
    term = np.zeros((3, n))
    # constants
    height = float(parameters[0])
    decay = float(parameters[1])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        direction = context[0, at]
        d = context[1, at]
        # per point
        term[1, at] = term_by_height = direction*np.exp(-d/decay)
        term[0, at] = term_ = height*term_by_height
        term[2, at] = d*term_/(decay*decay)
    return term


def effect_reversal_spike_time(context, parameters):
    """Term of the effect reversal_spike_time: friction at a reversal that the integral part of the control loop overcomes: as long at any feed.

    Source: reversal_spike_time = height*direction*exp(-d_time/tau). Operations: 7 per point.

    Arguments (float64):
        context (2, n): direction: direction of the last motion of the axis: +1, -1, 0 before it has moved; d_time: time since its last reversal, 1e9 before the first (u: unit of the component, axis: of its axis) [1, s]
            rows: direction d_time
        parameters (2,): height: height right after the reversal; tau: time over which it decays (u: unit of the component, axis: of its axis) [u, s]
            rows: height tau

    Returns:
        term (3, n): the term in u, then its derivative by height, tau [u]
            rows: term term_by_height term_by_tau
    """
    n, context = _points(context=(context, 2))
    parameters = _constant("parameters", parameters, (2,))
    term = np.zeros((3, n))
    # constants
    height = float(parameters[0])
    tau = float(parameters[1])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        direction = context[0, at]
        d_time = context[1, at]
        # per point
        term[1, at] = term_by_height = direction*np.exp(-d_time/tau)
        term[0, at] = term_ = height*term_by_height
        term[2, at] = d_time*term_/(tau*tau)
    return term


def effect_reversal_spike_path(context, parameters):
    """Term of the effect reversal_spike_path: friction at a reversal that is overcome as the path goes on, whichever axis moves.

    Source: reversal_spike_path = height*direction*exp(-d_path/decay). Operations: 7 per point.

    Arguments (float64):
        context (2, n): direction: direction of the last motion of the axis: +1, -1, 0 before it has moved; d_path: distance along the path of all linear axes since its last reversal, 1e9 before the first (u: unit of the component, axis: of its axis) [1, mm]
            rows: direction d_path
        parameters (2,): height: height right after the reversal; decay: distance along the path over which it decays (u: unit of the component, axis: of its axis) [u, mm]
            rows: height decay

    Returns:
        term (3, n): the term in u, then its derivative by height, decay [u]
            rows: term term_by_height term_by_decay
    """
    n, context = _points(context=(context, 2))
    parameters = _constant("parameters", parameters, (2,))
    term = np.zeros((3, n))
    # constants
    height = float(parameters[0])
    decay = float(parameters[1])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        direction = context[0, at]
        d_path = context[1, at]
        # per point
        term[1, at] = term_by_height = direction*np.exp(-d_path/decay)
        term[0, at] = term_ = height*term_by_height
        term[2, at] = d_path*term_/(decay*decay)
    return term


def effect_cross_axis(context, parameters):
    """Term of the effect cross_axis: a body that bends under another one: the component error of one axis depends on where another axis stands.

    Source: cross_axis = k*s*s_b^2. Operations: 3 per point.

    Arguments (float64):
        context (2, n): s: share of its travel, 0 at the lower end and 1 at the upper; s_b: share of its travel, 0 at the lower end and 1 at the upper (the other axis) (u: unit of the component, axis: of its axis) [1, 1]
            rows: s s_b
        parameters (1,): k: value at the far ends of both travels (u: unit of the component, axis: of its axis) [u]
            rows: k

    Returns:
        term (2, n): the term in u, then its derivative by k [u]
            rows: term term_by_k
    """
    n, context = _points(context=(context, 2))
    parameters = _constant("parameters", parameters, (1,))
    term = np.zeros((2, n))
    # constants
    k = float(parameters[0])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        s = context[0, at]
        s_b = context[1, at]
        # per point
        term[1, at] = term_by_k = s*(s_b*s_b)
        term[0, at] = k*term_by_k
    return term


def effect_laser_cosine(context, parameters):
    """Term of the effect laser_cosine: the laser beam was not parallel to the motion: it reads short.

    Source: laser_cosine = -angle^2/2*along. Operations: 6 per point.

    Arguments (float64):
        context (1, n): along: ideal displacement in the sensitive direction, since home [mm]
            rows: along
        parameters (1,): angle: angle between beam and motion [rad]
            rows: angle

    Returns:
        term (2, n): the term in mm, then its derivative by angle [mm]
            rows: term term_by_angle
    """
    n, context = _points(context=(context, 1))
    parameters = _constant("parameters", parameters, (1,))
    term = np.zeros((2, n))
    # constants
    angle = float(parameters[0])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        along = context[0, at]
        # per point
        term[0, at] = -0.5*along*(angle*angle)
        term[1, at] = -along*angle
    return term


def effect_laser_scale(context, parameters):
    """Term of the effect laser_scale: wavelength of the laser: air temperature, pressure or humidity were not what was entered.

    Source: laser_scale = k*along. Operations: 1 per point.

    Arguments (float64):
        context (1, n): along: ideal displacement in the sensitive direction, since home [mm]
            rows: along
        parameters (1,): k: relative error of all laser distances [1]
            rows: k

    Returns:
        term (2, n): the term in mm, then its derivative by k [mm]
            rows: term term_by_k
    """
    n, context = _points(context=(context, 1))
    parameters = _constant("parameters", parameters, (1,))
    term = np.zeros((2, n))
    # constants
    k = float(parameters[0])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        along = context[0, at]
        # per point
        term[0, at] = along*k
        term[1, at] = along
    return term


def effect_laser_step(context, parameters):
    """Term of the effect laser_step: something slipped or lost counts in the middle of a run.

    Source: laser_step = jump*step(t - t_0). Operations: 3 per point.

    Arguments (float64):
        context (1, n): t: time of the reading [s]
            rows: t
        parameters (2,): jump: height of the jump; t_0: moment of the jump [mm, s]
            rows: jump t_0

    Returns:
        term (3, n): the term in mm, then its derivative by jump, t_0 [mm]
            rows: term term_by_jump term_by_t_0
    """
    n, context = _points(context=(context, 1))
    parameters = _constant("parameters", parameters, (2,))
    term = np.zeros((3, n))
    # constants
    jump = float(parameters[0])
    t_0 = float(parameters[1])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        t = context[0, at]
        # per point
        term[1, at] = term_by_jump = np.heaviside(t - t_0, 1.0)
        term[0, at] = jump*term_by_jump
    return term


def effect_reading_zero(context, parameters):
    """Term of the effect reading_zero: the readings were zeroed elsewhere than the set-up says, or the instrument was touched between runs.

    Source: reading_zero = zero. Operations: 0 per point.

    Arguments (float64):
        context (1, n): along: ideal displacement in the sensitive direction, since home [mm]
            rows: along
        parameters (1,): zero: value added to all readings of the runs [mm]
            rows: zero

    Returns:
        term (2, n): the term in mm, then its derivative by zero [mm]
            rows: term term_by_zero
    """
    n, context = _points(context=(context, 1))
    parameters = _constant("parameters", parameters, (1,))
    term = np.zeros((2, n))
    # constants
    zero = float(parameters[0])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        # per point
        term[0, at] = zero
        term[1, at] = 1.0
    return term


def effect_reading_slope(context, parameters):
    """Term of the effect reading_slope: the reference line of a straightness run (its optics, a straightedge) is not parallel to the motion.

    Source: reading_slope = slope*along_line. Operations: 1 per point.

    Arguments (float64):
        context (1, n): along_line: ideal displacement of laser or probe along the line of the motion, since home [mm]
            rows: along_line
        parameters (1,): slope: change of the reading per displacement along the line of the motion, mm/mm [1]
            rows: slope

    Returns:
        term (2, n): the term in mm, then its derivative by slope [mm]
            rows: term term_by_slope
    """
    n, context = _points(context=(context, 1))
    parameters = _constant("parameters", parameters, (1,))
    term = np.zeros((2, n))
    # constants
    slope = float(parameters[0])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        along_line = context[0, at]
        # per point
        term[0, at] = along_line*slope
        term[1, at] = along_line
    return term


def effect_ballbar_length(context, parameters):
    """Term of the effect ballbar_length: the bar is longer than stated (shorter, where the length is negative).

    Source: ballbar_length = length. Operations: 0 per point.

    Arguments (float64):
        context (1, n): theta: polar angle of a ball bar in the plane of its circle [rad]
            rows: theta
        parameters (1,): length: actual minus nominal length of the bar [mm]
            rows: length

    Returns:
        term (2, n): the term in mm, then its derivative by length [mm]
            rows: term term_by_length
    """
    n, context = _points(context=(context, 1))
    parameters = _constant("parameters", parameters, (1,))
    term = np.zeros((2, n))
    # constants
    length = float(parameters[0])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        # per point
        term[0, at] = length
        term[1, at] = 1.0
    return term


def effect_ballbar_lobes(context, parameters):
    """Term of the effect ballbar_lobes: form error of the balls or of the bar's sockets: three lobes.

    Source: ballbar_lobes = amplitude*cos(3*theta + phase). Operations: 7 per point.

    Arguments (float64):
        context (1, n): theta: polar angle of a ball bar in the plane of its circle [rad]
            rows: theta
        parameters (2,): amplitude: amplitude; phase: phase at polar angle 0 [mm, rad]
            rows: amplitude phase

    Returns:
        term (3, n): the term in mm, then its derivative by amplitude, phase [mm]
            rows: term term_by_amplitude term_by_phase
    """
    n, context = _points(context=(context, 1))
    parameters = _constant("parameters", parameters, (2,))
    term = np.zeros((3, n))
    # constants
    amplitude = float(parameters[0])
    phase = float(parameters[1])
    for start in range(0, n, BLOCK):
        at = slice(start, start + BLOCK)
        theta = context[0, at]
        # per point
        w0 = phase + 3*theta
        term[1, at] = term_by_amplitude = np.cos(w0)
        term[0, at] = amplitude*term_by_amplitude
        term[2, at] = -amplitude*np.sin(w0)
    return term
