/* Part of the LinuxCNC kinematics module that trueaxis writes.
 * SPDX-License-Identifier: MIT
 * Error curves: one motion error as a function of the position of its axis.
 */
#ifndef TRUEAXIS_CURVES_H
#define TRUEAXIS_CURVES_H

typedef enum {
    NO_CURVE,
    POLYNOMIAL, /* numbers: coefficients of falling powers, the last is the constant; Horner's scheme */
    TABLE,      /* numbers: rising positions, then values; a straight line between, the end values beyond */
    LEGENDRE    /* numbers: coefficients of P1, P2 ... of the range scaled to -1 .. 1, then of the cosine and the sine of
                 * 1, 2 ... times the angle where the axis turns round, less the value at home */
} curve_form;

/* count: of coefficients, or of positions, of LEGENDRE those of P1, P2 ...; low, high: range of LEGENDRE, mm or deg;
 * at_home: its value there; harmonics: of a turn
 */
typedef struct {
    curve_form form;
    int axis;
    int count;
    const double *numbers;
    double low;
    double high;
    double at_home;
    int harmonics;
} curve;

static double polynomial_at(const curve *of, double position)
{
    double value = 0.0;
    for (int k = 0; k < of->count; ++k) {
        value = value * position + of->numbers[k];
    }
    return value;
}

static double table_at(const curve *of, double position)
{
    const double *positions = of->numbers;
    const double *values = of->numbers + of->count;
    int below = 0;
    int above = of->count - 1;
    if (position <= positions[below]) {
        return values[below];
    }
    if (position >= positions[above]) {
        return values[above];
    }
    while (above - below > 1) {
        const int middle = below + (above - below) / 2;
        if (positions[middle] <= position) {
            below = middle;
        } else {
            above = middle;
        }
    }
    return values[below]
        + (values[above] - values[below]) / (positions[above] - positions[below]) * (position - positions[below]);
}

static double legendre_at(const curve *of, double position)
{
    const double clamped = position < of->low ? of->low : position > of->high ? of->high : position;
    const double half = of->high > of->low ? 0.5 * (of->high - of->low) : 1.0;
    const double scaled = (clamped - 0.5 * (of->low + of->high)) / half;
    double before = 1.0;
    double current = scaled;
    double value = -of->at_home;
    for (int k = 1; k <= of->count; ++k) {
        /* (k + 1) P[k + 1] = (2 k + 1) t P[k] - k P[k - 1] */
        const double following = ((2 * k + 1) * scaled * current - k * before) / (k + 1);
        value += of->numbers[k - 1] * current;
        before = current;
        current = following;
    }
    if (of->harmonics == 0) {
        return value;
    }
    const double angle = position * 0.017453292519943295; /* pi / 180; turns repeat beyond the range */
    const double cosine = cos(angle);
    const double sine = sin(angle);
    const double *numbers = of->numbers + of->count;
    double real = cosine;
    double imaginary = sine;
    for (int k = 0; k < of->harmonics; ++k) {
        value += numbers[2 * k] * real + numbers[2 * k + 1] * imaginary;
        const double turned = real * cosine - imaginary * sine;
        imaginary = real * sine + imaginary * cosine;
        real = turned;
    }
    return value;
}

/* The error in mm or rad at a position in mm or deg; NaN where the position is NaN. */
static double curve_at(const curve *of, double position)
{
    switch (of->form) {
    case POLYNOMIAL:
        return polynomial_at(of, position);
    case TABLE:
        return table_at(of, position);
    case LEGENDRE:
        return legendre_at(of, position);
    case NO_CURVE:
        break;
    }
    return 0.0;
}

#endif
