/* The yardstick: the first-order deviation of the dmu60p machine as a careful engineer writes it by hand.
 *
 * Written from the machine's description, not from the derivation: the tool stands on Z on X on the bed, the workpiece
 * on Y on the bed. 18 polynomials of degree 7 (no constant term) in Horner's form, three squareness values. What does
 * not change from point to point is hoisted; rows are restrict pointers, so that the loop is vectorised.
 *
 * curves: [component][power - 1], components EX EY EZ EA EB EC of X, then of Y, then of Z.
 * parameters: q_wx q_wy q_wz q_Tx q_Ty q_Tz eps_xy eps_yz eps_xz. point: of the tool, in its frame.
 */
#include <stddef.h>

static inline double polynomial(const double *restrict c, double s)
{
    return s * (c[0] + s * (c[1] + s * (c[2] + s * (c[3] + s * (c[4] + s * (c[5] + s * c[6]))))));
}

static void rows(
    size_t n,
    const double *restrict X, const double *restrict Y, const double *restrict Z,
    const double *restrict curves, const double *restrict parameters, const double *restrict point,
    double *restrict DX, double *restrict DY, double *restrict DZ)
{
    /* Tool point seen from the Z slide. */
    const double tx = parameters[3] + point[0];
    const double ty = parameters[4] + point[1];
    const double tz = parameters[5] + point[2];
    const double eps_xy = parameters[6], eps_yz = parameters[7], eps_xz = parameters[8];
    const double dx = -eps_xy * ty, dz = eps_yz * ty - eps_xz * tx;
    double c[18][7];
    for (size_t k = 0; k < 18; ++k)
        for (size_t p = 0; p < 7; ++p)
            c[k][p] = curves[7 * k + p];

    for (size_t i = 0; i < n; ++i) {
        const double x = X[i], y = Y[i], z = Z[i];
        /* Angles of X and those of Z's squareness act on the point seen from the X slide; those of Y on the point
         * seen from the Y slide, the other way round. */
        const double above = tz + z;
        const double across = ty - y;
        const double along = tx + x;
        const double exx = polynomial(c[0], x), eyx = polynomial(c[1], x), ezx = polynomial(c[2], x);
        const double eax = polynomial(c[3], x), ebx = polynomial(c[4], x), ecx = polynomial(c[5], x);
        const double exy = polynomial(c[6], y), eyy = polynomial(c[7], y), ezy = polynomial(c[8], y);
        const double eay = polynomial(c[9], y), eby = polynomial(c[10], y), ecy = polynomial(c[11], y);
        const double exz = polynomial(c[12], z), eyz = polynomial(c[13], z), ezz = polynomial(c[14], z);
        const double eaz = polynomial(c[15], z), ebz = polynomial(c[16], z), ecz = polynomial(c[17], z);
        DX[i] = dx + exx + exz - exy + (ebx - eby + eps_xz) * above - (ecx + ecz) * ty + ecy * across + ebz * tz;
        DY[i] = eyx + eyz - eyy - (eax - eay + eps_yz) * above + (ecx + ecz) * tx + (eps_xy - ecy) * along - eaz * tz;
        DZ[i] = dz + ezx + ezz - ezy + (eax + eaz) * ty - (ebx + ebz) * tx - eay * across + eby * along;
    }
}

void hand_written(
    size_t n, size_t stride,
    const double *restrict positions, const double *restrict curves, const double *restrict parameters,
    const double *restrict point, double *restrict deviation)
{
    rows(n, positions, positions + stride, positions + 2 * stride, curves, parameters, point,
         deviation, deviation + stride, deviation + 2 * stride);
}
