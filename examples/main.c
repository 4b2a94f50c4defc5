/* The deviation of the tool of the paper's machine at two points, and its sensitivity to the yaw of X at the first.
 *
 *     cc -std=c17 -I generated/dmu60p examples/main.c generated/dmu60p/kernels.c -lm -o example && ./example
 *
 * examples/point.py does the same with NumPy. Rows of each array: generated/dmu60p/kernels.h.
 */
#include <stdio.h>

#include "kernels.h"

enum { POINTS = 2, AXES = 3, ERRORS = 18, PARAMETERS = 9, YAW_OF_X = 5 };

int main(void)
{
    const double positions[AXES * POINTS] = {270.0, 540.0, 350.0, 700.0, 300.0, 600.0};
    const double parameters[PARAMETERS] = {0.0, 0.0, 0.0, 25.0, 0.0, -200.0, -5e-6, 10e-6, 26e-6};
    const double point[3 * POINTS] = {0.0};
    double errors[ERRORS * POINTS];
    double deviation[3 * POINTS];
    double sensitivity[3 * (ERRORS + 3) * POINTS];

    for (int k = 0; k < ERRORS; ++k) {
        for (int i = 0; i < POINTS; ++i) {
            errors[k * POINTS + i] = k % 6 < 3 ? 2e-3 : 5e-6;
        }
    }
    dmu60p_tool_in_workpiece_deviation(POINTS, POINTS, positions, errors, parameters, point, deviation);
    dmu60p_tool_in_workpiece_sensitivity(POINTS, POINTS, positions, parameters, point, sensitivity);
    for (int i = 0; i < POINTS; ++i) {
        printf("%.12g %.12g %.12g\n", deviation[i], deviation[POINTS + i], deviation[2 * POINTS + i]);
    }
    printf("%.12g\n", sensitivity[(ERRORS + 3 + YAW_OF_X) * POINTS]);
    return 0;
}
